//! What one dancer takes home: buttons for booklet, pattern, film and 3D file, and below them how far
//! each has come.

use eframe::egui::{self, ProgressBar, RichText, Ui};
use lole_export::pdf::Paper;
use lole_language::Words;

use super::hindrance;
use super::knob::{choice, wide_button};
use crate::making::{Piece, Product, Stage};
use crate::platform;
use crate::studio::Request;
use crate::{Studio, look, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::PAPER));
    if let Some(paper) = choice(ui, Some(studio.order.wishes.paper), &Paper::ALL) {
        studio.order.wishes.paper = paper;
    }
    for &product in platform::products() {
        let name = format!("{}…", studio.say(product.name()));
        if wide_button(ui, &name) {
            studio.request(Request::AskMake(product));
        }
        let about = RichText::new(studio.say(product.about())).small();
        ui.label(about.weak());
    }
    pieces(ui, studio, |product| product != Product::GroupFilm);
}

/// How far each of some products has come.
pub(super) fn pieces(ui: &mut Ui, studio: &mut Studio, shows: impl Fn(Product) -> bool) {
    let pieces = studio.making.pieces.clone();
    for piece in pieces.iter().rev().filter(|piece| shows(piece.product)) {
        piece_ui(ui, studio, piece);
    }
}

fn piece_ui(ui: &mut Ui, studio: &mut Studio, piece: &Piece) {
    look::card(look::CARD).inner_margin(8).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(studio.say(piece.product.name())).strong());
        let language = studio.language;
        let named = |words: Words| format!("{} {}", words.text(language), piece.number);
        match &piece.stage {
            Stage::Stopping => {
                ui.label(studio.say(text::STOPPING));
            }
            Stage::Waiting | Stage::Working(_) => {
                let share = match piece.stage {
                    Stage::Working(share) => share,
                    _ => 0.0,
                };
                let said = match piece.stage {
                    Stage::Waiting => studio.say(text::WAITS).to_owned(),
                    _ => format!("{:.0} %", 100.0 * share),
                };
                ui.add(ProgressBar::new(share).text(said));
                if named_button(ui, studio.say(text::CANCEL), &named(text::CANCEL)) {
                    studio.request(Request::CallOff(piece.number));
                    studio.making.call_off(piece.number);
                }
            }
            Stage::Done => {
                ui.label(RichText::new(piece.path.display().to_string()).small());
                ui.horizontal(|ui| {
                    let open = named(text::OPEN_FOLDER);
                    if platform::HAS_FOLDERS
                        && named_button(ui, studio.say(text::OPEN_FOLDER), &open)
                    {
                        studio.request(Request::Reveal(piece.path.clone()));
                    }
                    close(ui, studio, piece, &named(text::CLOSE));
                });
            }
            Stage::Failed(sentence) => {
                hindrance::sentence(ui, studio, sentence);
                close(ui, studio, piece, &named(text::CLOSE));
            }
            Stage::CalledOff => {
                ui.label(studio.say(text::CALLED_OFF));
                close(ui, studio, piece, &named(text::CLOSE));
            }
        }
    });
}

/// Takes the card of a piece away; the piece stays where it is.
fn close(ui: &mut Ui, studio: &mut Studio, piece: &Piece, name: &str) {
    if named_button(ui, studio.say(text::CLOSE), name) {
        studio.making.forget(piece.number);
    }
}

/// A button that is read out with the number of what it is about.
fn named_button(ui: &mut Ui, said: &str, name: &str) -> bool {
    let response = ui.button(said);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
    response.clicked()
}
