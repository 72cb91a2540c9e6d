//! What the self-contained pages share: frame, tables, plots and words in two languages.
//!
//! Everything is in one file. Without scripts both languages show; with them, one.

pub(crate) mod plot;
pub(crate) mod text;

use text::{both, escape};

/// A page; every text but `lole` is HTML.
pub(crate) struct Page<'a> {
    /// Name of the page, the same in both languages.
    pub title: &'a str,
    /// What it is about, in one line.
    pub about: &'a str,
    /// Everything between head and foot.
    pub body: &'a str,
    /// Version of the program, as text.
    pub lole: &'a str,
}

impl Page<'_> {
    /// The whole page.
    pub(crate) fn html(&self) -> String {
        let Self {
            title, about, body, ..
        } = self;
        let lole = escape(self.lole);
        let foot = both(
            &format!(
                "Made by Lole {lole}. Steps and lengths differ between hālau: your kumu’s rule comes first."
            ),
            &format!(
                "Lole {lole} で作成しました。ステップや丈の決まりはハーラウごとに違います。クムの教えを優先してください。"
            ),
        );
        format!(
            "<!doctype html>\n<html lang=\"ja\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n\
             <title>{title} – Lole</title>\n<style>{style}</style>\n</head>\n<body>\n\
             <header><div><h1>{title}</h1><p class=\"where\">{about}</p></div>\
             <div class=\"language\"><button type=\"button\" data-set=\"ja\" lang=\"ja-JP\">日本語</button>\
             <button type=\"button\" data-set=\"en\" lang=\"en-US\">English</button></div></header>\n\
             <main>\n{body}</main>\n<footer><p>{foot}</p></footer>\n<script>{script}</script>\n\
             </body>\n</html>\n",
            style = include_str!("page/page.css"),
            script = include_str!("page/page.js"),
        )
    }
}

/// A line of a table: its name, its value and what it means, each as HTML.
pub(crate) struct Row {
    name: String,
    value: String,
    why: String,
}

/// A line of a table: name, value as HTML, and what it means (may be empty), each English first.
pub(crate) fn row(
    [name_en, name_ja]: [&str; 2],
    value: String,
    [why_en, why_ja]: [&str; 2],
) -> Row {
    let why = if why_en.is_empty() {
        String::new()
    } else {
        both(why_en, why_ja)
    };
    Row {
        name: both(name_en, name_ja),
        value,
        why,
    }
}

/// A heading, what it is about (may be empty) and its table.
pub(crate) fn section(title: [&str; 2], about: [&str; 2], rows: &[Row]) -> String {
    let rows: String = rows
        .iter()
        .map(|row| {
            format!(
                "<tr><th scope=\"row\">{}</th><td class=\"value\">{}</td><td class=\"why\">{}</td></tr>\n",
                row.name, row.value, row.why,
            )
        })
        .collect();
    let about = if about[0].is_empty() {
        String::new()
    } else {
        format!("<p class=\"note\">{}</p>\n", both(about[0], about[1]))
    };
    format!(
        "<h2>{}</h2>\n{about}<table><tbody>\n{rows}</tbody></table>\n",
        both(title[0], title[1])
    )
}

/// A heading and a note below it.
pub(crate) fn heading(english: &str, japanese: &str, note: [&str; 2]) -> String {
    format!(
        "<h2>{}</h2>\n<p class=\"note\">{}</p>\n",
        both(english, japanese),
        both(note[0], note[1])
    )
}

/// A table with a head line; cells are HTML.
pub(crate) fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let cells = |tag: &str, cells: &[String]| -> String {
        cells
            .iter()
            .map(|cell| format!("<{tag}>{cell}</{tag}>"))
            .collect()
    };
    let rows: String = rows
        .iter()
        .map(|row| format!("<tr>{}</tr>\n", cells("td", row)))
        .collect();
    format!(
        "<div class=\"wide\"><table><thead><tr>{}</tr></thead>\n{rows}</table></div>\n",
        cells("th", head)
    )
}
