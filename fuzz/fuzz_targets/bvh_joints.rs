//! Joints of a person, now and then wrong, are a recording whose dance is finite, or one sentence.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_fuzz::{checks, recording};

fuzz_target!(|bytes: &[u8]| {
    let file = recording::text(&mut Unstructured::new(bytes));
    lole_fuzz::show(file.as_ref());
    checks::recording(file.as_ref());
});
