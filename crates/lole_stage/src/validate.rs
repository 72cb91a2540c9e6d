//! The engine against closed forms: protocols with measured, reference, error and gate.
//!
//! A protocol is one file, one row of [`PROTOCOLS`]. It runs for every method that claims it; a
//! method's gate is what it promises, and its limits say what keeps it from more.

mod banded;
mod beam;
mod cantilever;
mod capstan;
mod catenary;
mod chain;
mod check;
mod column;
mod convergence;
mod creep;
mod drape;
mod elastica;
mod equilibrium;
mod fabric_drape;
mod hanging_strip;
mod incline;
mod lateral;
mod momentum;
mod pendulum;
mod protocols;
mod residual;
mod rig;
mod skirt_weight;
mod stick_slip;
mod waistband;
mod wave;

use lole_cloth::BuildError;
use lole_language::Words;

pub use check::Check;
pub use protocols::PROTOCOLS;
pub use rig::Subject;

/// One protocol.
pub struct Protocol {
    /// Name for programs and for `--only`.
    pub name: &'static str,
    /// What is compared with what.
    pub about: Words,
    /// The methods that it is for.
    pub subjects: &'static [Subject],
    /// What keeps a method from more than its gate.
    pub limits: &'static [(Subject, Words)],
    /// The curve on which its figures should lie, if there is one.
    pub curve: Option<Curve>,
    run: fn(Subject) -> Result<Vec<Check>, BuildError>,
}

/// A curve that is known.
pub struct Curve {
    /// What is along the axis below.
    pub along: Words,
    /// What is upward.
    pub value: Words,
    points: fn() -> Vec<[f64; 2]>,
}

impl Curve {
    /// Points of it, ascending along the axis.
    #[must_use]
    pub fn points(&self) -> Vec<[f64; 2]> {
        (self.points)()
    }
}

impl Protocol {
    /// Runs it for one method.
    ///
    /// # Errors
    /// A cloth that cannot be built: a mistake of the protocol.
    pub fn run(&self, subject: Subject) -> Result<Vec<Check>, BuildError> {
        (self.run)(subject)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_all_pass(subject: Subject) {
        let claimed = |protocol: &&Protocol| protocol.subjects.contains(&subject);
        for protocol in PROTOCOLS.iter().filter(claimed) {
            let checks = protocol.run(subject).unwrap();
            assert!(!checks.is_empty(), "{}", protocol.name);
            for check in checks {
                let name = format!("{} {}", protocol.name, subject.id());
                assert!(check.passes(), "{name}: {check:?} {}", check.error_pct());
            }
        }
    }

    #[test]
    fn every_protocol_claims_a_method() {
        for protocol in PROTOCOLS {
            assert!(!protocol.subjects.is_empty(), "{}", protocol.name);
        }
    }

    #[test]
    fn the_reference_passes_its_gates() {
        assert_all_pass(Subject::FbEuler);
    }

    #[test]
    fn the_real_time_method_passes_its_gates() {
        assert_all_pass(Subject::Xpbd);
    }

    #[test]
    fn curves_ascend_and_are_finite() {
        for curve in PROTOCOLS
            .iter()
            .filter_map(|protocol| protocol.curve.as_ref())
        {
            let points = curve.points();
            assert!(1 < points.len(), "{}", curve.value.english);
            for pair in points.windows(2) {
                assert!(pair[0][0] < pair[1][0], "{}: {pair:?}", curve.value.english);
            }
            assert!(points.iter().flatten().all(|value| value.is_finite()));
        }
    }
}
