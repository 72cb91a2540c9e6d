//! What no dancer has: a measure outside its band, or two measures that exclude each other.
//!
//! The bands are wide: they find a slip of the pen, a wrong unit or two dancers on one sheet, and
//! let pregnancy, age and great weight pass.

use super::{Measure, Measurements};
use crate::BodyError;

/// What each measure can be alone [cm].
pub(super) const fn band_cm(measure: Measure) -> [f64; 2] {
    match measure {
        Measure::Stature => [100.0, 195.0],
        Measure::Bust => [48.0, 150.0],
        Measure::Underbust => [45.0, 130.0],
        Measure::Waist => [45.0, 130.0],
        Measure::HighHip => [48.0, 150.0],
        Measure::Hip => [55.0, 150.0],
        Measure::Thigh => [28.0, 90.0],
        Measure::Knee => [20.0, 60.0],
        Measure::Calf => [20.0, 60.0],
        Measure::Ankle => [13.0, 36.0],
        Measure::Inseam => [38.0, 97.5],
        Measure::WaistHeight => [55.0, 130.0],
        Measure::ShoulderBreadth => [22.0, 52.0],
        Measure::UpperArmLength => [16.0, 42.0],
    }
}

/// The first measure over the second lies between two ratios.
pub(super) const PAIRS: [(Measure, Measure, [f64; 2]); 21] = [
    (Measure::Inseam, Measure::Stature, [0.40, 0.50]),
    (Measure::WaistHeight, Measure::Stature, [0.56, 0.66]),
    (Measure::WaistHeight, Measure::Inseam, [1.22, 1.55]),
    (Measure::Bust, Measure::Stature, [0.38, 0.95]),
    (Measure::Waist, Measure::Stature, [0.30, 0.86]),
    (Measure::Hip, Measure::Stature, [0.42, 0.95]),
    (Measure::ShoulderBreadth, Measure::Stature, [0.19, 0.28]),
    (Measure::UpperArmLength, Measure::Stature, [0.155, 0.205]),
    (Measure::Underbust, Measure::Bust, [0.72, 1.06]),
    (Measure::Waist, Measure::Bust, [0.55, 1.40]),
    (Measure::Waist, Measure::Underbust, [0.66, 1.60]),
    (Measure::Bust, Measure::Hip, [0.62, 1.50]),
    (Measure::Waist, Measure::Hip, [0.50, 1.35]),
    (Measure::HighHip, Measure::Hip, [0.74, 1.20]),
    (Measure::HighHip, Measure::Waist, [0.80, 1.50]),
    (Measure::Thigh, Measure::Hip, [0.42, 0.70]),
    (Measure::Knee, Measure::Thigh, [0.50, 0.92]),
    (Measure::Calf, Measure::Knee, [0.78, 1.30]),
    (Measure::Calf, Measure::Thigh, [0.48, 0.92]),
    (Measure::Ankle, Measure::Calf, [0.42, 0.82]),
    (Measure::Ankle, Measure::Knee, [0.42, 0.86]),
];

/// Where `measure` may lie [cm] beside what `known` gives, at most its own band.
///
/// Of bounds that exclude each other the later one is kept: [`check`] then names the two.
pub(super) fn room_cm(measure: Measure, known: impl Fn(Measure) -> Option<f64>) -> [f64; 2] {
    let [mut least, mut most] = band_cm(measure);
    for (first, second, [low, high]) in PAIRS {
        let bounds = if first == measure {
            known(second).map(|value| [low * value, high * value])
        } else if second == measure {
            known(first).map(|value| [value / high, value / low])
        } else {
            None
        };
        if let Some([low, high]) = bounds {
            least = least.max(low).min(high);
            most = most.min(high).max(low);
        }
    }
    [least, most.max(least)]
}

/// An estimate lies on a bound to the last bit only.
const SLACK: f64 = 1.0e-9;

/// The first measure outside its band.
pub(super) fn check_bands(value: impl Fn(Measure) -> Option<f64>) -> Result<(), BodyError> {
    for measure in Measure::ALL {
        let [least_cm, most_cm] = band_cm(measure);
        if let Some(value_cm) = value(measure)
            && !(least_cm - SLACK..=most_cm + SLACK).contains(&value_cm)
        {
            return Err(BodyError::OutOfBand {
                name: measure.words(),
                value_cm,
                least_cm,
                most_cm,
            });
        }
    }
    Ok(())
}

/// The first measure outside its band, then the first two that exclude each other.
pub(super) fn check(measurements: &Measurements) -> Result<(), BodyError> {
    let value = |measure: Measure| measurements.get(measure).map(lole_geom::Length::to_cm);
    check_bands(value)?;
    for (first, second, [low, high]) in PAIRS {
        let (Some(first_cm), Some(second_cm)) = (value(first), value(second)) else {
            continue;
        };
        let (least_cm, most_cm) = (low * second_cm, high * second_cm);
        if !(least_cm - SLACK..=most_cm + SLACK).contains(&first_cm) {
            return Err(BodyError::Conflict {
                first: first.words(),
                first_cm,
                second: second.words(),
                second_cm,
                least_cm,
                most_cm,
            });
        }
    }
    Ok(())
}
