//! Legal designs at random: bodies over the whole range of every measure, garments with options over the whole
//! range of each, and now and then any other key of the document over the whole of its own. Every one dances for a
//! while, or is refused in a sentence that names what excludes what.
//!
//! `cargo run --release -p lole_stage --example random_designs -- [--first N] [--count N] [--seconds S]
//! [--print]` prints a line for each: how it ended, its worst frame and how long all took; then the sentences of
//! refusal, each once. `--print` prints the designs too. The exit code is 1 where one has panicked or has come
//! apart.

#![expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a tool prints figures, times among them"
)]

use std::collections::BTreeMap;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::Instant;

use lole_costume::document::schema::{Key, Kind, TABLES, Table};
use lole_costume::document::{self, MethodName};
use lole_garment::TEMPLATES;
use lole_garment::template::{OptionKind, OptionRow};
use lole_geom::chance::Chance;
use lole_geom::trig64;
use lole_stage::{Performance, Production};

/// Range of the stature [cm], and key and range of every other measure as a share of it: wider than people, and
/// now and then refused.
const STATURE: [f64; 2] = [100.0, 195.0];
const MEASURES: [(&str, [f64; 2]); 5] = [
    ("bust_cm", [0.4, 0.85]),
    ("waist_cm", [0.32, 0.75]),
    ("hip_cm", [0.45, 0.85]),
    ("inseam_cm", [0.4, 0.5]),
    ("shoulder_breadth_cm", [0.19, 0.28]),
];
const FIGURES: [&str; 3] = ["woman", "man", "child"];
/// Garments of a design, at most.
const MOST_GARMENTS: u32 = 3;

/// Share of the other keys that a design says.
const KEYS_SAID: f32 = 0.08;

/// Rows, columns and substeps are no more than these: finer cloth takes longer, and is as legal.
const MOST_OF_A_COUNT: u64 = 256;

/// Columns and rows that are danced by the paper's methods, at most: their steps are no real time, and would take
/// many minutes on a fine skirt.
const SLOW_GRID: [u32; 2] = [64, 24];

/// How a design ended.
enum End {
    Danced { worst_ms: f64 },
    Refused(String),
    CameApart(String),
    Panicked,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut asked = BTreeMap::from([("--first", 1_u32), ("--count", 50), ("--seconds", 1)]);
    let mut prints = false;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--print" {
            prints = true;
            continue;
        }
        let value = asked.get_mut(argument.as_str()).ok_or("no such option")?;
        *value = arguments.next().ok_or("a number is missing")?.parse()?;
    }
    let [first, count] = ["--first", "--count"].map(|key| asked[key]);
    let seconds_asked = f64::from(asked["--seconds"]);
    let mut said: BTreeMap<String, u32> = BTreeMap::new();
    let mut is_broken = false;
    for seed in first..first + count {
        let text = design(u64::from(seed));
        if prints {
            println!("# {seed}\n{text}");
        }
        let start = Instant::now();
        let end = catch_unwind(AssertUnwindSafe(|| danced(&text, seconds_asked)));
        let seconds = start.elapsed().as_secs_f64();
        let how = match end.unwrap_or(End::Panicked) {
            End::Danced { worst_ms } => format!("danced, {worst_ms:.0} ms at worst"),
            End::Refused(why) => {
                let line = format!("refused: {why}");
                *said.entry(why).or_default() += 1;
                line
            }
            End::CameApart(why) => {
                is_broken = true;
                format!("CAME APART: {why}")
            }
            End::Panicked => {
                is_broken = true;
                "PANICKED".to_owned()
            }
        };
        println!("{seed:>5} {seconds:>7.1} s  {how}");
    }
    for (why, count) in said {
        println!("{count:>5} x {why}");
    }
    Ok(ExitCode::from(u8::from(is_broken)))
}

/// Dances a design for some seconds.
fn danced(text: &str, seconds: f64) -> End {
    let mut design = match document::parse(text, "random.lole") {
        Ok(design) => design,
        Err(error) => return End::Refused(error.to_string()),
    };
    if design.method.name != MethodName::Xpbd {
        let grid = [&mut design.skirt.column_count, &mut design.skirt.row_count];
        for (count, most) in grid.into_iter().zip(SLOW_GRID) {
            *count = (*count).min(most);
        }
    }
    let production = match Production::new(&design) {
        Ok(production) => production,
        Err(error) => return End::Refused(error.to_string()),
    };
    let mut performance = match Performance::new(production) {
        Ok(performance) => performance,
        Err(error) => return End::Refused(error.to_string()),
    };
    let mut worst_ms = 0.0_f64;
    while f64::from(performance.time()) < seconds {
        let start = Instant::now();
        if let Err(error) = performance.advance() {
            let why = format!("{error:?}");
            // The paper's methods come apart where their steps are too large for a fabric, and say so.
            return match design.method.name {
                MethodName::Xpbd => End::CameApart(why),
                _ => End::Refused(format!("{} came apart", design.method.name.id())),
            };
        }
        worst_ms = worst_ms.max(1000.0 * start.elapsed().as_secs_f64());
    }
    let is_finite = performance
        .cloth_positions()
        .iter()
        .all(|place| place.is_finite());
    if is_finite {
        End::Danced { worst_ms }
    } else {
        End::CameApart("a position is no number".to_owned())
    }
}

/// A design as a document.
fn design(seed: u64) -> String {
    let mut chance = Chance::new(seed);
    let mut lines = vec!["lole = 1".to_owned(), "[dancer]".to_owned()];
    let figure = chance.choose(&FIGURES).unwrap_or(&"woman");
    lines.push(format!("figure = \"{figure}\""));
    let stature = between(&mut chance, STATURE);
    lines.push(format!("stature_cm = {stature:.1}"));
    for (key, range) in MEASURES {
        if chance.falls(0.5) {
            let share = between(&mut chance, range);
            lines.push(format!("{key} = {:.1}", share * stature));
        }
    }
    for table in TABLES {
        lines.extend(some_keys(&mut chance, table));
    }
    for number in 0..MOST_GARMENTS {
        let Some(template) = chance.choose(TEMPLATES) else {
            continue;
        };
        if 0 < number && chance.falls(0.4) {
            continue;
        }
        lines.push(format!("[[garment]]\nkind = \"{}\"", template.id));
        for row in template.options {
            if chance.falls(0.4) {
                lines.push(format!("{} = {}", row.key, value(&mut chance, row)));
            }
        }
    }
    lines.join("\n")
}

/// A table with some of its keys; a body's are its measures, which go by its stature.
fn some_keys(chance: &mut Chance, table: &Table) -> Vec<String> {
    let mut lines = Vec::new();
    if table.name == "dancer" {
        return lines;
    }
    lines.push(format!("[{}]", table.name));
    if table.name == "skirt" {
        let worn = if chance.falls(0.5) { "yes" } else { "no" };
        lines.push(format!("worn = \"{worn}\""));
    }
    // There is no photo of which they could say something.
    let alone = |key: &&Key| {
        key.name != "worn" && !key.name.starts_with("known_") && !key.name.starts_with("crop_")
    };
    for key in table.keys.iter().filter(alone) {
        if !chance.falls(KEYS_SAID) {
            continue;
        }
        let said = match &key.kind {
            Kind::Number { min, max, .. } => format!("{:.4}", between(chance, [*min, *max])),
            Kind::Count { min, max, .. } => {
                let most = if key.name.ends_with("seed") {
                    // Beyond this no float is every whole number.
                    (*max).min(1 << f64::MANTISSA_DIGITS)
                } else {
                    MOST_OF_A_COUNT.min(*max)
                };
                format!("{:.0}", between(chance, [*min as f64, most as f64]).floor())
            }
            Kind::Name { choices, .. } => {
                let choices = choices();
                format!("\"{}\"", chance.choose(&choices).unwrap_or(&""))
            }
            // Files are looked for, and colors change no cloth.
            Kind::Text { .. } | Kind::Color { .. } => continue,
        };
        lines.push(format!("{} = {said}", key.name));
    }
    lines
}

/// A value of an option, now and then one of its ends.
fn value(chance: &mut Chance, row: &OptionRow) -> String {
    match &row.kind {
        OptionKind::Number { min, max, .. } => format!("{:.2}", between(chance, [*min, *max])),
        OptionKind::Count { min, max, .. } => {
            format!(
                "{:.0}",
                between(chance, [f64::from(*min), f64::from(*max)]).round()
            )
        }
        OptionKind::Choice(choices) => {
            let choice = chance.choose(choices).map_or("", |choice| choice.id);
            format!("\"{choice}\"")
        }
    }
}

/// A number of a range, now and then one of its ends; where it goes over powers of ten, each as often.
fn between(chance: &mut Chance, [low, high]: [f64; 2]) -> f64 {
    match chance.finest_share() {
        share if share < 0.1 => low,
        share if 0.9 < share => high,
        _ if 0.0 < low && 30.0 * low < high => {
            low * trig64::powf(high / low, chance.finest_share())
        }
        _ => low + (high - low) * chance.finest_share(),
    }
}
