//! How what crossed at the start of a step already is drawn out: the contour along which the surface
//! intersects itself becomes shorter (Volino and Magnenat-Thalmann 2006).

use glam::Vec3;

use super::{CrossingRepair, Fixed, UNTANGLING_ROUNDS, crossed_at};
use crate::collision::crossing::Crossing;
use crate::collision::parting::FARTHEST_LEVER;

/// Speed at which a tangle is drawn out [m/s].
const UNTANGLING_SPEED: f32 = 0.2;

impl CrossingRepair {
    /// Draws out what crossed at the start already; whether there is any.
    pub(super) fn draw_out_tangles(&mut self, fixed: Fixed<'_>, starts: &[Vec3]) -> bool {
        let mut any = false;
        for index in 0..self.finder.crossings.len() {
            let crossing = self.finder.crossings[index];
            if crossed_at(starts, &crossing) {
                self.draw_out(fixed, &crossing);
                any = true;
            }
        }
        any
    }

    fn draw_out(&mut self, fixed: Fixed<'_>, crossing: &Crossing) {
        let opposites = fixed.surface.opposites(crossing.ends);
        let Some(direction) = contour_gradient(&self.positions, crossing, opposites) else {
            return;
        };
        let weights = [
            1.0 - crossing.along,
            crossing.along,
            -crossing.weights.x,
            -crossing.weights.y,
            -crossing.weights.z,
        ];
        let [a, b, c] = crossing.corners;
        let particles = [crossing.ends[0], crossing.ends[1], a, b, c];
        let inv_masses = particles.map(|particle| Self::inv_mass(fixed, particle));
        let (mut sum, mut most) = (0.0, 0.0_f32);
        for (weight, inv_mass) in weights.iter().zip(inv_masses) {
            sum += weight * weight * inv_mass;
            most = most.max(weight.abs() * inv_mass);
        }
        let sum = sum.max(most / FARTHEST_LEVER);
        if sum <= 0.0 {
            return;
        }
        let push = direction * (UNTANGLING_SPEED * fixed.dt / (f32::from(UNTANGLING_ROUNDS) * sum));
        for ((particle, weight), inv_mass) in particles.into_iter().zip(weights).zip(inv_masses) {
            self.shift(particle, push * (weight * inv_mass));
        }
    }
}

/// Unit vector along which the edge must move against the triangle for the contour of the
/// intersection to become shorter: the sum over the faces of the edge of `R - 2 (E·R) / (E·N) N`,
/// with the direction `R` of the contour into the face, the edge's `E` and the triangle's normal
/// `N`.
fn contour_gradient(
    positions: &[Vec3],
    crossing: &Crossing,
    opposites: [Option<u32>; 2],
) -> Option<Vec3> {
    let [start, end] = crossing.ends.map(|end| positions[end as usize]);
    let [a, b, c] = crossing.corners.map(|corner| positions[corner as usize]);
    let edge = (end - start).normalize_or_zero();
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let steepness = edge.dot(normal);
    let mut gradient = Vec3::ZERO;
    for opposite in opposites.into_iter().flatten() {
        let into_face = positions[opposite as usize] - start;
        let face_normal = edge.cross(into_face);
        let mut contour = face_normal.cross(normal).normalize_or_zero();
        let inward = into_face - edge * into_face.dot(edge);
        if contour.dot(inward) < 0.0 {
            contour = -contour;
        }
        gradient += contour * steepness - normal * (2.0 * edge.dot(contour));
    }
    let gradient = if steepness < 0.0 { -gradient } else { gradient };
    gradient.try_normalize()
}
