//! A page as SVG, in millimeters.

use base64::Engine as _;
use kurbo::Affine;
use lole_language::visible;

use crate::pdf::{Color, Item, Rect, Sheet, Stroke, Weight};

/// Letters of the reader's own system: Japanese and Hawaiian ones are on all of them.
const FONTS: &str = "'Noto Sans JP','Hiragino Sans','Yu Gothic',Meiryo,sans-serif";

/// Writes a page; one unit of the drawing is a millimeter.
#[must_use]
pub fn sheet_svg(sheet: &Sheet) -> Vec<u8> {
    let [width, height] = sheet.size;
    let mut svg = head(width, height);
    let mut clips = 0;
    write_items(&mut svg, &sheet.items, &mut clips);
    svg.push_str("</svg>\n");
    svg.into_bytes()
}

/// The beginning of a drawing of this size [mm].
pub(crate) fn head(width: f64, height: f64) -> String {
    let (width, height) = (number(width), number(height));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" \
         width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"{FONTS}\">\n"
    )
}

/// A number with a hundredth of a micrometer, without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    let text = format!("{value:.5}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// Text between tags or in an attribute. What XML cannot hold, even spelled out, is made visible: a reader would
/// refuse the whole drawing.
pub(crate) fn escape(text: &str) -> String {
    visible(text)
        .replace(['\u{fffe}', '\u{ffff}'], "\u{fffd}")
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Path data with the precision of [`number`].
pub(crate) fn path_data(path: &kurbo::BezPath) -> String {
    let point = |at: kurbo::Point| format!("{} {}", number(at.x), number(at.y));
    let elements = path.elements().iter().map(|element| match *element {
        kurbo::PathEl::MoveTo(to) => format!("M{}", point(to)),
        kurbo::PathEl::LineTo(to) => format!("L{}", point(to)),
        kurbo::PathEl::QuadTo(a, to) => format!("Q{} {}", point(a), point(to)),
        kurbo::PathEl::CurveTo(a, b, to) => format!("C{} {} {}", point(a), point(b), point(to)),
        kurbo::PathEl::ClosePath => "Z".to_owned(),
    });
    elements.collect()
}

fn write_items(svg: &mut String, items: &[Item], clips: &mut u32) {
    for item in items {
        let line = match item {
            Item::Path { path, fill, stroke } => format!(
                "<path d=\"{}\" fill=\"{}\"{}/>",
                path_data(path),
                fill.map_or_else(|| "none".to_owned(), hex),
                stroke.as_ref().map_or_else(String::new, stroke_style),
            ),
            Item::Text { at, text, style } => format!(
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{} fill=\"{}\">{}</text>",
                number(at[0]),
                number(at[1]),
                number(style.em()),
                if style.weight == Weight::Bold {
                    " font-weight=\"700\""
                } else {
                    ""
                },
                hex(style.color),
                escape(text),
            ),
            Item::Picture { rect, picture } => format!(
                "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:{};base64,{}\"/>",
                number(rect.x),
                number(rect.y),
                number(rect.width),
                number(rect.height),
                picture.media_type(),
                base64::engine::general_purpose::STANDARD.encode(picture.bytes()),
            ),
            Item::Group {
                page_from_group,
                clip,
                items,
            } => {
                open_group(svg, *page_from_group, *clip, clips);
                write_items(svg, items, clips);
                let end = if clip.is_some() { "</g></g>" } else { "</g>" };
                end.to_owned()
            }
        };
        svg.push_str(&line);
        svg.push('\n');
    }
}

fn open_group(svg: &mut String, page_from_group: Affine, clip: Option<Rect>, clips: &mut u32) {
    if let Some(clip) = clip {
        *clips += 1;
        let data = path_data(&clip.to_path());
        svg.push_str(&format!(
            "<clipPath id=\"clip{clips}\"><path d=\"{data}\"/></clipPath><g clip-path=\"url(#clip{clips})\">\n"
        ));
    }
    let coefficients = page_from_group.as_coeffs().map(number).join(" ");
    svg.push_str(&format!("<g transform=\"matrix({coefficients})\">\n"));
}

fn hex(Color(red, green, blue): Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn stroke_style(stroke: &Stroke) -> String {
    let dashes: Vec<String> = stroke.dashes.iter().map(|dash| number(*dash)).collect();
    let dashes = if dashes.is_empty() {
        String::new()
    } else {
        format!(" stroke-dasharray=\"{}\"", dashes.join(" "))
    };
    format!(
        " stroke=\"{}\" stroke-width=\"{}\"{dashes}",
        hex(stroke.color),
        number(stroke.width)
    )
}
