//! The kīkepa: a rectangle that is wrapped around the body under the arms and tied over one shoulder.
//!
//! Newspapers of Honolulu describe 36 to 45 inches by about two yards; shops sell blanks of 60 by 68
//! inches. That it goes one and a half times around and leaves a forearm's length for the knot gives
//! two yards to a girth of 91 cm: derived.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::piece::{CutCount, Finish};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

use super::pau_skirt::HEM_HEIGHT;
use crate::drafting::chosen::{Chosen, by_measure, number};
use crate::drafting::making::{NO_WORK, cm, edges_of, folds, hem_in_section, pattern, say, step};
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
    let [tie_cm, girth_cm] = [chosen.m("tie_cm"), widest].map(cm);
    let steps = vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {cut_width} cm、幅の方向に {cut_height} cm の長方形を裁ちます。",
                "Cut a rectangle of {cut_width} cm along the selvage and {cut_height} cm across it."
            ),
            [10.0, 10.0],
        )
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
                "上の端を脇の下に当て、{girth_cm} cm の胴を一周半巻きます。角の {tie_cm} cm を左の肩の上へ回し、後ろの端と結びます。",
                "Hold the upper edge under the arms and wrap it one and a half times around {girth_cm} cm. Bring the last {tie_cm} cm over the left shoulder and tie it to the edge at the back."
            ),
            NO_WORK,
        ),
    ];
    Ok(
        pattern(vec![piece], Vec::new(), Vec::new(), steps).warn(say!(
            "巻き方と大きさは目安です。クムの決まりに合わせてください",
            "size and way of wrapping are estimates; the rule of your kumu comes first"
        )),
    )
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
    use crate::dress::bodice::folds;
    use crate::dress::form::Face;
    use crate::dress::wrap::{Carrier, Cloth, Wrap, along};
    use crate::template::{FEW_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Wrapped(Wrap {
            place,
            gap,
            knots: |_| Vec::new(),
            is_pinned,
            carrier: Carrier::Tape,
        }),
        particle_count: 4000.0,
        substep_counts: FEW_SUBSTEPS,
    };

    /// The wrapped part is this many turns at most, as the template's instructions say, and this many at
    /// least: the rest is for the way over the shoulder and the knot.
    const TURNS: [f64; 2] = [1.15, 1.5];
    /// The upper edge lies this far below the armpits [m].
    const BELOW_ARMPIT: f32 = 0.012;
    /// Gap to the skin, and what each turn adds [m].
    const GAP: f32 = 0.008;
    const TURN_GAP: f32 = 0.008;
    /// Depth below the upper edge down to which the corner is drawn over the shoulder [m].
    const DRAWN: f32 = 0.28;
    /// Length of the corner that the knot takes [m].
    const KNOT: f64 = 0.06;
    /// Cloth left for the way over the shoulder, over its length.
    const SLACK: f32 = 1.06;
    /// Cloth that is drawn up lies over the skin by this [m].
    const OVER_SKIN: f32 = 0.016;
    /// Share of its length that the front end goes on around her; the rest of it lies in folds.
    const GOES_ON: f32 = 0.7;

    /// How she has wrapped it.
    struct Wrapped {
        /// Length that is wrapped [m]: she leaves what the way over the shoulder takes.
        end: f64,
        /// Girth that it is wrapped around [m].
        girth: f64,
        /// From the middle of the front over the left shoulder to the upper edge at the back [m].
        way: [Vec3; 7],
    }

    impl Wrapped {
        fn new(cloth: &Cloth<'_>) -> Option<Self> {
            let girth = cloth.widest();
            let top = cloth.armpit() - BELOW_ARMPIT;
            let way = over_shoulder(cloth, cloth.around(top, 0.5, gap_of(0.5))?)?;
            let left = cloth.size.x - KNOT - f64::from(SLACK * length(&way));
            let [least, most] = TURNS.map(|turns| turns * girth);
            Some(Self {
                end: left.clamp(least, most).min(cloth.size.x - KNOT),
                girth,
                way,
            })
        }

        /// Turns around her, from the middle of the back over her left.
        fn turn_of(&self, x: f64) -> f32 {
            0.5 + narrow((self.end - x) / self.girth)
        }
    }

    fn length(way: &[Vec3]) -> f32 {
        way.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    }

    fn gap_of(turn: f32) -> f32 {
        GAP + TURN_GAP * (2.0 - turn)
    }

    /// The turns keep their order where an arm lets them no farther out than the skin.
    fn gap(cloth: &Cloth<'_>, point: DVec2) -> f32 {
        let wrapped = Wrapped::new(cloth);
        let turn = wrapped.map_or(0.5, |wrapped| wrapped.turn_of(point.x).max(0.5));
        gap_of(turn)
    }

    /// What is tucked in: the upper edge, and the corner in the knot.
    fn is_pinned(cloth: &Cloth<'_>, point: DVec2, spacing: f64) -> bool {
        let is_top = cloth.size.y - 0.5 * spacing < point.y;
        let end = Wrapped::new(cloth).map_or(cloth.size.x, |wrapped| wrapped.end);
        is_top && (point.x <= end || cloth.size.x - KNOT <= point.x)
    }

    fn place(cloth: &Cloth<'_>, point: DVec2) -> Option<Vec3> {
        let top = cloth.armpit() - BELOW_ARMPIT;
        let depth = narrow(cloth.size.y - point.y);
        let wrapped = Wrapped::new(cloth)?;
        if point.x <= wrapped.end {
            let turn = wrapped.turn_of(point.x);
            return cloth.around(top - depth, turn, gap_of(turn));
        }
        let beyond = narrow(point.x - wrapped.end);
        let tie = narrow(cloth.size.x - wrapped.end);
        let drawn = (1.0 - depth / DRAWN).max(0.0);
        let goes_on = 0.5 - GOES_ON * (1.0 - drawn) * beyond / narrow(wrapped.girth);
        let fold = (1.0 - drawn) * folds(1.0 / GOES_ON, tie, beyond / tie);
        let base = cloth.around(top - depth, goes_on, gap_of(goes_on) + fold)?;
        let up = along(&wrapped.way, drawn * beyond / tie) - wrapped.way[0];
        Some(base + up)
    }

    /// From the middle of the front over the left shoulder to the upper edge at the back.
    fn over_shoulder(cloth: &Cloth<'_>, start: Vec3) -> Option<[Vec3; 7]> {
        let top = cloth.armpit() - BELOW_ARMPIT;
        let [neck, drop] = [cloth.measures.neck_height, cloth.measures.shoulder_drop];
        let shoulder = neck.to_m_f32() - 0.5 * drop.to_m_f32();
        let on = |share: f32, face: Face, side: f32| {
            let height = top + (shoulder - top) * share;
            let (place, outward) = cloth.form.on_trunk(height, face, side)?;
            Some(place + (outward + Vec3::Y * share).normalize_or_zero() * OVER_SKIN)
        };
        Some([
            start,
            on(0.4, Face::Front, 0.3)?,
            on(0.8, Face::Front, 0.6)?,
            on(1.0, Face::Front, 1.0)? + Vec3::Y * 0.01,
            on(0.8, Face::Back, 0.7)?,
            on(0.4, Face::Back, 0.6)?,
            on(0.0, Face::Back, 0.55)?,
        ])
    }
}
