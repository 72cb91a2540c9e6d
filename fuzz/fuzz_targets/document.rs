//! Any bytes are a design that reads back, or one sentence with a line.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_costume::document::{parse, parse_bytes, to_toml};

fuzz_target!(|bytes: &[u8]| match parse_bytes(bytes, "fuzz.lole") {
    Ok(design) => assert_eq!(parse(&to_toml(&design), "again.lole").as_ref(), Ok(&design)),
    Err(error) => {
        assert!(error.line.is_some());
        assert!(!error.to_string().contains('\n'));
    }
});
