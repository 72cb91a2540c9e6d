//! Dancer and costume in the T-pose that VRM rests in.

use std::io;

use glam::{Affine3A, Quat, Vec3};
use lole_body::skin::blend;
use lole_body::{Bone, Dancer, Pose, Skeleton};
use lole_export::glb::GlbShape;
use lole_export::take::{TakeScene, TakeSource};
use lole_stage::{Production, WornSurface};

/// Cloth whose hem is not farther below the hips than this [m] does not hang.
const LEAST_HANG: f32 = 0.15;

/// The body in three poses: as it is bound, in the T-pose, and in the first frame of the take.
pub(super) struct Rest {
    pub(super) skeleton: Skeleton,
    /// Skin in the T-pose.
    pub(super) positions: Vec<Vec3>,
    pub(super) normals: Vec<Vec3>,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
    /// Skin in the first frame.
    first_positions: Vec<Vec3>,
    t_from_bind: Vec<Affine3A>,
    first_from_bind: Vec<Affine3A>,
}

/// What of the take's meshes hangs from the hips, in the hips' frame at rest.
pub(super) struct Hanging {
    pub(super) surfaces: Vec<HangingSurface>,
}

/// What of one mesh hangs.
pub(super) struct HangingSurface {
    /// Place of the mesh in the take.
    pub(super) mesh: usize,
    pub(super) vertices: Vec<usize>,
    /// At rest [m], shape of `vertices`.
    pub(super) rest: Vec<Vec3>,
}

impl Rest {
    pub(super) fn new(dancer: &Dancer, first: &Pose) -> Self {
        let skeleton = &dancer.skeleton;
        let t_from_bind = skeleton.world_from_bind(&t_pose(skeleton));
        let first_from_bind = skeleton.world_from_bind(first);
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let (mut first_positions, mut unused) = (Vec::new(), Vec::new());
        (dancer.drawn()).pose(&first_from_bind, &mut first_positions, &mut unused);
        (dancer.drawn()).pose(&t_from_bind, &mut positions, &mut normals);
        let joints = Bone::ALL.iter().map(|&bone| {
            let world = t_from_bind[bone.index()];
            world.transform_point3(skeleton.joint(bone))
        });
        Self {
            skeleton: Skeleton {
                joints: joints.collect(),
                waist_side: skeleton.waist_side,
            },
            positions,
            normals,
            joints: dancer.drawn().joints.clone(),
            weights: dancer.drawn().weights.clone(),
            first_positions,
            t_from_bind,
            first_from_bind,
        }
    }

    /// The shape of closed eyes; none of a given body, whose lids are not known.
    pub(super) fn closed_eyes(&self, dancer: &Dancer) -> Option<GlbShape> {
        let drawn = dancer.drawn_body.as_ref()?;
        let head = self.t_from_bind[Bone::Head.index()];
        let moved = drawn.closing();
        let moved = moved.map(|(vertex, [_, closed])| (vertex, head.transform_vector3(closed)));
        Some(GlbShape {
            name: "blink",
            moved: moved.collect(),
            weights: Vec::new(),
        })
    }

    /// Where the hips are at rest [m].
    pub(super) fn hips(&self) -> Vec3 {
        self.skeleton.joint(Bone::Hips)
    }

    /// A place of the first frame in the hips' frame at rest.
    pub(super) fn off_hips(&self, place: Vec3) -> Vec3 {
        let hips = Bone::Hips.index();
        let bind_from_first = self.first_from_bind[hips].inverse();
        (self.t_from_bind[hips] * bind_from_first).transform_point3(place)
    }

    /// A direction of the first frame in the hips' frame at rest.
    pub(super) fn turned_off_hips(&self, normal: Vec3) -> Vec3 {
        let hips = Bone::Hips.index();
        let rest = self.t_from_bind[hips] * self.first_from_bind[hips].inverse();
        rest.transform_vector3(normal).normalize_or(Vec3::Y)
    }

    /// A place and a direction of the first frame in the T-pose, carried by bones.
    pub(super) fn carried(
        &self,
        (place, normal): (Vec3, Vec3),
        (joints, weights): ([u16; 4], [f32; 4]),
    ) -> (Vec3, Vec3) {
        let first = blend(&self.first_from_bind, joints, weights);
        let rest = blend(&self.t_from_bind, joints, weights) * first.inverse();
        let normal = rest.transform_vector3(normal);
        (rest.transform_point3(place), normal.normalize_or(Vec3::Y))
    }

    /// What carries the skin that is nearest to a place of the first frame.
    pub(super) fn nearest(&self, place: Vec3) -> ([u16; 4], [f32; 4]) {
        let far = |vertex: &usize| self.first_positions[*vertex].distance_squared(place);
        let vertices = 0..self.first_positions.len();
        let nearest = vertices.min_by(|a, b| far(a).total_cmp(&far(b)));
        let nearest = nearest.unwrap_or(0);
        (self.joints[nearest], self.weights[nearest])
    }

    /// Cloth below the hips, of garments that reach well below them.
    pub(super) fn hanging(
        &self,
        production: &Production,
        scene: &TakeScene,
        take: &mut dyn TakeSource,
    ) -> io::Result<Hanging> {
        let mut surfaces = Vec::new();
        let top = self.hips().y;
        for (mesh, surface) in production.surfaces().enumerate() {
            if matches!(surface, WornSurface::Beside(..)) || scene.meshes[mesh].vertex_count == 0 {
                continue;
            }
            let [positions, _] = take.vertices(0, mesh)?;
            let rest: Vec<Vec3> = positions.iter().map(|&it| self.off_hips(it)).collect();
            let hem = rest.iter().map(|it| it.y).fold(f32::INFINITY, f32::min);
            if top - LEAST_HANG < hem {
                continue;
            }
            let vertices = (0..rest.len()).filter(|&vertex| rest[vertex].y < top);
            let vertices: Vec<usize> = vertices.collect();
            surfaces.push(HangingSurface {
                mesh,
                rest: vertices.iter().map(|&vertex| rest[vertex]).collect(),
                vertices,
            });
        }
        Ok(Hanging { surfaces })
    }
}

/// Arms straight out to the sides.
fn t_pose(skeleton: &Skeleton) -> Pose {
    let mut pose = Pose::default();
    let arms = [
        (
            Bone::LeftUpperArm,
            Bone::LeftLowerArm,
            Bone::LeftHand,
            Vec3::X,
        ),
        (
            Bone::RightUpperArm,
            Bone::RightLowerArm,
            Bone::RightHand,
            Vec3::NEG_X,
        ),
    ];
    for (upper, lower, hand, out) in arms {
        let along =
            |from: Bone, to: Bone| (skeleton.joint(to) - skeleton.joint(from)).normalize_or(out);
        let raised = Quat::from_rotation_arc(along(upper, lower), out);
        let straight = Quat::from_rotation_arc(along(lower, hand), out);
        pose.rotate(upper, raised);
        pose.rotate(lower, raised.inverse() * straight);
    }
    pose
}
