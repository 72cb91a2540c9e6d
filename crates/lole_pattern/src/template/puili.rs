//! Pūʻili: split bamboo that rustles when it is struck, held in the hand.
//!
//! Makers give 20 inches of length, 1.5 to 2 inches of diameter and a handle of 5 inches. The width of the
//! strips is an estimate.

use lole_language::words;

use super::accessory::{accessory, cord, counted};
use super::chosen::{Chosen, count, number};
use super::making::{cm, say, step, whole};
use super::{OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::{DraftError, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "puili",
    name: words("プイリ", "pūʻili"),
    about: words("先を細く裂いた竹の楽器", "sticks of split bamboo"),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    count("stick_count", [1, 2], 2, words("本数", "how many")),
    number("length_cm", [25.0, 70.0], 50.8, words("長さ", "length")),
    number(
        "diameter_cm",
        [2.0, 8.0],
        4.4,
        words("竹の太さ", "diameter of the bamboo"),
    ),
    number(
        "handle_cm",
        [8.0, 20.0],
        12.7,
        words("持ち手の長さ", "length of the handle"),
    ),
    number(
        "strip_cm",
        [0.3, 2.0],
        0.6,
        words("裂いた竹の幅", "width of a strip"),
    ),
];

/// Turns of tape around the end of a handle. Estimated.
const TAPE_TURNS: f64 = 4.0;

fn draft(_measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let sticks = chosen.count("stick_count");
    let [long, handle] = ["length_cm", "handle_cm"].map(|key| chosen.m(key));
    let around = std::f64::consts::PI * chosen.m("diameter_cm");
    let strips = whole(around / chosen.m("strip_cm"));
    let [long_cm, handle_cm, slit_cm] = [long, handle, long - handle].map(cm);
    let [wide_cm, strip_cm] = [chosen.m("diameter_cm"), chosen.m("strip_cm")].map(cm);
    let steps = vec![
        step(
            words("竹を切る", "Cut the bamboo"),
            say!(
                "太さ {wide_cm} cm の竹を {sticks} 本、節を持ち手の側に残して {long_cm} cm に切ります。",
                "Cut {sticks} pieces of {long_cm} cm from bamboo {wide_cm} cm thick, a node at the handle's end."
            ),
            [20.0, 20.0],
        ),
        step(
            words("先を裂く", "Split the end"),
            say!(
                "持ち手の {handle_cm} cm を残し、{slit_cm} cm を {strip_cm} cm ごとに {strips} 本に切り込みます。一本おきに取り除くとよく鳴ります。",
                "Leave {handle_cm} cm for the handle and slit the other {slit_cm} cm every {strip_cm} cm into {strips} strips. Every other one taken out makes it rustle."
            ),
            [90.0, 90.0],
        ),
        step(
            words("磨く", "Smooth it"),
            say!(
                "切り口を紙やすりで磨き、持ち手の端をテープで巻きます。",
                "Sand all edges and wind tape around the end of the handle."
            ),
            [30.0, 30.0],
        ),
    ];
    let tape = f64::from(sticks) * TAPE_TURNS * around;
    let notions = vec![
        counted(
            NotionKind::Bamboo,
            words("竹", "bamboo"),
            sticks,
            say!(
                "太さ {wide_cm} cm、長さ {long_cm} cm",
                "{wide_cm} cm thick, {long_cm} cm long"
            ),
        ),
        cord(words("持ち手に巻くテープ", "tape for the handles"), tape),
    ];
    let estimate = say!(
        "裂く幅は目安です。踊り手の人数分は同じ店で買うと音がそろいます",
        "the width of the strips is an estimate; bought in one shop, those of a group sound alike"
    );
    Ok(accessory(Vec::new(), notions, steps, estimate))
}
