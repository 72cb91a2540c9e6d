//! Where cloth and skin disagree in somebody's dance, and pictures of it.
//!
//! `cargo run --release -p lole_picture --example recorded -- OUT [--avatar FILE] [--motion FILE]
//! [--seconds S] [--every N] [--design FILE]` prints, for every so manyth frame in which cloth
//! is below the skin or strained by more than 10 % (p99), how deep the deepest particle lies, in which row
//! and on which bone's skin, and where the cloth is stretched most; the worst frames become pictures from
//! four sides in OUT, and where the body was told to leave no room comes last. `FILE` may be a step's name
//! for `--motion`; a design comes first, and names no files.

#![expect(clippy::print_stdout, reason = "a tool prints figures")]

use std::error::Error;
use std::path::{Path, PathBuf};

use glam::Vec3;
use lole_body::Bone;
use lole_costume::document::{Design, LinkedFile, parse};
use lole_hula::DanceStep;
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{Backend, Camera, Renderer, Size, View};
use lole_stage::{Performance, Production};

/// Size of one picture of the sheet [pixel].
const CELL: Size = Size::new(420, 560);
const VIEWS: [View; 4] = [View::Front, View::ThreeQuarter, View::Side, View::Back];
/// Strain (p99) from which on a frame is told.
const STRAINED: f32 = 0.1;
/// Pictures are taken of so many frames.
const PICTURES: usize = 4;
/// Frames that are told one after the other at most.
const APART: f32 = 0.25;

struct Asked {
    out: PathBuf,
    design: Design,
    seconds: f32,
    every: u32,
}

fn asked() -> Result<Asked, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut asked = Asked {
        out: PathBuf::from(arguments.next().ok_or("where to?")?),
        design: Design::default(),
        seconds: 4.0,
        every: 2,
    };
    let design = &mut asked.design;
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} what?"));
        match argument.as_str() {
            "--avatar" => design.dancer.file = Some(linked(&value()?)?),
            "--motion" => {
                let name = value()?;
                match DanceStep::from_id(&name) {
                    Some(step) => design.motion.step = step,
                    None => design.motion.file = Some(linked(&name)?),
                }
            }
            "--seconds" => asked.seconds = value()?.parse()?,
            "--every" => asked.every = value()?.parse()?,
            "--design" => *design = parse(&std::fs::read_to_string(value()?)?, "design")?,
            other => return Err(format!("{other} is unknown").into()),
        }
    }
    Ok(asked)
}

fn linked(name: &str) -> Result<LinkedFile, Box<dyn Error>> {
    Ok(LinkedFile {
        bytes: Some(std::fs::read(name)?.into()),
        ..LinkedFile::named(name)
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    std::fs::create_dir_all(&asked.out)?;
    let mut performance = Performance::new(Production::new(&asked.design)?)?;
    while performance.time() < 0.0 {
        performance.advance().map_err(|_| "the cloth flew away")?;
    }
    // How wrong, when, and the picture.
    let mut worst: Vec<(f32, f32, Vec<u8>)> = Vec::new();
    let mut frame = 0_u32;
    loop {
        if frame.is_multiple_of(asked.every) {
            performance.pose_body();
            let wrong = tell(&performance);
            let (time, least) = (performance.time(), worst.last().map_or(0.0, |it| it.0));
            let is_near = |it: &&mut (f32, f32, Vec<u8>)| (it.1 - time).abs() < APART;
            let is_full = PICTURES <= worst.len();
            let near = worst.iter_mut().find(is_near);
            match near {
                Some(near) if near.0 < wrong => *near = (wrong, time, shoot(&performance)?),
                Some(_) => {}
                None if 0.0 < wrong && !(is_full && wrong <= least) => {
                    worst.push((wrong, time, shoot(&performance)?));
                }
                None => {}
            }
            worst.sort_by(|a, b| b.0.total_cmp(&a.0));
            worst.truncate(PICTURES);
        }
        if asked.seconds <= performance.time() {
            break;
        }
        performance.advance().map_err(|_| "the cloth flew away")?;
        frame += 1;
    }
    for told in performance.no_room() {
        println!("{}", told.sentence());
    }
    for (_, time, pixels) in &worst {
        write(&asked.out.join(format!("at-{time:.2}.png")), pixels)?;
    }
    Ok(())
}

/// Prints what is wrong in a frame; how wrong it is, 0 where nothing is told.
fn tell(performance: &Performance) -> f32 {
    let measured = performance.measure();
    let (skin, strain) = (measured.skin, measured.strain);
    if skin.worst_depth <= 0.5e-3 && strain.p99 < STRAINED {
        return 0.0;
    }
    println!(
        "{:6.2} s  deepest {:4.1} mm, {} below and {} showing, p99 {:.1} %, max {:.0} %",
        performance.time(),
        1000.0 * skin.worst_depth,
        skin.sunken_cloth_vertices,
        skin.showing_body_vertices,
        100.0 * strain.p99,
        100.0 * strain.max,
    );
    for garment in &performance.production().garments {
        let positions = performance.garment_positions(garment);
        let columns = garment.sewn.spec.grid.column_count as usize;
        let depths = performance.depths_below_skin(positions);
        let place = |particle: usize| {
            let (row, column, at) = (particle / columns, particle % columns, positions[particle]);
            let bone = bone_at(performance, at).name();
            format!("row {row}, column {column}, {at:.2}, on {bone}")
        };
        if let Some((particle, depth)) = largest(&depths).filter(|it| 0.5e-3 < it.1) {
            let pinned = if garment.sewn.spec.pinned[particle] {
                "pinned, "
            } else {
                ""
            };
            println!(
                "          {pinned}{:.1} mm: {}",
                1000.0 * depth,
                place(particle)
            );
        }
        let strains = performance.strain_by_particle(garment);
        if let Some((particle, strain)) = largest(&strains).filter(|it| STRAINED < it.1) {
            println!("          {:.0} %: {}", 100.0 * strain, place(particle));
        }
    }
    skin.worst_depth + 0.1 * strain.p99
}

fn largest(values: &[f32]) -> Option<(usize, f32)> {
    let values = values.iter().copied().enumerate();
    values.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The bone whose skin is nearest.
fn bone_at(performance: &Performance, place: Vec3) -> Bone {
    let skin = &performance.production().dancer.skin;
    let distances = (performance.body_positions().iter()).map(|it| it.distance_squared(place));
    let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    let vertex = nearest.map_or(0, |(vertex, _)| vertex);
    let shares = skin.weights[vertex].into_iter().zip(skin.joints[vertex]);
    let most = shares.max_by(|a, b| a.0.total_cmp(&b.0));
    Bone::ALL[usize::from(most.map_or(0, |(_, joint)| joint))]
}

/// The dancer from all sides.
fn shoot(performance: &Performance) -> Result<Vec<u8>, Box<dyn Error>> {
    let production = performance.production();
    let looks = Looks::photographed(&production.design, production)?;
    let moment = Moment::photographed(performance, &looks);
    let mut renderer = Renderer::new(Backend::Cpu, CELL)?;
    let mut cells = Vec::new();
    for view in VIEWS {
        let camera = Camera::framing_points(performance.body_positions(), view, CELL.aspect());
        let scene = looks.scene(&moment.dancer(), camera, Lamps::WithCamera);
        cells.push(renderer.render(&scene)?.pixels);
    }
    let width = CELL.width as usize * 4;
    let lines = (0..CELL.height as usize).flat_map(|line| {
        let parts = cells.iter().map(move |cell| &cell[line * width..][..width]);
        parts.collect::<Vec<_>>().concat()
    });
    Ok(lines.collect())
}

fn write(file: &Path, pixels: &[u8]) -> Result<(), Box<dyn Error>> {
    let width = CELL.width * u32::try_from(VIEWS.len())?;
    let out = std::io::BufWriter::new(std::fs::File::create(file)?);
    let mut encoder = png::Encoder::new(out, width, CELL.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(())
}
