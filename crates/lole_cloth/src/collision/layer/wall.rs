//! A surface around the axis of the trunk: how far it stands out, by height and direction.

use std::ops::Range;

use glam::Vec3;
use lole_geom::Surfel;

/// Directions around the axis that are told apart.
pub(super) const SECTORS: usize = 144;
/// Heights that are told apart, and their distance [m].
pub(super) const LEVELS: usize = 128;
pub(super) const LEVEL: f32 = 0.015;
/// Levels below the height of the axis: as far as from the hips to the floor, and more.
const LEVELS_BELOW: usize = 88;

/// Where a surfel is put whose bin is empty [m]: no cloth comes there.
pub(super) const NOWHERE: Vec3 = Vec3::splat(1.0e4);

/// Where the trunk of a body is: an upright axis, and the way that it faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trunk {
    /// A point of its upright axis [m].
    pub axis: Vec3,
    /// Horizontal unit vector that turns with it.
    pub forward: Vec3,
}

impl Default for Trunk {
    fn default() -> Self {
        Self {
            axis: Vec3::ZERO,
            forward: Vec3::Z,
        }
    }
}

impl Trunk {
    /// A place [m] seen from the axis, with forward along `z`.
    pub(super) fn local(&self, place: Vec3) -> Vec3 {
        let arm = place - self.axis;
        let side = Vec3::Y.cross(self.forward);
        Vec3::new(arm.dot(side), arm.y, arm.dot(self.forward))
    }
}

/// Outward direction of every sector, where forward is `z`.
pub(super) fn directions() -> Vec<Vec3> {
    #[expect(clippy::cast_precision_loss, reason = "sectors are few")]
    let direction = |sector: usize| {
        let around = (sector as f32 + 0.5) * 4.0 / SECTORS as f32;
        let share = if around < 2.0 {
            1.0 - around
        } else {
            around - 3.0
        };
        let depth = 1.0 - share.abs();
        Vec3::new(share, 0.0, if around < 2.0 { depth } else { -depth }).normalize_or_zero()
    };
    (0..SECTORS).map(direction).collect()
}

/// The sectors within `reach` of one, on either side.
pub(super) fn around(sector: usize, reach: usize) -> impl Iterator<Item = usize> {
    (0..=2 * reach).map(move |step| (sector + SECTORS + step - reach) % SECTORS)
}

/// A wall where the trunk is.
#[derive(Clone, Copy)]
pub(super) struct Wall<'a> {
    pub(super) trunk: Trunk,
    /// Distance from the axis [m], 0 where there is none; shape `[LEVELS, SECTORS]`.
    pub(super) radii: &'a [f32],
    /// See [`directions`].
    pub(super) directions: &'a [Vec3],
}

impl Wall<'_> {
    /// Adds its surface, a surfel for every bin, `inset` [m] inside of it.
    pub(super) fn add_surfels(&self, inset: f32, surfels: &mut Vec<Surfel>) {
        let forward = self.trunk.forward;
        let side = Vec3::Y.cross(forward);
        let world = |v: Vec3| side * v.x + Vec3::Y * v.y + forward * v.z;
        for level in 0..LEVELS {
            for sector in 0..SECTORS {
                let Some(place) = self.place(level, sector) else {
                    surfels.push(Surfel {
                        position: NOWHERE,
                        normal: Vec3::Y,
                    });
                    continue;
                };
                let or_here = |other: Option<Vec3>| other.unwrap_or(place);
                let next = or_here(self.place(level, (sector + 2) % SECTORS));
                let last = or_here(self.place(level, (sector + SECTORS - 2) % SECTORS));
                let above = or_here(self.place((level + 1).min(LEVELS - 1), sector));
                let below = or_here(self.place(level.saturating_sub(1), sector));
                let outward = self.directions[sector];
                let normal = (next - last).cross(above - below);
                let normal = normal.try_normalize().unwrap_or(outward);
                let normal = if normal.dot(outward) < 0.0 {
                    -normal
                } else {
                    normal
                };
                surfels.push(Surfel {
                    position: self.trunk.axis + world(place - normal * inset),
                    normal: world(normal),
                });
            }
        }
    }

    /// Where the surface of a bin is from the axis [m], with forward along `z`; `None` where there is
    /// none.
    fn place(&self, level: usize, sector: usize) -> Option<Vec3> {
        let radius = self.radii[level * SECTORS + sector];
        let height = height_of(level) + 0.5 * LEVEL;
        (0.0 < radius).then(|| self.directions[sector] * radius + Vec3::Y * height)
    }
}

/// Height of the lower edge of a level over the axis [m].
#[expect(clippy::cast_precision_loss, reason = "levels are few")]
pub(super) const fn height_of(level: usize) -> f32 {
    (level as f32 - LEVELS_BELOW as f32) * LEVEL
}

/// The bin of a place seen from the axis, if there is one.
pub(super) fn bin(arm: Vec3) -> Option<usize> {
    let bin = bin_or_none(arm);
    (bin != NO_BIN).then_some(bin as usize)
}

/// The bins whose middles are around a place seen from the axis, with their weights, if there are any.
pub(super) fn spot(arm: Vec3) -> Option<[(usize, f32); 4]> {
    let [level, sector] = coordinates(arm)?;
    let level = (level - 0.5).max(0.0);
    #[expect(clippy::cast_precision_loss, reason = "sectors are few")]
    let sector = sector + SECTORS as f32 - 0.5;
    let (up, on) = (level.fract(), sector.fract());
    let levels = [whole(level), (whole(level) + 1).min(LEVELS - 1)];
    let sectors = [whole(sector) % SECTORS, (whole(sector) + 1) % SECTORS];
    let at = |level: usize, sector: usize| levels[level] * SECTORS + sectors[sector];
    Some([
        (at(0, 0), (1.0 - up) * (1.0 - on)),
        (at(0, 1), (1.0 - up) * on),
        (at(1, 0), up * (1.0 - on)),
        (at(1, 1), up * on),
    ])
}

/// Triangles whose points are found together.
const TOGETHER: usize = 16;
/// Points of a triangle that are looked at: its first corner and the middles of its edges, because a cell of the
/// cloth may be as high as a level.
const POINTS: usize = 4;

/// Where the points of triangles are: by triangle, four of each.
struct Places {
    x: [f32; TOGETHER * POINTS],
    y: [f32; TOGETHER * POINTS],
    z: [f32; TOGETHER * POINTS],
}

/// A point of cloth.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) bin: usize,
    /// Distance from the axis [m].
    pub(super) radius: f32,
    /// Over the axis' point [m].
    pub(super) height: f32,
}

/// Calls `found` for points all over some triangles between `positions` [m] that begin between two heights [m]:
/// with the place of the triangle, and the point with its bin.
pub(super) fn each_point(
    trunk: Trunk,
    (triangles, positions): (&[[u32; 3]], &[Vec3]),
    heights: &Range<f32>,
    mut found: impl FnMut(usize, Point),
) {
    let mut places = Places {
        x: [0.0; TOGETHER * POINTS],
        y: [0.0; TOGETHER * POINTS],
        z: [0.0; TOGETHER * POINTS],
    };
    let mut own = [0; TOGETHER];
    let mut count = 0;
    for (triangle, corners) in triangles.iter().enumerate() {
        let corners = corners.map(|corner| positions[corner as usize]);
        if !heights.contains(&corners[0].y) {
            continue;
        }
        let [a, b, c] = corners.map(|place| trunk.local(place));
        for (point, place) in [a, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5]
            .into_iter()
            .enumerate()
        {
            let at = point * TOGETHER + count;
            (places.x[at], places.y[at], places.z[at]) = (place.x, place.y, place.z);
        }
        own[count] = triangle;
        count += 1;
        if count == TOGETHER {
            tell(&places, &own, &mut found);
            count = 0;
        }
    }
    tell(&places, &own[..count], &mut found);
}

/// Tells of the points of as many triangles as there are in `own`.
fn tell(places: &Places, own: &[usize], found: &mut impl FnMut(usize, Point)) {
    let mut bins = [0_u32; TOGETHER * POINTS];
    let mut radii = [0.0_f32; TOGETHER * POINTS];
    for at in 0..TOGETHER * POINTS {
        let arm = Vec3::new(places.x[at], places.y[at], places.z[at]);
        bins[at] = bin_or_none(arm);
        radii[at] = from_axis(arm);
    }
    for (place, &triangle) in own.iter().enumerate() {
        for point in 0..POINTS {
            let at = point * TOGETHER + place;
            if bins[at] != NO_BIN {
                let point = Point {
                    bin: bins[at] as usize,
                    radius: radii[at],
                    height: places.y[at],
                };
                found(triangle, point);
            }
        }
    }
}

/// No bin of any place.
const NO_BIN: u32 = u32::MAX;

/// The bin of a place seen from the axis, or [`NO_BIN`], without a branch.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "bins are few, and counted from 0"
)]
#[inline(always)]
fn bin_or_none(arm: Vec3) -> u32 {
    let level = level_at(arm);
    let sector = sector_at(arm) as u32;
    let sector = if sector < SECTORS as u32 {
        sector
    } else {
        sector - SECTORS as u32
    };
    if 0.0 <= level && level < LEVELS as f32 {
        level as u32 * SECTORS as u32 + sector
    } else {
        NO_BIN
    }
}

/// Level of a place seen from the axis, counted from the edge of the first.
#[expect(clippy::cast_precision_loss, reason = "bins are few")]
#[inline(always)]
fn level_at(arm: Vec3) -> f32 {
    arm.y / LEVEL + LEVELS_BELOW as f32
}

/// Sector of a place seen from the axis, counted from the edge of the first: once around in all, evenly enough and
/// without an angle.
#[expect(clippy::cast_precision_loss, reason = "bins are few")]
#[inline(always)]
fn sector_at(arm: Vec3) -> f32 {
    let share = arm.x / (arm.x.abs() + arm.z.abs()).max(1.0e-6);
    let around = if 0.0 <= arm.z {
        1.0 - share
    } else {
        3.0 + share
    };
    (around * (SECTORS / 4) as f32).max(0.0)
}

/// Level and sector of a place seen from the axis, both counted from the edge of the first.
#[expect(clippy::cast_precision_loss, reason = "bins are few")]
fn coordinates(arm: Vec3) -> Option<[f32; 2]> {
    let level = level_at(arm);
    (0.0 <= level && level < LEVELS as f32).then(|| [level, sector_at(arm)])
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "bins are few, and counted from 0"
)]
const fn whole(coordinate: f32) -> usize {
    coordinate as usize
}

/// Area of a bin at this distance from the axis [m²].
#[expect(clippy::cast_precision_loss, reason = "sectors are few")]
pub(super) const fn area_at(radius: f32) -> f32 {
    std::f32::consts::TAU * radius / SECTORS as f32 * LEVEL
}

#[inline(always)]
pub(super) fn from_axis(arm: Vec3) -> f32 {
    (arm.x * arm.x + arm.z * arm.z).sqrt()
}
