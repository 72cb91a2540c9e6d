//! The ti-leaf skirt: leaves that are slit along their midribs and braided onto a cord.
//!
//! Makers count about 100 large leaves for an adult, 12 to 24 inches long and 2 to 4 wide; the midrib is
//! slit from 4 inches above the stem; the upper cord is a braid of three, the waist and 10 inches long,
//! the lower cord twice that, an inch below. A leaf to 0.9 cm of girth gives their 100 leaves: derived.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{Amount, Craft, Notion, NotionKind, StepFigure};
use lole_pattern::{DraftError, Pattern};

use super::pau_skirt::WORN_HEIGHT;
use crate::adorn::strand_skirt;
use crate::drafting::chosen::{Chosen, by_measure, number};
use crate::drafting::making::{NO_WORK, cm, notion, pattern, say, step, whole};
use crate::drafting::shape::CM;
use crate::drafting::strands::{Hung, STRANDS_HEM};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "ti-leaf-skirt",
    name: words("ティーリーフのスカート", "ti-leaf skirt"),
    about: words(
        "ティの葉を裂いてひもに編み付けたスカート",
        "slit ti leaves, braided onto a cord",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: strand_skirt::ti_leaf,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x8a7a4c, 0xf6e7c8, 0x3e7a2c, 0x2c5a20]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.strands(Tone::Leaf, 8);
}

const OPTIONS: &[OptionRow] = &[
    by_measure("hem_height_cm", [0.0, 110.0], STRANDS_HEM),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number(
        "leaf_spacing_cm",
        [0.3, 4.0],
        0.9,
        words("葉 1 枚あたりの胴回り", "girth for one leaf"),
    ),
    number(
        "tie_cm",
        [5.0, 100.0],
        25.4,
        words(
            "結ぶために足すひもの長さ",
            "cord beyond the girth, for the knot",
        ),
    ),
];

/// The stem is left whole for this length [m].
const WHOLE_STEM: f64 = 10.0 * CM;
/// The lower cord lies this far below the upper one [m].
const CORD_GAP: f64 = 2.54 * CM;
/// Longest leaves that are found [m].
const LONGEST_LEAF: f64 = 76.0 * CM;

/// So many leaves, and cord for a braid of this length and for the lower cord [m].
fn leaves_and_cord(leaf_count: u32, upper: f64) -> Vec<Notion> {
    vec![
        notion(
            NotionKind::Leaf,
            words("ティの葉（大きいもの）", "large ti leaves"),
            Amount::Count(leaf_count),
        ),
        notion(
            NotionKind::Cord,
            words(
                "ひも（三つ編みと下のひも）",
                "cord, for the braid and the lower cord",
            ),
            Amount::Length(Length::from_m(upper * (3.0 * BRAID_TAKE_UP + 2.0))),
        ),
    ]
}

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    let worn = Hung::of(measures, &chosen)?;
    let leaf_count = whole(worn.girth / chosen.m("leaf_spacing_cm"));
    let upper = worn.girth + chosen.m("tie_cm");
    let [girth_cm, upper_cm, braid_cm, lower_cm] =
        [worn.girth, upper, 3.0 * upper * BRAID_TAKE_UP, 2.0 * upper].map(cm);
    let [stem_cm, gap_cm, length_cm] = [WHOLE_STEM, CORD_GAP, worn.length].map(cm);
    let notions = leaves_and_cord(leaf_count, upper);
    let steps = vec![
        step(
            words("葉をそろえる", "Choose the leaves"),
            say!(
                "長さ {length_cm} cm くらいの葉を {leaf_count} 枚そろえ、洗って乾かないようにしておきます。",
                "Choose {leaf_count} leaves of about {length_cm} cm, wash them and keep them moist."
            ),
            [60.0, 60.0],
        ),
        step(
            words("葉を裂く", "Slit the leaves"),
            say!(
                "茎から {stem_cm} cm 上で葉の裏の芯に切れ目を入れ、先の方の芯を引いて取ります。",
                "Slit the midrib on the back {stem_cm} cm above the stem and pull it off towards the tip."
            ),
            [100.0, 100.0],
        )
        .shown(StepFigure::Craft(Craft::SlitLeaf(Length::from_m(WHOLE_STEM)))),
        step(
            words("上のひもを編む", "Braid the upper cord"),
            say!(
                "{braid_cm} cm のひもを 3 等分して三つ編みにし、{upper_cm} cm の帯を作ります。",
                "Braid three equal lengths out of {braid_cm} cm of cord to a belt of {upper_cm} cm."
            ),
            [30.0, 30.0],
        )
        .shown(StepFigure::Craft(Craft::Braid)),
        step(
            words("葉を編み付ける", "Fasten the leaves"),
            say!(
                "葉の茎を三つ編みに掛け、{gap_cm} cm 下で {lower_cm} cm の下のひもを 1 枚ずつからめて留めます。胴回り {girth_cm} cm に {leaf_count} 枚並べます。",
                "Hang each stem over the braid and bind it {gap_cm} cm below with the lower cord of {lower_cm} cm. Set {leaf_count} leaves over {girth_cm} cm."
            ),
            [240.0, 240.0],
        )
        .shown(StepFigure::Craft(Craft::LeavesOnCord(Length::from_m(CORD_GAP)))),
        step(
            words("しまう", "Keep it"),
            say!(
                "使うまで湿らせた新聞紙に包み、冷凍庫か冷蔵庫に入れておきます。",
                "Until it is worn keep it in damp paper, frozen or cold."
            ),
            NO_WORK,
        ),
    ];
    let mut pattern = pattern(Vec::new(), Vec::new(), notions, steps).warn(say!(
        "葉の枚数は目安です。大人でおよそ 50～100 枚と言われています",
        "the number of leaves is an estimate; makers give 50 to 100 for an adult"
    ));
    if LONGEST_LEAF < worn.length {
        let longest_cm = cm(LONGEST_LEAF);
        pattern = pattern.warn(say!(
            "丈が {length_cm} cm ですが、ティの葉は長くて {longest_cm} cm です。裾を上げるか、低い位置で着てください",
            "the skirt is {length_cm} cm long and ti leaves grow to {longest_cm} cm; raise the hem or wear it lower"
        ));
    }
    Ok(pattern)
}

/// Cord that a braid of three takes up over its own length. Estimated.
const BRAID_TAKE_UP: f64 = 1.3;
