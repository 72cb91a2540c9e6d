//! Where a surface turns so far around a particle that patches which share it may cross.

use std::ops::Range;

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;

use crate::collision::grid::each_hit;
use crate::collision::patch_tree::PatchTree;
use crate::collision::surface::{Surface, SurfaceNow};
use crate::lanes::{LANES, Points, Vectors, narrow};

/// Cosine of the angle with their sum within which all normals around a particle lie where the
/// surface is flat enough not to cross there.
const FLAT_COSINE: f32 = 0.2;

/// Cosine of the angle with their sum within which all normals around a particle lie where the surface is so
/// flat that it cannot wind around the particle twice either, unless the angles there make up 1.4 full turns:
/// a tilt widens an angle by no more than one over its cosine.
const SURELY_FLAT_COSINE: f32 = 0.7;

/// Quadrants of a full turn, and a little more for rounding.
const FULL_TURN: f32 = 4.0001;

/// Lists the patches around those particles whose bits are set.
pub(super) fn list_folded(
    surface: &Surface,
    particles: &[u32],
    folds: u64,
    folded: &mut Vec<[u32; 2]>,
) {
    for lane in each_hit(folds, particles.len()) {
        let star = surface.star(particles[lane] as usize);
        for (place, &one) in star.iter().enumerate() {
            let others = star[place + 1..].iter();
            folded.extend(others.map(|&other| [one, other]));
        }
    }
}

/// A surface that may fold, and the tree that knows how its patches are turned.
#[derive(Clone, Copy)]
pub(super) struct Turning<'a> {
    pub(super) now: SurfaceNow<'a>,
    pub(super) tree: &'a PatchTree,
}

/// Room for the normals around sixteen particles.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Stars(Vec<[Points; 2]>);

impl Stars {
    /// Lists the patches around those particles of a range where the surface folds.
    #[inline(always)]
    pub(super) fn fold<S: Simd>(
        &mut self,
        simd: S,
        turning: Turning<'_>,
        particles: Range<usize>,
        folded: &mut Vec<[u32; 2]>,
    ) {
        for start in particles.clone().step_by(LANES) {
            let mut some = [0; LANES];
            let count = LANES.min(particles.end - start);
            for (particle, place) in (start..).zip(&mut some[..count]) {
                *place = narrow(particle);
            }
            let folds = self.folds(simd, turning, &some[..count]);
            list_folded(turning.now.surface, &some[..count], folds, folded);
        }
    }

    /// Which of at most sixteen particles have normals around them that do not all lie in one
    /// half-space, and well within it, or cloth that winds around them more than once.
    #[inline(always)]
    pub(super) fn folds<S: Simd>(
        &mut self,
        simd: S,
        turning: Turning<'_>,
        particles: &[u32],
    ) -> u64 {
        self.gather(turning, particles);
        let mut sum = Vectors::splat(simd, Vec3::ZERO);
        for points in self.0.iter().flatten() {
            sum = sum.add(Vectors::load(simd, points));
        }
        let [limit, sure] = [FLAT_COSINE, SURELY_FLAT_COSINE]
            .map(|cosine| sum.dot(sum) * f32x16::splat(simd, cosine * cosine));
        let (mut flat, mut surely_flat) = (u64::MAX, u64::MAX);
        for points in self.0.iter().flatten() {
            let normal = Vectors::load(simd, points);
            let along = sum.dot(normal);
            let is_ahead = f32x16::splat(simd, 0.0).simd_le(along);
            let [is_within, is_sure] =
                [limit, sure].map(|limit| (limit * normal.dot(normal)).simd_le(along * along));
            flat &= is_ahead.to_bitmask() & is_within.to_bitmask();
            surely_flat &= is_sure.to_bitmask();
        }
        for lane in each_hit(flat & !surely_flat, particles.len()) {
            if winds_twice(turning.now, particles[lane]) {
                flat &= !(1 << lane);
            }
        }
        !flat
    }

    /// Where a star has fewer patches than others, its last stands in their place.
    #[inline(never)]
    fn gather(&mut self, turning: Turning<'_>, particles: &[u32]) {
        self.0.clear();
        for (lane, &particle) in particles.iter().enumerate() {
            let star = turning.now.surface.star(particle as usize);
            let Some(&last) = star.last() else { continue };
            while self.0.len() < star.len() {
                // Earlier lanes have nothing to add here.
                let repeated = self.0.last().copied().unwrap_or_default();
                self.0.push(repeated);
            }
            for (place, points) in self.0.iter_mut().enumerate() {
                let patch = star.get(place).copied().unwrap_or(last);
                let normals = turning.tree.normals(patch);
                points[0].set(lane, normals[0]);
                points[1].set(lane, normals[1]);
            }
        }
    }
}

/// Whether cloth whose normals around a particle lie in one half-space winds around it more than once: seen
/// along their sum, what its triangles turn through is more than a full turn.
#[cold]
#[inline(never)]
fn winds_twice(now: SurfaceNow<'_>, particle: u32) -> bool {
    let SurfaceNow { surface, positions } = now;
    let triangles = || {
        let star = surface.star(particle as usize).iter();
        star.flat_map(|&patch| surface.sides_at(patch, particle))
    };
    let at = positions[particle as usize];
    let sides = |[from, to]: [u32; 2]| [from, to].map(|corner| positions[corner as usize] - at);
    let sum: Vec3 = triangles()
        .map(sides)
        .map(|[from, to]| from.cross(to))
        .sum();
    let across = sum.any_orthogonal_vector();
    let axes = [across, sum.cross(across) / sum.length()];
    // Goes around with the angle, from 0 to 4, without the cost of one.
    let turned = |side: Vec3| {
        let [x, y] = axes.map(|axis| side.dot(axis));
        let share = y / (x.abs() + y.abs());
        if x < 0.0 { 2.0 - share } else { share }
    };
    let through = triangles().map(sides).map(|[from, to]| {
        let angle = turned(to) - turned(from);
        if angle < 0.0 { angle + 4.0 } else { angle }
    });
    // What has no direction folds.
    let is_once = through.sum::<f32>() <= FULL_TURN;
    !is_once
}
