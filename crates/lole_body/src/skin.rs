//! The drawn body: a mesh in the bind pose with joints and weights, and how a pose carries it.

use std::sync::Arc;

use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};

/// What a part of the skin shows; one plain material each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum PartKind {
    /// Bare skin.
    Skin,
    /// The plain leotard, always worn.
    Leotard,
    /// The front of the head, with painted eyes, brows and lips (see [`crate::face_texture`]).
    Face,
    /// The hair with its bun, with painted strands (see [`crate::hair_texture`]).
    Hair,
    /// Petals of the flower in the hair.
    Flower,
    /// Heart of the flower in the hair.
    FlowerHeart,
    /// A part of a given body, with a look of its own: see [`SkinnedMesh::looks`].
    Given,
}

/// What a part of a given body looks like.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Name of its material; may be empty.
    pub name: String,
    /// Color without a picture, and a factor on one, linear.
    pub base_color: [f32; 3],
    /// Picture that lies on it by texture coordinates.
    pub picture: Option<Arc<SkinPicture>>,
    /// 0 is a mirror, 1 is chalk.
    pub roughness: f32,
    /// Whether its back is drawn.
    pub is_two_sided: bool,
}

/// A picture on a given body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SkinPicture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Rows from the top, RGBA, sRGB-encoded, shape `[height, width, 4]`.
    pub pixels: Vec<u8>,
}

/// Triangles of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPart {
    /// The material.
    pub kind: PartKind,
    /// Vertex indices, counter-clockwise seen from outside, shape `[triangle_count, 3]`.
    pub triangles: Vec<[u32; 3]>,
}

/// The body's surface in the bind pose, carried by up to four bones a vertex.
///
/// Parts share vertices: [`PartKind::Skin`], [`PartKind::Leotard`] and [`PartKind::Face`] together
/// are one closed surface of genus 0; hair and flower are closed surfaces of their own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SkinnedMesh {
    /// Bind positions [m], shape `[vertex_count, 3]`.
    pub positions: Vec<Vec3>,
    /// Unit outward normals of the bind pose, shape `[vertex_count, 3]`.
    pub normals: Vec<Vec3>,
    /// Texture coordinates of face and hair, `v` down; elsewhere of no meaning, shape
    /// `[vertex_count, 2]`.
    pub uvs: Vec<Vec2>,
    /// Bones ([`crate::Bone::index`]) that carry each vertex, shape `[vertex_count, 4]`.
    pub joints: Vec<[u16; 4]>,
    /// Their shares, not negative, summing to 1; unused ones are 0, shape `[vertex_count, 4]`.
    pub weights: Vec<[f32; 4]>,
    /// Triangles by material, in the order of [`PartKind`].
    pub parts: Vec<MeshPart>,
    /// Looks of a given body, one for each part; empty for a built one.
    pub looks: Vec<Look>,
    /// What cloth meets and a tape measures on a given body, which may be drawn with its seams
    /// apart, in layers and with hair; empty for a built one, where the closed parts are that.
    pub surface: Vec<[u32; 3]>,
}

impl SkinnedMesh {
    /// Posed positions and unit normals by linear blending, `x' = Σ w_i M_i x`.
    ///
    /// Both vectors are cleared and filled; `world_from_bind` comes from
    /// [`crate::Skeleton::world_from_bind`].
    pub fn pose(
        &self,
        world_from_bind: &[Affine3A],
        positions: &mut Vec<Vec3>,
        normals: &mut Vec<Vec3>,
    ) {
        positions.clear();
        normals.clear();
        for (index, (&position, &normal)) in self.positions.iter().zip(&self.normals).enumerate() {
            let blended = blend(world_from_bind, self.joints[index], self.weights[index]);
            positions.push(blended.transform_point3(position));
            normals.push(blended.transform_vector3(normal).normalize_or_zero());
        }
    }

    /// Whether it was given and not built.
    #[must_use]
    pub const fn is_given(&self) -> bool {
        !self.surface.is_empty()
    }

    /// Height of the highest vertex of the body's surface [m].
    pub(crate) fn surface_height(&self) -> f32 {
        let triangles = self.body_triangles();
        let vertices = triangles.iter().flatten();
        let heights = vertices.map(|&vertex| self.positions[vertex as usize].y);
        heights.fold(0.0, f32::max)
    }

    /// All triangles of the body's surface: of a built one skin, leotard and face, without hair,
    /// which together are closed.
    #[must_use]
    pub fn body_triangles(&self) -> Vec<[u32; 3]> {
        if self.is_given() {
            return self.surface.clone();
        }
        self.parts
            .iter()
            .filter(|part| {
                matches!(
                    part.kind,
                    PartKind::Skin | PartKind::Leotard | PartKind::Face
                )
            })
            .flat_map(|part| part.triangles.iter().copied())
            .collect()
    }
}

/// Weighted sum of four bones' transforms.
#[must_use]
pub fn blend(world_from_bind: &[Affine3A], joints: [u16; 4], weights: [f32; 4]) -> Affine3A {
    let mut matrix3 = Mat3A::ZERO;
    let mut translation = Vec3A::ZERO;
    for (joint, weight) in joints.into_iter().zip(weights) {
        if weight > 0.0 {
            let bone = &world_from_bind[usize::from(joint)];
            matrix3 += bone.matrix3 * weight;
            translation += bone.translation * weight;
        }
    }
    Affine3A {
        matrix3,
        translation,
    }
}
