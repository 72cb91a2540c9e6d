//! From the half surface to the whole skin: regions cut, mirrored, weighted.

use glam::{Vec2, Vec3};

use crate::skin_weights::{Row, four_largest, half_weights, mirror_table, mirrored_row};
use crate::surface::Shape;
use crate::surface::half::is_on_plane;
use crate::surface::slice::{Cut, slice};
use crate::{MeshPart, PartKind, SkinnedMesh};

/// The left half with regions and dense weights.
struct Half {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    rows: Vec<Row>,
    triangles: Vec<[u32; 3]>,
    kinds: Vec<PartKind>,
}

/// The whole body: skin, leotard and face.
pub(crate) fn build_skin(shape: &Shape, regions: &Regions) -> SkinnedMesh {
    let mut half = Half {
        positions: shape.positions.clone(),
        normals: shape.normals.clone(),
        rows: half_weights(shape),
        triangles: shape.triangles.clone(),
        kinds: vec![PartKind::Skin; shape.triangles.len()],
    };
    half.cut(PartKind::Leotard, |point| regions.leotard(point));
    half.cut(PartKind::Face, |point| regions.face(point));
    half.mirrored(regions)
}

impl Half {
    /// Cuts along the zero line of `region` and marks what is inside.
    fn cut(&mut self, kind: PartKind, region: impl Fn(Vec3) -> f32) {
        let values: Vec<f32> = self.positions.iter().map(|&point| region(point)).collect();
        let mut kinds = Vec::new();
        let mut triangles = Vec::new();
        let sliced = slice(&self.triangles, &values);
        for cut in &sliced.vertices[self.positions.len()..] {
            if let Cut::Between(a, b, share) = *cut {
                self.push_between(a as usize, b as usize, share);
            }
        }
        for (piece, &triangle) in sliced.triangles.iter().enumerate() {
            let old = self.kinds[sliced.parents[piece] as usize];
            kinds.push(if sliced.is_positive[piece] { kind } else { old });
            triangles.push(triangle);
        }
        self.triangles = triangles;
        self.kinds = kinds;
    }

    fn push_between(&mut self, a: usize, b: usize, share: f32) {
        let mut position = self.positions[a].lerp(self.positions[b], share);
        if is_on_plane(self.positions[a]) && is_on_plane(self.positions[b]) {
            position.x = 0.0;
        }
        let normal = self.normals[a]
            .lerp(self.normals[b], share)
            .normalize_or_zero();
        let row: Row =
            std::array::from_fn(|k| self.rows[a][k] + (self.rows[b][k] - self.rows[a][k]) * share);
        self.positions.push(position);
        self.normals.push(normal);
        self.rows.push(row);
    }

    /// The half and its mirror image, sharing the vertices on the plane.
    fn mirrored(&self, regions: &Regions) -> SkinnedMesh {
        let flip = Vec3::new(-1.0, 1.0, 1.0);
        let mirror = mirror_table();
        let mut mesh = SkinnedMesh::default();
        let mut twin = Vec::with_capacity(self.positions.len());
        for (vertex, &position) in self.positions.iter().enumerate() {
            twin.push(u32::try_from(vertex).unwrap_or(u32::MAX));
            let (joints, weights) = four_largest(&self.rows[vertex]);
            mesh.positions.push(position);
            mesh.normals.push(self.normals[vertex]);
            mesh.uvs.push(regions.face_uv(position));
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
            mesh.normals.push(self.normals[vertex] * flip);
            mesh.uvs.push(regions.face_uv(position * flip));
            mesh.joints.push(joints);
            mesh.weights.push(weights);
        }
        for kind in [PartKind::Skin, PartKind::Leotard, PartKind::Face] {
            let mut triangles = Vec::new();
            for (&[a, b, c], _) in
                (self.triangles.iter().zip(&self.kinds)).filter(|(_, k)| **k == kind)
            {
                triangles.push([a, b, c]);
                triangles.push([a, c, b].map(|vertex| twin[vertex as usize]));
            }
            mesh.parts.push(MeshPart { kind, triangles });
        }
        mesh
    }
}

/// Where the leotard ends and the painted face begins, in the bind pose.
pub(crate) struct Regions {
    /// Stature over 1.585 m.
    k: f32,
    crotch: f32,
    armpit: f32,
    armpit_x: f32,
    shoulder: f32,
    face_center: Vec3,
    face_radius: f32,
}

impl Regions {
    pub(crate) fn new(shape: &Shape) -> Self {
        let k = shape.body.height / 1.585;
        let head = shape.body.head.center;
        Self {
            k,
            crotch: shape.crotch,
            armpit: shape.body.level("armpit"),
            armpit_x: shape.body.level("armpit_x"),
            shoulder: shape.body.level("shoulder"),
            face_center: head + Vec3::new(0.0, -0.022, 0.085) * k,
            face_radius: 0.088 * k,
        }
    }

    /// Positive inside the leotard: above the leg line, below the scoop, inside the armholes.
    fn leotard(&self, point: Vec3) -> f32 {
        let k = self.k;
        let x = point.x.abs();
        let leg = point.y - (self.crotch - 0.022 * k) - 0.62 * (x - 0.02 * k).max(0.0);
        let front = smooth_front(point.z / (0.05 * k));
        let depth = self.armpit + (0.052 - 0.022 * front) * k;
        let scoop = depth + 14.5 / k * x * x - point.y;
        let armhole_x = 0.128 * k
            + (self.armpit_x + 0.012 * k - 0.128 * k) * (self.shoulder - point.y)
                / (self.shoulder - self.armpit);
        leg.min(scoop).min(armhole_x - x)
    }

    /// Positive on the front of the head.
    fn face(&self, point: Vec3) -> f32 {
        self.face_radius - (point - self.face_center).length()
    }

    /// The face seen from the front, over the square around it; `v` down.
    fn face_uv(&self, point: Vec3) -> Vec2 {
        let offset = (point - self.face_center) / (2.0 * self.face_radius);
        Vec2::new(0.5 + offset.x, 0.5 - offset.y).clamp(Vec2::ZERO, Vec2::ONE)
    }
}

/// -1 behind, 1 in front, smooth between.
fn smooth_front(x: f32) -> f32 {
    2.0 * crate::surface::warp::smooth_step(0.5 + 0.5 * x) - 1.0
}
