//! Words that a finished repository does not hold. Each is spelled here in two halves, so that
//! this file keeps its own rule.

use super::TextFile;

/// What must not appear, and why.
const FORBIDDEN: &[(&str, &str)] = &[
    (
        concat!("TO", "DO"),
        "finish it, or write it down where work is planned",
    ),
    (
        concat!("FIX", "ME"),
        "finish it, or write it down where work is planned",
    ),
    (concat!("MEASURE", "_ME"), "put the measured figure here"),
    (concat!("LOREM ", "IPSUM"), "write the text"),
    (
        concat!("/ho", "me/"),
        "a path of one machine helps nobody else",
    ),
    (
        concat!("/ro", "ot/"),
        "a path of one machine helps nobody else",
    ),
    (
        concat!("/wo", "rk/"),
        "a path of one machine helps nobody else",
    ),
    (
        concat!("/Us", "ers/"),
        "a path of one machine helps nobody else",
    ),
    (
        concat!("C:", "\\Users"),
        "a path of one machine helps nobody else",
    ),
    (concat!("\n<<<", "<<<<"), "resolve the conflict"),
    (concat!("\n>>>", ">>>>"), "resolve the conflict"),
];

/// Where the words are read: what people write, not what tools lock.
fn is_written(path: &str) -> bool {
    !path.ends_with(".lock") && !path.ends_with(".json") && !path.ends_with(".js")
}

pub(crate) fn check(files: &[TextFile]) -> Vec<String> {
    let mut findings = Vec::new();
    for file in files.iter().filter(|file| is_written(&file.path)) {
        for (word, remedy) in FORBIDDEN {
            for (start, _) in file.text.match_indices(word) {
                let line = 1
                    + file.text[..start].matches('\n').count()
                    + usize::from(word.starts_with('\n'));
                findings.push(format!("{}:{line}: {:?}: {remedy}", file.path, word.trim()));
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(text: &str) -> Vec<String> {
        check(&[TextFile {
            path: "README.md".to_owned(),
            text: text.to_owned(),
        }])
    }

    #[test]
    fn a_forgotten_word_is_found_with_its_line() {
        assert!(findings("All done.\nWe do this to do that.\n").is_empty());
        let text = concat!("It takes\nMEASURE", "_ME seconds.\n");
        assert!(findings(text)[0].starts_with("README.md:2: "));
        assert_eq!(findings(concat!("a\n<<<", "<<<< ours\n")).len(), 1);
    }
}
