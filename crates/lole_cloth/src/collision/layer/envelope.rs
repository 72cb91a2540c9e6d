//! The outline of what is worn inside, as a surface that the next garment meets like skin.
//!
//! Gathers are deeper than what lies over them can follow: an outer skirt rests on the crests. The
//! envelope is how far the inner garments stand out from the axis of the trunk, by height and
//! direction, bridged from crest to crest. It is smooth, lies outside of every particle it was made
//! of, and moves from frame to frame, so that contact with skin is contact with cloth worn inside.

use std::ops::Range;

use glam::Vec3;
use lole_geom::Surfel;

use super::wall::{self, LEVEL, LEVELS, SECTORS, Trunk, Wall, around, bin, from_axis};

/// Sectors to either side that are bridged: about a gather's width at the hips, half of a fold's at
/// the hem.
const BRIDGE: usize = 3;

/// Radius of the bend with which cloth goes over an edge [m], and how many levels away it still counts.
const ROUND: f32 = 0.04;
const ROUND_LEVELS: usize = 3;
/// How much of the bend is given back [m], so that what lies farthest is not cut off between two heights.
const ROUND_OUT: f32 = 0.0004;

/// How far below and above cloth an outline is made for it [m]: farther than it moves in a frame, with room.
const AROUND: f32 = 0.18;

/// The place that is farthest from the axis in a bin.
#[derive(Debug, Clone, Copy, Default)]
struct Crest {
    /// Distance from the axis [m]; 0 where nothing is worn.
    radius: f32,
    /// Over the axis' point [m].
    height: f32,
}

impl Crest {
    /// How far from the axis cloth is at another height that goes over it in a bend [m]; 0 where nothing is worn.
    fn bent_at(&self, height: f32) -> f32 {
        let apart = self.height - height;
        let bent = self.radius + ROUND_OUT - apart * apart * (0.5 / ROUND);
        if 0.0 < self.radius { bent } else { 0.0 }
    }
}

/// How far garments stand out; its room is kept from frame to frame.
#[derive(Debug, Clone)]
pub struct Envelope {
    trunk: Trunk,
    /// Heights between which something may meet it [m].
    heights: Range<f32>,
    /// What is farthest from the axis; shape `[LEVELS, SECTORS]`.
    farthest: Vec<Crest>,
    /// Farthest distance from the axis [m], 0 where nothing is worn; shape `[LEVELS, SECTORS]`.
    radii: Vec<f32>,
    /// Farthest distance from the axis [m], bridged from crest to crest; shape `[LEVELS, SECTORS]`.
    bridged: Vec<f32>,
    /// Outward direction of every sector, where forward is `z`.
    directions: Vec<Vec3>,
}

impl Default for Envelope {
    fn default() -> Self {
        Self {
            trunk: Trunk::default(),
            heights: f32::NEG_INFINITY..f32::INFINITY,
            farthest: vec![Crest::default(); LEVELS * SECTORS],
            radii: Vec::new(),
            bridged: Vec::new(),
            directions: wall::directions(),
        }
    }
}

impl Envelope {
    /// Begins anew around a trunk: nothing is worn yet.
    pub fn begin(&mut self, trunk: Trunk) {
        self.begin_around(trunk, &[]);
    }

    /// The same, for cloth that lies at these places [m] and meets nothing far below or above of them; for any
    /// where there are none.
    pub fn begin_around(&mut self, trunk: Trunk, outer: &[Vec3]) {
        self.trunk = trunk;
        self.farthest.fill(Crest::default());
        let none = f32::INFINITY..f32::NEG_INFINITY;
        let heights = outer.iter().fold(none, |heights, place| {
            heights.start.min(place.y)..heights.end.max(place.y)
        });
        self.heights = if outer.is_empty() {
            f32::NEG_INFINITY..f32::INFINITY
        } else {
            heights.start - AROUND..heights.end + AROUND
        };
    }

    /// Puts on the `triangles` between `positions` [m].
    pub fn put_on(&mut self, triangles: &[[u32; 3]], positions: &[Vec3]) {
        let farthest = &mut self.farthest;
        let cloth = (triangles, positions);
        wall::each_point(self.trunk, cloth, &self.heights, |_, point| {
            let farthest = &mut farthest[point.bin];
            if farthest.radius < point.radius {
                *farthest = Crest {
                    radius: point.radius,
                    height: point.height,
                };
            }
        });
    }

    /// Adds the surface, a surfel for every bin, `inset` [m] inside of it.
    pub fn add_surfels(&mut self, inset: f32, surfels: &mut Vec<Surfel>) {
        self.round();
        self.bridge();
        let wall = Wall {
            trunk: self.trunk,
            radii: &self.bridged,
            directions: &self.directions,
        };
        wall.add_surfels(inset, surfels);
    }

    /// How far a place is outside of what is worn, after [`Self::add_surfels`], and the way out [m];
    /// `None` where nothing is worn.
    #[must_use]
    pub fn clearance(&self, place: Vec3) -> Option<(f32, Vec3)> {
        let local = self.trunk.local(place);
        let radius = *self.bridged.get(bin(local)?)?;
        let outward = (place - self.trunk.axis).with_y(0.0).try_normalize()?;
        (0.0 < radius).then(|| (from_axis(local) - radius, outward))
    }

    /// Rounds what is farthest at every height, so that an outline goes along with cloth and does not step from
    /// one height to the next when an edge comes by.
    fn round(&mut self) {
        self.radii.clear();
        for level in 0..LEVELS {
            let height = wall::height_of(level) + 0.5 * LEVEL;
            let near = level.saturating_sub(ROUND_LEVELS)..(level + ROUND_LEVELS + 1).min(LEVELS);
            let mut ring = [0.0_f32; SECTORS];
            for other in near {
                let others = &self.farthest[other * SECTORS..(other + 1) * SECTORS];
                for (radius, other) in ring.iter_mut().zip(others) {
                    *radius = radius.max(other.bent_at(height));
                }
            }
            self.radii.extend(ring);
        }
    }

    /// Spans what lies between crests, outside of everything worn: the mean of as many farthest
    /// places as each of them looked at.
    fn bridge(&mut self) {
        let mut crests = [0.0_f32; SECTORS];
        self.bridged.clear();
        for ring in self.radii.chunks(SECTORS) {
            for (sector, crest) in crests.iter_mut().enumerate() {
                *crest = around(sector, BRIDGE).fold(0.0, |most, near| most.max(ring[near]));
            }
            let mean = |sector: usize| {
                let near = || around(sector, BRIDGE).map(|near| crests[near]);
                let worn = || near().filter(|&r| 0.0 < r);
                if crests[sector] == 0.0 {
                    return 0.0;
                }
                #[expect(clippy::cast_precision_loss, reason = "sectors are few")]
                let count = worn().count() as f32;
                worn().sum::<f32>() / count
            };
            self.bridged.extend((0..SECTORS).map(mean));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::wall::NOWHERE;
    use super::*;

    /// A pleated tube of 400 columns: radius 0.25 m and ±0.02 m, from 0.1 m above the axis' point to
    /// 0.5 m below it.
    fn pleats(trunk: Trunk) -> (Vec<[u32; 3]>, Vec<Vec3>) {
        let (columns, rows) = (400_u16, 41_u16);
        let side = Vec3::Y.cross(trunk.forward);
        let place = |row: u16, column: u16| {
            let angle = f32::from(column) * std::f32::consts::TAU / f32::from(columns);
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            let radius = 0.25 + 0.02 * lole_geom::trig::sin_cos(40.0 * angle).0;
            let height = 0.1 - 0.015 * f32::from(row);
            trunk.axis + (side * cos + trunk.forward * sin) * radius + Vec3::Y * height
        };
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| place(row, column)));
        let at = |row: u16, column: u16| u32::from(row * columns + column % columns);
        let cells = (0..rows - 1).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let halves = cells.flat_map(|(row, column)| {
            let [first, right] = [at(row, column), at(row, column + 1)];
            let [below, last] = [at(row + 1, column), at(row + 1, column + 1)];
            [[first, right, last], [first, last, below]]
        });
        (halves.collect(), places.collect())
    }

    fn enveloped(trunk: Trunk) -> (Vec<Surfel>, Vec<Vec3>) {
        let (triangles, positions) = pleats(trunk);
        let mut envelope = Envelope::default();
        envelope.begin(trunk);
        envelope.put_on(&triangles, &positions);
        let mut surfels = Vec::new();
        envelope.add_surfels(0.0, &mut surfels);
        (surfels, positions)
    }

    #[test]
    fn crests_are_bridged_and_nothing_worn_stands_out() {
        let trunk = Trunk {
            axis: Vec3::new(0.1, 0.9, -0.2),
            forward: Vec3::Z,
        };
        let (surfels, positions) = enveloped(trunk);
        let worn: Vec<&Surfel> = surfels.iter().filter(|s| s.position != NOWHERE).collect();
        // It goes over its two edges in a bend.
        assert_eq!(worn.len(), (41 + 2 * ROUND_LEVELS) * SECTORS);
        for surfel in &worn {
            let arm = surfel.position - trunk.axis;
            let radius = from_axis(arm);
            let outward = arm.with_y(0.0) / radius;
            let beyond = (arm.y - 0.1).max(-0.5 - arm.y);
            if beyond < -2.0 * LEVEL {
                assert!((radius - 0.27).abs() < 0.003, "{radius} m");
                assert!(0.99 < surfel.normal.dot(outward), "{}", surfel.normal);
                continue;
            }
            // What is farthest in a level lies anywhere in it.
            let bent = |beyond: f32| 0.27 - beyond * beyond * (0.5 / ROUND);
            let most = bent(beyond.max(0.0)) + 0.003;
            let least = bent(beyond.max(0.0) + 0.5 * LEVEL) - 0.003;
            assert!((least..most).contains(&radius), "{radius} m at {}", arm.y);
            assert!(0.0 < surfel.normal.dot(outward), "{}", surfel.normal);
        }
        for &position in &positions {
            let near = worn.iter().min_by(|a, b| {
                let [a, b] = [a, b].map(|surfel| surfel.position.distance(position));
                a.total_cmp(&b)
            });
            let height = near.map(|near| near.normal.dot(position - near.position));
            assert!(height.is_some_and(|height| height < 0.001), "{height:?}");
        }
    }

    #[test]
    fn the_surface_turns_and_goes_with_the_trunk() {
        let at = |axis: Vec3, forward: Vec3| enveloped(Trunk { axis, forward }).0;
        let still = at(Vec3::ZERO, Vec3::Z);
        let moved = at(Vec3::new(1.0, 0.5, 0.0), Vec3::X);
        for (still, moved) in still.iter().zip(&moved) {
            if still.position == NOWHERE {
                continue;
            }
            let turned = |v: Vec3| Vec3::new(v.z, v.y, -v.x);
            let place = turned(still.position) + Vec3::new(1.0, 0.5, 0.0);
            assert!(place.distance(moved.position) < 1e-3, "{place}");
            assert!(0.999 < turned(still.normal).dot(moved.normal));
        }
    }

    #[test]
    fn a_place_is_as_far_outside_as_it_is_from_the_crests() {
        let trunk = Trunk {
            axis: Vec3::new(0.1, 0.9, -0.2),
            forward: Vec3::X,
        };
        let (triangles, positions) = pleats(trunk);
        let mut envelope = Envelope::default();
        envelope.begin(trunk);
        envelope.put_on(&triangles, &positions);
        assert_eq!(envelope.clearance(trunk.axis + Vec3::X * 0.3), None);
        envelope.add_surfels(0.0, &mut Vec::new());
        for (radius, height) in [(0.3, 0.0), (0.2, -0.2), (0.35, -0.4)] {
            let place = trunk.axis + Vec3::new(0.6, 0.0, 0.8) * radius + Vec3::Y * height;
            let (clearance, outward) = envelope.clearance(place).unwrap();
            assert!((clearance - (radius - 0.27)).abs() < 0.003, "{clearance}");
            assert!(outward.distance(Vec3::new(0.6, 0.0, 0.8)) < 1e-5);
        }
        let above = trunk.axis + Vec3::new(0.3, 0.3, 0.0);
        assert_eq!(envelope.clearance(above), None);
    }

    #[test]
    fn nothing_worn_is_nowhere_and_as_many_surfels() {
        let mut envelope = Envelope::default();
        let mut surfels = Vec::new();
        envelope.put_on(
            &[[0, 1, 2]],
            &[Vec3::NAN, Vec3::INFINITY, Vec3::splat(50.0)],
        );
        envelope.add_surfels(0.0, &mut surfels);
        assert_eq!(surfels.len(), LEVELS * SECTORS);
        assert!(surfels.iter().all(|surfel| surfel.position == NOWHERE));
    }
}
