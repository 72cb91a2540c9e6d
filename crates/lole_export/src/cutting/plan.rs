//! The cut plan on a page: cloth, pieces, how much to buy, and what to cut.

use kurbo::{Affine, Point};
use lole_costume::tailoring::{ClothPlan, role_name};
use lole_geom::Length;
use lole_language::{Bilingual as _, Language};
use lole_pattern::Yardage;
use lole_pattern::marker::{Lay, Marker, Nap, Placed};
use lole_pattern::piece::{ClothRole, Piece};
use lole_print::cloth_picture;

use super::draw::{arrow, fitting, line, outline, scale_of};
use super::{CutGarment, MM, TOLERANCE, cm, cut_words};
use crate::canvas::Canvas;
use crate::pdf::{
    Align, Cell, Color, Column, EncodedPicture, Flow, Item, Margins, PageTable, Paper, Rect, Sheet,
    Stroke, TextStyle,
};
use crate::still::ImageView;
use crate::svg::sheet_svg;

/// Color of the cloth that is bought, and of pieces on it.
const CLOTH: Color = Color(246, 243, 236);
const PIECE: Color = Color(255, 255, 255);
const DOUBLED: Color = Color(226, 236, 246);
/// Of a piece that reaches over the selvage.
const TOO_WIDE: Color = Color(250, 220, 214);
/// Its line where the cloth shows its print.
const OVER_SELVAGE: Color = Color(200, 0, 20);

/// Height of the drawing on a page [mm].
const DRAWING: f64 = 96.0;
/// Millimeters of a typographic point.
const MM_PER_PT: f64 = 25.4 / 72.0;
/// Room around the cloth for its measures [mm].
const BORDER: f64 = 12.0;

/// The cut plans of garments, one cloth after the other, on landscape pages.
#[must_use]
pub fn cut_plan_sheets(garments: &[CutGarment], paper: Paper, language: Language) -> Vec<Sheet> {
    let [short, long] = paper.size_mm();
    let mut flow = Flow::new(
        [long, short],
        Margins {
            side: 14.0,
            top: 14.0,
            bottom: 14.0,
        },
    );
    for cut in garments {
        for plan in &cut.plans {
            flow.new_page();
            write_plan(&mut flow, cut, plan, language);
        }
    }
    flow.numbered([14.0, 7.0])
}

/// The drawings of all cut plans as one SVG in millimeters, one below the other.
#[must_use]
pub fn cut_plan_svg(garments: &[CutGarment], language: Language) -> Vec<u8> {
    let plans = garments.iter().map(|cut| cut.plans.len()).sum::<usize>();
    let height = DRAWING + 34.0;
    let count = f64::from(u32::try_from(plans).unwrap_or(1));
    let mut sheet = Sheet::new([297.0, height * count + 10.0]);
    let mut top = 8.0;
    for cut in garments {
        for plan in &cut.plans {
            let style = TextStyle::bold(14.0);
            sheet.text(
                [14.0, top + 6.0],
                &title(cut, plan, language),
                &style,
                Align::Left,
            );
            let about = about(cut, plan, language);
            let facts = TextStyle::regular(9.0);
            sheet.text([14.0, top + 12.0], &about, &facts, Align::Left);
            let rect = Rect {
                x: 14.0,
                y: top + 16.0,
                width: 269.0,
                height: DRAWING,
            };
            let mut canvas = Canvas {
                sheet: &mut sheet,
                rect,
                language,
            };
            let numbered = draw_marker(&mut canvas, cut, plan);
            if let Some(words) = numbers_words(cut, &numbered, language) {
                let at = [14.0, top + 16.0 + DRAWING + 4.0];
                sheet.text(at, &words, &facts, Align::Left);
            }
            top += height;
        }
    }
    sheet_svg(&sheet)
}

fn write_plan(flow: &mut Flow, cut: &CutGarment, plan: &ClothPlan, language: Language) {
    flow.paragraph(&title(cut, plan, language), &TextStyle::bold(17.0));
    flow.paragraph(&about(cut, plan, language), &TextStyle::regular(11.0));
    flow.space(2.0);
    let mut numbered = Vec::new();
    flow.drawing(DRAWING, language, |canvas| {
        numbered = draw_marker(canvas, cut, plan);
    });
    flow.space(3.0);
    if let Some(words) = numbers_words(cut, &numbered, language) {
        flow.paragraph(&words, &TextStyle::regular(11.0));
    }
    for warning in &plan.marker.warnings {
        let text = format!("! {}", warning.text(language));
        flow.paragraph(&text, &TextStyle::bold(10.5));
    }
    if let Some(sentence) = short_words(&plan.marker.yardage, language) {
        flow.paragraph(&sentence, &TextStyle::regular(11.0));
    }
    pieces_table(cut, plan, language).draw(flow);
}

fn title(cut: &CutGarment, plan: &ClothPlan, language: Language) -> String {
    let name = cut.garment.name.text(language);
    let role = role_name(plan.role).text(language);
    match language {
        Language::Japanese => format!("{name}　裁ち方図（{role}）"),
        Language::English => format!("{name}: cut plan, {role}"),
    }
}

/// Cloth, what to buy, what it weighs and how well it is used.
fn about(cut: &CutGarment, plan: &ClothPlan, language: Language) -> String {
    let Marker { cloth, yardage, .. } = &plan.marker;
    let name = cut.garment.cloth.name.text(language);
    let width = cm(cloth.width);
    let needed = cm(yardage.needed);
    let (metric, imperial) = (yardage.metric.to_m(), yardage.imperial.to_yd());
    let [bought, cut_kg] = masses(plan, language);
    let used = used_words(plan, language.pick("　", "; "), language);
    let direction = match cloth.nap {
        Nap::OneWay => language.pick("・一方向に裁つ", "; all pieces one way"),
        Nap::AllWays | Nap::TwoWay => "",
    };
    match language {
        Language::Japanese => format!(
            "{name}　幅 {width}　用尺 {needed} → {metric:.1} m（または {imperial:.1} ヤード）を買う \
             重さ {bought:.2} kg（裁ったあと {cut_kg:.2} kg）{used}{direction}"
        ),
        Language::English => format!(
            "{name}, {width} wide. Needs {needed}: buy {imperial:.1} yd or {metric:.1} m. \
             Weighs {bought:.2} kg, {cut_kg:.2} kg once cut{used}{direction}."
        ),
    }
}

/// How much of the cloth is used, after what stands `between` that and the words before it; nothing
/// where a piece is wider than the cloth and pieces take more than all of it, of which a warning speaks.
#[must_use]
pub fn used_words(plan: &ClothPlan, between: &str, language: Language) -> String {
    let percent = 100.0 * plan.marker.efficiency;
    match language {
        _ if 100.0 < percent => String::new(),
        Language::Japanese => format!("{between}使用率 {percent:.0} %"),
        Language::English => format!("{between}{percent:.0} % of the cloth is used"),
    }
}

/// Mass of the cloth as it is bought, by the yard in English and by the meter in Japanese, and of all
/// pieces once they are cut [kg].
#[must_use]
pub fn masses(plan: &ClothPlan, language: Language) -> [f64; 2] {
    let yardage = plan.marker.yardage;
    let bought = match language {
        Language::Japanese => yardage.metric,
        Language::English => yardage.imperial,
    };
    let per_meter = plan.mass / yardage.needed.to_m().max(1e-6);
    [
        bought.to_m() * per_meter,
        plan.marker.efficiency * plan.mass,
    ]
}

/// Why a gathered rectangle is cut from a little less than its length, where that is so.
#[must_use]
pub fn short_words(yardage: &Yardage, language: Language) -> Option<String> {
    let [metric, imperial] = yardage.missing();
    let bought = [
        (metric, format!("{:.1} m", yardage.metric.to_m())),
        (
            imperial,
            match language {
                Language::Japanese => format!("{:.1} ヤード", yardage.imperial.to_yd()),
                Language::English => format!("{:.1} yd", yardage.imperial.to_yd()),
            },
        ),
    ];
    let short: Vec<String> = (bought.iter())
        .filter(|(missing, _)| Length::ZERO < *missing)
        .map(|(missing, bought)| match language {
            Language::Japanese => format!("{bought}なら {:.1} cm", missing.to_cm()),
            Language::English => format!("{bought} are {:.1} cm short", missing.to_cm()),
        })
        .collect();
    if short.is_empty() {
        return None;
    }
    Some(match language {
        Language::Japanese => format!(
            "{} 足りませんが、脇の縫い代はそのままで、輪をその分だけ小さく縫います。ギャザーに隠れます。",
            short.join("、")
        ),
        Language::English => format!(
            "{}: keep the allowance of the side seam and sew the ring that much smaller; the gathers hide it.",
            short.join(", ")
        ),
    })
}

/// The cloth with its pieces, as large as fits; returns the pieces that were too small for their names
/// and have numbers instead, from 1 in the order of the pattern.
pub(crate) fn draw_marker(
    canvas: &mut Canvas<'_>,
    cut: &CutGarment,
    plan: &ClothPlan,
) -> Vec<usize> {
    let marker = &plan.marker;
    let (rect, length) = (canvas.rect, lying_length(marker));
    let across = lying_across(marker);
    let scale = ((rect.width - 2.0 * BORDER) / length).min((rect.height - 2.0 * BORDER) / across);
    let [left, top] = [rect.x + BORDER, rect.y + BORDER];
    // Doubled cloth shows its fold below and one selvage above.
    let bottom = top + across * scale;
    let page = Affine::translate((left, bottom)) * Affine::scale_non_uniform(scale, -scale);
    let laid = Laid {
        pieces: &cut.garment.cutting().pieces,
        marker,
        page,
        is_printed: draw_print(canvas.sheet, cut, plan, page),
    };
    laid.draw_cloth(canvas.sheet);
    let mut numbered = Vec::new();
    for placed in &marker.placed {
        laid.draw_outline(canvas.sheet, placed);
        if laid.draw_inside(canvas, placed) {
            numbered.push(placed.piece);
        }
    }
    numbered.sort_unstable();
    numbered.dedup();
    laid.draw_edges(canvas);
    laid.draw_measures(canvas);
    numbered
}

/// What the numbers on small pieces mean; `None` where there are none.
pub(crate) fn numbers_words(
    cut: &CutGarment,
    numbered: &[usize],
    language: Language,
) -> Option<String> {
    let names: Vec<String> = (numbered.iter())
        .filter_map(|&index| {
            let name = cut.garment.cutting().pieces.get(index)?.name.text(language);
            Some(format!("{} {name}", index + 1))
        })
        .collect();
    let names = names.join(language.pick("、", ", "));
    (!numbered.is_empty()).then(|| match language {
        Language::Japanese => format!("図の番号: {names}。"),
        Language::English => format!("Numbers in the drawing: {names}."),
    })
}

/// The print on the cloth as its pieces will have it; whether there is one to show.
fn draw_print(sheet: &mut Sheet, cut: &CutGarment, plan: &ClothPlan, page: Affine) -> bool {
    let marker = &plan.marker;
    let print = (cut.print.as_ref()).filter(|_| plan.role == ClothRole::Main);
    let Some(print) = print else { return false };
    let across = lying_width(marker);
    let shown = cloth_picture(print, marker, across);
    let image = ImageView::new(shown.width, shown.height, &shown.pixels);
    // A picture that cannot be encoded leaves the plan as it is without one.
    let Ok(picture) = image.and_then(EncodedPicture::photo) else {
        return false;
    };
    let [low, high] = [(0.0, 0.0), (marker.yardage.needed.to_m(), across.to_m())]
        .map(|corner| page * Point::from(corner));
    let rect = Rect {
        x: low.x,
        y: high.y,
        width: high.x - low.x,
        height: low.y - high.y,
    };
    sheet.items.push(Item::Picture { rect, picture });
    true
}

/// Width of the cloth as it lies on the table: half of it where all of it is doubled.
#[must_use]
pub fn lying_width(marker: &Marker) -> Length {
    let is_single_somewhere = marker.folded_length < marker.yardage.needed;
    if is_single_somewhere {
        marker.cloth.width
    } else {
        marker.cloth.width * 0.5
    }
}

/// Length of the cloth [m], never nothing.
fn lying_length(marker: &Marker) -> f64 {
    marker.yardage.needed.to_m().max(1e-3)
}

/// Width of the cloth with what reaches over its selvage [m].
fn lying_across(marker: &Marker) -> f64 {
    let reach = marker.placed.iter();
    let reach = reach.map(|placed| placed.outline.bounds().y1);
    reach.fold(lying_width(marker).to_m(), f64::max)
}

/// Names are no smaller than old eyes read [pt].
const LEAST_NAME: f64 = 8.0;

/// A cloth with its pieces on a page.
struct Laid<'a> {
    pieces: &'a [Piece],
    marker: &'a Marker,
    /// Page from cloth.
    page: Affine,
    /// Whether the cloth shows its print.
    is_printed: bool,
}

impl Laid<'_> {
    /// Length that lies doubled [m].
    const fn folded(&self) -> f64 {
        self.marker.folded_length.to_m()
    }

    /// Whether a piece reaches over the selvage.
    fn is_wide(&self, placed: &Placed) -> bool {
        self.marker.cloth.width.to_m() + 1e-4 < placed.outline.bounds().y1
    }

    /// The bare cloth: what is doubled, then what is single.
    fn draw_cloth(&self, sheet: &mut Sheet) {
        let (width, length) = (self.marker.cloth.width.to_m(), lying_length(self.marker));
        let folded = self.folded();
        let doubled = (0.0 < folded).then_some((0.0, folded, 0.5 * width));
        let single = (folded < length).then_some((folded, length, width));
        for (from, to, height) in doubled.into_iter().chain(single) {
            let corners = [
                (from, 0.0),
                (to, 0.0),
                (to, height),
                (from, height),
                (from, 0.0),
            ];
            let path = line(&corners.map(Point::from), self.page);
            let fill = (!self.is_printed).then_some(CLOTH);
            let stroke = Stroke::solid(0.2).with_color(Color::GRAY);
            sheet.path(path, fill, Some(stroke));
        }
    }

    /// A laid piece as it is cut.
    fn draw_outline(&self, sheet: &mut Sheet, placed: &Placed) {
        let is_wide = self.is_wide(placed);
        let fill = match placed.layers {
            _ if self.is_printed => None,
            _ if is_wide => Some(TOO_WIDE),
            1 => Some(PIECE),
            _ => Some(DOUBLED),
        };
        let line = if self.is_printed && is_wide {
            Stroke::solid(0.7).with_color(OVER_SELVAGE)
        } else {
            Stroke::solid(0.35)
        };
        sheet.path(outline(&placed.outline, self.page), fill, Some(line));
    }

    /// Stitching line, grain and name of a laid piece; whether it has its number instead of its name.
    fn draw_inside(&self, canvas: &mut Canvas<'_>, placed: &Placed) -> bool {
        let piece = &self.pieces[placed.piece];
        let shown = if placed.is_on_fold {
            piece.clone()
        } else {
            piece.unfolded()
        };
        let drawing = shown.drawing(TOLERANCE);
        let to_page = self.page * placed.cloth_from_piece;
        let color = if self.is_printed {
            Color::BLACK
        } else {
            Color::GRAY
        };
        let thin = Stroke::solid(0.15).with_color(color);
        let stitches = drawing.stitches.iter().map(|stitches| &stitches.points);
        let marked = drawing.lines.iter().map(|marked| &marked.points);
        for points in stitches.chain(marked) {
            (canvas.sheet).path(line(points, to_page), None, Some(thin.clone()));
        }
        let grain = drawing.grain.map(|end| to_page * end);
        arrow(canvas.sheet, grain, &Stroke::solid(0.2).with_color(color));
        let name = piece.name.text(canvas.language);
        let bounds = outline(&placed.outline, self.page).control_box();
        // Above the grain arrow, where there is room for both.
        let room = scale_of(to_page) * drawing.label_room;
        let most = (0.8 * room / MM_PER_PT).clamp(5.0, 12.0);
        let fitted = fitting(name, 0.9 * bounds.width(), most);
        let fitted = fitted.filter(|style| LEAST_NAME <= style.size_pt);
        let number = (placed.piece + 1).to_string();
        let (name, style) = match fitted {
            Some(style) => (name, style),
            None => (number.as_str(), TextStyle::bold(9.0)),
        };
        self.draw_name(canvas.sheet, to_page * drawing.label, name, &style);
        fitted.is_none()
    }

    /// A piece's name or number, its middle above `at`.
    fn draw_name(&self, sheet: &mut Sheet, at: Point, name: &str, style: &TextStyle) {
        if self.is_printed {
            // Letters are read on white, not on flowers.
            let width = style.width_of(name) + style.em();
            let plate = Rect {
                x: at.x - 0.5 * width,
                y: at.y - 1.35 * style.em(),
                width,
                height: 1.5 * style.em(),
            };
            sheet.rect(plate, Some(Color::WHITE), None);
        }
        sheet.text([at.x, at.y - 0.3 * style.em()], name, style, Align::Center);
    }

    /// Selvages and fold, said along them.
    fn draw_edges(&self, canvas: &mut Canvas<'_>) {
        let (cloth, language) = (&self.marker.cloth, canvas.language);
        let (length, folded, width) =
            (lying_length(self.marker), self.folded(), cloth.width.to_m());
        let style = TextStyle::regular(8.0).with_color(Color::GRAY);
        let selvage = language.pick("耳", "selvage");
        let bold = Stroke::solid(0.6).with_color(Color::GRAY);
        let mut edge = |from: f64, to: f64, y: f64, name: &str| {
            let [a, b] = [(from, y), (to, y)].map(|end| self.page * Point::from(end));
            (canvas.sheet).line([a.x, a.y], [b.x, b.y], bold.clone());
            let lift = if 0.0 < y { -1.5 } else { 3.8 };
            (canvas.sheet).text([a.x, a.y + lift], name, &style, Align::Left);
        };
        let lower = match (cloth.lay, cloth.border.is_some()) {
            (Lay::Folded, _) => language.pick("わ", "fold"),
            (Lay::Single, true) => language.pick("耳・ボーダー柄", "selvage with the border"),
            (Lay::Single, false) => selvage,
        };
        if 0.0 < folded {
            edge(0.0, folded, 0.0, lower);
            edge(0.0, folded, 0.5 * width, selvage);
        }
        if folded < length {
            let lower = if 0.0 < folded { selvage } else { lower };
            edge(folded, length, 0.0, lower);
            edge(folded, length, width, selvage);
        }
    }

    /// Length and width of the cloth.
    fn draw_measures(&self, canvas: &mut Canvas<'_>) {
        let (sheet, marker) = (&mut *canvas.sheet, self.marker);
        let style = TextStyle::bold(10.0);
        let fine = Stroke::solid(0.2);
        let on_page = |ends: [(f64, f64); 2]| ends.map(|end| self.page * Point::from(end));
        let [from, to] = on_page([(0.0, 0.0), (lying_length(marker), 0.0)]);
        let below = kurbo::Vec2::new(0.0, 6.0);
        arrow(sheet, [from + below, to + below], &fine);
        let middle = from.midpoint(to);
        let along = match canvas.language {
            Language::Japanese => format!("{}（縦地の方向）", cm(marker.yardage.needed)),
            Language::English => format!("{} along the warp", cm(marker.yardage.needed)),
        };
        sheet.text([middle.x, middle.y + 10.5], &along, &style, Align::Center);
        let width = lying_width(marker);
        let [low, high] = on_page([(0.0, 0.0), (0.0, width.to_m())]);
        let aside = kurbo::Vec2::new(-3.5, 0.0);
        arrow(sheet, [low + aside, high + aside], &fine);
        let at = low.midpoint(high) + aside;
        let quarter = core::f64::consts::FRAC_PI_2;
        sheet.turned_text([at.x - 1.5, at.y], quarter, &cm(width), &style);
        let across = lying_across(marker);
        if width.to_m() + 1e-4 < across {
            let end = self.page * Point::new(0.0, across);
            let said = cm(Length::from_m(across));
            sheet.text([end.x, end.y - 1.5], &said, &style, Align::Left);
        }
    }
}

/// Every piece of a cloth: how often it is cut, how large it is.
fn pieces_table(cut: &CutGarment, plan: &ClothPlan, language: Language) -> PageTable {
    let pick = |japanese: &'static str, english: &'static str| language.pick(japanese, english);
    let pieces = cut.garment.cutting().pieces.iter();
    let rows = pieces
        .filter(|piece| piece.cloth == plan.role)
        .map(|piece| {
            let whole = piece.unfolded().cut_polygon(TOLERANCE);
            let bounds = whole.bounds();
            let [width, height] = [bounds.width(), bounds.height()].map(|side| 0.1 * MM * side);
            let size = if piece.is_on_bias() {
                let bias = pick("斜め 45°", "bias 45°");
                format!("{bias}: {width:.1} × {height:.1} cm")
            } else if piece.grain.y.abs() < piece.grain.x.abs() {
                format!("{width:.1} × {height:.1} cm")
            } else {
                format!("{height:.1} × {width:.1} cm")
            };
            let how = if piece.rectangle(TOLERANCE).is_some() {
                pick(
                    "定規とチャコで（ruler.pdf）",
                    "by ruler and chalk (ruler.pdf)",
                )
            } else {
                pick("型紙で", "by the paper pattern")
            };
            let area = 1e4 * whole.signed_area() * f64::from(piece.cut.pieces());
            vec![
                Cell::bold(piece.name.text(language)),
                Cell::from(cut_words(piece, language)),
                Cell::from(size),
                Cell::from(format!("{area:.0} cm²")),
                Cell::from(how),
            ]
        });
    PageTable {
        columns: vec![
            Column::text(pick("パーツ", "piece"), 0.23),
            Column::text(pick("枚数", "count"), 0.14),
            Column::text(
                pick(
                    "裁ち切り寸法（耳に沿って × 幅の方向）",
                    "cut size, along the selvage × across",
                ),
                0.27,
            ),
            Column::number(pick("面積（全部）", "area in all"), 0.14),
            Column::text(pick("写し方", "how to draw it"), 0.22),
        ],
        rows: rows.collect(),
        size_pt: 10.0,
    }
}
