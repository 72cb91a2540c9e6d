//! Sheets of an `.ods`: the elements of its contents, one after the other.
//!
//! A row, a cell or a space says how often it is repeated, so a line of text can stand for gigabytes. What is
//! repeated is counted and put once for each place that a list may have; nothing is made of the rest.

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::{MOST_CELLS, MOST_ROWS, MOST_SHEETS, Record, RosterError, Rows, number};

/// The sheets of these contents, each as a list of rows that are not empty.
pub(super) fn sheets(contents: &str) -> Result<Vec<Vec<Record>>, RosterError> {
    let mut reader = Reader::from_str(contents);
    let mut book = Book::default();
    while book.sheets.len() < MOST_SHEETS {
        match reader.read_event().map_err(|_| RosterError::Workbook)? {
            Event::Start(tag) => book.open(&tag)?,
            Event::Empty(tag) => {
                book.open(&tag)?;
                book.close(tag.name().as_ref())?;
            }
            Event::End(tag) => book.close(tag.name().as_ref())?,
            Event::Text(text) => book.say(&text.xml_content(XmlVersion::Implicit1_0)),
            Event::CData(text) => book.say(&text.xml_content(XmlVersion::Implicit1_0)),
            Event::GeneralRef(letter) => {
                let coded = letter.resolve_char_ref();
                let coded = coded.map_err(|_| RosterError::Workbook)?;
                match (coded, quick_xml::escape::resolve_predefined_entity(&letter)) {
                    (Some(letter), _) => book.say(letter.encode_utf8(&mut [0; 4])),
                    (None, Some(text)) => book.say(text),
                    (None, None) => return Err(RosterError::Workbook),
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    Ok(book.sheets)
}

/// What has been read so far.
#[derive(Default)]
struct Book {
    sheets: Vec<Vec<Record>>,
    sheet: Option<Rows>,
    /// Row and column that come next, counted from 0.
    place: (u32, u32),
    row_repeats: u32,
    /// Cells of the row, to be repeated with it: the first column of each, how many, and what stands there.
    row: Vec<(u32, u32, String)>,
    cell: Option<Cell>,
    /// Notes beside a cell that are open: their text is none of the cell's.
    notes: u32,
    is_in_paragraph: bool,
}

struct Cell {
    repeats: u32,
    value: Option<String>,
    text: String,
    paragraphs: u32,
}

impl Book {
    fn open(&mut self, tag: &BytesStart<'_>) -> Result<(), RosterError> {
        match tag.name().as_ref() {
            "table:table" => {
                self.sheet = Some(Rows::default());
                self.place = (0, 0);
            }
            "table:table-row" => {
                self.place.1 = 0;
                self.row_repeats = repeats(tag, "table:number-rows-repeated")?;
            }
            "table:table-cell" | "table:covered-table-cell" => {
                self.cell = Some(Cell {
                    repeats: repeats(tag, "table:number-columns-repeated")?,
                    value: value(tag)?,
                    text: String::new(),
                    paragraphs: 0,
                });
            }
            "office:annotation" => self.notes += 1,
            "text:p" => {
                self.is_in_paragraph = true;
                if let Some(cell) = self.cell.as_mut().filter(|_| self.notes == 0) {
                    if 0 < cell.paragraphs {
                        cell.text.push('\n');
                    }
                    cell.paragraphs += 1;
                }
            }
            "text:s" => {
                // A name is no longer for more spaces than one.
                repeats(tag, "text:c")?;
                self.say(" ");
            }
            "text:tab" | "text:line-break" => self.say(" "),
            _ => {}
        }
        Ok(())
    }

    fn close(&mut self, name: &str) -> Result<(), RosterError> {
        match name {
            "table:table" => self
                .sheets
                .extend(self.sheet.take().map(|rows| rows.records)),
            "table:table-row" => self.put_row()?,
            "table:table-cell" | "table:covered-table-cell" => {
                let Some(cell) = self.cell.take() else {
                    return Ok(());
                };
                let first = self.place.1;
                self.place.1 = first.saturating_add(cell.repeats);
                let text = cell.value.unwrap_or(cell.text);
                if !text.trim().is_empty() {
                    self.row.push((first, cell.repeats, text));
                }
            }
            "office:annotation" => self.notes = self.notes.saturating_sub(1),
            "text:p" => self.is_in_paragraph = false,
            _ => {}
        }
        Ok(())
    }

    fn say(&mut self, text: &str) {
        if self.notes == 0
            && self.is_in_paragraph
            && let Some(cell) = &mut self.cell
        {
            cell.text.push_str(text);
        }
    }

    /// The row as often as it stands there; past what a list may have, [`Rows`] refuses it.
    fn put_row(&mut self) -> Result<(), RosterError> {
        let row = self.place.0;
        self.place.0 = row.saturating_add(self.row_repeats);
        let cells = std::mem::take(&mut self.row);
        let Some(sheet) = self.sheet.as_mut().filter(|_| !cells.is_empty()) else {
            return Ok(());
        };
        for down in 0..self.row_repeats.min(bound(MOST_ROWS)) {
            for (column, count, text) in &cells {
                for across in 0..(*count).min(bound(MOST_CELLS)) {
                    let place = (row.saturating_add(down), column.saturating_add(across));
                    sheet.put(place, text)?;
                }
            }
        }
        Ok(())
    }
}

/// One more than a list may have: enough to be refused.
fn bound(most: usize) -> u32 {
    u32::try_from(most + 1).unwrap_or(u32::MAX)
}

/// How often an element stands there.
fn repeats(tag: &BytesStart<'_>, name: &str) -> Result<u32, RosterError> {
    let digits = attribute(tag, name)?;
    Ok(digits.map_or(1, |digits| digits.trim().parse().unwrap_or(u32::MAX)))
}

/// What a cell holds beside its text: a number, a truth or a day.
fn value(tag: &BytesStart<'_>) -> Result<Option<String>, RosterError> {
    if let Some(value) = attribute(tag, "office:value")? {
        return Ok(Some(value.trim().parse().map_or(value, number)));
    }
    for name in [
        "office:string-value",
        "office:boolean-value",
        "office:date-value",
        "office:time-value",
    ] {
        if let Some(value) = attribute(tag, name)? {
            return Ok(Some(value));
        }
    }
    Ok(None)
}

fn attribute(tag: &BytesStart<'_>, name: &str) -> Result<Option<String>, RosterError> {
    let found = tag.try_get_attribute(name);
    let Some(found) = found.map_err(|_| RosterError::Workbook)? else {
        return Ok(None);
    };
    let value = found.normalized_value(XmlVersion::Implicit1_0);
    Ok(Some(value.map_err(|_| RosterError::Workbook)?.into_owned()))
}
