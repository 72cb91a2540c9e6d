//! What is danced: a step, a choreography or a recording; its manner and tempo.

use eframe::egui::{RichText, Ui};
use lole_costume::document::{Design, LinkedFile, PartDesign};
use lole_hula::{DanceStep, SCHOOLS};
use lole_language::{Sentence, Words};

use super::hindrance;
use super::knob::{DropDown, Knob, Scale, choice};
use crate::studio::{DancePage, range};
use crate::{Studio, text};

/// Where the dance comes from.
const fn source(design: &Design) -> DancePage {
    match &design.motion {
        motion if motion.file.is_some() => DancePage::Recording,
        motion if motion.parts.is_empty() => DancePage::Step,
        _ => DancePage::Choreography,
    }
}

/// The page that is looked at.
fn page(studio: &Studio) -> DancePage {
    studio.dance_page.unwrap_or(source(studio.design()))
}

pub(super) fn is_step(studio: &Studio) -> bool {
    page(studio) == DancePage::Step
}

pub(super) fn is_choreography(studio: &Studio) -> bool {
    page(studio) == DancePage::Choreography
}

pub(super) fn is_recording(studio: &Studio) -> bool {
    page(studio) == DancePage::Recording
}

/// Whether what is looked at is what is danced.
pub(super) fn is_danced(studio: &Studio) -> bool {
    page(studio) == source(studio.design())
}

const NAMES: [(DancePage, Words); 3] = [
    (DancePage::Step, text::DANCE_STEP),
    (DancePage::Choreography, text::CHOREOGRAPHY),
    (DancePage::Recording, text::RECORDING_SHORT),
];

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let now = page(studio);
    let pages = NAMES.map(|(page, name)| (page, studio.say(name)));
    // To look is not to change: what is danced stays until something on the page is chosen.
    if let Some(wanted) = choice(ui, Some(now), &pages) {
        studio.dance_page = Some(wanted);
    }
    let danced = source(studio.design());
    if now != danced {
        let name = NAMES.iter().find(|(page, _)| *page == danced);
        let name = name.map_or(text::DANCE, |(_, name)| *name);
        let said = Sentence::new(
            format!("いまは「{}」で踊っています。", name.japanese),
            format!("She still dances what is under “{}”.", name.english),
        );
        ui.label(RichText::new(studio.tell(&said)).small().weak());
    }
    if now == DancePage::Recording {
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

/// What is danced now is put on the shelf, so that it comes back when it is chosen again.
fn put_by(studio: &mut Studio) {
    let motion = studio.design().motion.clone();
    if !motion.parts.is_empty() {
        studio.shelf.parts = motion.parts;
    }
    if motion.file.is_some() {
        studio.shelf.file = motion.file;
    }
}

/// Dances one step over and over.
pub(super) fn dance_step(studio: &mut Studio, step: DanceStep) {
    put_by(studio);
    studio.change(|design| {
        design.motion.parts.clear();
        design.motion.file = None;
        design.motion.step = step;
    });
    studio.dance_page = None;
}

/// Dances a choreography: the one before, or one that begins with the step that is danced.
pub(super) fn dance_choreography(studio: &mut Studio) {
    put_by(studio);
    let parts = studio.shelf.parts.clone();
    studio.change(|design| {
        design.motion.file = None;
        design.motion.parts = parts;
        if design.motion.parts.is_empty() {
            design.motion.parts.push(once(design.motion.step));
        }
    });
    studio.dance_page = None;
}

/// Dances the recording before.
pub(super) fn dance_recording(studio: &mut Studio, file: LinkedFile) {
    put_by(studio);
    studio.change(|design| design.motion.file = Some(file));
    studio.dance_page = None;
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
}
