//! The sentence on what keeps a design from being danced, at the place where it can be mended.

use eframe::egui::{self, RichText, Ui};
use lole_language::Sentence;

use crate::{Studio, look};

/// Shows the sentence if it is about one of these places, such as `[motion]`.
pub(super) fn show(ui: &mut Ui, studio: &Studio, places: &[&str]) {
    let hindrance = studio.hindrance.as_ref();
    let about = |place: &str| places.iter().any(|start| place.starts_with(start));
    if let Some(hindrance) = hindrance.filter(|hindrance| about(&hindrance.place)) {
        sentence(ui, studio, &hindrance.sentence);
    }
}

/// Shows a sentence on what is wrong.
pub(super) fn sentence(ui: &mut Ui, studio: &Studio, sentence: &Sentence) {
    egui::Frame::new()
        .fill(look::PALE_RED)
        .corner_radius(7)
        .inner_margin(8)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.label(
                RichText::new(studio.tell(sentence))
                    .small()
                    .color(look::INK),
            );
        });
}
