//! Kāwelu: two families.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{
    Change, Curve, Dip, Hips, LEFT, MIDDLE, RIGHT, Raise, STILL, Score, Stand, Stride, Sway,
    Travel, derived, estimate, fact, land, spot, standing,
};

/// How far the free foot goes to the front and behind the other [statures].
const FRONT: f32 = 0.15;
const BEHIND: f32 = -0.05;

/// The heel of the standing foot goes up before each count and strikes on it.
const BEATS: Curve = Curve::from_zero(&[
    Change(0.3, 0.65, 1.0),
    Change(0.68, 1.0, -1.0),
    Change(1.3, 1.65, 1.0),
    Change(1.68, 2.0, -1.0),
    Change(2.3, 2.65, 1.0),
    Change(2.68, 3.0, -1.0),
]);

pub(super) const KAWELU: Score = Score {
    id: "kawelu",
    name: "kāwelu",
    title: words("カヴェル（かかと）", "heel beats"),
    about: words(
        "片足のかかとで拍を打ち、もう片足を前とうしろへ出す",
        "One heel beats time while the other foot steps forward and a little back.",
    ),
    teaching: &[
        words(
            "左のかかとを打ち、右足を前へ。低く",
            "the left heel beats, the right foot steps forward, low",
        ),
        words(
            "左のかかとを打ち、右足を少しうしろへ",
            "the left heel beats, the right foot goes a little back",
        ),
        words(
            "左のかかとを打ち、右足を前へ",
            "the left heel beats, the right foot steps forward",
        ),
        words(
            "右足を左足の横に寄せる",
            "the right foot closes beside the left",
        ),
    ],
    facts: &[
        fact(
            words(
                "つま先を床につけたまま、かかとで拍を打つ。英語ではカラカウア・ステップ",
                "the heel beats time with the toes fixed; called the Kalākaua step in English",
            ),
            &["4", "27"],
        ),
        fact(
            words(
                "前へ、重みをうしろの左足へ、残り二拍でゆっくり戻る教え方もある",
                "others step forward, take the weight back and return slowly in two counts",
            ),
            &["28"],
        ),
        estimate(words(
            "かかと 3 cm、前へ 0.15 身長、うしろへ 0.05 身長、深さ 0.02 身長",
            "heel 3 cm, 0.15 statures forward, 0.05 back, 0.02 deep",
        )),
    ],
    questions: &[words(
        "かかとは拍で上がるか、下りるか",
        "does the heel rise on the count, or strike?",
    )],
    feet: [
        standing(LEFT).raising(&[Raise {
            lift: 0.0,
            heel: 0.019,
            knee_out: 0.0,
            share: BEATS,
        }]),
        standing(RIGHT).landing(&[
            land(1.0, Stand::flat(RIGHT.by(0.0, FRONT))),
            land(2.0, Stand::flat(RIGHT.by(0.0, BEHIND))),
            land(3.0, Stand::flat(RIGHT.by(0.0, FRONT))),
            land(4.0, Stand::flat(RIGHT)),
        ]),
    ],
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.035,
            roll: 6.0,
            yaw: 2.0,
        },
        side: Curve {
            start: 1.0,
            changes: &[
                Change(0.2, 1.1, -2.0),
                Change(1.2, 2.1, 2.0),
                Change(2.2, 3.1, -2.0),
            ],
        },
    },
    dips: &[Dip {
        drop: 0.008,
        share: Curve::from_zero(&[Change(0.3, 1.0, 1.0), Change(3.0, 3.8, -1.0)]),
    }],
    sink: 0.020,
    stride: Stride {
        step: 0.0,
        more: 0.08,
    },
    arms: ArmPlan::LeadAndChest,
    ..STILL
};

pub(super) const KAWELU_ZIGZAG: Score = Score {
    id: "kawelu-zigzag",
    name: "kāwelu (zigzag)",
    title: words("カヴェル（ジグザグ）", "zigzag"),
    about: words(
        "右斜め前、右斜めうしろへと進むカホロ",
        "A kāholo that goes forward and back, zigzag.",
    ),
    teaching: &[
        words("右足を右斜め前へ", "the right foot steps forward right"),
        words("左足を寄せる", "the left foot closes"),
        words("右足を右斜めうしろへ", "the right foot steps back right"),
        words("左足を寄せてタッチ", "the left foot closes and taps"),
    ],
    facts: &[
        fact(
            words(
                "日本のカヴェル。横に進む長さはカホロと同じ",
                "kāwelu as taught in Japan; to the side it goes as far as kāholo",
            ),
            &["9", "29"],
        ),
        derived(words("前後は 0.11 身長", "0.11 statures forward and back")),
    ],
    feet: [
        standing(LEFT).landing(&[
            land(2.0, Stand::flat(spot(1.0, -1.0).by(0.0, 0.11))).closing(),
            land(4.0, Stand::tap(spot(0.0, -2.0))).closing(),
        ]),
        standing(MIDDLE).from(Stand::tap(MIDDLE)).landing(&[
            land(1.0, Stand::flat(spot(-1.0, -1.0).by(0.0, 0.11))),
            land(3.0, Stand::flat(spot(-1.0, -2.0))),
        ]),
    ],
    hips: Hips::Sway {
        amplitude: Sway {
            shift: 0.04,
            roll: 6.0,
            yaw: 2.0,
        },
        holds: &[0.5, 4.5],
    },
    travel: Travel::WithFeet,
    way: spot(0.0, -2.0),
    questions: &[words("斜めの歩幅", "how long is the diagonal step?")],
    dips: &[],
    sink: 0.018,
    stride: Stride {
        step: 1.0,
        more: 0.02,
    },
    ..KAWELU
};
