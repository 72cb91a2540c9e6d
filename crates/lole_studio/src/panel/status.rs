//! The line below: time of the dance, where cloth has no room, whether the dance keeps pace, the door
//! to what researchers look at.

use eframe::egui::{Align, Button, Label, Layout, RichText, Ui};

use lole_stage::no_room_now;

use crate::{Studio, text};

/// The pace is named where it differs by more than this share.
const NOTICED: f64 = 0.05;

/// Narrower lines say nothing of the mouse [point].
const WITH_HINT: f32 = 1000.0;

/// Shows it.
pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let has_hint = WITH_HINT <= ui.available_width();
    let line = |ui: &mut Ui| {
        let name = RichText::new(studio.say(text::FOR_RESEARCHERS)).small();
        let door = Button::selectable(studio.researches, name).frame_when_inactive(true);
        if ui.add(door).clicked() {
            studio.researches = !studio.researches;
        }
        if has_hint {
            ui.label(RichText::new(studio.say(text::HINT)).small().weak());
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            if studio.sews {
                ui.spinner();
            }
            let said = RichText::new(parts(studio).join("   ")).small();
            ui.add(Label::new(said).wrap());
        });
    };
    ui.horizontal(|ui| ui.with_layout(Layout::right_to_left(Align::Center), line));
}

fn parts(studio: &Studio) -> Vec<String> {
    let mut parts = Vec::new();
    let Some(snapshot) = &studio.snapshot else {
        return vec![studio.say(text::SEWING).to_owned()];
    };
    parts.push(if snapshot.time < 0.0 {
        studio.say(text::SETTLING).to_owned()
    } else {
        format!("{:.1} {}", snapshot.time, studio.say(text::SECONDS))
    });
    if studio.sews {
        parts.push(studio.say(text::SEWING).to_owned());
    }
    // As long as it is so, and no longer.
    if let Some(sentence) = no_room_now(&snapshot.without_room) {
        parts.push(studio.tell(&sentence));
    }
    if let Some(pace) = snapshot.pace {
        let name = studio.say(text::PACE);
        parts.push(if pace < studio.speed * (1.0 - NOTICED) {
            format!("{name} ×{pace:.2}")
        } else {
            format!("{name} ×{}", studio.speed)
        });
    }
    parts
}
