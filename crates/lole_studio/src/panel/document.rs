//! The bar above: the design's file, steps back, the picture, the size of everything, the language.

use std::path::Path;

use eframe::egui::{Align, Button, Label, Layout, RichText, Ui};
use lole_language::Language;

use super::knob::{sign_button, wide_button};
use crate::studio::Request;
use crate::{Studio, text};

/// Narrower bars have signs instead of words [point].
const WORDY: f32 = 760.0;
/// Width of the menu of files [point].
const MENU: f32 = 240.0;
/// Sizes of everything, over the usual one.
const SIZES: [f32; 5] = [1.0, 1.25, 1.5, 1.75, 2.0];

/// Shows it.
pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let is_wordy = WORDY <= ui.available_width();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        ui.spacing_mut().button_padding.x = 9.0;
        ui.menu_button(studio.say(text::FILES), |ui| files(ui, studio));
        if is_wordy {
            words(ui, studio);
        } else {
            signs(ui, studio);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            languages(ui, studio);
            sizes(ui, studio);
            if is_wordy {
                name(ui, studio);
            }
        });
    });
}

/// The menu of files.
fn files(ui: &mut Ui, studio: &mut Studio) {
    ui.set_width(MENU);
    let rows = [
        (text::OPEN, Request::AskOpen),
        (text::SAVE_AS, Request::AskSave),
        (text::PICTURE, Request::Picture),
    ];
    super::start::button(ui, studio);
    for (name, request) in rows {
        if wide_button(ui, studio.say(name)) {
            studio.request(request);
            ui.close();
        }
    }
}

fn words(ui: &mut Ui, studio: &mut Studio) {
    if ui.button(studio.say(text::SAVE)).clicked() {
        studio.request_saving();
    }
    let undo = Button::new(studio.say(text::UNDO));
    if ui.add_enabled(studio.has_past(), undo).clicked() {
        studio.undo();
    }
    let redo = Button::new(studio.say(text::REDO));
    if ui.add_enabled(studio.has_future(), redo).clicked() {
        studio.redo();
    }
}

fn signs(ui: &mut Ui, studio: &mut Studio) {
    if ui.button(studio.say(text::SAVE)).clicked() {
        studio.request_saving();
    }
    ui.add_enabled_ui(studio.has_past(), |ui| {
        if sign_button(ui, "⟲", studio.say(text::UNDO)) {
            studio.undo();
        }
    });
    ui.add_enabled_ui(studio.has_future(), |ui| {
        if sign_button(ui, "⟳", studio.say(text::REDO)) {
            studio.redo();
        }
    });
}

fn name(ui: &mut Ui, studio: &Studio) {
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
    let said = format!("{name} {mark}");
    let label = Label::new(RichText::new(&said).weak()).truncate();
    ui.add(label).on_hover_text(said);
}

/// How large letters and buttons are; `Ctrl` with `+` and `−` does the same.
fn sizes(ui: &mut Ui, studio: &Studio) {
    let now = ui.ctx().zoom_factor();
    let larger = SIZES.into_iter().find(|size| now + 0.01 < *size);
    let smaller = SIZES.into_iter().rfind(|size| *size < now - 0.01);
    ui.add_enabled_ui(larger.is_some(), |ui| {
        if let (true, Some(size)) = (sign_button(ui, "＋", studio.say(text::LARGER_TYPE)), larger)
        {
            ui.ctx().set_zoom_factor(size);
        }
    });
    ui.label(RichText::new(format!("{:.0} %", 100.0 * now)).small())
        .on_hover_text(studio.say(text::SIZE_OF_TYPE));
    ui.add_enabled_ui(smaller.is_some(), |ui| {
        let is_clicked = sign_button(ui, "−", studio.say(text::SMALLER_TYPE));
        if let (true, Some(size)) = (is_clicked, smaller) {
            ui.ctx().set_zoom_factor(size);
        }
    });
}

/// The other language, in its own words.
fn languages(ui: &mut Ui, studio: &mut Studio) {
    let (other, name) = match studio.language {
        Language::Japanese => (Language::English, "English"),
        Language::English => (Language::Japanese, "日本語"),
    };
    if ui.button(name).clicked() {
        studio.language = other;
        studio.memory.language = Some(other);
    }
}
