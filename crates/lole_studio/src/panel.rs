//! The panels, a file each; these tables say where they stand.

mod body;
#[cfg(test)]
mod cad_tests;
mod choreography;
mod cloth;
mod cost;
mod cutting;
mod dance;
mod dancer;
mod document;
mod garment;
mod garments;
mod graphs;
mod hindrance;
mod knob;
mod notice;
mod options;
mod order;
mod overlays;
mod photo;
mod placement;
mod playback;
mod question;
mod recording;
mod sketch;
mod skirt;
mod status;
mod steps;
mod swatch;
#[cfg(test)]
mod tests;
mod view;
mod wind;

use eframe::egui::{self, RichText, Ui};
use lole_language::Words;

use crate::studio::Tab;
use crate::{Studio, look, text};

pub(crate) use cutting::ClothTextures;
pub use cutting::enlarged;
pub use document::show as document_bar;
pub use notice::show as notices;
pub(crate) use photo::PhotoDesk;
pub use question::show as question;
pub(crate) use recording::ClipShelf;
pub use status::show as status_bar;
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

/// What is always at hand.
const PLAYBACK: Panel = Panel {
    title: text::PLAYBACK,
    is_shown: always,
    show: playback::show,
};

/// What is danced, worn, who dances, and in which air.
pub const DRAWERS: &[Drawer] = &[
    Drawer {
        tab: Tab::Dance,
        title: text::DANCE,
        panels: &[
            Panel {
                title: text::DANCE,
                is_shown: always,
                show: dance::show,
            },
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
        ],
    },
    Drawer {
        tab: Tab::Costume,
        title: text::COSTUME,
        panels: &[
            Panel {
                title: text::SKIRT,
                is_shown: always,
                show: skirt::show,
            },
            Panel {
                title: text::GARMENTS,
                is_shown: always,
                show: garments::show,
            },
        ],
    },
    Drawer {
        tab: Tab::Cutting,
        title: text::CUT_AND_COST,
        panels: &[
            Panel {
                title: text::CUT_PLAN,
                is_shown: always,
                show: cutting::show,
            },
            Panel {
                title: text::COST,
                is_shown: always,
                show: cost::show,
            },
        ],
    },
    Drawer {
        tab: Tab::Dancer,
        title: text::DANCER,
        panels: &[Panel {
            title: text::TAPE,
            is_shown: always,
            show: dancer::show,
        }],
    },
    Drawer {
        tab: Tab::Order,
        title: text::GROUP_ORDER,
        panels: &[Panel {
            title: text::GROUP_ORDER,
            is_shown: always,
            show: order::show,
        }],
    },
    Drawer {
        tab: Tab::Cloth,
        title: text::AIR_AND_CLOTH,
        panels: &[
            Panel {
                title: text::WIND,
                is_shown: always,
                show: wind::show,
            },
            Panel {
                title: text::CLOTH,
                is_shown: always,
                show: cloth::show,
            },
            Panel {
                title: text::BODY,
                is_shown: always,
                show: body::show,
            },
        ],
    },
];

/// How it is looked at.
pub const RIGHT: &[Panel] = &[
    Panel {
        title: text::VIEW,
        is_shown: always,
        show: view::show,
    },
    Panel {
        title: text::SHOWS,
        is_shown: always,
        show: overlays::show,
    },
    Panel {
        title: text::GRAPHS,
        is_shown: always,
        show: graphs::show,
    },
];

/// Shows what the design can be changed by.
pub fn left_column(ui: &mut Ui, studio: &mut Studio) {
    column(ui, studio, &[]);
}

/// Shows how it is looked at.
pub fn right_column(ui: &mut Ui, studio: &mut Studio) {
    scrolled(ui, "right", |ui| panels(ui, studio, RIGHT, None));
}

/// Shows everything, for narrow windows.
pub fn one_column(ui: &mut Ui, studio: &mut Studio) {
    column(ui, studio, RIGHT);
}

fn column(ui: &mut Ui, studio: &mut Studio, below: &[Panel]) {
    (PLAYBACK.show)(ui, studio);
    ui.add_space(4.0);
    tabs(ui, studio);
    ui.add_space(2.0);
    let drawer = (DRAWERS.iter()).find(|drawer| drawer.tab == studio.tab);
    let own = drawer.map_or(&[][..], |drawer| drawer.panels);
    // The tab says it already.
    let title = drawer.map(|drawer| drawer.title);
    // Each drawer is as far scrolled as it was left.
    scrolled(ui, (studio.tab as usize, "left"), |ui| {
        panels(ui, studio, own, title);
        if !below.is_empty() {
            ui.separator();
            panels(ui, studio, below, None);
        }
    });
}

fn tabs(ui: &mut Ui, studio: &mut Studio) {
    let names: Vec<(Tab, &str)> = (DRAWERS.iter())
        .map(|drawer| (drawer.tab, studio.say(drawer.title)))
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
