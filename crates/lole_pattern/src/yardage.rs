//! How much cloth to ask for in a shop.

use lole_geom::Length;

/// Shops in Japan cut by 10 cm.
const METRIC_UNIT: f64 = 0.1;

/// Shops in Hawaiʻi cut by half a yard.
const HALF_YARD: f64 = 0.5;

/// What a piece may fall short of before the next unit is bought [m]: its two seam allowances of 1 cm.
/// So a 91.4 cm hip buys 4 yd (365.8 cm) for a piece of 367.6 cm.
const GIVE: f64 = 0.02;

/// A length of cloth and what to buy for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yardage {
    /// Cloth the pieces need, along the selvage.
    pub needed: Length,
    /// Rounded up to 10 cm.
    pub metric: Length,
    /// Rounded up to half a yard.
    pub imperial: Length,
}

impl Yardage {
    /// Rounds up, except where the seam allowances can give the missing two centimeters.
    #[must_use]
    pub fn for_length(needed: Length) -> Self {
        let given = needed - Length::from_m(GIVE);
        Self {
            needed,
            metric: Length::from_m(units_covering(given.to_m(), METRIC_UNIT) * METRIC_UNIT),
            imperial: Length::from_yd(units_covering(given.to_yd(), HALF_YARD) * HALF_YARD),
        }
    }
}

/// How many whole units reach `length`; rounding noise of the division does not buy one more.
fn units_covering(length: f64, unit: f64) -> f64 {
    (length / unit - 1e-9).ceil().max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_centimeters_are_given_and_three_are_bought() {
        assert!((Yardage::for_length(Length::from_cm(362.0)).metric.to_cm() - 360.0).abs() < 1e-9);
        assert!((Yardage::for_length(Length::from_cm(363.0)).metric.to_cm() - 370.0).abs() < 1e-9);
        assert!((Yardage::for_length(Length::from_cm(367.6)).imperial.to_yd() - 4.0).abs() < 1e-9);
        assert!((Yardage::for_length(Length::from_cm(368.0)).imperial.to_yd() - 4.5).abs() < 1e-9);
    }

    #[test]
    fn nothing_needs_nothing() {
        assert!(Yardage::for_length(Length::ZERO).metric.to_cm().abs() < 1e-12);
    }
}
