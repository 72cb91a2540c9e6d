//! Any bytes are a song no longer than its file, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_export::video::Song;

fuzz_target!(|bytes: &[u8]| match Song::read(bytes) {
    Ok(song) => assert!(song.seconds().is_finite()),
    Err(error) => assert!(!error.to_string().contains('\n')),
});
