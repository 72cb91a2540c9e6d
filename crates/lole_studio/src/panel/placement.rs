//! How a print lies on its cloth: one's own picture, how large it is, which way it points, where it
//! begins, and whether it is a border.

use std::ops::RangeInclusive;

use eframe::egui::{RichText, Ui};
use lole_costume::document::{PhotoMarks, PrintChoice};
use lole_print::{PrintBorder, PrintDirection, PrintFlip, PrintTiling};

use super::knob::{DropDown, Knob, Scale, choice, sign_button, wide_button};
use super::photo;
use crate::studio::Request;
use crate::{Studio, text};

/// Repeats on a slider [cm].
const REPEATS: RangeInclusive<f64> = 5.0..=150.0;
/// Scales on a slider.
const SCALES: RangeInclusive<f64> = 0.25..=4.0;
/// Offsets on a slider [cm].
const OFFSETS: RangeInclusive<f64> = -60.0..=60.0;

/// Shows one's own picture, and the rest folded up; the print that was chosen. `place` is that of a listed garment.
pub(super) fn show(
    ui: &mut Ui,
    studio: &mut Studio,
    place: Option<usize>,
    print: &PrintChoice,
) -> Option<PrintChoice> {
    let mut changed = print.clone();
    own_picture(ui, studio, place, &mut changed);
    ui.collapsing(studio.say(text::PLACEMENT), |ui| {
        sizes(ui, studio, &mut changed);
        ways(ui, studio, &mut changed);
        let lay = &mut changed.lay;
        for (name, key, offset) in [
            (
                text::OFFSET_ALONG,
                "offset_along_cm",
                &mut lay.offset_along_cm,
            ),
            (
                text::OFFSET_ACROSS,
                "offset_across_cm",
                &mut lay.offset_across_cm,
            ),
        ] {
            let knob = Knob {
                name: studio.say(name),
                range: OFFSETS,
                decimals: 1,
                unit: " cm",
                scale: Scale::Even,
            };
            if let (_, Some(moved)) = knob.within("print", key).show(ui, *offset) {
                *offset = (moved * 10.0).round() / 10.0;
            }
        }
    });
    (changed != *print).then_some(changed)
}

fn own_picture(ui: &mut Ui, studio: &mut Studio, place: Option<usize>, print: &mut PrintChoice) {
    let Some(file) = print.file.clone() else {
        if wide_button(ui, studio.say(text::OWN_PICTURE)) {
            studio.request(Request::AskPicture(place));
        }
        return;
    };
    ui.label(studio.say(text::PRINT));
    ui.horizontal(|ui| {
        if sign_button(ui, "✖", studio.say(text::DROP_PICTURE)) {
            print.file = None;
            print.marks = PhotoMarks::default();
        }
        let name = std::path::Path::new(&file.name).file_name();
        let name = name.map_or_else(|| file.name.clone(), |name| name.to_string_lossy().into());
        ui.label(RichText::new(name).strong());
    });
    match &file.picture {
        Some(picture) if print.file.is_some() => photo::show(ui, studio, picture, &mut print.marks),
        Some(_) => {}
        None => {
            ui.label(studio.say(text::PICTURE_NOT_READ));
        }
    }
}

fn sizes(ui: &mut Ui, studio: &Studio, print: &mut PrintChoice) {
    // A length that is known on the picture says how large the repeat is.
    if print.marks.known_length_cm.is_none() {
        let knob = Knob {
            name: studio.say(text::REPEAT),
            range: REPEATS,
            decimals: 0,
            unit: " cm",
            scale: Scale::Factors,
        };
        let knob = knob.within("print", "repeat_cm");
        if let (_, Some(moved)) = knob.show(ui, print.repeat_cm) {
            print.repeat_cm = moved.round();
        }
    }
    let knob = Knob {
        name: studio.say(text::PRINT_SCALE),
        range: SCALES,
        decimals: 2,
        unit: " ×",
        scale: Scale::Factors,
    };
    let knob = knob.within("print", "scale_ratio");
    if let (_, Some(moved)) = knob.show(ui, print.lay.scale_ratio) {
        print.lay.scale_ratio = (moved * 100.0).round() / 100.0;
    }
}

fn ways(ui: &mut Ui, studio: &Studio, print: &mut PrintChoice) {
    let lay = &mut print.lay;
    ui.label(studio.say(text::PRINT_DIRECTION));
    let arrows = [
        (PrintDirection::Up, "⬆"),
        (PrintDirection::Right, "➡"),
        (PrintDirection::Down, "⬇"),
        (PrintDirection::Left, "⬅"),
    ];
    if let Some(direction) = choice(ui, Some(lay.direction), &arrows) {
        lay.direction = direction;
    }
    let named = |words| studio.say(words).to_owned();
    let list = |salt, name| DropDown {
        salt,
        name: studio.say(name),
    };
    let borders = [
        (PrintBorder::None, named(text::ALL_OVER)),
        (PrintBorder::Hem, named(text::BORDER_HEM)),
        (PrintBorder::Hip, named(text::BORDER_HIP)),
    ];
    let picked = list("border", text::BORDER).show(ui, lay.border, &borders);
    if let Some(border) = picked {
        lay.border = border;
    }
    let flips = [
        (PrintFlip::None, named(text::NOT_FLIPPED)),
        (PrintFlip::Sideways, named(text::FLIP_SIDEWAYS)),
        (PrintFlip::UpsideDown, named(text::FLIP_OVER)),
    ];
    if let Some(flip) = list("flip", text::FLIP).show(ui, lay.flip, &flips) {
        lay.flip = flip;
    }
    let tilings = [
        (PrintTiling::Straight, named(text::STRAIGHT)),
        (PrintTiling::HalfDrop, named(text::HALF_DROP)),
        (PrintTiling::Brick, named(text::BRICK)),
        (PrintTiling::Mirror, named(text::MIRROR)),
    ];
    let picked = list("tiling", text::TILING).show(ui, lay.tiling, &tilings);
    if let Some(tiling) = picked {
        lay.tiling = tiling;
    }
}
