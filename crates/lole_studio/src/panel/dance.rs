//! The step and its tempo; a change is eased into while she dances.

use eframe::egui::{Button, ScrollArea, Ui};
use lole_body::DanceStep;

use super::knob::{Knob, Scale};
use crate::studio::range;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::DANCE_STEP));
    if let Some(step) = step_ui(ui, studio.design().motion.step) {
        studio.change(|design| {
            design.motion.step = step;
            // A choreography would go on instead.
            design.motion.parts.clear();
        });
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

/// Height in points of the list of steps: about five rows.
const LIST_HEIGHT: f32 = 150.0;

/// All steps by their names in rows; the one that was picked, if one was.
fn step_ui(ui: &mut Ui, chosen: DanceStep) -> Option<DanceStep> {
    let rows = |ui: &mut Ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        let picked = |step: &DanceStep| {
            let button = Button::selectable(chosen == *step, step.name())
                .frame_when_inactive(true)
                .min_size([30.0, 24.0].into());
            ui.add(button).clicked()
        };
        // Every button is drawn, also those after one that was clicked.
        let mut steps: Vec<DanceStep> = DanceStep::ALL.to_vec();
        steps.retain(picked);
        steps.first().copied()
    };
    let list = ScrollArea::vertical().max_height(LIST_HEIGHT);
    list.show(ui, |ui| ui.horizontal_wrapped(rows).inner).inner
}
