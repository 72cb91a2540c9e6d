//! Garments of the templates on six dancers, each from the front, the side and the back: what a fitting
//! shows before a dance.
//!
//! `cargo run --release -p lole_picture --example fitting_room -- OUT [TEMPLATE ...] [--only DANCER]
//! [--seconds S] [--layer under] [--close]` writes a picture for each template there and prints figures for
//! each dancer. Without a template, all that can be put on.

#![expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a tool prints figures, times among them"
)]

use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;

use glam::Vec3;
use lole_body::Figure;
use lole_costume::document::schema::kind_ids;
use lole_costume::document::{DancerDesign, Design, GarmentDesign, GarmentLayer, parse};
use lole_costume::dress;
use lole_picture::{Figure as Shown, Looks};
use lole_render::{Backend, Camera, LightRig, Renderer, Size, View};
use lole_stage::{Performance, Production};

/// Size of one picture of the sheet [pixel].
const CELL: Size = Size::new(360, 560);
const VIEWS: [View; 3] = [View::Front, View::Side, View::Back];

/// Who is dressed: name, figure, stature, bust, waist and hip [cm].
const DANCERS: [(&str, Figure, [Option<f64>; 4]); 6] = [
    ("child", Figure::Child, [Some(120.0), None, None, None]),
    (
        "small",
        Figure::Woman,
        [Some(150.0), Some(80.0), Some(62.0), Some(86.0)],
    ),
    ("mean", Figure::Woman, [None; 4]),
    (
        "tall",
        Figure::Woman,
        [Some(173.0), Some(90.0), Some(70.0), Some(97.0)],
    ),
    (
        "large",
        Figure::Woman,
        [Some(163.0), Some(102.0), Some(90.0), Some(106.0)],
    ),
    ("man", Figure::Man, [None; 4]),
];

struct Asked {
    out: PathBuf,
    templates: Vec<String>,
    only: Option<String>,
    seconds: f32,
    layer: GarmentLayer,
    is_close: bool,
    has_skirt: bool,
    print: Option<String>,
}

fn asked() -> Result<Asked, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut asked = Asked {
        out: PathBuf::from(arguments.next().ok_or("where to?")?),
        templates: Vec::new(),
        only: None,
        seconds: 0.0,
        layer: GarmentLayer::Over,
        is_close: false,
        has_skirt: false,
        print: None,
    };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--only" => asked.only = arguments.next(),
            "--seconds" => asked.seconds = arguments.next().ok_or("seconds?")?.parse()?,
            "--layer" => {
                asked.layer = match arguments.next().as_deref() {
                    Some("under") => GarmentLayer::Under,
                    _ => GarmentLayer::Over,
                }
            }
            "--close" => asked.is_close = true,
            "--skirt" => asked.has_skirt = true,
            "--print" => asked.print = arguments.next(),
            id => asked.templates.push(id.to_owned()),
        }
    }
    if asked.templates.is_empty() {
        let ids = kind_ids().into_iter().filter(|id| dress::is_worn(id));
        asked.templates = ids.map(str::to_owned).collect();
    }
    Ok(asked)
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    std::fs::create_dir_all(&asked.out)?;
    for template in &asked.templates {
        let mut rows = Vec::new();
        for (name, figure, cm) in DANCERS {
            if asked.only.as_ref().is_some_and(|only| only != name) {
                continue;
            }
            match fitting(&asked, template, (figure, cm)) {
                Ok((row, said)) => {
                    println!("{template:12} {name:6} {said}");
                    rows.push(row);
                }
                Err(error) => println!("{template:12} {name:6} refused: {error}"),
            }
        }
        let file = asked.out.join(format!("{template}.png"));
        write_sheet(&file, &rows)?;
    }
    Ok(())
}

/// One dancer from all sides, side by side, and what is to be said of her.
fn fitting(
    asked: &Asked,
    template: &str,
    (figure, [stature_cm, bust_cm, waist_cm, hip_cm]): (Figure, [Option<f64>; 4]),
) -> Result<(Vec<u8>, String), Box<dyn Error>> {
    let mut worn = GarmentDesign::of_kind(template).ok_or("no such garment")?;
    *worn.layer_mut() = asked.layer;
    if let Some(print) = &asked.print {
        let text = format!("lole = 1\n[print]\n{print}\n");
        *worn.print_mut() = parse(&text, "print")?.print;
    }
    let mut design = Design {
        dancer: DancerDesign {
            figure,
            stature_cm,
            bust_cm,
            waist_cm,
            hip_cm,
            ..DancerDesign::default()
        },
        garments: vec![worn],
        ..Design::default()
    };
    if !asked.has_skirt {
        design.skirt.is_worn = false;
    }
    (design.skirt.column_count, design.skirt.row_count) = (256, 32);
    let begun = Instant::now();
    let production = Production::new(&design)?;
    let sewn = begun.elapsed().as_secs_f32();
    let mut performance = Performance::new(production)?;
    while performance.time() < 0.0 {
        performance.advance().map_err(|_| "the cloth flew away")?;
    }
    let (mut frames, mut moving) = (0_u16, 0.0);
    let mut worst = (0.0_f32, 0.0_f32, 0);
    loop {
        performance.pose_body();
        let (strain, skin) = performance.measure_dressed(0);
        worst = (
            worst.0.max(strain.p99),
            worst.1.max(skin.worst_depth),
            worst.2.max(skin.showing_body_vertices),
        );
        if asked.seconds <= performance.time() {
            break;
        }
        let begun = Instant::now();
        performance.advance().map_err(|_| "the cloth flew away")?;
        moving += begun.elapsed().as_secs_f32();
        frames += 1;
    }
    let each = moving / f32::from(frames.max(1));
    let row = shoot(asked, &performance)?;
    let count = performance.production().dressed[0].dressed.particle_count();
    let said = format!(
        "{count} particles, sewn in {sewn:.1} s, p99 strain {:.1} %, deepest {:.1} mm, showing {}, {:.1} ms a frame with all",
        100.0 * worst.0,
        1000.0 * worst.1,
        worst.2,
        1000.0 * each,
    );
    Ok((row, said))
}

fn shoot(asked: &Asked, performance: &Performance) -> Result<Vec<u8>, Box<dyn Error>> {
    let production = performance.production();
    let looks = Looks::new(&production.design, production)?;
    let grids: Vec<[Vec<Vec3>; 2]> = (production.garments.iter())
        .map(|garment| {
            let mut vertices = [Vec::new(), Vec::new()];
            let [positions, normals] = &mut vertices;
            if asked.has_skirt {
                garment
                    .mesh
                    .spread(performance.garment_positions(garment), positions);
                garment
                    .mesh
                    .spread(&performance.garment_normals(garment), normals);
            }
            vertices
        })
        .collect();
    let dressed: Vec<[Vec<Vec3>; 2]> = (0..production.dressed.len())
        .map(|place| performance.dressed_vertices(place))
        .collect();
    let adornments = performance.posed_adornments();
    let shown = Shown {
        cloths: &grids,
        cloth_colors: &[],
        dressed: &dressed,
        adornments: &adornments,
        body: [performance.body_positions(), performance.body_normals()],
    };
    let points: Vec<Vec3> = if asked.is_close {
        dressed
            .iter()
            .flat_map(|vertices| vertices[0].clone())
            .collect()
    } else {
        let body = performance.body_positions().iter().copied();
        body.chain(dressed.iter().flat_map(|vertices| vertices[0].clone()))
            .collect()
    };
    let mut renderer = Renderer::new(Backend::Cpu, CELL)?;
    let mut row = vec![0; (CELL.width * CELL.height * 3 * 4) as usize];
    for (place, view) in VIEWS.into_iter().enumerate() {
        let camera = Camera::framing_points(&points, view, CELL.aspect());
        let lights = LightRig::seen_from(&camera);
        let scene = looks.scene(production, &shown, camera, lights);
        let image = renderer.render(&scene)?;
        let width = CELL.width as usize * 4;
        for line in 0..CELL.height as usize {
            let to = (line * 3 + place) * width;
            row[to..to + width].copy_from_slice(&image.pixels[line * width..][..width]);
        }
    }
    Ok(row)
}

fn write_sheet(file: &std::path::Path, rows: &[Vec<u8>]) -> Result<(), Box<dyn Error>> {
    if rows.is_empty() {
        return Ok(());
    }
    let height = CELL.height * u32::try_from(rows.len())?;
    let out = std::io::BufWriter::new(std::fs::File::create(file)?);
    let mut encoder = png::Encoder::new(out, CELL.width * 3, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&rows.concat())?;
    Ok(())
}
