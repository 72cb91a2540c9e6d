//! Any bytes are a pattern of another program whose places are finite, or one sentence; and measures of a body,
//! or one sentence.

#![no_main]

use kurbo::ParamCurve as _;
use libfuzzer_sys::fuzz_target;
use lole_exchange::{PatternInspection, flat, garmentcode, measures};

fuzz_target!(|bytes: &[u8]| {
    match garmentcode::read(bytes) {
        Ok(given) => {
            let pieces = given.pattern.pieces.iter();
            let segments = pieces
                .flat_map(|piece| &piece.edges)
                .flat_map(|edge| &edge.segments);
            assert!(
                segments
                    .into_iter()
                    .all(|segment| segment.eval(0.5).is_finite())
            );
            let sides = given
                .pattern
                .seams
                .iter()
                .flat_map(|seam| [seam.flat, seam.full]);
            for side in sides {
                assert!(side.edge < given.pattern.pieces[side.piece].edges.len());
            }
            assert!(!flat::svg(&given).contains("NaN"));
            drop(PatternInspection::new(&given).lines());
        }
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
    match measures::read(bytes) {
        Ok(body) => assert!(body.measures.iter().all(|taken| taken.cm.is_finite())),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
});
