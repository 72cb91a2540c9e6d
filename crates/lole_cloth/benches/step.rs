//! One step of every scene, half a second into it: `cargo bench -p lole_cloth`.
#![allow(
    missing_docs,
    reason = "criterion's macros write undocumented functions"
)]

use criterion::{Criterion, criterion_group, criterion_main};
use lole_cloth::scenes::{FRAME_DT, SCENES};
use lole_cloth::{ClothModel, ClothState, StepInput, step};

/// Frames before the measurement: the cloth has fallen and lies on the body.
const WARM_UP_FRAMES: u32 = 30;

fn bench_scenes(criterion: &mut Criterion) {
    for scene in SCENES {
        let setup = (scene.build)();
        let Ok(model) = ClothModel::new(&setup.spec) else {
            continue;
        };
        let mut state = ClothState::new(&model, &setup.positions);
        let pins: Vec<_> = model
            .pin_indices()
            .iter()
            .map(|&pin| setup.positions[pin as usize])
            .collect();
        let mut frame = 0;
        let mut advance = |state: &mut ClothState| {
            frame += 1;
            let capsules = (scene.capsules)(f64::from(frame) * f64::from(FRAME_DT));
            let input = StepInput {
                pin_targets: &pins,
                capsules: &capsules,
                ..StepInput::default()
            };
            step(&model, &setup.config, &input, state, FRAME_DT).expect("a target for every pin");
        };
        for _ in 0..WARM_UP_FRAMES {
            advance(&mut state);
        }
        criterion.bench_function(scene.name, |bencher| bencher.iter(|| advance(&mut state)));
    }
}

criterion_group!(benches, bench_scenes);
criterion_main!(benches);
