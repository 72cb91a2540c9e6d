//! Kāholo, the vamp, and its variants.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Answer, Change, Curve, Dip, FootScore, Hips, LEFT, MIDDLE, RIGHT, STILL, Score, Stand, Stride,
    Sway, Travel, estimate, fact, land, spot, standing,
};

const SWAY: Sway = Sway {
    shift: 0.035,
    roll: 6.0,
    yaw: 1.5,
};

/// The right foot at the end of a phrase to the left.
const TAPPING: FootScore = standing(MIDDLE).from(Stand::tap(MIDDLE));

const HIPS: Hips = Hips::Sway {
    amplitude: SWAY,
    holds: &[0.5, 4.5],
};

pub(super) const KAHOLO: Score = Score {
    id: "kaholo",
    name: "kāholo",
    title: words("カホロ", "vamp"),
    about: words(
        "右へ二歩すべらせて寄せ、左へ同じだけ戻る",
        "Two sliding steps to the right with a tap, and two to the left.",
    ),
    teaching: &[
        words("右足を右へ", "the right foot steps right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右へ", "the right foot steps right"),
        words(
            "左足を寄せてつま先でタッチ",
            "the left foot closes and taps",
        ),
    ],
    facts: &[
        fact(
            words(
                "歩幅は肩幅くらい、一歩目も二歩目も同じ",
                "steps are about as wide as the shoulders, the first as the second",
            ),
            &["6", "10"],
        ),
        fact(
            words(
                "四拍目は重みをかけずにつま先で触れる",
                "on four the toes touch without weight",
            ),
            &["1", "2", "8", "9", "13"],
        ),
        fact(
            words(
                "日本では、拍で足を置くとき腰はまだ反対側にある",
                "in Japan the foot is placed on the count while the hips are still over the other one",
            ),
            &["6", "8", "19"],
        ),
        fact(
            words(
                "拍で腰を出す足の側へ揺らす教え方もある",
                "others sway toward the stepping foot on the count",
            ),
            &["2"],
        ),
        fact(
            words(
                "股関節の内転 11°（X線での実測）。屈曲 17°、外旋 11°",
                "hip adduction 11° (measured by radiograph); flexion 17°, external rotation 11°",
            ),
            &["20"],
        ),
        estimate(words(
            "足が浮くのは半拍、高さ 1.6 cm",
            "a foot is in the air for half a count, 1.6 cm high",
        )),
    ],
    questions: &[
        words(
            "腰は踏み出す足の側か、残る足の側か",
            "are the hips over the stepping foot or over the other one?",
        ),
        words(
            "四拍目のかかとの向き",
            "which way does the heel point on four?",
        ),
    ],
    half: 4.0,
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(spot(1.0, -1.0))).closing(),
            land(4.0, Stand::tap(spot(0.0, -2.0))).closing(),
        ]),
        TAPPING.landing(&[
            land(1.0, Stand::flat(spot(-1.0, -1.0))),
            land(3.0, Stand::flat(spot(-1.0, -2.0))),
        ]),
    ],
    hips: HIPS,
    travel: Travel::Even,
    way: spot(0.0, -2.0),
    sink: 0.012,
    stride: Stride {
        step: 1.0,
        more: 0.0,
    },
    arms: ArmPlan::LeadAndChest,
    ..STILL
};

pub(super) const KAHOLO_DIP: Score = Score {
    id: "kaholo-dip",
    name: "kāholo (dip)",
    title: words("カホロ・ディップ", "vamp with a dip"),
    about: words(
        "一拍目で腰を沈めるカホロ",
        "A kāholo that sinks on its first count.",
    ),
    facts: &[
        fact(
            words("カホロの変化形", "a variant of kāholo"),
            &["1", "2", "13"],
        ),
        estimate(words(
            "沈む深さ 0.03 身長（5 cm）",
            "it sinks by 0.03 statures (5 cm)",
        )),
    ],
    questions: &[words(
        "どの拍で、どれだけ沈むか",
        "on which count does it sink, and how far?",
    )],
    dips: &[Dip {
        drop: 0.03,
        share: Curve::from_zero(&[Change(0.3, 1.0, 1.0), Change(1.15, 2.0, -1.0)]),
    }],
    ..KAHOLO
};

pub(super) const KAHOLO_DOUBLE: Score = Score {
    id: "kaholo-double",
    name: "kāholo (double)",
    title: words("ダブル・カホロ", "double vamp"),
    about: words(
        "右へ四歩、左へ四歩のカホロ",
        "A kāholo of four steps each way.",
    ),
    teaching: &[
        words("右足を右へ", "the right foot steps right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右へ", "the right foot steps right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右へ", "the right foot steps right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右へ", "the right foot steps right"),
        words("左足を寄せてタッチ", "the left foot closes and taps"),
    ],
    facts: &[fact(
        words("八拍ずつのカホロ", "a kāholo of eight counts each way"),
        &["2", "13"],
    )],
    half: 8.0,
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(spot(1.0, -1.0))).closing(),
            land(4.0, Stand::flat(spot(1.0, -2.0))).closing(),
            land(6.0, Stand::flat(spot(1.0, -3.0))).closing(),
            land(8.0, Stand::tap(spot(0.0, -4.0))).closing(),
        ]),
        TAPPING.landing(&[
            land(1.0, Stand::flat(spot(-1.0, -1.0))),
            land(3.0, Stand::flat(spot(-1.0, -2.0))),
            land(5.0, Stand::flat(spot(-1.0, -3.0))),
            land(7.0, Stand::flat(spot(-1.0, -4.0))),
        ]),
    ],
    hips: Hips::Sway {
        amplitude: SWAY,
        holds: &[0.5, 8.5],
    },
    way: spot(0.0, -4.0),
    ..KAHOLO
};

/// Side steps that a step to the front is long: farther, and the hips would fall behind.
const AHEAD: f32 = 0.8;

pub(super) const KAHOLO_FORWARD: Score = Score {
    id: "kaholo-forward",
    name: "kāholo i mua, i hope",
    title: words("カホロ（前後）", "vamp forward and back"),
    about: words(
        "前へ二歩、うしろへ二歩のカホロ",
        "A kāholo of two steps forward and two back.",
    ),
    teaching: &[
        words("右足を前へ", "the right foot steps forward"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を前へ", "the right foot steps forward"),
        words(
            "左足を寄せてタッチ。次は左足からうしろへ",
            "the left foot closes and taps; then back, left foot first",
        ),
    ],
    facts: &[
        fact(
            words(
                "イ・ムア（前へ）、イ・ホペ（うしろへ）",
                "i mua is forward, i hope is back",
            ),
            &["2", "13"],
        ),
        estimate(words(
            "前への歩幅は横の 0.8",
            "a step forward is 0.8 of a step to the side",
        )),
    ],
    answer: Answer::MirrorBackward,
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(LEFT.steps_ahead(AHEAD))).closing(),
            land(4.0, Stand::tap(MIDDLE.steps_ahead(2.0 * AHEAD))).closing(),
        ]),
        TAPPING.landing(&[
            land(1.0, Stand::flat(RIGHT.steps_ahead(AHEAD))),
            land(3.0, Stand::flat(RIGHT.steps_ahead(2.0 * AHEAD))),
        ]),
    ],
    way: MIDDLE.steps_ahead(2.0 * AHEAD),
    stride: Stride {
        step: 0.4,
        more: 0.0,
    },
    ..KAHOLO
};

/// Side steps to the side and to the front of a diagonal step.
const ASLANT: f32 = 0.65;

pub(super) const KAHOLO_DIAGONAL: Score = Score {
    id: "kaholo-diagonal",
    name: "kāholo (diagonal)",
    title: words("カホロ（斜め）", "diagonal vamp"),
    about: words(
        "右斜め前へ二歩、左斜めうしろへ二歩のカホロ",
        "A kāholo of two steps forward to the right and two back to the left.",
    ),
    teaching: &[
        words("右足を右斜め前へ", "the right foot steps forward right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右斜め前へ", "the right foot steps forward right"),
        words("左足を寄せてタッチ", "the left foot closes and taps"),
    ],
    facts: &[fact(
        words("カホロの変化形", "a variant of kāholo"),
        &["2", "13"],
    )],
    answer: Answer::MirrorBackward,
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(spot(1.0, -ASLANT).steps_ahead(ASLANT))).closing(),
            land(
                4.0,
                Stand::tap(spot(0.0, -2.0 * ASLANT).steps_ahead(2.0 * ASLANT)),
            )
            .closing(),
        ]),
        TAPPING.landing(&[
            land(1.0, Stand::flat(spot(-1.0, -ASLANT).steps_ahead(ASLANT))),
            land(
                3.0,
                Stand::flat(spot(-1.0, -2.0 * ASLANT).steps_ahead(2.0 * ASLANT)),
            ),
        ]),
    ],
    way: spot(0.0, -2.0 * ASLANT).steps_ahead(2.0 * ASLANT),
    stride: Stride {
        step: 1.0,
        more: 0.0,
    },
    ..KAHOLO
};
