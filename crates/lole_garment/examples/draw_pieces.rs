//! Draws the pieces of every template to SVG, to be looked at as a tailor looks at a draft:
//! `cargo run -p lole_garment --example draw_pieces -- FOLDER [BODY] [TEMPLATE]`.

#[path = "../tests/bodies/mod.rs"]
mod bodies;

use std::fmt::Write as _;

use kurbo::{Affine, BezPath, Shape as _};
use lole_garment::Fitting;
use lole_garment::template::{Options, TEMPLATES};
use lole_pattern::piece::Mark;
use lole_pattern::{Pattern, Piece};

/// Space between pieces [mm].
const GAP: f64 = 60.0;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_else(|| ".".to_owned());
    let wanted_body = arguments.next().unwrap_or_else(|| "mean".to_owned());
    let wanted = arguments.next();
    for (name, row) in bodies::BODIES
        .iter()
        .filter(|(name, _)| *name == wanted_body)
    {
        let measures = bodies::of_row(row);
        let templates = TEMPLATES.iter();
        for template in templates.filter(|one| wanted.as_ref().is_none_or(|id| id == one.id)) {
            match (template.draft)(&Fitting::by(&measures), &Options::of(template)) {
                Ok(pattern) if !pattern.pieces.is_empty() => {
                    let path = format!("{folder}/{}_{name}.svg", template.id);
                    std::fs::write(&path, drawing(&pattern)).expect("the folder can be written");
                }
                Ok(_) => {}
                #[expect(clippy::print_stderr, reason = "an example talks to its caller")]
                Err(error) => eprintln!("{} {name}: {error}", template.id),
            }
        }
    }
}

fn svg_path(path: &BezPath) -> String {
    use kurbo::PathEl;
    let point = |point: kurbo::Point| format!("{:.2} {:.2}", point.x, point.y);
    let element = |element: PathEl| match element {
        PathEl::MoveTo(to) => format!("M{}", point(to)),
        PathEl::LineTo(to) => format!("L{}", point(to)),
        PathEl::QuadTo(a, to) => format!("Q{} {}", point(a), point(to)),
        PathEl::CurveTo(a, b, to) => format!("C{} {} {}", point(a), point(b), point(to)),
        PathEl::ClosePath => "Z".to_owned(),
    };
    path.iter().map(element).collect()
}

fn drawing(pattern: &Pattern) -> String {
    let mut body = String::new();
    let (mut x, mut height) = (GAP, 0.0_f64);
    for piece in &pattern.pieces {
        let bounds = piece.stitching_line().bounding_box();
        let scale = Affine::new([1000.0, 0.0, 0.0, -1000.0, 0.0, 0.0]);
        let [left, top] = [bounds.x0 * 1000.0, -bounds.y1 * 1000.0];
        let place = Affine::translate((x - left, GAP - top)) * scale;
        draw(&mut body, piece, place);
        x += bounds.width() * 1000.0 + GAP;
        height = height.max(bounds.height() * 1000.0);
    }
    let height = height + 2.0 * GAP;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {x:.1} {height:.1}\" width=\"{x:.0}\" height=\"{height:.0}\"><rect width=\"100%\" height=\"100%\" fill=\"white\"/>{body}</svg>\n"
    )
}

fn draw(body: &mut String, piece: &Piece, place: Affine) {
    let mut path = |path: BezPath, style: &str| {
        let path = svg_path(&(place * path));
        writeln!(body, "<path d=\"{path}\" {style}/>").expect("writing to a string");
    };
    path(
        piece.stitching_line(),
        "fill=\"#eef4fb\" stroke=\"black\" stroke-width=\"2\"",
    );
    for mark in &piece.marks {
        if let Mark::Line { path: line, .. } = mark {
            let style =
                "fill=\"none\" stroke=\"#c02020\" stroke-width=\"1.5\" stroke-dasharray=\"8 5\"";
            path(line.clone(), style);
        }
    }
    for mark in &piece.marks {
        let (at, color) = match mark {
            Mark::Notch { edge, along, .. } => (point_on(piece, *edge, *along), "#208020"),
            Mark::Point { at, .. } => (*at, "#c02020"),
            Mark::Line { .. } => continue,
        };
        let at = place * at;
        writeln!(
            body,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"5\" fill=\"{color}\"/>",
            at.x, at.y
        )
        .expect("writing to a string");
    }
    let center = place * piece.stitching_line().bounding_box().center();
    writeln!(
        body,
        "<text x=\"{:.0}\" y=\"{:.0}\" font-size=\"18\" text-anchor=\"middle\">{} ({})</text>",
        center.x,
        center.y,
        piece.id,
        piece.cut.pieces()
    )
    .expect("writing to a string");
}

fn point_on(piece: &Piece, edge: usize, along: f64) -> kurbo::Point {
    use kurbo::{ParamCurve as _, ParamCurveArclen as _};
    let mut left = along;
    for segment in &piece.edges[edge].segments {
        let own = segment.arclen(1e-6);
        if left <= own {
            return segment.eval(segment.inv_arclen(left, 1e-6));
        }
        left -= own;
    }
    piece.edges[edge]
        .segments
        .last()
        .map_or(kurbo::Point::ZERO, kurbo::PathSeg::end)
}
