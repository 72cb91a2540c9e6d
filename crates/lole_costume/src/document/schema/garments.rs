//! The keys of garments that are worn with the skirt: those that every garment has, and those of gathered
//! ones; the options of its template stand between them.

use lole_garment::{TEMPLATES, given};
use lole_language::words;

use super::tables::MAX_SEED;
use super::{Key, Kind, Table};
use crate::document::{GarmentDesign, GarmentLayer, LinkedPattern};
use crate::fabrics::{PRESETS, Preset};

/// Names of every kind of garment.
#[must_use]
pub fn kind_ids() -> Vec<&'static str> {
    let given = [&given::TEMPLATE];
    let all = TEMPLATES.iter().chain(&given);
    all.map(|template| template.id).collect()
}

/// Name of the list of garments; their parts are named after it.
pub const LIST: &str = "garment";

const LAYERS: &[(&str, GarmentLayer)] =
    &[("under", GarmentLayer::Under), ("over", GarmentLayer::Over)];

/// Tables of a garment.
pub const GARMENT: &[Table<GarmentDesign>] = &[
    Table {
        name: LIST,
        about: words(
            "スカートと着る服や小物",
            "a garment or accessory that is worn with the skirt",
        ),
        keys: &[
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
            },
            Key {
                name: "file",
                about: words(
                    "ほかのプログラムの型紙（kind = \"pattern-file\" のとき）",
                    "a pattern of another program, where kind is \"pattern-file\"",
                ),
                kind: Kind::Text {
                    what: words("ファイルの名前", "the name of a file"),
                    get: |design| design.file.as_ref().map(|file| file.name.as_str()),
                    set: |design, name| design.file = Some(LinkedPattern::named(name)),
                },
            },
        ],
    },
    Table {
        name: "fabric",
        about: words("この服の布", "what it is cut from"),
        keys: fabric_keys!(),
    },
    Table {
        name: "print",
        about: words("この服の柄", "what is printed on it"),
        keys: print_keys!(),
    },
];

/// Keys of a garment that is gathered, after its options.
pub const FINENESS: &[Key<GarmentDesign>] = fineness_keys!(fineness);
