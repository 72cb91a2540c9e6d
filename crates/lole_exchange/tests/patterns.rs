//! What is read of patterns and measures, what is refused and how, and that what is written comes back.

use glam::DVec2;
use kurbo::ParamCurve as _;
use lole_body::{Dancer, Measure, Measurements};
use lole_exchange::{ExchangeError, PatternInspection, flat, garmentcode, measures};
use lole_garment::given::Origin;
use lole_garment::{Fitting, Given, Options, TEMPLATES, template};
use lole_language::Bilingual;
use lole_pattern::Pattern;
use lole_pattern::pattern::SeamKind;
use lole_pattern::piece::Finish;
use proptest::prelude::*;

/// A skirt of two panels of our own, in millimeters, with every kind of edge.
const SKIRT: &str = include_str!("skirt.json");

fn read(text: &str) -> Result<Given, ExchangeError> {
    garmentcode::read(text.as_bytes())
}

/// The skirt with a part of its text changed.
fn changed(from: &str, to: &str) -> Result<Given, ExchangeError> {
    assert!(SKIRT.contains(from), "{from}");
    read(&SKIRT.replacen(from, to, 1))
}

fn refused(result: Result<Given, ExchangeError>, place: &str) {
    let error = result.expect_err(place);
    let english = error.to_string();
    assert!(english.starts_with(place), "{english}");
    assert!(!english.contains('\n'), "{english}");
    assert_ne!(error.japanese(), english);
}

#[test]
fn what_is_larger_than_a_pattern_may_be_is_not_read_as_one() {
    let skirt = include_str!("skirt.json");
    assert!(garmentcode::is_specification(skirt.as_bytes()));
    let padded = format!("{skirt}{}", " ".repeat(garmentcode::MOST_BYTES));
    assert!(!garmentcode::is_specification(padded.as_bytes()));
}

#[test]
fn panels_edges_and_stitches_are_read_in_their_unit() {
    let given = read(SKIRT).unwrap();
    let names: Vec<&str> = given
        .panels
        .iter()
        .map(|panel| panel.name.as_str())
        .collect();
    assert_eq!(names, ["back", "front"]);
    assert_eq!(given.origin, Origin::Floor);
    let [back, front] = &given.pattern.pieces[..] else {
        panic!("two pieces");
    };
    assert_eq!(front.edges.len(), 4);
    // An arc of 60 cm with a radius of 150 cm: 2 r asin(c / 2 r).
    let arc = 2.0 * 1.5 * lole_geom::trig64::asin(0.6 / 3.0);
    assert!((front.edges[0].length() - arc).abs() < 1.0e-6);
    // It bulges to the right of its way: below the chord of the hem.
    let lowest = front.edges[0]
        .segments
        .iter()
        .map(|it| it.eval(1.0).y.min(it.eval(0.5).y));
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    let depth = 1.5 - (1.5_f64 * 1.5 - 0.3 * 0.3).sqrt();
    assert!((lowest + 0.5 + depth).abs() < 1.0e-4, "{lowest}");
    assert!((back.edges[2].length() - 0.48).abs() < 1.0e-9);
    let seams = &given.pattern.seams;
    assert_eq!(seams.len(), 2);
    assert!(seams.iter().all(|seam| seam.kind != SeamKind::Gathered));
    let corner = given.panels[0].place(DVec2::new(-0.3, -0.5));
    assert!(
        corner.abs_diff_eq(glam::DVec3::new(0.3, 0.45, -0.2), 1.0e-9),
        "{corner}"
    );
}

/// Edges that are sewn run against each other: the hem's corners meet, and the waist's.
#[test]
fn ends_meet_so_that_the_right_side_stays_right() {
    let given = read(SKIRT).unwrap();
    for seam in &given.pattern.seams {
        let ends = [seam.flat, seam.full].map(|side| {
            let edge = &given.pattern.pieces[side.piece].edges[side.edge];
            let [from, to] = edge.ends();
            if side.between[0] < side.between[1] {
                [from.y, to.y]
            } else {
                [to.y, from.y]
            }
        });
        for (one, other) in ends[0].into_iter().zip(ends[1]) {
            assert!((one - other).abs() < 0.1, "{ends:?}");
        }
    }
    assert!(given.notes.is_empty(), "{:?}", given.notes);
    let turned = changed(
        r#"{"panel": "back", "edge": 3}]"#,
        r#"{"panel": "back", "edge": 3}, "right_wrong"]"#,
    );
    // Where the panels lie contradicts it, and that is told.
    assert_eq!(turned.unwrap().notes.len(), 1);
}

#[test]
fn what_cannot_be_sewn_is_refused_with_its_place() {
    refused(read("no"), "this is no JSON");
    refused(read("[]"), "{}");
    refused(
        changed("\"units_in_meter\": 1000", "\"units_in_meter\": 0"),
        "properties.units_in_meter",
    );
    refused(
        changed("\"units_in_meter\": 1000", "\"units_in_meter\": 20"),
        "pattern.panels.back.vertices",
    );
    refused(
        changed("\"units_in_meter\": 1000", "\"units_in_meter\": 1e9"),
        "properties.units_in_meter",
    );
    refused(changed("[-300, -500]", "[-300, 1e999]"), "this is no JSON");
    refused(
        changed("[-300, -500]", "[-300, null]"),
        "pattern.panels.front.vertices[0]",
    );
    refused(
        changed("[-300, -500]", "[-300]"),
        "pattern.panels.front.vertices[0]",
    );
    refused(
        changed("\"endpoints\": [0, 1]", "\"endpoints\": [0, 7]"),
        "pattern.panels.front.edges[0]",
    );
    refused(
        changed("\"endpoints\": [0, 1]", "\"endpoints\": [0, 2]"),
        "pattern.panels.front.edges[0]",
    );
    refused(
        changed("\"circle\"", "\"spiral\""),
        "pattern.panels.front.edges[0].curvature.type",
    );
    refused(
        changed("[1500, 0, 1]", "[150, 0, 1]"),
        "pattern.panels.front.edges[0].curvature.params",
    );
    refused(
        changed("[[0.5, 0.02]]", "[[0.5, 9]]"),
        "pattern.panels.front.edges",
    );
    refused(
        changed(
            "{\"panel\": \"back\", \"edge\": 3}",
            "{\"panel\": \"side\", \"edge\": 3}",
        ),
        "pattern.stitches[0].panel",
    );
    refused(
        changed(
            "{\"panel\": \"back\", \"edge\": 3}",
            "{\"panel\": \"back\", \"edge\": 9}",
        ),
        "pattern.stitches[0].edge",
    );
    refused(
        changed(
            "{\"panel\": \"back\", \"edge\": 3}",
            "{\"panel\": \"back\", \"edge\": 1}",
        ),
        "pattern.stitches[1]",
    );
    refused(
        changed("\"rotation\": [0, 0, 0]", "\"rotation\": [0, 0]"),
        "pattern.panels.front.rotation",
    );
    refused(
        changed("\"front\": {", "\"front\\u0007\": {"),
        "pattern.panels",
    );
    let deep = "[".repeat(100_000);
    refused(read(&deep), "this is no JSON");
    let large = vec![b' '; garmentcode::MOST_BYTES + 1];
    refused(garmentcode::read(&large), "the file has");
}

#[test]
fn what_a_file_leaves_open_is_told() {
    let given = changed(", \"units_in_meter\": 1000", "");
    assert_eq!(given.unwrap().notes.len(), 1);
    let trunk = SKIRT.replace("950", "-350");
    let given = read(&trunk).unwrap();
    assert_eq!(given.origin, Origin::Trunk);
    assert_eq!(given.notes.len(), 1);
}

#[test]
fn a_pattern_is_drawn_and_told() {
    let given = read(SKIRT).unwrap();
    let svg = flat::svg(&given);
    assert_eq!(svg.matches("text-anchor").count(), 4);
    assert!(svg.contains(">1 back</text>") && svg.contains(">2 front</text>"));
    let found = PatternInspection::new(&given);
    assert_eq!((found.panels.len(), found.stitches.len()), (2, 2));
    let expected = 0.5 * (0.6 + 0.4) * 0.5 + 0.5 * (0.6 + 0.48) * 0.5;
    assert!(
        (found.cloth_area_m2 - expected).abs() < 0.05,
        "{}",
        found.cloth_area_m2
    );
    assert!(
        found
            .lines()
            .iter()
            .all(|line| line.english != line.japanese)
    );
}

/// Points along the outline of every panel that a pattern is cut into, by the panel.
fn outlines(pattern: &Pattern) -> Vec<Vec<DVec2>> {
    let mut outlines = Vec::new();
    for piece in &pattern.pieces {
        let is_folded = piece.edges.iter().any(|edge| edge.finish == Finish::Fold);
        for copy in 0..piece.cut.pieces() {
            let is_mirrored = matches!(piece.cut, lole_pattern::piece::CutCount::Pairs(_))
                && !copy.is_multiple_of(2)
                && !is_folded;
            let whole = if is_mirrored {
                piece.mirrored()
            } else {
                piece.unfolded()
            };
            outlines.push(corners(&whole));
        }
    }
    outlines
}

fn corners(piece: &lole_pattern::Piece) -> Vec<DVec2> {
    let segments = piece.edges.iter().flat_map(|edge| &edge.segments);
    let points = segments.flat_map(|segment| [0.0, 0.25, 0.5, 0.75].map(|t| segment.eval(t)));
    points.map(|point| DVec2::new(point.x, point.y)).collect()
}

/// How far a point lies from the outline of a piece [m].
fn distance(piece: &lole_pattern::Piece, point: DVec2) -> f64 {
    use kurbo::ParamCurveNearest as _;
    let at = kurbo::Point::new(point.x, point.y);
    let segments = piece.edges.iter().flat_map(|edge| &edge.segments);
    let distances = segments.map(|segment| segment.nearest(at, 1.0e-9).distance_sq);
    distances.fold(f64::INFINITY, f64::min).sqrt()
}

/// Every garment of ours that is cut from cloth, written for others and read back: the same outlines within a
/// hundredth of a millimeter, and every seam.
#[test]
fn what_is_written_comes_back() {
    let dancer = Dancer::new(&Measurements::woman()).unwrap();
    let measures = lole_garment::measures(&dancer);
    let waist = measures.waist_height.to_m();
    for template in TEMPLATES
        .iter()
        .filter(|it| it.is_sewn() || it.id.starts_with("pau-"))
    {
        let template: &template::Template = template;
        let fitting = Fitting {
            dancer: Some(&dancer),
            ..Fitting::by(&measures)
        };
        let Ok(pattern) = (template.draft)(&fitting, &Options::of(template)) else {
            continue;
        };
        let text = garmentcode::write(&pattern, waist);
        let given = read(&text).unwrap_or_else(|error| panic!("{}: {error}", template.id));
        let before = outlines(&pattern);
        assert_eq!(before.len(), given.panels.len(), "{}", template.id);
        for outline in &before {
            let worst = |piece: &lole_pattern::Piece| {
                outline
                    .iter()
                    .map(|point| distance(piece, *point))
                    .fold(0.0, f64::max)
            };
            let nearest = given
                .pattern
                .pieces
                .iter()
                .map(worst)
                .fold(f64::INFINITY, f64::min);
            assert!(nearest < 1.0e-5, "{}: {nearest}", template.id);
        }
        let sewn = |pattern: &Pattern| -> f64 {
            pattern
                .seams
                .iter()
                .map(|seam| seam.full.length(&pattern.pieces))
                .sum()
        };
        let [written, back] = [sewn(&pattern), sewn(&given.pattern)];
        assert!(
            (written - back).abs() < 1.0e-3 * written.max(1.0),
            "{}: {written} {back}",
            template.id
        );
    }
}

#[test]
fn measures_of_others_become_a_dancers() {
    let garmentcode = "body:\n  height: 166.194\n  bust: 97.4\n  waist: 80.3 # cm\n  hips: 104.1\n  head_l: 25.5\n  waist_line: 35.8\n  wrist: 15.9\n";
    let body = measures::read(garmentcode.as_bytes()).unwrap();
    let of = |body: &measures::BodyMeasures, measure: Measure| {
        let found = body.measures.iter().find(|taken| taken.measure == measure);
        found.map(|taken| taken.cm)
    };
    assert_eq!(body.format, "GarmentCode");
    assert_eq!(of(&body, Measure::Hip), Some(104.1));
    assert!((of(&body, Measure::WaistHeight).unwrap() - 104.894).abs() < 1.0e-9);
    assert_eq!(body.unused, ["wrist"]);
    let set =
        r#"{"name": "x", "measies": {"chest": 925, "seat": 1010, "hips": 900, "waist": 750}}"#;
    let body = measures::read(set.as_bytes()).unwrap();
    assert_eq!(body.format, "FreeSewing");
    assert_eq!(of(&body, Measure::Bust), Some(92.5));
    assert_eq!(of(&body, Measure::HighHip), Some(90.0));
    let smis = "<?xml version=\"1.0\"?><smis><unit>inch</unit><body-measurements><m name=\"hip_circ\" value=\"36\"/><m name=\"bust_circ\" value=\"hip_circ/2\"/></body-measurements></smis>";
    let body = measures::read(smis.as_bytes()).unwrap();
    assert!((of(&body, Measure::Hip).unwrap() - 91.44).abs() < 1.0e-9);
    assert_eq!(of(&body, Measure::Bust), None);
    for wrong in [
        "",
        "hello",
        "<a>",
        "{}",
        "body:\n  bust: 974",
        "<smis><unit>ell</unit></smis>",
        "<smis><unit>two\nlines\t</unit></smis>",
    ] {
        let error = measures::read(wrong.as_bytes()).unwrap_err();
        assert!(!error.to_string().contains('\n'));
        assert_ne!(error.japanese(), error.to_string());
    }
}

/// Real patterns, where the folder of samples is there.
#[test]
#[expect(clippy::print_stderr, reason = "a test says why it is skipped")]
fn sample_patterns_are_read() {
    let folder = std::env::var("LOLE_ASSETS").unwrap_or_default();
    let folder = std::path::Path::new(&folder).join("patterns");
    let samples = [
        ("garmentcode_dress_pencil.json", [6, 23]),
        ("garmentcode_shirt.json", [8, 18]),
        ("generator_skirt_2_panels.json", [2, 4]),
        ("generator_skirt_8_panels.json", [8, 16]),
        ("generator_skirt_waistband.json", [4, 6]),
        ("generator_tee.json", [6, 12]),
    ];
    for (name, counts) in samples {
        let bytes = match std::fs::read(folder.join(name)) {
            Ok(bytes) => bytes,
            Err(error) => {
                eprintln!("skipped: LOLE_ASSETS names no folder with patterns/{name} ({error})");
                continue;
            }
        };
        let given = garmentcode::read(&bytes).unwrap();
        assert_eq!(
            [given.panels.len(), given.pattern.seams.len()],
            counts,
            "{name}"
        );
    }
}

proptest! {
    /// Any bytes are a pattern, or one sentence.
    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        for error in [garmentcode::read(&bytes).err(), measures::read(&bytes).err()].into_iter().flatten() {
            prop_assert!(!error.to_string().contains('\n'));
        }
    }

    /// A pattern with a number replaced is a pattern of finite places, or one sentence.
    #[test]
    fn any_number_is_read_or_refused(place in 0..60_usize, number in any::<f64>()) {
        let mut left = place;
        let mut text = String::new();
        let mut word = String::new();
        for letter in SKIRT.chars() {
            if letter.is_ascii_digit() || "-.".contains(letter) {
                word.push(letter);
                continue;
            }
            if !word.is_empty() {
                if left == 0 {
                    text.push_str(&format!("{number:e}"));
                } else {
                    text.push_str(&word);
                }
                left = left.wrapping_sub(1);
                word.clear();
            }
            text.push(letter);
        }
        match read(&text) {
            Ok(given) => {
                let points = given.pattern.pieces.iter().flat_map(corners);
                prop_assert!(points.into_iter().all(|point| point.is_finite()));
                prop_assert!(!flat::svg(&given).contains("NaN"));
            }
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }
}
