//! All meshes of a scene as one list of vertices and one of triangles.

use crate::{Bounds, Scene, Sides};
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
    #[expect(
        clippy::cast_possible_truncation,
        reason = "indices are u32 by the scene's own type"
    )]
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
            let count = mesh.positions.len();
            let base = all.positions.len() as u32;
            let first_triangle = all.triangles.len() as u32;
            all.positions.extend(mesh.positions);
            if mesh.normals.is_empty() {
                all.normals
                    .extend(vertex_normals(mesh.positions, mesh.triangles));
            } else {
                all.normals
                    .extend(mesh.normals.iter().map(|normal| normal.normalize_or_zero()));
            }
            extend_or_fill(&mut all.uvs, mesh.uvs, count, Vec2::ZERO);
            extend_or_fill(&mut all.colors, mesh.colors, count, Vec3::ONE);
            all.triangles.extend(
                mesh.triangles
                    .iter()
                    .map(|corners| corners.map(|c| c + base)),
            );
            all.parts.push(Part {
                triangles: first_triangle..all.triangles.len() as u32,
                sides: mesh.material.sides,
            });
        }
        all
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

fn extend_or_fill<T: Copy>(column: &mut Vec<T>, values: &[T], count: usize, missing: T) {
    if values.is_empty() {
        column.resize(column.len() + count, missing);
    } else {
        column.extend(values);
    }
}
