//! The pāʻū top as a template: the draft of [`lole_pattern::design::pau_top`] from measures and options.

use lole_geom::{Length, narrow};
use lole_language::words;
use lole_pattern::design::pau_skirt::PauOptions;
use lole_pattern::design::pau_top::{TopMeasurements, TopOptions, draft_pau_top};
use lole_pattern::{DraftError, ElasticRatio, GatherRatio, Measure, Pattern};

use super::pau_skirt::{CASING, GAP, HEM, UNKNOWN_WIDTH};
use crate::drafting::chosen::{Chosen, by_measure, count, number};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{
    Fineness, Gathered, GatheredRow, OptionRow, Options, Shelf, Template, Wear, WornPlace,
};

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
    worn: Wear::Gathered(GatheredRow {
        count: |_| 1,
        draft: as_worn,
        fineness: Fineness {
            column_count: 288,
            row_count: 30,
            seed: 3,
        },
        second: None,
    }),
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
            "床から裾まで。書かなければスカートの上端のすぐ上",
            "hem above the floor; left out: just above the skirt's upper edge",
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

/// Upper elastic over the fullest bust [m]: below the arms.
const ABOVE_BUST: f32 = 0.015;
/// Lower elastic below it [m]: where the bust ends.
const BELOW_BUST: f32 = 0.08;
/// Hem over the upper edge of the skirt [m].
const ABOVE_SKIRT: f32 = 0.005;
/// The usual skirt's upper edge over the hip bones [m], where no skirt is known.
const SKIRT_EDGE: f32 = 0.1075;
/// Hem below the lowest elastic [m], at least.
const LEAST_FRILL: f32 = 0.06;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    Ok(as_worn(fitting, options)?.draft.pattern(TEMPLATE.name))
}

fn as_worn(fitting: &Fitting<'_>, options: &Options) -> Result<Gathered, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let (worn, lowest) = worn(fitting, &chosen)?;
    let usual_edge = fitting.measures.hip_bone_height.to_m_f32() + SKIRT_EDGE;
    let skirt_edge = (fitting.skirt_edge).map_or(usual_edge, Length::to_m_f32);
    let hem = (skirt_edge + ABOVE_SKIRT).min(lowest - LEAST_FRILL);
    let m = |key| Length::from_m(chosen.m(key));
    let cut = PauOptions {
        gather_ratio: GatherRatio::new(chosen.number("gather_ratio"))?,
        hem_height: Length::from_m(chosen.m_or("hem_height_cm", f64::from(hem))),
        elastic_row_count: chosen.count("upper_row_count"),
        elastic_ratio: ElasticRatio::new(chosen.number("elastic_ratio"))?,
        header: m("header_cm"),
        casing: m("casing_cm"),
        gap: m("casing_gap_cm"),
        hem: m("hem_allowance_cm"),
        fabric_width: fitting.cloth_width.unwrap_or(UNKNOWN_WIDTH),
        ..PauOptions::default()
    };
    let options = TopOptions {
        cut,
        lower_row_count: chosen.count("lower_row_count"),
    };
    Ok(Gathered {
        draft: draft_pau_top(&worn, &options)?,
        worn: worn.worn(),
        place: WornPlace::Bust,
        is_open: false,
        ruffle: None,
    })
}

/// Where it is held, and the height of its lowest elastic [m].
fn worn(fitting: &Fitting<'_>, chosen: &Chosen<'_>) -> Result<(TopMeasurements, f32), DraftError> {
    let measures = fitting.measures;
    measures.check(&[
        Measure::BustGirth,
        Measure::BustHeight,
        Measure::HipBoneHeight,
    ])?;
    let bust = measures.bust_height.to_m_f32();
    let height = |key, usual: f32| narrow(chosen.m_or(key, f64::from(usual)));
    let upper = height("upper_height_cm", bust + ABOVE_BUST);
    let lower = height("lower_height_cm", bust - BELOW_BUST);
    let lower_row_count = chosen.count("lower_row_count");
    let trunk = (0 < lower_row_count).then(|| fitting.way_up(lower, upper));
    // Further rows lie below the first.
    let rows = f64::from(lower_row_count.max(1) - 1);
    let apart = chosen.number("casing_cm") + chosen.number("casing_gap_cm");
    let below = Length::from_cm(rows * apart).to_m_f32();
    let lowest = if trunk.is_some() {
        lower - below
    } else {
        upper
    };
    let girth = |height| fitting.girth_at(height).unwrap_or(measures.bust_girth);
    let worn = TopMeasurements {
        bust_girth: measures.bust_girth,
        upper_girth: girth(upper),
        lowest: (girth(lowest), Length::from_m(f64::from(lowest))),
        trunk,
    };
    Ok((worn, lowest))
}
