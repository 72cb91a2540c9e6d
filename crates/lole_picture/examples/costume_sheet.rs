//! A design from four sides at several moments of its dance on one sheet, to judge a costume by eye, with
//! the time that a frame takes.
//!
//! `cargo run --release -p lole_picture --example costume_sheet -- design.lole sheet.png 0,1.5,3 zoom`

use std::error::Error;
use std::io::Write;

use glam::Vec3;
use lole_costume::document;
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{Backend, Camera, Renderer, Size, View};
use lole_stage::{FRAME_SECONDS, Performance, Production};

const VIEWS: [View; 4] = [View::Front, View::ThreeQuarter, View::Side, View::Back];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument = |index: usize, missing: &str| {
        arguments
            .get(index)
            .map_or_else(|| missing.to_owned(), Clone::clone)
    };
    let text = std::fs::read_to_string(argument(0, "design.lole"))?;
    let design = document::parse(&text, "design.lole")?;
    let times = argument(2, "0,1.5");
    let times: Vec<f32> = times.split(',').map(str::parse).collect::<Result<_, _>>()?;
    // Part of the height that is shown, from the top: "all", "upper", "lower" or "head".
    let part = argument(3, "all");
    let size = Size::new(480, 640);
    let mut renderer = Renderer::new(Backend::Cpu, size)?;
    let mut performance = Performance::new(Production::new(&design)?)?;
    let looks = Looks::photographed(&design, performance.production())?;
    while performance.time() < 0.0 {
        advance(&mut performance)?;
    }
    let (width, height) = (size.width as usize, size.height as usize);
    let mut sheet = vec![0_u8; VIEWS.len() * width * times.len() * height * 4];
    let (mut spent, mut frames) = (0.0, 0_u32);
    for (row, &time) in times.iter().enumerate() {
        while performance.time() + 0.5 * FRAME_SECONDS < time {
            spent += advance(&mut performance)?;
            frames += 1;
        }
        performance.pose_body();
        for (column, &view) in VIEWS.iter().enumerate() {
            let image = shoot(&performance, &looks, (view, &part), &mut renderer)?;
            for line in 0..height {
                let from = line * width * 4;
                let to = ((row * height + line) * VIEWS.len() + column) * width * 4;
                sheet[to..to + width * 4].copy_from_slice(&image[from..from + width * 4]);
            }
        }
    }
    let mut out = std::io::stdout().lock();
    let mean = 1e3 * spent / f64::from(frames.max(1));
    writeln!(
        out,
        "{mean:.2} ms a frame, {:016x}",
        performance.state_hash()
    )?;
    let file = std::fs::File::create(argument(1, "sheet.png"))?;
    let side = |count: usize| u32::try_from(count).unwrap_or(0);
    let mut encoder =
        png::Encoder::new(file, side(VIEWS.len() * width), side(times.len() * height));
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&sheet)?;
    Ok(())
}

/// Moves on by a frame, and how long it took [s].
#[expect(clippy::disallowed_methods, reason = "an example that measures time")]
fn advance(performance: &mut Performance) -> Result<f64, Box<dyn Error>> {
    let start = std::time::Instant::now();
    performance
        .advance()
        .map_err(|lost| format!("the cloth left the stage at {} s", lost.time))?;
    Ok(start.elapsed().as_secs_f64())
}

fn shoot(
    performance: &Performance,
    looks: &Looks,
    (view, part): (View, &str),
    renderer: &mut Renderer,
) -> Result<Vec<u8>, Box<dyn Error>> {
    let production = performance.production();
    let moment = Moment::photographed(performance, looks);
    let crown = production.dancer.landmarks.crown_height;
    let [low, high] = match part {
        "upper" => [0.52, 1.0],
        "lower" => [0.0, 0.62],
        "head" => [0.80, 1.0],
        _ => [0.0, 1.2],
    };
    let framed: Vec<Vec3> = (performance.body_positions().iter().copied())
        .filter(|place| low * crown < place.y && place.y < high * crown)
        .filter(|place| part == "all" || place.x.abs() < 0.3)
        .collect();
    let camera = Camera::framing_points(&framed, view, 480.0 / 640.0);
    let scene = looks.scene(&moment.dancer(), camera, Lamps::WithCamera);
    Ok(renderer.render(&scene)?.pixels)
}
