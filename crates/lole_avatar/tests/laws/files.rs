//! What is seen in files of other programs.

use glam::Quat;
use lole_avatar::{AvatarInspection, Permission, RestPose};
use lole_body::Pose;

use crate::support::{Kind, Manner, asset, dancer, write_dance};

fn inspected(name: &str) -> Option<AvatarInspection> {
    Some(AvatarInspection::new(&asset(name)?, None).expect("the file is sound"))
}

#[test]
fn avatars_of_known_stature_are_as_high() {
    for (name, format, centimeters, front, pose) in [
        (
            "made_mh_jp_mean_f.vrm1.vrm",
            "VRM 1.0",
            158.5,
            "+Z",
            RestPose::T,
        ),
        (
            "made_mh_large_f.vrm0.vrm",
            "VRM 0.x",
            163.5,
            "-Z",
            RestPose::T,
        ),
        (
            "made_mh_jp_mean_m.apose.glb",
            "glTF 2.0",
            171.0,
            "+Z",
            RestPose::A,
        ),
    ] {
        let Some(found) = inspected(name) else { return };
        let (humanoid, meshes) = (found.humanoid.unwrap(), found.meshes.unwrap());
        assert_eq!(found.format, format);
        assert!(
            (100.0 * meshes.height_m - centimeters).abs() < 0.1,
            "{name}"
        );
        assert_eq!(
            (humanoid.up, humanoid.front, humanoid.pose),
            ("+Y", front, pose)
        );
        assert_eq!((meshes.vertex_count, meshes.triangle_count), (13380, 26756));
        assert!(
            humanoid.missing.is_empty(),
            "{name}: {:?}",
            humanoid.missing
        );
    }
}

#[test]
fn a_rig_without_names_is_recognized_by_how_it_hangs_together() {
    let Some(found) = inspected("CesiumMan.glb") else {
        return;
    };
    let humanoid = found.humanoid.unwrap();
    assert_eq!(humanoid.recognized_by, "hierarchy");
    let node = |bone: &str| {
        let mut bones = humanoid.bones.iter();
        bones
            .find(|(name, _)| *name == bone)
            .map(|(_, node)| node.as_str())
    };
    assert_eq!(node("leftUpperLeg"), Some("leg_joint_L_1"));
    assert_eq!(node("rightHand"), Some("Skeleton_arm_joint_R__3_"));
    assert_eq!(found.animations.len(), 1);
    assert_eq!(found.animations[0].bone_count, 19);
}

#[test]
fn a_fox_is_refused_in_one_sentence() {
    let Some(found) = inspected("Fox.glb") else {
        return;
    };
    assert!(found.humanoid.is_none());
    let [japanese, english] = found.refused.unwrap();
    assert!(
        english.starts_with("no person: the trunk lies"),
        "{english}"
    );
    assert!(japanese.contains("動物"), "{japanese}");
}

#[test]
fn a_mannequin_with_few_fingers_says_which_are_missing() {
    let Some(found) = inspected("cryptovoxels.vrm") else {
        return;
    };
    let humanoid = found.humanoid.unwrap();
    assert_eq!(humanoid.recognized_by, "VRM 0.x");
    assert!(humanoid.missing.contains(&"leftThumbDistal"));
    assert_eq!(found.license.authors, ["jin"]);
    // Its permissions stand in the query of an address.
    assert_eq!(found.license.modification, Permission::Allowed);
    assert_eq!(found.license.redistribution, Permission::Allowed);
}

#[test]
fn a_ball_with_bones_is_described() {
    let Some(found) = inspected("s06_sphere_in.vrm") else {
        return;
    };
    let meshes = found.meshes.unwrap();
    assert!((meshes.height_m - 1.0).abs() < 1e-3);
    assert!(found.body.is_none());
    let [_, english] = found.refused.unwrap();
    assert!(
        english.starts_with("the avatar cannot be dressed"),
        "{english}"
    );
    assert_eq!(found.license.fields.last().unwrap().1, "CC0");
}

#[test]
fn unit_front_and_bones_of_a_file_are_told() {
    let poses = [Pose::default(), Pose::default()];
    let manner = Manner {
        kind: Kind::Vrm0,
        file_from_world: Quat::from_rotation_y(std::f32::consts::PI),
        units_per_meter: 100.0,
        ..Manner::default()
    };
    let bytes = write_dance(&dancer().skeleton, &poses, &manner);
    let found = AvatarInspection::new(&bytes, None).unwrap();
    let humanoid = found.humanoid.unwrap();
    assert_eq!((humanoid.front, humanoid.unit), ("-Z", "cm"));
    assert_eq!((humanoid.pose, humanoid.missing.len()), (RestPose::A, 0));
    assert!(found.meshes.is_none());
}

#[test]
fn a_list_says_which_node_is_which_bone() {
    let poses = [Pose::default(), Pose::default()];
    let manner = Manner {
        name: |bone| format!("n{}", bone.index()),
        ..Manner::default()
    };
    let bytes = write_dance(&dancer().skeleton, &poses, &manner);
    let list: String = lole_body::Bone::ALL
        .iter()
        .map(|bone| format!("n{} = {}\n", bone.index(), bone.name()))
        .collect();
    let found = AvatarInspection::new(&bytes, Some(&list)).unwrap();
    let humanoid = found.humanoid.unwrap();
    assert_eq!(humanoid.recognized_by, "list");
    assert!(humanoid.missing.is_empty());
}
