//! A moving triangle mesh as surfels, close enough together that cloth meets the mesh in them.

use crate::{Surfel, TriangleGrid};
use glam::Vec3;

/// Points spread over the triangles of a mesh, carried by their corners.
///
/// What cloth meets of a body that is known as vertices, normals and triangles: spread once, posed in every
/// frame from where the vertices are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshSurfels {
    /// Corners, and their shares, which sum to 1.
    points: Vec<([u32; 3], [f32; 3])>,
}

impl MeshSurfels {
    /// Spreads points over `triangles` of a mesh with these `positions` [m], so that none of
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

    /// The points of a mesh that are nearest to `places` [m] one each; a place
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

    /// An octahedron of a radius [m] whose sides are long against the spacing.
    fn octahedron(radius: f32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let axes = [Vec3::X, Vec3::Y, Vec3::Z];
        let corners = axes.into_iter().flat_map(|axis| [axis, -axis]);
        let triangles = (0..8_u32).map(|side| {
            let [a, b, c] = [0, 1, 2].map(|axis| 2 * axis + ((side >> axis) & 1));
            if side.count_ones().is_multiple_of(2) {
                [a, b, c]
            } else {
                [a, c, b]
            }
        });
        (
            corners.map(|corner| corner * radius).collect(),
            triangles.collect(),
        )
    }

    #[test]
    fn every_place_has_a_surfel_near_and_all_lie_on_the_moved_mesh() {
        let spacing = 0.012;
        let (rest, triangles) = octahedron(0.1);
        let samples = MeshSurfels::new(&rest, &triangles, spacing);
        let turn = glam::Quat::from_rotation_z(0.7);
        let moved: Vec<Vec3> = rest.iter().map(|&at| turn * at + Vec3::X).collect();
        let normals: Vec<Vec3> = (rest.iter())
            .map(|&at| turn * at.normalize_or_zero())
            .collect();
        let mut surfels = Vec::new();
        samples.pose(&moved, &normals, &mut surfels);
        assert_eq!(surfels.len(), samples.len());
        let grid = TriangleGrid::new(&moved, &triangles, 0.03);
        for surfel in &surfels {
            let nearest = grid.nearest(surfel.position, 0.01).expect("on the mesh");
            assert!(nearest.distance < 1e-5);
            assert!((surfel.normal.length() - 1.0).abs() < 1e-4);
            assert!(
                0.0 < surfel.normal.dot(surfel.position - Vec3::X),
                "outward"
            );
        }
        for triangle in triangles {
            let [a, b, c] = triangle.map(|corner| moved[corner as usize]);
            for (i, j) in (0..20_u8).flat_map(|i| (0..20 - i).map(move |j| (i, j))) {
                let [u, v] = [i, j].map(|it| f32::from(it) / 20.0);
                let place = a * u + b * v + c * (1.0 - u - v);
                let gaps = surfels.iter().map(|it| it.position.distance(place));
                let gap = gaps.fold(f32::INFINITY, f32::min);
                assert!(gap <= 0.75 * spacing, "{gap}");
            }
        }
    }

    #[test]
    fn what_is_far_from_the_mesh_has_no_nearest_point() {
        let (rest, triangles) = octahedron(0.1);
        let mesh = (&rest[..], &triangles[..]);
        let found = MeshSurfels::nearest_to([Vec3::X * 0.11], mesh, 0.02).expect("near");
        assert_eq!(
            (found.len(), found.is_empty(), found.carrier(0)),
            (1, false, 0)
        );
        assert_eq!(MeshSurfels::nearest_to([Vec3::X * 0.2], mesh, 0.02), None);
    }
}
