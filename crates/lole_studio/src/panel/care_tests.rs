//! The whole window for everybody: what a screen reader is told, what is pasted, and whether every word
//! has its room.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Pos2, Rect, Shape, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use lole_body::Measure;
use lole_costume::document::{Design, GarmentDesign, PartDesign};
use lole_language::{Language, Sentence};

use super::tests::{click, window};
use crate::chooser::{Entry, Lies, Listing};
use crate::making::Product;
use crate::message::Message;
use crate::paper::PaperDesign;
use crate::paper::tests::paper_of;
use crate::request::Verdict;
use crate::studio::{Purpose, Question, Request, Tab};
use crate::{Studio, look, panel, text};

/// A studio with something of everything in its panels.
fn furnished(language: Language) -> Studio {
    let mut design = Design::default();
    for id in ["blouse", "lei", "pau-skirt"] {
        design.garments.push(GarmentDesign::of_kind(id).unwrap());
    }
    design.motion.parts = vec![PartDesign::default(); 2];
    let mut studio = Studio::new(language, design, None);
    // Drafting takes longer than laying out, and is the same for all.
    static PAPER: OnceLock<Arc<PaperDesign>> = OnceLock::new();
    let paper = PAPER.get_or_init(|| Arc::new(paper_of(studio.design())));
    studio.paper = Some(Arc::clone(paper));
    studio.sews = false;
    studio
}

const CONTROLS: [Role; 8] = [
    Role::Button,
    Role::CheckBox,
    Role::ColorWell,
    Role::ComboBox,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::TextInput,
];

/// Controls of a window that a screen reader could not name.
fn nameless(window: &Harness<'static, Studio>) -> Vec<String> {
    let controls = window.root().children_recursive();
    controls
        .filter(|node| CONTROLS.contains(&node.accesskit_node().role()))
        .filter(|node| {
            let node = node.accesskit_node();
            node.label().is_none_or(|name| name.trim().is_empty())
        })
        .map(|node| format!("{node:?}"))
        .collect()
}

#[test]
fn a_screen_reader_can_name_every_control_in_both_languages() {
    let all_tabs: Vec<Tab> = panel::DRAWERS.iter().map(|drawer| drawer.tab).collect();
    for language in [Language::Japanese, Language::English] {
        for &tab in &all_tabs {
            let mut studio = furnished(language);
            studio.tab = tab;
            studio.shelf_is_open = true;
            let found = nameless(&window(studio));
            assert!(found.is_empty(), "{tab:?}, {language:?}: {found:#?}");
        }
    }
}

/// Controls that a fingertip does not meet.
fn small(window: &Harness<'static, Studio>) -> Vec<String> {
    let controls = window.root().children_recursive();
    controls
        .filter(|node| CONTROLS.contains(&node.accesskit_node().role()))
        .filter(|node| node.rect().size().min_elem() < look::TARGET - 0.5)
        .map(|node| format!("{} {:?}", node.rect().size(), node.accesskit_node().label()))
        .collect()
}

#[test]
fn every_control_is_as_large_as_a_fingertip() {
    for language in [Language::Japanese, Language::English] {
        for drawer in panel::DRAWERS {
            let mut studio = furnished(language);
            studio.tab = drawer.tab;
            studio.shelf_is_open = true;
            let found = small(&laid_out(studio, SIZES[0]));
            assert!(
                found.is_empty(),
                "{:?}, {language:?}: {found:#?}",
                drawer.tab
            );
        }
    }
}

#[test]
fn what_is_pasted_is_the_answer_to_a_question() {
    let mut studio = furnished(Language::Japanese);
    studio.question = Some(Question::new(Purpose::Open, ""));
    let mut window = window(studio);
    window.event(Event::Paste("ハウ.lole".to_owned()));
    window.run_steps(2);
    window.key_press(Key::Enter);
    window.run_steps(2);
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::Open("ハウ.lole".into())]);
}

/// Windows as they are laid out [point]: two sizes at 100 % and at 200 %.
const SIZES: [[f32; 2]; 4] = [
    [1280.0, 800.0],
    [800.0, 600.0],
    [640.0, 400.0],
    [400.0, 300.0],
];

/// Everything but the picture itself.
fn whole(ui: &mut Ui, studio: &mut Studio) {
    panel::frame(ui, studio, panel::notices);
    panel::start(ui, studio);
    panel::question(ui, studio);
}

/// The window as it is laid out in a size, without the picture.
fn laid_out(studio: Studio, size: [f32; 2]) -> Harness<'static, Studio> {
    let mut harness = Harness::builder()
        .with_size(size)
        .allow_missing_glyphs()
        .build_ui_state(whole, studio);
    look::apply(&harness.ctx);
    // Letters have their own widths, and not those of boxes.
    look::bring_letters(&harness.ctx);
    harness.run_steps(4);
    harness
}

/// Every text of a shape with the place where it is seen.
fn texts(shape: &Shape, clip: Rect, found: &mut Vec<(String, Rect, Rect, bool)>) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| texts(shape, clip, found)),
        Shape::Text(text) if !text.galley.text().trim().is_empty() => {
            let rect = text.visual_bounding_rect();
            found.push((
                text.galley.text().to_owned(),
                rect,
                clip,
                text.galley.elided,
            ));
        }
        _ => {}
    }
}

/// Texts that do not fit where they stand; `name` of the design is shortened by intent.
fn cut_off(window: &Harness<'static, Studio>, name: &str) -> Vec<String> {
    let mut found = Vec::new();
    for clipped in &window.output().shapes {
        texts(&clipped.shape, clipped.clip_rect, &mut found);
    }
    let bad = found.into_iter().filter(|(said, rect, clip, is_short)| {
        // What is scrolled away is not seen at all.
        let is_seen = rect.top() < clip.bottom() && clip.top() < rect.bottom();
        let is_out = rect.left() < clip.left() - 1.0 || clip.right() + 1.0 < rect.right();
        is_seen && (is_out || *is_short) && !said.starts_with(name)
    });
    bad.map(|(said, rect, clip, _)| format!("{said}: {rect} in {clip}"))
        .collect()
}

#[test]
fn no_text_is_cut_off_in_either_language_at_twice_the_size() {
    let all_tabs: Vec<Tab> = panel::DRAWERS.iter().map(|drawer| drawer.tab).collect();
    let mut found = Vec::new();
    for language in [Language::Japanese, Language::English] {
        for size in SIZES {
            for (tab, researches) in all_tabs
                .iter()
                .map(|tab| (*tab, false))
                .chain([(Tab::Dancer, true)])
            {
                let mut studio = furnished(language);
                studio.tab = tab;
                studio.shelf_is_open = true;
                studio.researches = researches;
                let name = studio.say(text::UNNAMED);
                let bad = cut_off(&laid_out(studio, size), name);
                found.extend(
                    bad.into_iter()
                        .map(|said| format!("{tab:?} {size:?} {said}")),
                );
            }
        }
    }
    for (language, size) in [Language::Japanese, Language::English]
        .into_iter()
        .flat_map(|language| SIZES.map(|size| (language, size)))
    {
        let mut studio = furnished(language);
        studio.starts = true;
        studio.memory.note_design(Path::new("ハウ.lole"));
        let name = studio.say(text::UNNAMED);
        found.extend(cut_off(&laid_out(studio, size), name));
        let mut studio = furnished(language);
        studio.question = Some(Question::new(Purpose::Make(Product::Booklet), "a.pdf"));
        found.extend(cut_off(&laid_out(studio, size), name));
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn in_every_size_there_is_a_way_to_panels_picture_and_research_and_back() {
    for size in SIZES {
        let mut window = laid_out(furnished(Language::English), size);
        click(&mut window, "For researchers…");
        window.get_by_label("Computation");
        click(&mut window, "Close");
        assert!(window.query_by_label("Computation").is_none());
        if let Some(button) = window.query_by_role_and_label(Role::Button, "Watch the dance") {
            button.click();
            window.run_steps(3);
            click(&mut window, "Front");
            click(&mut window, "Make");
        } else {
            click(&mut window, "Front");
        }
        let hip = Measure::Hip.words().english;
        assert!(window.query_all_by_label(hip).next().is_some());
    }
}

#[test]
fn what_is_said_is_seen_beside_the_panels_of_the_smallest_window_too() {
    for researches in [false, true] {
        let mut studio = furnished(Language::English);
        studio.researches = researches;
        let sentence = Sentence::new("書けません", "line 3 cannot be written");
        studio.message = Some(Message::trouble(&sentence));
        let mut window = laid_out(studio, [400.0, 300.0]);
        assert!(!window.state().watches);
        let said = window.get_by_label("line 3 cannot be written").rect();
        assert!(said.height() < 60.0 && said.bottom() < 300.0, "{said}");
        window.state_mut().researches = false;
        window.run_steps(3);
        click(&mut window, "Close");
        assert!(window.state().message.is_none());
    }
}

#[test]
fn a_question_fits_the_smallest_windows_with_its_list_and_its_buttons() {
    let entry = |number: usize| Entry {
        is_file: 3 < number,
        name: format!("{number}.lole"),
    };
    let listing = Arc::new(Listing {
        folder: "/silk/of/many/colors/and/names".into(),
        entries: (0..2000).map(entry).collect(),
        places: [
            "/silk",
            "/silk/デスクトップ",
            "/silk/ドキュメント",
            "/silk/画像",
        ]
        .map(Into::into)
        .into(),
        left_out: 17,
        ..Listing::default()
    });
    let mut found = Vec::new();
    for language in [Language::Japanese, Language::English] {
        for [width, height] in SIZES.into_iter().chain([[360.0, 260.0]]) {
            let mut studio = furnished(language);
            let mut question = Question::new(Purpose::Save, "/silk/a.lole");
            question.listing = Some(Arc::clone(&listing));
            question = match question.weigh(Lies::File) {
                Some(Verdict::Again(question)) => question,
                verdict => panic!("{verdict:?}"),
            };
            studio.question = Some(question);
            let [go, cancel, browse, unnamed] =
                [text::REPLACE, text::CANCEL, text::BROWSE, text::UNNAMED].map(|it| studio.say(it));
            let window = laid_out(studio, [width, height]);
            for label in [go, cancel, browse] {
                let rect = window.get_by_role_and_label(Role::Button, label).rect();
                let screen = Rect::from_min_size(Pos2::ZERO, vec2(width, height));
                if !screen.contains_rect(rect) {
                    found.push(format!("{label}: {rect} in {width} x {height}"));
                }
            }
            let first = window.get_by_role_and_label(Role::Button, "0.lole").rect();
            if height < 5.0 * first.height() || height - look::TARGET - 10.0 < first.bottom() {
                found.push(format!("the list: {first} in {width} x {height}"));
            }
            // Of a long folder only what is seen is laid out.
            assert!(window.query_by_label("900.lole").is_none());
            found.extend(cut_off(&window, unnamed));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn everything_grows_to_twice_its_size_and_back() {
    let mut window = laid_out(furnished(Language::English), [1280.0, 800.0]);
    for _ in 0..4 {
        click(&mut window, "Larger type");
    }
    assert!((window.ctx.zoom_factor() - 2.0).abs() < 1e-6);
    for _ in 0..4 {
        click(&mut window, "Smaller type");
    }
    assert!((window.ctx.zoom_factor() - 1.0).abs() < 1e-6);
}
