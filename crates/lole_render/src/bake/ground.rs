//! Light on the floor: the shadow of the key light and the darkness where feet and hem keep the
//! light of the room away.

use super::studio::Room;
use crate::shade::{KeyShadow, disk};
use crate::whole;
use crate::{Bounds, Scene};
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Cells of the light map on each side.
pub(crate) const CELLS: usize = 384;
/// Every so many cells the light of the room is worked out; between them it is interpolated.
const ROOM_STEP: usize = 2;
/// Room around the meshes [m], where the darkness of contact fades out.
const MARGIN: f32 = 0.6;
/// The side of the map grows in steps of this [m].
const SIDE_STEP: f32 = 0.5;
/// Shadows are followed no farther than this many times the height of the meshes.
const LONGEST_SHADOW: f32 = 1.6;
const ROOM_TAPS: usize = 10;
/// Half the angle between neighboring directions of the room, as a tangent: each direction stands
/// for all within it.
const ROOM_SPREAD: f32 = 0.30;
/// Shadows on the floor from farther away than this [m] do not get softer.
pub(super) const SOFTEST_DISTANCE: f32 = 0.8;
/// What is this close above the floor does not count as in the way [m].
const SLACK: f32 = 0.002;

/// Share of the open floor's light that arrives, by cell.
pub(crate) struct GroundLight {
    /// Height of the floor [m].
    pub(crate) height: f32,
    /// x and z of the first cell's corner [m].
    pub(crate) corner: Vec2,
    /// Side of a cell [m].
    pub(crate) cell: f32,
    /// Factor by cell, x fastest, shape `[CELLS, CELLS]`; 1 in the open.
    pub(crate) factors: Vec<Vec3>,
}

impl GroundLight {
    /// The light on the floor of a scene whose meshes lie in `bounds`; `None` without a floor.
    pub(super) fn new(
        scene: &Scene<'_>,
        bounds: Bounds,
        room: &Room,
        shadow: KeyShadow<'_>,
    ) -> Option<Self> {
        let ground = scene.ground.as_ref()?;
        let (corner, side) = covered_square(ground.height, bounds, shadow.map.axis);
        let cell = side / CELLS as f32;
        let place =
            |x: f32, z: f32| Vec3::new(corner.x + x * cell, ground.height, corner.y + z * cell);
        let room_taps: [Vec2; ROOM_TAPS] = disk();
        let room_side = CELLS / ROOM_STEP + 1;
        let room_lights: Vec<Vec3> = (0..room_side * room_side)
            .into_par_iter()
            .map(|index| {
                let step = ROOM_STEP as f32;
                let (x, z) = ((index % room_side) as f32, (index / room_side) as f32);
                room_light(room, &room_taps, place(x * step, z * step))
            })
            .collect();
        let key_light = Vec3::from(scene.lights.key.color) * shadow.map.axis.y.max(0.0);
        let open = (room.studio.on_open_floor() + key_light).max(Vec3::splat(1.0e-6));
        let factors: Vec<Vec3> = (0..CELLS * CELLS)
            .into_par_iter()
            .map(|index| {
                let (x, z) = (index % CELLS, index / CELLS);
                let middle = place(x as f32 + 0.5, z as f32 + 0.5);
                let light = key_light * shadow.seen(middle, Vec2::ZERO)
                    + room_between(&room_lights, room_side, x, z);
                let shaded = (light / open).min(Vec3::ONE);
                let fade = ground.shadow * edge_fade(x, z);
                Vec3::ONE.lerp(shaded, fade.clamp(0.0, 1.0))
            })
            .collect();
        Some(Self {
            height: ground.height,
            corner,
            cell,
            factors: smoothed(&factors),
        })
    }

    /// Factor where a ray from `position` along `direction` meets the floor; 1 where it does not.
    pub(super) fn factor_along(&self, position: Vec3, direction: Vec3) -> Vec3 {
        if direction.y > -1.0e-3 {
            return Vec3::ONE;
        }
        let reach = (self.height - position.y) / direction.y;
        let hit = position + direction * reach.max(0.0);
        let at = (Vec2::new(hit.x, hit.z) - self.corner) / self.cell;
        let inside = at.cmpge(Vec2::ZERO).all() && at.cmplt(Vec2::splat(CELLS as f32)).all();
        if inside {
            self.factors[whole::index(at.y) * CELLS + whole::index(at.x)]
        } else {
            Vec3::ONE
        }
    }

    /// Factor at a point of the floor, bilinear; 1 outside the map.
    pub(crate) fn factor_at(&self, x: f32, z: f32) -> Vec3 {
        let at = (Vec2::new(x, z) - self.corner) / self.cell - 0.5;
        let last = (CELLS - 1) as f32;
        if at.min_element() < 0.0 || at.max_element() >= last {
            return Vec3::ONE;
        }
        let (column, row) = (whole::index(at.x), whole::index(at.y));
        let part = at - Vec2::new(column as f32, row as f32);
        let start = row * CELLS + column;
        let top = self.factors[start].lerp(self.factors[start + 1], part.x);
        let bottom = self.factors[start + CELLS].lerp(self.factors[start + CELLS + 1], part.x);
        top.lerp(bottom, part.y)
    }
}

/// Corner and side [m] of the square of floor on which the meshes can throw a shadow.
fn covered_square(height: f32, bounds: Bounds, key_axis: Vec3) -> (Vec2, f32) {
    let tall = (bounds.max.y - height).max(0.0);
    let lean = Vec2::new(-key_axis.x, -key_axis.z) / key_axis.y.max(0.05);
    let longest = tall * LONGEST_SHADOW;
    let throw = (lean * tall).clamp_length_max(longest);
    let low = Vec2::new(bounds.min.x, bounds.min.z);
    let high = Vec2::new(bounds.max.x, bounds.max.z);
    let low = low.min(low + throw) - MARGIN;
    let high = high.max(high + throw) + MARGIN;
    // In a film the meshes move: cells that keep their size and place keep the shadow calm.
    let side = ((high - low).max_element() / SIDE_STEP).ceil() * SIDE_STEP;
    let cell = side / CELLS as f32;
    let corner = ((low + high) * 0.5 - side * 0.5) / cell;
    (corner.floor() * cell, side)
}

/// 1 inside, 0 at the rim of the map, so that it ends without an edge.
fn edge_fade(x: usize, z: usize) -> f32 {
    let rim = x.min(z).min(CELLS - 1 - x).min(CELLS - 1 - z) as f32;
    let share = (rim / (CELLS as f32 * 0.10)).min(1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Light of the room that reaches a point of the floor.
fn room_light(room: &Room, taps: &[Vec2], point: Vec3) -> Vec3 {
    let mut light = Vec3::ZERO;
    for (pair, map) in room.pairs() {
        let at = map.project(point);
        let mut seen = 0.0;
        for offset in taps {
            // Each direction stands for a cone: what is far away hides a wider part of the floor
            // softly, what is near a small part sharply.
            let spread = 0.25 * ROOM_SPREAD / map.texel;
            let wide = map.nearest_at(at.x + offset.x * spread, at.y + offset.y * spread);
            let distance = if wide > at.z { wide - at.z } else { 0.08 };
            let radius = (distance.min(1.0) * ROOM_SPREAD / map.texel).max(1.0);
            let spot = at + Vec3::new(offset.x * radius, offset.y * radius, SLACK);
            seen += map.seen_from_front(spot);
        }
        light += pair.radiance[0] * (pair.axis.y * seen / ROOM_TAPS as f32);
    }
    light
}

/// The mean of each cell and its eight neighbors, weighted 1-2-1 both ways: it takes the steps of
/// the room's taps away. The rim stays as it is.
fn smoothed(factors: &[Vec3]) -> Vec<Vec3> {
    let mut smooth = factors.to_vec();
    for z in 1..CELLS - 1 {
        for x in 1..CELLS - 1 {
            let start = z * CELLS + x;
            let row =
                |middle: usize| factors[middle - 1] + factors[middle] * 2.0 + factors[middle + 1];
            smooth[start] = (row(start - CELLS) + row(start) * 2.0 + row(start + CELLS)) / 16.0;
        }
    }
    smooth
}

fn room_between(room: &[Vec3], side: usize, x: usize, z: usize) -> Vec3 {
    let step = ROOM_STEP as f32;
    let (at_x, at_z) = ((x as f32 + 0.5) / step, (z as f32 + 0.5) / step);
    let (column, row) = (whole::index(at_x), whole::index(at_z));
    let start = row * side + column;
    let part = Vec2::new(at_x - column as f32, at_z - row as f32);
    let top = room[start].lerp(room[start + 1], part.x);
    let bottom = room[start + side].lerp(room[start + side + 1], part.x);
    top.lerp(bottom, part.y)
}
