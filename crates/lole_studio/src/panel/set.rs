//! How she is seen: floor, background and light of window, stills and film, and how the film is shot.

use eframe::egui::{TextEdit, Ui};
use lole_costume::document::{CameraWork, Gaze, MotionBlur, StageMood, StageSet};
use lole_language::Words;
use lole_picture::film::title::MOST_LETTERS;

use super::knob::DropDown;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let stage = studio.design().stage.clone();
    let sets = StageSet::ALL.map(|set| (set, set.name()));
    if let Some(set) = choose(ui, studio, (text::SET, &sets), stage.set) {
        studio.change(|design| design.stage.set = set);
    }
    if stage.set == StageSet::Theater {
        let moods = StageMood::ALL.map(|mood| (mood, mood.name()));
        if let Some(mood) = choose(ui, studio, (text::MOOD, &moods), stage.mood) {
            studio.change(|design| design.stage.mood = mood);
        }
    }
    let cameras = CameraWork::ALL.map(|work| (work, work.name()));
    if let Some(work) = choose(ui, studio, (text::CAMERA, &cameras), stage.camera) {
        studio.change(|design| design.stage.camera = work);
    }
    let blurs = MotionBlur::ALL.map(|blur| (blur, blur.name()));
    if let Some(blur) = choose(ui, studio, (text::MOTION_BLUR, &blurs), stage.motion_blur) {
        studio.change(|design| design.stage.motion_blur = blur);
    }
    let gazes = Gaze::ALL.map(|gaze| (gaze, gaze.name()));
    if let Some(gaze) = choose(ui, studio, (text::GAZE, &gazes), stage.gaze) {
        studio.change(|design| design.stage.gaze = gaze);
    }
    title(ui, studio, stage.title);
}

/// A list that drops down; the new choice.
pub(super) fn choose<T: PartialEq + Copy>(
    ui: &mut Ui,
    studio: &Studio,
    (name, choices): (Words, &[(T, Words)]),
    chosen: T,
) -> Option<T> {
    let named: Vec<(T, String)> = (choices.iter())
        .map(|(choice, name)| (*choice, studio.say(*name).to_owned()))
        .collect();
    let list = DropDown {
        salt: name.english,
        name: studio.say(name),
    };
    list.show(ui, chosen, &named)
}

/// What is written over the beginning of a film.
fn title(ui: &mut Ui, studio: &mut Studio, mut title: String) {
    let label = ui.label(studio.say(text::TITLE));
    let field = TextEdit::singleline(&mut title)
        .desired_width(f32::INFINITY)
        .char_limit(MOST_LETTERS)
        .hint_text(studio.say(text::TITLE_HINT));
    if ui.add(field).labelled_by(label.id).changed() {
        studio.change(|design| design.stage.title = title);
    }
}
