//! The bar above: the design's file, the picture, the language.

use std::path::Path;

use eframe::egui::{Align, Button, Label, Layout, RichText, Ui};
use lole_language::Language;

use crate::studio::Request;
use crate::{Studio, text};

/// Narrower bars take two lines [point].
const ONE_LINE: f32 = 860.0;

/// Shows it.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    if ui.available_width() < ONE_LINE {
        ui.horizontal(|ui| rest(ui, studio));
        ui.horizontal_wrapped(|ui| files(ui, studio));
    } else {
        ui.horizontal(|ui| {
            files(ui, studio);
            rest(ui, studio);
        });
    }
}

fn files(ui: &mut Ui, studio: &mut Studio) {
    if ui.button(studio.say(text::OPEN)).clicked() {
        studio.request(Request::AskOpen);
    }
    if ui.button(studio.say(text::SAVE)).clicked() {
        studio.request_saving();
    }
    if ui.button(studio.say(text::SAVE_AS)).clicked() {
        studio.request(Request::AskSave);
    }
    let undo = Button::new(studio.say(text::UNDO));
    if ui.add_enabled(studio.has_past(), undo).clicked() {
        studio.undo();
    }
    let redo = Button::new(studio.say(text::REDO));
    if ui.add_enabled(studio.has_future(), redo).clicked() {
        studio.redo();
    }
    if ui.button(studio.say(text::PICTURE)).clicked() {
        studio.request(Request::Picture);
    }
}

/// What stands at the right: the languages, and the design's name before them.
fn rest(ui: &mut Ui, studio: &mut Studio) {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        languages(ui, studio);
        let name = studio.path().and_then(Path::file_name);
        let name = name.map_or_else(
            || studio.say(text::UNNAMED).to_owned(),
            |name| name.to_string_lossy().into_owned(),
        );
        let mark = if studio.is_changed() {
            studio.say(text::CHANGED)
        } else {
            ""
        };
        let name = RichText::new(format!("{name} {mark}")).weak();
        ui.add(Label::new(name).truncate());
    });
}

/// Each language in its own words; the last is the first from the right.
fn languages(ui: &mut Ui, studio: &mut Studio) {
    for (language, name) in [
        (Language::English, "English"),
        (Language::Japanese, "日本語"),
    ] {
        let button =
            Button::selectable(studio.language == language, name).frame_when_inactive(true);
        if ui.add(button).clicked() {
            studio.language = language;
        }
    }
}
