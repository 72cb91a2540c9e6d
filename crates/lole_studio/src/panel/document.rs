//! The bar above: the design's file, the picture, the language.

use eframe::egui::{Align, Button, Layout, RichText, Ui};
use lole_language::Language;

use crate::studio::Request;
use crate::{Studio, text};

/// Shows it.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    ui.horizontal(|ui| {
        if ui.button(studio.say(text::OPEN)).clicked() {
            studio.request(Request::AskOpen);
        }
        if ui.button(studio.say(text::SAVE)).clicked() {
            let request = studio.path.clone().map_or(Request::AskSave, Request::Save);
            studio.request(request);
        }
        if ui.button(studio.say(text::SAVE_AS)).clicked() {
            studio.request(Request::AskSave);
        }
        if ui.button(studio.say(text::PICTURE)).clicked() {
            studio.request(Request::Picture);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            languages(ui, studio);
            let name = studio.path.as_ref().and_then(|path| path.file_name());
            let name = name.map_or_else(
                || studio.say(text::UNNAMED).to_owned(),
                |name| name.to_string_lossy().into_owned(),
            );
            let mark = if studio.is_changed() {
                studio.say(text::CHANGED)
            } else {
                ""
            };
            ui.add(
                eframe::egui::Label::new(RichText::new(format!("{name} {mark}")).weak())
                    .truncate(),
            );
        });
    });
}

/// Each language in its own words; the last is the first from the right.
fn languages(ui: &mut Ui, studio: &mut Studio) {
    for (language, name) in [
        (Language::English, "English"),
        (Language::Japanese, "日本語"),
    ] {
        let button = Button::selectable(studio.language == language, name).frame_when_inactive(true);
        if ui.add(button).clicked() {
            studio.language = language;
        }
    }
}
