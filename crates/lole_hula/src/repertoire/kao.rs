//! Kaʻo: sway in place.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Answer, FootScore, Hips, LEFT, RIGHT, STILL, Score, Sway, derived, estimate, fact, standing,
};

const SWAY: Sway = Sway {
    shift: 0.045,
    roll: 9.0,
    yaw: 2.0,
};

const fn swaying(foot: FootScore) -> FootScore {
    FootScore {
        heel_follows: true,
        ..foot
    }
}

pub(super) const KAO: Score = Score {
    id: "kao",
    name: "kaʻo",
    title: words("カオ", "sway in place"),
    about: words(
        "足を置いたまま、腰を左右に揺らす",
        "The hips go from side to side over standing feet.",
    ),
    teaching: &[
        words(
            "腰を左へ。左足に重み、右のかかとが浮く",
            "hips left, weight on the left foot, right heel up",
        ),
        words(
            "腰を右へ。右足に重み、左のかかとが浮く",
            "hips right, weight on the right foot, left heel up",
        ),
    ],
    facts: &[
        fact(
            words(
                "肩は水平のまま、頭は上下しない",
                "the shoulders stay level, the head neither rises nor falls",
            ),
            &["5", "7", "13", "17"],
        ),
        fact(
            words(
                "ひざは左右交互に曲げ伸ばしする",
                "the knees bend and stretch alternately",
            ),
            &["5"],
        ),
        fact(
            words(
                "股関節の内転 15°（X線での実測）。屈曲 31°、外旋 11°",
                "hip adduction 15° (measured by radiograph); flexion 31°, external rotation 11°",
            ),
            &["20"],
        ),
        derived(words(
            "腰の移動 0.045 身長（7 cm）と傾き 9° で内転 14°になる",
            "a shift of 0.045 statures (7 cm) with a roll of 9° makes 14° of adduction",
        )),
        estimate(words(
            "浮いたかかとの高さ 3 cm",
            "height of the free heel: 3 cm",
        )),
    ],
    questions: &[
        words(
            "重みの乗った側の腰が上がるか、自由な側が上がるか（カ・レヴァ）",
            "does the hip rise on the weighted side, or on the free side (ka lewa)?",
        ),
        words(
            "かかとは浮かせるか、足裏を床につけたままか",
            "do heels rise, or do the soles stay down?",
        ),
    ],
    half: 2.0,
    answer: Answer::Repeat,
    first_count: 0.0,
    feet: [swaying(standing(LEFT)), swaying(standing(RIGHT))],
    hips: Hips::Sway {
        amplitude: SWAY,
        holds: &[],
    },
    arms: ArmPlan::Open,
    ..STILL
};
