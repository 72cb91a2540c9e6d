//! Writes a design as text: every value, in the order of the schema, one key to a line.

use std::fmt::Write as _;

use super::schema::{Key, Kind, MOTION_PARTS, PART_KEYS, TABLES};
use super::{Design, VERSION};

/// The canonical text of a design. Reading it back gives the same design, to the last bit.
///
/// What is not set (an unmeasured girth, a figure the preset gives) is left out; tables that would
/// be empty are left out too.
#[must_use]
pub fn to_toml(design: &Design) -> String {
    let mut text = format!("lole = {VERSION}\n");
    for table in TABLES {
        let lines = lines(table.keys, design);
        if !lines.is_empty() {
            // Writing to a string cannot fail.
            let about = table.about;
            let _ignored = write!(
                text,
                "\n# {}\n# {}\n[{}]\n",
                about.japanese, about.english, table.name
            );
            text.extend(lines);
        }
        if table.name == "motion" {
            for part in &design.motion.parts {
                let _ignored = write!(text, "\n[[motion.{MOTION_PARTS}]]\n");
                text.extend(self::lines(PART_KEYS, part));
            }
        }
    }
    text
}

/// A line for each key that has a value.
fn lines<D>(keys: &[Key<D>], design: &D) -> Vec<String> {
    let line = |key: &Key<D>| {
        let value = value_text(&key.kind, design)?;
        let about = key.about;
        Some(format!(
            "{} = {value}  # {}; {}\n",
            key.name, about.japanese, about.english
        ))
    };
    keys.iter().filter_map(line).collect()
}

/// The value as TOML; `None` leaves the key out.
fn value_text<D>(kind: &Kind<D>, design: &D) -> Option<String> {
    match kind {
        Kind::Number { get, .. } => get(design).map(number_text),
        Kind::Count { get, .. } => get(design).map(|value| value.to_string()),
        Kind::Name { get, .. } => Some(format!("\"{}\"", get(design))),
        Kind::Color { get, .. } => {
            get(design).map(|[red, green, blue]| format!("\"#{red:02x}{green:02x}{blue:02x}\""))
        }
    }
}

/// The shortest text that reads back as the same bits: whole numbers as people write them, others
/// as Rust prints them (`{:?}` round-trips and is valid TOML).
fn number_text(value: f64) -> String {
    let whole =
        value.fract() == 0.0 && value.abs() < 1.0e15 && !(value == 0.0 && value.is_sign_negative());
    if whole {
        format!("{value:.0}")
    } else {
        format!("{value:?}")
    }
}
