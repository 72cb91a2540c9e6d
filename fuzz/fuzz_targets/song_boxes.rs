//! Boxes of a song, now and then wrong, are a song no longer than its file, or one sentence.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_fuzz::{checks, song};

fuzz_target!(|bytes: &[u8]| {
    let file = song::file(&mut Unstructured::new(bytes));
    lole_fuzz::show(file.as_ref());
    checks::song(file.as_ref());
});
