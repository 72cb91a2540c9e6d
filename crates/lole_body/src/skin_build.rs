//! From the half surface to the whole skin: regions cut, mirrored, weighted, and the centers about
//! which knees and elbows turn.

use glam::{Quat, Vec2, Vec3};
use lole_geom::trig;

use crate::skin::{Hinge, Turning};
use crate::skin_weights::{Row, four_largest, half_weights, mirror_table, mirrored_row};
use crate::surface::Shape;
use crate::surface::half::is_on_plane;
use crate::{Bone, MeshPart, PartKind, Pose, Skeleton, SkinnedMesh};

/// The left half with regions and dense weights.
#[derive(Clone)]
pub(crate) struct Half {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) rows: Vec<Row>,
    /// Factors on the color of the skin; none on what cloth meets.
    pub(crate) colors: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) kinds: Vec<PartKind>,
}

/// The left half of what cloth meets.
pub(crate) fn skin_half(shape: &Shape) -> Half {
    Half {
        positions: shape.positions.clone(),
        normals: shape.normals.clone(),
        rows: half_weights(shape),
        colors: Vec::new(),
        triangles: shape.triangles.clone(),
        kinds: shape.kinds.clone(),
    }
}

/// The whole body that cloth meets: skin, leotard and face.
pub(crate) fn build_skin(half: &Half, skeleton: &Skeleton) -> SkinnedMesh {
    let (mut skin, _) = half.mirrored();
    add_hinges(&mut skin, skeleton);
    skin
}

impl Half {
    /// A new vertex on the edge between two, where their heights say 0.
    pub(crate) fn split(&mut self, [a, b]: [u32; 2], heights: &[f32]) -> u32 {
        let [above, below] = [a, b].map(|vertex| heights[vertex as usize]);
        self.add_between([a, b], above / (above - below))
    }

    /// A new vertex at a share of the way from one to another.
    pub(crate) fn add_between(&mut self, [a, b]: [u32; 2], share: f32) -> u32 {
        let (a, b) = (a as usize, b as usize);
        let place = self.positions[a].lerp(self.positions[b], share);
        self.positions.push(place);
        let normal = self.normals[a].lerp(self.normals[b], share);
        self.normals.push(normal.normalize_or_zero());
        let row = std::array::from_fn(|bone| {
            self.rows[a][bone] + (self.rows[b][bone] - self.rows[a][bone]) * share
        });
        self.rows.push(row);
        self.colors.push(self.colors[a].lerp(self.colors[b], share));
        u32::try_from(self.positions.len() - 1).unwrap_or(u32::MAX)
    }

    /// Drops the vertices that no triangle uses; what each is called now.
    pub(crate) fn compact(&mut self) -> Vec<u32> {
        let mut renamed = vec![u32::MAX; self.positions.len()];
        let mut kept = Vec::new();
        for corner in self.triangles.iter_mut().flatten() {
            let new = &mut renamed[*corner as usize];
            if *new == u32::MAX {
                *new = u32::try_from(kept.len()).unwrap_or(u32::MAX);
                kept.push(*corner as usize);
            }
            *corner = *new;
        }
        self.positions = kept.iter().map(|&old| self.positions[old]).collect();
        self.normals = kept.iter().map(|&old| self.normals[old]).collect();
        self.rows = kept.iter().map(|&old| self.rows[old]).collect();
        self.colors = kept.iter().map(|&old| self.colors[old]).collect();
        renamed
    }

    /// The half and its mirror image, sharing the vertices on the plane, and the twin of each vertex of the half.
    pub(crate) fn mirrored(&self) -> (SkinnedMesh, Vec<u32>) {
        let flip = Vec3::new(-1.0, 1.0, 1.0);
        let mirror = mirror_table();
        let mut mesh = SkinnedMesh::default();
        let mut twin = Vec::with_capacity(self.positions.len());
        for (vertex, &position) in self.positions.iter().enumerate() {
            twin.push(u32::try_from(vertex).unwrap_or(u32::MAX));
            mesh.colors.extend(self.colors.get(vertex));
            let (joints, weights) = four_largest(&self.rows[vertex]);
            mesh.positions.push(position);
            mesh.normals.push(self.normals[vertex]);
            mesh.joints.push(joints);
            mesh.weights.push(weights);
        }
        for (vertex, &position) in self.positions.iter().enumerate() {
            if is_on_plane(position) {
                continue;
            }
            twin[vertex] = u32::try_from(mesh.positions.len()).unwrap_or(u32::MAX);
            let (joints, weights) = four_largest(&mirrored_row(&self.rows[vertex], &mirror));
            mesh.positions.push(position * flip);
            mesh.colors.extend(self.colors.get(vertex));
            mesh.normals.push(self.normals[vertex] * flip);
            mesh.joints.push(joints);
            mesh.weights.push(weights);
        }
        for kind in [
            PartKind::Skin,
            PartKind::Leotard,
            PartKind::Face,
            PartKind::Nail,
        ] {
            let mut triangles = Vec::new();
            for (&[a, b, c], _) in
                (self.triangles.iter().zip(&self.kinds)).filter(|(_, k)| **k == kind)
            {
                triangles.push([a, b, c]);
                triangles.push([a, c, b].map(|vertex| twin[vertex as usize]));
            }
            if !triangles.is_empty() {
                mesh.parts.push(MeshPart { kind, triangles });
            }
        }
        mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
        (mesh, twin)
    }
}

/// A kind of hinge: its bones with the joint that ends the lower one, and how its flesh gives way.
struct Kind {
    bones: [[Bone; 3]; 2],
    /// How far centers are led around the corner [radii of the limb].
    outward: f32,
    /// Flesh that the crease presses into itself, at [`KEPT_AT`], of a piece four radii long.
    pressed: f64,
    /// Where the limb bends to.
    inward: Vec3,
}

/// Bend [°] at which the body keeps its volume.
const KEPT_AT: f32 = 75.0;
/// Most that a limb becomes wider along the axis, were it folded up.
const MOST_WIDENING: f32 = 0.8;

/// The corner is chosen so that creases stay shallow (`tests/self_contact.rs`).
const KINDS: [Kind; 2] = [
    Kind {
        bones: [
            [Bone::LeftUpperLeg, Bone::LeftLowerLeg, Bone::LeftFoot],
            [Bone::RightUpperLeg, Bone::RightLowerLeg, Bone::RightFoot],
        ],
        outward: 0.5,
        pressed: 0.0,
        inward: Vec3::NEG_Z,
    },
    Kind {
        bones: [
            [Bone::LeftUpperArm, Bone::LeftLowerArm, Bone::LeftHand],
            [Bone::RightUpperArm, Bone::RightLowerArm, Bone::RightHand],
        ],
        outward: 1.2,
        pressed: 0.025,
        inward: Vec3::Z,
    },
];
/// Vertices that one of the two bones carries less than this are left to linear blending.
const LEAST_SHARE: f32 = 0.004;
/// How far apart shares are that still count as alike.
const ALIKE: f32 = 0.12;

/// Adds the hinges, with the vertices that both of their bones carry and nothing else.
pub(crate) fn add_hinges(skin: &mut SkinnedMesh, skeleton: &Skeleton) {
    let areas = areas(skin);
    let all = KINDS
        .iter()
        .flat_map(|kind| kind.bones.map(|bones| (kind, bones)));
    for (number, (kind, [above, below, end])) in (0..).zip(all) {
        let shared = shared(skin, [above, below]);
        let (mut squares, mut total) = (0.0, 0.0);
        for &(vertex, share) in &shared {
            let center = center(skin, &areas, &shared, share);
            let weight = areas[vertex] * share * (1.0 - share);
            squares += skin.positions[vertex].distance_squared(center) * weight;
            total += weight;
            skin.turning.push(Turning {
                vertex: u32::try_from(vertex).unwrap_or(u32::MAX),
                hinge: number,
                share,
                center,
            });
        }
        let radius = (squares / total.max(f32::MIN_POSITIVE)).sqrt();
        let direction = |from, to| (skeleton.joint(to) - skeleton.joint(from)).normalize_or_zero();
        skin.hinges.push(Hinge {
            bones: [above, below].map(|bone| u16::try_from(bone.index()).unwrap_or(0)),
            directions: [direction(above, below), direction(below, end)],
            outward: kind.outward * radius,
            widening: 0.0,
        });
    }
    skin.turning.sort_by_key(|turning| turning.vertex);
    for (number, kind) in KINDS.iter().enumerate() {
        let widening = widening(skin, skeleton, kind, 2 * number);
        for hinge in &mut skin.hinges[2 * number..][..2] {
            hinge.widening = widening;
        }
    }
}

/// The widening with which the body keeps its volume at [`KEPT_AT`]: by regula falsi, because the
/// volume is nearly linear in it.
fn widening(skin: &mut SkinnedMesh, skeleton: &Skeleton, kind: &Kind, hinge: usize) -> f32 {
    const TRIED: f32 = 0.4;
    let [_, below, _] = kind.bones[0];
    let [from, to] = skin.hinges[hinge].directions;
    let side = (kind.inward - from * kind.inward.dot(from)).normalize_or_zero();
    let (sin, cos) = trig::sin_cos(KEPT_AT.to_radians());
    let mut pose = Pose::default();
    pose.rotate(below, Quat::from_rotation_arc(to, from * cos + side * sin));
    let radius = f64::from(skin.hinges[hinge].outward / kind.outward);
    let pressed = kind.pressed * 4.0 * std::f64::consts::PI * radius.powi(3);
    let wanted = volume(skin, skeleton, &Pose::default()) + pressed;
    let mut lost = [0.0, TRIED].map(|widening| {
        skin.hinges[hinge].widening = widening;
        wanted - volume(skin, skeleton, &pose)
    });
    lost[1] = (lost[0] - lost[1]).max(f64::MIN_POSITIVE);
    #[expect(clippy::cast_possible_truncation, reason = "a part, and clamped")]
    let widening = (f64::from(TRIED) * lost[0] / lost[1]) as f32;
    widening.clamp(0.0, MOST_WIDENING)
}

/// Volume of the posed body in cubic meters.
fn volume(skin: &SkinnedMesh, skeleton: &Skeleton, pose: &Pose) -> f64 {
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    skin.pose(
        &skeleton.world_from_bind(pose),
        &mut positions,
        &mut normals,
    );
    let of_corner = |triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize].as_dvec3());
        a.dot(b.cross(c)) / 6.0
    };
    skin.body_triangles().into_iter().map(of_corner).sum()
}

/// Vertices that two bones carry and nothing else, with the share of the second.
fn shared(skin: &SkinnedMesh, bones: [Bone; 2]) -> Vec<(usize, f32)> {
    let shared_by_both = |vertex: usize| {
        let [above, below] = bones.map(|bone| {
            let carried = skin.joints[vertex].iter().zip(skin.weights[vertex]);
            let of_bone = carried.filter(|(joint, _)| usize::from(**joint) == bone.index());
            of_bone.map(|(_, weight)| weight).sum::<f32>()
        });
        let is_shared = above.min(below) > LEAST_SHARE && above + below > 0.999;
        is_shared.then_some((vertex, below))
    };
    (0..skin.positions.len())
        .filter_map(shared_by_both)
        .collect()
}

/// The middle of the limb [m] where the lower bone's share is `share`.
fn center(skin: &SkinnedMesh, areas: &[f32], shared: &[(usize, f32)], share: f32) -> Vec3 {
    let (mut sum, mut total) = (Vec3::ZERO, 0.0);
    for &(other, other_share) in shared {
        let apart = (share - other_share) / ALIKE;
        let weight = areas[other] * (1.0 - apart * apart).max(0.0);
        sum += skin.positions[other] * weight;
        total += weight;
    }
    sum / total.max(f32::MIN_POSITIVE)
}

/// Area around each vertex [m²], times 6.
fn areas(skin: &SkinnedMesh) -> Vec<f32> {
    let mut areas = vec![0.0; skin.positions.len()];
    for triangle in skin.body_triangles() {
        let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize]);
        for vertex in triangle {
            areas[vertex as usize] += (b - a).cross(c - a).length();
        }
    }
    areas
}
