//! The skin as surfels, close enough together that cloth meets the drawn body in them.

use glam::Vec3;
use lole_geom::{Surfel, TriangleGrid};

/// Points spread over a skin's triangles, carried by their corners.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SkinSurfels {
    /// Corners, and their shares, which sum to 1.
    points: Vec<([u32; 3], [f32; 3])>,
}

impl SkinSurfels {
    /// Spreads points over `triangles` of a mesh with these bind `positions` [m], so that none of
    /// them is farther than about half of `spacing` [m] from one: at every corner, along every edge
    /// and inside.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]], spacing: f32) -> Self {
        let mut points = Vec::new();
        let mut corners: Vec<u32> = triangles.iter().flatten().copied().collect();
        corners.sort_unstable();
        corners.dedup();
        points.extend(corners.iter().map(|&corner| ([corner; 3], [1.0, 0.0, 0.0])));
        let mut edges: Vec<[u32; 2]> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let length = |[a, b]: [u32; 2]| positions[a as usize].distance(positions[b as usize]);
        for edge in edges {
            let parts = parts(length(edge), spacing);
            let [a, b] = edge;
            points.extend((1..parts).map(|part| {
                let share = ratio(part, parts);
                ([a, b, a], [1.0 - share, share, 0.0])
            }));
        }
        for &[a, b, c] in triangles {
            let longest = length([a, b]).max(length([b, c])).max(length([c, a]));
            let parts = parts(longest, spacing);
            for first in 1..parts {
                for second in 1..parts - first {
                    let shares = [ratio(first, parts), ratio(second, parts)];
                    points.push((
                        [a, b, c],
                        [shares[0], shares[1], 1.0 - shares[0] - shares[1]],
                    ));
                }
            }
        }
        Self { points }
    }

    /// The points of a mesh that are nearest to `places` [m] in the bind pose, one each; a place
    /// farther than `reach` [m] from the mesh is refused.
    #[must_use]
    pub fn nearest_to(
        places: impl IntoIterator<Item = Vec3>,
        (positions, triangles): (&[Vec3], &[[u32; 3]]),
        reach: f32,
    ) -> Option<Self> {
        let grid = TriangleGrid::new(positions, triangles, reach);
        let point = |place| {
            let nearest = grid.nearest(place, reach)?;
            let corners = triangles[nearest.triangle as usize];
            Some((corners, nearest.barycentric.to_array()))
        };
        let points = places.into_iter().map(point).collect::<Option<_>>()?;
        Some(Self { points })
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The vertex that has most of each.
    pub fn carriers(&self) -> impl Iterator<Item = u32> {
        (0..self.len()).map(|surfel| self.carrier(surfel))
    }

    /// The vertex that has most of one.
    #[must_use]
    pub fn carrier(&self, surfel: usize) -> u32 {
        let (corners, shares) = self.points[surfel];
        let most = (1..3).fold(0, |most, next| {
            if shares[most] < shares[next] {
                next
            } else {
                most
            }
        });
        corners[most]
    }

    /// Where they are on the posed mesh; `surfels` is cleared and filled.
    pub fn pose(&self, positions: &[Vec3], normals: &[Vec3], surfels: &mut Vec<Surfel>) {
        surfels.clear();
        surfels.extend(self.points.iter().map(|&(corners, shares)| {
            let [a, b, c] = corners.map(|corner| corner as usize);
            let blend = |values: &[Vec3]| {
                values[a] * shares[0] + values[b] * shares[1] + values[c] * shares[2]
            };
            Surfel {
                position: blend(positions),
                normal: blend(normals).normalize_or_zero(),
            }
        }));
    }
}

/// Parts of at most `spacing` into which a length is cut.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "an edge of a body is a few times the spacing"
)]
fn parts(length: f32, spacing: f32) -> u16 {
    (length / spacing).ceil().clamp(1.0, 1000.0) as u16
}

fn ratio(part: u16, parts: u16) -> f32 {
    f32::from(part) / f32::from(parts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Dancer, Measurements, Pose};

    #[test]
    fn every_place_of_the_skin_has_a_surfel_near_and_all_lie_on_it() {
        let dancer = Dancer::new(&Measurements::woman()).unwrap();
        let skin = &dancer.skin;
        let triangles = skin.body_triangles();
        let spacing = 0.012;
        let samples = SkinSurfels::new(&skin.positions, &triangles, spacing);
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world_from_bind = dancer.skeleton.world_from_bind(&Pose::default());
        skin.pose(&world_from_bind, &mut positions, &mut normals);
        let mut surfels = Vec::new();
        samples.pose(&positions, &normals, &mut surfels);
        assert_eq!(surfels.len(), samples.len());
        let grid = TriangleGrid::new(&positions, &triangles, 0.03);
        for surfel in &surfels {
            let nearest = grid.nearest(surfel.position, 0.01).expect("on the skin");
            assert!(nearest.distance < 1e-5);
            assert!((surfel.normal.length() - 1.0).abs() < 1e-4);
        }
        for triangle in triangles.iter().step_by(7) {
            let [a, b, c] = triangle.map(|corner| positions[corner as usize]);
            let place = a * 0.4 + b * 0.35 + c * 0.25;
            let gap = surfels
                .iter()
                .map(|surfel| surfel.position.distance(place))
                .fold(f32::INFINITY, f32::min);
            assert!(gap <= 0.75 * spacing, "{gap}");
        }
    }
}
