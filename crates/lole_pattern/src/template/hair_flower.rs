//! The hair flower: a hibiscus of cloth petals on a pin.
//!
//! Hibiscus has five petals; their size, a hand's breadth across the flower, is an estimate and an option.

use kurbo::Vec2;
use lole_language::words;

use super::accessory::{accessory, counted};
use super::chosen::{Chosen, choice, count, number};
use super::making::{cm, edges_of, say, step, stitching};
use super::shape::{CM, DOWN, Label, at, curve, edge, line};
use super::{Choice, OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::piece::{CutCount, Finish, LineKind, Piece};
use crate::{DraftError, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "hair-flower",
    name: words("髪飾りの花", "hair flower"),
    about: words(
        "布の花びらで作るハイビスカスの髪飾り",
        "a hibiscus of cloth petals for the hair",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    number(
        "diameter_cm",
        [4.0, 25.0],
        12.0,
        words("花の直径", "across the flower"),
    ),
    count("petal_count", [3, 12], 5, words("花びらの枚数", "petals")),
    count("flower_count", [1, 5], 1, words("花の数", "flowers")),
    choice(
        "side",
        SIDES,
        words("着ける側（その人から見て）", "side of the head, hers"),
    ),
];

const SIDES: &[Choice] = &[
    Choice {
        id: "left",
        name: words("左", "left"),
    },
    Choice {
        id: "right",
        name: words("右", "right"),
    },
];

/// Length of a petal over the flower's radius: the middle is drawn together.
const PETAL: f64 = 1.15;
/// Width of a petal over its length, and of its foot.
const WIDE: f64 = 0.86;
const FOOT: f64 = 0.30;

fn draft(_measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let long = 0.5 * chosen.m("diameter_cm") * PETAL;
    let [petals, flowers] = ["petal_count", "flower_count"].map(|key| chosen.count(key));
    let all = petals * flowers;
    let piece = petal(long, all);
    // What is cut, the foot's allowance included.
    let bounds = piece.cut_polygon(1e-4).bounds();
    let [long_cm, wide_cm] = [bounds.height(), bounds.width()].map(cm);
    let steps = vec![
        step(
            words("花びらを裁つ", "Cut the petals"),
            say!(
                "長さ {long_cm} cm、幅 {wide_cm} cm の花びらを {all} 枚裁ち、端にほつれ止めを塗ります。",
                "Cut {all} petals of {long_cm} by {wide_cm} cm and seal their edges against fraying."
            ),
            [20.0, 20.0],
        )
        .shown(edges_of(0, &[0, 1])),
        step(
            words("花びらを寄せる", "Gather the petals"),
            say!(
                "花びら {petals} 枚の根元を少しずつ重ねて並べ、続けてぐし縫いし、引き絞って輪にします。",
                "Lay the feet of {petals} petals over each other in a row, run a thread through all of them and draw them to a ring."
            ),
            stitching(f64::from(all) * FOOT * long),
        )
        .shown(edges_of(0, &[0])),
        step(
            words("仕上げる", "Finish"),
            say!(
                "中心にしべを付け、裏に丸い布を当ててヘアピンを縫い付けます。",
                "Set a pistil in the middle, cover the back with a round of cloth and sew a hair pin to it."
            ),
            [20.0, 20.0],
        ),
    ];
    let notions = vec![
        counted(
            NotionKind::HairPin,
            words("ヘアピンまたはクリップ", "hair pin or clip"),
            flowers,
            say!("花 1 つに 1 本", "one for each flower"),
        ),
        counted(
            NotionKind::Pistil,
            words("しべ（ペップ）", "pistil"),
            flowers,
            say!("花 1 つに 1 本", "one for each flower"),
        ),
    ];
    let estimate = say!(
        "花の大きさは目安です",
        "the size of the flower is an estimate"
    );
    Ok(accessory(vec![piece], notions, steps, estimate))
}

/// A petal, its foot below, its rim round with a shallow notch.
fn petal(long: f64, count: u32) -> Piece {
    let half = 0.5 * WIDE * long;
    let foot = 0.5 * FOOT * long;
    let [left_foot, right_foot] = [at(-foot, 0.0), at(foot, 0.0)];
    let widest = 0.66 * long;
    let (right, left) = (at(half, widest), at(-half, widest));
    let dip = at(0.0, 0.965 * long);
    let up = Vec2::new(0.0, 1.0);
    let side = |sign: f64| Vec2::new(sign * 0.45 * half, 0.5 * widest);
    let rim = vec![
        curve(right_foot, side(1.0) * 0.8, up * (0.35 * widest), right),
        curve(
            right,
            up * (0.62 * (long - widest)),
            Vec2::new(-0.55 * half, -0.06 * long),
            dip,
        ),
        curve(
            dip,
            Vec2::new(-0.55 * half, 0.06 * long),
            -up * (0.62 * (long - widest)),
            left,
        ),
        curve(left, -up * (0.35 * widest), -side(-1.0) * 0.8, left_foot),
    ];
    let foot_edge = edge(
        "foot",
        vec![line(left_foot, right_foot)],
        Finish::Raw,
        0.8 * CM,
    );
    let gathers = super::shape::across(LineKind::Gather, 0.0, [-foot, foot]);
    let label = Label::main("petal", words("花びら", "petal"), CutCount::Alike(count));
    let rim = edge("rim", rim, Finish::Raw, 0.0);
    label.piece(vec![foot_edge, rim], DOWN, vec![gathers])
}
