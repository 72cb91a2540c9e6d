//! What is worn with the skirt: a second skirt below or above it, a top, and everything else on the
//! shelf of templates.

use eframe::egui::{self, RichText, Ui};
use lole_costume::document::{Design, GarmentDesign, GarmentLayer};
use lole_garment::{Fineness, Shelf, Template};
use lole_language::{Words, capitalized};

use super::garment::{SKIRT_HEMS, fabric_ui, paper_ui, print_ui, width_ui};
use super::knob::{choice, left_label, sign_button, wide_button};
use super::{hindrance, options, placement, sketch, swatch};
use crate::{Studio, look, text};

/// Garments beside the skirt that are danced.
const MOST: usize = 4;
/// Side of a sketch [point].
const SKETCH: f32 = 54.0;

/// When a change of a garment is sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    Now,
    /// When the hand leaves the slider: it is sewn anew.
    Later,
}

/// What is done with a garment as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Move {
    Remove,
    Up,
    Down,
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let garments = studio.design().garments.clone();
    let mut moved = None;
    for (place, garment) in garments.iter().enumerate() {
        look::card(look::CARD).inner_margin(8).show(ui, |ui| {
            ui.set_width(ui.available_width());
            if let Some(done) = title(ui, studio, &garments, place) {
                moved = Some((place, done));
            }
            ui.push_id(place, |ui| garment_ui(ui, studio, place, garment));
        });
    }
    hindrance::show(ui, studio, &["[garment", "[[garment", "[method]"]);
    if let Some((place, done)) = moved {
        studio.change(|design| match done {
            Move::Remove => drop(design.garments.remove(place)),
            Move::Up => design.garments.swap(place, place - 1),
            Move::Down => design.garments.swap(place, place + 1),
        });
    }
    let mark = if studio.shelf_is_open { "▲" } else { "▼" };
    let name = studio.say(text::ADD_GARMENT).to_owned();
    if wide_button(ui, &format!("{name} {mark}")) {
        studio.shelf_is_open = !studio.shelf_is_open;
    }
    if studio.shelf_is_open {
        shelf(ui, studio);
    }
}

/// What it is, with the buttons that move it in the list and take it off.
fn title(ui: &mut Ui, studio: &Studio, garments: &[GarmentDesign], place: usize) -> Option<Move> {
    let count = garments.len();
    let name = studio.say(garments[place].name());
    let of = |words: Words| format!("{} {name} {}", studio.say(words), place + 1);
    let mut done = None;
    ui.horizontal(|ui| {
        let room = egui::vec2(ui.available_width() - 42.0, 30.0);
        left_label(ui, room, RichText::new(name).strong());
        if sign_button(ui, "✖", &of(text::TAKE_OFF)) {
            done = Some(Move::Remove);
        }
    });
    if 1 < count {
        ui.horizontal(|ui| {
            ui.label(RichText::new(studio.say(text::ORDER_OF_LAYERS)).small());
            ui.add_enabled_ui(0 < place, |ui| {
                if sign_button(ui, "▲", &of(text::MOVE_IN)) {
                    done = Some(Move::Up);
                }
            });
            ui.add_enabled_ui(place + 1 < count, |ui| {
                if sign_button(ui, "▼", &of(text::MOVE_OUT)) {
                    done = Some(Move::Down);
                }
            });
        });
    }
    done
}

fn garment_ui(ui: &mut Ui, studio: &mut Studio, place: usize, garment: &GarmentDesign) {
    let (mut changed, mut when) = (garment.clone(), When::Now);
    let layers = [
        (GarmentLayer::Under, studio.say(text::UNDER_SKIRT)),
        (GarmentLayer::Over, studio.say(text::OVER_SKIRT)),
    ];
    if let Some(layer) = choice(ui, Some(garment.layer), &layers) {
        changed.layer = layer;
    }
    let paper = studio.paper.clone();
    let on_paper = (paper.as_ref()).and_then(|paper| paper.garment(Some(place), studio.design()));
    let trouble = on_paper.and_then(|garment| garment.cut.as_ref().err());
    let shape = egui::CollapsingHeader::new(studio.say(text::SHAPE)).default_open(true);
    let moved = shape.show(ui, |ui| options::show(ui, studio, &mut changed, trouble));
    if moved.body_returned == Some(true) {
        when = When::Later;
    }
    if let Some(trouble) = trouble.filter(|trouble| trouble.key.is_none()) {
        hindrance::sentence(ui, studio, &trouble.sentence);
    }
    paper_ui(ui, studio, on_paper);
    if changed == *garment {
        return;
    }
    let edit = |design: &mut Design| design.garments[place] = changed;
    match when {
        When::Now => studio.change(edit),
        When::Later => studio.change_later(edit),
    }
}

/// The first thing that is worn of cloth: `Some(None)` is the skirt, else a place in the list.
pub(crate) fn first_of_cloth(studio: &Studio) -> Option<Option<usize>> {
    let design = studio.design();
    if design.skirt.is_worn {
        return Some(None);
    }
    let mut places = 0..design.garments.len();
    places.find(|place| is_of_cloth(studio, *place)).map(Some)
}

/// Whether a garment of the list is cut from cloth: leaves and flowers are not.
pub(super) fn is_of_cloth(studio: &Studio, place: usize) -> bool {
    let paper = studio.paper.as_ref();
    let on_paper = paper.and_then(|paper| paper.garment(Some(place), studio.design()));
    on_paper.is_none_or(|garment| {
        let cut = garment.cut.as_ref();
        cut.map_or(true, |cut| !cut.plans.is_empty())
    })
}

/// Fabric and print of a garment of the list.
pub(super) fn cloth(ui: &mut Ui, studio: &mut Studio, place: usize) {
    let Some(garment) = studio.design().garments.get(place).cloned() else {
        return;
    };
    let mut changed = garment.clone();
    let is_moved = cloth_ui(ui, studio, place, &mut changed);
    let paper = studio.paper.clone();
    let on_paper = (paper.as_ref()).and_then(|paper| paper.garment(Some(place), studio.design()));
    paper_ui(ui, studio, on_paper);
    if changed == garment {
        return;
    }
    let edit = |design: &mut Design| design.garments[place] = changed;
    if is_moved {
        studio.change_later(edit);
    } else {
        studio.change(edit);
    }
}

/// Fabric and print; whether one was moved that is sewn anew.
fn cloth_ui(ui: &mut Ui, studio: &mut Studio, place: usize, garment: &mut GarmentDesign) -> bool {
    let (fabric, print) = (&mut garment.fabric, &mut garment.print);
    let mut is_moved = false;
    if let Some(chosen) = fabric_ui(ui, studio, place, fabric) {
        *fabric = chosen;
    }
    if let Some(chosen) = print_ui(ui, studio, place, print) {
        *print = chosen;
    }
    if let Some(chosen) = placement::show(ui, studio, Some(place), print) {
        *print = chosen;
        is_moved = true;
    }
    ui.collapsing(studio.say(text::OWN_FABRIC), |ui| {
        if let Some(width) = width_ui(ui, studio, fabric.width_cm) {
            fabric.width_cm = width;
            is_moved = true;
        }
        if let Some(own) = swatch::show(ui, studio, fabric) {
            *fabric = own;
        }
    });
    is_moved
}

/// Everything that can be put on, by what it is for.
fn shelf(ui: &mut Ui, studio: &mut Studio) {
    let danced = (studio.design().garments.iter()).filter(|garment| garment.is_danced());
    let is_full = MOST <= danced.count();
    let mut chosen = None;
    for shelf in Shelf::ALL {
        let name = RichText::new(studio.say(shelf.name())).strong();
        ui.label(name.color(look::RED));
        for (template, name, garment) in shelf
            .templates()
            .flat_map(|it| entries(studio.design(), it))
        {
            let is_open = !(is_full && garment.is_danced());
            let clicked = ui
                .add_enabled_ui(is_open, |ui| entry(ui, studio, template, name))
                .inner;
            if clicked {
                chosen = Some(garment);
            }
        }
    }
    if is_full {
        ui.label(RichText::new(studio.say(text::NO_MORE_DANCED)).small());
    }
    if let Some(garment) = chosen {
        studio.shelf_is_open = false;
        studio.change(|design| design.garments.push(garment));
    }
}

/// A sketch, what it is called and what it is; whether it was chosen.
fn entry(ui: &mut Ui, studio: &Studio, template: &Template, name: Words) -> bool {
    ui.horizontal(|ui| {
        let (_, rect) = ui.allocate_space(egui::Vec2::splat(SKETCH));
        sketch::draw(ui.painter(), rect, template.sketch);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            let clicked = wide_button(ui, &capitalized(studio.say(name)));
            let about = RichText::new(studio.say(template.about)).small().weak();
            ui.label(about);
            clicked
        })
        .inner
    })
    .inner
}

/// What a template puts on: a skirt below and above the other one, everything else as it is.
fn entries(
    design: &Design,
    template: &'static Template,
) -> Vec<(&'static Template, Words, GarmentDesign)> {
    let garment = GarmentDesign::new(template);
    if template.second().is_none() {
        return vec![(template, garment.name(), garment)];
    }
    let over = overskirt(design, &garment);
    [garment, over].map(|it| (template, it.name(), it)).into()
}

/// A skirt over that of the design, made as the one under it: shorter, so that both are seen.
fn overskirt(design: &Design, under: &GarmentDesign) -> GarmentDesign {
    let above = design.skirt.hem_height_cm + 12.0;
    let over = under
        .clone()
        .with(&[("hem_height_cm", above.min(*SKIRT_HEMS.end()))]);
    GarmentDesign {
        layer: GarmentLayer::Over,
        fineness: Fineness {
            seed: over.fineness.seed + 2,
            ..over.fineness
        },
        ..over
    }
}
