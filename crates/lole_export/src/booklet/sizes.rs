//! What the costume is drafted by, and what a tape says of it once it is sewn.

use lole_body::Measure;
use lole_costume::order::DancerPlan;
use lole_garment::Shelf;
use lole_geom::Length;
use lole_language::{Language, Words, capitalized};
use lole_pattern::Measure as Drafted;
use lole_pattern::pattern::FinishedMeasure;

use super::{Booklet, head, subhead};
use crate::pdf::{Cell, Column, Flow, PageTable, TextStyle};

/// Sizes of letters in the tables [pt].
const SIZE: f64 = 12.5;

/// Measurements of the dancer, and of every finished garment.
pub(super) fn draw(flow: &mut Flow, booklet: &Booklet<'_>, language: Language) {
    let rows = measured(booklet);
    if !rows.is_empty() {
        of_dancer(flow, &rows, language);
    }
    finished(flow, booklet.plan, language);
}

/// Her measures, and which of them are guesses.
fn of_dancer(flow: &mut Flow, rows: &[Row], language: Language) {
    let table = PageTable {
        columns: vec![
            Column::text("", 4.0),
            Column::number("", 2.0),
            Column::number("", 2.0),
            Column::text("", 2.0),
        ],
        rows: rows.iter().map(|row| row.cells(language)).collect(),
        size_pt: SIZE,
    };
    // Of many rows the first go with their head.
    flow.keep(table.height(flow.width()).min(90.0) + 26.0);
    head(flow, language.pick("寸法", "Measurements"));
    table.draw(flow);
    if !rows.iter().any(|row| row.is_estimated) {
        return;
    }
    flow.space(2.0);
    flow.paragraph(
        language.pick(
            "「推定」は測っていない寸法です。縫う前に測れるものは測ってください。",
            "Measurements marked as estimated were not taken; take them if you can before you sew.",
        ),
        &TextStyle::regular(11.5),
    );
}

/// A measure of the dancer.
struct Row {
    name: Words,
    length: Length,
    is_estimated: bool,
}

impl Row {
    fn cells(&self, language: Language) -> Vec<Cell> {
        let how = if self.is_estimated {
            language.pick("推定", "estimated")
        } else {
            language.pick("実測", "measured")
        };
        vec![
            Cell::bold(plain_name(self.name, language)),
            format!("{:.1} cm", self.length.to_cm()).into(),
            inches(self.length).into(),
            how.into(),
        ]
    }
}

/// "The girth of the neck" as the head of a row: "Girth of the neck".
fn plain_name(name: Words, language: Language) -> String {
    let name = name.text(language);
    capitalized(name.strip_prefix("the ").unwrap_or(name))
}

fn inches(length: Length) -> String {
    format!("{:.1} in", length.to_cm() / 2.54)
}

/// The tape of what covers the trunk, and whatever else the costume is drafted by.
fn measured(booklet: &Booklet<'_>) -> Vec<Row> {
    let plan = booklet.plan;
    let covers = |shelf: Shelf| !matches!(shelf, Shelf::Adornments | Shelf::Implements);
    let mut shelves = plan
        .garments
        .iter()
        .map(|garment| garment.tailored.template.shelf);
    let is_clothing = shelves.any(covers);
    let used = &booklet.drafted_by.measures[..];
    let is_estimated = |measure: Measure| plan.estimated.contains(&measure);
    let taped = plan.tape_cm.iter().filter(|(measure, _)| {
        let is_used = used
            .iter()
            .any(|used| taken_as(used.measure) == Some(*measure));
        is_used || (is_clothing && USUAL.contains(measure))
    });
    let taped = taped.map(|&(measure, cm)| Row {
        name: measure.words(),
        length: Length::from_cm(cm),
        is_estimated: is_estimated(measure),
    });
    let is_taped = |measure: Drafted| {
        let known = taken_as(measure);
        known.is_some_and(|known| plan.tape_cm.iter().any(|(measure, _)| *measure == known))
    };
    let others = used.iter().filter(|used| !is_taped(used.measure));
    let others = others.map(|used| Row {
        name: used.measure.words(),
        length: used.length,
        is_estimated: !used.is_taken,
    });
    taped.chain(others).collect()
}

/// What clothing is fitted by, whatever it is.
const USUAL: [Measure; 7] = [
    Measure::Stature,
    Measure::Bust,
    Measure::Waist,
    Measure::HighHip,
    Measure::Hip,
    Measure::Inseam,
    Measure::WaistHeight,
];

/// The tape by which a measure of a draft is taken, where one is; others are read from her figure.
const fn taken_as(measure: Drafted) -> Option<Measure> {
    Some(match measure {
        Drafted::Stature => Measure::Stature,
        Drafted::BustGirth => Measure::Bust,
        Drafted::UnderbustGirth => Measure::Underbust,
        Drafted::WaistGirth => Measure::Waist,
        Drafted::HipGirth => Measure::Hip,
        Drafted::AnkleGirth => Measure::Ankle,
        Drafted::ShoulderBreadth => Measure::ShoulderBreadth,
        Drafted::UpperArmLength => Measure::UpperArmLength,
        Drafted::WaistHeight => Measure::WaistHeight,
        _ => return None,
    })
}

/// What a tape says of the garments once they are sewn, beside the body.
fn finished(flow: &mut Flow, plan: &DancerPlan, language: Language) {
    let sewn = plan.garments.iter().filter(|garment| {
        let pattern = &garment.tailored.pattern;
        !pattern.finished.is_empty()
    });
    for (index, garment) in sewn.enumerate() {
        let rows = &garment.tailored.pattern.finished;
        let table = finished_table(rows, language);
        flow.keep(table.height(flow.width()) + 34.0);
        if index == 0 {
            flow.space(4.0);
            head(
                flow,
                language.pick("できあがり寸法とゆとり", "Finished measurements and ease"),
            );
        }
        subhead(flow, &capitalized(garment.tailored.name.text(language)));
        table.draw(flow);
        flow.space(3.0);
    }
}

fn finished_table(rows: &[FinishedMeasure], language: Language) -> PageTable {
    let cm = |length: Length| format!("{:.1} cm", length.to_cm());
    let has_body = rows.iter().any(|row| row.body.is_some());
    let cells = rows.iter().map(|row| {
        let name = Cell::bold(capitalized(row.name.text(language)));
        let garment = Cell::from(cm(row.garment));
        if !has_body {
            return vec![name, garment, inches(row.garment).into()];
        }
        let body = row.body.map_or_else(String::new, cm);
        let ease = row.ease().map_or_else(String::new, ease_words);
        vec![name, Cell::from(body), garment, Cell::from(ease)]
    });
    let columns = if has_body {
        vec![
            Column::text("", 4.6),
            Column::number(language.pick("体", "body"), 1.8),
            Column::number(language.pick("服", "garment"), 1.8),
            Column::number(language.pick("ゆとり", "ease"), 1.8),
        ]
    } else {
        vec![
            Column::text("", 4.6),
            Column::number("", 2.0),
            Column::number("", 2.0),
        ]
    };
    PageTable {
        columns,
        rows: cells.collect(),
        size_pt: SIZE,
    }
}

/// "+8.0 cm", "-1.3 cm", "0.0 cm".
fn ease_words(ease: Length) -> String {
    let tenths = (10.0 * ease.to_cm()).round();
    if tenths.abs() < 0.5 {
        return "0.0 cm".to_owned();
    }
    format!("{:+.1} cm", tenths / 10.0)
}
