//! The dancer's tape: fourteen measures, of which those that nobody took are estimated, and what patterns of
//! fitted garments alone go by.

use eframe::egui::{self, DragValue, Label, Response, RichText, Ui};
use lole_body::{BodyError, Figure, Measure, Measurements};
use lole_costume::document::Design;
use lole_costume::document::schema::{self, Kind};
use lole_language::{Sentence, Words};
use lole_pattern::{DraftError, Tailored};

use super::hindrance;
use super::knob::{choice, sign_button};
use crate::studio::range;
use crate::{Studio, look, text};

/// Sizes of a measure's name and of its number [point].
const SIZES: [egui::Vec2; 2] = [egui::vec2(128.0, 30.0), egui::vec2(92.0, 30.0)];
/// Centimeters for each point that a number is dragged.
const CM_PER_POINT: f64 = 0.1;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    figure(ui, studio);
    ui.label(RichText::new(studio.say(text::TAPE_HINT)).small().weak());
    let conflict = Conflict::of(studio.design());
    let estimates = estimates(studio);
    for measure in Measure::ALL {
        let is_wrong = conflict
            .as_ref()
            .is_some_and(|found| found.is_about(measure));
        let row = Row {
            line: Line::Body(measure),
            estimate: estimates[measure as usize],
            is_wrong,
        };
        row.show(ui, studio);
        if let Some(conflict) = &conflict
            && conflict.stands_at(measure)
        {
            hindrance::sentence(ui, studio, &conflict.sentence);
        }
    }
    if conflict.is_none() {
        hindrance::show(ui, studio, &["[dancer]"]);
    }
    ui.collapsing(studio.say(text::FOR_PATTERNS), |ui| {
        for_patterns(ui, studio);
    });
}

/// What was taken for drafting, pale where the body's own stands in for it.
fn for_patterns(ui: &mut Ui, studio: &mut Studio) {
    let hint = studio.say(text::FOR_PATTERNS_HINT);
    ui.label(RichText::new(hint).small().weak());
    let on_body = studio.snapshot.as_ref();
    let on_body = on_body.map(|now| now.wardrobe.tailored_cm);
    for tailored in Tailored::ALL {
        let estimate = on_body.map(|centimeters| centimeters[tailored as usize]);
        let given = studio.design().dancer.tailor_tape.cm(tailored);
        let refused =
            (given.zip(estimate)).and_then(|(cm, on_body)| not_hers(tailored, [cm, on_body]));
        let is_wrong = refused.is_some();
        let row = Row {
            line: Line::Patterns(tailored),
            estimate,
            is_wrong,
        };
        row.show(ui, studio);
        if let Some(sentence) = refused {
            hindrance::sentence(ui, studio, &sentence);
        }
    }
}

/// Why what was given is not drafted beside what her body has [cm]; `None` where it is.
fn not_hers(tailored: Tailored, [cm, on_body_cm]: [f64; 2]) -> Option<Sentence> {
    let [least_cm, most_cm] = tailored.room_cm(on_body_cm);
    let error = DraftError::Tailored {
        tailored,
        cm,
        on_body_cm,
        least_cm,
        most_cm,
    };
    (!(least_cm..=most_cm).contains(&cm)).then(|| Sentence::of(&error))
}

/// Two measures that exclude each other, or one that nobody has.
struct Conflict {
    sentence: Sentence,
    /// Names as the sentence has them.
    names: Vec<Words>,
}

impl Conflict {
    fn of(design: &Design) -> Option<Self> {
        let error = Measurements::from_tape(&design.tape()).err()?;
        let names = match &error {
            BodyError::OutOfBand { name, .. } => vec![*name],
            BodyError::Conflict { first, second, .. } => vec![*first, *second],
            BodyError::Unbuildable { check, against, .. } => vec![*check, *against],
            _ => Vec::new(),
        };
        Some(Self {
            sentence: Sentence::of(&error),
            names,
        })
    }

    fn is_about(&self, measure: Measure) -> bool {
        self.names.contains(&measure.words())
    }

    /// Whether the sentence stands below this one: below the later of the two.
    fn stands_at(&self, measure: Measure) -> bool {
        let last = Measure::ALL.into_iter().rfind(|m| self.is_about(*m));
        last.unwrap_or(Measure::UpperArmLength) == measure
    }
}

fn figure(ui: &mut Ui, studio: &mut Studio) {
    let names = [
        (Figure::OfStature, studio.say(text::FIGURE_BY_STATURE)),
        (Figure::Woman, studio.say(text::WOMAN)),
        (Figure::Man, studio.say(text::MAN)),
        (Figure::Child, studio.say(text::CHILD)),
    ];
    let now = studio.design().dancer.figure;
    if let Some(figure) = choice(ui, Some(now), &names) {
        studio.change(|design| design.dancer.figure = figure);
    }
}

/// What the dancer on stage measures [cm], in the order of the tape.
fn estimates(studio: &Studio) -> [Option<f64>; 14] {
    let taped = studio.snapshot.as_ref().map(|now| &now.wardrobe.taped);
    Measure::ALL.map(|measure| {
        let line = taped?.iter().find(|line| line.measure == measure)?;
        Some(line.on_body.to_cm())
    })
}

/// What a row is about.
#[derive(Debug, Clone, Copy)]
enum Line {
    /// The body is built from it.
    Body(Measure),
    /// Patterns alone go by it.
    Patterns(Tailored),
}

impl Line {
    const fn key(self) -> &'static str {
        match self {
            Self::Body(measure) => measure.key(),
            Self::Patterns(tailored) => tailored.key(),
        }
    }

    const fn words(self) -> Words {
        match self {
            Self::Body(measure) => measure.words(),
            Self::Patterns(tailored) => tailored.name(),
        }
    }
}

/// One measure of the tape.
struct Row {
    line: Line,
    /// What the dancer on stage measures [cm].
    estimate: Option<f64>,
    /// Whether it is one of those that exclude each other.
    is_wrong: bool,
}

impl Row {
    /// Its name, its number and, where it was taken, a button to leave it out again.
    fn show(&self, ui: &mut Ui, studio: &mut Studio) {
        let line = self.line;
        let given = given(studio.design(), line);
        ui.spacing_mut().item_spacing.y = 4.0;
        ui.horizontal(|ui| {
            let label = self.name(ui, studio, given);
            if let Some(centimeters) = self.number(ui, given, label.id) {
                studio.change_later(|design| set(design, line, Some(centimeters)));
            }
            if given.is_none() {
                ui.label(RichText::new(studio.say(text::ESTIMATED)).small().weak());
                return;
            }
            let name = studio.say(line.words());
            let name = format!("{name}: {}", studio.say(text::LEAVE_OUT));
            if sign_button(ui, "✖", &name) {
                studio.change(|design| set(design, line, None));
            }
        });
    }

    /// The name, pale where the measure is estimated; under the pointer it says where to measure.
    fn name(&self, ui: &mut Ui, studio: &Studio, given: Option<f64>) -> Response {
        let color = match (self.is_wrong, given) {
            (true, _) => look::RED,
            (false, Some(_)) => look::INK,
            (false, None) => look::PALE_INK,
        };
        let name = studio.say(self.line.words());
        let label = Label::new(RichText::new(name).color(color)).wrap();
        let place = egui::Layout::left_to_right(egui::Align::Center);
        let label = ui.allocate_ui_with_layout(SIZES[0], place, |ui| {
            ui.set_min_size(SIZES[0]);
            ui.add(label)
        });
        let about = schema::key("dancer", self.line.key()).map(|key| studio.say(key.about));
        label.inner.on_hover_text(about.unwrap_or(name))
    }

    /// The number, pale where it is estimated; what was typed or dragged.
    fn number(&self, ui: &mut Ui, given: Option<f64>, label: egui::Id) -> Option<f64> {
        let (low, high) = range("dancer", self.line.key());
        let known = given.or(self.estimate);
        let mut centimeters = known.unwrap_or(low);
        let response = ui.scope(|ui| {
            look::typing(ui);
            if given.is_none() {
                ui.visuals_mut().override_text_color = Some(look::PALE_INK);
                ui.visuals_mut().widgets.inactive.weak_bg_fill = look::PAPER;
            }
            let field = DragValue::new(&mut centimeters)
                .range(low..=high)
                .clamp_existing_to_range(false)
                .speed(CM_PER_POINT)
                .fixed_decimals(1)
                .suffix(" cm")
                .update_while_editing(false);
            ui.add_enabled_ui(known.is_some(), |ui| ui.add_sized(SIZES[1], field))
                .inner
        });
        let response = response.inner.labelled_by(label);
        let rounded = (centimeters * 10.0).round() / 10.0;
        (response.changed() && rounded.is_finite()).then_some(rounded)
    }
}

/// What the tape says [cm].
fn given(design: &Design, line: Line) -> Option<f64> {
    match schema::key("dancer", line.key()).map(|key| &key.kind) {
        Some(Kind::Number { get, .. }) => get(design),
        _ => None,
    }
}

/// Writes a measure down, or strikes it out.
const fn set(design: &mut Design, line: Line, centimeters: Option<f64>) {
    match line {
        Line::Body(measure) => *design.dancer.measure_mut(measure) = centimeters,
        Line::Patterns(tailored) => {
            let taken = design.dancer.tailor_tape;
            design.dancer.tailor_tape = taken.with_cm(tailored, centimeters);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_measure_is_written_where_the_document_reads_it() {
        let body = Measure::ALL.map(Line::Body);
        let patterns = Tailored::ALL.map(Line::Patterns);
        for line in body.into_iter().chain(patterns) {
            let mut design = Design::default();
            assert_eq!(given(&design, line), None);
            set(&mut design, line, Some(77.7));
            assert_eq!(given(&design, line), Some(77.7), "{line:?}");
            set(&mut design, line, None);
            assert_eq!(design, Design::default());
        }
    }

    #[test]
    fn of_two_measures_that_exclude_each_other_the_later_has_the_sentence() {
        let mut design = Design::default();
        set(&mut design, Line::Body(Measure::Waist), Some(130.0));
        set(&mut design, Line::Body(Measure::Hip), Some(80.0));
        let conflict = Conflict::of(&design).unwrap();
        let marked: Vec<_> = (Measure::ALL.into_iter())
            .filter(|m| conflict.is_about(*m))
            .collect();
        let places: Vec<_> = (Measure::ALL.into_iter())
            .filter(|m| conflict.stands_at(*m))
            .collect();
        assert_eq!(marked.len(), 2);
        assert_eq!(places, marked[1..]);
        assert!(Conflict::of(&Design::default()).is_none());
    }
}
