//! What a template lets its maker decide, one field for each row of its table.

use eframe::egui::{RichText, Ui};
use lole_costume::document::GarmentDesign;
use lole_garment::template::{OptionKind, OptionRow};

use super::hindrance;
use super::knob::{Knob, Scale, choice, list};
use crate::paper::DraftTrouble;
use crate::{Studio, text};

/// Ways that stand side by side; more drop down.
const BESIDE: usize = 2;

/// Shows all options, and under the one it is about why nothing can be drafted; whether one was moved.
pub(super) fn show(
    ui: &mut Ui,
    studio: &Studio,
    worn: &mut GarmentDesign,
    trouble: Option<&DraftTrouble>,
) -> bool {
    let mut is_moved = false;
    for (position, row) in worn.template.options.iter().enumerate() {
        let value = worn.options.get(position);
        let chosen = ui
            .push_id(row.key, |ui| option(ui, studio, row, value))
            .inner;
        if let Some(value) = chosen {
            worn.options.set(position, value);
            is_moved = true;
        }
        let about_it = trouble.filter(|trouble| trouble.key == Some(row.key));
        if let Some(trouble) = about_it {
            hindrance::sentence(ui, studio, &trouble.sentence);
        }
    }
    is_moved
}

/// One option; what was chosen, `Some(None)` where it is to follow the measures.
#[expect(clippy::option_option, reason = "chosen or not, and a number or not")]
fn option(
    ui: &mut Ui,
    studio: &Studio,
    row: &OptionRow,
    value: Option<f64>,
) -> Option<Option<f64>> {
    let (name, usual) = parts(studio.say(row.about));
    let name = capitalized(name);
    match row.kind {
        OptionKind::Number { min, max, default } => {
            let Some(number) = value else {
                ui.label(&name);
                return by_measures(ui, studio, (value, usual), [min, max]);
            };
            let moved = slider(ui, &name, row.key, [min, max], number);
            let follows = match default {
                Some(_) => None,
                None => by_measures(ui, studio, (value, usual), [min, max]),
            };
            follows.or(moved.map(Some))
        }
        OptionKind::Count { min, max, .. } => {
            let number = value.unwrap_or(f64::from(min));
            let knob = Knob {
                name: &name,
                range: f64::from(min)..=f64::from(max),
                decimals: 0,
                unit: "",
                scale: Scale::Even,
            };
            let (_, moved) = knob.show(ui, number);
            moved.map(|number| Some(number.round()))
        }
        OptionKind::Choice(choices) => {
            let now = value.unwrap_or(0.0);
            let names = (0_u32..).map(f64::from).zip(choices);
            let names: Vec<(f64, &str)> = names
                .map(|(index, choice)| (index, studio.say(choice.name)))
                .collect();
            let is_short = names.iter().all(|(_, name)| name.chars().count() < 14);
            if names.len() <= BESIDE && is_short {
                ui.label(&name);
                return choice(ui, Some(now), &names).map(Some);
            }
            let names: Vec<(f64, String)> = (names.iter())
                .map(|&(index, name)| (index, name.to_owned()))
                .collect();
            list(ui, (row.key, &name), now, &names).map(Some)
        }
    }
}

/// Whether an option follows the measures; a switched off one begins in the middle of its range.
#[expect(clippy::option_option, reason = "chosen or not, and a number or not")]
fn by_measures(
    ui: &mut Ui,
    studio: &Studio,
    (value, usual): (Option<f64>, &str),
    [min, max]: [f64; 2],
) -> Option<Option<f64>> {
    let mut follows = value.is_none();
    let words = studio.say(text::BY_MEASURES);
    let words = if usual.is_empty() {
        words.to_owned()
    } else {
        format!("{words}: {usual}")
    };
    let words = RichText::new(words).small();
    let changed = ui.checkbox(&mut follows, words).changed();
    changed.then(|| (!follows).then(|| (0.5 * (min + max)).round().clamp(min, max)))
}

/// A number in the unit of its key, rounded to what is shown.
fn slider(ui: &mut Ui, name: &str, key: &str, [min, max]: [f64; 2], value: f64) -> Option<f64> {
    let (unit, decimals, scale) = unit_of(key);
    let knob = Knob {
        name,
        range: min..=max,
        decimals,
        unit,
        scale: Scale::Even,
    };
    let (_, moved) = knob.show(ui, value);
    moved.map(|number| ((number * scale).round() / scale).clamp(min, max))
}

/// Unit behind a number, its digits after the point, and steps in one.
fn unit_of(key: &str) -> (&'static str, usize, f64) {
    let units = [
        ("_cm", (" cm", 1, 10.0)),
        ("_mm", (" mm", 1, 10.0)),
        ("_ratio", (" ×", 2, 100.0)),
        ("_deg", ("°", 0, 1.0)),
        ("_g", (" g", 0, 1.0)),
        ("_m", (" m", 1, 10.0)),
    ];
    let found = units.iter().find(|(end, _)| key.ends_with(end));
    found.map_or(("", 1, 10.0), |(_, unit)| *unit)
}

/// What an option is, and what it comes to when nothing is said: rows of documents tell both in one
/// sentence.
fn parts(about: &str) -> (&str, &str) {
    let found = ["。書かなければ", "; left out: "]
        .iter()
        .find_map(|words| about.split_once(words));
    found.unwrap_or((about, ""))
}

/// Rows speak in the middle of a line; a field begins one.
pub(super) fn capitalized(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map(|letter| letter.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

#[cfg(test)]
mod tests {
    use lole_garment::TEMPLATES;

    use super::*;

    #[test]
    fn every_number_of_every_template_is_shown_with_its_unit() {
        for row in TEMPLATES.iter().flat_map(|template| template.options) {
            if matches!(row.kind, OptionKind::Number { .. }) {
                assert!(!unit_of(row.key).0.is_empty(), "{}", row.key);
            }
        }
        assert_eq!(unit_of("hem_height_cm"), (" cm", 1, 10.0));
        assert_eq!(unit_of("gather_ratio"), (" ×", 2, 100.0));
        assert_eq!(capitalized("depth of it"), "Depth of it");
        assert_eq!(parts("depth; left out: 15"), ("depth", "15"));
        assert_eq!(parts("丈。書かなければ 15"), ("丈", " 15"));
    }
}
