//! Dance, pause, one frame, slow motion, from the beginning.

use eframe::egui::{self, RichText, Ui};

use super::knob::choice;
use crate::{Command, Studio, look, text};

/// Speeds of the buttons, with their names.
const SPEEDS: [(f64, &str); 4] = [(1.0, "×1"), (0.5, "×½"), (0.25, "×¼"), (0.1, "×⅒")];

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let gap = 6.0;
    let third = ((ui.available_width() - 2.0 * gap) / 3.0).max(40.0);
    let size = egui::vec2(third, 38.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        ui.spacing_mut().button_padding.x = 2.0;
        let name = studio.say(if studio.plays {
            text::PAUSE
        } else {
            text::PLAY
        });
        let main = egui::Button::new(RichText::new(name).strong().color(egui::Color32::WHITE))
            .fill(look::RED)
            .min_size(size);
        if ui.add(main).clicked() {
            studio.toggle_playing();
        }
        let step = egui::Button::new(studio.say(text::STEP)).min_size(size);
        if ui.add(step).clicked() {
            studio.step();
        }
        let reset = egui::Button::new(studio.say(text::RESET)).min_size(size);
        if ui.add(reset).clicked() {
            studio.reset();
        }
    });
    ui.horizontal(|ui| {
        ui.label(studio.say(text::SPEED));
        speed(ui, studio);
    });
}

fn speed(ui: &mut Ui, studio: &mut Studio) {
    if let Some(speed) = choice(ui, Some(studio.speed), &SPEEDS) {
        studio.speed = speed;
        studio.command(Command::Speed(speed));
    }
}
