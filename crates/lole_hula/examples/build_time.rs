//! How long the default dancer takes to build and to pose, the least of a few, and a hash of her
//! bits.

#![expect(
    clippy::expect_used,
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a printed measurement"
)]

use std::time::Instant;

use lole_body::{Dancer, Measurements};
use lole_hula::{Dance, MotionSettings};

fn main() {
    let measurements = Measurements::woman();
    let mut least = f64::INFINITY;
    let mut bits = 0;
    for _ in 0..7 {
        let start = Instant::now();
        let dancer = Dancer::new(&measurements).expect("the default woman can be built");
        least = least.min(start.elapsed().as_secs_f64());
        bits = hash(&dancer);
    }
    println!("{:.1} ms, bits {bits:016x}", least * 1000.0);
    let dancer = Dancer::new(&measurements).expect("the default woman can be built");
    println!("{:.3} ms a posed frame", least_frame(&dancer) * 1000.0);
}

/// Least time [s] of a frame: pose of the dance, bones, skin.
fn least_frame(dancer: &Dancer) -> f64 {
    let dance =
        Dance::new(&dancer.skeleton, &MotionSettings::default()).expect("the default dance");
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    let mut least = f64::INFINITY;
    for frame in 0..250_u8 {
        let start = Instant::now();
        let pose = dance.pose_at(f32::from(frame) / 60.0);
        let world_from_bind = dancer.skeleton.world_from_bind(&pose);
        (dancer.skin).pose(&world_from_bind, &mut positions, &mut normals);
        least = least.min(start.elapsed().as_secs_f64());
    }
    least
}

/// FNV-1a over the bits of the skin, its bones' shares and the capsules' radii.
fn hash(dancer: &Dancer) -> u64 {
    let skin = &dancer.skin;
    let vectors = skin.positions.iter().chain(&skin.normals);
    let numbers = (vectors.flat_map(|vector| vector.to_array()))
        .chain(skin.weights.iter().copied().flatten())
        .chain(dancer.capsules.iter().flat_map(|capsule| capsule.radii));
    numbers.fold(0xcbf2_9ce4_8422_2325, |hash, number| {
        (hash ^ u64::from(number.to_bits())).wrapping_mul(0x0100_0000_01b3)
    })
}
