//! Dancers whom pictures of bodies are drawn of.

use std::error::Error;

use lole_body::{Appearance, Dancer, Figure, HairStyle, Measurements};
use lole_costume::document::{DancerDesign, Design};

/// Stature, bust, waist and hip [cm], as far as they are given.
pub(crate) type Measures = [Option<f64>; 4];

/// All four of them.
pub(crate) const fn all(cm: [f64; 4]) -> Measures {
    [Some(cm[0]), Some(cm[1]), Some(cm[2]), Some(cm[3])]
}

/// A dancer of these measures; `change` may change how she looks.
pub(crate) fn dancer(
    figure: Figure,
    [stature_cm, bust_cm, waist_cm, hip_cm]: Measures,
    (hair, change): (HairStyle, impl FnOnce(&mut Appearance)),
) -> Result<Dancer, Box<dyn Error>> {
    let design = Design {
        dancer: DancerDesign {
            figure,
            stature_cm,
            bust_cm,
            waist_cm,
            hip_cm,
            hair,
            ..DancerDesign::default()
        },
        ..Design::default()
    };
    let mut appearance = design.appearance();
    change(&mut appearance);
    let measurements = Measurements::from_tape(&design.tape())?;
    Ok(Dancer::with_appearance(&measurements, &appearance)?)
}
