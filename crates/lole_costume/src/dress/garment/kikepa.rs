//! The kīkepa: wrapped one and a half times around under the arms from the middle of the back over her
//! right, its upper corner brought over the left shoulder and tied to the edge at the back.

use glam::{DVec2, Vec3};

use super::{Way, Worn};
use crate::dress::bodice::{folds, narrow};
use crate::dress::form::Face;
use crate::dress::wrap::{Carrier, Cloth, Wrap, along};

pub(super) const WORN: Worn = Worn {
    template: "kikepa",
    way: Way::Wrapped(Wrap {
        place,
        gap,
        knots: |_| Vec::new(),
        is_pinned,
        carrier: Carrier::Tape,
    }),
    particle_count: 4000.0,
    chest_room_deg: 14.0,
    substep_counts: super::FEW_SUBSTEPS,
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
