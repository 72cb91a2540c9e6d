//! The malo: a strip that is girded about the waist and between the legs, its ends hanging as flaps.
//!
//! A halau's instructions give strips of 3 to 6 yards, girded, with flaps (pola) in front and at the back.
//! The width is an estimate. The length here is the way it goes: two flaps, the crotch, and the turns
//! about the waist: derived.

use lole_language::words;
use lole_pattern::pattern::StepFigure;
use lole_pattern::piece::{CutCount, Finish};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

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
    id: "malo",
    name: words("マロ", "malo"),
    about: words(
        "腰と股に巻き、端を前後に垂らす細長い布",
        "a strip girded about waist and legs, its ends hanging in front and at the back",
    ),
    shelf: Shelf::Wraps,
    options: OPTIONS,
    draft,
    worn: Wear::Sewn(worn::ROW),
    chest_room_deg: 0.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.2, 0.3], [0.8, 0.3], [0.8, 0.4], [0.2, 0.4]],
        Tone::Cloth,
    );
    pen.patch(
        &[[0.38, 0.36], [0.62, 0.36], [0.6, 0.86], [0.4, 0.86]],
        Tone::Cloth,
    );
}

const OPTIONS: &[OptionRow] = &[
    number(
        "width_cm",
        [12.0, 60.0],
        26.0,
        words("できあがりの幅", "finished width"),
    ),
    number(
        "turn_count_ratio",
        [1.0, 4.0],
        2.0,
        words(
            "腰に巻く長さ÷ウエスト",
            "length about the waist over the waist girth",
        ),
    ),
    by_measure(
        "flap_cm",
        [10.0, 100.0],
        words(
            "前後に垂れる布の長さ。書かなければひざの上まで",
            "length of each flap; left out: to above the knees",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 5.0],
        1.5,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// The flaps end over the knees [m].
const OVER_KNEES: f64 = 3.0 * CM;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[
        Measure::WaistGirth,
        Measure::CrotchLength,
        Measure::WaistHeight,
        Measure::KneeHeight,
    ])?;
    let drop = measures.waist_height.to_m() - measures.knee_height.to_m() - OVER_KNEES;
    let flap = chosen.m_or("flap_cm", drop.clamp(10.0 * CM, 100.0 * CM));
    let turns = chosen.number("turn_count_ratio");
    let waist = measures.waist_girth.to_m();
    let length = 2.0 * flap + measures.crotch_length.to_m() + turns * waist;
    let (width, hem) = (chosen.m("width_cm"), chosen.m("hem_allowance_cm"));
    let sides = ["lower", "left_end", "upper", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("strip", words("帯布", "strip"), CutCount::Alike(1));
    let piece = rectangle(label, [length, width], sides, AROUND);
    let [cut_length, cut_width] = [length, width].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let [flap_cm, waist_cm] = [flap, waist].map(cm);
    let yards = (lole_geom::Length::from_m(length).to_yd() * 10.0).round() / 10.0;
    let steps = vec![
        step(
            words("布を裁つ", "Cut the strip"),
            say!(
                "耳に沿って {cut_length} cm（{yards} ヤード）、幅 {cut_width} cm の帯を裁ちます。",
                "Cut a strip of {cut_length} cm ({yards} yd) along the selvage, {cut_width} cm wide."
            ),
            [10.0, 10.0],
        )
        .cutting()
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("まわりを始末する", "Hem all sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch."
            ),
            minutes(&[(Work::Hem, 2.0 * (length + width))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("締める", "Gird it"),
            say!(
                "端を {flap_cm} cm 前に残して股を通し、後ろから {waist_cm} cm の腰に {turns} 周巻き、巻いた布にくぐらせて、残りを後ろに垂らします。",
                "Leave {flap_cm} cm hanging in front, pass the strip between the legs, wind it {turns} times about the waist of {waist_cm} cm, draw it under itself and let the rest hang at the back."
            ),
            NO_WORK,
        )
        .shown(way(flap, measures, turns)),
    ];
    Ok(pattern(vec![piece], Vec::new(), Vec::new(), steps)
        .measuring(length_and_width(length, width))
        .warn(say!(
            "マロの幅は目安です。締め方はクムに習ってください",
            "the width of the malo is an estimate; learn from your kumu how it is girded"
        )))
}

/// The strip's parts in the order in which they are laid.
fn way(flap: f64, measures: &Measures, turns: f64) -> StepFigure {
    StepFigure::Wrapping(vec![
        laid(flap, words("前に垂らす", "hangs in front"), None),
        laid(
            measures.crotch_length.to_m(),
            words(
                "股を通して後ろの腰まで",
                "between the legs, up to the waist behind",
            ),
            None,
        ),
        laid(
            turns * measures.waist_girth.to_m(),
            words("腰に巻く", "wound about the waist"),
            Some([0.5, 0.5 + turns]),
        ),
        laid(
            flap,
            words(
                "巻いた布にくぐらせて後ろに垂らす",
                "drawn under the turns at the waist, hangs behind",
            ),
            None,
        ),
    ])
}

mod worn {
    //! The malo: its front flap, the way between the legs, the turns about the waist, and the flap at the
    //! back. Girded as tightly as it is, all but the flaps goes with the skin.
    //!
    //! Where the strip comes up the back it is folded aslant to go around the waist: a fold at 45° turns a strip
    //! by a right angle without a pucker. At the end it is folded aslant again, upwards, and hangs down over that,
    //! its right side out.

    use glam::{DVec2, Vec3};
    use lole_geom::narrow;

    use crate::dress::Way;
    use crate::dress::fit;
    use crate::dress::form::Face;
    use crate::dress::wrap::{Carrier, Cloth, Wrap, along};
    use crate::template::{FEW_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Wrapped(Wrap {
            place,
            gap: |_, _| fit::START_GAP,
            knots: |_| Vec::new(),
            is_pinned,
            led: |_, _| Vec::new(),
            carrier: Carrier::Girded,
        }),
        particle_count: 3000.0,
        substep_counts: FEW_SUBSTEPS,
    };

    /// The flaps are a share of what is left of the strip without crotch and turns: half each.
    const TURNS: f64 = 2.0;
    /// Height of the girded band, and width between the legs, over the width of the strip.
    const BAND: f32 = 0.34;
    /// Gap to the skin, what each layer adds, and of the flaps over the band [m].
    const GAP: f32 = 0.006;
    const LAYER: f32 = 0.005;
    const FLAP: f32 = 0.034;
    /// A flap goes over the upper edge of the band this far above it [m]: farther than particles are apart.
    const OVER_EDGE: f32 = 0.022;
    /// Between the legs it is bunched to this share of its width in the band, and spreads to that within so much
    /// above the crotch [m].
    const BUNCHED: f32 = 0.2;
    const SPREADS: f32 = 0.12;
    /// It goes under the trunk from so far above the crotch on, so far from the skin [m].
    const BEGINS: f32 = 0.05;
    const UNDER_GAP: f32 = 0.010;
    /// Up to so far above the crotch the strip between the legs is flat, and as far again it comes to lie around
    /// the trunk [m].
    const FLAT: f32 = 0.08;
    /// Half of the strip's length that the turn of a fold takes [m]: about a triangle.
    const ROUND: f32 = 0.026;
    /// Cloth of a flap nearer to the band than this is still held by it [m].
    const HELD: f64 = 0.09;

    /// Lengths of the strip up to which it is front flap, crotch and turns [m].
    fn stops(cloth: &Cloth<'_>) -> [f64; 3] {
        let waist = cloth.measures.waist_girth.to_m();
        let crotch = cloth.measures.crotch_length.to_m();
        let flap = (0.5 * (cloth.size.x - crotch - TURNS * waist)).max(0.05);
        [flap, flap + crotch, cloth.size.x - flap]
    }

    /// Before so much of a fold's middle the strip lies as if there were none [m].
    fn before_fold(cloth: &Cloth<'_>) -> f32 {
        -0.5 * BAND * narrow(cloth.size.y) - 2.0 * ROUND
    }

    fn is_pinned(cloth: &Cloth<'_>, point: DVec2, _: f64) -> bool {
        let [front, _, back] = stops(cloth);
        (front - HELD..=back + HELD).contains(&point.x)
    }

    fn place(cloth: &Cloth<'_>, point: DVec2) -> Option<Vec3> {
        let waist = cloth.measures.waist_height.to_m_f32() - 0.03;
        let across = narrow(point.y - 0.5 * cloth.size.y);
        let edge = waist + 0.5 * BAND * narrow(cloth.size.y);
        let [front, crotch, back] = stops(cloth);
        if point.x < front {
            let down = narrow(front - point.x);
            let top = edge + OVER_EDGE;
            return hanging(cloth, Face::Front, [top, top - down], [down, -across]);
        }
        // Up the back it lies so far to her left, and around the waist so far above the middle of the band.
        let aside = -across * BAND;
        let [past_crotch, past_back] = [crotch, back].map(|stop| narrow(point.x - stop));
        if past_crotch < before_fold(cloth) {
            let end = crotch + f64::from(before_fold(cloth));
            let share = narrow((point.x - front) / (end - front));
            return Some(along(&between_legs(cloth, waist, aside)?, share));
        }
        let turn = (back - crotch) / TURNS;
        let turned = |past: f32| past / narrow(turn);
        let layer = |turned: f32| GAP + LAYER * (1.0 + turned);
        let around = |up: f32, turned: f32, gap: f32| {
            let (place, outward) = cloth.form.around_trunk(waist + up, turned)?;
            Some(place + outward * gap)
        };
        // Folded aslant it goes on as far around as it went up, and at the end as far up as around.
        if past_back < before_fold(cloth) {
            let fold = Fold::new(past_crotch, aside);
            let gap = GAP + (layer(turned(past_crotch)) - GAP) * fold.beyond;
            return around(fold.least, turned(fold.most), gap);
        }
        let outermost = layer(narrow(TURNS) + 1.0);
        let top = edge + OVER_EDGE;
        let down = past_back - (top - waist);
        if down < 0.0 {
            let fold = Fold::new(past_back, aside);
            let below = layer(narrow(TURNS) + turned(past_back));
            let gap = below + (outermost - below) * fold.beyond;
            return around(fold.most, turned(fold.least), gap);
        }
        hanging(cloth, Face::Back, [top, top - down], [down, -across])
    }

    /// A strip folded along a line at 45° to it: of its length and its width, what was the one is the other
    /// beyond the fold, which is as round as its triangles can follow.
    struct Fold {
        /// The lesser and the larger of both [m].
        least: f32,
        most: f32,
        /// 0 before the fold, 1 beyond it.
        beyond: f32,
    }

    impl Fold {
        fn new(along: f32, aside: f32) -> Self {
            let (middle, off) = (0.5 * (along + aside), 0.5 * (along - aside));
            let from_fold = if off.abs() < ROUND {
                0.5 * (off * off / ROUND + ROUND)
            } else {
                off.abs()
            };
            let share = (0.5 + 0.5 * off / ROUND).clamp(0.0, 1.0);
            Self {
                least: middle - from_fold,
                most: middle + from_fold,
                beyond: share * share * (3.0 - 2.0 * share),
            }
        }
    }

    /// A flap in front or at the back, hanging from the band: at a height, below an edge over which it comes [m].
    fn hanging(
        cloth: &Cloth<'_>,
        face: Face,
        [edge, at]: [f32; 2],
        [down, across]: [f32; 2],
    ) -> Option<Vec3> {
        // It spreads below the band.
        let below = down - narrow(HELD);
        let spread = BAND + (1.0 - BAND) * (below / 0.12).clamp(0.0, 1.0);
        let (top, _) = cloth.form.on_trunk(edge, face, 0.0)?;
        let lowest = at.max(0.15);
        // No nearer to the axis than anything above.
        let mut depth = top.z;
        let mut height = edge;
        while lowest < height {
            let (place, _) = cloth.form.on_trunk(height, face, 0.0)?;
            depth = match face {
                Face::Front => depth.max(place.z),
                Face::Back => depth.min(place.z),
            };
            height -= 0.02;
        }
        let out = match face {
            Face::Front => FLAP,
            Face::Back => -FLAP,
        };
        Some(Vec3::new(across * spread, at, depth + out))
    }

    /// Over the skin of the trunk at a height, so far to her left of the middle [m].
    fn on_trunk(
        cloth: &Cloth<'_>,
        face: Face,
        [height, aside]: [f32; 2],
        gap: f32,
    ) -> Option<Vec3> {
        let quarter = 0.25 * cloth.form.girth(height);
        let share = aside / quarter.max(0.05);
        let (place, outward) = cloth.form.on_trunk(height, face, share)?;
        Some(place + outward * gap)
    }

    /// Under the trunk in its middle, from the front to the back, over the skin [m].
    fn below_trunk(cloth: &Cloth<'_>) -> Option<Vec<Vec3>> {
        let crotch = cloth.form.dancer.landmarks.crotch_height;
        let end = |face: Face| {
            let place = on_trunk(cloth, face, [crotch + BEGINS, 0.0], GAP)?;
            Some(place.with_x(0.0))
        };
        let [front, back] = [end(Face::Front)?, end(Face::Back)?];
        let lowest = front.midpoint(back).with_y(crotch - GAP);
        let steps = 6_u8;
        let shares = (1..steps).map(|step| f32::from(step) / f32::from(steps));
        let down = shares.clone().map(|share| front.lerp(lowest, share));
        let up = shares.map(|share| lowest.lerp(back, share));
        let mut way: Vec<Vec3> = down.chain([lowest]).chain(up).collect();
        cloth.form.push_out(&mut way, |_| UNDER_GAP);
        Some(way.into_iter().map(|place| place.with_x(0.0)).collect())
    }

    /// Down the front, between the legs and up the back as far as nothing is folded, so far to her left of the middle [m].
    fn between_legs(cloth: &Cloth<'_>, waist: f32, aside: f32) -> Option<Vec<Vec3>> {
        // On the trunk it lies around it, below the band; between the legs it is flat.
        let crotch = cloth.form.dancer.landmarks.crotch_height;
        let end = waist + before_fold(cloth);
        let spreads = SPREADS.min(end - crotch);
        let bunched = |height: f32| {
            let spread = ((height - crotch) / spreads).clamp(0.0, 1.0);
            aside * (BUNCHED + (1.0 - BUNCHED) * spread * spread * (3.0 - 2.0 * spread))
        };
        let on = |height: f32, face: Face| {
            let aside = bunched(height);
            let around = on_trunk(cloth, face, [height, aside], GAP)?;
            let flat = on_trunk(cloth, face, [height, 0.0], GAP)?.with_x(aside);
            let share = ((height - crotch - FLAT) / FLAT).clamp(0.0, 1.0);
            Some(flat.lerp(around, share))
        };
        let mut way = Vec::new();
        let steps = 10_u8;
        let down_from = |top: f32| {
            (0..=steps).map(move |step| {
                let share = f32::from(step) / f32::from(steps);
                top + (crotch + BEGINS - top) * share
            })
        };
        // The flap in front comes over the upper edge of the band.
        let edge = waist + 0.5 * BAND * narrow(cloth.size.y) + OVER_EDGE;
        for height in std::iter::once(edge).chain(down_from(waist)) {
            way.push(on(height, Face::Front)?);
        }
        let below = cloth.way.get_or_init(|| below_trunk(cloth)).as_ref()?;
        way.extend(below.iter().map(|place| place.with_x(bunched(place.y))));
        let mut back = Vec::new();
        for height in down_from(end) {
            back.push(on(height, Face::Back)?);
        }
        way.extend(back.into_iter().rev());
        Some(way)
    }
}
