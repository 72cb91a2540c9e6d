//! A dance of the product's own, written as a BVH file of another program would be: the truth that
//! reading and retargeting are held against.

use std::fmt::Write as _;

use glam::{EulerRot, Quat, Vec3};
use lole_body::{Bone, Dancer, Measurements, Pose, Skeleton};
use lole_hula::{Dance, MotionSettings};

/// How the other program writes.
#[derive(Clone)]
pub(crate) struct Manner {
    /// File units of one meter.
    pub(crate) units_per_meter: f32,
    /// Turn from the product's space to the file's.
    pub(crate) file_from_world: Quat,
    /// Position channels on every joint, instead of the root alone.
    pub(crate) six_channels: bool,
    /// Order of the rotation channels, outermost first.
    pub(crate) order: EulerRot,
    /// How far each arm is raised in the rest pose against the bind pose [rad].
    pub(crate) arms_raised: f32,
    /// What joints are called.
    pub(crate) name: fn(Bone) -> String,
    /// End of a line.
    pub(crate) line_end: &'static str,
}

impl Default for Manner {
    fn default() -> Self {
        Self {
            units_per_meter: 1.0,
            file_from_world: Quat::IDENTITY,
            six_channels: false,
            order: EulerRot::ZYX,
            arms_raised: 0.0,
            name: |bone| bone.name().to_owned(),
            line_end: "\n",
        }
    }
}

/// The dancer that all tests share.
pub(crate) fn dancer() -> &'static Dancer {
    static DANCER: std::sync::LazyLock<Dancer> = std::sync::LazyLock::new(|| {
        Dancer::new(&Measurements::woman()).expect("the default woman can be built")
    });
    &DANCER
}

/// Poses of a step, sixty a second, from where it repeats.
pub(crate) fn steps(settings: &MotionSettings, count: usize) -> Vec<Pose> {
    let dance = Dance::new(&dancer().skeleton, settings).expect("the settings can be danced");
    (0..count)
        .map(|pose| dance.pose_at(dance.lead_in() + pose as f32 / 60.0))
        .collect()
}

/// Joint of a bone in a pose [m].
pub(crate) fn joint(skeleton: &Skeleton, pose: &Pose, bone: Bone) -> Vec3 {
    skeleton.world_from_bind(pose)[bone.index()].transform_point3(skeleton.joint(bone))
}

/// A turn of each bone from the bind pose to the rest pose.
fn rest_turns(manner: &Manner) -> Vec<Quat> {
    let raise = |bone: Bone| {
        let above = std::iter::successors(Some(bone), |bone| bone.parent());
        let mut above =
            above.skip_while(|bone| !matches!(bone, Bone::LeftUpperArm | Bone::RightUpperArm));
        match above.next() {
            Some(Bone::LeftUpperArm) => Quat::from_rotation_z(manner.arms_raised),
            Some(_) => Quat::from_rotation_z(-manner.arms_raised),
            None => Quat::IDENTITY,
        }
    };
    Bone::ALL.iter().map(|&bone| raise(bone)).collect()
}

/// The text of a BVH file in which `skeleton` dances `poses`.
pub(crate) fn write_bvh(skeleton: &Skeleton, poses: &[Pose], manner: &Manner) -> String {
    let raised = rest_turns(manner);
    let mut text = "HIERARCHY\n".to_owned();
    let mut order = Vec::new();
    write_joint(
        &mut text,
        &mut order,
        (skeleton, manner, &raised),
        Bone::Hips,
        0,
    );
    write!(
        text,
        "MOTION\nFrames: {}\nFrame Time: 0.016666667\n",
        poses.len()
    )
    .expect("a string takes any text");
    for pose in poses {
        let numbers = numbers(skeleton, pose, (manner, &raised, &order));
        writeln!(text, "{}", numbers.join(" ")).expect("a string takes any text");
    }
    text.replace('\n', manner.line_end)
}

/// Offset of a bone from its parent in the file's rest pose.
fn offset(skeleton: &Skeleton, manner: &Manner, raised: &[Quat], bone: Bone) -> Vec3 {
    let Some(parent) = bone.parent() else {
        return Vec3::ZERO;
    };
    let bound = skeleton.joint(bone) - skeleton.joint(parent);
    manner.file_from_world * (raised[parent.index()] * bound) * manner.units_per_meter
}

fn write_joint(
    text: &mut String,
    order: &mut Vec<Bone>,
    with: (&Skeleton, &Manner, &[Quat]),
    bone: Bone,
    depth: usize,
) {
    let (skeleton, manner, raised) = with;
    let indent = "\t".repeat(depth);
    let kind = if depth == 0 { "ROOT" } else { "JOINT" };
    let [x, y, z] = offset(skeleton, manner, raised, bone).to_array();
    let axes = match manner.order {
        EulerRot::XYZ => "Xrotation Yrotation Zrotation",
        _ => "Zrotation Yrotation Xrotation",
    };
    let channels = if depth == 0 || manner.six_channels {
        format!("6 Xposition Yposition Zposition {axes}")
    } else {
        format!("3 {axes}")
    };
    let name = (manner.name)(bone);
    write!(
        text,
        "{indent}{kind} {name}\n{indent}{{\n{indent}\tOFFSET {x} {y} {z}\n{indent}\tCHANNELS {channels}\n"
    )
    .expect("a string takes any text");
    order.push(bone);
    let children = Bone::ALL
        .iter()
        .filter(|child| child.parent() == Some(bone));
    let mut is_end = true;
    for &child in children {
        is_end = false;
        write_joint(text, order, with, child, depth + 1);
    }
    if is_end {
        let tip = manner.file_from_world * Vec3::new(0.0, 0.0, 0.03) * manner.units_per_meter;
        let [x, y, z] = tip.to_array();
        write!(
            text,
            "{indent}\tEnd Site\n{indent}\t{{\n{indent}\t\tOFFSET {x} {y} {z}\n{indent}\t}}\n"
        )
        .expect("a string takes any text");
    }
    writeln!(text, "{indent}}}").expect("a string takes any text");
}

fn numbers(skeleton: &Skeleton, pose: &Pose, with: (&Manner, &[Quat], &[Bone])) -> Vec<String> {
    let (manner, raised, order) = with;
    let mut turns = vec![Quat::IDENTITY; Bone::COUNT];
    for &bone in Bone::ALL {
        let parent = bone
            .parent()
            .map_or(Quat::IDENTITY, |parent| turns[parent.index()]);
        turns[bone.index()] = parent * pose.rotation(bone);
    }
    let file = manner.file_from_world;
    // Turns from the file's rest pose, in the file's axes.
    let from_rest =
        |bone: Bone| file * turns[bone.index()] * raised[bone.index()].inverse() * file.inverse();
    let mut numbers = Vec::new();
    for &bone in order {
        let place = if bone == Bone::Hips {
            file * (skeleton.joint(bone) + pose.hips_translation) * manner.units_per_meter
        } else {
            offset(skeleton, manner, raised, bone)
        };
        if bone == Bone::Hips || manner.six_channels {
            numbers.extend(place.to_array().map(|value| value.to_string()));
        }
        let parent = bone.parent().map_or(Quat::IDENTITY, from_rest);
        let (a, b, c) = (parent.inverse() * from_rest(bone)).to_euler(manner.order);
        numbers.extend([a, b, c].map(|angle| angle.to_degrees().to_string()));
    }
    numbers
}
