//! Stages of OpenUSD in their binary form, alone with its pictures or as one package.
//!
//! `metersPerUnit` is 1, `upAxis` is `Y`, a time code is a frame. Points, normals and extents are sampled in every
//! frame; what is skinned elsewhere is sampled here too, so that every program shows the same to the bit.

mod crate_file;
mod encode;
mod stage;

use std::io::{self, BufWriter, Write};

use glam::Vec3;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::{TakeFolder, TakeMaterial, TakeScene, TakeSource, finite};
use crate_file::{CrateFile, Piece};

/// Name of the stage's file; of a package, the first in it.
const STAGE: &str = "dance.usdc";
/// Files of a package begin at multiples of this (USDZ specification, "Layout").
const ALIGNMENT: u16 = 64;

/// Writes `dance.usdc` and its pictures.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_usd(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    for (name, png) in pictures(take.scene()) {
        folder.create(&name)?.write_all(png)?;
    }
    let mut file = BufWriter::new(folder.create(STAGE)?);
    write_stage(take, &mut file)?;
    file.flush()
}

/// Writes `dance.usdz`: the stage and its pictures, stored.
///
/// # Errors
/// As [`super::write_take`], and a stage of more than 4 GiB, which a package cannot hold.
pub fn write_usdz(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    let mut zip = ZipWriter::new(BufWriter::new(folder.create("dance.usdz")?));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .with_alignment(ALIGNMENT);
    zip.start_file(STAGE, options)?;
    write_stage(take, &mut zip)?;
    for (name, png) in pictures(take.scene()) {
        zip.start_file(name, options)?;
        zip.write_all(png)?;
    }
    zip.finish()?.flush()
}

fn pictures(scene: &TakeScene) -> impl Iterator<Item = (String, &[u8])> {
    let parts = scene.meshes.iter().flat_map(|mesh| &mesh.parts);
    parts.filter_map(|part| {
        let png = part.material.texture_png.as_deref()?;
        Some((TakeMaterial::picture_name(&part.material), png))
    })
}

/// Everything but the moving vertices is laid out first, so that the file is written from its first byte to its last.
fn write_stage(take: &mut dyn TakeSource, out: &mut dyn Write) -> io::Result<()> {
    let file: CrateFile = stage::stage(take.scene());
    let laid = file.laid_out();
    out.write_all(&laid.head)?;
    for piece in &laid.pieces {
        match piece {
            Piece::Bytes(bytes) => out.write_all(bytes)?,
            &Piece::Frame { mesh, frame } => {
                let [positions, normals] = take.vertices(frame, mesh as usize)?;
                finite(&take.scene().meshes[mesh as usize].name, &positions)?;
                write_array(out, &positions)?;
                write_array(out, &normals)?;
                write_array(out, &extent(&positions))?;
            }
        }
    }
    out.write_all(&laid.tail)
}

/// Smallest and largest coordinates.
fn extent(positions: &[Vec3]) -> [Vec3; 2] {
    let first = positions.first().copied().unwrap_or_default();
    positions.iter().fold([first; 2], |[low, high], &point| {
        [low.min(point), high.max(point)]
    })
}

/// An array of vectors as [`crate_file::array_bytes`] counts it.
fn write_array(out: &mut dyn Write, vectors: &[Vec3]) -> io::Result<()> {
    let mut bytes = Vec::with_capacity(crate_file::array_bytes(vectors.len()));
    bytes.extend((vectors.len() as u64).to_le_bytes());
    for vector in vectors {
        bytes.extend(vector.to_array().into_iter().flat_map(f32::to_le_bytes));
    }
    bytes.resize(crate_file::array_bytes(vectors.len()), 0);
    out.write_all(&bytes)
}
