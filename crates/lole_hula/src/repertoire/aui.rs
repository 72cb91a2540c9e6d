//! ʻAui: turned aside, a foot points out again and again.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, Hips, LEFT, RIGHT, STILL, Score, Stand, Sway, estimate, fact, land, standing,
};

/// The body turns to the right, and back to the front.
const TURN: &[Change] = &[Change(0.1, 1.0, -60.0), Change(3.1, 4.0, 60.0)];

pub(super) const AUI: Score = Score {
    id: "aui",
    name: "ʻaui",
    title: words("アウイ", "turned aside"),
    about: words(
        "体を横に向け、足を何度も出し、上体を傾けて手を足先へ",
        "Turned to the side, a foot points out again and again, and the body tips after the low hand.",
    ),
    teaching: &[
        words(
            "体を右へ向け、右足を出す",
            "the body turns right, the right foot points out",
        ),
        words("右足を引き寄せる", "the right foot is drawn back"),
        words("もう一度右足を出す", "the right foot points out again"),
        words("右足を戻し、正面へ", "the right foot returns, facing front"),
    ],
    facts: &[
        fact(
            words(
                "横を向き、足を二度から四度出す。間によく引く。上体を傾け、低い手は足先を指し、もう一方は高くうしろへ",
                "turned to the side, the foot points out two to four times and is drawn well back between; the body tips so that the low hand points to the toes, the other is high behind",
            ),
            &["3"],
        ),
        estimate(words("60°向き、22°傾く", "turned by 60°, tipped by 22°")),
    ],
    questions: &[words(
        "何度向き、何度傾くか",
        "how far does the body turn and tip?",
    )],
    feet: [
        standing(LEFT).twisting(&[Change(0.15, 0.95, -60.0), Change(3.05, 3.85, 60.0)]),
        standing(RIGHT).landing(&[
            land(1.0, Stand::ball(RIGHT.by(-0.10, 0.07), 0.018).facing(-60.0)).free(),
            land(2.0, Stand::ball(RIGHT.by(0.02, 0.0), 0.018).facing(-60.0)).free(),
            land(3.0, Stand::ball(RIGHT.by(-0.10, 0.07), 0.018).facing(-60.0)).free(),
            land(4.0, Stand::flat(RIGHT)).free(),
        ]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.03,
            roll: 4.0,
            yaw: 1.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[Change(3.1, 4.0, -2.0)],
        },
    },
    heading: Curve::from_zero(TURN),
    lean: Curve::from_zero(&[Change(0.3, 1.2, -22.0), Change(3.0, 3.9, 22.0)]),
    sink: 0.028,
    arms: ArmPlan::ToesAndBehind,
    ..STILL
};
