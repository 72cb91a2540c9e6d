//! What is behind the subject, and the floor below it.

use crate::light::turned;
use glam::Vec3;

/// What is behind everything, shown as given (not tone mapped).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Background {
    /// A soft gradient without a horizon, the same wherever the camera looks.
    Gradient(Gradient),
    /// Sky, floor and horizon, fixed in the world.
    Landscape(Landscape),
}

/// Color from the top to the bottom of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gradient {
    /// Color at the top of the picture, linear.
    pub top: [f32; 3],
    /// Color at the bottom, linear.
    pub bottom: [f32; 3],
    /// How much lighter the middle is than the corners, 0 to 1.
    pub glow: f32,
}

/// Surroundings by direction: what an eye at the origin sees far away. Colors are linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landscape {
    /// Color of the sky far above the horizon.
    pub zenith: [f32; 3],
    /// Color of the sky at the horizon.
    pub horizon: [f32; 3],
    /// Sine of the elevation at which the sky has the color of the zenith.
    pub band: f32,
    /// The glow in the sky.
    pub sun: Sun,
    /// The floor where the subject stands.
    pub near: Floor,
    /// The floor, or water, beyond it.
    pub far: Floor,
    /// Where the far floor begins [m], around the origin.
    pub shore: f32,
    /// Within this distance from the origin [m] the near floor is lit; it darkens beyond.
    pub pool: f32,
    /// Color that floors fade to far away.
    pub haze: [f32; 3],
    /// Distance at which they have faded by a quarter [m].
    pub haze_distance: f32,
    /// Mountains behind.
    pub mountains: Outline,
    /// Trees in front of them.
    pub trees: Outline,
    /// How much lighter the middle of the picture is than the corners, 0 to 1.
    pub glow: f32,
}

/// A glow in the sky.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sun {
    /// Direction towards it; any length above zero.
    pub toward: [f32; 3],
    /// What it adds to the sky around it.
    pub color: [f32; 3],
}

/// A floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// Its color in full light.
    pub color: [f32; 3],
    /// How much of the sky it mirrors at a grazing look, 0 to 1.
    pub mirror: f32,
}

/// Something dark against the sky along the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outline {
    /// Its color.
    pub color: [f32; 3],
    /// How high it stands, as the sine of an elevation; 0 for nothing.
    pub height: f32,
}

impl Default for Background {
    /// Pale warm gray above pale sand.
    fn default() -> Self {
        Self::Gradient(Gradient {
            top: [0.68, 0.66, 0.63],
            bottom: [0.80, 0.757, 0.69],
            glow: 0.22,
        })
    }
}

impl Landscape {
    /// The same with its glow turned about the vertical by `azimuth` [rad], as [`LightRig::turned`](crate::LightRig)
    /// turns lights; mountains and trees stay where they are.
    #[must_use]
    pub fn turned(self, azimuth: f32) -> Self {
        let toward = turned(Vec3::from(self.sun.toward), azimuth).to_array();
        Self {
            sun: Sun { toward, ..self.sun },
            ..self
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
