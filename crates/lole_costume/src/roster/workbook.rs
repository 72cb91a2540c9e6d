//! The first sheet of a workbook that is a list: `.xlsx` and `.ods`, read as they are saved.
//!
//! A workbook is a ZIP archive, and a small one can swell without end; so its parts are unpacked up to a
//! bound before anything is read of them, and cells are counted while they are read.

use std::io::{Cursor, Read as _};

use calamine::{Data, DataRef, Ods, Reader as _, Sheets, Xlsx, open_workbook_from_rs};
use zip::ZipArchive;

use super::cells::{MOST_CELLS, MOST_ROWS, Record};
use super::{RosterError, columns};

/// Largest size of all parts of a workbook, unpacked [byte].
const MOST_UNPACKED: u64 = 64 << 20;
/// Sheets that are looked at for a list.
const MOST_SHEETS: usize = 20;

/// A list of strings for each row that is not empty, of the sheet with the most heads among its first rows; the
/// first of equals.
pub(super) fn records(bytes: &[u8]) -> Result<Vec<Record>, RosterError> {
    let contents = unpacked(bytes)?;
    if let Some(contents) = &contents {
        check_repeats(contents)?;
    }
    let mut sheets = open(bytes, contents.as_deref())?;
    let names = sheets.sheet_names();
    let mut best: Option<(usize, Vec<Record>)> = None;
    for name in names.into_iter().take(MOST_SHEETS) {
        let records = match &mut sheets {
            Sheets::Xlsx(book) => of_xlsx(book, &name)?,
            Sheets::Ods(book) => of_ods(book, &name)?,
            _ => return Err(RosterError::Workbook),
        };
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

/// Opens it: an `.ods` is what has such contents.
fn open<'a>(bytes: &'a [u8], contents: Option<&str>) -> Result<Sheets<Bytes<'a>>, RosterError> {
    let cursor = Cursor::new(bytes);
    if contents.is_some() {
        let book: Result<Ods<_>, _> = open_workbook_from_rs(cursor);
        return book.map(Sheets::Ods).map_err(|_| RosterError::Workbook);
    }
    let book: Result<Xlsx<_>, _> = open_workbook_from_rs(cursor);
    book.map(Sheets::Xlsx).map_err(|_| RosterError::Workbook)
}

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

/// An `.ods` says of a row or a cell how often it is repeated: a line of text can be a million rows.
fn check_repeats(contents: &str) -> Result<(), RosterError> {
    contents
        .split("<table:table ")
        .skip(1)
        .try_for_each(|sheet| {
            let mut row_count = 0_usize;
            for row in sheet.split("<table:table-row").skip(1) {
                row_count = row_count.saturating_add(repeats(row, "table:number-rows-repeated"));
                // Sheets end with all the rows that are left, which are empty.
                if !has_text(row) {
                    continue;
                }
                if 2 * MOST_ROWS < row_count {
                    return Err(RosterError::TooMany { count: row_count });
                }
                check_cells(row, u32::try_from(row_count).unwrap_or(u32::MAX))?;
            }
            Ok(())
        })
}

fn has_text(part: &str) -> bool {
    part.contains("<text:p") || part.contains("office:value=")
}

/// The same of the cells of a row.
fn check_cells(row: &str, line: u32) -> Result<(), RosterError> {
    let mut cell_count = 0_usize;
    for cell in row.split("<table:table-cell").skip(1) {
        cell_count = cell_count.saturating_add(repeats(cell, "table:number-columns-repeated"));
        if has_text(cell) && MOST_CELLS < cell_count {
            return Err(RosterError::TooWide { line });
        }
    }
    Ok(())
}

/// What the first tag of a text says of this attribute; 1 where it says nothing.
fn repeats(tagged: &str, attribute: &str) -> usize {
    let tag = tagged.split('>').next().unwrap_or_default();
    let Some((_, value)) = tag.split_once(attribute) else {
        return 1;
    };
    let value = value.trim_start_matches([' ', '=', '"', '\'', '\n', '\t', '\r']);
    let end = value.find(|letter: char| !letter.is_ascii_digit());
    let digits = &value[..end.unwrap_or(value.len())];
    digits.parse().unwrap_or(usize::MAX)
}

fn of_xlsx(book: &mut Xlsx<Bytes<'_>>, name: &str) -> Result<Vec<Record>, RosterError> {
    let Ok(mut reader) = book.worksheet_cells_reader(name) else {
        // A sheet of a chart has no cells.
        return Ok(Vec::new());
    };
    let mut rows = Rows::default();
    while let Some(cell) = reader.next_cell().map_err(|_| RosterError::Workbook)? {
        let text = match cell.get_value() {
            DataRef::SharedString(text) => (*text).to_owned(),
            other => text_of(&Data::from(other.clone())),
        };
        rows.put(cell.get_position(), text)?;
    }
    Ok(rows.records)
}

fn of_ods(book: &mut Ods<Bytes<'_>>, name: &str) -> Result<Vec<Record>, RosterError> {
    let range = book
        .worksheet_range(name)
        .map_err(|_| RosterError::Workbook)?;
    let (row, column) = range.start().unwrap_or_default();
    let mut rows = Rows::default();
    for (down, across, value) in range.used_cells() {
        let [down, across] = [down, across].map(|off| u32::try_from(off).unwrap_or(u32::MAX));
        let place = (row.saturating_add(down), column.saturating_add(across));
        rows.put(place, text_of(value))?;
    }
    Ok(rows.records)
}

/// Rows that are filled cell by cell, in the order of reading.
#[derive(Default)]
struct Rows {
    records: Vec<Record>,
}

impl Rows {
    fn put(&mut self, (row, column): (u32, u32), text: String) -> Result<(), RosterError> {
        if text.trim().is_empty() {
            return Ok(());
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
            record.cells[column] = text;
        }
        Ok(())
    }
}

/// A cell as it would stand in CSV. Of a formula it is what it came to when the workbook was saved.
fn text_of(value: &Data) -> String {
    match value {
        Data::Float(number) => {
            // Nine digits: what a tape has, without the tail of binary fractions.
            let rounded = (number * 1.0e6).round() / 1.0e6;
            format!("{rounded}")
        }
        other => other.to_string(),
    }
}
