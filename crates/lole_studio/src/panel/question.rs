//! A question for a file, in the window itself: it works where the system has no dialog.

use std::path::{Path, PathBuf};

use eframe::egui::{self, Align2, Key, RichText, ScrollArea, TextEdit, Ui};
use lole_language::Words;

use super::hindrance;
use super::knob::sign_button;
use crate::chooser::Listing;
use crate::studio::{Purpose, Question, Request};
use crate::{Studio, look, text};

/// Width of the question where there is room [point].
const WIDTH: f32 = 560.0;
/// Height of the list of files where there is room [point].
const LIST: f32 = 280.0;
/// What stands above and below the list [point].
const AROUND: f32 = 270.0;

/// What the question is called.
const fn title(purpose: Purpose) -> Words {
    match purpose {
        Purpose::Open => text::OPEN,
        Purpose::Save => text::SAVE_AS,
        Purpose::Record => text::RECORDING,
        Purpose::Print(_) => text::OWN_PICTURE,
        Purpose::Roster => text::CHOOSE_LIST,
        Purpose::Order => text::MAKE_ORDER,
        Purpose::Make(product) => product.name(),
        Purpose::Picture => text::PICTURE,
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
        Purpose::Make(product) => Request::Make(product, path),
        Purpose::Picture => Request::SavePicture(path),
    }
}

/// Shows the question, if there is one.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    let Some(mut question) = studio.question.take() else {
        return;
    };
    let screen = ui.ctx().content_rect();
    let room = egui::vec2(
        WIDTH.min(screen.width() - 48.0),
        LIST.min(screen.height() - AROUND).max(60.0),
    );
    let mut end = None;
    egui::Window::new(studio.say(title(question.purpose)))
        .id(egui::Id::unique("question"))
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ui.ctx(), |ui| {
            ui.set_width(room.x);
            if let Some(listing) = question.listing.clone() {
                places(ui, studio, &mut question, &listing);
                files(ui, studio, &mut question, &listing, room.y);
            }
            if let Some(note) = &question.note {
                hindrance::sentence(ui, studio, note);
            }
            if field(ui, studio, &mut question) {
                end = Some(End::Answered);
            }
            end = buttons(ui, studio, question.purpose).or(end);
        });
    let path = question.path.trim();
    match end {
        Some(End::Answered) if !path.is_empty() => {
            let path = PathBuf::from(path);
            // A folder is looked into, unless one was asked for.
            if path.is_dir() && !question.purpose.is_folder() {
                studio.request(Request::ListFolder(path));
                studio.question = Some(question);
            } else {
                studio.request(request(question.purpose, path));
            }
        }
        Some(End::GivenUp) => {}
        Some(End::Answered) | None => studio.question = Some(question),
    }
}

/// How a question ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Answered,
    GivenUp,
}

/// The folder that is looked into, the one above it, and those that people keep files in.
fn places(ui: &mut Ui, studio: &mut Studio, question: &mut Question, listing: &Listing) {
    let mut wanted = None;
    ui.horizontal_wrapped(|ui| {
        for place in &listing.places {
            let is_own = Some(place) == listing.places.first();
            let name = match place.file_name() {
                Some(name) if !is_own => name.to_string_lossy().into_owned(),
                _ => studio.say(text::OWN_FOLDER).to_owned(),
            };
            if ui.button(name).clicked() {
                wanted = Some(place.clone());
            }
        }
    });
    ui.horizontal(|ui| {
        if let Some(above) = listing.folder.parent()
            && sign_button(ui, "⬆", studio.say(text::FOLDER_ABOVE))
        {
            wanted = Some(above.to_owned());
        }
        let here = RichText::new(listing.folder.display().to_string()).small();
        ui.add(egui::Label::new(here).wrap());
    });
    if let Some(folder) = wanted {
        go_to(studio, question, folder);
    }
}

/// Looks into another folder; the name that was typed stays.
fn go_to(studio: &mut Studio, question: &mut Question, folder: PathBuf) {
    let name = Path::new(&question.path).file_name();
    let name = name
        .filter(|_| question.purpose.writes())
        .map(PathBuf::from);
    let path = folder.join(name.unwrap_or_default());
    question.path = path.display().to_string();
    studio.request(Request::ListFolder(folder));
}

fn files(
    ui: &mut Ui,
    studio: &mut Studio,
    question: &mut Question,
    listing: &Listing,
    height: f32,
) {
    if let Some(trouble) = &listing.trouble {
        hindrance::sentence(ui, studio, trouble);
    }
    let mut wanted = None;
    look::card(look::CARD).inner_margin(6).show(ui, |ui| {
        ScrollArea::vertical()
            .id_salt(&listing.folder)
            .max_height(height)
            .auto_shrink([false, false])
            .show(ui, |ui| {
                if listing.entries.is_empty() {
                    ui.label(RichText::new(studio.say(text::NOTHING_HERE)).weak());
                }
                for entry in &listing.entries {
                    let path = listing.folder.join(&entry.name);
                    let is_chosen = Path::new(&question.path) == path;
                    let button = egui::Button::selectable(is_chosen, &entry.name)
                        .wrap()
                        .min_size(egui::vec2(ui.available_width(), 28.0));
                    let indented = |ui: &mut Ui| {
                        ui.spacing_mut().button_padding.x = INDENT;
                        ui.add(button)
                    };
                    let response = ui.scope(indented).inner;
                    if !entry.is_file {
                        paint_folder(ui.painter(), response.rect);
                    }
                    if response.clicked() {
                        wanted = Some((path, entry.is_file));
                    }
                }
            });
    });
    match wanted {
        Some((path, true)) => question.path = path.display().to_string(),
        Some((path, false)) => go_to(studio, question, path),
        None => {}
    }
}

/// Room for the sign of a folder before its name [point].
const INDENT: f32 = 34.0;

/// A folder with its tab, drawn, because not every typeface has one.
fn paint_folder(painter: &egui::Painter, row: egui::Rect) {
    let at = row.left_center() + egui::vec2(20.0, 1.0);
    let body = egui::Rect::from_center_size(at, egui::vec2(19.0, 13.0));
    let tab = egui::Rect::from_min_size(body.min - egui::vec2(0.0, 3.0), egui::vec2(9.0, 5.0));
    for part in [tab, body] {
        painter.rect_filled(part, 2.0, look::OCHRE);
    }
}

/// What was typed or chosen; whether it was typed to its end.
fn field(ui: &mut Ui, studio: &Studio, question: &mut Question) -> bool {
    let what = if question.purpose.is_folder() {
        text::FOLDER
    } else {
        text::FILE
    };
    let label = ui.label(studio.say(what));
    let field = TextEdit::singleline(&mut question.path).desired_width(f32::INFINITY);
    let add = |ui: &mut Ui| {
        look::typing(ui);
        ui.add(field).labelled_by(label.id)
    };
    let response = ui.scope(add).inner;
    let is_typed = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let has_focus = ui.ctx().memory(|memory| memory.focused().is_some());
    if !has_focus && !is_typed {
        response.request_focus();
    }
    is_typed
}

fn buttons(ui: &mut Ui, studio: &mut Studio, purpose: Purpose) -> Option<End> {
    let mut end = None;
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        let go = if purpose.writes() {
            text::SAVE
        } else {
            text::OPEN_IT
        };
        let go = RichText::new(studio.say(go)).color(egui::Color32::WHITE);
        if ui.add(egui::Button::new(go).fill(look::RED)).clicked() {
            end = Some(End::Answered);
        }
        let is_escaped = ui.input(|input| input.key_pressed(Key::Escape));
        if ui.button(studio.say(text::CANCEL)).clicked() || is_escaped {
            end = Some(End::GivenUp);
        }
        if ui.button(studio.say(text::BROWSE)).clicked() {
            studio.request(Request::Browse);
        }
    });
    end
}
