//! Whatever is done to a file: one sentence, or something finite.

use base64::Engine as _;
use lole_avatar::{Avatar, AvatarError, AvatarInspection, read_dance};
use lole_body::Pose;
use lole_language::Bilingual as _;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use serde_json::{Value, json};

use crate::support::{Kind, Manner, dancer, glb, write_avatar, write_dance};

/// A sound dance.
fn seed() -> &'static [u8] {
    static SEED: std::sync::LazyLock<Vec<u8>> = std::sync::LazyLock::new(|| {
        let poses = [Pose::default(), Pose::default(), Pose::default()];
        let manner = Manner {
            kind: Kind::Vrm1,
            ..Manner::default()
        };
        write_dance(&dancer().skeleton, &poses, &manner)
    });
    &SEED
}

/// A sound avatar.
fn avatar_seed() -> &'static [u8] {
    static SEED: std::sync::LazyLock<Vec<u8>> =
        std::sync::LazyLock::new(|| write_avatar(&Manner::default()));
    &SEED
}

/// The text and the bytes of the seed.
fn parts() -> (Value, &'static [u8]) {
    parts_of(seed())
}

fn parts_of(seed: &'static [u8]) -> (Value, &'static [u8]) {
    let length = u32::from_le_bytes(seed[12..16].try_into().expect("four bytes")) as usize;
    let text = serde_json::from_slice(&seed[20..20 + length]).expect("what was written");
    (text, &seed[28 + length..])
}

fn with_text(change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let (mut text, bytes) = parts();
    change(&mut text);
    glb(&text.to_string(), bytes)
}

fn said(bytes: &[u8]) -> String {
    let error = read_dance(bytes).expect_err("the file is broken");
    assert!(!error.to_string().contains('\n'));
    let kana = |letter: char| ('ぁ'..='ヿ').contains(&letter);
    assert!(error.japanese().contains(kana), "{}", error.japanese());
    error.to_string()
}

#[test]
fn each_mistake_is_said_with_its_place_in_both_languages() {
    for (bytes, english) in [
        (seed()[..40].to_vec(), "the file is cut off: a chunk of "),
        (b"glTF\x01\0\0\0".to_vec(), "the GLB has version 1"),
        (glb("{", &[]), "the glTF text is broken: EOF"),
        (
            with_text(|text| text["accessors"][1]["count"] = json!(1_000_000)),
            "accessors[1]: it reaches beyond its bufferView",
        ),
        (
            with_text(|text| text["bufferViews"][2]["byteOffset"] = json!(u64::MAX)),
            "bufferViews[2]: it reaches beyond",
        ),
        (
            with_text(|text| text["nodes"][3]["children"] = json!([0])),
            "nodes: nodes hang on each other in a ring",
        ),
        (
            with_text(|text| text["nodes"][3]["children"] = json!([7777])),
            "nodes[3].children: there is no nodes[7777]",
        ),
        (
            with_text(|text| text["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
            "the file needs the extension KHR_draco_mesh_compression",
        ),
        (
            with_text(|text| text["buffers"][0]["uri"] = json!("dance.bin")),
            "buffers[0] lies in another file, dance.bin",
        ),
        (
            with_text(|text| {
                text["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"]["hips"]["node"] =
                    json!(999);
            }),
            "extensions.VRMC_vrm.humanoid: the node of hips is not there",
        ),
        (
            with_text(|text| {
                let bones = &mut text["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"];
                bones.as_object_mut().unwrap().remove("leftLowerLeg");
            }),
            "no person: no joint was recognized for leftLowerLeg",
        ),
        (
            with_text(|text| text["animations"] = json!([])),
            "the file has no animation",
        ),
        (
            with_text(|text| text["animations"][0]["samplers"][0]["output"] = json!(0)),
            "accessors[0]: its elements have 1 numbers, and 4 are needed",
        ),
    ] {
        let said = said(&bytes);
        assert!(said.starts_with(english), "{said} / {english}");
    }
    assert_eq!(
        AvatarInspection::new(b"PK\x03\x04", None),
        Err(AvatarError::UnknownFormat)
    );
}

/// What a text's value is replaced by.
fn strange() -> impl Strategy<Value = Value> {
    prop::sample::select(vec![
        json!(null),
        json!(-1),
        json!(0),
        json!(1),
        json!(5),
        json!(4_294_967_295_u32),
        json!(1e30),
        json!(1e-30),
        json!(""),
        json!("x"),
        json!([]),
        json!({}),
        json!([0, 0, 0]),
        json!([1e38, 1e38, 1e38]),
        json!(true),
    ])
}

/// Puts `value` at the `place`-th value of a text, depth first.
fn replace(text: &mut Value, place: &mut usize, value: &Value) -> bool {
    if *place == 0 {
        text.clone_from(value);
        return true;
    }
    *place -= 1;
    match text {
        Value::Array(list) => list.iter_mut().any(|part| replace(part, place, value)),
        Value::Object(table) => table.values_mut().any(|part| replace(part, place, value)),
        _ => false,
    }
}

proptest! {
    #![proptest_config(Config {
        cases: 600,
        rng_seed: RngSeed::Fixed(11),
        failure_persistence: None,
        ..Config::default()
    })]

    #[test]
    fn broken_files_are_refused_or_read_as_finite_motion(
        edits in prop::collection::vec((0_usize..4000, strange()), 0..4),
        flips in prop::collection::vec((0_usize..100_000, 0_u8..=255), 0..8),
        cut in 0_usize..200_000,
    ) {
        let (mut text, data) = parts();
        for (place, value) in &edits {
            replace(&mut text, &mut place.clone(), value);
        }
        let mut bytes = glb(&text.to_string(), data);
        for (at, byte) in flips {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        if cut % 5 == 0 {
            bytes.truncate(cut);
        }
        if let Ok(found) = AvatarInspection::new(&bytes, None) {
            for line in found.lines() {
                prop_assert!(!line.english.contains('\n'));
            }
        }
        if let Ok(read) = read_dance(&bytes) {
            let recording = &read.recording;
            prop_assert!(recording.translations.iter().all(|place| place.is_finite()));
            prop_assert!(recording.rotations.iter().all(|turn| turn.is_finite()));
        }
    }
}

proptest! {
    #![proptest_config(Config {
        cases: 48,
        rng_seed: RngSeed::Fixed(13),
        failure_persistence: None,
        ..Config::default()
    })]

    #[test]
    fn broken_avatars_are_refused_or_finite(
        edits in prop::collection::vec((0_usize..2400, strange()), 1..4),
        flips in prop::collection::vec((0_usize..1_000_000, 0_u8..=255), 0..40),
    ) {
        let (mut text, data) = parts_of(avatar_seed());
        for (place, value) in &edits {
            replace(&mut text, &mut place.clone(), value);
        }
        let mut data = data.to_vec();
        for (at, byte) in flips {
            let at = at % data.len();
            data[at] = byte;
        }
        match Avatar::read(&glb(&text.to_string(), &data)) {
            Ok(avatar) => {
                let skin = &avatar.dancer.skin;
                let places = skin.positions.iter().chain(&avatar.dancer.skeleton.joints);
                prop_assert!(places.chain(&skin.normals).all(|place| place.is_finite()));
            }
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }
}

/// Pictures that are small in a file and would take a gigabyte are counted before any is read.
#[test]
fn pictures_of_too_many_pixels_are_refused_before_they_are_read() {
    let mut png = std::io::Cursor::new(Vec::new());
    image::GrayImage::new(8192, 8192)
        .write_to(&mut png, image::ImageFormat::Png)
        .expect("a picture");
    let text = base64::engine::general_purpose::STANDARD.encode(png.into_inner());
    let uri = format!("data:image/png;base64,{text}");
    let with_pictures = |count: usize| {
        let (mut text, bytes) = parts_of(avatar_seed());
        let shown = |number: usize| json!({ "pbrMetallicRoughness": { "baseColorTexture": { "index": number } } });
        text["images"] = json!(vec![json!({ "uri": uri }); count]);
        let textures: Vec<Value> = (0..count).map(|it| json!({ "source": it })).collect();
        text["textures"] = Value::Array(textures);
        text["materials"] = Value::Array((0..count).map(shown).collect());
        let primitives = &mut text["meshes"][0]["primitives"];
        let first = primitives[0].clone();
        let shows = |number: usize| {
            let mut primitive = first.clone();
            primitive["material"] = json!(number);
            primitive
        };
        *primitives = Value::Array((0..count).map(shows).collect());
        Avatar::read(&glb(&text.to_string(), bytes))
    };
    let Err(AvatarError::TooLarge { count, .. }) = with_pictures(5) else {
        panic!("five of them are too many");
    };
    assert_eq!(count, 5 * 8192 * 8192);
    let is_too_large = matches!(with_pictures(1), Err(AvatarError::TooLarge { .. }));
    assert!(!is_too_large, "one of them is not");
}
