//! Offers the word a typist most likely meant.

/// The choice most like `word`; `None` only when there are no choices.
///
/// Likeness is edit distance with swapped neighbors as one edit, ties broken by the order of the
/// choices.
#[must_use]
pub fn nearest<'a>(word: &str, choices: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    choices
        .iter()
        .copied()
        .min_by_key(|choice| strsim::damerau_levenshtein(&word, choice))
}

/// Like [`nearest`], but only when more than half of the letters agree.
#[must_use]
pub fn likely<'a>(word: &str, choices: &[&'a str]) -> Option<&'a str> {
    let choice = nearest(word, choices)?;
    let likeness = strsim::normalized_damerau_levenshtein(&word.to_lowercase(), choice);
    (0.5 < likeness).then_some(choice)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_slip_of_the_finger_is_undone() {
        let steps = ["kao", "kaholo", "ami", "uwehe"];
        for (typed, meant) in [
            ("kahollo", "kaholo"),
            ("khaolo", "kaholo"),
            ("KAHOLO", "kaholo"),
            ("uwhee", "uwehe"),
            ("amy", "ami"),
        ] {
            assert_eq!(nearest(typed, &steps), Some(meant));
            assert_eq!(likely(typed, &steps), Some(meant));
        }
        assert_eq!(likely("waltz", &steps), None);
        assert_eq!(nearest("waltz", &[]), None);
    }
}
