//! ʻAmi: the hips circle over standing feet; and its kinds.

use lole_language::words;

use crate::arms::ArmPlan;
use crate::score::{Answer, Change, Curve, Hips, STILL, Score, Sway, derived, estimate, fact};

/// Always the whole circle.
const WHOLE: Curve = Curve {
    start: 1.0,
    changes: &[],
};

const CIRCLE: Sway = Sway {
    shift: 0.045,
    roll: 6.0,
    yaw: 0.0,
};

const fn circle(rates: &'static [(f32, f32)], size: Curve, front: Option<f32>) -> Hips {
    Hips::Circle {
        amplitude: CIRCLE,
        depth: 0.030,
        tilt: 5.0,
        rates,
        size,
        front,
    }
}

pub(super) const AMI: Score = Score {
    id: "ami",
    name: "ʻami",
    title: words("アミ", "circle of the hips"),
    about: words(
        "足を置いたまま、腰を回す",
        "The hips draw a circle over standing feet.",
    ),
    teaching: &[
        words("左からうしろへ", "from the left to the back"),
        words("右から前へ", "from the right to the front"),
    ],
    facts: &[
        fact(
            words("足裏は床から離れない", "the soles never leave the floor"),
            &["15"],
        ),
        fact(
            words(
                "アミ・アーカウ（右）は左、うしろ、右、前。上から見て反時計回り。ヘマ（左）は逆",
                "ʻami ʻākau goes left, back, right, front: counter-clockwise from above; hema the other way",
            ),
            &["24", "25"],
        ),
        fact(
            words(
                "腰は左右でいちばん高い。ひざは開かない",
                "the hips are highest at the sides; the knees do not open",
            ),
            &["12"],
        ),
        estimate(words(
            "前には、うしろの 0.6 だけ出る",
            "to the front they reach 0.6 of what they reach to the back",
        )),
    ],
    questions: &[words(
        "どちらの拍で腰がどこにあるか",
        "where are the hips on the count?",
    )],
    half: 2.0,
    answer: Answer::Repeat,
    first_count: 0.0,
    hips: circle(&[(0.0, 0.5)], WHOLE, None),
    sink: 0.002,
    arms: ArmPlan::Rounded,
    ..STILL
};

pub(super) const AMI_KAHELA: Score = Score {
    id: "ami-kahela",
    name: "ʻami kāhela",
    title: words("アミ・カヘラ", "large slow circle"),
    about: words("大きくゆっくり回すアミ", "A large, slow ʻami."),
    teaching: &[
        words("左からうしろへ", "from the left to the back"),
        words("うしろから右へ", "from the back to the right"),
        words("右から前へ", "from the right to the front"),
        words("前から左へ", "from the front to the left"),
    ],
    facts: &[
        fact(
            words(
                "大きくゆっくり、二拍から四拍でひと回り",
                "large and slow, two to four counts a turn",
            ),
            &["3"],
        ),
        fact(
            words(
                "三回半回って逆に回ることが多い",
                "often three turns and a half, then the other way",
            ),
            &["9b"],
        ),
    ],
    half: 4.0,
    hips: circle(&[(0.0, 0.25)], WHOLE, None),
    ..AMI
};

pub(super) const AMI_KUU: Score = Score {
    id: "ami-kuu",
    name: "ʻami kuʻu",
    title: words("アミ・クウ", "large and small circles"),
    about: words(
        "大きく二回、続けて小さく速く三回まわす",
        "Two large turns and then three small fast ones.",
    ),
    teaching: &[
        words("大きく一回", "a large turn"),
        words("その終わり", "its end"),
        words("大きく二回目", "a second large turn"),
        words("その終わり", "its end"),
        words("小さく速く", "small and fast"),
        words("小さく速く", "small and fast"),
        words("小さく速く", "small and fast"),
        words(
            "小さく速く、三回で終わる",
            "small and fast: three turns in all",
        ),
    ],
    facts: &[
        fact(
            words("大きく二回、小さく三回", "two large, then three small"),
            &["3", "4"],
        ),
        fact(
            words(
                "腰だけの揺れは 1〜3 Hz に収まり、2 Hz で最も安定する（ベリーダンスの実測）",
                "oscillation of the pelvis alone keeps to 1 to 3 Hz and is steadiest at 2 Hz (measured in belly dance)",
            ),
            &["21"],
        ),
        estimate(words(
            "小さい円は半分の大きさ",
            "the small circles are half as large",
        )),
    ],
    half: 8.0,
    hips: circle(
        &[(0.0, 0.5), (4.0, 0.75)],
        Curve {
            start: 1.0,
            changes: &[Change(3.4, 4.6, -0.5), Change(7.0, 8.0, 0.5)],
        },
        None,
    ),
    ..AMI
};

pub(super) const AMI_ONIU: Score = Score {
    id: "ami-oniu",
    name: "ʻami ʻōniu",
    title: words("アミ・オニウ", "figure of eight"),
    about: words(
        "腰で横向きの八の字を描く",
        "The hips draw a figure of eight lying on its side.",
    ),
    teaching: &[
        words("左の腰を前、外へ", "the left hip forward and out"),
        words("うしろを通って戻る", "back and home"),
        words("右の腰を前、外へ", "the right hip forward and out"),
        words("うしろを通って戻る", "back and home"),
    ],
    facts: &[
        fact(
            words(
                "片方の腰を前、外、うしろ、元へ。次に反対",
                "one hip forward, out, back, home; then the other",
            ),
            &["26"],
        ),
        estimate(words(
            "ひと回り四拍、腰のひねり 12°",
            "four counts for the whole eight, the pelvis turning by 12°",
        )),
    ],
    half: 4.0,
    hips: Hips::Eight {
        amplitude: Sway {
            shift: 0.04,
            roll: 4.0,
            yaw: 12.0,
        },
        depth: 0.02,
        counts: 4.0,
    },
    ..AMI
};

pub(super) const AMI_HALF_MOON: Score = Score {
    id: "ami-half-moon",
    name: "ʻami (half-moon)",
    title: words("ハーフムーン・アミ", "half-moon"),
    about: words(
        "うしろは回り、前はまっすぐ通るアミ",
        "An ʻami that goes round the back and cuts straight across the front.",
    ),
    facts: &[
        fact(
            words(
                "うしろを回り、前を横切る",
                "round the back, straight across the front",
            ),
            &["4"],
        ),
        derived(words(
            "前には 0.003 身長より出ない",
            "it comes to the front by no more than 0.003 statures",
        )),
    ],
    hips: circle(&[(0.0, 0.5)], WHOLE, Some(0.003)),
    ..AMI
};

pub(super) const HUE: Score = Score {
    id: "hue",
    name: "hue",
    title: words("フエ（アイ・アミ）", "ʻami with the drum"),
    about: words(
        "太鼓と同じ速さで小さく回すアミ",
        "A small ʻami as fast as the drum.",
    ),
    teaching: &[
        words("小さくひと回り", "one small turn"),
        words("小さくひと回り", "one small turn"),
    ],
    facts: &[
        fact(words("太鼓に合わせて速く", "as fast as the drum"), &["3"]),
        estimate(words(
            "半径 0.0175 身長（3 cm）、2〜2.5 Hz まで",
            "radius 0.0175 statures (3 cm), up to 2 or 2.5 Hz",
        )),
    ],
    questions: &[words("一拍にひと回りでよいか", "is it one turn a count?")],
    tempo: [56.0, 150.0],
    hips: Hips::Circle {
        amplitude: Sway {
            shift: 0.0175,
            roll: 2.5,
            yaw: 0.0,
        },
        depth: 0.0117,
        tilt: 2.0,
        rates: &[(0.0, 1.0)],
        size: WHOLE,
        front: None,
    },
    sink: 0.010,
    ..AMI
};
