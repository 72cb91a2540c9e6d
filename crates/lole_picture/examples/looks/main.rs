//! Twenty situations in which a look is judged, on one sheet, and how far each differs from the sheet of before.
//!
//! `cargo run --release -p lole_picture --example looks -- OUT [NAME ...]` writes each as `OUT/NAME.png` and all as
//! `OUT/looks.jpg`. Beside each name stands how far it is from the kept sheet, `docs/looks.jpg`: the difference of 8-bit
//! colors that one place in fifty exceeds, where places are means over a few pixels, free of grain and compression. `cargo xtask looks` does both and keeps the sheet after it was looked at.

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
/// From here on a picture looks different; the sheet's own compression leaves less.
const DIFFERENT: u8 = 10;
/// Pixels of the sheet that are one place.
const PLACE: u32 = 4;
/// One place in so many may differ more.
const PLACES: usize = 50;

#[expect(clippy::print_stdout, reason = "a tool prints figures")]
fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let out = PathBuf::from(arguments.next().ok_or("where to?")?);
    let asked: Vec<String> = arguments.collect();
    let is_known = |name: &String| SITUATIONS.iter().any(|situation| situation.name == name);
    if let Some(name) = asked.iter().find(|name| !is_known(name)) {
        let names: Vec<&str> = SITUATIONS.iter().map(|situation| situation.name).collect();
        return Err(format!("{name} is no situation; there are {}", names.join(", ")).into());
    }
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
        let difference = kept.as_ref().map(|kept| difference(kept, &small, [x, y]));
        let said = difference.map_or("new".to_owned(), |steps| steps.to_string());
        let same = difference.is_some_and(|steps| steps < DIFFERENT);
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
        // From 90 on chroma is whole; the sheet of halved chroma came back in other colors.
        fs::write(out.join("looks.jpg"), encode_jpeg(view, 90)?)?;
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
    let looks = Looks::photographed(&design, performance.production())?;
    let moment = Moment::photographed(&performance, &looks);
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

/// How far a picture is from that at its place in the sheet of before.
fn difference(kept: &RgbImage, small: &RgbImage, [x, y]: [u32; 2]) -> u8 {
    let before = crop_imm(kept, x, y, CELL[0], CELL[1]).to_image();
    let coarse = |image: &RgbImage| {
        let [width, height] = CELL.map(|side| side / PLACE);
        resize(image, width, height, FilterType::Triangle)
    };
    let (before, after) = (coarse(&before), coarse(small));
    let places = before.pixels().zip(after.pixels());
    let mut steps: Vec<u8> = places
        .map(|(a, b)| (0..3).map(|at| a[at].abs_diff(b[at])).max().unwrap_or(0))
        .collect();
    steps.sort_unstable();
    let place = steps.len() - steps.len() / PLACES;
    steps.get(place).copied().unwrap_or(0)
}
