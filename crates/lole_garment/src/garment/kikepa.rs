//! The kīkepa: a rectangle that is wrapped around the body under the arms and tied over one shoulder.
//!
//! Newspapers of Honolulu describe 36 to 45 inches by about two yards; shops sell blanks of 60 by 68
//! inches. That it goes one and a half times around and leaves a forearm's length for the knot gives
//! two yards to a girth of 91 cm: derived.

use lole_geom::Length;
use lole_language::{Words, words};
use lole_pattern::pattern::StepFigure;
use lole_pattern::piece::{CutCount, Finish};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

use super::pau_skirt::HEM_HEIGHT;
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
    id: "kikepa",
    name: words("キーケパ", "kīkepa"),
    about: words(
        "脇の下で巻き、片方の肩で結ぶ一枚の布",
        "one cloth, wrapped under the arms and tied over one shoulder",
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
        &[[0.3, 0.34], [0.7, 0.3], [0.76, 0.9], [0.24, 0.9]],
        Tone::Cloth,
    );
    pen.patch(
        &[[0.3, 0.34], [0.36, 0.12], [0.44, 0.12], [0.5, 0.33]],
        Tone::Cloth,
    );
}

const OPTIONS: &[OptionRow] = &[
    number("hem_height_cm", [0.0, 100.0], 30.0, HEM_HEIGHT),
    number(
        "wrap_ratio",
        [1.1, 3.0],
        1.5,
        words(
            "巻く長さ÷いちばん太い胴回り",
            "length that is wrapped over the widest girth",
        ),
    ),
    number(
        "tie_cm",
        [10.0, 120.0],
        45.0,
        words("肩で結ぶための長さ", "length for the knot on the shoulder"),
    ),
    by_measure(
        "height_cm",
        [40.0, 160.0],
        words(
            "できあがりの幅。書かなければ脇の下から裾まで",
            "finished height; left out: from the armpits to the hem",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 10.0],
        2.0,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// Over the armpits, so that the upper edge covers the bust [m].
const OVER_ARMPITS: f64 = 3.0 * CM;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::BustGirth, Measure::HipGirth, Measure::ArmpitHeight])?;
    let widest = measures.bust_girth.to_m().max(measures.hip_girth.to_m());
    let hem_height = chosen.m("hem_height_cm");
    let height = chosen.m_or(
        "height_cm",
        measures.armpit_height.to_m() + OVER_ARMPITS - hem_height,
    );
    least_height(height, measures)?;
    let width = widest * chosen.number("wrap_ratio") + chosen.m("tie_cm");
    let hem = chosen.m("hem_allowance_cm");
    let sides = ["hem", "left_end", "top", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("cloth", words("布", "cloth"), CutCount::Alike(1));
    let piece = rectangle(label, [width, height], sides, AROUND);
    let [cut_width, cut_height] = [width, height].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let turns = chosen.number("wrap_ratio");
    let [tie_cm, girth_cm, wrapped_cm] = [chosen.m("tie_cm"), widest, turns * widest].map(cm);
    let begin = beginning(turns);
    let (begin_japanese, begin_english) = (begin.japanese, begin.english);
    let figure = StepFigure::Wrapping(vec![
        laid(
            turns * widest,
            words("胴に巻く", "wrapped under the arms"),
            Some([1.0 - turns, 1.0]),
        ),
        laid(
            chosen.m("tie_cm"),
            words(
                "左の肩の上を通って後ろで結ぶ",
                "over the left shoulder, tied at the back",
            ),
            None,
        ),
    ]);
    let steps = vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {cut_width} cm、幅の方向に {cut_height} cm の長方形を裁ちます。",
                "Cut a rectangle of {cut_width} cm along the selvage and {cut_height} cm across it."
            ),
            [10.0, 10.0],
        )
        .cutting()
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("四辺を始末する", "Hem all four sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。耳はそのままでもかまいません。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch. A selvage may stay as it is."
            ),
            minutes(&[(Work::Hem, 2.0 * (width + height))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("着る", "Put it on"),
            say!(
                "上の端を脇の下に当て、{begin_japanese}から始めて右へ回し、{girth_cm} cm の胴に {turns} 周（{wrapped_cm} cm）巻きます。前に来た角の {tie_cm} cm を左の肩の上へ回し、後ろの上の端と結びます。",
                "Hold the upper edge under the arms, begin at {begin_english} and wrap towards your right, {turns} times around {girth_cm} cm ({wrapped_cm} cm). Bring the last {tie_cm} cm, a corner in front now, over the left shoulder and tie it to the upper edge at the back."
            ),
            NO_WORK,
        )
        .shown(figure),
    ];
    Ok(pattern(vec![piece], Vec::new(), Vec::new(), steps)
        .measuring(length_and_width(width, height))
        .warn(say!(
            "巻き方と大きさは目安です。クムの決まりに合わせてください",
            "size and way of wrapping are estimates; the rule of your kumu comes first"
        )))
}

/// Where wrapping begins that ends in the middle of the front after so many turns.
fn beginning(turns: f64) -> Words {
    const PLACES: [Words; 4] = [
        words("前の中心", "the middle of the front"),
        words("左脇", "your left side"),
        words("後ろの中心", "the middle of the back"),
        words("右脇", "your right side"),
    ];
    // Towards her right from the front is back through the quarters.
    let quarters = (4.0 * (1.0 - turns)).round().rem_euclid(4.0);
    let is_at = |place: &usize| (quarters - *place as f64).abs() < 0.5;
    let place = (0..PLACES.len()).find(is_at);
    PLACES[place.unwrap_or_default()]
}

/// The cloth must reach from the hem over the bust.
fn least_height(height: f64, measures: &Measures) -> Result<(), DraftError> {
    const LEAST_CM: f64 = 30.0;
    if LEAST_CM * CM <= height {
        return Ok(());
    }
    Err(DraftError::TooShort {
        hem_cm: (measures.armpit_height + Length::from_m(OVER_ARMPITS - height)).to_cm(),
        finished_cm: height / CM,
        band_cm: LEAST_CM,
    })
}

mod worn {
    //! The kīkepa: wrapped one and a half times around under the arms from the middle of the back over her
    //! right, its upper corner brought over the left shoulder and tied to the edge at the back.

    use glam::{DVec2, Vec3};
    use lole_geom::narrow;

    use crate::dress::Way;
    use crate::dress::form::Face;
    use crate::dress::hung::Hung;
    use crate::dress::wrap::{Carrier, Cloth, Wrap, along};
    use crate::template::{MANY_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Wrapped(Wrap {
            place,
            gap,
            knots: |_| Vec::new(),
            is_pinned,
            led,
            carrier: Carrier::Tape,
        }),
        particle_count: 4000.0,
        // An arm lifts it in every count: more of them where it is strained would be more of them always.
        substep_counts: [MANY_SUBSTEPS[0]; 2],
    };

    /// The wrapped part is this many turns at most, as the template's instructions say, and this many at
    /// least: the rest is for the way over the shoulder and the knot.
    const TURNS: [f64; 2] = [1.15, 1.5];
    /// The upper edge lies this far below the armpits [m].
    const BELOW_ARMPIT: f32 = 0.05;
    /// Gap to the skin, and what each turn adds [m].
    const GAP: f32 = 0.008;
    const TURN_GAP: f32 = 0.008;
    /// How much farther out cloth is wrapped for each part of its way below the hips.
    const LOOSER: f32 = 0.03;
    /// Length of the corner that the knot takes [m].
    const KNOT: f64 = 0.06;
    /// Cloth left for the way over the shoulder, over its length.
    const SLACK: f32 = 1.4;
    /// Points of the way over the shoulder, and the share of it after which what is led comes over the skin.
    const WAY_POINTS: u16 = 24;
    const OVER_FROM: f32 = 0.35;
    /// Cloth that is drawn up lies over the skin by this [m].
    const OVER_SKIN: f32 = 0.016;
    /// Before it is drawn over the shoulder, the corner is held away from her by so much of the way forward
    /// for each part of it to her left.
    const FORWARD: f32 = 0.4;
    /// On its way it is lifted by so much of the length of the way over the shoulder, and comes down on it at
    /// last: what hangs from it would be drawn through the arm instead of over it.
    const LIFT: f32 = 0.5;
    /// Points of the way of what is lifted.
    const LIFT_POINTS: u16 = 24;
    /// To both sides of the middle of her side, the part of a turn that lies under the arm.
    const UNDER_ARM: f32 = 0.1;
    /// Share of the way after which the edge is held by the shoulder.
    const CREST: f32 = 0.5;

    /// How she has wrapped it.
    struct Wrapped<'a> {
        /// Length that is wrapped [m]: she leaves what the way over the shoulder takes.
        end: f64,
        /// From the middle of the front over the left shoulder to the upper edge at the back [m].
        way: &'a [Vec3],
    }

    impl<'a> Wrapped<'a> {
        fn new(cloth: &'a Cloth<'_>) -> Option<Self> {
            let top = top(cloth);
            let hung = cloth.hung(top)?;
            let start = hung.place(top, 0.5, gap_of(0.5));
            let way = cloth.way.get_or_init(|| over_shoulder(cloth, start));
            let way = way.as_ref()?;
            let left = cloth.size.x - KNOT - f64::from(SLACK * length(way));
            let girth = f64::from(hung.girth(top, GAP + 0.5 * TURN_GAP));
            let [least, most] = TURNS.map(|turns| turns * girth);
            Some(Self {
                end: left.clamp(least, most).min(cloth.size.x - KNOT),
                way,
            })
        }

        /// Share of the way over the shoulder that a point of the upper edge comes to lie at.
        fn share_over(&self, cloth: &Cloth<'_>, x: f64) -> f32 {
            let drawn = cloth.size.x - 0.5 * KNOT - self.end;
            narrow((x - self.end) / drawn).clamp(0.0, 1.0)
        }

        /// Turns around her, from the middle of the back over her left, of a point of the cloth, and how far
        /// out of the skin it lies [m]. The front end lies in the middle of the front at the upper edge; from
        /// there down the middle of what is wrapped hangs straight, and both ends slant.
        fn around(&self, hung: &Hung, [top, x, height, looser]: [f32; 4]) -> [f32; 2] {
            let half = 0.5 * narrow(self.end);
            let mean = |height, looser| hung.girth(height, GAP + 0.5 * TURN_GAP + looser);
            let middle = 0.5 + half / mean(top, 0.0);
            let turn = middle + (half - x.min(2.0 * half)) / mean(height, looser);
            [turn, gap_of(turn) + looser]
        }
    }

    fn length(way: &[Vec3]) -> f32 {
        way.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    }

    /// Height of the upper edge [m].
    fn top(cloth: &Cloth<'_>) -> f32 {
        cloth.armpit() - BELOW_ARMPIT
    }

    fn gap_of(turn: f32) -> f32 {
        GAP + TURN_GAP * (2.0 - turn)
    }

    /// Turns of a point around her, how far out of the skin it lies, and its height [m].
    fn wrapped_at(cloth: &Cloth<'_>, wrapped: &Wrapped<'_>, point: DVec2) -> Option<[f32; 3]> {
        let top = top(cloth);
        let height = top - narrow(cloth.size.y - point.y);
        let hips = cloth.measures.hip_height.to_m_f32();
        let looser = LOOSER * (hips - height).max(0.0);
        let [turn, gap] = wrapped.around(cloth.hung(top)?, [top, narrow(point.x), height, looser]);
        Some([turn, gap, height])
    }

    /// The turns keep their order where an arm lets them no farther out than the skin.
    fn gap(cloth: &Cloth<'_>, point: DVec2) -> f32 {
        let wrapped = Wrapped::new(cloth);
        let at = wrapped.and_then(|wrapped| wrapped_at(cloth, &wrapped, point));
        gap_of(at.map_or(0.5, |[turn, ..]| turn))
    }

    /// What is tucked in or tied: the upper edge where it is wrapped, and from the shoulder to the knot. Under the
    /// arms it is free to be pushed down by them.
    fn is_pinned(cloth: &Cloth<'_>, point: DVec2, spacing: f64) -> bool {
        let is_top = cloth.size.y - 0.5 * spacing < point.y;
        let is_under_arm = |wrapped: &Wrapped<'_>| {
            let turns = wrapped_at(cloth, wrapped, point).map(|[turn, ..]| turn);
            // The sides are a quarter and three quarters of a turn from the middle of the back.
            let sides = turns.map(|turn| 2.0 * turn - 0.5);
            sides.is_some_and(|it| (it - it.round()).abs() < 2.0 * UNDER_ARM)
        };
        let is_tied = |wrapped: Wrapped<'_>| {
            let is_wrapped = point.x <= wrapped.end && !is_under_arm(&wrapped);
            is_wrapped || CREST <= wrapped.share_over(cloth, point.x)
        };
        is_top && Wrapped::new(cloth).is_none_or(is_tied)
    }

    fn place(cloth: &Cloth<'_>, point: DVec2) -> Option<Vec3> {
        let wrapped = Wrapped::new(cloth)?;
        let [turn, gap, height] = wrapped_at(cloth, &wrapped, point)?;
        let held_out = narrow(point.x - wrapped.end).max(0.0)
            * Vec3::new(1.0, 0.0, FORWARD).normalize_or_zero();
        Some(cloth.hung(top(cloth))?.place(height, turn, gap) + held_out)
    }

    /// The edge beyond the shoulder is lifted over it, each point as far as it reaches towards the knot.
    fn led(cloth: &Cloth<'_>, point: DVec2) -> Vec<Vec3> {
        let Some(wrapped) = Wrapped::new(cloth).filter(|wrapped| wrapped.end < point.x) else {
            return Vec::new();
        };
        let start = place(cloth, point);
        let share = wrapped.share_over(cloth, point.x);
        let before = wrapped.way.iter().zip(0_u16..).filter(|(_, number)| {
            let passed = f32::from(*number) / f32::from(WAY_POINTS);
            OVER_FROM < passed && passed < share
        });
        let before = before.map(|(place, _)| *place);
        let last = along(wrapped.way, share);
        let low: Vec<Vec3> = start.into_iter().chain(before).chain([last]).collect();
        let lift = LIFT * length(wrapped.way) * share;
        let lifted = |point: u16| {
            let passed = f32::from(point) / f32::from(LIFT_POINTS);
            along(&low, passed) + Vec3::Y * (4.0 * lift * passed * (1.0 - passed))
        };
        (0..=LIFT_POINTS).map(lifted).collect()
    }

    /// From the middle of the front over the left shoulder to the upper edge at the back, over the skin.
    fn over_shoulder(cloth: &Cloth<'_>, start: Vec3) -> Option<Vec<Vec3>> {
        let top = top(cloth);
        let [neck, drop] = [cloth.measures.neck_height, cloth.measures.shoulder_drop];
        let shoulder = neck.to_m_f32() - 0.5 * drop.to_m_f32();
        // At the back it comes down over all turns of the edge.
        let over_edge = gap_of(0.5) + TURN_GAP;
        let on = |share: f32, face: Face, side: f32| {
            let height = top + (shoulder - top) * share;
            let (place, outward) = cloth.form.on_trunk(height, face, side)?;
            let over = match face {
                Face::Front => OVER_SKIN,
                Face::Back => over_edge + (OVER_SKIN - over_edge) * share,
            };
            Some(place + (outward + Vec3::Y * share).normalize_or_zero() * over)
        };
        let corners = [
            start,
            on(0.4, Face::Front, 0.25)?,
            on(0.8, Face::Front, 0.32)?,
            on(1.0, Face::Front, 0.36)? + Vec3::Y * 0.01,
            on(0.8, Face::Back, 0.36)?,
            on(0.4, Face::Back, 0.38)?,
            on(0.0, Face::Back, 0.42)?,
        ];
        let mut way: Vec<Vec3> = (0..=WAY_POINTS)
            .map(|point| along(&corners, f32::from(point) / f32::from(WAY_POINTS)))
            .collect();
        cloth.form.push_out(&mut way, |_| OVER_SKIN);
        Some(way)
    }
}
