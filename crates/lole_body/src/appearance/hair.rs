//! Her hair: a smooth cap combed back into a bun, and a plumeria behind the left ear.
//!
//! The cap is a closed surface around the head whose distance from the skin falls from a few
//! millimeters to below zero across the hairline: where it dives under the skin, hair ends.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};
use lole_geom::mesh::vertex_normals;
use lole_geom::trig;

use crate::surface::Shape;
use crate::surface::field::Head;
use crate::surface::pchip::Pchip;
use crate::surface::warp::smooth_step;
use crate::{Bone, MeshPart, PartKind, SkinnedMesh};

/// Latitude of the hairline [°] by longitude from the front [°]: forehead, temple, over the ear,
/// nape.
const HAIRLINE: [[f32; 2]; 11] = [
    [0.0, 40.0],
    [22.0, 39.0],
    [40.0, 34.0],
    [56.0, 23.0],
    [68.0, 9.0],
    [78.0, 4.0],
    [98.0, 4.0],
    [110.0, -6.0],
    [124.0, -26.0],
    [144.0, -38.0],
    [180.0, -42.0],
];
/// Direction of the bun: straight back, this much up [°].
const BUN_LATITUDE: f32 = 24.0;
/// Radius of the bun [m] at a stature of 158.5 cm.
const BUN_RADIUS: f32 = 0.041;
/// Longitude and latitude of the flower [°], on the left.
const FLOWER: [f32; 2] = [72.0, 16.0];
/// Radius of the flower [m].
const FLOWER_RADIUS: f32 = 0.034;
/// Locks combed towards the bun.
const LOCKS: f32 = 26.0;

/// Appends hair and flower to the skin, all carried by the head.
pub(crate) fn add_hair(skin: &mut SkinnedMesh, shape: &Shape) {
    let scalp = Scalp {
        head: shape.head.head(),
        center: shape.body.head.center,
        k: shape.body.height / 1.585,
        hairline: Pchip::new(&HAIRLINE),
    };
    let mut hair = scalp.cap();
    hair.append(&scalp.bun());
    let (petals, heart) = scalp.flower();
    for (kind, solid) in [
        (PartKind::Hair, hair),
        (PartKind::Flower, petals),
        (PartKind::FlowerHeart, heart),
    ] {
        solid.add_to(skin, kind);
    }
}

struct Scalp<'a> {
    head: &'a Head,
    center: Vec3,
    /// Stature over 1.585 m.
    k: f32,
    hairline: Pchip,
}

/// A closed surface, triangles counter-clockwise seen from outside.
#[derive(Default)]
struct Solid {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

/// Unit vector at a longitude from the front towards the left and a latitude [°].
fn direction(longitude: f32, latitude: f32) -> Vec3 {
    let (sin_lon, cos_lon) = trig::sin_cos(longitude.to_radians());
    let (sin_lat, cos_lat) = trig::sin_cos(latitude.to_radians());
    Vec3::new(sin_lon * cos_lat, sin_lat, cos_lon * cos_lat)
}

/// Two unit vectors that make a right-handed frame with `axis`.
fn frame(axis: Vec3) -> (Vec3, Vec3) {
    let across = Vec3::Y.cross(axis).normalize_or_zero();
    (across, axis.cross(across))
}

/// A place on a ball around an axis.
struct Spot {
    /// Angle from the axis [rad].
    polar: f32,
    /// Angle around the axis [rad].
    azimuth: f32,
    sin_polar: f32,
    cos_polar: f32,
    /// Unit vector from the axis outwards.
    around: Vec3,
}

/// Rings of vertices from one pole of `axis` to the other, as many parts as `counts` says along
/// and around it, each vertex where `place` puts it.
fn rings(counts: [usize; 2], axis: Vec3, place: impl Fn(Spot) -> Vec3) -> Vec<Vec<Vec3>> {
    let (across, up) = frame(axis);
    let ring = |ring: usize| {
        let polar = PI * ring as f32 / counts[0] as f32;
        let (sin_polar, cos_polar) = trig::sin_cos(polar);
        let vertex = |step: usize| {
            let azimuth = TAU * step as f32 / counts[1] as f32;
            let (sin_azimuth, cos_azimuth) = trig::sin_cos(azimuth);
            place(Spot {
                polar,
                azimuth,
                sin_polar,
                cos_polar,
                around: across * cos_azimuth + up * sin_azimuth,
            })
        };
        (0..counts[1]).map(vertex).collect()
    };
    (1..counts[0]).map(ring).collect()
}

impl Scalp<'_> {
    /// Distance [m] of the hair from the head's center in a direction.
    fn radius(&self, towards: Vec3) -> f32 {
        const UNDER: f32 = -0.006;
        const ROOT: f32 = 0.0035;
        const FULL: f32 = 0.010;
        const BURIED: f32 = 0.045;
        let latitude = trig::asin(towards.y).to_degrees();
        let longitude = trig::atan2(towards.x.abs(), towards.z).to_degrees();
        // Above the ear the skin sticks out: the skull lies at most this far from the center.
        let skin = self.head.radius(longitude, latitude);
        let inside = latitude - self.hairline.at(longitude);
        let root = UNDER + (ROOT - UNDER) * smooth_step((inside + 6.0) / 9.0);
        let cover = root + (FULL - ROOT) * smooth_step((inside - 1.0) / 30.0);
        let buried = smooth_step((-inside - 7.0) / 18.0);
        let visible = skin + cover * self.k;
        visible + (BURIED * self.k - visible).min(0.0) * buried
    }

    /// The cap: rings around the bun's axis, so that combed locks run to the bun.
    fn cap(&self) -> Solid {
        const RINGS: usize = 38;
        const AROUND: usize = 104;
        const LOCK_DEPTH: f32 = 0.0005;
        let axis = direction(180.0, BUN_LATITUDE);
        let rings = rings([RINGS, AROUND], axis, |spot| {
            let Spot {
                polar,
                azimuth,
                sin_polar,
                cos_polar,
                around,
            } = spot;
            let towards = axis * cos_polar + around * sin_polar;
            let waver = trig::sin(3.0 * polar + 5.0 * trig::sin(2.0 * azimuth));
            let lock = trig::sin(LOCKS * azimuth + waver) * LOCK_DEPTH * sin_polar;
            self.center + towards * (self.radius(towards) + lock * self.k)
        });
        let pole = |towards: Vec3| self.center + towards * self.radius(towards);
        Solid::from_rings(&rings, [pole(axis), pole(-axis)])
    }

    /// A wound bun, a little flattened against the head.
    fn bun(&self) -> Solid {
        const RINGS: usize = 18;
        const AROUND: usize = 40;
        const STRANDS: f32 = 3.0;
        let axis = direction(180.0, BUN_LATITUDE);
        let radius = BUN_RADIUS * self.k;
        let center = self.center + axis * (self.radius(axis) + 0.45 * radius);
        let rings = rings([RINGS, AROUND], axis, |spot| {
            let strand = trig::sin(STRANDS * spot.azimuth + 9.0 * spot.polar) * spot.sin_polar;
            let length = radius * (1.0 + 0.035 * strand);
            center + (axis * (0.8 * spot.cos_polar) + spot.around * spot.sin_polar) * length
        });
        Solid::from_rings(
            &rings,
            [
                center + axis * (0.76 * radius),
                center - axis * (0.8 * radius),
            ],
        )
    }

    /// A plumeria: five petals turned like a pinwheel, and its heart.
    fn flower(&self) -> (Solid, Solid) {
        const RINGS: usize = 5;
        const AROUND: usize = 80;
        const THICKNESS: f32 = 0.0012;
        let place = direction(FLOWER[0], FLOWER[1]);
        let seat = self.center + place * (self.radius(place) + 0.004 * self.k);
        let axis = (place + Vec3::new(0.15, 0.05, 0.35)).normalize_or_zero();
        let (across, up) = frame(axis);
        let radius = FLOWER_RADIUS * self.k;
        let side = |offset: f32| -> Vec<Vec<Vec3>> {
            (1..=RINGS)
                .map(|ring| {
                    let out = ring as f32 / RINGS as f32;
                    (0..AROUND)
                        .map(|step| {
                            let angle = TAU * step as f32 / AROUND as f32;
                            let Vec2 { x: flat, y: rise } = petal(angle, out);
                            let (sin, cos) = trig::sin_cos(angle);
                            seat + (across * cos + up * sin) * (flat * radius)
                                + axis * (rise * radius + offset * self.k)
                        })
                        .collect()
                })
                .collect()
        };
        let mut rings = side(THICKNESS);
        rings.extend(side(0.0).into_iter().rev());
        let poles = [seat + axis * (THICKNESS * self.k), seat];
        let petals = Solid::from_rings(&rings, poles);
        let heart_rings: Vec<Vec<Vec3>> = [0.5_f32, 0.85, 1.0]
            .map(|share| {
                let height = (1.0 - share * share).max(0.0).sqrt();
                (0..20)
                    .map(|step| {
                        let (sin, cos) = trig::sin_cos(TAU * step as f32 / 20.0);
                        seat + (across * cos + up * sin) * (0.2 * radius * share)
                            + axis * (radius * (0.1 + 0.09 * height))
                    })
                    .collect()
            })
            .to_vec();
        let tip = seat + axis * (0.19 * radius);
        (petals, Solid::from_rings(&heart_rings, [tip, seat]))
    }
}

/// Shape of the flower at an angle, `out` of the way from heart to rim: distance from the axis and
/// height above the seat, in flower radii.
fn petal(angle: f32, out: f32) -> Vec2 {
    let turn = angle * 5.0 / TAU;
    // -1 at one edge of the petal, 1 at the other, leaning over the next one.
    let across = 2.0 * (turn - turn.floor()) - 1.0;
    let round = (1.0 - across * across * across * across).max(0.0).sqrt();
    let rim = 0.34 + 0.66 * round;
    let flat = out * rim;
    let cup = 0.22 * out * out;
    let lean = 0.13 * across * out * round;
    Vec2::new(flat, 0.06 + cup + lean)
}

impl Solid {
    /// Closes rings of equal length with a pole at each end.
    fn from_rings(rings: &[Vec<Vec3>], poles: [Vec3; 2]) -> Self {
        let around = rings.first().map_or(0, Vec::len);
        let index = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        let mut solid = Self {
            positions: rings.iter().flatten().copied().collect(),
            triangles: Vec::new(),
        };
        let first_pole = solid.positions.len();
        solid.positions.extend(poles);
        let last = rings.len().saturating_sub(1) * around;
        for step in 0..around {
            let next = (step + 1) % around;
            solid.triangles.push([first_pole, step, next].map(index));
            solid
                .triangles
                .push([first_pole + 1, last + next, last + step].map(index));
            for ring in 1..rings.len() {
                let (upper, lower) = ((ring - 1) * around, ring * around);
                solid
                    .triangles
                    .push([upper + step, lower + step, lower + next].map(index));
                solid
                    .triangles
                    .push([upper + step, lower + next, upper + next].map(index));
            }
        }
        if solid.volume() < 0.0 {
            for triangle in &mut solid.triangles {
                triangle.swap(1, 2);
            }
        }
        solid
    }

    fn volume(&self) -> f32 {
        (self.triangles.iter())
            .map(|triangle| {
                let [a, b, c] =
                    triangle.map(|vertex| self.positions[vertex as usize] - self.positions[0]);
                a.dot(b.cross(c)) / 6.0
            })
            .sum()
    }

    fn append(&mut self, other: &Self) {
        let start = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        self.positions.extend(&other.positions);
        let moved = other
            .triangles
            .iter()
            .map(|triangle| triangle.map(|vertex| vertex + start));
        self.triangles.extend(moved);
    }

    /// Adds the solid as a part of the skin, carried by the head alone.
    fn add_to(&self, skin: &mut SkinnedMesh, kind: PartKind) {
        let start = u32::try_from(skin.positions.len()).unwrap_or(u32::MAX);
        let count = self.positions.len();
        let head = u16::try_from(Bone::Head.index()).unwrap_or(0);
        skin.positions.extend(&self.positions);
        skin.normals
            .extend(vertex_normals(&self.positions, &self.triangles));
        skin.uvs.extend(std::iter::repeat_n(Vec2::ZERO, count));
        skin.joints
            .extend(std::iter::repeat_n([head, 0, 0, 0], count));
        skin.weights
            .extend(std::iter::repeat_n([1.0, 0.0, 0.0, 0.0], count));
        skin.parts.push(MeshPart {
            kind,
            triangles: (self.triangles.iter())
                .map(|triangle| triangle.map(|vertex| vertex + start))
                .collect(),
        });
    }
}
