//! Wavefront OBJ with its materials: each mesh alone in its first frame, or one file for each frame of a take.

use std::io::{self, BufWriter, Write};

use super::scene::{TakeMaterial, TakeMesh};
use super::{TakeFolder, TakeSource, TakeVertices, finite};

/// Digits after the point of a position [m]: a micrometer.
const DIGITS: usize = 6;
/// Digits of normals and of places on the print.
const FINE: usize = 5;

/// Writes `NAME.obj` with its `NAME.mtl` for every mesh, as it is in the first frame: what a point cache moves.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_meshes(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    for mesh in 0..take.scene().meshes.len() {
        let vertices = take.vertices(0, mesh)?;
        let mesh = &take.scene().meshes[mesh];
        write_materials(
            &format!("{}.mtl", mesh.name),
            std::slice::from_ref(mesh),
            folder,
        )?;
        let mut file = BufWriter::new(folder.create(&format!("{}.obj", mesh.name))?);
        head(&mut file, &format!("{}.mtl", mesh.name))?;
        write_mesh(&mut file, mesh, &vertices, 1)?;
        file.flush()?;
    }
    Ok(())
}

/// Writes `dance_0000.obj` and so on, all meshes in each, with one `dance.mtl`.
///
/// # Errors
/// As [`super::write_take`].
pub fn write_sequence(take: &mut dyn TakeSource, folder: &mut dyn TakeFolder) -> io::Result<()> {
    write_materials("dance.mtl", &take.scene().meshes, folder)?;
    let frame_count = take.scene().frame_count;
    // As many digits as all of them have, so that they are in order by name.
    let width = frame_count.to_string().len().max(4);
    for frame in 0..frame_count {
        let mut file = BufWriter::new(folder.create(&format!("dance_{frame:0width$}.obj"))?);
        head(&mut file, "dance.mtl")?;
        writeln!(file, "# frame {frame}, {:.6} s", take.scene().time(frame))?;
        let mut first = 1;
        for mesh in 0..take.scene().meshes.len() {
            let vertices = take.vertices(frame, mesh)?;
            let mesh = &take.scene().meshes[mesh];
            write_mesh(&mut file, mesh, &vertices, first)?;
            first += mesh.vertex_count;
        }
        file.flush()?;
    }
    Ok(())
}

fn head(file: &mut impl Write, materials: &str) -> io::Result<()> {
    writeln!(
        file,
        "# Lole. Meters, right-handed, Y up; the dancer's front is +Z."
    )?;
    writeln!(file, "mtllib {materials}")
}

/// Vertices, then triangles by material; the first vertex is number `first` of the file. Every vertex has a normal
/// and a place on the print, so that one number names all three.
fn write_mesh(
    file: &mut impl Write,
    mesh: &TakeMesh,
    [positions, normals]: &TakeVertices,
    first: usize,
) -> io::Result<()> {
    finite(&mesh.name, positions)?;
    writeln!(file, "o {}", mesh.name)?;
    for (vertex, [x, y, z]) in positions.iter().map(|point| point.to_array()).enumerate() {
        write!(file, "v {x:.DIGITS$} {y:.DIGITS$} {z:.DIGITS$}")?;
        match mesh.colors.get(vertex) {
            Some(color) => writeln!(file, " {:.4} {:.4} {:.4}", color.x, color.y, color.z)?,
            None => writeln!(file)?,
        }
    }
    for vertex in 0..mesh.vertex_count {
        let uv = mesh.uvs.get(vertex).copied().unwrap_or_default();
        writeln!(file, "vt {:.FINE$} {:.FINE$}", uv.x, 1.0 - uv.y)?;
    }
    for [x, y, z] in normals.iter().map(|normal| normal.to_array()) {
        writeln!(file, "vn {x:.FINE$} {y:.FINE$} {z:.FINE$}")?;
    }
    for part in &mesh.parts {
        writeln!(file, "usemtl {}", part.material.name)?;
        for triangle in &part.triangles {
            let [a, b, c] = triangle.map(|vertex| vertex as usize + first);
            writeln!(file, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
        }
    }
    Ok(())
}

fn write_materials(name: &str, meshes: &[TakeMesh], folder: &mut dyn TakeFolder) -> io::Result<()> {
    let parts = || meshes.iter().flat_map(|mesh| &mesh.parts);
    let mut text = String::from("# Lole\n");
    for part in parts() {
        text += &material(&part.material);
    }
    folder.create(name)?.write_all(text.as_bytes())?;
    for part in parts() {
        if let Some(png) = &part.material.texture_png {
            folder
                .create(&part.material.picture_name())?
                .write_all(png)?;
        }
    }
    Ok(())
}

/// The color is linear, as programs that shade by physics read it; `Pr` is roughness as most programs that
/// know more than `Ns` read it.
fn material(material: &TakeMaterial) -> String {
    let [red, green, blue] = material.base_color;
    let roughness = material.roughness.clamp(0.0, 1.0);
    // Blender's own relation of the two, which is its importer's too.
    let exponent = 1000.0 * (1.0 - roughness) * (1.0 - roughness);
    let mut text = format!(
        "\nnewmtl {}\nKd {red:.5} {green:.5} {blue:.5}\nKs 0.04 0.04 0.04\nNs {exponent:.2}\nPr {roughness:.3}\nillum 2\n",
        material.name
    );
    if material.texture_png.is_some() {
        text += &format!("map_Kd {}\n", material.picture_name());
    }
    text
}
