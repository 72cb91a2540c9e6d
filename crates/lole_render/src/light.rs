//! The lights of the studio, its backdrop and its floor.

use glam::Vec3;

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
    /// A warm key from the upper right of the picture, a cool fill from the left, a rim from
    /// behind, in a bright room with a sand-colored floor.
    fn default() -> Self {
        Self {
            key: KeyLight {
                toward: Vec3::new(0.55, 0.95, 0.75),
                color: [2.05, 1.90, 1.68],
                angular_radius: 0.11,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(-1.0, 0.35, 0.55),
                    color: [0.30, 0.36, 0.44],
                    focus: 2.0,
                },
                SoftBox {
                    toward: Vec3::new(-0.35, 0.55, -1.0),
                    color: [0.65, 0.62, 0.58],
                    focus: 4.0,
                },
            ],
            zenith: [0.42, 0.43, 0.45],
            horizon: [0.25, 0.25, 0.25],
            nadir: [0.20, 0.17, 0.14],
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
            top: [0.60, 0.585, 0.56],
            bottom: [0.70, 0.665, 0.615],
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
