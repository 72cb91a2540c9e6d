//! What is worn with the skirt: a second skirt below or above it, a top.

use eframe::egui::{self, RichText, Ui};
use lole_costume::document::{Design, GarmentDesign, GarmentLayer, WornSkirt, WornTop};
use lole_language::Words;
use lole_stage::Garment;

use super::garment::{SKIRT_HEMS, TOP_HEMS, fabric_ui, gather_ui, hem_ui, paper_ui, print_ui};
use super::hindrance;
use super::knob::{choice, sign_button, wide_button};
use crate::{Studio, look, text};

/// Garments beside the skirt that are danced.
const MOST: usize = 4;

/// When a change of a garment is sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    Now,
    /// When the hand leaves the slider: it is sewn anew.
    Later,
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let garments = studio.design().garments.clone();
    let mut removed = None;
    for (place, garment) in garments.iter().enumerate() {
        let frame = egui::Frame::new()
            .fill(look::CARD)
            .stroke(egui::Stroke::new(1.0, look::LINE))
            .corner_radius(7)
            .inner_margin(8);
        frame.show(ui, |ui| {
            ui.set_width(ui.available_width());
            if title(ui, studio, place, garment) {
                removed = Some(place);
            }
            ui.push_id(place, |ui| garment_ui(ui, studio, place, garment));
        });
    }
    hindrance::show(ui, studio, &["[garment", "[[garment", "[method]"]);
    if let Some(place) = removed {
        studio.change(|design| {
            design.garments.remove(place);
        });
    }
    if let Some(sentence) = studio.design().not_danced() {
        ui.label(studio.tell(&sentence));
    }
    let danced = garments.iter().filter(|garment| garment.is_danced());
    if danced.count() < MOST {
        add(ui, studio);
    }
}

/// What it is, with the button that takes it off; whether that was clicked.
fn title(ui: &mut Ui, studio: &Studio, place: usize, garment: &GarmentDesign) -> bool {
    let name = studio.say(name_of(garment));
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).strong());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let name = format!("{} {name} {}", studio.say(text::TAKE_OFF), place + 1);
            sign_button(ui, "✖", &name)
        })
        .inner
    })
    .inner
}

const fn name_of(garment: &GarmentDesign) -> Words {
    match (garment, garment.layer()) {
        (GarmentDesign::PauSkirt(_), GarmentLayer::Under) => text::UNDERSKIRT,
        (GarmentDesign::PauSkirt(_), GarmentLayer::Over) => text::OVERSKIRT,
        (GarmentDesign::PauTop(_), _) => text::TOP,
        (GarmentDesign::Template(worn), _) => worn.template.name,
    }
}

fn garment_ui(ui: &mut Ui, studio: &mut Studio, place: usize, garment: &GarmentDesign) {
    let (mut changed, mut when) = (garment.clone(), When::Now);
    let layers = [
        (GarmentLayer::Under, studio.say(text::UNDER_SKIRT)),
        (GarmentLayer::Over, studio.say(text::OVER_SKIRT)),
    ];
    if let Some(layer) = choice(ui, Some(garment.layer()), &layers) {
        *changed.layer_mut() = layer;
    }
    let (fabric, print) = changed.cloth_mut();
    if let Some(chosen) = fabric_ui(ui, studio, place, fabric) {
        *fabric = chosen;
    }
    if let Some(chosen) = print_ui(ui, studio, place, print) {
        *print = chosen;
    }
    if cut_ui(ui, studio, &mut changed) {
        when = When::Later;
    }
    let snapshot = studio.snapshot.clone();
    let sewn = snapshot.as_ref();
    let sewn = sewn.and_then(|now| {
        let garments = &now.wardrobe.production.garments;
        garments.get(place_on_stage(studio.design(), place))
    });
    paper_ui(ui, studio, sewn.filter(|sewn| is_kind(sewn, garment)));
    if changed == *garment {
        return;
    }
    let edit = |design: &mut Design| design.garments[place] = changed;
    match when {
        When::Now => studio.change(edit),
        When::Later => studio.change_later(edit),
    }
}

/// Gathers and hem; whether one was moved.
fn cut_ui(ui: &mut Ui, studio: &Studio, garment: &mut GarmentDesign) -> bool {
    let before = garment.clone();
    match garment {
        GarmentDesign::PauSkirt(WornSkirt { skirt, .. }) => {
            if let Some(ratio) = gather_ui(ui, studio, skirt.gather_ratio) {
                skirt.gather_ratio = ratio;
            }
            if let Some(height) = hem_ui(ui, studio, SKIRT_HEMS, skirt.hem_height_cm) {
                skirt.hem_height_cm = height;
            }
        }
        GarmentDesign::PauTop(WornTop { top, .. }) => {
            if let Some(ratio) = gather_ui(ui, studio, top.gather_ratio) {
                top.gather_ratio = ratio;
            }
            let mut by_skirt = top.hem_height_cm.is_none();
            let switch = ui.checkbox(&mut by_skirt, studio.say(text::HEM_BY_SKIRT));
            if switch.changed() {
                top.hem_height_cm = (!by_skirt).then_some(*TOP_HEMS.start() + 15.0);
            }
            if let Some(height) = top.hem_height_cm
                && let Some(height) = hem_ui(ui, studio, TOP_HEMS, height)
            {
                top.hem_height_cm = Some(height);
            }
        }
        GarmentDesign::Template(_) => {}
    }
    *garment != before
}

/// Where a garment of the list is among what is worn, from the skin outward.
fn place_on_stage(design: &Design, place: usize) -> usize {
    let below = |layer| {
        design
            .garments_in(layer)
            .take_while(move |(at, _)| *at != place)
    };
    let under = below(GarmentLayer::Under).count();
    match design.garments.get(place).map(GarmentDesign::layer) {
        Some(GarmentLayer::Over) => under + 1 + below(GarmentLayer::Over).count(),
        _ => under,
    }
}

/// Whether what is on stage is this one, and not yet or still another.
fn is_kind(sewn: &Garment, garment: &GarmentDesign) -> bool {
    let start = match (garment, garment.layer()) {
        (GarmentDesign::PauSkirt(_), GarmentLayer::Under) => "pau_underskirt",
        (GarmentDesign::PauSkirt(_), GarmentLayer::Over) => "pau_overskirt",
        (GarmentDesign::PauTop(_), _) => "pau_top",
        (GarmentDesign::Template(_), _) => return false,
    };
    sewn.name.starts_with(start)
}

fn add(ui: &mut Ui, studio: &mut Studio) {
    let over = WornSkirt {
        layer: GarmentLayer::Over,
        ..WornSkirt::default()
    };
    // Shorter than the skirt, so that both are seen.
    let above = studio.design().skirt.hem_height_cm + 12.0;
    let over = WornSkirt {
        skirt: lole_costume::document::SkirtDesign {
            hem_height_cm: above.min(*SKIRT_HEMS.end()),
            seed: 4,
            ..over.skirt
        },
        ..over
    };
    let choices = [
        (
            text::ADD_UNDERSKIRT,
            GarmentDesign::PauSkirt(WornSkirt::default()),
        ),
        (text::ADD_OVERSKIRT, GarmentDesign::PauSkirt(over)),
        (text::ADD_TOP, GarmentDesign::PauTop(WornTop::default())),
    ];
    for (name, garment) in choices {
        if wide_button(ui, studio.say(name)) {
            studio.change(|design| design.garments.push(garment));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn garments_of_the_list_are_found_among_what_is_worn() {
        let skirt = |layer| {
            GarmentDesign::PauSkirt(WornSkirt {
                layer,
                ..WornSkirt::default()
            })
        };
        let mut design = Design::default();
        let layers = [GarmentLayer::Over, GarmentLayer::Under, GarmentLayer::Under];
        design.garments = layers.map(skirt).to_vec();
        // Under 1, under 2, the skirt, over 0.
        assert_eq!(
            [0, 1, 2].map(|place| place_on_stage(&design, place)),
            [3, 0, 1]
        );
    }
}
