//! What holds for everything that is read, whoever wrote it.

use std::sync::LazyLock;

use lole_body::{Dancer, Measurements};
use lole_costume::roster;
use lole_export::video::Song;
use lole_motion::{BoneMap, Clip, ClipSettings, Drift, RecordingInspection, Repeat, bvh};

static WOMAN: LazyLock<Dancer> =
    LazyLock::new(|| Dancer::new(&Measurements::woman()).expect("the default dancer"));

/// A recording whose dance is finite on any dancer, or one sentence.
pub fn recording(bytes: &[u8]) {
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
}

/// A list of dancers whose problems name their lines, or one sentence.
pub fn list(bytes: &[u8]) {
    match roster::read(bytes) {
        Ok(list) => {
            assert!(
                list.dancers
                    .iter()
                    .all(|dancer| dancer.hip_cm().is_finite())
            );
            assert!(list.problems.iter().all(|problem| 0 < problem.line));
        }
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
    // Names alone ask less of a file.
    drop(roster::names(bytes));
}

/// A song no longer than its file, or one sentence.
pub fn song(bytes: &[u8]) {
    match Song::read(bytes) {
        Ok(song) => assert!(song.seconds().is_finite()),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
}
