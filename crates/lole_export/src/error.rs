//! What can go wrong while a file is made, in sentences.

/// Why a file could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A picture has no pixels, or not as many as its size says.
    #[error(
        "a picture of {width} × {height} needs {expected} bytes of RGBA pixels but has {actual}; pass width × height × 4 bytes"
    )]
    PixelCount {
        /// Width [pixel].
        width: u32,
        /// Height [pixel].
        height: u32,
        /// Bytes the size asks for.
        expected: usize,
        /// Bytes that were given.
        actual: usize,
    },
    /// A picture is larger than its file format allows.
    #[error(
        "a {format} picture cannot be {width} × {height} pixels; each side must be 1 to {limit}"
    )]
    PictureSize {
        /// Name of the format.
        format: &'static str,
        /// Width [pixel].
        width: u32,
        /// Height [pixel].
        height: u32,
        /// Longest side the format stores [pixel].
        limit: u32,
    },
    /// The film's size cannot be stored with one chroma sample per 2 × 2 pixels.
    #[error(
        "a film cannot be {width} × {height}: H.264 film needs even sizes from 16 × 16 to 3840 × 2160; try {near_width} × {near_height}"
    )]
    FilmSize {
        /// Width [pixel].
        width: u32,
        /// Height [pixel].
        height: u32,
        /// Nearest width that works [pixel].
        near_width: u32,
        /// Nearest height that works [pixel].
        near_height: u32,
    },
    /// Pictures per second outside what players show.
    #[error("a film of {fps} pictures a second cannot be made; choose 1 to 120")]
    FilmRate {
        /// Pictures per second that were asked for.
        fps: u32,
    },
    /// A film without a picture.
    #[error("the film has no picture; push at least one frame before finishing it")]
    FilmEmpty,
    /// The H.264 encoder gave up.
    #[error("the H.264 encoder stopped at picture {frame}: {cause}; try a smaller --size")]
    Encoder {
        /// Index of the picture.
        frame: usize,
        /// The encoder's own words.
        cause: String,
    },
    /// A still or container encoder gave up.
    #[error("writing {file} failed: {cause}")]
    Encoding {
        /// Kind of file.
        file: &'static str,
        /// The encoder's own words.
        cause: String,
    },
    /// Columns that must be equally long are not.
    #[error(
        "{mesh}: {column} has {actual} entries where {expected} are needed; pass one per vertex"
    )]
    ColumnLength {
        /// Name of the mesh.
        mesh: String,
        /// Name of the column.
        column: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        actual: usize,
    },
    /// An index points outside its column.
    #[error("{mesh}: {column} holds index {index} but there are only {count}; rebuild the mesh")]
    IndexRange {
        /// Name of the mesh.
        mesh: String,
        /// Name of the column.
        column: &'static str,
        /// The index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A number that is not finite would have gone into a file.
    #[error(
        "{mesh}: {column} is not a finite number at entry {index}; the run has diverged, write no GLB of it"
    )]
    NotFinite {
        /// Name of the mesh.
        mesh: String,
        /// Name of the column.
        column: &'static str,
        /// First bad entry.
        index: usize,
    },
    /// Key times do not grow.
    #[error("{mesh}: key times must start at 0 or later and grow; entry {index} does not")]
    KeyTimes {
        /// Name of the mesh.
        mesh: String,
        /// First bad entry.
        index: usize,
    },
    /// A recorded frame cannot be had.
    #[error("{mesh}: frame {frame} cannot be read ({cause}); record the take again")]
    FrameLost {
        /// Name of the mesh.
        mesh: String,
        /// Number of the frame.
        frame: usize,
        /// Why.
        cause: String,
    },
    /// The GLB would be larger than its 32-bit length field.
    #[error("the GLB would be {bytes} bytes but a GLB ends at 4 GiB; write fewer cloth frames")]
    TooLarge {
        /// Bytes it would take.
        bytes: usize,
    },
}
