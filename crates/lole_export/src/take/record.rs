//! `dance.take`: a recording that grows frame by frame, and is read frame by frame.
//!
//! Magic, version, length of the header and its hash; the header as JSON; then frames of one size each: the pose,
//! positions (`f32`) and normals (octahedral, 2 × 16 bits) of every mesh, and their hash (FNV-1a, 64 bits).
//! Whatever stops the recording, all whole frames before are still there, and a run that is begun again finds them.

use std::io::{self, Read, Seek, SeekFrom, Write};

use glam::{Quat, Vec2, Vec3};
use lole_body::{Bone, Pose};
use lole_geom::fnv;
use serde::{Deserialize, Serialize};

use super::{TakeScene, TakeSource, TakeVertices};

const MAGIC: &[u8; 8] = b"LOLETAKE";
/// Layout of the file.
const VERSION: u32 = 1;
/// A header larger than this [byte] is none: a design has 16 MiB at most.
const LARGEST_HEADER: u32 = 32 << 20;
/// Most vertices of all meshes: a hundred times those of a dancer in four garments.
const MOST_VERTICES: usize = 1 << 24;
/// Most frames in a second.
const HIGHEST_RATE: u32 = 1000;
/// Bytes before the header.
const PREFIX: usize = 8 + 4 + 4 + 8;
/// Bytes of a pose: the hips' place, and a quaternion for each bone.
const POSE_BYTES: usize = 12 + 16 * Bone::COUNT;
/// Bytes of a vertex: its position and its normal.
const VERTEX_BYTES: usize = 12 + 4;
/// Largest value of a normal's coordinate in its octahedron.
const SHORT_ONE: f32 = 32_767.0;

/// What a take is of; two takes with the same one are the same to the bit.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TakeHeader {
    /// Version of Lole: another one may move cloth otherwise.
    pub lole: String,
    /// Frames in a second.
    pub frame_rate: u32,
    /// Frames that were asked for.
    pub frame_count: u32,
    /// The design, as a document.
    pub design: String,
    /// Hash of the files that the design names.
    pub files_hash: u64,
    /// Names and vertices of the meshes.
    pub meshes: Vec<(String, usize)>,
}

impl TakeHeader {
    /// The bytes that a take begins with.
    ///
    /// # Errors
    /// A header that is too large.
    pub fn bytes(&self) -> io::Result<Vec<u8>> {
        let json = serde_json::to_vec(self).map_err(io::Error::other)?;
        let length = u32::try_from(json.len()).map_err(io::Error::other)?;
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(length.to_le_bytes());
        bytes.extend(fnv::hash(json.iter().copied()).to_le_bytes());
        bytes.extend(json);
        Ok(bytes)
    }

    /// Whether its figures can be those of a take: what is read of it is asked memory for.
    fn is_possible(&self) -> bool {
        let vertices = self.meshes.iter().map(|(_, count)| *count);
        let sum = vertices.fold(0, usize::saturating_add);
        sum <= MOST_VERTICES && (1..=HIGHEST_RATE).contains(&self.frame_rate)
    }

    /// Bytes of one frame.
    #[must_use]
    pub fn frame_bytes(&self) -> usize {
        let vertices: usize = self.meshes.iter().map(|(_, count)| count).sum();
        POSE_BYTES + VERTEX_BYTES * vertices + 8
    }
}

/// Bytes of one frame, with its hash.
#[must_use]
pub fn frame_bytes(pose: &Pose, meshes: &[TakeVertices]) -> Vec<u8> {
    let vertices: usize = meshes.iter().map(|[positions, _]| positions.len()).sum();
    let mut bytes = Vec::with_capacity(POSE_BYTES + VERTEX_BYTES * vertices + 8);
    let mut put = |values: &[f32]| {
        for value in values {
            bytes.extend_from_slice(&value.to_le_bytes());
        }
    };
    put(&pose.hips_translation.to_array());
    for &bone in Bone::ALL {
        put(&pose.rotation(bone).to_array());
    }
    for [positions, normals] in meshes {
        for position in positions {
            bytes.extend(position.to_array().into_iter().flat_map(f32::to_le_bytes));
        }
        for normal in normals {
            bytes.extend(folded(*normal).into_iter().flat_map(i16::to_le_bytes));
        }
    }
    bytes.extend(fnv::hash(bytes.iter().copied()).to_le_bytes());
    bytes
}

/// A direction on the octahedron `|x| + |y| + |z| = 1`, its lower half folded outward over the upper one (Meyer and
/// others 2010, "On floating-point normal vectors"): off by 0.004° at most.
fn folded(normal: Vec3) -> [i16; 2] {
    let sum = normal.abs().element_sum();
    let on = if 0.0 < sum { normal / sum } else { Vec3::Y };
    let flat = if on.z < 0.0 {
        outward(on.truncate())
    } else {
        on.truncate()
    };
    #[expect(clippy::cast_possible_truncation, reason = "clamped to -32767..=32767")]
    let level = |value: f32| (value.clamp(-1.0, 1.0) * SHORT_ONE).round() as i16;
    [level(flat.x), level(flat.y)]
}

fn unfolded(level: [i16; 2]) -> Vec3 {
    let flat = Vec2::new(f32::from(level[0]), f32::from(level[1])) / SHORT_ONE;
    let height = 1.0 - flat.abs().element_sum();
    let flat = if height < 0.0 { outward(flat) } else { flat };
    flat.extend(height).normalize_or(Vec3::Y)
}

/// A point of the square folded over the nearest edge of the diamond in it.
fn outward(point: Vec2) -> Vec2 {
    let sign = |value: f32| if value < 0.0 { -1.0 } else { 1.0 };
    let swapped = Vec2::new(point.y, point.x).abs();
    (Vec2::ONE - swapped) * Vec2::new(sign(point.x), sign(point.y))
}

/// Why a file is no take that can be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TakeError {
    /// It cannot be read at all.
    #[error("the file cannot be read; check the path ({0})")]
    Unreadable(#[from] io::Error),
    /// It begins otherwise.
    #[error("this is no take; record one with `lole export`")]
    NoTake,
    /// It is of another version.
    #[error("this take was recorded by another version of Lole ({0}); record it again")]
    OtherVersion(String),
    /// It has no whole frame.
    #[error("this take has no whole frame; record it again")]
    Empty,
}

/// A recording that is read.
#[derive(Debug)]
pub struct RecordedTake<R> {
    file: R,
    header: TakeHeader,
    /// Where the first frame begins.
    start: u64,
    /// Whole frames.
    whole: u32,
}

impl<R: Read + Seek> RecordedTake<R> {
    /// Reads the header and finds the last whole frame.
    ///
    /// # Errors
    /// See [`TakeError`]; a take without a whole frame is one.
    pub fn open(mut file: R) -> Result<Self, TakeError> {
        let size = file.seek(SeekFrom::End(0))?;
        file.seek(SeekFrom::Start(0))?;
        let mut prefix = [0; PREFIX];
        file.read_exact(&mut prefix)
            .map_err(|_| TakeError::NoTake)?;
        let [magic, version, length] = [&prefix[..8], &prefix[8..12], &prefix[12..16]];
        if magic != MAGIC {
            return Err(TakeError::NoTake);
        }
        if word(version) != VERSION {
            return Err(TakeError::OtherVersion(format!("layout {}", word(version))));
        }
        let length = word(length);
        if LARGEST_HEADER < length || size < PREFIX as u64 + u64::from(length) {
            return Err(TakeError::NoTake);
        }
        let mut json = vec![0; length as usize];
        file.read_exact(&mut json)?;
        if fnv::hash(json.iter().copied()).to_le_bytes() != prefix[16..] {
            return Err(TakeError::NoTake);
        }
        let header: TakeHeader = serde_json::from_slice(&json).map_err(|_| TakeError::NoTake)?;
        if !header.is_possible() {
            return Err(TakeError::NoTake);
        }
        let start = PREFIX as u64 + u64::from(length);
        let frames = (size - start) / header.frame_bytes() as u64;
        let most = u64::from(header.frame_count);
        let mut take = Self {
            file,
            whole: u32::try_from(frames.min(most)).unwrap_or(u32::MAX),
            header,
            start,
        };
        while 0 < take.whole && !take.is_whole(take.whole - 1)? {
            take.whole -= 1;
        }
        Ok(take)
    }

    /// What it is of.
    pub const fn header(&self) -> &TakeHeader {
        &self.header
    }

    /// Whole frames.
    pub const fn whole_count(&self) -> u32 {
        self.whole
    }

    /// Bytes up to the end of the last whole frame.
    pub fn whole_bytes(&self) -> u64 {
        self.place(self.whole)
    }

    fn place(&self, frame: u32) -> u64 {
        self.start + u64::from(frame) * self.header.frame_bytes() as u64
    }

    fn bytes_at(&mut self, place: u64, count: usize) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; count];
        self.file.seek(SeekFrom::Start(place))?;
        self.file.read_exact(&mut bytes)?;
        Ok(bytes)
    }

    fn is_whole(&mut self, frame: u32) -> io::Result<bool> {
        let count = self.header.frame_bytes();
        let bytes = self.bytes_at(self.place(frame), count)?;
        let (payload, hash) = bytes.split_at(count - 8);
        Ok(fnv::hash(payload.iter().copied()).to_le_bytes() == hash)
    }

    /// The hash that a frame ends with.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn hash(&mut self, frame: u32) -> io::Result<[u8; 8]> {
        let place = self.place(frame + 1) - 8;
        let bytes = self.bytes_at(place, 8)?;
        Ok(bytes.try_into().unwrap_or_default())
    }

    /// The same with what it moves.
    pub const fn with_scene(self, scene: TakeScene) -> StagedTake<R> {
        StagedTake { take: self, scene }
    }

    fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices> {
        let before: usize = self.header.meshes[..mesh]
            .iter()
            .map(|(_, count)| count)
            .sum();
        let count = self.header.meshes[mesh].1;
        let place = self.place(frame) + (POSE_BYTES + VERTEX_BYTES * before) as u64;
        let bytes = self.bytes_at(place, VERTEX_BYTES * count)?;
        let (positions, normals) = bytes.split_at(12 * count);
        let positions: Vec<Vec3> = positions.chunks_exact(12).map(vector).collect();
        if !positions.iter().all(|position| position.is_finite()) {
            return Err(no_number(frame));
        }
        let normals = normals.chunks_exact(4).map(|it| {
            let level = |at: usize| i16::from_le_bytes([it[at], it[at + 1]]);
            unfolded([level(0), level(2)])
        });
        Ok([positions, normals.collect()])
    }

    fn pose(&mut self, frame: u32) -> io::Result<Pose> {
        let bytes = self.bytes_at(self.place(frame), POSE_BYTES)?;
        let turns = bytes[12..].chunks_exact(16).map(|it| {
            let axis = vector(it);
            Quat::from_xyzw(axis.x, axis.y, axis.z, float(&it[12..]))
        });
        let pose = Pose {
            hips_translation: vector(&bytes),
            rotations: turns.collect(),
        };
        let is_turn = |turn: &Quat| turn.is_finite() && turn.is_normalized();
        if pose.hips_translation.is_finite() && pose.rotations.iter().all(is_turn) {
            Ok(pose)
        } else {
            Err(no_number(frame))
        }
    }
}

/// A frame whose hash is right and whose values are none: nobody recorded it.
fn no_number(frame: u32) -> io::Error {
    io::Error::new(
        io::ErrorKind::InvalidData,
        format!("frame {frame} of the take has places that are no numbers; record it again"),
    )
}

/// A recording with the meshes that it moves.
#[derive(Debug)]
pub struct StagedTake<R> {
    take: RecordedTake<R>,
    scene: TakeScene,
}

impl<R: Read + Seek> TakeSource for StagedTake<R> {
    fn scene(&self) -> &TakeScene {
        &self.scene
    }

    fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices> {
        self.take.vertices(frame, mesh)
    }

    fn pose(&mut self, frame: u32) -> io::Result<Pose> {
        self.take.pose(frame)
    }
}

/// Appends frames to what is whole of a recording.
///
/// # Errors
/// A full disk, or a file that cannot be written.
pub fn append(file: &mut (impl Write + Seek), place: u64, bytes: &[u8]) -> io::Result<()> {
    file.seek(SeekFrom::Start(place))?;
    file.write_all(bytes)
}

fn word(bytes: &[u8]) -> u32 {
    bytes.try_into().map_or(0, u32::from_le_bytes)
}

fn float(bytes: &[u8]) -> f32 {
    f32::from_bits(word(&bytes[..4]))
}

fn vector(bytes: &[u8]) -> Vec3 {
    Vec3::new(float(bytes), float(&bytes[4..]), float(&bytes[8..]))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use proptest::prelude::*;

    use super::*;

    fn header() -> TakeHeader {
        TakeHeader {
            lole: "0".into(),
            frame_rate: 30,
            frame_count: 4,
            design: String::new(),
            files_hash: 7,
            meshes: vec![("a".into(), 3), ("b".into(), 2)],
        }
    }

    fn vertices(count: u8, frame: u8) -> TakeVertices {
        let point = |it: u8| Vec3::new(f32::from(it), f32::from(frame), 0.1);
        let positions: Vec<Vec3> = (0..count).map(point).collect();
        let normals = positions.iter().map(|it| it.normalize_or(Vec3::Y));
        [positions.clone(), normals.collect()]
    }

    fn recorded(frames: u8) -> Vec<u8> {
        let mut bytes = header().bytes().unwrap();
        for frame in 0..frames {
            let pose = Pose {
                hips_translation: Vec3::splat(f32::from(frame)),
                ..Pose::default()
            };
            bytes.extend(frame_bytes(
                &pose,
                &[vertices(3, frame), vertices(2, frame)],
            ));
        }
        bytes
    }

    #[test]
    fn what_is_recorded_is_read_again() {
        let mut take = RecordedTake::open(Cursor::new(recorded(4))).unwrap();
        assert_eq!((take.header(), take.whole_count()), (&header(), 4));
        for frame in 0..4_u8 {
            let [positions, normals] = take.vertices(frame.into(), 1).unwrap();
            assert_eq!(positions, vertices(2, frame)[0]);
            for (read, kept) in normals.iter().zip(&vertices(2, frame)[1]) {
                assert!(read.distance(*kept) < 1.0e-4, "{read} {kept}");
            }
            let pose = take.pose(frame.into()).unwrap();
            assert_eq!(pose.hips_translation, Vec3::splat(f32::from(frame)));
        }
    }

    /// Hashes are no seals: a header or a frame that fits its hash may still be nobody's.
    #[test]
    fn figures_that_no_take_has_are_refused() {
        let with = |change: &dyn Fn(&mut TakeHeader)| {
            let mut header = header();
            change(&mut header);
            RecordedTake::open(Cursor::new(header.bytes().unwrap())).map(|take| take.whole)
        };
        assert_eq!(with(&|_| ()).unwrap(), 0);
        let many = with(&|it| it.meshes[0].1 = usize::MAX / 8);
        assert!(matches!(many, Err(TakeError::NoTake)));
        let wrapped = with(&|it| it.meshes = vec![("a".into(), usize::MAX), ("b".into(), 2)]);
        assert!(matches!(wrapped, Err(TakeError::NoTake)));
        for rate in [0, u32::MAX] {
            assert!(matches!(
                with(&|it| it.frame_rate = rate),
                Err(TakeError::NoTake)
            ));
        }
    }

    #[test]
    fn frames_of_no_numbers_are_not_read() {
        let mut bytes = header().bytes().unwrap();
        let broken = [vec![Vec3::NAN; 3], vec![Vec3::Y; 3]];
        let pose = Pose {
            hips_translation: Vec3::INFINITY,
            ..Pose::default()
        };
        bytes.extend(frame_bytes(&pose, &[broken, vertices(2, 0)]));
        let mut take = RecordedTake::open(Cursor::new(bytes)).unwrap();
        assert_eq!(take.whole_count(), 1);
        assert!(take.pose(0).is_err() && take.vertices(0, 0).is_err());
        assert!(take.vertices(0, 1).is_ok());
    }

    proptest! {
        /// Wherever a recording is cut off, and whatever stands behind its last whole frame, the frames before are
        /// found and no others.
        #[test]
        fn a_recording_that_was_cut_off_has_its_whole_frames(cut in 0_usize..10_000, junk in any::<u8>()) {
            let whole = recorded(4);
            let start = header().bytes().unwrap().len();
            let cut = start + cut % (whole.len() - start);
            let mut bytes = whole[..cut].to_vec();
            bytes.resize(whole.len(), junk);
            let frames = (cut - start) / header().frame_bytes();
            let take = RecordedTake::open(Cursor::new(&bytes[..])).unwrap();
            let found = take.whole_count() as usize;
            // Junk that is what would have stood there is a whole frame.
            prop_assert!(found == frames || bytes == whole);
            let take = RecordedTake::open(Cursor::new(&bytes[..cut])).unwrap();
            prop_assert_eq!(take.whole_count() as usize, frames);
        }

        #[test]
        fn a_normal_keeps_its_direction(x in -1.0_f32..1.0, y in -1.0_f32..1.0, z in -1.0_f32..1.0) {
            let normal = Vec3::new(x, y, z).normalize_or(Vec3::Y);
            prop_assert!(unfolded(folded(normal)).distance(normal) < 1.0e-4);
        }

        #[test]
        fn bytes_of_anything_are_no_take(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            prop_assert!(RecordedTake::open(Cursor::new(bytes)).is_err());
        }
    }
}
