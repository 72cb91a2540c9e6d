//! A hundred thousand frames of random scenes, each held against the promise that cloth which does not cross
//! never comes to cross: `cargo run --release -p lole_cloth --example uncrossed_scenes -- [--first SEED]
//! [--frames N] [--threads N]`.
//!
//! Every frame is judged by exact predicates and a search that share nothing with the engine
//! (`tests/exact_support`). A scene with a crossing is told with its seed, its frame and the pairs.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a tool reads the clock and prints"
)]

#[path = "../tests/exact_support/mod.rs"]
mod exact_support;
#[path = "../tests/mesh_support/mod.rs"]
mod mesh_support;
#[path = "../tests/random_scenes/mod.rs"]
mod random_scenes;
#[path = "../tests/skin_support/mod.rs"]
mod skin_support;
#[path = "../tests/xpbd_support/mod.rs"]
mod xpbd_support;

use std::error::Error;
use std::time::Instant;

use random_scenes::{FRAME_COUNT, RandomScene, judge};
use rayon::prelude::*;

/// Scenes from one line of progress to the next.
const BATCH: u64 = 50;

/// What was seen so far.
#[derive(Default)]
struct Sum {
    frames: u64,
    scenes: u64,
    starts_crossed: u64,
    crossed: u64,
    touching: usize,
    held: u64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let (mut first, mut frames, mut threads) = (0_u64, 100_000_u64, 1_usize);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let value = arguments.next().ok_or(format!("{argument}: what?"))?;
        match argument.as_str() {
            "--first" => first = value.parse()?,
            "--frames" => frames = value.parse()?,
            "--threads" => threads = value.parse()?,
            _ => return Err(format!("{argument}: there is no such option").into()),
        }
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()?;
    let began = Instant::now();
    let (mut seed, mut sum) = (first, Sum::default());
    while sum.frames < frames {
        let seeds = seed..seed + BATCH;
        let verdicts: Vec<_> = pool.install(|| {
            let each = seeds.clone().into_par_iter();
            each.map(|seed| judge(seed, FRAME_COUNT)).collect()
        });
        for (seed, verdict) in seeds.zip(verdicts) {
            sum.scenes += 1;
            sum.frames += u64::from(verdict.frame_count);
            sum.touching += verdict.touching_count;
            sum.held += u64::from(verdict.held_count);
            sum.starts_crossed += u64::from(verdict.starts_crossed);
            if FRAME_COUNT < 10 * verdict.held_count {
                let about = RandomScene::draw(seed).about;
                println!(
                    "seed {seed}, {} steps not taken: {about}",
                    verdict.held_count
                );
            }
            if verdict.starts_crossed {
                println!(
                    "seed {seed} starts crossed: {}",
                    RandomScene::draw(seed).about
                );
            }
            if let Some((frame, pairs)) = verdict.crossed {
                sum.crossed += 1;
                let about = RandomScene::draw(seed).about;
                println!(
                    "seed {seed}, frame {frame}: {} crossings in {about}",
                    pairs.len()
                );
                for (edge, corners) in pairs.iter().take(8) {
                    println!("    edge {edge:?} through triangle {corners:?}");
                }
            }
        }
        seed += BATCH;
        println!(
            "{:7} frames, {:5} scenes: {} crossed, {} started crossed, {} touched, {} steps not taken, {:.0} s",
            sum.frames,
            sum.scenes,
            sum.crossed,
            sum.starts_crossed,
            sum.touching,
            sum.held,
            began.elapsed().as_secs_f64()
        );
    }
    Ok(())
}
