//! What leaves the window and what comes into it: products of the design, files that are chosen, the
//! first page, a group's dancers.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::roster;
use lole_language::{Language, Sentence};

use super::tests::{click, window};
use crate::chooser::{Entry, Lies, Listing};
use crate::making::{Piece, Product, Stage};
use crate::message::Message;
use crate::paper::tests::paper_of;
use crate::request::Verdict;
use crate::studio::{Purpose, Question, Request, Tab};
use crate::{Studio, panel};

fn studio(tab: Tab) -> Studio {
    let mut studio = Studio::new(Language::English, Design::default(), None);
    studio.sews = false;
    studio.tab = tab;
    studio
}

/// A window in which the first film is being made and the second waits.
fn with_two_films() -> Harness<'static, Studio> {
    let mut window = window(studio(Tab::Cutting));
    let piece = |number, stage| Piece {
        number,
        product: Product::Film,
        path: PathBuf::from("hula.mp4"),
        stage,
    };
    let pieces = &mut window.state_mut().making.pieces;
    *pieces = vec![piece(1, Stage::Working(0.4)), piece(2, Stage::Waiting)];
    window.run_steps(3);
    window
}

#[test]
fn every_product_is_asked_for_with_its_place() {
    let mut window = window(studio(Tab::Cutting));
    for product in Product::ALL {
        click(&mut window, &format!("{}…", product.name().english));
        let requests = window.state_mut().take_requests();
        assert_eq!(requests, [Request::AskMake(product)]);
        let purpose = Purpose::Make(product);
        window.state_mut().question = Some(Question::new(purpose, "here"));
        window.run_steps(3);
        window.key_press(Key::Enter);
        window.run_steps(3);
        let requests = window.state_mut().take_requests();
        assert_eq!(requests, [Request::Make(product, "here".into())]);
    }
}

#[test]
fn a_product_can_be_called_off_and_once_done_its_folder_opened() {
    let mut window = with_two_films();
    click(&mut window, "Cancel 2");
    click(&mut window, "Cancel 1");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::CallOff(2), Request::CallOff(1)]);
    // What is under way is not forgotten.
    window.state_mut().making.forget(1);
    assert_eq!(window.state().making.pieces.len(), 2);
    assert!(window.state_mut().making.note(1, Stage::Done).is_some());
    window.run_steps(3);
    click(&mut window, "Open the folder 1");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::Reveal("hula.mp4".into())]);
    click(&mut window, "Close 1");
    assert_eq!(window.state().making.pieces.len(), 1);
}

#[test]
fn a_message_of_something_written_opens_its_folder() {
    let mut studio = studio(Tab::Dancer);
    let message = Message::news("できました", "done").at(Path::new("order"));
    studio.message = Some(message);
    let mut window = window(studio);
    click(&mut window, "Open the folder");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::Reveal("order".into())]);
}

#[test]
fn a_file_is_chosen_from_a_list_without_any_other_program() {
    let mut studio = studio(Tab::Dancer);
    let mut question = Question::new(Purpose::Save, "/silk/hula.lole");
    let entry = |is_file, name: &str| Entry {
        is_file,
        name: name.to_owned(),
    };
    question.listing = Some(Arc::new(Listing {
        folder: PathBuf::from("/silk"),
        entries: vec![entry(false, "red"), entry(true, "a.lole")],
        places: vec![PathBuf::from("/silk"), PathBuf::from("/silk/Desktop")],
        ..Listing::default()
    }));
    question.note = Some(Sentence::new("なし", "no window"));
    studio.question = Some(question);
    let mut window = window(studio);
    window.get_by_label("no window");
    // The name that is to be written stays while folders are looked into.
    click(&mut window, "red");
    let path = |window: &Harness<'static, Studio>| {
        PathBuf::from(&window.state().question.as_ref().unwrap().path)
    };
    assert_eq!(path(&window), Path::new("/silk/red/hula.lole"));
    click(&mut window, "Desktop");
    click(&mut window, "To the folder above");
    let folders = ["/silk/red", "/silk/Desktop", "/"];
    let looked: Vec<_> = folders.map(|it| Request::ListFolder(it.into())).into();
    assert_eq!(window.state_mut().take_requests(), looked);
    click(&mut window, "a.lole");
    assert_eq!(path(&window), Path::new("/silk/a.lole"));
    click(&mut window, "The system’s own window…");
    assert_eq!(window.state_mut().take_requests(), [Request::Browse]);
    window.key_press(Key::Escape);
    window.run_steps(3);
    assert!(window.state().question.is_none());
}

#[test]
fn the_first_page_begins_with_a_costume_a_design_of_before_or_as_it_is() {
    let begun = |label: &str| {
        let mut studio = studio(Tab::Dancer);
        studio.starts = true;
        studio.memory.note_design(Path::new("silk/hau.lole"));
        let mut window = window(studio);
        click(&mut window, label);
        // Until a file is opened, the page is what is come back to.
        let requests = window.state_mut().take_requests();
        let asks = matches!(requests[..], [Request::AskOpen | Request::AskRoster]);
        assert_eq!(window.state().starts, asks);
        (window.state().design().clone(), requests)
    };
    let (design, requests) = begun("Muʻumuʻu");
    assert!(!design.skirt.is_worn && design.garments[0].kind_id() == "muumuu");
    assert!(requests.is_empty());
    let (design, requests) = begun("hau");
    assert_eq!(design, Design::default());
    assert_eq!(requests, [Request::Open("silk/hau.lole".into())]);
    assert!(begun("Begin as it is").1.is_empty());
    assert_eq!(begun("Open a design…").1, [Request::AskOpen]);
    assert_eq!(begun("Choose a list…").1, [Request::AskRoster]);
}

#[test]
fn the_first_page_comes_back_when_its_question_is_given_up_and_goes_with_a_design() {
    let mut studio = studio(Tab::Dancer);
    studio.starts = true;
    studio.question = Some(Question::new(Purpose::Open, "a.lole"));
    let mut window = window(studio);
    assert!(window.query_by_label("Begin as it is").is_none());
    window.key_press(Key::Escape);
    window.run_steps(3);
    window.get_by_label("Begin as it is");
    let path = PathBuf::from("a.lole");
    (window.state_mut()).opened(Design::default(), Some(path));
    window.run_steps(3);
    assert!(window.query_by_label("Begin as it is").is_none());
    window.state_mut().starts = true;
    let work = window.state().work();
    window.state_mut().resume(work);
    assert!(!window.state().starts);
}

#[test]
fn what_is_called_off_says_so_at_once() {
    let mut window = with_two_films();
    click(&mut window, "Cancel 2");
    window.get_by_label("Called off; nothing was written.");
    click(&mut window, "Cancel 1");
    window.get_by_label("Stopping…");
    // News from before is no news.
    let making = &mut window.state_mut().making;
    assert!(making.note(1, Stage::Working(0.5)).is_none());
    assert!(making.note(2, Stage::Working(0.0)).is_none());
    let stages = [&making.pieces[0].stage, &making.pieces[1].stage];
    assert_eq!(stages, [&Stage::Stopping, &Stage::CalledOff]);
    assert!(making.note(1, Stage::CalledOff).is_some());
}

#[test]
fn a_file_that_is_there_is_replaced_by_a_button_that_says_so() {
    let mut studio = studio(Tab::Dancer);
    let question = Question::new(Purpose::Save, "/silk/hula.lole");
    let Some(Verdict::Again(question)) = question.weigh(Lies::File) else {
        panic!("a design was replaced without a word")
    };
    studio.question = Some(question);
    let mut window = window(studio);
    window.get_by_label_contains("hula.lole is there already");
    // A key that is still held agrees to nothing.
    window.key_press(Key::Enter);
    window.run_steps(3);
    assert!(window.state_mut().take_requests().is_empty());
    let save = || Request::Save("/silk/hula.lole".into());
    click(&mut window, "Replace it");
    assert_eq!(window.state_mut().take_requests(), [save()]);
    let answered = window.state_mut().answered.take().unwrap();
    let agreed = answered.clone().weigh(Lies::File);
    assert_eq!(agreed, Some(Verdict::Goes(save())));
    // Another name is another question.
    window.state_mut().question = Some(Question {
        path: "/silk/other.lole".to_owned(),
        ..answered
    });
    window.run_steps(3);
    assert!(window.query_by_label("Replace it").is_none());
    assert!(window.query_by_label_contains("is there already").is_none());
}

#[test]
fn a_picture_is_printed_on_the_first_thing_of_cloth() {
    let mut studio = studio(Tab::Cloth);
    assert_eq!(panel::first_of_cloth(&studio), Some(None));
    let worn = |studio: &mut Studio, kinds: &[&str]| {
        studio.change(|design| {
            design.skirt.is_worn = false;
            let garments = kinds.iter().filter_map(|id| GarmentDesign::of_kind(id));
            design.garments = garments.collect();
        });
        studio.paper = Some(Arc::new(paper_of(studio.design())));
    };
    worn(&mut studio, &["ti-leaf-skirt", "pau-top"]);
    assert_eq!(panel::first_of_cloth(&studio), Some(Some(1)));
    worn(&mut studio, &["ti-leaf-skirt", "lei"]);
    assert_eq!(panel::first_of_cloth(&studio), None);
}

#[test]
fn a_dancer_of_the_list_is_dressed_by_a_click_with_her_figures_to_the_millimeter() {
    let mut studio = studio(Tab::Order);
    let list = roster::read("name,stature,hip\n宮崎 はな子,155.5,98\nNani,150,85\n".as_bytes());
    studio.order.list = Some((PathBuf::from("hula.csv"), Arc::new(list.unwrap())));
    let mut window = window(studio);
    window.get_by_label("155.5");
    click(&mut window, "宮崎 はな子");
    let dancer = window.state().design().dancer.clone();
    assert_eq!(
        (dancer.stature_cm, dancer.hip_cm),
        (Some(155.5), Some(98.0))
    );
    window.get_by_label_contains("Dressing 宮崎 はな子");
    click(&mut window, "Undo");
    assert_eq!(*window.state().design(), Design::default());
}

#[test]
fn everybody_of_the_list_is_filmed_as_they_are_to_stand() {
    let mut studio = studio(Tab::Order);
    let list = roster::read("name,stature,hip\nHanako,155.5,98\nNani,150,85\n".as_bytes());
    studio.order.list = Some((PathBuf::from("hula.csv"), Arc::new(list.unwrap())));
    let mut window = window(studio);
    let product = Product::GroupFilm;
    click(&mut window, &format!("{}…", product.name().english));
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::AskMake(product)]);
    window.state_mut().making.pieces = vec![Piece {
        number: 1,
        product,
        path: PathBuf::from("all.mp4"),
        stage: Stage::Working(0.4),
    }];
    window.run_steps(3);
    window.get_by_label("40 %");
}
