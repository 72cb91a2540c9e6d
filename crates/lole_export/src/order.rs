//! A group order on paper and as data: the line of dancers, what to buy, a label for each bundle of
//! cut cloth.

mod folder;
mod strips;

use lole_body::Measure;
use lole_costume::cost::Bill;
use lole_costume::order::{
    CutElastic, DancerPlan, NotionTotal, PlannedGarment, PrintTotal, Settings,
};
use lole_language::{Bilingual as _, Language, Sentence, capitalized};
use lole_pattern::pattern::{Amount, NotionKind};
use serde::Serialize;

use crate::ExportError;
use crate::booklet::{ACCENT, amount_words, bill_remarks, bill_table, foot, head, headed_table};
use crate::pdf::{
    Align, Cell, Column, EncodedPicture, Flow, Margins, PageTable, Paper, Rect, Sheet, Stroke,
    TextStyle,
};

pub use folder::{
    ORDER_JSON, OrderFolder, OrderParts, PATTERN_FILES, PICTURE_FOLDER, left_behind, listed_files,
    order_folder,
};

/// Everything about a group order.
#[derive(Debug, Clone, PartialEq)]
pub struct Order<'a> {
    /// What the costume is called.
    pub title: String,
    /// Height of every hem above the floor [cm]; `None` where the costume has none that was decided.
    pub hem_height_cm: Option<f64>,
    /// The dancers, in the order of the list.
    pub plans: &'a [DancerPlan],
    /// Each dancer's picture, where there is one; all at one scale.
    pub pictures: &'a [Option<EncodedPicture>],
    /// What is bought of each print.
    pub prints: &'a [PrintTotal],
    /// What is bought beside cloth.
    pub notions: &'a [NotionTotal],
    /// What each dancer's costume costs.
    pub bills: &'a [Bill],
    /// What all cost together.
    pub total: &'a Bill,
    /// Rows of the list that could not be used.
    pub problems: &'a [Sentence],
    /// What was not read of the list, and what should be decided before cutting.
    pub notes: &'a [Sentence],
    /// Spare cloth and bolts.
    pub settings: &'a Settings,
    /// Thread on one spool [m].
    pub spool_m: f64,
}

impl Order<'_> {
    /// Thread as it is bought: spools of the length that the cost is reckoned by.
    fn spool_words(&self, amount: Amount, language: Language) -> String {
        let Amount::Length(length) = amount else {
            return amount_words(NotionKind::Thread, amount, language);
        };
        let each = self.spool_m.max(1.0);
        let spools = (length.to_m() / each - 1e-9).ceil();
        match language {
            Language::Japanese => format!("{each:.0} m 巻きを {spools:.0} 巻き"),
            Language::English if spools <= 1.0 => format!("1 spool of {each:.0} m"),
            Language::English => format!("{spools:.0} spools of {each:.0} m"),
        }
    }
}

/// The summary, the shopping list and the labels.
#[must_use]
pub fn order_sheets(order: &Order<'_>, paper: Paper, language: Language) -> Vec<Sheet> {
    let mut flow = Flow::new(paper.size_mm(), Margins::default());
    summary(&mut flow, order, language);
    flow.new_page();
    shopping(&mut flow, order, language);
    flow.new_page();
    labels(&mut flow, order, language);
    let title = order.title.clone();
    flow.finish(|sheet, number, count| foot(sheet, &title, number, count))
}

/// "1 dancer", "12 dancers".
fn dancers_words(count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} dancer{plural}")
}

fn summary(flow: &mut Flow, order: &Order<'_>, language: Language) {
    let title = TextStyle::bold(24.0).with_color(ACCENT);
    flow.paragraph(&order.title, &title);
    let count = order.plans.len();
    let about = match (language, order.hem_height_cm) {
        (Language::Japanese, Some(hem)) => format!("{count} 人。裾は全員、床から {hem:.0} cm。"),
        (Language::Japanese, None) => format!("{count} 人。"),
        (Language::English, Some(hem)) => {
            format!(
                "{}. Every hem is {hem:.0} cm above the floor.",
                dancers_words(count)
            )
        }
        (Language::English, None) => format!("{}.", dancers_words(count)),
    };
    flow.paragraph(&about, &TextStyle::regular(14.0));
    for note in order.notes {
        flow.paragraph(&note.text(language), &TextStyle::regular(12.0));
    }
    for problem in order.problems {
        flow.paragraph(
            &format!("! {}", problem.text(language)),
            &TextStyle::bold(12.0),
        );
    }
    line_up(flow, order);
    let table = dancer_table(order, language);
    headed_table(flow, language.pick("一覧", "All dancers"), &table);
}

/// Dancers side by side on a floor, in rows, with their names.
fn line_up(flow: &mut Flow, order: &Order<'_>) {
    /// Dancers of a row: more would be too small to know, fewer taller than half the page.
    const ROW: std::ops::RangeInclusive<usize> = 4..=6;
    let name_style = TextStyle::regular(9.0);
    let dancers = order.plans.iter().zip(order.pictures);
    let shown: Vec<(&str, &EncodedPicture)> = dancers
        .filter_map(|(plan, picture)| Some((plan.name.as_str(), picture.as_ref()?)))
        .collect();
    let row_count = shown.len().div_ceil(*ROW.end()).max(1);
    let per_row = shown.len().div_ceil(row_count).max(*ROW.start());
    let width = flow.width() / per_row as f64;
    for row in shown.chunks(per_row) {
        let aspect =
            |picture: &EncodedPicture| f64::from(picture.height) / f64::from(picture.width);
        let heights = row.iter().map(|(_, picture)| aspect(picture) * width);
        let height = heights.fold(0.0, f64::max);
        flow.space(2.0);
        flow.block(height + name_style.line_height(), |sheet, rect| {
            for (index, (name, picture)) in row.iter().enumerate() {
                let place = Rect {
                    x: rect.x + width * index as f64,
                    width,
                    height,
                    ..rect
                };
                sheet.picture(place, picture);
                let under = [
                    place.x + 0.5 * width,
                    rect.y + height + 0.8 * name_style.line_height(),
                ];
                let fitted = name_style.wrap(name, width);
                let name = fitted.first().map_or("", String::as_str);
                sheet.text(under, name, &name_style, Align::Center);
            }
            let floor = rect.y + height;
            let stroke = Stroke::solid(0.4).with_color(ACCENT);
            sheet.line([rect.x, floor], [rect.x + rect.width, floor], stroke);
        });
    }
    flow.space(4.0);
}

fn dancer_table(order: &Order<'_>, language: Language) -> PageTable {
    let mut rows = Vec::new();
    for (index, plan) in order.plans.iter().enumerate() {
        for (place, garment) in plan.garments.iter().enumerate() {
            let name = if place == 0 { plan.name.as_str() } else { "" };
            let cost = order.bills.get(index).filter(|_| place == 0);
            let cost = cost.map_or_else(String::new, |bill| cost_words(bill, language));
            rows.push(vec![
                Cell::bold(name),
                garment.tailored.name.text(language).into(),
                cut_words(garment, language).into(),
                elastic_words(garment, language).into(),
                cloth_words(garment).into(),
                cost.into(),
            ]);
        }
    }
    PageTable {
        columns: vec![
            Column::text(language.pick("名前", "Name"), 2.0),
            Column::text(language.pick("服", "Garment"), 2.5),
            Column::text(language.pick("裁つ寸法 cm", "Cut, cm"), 3.6),
            Column::text(language.pick("ゴム cm", "Elastic, cm"), 3.1),
            Column::number(language.pick("布", "Cloth"), 1.4),
            Column::number(language.pick("費用", "Cost"), 2.1),
        ],
        rows,
        size_pt: 10.5,
    }
}

/// What a costume costs, or that its prices are still to be asked for.
fn cost_words(bill: &Bill, language: Language) -> String {
    match (bill.knows_something(), bill.is_complete()) {
        (_, true) => bill.currency.write(bill.total),
        (true, false) => {
            let total = bill.currency.write(bill.total);
            format!("{total}{}", language.pick("＋未定", " + ?"))
        }
        (false, false) => language.pick("値段を確認", "ask prices").to_owned(),
    }
}

/// Cloth to buy for a garment; nothing for one that is tied of leaves.
fn cloth_words(garment: &PlannedGarment) -> String {
    if garment.plans.is_empty() {
        return "–".to_owned();
    }
    format!("{:.1} m", garment.bought().metric.to_m())
}

/// What is cut for each dancer: cloth and elastic, in centimeters.
pub(crate) fn lengths_table(plans: &[DancerPlan], language: Language) -> PageTable {
    let mut rows = Vec::new();
    for plan in plans {
        // Leaves and flowers have no lengths to cut.
        let cut = plan.garments.iter().filter(|it| !it.plans.is_empty());
        for (place, garment) in cut.enumerate() {
            rows.push(vec![
                Cell::bold(if place == 0 { plan.name.as_str() } else { "" }),
                garment.tailored.name.text(language).into(),
                cut_words(garment, language).into(),
                elastic_words(garment, language).into(),
            ]);
        }
    }
    PageTable {
        columns: vec![
            Column::text(language.pick("名前", "Name"), 3.0),
            Column::text(language.pick("服", "Garment"), 2.6),
            Column::text(language.pick("裁つ寸法 cm", "Cut, cm"), 3.2),
            Column::text(language.pick("ゴム cm", "Elastic, cm"), 2.8),
        ],
        rows,
        size_pt: 11.5,
    }
}

/// "367.6 × 92.5" of every rectangle, after its name where there are several; other pieces have patterns.
fn cut_words(garment: &PlannedGarment, language: Language) -> String {
    let rectangles = garment.rectangles();
    let by_pattern = garment.tailored.cutting().pieces.len() - rectangles.len();
    let is_alone = garment.tailored.cutting().pieces.len() == 1;
    let sizes = rectangles.iter().map(|(name, [along, across], count)| {
        let name = if is_alone { "" } else { name.text(language) };
        let often = if *count == 1 {
            String::new()
        } else {
            format!(" ({count})")
        };
        let [along, across] = [along, across].map(|side| side.to_cm());
        let words = format!("{name} {along:.1} × {across:.1}{often}");
        words.trim_start().to_owned()
    });
    let patterns = language.pick("型紙", "pattern").to_owned();
    let patterns = (0 < by_pattern).then_some(patterns);
    patterns
        .into_iter()
        .chain(sizes)
        .collect::<Vec<_>>()
        .join("\n")
}

/// "3 本 × 75.1" of every elastic, after its place where it has one.
fn elastic_words(garment: &PlannedGarment, language: Language) -> String {
    let elastics = garment.elastics();
    let lines = elastics.iter().map(|elastic| {
        let place = elastic.place.map_or("", |place| place.text(language));
        let pieces = pieces_words(elastic, language);
        format!("{place} {pieces}").trim_start().to_owned()
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// How many pieces of what length [cm].
fn pieces_words(elastic: &CutElastic, language: Language) -> String {
    let (count, cm) = (elastic.count, elastic.length.to_cm());
    match language {
        Language::Japanese => format!("{count} 本 × {cm:.1}"),
        Language::English => format!("{count} × {cm:.1}"),
    }
}

fn shopping(flow: &mut Flow, order: &Order<'_>, language: Language) {
    head(flow, language.pick("買い物", "Shopping list"));
    let percent = 100.0 * order.settings.spare_ratio;
    for print in order.prints {
        let garments: Vec<&str> = print
            .garments
            .iter()
            .map(|name| name.text(language))
            .collect();
        let garments = capitalized(&garments.join(language.pick("・", ", ")));
        let (cloth, width) = (print.cloth.text(language), print.width.to_cm());
        let (metric, yards) = (print.bought.metric.to_m(), print.bought.imperial.to_yd());
        let needed = print.needed.to_m();
        let text = match language {
            Language::Japanese => format!(
                "{garments}: {cloth}、布幅 {width:.0} cm、{metric:.1} m（{yards:.1} ヤード）。用尺 {needed:.2} m に予備 {percent:.0} % を足しました。"
            ),
            Language::English => format!(
                "{garments}: {cloth}, {width:.0} cm wide, {yards:.1} yd or {metric:.1} m. {needed:.2} m are needed, and {percent:.0} % are spare."
            ),
        };
        flow.item("□", 7.0, &text, &TextStyle::body());
        strips::write(flow, order, print, language);
        flow.space(2.0);
    }
    for notion in order.notions {
        let amount = match notion.kind {
            NotionKind::Thread => order.spool_words(notion.amount, language),
            kind => amount_words(kind, notion.amount, language),
        };
        let each = notion
            .length
            .map_or_else(String::new, |length| format!(" {:.0} cm", length.to_cm()));
        let text = format!(
            "{}{each}: {amount}",
            capitalized(notion.name.text(language))
        );
        flow.item("□", 7.0, &text, &TextStyle::body());
    }
    flow.space(6.0);
    head(flow, language.pick("全員の費用", "Cost of all"));
    bill_table(order.total, language).draw(flow);
    flow.space(3.0);
    let together = together_words(order, language);
    flow.paragraph(&together, &TextStyle::body());
    for line in bill_remarks(order.total, language) {
        flow.paragraph(&line, &TextStyle::body());
    }
}

/// That the group's sum is of what it buys together, and each one's share.
fn together_words(order: &Order<'_>, language: Language) -> String {
    let count = order.plans.len().max(1);
    let each = order.total.currency.write(order.total.total / count as f64);
    let is_known = order.total.is_complete() && 0.0 < order.total.total;
    match (language, is_known) {
        (Language::Japanese, true) => format!(
            "買い物の表のとおりに、予備も入れてまとめて買うときの費用です。一人あたり {each} です。一覧の費用は、一人分だけを買うときのものです。"
        ),
        (Language::Japanese, false) => {
            "買い物の表のとおりに、予備も入れてまとめて買うときの量です。".to_owned()
        }
        (Language::English, true) => format!(
            "This is for buying together, by the shopping list and with what is spare: {each} for each. The costs beside the dancers are for buying for one alone."
        ),
        (Language::English, false) => {
            "These are the amounts of the shopping list, bought together and with what is spare."
                .to_owned()
        }
    }
}

/// One label for each dancer, to cut out and pin to her cloth.
fn labels(flow: &mut Flow, order: &Order<'_>, language: Language) {
    head(flow, language.pick("名札", "Labels"));
    for pair in order.plans.chunks(2) {
        let lines = pair
            .iter()
            .map(|plan| label_lines(plan, language).len())
            .max();
        let count = f64::from(u32::try_from(lines.unwrap_or(0)).unwrap_or(0));
        let line_height = TextStyle::regular(11.0).line_height();
        let height = 15.0 + count * line_height;
        flow.block(height + 4.0, |sheet, rect| {
            let width = 0.5 * (rect.width - 4.0);
            for (index, plan) in pair.iter().enumerate() {
                let place = Rect {
                    x: rect.x + (width + 4.0) * index as f64,
                    width,
                    height,
                    ..rect
                };
                draw_label(sheet, place, plan, language);
            }
        });
    }
}

fn label_lines(plan: &DancerPlan, language: Language) -> Vec<String> {
    let cm = |wanted: Measure| {
        let mut tape = plan.tape_cm.iter();
        let found = tape.find(|(measure, _)| *measure == wanted);
        found.map_or(0.0, |&(_, cm)| cm)
    };
    let (stature, hip) = (cm(Measure::Stature), cm(Measure::Hip));
    let mut lines = vec![match language {
        Language::Japanese => format!("身長 {stature:.1}　ヒップ {hip:.1} cm"),
        Language::English => format!("stature {stature:.1}, hip {hip:.1} cm"),
    }];
    for garment in &plan.garments {
        lines.push(garment.tailored.name.text(language).to_owned());
        lines.extend(label_cuts(garment, language));
        let elastics = garment.elastics();
        lines.extend(elastics.iter().map(|elastic| {
            let pieces = pieces_words(elastic, language);
            let place = elastic.place.map_or("", |place| place.text(language));
            match language {
                Language::Japanese => format!("  {place}ゴム {pieces} cm"),
                Language::English if place.is_empty() => format!("  elastic {pieces} cm"),
                Language::English => format!("  elastic, {place}: {pieces} cm"),
            }
        }));
    }
    lines
}

/// What a garment is cut by: its paper pattern, and its rectangles, with their names where there are
/// several.
fn label_cuts(garment: &PlannedGarment, language: Language) -> Vec<String> {
    let rectangles = garment.rectangles();
    let mut lines = Vec::new();
    if rectangles.len() < garment.tailored.cutting().pieces.len() {
        lines.push(
            language
                .pick("  型紙で裁つ", "  cut by the pattern")
                .to_owned(),
        );
    }
    let is_alone = garment.tailored.cutting().pieces.len() == 1;
    lines.extend(rectangles.iter().map(|(name, [along, across], count)| {
        let name = if is_alone {
            language.pick("裁つ", "cut")
        } else {
            name.text(language)
        };
        let often = match (count, language) {
            (1, _) => String::new(),
            (_, Language::Japanese) => format!(" を {count} 枚"),
            (_, Language::English) => format!(", {count} times"),
        };
        format!(
            "  {name} {:.1} × {:.1} cm{often}",
            along.to_cm(),
            across.to_cm()
        )
    }));
    lines
}

fn draw_label(sheet: &mut Sheet, rect: Rect, plan: &DancerPlan, language: Language) {
    let border = Stroke::dashed(0.25, 1.5);
    sheet.rect(rect, None, Some(border));
    // A long name is set smaller rather than cut off.
    let room = rect.width - 8.0;
    let natural = TextStyle::bold(16.0);
    let size = (16.0 * room / natural.width_of(&plan.name).max(1.0)).clamp(7.0, 16.0);
    let at = [rect.x + 4.0, rect.y + 8.0];
    sheet.text(at, &plan.name, &TextStyle::bold(size), Align::Left);
    let style = TextStyle::regular(11.0);
    let mut y = rect.y + 14.5;
    for line in label_lines(plan, language) {
        sheet.text([rect.x + 4.0, y], &line, &style, Align::Left);
        y += style.line_height();
    }
}

#[derive(Serialize)]
struct File<'a> {
    lole: &'static str,
    hem_height_cm: Option<f64>,
    dancers: Vec<DancerRow>,
    prints: Vec<PrintRow>,
    cost: CostRow,
    problems: Vec<String>,
    files: Vec<&'a str>,
}

#[derive(Serialize)]
struct DancerRow {
    name: String,
    measures_cm: Vec<(&'static str, f64)>,
    estimated: Vec<&'static str>,
    garments: Vec<GarmentRow>,
    cost: CostRow,
}

#[derive(Serialize)]
struct GarmentRow {
    id: String,
    cut_cm: Vec<[f64; 2]>,
    elastics: Vec<ElasticRow>,
    cloth_needed_m: f64,
    cloth_bought_m: f64,
    cloth_bought_yd: f64,
}

/// Equal pieces of elastic to cut.
#[derive(Serialize)]
struct ElasticRow {
    place: Option<&'static str>,
    length_cm: f64,
    count: u32,
}

#[derive(Serialize)]
struct PrintRow {
    cloth: &'static str,
    width_cm: f64,
    needed_m: f64,
    bought_m: f64,
    bought_yd: f64,
    /// The same where everybody's are cut by themselves.
    apart_m: f64,
    saved_m: f64,
    bolts: Vec<Vec<String>>,
    strips: Vec<strips::StripRow>,
}

#[derive(Serialize)]
struct CostRow {
    currency: &'static str,
    total: f64,
    is_complete: bool,
    asked_for: Vec<&'static str>,
    hours: f64,
    saving: Option<f64>,
}

/// A tenth of a millimeter is finer than cloth can be cut.
fn rounded(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

fn cost_row(bill: &Bill) -> CostRow {
    CostRow {
        currency: bill.currency.id(),
        total: rounded(bill.total),
        is_complete: bill.is_complete(),
        asked_for: bill.asked_for(),
        hours: rounded(bill.hours),
        saving: bill.saving().map(rounded),
    }
}

fn garment_row(garment: &PlannedGarment) -> GarmentRow {
    let bought = garment.bought();
    let rectangles = garment.rectangles().into_iter();
    let elastics = garment.elastics().into_iter();
    GarmentRow {
        id: garment.tailored.id.clone(),
        cut_cm: rectangles
            .map(|(_, sizes, _)| sizes.map(|size| rounded(size.to_cm())))
            .collect(),
        elastics: elastics
            .map(|elastic| ElasticRow {
                place: elastic.place.map(|place| place.english),
                length_cm: rounded(elastic.length.to_cm()),
                count: elastic.count,
            })
            .collect(),
        cloth_needed_m: rounded(bought.needed.to_m()),
        cloth_bought_m: rounded(bought.metric.to_m()),
        cloth_bought_yd: rounded(bought.imperial.to_yd()),
    }
}

/// The order as JSON, lengths in the unit of their key, with the names of the `files` that were written
/// for it.
///
/// # Errors
/// [`ExportError::Encoding`] from the encoder.
pub fn order_json(
    order: &Order<'_>,
    version: &'static str,
    files: &[&str],
) -> Result<String, ExportError> {
    let dancers = order.plans.iter().zip(order.bills);
    let name = |dancer: usize| order.plans.get(dancer).map(|plan| plan.name.clone());
    let file = File {
        lole: version,
        hem_height_cm: order.hem_height_cm,
        dancers: dancers
            .map(|(plan, bill)| DancerRow {
                name: plan.name.clone(),
                measures_cm: (plan.tape_cm.iter())
                    .map(|&(measure, cm)| (measure.key(), rounded(cm)))
                    .collect(),
                estimated: plan.estimated.iter().map(|measure| measure.key()).collect(),
                garments: plan.garments.iter().map(garment_row).collect(),
                cost: cost_row(bill),
            })
            .collect(),
        prints: (order.prints.iter())
            .map(|print| PrintRow {
                cloth: print.cloth.english,
                width_cm: rounded(print.width.to_cm()),
                needed_m: rounded(print.needed.to_m()),
                bought_m: rounded(print.bought.metric.to_m()),
                bought_yd: rounded(print.bought.imperial.to_yd()),
                apart_m: rounded(print.apart.to_m()),
                saved_m: rounded(print.saved().to_m()),
                bolts: (print.bolts.iter())
                    .map(|bolt| {
                        let dancers = strips::dancers(print, bolt).into_iter();
                        dancers.filter_map(name).collect()
                    })
                    .collect(),
                strips: strips::rows(print, &name),
            })
            .collect(),
        cost: cost_row(order.total),
        problems: order.problems.iter().map(ToString::to_string).collect(),
        files: files.to_vec(),
    };
    serde_json::to_string_pretty(&file).map_err(|error| ExportError::Encoding {
        file: "JSON",
        cause: error.to_string(),
    })
}

/// A bill as JSON.
///
/// # Errors
/// [`ExportError::Encoding`] from the encoder.
pub fn bill_json(bill: &Bill) -> Result<String, ExportError> {
    #[derive(Serialize)]
    struct Line {
        name: String,
        amount: String,
        sum: Option<f64>,
        asks: Option<&'static str>,
    }
    #[derive(Serialize)]
    struct Whole {
        lines: Vec<Line>,
        #[serde(flatten)]
        cost: CostRow,
    }
    let lines = bill.lines.iter().map(|line| Line {
        name: line.name.to_string(),
        amount: line.amount.to_string(),
        sum: line.sum.map(rounded),
        asks: line.asks,
    });
    let whole = Whole {
        lines: lines.collect(),
        cost: cost_row(bill),
    };
    serde_json::to_string_pretty(&whole).map_err(|error| ExportError::Encoding {
        file: "JSON",
        cause: error.to_string(),
    })
}
