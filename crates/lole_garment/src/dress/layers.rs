//! Which cloth of a garment lies outside where it covers itself: turns of a wrap, a flap over its band, a
//! front over a back, a tuck over what it is tucked from.
//!
//! Outside is away from the nearest skin. Both sides of one fold are near each other in the cloth, and which
//! of them is outside changes as the fold swings; so layers are cloth that is farther apart in the garment
//! than a fold is deep, along its cloth and through its seams.

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use glam::Vec3;
use lole_geom::TriangleGrid;
use lole_language::Words;

use super::{Dressed, EDGE};

/// Cloth between two places that may be sides of one fold [m].
const FOLD: f32 = 0.20;
/// Cloth over other cloth is no farther from it than this [m].
const COVERS: f32 = 0.04;
/// Skin that cloth lies over is no farther from it than this [m].
const SKIN: f32 = 0.30;
/// Cells of the search for skin [m].
const SKIN_CELL: f32 = 0.03;
/// Cells of the search for cloth over the edge of its triangles.
const CELL_EDGES: f32 = 1.5;

/// The body that a garment is on.
#[derive(Debug, Clone, Copy)]
pub struct Body<'a> {
    /// Vertices of the skin [m].
    pub positions: &'a [Vec3],
    /// Unit normals there, outward.
    pub normals: &'a [Vec3],
    /// Triangles between them.
    pub triangles: &'a [[u32; 3]],
}

/// A place where a garment covers itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Over {
    /// The particle that lies inside.
    pub inner: u32,
    /// Corners of the triangle over it.
    pub outer: [u32; 3],
    /// How far that is outside [m].
    pub gap: f32,
}

/// One piece of a garment over another of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PieceOver {
    /// Which lies outside.
    pub outer: Words,
    /// Which it lies over.
    pub inner: Words,
    /// Whether both are one piece of cloth: a turn or a tuck of it. Otherwise two of one name were cut
    /// from the same piece of the pattern.
    pub is_itself: bool,
    /// At how many places.
    pub places: usize,
}

/// What lies over what as a garment is put on.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Layers {
    places: Vec<Over>,
    /// Pairs of a particle and another over it.
    over: BTreeSet<[u32; 2]>,
}

impl Layers {
    /// Looks at a garment whose particles lie at `positions` [m].
    #[must_use]
    pub fn new(garment: &Dressed, positions: &[Vec3], body: Body<'_>) -> Self {
        let places = overlaps(garment, positions, body);
        let pairs = places.iter().flat_map(|place| {
            let outer = place.outer.into_iter();
            outer.map(|outer| [garment.welded[place.inner as usize], outer])
        });
        let over = pairs.map(|[inner, outer]| [inner, garment.welded[outer as usize]]);
        Self {
            over: over.collect(),
            places,
        }
    }

    /// Every place where it covers itself.
    #[must_use]
    pub fn places(&self) -> &[Over] {
        &self.places
    }

    /// Which pieces lie over which and at how many places, by what the paper calls them.
    #[must_use]
    pub fn pieces(&self, garment: &Dressed) -> Vec<PieceOver> {
        let mut found: Vec<PieceOver> = Vec::new();
        for place in &self.places {
            let [inner, outer] =
                [place.inner, place.outer[0]].map(|it| garment.panel_of[it as usize]);
            let name = |panel: u32| garment.pattern.pieces[garment.pieces[panel as usize]].name;
            let over = PieceOver {
                outer: name(outer),
                inner: name(inner),
                is_itself: inner == outer,
                places: 0,
            };
            let known = found
                .iter_mut()
                .position(|it| PieceOver { places: 0, ..*it } == over);
            let known = known.unwrap_or_else(|| {
                found.push(over);
                found.len() - 1
            });
            found[known].places += 1;
        }
        found
    }

    /// Places where cloth lies inside now that these layers have over what now covers it.
    #[must_use]
    pub fn inversions(&self, garment: &Dressed, positions: &[Vec3], body: Body<'_>) -> usize {
        let now = Self::new(garment, positions, body);
        let is_inverted = |place: &&Over| {
            let inner = garment.welded[place.inner as usize];
            place.outer.iter().any(|&outer| {
                let outer = garment.welded[outer as usize];
                self.over.contains(&[outer, inner]) && !self.over.contains(&[inner, outer])
            })
        };
        now.places.iter().filter(is_inverted).count()
    }
}

/// Every particle with what lies over it.
fn overlaps(garment: &Dressed, positions: &[Vec3], body: Body<'_>) -> Vec<Over> {
    if !positions.iter().all(|place| place.is_finite()) {
        return Vec::new();
    }
    let closed = garment.closed(positions);
    let skin = TriangleGrid::new(body.positions, body.triangles, SKIN_CELL);
    let cloth = TriangleGrid::new(&closed, &garment.triangles, CELL_EDGES * EDGE);
    let nearness = Nearness::new(garment);
    let (mut near, mut found) = (Vec::new(), Vec::new());
    for (particle, &place) in (0_u32..).zip(&closed) {
        let Some(outward) = outward(&skin, body, place) else {
            continue;
        };
        let end = place + outward * COVERS;
        cloth.near_segment(place, end, &mut near);
        let hits = near.iter().filter_map(|&triangle| {
            let outer = garment.triangles[triangle as usize];
            let corners = outer.map(|corner| closed[corner as usize]);
            Some((outer, hit(place, outward, corners)?))
        });
        let hits: Vec<([u32; 3], f32)> = hits.filter(|(_, gap)| *gap < COVERS).collect();
        if hits.is_empty() {
            continue;
        }
        let fold = nearness.around(garment.welded[particle as usize]);
        let is_fold = |outer: &[u32; 3]| {
            let corners = outer.iter().map(|&corner| garment.welded[corner as usize]);
            corners.into_iter().any(|corner| fold.contains(&corner))
        };
        let over = hits.into_iter().filter(|(outer, _)| !is_fold(outer));
        found.extend(over.map(|(outer, gap)| Over {
            inner: particle,
            outer,
            gap,
        }));
    }
    found
}

/// Away from the nearest skin.
fn outward(skin: &TriangleGrid<'_>, body: Body<'_>, place: Vec3) -> Option<Vec3> {
    let nearest = skin.nearest(place, SKIN)?;
    let corners = body.triangles[nearest.triangle as usize];
    let normals = corners.map(|corner| body.normals[corner as usize]);
    lole_geom::triangle_grid::blend(normals, nearest.barycentric).try_normalize()
}

/// How far along a direction a triangle lies (Möller and Trumbore 1997), `None` where it is not in the way.
fn hit(from: Vec3, along: Vec3, [a, b, c]: [Vec3; 3]) -> Option<f32> {
    let (e1, e2) = (b - a, c - a);
    let across = along.cross(e2);
    let volume = e1.dot(across);
    let arm = from - a;
    let beside = arm.cross(e1);
    let [u, v, t] = [arm.dot(across), along.dot(beside), e2.dot(beside)].map(|it| it / volume);
    let is_inside = 0.0 <= u && 0.0 <= v && u + v <= 1.0 && 0.0 < t;
    is_inside.then_some(t)
}

/// How much cloth lies between the particles of a garment.
struct Nearness {
    /// By particle, those beside it and the cloth between [m], with seams closed.
    neighbors: Vec<Vec<(u32, f32)>>,
}

impl Nearness {
    fn new(garment: &Dressed) -> Self {
        let mut neighbors = vec![Vec::new(); garment.start.len()];
        for &[a, b, c] in &garment.triangles {
            for [one, other] in [[a, b], [b, c], [c, a]] {
                let [from, to] = [one, other].map(|it| garment.on_cloth[it as usize]);
                let [one, other] = [one, other].map(|it| garment.welded[it as usize]);
                let length = from.distance(to);
                neighbors[one as usize].push((other, length));
                neighbors[other as usize].push((one, length));
            }
        }
        Self { neighbors }
    }

    /// Particles that no more cloth than a fold's lies between.
    fn around(&self, particle: u32) -> BTreeSet<u32> {
        let mut reached = BTreeSet::new();
        let mut queue = BinaryHeap::from([Reverse((0_u32, particle))]);
        while let Some(Reverse((bits, next))) = queue.pop() {
            if !reached.insert(next) {
                continue;
            }
            // Bits of a number that is not negative have its order.
            let length = f32::from_bits(bits);
            for &(other, step) in &self.neighbors[next as usize] {
                if length + step < FOLD && !reached.contains(&other) {
                    queue.push(Reverse(((length + step).to_bits(), other)));
                }
            }
        }
        reached
    }
}
