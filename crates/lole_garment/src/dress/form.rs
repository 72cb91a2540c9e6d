//! The dancer as a dressmaker's form: her skin in one pose, and tapes around her trunk.

use glam::{Affine3A, Mat3, Vec3};
use lole_body::{Bone, Dancer, Pose, TapePoint};
use lole_geom::{MeshSurfels, Surfel, TriangleGrid};

use super::Pins;

/// Points of a tape around the trunk.
const TAPE_POINTS: usize = 144;
/// Distance between tapes [m].
const TAPE_STEP: f32 = 0.01;
/// Cells of the search for the nearest skin [m].
const CELL: f32 = 0.03;
/// How far the nearest skin is looked for [m].
const REACH: f32 = 0.12;

/// A dancer in one pose.
pub(crate) struct Form<'a> {
    pub(crate) dancer: &'a Dancer,
    pub(crate) world_from_bind: Vec<Affine3A>,
    tapes: Vec<Tape>,
    lowest: f32,
}

/// A tape around the trunk, posed.
struct Tape {
    points: Vec<TapePoint>,
    places: Vec<(Vec3, Vec3)>,
    /// Index of the point farthest to the left.
    left: usize,
    girth: f32,
}

/// Least distance of pinned cloth from the skin [m].
const LEAST_GAP: f32 = 0.004;

/// Half of the trunk that a place is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Face {
    Front,
    Back,
}

impl<'a> Form<'a> {
    /// The form in a pose, with tapes from `lowest` [m] up to the neck.
    pub(crate) fn new(dancer: &'a Dancer, pose: &Pose, lowest: f32) -> Self {
        let world_from_bind = dancer.skeleton.world_from_bind(pose);
        let top = dancer.skeleton.joint(Bone::Neck).y + 0.04;
        let mut tapes: Vec<Tape> = Vec::new();
        let mut level = 0_u16;
        loop {
            let height = lowest + f32::from(level) * TAPE_STEP;
            if top < height {
                break;
            }
            level += 1;
            let ring = dancer.tape_ring(height, TAPE_POINTS);
            match Tape::new(&ring, &world_from_bind) {
                Some(tape) => tapes.push(tape),
                None => break,
            }
        }
        Self {
            dancer,
            world_from_bind,
            tapes,
            lowest,
        }
    }

    /// The tapes below and above a height, and the share between them.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the tapes"
    )]
    fn between(&self, height: f32) -> Option<([&Tape; 2], f32)> {
        let last = self.tapes.len().checked_sub(1)?;
        let level = ((height - self.lowest) / TAPE_STEP).clamp(0.0, last as f32);
        let below = level as usize;
        let above = (below + 1).min(last);
        Some((
            [&self.tapes[below], &self.tapes[above]],
            level - below as f32,
        ))
    }

    /// A place on the tape at a height of the bind pose [m], and the way out of the body there: `share` 0
    /// is the middle of front or back, 1 her left side. `None` where there is no trunk.
    pub(crate) fn on_trunk(&self, height: f32, face: Face, share: f32) -> Option<(Vec3, Vec3)> {
        let (tapes, part) = self.between(height)?;
        let [below, above] = tapes.map(|tape| tape.at(face, share));
        let outward = below.1.lerp(above.1, part).normalize_or_zero();
        Some((self.lowered(below.0.lerp(above.0, part), height), outward))
    }

    /// A place that lies below the lowest tape.
    fn lowered(&self, place: Vec3, height: f32) -> Vec3 {
        place - Vec3::Y * (self.lowest - height).max(0.0)
    }

    /// Around the trunk from the middle of the back over her left side: `turn` 1 is once around.
    pub(crate) fn around_trunk(&self, height: f32, turn: f32) -> Option<(Vec3, Vec3)> {
        let (tapes, part) = self.between(height)?;
        let [below, above] = tapes.map(|tape| tape.around(turn));
        let outward = below.1.lerp(above.1, part).normalize_or_zero();
        Some((self.lowered(below.0.lerp(above.0, part), height), outward))
    }

    /// Length of the tape at a height of the bind pose [m].
    pub(crate) fn girth(&self, height: f32) -> f32 {
        self.between(height)
            .map_or(0.0, |([a, b], part)| a.girth + (b.girth - a.girth) * part)
    }

    /// A joint of the skeleton in the pose [m].
    pub(crate) fn joint(&self, bone: Bone) -> Vec3 {
        let joint = self.dancer.skeleton.joint(bone);
        self.world_from_bind[bone.index()].transform_point3(joint)
    }

    /// A place in the middle of the left arm so far from the shoulder [m], and the ways over the arm and to its
    /// front.
    pub(super) fn in_arm(&self, along: f32) -> [Vec3; 3] {
        let [shoulder, elbow, hand] =
            [Bone::LeftUpperArm, Bone::LeftLowerArm, Bone::LeftHand].map(|bone| self.joint(bone));
        let upper = elbow - shoulder;
        let (axis, center) = if along <= upper.length() {
            let axis = upper.normalize_or_zero();
            (axis, shoulder + axis * along)
        } else {
            let axis = (hand - elbow).normalize_or_zero();
            (axis, elbow + axis * (along - upper.length()))
        };
        let forward = (Vec3::Z - axis * axis.z).normalize_or_zero();
        let over = forward.cross(axis).normalize_or_zero();
        let over = if over.y < 0.0 { -over } else { over };
        [center, over, forward]
    }

    /// The skin of the trunk below places that it carries, and how far they lie over it [m]; `None` where
    /// one is far from all of it.
    pub(super) fn carry(&self, places: &[Vec3]) -> Option<Pins> {
        let (skin, surfels) = self.nearest_skin(places)?;
        let gaps = places.iter().zip(&surfels);
        let gaps =
            gaps.map(|(place, skin)| (*place - skin.position).dot(skin.normal).max(LEAST_GAP));
        Some(Pins {
            skin,
            gaps: gaps.collect(),
            tied: vec![None; places.len()],
        })
    }

    /// A place as the trunk carries it where it is nearest to a tape; `None` where there is no tape.
    pub(crate) fn tied(&self, place: Vec3) -> Option<TapePoint> {
        let points = self.tapes.iter().flat_map(|tape| &tape.points);
        let posed = points.map(|point| (point, point.posed(&self.world_from_bind)));
        let (nearest, _) = posed.min_by(|a, b| {
            let [a, b] = [a.1, b.1].map(|at| at.distance_squared(place));
            a.total_cmp(&b)
        })?;
        let shares = nearest.joints.into_iter().zip(nearest.weights);
        let (joints, weights) = trunk_alone(shares);
        let carrier = TapePoint {
            joints,
            weights,
            ..*nearest
        };
        Some(self.carried_to(carrier, place))
    }

    /// A point that goes as `carrier` does and lies at a place [m] in this pose.
    fn carried_to(&self, carrier: TapePoint, place: Vec3) -> TapePoint {
        // The point's own motion, read off four places of its bind pose.
        let moved = |bind_position: Vec3| {
            let point = TapePoint {
                bind_position,
                ..carrier
            };
            point.posed(&self.world_from_bind)
        };
        let origin = moved(Vec3::ZERO);
        let [x, y, z] = Vec3::AXES.map(|axis| moved(axis) - origin);
        let world_from_bind = Affine3A::from_mat3_translation(Mat3::from_cols(x, y, z), origin);
        TapePoint {
            bind_position: world_from_bind.inverse().transform_point3(place),
            ..carrier
        }
    }

    /// Places as the trunk carries them where they are girded around it: with the bones of the skin below
    /// them, but for the legs, which go with the hips. `None` where one is far from all skin.
    pub(crate) fn girded(&self, places: &[Vec3]) -> Option<Vec<Option<TapePoint>>> {
        let skin = &self.dancer.skin;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        skin.pose(&self.world_from_bind, &mut positions, &mut normals);
        let triangles = self.trunk_triangles();
        let grid = TriangleGrid::new(&positions, &triangles, CELL);
        let carried = places.iter().map(|&place| {
            let nearest = grid.nearest(place, REACH)?;
            let corners = triangles[nearest.triangle as usize];
            let shares = nearest.barycentric.to_array();
            let (joints, weights) = self.of_trunk(corners, shares);
            let carrier = TapePoint {
                bind_position: Vec3::ZERO,
                outward: Vec3::Y,
                joints,
                weights,
            };
            Some(self.carried_to(carrier, place))
        });
        carried.map(|carried| carried.map(Some)).collect()
    }

    /// The bones of the trunk that carry a point of a triangle of the skin, and their shares.
    fn of_trunk(&self, corners: [u32; 3], shares: [f32; 3]) -> ([u16; 4], [f32; 4]) {
        let skin = &self.dancer.skin;
        let shares = corners.into_iter().zip(shares).flat_map(|(corner, share)| {
            let corner = corner as usize;
            let carried = skin.joints[corner].into_iter().zip(skin.weights[corner]);
            carried.map(move |(joint, weight)| (joint, share * weight))
        });
        trunk_alone(shares)
    }

    /// The same where they come to lie so far over it: what carries them, and where they are then [m].
    pub(crate) fn carried(
        &self,
        places: &[Vec3],
        gaps: &[f32],
    ) -> Option<(MeshSurfels, Vec<Vec3>)> {
        let (carriers, surfels) = self.nearest_skin(places)?;
        let over = surfels.iter().zip(gaps);
        let over = over.map(|(skin, gap)| skin.position + skin.normal * *gap);
        Some((carriers, over.collect()))
    }

    /// The points of the trunk's skin nearest to places. Arms hang beside it and go their own way.
    fn nearest_skin(&self, places: &[Vec3]) -> Option<(MeshSurfels, Vec<Surfel>)> {
        let skin = &self.dancer.skin;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        skin.pose(&self.world_from_bind, &mut positions, &mut normals);
        let triangles = self.trunk_triangles();
        let places = places.iter().copied();
        let carriers = MeshSurfels::nearest_to(places, (&positions, &triangles), REACH)?;
        let mut surfels = Vec::new();
        carriers.pose(&positions, &normals, &mut surfels);
        Some((carriers, surfels))
    }

    /// Triangles of the skin without the arms'.
    fn trunk_triangles(&self) -> Vec<[u32; 3]> {
        let skin = &self.dancer.skin;
        let mut triangles = skin.body_triangles();
        let is_of_trunk = |corner: &u32| {
            let bone = Bone::ALL[usize::from(skin.joints[*corner as usize][0])];
            !is_of_arm(bone)
        };
        triangles.retain(|corners| corners.iter().all(is_of_trunk));
        triangles
    }

    /// Moves places out of the skin until each keeps its `gap` [m] from it.
    pub(crate) fn push_out(&self, places: &mut [Vec3], gap: impl Fn(usize) -> f32) {
        self.push_out_some(places, |particle| Some(gap(particle)));
    }

    /// The same of those that have a gap.
    pub(crate) fn push_out_some(&self, places: &mut [Vec3], gap: impl Fn(usize) -> Option<f32>) {
        let skin = &self.dancer.skin;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        skin.pose(&self.world_from_bind, &mut positions, &mut normals);
        let triangles = skin.body_triangles();
        let grid = TriangleGrid::new(&positions, &triangles, CELL);
        for (particle, place) in places.iter_mut().enumerate() {
            let Some(gap) = gap(particle) else {
                continue;
            };
            let Some(nearest) = grid.nearest(*place, REACH) else {
                continue;
            };
            let corners = triangles[nearest.triangle as usize];
            let normals = corners.map(|corner| normals[corner as usize]);
            let outward = lole_geom::triangle_grid::blend(normals, nearest.barycentric);
            let height = (*place - nearest.point).dot(outward);
            if height < gap {
                *place = nearest.point + outward.normalize_or_zero() * gap;
            }
        }
    }
}

impl Tape {
    fn new(ring: &[TapePoint], world_from_bind: &[Affine3A]) -> Option<Self> {
        let (left, _) = (ring.iter().enumerate()).max_by(|a, b| {
            let x = |point: &TapePoint| point.bind_position.x;
            x(a.1).total_cmp(&x(b.1))
        })?;
        let places: Vec<(Vec3, Vec3)> = (ring.iter())
            .map(|point| {
                (
                    point.posed(world_from_bind),
                    point.posed_outward(world_from_bind),
                )
            })
            .collect();
        let next = places.iter().cycle().skip(1);
        let girth = places
            .iter()
            .zip(next)
            .map(|(a, b)| a.0.distance(b.0))
            .sum();
        Some(Self {
            points: ring.to_vec(),
            places,
            left,
            girth,
        })
    }

    fn at(&self, face: Face, share: f32) -> (Vec3, Vec3) {
        let from = match face {
            Face::Front => 0.5 * self.places.len() as f32,
            Face::Back => 0.0,
        };
        self.of_index(from + (self.left as f32 - from) * share)
    }

    fn around(&self, turn: f32) -> (Vec3, Vec3) {
        let turn = turn - turn.floor();
        self.of_index(turn * self.places.len() as f32)
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "wrapped into the ring"
    )]
    fn of_index(&self, index: f32) -> (Vec3, Vec3) {
        let count = self.places.len();
        let index = index.rem_euclid(count as f32);
        let before = index as usize % count;
        let after = (before + 1) % count;
        let part = index - index.floor();
        let [a, b] = [before, after].map(|at| self.places[at]);
        (a.0.lerp(b.0, part), a.1.lerp(b.1, part).normalize_or_zero())
    }
}

/// The four bones of the trunk that carry most, and their shares: legs go with the hips, arms with the chest.
fn trunk_alone(shares: impl Iterator<Item = (u16, f32)>) -> ([u16; 4], [f32; 4]) {
    let mut sums = [0.0_f32; Bone::ALL.len()];
    for (joint, share) in shares {
        let bone = match Bone::ALL[usize::from(joint)] {
            leg if is_of_leg(leg) => Bone::Hips,
            arm if is_of_arm(arm) => Bone::UpperChest,
            trunk => trunk,
        };
        sums[bone.index()] += share;
    }
    let mut order: Vec<usize> = (0..sums.len()).collect();
    order.sort_by(|&a, &b| sums[b].total_cmp(&sums[a]));
    let most = [0, 1, 2, 3].map(|place| order[place]);
    let total: f32 = most.iter().map(|&bone| sums[bone]).sum();
    let joints = most.map(|bone| u16::try_from(bone).unwrap_or(0));
    (joints, most.map(|bone| sums[bone] / total.max(1.0e-6)))
}

/// Whether a bone is an arm's.
fn is_of_arm(bone: Bone) -> bool {
    let is_upper_arm = |bone| matches!(bone, Bone::LeftUpperArm | Bone::RightUpperArm);
    bone.lineage().any(is_upper_arm)
}

/// Whether a bone is a leg's.
fn is_of_leg(bone: Bone) -> bool {
    let is_upper_leg = |bone| matches!(bone, Bone::LeftUpperLeg | Bone::RightUpperLeg);
    bone.lineage().any(is_upper_leg)
}
