//! Eyeballs, brows and lashes.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};
use lole_geom::mesh::vertex_normals;
use lole_geom::srgb::linear_from_srgb;
use lole_geom::trig;

use super::face::{Eyeball, LidPoint, with_upper_lid};
use crate::appearance::Feature;
use crate::parts::HeadPart;
use crate::surface::warp::smooth_step;
use crate::{Appearance, Bone, Figure, MeshPart, PartKind, SkinnedMesh};

/// Colors of the eye, linear.
const WHITE: Vec3 = Vec3::new(0.80, 0.775, 0.755);
const IRIS: Vec3 = Vec3::new(0.092, 0.046, 0.028);
const IRIS_LIGHT: Vec3 = Vec3::new(0.165, 0.083, 0.045);
const LIMBUS: Vec3 = Vec3::new(0.028, 0.015, 0.011);
const PUPIL: Vec3 = Vec3::new(0.006, 0.005, 0.005);
/// Lashes of an upper lid.
const LASHES: u8 = 30;
/// Of the lashes.
const LASH: Vec3 = Vec3::new(0.035, 0.023, 0.019);
/// Corners of the eye's rings.
const AROUND: usize = 32;
/// The pupil's share of the iris.
const PUPIL_SHARE: f32 = 0.40;
/// How far the eye bulges before the iris, as a share of its radius.
const BULGE: f32 = 0.045;
/// How far down the upper lid shades the eye [m].
const LID_SHADOW: f32 = 0.004;
/// The brow's half width by its length, as shares of the widest.
const BROW_WIDTHS: [f32; 13] = [
    0.42, 0.66, 0.84, 0.95, 1.0, 1.0, 0.96, 0.88, 0.77, 0.63, 0.47, 0.29, 0.08,
];
/// How much lighter brows are than hair, linear.
const BROW_LIGHT: Vec3 = Vec3::new(0.055, 0.038, 0.028);
/// The lightest hair of a brow, linear.
const BROW_MOST: f32 = 0.14;
/// How much thicker the thickest brows are.
const BROW_THICKNESS: f32 = 0.45;
/// How far brows lie over the skin [m].
const BROW_LIFT: f32 = 0.35e-3;

/// Linear light of a color.
fn linear(color: [u8; 3]) -> Vec3 {
    Vec3::from_array(color.map(|byte| linear_from_srgb(f32::from(byte) / 255.0)))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a column of some dozens"
)]
fn column_index(column: f32) -> usize {
    column.max(0.0) as usize
}

/// What hangs on the head alone.
#[derive(Default)]
struct Loose {
    positions: Vec<Vec3>,
    colors: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

/// Adds eyes, brows and lashes: the eyes, and the lashes' points, which move with the lids.
pub(super) fn add(
    mesh: &mut SkinnedMesh,
    (head, colors): (&HeadPart, &[Vec3]),
    (figure, appearance): (Figure, &Appearance),
) -> ([Eyeball; 2], Vec<LidPoint>) {
    let first = number(mesh.positions.len());
    let mut eyes = Loose::default();
    let eyeballs = [1.0, -1.0].map(|side| {
        let start = first + number(eyes.positions.len());
        eyes.eye(head, side);
        let flip = Vec3::new(side, 1.0, 1.0);
        Eyeball {
            vertices: start..first + number(eyes.positions.len()),
            center: head.eye * flip,
            ahead: head.gaze * flip,
        }
    });
    eyes.add_to(mesh, PartKind::Eye);
    let mut brows = Loose::default();
    brows.brow((head, colors), (figure, appearance));
    brows.mirror();
    brows.add_to(mesh, PartKind::Brow);
    let first = number(mesh.positions.len());
    let mut lashes = Loose::default();
    let columns = lashes.lashes(head, figure);
    let count = number(lashes.positions.len());
    let places = lashes.positions.clone();
    lashes.mirror();
    lashes.add_to(mesh, PartKind::Lash);
    let placed = places.into_iter().zip(columns);
    let points = (first..).zip(placed).flat_map(|(vertex, (place, column))| {
        let moved = [0.5, 1.0].map(|share| with_upper_lid(head, place, column, share));
        let other = moved.map(|by| by * Vec3::new(-1.0, 1.0, 1.0));
        let pair = [(vertex, moved), (vertex + count, other)];
        pair.map(|(vertex, moved)| LidPoint { vertex, moved })
    });
    (eyeballs, points.collect())
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

impl Loose {
    fn push(&mut self, place: Vec3, color: Vec3) -> u32 {
        self.positions.push(place);
        self.colors.push(color);
        number(self.positions.len() - 1)
    }

    /// The same once more on the other side.
    fn mirror(&mut self) {
        let first = number(self.positions.len());
        let other = self
            .positions
            .iter()
            .map(|place| *place * Vec3::new(-1.0, 1.0, 1.0));
        let other: Vec<Vec3> = other.collect();
        self.positions.extend(other);
        self.colors.extend_from_within(..);
        let other = (self.triangles.iter()).map(|&[a, b, c]| [a + first, c + first, b + first]);
        let other: Vec<[u32; 3]> = other.collect();
        self.triangles.extend(other);
    }

    fn add_to(self, mesh: &mut SkinnedMesh, kind: PartKind) {
        let first = number(mesh.positions.len());
        let count = self.positions.len();
        mesh.normals
            .extend(vertex_normals(&self.positions, &self.triangles));
        mesh.positions.extend(self.positions);
        mesh.colors.extend(self.colors);
        mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
        let head = [Bone::Head as u16, 0, 0, 0];
        mesh.joints.extend(std::iter::repeat_n(head, count));
        let whole = [1.0, 0.0, 0.0, 0.0];
        mesh.weights.extend(std::iter::repeat_n(whole, count));
        let triangles = self.triangles.iter();
        mesh.parts.push(MeshPart {
            kind,
            triangles: triangles
                .map(|it| it.map(|corner| corner + first))
                .collect(),
        });
    }

    /// An eyeball, the front half of it and some more, and the light of a window in it.
    fn eye(&mut self, head: &HeadPart, side: f32) {
        let flip = Vec3::new(side, 1.0, 1.0);
        let (center, gaze) = (head.eye * flip, (head.gaze * flip).normalize_or(Vec3::Z));
        let radius = head.eye_radius;
        let lid = head.lids[head.lid_rim][9];
        let lid = head.part.positions[lid as usize].y;
        let across = Vec3::Y.cross(gaze).normalize_or(Vec3::X);
        let up = gaze.cross(across);
        let edge = trig::asin((head.iris_radius / radius).clamp(0.05, 0.95));
        let mut rings = vec![
            (PUPIL_SHARE * edge, PUPIL),
            (PUPIL_SHARE * 1.06 * edge, IRIS_LIGHT),
            (0.68 * edge, IRIS),
            (0.88 * edge, IRIS * 0.8),
            (0.95 * edge, LIMBUS),
            (1.0 * edge, LIMBUS),
            (1.06 * edge, WHITE),
        ];
        rings.extend((1..=12).map(|ring| (1.06 * edge + 0.105 * ring as f32, WHITE)));
        let place = |polar: f32, turn: f32| {
            let (sin, cos) = trig::sin_cos(polar);
            let (sin_turn, cos_turn) = trig::sin_cos(turn);
            let out = gaze * cos + (across * cos_turn + up * sin_turn) * sin;
            let bulge = BULGE * smooth_step(1.0 - polar / edge);
            center + out * (radius * (1.0 + bulge))
        };
        let shade = |place: Vec3| 0.45 + 0.55 * smooth_step((lid - place.y) / LID_SHADOW);
        let pole = self.push(place(0.0, 0.0), PUPIL);
        let around = number(AROUND);
        let mut last: Option<u32> = None;
        for (polar, color) in rings {
            let first = number(self.positions.len());
            for step in 0..AROUND {
                let at = place(polar, TAU * step as f32 / AROUND as f32);
                self.push(at, color * shade(at));
            }
            for step in 0..around {
                let next = (step + 1) % around;
                match last {
                    None => self.triangles.push([pole, first + step, first + next]),
                    Some(inner) => self.triangles.extend([
                        [inner + step, first + step, first + next],
                        [inner + step, first + next, inner + next],
                    ]),
                }
            }
            last = Some(first);
        }
        self.glint((center, radius), gaze, [across, up]);
    }

    /// A small white disk that stands before the iris, on the same side of both eyes.
    fn glint(&mut self, (center, radius): (Vec3, f32), gaze: Vec3, [across, up]: [Vec3; 2]) {
        const STEPS: u32 = 10;
        let out = (gaze + Vec3::X * 0.13 + up * 0.17).normalize_or(gaze);
        let middle = center + out * (radius * (1.0 + BULGE) + 0.1e-3);
        let pole = self.push(middle, Vec3::ONE);
        for step in 0..STEPS {
            let (sin, cos) = trig::sin_cos(TAU * step as f32 / STEPS as f32);
            let flat = (across * cos + up * sin) * (0.062 * radius);
            // It lies on the eye, not in it.
            self.push(
                middle + flat - out * (0.3 * flat.length_squared() / radius),
                Vec3::ONE,
            );
        }
        for step in 0..STEPS {
            let next = (step + 1) % STEPS;
            self.triangles
                .push([pole, pole + 1 + step, pole + 1 + next]);
        }
    }

    /// A strip along the brow whose edges have the color of the skin below, so that none is seen.
    fn brow(
        &mut self,
        (head, colors): (&HeadPart, &[Vec3]),
        (figure, appearance): (Figure, &Appearance),
    ) {
        /// Places across and how much hair there is.
        const ACROSS: [(f32, f32); 5] = [
            (-1.0, 0.0),
            (-0.55, 0.75),
            (0.0, 1.0),
            (0.6, 0.7),
            (1.0, 0.0),
        ];
        let normals = vertex_normals(&head.part.positions, &head.part.triangles);
        let half = head.size()
            * match figure {
                Figure::Man => 3.4e-3,
                Figure::Child => 2.1e-3,
                Figure::OfStature | Figure::Woman => 2.6e-3,
            }
            * (1.0 + BROW_THICKNESS * appearance.face.feature(Feature::BrowThickness));
        let on = |of: &[Vec3], (corners, shares): &([u32; 3], [f32; 3])| -> Vec3 {
            (corners.iter().zip(shares))
                .map(|(&corner, &share)| of[corner as usize] * share)
                .sum()
        };
        let line: Vec<Vec3> = head
            .brow
            .iter()
            .map(|it| on(&head.part.positions, it))
            .collect();
        let hair = linear(appearance.hair_srgb);
        // Brows turn grey, hardly ever white.
        let brow = hair * (BROW_MOST / hair.max_element().max(BROW_MOST)) + BROW_LIGHT;
        let mut last: Option<u32> = None;
        for (index, anchor) in head.brow.iter().enumerate() {
            let normal = on(&normals, anchor).normalize_or(Vec3::Z);
            let before = line[index.saturating_sub(1)];
            let after = line[(index + 1).min(line.len() - 1)];
            let up = normal.cross(before - after).normalize_or(Vec3::Y);
            let up = if up.y < 0.0 { -up } else { up };
            let end = index.min(line.len() - 1 - index) as f32;
            let dense = 0.95 * smooth_step((end + 0.6) / 2.2);
            let width = half * BROW_WIDTHS[index.min(BROW_WIDTHS.len() - 1)];
            let below = on(colors, anchor) * linear(appearance.skin_srgb);
            let first = number(self.positions.len());
            for (across, hair) in ACROSS {
                let flat = up * (across * width);
                let place = line[index] + normal * BROW_LIFT + flat;
                self.push(place, below.lerp(brow, hair * dense));
            }
            if let Some(inner) = last {
                for step in 0..number(ACROSS.len() - 1) {
                    let [a, b, c, d] = [
                        inner + step,
                        inner + step + 1,
                        first + step,
                        first + step + 1,
                    ];
                    self.triangles.extend([[a, c, d], [a, d, b]]);
                }
            }
            last = Some(first);
        }
        self.face_out();
    }

    /// Lashes along the upper lid, longest towards the outer corner; the lid's column of each vertex.
    fn lashes(&mut self, head: &HeadPart, figure: Figure) -> Vec<usize> {
        let longest = match figure {
            Figure::OfStature | Figure::Woman => 4.4e-3,
            Figure::Child => 2.6e-3,
            Figure::Man => 1.4e-3,
        };
        let rim = &head.lids[head.lid_rim];
        let at = |place: f32| {
            let places = [place.floor(), place.floor() + 1.0].map(|column| {
                let point = rim[column_index(column).min(rim.len() - 1)];
                head.part.positions[point as usize]
            });
            places[0].lerp(places[1], place.fract())
        };
        let size = head.size();
        let mut columns = Vec::new();
        for lash in 0..LASHES {
            let share = (lash as f32 + 0.5) / LASHES as f32;
            let column = 2.4 + 14.6 * share;
            let middle = at(column);
            let out = (middle - head.eye).normalize_or(Vec3::Z);
            // Neighbors are of unlike length, as hairs are.
            let unlike = 0.82 + 0.18 * trig::sin(2.4 * lash as f32);
            let length = longest * size * (0.4 + 0.6 * smooth_step(share / 0.75)) * unlike;
            let aside = Vec3::X * (0.85 * (share - 0.35));
            let way = (out * 0.95 + Vec3::Y * 0.35 + aside).normalize_or(out);
            let roots = [at(column - 0.22), at(column + 0.22)];
            let [one, two] = roots.map(|root| self.push(root + out * 0.1e-3, LASH));
            // They bend up.
            let bent = middle + way * (0.55 * length);
            let half = (roots[1] - roots[0]) * 0.22;
            let [left, right] = [bent - half, bent + half].map(|place| self.push(place, LASH));
            let tip = bent + (way + Vec3::Y * 0.5).normalize_or(way) * (0.45 * length);
            let tip = self.push(tip, LASH);
            self.triangles
                .extend([[one, two, right], [one, right, left], [left, right, tip]]);
            columns.resize(self.positions.len(), column_index(column.round()));
        }
        columns
    }

    /// Turns triangles that look into the head.
    fn face_out(&mut self) {
        for triangle in &mut self.triangles {
            let [a, b, c] = triangle.map(|corner| self.positions[corner as usize]);
            if (b - a).cross(c - a).z < 0.0 {
                triangle.swap(1, 2);
            }
        }
    }
}
