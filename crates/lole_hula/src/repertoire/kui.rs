//! Kuʻi: the foot twists and the heel stamps.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, Hips, LEFT, RIGHT, Raise, STILL, Score, Sway, estimate, fact, standing,
};

pub(super) const KUI: Score = Score {
    id: "kui",
    name: "kuʻi",
    title: words("クイ", "twist and stamp"),
    about: words(
        "足のボールを軸にかかとを外へ振って打ち、戻して打つ",
        "On its ball, a foot swings its heel out and stamps, then in and stamps.",
    ),
    teaching: &[
        words("右のかかとを外へ打つ", "the right heel stamps outside"),
        words("内へ戻して打つ", "and back inside"),
        words("外へ打つ", "outside"),
        words("内へ戻して打つ", "and back inside"),
    ],
    facts: &[
        fact(
            words("足をひねり、かかとで打つ", "foot twisting, heel stamping"),
            &["31"],
        ),
        estimate(words(
            "かかとの振り 25°、四拍で反対の足へ。根拠は弱い",
            "the heel swings by 25°, four counts a side; the evidence is weak",
        )),
    ],
    questions: &[words(
        "これがクイと呼べる動きか",
        "is this what is called kuʻi?",
    )],
    tempo: [76.0, 132.0],
    feet: [
        standing(LEFT),
        standing(RIGHT)
            .twisting(&[
                Change(0.4, 0.9, 25.0),
                Change(1.4, 1.9, -25.0),
                Change(2.4, 2.9, 25.0),
                Change(3.38, 3.88, -25.0),
            ])
            .raising(&[Raise {
                lift: 0.0,
                heel: 0.016,
                knee_out: 0.0,
                share: Curve::from_zero(&[
                    Change(0.25, 0.6, 1.0),
                    Change(0.7, 1.0, -1.0),
                    Change(1.25, 1.6, 1.0),
                    Change(1.7, 2.0, -1.0),
                    Change(2.25, 2.6, 1.0),
                    Change(2.7, 3.0, -1.0),
                    Change(3.25, 3.6, 1.0),
                    Change(3.7, 4.0, -1.0),
                ]),
            }]),
    ],
    hips: Hips::Sway {
        amplitude: Sway {
            shift: 0.02,
            roll: 3.0,
            yaw: 10.0,
        },
        holds: &[0.5, 4.5],
    },
    sink: 0.030,
    arms: ArmPlan::Open,
    ..STILL
};
