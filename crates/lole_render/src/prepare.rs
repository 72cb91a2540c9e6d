//! All meshes of a scene as one list of vertices and one of triangles.

use crate::{Bounds, Scene, SceneMesh, Sides};
use glam::{Vec2, Vec3};
use lole_geom::mesh::vertex_normals;
use std::ops::Range;

/// The meshes of a scene, one after the other.
pub(crate) struct Geometry {
    /// Positions [m].
    pub(crate) positions: Vec<Vec3>,
    /// Unit normals; zero where a vertex belongs to no area.
    pub(crate) normals: Vec<Vec3>,
    /// Texture coordinates.
    pub(crate) uvs: Vec<Vec2>,
    /// Linear color factors.
    pub(crate) colors: Vec<Vec3>,
    /// Indices into the lists above.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangles and sides of each mesh, in the scene's order.
    pub(crate) parts: Vec<Part>,
}

/// What belongs to one mesh.
pub(crate) struct Part {
    /// Its triangles.
    pub(crate) triangles: Range<u32>,
    /// Which of its sides are drawn.
    pub(crate) sides: Sides,
}

impl Geometry {
    /// Gathers the meshes of a checked scene.
    pub(crate) fn of(scene: &Scene<'_>) -> Self {
        let vertex_count = scene.meshes.iter().map(|mesh| mesh.positions.len()).sum();
        let mut all = Self {
            positions: Vec::with_capacity(vertex_count),
            normals: Vec::with_capacity(vertex_count),
            uvs: Vec::with_capacity(vertex_count),
            colors: Vec::with_capacity(vertex_count),
            triangles: Vec::new(),
            parts: Vec::new(),
        };
        for mesh in &scene.meshes {
            all.add(mesh);
        }
        all
    }

    /// Adds the vertices of a mesh that its triangles use, and the triangles.
    ///
    /// A body in several materials comes as several meshes over the same vertices: what one does
    /// not use is left out, so that light is worked out once for each.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "indices are u32 by the scene's own type"
    )]
    fn add(&mut self, mesh: &SceneMesh<'_>) {
        let mut places = vec![0; mesh.positions.len()];
        let made;
        let normals = if mesh.normals.is_empty() {
            made = vertex_normals(mesh.positions, mesh.triangles);
            &made
        } else {
            mesh.normals
        };
        for vertex in used_vertices(mesh) {
            let vertex = vertex as usize;
            places[vertex] = self.positions.len() as u32;
            self.positions.push(mesh.positions[vertex]);
            self.normals.push(normals[vertex].normalize_or_zero());
            self.uvs
                .push(mesh.uvs.get(vertex).copied().unwrap_or(Vec2::ZERO));
            self.colors
                .push(mesh.colors.get(vertex).copied().unwrap_or(Vec3::ONE));
        }
        let first = self.triangles.len() as u32;
        self.triangles.extend(
            mesh.triangles
                .iter()
                .map(|corners| corners.map(|c| places[c as usize])),
        );
        self.parts.push(Part {
            triangles: first..self.triangles.len() as u32,
            sides: mesh.material.sides,
        });
    }

    /// The box around everything; `None` where there is nothing.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.positions)
    }

    /// Which mesh a triangle belongs to.
    pub(crate) fn part_of(&self, triangle: u32) -> usize {
        self.parts
            .partition_point(|part| part.triangles.end <= triangle)
    }
}

/// The vertices of a mesh that its triangles use, in order.
pub(crate) fn used_vertices(mesh: &SceneMesh<'_>) -> Vec<u32> {
    let mut used = vec![false; mesh.positions.len()];
    for &corner in mesh.triangles.iter().flatten() {
        used[corner as usize] = true;
    }
    (0..)
        .zip(used)
        .filter_map(|(vertex, used)| used.then_some(vertex))
        .collect()
}
