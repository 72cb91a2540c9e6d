//! What a piece of cloth of any triangle mesh is made of, and why one cannot be built.

use glam::Vec2;

use crate::Fabric;

/// Everything that never changes about one piece of cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSpec {
    /// Every particle in the flat piece [m]: `x` runs along the warp (`u`), `y` along the weft
    /// (`v`). Shape `[particle_count]`.
    pub flat_positions: Vec<Vec2>,
    /// Three particles each, in either direction around.
    pub triangles: Vec<[u32; 3]>,
    /// Material of the whole piece.
    pub fabric: Fabric,
    /// Layers of cloth at each particle: 1, or more where a hem or casing is folded. Multiplies
    /// the mass. Shape `[particle_count]`.
    pub layers: Vec<f32>,
    /// Particles carried exactly by the body, shape `[particle_count]`.
    pub pinned: Vec<bool>,
}

impl MeshSpec {
    /// A free piece, one layer thick.
    #[must_use]
    pub fn new(flat_positions: Vec<Vec2>, triangles: Vec<[u32; 3]>, fabric: Fabric) -> Self {
        Self {
            layers: vec![1.0; flat_positions.len()],
            pinned: vec![false; flat_positions.len()],
            flat_positions,
            triangles,
            fabric,
        }
    }
}

/// Why a [`MeshSpec`] cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// No particle or no triangle.
    #[error("the mesh has {particle_count} particles and {triangle_count} triangles; give it some")]
    Empty {
        /// Particles found.
        particle_count: usize,
        /// Triangles found.
        triangle_count: usize,
    },
    /// Neighbors stand farther apart in memory than the engine reaches: half a million particles
    /// in a square fit, and more in a strip.
    #[error("the mesh has {particle_count} particles, too many for one piece; cut it in two")]
    TooLarge {
        /// Particles found.
        particle_count: usize,
    },
    /// A column of the specification has another length than there are particles.
    #[error("`{field}` has {actual} entries; the mesh needs {expected}")]
    WrongLength {
        /// Field of the specification.
        field: &'static str,
        /// Entries found.
        actual: usize,
        /// Entries needed.
        expected: usize,
    },
    /// A triangle names a particle that does not exist.
    #[error("triangle {triangle} names particle {index}, and there are {particle_count}")]
    IndexOutOfRange {
        /// Position in the list of triangles.
        triangle: usize,
        /// The index found.
        index: u32,
        /// Particles there are.
        particle_count: usize,
    },
    /// A flat position that is not a number, or is infinite.
    #[error("particle {particle} lies at ({}, {}) in the flat piece; give it a finite place", position.x, position.y)]
    NotFinite {
        /// The particle.
        particle: usize,
        /// Where it was said to lie [m].
        position: Vec2,
    },
    /// A triangle without area, or one so narrow that its area is rounding.
    #[error(
        "triangle {triangle} is {height} m high over a side of {side} m; remove it or move a corner"
    )]
    ZeroArea {
        /// Position in the list of triangles.
        triangle: usize,
        /// Its longest side [m].
        side: f32,
        /// Its height over that side [m].
        height: f32,
    },
    /// A particle of no triangle, which would weigh nothing.
    #[error("particle {particle} belongs to no triangle and would weigh nothing; remove it")]
    ZeroMass {
        /// The particle.
        particle: usize,
    },
    /// More than two triangles share an edge.
    #[error(
        "{triangle_count} triangles share the edge of particles {first} and {second}; cloth has at most two there"
    )]
    NonManifoldEdge {
        /// One end.
        first: u32,
        /// The other.
        second: u32,
        /// Triangles that share it.
        triangle_count: usize,
    },
    /// Two parts of the piece touch in a single particle only.
    #[error(
        "parts of the mesh hang together by particle {particle} alone; give each part its own and sew them"
    )]
    NonManifoldVertex {
        /// The particle.
        particle: usize,
    },
    /// Two neighboring triangles lie on top of each other in the flat piece.
    #[error(
        "the flat piece folds over at the edge of particles {first} and {second}; lay it out flat"
    )]
    FoldedOver {
        /// One end of the edge.
        first: u32,
        /// The other.
        second: u32,
    },
    /// A number that is not finite or that no fabric has.
    #[error("`{field}` is {value}; it must be {rule}")]
    OutOfRange {
        /// Field of the specification.
        field: &'static str,
        /// The value found.
        value: f32,
        /// What would be allowed.
        rule: &'static str,
    },
}
