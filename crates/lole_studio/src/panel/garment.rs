//! What all garments have: fabric, print, gathers, hem, and what they come to on paper.

use std::ops::RangeInclusive;

use eframe::egui::{RichText, Ui};
use lole_costume::document::{FabricDesign, PrintChoice};
use lole_costume::fabrics::PRESETS;
use lole_costume::print::{COLORWAYS, MOTIFS};
use lole_language::Language;
use lole_stage::Garment;

use super::knob::{Knob, Scale, list};
use crate::{Studio, text};

/// The hem slider's ends [cm]: ankle and knee, and a little more.
pub(super) const SKIRT_HEMS: RangeInclusive<f64> = 5.0..=60.0;
/// Of a top [cm]: from the hips to the bust.
pub(super) const TOP_HEMS: RangeInclusive<f64> = 80.0..=125.0;
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
    let index: usize = list(ui, (("fabric", place), name), now.unwrap_or(0), &options)?;
    // What was measured on the other cloth does not hold for this one; the bolt is as wide.
    Some(FabricDesign {
        preset: &PRESETS[index],
        width_cm: fabric.width_cm,
        ..FabricDesign::default()
    })
}

/// Motif, colorway and ground; the print that was chosen.
pub(super) fn print_ui(
    ui: &mut Ui,
    studio: &Studio,
    place: usize,
    print: &PrintChoice,
) -> Option<PrintChoice> {
    let mut changed = print.clone();
    let motifs: Vec<_> = (MOTIFS.iter())
        .map(|row| (row.motif, row.name.text(studio.language).to_owned()))
        .collect();
    let name = studio.say(text::PRINT);
    if let Some(motif) = list(ui, (("motif", place), name), print.motif, &motifs) {
        changed.motif = motif;
    }
    let ways: Vec<_> = (COLORWAYS.iter())
        .map(|way| (way.id, way.name.text(studio.language).to_owned()))
        .collect();
    let name = studio.say(text::COLORWAY);
    if let Some(way) = list(ui, (("colorway", place), name), print.colorway, &ways) {
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

/// What the garment on stage comes to on paper.
pub(super) fn paper_ui(ui: &mut Ui, studio: &Studio, garment: Option<&Garment>) {
    let Some(garment) = garment else { return };
    let draft = &garment.draft;
    let length = draft.finished_length.to_cm();
    let (metric, yards) = (draft.yardage.metric.to_m(), draft.yardage.imperial.to_yd());
    let sentence = match studio.language {
        Language::Japanese => {
            format!("仕上がり丈 {length:.0} cm、布は {metric:.1} m（{yards} ヤード）")
        }
        Language::English => {
            format!("finished length {length:.0} cm; buy {metric:.1} m ({yards} yd)")
        }
    };
    ui.label(RichText::new(sentence).small().weak());
}
