//! Writes a design as text: every value, in the order of the schema, one key to a line, then the
//! garments that are worn with the skirt.

use std::fmt::Write as _;

use super::schema::{FINENESS, GARMENT, Key, Kind, LIST, MOTION_PARTS, PART_KEYS, TABLES, Table};
use super::{Design, GarmentDesign, VERSION, template};

/// The canonical text of a design. Reading it back gives the same design, to the last bit.
///
/// What is not set (an unmeasured girth, a figure the preset gives) is left out; tables that would
/// be empty are left out too.
#[must_use]
pub fn to_toml(design: &Design) -> String {
    let mut text = format!("lole = {VERSION}\n");
    for table in TABLES {
        write_table(&mut text, table, format!("[{}]", table.name), "", design);
        if table.name == "motion" {
            for part in &design.motion.parts {
                // Writing to a string cannot fail.
                let _ignored = write!(text, "\n[[motion.{MOTION_PARTS}]]\n");
                text.extend(lines(PART_KEYS, part));
            }
        }
    }
    for garment in &design.garments {
        write_garment(&mut text, garment);
    }
    text
}

/// A garment: its own keys and the lines of its options, then the tables of its parts.
fn write_garment(text: &mut String, garment: &GarmentDesign) {
    let kind = format!(
        "kind = \"{}\"  # 服の種類; kind of garment\n",
        garment.kind_id()
    );
    for table in GARMENT {
        if table.name != LIST {
            let head = format!("[{LIST}.{}]", table.name);
            write_table(text, table, head, "", garment);
            continue;
        }
        write_table(text, table, format!("[[{LIST}]]"), &kind, garment);
        text.extend(template::lines(garment.template, &garment.options));
        if garment.is_danced() {
            text.extend(lines(FINENESS, garment));
        }
    }
}

/// A table with its comment: the line `first`, then every key that has a value.
fn write_table<T>(text: &mut String, table: &Table<T>, head: String, first: &str, from: &T) {
    let lines = lines(table.keys, from);
    if !lines.is_empty() {
        let about = table.about;
        // Writing to a string cannot fail.
        let _ignored = write!(
            text,
            "\n# {}\n# {}\n{head}\n{first}",
            about.japanese, about.english
        );
        text.extend(lines);
    }
}

/// A line for each key that has a value.
fn lines<T>(keys: &[Key<T>], from: &T) -> Vec<String> {
    let line = |key: &Key<T>| {
        let value = value_text(&key.kind, from)?;
        let about = key.about;
        Some(format!(
            "{} = {value}  # {}; {}\n",
            key.name, about.japanese, about.english
        ))
    };
    keys.iter().filter_map(line).collect()
}

/// The value as TOML; `None` leaves the key out.
fn value_text<T>(kind: &Kind<T>, design: &T) -> Option<String> {
    match kind {
        Kind::Number { get, .. } => get(design).map(number_text),
        Kind::Count { get, .. } => get(design).map(|value| value.to_string()),
        Kind::Name { get, .. } => Some(format!("\"{}\"", get(design))),
        Kind::Text { get, .. } => get(design).map(|text| toml::Value::from(text).to_string()),
        Kind::Color { get, .. } => {
            get(design).map(|[red, green, blue]| format!("\"#{red:02x}{green:02x}{blue:02x}\""))
        }
    }
}

/// The shortest text that reads back as the same bits: whole numbers as people write them, others
/// as Rust prints them (`{:?}` round-trips and is valid TOML).
pub(super) fn number_text(value: f64) -> String {
    let whole =
        value.fract() == 0.0 && value.abs() < 1.0e15 && !(value == 0.0 && value.is_sign_negative());
    if whole {
        format!("{value:.0}")
    } else {
        format!("{value:?}")
    }
}
