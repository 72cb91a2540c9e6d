//! Any header and any frames are a take of finite places, or an error.

#![no_main]

use std::io::Cursor;

use libfuzzer_sys::fuzz_target;
use lole_export::take::record::{RecordedTake, TakeHeader};
use lole_export::take::{TakeScene, TakeSource as _};

/// Frames in a second and in all, vertices of each mesh, and what stands behind the header.
type Given = (u32, u32, Vec<usize>, Vec<u8>);

fuzz_target!(|given: Given| {
    let (frame_rate, frame_count, counts, frames) = given;
    let named = |(index, count): (usize, &usize)| (format!("mesh {index}"), *count);
    let header = TakeHeader {
        lole: "0".into(),
        frame_rate,
        frame_count,
        design: String::new(),
        files_hash: 0,
        meshes: counts.iter().enumerate().map(named).collect(),
    };
    let Ok(mut bytes) = header.bytes() else {
        return;
    };
    bytes.extend(&frames);
    let Ok(take) = RecordedTake::open(Cursor::new(bytes)) else {
        return;
    };
    let whole = take.whole_count();
    let mut staged = take.with_scene(TakeScene::default());
    for frame in 0..whole.min(8) {
        for mesh in 0..counts.len().min(8) {
            if let Ok([positions, _]) = staged.vertices(frame, mesh) {
                assert!(positions.iter().all(|it| it.is_finite()));
            }
        }
        drop(staged.pose(frame));
    }
});
