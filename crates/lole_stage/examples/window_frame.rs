//! What a frame of the window costs when crossings are left, repaired in every fourth frame, and
//! repaired in all, with how many are left: `cargo run --release --example window_frame -p
//! lole_stage -- [THREADS] [DOCUMENT]`.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a measurement reads the clock and prints"
)]

use std::time::Instant;

use lole_cloth::{Crossings, diagnose};
use lole_costume::document::{self, Design};
use lole_stage::{Production, Show};
use std::sync::Arc;

/// Frames danced: five seconds.
const FRAMES: u32 = 300;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let threads = words.next().map_or(Ok(1), |word| word.parse())?;
    let design = match words.next() {
        Some(path) => document::parse_bytes(&std::fs::read(&path)?, &path)?,
        None => Design::default(),
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()?;
    let production = Arc::new(Production::new(&design)?);
    for interval in [0, 4, 1] {
        let mut show = Show::of(Arc::clone(&production))?;
        pool.install(|| show.settle())
            .map_err(|stop| format!("{stop:?}"))?;
        let mut costs = Vec::new();
        let mut crossings = Vec::new();
        for frame in 0..FRAMES {
            let repairs = 0 < interval && frame % interval == 0;
            show.set_crossings(if repairs {
                Crossings::Repair
            } else {
                Crossings::Leave
            });
            let start = Instant::now();
            pool.install(|| show.advance())
                .map_err(|stop| format!("{stop:?}"))?;
            costs.push(1e3 * start.elapsed().as_secs_f64());
            if frame % 20 == 10 {
                let garments = &production.garments;
                let found = garments.iter().filter_map(|garment| {
                    let own = &show.cloth_positions()[garment.particles.clone()];
                    diagnose::self_crossings(&garment.sewn.spec.grid, own)
                });
                crossings.push(found.sum::<usize>());
            }
        }
        costs.sort_by(f64::total_cmp);
        let at = |share: usize| costs[(costs.len() * share / 100).min(costs.len() - 1)];
        let most = crossings.iter().max().copied().unwrap_or(0);
        let mean = crossings.iter().sum::<usize>() / crossings.len().max(1);
        println!(
            "repaired every {interval} frames: {:.1} ms median, {:.1} ms at 90 %; crossings {mean} on the mean, {most} at most",
            at(50),
            at(90)
        );
    }
    Ok(())
}
