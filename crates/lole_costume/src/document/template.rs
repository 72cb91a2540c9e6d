//! Garments of the table of templates in a document: their options are keys, read, checked and written
//! by the rows of [`OptionRow`], so that a new template needs no line here.

use lole_garment::template::{OptionKind, OptionRow, Options, Template};
use lole_language::{Sentence, Words, words};
use toml::de::DeValue;

use super::parse::{number, type_name, whole_number};
use super::schema::{self, shortened};
use super::write::number_text;
use super::{DesignError, GarmentDesign, Problem, nearest};

/// What a choice of a template is called in a sentence.
const WAY: Words = words("選択肢", "choice");

/// What should be written, with its range.
fn wanted(row: &OptionRow) -> Sentence {
    match row.kind {
        OptionKind::Number { min, max, .. } => Sentence::new(
            format!("{min} から {max} までの数"),
            format!("a number from {min} to {max}"),
        ),
        OptionKind::Count { min, max, .. } => Sentence::new(
            format!("{min} から {max} までの整数"),
            format!("a whole number from {min} to {max}"),
        ),
        OptionKind::Choice(_) => {
            let choices = choices(row).join(", ");
            Sentence::new(
                format!("次のどれかを引用符で囲んだもの（{choices}）"),
                format!("one of these in quotes: {choices}"),
            )
        }
    }
}

fn choices(row: &OptionRow) -> Vec<&'static str> {
    match row.kind {
        OptionKind::Choice(choices) => choices.iter().map(|choice| choice.id).collect(),
        OptionKind::Number { .. } | OptionKind::Count { .. } => Vec::new(),
    }
}

/// The value of an option, written as `found`.
pub(super) fn read(row: &OptionRow, value: &DeValue<'_>, found: &str) -> Result<f64, Problem> {
    let wrong_type = || Problem::WrongType {
        found: found.to_owned(),
        found_type: type_name(value),
        wanted: wanted(row),
    };
    let read = match row.kind {
        OptionKind::Number { .. } => number(value).ok_or_else(wrong_type)?,
        OptionKind::Count { .. } => {
            let integer = value.as_integer().ok_or_else(wrong_type)?;
            whole_number(integer).map_or(f64::INFINITY, |whole| whole as f64)
        }
        OptionKind::Choice(_) => {
            let name = value.as_str().ok_or_else(wrong_type)?;
            let choices = choices(row);
            let position = choices.iter().position(|choice| *choice == name);
            let position = position.ok_or_else(|| Problem::UnknownName {
                found: format!("\"{}\"", shortened(name)),
                what: WAY,
                nearest: nearest(name, &choices).unwrap_or_default().to_owned(),
                choices: choices.join(", "),
            })?;
            position as f64
        }
    };
    check_value(row, read, found)?;
    Ok(read)
}

/// Whether a value fits its row.
fn check_value(row: &OptionRow, value: f64, found: &str) -> Result<(), Problem> {
    let fits = match row.kind {
        OptionKind::Number { min, max, .. } => (min..=max).contains(&value),
        OptionKind::Count { min, max, .. } => {
            (f64::from(min)..=f64::from(max)).contains(&value) && value.fract() == 0.0
        }
        OptionKind::Choice(choices) => {
            (0.0..choices.len() as f64).contains(&value) && value.fract() == 0.0
        }
    };
    if fits {
        return Ok(());
    }
    Err(Problem::OutOfRange {
        found: shortened(found),
        wanted: wanted(row),
    })
}

/// Whether every option of a garment that a program made fits.
pub(super) fn check(worn: &GarmentDesign, source: &str) -> Result<(), DesignError> {
    for (position, row) in worn.template.options.iter().enumerate() {
        let checked = match worn.options.get(position) {
            Some(value) => check_value(row, value, &value.to_string()),
            None => Ok(()),
        };
        checked.map_err(|problem| DesignError {
            file_name: source.to_owned(),
            line: None,
            place: format!("[[{}]] {}", schema::LIST, row.key),
            problem: Box::new(problem),
        })?;
    }
    Ok(())
}

/// A line for each option that has a value.
pub(super) fn lines<'a>(
    template: &'static Template,
    options: &'a Options,
) -> impl Iterator<Item = String> + 'a {
    let rows = template.options.iter().enumerate();
    rows.filter_map(move |(position, row)| {
        let value = options.get(position)?;
        let text = match row.kind {
            OptionKind::Number { .. } | OptionKind::Count { .. } => number_text(value),
            OptionKind::Choice(choices) => {
                let chosen = (0..).map(f64::from).zip(choices);
                let chosen = chosen.into_iter().find(|(index, _)| *index == value);
                format!("\"{}\"", chosen?.1.id)
            }
        };
        let about = row.about;
        let names: Vec<String> = match row.kind {
            OptionKind::Choice(choices) => {
                let name = |choice: &lole_garment::template::Choice| {
                    format!(
                        "{}: {}, {}",
                        choice.id, choice.name.japanese, choice.name.english
                    )
                };
                choices.iter().map(name).collect()
            }
            OptionKind::Number { .. } | OptionKind::Count { .. } => Vec::new(),
        };
        let names = if names.is_empty() {
            String::new()
        } else {
            format!(" ({})", names.join("; "))
        };
        Some(format!(
            "{} = {text}  # {}; {}{names}\n",
            row.key, about.japanese, about.english
        ))
    })
}
