//! The panels without a display: what a click sends, what a language shows, what trouble says.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use lole_avatar::AnimationSummary;
use lole_body::{Bone, Figure, Side};
use lole_cloth::wind::WindLaw;
use lole_costume::document::{
    Design, GarmentDesign, LinkedFile, MethodName, MotionDrift, MotionRepeat, PartDesign,
    StageMood, StageSet, Uncrossed, WindModel,
};
use lole_costume::fabrics::PRESETS;
use lole_hula::DanceStep;
use lole_hula::SCHOOLS;
use lole_language::{Language, Sentence};
use lole_stage::{Divergence, PartNow};

use crate::message::Message;
use crate::panel::ClipShelf;
use crate::studio::{Purpose, Question, Request, Tab};
use crate::{Command, Studio, panel};

/// A window with everything in it, tall enough that nothing scrolls away.
pub(super) fn window(mut studio: Studio) -> Harness<'static, Studio> {
    let show = |ui: &mut eframe::egui::Ui, studio: &mut Studio| {
        panel::frame(ui, studio, panel::notices);
        panel::start(ui, studio);
        panel::question(ui, studio);
        if !ui.input(|input| input.pointer.any_down()) {
            studio.rest();
        }
    };
    studio.researches = true;
    let mut harness = Harness::builder()
        .with_size([1400.0, 4200.0])
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

/// The panels of a tab.
fn tab(tab: Tab) -> Harness<'static, Studio> {
    let mut studio = studio(Language::English);
    studio.tab = tab;
    window(studio)
}

pub(super) fn click(harness: &mut Harness<'static, Studio>, label: &str) {
    harness.get_by_role_and_label(Role::Button, label).click();
    harness.run_steps(3);
}

fn commands(harness: &mut Harness<'static, Studio>) -> Vec<Command> {
    harness.state_mut().take_commands()
}

/// The last design that was sent.
pub(super) fn wished(harness: &mut Harness<'static, Studio>) -> Design {
    let sent = commands(harness);
    match sent.last() {
        Some(Command::Wish(design)) => (**design).clone(),
        _ => panic!("{sent:?}"),
    }
}

/// Drops a list down and picks one of its rows.
pub(super) fn pick(harness: &mut Harness<'static, Studio>, list: &str, row: &str) {
    harness.get_by_role_and_label(Role::ComboBox, list).click();
    harness.run_steps(3);
    click(harness, row);
}

/// Takes a garment from the shelf.
pub(super) fn put_on(harness: &mut Harness<'static, Studio>, name: &str) {
    click(harness, "+ Add a garment ▼");
    click(harness, name);
}

#[test]
fn pausing_stepping_slowing_and_resetting_are_sent() {
    let mut window = window(studio(Language::English));
    click(&mut window, "Pause");
    assert_eq!(commands(&mut window), [Command::Pause]);
    click(&mut window, "One frame");
    assert_eq!(commands(&mut window), [Command::Step]);
    pick(&mut window, "Speed", "×¼");
    assert_eq!(commands(&mut window), [Command::Speed(0.25)]);
    click(&mut window, "Play");
    assert_eq!(commands(&mut window), [Command::Play]);
    click(&mut window, "From the start");
    assert_eq!(commands(&mut window), [Command::Reset, Command::Play]);
}

#[test]
fn another_step_is_wished_at_once() {
    let mut window = tab(Tab::Dance);
    click(&mut window, DanceStep::Ami.name());
    assert_eq!(wished(&mut window).motion.step, DanceStep::Ami);
}

#[test]
fn every_method_of_the_document_can_be_chosen() {
    for method in MethodName::ALL {
        let mut window = tab(Tab::Dance);
        window
            .get_by_role_and_label(Role::ComboBox, "Method")
            .click();
        window.run_steps(3);
        let label = format!("{}  {}", method.id(), crate::text::method(method).english);
        click(&mut window, &label);
        assert_eq!(window.state().design().method.name, method);
    }
}

#[test]
fn cloth_may_be_let_through_cloth_where_the_method_knows_better() {
    let mut window = tab(Tab::Cloth);
    assert_eq!(window.state().design().method.uncrossed, Uncrossed::Always);
    window
        .get_by_role_and_label(Role::ComboBox, "Cloth stays out of cloth")
        .click();
    window.run_steps(3);
    click(&mut window, "while there is time");
    assert_eq!(window.state().design().method.uncrossed, Uncrossed::InTime);
}

#[test]
fn the_language_switch_changes_the_labels_and_nothing_else() {
    let mut window = window(studio(Language::English));
    let before = window.state().design().clone();
    click(&mut window, "日本語");
    assert_eq!(window.state().language, Language::Japanese);
    for label in ["止める", "1コマずつ", "最初から", "保存"] {
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
            "From the start",
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
    let mut window = tab(Tab::Cloth);
    for shown in [true, false] {
        window
            .get_by_role_and_label(Role::CheckBox, "Color the cloth where it pulls")
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
    studio.question = Some(Question::new(Purpose::Open, "a.lole"));
    let mut window = window(studio);
    click(&mut window, "Open");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::Open(PathBuf::from("a.lole"))]);
    assert!(window.state().question.is_none());
    window.state_mut().question = Some(Question::new(Purpose::Save, ""));
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
    window.state_mut().researches = false;
    window.run_steps(3);
    click(&mut window, "閉じる");
    assert!(window.query_by_label("3行目がちがいます").is_none());
}

#[test]
fn where_cloth_has_no_room_is_told_below_as_long_as_it_is_so() {
    let mut design = Design::default();
    (design.skirt.column_count, design.skirt.row_count) = (96, 12);
    for (language, sentence) in [
        (
            Language::English,
            "no room for the cloth at her left thigh: the skin gives way",
        ),
        (
            Language::Japanese,
            "左の太もものところで布の居場所がなく、肌のほうがよけています",
        ),
    ] {
        let mut moment = crate::sim::first_moment(&design).expect("she is dressed");
        assert!(moment.without_room.is_empty());
        moment.without_room = vec![Bone::LeftUpperLeg];
        let mut studio = studio(language);
        studio.snapshot = Some(Arc::new(moment));
        let mut window = window(studio);
        window.get_by_label_contains(sentence);
        let moment = crate::sim::first_moment(&design).expect("she is dressed");
        window.state_mut().snapshot = Some(Arc::new(moment));
        window.run_steps(3);
        assert!(window.query_by_label_contains(sentence).is_none());
    }
}

/// The lamps of a theater say what the part says that is danced, or the last one before it that says anything.
#[test]
fn lamps_follow_the_choreography() {
    let mut design = Design::default();
    design.skirt.column_count = 128;
    design.skirt.row_count = 20;
    design.stage.set = StageSet::Theater;
    design.stage.mood = StageMood::Joyful;
    design.motion.parts = [None, Some(StageMood::Sea), None]
        .map(|mood| PartDesign {
            mood,
            ..PartDesign::default()
        })
        .to_vec();
    let mut moment = crate::sim::first_moment(&design).expect("she is dressed");
    let studio = Studio::new(Language::English, design, None);
    let lamps = [None, Some(0), Some(1), Some(2)].map(|part| {
        moment.part = part.map(|index| PartNow { index, share: 0.5 });
        studio.scenery(&moment).mood
    });
    let [before, first, second, third] = lamps;
    assert_eq!([before, first], [StageMood::Joyful; 2]);
    assert_eq!([second, third], [StageMood::Sea; 2]);
}

#[test]
fn a_slider_moved_by_keys_changes_the_design_within_its_range() {
    let mut window = tab(Tab::Dance);
    let slider = window.get_by_role_and_label(Role::Slider, "Speed of the wind");
    assert_eq!(slider.accesskit_node().numeric_value(), Some(0.0));
    slider.focus();
    window.run_steps(2);
    window.key_press(eframe::egui::Key::ArrowRight);
    window.run_steps(3);
    let design = wished(&mut window);
    assert!(0.0 < design.wind.speed_m_per_s && design.wind.speed_m_per_s <= 8.0);
}

#[test]
fn every_step_back_comes_from_the_bar_and_is_sent() {
    let mut window = tab(Tab::Dance);
    click(&mut window, "breeze");
    let blown = wished(&mut window);
    assert_eq!(blown.wind.model, WindModel::Triangles);
    click(&mut window, "strong");
    assert!(blown.wind.speed_m_per_s < wished(&mut window).wind.speed_m_per_s);
    click(&mut window, "Undo");
    assert_eq!(wished(&mut window), blown);
    click(&mut window, "Undo");
    assert_eq!(wished(&mut window), Design::default());
    click(&mut window, "Redo");
    assert_eq!(wished(&mut window), blown);
}

#[test]
fn wind_is_still_or_blows_as_one_likes_with_other_gusts() {
    let mut window = tab(Tab::Dance);
    assert!(window.query_by_label("turns round").is_none());
    click(&mut window, "breeze");
    assert_eq!(wished(&mut window).wind.law, WindLaw::Steady);
    click(&mut window, "the left");
    let blown = wished(&mut window);
    // What is left in the picture is her right.
    let toward = blown.wind.velocity().force(10.0);
    assert!(1.9 < toward.x && toward.z.abs() < 1e-9, "{toward}");
    click(&mut window, "to and fro");
    assert!(window.query_by_label("the left").is_none());
    assert_eq!(wished(&mut window).wind.law, WindLaw::LiteralScalar);
    let before = window.state().design().wind.seed;
    let label = format!("Other gusts ({before})");
    click(&mut window, &label);
    assert_ne!(wished(&mut window).wind.seed, before);
    click(&mut window, "all alike");
    assert_eq!(wished(&mut window).wind.model, WindModel::Uniform);
    assert!(window.query_by_label("Gusts").is_none());
    click(&mut window, "still");
    assert!(wished(&mut window).wind.speed_m_per_s <= 0.0);
}

#[test]
fn a_choreography_is_put_together_part_by_part() {
    let mut window = tab(Tab::Dance);
    // To look at a page changes nothing.
    click(&mut window, "Choreography");
    assert!(commands(&mut window).is_empty());
    assert!(window.state_mut().take_requests().is_empty());
    assert_eq!(*window.state().design(), Design::default());
    click(&mut window, "Dance a choreography");
    let counts = DanceStep::Kaholo.counts();
    assert_eq!(wished(&mut window).motion.parts[0].beat_count, counts);
    click(&mut window, "+ Add a part");
    let added = wished(&mut window).motion.parts;
    assert_eq!((added.len(), added[1].side), (2, Side::Left));
    pick(&mut window, "2 Step", DanceStep::Kao.name());
    click(&mut window, "2 more counts");
    pick(&mut window, "2 facing", "left");
    click(&mut window, "2 left");
    let parts = wished(&mut window).motion.parts;
    assert_eq!(
        (parts[1].step, parts[1].side),
        (DanceStep::Kao, Side::Right)
    );
    assert_eq!(parts[1].facing_deg.to_bits(), 90.0_f64.to_bits());
    assert_eq!(parts[1].beat_count, counts + DanceStep::Kao.phrase());
    click(&mut window, "2 up");
    assert_eq!(wished(&mut window).motion.parts[0].step, DanceStep::Kao);
    click(&mut window, "2 remove");
    assert_eq!(wished(&mut window).motion.parts.len(), 1);
    // Another source puts it on the shelf, and back.
    click(&mut window, "Step");
    assert!(commands(&mut window).is_empty());
    click(&mut window, DanceStep::Ami.name());
    assert!(wished(&mut window).motion.parts.is_empty());
    click(&mut window, "Choreography");
    click(&mut window, "Dance a choreography");
    assert_eq!(wished(&mut window).motion.parts[0].step, DanceStep::Kao);
}

#[test]
fn a_hālau_s_manner_sets_the_whole_posture() {
    let mut window = tab(Tab::Dance);
    let school = &SCHOOLS[4];
    pick(&mut window, "Manner (hālau)", school.about.english);
    let motion = wished(&mut window).motion;
    assert_eq!(motion.school.id, school.id);
    assert!((motion.knee_deg - f64::from(school.knee_degrees)).abs() < 1e-4);
}

#[test]
fn a_recording_is_asked_for_and_can_go_round_on_the_spot() {
    let mut window = tab(Tab::Dance);
    click(&mut window, "Recording");
    assert!(window.state_mut().take_requests().is_empty());
    click(&mut window, "Open a recording…");
    assert_eq!(window.state_mut().take_requests(), [Request::AskRecording]);
    let file = LinkedFile {
        bytes: Some(b"HIERARCHY".as_slice().into()),
        ..LinkedFile::named("dances/hula.bvh")
    };
    (window.state_mut()).change(|design| design.motion.file = Some(file.clone()));
    window.run_steps(3);
    window.get_by_label("hula.bvh");
    click(&mut window, "begins again");
    click(&mut window, "stays");
    let motion = wished(&mut window).motion;
    assert_eq!(
        (motion.repeat, motion.drift),
        (MotionRepeat::Loop, MotionDrift::Remove)
    );
    click(&mut window, "Step");
    click(&mut window, DanceStep::Ami.name());
    assert!(wished(&mut window).motion.file.is_none());
    click(&mut window, "Recording");
    click(&mut window, "Dance hula.bvh again");
    assert_eq!(wished(&mut window).motion.file, Some(file));
}

#[test]
fn one_of_several_animations_is_chosen_by_name_or_by_number_where_names_are_alike() {
    let bytes: Arc<[u8]> = b"glTF".as_slice().into();
    let clip = |name: &str, bone_count| AnimationSummary {
        name: name.to_owned(),
        duration_s: 2.0,
        key_count: 9,
        bone_count,
    };
    let clips = [
        clip("Blink", 0),
        clip("Hula", 20),
        clip("Hula", 20),
        clip("", 20),
    ];
    let mut window = tab(Tab::Dance);
    let studio = window.state_mut();
    studio.clips = ClipShelf::holding(bytes.clone(), clips.to_vec());
    studio.change(|design| {
        design.motion.file = Some(LinkedFile {
            bytes: Some(bytes),
            ..LinkedFile::named("dances.glb")
        });
    });
    window.run_steps(3);
    assert!(window.query_by_label("1 Blink  2.0 s").is_none());
    let mut chosen = |row| {
        pick(&mut window, "Which of its dances", row);
        wished(&mut window).motion.clip
    };
    assert_eq!(chosen("3 Hula  2.0 s"), "3");
    assert_eq!(chosen("2 Hula  2.0 s"), "Hula");
    assert_eq!(chosen("4   2.0 s"), "4");
}

#[test]
fn garments_are_put_on_cut_from_another_fabric_and_taken_off() {
    let mut window = tab(Tab::Cloth);
    pick(&mut window, "Fabric", PRESETS[5].name);
    assert_eq!(wished(&mut window).fabric.preset.id, PRESETS[5].id);
    click(&mut window, "2 Costume");
    put_on(&mut window, "Pāʻū underskirt");
    put_on(&mut window, "Pāʻū top");
    let garments = wished(&mut window).garments;
    let kinds = garments.iter().map(GarmentDesign::kind_id);
    assert_eq!(kinds.collect::<Vec<_>>(), ["pau-skirt", "pau-top"]);
    click(&mut window, "Take off: pāʻū underskirt 1");
    let design = wished(&mut window);
    assert_eq!(design.garments.len(), 1);
    assert!(design.garments[0].option("hem_height_cm").is_none());
    let hem = "by the measures: just above the skirt's upper edge";
    window.get_by_role_and_label(Role::CheckBox, hem).click();
    window.run_steps(3);
    let design = wished(&mut window);
    assert!(design.garments[0].option("hem_height_cm").is_some());
}

#[test]
fn garments_that_a_method_cannot_move_are_explained_where_they_are_added() {
    let mut studio = studio(Language::English);
    studio.tab = Tab::Costume;
    studio.change(|design| design.method.name = MethodName::FbEuler);
    let mut window = window(studio);
    window.state_mut().researches = false;
    commands(&mut window);
    put_on(&mut window, "Pāʻū top");
    assert!(commands(&mut window).is_empty());
    window.get_by_label_contains("move one garment alone");
    click(&mut window, "Undo");
    assert!(
        window
            .query_by_label_contains("move one garment alone")
            .is_none()
    );
}

#[test]
fn measures_that_exclude_each_other_are_explained_below_them_and_can_be_left_out() {
    let mut studio = studio(Language::Japanese);
    studio.tab = Tab::Dancer;
    studio.change(|design| {
        design.dancer.waist_cm = Some(130.0);
        design.dancer.hip_cm = Some(80.0);
    });
    let mut window = window(studio);
    assert!(commands(&mut window).is_empty());
    window.get_by_label_contains("両立しません");
    click(&mut window, "ウエスト: 推定に戻す");
    assert_eq!(wished(&mut window).dancer.waist_cm, None);
    assert!(window.query_by_label_contains("両立しません").is_none());
    click(&mut window, "男性");
    assert_eq!(wished(&mut window).dancer.figure, Figure::Man);
}

#[test]
fn work_that_was_found_is_offered_once_in_a_sentence() {
    for (button, request) in [("続きから", Request::Resume), ("捨てる", Request::Discard)] {
        let mut left = studio(Language::Japanese);
        left.change(|design| design.skirt.hem_height_cm = 30.0);
        left.rest();
        let mut studio = studio(Language::Japanese);
        studio.found = left.take_work();
        let mut window = window(studio);
        window.get_by_label_contains("保存しないまま終わったデザイン");
        click(&mut window, button);
        assert_eq!(window.state_mut().take_requests(), [request]);
    }
}

#[test]
fn rows_of_elastic_are_chosen_with_their_places() {
    let mut window = tab(Tab::Costume);
    click(&mut window, "4");
    let skirt = wished(&mut window).skirt;
    assert_eq!(skirt.elastic_row_count, 4);
    window.get_by_label("Where the elastic is").click();
    window.run_steps(20);
    let hip_bones = "Lowest row on the hip bones";
    window
        .get_by_role_and_label(Role::CheckBox, hip_bones)
        .click();
    window.run_steps(3);
    assert!(wished(&mut window).skirt.worn_height_cm.is_some());
    let slider = window.get_by_role_and_label(Role::Slider, "Between two casings");
    slider.focus();
    window.run_steps(2);
    window.key_press(eframe::egui::Key::ArrowRight);
    window.run_steps(3);
    assert!(skirt.casing_gap_cm < wished(&mut window).skirt.casing_gap_cm);
}

#[test]
fn what_researchers_look_at_stands_behind_one_door_that_is_closed_at_first() {
    let mut window = window(studio(Language::Japanese));
    window.state_mut().researches = false;
    window.run_steps(3);
    for research in ["計算のしかた", "グラフ", "体"] {
        assert!(window.query_by_label(research).is_none(), "{research}");
    }
    click(&mut window, "研究者向け…");
    window.get_by_label("計算のしかた");
    click(&mut window, "閉じる");
    assert!(window.query_by_label("計算のしかた").is_none());
}
