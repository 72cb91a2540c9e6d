//! The vertices and triangles of a grid of particles, thinned for a file.

use glam::Vec2;

/// Whether the last column of a grid is sewn to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GridRing {
    /// Four free edges.
    Open,
    /// The last column is followed by the first.
    Closed,
}

/// A grid of particles, row by row from the top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridSheet {
    /// Particles in a row, at least 2 (3 when closed).
    pub column_count: u32,
    /// Rows, at least 2.
    pub row_count: u32,
    /// How the first and last column meet.
    pub ring: GridRing,
    /// Flat distance between neighbors along a row and down a column [m].
    pub spacing: [f32; 2],
    /// Flat width and height of one print repeat [m].
    pub print_repeat: [f32; 2],
}

/// Which particles are vertices of a file, and how they are joined.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GridMesh {
    /// Particle of each vertex.
    pub particles: Vec<u32>,
    /// Texture coordinates of each vertex, in print repeats, v down.
    pub uvs: Vec<Vec2>,
    /// Vertex indices.
    pub triangles: Vec<[u32; 3]>,
}
