//! The kīhei: a rectangle that is worn over one shoulder and knotted there.
//!
//! Dictionaries say what it is; no source gives its size. 1.04 by 1.8 m for a dancer of 158 cm is an
//! estimate, follows the stature, and is no wider than can be cut from cloth of 110 cm.

use lole_language::words;
use lole_pattern::pattern::StepFigure;
use lole_pattern::piece::{CutCount, Finish};
use lole_pattern::{DraftError, Measure, Pattern};

use crate::drafting::chosen::{Chosen, by_measure, number};
use crate::drafting::making::{
    NO_WORK, cm, edges_of, folds, hem_in_section, laid, length_and_width, pattern, say, step,
};
use crate::drafting::shape::{AROUND, CM, Label, rectangle};
use crate::drafting::work::{Work, minutes};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "kihei",
    name: words("キーヘイ", "kīhei"),
    about: words(
        "片方の肩に掛けて結ぶ一枚の布",
        "one cloth, worn over one shoulder and knotted there",
    ),
    shelf: Shelf::Wraps,
    options: OPTIONS,
    draft,
    worn: Wear::Sewn(worn::ROW),
    chest_room_deg: 14.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[
            [0.3, 0.16],
            [0.5, 0.2],
            [0.82, 0.5],
            [0.74, 0.9],
            [0.2, 0.86],
        ],
        Tone::Cloth,
    );
    pen.disc([0.34, 0.17], 0.05, Tone::Cloth);
    pen.line(&[[0.38, 0.24], [0.66, 0.86]]);
}

const OPTIONS: &[OptionRow] = &[
    by_measure(
        "length_cm",
        [60.0, 300.0],
        words(
            "布の長さ。書かなければ身長の 1.14 倍",
            "length of the cloth; left out: 1.14 times the stature",
        ),
    ),
    by_measure(
        "height_cm",
        [40.0, 200.0],
        words(
            "できあがりの幅。書かなければ身長の 0.66 倍で、104 cm まで",
            "finished height; left out: 0.66 times the stature, at most 104 cm",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 10.0],
        2.0,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// Length and height over the stature: 1.8 and 1.04 m at 158 cm.
const OVER_STATURE: [f64; 2] = [1.14, 0.66];
/// Highest that is cut from cloth of 110 cm, its hems and selvages left.
const HIGHEST: f64 = 104.0 * CM;
/// From the corner to the knot, along the upper edge [m].
const KNOT: f64 = 25.0 * CM;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::Stature])?;
    let [length, height] = OVER_STATURE.map(|share| share * measures.stature.to_m());
    let (length, height) = (
        chosen.m_or("length_cm", length),
        chosen.m_or("height_cm", height.min(HIGHEST)),
    );
    let hem = chosen.m("hem_allowance_cm");
    let sides = ["hem", "left_end", "top", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("cloth", words("布", "cloth"), CutCount::Alike(1));
    let piece = rectangle(label, [length, height], sides, AROUND);
    let [cut_length, cut_height] = [length, height].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let knot_cm = cm(KNOT);
    let hanging = words("結び目から垂れる", "hangs from the knot");
    let figure = StepFigure::Wrapping(vec![
        laid(KNOT, hanging, None),
        laid(
            length - 2.0 * KNOT,
            words(
                "左の肩から背中、右の脇の下を通って左の肩へ",
                "from the left shoulder over the back, under the right arm, to the left shoulder",
            ),
            Some([0.25, 1.25]),
        ),
        laid(KNOT, hanging, None),
    ]);
    let steps = vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {cut_length} cm、幅の方向に {cut_height} cm の長方形を裁ちます。",
                "Cut a rectangle of {cut_length} cm along the selvage and {cut_height} cm across it."
            ),
            [10.0, 10.0],
        )
        .cutting()
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("四辺を始末する", "Hem all four sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch."
            ),
            minutes(&[(Work::Hem, 2.0 * (length + height))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("着る", "Put it on"),
            say!(
                "布を背中に当て、右の脇の下を通して前へ回し、上の二つの角を、角から {knot_cm} cm のところで左の肩の上に結びます。右の腕は出しておきます。",
                "Lay the cloth across the back, bring it under the right arm to the front and knot the two upper corners on the left shoulder, {knot_cm} cm from each corner. The right arm stays free."
            ),
            NO_WORK,
        )
        .shown(figure),
    ];
    Ok(pattern(vec![piece], Vec::new(), Vec::new(), steps)
        .measuring(length_and_width(length, height))
        .warn(say!(
            "キーヘイの大きさは目安です。クムの決まりに合わせてください",
            "the size of the kīhei is an estimate; the rule of your kumu comes first"
        )))
}

mod worn {
    //! The kīhei: across the back, knotted over the left shoulder, the right arm free; its left side is open
    //! and the ends hang from the knot.

    use glam::{DVec2, Vec3};
    use lole_geom::narrow;
    use lole_geom::trig;

    use crate::dress::Way;
    use crate::dress::fit;
    use crate::dress::wrap::{Carrier, Cloth, Wrap};
    use crate::template::{MANY_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Wrapped(Wrap {
            place,
            gap: |_, _| fit::START_GAP,
            knots,
            // The knot alone sits on the shoulder.
            is_pinned: |_, _, _| false,
            led: |_, _| Vec::new(),
            carrier: Carrier::Skin,
        }),
        particle_count: 3500.0,
        substep_counts: MANY_SUBSTEPS,
    };

    /// From each corner to the knot along the upper edge [m], as the template says.
    const KNOT: f64 = 0.25;
    /// Points that the knot takes on either side of it [m].
    const TIED: [f64; 3] = [-0.03, 0.0, 0.03];
    /// Gap to the skin [m].
    const GAP: f32 = 0.015;
    /// The upper edge keeps below the right armpit and above the left shoulder by this [m].
    const BELOW_ARMPIT: f32 = 0.03;
    const OVER_SHOULDER: f32 = 0.02;
    /// Share of a turn around the arm in which the cloth hangs straight, in front of it or behind it.
    const BESIDE_ARM: f32 = 0.13;

    /// Cloth beside the arm is laid out to this share of its width.
    const SPREAD: f32 = 0.45;
    /// The same of the ends beyond the knot, and this far below the upper edge [m].
    const LOW_SPREAD: f32 = 0.9;
    const DEEP: f32 = 0.30;

    fn knots(cloth: &Cloth<'_>) -> Vec<[DVec2; 2]> {
        let ends = |off: f64| {
            let right = DVec2::new(KNOT + off, cloth.size.y);
            let left = DVec2::new(cloth.size.x - KNOT - off, cloth.size.y);
            [right, left]
        };
        TIED.map(ends).to_vec()
    }

    fn place(cloth: &Cloth<'_>, point: DVec2) -> Option<Vec3> {
        let loop_length = cloth.size.x - 2.0 * KNOT;
        let passed = narrow((point.x - KNOT) / loop_length);
        // From the knot over the back and under the right arm to the front and the knot again.
        let turn = 1.25 - passed.clamp(0.0, 1.0);
        let [neck, drop] = [cloth.measures.neck_height, cloth.measures.shoulder_drop];
        let shoulder = neck.to_m_f32() - 0.6 * drop.to_m_f32() + OVER_SHOULDER;
        let armpit = cloth.armpit() - BELOW_ARMPIT;
        let up = 0.5 + 0.5 * trig::cos(std::f32::consts::TAU * (turn - 0.25));
        let top = armpit + (shoulder - armpit) * up * up;
        let height = top - narrow(cloth.size.y - point.y);
        // Beside the left arm the cloth goes straight on to the left.
        let from_knot = passed.min(1.0 - passed);
        let beyond = (BESIDE_ARM - from_knot).max(0.0) * narrow(loop_length);
        let is_front = 0.5 < passed;
        let turned = if is_front {
            turn.max(0.25 + BESIDE_ARM)
        } else {
            turn.min(1.25 - BESIDE_ARM)
        };
        let below_arm = height.min(armpit);
        let (skin, outward) = cloth.form.around_trunk(below_arm.max(0.1), turned)?;
        let excess = narrow(loop_length) - cloth.form.girth(below_arm);
        let gap = GAP + (excess / std::f32::consts::TAU).clamp(0.0, 0.06);
        let mut place = skin + outward * gap;
        place.y = height;
        if 0.0 < beyond {
            // As wide as it is, or it would cut into the arm.
            let depth = narrow(cloth.size.y - point.y);
            let spread = SPREAD + (LOW_SPREAD - SPREAD) * (depth / DEEP).min(1.0);
            let end = (-from_knot).max(0.0) * narrow(loop_length);
            place += Vec3::X * (spread * (beyond - end) + LOW_SPREAD * end);
            let in_front = if is_front { 1.0 } else { -1.0 };
            place.z += in_front * (0.2 * beyond).min(0.03);
        }
        Some(place)
    }
}
