//! Garments of the templates on six dancers, each from the front, the side and the back: what a fitting
//! shows before a dance.
//!
//! `cargo run --release -p lole_picture --example fitting_room -- OUT [TEMPLATE ...] [--only DANCER,DANCER]
//! [--seconds S] [--dance STEP] [--tempo BPM] [--layer under] [--skirt] [--close] [--where] [--fine] [--print LINE]`
//! writes a picture for each template there, as she stands and after so many seconds of her dance, and prints
//! figures for each dancer. Without a template, all that can be put on; `kihei+muumuu` puts on both, from
//! the skin outward, and `'pau-ruffle:ruffle = "layer"'` has an option as in a document. `--where` says
//! where cloth is stretched most, and which pieces go through each other; `--fine` divides garments of triangles into
//! those of 1.2 cm.

#![expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a tool prints figures, times among them"
)]

use std::error::Error;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use cpu_time::ProcessTime;
use glam::Vec3;
use lole_body::Bone;
use lole_costume::document::{DancerDesign, Design, GarmentLayer, parse};
use lole_garment::TEMPLATES;
use lole_garment::dress::Layers;
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{Backend, Camera, Renderer, Size, View};
use lole_stage::skin_check::{CheckedSurface, check};
use lole_stage::{Division, Performance, Production, six_dancers};

/// Size of one picture of the sheet [pixel].
const CELL: Size = Size::new(360, 560);
const VIEWS: [View; 3] = [View::Front, View::Side, View::Back];

struct Asked {
    out: PathBuf,
    templates: Vec<String>,
    only: Option<String>,
    seconds: f32,
    layer: GarmentLayer,
    is_close: bool,
    has_skirt: bool,
    print: Option<String>,
    dance: Option<String>,
    tempo: Option<f64>,
    says_where: bool,
    division: Division,
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
        dance: None,
        tempo: None,
        says_where: false,
        division: Division::Full,
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
            "--fine" => asked.division = Division::Fine,
            "--where" => asked.says_where = true,
            "--dance" => asked.dance = arguments.next(),
            "--tempo" => asked.tempo = Some(arguments.next().ok_or("counts a minute?")?.parse()?),
            "--print" => asked.print = arguments.next(),
            id => asked.templates.push(id.to_owned()),
        }
    }
    if asked.templates.is_empty() {
        let ids = TEMPLATES.iter().filter(|it| it.is_sewn()).map(|it| it.id);
        asked.templates = ids.map(str::to_owned).collect();
    }
    Ok(asked)
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    std::fs::create_dir_all(&asked.out)?;
    for template in &asked.templates {
        let mut rows = Vec::new();
        for (name, dancer) in six_dancers() {
            let is_asked = |only: &String| only.split(',').any(|only| only == name);
            if !asked.only.as_ref().is_none_or(is_asked) {
                continue;
            }
            match fitting(&asked, template, dancer) {
                Ok((row, said)) => {
                    println!("{template} {name}: {said}");
                    rows.push(row);
                }
                Err(error) => println!("{template:12} {name:6} refused: {error}"),
            }
        }
        let name = template.replace(|letter: char| !letter.is_ascii_alphanumeric(), "-");
        let file = asked.out.join(format!("{}.png", name.trim_matches('-')));
        write_sheet(&file, &rows)?;
    }
    Ok(())
}

/// One dancer from all sides, side by side, and what is to be said of her.
fn fitting(
    asked: &Asked,
    template: &str,
    dancer: DancerDesign,
) -> Result<(Vec<u8>, String), Box<dyn Error>> {
    let mut garments = Vec::new();
    for id in template.split('+') {
        let (id, option) = id.split_once(':').unwrap_or((id, ""));
        let text = format!("lole = 1\n[[garment]]\nkind = \"{id}\"\n{option}\n");
        let mut worn = parse(&text, "garment")?.garments.remove(0);
        worn.layer = asked.layer;
        if let Some(print) = &asked.print {
            let text = format!("lole = 1\n[print]\n{print}\n");
            worn.print = parse(&text, "print")?.print;
        }
        garments.push(worn);
    }
    let mut design = Design {
        dancer,
        garments,
        ..Design::default()
    };
    if let Some(dance) = &asked.dance {
        let text = format!("lole = 1\n[motion]\nstep = \"{dance}\"\n");
        design.motion = parse(&text, "dance")?.motion;
    }
    design.motion.tempo_bpm = asked.tempo.unwrap_or(design.motion.tempo_bpm);
    if !asked.has_skirt {
        design.skirt.is_worn = false;
    }
    (design.skirt.column_count, design.skirt.row_count) = (256, 32);
    let begun = Instant::now();
    let production = Production::divided(&design, asked.division)?;
    let sewn = begun.elapsed().as_secs_f32();
    let mut performance = Performance::new(production)?;
    let mut restless = String::new();
    while performance.time() < 0.0 {
        let before = places(&performance);
        performance.advance().map_err(|_| "the cloth flew away")?;
        restless = said_of_rest(&before, &places(&performance));
    }
    performance.pose_body();
    let mut cells = shoot(asked, &performance, None)?;
    let (said, close) = danced(asked, &mut performance)?;
    if 0.0 < asked.seconds {
        cells.extend(shoot(asked, &performance, None)?);
    }
    if asked.says_where {
        // Where skin shows most, or where she is at last: each row of a sheet has as many pictures.
        let close = if close.is_empty() {
            shoot(asked, &performance, None)?
        } else {
            close
        };
        cells.extend(close.into_iter().take(VIEWS.len()));
    }
    Ok((
        beside(&cells),
        format!("sewn in {sewn:.1} s, {restless}{said}"),
    ))
}

/// Particles of everything that is dressed [m].
fn places(performance: &Performance) -> Vec<Vec3> {
    let all = 0..performance.production().dressed.len();
    all.flat_map(|place| performance.dressed_positions(place).to_vec())
        .collect()
}

/// How far cloth moves in a frame while she stands.
fn said_of_rest(before: &[Vec3], after: &[Vec3]) -> String {
    let pairs = before.iter().zip(after);
    let mut moves: Vec<(f32, Vec3)> = pairs.map(|(a, b)| (a.distance(*b), *b)).collect();
    moves.sort_by(|a, b| b.0.total_cmp(&a.0));
    let restless = moves.iter().filter(|one| 0.002 < one.0).count();
    moves.first().map_or_else(String::new, |(most, place)| {
        format!(
            "at rest {restless} particles move by more than 2 mm a frame, at most {:.1} mm at {place:.2}",
            1000.0 * most
        )
    })
}

/// What is said of a dance, and close pictures of it.
type SaidAndShot = (String, Vec<Vec<u8>>);

/// Dances, and says what the cloth did meanwhile.
fn danced(asked: &Asked, performance: &mut Performance) -> Result<SaidAndShot, Box<dyn Error>> {
    let count = performance.production().dressed.len();
    let mut seen = vec![Seen::default(); count];
    let (mut frames, mut moving) = (0_u16, 0.0);
    loop {
        performance.pose_body();
        for (place, seen) in seen.iter_mut().enumerate() {
            let (strain, skin) = performance.measure_dressed(place);
            seen.strain = [seen.strain[0].max(strain.p99), strain.p99];
            seen.deepest = seen.deepest.max(skin.worst_depth);
            let hem = hem(performance, place);
            seen.risen = seen.risen.max(hem - *seen.hung.get_or_insert(hem));
            if seen.showing < skin.showing_body_vertices {
                seen.showing = skin.showing_body_vertices;
                let vertices = performance.showing_through(place);
                seen.shown_at = (vertices.iter())
                    .map(|&vertex| performance.body_positions()[vertex])
                    .collect();
                seen.shown_in = performance.time();
                if asked.says_where {
                    seen.close = shoot(asked, performance, Some(&seen.shown_at))?;
                }
            }
            if frames.is_multiple_of(10) {
                let garment = &performance.production().dressed[place].dressed;
                let crossings = garment.crossings(performance.dressed_positions(place));
                let crossings = crossings.ok_or("the cloth is nowhere")?;
                seen.crossings = [seen.crossings[0].max(crossings), crossings];
                seen.drawn = seen.drawn.max(drawn_outside(performance, place));
                let first = || performance.dressed_layers(place);
                let layers = seen.layers.get_or_insert_with(first);
                let inversions = performance.dressed_inversions(place, layers);
                seen.inversions = seen.inversions.max(inversions);
            }
        }
        if asked.seconds <= performance.time() {
            break;
        }
        let begun = ProcessTime::now();
        performance.advance().map_err(|_| "the cloth flew away")?;
        moving += begun.elapsed().as_secs_f32();
        frames += 1;
    }
    let each = 1000.0 * moving / f32::from(frames.max(1));
    let mut said = format!(", {each:.1} ms of processor a frame");
    let mut close = Vec::new();
    say_gathered(performance, &mut said)?;
    for (place, seen) in seen.iter_mut().enumerate() {
        let garment = &performance.production().dressed[place];
        write!(
            said,
            "\n    {:10} {} particles, p99 strain {:.1} % at worst and {:.1} % at the end, deepest {:.1} mm, hem up by {:.0} mm, showing {} (drawn {}), crossings {} at worst and {} at the end, over itself at {} places, {} of them inverted at worst",
            garment.name,
            garment.dressed.particle_count(),
            100.0 * seen.strain[0],
            100.0 * seen.strain[1],
            1000.0 * seen.deepest,
            1000.0 * seen.risen,
            seen.showing,
            seen.drawn,
            seen.crossings[0],
            seen.crossings[1],
            seen.layers
                .as_ref()
                .map_or(0, |layers| layers.places().len()),
            seen.inversions,
        )?;
        if asked.says_where {
            close.append(&mut seen.close);
            say_showing(seen, &mut said)?;
            say_crossings(performance, place, &mut said)?;
            let tightest = say_where(performance, place, &mut said)?;
            if close.is_empty() {
                close = shoot(asked, performance, Some(&tightest))?;
            }
        }
    }
    Ok((said, close))
}

/// How high the lowest particles of a garment are over the hips [m], in the mean.
fn hem(performance: &Performance, place: usize) -> f32 {
    const LOWEST: usize = 40;
    let skeleton = &performance.production().dancer.skeleton;
    let hips = performance.world_from_bind()[Bone::Hips.index()];
    let hips = hips.transform_point3(skeleton.joint(Bone::Hips));
    let places = performance.dressed_positions(place).iter();
    let mut heights: Vec<f32> = places.map(|place| place.y - hips.y).collect();
    heights.sort_by(f32::total_cmp);
    heights.iter().take(LOWEST).sum::<f32>() / LOWEST as f32
}

/// Says what gathered garments do at last.
fn say_gathered(performance: &Performance, said: &mut String) -> Result<(), Box<dyn Error>> {
    let gathered = performance.measure();
    for garment in &performance.production().garments {
        let crossings = performance.self_crossings(garment);
        write!(
            said,
            "\n    {:10} {} particles, crossings {} at the end",
            garment.name,
            garment.particles.len(),
            crossings.ok_or("the cloth is nowhere")?,
        )?;
    }
    write!(
        said,
        "\n    all at the end: p99 strain {:.1} %, showing {}",
        100.0 * gathered.strain.p99,
        gathered.skin.showing_body_vertices,
    )?;
    Ok(())
}

/// Worst of a garment, and what it was at last.
#[derive(Debug, Clone, Default)]
struct Seen {
    strain: [f32; 2],
    deepest: f32,
    /// How high its hem was over the hips at first, and how far it came up from there [m].
    hung: Option<f32>,
    risen: f32,
    showing: u32,
    /// Vertices of skin outside as it is drawn, where it gives way.
    drawn: u32,
    /// Where skin lay outside in the worst frame [m], and when that was [s].
    shown_at: Vec<Vec3>,
    shown_in: f32,
    /// Pictures of that.
    close: Vec<Vec<u8>>,
    crossings: [usize; 2],
    /// What lies over what at first, and the most places at which that was the other way around.
    layers: Option<Layers>,
    inversions: usize,
}

/// Vertices of the body outside a garment as both are drawn.
fn drawn_outside(performance: &Performance, place: usize) -> u32 {
    let moment = Moment::of(performance);
    let production = performance.production();
    let body = CheckedSurface {
        positions: &moment.body[0],
        normals: &moment.body[1],
        triangles: &production.drawn_triangles,
    };
    let cloth = CheckedSurface {
        positions: &moment.worn[production.garments.len() + place][0],
        normals: &moment.worn[production.garments.len() + place][1],
        triangles: &production.dressed[place].dressed.open_triangles,
    };
    check(body, cloth).showing_body_vertices
}

/// Where skin lay outside the cloth in the worst frame, by decimeters.
fn say_showing(seen: &Seen, said: &mut String) -> std::fmt::Result {
    let mut left = seen.shown_at.clone();
    while let Some(&place) = left.first() {
        let before = left.len();
        left.retain(|other| 0.05 < other.distance(place));
        write!(
            said,
            "\n        {} vertices of skin outside at {place:.2} after {:.2} s",
            before - left.len(),
            seen.shown_in
        )?;
    }
    Ok(())
}

/// Where the garment goes through itself at last: which pieces, in the seam or beside it, held or not.
fn say_crossings(performance: &Performance, place: usize, said: &mut String) -> std::fmt::Result {
    let garment = &performance.production().dressed[place].dressed;
    let positions = performance.dressed_positions(place);
    let pairs = garment.crossing_pairs(positions).unwrap_or_default();
    let in_seams = garment.in_seams();
    let side = |corners: &[u32]| {
        let (panel, piece) = garment.piece_of(corners[0]);
        let count = |holds: &dyn Fn(u32) -> bool| corners.iter().filter(|it| holds(**it)).count();
        let [sewn, held] = [
            count(&|it| in_seams[it as usize]),
            count(&|it| garment.is_pinned(it)),
        ];
        let of = corners.len();
        format!("{piece} {panel} ({sewn} of {of} in a seam, {held} held)")
    };
    let mut told: Vec<(String, Vec<Vec3>)> = Vec::new();
    for pair in &pairs {
        let what = format!("{} through {}", side(&pair.ends), side(&pair.corners));
        match told.iter_mut().find(|(other, _)| *other == what) {
            Some((_, places)) => places.push(pair.place),
            None => told.push((what, vec![pair.place])),
        }
    }
    for (what, places) in told {
        let count = places.len();
        write!(
            said,
            "\n        {count} crossings at {:.2}: {what}",
            places[0]
        )?;
    }
    Ok(())
}

/// The places of the cloth that are stretched most, by decimeters of the flat pieces.
fn say_where(
    performance: &Performance,
    place: usize,
    said: &mut String,
) -> Result<Vec<Vec3>, std::fmt::Error> {
    let garment = &performance.production().dressed[place].dressed;
    let positions = performance.dressed_positions(place);
    let stretches = garment.stretches(positions);
    let mut worst: Vec<(f32, usize, Vec3, f32)> = (stretches.iter().zip(&garment.triangles))
        .map(|([warp, weft], corners)| {
            let middle = corners.map(|corner| positions[corner as usize]);
            let middle = middle.iter().sum::<Vec3>() / 3.0;
            let [a, b, c] = corners.map(|corner| garment.on_cloth[corner as usize]);
            let sides = [a.distance(b), b.distance(c), c.distance(a)];
            let longest = sides.into_iter().fold(0.0, f32::max);
            let height = (b - a).perp_dot(c - a).abs() / longest;
            (warp.max(*weft), usize::from(warp < weft), middle, height)
        })
        .collect();
    worst.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut told: Vec<Vec3> = Vec::new();
    for (stretch, along, middle, height) in worst {
        if told.iter().all(|other| 0.06 < other.distance(middle)) {
            let yarn = ["warp", "weft"][along];
            write!(
                said,
                "\n        {:5.1} % along the {yarn} at {middle:.2}, a triangle {:.1} mm high",
                100.0 * stretch,
                1000.0 * height
            )?;
            told.push(middle);
        }
        if 12 <= told.len() {
            break;
        }
    }
    told.truncate(1);
    Ok(told)
}

/// A dancer from all sides.
fn shoot(
    asked: &Asked,
    performance: &Performance,
    about: Option<&[Vec3]>,
) -> Result<Vec<Vec<u8>>, Box<dyn Error>> {
    let production = performance.production();
    let looks = Looks::new(&production.design, production)?;
    let moment = Moment::of(performance);
    let shown = moment.dancer();
    let count = production.garments.len();
    let dressed = &moment.worn[count..count + production.dressed.len()];
    let points: Vec<Vec3> = if let Some(about) = about {
        let ends = |&place: &Vec3| [place - Vec3::splat(0.1), place + Vec3::splat(0.1)];
        about.iter().flat_map(ends).collect()
    } else if asked.is_close {
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
    let mut cells = Vec::new();
    for view in VIEWS {
        let camera = Camera::framing_points(&points, view, CELL.aspect());
        let scene = looks.scene(&shown, camera, Lamps::WithCamera);
        cells.push(renderer.render(&scene)?.pixels);
    }
    Ok(cells)
}

/// Pictures side by side.
fn beside(cells: &[Vec<u8>]) -> Vec<u8> {
    let width = CELL.width as usize * 4;
    let lines = (0..CELL.height as usize).flat_map(|line| {
        let parts = cells.iter().map(move |cell| &cell[line * width..][..width]);
        parts.collect::<Vec<_>>().concat()
    });
    lines.collect()
}

fn write_sheet(file: &std::path::Path, rows: &[Vec<u8>]) -> Result<(), Box<dyn Error>> {
    if rows.is_empty() {
        return Ok(());
    }
    let height = CELL.height * u32::try_from(rows.len())?;
    let width = u32::try_from(rows[0].len())? / (4 * CELL.height);
    let out = std::io::BufWriter::new(std::fs::File::create(file)?);
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&rows.concat())?;
    Ok(())
}
