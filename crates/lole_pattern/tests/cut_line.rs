//! Laws of the cut line, of folds and of mirrored pieces.

mod shapes;

use kurbo::{Affine, Point, Vec2};
use lole_geom::Length;
use lole_pattern::Piece;
use lole_pattern::piece::{Edge, Finish, Mark};
use lole_pattern::polygon::Polygon;
use proptest::prelude::*;

/// A tenth of a millimeter [m].
const TOLERANCE: f64 = 1.0e-4;

fn every_shape() -> Vec<Piece> {
    shapes::pattern().pieces
}

/// A polygon of `count` corners on a circle as a piece with one allowance all around.
fn convex(count: u32, radius: f64, allowance: f64) -> Piece {
    let corner = |index: u32| {
        let (sin, cos) =
            lole_geom::trig64::sin_cos(std::f64::consts::TAU * f64::from(index) / f64::from(count));
        Point::new(radius * cos, radius * sin)
    };
    let edges = (0..count).map(|index| {
        Edge::straight("side", corner(index), corner(index + 1), Finish::Seam)
            .with_allowance(Length::from_m(allowance))
    });
    Piece {
        edges: edges.collect(),
        marks: Vec::new(),
        ..shapes::gore(0.2, 0.3, 0.5, 3.0)
    }
}

proptest! {
    /// Mitered all around, a convex piece grows by `a·P + a² Σ tan(θ/2)`, θ being the turn at a corner.
    #[test]
    fn the_cut_line_encloses_the_allowance(
        count in 3_u32..40, radius in 0.05_f64..1.0, allowance in 0.0_f64..0.04,
    ) {
        let piece = convex(count, radius, allowance);
        let perimeter: f64 = piece.edges.iter().map(Edge::length).sum();
        let half_turn = std::f64::consts::PI / f64::from(count);
        let corners = f64::from(count) * lole_geom::trig64::sin(half_turn) / lole_geom::trig64::cos(half_turn);
        let expected = piece.stitching_polygon(TOLERANCE).signed_area()
            + allowance * perimeter + allowance * allowance * corners;
        let found = piece.cut_polygon(TOLERANCE).signed_area();
        prop_assert!((found - expected).abs() < 1e-6, "{found} for {expected}");
    }

    /// Folded up at the hem, the allowance ends at the side's own cut line, however the sides flare.
    #[test]
    fn a_folded_hem_lies_on_the_cloth(
        top in 0.1_f64..0.5, bottom in 0.1_f64..0.7, height in 0.3_f64..1.0, hem_cm in 1.0_f64..8.0,
    ) {
        let gore = shapes::gore(top, bottom, height, hem_cm);
        let cut = gore.cut_polygon(TOLERANCE);
        let depth = -cut.bounds().y0;
        prop_assert!((depth - 0.01 * hem_cm).abs() < 1e-6, "{depth}");
        for corner in cut.points.iter().filter(|corner| corner.y < -1e-6) {
            let folded = Affine::FLIP_Y * *corner;
            let off = cut.distance(folded);
            prop_assert!(off < 1e-6, "{corner:?} folds to {folded:?}, {off} m from the cut line");
        }
    }
}

#[test]
fn a_finer_tolerance_leaves_a_smaller_error() {
    let whole = shapes::front().unfolded();
    let area = |tolerance: f64| whole.cut_polygon(tolerance).signed_area();
    let exact = area(1e-6);
    for tolerance in [1e-3, 1e-4, 1e-5] {
        // A chord is off by the tolerance at most, along a meter and a half of curves.
        let error = (area(tolerance) - exact).abs();
        assert!(error < 1.5 * tolerance, "{tolerance}: {error}");
    }
}

#[test]
fn no_cut_line_crosses_itself_and_all_run_counterclockwise() {
    for piece in every_shape() {
        for turned in [piece.clone(), piece.mirrored(), piece.unfolded()] {
            let cut = turned.cut_polygon(TOLERANCE);
            assert_eq!(cut.first_crossing(), None, "{}", piece.id);
            let stitched = turned.stitching_polygon(TOLERANCE).signed_area();
            assert!(stitched < cut.signed_area(), "{}", piece.id);
        }
    }
}

/// From the middle of every edge, its allowance leads straight to the cut line.
#[test]
fn the_cut_line_lies_an_allowance_outside_of_its_edge() {
    for piece in every_shape() {
        let cut = piece.cut_polygon(1e-6);
        for edge in &piece.edges {
            for part in [0.35, 0.5, 0.65] {
                let (at, outward) = edge.place(part * edge.length()).unwrap();
                let tip = at + outward * edge.allowance.to_m();
                let off = cut.distance(tip);
                let is_tight_hollow = piece.id == "yoke" && edge.id == "neck";
                if !is_tight_hollow {
                    assert!(off < 5e-5, "{} {}: {off} m", piece.id, edge.id);
                }
            }
        }
    }
}

/// In a hollow tighter than its allowance the cut line stays clear of the stitches, and no thorn or
/// loop is left of it.
#[test]
fn a_hollow_keeps_its_allowance() {
    let yoke = shapes::hollow();
    let cut = yoke.cut_polygon(TOLERANCE);
    let neck = yoke.edge("neck").unwrap();
    let (deepest, _) = neck.place(0.5 * neck.length()).unwrap();
    let above = cut
        .points
        .iter()
        .filter(|point| point.x.abs() < 0.01 && deepest.y < point.y);
    for point in above {
        let stitches = Polygon::new(neck.points(TOLERANCE));
        let nearest = (stitches.points.iter()).map(|stitch| stitch.distance(*point));
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        assert!(0.0235 < nearest, "{nearest}");
    }
}

#[test]
fn an_unfolded_piece_is_its_half_twice() {
    let half = shapes::front();
    let whole = half.unfolded();
    assert!(whole.edges.iter().all(|edge| edge.finish != Finish::Fold));
    let areas = [&half, &whole].map(|piece| piece.stitching_polygon(1e-6).signed_area());
    assert!((areas[1] - 2.0 * areas[0]).abs() < 1e-9, "{areas:?}");
    let cuts = [&half, &whole].map(|piece| piece.cut_polygon(1e-6));
    let areas = [0, 1].map(|index| cuts[index].signed_area());
    assert!((areas[1] - 2.0 * areas[0]).abs() < 1e-7, "{areas:?}");
    let drawing = whole.drawing(TOLERANCE);
    assert_eq!(drawing.notches.len(), 2);
    assert_eq!(drawing.points.len(), 2);
    let [one, other] = [drawing.notches[0].at, drawing.notches[1].at];
    assert!(
        one.distance(Affine::FLIP_X * other) < 1e-6,
        "{one:?} {other:?}"
    );
    for notch in &drawing.notches {
        assert!(drawing.cut.distance(notch.at) < 1e-9);
        assert!(drawing.cut.contains(notch.at + notch.inward * 0.004));
    }
}

/// A quarter of a square on two folds is the square.
#[test]
fn a_quarter_unfolds_to_the_whole() {
    let corner = [(0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.0, 0.2)].map(Point::from);
    let edge =
        |id, from: usize, finish| Edge::straight(id, corner[from], corner[(from + 1) % 4], finish);
    let quarter = Piece {
        edges: vec![
            edge("lower", 0, Finish::Fold),
            edge("side", 1, Finish::Raw),
            edge("upper", 2, Finish::Raw),
            edge("middle", 3, Finish::Fold),
        ],
        marks: Vec::new(),
        ..shapes::front()
    };
    let whole = quarter.unfolded().cut_polygon(TOLERANCE);
    assert!((whole.signed_area() - 0.24).abs() < 1e-9, "{whole:?}");
    assert_eq!(whole.points.len(), 4);
}

#[test]
fn a_piece_turned_over_twice_is_itself() {
    for piece in every_shape() {
        let twice = piece.mirrored().mirrored();
        assert_eq!(twice.edges, piece.edges, "{}", piece.id);
        for (mark, again) in piece.marks.iter().zip(&twice.marks) {
            match (mark, again) {
                (
                    Mark::Notch { edge, along, .. },
                    Mark::Notch {
                        edge: edge_again,
                        along: along_again,
                        ..
                    },
                ) => {
                    assert_eq!(edge, edge_again);
                    assert!((along - along_again).abs() < 1e-9);
                }
                _ => assert_eq!(mark, again),
            }
        }
    }
}

#[test]
fn only_upright_rectangles_need_no_paper() {
    let strip = shapes::strip(0.9, 0.06).drawing(TOLERANCE);
    let [width, height] = strip.rectangle.unwrap();
    assert!((width.to_cm() - 92.0).abs() < 1e-9 && (height.to_cm() - 8.0).abs() < 1e-9);
    for piece in [
        shapes::front(),
        shapes::sleeve(),
        shapes::gore(0.2, 0.3, 0.5, 3.0),
    ] {
        assert_eq!(piece.drawing(TOLERANCE).rectangle, None, "{}", piece.id);
    }
}

#[test]
fn the_grain_arrow_lies_in_the_piece_along_its_warp() {
    for piece in every_shape() {
        let drawing = piece.unfolded().drawing(TOLERANCE);
        let [tail, head] = drawing.grain;
        let along = (head - tail) / (head - tail).hypot();
        assert!((along - piece.grain).hypot() < 1e-9, "{}", piece.id);
        assert!(0.04 < tail.distance(head), "{}", piece.id);
        for end in drawing.grain {
            assert!(drawing.cut.contains(end), "{}: {end:?}", piece.id);
        }
        assert!(drawing.cut.contains(drawing.label), "{}", piece.id);
    }
}

/// A sharp point loses its thorn and keeps its allowance.
#[test]
fn a_sharp_point_is_cut_off() {
    let corners = [(0.0, 0.0), (0.5, 0.02), (0.0, 0.04)].map(Point::from);
    let edges = (0..3).map(|index| {
        Edge::straight(
            "side",
            corners[index],
            corners[(index + 1) % 3],
            Finish::Seam,
        )
        .with_allowance(Length::from_cm(1.0))
    });
    let spike = Piece {
        edges: edges.collect(),
        marks: Vec::new(),
        ..shapes::front()
    };
    let cut = spike.cut_polygon(TOLERANCE);
    let tip = cut.bounds().x1;
    assert!((0.505..0.53).contains(&tip), "{tip}");
    assert!(
        0.0099 < cut.distance(corners[1]),
        "{}",
        cut.distance(corners[1])
    );
    assert!(cut.contains(corners[1] + Vec2::new(0.005, 0.0)));
}
