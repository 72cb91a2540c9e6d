//! NumPy arrays in one file.
//!
//! | Array | Shape | |
//! |---|---|---|
//! | `times_s` | `[frames]` | when each frame is [s] |
//! | `frame_rate` | `[]` | frames in a second |
//! | `mesh_names`, `bone_names` | `[meshes]`, `[bones]` | text |
//! | `NAME.positions` | `[frames, vertices, 3]` | [m], `+Y` up |
//! | `NAME.triangles` | `[triangles, 3]` | by vertices |
//! | `NAME.uvs` | `[vertices, 2]` | in repeats of the print, v down; where there are any |
//! | `bone_rotations` | `[frames, bones, 4]` | quaternions `x y z w`, each by the axes of the bind pose |
//! | `hips_translation` | `[frames, 3]` | off the bind pose [m] |

use std::io::{self, BufWriter, Write};

use lole_body::Bone;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::{TakeFile, TakeFolder, TakeSource, finite};

/// Header bytes of an array end at multiples of this.
const ALIGNMENT: usize = 64;
/// Magic and version of the format 1.0.
const MAGIC: &[u8; 8] = b"\x93NUMPY\x01\x00";

type Archive<'a> = ZipWriter<BufWriter<Box<dyn TakeFile + 'a>>>;

/// Writes `dance.npz`.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_npz(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    let mut zip = ZipWriter::new(BufWriter::new(folder.create("dance.npz")?));
    let frame_count = take.scene().frame_count;
    let frames = frame_count as usize;
    begin(&mut zip, "times_s", "<f8", &[frames])?;
    for frame in 0..frame_count {
        zip.write_all(&take.scene().time(frame).to_le_bytes())?;
    }
    begin(&mut zip, "frame_rate", "<f8", &[])?;
    zip.write_all(&f64::from(take.scene().frame_rate).to_le_bytes())?;
    let meshes = take.scene().meshes.iter().map(|mesh| mesh.name.as_str());
    names(&mut zip, "mesh_names", &meshes.collect::<Vec<_>>())?;
    for mesh in 0..take.scene().meshes.len() {
        write_mesh(&mut zip, take, mesh)?;
    }
    let bones = Bone::ALL.iter().map(|bone| bone.name());
    names(&mut zip, "bone_names", &bones.collect::<Vec<_>>())?;
    begin(&mut zip, "bone_rotations", "<f4", &[frames, Bone::COUNT, 4])?;
    for frame in 0..frame_count {
        let pose = take.pose(frame)?;
        let turns = Bone::ALL.iter().map(|&bone| pose.rotation(bone).to_array());
        floats(&mut zip, turns.flatten())?;
    }
    begin(&mut zip, "hips_translation", "<f4", &[frames, 3])?;
    for frame in 0..frame_count {
        floats(&mut zip, take.pose(frame)?.hips_translation.to_array())?;
    }
    zip.finish()?.flush()
}

fn write_mesh(zip: &mut Archive<'_>, take: &mut dyn TakeSource, mesh: usize) -> io::Result<()> {
    let scene = take.scene();
    let (name, count) = (
        scene.meshes[mesh].name.clone(),
        scene.meshes[mesh].vertex_count,
    );
    let frame_count = scene.frame_count;
    let triangles: Vec<[u32; 3]> = scene.meshes[mesh].triangles().collect();
    begin(
        zip,
        &format!("{name}.triangles"),
        "<u4",
        &[triangles.len(), 3],
    )?;
    for index in triangles.as_flattened() {
        zip.write_all(&index.to_le_bytes())?;
    }
    let uvs = scene.meshes[mesh].uvs.clone();
    if !uvs.is_empty() {
        begin(zip, &format!("{name}.uvs"), "<f4", &[uvs.len(), 2])?;
        floats(zip, uvs.iter().flat_map(|uv| uv.to_array()))?;
    }
    let shape = [frame_count as usize, count, 3];
    begin(zip, &format!("{name}.positions"), "<f4", &shape)?;
    for frame in 0..frame_count {
        let [positions, _] = take.vertices(frame, mesh)?;
        finite(&name, &positions)?;
        floats(zip, positions.iter().flat_map(|point| point.to_array()))?;
    }
    Ok(())
}

/// Begins an array: its header is a Python dictionary, padded with blanks.
fn begin(zip: &mut Archive<'_>, name: &str, kind: &str, shape: &[usize]) -> io::Result<()> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .large_file(true);
    zip.start_file(format!("{name}.npy"), options)?;
    let shape: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    while !(MAGIC.len() + 2 + header.len() + 1).is_multiple_of(ALIGNMENT) {
        header.push(' ');
    }
    header.push('\n');
    let length = u16::try_from(header.len()).map_err(io::Error::other)?;
    zip.write_all(MAGIC)?;
    zip.write_all(&length.to_le_bytes())?;
    zip.write_all(header.as_bytes())
}

/// An array of text: as many letters each as the longest has, filled with zeros.
fn names(zip: &mut Archive<'_>, name: &str, words: &[&str]) -> io::Result<()> {
    let width = words
        .iter()
        .map(|word| word.len())
        .max()
        .unwrap_or(0)
        .max(1);
    begin(zip, name, &format!("<U{width}"), &[words.len()])?;
    for word in words {
        let letters = word.chars().map(u32::from);
        for letter in letters.chain(std::iter::repeat(0)).take(width) {
            zip.write_all(&letter.to_le_bytes())?;
        }
    }
    Ok(())
}

fn floats(zip: &mut Archive<'_>, values: impl IntoIterator<Item = f32>) -> io::Result<()> {
    let bytes: Vec<u8> = values.into_iter().flat_map(f32::to_le_bytes).collect();
    zip.write_all(&bytes)
}
