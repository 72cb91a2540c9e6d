//! The malo: its front flap, the way between the legs, the turns about the waist, and the flap at the
//! back. Girded as tightly as it is, all but the flaps goes with the skin.
//!
//! Where the strip comes up the back it is folded aslant to go around the waist: a fold at 45° turns a strip
//! by a right angle without a pucker. At the end it is folded aslant again, upwards, and hangs down over that,
//! its right side out.

use glam::{DVec2, Vec3};

use super::{Way, Worn};
use crate::dress::bodice::narrow;
use crate::dress::form::Face;
use crate::dress::wrap::{Cloth, Wrap, along};

pub(super) const WORN: Worn = Worn {
    template: "malo",
    way: Way::Wrapped(Wrap {
        place,
        knots: |_| Vec::new(),
        is_pinned,
        is_tied: false,
    }),
    particle_count: 3000.0,
    chest_room_deg: 0.0,
    substep_count: super::FEW_SUBSTEPS,
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
/// Up to so far above the crotch the strip between the legs is flat, and as far again it comes to lie around
/// the trunk [m].
const FLAT: f32 = 0.08;
/// Cloth of a flap nearer to the band than this is still held by it [m].
const HELD: f64 = 0.09;

/// Lengths of the strip up to which it is front flap, crotch and turns [m].
fn stops(cloth: &Cloth<'_>) -> [f64; 3] {
    let waist = cloth.measures.waist_girth.to_m();
    let crotch = cloth.measures.crotch_length.to_m();
    let flap = (0.5 * (cloth.size.x - crotch - TURNS * waist)).max(0.05);
    [flap, flap + crotch, cloth.size.x - flap]
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
    if past_crotch < aside {
        if 0.0 < past_crotch {
            return on_trunk(cloth, Face::Back, [waist + past_crotch, aside], GAP);
        }
        let share = narrow((point.x - front) / (crotch - front));
        return Some(along(&between_legs(cloth, waist, aside)?, share));
    }
    if past_back < aside {
        let turned = narrow((point.x - crotch) / (back - crotch) * TURNS);
        let (place, outward) = cloth.form.around_trunk(waist + aside, turned)?;
        return Some(place + outward * (GAP + LAYER * (1.0 + turned)));
    }
    let top = edge + OVER_EDGE;
    let down = past_back - (top - waist);
    if down < 0.0 {
        let outermost = GAP + LAYER * narrow(TURNS + 2.0);
        return on_trunk(cloth, Face::Back, [waist + past_back, aside], outermost);
    }
    hanging(cloth, Face::Back, [top, top - down], [down, -across])
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
fn on_trunk(cloth: &Cloth<'_>, face: Face, [height, aside]: [f32; 2], gap: f32) -> Option<Vec3> {
    let quarter = 0.25 * cloth.form.girth(height);
    let share = aside / quarter.max(0.05);
    let (place, outward) = cloth.form.on_trunk(height, face, share)?;
    Some(place + outward * gap)
}

/// Down the front, between the legs and up the back, so far to her left of the middle [m].
fn between_legs(cloth: &Cloth<'_>, waist: f32, aside: f32) -> Option<Vec<Vec3>> {
    // On the trunk it lies around it, below the band; between the legs it is flat.
    let crotch = cloth.form.dancer.landmarks.crotch_height;
    let on = |height: f32, face: Face| {
        let around = on_trunk(cloth, face, [height, aside], GAP)?;
        let flat = on_trunk(cloth, face, [height, 0.0], GAP)?.with_x(aside);
        let share = ((height - crotch - FLAT) / FLAT).clamp(0.0, 1.0);
        Some(flat.lerp(around, share))
    };
    let mut way = Vec::new();
    let steps = 10_u8;
    let heights = (0..=steps).map(|step| {
        let share = f32::from(step) / f32::from(steps);
        waist + (crotch + 0.05 - waist) * share
    });
    // The flap in front comes over the upper edge of the band.
    let edge = waist + 0.5 * BAND * narrow(cloth.size.y) + OVER_EDGE;
    for height in std::iter::once(edge).chain(heights.clone()) {
        way.push(on(height, Face::Front)?);
    }
    let middle = way.last().map_or(0.0, |place| place.z);
    let mut back = Vec::new();
    for height in heights {
        back.push(on(height, Face::Back)?);
    }
    let behind = back.last().map_or(0.0, |place| place.z);
    way.push(Vec3::new(aside, crotch - GAP, 0.5 * (middle + behind)));
    way.extend(back.into_iter().rev());
    Some(way)
}
