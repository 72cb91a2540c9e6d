//! How two pieces of cloth that are nearer than they may be part: at a limited speed, without a
//! push beyond undoing their approach, and held by friction.

use glam::Vec3;

/// Fastest that overlapping folds part [m/s], beyond undoing their approach.
const PARTING_SPEED: f32 = 2.0;

/// Share of a shallow overlap that parts in one solution: springs that hold folds together answer
/// a greater one with jitter.
const PARTING_SHARE: f32 = 0.7;

/// Farthest that parting moves a particle, over what the two sides part: a corner that alone is free, at
/// the far end of a triangle with two pinned ones, would be thrown away by the lever. Where all corners
/// are free it is 1.4 at most.
pub(crate) const FARTHEST_LEVER: f32 = 2.0;

/// Below this squared length [m²] two points have no direction between them.
pub(crate) const DEGENERATE_SQUARED: f32 = 1.0e-14;

/// Two points of cloth that are nearer than they may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touching {
    /// From the first to the second [m].
    pub(crate) gap: Vec3,
    /// How the second has moved relative to the first in the substep [m].
    pub(crate) slip: Vec3,
    /// Unit vector from the first to the second when they were found: what has gone through goes back
    /// to that side.
    pub(crate) side: Vec3,
    /// Distance that they keep [m].
    pub(crate) diameter: f32,
}

/// What the second of two touching points does relative to the first [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parting {
    /// The whole of what it does, friction included.
    pub(crate) change: Vec3,
    /// Unit vector along which they part.
    pub(crate) normal: Vec3,
    /// How far of the way along it gives no speed.
    pub(crate) quiet: f32,
}

impl Touching {
    /// How they part in a substep of `h` [s]; `None` where they may stay.
    pub(crate) fn part(self, friction: f32, h: f32) -> Option<Parting> {
        let Self {
            gap,
            slip,
            side,
            diameter,
        } = self;
        let squared = gap.length_squared();
        let along_side = gap.dot(side);
        let has_gone_through = along_side <= 0.0 || squared < DEGENERATE_SQUARED;
        let (normal, distance) = if has_gone_through {
            (side, along_side)
        } else {
            let distance = squared.sqrt();
            (gap / distance, distance)
        };
        let separation = slip.dot(normal);
        let overlap = diameter - distance;
        let parting = if along_side <= 0.0 {
            PARTING_SPEED * h
        } else {
            (PARTING_SPEED * h).min(PARTING_SHARE * overlap)
        };
        let depth = overlap.min(parting - separation);
        if depth <= 0.0 {
            return None;
        }
        let tangential = slip - normal * separation;
        let slip_squared = tangential.length_squared();
        let limit = friction * depth;
        let held = if slip_squared <= limit * limit {
            1.0
        } else {
            limit / slip_squared.sqrt()
        };
        Some(Parting {
            change: normal * depth - tangential * held,
            normal,
            quiet: (depth - (-separation).max(0.0)).max(0.0),
        })
    }
}
