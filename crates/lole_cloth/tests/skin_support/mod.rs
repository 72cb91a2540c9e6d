//! Bodies of surfels.

use glam::Vec3;
use lole_geom::{Surfel, trig};

/// Surfels about 12 mm apart on a sphere.
pub(crate) fn sphere(center: Vec3, radius: f32) -> Vec<Surfel> {
    let area = 4.0 * std::f32::consts::PI * radius * radius;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few thousand"
    )]
    let count = (area / (0.012 * 0.012)) as u16;
    // Fibonacci's spiral spreads points evenly.
    let golden = std::f32::consts::PI * (3.0 - 5.0_f32.sqrt());
    (0..count)
        .map(|index| {
            let height = 1.0 - 2.0 * (f32::from(index) + 0.5) / f32::from(count);
            let (sin, cos) = trig::sin_cos((golden * f32::from(index)) % std::f32::consts::TAU);
            let around = (1.0 - height * height).sqrt();
            let normal = Vec3::new(around * cos, height, around * sin);
            Surfel {
                position: center + normal * radius,
                normal,
            }
        })
        .collect()
}
