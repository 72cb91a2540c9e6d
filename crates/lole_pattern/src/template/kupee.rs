//! Kūpeʻe: bands of leaves or ferns around wrists and ankles.
//!
//! They are worn at wrists and ankles, of ti leaf or palapalai fern. How much longer than the girth, and how
//! many leaves, are estimates.

use lole_language::words;

use super::accessory::{accessory, counted, raffia};
use super::chosen::{Chosen, choice, number};
use super::making::{cm, say, step, whole};
use super::shape::CM;
use super::{Choice, OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "kupee",
    name: words("クーペエ", "kūpeʻe"),
    about: words(
        "手首と足首に巻く葉の飾り",
        "bands of leaves for wrists and ankles",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const PLACES: &[Choice] = &[
    Choice {
        id: "both",
        name: words("手首と足首", "wrists and ankles"),
    },
    Choice {
        id: "wrists",
        name: words("手首", "wrists"),
    },
    Choice {
        id: "ankles",
        name: words("足首", "ankles"),
    },
];

const OPTIONS: &[OptionRow] = &[
    choice("place", PLACES, words("着ける所", "where they are worn")),
    number(
        "ease_cm",
        [0.0, 6.0],
        1.5,
        words("手首や足首より長くする分", "band over the girth"),
    ),
    number(
        "tie_cm",
        [3.0, 40.0],
        15.0,
        words("結ぶための両端", "each end, for the knot"),
    ),
    number(
        "leaves_per_cm_ratio",
        [0.2, 5.0],
        1.0,
        words("1 cm あたりの葉の数", "leaves to a centimeter"),
    ),
];

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let (wrists, ankles) = match chosen.choice("place") {
        "wrists" => (true, false),
        "ankles" => (false, true),
        _ => (true, true),
    };
    let (ease, tie) = (chosen.m("ease_cm"), chosen.m("tie_cm"));
    let mut steps = Vec::new();
    let mut notions = Vec::new();
    for (is_worn, measure, name) in [
        (wrists, Measure::WristGirth, words("手首", "wrists")),
        (ankles, Measure::AnkleGirth, words("足首", "ankles")),
    ] {
        if !is_worn {
            continue;
        }
        measures.check(&[measure])?;
        let band = measure.of(measures).to_m() + ease;
        let base = band + 2.0 * tie;
        let leaves = whole(band / CM * chosen.number("leaves_per_cm_ratio"));
        let [band_cm, base_cm, tie_cm] = [band, base, tie].map(cm);
        let (japanese, english) = (name.japanese, name.english);
        steps.push(step(
            name,
            say!(
                "{japanese}用を 2 本作ります。三つ編みの土台 {base_cm} cm に、葉 {leaves} 枚を {band_cm} cm にわたって巻き付け、両端 {tie_cm} cm を結ぶために残します。",
                "Make two for the {english}: wind {leaves} leaves onto {band_cm} cm of a braided base of {base_cm} cm and leave {tie_cm} cm at each end for the knot."
            ),
            [60.0, 60.0],
        ));
        notions.push(counted(
            NotionKind::Leaf,
            words("葉またはシダ", "leaves or ferns"),
            2 * leaves,
            say!("{japanese} 2 本分", "for both {english}"),
        ));
        notions.push(raffia(2.0 * (3.0 * 1.3 * base + 4.0 * band)));
    }
    let estimate = say!("葉の数は目安です", "the number of leaves is an estimate");
    Ok(accessory(Vec::new(), notions, steps, estimate))
}
