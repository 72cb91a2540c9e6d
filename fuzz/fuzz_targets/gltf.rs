//! Any parts that name each other are an avatar or a dance of finite numbers, or one sentence.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_avatar::{Avatar, AvatarInspection, read_dance};
use lole_fuzz::gltf;

fuzz_target!(|bytes: &[u8]| {
    let file = gltf::glb(&mut Unstructured::new(bytes));
    lole_fuzz::show(&file);
    if let Err(error) = AvatarInspection::new(&file, None) {
        assert!(!error.to_string().contains('\n'));
    }
    if let Ok(read) = read_dance(&file) {
        assert!(
            read.recording
                .translations
                .iter()
                .all(|place| place.is_finite())
        );
        assert!(read.recording.rotations.iter().all(|turn| turn.is_finite()));
    }
    match Avatar::read(&file) {
        Ok(avatar) => {
            let skin = &avatar.dancer.skin;
            let places = skin.positions.iter().chain(&skin.normals);
            assert!(places.into_iter().all(|place| place.is_finite()));
        }
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
});
