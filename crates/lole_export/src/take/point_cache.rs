//! Point caches: PC2 of 3ds Max, MDD of LightWave. Each has positions alone, so that the mesh stands beside it.

use std::io::{self, BufWriter, Write};

use super::{TakeFolder, TakeSource, finite, obj};

/// `POINTCACHE2`, ended by a zero.
const PC2_MAGIC: &[u8; 12] = b"POINTCACHE2\0";
const PC2_VERSION: u32 = 1;

/// Writes `NAME.pc2` and `NAME.obj` for every mesh.
///
/// The layout: magic, version, number of points, first frame (a float, 0), frames from one sample to the next (a
/// float, 1), number of samples; then the positions of each sample; all little-endian.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_pc2(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    obj::write_meshes(take, folder)?;
    let frame_count = take.scene().frame_count;
    for mesh in 0..take.scene().meshes.len() {
        let (name, points) = named(take, mesh)?;
        let mut file = BufWriter::new(folder.create(&format!("{name}.pc2"))?);
        file.write_all(PC2_MAGIC)?;
        file.write_all(&PC2_VERSION.to_le_bytes())?;
        file.write_all(&points.to_le_bytes())?;
        file.write_all(&0.0_f32.to_le_bytes())?;
        file.write_all(&1.0_f32.to_le_bytes())?;
        file.write_all(&frame_count.to_le_bytes())?;
        for frame in 0..frame_count {
            let [positions, _] = take.vertices(frame, mesh)?;
            finite(&name, &positions)?;
            for value in positions.iter().flat_map(|point| point.to_array()) {
                file.write_all(&value.to_le_bytes())?;
            }
        }
        file.flush()?;
    }
    Ok(())
}

/// Writes `NAME.mdd` and `NAME.obj` for every mesh.
///
/// The layout: number of samples, number of points, the time of each sample [s], then their positions; all
/// big-endian.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_mdd(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    obj::write_meshes(take, folder)?;
    let frame_count = take.scene().frame_count;
    for mesh in 0..take.scene().meshes.len() {
        let (name, points) = named(take, mesh)?;
        let mut file = BufWriter::new(folder.create(&format!("{name}.mdd"))?);
        file.write_all(&frame_count.to_be_bytes())?;
        file.write_all(&points.to_be_bytes())?;
        for frame in 0..frame_count {
            #[expect(clippy::cast_possible_truncation, reason = "ten minutes at most")]
            let time = take.scene().time(frame) as f32;
            file.write_all(&time.to_be_bytes())?;
        }
        for frame in 0..frame_count {
            let [positions, _] = take.vertices(frame, mesh)?;
            finite(&name, &positions)?;
            for value in positions.iter().flat_map(|point| point.to_array()) {
                file.write_all(&value.to_be_bytes())?;
            }
        }
        file.flush()?;
    }
    Ok(())
}

/// Name and number of points of a mesh.
fn named(take: &dyn TakeSource, mesh: usize) -> io::Result<(String, u32)> {
    let mesh = &take.scene().meshes[mesh];
    let count = u32::try_from(mesh.vertex_count).map_err(io::Error::other)?;
    Ok((mesh.name.clone(), count))
}
