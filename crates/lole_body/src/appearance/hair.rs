//! The hair: combed back into a wound bun or open down the back, with a plumeria behind the left ear;
//! short; or a child's bob.
//!
//! The cap is a closed surface around the head whose distance from the skin falls gently to below
//! zero across the hairline: where it dives under the skin, hair ends. There it is painted as
//! skin (`hair_paint`), so that no edge shows.

use std::f32::consts::{PI, TAU};
use std::ops::Range;

use glam::{Vec2, Vec3};
use lole_geom::mesh::vertex_normals;
use lole_geom::trig;

mod cut;
mod fall;
mod strands;

use super::HairStyle;
use super::hair_paint::hairline_v;
use crate::drawn::DrawnBody;
use crate::drawn::open_hair::{OpenHair, lies};
use crate::surface::Shape;
use crate::surface::field::Head;
use crate::surface::pchip::Pchip;
use crate::surface::warp::smooth_step;
use crate::{Bone, MeshPart, PartKind, SkinnedMesh};
use cut::Cut;
use fall::Fall;

/// Direction of the bun: straight back, this much up [°].
const BUN_LATITUDE: f32 = 24.0;
/// Radius of the bun [m] at a stature of 158.5 cm.
const BUN_RADIUS: f32 = 0.043;
/// Longitude and latitude of the flower [°], on the left.
const FLOWER: [f32; 2] = [72.0, 16.0];
/// Radius of the flower [m].
const FLOWER_RADIUS: f32 = 0.034;

/// Appends hair and, where it is worn, the flower to the skin.
pub(crate) fn add_hair(skin: &mut SkinnedMesh, on: (&Shape, &Head), style: HairStyle) {
    Grown::new(on, style).add_to(skin);
}

/// The same to a drawn body, with single strands and what of them swings.
pub(crate) fn add_drawn_hair(drawn: &mut DrawnBody, on: (&Shape, &Head), style: HairStyle) {
    let grown = Grown::new(on, style);
    let beside_cap = grown.add_to(&mut drawn.mesh);
    let (strands, of_fall) = strands::strands(&grown.scalp, style, grown.fall.as_ref());
    drawn.strands = strands;
    if let Some(fall) = &grown.fall {
        let lie = |place| fall.lie(place);
        drawn.open_hair = OpenHair::new(
            fall.knots(),
            lies(&drawn.mesh, beside_cap, lie),
            lies(&drawn.strands, of_fall..drawn.strands.positions.len(), lie),
        );
    }
}

/// Hair of a style on a head.
struct Grown<'a> {
    scalp: Scalp<'a>,
    style: HairStyle,
    cap: Solid,
    fall: Option<Fall>,
}

impl<'a> Grown<'a> {
    fn new((shape, head): (&Shape, &'a Head), style: HairStyle) -> Self {
        let scalp = Scalp::new((shape, head), style);
        let cap = scalp.cap();
        let fall = (style == HairStyle::Long).then(|| Fall::new(shape, &scalp, &cap));
        Self {
            scalp,
            style,
            cap,
            fall,
        }
    }

    /// Appends it to a skin; gives the vertices of hair that is no cap.
    fn add_to(&self, skin: &mut SkinnedMesh) -> Range<usize> {
        let mut hair = Solid::default();
        hair.append(&self.cap);
        let after_cap = skin.positions.len() + hair.positions.len();
        match &self.fall {
            Some(fall) => hair.append(&fall.solid()),
            None if matches!(self.style, HairStyle::OfFigure | HairStyle::Bun) => {
                hair.append(&self.scalp.bun());
            }
            None => {}
        }
        hair.add_to(skin, PartKind::Hair);
        let end = skin.positions.len();
        if matches!(self.style, HairStyle::Bun | HairStyle::Long) {
            let (petals, heart) = self.scalp.flower();
            petals.add_to(skin, PartKind::Flower);
            heart.add_to(skin, PartKind::FlowerHeart);
        }
        after_cap..end
    }
}

struct Scalp<'a> {
    head: &'a Head,
    center: Vec3,
    /// Size of the head over the mean woman's.
    k: f32,
    hairline: Pchip,
    cover: Pchip,
    /// Where the locks come together.
    crown: Vec3,
    /// Latitude [°] below which hair hangs straight instead of following the skin.
    hangs: Option<f32>,
    /// How far inside the hairline [°] the picture begins: cut ends are dense at once.
    dense: f32,
}

/// What the head alone carries.
const HEAD_ALONE: ([u16; 4], [f32; 4]) = ([Bone::Head as u16, 0, 0, 0], [1.0, 0.0, 0.0, 0.0]);

/// A closed surface, triangles counter-clockwise seen from outside.
#[derive(Default)]
struct Solid {
    positions: Vec<Vec3>,
    /// Places in the hair's picture, as many as positions, or none.
    uvs: Vec<Vec2>,
    triangles: Vec<[u32; 3]>,
    /// Bones and their shares, as many as positions or fewer: the head carries the rest.
    carried: Vec<([u16; 4], [f32; 4])>,
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

impl Spot {
    /// The spot at these angles [rad] around an axis; `frame` is that of [`frame`].
    fn of(polar: f32, azimuth: f32, (across, up): (Vec3, Vec3)) -> Self {
        let (sin_polar, cos_polar) = trig::sin_cos(polar);
        let (sin_azimuth, cos_azimuth) = trig::sin_cos(azimuth);
        Self {
            polar,
            azimuth,
            sin_polar,
            cos_polar,
            around: across * cos_azimuth + up * sin_azimuth,
        }
    }
}

/// Rings of vertices from one pole of `axis` to the other, as many parts as `counts` says along
/// and around it, each vertex where `place` puts it.
fn rings(counts: [usize; 2], axis: Vec3, place: impl Fn(Spot) -> Vec3) -> Vec<Vec<Vec3>> {
    let frame = frame(axis);
    let ring = |ring: usize| {
        let polar = PI * ring as f32 / counts[0] as f32;
        let vertex = |step: usize| {
            let azimuth = TAU * step as f32 / counts[1] as f32;
            place(Spot::of(polar, azimuth, frame))
        };
        (0..counts[1]).map(vertex).collect()
    };
    (1..counts[0]).map(ring).collect()
}

/// Angle from the top of a ring, the same on both sides, as a share of a half turn: 0 to 1.
fn from_top(azimuth: f32) -> f32 {
    let turned = (azimuth / TAU + 0.75).fract();
    1.0 - (2.0 * turned - 1.0).abs()
}

/// Combed locks of unlike width [m].
fn lock_height(spot: &Spot) -> f32 {
    let sway = trig::sin(3.0 * spot.polar + 5.0 * trig::sin(2.0 * spot.azimuth));
    let wave = |count: f32, share: f32| trig::sin(count * spot.azimuth + share * sway);
    0.0004 * wave(26.0, 1.0) + 0.0003 * wave(17.0, 1.6) + 0.0002 * wave(41.0, 0.7)
}

impl<'a> Scalp<'a> {
    fn new((shape, head): (&Shape, &'a Head), style: HairStyle) -> Self {
        let cut = Cut::of(style);
        Self {
            head,
            center: shape.body.head.center,
            k: shape.head_size,
            hairline: Pchip::new(cut.hairline),
            cover: Pchip::new(cut.cover),
            crown: direction(180.0, cut.crown_latitude),
            hangs: cut.hangs,
            dense: if cut.hangs.is_some() { 9.0 } else { 0.0 },
        }
    }
}

impl Scalp<'_> {
    /// How far a direction lies inside the hairline [°].
    fn inside(&self, towards: Vec3) -> f32 {
        let latitude = trig::asin(towards.y).to_degrees();
        let longitude = trig::atan2(towards.x.abs(), towards.z).to_degrees();
        latitude - self.hairline.at(longitude)
    }

    /// Distance [m] of the skin from the head's center in a direction.
    fn skin(&self, towards: Vec3) -> f32 {
        let latitude = trig::asin(towards.y).to_degrees();
        let longitude = trig::atan2(towards.x.abs(), towards.z).to_degrees();
        self.head.radius(longitude, latitude)
    }

    /// Distance [m] of the hair from the head's center in a direction.
    fn radius(&self, towards: Vec3) -> f32 {
        const BURIED: f32 = 0.045;
        let latitude = trig::asin(towards.y).to_degrees();
        let longitude = trig::atan2(towards.x.abs(), towards.z).to_degrees();
        // Above the ear the skin sticks out: the skull lies at most this far from the center.
        let skin = self.head.radius(longitude, latitude);
        let inside = self.inside(towards);
        let buried = smooth_step((-inside - 9.0) / 18.0);
        let mut visible = skin + self.cover.at(inside) * 0.001 * self.k;
        if let Some(from) = self.hangs {
            // Over the ears hair does not follow the skin.
            let share = smooth_step((from - latitude) / 10.0) * smooth_step((inside + 1.0) / 3.0);
            visible += (self.hanging(longitude, latitude, from) - visible) * share;
        }
        visible + (BURIED * self.k - visible).min(0.0) * buried
    }

    /// Distance [m] from the center to hair that hangs straight down `from` a latitude and turns in
    /// at its ends.
    fn hanging(&self, longitude: f32, latitude: f32, from: f32) -> f32 {
        let (sin, cos) = trig::sin_cos(from.to_radians());
        let top = self.head.radius(longitude, from) + 0.017 * self.k;
        let (sin_low, cos_low) = trig::sin_cos(latitude.to_radians());
        // The same distance from the vertical axis, less and less of it towards the ends.
        let straight = top * cos / cos_low.max(0.2);
        let drop = (straight * sin_low - top * sin).abs() / self.k;
        straight * (1.0 - 9.0 * drop * drop)
    }

    /// The cap: rings around the crown, so that combed locks run to it.
    fn cap(&self) -> Solid {
        const RINGS: usize = 52;
        const AROUND: usize = 144;
        let axis = self.crown;
        let towards = |spot: &Spot| axis * spot.cos_polar + spot.around * spot.sin_polar;
        let rings_of = rings([RINGS, AROUND], axis, |spot| {
            let towards = towards(&spot);
            let depth = smooth_step((self.inside(towards) - 3.0) / 14.0) * spot.sin_polar;
            self.center + towards * (self.radius(towards) + lock_height(&spot) * depth * self.k)
        });
        let pole = |towards: Vec3| self.center + towards * self.radius(towards);
        let mut solid = Solid::from_rings(&rings_of, [pole(axis), pole(-axis)]);
        // Mirrored across the middle, so that the picture has no seam.
        let places = rings([RINGS, AROUND], axis, |spot| {
            let v = hairline_v(self.inside(towards(&spot)) + self.dense);
            Vec3::new(from_top(spot.azimuth), v, 0.0)
        });
        solid.uvs = (places.iter().flatten().map(|place| place.truncate()))
            .chain([axis, -axis].map(|pole| Vec2::new(0.5, hairline_v(self.inside(pole)))))
            .collect();
        solid
    }

    /// A wound bun, a little flattened against the head: strands run around it in a spiral.
    fn bun(&self) -> Solid {
        const RINGS: usize = 30;
        const AROUND: usize = 64;
        let axis = direction(180.0, BUN_LATITUDE);
        let (center, radius) = self.bun_ball();
        let rings_of = rings([RINGS, AROUND], axis, |spot| self.on_bun_at(&spot));
        let poles = [0.74, -0.74].map(|share| center + axis * (share * 0.94 * radius));
        let mut solid = Solid::from_rings(&rings_of, poles);
        let place = |spot: &Spot| {
            let around = from_top(spot.azimuth);
            Vec2::new(
                0.1 + 0.25 * spot.polar + 0.06 * around,
                hairline_v(27.0 + 10.0 * around),
            )
        };
        let places = rings([RINGS, AROUND], axis, |spot| place(&spot).extend(0.0));
        solid.uvs = (places.iter().flatten().map(|place| place.truncate()))
            .chain([Vec2::new(0.1, 0.4), Vec2::new(0.9, 0.4)])
            .collect();
        solid
    }

    /// Center and radius of the bun [m].
    fn bun_ball(&self) -> (Vec3, f32) {
        let axis = direction(180.0, BUN_LATITUDE);
        let radius = BUN_RADIUS * self.k;
        let center = self.center + axis * (self.radius(axis) + 0.40 * radius);
        (center, radius)
    }

    /// Where the bun is at a spot around its axis.
    fn on_bun_at(&self, spot: &Spot) -> Vec3 {
        let axis = direction(180.0, BUN_LATITUDE);
        let (center, radius) = self.bun_ball();
        // Two strands, each wound two and a half times: round ropes with a groove between.
        let wave = trig::sin(spot.azimuth + 7.5 * spot.polar);
        let rope = (1.0 - wave * wave * wave * wave) * spot.sin_polar;
        let length = radius * (0.94 + 0.085 * rope);
        center + (axis * (0.74 * spot.cos_polar) + spot.around * spot.sin_polar) * length
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
            ..Self::default()
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
        self.carried.resize(self.positions.len(), HEAD_ALONE);
        self.carried.extend(&other.carried);
        self.positions.extend(&other.positions);
        self.uvs.extend(&other.uvs);
        let moved = other
            .triangles
            .iter()
            .map(|triangle| triangle.map(|vertex| vertex + start));
        self.triangles.extend(moved);
    }

    /// Adds the solid as a part of the skin.
    fn add_to(&self, skin: &mut SkinnedMesh, kind: PartKind) {
        let start = u32::try_from(skin.positions.len()).unwrap_or(u32::MAX);
        let count = self.positions.len();
        skin.positions.extend(&self.positions);
        skin.normals
            .extend(vertex_normals(&self.positions, &self.triangles));
        skin.uvs.extend(&self.uvs);
        skin.uvs.resize(skin.positions.len(), Vec2::ZERO);
        let head_alone = std::iter::repeat(&HEAD_ALONE);
        for &(joints, weights) in self.carried.iter().chain(head_alone).take(count) {
            skin.joints.push(joints);
            skin.weights.push(weights);
        }
        skin.parts.push(MeshPart {
            kind,
            triangles: (self.triangles.iter())
                .map(|triangle| triangle.map(|vertex| vertex + start))
                .collect(),
        });
    }
}
