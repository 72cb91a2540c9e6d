//! The panels without a display: what a click sends, what a language shows, what trouble says.

use std::path::PathBuf;

use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use lole_body::DanceStep;
use lole_costume::document::{Design, MethodName};
use lole_language::{Language, Sentence};
use lole_stage::Divergence;

use super::{LEFT, RIGHT};
use crate::message::Message;
use crate::studio::{Purpose, Question, Request};
use crate::{Command, Studio, panel};

/// All panels above each other, tall enough that nothing scrolls away.
fn window(studio: Studio) -> Harness<'static, Studio> {
    let show = |ui: &mut eframe::egui::Ui, studio: &mut Studio| {
        panel::document_bar(ui, studio);
        panel::status_bar(ui, studio);
        panel::notices(ui, studio);
        let all: Vec<_> = LEFT.iter().chain(RIGHT).collect();
        panel::column(ui, studio, &all);
        panel::question(ui, studio);
    };
    let mut harness = Harness::builder()
        .with_size([420.0, 2000.0])
        .allow_missing_glyphs()
        .build_ui_state(show, studio);
    harness.run_steps(3);
    harness
}

fn studio(language: Language) -> Studio {
    let mut studio = Studio::new(language, Design::default(), None);
    studio.sews = false;
    studio
}

fn click(harness: &mut Harness<'static, Studio>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click();
    harness.run_steps(3);
}

fn commands(harness: &mut Harness<'static, Studio>) -> Vec<Command> {
    harness.state_mut().take_commands()
}

#[test]
fn pausing_stepping_slowing_and_resetting_are_sent() {
    let mut window = window(studio(Language::English));
    click(&mut window, "Pause");
    assert_eq!(commands(&mut window), [Command::Pause]);
    click(&mut window, "One frame");
    assert_eq!(commands(&mut window), [Command::Step]);
    click(&mut window, "×¼");
    assert_eq!(commands(&mut window), [Command::Speed(0.25)]);
    click(&mut window, "Dance");
    assert_eq!(commands(&mut window), [Command::Play]);
    click(&mut window, "Reset");
    assert_eq!(commands(&mut window), [Command::Reset, Command::Play]);
}

#[test]
fn another_step_is_wished_at_once() {
    let mut window = window(studio(Language::English));
    click(&mut window, DanceStep::Ami.name());
    let [Command::Wish(design)] = &commands(&mut window)[..] else {
        panic!("no wish was sent");
    };
    assert_eq!(design.motion.step, DanceStep::Ami);
}

#[test]
fn every_method_of_the_document_can_be_chosen() {
    for method in MethodName::ALL {
        let mut window = window(studio(Language::English));
        window.get_by_role(Role::ComboBox).click();
        window.run_steps(3);
        let label = format!("{}  {}", method.id(), crate::text::method(method).english);
        click(&mut window, &label);
        assert_eq!(window.state().design().method.name, method);
    }
}

#[test]
fn the_language_switch_changes_the_labels_and_nothing_else() {
    let mut window = window(studio(Language::English));
    let before = window.state().design().clone();
    click(&mut window, "日本語");
    assert_eq!(window.state().language, Language::Japanese);
    for label in ["止める", "1コマ進む", "最初から", "開く…"] {
        window.get_by_role_and_label(Role::Button, label);
    }
    assert!(window.query_by_label("Pause").is_none());
    click(&mut window, "English");
    window.get_by_role_and_label(Role::Button, "Pause");
    assert_eq!(*window.state().design(), before);
    assert!(commands(&mut window).is_empty());
}

#[test]
fn cloth_that_flew_apart_says_when_and_where_and_offers_a_reset() {
    for (language, reset, part) in [
        (
            Language::English,
            "Reset",
            "1.25 s, first at row 7, column 30",
        ),
        (Language::Japanese, "最初から", "1.25 秒に、7 行 30 列から"),
    ] {
        let mut studio = studio(language);
        studio.stopped = Some(Divergence {
            time: 1.25,
            garment: 0,
            row: 7,
            column: 30,
        });
        let mut window = window(studio);
        window.get_by_label_contains(part);
        let buttons: Vec<_> = window
            .get_all_by_role_and_label(Role::Button, reset)
            .collect();
        buttons[0].click();
        drop(buttons);
        window.run_steps(3);
        assert_eq!(commands(&mut window), [Command::Reset, Command::Play]);
    }
}

#[test]
fn overlays_that_cost_time_are_asked_for_and_called_off() {
    let mut window = window(studio(Language::English));
    for shown in [true, false] {
        window
            .get_by_role_and_label(Role::CheckBox, "Strain")
            .click();
        window.run_steps(3);
        let sent = commands(&mut window);
        assert!(
            matches!(&sent[..], [Command::Watch(watch)] if watch.strain == shown),
            "{sent:?}"
        );
    }
}

#[test]
fn saving_asks_where_only_the_first_time() {
    let mut window = window(studio(Language::English));
    click(&mut window, "Save");
    assert_eq!(window.state_mut().take_requests(), [Request::AskSave]);
    window.state_mut().saved_at(PathBuf::from("hau.lole"));
    window.run_steps(2);
    click(&mut window, "Save");
    let path = PathBuf::from("hau.lole");
    assert_eq!(window.state_mut().take_requests(), [Request::Save(path)]);
    window.get_by_label_contains("hau.lole");
}

#[test]
fn a_question_for_a_file_can_be_answered_and_given_up() {
    let mut studio = studio(Language::English);
    studio.question = Some(Question {
        purpose: Purpose::Open,
        path: "a.lole".to_owned(),
    });
    let mut window = window(studio);
    click(&mut window, "Open");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::Open(PathBuf::from("a.lole"))]);
    assert!(window.state().question.is_none());
    window.state_mut().question = Some(Question {
        purpose: Purpose::Save,
        path: String::new(),
    });
    window.run_steps(3);
    click(&mut window, "Cancel");
    assert!(window.state().question.is_none());
    assert!(window.state_mut().take_requests().is_empty());
}

#[test]
fn a_message_stays_until_it_is_closed() {
    let mut studio = studio(Language::Japanese);
    let sentence = Sentence::new("3行目がちがいます", "line 3 is wrong");
    studio.message = Some(Message::trouble(&sentence));
    let mut window = window(studio);
    window.get_by_label("3行目がちがいます");
    click(&mut window, "閉じる");
    assert!(window.query_by_label("3行目がちがいます").is_none());
}

#[test]
fn a_slider_moved_by_keys_changes_the_design_within_its_range() {
    let mut window = window(studio(Language::English));
    let slider = window.get_by_role_and_label(Role::Slider, "Wind");
    assert_eq!(slider.accesskit_node().numeric_value(), Some(0.0));
    slider.focus();
    window.run_steps(2);
    window.key_press(eframe::egui::Key::ArrowRight);
    window.run_steps(3);
    let sent = commands(&mut window);
    let Some(Command::Wish(design)) = sent.last() else {
        panic!("{sent:?}");
    };
    assert!(0.0 < design.wind.speed_m_per_s && design.wind.speed_m_per_s <= 8.0);
}
