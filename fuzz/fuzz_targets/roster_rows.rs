//! Titles and rows of a spreadsheet are a list of dancers, or one sentence.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_fuzz::{checks, list};

fuzz_target!(|bytes: &[u8]| {
    let file = list::file(&mut Unstructured::new(bytes));
    lole_fuzz::show(file.as_ref());
    checks::list(file.as_ref());
});
