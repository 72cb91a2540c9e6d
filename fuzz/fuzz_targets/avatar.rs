//! Any bytes are an avatar or a dance of finite numbers, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_avatar::{Avatar, AvatarInspection, read_dance};

fuzz_target!(|bytes: &[u8]| {
    match AvatarInspection::new(bytes, None) {
        Ok(found) => assert!(
            found
                .lines()
                .iter()
                .all(|line| !line.english.contains('\n'))
        ),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
    if let Ok(read) = read_dance(bytes) {
        assert!(
            read.recording
                .translations
                .iter()
                .all(|place| place.is_finite())
        );
        assert!(read.recording.rotations.iter().all(|turn| turn.is_finite()));
    }
    if let Ok(avatar) = Avatar::read(bytes) {
        let skin = &avatar.dancer.skin;
        assert!(
            skin.positions
                .iter()
                .chain(&skin.normals)
                .all(|place| place.is_finite())
        );
    }
});
