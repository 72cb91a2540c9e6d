//! The pāʻū skirt: its cloth, gathers and hem.

use eframe::egui::{RichText, Ui};

use super::garment::{SKIRT_HEMS, fabric_ui, gather_ui, hem_ui, paper_ui, print_ui, width_ui};
use super::{hindrance, placement, swatch};
use crate::{Studio, text};

/// Place of the skirt among what is worn, for the lists; garments are counted from 0.
const PLACE: usize = usize::MAX;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let mut is_worn = studio.design().skirt.is_worn;
    if ui
        .checkbox(&mut is_worn, studio.say(text::WEAR_SKIRT))
        .changed()
    {
        studio.change(|design| design.skirt.is_worn = is_worn);
    }
    if !is_worn {
        sewing(ui, studio);
        return;
    }
    if let Some(fabric) = fabric_ui(ui, studio, PLACE, &studio.design().fabric) {
        studio.choose_fabric(fabric);
    }
    if let Some(ratio) = gather_ui(ui, studio, studio.design().skirt.gather_ratio) {
        studio.change_later(|design| design.skirt.gather_ratio = ratio);
    }
    if let Some(height) = hem_ui(ui, studio, SKIRT_HEMS, studio.design().skirt.hem_height_cm) {
        studio.change_later(|design| design.skirt.hem_height_cm = height);
    }
    let paper = studio.paper.clone();
    let garment = (paper.as_ref()).and_then(|paper| paper.garment(None, studio.design()));
    if let Some(trouble) = garment.and_then(|garment| garment.cut.as_ref().err()) {
        hindrance::sentence(ui, studio, &trouble.sentence);
    }
    paper_ui(ui, studio, garment);
    hindrance::show(ui, studio, &["[skirt]", "[print]"]);
    if let Some(print) = print_ui(ui, studio, PLACE, &studio.design().print) {
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
    sewing(ui, studio);
}

/// Whether needles are at work.
fn sewing(ui: &mut Ui, studio: &Studio) {
    if studio.sews {
        ui.horizontal(|ui| {
            ui.spinner();
            ui.label(studio.say(text::SEWING));
        });
    } else {
        ui.label(RichText::new(studio.say(text::SEWS_ANEW)).small().weak());
    }
}
