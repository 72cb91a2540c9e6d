//! Any patterns, masks, clips and filters that use each other are a picture, or one sentence, in bounded time.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_fuzz::drawing;
use lole_print::Picture;

fuzz_target!(|bytes: &[u8]| {
    let text = drawing::text(&mut Unstructured::new(bytes));
    lole_fuzz::show(text.as_bytes());
    match Picture::read(text.as_bytes()) {
        Ok(picture) => assert_eq!(
            picture.pixels.len(),
            4 * picture.width as usize * picture.height as usize
        ),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
});
