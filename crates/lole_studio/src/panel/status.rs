//! The line below: time of the dance, where cloth has no room, how fast cloth and picture go, what the mouse
//! does.

use eframe::egui::{Align, Label, Layout, RichText, Ui};

use lole_stage::no_room_now;

use crate::{Studio, text};

/// The pace is named where it differs by more than this share.
const NOTICED: f64 = 0.05;

/// Narrower lines say nothing of the mouse [point].
const WITH_HINT: f32 = 820.0;

/// Shows it.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    let parts = parts(studio);
    let small = |part: &String| RichText::new(part).small();
    if ui.available_width() < WITH_HINT {
        ui.add(Label::new(small(&parts.join("   "))).truncate());
        return;
    }
    ui.horizontal(|ui| {
        if studio.sews {
            ui.spinner();
        }
        for part in &parts {
            ui.label(small(part));
            ui.add_space(10.0);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let hint = RichText::new(studio.say(text::HINT)).small().weak();
            ui.add(Label::new(hint).truncate());
        });
    });
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
        let name = studio.say(text::REAL_TIME);
        parts.push(if pace < studio.speed * (1.0 - NOTICED) {
            format!("{name} ×{pace:.2}")
        } else {
            format!("{name} ×{}", studio.speed)
        });
    }
    if let Some(milliseconds) = studio.history.milliseconds() {
        let unit = studio.say(text::MS_PER_FRAME);
        parts.push(format!("{milliseconds:.1} {unit}"));
    }
    if let Some(pictures) = studio.pictures_per_second {
        let unit = studio.say(text::PICTURES_PER_SECOND);
        parts.push(format!("{pictures:.0} {unit}"));
    }
    parts
}
