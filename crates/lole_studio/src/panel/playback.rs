//! Dance, pause, one frame, slow motion, from the beginning.

use eframe::egui::{self, RichText, Ui};

use super::knob::choice;
use crate::{Command, Studio, look, text};

/// Speeds of the buttons, with their names.
const SPEEDS: [(f64, &str); 4] = [(1.0, "×1"), (0.5, "×½"), (0.25, "×¼"), (0.1, "×⅒")];

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let gap = ui.spacing().item_spacing.x;
    let half = ((ui.available_width() - gap) / 2.0).max(40.0);
    ui.horizontal(|ui| {
        let name = studio.say(if studio.plays {
            text::PAUSE
        } else {
            text::PLAY
        });
        let main = egui::Button::new(RichText::new(name).strong().color(egui::Color32::WHITE))
            .fill(look::RED)
            .min_size(egui::vec2(half, 38.0));
        if ui.add(main).clicked() {
            studio.toggle_playing();
        }
        let step = egui::Button::new(studio.say(text::STEP)).min_size(egui::vec2(half, 38.0));
        if ui.add(step).clicked() {
            studio.step();
        }
    });
    ui.horizontal(|ui| {
        let width = ui.available_width();
        let reset = egui::Button::new(studio.say(text::RESET)).min_size(egui::vec2(width, 32.0));
        if ui.add(reset).clicked() {
            studio.reset();
        }
    });
    ui.label(studio.say(text::SPEED));
    if let Some(speed) = choice(ui, Some(studio.speed), &SPEEDS) {
        studio.speed = speed;
        studio.command(Command::Speed(speed));
    }
}
