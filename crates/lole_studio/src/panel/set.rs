//! How she is seen: floor, background and light of window, stills and film, and how the film is shot.

use eframe::egui::Ui;
use lole_costume::document::{CameraWork, Gaze, StageSet};

use super::knob::DropDown;
use crate::{Studio, text};

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
}
