//! The light theme: paper, ink and one red, in type that can be read at arm's length.

use eframe::egui::{
    self, Color32, CornerRadius, FontFamily, FontId, Margin, Stroke, Style, TextStyle, Vec2,
    style::ScrollStyle,
};

/// Size of ordinary text [point].
const BODY: f32 = 16.0;
/// Size of the smallest text [point].
const SMALL: f32 = 14.5;
/// Size of a panel's title [point].
const HEADING: f32 = 18.0;

/// Height of what can be clicked, and the least width of it [point]: a fingertip.
pub(crate) const TARGET: f32 = 40.0;

pub(crate) const PAPER: Color32 = Color32::from_rgb(250, 247, 241);
pub(crate) const CARD: Color32 = Color32::from_rgb(255, 254, 251);
pub(crate) const INK: Color32 = Color32::from_rgb(38, 32, 28);
pub(crate) const PALE_INK: Color32 = Color32::from_rgb(96, 86, 78);
/// Between things; nothing depends on seeing it.
pub(crate) const LINE: Color32 = Color32::from_rgb(217, 208, 195);
/// Around what can be clicked or typed in.
const OUTLINE: Color32 = Color32::from_rgb(108, 98, 89);
pub(crate) const RED: Color32 = Color32::from_rgb(170, 28, 50);
pub(crate) const PALE_RED: Color32 = Color32::from_rgb(246, 222, 218);
pub(crate) const TEAL: Color32 = Color32::from_rgb(0, 112, 122);
pub(crate) const OCHRE: Color32 = Color32::from_rgb(190, 120, 0);
const KEY: Color32 = Color32::from_rgb(238, 231, 220);
const KEY_HOVERED: Color32 = Color32::from_rgb(229, 219, 204);
const KEY_PRESSED: Color32 = Color32::from_rgb(217, 204, 185);

/// Gives the window the letters of paper, after its own: a machine may have no Japanese font.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn bring_letters(context: &egui::Context) {
    use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
    let families = [FontFamily::Proportional, FontFamily::Monospace];
    let families = families.map(|family| InsertFontFamily {
        family,
        priority: FontPriority::Lowest,
    });
    let font = egui::FontData::from_static(lole_export::pdf::regular_font());
    context.add_font(FontInsert::new("letters", font, families.into()));
}

/// Dresses the window.
pub(crate) fn apply(context: &egui::Context) {
    context.set_theme(egui::Theme::Light);
    // A letter that no font has is shown as a box instead of ending all.
    context.set_missing_glyph_policy(egui::MissingGlyphPolicy::Tofu);
    context.all_styles_mut(style);
}

fn style(style: &mut Style) {
    let font = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles = [
        (TextStyle::Small, font(SMALL)),
        (TextStyle::Body, font(BODY)),
        (TextStyle::Button, font(BODY)),
        (TextStyle::Heading, font(HEADING)),
        (
            TextStyle::Monospace,
            FontId::new(BODY, FontFamily::Monospace),
        ),
    ]
    .into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = Vec2::new(8.0, 7.0);
    spacing.button_padding = Vec2::new(11.0, 6.0);
    spacing.interact_size = Vec2::new(44.0, TARGET);
    spacing.icon_width = 20.0;
    spacing.icon_width_inner = 12.0;
    spacing.slider_rail_height = 6.0;
    spacing.combo_height = 320.0;
    spacing.scroll = ScrollStyle {
        bar_width: 8.0,
        ..ScrollStyle::solid()
    };
    spacing.window_margin = Margin::same(14);
    let visuals = &mut style.visuals;
    visuals.panel_fill = PAPER;
    visuals.window_fill = CARD;
    visuals.window_stroke = Stroke::new(1.0, LINE);
    visuals.window_corner_radius = CornerRadius::same(10);
    visuals.extreme_bg_color = CARD;
    visuals.faint_bg_color = KEY;
    visuals.weak_text_color = Some(PALE_INK);
    visuals.selection.bg_fill = RED;
    visuals.selection.stroke = Stroke::new(1.0, Color32::WHITE);
    visuals.slider_trailing_fill = true;
    let radius = CornerRadius::same(7);
    for (widget, fill, line) in [
        (&mut visuals.widgets.noninteractive, PAPER, LINE),
        (&mut visuals.widgets.inactive, KEY, OUTLINE),
        (&mut visuals.widgets.hovered, KEY_HOVERED, INK),
        (&mut visuals.widgets.active, KEY_PRESSED, INK),
        (&mut visuals.widgets.open, KEY_HOVERED, INK),
    ] {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = Stroke::new(1.0, line);
        widget.fg_stroke = Stroke::new(1.5, INK);
        widget.corner_radius = radius;
        widget.expansion = 0.0;
    }
}

/// Dresses what is typed in: its outline while it has the keyboard is dark, and so are words that are
/// selected in it. Chosen buttons have both the other way round.
pub(crate) fn typing(ui: &mut egui::Ui) {
    let selection = &mut ui.visuals_mut().selection;
    selection.stroke = Stroke::new(2.0, INK);
    selection.bg_fill = PALE_RED;
}

/// A card that stands for one thing of a list.
pub(crate) fn card(fill: Color32) -> egui::Frame {
    egui::Frame::new()
        .fill(fill)
        .stroke(Stroke::new(1.0, LINE))
        .corner_radius(7)
}

/// Color of a strain, linear, for the cloth: blue where it is shrunk, red where it is stretched;
/// full at ±[`FULL_STRAIN`]. Blue and red stay apart for color-blind eyes.
pub(crate) fn strain_color(strain: f32) -> glam::Vec3 {
    use glam::Vec3;
    const CALM: Vec3 = Vec3::new(0.80, 0.78, 0.74);
    const SHRUNK: Vec3 = Vec3::new(0.03, 0.16, 0.62);
    const STRETCHED: Vec3 = Vec3::new(0.72, 0.05, 0.02);
    let share = (strain / FULL_STRAIN).clamp(-1.0, 1.0);
    let end = if share < 0.0 { SHRUNK } else { STRETCHED };
    CALM.lerp(end, share.abs().sqrt())
}

/// Strain that is shown in full color.
pub(crate) const FULL_STRAIN: f32 = 0.05;

#[cfg(test)]
mod tests {
    use eframe::egui::Rgba;

    use super::*;

    /// Contrast of two colors as the guidelines for accessible pages define it: 1 to 21.
    fn contrast(one: Color32, other: Color32) -> f32 {
        let luminance = |color: Color32| {
            let linear = Rgba::from(color);
            0.2126 * linear.r() + 0.7152 * linear.g() + 0.0722 * linear.b()
        };
        let [a, b] = [luminance(one), luminance(other)];
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn contrast_of_black_on_white_is_that_of_the_definition() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-3);
    }

    #[test]
    fn words_and_outlines_stand_out_from_everything_they_lie_on() {
        const LEAST: f32 = 4.5;
        let mut dressed = Style::default();
        style(&mut dressed);
        let visuals = &dressed.visuals;
        let widgets = &visuals.widgets;
        let grounds = [PAPER, CARD, PALE_RED];
        for widget in [
            &widgets.inactive,
            &widgets.hovered,
            &widgets.active,
            &widgets.open,
        ] {
            assert!(LEAST <= contrast(widget.fg_stroke.color, widget.bg_fill));
            for ground in grounds.into_iter().chain([widget.bg_fill]) {
                assert!(LEAST <= contrast(widget.bg_stroke.color, ground));
            }
        }
        let weak = visuals.weak_text_color.unwrap();
        let text = widgets.noninteractive.fg_stroke.color;
        for ink in [text, weak, RED, TEAL] {
            for ground in grounds {
                assert!(LEAST <= contrast(ink, ground), "{ink:?} on {ground:?}");
            }
        }
        let chosen = &visuals.selection;
        assert!(LEAST <= contrast(chosen.stroke.color, chosen.bg_fill));
    }

    #[test]
    fn japanese_and_hawaiian_are_written_on_a_machine_without_fonts() {
        let context = egui::Context::default();
        bring_letters(&context);
        let mut seen = false;
        // Fonts that are added come in the next pass.
        for _ in 0..2 {
            let mut output = context.run_ui(egui::RawInput::default(), |ui| {
                let has = |fonts: &mut egui::epaint::FontsView<'_>| {
                    fonts.has_glyphs(&FontId::proportional(BODY), "日本語の型紙と髙﨑 －＋ pāʻū")
                };
                seen = ui.ctx().fonts_mut(has);
            });
            output.textures_delta.clear();
        }
        assert!(seen);
    }
}
