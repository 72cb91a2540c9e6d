//! Neʻe: kaʻo that creeps to the side.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Hips, LEFT, MIDDLE, RIGHT, STILL, Score, Stand, Stride, Sway, Travel, estimate, fact, land,
    standing,
};

/// How far a foot creeps [statures].
const CREEP: f32 = 0.1;

pub(super) const NEE: Score = Score {
    id: "nee",
    name: "neʻe",
    title: words("ネエ", "creeping"),
    about: words(
        "カオをしながら少しずつ横へ進む",
        "A kaʻo whose feet creep to the side.",
    ),
    teaching: &[
        words("右足を少し右へ", "the right foot creeps right"),
        words("左足が続く", "the left foot follows"),
        words("右足を少し右へ", "the right foot creeps right"),
        words("左足が続く", "the left foot follows"),
    ],
    facts: &[
        fact(
            words("カオで少しずつ進む", "a kaʻo that moves along"),
            &["4"],
        ),
        estimate(words("一拍に 0.05 身長", "0.05 statures a count")),
    ],
    questions: &[words(
        "つま先とかかとを交互にずらすか、足を運ぶか",
        "do toes and heels creep in turn, or do the feet step?",
    )],
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(LEFT.by(-CREEP, 0.0))).lifted(0.005),
            land(4.0, Stand::flat(LEFT.by(-2.0 * CREEP, 0.0))).lifted(0.005),
        ]),
        standing(RIGHT).landing(&[
            land(1.0, Stand::flat(RIGHT.by(-CREEP, 0.0))).lifted(0.005),
            land(3.0, Stand::flat(RIGHT.by(-2.0 * CREEP, 0.0))).lifted(0.005),
        ]),
    ],
    hips: Hips::Sway {
        amplitude: Sway {
            shift: 0.04,
            roll: 8.0,
            yaw: 2.0,
        },
        holds: &[0.5, 4.5],
    },
    travel: Travel::Even,
    way: MIDDLE.by(-2.0 * CREEP, 0.0),
    sink: 0.006,
    stride: Stride {
        step: 0.0,
        more: CREEP,
    },
    arms: ArmPlan::Open,
    ..STILL
};
