//! Sentences over the picture: news, trouble, and cloth that flew apart.

use eframe::egui::{self, Color32, RichText, Ui};
use lole_stage::Divergence;

use crate::message::MessageKind;
use crate::platform;
use crate::studio::Request;
use crate::{Studio, look, text};

/// Shows what there is to say; `ui` is the picture's place.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    if let Some(divergence) = studio.stopped {
        let sentence = flew_apart(studio, &divergence);
        card(ui, look::PALE_RED, |ui| {
            ui.label(RichText::new(sentence).color(look::INK));
            let button = egui::Button::new(
                RichText::new(studio.say(text::RESET))
                    .strong()
                    .color(Color32::WHITE),
            );
            if ui.add(button.fill(look::RED)).clicked() {
                studio.reset();
            }
        });
    }
    found(ui, studio);
    if let Some(message) = studio.message.clone() {
        let fill = match message.kind {
            MessageKind::News => look::CARD,
            MessageKind::Trouble => look::PALE_RED,
        };
        card(ui, fill, |ui| {
            ui.label(studio.tell(&message.sentence));
            ui.horizontal(|ui| {
                if let Some(place) = message.place
                    && platform::HAS_FOLDERS
                    && ui.button(studio.say(text::OPEN_FOLDER)).clicked()
                {
                    studio.request(Request::Reveal(place));
                }
                if ui.button(studio.say(text::CLOSE)).clicked() {
                    studio.message = None;
                }
            });
        });
    }
    if studio.sews && studio.snapshot.is_none() {
        card(ui, look::CARD, |ui| {
            ui.horizontal(|ui| {
                ui.spinner();
                ui.label(studio.say(text::SEWING));
            });
        });
    }
}

/// Offers what a window left behind that ended without saving.
fn found(ui: &mut Ui, studio: &mut Studio) {
    let Some(work) = &studio.found else { return };
    let name = work.name();
    let japanese = format!(
        "前回、保存しないまま終わったデザインがあります（{}）。続きから始めますか？",
        name.as_deref().unwrap_or(text::UNNAMED.japanese)
    );
    let english = format!(
        "A design was left without saving ({}); go on with it?",
        name.as_deref().unwrap_or(text::UNNAMED.english)
    );
    let sentence = studio.language.pick(&japanese, &english).to_owned();
    card(ui, look::CARD, |ui| {
        ui.label(sentence);
        ui.horizontal(|ui| {
            let resume = RichText::new(studio.say(text::RESUME)).color(Color32::WHITE);
            if ui.add(egui::Button::new(resume).fill(look::RED)).clicked() {
                studio.request(Request::Resume);
            }
            if ui.button(studio.say(text::DISCARD)).clicked() {
                studio.request(Request::Discard);
            }
        });
    });
}

fn card(ui: &mut Ui, fill: Color32, contents: impl FnOnce(&mut Ui)) {
    egui::Frame::new()
        .fill(fill)
        .stroke(egui::Stroke::new(1.0, look::LINE))
        .corner_radius(9)
        .inner_margin(12)
        .outer_margin(6)
        .show(ui, |ui| {
            ui.set_max_width(ui.available_width().min(560.0));
            contents(ui);
        });
}

fn flew_apart(studio: &Studio, divergence: &Divergence) -> String {
    let Divergence {
        time, row, column, ..
    } = divergence;
    let method = studio.design().method.name.id();
    let japanese = format!(
        "{time:.2} 秒に、{row} 行 {column} 列から布が飛び散りました（{method}）。「最初から」を押すか、計算方法を変えてください。"
    );
    let english = format!(
        "The cloth flew apart at {time:.2} s, first at row {row}, column {column} ({method}). Press “From the start”, or choose another method."
    );
    studio.language.pick(&japanese, &english).to_owned()
}
