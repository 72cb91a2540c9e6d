//! The cellophane skirt: strips of film in layers, sewn to a band with elastic.
//!
//! No source gives its sizes: strips of 8 mm in two layers, cut from film of 25 to 40 µm, are estimates.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::{DraftError, Pattern};

use super::pau_skirt::WORN_HEIGHT;
use crate::adorn::strand_skirt;
use crate::drafting::chosen::{Chosen, by_measure, count, number};
use crate::drafting::making::{cm, notion, pattern, say, whole};
use crate::drafting::strands::{Band, Hung, STRANDS_HEM};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "cellophane-skirt",
    name: words("セロファンのスカート", "cellophane skirt"),
    about: words(
        "細く裂いたフィルムを重ねてゴムの帯に付けたスカート",
        "strips of film in layers on a band with elastic",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: strand_skirt::cellophane,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x8c1d3a, 0xf4d9e0, 0xc92a55, 0x6e1030]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.strands(Tone::Rgb([214, 230, 240]), 9);
}

const OPTIONS: &[OptionRow] = &[
    by_measure("hem_height_cm", [0.0, 110.0], STRANDS_HEM),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number(
        "strip_cm",
        [0.3, 3.0],
        0.8,
        words("細片の幅", "width of a strip"),
    ),
    count(
        "layer_count",
        [1, 4],
        2,
        words("重ねる枚数", "layers of film"),
    ),
    number(
        "film_width_cm",
        [20.0, 200.0],
        50.0,
        words("フィルムのロールの幅", "width of the roll of film"),
    ),
    number(
        "band_cm",
        [2.0, 10.0],
        3.5,
        words("帯の高さ", "height of the band"),
    ),
];

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    let worn = Hung::of(measures, &chosen)?;
    let height = chosen.m("band_cm");
    let band = Band::new(&worn, height);
    let layer_count = chosen.count("layer_count");
    // Film is laid flat around the stretched band, and reaches into it.
    let sheet = worn.length + height * 0.5;
    let film = chosen.m("film_width_cm");
    let sheets = whole(band.length() * f64::from(layer_count) / film);
    let strip_count = whole(band.length() * f64::from(layer_count) / chosen.m("strip_cm"));
    let [sheet_cm, film_cm, strip_cm, band_cm, left_cm] =
        [sheet, film, chosen.m("strip_cm"), band.length(), height].map(cm);
    let notions = vec![
        notion(
            NotionKind::Film,
            words("セロファンまたは OPP フィルム", "cellophane or OPP film"),
            Amount::Length(Length::from_m(f64::from(sheets) * sheet)),
        ),
        band.elastic(),
    ];
    let mut steps = band.first_steps();
    steps.extend(band.last_steps(
        say!(
            "幅 {film_cm} cm のフィルムを {sheet_cm} cm ずつ {sheets} 枚切り、{layer_count} 枚重ねて {band_cm} cm の帯にはさんで二度縫います。上を {left_cm} cm 残して {strip_cm} cm ごとに裂き、{strip_count} 本ほどの細片にします。",
            "Cut {sheets} sheets of {sheet_cm} cm from film of {film_cm} cm, lay them {layer_count} deep into the band of {band_cm} cm and sew twice. Leave {left_cm} cm at the top and cut it into strips every {strip_cm} cm, about {strip_count} in all."
        ),
        [120.0, 180.0],
    ));
    Ok(
        pattern(vec![band.piece()], Band::seams(0), notions, steps).warn(say!(
            "セロファンのスカートの寸法は、すべて目安です",
            "all sizes of the cellophane skirt are estimates"
        )),
    )
}
