//! Writes a design as text: every value, in the order of the schema, one key to a line.

use std::fmt::Write as _;

use super::schema::{Kind, TABLES};
use super::{Design, VERSION};

/// The canonical text of a design. Reading it back gives the same design, to the last bit.
///
/// What is not set (an unmeasured girth, a figure the preset gives) is left out; tables that would
/// be empty are left out too.
#[must_use]
pub fn to_toml(design: &Design) -> String {
    let mut text = format!("lole = {VERSION}\n");
    for table in TABLES {
        let lines: Vec<String> = table
            .keys
            .iter()
            .filter_map(|key| {
                let value = value_text(&key.kind, design)?;
                Some(format!(
                    "{} = {value}  # {}; {}\n",
                    key.name, key.about.japanese, key.about.english
                ))
            })
            .collect();
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
    }
    text
}

/// The value as TOML; `None` leaves the key out.
fn value_text(kind: &Kind, design: &Design) -> Option<String> {
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
