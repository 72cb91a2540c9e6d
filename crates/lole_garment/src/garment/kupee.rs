//! Kūpeʻe: bands of leaves or ferns around wrists and ankles.
//!
//! They are worn at wrists and ankles, of ti leaf or palapalai fern. How much longer than the girth, and how
//! many leaves, are estimates.

use lole_language::words;
use lole_pattern::pattern::{Craft, NotionKind, StepFigure};
use lole_pattern::{DraftError, Measure, Pattern};

use crate::drafting::accessory::{accessory, counted, raffia};
use crate::drafting::chosen::{Chosen, choice, number};
use crate::drafting::making::{cm, say, step, whole};
use crate::drafting::shape::CM;
use crate::fitting::Fitting;
use crate::sketch::Sketch;
use crate::template::{BesideRow, Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "kupee",
    name: words("クーペエ", "kūpeʻe"),
    about: words(
        "手首と足首に巻く葉の飾り",
        "bands of leaves for wrists and ankles",
    ),
    shelf: Shelf::Adornments,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x7b5a34, 0xe2574c, 0x46803a, 0xf4d35e]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.ring([0.3, 0.5], [0.16, 0.1], [12.0, 0.04]);
    pen.ring([0.72, 0.5], [0.16, 0.1], [12.0, 0.04]);
}

const PLACES: &[Choice] = &[
    Choice {
        id: "both",
        name: words("手首と足首", "wrists and ankles"),
    },
    Choice {
        id: "wrists",
        name: words("手首", "wrists"),
    },
    Choice {
        id: "ankles",
        name: words("足首", "ankles"),
    },
];

const OPTIONS: &[OptionRow] = &[
    choice("place", PLACES, words("着ける所", "where they are worn")),
    number(
        "ease_cm",
        [0.0, 6.0],
        1.5,
        words("手首や足首より長くする分", "band over the girth"),
    ),
    number(
        "tie_cm",
        [3.0, 40.0],
        15.0,
        words("結ぶための両端", "each end, for the knot"),
    ),
    number(
        "leaves_per_cm_ratio",
        [0.2, 5.0],
        1.0,
        words("1 cm あたりの葉の数", "leaves to a centimeter"),
    ),
];

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    let (wrists, ankles) = match chosen.choice("place") {
        "wrists" => (true, false),
        "ankles" => (false, true),
        _ => (true, true),
    };
    let (ease, tie) = (chosen.m("ease_cm"), chosen.m("tie_cm"));
    let mut steps = Vec::new();
    let mut notions = Vec::new();
    for (is_worn, measure, name) in [
        (wrists, Measure::WristGirth, words("手首", "wrists")),
        (ankles, Measure::AnkleGirth, words("足首", "ankles")),
    ] {
        if !is_worn {
            continue;
        }
        measures.check(&[measure])?;
        let band = measure.of(measures).to_m() + ease;
        let base = band + 2.0 * tie;
        let leaves = whole(band / CM * chosen.number("leaves_per_cm_ratio"));
        let [band_cm, base_cm, tie_cm] = [band, base, tie].map(cm);
        let (japanese, english) = (name.japanese, name.english);
        let winding = step(
            name,
            say!(
                "{japanese}用を 2 本作ります。三つ編みの土台 {base_cm} cm に、葉 {leaves} 枚を {band_cm} cm にわたって巻き付け、両端 {tie_cm} cm を結ぶために残します。",
                "Make two for the {english}: wind {leaves} leaves onto {band_cm} cm of a braided base of {base_cm} cm and leave {tie_cm} cm at each end for the knot."
            ),
            [60.0, 60.0],
        );
        steps.push(winding.shown(StepFigure::Craft(Craft::Wili)));
        notions.push(counted(
            NotionKind::Leaf,
            words("葉またはシダ", "leaves or ferns"),
            2 * leaves,
            say!("{japanese} 2 本分", "for both {english}"),
        ));
        notions.push(raffia(2.0 * (3.0 * 1.3 * base + 4.0 * band)));
    }
    let estimate = say!("葉の数は目安です", "the number of leaves is an estimate");
    Ok(accessory(Vec::new(), notions, steps, estimate))
}

mod worn {
    //! Kūpeʻe: bands of leaves around wrists and ankles.

    use glam::Vec3;
    use lole_body::{Bone, PartKind};
    use lole_pattern::DraftError;

    use crate::GarmentSpec;
    use crate::adorn::blade::Blade;
    use crate::adorn::body::{Around, Girdle, carrier_at};
    use crate::adorn::chosen::{Chosen, whole};
    use crate::adorn::shape::Shape;
    use crate::adorn::wreath::{Wound, wind};
    use crate::adorn::{AdornmentFinish, Made, Wearer};

    /// Where the band of a wrist lies, from elbow to wrist.
    const WRIST: f32 = 0.93;
    /// Leaf of the mean woman's band [m], and radius of its base.
    const LEAF: [f32; 2] = [0.036, 0.014];
    const BASE: f32 = 0.005;
    const SKIN: &[PartKind] = &[PartKind::Skin, PartKind::Leotard];

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let dancer = wearer.dancer;
        let joint = |bone: Bone| dancer.skeleton.joint(bone);
        let size = (dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.3);
        let place = chosen.choice("place");
        let mut limbs = Vec::new();
        if place != "ankles" {
            for [elbow, wrist] in [
                [Bone::LeftLowerArm, Bone::LeftHand],
                [Bone::RightLowerArm, Bone::RightHand],
            ] {
                let way = joint(wrist) - joint(elbow);
                limbs.push((joint(elbow) + way * WRIST, way));
            }
        }
        if place != "wrists" {
            for [knee, ankle] in [
                [Bone::LeftLowerLeg, Bone::LeftFoot],
                [Bone::RightLowerLeg, Bone::RightFoot],
            ] {
                let way = joint(ankle) - joint(knee);
                let height = dancer.landmarks.ankle_tape_height;
                let share = (height - joint(knee).y) / way.y.min(-1e-3);
                limbs.push((joint(knee) + way * share.clamp(0.5, 1.0), way));
            }
        }
        let mut surfaces = Vec::new();
        for (center, way) in limbs {
            let girdle = Girdle::new(
                dancer,
                &Around {
                    center,
                    axis: way,
                    front: Vec3::Z,
                    half_height: 0.014 * size,
                    reach: 0.085 * size,
                    parts: SKIN,
                },
                48,
            );
            let cm = f64::from(girdle.length()) * 100.0 + chosen.number("ease_cm", 1.5);
            let wound = Wound {
                leaf: Blade {
                    length: LEAF[0] * size,
                    width: LEAF[1] * size,
                    fold: 0.35,
                    droop: 0.2,
                    color: chosen.leaf(),
                },
                leaf_count: 2 * whole(cm * chosen.number("leaves_per_cm_ratio", 1.0)),
                flower: Shape::default(),
                flower_count: 0,
                base: BASE * size,
            };
            let [leaves, _] = wind(&girdle, &wound);
            let carrier = carrier_at(dancer, center, 0.05 * size);
            surfaces.push(leaves.ridden(AdornmentFinish::Leaf, carrier));
        }
        Ok(Made {
            surfaces,
            ..Made::default()
        })
    }
}
