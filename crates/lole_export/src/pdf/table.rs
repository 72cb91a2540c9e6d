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
pub struct Table {
    /// Its columns. Heads are drawn unless all are empty.
    pub columns: Vec<Column>,
    /// Its rows; a missing cell is empty.
    pub rows: Vec<Vec<Cell>>,
    /// Size of its letters [pt].
    pub size_pt: f64,
}

impl Table {
    /// Draws the table down the pages.
    pub fn draw(&self, flow: &mut Flow) {
        let head: Vec<Cell> = (self.columns.iter())
            .map(|column| Cell::bold(column.head.clone()))
            .collect();
        let has_head = head.iter().any(|cell| !cell.text.is_empty());
        let mut page_is_new = true;
        for row in &self.rows {
            let height = self.row_height(row, flow.width());
            let head_height = self.row_height(&head, flow.width());
            let wanted = if page_is_new {
                height + head_height
            } else {
                height
            };
            if flow.left_over() < wanted {
                flow.new_page();
                page_is_new = true;
            }
            if page_is_new && has_head {
                flow.block(head_height, |sheet, rect| {
                    sheet.rect(rect, Some(HEAD), None);
                    self.draw_row(&head, sheet, rect);
                });
            }
            page_is_new = false;
            flow.block(height, |sheet, rect| self.draw_row(row, sheet, rect));
        }
    }

    /// Height on a page of this width of text [mm], when it fits onto one.
    #[must_use]
    pub fn height(&self, width: f64) -> f64 {
        let head: Vec<Cell> = (self.columns.iter())
            .map(|column| Cell::bold(column.head.clone()))
            .collect();
        let has_head = head.iter().any(|cell| !cell.text.is_empty());
        let rows: f64 = self
            .rows
            .iter()
            .map(|row| self.row_height(row, width))
            .sum();
        if has_head {
            rows + self.row_height(&head, width)
        } else {
            rows
        }
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
        let bottom = rect.y + rect.height;
        let rule = Stroke::solid(0.2).with_color(RULE);
        sheet.line([rect.x, bottom], [rect.x + rect.width, bottom], rule);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Margins, Paper};
    use super::*;

    #[test]
    fn heads_stand_on_every_page_and_no_row_is_lost() {
        let table = Table {
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
    fn a_table_says_its_height() {
        let table = Table {
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
