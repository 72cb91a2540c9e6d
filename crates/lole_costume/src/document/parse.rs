//! Reads a design from text, and says in one sentence what is wrong with it.

use std::ops::Range;

use lole_garment::template::Wear;
use lole_hula::MotionError;
use lole_language::{Sentence, Words, words};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::convert::part_place;
use super::schema::{self, Key, Kind, shortened};
use super::{
    Design, DesignError, GarmentDesign, PartDesign, Problem, VERSION, likely, nearest, template,
};

/// Largest text that is read [bytes]; a whole design is under two thousand.
const SIZE_LIMIT: usize = 1 << 20;

/// Reads a design from the bytes of a file.
///
/// # Errors
/// As [`parse`], and bytes that are not UTF-8.
pub fn parse_bytes(bytes: &[u8], file_name: &str) -> Result<Design, DesignError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => parse(text, file_name),
        Err(error) => {
            let read = &bytes[..error.valid_up_to()];
            Err(DesignError {
                file_name: file_name.to_owned(),
                line: Some(1 + read.iter().filter(|byte| **byte == b'\n').count()),
                place: String::new(),
                problem: Box::new(Problem::NotUtf8),
            })
        }
    }
}

/// Reads a design from text; `file_name` is only named in the sentence.
///
/// # Errors
/// The first thing that is wrong, from the top of the text down; a version that cannot be read
/// comes before everything but broken TOML.
pub fn parse(text: &str, file_name: &str) -> Result<Design, DesignError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let reader = Reader { text, file_name };
    if SIZE_LIMIT < text.len() {
        let problem = Problem::TooLong {
            byte_count: text.len(),
            limit: SIZE_LIMIT,
        };
        return Err(reader.error(0, String::new(), problem));
    }
    let document = DeTable::parse(text).map_err(|error| {
        let start = error.span().map_or(0, |span| span.start);
        reader.error(
            start,
            String::new(),
            Problem::Syntax {
                message: one_line(error.message()),
            },
        )
    })?;
    reader.check_version(document.get_ref())?;

    let mut design = Design::default();
    for (name, value) in in_text_order(document.get_ref()) {
        match name.get_ref().as_ref() {
            "lole" => {}
            schema::LIST => reader.read_garments(name, value, &mut design)?,
            _ => reader.read_table(name, value, &mut design)?,
        }
    }
    design.check_together().map_err(|(table, problem)| {
        let header = document
            .get_ref()
            .iter()
            .find(|(name, _)| name.get_ref() == table);
        let start = header.map_or(0, |(name, _)| name.span().start);
        reader.error(start, format!("[{table}]"), *problem)
    })?;
    Ok(design)
}

/// Says of a text that was read before where a mistake lies that only sewing or dancing found:
/// at the key, else at its table, else at the top.
#[must_use]
pub fn locate(text: &str, file_name: &str, place: Place<'_>, sentence: Sentence) -> DesignError {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let document = DeTable::parse(text)
        .map(Spanned::into_inner)
        .unwrap_or_default();
    let table = document
        .iter()
        .find(|(name, _)| name.get_ref() == place.table);
    let keys = table.and_then(|(_, value)| value.get_ref().as_table());
    let key = keys.and_then(|keys| keys.iter().find(|(name, _)| name.get_ref() == place.key));
    let start = key.map(|(name, _)| name).or(table.map(|(name, _)| name));
    let start = start.map_or(0, |name| name.span().start);
    let place = format!("[{}] {}", place.table, place.key);
    Reader { text, file_name }.error(
        start,
        place.trim_end().to_owned(),
        Problem::Together { sentence },
    )
}

/// A table of the document and one of its keys, which may be empty.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place<'p> {
    /// Name of the table.
    pub table: &'p str,
    /// Name of the key, or nothing.
    pub key: &'p str,
}

type Entry<'d, 'i> = (
    &'d Spanned<toml::de::DeString<'i>>,
    &'d Spanned<DeValue<'i>>,
);

/// Entries from the top of the text down, so that the first mistake is the one reported.
fn in_text_order<'d, 'i>(table: &'d DeTable<'i>) -> Vec<Entry<'d, 'i>> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries
}

struct Reader<'t> {
    text: &'t str,
    file_name: &'t str,
}

impl Reader<'_> {
    fn error(&self, start: usize, place: String, problem: Problem) -> DesignError {
        let read = &self.text.as_bytes()[..start.min(self.text.len())];
        DesignError {
            file_name: self.file_name.to_owned(),
            line: Some(1 + read.iter().filter(|byte| **byte == b'\n').count()),
            place,
            problem: Box::new(problem),
        }
    }

    /// What stands in the text there, short and on one line.
    fn found(&self, span: Range<usize>) -> String {
        shortened(self.text.get(span).unwrap_or_default())
    }

    fn check_version(&self, document: &DeTable<'_>) -> Result<(), DesignError> {
        let Some((name, value)) = document.iter().find(|(name, _)| name.get_ref() == "lole") else {
            return Err(self.error(0, String::new(), Problem::VersionMissing));
        };
        let problem = match value.get_ref().as_integer().map(whole_number) {
            Some(Some(VERSION)) => return Ok(()),
            Some(Some(found)) if VERSION < found => Problem::VersionNewer { found },
            _ => Problem::VersionUnreadable {
                found: self.found(value.span()),
            },
        };
        Err(self.error(name.span().start, "lole".to_owned(), problem))
    }

    fn read_table(
        &self,
        name: &Spanned<toml::de::DeString<'_>>,
        value: &Spanned<DeValue<'_>>,
        design: &mut Design,
    ) -> Result<(), DesignError> {
        let Some(table) = schema::TABLES
            .iter()
            .find(|table| table.name == name.get_ref())
        else {
            let mut names: Vec<_> = schema::TABLES.iter().map(|table| table.name).collect();
            names.push(schema::LIST);
            return Err(self.unknown_table(name, &names));
        };
        let place = format!("[{}]", table.name);
        let mut entries = in_text_order(self.entries(value, &place)?);
        // A school sets what is left out, so it comes first.
        entries.sort_by_key(|(name, _)| name.get_ref() != "school");
        entries.into_iter().try_for_each(|(key, value)| {
            if table.name == "motion" && key.get_ref() == schema::MOTION_PARTS {
                return self.read_parts(key, value, design);
            }
            self.read_key((table.keys, &place), (key, value), design)
        })
    }

    fn unknown_table(&self, name: &Spanned<toml::de::DeString<'_>>, names: &[&str]) -> DesignError {
        let problem = unknown(
            words("表", "table"),
            name.get_ref(),
            names,
            words("使える表は ", "the tables are"),
        );
        let place = format!("[{}]", shortened(name.get_ref()));
        self.error(name.span().start, place, problem)
    }

    /// The entries of what must be a table.
    fn entries<'d, 'i>(
        &self,
        value: &'d Spanned<DeValue<'i>>,
        place: &str,
    ) -> Result<&'d DeTable<'i>, DesignError> {
        value.get_ref().as_table().ok_or_else(|| {
            let wanted = Sentence::new(
                format!("{place} で始まる表"),
                format!("a table that begins with {place}"),
            );
            self.wrong_type(value, place, wanted)
        })
    }

    fn wrong_type(
        &self,
        value: &Spanned<DeValue<'_>>,
        place: &str,
        wanted: Sentence,
    ) -> DesignError {
        let problem = Problem::WrongType {
            found: self.found(value.span()),
            found_type: type_name(value.get_ref()),
            wanted,
        };
        self.error(value.span().start, place.to_owned(), problem)
    }

    /// Reads the list of the parts of a choreography.
    fn read_parts(
        &self,
        name: &Spanned<toml::de::DeString<'_>>,
        value: &Spanned<DeValue<'_>>,
        design: &mut Design,
    ) -> Result<(), DesignError> {
        let wrong_type = |value: &Spanned<DeValue<'_>>, number| {
            let problem = Problem::WrongType {
                found: self.found(value.span()),
                found_type: type_name(value.get_ref()),
                wanted: Sentence::new(
                    "[[motion.part]] で始まる部分",
                    "parts that begin with [[motion.part]] each",
                ),
            };
            self.error(name.span().start, part_place(number, ""), problem)
        };
        let Some(parts) = value.get_ref().as_array() else {
            return Err(wrong_type(value, 1));
        };
        for (number, value) in (1..).zip(parts.iter()) {
            let Some(entries) = value.get_ref().as_table() else {
                return Err(wrong_type(value, number));
            };
            let mut part = PartDesign::default();
            let entries = in_text_order(entries);
            let place = part_place(number, "");
            for &entry in &entries {
                self.read_key((schema::PART_KEYS, &place), entry, &mut part)?;
            }
            if let Some(sentence) = part.cannot_walk(number) {
                let named = (entries.iter()).find(|(name, _)| name.get_ref() == "formation");
                let at = named.map_or(0, |(name, _)| name.span().start);
                let problem = Problem::Together { sentence };
                return Err(self.error(at, part_place(number, "formation"), problem));
            }
            design.motion.parts.push(part);
            design.motion_settings().check().map_err(|error| {
                let start = |key: &str| {
                    let found = entries.iter().find(|(name, _)| name.get_ref() == key);
                    found.map(|(name, _)| name.span().start)
                };
                let key = match error {
                    MotionError::Turn { .. } => "facing_deg",
                    _ => "beat_count",
                };
                let top = entries.first().map_or(0, |(name, _)| name.span().start);
                let sentence = Sentence::of(&error);
                self.error(
                    start(key).unwrap_or(top),
                    part_place(number, key),
                    Problem::Together { sentence },
                )
            })?;
        }
        Ok(())
    }

    /// Reads the list of garments.
    fn read_garments(
        &self,
        name: &Spanned<toml::de::DeString<'_>>,
        value: &Spanned<DeValue<'_>>,
        design: &mut Design,
    ) -> Result<(), DesignError> {
        let place = format!("[[{}]]", schema::LIST);
        let wanted = || {
            Sentence::new(
                format!("服ごとに {place} で始まる表"),
                format!("a table that begins with {place} for each garment"),
            )
        };
        let Some(list) = value.get_ref().as_array() else {
            return Err(self.error(
                name.span().start,
                format!("[{}]", schema::LIST),
                Problem::WrongType {
                    found: format!("[{}]", schema::LIST),
                    found_type: type_name(value.get_ref()),
                    wanted: wanted(),
                },
            ));
        };
        for garment in list {
            let Some(entries) = garment.get_ref().as_table() else {
                return Err(self.wrong_type(garment, &place, wanted()));
            };
            let start = if entries.is_empty() {
                name.span().start
            } else {
                garment.span().start
            };
            let mut read = self.garment_kind(entries, (start, &place))?;
            self.read_garment(entries, &mut read)?;
            design.garments.push(read);
        }
        Ok(())
    }

    /// A garment of the kind that its entries name, as the program would make it.
    fn garment_kind(
        &self,
        entries: &DeTable<'_>,
        (start, place): (usize, &str),
    ) -> Result<GarmentDesign, DesignError> {
        const WHAT: Words = words("服の種類", "kind of garment");
        let ids = schema::kind_ids();
        let choices = ids.join(", ");
        let named = entries.iter().find(|(name, _)| name.get_ref() == "kind");
        let Some((_, value)) = named else {
            let remedy = Sentence::new(
                format!(
                    "kind = \"{}\" のように書いてください（選べるのは {choices}）",
                    ids[0]
                ),
                format!("write kind = \"{}\" (the choices are {choices})", ids[0]),
            );
            let problem = Problem::Missing { what: WHAT, remedy };
            return Err(self.error(start, place.to_owned(), problem));
        };
        let place = format!("{place} kind");
        let Some(id) = value.get_ref().as_str() else {
            let wanted = Sentence::new(
                format!("{}の名前を引用符で囲んだもの（{choices}）", WHAT.japanese),
                format!("the name of a {} in quotes: {choices}", WHAT.english),
            );
            return Err(self.wrong_type(value, &place, wanted));
        };
        match GarmentDesign::of_kind(id) {
            Some(garment) => Ok(garment),
            None => {
                let problem = Problem::UnknownName {
                    found: format!("\"{}\"", shortened(id)),
                    what: WHAT,
                    nearest: nearest(id, &ids).unwrap_or_default().to_owned(),
                    choices,
                };
                Err(self.error(value.span().start, place, problem))
            }
        }
    }

    /// Fills a garment from its entries: its options by the rows of its template, everything else as of any
    /// garment.
    fn read_garment(
        &self,
        entries: &DeTable<'_>,
        worn: &mut GarmentDesign,
    ) -> Result<(), DesignError> {
        let place = format!("[[{}]]", schema::LIST);
        let [own, parts @ ..] = schema::GARMENT else {
            return Ok(());
        };
        let is_gathered = matches!(worn.template.worn, Wear::Gathered(_));
        let fineness = if is_gathered { schema::FINENESS } else { &[] };
        for (name, value) in in_text_order(entries) {
            let key = name.get_ref().as_ref();
            if key == "kind" {
                continue;
            }
            if let Some(position) = worn.template.position(key) {
                let row = &worn.template.options[position];
                let read = template::read(row, value.get_ref(), &self.found(value.span()));
                let read = read.map_err(|problem| {
                    self.error(value.span().start, format!("{place} {key}"), problem)
                })?;
                worn.options.set(position, Some(read));
            } else if let Some(part) = parts.iter().find(|part| part.name == key) {
                let place = format!("[{}.{}]", schema::LIST, part.name);
                for entry in in_text_order(self.entries(value, &place)?) {
                    self.read_key((part.keys, &place), entry, worn)?;
                }
            } else if let Some(keys) = [own.keys, fineness]
                .into_iter()
                .find(|keys| keys.iter().any(|row| row.name == key))
            {
                self.read_key((keys, &place), (name, value), worn)?;
            } else {
                let options = worn.template.options.iter().map(|row| row.key);
                let own = own.keys.iter().map(|row| row.name).chain(options);
                let names: Vec<_> = own.chain(fineness.iter().map(|row| row.name)).collect();
                return Err(self.unknown_key((name, &place), &names));
            }
        }
        Ok(())
    }

    fn unknown_key(
        &self,
        (name, place): (&Spanned<toml::de::DeString<'_>>, &str),
        names: &[&str],
    ) -> DesignError {
        let problem = unknown(
            words("項目", "key"),
            name.get_ref(),
            names,
            words("この表の項目は ", "the keys of this table are"),
        );
        let place = format!("{place} {}", shortened(name.get_ref()));
        self.error(name.span().start, place, problem)
    }

    fn read_key<T>(
        &self,
        (keys, place): (&[Key<T>], &str),
        (name, value): Entry<'_, '_>,
        into: &mut T,
    ) -> Result<(), DesignError> {
        let Some(key) = keys.iter().find(|key| key.name == name.get_ref()) else {
            let names: Vec<_> = keys.iter().map(|key| key.name).collect();
            return Err(self.unknown_key((name, place), &names));
        };
        let place = format!("{place} {}", shortened(name.get_ref()));
        fill(key, value.get_ref(), &self.found(value.span()), into)
            .map_err(|problem| self.error(value.span().start, place, problem))
    }
}

/// Puts a value, written as `found`, where its key belongs.
fn fill<T>(key: &Key<T>, value: &DeValue<'_>, found: &str, design: &mut T) -> Result<(), Problem> {
    let wrong_type = || Problem::WrongType {
        found: found.to_owned(),
        found_type: type_name(value),
        wanted: key.kind.wanted(),
    };
    match &key.kind {
        Kind::Number { set, .. } => {
            let number = number(value).ok_or_else(wrong_type)?;
            key.kind.check_number(number, found)?;
            set(design, number);
        }
        Kind::Count { set, .. } => {
            let integer = value.as_integer().ok_or_else(wrong_type)?;
            let count = whole_number(integer).ok_or_else(|| key.kind.out_of_range(found))?;
            key.kind.check_count(count, found)?;
            set(design, count);
        }
        Kind::Name { set, choices, .. } => {
            let name = named(value, &choices()).ok_or_else(wrong_type)?;
            key.kind.check_name(name)?;
            set(design, name);
        }
        Kind::Text { set, .. } => {
            let text = value.as_str().ok_or_else(wrong_type)?;
            key.kind.check_text(text)?;
            set(design, text);
        }
        Kind::Color { set, .. } => {
            let text = value.as_str().ok_or_else(wrong_type)?;
            set(
                design,
                color(text).ok_or_else(|| Problem::NotColor {
                    found: found.to_owned(),
                    wanted: key.kind.wanted(),
                })?,
            );
        }
    }
    Ok(())
}

/// The name that a value is; where yes and no are to choose from, TOML's own `true` and `false` say them too.
fn named<'a>(value: &'a DeValue<'_>, choices: &[&'a str]) -> Option<&'a str> {
    match value {
        DeValue::Boolean(answer) => {
            let word = if *answer { "yes" } else { "no" };
            choices.iter().find(|choice| **choice == word).copied()
        }
        _ => value.as_str(),
    }
}

/// A number, whole or not; what no `f64` can hold becomes infinite and is then out of range.
pub(super) fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Integer(integer) => {
            let parsed = i64::from_str_radix(integer.as_str(), integer.radix());
            Some(parsed.map_or(f64::INFINITY, |whole| whole as f64))
        }
        DeValue::Float(float) => Some(float.as_str().parse().unwrap_or(f64::NAN)),
        _ => None,
    }
}

/// A whole number that is not negative and fits.
pub(super) fn whole_number(integer: &toml::de::DeInteger<'_>) -> Option<u64> {
    u64::from_str_radix(integer.as_str(), integer.radix()).ok()
}

/// `#rrggbb` as three bytes.
fn color(text: &str) -> Option<[u8; 3]> {
    let digits = text.strip_prefix('#')?;
    if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let [_, red, green, blue] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some([red, green, blue])
}

fn unknown(what: Words, name: &str, names: &[&str], all: Words) -> Problem {
    let remedy = match likely(name, names) {
        Some(choice) => Sentence::new(
            format!("{choice} のことですか"),
            format!("did you mean {choice}?"),
        ),
        None => Sentence::new(
            format!("{}{} です", all.japanese, names.join(", ")),
            format!("{} {}", all.english, names.join(", ")),
        ),
    };
    Problem::Unknown { what, remedy }
}

pub(super) const fn type_name(value: &DeValue<'_>) -> Words {
    match value {
        DeValue::String(_) => words("文字", "a text"),
        DeValue::Integer(_) => words("整数", "a whole number"),
        DeValue::Float(_) => words("小数", "a number with a point"),
        DeValue::Boolean(_) => words("真偽値", "a yes-or-no value"),
        DeValue::Datetime(_) => words("日付", "a date"),
        DeValue::Array(_) => words("リスト", "a list"),
        DeValue::Table(_) => words("表", "a table"),
    }
}

/// The parser's message without its line breaks.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}
