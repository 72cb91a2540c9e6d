//! The pāʻū skirt: its gathers, hem and rows of elastic.

use eframe::egui::{RichText, Ui};
use lole_costume::document::{Design, SkirtDesign};

use super::garment::{SKIRT_HEMS, gather_ui, hem_ui, paper_ui};
use super::hindrance;
use super::knob::{Knob, Scale, choice};
use crate::studio::range;
use crate::{Studio, text};

/// Rows of elastic that a document may have, as buttons.
const ROWS: [(u32, &str); 6] = [(1, "1"), (2, "2"), (3, "3"), (4, "4"), (5, "5"), (6, "6")];
/// Where the lowest row is worn on the slider [cm above the floor]: from the hips of a child to the
/// waist of a tall dancer.
const WORN: [f64; 2] = [50.0, 120.0];

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
    elastics(ui, studio);
    hindrance::show(ui, studio, &["[skirt]"]);
    sewing(ui, studio);
}

/// How many rows of elastic there are, and where.
fn elastics(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::ELASTIC_ROWS));
    let count = studio.design().skirt.elastic_row_count;
    if let Some(count) = choice(ui, Some(count), &ROWS) {
        studio.change(|design| design.skirt.elastic_row_count = count);
    }
    ui.collapsing(studio.say(text::ELASTIC_PLACES), |ui| {
        for length in LENGTHS {
            length.show(ui, studio);
        }
        worn_height(ui, studio);
    });
}

/// A length of the band that is typed or moved, in centimeters with halves.
struct BandLength {
    name: lole_language::Words,
    key: &'static str,
    most: f64,
    of: fn(&mut SkirtDesign) -> &mut f64,
}

/// From the top down.
const LENGTHS: [BandLength; 3] = [
    BandLength {
        name: text::RUFFLE_ABOVE,
        key: "header_cm",
        most: 8.0,
        of: |skirt| &mut skirt.header_cm,
    },
    BandLength {
        name: text::CASING,
        key: "casing_cm",
        most: 5.0,
        of: |skirt| &mut skirt.casing_cm,
    },
    BandLength {
        name: text::CASING_GAP,
        key: "casing_gap_cm",
        most: 8.0,
        of: |skirt| &mut skirt.casing_gap_cm,
    },
];

impl BandLength {
    fn show(&self, ui: &mut Ui, studio: &mut Studio) {
        let (low, high) = range("skirt", self.key);
        let knob = Knob {
            name: studio.say(self.name),
            range: low..=high.min(self.most),
            decimals: 1,
            unit: " cm",
            scale: Scale::Even,
        };
        let now = *(self.of)(&mut studio.design().skirt.clone());
        if let (_, Some(moved)) = knob.show(ui, now) {
            let edit = |design: &mut Design| {
                *(self.of)(&mut design.skirt) = (moved * 10.0).round() / 10.0;
            };
            studio.change_later(edit);
        }
    }
}

/// Where the lowest row is worn: on the hip bones, or as high as one likes.
fn worn_height(ui: &mut Ui, studio: &mut Studio) {
    let known = studio.design().skirt.worn_height_cm;
    let mut follows = known.is_none();
    let words = studio.say(text::WORN_ON_HIP_BONES);
    if ui.checkbox(&mut follows, words).changed() {
        // Near where it was: hip bones are at 56 hundredths of the stature.
        let stature = studio.design().dancer.stature_cm.unwrap_or(158.0);
        let height = (0.56 * stature).round();
        studio.change(|design| design.skirt.worn_height_cm = (!follows).then_some(height));
    }
    let Some(height) = known else { return };
    let (low, high) = range("skirt", "worn_height_cm");
    let knob = Knob {
        name: studio.say(text::WORN_HEIGHT),
        range: low.max(WORN[0])..=high.min(WORN[1]),
        decimals: 0,
        unit: " cm",
        scale: Scale::Even,
    };
    if let (_, Some(moved)) = knob.show(ui, height) {
        studio.change_later(|design| design.skirt.worn_height_cm = Some(moved.round()));
    }
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
