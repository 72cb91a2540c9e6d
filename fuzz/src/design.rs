//! Designs of any keys, each over its range.

use std::fmt::Write as _;

use arbitrary::Unstructured;
use lole_costume::document::schema::{
    FINENESS, GARMENT, Key, Kind, LIST, MOTION_PARTS, PART_KEYS, TABLES,
};
use lole_garment::TEMPLATES;
use lole_garment::template::OptionKind;

use crate::{between, choose, once_in};

/// Which designs are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// Any keys; numbers may lie beside their range.
    Any,
    /// Numbers of their range, no file of another name, cloth that is coarse enough to be danced at once.
    Danced,
}

/// Garments of a design, at most.
const MOST_GARMENTS: u32 = 3;
/// Parts of a choreography, at most.
const MOST_PARTS: u32 = 4;
/// The grid of the skirt where it is to be danced.
const COARSE: &str = "column_count = 96\nrow_count = 40\n";

/// A design as a document.
pub fn text(bytes: &mut Unstructured<'_>, which: Which) -> String {
    let mut text = "lole = 1\n".to_owned();
    for table in TABLES {
        let is_coarse = which == Which::Danced && table.name == "skirt";
        if !is_coarse && !once_in(bytes, 2) {
            continue;
        }
        let _ = writeln!(text, "[{}]", table.name);
        if is_coarse {
            text.push_str(COARSE);
        }
        keys(bytes, which, table.keys, &mut text);
    }
    if which == Which::Any {
        for _ in 0..MOST_PARTS {
            if once_in(bytes, 3) {
                let _ = writeln!(text, "[[motion.{MOTION_PARTS}]]");
                keys(bytes, which, PART_KEYS, &mut text);
            }
        }
    }
    for _ in 0..MOST_GARMENTS {
        if once_in(bytes, 2) {
            garment(bytes, which, &mut text);
        }
    }
    text
}

fn garment(bytes: &mut Unstructured<'_>, which: Which, text: &mut String) {
    let template = choose(bytes, TEMPLATES);
    let _ = writeln!(text, "[[{LIST}]]\nkind = \"{}\"", template.id);
    for row in template.options {
        if once_in(bytes, 3) {
            let value = match &row.kind {
                OptionKind::Number { min, max, .. } => format!("{:.3}", between(bytes, *min, *max)),
                OptionKind::Count { min, max, .. } => {
                    let count = between(bytes, f64::from(*min), f64::from(*max));
                    format!("{count:.0}")
                }
                OptionKind::Choice(choices) => format!("\"{}\"", choose(bytes, choices).id),
            };
            let _ = writeln!(text, "{} = {value}", row.key);
        }
    }
    for table in GARMENT {
        if table.name == LIST {
            keys(bytes, which, table.keys, text);
            if which == Which::Any && once_in(bytes, 4) {
                keys(bytes, which, FINENESS, text);
            }
        } else if once_in(bytes, 4) {
            let _ = writeln!(text, "[{LIST}.{}]", table.name);
            keys(bytes, which, table.keys, text);
        }
    }
}

fn keys<T>(bytes: &mut Unstructured<'_>, which: Which, keys: &[Key<T>], text: &mut String) {
    for key in keys {
        let is_fine = ["column_count", "row_count", "substep_count"].contains(&key.name);
        let is_text = matches!(key.kind, Kind::Text { .. });
        if which == Which::Danced && (is_fine || is_text) {
            continue;
        }
        if once_in(bytes, 5) {
            let value = value(bytes, which, &key.kind);
            let _ = writeln!(text, "{} = {value}", key.name);
        }
    }
}

fn value<T>(bytes: &mut Unstructured<'_>, which: Which, kind: &Kind<T>) -> String {
    let is_beside = which == Which::Any && once_in(bytes, 16);
    let over = if is_beside { 1.5 } else { 1.0 };
    match kind {
        Kind::Number { min, max, .. } => format!("{:.4}", over * between(bytes, *min, *max)),
        #[expect(
            clippy::cast_precision_loss,
            reason = "a value of about that size will do"
        )]
        Kind::Count { min, max, .. } => {
            format!("{:.0}", over * between(bytes, *min as f64, *max as f64))
        }
        Kind::Name { choices, .. } => format!("\"{}\"", choose(bytes, &choices())),
        Kind::Text { .. } => format!("{:?}", bytes.arbitrary::<String>().unwrap_or_default()),
        Kind::Color { .. } => {
            let [red, green, blue] = bytes.arbitrary::<[u8; 3]>().unwrap_or_default();
            format!("\"#{red:02x}{green:02x}{blue:02x}\"")
        }
    }
}
