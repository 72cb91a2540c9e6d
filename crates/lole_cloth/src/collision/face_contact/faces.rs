//! Triangles of one or several pieces of cloth, and what decides how near they may come: what never
//! changes.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::Vec2;

use crate::collision::placement::Placement;
use crate::lanes::{LANES, Scalars, narrow};
use lole_geom::triangle_grid::{blend, nearest_barycentric};

/// How far a vertex is from the edge that faces it, as a share of the way to the nearer end: in a
/// triangle of three equal sides 0.87, in narrower ones less.
const ACROSS: f32 = 0.8;

/// Stands for what is not there.
pub(super) const ABSENT: u32 = u32::MAX;

/// How far particles of a piece lie apart on the cloth.
#[derive(Clone, Copy)]
pub(crate) enum FlatShape<'a> {
    /// By where they lie in the plane [m].
    Plane(&'a [Vec2]),
    /// By particle, what is near, ascending, and how far [m]: what is not named is far.
    Near(&'a [Vec<(u32, f32)>]),
}

/// One piece of cloth.
pub(crate) struct FacePiece<'a> {
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Distance of two particles in the flat piece [m].
    pub(crate) flat_distance: Box<dyn Fn([u32; 2]) -> f32 + 'a>,
    /// Particles in the flat piece [m]; `None` where the piece meets itself by a law of its own.
    pub(crate) flat_positions: Option<FlatShape<'a>>,
    pub(crate) placement: &'a dyn Placement,
    pub(crate) inv_masses: &'a [Scalars],
    /// By particle, the pin that it hangs from and the cloth between [m]; empty where nothing is
    /// pinned.
    pub(crate) pins: Vec<(u32, f32)>,
    /// By particle, whether it is sewn to another; empty where none is.
    pub(crate) is_sewn: Vec<bool>,
    pub(crate) particle_count: usize,
}

/// What contact knows of a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FaceParticle {
    pub(crate) piece: u32,
    pub(crate) slot: u32,
    pub(crate) inv_mass: f32,
    /// Where it lies in the flat piece [m]; of a piece without a plane nowhere in particular.
    flat: Vec2,
    /// Cloth between it and the nearest seam [m]; infinite where there is none.
    pub(crate) from_seam: f32,
    /// The pin that it hangs from, [`ABSENT`] where there is none, and the cloth between [m].
    pub(crate) pin: u32,
    pub(crate) from_pin: f32,
}

/// Triangles of one or several pieces, particles numbered piece by piece.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Faces {
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) particles: Vec<FaceParticle>,
    /// First particle of every piece.
    pub(crate) starts: Vec<u32>,
    /// Whether its triangles meet its own particles here, by piece.
    pub(crate) meets_itself: Vec<bool>,
    /// Length of an edge on the mean [m].
    pub(crate) edge_length: f32,
    ring_starts: Vec<u32>,
    rings: Vec<u32>,
    /// Of pieces without a plane, by particle, what is near on the cloth, ascending, and how far [m].
    near_starts: Vec<u32>,
    near: Vec<(u32, f32)>,
    has_plane: Vec<bool>,
}

impl Faces {
    pub(crate) fn new(pieces: &[FacePiece<'_>]) -> Self {
        let mut faces = Self::default();
        let (mut length, mut edge_count) = (0.0_f64, 0_u32);
        for (index, piece) in (0_u32..).zip(pieces) {
            let first = narrow(faces.particles.len());
            faces.starts.push(first);
            faces.meets_itself.push(piece.flat_positions.is_some());
            let (plane, near) = match piece.flat_positions {
                Some(FlatShape::Plane(plane)) => (Some(plane), None),
                Some(FlatShape::Near(near)) => (None, Some(near)),
                None => (None, None),
            };
            faces.has_plane.push(near.is_none());
            let neighbors = neighbors(piece);
            for (particle, ring) in (0_u32..).zip(&neighbors) {
                for &neighbor in ring.iter().filter(|&&neighbor| particle < neighbor) {
                    length += f64::from((piece.flat_distance)([particle, neighbor]));
                    edge_count += 1;
                }
            }
            let from_seam = from_seam(piece, &neighbors);
            for particle in 0..piece.particle_count {
                let (vector, lane) = piece.placement.slot(particle);
                let (pin, from_pin) = piece.pins.get(particle).copied().unwrap_or((ABSENT, 0.0));
                let flat = plane.map(|flat| flat[particle]);
                faces.near_starts.push(narrow(faces.near.len()));
                let near = near.into_iter().flat_map(|near| &near[particle]);
                (faces.near).extend(near.map(|&(other, length)| (first + other, length)));
                faces.particles.push(FaceParticle {
                    piece: index,
                    slot: narrow(vector * LANES + lane),
                    inv_mass: piece.inv_masses[vector].0[lane],
                    flat: flat.unwrap_or_default(),
                    from_seam: from_seam[particle],
                    pin: if pin == ABSENT { ABSENT } else { first + pin },
                    from_pin,
                });
                faces.ring_starts.push(narrow(faces.rings.len()));
                let ring = neighbors[particle].iter();
                faces.rings.extend(ring.map(|&neighbor| first + neighbor));
            }
            let triangles = piece.triangles.iter();
            (faces.triangles).extend(triangles.map(|corners| corners.map(|corner| first + corner)));
        }
        faces.ring_starts.push(narrow(faces.rings.len()));
        faces.near_starts.push(narrow(faces.near.len()));
        #[expect(clippy::cast_possible_truncation, reason = "a mean length")]
        let edge_length = (length / f64::from(edge_count.max(1))) as f32;
        faces.edge_length = edge_length;
        faces
    }

    /// How far a vertex and a triangle of one piece lie apart on the cloth [m]: in the plane exactly; on a
    /// surface without one a little less than the way to the nearest corner, and infinite where that is
    /// far.
    pub(super) fn flat_gap(&self, vertex: u32, corners: [u32; 3]) -> f32 {
        let one = &self.particles[vertex as usize];
        if self.has_plane[one.piece as usize] {
            let flat = corners.map(|corner| self.particles[corner as usize].flat.extend(0.0));
            let point = one.flat.extend(0.0);
            return point.distance(blend(flat, nearest_barycentric(point, flat)));
        }
        if corners.contains(&vertex) {
            return 0.0;
        }
        let [start, end] = [0, 1].map(|next| self.near_starts[vertex as usize + next] as usize);
        let near = &self.near[start..end];
        let way = |corner: u32| {
            let found = near.binary_search_by_key(&corner, |&(other, _)| other);
            found.map_or(f32::INFINITY, |place| near[place].1)
        };
        ACROSS * corners.map(way).into_iter().fold(f32::INFINITY, f32::min)
    }

    /// Neighbors of a particle.
    pub(crate) fn ring(&self, particle: u32) -> &[u32] {
        let [start, end] = [0, 1].map(|next| self.ring_starts[particle as usize + next] as usize);
        &self.rings[start..end]
    }
}

/// By particle, those it shares an edge with, ascending.
fn neighbors(piece: &FacePiece<'_>) -> Vec<Vec<u32>> {
    let mut neighbors = vec![Vec::new(); piece.particle_count];
    for &[a, b, c] in &piece.triangles {
        for [one, other] in [[a, b], [b, c], [c, a]] {
            neighbors[one as usize].push(other);
            neighbors[other as usize].push(one);
        }
    }
    for ring in &mut neighbors {
        ring.sort_unstable();
        ring.dedup();
    }
    neighbors
}

/// By particle, how much cloth lies between it and the nearest seam [m], along edges (Dijkstra
/// 1959).
fn from_seam(piece: &FacePiece<'_>, neighbors: &[Vec<u32>]) -> Vec<f32> {
    let mut lengths = vec![f32::INFINITY; piece.particle_count];
    let mut queue = BinaryHeap::new();
    let sewn = (0_u32..).zip(&piece.is_sewn).filter(|(_, sewn)| **sewn);
    for (particle, _) in sewn {
        lengths[particle as usize] = 0.0;
        queue.push(Reverse((0_u32, particle)));
    }
    while let Some(Reverse((bits, particle))) = queue.pop() {
        // Bits of a number that is not negative have its order.
        let length = lengths[particle as usize];
        if length.to_bits() < bits {
            continue;
        }
        for &next in &neighbors[particle as usize] {
            let beyond = length + (piece.flat_distance)([particle, next]);
            if beyond < lengths[next as usize] {
                lengths[next as usize] = beyond;
                queue.push(Reverse((beyond.to_bits(), next)));
            }
        }
    }
    lengths
}
