//! What can go wrong when a picture is drawn.

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The font that comes with the program cannot be read.
    #[error("the program's font is damaged; install it again")]
    Font,
    /// The picture would have no pixels, or more than can be drawn.
    #[error("a picture of {width} x {height} pixels cannot be drawn; use 1 to {max} on each side", max = crate::image::MAX_SIDE)]
    ImageSize {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
    },
    /// The pixels of a texture do not fill it.
    #[error(
        "a texture of {width} x {height} pixels needs {needed} bytes of RGBA, not {given}; \
         give four bytes a pixel"
    )]
    TextureSize {
        /// Columns of the texture.
        width: u32,
        /// Rows of the texture.
        height: u32,
        /// Bytes that it needs.
        needed: usize,
        /// Bytes that were given.
        given: usize,
    },
    /// A position, normal, texture coordinate or color is NaN or infinite.
    #[error(
        "mesh {mesh} (counted from 0) has a {column} at vertex {vertex} that is not a finite \
         number; nothing was drawn: find the step that made it"
    )]
    NotFinite {
        /// Which mesh of the scene.
        mesh: usize,
        /// Which vertex of the mesh.
        vertex: usize,
        /// `position`, `normal`, `texture coordinate` or `color`.
        column: &'static str,
    },
    /// A column is neither empty nor as long as the positions.
    #[error(
        "mesh {mesh} (counted from 0) has {given} {column}s for {expected} positions; \
         give one each"
    )]
    ColumnLength {
        /// Which mesh of the scene.
        mesh: usize,
        /// `normal`, `texture coordinate` or `color`.
        column: &'static str,
        /// How many there are.
        given: usize,
        /// How many positions there are.
        expected: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error(
        "triangle {triangle} of mesh {mesh} (both counted from 0) names vertex {vertex}, but \
         there are only {vertex_count}"
    )]
    VertexIndex {
        /// Which mesh of the scene.
        mesh: usize,
        /// Which triangle of the mesh.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// The camera sees nothing: it is not finite, looks nowhere or has no opening.
    #[error("the camera cannot look: {reason}")]
    Camera {
        /// What is wrong with it.
        reason: &'static str,
    },
    /// No GPU, nor a driver that acts as one.
    #[error("no graphics adapter can be used ({reason}); use the CPU backend")]
    NoAdapter {
        /// What the graphics system said.
        reason: String,
    },
    /// The GPU was lost or refused the work.
    #[error("the graphics adapter failed while {doing} ({reason}); use the CPU backend")]
    Gpu {
        /// What was being done.
        doing: &'static str,
        /// What the graphics system said.
        reason: String,
    },
}
