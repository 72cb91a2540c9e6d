//! One cloth that is wrapped and tied: rules that say where its points lie.

use std::cell::OnceCell;

use glam::{DVec2, Vec3};
use lole_geom::narrow;
use lole_pattern::{Measures, Pattern};

use super::form::Form;
use super::hung::Hung;

/// A rule for one rectangle.
#[derive(Debug)]
pub struct Wrap {
    /// Where a point of the cloth lies before it comes to rest [m].
    pub(crate) place: fn(&Cloth<'_>, DVec2) -> Option<Vec3>,
    /// How far from the skin a point lies at least [m]: more, the more cloth there is below it.
    pub(crate) gap: fn(&Cloth<'_>, DVec2) -> f32,
    /// Points of the cloth that are knotted to each other and held there.
    pub(crate) knots: fn(&Cloth<'_>) -> Vec<[DVec2; 2]>,
    /// Whether a point is tied or tucked so firmly that it goes with the skin; the last number is the
    /// distance of particles [m].
    pub(crate) is_pinned: fn(&Cloth<'_>, DVec2, f64) -> bool,
    /// The way on which such a point is led from where it lies to where it is tied [m]; empty where it stays.
    pub(crate) led: fn(&Cloth<'_>, DVec2) -> Vec<Vec3>,
    /// What that goes with.
    pub(crate) carrier: Carrier,
}

/// What carries the pinned part of a cloth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Carrier {
    /// The skin below it.
    Skin,
    /// The trunk as a tape around it, below the arms.
    Tape,
    /// The trunk as it is girded: layers keep as they were laid over each other, between legs that go their
    /// own way too.
    Girded,
}

/// A rectangle and whom it is wrapped around. `x` runs along it from 0, `y` up from 0.
pub(crate) struct Cloth<'a> {
    pub(crate) form: &'a Form<'a>,
    pub(crate) measures: &'a Measures,
    /// Length and height [m].
    pub(crate) size: DVec2,
    /// A way that its rule has looked for once [m].
    pub(crate) way: OnceCell<Option<Vec<Vec3>>>,
    /// How it hangs, found once.
    hung: OnceCell<Option<Hung>>,
}

impl<'a> Cloth<'a> {
    pub(crate) fn new(form: &'a Form<'a>, (pattern, measures): (&Pattern, &'a Measures)) -> Self {
        let drawn = pattern
            .pieces
            .first()
            .map(|piece| piece.stitching_polygon(1.0e-3));
        let size = drawn.map_or(DVec2::ZERO, |polygon| {
            let bounds = polygon.bounds();
            DVec2::new(bounds.width(), bounds.height())
        });
        Self {
            form,
            measures,
            size,
            way: OnceCell::new(),
            hung: OnceCell::new(),
        }
    }

    /// Height of the armpits above the floor [m].
    pub(crate) fn armpit(&self) -> f32 {
        self.measures.armpit_height.to_m_f32()
    }

    /// The trunk as this cloth hangs around it from a height down [m]; `None` where there is no trunk.
    pub(crate) fn hung(&self, top: f32) -> Option<&Hung> {
        let lowest = top - narrow(self.size.y);
        let hung = self
            .hung
            .get_or_init(|| Hung::new(self.form.dancer, [top, lowest]));
        hung.as_ref()
    }
}

/// A point at a share of the length of a way.
pub(crate) fn along(way: &[Vec3], share: f32) -> Vec3 {
    let lengths = way.windows(2).map(|pair| pair[0].distance(pair[1]));
    let total: f32 = lengths.clone().sum();
    let mut left = share.clamp(0.0, 1.0) * total;
    for (pair, length) in way.windows(2).zip(lengths) {
        if left <= length {
            return pair[0].lerp(pair[1], left / length.max(1.0e-6));
        }
        left -= length;
    }
    way.last().copied().unwrap_or(Vec3::ZERO)
}
