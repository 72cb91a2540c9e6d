//! One pattern in several sizes on one page: of every piece all sizes around one another, as they were drafted.

use kurbo::{Affine, Point, Rect as Bounds};
use lole_body::Measure;
use lole_costume::order::DancerPlan;
use lole_language::{Language, capitalized};
use lole_pattern::piece::{Drawing, Finish, Piece};

use super::draw::{PLACE_ON_FOLD, arrow, fold_stroke, line, notch_places, outline};
use super::{CutGarment, MM, TOLERANCE, cut_words};
use crate::pdf::{Align, Rect, Sheet, Stroke, TextStyle};

/// Width of the page [mm]: a roll of 36 inches.
const WIDTH: f64 = 914.4;
/// Not printed on at its sides, and between pieces [mm].
const MARGIN: f64 = 12.0;
const GAP: f64 = 14.0;
/// Room for the chart of sizes at the upper end [mm].
const HEAD: f64 = 122.0;
/// Most sizes: lines of more cannot be told apart.
pub const MOST_SIZES: usize = 9;

/// Dashes of the sizes' lines in their order [mm], the same again after the last.
const DASHES: [&[f64]; 5] = [
    &[],
    &[8.0, 3.0],
    &[2.0, 2.0],
    &[10.0, 2.0, 2.0, 2.0],
    &[10.0, 2.0, 2.0, 2.0, 2.0, 2.0],
];

/// A garment of one design in several sizes, each a plan under its name, on one page; `None` where it has no
/// pieces of a shape, or where one is wider than the page.
#[must_use]
pub fn nested_sheet(sizes: &[DancerPlan], garment: usize, language: Language) -> Option<Sheet> {
    let first = sizes.first()?.garments.get(garment)?;
    let cut = CutGarment::of(first);
    let shaped: Vec<usize> = (0..cut.garment.cutting().pieces.len())
        .filter(|&index| {
            let piece = &cut.garment.cutting().pieces[index];
            piece.drawing(TOLERANCE).rectangle.is_none()
        })
        .collect();
    if shaped.is_empty() {
        return None;
    }
    let nests: Option<Vec<Nest<'_>>> = (shaped.iter())
        .map(|&index| Nest::of(sizes, garment, index))
        .collect();
    let nests = nests?;
    let bounds: Vec<Bounds> = nests.iter().map(Nest::bounds).collect();
    let (corners, height) = shelves(&bounds)?;
    let mut sheet = Sheet::new([WIDTH, height]);
    draw_chart(&mut sheet, (&cut, sizes), language);
    for (nest, (bounds, corner)) in nests.iter().zip(bounds.iter().zip(corners)) {
        // The upper left corner of the largest comes to lie there.
        let page = Affine::translate((corner.x, corner.y))
            * Affine::scale_non_uniform(MM, -MM)
            * Affine::translate((-bounds.x0, -bounds.y1));
        nest.draw(&mut sheet, page, (&cut, language));
    }
    Some(sheet)
}

/// One piece in all sizes.
struct Nest<'a> {
    piece: &'a Piece,
    drawings: Vec<(&'a str, Drawing)>,
}

impl<'a> Nest<'a> {
    /// `None` where a size has no such piece.
    fn of(sizes: &'a [DancerPlan], garment: usize, index: usize) -> Option<Self> {
        let pieces = |size: &'a DancerPlan| {
            let pieces = &size.garments.get(garment)?.tailored.cutting().pieces;
            pieces.get(index)
        };
        let piece = pieces(sizes.first()?)?;
        let drawings: Option<Vec<(&str, Drawing)>> = (sizes.iter())
            .map(|size| {
                let own = pieces(size).filter(|own| own.id == piece.id)?;
                Some((size.name.as_str(), own.drawing(TOLERANCE)))
            })
            .collect();
        let drawings = drawings?;
        Some(Self { piece, drawings })
    }

    fn bounds(&self) -> Bounds {
        let all = self
            .drawings
            .iter()
            .map(|(_, drawing)| drawing.cut.bounds());
        all.reduce(|one, other| one.union(other))
            .unwrap_or_default()
    }

    fn draw(&self, sheet: &mut Sheet, page: Affine, (cut, language): (&CutGarment, Language)) {
        let small = TextStyle::bold(7.5);
        for (index, (name, drawing)) in self.drawings.iter().enumerate() {
            sheet.path(outline(&drawing.cut, page), None, Some(stroke(index)));
            for marked in &drawing.lines {
                sheet.path(
                    line(&marked.points, page),
                    None,
                    Some(Stroke {
                        width: 0.2,
                        ..stroke(index)
                    }),
                );
            }
            for notch in &drawing.notches {
                let at = page * notch.at;
                let inward = page * (notch.at + notch.inward) - at;
                let inward = inward / inward.hypot().max(1e-9);
                let side = kurbo::Vec2::new(-inward.y, inward.x) * 2.0;
                for place in notch_places(notch) {
                    let from = at + side * *place;
                    let to = from + inward * 5.0;
                    sheet.line([from.x, from.y], [to.x, to.y], Stroke::solid(0.35));
                }
            }
            // Each line is named where it turns farthest to the lower right.
            let lowest = drawing.cut.points.iter().map(|point| page * *point);
            let corner = lowest.max_by(|a, b| (a.x + a.y).total_cmp(&(b.x + b.y)));
            if let Some(at) = corner {
                // Neighbors stand on two levels, so that their names do not run into each other.
                let level = if index % 2 == 0 { 3.0 } else { 6.2 };
                sheet.text([at.x + 0.5, at.y + level], name, &small, Align::Left);
            }
        }
        let Some((_, first)) = self.drawings.first() else {
            return;
        };
        let grain = first.grain.map(|end| page * end);
        arrow(sheet, grain, &Stroke::solid(0.35));
        let label = page * first.label;
        let is_half = first
            .stitches
            .iter()
            .any(|edge| edge.finish == Finish::Fold);
        let fold = if is_half {
            language.pick("（わ）", " on fold")
        } else {
            ""
        };
        let words = [
            capitalized(self.piece.name.text(language)),
            cut.title(language),
            format!("{}{fold}", cut_words(self.piece, language)),
        ];
        say_fold(sheet, (first, page), language);
        let style = TextStyle::bold(14.0);
        for (row, words) in (0_u32..).zip(&words) {
            let y = label.y + style.line_height() * (f64::from(row) - 3.0);
            // Beside the arrow, which stands upright.
            sheet.text([label.x + 4.0, y], words, &style, Align::Left);
        }
    }
}

/// Says along the edge on a fold that the other half is cut with it.
fn say_fold(sheet: &mut Sheet, (drawing, page): (&Drawing, Affine), language: Language) {
    let folds = drawing.stitches.iter();
    for fold in folds.filter(|edge| edge.finish == Finish::Fold) {
        if let [from, .., to] = fold.points[..] {
            let path = line(&fold.points, page);
            sheet.path(path, None, Some(fold_stroke()));
            let at = page * from.midpoint(to) + kurbo::Vec2::new(6.0, 0.0);
            let words = PLACE_ON_FOLD.text(language);
            let upright = core::f64::consts::FRAC_PI_2;
            sheet.turned_text([at.x, at.y], upright, words, &TextStyle::bold(12.0));
        }
    }
}

/// The line of a size.
fn stroke(index: usize) -> Stroke {
    Stroke {
        dashes: DASHES[index % DASHES.len()].to_vec(),
        ..Stroke::solid(if index < DASHES.len() { 0.5 } else { 0.9 })
    }
}

/// Where the upper left corners of boxes come to lie, the tallest first, row by row, and the height of the page;
/// `None` where one is wider than it.
fn shelves(bounds: &[Bounds]) -> Option<(Vec<Point>, f64)> {
    let room = WIDTH - 2.0 * MARGIN;
    let mut order: Vec<usize> = (0..bounds.len()).collect();
    order.sort_by(|&a, &b| bounds[b].height().total_cmp(&bounds[a].height()));
    let mut corners = vec![Point::ZERO; bounds.len()];
    let (mut x, mut top, mut high) = (0.0, HEAD, 0.0_f64);
    for index in order {
        let [wide, tall] = [bounds[index].width(), bounds[index].height()].map(|side| side * MM);
        if room < wide {
            return None;
        }
        if room < x + wide {
            (x, top, high) = (0.0, top + high + GAP, 0.0);
        }
        corners[index] = Point::new(MARGIN + x, top);
        x += wide + GAP;
        high = high.max(tall);
    }
    Some((corners, top + high + MARGIN))
}

/// What it is, a square to measure, and the sizes with their lines and girths.
fn draw_chart(sheet: &mut Sheet, (cut, sizes): (&CutGarment, &[DancerPlan]), language: Language) {
    let square = Rect {
        x: MARGIN,
        y: MARGIN,
        width: 100.0,
        height: 100.0,
    };
    sheet.rect(square, None, Some(Stroke::solid(0.3)));
    let said = language.pick("この四角は 10 cm × 10 cm", "this square is 10 cm × 10 cm");
    sheet.text(
        [MARGIN + 50.0, MARGIN + 50.0],
        said,
        &TextStyle::bold(14.0),
        Align::Center,
    );
    let left = MARGIN + 112.0;
    let title = cut.title(language);
    sheet.text(
        [left, MARGIN + 10.0],
        &title,
        &TextStyle::bold(26.0),
        Align::Left,
    );
    let columns = [
        Measure::Stature,
        Measure::Bust,
        Measure::Waist,
        Measure::Hip,
    ];
    let place = |column: usize| left + 70.0 + 34.0 * column as f64;
    let head = TextStyle::bold(12.0);
    for (column, measure) in columns.iter().enumerate() {
        let name = capitalized(measure.words().text(language));
        sheet.text([place(column), MARGIN + 20.0], &name, &head, Align::Left);
    }
    for (index, size) in sizes.iter().enumerate() {
        let y = MARGIN + 28.0 + 8.0 * index as f64;
        sheet.line([left, y - 1.5], [left + 34.0, y - 1.5], stroke(index));
        sheet.text([left + 38.0, y], &size.name, &head, Align::Left);
        for (column, measure) in columns.iter().enumerate() {
            let taped = size.tape_cm.iter().find(|(taped, _)| taped == measure);
            if let Some((_, cm)) = taped {
                let text = format!("{cm:.0} cm");
                sheet.text(
                    [place(column), y],
                    &text,
                    &TextStyle::regular(12.0),
                    Align::Left,
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_costume::document::{Design, GarmentDesign};
    use lole_costume::order;
    use lole_costume::size_chart;

    /// All sizes of every piece are there, named, on the page, and larger sizes are larger.
    #[test]
    fn every_piece_is_there_in_every_size() {
        for kind in ["blouse", "muumuu"] {
            let mut design = Design::default();
            design.skirt.is_worn = false;
            design.garments = GarmentDesign::of_kind(kind).into_iter().collect();
            let sizes: Vec<DancerPlan> = (size_chart::jis().dancers.iter())
                .map(|size| order::plan(size, &design).unwrap_or_else(|error| panic!("{error}")))
                .collect();
            let sheet = nested_sheet(&sizes, 0, Language::English);
            let sheet = sheet.unwrap_or_else(|| panic!("{kind}"));
            let count = |name: &str| sheet.texts().iter().filter(|text| **text == name).count();
            let pieces = sizes[0].garments[0].tailored.cutting().pieces.iter();
            let shaped = pieces
                .filter(|piece| piece.drawing(TOLERANCE).rectangle.is_none())
                .count();
            for size in &sizes {
                // Once for each piece, and once in the chart.
                assert_eq!(count(&size.name), shaped + 1, "{kind} {}", size.name);
            }
            let nest = Nest::of(&sizes, 0, 0).unwrap_or_else(|| panic!("{kind}"));
            let areas: Vec<f64> = nest
                .drawings
                .iter()
                .map(|(_, drawing)| drawing.cut.signed_area())
                .collect();
            assert!(areas.windows(2).all(|pair| pair[0] < pair[1]), "{areas:?}");
            for item in &sheet.items {
                if let crate::pdf::Item::Path { path, .. } = item {
                    let bounds = kurbo::Shape::bounding_box(path);
                    let [width, height] = sheet.size;
                    assert!(
                        0.0 <= bounds.x0 && bounds.x1 <= width && bounds.y1 <= height,
                        "{bounds:?}"
                    );
                }
            }
        }
    }
}
