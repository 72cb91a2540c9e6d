//! The hair flower: a hibiscus beside an ear.

use glam::{Affine3A, Quat, Vec3};
use lole_body::{Bone, PartKind, Side};
use lole_geom::trig;
use lole_pattern::DraftError;

use super::blade::Blade;
use super::body::{bone_alone, farthest};
use super::chosen::{Chosen, real};
use super::shape::{Shape, affine, facing};
use super::{Finish, Made, Wearer, flower};
use crate::document::WornTemplate;

/// Longitude from the front towards the side, and latitude, of the first flower [°]; the others follow
/// up and back.
const PLACE: [f32; 2] = [74.0, 16.0];
const NEXT: [f32; 2] = [30.0, 17.0];
const HEAD: &[PartKind] = &[PartKind::Skin, PartKind::Face, PartKind::Hair];

/// The side on which it is worn.
pub(super) fn side(worn: &WornTemplate) -> Side {
    match Chosen(worn).choice("side") {
        "right" => Side::Right,
        _ => Side::Left,
    }
}

pub(super) fn make(worn: &WornTemplate, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen(worn);
    let dancer = wearer.dancer;
    let joint = dancer.skeleton.joint(Bone::Head);
    let rise = dancer.landmarks.crown_height - joint.y;
    let center = joint + Vec3::new(0.0, 0.46 * rise, 0.08 * rise);
    let sign = match side(worn) {
        Side::Left => 1.0,
        Side::Right => -1.0,
    };
    let radius = 0.5 * chosen.m("diameter_cm", 0.12);
    let petals = chosen.count("petal_count");
    let colors = [chosen.flower(), chosen.shadow(), chosen.ground()];
    let one = flower::hibiscus(radius, petals, colors);
    let leaf = Blade {
        length: 1.15 * radius,
        width: 0.55 * radius,
        fold: 0.25,
        droop: 0.2,
        color: chosen.leaf(),
    };
    let mut flowers = Shape::default();
    let mut leaves = Shape::default();
    for number in 0..chosen.count("flower_count") {
        let [longitude, latitude] = [0, 1].map(|k| PLACE[k] + NEXT[k] * real(number));
        let (sin_lon, cos_lon) = trig::sin_cos(longitude.to_radians());
        let (sin_lat, cos_lat) = trig::sin_cos(latitude.min(70.0).to_radians());
        let towards = Vec3::new(sign * sin_lon * cos_lat, sin_lat, cos_lon * cos_lat);
        let reach = farthest(dancer, (center, towards), 0.985, HEAD);
        let seat = center + towards * (reach + 0.006);
        // It looks to the side and a little to the front.
        let face = (towards + Vec3::new(0.15 * sign, 0.05, 0.35)).normalize_or_zero();
        let axes = facing(Vec3::Y, face);
        let [x, y, z] = [axes[0], axes[1], axes[2]];
        let place = affine([x, y, z], seat);
        let spin = Quat::from_axis_angle(Vec3::Y, 0.9 * real(number));
        flowers.add(&one, &(place * Affine3A::from_quat(spin)));
        for (turn, down) in [(2.2_f32, 0.12_f32), (3.4, 0.16), (4.4, 0.12)] {
            let around = Quat::from_axis_angle(Vec3::Y, sign * turn);
            let under = Affine3A::from_translation(Vec3::NEG_Y * (down * radius))
                * Affine3A::from_quat(around);
            leaves.add(&leaf.varied(number).shape(3), &(place * under));
        }
    }
    let head = bone_alone(Bone::Head);
    Ok(Made {
        surfaces: vec![
            flowers.ridden(Finish::Petal, head),
            leaves.ridden(Finish::Leaf, head),
        ],
        ..Made::default()
    })
}
