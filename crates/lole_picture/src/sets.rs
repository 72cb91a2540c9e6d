//! What stands around the dancer in pictures: floor, background and lamps of each set.

mod beach;
mod canvas;
mod floors;
mod lawn;
mod noise;
mod plants;
mod theater;

use glam::Vec3;
use lole_costume::document::{StageDesign, StageMood, StageSet};
use lole_geom::trig;
use lole_render::{Background, Camera, Gradient, Ground, KeyLight, Landscape, LightRig, SoftBox};

/// Where lamps stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lamps {
    /// Around each camera as around the one in front, as a photographer carries them around: stills. The set goes
    /// with them.
    WithCamera,
    /// As for a camera in front, wherever the camera goes: films.
    Still,
}

/// What is around her.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Scenery {
    /// Floor, background and light.
    pub set: StageSet,
    /// What the lamps of a theater say.
    pub mood: StageMood,
}

impl Scenery {
    /// That of a design.
    #[must_use]
    pub const fn of(stage: &StageDesign) -> Self {
        Self {
            set: stage.set,
            mood: stage.mood,
        }
    }
}

/// One set, as a camera in front sees it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StageLook {
    lights: LightRig,
    background: Background,
    ground: Ground,
}

impl StageLook {
    pub(crate) fn of(scenery: Scenery) -> Self {
        match scenery.set {
            StageSet::Studio => Self {
                lights: LightRig::default(),
                background: Background::default(),
                ground: Ground::default(),
            },
            StageSet::Plain => plain(),
            StageSet::Theater => {
                let mood = scenery.mood;
                Self::painted(theater::lights(mood), theater::landscape(mood))
            }
            StageSet::Beach => Self::painted(beach::lights(), beach::landscape()),
            StageSet::Lawn => Self::painted(lawn::lights(), lawn::landscape()),
        }
    }

    fn painted(lights: LightRig, landscape: Option<&Landscape>) -> Self {
        Self {
            lights,
            background: landscape.map_or_else(Background::default, |painted| {
                Background::Landscape(painted.clone())
            }),
            ground: Ground::default(),
        }
    }

    /// Lights, background and floor for a camera.
    pub(crate) fn around(self, camera: &Camera, lamps: Lamps) -> (LightRig, Background, Ground) {
        let arm = camera.eye - camera.target;
        let azimuth = match lamps {
            Lamps::WithCamera => trig::atan2(arm.x, arm.z),
            Lamps::Still => 0.0,
        };
        let background = match self.background {
            Background::Landscape(landscape) => Background::Landscape(landscape.turned(azimuth)),
            gradient @ Background::Gradient(_) => gradient,
        };
        (self.lights.turned(azimuth), background, self.ground)
    }
}

/// Even light on white: what a catalogue prints.
fn plain() -> StageLook {
    StageLook {
        lights: LightRig {
            key: KeyLight {
                toward: Vec3::new(0.5, 1.1, 0.8),
                color: [1.12, 1.10, 1.06],
                angular_radius: 0.16,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(-1.0, 0.3, 0.6),
                    color: [0.30, 0.31, 0.33],
                    focus: 2.0,
                },
                SoftBox {
                    toward: Vec3::new(0.2, 0.5, -1.0),
                    color: [0.40, 0.40, 0.40],
                    focus: 3.0,
                },
            ],
            zenith: [0.42, 0.42, 0.43],
            horizon: [0.30, 0.30, 0.31],
            nadir: [0.36, 0.35, 0.34],
            exposure: 1.0,
        },
        background: Background::Gradient(Gradient {
            top: [0.92, 0.92, 0.92],
            bottom: [0.95, 0.945, 0.94],
            glow: 0.04,
        }),
        ground: Ground {
            shadow: 0.6,
            ..Ground::default()
        },
    }
}
