//! A list of dancers as a spreadsheet saves it, as text or as a workbook: one row a dancer, names and tape
//! measures.
//!
//! Heads are Japanese or English and stand in any order; text is UTF-8 with or without a byte-order
//! mark, UTF-16 with one, or `Shift_JIS`; columns are parted by commas, semicolons or tabs. A length is
//! in centimeters unless its head or its cell says inches. One bad row is told with its line and
//! column and leaves the others as they are; a file that is no list is refused whole.
//!
//! ```
//! use lole_costume::roster;
//!
//! let list = roster::read("名前,身長,ヒップ\n花子,158,91\nʻIolana,\"5'4\"\"\",38 in\n".as_bytes())?;
//! assert_eq!(list.dancers.len(), 2);
//! assert!((list.dancers[1].hip_cm() - 96.52).abs() < 1e-9);
//! # Ok::<(), roster::RosterError>(())
//! ```

mod cells;
mod columns;
mod lengths;
#[cfg(not(target_arch = "wasm32"))]
mod workbook;

use lole_body::{Figure, Measure, Measurements};
use lole_garment::template::OptionKind;
use lole_language::{Bilingual, Sentence, Words};
use lole_pattern::{Alteration, Alterations, TailorTape, Tailored};

use crate::document::Design;
use cells::{Record, Separator};
use columns::{Column, Meaning};
use lengths::{Reading, Unit};

/// Most dancers of a list: more than any hālau, and what one run can hold.
pub const MOST_DANCERS: usize = 1000;
/// Largest file [byte].
pub const MOST_BYTES: usize = 8 << 20;
/// Longest name [letter]: it becomes the name of files.
const MOST_LETTERS: usize = 80;

/// What a file says.
#[derive(Debug, Clone, PartialEq)]
pub struct Roster {
    /// Everybody whose row can be used, in the order of the file.
    pub dancers: Vec<RosterDancer>,
    /// Rows that cannot, and why.
    pub problems: Vec<RowProblem>,
    /// What was taken for granted, such as columns that were not read.
    pub notes: Vec<Sentence>,
}

/// One dancer of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct RosterDancer {
    /// Line of the file, from 1.
    pub line: u32,
    /// As written; no two are alike.
    pub name: String,
    /// Whose proportions, where a column says so.
    pub figure: Option<Figure>,
    /// How old she is [years], where the list says so.
    pub age_years: Option<f64>,
    /// How fitted garments are altered for her, as a trial has shown.
    pub alterations: Alterations,
    /// What was taken for drafting, and no body is built from.
    pub tailor_tape: TailorTape,
    /// What the tape said [cm], in the order of [`Measure::ALL`]. The hip is among them.
    pub tape_cm: Vec<(Measure, f64)>,
}

/// A row that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowProblem {
    /// Line of the file, from 1.
    pub line: u32,
    /// Column from 1 with its head, where it is about one.
    pub column: Option<(usize, String)>,
    /// What is wrong and what to do.
    pub what: Sentence,
}

impl RowProblem {
    /// The problem with its place.
    #[must_use]
    pub fn sentence(&self) -> Sentence {
        let Self { line, column, what } = self;
        match column {
            Some((number, head)) => Sentence::new(
                format!("{line} 行目、{number} 列目（{head}）: {}", what.japanese),
                format!("line {line}, column {number} ({head}): {}", what.english),
            ),
            None => Sentence::new(
                format!("{line} 行目: {}", what.japanese),
                format!("line {line}: {}", what.english),
            ),
        }
    }
}

/// Why a file is no list of dancers.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RosterError {
    /// It is larger than any list.
    #[error("the file has {bytes} bytes, more than a list of dancers has; save only the list")]
    TooLarge {
        /// Its size.
        bytes: usize,
    },
    /// It is not text.
    #[error(
        "the file is no text in UTF-8 or Shift_JIS; in the spreadsheet choose \"CSV UTF-8\" when saving"
    )]
    NoText,
    /// It is a spreadsheet's own file, of a kind or in a state that is not read.
    #[error(
        "the file is a workbook that cannot be read; save it as .xlsx or .ods, or choose \"CSV UTF-8\" when saving"
    )]
    Workbook,
    /// Unpacked it is larger than any list.
    #[error(
        "unpacked the workbook has more than 64 MB, more than a list of dancers has; save only the list"
    )]
    Swells,
    /// A row has more cells than any list has columns.
    #[error("line {line}: the row has more than 500 cells; save only the list")]
    TooWide {
        /// Its line.
        line: u32,
    },
    /// A quotation mark is never closed.
    #[error("line {line}: a quotation mark opens here and is never closed; close or remove it")]
    OpenQuote {
        /// Where it opens.
        line: u32,
    },
    /// Nothing but empty lines.
    #[error(
        "the list is empty; write a first row of heads such as name, stature, bust, waist, hip"
    )]
    Empty,
    /// A column without which nothing can be sized.
    #[error(
        "line {line}: no column is called {}; one of the first ten lines must name the columns, such as \
         name, stature, bust, waist, hip",
        column.english
    )]
    MissingColumn {
        /// Line of the heads.
        line: u32,
        /// What is missing.
        column: Words,
    },
    /// Two columns of one meaning.
    #[error(
        "line {line}: columns {first} and {second} are both {}; rename or remove one",
        column.english
    )]
    TwiceColumn {
        /// Line of the heads.
        line: u32,
        /// What both are.
        column: Words,
        /// Number of one, from 1.
        first: usize,
        /// Number of the other.
        second: usize,
    },
    /// More rows than one run takes.
    #[error(
        "the list has {count} dancers or more; at most {MOST_DANCERS} are cut at once, so split it"
    )]
    TooMany {
        /// How many.
        count: usize,
    },
}

impl Bilingual for RosterError {
    fn japanese(&self) -> String {
        match self {
            Self::TooLarge { bytes } => format!(
                "ファイルが {bytes} バイトあり、名簿としては大きすぎます。名簿だけを保存してください"
            ),
            Self::NoText => "UTF-8 でも Shift_JIS でもないファイルです。表計算ソフトで「CSV UTF-8」を選んで保存してください".to_owned(),
            Self::Workbook => "読めない表計算ソフトのファイルです。.xlsx か .ods で、または「CSV UTF-8」を選んで保存してください".to_owned(),
            Self::Swells => "展開すると 64 MB を超え、名簿としては大きすぎます。名簿だけを保存してください".to_owned(),
            Self::TooWide { line } => {
                format!("{line} 行目: 列が 500 より多くあります。名簿だけを保存してください")
            }
            Self::OpenQuote { line } => format!(
                "{line} 行目: ここで始まる引用符が閉じていません。閉じるか、消してください"
            ),
            Self::Empty => "名簿が空です。最初の行に 名前、身長、バスト、ウエスト、ヒップ などの見出しを書いてください".to_owned(),
            Self::MissingColumn { line, column } => format!(
                "{line} 行目: 「{}」の列がありません。はじめの 10 行のどれかに 名前、身長、バスト、ウエスト、ヒップ などの見出しを書いてください",
                column.japanese
            ),
            Self::TwiceColumn {
                line,
                column,
                first,
                second,
            } => format!(
                "{line} 行目: {first} 列目と {second} 列目がどちらも「{}」です。片方の見出しを変えるか、消してください",
                column.japanese
            ),
            Self::TooMany { count } => format!(
                "名簿に {count} 人以上います。一度に {MOST_DANCERS} 人までです。分けてください"
            ),
        }
    }
}

impl RosterDancer {
    /// Girth of the hips [cm].
    #[must_use]
    pub fn hip_cm(&self) -> f64 {
        let mut tape = self.tape_cm.iter();
        let hip = tape.find(|(measure, _)| *measure == Measure::Hip);
        hip.map_or(0.0, |&(_, cm)| cm)
    }

    /// The design as this dancer wears it: her tape, all else as it is. Heights that the design
    /// gives for its own dancer's body follow the statures; the hem stays where it is above the
    /// floor, so that a group is level. Where the design chooses no face, she has one of her own, which is that of
    /// her name.
    #[must_use]
    pub fn design(&self, design: &Design) -> Design {
        let mut worn = design.clone();
        worn.dancer.file = None;
        if let Some(figure) = self.figure {
            worn.dancer.figure = figure;
        }
        if self.age_years.is_some() {
            worn.dancer.age_years = self.age_years;
        }
        // What a trial has shown of one body is nothing to another.
        worn.alterations = self.alterations;
        worn.dancer.tailor_tape = self.tailor_tape;
        if worn.face.is_unchosen() {
            worn.face.seed = seed_of(&self.name);
        }
        for measure in Measure::ALL {
            let mut tape = self.tape_cm.iter();
            let given = tape.find(|(known, _)| *known == measure);
            *worn.dancer.measure_mut(measure) = given.map(|&(_, cm)| cm);
        }
        let stature = |design: &Design| Some(Measurements::from_tape(&design.tape()).ok()?.stature);
        if let (Some(own), Some(hers)) = (stature(design), stature(&worn)) {
            follow_stature(&mut worn, hers.to_cm() / own.to_cm());
        }
        worn
    }
}

/// A seed that a name always has, and hardly another name; 0 would be the measured face.
fn seed_of(name: &str) -> u64 {
    (lole_geom::fnv::hash(name.bytes()) >> 32).max(1)
}

/// Key of the height of a hem.
const HEM_HEIGHT: &str = "hem_height_cm";

/// Moves the places where garments are worn up or down by a ratio of statures; hems stay.
fn follow_stature(design: &mut Design, ratio: f64) {
    let follow = |height: &mut Option<f64>| {
        if let Some(cm) = height {
            *cm *= ratio;
        }
    };
    follow(&mut design.skirt.worn_height_cm);
    for garment in &mut design.garments {
        for (position, row) in garment.template.options.iter().enumerate() {
            // A height that has a default, as of a puff, is none on the body.
            let follows = matches!(row.kind, OptionKind::Number { default: None, .. });
            if follows && row.key.ends_with("_height_cm") && row.key != HEM_HEIGHT {
                let mut height = garment.options.get(position);
                follow(&mut height);
                garment.options.set(position, height);
            }
        }
    }
}

/// The names of a list whose measurements are still to be taken, in its order.
///
/// # Errors
/// A file that is no list, or that has no column of names; see [`RosterError`].
pub fn names(bytes: &[u8]) -> Result<Vec<String>, RosterError> {
    let (records, _) = records(bytes)?;
    let Sheet { head, rows, .. } = Sheet::of(records)?;
    let (columns, _) = columns::read(&head, &[Meaning::Name])?;
    let is_name = |column: &&Column| column.meaning == Meaning::Name;
    let place = columns
        .iter()
        .find(is_name)
        .map_or(0, |column| column.index);
    let people = rows.iter().filter(|row| !is_summary(row, place));
    let names = people.map(|row| {
        let words: Vec<&str> = row.cell(place).split_whitespace().collect();
        words.join(" ").chars().take(MOST_LETTERS).collect()
    });
    let names: Vec<String> = names.filter(|name: &String| !name.is_empty()).collect();
    if MOST_DANCERS < names.len() {
        return Err(RosterError::TooMany { count: names.len() });
    }
    Ok(names)
}

/// The rows of a file, and what parts their cells: a workbook writes decimals with a point.
fn records(bytes: &[u8]) -> Result<(Vec<Record>, Separator), RosterError> {
    #[cfg(not(target_arch = "wasm32"))]
    if bytes.starts_with(b"PK\x03\x04") {
        if MOST_BYTES < bytes.len() {
            return Err(RosterError::TooLarge { bytes: bytes.len() });
        }
        return Ok((workbook::records(bytes)?, Separator::Comma));
    }
    let text = cells::decode(bytes)?;
    let separator = Separator::of(&text);
    Ok((cells::records(&text, separator)?, separator))
}

/// The rows of a file that are not empty, by what they are.
struct Sheet {
    /// What stands above the heads.
    titles: Vec<Record>,
    head: Record,
    rows: Vec<Record>,
}

impl Sheet {
    /// Heads are looked for among this many lines.
    const HEAD_LINES: u32 = 10;

    /// The heads are the row among the first lines in which the most cells are heads, the first of equals;
    /// where there is none, the first row.
    fn of(records: Vec<Record>) -> Result<Self, RosterError> {
        let mut rows: Vec<Record> = records.into_iter().filter(|row| !row.is_blank()).collect();
        let upper = rows.iter().take_while(|row| row.line <= Self::HEAD_LINES);
        let (mut place, mut most) = (0, 0);
        for (index, row) in upper.enumerate() {
            let count = columns::known_count(row);
            if most < count {
                (place, most) = (index, count);
            }
        }
        if rows.is_empty() {
            return Err(RosterError::Empty);
        }
        let head = rows.remove(place);
        let below = rows.split_off(place);
        Ok(Self {
            titles: rows,
            head,
            rows: below,
        })
    }
}

/// Words that begin a line of sums below a list, without spaces and case.
const SUMMARIES: &[&str] = &[
    "合計", "総計", "小計", "計", "平均", "人数", "最大", "最小", "total", "subtotal", "sum",
    "average", "mean",
];

/// Whether a row sums up others instead of being a dancer's: its name or what stands before it says so.
fn is_summary(row: &Record, name: usize) -> bool {
    (0..=name).any(|index| {
        let cell = lengths::narrow(row.cell(index));
        let words: String = cell
            .chars()
            .filter(|letter| letter.is_alphabetic())
            .collect();
        SUMMARIES.contains(&words.as_str())
            || SUMMARIES.iter().any(|word| {
                let rest = words.strip_prefix(word);
                rest.is_some_and(|rest| ["値", "人", "名", "人数", "s"].contains(&rest))
            })
    })
}

/// Lines above the heads and lines of sums, which are no dancers.
fn skipped(titles: &[Record], sums: &[Record]) -> Option<Sentence> {
    let lines: Vec<(u32, String)> = (titles.iter().chain(sums))
        .map(|row| {
            let mut cells = row.cells.iter().map(|cell| cell.trim());
            let first = cells.find(|cell| !cell.is_empty()).unwrap_or_default();
            (row.line, first.chars().take(MOST_LETTERS / 2).collect())
        })
        .collect();
    if lines.is_empty() {
        return None;
    }
    let japanese = lines
        .iter()
        .map(|(line, text)| format!("{line} 行目「{text}」"));
    let english = lines
        .iter()
        .map(|(line, text)| format!("line {line} (\"{text}\")"));
    Some(Sentence::new(
        format!(
            "見出しや踊り手の行ではないので、読みませんでした: {}",
            japanese.collect::<Vec<_>>().join("、")
        ),
        format!(
            "Not read, since it names neither columns nor a dancer: {}",
            english.collect::<Vec<_>>().join(", ")
        ),
    ))
}

/// Rows with more cells than the heads name: nobody knows what those are.
fn surplus(head: &Record, rows: &[Record]) -> Option<Sentence> {
    let is_long = |row: &&Record| {
        (head.cells.len()..row.cells.len()).any(|index| !row.cell(index).is_empty())
    };
    let lines: Vec<String> = (rows.iter())
        .filter(is_long)
        .map(|row| row.line.to_string())
        .collect();
    (!lines.is_empty()).then(|| {
        Sentence::new(
            format!(
                "{} 行目: 見出しより右にある欄は読みませんでした。列がずれていないか確かめてください",
                lines.join("、")
            ),
            format!(
                "line {}: cells to the right of the heads were not read; see that no column has moved",
                lines.join(", ")
            ),
        )
    })
}

/// What is said of rows whose age is none: it changes pictures alone, so nobody is left out for it.
fn ageless(columns: &[Column], rows: &[Record]) -> Option<Sentence> {
    let column = columns.iter().find(|it| it.meaning == Meaning::Age)?;
    let is_none = |row: &&Record| columns::age(row.cell(column.index)).is_err();
    let lines = rows.iter().filter(is_none).map(|row| row.line.to_string());
    let lines: Vec<String> = lines.collect();
    let [youngest, oldest] = columns::ages();
    let head = &column.head;
    (!lines.is_empty()).then(|| {
        Sentence::new(
            format!(
                "{} 行目: 「{head}」は {youngest} から {oldest} までの数として読めず、使いませんでした。年齢は絵の顔と髪だけを変えます",
                lines.join("、")
            ),
            format!(
                "line {}: \"{head}\" is no number from {youngest} to {oldest} and was not used; ages change face and hair of pictures alone",
                lines.join(", ")
            ),
        )
    })
}

/// Reads a list of dancers.
///
/// # Errors
/// A file that is no list, see [`RosterError`]. Single rows that cannot be used are part of the
/// [`Roster`].
pub fn read(bytes: &[u8]) -> Result<Roster, RosterError> {
    let (records, separator) = records(bytes)?;
    let Sheet { titles, head, rows } = Sheet::of(records)?;
    let (mut columns, notes) = columns::read(&head, &columns::NEEDED)?;
    let mut named = columns.iter();
    let named = named.find(|column| column.meaning == Meaning::Name);
    let place = named.map_or(0, |column| column.index);
    let (sums, rows): (Vec<Record>, Vec<Record>) =
        rows.into_iter().partition(|row| is_summary(row, place));
    if MOST_DANCERS < rows.len() {
        return Err(RosterError::TooMany { count: rows.len() });
    }
    let mut notes: Vec<Sentence> = skipped(&titles, &sums).into_iter().chain(notes).collect();
    notes.extend(surplus(&head, &rows));
    notes.extend(ageless(&columns, &rows));
    notes.extend(settle_units(&mut columns, &rows, separator));
    let mut roster = Roster {
        dancers: Vec::new(),
        problems: Vec::new(),
        notes,
    };
    for row in &rows {
        match dancer(row, &columns, separator, &roster.dancers) {
            Ok(dancer) => roster.dancers.push(dancer),
            Err(problems) => roster.problems.extend(problems),
        }
    }
    Ok(roster)
}

/// Columns without a unit whose numbers can all be inches and none centimeters are inches.
fn settle_units(columns: &mut [Column], rows: &[Record], separator: Separator) -> Vec<Sentence> {
    let mut notes = Vec::new();
    for column in columns.iter_mut() {
        let Some(band) = column.meaning.taped_cm() else {
            continue;
        };
        if column.unit.is_some() {
            continue;
        }
        let cells = rows.iter().map(|row| row.cell(column.index));
        let plain: Vec<f64> = cells
            .filter_map(|cell| match lengths::read(cell, separator) {
                Reading::Plain(number) => Some(number),
                _ => None,
            })
            .collect();
        let fits = |unit: Unit| move |number: &f64| lengths::fits(band, unit.to_cm(*number));
        let are_inches = !plain.is_empty()
            && plain.iter().all(fits(Unit::Inch))
            && !plain.iter().any(fits(Unit::Centimeter));
        if are_inches {
            column.unit = Some(Unit::Inch);
            let head = &column.head;
            notes.push(Sentence::new(
                format!("「{head}」の列は、数の大きさからインチとして読みました。cm のときは見出しを「{head}(cm)」にしてください。"),
                format!("The column \"{head}\" was read as inches, because its numbers fit no body in centimeters. Write \"{head} (cm)\" if they are centimeters."),
            ));
        }
    }
    notes
}

/// One row; every problem of it at once.
fn dancer(
    row: &Record,
    columns: &[Column],
    separator: Separator,
    others: &[RosterDancer],
) -> Result<RosterDancer, Vec<RowProblem>> {
    let mut dancer = RosterDancer {
        line: row.line,
        name: String::new(),
        figure: None,
        age_years: None,
        alterations: Alterations::NONE,
        tailor_tape: TailorTape::NONE,
        tape_cm: Vec::new(),
    };
    let mut problems = Vec::new();
    for column in columns {
        let cell = row.cell(column.index);
        let read = match column.meaning {
            _ if cells::is_formula(cell) => Err(formula(cell)),
            Meaning::Name => name(cell, others).map(|name| dancer.name = name),
            Meaning::Figure => figure(cell).map(|figure| dancer.figure = figure),
            Meaning::Age => {
                dancer.age_years = columns::age(cell).unwrap_or_default();
                Ok(())
            }
            Meaning::Alteration(one) => alteration(cell, one, column.unit, separator).map(|cm| {
                dancer.alterations = dancer.alterations.with_cm(one, cm);
            }),
            Meaning::Measure(measure) => length(cell, column, measure.band_cm(), separator)
                .map(|cm| dancer.tape_cm.extend(cm.map(|cm| (measure, cm)))),
            Meaning::Tailored(one) => length(cell, column, one.band_cm(), separator).map(|cm| {
                dancer.tailor_tape = dancer.tailor_tape.with_cm(one, cm);
            }),
        };
        if let Err(what) = read {
            problems.push(RowProblem {
                line: row.line,
                column: Some((column.index + 1, column.head.clone())),
                what,
            });
        }
    }
    dancer.tape_cm.sort_by_key(|&(measure, _)| measure);
    if problems.is_empty() {
        Ok(dancer)
    } else {
        Err(problems)
    }
}

fn formula(cell: &str) -> Sentence {
    let cell: String = cell.chars().take(40).collect();
    Sentence::new(
        format!("「{cell}」は計算式です。表計算ソフトで値だけを貼り付けて保存してください"),
        format!("\"{cell}\" is a formula; paste the values alone and save again"),
    )
}

fn name(cell: &str, others: &[RosterDancer]) -> Result<String, Sentence> {
    let name = cell.split_whitespace().collect::<Vec<_>>().join(" ");
    if name.is_empty() {
        return Err(Sentence::new(
            "名前がありません。名前を書いてください",
            "there is no name; write one",
        ));
    }
    if MOST_LETTERS < name.chars().count() {
        return Err(Sentence::new(
            format!("名前が {MOST_LETTERS} 文字より長くなっています。短くしてください"),
            format!("the name is longer than {MOST_LETTERS} letters; shorten it"),
        ));
    }
    match others.iter().find(|other| other.name == name) {
        None => Ok(name),
        Some(other) => Err(Sentence::new(
            format!(
                "「{name}」は {} 行目にもあります。同じ人なら片方を消し、別の人なら区別できる名前にしてください",
                other.line
            ),
            format!(
                "\"{name}\" is on line {} too; remove one, or tell the two apart by their names",
                other.line
            ),
        )),
    }
}

fn figure(cell: &str) -> Result<Option<Figure>, Sentence> {
    columns::figure(cell).map_err(|()| {
        Sentence::new(
            format!("「{cell}」は読めません。女性、男性、子ども のどれかを書くか、空けてください"),
            format!("\"{cell}\" cannot be read; write woman, man or child, or leave it empty"),
        )
    })
}

/// A length in centimeters; `None` of an empty cell that can be estimated.
fn length(
    cell: &str,
    column: &Column,
    band: [f64; 2],
    separator: Separator,
) -> Result<Option<f64>, Sentence> {
    let (words, unit) = (column.meaning.words(), column.unit);
    let cm = match lengths::read(cell, separator) {
        Reading::Empty if column.meaning == Meaning::Measure(Measure::Hip) => {
            return Err(Sentence::new(
                "空です。ヒップはかならず測ってください",
                "it is empty; the hip must be measured",
            ));
        }
        Reading::Empty => return Ok(None),
        Reading::NoNumber => {
            return Err(Sentence::new(
                format!("「{cell}」は長さではありません。91.4 や 36 in のように書いてください"),
                format!("\"{cell}\" is no length; write it like 91.4 or 36 in"),
            ));
        }
        Reading::Length(cm) => cm,
        Reading::Plain(number) => {
            let cm = unit.unwrap_or(Unit::Centimeter).to_cm(number);
            let other = match unit {
                None => Some(Unit::Inch),
                Some(Unit::Inch) => Some(Unit::Centimeter),
                Some(_) => None,
            };
            let other = other.filter(|other| lengths::fits(band, other.to_cm(number)));
            if let (false, Some(other)) = (lengths::fits(band, cm), other) {
                let (unit, name) = (other.abbreviation(), other.name());
                return Err(Sentence::new(
                    format!(
                        "{}が {cell} では体に合いません。{}なら「{cell} {unit}」と書いてください",
                        words.japanese, name.japanese
                    ),
                    format!(
                        "a {} of {cell} fits nobody; if it is in {}, write \"{cell} {unit}\"",
                        words.english, name.english
                    ),
                ));
            }
            cm
        }
    };
    if lengths::fits(band, cm) {
        return Ok(Some(cm));
    }
    Err(unfit(column.meaning, cm, band))
}

/// A length that nobody has.
fn unfit(meaning: Meaning, cm: f64, [least, most]: [f64; 2]) -> Sentence {
    let words = meaning.words();
    // The two are one letter apart, and often mistaken for each other.
    let is_stature = meaning == Meaning::Tailored(Tailored::BackLength)
        && lengths::fits(Measure::Stature.band_cm(), cm);
    if is_stature {
        return Sentence::new(
            format!(
                "背丈が {cm:.1} cm です。背丈は首の後ろの骨からウエストまでの長さです。身長なら、列の見出しを「身長」にしてください"
            ),
            format!(
                "the back length is {cm:.1} cm, but it goes from the nape to the waist; if it is the stature, call the column so (身長)"
            ),
        );
    }
    Sentence::new(
        format!(
            "{}が {cm:.1} cm です。{least}～{most} cm のはずです。測りなおすか、単位をたしかめてください",
            words.japanese
        ),
        format!(
            "the {} is {cm:.1} cm, but a dancer's lies between {least} and {most} cm; measure again or check the unit",
            words.english
        ),
    )
}

/// How much of an alteration a cell says [cm], which may be less than nothing; nothing of an empty one.
fn alteration(
    cell: &str,
    alteration: Alteration,
    unit: Option<Unit>,
    separator: Separator,
) -> Result<f64, Sentence> {
    let narrowed = lengths::narrow(cell);
    let written = narrowed.trim();
    let below = written.strip_prefix(['-', '−', '▲', '△']);
    let below = below.filter(|rest| !rest.trim().is_empty());
    let sign = if below.is_some() { -1.0 } else { 1.0 };
    let cm = match lengths::read(below.unwrap_or(written), separator) {
        Reading::Empty => 0.0,
        Reading::Length(cm) => sign * cm,
        Reading::Plain(number) => sign * unit.unwrap_or(Unit::Centimeter).to_cm(number),
        Reading::NoNumber => {
            return Err(Sentence::new(
                format!("「{cell}」は長さではありません。1.5 や -1 のように書いてください"),
                format!("\"{cell}\" is no length; write it like 1.5 or -1"),
            ));
        }
    };
    let [least, most] = alteration.band_cm();
    if (least..=most).contains(&cm) {
        return Ok(cm);
    }
    let name = alteration.name();
    Err(Sentence::new(
        format!(
            "{}が {cm:.1} cm です。{least}～{most} cm にしてください",
            name.japanese
        ),
        format!(
            "{} is altered by {cm:.1} cm; give a number from {least} to {most} cm",
            name.english
        ),
    ))
}

#[cfg(test)]
mod tests;
