//! The kīkepa: a rectangle that is wrapped around the body under the arms and tied over one shoulder.
//!
//! Newspapers of Honolulu describe 36 to 45 inches by about two yards; shops sell blanks of 60 by 68
//! inches. That it goes one and a half times around and leaves a forearm's length for the knot gives
//! two yards to a girth of 91 cm: derived.

use lole_geom::Length;
use lole_language::words;

use super::chosen::{Chosen, by_measure, number};
use super::making::{NO_WORK, cm, edges_of, folds, hem_in_section, pattern, say, step};
use super::pau_skirt::HEM_HEIGHT;
use super::shape::{AROUND, CM, Label, rectangle};
use super::work::{Work, minutes};
use super::{OptionRow, Options, Template};
use crate::piece::{CutCount, Finish};
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "kikepa",
    name: words("キーケパ", "kīkepa"),
    about: words(
        "脇の下で巻き、片方の肩で結ぶ一枚の布",
        "one cloth, wrapped under the arms and tied over one shoulder",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    number("hem_height_cm", [0.0, 100.0], 30.0, HEM_HEIGHT),
    number(
        "wrap_ratio",
        [1.1, 3.0],
        1.5,
        words(
            "巻く長さ÷いちばん太い胴回り",
            "length that is wrapped over the widest girth",
        ),
    ),
    number(
        "tie_cm",
        [10.0, 120.0],
        45.0,
        words("肩で結ぶための長さ", "length for the knot on the shoulder"),
    ),
    by_measure(
        "height_cm",
        [40.0, 160.0],
        words(
            "できあがりの幅。書かなければ脇の下から裾まで",
            "finished height; left out: from the armpits to the hem",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 10.0],
        2.0,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// Over the armpits, so that the upper edge covers the bust [m].
const OVER_ARMPITS: f64 = 3.0 * CM;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::BustGirth, Measure::HipGirth, Measure::ArmpitHeight])?;
    let widest = measures.bust_girth.to_m().max(measures.hip_girth.to_m());
    let hem_height = chosen.m("hem_height_cm");
    let height = chosen.m_or(
        "height_cm",
        measures.armpit_height.to_m() + OVER_ARMPITS - hem_height,
    );
    least_height(height, measures)?;
    let width = widest * chosen.number("wrap_ratio") + chosen.m("tie_cm");
    let hem = chosen.m("hem_allowance_cm");
    let sides = ["hem", "left_end", "top", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("cloth", words("布", "cloth"), CutCount::Alike(1));
    let piece = rectangle(label, [width, height], sides, AROUND);
    let [cut_width, cut_height] = [width, height].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let [tie_cm, girth_cm] = [chosen.m("tie_cm"), widest].map(cm);
    let steps = vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {cut_width} cm、幅の方向に {cut_height} cm の長方形を裁ちます。",
                "Cut a rectangle of {cut_width} cm along the selvage and {cut_height} cm across it."
            ),
            [10.0, 10.0],
        )
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("四辺を始末する", "Hem all four sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。耳はそのままでもかまいません。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch. A selvage may stay as it is."
            ),
            minutes(&[(Work::Hem, 2.0 * (width + height))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("着る", "Put it on"),
            say!(
                "上の端を脇の下に当て、{girth_cm} cm の胴を一周半巻きます。角の {tie_cm} cm を左の肩の上へ回し、後ろの端と結びます。",
                "Hold the upper edge under the arms and wrap it one and a half times around {girth_cm} cm. Bring the last {tie_cm} cm over the left shoulder and tie it to the edge at the back."
            ),
            NO_WORK,
        ),
    ];
    Ok(
        pattern(vec![piece], Vec::new(), Vec::new(), steps).warn(say!(
            "巻き方と大きさは目安です。クムの決まりに合わせてください",
            "size and way of wrapping are estimates; the rule of your kumu comes first"
        )),
    )
}

/// The cloth must reach from the hem over the bust.
fn least_height(height: f64, measures: &Measures) -> Result<(), DraftError> {
    const LEAST_CM: f64 = 30.0;
    if LEAST_CM * CM <= height {
        return Ok(());
    }
    Err(DraftError::TooShort {
        hem_cm: (measures.armpit_height + Length::from_m(OVER_ARMPITS - height)).to_cm(),
        finished_cm: height / CM,
        band_cm: LEAST_CM,
    })
}
