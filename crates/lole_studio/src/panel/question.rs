//! A question for a file, in the window itself: it works where the system has no dialog.

use std::path::{Path, PathBuf};

use eframe::egui::{self, Align2, Key, RichText, ScrollArea, TextEdit, Ui};
use lole_language::Words;

use super::hindrance;
use super::knob::sign_button;
use crate::chooser::{Entry, Listing};
use crate::studio::{Purpose, Question, Request};
use crate::{Studio, look, text};

/// Width of the question where there is room [point].
const WIDTH: f32 = 560.0;
/// Heights of the list of files where there is room, and where there is least [point].
const LIST: [f32; 2] = [280.0, 64.0];
/// Height of list and places at least, where they are scrolled together [point].
const LEAST_ROOM: f32 = 28.0;
/// Height of a file in the list [point].
const ROW: f32 = 28.0;

/// Heights of the last picture [point], by which this one's list fits the window.
#[derive(Debug, Clone, Copy)]
struct Heights {
    /// The window's frame with its title.
    frame: f32,
    /// What stands above and below the list and is scrolled with it.
    beside: f32,
    /// What was typed, and the buttons, which are never scrolled away.
    below: f32,
}

/// Before there was a picture.
const FIRST: Heights = Heights {
    frame: 60.0,
    beside: 110.0,
    below: 130.0,
};

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

/// Shows the question, if there is one.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    let Some(mut question) = studio.question.take() else {
        return;
    };
    if question.replaces.is_some() && !question.is_replacing() {
        // Another name was given: what was said of the one before is over.
        question.replaces = None;
        question.note = None;
    }
    let screen = ui.ctx().content_rect();
    let id = egui::Id::unique("question");
    let before: Heights = ui.data(|data| data.get_temp(id)).unwrap_or(FIRST);
    let mut now = before;
    let mut end = None;
    let window = egui::Window::new(studio.say(title(question.purpose)))
        .id(id)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ui.ctx(), |ui| {
            ui.set_width(WIDTH.min(screen.width() - 48.0));
            let room = (screen.height() - before.frame - before.below).max(LEAST_ROOM);
            now.beside = upper(ui, studio, &mut question, [room, before.beside]);
            let top = ui.min_rect().bottom();
            if field(ui, studio, &mut question) && !question.is_replacing() {
                end = Some(End::Answered);
            }
            end = buttons(ui, studio, &question).or(end);
            now.below = ui.min_rect().bottom() - top;
            ui.min_rect().height()
        });
    if let Some(window) = window {
        let inner = window.inner.unwrap_or_default();
        now.frame = window.response.rect.height() - inner;
        ui.data_mut(|data| data.insert_temp(id, now));
    }
    match end {
        Some(End::GivenUp) => {}
        Some(End::Answered) if let Some(request) = question.request() => {
            studio.request(request);
            studio.answered = Some(question);
        }
        Some(End::Answered) | None => studio.question = Some(question),
    }
}

/// Places, list and note, in a room of this height; the height of what stands beside the list, which was
/// `beside` in the picture before.
fn upper(
    ui: &mut Ui,
    studio: &mut Studio,
    question: &mut Question,
    [room, beside]: [f32; 2],
) -> f32 {
    let mut list = 0.0;
    let scrolled = ScrollArea::vertical()
        .id_salt("upper")
        .max_height(room)
        .min_scrolled_height(LEAST_ROOM)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            if let Some(listing) = question.listing.clone() {
                places(ui, studio, question, &listing);
                // A little less than fits, so that rounding makes nothing to be scrolled.
                list = (room - beside - 2.0).clamp(LIST[1], LIST[0]);
                files(ui, studio, question, &listing, list);
            }
            if let Some(note) = &question.note {
                hindrance::sentence(ui, studio, note);
            }
        });
    scrolled.content_size.y - list
}

/// Windows lower than this have the places in a list that drops down: the files need the height [point].
const LOW: f32 = 420.0;

/// How a question ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Answered,
    GivenUp,
}

/// The folder that is looked into, the one above it, and those that people keep files in.
fn places(ui: &mut Ui, studio: &mut Studio, question: &mut Question, listing: &Listing) {
    let mut wanted = None;
    let is_low = ui.ctx().content_rect().height() < LOW;
    if !is_low {
        ui.horizontal_wrapped(|ui| {
            for place in &listing.places {
                if ui.button(place_name(studio, listing, place)).clicked() {
                    wanted = Some(place.clone());
                }
            }
        });
    }
    ui.horizontal(|ui| {
        if let Some(above) = listing.folder.parent()
            && sign_button(ui, "⬆", studio.say(text::FOLDER_ABOVE))
        {
            wanted = Some(above.to_owned());
        }
        if is_low {
            wanted = place_list(ui, studio, listing).or(wanted.take());
        }
        let here = RichText::new(listing.folder.display().to_string()).small();
        ui.add(egui::Label::new(here).wrap());
    });
    if let Some(folder) = wanted {
        go_to(studio, question, folder);
    }
}

fn place_name(studio: &Studio, listing: &Listing, place: &Path) -> String {
    let is_own = listing.places.first().is_some_and(|own| own == place);
    match place.file_name() {
        Some(name) if !is_own => name.to_string_lossy().into_owned(),
        _ => studio.say(text::OWN_FOLDER).to_owned(),
    }
}

/// The places as a list that drops down.
fn place_list(ui: &mut Ui, studio: &Studio, listing: &Listing) -> Option<PathBuf> {
    let mut wanted = None;
    let title = studio.say(text::PLACES);
    let list = egui::ComboBox::from_id_salt("places").selected_text(title);
    let shown = list.show_ui(ui, |ui| {
        for place in &listing.places {
            let name = place_name(studio, listing, place);
            if ui
                .selectable_label(*place == listing.folder, name)
                .clicked()
            {
                wanted = Some(place.clone());
            }
        }
    });
    let info = || egui::WidgetInfo::labeled(egui::Role::ComboBox, true, title);
    shown.response.widget_info(info);
    wanted
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
        let padding = 2.0 * ui.spacing().button_padding.y;
        let row = ROW.max(ui.text_style_height(&egui::TextStyle::Button) + padding);
        ScrollArea::vertical()
            .id_salt(&listing.folder)
            .max_height(height)
            .min_scrolled_height(height)
            .auto_shrink([false, false])
            .show_rows(ui, row, listing.entries.len(), |ui, rows| {
                if listing.entries.is_empty() {
                    ui.label(RichText::new(studio.say(text::NOTHING_HERE)).weak());
                }
                for entry in &listing.entries[rows] {
                    if entry_ui(ui, question, listing, entry, row) {
                        wanted = Some((listing.folder.join(&entry.name), entry.is_file));
                    }
                }
            });
    });
    if 0 < listing.left_out {
        let count = listing.left_out;
        let japanese = format!("このほかに {count} 個あります。名前を下に書いても選べます。");
        let english = format!("There are {count} more; type the name of one below.");
        ui.label(RichText::new(studio.language.pick(&japanese, &english)).small());
    }
    match wanted {
        Some((path, true)) => question.path = path.display().to_string(),
        Some((path, false)) => go_to(studio, question, path),
        None => {}
    }
}

/// One file or folder of the list; whether it was chosen. All are of one height, so that of a long list
/// only what is seen is laid out.
fn entry_ui(
    ui: &mut Ui,
    question: &Question,
    listing: &Listing,
    entry: &Entry,
    height: f32,
) -> bool {
    let is_chosen = question.answer() == Some(listing.folder.join(&entry.name));
    let button = egui::Button::selectable(is_chosen, &entry.name)
        .truncate()
        .min_size(egui::vec2(ui.available_width(), height));
    let indented = |ui: &mut Ui| {
        ui.spacing_mut().button_padding.x = INDENT;
        ui.add(button)
    };
    let response = ui.scope(indented).inner;
    if !entry.is_file {
        paint_folder(ui.painter(), response.rect);
    }
    response.on_hover_text(&entry.name).clicked()
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

fn buttons(ui: &mut Ui, studio: &mut Studio, question: &Question) -> Option<End> {
    let mut end = None;
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        let go = if question.is_replacing() {
            text::REPLACE
        } else if question.purpose.writes() {
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
