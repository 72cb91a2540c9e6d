//! Holo: running sideways.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Hips, LEFT, MIDDLE, RIGHT, STILL, Score, Stand, Stride, Sway, Travel, estimate, fact, land,
    standing,
};

/// How far a foot runs [statures].
const RUN: f32 = 0.2;

pub(super) const HOLO: Score = Score {
    id: "holo",
    name: "holo",
    title: words("ホロ", "run"),
    about: words(
        "ひざを低くして横へ走る",
        "Running sideways with low knees; the feet need not close.",
    ),
    teaching: &[
        words("右足を右へ", "the right foot runs right"),
        words("左足が続く", "the left foot follows"),
        words("右足を右へ", "the right foot runs right"),
        words("左足が続く", "the left foot follows"),
    ],
    facts: &[
        fact(
            words(
                "カホロのように横へ走る。足はそろえなくてよい",
                "running sideways as in kāholo; the feet need not close",
            ),
            &["3"],
        ),
        fact(
            words("ホロホロは寄せ足で滑る", "holoholo is step-close slides"),
            &["2"],
        ),
        estimate(words("一歩 0.2 身長", "0.2 statures a step")),
    ],
    questions: &[words("足をそろえるか", "do the feet close?")],
    tempo: [76.0, 132.0],
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(LEFT.by(-RUN, 0.0))),
            land(4.0, Stand::flat(LEFT.by(-2.0 * RUN, 0.0))),
        ]),
        standing(RIGHT).landing(&[
            land(1.0, Stand::flat(RIGHT.by(-RUN, 0.0))).lifted(0.02),
            land(3.0, Stand::flat(RIGHT.by(-2.0 * RUN, 0.0))).lifted(0.02),
        ]),
    ],
    hips: Hips::Sway {
        amplitude: Sway {
            shift: 0.02,
            roll: 4.0,
            yaw: 1.5,
        },
        holds: &[0.5, 4.5],
    },
    travel: Travel::Even,
    way: MIDDLE.by(-2.0 * RUN, 0.0),
    sink: 0.024,
    stride: Stride {
        step: 0.0,
        more: RUN,
    },
    arms: ArmPlan::LeadAndChest,
    ..STILL
};
