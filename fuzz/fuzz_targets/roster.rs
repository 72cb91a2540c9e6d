//! Any bytes are a list of dancers whose problems name their lines, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_costume::roster;

fuzz_target!(|bytes: &[u8]| {
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
});
