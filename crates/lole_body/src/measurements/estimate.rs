//! What was not measured, from what was: means of women, men and children, moved along.
//!
//! Women: AIST 1997–98, size-JPN 2004–06 and JIS L 4005 (size 9AR). Men: the same surveys. Children:
//! the two measured bodies of the table of sections, of 128 and 151 cm; their girths of knee, calf
//! and ankle, and all of the child of 100 cm, are judged and not measured.

use lole_geom::{Length, trig64};

use super::plausible::room_cm;
use super::{Figure, Measure, Measurements, Tape};

/// A mean dancer [cm]: stature, bust, waist, hip, inseam, thigh, knee, calf, ankle.
type Mean = [f64; 9];

/// Order of [`Mean`] after the stature.
const ORDER: [Measure; 8] = [
    Measure::Bust,
    Measure::Waist,
    Measure::Hip,
    Measure::Inseam,
    Measure::Thigh,
    Measure::Knee,
    Measure::Calf,
    Measure::Ankle,
];
const WOMAN: Mean = [158.0, 83.5, 66.0, 91.0, 71.0, 52.0, 34.5, 34.5, 20.5];
const MAN: Mean = [171.0, 88.0, 74.0, 91.0, 78.4, 52.5, 36.0, 36.5, 21.5];
/// By stature, linear between.
const CHILDREN: [Mean; 3] = [
    [100.0, 54.0, 50.0, 57.0, 42.5, 32.0, 22.5, 22.0, 14.5],
    [128.0, 62.0, 54.5, 67.0, 57.5, 38.5, 26.5, 26.5, 17.0],
    [151.0, 75.0, 60.0, 81.0, 69.0, 46.0, 31.5, 31.5, 19.5],
];
/// How far each leg girth follows the hip rather than the stature (exponent).
const LEG_FOLLOWS_HIP: [f64; 4] = [0.85, 0.6, 0.6, 0.35];
/// How far a trunk girth that was not measured follows those that were (exponent).
const TRUNK_FOLLOWS_TRUNK: f64 = 0.85;

/// The mean dancer of this figure; a child's means go by her stature.
fn mean(figure: Figure, stature_cm: Option<f64>) -> Mean {
    match figure {
        Figure::Man => MAN,
        Figure::Child => {
            let stature = stature_cm.unwrap_or(CHILDREN[1][0]);
            let pair = if stature < CHILDREN[1][0] { 0 } else { 1 };
            let (low, high) = (CHILDREN[pair], CHILDREN[pair + 1]);
            let share = ((stature - low[0]) / (high[0] - low[0])).clamp(0.0, 1.0);
            std::array::from_fn(|index| low[index] + share * (high[index] - low[index]))
        }
        Figure::OfStature | Figure::Woman => WOMAN,
    }
}

/// Missing girths follow the mean ratio of those measured, and the stature for the rest; a missing
/// inseam keeps its share of the stature. What is guessed stays where it is plausible beside what
/// was measured: nobody could mend it.
pub(super) fn fill(tape: &Tape) -> Measurements {
    let figure = tape.figure.resolved(tape.stature);
    let mean = mean(figure, tape.stature.map(Length::to_cm));
    let [stature_0, bust_0, waist_0, hip_0, inseam_0, legs_0 @ ..] = mean;
    let given = |measure: Measure| measure.of(tape).map(Length::to_cm);
    let stature = given(Measure::Stature).unwrap_or_else(|| {
        let [least, most] = room_cm(Measure::Stature, given);
        stature_0.clamp(least, most)
    });
    let mut known: [Option<f64>; 9] = std::array::from_fn(|index| match index {
        0 => Some(stature),
        index => given(ORDER[index - 1]),
    });
    let tall = trig64::ln(stature / stature_0);
    let trunk_0 = [bust_0, waist_0, hip_0];
    let measured = |of: &[usize]| -> Option<f64> {
        let ratios: Vec<f64> = (of.iter())
            .filter_map(|&index| Some(trig64::ln(known[index]? / mean[index])))
            .collect();
        (!ratios.is_empty()).then(|| ratios.iter().sum::<f64>() / ratios.len() as f64)
    };
    // A thigh tells of the hips where no trunk girth was measured.
    let wide = (measured(&[1, 2, 3]).or_else(|| measured(&[5]))).unwrap_or(tall);
    let trunk = trig64::exp(TRUNK_FOLLOWS_TRUNK * wide + (1.0 - TRUNK_FOLLOWS_TRUNK) * tall);
    let plausible = |index: usize, guess: f64, known: &[Option<f64>; 9]| {
        let measure = ORDER[index - 1];
        let [least, most] = room_cm(measure, |other| match other {
            Measure::Stature => known[0],
            other => (ORDER.iter().position(|&one| one == other))
                .map_or_else(|| given(other), |place| known[place + 1]),
        });
        guess.clamp(least, most)
    };
    for (index, girth_0) in (1..).zip(trunk_0) {
        if known[index].is_none() {
            known[index] = Some(plausible(index, girth_0 * trunk, &known));
        }
    }
    if known[4].is_none() {
        known[4] = Some(plausible(4, inseam_0 * stature / stature_0, &known));
    }
    let hip = known[3].unwrap_or(hip_0);
    for (index, (girth_0, follow)) in (5..).zip(legs_0.into_iter().zip(LEG_FOLLOWS_HIP)) {
        if known[index].is_none() {
            let ratio = follow * trig64::ln(hip / hip_0) + (1.0 - follow) * tall;
            known[index] = Some(plausible(index, girth_0 * trig64::exp(ratio), &known));
        }
    }
    let [stature, bust, waist, hip, inseam, thigh, knee, calf, ankle] =
        known.map(|value| Length::from_cm(value.unwrap_or(0.0)));
    Measurements {
        figure,
        stature,
        bust_girth: bust,
        underbust_girth: tape.underbust_girth,
        waist_girth: waist,
        high_hip_girth: tape.high_hip_girth,
        hip_girth: hip,
        thigh_girth: thigh,
        knee_girth: knee,
        calf_girth: calf,
        ankle_girth: ankle,
        inseam_length: inseam,
        waist_height: tape.waist_height,
        shoulder_breadth: tape.shoulder_breadth,
        upper_arm_length: tape.upper_arm_length,
    }
}
