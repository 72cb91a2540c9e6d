//! Laws of what is said of a sewn garment: it is what its pieces come to when they are measured.

#[path = "bodies/any.rs"]
mod any;
mod bodies;

use kurbo::PathEl;
use lole_garment::Fitting;
use lole_garment::template::{Options, TEMPLATES, Template};
use lole_pattern::pattern::{Pattern, StepFigure};
use lole_pattern::piece::{Finish, LineKind, Mark};
use lole_pattern::{Measures, Piece};
use proptest::prelude::*;

use any::any_body;
use bodies::of_row;

/// Lengths agree to a tenth of a millimeter [m].
const CLOSE: f64 = 1.0e-4;

fn drafted(id: &str, measures: &Measures) -> Option<Pattern> {
    let template: &Template = TEMPLATES
        .iter()
        .copied()
        .find(|template| template.id == id)?;
    (template.draft)(&Fitting::by(measures), &Options::of(template)).ok()
}

/// Width of half a piece at the waist [m], its darts sewn.
fn width_at_waist(piece: &Piece) -> f64 {
    let polygon = piece.stitching_polygon(1.0e-5);
    let crossings = polygon.sides().filter(|[a, b]| (a.y < 0.0) != (b.y < 0.0));
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for [a, b] in crossings {
        let x = a.x + (b.x - a.x) * a.y / (a.y - b.y);
        (least, most) = (least.min(x), most.max(x));
    }
    let mut legs: Vec<f64> = Vec::new();
    for mark in &piece.marks {
        if let Mark::Line {
            kind: LineKind::Dart,
            path,
        } = mark
        {
            let points = path.elements().iter().filter_map(PathEl::end_point);
            legs.extend(
                points
                    .filter(|point| point.y.abs() < 1.0e-9)
                    .map(|point| point.x),
            );
        }
    }
    legs.sort_by(f64::total_cmp);
    let darts: f64 = legs.chunks_exact(2).map(|pair| pair[1] - pair[0]).sum();
    most - least - darts
}

fn piece<'a>(pattern: &'a Pattern, id: &str) -> &'a Piece {
    let found = pattern.pieces.iter().find(|piece| piece.id == id);
    found.unwrap_or_else(|| panic!("no {id}"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// The waist that is said is the one that the pieces have where they are narrowest.
    #[test]
    fn the_waist_that_is_said_is_that_of_the_pieces(body in any_body()) {
        let measures = of_row(&body);
        for id in ["blouse", "holoku"] {
            let Some(pattern) = drafted(id, &measures) else { continue };
            let halves = ["front", "back"].map(|id| width_at_waist(piece(&pattern, id)));
            let around = 2.0 * (halves[0] + halves[1]);
            let said = pattern.finished.iter().find(|row| row.name.english == "waist");
            let said = said.map_or(0.0, |row| row.garment.to_m());
            prop_assert!((around - said).abs() < CLOSE, "{id}: {around} is said to be {said}");
        }
    }

    /// What is worn close has room for the body, but where elastic draws it in.
    #[test]
    fn garments_have_room(body in any_body()) {
        let measures = of_row(&body);
        for template in TEMPLATES {
            let Some(pattern) = drafted(template.id, &measures) else { continue };
            for row in &pattern.finished {
                prop_assert!(0.0 < row.garment.to_m(), "{} {}", template.id, row.name.english);
                let is_drawn_in = row.name.english.contains("elastic");
                let ease = row.ease().map_or(0.0, |ease| ease.to_m());
                prop_assert!(
                    is_drawn_in || -CLOSE < ease,
                    "{} {}: {ease}", template.id, row.name.english
                );
            }
        }
    }

    /// A skirt with a flounce is as long as both, and as wide as the flounce.
    #[test]
    fn a_flounce_is_part_of_the_skirt_that_is_said(body in any_body(), choice in 0_u8..3) {
        let measures = of_row(&body);
        let template = Template::of_id("pau-ruffle").expect("on the shelf");
        let options = Options::of(template).with(template, &[("ruffle", f64::from(choice))]);
        if let Ok(pattern) = (template.draft)(&Fitting::by(&measures), &options) {
            let panel = piece(&pattern, "panel");
            let said = |name: &str| {
                let row = pattern.finished.iter().find(|row| row.name.english == name);
                row.map_or(0.0, |row| row.garment.to_m())
            };
            let bounds = |piece: &Piece| piece.stitching_polygon(1.0e-5).bounds();
            let (mut length, mut around) = (bounds(panel).height(), bounds(panel).width());
            if panel.edges[0].finish == Finish::Seam {
                let ruffle = piece(&pattern, "ruffle");
                length += bounds(ruffle).height();
                around = bounds(ruffle).width() * f64::from(ruffle.cut.pieces());
            }
            let found = said("from the top fold to the hem");
            prop_assert!((found - length).abs() < CLOSE, "{choice}: {found} of {length}");
            let found = said("around the hem");
            prop_assert!((found - around).abs() < CLOSE, "{choice}: {found} of {around}");
        }
    }

    /// The parts in which a wrap is drawn are all of its cloth, end to end.
    #[test]
    fn the_parts_of_a_wrap_are_its_cloth(body in any_body()) {
        let measures = of_row(&body);
        let mut seen = 0;
        for template in TEMPLATES {
            let Some(pattern) = drafted(template.id, &measures) else { continue };
            for step in &pattern.steps {
                let StepFigure::Wrapping(parts) = &step.figure else { continue };
                let bounds = pattern.pieces[0].stitching_polygon(1.0e-5).bounds();
                let whole: f64 = parts.iter().map(|part| part.length.to_m()).sum();
                prop_assert!((whole - bounds.width()).abs() < CLOSE, "{}: {whole}", template.id);
                seen += 1;
            }
        }
        prop_assert!(0 < seen);
    }
}
