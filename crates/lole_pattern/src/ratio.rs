//! Ratios with a rule: a value of these types is always one that can be sewn.

use crate::DraftError;

/// Flat length over finished length of a gathered edge. Finite, 1 to 5.
///
/// For a pāʻū skirt the finished length is the hip girth, because the cloth is bought by the
/// hip: 4 yards for a hip of 91 cm is a ratio of 4.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct GatherRatio(f64);

impl GatherRatio {
    /// The usual pāʻū skirt: four times the hips, 4 yards for most dancers.
    pub const PAU: Self = Self(4.0);
    /// Smallest ratio: no gathers.
    pub const MIN: f64 = 1.0;
    /// Largest ratio: 5 yards on a 91 cm hip; more does not fit under the elastic.
    pub const MAX: f64 = 5.0;

    /// Refuses anything that is not between [`Self::MIN`] and [`Self::MAX`].
    ///
    /// # Errors
    /// [`DraftError::GatherRatio`].
    pub fn new(ratio: f64) -> Result<Self, DraftError> {
        if (Self::MIN..=Self::MAX).contains(&ratio) {
            Ok(Self(ratio))
        } else {
            Err(DraftError::GatherRatio { ratio })
        }
    }

    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

/// Relaxed elastic over body girth where it is worn. Finite, 0.8 to 0.9.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct ElasticRatio(f64);

impl ElasticRatio {
    /// The middle of the range dressmakers use.
    pub const PAU: Self = Self(0.85);
    /// Tightest elastic that is comfortable, for heavy cloth.
    pub const MIN: f64 = 0.8;
    /// Loosest elastic that still carries a light skirt.
    pub const MAX: f64 = 0.9;

    /// Refuses anything that is not between [`Self::MIN`] and [`Self::MAX`].
    ///
    /// # Errors
    /// [`DraftError::ElasticRatio`].
    pub fn new(ratio: f64) -> Result<Self, DraftError> {
        if (Self::MIN..=Self::MAX).contains(&ratio) {
            Ok(Self(ratio))
        } else {
            Err(DraftError::ElasticRatio { ratio })
        }
    }

    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_ratios_that_can_be_sewn_exist() {
        for ratio in [1.0, 2.5, 4.0, 5.0] {
            assert!(GatherRatio::new(ratio).is_ok());
        }
        for ratio in [0.999, 5.001, -4.0, f64::NAN, f64::INFINITY] {
            let sentence = GatherRatio::new(ratio).unwrap_err().to_string();
            assert!(sentence.contains("use 1"), "{sentence}");
        }
        for ratio in [0.8, 0.85, 0.9] {
            assert!(ElasticRatio::new(ratio).is_ok());
        }
        for ratio in [0.79, 0.91, 1.0, f64::NAN, f64::NEG_INFINITY] {
            let sentence = ElasticRatio::new(ratio).unwrap_err().to_string();
            assert!(sentence.contains("use 0.8"), "{sentence}");
        }
    }
}
