//! Sway and folds of a hem: what a dance makes of a skirt, in numbers.

use glam::{DVec2, DVec3, Vec3};
use lole_cloth::drape_test::fold_count;
use lole_geom::trig64;
use std::f64::consts::TAU;

/// Waves around the hem that belong to body and pose, not to folds: hips are wider than they are deep, and a
/// thigh comes forward.
const BODY_WAVES: u32 = 3;

/// Folds of a hem in one frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Folds {
    /// How many.
    pub count: u32,
    /// From valley to ridge [m]: `2 √2` times the root mean square of the hem's distance from its own
    /// smooth outline, which is the height of an even wave.
    pub depth: f64,
    /// Mean distance of the hem from its center [m].
    pub radius: f64,
}

/// Folds of a hem once around: its distance from its center, less what has at most three waves around her,
/// rises above zero and falls below so often, a tenth of its range apart.
#[must_use]
pub fn folds(hem: &[Vec3]) -> Folds {
    let center = mean(hem);
    let radii: Vec<f64> = (hem.iter())
        .map(|place| {
            let away = place.as_dvec3() - center;
            DVec2::new(away.x, away.z).length()
        })
        .collect();
    if radii.is_empty() {
        return Folds::default();
    }
    let count = radii.len() as f64;
    let radius = radii.iter().sum::<f64>() / count;
    let mut residual: Vec<f64> = radii.iter().map(|it| it - radius).collect();
    for wave in 1..=BODY_WAVES {
        let turn = |place: usize| TAU * f64::from(wave) * place as f64 / count;
        let part = |wave: fn(f64) -> f64| {
            let terms = radii.iter().enumerate();
            2.0 / count * terms.map(|(place, it)| it * wave(turn(place))).sum::<f64>()
        };
        let (even, odd) = (part(trig64::cos), part(trig64::sin));
        for (place, it) in residual.iter_mut().enumerate() {
            *it -= even * trig64::cos(turn(place)) + odd * trig64::sin(turn(place));
        }
    }
    let square = residual.iter().map(|it| it * it).sum::<f64>() / count;
    Folds {
        count: fold_count(residual.into_iter()),
        depth: (8.0 * square).sqrt(),
        radius,
    }
}

/// How a hem swings against the belt that it hangs from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SwayWatch {
    /// From the belt's center to the hem's, on the floor [m], a frame each.
    offsets: Vec<DVec2>,
}

/// A swing in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sway {
    /// Amplitude of the even swing that has the same mean square, all directions together [m].
    pub amplitude: f64,
    /// Farthest from the middle of the swing [m].
    pub farthest: f64,
}

impl SwayWatch {
    /// Looks at a frame: the particles of the belt and of the hem [m].
    pub fn look(&mut self, belt: &[Vec3], hem: &[Vec3]) {
        let away = mean(hem) - mean(belt);
        self.offsets.push(DVec2::new(away.x, away.z));
    }

    /// The swing that was seen; zero before any frame.
    #[must_use]
    pub fn seen(&self) -> Sway {
        let count = self.offsets.len().max(1) as f64;
        let middle = self.offsets.iter().sum::<DVec2>() / count;
        let squares = (self.offsets.iter()).map(|it| (*it - middle).length_squared());
        Sway {
            amplitude: (2.0 * squares.clone().sum::<f64>() / count).sqrt(),
            farthest: squares.fold(0.0, f64::max).sqrt(),
        }
    }

    /// From the belt's center to the hem's in the last frame that was seen [m]: across and forward.
    #[must_use]
    pub fn last(&self) -> Option<[f64; 2]> {
        self.offsets.last().map(|it| it.to_array())
    }
}

fn mean(places: &[Vec3]) -> DVec3 {
    let sum = places.iter().map(|it| it.as_dvec3()).sum::<DVec3>();
    sum / places.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    use super::*;

    /// A hem of so many waves on an oval, turned and moved.
    fn hem(waves: u32, depth: f64, oval: f64, phase: f64) -> Vec<Vec3> {
        let places = 512;
        let at = |place: u32| {
            let angle = TAU * f64::from(place) / f64::from(places);
            let radius = 0.5
                + oval * trig64::cos(2.0 * angle + 0.3)
                + 0.5 * depth * trig64::cos(f64::from(waves) * angle + phase);
            let (x, z) = (radius * trig64::cos(angle), radius * trig64::sin(angle));
            DVec3::new(x + 0.2, 0.3, z - 0.4).as_vec3()
        };
        (0..places).map(at).collect()
    }

    proptest! {
        #[test]
        fn waves_on_an_oval_are_counted_and_measured(
            waves in 5_u32..60, depth in 0.01_f64..0.08, oval in 0.0_f64..0.06, phase in 0.0..TAU
        ) {
            let found = folds(&hem(waves, depth, oval, phase));
            prop_assert_eq!(found.count, waves);
            prop_assert!((found.depth / depth - 1.0).abs() < 0.05, "{} of {}", found.depth, depth);
        }

        #[test]
        fn a_swing_has_its_amplitude_wherever_she_goes(
            amplitude in 0.001_f64..0.3, drift in -2.0_f64..2.0, phase in 0.0..TAU
        ) {
            let mut watch = SwayWatch::default();
            for frame in 0..240 {
                let time = f64::from(frame) / 60.0;
                let belt = DVec3::new(drift * time, 1.0, 0.0);
                let swing = amplitude * trig64::sin(TAU * time + phase);
                let hem = belt + DVec3::new(swing, -0.6, 0.02);
                watch.look(&[belt.as_vec3()], &[hem.as_vec3()]);
            }
            let seen = watch.seen();
            prop_assert!((seen.amplitude / amplitude - 1.0).abs() < 1e-2);
            prop_assert!((seen.farthest / amplitude - 1.0).abs() < 1e-2);
        }
    }

    #[test]
    fn nothing_has_neither_folds_nor_sway() {
        assert_eq!(folds(&[]), Folds::default());
        assert_eq!(SwayWatch::default().seen(), Sway::default());
    }
}
