//! Any bytes are a list of dancers whose problems name their lines, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_fuzz::checks;

fuzz_target!(|bytes: &[u8]| checks::list(bytes));
