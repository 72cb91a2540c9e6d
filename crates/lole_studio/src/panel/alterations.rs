//! How fitted garments are altered for her after a trial in basted cloth.

use eframe::egui::{RichText, Ui};
use lole_pattern::{Alteration, Alterations};

use super::knob::{Knob, Scale, wide_button};
use crate::{Studio, text};

/// Something that is worn is drafted from her bodice block.
pub(super) fn is_fitted(studio: &Studio) -> bool {
    let mut garments = studio.design().garments.iter();
    garments.any(|garment| garment.template.is_fitted())
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    ui.label(RichText::new(studio.say(text::WHY_ALTER)).small());
    let alterations = studio.design().alterations;
    for alteration in Alteration::ALL {
        let knob = Knob {
            name: studio.say(alteration.name()),
            range: f64::NEG_INFINITY..=f64::INFINITY,
            decimals: 1,
            unit: " cm",
            scale: Scale::Even,
        };
        let knob = knob.within("alterations", alteration.key());
        if let (_, Some(cm)) = knob.show(ui, alterations.cm(alteration)) {
            let cm = (cm * 10.0).round() / 10.0;
            studio.change_later(|design| {
                design.alterations = design.alterations.with_cm(alteration, cm);
            });
        }
        ui.label(RichText::new(studio.say(alteration.seen())).small());
    }
    if alterations != Alterations::NONE && wide_button(ui, studio.say(text::NO_ALTERATIONS)) {
        studio.change(|design| design.alterations = Alterations::NONE);
    }
}
