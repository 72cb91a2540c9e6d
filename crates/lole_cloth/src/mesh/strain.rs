//! Stretch along warp and weft, and shear, of every triangle.
//!
//! A triangle's deformation gradient has two columns, what became of the unit vectors along the
//! warp and the weft: `[f_u f_v] = [x_1 - x_0, x_2 - x_0] D⁻¹`, with `D` the same edges in the
//! flat piece. The energy per area is `½ (Y_u (|f_u| - 1)² + Y_v (|f_v| - 1)² + G (f_u·f_v)²)`:
//! three constraints (Müller, Chentanez, Kim and Macklin 2014, "Strain Based Dynamics") with the
//! compliance of XPBD. Yarns lie in any direction across the mesh.

use fearless_simd::{f32x16, prelude::*};
use glam::DVec2;
use lole_geom::narrow;

use crate::constraint::pull::Pull;
use crate::lanes::{LANES, Scalars, Vectors, larger};
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

/// Sixteen triangles in the flat piece, and how they resist.
///
/// What resists is worked out for substeps of one length (`resist`): divisions are dear.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub(crate) struct Flats {
    inverse: [[f32; LANES]; 4],
    /// One over what resists stretch along warp and weft, mass and compliance together [kg·m²];
    /// 0 before that is known.
    inv_sums: [[f32; LANES]; 2],
    /// Compliance of shear over the substep squared [1/(kg·m²)]; before that is known one over the
    /// area [1/m²].
    shear: [f32; LANES],
}

impl Flats {
    /// The triangle of every constraint of a batch.
    pub(crate) fn new(batch: &Batch, flat: impl Fn(usize) -> Flat) -> Self {
        Self {
            inverse: [0, 1, 2, 3].map(|entry| batch.column(0.0, |t| flat(t).inverse[entry])),
            inv_sums: [[0.0; LANES]; 2],
            shear: batch.column(Flat::NONE.per_area, |t| flat(t).per_area),
        }
    }

    /// Works out, once, what resists with corners of these inverse masses [1/kg].
    pub(crate) fn resist(&mut self, inv_masses: [[f32; LANES]; 3], strain: Strain) {
        for lane in 0..LANES {
            let [u1, u2, v1, v2] = self.inverse.map(|entry| entry[lane]);
            let [w0, w1, w2] = inv_masses.map(|inv_mass| inv_mass[lane]);
            let sum = |second: f32, third: f32| {
                let first = second + third;
                (first * first * w0 + second * second * w1) + third * third * w2
            };
            let per_area = self.shear[lane];
            let [along_warp, along_weft] = strain.stretch;
            self.inv_sums[0][lane] = 1.0 / (sum(u1, u2) + per_area * along_warp);
            self.inv_sums[1][lane] = 1.0 / (sum(v1, v2) + per_area * along_weft);
            self.shear[lane] = per_area * strain.shear;
        }
    }
}

/// Sixteen triangles that share no particle.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
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

    /// Works out, once, what resists.
    pub(crate) fn resist(&mut self, inv_masses: &[Scalars], strain: Strain) {
        let of = |lanes: &Lanes| lanes.inv_masses(self.base, inv_masses);
        let [a, b, c] = &self.corners;
        self.flats.resist([of(a), of(b), of(c)], strain);
    }
}

/// What a cloth gives way by in a substep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Strain {
    /// Compliance of one square meter along warp and weft, over the substep squared [m²/kg].
    pub(crate) stretch: [f32; 2],
    /// Compliance of one square meter in shear, over the substep squared [m²/kg].
    pub(crate) shear: f32,
}

/// Solves every triangle once.
#[inline(always)]
pub(crate) fn solve<S: Simd>(simd: S, particles: &mut [f32], batches: &[StrainBatch]) {
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
        project(simd, &mut corners, &batch.flats);
        scatter(corners[0], particles, lanes_0);
        scatter(corners[1], particles, lanes_1);
        scatter(corners[2], particles, lanes_2);
    }
}

/// Solves sixteen triangles with these corners.
#[inline(always)]
pub(crate) fn project<S: Simd>(simd: S, corners: &mut [Gathered<S>; 3], flats: &Flats) {
    let pull = Pull::new(1.0);
    let one = f32x16::splat(simd, 1.0);
    // Gradients of f_u and f_v by the second and third corner; the first has minus their sums.
    let u1 = f32x16::load_array_ref(simd, &flats.inverse[0]);
    let u2 = f32x16::load_array_ref(simd, &flats.inverse[1]);
    let v1 = f32x16::load_array_ref(simd, &flats.inverse[2]);
    let v2 = f32x16::load_array_ref(simd, &flats.inverse[3]);
    let inv_sum_u = f32x16::load_array_ref(simd, &flats.inv_sums[0]);
    let inv_sum_v = f32x16::load_array_ref(simd, &flats.inv_sums[1]);
    let shear = f32x16::load_array_ref(simd, &flats.shear);
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

    let e1 = corners[1].place.sub(corners[0].place);
    let e2 = corners[2].place.sub(corners[0].place);
    let f_u = e1.scale(u1).add(e2.scale(u2));
    let f_v = e1.scale(v1).add(e2.scale(v2));
    let (q_u, q_v, angle) = (f_u.dot(f_u), f_v.dot(f_v), f_u.dot(f_v));

    // Stretch both ways at once: one hardly changes the other, for the yarns are nearly square to
    // each other. What is left of the columns is a f_u - b f_v and d f_v - e f_u.
    let g_u = pull.factor(simd, q_u) * inv_sum_u;
    let g_v = pull.factor(simd, q_v) * inv_sum_v;
    let (a, b) = (one - s_uu * g_u, s_uv * g_v);
    let (d, e) = (one - s_vv * g_v, s_uv * g_u);
    // Their squares and their product, to the last term: without those of second order what divides
    // may vanish in cloth that is torn at.
    let (u_by_u, u_by_v) = (a * q_u - b * angle, a * angle - b * q_v);
    let (v_by_u, v_by_v) = (d * angle - e * q_u, d * q_v - e * angle);
    let angle_left = d * u_by_v - e * u_by_u;
    let uv = s_uv * angle_left;
    let sum = (s_uu * (d * v_by_v - e * v_by_u) + s_vv * (a * u_by_u - b * u_by_v)) + (uv + uv);
    let g = angle_left / (larger(sum, f32x16::splat(simd, 0.0)) + shear);
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
