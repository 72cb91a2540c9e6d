//! Kaʻapuni: round the island.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Answer, Change, Curve, Hips, LEFT, RIGHT, STILL, Score, Spot, Stand, Stride, Sway, Travel,
    derived, estimate, fact, land, spot, standing,
};

/// A quarter turn to the left with each step of the right foot.
const QUARTERS: &[Change] = &[
    Change(0.2, 1.8, 90.0),
    Change(2.2, 3.8, 90.0),
    Change(4.2, 5.8, 90.0),
    Change(6.2, 7.8, 90.0),
];

/// The right foot beside the ball of the left one after a turn: `base` half stances to the left of
/// the ball, and so on.
const fn round(base: f32, base_ahead: f32, side: f32, ahead: f32) -> Spot {
    spot(1.0 + base, 0.0)
        .bases_ahead(base_ahead)
        .by(side, 0.077 + ahead)
}

pub(super) const KAAPUNI: Score = Score {
    id: "kaapuni",
    name: "kaʻapuni",
    title: words("カアプニ", "around the island"),
    about: words(
        "左足のボールを軸に、アミを回しながら四歩で一周する",
        "Four steps round the ball of the left foot, with an ʻami each: a whole turn.",
    ),
    teaching: &[
        words(
            "右足を踏み出し、四分の一回る",
            "the right foot steps round: a quarter turn",
        ),
        words("アミ", "ʻami"),
        words(
            "右足を踏み出し、四分の一回る",
            "the right foot steps round: a quarter turn",
        ),
        words("アミ", "ʻami"),
        words(
            "右足を踏み出し、四分の一回る",
            "the right foot steps round: a quarter turn",
        ),
        words("アミ", "ʻami"),
        words(
            "右足を踏み出し、四分の一回る",
            "the right foot steps round: a quarter turn",
        ),
        words("アミ。一周", "ʻami: a whole turn"),
    ],
    facts: &[
        fact(
            words(
                "片足を軸に、四歩か八歩で一周",
                "round one foot in four or eight steps",
            ),
            &["1", "3", "23"],
        ),
        estimate(words("一周八拍", "eight counts for the whole turn")),
        derived(words(
            "右足の円の半径 0.15 身長",
            "the right foot goes round at a radius of 0.15 statures",
        )),
    ],
    questions: &[words(
        "どちらへ回るか、四歩か八歩か",
        "which way round, and in four steps or eight?",
    )],
    half: 8.0,
    answer: Answer::Repeat,
    feet: [
        standing(LEFT).twisting(QUARTERS),
        standing(RIGHT).landing(&[
            land(1.0, Stand::flat(round(0.0, 2.0, -0.077, 0.0)).facing(90.0)),
            land(3.0, Stand::flat(round(2.0, 0.0, 0.0, 0.077)).facing(180.0)),
            land(5.0, Stand::flat(round(0.0, -2.0, 0.077, 0.0)).facing(270.0)),
            land(7.0, Stand::flat(RIGHT).facing(360.0)),
        ]),
    ],
    hips: Hips::Circle {
        amplitude: Sway {
            shift: 0.035,
            roll: 5.0,
            yaw: 0.0,
        },
        depth: 0.024,
        tilt: 4.0,
        rates: &[(0.0, 0.5)],
        size: Curve {
            start: 1.0,
            changes: &[],
        },
        front: None,
    },
    travel: Travel::RoundLeftBall,
    heading: Curve::from_zero(QUARTERS),
    sink: 0.014,
    stride: Stride {
        step: 0.0,
        more: 0.10,
    },
    arms: ArmPlan::Open,
    ..STILL
};
