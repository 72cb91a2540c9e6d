//! The engine against closed forms: protocols with measured, reference, error and gate.
//!
//! A protocol is one file, one row of [`PROTOCOLS`]. It runs for every method that claims it; a
//! method's gate is what it promises, and its note says what keeps it from more.

mod beam;
mod cantilever;
mod catenary;
mod chain;
mod column;
mod hanging_strip;
mod lateral;
mod rig;

use lole_cloth::BuildError;

pub use rig::Subject;

/// One protocol.
pub struct Protocol {
    /// Name for programs and for `--only`.
    pub name: &'static str,
    /// What is compared with what, in English.
    pub about: &'static str,
    /// The same in Japanese.
    pub about_ja: &'static str,
    run: fn(Subject) -> Result<Vec<Check>, BuildError>,
}

/// One figure held against its reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Which case of the protocol, such as `Γ = 8`.
    pub case: String,
    /// The figure.
    pub measured: f64,
    /// What it should be.
    pub reference: f64,
    /// Largest error that passes [%].
    pub gate_pct: f64,
    /// Unit, or nothing.
    pub unit: &'static str,
}

impl Check {
    /// Relative error [%]; infinite where the figure is not a number.
    #[must_use]
    pub fn error_pct(&self) -> f64 {
        let error = 100.0 * (self.measured / self.reference - 1.0);
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

impl Protocol {
    /// Runs it for one method.
    ///
    /// # Errors
    /// A cloth that cannot be built: a mistake of the protocol.
    pub fn run(&self, subject: Subject) -> Result<Vec<Check>, BuildError> {
        (self.run)(subject)
    }
}

/// All protocols.
pub const PROTOCOLS: &[Protocol] = &[
    Protocol {
        name: "cantilever",
        about: "height over width of a clamped strip under its own weight, against the heavy elastica",
        about_ja: "片側を固定した布の垂れの縦横比（重い弾性線と比べる）",
        run: cantilever::run,
    },
    Protocol {
        name: "self-buckling",
        about: "the Γ at which an upright clamped strip falls over under its own weight",
        about_ja: "立てた布が自重で倒れはじめる Γ",
        run: column::run,
    },
    Protocol {
        name: "lateral-buckling",
        about: "the Γ at which a strip held on its narrow edge tips over sideways: bending and twist",
        about_ja: "細い縁で立てて片側を固定した布が横に倒れはじめる Γ（曲げとねじり）",
        run: lateral::run,
    },
    Protocol {
        name: "hanging-strip",
        about: "how far a hanging strip stretches, against the sum of the weights below each spring",
        about_ja: "吊るした布の伸び（各ばねの下の重さの和と比べる）",
        run: hanging_strip::run,
    },
    Protocol {
        name: "catenary",
        about: "sag of a strip held at both ends, against the catenary",
        about_ja: "両端を持った布のたるみ（懸垂線と比べる）",
        run: catenary::run,
    },
    Protocol {
        name: "chain-mode",
        about: "period of the slowest swing of a hanging strip, against the hanging chain",
        about_ja: "吊るした布のいちばん遅い揺れの周期（吊り鎖と比べる）",
        run: chain::run,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_passes_its_gates() {
        for protocol in PROTOCOLS {
            for subject in Subject::ALL {
                for check in protocol.run(subject).unwrap() {
                    let name = format!("{} {}", protocol.name, subject.id());
                    assert!(check.passes(), "{name}: {check:?} {}", check.error_pct());
                }
            }
        }
    }

    #[test]
    fn what_is_no_number_never_passes() {
        let check = Check {
            case: String::new(),
            measured: f64::NAN,
            reference: 1.0,
            gate_pct: 100.0,
            unit: "",
        };
        assert!(!check.passes());
    }
}
