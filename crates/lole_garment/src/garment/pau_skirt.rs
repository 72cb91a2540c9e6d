//! The pāʻū skirt as a template: the draft of [`lole_pattern::design::pau_skirt`] from measures and options.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::design::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};
use lole_pattern::{DraftError, ElasticRatio, GatherRatio, Measure, Pattern};

use crate::drafting::chosen::{Chosen, by_measure, count, number};
use crate::drafting::shape::CM;
use crate::fitting::Fitting;
use crate::sketch::Sketch;
use crate::template::{
    Called, Fineness, Gathered, GatheredRow, OptionRow, Options, Second, Shelf, Template, Wear,
    WornPlace,
};

/// The pāʻū skirt.
pub static TEMPLATE: Template = Template {
    id: "pau-skirt",
    name: words("パウスカート", "pāʻū skirt"),
    about: words(
        "一枚の長い布を何段ものゴムに寄せて腰ではくスカート",
        "one long piece of cloth, gathered onto rows of elastic and worn on the hips",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Gathered(GatheredRow {
        count: |_| 1,
        draft: as_worn,
        fineness: Fineness::OF_SKIRT,
        // Less cloth, and a hem that shows below the skirt's.
        second: Some(Second {
            options: &[("hem_height_cm", 14.0), ("gather_ratio", 2.5)],
            fineness: Fineness {
                column_count: 352,
                row_count: 44,
                seed: 2,
            },
            called: [
                Called {
                    id: "pau_underskirt",
                    name: words("下に重ねるパウスカート", "pāʻū underskirt"),
                },
                Called {
                    id: "pau_overskirt",
                    name: words("上に重ねるパウスカート", "pāʻū overskirt"),
                },
            ],
        }),
    }),
    chest_room_deg: 0.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.skirt(0.9);
}

const OPTIONS: &[OptionRow] = &[
    number("hem_height_cm", [0.0, 100.0], 22.0, HEM_HEIGHT),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number("gather_ratio", [1.0, 5.0], 4.0, GATHERS),
    count(
        "elastic_row_count",
        [1, 6],
        3,
        words("ゴムの段数", "rows of elastic"),
    ),
    number(
        "elastic_ratio",
        [0.8, 0.9],
        0.85,
        words(
            "縮んだゴムの長さ÷はく位置の胴回り",
            "relaxed elastic over the girth where it is worn",
        ),
    ),
    number("header_cm", [0.0, 15.0], 2.0, HEADER),
    number("casing_cm", [0.5, 10.0], 1.5, CASING),
    number("casing_gap_cm", [0.0, 15.0], 2.5, GAP),
    number("hem_allowance_cm", [0.0, 30.0], 5.0, HEM),
];

pub(crate) const HEM_HEIGHT: lole_language::Words = words("床から裾まで", "hem above the floor");
pub(crate) const WORN_HEIGHT: lole_language::Words = words(
    "床からいちばん下の段まで。書かなければ腰骨の前",
    "lowest row above the floor; left out: the front hip bones",
);
pub(crate) const GATHERS: lole_language::Words =
    words("布の長さ÷ヒップ", "flat length over hip girth");
pub(crate) const HEADER: lole_language::Words =
    words("いちばん上の段より上のフリル", "ruffle above the top row");
pub(crate) const CASING: lole_language::Words = words("ゴム通しの幅", "height of one casing");
pub(crate) const GAP: lole_language::Words = words("ゴム通しの間隔", "between two casings");
pub(crate) const HEM: lole_language::Words = words("裾上げの分", "cloth for the hem");

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let name = TEMPLATE.name_in(fitting.layer);
    Ok(as_worn(fitting, options)?.draft.pattern(name))
}

fn as_worn(fitting: &Fitting<'_>, options: &Options) -> Result<Gathered, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let worn = worn(fitting, &chosen)?;
    Ok(Gathered {
        draft: draft_pau_skirt(&worn, &cut(fitting, &chosen)?)?,
        worn,
        place: WornPlace::Hips,
        is_open: false,
        ruffle: None,
    })
}

/// Hips and the place where it is worn.
pub(crate) fn worn(
    fitting: &Fitting<'_>,
    chosen: &Chosen<'_>,
) -> Result<PauMeasurements, DraftError> {
    let measures = fitting.measures;
    measures.check(&[Measure::HipGirth, Measure::HipBoneHeight])?;
    let usual = measures.hip_bone_height.to_m();
    let worn_height = Length::from_m(chosen.m_or("worn_height_cm", usual));
    let worn_girth = fitting.girth_at(worn_height.to_m_f32());
    Ok(PauMeasurements {
        hip_girth: measures.hip_girth,
        worn_girth: worn_girth.unwrap_or(measures.hip_girth),
        worn_height,
    })
}

fn cut(fitting: &Fitting<'_>, chosen: &Chosen<'_>) -> Result<PauOptions, DraftError> {
    let m = |key| Length::from_m(chosen.m(key));
    Ok(PauOptions {
        gather_ratio: GatherRatio::new(chosen.number("gather_ratio"))?,
        hem_height: m("hem_height_cm"),
        elastic_row_count: chosen.count("elastic_row_count"),
        elastic_ratio: ElasticRatio::new(chosen.number("elastic_ratio"))?,
        header: m("header_cm"),
        casing: m("casing_cm"),
        gap: m("casing_gap_cm"),
        hem: m("hem_allowance_cm"),
        fabric_width: fitting.cloth_width.unwrap_or(UNKNOWN_WIDTH),
        ..PauOptions::default()
    })
}

/// Where the width of the cloth is not known, what lays the pieces on it warns.
pub(crate) const UNKNOWN_WIDTH: Length = Length::from_m(400.0 * CM);
