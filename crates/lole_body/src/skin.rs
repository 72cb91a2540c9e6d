//! A body's surface: a mesh in the bind pose with joints and weights, and how a pose carries it.
//!
//! Linear blending draws a bent limb in towards its axis, by the cosine of half the bend where two
//! bones share it evenly. About knees and elbows a vertex therefore turns rigidly about a center of its
//! own, which is blended (Le and Hodgins 2016, "Real-time skeletal skinning with optimized centers
//! of rotation"); blended centers cut the corner, so they are led around it, and what flesh the crease
//! takes goes to the sides. A file that knows linear blending alone shows the thinner joints.

use std::sync::Arc;

use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};
use rayon::prelude::*;

use crate::Bone;

/// Vertices that one thread carries in one go.
const VERTICES_TOGETHER: usize = 1024;

/// What a part of the skin shows; one plain material each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum PartKind {
    /// Bare skin.
    Skin,
    /// The plain leotard, always worn.
    Leotard,
    /// The front of the head of what cloth meets; of the drawn body it is skin.
    Face,
    /// Nails of fingers and toes, over the skin.
    Nail,
    /// The eyes; their colors are those of the vertices.
    Eye,
    /// The brows; their colors are those of the vertices.
    Brow,
    /// The lashes, seen from both sides; their colors are those of the vertices.
    Lash,
    /// The hair, with painted strands (see [`crate::Dancer::hair_picture`]).
    Hair,
    /// Petals of the flower in the hair.
    Flower,
    /// Heart of the flower in the hair.
    FlowerHeart,
    /// A part of a given body, with a look of its own: see [`SkinnedMesh::looks`].
    Given,
}

impl PartKind {
    /// Whether it is of the closed surface that [`crate::DrawnBody::finer`] rounds.
    #[must_use]
    pub const fn is_rounded(self) -> bool {
        matches!(self, Self::Skin | Self::Leotard)
    }
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
    /// Linear factors on the colors of the vertices, shape `[vertex_count, 3]`; empty where there are none.
    pub colors: Vec<Vec3>,
    /// Texture coordinates of hair, `v` down; elsewhere of no meaning, shape
    /// `[vertex_count, 2]`.
    pub uvs: Vec<Vec2>,
    /// Bones ([`crate::Bone::index`]) that carry each vertex, shape `[vertex_count, 4]`.
    pub joints: Vec<[u16; 4]>,
    /// Their shares, not negative, summing to 1; unused ones are 0, shape `[vertex_count, 4]`.
    pub weights: Vec<[f32; 4]>,
    /// Triangles by material, in the order of [`PartKind`].
    pub parts: Vec<MeshPart>,
    /// Knees and elbows.
    pub hinges: Vec<Hinge>,
    /// Vertices about the hinges, in order, and the centers they turn about.
    pub turning: Vec<Turning>,
    /// Looks of a given body, one for each of its parts, which stand before a leotard; empty for a built
    /// one.
    pub looks: Vec<Look>,
    /// What cloth meets and a tape measures on a given body, which may be drawn with its seams
    /// apart, in layers and with hair; empty for a built one, where the closed parts are that.
    pub surface: Vec<[u32; 3]>,
}

/// A joint of two bones about which flesh keeps its volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Bones above and below ([`crate::Bone::index`]).
    pub bones: [u16; 2],
    /// Unit directions down these bones, in the bind pose.
    pub directions: [Vec3; 2],
    /// How far centers are led around the corner, were the limb folded up [m].
    pub outward: f32,
    /// By what part the limb is wider along the hinge's axis, were it folded up.
    pub widening: f32,
}

/// A vertex that two bones of a hinge share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// The vertex.
    pub vertex: u32,
    /// Number of its hinge.
    pub hinge: u32,
    /// Share of the bone below the hinge.
    pub share: f32,
    /// What it turns about, in the bind pose [m]: the middle of the limb where the bones' shares are
    /// as they are here.
    pub center: Vec3,
}

/// A hinge in a pose.
struct Bend {
    /// Unit direction out of the outer side of the bend.
    outward: Vec3,
    /// Unit direction of the axis.
    axis: Vec3,
    /// Cosine of the angle.
    cos: f32,
}

impl Hinge {
    fn bend(&self, world_from_bind: &[Affine3A]) -> Bend {
        let [above, below] = [0, 1].map(|end| {
            let bone = &world_from_bind[usize::from(self.bones[end])];
            bone.transform_vector3(self.directions[end])
        });
        Bend {
            outward: (above - below).normalize_or_zero(),
            axis: above.cross(below).normalize_or_zero(),
            cos: above.dot(below).clamp(-1.0, 1.0),
        }
    }
}

impl Bend {
    /// How much shorter than the directions of the two bones their blend is: 0 where one bone carries
    /// all, and at most 1.
    fn lost(&self, share: f32) -> f32 {
        let squared = 1.0 - 2.0 * share * (1.0 - share) * (1.0 - self.cos);
        1.0 - squared.max(0.0).sqrt()
    }
}

impl SkinnedMesh {
    /// Posed positions and unit normals by linear blending, `x' = B x` with `B = Σ w_i M_i`, and about
    /// the hinges `x' = W R (x - c) + B c + o` with the rotation `R` nearest to `B`, the widening `W`
    /// along the axis, and `o` around the corner; both grow with what the blend has lost.
    ///
    /// Both vectors are cleared and filled; `world_from_bind` comes from
    /// [`crate::Skeleton::world_from_bind`].
    pub fn pose(
        &self,
        world_from_bind: &[Affine3A],
        positions: &mut Vec<Vec3>,
        normals: &mut Vec<Vec3>,
    ) {
        positions.resize(self.positions.len(), Vec3::ZERO);
        normals.resize(self.positions.len(), Vec3::ZERO);
        let pose = |(start, (positions, normals)): (usize, (&mut [Vec3], &mut [Vec3]))| {
            for ((index, position), normal) in (start..).zip(positions).zip(normals) {
                let blended = blend(world_from_bind, self.joints[index], self.weights[index]);
                *position = blended.transform_point3(self.positions[index]);
                *normal = blended
                    .transform_vector3(self.normals[index])
                    .normalize_or_zero();
            }
        };
        if rayon::current_num_threads() == 1 {
            pose((0, (&mut positions[..], &mut normals[..])));
        } else {
            let starts = (0..self.positions.len()).into_par_iter();
            let parts = positions.par_chunks_mut(VERTICES_TOGETHER);
            let parts = parts.zip(normals.par_chunks_mut(VERTICES_TOGETHER));
            starts.step_by(VERTICES_TOGETHER).zip(parts).for_each(pose);
        }
        let bends: Vec<Bend> = (self.hinges.iter())
            .map(|hinge| hinge.bend(world_from_bind))
            .collect();
        for turning in &self.turning {
            let (vertex, center) = (turning.vertex as usize, turning.center);
            let index = turning.hinge as usize;
            let (hinge, bend) = (&self.hinges[index], &bends[index]);
            let lost = bend.lost(turning.share);
            let blended = blend(world_from_bind, self.joints[vertex], self.weights[vertex]);
            let turn = nearest_rotation(blended.matrix3);
            let wider = 1.0 + hinge.widening * lost;
            let stretched = |place: Vec3, factor: f32| {
                place + bend.axis * (bend.axis.dot(place) * (factor - 1.0))
            };
            positions[vertex] = stretched(turn * (self.positions[vertex] - center), wider)
                + blended.transform_point3(center)
                + bend.outward * (hinge.outward * lost);
            let normal = stretched(turn * self.normals[vertex], wider.recip());
            normals[vertex] = normal.normalize_or_zero();
        }
    }

    /// Whether it was given and not built.
    #[must_use]
    pub const fn is_given(&self) -> bool {
        !self.surface.is_empty()
    }

    /// The bone that carries most of a vertex; of equals the first.
    #[must_use]
    pub fn strongest_bone(&self, vertex: usize) -> Bone {
        Bone::strongest(self.joints[vertex], self.weights[vertex])
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

/// The rotation nearest to a blend of rotations that are less than half a turn apart: Newton's
/// iteration for the polar decomposition (Higham 1986).
fn nearest_rotation(matrix: Mat3A) -> Mat3A {
    const PASSES: usize = 6;
    let mut turn = matrix;
    for _ in 0..PASSES {
        if turn.determinant() < 1.0e-3 {
            return matrix;
        }
        turn = (turn + turn.inverse().transpose()) * 0.5;
    }
    turn
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Quat;

    #[test]
    fn the_rotation_nearest_to_a_blend_lies_half_way() {
        for angle in [0.0, 0.4, 1.3, 2.4] {
            let ends = [0.0, angle].map(|angle| Mat3A::from_quat(Quat::from_rotation_x(angle)));
            let nearest = nearest_rotation(ends[0] * 0.5 + ends[1] * 0.5);
            let wanted = Mat3A::from_quat(Quat::from_rotation_x(0.5 * angle));
            assert!(nearest.abs_diff_eq(wanted, 1.0e-5), "{angle}: {nearest}");
        }
    }
}
