//! A group's order: the list of dancers with what is wrong in it, what all need together, and the
//! folder with everything on paper.

use std::sync::Arc;

use eframe::egui::{self, ProgressBar, RichText, Ui};
use lole_body::Measure;
use lole_costume::order::PrintTotal;
use lole_costume::roster::RosterDancer;
use lole_export::pdf::Paper;
use lole_language::Sentence;
use lole_pattern::pattern::Amount;
use lole_stage::Formation;

use super::cost::total_name;
use super::hindrance;
use super::knob::{DropDown, Knob, Scale, choice, left_label, wide_button};
use super::making;
use crate::making::Product;
use crate::ordering::{Progress, Totals};
use crate::platform;
use crate::studio::Request;
use crate::{Studio, look, text};

/// Rows that are shown before the list scrolls on its own [point].
const LIST_HEIGHT: f32 = 220.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    if wide_button(ui, studio.say(text::CHOOSE_LIST)) {
        studio.request(Request::AskRoster);
    }
    let Some((path, list)) = studio.order.list.clone() else {
        ui.label(RichText::new(studio.say(text::LIST_HOW)).small().weak());
        return;
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (count, wrong) = (list.dancers.len(), list.problems.len());
    let said = Sentence::new(
        format!("{name}: {count} 人、使えない行 {wrong} 件"),
        format!("{name}: {count} dancers, {wrong} rows that cannot be used"),
    );
    ui.label(RichText::new(studio.tell(&said)).strong());
    for problem in &list.problems {
        hindrance::sentence(ui, studio, &problem.sentence());
    }
    for note in &list.notes {
        ui.label(RichText::new(studio.tell(note)).small().weak());
    }
    egui::ScrollArea::vertical()
        .id_salt("roster")
        .max_height(LIST_HEIGHT)
        .show(ui, |ui| dancers(ui, studio, &list.dancers));
    wishes(ui, studio);
    let totals = studio.order.totals.clone();
    match studio.order.progress {
        Some(progress) => under_way(ui, studio, progress),
        None => {
            if wide_button(ui, studio.say(text::WORK_OUT)) {
                studio.request(Request::WorkOutOrder);
            }
            let make = RichText::new(studio.say(text::MAKE_ORDER)).color(egui::Color32::WHITE);
            let size = egui::vec2(ui.available_width(), 36.0);
            let button = egui::Button::new(make).fill(look::RED).min_size(size);
            if ui.add(button).clicked() {
                studio.request(Request::AskOrderFolder);
            }
            ui.label(RichText::new(studio.say(text::ORDER_HOW)).small().weak());
        }
    }
    if let Some(totals) = totals {
        totals_ui(ui, studio, &totals);
    }
    if platform::products().contains(&Product::Film) {
        film(ui, studio);
    }
}

/// Everybody in one film.
fn film(ui: &mut Ui, studio: &mut Studio) {
    ui.separator();
    let formations = Formation::ALL.map(|it| (it, studio.say(it.name()).to_owned()));
    let list = DropDown {
        salt: "formation",
        name: studio.say(text::FORMATION),
    };
    if let Some(formation) = list.show(ui, studio.order.formation, &formations) {
        studio.order.formation = formation;
    }
    let product = Product::GroupFilm;
    if wide_button(ui, &format!("{}…", studio.say(product.name()))) {
        studio.request(Request::AskMake(product));
    }
    let about = RichText::new(studio.say(product.about())).small();
    ui.label(about.weak());
    making::pieces(ui, studio, |product| product == Product::GroupFilm);
}

/// Widths of a number of the list [point].
const NUMBER: f32 = 56.0;

/// Name, stature and hip of everybody; a click on a name dresses her.
fn dancers(ui: &mut Ui, studio: &mut Studio, dancers: &[RosterDancer]) {
    let name_width = (ui.available_width() - 2.0 * (NUMBER + 8.0)).max(80.0);
    let measures = [Measure::Stature, Measure::Hip];
    ui.horizontal(|ui| {
        let small = |words| RichText::new(studio.say(words)).small().weak();
        left_label(ui, egui::vec2(name_width, 20.0), small(text::NAME));
        for measure in measures {
            left_label(ui, egui::vec2(NUMBER, 20.0), small(measure.words()));
        }
    });
    for dancer in dancers {
        ui.horizontal(|ui| {
            let size = egui::vec2(name_width, look::TARGET);
            let is_on = is_dressed(studio, dancer);
            let name = egui::Button::selectable(is_on, &dancer.name)
                .frame_when_inactive(true)
                .wrap()
                .min_size(size);
            let place = egui::Layout::top_down_justified(egui::Align::Min);
            let button = ui.allocate_ui_with_layout(size, place, |ui| ui.add(name));
            let button = button.inner.on_hover_text(studio.say(text::TRY_ON));
            if button.clicked() {
                studio.try_on(dancer);
            }
            for wanted in measures {
                let found = dancer.tape_cm.iter().find(|(of, _)| *of == wanted);
                let said = found.map_or_else(|| "–".to_owned(), |(_, cm)| format!("{cm:.1}"));
                left_label(ui, egui::vec2(NUMBER, 24.0), said);
            }
        });
    }
}

/// Whether the design is on this dancer.
fn is_dressed(studio: &Studio, dancer: &RosterDancer) -> bool {
    let dressed = studio.order.dressed.as_ref();
    dressed.is_some_and(|(name, tape)| *name == dancer.name && *tape == studio.design().dancer)
}

fn wishes(ui: &mut Ui, studio: &mut Studio) {
    let knob = Knob {
        name: studio.say(text::SPARE),
        range: 0.0..=30.0,
        decimals: 0,
        unit: " %",
        scale: Scale::Even,
    };
    if let (_, Some(moved)) = knob.show(ui, studio.order.wishes.spare_percent) {
        studio.order.wishes.spare_percent = moved.round();
    }
    ui.label(studio.say(text::PAPER));
    if let Some(paper) = choice(ui, Some(studio.order.wishes.paper), &Paper::ALL) {
        studio.order.wishes.paper = paper;
    }
    let mut pictures = studio.order.wishes.pictures;
    if ui
        .checkbox(&mut pictures, studio.say(text::ORDER_PICTURES))
        .changed()
    {
        studio.order.wishes.pictures = pictures;
    }
    let mut knows_bolt = studio.order.wishes.bolt_m.is_some();
    let words = studio.say(text::KNOWS_BOLT);
    if ui.checkbox(&mut knows_bolt, words).changed() {
        studio.order.wishes.bolt_m = knows_bolt.then_some(50.0);
    }
    if let Some(bolt) = studio.order.wishes.bolt_m {
        let knob = Knob {
            name: studio.say(text::BOLT),
            range: 5.0..=100.0,
            decimals: 0,
            unit: " m",
            scale: Scale::Even,
        };
        if let (_, Some(moved)) = knob.show(ui, bolt) {
            studio.order.wishes.bolt_m = Some(moved.round());
        }
    }
}

fn under_way(ui: &mut Ui, studio: &mut Studio, progress: Progress) {
    let Progress { done, of } = progress;
    #[expect(clippy::cast_precision_loss, reason = "a thousand dancers at most")]
    let share = done as f32 / of.max(1) as f32;
    ui.add(ProgressBar::new(share).text(format!("{done} / {of}")));
    if wide_button(ui, studio.say(text::CANCEL)) {
        studio.request(Request::CallOffOrder);
    }
}

/// What all need together; where the design has changed since, that is said.
fn totals_ui(ui: &mut Ui, studio: &Studio, totals: &Totals) {
    ui.separator();
    let is_old = totals.design != *studio.design() || totals.wishes != studio.order.wishes;
    if is_old {
        let words = RichText::new(studio.say(text::TOTALS_ARE_OLD)).small();
        ui.label(words.color(look::RED));
    }
    let count = totals.group.plans.len();
    let said = Sentence::new(format!("{count} 人分"), format!("For {count} dancers"));
    ui.label(RichText::new(studio.tell(&said)).strong());
    // Rows that cannot be read stand above already.
    let list = studio.order.list.as_ref().map(|(_, list)| Arc::clone(list));
    let known = list.map_or(0, |list| list.problems.len());
    for problem in totals.group.problems.iter().skip(known) {
        hindrance::sentence(ui, studio, problem);
    }
    for print in &totals.prints {
        ui.label(studio.tell(&bought(studio, print)));
    }
    for notion in &totals.notions {
        let amount = amount(notion.amount);
        ui.label(RichText::new(format!("{} {amount}", studio.say(notion.name))).small());
    }
    let bill = &totals.bill;
    let total = if bill.knows_something() {
        let sum = bill.currency.write(bill.total);
        format!("{}: {sum}", studio.say(total_name(bill)))
    } else {
        studio.say(text::NO_PRICES_YET).to_owned()
    };
    ui.label(RichText::new(total).strong());
}

/// How much of a notion is bought; lengths are rounded up to a tenth of a meter.
fn amount(amount: Amount) -> String {
    match amount {
        Amount::Length(length) => format!("{:.1} m", (length.to_m() * 10.0).ceil() / 10.0),
        Amount::Count(count) => format!("× {count}"),
        Amount::Mass(mass) => format!("{:.0} g", 1000.0 * mass),
    }
}

/// What is bought of a print, and for which garments.
fn bought(studio: &Studio, print: &PrintTotal) -> Sentence {
    let names = print.garments.iter().map(|name| studio.say(*name));
    let names = names
        .collect::<Vec<_>>()
        .join(studio.language.pick("・", ", "));
    let (metric, yards) = (print.bought.metric.to_m(), print.bought.imperial.to_yd());
    let (cloth, width) = (print.cloth, print.width.to_cm());
    Sentence::new(
        format!(
            "{names}: {}（幅 {width:.0} cm）{metric:.1} m、{yards:.1} ヤード",
            cloth.japanese
        ),
        format!(
            "{names}: {} ({width:.0} cm wide), {metric:.1} m or {yards:.1} yd",
            cloth.english
        ),
    )
}
