//! House rules as code: `cargo xtask tidy` checks them, `cargo xtask golden` rewrites goldens,
//! `cargo xtask look` judges the files of a dance, `cargo xtask shape` says how large things are.

#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a command speaks on the terminal"
)]

mod dist;
mod docs;
mod golden;
mod look;
mod looks;
mod shape;
mod tidy;
mod web;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask <command>

  tidy     check the house rules: dependency table, documents, budgets, words
  docs     build the documentation, warnings being errors, and check its links
  golden   rewrite the goldens under tests/golden and list what changed
  shape    lines of functions, files and crates, values that functions take, names had twice
  web      build the studio as a page into one folder, and hold its size against the budget
  dist     build packages for machines without a compiler: archive, Debian package, licenses, bill of materials;
           --twice builds the programs here and in a copy elsewhere, and says whether they are the same
  serve [PORT]  show that page on this machine
  looks [--keep] [NAME ...]  draw twenty situations, and say which look different from the kept sheet
  look DIR look at the files that `lole dance` wrote: all there, and the report complete
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match arguments.as_slice() {
        ["tidy"] => tidy::run(&repository()),
        ["docs"] => docs::run(&repository()),
        ["golden"] => golden::run(&repository()),
        ["shape"] => shape::run(&repository()),
        ["dist"] => dist::run(&repository()),
        ["dist", "--twice"] => dist::twice(&repository()),
        ["web"] => web::run(&repository()),
        ["serve"] => web::serve(&web::folder(&repository()), None),
        ["serve", port] => web::serve(&web::folder(&repository()), Some(port)),
        ["looks", rest @ ..] => looks::run(&repository(), rest),
        ["look", folder] => look::run(Path::new(folder)),
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(code) => code,
        Err(error) => {
            eprintln!("xtask: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Folder of the workspace: the parent of this crate's.
fn repository() -> PathBuf {
    // As Cargo says when it runs: a build folder that several clones share keeps what one of them was.
    let own = std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(PathBuf::new, PathBuf::from);
    own.parent().unwrap_or(&own).to_owned()
}
