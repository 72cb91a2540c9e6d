//! What is to be drawn.

use crate::{Background, Bounds, Camera, Ground, LightRig, Material, RenderError};
use glam::{Vec2, Vec3};

/// One mesh with one material. Columns are empty or as long as `positions`.
#[derive(Debug, Clone, Copy)]
pub struct SceneMesh<'a> {
    /// Vertex positions [m], shape `[vertex_count, 3]`.
    pub positions: &'a [Vec3],
    /// Outward normals, any length above zero; made from the triangles where empty.
    pub normals: &'a [Vec3],
    /// Texture coordinates, v down, repeating; may be empty.
    pub uvs: &'a [Vec2],
    /// Linear color factors by vertex (paint); may be empty.
    pub colors: &'a [Vec3],
    /// Vertex indices, counter-clockwise seen from the face, shape `[triangle_count, 3]`.
    pub triangles: &'a [[u32; 3]],
    /// What it is made of.
    pub material: &'a Material,
}

/// Everything in one picture.
#[derive(Debug, Clone)]
pub struct Scene<'a> {
    /// The meshes, in any order.
    pub meshes: Vec<SceneMesh<'a>>,
    /// Where the picture is taken from.
    pub camera: Camera,
    /// The lights.
    pub lights: LightRig,
    /// What is behind everything.
    pub background: Background,
    /// The floor that catches shadows; `None` for none.
    pub ground: Option<Ground>,
}

impl Scene<'_> {
    /// An empty studio seen by `camera`: lights that stand around it, backdrop, floor at height 0.
    #[must_use]
    pub fn studio(camera: Camera) -> Self {
        Self {
            meshes: Vec::new(),
            camera,
            lights: LightRig::seen_from(&camera),
            background: Background::default(),
            ground: Some(Ground::default()),
        }
    }

    /// The box around all meshes; `None` where there is no vertex.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        self.meshes
            .iter()
            .filter_map(|mesh| Bounds::of(mesh.positions))
            .reduce(Bounds::union)
    }

    /// Refuses what cannot be drawn, naming mesh and vertex.
    pub(crate) fn check(&self) -> Result<(), RenderError> {
        self.camera.check()?;
        for (mesh_index, mesh) in self.meshes.iter().enumerate() {
            mesh.check(mesh_index)?;
        }
        Ok(())
    }
}

impl SceneMesh<'_> {
    fn check(&self, mesh: usize) -> Result<(), RenderError> {
        let expected = self.positions.len();
        let lengths = [
            ("normal", self.normals.len()),
            ("texture coordinate", self.uvs.len()),
            ("color", self.colors.len()),
        ];
        for (column, given) in lengths {
            if given != 0 && given != expected {
                return Err(RenderError::ColumnLength {
                    mesh,
                    column,
                    given,
                    expected,
                });
            }
        }
        let broken = [
            ("position", first_broken(self.positions, |v| v.is_finite())),
            ("normal", first_broken(self.normals, |v| v.is_finite())),
            (
                "texture coordinate",
                first_broken(self.uvs, |v| v.is_finite()),
            ),
            ("color", first_broken(self.colors, |v| v.is_finite())),
        ];
        for (column, vertex) in broken {
            if let Some(vertex) = vertex {
                return Err(RenderError::NotFinite {
                    mesh,
                    vertex,
                    column,
                });
            }
        }
        for (triangle, indices) in self.triangles.iter().enumerate() {
            if let Some(&vertex) = indices.iter().find(|&&index| index as usize >= expected) {
                return Err(RenderError::VertexIndex {
                    mesh,
                    triangle,
                    vertex,
                    vertex_count: expected,
                });
            }
        }
        Ok(())
    }
}

fn first_broken<T: Copy>(column: &[T], is_finite: impl Fn(T) -> bool) -> Option<usize> {
    column.iter().position(|&value| !is_finite(value))
}
