//! Laws of seams as they are pinned: both sides are marked where they meet, and from notch to notch they
//! differ in length by the ease or the gathers that are said of that stretch, and by nothing else.

#[path = "bodies/any.rs"]
mod any;
mod bodies;

use kurbo::{ParamCurve as _, ParamCurveArclen as _, Point};
use lole_garment::Fitting;
use lole_garment::template::{OptionKind, Options, TEMPLATES, Template};
use lole_pattern::pattern::{Seam, SeamKind, SeamSide};
use lole_pattern::piece::{Edge, Finish, LineKind, Mark};
use lole_pattern::{Alteration, Alterations, Pattern, Piece, TailorTape, Tailored};
use proptest::prelude::*;

use any::any_body;
use bodies::{BODIES, of_row};

/// Places nearer than this are pinned together [m]: a tenth of a millimeter.
const PINNED: f64 = 1.0e-4;
/// Rows of gathering are run this far from the stitching line, at most [m].
const BESIDE: f64 = 6.0e-3;

/// Notches of an edge: how far each is from its beginning [m], and whether it is double.
fn notches(piece: &Piece, wanted: usize) -> Vec<(f64, bool)> {
    let marks = piece.marks.iter();
    let mut found: Vec<(f64, bool)> = marks
        .filter_map(|mark| match mark {
            Mark::Notch {
                edge,
                along,
                is_double,
            } if *edge == wanted => Some((*along, *is_double)),
            _ => None,
        })
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

/// Notches strictly within one side of a seam, as far as they are from where it begins [m], and its end.
fn pins(pattern: &Pattern, side: &SeamSide) -> (Vec<(f64, bool)>, f64) {
    let piece = &pattern.pieces[side.piece];
    let whole = piece.edges[side.edge].length();
    let [from, to] = side.between.map(|share| share * whole);
    let long = (to - from).abs();
    let walked = notches(piece, side.edge).into_iter();
    let mut walked: Vec<(f64, bool)> = walked
        .map(|(along, is_double)| ((along - from) * (to - from).signum(), is_double))
        .filter(|(along, _)| PINNED < *along && *along < long - PINNED)
        .collect();
    walked.sort_by(|a, b| a.0.total_cmp(&b.0));
    (walked, long)
}

/// From notch to notch and to the ends of the seam.
fn check_walk(pattern: &Pattern, seam: &Seam) -> Result<(), String> {
    let ((flat, flat_end), (full, full_end)) =
        (pins(pattern, &seam.flat), pins(pattern, &seam.full));
    if flat.len() != full.len() {
        return Err(format!("{} notches meet {}", flat.len(), full.len()));
    }
    // What is said of the whole stretch holds between any two pins of it.
    let stated = match seam.kind {
        SeamKind::Plain => 1.0,
        SeamKind::Eased | SeamKind::Gathered => full_end / flat_end,
    };
    let ends = [(flat_end, false), (full_end, false)];
    let pairs = flat.iter().zip(&full).chain([(&ends[0], &ends[1])]);
    let mut last = [0.0; 2];
    for (&(flat, one), &(full, other)) in pairs {
        let [short, long] = [flat - last[0], full - last[1]];
        if PINNED < (long - stated * short).abs() {
            let [short, long] = [short * 100.0, long * 100.0];
            return Err(format!(
                "{short:.2} cm meet {long:.2} cm, {stated:.3} times as much is said"
            ));
        }
        if one != other {
            return Err("a double notch meets a single one".to_owned());
        }
        last = [flat, full];
    }
    Ok(())
}

/// Stretches of an edge that are gathered onto something, joined where they touch [m].
fn gathered_stretches(pattern: &Pattern, piece: usize, edge: usize) -> Vec<[f64; 2]> {
    let whole = pattern.pieces[piece].edges[edge].length();
    let seams = pattern.seams.iter();
    let mut found: Vec<[f64; 2]> = seams
        .filter(|seam| {
            seam.kind == SeamKind::Gathered && (seam.full.piece, seam.full.edge) == (piece, edge)
        })
        .map(|seam| {
            let [from, to] = seam.full.between;
            [from.min(to) * whole, from.max(to) * whole]
        })
        .collect();
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for stretch in found {
        match joined.last_mut() {
            Some(last) if stretch[0] <= last[1] + PINNED => last[1] = last[1].max(stretch[1]),
            _ => joined.push(stretch),
        }
    }
    joined
}

/// Ends of the rows that are marked to be gathered.
fn gathering_rows(piece: &Piece) -> Vec<[Point; 2]> {
    let marks = piece.marks.iter();
    marks
        .filter_map(|mark| match mark {
            Mark::Line {
                kind: LineKind::Gather,
                path,
            } => {
                let points = path.elements().iter().filter_map(kurbo::PathEl::end_point);
                let points: Vec<Point> = points.collect();
                Some([*points.first()?, *points.last()?])
            }
            _ => None,
        })
        .collect()
}

/// Rows are marked along what is gathered, and along nothing else.
fn check_gathers(pattern: &Pattern, piece: usize) -> Result<(), String> {
    let drawn = &pattern.pieces[piece];
    let rows = gathering_rows(drawn);
    let mut met = 0;
    for (index, edge) in drawn.edges.iter().enumerate() {
        for [from, to] in gathered_stretches(pattern, piece, index) {
            let ends = [point(edge, from), point(edge, to)];
            let is_of = |row: &[Point; 2]| {
                let apart = |a: usize, b: usize| ends[a].distance(row[b]) < BESIDE;
                apart(0, 0) && apart(1, 1) || apart(0, 1) && apart(1, 0)
            };
            if !rows.iter().any(is_of) {
                let [from, to] = [from * 100.0, to * 100.0];
                return Err(format!(
                    "{} {} is gathered from {from:.1} to {to:.1} cm and marked elsewhere",
                    drawn.id, edge.id
                ));
            }
            met += 1;
        }
    }
    // What is gathered onto a line within a piece, or onto itself, is sewn by no seam of two edges.
    if 0 < met && met != rows.len() {
        return Err(format!("{}: {met} of {} rows", drawn.id, rows.len()));
    }
    Ok(())
}

/// Where a seam begins or ends there is a corner of the cloth or a notch; the middle of a piece on the fold
/// is no corner.
fn check_ends(pattern: &Pattern, side: &SeamSide) -> Result<(), String> {
    let piece = &pattern.pieces[side.piece];
    let whole = piece.edges[side.edge].length();
    let count = piece.edges.len();
    let is_fold = |edge: usize| piece.edges[edge].finish == Finish::Fold;
    for along in side.between.map(|share| share * whole) {
        let is_corner = if along < PINNED {
            !is_fold((side.edge + count - 1) % count)
        } else {
            whole - PINNED < along && !is_fold((side.edge + 1) % count)
        };
        let notched = notches(piece, side.edge).into_iter();
        let is_notched = notched
            .into_iter()
            .any(|one| (one.0 - along).abs() < PINNED);
        if !is_corner && !is_notched {
            return Err(format!(
                "{} {} has no mark at {:.1} cm",
                piece.id,
                piece.edges[side.edge].id,
                along * 100.0
            ));
        }
    }
    Ok(())
}

/// No seam of a hand's length is unmarked between its ends, and no gathers are left to guessing.
fn check_marked(pattern: &Pattern, seam: &Seam) -> Result<(), String> {
    check_ends(pattern, &seam.flat)?;
    check_ends(pattern, &seam.full)?;
    let (marks, end) = pins(pattern, &seam.flat);
    // A mark that is there already stands in for one that would be 2.5 cm from it, at either end.
    let (longest, apart) = match seam.kind {
        SeamKind::Gathered => (0.12, 0.25 + 0.05),
        SeamKind::Plain | SeamKind::Eased => (0.15, 0.40 + 0.05),
    };
    if marks.is_empty() && longest < end {
        return Err(format!("{:.1} cm without a mark", end * 100.0));
    }
    let places: Vec<f64> = std::iter::once(0.0)
        .chain(marks.iter().map(|mark| mark.0))
        .chain([end])
        .collect();
    let widest = places
        .windows(2)
        .map(|two| two[1] - two[0])
        .fold(0.0, f64::max);
    if apart < widest {
        return Err(format!("{:.1} cm from mark to mark", widest * 100.0));
    }
    Ok(())
}

/// Legs of darts that open at an edge are marked there, and no two other notches are taken for one.
fn check_piece(piece: &Piece) -> Result<(), String> {
    for (index, edge) in piece.edges.iter().enumerate() {
        let found = notches(piece, index);
        let legs = legs_on(piece, edge);
        let is_near = |place: f64| move |other: &f64| (place - other).abs() < 2.0e-3;
        for &leg in &legs {
            if !found.iter().any(|one| is_near(leg)(&one.0)) {
                return Err(format!(
                    "{} {}: a dart without its notch",
                    piece.id, edge.id
                ));
            }
        }
        let is_mouth = |one: &(f64, bool)| legs.iter().any(is_near(one.0));
        let close = found
            .windows(2)
            .find(|two| two[1].0 - two[0].0 < NEAR && !two.iter().all(is_mouth));
        if let Some(two) = close {
            return Err(format!("{} {}: {two:?}", piece.id, edge.id));
        }
    }
    Ok(())
}

/// Where legs of darts begin along an edge [m]: at corners of it.
fn legs_on(piece: &Piece, edge: &Edge) -> Vec<f64> {
    let legs = dart_ends(piece);
    let mut passed = 0.0;
    let mut found = Vec::new();
    for segment in &edge.segments {
        if legs
            .iter()
            .any(|leg| leg.distance(segment.start()) < 1.0e-3)
        {
            found.push(passed);
        }
        passed += segment.arclen(1.0e-6);
    }
    found
}

/// Notches of one edge are farther apart than this [m].
const NEAR: f64 = 8.0e-3;

fn point(edge: &Edge, along: f64) -> Point {
    edge.place(along).map_or(Point::ZERO, |(at, _)| at)
}

/// Where the legs of straight darts begin.
fn dart_ends(piece: &Piece) -> Vec<Point> {
    let marks = piece.marks.iter();
    marks
        .filter_map(|mark| match mark {
            Mark::Line {
                kind: LineKind::Dart,
                path,
            } if path.elements().len() == 2 => path.elements()[0].end_point(),
            _ => None,
        })
        .collect()
}

fn check(pattern: &Pattern) -> Result<(), String> {
    pattern.pieces.iter().try_for_each(check_piece)?;
    for (index, seam) in pattern.seams.iter().enumerate() {
        let checked = check_walk(pattern, seam).and_then(|()| check_marked(pattern, seam));
        checked.map_err(|fault| {
            let [one, other] = [seam.flat, seam.full].map(|side| {
                let piece = &pattern.pieces[side.piece];
                format!(
                    "{} {} {:?}",
                    piece.id, piece.edges[side.edge].id, side.between
                )
            });
            format!("seam {index} {:?}, {one} to {other}: {fault}", seam.kind)
        })?;
    }
    (0..pattern.pieces.len()).try_for_each(|piece| check_gathers(pattern, piece))
}

fn drafted(template: &Template, row: &[f64; 27], options: &Options) -> Option<Pattern> {
    (template.draft)(&Fitting::by(&of_row(row)), options).ok()
}

/// Every choice of a template, one at a time; the rest as usual.
fn variants(template: &'static Template) -> Vec<Options> {
    let usual = Options::of(template);
    let mut found = vec![usual.clone()];
    for (position, row) in template.options.iter().enumerate() {
        if let OptionKind::Choice(choices) = row.kind {
            found.extend((1..choices.len()).map(|choice| {
                let mut options = usual.clone();
                options.set(position, Some(choice as f64));
                options
            }));
        }
    }
    found
}

#[test]
fn every_choice_of_every_template_is_marked_and_walks_from_notch_to_notch() {
    for (name, row) in &BODIES {
        for template in TEMPLATES {
            for options in variants(template) {
                let pattern = drafted(template, row, &options);
                let pattern = pattern.unwrap_or_else(|| panic!("{} {name}", template.id));
                check(&pattern).unwrap_or_else(|fault| panic!("{} {name}: {fault}", template.id));
            }
        }
    }
}

/// From the underarm to its notch a cap is as long as the armhole, however full it is.
#[test]
fn below_its_notches_a_cap_is_as_long_as_the_armhole() {
    for (name, row) in &BODIES {
        for ratio in [1.1, 1.5, 2.2] {
            let template = Template::of_id("blouse").unwrap_or_else(|| panic!("no blouse"));
            let mut options = Options::of(template);
            let position = template.position("puff_ratio");
            options.set(position.unwrap_or_else(|| panic!("no puff")), Some(ratio));
            let pattern = drafted(template, row, &options);
            let pattern = pattern.unwrap_or_else(|| panic!("{name} {ratio}"));
            let [front, back, sleeve] = [0, 1, 2].map(|piece| &pattern.pieces[piece]);
            let cap = notches(sleeve, 2);
            let whole = sleeve.edges[2].length();
            let of = |piece: &Piece| notches(piece, 2)[0];
            let doubles: Vec<f64> = cap.iter().filter(|one| one.1).map(|one| one.0).collect();
            let last = cap[cap.len() - 1].0;
            assert_eq!([of(front).1, of(back).1], [false, true], "{name}");
            assert!((doubles[0] - of(back).0).abs() < PINNED, "{name} {ratio}");
            assert!(
                (whole - last - of(front).0).abs() < PINNED,
                "{name} {ratio}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn seams_are_marked_and_walk_from_notch_to_notch_on_any_body(row in any_body()) {
        for template in TEMPLATES {
            let pattern = drafted(template, &row, &Options::of(template));
            prop_assert!(pattern.is_some(), "{} is not drafted", template.id);
            let checked = pattern.as_ref().map_or(Ok(()), check);
            prop_assert!(checked.is_ok(), "{}: {}", template.id, checked.unwrap_err());
        }
    }

    #[test]
    fn seams_walk_however_a_garment_is_altered(
        row in any_body(),
        shares in proptest::collection::vec(0.0..1.0_f64, Alteration::ALL.len()),
    ) {
        let measures = of_row(&row);
        let altered = Alteration::ALL.into_iter().zip(shares);
        let alterations = altered.fold(Alterations::NONE, |all, (one, share)| {
            let [least, most] = one.band_cm();
            all.with_cm(one, least + share * (most - least))
        });
        let fitting = Fitting { alterations, ..Fitting::by(&measures) };
        for template in TEMPLATES {
            // Measures and alterations may exclude each other, and are then refused by name.
            if let Ok(pattern) = (template.draft)(&fitting, &Options::of(template)) {
                let checked = check(&pattern);
                prop_assert!(checked.is_ok(), "{}: {}", template.id, checked.unwrap_err());
            }
        }
    }

    #[test]
    fn seams_walk_whatever_was_taken_of_her(
        row in any_body(),
        shares in proptest::collection::vec(proptest::option::of(0.0..1.0_f64), Tailored::ALL.len()),
    ) {
        let body = of_row(&row);
        let taken = Tailored::ALL.into_iter().zip(shares);
        let taken = taken.fold(TailorTape::NONE, |all, (one, share)| {
            let [least, most] = one.room_cm(one.measure().of(&body).to_cm());
            all.with_cm(one, share.map(|share| least + share * (most - least)))
        });
        let measures = taken.over(body);
        prop_assert!(measures.is_ok(), "{measures:?}");
        let measures = measures.unwrap();
        for template in TEMPLATES {
            // Measures may exclude each other, and are then refused by name.
            if let Ok(pattern) = (template.draft)(&Fitting::by(&measures), &Options::of(template)) {
                let checked = check(&pattern);
                prop_assert!(checked.is_ok(), "{}: {}", template.id, checked.unwrap_err());
            }
        }
    }
}
