//! How much cloth to ask for in a shop.

use lole_geom::Length;

/// Shops in Japan cut by 10 cm.
const METRIC_UNIT: f64 = 0.1;

/// Shops in Hawaiʻi cut by half a yard.
const HALF_YARD: f64 = 0.5;

/// What a gathered ring may fall short of before the next unit is bought [m]: its gathers do not show it.
/// So a 91.4 cm hip buys 4 yd (365.8 cm) for a piece of 367.6 cm.
const GIVE: f64 = 0.02;

/// Zips as shops have them [cm]; longer ones come by 10 cm. Invisible zips of 22 and 56 cm are found everywhere.
const ZIPS: [f64; 13] = [
    18.0, 20.0, 22.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 56.0, 60.0, 70.0, 80.0,
];

/// The shortest zip that is sold for an opening: what is too long is sewn across and cut off.
#[must_use]
pub fn sold_zip(opening: Length) -> Length {
    // Rounding noise asks for no longer one.
    let least = opening.to_cm() - 1.0e-6;
    let sold = ZIPS.into_iter().find(|zip| least <= *zip);
    Length::from_cm(sold.unwrap_or_else(|| (least / 10.0).ceil() * 10.0))
}

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
    /// Rounds up.
    #[must_use]
    pub fn for_length(needed: Length) -> Self {
        Self::covering(needed, needed)
    }

    /// For one rectangle that is closed to a ring and gathered: rounds up, except where it can do without
    /// the missing two centimeters. [`Self::missing`] says how much that is.
    #[must_use]
    pub fn for_gathered(needed: Length) -> Self {
        Self::covering(needed, needed - Length::from_m(GIVE))
    }

    fn covering(needed: Length, least: Length) -> Self {
        Self {
            needed,
            metric: Length::from_m(units_covering(least.to_m(), METRIC_UNIT) * METRIC_UNIT),
            imperial: Length::from_yd(units_covering(least.to_yd(), HALF_YARD) * HALF_YARD),
        }
    }

    /// What the bought cloth falls short of the needed length, by meters and by yards; zero where it
    /// does not.
    #[must_use]
    pub fn missing(&self) -> [Length; 2] {
        [self.metric, self.imperial].map(|bought| {
            let missing = self.needed - bought;
            // Rounding noise is nothing that anybody cuts.
            if missing < Length::from_cm(0.05) {
                Length::ZERO
            } else {
                missing
            }
        })
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
    fn a_zip_is_never_too_short_and_no_shorter_one_is_sold() {
        for millimeters in 50_u16..1300 {
            let opening = Length::from_cm(f64::from(millimeters) / 10.0);
            let sold = sold_zip(opening);
            assert!(opening <= sold, "{opening:?}");
            assert!((sold_zip(sold) - sold).to_m().abs() < 1e-12);
            let shorter = ZIPS.iter().rfind(|zip| **zip < sold.to_cm() - 1e-9);
            assert!(
                shorter.is_none_or(|zip| *zip < opening.to_cm()),
                "{opening:?}"
            );
            assert!(sold.to_cm() <= 80.0 || (sold - opening).to_cm() < 10.0);
        }
    }

    #[test]
    fn gathers_give_two_centimeters_and_three_are_bought() {
        let bought = |cm| Yardage::for_gathered(Length::from_cm(cm));
        assert!((bought(362.0).metric.to_cm() - 360.0).abs() < 1e-9);
        assert!((bought(363.0).metric.to_cm() - 370.0).abs() < 1e-9);
        assert!((bought(367.6).imperial.to_yd() - 4.0).abs() < 1e-9);
        assert!((bought(368.0).imperial.to_yd() - 4.5).abs() < 1e-9);
        let [metric, imperial] = bought(367.6).missing();
        assert!(metric == Length::ZERO && (imperial.to_cm() - 1.84).abs() < 1e-9);
    }

    #[test]
    fn all_else_is_bought_to_the_last_millimeter() {
        for cm in [311.8, 300.1, 362.0, 10.0] {
            let bought = Yardage::for_length(Length::from_cm(cm));
            assert!(cm <= bought.metric.to_cm() + 1e-6 && cm <= bought.imperial.to_cm() + 1e-6);
            assert_eq!(bought.missing(), [Length::ZERO; 2]);
        }
    }

    #[test]
    fn nothing_needs_nothing() {
        assert!(Yardage::for_length(Length::ZERO).metric.to_cm().abs() < 1e-12);
    }
}
