//! What can go wrong when a dancer is built.

use lole_language::{Bilingual, Sentence, Words};

/// Why no dancer could be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyError {
    /// A measurement no dancer has.
    #[error(
        "{} is {value_cm:.1} cm, but a dancer's lies between {least_cm:.1} and {most_cm:.1} cm; \
         measure again or correct the unit",
        name.english
    )]
    OutOfBand {
        /// Name of the measurement.
        name: Words,
        /// What was given [cm].
        value_cm: f64,
        /// Lower end of the band [cm].
        least_cm: f64,
        /// Upper end of the band [cm].
        most_cm: f64,
    },
    /// Two measurements that exclude each other.
    #[error(
        "{} {first_cm:.1} cm and {} {second_cm:.1} cm exclude each other: beside the second, the \
         first lies between {least_cm:.1} and {most_cm:.1} cm; measure both again",
        first.english, second.english
    )]
    Conflict {
        /// Name of one.
        first: Words,
        /// What it is [cm].
        first_cm: f64,
        /// Name of the other.
        second: Words,
        /// What it is [cm].
        second_cm: f64,
        /// Least that the first can be beside the second [cm].
        least_cm: f64,
        /// Most that the first can be beside the second [cm].
        most_cm: f64,
    },
    /// The measurements do not go together: no closed body has them all.
    #[error(
        "the measurements do not make one body: {reason}; check {} against {}",
        check.english, against.english
    )]
    Unbuildable {
        /// What failed.
        reason: Sentence,
        /// The measurement to check first.
        check: Words,
        /// The measurement it goes least well with.
        against: Words,
    },
    /// A given body on which a tape finds no place.
    #[error("{}", what.english)]
    Unmeasurable {
        /// What cannot be measured, and why.
        what: Words,
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

impl Bilingual for BodyError {
    fn japanese(&self) -> String {
        match self {
            Self::OutOfBand {
                name,
                value_cm,
                least_cm,
                most_cm,
            } => format!(
                "{}が {value_cm:.1} cm ですが、{least_cm:.1}～{most_cm:.1} cm のはずです。\
                 測り直すか、単位を確かめてください",
                name.japanese
            ),
            Self::Conflict {
                first,
                first_cm,
                second,
                second_cm,
                least_cm,
                most_cm,
            } => format!(
                "{} {first_cm:.1} cm と{} {second_cm:.1} cm は両立しません（後者に対して前者は \
                 {least_cm:.1}～{most_cm:.1} cm のはずです）。両方を測り直してください",
                first.japanese, second.japanese
            ),
            Self::Unbuildable {
                reason,
                check,
                against,
            } => format!(
                "この採寸では一つの体になりません（{}）。{}を{}と比べて確かめてください",
                reason.japanese, check.japanese, against.japanese
            ),
            Self::Unmeasurable { what } => what.japanese.to_owned(),
            Self::Sections { reason } => format!(
                "体の断面の表が読めません（{reason}）。data/body_sections.json を元に戻してください"
            ),
        }
    }
}
