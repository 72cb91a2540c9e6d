//! Bodies and dances that nobody designed for: whether cloth stays whole, uncrossed and quick on them.
//!
//! `cargo run --release -p lole_picture --example strangers -- [--first SEED] [--count N] [--seconds S]
//! [--design FILE] [--own] [--repertoire [--dancer NAME]] [--trace] [--pictures FOLDER]` prints a line for each
//! stranger: what a frame costs, how the cloth is strained, how often it crosses itself, and what is odd about her.
//! With `--own` dancer and dance are the design's, with `--repertoire` six built dancers dance every step at
//! its slowest and at its fastest. With `--trace` every frame has a line, with `--pictures` she is drawn four
//! times in her dance. Times are the processor's; nobody is given more than a minute and a half of it.

#![expect(
    clippy::print_stdout,
    reason = "a tool prints figures, times among them"
)]

use std::error::Error;
use std::path::PathBuf;
use std::time::Duration;

use cpu_time::ProcessTime;
use glam::Vec3;
use lole_body::Bone;
use lole_costume::document::{self, Design};
use lole_hula::DanceStep;
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{Backend, Camera, Renderer, Size, View};

use lole_stage::{Garment, Performance, Production, Stranger, six_dancers};

/// Size of one picture [pixel].
const CELL: Size = Size::new(420, 640);

/// Frames from one look at skin, and at crossings, to the next.
const SKIN_INTERVAL: usize = 6;
const CROSSINGS_INTERVAL: usize = 3;

/// Time of the processor that a stranger gets at most.
const PATIENCE: Duration = Duration::from_secs(90);

/// Strain of whole cloth, at the 99th percentile, and times of the median that a frame may take.
const WHOLE: f32 = 0.1;
const BUDGET: f64 = 4.0;

struct Asked {
    first: u64,
    count: u64,
    seconds: f32,
    design: Design,
    is_own: bool,
    is_repertoire: bool,
    dancer: Option<String>,
    traces: bool,
    pictures: Option<PathBuf>,
}

fn asked() -> Result<Asked, Box<dyn Error>> {
    let mut asked = Asked {
        first: 1,
        count: 200,
        seconds: 5.0,
        design: Design::default(),
        is_own: false,
        is_repertoire: false,
        dancer: None,
        traces: false,
        pictures: None,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument}: what?"));
        match argument.as_str() {
            "--first" => asked.first = value()?.parse()?,
            "--count" => asked.count = value()?.parse()?,
            "--seconds" => asked.seconds = value()?.parse()?,
            "--design" => {
                let name = value()?;
                asked.design = document::parse(&std::fs::read_to_string(&name)?, &name)?;
                let (avatar, dance) =
                    (&mut asked.design.dancer.file, &mut asked.design.motion.file);
                for file in [avatar, dance].into_iter().flatten() {
                    let path = std::path::Path::new(&name).with_file_name(&file.name);
                    file.bytes = Some(std::fs::read(path)?.into());
                }
            }
            "--own" => asked.is_own = true,
            "--dancer" => asked.dancer = Some(value()?),
            "--repertoire" => asked.is_repertoire = true,
            "--trace" => asked.traces = true,
            "--pictures" => asked.pictures = Some(PathBuf::from(value()?)),
            _ => return Err(format!("{argument}: there is no such option").into()),
        }
    }
    Ok(asked)
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    if let Some(folder) = &asked.pictures {
        std::fs::create_dir_all(folder)?;
    }
    if asked.is_own {
        println!("{}", dance(Production::new(&asked.design)?, &asked, 0)?);
        return Ok(());
    }
    if asked.is_repertoire {
        return repertoire(&asked);
    }
    for seed in asked.first..asked.first + asked.count {
        match Stranger::draw(seed, &asked.design) {
            Ok(stranger) => {
                let (body, danced) = (stranger.body, stranger.dance);
                let said = dance(stranger.production, &asked, seed)?;
                println!("{seed:4} {said}  {body} | {danced}");
            }
            Err(error) => println!("{seed:4} cannot be dressed: {error}"),
        }
    }
    Ok(())
}

/// Six built dancers in every step at its slowest and at its fastest.
fn repertoire(asked: &Asked) -> Result<(), Box<dyn Error>> {
    let wanted = |name: &str| asked.dancer.as_ref().is_none_or(|dancer| dancer == name);
    for (name, dancer) in six_dancers().into_iter().filter(|(name, _)| wanted(name)) {
        for step in DanceStep::ALL {
            for tempo in step.tempo() {
                let mut design = asked.design.clone();
                design.dancer = dancer.clone();
                design.motion.step = step;
                design.motion.tempo_bpm = f64::from(tempo);
                let said = dance(Production::new(&design)?, asked, 0)?;
                println!("{name:5} {said}  {} at {tempo}", step.id());
            }
        }
    }
    Ok(())
}

/// Dances, and says how it went.
fn dance(production: Production, asked: &Asked, seed: u64) -> Result<String, Box<dyn Error>> {
    let mut performance = Performance::new(production)?;
    let mut seen = Seen {
        traces: asked.traces,
        before: performance.cloth_positions().to_vec(),
        ..Seen::default()
    };
    let mut pictures = Vec::new();
    let began = ProcessTime::now();
    while performance.time() < asked.seconds {
        let start = ProcessTime::now();
        if let Err(found) = performance.advance() {
            return Ok(format!("FLEW AWAY: {found:?}"));
        }
        let spent = start.elapsed().as_secs_f64() * 1000.0;
        seen.frame(&performance, spent);
        if PATIENCE < began.elapsed() {
            seen.gave_up = Some(performance.time());
            break;
        }
        let due = asked.seconds * pictures.len() as f32 / 3.0;
        if asked.pictures.is_some() && due <= performance.time() + 0.02 && pictures.len() < 4 {
            pictures.push(shoot(&mut performance)?);
        }
    }
    if let Some(folder) = asked.pictures.as_ref().filter(|_| !pictures.is_empty()) {
        write_sheet(&folder.join(format!("{seed}.png")), &pictures)?;
    }
    Ok(seen.said())
}

/// The worst that was seen of a dance.
#[derive(Default)]
struct Seen {
    /// Whether every frame has a line.
    traces: bool,
    /// What each frame took [ms].
    times: Vec<f64>,
    settling: f64,
    p99: f32,
    /// Looks at the strain, and those at which it was beyond [`WHOLE`].
    looks: [usize; 2],
    max: f32,
    depth: f32,
    showing: u32,
    crossings: usize,
    /// When waiting ended before the dance did [s].
    gave_up: Option<f32>,
    /// Where the cloth was a frame ago [m].
    before: Vec<Vec3>,
}

impl Seen {
    fn frame(&mut self, performance: &Performance, spent: f64) {
        let (traces, is_settling) = (self.traces, performance.time() <= 0.0);
        if is_settling {
            self.settling = self.settling.max(spent);
        } else {
            self.times.push(spent);
        }
        let is_due = |interval: usize| traces || self.times.len() % interval == interval - 1;
        let production = performance.production();
        let mut crossings = 0;
        if is_due(CROSSINGS_INTERVAL) {
            crossings = (production.garments.iter())
                .map(|garment| performance.self_crossings(garment).unwrap_or(usize::MAX))
                .fold(0, usize::saturating_add);
        }
        let is_looked_at = is_due(SKIN_INTERVAL);
        if !is_settling {
            self.crossings = self.crossings.max(crossings);
        }
        if !is_looked_at {
            return;
        }
        let mut posed = performance.clone();
        posed.pose_body();
        let metrics = posed.measure();
        if !is_settling {
            self.p99 = self.p99.max(metrics.strain.p99);
            self.looks[0] += 1;
            self.looks[1] += usize::from(WHOLE < metrics.strain.p99);
            self.max = self.max.max(metrics.strain.max);
            self.depth = self.depth.max(metrics.skin.worst_depth);
            self.showing = self.showing.max(metrics.skin.showing_body_vertices);
        }
        if traces {
            println!(
                "{:7.3} s {spent:8.1} ms  p99 {:6.2} %  max {:7.1} %  {crossings:6} crossings  {:5.1} mm in skin, {} showing",
                performance.time(),
                100.0 * metrics.strain.p99,
                100.0 * metrics.strain.max,
                1000.0 * metrics.skin.worst_depth,
                metrics.skin.showing_body_vertices,
            );
            self.moved(&posed);
            strained(&posed);
            sunk(&posed);
        }
    }

    /// How far cloth and what holds it came in this frame.
    fn moved(&mut self, performance: &Performance) {
        let now = performance.cloth_positions();
        let far = |particle: usize| match self.before.get(particle) {
            Some(before) => 1000.0 * before.distance(now[particle]),
            None => 0.0,
        };
        for garment in &performance.production().garments {
            let columns = garment.sewn.spec.grid.column_count as usize;
            let rows = garment.particles.clone().step_by(columns);
            let farthest: Vec<String> = rows
                .map(|row| (row..row + columns).map(far).fold(0.0, f32::max))
                .map(|far| format!("{far:.0}"))
                .collect();
            println!("    moved by rows, farthest [mm]: {}", farthest.join(" "));
        }
        self.before.clear();
        self.before.extend_from_slice(now);
    }

    fn said(mut self) -> String {
        let worst = self.times.iter().copied().fold(0.0, f64::max);
        self.times.sort_by(f64::total_cmp);
        let median = self.times.get(self.times.len() / 2).copied().unwrap_or(0.0);
        let late = (self.times.iter())
            .filter(|&&time| BUDGET * median < time)
            .count();
        let [looks, torn] = self.looks;
        let gave_up =
            (self.gave_up).map_or_else(String::new, |at| format!("GAVE UP at {at:.1} s: "));
        format!(
            "{gave_up}{median:6.1} ms, {:4.1} x at worst, {late:3} late (settling {:6.1}), p99 {:6.1} %, {torn:2} of {looks:2} torn, max {:6.0} %, {:4} crossings, {:5.1} mm in skin, {:4} showing",
            worst / median.max(1.0e-9),
            self.settling,
            100.0 * self.p99,
            100.0 * self.max,
            self.crossings,
            1000.0 * self.depth,
            self.showing,
        )
    }
}

/// Where cloth is deepest in the skin: rows, columns and the bones beside it.
fn sunk(performance: &Performance) {
    let production = performance.production();
    for garment in &production.garments {
        let positions = performance.garment_positions(garment);
        let depths = performance.depths_below_skin(positions);
        let mut most: Vec<usize> = (0..depths.len()).collect();
        most.sort_by(|&a, &b| depths[b].total_cmp(&depths[a]));
        for &particle in most.iter().take(3).filter(|&&it| 0.001 < depths[it]) {
            println!(
                "    {:5.1} mm deep {}",
                1000.0 * depths[particle],
                beside(performance, garment, particle)
            );
        }
    }
}

/// A particle of a garment in words: its row and column, where it is, and the bone beside it.
fn beside(performance: &Performance, garment: &Garment, particle: usize) -> String {
    let place = performance.garment_positions(garment)[particle];
    let columns = garment.sewn.spec.grid.column_count as usize;
    let vertices = performance.body_positions().iter().enumerate();
    let nearest = vertices.min_by(|a, b| a.1.distance(place).total_cmp(&b.1.distance(place)));
    let bone = nearest.map_or("nobody", |(vertex, _)| {
        let joints = performance.production().dancer.skin.joints[vertex];
        Bone::ALL[usize::from(joints[0])].name()
    });
    let far = nearest.map_or(f32::INFINITY, |(_, at)| at.distance(place));
    let (row, column) = (particle / columns, particle % columns);
    format!(
        "row {row} column {column} at {place:.3}, {:.1} mm from {bone}",
        1000.0 * far
    )
}

/// Where cloth is stretched most: rows, columns and the bones beside it.
fn strained(performance: &Performance) {
    let production = performance.production();
    for garment in &production.garments {
        let strains = performance.strain_by_particle(garment);
        let mut most: Vec<usize> = (0..strains.len()).collect();
        most.sort_by(|&a, &b| strains[b].total_cmp(&strains[a]));
        for &particle in most.iter().step_by(40).take(4) {
            println!(
                "    {:5.0} % {}",
                100.0 * strains[particle],
                beside(performance, garment, particle)
            );
        }
    }
}

/// She from the front and from the side.
fn shoot(performance: &mut Performance) -> Result<Vec<u8>, Box<dyn Error>> {
    performance.pose_body();
    let production = performance.production();
    let looks = Looks::new(&production.design, production)?;
    let moment = Moment::of(performance);
    let points: Vec<_> = performance
        .body_positions()
        .iter()
        .chain(performance.cloth_positions())
        .copied()
        .collect();
    let mut renderer = Renderer::new(Backend::Cpu, CELL)?;
    let mut pixels = Vec::new();
    for view in [View::Front, View::Side] {
        let camera = Camera::framing_points(&points, view, CELL.aspect());
        let scene = looks.scene(&moment.dancer(), camera, Lamps::WithCamera);
        pixels.extend(renderer.render(&scene)?.pixels);
    }
    Ok(pixels)
}

/// Pictures side by side.
fn write_sheet(file: &std::path::Path, pictures: &[Vec<u8>]) -> Result<(), Box<dyn Error>> {
    let line = CELL.width as usize * 4;
    let lines = (0..2 * CELL.height as usize).flat_map(|at| {
        let parts = pictures
            .iter()
            .map(move |picture| &picture[at * line..][..line]);
        parts.collect::<Vec<_>>().concat()
    });
    let width = CELL.width * u32::try_from(pictures.len())?;
    let out = std::io::BufWriter::new(std::fs::File::create(file)?);
    let mut encoder = png::Encoder::new(out, width, 2 * CELL.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder
        .write_header()?
        .write_image_data(&lines.collect::<Vec<u8>>())?;
    Ok(())
}
