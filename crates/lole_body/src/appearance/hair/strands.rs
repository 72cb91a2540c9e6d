//! Single strands over the hair: thin ribbons that run as it is combed and begin one by one at the hairline. Stills
//! show them; what moves is drawn without, because from a film's distance each is finer than a pixel.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};
use lole_geom::chance::Chance;
use lole_geom::trig;

use super::super::hair_paint::hairline_v;
use super::fall::{COLUMNS, Fall, RINGS};
use super::{BUN_LATITUDE, HEAD_ALONE, Scalp, direction, frame, from_top, lock_height};
use crate::surface::warp::smooth_step;
use crate::{HairStyle, MeshPart, PartKind, SkinnedMesh};

/// Places along a strand.
const STEPS: u16 = 12;
/// Strands of each kind.
const ON_CAP: u16 = 1500;
const ON_FALL: u16 = 700;
const ON_BUN: u16 = 260;
/// Half the width of a strand [m]: several hairs that lie together.
const HALF_WIDTH: [f32; 2] = [0.000_30, 0.000_65];
/// How far above what is combed together a strand lies [m].
const LIFT: [f32; 2] = [0.000_1, 0.000_6];
/// A strand turns its flat side to either side by up to this [rad]: they do not all shine at once.
const ROLL: f32 = 0.55;
/// Its flat side is lit as if it were round: normals at its edges lean out this far.
const ROUND: f32 = 0.45;

/// The strands of a style, as one part, and the first vertex of those of open hair.
pub(super) fn strands(
    scalp: &Scalp<'_>,
    style: HairStyle,
    fall: Option<&Fall>,
) -> (SkinnedMesh, usize) {
    let mut chance = Chance::new(1959);
    let mut mesh = SkinnedMesh::default();
    let mut triangles = Vec::new();
    let mut add = |strand: Option<Strand>, chance: &mut Chance| {
        if let Some(strand) = strand {
            strand.add_to(&mut mesh, &mut triangles, chance);
        }
        mesh.positions.len()
    };
    let mut of_fall = 0;
    for index in 0..ON_CAP {
        let strand = scalp.on_cap(style, index, &mut chance);
        of_fall = add(strand, &mut chance);
    }
    if matches!(style, HairStyle::OfFigure | HairStyle::Bun) {
        for _ in 0..ON_BUN {
            let strand = scalp.on_bun(&mut chance);
            of_fall = add(Some(strand), &mut chance);
        }
    }
    if let Some(fall) = fall {
        for _ in 0..ON_FALL {
            let strand = on_fall(fall, &mut chance);
            add(strand, &mut chance);
        }
    }
    mesh.parts.push(MeshPart {
        kind: PartKind::Hair,
        triangles,
    });
    (mesh, of_fall)
}

/// One place along a strand.
#[derive(Clone, Copy)]
struct Knot {
    /// Where it is in the bind pose [m].
    place: Vec3,
    /// Unit vector away from what it lies on.
    outward: Vec3,
    /// Row of the hair's picture.
    v: f32,
    carried: ([u16; 4], [f32; 4]),
}

struct Strand {
    knots: Vec<Knot>,
    /// Column of the hair's picture.
    u: f32,
}

impl Strand {
    /// Adds it as a ribbon that is pointed at both ends.
    fn add_to(&self, mesh: &mut SkinnedMesh, triangles: &mut Vec<[u32; 3]>, chance: &mut Chance) {
        let half = chance.between(HALF_WIDTH[0], HALF_WIDTH[1]);
        let (sin, cos) = trig::sin_cos(chance.between(-ROLL, ROLL));
        let last = self.knots.len().saturating_sub(1);
        for (index, knot) in self.knots.iter().enumerate() {
            let ahead = self.knots[(index + 1).min(last)].place;
            let along = ahead - self.knots[index.saturating_sub(1)].place;
            let side = along.cross(knot.outward).normalize_or_zero();
            let up = side.cross(along).normalize_or_zero();
            let (across, normal) = (side * cos + up * sin, up * cos - side * sin);
            let share = index as f32 / last.max(1) as f32;
            let pointed = smooth_step(share / 0.22).min(smooth_step((1.0 - share) / 0.22));
            for edge in [-1.0, 1.0] {
                let width = half * (0.12 + 0.88 * pointed);
                mesh.positions.push(knot.place + across * (edge * width));
                mesh.normals
                    .push((normal + across * (edge * ROUND)).normalize_or_zero());
                mesh.uvs.push(Vec2::new(self.u, knot.v));
                mesh.joints.push(knot.carried.0);
                mesh.weights.push(knot.carried.1);
            }
        }
        let end = u32::try_from(mesh.positions.len()).unwrap_or(u32::MAX);
        let start = end - 2 * u32::try_from(self.knots.len()).unwrap_or(0);
        for step in 0..u32::try_from(last).unwrap_or(0) {
            let first = start + 2 * step;
            triangles.push([first, first + 1, first + 2]);
            triangles.push([first + 1, first + 3, first + 2]);
        }
    }
}

impl Scalp<'_> {
    /// A strand on the cap, at one of the directions around the crown; `None` where there is no hair.
    fn on_cap(&self, style: HairStyle, index: u16, chance: &mut Chance) -> Option<Strand> {
        let azimuth = TAU * (f32::from(index) + chance.share()) / f32::from(ON_CAP);
        let (across, up) = frame(self.crown);
        let towards = |polar: f32, azimuth: f32| {
            let (sin_polar, cos_polar) = trig::sin_cos(polar);
            let (sin_azimuth, cos_azimuth) = trig::sin_cos(azimuth);
            let around = across * cos_azimuth + up * sin_azimuth;
            (self.crown * cos_polar + around * sin_polar).normalize_or_zero()
        };
        let rim = (0..=150_u8)
            .map(|step| PI - f32::from(step) * (PI / 150.0))
            .find(|&polar| self.inside(towards(polar, azimuth)) > 0.0)?;
        let free = chance.share();
        let (from, to) = match style {
            // Grown out from the crown, ends free.
            HairStyle::Short => {
                let root = 0.08 + (rim - 0.16) * free.sqrt();
                (root, (root + chance.between(0.22, 0.45)).min(rim + 0.01))
            }
            HairStyle::Bob => (
                chance.between(0.05, 0.5),
                rim - chance.between(-0.012, 0.03),
            ),
            // Combed from the hairline to the crown; half of them rise from under others.
            _ => {
                let first = chance.between(-0.055, 0.03);
                let root = if index.is_multiple_of(2) {
                    first
                } else {
                    first + 0.55 * (rim - 0.3) * free
                };
                (rim - root, 0.26)
            }
        };
        let drift = chance.between(-0.035, 0.035);
        let height = self.k * chance.between(LIFT[0], LIFT[1]);
        let tip = if style == HairStyle::Short {
            0.0006 * self.k
        } else {
            0.0
        };
        let knot = |step: u16| {
            let share = f32::from(step) / f32::from(STEPS);
            let polar = from + (to - from) * share;
            let azimuth = azimuth + drift * trig::sin(PI * share);
            let towards = towards(polar, azimuth);
            let spot = super::Spot::of(polar, azimuth, (across, up));
            let depth = smooth_step((self.inside(towards) - 3.0) / 14.0) * spot.sin_polar;
            let root = smooth_step(share / 0.15);
            let off = height * root + 0.0001 * (1.0 - root) + tip * share * share;
            let combed = self.radius(towards) + lock_height(&spot) * depth * self.k;
            // What is combed back begins on bare skin.
            let out = match style {
                HairStyle::Short | HairStyle::Bob => combed,
                _ => combed.max(self.skin(towards)),
            };
            let out = out + off;
            let inside = self.inside(towards).max(9.0) + self.dense;
            Knot {
                place: self.center + towards * out,
                outward: towards,
                v: hairline_v(inside),
                carried: HEAD_ALONE,
            }
        };
        Some(Strand {
            knots: (0..=STEPS).map(knot).collect(),
            u: from_top(azimuth) + chance.between(-0.02, 0.02),
        })
    }

    /// A strand that is wound around the bun with its ropes.
    fn on_bun(&self, chance: &mut Chance) -> Strand {
        let axis = direction(180.0, BUN_LATITUDE);
        let (center, _) = self.bun_ball();
        let (across, up) = frame(axis);
        let phase = chance.between(0.0, TAU);
        let from = chance.between(0.15, 1.6);
        let height = self.k * chance.between(LIFT[0], LIFT[1]) * 0.6;
        let knot = |step: u16| {
            let polar = from + 0.55 * f32::from(step) / f32::from(STEPS);
            let spot = super::Spot::of(polar, phase - 7.5 * polar, (across, up));
            let place = self.on_bun_at(&spot);
            let outward = (place - center).normalize_or_zero();
            Knot {
                place: place + outward * height,
                outward,
                v: hairline_v(24.0 + 10.0 * trig::sin(polar * 3.0 + phase)),
                carried: HEAD_ALONE,
            }
        };
        Strand {
            knots: (0..=STEPS).map(knot).collect(),
            u: chance.between(0.1, 0.9),
        }
    }
}

/// A strand down the fall; ends lie at unlike heights.
fn on_fall(fall: &Fall, chance: &mut Chance) -> Option<Strand> {
    let last = (COLUMNS - 1) as f32;
    let column = chance.between(0.2, last - 0.2);
    let rings = (RINGS - 1) as f32;
    let (from, to) = (
        chance.between(0.0, 0.45) * rings,
        rings * chance.between(0.90, 1.0),
    );
    let drift = chance.between(-1.2, 1.2);
    let height = chance.between(LIFT[0], LIFT[1]) * 1.4;
    let knot = |step: u16| {
        let share = f32::from(step) / f32::from(2 * STEPS);
        let ring = from + (to - from) * share;
        let column = (column + drift * share * share).clamp(0.05, last - 0.05);
        let (place, outward) = fall.at(ring, column)?;
        let place = place + outward * height * smooth_step(share / 0.1);
        Some(Knot {
            place,
            outward,
            v: hairline_v(16.0 + 50.0 * ring / rings),
            carried: fall.carried(place.y),
        })
    };
    Some(Strand {
        knots: (0..=2 * STEPS).map(knot).collect::<Option<_>>()?,
        u: 0.1 + 0.6 * column / last + chance.between(-0.02, 0.02),
    })
}
