//! Below the picture: what was danced, to be seen again at any moment, slowly, a phrase over and over.

use eframe::egui::{self, Button, CornerRadius, Rect, RichText, Slider, Ui};

use super::knob;
use crate::take::Way;
use crate::{Studio, look, text};

/// Width of the time beside the slider [point].
const TIME_WIDTH: f32 = 64.0;
/// Narrower sliders lead nowhere [point].
const NARROWEST: f32 = 60.0;
/// Windows lower than this need the room for the picture [point].
const LOWEST: f32 = 360.0;
/// Of the line below the slider that shows the phrase [point].
const PHRASE_HEIGHT: f32 = 4.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let has_room = LOWEST <= ui.ctx().content_rect().height();
    if !has_room && studio.replay.is_none() {
        return;
    }
    slider(ui, studio);
    if studio.replay.is_some() {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(5.0, 5.0);
            ui.spacing_mut().button_padding.x = 9.0;
            phrase(ui, studio);
            if ui.button(studio.say(text::KEEP_BESIDE)).clicked() {
                studio.keep_beside();
            }
            let back = RichText::new(studio.say(text::DANCE_ON)).strong();
            if ui.button(back).clicked() {
                studio.dance_on();
            }
        });
    }
    if studio.kept.is_some() {
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(studio.say(text::WHO_IS_BESIDE)).small());
            if ui.button(studio.say(text::NOBODY_BESIDE)).clicked() {
                studio.kept = None;
            }
        });
    }
}

/// The whole of what was danced, and where in it the picture is.
fn slider(ui: &mut Ui, studio: &mut Studio) {
    let span = studio.take.span();
    let [first, last] = span.unwrap_or([0.0, 1.0]);
    let now = (studio.snapshot.as_ref()).map_or(first, |shown| shown.time.clamp(first, last));
    ui.horizontal(|ui| {
        let label = ui.label(studio.say(text::SEE_AGAIN));
        let room = ui.available_width() - TIME_WIDTH;
        ui.spacing_mut().slider_width = room.max(NARROWEST);
        let mut at = now;
        let slider = Slider::new(&mut at, first..=last).show_value(false);
        let response = ui.add_enabled(span.is_some(), slider);
        let response = response.labelled_by(label.id);
        if response.changed() && at.is_finite() {
            if let Some(replay) = &mut studio.replay {
                replay.plays = false;
            }
            studio.look_again(at);
        }
        let unit = studio.say(text::SECONDS);
        ui.label(RichText::new(format!("{now:.1} {unit}")).small());
        if let ([Some(_), _] | [_, Some(_)], Some([from, to])) =
            (studio.phrase, studio.phrase_span())
        {
            let rail = response.rect;
            let x = |time: f32| {
                let share = (time - first) / (last - first).max(f32::MIN_POSITIVE);
                rail.left() + share * rail.width()
            };
            let bottom = rail.bottom() - 2.0;
            let line = Rect::from_x_y_ranges(x(from)..=x(to), bottom - PHRASE_HEIGHT..=bottom);
            ui.painter()
                .rect_filled(line, CornerRadius::same(2), look::TEAL);
        }
    });
}

/// Frame by frame, and the phrase that is seen over and over.
fn phrase(ui: &mut Ui, studio: &mut Studio) {
    for (sign, name, way) in [
        ("⬅", text::FRAME_BEFORE, Way::Back),
        ("➡", text::FRAME_AFTER, Way::On),
    ] {
        if knob::sign_button(ui, sign, studio.say(name)) {
            studio.step_again(way);
        }
    }
    let at = studio.replay.as_ref().map(|replay| replay.at);
    for (end, name) in [text::PHRASE_FROM, text::PHRASE_TO].into_iter().enumerate() {
        let is_set = studio.phrase[end].is_some();
        let button = Button::selectable(is_set, studio.say(name)).frame_when_inactive(true);
        if ui.add(button).clicked() {
            studio.phrase[end] = at;
            let [from, to] = studio.phrase;
            if let (Some(from), Some(to)) = (from, to)
                && to <= from
            {
                // The other end was of another phrase.
                studio.phrase[1 - end] = None;
            }
            if let Some(replay) = &mut studio.replay {
                replay.plays = true;
            }
        }
    }
    let has_phrase = studio.phrase.iter().any(Option::is_some);
    let all = Button::new(studio.say(text::PHRASE_ALL));
    if ui.add_enabled(has_phrase, all).clicked() {
        studio.phrase = [None; 2];
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use eframe::egui::Key;
    use egui_kittest::kittest::{NodeT as _, Queryable as _};
    use lole_costume::document::Design;
    use lole_language::Language;

    use super::super::tests::{click, window};
    use super::*;
    use crate::Command;
    use crate::take::tests::{moment, wardrobe};

    #[test]
    fn what_was_danced_is_seen_again_by_the_slider_and_left_by_its_button() {
        let mut studio = Studio::new(Language::English, Design::default(), None);
        let wardrobe = wardrobe();
        for second in 0_u8..=9 {
            studio.receive(Arc::new(moment(&wardrobe, f32::from(second))));
        }
        let mut window = window(studio);
        assert!(window.query_by_label("Back to the dance").is_none());
        let slider = |window: &egui_kittest::Harness<'static, Studio>| {
            let role = egui::accesskit::Role::Slider;
            let node = window.get_by_role_and_label(role, "See again");
            let value = node.accesskit_node().numeric_value();
            (value, node.focus())
        };
        assert_eq!(slider(&window).0, Some(9.0));
        window.run_steps(2);
        window.key_press(Key::ArrowLeft);
        window.run_steps(3);
        let shown = slider(&window).0.expect("a slider has a value");
        assert!(shown < 9.0, "{shown}");
        assert_eq!(window.state_mut().take_commands(), [Command::Pause]);
        click(&mut window, "From here");
        assert!(
            window
                .state()
                .replay
                .as_ref()
                .is_some_and(|replay| replay.plays)
        );
        click(&mut window, "One frame back");
        // The first one that was kept before it.
        assert_eq!(slider(&window).0, Some(8.0));
        click(&mut window, "To here");
        let phrase = window.state().phrase;
        assert_eq!(phrase, [None, Some(8.0)]);
        click(&mut window, "Back to the dance");
        assert_eq!(slider(&window).0, Some(9.0));
        assert_eq!(window.state_mut().take_commands(), [Command::Play]);
        assert_eq!(window.state().phrase, [None; 2]);
    }
}
