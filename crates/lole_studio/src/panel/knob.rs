//! A slider with its name above and its value beside it, as wide as the panel.

use std::ops::RangeInclusive;

use eframe::egui::{self, Response, Slider, Ui};

use crate::{look, studio};

/// Width of the value beside a slider [point].
const VALUE_WIDTH: f32 = 108.0;

/// What a slider shows.
pub(super) struct Knob<'a> {
    /// Its name.
    pub(super) name: &'a str,
    /// Smallest and largest value.
    pub(super) range: RangeInclusive<f64>,
    /// Digits after the point.
    pub(super) decimals: usize,
    /// Unit behind the value, with its space.
    pub(super) unit: &'a str,
    /// How values lie along the slider.
    pub(super) scale: Scale,
}

/// How values lie along a slider.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Even,
    /// Each step multiplies.
    Factors,
}

impl Knob<'_> {
    /// With what a key of the document may be as the widest range.
    pub(super) fn within(self, table: &str, key: &str) -> Self {
        let (min, max) = studio::range(table, key);
        let range = min.max(*self.range.start())..=max.min(*self.range.end());
        Self { range, ..self }
    }

    /// Shows it; the new value while it is moved.
    pub(super) fn show(self, ui: &mut Ui, value: f64) -> (Response, Option<f64>) {
        let mut moved = value;
        let label = ui.label(self.name);
        ui.spacing_mut().slider_width = (ui.available_width() - VALUE_WIDTH).max(60.0);
        let slider = Slider::new(&mut moved, self.range)
            .logarithmic(self.scale == Scale::Factors)
            .fixed_decimals(self.decimals)
            .suffix(self.unit)
            // Half a number is none.
            .update_while_editing(false);
        let response = ui.add(slider).labelled_by(label.id);
        let is_moved = response.changed() && moved.is_finite();
        (response, is_moved.then_some(moved))
    }
}

/// Room between buttons that stand side by side [point].
const GAP: f32 = 6.0;

/// Buttons of which one is chosen, each as wide as the others, in as few rows as have room for them.
pub(super) fn choice<T: PartialEq + Copy>(
    ui: &mut Ui,
    chosen: Option<T>,
    options: &[(T, &str)],
) -> Option<T> {
    let mut picked = None;
    let room = ui.available_width();
    let widest = options.iter().map(|(_, name)| width_of(ui, name));
    let widest = widest.fold(30.0, f32::max) + 2.0 * PADDING;
    let fit = (1..=options.len()).rev().find(|count| {
        let gaps = GAP * (as_float(*count) - 1.0);
        as_float(*count) * widest + gaps <= room
    });
    let row_count = options.len().div_ceil(fit.unwrap_or(1)).max(1);
    let in_row = options.len().div_ceil(row_count).max(1);
    let width = ((room - GAP * (as_float(in_row) - 1.0)) / as_float(in_row)).max(30.0);
    for row in options.chunks(in_row) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            ui.spacing_mut().button_padding.x = PADDING;
            let size = egui::vec2(width, ui.spacing().interact_size.y);
            for &(option, name) in row {
                let button = egui::Button::selectable(chosen == Some(option), name)
                    .frame_when_inactive(true)
                    .wrap()
                    .min_size(size);
                if ui.add(button).clicked() {
                    picked = Some(option);
                }
            }
        });
    }
    picked
}

/// Room beside the words of a button of [`choice`] [point].
const PADDING: f32 = 4.0;

#[expect(clippy::cast_precision_loss, reason = "a handful of buttons")]
const fn as_float(count: usize) -> f32 {
    count as f32
}

/// Buttons of which one is chosen, each as wide as its words, among others in a row.
pub(super) fn loose_choice<T: PartialEq + Copy>(
    ui: &mut Ui,
    chosen: Option<T>,
    options: &[(T, &str)],
) -> Option<T> {
    let mut picked = None;
    for &(option, name) in options {
        let button = egui::Button::selectable(chosen == Some(option), name)
            .frame_when_inactive(true)
            .min_size(egui::Vec2::splat(look::TARGET));
        if ui.add(button).clicked() {
            picked = Some(option);
        }
    }
    picked
}

/// Width of a line of ordinary text [point].
pub(super) fn width_of(ui: &Ui, text: &str) -> f32 {
    let font = egui::TextStyle::Body.resolve(ui.style());
    let color = ui.visuals().text_color();
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, color);
    galley.size().x
}

/// Words that begin at the left of a place of this size, in as many lines as they need.
pub(super) fn left_label(
    ui: &mut Ui,
    size: egui::Vec2,
    words: impl Into<egui::WidgetText>,
) -> Response {
    let words = words.into();
    let place = egui::Layout::left_to_right(egui::Align::Center);
    let label = ui.allocate_ui_with_layout(size, place, |ui| {
        ui.set_min_size(size);
        ui.add(egui::Label::new(words).wrap())
    });
    label.inner
}

/// A button as wide as the panel; whether it was clicked.
pub(super) fn wide_button(ui: &mut Ui, name: &str) -> bool {
    let size = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.add(egui::Button::new(name).wrap().min_size(size))
        .clicked()
}

/// Size of a button with a sign [point].
pub(super) const SIGN: egui::Vec2 = egui::vec2(look::TARGET, look::TARGET);

/// A small button with a sign that is read out as `name`; whether it was clicked.
pub(super) fn sign_button(ui: &mut Ui, sign: &str, name: &str) -> bool {
    let enabled = ui.is_enabled();
    let button = egui::Button::new(sign).min_size(SIGN);
    let slim = |ui: &mut Ui| {
        ui.spacing_mut().button_padding.x = 2.0;
        ui.add(button)
    };
    let response = ui.scope(slim).inner.on_hover_text(name);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, enabled, name));
    response.clicked()
}

/// A list that drops down below its name, as wide as the panel.
pub(super) struct DropDown<'a, S> {
    /// What tells it from the other lists of its panel.
    pub(super) salt: S,
    /// Its name.
    pub(super) name: &'a str,
}

impl<S: egui::AsIdSalt> DropDown<'_, S> {
    /// Shows it; the new choice.
    pub(super) fn show<T: PartialEq + Copy>(
        self,
        ui: &mut Ui,
        chosen: T,
        options: &[(T, String)],
    ) -> Option<T> {
        let label = ui.label(self.name);
        let mut picked = chosen;
        let known = options.iter().find(|(option, _)| *option == chosen);
        egui::ComboBox::from_id_salt(self.salt)
            .width(ui.available_width())
            .wrap()
            .selected_text(known.map_or("", |(_, name)| name))
            .show_ui(ui, |ui| {
                for (option, name) in options {
                    ui.selectable_value(&mut picked, *option, name);
                }
            })
            .response
            .labelled_by(label.id);
        (picked != chosen).then_some(picked)
    }
}
