//! How pages that people read look: heads, rules, numbers, the foot.

use lole_language::Language;

use crate::canvas::Canvas;
use crate::pdf::{Align, Color, Flow, PageTable, Rect, Sheet, Stroke, TextStyle};

/// Heads and what is brought out: the green of ti leaves.
pub(crate) const ACCENT: Color = Color(20, 98, 90);
/// What is sewn now: the red of hibiscus.
pub(crate) const SEWN: Color = Color(196, 56, 48);
/// The right side of cloth in drawings.
pub(crate) const CLOTH: Color = Color(250, 240, 226);
/// Its wrong side.
pub(crate) const INSIDE: Color = Color(228, 222, 214);

/// A head over the whole width.
pub(crate) fn head(flow: &mut Flow, text: &str) {
    head_above(flow, text, 12.0);
}

/// A head, and a table of which at least the beginning is on its page.
pub(crate) fn headed_table(flow: &mut Flow, text: &str, table: &PageTable) {
    head_above(flow, text, table.beginning(flow.width()));
    table.draw(flow);
}

/// A head with at least so much room [mm] below it.
fn head_above(flow: &mut Flow, text: &str, room: f64) {
    flow.space(3.0);
    flow.keep(18.0 + room);
    flow.block(14.0, |sheet, rect| {
        let style = TextStyle::bold(19.0).with_color(ACCENT);
        sheet.text([rect.x, rect.y + 8.0], text, &style, Align::Left);
        rule(sheet, [rect.x, rect.y + 11.0], rect.width);
        sheet.bookmarks.push(text.to_owned());
    });
    flow.space(1.0);
}

/// A smaller head.
pub(crate) fn subhead(flow: &mut Flow, text: &str) {
    flow.keep(24.0);
    flow.paragraph(text, &TextStyle::bold(14.5));
}

/// Room between a drawing and its words, and below both [mm].
const GAP: f64 = 6.0;

/// A drawing with words beside it.
pub(crate) struct Illustrated<'a> {
    pub(crate) title: &'a str,
    pub(crate) words: &'a str,
    /// Size of the drawing [mm].
    pub(crate) drawing: [f64; 2],
    /// Lines below the words that are kept free.
    pub(crate) free_lines: f64,
}

impl Illustrated<'_> {
    /// Draws it; `fill` has the page and the upper left corner of what was kept free.
    pub(crate) fn draw(
        &self,
        flow: &mut Flow,
        language: Language,
        (picture, fill): (
            impl FnOnce(&mut Canvas<'_>),
            impl FnOnce(&mut Sheet, [f64; 2]),
        ),
    ) {
        let (title, style) = (TextStyle::bold(13.5), TextStyle::body());
        let [width, height] = self.drawing;
        let beside = flow.width() - width - GAP;
        let lines = style.wrap(self.words, beside).len() as f64 + self.free_lines;
        let high = title.line_height() + style.line_height() * lines + 2.0;
        flow.drawing(high.max(height) + GAP, language, |canvas| {
            let rect = canvas.rect;
            let place = Rect {
                width,
                height,
                ..rect
            };
            picture(&mut canvas.at(place));
            let left = rect.x + width + GAP;
            let top = rect.y + title.line_height();
            let sheet = &mut canvas.sheet;
            sheet.text([left, top - 1.2], self.title, &title, Align::Left);
            let top = top + 0.8;
            let said = sheet.paragraph([left, top], beside, self.words, &style);
            fill(sheet, [left, top + said]);
        });
    }
}

/// A line below a head.
pub(crate) fn rule(sheet: &mut Sheet, [x, y]: [f64; 2], width: f64) {
    let stroke = Stroke::solid(0.6).with_color(ACCENT);
    sheet.line([x, y], [x + width, y], stroke);
}

/// A step's number in a disk around `center`.
pub(crate) fn number(sheet: &mut Sheet, center: [f64; 2], number: u32) {
    use kurbo::Shape as _;
    let disk = kurbo::Circle::new((center[0], center[1]), 4.0).to_path(0.01);
    sheet.path(disk, Some(ACCENT), None);
    let style = TextStyle::bold(14.0).with_color(Color::WHITE);
    let at = [center[0], center[1] + 1.8];
    sheet.text(at, &number.to_string(), &style, Align::Center);
}

/// Title and number at the foot of a page.
pub(crate) fn foot(sheet: &mut Sheet, title: &str, number: usize, count: usize) {
    let [width, height] = sheet.size;
    let style = TextStyle::regular(10.0).with_color(Color::GRAY);
    sheet.text([20.0, height - 10.0], title, &style, Align::Left);
    let page = format!("{number} / {count}");
    sheet.text([width - 20.0, height - 10.0], &page, &style, Align::Right);
}
