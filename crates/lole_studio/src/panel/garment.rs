//! What all garments have: fabric, print, gathers, hem, and what they come to on paper.

use std::ops::RangeInclusive;

use eframe::egui::{RichText, Ui};
use lole_costume::document::{FabricDesign, PrintChoice};
use lole_costume::fabrics::PRESETS;
use lole_language::Language;
use lole_print::{COLORWAYS, MOTIFS};

use super::knob::{DropDown, Knob, Scale};
use crate::paper::PaperGarment;
use crate::studio::range;
use crate::{Studio, text};

/// The hem slider's ends [cm]: ankle and knee, and a little more.
pub(super) const SKIRT_HEMS: RangeInclusive<f64> = 5.0..=60.0;
/// Ends of the gathers' slider: flat to as much as elastic takes in.
const GATHERS: RangeInclusive<f64> = 1.5..=5.0;

/// A list of fabrics; the one that was chosen.
pub(super) fn fabric_ui(
    ui: &mut Ui,
    studio: &Studio,
    place: usize,
    fabric: &FabricDesign,
) -> Option<FabricDesign> {
    let named = |name: &str, name_ja: &str| studio.language.pick(name_ja, name).to_owned();
    let options: Vec<_> = (0..)
        .zip(PRESETS)
        .map(|(index, preset)| (index, named(preset.name, preset.name_ja)))
        .collect();
    let now = (PRESETS.iter()).position(|preset| preset.id == fabric.preset.id);
    let name = studio.say(text::FABRIC);
    let list = DropDown {
        salt: ("fabric", place),
        name,
    };
    let chosen = list.show(ui, now.unwrap_or(0), &options);
    if let Some(own) = &fabric.name {
        let said = format!("{}{own}", studio.say(text::OWN_FABRIC_NOW));
        ui.label(RichText::new(said).small());
    }
    let index: usize = chosen?;
    // What was measured on the other cloth does not hold for this one; the bolt is as wide.
    Some(FabricDesign {
        preset: &PRESETS[index],
        ..kept(fabric)
    })
}

/// What does not change with the cloth: how wide it is and what it costs.
pub(super) fn kept(fabric: &FabricDesign) -> FabricDesign {
    FabricDesign {
        width_cm: fabric.width_cm,
        price_per_m: fabric.price_per_m,
        price_per_yd: fabric.price_per_yd,
        beside_width_cm: fabric.beside_width_cm,
        beside_price_per_m: fabric.beside_price_per_m,
        ..FabricDesign::default()
    }
}

/// Motif, colorway and ground; the print that was chosen. Nothing where one's own picture is printed.
pub(super) fn print_ui(
    ui: &mut Ui,
    studio: &Studio,
    place: usize,
    print: &PrintChoice,
) -> Option<PrintChoice> {
    if print.file.is_some() {
        return None;
    }
    let mut changed = print.clone();
    let motifs: Vec<_> = (MOTIFS.iter())
        .map(|row| (row.motif, row.name.text(studio.language).to_owned()))
        .collect();
    let name = studio.say(text::PRINT);
    let list = DropDown {
        salt: ("motif", place),
        name,
    };
    if let Some(motif) = list.show(ui, print.motif, &motifs) {
        changed.motif = motif;
    }
    let ways: Vec<_> = (COLORWAYS.iter())
        .map(|way| (way.id, way.name.text(studio.language).to_owned()))
        .collect();
    let name = studio.say(text::COLORWAY);
    let list = DropDown {
        salt: ("colorway", place),
        name,
    };
    if let Some(way) = list.show(ui, print.colorway, &ways) {
        changed = PrintChoice {
            colorway: way,
            ground: None,
            flower: None,
            leaf: None,
            shadow: None,
            ..print.clone()
        };
    }
    ui.horizontal(|ui| {
        let label = ui.label(studio.say(text::GROUND));
        let mut ground = print.print().ground;
        let button = ui.color_edit_button_srgb(&mut ground).labelled_by(label.id);
        if button.changed() {
            changed.ground = Some(ground);
        }
    });
    (changed != *print).then_some(changed)
}

/// A slider of gathers, with tenths; the ratio that was chosen.
pub(super) fn gather_ui(ui: &mut Ui, studio: &Studio, ratio: f64) -> Option<f64> {
    let knob = Knob {
        name: studio.say(text::GATHER),
        range: GATHERS,
        decimals: 1,
        unit: "×",
        scale: Scale::Even,
    };
    let (_, moved) = knob.show(ui, ratio);
    moved.map(|ratio| (ratio * 10.0).round() / 10.0)
}

/// A slider of the hem's height; the whole centimeters that were chosen.
pub(super) fn hem_ui(
    ui: &mut Ui,
    studio: &Studio,
    hems: RangeInclusive<f64>,
    height: f64,
) -> Option<f64> {
    let knob = Knob {
        name: studio.say(text::HEM),
        range: hems,
        decimals: 0,
        unit: " cm",
        scale: Scale::Even,
    };
    let (_, moved) = knob.show(ui, height);
    moved.map(f64::round)
}

/// A slider of the cloth's width; the whole centimeters that were chosen.
pub(super) fn width_ui(ui: &mut Ui, studio: &Studio, width_cm: f64) -> Option<f64> {
    let (low, high) = range("fabric", "width_cm");
    let knob = Knob {
        name: studio.say(text::CLOTH_WIDTH),
        range: low.max(WIDTHS[0])..=high.min(WIDTHS[1]),
        decimals: 0,
        unit: " cm",
        scale: Scale::Even,
    };
    let (_, moved) = knob.show(ui, width_cm);
    moved.map(f64::round)
}

/// Cloth as shops have it [cm].
const WIDTHS: [f64; 2] = [36.0, 300.0];

/// How much cloth a garment takes.
pub(super) fn paper_ui(ui: &mut Ui, studio: &Studio, garment: Option<&PaperGarment>) {
    let cut = garment.and_then(|garment| garment.cut.as_ref().ok());
    let Some(plan) = cut.and_then(|cut| cut.own_plan()) else {
        return;
    };
    let (bought, mass) = (plan.marker.yardage, plan.mass);
    let (metric, yards) = (bought.metric.to_m(), bought.imperial.to_yd());
    let sentence = match studio.language {
        Language::Japanese => {
            format!("布は {metric:.1} m（{yards:.1} ヤード）、{mass:.2} kg")
        }
        Language::English => {
            format!("Buy {metric:.1} m ({yards:.1} yd) of cloth, {mass:.2} kg")
        }
    };
    ui.label(RichText::new(sentence).small().weak());
}
