//! A page for pen plotters and cutters: HP-GL, which they have read since 1976.
//!
//! Units are fortieths of a millimeter from the lower left corner. Pen 1 draws what is cut, pen 2 everything else, so
//! that a cutter can be told to cut with the first alone. Lines are as long as they are drawn, dashes one by one;
//! fills and pictures are left out. Letters are the plotter's own, in ASCII: macrons and ʻokina are left out, what
//! else it lacks becomes `?`.

use kurbo::{Affine, BezPath, PathEl, Point};

use crate::dxf::plain;
use crate::pdf::{Item, LayeredSheet};

/// Units of a millimeter.
const UNITS: f64 = 40.0;
/// Curves become lines this close to them [mm].
const TOLERANCE: f64 = 0.02;
/// Thinner lines are no cutting lines [mm].
const CUT_WIDTH: f64 = 0.45;
/// Height and width of a capital over the size of its letters.
const LETTER: [f64; 2] = [0.7, 0.5];
/// Centimeters of a point.
const CM_OF_PT: f64 = 2.54 / 72.0;
/// Ends the text of a label.
const END: char = '\u{3}';

/// A page with all of its layers, as bytes.
pub(crate) fn plotter_file(sheet: &LayeredSheet) -> Vec<u8> {
    let mut plot = Plot {
        text: format!("IN;DT{END};"),
        height: sheet.base.size[1],
        pen: 0,
    };
    let layers = sheet.layers.iter().flat_map(|layer| &layer.items);
    for item in sheet.base.items.iter().chain(layers) {
        plot.item(item, Affine::IDENTITY);
    }
    plot.text.push_str("PU;SP0;");
    plot.text.into_bytes()
}

struct Plot {
    text: String,
    /// Of the page [mm].
    height: f64,
    pen: u8,
}

impl Plot {
    fn item(&mut self, item: &Item, page: Affine) {
        match item {
            Item::Path {
                path,
                stroke: Some(stroke),
                ..
            } => {
                let is_cut = stroke.dashes.is_empty() && CUT_WIDTH <= stroke.width;
                self.take(if is_cut { 1 } else { 2 });
                if stroke.dashes.is_empty() {
                    self.line(path, page);
                } else {
                    let dashed = kurbo::dash(path.iter(), 0.0, &stroke.dashes);
                    self.line(&dashed.collect(), page);
                }
            }
            Item::Text { at, text, style } => self.label((*at, text, style.size_pt), page),
            Item::Group {
                page_from_group,
                items,
                ..
            } => {
                for item in items.iter() {
                    self.item(item, page * *page_from_group);
                }
            }
            Item::Path { stroke: None, .. } | Item::Picture { .. } => {}
        }
    }

    fn take(&mut self, pen: u8) {
        if self.pen != pen {
            self.pen = pen;
            self.text.push_str(&format!("PU;SP{pen};"));
        }
    }

    /// Where a point of the page is for the plotter.
    fn place(&self, at: Point) -> String {
        let [x, y] = [at.x, self.height - at.y].map(|along| (UNITS * along).round() + 0.0);
        format!("{x},{y}")
    }

    fn line(&mut self, path: &BezPath, page: Affine) {
        let mut start = Point::ZERO;
        kurbo::flatten(page * path.clone(), TOLERANCE, |element| match element {
            PathEl::MoveTo(at) => {
                start = at;
                self.text.push_str(&format!("PU{};", self.place(at)));
            }
            PathEl::LineTo(at) => self.text.push_str(&format!("PD{};", self.place(at))),
            PathEl::ClosePath => self.text.push_str(&format!("PD{};", self.place(start))),
            PathEl::QuadTo(..) | PathEl::CurveTo(..) => {}
        });
    }

    /// Words from the left end of their baseline.
    fn label(&mut self, (at, text, size_pt): ([f64; 2], &str, f64), page: Affine) {
        self.take(2);
        let from = page * Point::new(at[0], at[1]);
        let along = page * Point::new(at[0] + 1.0, at[1]) - from;
        let [high, wide] = LETTER.map(|share| share * size_pt * CM_OF_PT);
        let (place, said) = (self.place(from), plain(text));
        // On the page down is what is up on the plotter.
        self.text.push_str(&format!(
            "PU{place};DI{:.4},{:.4};SI{wide:.3},{high:.3};LB{said}{END};",
            along.x + 0.0,
            0.0 - along.y
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pdf::{Align, Layer, Sheet, Stroke, TextStyle};

    #[test]
    fn a_square_is_as_large_as_it_is_and_words_are_ascii() {
        let mut sheet = Sheet::new([200.0, 300.0]);
        let square = kurbo::Rect::new(10.0, 20.0, 110.0, 120.0);
        let path = kurbo::Shape::to_path(&square, 0.1);
        sheet.path(path.clone(), None, Some(Stroke::solid(0.5)));
        sheet.text(
            [10.0, 20.0],
            "pāʻū; 花",
            &TextStyle::regular(10.0),
            Align::Left,
        );
        let mut dashed = Sheet::new([0.0, 0.0]);
        dashed.path(path, None, Some(Stroke::dashed(0.3, 3.0)));
        let layer = Layer {
            name: "sewing".to_owned(),
            items: dashed.items,
        };
        let file = plotter_file(&LayeredSheet {
            base: sheet,
            layers: vec![layer],
        });
        let text = String::from_utf8(file).unwrap();
        assert!(text.is_ascii() && text.starts_with("IN;"));
        assert!(text.contains("SP1;PU400,11200;PD4400,11200;PD4400,7200;PD400,7200;PD400,11200;"));
        assert!(text.contains("LBpau; ?\u{3};"));
        // Nothing leaves the page, and dashes are many short strokes of the second pen.
        let (_, second) = text.split_once("SP2;").unwrap();
        assert!(40 < second.matches("PU").count());
        for command in text.split(';') {
            let Some(place) = command.strip_prefix("PU").or(command.strip_prefix("PD")) else {
                continue;
            };
            let Some((x, y)) = place.split_once(',') else {
                continue;
            };
            let [x, y]: [f64; 2] = [x, y].map(|along| along.parse().unwrap());
            assert!((400.0..=4400.0).contains(&x) && (7200.0..=11200.0).contains(&y));
        }
    }
}
