//! The first sheet of a workbook that is a list: `.xlsx` and `.ods`, read as they are saved.
//!
//! A workbook is a ZIP archive, and a small one can swell without end; so its parts are unpacked up to a
//! bound before anything is read of them, and cells and their letters are counted while they are read.

mod ods;

use std::io::{Cursor, Read as _};

use calamine::{Data, DataRef, Reader as _, Xlsx, open_workbook_from_rs};
use zip::ZipArchive;

use super::cells::{MOST_CELLS, MOST_ROWS, Record};
use super::{RosterError, columns};

/// Largest size of all parts of a workbook, unpacked [byte].
const MOST_UNPACKED: u64 = 64 << 20;
/// Most that all cells of a sheet have together [byte]: a text is kept once and can be meant by every cell.
const MOST_LETTERS: usize = 64 << 20;
/// Sheets that are looked at for a list.
const MOST_SHEETS: usize = 20;

/// A list of strings for each row that is not empty, of the sheet with the most heads among its first rows; the
/// first of equals.
pub(super) fn records(bytes: &[u8]) -> Result<Vec<Record>, RosterError> {
    let sheets = match unpacked(bytes)? {
        Some(contents) => ods::sheets(&contents)?,
        None => of_xlsx(bytes)?,
    };
    let mut best: Option<(usize, Vec<Record>)> = None;
    for records in sheets {
        let upper = records.iter().take_while(|row| row.line <= HEAD_LINES);
        let count = upper.map(columns::known_count).max().unwrap_or_default();
        if best.as_ref().is_none_or(|(most, _)| *most < count) {
            best = Some((count, records));
        }
    }
    best.map(|(_, records)| records).ok_or(RosterError::Empty)
}

/// Heads are looked for among this many lines.
const HEAD_LINES: u32 = 10;

type Bytes<'a> = Cursor<&'a [u8]>;

/// Unpacks every part up to the bound; the text of an `.ods`, where it is one.
fn unpacked(bytes: &[u8]) -> Result<Option<String>, RosterError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| RosterError::Workbook)?;
    let mut left = MOST_UNPACKED;
    let mut contents = None;
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|_| RosterError::Workbook)?;
        let is_contents = part.name().is_ok_and(|name| name == "content.xml");
        let mut unpacked = Vec::new();
        let read = part.take(left + 1).read_to_end(&mut unpacked);
        read.map_err(|_| RosterError::Workbook)?;
        left = left
            .checked_sub(unpacked.len() as u64)
            .ok_or(RosterError::Swells)?;
        if is_contents {
            contents = Some(String::from_utf8_lossy(&unpacked).into_owned());
        }
    }
    Ok(contents)
}

/// The sheets of an `.xlsx`.
fn of_xlsx(bytes: &[u8]) -> Result<Vec<Vec<Record>>, RosterError> {
    let book: Result<Xlsx<_>, _> = open_workbook_from_rs(Cursor::new(bytes));
    let mut book = book.map_err(|_| RosterError::Workbook)?;
    let names = book.sheet_names().into_iter().take(MOST_SHEETS);
    names.map(|name| sheet_of_xlsx(&mut book, &name)).collect()
}

fn sheet_of_xlsx(book: &mut Xlsx<Bytes<'_>>, name: &str) -> Result<Vec<Record>, RosterError> {
    let Ok(mut reader) = book.worksheet_cells_reader(name) else {
        // A sheet of a chart has no cells.
        return Ok(Vec::new());
    };
    let mut rows = Rows::default();
    while let Some(cell) = reader.next_cell().map_err(|_| RosterError::Workbook)? {
        let place = cell.get_position();
        match cell.get_value() {
            DataRef::SharedString(text) => rows.put(place, text)?,
            other => rows.put(place, &text_of(&Data::from(other.clone())))?,
        }
    }
    Ok(rows.records)
}

/// Rows that are filled cell by cell, in the order of reading.
#[derive(Default)]
struct Rows {
    records: Vec<Record>,
    /// Size of all texts [byte].
    letters: usize,
}

impl Rows {
    fn put(&mut self, (row, column): (u32, u32), text: &str) -> Result<(), RosterError> {
        if text.trim().is_empty() {
            return Ok(());
        }
        self.letters = self.letters.saturating_add(text.len());
        if MOST_LETTERS < self.letters {
            return Err(RosterError::Swells);
        }
        let line = row.saturating_add(1);
        let column = column as usize;
        if MOST_CELLS <= column {
            return Err(RosterError::TooWide { line });
        }
        if self.records.last().is_none_or(|last| last.line != line) {
            let cells = Vec::new();
            self.records.push(Record { line, cells });
            let count = self.records.len();
            if MOST_ROWS < count {
                return Err(RosterError::TooMany { count });
            }
        }
        if let Some(record) = self.records.last_mut() {
            if record.cells.len() <= column {
                record.cells.resize(column + 1, String::new());
            }
            text.clone_into(&mut record.cells[column]);
        }
        Ok(())
    }
}

/// A cell as it would stand in CSV. Of a formula it is what it came to when the workbook was saved.
fn text_of(value: &Data) -> String {
    match value {
        Data::Float(value) => number(*value),
        other => other.to_string(),
    }
}

/// A number as it would stand in CSV: six decimals, without the tail of binary fractions.
fn number(value: f64) -> String {
    format!("{}", (value * 1.0e6).round() / 1.0e6)
}
