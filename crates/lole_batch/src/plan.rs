//! A sweep over a design: which documents are run.

use lole_costume::document::{self, Design, DesignError, Problem};
use lole_geom::fnv;
use lole_language::Sentence;
use toml::{Table, Value};

use crate::sweep::{Span, Sweep, SweepError};

/// The runs of a sweep over a design. Every value was held against the design when it was made; what only
/// values together are refused for becomes the record of its run.
#[derive(Debug, Clone)]
pub struct Plan {
    sweep: Sweep,
    base: Table,
    /// What the design is called in sentences.
    name: String,
    /// Of a hypercube.
    shares: Option<Vec<Vec<f64>>>,
    /// By axis: whether its keys take whole numbers only.
    is_whole: Vec<bool>,
}

/// One run before it is performed.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What the run is called, the same wherever and whenever it is run: a hash of version, document and files.
    pub id: String,
    /// Its value of each axis.
    pub values: Vec<Value>,
    /// Its whole design.
    pub document: String,
}

impl Plan {
    /// Holds a sweep against the text of its design, `text`, which sentences call `name`.
    ///
    /// # Errors
    /// The design's own mistakes with their lines; the first key that it does not have; the first value
    /// that is out of its range.
    pub fn new(sweep: Sweep, text: &str, name: &str) -> Result<Self, SweepError> {
        document::parse(text, name).map_err(|error| SweepError(Sentence::of(&error)))?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut base: Table = text.parse().unwrap_or_default();
        for (path, value) in &sweep.fixed {
            let place = |why: Sentence| in_place("[fixed]", &why);
            path.put(&mut base, value.clone()).map_err(place)?;
            if let Err(why) = parse(&base, name) {
                return Err(in_place("[fixed]", &of_value(&path.name, value, &why)));
            }
        }
        let shares = sweep.shares();
        let mut plan = Self {
            is_whole: Vec::new(),
            name: name.to_owned(),
            sweep,
            base,
            shares,
        };
        for number in 0..plan.sweep.axes.len() {
            let is_whole = plan.probe(number)?;
            plan.is_whole.push(is_whole);
        }
        Ok(plan)
    }

    /// What is swept.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    /// How many runs there are.
    #[must_use]
    pub const fn run_count(&self) -> u64 {
        self.sweep.run_count()
    }

    /// Names of the columns of what is varied.
    pub fn parameters(&self) -> impl Iterator<Item = &str> {
        self.sweep.axes.iter().map(|axis| &*axis.keys[0].name)
    }

    /// Every design that names other files than the rest may: the design, and it with each listed value.
    /// What they name is read and goes into [`Self::run`] as one number.
    #[must_use]
    pub fn designs(&self) -> Vec<Design> {
        let mut all: Vec<Design> = parse(&self.base, &self.name).into_iter().collect();
        for axis in &self.sweep.axes {
            let Span::Values(values) = &axis.span else {
                continue;
            };
            for value in values.iter().filter(|value| value.is_str()) {
                let mut table = self.base.clone();
                let put = axis
                    .keys
                    .iter()
                    .try_for_each(|key| key.put(&mut table, value.clone()));
                all.extend(put.ok().and_then(|()| parse(&table, &self.name).ok()));
            }
        }
        all
    }

    /// The run of a number, counted from 0; `linked` is a hash of the bytes of all files that the designs name.
    ///
    /// # Panics
    /// Where there is no such run.
    #[must_use]
    pub fn run(&self, number: u64, linked: u64) -> Run {
        assert!(
            number < self.run_count(),
            "run {number} of {}",
            self.run_count()
        );
        let values: Vec<Value> = match &self.shares {
            None => self.sweep.listed(number),
            Some(shares) => {
                let place = usize::try_from(number).unwrap_or(0);
                let axes = self.sweep.axes.iter().zip(shares);
                axes.map(|(axis, shares)| axis.span.at(shares[place]))
                    .collect()
            }
        };
        let values: Vec<Value> = (values.into_iter().zip(&self.is_whole))
            .map(|(value, &is_whole)| if is_whole { whole(value) } else { value })
            .collect();
        let mut table = self.base.clone();
        for (axis, value) in self.sweep.axes.iter().zip(&values) {
            for key in &axis.keys {
                // Each was put there when the plan was made.
                let put = key.put(&mut table, value.clone());
                debug_assert!(put.is_ok(), "{}", key.name);
            }
        }
        let document = written(&table);
        let version = format!("{}\n{linked:016x}\n", env!("CARGO_PKG_VERSION"));
        let hash = fnv::hash(version.bytes().chain(document.bytes()));
        Run {
            id: format!("{hash:016x}"),
            values,
            document,
        }
    }

    /// Holds every value of an axis against the design: whether its keys take whole numbers only.
    fn probe(&self, number: usize) -> Result<bool, SweepError> {
        let axis = &self.sweep.axes[number];
        let values = match &axis.span {
            // What lies between two numbers that a key takes, it takes too.
            Span::Values(values) if axis.is_range => values
                .iter()
                .take(1)
                .chain(values.last())
                .cloned()
                .collect(),
            Span::Values(values) => values.clone(),
            Span::Between { .. } => vec![axis.span.at(0.0), axis.span.at(1.0)],
        };
        let mut is_whole = false;
        for value in values {
            let first = self.tried(number, &value);
            let rounded = whole(value.clone());
            let place = format!("[[axis]] {}", number + 1);
            match first {
                Ok(()) => {}
                Err(Tried::Refused(_)) if axis.is_range && self.tried(number, &rounded).is_ok() => {
                    is_whole = true;
                }
                Err(Tried::Nowhere(why)) => return Err(in_place(&place, &why)),
                Err(Tried::Refused(why)) => {
                    let why = of_value(&axis.keys[0].name, &value, &why);
                    return Err(in_place(&place, &why));
                }
            }
        }
        Ok(is_whole)
    }

    fn tried(&self, number: usize, value: &Value) -> Result<(), Tried> {
        let mut table = self.base.clone();
        for key in &self.sweep.axes[number].keys {
            key.put(&mut table, value.clone()).map_err(Tried::Nowhere)?;
        }
        match parse(&table, &self.name) {
            Ok(_) => Ok(()),
            // What does not go with the rest of the design may go with another value of another axis.
            Err(error) if matches!(*error.problem, Problem::Together { .. }) => Ok(()),
            Err(error) => Err(Tried::Refused(error)),
        }
    }
}

enum Tried {
    Nowhere(Sentence),
    Refused(DesignError),
}

/// A number as a key of whole numbers takes it.
fn whole(value: Value) -> Value {
    match value {
        #[expect(clippy::cast_possible_truncation, reason = "in the range of its key")]
        Value::Float(number) => Value::Integer(number.round() as i64),
        value => value,
    }
}

/// The text of a document, the same for equal tables.
fn written(table: &Table) -> String {
    toml::to_string(table).unwrap_or_default()
}

/// Reads a design that has no text of its own.
fn parse(table: &Table, name: &str) -> Result<Design, DesignError> {
    document::parse(&written(table), name).map_err(|error| DesignError {
        line: None,
        ..error
    })
}

fn of_value(key: &str, value: &Value, why: &DesignError) -> Sentence {
    Sentence::new(
        format!(
            "{key} = {value}: {}",
            lole_language::Bilingual::japanese(why)
        ),
        format!("{key} = {value}: {why}"),
    )
}

fn in_place(place: &str, why: &Sentence) -> SweepError {
    SweepError(Sentence::new(
        format!("{place}: {}", why.japanese),
        format!("{place}: {}", why.english),
    ))
}

#[cfg(test)]
#[path = "plan/tests.rs"]
mod tests;
