//! Any bytes are a song no longer than its file, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_fuzz::checks;

fuzz_target!(|bytes: &[u8]| checks::song(bytes));
