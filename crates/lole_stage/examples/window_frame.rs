//! What a frame of the window costs, and how much cloth has gone through itself, when that is left,
//! repaired in every frame, in every fourth, and only while the skirt settles: `cargo run --release
//! --example window_frame -p lole_stage -- [THREADS] [DOCUMENT]`.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a measurement reads the clock and prints"
)]

use std::sync::Arc;
use std::time::Instant;

use lole_cloth::{Crossings, diagnose};
use lole_costume::document::{self, Design};
use lole_stage::{Production, Show};

/// Frames danced: five seconds.
const FRAMES: u32 = 300;
/// Crossings are counted in every so manyth frame.
const LOOKS: u32 = 20;

/// A way of repairing, danced beside the others so that a busy machine is as busy for all.
struct Way {
    name: &'static str,
    settling: Crossings,
    /// Frames from one repair to the next; 0 for never.
    interval: u32,
    costs: Vec<f64>,
    crossings: Vec<usize>,
}

impl Way {
    const fn in_frame(&self, frame: u32) -> Crossings {
        if 0 < self.interval && frame.is_multiple_of(self.interval) {
            Crossings::Repair
        } else {
            Crossings::Leave
        }
    }
}

const fn way(name: &'static str, settling: Crossings, interval: u32) -> Way {
    Way {
        name,
        settling,
        interval,
        costs: Vec::new(),
        crossings: Vec::new(),
    }
}

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
    let mut ways = Vec::new();
    for way in [
        way("left", Crossings::Leave, 0),
        way("repaired in every frame", Crossings::Repair, 1),
        way("repaired in every fourth frame", Crossings::Repair, 4),
        way("repaired while settling", Crossings::Repair, 0),
    ] {
        let mut show = Show::of(Arc::clone(&production))?;
        show.set_crossings(way.settling);
        pool.install(|| show.settle())
            .map_err(|stop| format!("{stop:?}"))?;
        ways.push((way, show));
    }
    for frame in 0..FRAMES {
        for (way, show) in &mut ways {
            show.set_crossings(way.in_frame(frame));
            let start = Instant::now();
            pool.install(|| show.advance())
                .map_err(|stop| format!("{stop:?}"))?;
            way.costs.push(1e3 * start.elapsed().as_secs_f64());
            if frame % LOOKS == LOOKS / 2 {
                way.crossings.push(crossing_count(show));
            }
        }
    }
    for (way, _) in &mut ways {
        way.costs.sort_by(f64::total_cmp);
        let at = |share: usize| way.costs[way.costs.len() * share / 100];
        let most = way.crossings.iter().max().copied().unwrap_or(0);
        let mean = way.crossings.iter().sum::<usize>() / way.crossings.len().max(1);
        println!(
            "{}: {:.1} ms at 10 %, {:.1} ms median, {:.1} ms at 90 %; {mean} crossings on the mean, {most} at most",
            way.name,
            at(10),
            at(50),
            at(90)
        );
    }
    Ok(())
}

fn crossing_count(show: &Show) -> usize {
    let production = show.production();
    let found = production.garments.iter().filter_map(|garment| {
        let own = &show.cloth_positions()[garment.particles.clone()];
        diagnose::self_crossings(&garment.sewn.spec.grid, own)
    });
    found.sum()
}
