//! A take: everything that was seen to move, frame by frame, and the files that other programs open.
//!
//! | Format | Writer | Read by |
//! |---|---|---|
//! | PC2, MDD | [`point_cache`] | Blender, 3ds Max, Maya, Houdini, LightWave |
//! | OBJ sequence | [`obj`] | nearly every 3D program |
//! | NPZ | [`npz`] | NumPy |
//! | CSV | [`csv`] | spreadsheets, R, anything |
//! | USD, USDZ | [`usd`] | Houdini, Maya, Blender, Unreal, Omniverse, phones |
//!
//! All of them are in meters, right-handed, `+Y` up, with the dancer's front at `+Z`.
//! A take is larger than memory: writers ask a [`TakeSource`] for one mesh in one frame at a time, and write into
//! what the caller gives them.

pub mod csv;
pub mod npz;
pub mod obj;
pub mod point_cache;
pub mod record;
mod scene;
pub mod usd;

pub use scene::{TakeMaterial, TakeMesh, TakePart, TakeScene, identifier};

use std::io::{self, Seek, Write};

use glam::Vec3;
use lole_body::Pose;

/// Vertices of a mesh [m] and their unit normals.
pub type TakeVertices = [Vec<Vec3>; 2];

/// Where a take's frames come from.
pub trait TakeSource {
    /// What does not move.
    fn scene(&self) -> &TakeScene;

    /// One mesh in one frame.
    ///
    /// # Errors
    /// A frame that cannot be read, or a caller who no longer wants it.
    fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices>;

    /// The dancer's pose in one frame.
    ///
    /// # Errors
    /// As [`Self::vertices`].
    fn pose(&mut self, frame: u32) -> io::Result<Pose>;
}

/// A file that is being written.
pub trait TakeFile: Write + Seek {}

impl<W: Write + Seek> TakeFile for W {}

/// Where a take's files go.
pub trait TakeFolder {
    /// Begins a file.
    ///
    /// # Errors
    /// A file that cannot be made.
    fn create(&mut self, name: &str) -> io::Result<Box<dyn TakeFile + '_>>;
}

/// Forms of a take that other programs open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TakeFormat {
    /// Point caches of 3ds Max and Blender, one for each mesh, with the mesh as OBJ.
    Pc2,
    /// Point caches of LightWave, one for each mesh, with the mesh as OBJ.
    Mdd,
    /// One OBJ for each frame, with materials.
    Obj,
    /// Arrays of NumPy.
    Npz,
    /// A table for each mesh.
    Csv,
    /// A binary stage with pictures beside it.
    Usd,
    /// The same as one file.
    Usdz,
}

/// Writes a take.
///
/// # Errors
/// A file that cannot be written, a frame that cannot be read, or a caller who no longer wants it.
pub fn write_take(
    format: TakeFormat,
    take: &mut dyn TakeSource,
    folder: &mut dyn TakeFolder,
) -> io::Result<()> {
    match format {
        TakeFormat::Pc2 => point_cache::write_pc2(take, folder),
        TakeFormat::Mdd => point_cache::write_mdd(take, folder),
        TakeFormat::Obj => obj::write_sequence(take, folder),
        TakeFormat::Npz => npz::write_npz(take, folder),
        TakeFormat::Csv => csv::write_csv(take, folder),
        TakeFormat::Usd => usd::write_usd(take, folder),
        TakeFormat::Usdz => usd::write_usdz(take, folder),
    }
}

/// Finite or an error: no file is made of numbers that are not.
fn finite(name: &str, points: &[Vec3]) -> io::Result<()> {
    match points.iter().position(|point| !point.is_finite()) {
        None => Ok(()),
        Some(vertex) => Err(io::Error::new(
            io::ErrorKind::InvalidData,
            format!("{name}: vertex {vertex} is nowhere"),
        )),
    }
}
