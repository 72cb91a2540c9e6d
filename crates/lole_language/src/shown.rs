//! What a message shows of what was given: little of it, and nothing that a terminal would follow.

/// Letters of what was given that a message repeats, at most.
pub const MOST_REPEATED: usize = 80;
/// Letters of a message, at most: a sentence or two with a path in it.
const LONGEST_MESSAGE: usize = 1200;

/// What was given, as a message repeats it: at most [`MOST_REPEATED`] letters, with `…` for the rest, on one line.
///
/// ```
/// assert_eq!(lole_language::repeated("hula"), "hula");
/// assert_eq!(lole_language::repeated("two\nlines"), "two lines");
/// assert_eq!(lole_language::repeated(&"a".repeat(1000)).chars().count(), 81);
/// ```
#[must_use]
pub fn repeated(given: &str) -> String {
    shortened(given, MOST_REPEATED).replace(['\n', '\r', '\t'], " ")
}

/// A message as it is shown: control characters of what it repeats are made visible, so that no terminal
/// follows them, and words longer than any in a language are cut.
///
/// ```
/// assert_eq!(lole_language::shown("no \u{1b}[2J here"), "no \\u{1b}[2J here");
/// ```
#[must_use]
pub fn shown(message: &str) -> String {
    let words = message.split(' ').map(|word| match word.rfind('/') {
        // Paths are cut in front of the name of their file.
        Some(end) if LONGEST_WORD < word.chars().count() => {
            let (folder, name) = word.split_at(end);
            shortened(folder, LONGEST_WORD / 2) + &shortened(name, LONGEST_WORD / 2)
        }
        _ => shortened(word, LONGEST_WORD),
    });
    shortened(
        &visible(&words.collect::<Vec<_>>().join(" ")),
        LONGEST_MESSAGE,
    )
}

/// A text with its control characters made visible, and marks that turn the direction of what follows; lines
/// and tabs stay.
#[must_use]
pub fn visible(text: &str) -> String {
    let mut seen = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '\n' | '\t' => seen.push(letter),
            _ if is_unseen(letter) => seen.extend(letter.escape_unicode()),
            _ => seen.push(letter),
        }
    }
    seen
}

/// JSON in which the same letters are written as JSON writes them, so that a terminal follows none and a
/// program reads what was there.
///
/// ```
/// assert_eq!(lole_language::visible_json("[\"a\u{202e}\"]"), "[\"a\\u202e\"]");
/// ```
#[must_use]
pub fn visible_json(json: &str) -> String {
    let mut seen = String::with_capacity(json.len());
    for letter in json.chars() {
        match letter {
            // Between values, for people.
            '\n' | '\t' => seen.push(letter),
            // None of them lies beyond the letters of four digits.
            _ if is_unseen(letter) => seen.push_str(&format!("\\u{:04x}", u32::from(letter))),
            _ => seen.push(letter),
        }
    }
    seen
}

/// Letters of a word, at most, a path included.
const LONGEST_WORD: usize = 400;

/// Whether a terminal would follow a letter instead of showing it, or it would turn what stands around it.
#[must_use]
pub fn is_unseen(letter: char) -> bool {
    letter.is_control()
        || matches!(letter, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

fn shortened(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
