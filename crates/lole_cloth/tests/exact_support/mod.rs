//! Crossings found with exact predicates (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic
//! and Fast Robust Geometric Predicates"), and a search that shares nothing with
//! the engine's. The engine asks by the same crate, in code of its own.
//!
//! An edge crosses a triangle with which it shares no corner where its ends lie strictly on either side of
//! the triangle's plane and it passes strictly inside. What only touches does not cross: an end that lies
//! in the plane, an edge that meets a side or a corner of the triangle, and all that lies in one plane.
//! Cloth that passes through cloth is caught all the same, because some edge of one of them is strictly
//! inside before or after; [`Touching::Counts`] shows how often the question arises at all.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::collections::BTreeSet;
use std::ops::Range;

use glam::Vec3;
use robust::{Coord3D, orient3d};

/// Triangles in a leaf of the tree of boxes, at most.
const LEAF: usize = 4;

/// An edge, its smaller end first, and the corners of the triangle that it goes through.
pub(crate) type Pair = ([u32; 2], [u32; 3]);

/// What becomes of an edge that touches a triangle and does not go through its inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Touching {
    /// It is passed over.
    IsFine,
    /// It counts as a crossing, unless all of it lies in the triangle's plane.
    Counts,
}

/// The box around some things [m], its least and its largest corner.
#[derive(Debug, Clone, Copy)]
struct Bounds([Vec3; 2]);

impl Bounds {
    const NOTHING: Self = Self([Vec3::INFINITY, Vec3::NEG_INFINITY]);

    fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        let grown = |Self([low, high]), point| Self([low.min(point), high.max(point)]);
        points.into_iter().fold(Self::NOTHING, grown)
    }

    fn with(self, other: Self) -> Self {
        let ([low, high], [other_low, other_high]) = (self.0, other.0);
        Self([low.min(other_low), high.max(other_high)])
    }

    fn meets(&self, other: &Self) -> bool {
        self.0[0].cmple(other.0[1]).all() && other.0[0].cmple(self.0[1]).all()
    }
}

/// Some triangles of the tree that follow each other, and where the node's other half begins.
#[derive(Debug, Clone, Copy)]
struct Node {
    first: usize,
    last: usize,
    /// The second of its two halves; the first is the next node. `None` for a leaf.
    second: Option<usize>,
}

/// A surface whose crossings are looked for again and again, while it moves.
#[derive(Debug, Clone)]
pub(crate) struct Surface {
    /// In the order of the tree's leaves.
    triangles: Vec<[u32; 3]>,
    /// The edges that no triangle before has, and by triangle which of them are its.
    edges: Vec<[u32; 2]>,
    edges_of: Vec<Range<usize>>,
    nodes: Vec<Node>,
    bounds: Vec<Bounds>,
    triangle_bounds: Vec<Bounds>,
}

impl Surface {
    /// The search for crossings of triangles that start at some positions [m].
    pub(crate) fn new(triangles: &[[u32; 3]], positions: &[Vec3]) -> Self {
        let mut triangles = triangles.to_vec();
        let mut nodes = Vec::new();
        let whole = 0..triangles.len();
        if !whole.is_empty() {
            split(&mut triangles, whole, positions, &mut nodes);
        }
        let (mut edges, mut edges_of) = (Vec::new(), Vec::new());
        let mut seen = BTreeSet::new();
        for &[a, b, c] in &triangles {
            let sides = [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
            let first = edges.len();
            edges.extend(sides.into_iter().filter(|side| seen.insert(*side)));
            edges_of.push(first..edges.len());
        }
        Self {
            bounds: vec![Bounds::NOTHING; nodes.len()],
            triangle_bounds: vec![Bounds::NOTHING; triangles.len()],
            edges,
            edges_of,
            nodes,
            triangles,
        }
    }

    /// Every crossing at some positions [m], in ascending order.
    pub(crate) fn crossings(&mut self, positions: &[Vec3], touching: Touching) -> Vec<Pair> {
        let at = |particle: &u32| positions[*particle as usize];
        for (bounds, corners) in self.triangle_bounds.iter_mut().zip(&self.triangles) {
            *bounds = Bounds::around(corners.iter().map(at));
        }
        for index in (0..self.nodes.len()).rev() {
            let node = self.nodes[index];
            self.bounds[index] = match node.second {
                Some(second) => self.bounds[index + 1].with(self.bounds[second]),
                None => (self.triangle_bounds[node.first..node.last].iter())
                    .fold(Bounds::NOTHING, |all, it| all.with(*it)),
            };
        }
        let mut pairs = Vec::new();
        let mut waiting = Vec::new();
        let wait = |waiting: &mut Vec<[usize; 2]>, some: &[[usize; 2]]| {
            let meet = |&&[one, other]: &&[usize; 2]| self.bounds[one].meets(&self.bounds[other]);
            waiting.extend(some.iter().filter(meet));
        };
        if !self.nodes.is_empty() {
            waiting.push([0, 0]);
        }
        while let Some([one, other]) = waiting.pop() {
            let sides = [one, other].map(|node| self.nodes[node].second.map(|it| [node + 1, it]));
            match sides {
                [None, None] => self.look([one, other], (positions, touching), &mut pairs),
                [Some([a, b]), _] if one == other => {
                    wait(&mut waiting, &[[a, a], [a, b], [b, b]]);
                }
                [Some(halves), None] => wait(&mut waiting, &halves.map(|half| [half, other])),
                [None, Some(halves)] => wait(&mut waiting, &halves.map(|half| [one, half])),
                [Some([a, b]), Some([c, d])] => {
                    wait(&mut waiting, &[[a, c], [a, d], [b, c], [b, d]]);
                }
            }
        }
        pairs.sort_unstable();
        pairs
    }

    /// Crossings between the triangles of two leaves.
    fn look(
        &self,
        [one, other]: [usize; 2],
        (positions, touching): (&[Vec3], Touching),
        pairs: &mut Vec<Pair>,
    ) {
        let [ones, others] = [one, other].map(|leaf| self.nodes[leaf].first..self.nodes[leaf].last);
        for a in ones {
            let firsts = if one == other { a + 1 } else { others.start };
            for b in firsts..others.end {
                if self.triangle_bounds[a].meets(&self.triangle_bounds[b]) {
                    self.through(a, b, (positions, touching), pairs);
                    self.through(b, a, (positions, touching), pairs);
                }
            }
        }
    }

    /// The edges of one triangle that go through another.
    fn through(
        &self,
        one: usize,
        other: usize,
        (positions, touching): (&[Vec3], Touching),
        pairs: &mut Vec<Pair>,
    ) {
        let corners = self.triangles[other];
        for &ends in &self.edges[self.edges_of[one].clone()] {
            let [p, q] = ends.map(|end| positions[end as usize]);
            let is_near = Bounds::around([p, q]).meets(&self.triangle_bounds[other]);
            let is_apart = !ends.iter().any(|end| corners.contains(end));
            let [a, b, c] = corners.map(|corner| positions[corner as usize]);
            if is_near && is_apart && meets([p, q], [a, b, c], touching) {
                pairs.push((ends, corners));
            }
        }
    }
}

/// Sorts triangles into halves, and those again, and notes a node for each; which one is for all.
fn split(
    triangles: &mut [[u32; 3]],
    range: Range<usize>,
    positions: &[Vec3],
    nodes: &mut Vec<Node>,
) -> usize {
    let index = nodes.len();
    nodes.push(Node {
        first: range.start,
        last: range.end,
        second: None,
    });
    if range.len() <= LEAF {
        return index;
    }
    let middle_of = |corners: &[u32; 3]| -> Vec3 {
        corners
            .iter()
            .map(|&corner| positions[corner as usize])
            .sum()
    };
    let Bounds([low, high]) = Bounds::around(triangles[range.clone()].iter().map(middle_of));
    let axis = (high - low).max_position();
    let middle = range.len() / 2;
    triangles[range.clone()].select_nth_unstable_by(middle, |one, other| {
        let places = [one, other].map(|corners| middle_of(corners)[axis]);
        places[0].total_cmp(&places[1]).then(one.cmp(other))
    });
    let middle = range.start + middle;
    split(triangles, range.start..middle, positions, nodes);
    let second = split(triangles, middle..range.end, positions, nodes);
    nodes[index].second = Some(second);
    index
}

/// Edges that go through triangles with which they share no corner: through the inside, exactly.
pub(crate) fn crossing_count(triangles: &[[u32; 3]], positions: &[Vec3]) -> usize {
    let mut surface = Surface::new(triangles, positions);
    surface.crossings(positions, Touching::IsFine).len()
}

fn side([a, b, c]: [Vec3; 3], p: Vec3) -> f64 {
    let point = |at: Vec3| Coord3D {
        x: f64::from(at.x),
        y: f64::from(at.y),
        z: f64::from(at.z),
    };
    orient3d(point(a), point(b), point(c), point(p))
}

/// Whether a segment goes through the inside of a triangle.
pub(crate) fn crosses(ends: [Vec3; 2], corners: [Vec3; 3]) -> bool {
    meets(ends, corners, Touching::IsFine)
}

fn meets([p, q]: [Vec3; 2], [a, b, c]: [Vec3; 3], touching: Touching) -> bool {
    let ends = [p, q].map(|end| side([a, b, c], end));
    let around = || [[a, b], [b, c], [c, a]].map(|[from, to]| side([from, to, p], q));
    match touching {
        Touching::IsFine => {
            let is_between = (0.0 < ends[0] && ends[1] < 0.0) || (ends[0] < 0.0 && 0.0 < ends[1]);
            is_between && {
                let around = around();
                around.iter().all(|&it| 0.0 < it) || around.iter().all(|&it| it < 0.0)
            }
        }
        Touching::Counts => {
            let is_beside = (0.0 < ends[0] && 0.0 < ends[1]) || (ends[0] < 0.0 && ends[1] < 0.0);
            let is_flat = ends[0] == 0.0 && ends[1] == 0.0;
            !is_beside && !is_flat && {
                let around = around();
                around.iter().all(|&it| 0.0 <= it) || around.iter().all(|&it| it <= 0.0)
            }
        }
    }
}
