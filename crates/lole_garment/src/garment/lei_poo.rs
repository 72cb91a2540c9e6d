//! The lei poʻo: a wreath around the head.
//!
//! Makers give about 21 inches, the head's girth, worn level. Leaves and flowers to a centimeter and the
//! ends that tie it are estimates.

use lole_language::words;
use lole_pattern::pattern::{Craft, NotionKind, StepFigure};
use lole_pattern::{DraftError, Measure, Pattern};

use crate::drafting::accessory::{accessory, counted, raffia};
use crate::drafting::chosen::{Chosen, number};
use crate::drafting::making::{NO_WORK, cm, say, sewn, step, whole};
use crate::drafting::shape::CM;
use crate::fitting::Fitting;
use crate::sketch::Sketch;
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "lei-poo",
    name: words("レイ・ポオ", "lei poʻo"),
    about: words(
        "頭に巻く葉と花の輪",
        "a wreath of leaves and flowers around the head",
    ),
    shelf: Shelf::Adornments,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| true,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x7b5a34, 0xe2574c, 0x46803a, 0xf4d35e]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.ring([0.5, 0.5], [0.36, 0.17], [18.0, 0.06]);
}

const OPTIONS: &[OptionRow] = &[
    number(
        "tie_cm",
        [5.0, 60.0],
        25.0,
        words("後ろで結ぶための両端", "each end, for the knot at the back"),
    ),
    number(
        "flowers_per_cm_ratio",
        [0.0, 3.0],
        0.3,
        words("1 cm あたりの花の数", "flowers to a centimeter"),
    ),
    number(
        "leaves_per_cm_ratio",
        [0.2, 5.0],
        1.0,
        words(
            "1 cm あたりの葉やシダの数",
            "leaves or ferns to a centimeter",
        ),
    ),
];

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::HeadGirth])?;
    let head = measures.head_girth.to_m();
    let base = head + 2.0 * chosen.m("tie_cm");
    let flowers = whole(head / CM * chosen.number("flowers_per_cm_ratio"));
    let leaves = whole(head / CM * chosen.number("leaves_per_cm_ratio"));
    let [head_cm, base_cm, tie_cm] = [head, base, chosen.m("tie_cm")].map(cm);
    let steps = vec![
        step(
            words("土台を用意する", "Prepare the base"),
            say!(
                "ラフィアを 3 本そろえて三つ編みにし、{base_cm} cm の土台を作ります。両端 {tie_cm} cm は結ぶために空けておきます。",
                "Braid three strands of raffia to a base of {base_cm} cm. {tie_cm} cm at each end stay bare, for the knot."
            ),
            [15.0, 15.0],
        )
        .shown(StepFigure::Craft(Craft::Braid)),
        step(
            words("葉と花を巻き付ける", "Wind on leaves and flowers"),
            say!(
                "葉 {leaves} 枚と花 {flowers} 個を少しずつ重ね、別のラフィアで土台に巻き付けていきます（ウィリの編み方）。{head_cm} cm まで続けます。",
                "Lay {leaves} leaves and {flowers} flowers one over the other and wind them onto the base with another strand (wili), for {head_cm} cm."
            ),
            [90.0, 90.0],
        )
        .shown(StepFigure::Craft(Craft::Wili)),
        step(
            words("かぶる", "Put it on"),
            say!(
                "頭に水平に載せ、首の後ろで結びます。",
                "Lay it level around the head and tie it at the back."
            ),
            NO_WORK,
        ),
    ];
    let mut notions = vec![
        counted(
            NotionKind::Leaf,
            words("葉またはシダ", "leaves or ferns"),
            leaves,
            say!("パラパライ、ティの葉など", "palapalai, ti leaf and others"),
        ),
        raffia(3.0 * 1.3 * base + 4.0 * head),
    ];
    if 0 < flowers {
        notions.push(counted(
            NotionKind::Flower,
            words("花", "flowers"),
            flowers,
            say!("造花または生花", "artificial or fresh"),
        ));
    }
    let estimate = say!(
        "葉と花の数は目安です",
        "the numbers of leaves and flowers are estimates"
    );
    Ok(
        accessory(Vec::new(), notions, steps, estimate).measuring(vec![sewn(
            words("飾りの長さ", "length of leaves and flowers"),
            Some(measures.head_girth),
            head,
        )]),
    )
}

mod worn {
    //! The lei poʻo: a wreath worn level around the head, over the hair.

    use lole_body::{Bone, PartKind};
    use lole_pattern::DraftError;

    use glam::Vec3;

    use crate::GarmentSpec;
    use crate::adorn::blade::Blade;
    use crate::adorn::body::{Around, Girdle, bone_alone};
    use crate::adorn::chosen::{Chosen, whole};
    use crate::adorn::wreath::{Wound, wind};
    use crate::adorn::{AdornmentFinish, Made, Wearer, flower};

    /// Where it lies on the forehead, from the head's joint to the crown.
    const FOREHEAD: f32 = 0.72;
    /// How far it is lower behind, over its depth: it rests on the back of the head.
    const FALL: f32 = 0.16;
    /// Fern and flower of the mean woman's wreath [m].
    const LEAF: [f32; 2] = [0.052, 0.019];
    const FLOWER: f32 = 0.024;
    /// Radius of the base [m].
    const BASE: f32 = 0.006;
    /// Farthest that hair reaches from the middle of the head [m]: what is knotted behind lies farther out.
    const REACH: f32 = 0.115;

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let dancer = wearer.dancer;
        let joint = dancer.skeleton.joint(Bone::Head);
        let rise = dancer.landmarks.crown_height - joint.y;
        let size = rise / 0.20;
        // The middle of the skull lies over the joint, between face and nape.
        let parts: &[PartKind] = &[PartKind::Skin, PartKind::Face, PartKind::Hair];
        let level = joint.y + FOREHEAD * rise;
        let near = crate::adorn::body::vertices(dancer, parts)
            .filter(|vertex| (vertex.y - level).abs() < 0.02 && (vertex.x).abs() < 0.2);
        let [low, high] = near
            .filter(|vertex| (vertex.z - joint.z).abs() < REACH * size)
            .fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], vertex| {
                [low.min(vertex.z), high.max(vertex.z)]
            });
        let middle = if low < high {
            0.5 * (low + high)
        } else {
            joint.z
        };
        let axis = Vec3::new(0.0, 1.0, -FALL).normalize_or(Vec3::Y);
        let girdle = Girdle::new(
            dancer,
            &Around {
                center: Vec3::new(joint.x, level - 0.5 * FALL * 0.2 * size, middle),
                axis,
                front: Vec3::Z,
                half_height: 0.012 * size,
                reach: REACH * size,
                parts,
            },
            96,
        );
        let around_cm = f64::from(girdle.length()) * 100.0;
        let per_cm = |key: &str, usual: f64| whole(around_cm * chosen.number(key, usual));
        let wound = Wound {
            leaf: Blade {
                length: LEAF[0] * size,
                width: LEAF[1] * size,
                fold: 0.35,
                droop: 0.12,
                color: chosen.leaf(),
            },
            leaf_count: 2 * per_cm("leaves_per_cm_ratio", 1.0),
            flower: flower::rosette(FLOWER * size, chosen.flower(), chosen.shadow()),
            flower_count: per_cm("flowers_per_cm_ratio", 0.3),
            base: BASE * size.max(0.7),
        };
        let [leaves, flowers] = wind(&girdle, &wound);
        let head = bone_alone(Bone::Head);
        Ok(Made {
            surfaces: vec![
                leaves.ridden(AdornmentFinish::Leaf, head),
                flowers.ridden(AdornmentFinish::Petal, head),
            ],
            ..Made::default()
        })
    }
}
