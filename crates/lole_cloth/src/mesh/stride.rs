//! Strides: particles several cells apart along a yarn may not be farther apart than the yarn
//! between them is long.
//!
//! They carry tension across many cells in one pass, conserve momentum and leave folds alone, as on
//! the grid. A mesh seldom has a second particle on the same yarn: the one nearest to it is
//! taken, and what shear may lengthen the way between the two is allowed.

use fearless_simd::{f32x16, prelude::*};
use glam::Vec2;

use crate::SolverConfig;
use crate::constraint::INV_MASS_FLOOR;
use crate::constraint::pull::Pull;
use crate::lanes::{LANES, narrow};
use crate::mesh::model::MeshModel;
use crate::mesh::order::{Batch, into_batches};
use crate::mesh::particles::{Lanes, gather, scatter, window};
use crate::mesh::rest::Rest;
use crate::mesh::tether::Ways;
use crate::mesh::yarn::WeldedSurface;

/// Shear [rad] up to which a stride leaves the cloth alone.
const SHEAR_ALLOWED: f32 = 0.3;

/// Farthest that a stride may be off its yarn, as a tangent.
pub(super) const SLANT_MAX: f32 = 0.2;

/// Shares of a stride between which the true distance may lie.
pub(super) const REACH: [f32; 2] = [0.7, 1.3];

/// Strides of a piece, with the settings that they were made for.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Strides {
    made_for: [Vec<u32>; 2],
    batches: Vec<StrideBatch>,
}

/// Two slots, and the longest distance between them [m].
type Pair = ([u32; 2], f32);

/// Sixteen pairs that share no particle.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
struct StrideBatch {
    base: u32,
    ends: [Lanes; 2],
    /// Inverse square of the longest distance [1/m²]; 0 where there is no pair.
    inv_squares: [f32; LANES],
}

impl Strides {
    /// Prepares the strides of `config`; nothing is done where they are those of the last step.
    pub(crate) fn set(&mut self, model: &MeshModel, config: &SolverConfig) {
        if self.made_for == [config.row_strides.clone(), config.column_strides.clone()] {
            return;
        }
        self.made_for = [config.row_strides.clone(), config.column_strides.clone()];
        self.batches.clear();
        let pairs_of: Box<dyn Fn(u32, Vec2) -> Vec<Pair>> = match model.rest() {
            Rest::Plane(flat) => {
                let search = Search::new(model, flat);
                Box::new(move |stride, yarn| search.pairs(stride, yarn))
            }
            Rest::Welded(welded) => {
                let surface = WeldedSurface {
                    topology: model.topology(),
                    welded,
                };
                Box::new(move |stride, yarn| traced_pairs(model, surface, stride, yarn))
            }
        };
        let mut levels: Vec<(u32, Vec2)> = (config.row_strides.iter().map(|&s| (s, Vec2::X)))
            .chain(config.column_strides.iter().map(|&s| (s, Vec2::Y)))
            .collect();
        levels.sort_by_key(|&(stride, _)| std::cmp::Reverse(stride));
        for (stride, yarn) in levels {
            let pairs = pairs_of(stride, yarn);
            let lists: Vec<&[u32]> = pairs.iter().map(|(ends, _)| &ends[..]).collect();
            // A pair too far apart in memory is left out: strides help, and are not needed.
            let batches = into_batches(&lists, model.slots.count).unwrap_or_default();
            self.batches
                .extend(batches.iter().map(|batch| StrideBatch::new(batch, &pairs)));
        }
    }
}

impl StrideBatch {
    fn new(batch: &Batch, pairs: &[Pair]) -> Self {
        Self {
            base: batch.base,
            ends: [0, 1].map(|end| batch.lanes(|pair| Some(pairs[pair].0[end]))),
            inv_squares: batch.column(0.0, |pair| 1.0 / (pairs[pair].1 * pairs[pair].1)),
        }
    }
}

/// Two particles so far apart [m] that lie off a yarn by this tangent.
fn pair(model: &MeshModel, ends: [u32; 2], (length, slant): (f32, f32)) -> Pair {
    // Yarns at a slant `t` to the way: shear `γ` lengthens it by `γ t / (1 + t²)`.
    let allowed = 1.0 + SHEAR_ALLOWED * slant / (1.0 + slant * slant);
    (model.slots.of(ends), length * allowed)
}

/// For every particle of a surface without a plane its partner along the yarn.
fn traced_pairs(
    model: &MeshModel,
    surface: WeldedSurface<'_>,
    stride: u32,
    yarn: Vec2,
) -> Vec<Pair> {
    #[expect(clippy::cast_precision_loss, reason = "a stride is far below 2^24")]
    let reach = stride as f32 * model.spacing();
    let pinned = &model.spec().pinned;
    let partner_of = |particle: u32| {
        let partner = surface.partner(particle, yarn.as_dvec2(), f64::from(reach))?;
        let is_held = pinned[particle as usize] && pinned[partner.particle as usize];
        let way = (partner.length, partner.slant);
        (!is_held).then(|| pair(model, [particle, partner.particle], way))
    };
    let particles = 0..narrow(model.particle_count());
    let mut pairs: Vec<Pair> = particles.filter_map(partner_of).collect();
    pairs.sort_by_key(|&([first, second], _)| first.min(second));
    pairs
}

/// Particles of the flat piece by where they lie.
struct Search<'a> {
    model: &'a MeshModel,
    flat: &'a [Vec2],
    ways: Ways<'a>,
    /// Mean distance of neighbors, and side of a cell [m].
    spacing: f32,
    low: Vec2,
    columns: usize,
    /// First entry of every cell, and one more.
    starts: Vec<u32>,
    particles: Vec<u32>,
}

impl<'a> Search<'a> {
    fn new(model: &'a MeshModel, flat: &'a [Vec2]) -> Self {
        let low = flat.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let high = flat.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        let spacing = model.spacing();
        let cell = |point: Vec2| ((point - low) / spacing).as_uvec2();
        let last = cell(high);
        let columns = last.x as usize + 1;
        let place = |point: Vec2| cell(point).y as usize * columns + cell(point).x as usize;
        let mut order: Vec<(usize, u32)> = flat.iter().map(|&p| place(p)).zip(0_u32..).collect();
        order.sort_unstable();
        let cell_count = columns * (last.y as usize + 1);
        let mut starts = vec![0; cell_count + 1];
        for &(cell, _) in &order {
            starts[cell + 1] += 1;
        }
        for cell in 0..cell_count {
            starts[cell + 1] += starts[cell];
        }
        Self {
            model,
            flat,
            ways: Ways::new(flat, model.topology()),
            spacing,
            low,
            columns,
            starts,
            particles: order.into_iter().map(|(_, particle)| particle).collect(),
        }
    }

    /// For every particle its partner along the yarn: both slots, and the longest distance [m].
    fn pairs(&self, stride: u32, yarn: Vec2) -> Vec<Pair> {
        #[expect(clippy::cast_precision_loss, reason = "a stride is far below 2^24")]
        let reach = stride as f32 * self.spacing;
        let mut pairs: Vec<Pair> = (0_u32..)
            .zip(self.flat)
            .filter_map(|(particle, &from)| {
                let (partner, slant) = self.partner(from, reach, yarn)?;
                if !self.ways.sees(particle, partner) {
                    return None;
                }
                let pinned = &self.model.spec().pinned;
                if pinned[particle as usize] && pinned[partner as usize] {
                    return None;
                }
                let length = from.distance(self.flat[partner as usize]);
                Some(pair(self.model, [particle, partner], (length, slant)))
            })
            .collect();
        pairs.sort_by_key(|&([first, second], _)| first.min(second));
        pairs
    }

    /// The particle nearest to the yarn about `reach` from a point, and how far off it is.
    fn partner(&self, from: Vec2, reach: f32, yarn: Vec2) -> Option<(u32, f32)> {
        let across = yarn.perp();
        let middle = from + yarn * reach;
        let half = yarn * (reach * (REACH[1] - 1.0)) + across.abs() * (SLANT_MAX * reach);
        let mut best: Option<(u32, f32)> = None;
        for particle in self.in_box(middle - half, middle + half) {
            let offset = self.flat[particle as usize] - from;
            let along = offset.dot(yarn);
            let slant = (offset.dot(across) / along).abs();
            let fits = REACH[0] * reach <= along && along <= REACH[1] * reach && slant <= SLANT_MAX;
            // Among those on the yarn, what is nearest to the reach.
            let score = slant + 0.02 * ((along / reach) - 1.0).abs();
            if fits && best.is_none_or(|(_, least)| score < least) {
                best = Some((particle, score));
            }
        }
        let (particle, _) = best?;
        let offset = self.flat[particle as usize] - from;
        Some((particle, (offset.dot(across) / offset.dot(yarn)).abs()))
    }

    fn in_box(&self, low: Vec2, high: Vec2) -> impl Iterator<Item = u32> + '_ {
        let rows = (self.starts.len() - 1) / self.columns;
        // Negative numbers become 0.
        let first = ((low - self.low) / self.spacing).as_uvec2();
        let last = ((high - self.low) / self.spacing).as_uvec2();
        let (left, right) = (first.x as usize, (last.x as usize + 1).min(self.columns));
        let outside = high.x < self.low.x || high.y < self.low.y || right <= left;
        let rows = if outside {
            0..0
        } else {
            first.y as usize..(last.y as usize + 1).min(rows)
        };
        rows.flat_map(move |row| {
            let [start, end] = [left, right].map(|column| self.starts[row * self.columns + column]);
            self.particles[start as usize..end as usize].iter().copied()
        })
    }
}

/// Solves every stride once, the longest first.
#[inline(always)]
pub(crate) fn solve<S: Simd>(simd: S, particles: &mut [f32], strides: &Strides) {
    let one = f32x16::splat(simd, 1.0);
    let pull = Pull::new(1.0);
    for batch in &strides.batches {
        let Some(particles) = window(particles, batch.base) else {
            continue;
        };
        let mut first = gather(simd, particles, &batch.ends[0]);
        let mut second = gather(simd, particles, &batch.ends[1]);
        let offset = second.place.sub(first.place);
        let squared = offset.dot(offset) * f32x16::load_array_ref(simd, &batch.inv_squares);
        if !one.simd_lt(squared).any_true() {
            continue;
        }
        let sum = first.inv_mass + second.inv_mass + INV_MASS_FLOOR;
        let factor = pull.taut_factor(simd, squared) / sum;
        first.place = first.place.add(offset.scale(factor * first.inv_mass));
        second.place = second.place.sub(offset.scale(factor * second.inv_mass));
        scatter(first, particles, &batch.ends[0]);
        scatter(second, particles, &batch.ends[1]);
    }
}
