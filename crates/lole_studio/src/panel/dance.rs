//! The step and its tempo; a change is eased into while she dances.

use eframe::egui::Ui;
use lole_body::DanceStep;

use super::knob::{Knob, Scale, choice};
use crate::studio::range;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::DANCE_STEP));
    let steps = DanceStep::ALL.map(|step| (step, step.name()));
    let chosen = studio.design().motion.step;
    if let Some(step) = choice(ui, Some(chosen), &steps) {
        studio.change(|design| design.motion.step = step);
    }
    let (low, high) = range("motion", "tempo_bpm");
    let knob = Knob {
        name: studio.say(text::TEMPO),
        range: low..=high,
        decimals: 0,
        unit: studio.say(text::TEMPO_UNIT),
        scale: Scale::Even,
    };
    if let (_, Some(tempo)) = knob.show(ui, studio.design().motion.tempo_bpm) {
        studio.change(|design| design.motion.tempo_bpm = tempo);
    }
}
