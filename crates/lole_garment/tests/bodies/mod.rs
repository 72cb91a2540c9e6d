//! Bodies to draft for: measures of built dancers, rounded to millimeters.

use lole_geom::Length;
use lole_pattern::measures::TrunkGirth;
use lole_pattern::{Measure, Measures};

/// A name and all measures in the order of [`Measure::ALL`] [cm].
pub(crate) type Row = (&'static str, [f64; 27]);

/// Six dancers.
#[rustfmt::skip]
pub(crate) const BODIES: [Row; 6] = [
    ("child", [112.7, 58.0, 56.9, 52.0, 62.0, 29.3, 50.8, 17.9, 12.4, 15.8, 46.3, 24.9, 18.6, 35.1, 25.0, 27.5, 3.0, 22.9, 21.7, 9.9, 93.7, 81.1, 84.3, 69.9, 60.9, 52.2, 27.9]),
    ("small", [150.0, 78.0, 65.5, 61.0, 86.0, 33.9, 53.8, 24.0, 14.5, 19.4, 59.4, 34.8, 23.4, 43.6, 34.6, 39.4, 4.6, 30.6, 29.4, 17.3, 126.5, 106.7, 113.9, 92.6, 79.8, 70.5, 42.0]),
    ("mean", [158.0, 83.5, 70.4, 66.0, 91.0, 35.4, 54.5, 25.4, 15.0, 20.5, 64.1, 36.5, 25.0, 46.3, 36.7, 41.9, 5.0, 32.9, 31.7, 18.9, 133.6, 112.5, 120.3, 97.5, 83.6, 74.3, 43.4]),
    ("tall", [172.0, 88.0, 74.4, 70.0, 96.0, 38.5, 55.6, 27.6, 15.8, 22.1, 69.4, 39.6, 27.3, 50.5, 40.0, 45.4, 5.3, 34.3, 33.1, 20.4, 145.5, 122.6, 131.0, 106.1, 90.9, 80.8, 47.1]),
    ("large", [160.0, 112.0, 102.0, 98.0, 118.0, 38.3, 54.7, 29.6, 15.1, 22.6, 69.1, 39.1, 28.7, 52.2, 36.8, 42.9, 5.2, 37.1, 35.9, 22.9, 134.0, 113.3, 119.9, 98.7, 84.4, 74.1, 43.6]),
    ("man", [171.0, 92.0, 86.9, 80.0, 94.0, 44.5, 55.6, 30.6, 15.8, 21.7, 61.5, 40.1, 28.8, 54.6, 43.3, 45.6, 3.8, 35.2, 34.0, 18.3, 144.5, 122.9, 130.8, 103.0, 92.7, 81.2, 45.4]),
];

/// Measures of a row, with tapes of the trunk in proportion to its girths.
#[must_use]
pub(crate) fn of_row(row: &[f64; 27]) -> Measures {
    let zero = Length::ZERO;
    let mut measures = Measures {
        stature: zero,
        bust_girth: zero,
        underbust_girth: zero,
        waist_girth: zero,
        hip_girth: zero,
        neck_girth: zero,
        head_girth: zero,
        upper_arm_girth: zero,
        wrist_girth: zero,
        ankle_girth: zero,
        crotch_length: zero,
        shoulder_breadth: zero,
        upper_arm_length: zero,
        arm_length: zero,
        back_length: zero,
        front_length: zero,
        shoulder_drop: zero,
        back_breadth: zero,
        chest_breadth: zero,
        bust_point_breadth: zero,
        neck_height: zero,
        bust_height: zero,
        armpit_height: zero,
        waist_height: zero,
        hip_bone_height: zero,
        hip_height: zero,
        knee_height: zero,
        trunk: Vec::new(),
    };
    for (measure, cm) in Measure::ALL.iter().zip(row) {
        *measure.of_mut(&mut measures) = Length::from_cm(*cm);
    }
    let tape = |height, girth| TrunkGirth { height, girth };
    measures.trunk = vec![
        tape(measures.hip_height, measures.hip_girth),
        tape(
            measures.hip_bone_height,
            (measures.hip_girth + measures.waist_girth) * 0.53,
        ),
        tape(measures.waist_height, measures.waist_girth),
        tape(
            measures.bust_height - Length::from_cm(7.0),
            measures.underbust_girth,
        ),
        tape(measures.bust_height, measures.bust_girth),
        tape(measures.armpit_height, measures.bust_girth * 1.02),
    ];
    measures
}
