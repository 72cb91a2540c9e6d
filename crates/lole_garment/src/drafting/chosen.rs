//! What was decided for a garment, read by key and held to the ranges of its rows.

use lole_geom::Length;
use lole_pattern::DraftError;

use crate::template::{OptionKind, OptionRow, Options};

/// The options of one garment by key.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chosen<'a> {
    rows: &'static [OptionRow],
    options: &'a Options,
}

impl<'a> Chosen<'a> {
    /// Refuses values outside the ranges of their rows.
    pub(crate) fn new(
        rows: &'static [OptionRow],
        options: &'a Options,
    ) -> Result<Self, DraftError> {
        for (position, row) in rows.iter().enumerate() {
            let (min, max) = match row.kind {
                OptionKind::Number { min, max, .. } => (min, max),
                OptionKind::Count { min, max, .. } => (f64::from(min), f64::from(max)),
                OptionKind::Choice(choices) => (0.0, choices.len().saturating_sub(1) as f64),
            };
            let whole = !matches!(row.kind, OptionKind::Number { .. });
            if let Some(value) = options.get(position)
                && (!(min..=max).contains(&value) || (whole && value.fract() != 0.0))
            {
                return Err(DraftError::Option {
                    key: row.key,
                    about: row.about,
                    value,
                    min,
                    max,
                });
            }
        }
        Ok(Self { rows, options })
    }

    fn value(&self, key: &str) -> Option<f64> {
        let position = self.rows.iter().position(|row| row.key == key);
        debug_assert!(position.is_some(), "no option {key}");
        let position = position?;
        let usual = match self.rows[position].kind {
            OptionKind::Number { default, .. } => default,
            OptionKind::Count { default, .. } => Some(f64::from(default)),
            OptionKind::Choice(_) => Some(0.0),
        };
        self.options.get(position).or(usual)
    }

    /// A number that has a default.
    pub(crate) fn number(&self, key: &str) -> f64 {
        self.value(key).unwrap_or_default()
    }

    /// A number that follows from the measures unless it was decided.
    pub(crate) fn number_or(&self, key: &str, usual: f64) -> f64 {
        self.value(key).unwrap_or(usual)
    }

    /// A length in centimeters that has a default [m].
    pub(crate) fn m(&self, key: &str) -> f64 {
        Length::from_cm(self.number(key)).to_m()
    }

    /// A length in centimeters that follows from the measures unless it was decided [m].
    pub(crate) fn m_or(&self, key: &str, usual: f64) -> f64 {
        self.value(key)
            .map_or(usual, |cm| Length::from_cm(cm).to_m())
    }

    /// A count.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "held to the range of its row, which is of u32"
    )]
    pub(crate) fn count(&self, key: &str) -> u32 {
        self.number(key) as u32
    }

    /// Identifier of the choice.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "held to the range of its row"
    )]
    pub(crate) fn choice(&self, key: &str) -> &'static str {
        let row = self.rows.iter().find(|row| row.key == key);
        let index = self.number(key) as usize;
        match row.map(|row| &row.kind) {
            Some(OptionKind::Choice(choices)) => choices.get(index).map_or("", |one| one.id),
            _ => "",
        }
    }
}

/// A row for a length or ratio with its usual value.
pub(crate) const fn number(
    key: &'static str,
    [min, max]: [f64; 2],
    default: f64,
    about: lole_language::Words,
) -> OptionRow {
    let default = Some(default);
    let kind = OptionKind::Number { min, max, default };
    OptionRow { key, about, kind }
}

/// A row for a length or ratio that follows from the measures unless it is decided.
pub(crate) const fn by_measure(
    key: &'static str,
    [min, max]: [f64; 2],
    about: lole_language::Words,
) -> OptionRow {
    let default = None;
    let kind = OptionKind::Number { min, max, default };
    OptionRow { key, about, kind }
}

/// A row for a count.
pub(crate) const fn count(
    key: &'static str,
    [min, max]: [u32; 2],
    default: u32,
    about: lole_language::Words,
) -> OptionRow {
    let kind = OptionKind::Count { min, max, default };
    OptionRow { key, about, kind }
}

/// A row for one of several ways, the first being the usual one.
pub(crate) const fn choice(
    key: &'static str,
    choices: &'static [crate::template::Choice],
    about: lole_language::Words,
) -> OptionRow {
    let kind = OptionKind::Choice(choices);
    OptionRow { key, about, kind }
}
