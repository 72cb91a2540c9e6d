//! Laws of the tape: the surface has every measure that was given, over random plausible dancers;
//! what excludes each other is refused by name.

#![expect(
    clippy::unwrap_used,
    reason = "helpers of tests; a failure is a failed test"
)]

use lole_body::{BodyError, Dancer, Figure, Measure, Measurements, Tape};
use lole_geom::{Chance, Length};
use lole_language::Bilingual;
use rayon::prelude::*;

/// Largest distance of the surface from a given tape [cm].
const TOLERANCE_CM: f64 = 0.3;

struct Dice(Chance);

impl Dice {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.finest_share()
    }
}

fn set(tape: &mut Tape, measure: Measure, cm: f64) {
    let place = match measure {
        Measure::Stature => &mut tape.stature,
        Measure::Bust => &mut tape.bust_girth,
        Measure::Underbust => &mut tape.underbust_girth,
        Measure::Waist => &mut tape.waist_girth,
        Measure::HighHip => &mut tape.high_hip_girth,
        Measure::Hip => &mut tape.hip_girth,
        Measure::Thigh => &mut tape.thigh_girth,
        Measure::Knee => &mut tape.knee_girth,
        Measure::Calf => &mut tape.calf_girth,
        Measure::Ankle => &mut tape.ankle_girth,
        Measure::Inseam => &mut tape.inseam_length,
        Measure::WaistHeight => &mut tape.waist_height,
        Measure::ShoulderBreadth => &mut tape.shoulder_breadth,
        Measure::UpperArmLength => &mut tape.upper_arm_length,
    };
    *place = Some(Length::from_cm(cm));
}

/// A plausible dancer: around the mean of her figure, heavier or lighter as a whole, with scatter
/// of each measure; about a quarter of the measures are left out.
fn random_tape(seed: u64) -> Tape {
    let mut chance = Dice(Chance::new(seed));
    loop {
        let tape = drawn(&mut chance, seed);
        if Measurements::from_tape(&tape).is_ok() {
            return tape;
        }
    }
}

fn drawn(chance: &mut Dice, seed: u64) -> Tape {
    let (figure, statures, weights) = match seed % 5 {
        0 | 1 => (Figure::Woman, [142.0, 182.0], [-0.12, 0.40]),
        2 => (Figure::OfStature, [140.0, 172.0], [-0.10, 0.30]),
        3 => (Figure::Man, [152.0, 195.0], [-0.12, 0.40]),
        _ => (Figure::Child, [100.0, 158.0], [-0.10, 0.22]),
    };
    let mut tape = Tape {
        figure,
        ..Tape::default()
    };
    let stature = chance.between(statures[0], statures[1]);
    set(&mut tape, Measure::Stature, stature);
    let mean = Measurements::from_tape(&tape).unwrap();
    let heavy = chance.between(weights[0], weights[1]);
    let belly = chance.between(0.0, 1.0);
    let belly = if belly > 0.85 { 0.22 } else { 0.0 };
    let mut girth = |mean: Length, follows: f64, extra: f64, scatter: f64| {
        let log = heavy * follows + extra + chance.between(-scatter, scatter);
        mean.to_cm() * lole_geom::trig64::exp(log)
    };
    let bust = girth(mean.bust_girth, 1.0, 0.0, 0.05);
    let waist = girth(mean.waist_girth, 1.15, belly, 0.06);
    let hip = girth(mean.hip_girth, 0.85, 0.0, 0.05);
    let values = [
        (Measure::Bust, bust),
        (Measure::Waist, waist),
        (Measure::Hip, hip),
        (Measure::Thigh, girth(mean.thigh_girth, 0.75, 0.0, 0.05)),
        (Measure::Knee, girth(mean.knee_girth, 0.5, 0.0, 0.05)),
        (Measure::Calf, girth(mean.calf_girth, 0.5, 0.0, 0.05)),
        (Measure::Ankle, girth(mean.ankle_girth, 0.3, 0.0, 0.05)),
        (Measure::Underbust, bust * chance.between(0.82, 0.96)),
        (
            Measure::HighHip,
            waist + (hip - waist) * chance.between(0.45, 0.85),
        ),
        (
            Measure::Inseam,
            mean.inseam_length.to_cm() * chance.between(0.97, 1.03),
        ),
        (Measure::WaistHeight, stature * chance.between(0.595, 0.635)),
        (
            Measure::ShoulderBreadth,
            stature * chance.between(0.21, 0.245),
        ),
        (
            Measure::UpperArmLength,
            stature * chance.between(0.168, 0.188),
        ),
    ];
    for (measure, cm) in values {
        if chance.0.finest_share() < 0.75 {
            set(&mut tape, measure, cm);
        }
    }
    tape
}

/// What is wrong with the dancer of this seed: measures that are off, or why she was refused.
fn faults(seed: u64) -> Vec<String> {
    let tape = random_tape(seed);
    let measurements = Measurements::from_tape(&tape).unwrap();
    let dancer = match Dancer::new(&measurements) {
        Ok(dancer) => dancer,
        Err(error) => return vec![format!("seed {seed} {:?}: {error}", tape.figure)],
    };
    let off = dancer.taped(&tape).into_iter().filter_map(|taped| {
        let given = taped.given?.to_cm();
        let error = taped.on_body.to_cm() - given;
        (error.abs() > TOLERANCE_CM).then(|| {
            let (figure, key) = (tape.figure, taped.measure.key());
            format!("seed {seed} {figure:?}: {key} {given:.1} is {error:+.2} cm off")
        })
    });
    off.chain(open_edges(&dancer).map(|edges| format!("seed {seed}: {edges} open edges")))
        .collect()
}

/// Edges of the body's surface that do not have one triangle on either side, if there are any: the
/// mirrored halves meet in the middle plane.
fn open_edges(dancer: &Dancer) -> Option<usize> {
    let mut edges: Vec<[u32; 2]> = (dancer.skin.body_triangles().into_iter())
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
        .collect();
    edges.sort_unstable();
    let is_lone = |&[a, b]: &[u32; 2]| {
        let twins = edges.partition_point(|edge| *edge <= [b, a])
            - edges.partition_point(|edge| *edge < [b, a]);
        twins != 1
    };
    let lone = edges.iter().filter(|edge| is_lone(edge)).count();
    (lone > 0).then_some(lone)
}

fn assert_no_faults(seeds: std::ops::Range<u64>) {
    let found: Vec<String> = seeds.into_par_iter().flat_map(faults).collect();
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}

#[test]
fn two_dozen_random_dancers_have_every_given_measure() {
    assert_no_faults(0..24);
}

#[test]
#[ignore = "minutes; run in release"]
fn five_hundred_random_dancers_have_every_given_measure() {
    assert_no_faults(0..500);
}

#[test]
fn measures_that_exclude_each_other_are_named_in_both_languages() {
    let mut tape = Tape::default();
    set(&mut tape, Measure::Hip, 90.0);
    set(&mut tape, Measure::Thigh, 80.0);
    let error = Measurements::from_tape(&tape).unwrap_err();
    assert!(matches!(error, BodyError::Conflict { .. }));
    assert_eq!(
        error.to_string(),
        "thigh girth 80.0 cm and hip girth 90.0 cm exclude each other: beside the second, the \
         first lies between 37.8 and 63.0 cm; measure both again"
    );
    assert_eq!(
        error.japanese(),
        "太もも回り 80.0 cm とヒップ 90.0 cm は両立しません（後者に対して前者は 37.8～63.0 cm \
         のはずです）。両方を測り直してください"
    );
}

/// One given measure anywhere in its band never fails for what was only guessed.
#[test]
fn one_measure_alone_is_never_refused_for_an_estimate() {
    for figure in Figure::ALL {
        for measure in Measure::ALL {
            for share in 0..=10 {
                let [least, most] = match measure {
                    Measure::Stature => [100.0, 195.0],
                    Measure::Waist => [60.0, 80.0],
                    Measure::Hip => [80.0, 110.0],
                    Measure::Thigh => [42.0, 65.0],
                    _ => continue,
                };
                let mut tape = Tape {
                    figure,
                    ..Tape::default()
                };
                set(
                    &mut tape,
                    measure,
                    least + (most - least) * f64::from(share) / 10.0,
                );
                let filled = Measurements::from_tape(&tape);
                assert!(filled.is_ok(), "{figure:?} {measure:?} {share}: {filled:?}");
            }
        }
    }
}

/// The means of the surveys stand in the body even where nobody measured them.
#[test]
fn what_is_estimated_is_near_the_means_of_the_surveys() {
    for (figure, shoulders_cm, waist_height_cm) in
        [(Figure::OfStature, 36.0, 97.5), (Figure::Man, 40.0, 103.0)]
    {
        let tape = Tape {
            figure,
            ..Tape::default()
        };
        let measurements = Measurements::from_tape(&tape).unwrap();
        let taped = Dancer::new(&measurements).unwrap().taped(&tape);
        let on_body = |wanted| {
            let line = taped.iter().find(|line| line.measure == wanted).unwrap();
            assert_eq!(line.given, None);
            line.on_body.to_cm()
        };
        let shoulders = on_body(Measure::ShoulderBreadth);
        assert!(
            (shoulders - shoulders_cm).abs() < 1.0,
            "{figure:?} {shoulders}"
        );
        let waist = on_body(Measure::WaistHeight);
        assert!((waist - waist_height_cm).abs() < 0.5, "{figure:?} {waist}");
    }
}

#[test]
fn a_child_is_no_shrunk_adult() {
    let built = |figure, stature| {
        let mut tape = Tape {
            figure,
            ..Tape::default()
        };
        set(&mut tape, Measure::Stature, stature);
        Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap()
    };
    let head = |dancer: &Dancer| {
        let joint = dancer.skeleton.joint(lole_body::Bone::Head);
        (dancer.landmarks.crown_height - joint.y) / dancer.landmarks.crown_height
    };
    let [small, child, woman] = [
        built(Figure::OfStature, 100.0),
        built(Figure::Child, 128.0),
        built(Figure::Woman, 158.0),
    ];
    assert!(head(&small) > head(&child) && head(&child) > 1.1 * head(&woman));
    let legs = |dancer: &Dancer| dancer.landmarks.crotch_height / dancer.landmarks.crown_height;
    assert!(legs(&small) < legs(&child));
}
