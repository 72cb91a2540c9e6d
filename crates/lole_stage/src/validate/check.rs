//! One figure of a protocol held against what it should be.

/// One figure held against its reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Which case of the protocol, such as `Γ = 8`.
    pub case: String,
    /// The figure.
    pub measured: f64,
    /// What it should be.
    pub reference: f64,
    /// What 100 % of error is: the reference, or where that is zero something of its size.
    pub scale: f64,
    /// Largest error that passes [%].
    pub gate_pct: f64,
    /// Unit, or nothing.
    pub unit: &'static str,
    /// Where the figure lies along the curve of its protocol.
    pub along: Option<f64>,
}

impl Check {
    /// A figure `[measured, reference]` whose error is a share of the reference.
    pub(super) fn new(
        case: impl Into<String>,
        [measured, reference]: [f64; 2],
        gate_pct: f64,
    ) -> Self {
        Self {
            case: case.into(),
            measured,
            reference,
            scale: reference,
            gate_pct,
            unit: "",
            along: None,
        }
    }

    /// A figure that should be zero and may be at most `bound` away from it.
    pub(super) fn vanishing(case: impl Into<String>, measured: f64, bound: f64) -> Self {
        Self {
            scale: bound,
            ..Self::new(case, [measured, 0.0], 100.0)
        }
    }

    /// A figure that passes from `low` to `high`.
    pub(super) fn within(case: impl Into<String>, measured: f64, [low, high]: [f64; 2]) -> Self {
        let middle = 0.5 * (low + high);
        let half = 0.5 * (high - low);
        Self::new(case, [measured, middle], 100.0 * half / middle)
    }

    /// The same in this unit.
    pub(super) fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// The same with this for 100 % of error.
    pub(super) fn scale(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// The same at this place of the protocol's curve.
    pub(super) fn along(self, along: f64) -> Self {
        Self {
            along: Some(along),
            ..self
        }
    }

    /// From where to where the figure passes, in its own unit.
    #[must_use]
    pub fn bounds(&self) -> [f64; 2] {
        let gate = (0.01 * self.gate_pct * self.scale).abs();
        [self.reference - gate, self.reference + gate]
    }

    /// Error [%] of its scale; infinite where the figure is not a number.
    #[must_use]
    pub fn error_pct(&self) -> f64 {
        let error = 100.0 * (self.measured - self.reference) / self.scale;
        if error.is_finite() {
            error
        } else {
            f64::INFINITY
        }
    }

    /// Whether the error is within its gate.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.error_pct().abs() <= self.gate_pct
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_never_passes() {
        assert!(!Check::new("", [f64::NAN, 1.0], 100.0).passes());
        assert!(!Check::vanishing("", f64::INFINITY, 1.0).passes());
    }

    #[test]
    fn a_gate_has_two_sides() {
        for (measured, passes) in [(0.98, true), (1.02, true), (0.96, false), (1.04, false)] {
            assert_eq!(Check::new("", [measured, 1.0], 3.0).passes(), passes);
        }
        for (measured, passes) in [(-0.9, true), (0.9, true), (1.1, false)] {
            assert_eq!(Check::vanishing("", measured, 1.0).passes(), passes);
        }
        assert_eq!(Check::within("", 5.0, [4.0, 8.0]).bounds(), [4.0, 8.0]);
        assert_eq!(Check::vanishing("", 0.0, 0.5).bounds(), [-0.5, 0.5]);
        for (measured, passes) in [(3.9, false), (4.1, true), (7.9, true), (8.1, false)] {
            assert_eq!(Check::within("", measured, [4.0, 8.0]).passes(), passes);
        }
    }
}
