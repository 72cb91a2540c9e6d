//! Lines of a paragraph: English breaks between words, Japanese between letters but for those that
//! may not begin or end a line (JIS X 4051, the basic prohibitions).

use super::typeface::{Weight, text_width};

/// May not begin a line.
const NOT_FIRST: &str = "、。，．・：；？！゛゜ヽヾゝゞ々〻ー－～〜…‥」』）〕］｝〉》】’”ぁぃぅぇぉっゃゅょゎァィゥェォッャュョヮヵヶ%％‰℃㎝㎏°,.:;?!)]}";

/// May not end a line.
const NOT_LAST: &str = "「『（〔［｛〈《【‘“([{¥￥$＄№";

/// Stay on the line of their number.
const UNITS: [&str; 9] = ["cm", "mm", "m", "yd", "in", "g", "kg", "h", "min"];

/// What is counted in Japanese stays on the line of its number too.
const COUNTERS: [&str; 12] = [
    "ヤード",
    "本",
    "枚",
    "個",
    "組",
    "粒",
    "巻き",
    "分",
    "時間",
    "人",
    "周",
    "段",
];

/// Words of katakana are broken only where they are longer than this.
const LONGEST_KATAKANA: usize = 8;

/// Breaks `text` into lines no wider than `width` [mm]; `\n` ends a line. A word longer than a line is
/// broken where it must be, so that nothing is ever wider.
#[must_use]
pub fn wrap(text: &str, weight: Weight, size_pt: f64, width: f64) -> Vec<String> {
    let measure = |text: &str| text_width(text, weight, size_pt);
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for atom in atoms(paragraph) {
            let grown = format!("{line}{atom}");
            if measure(grown.trim_end()) <= width {
                line = grown;
                continue;
            }
            if !line.trim().is_empty() {
                lines.push(line.trim_end().to_owned());
            }
            let atom = atom.trim_start();
            line = if measure(atom.trim_end()) <= width {
                atom.to_owned()
            } else {
                break_by_letters(atom, width, &measure, &mut lines)
            };
        }
        lines.push(line.trim_end().to_owned());
    }
    lines
}

/// Pushes full lines of an atom that is too long for one; returns what is left.
fn break_by_letters(
    atom: &str,
    width: f64,
    measure: &impl Fn(&str) -> f64,
    lines: &mut Vec<String>,
) -> String {
    let mut line = String::new();
    for letter in atom.chars() {
        let mut grown = line.clone();
        grown.push(letter);
        if !line.is_empty() && width < measure(&grown) {
            lines.push(line);
            grown = letter.to_string();
        }
        line = grown;
    }
    line
}

/// The shortest stretches between which a line may end; spaces stand at the end of theirs.
fn atoms(text: &str) -> Vec<&str> {
    let mut atoms = Vec::new();
    let mut start = 0;
    for (index, _) in text.char_indices() {
        if may_break(&text[..index], &text[index..]) {
            atoms.push(&text[start..index]);
            start = index;
        }
    }
    atoms.push(&text[start..]);
    atoms
}

/// Whether a line may end between two parts of a text.
fn may_break(before: &str, after: &str) -> bool {
    let (Some(left), Some(right)) = (before.chars().next_back(), after.chars().next()) else {
        return false;
    };
    if NOT_FIRST.contains(right) || NOT_LAST.contains(left) || right == ' ' {
        return false;
    }
    if left == ' ' {
        let number = before
            .trim_end()
            .ends_with(|end: char| end.is_ascii_digit());
        let word = after
            .split(|letter: char| !letter.is_ascii_alphabetic())
            .next();
        let is_unit = word.is_some_and(|word| UNITS.contains(&word))
            || COUNTERS.iter().any(|counter| after.starts_with(counter));
        return !(number && is_unit);
    }
    if is_katakana(left) && is_katakana(right) {
        let to_left = before.chars().rev().take_while(|one| is_katakana(*one));
        let to_right = after.chars().take_while(|one| is_katakana(*one));
        return LONGEST_KATAKANA < to_left.count() + to_right.count();
    }
    // A number stays with what it counts: 3本, 4段.
    (is_wide(left) || is_wide(right)) && !(left.is_ascii_digit() && is_wide(right))
}

/// Letters of one word: the middle dot parts words.
fn is_katakana(letter: char) -> bool {
    matches!(letter, 'ァ'..='ヺ' | 'ー')
}

/// Letters of an em's width, between which a line may end.
fn is_wide(letter: char) -> bool {
    matches!(letter, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{ff01}'..='\u{ff60}' | '\u{ffe0}'..='\u{ffee}')
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn lines(text: &str, width: f64) -> Vec<String> {
        wrap(text, Weight::Regular, 12.0, width)
    }

    #[test]
    fn japanese_marks_never_begin_or_end_a_line_wrongly() {
        let text = "布を中表に合わせて、「わ」を上にします。ゴムを3本（各76.1 cm）通し、ぬいしろを割ります。";
        for width in 20..90 {
            for line in lines(text, f64::from(width)) {
                let (first, last) = (line.chars().next(), line.chars().next_back());
                assert!(
                    !first.is_some_and(|first| NOT_FIRST.contains(first)),
                    "{width}: {line}"
                );
                assert!(
                    !last.is_some_and(|last| NOT_LAST.contains(last)),
                    "{width}: {line}"
                );
            }
        }
    }

    #[test]
    fn numbers_keep_their_units() {
        for width in 22..80 {
            for line in lines(
                "Cut 3 pieces of 76.1 cm and 4 yd of cloth",
                f64::from(width),
            ) {
                assert!(!line.ends_with("76.1") && !line.ends_with('4'), "{line}");
            }
        }
        assert_eq!(atoms("a 4 yd b"), ["a ", "4 yd ", "b"]);
        assert_eq!(atoms("ゴム3本"), ["ゴム", "3本"]);
        assert_eq!(atoms("布（4.5 ヤード）"), ["布", "（4.5 ヤード）"]);
    }

    #[test]
    fn new_lines_are_kept() {
        assert_eq!(lines("a\n\nb", 50.0), ["a", "", "b"]);
    }

    proptest! {
        #[test]
        fn no_line_is_too_wide_and_nothing_is_lost(text in "[a-zA-Z0-9āʻ、。「」ぁかか漢字 ]{0,60}", width in 8.0..80.0) {
            let lines = lines(&text, width);
            for line in &lines {
                prop_assert!(text_width(line, Weight::Regular, 12.0) <= width + 1e-9, "{line}");
            }
            let dense = |text: &str| text.replace(' ', "");
            prop_assert_eq!(dense(&lines.concat()), dense(&text));
        }
    }
}
