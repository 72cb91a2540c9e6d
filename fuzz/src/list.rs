//! Lists of dancers with titles and rows, as spreadsheets save them.

use arbitrary::Unstructured;

use crate::{between, choose, count, once_in};

/// Titles of columns.
const TITLES: [&str; 14] = [
    "name",
    "名前",
    "hip",
    "ヒップ",
    "ﾋｯﾌﾟ",
    "waist (in)",
    "waist_cm",
    "身長",
    "stature",
    "背丈",
    "bust",
    "枚数",
    "figure",
    "備考",
];
/// Names.
const NAMES: [&str; 8] = [
    "Anela",
    "𠮷田 花",
    "=SUM(A1)",
    "a\"b",
    "",
    "a,b;c\td",
    "\u{202e}x",
    "O'Neil",
];
/// What stands where a number should.
const VALUES: [&str; 10] = [
    "", "92 cm", "36 1/2", "5'4\"", "９２", "92,5", "1e9", "nan", "-1", "woman",
];

/// A file.
pub fn file(bytes: &mut Unstructured<'_>) -> Vec<u8> {
    let between_cells = *choose(bytes, &[",", ";", "\t"]);
    let end = *choose(bytes, &["\n", "\r\n", "\r"]);
    let columns = 1 + count(bytes, 7) as usize;
    let mut text = String::new();
    if once_in(bytes, 4) {
        text.push('\u{feff}');
    }
    if once_in(bytes, 6) {
        text.push_str("ハーラウ");
        text.push_str(end);
    }
    let titles: Vec<&str> = (0..columns).map(|_| *choose(bytes, &TITLES)).collect();
    text.push_str(&titles.join(between_cells));
    text.push_str(end);
    for _ in 0..count(bytes, 12) {
        let ragged = if once_in(bytes, 12) {
            count(bytes, 3) as usize
        } else {
            0
        };
        let cells: Vec<String> = (0..columns + ragged)
            .map(|column| {
                cell(
                    bytes,
                    titles.get(column).copied().unwrap_or(""),
                    between_cells,
                )
            })
            .collect();
        text.push_str(&cells.join(between_cells));
        text.push_str(end);
    }
    match count(bytes, 7) {
        0 => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        // Cut within a letter.
        1 => text.as_bytes()[..text.len() - text.len().min(1)].to_vec(),
        _ => text.into_bytes(),
    }
}

fn cell(bytes: &mut Unstructured<'_>, title: &str, between_cells: &str) -> String {
    let is_name = title == "name" || title == "名前";
    let cell = match (is_name, count(bytes, 5)) {
        (true, _) => (*choose(bytes, &NAMES)).to_owned(),
        (false, 0) => (*choose(bytes, &VALUES)).to_owned(),
        (false, _) => format!("{:.1}", between(bytes, 20.0, 200.0)),
    };
    let parts = cell.contains(['"', '\n', '\r']) || cell.contains(between_cells);
    if parts && !once_in(bytes, 6) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell
    }
}
