//! How she is seen: floor, background and light of window, stills and film, and how the film is shot.

use eframe::egui::{TextEdit, Ui};
use lole_body::{HairStyle, Makeup};
use lole_costume::document::{CameraWork, Gaze, StageMood, StageSet};

use super::knob::DropDown;
use crate::{Studio, text};

/// Letters of a title that a film shows.
const MOST_LETTERS: usize = 60;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let sets: Vec<_> = (StageSet::ALL.iter())
        .map(|set| (*set, studio.say(set.name()).to_owned()))
        .collect();
    let list = DropDown {
        salt: "set",
        name: studio.say(text::SET),
    };
    if let Some(set) = list.show(ui, studio.design().stage.set, &sets) {
        studio.change(|design| design.stage.set = set);
    }
    if studio.design().stage.set == StageSet::Theater {
        let moods: Vec<_> = (StageMood::ALL.iter())
            .map(|mood| (*mood, studio.say(mood.name()).to_owned()))
            .collect();
        let list = DropDown {
            salt: "mood",
            name: studio.say(text::MOOD),
        };
        if let Some(mood) = list.show(ui, studio.design().stage.mood, &moods) {
            studio.change(|design| design.stage.mood = mood);
        }
    }
    let cameras: Vec<_> = (CameraWork::ALL.iter())
        .map(|work| (*work, studio.say(work.name()).to_owned()))
        .collect();
    let list = DropDown {
        salt: "camera",
        name: studio.say(text::CAMERA),
    };
    if let Some(work) = list.show(ui, studio.design().stage.camera, &cameras) {
        studio.change(|design| design.stage.camera = work);
    }
    let gazes: Vec<_> = (Gaze::ALL.iter())
        .map(|gaze| (*gaze, studio.say(gaze.name()).to_owned()))
        .collect();
    let list = DropDown {
        salt: "gaze",
        name: studio.say(text::GAZE),
    };
    if let Some(gaze) = list.show(ui, studio.design().stage.gaze, &gazes) {
        studio.change(|design| design.stage.gaze = gaze);
    }
    title(ui, studio);
    head(ui, studio);
}

/// What is written over the beginning of a film.
fn title(ui: &mut Ui, studio: &mut Studio) {
    let label = ui.label(studio.say(text::TITLE));
    let mut title = studio.design().stage.title.clone();
    let field = TextEdit::singleline(&mut title)
        .desired_width(f32::INFINITY)
        .char_limit(MOST_LETTERS)
        .hint_text(studio.say(text::TITLE_HINT));
    if ui.add(field).labelled_by(label.id).changed() {
        studio.change(|design| design.stage.title = title);
    }
}

/// Hair and makeup, where the dancer is not someone's avatar.
fn head(ui: &mut Ui, studio: &mut Studio) {
    let styles: Vec<_> = (HairStyle::ALL.iter())
        .map(|style| (*style, studio.say(style.name()).to_owned()))
        .collect();
    let list = DropDown {
        salt: "hair",
        name: studio.say(text::HAIR),
    };
    if let Some(style) = list.show(ui, studio.design().dancer.hair, &styles) {
        studio.change(|design| design.dancer.hair = style);
    }
    let makeups: Vec<_> = (Makeup::ALL.iter())
        .map(|makeup| (*makeup, studio.say(makeup.name()).to_owned()))
        .collect();
    let list = DropDown {
        salt: "makeup",
        name: studio.say(text::MAKEUP),
    };
    if let Some(makeup) = list.show(ui, studio.design().dancer.makeup, &makeups) {
        studio.change(|design| design.dancer.makeup = makeup);
    }
}
