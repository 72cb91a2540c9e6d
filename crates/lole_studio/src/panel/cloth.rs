//! Method, stiffness and damping: changed without stopping the dance.

use eframe::egui::{ComboBox, Ui};
use lole_costume::document::MethodName;

use super::hindrance;
use super::knob::{Knob, Scale};
use crate::studio::range;
use crate::wished::STIFFNESSES;
use crate::{Studio, text};

/// The damping slider ends here [1/s]: stronger drag looks like honey.
const MOST_DAMPING: f64 = 10.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    method(ui, studio);
    hindrance::show(ui, studio, &["[method]", "[fabric]"]);
    let stiffness = Knob {
        name: studio.say(text::STIFFNESS),
        range: STIFFNESSES[0]..=STIFFNESSES[1],
        decimals: 2,
        unit: "×",
        scale: Scale::Factors,
    };
    if let (_, Some(factor)) = stiffness.show(ui, studio.stiffness()) {
        studio.set_stiffness(factor);
    }
    let (low, high) = range("fabric", "drag_per_s");
    let damping = Knob {
        name: studio.say(text::DAMPING),
        range: low..=high.min(MOST_DAMPING),
        decimals: 2,
        unit: " 1/s",
        scale: Scale::Even,
    };
    let now = f64::from(studio.design().fabric.fabric().drag_rate);
    if let (_, Some(drag)) = damping.show(ui, now) {
        studio.change(|design| design.fabric.drag_per_s = Some(drag));
    }
}

fn method(ui: &mut Ui, studio: &mut Studio) {
    let label = ui.label(studio.say(text::METHOD));
    let chosen = studio.design().method.name;
    let mut picked = chosen;
    let width = ui.available_width();
    ComboBox::from_id_salt("method")
        .width(width)
        .selected_text(name_of(studio, chosen))
        .show_ui(ui, |ui| {
            for method in MethodName::ALL {
                let name = name_of(studio, method);
                ui.selectable_value(&mut picked, method, name);
            }
        })
        .response
        .labelled_by(label.id);
    if picked != chosen {
        studio.change(|design| design.method.name = picked);
    }
}

/// The method's id with a word on it.
fn name_of(studio: &Studio, method: MethodName) -> String {
    let about = studio.say(text::method(method));
    format!("{}  {about}", method.id())
}
