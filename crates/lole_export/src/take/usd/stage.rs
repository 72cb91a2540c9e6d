//! The prims of a take: one model of meshes, and what they are made of.

use super::crate_file::{CrateFile, Path, Rep};
use crate::take::{TakeMaterial, TakeMesh, TakeScene};

/// Name of the model, which a stage that refers to this one gets.
const MODEL: &str = "dance";

/// The stage of a take, all but its moving vertices.
#[expect(
    clippy::cast_precision_loss,
    reason = "rates and frames are far below 2^24"
)]
pub(super) fn stage(scene: &TakeScene) -> CrateFile {
    let mut file = CrateFile::new();
    let root = CrateFile::ROOT;
    let said = file.string(concat!(
        "Written by Lole ",
        env!("CARGO_PKG_VERSION"),
        ". Meters; the dancer's front is +Z."
    ));
    file.field(root, "documentation", said);
    let model = file.token(MODEL);
    file.field(root, "defaultPrim", model);
    let up = file.token("Y");
    file.field(root, "upAxis", up);
    file.field(root, "metersPerUnit", Rep::double(1.0));
    let rate = Rep::double(scene.frame_rate as f32);
    file.field(root, "timeCodesPerSecond", rate);
    file.field(root, "framesPerSecond", rate);
    file.field(root, "startTimeCode", Rep::double(0.0));
    let last = scene.frame_count.saturating_sub(1);
    file.field(root, "endTimeCode", Rep::double(last as f32));

    let model = file.prim(root, MODEL, "Xform");
    let kind = file.token("component");
    file.field(model, "kind", kind);
    let materials = file.prim(model, "materials", "Scope");
    let times: Vec<f64> = (0..scene.frame_count).map(f64::from).collect();
    let times = file.times(&times);
    for (place, mesh) in (0_u32..).zip(&scene.meshes) {
        let made: Vec<Path> = mesh
            .parts
            .iter()
            .map(|part| material(&mut file, materials, &part.material, mesh))
            .collect();
        let prim = file.prim(model, &mesh.name, "Mesh");
        surface(&mut file, prim, mesh);
        bind(&mut file, prim, mesh, &made);
        let frames =
            (0..scene.frame_count).map(|frame| file.frame((place, frame), mesh.vertex_count));
        let frames: Vec<[Rep; 3]> = frames.collect();
        move_points(&mut file, prim, times, &frames);
    }
    file
}

/// What of a mesh stays as it is.
fn surface(file: &mut CrateFile, prim: Path, mesh: &TakeMesh) {
    let triangles: Vec<[u32; 3]> = mesh.triangles().collect();
    let counts = file.integers(&vec![3; triangles.len()]);
    file.attribute(prim, ("int[]", "faceVertexCounts"), Some(counts));
    let corners = file.integers(triangles.as_flattened());
    file.attribute(prim, ("int[]", "faceVertexIndices"), Some(corners));
    let none = file.token("none");
    file.constant(prim, ("token", "subdivisionScheme"), none);
    let is_two_sided = mesh.parts.iter().any(|part| part.material.is_two_sided);
    file.constant(prim, ("bool", "doubleSided"), Rep::bool(is_two_sided));
    let vertex = file.token("vertex");
    if !mesh.uvs.is_empty() {
        let uvs: Vec<[f32; 2]> = mesh.uvs.iter().map(|uv| [uv.x, 1.0 - uv.y]).collect();
        let uvs = file.vectors2(&uvs);
        let uvs = file.attribute(prim, ("texCoord2f[]", "primvars:st"), Some(uvs));
        file.field(uvs, "interpolation", vertex);
    }
    if !mesh.colors.is_empty() {
        let colors: Vec<[f32; 3]> = mesh.colors.iter().map(|color| color.to_array()).collect();
        let colors = file.vectors3(&colors);
        let colors = file.attribute(prim, ("color3f[]", "primvars:displayColor"), Some(colors));
        file.field(colors, "interpolation", vertex);
    }
}

/// Points, normals and extents of all frames.
fn move_points(file: &mut CrateFile, prim: Path, times: Rep, frames: &[[Rep; 3]]) {
    let names = [
        ("point3f[]", "points"),
        ("normal3f[]", "normals"),
        ("float3[]", "extent"),
    ];
    for (column, name) in names.into_iter().enumerate() {
        let values: Vec<Rep> = frames.iter().map(|frame| frame[column]).collect();
        let samples = file.samples(times, &values);
        let attribute = file.attribute(prim, name, None);
        file.field(attribute, "timeSamples", samples);
        if name.1 == "normals" {
            let vertex = file.token("vertex");
            file.field(attribute, "interpolation", vertex);
        }
    }
}

/// Binds the whole mesh to its material, or subsets of its faces to theirs.
fn bind(file: &mut CrateFile, prim: Path, mesh: &TakeMesh, materials: &[Path]) {
    let binding = file.prepended(&["MaterialBindingAPI"]);
    if let &[material] = materials {
        file.field(prim, "apiSchemas", binding);
        file.relationship(prim, "material:binding", material);
        return;
    }
    let partition = file.token("partition");
    let family = ("token", "subsetFamily:materialBind:familyType");
    file.constant(prim, family, partition);
    let mut first = 0;
    for (part, &material) in mesh.parts.iter().zip(materials) {
        let subset = file.prim(prim, &part.material.name, "GeomSubset");
        file.field(subset, "apiSchemas", binding);
        let face = file.token("face");
        file.constant(subset, ("token", "elementType"), face);
        let family = file.token("materialBind");
        file.constant(subset, ("token", "familyName"), family);
        let count = u32::try_from(part.triangles.len()).unwrap_or(u32::MAX);
        let faces: Vec<u32> = (first..first + count).collect();
        first += count;
        let faces = file.integers(&faces);
        file.attribute(subset, ("int[]", "indices"), Some(faces));
        file.relationship(subset, "material:binding", material);
    }
}

/// A material of `UsdPreviewSurface`: its picture, or the colors of the vertices, or one color.
fn material(file: &mut CrateFile, scope: Path, look: &TakeMaterial, mesh: &TakeMesh) -> Path {
    let material = file.prim(scope, &look.name, "Material");
    let surface = shader(file, material, ("surface", "UsdPreviewSurface"));
    let color = file.vector(look.base_color);
    let color = file.attribute(surface, ("color3f", "inputs:diffuseColor"), Some(color));
    let numbers = [
        ("inputs:roughness", look.roughness),
        ("inputs:metallic", 0.0),
    ];
    for (name, value) in numbers {
        file.attribute(surface, ("float", name), Some(Rep::float(value)));
    }
    if look.texture_png.is_some() {
        let texture = picture(file, material, look);
        file.connect(color, texture);
    } else if !mesh.colors.is_empty() {
        let reader = shader(file, material, ("colors", "UsdPrimvarReader_float3"));
        let name = file.string("displayColor");
        file.attribute(reader, ("string", "inputs:varname"), Some(name));
        let result = file.attribute(reader, ("float3", "outputs:result"), None);
        file.connect(color, result);
    }
    let made = file.attribute(surface, ("token", "outputs:surface"), None);
    let output = file.attribute(material, ("token", "outputs:surface"), None);
    file.connect(output, made);
    material
}

/// A picture's color, where `primvars:st` says.
fn picture(file: &mut CrateFile, material: Path, look: &TakeMaterial) -> Path {
    let reader = shader(file, material, ("uvs", "UsdPrimvarReader_float2"));
    let name = file.string("st");
    file.attribute(reader, ("string", "inputs:varname"), Some(name));
    let result = file.attribute(reader, ("float2", "outputs:result"), None);
    let texture = shader(file, material, ("picture", "UsdUVTexture"));
    let asset = file.asset(&look.picture_name());
    file.attribute(texture, ("asset", "inputs:file"), Some(asset));
    let place = file.attribute(texture, ("float2", "inputs:st"), None);
    file.connect(place, result);
    let [red, green, blue] = look.base_color;
    let scale = file.vector4([red, green, blue, 1.0]);
    file.attribute(texture, ("float4", "inputs:scale"), Some(scale));
    for (name, value) in [
        ("inputs:sourceColorSpace", "sRGB"),
        ("inputs:wrapS", "repeat"),
        ("inputs:wrapT", "repeat"),
    ] {
        let value = file.token(value);
        file.attribute(texture, ("token", name), Some(value));
    }
    file.attribute(texture, ("float3", "outputs:rgb"), None)
}

fn shader(file: &mut CrateFile, material: Path, (name, id): (&str, &str)) -> Path {
    let shader = file.prim(material, name, "Shader");
    let id = file.token(id);
    file.constant(shader, ("token", "info:id"), id);
    shader
}
