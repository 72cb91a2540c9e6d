//! Pieces at full size over sheets of paper that are joined.
//!
//! Each sheet shows a window of the whole drawing, a centimeter wider than its step, so that sheets
//! overlap. The left and the upper edge of a window are cut, and laid on the broken line of the sheet
//! before; numbered diamonds meet there.

use std::sync::Arc;

use kurbo::{Affine, Point, Vec2};
use lole_costume::tailoring::role_name;
use lole_geom::Length;
use lole_language::Language;
use lole_pattern::Pattern;
use lole_pattern::marker::{Lay, Marker, Nap, Placed, TableCloth, lay_out};
use lole_pattern::piece::{ClothRole, CutCount, Finish, Piece};
use lole_pattern::polygon::Polygon;

use super::draw::{
    FullSize, PLACE_ON_FOLD, PieceLines, arrow, fitting, fold_stroke, marked_stroke, outline,
};
use super::label::Label;
use super::stamp::{CODE, draw_bar};
use super::{CutGarment, MM, TOLERANCE, cut_words};
use crate::canvas::Canvas;
use crate::pdf::{Align, Color, Item, Layer, Paper, Rect, Sheet, Stroke, TextStyle};

/// What no home printer needs to print on [mm].
const MARGIN: f64 = 10.0;
/// Sheets overlap by this [mm].
const OVERLAP: f64 = 10.0;
/// Half the diagonal of a diamond [mm].
const DIAMOND: f64 = 3.0;
/// Side of the square by which a print is checked [mm].
const TEST_SQUARE: f64 = 100.0;
/// Pieces keep this distance from the border of the drawing [mm].
const BORDER: f64 = 4.0;

/// Room for the name of a tile at its upper edge [mm].
const TILE_NAME: f64 = 16.0;

/// Half the space between two pieces on paper [mm].
const SPACE: f64 = 3.0;

/// Letters at joints.
const SMALL: TextStyle = TextStyle::regular(7.0);

const PALE: Color = Color(170, 170, 170);

/// A pattern over many sheets.
#[derive(Debug, Clone, PartialEq)]
pub struct TiledPattern {
    /// A page of instructions with the map, and the sheets in its order.
    pub sheets: Vec<Sheet>,
    /// Columns and rows of the map.
    pub grid: [u32; 2],
    /// Pieces that are drawn here; rectangles are not.
    pub piece_count: usize,
}

/// The pieces of a garment that no ruler draws, at full size; `None` where there are none. Pieces on a
/// fold are drawn to it, pairs once.
#[must_use]
pub fn tiled_sheets(cut: &CutGarment, paper: Paper, language: Language) -> Option<TiledPattern> {
    let free = free_pieces(cut);
    if free.is_empty() {
        return None;
    }
    let layout = Layout::new(&free, paper);
    let tiles = layout.used_tiles();
    let rooms: Vec<kurbo::Rect> = tiles.iter().map(|tile| layout.room(*tile)).collect();
    let drawn = Drawn {
        placed: &layout.marker.placed,
        page_from_cloth: layout.drawing_from_marker(),
        rooms: &rooms,
        is_upright: false,
        thick: 1.0,
    };
    let layers = draw_pieces(cut, &free, &drawn, language);
    let drawing = Arc::new(layers.into_iter().flat_map(|layer| layer.items).collect());
    let mut sheets = vec![cover(cut, &layout, tiles.len(), language)];
    for (number, tile) in (1_usize..).zip(&tiles) {
        let mut sheet = layout.tile_sheet(*tile, &tiles, &drawing, language);
        let [width, height] = sheet.size;
        let foot = foot(cut, number, tiles.len(), language);
        let style = fitted_foot(&foot, width - 2.0 * MARGIN - 56.0);
        sheet.text([width - MARGIN, height - 5.0], &foot, &style, Align::Right);
        draw_bar(&mut sheet, [MARGIN, height - 6.4], language);
        sheet.bookmarks.push(tile_name(*tile));
        sheets.push(sheet);
    }
    Some(TiledPattern {
        sheets,
        grid: [layout.columns, layout.rows],
        piece_count: free.len(),
    })
}

/// Pieces that no ruler draws.
pub(super) fn free_pieces(cut: &CutGarment) -> Vec<&Piece> {
    let pieces = cut.garment.cutting().pieces.iter();
    pieces
        .filter(|piece| piece.rectangle(TOLERANCE).is_none())
        .collect()
}

/// The pieces as paper has them: once each, to their folds only, with room for scissors between them.
pub(super) fn on_paper(free: &[&Piece]) -> Pattern {
    let once = |piece: &&Piece| {
        let mut piece = (*piece).clone();
        piece.cut = CutCount::Alike(1);
        piece.cloth = ClothRole::Main;
        for edge in &mut piece.edges {
            edge.allowance = edge.allowance + Length::from_m(SPACE / MM);
            if edge.finish == Finish::Fold {
                edge.finish = Finish::Selvage;
            }
        }
        piece
    };
    Pattern {
        pieces: free.iter().map(once).collect(),
        ..Pattern::default()
    }
}

/// All pieces laid on one large sheet, and how paper covers it.
struct Layout {
    paper: Paper,
    marker: Marker,
    columns: u32,
    rows: u32,
}

impl Layout {
    /// The sheet that takes the fewest papers, over some widths.
    fn new(free: &[&Piece], paper: Paper) -> Self {
        let pattern = on_paper(free);
        let [_, step] = step(paper);
        let mut best: Option<Self> = None;
        for rows in 1..=MOST_ROWS {
            let width = f64::from(rows) * step + OVERLAP - 2.0 * BORDER;
            let cloth = TableCloth {
                width: Length::from_m(width / MM),
                nap: Nap::TwoWay,
                border: None,
                matched_repeat: None,
                lay: Lay::Single,
            };
            let marker = lay_out(&pattern, ClothRole::Main, &cloth);
            let is_too_narrow = !marker.warnings.is_empty();
            if is_too_narrow && rows < MOST_ROWS {
                continue;
            }
            let layout = Self::around(marker, paper);
            let count = layout.used_tiles().len();
            let is_better = (best.as_ref()).is_none_or(|best| count < best.used_tiles().len());
            let is_last = best.is_some();
            if is_better {
                best = Some(layout);
            }
            if is_last {
                break;
            }
        }
        best.unwrap_or_else(|| Self::around(lay_out(&pattern, ClothRole::Main, &FALLBACK), paper))
    }

    fn around(marker: Marker, paper: Paper) -> Self {
        let bounds = marker.placed.iter().map(|placed| placed.outline.bounds());
        let [x, y] = bounds.fold([0.0, 0.0], |[x, y]: [f64; 2], bounds| {
            [x.max(bounds.x1), y.max(bounds.y1)]
        });
        let [step_x, step_y] = step(paper);
        let columns = tiles_for(x * MM + 2.0 * BORDER, step_x);
        let rows = tiles_for(y * MM + 2.0 * BORDER, step_y);
        Self {
            paper,
            marker,
            columns,
            rows,
        }
    }

    /// How the sheets are printed and joined.
    fn how_to_join(&self, count: usize, language: Language) -> String {
        let paper = self.paper.name();
        let [columns, rows] = [self.columns, self.rows];
        match language {
            Language::Japanese => format!(
                "{paper} 用紙 {count} 枚（横 {columns} × 縦 {rows}）。「実際のサイズ」「倍率100 %」で印刷し、下の四角を\
                 定規で測ってから始めます。各ページの左と上の実線を切り、前のページの破線に重ね、同じ番号の◇を合わせて貼ります。"
            ),
            Language::English => format!(
                "{count} sheets of {paper}, {columns} across and {rows} down. Print at actual size (100 %) and \
                 measure the square below before you go on. On each sheet cut the solid line at the left and at \
                 the top, lay it on the broken line of the sheet before so that diamonds of one number meet, and \
                 glue."
            ),
        }
    }

    /// Height of the whole drawing [mm].
    fn height(&self) -> f64 {
        f64::from(self.rows) * step(self.paper)[1] + OVERLAP
    }

    /// From meters of the laid pieces to millimeters of the whole drawing, `y` down.
    fn drawing_from_marker(&self) -> Affine {
        Affine::translate((BORDER, self.height() - BORDER)) * Affine::scale_non_uniform(MM, -MM)
    }

    /// Window of a tile in the whole drawing [mm].
    fn window(&self, [column, row]: [u32; 2]) -> kurbo::Rect {
        let [x, y] = step(self.paper);
        let origin = Point::new(f64::from(column) * x, f64::from(row) * y);
        kurbo::Rect::from_origin_size(origin, (x + OVERLAP, y + OVERLAP))
    }

    /// What of a window lies on no other sheet, below the name of the tile [mm].
    fn room(&self, tile: [u32; 2]) -> kurbo::Rect {
        let window = self.window(tile);
        kurbo::Rect::new(
            window.x0 + OVERLAP,
            window.y0 + OVERLAP.max(TILE_NAME),
            window.x1 - OVERLAP,
            window.y1 - OVERLAP,
        )
    }

    /// Tiles that hold a part of a piece, row by row.
    fn used_tiles(&self) -> Vec<[u32; 2]> {
        let to_drawing = self.drawing_from_marker();
        let outlines: Vec<Polygon> = (self.marker.placed.iter())
            .map(|placed| placed.outline.transformed(to_drawing))
            .collect();
        let all = (0..self.rows).flat_map(|row| (0..self.columns).map(move |column| [column, row]));
        all.filter(|tile| {
            let window = self.window(*tile);
            outlines.iter().any(|outline| touches(outline, window))
        })
        .collect()
    }

    /// One sheet of the pattern.
    fn tile_sheet(
        &self,
        tile: [u32; 2],
        tiles: &[[u32; 2]],
        drawing: &Arc<Vec<Item>>,
        language: Language,
    ) -> Sheet {
        let window = self.window(tile);
        let frame = Rect {
            x: MARGIN,
            y: MARGIN,
            width: window.width(),
            height: window.height(),
        };
        let mut sheet = Sheet::new(self.paper.size_mm());
        let shift = Vec2::new(MARGIN, MARGIN) - window.origin().to_vec2();
        let name = TextStyle::bold(22.0).with_color(PALE);
        sheet.text(
            [frame.x + 14.0, frame.y + 14.0],
            &tile_name(tile),
            &name,
            Align::Left,
        );
        sheet.items.push(Item::Group {
            page_from_group: Affine::translate(shift),
            clip: Some(frame),
            items: Arc::clone(drawing),
        });
        sheet.rect(frame, None, Some(Stroke::solid(0.15).with_color(PALE)));
        let middle = [frame.x + 0.5 * frame.width, frame.y + 0.5 * frame.height];
        for joint in self.joints(tile, tiles, frame) {
            joint.draw(&mut sheet, frame, middle, language);
        }
        sheet
    }

    /// Where a tile whose window lies in `frame` on its page meets other tiles.
    fn joints(&self, tile: [u32; 2], tiles: &[[u32; 2]], frame: Rect) -> Vec<Joint> {
        let [column, row] = tile;
        let neighbor = |tile: Option<[u32; 2]>| tile.filter(|tile| tiles.contains(tile));
        let left = neighbor(column.checked_sub(1).map(|column| [column, row]));
        let above = neighbor(row.checked_sub(1).map(|row| [column, row]));
        let right = neighbor(Some([column + 1, row]));
        let below = neighbor(Some([column, row + 1]));
        let ends = [frame.x + frame.width, frame.y + frame.height];
        let joints = [
            left.map(|_| (Run::Upright, frame.x, tile, None)),
            right.map(|other| (Run::Upright, ends[0] - OVERLAP, other, Some(other))),
            above.map(|_| (Run::Level, frame.y, tile, None)),
            below.map(|other| (Run::Level, ends[1] - OVERLAP, other, Some(other))),
        ];
        let joints = joints.into_iter().flatten();
        joints
            .map(|(run, at, later, other)| Joint {
                run,
                at,
                number: self.joint_number(later, run),
                other,
            })
            .collect()
    }

    /// Number of the joint at the left or at the upper edge of a tile: the same on both of its sheets.
    fn joint_number(&self, [column, row]: [u32; 2], run: Run) -> u32 {
        2 * (row * self.columns + column) + u32::from(run == Run::Level)
    }
}

/// More rows of paper than this go over no table.
const MOST_ROWS: u32 = 8;

/// A table that any piece lies on, if only by hanging over.
const FALLBACK: TableCloth = TableCloth {
    width: Length::from_m(2.0),
    nap: Nap::TwoWay,
    border: None,
    matched_repeat: None,
    lay: Lay::Single,
};

/// From one window to the next [mm].
fn step(paper: Paper) -> [f64; 2] {
    paper.size_mm().map(|side| side - 2.0 * MARGIN - OVERLAP)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "no drawing is a thousand sheets wide"
)]
fn tiles_for(size: f64, step: f64) -> u32 {
    (((size - OVERLAP) / step) - 1e-9).ceil().max(1.0) as u32
}

/// Row by letter, column by number: `B3`.
fn tile_name([column, row]: [u32; 2]) -> String {
    let letter = char::from_u32(u32::from('A') + row % 26).unwrap_or('A');
    let again = if 26 <= row {
        letter.to_string()
    } else {
        String::new()
    };
    format!("{again}{letter}{}", column + 1)
}

/// Whether any of an outline lies in a window.
fn touches(outline: &Polygon, window: kurbo::Rect) -> bool {
    let bounds = outline.bounds();
    let is_apart = bounds.x1 < window.x0
        || window.x1 < bounds.x0
        || bounds.y1 < window.y0
        || window.y1 < bounds.y0;
    if is_apart {
        return false;
    }
    let corners = [
        Point::new(window.x0, window.y0),
        Point::new(window.x1, window.y0),
        Point::new(window.x1, window.y1),
        Point::new(window.x0, window.y1),
    ];
    let frame = Polygon::new(corners);
    outline.points.iter().any(|point| window.contains(*point))
        || corners.iter().any(|corner| outline.contains(*corner))
        || outline
            .sides()
            .any(|side| frame.sides().any(|edge| cross(side, edge)))
}

/// Whether two segments cross within both.
pub(super) fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let turn = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

/// How a joint runs over the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Run {
    Upright,
    Level,
}

/// Where a sheet meets another one.
struct Joint {
    run: Run,
    /// Where its line runs on the page [mm].
    at: f64,
    number: u32,
    /// The sheet that is laid there; `None` where this one is cut.
    other: Option<[u32; 2]>,
}

impl Joint {
    /// The line, a numbered diamond on it, and what to do there.
    fn draw(&self, sheet: &mut Sheet, frame: Rect, middle: [f64; 2], language: Language) {
        let stroke = match self.other {
            Some(_) => Stroke::dashed(0.2, 2.0),
            None => Stroke::solid(0.2),
        };
        let (from, size, center) = if self.run == Run::Upright {
            (frame.y, frame.height, middle[1])
        } else {
            (frame.x, frame.width, middle[0])
        };
        sheet.line(
            self.on_page(from, 0.0),
            self.on_page(from + size, 0.0),
            stroke,
        );
        self.draw_diamond(sheet, center);
        let aside = if self.other.is_some() { 4.0 } else { -1.5 };
        let angle = match self.run {
            Run::Upright => core::f64::consts::FRAC_PI_2,
            Run::Level => 0.0,
        };
        let at = self.on_page(center - 35.0, aside);
        sheet.turned_text(at, angle, &self.words(language), &SMALL);
    }

    /// A point so far along the joint from the page's edge, and so far beside it [mm].
    fn on_page(&self, along: f64, aside: f64) -> [f64; 2] {
        match self.run {
            Run::Upright => [self.at + aside, along],
            Run::Level => [along, self.at + aside],
        }
    }

    /// The numbered diamond so far along the joint [mm].
    fn draw_diamond(&self, sheet: &mut Sheet, center: f64) {
        let corners = [
            (-DIAMOND, 0.0),
            (0.0, -DIAMOND),
            (DIAMOND, 0.0),
            (0.0, DIAMOND),
        ];
        let corners = corners.map(|(along, aside)| {
            let [x, y] = self.on_page(center + along, aside);
            Point::new(x, y)
        });
        let diamond = outline(&Polygon::new(corners), Affine::IDENTITY);
        sheet.path(diamond, Some(Color::WHITE), Some(Stroke::solid(0.25)));
        let [x, y] = self.on_page(center, 0.0);
        let number = self.number.to_string();
        sheet.text([x, y + 0.9], &number, &SMALL, Align::Center);
    }

    /// What is done at the joint.
    fn words(&self, language: Language) -> String {
        match (self.other.map(tile_name), language) {
            (Some(name), Language::Japanese) => format!("ここに {name} を重ねて貼る"),
            (Some(name), Language::English) => format!("lay {name} here"),
            (None, Language::Japanese) => "この線で切る".to_owned(),
            (None, Language::English) => "cut along this line".to_owned(),
        }
    }
}

/// All pieces at full size in the space of the whole drawing, by what lines are for.
pub(super) fn draw_pieces(
    cut: &CutGarment,
    free: &[&Piece],
    drawn: &Drawn<'_>,
    language: Language,
) -> Vec<Layer> {
    let mut lines = PieceLines::none();
    for placed in drawn.placed {
        let piece = free[placed.piece];
        let to_page = drawn.page_from_cloth * placed.cloth_from_piece;
        let drawing = piece.drawing(TOLERANCE);
        let words = label(cut, piece, language);
        let mut place = Label::of(&drawing, &words, to_page, drawn.rooms);
        if drawn.is_upright {
            place = place.beside(&drawing, &words, to_page);
        }
        let full_size = FullSize {
            drawing: &drawing,
            page_from_piece: to_page,
            language,
            thick: drawn.thick,
        };
        full_size.draw(&mut lines, &words, &place);
    }
    lines.into_layers(language)
}

/// Pieces as they lie on paper.
pub(super) struct Drawn<'a> {
    pub(super) placed: &'a [Placed],
    /// From meters of the cloth that they were laid on to millimeters of the page.
    pub(super) page_from_cloth: Affine,
    /// Parts of the page on which words stand whole; none where all of it is.
    pub(super) rooms: &'a [kurbo::Rect],
    /// Whether the warp, and so all arrows, run down the page.
    pub(super) is_upright: bool,
    /// How thick lines are, over those of paper.
    pub(super) thick: f64,
}

/// What stands on a piece: its name, its garment, how often and from what it is cut.
fn label(cut: &CutGarment, piece: &Piece, language: Language) -> Vec<String> {
    let cloth = role_name(piece.cloth).text(language);
    let on_fold = piece.edges.iter().any(|edge| edge.finish == Finish::Fold);
    let fold = if on_fold {
        language.pick("（わ）", " on fold")
    } else {
        ""
    };
    vec![
        piece.name.text(language).to_owned(),
        cut.title(language),
        format!("{cloth}　{}{fold}", cut_words(piece, language)),
    ]
}

/// Letters in which the line at the foot of a sheet leaves room for what stands beside it.
fn fitted_foot(foot: &str, room: f64) -> TextStyle {
    const MOST: f64 = 8.0;
    let natural = TextStyle::regular(MOST).width_of(foot);
    TextStyle::regular(MOST * (room / natural).min(1.0))
}

/// The line at the foot of a sheet.
fn foot(cut: &CutGarment, number: usize, count: usize, language: Language) -> String {
    let name = cut.title(language);
    let stamp = cut.stamp.words();
    match language {
        Language::Japanese => format!("{name}　{stamp}　{number} / {count}　倍率100 %で印刷"),
        Language::English => {
            format!("{name}  {stamp}  sheet {number} of {count}. Print at 100 %.")
        }
    }
}

/// The first page: how to print and join, a square to measure, the map, the lines.
fn cover(cut: &CutGarment, layout: &Layout, count: usize, language: Language) -> Sheet {
    let mut sheet = Sheet::new(layout.paper.size_mm());
    let [width, height] = sheet.size;
    let left = 15.0;
    let room = width - 2.0 * left;
    let name = cut.title(language);
    let title = match language {
        Language::Japanese => format!("{name}　実物大型紙"),
        Language::English => format!("{name}: full-size pattern"),
    };
    sheet.text([left, 22.0], &title, &TextStyle::bold(20.0), Align::Left);
    let steps = layout.how_to_join(count, language);
    let used = sheet.paragraph([left, 27.0], room, &steps, &TextStyle::regular(11.0));
    let top = 32.0 + used;
    let square = Rect {
        x: left,
        y: top,
        width: TEST_SQUARE,
        height: TEST_SQUARE,
    };
    sheet.rect(square, None, Some(Stroke::solid(0.3)));
    let said = language.pick("この四角は 10 cm × 10 cm", "this square is 10 cm × 10 cm");
    let center = [left + 0.5 * TEST_SQUARE, top + 0.5 * TEST_SQUARE];
    sheet.text(center, said, &TextStyle::bold(12.0), Align::Center);
    draw_legend(&mut sheet, [left + TEST_SQUARE + 10.0, top], language);
    let code = [left + TEST_SQUARE + 10.0, top + TEST_SQUARE - CODE];
    cut.stamp.draw(&mut sheet, code, &cut.owner);
    sheet.bookmarks.push(title.clone());
    let map = Rect {
        x: left,
        y: top + TEST_SQUARE + 14.0,
        width: room,
        height: height - top - TEST_SQUARE - 14.0 - 14.0,
    };
    let heading = language.pick("ページの並べ方", "map of the sheets");
    sheet.text(
        [left, map.y - 3.0],
        heading,
        &TextStyle::bold(11.0),
        Align::Left,
    );
    let mut canvas = Canvas {
        sheet: &mut sheet,
        rect: map,
        language,
    };
    draw_map(&mut canvas, layout, cut);
    sheet
}

/// What each kind of line means.
fn draw_legend(sheet: &mut Sheet, [x, y]: [f64; 2], language: Language) {
    let rows: [(Stroke, &str, &str); 4] = [
        (
            Stroke::solid(0.5),
            "裁ち切り線（ここを切る）",
            "cutting line",
        ),
        (
            Stroke::dashed(0.3, 3.0),
            "縫い線（でき上がり線）",
            "stitching line",
        ),
        (fold_stroke(), PLACE_ON_FOLD.japanese, PLACE_ON_FOLD.english),
        (
            marked_stroke(1.0),
            "折り線・付け位置など",
            "folds, placements",
        ),
    ];
    let style = TextStyle::regular(9.5);
    let mut y = y + 6.0;
    for (stroke, japanese, english) in rows {
        sheet.line([x, y], [x + 18.0, y], stroke);
        sheet.text(
            [x + 21.0, y + 1.2],
            language.pick(japanese, english),
            &style,
            Align::Left,
        );
        y += 11.0;
    }
    let grain = [x, x + 18.0].map(|x| Point::new(x, y));
    arrow(sheet, grain, &Stroke::solid(0.35));
    let said = language.pick("布目の矢印（耳と平行）", "grain arrow, along the selvage");
    sheet.text([x + 21.0, y + 1.2], said, &style, Align::Left);
    y += 11.0;
    sheet.line([x + 9.0, y - 2.5], [x + 9.0, y + 2.5], Stroke::solid(0.5));
    let notch = language.pick("合印（切り込み 5 mm）", "notch, 5 mm into the edge");
    sheet.text([x + 21.0, y + 1.2], notch, &style, Align::Left);
    let allowance = language.pick("縫い代は入っています。", "Seam allowances are included.");
    sheet.text(
        [x, y + 13.0],
        allowance,
        &TextStyle::bold(10.0),
        Align::Left,
    );
}

/// All sheets small, with the pieces on them.
fn draw_map(canvas: &mut Canvas<'_>, layout: &Layout, cut: &CutGarment) {
    let sheet = &mut *canvas.sheet;
    let whole = layout.window([layout.columns - 1, layout.rows - 1]);
    let fitted = canvas.rect.fitting(whole.x1, whole.y1);
    let scale = fitted.width / whole.x1;
    let map = Affine::translate((fitted.x, fitted.y)) * Affine::scale(scale);
    let [step_x, step_y] = step(layout.paper);
    for tile in layout.used_tiles() {
        let window = layout.window(tile);
        let corner = map * window.origin();
        let cell = Rect {
            x: corner.x,
            y: corner.y,
            width: step_x * scale,
            height: step_y * scale,
        };
        sheet.rect(cell, None, Some(Stroke::solid(0.2).with_color(PALE)));
        let style = TextStyle::bold((cell.height * 0.8).clamp(7.0, 16.0)).with_color(PALE);
        let at = [cell.x + 1.5, cell.y + style.em()];
        sheet.text(at, &tile_name(tile), &style, Align::Left);
    }
    let free = free_pieces(cut);
    for placed in &layout.marker.placed {
        let to_map = map * layout.drawing_from_marker();
        let path = outline(&placed.outline, to_map);
        let bounds = path.control_box();
        sheet.path(path, None, Some(Stroke::solid(0.35)));
        let name = free[placed.piece].name.text(canvas.language);
        if let Some(style) = fitting(name, 0.9 * bounds.width(), 10.0) {
            let (label, _) = placed.outline.roomiest_point();
            let at = to_map * label;
            sheet.text(
                [at.x, at.y + 0.35 * style.em()],
                name,
                &style,
                Align::Center,
            );
        }
    }
}
