//! Laws of every template: its outlines are closed, counterclockwise and simple, its seams walk, its
//! numbers are finite, and what cannot be drafted is refused with the measure that is the cause.

#[path = "bodies/any.rs"]
mod any;
mod bodies;

use kurbo::{ParamCurve as _, PathSeg, Point, Shape as _};
use lole_garment::Fitting;
use lole_garment::sketch::{Sketch, SketchStroke};
use lole_garment::template::{OptionKind, Options, Shelf, TEMPLATES, Template};
use lole_geom::Length;
use lole_language::{Bilingual as _, Sentence};
use lole_pattern::pattern::{Amount, SeamKind, SeamSide};
use lole_pattern::piece::{CutCount, Finish, Mark};
use lole_pattern::{DraftError, Measure, Measures, Pattern, Piece, Yardage};
use proptest::prelude::*;

use any::any_body;
use bodies::{BODIES, of_row};

/// How exactly seams walk [m]: a tenth of a millimeter.
const WALK: f64 = 1.0e-4;

fn template(id: &str) -> &'static Template {
    Template::of_id(id).unwrap_or_else(|| panic!("no template {id}"))
}

fn draft(id: &str, measures: &Measures, options: &[(&str, f64)]) -> Result<Pattern, DraftError> {
    let template = template(id);
    let mut chosen = Options::of(template);
    for (key, value) in options {
        let position = template.position(key);
        chosen.set(
            position.unwrap_or_else(|| panic!("no option {key}")),
            Some(*value),
        );
    }
    (template.draft)(&Fitting::by(measures), &chosen)
}

/// Points along a piece's stitching line, every few millimeters, not closed.
fn points(piece: &Piece) -> Vec<Point> {
    let segments = piece.edges.iter().flat_map(|edge| edge.segments.iter());
    let sampled = segments.flat_map(|segment| {
        let count = if matches!(segment, PathSeg::Line(_)) {
            1
        } else {
            24
        };
        (0..count).map(move |index| segment.eval(f64::from(index) / f64::from(count)))
    });
    sampled.collect()
}

fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let side = |line: [Point; 2], at: Point| (line[1] - line[0]).cross(at - line[0]);
    let apart = |x: f64, y: f64| (x < 0.0) != (y < 0.0) && x != 0.0 && y != 0.0;
    apart(side(a, b[0]), side(a, b[1])) && apart(side(b, a[0]), side(b, a[1]))
}

fn check_outline(piece: &Piece) -> Result<(), String> {
    let id = piece.id;
    let mut end = None;
    for edge in &piece.edges {
        for segment in &edge.segments {
            let start = segment.start();
            if let Some(end) = end
                && start != end
            {
                return Err(format!(
                    "{id}: {} begins {start:?} and not {end:?}",
                    edge.id
                ));
            }
            end = Some(segment.end());
        }
        let length = edge.length();
        if !(1.0e-3..100.0).contains(&length) {
            return Err(format!("{id}: {} is {length} m long", edge.id));
        }
        let allowance = edge.allowance.to_m();
        if !(0.0..3.0).contains(&allowance) || (edge.finish == Finish::Fold && allowance != 0.0) {
            return Err(format!(
                "{id}: {} has an allowance of {allowance} m",
                edge.id
            ));
        }
    }
    let first = piece.edges[0].segments[0].start();
    if end != Some(first) {
        return Err(format!("{id} is open"));
    }
    let points = points(piece);
    let next = |index: usize| points[(index + 1) % points.len()];
    if points.iter().any(|point| !point.is_finite()) {
        return Err(format!("{id} is not finite"));
    }
    let area: f64 = (0..points.len())
        .map(|index| 0.5 * points[index].to_vec2().cross(next(index).to_vec2()))
        .sum();
    if area < 1.0e-5 {
        return Err(format!("{id} runs clockwise: {area} m²"));
    }
    for one in 0..points.len() {
        for other in one + 2..points.len() {
            if cross([points[one], next(one)], [points[other], next(other)]) {
                return Err(format!("{id} meets itself at {:?}", points[one]));
            }
        }
    }
    let grain = piece.grain.hypot();
    if 1.0e-9 < (grain - 1.0).abs() {
        return Err(format!("{id}: grain of length {grain}"));
    }
    check_marks(piece)
}

fn check_marks(piece: &Piece) -> Result<(), String> {
    let allowances = piece.edges.iter().map(|edge| edge.allowance.to_m());
    let room = allowances.fold(0.01, f64::max);
    let bounds = piece.stitching_line().bounding_box().inflate(room, room);
    for mark in &piece.marks {
        let inside = match mark {
            Mark::Line { path, .. } => {
                let box_of = path.bounding_box();
                bounds.contains(Point::new(box_of.x0, box_of.y0))
                    && bounds.contains(Point::new(box_of.x1, box_of.y1))
            }
            Mark::Notch { edge, along, .. } => {
                (0.0..=piece.edges[*edge].length() + 1.0e-9).contains(along)
            }
            Mark::Point { at, .. } => bounds.contains(*at),
        };
        if !inside {
            return Err(format!("{}: {mark:?} is outside", piece.id));
        }
    }
    Ok(())
}

fn length_of(pattern: &Pattern, side: &SeamSide) -> Result<f64, String> {
    let piece = pattern
        .pieces
        .get(side.piece)
        .ok_or("a seam without its piece")?;
    let halves = if piece.edges.iter().any(|edge| edge.finish == Finish::Fold) {
        2
    } else {
        1
    };
    if piece.cut.pieces() * halves <= side.copy {
        return Err(format!("{} has no copy {}", piece.id, side.copy));
    }
    let edge = piece
        .edges
        .get(side.edge)
        .ok_or("a seam without its edge")?;
    if edge.finish == Finish::Fold
        || side
            .between
            .iter()
            .any(|share| !(0.0..=1.0).contains(share))
    {
        return Err(format!("{} {}: {:?}", piece.id, edge.id, side.between));
    }
    Ok(edge.length() * (side.between[1] - side.between[0]).abs())
}

fn check_seams(pattern: &Pattern) -> Result<(), String> {
    for (index, seam) in pattern.seams.iter().enumerate() {
        let (flat, full) = (
            length_of(pattern, &seam.flat)?,
            length_of(pattern, &seam.full)?,
        );
        let fits = match seam.kind {
            SeamKind::Plain => (full - flat).abs() < WALK,
            SeamKind::Eased => flat - WALK < full && full < flat * 1.08 + WALK,
            SeamKind::Gathered => flat - WALK < full && full < flat * 5.0,
        };
        if !fits {
            let [one, other] = [seam.flat, seam.full].map(|side| {
                let piece = &pattern.pieces[side.piece];
                format!(
                    "{} {} {:?}",
                    piece.id, piece.edges[side.edge].id, side.between
                )
            });
            return Err(format!(
                "seam {index} {:?}: {one} is {:.2} cm and {other} {:.2} cm",
                seam.kind,
                flat * 100.0,
                full * 100.0
            ));
        }
    }
    Ok(())
}

/// Every edge that is to be sewn is in seams along its whole length, but for mouths of darts, on every
/// copy that is cut.
fn check_sewn(pattern: &Pattern) -> Result<(), String> {
    for (index, piece) in pattern.pieces.iter().enumerate() {
        for (place, edge) in piece.edges.iter().enumerate() {
            let sides = pattern.seams.iter().flat_map(|seam| [seam.flat, seam.full]);
            let own = sides.filter(|side| side.piece == index && side.edge == place);
            let sewn: f64 = own
                .map(|side| (side.between[1] - side.between[0]).abs())
                .sum();
            if (edge.finish == Finish::Seam) != (0.0 < sewn) {
                return Err(format!(
                    "{} {}: {:?} sewn {sewn}",
                    piece.id, edge.id, edge.finish
                ));
            }
        }
    }
    Ok(())
}

fn check_words(pattern: &Pattern) -> Result<(), String> {
    let complete = |sentence: &Sentence| {
        let [japanese, english] = [&sentence.japanese, &sentence.english];
        let numbers = !english.contains("NaN") && !english.contains("inf");
        numbers && !japanese.is_empty() && !english.is_empty() && japanese != english
    };
    for step in &pattern.steps {
        let by_hand = step.by_hand.as_ref().is_none_or(&complete);
        let times = step
            .minutes
            .iter()
            .all(|minutes| *minutes == 0.0 || (0.5..20_000.0).contains(minutes));
        if !complete(&step.by_machine) || !by_hand || !times {
            return Err(format!("{step:?}"));
        }
    }
    for notion in &pattern.notions {
        let there = match notion.amount {
            Amount::Length(length) => (0.01..2000.0).contains(&length.to_m()),
            Amount::Count(count) => 0 < count,
            Amount::Mass(mass) => (1.0e-4..20.0).contains(&mass),
        };
        if !there {
            return Err(format!("{notion:?}"));
        }
    }
    let wrong = pattern.warnings.iter().find(|sentence| !complete(sentence));
    wrong.map_or(Ok(()), |sentence| Err(format!("{sentence:?}")))
}

fn check(pattern: &Pattern) -> Result<(), String> {
    pattern.pieces.iter().try_for_each(check_outline)?;
    check_seams(pattern)?;
    check_sewn(pattern)?;
    check_words(pattern)
}

#[test]
fn every_template_fits_six_dancers() {
    for (name, row) in &BODIES {
        let measures = of_row(row);
        for template in TEMPLATES {
            let pattern = (template.draft)(&Fitting::by(&measures), &Options::of(template));
            let pattern = pattern.unwrap_or_else(|error| panic!("{} {name}: {error}", template.id));
            check(&pattern).unwrap_or_else(|fault| panic!("{} {name}: {fault}", template.id));
        }
    }
}

/// The ends of the range of every option, alone.
#[test]
fn every_option_at_both_ends_drafts_or_is_refused_in_a_sentence() {
    let measures = of_row(&BODIES[2].1);
    for template in TEMPLATES {
        for row in template.options {
            let ends: Vec<f64> = match row.kind {
                OptionKind::Number { min, max, .. } => vec![min, max],
                OptionKind::Count { min, max, .. } => vec![f64::from(min), f64::from(max)],
                OptionKind::Choice(choices) => (0..choices.len()).map(|one| one as f64).collect(),
            };
            for end in ends {
                match draft(template.id, &measures, &[(row.key, end)]) {
                    Ok(pattern) => check(&pattern).unwrap_or_else(|fault| {
                        panic!("{} {} {end}: {fault}", template.id, row.key)
                    }),
                    Err(error) => assert!(!error.japanese().is_empty(), "{error}"),
                }
            }
        }
    }
}

#[test]
fn keys_say_their_unit_and_stand_once() {
    for template in TEMPLATES {
        for (position, row) in template.options.iter().enumerate() {
            let has_unit = match row.kind {
                OptionKind::Number { min, max, default } => {
                    assert!(min < max && default.is_none_or(|usual| (min..=max).contains(&usual)));
                    ["_cm", "_ratio"].iter().any(|unit| row.key.ends_with(unit))
                }
                OptionKind::Count { min, max, default } => {
                    assert!((min..=max).contains(&default));
                    row.key.ends_with("_count")
                }
                OptionKind::Choice(choices) => 1 < choices.len(),
            };
            assert!(has_unit, "{} {}", template.id, row.key);
            assert_eq!(template.position(row.key), Some(position));
            assert!(!["kind", "layer", "fabric", "print"].contains(&row.key));
        }
        let alike = TEMPLATES.iter().filter(|other| other.id == template.id);
        assert_eq!(alike.count(), 1, "{}", template.id);
    }
}

#[test]
fn every_template_stands_on_a_shelf_of_the_menu_and_is_sketched_in_its_square() {
    let shelved = Shelf::ALL.into_iter().flat_map(Shelf::templates);
    assert_eq!(shelved.count(), TEMPLATES.len());
    for template in TEMPLATES {
        let mut sketch = Sketch::default();
        (template.sketch)(&mut sketch);
        let points = sketch.strokes.iter().flat_map(|stroke| match stroke {
            SketchStroke::Line(points) | SketchStroke::Patch(points, _) => points.clone(),
            SketchStroke::Disc([x, y], radius, _) => {
                let lowest = [x - radius, y - radius];
                vec![lowest, [x + radius, y + radius]]
            }
        });
        let all: Vec<f32> = points.flatten().collect();
        assert!(!all.is_empty(), "{} has no sketch", template.id);
        let is_inside = |&at: &f32| (0.0..=1.0).contains(&at);
        assert!(all.iter().all(is_inside), "{}: {all:?}", template.id);
    }
}

/// The published example: hip 91.4, four times around, 75 cm long, three rows.
#[test]
fn the_skirt_of_the_books_is_cut_and_bought_as_they_say() {
    let mut measures = of_row(&BODIES[2].1);
    measures.hip_girth = Length::from_cm(91.4);
    let hem = measures.hip_bone_height.to_cm() - (75.0 - 10.75);
    let pattern = draft("pau-skirt", &measures, &[("hem_height_cm", hem)]);
    let pattern = pattern.unwrap_or_else(|error| panic!("{error}"));
    let [piece] = &pattern.pieces[..] else {
        panic!("{} pieces", pattern.pieces.len());
    };
    let length = |id: &str| piece.edge(id).map_or(0.0, |edge| edge.length());
    let allowance = |id: &str| piece.edge(id).map_or(0.0, |edge| edge.allowance.to_m());
    let height = length("left_end") + allowance("top") + allowance("hem");
    assert!((height - 0.925).abs() < 1.0e-9, "{height}");
    let around = length("hem") + allowance("left_end") + allowance("right_end");
    let bought = Yardage::for_gathered(Length::from_m(around)).imperial;
    assert!((length("hem") - 3.656).abs() < 1.0e-9);
    assert!((bought.to_yd() - 4.0).abs() < 1.0e-9, "{around}");
    // Broadcloth of 110 g/m², 110 cm wide.
    let [bought_kg, cut_kg] = [bought.to_m() * 1.10, around * height].map(|area| area * 0.110);
    assert!((bought_kg - 0.44).abs() < 0.005, "{bought_kg}");
    assert!((cut_kg - 0.37).abs() < 0.005, "{cut_kg}");
}

#[test]
fn templates_have_the_pieces_that_their_garments_have() {
    let measures = of_row(&BODIES[2].1);
    let cut = |id: &str, options: &[(&str, f64)]| -> Vec<(&'static str, u32)> {
        let pattern = draft(id, &measures, options);
        let pattern = pattern.unwrap_or_else(|error| panic!("{id}: {error}"));
        (pattern.pieces.iter())
            .map(|piece| (piece.id, piece.cut.pieces()))
            .collect()
    };
    assert_eq!(cut("pau-skirt", &[]), [("panel", 1)]);
    assert_eq!(cut("pau-top", &[]), [("panel", 1)]);
    assert_eq!(cut("pau-kahiko", &[]), [("panel", 1)]);
    assert_eq!(cut("pau-ruffle", &[]), [("panel", 1), ("ruffle", 2)]);
    assert_eq!(cut("pau-ruffle", &[("ruffle", 2.0)]), [("panel", 1)]);
    for id in ["kikepa", "kihei"] {
        assert_eq!(cut(id, &[]), [("cloth", 1)]);
    }
    assert_eq!(cut("malo", &[]), [("strip", 1)]);
    assert_eq!(cut("ti-leaf-skirt", &[]), []);
    for id in ["raffia-skirt", "cellophane-skirt"] {
        assert_eq!(cut(id, &[]), [("band", 1)]);
    }
    assert_eq!(
        cut("blouse", &[]),
        [("front", 1), ("back", 2), ("sleeve", 2), ("binding", 1)]
    );
    let dress = [
        ("front", 1),
        ("back", 1),
        ("front_yoke", 1),
        ("back_yoke", 1),
    ];
    let rest = [("sleeve", 2), ("binding", 1), ("ruffle", 2)];
    assert_eq!(cut("muumuu", &[]), [&dress[..], &rest[..]].concat());
    assert_eq!(
        cut("muumuu", &[("ruffle_cm", 0.0)]),
        [&dress[..], &rest[..2]].concat()
    );
    let dress = [
        ("front", 1),
        ("back", 2),
        ("front_yoke", 1),
        ("back_yoke", 2),
    ];
    assert_eq!(cut("holoku", &[]), [&dress[..], &rest[..2]].concat());
    assert_eq!(
        cut("hair-flower", &[("flower_count", 2.0)]),
        [("petal", 10)]
    );
    assert_eq!(cut("uliuli", &[]), [("disc", 4)]);
    for id in ["lei", "lei-poo", "kupee", "puili", "ipu"] {
        assert_eq!(cut(id, &[]), []);
    }
}

#[test]
fn a_wrong_measure_is_named() {
    for (id, measure, cm) in [
        ("pau-skirt", Measure::HipGirth, 300.0),
        ("kikepa", Measure::BustGirth, 36.0),
        ("blouse", Measure::FrontLength, 70.0),
        ("blouse", Measure::UpperArmGirth, 60.0),
        ("blouse", Measure::ShoulderBreadth, 19.0),
        ("malo", Measure::CrotchLength, f64::NAN),
    ] {
        let mut measures = of_row(&BODIES[2].1);
        *measure.of_mut(&mut measures) = Length::from_cm(cm);
        let error = draft(id, &measures, &[]).err();
        let error = error.unwrap_or_else(|| panic!("{id} takes {measure:?} of {cm}"));
        let words = measure.words();
        assert!(
            error.to_string().contains(words.english),
            "{id} {measure:?}: {error}"
        );
        assert!(
            error.japanese().contains(words.japanese),
            "{}",
            error.japanese()
        );
    }
}

#[test]
fn a_wrong_option_is_named_with_its_range() {
    let measures = of_row(&BODIES[2].1);
    for (value, said) in [(99.0, "puff_ratio is 99"), (f64::NAN, "puff_ratio is NaN")] {
        let error = draft("blouse", &measures, &[("puff_ratio", value)]).err();
        let error = error.unwrap_or_else(|| panic!("{value} was taken"));
        assert!(error.to_string().starts_with(said), "{error}");
        assert!(error.to_string().contains("from 1.1 to 2.2"), "{error}");
    }
}

/// On a small body a low neckline reaches the yoke's line; the largest that is named can be cut.
#[test]
fn a_neckline_below_the_yoke_is_refused_with_one_that_fits() {
    let measures = of_row(&BODIES[0].1);
    let error = draft("muumuu", &measures, &[("neck_lower_cm", 9.9)]).err();
    let Some(DraftError::Option { key, max, .. }) = error else {
        panic!("{error:?}");
    };
    assert_eq!(key, "neck_lower_cm");
    let pattern = draft("muumuu", &measures, &[("neck_lower_cm", max)]);
    let pattern = pattern.unwrap_or_else(|error| panic!("{max}: {error}"));
    assert!(check(&pattern).is_ok());
}

/// A cap is as long as the armhole, times what was asked.
#[test]
fn the_cap_of_a_sleeve_is_as_full_as_was_asked() {
    for (_, row) in &BODIES {
        let measures = of_row(row);
        for ratio in [1.1, 1.5, 2.2] {
            let pattern = draft("blouse", &measures, &[("puff_ratio", ratio)]);
            let pattern = pattern.unwrap_or_else(|error| panic!("{error}"));
            let edge = |piece: &str, id: &str| {
                let piece = pattern.pieces.iter().find(|one| one.id == piece);
                piece
                    .and_then(|piece| piece.edge(id))
                    .map_or(0.0, |edge| edge.length())
            };
            let armhole = edge("front", "armhole") + edge("back", "armhole");
            assert!((edge("sleeve", "cap") - ratio * armhole).abs() < WALK);
        }
    }
}

/// The numbers that makers give: 50 plumeria to a meter of lei, 100 leaves and a cord of the girth and ten
/// inches to a skirt, a kīkepa of about two yards, a malo of three to six.
#[test]
fn materials_are_those_that_makers_give() {
    let measures = of_row(&BODIES[2].1);
    let drafted = |id: &str, options: &[(&str, f64)]| {
        draft(id, &measures, options).unwrap_or_else(|error| panic!("{id}: {error}"))
    };
    let lei = drafted("lei", &[("length_cm", 101.6)]);
    assert_eq!(lei.notions[0].amount, Amount::Count(51));
    let skirt = drafted("ti-leaf-skirt", &[]);
    let Amount::Count(leaves) = skirt.notions[0].amount else {
        panic!("{:?}", skirt.notions[0]);
    };
    assert!((85..=110).contains(&leaves), "{leaves}");
    let long = |pattern: &Pattern| {
        let bounds = pattern.pieces[0].stitching_line().bounding_box();
        Length::from_m(bounds.width()).to_yd()
    };
    let kikepa = long(&drafted("kikepa", &[]));
    assert!((kikepa - 2.0).abs() < 0.05, "{kikepa}");
    let malo = long(&drafted("malo", &[]));
    assert!((3.0..6.0).contains(&malo), "{malo}");
}

#[test]
fn pairs_are_two_pieces() {
    assert_eq!(CutCount::Pairs(2).pieces(), 4);
    assert_eq!(CutCount::Alike(3).pieces(), 3);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn seams_walk_and_outlines_are_simple_on_any_body(row in any_body()) {
        let measures = of_row(&row);
        for template in TEMPLATES {
            match (template.draft)(&Fitting::by(&measures), &Options::of(template)) {
                Ok(pattern) => {
                    let checked = check(&pattern);
                    prop_assert!(checked.is_ok(), "{}: {}", template.id, checked.unwrap_err());
                }
                Err(error) => prop_assert!(false, "{}: {error}", template.id),
            }
        }
    }

    #[test]
    fn any_options_draft_or_are_refused(body in 0..6_usize, shares in proptest::collection::vec(0.0..1.0_f64, 12)) {
        let measures = of_row(&BODIES[body].1);
        for template in TEMPLATES {
            let mut options = Options::of(template);
            for (position, (row, share)) in template.options.iter().zip(&shares).enumerate() {
                options.set(position, Some(match row.kind {
                    OptionKind::Number { min, max, .. } => min + share * (max - min),
                    OptionKind::Count { min, max, .. } => {
                        (f64::from(min) + share * f64::from(max - min)).round()
                    }
                    OptionKind::Choice(choices) => (share * (choices.len() - 1) as f64).round(),
                }));
            }
            if let Ok(pattern) = (template.draft)(&Fitting::by(&measures), &options) {
                let checked = check(&pattern);
                prop_assert!(checked.is_ok(), "{}: {} {options:?}", template.id, checked.unwrap_err());
            }
        }
    }
}
