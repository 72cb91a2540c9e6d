//! What a dance was at the key times of its 3D file.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};

use glam::Vec3;
use lole_body::Pose;
use lole_export::ExportError;
use lole_export::glb::ClothFrames;
use lole_stage::Performance;

/// Bytes of a place: three `f32`.
const PLACE_BYTES: usize = 12;

/// Poses and cloth at key times.
#[derive(Debug, Default)]
pub struct Keys {
    /// When each was kept [s].
    pub times: Vec<f32>,
    /// The dancer's pose at each.
    pub poses: Vec<Pose>,
    worn: Kept,
}

/// Where what is worn was, key by key.
#[derive(Debug)]
enum Kept {
    /// By key, then by surface; see [`Performance::recorded`].
    Memory(Vec<Vec<Vec<Vec3>>>),
    /// The same as bytes, for dances that memory is too small for.
    Scratch {
        file: RefCell<File>,
        /// Vertices of each surface, the same in every key.
        counts: Vec<usize>,
    },
}

impl Default for Kept {
    fn default() -> Self {
        Self::Memory(Vec::new())
    }
}

impl Keys {
    /// Keys that keep what is worn in an empty file that can be read again; it is the caller's to remove.
    #[must_use]
    pub fn in_file(scratch: File) -> Self {
        Self {
            worn: Kept::Scratch {
                file: RefCell::new(scratch),
                counts: Vec::new(),
            },
            ..Self::default()
        }
    }

    /// Keeps the current frame.
    ///
    /// # Errors
    /// A file that takes no more.
    pub fn keep(&mut self, performance: &Performance) -> io::Result<()> {
        self.put(performance.recorded())?;
        self.times.push(performance.time());
        self.poses.push(performance.pose().clone());
        Ok(())
    }

    fn put(&mut self, recorded: Vec<Vec<Vec3>>) -> io::Result<()> {
        match &mut self.worn {
            Kept::Memory(keys) => keys.push(recorded),
            Kept::Scratch { file, counts } => {
                *counts = recorded.iter().map(Vec::len).collect();
                let places = recorded.iter().flatten().flat_map(Vec3::to_array);
                let bytes: Vec<u8> = places.flat_map(f32::to_le_bytes).collect();
                file.get_mut().write_all(&bytes)?;
            }
        }
        Ok(())
    }

    /// What was kept of each surface.
    pub(super) fn by_surface(&self) -> Vec<SurfaceKeys<'_>> {
        let count = match &self.worn {
            Kept::Memory(keys) => keys.first().map_or(0, Vec::len),
            Kept::Scratch { counts, .. } => counts.len(),
        };
        let surface = |surface| SurfaceKeys {
            keys: self,
            surface,
        };
        (0..count).map(surface).collect()
    }
}

/// One surface in every key.
#[derive(Debug)]
pub(super) struct SurfaceKeys<'a> {
    keys: &'a Keys,
    surface: usize,
}

impl ClothFrames for SurfaceKeys<'_> {
    fn count(&self) -> usize {
        self.keys.times.len()
    }

    fn frame(&self, number: usize) -> Result<Cow<'_, [Vec3]>, ExportError> {
        match &self.keys.worn {
            Kept::Memory(keys) => Ok(Cow::Borrowed(&keys[number][self.surface])),
            Kept::Scratch { file, counts } => {
                let read = read_key(&mut file.borrow_mut(), counts, [number, self.surface]);
                read.map(Cow::Owned)
                    .map_err(|error| ExportError::FrameLost {
                        mesh: "worn".to_owned(),
                        frame: number,
                        cause: error.to_string(),
                    })
            }
        }
    }
}

/// The places of a surface in a key.
fn read_key(
    file: &mut File,
    counts: &[usize],
    [key, surface]: [usize; 2],
) -> io::Result<Vec<Vec3>> {
    let whole: usize = counts.iter().sum();
    let before: usize = counts[..surface].iter().sum();
    let start = (key * whole + before) * PLACE_BYTES;
    file.seek(SeekFrom::Start(start as u64))?;
    let mut bytes = vec![0; counts[surface] * PLACE_BYTES];
    file.read_exact(&mut bytes)?;
    let numbers = bytes
        .as_chunks::<4>()
        .0
        .iter()
        .map(|it| f32::from_le_bytes(*it));
    let numbers: Vec<f32> = numbers.collect();
    let places = numbers.as_chunks::<3>().0.iter();
    Ok(places.map(|place| Vec3::from_array(*place)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_in_a_file_comes_back_to_the_bit() {
        let path = std::env::temp_dir().join(format!("lole_keys_{}", std::process::id()));
        let mut options = File::options();
        let options = options.read(true).write(true).create(true).truncate(true);
        let file = options.open(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        let (mut filed, mut held) = (Keys::in_file(file), Keys::default());
        let place = |seed: u32| Vec3::new(seed as f32, f32::from_bits(seed + 1), -0.0);
        for key in 0..7 {
            // A surface without vertices lies between the others, as an adornment without its flowers does.
            let surfaces =
                [5, 0, 3].map(|count| (0..count).map(|at| place(97 * key + at)).collect());
            for keys in [&mut filed, &mut held] {
                keys.put(surfaces.to_vec()).unwrap();
                keys.times.push(key as f32);
            }
        }
        let (filed, held) = (filed.by_surface(), held.by_surface());
        assert_eq!(filed.len(), 3);
        for (filed, held) in filed.iter().zip(&held) {
            assert_eq!((filed.count(), held.count()), (7, 7));
            // Out of order too: the fit looks at samples first.
            for key in [6, 0, 3, 5, 1] {
                let bits = |frame: Cow<'_, [Vec3]>| -> Vec<[u32; 3]> {
                    let places = frame.iter();
                    places.map(|it| it.to_array().map(f32::to_bits)).collect()
                };
                assert_eq!(
                    bits(filed.frame(key).unwrap()),
                    bits(held.frame(key).unwrap())
                );
            }
        }
    }
}
