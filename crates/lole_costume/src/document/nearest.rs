//! Offers the word a typist most likely meant.

/// Letters that make a part of a word worth recognizing: "silk" or "hem", not "e".
const PART_LENGTH: usize = 3;

/// The choice most like `word`; `None` only when there are no choices.
///
/// A choice that has the whole word in it comes first ("broadcloth" means polycotton-broadcloth),
/// then the smallest edit distance, with swapped neighbors as one edit, to it or to a word of it,
/// then the order of the choices.
#[must_use]
pub fn nearest<'a>(word: &str, choices: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    choices.iter().copied().min_by_key(|choice| {
        (
            !is_part(&word, choice),
            names(choice)
                .map(|name| strsim::damerau_levenshtein(&word, name))
                .min(),
            strsim::damerau_levenshtein(&word, choice),
        )
    })
}

/// Like [`nearest`], but only when more than half of the letters agree or it has the word in it.
#[must_use]
pub fn likely<'a>(word: &str, choices: &[&'a str]) -> Option<&'a str> {
    let choice = nearest(word, choices)?;
    let word = word.to_lowercase();
    let likeness = names(choice)
        .map(|name| strsim::normalized_damerau_levenshtein(&word, name))
        .fold(0.0, f64::max);
    (is_part(&word, choice) || 0.5 < likeness).then_some(choice)
}

/// A choice, and the words it is made of: "coton" means cotton-lawn.
fn names(choice: &str) -> impl Iterator<Item = &str> {
    std::iter::once(choice).chain(choice.split('-').filter(|name| PART_LENGTH <= name.len()))
}

fn is_part(word: &str, choice: &str) -> bool {
    PART_LENGTH <= word.len() && choice.contains(word)
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
        let fabrics = ["barkcloth", "polycotton-broadcloth"];
        assert_eq!(
            nearest("broadcloth", &fabrics),
            Some("polycotton-broadcloth")
        );
        let cottons = ["chiffon", "cotton-lawn", "cotton-sheeting"];
        assert_eq!(nearest("coton", &cottons), Some("cotton-lawn"));
        assert_eq!(likely("coton", &cottons), Some("cotton-lawn"));
        assert_eq!(likely("waltz", &steps), None);
        assert_eq!(nearest("waltz", &[]), None);
    }
}
