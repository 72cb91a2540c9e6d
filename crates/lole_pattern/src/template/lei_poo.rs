//! The lei poʻo: a wreath around the head.
//!
//! Makers give about 21 inches, the head's girth, worn level. Leaves and flowers to a centimeter and the
//! ends that tie it are estimates.

use lole_language::words;

use super::accessory::{accessory, counted, raffia};
use super::chosen::{Chosen, number};
use super::making::{NO_WORK, cm, say, step, whole};
use super::shape::CM;
use super::{OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "lei-poo",
    name: words("レイ・ポオ", "lei poʻo"),
    about: words(
        "頭に巻く葉と花の輪",
        "a wreath of leaves and flowers around the head",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    number(
        "tie_cm",
        [5.0, 60.0],
        25.0,
        words("後ろで結ぶための両端", "each end, for the knot at the back"),
    ),
    number(
        "flowers_per_cm_ratio",
        [0.0, 3.0],
        0.3,
        words("1 cm あたりの花の数", "flowers to a centimeter"),
    ),
    number(
        "leaves_per_cm_ratio",
        [0.2, 5.0],
        1.0,
        words(
            "1 cm あたりの葉やシダの数",
            "leaves or ferns to a centimeter",
        ),
    ),
];

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::HeadGirth])?;
    let head = measures.head_girth.to_m();
    let base = head + 2.0 * chosen.m("tie_cm");
    let flowers = whole(head / CM * chosen.number("flowers_per_cm_ratio"));
    let leaves = whole(head / CM * chosen.number("leaves_per_cm_ratio"));
    let [head_cm, base_cm, tie_cm] = [head, base, chosen.m("tie_cm")].map(cm);
    let steps = vec![
        step(
            words("土台を用意する", "Prepare the base"),
            say!(
                "ラフィアを 3 本そろえて三つ編みにし、{base_cm} cm の土台を作ります。両端 {tie_cm} cm は結ぶために空けておきます。",
                "Braid three strands of raffia to a base of {base_cm} cm. {tie_cm} cm at each end stay bare, for the knot."
            ),
            [15.0, 15.0],
        ),
        step(
            words("葉と花を巻き付ける", "Wind on leaves and flowers"),
            say!(
                "葉 {leaves} 枚と花 {flowers} 個を少しずつ重ね、別のラフィアで土台に巻き付けていきます（ウィリの編み方）。{head_cm} cm まで続けます。",
                "Lay {leaves} leaves and {flowers} flowers one over the other and wind them onto the base with another strand (wili), for {head_cm} cm."
            ),
            [90.0, 90.0],
        ),
        step(
            words("かぶる", "Put it on"),
            say!(
                "頭に水平に載せ、首の後ろで結びます。",
                "Lay it level around the head and tie it at the back."
            ),
            NO_WORK,
        ),
    ];
    let mut notions = vec![
        counted(
            NotionKind::Leaf,
            words("葉またはシダ", "leaves or ferns"),
            leaves,
            say!("パラパライ、ティの葉など", "palapalai, ti leaf and others"),
        ),
        raffia(3.0 * 1.3 * base + 4.0 * head),
    ];
    if 0 < flowers {
        notions.push(counted(
            NotionKind::Flower,
            words("花", "flowers"),
            flowers,
            say!("造花または生花", "artificial or fresh"),
        ));
    }
    let estimate = say!(
        "葉と花の数は目安です",
        "the numbers of leaves and flowers are estimates"
    );
    Ok(accessory(Vec::new(), notions, steps, estimate))
}
