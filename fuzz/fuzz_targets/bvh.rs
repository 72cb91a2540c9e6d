//! Any bytes are a recording whose dance is finite on any dancer, or one sentence.

#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use lole_body::{Dancer, Measurements};
use lole_motion::{BoneMap, Clip, ClipSettings, Drift, RecordingInspection, Repeat, bvh};

static WOMAN: LazyLock<Dancer> =
    LazyLock::new(|| Dancer::new(&Measurements::woman()).expect("the default dancer"));

fuzz_target!(|bytes: &[u8]| {
    let recording = match bvh::parse(bytes) {
        Ok(recording) => recording,
        Err(error) => {
            assert!(!error.to_string().contains('\n'));
            return;
        }
    };
    let lines = RecordingInspection::new("BVH", &recording, None).lines();
    assert!(lines.iter().all(|line| !line.english.contains('\n')));
    let Ok(map) = BoneMap::recognize(&recording) else {
        return;
    };
    for repeat in [Repeat::Once, Repeat::Loop] {
        let settings = ClipSettings {
            repeat,
            drift: Drift::Remove,
        };
        let Ok(clip) = Clip::retarget(&recording, &map, &WOMAN.skeleton, settings) else {
            continue;
        };
        for pose in clip.poses() {
            assert!(pose.hips_translation.is_finite());
            assert!(pose.rotations.iter().all(|turn| turn.is_finite()));
        }
    }
});
