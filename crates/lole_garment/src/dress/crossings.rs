//! Where a garment goes through itself, with its seams closed.
//!
//! What is counted is the cloth as it is sewn, before it is faired to be drawn: what is sewn together is one point, and what is gathered in
//! between lies on the side of the other cloth's triangle that runs along the seam. So that triangle is cut
//! there, and both cloths have those points in common: they touch along the seam, and cross only where one
//! goes through the other beside it.

use std::collections::BTreeMap;

use glam::Vec3;
use lole_cloth::diagnose;

use super::{Dressed, EDGE};

/// An edge of a garment that goes through one of its triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClothCrossing {
    /// Ends of the edge: particles, the first of those that are sewn to each other.
    pub ends: [u32; 2],
    /// Corners of the triangle, in the same way.
    pub corners: [u32; 3],
    /// Middle of the edge [m].
    pub place: Vec3,
}

/// By the ends of a seam's edge, what is gathered on it: particles from the end of the smaller number on.
type Gathered = BTreeMap<[u32; 2], Vec<u32>>;

impl Dressed {
    /// Edges of the garment that go through one of its triangles, with its seams closed: 0 where no fold
    /// has gone through another. `None` where not all positions [m] are finite.
    #[must_use]
    pub fn crossings(&self, positions: &[Vec3]) -> Option<usize> {
        self.crossing_pairs(positions).map(|pairs| pairs.len())
    }

    /// The same one by one.
    #[must_use]
    pub fn crossing_pairs(&self, positions: &[Vec3]) -> Option<Vec<ClothCrossing>> {
        let joined = self.joined(positions);
        let triangles = self.closed_triangles();
        let mut edges: Vec<[u32; 2]> = (triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let crossings = diagnose::crossings((&triangles, edges.into_iter()), &joined, EDGE)?;
        let crossing = |(ends, triangle): ([u32; 2], u32)| ClothCrossing {
            ends,
            corners: triangles[triangle as usize],
            place: 0.5 * (joined[ends[0] as usize] + joined[ends[1] as usize]),
        };
        Some(crossings.into_iter().map(crossing).collect())
    }

    /// The triangles as they are sewn, cut where something is gathered on one of their sides.
    fn closed_triangles(&self) -> Vec<[u32; 3]> {
        let gathered = self.gathered();
        let mut closed = Vec::with_capacity(self.triangles.len());
        for corners in &self.triangles {
            let corners = corners.map(|corner| self.welded[corner as usize]);
            cut(corners, &gathered, &mut closed);
        }
        closed
    }

    /// The piece of cloth of a particle, and the identifier of the pattern's piece.
    #[must_use]
    pub fn piece_of(&self, particle: u32) -> (u32, &'static str) {
        let panel = self.panel_of[particle as usize];
        let piece = self.pieces[panel as usize];
        (panel, self.pattern.pieces[piece].id)
    }

    /// Whether the skin carries a particle.
    #[must_use]
    pub fn is_pinned(&self, particle: u32) -> bool {
        self.model()
            .is_some_and(|model| model.spec().pinned[particle as usize])
    }

    /// Particles that are sewn to others, or gathered between some that are.
    #[must_use]
    pub fn in_seams(&self) -> Vec<bool> {
        let mut sewn = vec![false; self.welded.len()];
        for (particle, &first) in self.welded.iter().enumerate() {
            if first as usize != particle {
                sewn[particle] = true;
                sewn[first as usize] = true;
            }
        }
        for &(particle, ..) in &self.puckers {
            sewn[particle as usize] = true;
        }
        sewn
    }

    fn gathered(&self) -> Gathered {
        let mut along: BTreeMap<[u32; 2], Vec<(u32, f32)>> = BTreeMap::new();
        for &(particle, ends, share) in &self.puckers {
            let [first, last] = ends.map(|end| self.welded[end as usize]);
            let share = if first < last { share } else { 1.0 - share };
            let side = [first.min(last), first.max(last)];
            along.entry(side).or_default().push((particle, share));
        }
        let ordered = along.into_iter().map(|(side, mut particles)| {
            particles.sort_by(|a, b| a.1.total_cmp(&b.1));
            (
                side,
                particles
                    .into_iter()
                    .map(|(particle, _)| particle)
                    .collect(),
            )
        });
        ordered.collect()
    }
}

/// Cuts a triangle from what is gathered on its sides to the corners opposite.
fn cut([a, b, c]: [u32; 3], gathered: &Gathered, out: &mut Vec<[u32; 3]>) {
    for [from, to, opposite] in [[a, b, c], [b, c, a], [c, a, b]] {
        let on_side = gathered.get(&[from.min(to), from.max(to)]);
        // The gathered cloth's own triangle between them is cut already.
        let Some(particles) = on_side.filter(|particles| !particles.contains(&opposite)) else {
            continue;
        };
        let mut way = vec![from.min(to)];
        way.extend(particles);
        way.push(from.max(to));
        if to < from {
            way.reverse();
        }
        for pair in way.windows(2) {
            cut([pair[0], pair[1], opposite], gathered, out);
        }
        return;
    }
    out.push([a, b, c]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_cut_where_something_is_gathered_on_its_sides() {
        let gathered = Gathered::from([([1, 2], vec![7, 8]), ([1, 3], vec![9])]);
        let mut out = Vec::new();
        cut([2, 1, 3], &gathered, &mut out);
        assert_eq!(out, [[2, 8, 3], [8, 7, 3], [1, 9, 7], [9, 3, 7]]);
    }
}
