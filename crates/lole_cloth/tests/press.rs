//! Laws of gathers under what is worn over them: taut cloth presses them until it is slack, slack cloth
//! does not, and folds keep their order.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};
use lole_cloth::collision::layer::{OuterCloth, Press, Trunk};
use lole_geom::trig;

const GAP: f32 = 0.0015;
const ROWS: u16 = 31;
const HEIGHT: f32 = 0.01;
/// Radius of the pleats, and how far their crests stand out from that [m].
const RADIUS: f32 = 0.15;
const DEPTH: f32 = 0.012;

const TRUNK: Trunk = Trunk {
    axis: Vec3::new(0.1, 0.9, -0.2),
    forward: Vec3::X,
};

/// A tube from the height of the axis down: triangles and places [m].
fn tube(columns: u16, radius: impl Fn(f32) -> f32) -> (Vec<[u32; 3]>, Vec<Vec3>) {
    let at = |row: u16, column: u16| u32::from(row * columns + column % columns);
    let place = |row: u16, column: u16| {
        let angle = f32::from(column) * TAU / f32::from(columns);
        let (sin, cos) = trig::sin_cos(angle);
        TRUNK.axis + Vec3::new(cos, 0.0, sin) * radius(angle) - Vec3::Y * (HEIGHT * f32::from(row))
    };
    let cells = (0..ROWS - 1).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let halves = cells.flat_map(|(row, column)| {
        let [first, right] = [at(row, column), at(row, column + 1)];
        let [below, last] = [at(row + 1, column), at(row + 1, column + 1)];
        [[first, right, last], [first, last, below]]
    });
    let places = (0..ROWS).flat_map(|row| (0..columns).map(move |column| place(row, column)));
    (halves.collect(), places.collect())
}

/// Pleats, which overlap in this many columns.
fn pleats() -> (Vec<[u32; 3]>, Vec<Vec3>) {
    tube(800, |angle| RADIUS + DEPTH * trig::sin_cos(40.0 * angle).0)
}

/// Where the pleats lie under a sleeve of their upper half, this much wider than their crests, which has
/// this girth when it is flat [m].
fn pressed(out: f32, girth: f32) -> (Vec<Vec3>, Vec<Vec3>) {
    let columns = 100_u16;
    let radius = RADIUS + DEPTH + out;
    let (triangles, positions) = tube(columns, |_| radius);
    // Cut open, so that triangles across the cut have their size too.
    let half = usize::from(columns) * usize::from(ROWS - 1);
    let opened: Vec<[u32; 3]> = (triangles[..half].iter())
        .filter(|triangle| {
            let column = |corner: &u32| corner % u32::from(columns);
            let ends = triangle.iter().map(column);
            ends.clone().max().unwrap_or(0) - ends.min().unwrap_or(0) < 2
        })
        .copied()
        .collect();
    let flat: Vec<Vec2> = (0..ROWS)
        .flat_map(|row| (0..columns).map(move |column| (row, column)))
        .map(|(row, column)| {
            let along = f32::from(column) * girth / f32::from(columns);
            Vec2::new(along, HEIGHT * f32::from(row))
        })
        .collect();
    let over = OuterCloth {
        triangles: &opened,
        on_cloth: &flat,
        positions: &positions,
    };
    let mut press = Press::default();
    press.tighten(TRUNK, [over].into_iter());
    let (triangles, positions) = pleats();
    press.flatten(TRUNK, [(&triangles[..], &positions[..])].into_iter(), GAP);
    let mut pressed = Vec::new();
    press.press(&positions, &mut pressed);
    (positions, pressed)
}

fn radius(place: Vec3) -> f32 {
    (place - TRUNK.axis).with_y(0.0).length()
}

/// Farthest from the axis in the middle of the upper half [m].
fn crest(places: &[Vec3]) -> f32 {
    let is_there = |place: &&Vec3| {
        let below = TRUNK.axis.y - place.y;
        (0.04..0.10).contains(&below)
    };
    places
        .iter()
        .filter(is_there)
        .map(|place| radius(*place))
        .fold(0.0, f32::max)
}

#[test]
fn taut_cloth_presses_gathers_until_it_is_slack() {
    let free = RADIUS + DEPTH;
    for slack in [free - 0.010, free - 0.006, free - 0.002] {
        let (_, pressed) = pressed(GAP, TAU * slack);
        let found = crest(&pressed);
        // It lies a gap outside of them.
        assert!(
            (found - (slack - GAP)).abs() < 0.001,
            "{found} m of {slack}"
        );
    }
}

#[test]
fn slack_cloth_presses_nothing() {
    let (free, pressed) = pressed(0.01, TAU * (RADIUS + DEPTH + 0.011));
    assert_eq!(free, pressed);
}

#[test]
fn nothing_is_pressed_flatter_than_its_layers() {
    let (free, pressed) = pressed(GAP, TAU * 0.5 * RADIUS);
    let lowest = RADIUS - DEPTH;
    let (triangles, _) = pleats();
    let area = |[a, b, c]: [Vec3; 3]| 0.5 * (b - a).cross(c - a).length();
    let cloth: f32 = triangles
        .iter()
        .map(|it| area(it.map(|it| free[it as usize])))
        .sum();
    let layers = cloth / (TAU * lowest * HEIGHT * f32::from(ROWS - 1));
    let least = lowest + layers * GAP;
    let found = crest(&pressed);
    assert!((found - least).abs() < 0.001, "{found} m, not {least}");
}

#[test]
fn folds_keep_their_order_and_their_heights_and_end_softly() {
    let (free, pressed) = pressed(GAP, TAU * (RADIUS + 0.003));
    for (row, (free, pressed)) in free.chunks(800).zip(pressed.chunks(800)).enumerate() {
        for (near, far) in [(15, 5), (14, 8), (12, 10)] {
            let [near, far] = [near, far].map(|column| radius(pressed[column]));
            assert!(near < far + 1.0e-6, "row {row}: {near} m and {far} m");
        }
        for (free, pressed) in free.iter().zip(pressed) {
            assert_eq!(free.y, pressed.y, "row {row}");
            assert!(radius(*pressed) <= radius(*free) + 1.0e-6, "row {row}");
        }
    }
    // Beyond the lower edge of what is worn over it a row comes out by half a millimeter to the next.
    let crests: Vec<f32> = pressed
        .chunks(800)
        .map(|row| row.iter().map(|place| radius(*place)).fold(0.0, f32::max))
        .collect();
    for pair in crests.windows(2) {
        assert!((pair[1] - pair[0]).abs() < 0.006, "{crests:?}");
    }
    assert!(
        RADIUS + DEPTH - crests[usize::from(ROWS) - 1] < 0.001,
        "{crests:?}"
    );
}
