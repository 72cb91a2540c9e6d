//! Any bytes are a picture, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_print::Picture;

fuzz_target!(|bytes: &[u8]| match Picture::read(bytes) {
    Ok(picture) => assert_eq!(
        picture.pixels.len(),
        4 * picture.width as usize * picture.height as usize
    ),
    Err(error) => assert!(!error.to_string().contains('\n')),
});
