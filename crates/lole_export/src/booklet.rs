//! The sewing booklet: a costume on its dancer, what it takes, how it is cut and sewn, what it costs.
//!
//! Everything comes from the design itself: amounts from the patterns, drawings from the pieces,
//! times and prices as they stand there. Letters are large, because those who sew are not all young.

mod figures;
mod keep;
mod own_numbers;
mod sizes;
mod style;
mod techniques;
mod trial;

use std::sync::Arc;

use lole_costume::cost::Bill;
use lole_costume::order::{CutElastic, DancerPlan, PlannedGarment};
use lole_costume::tailoring::{ClothPlan, DraftedBy, role_name};
use lole_garment::Shelf;
use lole_geom::Length;
use lole_language::{Bilingual as _, Language, Sentence, Words, capitalized};
use lole_pattern::pattern::{Amount, NotionKind, Step};
use lole_pattern::piece::ClothRole;
use lole_print::PrintImage;

use crate::cutting::{CutGarment, draw_marker, masses, numbers_words, short_words};
use crate::order::lengths_table;
use crate::pdf::{
    Align, Cell, Column, EncodedPicture, Flow, Margins, PageTable, Paper, Rect, Sheet, Stroke,
    TextStyle,
};
pub(crate) use style::{ACCENT, foot, head, headed_table, rule, subhead};

/// What a booklet is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Booklet<'a> {
    /// What the costume is called.
    pub title: String,
    /// Patterns and cut plans of the dancer on the cover.
    pub plan: &'a DancerPlan,
    /// Everybody who sews by this booklet, where that are several: each has her own lengths.
    pub group: &'a [DancerPlan],
    /// What is printed on each garment, in their order; none where it is not to be shown.
    pub prints: &'a [Arc<PrintImage>],
    /// What it costs.
    pub bill: &'a Bill,
    /// What the costume is drafted by; empty where that is not known.
    pub drafted_by: &'a DraftedBy,
    /// The costume on its dancer.
    pub worn: Option<Worn>,
    /// Height of the hem above the floor [cm]; `None` where the costume has none that was decided.
    pub hem_height_cm: Option<f64>,
}

/// Pictures of a costume as it is worn.
#[derive(Debug, Clone, PartialEq)]
pub struct Worn {
    /// For the cover.
    pub cover: EncodedPicture,
    /// From the front and from behind, at one scale; none where there is the cover alone.
    pub front_and_back: Option<[EncodedPicture; 2]>,
}

impl Worn {
    /// The cover alone.
    #[must_use]
    pub const fn alone(cover: EncodedPicture) -> Self {
        Self {
            cover,
            front_and_back: None,
        }
    }
}

/// The pages of a booklet, in one language.
#[must_use]
pub fn booklet_sheets(booklet: &Booklet<'_>, paper: Paper, language: Language) -> Vec<Sheet> {
    let mut flow = Flow::new(paper.size_mm(), Margins::default());
    cover(&mut flow, booklet, language);
    flow.new_page();
    if let Some(pictures) = booklet
        .worn
        .as_ref()
        .and_then(|worn| worn.front_and_back.as_ref())
    {
        front_and_back(&mut flow, pictures, language);
    }
    materials(&mut flow, booklet.plan, language);
    // The sizes of a drum or a rattle are in its steps.
    if !booklet.plan.garments.iter().all(is_held) {
        sizes::draw(&mut flow, booklet, language);
    }
    if 1 < booklet.group.len() {
        flow.space(6.0);
        flow.keep(70.0);
        everybody(&mut flow, booklet, language);
    }
    for (index, garment) in booklet.plan.garments.iter().enumerate() {
        cut_plans(&mut flow, garment, booklet.prints.get(index), language);
    }
    // Those who sew have half a page before them, or a fresh one.
    flow.keep(0.5 * flow.page_height());
    for garment in &booklet.plan.garments {
        steps(&mut flow, garment, language);
    }
    let owns = own_numbers::of_group(booklet.group, language);
    own_numbers::draw(&mut flow, (&owns, booklet.group), language);
    trial::draw(&mut flow, &booklet.drafted_by.alterations, language);
    techniques::draw(&mut flow, booklet.plan, language);
    care(&mut flow, booklet.plan, language);
    costs(&mut flow, booklet.bill, language);
    let title = booklet.title.clone();
    flow.finish(|sheet, number, count| {
        // The cover has no number.
        if 1 < number {
            foot(sheet, &title, number, count);
        }
    })
}

fn cover(flow: &mut Flow, booklet: &Booklet<'_>, language: Language) {
    let width = flow.width();
    flow.block(30.0, |sheet, rect| {
        let middle = rect.x + 0.5 * rect.width;
        let title = TextStyle::bold(30.0).with_color(ACCENT);
        sheet.text(
            [middle, rect.y + 16.0],
            &booklet.title,
            &title,
            Align::Center,
        );
        let is_sewn = booklet.plan.garments.iter().any(keep::is_sewn);
        let under = if is_sewn {
            language.pick("縫い方の本", "A sewing booklet")
        } else {
            language.pick("作り方の本", "How it is made")
        };
        sheet.text(
            [middle, rect.y + 27.0],
            under,
            &TextStyle::regular(16.0),
            Align::Center,
        );
    });
    flow.space(4.0);
    let text_height = 4.0 * TextStyle::regular(14.0).line_height() + 4.0;
    let height = flow.left_over() - text_height - 2.0;
    flow.block(height, |sheet, rect| match &booklet.worn {
        Some(Worn { cover, .. }) => {
            let shown = sheet.picture(rect, cover);
            sheet.rect(shown, None, Some(Stroke::solid(0.3).with_color(ACCENT)));
        }
        None => rule(sheet, [rect.x, rect.y], width),
    });
    flow.space(4.0);
    for line in about(booklet, language) {
        flow.block(TextStyle::regular(14.0).line_height(), |sheet, rect| {
            let at = [rect.x + 0.5 * rect.width, rect.y + 6.0];
            sheet.text(at, &line, &TextStyle::regular(14.0), Align::Center);
        });
    }
}

/// The finished costume from the front and from behind, side by side.
fn front_and_back(flow: &mut Flow, pictures: &[EncodedPicture; 2], language: Language) {
    const HEIGHT: f64 = 108.0;
    head(flow, language.pick("できあがり", "How it is worn"));
    let names = [language.pick("前", "front"), language.pick("後ろ", "back")];
    flow.block(HEIGHT + 8.0, |sheet, rect| {
        let half = 0.5 * rect.width;
        for (place, (picture, name)) in [0.0, half].into_iter().zip(pictures.iter().zip(names)) {
            let room = Rect {
                x: rect.x + place,
                y: rect.y,
                width: half,
                height: HEIGHT,
            };
            let shown = sheet.picture(room, picture);
            let at = [shown.x + 0.5 * shown.width, rect.y + HEIGHT + 5.5];
            sheet.text(at, name, &TextStyle::regular(12.5), Align::Center);
        }
    });
    flow.space(4.0);
}

/// The lines of the cover: the garments, the dancer, her hem and the time that it takes.
fn about(booklet: &Booklet<'_>, language: Language) -> Vec<String> {
    let names: Vec<&str> = (booklet.plan.garments.iter())
        .map(|garment| garment.tailored.name.text(language))
        .collect();
    let name = booklet.plan.name.trim();
    let dancer =
        (!name.is_empty()).then(|| format!("{}{name}", language.pick("踊り手: ", "Dancer: ")));
    let hem = booklet.hem_height_cm.map(|hem| {
        let label = language.pick("床から裾まで: ", "Hem above the floor: ");
        format!("{label}{hem:.0} cm")
    });
    let garments = names.join(language.pick("・", ", "));
    let lines = [
        Some(garments),
        dancer,
        hem,
        Some(time_words(booklet, language)),
    ];
    lines.into_iter().flatten().collect()
}

fn time_words(booklet: &Booklet<'_>, language: Language) -> String {
    let minutes = |which: usize| -> f64 {
        let garments = booklet.plan.garments.iter();
        let steps = garments.flat_map(|garment| &garment.tailored.pattern.steps);
        steps.map(|step| step.minutes[which]).sum()
    };
    let [machine, hand] = [0, 1].map(|which| hours(minutes(which), language));
    if machine == hand {
        return match language {
            Language::Japanese => format!("約 {machine}（目安）"),
            Language::English => format!("About {machine} (an estimate)"),
        };
    }
    match language {
        Language::Japanese => format!("ミシンで約 {machine}、手縫いで約 {hand}（目安）"),
        Language::English => format!("About {machine} with a machine, {hand} by hand (estimates)"),
    }
}

/// "2.5 h", "40 min".
fn hours(minutes: f64, language: Language) -> String {
    if minutes < 60.0 {
        let minutes = (minutes / 5.0).round().max(1.0) * 5.0;
        return format!("{minutes:.0} {}", language.pick("分", "min"));
    }
    let hours = (minutes / 30.0).round() / 2.0;
    format!("{hours} {}", language.pick("時間", "h"))
}

/// An amount as it is asked for in a shop.
#[must_use]
pub fn amount_words(kind: NotionKind, amount: Amount, language: Language) -> String {
    match amount {
        Amount::Length(length) if length.to_m() < 3.0 => format!("{:.0} cm", length.to_cm().ceil()),
        Amount::Length(length) => format!("{:.1} m", (length.to_m() * 10.0).ceil() / 10.0),
        Amount::Count(count) => match language {
            Language::Japanese => format!("{count} {}", kind.counter()),
            Language::English if count == 1 => "1 piece".to_owned(),
            Language::English => format!("{count} pieces"),
        },
        Amount::Mass(mass) => format!("{:.0} g", 1000.0 * mass),
    }
}

fn materials(flow: &mut Flow, plan: &DancerPlan, language: Language) {
    head(flow, language.pick("用意するもの", "What you need"));
    for garment in &plan.garments {
        subhead(flow, &capitalized(garment.tailored.name.text(language)));
        PageTable {
            columns: vec![
                Column::text("", 3.4),
                Column::text("", 3.0),
                Column::text("", 3.6),
            ],
            rows: material_rows(garment, language),
            size_pt: 12.5,
        }
        .draw(flow);
        flow.space(4.0);
    }
    let tools = keep::tools(plan);
    let tools: Vec<&str> = tools.iter().map(|tool| tool.text(language)).collect();
    if !tools.is_empty() {
        let tools = tools.join(language.pick("、", ", "));
        let text = match language {
            Language::Japanese => format!("道具: {tools}。"),
            Language::English => format!("Tools: {tools}."),
        };
        flow.paragraph(&text, &TextStyle::body());
    }
    flow.space(6.0);
}

/// What is bought of one of a garment's cloths.
fn cloth_row(garment: &PlannedGarment, plan: &ClothPlan, language: Language) -> Vec<Cell> {
    let bought = plan.marker.yardage;
    let (width, metric) = (plan.marker.cloth.width.to_cm(), bought.metric.to_m());
    let yards = bought.imperial.to_yd();
    let [mass, _] = masses(plan, language);
    let name = match plan.role {
        ClothRole::Main => garment.tailored.cloth.name.text(language),
        role => role_name(role).text(language),
    };
    let [bought, about] = match language {
        Language::Japanese => [
            format!("{metric:.1} m（{yards:.1} ヤード）"),
            format!("布幅 {width:.0} cm、およそ {mass:.2} kg"),
        ],
        Language::English => [
            format!("{yards:.1} yd or {metric:.1} m"),
            format!("{width:.0} cm wide, about {mass:.2} kg"),
        ],
    };
    vec![Cell::bold(name), bought.into(), about.into()]
}

/// What is bought for a garment: its cloths, its elastics, and all else that goes into it.
fn material_rows(garment: &PlannedGarment, language: Language) -> Vec<Vec<Cell>> {
    let tailored = &garment.tailored;
    let plans = garment.plans.iter();
    let mut rows: Vec<Vec<Cell>> = plans
        .map(|plan| cloth_row(garment, plan, language))
        .collect();
    let notions = tailored.pattern.notions.iter();
    let elastic = notions
        .clone()
        .find(|notion| notion.kind == NotionKind::Elastic);
    // Rows of equal elastics are one line; those of one garment are of one width.
    let is_by_row = elastic.is_some_and(|notion| notion.note.is_none());
    let elastics = if is_by_row {
        garment.elastics()
    } else {
        Vec::new()
    };
    for CutElastic { length, count, .. } in &elastics {
        let (each, all) = (length.to_cm(), length.to_m() * f64::from(*count));
        rows.push(vec![
            Cell::bold(elastic.map_or_else(String::new, |notion| {
                capitalized(notion.name.text(language))
            })),
            format!("{all:.2} m").into(),
            match language {
                Language::Japanese => format!("{each:.1} cm を {count} 本（重なりを含む）").into(),
                Language::English => format!("{count} × {each:.1} cm, overlap included").into(),
            },
        ]);
    }
    for notion in &tailored.pattern.notions {
        if is_by_row && notion.kind == NotionKind::Elastic {
            continue;
        }
        let note = notion.note.as_ref();
        rows.push(vec![
            Cell::bold(capitalized(notion.name.text(language))),
            amount_words(notion.kind, notion.amount, language).into(),
            note.map_or_else(String::new, |note| note.text(language))
                .into(),
        ]);
    }
    rows
}

/// Whether it is held and not worn.
fn is_held(garment: &PlannedGarment) -> bool {
    garment.tailored.template.shelf == Shelf::Implements
}

/// Everybody's lengths, where the rest of the booklet has those of one.
fn everybody(flow: &mut Flow, booklet: &Booklet<'_>, language: Language) {
    head(flow, language.pick("全員の寸法", "Everybody’s lengths"));
    let name = booklet.plan.name.as_str();
    let text = match language {
        Language::Japanese => format!(
            "この本の図と手順の数字は {name} さんの寸法です。ほかの人は、裁つ寸法とゴムの長さをこの表から取ってください。「型紙」とある服は、その人の採寸で作った型紙で裁ちます。手順の中で人によって違う数字は、手順のあとの「人によって違う数字」にあります。"
        ),
        Language::English => format!(
            "The drawings and steps of this booklet have the lengths of {name}. For everybody else take the lengths of cloth and elastic from this table, and where it says “pattern”, cut by the paper pattern of her own measures. Numbers of the steps that differ stand after the steps, under “Numbers of her own”."
        ),
    };
    flow.paragraph(&text, &TextStyle::body());
    flow.space(3.0);
    lengths_table(booklet.group, language).draw(flow);
}

fn cut_plans(
    flow: &mut Flow,
    garment: &PlannedGarment,
    print: Option<&Arc<PrintImage>>,
    language: Language,
) {
    // Leaves and flowers are tied, not cut.
    let Some(first) = garment.plans.first() else {
        return;
    };
    flow.keep(plan_height(first, flow.width()) + 24.0);
    let name = garment.tailored.name.text(language);
    let title = match language {
        Language::Japanese => format!("裁ち方: {name}"),
        Language::English => format!("Cutting: {name}"),
    };
    head(flow, &title);
    let cut = CutGarment {
        print: print.cloned(),
        ..CutGarment::of(garment)
    };
    for plan in &garment.plans {
        cut_plan(flow, &cut, plan, language);
    }
    for plan in &garment.plans {
        if let Some(text) = short_words(&plan.marker.yardage, language) {
            flow.paragraph(&text, &TextStyle::body());
        }
    }
    for text in rectangles(garment, language) {
        flow.paragraph(&text, &TextStyle::body());
    }
    flow.space(6.0);
}

/// Where the pieces of one cloth lie, with what is to be said of it.
fn cut_plan(flow: &mut Flow, cut: &CutGarment, plan: &ClothPlan, language: Language) {
    let height = plan_height(plan, flow.width());
    flow.keep(height + 10.0);
    if plan.role != ClothRole::Main {
        subhead(flow, role_name(plan.role).text(language));
    }
    let mut numbered = Vec::new();
    flow.drawing(height, language, |canvas| {
        numbered = draw_marker(canvas, cut, plan);
    });
    if let Some(words) = numbers_words(cut, &numbered, language) {
        flow.paragraph(&words, &TextStyle::body());
    }
    for warning in &plan.marker.warnings {
        let text = format!("! {}", warning.text(language));
        flow.paragraph(&text, &TextStyle::bold(12.5));
    }
}

/// How large the rectangles of a garment are cut, and how often.
fn rectangles(garment: &PlannedGarment, language: Language) -> Vec<String> {
    let rectangles = garment.rectangles().into_iter();
    let sentence = |(piece, [along, across], count): (Words, [Length; 2], u32)| {
        let (along, across) = (along.to_cm(), across.to_cm());
        let mut pieces = garment.tailored.cutting().pieces.iter();
        let on_bias = pieces.any(|other| other.name == piece && other.is_on_bias());
        match language {
            Language::Japanese if on_bias => format!(
                "{}: バイアス（耳から斜め 45°）に、長さ {:.1} cm × 幅 {:.1} cm を {count} 枚（縫い代を含む）。",
                piece.japanese,
                along.max(across),
                along.min(across)
            ),
            Language::English if on_bias => format!(
                "{}: on the bias, at 45° to the selvage, {:.1} × {:.1} cm, cut {count} (seam allowances included).",
                capitalized(piece.english),
                along.max(across),
                along.min(across)
            ),
            Language::Japanese => format!(
                "{}: 耳に沿って {along:.1} cm × 耳と直角に {across:.1} cm を {count} 枚（縫い代を含む）。",
                piece.japanese
            ),
            Language::English => format!(
                "{}: {along:.1} cm along the selvage by {across:.1} cm across, cut {count} (seam allowances included).",
                capitalized(piece.english)
            ),
        }
    };
    rectangles.map(sentence).collect()
}

/// Height of a cut plan over this width [mm].
fn plan_height(plan: &ClothPlan, width: f64) -> f64 {
    let aspect = plan.marker.cloth.width.to_m() / plan.marker.yardage.needed.to_m().max(0.01);
    (aspect * width + 34.0).clamp(60.0, 130.0)
}

fn steps(flow: &mut Flow, garment: &PlannedGarment, language: Language) {
    let pattern = &garment.tailored.pattern;
    let Some(first) = pattern.steps.first() else {
        return;
    };
    flow.keep(figures::height(&first.figure) + step_height(first, flow.width(), language) + 16.0);
    let name = garment.tailored.name.text(language);
    let title = match (language, keep::is_sewn(garment)) {
        (Language::Japanese, true) => format!("縫い方: {name}"),
        (Language::Japanese, false) => format!("作り方: {name}"),
        (Language::English, true) => format!("Sewing: {name}"),
        (Language::English, false) => format!("Making: {name}"),
    };
    head(flow, &title);
    for warning in &pattern.warnings {
        let text = format!("! {}", capitalized(&warning.text(language)));
        flow.paragraph(&text, &TextStyle::bold(12.5));
        flow.space(3.0);
    }
    for (number, step) in (1..).zip(&pattern.steps) {
        let figure = figures::height(&step.figure);
        flow.keep(figure + step_height(step, flow.width(), language));
        step_title(flow, number, step, language);
        if 0.0 < figure {
            flow.drawing(figure, language, |canvas| {
                figures::draw(canvas, pattern, &step.figure);
            });
            flow.space(2.0);
        }
        flow.indented(11.0, &step.by_machine.text(language), &TextStyle::body());
        if let Some(by_hand) = &step.by_hand {
            let text = by_hand_words(by_hand, language);
            flow.indented(11.0, &text, &TextStyle::body().with_color(ACCENT));
        }
        flow.space(7.0);
    }
}

/// Height of a step without its drawing [mm].
fn step_height(step: &Step, width: f64, language: Language) -> f64 {
    let style = TextStyle::body();
    let lines = |text: &str| {
        let count = style.wrap(text, width - 11.0).len();
        f64::from(u32::try_from(count).unwrap_or(u32::MAX)) * style.line_height()
    };
    let by_hand = step.by_hand.as_ref();
    let by_hand = by_hand.map_or(0.0, |text| lines(&by_hand_words(text, language)));
    12.0 + lines(&step.by_machine.text(language)) + by_hand
}

/// How the step is done without a machine.
fn by_hand_words(by_hand: &Sentence, language: Language) -> String {
    let label = language.pick("手縫いなら: ", "By hand: ");
    format!("{label}{}", by_hand.text(language))
}

fn step_title(flow: &mut Flow, number: u32, step: &Step, language: Language) {
    let [machine, hand] = step.minutes.map(|minutes| hours(minutes, language));
    let time = if step.minutes == [0.0, 0.0] {
        // Putting it on is no work.
        String::new()
    } else if machine == hand {
        machine
    } else {
        match language {
            Language::Japanese => format!("{machine}（手縫い {hand}）"),
            Language::English => format!("{machine} ({hand} by hand)"),
        }
    };
    flow.block(10.0, |sheet, rect| {
        style::number(sheet, [rect.x + 4.0, rect.y + 4.5], number);
        let style = TextStyle::bold(15.0);
        sheet.text(
            [rect.x + 11.0, rect.y + 6.4],
            step.title.text(language),
            &style,
            Align::Left,
        );
        let small = TextStyle::regular(11.0);
        sheet.text(
            [rect.x + rect.width, rect.y + 6.2],
            &time,
            &small,
            Align::Right,
        );
    });
}

fn care(flow: &mut Flow, plan: &DancerPlan, language: Language) {
    let rules = keep::care(plan);
    if rules.is_empty() {
        return;
    }
    flow.keep(60.0);
    flow.space(4.0);
    head(flow, language.pick("手入れ", "Care"));
    for rule in rules {
        flow.item("•", 6.0, rule.text(language), &TextStyle::body());
    }
}

fn costs(flow: &mut Flow, bill: &Bill, language: Language) {
    let table = bill_table(bill, language);
    let (remarks, style) = (bill_remarks(bill, language), TextStyle::body());
    let lines = remarks
        .iter()
        .map(|remark| style.wrap(remark, flow.width()).len() as f64);
    let remarks_height = lines.sum::<f64>() * style.line_height();
    flow.keep(table.height(flow.width()) + remarks_height + 26.0);
    flow.space(6.0);
    head(flow, language.pick("費用", "Cost"));
    table.draw(flow);
    flow.space(3.0);
    for line in remarks {
        flow.paragraph(&line, &style);
    }
}

/// A bill with its total.
pub(crate) fn bill_table(bill: &Bill, language: Language) -> PageTable {
    let currency = bill.currency;
    let unknown = || language.pick("値段を確認", "ask the price").to_owned();
    let mut rows: Vec<Vec<Cell>> = (bill.lines.iter())
        .map(|line| {
            let sum = line.sum.map_or_else(unknown, |sum| currency.write(sum));
            vec![
                Cell::bold(capitalized(&line.name.text(language))),
                line.amount.text(language).into(),
                sum.into(),
            ]
        })
        .collect();
    let total = if bill.is_complete() {
        language.pick("合計", "Total")
    } else {
        language.pick("わかっている分の合計", "Total of what is known")
    };
    // Where nothing is known yet there is nothing to sum up.
    if bill.knows_something() {
        rows.push(vec![
            Cell::bold(total),
            "".into(),
            Cell::bold(currency.write(bill.total)),
        ]);
    }
    PageTable {
        columns: vec![
            Column::text("", 4.5),
            Column::text("", 3.0),
            Column::number("", 2.5),
        ],
        rows,
        size_pt: 12.5,
    }
}

/// What is to be said below a bill: prices that are asked for, and the comparison with buying.
#[must_use]
pub fn bill_remarks(bill: &Bill, language: Language) -> Vec<String> {
    let mut remarks = Vec::new();
    let keys = bill.asked_for();
    if !keys.is_empty() {
        let comma = language.pick("、", ", ");
        let unpriced = bill.lines.iter().filter(|line| line.asks.is_some());
        let names: Vec<String> = unpriced.map(|line| line.name.text(language)).collect();
        let (names, keys) = (names.join(comma), keys.join(comma));
        remarks.push(match language {
            Language::Japanese => format!(
                "まだ値段のないもの: {names}。店で見て、窓の「裁断・費用」か、デザインの文書（{keys}）に書いてください。"
            ),
            Language::English => format!(
                "Still without a price: {names}. Ask in a shop and write it in the window under “Cut, cost”, or into the design ({keys})."
            ),
        });
    }
    if let (Some(bought), Some(saving)) = (bill.bought, bill.saving()) {
        let (bought, difference) = (
            bill.currency.write(bought),
            bill.currency.write(saving.abs()),
        );
        remarks.push(match (language, 0.0 <= saving) {
            (Language::Japanese, true) => {
                format!("買うと {bought}。縫うと {difference} 安くなります。")
            }
            (Language::Japanese, false) => {
                format!("買うと {bought}。縫うほうが {difference} 高くなります。")
            }
            (Language::English, true) => {
                format!("Bought ready it costs {bought}: sewing saves {difference}.")
            }
            (Language::English, false) => {
                format!("Bought ready it costs {bought}: sewing costs {difference} more.")
            }
        });
    }
    remarks
}

/// A place for the figures of steps, in the middle of a page.
pub(crate) const fn middle(rect: Rect, width: f64) -> Rect {
    Rect {
        x: rect.x + 0.5 * (rect.width - width),
        width,
        ..rect
    }
}
