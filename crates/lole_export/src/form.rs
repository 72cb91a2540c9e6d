//! The form on which a dancer is measured: a page with a figure, its tapes and a place for each number, and on
//! the back what fitted garments are drafted by. Its heads are those that `lole order` reads.

use kurbo::{Affine, BezPath, Shape as _};
use lole_body::Measure;
use lole_language::{Language, Words, capitalized, words};

use lole_pattern::Tailored;

use crate::booklet::ACCENT;
use crate::pdf::{Align, Color, Paper, Rect, Sheet, Stroke, TextStyle};

/// What is measured, where the tape lies, and how to lay it.
struct Row {
    measure: Measure,
    tape: Tape,
    how: Words,
}

/// A tape on the figure, in heads from the floor: the figure is eight heads tall.
enum Tape {
    /// Around the trunk at a height, as wide as the figure there.
    Around(f64, f64),
    /// Upright beside the figure, from one height to another, at a distance from its middle.
    Up(f64, f64, f64),
    /// Level across the shoulders.
    Across(f64, f64),
}

const ROWS: &[Row] = &[
    Row {
        measure: Measure::Stature,
        tape: Tape::Up(0.0, 8.0, -2.5),
        how: words("靴をぬぎ、壁に背をつけて", "without shoes, back to a wall"),
    },
    Row {
        measure: Measure::Bust,
        tape: Tape::Around(5.85, 0.88),
        how: words(
            "いちばん高いところを水平に",
            "level, around the fullest part",
        ),
    },
    Row {
        measure: Measure::Underbust,
        tape: Tape::Around(5.45, 0.74),
        how: words(
            "バストのすぐ下を水平に。ダーツの深さが決まる",
            "level, right below the bust; it decides the darts",
        ),
    },
    Row {
        measure: Measure::Waist,
        tape: Tape::Around(5.0, 0.66),
        how: words("いちばん細いところ", "around the narrowest part"),
    },
    Row {
        measure: Measure::HighHip,
        tape: Tape::Around(4.62, 0.84),
        how: words(
            "腰骨の出たところ。パウをはく位置",
            "over the hip bones, where a pāʻū is worn",
        ),
    },
    Row {
        measure: Measure::Hip,
        tape: Tape::Around(4.1, 0.98),
        how: words(
            "いちばん太いところ。かならず測る",
            "around the fullest part; always needed",
        ),
    },
    Row {
        measure: Measure::Inseam,
        tape: Tape::Up(0.0, 3.75, 1.9),
        how: words("またの付け根から床まで", "from the crotch to the floor"),
    },
    Row {
        measure: Measure::WaistHeight,
        tape: Tape::Up(0.0, 5.0, 2.5),
        how: words("ウエストから床まで", "from the waist to the floor"),
    },
    Row {
        measure: Measure::ShoulderBreadth,
        tape: Tape::Across(6.6, 0.95),
        how: words("肩先から肩先まで", "from shoulder point to shoulder point"),
    },
];

/// Right half of a standing figure: distance from the middle and height, in heads.
const OUTLINE: &[[f64; 2]] = &[
    [0.0, 8.0],
    [0.28, 7.9],
    [0.37, 7.55],
    [0.3, 7.15],
    [0.19, 6.98],
    [0.2, 6.78],
    [0.55, 6.66],
    [0.92, 6.52],
    [1.06, 6.2],
    [1.16, 5.5],
    [1.3, 4.7],
    [1.42, 3.95],
    [1.45, 3.6],
    [1.28, 3.62],
    [1.18, 4.0],
    [1.04, 4.7],
    [0.92, 5.3],
    [0.86, 5.95],
    [0.8, 5.6],
    [0.66, 5.05],
    [0.72, 4.8],
    [0.9, 4.4],
    [0.98, 4.05],
    [0.95, 3.6],
    [0.8, 2.8],
    [0.62, 2.1],
    [0.66, 1.6],
    [0.58, 1.1],
    [0.38, 0.4],
    [0.44, 0.16],
    [0.56, 0.0],
    [0.2, 0.0],
    [0.18, 0.4],
    [0.2, 1.2],
    [0.22, 2.0],
    [0.12, 3.0],
    [0.0, 3.72],
];

/// Both sides of the form for one dancer; her name is written in where it is known.
#[must_use]
pub fn form_sheets(name: Option<&str>, paper: Paper, language: Language) -> [Sheet; 2] {
    [
        front(name, paper, language),
        fitted_side(name, paper, language),
    ]
}

/// Distance of what is printed from the left and right edge of the page [mm].
const MARGIN: f64 = 18.0;

/// What every figure and garment goes by.
fn front(name: Option<&str>, paper: Paper, language: Language) -> Sheet {
    let mut sheet = Sheet::new(paper.size_mm());
    let [width, height] = sheet.size;
    let (left, right) = (MARGIN, width - MARGIN);
    let advice = language.pick(
        "薄い服で、まっすぐ立って測ります。メジャーは水平に、指が1本入るくらいにします。長さは cm（またはインチと書く）で。",
        "Wear thin clothes and stand straight. Keep the tape level, with room for one finger. Write centimeters, or say that they are inches.",
    );
    let title = language.pick("採寸表", "Measurement form");
    let top = write_head(&mut sheet, (title, advice), name, language);
    let figure = Rect {
        x: left,
        y: top,
        width: 74.0,
        height: height - top - 22.0,
    };
    draw_figure(&mut sheet, figure);
    let rows = ROWS.iter().map(|row| (row.measure.words(), row.how));
    let rows: Vec<_> = rows.collect();
    let place = ([left + 82.0, right], [top, height - 20.0]);
    write_rows(&mut sheet, &rows, place, language);
    write_foot(&mut sheet, language);
    sheet
}

/// What fitted garments are drafted by beside that; may all be left empty.
fn fitted_side(name: Option<&str>, paper: Paper, language: Language) -> Sheet {
    let mut sheet = Sheet::new(paper.size_mm());
    let [width, height] = sheet.size;
    let advice = language.pick(
        "ブラウス、ムウムウ、ホロクーなど、体に合わせて縫う服のときに測ります。測れないところは空けておくと、推定します。袖口と頭の飾りだけなら、手首回りと頭回りだけで足ります。",
        "For blouse, muʻumuʻu, holokū and what else is cut to fit. What is left empty is estimated. For cuffs and wreaths alone, wrist and head will do.",
    );
    let title = language.pick(
        "採寸表（体に合わせる服）",
        "Measurement form: fitted clothes",
    );
    let top = write_head(&mut sheet, (title, advice), name, language);
    let rows = Tailored::ALL.map(|tailored| (tailored.name(), tailored.how()));
    let place = ([MARGIN, width - MARGIN], [top, height - 20.0]);
    write_rows(&mut sheet, &rows, place, language);
    write_foot(&mut sheet, language);
    sheet
}

/// Title, name, date and advice; how far down they go [mm].
fn write_head(
    sheet: &mut Sheet,
    (title, advice): (&str, &str),
    name: Option<&str>,
    language: Language,
) -> f64 {
    let (left, right) = (MARGIN, sheet.size[0] - MARGIN);
    let style = TextStyle::bold(24.0).with_color(ACCENT);
    sheet.text([left, 26.0], title, &style, Align::Left);
    let label = TextStyle::regular(13.0);
    let said = language.pick("名前", "Name");
    sheet.text([left, 41.0], said, &label, Align::Left);
    let line = Stroke::solid(0.3);
    sheet.line([left + 16.0, 42.0], [right - 62.0, 42.0], line.clone());
    if let Some(name) = name {
        sheet.text(
            [left + 18.0, 40.5],
            name,
            &TextStyle::bold(15.0),
            Align::Left,
        );
    }
    let said = language.pick("測った日", "Date");
    sheet.text([right - 58.0, 41.0], said, &label, Align::Left);
    sheet.line([right - 38.0, 42.0], [right, 42.0], line);
    let used = sheet.paragraph(
        [left, 47.0],
        right - left,
        advice,
        &TextStyle::regular(12.0),
    );
    51.0 + used
}

/// How a filled form comes into the program.
fn write_foot(sheet: &mut Sheet, language: Language) {
    let said = language.pick(
        "この表の見出しのまま表計算ソフトに入れて保存すると（Excel でも CSV でも）、lole order が読めます。",
        "Typed into a spreadsheet under the same heads and saved, as a workbook or as CSV, lole order reads it.",
    );
    let style = TextStyle::regular(9.5).with_color(Color::GRAY);
    let place = [MARGIN, sheet.size[1] - 9.0];
    sheet.text(place, said, &style, Align::Left);
}

/// The figure with a numbered tape for each measure.
fn draw_figure(sheet: &mut Sheet, rect: Rect) {
    let head = (rect.height / 8.2).min(rect.width / 6.0);
    let middle = rect.x + 0.5 * rect.width;
    // In the middle of its place, which is higher than the figure.
    let floor = rect.y + 0.5 * (rect.height + 8.0 * head);
    let page = Affine::translate((middle, floor)) * Affine::scale_non_uniform(head, -head);
    for side in [1.0, -1.0] {
        let mirror = page * Affine::scale_non_uniform(side, 1.0);
        let path = mirror * smooth(OUTLINE);
        let skin = Color(247, 233, 220);
        sheet.path(path.clone(), Some(skin), None);
        sheet.path(
            path,
            None,
            Some(Stroke::solid(0.4).with_color(Color(120, 90, 70))),
        );
    }
    let tape = Stroke::solid(0.8).with_color(ACCENT);
    for (number, row) in (1_u32..).zip(ROWS) {
        let at = match row.tape {
            Tape::Around(height, half) => {
                let center = page * kurbo::Point::new(0.0, height);
                let ring = kurbo::Ellipse::new(center, (half * head, 0.12 * head), 0.0);
                sheet.path(ring.to_path(0.01), None, Some(tape.clone()));
                [center.x + half * head + 4.2, center.y]
            }
            Tape::Up(low, high, beside) => {
                let [low, high] = [low, high].map(|at| page * kurbo::Point::new(beside, at));
                crate::cutting::draw::arrow(sheet, [low, high], &tape);
                [low.x, 0.5 * (low.y + high.y)]
            }
            Tape::Across(height, half) => {
                let [from, to] = [-half, half].map(|at| page * kurbo::Point::new(at, height));
                crate::cutting::draw::arrow(sheet, [from, to], &tape);
                [to.x + 4.2, to.y]
            }
        };
        disk(sheet, at, number);
    }
}

/// A smooth curve through points: Catmull and Rom's, as cubics.
fn smooth(points: &[[f64; 2]]) -> BezPath {
    let at = |index: usize| {
        let [x, y] = points[index.min(points.len() - 1)];
        kurbo::Point::new(x, y)
    };
    let mut path = BezPath::new();
    path.move_to(at(0));
    for index in 1..points.len() {
        let before = at(index.saturating_sub(2));
        let (from, to, after) = (at(index - 1), at(index), at(index + 1));
        path.curve_to(from + (to - before) / 6.0, to - (after - from) / 6.0, to);
    }
    path
}

fn disk(sheet: &mut Sheet, [x, y]: [f64; 2], number: u32) {
    let path = kurbo::Circle::new((x, y), 3.2).to_path(0.01);
    sheet.path(path, Some(ACCENT), None);
    let style = TextStyle::bold(11.0).with_color(Color::WHITE);
    sheet.text([x, y + 1.4], &number.to_string(), &style, Align::Center);
}

/// Number, name, how to measure, and a box to write into.
fn write_rows(
    sheet: &mut Sheet,
    rows: &[(Words, Words)],
    ([left, right], [top, bottom]): ([f64; 2], [f64; 2]),
    language: Language,
) {
    let count = f64::from(u32::try_from(rows.len()).unwrap_or(1));
    let pitch = ((bottom - top) / count).min(24.0);
    for (number, (name, how)) in (1_u32..).zip(rows) {
        let y = top + pitch * f64::from(number - 1);
        disk(sheet, [left + 3.5, y + 5.0], number);
        let name = &capitalized(name.text(language));
        sheet.text(
            [left + 10.0, y + 6.6],
            name,
            &TextStyle::bold(14.0),
            Align::Left,
        );
        let entry = Rect {
            x: right - 34.0,
            y: y + 0.5,
            width: 34.0,
            height: 11.0,
        };
        sheet.rect(entry, None, Some(Stroke::solid(0.35)));
        let unit = TextStyle::regular(10.0).with_color(Color::GRAY);
        sheet.text([right - 2.0, y + 9.5], "cm", &unit, Align::Right);
        let how = how.text(language);
        let small = TextStyle::regular(11.0);
        sheet.paragraph([left + 10.0, y + 11.5], right - left - 10.0, how, &small);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pdf::missing_glyphs;

    #[test]
    fn everything_stays_on_the_page_and_can_be_printed() {
        for paper in [Paper::A4, Paper::Letter] {
            for language in [Language::Japanese, Language::English] {
                for sheet in form_sheets(Some("ʻIolana"), paper, language) {
                    check(&sheet);
                }
            }
        }
    }

    fn check(sheet: &Sheet) {
        assert!(sheet.texts().contains(&"ʻIolana"));
        for text in sheet.texts() {
            assert!(missing_glyphs(text).is_empty(), "{text}");
        }
        for item in &sheet.items {
            let crate::pdf::Item::Text { at, text, style } = item else {
                continue;
            };
            let end = at[0] + style.width_of(text);
            assert!(10.0 < at[0] && end < sheet.size[0] - 8.0, "{text}: {end}");
            assert!(at[1] < sheet.size[1] - 5.0, "{text}");
        }
    }

    /// What is written on the form is what the list's heads are called.
    #[test]
    fn heads_of_the_form_are_read_by_the_order() {
        for language in [Language::Japanese, Language::English] {
            let names = ROWS.iter().map(|row| row.measure.words());
            let tailored = Tailored::ALL.map(Tailored::name);
            let names = names.chain(tailored).map(|name| name.text(language));
            let heads: Vec<String> = names.map(capitalized).collect();
            let name = language.pick("名前", "Name");
            let list = format!("{name},{}\n", heads.join(","));
            let roster = lole_costume::roster::read(list.as_bytes());
            let roster = roster.unwrap_or_else(|error| panic!("{error}"));
            assert!(roster.notes.is_empty(), "{:?}", roster.notes);
        }
    }
}
