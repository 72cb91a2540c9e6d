//! Seconds in which the film's skirt comes to rest from where it is sewn: `cargo run --release
//! --example settle_speed -p lole_stage`.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a measurement reads the clock and prints"
)]

use std::time::Instant;

use lole_costume::document::Design;
use lole_stage::{Performance, Production};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut performance = Performance::new(Production::new(&Design::default())?)?;
    let start = Instant::now();
    let mut frame_count = 0;
    while performance.time() < 0.0 {
        performance.advance().map_err(|stop| format!("{stop:?}"))?;
        frame_count += 1;
    }
    let seconds = start.elapsed().as_secs_f64();
    let particle_count = performance.cloth_positions().len();
    println!("{particle_count} particles: {frame_count} frames in {seconds:.2} s");
    Ok(())
}
