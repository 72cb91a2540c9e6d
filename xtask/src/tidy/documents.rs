//! The documents that must exist, what they must name, where their links lead, and one sentence to
//! a line.

use std::path::Path;

use super::TextFile;

/// Documents a reader looks for.
const REQUIRED: &[&str] = &[
    "README.md",
    "README.ja.md",
    "ARCHITECTURE.md",
    "DESIGN.md",
    "CHANGELOG.md",
    "LICENSE-MIT",
    "LICENSE-APACHE",
    "NOTICE",
];

/// Names every crate.
const ARCHITECTURE: &str = "ARCHITECTURE.md";

pub(crate) fn check(repository: &Path, files: &[TextFile]) -> Vec<String> {
    let mut findings: Vec<String> = REQUIRED
        .iter()
        .filter(|required| !files.iter().any(|file| file.path == **required))
        .map(|required| format!("{required}:1: the document is missing"))
        .collect();
    let architecture = files.iter().find(|file| file.path == ARCHITECTURE);
    let architecture = architecture.map_or("", |file| &file.text);
    for name in files.iter().filter_map(|file| crate_name(&file.path)) {
        if !architecture.contains(&format!("`{name}`")) {
            findings.push(format!("{ARCHITECTURE}:1: no line on the crate `{name}`"));
        }
    }
    for file in files.iter().filter(|file| file.path.ends_with(".md")) {
        findings.extend(crowded_lines(file));
        let exists = |path: &Path| repository.join(path).exists();
        findings.extend(lost_links(file, exists));
    }
    findings
}

/// The crate whose manifest this is.
fn crate_name(path: &str) -> Option<&str> {
    let folder = path.strip_suffix("/Cargo.toml")?;
    match folder.strip_prefix("crates/") {
        Some(name) if !name.contains('/') => Some(name),
        None if folder == "xtask" => Some(folder),
        _ => None,
    }
}

/// Lines of prose with more than one sentence; tables, code and quotations are left alone.
fn crowded_lines(file: &TextFile) -> Vec<String> {
    let mut in_code = false;
    let mut findings = Vec::new();
    for (number, line) in (1..).zip(file.text.lines()) {
        let start = line.trim_start();
        if start.starts_with("```") {
            in_code = !in_code;
        }
        let prose = !in_code && !start.starts_with(['|', '>', '<', '#']);
        if prose && 1 < sentence_count(start) {
            findings.push(format!(
                "{}:{number}: write one sentence to a line",
                file.path
            ));
        }
    }
    findings
}

/// Links and pictures within the repository that lead nowhere.
fn lost_links(file: &TextFile, exists: impl Fn(&Path) -> bool) -> Vec<String> {
    let folder = Path::new(&file.path).parent().unwrap_or(Path::new(""));
    let mut findings = Vec::new();
    for (number, line) in (1..).zip(file.text.lines()) {
        for rest in line.split("](").skip(1) {
            let target = rest.split([')', '#']).next().unwrap_or_default();
            let is_ours = !target.is_empty() && !target.contains(':');
            if is_ours && !exists(&folder.join(target)) {
                findings.push(format!("{}:{number}: there is no {target}", file.path));
            }
        }
    }
    findings
}

/// Sentences: ends followed by a space and a capital letter, or a Japanese full stop with more
/// after it.
fn sentence_count(line: &str) -> usize {
    let letters: Vec<char> = line.chars().collect();
    let breaks = (1..letters.len())
        .filter(|&index| {
            let end = letters[index - 1];
            let (next, after) = (letters[index], letters.get(index + 1).copied());
            let latin = ".!?".contains(end) && next == ' ' && after.is_some_and(char::is_uppercase);
            let abbreviation = 2 <= index && letters[index - 2].is_uppercase();
            (latin && !abbreviation) || (end == '。' && !"」）)*`".contains(next))
        })
        .count();
    1 + breaks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_are_counted_in_both_languages() {
        for (line, count) in [
            ("One sentence.", 1),
            ("One. Two.", 2),
            ("Is it? It is!", 2),
            ("By J. Smith, in 2016.", 1),
            ("version 1.0 of it", 1),
            ("文です。", 1),
            ("文です。もう一つ。", 2),
            ("「文です。」と言う。", 1),
        ] {
            assert_eq!(sentence_count(line), count, "{line}");
        }
    }

    #[test]
    fn links_lead_somewhere() {
        let file = TextFile {
            path: "docs/a.md".to_owned(),
            text: "[b](b.md#part), [here](#part), [web](https://example.org)\n![c](c.png)\n"
                .to_owned(),
        };
        let found = lost_links(&file, |path| path == Path::new("docs/b.md"));
        assert_eq!(found, ["docs/a.md:2: there is no c.png"]);
    }

    #[test]
    fn every_crate_needs_its_line() {
        assert_eq!(crate_name("crates/lole_geom/Cargo.toml"), Some("lole_geom"));
        assert_eq!(crate_name("xtask/Cargo.toml"), Some("xtask"));
        assert_eq!(crate_name("Cargo.toml"), None);
        assert_eq!(crate_name("crates/lole_geom/src/lib.rs"), None);
    }

    #[test]
    fn code_and_tables_may_be_crowded() {
        let text = "```text\nOne. Two.\n```\n| One. Two. |\nOne. Two.\n";
        let file = TextFile {
            path: "a.md".to_owned(),
            text: text.to_owned(),
        };
        assert_eq!(
            crowded_lines(&file),
            ["a.md:5: write one sentence to a line"]
        );
    }
}
