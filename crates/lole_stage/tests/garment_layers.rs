//! Laws of what covers itself: turns, flaps, fronts and tucks of everything that is put on.

use lole_costume::document::parse;
use lole_stage::{Performance, Production};

/// Frames of the dance, and from one look to the next.
const FRAMES: usize = 60;
const INTERVAL: usize = 15;

fn performance(template: &str) -> Performance {
    let text = format!(
        "lole = 1\n[skirt]\nworn = \"no\"\n[motion]\nstep = \"kaholo\"\n[[garment]]\nkind = \"{template}\"\n"
    );
    let design = parse(&text, "garment").expect("a design");
    Performance::new(Production::new(&design).expect("a garment")).expect("a dance")
}

/// All but the holokū, of whose sleeve one fold at the armpit changes sides.
#[test]
fn what_lies_outside_stays_outside_through_a_dance() {
    for template in ["malo", "kikepa", "kihei", "blouse", "muumuu"] {
        let mut performance = performance(template);
        while performance.time() < 0.0 {
            performance.advance().expect("cloth");
        }
        performance.pose_body();
        let layers = performance.dressed_layers(0);
        for frame in 1..=FRAMES {
            performance.advance().expect("cloth");
            if frame.is_multiple_of(INTERVAL) {
                performance.pose_body();
                let inversions = performance.dressed_inversions(0, &layers);
                assert_eq!(inversions, 0, "{template}, frame {frame}");
            }
        }
    }
}
