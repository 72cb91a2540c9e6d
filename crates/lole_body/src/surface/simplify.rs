//! Quadric edge collapse (Garland and Heckbert 1997) of a half mesh, onto original vertices.
//!
//! A collapse moves one end of an edge onto the other, so every kept vertex is an original one and
//! keeps its normal. The border stays in the mirror plane, and no edge but a border edge joins two
//! border vertices, so that the half and its mirror image always close to a manifold.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::{DVec3, Vec3};

use super::half::is_on_plane;

/// Weight of edge length against distance: 0.1 mm off the surface costs as much as 15 mm of edge.
const LENGTH_WEIGHT: f64 = 4.0e-5;
/// No edge grows longer than this [m]: skinning needs vertices to bend at.
const LONGEST_EDGE: f64 = 0.045;
/// A collapse may not turn a triangle by more than the arc cosine of this.
const LEAST_TURN_COSINE: f64 = 0.3;
/// Least double area over squared longest edge of a new triangle: no needles.
const LEAST_SHAPE: f64 = 0.06;

/// Squared distance to planes as a symmetric form: `p·A p + 2 b·p + c`.
#[derive(Debug, Clone, Copy, Default)]
struct Quadric {
    a: [f64; 6],
    b: DVec3,
    c: f64,
}

impl Quadric {
    fn plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let d = -normal.dot(point);
        let n = normal;
        Self {
            a: [
                n.x * n.x,
                n.x * n.y,
                n.x * n.z,
                n.y * n.y,
                n.y * n.z,
                n.z * n.z,
            ]
            .map(|product| product * weight),
            b: n * (d * weight),
            c: d * d * weight,
        }
    }

    fn add(&mut self, other: &Self) {
        for (sum, term) in self.a.iter_mut().zip(other.a) {
            *sum += term;
        }
        self.b += other.b;
        self.c += other.c;
    }

    fn at(&self, p: DVec3) -> f64 {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        let quadratic = xx * p.x * p.x
            + yy * p.y * p.y
            + zz * p.z * p.z
            + 2.0 * (xy * p.x * p.y + xz * p.x * p.z + yz * p.y * p.z);
        quadratic + 2.0 * self.b.dot(p) + self.c
    }
}

/// A possible collapse of `from` onto `onto`; stale once either end has changed.
#[derive(Debug, Clone, Copy)]
struct Collapse {
    cost: f64,
    from: u32,
    onto: u32,
    versions: [u32; 2],
}

impl Ord for Collapse {
    /// The cheapest is the greatest; ties go to the lower indices.
    fn cmp(&self, other: &Self) -> Ordering {
        (other.cost.total_cmp(&self.cost))
            .then(other.from.cmp(&self.from))
            .then(other.onto.cmp(&self.onto))
    }
}

impl PartialOrd for Collapse {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Collapse {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Collapse {}

struct Collapser {
    points: Vec<DVec3>,
    on_plane: Vec<bool>,
    quadrics: Vec<Quadric>,
    triangles: Vec<[u32; 3]>,
    alive: Vec<bool>,
    fans: Vec<Vec<u32>>,
    versions: Vec<u32>,
    heap: BinaryHeap<Collapse>,
}

/// Collapses to about `target` triangles; `detail` weighs the error at each vertex.
/// Returns the remaining triangles, indexing the given positions.
pub(crate) fn simplify(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    detail: &[f32],
    target: usize,
) -> Vec<[u32; 3]> {
    let mut collapser = Collapser::new(positions, triangles, detail);
    let mut count = triangles.len();
    while count > target {
        let Some(collapse) = collapser.heap.pop() else {
            break;
        };
        let ends = [collapse.from as usize, collapse.onto as usize];
        let current = ends.map(|end| collapser.versions[end]);
        if current == collapse.versions && collapser.is_allowed(collapse.from, collapse.onto) {
            count -= collapser.apply(collapse.from, collapse.onto);
        }
    }
    (collapser.triangles.iter().zip(&collapser.alive))
        .filter_map(|(triangle, &alive)| alive.then_some(*triangle))
        .collect()
}

impl Collapser {
    fn new(positions: &[Vec3], triangles: &[[u32; 3]], detail: &[f32]) -> Self {
        let points: Vec<DVec3> = positions
            .iter()
            .map(|position| position.as_dvec3())
            .collect();
        let on_plane: Vec<bool> = positions
            .iter()
            .map(|&position| is_on_plane(position))
            .collect();
        let mut quadrics = vec![Quadric::default(); points.len()];
        let mut fans = vec![Vec::new(); points.len()];
        for (index, triangle) in triangles.iter().enumerate() {
            let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
            let cross = (b - a).cross(c - a);
            let area = cross.length();
            let normal = cross.normalize_or_zero();
            let mirrored = normal * DVec3::new(-1.0, 1.0, 1.0);
            for &vertex in triangle {
                let vertex = vertex as usize;
                let weight = area * f64::from(detail[vertex]);
                quadrics[vertex].add(&Quadric::plane(normal, a, weight));
                if on_plane[vertex] {
                    // The unseen half passes through the same border.
                    quadrics[vertex].add(&Quadric::plane(mirrored, points[vertex], weight));
                }
                fans[vertex].push(u32::try_from(index).unwrap_or(u32::MAX));
            }
        }
        let mut collapser = Self {
            points,
            on_plane,
            quadrics,
            triangles: triangles.to_vec(),
            alive: vec![true; triangles.len()],
            fans,
            versions: vec![0; positions.len()],
            heap: BinaryHeap::new(),
        };
        for &[a, b, c] in triangles {
            for [from, onto] in [[a, b], [b, c], [c, a]] {
                // Each inner edge is met twice, a border edge once.
                if from < onto || collapser.is_border(from, onto) {
                    collapser.propose(from, onto);
                    collapser.propose(onto, from);
                }
            }
        }
        collapser
    }

    /// Both ends on the mirror plane; such edges are border edges, kept so by `is_allowed`.
    fn is_border(&self, a: u32, b: u32) -> bool {
        self.on_plane[a as usize] && self.on_plane[b as usize]
    }

    fn propose(&mut self, from: u32, onto: u32) {
        let (f, o) = (from as usize, onto as usize);
        if self.on_plane[f] && !self.on_plane[o] {
            return;
        }
        let mut quadric = self.quadrics[f];
        quadric.add(&self.quadrics[o]);
        let squared = self.points[f].distance_squared(self.points[o]);
        let cost = quadric.at(self.points[o]).max(0.0) + LENGTH_WEIGHT * squared * squared;
        self.heap.push(Collapse {
            cost,
            from,
            onto,
            versions: [self.versions[f], self.versions[o]],
        });
    }

    /// Vertices around `vertex`, sorted.
    fn ring(&self, vertex: u32) -> Vec<u32> {
        let mut ring: Vec<u32> = (self.fans[vertex as usize].iter())
            .flat_map(|&triangle| self.triangles[triangle as usize])
            .filter(|&other| other != vertex)
            .collect();
        ring.sort_unstable();
        ring.dedup();
        ring
    }

    /// The link condition, the border rules, and no flipped, thin or huge triangle.
    fn is_allowed(&self, from: u32, onto: u32) -> bool {
        let around_onto = self.ring(onto);
        let mut common = 0;
        for other in self.ring(from) {
            if around_onto.binary_search(&other).is_ok() {
                common += 1;
            } else if other != onto
                && self.on_plane[onto as usize]
                && self.on_plane[other as usize]
                && !self.on_plane[from as usize]
            {
                return false;
            }
        }
        let expected = if self.is_border(from, onto) { 1 } else { 2 };
        common == expected
            && self.fans[from as usize]
                .iter()
                .all(|&t| self.stays_good(t, from, onto))
    }

    fn stays_good(&self, triangle: u32, from: u32, onto: u32) -> bool {
        let corners = self.triangles[triangle as usize];
        if corners.contains(&onto) {
            return true;
        }
        let moved = corners.map(|corner| if corner == from { onto } else { corner });
        if moved.iter().all(|&corner| self.on_plane[corner as usize]) {
            return false;
        }
        let cross = |corners: [u32; 3]| {
            let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
            (b - a).cross(c - a)
        };
        let (before, after) = (cross(corners), cross(moved));
        let [a, b, c] = moved.map(|corner| self.points[corner as usize]);
        let longest = (a.distance_squared(b))
            .max(b.distance_squared(c))
            .max(c.distance_squared(a));
        let area = after.length();
        before.dot(after) > LEAST_TURN_COSINE * before.length() * area
            && area > LEAST_SHAPE * longest
            && longest < LONGEST_EDGE * LONGEST_EDGE
    }

    /// Collapses and returns how many triangles vanished.
    fn apply(&mut self, from: u32, onto: u32) -> usize {
        let (f, o) = (from as usize, onto as usize);
        let fan = std::mem::take(&mut self.fans[f]);
        let mut vanished = 0;
        for triangle in fan {
            let corners = self.triangles[triangle as usize];
            if corners.contains(&onto) {
                self.alive[triangle as usize] = false;
                vanished += 1;
                for corner in corners {
                    self.fans[corner as usize].retain(|&other| other != triangle);
                }
            } else {
                self.triangles[triangle as usize] =
                    corners.map(|corner| if corner == from { onto } else { corner });
                self.fans[o].push(triangle);
            }
        }
        let quadric = self.quadrics[f];
        self.quadrics[o].add(&quadric);
        self.versions[f] += 1;
        self.versions[o] += 1;
        for other in self.ring(onto) {
            self.propose(onto, other);
            self.propose(other, onto);
        }
        vanished
    }
}
