//! Stretch along warp and weft, and shear, of every triangle.
//!
//! A triangle's deformation gradient has two columns, what became of the unit vectors along the
//! warp and the weft: `[f_u f_v] = [x_1 - x_0, x_2 - x_0] D⁻¹`, with `D` the same edges in the
//! flat piece. The energy per area is `½ (Y_u (|f_u| - 1)² + Y_v (|f_v| - 1)² + G (f_u·f_v)²)`:
//! three constraints (Müller, Chentanez, Kim and Macklin 2014, "Strain Based Dynamics") with the
//! compliance of XPBD. Yarns lie in any direction across the mesh.

use fearless_simd::{f32x16, prelude::*};
use glam::DVec2;

use crate::constraint::pull::Pull;
use crate::lanes::{LANES, Vectors};
use crate::mesh::order::Batch;
use crate::mesh::particles::{Gathered, Lanes, gather, scatter, window};

/// What a triangle is like in the flat piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Flat {
    /// `D⁻¹` [1/m]: first the column of the warp, then that of the weft.
    inverse: [f32; 4],
    /// One over the area [1/m²].
    per_area: f32,
}

impl Flat {
    /// No triangle: nothing moves.
    pub(crate) const NONE: Self = Self {
        inverse: [0.0; 4],
        per_area: 1.0,
    };

    /// The triangle with these corners [m], counterclockwise.
    pub(crate) fn new([origin, first, second]: [DVec2; 3]) -> Self {
        let (e1, e2) = (first - origin, second - origin);
        let area = e1.perp_dot(e2);
        let inverse = [e2.y, -e1.y, -e2.x, e1.x].map(|entry| narrow(entry / area));
        Self {
            inverse,
            per_area: narrow(2.0 / area),
        }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "coefficients are worked out in f64 and used in f32"
)]
const fn narrow(value: f64) -> f32 {
    value as f32
}

/// Sixteen triangles in the flat piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Flats {
    inverse: [[f32; LANES]; 4],
    per_area: [f32; LANES],
}

impl Flats {
    /// The triangle of every constraint of a batch.
    pub(crate) fn new(batch: &Batch, flat: impl Fn(usize) -> Flat) -> Self {
        Self {
            inverse: [0, 1, 2, 3].map(|entry| batch.column(0.0, |t| flat(t).inverse[entry])),
            per_area: batch.column(Flat::NONE.per_area, |t| flat(t).per_area),
        }
    }
}

/// Sixteen triangles that share no particle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StrainBatch {
    base: u32,
    corners: [Lanes; 3],
    flats: Flats,
}

impl StrainBatch {
    /// `triangles` name slots.
    pub(crate) fn new(batch: &Batch, triangles: &[[u32; 3]], flats: &[Flat]) -> Self {
        Self {
            base: batch.base,
            corners: [0, 1, 2]
                .map(|corner| batch.lanes(|triangle| Some(triangles[triangle][corner]))),
            flats: Flats::new(batch, |triangle| flats[triangle]),
        }
    }
}

/// Moduli over the substep squared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strain {
    /// Compliance of one square meter along warp and weft, over the substep squared [m²/kg].
    pub(crate) stretch: [f32; 2],
    /// The same of shear.
    pub(crate) shear: f32,
}

/// Solves every triangle once.
#[inline(always)]
pub(crate) fn solve<S: Simd>(
    simd: S,
    particles: &mut [f32],
    batches: &[StrainBatch],
    strain: Strain,
) {
    for batch in batches {
        let Some(particles) = window(particles, batch.base) else {
            continue;
        };
        let [lanes_0, lanes_1, lanes_2] = &batch.corners;
        let mut corners = [
            gather(simd, particles, lanes_0),
            gather(simd, particles, lanes_1),
            gather(simd, particles, lanes_2),
        ];
        project(simd, &mut corners, &batch.flats, strain);
        scatter(corners[0], particles, lanes_0);
        scatter(corners[1], particles, lanes_1);
        scatter(corners[2], particles, lanes_2);
    }
}

/// Solves sixteen triangles with these corners.
#[inline(always)]
pub(crate) fn project<S: Simd>(
    simd: S,
    corners: &mut [Gathered<S>; 3],
    flats: &Flats,
    strain: Strain,
) {
    let pull = Pull::new(1.0);
    let one = f32x16::splat(simd, 1.0);
    // Gradients of f_u and f_v by the second and third corner; the first has minus their sums.
    let u1 = f32x16::load_array_ref(simd, &flats.inverse[0]);
    let u2 = f32x16::load_array_ref(simd, &flats.inverse[1]);
    let v1 = f32x16::load_array_ref(simd, &flats.inverse[2]);
    let v2 = f32x16::load_array_ref(simd, &flats.inverse[3]);
    let per_area = f32x16::load_array_ref(simd, &flats.per_area);
    let (u0, v0) = (u1 + u2, v1 + v2);
    let [w0, w1, w2] = [
        corners[0].inv_mass,
        corners[1].inv_mass,
        corners[2].inv_mass,
    ];
    let (u0w, u1w, u2w) = (u0 * w0, u1 * w1, u2 * w2);
    let (v0w, v1w, v2w) = (v0 * w0, v1 * w1, v2 * w2);
    let s_uu = (u0 * u0w + u1 * u1w) + u2 * u2w;
    let s_uv = (v0 * u0w + v1 * u1w) + v2 * u2w;
    let s_vv = (v0 * v0w + v1 * v1w) + v2 * v2w;
    let sum_u = s_uu + per_area * strain.stretch[0];
    let sum_v = s_vv + per_area * strain.stretch[1];
    let inverse = one / (sum_u * sum_v);

    let e1 = corners[1].place.sub(corners[0].place);
    let e2 = corners[2].place.sub(corners[0].place);
    let f_u = e1.scale(u1).add(e2.scale(u2));
    let f_v = e1.scale(v1).add(e2.scale(v2));
    let (q_u, q_v, angle) = (f_u.dot(f_u), f_v.dot(f_v), f_u.dot(f_v));

    // Stretch both ways at once: one hardly changes the other, for the yarns are nearly square to
    // each other. What is left of the columns is a f_u - b f_v and d f_v - e f_u.
    let g_u = pull.factor(simd, q_u) * (sum_v * inverse);
    let g_v = pull.factor(simd, q_v) * (sum_u * inverse);
    let (a, b) = (one - s_uu * g_u, s_uv * g_v);
    let (d, e) = (one - s_vv * g_v, s_uv * g_u);
    // Their products; of the squares what the other column adds is of second order.
    let angle_left = d * (a * angle - b * q_v) - e * (a * q_u - b * angle);
    let uv = s_uv * angle_left;
    let sum = (s_uu * (d * d * q_v) + s_vv * (a * a * q_u)) + (uv + uv);
    let g = angle_left / (sum + per_area * strain.shear);
    let lambda_u = f_u.scale(g_u - g * e).add(f_v.scale(g * d));
    let lambda_v = f_v.scale(g_v - g * b).add(f_u.scale(g * a));

    corners[0].place = corners[0].place.add(pushed(lambda_u, lambda_v, u0w, v0w));
    corners[1].place = corners[1].place.sub(pushed(lambda_u, lambda_v, u1w, v1w));
    corners[2].place = corners[2].place.sub(pushed(lambda_u, lambda_v, u2w, v2w));
}

#[inline(always)]
fn pushed<S: Simd>(
    lambda_u: Vectors<S>,
    lambda_v: Vectors<S>,
    by_u: f32x16<S>,
    by_v: f32x16<S>,
) -> Vectors<S> {
    lambda_u.scale(by_u).add(lambda_v.scale(by_v))
}
