//! Method, stiffness and damping: changed without stopping the dance.

use eframe::egui::Ui;
use lole_costume::document::{MethodName, Uncrossed};

use super::hindrance;
use super::knob::{DropDown, Knob, Scale};
use crate::studio::range;
use crate::wished::STIFFNESSES;
use crate::{Studio, text};

/// The damping slider ends here [1/s]: stronger drag looks like honey.
const MOST_DAMPING: f64 = 10.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    method(ui, studio);
    uncrossed(ui, studio);
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
    let options = MethodName::ALL.map(|method| (method, name_of(studio, method)));
    let chosen = studio.design().method.name;
    let name = studio.say(text::METHOD);
    let list = DropDown {
        salt: "method",
        name,
    };
    if let Some(picked) = list.show(ui, chosen, &options) {
        studio.change(|design| design.method.name = picked);
    }
}

/// Of `xpbd`: the paper's methods let cloth pass through itself.
fn uncrossed(ui: &mut Ui, studio: &mut Studio) {
    if studio.design().method.name != MethodName::Xpbd {
        return;
    }
    let options = Uncrossed::ALL.map(|when| (when, studio.say(text::uncrossed(when)).to_owned()));
    let chosen = studio.design().method.uncrossed;
    let name = studio.say(text::UNCROSSED);
    let list = DropDown {
        salt: "uncrossed",
        name,
    };
    if let Some(picked) = list.show(ui, chosen, &options) {
        studio.change(|design| design.method.uncrossed = picked);
    }
}

/// The method's id with a word on it.
fn name_of(studio: &Studio, method: MethodName) -> String {
    let about = studio.say(text::method(method));
    format!("{}  {about}", method.id())
}
