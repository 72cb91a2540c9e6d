//! Laws of the cut plan.

mod shapes;

use kurbo::{Affine, Point, Vec2};
use lole_geom::Length;
use lole_language::Bilingual as _;
use lole_pattern::marker::{Border, Lay, Marker, Nap, Placed, TableCloth, lay_out};
use lole_pattern::piece::{ClothRole, CutCount, Finish};
use lole_pattern::polygon::Polygon;
use lole_pattern::{Pattern, Piece};
use proptest::prelude::*;

fn cloth(width_cm: f64) -> TableCloth {
    TableCloth {
        width: Length::from_cm(width_cm),
        nap: Nap::TwoWay,
        border: None,
        matched_repeat: None,
        lay: Lay::Single,
    }
}

fn garment(pieces: Vec<Piece>) -> Pattern {
    Pattern {
        pieces,
        ..shapes::pattern()
    }
}

fn plan(pattern: &Pattern, cloth: &TableCloth) -> Marker {
    let marker = lay_out(pattern, ClothRole::Main, cloth);
    check(pattern, &marker);
    marker
}

/// What holds for every plan: everything is there, on the cloth, grain along it, nothing over another.
fn check(pattern: &Pattern, marker: &Marker) {
    for (index, piece) in pattern.pieces.iter().enumerate() {
        let laid = marker.placed.iter().filter(|placed| placed.piece == index);
        let cut: u32 = (laid.clone())
            .map(|placed| if placed.is_on_fold { 1 } else { placed.layers })
            .sum();
        assert_eq!(cut, piece.cut.pieces(), "{}", piece.id);
        for placed in laid {
            check_placed(piece, placed, marker);
        }
    }
    for (index, one) in marker.placed.iter().enumerate() {
        for other in &marker.placed[index + 1..] {
            assert!(
                !overlap(one, other),
                "pieces {} and {}",
                one.piece,
                other.piece
            );
        }
    }
    assert!(marker.efficiency <= 1.0 + 1e-9, "{}", marker.efficiency);
}

fn check_placed(piece: &Piece, placed: &Placed, marker: &Marker) {
    let width = marker.cloth.width.to_m();
    let is_doubled = placed.outline.bounds().x1 <= marker.folded_length.to_m() + 1e-9;
    let width = if is_doubled { 0.5 * width } else { width };
    let bounds = placed.outline.bounds();
    assert!(
        -1e-6 <= bounds.x0 && -1e-6 <= bounds.y0,
        "{}: {bounds:?}",
        piece.id
    );
    if marker.warnings.is_empty() {
        assert!(bounds.y1 <= width + 1e-5, "{}: {bounds:?}", piece.id);
        let along = linear(placed) * piece.grain.to_point();
        let is_border = marker.cloth.border.is_some();
        assert!(is_border || along.y.abs() < 1e-9, "{}: {along:?}", piece.id);
    }
}

fn linear(placed: &Placed) -> Affine {
    let [a, b, c, d, _, _] = placed.cloth_from_piece.as_coeffs();
    Affine::new([a, b, c, d, 0.0, 0.0])
}

/// Deepest that cut lines may lie over each other [m]: a hundredth of a millimeter.
const TOUCHING: f64 = 1e-5;

/// Whether two cut lines lie over each other by more than [`TOUCHING`].
fn overlap(one: &Placed, other: &Placed) -> bool {
    let (one, other) = (&one.outline, &other.outline);
    let crosses = one
        .sides()
        .any(|first| other.sides().any(|second| cross(first, second)));
    let is_deep = |point: Point, outline: &Polygon| {
        outline.contains(point) && outline.sides().all(|side| TOUCHING < distance(point, side))
    };
    crosses
        || other.points.iter().any(|&point| is_deep(point, one))
        || one.points.iter().any(|&point| is_deep(point, other))
}

/// Whether two sides cross with all ends farther than [`TOUCHING`] from the other's line.
fn cross(first: [Point; 2], second: [Point; 2]) -> bool {
    let parts = |[a, b]: [Point; 2], ends: [Point; 2]| {
        let heights = ends.map(|end| (b - a).cross(end - a) / a.distance(b));
        heights[0] * heights[1] < 0.0 && heights.iter().all(|height| TOUCHING < height.abs())
    };
    parts(first, second) && parts(second, first)
}

/// From a point to a side [m].
fn distance(point: Point, [a, b]: [Point; 2]) -> f64 {
    let along = (point - a).dot(b - a) / (b - a).hypot2().max(1e-30);
    point.distance(a + (b - a) * along.clamp(0.0, 1.0))
}

/// A scooped side lies at a sloping one: what touches does not lie over each other.
#[test]
fn a_gore_may_touch_a_front() {
    let gore = shapes::gore(
        0.105_563_388_130_169_4,
        0.283_120_660_340_537_4,
        0.757_176_130_945_368_6,
        4.0,
    );
    let pieces = vec![gore, shapes::front(), shapes::sleeve()];
    plan(&garment(pieces), &cloth(128.833_646_987_709_22));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn strips_of_any_size_fit(
        sizes in proptest::collection::vec((0.1_f64..1.2, 0.03_f64..0.5), 1..7), width_cm in 90.0_f64..150.0,
    ) {
        let strips = sizes.into_iter().map(|(length, height)| shapes::strip(length, height));
        plan(&garment(strips.collect()), &cloth(width_cm));
    }

    #[test]
    fn free_shapes_of_any_size_fit(
        top in 0.1_f64..0.4, bottom in 0.2_f64..0.6, height in 0.2_f64..0.8, width_cm in 90.0_f64..150.0,
    ) {
        let pieces = vec![shapes::gore(top, bottom, height, 4.0), shapes::front(), shapes::sleeve()];
        let marker = plan(&garment(pieces), &cloth(width_cm));
        prop_assert!(0.55 < marker.efficiency, "{}", marker.efficiency);
    }
}

#[test]
fn the_same_garment_gives_the_same_plan() {
    let pattern = shapes::pattern();
    assert_eq!(plan(&pattern, &cloth(110.0)), plan(&pattern, &cloth(110.0)));
}

/// Halves of the width lie side by side: rectangles are laid exactly.
#[test]
fn thirds_of_the_width_waste_nothing() {
    let third = Piece {
        cut: CutCount::Alike(6),
        ..shapes::strip(0.48, 1.10 / 3.0 - 0.02)
    };
    let marker = plan(&garment(vec![third]), &cloth(110.0));
    assert!(
        (marker.efficiency - 1.0).abs() < 1e-6,
        "{}",
        marker.efficiency
    );
    assert!((marker.yardage.needed.to_cm() - 100.0).abs() < 1e-6);
}

/// Slopes face each other where pieces may be turned, and lie the same way where they may not.
#[test]
fn a_direction_of_the_cloth_costs_cloth() {
    let gores = garment(vec![shapes::gore(0.12, 0.40, 0.70, 3.0)]);
    let both = plan(&gores, &cloth(110.0));
    let one_way = TableCloth {
        nap: Nap::OneWay,
        ..cloth(110.0)
    };
    let directed = plan(&gores, &one_way);
    assert!(both.yardage.needed < directed.yardage.needed);
    assert!(
        directed
            .placed
            .iter()
            .all(|placed| linear(placed) == linear(&directed.placed[0]))
    );
    assert!(
        both.placed
            .iter()
            .any(|placed| linear(placed) != linear(&both.placed[0]))
    );
}

#[test]
fn pairs_are_cut_left_and_right() {
    let marker = plan(&garment(vec![shapes::sleeve()]), &cloth(110.0));
    let signs: Vec<f64> = (marker.placed.iter())
        .map(|placed| placed.cloth_from_piece.determinant().signum())
        .collect();
    assert_eq!(marker.placed.len(), 2);
    assert!((signs[0] * signs[1] + 1.0).abs() < 1e-12, "{signs:?}");
}

/// On doubled cloth the front lies on the fold, a pair of sleeves is cut at once, and an odd copy
/// lies behind on single cloth.
#[test]
fn doubled_cloth_has_a_fold() {
    let odd = Piece {
        cut: CutCount::Alike(3),
        ..shapes::strip(0.5, 0.1)
    };
    let folded = TableCloth {
        lay: Lay::Folded,
        ..cloth(110.0)
    };
    let pattern = garment(vec![shapes::front(), shapes::sleeve(), odd]);
    let marker = plan(&pattern, &folded);
    let front = marker
        .placed
        .iter()
        .find(|placed| placed.piece == 0)
        .unwrap();
    assert!(front.is_on_fold && front.layers == 2);
    let fold = pattern.pieces[0]
        .edges
        .iter()
        .find(|edge| edge.finish == Finish::Fold)
        .unwrap();
    for part in [0.0, 0.5, 1.0] {
        let (at, _) = fold.place(part * fold.length()).unwrap();
        assert!((front.cloth_from_piece * at).y.abs() < 1e-9);
    }
    let single: Vec<&Placed> = marker
        .placed
        .iter()
        .filter(|placed| placed.layers == 1)
        .collect();
    assert_eq!(single.len(), 1);
    assert!(marker.folded_length.to_m() <= single[0].outline.bounds().x0 + 1e-9);
}

#[test]
fn hems_lie_on_the_border() {
    let border = TableCloth {
        border: Some(Border::Hem),
        ..cloth(110.0)
    };
    let marker = plan(&garment(vec![shapes::gore(0.2, 0.34, 0.6, 4.0)]), &border);
    for placed in &marker.placed {
        let hem = linear(placed) * Vec2::new(0.0, -1.0).to_point();
        assert!((hem.y + 1.0).abs() < 1e-9, "{hem:?}");
        assert!(placed.outline.bounds().y0.abs() < 1e-9);
    }
    // At the hips it is turned: the hem then lies highest.
    let hip = TableCloth {
        border: Some(Border::Hip),
        ..border
    };
    let turned = plan(&garment(vec![shapes::gore(0.2, 0.34, 0.6, 4.0)]), &hip);
    let hem = linear(&turned.placed[0]) * Vec2::new(0.0, -1.0).to_point();
    assert!((hem.y - 1.0).abs() < 1e-9, "{hem:?}");
    // Too long for the width: along the warp, and said.
    let long = plan(&garment(vec![shapes::gore(0.2, 0.34, 1.2, 4.0)]), &border);
    let said = long.warnings[0].to_string();
    assert!(
        said.contains("border") && said.contains("shorten it"),
        "{said}"
    );
    assert_eq!(long.warnings.len(), 1);
}

/// Pieces lie whole repeats apart, from the lower end of the stitching line.
#[test]
fn prints_meet_at_the_seams() {
    let matched = TableCloth {
        nap: Nap::OneWay,
        matched_repeat: Some(Length::from_cm(31.0)),
        ..cloth(110.0)
    };
    let pattern = garment(vec![shapes::gore(0.2, 0.34, 0.6, 4.0), shapes::front()]);
    let marker = plan(&pattern, &matched);
    for placed in &marker.placed {
        let piece = pattern.pieces[placed.piece].unfolded();
        let stitched = piece
            .stitching_polygon(2e-4)
            .transformed(placed.cloth_from_piece);
        let repeats = stitched.bounds().x0 / 0.31;
        assert!((repeats - repeats.round()).abs() < 1e-6, "{repeats}");
    }
    assert!(plan(&pattern, &cloth(110.0)).yardage.needed < marker.yardage.needed);
}

#[test]
fn a_piece_wider_than_the_cloth_is_drawn_and_said_with_remedies() {
    let wide = Piece {
        cut: CutCount::Alike(1),
        ..shapes::strip(0.7, 1.2)
    };
    let marker = plan(&garment(vec![wide, shapes::strip(0.5, 0.4)]), &cloth(110.0));
    assert_eq!(marker.warnings.len(), 1);
    let warning = &marker.warnings[0];
    assert_eq!(
        warning.to_string(),
        "strip: 122.0 cm lie across cloth of 110.0 cm; lay it with its grain across the cloth, use cloth \
         at least 122 cm wide, or make the piece 12.0 cm smaller"
    );
    assert!(
        warning.japanese().contains("はみ出します"),
        "{}",
        warning.japanese()
    );
    let behind = marker.placed.last().unwrap();
    assert_eq!(behind.piece, 0);
}

/// Cloth of other roles is another plan.
#[test]
fn linings_are_laid_on_their_own_cloth() {
    let lining = Piece {
        cloth: ClothRole::Lining,
        ..shapes::sleeve()
    };
    let pattern = garment(vec![shapes::front(), lining]);
    let main = lay_out(&pattern, ClothRole::Main, &cloth(110.0));
    let lining = lay_out(&pattern, ClothRole::Lining, &cloth(90.0));
    assert!(main.placed.iter().all(|placed| placed.piece == 0));
    assert!(lining.placed.iter().all(|placed| placed.piece == 1));
    assert!(
        lay_out(&pattern, ClothRole::Contrast, &cloth(90.0))
            .placed
            .is_empty()
    );
}
