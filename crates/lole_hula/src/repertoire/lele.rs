//! Lele: walking; and lele ʻuwehe.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Answer, Change, Curve, Dip, Hips, LEFT, MIDDLE, RIGHT, Raise, STILL, Score, Stand, Stride,
    Sway, estimate, fact, land, spot, standing,
};

/// How long a walking step is [statures].
const PACE: f32 = 0.16;

const fn heel(share: Curve) -> Raise {
    Raise {
        lift: 0.0,
        heel: 0.030,
        knee_out: 0.0,
        share,
    }
}

pub(super) const LELE: Score = Score {
    id: "lele",
    name: "lele",
    title: words("レレ", "walk"),
    about: words(
        "うしろのかかとを上げながら前へ歩き、同じだけ下がる",
        "A walk whose rear heel rises with each step: forward, and back.",
    ),
    teaching: &[
        words(
            "右足を前へ、左のかかとが上がる",
            "the right foot forward, the left heel rises",
        ),
        words(
            "左足を前へ、右のかかとが上がる",
            "the left foot forward, the right heel rises",
        ),
        words(
            "右足を前へ、左のかかとが上がる",
            "the right foot forward, the left heel rises",
        ),
        words(
            "左足をそろえる。次は左足からうしろへ",
            "the left foot closes; then back, left foot first",
        ),
    ],
    facts: &[
        fact(
            words(
                "日本の基本では、足を出すとき少し伸び上がる",
                "as a basic in Japan, the body rises slightly with the step",
            ),
            &["1"],
        ),
        estimate(words(
            "歩くごとにうしろのかかとが上がり、少し内へ向く。うしろへも行く",
            "the rear heel rises with each step, turning slightly inward; it may go back",
        )),
        estimate(words(
            "一歩 0.16 身長、かかと 5 cm",
            "0.16 statures a step, heel 5 cm",
        )),
    ],
    questions: &[words(
        "四拍目でそろえるか、歩き続けるか",
        "do the feet close on four, or walk on?",
    )],
    answer: Answer::MirrorBackward,
    feet: [
        standing(LEFT)
            .landing(&[
                land(2.0, Stand::flat(LEFT.by(0.0, 2.0 * PACE))),
                land(4.0, Stand::flat(LEFT.by(0.0, 3.0 * PACE))),
            ])
            .raising(&[heel(Curve::from_zero(&[
                Change(0.6, 1.2, 1.0),
                Change(1.5, 1.9, -1.0),
                Change(2.6, 3.2, 1.0),
                Change(3.5, 3.9, -1.0),
            ]))]),
        standing(RIGHT)
            .landing(&[
                land(1.0, Stand::flat(RIGHT.by(0.0, PACE))),
                land(3.0, Stand::flat(RIGHT.by(0.0, 3.0 * PACE))),
            ])
            .raising(&[heel(Curve::from_zero(&[
                Change(1.6, 2.2, 1.0),
                Change(2.5, 2.9, -1.0),
            ]))]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.03,
            roll: 5.0,
            yaw: 3.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[
                Change(0.25, 1.1, -2.0),
                Change(1.25, 2.1, 2.0),
                Change(2.25, 3.1, -2.0),
            ],
        },
    },
    way: MIDDLE.by(0.0, 3.0 * PACE),
    sink: 0.014,
    stride: Stride {
        step: 0.0,
        more: 0.09,
    },
    arms: ArmPlan::Open,
    ..STILL
};

pub(super) const LELE_UWEHE: Score = Score {
    id: "lele-uwehe",
    name: "lele ʻuwehe",
    title: words("レレ・ウエヘ", "step, point and snap"),
    about: words(
        "横へ一歩、反対の足を斜め前に出し、寄せて両かかとを上げる",
        "A step to the side, a point of the other foot, and both heels up.",
    ),
    teaching: &[
        words(
            "伸び上がって右足を右へ",
            "rising, the right foot steps right",
        ),
        words("左足を斜め前に出す", "the left foot points forward"),
        words(
            "左足を寄せ、両ひざを曲げる",
            "the left foot closes, both knees bend",
        ),
        words("両かかとを上げて下ろす", "both heels up and down"),
    ],
    facts: &[
        fact(
            words("右へ、出す、寄せる、ウエヘ", "step, point, close, ʻuwehe"),
            &["1", "12b"],
        ),
        estimate(words(
            "ひざを曲げる深さ 0.02 身長",
            "the knees bend by 0.02 statures",
        )),
    ],
    questions: &[words(
        "ウエヘは四拍目か、三拍目の裏か",
        "do the heels snap on four, or on the half beat before?",
    )],
    feet: [
        standing(LEFT)
            .landing(&[
                land(
                    2.0,
                    Stand::ball(spot(1.0, -1.0).by(0.06, 0.12), 0.016).out(10.0),
                ),
                land(3.0, Stand::flat(spot(1.0, -1.0))),
            ])
            .raising(&[
                SNAP,
                Raise {
                    lift: 0.0,
                    heel: 0.016,
                    knee_out: 0.0,
                    share: Curve::from_zero(&[Change(0.4, 0.85, 1.0), Change(0.95, 1.4, -1.0)]),
                },
            ]),
        standing(RIGHT)
            .landing(&[land(1.0, Stand::flat(spot(-1.0, -1.0)))])
            .raising(&[SNAP]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.03,
            roll: 5.0,
            yaw: 1.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[
                Change(0.3, 1.2, -2.0),
                Change(2.2, 3.0, 0.7),
                Change(3.1, 4.0, -0.7),
            ],
        },
    },
    way: spot(0.0, -1.0),
    dips: &[Dip {
        drop: 0.012,
        share: Curve::from_zero(&[Change(2.2, 3.0, 1.0), Change(3.1, 4.0, -1.0)]),
    }],
    sink: 0.016,
    stride: Stride {
        step: 1.0,
        more: 0.0,
    },
    arms: ArmPlan::HighAndLow,
    arms_later: -2.5,
    ..STILL
};

/// Both heels are up on the fourth count and come down after it.
const SNAP: Raise = Raise {
    lift: 0.0,
    heel: 0.030,
    knee_out: 28.0,
    share: Curve {
        start: 1.0,
        changes: &[Change(0.04, 0.4, -1.0), Change(3.7, 4.0, 1.0)],
    },
};
