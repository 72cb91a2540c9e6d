//! What is read of a BVH file, and what is said of a broken one.

use glam::{Quat, Vec3};
use lole_hula::MotionSettings;
use lole_language::Bilingual as _;
use lole_motion::{RecordingError, bvh};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

use super::support::{Manner, dancer, steps, write_bvh};

/// An arm of two bones along X, with `channels` and `numbers` of its second joint.
fn arm(channels: &str, numbers: &str) -> String {
    format!(
        "HIERARCHY\nROOT a\n{{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n\
         JOINT b\n{{\nOFFSET 1 0 0\nCHANNELS {channels}\nEnd Site\n{{\nOFFSET 1 0 0\n}}\n}}\n}}\n\
         MOTION\nFrames: 1\nFrame Time: 0.01\n0 0 0 {numbers}\n"
    )
}

fn tip(text: &str) -> Vec3 {
    let recording = bvh::parse(text.as_bytes()).expect("the text is sound");
    recording.places(0)[2].position
}

#[test]
fn rotations_are_applied_in_the_order_of_the_channels_the_first_outermost() {
    // A tip along X: turned about Z to Y first, then about X to Z; the other way round it only
    // comes to Y.
    let outer_x = tip(&arm("3 Xrotation Zrotation Yrotation", "90 90 0"));
    assert!(
        (outer_x - Vec3::new(1.0, 0.0, 1.0)).length() < 1e-6,
        "{outer_x}"
    );
    let outer_z = tip(&arm("3 Zrotation Xrotation Yrotation", "90 90 0"));
    assert!(
        (outer_z - Vec3::new(1.0, 1.0, 0.0)).length() < 1e-6,
        "{outer_z}"
    );
}

#[test]
fn positions_may_replace_the_offset_or_add_to_it() {
    let six = "6 Xrotation Xposition Zrotation Yposition Yrotation Zposition";
    assert_eq!(tip(&arm(six, "0 1.1 0 0.2 0 0")), Vec3::new(2.1, 0.2, 0.0));
    assert_eq!(tip(&arm(six, "0 0.1 0 0.2 0 0")), Vec3::new(2.1, 0.2, 0.0));
}

#[test]
fn line_ends_tabs_comments_and_case_change_nothing() {
    let text = arm("3 Xrotation Zrotation Yrotation", "10 20 30");
    let plain = bvh::parse(text.as_bytes()).unwrap();
    for other in [
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        text.replace(' ', " \t "),
        text.replace('\n', "  # said aside\n\n// and again\n"),
        text.replace("\n{", " {").replace("Xrotation", "XROTATION"),
        text.replace("MOTION", "motion")
            .replace("Frames: 1", "Frames:1"),
        text.replace("0 0 0 10", "0 0\n0 10"),
        format!("\u{feff}{text}"),
    ] {
        assert_eq!(bvh::parse(other.as_bytes()).unwrap(), plain, "{other}");
    }
}

#[test]
fn names_may_hold_spaces_and_be_in_any_encoding() {
    let text =
        arm("3 Xrotation Zrotation Yrotation", "0 0 0").replace("JOINT b", "JOINT Bip01 L Thigh");
    let recording = bvh::parse(text.as_bytes()).unwrap();
    assert_eq!(recording.joints[1].name, "Bip01 L Thigh");
    // 左 in Shift-JIS.
    let mut bytes = text.replace("Thigh", "@").into_bytes();
    let at = bytes.iter().position(|&byte| byte == b'@').unwrap();
    bytes.splice(at..=at, [0x8d, 0xb6]);
    assert_eq!(bvh::parse(&bytes).unwrap().joints.len(), 3);
}

#[test]
fn each_mistake_is_said_with_its_line_in_both_languages() {
    let text = arm("3 Xrotation Zrotation Yrotation", "1 2 3");
    let two = text.replace("Frames: 1", "Frames: 2");
    for (broken, english) in [
        (
            String::new(),
            "line 1: the file ends here; HIERARCHY should follow",
        ),
        ("{\"asset\":1}".to_owned(), "line 1: this is no BVH file"),
        (
            two,
            "line 19: the file ends after 1 of 2 frames and 0 numbers, and a frame has 6",
        ),
        (
            text.replace(" 3\n", "\n"),
            "line 19: the file ends after 0 of 1 frames and 5 numbers",
        ),
        (
            text.replace(" 3\n", " 3 4\n"),
            "line 19: more numbers follow than the 1 frames take",
        ),
        (
            text.replace(" 3\n", " nan\n"),
            "line 19: nan is too large or no finite number",
        ),
        (
            text.replace(" 3\n", " 1e30\n"),
            "line 19: 1e30 is too large",
        ),
        (
            text.replace(" 3\n", " x\n"),
            "line 19: \"x\" is not a number",
        ),
        (
            text.replace("OFFSET 1 0 0\nCH", "OFFSET 1 0\nCH"),
            "line 8: OFFSET takes three numbers, and here are 2",
        ),
        (
            text.replace("3 Xrot", "4 Xrot"),
            "line 9: the number after CHANNELS",
        ),
        (
            text.replace("Zrotation", "Wrotation"),
            "line 9: there is no channel \"Wrotation\"",
        ),
        (
            text.replace("Zrotation", "Xrotation"),
            "line 9: a channel of this joint stands there twice",
        ),
        (
            text.replace("JOINT b\n{", "JOINT b"),
            "line 7: a { is missing before this",
        ),
        (
            text.replacen("}\n", "", 1),
            "line 15: \"MOTION\" cannot stand here",
        ),
        (
            text.replace("}\nMOTION", "}\n}\nMOTION"),
            "line 16: this } closes nothing",
        ),
        (text.replace("0.01", "0"), "line 18: the Frame Time is 0 s"),
        (
            text.replace("Frames: 1", "Frames: many"),
            "line 17: Frames takes a whole number",
        ),
    ] {
        let error = bvh::parse(broken.as_bytes()).unwrap_err();
        assert!(
            error.to_string().starts_with(english),
            "{error} / {english}"
        );
        let kana = |letter: char| ('ぁ'..='ヿ').contains(&letter);
        assert!(error.japanese().contains(kana), "{}", error.japanese());
    }
}

#[test]
fn what_is_larger_than_any_dance_is_refused_before_room_is_made() {
    let text = arm("3 Xrotation Zrotation Yrotation", "1 2 3");
    let long = text.replace("Frames: 1", "Frames: 99999999999");
    assert!(matches!(
        bvh::parse(long.as_bytes()),
        Err(RecordingError::TooLarge {
            what: "numbers",
            ..
        })
    ));
    let deep = format!("HIERARCHY\nROOT a\n{{\n{}", "JOINT b\n{\n".repeat(1000));
    assert!(matches!(
        bvh::parse(deep.as_bytes()),
        Err(RecordingError::TooLarge {
            what: "levels of joints",
            ..
        })
    ));
    let wide = format!("HIERARCHY\nROOT a\n{{\n{}", "JOINT b\n{\n}\n".repeat(5000));
    assert!(matches!(
        bvh::parse(wide.as_bytes()),
        Err(RecordingError::TooLarge { what: "joints", .. })
    ));
}

/// A small file that uses all of the grammar.
fn seed_text() -> &'static str {
    static TEXT: std::sync::LazyLock<String> = std::sync::LazyLock::new(|| {
        let poses = steps(&MotionSettings::default(), 2);
        write_bvh(&dancer().skeleton, &poses, &Manner::default())
    });
    &TEXT
}

proptest! {
    #![proptest_config(Config {
        cases: 400,
        rng_seed: RngSeed::Fixed(7),
        failure_persistence: None,
        ..Config::default()
    })]

    /// Whatever is cut off, put in or overwritten: an answer comes, and what is read is finite.
    #[test]
    fn broken_files_are_refused_or_read_as_finite_motion(
        cut in 0_usize..30_000,
        edits in prop::collection::vec(
            (0_usize..30_000, prop::sample::select(vec![
                "{", "}", "\n", "-", "1e9", "nan", "inf", "JOINT x", "End Site", "CHANNELS 6 ",
                "OFFSET", "MOTION\n", "Frames: 0", "9", ".", "\0", "é", " ",
            ]), 0_usize..40),
            0..6,
        ),
    ) {
        let mut bytes = seed_text().as_bytes().to_vec();
        for (at, word, replaced) in edits {
            let at = at % bytes.len();
            let end = (at + replaced).min(bytes.len());
            bytes.splice(at..end, word.bytes());
        }
        if cut % 3 == 0 {
            bytes.truncate(cut);
        }
        if let Ok(recording) = bvh::parse(&bytes) {
            let finite = recording.translations.iter().all(|place| place.is_finite());
            prop_assert!(finite && recording.rotations.iter().all(|turn| turn.is_finite()));
            if let Ok(map) = lole_motion::BoneMap::recognize(&recording) {
                let skeleton = &dancer().skeleton;
                let settings = lole_motion::ClipSettings::default();
                if let Ok(clip) = lole_motion::Clip::retarget(&recording, &map, skeleton, settings) {
                    let finite = |turn: &Quat| turn.is_finite();
                    prop_assert!(clip.poses().iter().all(|pose| pose.rotations.iter().all(finite)));
                }
            }
        }
    }
}
