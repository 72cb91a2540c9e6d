//! Twenty situations in which a look is judged, on one sheet, and how far each differs from the sheet of before.
//!
//! `cargo run --release -p lole_picture --example looks -- OUT [NAME ...]` writes each as `OUT/NAME.png` and all as
//! `OUT/looks.jpg`. Beside each name stands how alike it is to the kept sheet, `docs/looks.jpg`, from 0 to 1, by
//! structure and color. `cargo xtask looks` does both and keeps the sheet after it was looked at.

mod situations;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use glam::Vec3;
use image::RgbImage;
use image::imageops::{FilterType, crop_imm, replace, resize};
use lole_costume::document::parse;
use lole_export::ImageView;
use lole_export::still::{encode_jpeg, encode_png};
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{Backend, Camera, Image, Renderer, Size};
use lole_stage::{FRAME_SECONDS, Performance, Production};

use situations::{Part, SITUATIONS, Situation};

/// One picture at full size [pixel].
const FULL: Size = Size::new(720, 960);
/// One picture of the sheet [pixel].
const CELL: [u32; 2] = [240, 320];
/// Pictures side by side.
const COLUMNS: u32 = 5;
/// The sheet that is kept.
const KEPT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/looks.jpg");
/// Below this a picture looks different: the sheet's own compression leaves more.
const ALIKE: f64 = 0.97;

#[expect(clippy::print_stdout, reason = "a tool prints figures")]
fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let out = PathBuf::from(arguments.next().ok_or("where to?")?);
    let asked: Vec<String> = arguments.collect();
    fs::create_dir_all(&out)?;
    let kept = image::open(KEPT).map(|image| image.to_rgb8()).ok();
    let rows = u32::try_from(SITUATIONS.len())?.div_ceil(COLUMNS);
    let mut sheet = RgbImage::new(COLUMNS * CELL[0], rows * CELL[1]);
    let mut changed = 0;
    for (number, situation) in (0..).zip(SITUATIONS) {
        if !asked.is_empty() && !asked.iter().any(|name| name == situation.name) {
            continue;
        }
        let picture = shot(situation)?;
        write_png(&out.join(format!("{}.png", situation.name)), &picture)?;
        let [x, y] = [number % COLUMNS * CELL[0], number / COLUMNS * CELL[1]];
        let small = small(&picture).ok_or("a picture of another size")?;
        let alike = kept.as_ref().and_then(|kept| alike(kept, &small, [x, y]));
        let (said, same) = alike.map_or(("new".to_owned(), false), |score| {
            (format!("{score:.3}"), ALIKE <= score)
        });
        changed += i32::from(!same);
        println!(
            "{:18} {said:6} {}",
            situation.name,
            if same { "" } else { "look at it" }
        );
        replace(&mut sheet, &small, i64::from(x), i64::from(y));
    }
    if asked.is_empty() {
        let pixels: Vec<u8> = (sheet.pixels())
            .flat_map(|pixel| [pixel[0], pixel[1], pixel[2], u8::MAX])
            .collect();
        let view = ImageView::new(sheet.width(), sheet.height(), &pixels)?;
        fs::write(out.join("looks.jpg"), encode_jpeg(view, 88)?)?;
        println!("{changed} of {} look different", SITUATIONS.len());
    }
    Ok(())
}

/// One situation, danced to its moment and drawn.
fn shot(situation: &Situation) -> Result<Image, Box<dyn Error>> {
    let design = parse(situation.document, situation.name)?;
    let mut performance = Performance::new(Production::new(&design)?)?;
    while performance.time() + 0.5 * FRAME_SECONDS < situation.seconds {
        let advanced = performance.advance();
        advanced.map_err(|lost| format!("the cloth left the stage at {} s", lost.time))?;
    }
    performance.pose_body();
    let looks = Looks::new(&design, performance.production())?;
    let moment = Moment::of(&performance);
    let camera = camera(&performance, situation);
    let scene = looks.scene(&moment.dancer(), camera, Lamps::WithCamera);
    Ok(Renderer::new(Backend::Cpu, FULL)?.render(&scene)?)
}

/// A camera that shows what is to be judged.
fn camera(performance: &Performance, situation: &Situation) -> Camera {
    let crown = performance.production().dancer.landmarks.crown_height;
    let body = performance.body_positions();
    let [low, high] = match situation.part {
        Part::Whole => {
            let mut points = body.to_vec();
            points.extend(performance.cloth_positions());
            return Camera::framing_points(&points, situation.view, FULL.aspect());
        }
        Part::Head => [0.83, 1.02],
        Part::Bust => [0.60, 1.02],
        Part::Waist => [0.48, 0.68],
        Part::Feet => [-0.02, 0.20],
    };
    let near = |place: &&Vec3| (low * crown..high * crown).contains(&place.y);
    let near: Vec<Vec3> = body.iter().filter(near).copied().collect();
    // Arms that reach out of the picture do not make it wider.
    let middle = near.iter().sum::<Vec3>() / near.len().max(1) as f32;
    let reach = 0.5 * (high - low) * crown;
    let close =
        |place: &Vec3| (place.x - middle.x).abs() < reach && (place.z - middle.z).abs() < reach;
    let points: Vec<Vec3> = near.into_iter().filter(close).collect();
    Camera::framing_points(&points, situation.view, FULL.aspect())
}

fn write_png(path: &Path, picture: &Image) -> Result<(), Box<dyn Error>> {
    let view = ImageView::new(picture.width, picture.height, &picture.pixels)?;
    Ok(fs::write(path, encode_png(view)?)?)
}

/// A picture as large as a cell of the sheet.
fn small(picture: &Image) -> Option<RgbImage> {
    let colors = picture
        .pixels
        .chunks(4)
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    let full = RgbImage::from_raw(picture.width, picture.height, colors.collect())?;
    Some(resize(&full, CELL[0], CELL[1], FilterType::Triangle))
}

/// How alike a picture is to that at its place in the sheet of before.
fn alike(kept: &RgbImage, small: &RgbImage, [x, y]: [u32; 2]) -> Option<f64> {
    let before = crop_imm(kept, x, y, CELL[0], CELL[1]).to_image();
    image_compare::rgb_hybrid_compare(&before, small)
        .ok()
        .map(|found| found.score)
}
