//! What is behind the subject, and the floor below it.

use crate::Texture;
use std::sync::Arc;

/// What is behind everything, shown as given (not tone mapped).
#[derive(Debug, Clone, PartialEq)]
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

/// A painted panorama far away, and two floors that lie on either side of a straight shore. Colors are linear.
#[derive(Debug, Clone, PartialEq)]
pub struct Landscape {
    /// All that is far away.
    pub far: Panorama,
    /// The floor where the subject stands.
    pub near: Floor,
    /// The floor, or water, beyond the shore.
    pub beyond: Floor,
    /// Where it begins.
    pub shore: Shore,
    /// Within this distance from the origin [m] the near floor is lit; it darkens beyond.
    pub pool: f32,
    /// Color that floors fade to far away.
    pub haze: [f32; 3],
    /// Distance at which they have faded by a quarter [m].
    pub haze_distance: f32,
    /// How much lighter the middle of the picture is than the corners, 0 to 1.
    pub glow: f32,
    /// All of it is turned about the vertical by this angle [rad], from `+Z` towards `+X`.
    pub turn: f32,
}

/// A picture of all directions: its columns go once around, from left to right as an eye turns, with `-Z` in the
/// middle; its rows are even steps of the sine of the elevation. What lies below the horizon stands before the floor
/// by its alpha; above it, alpha does not count.
#[derive(Debug, Clone, PartialEq)]
pub struct Panorama {
    /// The picture.
    pub picture: Arc<Texture>,
    /// What floors mirror of it, of the same directions: without what stands on them, and as coarse as one likes.
    pub mirrored: Arc<Texture>,
    /// Sine of the elevation at its upper edge; what is above shows its uppermost row.
    pub top: f32,
    /// Sine of the elevation at its lower edge, negative or 0.
    pub bottom: f32,
}

/// A floor.
#[derive(Debug, Clone, PartialEq)]
pub struct Floor {
    /// What it looks like in full light from above; it repeats.
    pub paint: Arc<Texture>,
    /// Side of one repeat [m].
    pub repeat: f32,
    /// How much of what is far away it mirrors at a grazing look, 0 to 1.
    pub mirror: f32,
    /// How far waves tilt what it mirrors: sine of the elevation for a full step of the paint's green.
    pub waves: f32,
}

/// A straight edge between two floors, as the waves of a sea leave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shore {
    /// x and z of the direction from the origin towards it, of unit length.
    pub toward: [f32; 2],
    /// How far away it is [m].
    pub distance: f32,
    /// Width of the foam on it [m]; 0 for a plain edge.
    pub foam: f32,
    /// Its color.
    pub foam_color: [f32; 3],
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

impl Shore {
    /// No shore in sight.
    pub const NONE: Self = Self {
        toward: [0.0, -1.0],
        distance: 1.0e6,
        foam: 0.0,
        foam_color: [0.0; 3],
    };
}

impl Landscape {
    /// The same turned about the vertical by `azimuth` [rad], as [`LightRig::turned`](crate::LightRig) turns lights.
    #[must_use]
    pub fn turned(self, azimuth: f32) -> Self {
        Self {
            turn: self.turn + azimuth,
            ..self
        }
    }

    /// The pictures that it is painted with: what is far away, what floors mirror of it, the near floor, the floor
    /// beyond.
    pub(crate) const fn paints(&self) -> [&Arc<Texture>; 4] {
        let [far, mirrored] = [&self.far.picture, &self.far.mirrored];
        [far, mirrored, &self.near.paint, &self.beyond.paint]
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
