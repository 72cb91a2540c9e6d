//! Words and numbers of the page: escaping, units, and every sentence twice.

use lole_language::visible;

/// Text with the five characters that HTML gives a meaning spelled out, safe inside elements and
/// quoted attributes, and with marks made visible that would turn what stands around it.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in visible(text).chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// A file name as a relative link: everything but letters, digits and `-._` in percent codes.
pub(crate) fn link(name: &str) -> String {
    use std::fmt::Write as _;
    name.bytes().fold(String::from("./"), |mut link, byte| {
        if byte.is_ascii_alphanumeric() || b"-._".contains(&byte) {
            link.push(char::from(byte));
        } else if write!(link, "%{byte:02X}").is_err() {
            // Writing to a String cannot fail.
            link.push('_');
        }
        link
    })
}

/// The same words in English and in Japanese; the page shows one of them. Both are HTML.
pub(crate) fn both(english: &str, japanese: &str) -> String {
    format!("<span lang=\"en\">{english}</span><span lang=\"ja\">{japanese}</span>")
}

/// A number with fixed decimals, a dash where it is not finite.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    if value.is_finite() {
        format!("{value:.decimals$}")
    } else {
        "–".into()
    }
}

/// A whole number in groups of three.
pub(crate) fn grouped(value: usize) -> String {
    let digits = value.to_string();
    let first = digits.len() % 3;
    let mut groups: Vec<&str> = Vec::new();
    if 0 < first {
        groups.push(&digits[..first]);
    }
    groups.extend(
        (first..digits.len())
            .step_by(3)
            .map(|start| &digits[start..start + 3]),
    );
    groups.join(",")
}

/// A file size in words.
pub(crate) fn file_size(bytes: u64) -> String {
    #[expect(clippy::cast_precision_loss, reason = "shown with one decimal")]
    let bytes_shown = bytes as f64;
    if bytes < 1000 {
        format!("{bytes} B")
    } else if bytes < 1_000_000 {
        format!("{:.0} kB", bytes_shown / 1e3)
    } else {
        format!("{:.1} MB", bytes_shown / 1e6)
    }
}

/// A dance step's name as it is written in Hawaiian; unknown names stay as they are.
pub(crate) fn dance_step(name: &str) -> String {
    match name {
        "kao" => "Kaʻo".into(),
        "kaholo" => "kāholo".into(),
        "ami" => "ʻami".into(),
        "uwehe" => "ʻuwehe".into(),
        other => escape(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_escapes_into_markup() {
        assert_eq!(escape("<b a='\"'>&"), "&lt;b a=&#39;&quot;&#39;&gt;&amp;");
        assert_eq!(link("a b\"/../<x>.glb"), "./a%20b%22%2F..%2F%3Cx%3E.glb");
    }

    #[test]
    fn numbers_read_well() {
        let cases = [(0, "0"), (999, "999"), (1000, "1,000"), (25_600, "25,600")];
        for (value, text) in cases {
            assert_eq!(grouped(value), text);
        }
        assert_eq!(number(f64::NAN, 1), "–");
        assert_eq!(number(3.2004, 2), "3.20");
    }
}
