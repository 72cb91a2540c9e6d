//! `lole dancer`: the dancer alone, in pictures, figures and a 3D file.

use anyhow::Result;
use lole_body::{Dancer, Expression, Pose, Swing};
use lole_costume::document::Place;
use lole_export::dancer_sheet::{DancerSheet, dancer_json};
use lole_export::{ImageView, still};
use lole_language::{Language, Sentence};
use lole_picture::baked;
use lole_picture::studio::{STILLS, cameras_around};
use lole_render::{Backend, LightRig, Renderer, Scene, SceneMesh, Size};
use lole_study::figures;

use crate::args::DancerArgs;
use crate::output;
use crate::patience::progress_bar;
use crate::source;
use crate::{Failure, summary};

/// Size of the pictures: upright, as a person is.
const PICTURE_SIZE: Size = Size {
    width: 900,
    height: 1200,
};

/// Runs the command.
pub(crate) fn run(args: &DancerArgs, language: Language) -> Result<(), Failure> {
    let mut source = source::read(args.design.as_deref())?;
    source.put(args.avatar.as_deref(), None)?;
    source.measure(args.measures.as_deref())?;
    let (dancer, license) = lole_stage::dancer(&source.design).map_err(|error| {
        let place = Place {
            table: "dancer",
            key: "",
        };
        source.located(place, Sentence::of(&error))
    })?;
    let avatar = source.design.dancer.file.as_ref();
    let sheet = DancerSheet {
        avatar: avatar.map(|file| file.name.clone()),
        ..figures::dancer_sheet(&dancer, &source.design.tape(), license.as_ref())
    };
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    let count = STILLS.iter().map(|_| 1_u32).sum();
    let bar = progress_bar(count, language.pick("写真をとる", "taking pictures"));
    let backend = if args.cpu {
        Backend::Cpu
    } else {
        Backend::Auto
    };
    for (name, picture) in pictures(&dancer, backend, || bar.inc(1)).map_err(Failure::error)? {
        output.write(name, &picture).map_err(Failure::error)?;
    }
    bar.finish_and_clear();
    if !baked::is_kept_here(license.as_ref()) {
        let glb = baked::body_glb(&dancer).map_err(Failure::error)?;
        output.write("dancer.glb", &glb).map_err(Failure::error)?;
    }
    let json = dancer_json(&sheet).map_err(Failure::error)?;
    output
        .write("dancer.json", json.as_bytes())
        .map_err(Failure::error)?;
    let paths = output.finish().map_err(Failure::error)?;
    if args.json {
        summary::print_json(&json);
        return Ok(());
    }
    summary::print_files(&paths, language);
    summary::print_dancer(&sheet, language);
    if let Some(license) = &license {
        summary::print_lines(&license.lines(), language);
    }
    Ok(())
}

/// The dancer from all sides as PNG, by file name.
fn pictures(
    dancer: &Dancer,
    backend: Backend,
    taken: impl Fn(),
) -> Result<Vec<(&'static str, Vec<u8>)>> {
    let world_from_bind = dancer.skeleton.world_from_bind(&Pose::default());
    let [positions, normals] = lole_picture::drawn_body(
        dancer,
        &world_from_bind,
        (Expression::default(), &Swing::default()),
    );
    let drawn = dancer.drawn();
    let materials = lole_picture::dancer_materials(dancer)?;
    let mut renderer = Renderer::new(backend, PICTURE_SIZE)?;
    let cameras = cameras_around(&positions, PICTURE_SIZE);
    let mut pictures = Vec::new();
    for (still, camera) in STILLS.iter().zip(cameras) {
        let parts = drawn.parts.iter().zip(&materials);
        let scene = Scene {
            meshes: parts
                .map(|(part, (_, material))| SceneMesh {
                    positions: &positions,
                    normals: &normals,
                    uvs: &drawn.uvs,
                    colors: &drawn.colors,
                    triangles: &part.triangles,
                    material,
                })
                .collect(),
            lights: LightRig::seen_from(&camera),
            ..Scene::studio(camera)
        };
        let image = renderer.render(&scene)?;
        let image = ImageView::new(image.width, image.height, &image.pixels)?;
        pictures.push((still.file, still::encode_png(image)?));
        taken();
    }
    Ok(pictures)
}
