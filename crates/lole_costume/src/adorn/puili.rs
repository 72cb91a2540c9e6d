//! Pūʻili: bamboo split into strips beyond the handle, one in each hand.

use std::f32::consts::TAU;

use glam::Vec3;
use lole_body::Side;
use lole_geom::trig;
use lole_pattern::DraftError;

use super::body::bone_alone;
use super::chosen::{Chosen, chance, real, whole};
use super::grip::{Grip, Palm};
use super::shape::{Shape, affine};
use super::{Finish, Made, Wearer};
use crate::document::WornTemplate;

/// Half the flesh of the mean woman's palm [m].
const HALF_PALM: f32 = 0.014;
/// Where sticks point: up and away from her, so that none goes through her.
const AWAY: Vec3 = Vec3::new(0.0, 0.5, 0.85);
/// How far the strips spread at their ends, over the radius.
const SPREAD: f32 = 0.22;

pub(super) fn make(worn: &WornTemplate, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen(worn);
    let skeleton = &wearer.dancer.skeleton;
    let size = (wearer.dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.25);
    let sides: &[Side] = if chosen.count("stick_count") < 2 {
        &[Side::Right]
    } else {
        &[Side::Right, Side::Left]
    };
    let thickness = chosen.m("diameter_cm", 0.044);
    let stick = stick(&chosen, thickness);
    let mut made = Made::default();
    for &side in sides {
        let palm = Palm::new(skeleton, side, HALF_PALM * size);
        // It leaves the fist beside the index finger, leaning towards the fingertips.
        let up = (-palm.to_little + palm.along * 0.45).normalize_or(Vec3::Y);
        let across = (palm.along - up * palm.along.dot(up)).normalize_or(Vec3::X);
        let place = affine(
            [across, up, across.cross(up)],
            palm.center + palm.out * (0.45 * thickness),
        );
        let mut held = Shape::default();
        held.add(&stick, &place);
        made.surfaces
            .push(held.ridden(Finish::Wood, bone_alone(palm.hand)));
        made.grips.push(Grip {
            side,
            thickness,
            facing: Some(AWAY),
            arm: None,
        });
    }
    Ok(made)
}

/// The stick, upright about the middle of its handle.
fn stick(chosen: &Chosen<'_>, thickness: f32) -> Shape {
    let [length, handle] =
        [("length_cm", 0.508), ("handle_cm", 0.127)].map(|(key, usual)| chosen.m(key, usual));
    let radius = 0.5 * thickness;
    let around = f64::from(TAU * radius);
    let strips = whole(around / f64::from(chosen.m("strip_cm", 0.006).max(1e-3))).clamp(5, 60);
    let bamboo = chosen.ground();
    let (low, node) = (-0.5 * handle, 0.5 * handle);
    let mut shape = Shape::turned(
        18,
        &[
            ([0.0, low], bamboo * 0.7),
            ([radius, low], bamboo * 0.8),
            ([radius, low + 0.004], bamboo),
            ([radius, node - 0.006], bamboo),
            ([radius * 1.07, node - 0.002], bamboo * 0.75),
            ([radius * 1.07, node + 0.002], bamboo * 0.75),
            ([radius, node + 0.006], bamboo),
        ],
    );
    let top = low + length;
    for one in 0..strips {
        let angle = TAU * real(one) / real(strips);
        let half = 0.36 * TAU / real(strips);
        let splay = SPREAD * (1.0 + 0.6 * chance(one, 81));
        let sway = 0.10 * chance(one, 82);
        let end = top - 0.02 * length * (1.0 + chance(one, 83));
        let light = 1.0 + 0.10 * chance(one, 84);
        // A strip with its two narrow sides, bent outwards towards its end.
        let strip = Shape::sheet([5, 3], |along, across| {
            let out = 1.0 + splay * along * along;
            let inside = if !(0.1..=0.9).contains(&across) {
                0.82
            } else {
                1.0
            };
            let side = if across < 0.5 { -half } else { half };
            let (sin, cos) = trig::sin_cos(angle + side + sway * along * along);
            let reach = radius * out * inside;
            let place = Vec3::new(reach * sin, node + (end - node) * along, reach * cos);
            let shade = if inside < 1.0 { 0.62 } else { light };
            (place, (bamboo * shade).clamp(Vec3::ZERO, Vec3::ONE))
        });
        shape.add(&strip, &glam::Affine3A::IDENTITY);
    }
    shape
}
