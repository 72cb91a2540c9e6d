//! `dancer.glb`: the dancer skinned and animated, the cloth with its baked motion, in glTF 2.0.

mod buffer;
mod check;
mod fit;
mod grid_mesh;
mod skinned_cloth;
mod write;

pub use fit::{ClothFit, said_of};
pub use grid_mesh::{GridMesh, GridRing, GridSheet};

use std::borrow::Cow;
use std::fmt::Debug;

use glam::{Vec2, Vec3};
use lole_body::skeleton::{Pose, Skeleton};
use serde_json::Value;

use crate::ExportError;

/// Most morph targets of a mesh: viewers differ in how many they play, and so many are safe.
pub const MOST_TARGETS: usize = 128;

/// Everything a `dancer.glb` holds.
#[derive(Debug, Clone, Copy)]
pub struct GlbScene<'a> {
    /// Joints of the dancer in the bind pose.
    pub skeleton: &'a Skeleton,
    /// Time of each pose [s], growing.
    pub pose_times: &'a [f32],
    /// Poses, shape `[pose_times.len()]`; none for a dancer who stands still.
    pub poses: &'a [Pose],
    /// Body, hair and whatever else the bones carry.
    pub skinned: &'a [GlbMesh<'a>],
    /// Cloth that moves by itself.
    pub cloths: &'a [BakedCloth<'a>],
    /// Joints after those of the skeleton, parents before children.
    pub added: &'a [AddedJoint],
    /// Extensions of the whole file by name; the node of a joint is its place plus one.
    pub extensions: &'a [(&'a str, Value)],
}

/// A joint that is no bone of the body.
#[derive(Debug, Clone, PartialEq)]
pub struct AddedJoint {
    /// Name of its node.
    pub name: String,
    /// Place of its parent: among `Bone::ALL`, and behind them among the added ones.
    pub parent: usize,
    /// Where it is in the bind pose [m].
    pub place: Vec3,
}

/// A mesh carried by the bones.
#[derive(Debug, Clone, Copy)]
pub struct GlbMesh<'a> {
    /// Name of its node.
    pub name: &'a str,
    /// Vertices in the bind pose [m].
    pub positions: &'a [Vec3],
    /// Unit normals, shape of `positions`.
    pub normals: &'a [Vec3],
    /// Texture coordinates, v down, shape of `positions` or empty.
    pub uvs: &'a [Vec2],
    /// Linear colors of the vertices, shape of `positions` or empty; they multiply the material's.
    pub colors: &'a [Vec3],
    /// Bones of each vertex, as positions in `Bone::ALL` and behind them among the added joints.
    pub joints: &'a [[u16; 4]],
    /// Their weights; brought to a sum of 1 here.
    pub weights: &'a [[f32; 4]],
    /// Triangles by material; they share the vertices.
    pub parts: &'a [GlbPart<'a>],
    /// Shapes that it can take, such as closed eyes.
    pub shapes: &'a [GlbShape],
    /// Times of the shapes' weights [s], growing.
    pub shape_times: &'a [f32],
}

/// A shape that a mesh can take beside its own.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbShape {
    /// Name in the file.
    pub name: &'static str,
    /// Vertices that move, ascending, and how far [m].
    pub moved: Vec<(u32, Vec3)>,
    /// How much of it is on at each of the mesh's `shape_times`; empty where it stays off.
    pub weights: Vec<f32>,
}

/// The triangles of one material.
#[derive(Debug, Clone, Copy)]
pub struct GlbPart<'a> {
    /// Vertex indices, counter-clockwise seen from outside.
    pub triangles: &'a [[u32; 3]],
    /// What they are made of.
    pub material: GlbMaterial<'a>,
}

/// How a surface looks.
#[derive(Debug, Clone, Copy)]
pub struct GlbMaterial<'a> {
    /// Name in the file.
    pub name: &'a str,
    /// Linear RGB color, 0 to 1; multiplies the texture.
    pub base_color: [f32; 3],
    /// Perceptual roughness, 0 (mirror) to 1 (chalk).
    pub roughness: f32,
    /// Linear brightness that fibers add where it is seen at a grazing angle, 0 to 1 (`KHR_materials_sheen`).
    pub sheen: f32,
    /// PNG bytes of an sRGB picture that repeats.
    pub texture_png: Option<&'a [u8]>,
    /// Which sides are drawn.
    pub sides: GlbSides,
}

/// Which sides of a surface are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GlbSides {
    /// Only the side the triangles wind counter-clockwise on.
    Front,
    /// Both, as cloth needs.
    Both,
}

/// A mesh whose vertices were recorded.
#[derive(Debug, Clone, Copy)]
pub struct BakedCloth<'a> {
    /// Name of its node.
    pub name: &'a str,
    /// Which particles become vertices, and how they are joined.
    pub mesh: &'a GridMesh,
    /// Linear colors of the vertices of `mesh`; may be empty. They multiply the material's.
    pub colors: &'a [Vec3],
    /// What it is made of.
    pub material: GlbMaterial<'a>,
    /// Time of each frame [s], growing.
    pub key_times: &'a [f32],
    /// Particle positions of each frame [m], world space, shape `[key_times.len(), particle_count]`;
    /// the first is the mesh at rest.
    pub frames: &'a dyn ClothFrames,
}

/// Recorded frames of a cloth, which may be more than memory holds.
pub trait ClothFrames: Debug {
    /// Number of frames.
    fn count(&self) -> usize;

    /// Particle positions of a frame [m].
    ///
    /// # Errors
    /// A frame that cannot be had.
    fn frame(&self, number: usize) -> Result<Cow<'_, [Vec3]>, ExportError>;
}

impl ClothFrames for Vec<Vec<Vec3>> {
    fn count(&self) -> usize {
        self.len()
    }

    fn frame(&self, number: usize) -> Result<Cow<'_, [Vec3]>, ExportError> {
        Ok(Cow::Borrowed(&self[number]))
    }
}

/// A file, and what it is not exact in.
#[derive(Debug, Clone, PartialEq)]
pub struct GlbFile {
    /// The file.
    pub bytes: Vec<u8>,
    /// Cloths that were too long for morph targets, and how far bones carry them from where they were.
    pub fits: Vec<ClothFit>,
}

/// Writes the scene as binary glTF 2.0. Cloth of at most [`MOST_TARGETS`] frames after the first is written as it
/// moved, as morph targets; longer ones on bones of their own.
///
/// # Errors
/// [`ExportError`] when columns do not fit each other, an index is out of range or a number is
/// not finite.
pub fn write_glb(scene: &GlbScene<'_>) -> Result<GlbFile, ExportError> {
    check::check_scene(scene)?;
    write::write_scene(scene)
}
