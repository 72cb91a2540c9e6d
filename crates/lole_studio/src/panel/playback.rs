//! Below the picture: dance, pause, from the beginning, slow motion; from where she is seen, and
//! what dragging does.

use eframe::egui::{self, ComboBox, RichText, Ui};

use super::again;
use super::knob::loose_choice;
use crate::orbit::VIEWS;
use crate::studio::Tool;
use crate::{Command, Studio, look, text};

/// Speeds of the buttons, with their names.
const SPEEDS: [(f64, &str); 4] = [(1.0, "×1"), (0.5, "×½"), (0.25, "×¼"), (0.1, "×⅒")];
/// Narrower bars leave out what can be done without [point].
const ROOMY: f32 = 440.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    again::show(ui, studio);
    let is_roomy = ROOMY <= ui.available_width();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(5.0, 5.0);
        ui.spacing_mut().button_padding.x = 9.0;
        play(ui, studio);
        ui.add_space(6.0);
        views(ui, studio);
        if is_roomy {
            ui.add_space(6.0);
            tools(ui, studio);
            ui.add_space(6.0);
            speed(ui, studio);
        }
    });
}

fn play(ui: &mut Ui, studio: &mut Studio) {
    let name = studio.say(if studio.moves() {
        text::PAUSE
    } else {
        text::PLAY
    });
    let height = ui.spacing().interact_size.y;
    let main = egui::Button::new(RichText::new(name).strong().color(egui::Color32::WHITE))
        .fill(look::RED)
        .min_size(egui::vec2(76.0, height));
    if ui.add(main).clicked() {
        studio.toggle_playing();
    }
    if ui.button(studio.say(text::RESET)).clicked() {
        studio.reset();
    }
    if ui.button(studio.say(text::STEP)).clicked() {
        studio.step();
    }
}

/// A list of speeds that drops down.
fn speed(ui: &mut Ui, studio: &mut Studio) {
    let label = ui.label(studio.say(text::SPEED));
    let mut chosen = studio.speed;
    let is_chosen = |(speed, _): &&(f64, &str)| (*speed - chosen).abs() < 1e-9;
    let said = SPEEDS.iter().find(is_chosen).map_or("", |(_, name)| *name);
    ComboBox::from_id_salt("speed")
        .width(64.0)
        .selected_text(said)
        .show_ui(ui, |ui| {
            for (speed, name) in SPEEDS {
                ui.selectable_value(&mut chosen, speed, name);
            }
        })
        .response
        .labelled_by(label.id);
    if 1e-9 < (chosen - studio.speed).abs() {
        studio.speed = chosen;
        studio.command(Command::Speed(chosen));
    }
}

fn views(ui: &mut Ui, studio: &mut Studio) {
    let names = [text::FRONT, text::SIDE, text::BACK, text::THREE_QUARTER];
    let options: Vec<_> = (VIEWS.iter().copied())
        .zip(names.map(|name| studio.say(name)))
        .collect();
    let chosen = studio.orbit.and_then(|orbit| orbit.view);
    if let Some(view) = loose_choice(ui, chosen, &options) {
        studio.wanted_view = Some(view);
    }
}

fn tools(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::DRAG_DOES));
    let tools = [
        (Tool::Hold, studio.say(text::HOLDS)),
        (Tool::Turn, studio.say(text::TURNS)),
    ];
    if let Some(tool) = loose_choice(ui, Some(studio.tool), &tools) {
        studio.tool = tool;
    }
}
