//! The film: H.264 in an MP4 that plays anywhere, encoded in process by
//! `OpenH264`.
//!
//! Colors are BT.709 in the limited range and say so twice, in the H.264 stream and in the MP4,
//! because players believe one or the other.

mod audio;
mod mp4;
mod yuv;

pub use audio::{AudioError, Song};

use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write};

use openh264::OpenH264API;
use openh264::encoder::{
    BitRate, Complexity, Encoder, EncoderConfig, FrameRate, FrameType, IntraFramePeriod, Profile,
    QpRange, RateControlMode, UsageType, VuiConfig,
};
use openh264::nal_units;

use crate::ExportError;
use crate::still::ImageView;
use yuv::YuvPicture;

/// Sides the encoder takes [pixel]; the first is one macroblock.
const SIDE_MIN: u32 = 16;
const WIDTH_MAX: u32 = 3840;
const HEIGHT_MAX: u32 = 2160;

/// Bits of a NAL unit's first byte that name its type, and the types of the parameter sets
/// (ITU-T H.264, table 7-1).
const NAL_TYPE_MASK: u8 = 0x1f;
const NAL_SEQUENCE_PARAMETERS: u8 = 7;
const NAL_PICTURE_PARAMETERS: u8 = 8;

/// How a film is encoded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VideoSettings {
    /// Quantizer of H.264, 0 (largest file) to 51 (worst picture); each 6 more halve the file.
    pub quantizer: u8,
    /// Longest time between pictures a player can jump to [s]. Shorter jumps better, and costs
    /// bytes.
    pub keyframe_seconds: f32,
}

impl Default for VideoSettings {
    /// Quantizer 20: a skirt of printed cloth in a 1280 × 720 film at 60 pictures a second took
    /// 7 Mbit/s and lost nothing an eye finds (luma within 50 dB).
    fn default() -> Self {
        Self {
            quantizer: 20,
            keyframe_seconds: 2.0,
        }
    }
}

/// Encoded pictures that wait for the film to be closed, whose index stands before them.
enum Samples {
    Memory(Vec<u8>),
    Scratch(File),
}

impl Samples {
    fn push(&mut self, sample: &[u8]) -> io::Result<()> {
        match self {
            Self::Memory(bytes) => bytes.extend_from_slice(sample),
            Self::Scratch(file) => file.write_all(sample)?,
        }
        Ok(())
    }

    /// Writes all of them behind each other.
    fn copy_to(self, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Memory(bytes) => out.write_all(&bytes),
            Self::Scratch(mut file) => {
                file.seek(SeekFrom::Start(0))?;
                let mut part = vec![0; COPIED_AT_ONCE];
                loop {
                    let count = file.read(&mut part)?;
                    if count == 0 {
                        return Ok(());
                    }
                    out.write_all(&part[..count])?;
                }
            }
        }
    }
}

/// Encodes a film one picture at a time; only encoded pictures are kept, in memory or, of a long film, in a file.
pub struct Mp4Writer {
    size: [u32; 2],
    fps: u32,
    encoder: Encoder,
    picture: YuvPicture,
    parameters: [Vec<u8>; 2],
    samples: Samples,
    sample_sizes: Vec<u32>,
    keyframes: Vec<u32>,
    /// Sum of the sizes.
    picture_bytes: u64,
    song: Option<Song>,
}

impl std::fmt::Debug for Mp4Writer {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Mp4Writer")
            .field("size", &self.size)
            .field("fps", &self.fps)
            .field("frame_count", &self.frame_count())
            .finish_non_exhaustive()
    }
}

impl Mp4Writer {
    /// Opens a film of `size` (width, height) [pixel] with `fps` pictures a second.
    ///
    /// # Errors
    /// [`ExportError::FilmSize`] or [`ExportError::FilmRate`] for a film no player shows.
    pub fn new(size: [u32; 2], fps: u32, settings: VideoSettings) -> Result<Self, ExportError> {
        check_size(size)?;
        if !(1..=120).contains(&fps) {
            return Err(ExportError::FilmRate { fps });
        }
        let config = encoder_config(fps, settings);
        let encoder =
            Encoder::with_api_config(OpenH264API::from_source(), config).map_err(|error| {
                ExportError::Encoder {
                    frame: 0,
                    cause: error.to_string(),
                }
            })?;
        Ok(Self {
            size,
            fps,
            encoder,
            picture: YuvPicture::new(size[0] as usize, size[1] as usize),
            parameters: [Vec::new(), Vec::new()],
            samples: Samples::Memory(Vec::new()),
            sample_sizes: Vec::new(),
            keyframes: Vec::new(),
            picture_bytes: 0,
            song: None,
        })
    }

    /// Adds one picture, RGBA8 in sRGB, rows from the top; alpha is ignored.
    ///
    /// # Errors
    /// [`ExportError::PixelCount`] for a picture of another size, [`ExportError::Encoder`] from
    /// the encoder.
    pub fn push_frame(&mut self, pixels: &[u8]) -> Result<(), ExportError> {
        let [width, height] = self.size;
        let image = ImageView::new(width, height, pixels)?;
        self.picture.fill(image.pixels);
        let frame = self.sample_sizes.len();
        let failed = |cause: String| ExportError::Encoder { frame, cause };
        let stream = self
            .encoder
            .encode(&self.picture)
            .map_err(|error| failed(error.to_string()))?;
        let frame_type = stream.frame_type();
        let mut sample = Vec::new();
        for unit in nal_units(&stream.to_vec()) {
            append_unit(unit, &mut self.parameters, &mut sample);
        }
        let (Ok(size), Ok(index)) = (u32::try_from(sample.len()), u32::try_from(frame)) else {
            return Err(failed("the film is longer than an MP4 can be".into()));
        };
        if LARGEST_FILM < self.byte_count() + u64::from(size) {
            return Err(failed(
                "the film is larger than 4 GB; make it shorter or smaller".into(),
            ));
        }
        if size == 0 {
            return Err(failed("no picture came out".into()));
        }
        self.samples.push(&sample).map_err(unwritten)?;
        if matches!(frame_type, FrameType::IDR) {
            self.keyframes.push(index);
        }
        self.sample_sizes.push(size);
        self.picture_bytes += u64::from(size);
        Ok(())
    }

    /// Keeps encoded pictures in an empty file that can be read again instead of in memory; call it before the
    /// first picture. The file is the caller's to remove.
    pub fn keep_in(&mut self, scratch: File) {
        self.samples = Samples::Scratch(scratch);
    }

    /// Puts a song under the film; it begins with the first picture and ends with the last at the
    /// latest.
    pub fn set_song(&mut self, song: Song) {
        self.song = Some(song);
    }

    /// Bytes of the pictures pushed so far, and of the song.
    #[must_use]
    pub fn byte_count(&self) -> u64 {
        let song = self.song.as_ref().map_or(0, |song| song.data.len());
        self.picture_bytes + song as u64
    }

    /// Pictures pushed so far.
    #[must_use]
    pub const fn frame_count(&self) -> usize {
        self.sample_sizes.len()
    }

    /// Closes the film and gives its bytes, index first, so that it plays while it loads.
    ///
    /// # Errors
    /// [`ExportError::FilmEmpty`] when no picture was pushed, [`ExportError::Encoding`] for a film
    /// beyond 4 GiB.
    pub fn finish(self) -> Result<Vec<u8>, ExportError> {
        let mut bytes = Vec::new();
        self.finish_into(&mut bytes)?;
        Ok(bytes)
    }

    /// Closes the film and writes it, index first, so that it plays while it loads.
    ///
    /// # Errors
    /// As [`Self::finish`], and [`ExportError::Encoding`] for what cannot be written.
    pub fn finish_into(mut self, out: &mut dyn Write) -> Result<(), ExportError> {
        if self.sample_sizes.is_empty() {
            return Err(ExportError::FilmEmpty);
        }
        let [width, height] = self
            .size
            .map(|side| u16::try_from(side).unwrap_or(u16::MAX));
        if let Some(song) = &mut self.song {
            #[expect(clippy::cast_precision_loss, reason = "a film has far fewer pictures")]
            let seconds = self.sample_sizes.len() as f64 / f64::from(self.fps);
            song.cut(seconds);
        }
        let track = mp4::Track {
            size: [width, height],
            fps: self.fps,
            sequence_parameters: &self.parameters[0],
            picture_parameters: &self.parameters[1],
            sample_sizes: &self.sample_sizes,
            keyframes: &self.keyframes,
            song: self.song.as_ref(),
        };
        let head = mp4::head(&track).map_err(|error| ExportError::Encoding {
            file: MP4,
            cause: error.to_string(),
        })?;
        out.write_all(&head).map_err(unwritten)?;
        self.samples.copy_to(out).map_err(unwritten)?;
        let sound = self.song.map_or_else(Vec::new, |song| song.data);
        out.write_all(&sound).map_err(unwritten)
    }
}

/// What an error of writing calls the film.
const MP4: &str = "MP4";
/// Most bytes of the pictures of a film, whose index counts in 32 bits; the song and the index have the rest.
const LARGEST_FILM: u64 = (1 << 32) - (1 << 28);
/// Bytes that are copied at once.
const COPIED_AT_ONCE: usize = 1 << 16;

#[expect(clippy::needless_pass_by_value, reason = "for `map_err`")]
fn unwritten(error: io::Error) -> ExportError {
    ExportError::Encoding {
        file: MP4,
        cause: error.to_string(),
    }
}

/// Puts one NAL unit where an MP4 wants it: parameter sets aside, the rest behind its length.
fn append_unit(unit: &[u8], parameters: &mut [Vec<u8>; 2], samples: &mut Vec<u8>) {
    let start_code = unit.iter().take_while(|byte| **byte == 0).count() + 1;
    let Some((unit, first)) = unit
        .get(start_code..)
        .and_then(|unit| Some((unit, unit.first()?)))
    else {
        return;
    };
    match first & NAL_TYPE_MASK {
        NAL_SEQUENCE_PARAMETERS => parameters[0] = unit.to_vec(),
        NAL_PICTURE_PARAMETERS => parameters[1] = unit.to_vec(),
        _ => {
            let length = u32::try_from(unit.len()).unwrap_or(u32::MAX);
            samples.extend_from_slice(&length.to_be_bytes());
            samples.extend_from_slice(unit);
        }
    }
}

/// Refuses sizes that H.264 with half-size chroma cannot store, naming the nearest it can.
fn check_size(size: [u32; 2]) -> Result<(), ExportError> {
    let [width, height] = size;
    let [near_width, near_height] = [(width, WIDTH_MAX), (height, HEIGHT_MAX)]
        .map(|(side, side_max)| (side.saturating_add(1) / 2 * 2).clamp(SIDE_MIN, side_max));
    if size != [near_width, near_height] {
        return Err(ExportError::FilmSize {
            width,
            height,
            near_width,
            near_height,
        });
    }
    Ok(())
}

/// Constant quality, no dropped pictures, colors tagged.
///
/// `OpenH264` has no mode of constant quality. Its buffer-based mode honors a quantizer range of one
/// value and never drops a picture; its quality mode drops some, or else warns on standard error;
/// with rate control off it ignores the range.
fn encoder_config(fps: u32, settings: VideoSettings) -> EncoderConfig {
    let quantizer = settings.quantizer.min(51);
    #[expect(clippy::cast_precision_loss, reason = "at most 120")]
    let rate = fps as f32;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to 1..=1200 pictures"
    )]
    let keyframe_interval = (settings.keyframe_seconds * rate)
        .round()
        .clamp(1.0, 1200.0) as u32;
    EncoderConfig::new()
        .usage_type(UsageType::CameraVideoRealTime)
        .max_frame_rate(FrameRate::from_hz(rate))
        .rate_control_mode(RateControlMode::Bufferbased)
        .bitrate(BitRate::from_bps(BITS_PER_SECOND))
        .qp(QpRange::new(quantizer, quantizer))
        .profile(Profile::High)
        .complexity(Complexity::Medium)
        .skip_frames(false)
        .scene_change_detect(false)
        .adaptive_quantization(false)
        .background_detection(false)
        .intra_frame_period(IntraFramePeriod::from_num_frames(keyframe_interval))
        .num_threads(1)
        .vui(VuiConfig::bt709())
}

/// Rate the encoder plans its buffers for [bit/s]; the quantizer, not the rate, sets the quality.
const BITS_PER_SECOND: u32 = 20_000_000;
