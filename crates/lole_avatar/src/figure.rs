//! From the bones and meshes of a file to a dancer's skeleton and skin.
//!
//! The product's skeleton has three bones between hips and arms and two between arms and head. A
//! file has any number there: its joints are shared out, the one on which the arms hang always
//! being the upper chest, so that arms and shoulders turn together. Bones that a file lacks get a
//! joint where a person's would be, and carry nothing.

use std::collections::BTreeMap;

use glam::{Mat3, Quat, Vec3};
use lole_body::{Bone, MeshPart, PartKind, Skeleton, SkinnedMesh};
use lole_geom::mesh::vertex_normals;
use lole_motion::BoneMap;

use crate::AvatarError;
use crate::container::File;
use crate::geometry::Geometry;
use crate::look::looks;
use crate::rig::Rig;

/// Vertices closer than this are one on the body's surface [m].
const WELD: f32 = 1.0e-5;
/// Skin that the head carries is no body below the neck by this part of the way from the hip
/// joints to the neck: there it is hair, a veil or a beard.
const HAIR_BELOW_NECK: f32 = 0.12;

/// Joints of the left hand of the measured woman [m], wrist first, from which missing fingers are
/// taken: in body space, with the forearm's beginning before them.
const HAND: [[f32; 3]; 17] = [
    [0.3145, 1.0820, 0.0265],
    [0.4245, 0.9602, 0.1636],
    [0.4254, 0.9517, 0.2016],
    [0.4071, 0.9431, 0.2199],
    [0.3963, 0.9294, 0.2466],
    [0.4489, 0.9204, 0.2450],
    [0.4520, 0.9064, 0.2626],
    [0.4515, 0.8914, 0.2764],
    [0.4632, 0.9115, 0.2286],
    [0.4697, 0.8877, 0.2458],
    [0.4721, 0.8680, 0.2601],
    [0.4699, 0.9055, 0.2134],
    [0.4777, 0.8833, 0.2246],
    [0.4813, 0.8642, 0.2349],
    [0.4706, 0.8987, 0.1960],
    [0.4763, 0.8816, 0.2020],
    [0.4777, 0.8686, 0.2064],
];
/// Elbow, wrist and the first finger bone of each side; the other fourteen follow it.
const HANDS: [[Bone; 3]; 2] = [
    [
        Bone::LeftLowerArm,
        Bone::LeftHand,
        Bone::LeftThumbMetacarpal,
    ],
    [
        Bone::RightLowerArm,
        Bone::RightHand,
        Bone::RightThumbMetacarpal,
    ],
];

/// Bones of the rig's joints, and places of all bones.
struct Bones {
    /// The bone that carries what each joint of the rig carries.
    of_joint: Vec<Option<Bone>>,
    skeleton: Skeleton,
}

/// The dancer's skeleton and skin of a file.
pub(crate) fn skeleton_and_skin(
    file: &File<'_>,
    rig: &Rig,
    geometry: &Geometry,
) -> Result<(Skeleton, SkinnedMesh), AvatarError> {
    let places = rig.body_places(geometry.shift);
    let bones = Bones::new(&rig.map, &places);
    let mut skin = SkinnedMesh {
        positions: geometry.positions.clone(),
        normals: geometry.normals.clone(),
        uvs: geometry.uvs.clone(),
        ..SkinnedMesh::default()
    };
    for carriers in &geometry.carriers {
        let (joints, weights) = bones.carriers(rig, carriers);
        skin.joints.push(joints);
        skin.weights.push(weights);
    }
    let (looks, parts) = looks(file, geometry)?;
    skin.parts = parts
        .into_iter()
        .map(|triangles| MeshPart {
            kind: PartKind::Given,
            triangles,
        })
        .collect();
    skin.looks = looks;
    shade(&mut skin);
    weld(&mut skin, &bones.skeleton);
    Ok((bones.skeleton, skin))
}

impl Bones {
    fn new(map: &BoneMap, places: &[Vec3]) -> Self {
        let mut of_joint = vec![None; places.len()];
        let mut joints: Vec<Option<Vec3>> = vec![None; Bone::COUNT];
        let chained = [Bone::Spine, Bone::Chest, Bone::UpperChest, Bone::Neck];
        for &bone in Bone::ALL {
            if let Some(joint) = map.joint(bone).filter(|_| !chained.contains(&bone)) {
                of_joint[joint] = Some(bone);
                joints[bone.index()] = Some(places[joint]);
            }
        }
        // Below, middle, top of the trunk: the last joint is always the top.
        let spine = map.spine();
        let trunk = [Bone::Spine, Bone::Chest, Bone::UpperChest];
        for (place, &joint) in spine.iter().enumerate() {
            let from_top = spine.len() - 1 - place;
            let third = match (spine.len(), from_top) {
                (_, 0) => 2,
                (2, _) => 0,
                (count, _) => 2 - (3 * from_top).div_ceil(count.max(3)).min(2),
            };
            let bone = trunk[third];
            of_joint[joint] = Some(bone);
            joints[bone.index()].get_or_insert(places[joint]);
        }
        for &joint in map.neck() {
            if of_joint[joint].is_none() {
                of_joint[joint] = Some(Bone::Neck);
                joints[Bone::Neck.index()].get_or_insert(places[joint]);
            }
        }
        let joints = filled(joints);
        Self {
            of_joint,
            skeleton: Skeleton {
                joints,
                // Found on the skin.
                waist_side: Vec3::ZERO,
            },
        }
    }

    /// The four bones that carry a vertex most, and their shares.
    fn carriers(&self, rig: &Rig, carriers: &[(usize, f32)]) -> ([u16; 4], [f32; 4]) {
        let mut shares: BTreeMap<usize, f32> = BTreeMap::new();
        for &(joint, share) in carriers {
            let above = rig
                .rest
                .ancestors(joint)
                .find_map(|joint| self.of_joint[joint]);
            *shares
                .entry(above.unwrap_or(Bone::Hips).index())
                .or_default() += share;
        }
        let mut order: Vec<(usize, f32)> = shares.into_iter().collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        order.truncate(4);
        let sum: f32 = order.iter().map(|(_, share)| share).sum();
        let (mut joints, mut weights) = ([0; 4], [0.0; 4]);
        for (slot, (bone, share)) in order.into_iter().enumerate() {
            joints[slot] = u16::try_from(bone).unwrap_or(0);
            weights[slot] = share / sum.max(f32::MIN_POSITIVE);
        }
        if sum <= 0.0 {
            weights[0] = 1.0;
        }
        (joints, weights)
    }
}

/// Places of all bones: missing ones where a person's would be.
fn filled(known: Vec<Option<Vec3>>) -> Vec<Vec3> {
    let mut joints = known;
    let at = |joints: &[Option<Vec3>], bone: Bone| joints[bone.index()];
    let or = |joints: &mut [Option<Vec3>], bone: Bone, place: Option<Vec3>| {
        if let (None, Some(place)) = (joints[bone.index()], place) {
            joints[bone.index()] = Some(place);
        }
    };
    let between = |a: Option<Vec3>, b: Option<Vec3>, share: f32| Some(a?.lerp(b?, share));
    let middle = between(
        at(&joints, Bone::LeftUpperArm),
        at(&joints, Bone::RightUpperArm),
        0.5,
    );
    let hips = at(&joints, Bone::Hips);
    or(&mut joints, Bone::UpperChest, between(hips, middle, 0.8));
    let top = at(&joints, Bone::UpperChest);
    or(&mut joints, Bone::Chest, top);
    let chest = at(&joints, Bone::Chest);
    or(&mut joints, Bone::Spine, chest);
    let above = between(hips, middle, 1.25);
    or(&mut joints, Bone::Head, above);
    let head = at(&joints, Bone::Head);
    or(&mut joints, Bone::Neck, between(middle, head, 0.5));
    for (shoulder, arm) in [
        (Bone::LeftShoulder, Bone::LeftUpperArm),
        (Bone::RightShoulder, Bone::RightUpperArm),
    ] {
        let arm = at(&joints, arm);
        or(&mut joints, shoulder, between(middle, arm, 0.35));
    }
    for [_, knee, foot, toes] in Bone::LEGS {
        let [knee, foot] = [knee, foot].map(|bone| at(&joints, bone));
        if let (Some(knee), Some(foot)) = (knee, foot) {
            let ahead = Vec3::Z * (0.35 * knee.distance(foot));
            or(&mut joints, toes, Some((foot + ahead).with_y(0.3 * foot.y)));
        }
    }
    for (side, [elbow, wrist, first]) in HANDS.into_iter().enumerate() {
        let [elbow, wrist] = [elbow, wrist].map(|bone| at(&joints, bone));
        if let (Some(elbow), Some(wrist)) = (elbow, wrist) {
            let fingers = fingers([elbow, wrist], side);
            for (finger, place) in Bone::ALL[first.index()..].iter().zip(fingers) {
                or(&mut joints, *finger, Some(place));
            }
        }
    }
    let hips = hips.unwrap_or(Vec3::ZERO);
    joints
        .into_iter()
        .map(|joint| joint.unwrap_or(hips))
        .collect()
}

/// Finger joints of the measured woman carried to another forearm, palm down.
fn fingers([elbow, wrist]: [Vec3; 2], side: usize) -> [Vec3; 15] {
    let mirror = Vec3::new(if side == 0 { 1.0 } else { -1.0 }, 1.0, 1.0);
    let measured = HAND.map(|place| Vec3::from_array(place) * mirror);
    let frame = |along: Vec3, across: Vec3| {
        let along = along.try_normalize().unwrap_or(Vec3::X);
        let across = (across - along * across.dot(along))
            .try_normalize()
            .unwrap_or_else(|| along.any_orthonormal_vector());
        Quat::from_mat3(&Mat3::from_cols(along, across, along.cross(across))).normalize()
    };
    // From little to index finger: to the front, where palms face the floor.
    let from = frame(measured[1] - measured[0], measured[5] - measured[14]);
    let to = frame(wrist - elbow, Vec3::Z);
    let scale = wrist.distance(elbow) / measured[1].distance(measured[0]);
    let turn = to * from.inverse();
    let mut places = [Vec3::ZERO; 15];
    for (place, joint) in places.iter_mut().zip(&measured[2..]) {
        *place = wrist + turn * (*joint - measured[1]) * scale;
    }
    places
}

/// Gives normals to vertices that have none.
fn shade(skin: &mut SkinnedMesh) {
    let triangles: Vec<[u32; 3]> = drawn(skin).collect();
    let computed = vertex_normals(&skin.positions, &triangles);
    for (normal, computed) in skin.normals.iter_mut().zip(computed) {
        if *normal == Vec3::ZERO {
            *normal = computed;
        }
    }
}

fn drawn(skin: &SkinnedMesh) -> impl Iterator<Item = [u32; 3]> + '_ {
    skin.parts
        .iter()
        .flat_map(|part| part.triangles.iter().copied())
}

/// The surface that cloth meets: vertices at one place become one, with a smooth normal of its own;
/// hair that hangs below the neck is left out.
fn weld(skin: &mut SkinnedMesh, skeleton: &Skeleton) {
    #[expect(clippy::cast_possible_truncation, reason = "a body has some meters")]
    let key = |place: Vec3| place.to_array().map(|part| (part / WELD).round() as i32);
    let mut first: BTreeMap<[i32; 3], u32> = BTreeMap::new();
    let mut twins: Vec<u32> = Vec::with_capacity(skin.positions.len());
    for (vertex, &place) in (0..).zip(&skin.positions) {
        twins.push(*first.entry(key(place)).or_insert(vertex));
    }
    let mut shared = vec![false; twins.len()];
    for (vertex, &twin) in (0..).zip(&twins) {
        shared[twin as usize] |= vertex != twin;
    }
    // What stands for several vertices is a vertex of its own, which is not drawn.
    let mut own: Vec<u32> = (0..).take(twins.len()).collect();
    for vertex in 0..twins.len() {
        if shared[vertex] {
            own[vertex] = u32::try_from(skin.positions.len()).unwrap_or(u32::MAX);
            skin.positions.push(skin.positions[vertex]);
            skin.normals.push(skin.normals[vertex]);
            skin.uvs.push(skin.uvs[vertex]);
            skin.joints.push(skin.joints[vertex]);
            skin.weights.push(skin.weights[vertex]);
        }
    }
    let stands_for = |vertex: u32| own[twins[vertex as usize] as usize];
    let neck = skeleton.joint(Bone::Neck).y;
    let hips = skeleton.joint(Bone::Hips).y;
    let lowest_head = neck - HAIR_BELOW_NECK * (neck - hips);
    let head = u16::try_from(Bone::Head.index()).unwrap_or(0);
    let is_body = |triangle: &[u32; 3]| {
        let mut corners = triangle.iter().map(|&vertex| vertex as usize);
        !corners.any(|v| skin.joints[v][0] == head && skin.positions[v].y < lowest_head)
    };
    let surface: Vec<[u32; 3]> = drawn(skin)
        .map(|triangle| triangle.map(stands_for))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .filter(is_body)
        .collect();
    let smooth = vertex_normals(&skin.positions, &surface);
    for (normal, smooth) in skin.normals.iter_mut().zip(smooth).skip(twins.len()) {
        *normal = smooth;
    }
    skin.surface = surface;
}
