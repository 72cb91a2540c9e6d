//! The lines of a text without comments, blank lines and line ends, each with its number.

use lole_language::Sentence;

use crate::RecordingError;
use crate::bvh::LARGEST_NUMBER;

pub(super) struct Lines<'a> {
    rest: std::iter::Peekable<Box<dyn Iterator<Item = (usize, &'a str)> + 'a>>,
    /// Number of the line read last, counted from 1.
    pub(super) line: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let lines = text.split(['\n', '\r']);
        // A carriage return before a line feed ends no line of its own.
        let mut line = 1;
        let mut at = 0;
        let numbered = lines.map(move |part| {
            let number = line;
            at += part.len();
            let end = text.as_bytes().get(at..).unwrap_or_default();
            if !end.starts_with(b"\r\n") {
                line += 1;
            }
            at += 1;
            (number, uncommented(part).trim())
        });
        let kept: Box<dyn Iterator<Item = _>> =
            Box::new(numbered.filter(|(_, part)| !part.is_empty()));
        Self {
            rest: kept.peekable(),
            line: 1,
        }
    }

    /// The next line that says something.
    pub(super) fn next(&mut self) -> Option<&'a str> {
        let (line, text) = self.rest.next()?;
        self.line = line;
        Some(text)
    }

    /// The next line, which must be there; `wanted` says what for.
    pub(super) fn expect(&mut self, wanted: &str) -> Result<&'a str, RecordingError> {
        self.next().ok_or_else(|| {
            self.error(
                format!("ファイルがここで終わっています。{wanted} が続くはずです"),
                format!("the file ends here; {wanted} should follow"),
            )
        })
    }

    /// A mistake on the line read last.
    pub(super) fn error(
        &self,
        japanese: impl Into<String>,
        english: impl Into<String>,
    ) -> RecordingError {
        RecordingError::Syntax {
            line: self.line,
            problem: Sentence::new(japanese, english),
        }
    }

    /// A finite number of a sane size.
    pub(super) fn number(&self, word: &str) -> Result<f64, RecordingError> {
        let value = word.parse::<f64>();
        let value = value.or_else(|_| word.replace(',', ".").parse::<f64>());
        match value {
            Ok(value) if value.abs() <= LARGEST_NUMBER => Ok(value),
            Ok(_) => {
                let word = shortened(word);
                Err(self.error(
                    format!("{word} は大きすぎるか、有限の数ではありません"),
                    format!("{word} is too large or no finite number"),
                ))
            }
            Err(_) => {
                let word = shortened(word);
                Err(self.error(
                    format!("「{word}」は数ではありません"),
                    format!("\"{word}\" is not a number"),
                ))
            }
        }
    }
}

fn uncommented(line: &str) -> &str {
    let end = ["#", "//"].iter().filter_map(|mark| line.find(mark)).min();
    &line[..end.unwrap_or(line.len())]
}

/// What stands in the file, short enough for a sentence.
pub(super) fn shortened(word: &str) -> String {
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    word.chars().take(40).map(visible).collect()
}
