//! The kīhei: across the back, knotted over the left shoulder, the right arm free; its left side is open
//! and the ends hang from the knot.

use glam::{DVec2, Vec3};
use lole_geom::trig;

use super::{Way, Worn};
use crate::dress::bodice::narrow;
use crate::dress::fit;
use crate::dress::wrap::{Carrier, Cloth, Wrap};

pub(super) const WORN: Worn = Worn {
    template: "kihei",
    way: Way::Wrapped(Wrap {
        place,
        gap: |_, _| fit::START_GAP,
        knots,
        is_pinned,
        carrier: Carrier::Skin,
    }),
    particle_count: 3500.0,
    chest_room_deg: 14.0,
    substep_counts: super::MANY_SUBSTEPS,
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

/// The knot sits on the shoulder.
fn is_pinned(cloth: &Cloth<'_>, point: DVec2, spacing: f64) -> bool {
    let near = |at: &DVec2| at.distance(point) < 0.6 * spacing;
    knots(cloth).iter().flatten().any(near)
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
