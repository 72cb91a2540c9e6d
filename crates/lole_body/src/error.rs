//! What can go wrong when a dancer is built.

/// Why no dancer could be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyError {
    /// A measurement no dancer has.
    #[error(
        "{name} is {value_cm:.1} cm, but a dancer's lies between {least_cm:.1} and {most_cm:.1} cm; \
         measure again or correct the unit"
    )]
    OutOfBand {
        /// Name of the measurement.
        name: &'static str,
        /// What was given [cm].
        value_cm: f64,
        /// Lower end of the band [cm].
        least_cm: f64,
        /// Upper end of the band [cm].
        most_cm: f64,
    },
    /// The measurements do not go together: no closed body has them all.
    #[error("the measurements do not make one body: {reason}; check {check} against the others")]
    Unbuildable {
        /// What failed.
        reason: String,
        /// The measurement to check first.
        check: &'static str,
    },
    /// The built-in table of sections is damaged.
    #[error(
        "the table of body sections cannot be read ({reason}); restore data/body_sections.json"
    )]
    Sections {
        /// What the reader said.
        reason: String,
    },
}
