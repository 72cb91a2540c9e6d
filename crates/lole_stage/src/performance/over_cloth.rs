//! The body as a lei meets it: skin, raised to the cloth that lies over it.
//!
//! A string of flowers is five centimeters across and lies on the outside of folds. Cloth met vertex by
//! vertex, with the skin a few millimeters below it, pushes such a string now one way and now another,
//! and threw it about. Skin is smooth and moves without jumps, so where cloth lies over it, it is raised
//! to that; only cloth that hangs far from the skin is met by itself.

use std::sync::Arc;

use glam::Vec3;
use lole_geom::mesh::vertex_normals;
use lole_geom::{Surfel, TriangleGrid};

use super::order::Inner;

/// Skin is raised this far at most [m].
const REACH: f32 = 0.06;
/// Cloth farther from the skin than this as she stands hangs by itself [m].
const LOOSE: f32 = 0.05;
/// Skin this near is raised alike [m]: half of a flower.
const ALIKE: f32 = 0.025;
/// Skin and cloth that face each other's way less than this cosine do not lie on each other.
const SAME_WAY: f32 = 0.3;
/// Only what is this near to a strand is looked at [m]: more than what it meets and what is alike.
const MARGIN: f32 = 0.12;
/// Cells of the search [m]: about two edges of the cloth.
const CELL: f32 = 0.03;

/// What does not change from frame to frame, and room.
#[derive(Clone, Default)]
pub(super) struct OverCloth {
    /// Of every surfel of the skin, those that are raised alike, itself among them.
    alike: Arc<Vec<Vec<u32>>>,
    /// By garment, particles that hang far from the skin.
    loose: Arc<Vec<Vec<u32>>>,
    /// How far each surfel is raised [m] and which way it faces then, as it was found and as it is spread.
    found: Vec<(f32, Vec3)>,
    raised: Vec<(f32, Vec3)>,
    far: Vec<Surfel>,
}

impl OverCloth {
    /// Looks at a dancer who stands in her garments.
    pub(super) fn new(skin: &[Surfel], cloth: &[Inner<'_>]) -> Self {
        let is_near = |a: &Surfel, b: &Surfel| {
            a.position.distance_squared(b.position) < ALIKE * ALIKE
                && SAME_WAY < a.normal.dot(b.normal)
        };
        // By height, so that a slice of her is looked at and not all of her.
        let height = |place: u32| skin[place as usize].position.y;
        let mut by_height: Vec<u32> = (0..).take(skin.len()).collect();
        by_height.sort_by(|&a, &b| height(a).total_cmp(&height(b)));
        let around = |y: f32, reach: f32| {
            let below = |limit: f32| by_height.partition_point(|&place| height(place) < limit);
            let slice = below(y - reach)..below(y + reach);
            by_height[slice].iter().copied()
        };
        let alike = skin.iter().map(|one| {
            let mut near: Vec<u32> = around(one.position.y, ALIKE)
                .filter(|&place| is_near(one, &skin[place as usize]))
                .collect();
            near.sort_unstable();
            near
        });
        let loose = cloth.iter().map(|(_, positions)| {
            let all = (0..).zip(*positions);
            let loose = all.filter(|(_, place)| {
                let apart = |one: u32| skin[one as usize].position.distance_squared(**place);
                around(place.y, LOOSE).all(|one| LOOSE * LOOSE < apart(one))
            });
            loose.map(|(particle, _)| particle).collect()
        });
        Self {
            alike: Arc::new(alike.collect()),
            loose: Arc::new(loose.collect()),
            ..Self::default()
        }
    }

    /// Finds how far the cloth raises the skin near the places of strands [m].
    pub(super) fn look(&mut self, skin: &[Surfel], cloth: &[Inner<'_>], strands: &[Vec3]) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = strands.iter().fold(start, |(low, high), &place| {
            (low.min(place), high.max(place))
        });
        let (low, high) = (low - MARGIN, high + MARGIN);
        let is_near = |place: Vec3| place.cmpge(low).all() && place.cmple(high).all();
        self.found.clear();
        (self.found).extend(skin.iter().map(|surfel| (0.0, surfel.normal)));
        self.far.clear();
        let mut crossed = Vec::new();
        for (&(triangles, positions), loose) in cloth.iter().zip(&*self.loose) {
            let near: Vec<[u32; 3]> = (triangles.iter().copied())
                .filter(|corners| {
                    corners
                        .iter()
                        .any(|&corner| is_near(positions[corner as usize]))
                })
                .collect();
            let grid = TriangleGrid::new(positions, &near, CELL);
            for (surfel, found) in skin.iter().zip(&mut self.found) {
                if is_near(surfel.position) {
                    outermost(surfel, (&grid, &near, positions), (&mut crossed, found));
                }
            }
            let met = |particle: &&u32| is_near(positions[**particle as usize]);
            if !loose.iter().any(|particle| met(&particle)) {
                continue;
            }
            // All triangles around what is near are near.
            let normals = vertex_normals(positions, &near);
            let met = loose.iter().filter(met);
            self.far.extend(met.map(|&particle| Surfel {
                position: positions[particle as usize],
                normal: normals[particle as usize],
            }));
        }
        self.spread();
    }

    /// The mean of what is alike: half of a flower does not follow a fold, and rests a few millimeters
    /// deeper than its crests.
    fn spread(&mut self) {
        self.raised.clear();
        for alike in &*self.alike {
            let found = alike.iter().map(|&place| self.found[place as usize]);
            let sum = found.fold((0.0, Vec3::ZERO), |sum, one| (sum.0 + one.0, sum.1 + one.1));
            let height = sum.0 / alike.len().max(1) as f32;
            self.raised.push((height, sum.1.normalize_or_zero()));
        }
    }

    /// Raises the skin to the cloth that was looked at last.
    pub(super) fn raise(&self, skin: &mut [Surfel]) {
        for (surfel, (height, normal)) in skin.iter_mut().zip(&self.raised) {
            if 0.0 < *height {
                surfel.position += surfel.normal * *height;
                surfel.normal = *normal;
            }
        }
    }

    /// Cloth near the strands that hangs far from the skin.
    pub(super) fn far(&self) -> &[Surfel] {
        &self.far
    }

    /// How the skin nearest to a place was raised when it was looked at last [m].
    pub(super) fn lift(&self, skin: &[Surfel], place: Vec3) -> Vec3 {
        let apart = |surfel: &Surfel| surfel.position.distance_squared(place);
        let pairs = skin.iter().zip(&self.raised);
        let nearest = pairs.min_by(|a, b| apart(a.0).total_cmp(&apart(b.0)));
        nearest.map_or(Vec3::ZERO, |(surfel, raised)| surfel.normal * raised.0)
    }
}

/// Finds how high the outermost cloth lies over a surfel [m], and its normal there.
fn outermost(
    surfel: &Surfel,
    (grid, triangles, positions): (&TriangleGrid<'_>, &[[u32; 3]], &[Vec3]),
    (crossed, found): (&mut Vec<u32>, &mut (f32, Vec3)),
) {
    let out = surfel.position + surfel.normal * REACH;
    grid.crossed_by(surfel.position, out, crossed);
    for &triangle in &*crossed {
        let [a, b, c] = triangles[triangle as usize].map(|corner| positions[corner as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let facing = normal.dot(surfel.normal);
        if facing < SAME_WAY {
            continue;
        }
        let height = ((a - surfel.position).dot(normal) / facing).clamp(0.0, REACH);
        if found.0 < height {
            *found = (height, normal);
        }
    }
}
