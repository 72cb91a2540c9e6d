//! Lengths as people write them, kept in meters.

/// A length, kept in meters. Finite by construction through [`Length::from_cm`] and its kin only
/// when the argument is finite: parsers check first.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Length(f64);

/// One international yard [m].
const YARD: f64 = 0.9144;

impl Length {
    /// Zero length.
    pub const ZERO: Self = Self(0.0);

    /// From meters.
    #[must_use]
    pub const fn from_m(meters: f64) -> Self {
        Self(meters)
    }

    /// From centimeters.
    #[must_use]
    pub const fn from_cm(centimeters: f64) -> Self {
        Self(centimeters * 0.01)
    }

    /// From international yards (0.9144 m).
    #[must_use]
    pub const fn from_yd(yards: f64) -> Self {
        Self(yards * YARD)
    }

    /// In meters.
    #[must_use]
    pub const fn to_m(self) -> f64 {
        self.0
    }

    /// In meters, in the engine's precision (7 digits: a hair's width in a kilometer).
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the engine computes in f32"
    )]
    pub const fn to_m_f32(self) -> f32 {
        self.0 as f32
    }

    /// In centimeters.
    #[must_use]
    pub const fn to_cm(self) -> f64 {
        self.0 * 100.0
    }

    /// In international yards (0.9144 m).
    #[must_use]
    pub const fn to_yd(self) -> f64 {
        self.0 / YARD
    }
}

impl std::ops::Add for Length {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl std::ops::Sub for Length {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl std::ops::Mul<f64> for Length {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_convert_back_and_forth() {
        assert!((Length::from_yd(4.0).to_cm() - 365.76).abs() < 1e-9);
        assert!((Length::from_cm(91.44).to_yd() - 1.0).abs() < 1e-12);
    }
}
