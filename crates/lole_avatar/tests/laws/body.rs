//! A body that was written as a file of another program is measured as it was, and dressed.

use glam::{Quat, Vec3};
use lole_avatar::{Avatar, AvatarError};
use lole_body::{Bone, Measure, Pose, Tape};

use crate::support::{Kind, Manner, asset, dancer, write_avatar};

/// What the tape reads on an avatar [cm].
fn taped(avatar: &Avatar, measure: Measure) -> f64 {
    let taped = avatar.dancer.taped(&Tape::default());
    let mut all = taped.iter();
    let found = all.find(|taped| taped.measure == measure);
    found.map_or(0.0, |taped| taped.on_body.to_cm())
}

#[test]
fn whatever_file_she_comes_in_she_is_the_dancer_who_was_written() {
    let backward = Quat::from_rotation_y(std::f32::consts::PI);
    let z_up = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
    for manner in [
        Manner {
            kind: Kind::Vrm1,
            ..Manner::default()
        },
        Manner {
            kind: Kind::Vrm0,
            file_from_world: backward,
            ..Manner::default()
        },
        Manner {
            units_per_meter: 100.0,
            file_from_world: z_up,
            ..Manner::default()
        },
    ] {
        let avatar = Avatar::read(&write_avatar(&manner)).unwrap();
        let (read, written) = (&avatar.dancer, dancer());
        let shift = read.skeleton.joint(Bone::Hips) - written.skeleton.joint(Bone::Hips);
        assert!(shift.with_z(0.0).length() < 1e-3, "{shift}");
        for &bone in Bone::ALL {
            let off = read.skeleton.joint(bone) - written.skeleton.joint(bone) - shift;
            assert!(off.length() < 1e-3, "{bone:?} {off}");
        }
        for own in written.taped(&Tape::default()) {
            let (own, read) = (own.on_body.to_cm(), taped(&avatar, own.measure));
            // The levels are found by the flesh, not by the table that she was built from.
            assert!((read - own).abs() < 0.025 * own + 0.3, "{read} {own}");
        }
        // Hair and flower are no part of what a tape measures around the trunk.
        assert!(avatar.license.export_refusal().is_none());
    }
}

#[test]
fn the_tape_reads_what_avatars_were_made_to() {
    // Convex girths of the source meshes: MakeHuman's CC0 bodies of the Japanese means.
    let made: [(&str, &[(Measure, f64)]); 2] = [
        (
            "made_mh_jp_mean_f.vrm1.vrm",
            &[
                (Measure::Stature, 158.5),
                (Measure::Bust, 83.5),
                (Measure::Waist, 65.9),
                (Measure::Hip, 91.0),
                (Measure::HighHip, 79.2),
                (Measure::Thigh, 51.5),
                (Measure::Knee, 32.4),
                (Measure::Calf, 34.5),
                (Measure::Inseam, 71.6),
            ],
        ),
        (
            "made_mh_large_f.vrm0.vrm",
            &[
                (Measure::Stature, 163.7),
                (Measure::Bust, 108.9),
                (Measure::Waist, 86.8),
                (Measure::Hip, 108.5),
                (Measure::HighHip, 98.1),
                (Measure::Thigh, 63.3),
                (Measure::Inseam, 72.9),
            ],
        ),
    ];
    for (name, measures) in made {
        let Some(bytes) = asset(name) else { return };
        let avatar = Avatar::read(&bytes).unwrap();
        for &(measure, centimeters) in measures {
            let read = taped(&avatar, measure);
            // Raised arms widen the chest, and lowering them does not bring all of it back.
            let close = match measure {
                Measure::Bust => 0.025 * centimeters,
                _ => 0.5,
            };
            let off = (read - centimeters).abs();
            assert!(off < close, "{name} {measure:?} {read}");
        }
    }
}

#[test]
fn thirteen_capsules_stand_for_bodies_of_persons() {
    for name in ["made_mh_jp_mean_f.vrm1.vrm", "made_mh_jp_mean_m.apose.glb"] {
        let Some(bytes) = asset(name) else { return };
        let dancer = Avatar::read(&bytes).unwrap().dancer;
        assert_eq!(dancer.capsules.len(), 13);
        let coverage = dancer.capsule_coverage();
        assert!(
            coverage.close > 0.75 && coverage.outside < 0.05,
            "{name} {coverage:?}"
        );
    }
}

#[test]
fn stylized_bodies_are_measured_and_posed() {
    for name in ["cryptovoxels.vrm", "CesiumMan.glb"] {
        let Some(bytes) = asset(name) else { return };
        let dancer = Avatar::read(&bytes).unwrap().dancer;
        let levels = &dancer.landmarks;
        assert!(levels.crotch_height < levels.hip_joint_height);
        assert!(levels.asis_height < levels.waist_height);
        assert!(levels.waist_height < levels.bust_height);
        let mut pose = Pose::default();
        pose.rotate(Bone::LeftUpperArm, Quat::from_rotation_z(-0.5));
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world_from_bind = dancer.skeleton.world_from_bind(&pose);
        dancer
            .skin
            .pose(&world_from_bind, &mut positions, &mut normals);
        assert!(
            positions
                .iter()
                .chain(&normals)
                .all(|value| value.is_finite())
        );
        let sums = dancer
            .skin
            .weights
            .iter()
            .map(|weights| weights.iter().sum::<f32>());
        assert!(sums.into_iter().all(|sum| (sum - 1.0).abs() < 1e-4));
        let ring = dancer.tape_ring(levels.asis_height, 64);
        assert_eq!(ring.len(), 64);
    }
}

#[test]
fn missing_fingers_lie_before_the_wrist() {
    let Some(bytes) = asset("CesiumMan.glb") else {
        return;
    };
    let skeleton = Avatar::read(&bytes).unwrap().dancer.skeleton;
    for (elbow, wrist, finger) in [
        (Bone::LeftLowerArm, Bone::LeftHand, Bone::LeftMiddleProximal),
        (
            Bone::RightLowerArm,
            Bone::RightHand,
            Bone::RightMiddleProximal,
        ),
    ] {
        let forearm = skeleton.joint(wrist) - skeleton.joint(elbow);
        let hand = skeleton.joint(finger) - skeleton.joint(wrist);
        assert!(forearm.dot(hand) > 0.8 * forearm.length() * hand.length());
        assert!((0.1..0.9).contains(&(hand.length() / forearm.length())));
        assert_ne!(hand, Vec3::ZERO);
    }
}

#[test]
fn a_ball_cannot_be_dressed() {
    let Some(bytes) = asset("s06_sphere_in.vrm") else {
        return;
    };
    let error = Avatar::read(&bytes).unwrap_err();
    assert!(matches!(error, AvatarError::Body(_)));
    assert!(
        error
            .to_string()
            .starts_with("the avatar cannot be dressed: its ankles")
    );
}

#[test]
fn a_dance_alone_is_no_avatar() {
    let Some(bytes) = asset("three-vrm_test.vrma") else {
        return;
    };
    assert_eq!(Avatar::read(&bytes), Err(AvatarError::NoMesh));
}
