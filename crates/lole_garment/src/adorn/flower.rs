//! Flowers: a plumeria to string, a hibiscus to wear, a small one for wreaths.

use std::f32::consts::TAU;

use glam::{Affine3A, Quat, Vec3};

use super::blade::Petal;
use super::chosen::real;
use super::shape::Shape;

/// Petals around `+Y`, the face of the flower towards it.
fn whorl(petal: &Shape, count: usize, turn: f32) -> Shape {
    let mut flower = Shape::default();
    for one in 0..count {
        let around = Quat::from_axis_angle(Vec3::Y, TAU * real(one) / real(count) + turn);
        flower.add(petal, &Affine3A::from_quat(around));
    }
    flower
}

/// A plumeria of a radius [m]: five petals turned like a pinwheel around a heart.
pub(crate) fn plumeria(radius: f32, flower: Vec3, heart: Vec3) -> Shape {
    let petal = Petal {
        length: radius,
        width: 1.18 * radius,
        cup: 0.50,
        lean: 0.35,
        ruffle: 0.0,
        colors: [heart, flower.lerp(heart, 0.18), flower],
    };
    whorl(&petal.shape([3, 2]), 5, 0.0)
}

/// A hibiscus of a radius [m]: broad ruffled petals and a long column of stamens.
pub(crate) fn hibiscus(radius: f32, petals: usize, [flower, heart, stamens]: [Vec3; 3]) -> Shape {
    // Fewer petals are broader.
    let width = (TAU / real(petals.max(1)) * 1.05).min(1.25) * radius;
    let petal = Petal {
        length: 1.04 * radius,
        width,
        cup: 0.34,
        lean: 0.30,
        ruffle: 0.035,
        colors: [heart, flower * 0.88, flower],
    };
    let mut shape = whorl(&petal.shape([5, 6]), petals, 0.0);
    let column = Shape::turned(
        6,
        &[
            ([0.035 * radius, 0.0], heart),
            ([0.028 * radius, 0.45 * radius], heart.lerp(stamens, 0.5)),
            ([0.055 * radius, 0.62 * radius], stamens),
            ([0.060 * radius, 0.86 * radius], stamens),
            ([0.0, 0.93 * radius], stamens),
        ],
    );
    shape.add(
        &column,
        &Affine3A::from_quat(Quat::from_axis_angle(Vec3::X, 0.22)),
    );
    shape
}

/// A small full flower of a radius [m], two whorls of petals.
pub(crate) fn rosette(radius: f32, flower: Vec3, heart: Vec3) -> Shape {
    let petal = |share: f32, cup: f32| Petal {
        length: share * radius,
        width: 0.85 * share * radius,
        cup,
        lean: 0.2,
        ruffle: 0.0,
        colors: [heart, flower * 0.92, flower],
    };
    let mut shape = whorl(&petal(1.0, 0.25).shape([2, 2]), 6, 0.0);
    shape.add(
        &whorl(&petal(0.66, 0.7).shape([2, 2]), 5, 0.4),
        &Affine3A::from_translation(Vec3::Y * (0.06 * radius)),
    );
    shape
}
