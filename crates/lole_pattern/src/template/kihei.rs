//! The kīhei: a rectangle that is worn over one shoulder and knotted there.
//!
//! Dictionaries say what it is; no source gives its size. 1.04 by 1.8 m for a dancer of 158 cm is an
//! estimate, follows the stature, and is no wider than can be cut from cloth of 110 cm.

use lole_language::words;

use super::chosen::{Chosen, by_measure, number};
use super::making::{NO_WORK, cm, edges_of, folds, hem_in_section, pattern, say, step};
use super::shape::{AROUND, CM, Label, rectangle};
use super::work::{Work, minutes};
use super::{OptionRow, Options, Template};
use crate::piece::{CutCount, Finish};
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "kihei",
    name: words("キーヘイ", "kīhei"),
    about: words(
        "片方の肩に掛けて結ぶ一枚の布",
        "one cloth, worn over one shoulder and knotted there",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    by_measure(
        "length_cm",
        [60.0, 300.0],
        words(
            "布の長さ。書かなければ身長の 1.14 倍",
            "length of the cloth; left out: 1.14 times the stature",
        ),
    ),
    by_measure(
        "height_cm",
        [40.0, 200.0],
        words(
            "できあがりの幅。書かなければ身長の 0.66 倍で、104 cm まで",
            "finished height; left out: 0.66 times the stature, at most 104 cm",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 10.0],
        2.0,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// Length and height over the stature: 1.8 and 1.04 m at 158 cm.
const OVER_STATURE: [f64; 2] = [1.14, 0.66];
/// Highest that is cut from cloth of 110 cm, its hems and selvages left.
const HIGHEST: f64 = 104.0 * CM;
/// From the corner to the knot, along the upper edge [m].
const KNOT: f64 = 25.0 * CM;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::Stature])?;
    let [length, height] = OVER_STATURE.map(|share| share * measures.stature.to_m());
    let (length, height) = (
        chosen.m_or("length_cm", length),
        chosen.m_or("height_cm", height.min(HIGHEST)),
    );
    let hem = chosen.m("hem_allowance_cm");
    let sides = ["hem", "left_end", "top", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("cloth", words("布", "cloth"), CutCount::Alike(1));
    let piece = rectangle(label, [length, height], sides, AROUND);
    let [cut_length, cut_height] = [length, height].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let knot_cm = cm(KNOT);
    let steps = vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {cut_length} cm、幅の方向に {cut_height} cm の長方形を裁ちます。",
                "Cut a rectangle of {cut_length} cm along the selvage and {cut_height} cm across it."
            ),
            [10.0, 10.0],
        )
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("四辺を始末する", "Hem all four sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch."
            ),
            minutes(&[(Work::Hem, 2.0 * (length + height))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("着る", "Put it on"),
            say!(
                "布を背中に当て、上の二つの角を、角から {knot_cm} cm のところで片方の肩の上に結びます。反対の腕は出しておきます。",
                "Lay the cloth across the back and knot the two upper corners on one shoulder, {knot_cm} cm from each corner. The other arm stays free."
            ),
            NO_WORK,
        ),
    ];
    Ok(
        pattern(vec![piece], Vec::new(), Vec::new(), steps).warn(say!(
            "キーヘイの大きさは目安です。クムの決まりに合わせてください",
            "the size of the kīhei is an estimate; the rule of your kumu comes first"
        )),
    )
}
