//! Prints what the scenes of [`lole_stage::machine`] come to on this machine, to be held against a browser's or
//! another processor's: `cargo run --release -p lole_stage --example scenes -- [NAME ...]`.
#![expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a tool prints figures, times among them"
)]

use std::time::Instant;

use lole_stage::machine;

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let is_asked = |name: &String| asked.is_empty() || asked.contains(name);
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64() * 1e3;
    // One thread, as a worker of a page has.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let print = || {
        for name in machine::names().into_iter().filter(is_asked) {
            match machine::run(&name, &clock) {
                Some(row) => println!("{row}"),
                None => println!("{name:16} cannot be run"),
            }
        }
    };
    match pool {
        Ok(pool) => pool.install(print),
        Err(_) => print(),
    }
}
