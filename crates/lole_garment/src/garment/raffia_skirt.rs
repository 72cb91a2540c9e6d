//! The raffia skirt: folded strands, knotted or sewn onto a band with elastic.
//!
//! Makers give strands of 26 to 28 inches, each folded and knotted over the band, 100 to 200 of them for
//! an adult: two strands to a centimeter of the waist. What a strand weighs is an estimate.

use lole_language::words;
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::{DraftError, Pattern};

use super::pau_skirt::WORN_HEIGHT;
use crate::adorn::strand_skirt;
use crate::drafting::chosen::{Chosen, by_measure, number};
use crate::drafting::making::{cm, notion, pattern, say, whole};
use crate::drafting::shape::CM;
use crate::drafting::strands::{Band, Hung, STRANDS_HEM};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "raffia-skirt",
    name: words("ラフィアのスカート", "raffia skirt"),
    about: words(
        "二つ折りにしたラフィアの束をゴムの帯に付けたスカート",
        "folded strands of raffia on a band with elastic",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: strand_skirt::raffia,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0xb99a5c, 0xf2dfae, 0xd9bd82, 0xa9894e]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.strands(Tone::Rgb([240, 226, 190]), 11);
}

const OPTIONS: &[OptionRow] = &[
    by_measure("hem_height_cm", [0.0, 110.0], STRANDS_HEM),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number(
        "strands_per_cm_ratio",
        [0.5, 6.0],
        2.0,
        words(
            "帯 1 cm あたりの二つ折りの束の数",
            "folded strands to a centimeter of the band",
        ),
    ),
    number(
        "band_cm",
        [2.0, 10.0],
        3.5,
        words("帯の高さ", "height of the band"),
    ),
];

/// Mass of a meter of raffia [kg]. Estimated.
pub(crate) const MASS_PER_METER: f64 = 0.0006;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    let worn = Hung::of(measures, &chosen)?;
    let band = Band::new(&worn, chosen.m("band_cm"));
    let strand_count = whole(worn.girth / CM * chosen.number("strands_per_cm_ratio"));
    let strand = 2.0 * worn.length;
    let kilograms = f64::from(strand_count) * strand * MASS_PER_METER;
    let [strand_cm, length_cm, band_cm] = [strand, worn.length, band.length()].map(cm);
    let grams = (kilograms * 1000.0).round();
    let notions = vec![
        notion(
            NotionKind::Raffia,
            words("ラフィア", "raffia"),
            Amount::Mass(kilograms),
        ),
        band.elastic(),
    ];
    let mut steps = band.first_steps();
    steps.extend(band.last_steps(
        say!(
            "{strand_cm} cm に切ったラフィアを {strand_count} 本（約 {grams} g）用意し、二つ折りにして長さ {length_cm} cm にします。{band_cm} cm の帯の間に折り山を均等にはさみ、帯の長い端を縫い閉じます。二度縫います。",
            "Cut {strand_count} strands of {strand_cm} cm (about {grams} g) and fold each to {length_cm} cm. Lay their folds evenly into the band of {band_cm} cm and sew its long edge closed over them, twice."
        ),
        [90.0, 240.0],
    ));
    Ok(
        pattern(vec![band.piece()], Band::seams(0), notions, steps).warn(say!(
            "ラフィアの本数と重さは目安です",
            "number and weight of the strands are estimates"
        )),
    )
}
