//! What tells the sheets of one design, dancer and version from those of all others, and a code of it that
//! telephones read.

use lole_body::Measurements;
use lole_costume::document::{Design, to_toml};
use lole_language::Language;
use qrcodegen::{QrCode, QrCodeEcc};

use crate::pdf::{Align, Color, Rect, Sheet, Stroke, TextStyle};

/// Written on every sheet of a pattern.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Stamp {
    /// What the design is called.
    pub title: String,
    /// Girths that the dancer was drafted by, taken or estimated, such as `B 87 W 75 H 95`.
    pub size: String,
    /// Eight digits that differ where anything of the design or the program's version differs; empty for none.
    pub id: String,
}

impl Stamp {
    /// The stamp of a design of this name.
    #[must_use]
    pub fn of(title: &str, design: &Design) -> Self {
        // A tape that makes no body has no pattern either; an avatar's is not known here.
        let body = Measurements::from_tape(&design.tape()).ok();
        let body = body.filter(|_| design.dancer.file.is_none());
        let girths = body.map(|body| {
            [
                ("B", body.bust_girth),
                ("W", body.waist_girth),
                ("H", body.hip_girth),
            ]
        });
        let drafted = girths.into_iter().flatten().map(|(letter, girth)| {
            let cm = (10.0 * girth.to_cm()).round() / 10.0;
            format!("{letter} {cm}")
        });
        let size: Vec<String> = drafted.collect();
        let whole = format!("{} {}", env!("CARGO_PKG_VERSION"), to_toml(design));
        let hash = lole_geom::fnv::hash(whole.into_bytes());
        // Both halves, so that no digit of the hash is without effect.
        let digits = format!("{:08X}", (hash >> 32) ^ (hash & 0xffff_ffff));
        let (first, second) = digits.split_at(4);
        Self {
            title: title.to_owned(),
            size: size.join(" "),
            id: format!("{first}-{second}"),
        }
    }

    /// Size and id, as they stand at the foot of a sheet.
    pub(super) fn words(&self) -> String {
        let parts = [self.size.as_str(), self.id.as_str()];
        let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        parts.join(" · ")
    }

    /// What the code says: program, id, document, dancer, size.
    pub(super) fn code(&self, owner: &str) -> String {
        let parts = [
            "Lole",
            env!("CARGO_PKG_VERSION"),
            &self.id,
            &self.title,
            owner,
            &self.size,
        ];
        let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        parts.join(" ")
    }

    /// Draws the code with what it says beside it; nothing where there is no id.
    pub(super) fn draw(&self, sheet: &mut Sheet, [x, y]: [f64; 2], owner: &str) {
        if self.id.is_empty() {
            return;
        }
        // What is too long for a code has its id alone.
        let code = QrCode::encode_text(&self.code(owner), QrCodeEcc::Medium)
            .or_else(|_| QrCode::encode_text(&self.id, QrCodeEcc::Medium));
        let Ok(code) = code else { return };
        let module = CODE / f64::from(code.size());
        let mut path = kurbo::BezPath::new();
        for row in 0..code.size() {
            for column in 0..code.size() {
                if code.get_module(column, row) {
                    let dark = Rect {
                        x: x + module * f64::from(column),
                        y: y + module * f64::from(row),
                        width: module,
                        height: module,
                    };
                    path.extend(dark.to_path());
                }
            }
        }
        sheet.path(path, Some(Color::BLACK), None);
        let said = [owner, &self.title, &self.size, &self.id];
        let said = said.into_iter().filter(|words| !words.is_empty());
        for (row, words) in (0_u32..).zip(said) {
            let at = [x + CODE + 3.5, y + 4.0 + 5.5 * f64::from(row)];
            sheet.text(at, words, &TextStyle::regular(10.0), Align::Left);
        }
    }
}

/// Side of a code on paper [mm].
pub(super) const CODE: f64 = 21.0;

/// A bar of five centimeters at the foot of a sheet, to measure whether it was printed at its size.
pub(super) fn draw_bar(sheet: &mut Sheet, [x, y]: [f64; 2], language: Language) {
    const LONG: f64 = 50.0;
    let stroke = Stroke::solid(0.3);
    sheet.line([x, y], [x + LONG, y], stroke.clone());
    let mut tick = 0_u32;
    while tick <= 5 {
        let at = x + 10.0 * f64::from(tick);
        let rise = if tick == 0 || tick == 5 { 2.2 } else { 1.2 };
        sheet.line([at, y], [at, y - rise], stroke.clone());
        tick += 1;
    }
    let words = language.pick("ここが 5 cm", "this is 5 cm");
    sheet.text(
        [x + 0.5 * LONG, y + 2.9],
        words,
        &TextStyle::regular(7.0),
        Align::Center,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_differs_in_a_design_changes_its_id() {
        let design = Design::default();
        let stamp = Stamp::of("a", &design);
        assert_eq!(stamp, Stamp::of("a", &design));
        assert_eq!(stamp.id.len(), 9);
        let mut other = design.clone();
        other.dancer.hip_cm = Some(91.4);
        let other = Stamp::of("a", &other);
        assert_ne!(stamp.id, other.id);
        assert!(other.size.starts_with("B ") && other.size.ends_with(" H 91.4"));
        assert!(
            other
                .code("花子")
                .ends_with(&format!("{} a 花子 {}", other.id, other.size))
        );
    }
}
