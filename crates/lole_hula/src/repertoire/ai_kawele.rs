//! ʻAi kāwele: a foot draws half a circle in the air.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{Hips, LEFT, RIGHT, STILL, Score, Stand, Sway, estimate, fact, land, standing};

pub(super) const AI_KAWELE: Score = Score {
    id: "ai-kawele",
    name: "ʻai kāwele",
    title: words("アイ・カヴェレ", "half a circle in the air"),
    about: words(
        "片足で前から横へ半円を描き、床に触れずに下ろす",
        "A foot draws half a circle forward and to the side without touching the floor, and lands.",
    ),
    teaching: &[
        words(
            "右足で前から横へ半円。左足に重み",
            "the right foot draws half a circle forward and out, weight left",
        ),
        words("右足を下ろす", "the right foot lands"),
    ],
    facts: &[
        fact(
            words(
                "床に触れずに前から横へ半円。ホロやウエヘにつなぐ",
                "half a circle forward and to the side without touching the floor; joined with holo or ʻuwehe",
            ),
            &["3"],
        ),
        estimate(words(
            "前へ 0.10、横へ 0.13 身長、高さ 6 cm",
            "0.10 statures forward, 0.13 to the side, 6 cm high",
        )),
    ],
    questions: &[words(
        "円の大きさと高さ",
        "how large is the circle, and how high?",
    )],
    tempo: [76.0, 132.0],
    half: 2.0,
    feet: [
        standing(LEFT),
        standing(RIGHT).landing(&[land(2.0, Stand::flat(RIGHT))
            .flying(1.6)
            .lifted(0.036)
            .swinging([-0.13, 0.10])
            .free()]),
    ],
    hips: Hips::Eight {
        amplitude: Sway {
            shift: 0.035,
            roll: 4.0,
            yaw: 1.0,
        },
        depth: 0.0,
        counts: 4.0,
    },
    sink: 0.022,
    arms: ArmPlan::Open,
    ..STILL
};
