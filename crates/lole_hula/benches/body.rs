//! What a body costs: `cargo bench -p lole_body --bench body`.
//!
//! Building one from a tape, its capsules among it, and posing and skinning it, which the dance does
//! once a frame on one thread.
#![allow(
    missing_docs,
    clippy::disallowed_methods,
    reason = "criterion's macros write undocumented functions; a bench reads the clock"
)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use lole_body::{Dancer, Figure, Measurements, Tape};
use lole_hula::{Dance, MotionSettings};

fn bodies(criterion: &mut Criterion) {
    for figure in [Figure::Woman, Figure::Man, Figure::Child] {
        let tape = Tape {
            figure,
            ..Tape::default()
        };
        let measurements = Measurements::from_tape(&tape).expect("a usual figure");
        let name = format!("{figure:?}").to_lowercase();
        criterion.bench_function(&format!("build/{name}"), |bencher| {
            bencher.iter(|| Dancer::new(black_box(&measurements)));
        });
        let dancer = Dancer::new(&measurements).expect("a usual figure");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let pool = pool.expect("one thread");
        let dance = Dance::new(&dancer.skeleton, &MotionSettings::default());
        let pose = dance.expect("a usual dance").pose_at(1.3);
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        criterion.bench_function(&format!("pose-and-skin/{name}"), |bencher| {
            pool.install(|| {
                bencher.iter(|| {
                    let bones = dancer.skeleton.world_from_bind(black_box(&pose));
                    dancer.skin.pose(&bones, &mut positions, &mut normals);
                });
            });
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = bodies
}
criterion_main!(benches);
