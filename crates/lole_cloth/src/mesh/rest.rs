//! The flat shape of a piece: in one plane, or triangle by triangle where pieces are welded to one
//! surface.
//!
//! What lies around a particle of a welded piece is laid into a plane by distance and angle, as
//! along straight ways from the particle (the exponential map); angles that do not add up to a full
//! turn, as at the tip of a dart, are opened or closed evenly. Where the piece is flat that is the
//! flat piece.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

use glam::{DVec2, Vec2};
use lole_geom::narrow;
use lole_geom::trig64;

use crate::lanes::narrow as particle_number;
use crate::mesh::spec::{MeshError, MeshSpec};
use crate::mesh::strain::Flat;
use crate::mesh::topology::Topology;

/// Mean edges within which the ways between particles of a welded piece are kept: cloth that is
/// farther apart may touch itself.
const NEAR: f32 = 4.0;

/// A way along an edge goes through it up to this share of its length beyond its ends: rounding.
const ALONG: f64 = 1.0e-6;

/// The flat shape of a piece.
#[derive(Clone, Copy)]
pub(crate) enum Rest<'a> {
    /// Particles in the plane [m].
    Plane(&'a [Vec2]),
    /// Triangle by triangle.
    Welded(&'a Welded),
}

/// Triangles of a particle, counterclockwise: the corners right and left of it, and which.
pub(crate) type Fan = Vec<([u32; 2], usize)>;

/// What is known of a piece of which each triangle is laid flat by itself.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Welded {
    /// By triangle of the topology, its corners [m], counterclockwise, warp along `x`.
    pub(crate) corners: Vec<[Vec2; 3]>,
    /// By particle, its neighbors' distances [m], in their order; of an edge whose sides differ, the mean.
    pub(crate) lengths: Vec<Vec<f32>>,
    pub(crate) fans: Vec<Fan>,
    /// By particle, what is near on the cloth, ascending, and how far that is along edges and across
    /// them [m].
    pub(crate) near: Vec<Vec<(u32, f32)>>,
}

impl Welded {
    /// Reads the shape of a checked mesh; `corners` are those of its triangles.
    ///
    /// # Errors
    /// When parts hang together in a single particle only.
    pub(crate) fn new(topology: &Topology, corners: Vec<[Vec2; 3]>) -> Result<Self, MeshError> {
        let mut welded = Self {
            lengths: lengths(topology, &corners),
            fans: fans(topology)?,
            corners,
            near: Vec::new(),
        };
        let hops = welded.hops(topology);
        let (mut sum, mut count) = (0.0_f64, 0.0_f64);
        for &length in welded.lengths.iter().flatten() {
            sum += f64::from(length);
            count += 1.0;
        }
        #[expect(clippy::cast_possible_truncation, reason = "a mean length")]
        let reach = NEAR * (sum / count.max(1.0)) as f32;
        let mut search = Search::new(hops.len());
        let each = (0_u32..).zip(&hops);
        welded.near = each
            .map(|(particle, _)| search.within(&hops, particle, reach))
            .collect();
        Ok(welded)
    }

    /// A triangle's corners in another order around.
    fn turned(&self, topology: &Topology, (triangle, order): (usize, [u32; 3])) -> [DVec2; 3] {
        let particles = topology.triangles[triangle];
        let corners = self.corners[triangle];
        order.map(|particle| {
            let place = particles.iter().position(|&it| it == particle);
            corners[place.unwrap_or(0)].as_dvec2()
        })
    }

    /// By particle, where it may go straight: to its neighbors, and across the edges that face it; with
    /// lengths [m].
    fn hops(&self, topology: &Topology) -> Vec<Vec<(u32, f32)>> {
        let mut hops: Vec<Vec<(u32, f32)>> = (topology.neighbors.iter())
            .zip(&self.lengths)
            .map(|(ring, lengths)| ring.iter().copied().zip(lengths.iter().copied()).collect())
            .collect();
        for middle in 0..hops.len() {
            for place in 0..self.fans[middle].len() {
                if let Some((beyond, length)) = self.across(topology, (middle, place)) {
                    hops[middle].push((beyond, length));
                    hops[beyond as usize].push((particle_number(middle), length));
                }
            }
        }
        hops
    }

    /// The particle beyond the edge that faces a particle in a triangle of its fan, and how far it is
    /// straight over the edge [m].
    fn across(&self, topology: &Topology, (middle, place): (usize, usize)) -> Option<(u32, f32)> {
        let ([right, left], triangle) = self.fans[middle][place];
        let (other, corner) = self.beyond(right, left, triangle)?;
        if corner as usize <= middle {
            return None;
        }
        let [at, a, b] = self.turned(topology, (triangle, [particle_number(middle), right, left]));
        let facing = self.turned(topology, (other, [left, right, corner]));
        let end = unfolded([b, a], facing);
        let way = end - at;
        let is_between = (a - at).perp_dot(way) > 0.0 && way.perp_dot(b - at) > 0.0;
        is_between.then(|| (corner, narrow(way.length())))
    }

    /// The triangle on the other side of the edge that `triangle` walks from `right` to `left`, and its
    /// corner there.
    pub(crate) fn beyond(&self, right: u32, left: u32, triangle: usize) -> Option<(usize, u32)> {
        self.fans[left as usize]
            .iter()
            .find(|&&([first, _], other)| first == right && other != triangle)
            .map(|&([_, corner], other)| (other, corner))
    }

    /// A triangle of the fan of `middle` as it lies by itself: `middle`, right and left corner.
    pub(crate) fn leaf(
        &self,
        topology: &Topology,
        middle: u32,
        place: usize,
    ) -> ([u32; 2], [DVec2; 3]) {
        let (sides, triangle) = self.fans[middle as usize][place];
        let [right, left] = sides;
        (
            sides,
            self.turned(topology, (triangle, [middle, right, left])),
        )
    }

    /// The corner of a triangle beyond the edge from `left` to `right`, laid beside the edge.
    pub(crate) fn laid_beside(
        &self,
        topology: &Topology,
        (triangle, order): (usize, [u32; 3]),
        edge: [DVec2; 2],
    ) -> DVec2 {
        unfolded(edge, self.turned(topology, (triangle, order)))
    }

    /// By particle, its nearest pin and the cloth between [m]; infinite where no way leads there.
    ///
    /// Dijkstra 1959 over the edges; where two corners of a triangle are known, the third is as far as it is
    /// from where the pin lies in the triangle's plane, seen through the edge between the two (Novotni and
    /// Klein 2002), which is exact where the surface can be laid flat.
    pub(crate) fn ways_from(&self, topology: &Topology, pins: &[u32]) -> Vec<(u32, f32)> {
        let count = topology.neighbors.len();
        let mut best = vec![(pins.first().copied().unwrap_or(0), f32::INFINITY); count];
        let mut is_done = vec![false; count];
        let mut queue = BinaryHeap::new();
        for &pin in pins {
            best[pin as usize] = (pin, 0.0);
            queue.push(Reverse((0_u32, pin)));
        }
        while let Some(Reverse((_, particle))) = queue.pop() {
            if std::mem::replace(&mut is_done[particle as usize], true) {
                continue;
            }
            let (pin, length) = best[particle as usize];
            let mut offer = |next: u32, way: f32| {
                if way < best[next as usize].1 {
                    best[next as usize] = (pin, way);
                    // Bits of a number that is not negative have its order.
                    queue.push(Reverse((way.to_bits(), next)));
                }
                best[next as usize]
            };
            for (&next, &edge) in topology.neighbors[particle as usize]
                .iter()
                .zip(&self.lengths[particle as usize])
            {
                offer(next, length + edge);
            }
            let leaves = 0..self.fans[particle as usize].len();
            let corners = leaves.flat_map(|place| {
                let ([right, left], [at, on_right, on_left]) = self.leaf(topology, particle, place);
                [
                    ([right, left], [at, on_right, on_left]),
                    ([left, right], [at, on_left, on_right]),
                ]
            });
            for ([near, far], [at, beside, end]) in corners {
                let (of, known) = offer(near, f32::INFINITY);
                if of != pin || !is_done[near as usize] {
                    continue;
                }
                let ways = [length, known].map(f64::from);
                if let Some(way) = seen_through([at, beside], ways, end) {
                    offer(far, narrow(way));
                }
            }
        }
        best
    }

    /// Neighbors of a particle laid around it [m], warp along `x`, in the order of the ring.
    fn around(&self, topology: &Topology, middle: usize) -> Vec<(u32, DVec2)> {
        let fan = &self.fans[middle];
        let mut angles = Vec::with_capacity(fan.len() + 1);
        let mut warps = Vec::with_capacity(fan.len());
        let mut angle = 0.0;
        for place in 0..fan.len() {
            let (_, [at, right, left]) = self.leaf(topology, particle_number(middle), place);
            let (e1, e2) = (right - at, left - at);
            let wide = trig64::atan2(e1.perp_dot(e2), e1.dot(e2));
            // Half of the angle on either side of its middle, so that opening a fan turns no triangle.
            let half = trig64::atan2(e1.y, e1.x) + 0.5 * wide;
            warps.push((angle + 0.5 * wide, half, e1.perp_dot(e2)));
            angles.push(angle);
            angle += wide;
        }
        let is_closed = fan.first().map(|it| it.0[0]) == fan.last().map(|it| it.0[1]);
        let opened = if is_closed && 0.0 < angle {
            TAU / angle
        } else {
            1.0
        };
        if !is_closed {
            angles.push(angle);
        }
        let mut sum = DVec2::ZERO;
        for (middle, half, weight) in warps {
            let (sin, cos) = trig64::sin_cos(2.0 * (middle * opened - half));
            sum += DVec2::new(cos, sin) * weight;
        }
        let turn = 0.5 * trig64::atan2(sum.y, sum.x);
        let spokes = fan
            .iter()
            .map(|it| it.0[0])
            .chain(fan.last().map(|it| it.0[1]));
        spokes
            .zip(angles)
            .map(|(neighbor, angle)| {
                let (sin, cos) = trig64::sin_cos(angle * opened - turn);
                let length = self.length(topology, [particle_number(middle), neighbor]);
                (
                    neighbor,
                    DVec2::new(cos, sin) * f64::from(length.unwrap_or(0.0)),
                )
            })
            .collect()
    }

    /// How long the edge between two particles is [m]; `None` where there is none.
    fn length(&self, topology: &Topology, [first, second]: [u32; 2]) -> Option<f32> {
        let ring = &topology.neighbors[first as usize];
        let place = ring.binary_search(&second).ok()?;
        Some(self.lengths[first as usize][place])
    }
}

impl Rest<'_> {
    /// A triangle of the topology, as its corners come in `order`.
    pub(crate) fn triangle(&self, topology: &Topology, index: usize, order: [u32; 3]) -> Flat {
        Flat::new(match self {
            Self::Plane(flat) => order.map(|particle| flat[particle as usize].as_dvec2()),
            Self::Welded(welded) => welded.turned(topology, (index, order)),
        })
    }

    /// Where the neighbors of a particle lie from it [m], in ascending order.
    pub(crate) fn ring(&self, topology: &Topology, middle: usize) -> Vec<(u32, DVec2)> {
        match self {
            Self::Plane(flat) => {
                let center = flat[middle].as_dvec2();
                let offset = |&it: &u32| (it, flat[it as usize].as_dvec2() - center);
                topology.neighbors[middle].iter().map(offset).collect()
            }
            Self::Welded(welded) => {
                let mut ring = welded.around(topology, middle);
                ring.sort_by_key(|&(neighbor, _)| neighbor);
                ring
            }
        }
    }

    /// How far every particle is from one on the cloth [m]; straight where the piece lies in a plane.
    pub(crate) fn ways_from(&self, topology: &Topology, from: u32) -> Vec<f32> {
        match self {
            Self::Plane(flat) => {
                let start = flat[from as usize];
                flat.iter().map(|place| place.distance(start)).collect()
            }
            Self::Welded(welded) => {
                let ways = welded.ways_from(topology, &[from]);
                ways.into_iter().map(|(_, way)| way).collect()
            }
        }
    }

    /// How far two particles lie apart on the cloth [m]: straight in the plane; of a welded piece along
    /// edges and across them.
    pub(crate) fn distance(&self, topology: &Topology, [first, second]: [u32; 2]) -> f32 {
        match self {
            Self::Plane(flat) => flat[first as usize].distance(flat[second as usize]),
            Self::Welded(welded) => {
                let near = &welded.near[first as usize];
                let found = near.binary_search_by_key(&second, |&(it, _)| it);
                let known = welded.length(topology, [first, second]);
                known
                    .or_else(|| Some(near[found.ok()?].1))
                    .unwrap_or_else(|| welded.ways_from(topology, &[first])[second as usize].1)
            }
        }
    }
}

/// How far a place is straight from one that is so far from both ends of an edge [m], on the other side of
/// it; `None` where the way does not go through the edge.
fn seen_through([a, b]: [DVec2; 2], [from_a, from_b]: [f64; 2], place: DVec2) -> Option<f64> {
    let edge = b - a;
    let length = edge.length();
    let along = (from_a * from_a - from_b * from_b + length * length) / (2.0 * length);
    let off = (from_a * from_a - along * along).max(0.0).sqrt();
    let (right, up) = (edge / length, edge.perp() / length);
    let (x, y) = ((place - a).dot(right), (place - a).dot(up).abs());
    // Where the way crosses the edge.
    let crossing = along + (x - along) * off / (off + y);
    let is_through = -ALONG * length <= crossing && crossing <= (1.0 + ALONG) * length;
    is_through.then(|| {
        let (x, y) = (x - along, off + y);
        (x * x + y * y).sqrt()
    })
}

/// Where the third corner of a triangle lies beside an edge, at which its first two are laid; the edge
/// may be as long on its other side as it wants.
fn unfolded([from, to]: [DVec2; 2], [a, b, c]: [DVec2; 3]) -> DVec2 {
    let (side, edge) = (b - a, to - from);
    let square = side.length_squared();
    let (along, across) = ((c - a).dot(side) / square, side.perp_dot(c - a) / square);
    from + edge * along + edge.perp() * across
}

fn lengths(topology: &Topology, corners: &[[Vec2; 3]]) -> Vec<Vec<f32>> {
    let mut sums: Vec<Vec<(f64, f64)>> = (topology.neighbors.iter())
        .map(|ring| vec![(0.0, 0.0); ring.len()])
        .collect();
    for (particles, corners) in topology.triangles.iter().zip(corners) {
        for [one, other] in [[0, 1], [1, 2], [2, 0]] {
            let length = corners[one].as_dvec2().distance(corners[other].as_dvec2());
            for [from, to] in [[one, other], [other, one]] {
                let from = particles[from] as usize;
                let place = topology.neighbors[from].binary_search(&particles[to]);
                if let Ok(place) = place {
                    sums[from][place].0 += length;
                    sums[from][place].1 += 1.0;
                }
            }
        }
    }
    let mean = |&(sum, count): &(f64, f64)| narrow(sum / count);
    sums.iter()
        .map(|ring| ring.iter().map(mean).collect())
        .collect()
}

/// Triangles around every particle in turn, from the border where there is one.
fn fans(topology: &Topology) -> Result<Vec<Fan>, MeshError> {
    let mut fans: Vec<Fan> = vec![Vec::new(); topology.neighbors.len()];
    for (index, &[a, b, c]) in topology.triangles.iter().enumerate() {
        for [middle, right, left] in [[a, b, c], [b, c, a], [c, a, b]] {
            fans[middle as usize].push(([right, left], index));
        }
    }
    for (particle, fan) in fans.iter_mut().enumerate() {
        let is_first = |&at: &usize| !fan.iter().any(|&([_, left], _)| left == fan[at].0[0]);
        let mut next = Some((0..fan.len()).find(is_first).unwrap_or(0));
        let mut sorted = Fan::with_capacity(fan.len());
        while let Some(at) = next.filter(|_| sorted.len() < fan.len()) {
            sorted.push(fan[at]);
            let left = fan[at].0[1];
            next = fan.iter().position(|&([right, _], _)| right == left);
            if next.is_some_and(|next| fan[next] == sorted[0]) {
                break;
            }
        }
        if sorted.len() < fan.len() {
            return Err(MeshError::NonManifoldVertex { particle });
        }
        *fan = sorted;
    }
    Ok(fans)
}

/// Room for the search of what is near.
struct Search {
    best: Vec<f32>,
    queue: BinaryHeap<Reverse<(u32, u32)>>,
}

impl Search {
    fn new(count: usize) -> Self {
        Self {
            best: vec![f32::INFINITY; count],
            queue: BinaryHeap::new(),
        }
    }

    /// What lies within `reach` [m] of a particle, itself left out, ascending.
    fn within(&mut self, hops: &[Vec<(u32, f32)>], from: u32, reach: f32) -> Vec<(u32, f32)> {
        let mut found = vec![from];
        self.best[from as usize] = 0.0;
        self.queue.push(Reverse((0, from)));
        while let Some(Reverse((bits, particle))) = self.queue.pop() {
            let length = self.best[particle as usize];
            if length.to_bits() < bits {
                continue;
            }
            for &(next, hop) in &hops[particle as usize] {
                let (beyond, best) = (length + hop, &mut self.best[next as usize]);
                if reach < beyond || *best <= beyond {
                    continue;
                }
                if best.is_infinite() {
                    found.push(next);
                }
                *best = beyond;
                self.queue.push(Reverse((beyond.to_bits(), next)));
            }
        }
        found.sort_unstable();
        let lengths = found.iter().map(|&it| (it, self.best[it as usize]));
        let near = lengths.filter(|&(it, _)| it != from).collect();
        for particle in found {
            self.best[particle as usize] = f32::INFINITY;
        }
        near
    }
}

/// Triangles, and their corners as they lie flat [m].
type Laid = (Vec<[u32; 3]>, Vec<[Vec2; 3]>);

/// The triangles of a welded piece, turned alike, and their flat corners counterclockwise.
pub(crate) fn oriented(spec: &MeshSpec) -> Result<Laid, MeshError> {
    let mut triangles = spec.triangles.clone();
    let mut corners = spec.flat_corners.clone();
    let turns = turns(&spec.triangles)?;
    for ((triangle, corners), is_turned) in triangles.iter_mut().zip(&mut corners).zip(turns) {
        if is_turned {
            triangle.swap(1, 2);
            corners.swap(1, 2);
        }
        let [a, b, c] = *corners;
        if (b - a).perp_dot(c - a) < 0.0 {
            *corners = corners.map(|corner| Vec2::new(corner.x, -corner.y));
        }
    }
    Ok((triangles, corners))
}

/// Whether each triangle must be turned, so that all of a part are turned like its first.
fn turns(triangles: &[[u32; 3]]) -> Result<Vec<bool>, MeshError> {
    // By edge, its triangles and whether they walk it upwards.
    let mut sides: Vec<([u32; 2], usize, bool)> = Vec::with_capacity(3 * triangles.len());
    for (index, &[a, b, c]) in triangles.iter().enumerate() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            sides.push(([from.min(to), from.max(to)], index, from < to));
        }
    }
    sides.sort_unstable();
    let mut beside: Vec<Vec<(usize, bool, [u32; 2])>> = vec![Vec::new(); triangles.len()];
    for same in sides.chunk_by(|one, other| one.0 == other.0) {
        match *same {
            [_] => {}
            [(edge, one, upward), (_, other, other_upward)] => {
                beside[one].push((other, upward == other_upward, edge));
                beside[other].push((one, upward == other_upward, edge));
            }
            _ => {
                let [first, second] = same[0].0;
                return Err(MeshError::NonManifoldEdge {
                    first,
                    second,
                    triangle_count: same.len(),
                });
            }
        }
    }
    let mut turns: Vec<Option<bool>> = vec![None; triangles.len()];
    for start in 0..triangles.len() {
        if turns[start].is_some() {
            continue;
        }
        turns[start] = Some(false);
        let mut stack = vec![(start, false)];
        while let Some((here, is_turned)) = stack.pop() {
            for &(next, is_against, [first, second]) in &beside[here] {
                let wanted = is_turned != is_against;
                match turns[next] {
                    None => {
                        turns[next] = Some(wanted);
                        stack.push((next, wanted));
                    }
                    Some(found) if found != wanted => {
                        return Err(MeshError::OneSided { first, second });
                    }
                    Some(_) => {}
                }
            }
        }
    }
    Ok(turns.into_iter().map(|turn| turn == Some(true)).collect())
}
