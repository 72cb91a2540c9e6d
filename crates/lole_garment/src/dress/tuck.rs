//! What is tucked under a skirt: it rides the skin, and the skirt's band lies on it.
//!
//! Cloth between a band and the skin goes nowhere. So it is pinned to the skin below it, thinner than the
//! room that the band leaves, and neither feels the other: contact of two sheets that are both held within
//! a millimeter would be repaired in every frame and seen in none.

use glam::Vec3;

use super::form::Form;
use super::{DressError, Dressed, Ease, Kit, Pins, assembly};

/// The upper edges of the skirts that a garment is worn under, around the dancer in her stance [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bands<'a> {
    /// Points along them.
    pub edge: &'a [Vec3],
}

/// Cloth that ends in the band is held this far above its edge already [m], or it would stand out over it.
const ABOVE_EDGE: f32 = 0.015;
/// How far over the skin it is held there, and under the band [m].
const GAPS: [f32; 2] = [0.003, 0.001];
/// Below the edge, cloth is held down to here at most [m]: farther down it hangs.
const DEEPEST: f32 = 0.30;
/// And no nearer to the crotch than this, where the skin of two legs is near [m].
const ABOVE_CROTCH: f32 = 0.05;
/// Cloth that is drawn up when it is tucked in, so that it blouses and arms can be raised [m].
const BLOUSING: f32 = 0.012;
/// Directions nearer to each other than this cosine are the same way out.
const SAME_WAY: f32 = 0.995;

impl Bands<'_> {
    fn center(&self) -> Vec3 {
        self.edge.iter().sum::<Vec3>() / self.edge.len().max(1) as f32
    }

    /// Height of the highest edge in the direction of a place [m].
    fn height(&self, center: Vec3, place: Vec3) -> Option<f32> {
        let way = |point: Vec3| (point - center).with_y(0.0).normalize_or_zero();
        let outward = way(place);
        let near = (self.edge.iter()).filter(|point| SAME_WAY < outward.dot(way(**point)));
        near.map(|point| point.y).max_by(f32::total_cmp)
    }
}

/// How far each particle of the trunk lies above the bands, where it is tucked in; `None` elsewhere.
fn depths(garment: &Dressed, bands: Bands<'_>, lowest: f32) -> Vec<Option<f32>> {
    let is_on_trunk = garment.on_trunk();
    let center = bands.center();
    let places = garment.start.iter().zip(&is_on_trunk);
    let depths = places.map(|(&place, &is_on_trunk)| {
        if !is_on_trunk || place.y < lowest {
            return None;
        }
        let above = place.y - bands.height(center, place)?;
        (-DEEPEST < above && above < ABOVE_EDGE).then_some(above)
    });
    depths.collect()
}

/// Tucks what lies below the bands' edge in: a garment at rest on a dancer in her stance. Whether anything
/// was.
///
/// # Errors
/// As for a garment that is sewn.
pub(super) fn tuck(
    garment: &mut Dressed,
    kit: &mut Kit,
    (form, bands): (&Form<'_>, Bands<'_>),
) -> Result<bool, DressError> {
    let lowest = form.dancer.landmarks.crotch_height + ABOVE_CROTCH;
    let depths = depths(garment, bands, lowest);
    let mut held = garment.pins.gaps.iter().zip(&garment.pins.tied);
    let (mut particles, mut places) = (Vec::new(), Vec::new());
    let (mut gaps, mut tied) = (Vec::new(), Vec::new());
    for (particle, (depth, is_pinned)) in depths.iter().zip(&kit.spec.pinned).enumerate() {
        let was_held = is_pinned.then(|| held.next()).flatten();
        let (lift, gap, tie) = match (depth, was_held) {
            (Some(above), _) => {
                let share = (above / ABOVE_EDGE).clamp(0.0, 1.0);
                (BLOUSING, GAPS[1] + (GAPS[0] - GAPS[1]) * share, None)
            }
            (None, Some((gap, tie))) => (0.0, *gap, *tie),
            (None, None) => continue,
        };
        tied.push(tie);
        particles.push(particle);
        places.push(garment.start[particle] + Vec3::Y * lift);
        gaps.push(gap);
    }
    if depths.iter().all(Option::is_none) {
        return Ok(false);
    }
    let carried = form.carried(&places, &gaps);
    let (skin, places) = carried.ok_or(DressError::NoTrunk {
        template: kit.template,
    })?;
    for (&particle, place) in particles.iter().zip(places) {
        kit.spec.pinned[particle] = true;
        garment.start[particle] = place;
    }
    garment.rested = None;
    garment.pins = Pins { skin, gaps, tied };
    garment.assembly = assembly(kit, Ease::Worn)?;
    let is_tucked = |corner: &u32| depths[*corner as usize].is_some();
    let is_open = |corners: &&[u32; 3]| !corners.iter().all(is_tucked);
    garment.open_triangles = garment.triangles.iter().filter(is_open).copied().collect();
    // What comes out above the band stands over it, and is not in the skirt's way.
    let center = bands.center();
    let hang = garment.start.iter().map(|&place| {
        let edge = bands.height(center, place);
        edge.is_none_or(|edge| place.y < edge)
    });
    let hang: Vec<bool> = hang.collect();
    let hangs = |corner: &u32| hang[*corner as usize];
    (garment.hanging_triangles).retain(|corners| is_open(&corners) && corners.iter().all(hangs));
    garment.trunk_triangles.retain(|corners| is_open(&corners));
    Ok(true)
}
