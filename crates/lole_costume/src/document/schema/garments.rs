//! The keys of garments that are worn with the skirt, by kind: a row of [`KINDS`] for each.

use lole_garment::TEMPLATES;
use lole_language::{Words, words};

use super::tables::MAX_SEED;
use super::{Key, Kind, Table};
use crate::document::{GarmentDesign, GarmentLayer, WornSkirt, WornTemplate, WornTop};
use crate::fabrics::{PRESETS, Preset};

/// A kind of garment that is danced.
#[derive(Debug)]
pub struct GarmentKind {
    /// Name in documents.
    pub id: &'static str,
    /// What it is, in a few words, written as a comment above it.
    pub about: Words,
    /// One as the program would make it.
    pub make: fn() -> GarmentDesign,
}

/// Every kind of garment that is danced.
pub const KINDS: &[GarmentKind] = &[
    GarmentKind {
        id: "pau-skirt",
        about: words("重ねるパウスカート", "a pāʻū skirt worn with the other"),
        make: || GarmentDesign::PauSkirt(WornSkirt::default()),
    },
    GarmentKind {
        id: "pau-top",
        about: words(
            "パウトップ（胸をゴムで留める筒）",
            "a pāʻū top: a tube held over the bust by elastic",
        ),
        make: || GarmentDesign::PauTop(WornTop::default()),
    },
];

/// Names of every kind of garment: those that are danced, then the templates that are only drafted.
#[must_use]
pub fn kind_ids() -> Vec<&'static str> {
    let mut ids: Vec<_> = KINDS.iter().map(|kind| kind.id).collect();
    for template in TEMPLATES {
        if !ids.contains(&template.id) {
            ids.push(template.id);
        }
    }
    ids
}

/// Name of the list of garments; their parts are named after it.
pub const LIST: &str = "garment";

const LAYERS: &[(&str, GarmentLayer)] =
    &[("under", GarmentLayer::Under), ("over", GarmentLayer::Over)];

const FABRIC: Words = words("この服の布", "what it is cut from");
const PRINT: Words = words("この服の柄", "what is printed on it");

macro_rules! layer {
    () => {
        Key {
            name: "layer",
            about: words(
                "スカートの下（under）か上（over）か。並べた順に体から外へ重なる",
                "under the skirt or over it; garments of a layer lie in their order, from the skin outward",
            ),
            kind: Kind::Name {
                what: words("重ねる場所", "layer"),
                choices: || LAYERS.iter().map(|(id, _)| *id).collect(),
                get: |design| {
                    let found = LAYERS.iter().find(|(_, layer)| *layer == design.layer);
                    found.map_or(LAYERS[0].0, |(id, _)| id)
                },
                set: |design, name| {
                    if let Some((_, layer)) = LAYERS.iter().find(|(id, _)| *id == name) {
                        design.layer = *layer;
                    }
                },
            },
        }
    };
}

/// Tables of a skirt that is worn with the other.
pub const WORN_SKIRT: &[Table<WornSkirt>] = &[
    Table {
        name: LIST,
        about: KINDS[0].about,
        keys: skirt_keys!(layer!()),
    },
    Table {
        name: "fabric",
        about: FABRIC,
        keys: fabric_keys!(),
    },
    Table {
        name: "print",
        about: PRINT,
        keys: print_keys!(),
    },
];

/// Tables of a top.
pub const WORN_TOP: &[Table<WornTop>] = &[
    Table {
        name: LIST,
        about: KINDS[1].about,
        keys: &[
            layer!(),
            number_if_known!(
                "upper_height_cm",
                60.0..=170.0,
                top.upper_height_cm,
                "床から上のゴムまで。書かなければ胸のいちばん太いところの少し上",
                "upper elastic above the floor; left out: a little above the fullest bust"
            ),
            number_if_known!(
                "lower_height_cm",
                50.0..=160.0,
                top.lower_height_cm,
                "床から下のゴムまで。書かなければ胸の下",
                "lower elastic above the floor; left out: below the bust"
            ),
            number_if_known!(
                "hem_height_cm",
                30.0..=160.0,
                top.hem_height_cm,
                "床から裾まで。書かなければスカートの上端のすぐ上",
                "hem above the floor; left out: just above the skirt's upper edge"
            ),
            number!(
                "gather_ratio",
                1.0..=5.0,
                top.gather_ratio,
                "布の長さ÷バスト",
                "flat length over bust girth"
            ),
            count!(
                "upper_row_count",
                1..=3,
                top.upper_row_count,
                "上のゴムの段数",
                "rows of elastic above the bust"
            ),
            count!(
                "lower_row_count",
                0..=3,
                top.lower_row_count,
                "下のゴムの段数。0 なら胸からそのまま下がる",
                "rows of elastic below it; 0: it hangs from the upper ones"
            ),
            number!(
                "elastic_ratio",
                0.8..=0.9,
                top.elastic_ratio,
                "縮んだゴムの長さ÷留める位置の胴回り",
                "relaxed elastic over the girth where it is worn"
            ),
            number!(
                "header_cm",
                0.0..=15.0,
                top.header_cm,
                "いちばん上のゴムより上のフリル",
                "ruffle above the top elastic"
            ),
            number!(
                "casing_cm",
                0.5..=10.0,
                top.casing_cm,
                "ゴム通しの幅",
                "height of one casing"
            ),
            number!(
                "casing_gap_cm",
                0.0..=15.0,
                top.casing_gap_cm,
                "ゴム通しの間隔",
                "between two casings"
            ),
            number!(
                "hem_allowance_cm",
                0.0..=30.0,
                top.hem_allowance_cm,
                "裾上げの分",
                "cloth for the hem"
            ),
            count!(
                "column_count",
                32..=4096,
                top.column_count,
                "横まわりの質点の数",
                "particles around"
            ),
            count!(
                "row_count",
                8..=512,
                top.row_count,
                "上から裾までの質点の数",
                "particles from top to hem"
            ),
            seed!(top, "ギャザーの寄り方（乱数の種）", "chance of the gathers"),
        ],
    },
    Table {
        name: "fabric",
        about: FABRIC,
        keys: fabric_keys!(),
    },
    Table {
        name: "print",
        about: PRINT,
        keys: print_keys!(),
    },
];

/// Tables of a garment of the table of templates, whose options stand in the first one after its keys.
pub const WORN_TEMPLATE: &[Table<WornTemplate>] = &[
    Table {
        name: LIST,
        about: words(
            "型紙だけを作る服や小物",
            "a garment or accessory that is drafted for sewing",
        ),
        keys: &[layer!()],
    },
    Table {
        name: "fabric",
        about: FABRIC,
        keys: fabric_keys!(),
    },
    Table {
        name: "print",
        about: PRINT,
        keys: print_keys!(),
    },
];
