//! How flat gathers lie under what is worn over them.
//!
//! Gathers of thin cloth are soft: what lies over them and is stretched around the body flattens them
//! until it is slack. Folds of particles cannot be flattened so far, because their columns keep as far from
//! each other as they are wide. So gathers are simulated as they hang, and what is worn over them, and
//! whoever looks, finds them [pressed](Press::press): each place is drawn in towards the innermost of the
//! folds around it, all folds by the same share, so that what lies outside of another stays there.
//!
//! At a stretch `ε` around the body and a distance `r` from its axis, cloth has no tension at `r / (1 + ε)`:
//! so far the crests are drawn in, but not nearer to the innermost than their layers lie on each other,
//! as many as there is cloth over an area.

use std::ops::Range;

use glam::{Vec2, Vec3};

use super::wall::{
    LEVELS, SECTORS, Trunk, area_at, around, bin, each_point, from_axis, height_of, spot,
};

/// Sectors to either side over which the place of cloth is averaged: those that an envelope bridges.
const NEAR: usize = 3;
/// Sectors to either side over which the stretch of cloth is averaged, an eighth of the way around: tension
/// runs on around the body.
const ALONG: usize = SECTORS / 8;
/// Farthest that a stretch is believed: folds are none.
const MOST: f32 = 0.5;
/// What is left of a press from one level to the next beyond an edge: cloth does not bend at once.
const BEYOND: f32 = 0.5;
/// Levels beyond an edge in which a press is looked for: a four-thousandth of it is left there.
const FADED: usize = 12;
/// Share of its way that a press goes in a frame: crests come and go in a bin, and what is worn over them meets
/// where they are pressed to, and presses them.
const FOLLOW: f32 = 0.2;
/// A share less than this is none.
const LEAST: f32 = 1.0e-4;

/// Cloth that lies over gathers.
#[derive(Debug, Clone, Copy)]
pub struct OuterCloth<'a> {
    /// Corners of its triangles, shape `[triangle_count]`.
    pub triangles: &'a [[u32; 3]],
    /// Where its particles lie on the flat cloth [m].
    pub on_cloth: &'a [Vec2],
    /// Where they are [m].
    pub positions: &'a [Vec3],
}

/// What lies over gathers in one bin: its area [m²], that times its distance from the axis, and that times
/// its stretch around the axis.
#[derive(Debug, Clone, Copy, Default)]
struct Taut {
    area: f32,
    radius: f32,
    stretch: f32,
}

impl Taut {
    fn add(&mut self, other: &Self) {
        self.area += other.area;
        self.radius += other.radius;
        self.stretch += other.stretch;
    }
}

/// Gathers in one bin: nearest to the axis and farthest from it [m], and their area [m²].
#[derive(Debug, Clone, Copy)]
struct Full {
    low: f32,
    high: f32,
    area: f32,
}

const EMPTY: Full = Full {
    low: f32::INFINITY,
    high: 0.0,
    area: 0.0,
};

impl Default for Full {
    fn default() -> Self {
        EMPTY
    }
}

impl Full {
    fn add(&mut self, other: &Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
        self.area += other.area;
    }
}

/// How gathers are pressed in one bin: places farther from the axis than `low` [m] come nearer to that by
/// a `share` of the way.
#[derive(Debug, Clone, Copy, Default)]
struct Pressed {
    low: f32,
    share: f32,
}

impl Pressed {
    /// Goes the way from how it was a frame ago in part.
    fn follow(&mut self, before: &Self) {
        if 0.0 < self.low && 0.0 < before.low {
            self.low = before.low + (self.low - before.low) * FOLLOW;
        } else {
            self.low = self.low.max(before.low);
        }
        self.share = before.share + (self.share - before.share) * FOLLOW;
        if self.share < LEAST {
            *self = Self::default();
        }
    }
}

/// How gathers around a trunk are pressed.
#[derive(Debug, Clone)]
pub struct Press {
    trunk: Trunk,
    /// Heights over the axis between which anything is pressed [m]; empty where nothing is.
    heights: Range<f32>,
    /// Shape `[LEVELS, SECTORS]`, as the others.
    taut: Vec<Taut>,
    full: Vec<Full>,
    /// Room for a quarter of the area of every triangle [m²].
    areas: Vec<f32>,
    pressed: Vec<Pressed>,
    /// The same a frame ago, once there was one.
    before: Vec<Pressed>,
    is_known: bool,
}

impl Default for Press {
    fn default() -> Self {
        Self {
            trunk: Trunk::default(),
            heights: 0.0..0.0,
            taut: vec![Taut::default(); LEVELS * SECTORS],
            full: vec![EMPTY; LEVELS * SECTORS],
            areas: Vec::new(),
            pressed: vec![Pressed::default(); LEVELS * SECTORS],
            before: vec![Pressed::default(); LEVELS * SECTORS],
            is_known: false,
        }
    }
}

impl Press {
    /// Looks at what lies over gathers where a trunk is.
    pub fn tighten<'a>(&mut self, trunk: Trunk, over: impl Iterator<Item = OuterCloth<'a>>) {
        self.taut.fill(Taut::default());
        for over in over {
            for triangle in over.triangles {
                let corners = triangle.map(|corner| trunk.local(over.positions[corner as usize]));
                let flat = triangle.map(|corner| over.on_cloth[corner as usize]);
                self.add_taut(corners, flat);
            }
        }
        let is_taut = |level: &usize| {
            let level = &self.taut[level * SECTORS..(level + 1) * SECTORS];
            level.iter().any(|taut| 0.0 < taut.area)
        };
        let first = (0..LEVELS).find(is_taut);
        let last = (0..LEVELS).rev().find(is_taut);
        self.heights = first.zip(last).map_or(0.0..0.0, |(first, last)| {
            let end = (last + 1 + FADED).min(LEVELS);
            height_of(first.saturating_sub(FADED))..height_of(end)
        });
    }

    fn add_taut(&mut self, corners: [Vec3; 3], flat: [Vec2; 3]) {
        let [a, b, c] = corners;
        let middle = (a + b + c) / 3.0;
        let outward = middle.with_y(0.0).normalize_or_zero();
        // What lies across presses nothing.
        let area = 0.5 * (b - a).cross(c - a).dot(outward).abs();
        if let (Some(bin), Some(stretch)) = (bin(middle), stretch_around(corners, flat)) {
            let taut = &mut self.taut[bin];
            taut.area += area;
            taut.radius += area * from_axis(middle);
            taut.stretch += area * stretch.clamp(-MOST, MOST);
        }
    }

    /// Finds how flat gathers lie that are around a trunk a frame later, triangles and places [m], under what was
    /// looked at last: the first time at once, and then within a tenth of a second. Two layers of them lie `gap` [m] apart, and so does what is worn over them.
    pub fn flatten<'a>(
        &mut self,
        trunk: Trunk,
        gathers: impl Iterator<Item = (&'a [[u32; 3]], &'a [Vec3])>,
        gap: f32,
    ) {
        self.trunk = trunk;
        self.full.fill(EMPTY);
        let axis = trunk.axis.y;
        let heights = axis + self.heights.start..axis + self.heights.end;
        for cloth in gathers {
            self.areas.clear();
            let (triangles, positions) = cloth;
            self.areas.extend(triangles.iter().map(|triangle| {
                let [a, b, c] = triangle.map(|corner| positions[corner as usize]);
                if heights.contains(&a.y) {
                    0.125 * (b - a).cross(c - a).length()
                } else {
                    0.0
                }
            }));
            let (full, areas) = (&mut self.full, &self.areas);
            each_point(trunk, cloth, &heights, |triangle, point| {
                let full = &mut full[point.bin];
                full.low = full.low.min(point.radius);
                full.high = full.high.max(point.radius);
                full.area += areas[triangle];
            });
        }
        std::mem::swap(&mut self.pressed, &mut self.before);
        self.pressed.fill(Pressed::default());
        for level in 0..LEVELS {
            let near = level.saturating_sub(1)..(level + 2).min(LEVELS);
            let bins = near.start * SECTORS..near.end * SECTORS;
            if self.taut[bins].iter().all(|taut| taut.area == 0.0) {
                continue;
            }
            let ring: [Around; SECTORS] =
                std::array::from_fn(|sector| self.around(near.clone(), sector));
            for sector in 0..SECTORS {
                self.pressed[level * SECTORS + sector] = pressed_at(&ring, sector, gap);
            }
        }
        self.fade();
        if self.is_known {
            let pairs = self.pressed.iter_mut().zip(&self.before);
            pairs.for_each(|(now, before)| now.follow(before));
        }
        self.is_known = true;
    }

    /// Where gathers at `positions` [m] lie under what is worn over them.
    pub fn press(&self, positions: &[Vec3], out: &mut Vec<Vec3>) {
        out.clear();
        out.extend(positions.iter().map(|&place| self.pressed_place(place)));
    }

    fn pressed_place(&self, place: Vec3) -> Vec3 {
        if !self.heights.contains(&(place.y - self.trunk.axis.y)) {
            return place;
        }
        let local = self.trunk.local(place);
        let Some(corners) = spot(local) else {
            return place;
        };
        // What is not pressed has no say in where that leads.
        let (mut share, mut low) = (0.0, 0.0);
        for (bin, weight) in corners {
            let pressed = self.pressed[bin];
            share += weight * pressed.share;
            low += weight * pressed.share * pressed.low;
        }
        let radius = from_axis(local);
        let inward = share * radius - low;
        if inward <= 0.0 {
            return place;
        }
        place - (place - self.trunk.axis).with_y(0.0) * (inward / radius)
    }

    /// What lies in one direction at some levels.
    fn around(&self, levels: Range<usize>, sector: usize) -> Around {
        let mut around = Around::default();
        for bin in levels.map(|level| level * SECTORS + sector) {
            around.taut.add(&self.taut[bin]);
            around.full.add(&self.full[bin]);
            around.bins += 1.0;
        }
        around
    }

    /// Lets the press fade beyond what is worn over the gathers.
    fn fade(&mut self) {
        let pairs = (1..LEVELS).map(|level| (level - 1, level));
        let beyond = pairs.clone().map(|(below, level)| (level, below));
        for (from, to) in pairs.chain(beyond.rev()) {
            for sector in 0..SECTORS {
                let from = self.pressed[from * SECTORS + sector];
                let to_bin = to * SECTORS + sector;
                let full = self.full[to_bin];
                let to = &mut self.pressed[to_bin];
                if to.share < BEYOND * from.share && 0.0 < full.area {
                    *to = Pressed {
                        low: from.low.min(full.low),
                        share: BEYOND * from.share,
                    };
                }
            }
        }
    }
}

/// What lies in one direction around a height: over the gathers, the gathers, and in how many bins.
#[derive(Debug, Clone, Copy, Default)]
struct Around {
    taut: Taut,
    full: Full,
    bins: f32,
}

/// How gathers are pressed in one direction of a ring, of which two layers lie `gap` [m] apart.
fn pressed_at(ring: &[Around; SECTORS], sector: usize, gap: f32) -> Pressed {
    let mut near = Around::default();
    for other in around(sector, NEAR).map(|sector| &ring[sector]) {
        near.taut.add(&other.taut);
        near.full.add(&other.full);
        near.bins += other.bins;
    }
    let (place, full) = (near.taut, near.full);
    if place.area <= 0.0 || full.area <= 0.0 {
        return Pressed::default();
    }
    let mut taut = Taut::default();
    for sector in around(sector, ALONG) {
        taut.area += ring[sector].taut.area;
        taut.stretch += ring[sector].taut.stretch;
    }
    let slack = place.radius / (place.area + taut.stretch * place.area / taut.area) - gap;
    let layers = full.area / (near.bins * area_at(full.low));
    let room = slack.max(full.low + layers * gap);
    let share = (full.high - room) / (full.high - full.low).max(1.0e-6);
    Pressed {
        low: full.low,
        share: share.clamp(0.0, 1.0),
    }
}

/// Strain of a triangle in its level direction; `None` where it has none, or lies level.
fn stretch_around([a, b, c]: [Vec3; 3], [flat_a, flat_b, flat_c]: [Vec2; 3]) -> Option<f32> {
    let (u, v) = (b - a, c - a);
    let (flat_u, flat_v) = (flat_b - flat_a, flat_c - flat_a);
    // `u s + v t` is level.
    let (s, t) = (v.y, -u.y);
    let (length, flat) = ((u * s + v * t).length(), (flat_u * s + flat_v * t).length());
    (1.0e-9 < flat).then(|| length / flat - 1.0)
}
