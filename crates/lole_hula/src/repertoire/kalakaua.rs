//! Kalākaua: three steps of one name.

use lole_language::words;

use super::kawelu::KAWELU;
use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, FootScore, Hips, LEFT, MIDDLE, RIGHT, STILL, Score, Stand, Stride, Sway,
    derived, fact, land, standing,
};

pub(super) const KALAKAUA: Score = Score {
    id: "kalakaua",
    name: "kalākaua",
    title: words("カラカウア（かかと）", "heel beats"),
    facts: &[fact(
        words(
            "辞書のカヴェルの英語名。同じステップ",
            "the English name of the dictionary's kāwelu: the same step",
        ),
        &["27"],
    )],
    questions: &[words(
        "カヴェルと区別するか",
        "is it told apart from kāwelu?",
    )],
    ..KAWELU
};

pub(super) const KALAKAUA_SWAY: Score = Score {
    id: "kalakaua-sway",
    name: "kalākaua (kaʻo)",
    title: words("カラカウア（カオ）", "kaʻo with feet"),
    about: words(
        "カオをしながら片足を前に出して戻す",
        "A kaʻo whose foot goes to the front and back.",
    ),
    teaching: &[
        words(
            "左足に重み、右足を前へ",
            "weight left, the right foot forward",
        ),
        words(
            "右足に重み、左のかかとが浮く",
            "weight on the right foot, left heel up",
        ),
        words(
            "右足を戻し、左のかかとを下ろす",
            "the right foot returns, left heel down",
        ),
        words("右足に重み", "weight on the right foot"),
    ],
    facts: &[fact(
        words(
            "イ・ムア（前）とイ・ホペ（うしろ）がある",
            "i mua goes forward, i hope back",
        ),
        &["30"],
    )],
    questions: &[words(
        "四拍目で足をそろえるか、拍を置くか",
        "do the feet close on four?",
    )],
    feet: [
        FootScore {
            heel_follows: true,
            ..standing(LEFT)
        },
        standing(RIGHT).landing(&[
            land(1.0, Stand::flat(RIGHT.by(0.0, 0.15))),
            land(3.0, Stand::flat(RIGHT)),
        ]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.04,
            roll: 7.0,
            yaw: 2.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[
                Change(1.05, 2.0, -2.0),
                Change(2.05, 3.0, 2.0),
                Change(3.05, 4.0, -2.0),
            ],
        },
    },
    dips: &[],
    arms: ArmPlan::Open,
    ..KAWELU
};

/// A quarter turn to the right and back.
const TURN: &[Change] = &[Change(0.05, 1.25, -90.0), Change(1.3, 2.8, 90.0)];

pub(super) const KALAKAUA_TURN: Score = Score {
    id: "kalakaua-turn",
    name: "kalākaua (turn)",
    title: words("カラカウア（ターン）", "turning kāholo"),
    about: words(
        "左足を軸に右へ四分の一開き、戻る",
        "The body opens a quarter turn to the right about the left foot, and comes back.",
    ),
    teaching: &[
        words(
            "右足をうしろへ、体は右へ四分の一",
            "the right foot steps back, the body opens to the right",
        ),
        words(
            "左足に重み、前へ戻り始める",
            "weight on the left, turning forward",
        ),
        words(
            "右足を前に戻す",
            "the right foot returns, the body faces front",
        ),
        words("左足を寄せてタッチ", "the left foot closes and taps"),
    ],
    facts: &[
        fact(words("回るカホロ", "the turning kāholo"), &["11b"]),
        derived(words("拍の割り方", "how the turn is split over the counts")),
    ],
    questions: &[words(
        "半回転なら一拍目と三拍目に分けるか",
        "is a half turn split over one and three?",
    )],
    feet: [
        standing(LEFT)
            .twisting(&[Change(0.15, 1.15, -90.0), Change(1.4, 2.7, 90.0)])
            .landing(&[land(4.0, Stand::tap(MIDDLE)).closing()]),
        standing(MIDDLE).from(Stand::tap(MIDDLE)).landing(&[
            land(1.0, Stand::flat(MIDDLE.by(0.05, -0.11)).facing(-90.0)).flying(0.6),
            land(3.0, Stand::flat(RIGHT)).flying(0.6),
        ]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.03,
            roll: 5.0,
            yaw: 1.5,
        },
        side: Curve {
            start: 1.0,
            changes: &[
                Change(0.3, 1.2, -2.0),
                Change(1.2, 2.1, 2.0),
                Change(2.5, 3.5, -2.0),
            ],
        },
    },
    heading: Curve::from_zero(TURN),
    sink: 0.022,
    stride: Stride {
        step: 0.0,
        more: 0.09,
    },
    arms: ArmPlan::LeadAndChest,
    ..STILL
};
