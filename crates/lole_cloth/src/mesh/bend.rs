//! Bending: the orthotropic plate energy at every particle, by its neighbors.
//!
//! Every particle and its neighbors have at most three measures of bending, linear in the
//! positions and orthogonal to each other (`fit`), so one solution of the three is exact for the
//! star whatever the time step: `Δλ_k = -y_k / (μ_k + 1 / h²)`. Like the grid's, the constraint
//! knows no direction: rotations leave it alone, and a flat piece has none of it.

pub(crate) mod fit;

use fearless_simd::{f32x16, prelude::*};

use crate::lanes::{LANES, Scalars, Vectors, larger};
use crate::mesh::order::Batch;
use crate::mesh::particles::{Gathered, Lanes, gather, scatter, window};
use crate::mesh::strain::{self, Flat, Flats, Strain};

/// Neighbors that a star can have: of most particles, of nearly all others, and of the rest.
pub(crate) const STAR_SIZES: [usize; 3] = [6, 8, 14];

/// One particle, its neighbors, and how they measure bending.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StarSpec {
    /// The slot in the middle, then those of the neighbors.
    pub(crate) members: Vec<u32>,
    /// By neighbor.
    pub(crate) weights: Vec<[f32; 3]>,
    pub(crate) masses: [f32; 3],
    /// Triangles of the middle with its first and second, and its second and third neighbor.
    pub(crate) triangles: [Flat; 2],
    /// Where the star is not flat when nothing is bent.
    pub(crate) curve: Option<Curve>,
}

/// How a star is bent at rest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Curve {
    /// By neighbor, its weight in the slopes along warp and weft [1/m], which span one square meter for each at
    /// rest.
    pub(crate) slopes: Vec<[f32; 2]>,
    /// By measure, what it is at rest, along the normal.
    pub(crate) rests: [f32; 3],
}

/// The [`Curve`]s of sixteen stars, by lane.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
struct Curves<const N: usize> {
    slopes: [[[f32; LANES]; 2]; N],
    rests: [[f32; LANES]; 3],
}

/// Sixteen stars that are bent at rest.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
pub(crate) struct BentBatch<const N: usize> {
    stars: StarBatch<N>,
    curves: Curves<N>,
}

impl<const N: usize> BentBatch<N> {
    pub(crate) fn new(batch: &Batch, stars: &[&StarSpec]) -> Self {
        let curve = |star: usize| stars[star].curve.as_ref();
        let slope = |neighbor: usize, way: usize| {
            batch.column(0.0, |star| {
                let slopes = curve(star).and_then(|curve| curve.slopes.get(neighbor));
                slopes.map_or(0.0, |slopes| slopes[way])
            })
        };
        let rest = |measure: usize| {
            batch.column(0.0, |star| {
                curve(star).map_or(0.0, |curve| curve.rests[measure])
            })
        };
        Self {
            stars: StarBatch::new(batch, stars),
            curves: Curves {
                slopes: std::array::from_fn(|neighbor| [0, 1].map(|way| slope(neighbor, way))),
                rests: [0, 1, 2].map(rest),
            },
        }
    }

    /// Works out, once, what resists.
    pub(crate) fn resist(&mut self, inv_masses: &[Scalars], made_for: (f32, Strain)) {
        self.stars.resist(inv_masses, made_for);
    }
}

impl<const N: usize> Curves<N> {
    /// Takes from the measures what they are at rest.
    #[inline(always)]
    fn take_rest<S: Simd>(
        &self,
        simd: S,
        (middle, neighbors): (&Gathered<S>, &[Gathered<S>; N]),
        measures: &mut [Vectors<S>; 3],
    ) {
        let zero = f32x16::splat(simd, 0.0);
        let none = Vectors {
            x: zero,
            y: zero,
            z: zero,
        };
        let mut slopes = [none; 2];
        for (neighbor, weights) in neighbors.iter().zip(&self.slopes) {
            let offset = neighbor.place.sub(middle.place);
            for (slope, weight) in slopes.iter_mut().zip(weights) {
                *slope = slope.add(offset.scale(f32x16::load_array_ref(simd, weight)));
            }
        }
        let normal = slopes[0].cross(slopes[1]);
        // A star that is pressed together turns its normal at a touch: the smaller it is, the less it counts.
        let one = f32x16::splat(simd, 1.0);
        let normal = normal.scale(one / larger(normal.dot(normal), one).sqrt());
        for (measure, rest) in measures.iter_mut().zip(&self.rests) {
            *measure = measure.sub(normal.scale(f32x16::load_array_ref(simd, rest)));
        }
    }
}

/// Sixteen stars that share no particle, of at most `N` neighbors each.
///
/// Laid out in the order in which it is read: the processor fetches ahead what follows.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
pub(crate) struct StarBatch<const N: usize> {
    base: u32,
    middle: Lanes,
    neighbors: [Lanes; N],
    /// By neighbor and measure.
    weights: [[[f32; LANES]; 3]; N],
    /// By measure `μ` [1/s²]; once that is worked out for substeps of one length (`resist`),
    /// `1 / (μ + 1 / h²)` in s².
    shares: [[f32; LANES]; 3],
    triangles: [Flats; 2],
}

impl<const N: usize> StarBatch<N> {
    pub(crate) fn new(batch: &Batch, stars: &[&StarSpec]) -> Self {
        let member = |place: usize| batch.lanes(|star| stars[star].members.get(place).copied());
        let weight = |neighbor: usize, measure: usize| {
            batch.column(0.0, |star| {
                let weights = stars[star].weights.get(neighbor);
                weights.map_or(0.0, |weights| weights[measure])
            })
        };
        Self {
            base: batch.base,
            middle: member(0),
            neighbors: std::array::from_fn(|neighbor| member(neighbor + 1)),
            weights: std::array::from_fn(|neighbor| {
                [0, 1, 2].map(|measure| weight(neighbor, measure))
            }),
            shares: [0, 1, 2].map(|measure| batch.column(0.0, |star| stars[star].masses[measure])),
            triangles: [0, 1].map(|index| Flats::new(batch, |star| stars[star].triangles[index])),
        }
    }
}

impl<const N: usize> StarBatch<N> {
    /// Works out, once, what resists; `inv_square` is one over the substep squared [1/s²].
    pub(crate) fn resist(&mut self, inv_masses: &[Scalars], (inv_square, strain): (f32, Strain)) {
        for share in self.shares.iter_mut().flatten() {
            *share = 1.0 / (*share + inv_square);
        }
        let of = |lanes: &Lanes| lanes.inv_masses(self.base, inv_masses);
        let middle = of(&self.middle);
        let [first, second, third] = [0, 1, 2].map(|place| of(&self.neighbors[place]));
        self.triangles[0].resist([middle, first, second], strain);
        self.triangles[1].resist([middle, second, third], strain);
    }
}

/// Solves every star once.
#[inline(always)]
pub(crate) fn solve<S: Simd, const N: usize>(
    simd: S,
    particles: &mut [f32],
    batches: &[StarBatch<N>],
) {
    for batch in batches {
        solve_batch(simd, particles, (batch, None));
    }
}

/// Solves every star that is bent at rest once.
#[inline(always)]
pub(crate) fn solve_bent<S: Simd, const N: usize>(
    simd: S,
    particles: &mut [f32],
    batches: &[BentBatch<N>],
) {
    for batch in batches {
        solve_batch(simd, particles, (&batch.stars, Some(&batch.curves)));
    }
}

#[inline(always)]
fn solve_batch<S: Simd, const N: usize>(
    simd: S,
    particles: &mut [f32],
    (batch, curves): (&StarBatch<N>, Option<&Curves<N>>),
) {
    let Some(particles) = window(particles, batch.base) else {
        return;
    };
    let zero = f32x16::splat(simd, 0.0);
    let mut middle = gather(simd, particles, &batch.middle);
    let mut neighbors = [middle; N];
    let none = Vectors {
        x: zero,
        y: zero,
        z: zero,
    };
    let mut measures = [none; 3];
    for (neighbor, (lanes, weights)) in
        (neighbors.iter_mut()).zip(batch.neighbors.iter().zip(&batch.weights))
    {
        *neighbor = gather(simd, particles, lanes);
        let offset = neighbor.place.sub(middle.place);
        for (measure, weight) in measures.iter_mut().zip(weights) {
            *measure = measure.add(offset.scale(f32x16::load_array_ref(simd, weight)));
        }
    }
    if let Some(curves) = curves {
        curves.take_rest(simd, (&middle, &neighbors), &mut measures);
    }
    for (measure, share) in measures.iter_mut().zip(&batch.shares) {
        *measure = measure.scale(f32x16::load_array_ref(simd, share));
    }
    let mut sum = none;
    for (neighbor, weights) in neighbors.iter_mut().zip(&batch.weights) {
        let mut push = none;
        for (measure, weight) in measures.iter().zip(weights) {
            push = push.add(measure.scale(f32x16::load_array_ref(simd, weight)));
        }
        sum = sum.add(push);
        neighbor.place = neighbor.place.sub(push.scale(neighbor.inv_mass));
    }
    middle.place = middle.place.add(sum.scale(middle.inv_mass));
    let mut corners = [middle, neighbors[0], neighbors[1]];
    strain::project(simd, &mut corners, &batch.triangles[0]);
    let [middle, first, second] = corners;
    neighbors[0] = first;
    let mut corners = [middle, second, neighbors[2]];
    strain::project(simd, &mut corners, &batch.triangles[1]);
    let [middle, second, third] = corners;
    neighbors[1] = second;
    neighbors[2] = third;
    for (neighbor, lanes) in neighbors.iter().zip(&batch.neighbors) {
        scatter(*neighbor, particles, lanes);
    }
    scatter(middle, particles, &batch.middle);
}
