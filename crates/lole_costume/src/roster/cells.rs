//! Bytes to cells: encodings, separators, quotation marks.

use super::{MOST_BYTES, MOST_DANCERS, RosterError};

/// Rows of a list that are looked at: its dancers, heads, sums and notes.
pub(super) const MOST_ROWS: usize = 2 * MOST_DANCERS;
/// Cells of a row.
pub(super) const MOST_CELLS: usize = 500;

/// What parts the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Separator {
    Comma,
    /// Of spreadsheets whose decimals are written with a comma.
    Semicolon,
    Tab,
}

impl Separator {
    const ALL: [Self; 3] = [Self::Comma, Self::Semicolon, Self::Tab];

    const fn letter(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Semicolon => ';',
            Self::Tab => '\t',
        }
    }

    /// The one that stands most often in the first line that has any, outside of quotation marks.
    pub(super) fn of(text: &str) -> Self {
        let count = |line: &str, separator: Self| {
            let mut is_quoted = false;
            let mut count = 0;
            for letter in line.chars() {
                is_quoted ^= letter == '"';
                count += usize::from(!is_quoted && letter == separator.letter());
            }
            count
        };
        let mut lines = text.lines();
        let heads = lines.find(|line| Self::ALL.iter().any(|&one| 0 < count(line, one)));
        let heads = heads.unwrap_or_default();
        // Of equals the first wins: a comma is the usual one.
        let best = Self::ALL.into_iter().rev();
        best.max_by_key(|&one| count(heads, one))
            .unwrap_or(Self::Comma)
    }
}

/// One row and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Record {
    /// Line on which it begins, from 1.
    pub(super) line: u32,
    pub(super) cells: Vec<String>,
}

impl Record {
    /// A cell without the spaces around it; empty beyond the last one.
    pub(super) fn cell(&self, index: usize) -> &str {
        self.cells.get(index).map_or("", |cell| cell.trim())
    }

    pub(super) fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| cell.trim().is_empty())
    }
}

/// The text of a file: what its byte-order mark says, else UTF-8, else `Shift_JIS`.
pub(super) fn decode(bytes: &[u8]) -> Result<String, RosterError> {
    if MOST_BYTES < bytes.len() {
        return Err(RosterError::TooLarge { bytes: bytes.len() });
    }
    // Workbooks are ZIP archives or compound files.
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
        return Err(RosterError::Workbook);
    }
    let (encoding, mark) = match encoding_rs::Encoding::for_bom(bytes) {
        Some((encoding, mark)) => (encoding, mark),
        None if std::str::from_utf8(bytes).is_ok() => (encoding_rs::UTF_8, 0),
        None => (encoding_rs::SHIFT_JIS, 0),
    };
    let (text, has_errors) = encoding.decode_without_bom_handling(&bytes[mark..]);
    if has_errors || text.contains('\0') {
        return Err(RosterError::NoText);
    }
    Ok(text.into_owned())
}

/// Rows of cells that are not empty. A cell in quotation marks may hold separators, new lines, and doubled marks.
pub(super) fn records(text: &str, separator: Separator) -> Result<Vec<Record>, RosterError> {
    let mut records = Vec::new();
    let mut cells = Vec::new();
    let mut cell = String::new();
    let (mut line, mut first_line) = (1, 1);
    let mut quote_line = None;
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        line += u32::from(letter == '\n' || (letter == '\r' && letters.peek() != Some(&'\n')));
        match letter {
            '"' if quote_line.is_some() => {
                if letters.next_if_eq(&'"').is_some() {
                    cell.push('"');
                } else {
                    quote_line = None;
                }
            }
            // Within a cell a mark is a mark: 36" is inches.
            '"' if cell.trim().is_empty() => {
                cell.clear();
                quote_line = Some(line);
            }
            _ if quote_line.is_some() => cell.push(letter),
            '\r' if letters.peek() == Some(&'\n') => {}
            '\r' | '\n' => {
                cells.push(std::mem::take(&mut cell));
                let record = Record {
                    line: first_line,
                    cells: std::mem::take(&mut cells),
                };
                keep(&mut records, record)?;
                first_line = line;
            }
            _ if letter == separator.letter() => {
                cells.push(std::mem::take(&mut cell));
                if MOST_CELLS < cells.len() {
                    return Err(RosterError::TooWide { line: first_line });
                }
            }
            _ => cell.push(letter),
        }
    }
    if let Some(line) = quote_line {
        return Err(RosterError::OpenQuote { line });
    }
    cells.push(cell);
    let record = Record {
        line: first_line,
        cells,
    };
    keep(&mut records, record)?;
    Ok(records)
}

/// Keeps a row unless it is empty.
fn keep(records: &mut Vec<Record>, record: Record) -> Result<(), RosterError> {
    if record.is_blank() {
        return Ok(());
    }
    records.push(record);
    if MOST_ROWS < records.len() {
        let count = records.len();
        return Err(RosterError::TooMany { count });
    }
    Ok(())
}

/// Whether a spreadsheet would compute the cell.
pub(super) fn is_formula(cell: &str) -> bool {
    let mut letters = cell.chars();
    match letters.next() {
        Some('=' | '@') => true,
        Some('+' | '-') => (letters.next()).is_some_and(|next| next.is_alphabetic() || next == '('),
        _ => false,
    }
}
