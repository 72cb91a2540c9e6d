//! How a print lies on its cloth: one's own picture, how large it is, which way it points, where it
//! begins, and whether it is a border.

use eframe::egui::{RichText, Ui};
use lole_costume::document::{PhotoMarks, PrintChoice};
use lole_print::{PrintBorder, PrintDirection, PrintFlip, PrintTiling};

use super::knob::{Knob, Scale, choice, list, sign_button, wide_button};
use super::photo;
use crate::studio::{Request, range};
use crate::{Studio, text};

/// Repeats on a slider [cm].
const REPEATS: [f64; 2] = [5.0, 150.0];
/// Scales on a slider.
const SCALES: [f64; 2] = [0.25, 4.0];
/// Offsets on a slider [cm].
const OFFSETS: [f64; 2] = [-60.0, 60.0];

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
            let knob = knob(studio.say(name), key, OFFSETS, (1, " cm", Scale::Even));
            if let (_, Some(moved)) = knob.show(ui, *offset) {
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
        let unit = (0, " cm", Scale::Factors);
        let knob_of_repeat = knob(studio.say(text::REPEAT), "repeat_cm", REPEATS, unit);
        if let (_, Some(moved)) = knob_of_repeat.show(ui, print.repeat_cm) {
            print.repeat_cm = moved.round();
        }
    }
    let unit = (2, " ×", Scale::Factors);
    let knob_of_scale = knob(studio.say(text::PRINT_SCALE), "scale_ratio", SCALES, unit);
    if let (_, Some(moved)) = knob_of_scale.show(ui, print.lay.scale_ratio) {
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
    let borders = [
        (PrintBorder::None, named(text::ALL_OVER)),
        (PrintBorder::Hem, named(text::BORDER_HEM)),
        (PrintBorder::Hip, named(text::BORDER_HIP)),
    ];
    if let Some(border) = list(
        ui,
        ("border", studio.say(text::BORDER)),
        lay.border,
        &borders,
    ) {
        lay.border = border;
    }
    let flips = [
        (PrintFlip::None, named(text::NOT_FLIPPED)),
        (PrintFlip::Sideways, named(text::FLIP_SIDEWAYS)),
        (PrintFlip::UpsideDown, named(text::FLIP_OVER)),
    ];
    if let Some(flip) = list(ui, ("flip", studio.say(text::FLIP)), lay.flip, &flips) {
        lay.flip = flip;
    }
    let tilings = [
        (PrintTiling::Straight, named(text::STRAIGHT)),
        (PrintTiling::HalfDrop, named(text::HALF_DROP)),
        (PrintTiling::Brick, named(text::BRICK)),
        (PrintTiling::Mirror, named(text::MIRROR)),
    ];
    if let Some(tiling) = list(
        ui,
        ("tiling", studio.say(text::TILING)),
        lay.tiling,
        &tilings,
    ) {
        lay.tiling = tiling;
    }
}

/// A slider over the useful part of a key's range.
fn knob<'a>(
    name: &'a str,
    key: &str,
    [low, high]: [f64; 2],
    (decimals, unit, scale): (usize, &'a str, Scale),
) -> Knob<'a> {
    let (min, max) = range("print", key);
    Knob {
        name,
        range: min.max(low)..=max.min(high),
        decimals,
        unit,
        scale,
    }
}
