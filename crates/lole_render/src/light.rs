//! The lights around the subject.

use crate::Camera;
use glam::Vec3;
use lole_geom::trig;

/// The one light that throws a shadow with a visible edge: a large lamp, far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KeyLight {
    /// Direction from the subject towards the lamp; any length above zero.
    pub toward: Vec3,
    /// Light that falls on a card facing the lamp, linear.
    pub color: [f32; 3],
    /// Half the angle under which the lamp is seen [rad]. Larger is softer: 0.0047 is the sun,
    /// 0.1 a softbox of 1 m five meters away.
    pub angular_radius: f32,
}

/// A broad, soft source in the surroundings: a fill or a rim light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftBox {
    /// Direction from the subject towards its middle; any length above zero.
    pub toward: Vec3,
    /// Radiance of its middle, linear.
    pub color: [f32; 3],
    /// Falls off as the cosine to this power: 2 is broad, 8 is narrow.
    pub focus: f32,
}

/// All lights.
#[derive(Debug, Clone, PartialEq)]
pub struct LightRig {
    /// The light that throws the shadow.
    pub key: KeyLight,
    /// Soft lights without a shadow edge.
    pub boxes: Vec<SoftBox>,
    /// Radiance of the surroundings straight above, linear.
    pub zenith: [f32; 3],
    /// Radiance of the surroundings at the horizon, linear.
    pub horizon: [f32; 3],
    /// Radiance of what is below: light given back by the floor, linear.
    pub nadir: [f32; 3],
    /// Factor on everything before tone mapping.
    pub exposure: f32,
}

impl LightRig {
    /// The studio's lights as they stand around `camera`: a warm key from the upper right of the
    /// picture, a cool fill from its left, a rim from behind, in a bright room with a sand-colored
    /// floor. Walking around the subject with camera and lights is turning it on the spot.
    #[must_use]
    pub fn seen_from(camera: &Camera) -> Self {
        let arm = camera.eye - camera.target;
        Self::default().turned(trig::atan2(arm.x, arm.z))
    }

    /// These lights turned about the vertical by `azimuth` [rad]: those in front of the dancer come to stand in front
    /// of a camera at that azimuth.
    #[must_use]
    pub fn turned(mut self, azimuth: f32) -> Self {
        self.key.toward = turned(self.key.toward, azimuth);
        for soft in &mut self.boxes {
            soft.toward = turned(soft.toward, azimuth);
        }
        self
    }
}

impl Default for LightRig {
    /// The rig of [`LightRig::seen_from`] for a camera in front.
    fn default() -> Self {
        Self {
            key: KeyLight {
                toward: Vec3::new(0.78, 1.08, 0.62),
                color: [1.42, 1.30, 1.12],
                angular_radius: 0.10,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(-1.0, 0.30, 0.45),
                    color: [0.17, 0.21, 0.27],
                    focus: 2.0,
                },
                SoftBox {
                    toward: Vec3::new(-0.45, 0.50, -1.0),
                    color: [0.62, 0.60, 0.57],
                    focus: 4.0,
                },
            ],
            zenith: [0.36, 0.37, 0.39],
            horizon: [0.22, 0.22, 0.225],
            nadir: [0.27, 0.235, 0.20],
            exposure: 1.0,
        }
    }
}

/// A direction turned about the vertical by `azimuth` [rad], from the front towards the dancer's left.
pub(crate) fn turned(direction: Vec3, azimuth: f32) -> Vec3 {
    let (sin, cos) = trig::sin_cos(azimuth);
    let Vec3 { x, y, z } = direction;
    Vec3::new(x * cos + z * sin, y, z * cos - x * sin)
}
