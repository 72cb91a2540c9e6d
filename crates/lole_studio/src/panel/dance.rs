//! What is danced: a step, a choreography or a recording; its manner and tempo.

use eframe::egui::{RichText, Ui};
use lole_costume::document::{Design, PartDesign};
use lole_hula::{DanceStep, SCHOOLS};

use super::hindrance;
use super::knob::{DropDown, Knob, Scale, choice};
use crate::studio::{Request, range};
use crate::{Studio, text};

/// Where the dance comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Source {
    Step,
    Choreography,
    Recording,
}

fn source(design: &Design) -> Source {
    match &design.motion {
        motion if motion.file.is_some() => Source::Recording,
        motion if motion.parts.is_empty() => Source::Step,
        _ => Source::Choreography,
    }
}

pub(super) fn is_step(studio: &Studio) -> bool {
    source(studio.design()) == Source::Step
}

pub(super) fn is_choreography(studio: &Studio) -> bool {
    source(studio.design()) == Source::Choreography
}

pub(super) fn is_recording(studio: &Studio) -> bool {
    source(studio.design()) == Source::Recording
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let now = source(studio.design());
    let sources = [
        (Source::Step, studio.say(text::DANCE_STEP)),
        (Source::Choreography, studio.say(text::CHOREOGRAPHY)),
        (Source::Recording, studio.say(text::RECORDING_SHORT)),
    ];
    if let Some(wanted) = choice(ui, Some(now), &sources)
        && wanted != now
    {
        change_source(studio, wanted);
    }
    if now == Source::Recording {
        return;
    }
    school(ui, studio);
    let (low, high) = range("motion", "tempo_bpm");
    let knob = Knob {
        name: studio.say(text::TEMPO),
        range: low..=high,
        decimals: 0,
        unit: studio.say(text::TEMPO_UNIT),
        scale: Scale::Even,
    };
    if let (_, Some(tempo)) = knob.show(ui, studio.design().motion.tempo_bpm) {
        studio.change(|design| design.motion.tempo_bpm = tempo.round());
    }
    hindrance::show(ui, studio, &["[motion]"]);
}

/// Goes over to another kind of dance; the one before is put on the shelf.
fn change_source(studio: &mut Studio, wanted: Source) {
    let motion = studio.design().motion.clone();
    if !motion.parts.is_empty() {
        studio.shelf.parts = motion.parts;
    }
    if motion.file.is_some() {
        studio.shelf.file = motion.file;
    }
    let shelf = studio.shelf.clone();
    match wanted {
        Source::Step => studio.change(|design| {
            design.motion.parts.clear();
            design.motion.file = None;
        }),
        Source::Choreography => studio.change(|design| {
            design.motion.file = None;
            design.motion.parts = shelf.parts;
            if design.motion.parts.is_empty() {
                design.motion.parts.push(once(design.motion.step));
            }
        }),
        Source::Recording if shelf.file.is_some() => {
            studio.change(|design| design.motion.file = shelf.file);
        }
        Source::Recording => studio.request(Request::AskRecording),
    }
}

/// A step, danced once.
fn once(step: DanceStep) -> PartDesign {
    PartDesign {
        step,
        beat_count: step.counts(),
        ..PartDesign::default()
    }
}

/// The manner of a hālau.
fn school(ui: &mut Ui, studio: &mut Studio) {
    let options: Vec<_> = (0..)
        .zip(SCHOOLS)
        .map(|(index, school)| (index, studio.say(school.about).to_owned()))
        .collect();
    let now = (SCHOOLS.iter()).position(|school| school.id == studio.design().motion.school.id);
    let name = studio.say(text::SCHOOL);
    let list = DropDown {
        salt: "school",
        name,
    };
    if let Some(index) = list.show(ui, now.unwrap_or(0), &options) {
        studio.change(|design| design.motion.follow(&SCHOOLS[index]));
    }
    let about = studio.say(studio.design().motion.school.about);
    ui.label(RichText::new(about).small().weak());
}
