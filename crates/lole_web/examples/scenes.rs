//! Prints what the engine's scenes come to on this machine, to be held against a browser's.
#![allow(clippy::print_stdout, reason = "an example speaks on the terminal")]

use lole_web::scene;

fn main() {
    // One thread, as a worker of a page has.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let print = || {
        let rows = scene::names()
            .into_iter()
            .filter_map(|name| scene::run(&name));
        rows.for_each(|row| println!("{row}"));
    };
    match pool {
        Ok(pool) => pool.install(print),
        Err(_) => print(),
    }
}
