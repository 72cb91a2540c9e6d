//! A dance written by one program and danced again is the same dance, on her own body and others.

use glam::{EulerRot, Quat, Vec3};
use lole_body::{Bone, Dancer, Measurements, Pose, Tape};
use lole_geom::Length;
use lole_hula::{DanceStep, MotionSettings};
use lole_motion::{
    BoneMap, Clip, ClipSettings, Drift, MapSource, Recording, RecordingInspection, Repeat, bvh,
};

use super::support::{Manner, dancer, joint, steps, write_bvh};

fn danced(recording: &Recording, settings: ClipSettings) -> Clip {
    let map = BoneMap::recognize(recording).expect("a person");
    Clip::retarget(recording, &map, &dancer().skeleton, settings).expect("can be danced")
}

fn recording(poses: &[Pose], manner: &Manner) -> Recording {
    let text = write_bvh(&dancer().skeleton, poses, manner);
    bvh::parse(text.as_bytes()).expect("the text is sound")
}

/// Farthest that a joint of `danced` lies from that of `poses` [m], after the same start.
fn apart(danced: &[Pose], poses: &[Pose], bones: &[Bone]) -> f32 {
    let skeleton = &dancer().skeleton;
    let start = |pose: &Pose| {
        let [left, right] =
            [Bone::LeftUpperLeg, Bone::RightUpperLeg].map(|bone| joint(skeleton, pose, bone));
        (0.5 * (left + right)).with_y(0.0)
    };
    let shift = start(&danced[0]) - start(&poses[0]);
    let pairs = danced.iter().zip(poses);
    let apart = pairs.flat_map(|(danced, pose)| {
        bones.iter().map(move |&bone| {
            let place = joint(skeleton, pose, bone) + shift;
            joint(skeleton, danced, bone).distance(place)
        })
    });
    apart.fold(0.0, f32::max)
}

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

/// Hula that starts facing the front, whatever its step.
fn ami() -> Vec<Pose> {
    let settings = MotionSettings {
        dance_step: DanceStep::Ami,
        ..MotionSettings::default()
    };
    let mut poses = steps(&settings, 150);
    // The recording is turned to where the hips face at first; let that be the front.
    let facing = poses[0].rotation(Bone::Hips) * Vec3::X;
    let yaw = lole_geom::trig::atan2(-facing.z, facing.x);
    let back = Quat::from_rotation_y(-yaw);
    for pose in &mut poses {
        pose.rotate(Bone::Hips, back * pose.rotation(Bone::Hips));
        let hips = dancer().skeleton.joint(Bone::Hips);
        pose.hips_translation = back * (pose.hips_translation + hips) - hips;
    }
    poses
}

#[test]
fn a_dance_comes_back_whatever_axes_units_channels_and_rest_pose_it_was_written_in() {
    let poses = ami();
    let z_up = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
    for (what, manner) in [
        ("plain", Manner::default()),
        (
            "centimeters",
            Manner {
                units_per_meter: 100.0,
                ..Manner::default()
            },
        ),
        (
            "z up",
            Manner {
                file_from_world: z_up,
                ..Manner::default()
            },
        ),
        (
            "facing aside",
            Manner {
                file_from_world: Quat::from_rotation_y(1.3),
                units_per_meter: 17.7,
                ..Manner::default()
            },
        ),
        (
            "six channels",
            Manner {
                six_channels: true,
                order: EulerRot::XYZ,
                ..Manner::default()
            },
        ),
        (
            "T-pose",
            Manner {
                arms_raised: 0.7,
                ..Manner::default()
            },
        ),
        (
            "arms down",
            Manner {
                arms_raised: -0.5,
                ..Manner::default()
            },
        ),
    ] {
        let recording = recording(&poses, &manner);
        let clip = danced(&recording, ClipSettings::default());
        assert_eq!(clip.poses().len(), poses.len());
        let apart = apart(clip.poses(), &poses, &LIMBS);
        assert!(apart < 0.006, "{what}: {apart}");
    }
}

#[test]
fn joints_are_found_by_the_names_of_many_programs() {
    let poses = &ami()[..3];
    type Namer = fn(Bone) -> String;
    let cases: [(&str, Namer); 6] = [
        ("VRM, Unity", |bone| bone.name().to_owned()),
        ("3ds Max Biped", |bone| biped(bone)),
        ("MotionBuilder, Mixamo, CMU", |bone| mixamo(bone)),
        ("VRChat", |bone| vr_chat(bone)),
        ("MakeHuman", |bone| make_human(bone)),
        ("MikuMikuDance", |bone| miku_miku_dance(bone)),
    ];
    let plain = BoneMap::recognize(&recording(poses, &Manner::default())).unwrap();
    for (program, name) in cases {
        let recording = recording(
            poses,
            &Manner {
                name,
                ..Manner::default()
            },
        );
        let map = BoneMap::recognize(&recording).unwrap();
        assert_eq!(map.source, MapSource::Names(program));
        for bone in LIMBS {
            assert_eq!(map.joint(bone), plain.joint(bone), "{program} {bone:?}");
        }
        assert_eq!((map.spine(), map.neck()), (plain.spine(), plain.neck()));
    }
}

/// `LeftUpperLeg` in the words of a program: those of each part of a limb.
fn told(bone: Bone, parts: [&str; 8], side: impl Fn(&str, &str) -> String) -> String {
    const OURS: [&str; 8] = [
        "Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toes",
    ];
    let name = bone.name();
    let split = ["left", "right"]
        .into_iter()
        .find_map(|side| Some((side, name.strip_prefix(side)?)));
    let known = split.and_then(|(which, part)| {
        let place = OURS.iter().position(|ours| *ours == part)?;
        Some(side(which, parts[place]))
    });
    known.unwrap_or_else(|| side("", name))
}

fn biped(bone: Bone) -> String {
    let parts = [
        "Clavicle", "UpperArm", "Forearm", "Hand", "Thigh", "Calf", "Foot", "Toe0",
    ];
    match bone {
        Bone::Hips => "Bip01 Pelvis".to_owned(),
        _ => told(bone, parts, |side, part| {
            let side = side
                .chars()
                .next()
                .map(|letter| format!("{} ", letter.to_ascii_uppercase()));
            format!("Bip01 {}{part}", side.unwrap_or_default())
        }),
    }
}

fn vr_chat(bone: Bone) -> String {
    let parts = [
        "shoulder", "arm", "elbow", "wrist", "leg", "knee", "ankle", "toe",
    ];
    told(bone, parts, |side, part| match side {
        "left" => format!("Left {part}"),
        "right" => format!("Right {part}"),
        _ => part.to_owned(),
    })
}

fn make_human(bone: Bone) -> String {
    let parts = [
        "clavicle",
        "upperarm01",
        "lowerarm01",
        "wrist",
        "upperleg01",
        "lowerleg01",
        "foot",
        "toe1-1",
    ];
    match bone {
        Bone::Hips => "root".to_owned(),
        _ => told(bone, parts, |side, part| match side {
            "left" => format!("{part}.L"),
            "right" => format!("{part}.R"),
            _ => part.to_owned(),
        }),
    }
}

fn miku_miku_dance(bone: Bone) -> String {
    let parts = ["肩", "腕", "ひじ", "手首", "足", "ひざ", "足首", "つま先"];
    match bone {
        Bone::Hips => "センター".to_owned(),
        Bone::Head => "頭".to_owned(),
        _ => told(bone, parts, |side, part| match side {
            "left" => format!("左{part}"),
            "right" => format!("右{part}"),
            _ => part.to_owned(),
        }),
    }
}

fn mixamo(bone: Bone) -> String {
    let parts = [
        "Shoulder", "Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot", "ToeBase",
    ];
    told(bone, parts, |side, part| format!("mixamorig:{side}{part}"))
}

#[test]
fn joints_without_telling_names_are_found_by_how_they_hang_together() {
    let poses = &ami()[..3];
    let named = BoneMap::recognize(&recording(poses, &Manner::default())).unwrap();
    for file_from_world in [
        Quat::IDENTITY,
        Quat::from_rotation_x(1.5),
        Quat::from_rotation_y(2.0),
    ] {
        let manner = Manner {
            name: |bone| format!("b{}", 7 * bone.index() % 61),
            file_from_world,
            ..Manner::default()
        };
        let map = BoneMap::recognize(&recording(poses, &manner)).unwrap();
        assert_eq!(map.source, MapSource::Hierarchy);
        for bone in LIMBS.into_iter().chain([
            Bone::Hips,
            Bone::LeftUpperArm,
            Bone::RightUpperLeg,
            Bone::LeftShoulder,
            Bone::RightToes,
        ]) {
            assert_eq!(map.joint(bone), named.joint(bone), "{bone:?}");
        }
    }
}

#[test]
fn a_list_says_what_names_do_not() {
    let poses = &ami()[..3];
    let manner = Manner {
        name: |bone| match bone {
            Bone::LeftHand => "hook".to_owned(),
            _ => bone.name().to_owned(),
        },
        ..Manner::default()
    };
    let recording = recording(poses, &manner);
    let map = BoneMap::from_list(&recording, "# one\nhook = leftHand # instead\n").unwrap();
    let hook = recording
        .joints
        .iter()
        .position(|joint| joint.name == "hook");
    assert_eq!(map.joint(Bone::LeftHand), hook);
    let said = |list: &str| {
        BoneMap::from_list(&recording, list)
            .unwrap_err()
            .to_string()
    };
    assert!(
        said("\nhoof = leftHand")
            .starts_with("line 2 of the bone list: the recording has no joint")
    );
    assert!(said("hook = leftFin").starts_with("line 1 of the bone list: there is no bone"));
    assert!(said("").starts_with("no joint was recognized for leftHand"));
}

#[test]
fn feet_that_slide_a_little_where_they_stand_are_held_still() {
    // A stance whose recording sways as a whole, as a badly tracked one does: 2 cm, twice in 3 s.
    let stance = ami().remove(0);
    let sway = |pose: usize| lole_geom::trig::sin(std::f32::consts::TAU * pose as f32 / 90.0);
    let poses: Vec<Pose> = (0..180)
        .map(|index| {
            let mut pose = stance.clone();
            pose.hips_translation += Vec3::new(0.02 * sway(index), 0.0, 0.01 * sway(index + 20));
            pose
        })
        .collect();
    let clip = danced(
        &recording(&poses, &Manner::default()),
        ClipSettings::default(),
    );
    let skeleton = &dancer().skeleton;
    let places = |bone: Bone| {
        let poses = clip.poses().iter();
        poses.map(move |pose| joint(skeleton, pose, bone))
    };
    let width = |bone: Bone| {
        let xs = places(bone).map(|place| place.x);
        let (low, high) = xs.fold((f32::MAX, f32::MIN), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    assert!(width(Bone::Hips) > 0.038, "the body sways on");
    for ball in [Bone::LeftToes, Bone::RightToes] {
        assert!(width(ball) < 1e-3, "{ball:?} slides {}", width(ball));
    }
}

#[test]
fn soles_stand_on_the_floor_and_never_below_on_other_bodies() {
    let poses = steps(&MotionSettings::default(), 360);
    let recording = recording(&poses, &Manner::default());
    let map = BoneMap::recognize(&recording).unwrap();
    for centimeters in [146.0, 178.0] {
        let tape = Tape {
            stature: Some(Length::from_cm(centimeters)),
            ..Tape::default()
        };
        let other = Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap();
        let clip =
            Clip::retarget(&recording, &map, &other.skeleton, ClipSettings::default()).unwrap();
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        for pose in clip.poses().iter().step_by(20) {
            let world_from_bind = other.skeleton.world_from_bind(pose);
            other
                .skin
                .pose(&world_from_bind, &mut positions, &mut normals);
            let heights = positions.iter().map(|place| place.y);
            let lowest = heights.fold(f32::INFINITY, f32::min);
            assert!(lowest.abs() < 0.012, "{centimeters} cm: {lowest}");
        }
    }
}

#[test]
fn a_loop_is_a_whole_number_of_rounds_and_closes() {
    let settings = MotionSettings::default();
    let poses = steps(&settings, 700);
    let recording = recording(&poses, &Manner::default());
    let looped = ClipSettings {
        repeat: Repeat::Loop,
        ..ClipSettings::default()
    };
    let clip = danced(&recording, looped);
    let round = settings.dance_step.counts() as f32 * 60.0 / settings.beats_per_minute;
    let rounds = clip.duration() / round;
    assert!((rounds - rounds.round()).abs() * round < 0.06, "{rounds}");
    let skeleton = &dancer().skeleton;
    let (first, last) = (&clip.poses()[0], &clip.poses()[clip.poses().len() - 1]);
    for bone in LIMBS {
        let leap = joint(skeleton, first, bone).distance(joint(skeleton, last, bone));
        assert!(leap < 0.03, "{bone:?} {leap}");
    }
    // Later rounds are the same as the first.
    let [one, two] = [2.0, 2.0 + 3.0 * clip.duration()].map(|time| clip.pose_at(time));
    assert!((one.hips_translation - two.hips_translation).length() < 1e-4);
}

#[test]
fn a_drift_that_is_removed_ends_where_it_began() {
    let mut poses = ami();
    let count = poses.len() as f32;
    for (index, pose) in poses.iter_mut().enumerate() {
        pose.hips_translation += Vec3::new(0.3, 0.0, 2.0) * (index as f32 / count);
    }
    let recording = recording(&poses, &Manner::default());
    let way = |drift: Drift| {
        let clip = danced(
            &recording,
            ClipSettings {
                drift,
                ..ClipSettings::default()
            },
        );
        let [first, .., last] = clip.poses() else {
            unreachable!()
        };
        (last.hips_translation - first.hips_translation)
            .with_y(0.0)
            .length()
    };
    assert!(way(Drift::Keep) > 1.9);
    assert!(way(Drift::Remove) < 1e-4);
}

#[test]
fn poses_are_eased_in_and_stay_at_the_end() {
    let poses = ami();
    let recording = recording(&poses, &Manner::default());
    let clip = danced(&recording, ClipSettings::default());
    assert_eq!(clip.pose_at(f32::NAN), clip.poses()[0]);
    let speed = |time: f32| {
        let [a, b] = [time, time + 0.01].map(|time| clip.pose_at(time));
        joint(&dancer().skeleton, &a, Bone::Hips).distance(joint(
            &dancer().skeleton,
            &b,
            Bone::Hips,
        ))
    };
    assert!(speed(0.0) < 0.1 * speed(1.0));
    assert!(speed(clip.duration() + 1.0) < 1e-6);
}

#[test]
fn an_inspection_tells_unit_axes_and_joints() {
    let manner = Manner {
        units_per_meter: 100.0,
        file_from_world: Quat::from_rotation_x(std::f32::consts::FRAC_PI_2),
        name: |bone| match bone {
            Bone::LeftRingDistal => "jewel".to_owned(),
            _ => bone.name().to_owned(),
        },
        six_channels: true,
        ..Manner::default()
    };
    let inspection = RecordingInspection::new("BVH", &recording(&ami(), &manner), None);
    let person = inspection.person.unwrap();
    assert_eq!(
        (person.unit, person.up, person.front),
        (Some("cm"), "+Z", "-Y")
    );
    assert_eq!(person.missing, ["leftRingDistal"]);
    assert_eq!(inspection.unrecognized, ["jewel"]);
    assert_eq!(inspection.six_channel_joint_count, inspection.joint_count);
    assert!((inspection.frames_per_second - 60.0).abs() < 1e-3);
}

/// A recording of the CMU database (subject 1, trial 1: jumps forward, then turns around), where
/// the folder that `LOLE_ASSETS` names holds it.
#[test]
#[expect(clippy::print_stderr, reason = "says why nothing was tested")]
fn a_recorded_jump_leaves_the_floor_and_comes_back() {
    let bytes = std::env::var("LOLE_ASSETS")
        .map_err(|error| error.to_string())
        .and_then(|folder| {
            let path = std::path::Path::new(&folder).join("cmu_01_01.bvh");
            std::fs::read(path).map_err(|error| error.to_string())
        });
    let bytes = match bytes {
        Ok(bytes) => bytes,
        Err(error) => {
            eprintln!("skipped: LOLE_ASSETS names no folder with cmu_01_01.bvh ({error})");
            return;
        }
    };
    let recording = bvh::parse(&bytes).unwrap();
    assert!(recording.begins_with_a_stance());
    let clip = danced(&recording, ClipSettings::default());
    let skeleton = &dancer().skeleton;
    let height = |pose: &Pose, bone| joint(skeleton, pose, bone).y;
    let lowest: Vec<f32> = clip
        .poses()
        .iter()
        .map(|pose| height(pose, Bone::LeftToes).min(height(pose, Bone::RightToes)))
        .collect();
    let standing = skeleton.joint(Bone::LeftToes).y;
    let low = lowest.iter().copied().fold(f32::INFINITY, f32::min);
    let high = lowest.iter().copied().fold(0.0, f32::max);
    assert!((low - standing).abs() < 0.02, "{low} {standing}");
    assert!(high > 0.15, "she jumps {high}");
    for pose in clip.poses() {
        // Knees bend forward and never twist round.
        for bone in [Bone::LeftLowerLeg, Bone::RightLowerLeg] {
            let shank = pose.rotation(bone) * Vec3::Z;
            assert!(shank.z > -0.9 && shank.x.abs() < 0.7, "{bone:?} {shank}");
        }
    }
}
