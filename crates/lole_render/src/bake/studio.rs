//! The surroundings as a few dozen directions, in opposite pairs that share one depth map.

use crate::LightRig;
use crate::depth_map::DepthMap;
use glam::Vec3;
use lole_geom::trig;

/// Pairs of directions. More are smoother and cost a map each.
const PAIR_COUNT: usize = 16;

/// One pair of opposite directions.
pub(super) struct Pair {
    /// Unit vector, pointing up or level.
    pub(super) axis: Vec3,
    /// Radiance from `+axis` and from `-axis`, times the share of the sphere over π.
    pub(super) radiance: [Vec3; 2],
}

/// All directions.
pub(super) struct Studio {
    /// The pairs, evenly over the half sphere.
    pub(super) axes: Vec<Pair>,
}

impl Studio {
    pub(super) fn new(lights: &LightRig) -> Self {
        // Sum over 2·PAIR_COUNT directions of radiance · cos · solid angle / π.
        let weight = 4.0 / (2 * PAIR_COUNT) as f32;
        let axes = (0..PAIR_COUNT)
            .map(|index| {
                let axis = half_sphere_direction(index);
                Pair {
                    axis,
                    radiance: [
                        lights.radiance(axis) * weight,
                        lights.radiance(-axis) * weight,
                    ],
                }
            })
            .collect();
        Self { axes }
    }

    /// Light on an open floor, as the radiance of a white surface there.
    pub(super) fn on_open_floor(&self) -> Vec3 {
        (self.axes.iter())
            .map(|pair| pair.radiance[0] * pair.axis.y)
            .sum()
    }
}

/// The surroundings, and what of the meshes each pair of directions meets.
pub(super) struct Room {
    pub(super) studio: Studio,
    /// One for each pair, in its direction.
    pub(super) maps: Vec<DepthMap>,
}

impl Room {
    /// Each pair with its map.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (&Pair, &DepthMap)> {
        self.studio.axes.iter().zip(&self.maps)
    }
}

/// Even points on the upper half sphere: equal steps in height, golden angle around.
fn half_sphere_direction(index: usize) -> Vec3 {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    let y = (index as f32 + 0.5) / PAIR_COUNT as f32;
    let ring = (1.0 - y * y).max(0.0).sqrt();
    let (sin, cos) = trig::sin_cos(index as f32 * GOLDEN_ANGLE + 0.4);
    Vec3::new(ring * cos, y, ring * sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In a room of one even radiance, every surface in the open is lit by just that radiance.
    #[test]
    fn an_even_room_lights_every_orientation_alike() {
        let even = LightRig {
            boxes: Vec::new(),
            zenith: [1.0; 3],
            horizon: [1.0; 3],
            nadir: [1.0; 3],
            ..LightRig::default()
        };
        let studio = Studio::new(&even);
        for index in 0..PAIR_COUNT {
            let normal = half_sphere_direction(index).cross(Vec3::new(0.3, 0.2, 0.9));
            let normal = normal.normalize_or_zero();
            let light: f32 = studio
                .axes
                .iter()
                .map(|pair| pair.radiance[0].x * normal.dot(pair.axis).abs())
                .sum();
            assert!((light - 1.0).abs() < 0.08, "{normal} gets {light}");
        }
    }
}
