//! Any keys with any values are a design that reads back, or one sentence with a line.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_costume::document::{parse, to_toml};
use lole_fuzz::design::{self, Which};

fuzz_target!(|bytes: &[u8]| {
    let text = design::text(&mut Unstructured::new(bytes), Which::Any);
    lole_fuzz::show(text.as_bytes());
    match parse(&text, "fuzz.lole") {
        Ok(design) => assert_eq!(
            parse(&to_toml(&design), "again.lole").as_ref(),
            Ok(&design),
            "{text}"
        ),
        Err(error) => {
            assert!(error.line.is_some(), "{text}");
            assert!(!error.to_string().contains('\n'));
        }
    }
});
