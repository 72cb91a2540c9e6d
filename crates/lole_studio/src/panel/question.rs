//! A question for a file, in the window itself: it works where the system has no dialog.

use std::path::PathBuf;

use eframe::egui::{self, Align2, Key, TextEdit, Ui};

use lole_language::Words;

use crate::studio::{Purpose, Request};
use crate::{Studio, text};

/// What the question is called.
const fn title(purpose: Purpose) -> Words {
    match purpose {
        Purpose::Open => text::OPEN,
        Purpose::Save => text::SAVE_AS,
        Purpose::Record => text::RECORDING,
        Purpose::Print(_) => text::OWN_PICTURE,
        Purpose::Roster => text::CHOOSE_LIST,
        Purpose::Order => text::MAKE_ORDER,
    }
}

/// What is to be done with the path that was answered.
const fn request(purpose: Purpose, path: PathBuf) -> Request {
    match purpose {
        Purpose::Open => Request::Open(path),
        Purpose::Save => Request::Save(path),
        Purpose::Record => Request::OpenRecording(path),
        Purpose::Print(place) => Request::OpenPicture(place, path),
        Purpose::Roster => Request::OpenRoster(path),
        Purpose::Order => Request::MakeOrder(path),
    }
}

/// Shows the question, if there is one.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    let Some(mut question) = studio.question.take() else {
        return;
    };
    let title = studio.say(title(question.purpose));
    let (mut answered, mut given_up) = (false, false);
    egui::Window::new(title)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ui.ctx(), |ui| {
            let what = match question.purpose {
                Purpose::Order => text::FOLDER,
                _ => text::FILE,
            };
            let label = ui.label(studio.say(what));
            let field = TextEdit::singleline(&mut question.path).desired_width(360.0);
            let response = ui.add(field).labelled_by(label.id);
            answered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            if !response.has_focus() && !answered {
                response.request_focus();
            }
            ui.add_space(4.0);
            ui.horizontal(|ui| {
                let go = match question.purpose {
                    Purpose::Open | Purpose::Record | Purpose::Print(_) | Purpose::Roster => {
                        text::OPEN_IT
                    }
                    Purpose::Save | Purpose::Order => text::SAVE,
                };
                answered |= ui.button(studio.say(go)).clicked();
                if ui.button(studio.say(text::BROWSE)).clicked() {
                    studio.request(Request::Browse);
                }
                given_up = ui.button(studio.say(text::CANCEL)).clicked()
                    || ui.input(|input| input.key_pressed(Key::Escape));
            });
        });
    let path = question.path.trim();
    if answered && !path.is_empty() {
        let path = PathBuf::from(path);
        studio.request(request(question.purpose, path));
    } else if !given_up {
        studio.question = Some(question);
    }
}
