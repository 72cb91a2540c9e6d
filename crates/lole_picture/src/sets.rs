//! What stands around the dancer in pictures: floor, background and lamps of each set.

use glam::Vec3;
use lole_costume::document::StageSet;
use lole_geom::trig;
use lole_render::backdrop::{Floor, Outline, Sun};
use lole_render::{Background, Camera, Gradient, Ground, KeyLight, Landscape, LightRig, SoftBox};

/// Where lamps stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lamps {
    /// Around each camera as around the one in front, as a photographer carries them around: stills.
    WithCamera,
    /// As for a camera in front, wherever the camera goes: films.
    Still,
}

/// One set, as a camera in front sees it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StageLook {
    lights: LightRig,
    background: Background,
    ground: Ground,
}

impl StageLook {
    pub(crate) fn of(set: StageSet) -> Self {
        match set {
            StageSet::Studio => Self {
                lights: LightRig::default(),
                background: Background::default(),
                ground: Ground::default(),
            },
            StageSet::Plain => plain(),
            StageSet::Theater => theater(),
            StageSet::Beach => beach(),
            StageSet::Lawn => lawn(),
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

/// A lamp from the front, colored ones from behind, and a lit cloth at the back of a dark stage.
fn theater() -> StageLook {
    StageLook {
        lights: LightRig {
            key: KeyLight {
                toward: Vec3::new(0.55, 1.15, 0.95),
                color: [1.62, 1.46, 1.20],
                angular_radius: 0.05,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(-0.9, 0.6, -0.8),
                    color: [1.25, 0.70, 0.85],
                    focus: 5.0,
                },
                SoftBox {
                    toward: Vec3::new(0.9, 0.5, -0.9),
                    color: [0.45, 0.75, 1.35],
                    focus: 5.0,
                },
                SoftBox {
                    toward: Vec3::new(-0.9, 0.35, 0.7),
                    color: [0.12, 0.13, 0.18],
                    focus: 2.0,
                },
            ],
            zenith: [0.05, 0.05, 0.08],
            horizon: [0.06, 0.055, 0.09],
            nadir: [0.10, 0.075, 0.055],
            exposure: 1.0,
        },
        background: Background::Landscape(Landscape {
            zenith: [0.012, 0.012, 0.028],
            horizon: [0.13, 0.065, 0.24],
            band: 0.17,
            sun: Sun {
                toward: [0.0, 0.05, -1.0],
                color: [0.09, 0.04, 0.06],
            },
            near: Floor {
                color: [0.20, 0.125, 0.075],
                mirror: 0.35,
            },
            far: Floor {
                color: [0.02, 0.016, 0.02],
                mirror: 0.35,
            },
            shore: 7.0,
            pool: 2.6,
            haze: [0.12, 0.06, 0.22],
            haze_distance: 30.0,
            mountains: NOTHING,
            trees: NOTHING,
            glow: 0.25,
        }),
        ground: Ground::default(),
    }
}

/// The sun stands low behind her, at the side; the sky in front of her lights face and cloth.
fn beach() -> StageLook {
    let sun = [-0.88, 0.34, -0.62];
    StageLook {
        lights: LightRig {
            key: KeyLight {
                toward: Vec3::from(sun),
                color: [2.0, 1.2, 0.62],
                angular_radius: 0.03,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(0.45, 0.40, 1.0),
                    color: [0.74, 0.62, 0.56],
                    focus: 2.0,
                },
                SoftBox {
                    toward: Vec3::new(-0.7, 0.35, 0.7),
                    color: [0.30, 0.22, 0.20],
                    focus: 2.0,
                },
            ],
            zenith: [0.26, 0.28, 0.40],
            horizon: [0.42, 0.30, 0.28],
            nadir: [0.24, 0.18, 0.14],
            exposure: 1.0,
        },
        background: Background::Landscape(Landscape {
            zenith: [0.16, 0.24, 0.46],
            horizon: [0.92, 0.50, 0.27],
            band: 0.26,
            sun: Sun {
                toward: [sun[0], 0.06, sun[2]],
                color: [0.55, 0.34, 0.12],
            },
            near: Floor {
                color: [0.52, 0.37, 0.25],
                mirror: 0.0,
            },
            far: Floor {
                color: [0.07, 0.11, 0.17],
                mirror: 0.62,
            },
            shore: 11.0,
            pool: 60.0,
            haze: [0.42, 0.30, 0.32],
            haze_distance: 900.0,
            mountains: Outline {
                color: [0.20, 0.15, 0.22],
                height: 0.055,
            },
            trees: NOTHING,
            glow: 0.16,
        }),
        ground: Ground::default(),
    }
}

/// The sun of the late morning, mountains and trees behind.
fn lawn() -> StageLook {
    StageLook {
        lights: LightRig {
            key: KeyLight {
                toward: Vec3::new(0.75, 1.15, 0.60),
                color: [1.58, 1.46, 1.24],
                angular_radius: 0.025,
            },
            boxes: vec![
                SoftBox {
                    toward: Vec3::new(-0.9, 0.5, 0.4),
                    color: [0.20, 0.26, 0.34],
                    focus: 2.0,
                },
                SoftBox {
                    toward: Vec3::new(-0.3, 0.6, -1.0),
                    color: [0.45, 0.50, 0.56],
                    focus: 3.0,
                },
            ],
            zenith: [0.34, 0.42, 0.56],
            horizon: [0.28, 0.31, 0.34],
            nadir: [0.15, 0.19, 0.10],
            exposure: 1.0,
        },
        background: Background::Landscape(Landscape {
            zenith: [0.17, 0.38, 0.72],
            horizon: [0.66, 0.78, 0.88],
            band: 0.26,
            sun: Sun {
                toward: [0.75, 0.9, 0.6],
                color: [0.2, 0.18, 0.12],
            },
            near: Floor {
                color: [0.20, 0.28, 0.095],
                mirror: 0.0,
            },
            far: Floor {
                color: [0.20, 0.28, 0.095],
                mirror: 0.0,
            },
            shore: 18.0,
            pool: 80.0,
            haze: [0.27, 0.34, 0.17],
            haze_distance: 60.0,
            mountains: Outline {
                color: [0.30, 0.42, 0.44],
                height: 0.15,
            },
            trees: Outline {
                color: [0.085, 0.16, 0.055],
                height: 0.05,
            },
            glow: 0.12,
        }),
        ground: Ground::default(),
    }
}

const NOTHING: Outline = Outline {
    color: [0.0; 3],
    height: 0.0,
};
