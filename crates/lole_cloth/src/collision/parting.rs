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

/// What the second of two touching points does relative to the first [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parting {
    /// All of it, friction included.
    pub(crate) change: Vec3,
    /// Unit vector along which they part.
    pub(crate) normal: Vec3,
    /// How much of that gives no speed.
    pub(crate) quiet: f32,
}

impl Parting {
    /// Of points `gap` apart that moved by `slip` relative to each other in a substep of `h` [s],
    /// both from the first to the second [m]. They were found on `side`, a unit vector, and keep
    /// `diameter` [m]; what has gone through goes back to that side. `None` where they may stay.
    pub(crate) fn new(
        (gap, slip): (Vec3, Vec3),
        (side, diameter): (Vec3, f32),
        friction: f32,
        h: f32,
    ) -> Option<Self> {
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
        Some(Self {
            change: normal * depth - tangential * held,
            normal,
            quiet: (depth - (-separation).max(0.0)).max(0.0),
        })
    }
}
