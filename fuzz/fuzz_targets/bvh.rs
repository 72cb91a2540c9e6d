//! Any bytes are a recording whose dance is finite on any dancer, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_fuzz::checks;

fuzz_target!(|bytes: &[u8]| checks::recording(bytes));
