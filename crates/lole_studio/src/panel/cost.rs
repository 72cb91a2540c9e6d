//! What the costume costs: prices as a shop told them, and the bill that comes of them.

use eframe::egui::{self, Align, Layout, RichText, TextEdit, Ui};
use lole_costume::cost::Bill;
use lole_costume::document::{CostDesign, Currency, Design, FabricDesign};
use lole_costume::tailoring::role_name;
use lole_language::{Sentence, Words};
use lole_pattern::piece::ClothRole;

use super::hindrance;
use super::knob::{choice, left_label, width_of};
use crate::paper::PaperGarment;
use crate::studio::range;
use crate::{Studio, look, text};

/// Widths of a field for a price and of its unit [point].
const FIELD: f32 = 104.0;
const UNIT: f32 = 62.0;

/// Width of what a line of the bill is of [point]; a longer name has a line of its own.
const BILLED: f32 = 136.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let now = studio.design().cost.currency;
    let names = [
        (Currency::Yen, studio.say(text::YEN)),
        (Currency::Dollar, studio.say(text::DOLLAR)),
    ];
    if let Some(currency) = choice(ui, Some(now), &names) {
        studio.change(|design| design.cost.currency = currency);
    }
    let Some(paper) = studio.paper.clone() else {
        ui.label(studio.say(text::DRAFTING));
        return;
    };
    for garment in &paper.garments {
        if paper.garment(garment.place, studio.design()).is_some() {
            cloth_prices(ui, studio, garment);
        }
    }
    prices(ui, studio, paper.bill.as_ref(), BY_LENGTH);
    pieces(ui, studio, paper.bill.as_ref());
    prices(ui, studio, paper.bill.as_ref(), BESIDE_MATERIALS);
    hindrance::show(ui, studio, &["[cost]", "[fabric] price"]);
    if let Some(bill) = &paper.bill {
        ui.separator();
        bill_ui(ui, studio, bill);
    }
}

/// The fabric of a garment; `None` stands for the skirt.
pub(super) fn fabric_of(design: &Design, place: Option<usize>) -> Option<&FabricDesign> {
    match place {
        Some(place) => design.garments.get(place).map(|garment| &garment.fabric),
        None => Some(&design.fabric),
    }
}

/// The fabric of a garment to change it: `None` stands for the skirt.
pub(super) fn fabric_mut(design: &mut Design, place: Option<usize>) -> &mut FabricDesign {
    match place {
        Some(place) => &mut design.garments[place].fabric,
        None => &mut design.fabric,
    }
}

/// What a price of cloth is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sold {
    ByMeter,
    ByYard,
}

fn cloth_prices(ui: &mut Ui, studio: &mut Studio, garment: &PaperGarment) {
    let Ok(cut) = &garment.cut else { return };
    let place = garment.place;
    let Some(fabric) = fabric_of(studio.design(), place).cloned() else {
        return;
    };
    let name = studio.say(garment.name);
    ui.push_id(("prices", place), |ui| {
        for plan in &cut.plans {
            if plan.role == ClothRole::Main {
                own_cloth(ui, studio, garment, &fabric);
                continue;
            }
            let role = studio.say(role_name(plan.role));
            let row = PriceRow {
                name: &format!("{name}: {role}"),
                unit: studio.say(text::PER_METER),
                hint: text::PRICE_HINT,
                key: ("fabric", "beside_price_per_m"),
            };
            if let Some(price) = row.show(ui, studio, fabric.beside_price_per_m) {
                let edit = |design: &mut Design| {
                    fabric_mut(design, place).beside_price_per_m = price;
                };
                studio.change_later(edit);
            }
        }
    });
}

/// The price of a garment's own cloth, by the meter or by the yard as the shop says it.
fn own_cloth(ui: &mut Ui, studio: &mut Studio, garment: &PaperGarment, fabric: &FabricDesign) {
    let place = garment.place;
    let sold = if fabric.price_per_m.is_none() && fabric.price_per_yd.is_some() {
        Sold::ByYard
    } else {
        Sold::ByMeter
    };
    let price = fabric.price_per_m.or(fabric.price_per_yd);
    let row = PriceRow {
        name: &format!("{}{}", studio.say(garment.name), studio.say(text::CLOTH_OF)),
        unit: studio.say(match sold {
            Sold::ByMeter => text::PER_METER,
            Sold::ByYard => text::PER_YARD,
        }),
        hint: text::PRICE_HINT,
        key: ("fabric", "price_per_m"),
    };
    if let Some(price) = row.show(ui, studio, price) {
        let edit = |design: &mut Design| set_price(fabric_mut(design, place), sold, price);
        studio.change_later(edit);
    }
    let ways = [
        (Sold::ByMeter, studio.say(text::BY_METER)),
        (Sold::ByYard, studio.say(text::BY_YARD)),
    ];
    if price.is_some()
        && let Some(sold) = choice(ui, Some(sold), &ways)
    {
        studio.change(|design| set_price(fabric_mut(design, place), sold, price));
    }
}

const fn set_price(fabric: &mut FabricDesign, sold: Sold, price: Option<f64>) {
    (fabric.price_per_m, fabric.price_per_yd) = match sold {
        Sold::ByMeter => (price, None),
        Sold::ByYard => (None, price),
    };
}

type Field = fn(&mut CostDesign) -> &mut Option<f64>;

/// What a price is for, its unit, what an empty field says, its key and where it is kept.
type Priced = (Words, Words, Words, &'static str, Field);

/// What is bought by length, and thread.
const BY_LENGTH: &[Priced] = &[
    (
        text::ELASTIC,
        text::PER_METER,
        text::PRICE_HINT,
        "elastic_price_per_m",
        |cost| &mut cost.elastic_price_per_m,
    ),
    (
        text::TAPE_AND_CORD,
        text::PER_METER,
        text::PRICE_HINT,
        "tape_price_per_m",
        |cost| &mut cost.tape_price_per_m,
    ),
    (
        text::THREAD,
        text::PER_SPOOL,
        text::PRICE_HINT,
        "thread_price_per_spool",
        |cost| &mut cost.thread_price_per_spool,
    ),
];

/// What comes beside materials. The bill is whole without it.
const BESIDE_MATERIALS: &[Priced] = &[
    (
        text::ALL_ELSE,
        text::PER_COSTUME,
        text::OPTIONAL,
        "other_price",
        |cost| &mut cost.other_price,
    ),
    (
        text::WAGE,
        text::PER_HOUR,
        text::OPTIONAL,
        "wage_per_h",
        |cost| &mut cost.wage_per_h,
    ),
    (
        text::BOUGHT,
        text::PER_COSTUME,
        text::OPTIONAL,
        "bought_price",
        |cost| &mut cost.bought_price,
    ),
];

/// Prices of what is in a table, where the costume takes it.
fn prices(ui: &mut Ui, studio: &mut Studio, bill: Option<&Bill>, priced: &[Priced]) {
    for &(name, unit, hint, key, field) in priced {
        let mut cost = studio.design().cost.clone();
        let price = *field(&mut cost);
        // Tape is asked for where a garment has some.
        let is_used = key != "tape_price_per_m"
            || price.is_some()
            || bill.is_some_and(|bill| {
                let mut asked = bill.lines.iter().filter_map(|line| line.asks);
                asked.any(|asked| asked.ends_with(key))
            });
        if !is_used {
            continue;
        }
        let row = PriceRow {
            name: studio.say(name),
            unit: studio.say(unit),
            hint,
            key: ("cost", key),
        };
        if let Some(price) = row.show(ui, studio, price) {
            studio.change_later(|design| *field(&mut design.cost) = price);
        }
    }
}

/// Prices of zips, flowers and the like, where the costume takes any.
fn pieces(ui: &mut Ui, studio: &mut Studio, bill: Option<&Bill>) {
    for notion in lole_costume::cost::notion_prices() {
        let mut prices = studio.design().cost.notions.clone();
        let price = *(notion.place)(&mut prices);
        let is_asked = bill.is_some_and(|bill| {
            let mut asked = bill.lines.iter().filter_map(|line| line.asks);
            asked.any(|asked| asked.ends_with(notion.key))
        });
        if price.is_none() && !is_asked {
            continue;
        }
        let row = PriceRow {
            name: studio.say(notion.name),
            unit: studio.say(notion.unit),
            hint: text::PRICE_HINT,
            key: ("cost", notion.key),
        };
        if let Some(price) = row.show(ui, studio, price) {
            studio.change_later(|design| *(notion.place)(&mut design.cost.notions) = price);
        }
    }
}

/// A price to be typed; empty where nobody knows it.
struct PriceRow<'a> {
    name: &'a str,
    unit: &'a str,
    /// What is said in an empty field.
    hint: Words,
    /// Table and name of its key, for its range.
    key: (&'a str, &'a str),
}

impl PriceRow<'_> {
    /// Shows it; what was typed, `Some(None)` where it was struck out.
    #[expect(clippy::option_option, reason = "typed or not, and a price or not")]
    fn show(&self, ui: &mut Ui, studio: &Studio, price: Option<f64>) -> Option<Option<f64>> {
        let id = ui.make_persistent_id((self.key, self.name));
        let typed: Option<String> = ui.data(|data| data.get_temp(id));
        let known = price.map_or_else(String::new, |price| price.to_string());
        let mut line = typed.unwrap_or_else(|| known.clone());
        let mut chosen = None;
        let (low, high) = range(self.key.0, self.key.1);
        // A long name has a line of its own.
        let beside = ui.available_width() - FIELD - UNIT - 16.0;
        let above = (beside < width_of(ui, self.name)).then(|| ui.label(self.name));
        ui.horizontal(|ui| {
            let label = match above {
                Some(label) => {
                    ui.add_space(beside + 8.0);
                    label
                }
                None => left_label(ui, egui::vec2(beside, 30.0), self.name),
            };
            let field = TextEdit::singleline(&mut line)
                .hint_text(studio.say(self.hint))
                .desired_width(FIELD - 22.0);
            let add = |ui: &mut Ui| {
                look::typing(ui);
                // A field paints its hint in this color and in no other.
                ui.visuals_mut().weak_text_color = Some(match self.hint {
                    text::OPTIONAL => look::PALE_INK,
                    _ => look::RED,
                });
                ui.add(field).labelled_by(label.id)
            };
            let response = ui.scope(add).inner;
            ui.label(RichText::new(self.unit).small().weak());
            if response.changed() {
                chosen = parse(&line, [low, high]);
            }
            if response.has_focus() {
                ui.data_mut(|data| data.insert_temp(id, line.clone()));
            } else {
                ui.data_mut(|data| data.remove::<String>(id));
            }
        });
        if !line.trim().is_empty() && parse(&line, [low, high]).is_none() {
            let wrong = RichText::new(studio.say(text::NO_PRICE)).small();
            ui.label(wrong.color(look::RED));
        }
        chosen.filter(|chosen| *chosen != price)
    }
}

/// A price as people type it: `1,200`, `¥1200`, `１２００`, `6.50`; nothing is no price yet.
#[expect(clippy::option_option, reason = "a price or none, or neither")]
fn parse(line: &str, [low, high]: [f64; 2]) -> Option<Option<f64>> {
    let plain: String = (line.chars())
        .filter(|letter| !letter.is_whitespace() && !",，、¥￥$円".contains(*letter))
        .map(|letter| match letter {
            '０'..='９' => {
                char::from(b'0' + u8::try_from(letter as u32 - '０' as u32).unwrap_or(0))
            }
            '．' => '.',
            other => other,
        })
        .collect();
    if plain.is_empty() {
        return Some(None);
    }
    let price: f64 = plain.parse().ok()?;
    (low..=high).contains(&price).then_some(Some(price))
}

fn bill_ui(ui: &mut Ui, studio: &Studio, bill: &Bill) {
    let row = |ui: &mut Ui, name: RichText, amount: RichText, sum: RichText| {
        let is_long = BILLED < width_of(ui, name.text());
        if is_long {
            ui.label(name.clone());
        }
        ui.horizontal(|ui| {
            let beside = if is_long { RichText::new("") } else { name };
            left_label(ui, egui::vec2(BILLED, 24.0), beside);
            left_label(ui, egui::vec2(60.0, 24.0), amount);
            let place = Layout::right_to_left(Align::Center);
            ui.with_layout(place, |ui| ui.label(sum));
        });
    };
    for line in &bill.lines {
        let asked = || {
            RichText::new(studio.say(text::PRICE_ASKED))
                .small()
                .color(look::RED)
        };
        let sum = (line.sum).map_or_else(asked, |sum| RichText::new(bill.currency.write(sum)));
        let amount = RichText::new(studio.tell(&line.amount)).small();
        row(ui, RichText::new(studio.tell(&line.name)), amount, sum);
    }
    if bill.knows_something() {
        ui.separator();
        let total = RichText::new(bill.currency.write(bill.total)).strong();
        let name = RichText::new(studio.say(total_name(bill))).strong();
        row(ui, name, RichText::new(""), total);
    }
    for sentence in remarks(bill) {
        ui.label(RichText::new(studio.tell(&sentence)).small());
    }
}

/// What the sum of a bill is called: some of its prices may not be known.
pub(super) fn total_name(bill: &Bill) -> Words {
    if bill.is_complete() {
        text::TOTAL
    } else {
        text::TOTAL_KNOWN
    }
}

/// How long sewing takes, and what it saves.
fn remarks(bill: &Bill) -> Vec<Sentence> {
    let hours = bill.hours;
    let mut said = vec![Sentence::new(
        format!("縫う時間の目安は {hours:.1} 時間です。"),
        format!("Sewing takes about {hours:.1} h."),
    )];
    if let (Some(bought), Some(saving)) = (bill.bought, bill.saving()) {
        let [bought, difference] = [bought, saving.abs()].map(|sum| bill.currency.write(sum));
        said.push(if 0.0 <= saving {
            Sentence::new(
                format!("買うと {bought}。縫うと {difference} 安くなります。"),
                format!("Ready made {bought}: sewing saves {difference}."),
            )
        } else {
            Sentence::new(
                format!("買うと {bought}。縫うほうが {difference} 高くなります。"),
                format!("Ready made {bought}: sewing costs {difference} more."),
            )
        });
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prices_are_read_as_people_type_them() {
        let read = |line| parse(line, [0.0, 1e6]);
        for (line, price) in [
            ("1200", Some(1200.0)),
            ("¥1,200", Some(1200.0)),
            ("１２００円", Some(1200.0)),
            ("6.50", Some(6.5)),
            ("  ", None),
        ] {
            assert_eq!(read(line), Some(price), "{line}");
        }
        for wrong in ["abc", "-3", "1e99", "NaN", "inf"] {
            assert_eq!(read(wrong), None, "{wrong}");
        }
    }
}
