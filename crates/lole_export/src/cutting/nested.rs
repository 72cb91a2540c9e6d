//! One pattern in several sizes on one page: of every piece all sizes around one another, as they were drafted.

use kurbo::{Affine, Point, Rect as Bounds};
use lole_body::Measure;
use lole_costume::order::DancerPlan;
use lole_language::{Language, Sentence, Words, capitalized};
use lole_pattern::piece::{Drawing, Finish, Piece};

use super::draw::{PLACE_ON_FOLD, arrow, fold_stroke, line, notch_places, outline};
use super::{CutGarment, MM, TOLERANCE, cut_words};
use crate::pdf::{Align, Layer, LayeredSheet, Rect, Sheet, Stroke, TextStyle};

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

/// Why a garment is not nested.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotNested {
    /// All of it is cut by ruler and chalk, to the figures of its own sheet.
    Rectangles,
    /// It has other pieces in the size of this name.
    Differs(String),
    /// The piece of this name is wider than the page in some size.
    TooWide(Words),
}

impl NotNested {
    /// The sentence about a garment.
    #[must_use]
    pub fn sentence(&self, garment: Words) -> Sentence {
        let (japanese, english) = match self {
            Self::Rectangles => (
                "長方形だけなので、サイズを重ねた型紙はありません。裁つ寸法の紙を使います".to_owned(),
                "it is cut from rectangles alone, so there is nothing to nest; its sheet of cut sizes has the figures"
                    .to_owned(),
            ),
            Self::Differs(size) => (
                format!("サイズ {size} は型紙の枚数か種類がちがうので、重ねられません。分けて書き出してください"),
                format!("size {size} has other pieces, so the sizes are not nested; write that size by itself"),
            ),
            Self::TooWide(piece) => (
                format!("{}が 914 mm の紙より広いサイズがあり、重ねられません。大きいサイズを分けてください", piece.japanese),
                format!(
                    "the {} is wider than paper of 914 mm in some size, so the sizes are not nested; leave the largest out",
                    piece.english
                ),
            ),
        };
        Sentence::new(
            format!("{}: {japanese}", garment.japanese),
            format!("{}: {english}", garment.english),
        )
    }
}

/// A garment of one design in several sizes, each a plan under its name, on one page.
///
/// # Errors
///
/// [`NotNested`]: it has no pieces of a shape, other ones in another size, or one is wider than the page.
pub fn nested_sheet(
    sizes: &[DancerPlan],
    garment: usize,
    language: Language,
) -> Result<LayeredSheet, NotNested> {
    let first = sizes.first().and_then(|size| size.garments.get(garment));
    let first = first.ok_or(NotNested::Rectangles)?;
    let cut = CutGarment::of(first);
    let shaped: Vec<usize> = (0..cut.garment.cutting().pieces.len())
        .filter(|&index| {
            let piece = &cut.garment.cutting().pieces[index];
            piece.rectangle(TOLERANCE).is_none()
        })
        .collect();
    if shaped.is_empty() {
        return Err(NotNested::Rectangles);
    }
    let nests: Result<Vec<Nest<'_>>, NotNested> = (shaped.iter())
        .map(|&index| Nest::of(sizes, garment, index))
        .collect();
    let nests = nests?;
    let bounds: Vec<Bounds> = nests.iter().map(Nest::bounds).collect();
    let wide = |index: usize| NotNested::TooWide(nests[index].piece.name);
    let (corners, height) = shelves(&bounds).map_err(wide)?;
    let mut sheet = Sheet::new([WIDTH, height]);
    draw_chart(&mut sheet, (&cut, sizes), language);
    let mut by_size = vec![Sheet::new(sheet.size); sizes.len()];
    for (nest, (bounds, corner)) in nests.iter().zip(bounds.iter().zip(corners)) {
        // The upper left corner of the largest comes to lie there.
        let page = Affine::translate((corner.x, corner.y))
            * Affine::scale_non_uniform(MM, -MM)
            * Affine::translate((-bounds.x0, -bounds.y1));
        nest.draw_sizes(&mut by_size, page);
        nest.draw(&mut sheet, page, (&cut, language));
    }
    let layers = sizes.iter().zip(by_size).map(|(size, sheet)| Layer {
        name: size.name.clone(),
        items: sheet.items,
    });
    Ok(LayeredSheet {
        base: sheet,
        layers: layers.collect(),
    })
}

/// One piece in all sizes.
struct Nest<'a> {
    piece: &'a Piece,
    drawings: Vec<(&'a str, Drawing)>,
}

impl<'a> Nest<'a> {
    /// [`NotNested::Differs`] where a size has no such piece.
    fn of(sizes: &'a [DancerPlan], garment: usize, index: usize) -> Result<Self, NotNested> {
        let pieces = |size: &'a DancerPlan| {
            let pieces = &size.garments.get(garment)?.tailored.cutting().pieces;
            pieces.get(index)
        };
        let piece = sizes.first().and_then(pieces);
        let piece = piece.ok_or(NotNested::Rectangles)?;
        let drawings: Result<Vec<(&str, Drawing)>, NotNested> = (sizes.iter())
            .map(|size| {
                let own = pieces(size).filter(|own| own.id == piece.id);
                let own = own.ok_or_else(|| NotNested::Differs(size.name.clone()))?;
                Ok((size.name.as_str(), own.drawing(TOLERANCE)))
            })
            .collect();
        let drawings = drawings?;
        Ok(Self { piece, drawings })
    }

    fn bounds(&self) -> Bounds {
        let all = self
            .drawings
            .iter()
            .map(|(_, drawing)| drawing.cut.bounds());
        all.reduce(|one, other| one.union(other))
            .unwrap_or_default()
    }

    /// The lines of each size on a layer of its own.
    fn draw_sizes(&self, layers: &mut [Sheet], page: Affine) {
        let small = TextStyle::bold(7.5);
        let sizes = self.drawings.iter().zip(layers);
        for (index, ((name, drawing), sheet)) in sizes.enumerate() {
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
    }

    /// What all sizes have in common: grain, fold and words.
    fn draw(&self, sheet: &mut Sheet, page: Affine, (cut, language): (&CutGarment, Language)) {
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
/// or the first that is wider than it.
fn shelves(bounds: &[Bounds]) -> Result<(Vec<Point>, f64), usize> {
    let room = WIDTH - 2.0 * MARGIN;
    let mut order: Vec<usize> = (0..bounds.len()).collect();
    order.sort_by(|&a, &b| bounds[b].height().total_cmp(&bounds[a].height()));
    let mut corners = vec![Point::ZERO; bounds.len()];
    let (mut x, mut top, mut high) = (0.0, HEAD, 0.0_f64);
    for index in order {
        let [wide, tall] = [bounds[index].width(), bounds[index].height()].map(|side| side * MM);
        if room < wide {
            return Err(index);
        }
        if room < x + wide {
            (x, top, high) = (0.0, top + high + GAP, 0.0);
        }
        corners[index] = Point::new(MARGIN + x, top);
        x += wide + GAP;
        high = high.max(tall);
    }
    Ok((corners, top + high + MARGIN))
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
            let chart = size_chart::chart("jis").expect("a chart");
            let sizes: Vec<DancerPlan> = (chart.dancers.iter())
                .map(|size| order::plan(size, &design).unwrap_or_else(|error| panic!("{error}")))
                .collect();
            let sheet = nested_sheet(&sizes, 0, Language::English);
            let sheet = sheet
                .unwrap_or_else(|error| panic!("{kind}: {error:?}"))
                .flat();
            let count = |name: &str| sheet.texts().iter().filter(|text| **text == name).count();
            let pieces = sizes[0].garments[0].tailored.cutting().pieces.iter();
            let shaped = pieces
                .filter(|piece| piece.rectangle(TOLERANCE).is_none())
                .count();
            for size in &sizes {
                // Once for each piece, and once in the chart.
                assert_eq!(count(&size.name), shaped + 1, "{kind} {}", size.name);
            }
            let nest = Nest::of(&sizes, 0, 0).unwrap_or_else(|error| panic!("{kind}: {error:?}"));
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

    /// What cannot be nested says why, in one sentence about the garment and its piece.
    #[test]
    fn what_is_not_nested_says_why() {
        let chart = size_chart::chart("jis").expect("a chart");
        let plan = |size, kind: &str| {
            let mut design = Design::default();
            design.skirt.is_worn = kind.is_empty();
            design.garments = GarmentDesign::of_kind(kind).into_iter().collect();
            order::plan(size, &design).unwrap_or_else(|error| panic!("{error}"))
        };
        let [small, large] = [&chart.dancers[0], &chart.dancers[1]];
        let skirts = [plan(small, ""), plan(large, "")];
        let why = nested_sheet(&skirts, 0, Language::English).err();
        assert_eq!(why, Some(NotNested::Rectangles));
        let mixed = [plan(small, "blouse"), plan(large, "muumuu")];
        let why = nested_sheet(&mixed, 0, Language::English).err();
        assert_eq!(why, Some(NotNested::Differs(large.name.clone())));
        let boxes = [0.5, 1.0].map(|wide| Bounds::new(0.0, 0.0, wide, 0.2));
        assert_eq!(shelves(&boxes).err(), Some(1));
        let name = skirts[0].garments[0].tailored.name;
        for why in [NotNested::Rectangles, NotNested::TooWide(name)] {
            let said = why.sentence(name).to_string();
            assert!(said.starts_with(&format!("{}: ", name.english)), "{said}");
        }
    }
}
