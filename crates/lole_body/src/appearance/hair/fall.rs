//! Open hair: a fall from the back of the head over the neck and down the back.

use glam::{Vec2, Vec3};
use lole_geom::trig;

use super::super::hair_paint::hairline_v;
use super::{HEAD_ALONE, Scalp, Solid};
use crate::Bone;
use crate::drawn::HairKnot;
use crate::drawn::open_hair::Lie;
use crate::surface::Shape;
use crate::surface::pchip::Pchip;
use crate::surface::warp::smooth_step;

/// Half the width of the fall [cm] by its share from top to bottom.
const HALF_WIDTH: [[f32; 2]; 8] = [
    [0.0, 1.0],
    [0.04, 3.9],
    [0.1, 6.3],
    [0.3, 7.0],
    [0.5, 8.8],
    [0.75, 9.2],
    [0.93, 7.4],
    [1.0, 4.6],
];
/// How far it stands off skin and cap in the middle [cm]: nothing at the top, where it grows out of
/// the cap.
const STAND_OFF: [[f32; 2]; 7] = [
    [0.0, -1.8],
    [0.05, -0.5],
    [0.14, 0.4],
    [0.3, 1.2],
    [0.7, 1.4],
    [0.93, 1.0],
    [1.0, 0.5],
];
/// Its inner side lies this far below its outer one [cm], in the skin or nearly so.
const THICKNESS: f32 = 1.7;
/// How far in front of the place above it hair may hang, per way down: it spans the neck's hollow.
const FORWARD: f32 = 0.15;
/// How far down the back it goes, between shoulder and waist.
const LENGTH: f32 = 0.66;
pub(super) const RINGS: usize = 72;
/// Knots by which it swings, across and down.
const KNOT_COLUMNS: usize = 5;
const KNOT_ROWS: usize = 9;
/// Columns of either side of the sheet.
pub(super) const COLUMNS: usize = 29;

/// The fall behind head and back.
pub(super) struct Fall {
    /// Around, from above down: the outer side from her right to her left, the inner one back.
    rings: Vec<Vec<Vec3>>,
    /// Heights of shoulder and head, between which the head takes over, and of the chest [m].
    neck: [f32; 2],
    chest: f32,
    /// Size of the head over the mean woman's.
    k: f32,
}

impl Fall {
    /// Hangs it; `cap` is the hair on the head.
    pub(super) fn new(shape: &Shape, scalp: &Scalp<'_>, cap: &Solid) -> Self {
        let body = &shape.body;
        Self {
            rings: hung(shape, scalp, cap),
            neck: [body.level("shoulder"), body.joint("head").y],
            chest: body.joint("upperChest").y,
            k: scalp.k,
        }
    }

    /// Bones of a point at a height.
    pub(super) fn carried(&self, y: f32) -> ([u16; 4], [f32; 4]) {
        carried(y, self.neck, self.chest)
    }

    /// Place and outward direction of the outer side, at a ring and a column of it that need not be whole.
    pub(super) fn at(&self, ring: f32, column: f32) -> Option<(Vec3, Vec3)> {
        let (row, place) = (ring.floor(), column.floor());
        let [first, second] =
            [index(row), index(row).checked_add(1)?].map(|row| row.min(RINGS - 1));
        let [left, right] = [index(place), index(place) + 1].map(|place| place.min(COLUMNS - 1));
        let [upper, lower] = [first, second].map(|row| self.rings.get(row));
        let (upper, lower) = (upper?, lower?);
        let share = column - place;
        let [above, below] = [upper, lower].map(|ring| ring[left].lerp(ring[right], share));
        let across = upper[right] - upper[left];
        let outward = across
            .cross(upper[left] - lower[left])
            .normalize_or(Vec3::NEG_Z);
        let outward = if outward.z > 0.0 { -outward } else { outward };
        Some((above.lerp(below, ring - row), outward))
    }

    /// Knots by which it swings, column by column, and how many columns they are.
    pub(super) fn knots(&self) -> (Vec<HairKnot>, usize) {
        let [from, to] = self.swinging();
        let knot = |column: usize, row: usize| {
            let ring = from + (to - from) * row as f32 / (KNOT_ROWS - 1) as f32;
            let column = (COLUMNS - 1) as f32 * (column as f32 + 0.5) / KNOT_COLUMNS as f32;
            let (place, outward) = self.at(ring, column).unwrap_or_default();
            HairKnot {
                place,
                outward,
                carried: self.carried(place.y),
            }
        };
        let knots = (0..KNOT_COLUMNS)
            .flat_map(|column| (0..KNOT_ROWS).map(move |row| knot(column, row)))
            .collect();
        (knots, KNOT_COLUMNS)
    }

    /// Where a place of it lies among the knots.
    pub(super) fn lie(&self, place: Vec3) -> Lie {
        let heights = [0, RINGS - 1].map(|ring| self.rings[ring][0].y);
        let down = (heights[0] - place.y) / (heights[0] - heights[1]);
        let half = 0.01 * self.k * Pchip::new(&HALF_WIDTH).at(down.clamp(0.0, 1.0));
        let across = 0.5 + 0.5 * (place.x / half.max(1.0e-3)).clamp(-1.0, 1.0);
        let [from, to] = self.swinging();
        let row = ((RINGS - 1) as f32 * down - from) / (to - from);
        [
            KNOT_COLUMNS as f32 * across - 0.5,
            (KNOT_ROWS - 1) as f32 * row,
        ]
    }

    /// Rings between which it swings: from where it leaves the head to its end.
    fn swinging(&self) -> [f32; 2] {
        let last = RINGS - 1;
        let heights = [0, last].map(|ring| self.rings[ring][0].y);
        let from = (heights[0] - self.neck[1]) / (heights[0] - heights[1]);
        [last as f32 * from.clamp(0.0, 0.9), last as f32]
    }

    /// Its closed surface.
    pub(super) fn solid(&self) -> Solid {
        let middle = |ring: &[Vec3]| ring.iter().sum::<Vec3>() / ring.len() as f32;
        let poles = [middle(&self.rings[0]), middle(&self.rings[RINGS - 1])];
        let around = self.rings[0].len();
        let mut solid = Solid::from_rings(&self.rings, poles);
        solid.uvs = (0..RINGS * around)
            .map(|index| {
                let (ring, column) = (index / around, index % around);
                let is_outer = column < COLUMNS;
                let column = if is_outer { column } else { around - column };
                let across = column as f32 / (COLUMNS - 1) as f32;
                let down = ring as f32 / RINGS as f32;
                // Light hardly comes to the inner side.
                let row = if is_outer { 16.0 + 50.0 * down } else { 39.0 };
                Vec2::new(0.1 + 0.6 * across, hairline_v(row))
            })
            .chain([16.0, 66.0].map(|inside| Vec2::new(0.3, hairline_v(inside))))
            .collect();
        solid.carried = (solid.positions.iter())
            .map(|point| self.carried(point.y))
            .collect();
        solid
    }
}

/// A whole number that is not negative, as an index.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cut off at 0, and rings are few"
)]
fn index(whole: f32) -> usize {
    whole.max(0.0) as usize
}

/// The rings of the fall; `cap` is the hair on the head.
fn hung(shape: &Shape, scalp: &Scalp<'_>, cap: &Solid) -> Vec<Vec<Vec3>> {
    let k = scalp.k;
    let body = &shape.body;
    let top = scalp.center.y + 0.075 * k;
    let shoulder = body.level("shoulder");
    let bottom = shoulder + (body.tape_level("waist") - shoulder) * LENGTH;
    let [width, stand_off] = [&HALF_WIDTH[..], &STAND_OFF[..]].map(Pchip::new);
    let step = (top - bottom) / (RINGS - 1) as f32;
    let ground = ground(shape, cap);
    let mut behind = [f32::INFINITY; COLUMNS];
    let mut rings = Vec::with_capacity(RINGS);
    for ring in 0..RINGS {
        let down = ring as f32 / (RINGS - 1) as f32;
        let y = top - step * ring as f32;
        let half = 0.01 * k * width.at(down);
        let across = |column: usize| 2.0 * column as f32 / (COLUMNS - 1) as f32 - 1.0;
        for (column, behind) in behind.iter_mut().enumerate() {
            let skin = back(&ground, half * across(column).abs(), y);
            *behind = (*behind + FORWARD * step).min(skin);
        }
        evened(&mut behind);
        let place = |column: usize, is_outer: bool| {
            let x = across(column);
            // Thin at its sides, and in locks.
            let round = (1.0 - x * x * x * x).max(0.0).sqrt();
            let lock = 0.07 * trig::sin(21.0 * x + 2.5 * down) + 0.05 * trig::sin(47.0 * x - down);
            let outer = stand_off.at(down) * round * (1.0 + lock);
            let off = if is_outer {
                outer
            } else {
                outer - THICKNESS * round
            };
            Vec3::new(half * x, y, behind[column] - 0.01 * k * off)
        };
        // Around: the outer side from her right to her left, the inner one back.
        let outer = (0..COLUMNS).map(|column| place(column, true));
        let inner = (1..COLUMNS - 1).rev().map(|column| place(column, false));
        rings.push(outer.chain(inner).collect::<Vec<Vec3>>());
    }
    rings
}

/// Hair beside hair lies level: a few passes of means over neighbors.
fn evened(behind: &mut [f32; COLUMNS]) {
    const PASSES: usize = 3;
    for _ in 0..PASSES {
        let before = *behind;
        for column in 1..COLUMNS - 1 {
            let mean = (before[column - 1] + before[column] + before[column + 1]) / 3.0;
            behind[column] = mean.min(before[column]);
        }
    }
}

/// What the fall lies on: the back half of trunk, head and cap.
fn ground(shape: &Shape, cap: &Solid) -> Vec<Vec3> {
    let skin = shape.positions.iter().zip(&shape.labels);
    skin.filter(|(_, label)| !label.is_arm())
        .map(|(&point, _)| point)
        .chain(cap.positions.iter().copied())
        .filter(|point| point.z < shape.body.head.center.z)
        .collect()
}

/// How far back the ground reaches around a place seen from behind [m].
fn back(ground: &[Vec3], x: f32, y: f32) -> f32 {
    const NEAR: f32 = 0.011;
    (ground.iter())
        .filter(|point| (point.y - y).abs() < NEAR && (point.x.abs() - x).abs() < NEAR)
        .map(|point| point.z)
        .fold(f32::INFINITY, f32::min)
}

/// Bones of a point of the fall: the head above the neck, the back below it.
fn carried(y: f32, [shoulder, head]: [f32; 2], chest: f32) -> ([u16; 4], [f32; 4]) {
    let by_head = smooth_step((y - shoulder) / (head - shoulder));
    let by_chest = (1.0 - by_head) * smooth_step((chest + 0.05 - y) / 0.1);
    let bone = |bone: Bone| u16::try_from(bone.index()).unwrap_or(0);
    let (mut joints, _) = HEAD_ALONE;
    joints[1] = bone(Bone::UpperChest);
    joints[2] = bone(Bone::Chest);
    (joints, [by_head, 1.0 - by_head - by_chest, by_chest, 0.0])
}
