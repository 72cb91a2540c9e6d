//! The panels of the costume CAD without a display: from the shelf to the order.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::roster;
use lole_language::Language;
use lole_pattern::marker::Lay;
use lole_print::{PrintBorder, PrintDirection};

use super::tests::{click, pick, put_on, window, wished};
use crate::Studio;
use crate::ordering::Progress;
use crate::paper::tests::paper_of;
use crate::studio::{Request, Tab};

/// A window of a design whose paper is drafted.
fn drafted(design: Design, language: Language, tab: Tab) -> Harness<'static, Studio> {
    let mut studio = Studio::new(language, design, None);
    studio.sews = false;
    studio.tab = tab;
    studio.paper = Some(Arc::new(paper_of(studio.design())));
    window(studio)
}

fn with_garment(id: &str) -> Design {
    Design {
        garments: vec![GarmentDesign::of_kind(id).unwrap()],
        ..Design::default()
    }
}

/// Opens what is folded up, and waits until it stands open.
fn unfold(window: &mut Harness<'static, Studio>, label: &str) {
    window.get_by_label(label).click();
    window.run_steps(20);
}

fn draft_anew(window: &mut Harness<'static, Studio>) {
    let paper = paper_of(window.state().design());
    window.state_mut().paper = Some(Arc::new(paper));
    window.run_steps(3);
}

#[test]
fn a_garment_from_the_shelf_has_its_options_and_goes_with_one_step_back() {
    let mut window = drafted(Design::default(), Language::English, Tab::Costume);
    put_on(&mut window, "Blouse with puff sleeves");
    draft_anew(&mut window);
    let slider = window.get_by_role_and_label(Role::Slider, "From the waist to the hem");
    slider.focus();
    window.run_steps(2);
    window.key_press(eframe::egui::Key::ArrowRight);
    window.run_steps(3);
    let design = wished(&mut window);
    assert!(16.0 < design.garments[0].option("below_waist_cm").unwrap());
    click(&mut window, "Undo");
    click(&mut window, "Undo");
    assert!(wished(&mut window).garments.is_empty());
}

#[test]
fn an_option_that_cannot_be_drafted_has_its_sentence_below_it() {
    let mut design = with_garment("blouse");
    design.garments[0] = design.garments[0].clone().with(&[("bust_ease_cm", 99.0)]);
    let window = drafted(design, Language::English, Tab::Costume);
    window.get_by_label_contains("bust_ease_cm is 99");
}

#[test]
fn garments_change_places_in_the_list() {
    let mut design = with_garment("blouse");
    design.garments.push(GarmentDesign::of_kind("lei").unwrap());
    let mut window = drafted(design, Language::Japanese, Tab::Costume);
    click(&mut window, "外側へ: パフスリーブのブラウス 1");
    let ids = |design: &Design| -> Vec<&str> {
        design.garments.iter().map(GarmentDesign::kind_id).collect()
    };
    assert_eq!(ids(&wished(&mut window)), ["lei", "blouse"]);
    click(&mut window, "元に戻す");
    assert_eq!(ids(&wished(&mut window)), ["blouse", "lei"]);
}

#[test]
fn a_price_is_asked_for_and_makes_the_bill() {
    let mut window = drafted(Design::default(), Language::English, Tab::Cutting);
    window.get_all_by_label("ask the price").next().unwrap();
    let field = window.get_by_role_and_label(Role::TextInput, "pāʻū skirt: cloth");
    field.focus();
    window.run_steps(2);
    let field = window.get_by_role_and_label(Role::TextInput, "pāʻū skirt: cloth");
    field.type_text("1200");
    window.run_steps(3);
    let design = wished(&mut window);
    assert_eq!(design.fabric.price_per_m, Some(1200.0));
    draft_anew(&mut window);
    let bought = window.state().paper.as_ref().unwrap().garments[0]
        .cut
        .clone();
    let meters = bought.unwrap().bought().metric.to_m();
    let sum = design.cost.currency.write(1200.0 * meters);
    assert!(window.get_all_by_label(&sum).count() >= 1, "{sum}");
    click(&mut window, "Price per yard");
    let fabric = wished(&mut window).fabric;
    assert_eq!(
        (fabric.price_per_m, fabric.price_per_yd),
        (None, Some(1200.0))
    );
}

#[test]
fn what_is_wider_than_its_cloth_is_planned_in_parts_and_said_to_be_joined() {
    let mut design = Design::default();
    design.fabric.width_cm = 70.0;
    let mut window = drafted(design, Language::English, Tab::Cutting);
    window.get_by_label_contains("joined where it does not show");
    for warning in ["use cloth at least", "cm tall and the cloth"] {
        assert!(window.query_by_label_contains(warning).is_none());
    }
    let usual = drafted(Design::default(), Language::English, Tab::Cutting);
    let joined = usual.query_by_label_contains("joined where it does not show");
    assert!(joined.is_none());
    click(&mut window, "Folded");
    assert_eq!(window.state().cutting.lay, Lay::Folded);
}

#[test]
fn a_print_is_turned_made_a_border_and_replaced_by_a_picture() {
    let mut window = drafted(Design::default(), Language::English, Tab::Cloth);
    unfold(&mut window, "Size and place of the print");
    click(&mut window, "➡");
    assert_eq!(
        wished(&mut window).print.lay.direction,
        PrintDirection::Right
    );
    pick(&mut window, "Border print", "border at the hem");
    assert_eq!(wished(&mut window).print.lay.border, PrintBorder::Hem);
    click(&mut window, "Use a photo or picture…");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::AskPicture(None)]);
}

#[test]
fn one_s_own_cloth_is_measured_and_sewn_from() {
    let mut window = drafted(Design::default(), Language::English, Tab::Cloth);
    unfold(&mut window, "Width; test your own cloth");
    click(&mut window, "Sew from this cloth");
    let fabric = wished(&mut window).fabric;
    assert_eq!(fabric.areal_density_g_per_m2, Some(110.0));
    assert!(fabric.bend_warp_un_m.is_some());
}

#[test]
fn a_list_shows_its_rows_and_problems_and_an_order_can_be_called_off() {
    let mut studio = Studio::new(Language::English, Design::default(), None);
    studio.tab = Tab::Order;
    let list = roster::read("name,stature,hip\nKeola,171,101\nNani,158,oops\n".as_bytes());
    studio.order.list = Some((PathBuf::from("hula.csv"), Arc::new(list.unwrap())));
    let mut window = window(studio);
    window.get_by_label("Keola");
    window.get_by_label_contains("line 3, column 3 (hip)");
    click(&mut window, "Make the order’s folder…");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::AskOrderFolder]);
    window.state_mut().order.progress = Some(Progress { done: 1, of: 2 });
    window.run_steps(3);
    click(&mut window, "Cancel");
    let requests = window.state_mut().take_requests();
    assert_eq!(requests, [Request::CallOffOrder]);
}
