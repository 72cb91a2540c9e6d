//! What a template lets its maker decide, one field for each row of its table.

use eframe::egui::{RichText, Ui};
use lole_costume::document::GarmentDesign;
use lole_garment::template::{OptionKind, OptionRow};
use lole_language::capitalized;

use super::hindrance;
use super::knob::{DropDown, Knob, Scale, choice};
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
        let (name, usual) = parts(studio.say(row.about));
        let field = Field {
            row,
            name: capitalized(name),
            usual,
            value,
        };
        let chosen = ui.push_id(row.key, |ui| field.show(ui, studio)).inner;
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

/// One option and what it is now.
struct Field<'a> {
    row: &'a OptionRow,
    name: String,
    /// What it comes to when it follows the measures; empty where that is not said.
    usual: &'a str,
    value: Option<f64>,
}

#[expect(clippy::option_option, reason = "chosen or not, and a number or not")]
impl Field<'_> {
    /// Shows it; what was chosen, `Some(None)` where it is to follow the measures.
    fn show(&self, ui: &mut Ui, studio: &Studio) -> Option<Option<f64>> {
        match self.row.kind {
            OptionKind::Number { min, max, default } => {
                let mut moved = None;
                match self.value {
                    Some(number) => moved = self.slider(ui, [min, max], number),
                    None => drop(ui.label(&self.name)),
                }
                if self.value.is_some() && default.is_some() {
                    return moved.map(Some);
                }
                let follows = self.by_measures(ui, studio, 0.5 * (min + max));
                let follows = follows.map(|number| number.map(|it| it.clamp(min, max)));
                follows.or(moved.map(Some))
            }
            OptionKind::Count { min, max, .. } => {
                let [min, max] = [min, max].map(f64::from);
                let knob = Knob {
                    name: &self.name,
                    range: min..=max,
                    decimals: 0,
                    unit: "",
                    scale: Scale::Even,
                };
                let (_, moved) = knob.show(ui, self.value.unwrap_or(min));
                moved.map(|number| Some(number.round()))
            }
            OptionKind::Choice(choices) => {
                let names = choices.iter().map(|choice| studio.say(choice.name));
                self.choice(ui, &names.collect::<Vec<_>>()).map(Some)
            }
        }
    }

    /// A number in the unit of its key, rounded to what is shown.
    fn slider(&self, ui: &mut Ui, [min, max]: [f64; 2], number: f64) -> Option<f64> {
        let (unit, decimals, steps) = unit_of(self.row.key);
        let knob = Knob {
            name: &self.name,
            range: min..=max,
            decimals,
            unit,
            scale: Scale::Even,
        };
        let (_, moved) = knob.show(ui, number);
        moved.map(|number| ((number * steps).round() / steps).clamp(min, max))
    }

    /// Whether it follows the measures; once it does not, it begins in the `middle` of its range.
    fn by_measures(&self, ui: &mut Ui, studio: &Studio, middle: f64) -> Option<Option<f64>> {
        let mut follows = self.value.is_none();
        let words = studio.say(text::BY_MEASURES);
        let words = if self.usual.is_empty() {
            words.to_owned()
        } else {
            format!("{words}: {}", self.usual)
        };
        let words = RichText::new(words).small();
        let changed = ui.checkbox(&mut follows, words).changed();
        changed.then(|| (!follows).then(|| middle.round()))
    }

    /// A few short ways side by side, others in a list.
    fn choice(&self, ui: &mut Ui, names: &[&str]) -> Option<f64> {
        let now = self.value.unwrap_or(0.0);
        let ways = (0_u32..).map(f64::from).zip(names.iter().copied());
        let is_short = names.iter().all(|name| name.chars().count() < 14);
        if names.len() <= BESIDE && is_short {
            ui.label(&self.name);
            return choice(ui, Some(now), &ways.collect::<Vec<_>>());
        }
        let list = DropDown {
            salt: self.row.key,
            name: &self.name,
        };
        let ways: Vec<_> = ways.map(|(index, name)| (index, name.to_owned())).collect();
        list.show(ui, now, &ways)
    }
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
        assert_eq!(parts("depth; left out: 15"), ("depth", "15"));
        assert_eq!(parts("丈。書かなければ 15"), ("丈", " 15"));
    }
}
