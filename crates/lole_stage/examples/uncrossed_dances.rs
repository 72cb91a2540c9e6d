//! The promise on whole costumes: every frame of every scene whose cloth meets itself, and of every step at
//! its fastest on six dancers, is searched for crossings by exact predicates and a search that share nothing
//! with the engine (`tests/exact_support` of `lole_cloth`).
//!
//! `cargo run --release -p lole_stage --example uncrossed_dances -- [--seconds S] [--threads N] [--scenes]
//! [--repertoire] [--dancer NAME] [--step NAME] [--design FILE]` prints a line for each scene and dance: what
//! crosses at the start, pairs that are new since, by rows and columns, and `BROKEN` with the frames that
//! began without a crossing and ended with one. Frames count from the start of the drape.

#![allow(clippy::print_stdout, reason = "a tool prints")]

#[path = "../../lole_cloth/tests/exact_support/mod.rs"]
mod exact_support;
#[path = "../tests/watch/mod.rs"]
mod watch;

use std::error::Error;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use cpu_time::ThreadTime;
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES};
use lole_cloth::{ClothModel, ClothState, StepInput, step};
use lole_costume::document::{self, Design};
use lole_hula::DanceStep;
use lole_stage::{Performance, Production, double_pau, six_dancers};
use watch::Watch;

/// What is watched.
enum Play {
    Scene(&'static ClothScene),
    Dance(String, Box<Design>),
}

struct Asked {
    seconds: f32,
    threads: usize,
    plays: Vec<Play>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..asked.threads {
            scope.spawn(|| work(&asked, &next));
        }
    });
    Ok(())
}

fn asked() -> Result<Asked, Box<dyn Error>> {
    let (mut seconds, mut threads, mut design) = (3.0, 1, Design::default());
    let (mut wanted, mut dancer, mut name) = (Vec::new(), None, None);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument}: what?"));
        match argument.as_str() {
            "--seconds" => seconds = value()?.parse()?,
            "--threads" => threads = value()?.parse()?,
            "--dancer" => dancer = Some(value()?),
            "--step" => name = Some(value()?),
            "--design" => {
                let file = value()?;
                design = document::parse(&std::fs::read_to_string(&file)?, &file)?;
            }
            "--scenes" | "--repertoire" => wanted.push(argument),
            _ => return Err(format!("{argument}: there is no such option").into()),
        }
    }
    let wants = |what: &str| wanted.is_empty() || wanted.iter().any(|it| it == what);
    let mut plays = Vec::new();
    if wants("--scenes") {
        let meets_itself = |scene: &&ClothScene| (scene.build)().config.self_collision.is_some();
        plays.extend(SCENES.iter().filter(meets_itself).map(Play::Scene));
        plays.push(Play::Dance("pau-fine".into(), Box::default()));
        plays.push(Play::Dance("pau-layers".into(), Box::new(double_pau())));
    }
    if wants("--repertoire") {
        plays.extend(repertoire(&design, (dancer, name)));
    }
    Ok(Asked {
        seconds,
        threads,
        plays,
    })
}

/// Every step at its fastest on six dancers, or those that were named.
fn repertoire(design: &Design, (dancer, name): (Option<String>, Option<String>)) -> Vec<Play> {
    let mut plays = Vec::new();
    for step in DanceStep::ALL {
        for (worn_by, body) in six_dancers() {
            let is_dancer = dancer.as_ref().is_none_or(|it| it == worn_by);
            let is_step = name.as_ref().is_none_or(|it| it == step.id());
            if is_dancer && is_step {
                let tempo = step.tempo()[1];
                let mut design = design.clone();
                design.dancer = body;
                design.motion.step = step;
                design.motion.tempo_bpm = f64::from(tempo);
                let title = format!("{worn_by:5} {} at {tempo}", step.id());
                plays.push(Play::Dance(title, Box::new(design)));
            }
        }
    }
    plays
}

/// Takes one after the other.
fn work(asked: &Asked, next: &AtomicUsize) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("a thread");
    while let Some(play) = asked.plays.get(next.fetch_add(1, Ordering::Relaxed)) {
        pool.install(|| match play {
            Play::Scene(scene) => println!("{}: {}", scene.name, run_scene(scene)),
            Play::Dance(title, design) => match run_dance(design, asked.seconds) {
                Ok(said) => println!("{title}: {said}"),
                Err(error) => println!("{title}: {error}"),
            },
        });
    }
}

/// Every frame of a scene of the engine.
fn run_scene(scene: &ClothScene) -> String {
    let setup = (scene.build)();
    let model = ClothModel::new(&setup.spec).expect("a scene can be built");
    let mut state = ClothState::new(&model, &setup.positions);
    let pin_targets: Vec<_> = (model.pin_indices().iter())
        .map(|&pin| setup.positions[pin as usize])
        .collect();
    let mut watch = Watch::new("cloth", &setup.spec.grid, &setup.positions);
    let (mut positions, mut spent) = (Vec::new(), Duration::ZERO);
    for frame in 1..=scene.frame_count {
        let capsules = (scene.capsules)(f64::from(frame) * f64::from(FRAME_DT));
        let input = StepInput {
            pin_targets: &pin_targets,
            capsules: &capsules,
            ..StepInput::default()
        };
        step(&model, &setup.config, &input, &mut state, FRAME_DT).expect("a target for every pin");
        state.copy_positions(&model, &mut positions);
        let began = ThreadTime::now();
        watch.look(&positions);
        spent += began.elapsed();
    }
    format!(
        "{watch} [{} a look]",
        milliseconds(spent, scene.frame_count)
    )
}

/// Every frame of a dance, from the start of the drape on.
fn run_dance(design: &Design, seconds: f32) -> Result<String, Box<dyn Error>> {
    let mut performance = Performance::new(Production::new(design)?)?;
    let mut watches = Watch::all(&performance);
    let (mut spent, mut frames) = (Duration::ZERO, 0);
    while performance.time() < seconds {
        if let Err(found) = performance.advance() {
            return Ok(format!("FLEW AWAY: {found:?}"));
        }
        let began = ThreadTime::now();
        Watch::look_at_all(&mut watches, &performance);
        spent += began.elapsed();
        frames += 1;
    }
    let said: Vec<String> = watches.iter().map(ToString::to_string).collect();
    let cost = milliseconds(spent, frames);
    Ok(format!("{} [{cost} a look]", said.join(" | ")))
}

/// What each of some took of the processor's time, in words.
fn milliseconds(spent: Duration, count: u32) -> String {
    let cost = spent.as_secs_f64() * 1000.0 / f64::from(count.max(1));
    format!("{cost:.0} ms")
}
