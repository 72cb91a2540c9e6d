//! Quadric edge collapse (Garland and Heckbert 1997) of a half mesh, onto original vertices.
//!
//! A collapse moves one end of an edge onto the other, so every kept vertex is an original one and
//! keeps its normal. The border stays in the mirror plane, and no edge but a border edge joins two
//! border vertices, so that the half and its mirror image always close to a manifold.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use smallvec::SmallVec;

use super::half::is_on_plane;

/// Weight of edge length against distance: 0.1 mm off the surface costs as much as 15 mm of edge.
const LENGTH_WEIGHT: f64 = 4.0e-5;
/// No edge grows longer than this [m]: skinning needs vertices to bend at.
const LONGEST_EDGE: f64 = 0.045;
/// A collapse may not turn a triangle by more than the arc cosine of this.
const LEAST_TURN_COSINE: f64 = 0.3;
/// Least double area over squared longest edge of a new triangle: no needles.
const LEAST_SHAPE: f64 = 0.06;
/// Weight of the course of a line between regions against the surface.
const LINE_WEIGHT: f64 = 4.0;
/// Before the exact order by heap, sweeps collapse whatever costs less than a rising threshold,
/// down to this many times the target; one heap for everything would take four times as long.
const SWEEP_UNTIL: usize = 2;
/// Most vertices have fewer triangles around them than this.
const FAN_ROOM: usize = 8;
/// Cost of a cheapest collapse that is to be looked for anew.
const STALE: f64 = -1.0;
const SWEEP_START: f64 = 2.0e-14;
const SWEEP_GROWTH: f64 = 3.0;
const SWEEP_END: f64 = 1.0e-6;

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

/// A possible collapse of the first end onto the second; stale once either has changed.
#[derive(Debug, Clone, Copy)]
struct Collapse {
    cost: f64,
    ends: [u32; 2],
    versions: [u32; 2],
}

impl Ord for Collapse {
    /// The cheapest is the greatest; ties go to the lower indices.
    fn cmp(&self, other: &Self) -> Ordering {
        (other.cost.total_cmp(&self.cost)).then(other.ends.cmp(&self.ends))
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

/// A triangle's area normal, double area and longest edge squared.
struct TriangleShape {
    cross: DVec3,
    area: f64,
    longest: f64,
}

impl TriangleShape {
    /// Double area over squared longest edge: 0.87 at best, 0 for a needle.
    fn quality(&self) -> f64 {
        self.area / self.longest
    }
}

/// One vertex, in two lines of the cache: what a collapse costs is asked of neighbors again and again.
#[derive(Debug, Clone, Default)]
#[repr(align(64))]
struct Vertex {
    point: DVec3,
    quadric: Quadric,
    /// Goes up with every change.
    version: u32,
    on_plane: bool,
    /// On a line between regions.
    on_line: bool,
    /// Where a line ends or meets another or the mirror plane: never moved.
    is_locked: bool,
}

struct Collapser {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
    regions: Vec<u8>,
    alive: Vec<bool>,
    count: usize,
    fans: Vec<SmallVec<[u32; FAN_ROOM]>>,
    heap: BinaryHeap<Collapse>,
    /// The cheapest collapse of each vertex and where it goes; [`STALE`] until it is looked for.
    cheapest: Vec<(f64, u32)>,
}

/// Room for vertices around a vertex, used again and again.
#[derive(Default)]
struct Rings {
    from: Vec<u32>,
    onto: Vec<u32>,
}

/// What is simplified: equal-length vertex columns and triangles with their region.
pub(crate) struct Fine<'a> {
    pub(crate) positions: &'a [Vec3],
    /// Weight of the error at each vertex.
    pub(crate) detail: &'a [f32],
    pub(crate) triangles: &'a [[u32; 3]],
    /// Region of each triangle: lines between regions keep their course.
    pub(crate) regions: &'a [u8],
}

/// Collapses to about `target` triangles: those that remain, indexing the given positions, each
/// with its region.
pub(crate) fn simplify(fine: &Fine<'_>, target: usize) -> Vec<([u32; 3], u8)> {
    let mut collapser = Collapser::new(fine);
    let mut threshold = SWEEP_START;
    collapser.find_cheapest();
    while collapser.count > SWEEP_UNTIL * target && threshold < SWEEP_END {
        collapser.sweep(threshold);
        threshold *= SWEEP_GROWTH;
    }
    collapser.fill_heap();
    let mut rings = Rings::default();
    while collapser.count > target {
        let Some(Collapse { ends, versions, .. }) = collapser.heap.pop() else {
            break;
        };
        if ends.map(|end| collapser.vertices[end as usize].version) != versions {
            continue;
        }
        let [from, onto] = ends;
        if collapser.is_allowed(from, onto, &mut rings) {
            collapser.apply(from, onto);
            collapser.propose_around(onto, &mut rings.onto);
        } else if collapser.is_allowed(onto, from, &mut rings) {
            collapser.apply(onto, from);
            collapser.propose_around(from, &mut rings.onto);
        }
    }
    (0..fine.triangles.len())
        .filter(|&index| collapser.alive[index])
        .map(|index| (collapser.triangles[index], fine.regions[index]))
        .collect()
}

/// The cheaper of two collapses of a vertex comes first; ties go to the lower index.
fn cheaper(a: &(f64, u32), b: &(f64, u32)) -> Ordering {
    a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
}

impl Collapser {
    fn new(fine: &Fine<'_>) -> Self {
        let vertices = fine.positions.iter().map(|point| Vertex {
            point: point.as_dvec3(),
            on_plane: is_on_plane(*point),
            ..Vertex::default()
        });
        let vertices: Vec<Vertex> = vertices.collect();
        let count = vertices.len();
        let mut collapser = Self {
            vertices,
            triangles: fine.triangles.to_vec(),
            regions: fine.regions.to_vec(),
            alive: vec![true; fine.triangles.len()],
            count: fine.triangles.len(),
            fans: vec![SmallVec::new(); count],
            heap: BinaryHeap::new(),
            cheapest: vec![(STALE, u32::MAX); count],
        };
        for (index, triangle) in fine.triangles.iter().enumerate() {
            let [a, b, c] = triangle.map(|vertex| collapser.vertices[vertex as usize].point);
            let cross = (b - a).cross(c - a);
            let area = cross.length();
            let normal = cross.normalize_or_zero();
            let mirrored = normal * DVec3::new(-1.0, 1.0, 1.0);
            for &vertex in triangle {
                let vertex = vertex as usize;
                let weight = area * f64::from(fine.detail[vertex]);
                collapser.vertices[vertex]
                    .quadric
                    .add(&Quadric::plane(normal, a, weight));
                if collapser.vertices[vertex].on_plane {
                    // The unseen half passes through the same border.
                    let point = collapser.vertices[vertex].point;
                    collapser.vertices[vertex]
                        .quadric
                        .add(&Quadric::plane(mirrored, point, weight));
                }
                collapser.fans[vertex].push(u32::try_from(index).unwrap_or(u32::MAX));
            }
        }
        collapser.mark_lines();
        collapser
    }

    /// Finds the lines between regions and gives their vertices a plane across the surface.
    fn mark_lines(&mut self) {
        let mut degrees = vec![0_u8; self.vertices.len()];
        let between: Vec<bool> = (self.fans.iter())
            .map(|fan| {
                let mut regions = fan.iter().map(|&it| self.regions[it as usize]);
                let first = regions.next();
                regions.any(|region| Some(region) != first)
            })
            .collect();
        for index in 0..self.triangles.len() {
            let corners = self.triangles[index];
            let ends = corners.iter().filter(|&&it| between[it as usize]);
            if ends.count() < 2 {
                continue;
            }
            let [a, b, c] = corners.map(|corner| self.vertices[corner as usize].point);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            for side in 0..3 {
                let ends = [corners[side], corners[(side + 1) % 3]];
                if !self.is_line(ends[0], ends[1]) {
                    continue;
                }
                let [from, to] = ends.map(|end| self.vertices[end as usize].point);
                let across = (to - from).cross(normal).normalize_or_zero();
                let weight = LINE_WEIGHT * (to - from).length_squared();
                for end in ends {
                    let end_vertex = &mut self.vertices[end as usize];
                    end_vertex
                        .quadric
                        .add(&Quadric::plane(across, from, weight));
                    end_vertex.on_line = true;
                    degrees[end as usize] += 1;
                }
            }
        }
        // Every line edge is met from both its triangles.
        for (vertex, &degree) in self.vertices.iter_mut().zip(&degrees) {
            vertex.is_locked = vertex.on_line && (degree != 4 || vertex.on_plane);
        }
    }

    /// Whether the edge has different regions on its sides.
    fn is_line(&self, a: u32, b: u32) -> bool {
        let mut sides = (self.fans[a as usize].iter())
            .filter(|&&triangle| self.triangles[triangle as usize].contains(&b))
            .map(|&triangle| self.regions[triangle as usize]);
        match (sides.next(), sides.next()) {
            (Some(one), Some(other)) => one != other,
            _ => false,
        }
    }

    /// Collapses each vertex onto its cheapest neighbor where that costs less than `threshold`.
    fn sweep(&mut self, threshold: f64) {
        let mut rings = Rings::default();
        for from in 0..self.vertices.len() {
            if self.fans[from].is_empty() || threshold <= self.cheapest[from].0 {
                continue;
            }
            let name = u32::try_from(from).unwrap_or(u32::MAX);
            if self.cheapest[from].0 < 0.0 {
                self.cheapest[from] = self.cheapest_from(name, &mut rings.from);
            }
            let (cost, onto) = self.cheapest[from];
            if cost < threshold && self.is_allowed(name, onto, &mut rings) {
                self.apply(name, onto);
                self.look_around(name, onto, &mut rings.onto);
            }
        }
    }

    /// After `from` has gone onto `onto`: around it nothing else has changed, so that a cheapest collapse that went
    /// to neither of them is still the cheapest or dearer than the one onto `onto`.
    fn look_around(&mut self, from: u32, onto: u32, ring: &mut Vec<u32>) {
        self.ring_into(onto, ring);
        self.cheapest[onto as usize].0 = STALE;
        for &other in &*ring {
            let (cost, goal) = self.cheapest[other as usize];
            if goal == from || goal == onto {
                self.cheapest[other as usize].0 = STALE;
            } else if 0.0 <= cost {
                let now = (self.cost(other, onto), onto);
                if cheaper(&now, &(cost, goal)).is_lt() {
                    self.cheapest[other as usize] = now;
                }
            }
        }
    }

    fn fill_heap(&mut self) {
        let mut edges: Vec<[u32; 2]> = (self.triangles.iter().zip(&self.alive))
            .filter(|(_, alive)| **alive)
            .flat_map(|(&[a, b, c], _)| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let collapses: Vec<Collapse> = edges.iter().filter_map(|&[a, b]| self.best(a, b)).collect();
        self.heap = BinaryHeap::from(collapses);
    }

    /// Both ends on the mirror plane; such edges are border edges, kept so by `is_allowed`.
    fn is_border(&self, a: u32, b: u32) -> bool {
        self.vertices[a as usize].on_plane && self.vertices[b as usize].on_plane
    }

    /// Cost of moving `from` onto `onto`; infinite where a rule forbids it outright.
    fn cost(&self, from: u32, onto: u32) -> f64 {
        let (f, o) = (from as usize, onto as usize);
        let leaves_plane = self.vertices[f].on_plane && !self.vertices[o].on_plane;
        let leaves_line = self.vertices[f].on_line && !self.vertices[o].on_line;
        if self.vertices[f].is_locked || leaves_plane || leaves_line {
            return f64::INFINITY;
        }
        let mut quadric = self.vertices[f].quadric;
        quadric.add(&self.vertices[o].quadric);
        let squared = self.vertices[f]
            .point
            .distance_squared(self.vertices[o].point);
        quadric.at(self.vertices[o].point).max(0.0) + LENGTH_WEIGHT * squared * squared
    }

    /// The cheaper of the edge's two collapses.
    fn best(&self, a: u32, b: u32) -> Option<Collapse> {
        let costs = [self.cost(a, b), self.cost(b, a)];
        let ends = if costs[1] < costs[0] { [b, a] } else { [a, b] };
        let cost = costs[0].min(costs[1]);
        cost.is_finite().then(|| Collapse {
            cost,
            ends,
            versions: ends.map(|end| self.vertices[end as usize].version),
        })
    }

    fn propose_around(&mut self, vertex: u32, ring: &mut Vec<u32>) {
        self.ring_into(vertex, ring);
        for &other in &*ring {
            if let Some(collapse) = self.best(vertex.min(other), vertex.max(other)) {
                self.heap.push(collapse);
            }
        }
    }

    /// Vertices around `vertex`, each once: every triangle around it gives the one that follows, and
    /// on the border the one that is left has none before it.
    fn ring_into(&self, vertex: u32, ring: &mut Vec<u32>) {
        ring.clear();
        let fan = &self.fans[vertex as usize];
        let turned = |triangle: u32| {
            let [a, b, c] = self.triangles[triangle as usize];
            if a == vertex {
                [b, c]
            } else if b == vertex {
                [c, a]
            } else {
                [a, b]
            }
        };
        ring.extend(fan.iter().map(|&triangle| turned(triangle)[0]));
        if self.vertices[vertex as usize].on_plane {
            for &triangle in fan {
                let last = turned(triangle)[1];
                if !ring.contains(&last) {
                    ring.push(last);
                }
            }
        }
    }

    /// Cost of the cheapest collapse of `from` and where it goes; infinite where there is none.
    fn cheapest_from(&self, from: u32, ring: &mut Vec<u32>) -> (f64, u32) {
        self.ring_into(from, ring);
        let costs = ring.iter().map(|&onto| (self.cost(from, onto), onto));
        costs.min_by(cheaper).unwrap_or((f64::INFINITY, u32::MAX))
    }

    /// Looks at every vertex on all threads, so that the first sweep need not.
    fn find_cheapest(&mut self) {
        self.cheapest = (0..self.vertices.len())
            .into_par_iter()
            .map_init(Vec::new, |ring, from| {
                self.cheapest_from(u32::try_from(from).unwrap_or(u32::MAX), ring)
            })
            .collect();
    }

    /// The link condition, the border rules, and no flipped, thin or huge triangle.
    fn is_allowed(&self, from: u32, onto: u32, rings: &mut Rings) -> bool {
        let (f, o) = (from as usize, onto as usize);
        if !self.cost(from, onto).is_finite()
            || (self.vertices[f].on_line && !self.is_line(from, onto))
        {
            return false;
        }
        self.ring_into(from, &mut rings.from);
        self.ring_into(onto, &mut rings.onto);
        let mut common = 0;
        for &other in &rings.from {
            if other == onto {
                continue;
            }
            if rings.onto.contains(&other) {
                common += 1;
            } else if self.vertices[o].on_plane
                && self.vertices[other as usize].on_plane
                && !self.vertices[f].on_plane
            {
                return false;
            }
        }
        let expected = if self.is_border(from, onto) { 1 } else { 2 };
        common == expected && self.fans[f].iter().all(|&t| self.stays_good(t, from, onto))
    }

    fn stays_good(&self, triangle: u32, from: u32, onto: u32) -> bool {
        let corners = self.triangles[triangle as usize];
        if corners.contains(&onto) {
            return true;
        }
        let moved = corners.map(|corner| if corner == from { onto } else { corner });
        if moved
            .iter()
            .all(|&corner| self.vertices[corner as usize].on_plane)
        {
            return false;
        }
        let [before, after] = [corners, moved].map(|corners| self.shape(corners));
        before.cross.dot(after.cross) > LEAST_TURN_COSINE * before.area * after.area
            && after.quality() > LEAST_SHAPE.min(before.quality())
            && after.longest < LONGEST_EDGE * LONGEST_EDGE
    }

    fn shape(&self, corners: [u32; 3]) -> TriangleShape {
        let [a, b, c] = corners.map(|corner| self.vertices[corner as usize].point);
        let cross = (b - a).cross(c - a);
        let sides = [
            a.distance_squared(b),
            b.distance_squared(c),
            c.distance_squared(a),
        ];
        TriangleShape {
            cross,
            area: cross.length(),
            longest: sides.into_iter().fold(0.0, f64::max),
        }
    }

    fn apply(&mut self, from: u32, onto: u32) {
        let (f, o) = (from as usize, onto as usize);
        for triangle in std::mem::take(&mut self.fans[f]) {
            let corners = self.triangles[triangle as usize];
            if corners.contains(&onto) {
                self.alive[triangle as usize] = false;
                self.count -= 1;
                for corner in corners {
                    self.fans[corner as usize].retain(|other| *other != triangle);
                }
            } else {
                self.triangles[triangle as usize] =
                    corners.map(|corner| if corner == from { onto } else { corner });
                self.fans[o].push(triangle);
            }
        }
        let quadric = self.vertices[f].quadric;
        self.vertices[o].quadric.add(&quadric);
        self.vertices[f].version += 1;
        self.vertices[o].version += 1;
    }
}
