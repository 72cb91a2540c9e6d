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

use glam::{Vec2, Vec3};

use super::wall::{LEVELS, SECTORS, Trunk, area_at, around, bin, from_axis, spot};

/// Sectors to either side over which the place of cloth is averaged: those that an envelope bridges.
const NEAR: usize = 3;
/// Sectors to either side over which the stretch of cloth is averaged, an eighth of the way around: tension
/// runs on around the body.
const ALONG: usize = SECTORS / 8;
/// Farthest that a stretch is believed: folds are none.
const MOST: f32 = 0.5;
/// What is left of a press from one level to the next beyond an edge: cloth does not bend at once.
const BEYOND: f32 = 0.5;

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

/// How gathers are pressed in one bin: places farther from the axis than `low` [m] come nearer to that by
/// a `share` of the way.
#[derive(Debug, Clone, Copy, Default)]
struct Pressed {
    low: f32,
    share: f32,
}

/// How gathers around a trunk are pressed.
#[derive(Debug, Clone)]
pub struct Press {
    trunk: Trunk,
    /// Shape `[LEVELS, SECTORS]`, as the others.
    taut: Vec<Taut>,
    full: Vec<Full>,
    pressed: Vec<Pressed>,
}

impl Default for Press {
    fn default() -> Self {
        Self {
            trunk: Trunk::default(),
            taut: vec![Taut::default(); LEVELS * SECTORS],
            full: vec![EMPTY; LEVELS * SECTORS],
            pressed: vec![Pressed::default(); LEVELS * SECTORS],
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

    /// Finds how flat gathers lie that are around a trunk now, triangles and places [m], under what was
    /// looked at last. Two layers of them lie `gap` [m] apart, and so does what is worn over them.
    pub fn flatten<'a>(
        &mut self,
        trunk: Trunk,
        gathers: impl Iterator<Item = (&'a [[u32; 3]], &'a [Vec3])>,
        gap: f32,
    ) {
        self.trunk = trunk;
        self.full.fill(EMPTY);
        for (triangles, positions) in gathers {
            for triangle in triangles {
                let corners = triangle.map(|corner| trunk.local(positions[corner as usize]));
                self.add_full(corners);
            }
        }
        self.pressed.fill(Pressed::default());
        for level in 0..LEVELS {
            let near = level.saturating_sub(1) * SECTORS..(level + 2).min(LEVELS) * SECTORS;
            if self.taut[near].iter().all(|taut| taut.area == 0.0) {
                continue;
            }
            for sector in 0..SECTORS {
                self.pressed[level * SECTORS + sector] = self.pressed_at((level, sector), gap);
            }
        }
        self.fade();
    }

    fn add_full(&mut self, [a, b, c]: [Vec3; 3]) {
        let area = 0.5 * (b - a).cross(c - a).length();
        // A cell of the cloth may be as high as a level.
        for point in [a, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5] {
            if let Some(bin) = bin(point) {
                let full = &mut self.full[bin];
                let radius = from_axis(point);
                full.low = full.low.min(radius);
                full.high = full.high.max(radius);
                full.area += 0.25 * area;
            }
        }
    }

    /// Where gathers at `positions` [m] lie under what is worn over them.
    pub fn press(&self, positions: &[Vec3], out: &mut Vec<Vec3>) {
        out.clear();
        out.extend(positions.iter().map(|&place| self.pressed_place(place)));
    }

    fn pressed_place(&self, place: Vec3) -> Vec3 {
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

    /// The bins around one, within so many sectors and a level.
    fn around(level: usize, sector: usize, reach: usize) -> impl Iterator<Item = usize> {
        let levels = level.saturating_sub(1)..(level + 2).min(LEVELS);
        levels.flat_map(move |level| around(sector, reach).map(move |it| level * SECTORS + it))
    }

    fn pressed_at(&self, (level, sector): (usize, usize), gap: f32) -> Pressed {
        let (mut place, mut full, mut outline) = (Taut::default(), EMPTY, 0.0);
        for bin in Self::around(level, sector, NEAR) {
            let (taut, other) = (&self.taut[bin], &self.full[bin]);
            place.area += taut.area;
            place.radius += taut.radius;
            full.low = full.low.min(other.low);
            full.high = full.high.max(other.high);
            full.area += other.area;
            outline += 1.0;
        }
        if place.area <= 0.0 || full.area <= 0.0 {
            return Pressed::default();
        }
        let mut taut = Taut::default();
        for bin in Self::around(level, sector, ALONG) {
            taut.area += self.taut[bin].area;
            taut.stretch += self.taut[bin].stretch;
        }
        let slack = place.radius / (place.area + taut.stretch * place.area / taut.area) - gap;
        let layers = full.area / (outline * area_at(full.low));
        let room = slack.max(full.low + layers * gap);
        let share = (full.high - room) / (full.high - full.low).max(1.0e-6);
        Pressed {
            low: full.low,
            share: share.clamp(0.0, 1.0),
        }
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

/// Strain of a triangle in its level direction; `None` where it has none, or lies level.
fn stretch_around([a, b, c]: [Vec3; 3], [flat_a, flat_b, flat_c]: [Vec2; 3]) -> Option<f32> {
    let (u, v) = (b - a, c - a);
    let (flat_u, flat_v) = (flat_b - flat_a, flat_c - flat_a);
    // `u s + v t` is level.
    let (s, t) = (v.y, -u.y);
    let (length, flat) = ((u * s + v * t).length(), (flat_u * s + flat_v * t).length());
    (1.0e-9 < flat).then(|| length / flat - 1.0)
}
