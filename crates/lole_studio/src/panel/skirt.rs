//! The cut of the skirt and the body beneath it.

use eframe::egui::{Checkbox, RichText, Ui};
use lole_costume::document::BodyShapes;

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
    body(ui, studio);
}

/// What the cloth meets: the skin, or so many capsules.
fn body(ui: &mut Ui, studio: &mut Studio) {
    let mut meets_skin = studio.design().contact_body() == BodyShapes::Skin;
    let knows_skin = studio.design().method.name.integrator().is_none();
    let switch = ui.add_enabled(
        knows_skin,
        Checkbox::new(&mut meets_skin, studio.say(text::MEETS_SKIN)),
    );
    if switch.changed() {
        studio.change(|design| {
            design.method.body = if meets_skin {
                BodyShapes::Skin
            } else {
                BodyShapes::Capsules
            };
        });
    }
    if meets_skin {
        return;
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
