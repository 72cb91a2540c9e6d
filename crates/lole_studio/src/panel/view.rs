//! Where she is seen from, and what dragging does.

use eframe::egui::Ui;

use super::knob::choice;
use crate::orbit::VIEWS;
use crate::studio::Tool;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let names = [text::FRONT, text::SIDE, text::BACK, text::THREE_QUARTER];
    let options: Vec<_> = (VIEWS.iter().copied())
        .zip(names.map(|name| studio.say(name)))
        .collect();
    let chosen = studio.orbit.and_then(|orbit| orbit.view);
    if let Some(view) = choice(ui, chosen, &options) {
        studio.wanted_view = Some(view);
    }
    ui.label(studio.say(text::DRAG_DOES));
    let tools = [
        (Tool::Hold, studio.say(text::HOLDS)),
        (Tool::Turn, studio.say(text::TURNS)),
    ];
    if let Some(tool) = choice(ui, Some(studio.tool), &tools) {
        studio.tool = tool;
    }
}
