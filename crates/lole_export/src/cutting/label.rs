//! Where the words of a piece stand on paper: whole on one sheet, clear of its lines.

use kurbo::{Affine, Point, Rect};
use lole_pattern::piece::Drawing;
use lole_pattern::polygon::Polygon;

use super::draw::scale_of;
use super::tiles::cross;
use crate::pdf::TextStyle;

/// Space between a label and the grain arrow below it [mm].
const CLEAR: f64 = 3.0;
/// Sizes that a label is tried in [pt].
const SIZES: [f64; 7] = [18.0, 16.0, 14.0, 12.0, 10.0, 8.0, 7.0];
/// Smallest size that a label takes in order to stand on one sheet [pt].
const LEAST: f64 = 10.0;
/// Places are tried at this distance from each other [mm].
const STEP: f64 = 6.0;
/// Words of a line or a point, beside its middle [mm].
const WORDS: [f64; 2] = [24.0, 5.0];

/// The words of a piece in their place.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Label {
    /// Middle of the lower edge of the words [mm].
    pub(super) foot: Point,
    /// Their letters.
    pub(super) style: TextStyle,
}

impl Label {
    /// The roomiest place of a piece, smaller where there is little room; where that lies on none of
    /// the sheets whole and another place does, there. `sheets` are the parts of the page that lie on
    /// one sheet only, clear of what is written on it.
    pub(super) fn of(
        drawing: &Drawing,
        words: &[String],
        page_from_piece: Affine,
        sheets: &[Rect],
    ) -> Self {
        let natural = Self::roomiest(drawing, words, page_from_piece);
        let lies = |label: &Self| {
            let space = label.space(words);
            sheets.iter().any(|sheet| sheet.union(space) == *sheet)
        };
        if sheets.is_empty() || lies(&natural) {
            return natural;
        }
        let lines = Lines::of(drawing, page_from_piece);
        let sizes = SIZES.into_iter();
        let sizes = sizes.filter(|size| (LEAST..=natural.style.size_pt).contains(size));
        let mut elsewhere = sizes.filter_map(|size| {
            let style = TextStyle::bold(size);
            let on_sheets = sheets.iter();
            let places = on_sheets.flat_map(|sheet| places(*sheet, &style, words));
            // The nearest first: most places are never looked at.
            let mut places: Vec<Point> = places.collect();
            let far = |foot: &Point| foot.distance_squared(natural.foot);
            places.sort_by(|one, other| far(one).total_cmp(&far(other)));
            let mut labels = places.into_iter().map(|foot| Self { foot, style });
            labels.find(|label| lines.leave_free(label.space(words)))
        });
        elsewhere.next().unwrap_or(natural)
    }

    /// Above the grain arrow in the middle of the roomiest place.
    fn roomiest(drawing: &Drawing, words: &[String], page_from_piece: Affine) -> Self {
        let room = scale_of(page_from_piece) * drawing.label_room;
        let fits = |style: &TextStyle| {
            let height = height_of(style, words) + CLEAR;
            let half = 0.5 * width_of(style, words);
            (half * half + height * height).sqrt() <= room
        };
        let style = SIZES.into_iter().map(TextStyle::bold).find(fits);
        let at = page_from_piece * drawing.label;
        Self {
            foot: Point::new(at.x, at.y - CLEAR),
            style: style.unwrap_or_else(|| TextStyle::bold(6.0)),
        }
    }

    /// The label beside an arrow that runs through its place, smaller where there is little room.
    pub(super) fn beside(
        self,
        drawing: &Drawing,
        words: &[String],
        page_from_piece: Affine,
    ) -> Self {
        let room = scale_of(page_from_piece) * drawing.label_room - CLEAR;
        let wide = width_of(&self.style, words);
        let size_pt = self.style.size_pt * (room / wide.max(1.0)).clamp(0.4, 1.0);
        let style = TextStyle::bold(size_pt);
        let at = page_from_piece * drawing.label;
        Self {
            foot: Point::new(
                at.x + CLEAR + 0.5 * width_of(&style, words),
                at.y + 0.4 * height_of(&style, words),
            ),
            style,
        }
    }

    /// What the words cover [mm].
    fn space(&self, words: &[String]) -> Rect {
        let half = 0.5 * width_of(&self.style, words);
        let (foot, below) = (self.foot, 0.3 * self.style.em());
        Rect::new(
            foot.x - half,
            foot.y - height_of(&self.style, words),
            foot.x + half,
            foot.y + below,
        )
    }
}

fn width_of(style: &TextStyle, words: &[String]) -> f64 {
    let widths = words.iter().map(|text| style.width_of(text));
    widths.fold(0.0, f64::max)
}

fn height_of(style: &TextStyle, words: &[String]) -> f64 {
    style.line_height() * words.len() as f64
}

/// Feet of words that lie whole on a sheet, row by row.
fn places(sheet: Rect, style: &TextStyle, words: &[String]) -> Vec<Point> {
    let half = 0.5 * width_of(style, words);
    let [left, right] = [sheet.x0 + half, sheet.x1 - half];
    let [top, bottom] = [
        sheet.y0 + height_of(style, words),
        sheet.y1 - 0.3 * style.em(),
    ];
    let mut feet = Vec::new();
    let mut y = top;
    while y <= bottom {
        let mut x = left;
        while x <= right {
            feet.push(Point::new(x, y));
            x += STEP;
        }
        y += STEP;
    }
    feet
}

/// What words keep clear of.
struct Lines {
    outline: Polygon,
    bounds: Rect,
    segments: Vec<[Point; 2]>,
    /// Words that stand on the piece already.
    words: Vec<Rect>,
}

impl Lines {
    fn of(drawing: &Drawing, page_from_piece: Affine) -> Self {
        let outline = drawing.cut.transformed(page_from_piece);
        let drawn = (drawing.stitches.iter().map(|it| &it.points))
            .chain(drawing.lines.iter().map(|it| &it.points));
        let mut segments: Vec<[Point; 2]> = outline.sides().collect();
        segments.push(drawing.grain.map(|end| page_from_piece * end));
        let mut words: Vec<Rect> = Vec::new();
        for points in drawn {
            let on_page: Vec<Point> = points
                .iter()
                .map(|point| page_from_piece * *point)
                .collect();
            segments.extend(on_page.windows(2).map(|pair| [pair[0], pair[1]]));
            if let (Some(first), Some(last)) = (on_page.first(), on_page.last()) {
                words.push(around(first.midpoint(*last)));
            }
        }
        let points = drawing.points.iter();
        words.extend(points.map(|(_, at)| around(page_from_piece * *at)));
        Self {
            bounds: outline.bounds(),
            outline,
            segments,
            words,
        }
    }

    fn leave_free(&self, space: Rect) -> bool {
        let corners = [
            Point::new(space.x0, space.y0),
            Point::new(space.x1, space.y0),
            Point::new(space.x1, space.y1),
            Point::new(space.x0, space.y1),
        ];
        let diagonals = [[corners[0], corners[2]], [corners[1], corners[3]]];
        let meets = |segment: &[Point; 2]| {
            let [from, to] = *segment;
            let is_apart = from.x.max(to.x) < space.x0
                || space.x1 < from.x.min(to.x)
                || from.y.max(to.y) < space.y0
                || space.y1 < from.y.min(to.y);
            !is_apart
                && (segment.iter().any(|end| space.contains(*end))
                    || diagonals.iter().any(|diagonal| cross(*segment, *diagonal)))
        };
        self.bounds.union(space) == self.bounds
            && corners.iter().all(|corner| self.outline.contains(*corner))
            && !self.segments.iter().any(meets)
            && !self.words.iter().any(|words| space.overlaps(*words))
    }
}

/// Space of the words at a point.
fn around(point: Point) -> Rect {
    let [wide, high] = WORDS;
    Rect::new(
        point.x - wide,
        point.y - high,
        point.x + wide,
        point.y + high,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_costume::document::{Design, GarmentDesign};
    use lole_costume::order::plan_design;

    /// Wherever the sheets meet, the words of every piece of a blouse that has room lie whole on one.
    #[test]
    fn words_lie_whole_on_one_sheet_inside_their_piece() {
        let design = Design {
            garments: GarmentDesign::of_kind("blouse").into_iter().collect(),
            ..Design::default()
        };
        let plan = plan_design("花子", &design).unwrap_or_else(|error| panic!("{error}"));
        let pieces = &plan.garments[1].tailored.pattern.pieces;
        let words = ["前身頃", "パフスリーブのブラウス", "表布　1 枚"].map(str::to_owned);
        let page = Affine::scale_non_uniform(1000.0, -1000.0);
        for piece in pieces.iter().filter(|piece| piece.id != "binding") {
            let drawing = piece.drawing(1e-3);
            let bounds = drawing.cut.transformed(page).bounds();
            for shift in [0.0, 37.0, 90.0] {
                let start = [bounds.x0 - shift, bounds.y0 - shift];
                let sheets: Vec<Rect> = (0..36_u32)
                    .map(|index| {
                        let [column, row] = [f64::from(index % 6), f64::from(index / 6)];
                        let corner = (start[0] + 180.0 * column, start[1] + 267.0 * row);
                        Rect::from_origin_size(corner, (165.0, 240.0))
                    })
                    .collect();
                let label = Label::of(&drawing, &words, page, &sheets);
                let space = label.space(&words);
                let is_whole = sheets.iter().any(|sheet| sheet.union(space) == *sheet);
                assert!(is_whole, "{} {shift}: {space:?}", piece.id);
                let outline = drawing.cut.transformed(page);
                let corners = [(space.x0, space.y0), (space.x1, space.y1)].map(Point::from);
                assert!(corners.iter().all(|corner| outline.contains(*corner)));
                assert!(LEAST <= label.style.size_pt);
            }
        }
    }

    #[test]
    fn a_segment_through_a_corner_is_seen() {
        let field = [(-50.0, -50.0), (50.0, -50.0), (50.0, 50.0), (-50.0, 50.0)];
        let is_free = |from: [f64; 2], to: [f64; 2]| {
            let outline = Polygon::new(field.map(Point::from));
            let lines = Lines {
                bounds: outline.bounds(),
                outline,
                segments: vec![[from.into(), to.into()].map(|(x, y)| Point::new(x, y))],
                words: Vec::new(),
            };
            lines.leave_free(Rect::new(0.0, 0.0, 10.0, 10.0))
        };
        assert!(!is_free([-1.0, 2.0], [2.0, -1.0]));
        assert!(!is_free([-5.0, 5.0], [15.0, 6.0]));
        assert!(!is_free([4.0, 4.0], [5.0, 4.0]));
        assert!(is_free([-5.0, 2.0], [2.0, -5.0]));
    }
}
