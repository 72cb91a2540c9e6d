//! The parts of a choreography: step, side, counts and facing; added, moved and taken out.

use eframe::egui::{self, ComboBox, RichText, Ui};
use lole_body::Side;
use lole_costume::document::{PartDesign, StageMood, StageSet};
use lole_hula::Formation;
use lole_language::Words;
use lole_stage::PartNow;

use super::knob::{self, DropDown, wide_button};
use super::steps::StepList;
use super::{dance, hindrance, timeline};
use crate::{Studio, look, text};

/// Most counts of one part.
const MOST_COUNTS: u32 = 256;
/// Directions, to her left of the front [°], from behind her right shoulder round to her back.
const DIRECTIONS: [f64; 8] = [-135.0, -90.0, -45.0, 0.0, 45.0, 90.0, 135.0, 180.0];

/// What was done to the list.
pub(super) enum Edit {
    Change(usize, PartDesign),
    Move(usize, usize),
    Remove(usize),
    /// Once more, after itself.
    Repeat(usize),
    /// Left for right in all of them.
    Mirror,
    Add,
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    if !dance::is_danced(studio) {
        ui.label(studio.say(text::CHOREOGRAPHY_HOW));
        if wide_button(ui, studio.say(text::DANCE_CHOREOGRAPHY)) {
            dance::dance_choreography(studio);
        }
        return;
    }
    let parts = studio.design().motion.parts.clone();
    ui.label(RichText::new(whole(studio, &parts)).small().weak());
    let dancing = dancing_part(studio).map(|part| part.index);
    let timeline = timeline::show(ui, studio, &parts);
    let mut edit = timeline.edit;
    if let Some(part) = timeline.again {
        studio.see_part(part);
    }
    for index in 0..parts.len() {
        let fill = if dancing == Some(index) {
            look::PALE_RED
        } else {
            look::CARD
        };
        let card = look::card(fill).inner_margin(6).show(ui, |ui| {
            ui.set_width(ui.available_width());
            if let Some(done) = part_ui(ui, studio, &parts, index) {
                edit = Some(done);
            }
        });
        if timeline.looked_at == Some(index) {
            card.response.scroll_to_me(Some(egui::Align::Center));
        }
        let place = format!("[[motion.part]] {} ", index + 1);
        hindrance::show(ui, studio, &[&place]);
    }
    if wide_button(ui, studio.say(text::ADD_PART)) {
        edit = Some(Edit::Add);
    }
    if let Some(edit) = edit {
        studio.change(|design| apply(&mut design.motion.parts, edit));
    }
}

/// Counts and time of all parts.
fn whole(studio: &Studio, parts: &[PartDesign]) -> String {
    let counts: u32 = parts.iter().map(|part| part.beat_count).sum();
    let mut tempo = studio.design().motion.tempo_bpm;
    let mut seconds = 0.0;
    for part in parts {
        tempo = part.tempo_bpm.unwrap_or(tempo);
        seconds += 60.0 * f64::from(part.beat_count) / tempo;
    }
    match studio.language {
        lole_language::Language::Japanese => {
            format!("ぜんぶで {counts} 拍、約 {seconds:.0} 秒。一度踊って止まります。")
        }
        lole_language::Language::English => {
            format!("{counts} counts in all, about {seconds:.0} s; danced once.")
        }
    }
}

/// The part that is danced in the picture.
pub(super) fn dancing_part(studio: &Studio) -> Option<PartNow> {
    studio.snapshot.as_ref()?.part
}

/// A button with a sign, for what can be done now; whether it was clicked.
fn sign_button(ui: &mut Ui, (sign, name, can): (&str, &str, bool)) -> bool {
    ui.add_enabled_ui(can, |ui| knob::sign_button(ui, sign, name))
        .inner
}

/// One part of the list; what was done to it.
fn part_ui(ui: &mut Ui, studio: &Studio, parts: &[PartDesign], index: usize) -> Option<Edit> {
    let (number, count) = (index + 1, parts.len());
    let part = parts[index];
    let mut changed = part;
    let mut edit = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(RichText::new(number.to_string()).strong());
        let width = ui.available_width() - 3.0 * (knob::SIGN.x + 4.0);
        let list = StepList { number, width };
        if let Some(step) = list.show(ui, studio, part.step) {
            changed.step = step;
            changed.beat_count = whole_phrases(part.beat_count, step.phrase());
            // Nobody walks anywhere in a step that stays.
            changed.formation = changed.formation.filter(|_| step.walks());
        }
        let name = |words| format!("{number} {}", studio.say(words));
        if sign_button(ui, ("⬆", &name(text::MOVE_UP), 0 < index)) {
            edit = Some(Edit::Move(index, index - 1));
        }
        if sign_button(ui, ("⬇", &name(text::MOVE_DOWN), number < count)) {
            edit = Some(Edit::Move(index, number));
        }
        if sign_button(ui, ("✖", &name(text::REMOVE), 1 < count)) {
            edit = Some(Edit::Remove(index));
        }
    });
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        counts_ui(ui, studio, number, &mut changed);
        side_ui(ui, studio, number, &mut changed);
        facing_ui(ui, studio, number, &mut changed);
    });
    if studio.design().stage.set == StageSet::Theater {
        let moods = StageMood::ALL.map(|mood| (mood, mood.name()));
        let named = (number, text::MOOD, text::MOOD_STAYS);
        if let Some(mood) = change_ui(ui, studio, named, (&moods, changed.mood)) {
            changed.mood = mood;
        }
    }
    // One dancer alone stays in her place.
    if studio.order.list.is_some() && changed.step.walks() {
        let formations = Formation::ALL.map(|formation| (formation, formation.name()));
        let named = (number, text::FORMATION_OF_PART, text::FORMATION_STAYS);
        if let Some(formation) = change_ui(ui, studio, named, (&formations, changed.formation)) {
            changed.formation = formation;
        }
    }
    edit.or_else(|| (changed != part).then_some(Edit::Change(index, changed)))
}

/// The nearest number of counts that is whole phrases.
fn whole_phrases(counts: u32, phrase: u32) -> u32 {
    let phrase = phrase.max(1);
    let phrases = (counts + phrase / 2) / phrase;
    phrases.clamp(1, MOST_COUNTS / phrase) * phrase
}

fn counts_ui(ui: &mut Ui, studio: &Studio, number: usize, part: &mut PartDesign) {
    let phrase = part.step.phrase().max(1);
    let name = |words| format!("{number} {}", studio.say(words));
    let spare = phrase < part.beat_count;
    if sign_button(ui, ("−", &name(text::FEWER_COUNTS), spare)) {
        part.beat_count = whole_phrases(part.beat_count - phrase, phrase);
    }
    let counts = format!("{} {}", part.beat_count, studio.say(text::COUNTS));
    ui.label(counts);
    let room = part.beat_count + phrase <= MOST_COUNTS;
    if sign_button(ui, ("＋", &name(text::MORE_COUNTS), room)) {
        part.beat_count = whole_phrases(part.beat_count + phrase, phrase);
    }
}

fn side_ui(ui: &mut Ui, studio: &Studio, number: usize, part: &mut PartDesign) {
    let (here, other) = match part.side {
        Side::Right => (text::FROM_RIGHT, Side::Left),
        Side::Left => (text::FROM_LEFT, Side::Right),
    };
    let name = format!("{number} {}", studio.say(here));
    let button = ui.button(studio.say(here));
    button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
    if button.on_hover_text(studio.say(text::FIRST_SIDE)).clicked() {
        part.side = other;
    }
}

fn facing_ui(ui: &mut Ui, studio: &Studio, number: usize, part: &mut PartDesign) {
    let mut facing = part.facing_deg;
    let name = |degrees: f64| match DIRECTIONS.iter().position(|&d| is_same(d, degrees)) {
        Some(index) => studio.say(text::DIRECTIONS[index]).to_owned(),
        None => format!("{degrees}°"),
    };
    let response = ComboBox::from_id_salt(("facing of part", number))
        .width(ui.available_width() - 8.0)
        .wrap()
        .selected_text(name(facing))
        .show_ui(ui, |ui| {
            for degrees in DIRECTIONS {
                let is_chosen = is_same(degrees, facing);
                if ui.selectable_label(is_chosen, name(degrees)).clicked() {
                    facing = degrees;
                }
            }
        })
        .response;
    response.widget_info(|| {
        let what = format!("{number} {}", studio.say(text::FACING));
        let mut info = egui::WidgetInfo::labeled(egui::Role::ComboBox, true, what);
        info.current_text_value = Some(name(part.facing_deg));
        info
    });
    part.facing_deg = facing;
}

/// A list of what a part may change and what stays as before; the new choice.
fn change_ui<T: PartialEq + Copy>(
    ui: &mut Ui,
    studio: &Studio,
    (number, name, stays): (usize, Words, Words),
    (choices, chosen): (&[(T, Words)], Option<T>),
) -> Option<Option<T>> {
    let changes = choices.iter().map(|(choice, name)| (Some(*choice), *name));
    let choices: Vec<(Option<T>, String)> = std::iter::once((None, stays))
        .chain(changes)
        .map(|(choice, name)| (choice, studio.say(name).to_owned()))
        .collect();
    let name = format!("{number} {}", studio.say(name));
    let list = DropDown {
        salt: &name,
        name: &name,
    };
    list.show(ui, chosen, &choices)
}

/// Whether two directions are one, whole turns apart.
fn is_same(a: f64, b: f64) -> bool {
    ((a - b) / 360.0).fract().abs() < 1e-9
}

fn apply(parts: &mut Vec<PartDesign>, edit: Edit) {
    match edit {
        Edit::Change(index, part) => parts[index] = part,
        Edit::Move(from, to) => {
            let part = parts.remove(from);
            parts.insert(to.min(parts.len()), part);
        }
        Edit::Remove(index) => drop(parts.remove(index)),
        Edit::Repeat(index) => parts.insert(index, parts[index]),
        Edit::Mirror => {
            for part in parts.iter_mut() {
                part.side = other_side(part.side);
                part.facing_deg = -part.facing_deg;
            }
        }
        Edit::Add => {
            let mut next = parts.last().copied().unwrap_or_default();
            next.side = other_side(next.side);
            parts.push(next);
        }
    }
    unwind(parts);
}

const fn other_side(side: Side) -> Side {
    match side {
        Side::Right => Side::Left,
        Side::Left => Side::Right,
    }
}

/// Turns the shorter way round from part to part: facings are counted on over whole turns.
fn unwind(parts: &mut [PartDesign]) {
    let mut before = 0.0;
    for part in parts {
        let turns = ((before - part.facing_deg) / 360.0).round();
        part.facing_deg += 360.0 * turns;
        before = part.facing_deg;
    }
}

#[cfg(test)]
mod tests {
    use lole_costume::document::Design;
    use lole_hula::DanceStep;

    use super::*;

    fn facing(degrees: f64) -> PartDesign {
        PartDesign {
            facing_deg: degrees,
            ..PartDesign::default()
        }
    }

    #[test]
    fn whatever_is_done_to_the_list_it_can_be_danced() {
        let mut design = Design::default();
        let parts = &mut design.motion.parts;
        for _ in 0..4 {
            apply(parts, Edit::Add);
        }
        assert_ne!(parts[0].side, parts[1].side);
        for (index, degrees) in [(0, 90.0), (1, 180.0), (2, -90.0), (3, 0.0)] {
            apply(parts, Edit::Change(index, facing(degrees)));
        }
        // Once round, without spinning back.
        let round: Vec<f64> = parts.iter().map(|part| part.facing_deg).collect();
        assert_eq!(round, [90.0, 180.0, 270.0, 360.0]);
        design.check("test").unwrap();
        let parts = &mut design.motion.parts;
        let before = parts.clone();
        apply(parts, Edit::Mirror);
        assert_eq!(parts[0].facing_deg.to_bits(), (-90.0_f64).to_bits());
        assert!(std::iter::zip(&*parts, &before).all(|(now, was)| now.side != was.side));
        apply(parts, Edit::Mirror);
        assert_eq!(*parts, before);
        apply(parts, Edit::Repeat(1));
        assert_eq!((parts.len(), parts[1]), (before.len() + 1, parts[2]));
        design.check("test").unwrap();
        let parts = &mut design.motion.parts;
        apply(parts, Edit::Move(0, 4));
        apply(parts, Edit::Remove(1));
        design.check("test").unwrap();
        assert_eq!(design.motion.parts.len(), before.len());
    }

    #[test]
    fn counts_stay_whole_phrases_of_every_step() {
        for step in DanceStep::ALL {
            for counts in [1, 7, 8, 30, 256] {
                let whole = whole_phrases(counts, step.phrase());
                assert!(whole.is_multiple_of(step.phrase()) && (1..=MOST_COUNTS).contains(&whole));
            }
        }
    }

    #[test]
    fn directions_are_the_same_after_whole_turns() {
        assert!(is_same(-90.0, 270.0) && is_same(0.0, 360.0) && !is_same(0.0, 180.0));
    }
}
