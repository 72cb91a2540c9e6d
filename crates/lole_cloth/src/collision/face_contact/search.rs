//! Which vertices and triangles may touch in a step.

use std::ops::Range;

use fearless_simd::{Level, Simd, dispatch, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::triangle_grid::{blend, nearest_barycentric};
use rayon::prelude::*;

use super::faces::{FaceParticle, Faces};
use super::{Body, FaceContacts, Meeting, Pair};
use crate::collision::crossing::crossing_point;
use crate::collision::face_contact::faces::ABSENT;
use crate::collision::grid::{CellGrid, each_hit};
use crate::collision::parting::DEGENERATE_SQUARED;
use crate::lanes::{LANES, Vectors, narrow};

/// How far beyond touching candidates are kept [diameters]: folds move together, so what one gains
/// on another in a step is far less than its speed.
const MARGIN: f32 = 0.6;

/// Farthest that one piece is believed to come towards another in a step [m], besides.
const CLOSING_MAX: f32 = 0.03;

/// Of the triangles on one side of a vertex, those are kept that are as near as the nearest, or
/// farther by less than this share of the diameter: what lies behind is kept away by what lies
/// before it, and a vertex slides by less within a step.
const SLACK: f32 = 0.4;

/// Share of their distance in the flat cloth that two particles may always keep: cloth that is
/// pressed together within its plane does not touch itself.
const FLAT_SHARE: f32 = 0.8;

/// Where pins hold cloth nearer together than a diameter, contact keeps this share of their gap,
/// and what lies this much farther apart for every meter of cloth from the pins.
const PINNED_SHARE: f32 = 0.9;
const PINNED_OPENING: f32 = 0.06;

/// Edge of a cell, in distances at which a vertex is looked for, or in edges of triangles where those are longer.
const CELL_REACHES: f32 = 2.0;

/// Parts of the triangles that several threads look around. What is found is taken in the order of the triangles,
/// so that it is the same with one.
const PART_COUNT: usize = 16;

/// Fewer triangles than these are looked around before a second thread has begun.
const SHARED_MIN: usize = 1024;

/// Room for one search.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Room {
    candidates: Vec<Candidate>,
    parts: Vec<Part>,
    /// Sums of the normals of the triangles around every particle [m²].
    normals: Vec<Vec3>,
    /// Squared distance of the nearest triangle on each side of every particle [m²].
    nearest: Vec<[f32; 2]>,
    /// Particles where cloth has gone through cloth.
    is_tangled: Vec<bool>,
    /// By particle, its body or [`ABSENT`].
    body_of: Vec<u32>,
}

/// Some of the triangles, and what is found around them.
#[derive(Debug, Clone, Default, PartialEq)]
struct Part {
    triangles: Range<usize>,
    candidates: Vec<Candidate>,
    /// Last triangle that every particle was found to be near on the cloth.
    stamps: Vec<u32>,
    /// By candidate whose vertex has an edge that goes through the triangle, its place and the edge's far end.
    through: Vec<(usize, u32)>,
}

/// A vertex near a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Candidate {
    vertex: u32,
    triangle: u32,
    /// From the triangle to the vertex [m].
    gap: Vec3,
    squared: f32,
    diameter: f32,
    /// How far they may come towards each other in the step [m].
    closing: f32,
}

impl FaceContacts {
    /// Forgets all candidates.
    pub(crate) fn clear(&mut self) {
        self.pairs.clear();
    }

    /// Finds the candidates of a step of `dt` [s], by piece as `meetings` say, with every particle at
    /// `positions`. Where cloth has blown up there are none.
    pub(crate) fn find(&mut self, level: Level, faces: &Faces, meetings: &[Meeting], dt: f32) {
        self.clear();
        let radii = meetings.iter().filter_map(|meeting| meeting.radius);
        let widest = 2.0 * radii.fold(0.0, f32::max);
        if widest <= 0.0 || !self.positions.iter().all(|position| position.is_finite()) {
            return;
        }
        let reach = widest * (1.0 + MARGIN);
        // A triangle looks around in rows of cells, and sixteen of a row take no longer than one.
        let cell = CELL_REACHES * reach.max(faces.edge_length);
        self.cells.sort(&self.positions, cell);
        let search = Search {
            faces,
            meetings,
            positions: &self.positions,
            motions: Motions::new(&self.velocities, dt),
            is_tangled: &self.is_tangled,
            cells: &self.cells,
        };
        search.collect(level, &mut self.room);
        search.leave_tangles(&mut self.room);
        self.keep_nearest(faces, meetings);
    }

    /// Makes pairs of the nearest candidates.
    fn keep_nearest(&mut self, faces: &Faces, meetings: &[Meeting]) {
        let Room {
            candidates,
            normals,
            nearest,
            body_of,
            ..
        } = &mut self.room;
        let side_of = |candidate: &Candidate| {
            usize::from(0.0 <= candidate.gap.dot(normals[candidate.vertex as usize]))
        };
        nearest.clear();
        nearest.resize(faces.particles.len(), [f32::INFINITY; 2]);
        for candidate in candidates.iter() {
            let least = &mut nearest[candidate.vertex as usize][side_of(candidate)];
            *least = least.min(candidate.squared);
        }
        body_of.clear();
        body_of.resize(faces.particles.len(), ABSENT);
        self.bodies.clear();
        for candidate in candidates.iter() {
            let least = nearest[candidate.vertex as usize][side_of(candidate)];
            let limit = least.sqrt() + SLACK * (candidate.diameter + candidate.closing);
            if limit * limit < candidate.squared {
                continue;
            }
            let [a, b, c] = faces.triangles[candidate.triangle as usize];
            let members = [candidate.vertex, a, b, c];
            for member in members {
                let place = &mut body_of[member as usize];
                if *place == ABSENT {
                    *place = narrow(self.bodies.len());
                    self.bodies.push(body(&faces.particles[member as usize]));
                }
            }
            let pieces = [candidate.vertex, a].map(|p| faces.particles[p as usize].piece);
            let [one, other] = pieces.map(|piece| meetings[piece as usize].friction);
            self.pairs.push(Pair {
                bodies: members.map(|member| body_of[member as usize]),
                diameter: candidate.diameter,
                friction: 0.5 * (one + other),
                side: candidate.gap / candidate.squared.sqrt(),
            });
        }
    }
}

/// What a search looks at.
struct Search<'a> {
    faces: &'a Faces,
    meetings: &'a [Meeting],
    positions: &'a [Vec3],
    motions: Motions<'a>,
    is_tangled: &'a [bool],
    cells: &'a CellGrid,
}

impl Search<'_> {
    /// Finds the candidates, and the normals at every particle.
    fn collect(&self, level: Level, room: &mut Room) {
        let triangle_count = self.faces.triangles.len();
        let is_alone = triangle_count < SHARED_MIN || rayon::current_num_threads() == 1;
        let count = if is_alone { 1 } else { PART_COUNT };
        room.parts.resize_with(count, Part::default);
        for (index, part) in room.parts.iter_mut().enumerate() {
            part.triangles = triangle_count * index / count..triangle_count * (index + 1) / count;
        }
        let find = |part: &mut Part| {
            dispatch!(level, simd => self.look_around_all(simd, part));
            self.find_tangles(part);
        };
        if is_alone {
            room.parts.iter_mut().for_each(find);
            self.add_normals(&mut room.normals);
        } else {
            let normals = &mut room.normals;
            let parts = &mut room.parts;
            rayon::join(
                || parts.par_iter_mut().for_each(find),
                || self.add_normals(normals),
            );
        }
    }

    fn add_normals(&self, normals: &mut Vec<Vec3>) {
        normals.clear();
        normals.resize(self.positions.len(), Vec3::ZERO);
        for corners in &self.faces.triangles {
            let [a, b, c] = corners.map(|corner| self.positions[corner as usize]);
            let normal = (b - a).cross(c - a);
            for &corner in corners {
                normals[corner as usize] += normal;
            }
        }
    }

    #[inline(always)]
    fn look_around_all<S: Simd>(&self, simd: S, part: &mut Part) {
        let radii = self.meetings.iter().filter_map(|meeting| meeting.radius);
        let widest = radii.fold(0.0, f32::max);
        part.candidates.clear();
        part.stamps.clear();
        part.stamps.resize(self.positions.len(), ABSENT);
        for triangle in part.triangles.clone() {
            let corners = self.faces.triangles[triangle];
            let piece = self.faces.particles[corners[0] as usize].piece as usize;
            if let Some(radius) = self.meetings[piece].radius {
                let places = corners.map(|corner| self.positions[corner as usize]);
                let reach = (radius + widest) * (1.0 + MARGIN) + self.motions.most_closing(corners);
                let near = NearTriangle::new(places, reach);
                self.look_around(simd, (narrow(triangle), radius), &near, part);
            }
        }
    }

    fn find_tangles(&self, part: &mut Part) {
        part.through.clear();
        for (place, candidate) in part.candidates.iter().enumerate() {
            let corners = self.faces.triangles[candidate.triangle as usize];
            let far = self.edge_through(candidate.vertex, corners);
            part.through.extend(far.map(|far| (place, far)));
        }
    }

    /// Takes all candidates but those around edges that go through triangles: there nobody knows on which side he
    /// belongs, and contact would draw the cloth together and tangle it more.
    fn leave_tangles(&self, room: &mut Room) {
        let Room {
            candidates,
            parts,
            is_tangled,
            ..
        } = room;
        is_tangled.clear();
        candidates.clear();
        for part in parts {
            candidates.extend_from_slice(&part.candidates);
            for &(place, far) in &part.through {
                let candidate = &part.candidates[place];
                is_tangled.resize(self.positions.len(), false);
                let [a, b, c] = self.faces.triangles[candidate.triangle as usize];
                for member in [candidate.vertex, far, a, b, c] {
                    self.mark_around(member, is_tangled);
                }
            }
        }
        if !is_tangled.is_empty() {
            candidates.retain(|candidate| {
                let [a, b, c] = self.faces.triangles[candidate.triangle as usize];
                let mut members = [candidate.vertex, a, b, c].into_iter();
                members.any(|member| !is_tangled[member as usize])
            });
        }
    }

    fn mark_around(&self, member: u32, marks: &mut [bool]) {
        marks[member as usize] = true;
        for &neighbor in self.faces.ring(member) {
            marks[neighbor as usize] = true;
        }
    }

    /// The far end of an edge of a vertex that goes through a triangle, if there is one.
    fn edge_through(&self, vertex: u32, corners: [u32; 3]) -> Option<u32> {
        let [a, b, c] = corners.map(|corner| self.positions[corner as usize]);
        let normal = (b - a).cross(c - a);
        let start = self.positions[vertex as usize];
        let height = normal.dot(start - a);
        let ring = self.faces.ring(vertex).iter().copied();
        ring.into_iter().find(|far| {
            let end = self.positions[*far as usize];
            normal.dot(end - a) * height <= 0.0
                && !corners.contains(far)
                && crossing_point([start, end], [a, b, c]).is_some()
        })
    }

    /// Adds the vertices near a triangle.
    #[inline(always)]
    fn look_around<S: Simd>(
        &self,
        simd: S,
        (triangle, radius): (u32, f32),
        near: &NearTriangle,
        part: &mut Part,
    ) {
        for corner in self.faces.triangles[triangle as usize] {
            part.stamps[corner as usize] = triangle;
            for &neighbor in self.faces.ring(corner) {
                part.stamps[neighbor as usize] = triangle;
            }
        }
        self.cells.runs_within(near.bounds(), |run| {
            for from in run.clone().step_by(LANES) {
                let hits = near.hits(simd, self.cells, from);
                let entries = each_hit(hits, run.end - from);
                let particles = entries.map(|place| self.cells.entries[from + place].particle);
                for particle in particles {
                    let is_beside = part.stamps[particle as usize] == triangle;
                    let found = (!is_beside)
                        .then(|| self.candidate((particle, triangle), near.corners, radius));
                    part.candidates.extend(found.flatten());
                }
            }
        });
    }

    /// A vertex and a triangle, unless they are too far apart or do not meet. Not inlined into vector code: it
    /// would change kinds of instructions.
    #[inline(never)]
    fn candidate(
        &self,
        (vertex, triangle): (u32, u32),
        places: [Vec3; 3],
        radius: f32,
    ) -> Option<Candidate> {
        let position = self.positions[vertex as usize];
        let gap = position - blend(places, nearest_barycentric(position, places));
        let squared = gap.length_squared();
        let particle = &self.faces.particles[vertex as usize];
        let wide = radius + self.meetings[particle.piece as usize].radius?;
        let corners = self.faces.triangles[triangle as usize];
        let is_same = particle.piece == self.faces.particles[corners[0] as usize].piece;
        let closing = if is_same {
            0.0
        } else {
            self.motions.closing(vertex, corners, gap)
        };
        let margin = wide * MARGIN + closing;
        let reach = wide + margin;
        if reach * reach < squared || squared < DEGENERATE_SQUARED {
            return None;
        }
        if !self.may_meet(vertex, corners) {
            return None;
        }
        let diameter = self.allowed(vertex, corners, wide);
        let reach = diameter + margin;
        (squared <= reach * reach && 0.0 < diameter).then_some(Candidate {
            vertex,
            triangle,
            gap,
            squared,
            diameter,
            closing,
        })
    }

    fn may_meet(&self, vertex: u32, corners: [u32; 3]) -> bool {
        let particle = |index: u32| &self.faces.particles[index as usize];
        let piece = particle(vertex).piece;
        if piece == particle(corners[0]).piece && !self.faces.meets_itself[piece as usize] {
            return false;
        }
        let [a, b, c] = corners;
        let members = [vertex, a, b, c];
        let is_tangled = |member: u32| self.is_tangled[member as usize];
        let is_free = |member: u32| 0.0 < particle(member).inv_mass;
        (self.is_tangled.is_empty() || !members.into_iter().all(is_tangled))
            && members.into_iter().any(is_free)
    }

    /// How far a vertex and a triangle are kept apart [m]: `wide`, or less where they lie nearer to
    /// each other on the cloth, across a seam, or in the pins that they hang from.
    fn allowed(&self, vertex: u32, corners: [u32; 3], wide: f32) -> f32 {
        let particle = |index: u32| &self.faces.particles[index as usize];
        let (one, others) = (particle(vertex), corners.map(particle));
        let mut allowed = wide;
        if one.piece == others[0].piece {
            allowed = allowed.min(FLAT_SHARE * self.faces.flat_gap(vertex, corners));
        }
        for other in others {
            allowed = allowed.min(FLAT_SHARE * (one.from_seam + other.from_seam));
            if one.pin != ABSENT && other.pin != ABSENT {
                let [pin, other_pin] = [one, other].map(|p| self.positions[p.pin as usize]);
                let kept = PINNED_SHARE * pin.distance(other_pin)
                    + PINNED_OPENING * (one.from_pin + other.from_pin);
                allowed = allowed.min(kept);
            }
        }
        allowed
    }
}

/// A triangle and what is certainly too far from it.
struct NearTriangle {
    corners: [Vec3; 3],
    reach: f32,
    /// Twice its area along its normal [m²].
    normal: Vec3,
    /// The mean of its corners, and how far from there anything may lie [m].
    middle: Vec3,
    radius: f32,
}

impl NearTriangle {
    /// Of what is at most `reach` [m] from it.
    fn new([a, b, c]: [Vec3; 3], reach: f32) -> Self {
        let middle = (a + b + c) / 3.0;
        let squares = [a, b, c].map(|corner| corner.distance_squared(middle));
        Self {
            corners: [a, b, c],
            reach,
            normal: (b - a).cross(c - a),
            middle,
            radius: squares.into_iter().fold(0.0, f32::max).sqrt() + reach,
        }
    }

    fn bounds(&self) -> [Vec3; 2] {
        let [a, b, c] = self.corners;
        [a.min(b).min(c) - self.reach, a.max(b).max(c) + self.reach]
    }

    /// Which of sixteen entries may be near enough, by bits: by their distance from its plane and its middle.
    #[inline(always)]
    fn hits<S: Simd>(&self, simd: S, cells: &CellGrid, from: usize) -> u64 {
        let [x, y, z] = &cells.coordinates;
        let lanes = from..from + LANES;
        let entries = Vectors {
            x: f32x16::from_slice(simd, &x[lanes.clone()]),
            y: f32x16::from_slice(simd, &y[lanes.clone()]),
            z: f32x16::from_slice(simd, &z[lanes]),
        };
        let splat = |value: f32| f32x16::splat(simd, value);
        let from_middle = entries.sub(Vectors::splat(simd, self.middle));
        let height = from_middle.dot(Vectors::splat(simd, self.normal));
        let is_round = from_middle
            .dot(from_middle)
            .simd_le(splat(self.radius * self.radius));
        let limit = self.reach * self.reach * self.normal.length_squared();
        let is_level = (height * height).simd_le(splat(limit));
        is_round.to_bitmask() & is_level.to_bitmask()
    }
}

/// What particles do in a step if they fly on.
struct Motions<'a> {
    /// [m/s]; empty where nothing closes in on anything.
    velocities: &'a [Vec3],
    mean: Vec3,
    /// Largest difference from the mean [m/s].
    spread: f32,
    /// Duration of the step [s].
    dt: f32,
}

impl<'a> Motions<'a> {
    fn new(velocities: &'a [Vec3], dt: f32) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "a mean velocity")]
        let count = velocities.len().max(1) as f32;
        let mean = velocities.iter().sum::<Vec3>() / count;
        let squares = velocities.iter().map(|v| v.distance_squared(mean));
        Self {
            velocities,
            mean,
            spread: squares.fold(0.0, f32::max).sqrt(),
            dt,
        }
    }

    /// Farthest that anything may come towards a triangle [m].
    fn most_closing(&self, corners: [u32; 3]) -> f32 {
        if self.velocities.is_empty() {
            return 0.0;
        }
        let squares = corners.map(|p| self.velocities[p as usize].distance_squared(self.mean));
        let own = squares.into_iter().fold(0.0, f32::max).sqrt();
        ((own + self.spread) * self.dt).min(CLOSING_MAX)
    }

    /// How far a vertex comes towards a triangle that is `gap` away [m].
    fn closing(&self, vertex: u32, corners: [u32; 3], gap: Vec3) -> f32 {
        if self.velocities.is_empty() {
            return 0.0;
        }
        let [a, b, c] = corners.map(|corner| self.velocities[corner as usize]);
        let relative = self.velocities[vertex as usize] - (a + b + c) / 3.0;
        if 0.0 <= relative.dot(gap) {
            return 0.0;
        }
        (relative.length() * self.dt).min(CLOSING_MAX)
    }
}

const fn body(particle: &FaceParticle) -> Body {
    Body {
        position: Vec3::ZERO,
        inv_mass: particle.inv_mass,
        before: Vec3::ZERO,
        is_touched: false,
        quiet: Vec3::ZERO,
        has_before: false,
        piece: particle.piece,
        slot: particle.slot,
    }
}
