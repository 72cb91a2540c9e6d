//! The outline of what is worn inside, as a surface that the next garment meets like skin.
//!
//! Gathers are deeper than what lies over them can follow: an outer skirt rests on the crests. The
//! envelope is how far the inner garments stand out from the axis of the trunk, by height and
//! direction, bridged from crest to crest. It is smooth, lies outside of every particle it was made
//! of, and moves from frame to frame, so that contact with skin is contact with cloth worn inside.

use glam::Vec3;
use lole_geom::Surfel;

/// Directions around the axis that are told apart.
const SECTORS: usize = 144;
/// Heights that are told apart, and their distance [m].
const LEVELS: usize = 128;
const LEVEL: f32 = 0.015;
/// Levels below the height of the axis: as far as from the hips to the floor, and more.
const LEVELS_BELOW: usize = 88;

/// Sectors to either side that are bridged: about a gather's width at the hips, half of a fold's at
/// the hem.
const BRIDGE: usize = 3;

/// Where a surfel is put whose bin is empty [m]: no cloth comes there.
const NOWHERE: Vec3 = Vec3::splat(1.0e4);

/// Where the trunk is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trunk {
    /// A point of its upright axis [m].
    pub axis: Vec3,
    /// Horizontal unit vector that turns with it.
    pub forward: Vec3,
}

/// How far garments stand out; its room is kept from frame to frame.
#[derive(Debug, Clone)]
pub struct Envelope {
    trunk: Trunk,
    /// Farthest distance from the axis [m], 0 where nothing is worn; shape `[LEVELS, SECTORS]`.
    radii: Vec<f32>,
    /// The same, bridged.
    bridged: Vec<f32>,
    /// Outward direction of every sector, where forward is `z`.
    directions: Vec<Vec3>,
}

impl Default for Envelope {
    fn default() -> Self {
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
        Self {
            trunk: Trunk {
                axis: Vec3::ZERO,
                forward: Vec3::Z,
            },
            radii: vec![0.0; LEVELS * SECTORS],
            bridged: Vec::new(),
            directions: (0..SECTORS).map(direction).collect(),
        }
    }
}

impl Envelope {
    /// Nothing worn yet.
    pub fn begin(&mut self, trunk: Trunk) {
        self.trunk = trunk;
        self.radii.fill(0.0);
    }

    /// Puts on the `triangles` between `positions` [m].
    pub fn put_on(&mut self, triangles: &[[u32; 3]], positions: &[Vec3]) {
        let side = Vec3::Y.cross(self.trunk.forward);
        for triangle in triangles {
            let corners = triangle.map(|corner| {
                let arm = positions[corner as usize] - self.trunk.axis;
                Vec3::new(arm.dot(side), arm.y, arm.dot(self.trunk.forward))
            });
            // A cell of the cloth may be as high as a level.
            let [a, b, c] = corners;
            for point in [a, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5] {
                if let Some(bin) = bin(point) {
                    self.radii[bin] = self.radii[bin].max(from_axis(point));
                }
            }
        }
    }

    /// Adds the surface, a surfel for every bin, `inset` [m] inside of it.
    pub fn add_surfels(&mut self, inset: f32, surfels: &mut Vec<Surfel>) {
        self.bridge();
        let side = Vec3::Y.cross(self.trunk.forward);
        let forward = self.trunk.forward;
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

    /// How far a place is outside of what is worn, after [`Self::add_surfels`], and the way out [m];
    /// `None` where nothing is worn.
    #[must_use]
    pub fn clearance(&self, place: Vec3) -> Option<(f32, Vec3)> {
        let side = Vec3::Y.cross(self.trunk.forward);
        let arm = place - self.trunk.axis;
        let local = Vec3::new(arm.dot(side), arm.y, arm.dot(self.trunk.forward));
        let radius = *self.bridged.get(bin(local)?)?;
        let outward = arm.with_y(0.0).try_normalize()?;
        (0.0 < radius).then(|| (from_axis(local) - radius, outward))
    }

    /// Spans what lies between crests, outside of everything worn: the mean of as many farthest
    /// places as each of them looked at.
    fn bridge(&mut self) {
        let mut crests = [0.0_f32; SECTORS];
        self.bridged.clear();
        for ring in self.radii.chunks(SECTORS) {
            let around = |sector: usize| {
                (0..=2 * BRIDGE).map(move |step| (sector + SECTORS + step - BRIDGE) % SECTORS)
            };
            for (sector, crest) in crests.iter_mut().enumerate() {
                *crest = around(sector).fold(0.0, |most, near| most.max(ring[near]));
            }
            let mean = |sector: usize| {
                let worn = || around(sector).map(|near| crests[near]).filter(|&r| 0.0 < r);
                if crests[sector] == 0.0 {
                    return 0.0;
                }
                #[expect(clippy::cast_precision_loss, reason = "sectors are few")]
                let count = worn().count() as f32;
                worn().sum::<f32>() / count
            };
            self.bridged.extend((0..SECTORS).map(mean));
        }
    }

    /// Where the surface of a bin is from the axis [m], with forward along `z`; `None` where nothing
    /// is worn.
    #[expect(clippy::cast_precision_loss, reason = "levels are few")]
    fn place(&self, level: usize, sector: usize) -> Option<Vec3> {
        let radius = self.bridged[level * SECTORS + sector];
        let height = (level as f32 + 0.5 - LEVELS_BELOW as f32) * LEVEL;
        (0.0 < radius).then(|| self.directions[sector] * radius + Vec3::Y * height)
    }
}

/// The bin of a place seen from the axis, if there is one.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "clamped to the bins"
)]
fn bin(arm: Vec3) -> Option<usize> {
    let level = arm.y / LEVEL + LEVELS_BELOW as f32;
    if !(0.0 <= level && level < LEVELS as f32) {
        return None;
    }
    // Once around in 0..4, evenly enough and without an angle.
    let share = arm.x / (arm.x.abs() + arm.z.abs()).max(1.0e-6);
    let around = if 0.0 <= arm.z {
        1.0 - share
    } else {
        3.0 + share
    };
    let sector = (around * (SECTORS / 4) as f32).max(0.0) as usize % SECTORS;
    Some(level as usize * SECTORS + sector)
}

fn from_axis(arm: Vec3) -> f32 {
    (arm.x * arm.x + arm.z * arm.z).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pleated tube of 400 columns: radius 0.25 m and ±0.02 m, from 0.1 m above the axis' point to
    /// 0.5 m below it.
    fn pleats(trunk: Trunk) -> (Vec<[u32; 3]>, Vec<Vec3>) {
        let (columns, rows) = (400_u16, 41_u16);
        let side = Vec3::Y.cross(trunk.forward);
        let place = |row: u16, column: u16| {
            let angle = f32::from(column) * std::f32::consts::TAU / f32::from(columns);
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            let radius = 0.25 + 0.02 * lole_geom::trig::sin_cos(40.0 * angle).0;
            let height = 0.1 - 0.015 * f32::from(row);
            trunk.axis + (side * cos + trunk.forward * sin) * radius + Vec3::Y * height
        };
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| place(row, column)));
        let at = |row: u16, column: u16| u32::from(row * columns + column % columns);
        let cells = (0..rows - 1).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let halves = cells.flat_map(|(row, column)| {
            let [first, right] = [at(row, column), at(row, column + 1)];
            let [below, last] = [at(row + 1, column), at(row + 1, column + 1)];
            [[first, right, last], [first, last, below]]
        });
        (halves.collect(), places.collect())
    }

    fn enveloped(trunk: Trunk) -> (Vec<Surfel>, Vec<Vec3>) {
        let (triangles, positions) = pleats(trunk);
        let mut envelope = Envelope::default();
        envelope.begin(trunk);
        envelope.put_on(&triangles, &positions);
        let mut surfels = Vec::new();
        envelope.add_surfels(0.0, &mut surfels);
        (surfels, positions)
    }

    #[test]
    fn crests_are_bridged_and_nothing_worn_stands_out() {
        let trunk = Trunk {
            axis: Vec3::new(0.1, 0.9, -0.2),
            forward: Vec3::Z,
        };
        let (surfels, positions) = enveloped(trunk);
        let worn: Vec<&Surfel> = surfels.iter().filter(|s| s.position != NOWHERE).collect();
        assert_eq!(worn.len(), 41 * SECTORS);
        for surfel in &worn {
            let arm = surfel.position - trunk.axis;
            let radius = from_axis(arm);
            assert!((radius - 0.27).abs() < 0.003, "{radius} m");
            let outward = arm.with_y(0.0) / radius;
            assert!(0.99 < surfel.normal.dot(outward), "{}", surfel.normal);
        }
        for &position in &positions {
            let near = worn.iter().min_by(|a, b| {
                let [a, b] = [a, b].map(|surfel| surfel.position.distance(position));
                a.total_cmp(&b)
            });
            let height = near.map(|near| near.normal.dot(position - near.position));
            assert!(height.is_some_and(|height| height < 0.001), "{height:?}");
        }
    }

    #[test]
    fn the_surface_turns_and_goes_with_the_trunk() {
        let at = |axis: Vec3, forward: Vec3| enveloped(Trunk { axis, forward }).0;
        let still = at(Vec3::ZERO, Vec3::Z);
        let moved = at(Vec3::new(1.0, 0.5, 0.0), Vec3::X);
        for (still, moved) in still.iter().zip(&moved) {
            if still.position == NOWHERE {
                continue;
            }
            let turned = |v: Vec3| Vec3::new(v.z, v.y, -v.x);
            let place = turned(still.position) + Vec3::new(1.0, 0.5, 0.0);
            assert!(place.distance(moved.position) < 1e-3, "{place}");
            assert!(0.999 < turned(still.normal).dot(moved.normal));
        }
    }

    #[test]
    fn a_place_is_as_far_outside_as_it_is_from_the_crests() {
        let trunk = Trunk {
            axis: Vec3::new(0.1, 0.9, -0.2),
            forward: Vec3::X,
        };
        let (triangles, positions) = pleats(trunk);
        let mut envelope = Envelope::default();
        envelope.begin(trunk);
        envelope.put_on(&triangles, &positions);
        assert_eq!(envelope.clearance(trunk.axis + Vec3::X * 0.3), None);
        envelope.add_surfels(0.0, &mut Vec::new());
        for (radius, height) in [(0.3, 0.0), (0.2, -0.2), (0.35, -0.4)] {
            let place = trunk.axis + Vec3::new(0.6, 0.0, 0.8) * radius + Vec3::Y * height;
            let (clearance, outward) = envelope.clearance(place).unwrap();
            assert!((clearance - (radius - 0.27)).abs() < 0.003, "{clearance}");
            assert!(outward.distance(Vec3::new(0.6, 0.0, 0.8)) < 1e-5);
        }
        let above = trunk.axis + Vec3::new(0.3, 0.3, 0.0);
        assert_eq!(envelope.clearance(above), None);
    }

    #[test]
    fn nothing_worn_is_nowhere_and_as_many_surfels() {
        let mut envelope = Envelope::default();
        let mut surfels = Vec::new();
        envelope.put_on(
            &[[0, 1, 2]],
            &[Vec3::NAN, Vec3::INFINITY, Vec3::splat(50.0)],
        );
        envelope.add_surfels(0.0, &mut surfels);
        assert_eq!(surfels.len(), LEVELS * SECTORS);
        assert!(surfels.iter().all(|surfel| surfel.position == NOWHERE));
    }
}
