//! Wreaths: leaves and flowers wound onto a braided base around the head or a limb.

use std::f32::consts::TAU;

use glam::{Affine3A, Quat, Vec3};
use lole_geom::trig;

use super::blade::Blade;
use super::body::Girdle;
use super::chosen::{chance, real};
use super::shape::{Shape, affine, facing};

/// What is wound on.
pub(crate) struct Wound {
    pub(crate) leaf: Blade,
    pub(crate) leaf_count: usize,
    /// A flower whose face is towards `+Y`.
    pub(crate) flower: Shape,
    pub(crate) flower_count: usize,
    /// Radius of the braided base [m].
    pub(crate) base: f32,
}

/// Leaves, and flowers, of a wreath around a girdle.
pub(crate) fn wind(girdle: &Girdle, wound: &Wound) -> [Shape; 2] {
    let mut leaves = Shape::default();
    let base = wound.base;
    leaves.add(
        &ring(girdle, base, wound.leaf.color * 0.55),
        &Affine3A::IDENTITY,
    );
    for one in 0..wound.leaf_count {
        let share = (real(one) + 0.4 * chance(one, 11)) / real(wound.leaf_count.max(1));
        let [point, outward, along] = girdle.at(share);
        // Around the base from below over the outside to above, turn by turn.
        let around = [-1.05_f32, 0.35, -0.35, 1.05][one % 4] + 0.25 * chance(one, 12);
        let (sin, cos) = trig::sin_cos(around);
        let out = outward * cos + girdle.axis * sin;
        let seat = point + outward * (0.6 * base) + out * (0.8 * base);
        // They lie back along the wreath, the tips a little out.
        let slope = 0.30 + 0.15 * chance(one, 13);
        let along = (along + out * slope + girdle.axis * (0.30 * sin)).normalize_or_zero();
        let leaf = wound.leaf.varied(one).shape(3);
        leaves.add(&leaf, &affine(facing(along, out), seat));
    }
    let mut flowers = Shape::default();
    for one in 0..wound.flower_count {
        let share = (real(one) + 0.5 + 0.25 * chance(one, 21)) / real(wound.flower_count.max(1));
        let [point, outward, along] = girdle.at(share);
        let (sin, cos) = trig::sin_cos(0.55 * chance(one, 22));
        let out = outward * cos + girdle.axis * sin;
        let seat = point + outward * base + out * (2.9 * base);
        let [x, y, z] = facing(along, out);
        let spin = Quat::from_axis_angle(Vec3::Y, TAU * chance(one, 23));
        let place = affine([x, y, z], seat) * Affine3A::from_quat(spin);
        let size = 1.0 + 0.12 * chance(one, 24);
        flowers.add(
            &wound.flower,
            &(place * Affine3A::from_scale(Vec3::splat(size))),
        );
    }
    [leaves, flowers]
}

/// The base: a tube along the girdle, its inside on the skin.
fn ring(girdle: &Girdle, radius: f32, color: Vec3) -> Shape {
    const PARTS: usize = 48;
    const AROUND: usize = 6;
    Shape::sheet([PARTS, AROUND], |along, across| {
        let [point, outward, _] = girdle.at(along);
        let (sin, cos) = trig::sin_cos(-TAU * across);
        let out = outward * cos + girdle.axis * sin;
        (point + outward * (0.9 * radius) + out * radius, color)
    })
}
