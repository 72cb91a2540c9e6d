//! A dance that was written as a file of another program is the same dance when it is read.

use glam::{Quat, Vec3};
use lole_avatar::{AvatarError, read_dance};
use lole_body::{Bone, Dancer, Measurements, Pose, Tape};
use lole_geom::Length;
use lole_hula::{Dance, MotionSettings};
use lole_motion::{Clip, ClipSettings};

use crate::support::{Kind, Manner, asset, dancer, write_dance};

const QUARTER: f32 = std::f32::consts::FRAC_PI_2;

/// Bones whose joints are compared.
const LIMBS: [Bone; 9] = [
    Bone::Head,
    Bone::LeftHand,
    Bone::RightHand,
    Bone::LeftLowerArm,
    Bone::RightLowerArm,
    Bone::LeftLowerLeg,
    Bone::RightLowerLeg,
    Bone::LeftFoot,
    Bone::RightFoot,
];

/// Hula that starts facing the front, as a recording is turned.
fn steps(count: usize) -> Vec<Pose> {
    let skeleton = &dancer().skeleton;
    let dance = Dance::new(skeleton, &MotionSettings::default()).expect("it can be danced");
    let mut poses: Vec<Pose> = (0..count)
        .map(|pose| dance.pose_at(dance.lead_in() + pose as f32 / 60.0))
        .collect();
    let facing = poses[0].rotation(Bone::Hips) * Vec3::X;
    let back = Quat::from_rotation_y(-lole_geom::trig::atan2(-facing.z, facing.x));
    for pose in &mut poses {
        pose.rotate(Bone::Hips, back * pose.rotation(Bone::Hips));
        let hips = skeleton.joint(Bone::Hips);
        pose.hips_translation = back * (pose.hips_translation + hips) - hips;
    }
    poses
}

fn danced(bytes: &[u8]) -> Clip {
    let read = read_dance(bytes).expect("a dance");
    let skeleton = &dancer().skeleton;
    Clip::retarget(
        &read.recording,
        &read.map,
        skeleton,
        ClipSettings::default(),
    )
    .expect("it can be danced")
}

fn joint(pose: &Pose, bone: Bone) -> Vec3 {
    let skeleton = &dancer().skeleton;
    skeleton.world_from_bind(pose)[bone.index()].transform_point3(skeleton.joint(bone))
}

#[test]
fn every_kind_of_file_gives_back_the_dance_that_was_written() {
    let poses = steps(120);
    let backward = Quat::from_rotation_y(2.0 * QUARTER);
    let manners = [
        Manner {
            kind: Kind::Vrma,
            ..Manner::default()
        },
        // The axes of the nodes are turned at rest, as three-vrm's test file has them.
        Manner {
            kind: Kind::Vrma,
            axes: Quat::from_xyzw(0.5, 0.5, -0.5, 0.5),
            ..Manner::default()
        },
        Manner {
            kind: Kind::Vrm0,
            file_from_world: backward,
            ..Manner::default()
        },
        // Centimeters, Z up, names alone.
        Manner {
            units_per_meter: 100.0,
            file_from_world: Quat::from_rotation_x(QUARTER),
            ..Manner::default()
        },
    ];
    for manner in &manners {
        let clip = danced(&write_dance(&dancer().skeleton, &poses, manner));
        assert_eq!(clip.poses().len(), poses.len());
        let middle = |pose: &Pose| {
            let hips = [Bone::LeftUpperLeg, Bone::RightUpperLeg].map(|bone| joint(pose, bone));
            0.5 * (hips[0] + hips[1])
        };
        let start = (middle(&poses[0]) - middle(&clip.poses()[0])).with_y(0.0);
        for (frame, (pose, wanted)) in clip.poses().iter().zip(&poses).enumerate().step_by(7) {
            for bone in LIMBS {
                let off = joint(pose, bone) + start - joint(wanted, bone);
                assert!(
                    off.length() < 0.006,
                    "{manner:?} frame {frame} {bone:?} {off}"
                );
            }
        }
    }
}

#[test]
fn a_skeleton_alone_has_no_dance() {
    let bytes = write_dance(&dancer().skeleton, &steps(1), &Manner::default());
    assert_eq!(read_dance(&bytes), Err(AvatarError::NoAnimation));
}

#[test]
fn a_run_on_the_spot_leaves_the_floor_and_comes_back_on_other_bodies() {
    let Some(bytes) = asset("CesiumMan.glb") else {
        return;
    };
    let read = read_dance(&bytes).unwrap();
    assert!((read.recording.duration() - 2.0).abs() < 0.05);
    let tape = Tape {
        stature: Some(Length::from_cm(150.0)),
        ..Tape::default()
    };
    let other = Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap();
    let settings = ClipSettings::default();
    let clip = Clip::retarget(&read.recording, &read.map, &other.skeleton, settings).unwrap();
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    let mut strides = (f32::MAX, f32::MIN);
    let balls = [Bone::LeftToes, Bone::RightToes].map(|bone| read.map.joint(bone).unwrap());
    for (frame, pose) in clip.poses().iter().enumerate().step_by(5) {
        let world_from_bind = other.skeleton.world_from_bind(pose);
        (other.skin).pose(&world_from_bind, &mut positions, &mut normals);
        let heights = positions.iter().map(|place| place.y);
        let lowest = heights.fold(f32::INFINITY, f32::min);
        // He runs: where both feet are in the air, so are hers; his legs are 0.54 m long.
        let places = read.recording.places(frame);
        let recorded = balls.map(|ball| places[ball].position.y);
        let recorded = recorded[0].min(recorded[1]) * 0.68 / 0.54;
        let floor = -0.012..recorded + 0.06;
        assert!(floor.contains(&lowest), "{frame}: {lowest} {recorded}");
        let foot = world_from_bind[Bone::LeftFoot.index()]
            .transform_point3(other.skeleton.joint(Bone::LeftFoot));
        strides = (strides.0.min(foot.z), strides.1.max(foot.z));
    }
    assert!(strides.1 - strides.0 > 0.3, "he runs {strides:?}");
}

#[test]
fn a_dance_whose_rest_pose_is_turned_stands_upright() {
    let Some(bytes) = asset("three-vrm_test.vrma") else {
        return;
    };
    let clip = danced(&bytes);
    assert!((clip.duration() - 3.0).abs() < 0.05);
    for pose in clip.poses().iter().step_by(20) {
        let up = joint(pose, Bone::Head) - joint(pose, Bone::Hips);
        assert!(up.normalize_or_zero().y > 0.9, "{up}");
    }
}
