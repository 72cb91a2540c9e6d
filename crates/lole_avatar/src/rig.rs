//! The bones of a file: which node is which, where they rest, and what its numbers measure.

use glam::{Affine3A, Mat4, Quat, Vec3};
use lole_body::Bone;
use lole_motion::{Axes, BoneMap, Joint, JointPlace, MapSource, Recording};

use crate::AvatarError;
use crate::container::File;
use crate::tree::{Local, Tree, locals, place};
use crate::vrm::{Format, human_bones};

/// Thigh and shank of any dancer [m]: a small figure's to a giant's.
const LEGS: std::ops::RangeInclusive<f32> = 0.2..=1.4;
/// Units in which files are written whose legs are not of a person's length in meters.
const UNITS: [(&str, f32); 5] = [
    ("cm", 0.01),
    ("mm", 0.001),
    ("inch", 0.0254),
    ("dm", 0.1),
    ("km", 1000.0),
];
/// A trunk that leans more than this over the legs at rest is no person's [°].
const MOST_LEAN: f32 = 50.0;
/// Cosine of the angle up to which a front is taken for an axis of the file.
const ALONG_AXIS: f32 = 0.97;

/// The bones of a file at rest.
pub(crate) struct Rig {
    pub(crate) tree: Tree,
    /// Local transforms of all nodes as the file leaves them.
    pub(crate) locals: Vec<Local>,
    /// For each node, its transform where the skins were bound to it; elsewhere where it lies.
    pub(crate) binds: Vec<Affine3A>,
    /// Joints at rest, in the units of the scene, and no frames.
    pub(crate) rest: Recording,
    /// Node of each joint.
    pub(crate) nodes: Vec<usize>,
    /// Joint of each node.
    pub(crate) joints: Vec<Option<usize>>,
    /// Which joint is which bone.
    pub(crate) map: BoneMap,
    /// Left, up and front of the body at rest.
    pub(crate) axes: Axes,
    /// Units of the scene in one of the skins' space.
    pub(crate) scene_per_bind: f32,
    /// Name and length [m] of a unit of the scene.
    pub(crate) unit: (&'static str, f32),
}

/// How the arms are held at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RestPose {
    /// Level to the sides.
    T,
    /// Aslant.
    A,
    /// Beside the body.
    ArmsDown,
    /// Otherwise.
    Other,
}

impl Rig {
    /// Finds the bones; `list` says which joint is which bone, as [`BoneMap::from_list`] takes it.
    pub(crate) fn new(file: &File<'_>, list: Option<&str>) -> Result<Self, AvatarError> {
        let format = Format::of(file);
        let tree = Tree::new(file)?;
        let locals = locals(file)?;
        let worlds = tree.worlds(&locals);
        let binds = binds(file, &tree, &locals, &worlds)?;
        let human = human_bones(file, format)?;
        let hung = JointNodes::of(file, &tree, human.as_deref());
        let places = |transforms: &[Affine3A]| -> Vec<JointPlace> {
            let nodes = hung.nodes.iter();
            nodes.map(|&node| place(&transforms[node])).collect()
        };
        let (scene, bound) = (places(&worlds), places(&binds));
        let unscaled = hung.recording(file, &tree, &bound);
        let map = match (list, human) {
            (Some(list), _) => BoneMap::from_list(&unscaled, list),
            (None, Some(human)) => {
                let joint = |node: &Option<usize>| node.and_then(|node| hung.joints[node]);
                let joints = human.iter().map(joint).collect();
                BoneMap::given(&unscaled, MapSource::File(format.name()), joints)
            }
            (None, None) => BoneMap::recognize(&unscaled),
        };
        let map = map.map_err(AvatarError::NotHumanoid)?;
        check_upright(&map, &bound)?;
        let [bind_leg, scene_leg] = [&bound, &scene].map(|places| leg_length(&map, places));
        let unit = unit(scene_leg)?;
        let scene_per_bind = scene_leg / bind_leg;
        if !(scene_per_bind.is_finite() && 0.0 < scene_per_bind) {
            return Err(AvatarError::UnknownScale { meters: bind_leg });
        }
        let scaled: Vec<JointPlace> = (bound.iter())
            .map(|place| JointPlace {
                position: place.position * scene_per_bind,
                ..*place
            })
            .collect();
        let axes = axes(&map, &scaled);
        let rest = hung.recording(file, &tree, &scaled);
        Ok(Self {
            tree,
            locals,
            binds,
            rest,
            nodes: hung.nodes,
            joints: hung.joints,
            map,
            axes,
            scene_per_bind,
            unit,
        })
    }

    /// Bone of a node: the one it is, or else the one it hangs on.
    pub(crate) fn joint_above(&self, node: usize) -> Option<usize> {
        let known = |node: usize| self.joints[node].filter(|&joint| self.map.is_recognized(joint));
        self.tree.nearest(node, known)
    }

    /// What sets a body on the floor and over the middle, once it is turned and in meters, whose
    /// lowest point lies at `lowest` [m].
    pub(crate) fn shift(&self, lowest: f32) -> Vec3 {
        let places = self.body_places(Vec3::ZERO);
        let at = |bone| {
            let joint = self.map.joint(bone);
            joint.map_or(Vec3::ZERO, |joint| places[joint])
        };
        let middle = 0.5 * (at(Bone::LeftUpperLeg) + at(Bone::RightUpperLeg));
        Vec3::new(-middle.x, -lowest, -middle.z)
    }

    /// Joints in body space [m], moved by `shift`.
    pub(crate) fn body_places(&self, shift: Vec3) -> Vec<Vec3> {
        let turn = self.axes.world_from_file();
        let places = self.rest.rest_places();
        let places = places.iter();
        places
            .map(|place| turn * place.position * self.unit.1 + shift)
            .collect()
    }

    /// How the arms are held at rest.
    pub(crate) fn rest_pose(&self) -> RestPose {
        let places = self.rest.rest_places();
        let at = |bone| self.map.joint(bone).map(|joint| places[joint].position);
        let drop = |upper, hand| {
            let arm = at(hand)? - at(upper)?;
            let aside = arm.dot(self.axes.left).abs();
            Some((-arm.dot(self.axes.up), aside, arm.length()))
        };
        let arms = [
            drop(Bone::LeftUpperArm, Bone::LeftHand),
            drop(Bone::RightUpperArm, Bone::RightHand),
        ];
        let [Some(left), Some(right)] = arms else {
            return RestPose::Other;
        };
        let mean = |part: fn((f32, f32, f32)) -> f32| 0.5 * (part(left) + part(right));
        let (down, aside, length) = (mean(|a| a.0), mean(|a| a.1), mean(|a| a.2));
        let slope = down / length.max(f32::MIN_POSITIVE);
        // Sines of 20° and 65°.
        match slope {
            _ if aside < 0.2 * length && slope < 0.9 => RestPose::Other,
            s if s.abs() < 0.34 => RestPose::T,
            s if (0.34..0.906).contains(&s) => RestPose::A,
            s if 0.906 <= s => RestPose::ArmsDown,
            _ => RestPose::Other,
        }
    }
}

/// Where the skins were bound to each node, or else where it lies below the node it hangs on.
fn binds(
    file: &File<'_>,
    tree: &Tree,
    locals: &[Local],
    worlds: &[Affine3A],
) -> Result<Vec<Affine3A>, AvatarError> {
    let mut bound: Vec<Option<Affine3A>> = vec![None; worlds.len()];
    let mut skins: Vec<usize> = (0..file.root.skins.len()).collect();
    // The skin of most joints first; equal ones as they stand.
    skins.sort_by_key(|&skin| usize::MAX - file.root.skins[skin].joints.len());
    for skin in skins {
        for (node, inverse) in skin_joints(file, skin)? {
            let bind = match inverse {
                Some(inverse) => inverse.inverse(),
                None => worlds[node],
            };
            if !bind.is_finite() {
                return Err(AvatarError::part(
                    format!("skins[{skin}].inverseBindMatrices"),
                    "逆にできない行列があります",
                    "a matrix has no inverse",
                ));
            }
            bound[node].get_or_insert(bind);
        }
    }
    let mut binds = worlds.to_vec();
    for &node in &tree.order {
        binds[node] = match (bound[node], tree.parents[node]) {
            (Some(bind), _) => bind,
            (None, Some(parent)) => binds[parent] * locals[node].parent_from_node(),
            (None, None) => worlds[node],
        };
    }
    Ok(binds)
}

/// Node and inverse bind matrix of every joint of a skin.
pub(crate) fn skin_joints(
    file: &File<'_>,
    skin: usize,
) -> Result<Vec<(usize, Option<Affine3A>)>, AvatarError> {
    let said = &file.root.skins[skin];
    let inverses = match said.inverse_bind_matrices {
        Some(index) => Some(file.floats::<16>(index)?),
        None => None,
    };
    let joints = said.joints.iter().enumerate();
    joints
        .map(|(place, node)| {
            let wrong = |japanese: &str, english: &str| {
                AvatarError::part(format!("skins[{skin}].joints[{place}]"), japanese, english)
            };
            if file.root.get(*node).is_none() {
                return Err(wrong("ノードがありません", "there is no such node"));
            }
            let inverse = match &inverses {
                Some(inverses) => {
                    let columns = inverses
                        .get(place)
                        .ok_or_else(|| wrong("行列がありません", "it has no matrix"))?;
                    Some(Affine3A::from_mat4(Mat4::from_cols_array(columns)))
                }
                None => None,
            };
            Ok((node.value(), inverse))
        })
        .collect()
}

/// Nodes that can be joints.
struct JointNodes {
    /// Parents first.
    nodes: Vec<usize>,
    /// The joint of each node of the file.
    joints: Vec<Option<usize>>,
}

impl JointNodes {
    /// All but those that only carry meshes.
    fn of(file: &File<'_>, tree: &Tree, human: Option<&[Option<usize>]>) -> Self {
        let mut needed = vec![false; file.root.nodes.len()];
        let skins = file.root.skins.iter().flat_map(|skin| &skin.joints);
        let of_skins = skins.map(|node| node.value());
        let of_human = human.into_iter().flatten().flatten().copied();
        for node in of_skins.chain(of_human) {
            if let Some(needed) = needed.get_mut(node) {
                *needed = true;
            }
        }
        let has_joints = needed.iter().any(|&needed| needed);
        for (node, needed) in needed.iter_mut().enumerate() {
            // Without skins every node without a mesh may be a joint.
            *needed |= !has_joints && file.root.nodes[node].mesh.is_none();
        }
        for &node in tree.order.iter().rev() {
            if let (true, Some(parent)) = (needed[node], tree.parents[node]) {
                needed[parent] = true;
            }
        }
        let nodes: Vec<usize> = (tree.order.iter().copied())
            .filter(|&node| needed[node])
            .collect();
        let mut joints = vec![None; needed.len()];
        for (joint, &node) in nodes.iter().enumerate() {
            joints[node] = Some(joint);
        }
        Self { nodes, joints }
    }

    /// Joints at rest that lie at `places`.
    fn recording(&self, file: &File<'_>, tree: &Tree, places: &[JointPlace]) -> Recording {
        let rest = self.nodes.iter().zip(places).map(|(&node, place)| {
            let parent = tree.parents[node].and_then(|parent| self.joints[parent]);
            let (translation, rotation) = within(parent.map(|parent| places[parent]), *place);
            Joint {
                name: file.node_name(node).to_owned(),
                parent,
                translation,
                rotation,
                channel_count: 3,
            }
        });
        Recording {
            joints: rest.collect(),
            frame_seconds: 1.0 / 60.0,
            rotations: Vec::new(),
            translations: Vec::new(),
        }
    }
}

/// A place in the space of its parent.
pub(crate) fn within(parent: Option<JointPlace>, place: JointPlace) -> (Vec3, Quat) {
    match parent {
        Some(parent) => {
            let back = parent.rotation.inverse();
            (
                back * (place.position - parent.position),
                (back * place.rotation).normalize(),
            )
        }
        None => (place.position, place.rotation),
    }
}

/// Mean length of thigh and shank.
fn leg_length(map: &BoneMap, places: &[JointPlace]) -> f32 {
    let at = |bone| {
        let joint = map.joint(bone);
        joint.map_or(Vec3::ZERO, |joint| places[joint].position)
    };
    let leg = |[upper, lower, foot, _]: [Bone; 4]| {
        at(upper).distance(at(lower)) + at(lower).distance(at(foot))
    };
    0.5 * (leg(Bone::LEGS[0]) + leg(Bone::LEGS[1]))
}

/// The unit that gives legs a person's length; meters, as glTF asks, wherever they do.
fn unit(leg: f32) -> Result<(&'static str, f32), AvatarError> {
    if LEGS.contains(&leg) {
        return Ok(("m", 1.0));
    }
    let fits = |(_, meters): &&(&str, f32)| LEGS.contains(&(leg * meters));
    let found = UNITS.iter().find(fits).copied();
    found.ok_or(AvatarError::UnknownScale { meters: leg })
}

/// Refuses whose trunk does not stand over the legs.
fn check_upright(map: &BoneMap, places: &[JointPlace]) -> Result<(), AvatarError> {
    let at = |bone| {
        let joint = map.joint(bone);
        joint.map_or(Vec3::ZERO, |joint| places[joint].position)
    };
    let middle = |[a, b]: [Bone; 2]| 0.5 * (at(a) + at(b));
    let hips = middle([Bone::LeftUpperLeg, Bone::RightUpperLeg]);
    let feet = middle([Bone::LeftFoot, Bone::RightFoot]);
    let shoulders = middle([Bone::LeftUpperArm, Bone::RightUpperArm]);
    let degrees = (shoulders - hips).angle_between(hips - feet).to_degrees();
    if MOST_LEAN < degrees {
        return Err(AvatarError::FourLegged { degrees });
    }
    Ok(())
}

/// Axes of the body at rest; who faces nearly along an axis of the file faces along it.
fn axes(map: &BoneMap, places: &[JointPlace]) -> Axes {
    let axes = Axes::of(map, places);
    let along = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z];
    let near = along.iter().find(|axis| ALONG_AXIS < axis.dot(axes.left));
    Axes::new(near.copied().unwrap_or(axes.left), axes.up)
}
