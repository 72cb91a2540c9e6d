//! The panels, a file each; these tables say where they stand.

mod cloth;
mod dance;
mod document;
mod graphs;
mod knob;
mod notice;
mod overlays;
mod playback;
mod question;
mod skirt;
mod status;
#[cfg(test)]
mod tests;
mod view;

use eframe::egui::{self, RichText, Ui};
use lole_language::Words;

use crate::{Studio, look, text};

pub use document::show as document_bar;
pub use notice::show as notices;
pub use question::show as question;
pub use status::show as status_bar;

/// One panel of a column.
pub struct Panel {
    /// Its heading.
    pub title: Words,
    /// Shows it and takes in what is done with it.
    pub show: fn(&mut Ui, &mut Studio),
}

/// What is danced, in which cloth.
pub const LEFT: &[Panel] = &[
    Panel {
        title: text::PLAYBACK,
        show: playback::show,
    },
    Panel {
        title: text::DANCE,
        show: dance::show,
    },
    Panel {
        title: text::CLOTH,
        show: cloth::show,
    },
    Panel {
        title: text::SKIRT,
        show: skirt::show,
    },
];

/// How it is looked at.
pub const RIGHT: &[Panel] = &[
    Panel {
        title: text::VIEW,
        show: view::show,
    },
    Panel {
        title: text::SHOWS,
        show: overlays::show,
    },
    Panel {
        title: text::GRAPHS,
        show: graphs::show,
    },
];

/// Shows a column of panels, scrolling where it is too long.
pub fn column(ui: &mut Ui, studio: &mut Studio, panels: &[&Panel]) {
    egui::ScrollArea::vertical()
        .auto_shrink([false, false])
        .show(ui, |ui| {
            for (index, panel) in panels.iter().enumerate() {
                if 0 < index {
                    ui.add_space(5.0);
                    ui.separator();
                }
                let title = RichText::new(studio.say(panel.title))
                    .heading()
                    .color(look::RED);
                ui.label(title);
                (panel.show)(ui, studio);
            }
            ui.add_space(8.0);
        });
}
