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

#[cfg(test)]
mod tests {
    use super::*;

    /// All that is painted.
    fn landscapes() -> Vec<(&'static str, Landscape)> {
        let moods = StageMood::ALL
            .iter()
            .map(|mood| (mood.id(), theater::landscape(*mood)));
        let outdoors = [("beach", beach::landscape()), ("lawn", lawn::landscape())];
        moods
            .chain(outdoors)
            .map(|(name, landscape)| (name, landscape.unwrap().clone()))
            .collect()
    }

    /// A panorama is whole above the horizon and open at its lower edge, and its two ends meet.
    #[test]
    fn every_panorama_is_whole_and_closes() {
        for (name, landscape) in landscapes() {
            let far = &landscape.far;
            let (width, height) = (far.picture.width() as usize, far.picture.height() as usize);
            let pixel = |x: usize, y: usize| &far.picture.pixels()[(y * width + x) * 4..][..4];
            let horizon = far.top / (far.top - far.bottom) * height as f32;
            let above = (0..height).take_while(|&y| (y as f32) < horizon - 2.0);
            for y in above.clone() {
                assert!((0..width).all(|x| pixel(x, y)[3] == 255), "{name}: row {y}");
                let (left, right) = (pixel(0, y), pixel(width - 1, y));
                let apart = left.iter().zip(right).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(apart < Some(28), "{name}: row {y}: {left:?} and {right:?}");
            }
            assert!(above.count() > height / 2);
            assert!((0..width).all(|x| pixel(x, height - 1)[3] < 128), "{name}");
        }
    }

    /// What is behind her is neither black nor white where a camera in front looks, and no two sets are alike.
    #[test]
    fn sets_differ_and_are_seen() {
        let mut seen: Vec<(&str, [f32; 3])> = Vec::new();
        for (name, landscape) in landscapes() {
            let far = &landscape.far.picture;
            let (width, height) = (far.width() as usize, far.height() as usize);
            let ahead = (width * 7 / 16..width * 9 / 16)
                .flat_map(|x| (height * 5 / 8..height * 13 / 16).map(move |y| (y * width + x) * 4));
            let mut sum = [0.0; 3];
            let mut count = 0.0;
            for start in ahead {
                count += 1.0;
                for (sum, part) in sum.iter_mut().zip(&far.pixels()[start..start + 3]) {
                    *sum += f32::from(*part);
                }
            }
            let mean = sum.map(|sum| sum / count);
            let light = mean.iter().sum::<f32>() / 3.0;
            assert!((12.0..235.0).contains(&light), "{name}: {mean:?}");
            for (other, color) in &seen {
                let apart = (color.iter().zip(mean))
                    .map(|(a, b)| (a - b).abs())
                    .sum::<f32>();
                assert!(apart > 20.0, "{name} is as {other}: {mean:?}");
            }
            seen.push((name, mean));
        }
    }
}
