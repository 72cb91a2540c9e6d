//! A table for each mesh: every vertex of every frame in a row.

use std::io::{self, BufWriter, Write};

use super::{TakeFolder, TakeSource, finite};

/// Writes `NAME.csv` for every mesh: frame, time [s], vertex, position [m].
///
/// # Errors
/// As [`super::write_take`].
pub fn write_csv(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    for mesh in 0..take.scene().meshes.len() {
        let name = take.scene().meshes[mesh].name.clone();
        let mut file = BufWriter::new(folder.create(&format!("{name}.csv"))?);
        writeln!(file, "frame,time_s,vertex,x_m,y_m,z_m")?;
        for frame in 0..take.scene().frame_count {
            let time = take.scene().time(frame);
            let [positions, _] = take.vertices(frame, mesh)?;
            finite(&name, &positions)?;
            for (vertex, [x, y, z]) in positions.iter().map(|it| it.to_array()).enumerate() {
                writeln!(file, "{frame},{time:.6},{vertex},{x:.6},{y:.6},{z:.6}")?;
            }
        }
        file.flush()?;
    }
    Ok(())
}
