//! What the cloth meets as a body: the skin, or so many capsules.

use eframe::egui::{Checkbox, Ui};
use lole_costume::document::BodyShapes;

use super::knob::{Knob, Scale};
use crate::studio::range;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
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
