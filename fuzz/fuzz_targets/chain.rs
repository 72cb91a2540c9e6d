//! Any design of the range of its keys is drafted, sewn and danced for a second in finite numbers, or refused in a
//! sentence at one of these.

#![no_main]

use arbitrary::Unstructured;
use libfuzzer_sys::fuzz_target;
use lole_costume::document::parse;
use lole_fuzz::design::{self, Which};
use lole_garment::dress::Division;
use lole_stage::{FRAMES_PER_SECOND, Performance, Production};

fuzz_target!(|bytes: &[u8]| {
    let text = design::text(&mut Unstructured::new(bytes), Which::Danced);
    lole_fuzz::show(text.as_bytes());
    let Ok(design) = parse(&text, "fuzz.lole") else {
        return;
    };
    let performance = Production::divided(&design, Division::Half).and_then(Performance::new);
    let mut performance = match performance {
        Ok(performance) => performance,
        Err(error) => {
            assert!(!error.to_string().contains('\n'), "{text}");
            return;
        }
    };
    for _ in 0..FRAMES_PER_SECOND {
        // What comes apart is said, with what to change; a picture of no numbers is not.
        if performance.advance().is_err() {
            return;
        }
        let mut places = performance.cloth_positions().iter();
        assert!(places.all(|place| place.is_finite()), "{text}");
    }
});
