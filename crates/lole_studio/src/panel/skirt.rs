//! The cut of the skirt and the body beneath it.

use eframe::egui::{RichText, Ui};

use super::knob::{Knob, Scale};
use crate::studio::range;
use crate::{Studio, text};

/// The hem slider's ends [cm]: ankle and knee, and a little more.
const HEMS: [f64; 2] = [5.0, 60.0];

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let (low, high) = range("skirt", "gather_ratio");
    let gather = Knob {
        name: studio.say(text::GATHER),
        range: low.max(1.5)..=high,
        decimals: 1,
        unit: "×",
        scale: Scale::Even,
    };
    if let (_, Some(ratio)) = gather.show(ui, studio.design().skirt.gather_ratio) {
        studio.change_later(|design| design.skirt.gather_ratio = (ratio * 10.0).round() / 10.0);
    }
    let (low, high) = range("skirt", "hem_height_cm");
    let hem = Knob {
        name: studio.say(text::HEM),
        range: low.max(HEMS[0])..=high.min(HEMS[1]),
        decimals: 0,
        unit: " cm",
        scale: Scale::Even,
    };
    if let (_, Some(height)) = hem.show(ui, studio.design().skirt.hem_height_cm) {
        studio.change_later(|design| design.skirt.hem_height_cm = height.round());
    }
    if studio.sews {
        ui.horizontal(|ui| {
            ui.spinner();
            ui.label(studio.say(text::SEWING));
        });
    } else {
        ui.label(RichText::new(studio.say(text::SEWS_ANEW)).small().weak());
    }
    let (low, high) = range("method", "capsule_count");
    let capsules = Knob {
        name: studio.say(text::CAPSULES_COUNT),
        range: low..=high,
        decimals: 0,
        unit: "",
        scale: Scale::Even,
    };
    let now = f64::from(studio.design().method.capsule_count);
    if let (_, Some(count)) = capsules.show(ui, now) {
        studio.change_later(|design| design.method.capsule_count = whole(count));
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a slider from 1 to 40"
)]
fn whole(count: f64) -> u32 {
    count.round() as u32
}
