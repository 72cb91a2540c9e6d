//! The whole window around the picture, in every size: panels beside it while there is room, and
//! else one of the two at a time.

use eframe::egui::{self, Align, Button, ComboBox, Layout, RichText, Ui};

use super::{DRAWERS, RESEARCH, document, knob, notices, panels, playback, scrolled, status, tabs};
use crate::studio::Tab;
use crate::{Studio, look, text};

/// Widths of the column of panels and of that for researchers [point].
const COLUMNS: [f32; 2] = [330.0, 280.0];
/// Windows of this width have both columns beside the picture [point].
const BOTH: f32 = 1000.0;
/// Narrower windows show panels or picture, one at a time [point].
const BESIDE: f32 = 560.0;
/// Lower windows name the tabs in a list that drops down [point].
const LOW: f32 = 430.0;
/// Share of the width that the column takes at most.
const MOST_SHARE: f32 = 0.56;
/// Share of the height that notices above the column take at most: longer ones are scrolled.
const MOST_NOTICES: f32 = 0.7;

/// Shows everything; `picture` fills what is left.
pub fn show(ui: &mut Ui, studio: &mut Studio, picture: impl FnOnce(&mut Ui, &mut Studio)) {
    let bar = egui::Frame::new().fill(look::CARD).inner_margin(6);
    let (width, height) = (ui.available_width(), ui.available_height());
    let show_tabs = if height < LOW { tab_list } else { tabs };
    egui::Panel::top("document")
        .frame(bar)
        .show(ui, |ui| document::show(ui, studio));
    egui::Panel::bottom("status")
        .frame(bar.inner_margin(egui::Margin::symmetric(8, 3)))
        .show(ui, |ui| status::show(ui, studio));
    if width < BESIDE {
        one_at_a_time(ui, studio, picture);
        return;
    }
    let side = egui::Frame::new().fill(look::PAPER).inner_margin(10);
    let has_both = BOTH <= width;
    egui::Panel::left("left")
        .frame(side)
        .resizable(false)
        .exact_size(COLUMNS[0].min(MOST_SHARE * width))
        .show(ui, |ui| {
            if studio.researches && !has_both {
                research(ui, studio);
            } else {
                column(ui, studio, show_tabs);
            }
        });
    if studio.researches && has_both {
        egui::Panel::right("right")
            .frame(side)
            .resizable(false)
            .exact_size(COLUMNS[1])
            .show(ui, |ui| research(ui, studio));
    }
    stage(ui, studio, picture);
}

/// Panels or picture, with a switch between them.
fn one_at_a_time(ui: &mut Ui, studio: &mut Studio, picture: impl FnOnce(&mut Ui, &mut Studio)) {
    let side = egui::Frame::new().fill(look::PAPER).inner_margin(8);
    let look_at = [
        (false, studio.say(text::MAKES)),
        (true, studio.say(text::WATCHES)),
    ];
    egui::Panel::top("switch").frame(side).show(ui, |ui| {
        if let Some(watches) = knob::choice(ui, Some(studio.watches), &look_at) {
            studio.watches = watches;
        }
    });
    if studio.watches {
        stage(ui, studio, picture);
        return;
    }
    egui::CentralPanel::default().frame(side).show(ui, |ui| {
        // They stand over the picture, which is not there.
        egui::ScrollArea::vertical()
            .id_salt("notices")
            .max_height(MOST_NOTICES * ui.available_height())
            .auto_shrink([false, true])
            .show(ui, |ui| notices(ui, studio));
        if studio.researches {
            research(ui, studio);
        } else {
            column(ui, studio, tab_list);
        }
    });
}

/// The picture with what plays and turns it below.
fn stage(ui: &mut Ui, studio: &mut Studio, picture: impl FnOnce(&mut Ui, &mut Studio)) {
    let bar = egui::Frame::new()
        .fill(look::PAPER)
        .inner_margin(egui::Margin::symmetric(8, 6));
    egui::CentralPanel::default()
        .frame(egui::Frame::NONE)
        .show(ui, |ui| {
            egui::Panel::bottom("playback")
                .frame(bar)
                .show(ui, |ui| playback::show(ui, studio));
            egui::CentralPanel::default()
                .frame(egui::Frame::NONE)
                .show(ui, |ui| picture(ui, studio));
        });
}

/// What the design can be changed by, in the order in which a costume is thought of.
fn column(ui: &mut Ui, studio: &mut Studio, show_tabs: fn(&mut Ui, &mut Studio)) {
    show_tabs(ui, studio);
    ui.add_space(2.0);
    let drawer = (DRAWERS.iter()).find(|drawer| drawer.tab == studio.tab);
    let own = drawer.map_or(&[][..], |drawer| drawer.panels);
    // The tab says it already.
    let title = drawer.map(|drawer| drawer.title);
    // Each drawer is as far scrolled as it was left.
    scrolled(ui, (studio.tab as usize, "left"), |ui| {
        panels(ui, studio, own, title);
    });
}

/// The tabs in a list that drops down, where there is no room for buttons.
fn tab_list(ui: &mut Ui, studio: &mut Studio) {
    let names: Vec<(Tab, String)> = super::tab_names(studio);
    let now = names.iter().find(|(tab, _)| *tab == studio.tab);
    let said = now.map_or_else(String::new, |(_, name)| name.clone());
    let mut chosen = studio.tab;
    let response = ComboBox::from_id_salt("tabs")
        .width(ui.available_width())
        .selected_text(said.clone())
        .show_ui(ui, |ui| {
            for (tab, name) in names {
                ui.selectable_value(&mut chosen, tab, name);
            }
        })
        .response;
    response.widget_info(|| {
        let name = studio.say(text::TABS);
        let mut info = egui::WidgetInfo::labeled(egui::Role::ComboBox, true, name);
        info.current_text_value = Some(said.clone());
        info
    });
    studio.tab = chosen;
}

/// What is measured and how it is computed; the way back stands above it.
fn research(ui: &mut Ui, studio: &mut Studio) {
    ui.horizontal(|ui| {
        let title = RichText::new(studio.say(text::RESEARCH)).heading();
        ui.label(title.color(look::RED));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.add(Button::new(studio.say(text::CLOSE))).clicked() {
                studio.researches = false;
            }
        });
    });
    scrolled(ui, "research", |ui| panels(ui, studio, RESEARCH, None));
}
