//! The left half of a mirror-symmetric surface, its neighbors, and smoothing that keeps the
//! mirror plane.

use glam::Vec3;

use super::warp::smooth_step;
use crate::sections::Tube;

/// Inner vertices keep at least this far from the mirror plane [m].
const LEAST_X: f32 = 1.0e-6;

/// Left half (`x >= 0`) of a closed surface; its border lies in the plane `x = 0` exactly.
#[derive(Debug, Clone, Default)]
pub(crate) struct HalfMesh {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The tube each vertex belongs to.
    pub(crate) labels: Vec<Tube>,
}

/// Neighbors of every vertex in one array.
pub(crate) struct Neighbors {
    starts: Vec<u32>,
    vertices: Vec<u32>,
}

impl Neighbors {
    pub(crate) fn new(vertex_count: usize, triangles: &[[u32; 3]]) -> Self {
        // Every edge of a closed surface comes twice: room for both, then each list is sorted and
        // thinned where it lies, which one sort of all edges would take five times as long for.
        let ends = |&[a, b, c]: &[u32; 3]| [[a, b], [a, c], [b, a], [b, c], [c, a], [c, b]];
        let mut room = vec![0_u32; vertex_count + 1];
        for [from, _] in triangles.iter().flat_map(ends) {
            room[from as usize + 1] += 1;
        }
        for index in 0..vertex_count {
            room[index + 1] += room[index];
        }
        let mut filled = room.clone();
        let mut all = vec![0_u32; triangles.len() * 6];
        for [from, to] in triangles.iter().flat_map(ends) {
            let slot = &mut filled[from as usize];
            all[*slot as usize] = to;
            *slot += 1;
        }
        let mut starts = Vec::with_capacity(vertex_count + 1);
        let mut vertices = Vec::with_capacity(triangles.len() * 3);
        for vertex in 0..vertex_count {
            starts.push(u32::try_from(vertices.len()).unwrap_or(u32::MAX));
            let list = &mut all[room[vertex] as usize..room[vertex + 1] as usize];
            list.sort_unstable();
            let mut last = u32::MAX;
            for &mut other in list {
                if other != last {
                    vertices.push(other);
                    last = other;
                }
            }
        }
        starts.push(u32::try_from(vertices.len()).unwrap_or(u32::MAX));
        Self { starts, vertices }
    }

    pub(crate) fn of(&self, vertex: usize) -> &[u32] {
        &self.vertices[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// Mean of the neighbors of `vertex`; on the mirror plane the unseen half counts too.
    pub(crate) fn mean(&self, positions: &[Vec3], vertex: usize) -> Vec3 {
        let on_plane = is_on_plane(positions[vertex]);
        let mut sum = Vec3::ZERO;
        let mut count = 0.0;
        for &neighbor in self.of(vertex) {
            let mut position = positions[neighbor as usize];
            let mut share = 1.0;
            if on_plane && !is_on_plane(position) {
                position.x = 0.0;
                share = 2.0;
            }
            sum += position * share;
            count += share;
        }
        if count > 0.0 {
            sum / count
        } else {
            positions[vertex]
        }
    }
}

impl Neighbors {
    /// Unit mean of the normals around a vertex.
    fn mean_normal(&self, normals: &[Vec3], vertex: usize) -> Vec3 {
        let sum: Vec3 = (self.of(vertex).iter())
            .map(|&neighbor| normals[neighbor as usize])
            .sum();
        sum.normalize_or(normals[vertex])
    }
}

/// The border of the half lies at `x = 0` exactly.
pub(crate) fn is_on_plane(position: Vec3) -> bool {
    position.x == 0.0
}

/// Keeps a border vertex in the plane and any other off it.
fn kept_on_side(before: Vec3, moved: Vec3) -> Vec3 {
    let x = if is_on_plane(before) {
        0.0
    } else {
        moved.x.max(LEAST_X)
    };
    Vec3::new(x, moved.y, moved.z)
}

impl HalfMesh {
    pub(crate) fn neighbors(&self) -> Neighbors {
        Neighbors::new(self.positions.len(), &self.triangles)
    }

    /// Keeps the largest connected piece, and returns its neighbors.
    pub(crate) fn keep_largest(&mut self) -> Neighbors {
        let neighbors = self.neighbors();
        let mut piece_of = vec![usize::MAX; self.positions.len()];
        let mut sizes = Vec::new();
        for seed in 0..self.positions.len() {
            if piece_of[seed] != usize::MAX {
                continue;
            }
            let piece = sizes.len();
            let mut size = 0;
            let mut open = vec![seed];
            piece_of[seed] = piece;
            while let Some(vertex) = open.pop() {
                size += 1;
                let around = neighbors.of(vertex).iter().map(|&next| next as usize);
                // Marked as they are found, so that none is found twice.
                open.extend(
                    around.filter(|&next| {
                        std::mem::replace(&mut piece_of[next], piece) == usize::MAX
                    }),
                );
            }
            sizes.push(size);
        }
        if sizes.len() < 2 {
            return neighbors;
        }
        let largest = (0..sizes.len())
            .max_by_key(|&piece| sizes[piece])
            .unwrap_or(0);
        let kept: Vec<bool> = piece_of.iter().map(|&piece| piece == largest).collect();
        self.retain(&kept);
        self.neighbors()
    }

    /// Vertices minus edges plus triangles: 1 for a disk, 2 less for every handle.
    pub(crate) fn euler_characteristic(&self) -> i64 {
        let count = |len: usize| i64::try_from(len).unwrap_or(i64::MAX);
        // Every inner edge is met twice, every border edge once.
        let borders = (self.triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .filter(|edge| {
                edge.iter()
                    .all(|&end| is_on_plane(self.positions[end as usize]))
            })
            .count();
        let edges = (self.triangles.len() * 3 + borders) / 2;
        count(self.positions.len()) - count(edges) + count(self.triangles.len())
    }

    /// Drops vertices and every triangle that uses one.
    pub(crate) fn retain(&mut self, kept: &[bool]) {
        let mut renamed = vec![u32::MAX; self.positions.len()];
        let mut positions = Vec::new();
        let mut labels = Vec::new();
        for (vertex, &keep) in kept.iter().enumerate() {
            if keep {
                renamed[vertex] = u32::try_from(positions.len()).unwrap_or(u32::MAX);
                positions.push(self.positions[vertex]);
                labels.push(self.labels[vertex]);
            }
        }
        self.triangles
            .retain(|triangle| triangle.iter().all(|&vertex| kept[vertex as usize]));
        for triangle in &mut self.triangles {
            *triangle = triangle.map(|vertex| renamed[vertex as usize]);
        }
        self.positions = positions;
        self.labels = labels;
    }

    /// Taubin 1995: steps forward and back that smooth without shrinking.
    pub(crate) fn smooth(&mut self, neighbors: &Neighbors, pass_count: usize) {
        const FORWARD: f32 = 0.5;
        const BACK: f32 = -0.53;
        for _ in 0..pass_count {
            self.step_to_mean(neighbors, FORWARD);
            self.step_to_mean(neighbors, BACK);
        }
    }

    /// Moves every vertex a share of the way to the mean of its neighbors.
    fn step_to_mean(&mut self, neighbors: &Neighbors, share: f32) {
        let before = self.positions.clone();
        for (vertex, position) in self.positions.iter_mut().enumerate() {
            let moved = *position + (neighbors.mean(&before, vertex) - *position) * share;
            *position = kept_on_side(*position, moved);
        }
    }

    /// Laplacian fairing within balls `(center, radius)`, fading to nothing at the radius.
    pub(crate) fn fair(&mut self, neighbors: &Neighbors, balls: &[(Vec3, f32)], passes: usize) {
        let mut near: Vec<(usize, f32)> = Vec::new();
        for (vertex, &position) in self.positions.iter().enumerate() {
            let weight = (balls.iter())
                .map(|&(center, radius)| {
                    let share = (position - center).length_squared() / (radius * radius);
                    (1.4 * (1.0 - share)).clamp(0.0, 1.0)
                })
                .fold(0.0, f32::max);
            if weight > 0.0 {
                near.push((vertex, 0.5 * weight));
            }
        }
        let mut moved = vec![Vec3::ZERO; near.len()];
        for _ in 0..passes {
            for (&(vertex, weight), moved) in near.iter().zip(&mut moved) {
                let position = self.positions[vertex];
                *moved = position + (neighbors.mean(&self.positions, vertex) - position) * weight;
                *moved = kept_on_side(position, *moved);
            }
            for (&(vertex, _), &moved) in near.iter().zip(&moved) {
                self.positions[vertex] = moved;
            }
        }
    }

    /// Area-weighted normals, with the unseen half, smoothed once over neighbors.
    pub(crate) fn normals(&self, neighbors: &Neighbors) -> Vec<Vec3> {
        let mut normals = lole_geom::mesh::vertex_normals(&self.positions, &self.triangles);
        self.flatten(&mut normals);
        for _ in 0..2 {
            let before = normals.clone();
            for (vertex, normal) in normals.iter_mut().enumerate() {
                for &neighbor in neighbors.of(vertex) {
                    *normal += before[neighbor as usize] * 0.5;
                }
            }
            self.flatten(&mut normals);
        }
        normals
    }

    /// Evens out normals within balls: the surface keeps its shape, but light no longer shows every
    /// dent of the sections.
    pub(crate) fn soften_normals(
        &self,
        normals: &mut [Vec3],
        neighbors: &Neighbors,
        balls: &[(Vec3, f32)],
        passes: usize,
    ) {
        let share = |point: Vec3| {
            (balls.iter())
                .map(|&(center, radius)| smooth_step(2.0 * (1.0 - point.distance(center) / radius)))
                .fold(0.0, f32::max)
        };
        let near: Vec<(usize, f32)> = (self.positions.iter().enumerate())
            .map(|(vertex, &point)| (vertex, share(point)))
            .filter(|&(_, share)| share > 0.0)
            .collect();
        for _ in 0..passes {
            let before = normals.to_vec();
            for &(vertex, share) in &near {
                let mean = neighbors.mean_normal(&before, vertex);
                normals[vertex] = before[vertex].lerp(mean, share);
            }
            self.flatten(normals);
        }
    }

    /// Unit length; in the mirror plane where the vertex is.
    fn flatten(&self, normals: &mut [Vec3]) {
        for (normal, &position) in normals.iter_mut().zip(&self.positions) {
            if is_on_plane(position) {
                normal.x = 0.0;
            }
            *normal = normal.normalize_or_zero();
        }
    }
}
