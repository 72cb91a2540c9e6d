//! ʻUwehe: a foot is lifted and put down, then both heels snap up.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, Dip, Hips, LEFT, RIGHT, Raise, STILL, Score, Sway, estimate, fact, standing,
};

/// Both heels snap up on the second count and are down before the next lift.
const SNAP: Curve = Curve::from_zero(&[Change(0.72, 1.0, 1.0), Change(1.04, 1.36, -1.0)]);

const BOTH: Raise = Raise {
    lift: 0.0,
    heel: 0.032,
    knee_out: 30.0,
    share: SNAP,
};

const fn lifted(share: Curve) -> Raise {
    Raise {
        lift: 0.030,
        heel: 0.022,
        knee_out: 0.0,
        share,
    }
}

pub(super) const UWEHE: Score = Score {
    id: "uwehe",
    name: "ʻuwehe",
    title: words("ウエヘ", "lift and snap"),
    about: words(
        "片足を上げて下ろし、両かかとをはね上げてひざを開く",
        "A foot is lifted and put down, then both heels snap up and the knees open.",
    ),
    teaching: &[
        words(
            "右足を上げ、左足に重み",
            "the right foot is up, weight on the left",
        ),
        words(
            "右足を下ろし、両かかとを上げる",
            "the right foot is down, both heels snap up",
        ),
    ],
    facts: &[
        fact(
            words(
                "両かかとを上げ、ひざを前と外へ押し出す",
                "both heels rise and push the knees forward and out",
            ),
            &["3", "4", "11", "12", "13", "23"],
        ),
        estimate(words(
            "かかとは 0.15〜0.2 秒で 5 cm 上がる",
            "the heels rise by 5 cm in 0.15 to 0.2 s",
        )),
        estimate(words("ひざは外へ 30°開く", "the knees open by 30°")),
    ],
    questions: &[
        words("ひざをどこまで開くか", "how far do the knees open?"),
        words("かかとは一度か二度か", "do the heels rise once or twice?"),
    ],
    half: 2.0,
    first_count: 0.0,
    feet: [
        standing(LEFT).raising(&[BOTH, lifted(Curve::from_zero(&[Change(1.55, 2.0, 1.0)]))]),
        standing(RIGHT).raising(&[
            BOTH,
            lifted(Curve {
                start: 1.0,
                changes: &[Change(0.04, 0.45, -1.0)],
            }),
        ]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.032,
            roll: 6.0,
            yaw: 0.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[Change(0.1, 0.8, -1.0), Change(1.2, 2.0, -1.0)],
        },
    },
    dips: &[Dip {
        drop: 0.0015,
        share: SNAP,
    }],
    arms: ArmPlan::HighAndLow,
    ..STILL
};
