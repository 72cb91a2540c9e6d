//! Pages filled from top to bottom.

use super::sheet::{Align, EncodedPicture, Rect, Sheet, TextStyle, baseline};

/// Empty borders of a page [mm].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// At the left and at the right.
    pub side: f64,
    /// Above the first line.
    pub top: f64,
    /// Below the last line; the page's number stands in it.
    pub bottom: f64,
}

impl Default for Margins {
    /// Wide enough for the holes of a binder and for every printer.
    fn default() -> Self {
        Self {
            side: 20.0,
            top: 18.0,
            bottom: 20.0,
        }
    }
}

/// A cursor that goes down pages and begins new ones.
#[derive(Debug, Clone)]
pub struct Flow {
    size: [f64; 2],
    margins: Margins,
    sheets: Vec<Sheet>,
    y: f64,
}

impl Flow {
    /// Begins at the top of a first page of this size [mm].
    #[must_use]
    pub fn new(size: [f64; 2], margins: Margins) -> Self {
        Self {
            size,
            margins,
            sheets: vec![Sheet::new(size)],
            y: margins.top,
        }
    }

    /// Left edge of the text [mm].
    #[must_use]
    pub const fn left(&self) -> f64 {
        self.margins.side
    }

    /// Width of the text [mm].
    #[must_use]
    pub fn width(&self) -> f64 {
        self.size[0] - 2.0 * self.margins.side
    }

    /// Where the next thing stands, from the page's top [mm].
    #[must_use]
    pub const fn y(&self) -> f64 {
        self.y
    }

    /// Height left on this page [mm].
    #[must_use]
    pub fn left_over(&self) -> f64 {
        self.size[1] - self.margins.bottom - self.y
    }

    /// Height of the text of a whole page [mm].
    #[must_use]
    pub fn page_height(&self) -> f64 {
        self.size[1] - self.margins.bottom - self.margins.top
    }

    /// The page that is being filled.
    pub fn sheet(&mut self) -> &mut Sheet {
        if self.sheets.is_empty() {
            self.sheets.push(Sheet::new(self.size));
        }
        let last = self.sheets.len() - 1;
        &mut self.sheets[last]
    }

    /// Begins a new page, unless this one is still empty.
    pub fn new_page(&mut self) {
        if !self.sheet().items.is_empty() {
            self.sheets.push(Sheet::new(self.size));
        }
        self.y = self.margins.top;
    }

    /// Leaves room [mm]; nothing at the top of a page.
    pub fn space(&mut self, height: f64) {
        if self.margins.top < self.y {
            self.y += height;
        }
    }

    /// Begins a new page where less than `height` [mm] is left, so that what follows stays together.
    pub fn keep(&mut self, height: f64) {
        if self.left_over() < height {
            self.new_page();
        }
    }

    /// Writes a paragraph over the whole width, from page to page where it must be.
    pub fn paragraph(&mut self, text: &str, style: &TextStyle) {
        self.indented(0.0, text, style);
    }

    /// Writes a paragraph that begins `indent` [mm] to the right.
    pub fn indented(&mut self, indent: f64, text: &str, style: &TextStyle) {
        for line in style.wrap(text, self.width() - indent) {
            self.keep(style.line_height());
            let at = [self.left() + indent, self.y + baseline(style)];
            self.sheet().text(at, &line, style, Align::Left);
            self.y += style.line_height();
        }
    }

    /// Writes an item of a list: `label`, and the text beside it.
    pub fn item(&mut self, label: &str, indent: f64, text: &str, style: &TextStyle) {
        self.keep(style.line_height());
        let at = [self.left(), self.y + baseline(style)];
        self.sheet().text(at, label, style, Align::Left);
        self.indented(indent, text, style);
    }

    /// Reserves a place over the whole width, on one page, and gives it to `draw`.
    pub fn block(&mut self, height: f64, draw: impl FnOnce(&mut Sheet, Rect)) {
        self.keep(height);
        let rect = Rect {
            x: self.left(),
            y: self.y,
            width: self.width(),
            height,
        };
        draw(self.sheet(), rect);
        self.y += height;
    }

    /// Shows a picture as wide as the text, or smaller where it would be higher than `height` [mm].
    pub fn picture(&mut self, picture: &EncodedPicture, height: f64) {
        let full = self.width() * f64::from(picture.height) / f64::from(picture.width);
        self.block(full.min(height), |sheet, rect| {
            sheet.picture(rect, picture);
        });
    }

    /// The pages, numbered so far from their right and their lower edge [mm].
    pub(crate) fn numbered(self, [right, bottom]: [f64; 2]) -> Vec<Sheet> {
        self.finish(|sheet, number, count| {
            let [width, height] = sheet.size;
            let at = [width - right, height - bottom];
            let text = format!("{number} / {count}");
            sheet.text(at, &text, &TextStyle::regular(9.0), Align::Right);
        })
    }

    /// The pages. `foot` draws on each of them, given its number from 1 and how many there are.
    #[must_use]
    pub fn finish(mut self, mut foot: impl FnMut(&mut Sheet, usize, usize)) -> Vec<Sheet> {
        let count = self.sheets.len();
        for (index, sheet) in self.sheets.iter_mut().enumerate() {
            foot(sheet, index + 1, count);
        }
        self.sheets
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pdf::{Item, Paper};

    #[test]
    fn text_stays_between_the_margins_and_goes_on_overleaf() {
        let margins = Margins::default();
        let mut flow = Flow::new(Paper::A4.size_mm(), margins);
        let style = TextStyle::body();
        for _ in 0..80 {
            flow.paragraph("布を裁つ前に、型紙の寸法をもう一度はかります。", &style);
        }
        let sheets = flow.finish(|_, _, _| {});
        assert_eq!(sheets.len(), 3);
        for item in sheets.iter().flat_map(|sheet| &sheet.items) {
            let Item::Text { at, .. } = item else {
                unreachable!("only text was written")
            };
            assert!(
                margins.top < at[1] && at[1] < 297.0 - margins.bottom,
                "{at:?}"
            );
        }
    }

    #[test]
    fn a_block_is_never_torn() {
        let mut flow = Flow::new(Paper::A4.size_mm(), Margins::default());
        for _ in 0..5 {
            flow.block(150.0, |_, rect| assert!(rect.y + rect.height <= 277.0));
            flow.sheet()
                .line([0.0, 0.0], [1.0, 1.0], super::super::Stroke::solid(0.1));
        }
        let mut numbers = Vec::new();
        let sheets = flow.finish(|_, number, count| numbers.push((number, count)));
        assert_eq!(sheets.len(), 5);
        assert_eq!(numbers[4], (5, 5));
    }
}
