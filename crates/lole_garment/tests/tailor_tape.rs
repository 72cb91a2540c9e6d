//! What was taken of her for drafting, in the place of what her body has.

mod bodies;

#[path = "bodies/any.rs"]
mod any;

use kurbo::ParamCurve as _;
use lole_garment::Fitting;
use lole_garment::template::{Options, TEMPLATES, Template};
use lole_language::Bilingual as _;
use lole_pattern::piece::{LineKind, Mark};
use lole_pattern::{DraftError, Measures, Pattern, Piece, TailorTape, Tailored};
use proptest::prelude::*;

use any::any_body;
use bodies::of_row;

/// What nobody cuts [m]: a hundredth of a millimeter.
const ALIKE: f64 = 1.0e-5;

fn drafted(id: &str, measures: &Measures) -> Result<Pattern, DraftError> {
    let template = Template::of_id(id).unwrap_or_else(|| panic!("no {id}"));
    (template.draft)(&Fitting::by(measures), &Options::of(template))
}

fn on_body(tailored: Tailored, body: &Measures) -> f64 {
    tailored.measure().of(body).to_cm()
}

/// The farthest that a corner of one pattern lies from that of the other [m]; infinite where they are not of the
/// same pieces.
fn apart(one: &Pattern, other: &Pattern) -> f64 {
    let corners = |pattern: &Pattern| -> Vec<kurbo::Point> {
        let edges = pattern.pieces.iter().flat_map(|piece| &piece.edges);
        let lines = edges.flat_map(|edge| &edge.segments);
        lines.map(|line| line.eval(0.5)).collect()
    };
    let (one, other) = (corners(one), corners(other));
    if one.len() != other.len() {
        return f64::INFINITY;
    }
    let pairs = one.iter().zip(&other);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// Over all pieces whose name begins so, the length of what is called so [m].
fn long(pattern: &Pattern, face: &str, edge: &str) -> f64 {
    let pieces = (pattern.pieces.iter()).filter(|piece| piece.id.starts_with(face));
    let edges = pieces.filter_map(|piece| piece.edge(edge));
    edges.map(lole_pattern::piece::Edge::length).sum()
}

/// From one end of an edge to the other as the crow flies, of the first piece called so [m].
fn across(pattern: &Pattern, face: &str, edge: &str) -> f64 {
    let mut pieces = (pattern.pieces.iter()).filter(|piece| piece.id.starts_with(face));
    let ends = |piece: &Piece| {
        let edge = piece.edge(edge)?;
        let [first, last] = [edge.segments.first()?, edge.segments.last()?];
        Some((first.start() - last.end()).hypot())
    };
    pieces.find_map(ends).unwrap_or(f64::NAN)
}

/// How far from the middle the armhole lies in the mean, of the first piece called so [m].
fn from_middle(pattern: &Pattern, face: &str) -> f64 {
    let mut pieces = (pattern.pieces.iter()).filter(|piece| piece.id.starts_with(face));
    let edge = pieces.find_map(|piece| piece.edge("armhole"));
    let segments = edge.map_or(&[][..], |edge| &edge.segments);
    let places = segments.iter().map(|line| line.eval(0.5).x);
    places.sum::<f64>() / segments.len() as f64
}

/// How far from the middle the dart of the front ends [m]; infinite where she needs none.
fn dart_tip(pattern: &Pattern) -> f64 {
    let fronts = (pattern.pieces.iter()).filter(|piece| piece.id.starts_with("front"));
    let darts = (fronts.flat_map(|piece| &piece.marks)).filter_map(|mark| match mark {
        Mark::Line {
            kind: LineKind::Dart,
            path,
        } => Some(path.elements().iter().filter_map(kurbo::PathEl::end_point)),
        _ => None,
    });
    (darts.flatten())
        .map(|point| point.x)
        .fold(f64::INFINITY, f64::min)
}

fn finished(pattern: &Pattern, english: &str) -> f64 {
    let found = pattern
        .finished
        .iter()
        .find(|row| row.name.english == english);
    found.map_or(f64::NAN, |row| row.garment.to_m())
}

/// A garment that goes by a measure, and what of it grows with it.
fn growing(tailored: Tailored) -> (&'static str, fn(&Pattern) -> f64) {
    match tailored {
        Tailored::Neck => ("blouse", |it| long(it, "back", "neckline")),
        Tailored::BackBreadth => ("blouse", |it| from_middle(it, "back")),
        Tailored::ChestBreadth => ("blouse", |it| from_middle(it, "front")),
        Tailored::BackLength => ("holoku", |it| long(it, "back", "center_back")),
        Tailored::FrontLength => ("blouse", |it| long(it, "front", "center_front")),
        Tailored::BustPoints => ("blouse", dart_tip),
        Tailored::UpperArm => ("blouse", |it| finished(it, "edge of the sleeve, elastic")),
        Tailored::Wrist => ("holoku", |it| finished(it, "edge of the sleeve")),
        Tailored::ArmLength => ("holoku", |it| long(it, "sleeve", "back_side")),
        Tailored::CrotchLength => ("malo", |it| finished(it, "length")),
        Tailored::Head => ("lei-poo", |it| finished(it, "length of leaves and flowers")),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(120) })]

    #[test]
    fn taking_what_she_has_changes_nothing(row in any_body()) {
        let body = of_row(&row);
        let tape = Tailored::ALL.into_iter().fold(TailorTape::NONE, |tape, one| {
            tape.with_cm(one, Some(on_body(one, &body)))
        });
        let taken = tape.over(body.clone()).unwrap();
        for template in TEMPLATES {
            let draft = |measures| (template.draft)(&Fitting::by(measures), &Options::of(template));
            let (own, other) = (draft(&body).unwrap(), draft(&taken).unwrap());
            prop_assert!(apart(&own, &other) < ALIKE, "{}", template.id);
        }
        prop_assert_eq!(TailorTape::NONE.over(body.clone()).unwrap(), body);
    }

    /// More of it makes more cloth there, and less less.
    #[test]
    fn patterns_grow_with_what_was_taken(row in any_body()) {
        let body = of_row(&row);
        for tailored in Tailored::ALL {
            let (id, size) = growing(tailored);
            let own = drafted(id, &body).unwrap();
            for ratio in [0.96, 1.04] {
                let cm = ratio * on_body(tailored, &body);
                let measures = TailorTape::NONE.with_cm(tailored, Some(cm)).over(body.clone()).unwrap();
                prop_assert!((on_body(tailored, &measures) - cm).abs() < 1.0e-9);
                let Ok(other) = drafted(id, &measures) else {
                    continue;
                };
                let (before, after) = (size(&own), size(&other));
                if before.is_finite() && after.is_finite() {
                    let grown = (after - before) * (ratio - 1.0);
                    prop_assert!(0.0 < grown, "{tailored:?} {ratio}: {before} to {after}");
                }
                // Nothing but a flat chest is cut alike whatever is taken of it.
                let is_flat = tailored == Tailored::BustPoints;
                prop_assert!(before.is_finite() || is_flat, "{tailored:?}");
            }
        }
    }

    #[test]
    fn a_sleeve_is_wide_enough_for_the_arm_that_was_taken(row in any_body()) {
        let body = of_row(&row);
        let [_, most] = Tailored::UpperArm.room_cm(on_body(Tailored::UpperArm, &body));
        let measures = TailorTape::NONE.with_cm(Tailored::UpperArm, Some(most)).over(body.clone()).unwrap();
        for id in ["blouse", "muumuu", "holoku"] {
            if let Ok(pattern) = drafted(id, &measures) {
                let plain = across(&drafted(id, &body).unwrap(), "sleeve", "cap");
                let wide = across(&pattern, "sleeve", "cap");
                // On a small armhole it may be wide enough already.
                let is_enough = plain <= wide && 0.01 * most < wide;
                prop_assert!(is_enough, "{id} {most}: {plain} to {wide}");
            }
        }
    }

    #[test]
    fn what_is_too_far_from_her_body_is_refused_by_its_key(row in any_body()) {
        let body = of_row(&row);
        for tailored in Tailored::ALL {
            let [least, most] = tailored.room_cm(on_body(tailored, &body));
            let over = |cm| TailorTape::NONE.with_cm(tailored, Some(cm)).over(body.clone());
            for cm in [least, most] {
                prop_assert!(over(cm).is_ok(), "{tailored:?} {cm}");
            }
            for cm in [least - 0.1, most + 0.1, f64::NAN, f64::INFINITY] {
                let error = over(cm).unwrap_err();
                for text in [error.to_string(), error.japanese()] {
                    let ends = [format!("{least:.1}"), format!("{most:.1}")];
                    prop_assert!(text.contains(tailored.key()), "{text}");
                    prop_assert!(ends.iter().all(|end| text.contains(end)), "{text}");
                }
            }
        }
    }
}

/// A front that was not measured hangs from the shoulders of the back that was.
#[test]
fn the_front_goes_with_the_back_until_it_is_taken() {
    let body = of_row(&bodies::BODIES[2].1);
    let longer = on_body(Tailored::BackLength, &body) + 1.5;
    let tape = TailorTape::NONE.with_cm(Tailored::BackLength, Some(longer));
    let front =
        |tape: TailorTape| on_body(Tailored::FrontLength, &tape.over(body.clone()).unwrap());
    let own = on_body(Tailored::FrontLength, &body);
    assert!((front(tape) - own - 1.5).abs() < 1.0e-9);
    let both = tape.with_cm(Tailored::FrontLength, Some(own));
    assert!((front(both) - own).abs() < 1.0e-9);
}

#[test]
fn a_large_arm_has_a_wider_sleeve_where_it_is_set_in_plain() {
    let template = Template::of_id("holoku").unwrap();
    let mut options = Options::of(template);
    let place = template.position("sleeve").unwrap();
    options.set(place, Some(1.0));
    let body = of_row(&bodies::BODIES[2].1);
    let tape = TailorTape::NONE.with_cm(Tailored::UpperArm, Some(40.0));
    let taken = tape.over(body.clone()).unwrap();
    let [own, wide] = [&body, &taken].map(|measures| {
        let pattern = (template.draft)(&Fitting::by(measures), &options).unwrap();
        across(&pattern, "sleeve", "cap")
    });
    assert!(own + 0.005 < wide, "{own} to {wide}");
}
