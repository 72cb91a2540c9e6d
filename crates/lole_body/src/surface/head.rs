//! How large a head is, and a child's: its girth by stature.
//!
//! The measured children of the table have heads that are small for their statures, and a line
//! through them does not reach a child of four. The girths are rounded estimates near the medians that
//! growth charts give girls of the ages whose median statures these are.

use glam::Vec3;
use lole_geom::trig;

use super::pchip::Pchip;
use super::warp::smooth_step;
use crate::sections::{HeadTable, Sections, Tube};

/// Girth of the head [cm] by stature [cm], about the medians of girls: 3 years 8 months, 5 years, 8 years, 12
/// years.
const GIRTH: [[f32; 2]; 4] = [[100.0, 49.1], [110.0, 50.1], [128.0, 51.8], [151.0, 53.6]];
/// How far above the head's center its girth is taken, of the crown's height over it: over the
/// brows and the back of the head.
const GIRTH_UP: f32 = 0.28;
/// How far the center rises with the size of the head: the jaw grows less than the skull, and the
/// neck stays free.
const RISE: f32 = 0.055;

/// How far the neck's girth follows the head's.
const NECK_FOLLOWS: f32 = 0.6;
/// Mean radius [m] of the mean woman's head.
const MEAN_RADIUS: f32 = 0.0916;

/// Size of a head over the mean woman's: features lie at the same places of heads of one size,
/// whatever the stature.
pub(super) fn size(head: &HeadTable) -> f32 {
    let count = head.radii.iter().map(Vec::len).sum::<usize>().max(1);
    head.radii.iter().flatten().sum::<f32>() / count as f32 / MEAN_RADIUS
}

/// Makes the head of a child as large as heads of her stature are; by how much.
pub(super) fn grow(body: &mut Sections) -> f32 {
    let wanted = Pchip::new(&GIRTH).at(100.0 * body.height) / 100.0;
    let factor = wanted / girth(&body.head);
    for radius in (body.head.radii.iter_mut().chain(&mut body.head.face)).flatten() {
        *radius *= factor;
    }
    // The neck grows with the head, fully at its top.
    let neck = [body.level("neckbase"), body.level("neckmid")];
    let torso = body
        .tubes
        .iter_mut()
        .filter(|tube| tube.tube == Tube::Torso);
    for ring in torso.flat_map(|tube| &mut tube.rings) {
        let share = smooth_step((ring.center.y - neck[0]) / (neck[1] - neck[0]).max(1.0e-3));
        for radius in &mut ring.radii {
            *radius *= 1.0 + NECK_FOLLOWS * (factor - 1.0) * share;
        }
    }
    let rise = Vec3::Y * (RISE * (factor - 1.0) * body.height / 1.28);
    body.head.center += rise;
    factor
}

/// Length [m] around the head at the height of the brows, ears left out.
fn girth(head: &HeadTable) -> f32 {
    // The table ends with the crown at 90°.
    let crown = head.radii.first().and_then(|row| row.last()).copied();
    let up = GIRTH_UP * crown.unwrap_or(0.0);
    let points: Vec<Vec3> = (head.radii.iter().enumerate())
        .map(|(step, row)| {
            let (sin, cos) = trig::sin_cos((3.0 * step as f32).to_radians());
            let out = outward(row, up);
            Vec3::new(sin * out, 0.0, cos * out)
        })
        .collect();
    2.0 * points
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .sum::<f32>()
}

/// How far out [m] a column of latitudes lies at a height over the center.
fn outward(row: &[f32], up: f32) -> f32 {
    let place = |index: usize| {
        let (sin, cos) = trig::sin_cos((-75.0 + 3.0 * index as f32).to_radians());
        [row[index] * cos, row[index] * sin]
    };
    for index in 1..row.len() {
        let ([out_a, up_a], [out_b, up_b]) = (place(index - 1), place(index));
        if up_a <= up && up < up_b {
            return out_a + (out_b - out_a) * (up - up_a) / (up_b - up_a);
        }
    }
    0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_has_the_girth_of_its_circle() {
        let radius = 0.08_f32;
        let ball = HeadTable {
            center: Vec3::ZERO,
            radii: vec![vec![radius; 56]; 61],
            face: Vec::new(),
        };
        let circle = std::f32::consts::TAU * radius * (1.0 - GIRTH_UP * GIRTH_UP).sqrt();
        assert!((girth(&ball) / circle - 1.0).abs() < 0.01);
    }
}
