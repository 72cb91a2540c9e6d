//! The pāʻū top as a template: the draft of [`lole_pattern::design::pau_top`] from measures and options.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::design::pau_skirt::PauOptions;
use lole_pattern::design::pau_top::{TopMeasurements, TopOptions, draft_pau_top};
use lole_pattern::{DraftError, ElasticRatio, GatherRatio, Measure, Measures, Pattern};

use super::pau_skirt::{CASING, GAP, HEM, UNKNOWN_WIDTH};
use crate::drafting::chosen::{Chosen, by_measure, count, number};
use crate::drafting::shape::CM;
use crate::sketch::{Sketch, Tone};
use crate::template::{OptionRow, Options, Shelf, Template, Wear};

/// The pāʻū top.
pub static TEMPLATE: Template = Template {
    id: "pau-top",
    name: words("パウトップ", "pāʻū top"),
    about: words(
        "胸の上をゴムで留める筒形の上着",
        "a tube of cloth, held over the bust by elastic",
    ),
    shelf: Shelf::Tops,
    options: OPTIONS,
    draft,
    worn: Wear::OwnKeys,
    chest_room_deg: 10.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.26, 0.26], [0.74, 0.26], [0.72, 0.76], [0.28, 0.76]],
        Tone::Cloth,
    );
    pen.line(&[[0.26, 0.33], [0.74, 0.33]]);
    pen.line(&[[0.28, 0.6], [0.72, 0.6]]);
    pen.fan([0.34, 0.58], [0.18, 0.18], 6);
}

const OPTIONS: &[OptionRow] = &[
    by_measure(
        "upper_height_cm",
        [50.0, 170.0],
        words(
            "床から上のゴムまで。書かなければ胸のいちばん太いところの少し上",
            "upper elastic above the floor; left out: a little above the fullest bust",
        ),
    ),
    by_measure(
        "lower_height_cm",
        [40.0, 160.0],
        words(
            "床から下のゴムまで。書かなければ胸の下",
            "lower elastic above the floor; left out: below the bust",
        ),
    ),
    by_measure(
        "hem_height_cm",
        [30.0, 160.0],
        words(
            "床から裾まで。書かなければ腰骨の少し上",
            "hem above the floor; left out: a little above the hip bones",
        ),
    ),
    number(
        "gather_ratio",
        [1.0, 5.0],
        2.0,
        words("布の長さ÷バスト", "flat length over bust girth"),
    ),
    count(
        "upper_row_count",
        [1, 3],
        1,
        words("上のゴムの段数", "rows of elastic above the bust"),
    ),
    count(
        "lower_row_count",
        [0, 3],
        1,
        words(
            "下のゴムの段数。0 なら胸からそのまま下がる",
            "rows of elastic below it; 0: it hangs from the upper ones",
        ),
    ),
    number(
        "elastic_ratio",
        [0.8, 0.9],
        0.85,
        words(
            "縮んだゴムの長さ÷留める位置の胴回り",
            "relaxed elastic over the girth where it is worn",
        ),
    ),
    number(
        "header_cm",
        [0.0, 15.0],
        2.5,
        words(
            "いちばん上のゴムより上のフリル",
            "ruffle above the top elastic",
        ),
    ),
    number("casing_cm", [0.5, 10.0], 2.5, CASING),
    number("casing_gap_cm", [0.0, 15.0], 1.5, GAP),
    number("hem_allowance_cm", [0.0, 30.0], 2.0, HEM),
];

/// Upper elastic over the fullest bust, and the lower one under it.
const ABOVE_BUST: f64 = 1.5 * CM;
const BELOW_BUST: f64 = 8.0 * CM;
/// The usual skirt's band over the hip bones, and what is seen between both.
const OVER_HIP_BONES: f64 = 11.25 * CM;
/// Hem below the lowest elastic, at least.
const LEAST_FRILL: f64 = 6.0 * CM;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[
        Measure::BustGirth,
        Measure::BustHeight,
        Measure::HipBoneHeight,
    ])?;
    let bust = measures.bust_height.to_m();
    let upper = chosen.m_or("upper_height_cm", bust + ABOVE_BUST);
    let lower = chosen.m_or("lower_height_cm", bust - BELOW_BUST);
    let m = |key| Length::from_m(chosen.m(key));
    let lower_row_count = chosen.count("lower_row_count");
    let below = (m("casing_cm") + m("casing_gap_cm")) * f64::from(lower_row_count.max(1) - 1);
    let lowest = if lower_row_count == 0 {
        upper
    } else {
        lower - below.to_m()
    };
    let girth = |height| measures.girth_at(Length::from_m(height));
    let over_hips = measures.hip_bone_height.to_m() + OVER_HIP_BONES;
    let hem_height = chosen.m_or("hem_height_cm", over_hips.min(lowest - LEAST_FRILL));
    let top = TopMeasurements {
        bust_girth: measures.bust_girth,
        upper_girth: girth(upper).unwrap_or(measures.bust_girth),
        lowest: (
            girth(lowest).unwrap_or(measures.bust_girth),
            Length::from_m(lowest),
        ),
        trunk: (0 < lower_row_count).then(|| measures.way_up(lower, upper)),
    };
    let cut = PauOptions {
        gather_ratio: GatherRatio::new(chosen.number("gather_ratio"))?,
        hem_height: Length::from_m(hem_height),
        elastic_row_count: chosen.count("upper_row_count"),
        elastic_ratio: ElasticRatio::new(chosen.number("elastic_ratio"))?,
        header: m("header_cm"),
        casing: m("casing_cm"),
        gap: m("casing_gap_cm"),
        hem: m("hem_allowance_cm"),
        fabric_width: UNKNOWN_WIDTH,
        ..PauOptions::default()
    };
    let draft = draft_pau_top(
        &top,
        &TopOptions {
            cut,
            lower_row_count,
        },
    )?;
    Ok(draft.pattern(TEMPLATE.name))
}
