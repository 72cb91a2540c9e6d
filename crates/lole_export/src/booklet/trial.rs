//! The trial in basted cloth: how a fitted garment is tried on before its cloth is cut, and what is altered by
//! what is seen then.

use kurbo::{Affine, BezPath, Rect as Bounds, Shape as _};
use lole_costume::tailoring::UsedAlteration;
use lole_language::{Language, Words, words};
use lole_pattern::Piece;

use super::style::{CLOTH, Illustrated, SEWN, head};
use crate::canvas::Canvas;
use crate::pdf::{Align, Flow, Stroke, TextStyle};

/// Size of a drawing [mm].
const DRAWING: [f64; 2] = [34.0, 40.0];
/// The line on which a number is written [mm].
const BLANK: f64 = 26.0;

const STEPS: [Words; 4] = [
    words(
        "型紙をシーチングなど安い平織りの布に写し、身頃と袖だけを裁ちます。脇と肩の縫い代は 2.5 cm にします。中心・ウエスト・合印を線で描いておきます。",
        "Draw the patterns on sheeting or another cheap plain cloth and cut bodice and sleeves alone, with 2.5 cm of allowance at sides and shoulders. Draw the middles, the waist and all notches on it.",
    ),
    words(
        "4 mm の粗い目で縫い合わせ、裏返さずに着て、ファスナーやボタンで開く所はピンで留めます。踊るときの下着で、靴なしで立ちます。",
        "Sew it together in stitches of 4 mm, put it on with the allowances outside, and pin what opens by a zip or a button. Stand as you dance: without shoes, in what you wear below.",
    ),
    words(
        "前・横・後ろから見ます。腕を上げ、前へ伸ばし、腰を回します。しわは、布の足りない所へ向かい、余る所にたまります。下の絵と見くらべ、ピンでつまむか、切り開いて布を足し、その長さを測ります。",
        "Look from the front, from the side and from behind. Raise the arms, reach forward, turn the hips. Creases point to where cloth is missing and lie where there is too much. Compare with the drawings below; pin out what is too much, or cut open and fill in what is missing, and measure it.",
    ),
    words(
        "測った数を下に書き、デザインの「補正」か、名簿の同じ名前の列に入れて、型紙を引き直します。縫い合わせる所はすべて、いっしょに直ります。",
        "Write the numbers below and give them to the design as its alterations, or to the list in columns of these names: the patterns are drafted anew, and every seam that is sewn together changes with them.",
    ),
];

/// Draws the pages; nothing where no garment is fitted.
pub(super) fn draw(flow: &mut Flow, alterations: &[UsedAlteration], language: Language) {
    if alterations.is_empty() {
        return;
    }
    flow.space(4.0);
    flow.keep(0.5 * flow.page_height());
    head(
        flow,
        language.pick("仮縫いと補正", "A trial in basted cloth, and alterations"),
    );
    for (index, step) in STEPS.iter().enumerate() {
        let text = format!("{}. {}", index + 1, step.text(language));
        flow.paragraph(&text, &TextStyle::body());
        flow.space(1.5);
    }
    flow.paragraph(
        language.pick(
            "絵は、補正していない型紙（黒）と、2 cm 補正した型紙（赤い点線）です。",
            "The drawings show the pattern without the alteration (black) and with 2 cm of it (red, dashed).",
        ),
        &TextStyle::regular(11.5),
    );
    flow.space(3.0);
    for used in alterations {
        one(flow, used, language);
    }
}

fn one(flow: &mut Flow, used: &UsedAlteration, language: Language) {
    let said = Illustrated {
        title: used.alteration.name().text(language),
        words: used.alteration.seen().text(language),
        drawing: DRAWING,
        free_lines: 1.4,
    };
    let picture = |canvas: &mut Canvas<'_>| overlaid(canvas, &used.shown);
    said.draw(
        flow,
        language,
        (picture, |sheet, [left, top]| {
            let style = TextStyle::body();
            let y = top + style.line_height();
            let now = if used.cm == 0.0 {
                language.pick("補正: ", "altered by: ").to_owned()
            } else {
                let label = language.pick("いまの補正", "altered by now");
                let more = language.pick("新しい補正: ", "from now on: ");
                format!("{label}: {:+.1} cm　{more}", used.cm)
            };
            let end = sheet.text([left, y], &now, &style, Align::Left);
            let from = left + end + 1.0;
            sheet.line([from, y + 0.8], [from + BLANK, y + 0.8], Stroke::solid(0.3));
            let unit = [from + BLANK + 1.5, y];
            sheet.text(unit, "cm", &style, Align::Left);
        }),
    );
}

/// A piece as it is and altered, at one scale and one place.
fn overlaid(canvas: &mut Canvas<'_>, [plain, altered]: &[Piece; 2]) {
    let [plain, altered] = [plain, altered].map(outline);
    let bounds: Bounds = plain.bounding_box().union(altered.bounding_box());
    let rect = canvas.rect;
    let scale = (rect.width / bounds.width()).min(rect.height / bounds.height());
    let left = rect.x + 0.5 * (rect.width - bounds.width() * scale);
    let place = Affine::translate((left, rect.y))
        * Affine::scale_non_uniform(scale, -scale)
        * Affine::translate((-bounds.x0, -bounds.y1));
    let solid = Stroke::solid(0.35);
    (canvas.sheet).path(place * plain, Some(CLOTH), Some(solid));
    let dashed = Stroke::dashed(0.45, 1.2).with_color(SEWN);
    canvas.sheet.path(place * altered, None, Some(dashed));
}

/// The seam line of a piece [m].
fn outline(piece: &Piece) -> BezPath {
    let segments = piece.edges.iter().flat_map(|edge| &edge.segments);
    let mut path = BezPath::from_path_segments(segments.copied());
    path.close_path();
    path
}
