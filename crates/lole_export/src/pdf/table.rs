//! Tables: columns of given width, rows as high as their text, heads repeated on every page.

use super::flow::Flow;
use super::sheet::{Align, Color, Rect, Sheet, Stroke, TextStyle, baseline};

/// Between a cell's edge and its text [mm].
const PADDING: [f64; 2] = [2.0, 1.2];

/// Behind the head.
const HEAD: Color = Color(233, 240, 240);

/// Between rows.
const RULE: Color = Color(170, 170, 170);

/// A column of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its head.
    pub head: String,
    /// Its part of the width, in proportion to the other columns' parts.
    pub share: f64,
    /// Where its text stands; numbers stand at the right.
    pub align: Align,
}

impl Column {
    /// A column of text.
    pub fn text(head: impl Into<String>, share: f64) -> Self {
        Self {
            head: head.into(),
            share,
            align: Align::Left,
        }
    }

    /// A column of numbers.
    pub fn number(head: impl Into<String>, share: f64) -> Self {
        Self {
            align: Align::Right,
            ..Self::text(head, share)
        }
    }
}

/// What stands in one row of one column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    /// The text.
    pub text: String,
    /// Whether it is set in bold, as sums are.
    pub is_bold: bool,
}

impl Cell {
    /// Bold text.
    pub fn bold(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            is_bold: true,
        }
    }
}

impl<T: Into<String>> From<T> for Cell {
    fn from(text: T) -> Self {
        Self {
            text: text.into(),
            is_bold: false,
        }
    }
}

/// A table.
#[derive(Debug, Clone, PartialEq)]
pub struct PageTable {
    /// Its columns. Heads are drawn unless all are empty.
    pub columns: Vec<Column>,
    /// Its rows; a missing cell is empty. A row whose first cell is empty goes on with the one above it,
    /// and stays on its page where there is room.
    pub rows: Vec<Vec<Cell>>,
    /// Size of its letters [pt].
    pub size_pt: f64,
}

impl PageTable {
    /// Draws the table down the pages.
    pub fn draw(&self, flow: &mut Flow) {
        let head = self.head();
        let head_height = self.head_height(flow.width());
        let mut page_is_new = true;
        for (index, row) in self.rows.iter().enumerate() {
            let height = self.row_height(row, flow.width());
            let together = self.height_together(index, flow.width());
            let heads = if page_is_new { head_height } else { 0.0 };
            // What no page has room for breaks where it must.
            let wanted = if heads + together <= flow.page_height() {
                together
            } else {
                height
            };
            if flow.left_over() < heads + wanted {
                flow.new_page();
                page_is_new = true;
            }
            if let Some(head) = head.as_ref().filter(|_| page_is_new) {
                flow.block(head_height, |sheet, rect| {
                    sheet.rect(rect, Some(HEAD), None);
                    self.draw_row(head, sheet, rect);
                    self.draw_rule(sheet, rect, 0);
                });
            }
            page_is_new = false;
            let beside = usize::from(self.goes_on(index + 1));
            flow.block(height, |sheet, rect| {
                self.draw_row(row, sheet, rect);
                self.draw_rule(sheet, rect, beside);
            });
        }
    }

    /// Whether a row goes on with the one above it.
    fn goes_on(&self, row: usize) -> bool {
        let row = self.rows.get(row);
        row.is_some_and(|row| row.first().is_some_and(|cell| cell.text.is_empty()))
    }

    /// Height of a row and of what goes on with it [mm].
    fn height_together(&self, row: usize, width: f64) -> f64 {
        let rest = (row + 1..).take_while(|&next| self.goes_on(next));
        let rows = std::iter::once(row).chain(rest);
        rows.map(|row| self.row_height(&self.rows[row], width))
            .sum()
    }

    /// Height of the heads and of the first row with what goes on with it [mm]: what a title keeps below it.
    #[must_use]
    pub fn beginning(&self, width: f64) -> f64 {
        let first = if self.rows.is_empty() {
            0.0
        } else {
            self.height_together(0, width)
        };
        first + self.head_height(width)
    }

    /// Heads of the columns, unless all are empty.
    fn head(&self) -> Option<Vec<Cell>> {
        let heads = self.columns.iter();
        let heads: Vec<Cell> = heads
            .map(|column| Cell::bold(column.head.clone()))
            .collect();
        let has_text = heads.iter().any(|cell| !cell.text.is_empty());
        has_text.then_some(heads)
    }

    fn head_height(&self, width: f64) -> f64 {
        let head = self.head();
        head.map_or(0.0, |head| self.row_height(&head, width))
    }

    /// Height on a page of this width of text [mm], when it fits onto one.
    #[must_use]
    pub fn height(&self, width: f64) -> f64 {
        let rows = self.rows.iter();
        let rows: f64 = rows.map(|row| self.row_height(row, width)).sum();
        rows + self.head_height(width)
    }

    const fn style(&self, cell: &Cell) -> TextStyle {
        if cell.is_bold {
            TextStyle::bold(self.size_pt)
        } else {
            TextStyle::regular(self.size_pt)
        }
    }

    fn widths(&self, width: f64) -> impl Iterator<Item = f64> {
        let shares: f64 = self.columns.iter().map(|column| column.share).sum();
        let columns = self.columns.iter();
        columns.map(move |column| width * column.share / shares)
    }

    fn row_height(&self, row: &[Cell], width: f64) -> f64 {
        let height = |(cell, width): (&Cell, f64)| {
            let style = self.style(cell);
            let lines = style.wrap(&cell.text, width - 2.0 * PADDING[0]).len();
            f64::from(u32::try_from(lines).unwrap_or(u32::MAX)) * style.line_height()
        };
        let heights = row.iter().zip(self.widths(width)).map(height);
        let line = TextStyle::regular(self.size_pt).line_height();
        heights.fold(line, f64::max) + 2.0 * PADDING[1]
    }

    fn draw_row(&self, row: &[Cell], sheet: &mut Sheet, rect: Rect) {
        let mut left = rect.x;
        for ((cell, column), width) in row.iter().zip(&self.columns).zip(self.widths(rect.width)) {
            let style = self.style(cell);
            let mut y = rect.y + PADDING[1] + baseline(&style);
            for line in style.wrap(&cell.text, width - 2.0 * PADDING[0]) {
                let x = match column.align {
                    Align::Left => left + PADDING[0],
                    Align::Center => left + 0.5 * width,
                    Align::Right => left + width - PADDING[0],
                };
                sheet.text([x, y], &line, &style, column.align);
                y += style.line_height();
            }
            left += width;
        }
    }

    /// Draws the line below a row, beside its first columns.
    fn draw_rule(&self, sheet: &mut Sheet, rect: Rect, beside: usize) {
        let left: f64 = self.widths(rect.width).take(beside).sum();
        let bottom = rect.y + rect.height;
        let rule = Stroke::solid(0.2).with_color(RULE);
        sheet.line([rect.x + left, bottom], [rect.x + rect.width, bottom], rule);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Margins, Paper};
    use super::*;

    #[test]
    fn heads_stand_on_every_page_and_no_row_is_lost() {
        let table = PageTable {
            columns: vec![Column::text("名前", 3.0), Column::number("布 (m)", 1.0)],
            rows: (0..120)
                .map(|index| vec![format!("row {index}").into(), "3.66".into()])
                .collect(),
            size_pt: 12.0,
        };
        let mut flow = Flow::new(Paper::A4.size_mm(), Margins::default());
        table.draw(&mut flow);
        let sheets = flow.finish(|_, _, _| {});
        assert!(3 < sheets.len(), "{}", sheets.len());
        let texts: Vec<&str> = sheets.iter().flat_map(Sheet::texts).collect();
        let count = |wanted: &str| texts.iter().filter(|text| **text == wanted).count();
        assert_eq!(count("名前"), sheets.len());
        for index in 0..120 {
            assert_eq!(count(&format!("row {index}")), 1);
        }
    }

    #[test]
    fn rows_that_go_on_stay_on_the_page_of_the_row_they_go_on_with() {
        let rows = (0..60).flat_map(|index| {
            [
                vec![Cell::bold(format!("dancer {index}")), "skirt".into()],
                vec!["".into(), format!("top of {index}").into()],
                vec!["".into(), format!("lei of {index}").into()],
            ]
        });
        let table = PageTable {
            columns: vec![Column::text("Name", 1.0), Column::text("Garment", 1.0)],
            rows: rows.collect(),
            size_pt: 12.0,
        };
        let mut flow = Flow::new(Paper::A4.size_mm(), Margins::default());
        // So that a page ends within a dancer unless it is kept from that.
        flow.space(1.0);
        flow.paragraph("All dancers", &TextStyle::regular(20.0));
        table.draw(&mut flow);
        let sheets = flow.finish(|_, _, _| {});
        assert!(2 < sheets.len(), "{}", sheets.len());
        let page_of = |wanted: &str| {
            let is_on = |sheet: &Sheet| sheet.texts().contains(&wanted);
            sheets.iter().position(is_on).expect("nothing is lost")
        };
        for index in 0..60 {
            let page = page_of(&format!("dancer {index}"));
            assert_eq!(page, page_of(&format!("top of {index}")));
            assert_eq!(page, page_of(&format!("lei of {index}")));
        }
    }

    #[test]
    fn a_table_says_its_height() {
        let table = PageTable {
            columns: vec![Column::text("", 1.0), Column::text("", 1.0)],
            rows: vec![
                vec!["a".into(), "long ".repeat(40).into()],
                vec!["b".into()],
            ],
            size_pt: 10.0,
        };
        let mut flow = Flow::new(Paper::A4.size_mm(), Margins::default());
        let top = flow.y();
        table.draw(&mut flow);
        assert!((flow.y() - top - table.height(flow.width())).abs() < 1e-9);
    }
}
