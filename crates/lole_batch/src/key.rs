//! One key of a document, as a sweep names it: `skirt.gather_ratio`, `garment.2.length_cm`.

use lole_language::Sentence;
use toml::{Table, Value};

/// Where a value goes in a document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct KeyPath {
    /// As it was written.
    pub(crate) name: String,
    steps: Vec<Step>,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Step {
    Key(String),
    /// Place in a list, counted from 0.
    Place(usize),
}

impl KeyPath {
    /// Reads a path: keys with points between them, and the places of a list counted from 1.
    pub(crate) fn read(name: &str) -> Result<Self, Sentence> {
        let refused = || {
            Sentence::new(
                format!(
                    "{name}: キーの書き方が違います。skirt.gather_ratio や garment.1.ease_cm のように書いてください"
                ),
                format!(
                    "{name}: this names no key; write it as skirt.gather_ratio, or garment.1.ease_cm for the first of a list"
                ),
            )
        };
        let is_word = |word: &str| {
            !word.is_empty()
                && word
                    .chars()
                    .all(|letter| letter.is_ascii_alphanumeric() || "_-".contains(letter))
        };
        let mut steps = Vec::new();
        for word in name.split('.') {
            let number = word.parse::<usize>();
            steps.push(match number {
                Ok(number) if 0 < number && !steps.is_empty() => Step::Place(number - 1),
                Ok(_) => return Err(refused()),
                _ if is_word(word) => Step::Key(word.to_owned()),
                _ => return Err(refused()),
            });
        }
        let ends_in_key = matches!(steps.last(), Some(Step::Key(_)));
        if steps.len() < 2 || !ends_in_key {
            return Err(refused());
        }
        Ok(Self {
            name: name.to_owned(),
            steps,
        })
    }

    /// Puts a value there; tables that are missing come to be, places of a list do not.
    pub(crate) fn put(&self, document: &mut Table, value: Value) -> Result<(), Sentence> {
        let Some((Step::Key(last), way)) = self.steps.split_last() else {
            return Err(self.nowhere());
        };
        let Some((Step::Key(first), way)) = way.split_first() else {
            return Err(self.nowhere());
        };
        let mut here =
            (document.entry(first.clone())).or_insert_with(|| Value::Table(Table::new()));
        for step in way {
            here = match (step, here) {
                (Step::Place(place), Value::Array(list)) => list.get_mut(*place),
                (Step::Key(key), Value::Table(table)) => {
                    Some((table.entry(key.clone())).or_insert_with(|| Value::Table(Table::new())))
                }
                _ => None,
            }
            .ok_or_else(|| self.nowhere())?;
        }
        let table = here.as_table_mut().ok_or_else(|| self.nowhere())?;
        table.insert(last.clone(), value);
        Ok(())
    }

    fn nowhere(&self) -> Sentence {
        let name = &self.name;
        Sentence::new(
            format!(
                "{name}: デザインにそのような場所がありません。リストは garment.1 から数えます"
            ),
            format!(
                "{name}: the design has no such place; a garment of its list is named by its number, from garment.1 on"
            ),
        )
    }
}

/// Puts a value where a path such as `skirt.gather_ratio` or `garment.1.fabric.preset` names it.
///
/// # Errors
/// One sentence: the path names no key, or no place of the list.
pub fn put(document: &mut Table, path: &str, value: Value) -> Result<(), Sentence> {
    KeyPath::read(path)?.put(document, value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_puts_its_value_where_the_document_reads_it() {
        let text = "lole = 1\n[[garment]]\nkind = \"lei\"\n[[garment]]\nkind = \"blouse\"\n";
        let mut document: Table = text.parse().unwrap();
        for (path, value) in [
            ("garment.2.fabric.preset", "lawn"),
            ("print.colorway", "blue"),
        ] {
            let path = KeyPath::read(path).unwrap();
            path.put(&mut document, Value::from(value)).unwrap();
        }
        let garments = document["garment"].as_array().unwrap();
        assert_eq!(garments[1]["fabric"]["preset"].as_str(), Some("lawn"));
        assert_eq!(document["print"]["colorway"].as_str(), Some("blue"));
    }

    #[test]
    fn what_names_no_key_is_refused() {
        for name in [
            "",
            ".",
            "skirt",
            "skirt.",
            "garment.0.x",
            "garment.1",
            "a b.c",
            "1.x",
            "ski\u{0}rt.x",
        ] {
            assert!(KeyPath::read(name).is_err(), "{name}");
        }
        let mut document = Table::new();
        let beyond = KeyPath::read("garment.3.ease_cm").unwrap();
        assert!(beyond.put(&mut document, Value::from(1)).is_err());
    }
}
