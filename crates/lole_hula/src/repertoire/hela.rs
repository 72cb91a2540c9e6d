//! Hela: a foot points forward and out, and comes back.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, Dip, Hips, LEFT, RIGHT, STILL, Score, Stand, Sway, derived, estimate, fact,
    land, standing,
};

pub(super) const HELA: Score = Score {
    id: "hela",
    name: "hela",
    title: words("ヘラ", "point"),
    about: words(
        "片足を斜め前に出して戻す。左右交互",
        "A foot points forward and out and comes back; right and left.",
    ),
    teaching: &[
        words(
            "右足を右斜め前へ。左ひざを曲げ、腰は左",
            "the right foot points forward right; left knee bent, hips left",
        ),
        words(
            "右足を戻し、重みを移す",
            "the right foot returns, the weight crosses",
        ),
    ],
    facts: &[
        fact(
            words(
                "45°前に出す。出した足に重みはかけない",
                "it points at 45°, without weight",
            ),
            &["1", "2", "3", "8", "11"],
        ),
        fact(
            words(
                "腰を静かに保つ流派がある",
                "one school keeps the hips quiet",
            ),
            &["19b"],
        ),
        derived(words(
            "出す距離 0.16 身長。0.18 ではひざが伸びきる",
            "it points by 0.16 statures; at 0.18 the knee would lock",
        )),
        estimate(words(
            "出した足はボールで触れ、かかとは 3 cm 上がる",
            "the pointing foot touches with its ball, the heel 3 cm up",
        )),
    ],
    questions: &[
        words(
            "足裏全体で出すか、つま先か",
            "does it point with the whole sole or with the toes?",
        ),
        words("腰を動かすか", "do the hips move?"),
    ],
    half: 2.0,
    feet: [
        standing(LEFT),
        standing(RIGHT).landing(&[
            land(1.0, Stand::ball(RIGHT.by(-0.113, 0.113), 0.02).out(12.0)).free(),
            land(2.0, Stand::flat(RIGHT)).free(),
        ]),
    ],
    hips: Hips::Eight {
        amplitude: Sway {
            shift: 0.03,
            roll: 5.0,
            yaw: 1.0,
        },
        depth: 0.0,
        counts: 4.0,
    },
    dips: &[Dip {
        drop: 0.006,
        share: Curve::from_zero(&[Change(0.2, 1.0, 1.0), Change(1.0, 1.8, -1.0)]),
    }],
    sink: 0.020,
    arms: ArmPlan::HighAndLow,
    arms_later: 1.0,
    ..STILL
};
