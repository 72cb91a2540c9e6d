//! The ʻuliʻuli: a gourd rattle under a disc of feathers, its handle in the fist.

use std::f32::consts::TAU;

use glam::{Affine3A, Quat, Vec3};
use lole_body::Side;
use lole_pattern::DraftError;

use super::blade::Petal;
use super::body::bone_alone;
use super::chosen::{Chosen, chance, real};
use super::grip::{Grip, Palm};
use super::shape::{Shape, affine};
use super::{Finish, Made, Wearer};
use crate::document::WornTemplate;

/// Half the flesh of a palm, thickness of the handle and room for the fist [m], of the mean woman.
const HALF_PALM: f32 = 0.014;
const HANDLE: f32 = 0.026;
const FIST: f32 = 0.095;
/// Length of a feather over the disc's radius, and feathers to a ring.
const FEATHER: f32 = 0.50;
const FEATHERS: usize = 38;

/// Where the feathers look: to whoever watches, and a little up.
const FEATHERS_FACE: Vec3 = Vec3::new(0.0, 0.5, 0.85);

pub(super) fn make(worn: &WornTemplate, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen(worn);
    let skeleton = &wearer.dancer.skeleton;
    let size = (wearer.dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.25);
    let sides: &[Side] = if chosen.count("rattle_count") < 2 {
        &[Side::Right]
    } else {
        &[Side::Right, Side::Left]
    };
    let [gourd, feathers] = rattle(&chosen, size);
    let mut made = Made::default();
    for &side in sides {
        let palm = Palm::new(skeleton, side, HALF_PALM * size);
        // The gourd lies beside the little finger, the feathers beyond the thumb.
        let up = -palm.to_little;
        let axes = [palm.along, up, palm.along.cross(up)];
        let place = affine(axes, palm.center + palm.out * (0.5 * HANDLE * size));
        let hand = bone_alone(palm.hand);
        for (shape, finish) in [(&gourd, Finish::Wood), (&feathers, Finish::Feather)] {
            let mut held = Shape::default();
            held.add(shape, &place);
            made.surfaces.push(held.ridden(finish, hand));
        }
        made.grips.push(Grip {
            side,
            thickness: HANDLE * size,
            facing: Some(FEATHERS_FACE),
            arm: None,
        });
    }
    Ok(made)
}

/// Gourd with its handle, and the disc with its feathers, upright about the middle of the fist.
fn rattle(chosen: &Chosen<'_>, size: f32) -> [Shape; 2] {
    let radius = 0.5 * chosen.m("gourd_cm", 0.10);
    let disc = 0.5 * chosen.m("disc_cm", 0.25);
    let (half, handle) = (0.5 * FIST * size, 0.5 * HANDLE * size);
    let wood = chosen.shadow();
    let below = -half - radius * 0.92;
    let mut profile = vec![([0.0, below - radius], wood * 0.9)];
    for k in 1..10_u8 {
        let (sin, cos) = lole_geom::trig::sin_cos(std::f32::consts::PI * f32::from(k) / 10.6);
        profile.push(([radius * sin, below - radius * cos], wood));
    }
    profile.push(([handle, -half], wood * 0.7));
    profile.push(([handle * 0.85, half], wood * 0.55));
    let gourd = Shape::turned(20, &profile);
    let mut feathers = Shape::turned(
        28,
        &[
            ([0.0, half], chosen.ground() * 0.8),
            ([disc * 0.92, half + 0.004], chosen.ground()),
            ([disc, half + 0.010], chosen.ground() * 0.9),
            ([disc * 0.9, half + 0.018], chosen.ground()),
            ([0.0, half + 0.022], chosen.ground()),
        ],
    );
    let length = FEATHER * disc;
    // From the rim inwards: each ring lies on the one outside it, its color in turn.
    for (ring, (seat, color)) in [
        (0.86, chosen.flower()),
        (0.58, chosen.ground()),
        (0.30, chosen.flower()),
        (0.06, chosen.ground()),
    ]
    .into_iter()
    .enumerate()
    {
        let count = FEATHERS - 8 * ring;
        for one in 0..count {
            let feather = Petal {
                length: length * (1.0 + 0.10 * chance(one, 50 + ring)),
                width: TAU * disc * (seat + 0.45) / real(count) * 1.25,
                cup: 0.20 + 0.06 * chance(one, 60 + ring),
                lean: 0.25,
                ruffle: 0.02,
                colors: [color * 0.6, color, color * (0.95 + 0.05 * chance(one, 70))],
            };
            let around = TAU * (real(one) + 0.5 * real(ring % 2)) / real(count);
            let place = Affine3A::from_quat(Quat::from_rotation_y(around))
                * Affine3A::from_translation(Vec3::new(
                    0.0,
                    half + 0.016 + 0.008 * real(ring),
                    seat * disc,
                ));
            feathers.add(&feather.shape([3, 2]), &place);
        }
    }
    [gourd, feathers]
}
