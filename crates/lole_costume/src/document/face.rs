//! What a design says of the dancer's face.

use lole_body::{Face, Feature};

/// What makes her face unlike others.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FaceDesign {
    /// Chance that gives each feature that is not chosen; 0 is the measured face.
    pub seed: u64,
    /// Features that are chosen, at their places in [`Feature::ALL`], each from −1 (least) to 1 (most).
    pub features: [Option<f64>; Feature::COUNT],
}

impl FaceDesign {
    /// The face: that of the seed, with what is chosen.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "shares of one")]
    pub fn face(&self) -> Face {
        let chosen = Feature::ALL.into_iter().zip(self.features);
        chosen.fold(Face::of_seed(self.seed), |face, (feature, value)| {
            value.map_or(face, |value| face.with(feature, value as f32))
        })
    }

    /// Whether nothing was said of her face, so that she may be given one of her own among others.
    #[must_use]
    pub fn is_unchosen(&self) -> bool {
        *self == Self::default()
    }
}
