//! The cloth of everything that is worn: fabric, print, how it lies, one's own cloth and photo.

use eframe::egui::{RichText, Ui};
use lole_garment::template::PAU_SKIRT;

use super::garment::{fabric_ui, paper_ui, print_ui, width_ui};
use super::{garments, hindrance, overlays, placement, swatch};
use crate::{Studio, look, text};

/// Place of the skirt among what is worn, for the lists; garments are counted from 0.
const SKIRT: usize = usize::MAX;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let mut is_bare = true;
    if studio.design().skirt.is_worn {
        is_bare = false;
        card(ui, studio.say(PAU_SKIRT.name), |ui| skirt(ui, studio));
    }
    let worn = studio.design().garments.clone();
    for (place, garment) in worn.iter().enumerate() {
        if !garments::is_of_cloth(studio, place) {
            continue;
        }
        is_bare = false;
        card(ui, studio.say(garment.name()), |ui| {
            ui.push_id(("cloth", place), |ui| garments::cloth(ui, studio, place));
        });
    }
    if is_bare {
        ui.label(studio.say(text::NO_CLOTH_WORN));
    }
    hindrance::show(ui, studio, &["[fabric]", "[print]"]);
    overlays::strain(ui, studio);
}

fn card(ui: &mut Ui, name: &str, contents: impl FnOnce(&mut Ui)) {
    look::card(look::CARD).inner_margin(8).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(name).strong().color(look::TEAL));
        contents(ui);
    });
}

fn skirt(ui: &mut Ui, studio: &mut Studio) {
    if let Some(fabric) = fabric_ui(ui, studio, SKIRT, &studio.design().fabric) {
        studio.choose_fabric(fabric);
    }
    if let Some(print) = print_ui(ui, studio, SKIRT, &studio.design().print) {
        studio.change(|design| design.print = print);
    }
    let print = studio.design().print.clone();
    if let Some(print) = placement::show(ui, studio, None, &print) {
        studio.change_later(|design| design.print = print);
    }
    ui.collapsing(studio.say(text::OWN_FABRIC), |ui| {
        let fabric = studio.design().fabric.clone();
        if let Some(width) = width_ui(ui, studio, fabric.width_cm) {
            studio.change_later(|design| design.fabric.width_cm = width);
        }
        if let Some(own) = swatch::show(ui, studio, &fabric) {
            studio.choose_fabric(own);
        }
    });
    let paper = studio.paper.clone();
    let garment = (paper.as_ref()).and_then(|paper| paper.garment(None, studio.design()));
    paper_ui(ui, studio, garment);
}
