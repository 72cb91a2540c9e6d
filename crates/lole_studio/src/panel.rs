//! The panels, a file each; these tables say where they stand.

mod again;
mod alterations;
mod body;
#[cfg(test)]
mod cad_tests;
#[cfg(test)]
mod care_tests;
mod choreography;
mod cloths;
mod cost;
mod cutting;
mod dance;
mod dancer;
mod document;
mod frame;
mod garment;
mod garments;
mod graphs;
mod head;
mod hindrance;
mod knob;
mod making;
mod method;
mod notice;
mod options;
mod order;
mod overlays;
#[cfg(test)]
mod paper_tests;
mod photo;
mod placement;
mod playback;
mod question;
mod recording;
mod set;
mod sketch;
mod skirt;
mod start;
mod status;
mod steps;
mod swatch;
#[cfg(test)]
mod tests;
mod timeline;
mod wind;

use eframe::egui::{self, RichText, Ui};
use lole_language::Words;

use crate::studio::Tab;
use crate::{Studio, look, text};

pub(crate) use cutting::ClothTextures;
pub use cutting::enlarged;
pub use frame::show as frame;
pub(crate) use garments::first_of_cloth;
pub use notice::show as notices;
pub(crate) use photo::PhotoDesk;
pub use question::show as question;
pub(crate) use recording::ClipShelf;
pub use start::show as start;
pub(crate) use swatch::SwatchForm;

/// One panel of a column.
pub struct Panel {
    /// Its heading.
    pub title: Words,
    /// Whether it has something to say now.
    pub is_shown: fn(&Studio) -> bool,
    /// Shows it and takes in what is done with it.
    pub show: fn(&mut Ui, &mut Studio),
}

/// Panels of the left column that are shown together.
pub struct Drawer {
    /// When they are shown.
    pub tab: Tab,
    /// What is written on the button.
    pub title: Words,
    /// Them.
    pub panels: &'static [Panel],
}

const fn always(_: &Studio) -> bool {
    true
}

/// Tabs side by side.
const TABS_OF_ROW: usize = 3;

const fn panel(title: Words, show: fn(&mut Ui, &mut Studio)) -> Panel {
    Panel {
        title,
        is_shown: always,
        show,
    }
}

/// Who dances, what is worn, of which cloth, what is danced, and how it is made: in the order in which
/// a costume is thought of.
pub const DRAWERS: &[Drawer] = &[
    Drawer {
        tab: Tab::Dancer,
        title: text::DANCER,
        panels: &[
            panel(text::TAPE, dancer::show),
            Panel {
                title: text::HEAD,
                is_shown: head::is_hers,
                show: head::show,
            },
        ],
    },
    Drawer {
        tab: Tab::Costume,
        title: text::COSTUME,
        panels: &[
            panel(text::SKIRT, skirt::show),
            panel(text::GARMENTS, garments::show),
            Panel {
                title: text::ALTERATIONS,
                is_shown: alterations::is_fitted,
                show: alterations::show,
            },
        ],
    },
    Drawer {
        tab: Tab::Cloth,
        title: text::CLOTH,
        panels: &[panel(text::CLOTH, cloths::show)],
    },
    Drawer {
        tab: Tab::Dance,
        title: text::DANCE,
        panels: &[
            panel(text::DANCE, dance::show),
            Panel {
                title: text::DANCE_STEP,
                is_shown: dance::is_step,
                show: steps::show,
            },
            Panel {
                title: text::CHOREOGRAPHY,
                is_shown: dance::is_choreography,
                show: choreography::show,
            },
            Panel {
                title: text::RECORDING,
                is_shown: dance::is_recording,
                show: recording::show,
            },
            panel(text::WIND, wind::show),
            panel(text::PICTURES, set::show),
        ],
    },
    Drawer {
        tab: Tab::Cutting,
        title: text::CUT_AND_COST,
        panels: &[
            panel(text::MAKE_THEM, making::show),
            panel(text::CUT_PLAN, cutting::show),
            panel(text::COST, cost::show),
        ],
    },
    Drawer {
        tab: Tab::Order,
        title: text::GROUP_ORDER,
        panels: &[panel(text::GROUP_ORDER, order::show)],
    },
];

/// How it is computed, what is measured, and what is drawn over the picture: behind a door, because a
/// costume is made without it.
pub const RESEARCH: &[Panel] = &[
    panel(text::COMPUTATION, method::show),
    panel(text::BODY, body::show),
    panel(text::SHOWS, overlays::show),
    panel(text::GRAPHS, graphs::show),
];

/// Tabs with their places in the order.
fn tab_names(studio: &Studio) -> Vec<(Tab, String)> {
    let numbered = (1..).zip(DRAWERS);
    numbered
        .map(|(number, drawer)| (drawer.tab, format!("{number} {}", studio.say(drawer.title))))
        .collect()
}

fn tabs(ui: &mut Ui, studio: &mut Studio) {
    let names = tab_names(studio);
    let names: Vec<(Tab, &str)> = (names.iter())
        .map(|(tab, name)| (*tab, name.as_str()))
        .collect();
    // Three in a row: words of two lines or small letters would be hard to read.
    for row in names.chunks(TABS_OF_ROW) {
        if let Some(tab) = knob::choice(ui, Some(studio.tab), row) {
            studio.tab = tab;
        }
    }
}

fn scrolled(ui: &mut Ui, salt: impl egui::AsIdSalt, contents: impl FnOnce(&mut Ui)) {
    egui::ScrollArea::vertical()
        .id_salt(salt)
        .auto_shrink([false, false])
        .show(ui, |ui| {
            contents(ui);
            ui.add_space(8.0);
        });
}

/// Panels below each other; one that is called `said` needs no heading.
fn panels(ui: &mut Ui, studio: &mut Studio, panels: &[Panel], said: Option<Words>) {
    let mut is_first = true;
    for panel in panels {
        if !(panel.is_shown)(studio) {
            continue;
        }
        if !std::mem::take(&mut is_first) {
            ui.add_space(5.0);
            ui.separator();
        }
        if said != Some(panel.title) {
            let title = RichText::new(studio.say(panel.title)).heading();
            ui.label(title.color(look::RED));
        }
        (panel.show)(ui, studio);
    }
}
