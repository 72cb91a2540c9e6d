//! The lights of the studio, its backdrop and its floor.

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

impl Default for LightRig {
    /// The rig of [`LightRig::seen_from`] for a camera in front.
    fn default() -> Self {
        Self::turned(0.0)
    }
}

impl LightRig {
    /// The studio's lights as they stand around `camera`: a warm key from the upper right of the
    /// picture, a cool fill from its left, a rim from behind, in a bright room with a sand-colored
    /// floor. Walking around the subject with camera and lights is turning it on the spot.
    #[must_use]
    pub fn seen_from(camera: &Camera) -> Self {
        let arm = camera.eye - camera.target;
        Self::turned(trig::atan2(arm.x, arm.z))
    }

    /// The studio's lights turned about the vertical by `azimuth` [rad].
    fn turned(azimuth: f32) -> Self {
        let (sin, cos) = trig::sin_cos(azimuth);
        let turn = |x: f32, y: f32, z: f32| Vec3::new(x * cos + z * sin, y, z * cos - x * sin);
        Self {
            key: KeyLight {
                toward: turn(0.78, 1.08, 0.62),
                color: [1.42, 1.30, 1.12],
                angular_radius: 0.10,
            },
            boxes: vec![
                SoftBox {
                    toward: turn(-1.0, 0.30, 0.45),
                    color: [0.17, 0.21, 0.27],
                    focus: 2.0,
                },
                SoftBox {
                    toward: turn(-0.45, 0.50, -1.0),
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

/// The backdrop: a soft gradient without a horizon, shown as given (not tone mapped).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Background {
    /// Color at the top of the picture, linear.
    pub top: [f32; 3],
    /// Color at the bottom, linear.
    pub bottom: [f32; 3],
    /// How much lighter the middle is than the corners, 0 to 1.
    pub glow: f32,
}

impl Default for Background {
    /// Pale warm gray above pale sand.
    fn default() -> Self {
        Self {
            top: [0.68, 0.66, 0.63],
            bottom: [0.80, 0.757, 0.69],
            glow: 0.22,
        }
    }
}

/// The floor: it shows the backdrop, darkened where light is kept from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground {
    /// Height of the floor [m].
    pub height: f32,
    /// How dark shadows on it are, 0 (not at all) to 1 (as dark as the lights make them).
    pub shadow: f32,
}

impl Default for Ground {
    /// At height 0.
    fn default() -> Self {
        Self {
            height: 0.0,
            shadow: 0.85,
        }
    }
}
