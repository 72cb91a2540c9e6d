//! The text of a sweep: which keys of a design are varied, and how.
//!
//! ```toml
//! lole_sweep = 1
//! design = "pau.lole"          # from where the sweep lies; the built-in design without it
//! kind = "grid"                # or "list", or "latin-hypercube" with count and seed
//! files = ["series"]           # written for every run: design, series, positions
//!
//! [fixed]                      # the same in every run
//! "motion.duration_s" = 4
//!
//! [[axis]]
//! key = "skirt.gather_ratio"
//! values = [2, 3, 4]
//!
//! [[axis]]                     # one value in several keys
//! keys = ["fabric.bend_warp_un_m", "fabric.bend_weft_un_m"]
//! from = 1
//! to = 100
//! count = 5                    # of a grid; a hypercube has as many as runs
//! scale = "log"
//! ```

use std::collections::BTreeSet;

use lole_geom::chance::Chance;
use lole_geom::{fnv, trig64};
use lole_language::{Bilingual, Sentence};
use serde::Deserialize;
use toml::Value;

use crate::key::KeyPath;

/// Version of the format, and the newest that is read.
pub const VERSION: u64 = 1;
/// Most runs of a sweep.
pub const MOST_RUNS: u64 = 1_000_000;
/// Largest text that is read [byte].
const SIZE_LIMIT: usize = 16 << 20;

/// Why a sweep cannot be run: one sentence with file, line or place, what is wrong and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct SweepError(pub Sentence);

impl Bilingual for SweepError {
    fn japanese(&self) -> String {
        self.0.japanese.clone()
    }
}

/// Files that a run may leave beside its record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileKind {
    /// The document that was run: `lole dance` repeats it.
    Design,
    /// Strain, hem, sway and folds by time, as CSV.
    Series,
    /// Where every particle is at the end [m], as `NumPy` reads it.
    Positions,
}

impl FileKind {
    /// What follows the run's name.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Design => ".lole",
            Self::Series => "-series.csv",
            Self::Positions => "-positions.npy",
        }
    }
}

/// How the axes are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SweepKind {
    /// Every value of one with every value of the others.
    Grid,
    /// The first values of all, the second values of all, and so on.
    List,
    /// In every axis one run in each of `count` equal parts, in an order of its own (`McKay`, Beckman and
    /// Conover 1979).
    LatinHypercube,
}

/// How a range is divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Scale {
    #[default]
    Linear,
    Log,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SweepText {
    lole_sweep: u64,
    design: Option<String>,
    kind: SweepKind,
    count: Option<u64>,
    seed: Option<u64>,
    #[serde(default)]
    files: BTreeSet<FileKind>,
    #[serde(default)]
    fixed: toml::Table,
    axis: Vec<AxisText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AxisText {
    key: Option<String>,
    keys: Option<Vec<String>>,
    values: Option<Vec<Value>>,
    from: Option<f64>,
    to: Option<f64>,
    count: Option<u64>,
    scale: Option<Scale>,
}

/// One thing that is varied.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    /// The same value goes to all of them; the first names the column.
    pub(crate) keys: Vec<KeyPath>,
    pub(crate) span: Span,
    /// Whether it was written as a range.
    pub(crate) is_range: bool,
}

/// What an axis may be.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Span {
    /// These, in this order.
    Values(Vec<Value>),
    /// Anything between two numbers: of a hypercube.
    Between { from: f64, to: f64, is_log: bool },
}

impl Span {
    /// The value that has this share of the axis before it.
    pub(crate) fn at(&self, share: f64) -> Value {
        match self {
            Self::Values(values) => {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "a share of a length"
                )]
                let place = (share * values.len() as f64) as usize;
                values[place.min(values.len() - 1)].clone()
            }
            Self::Between { from, to, is_log } => Value::Float(if *is_log {
                let between = trig64::powf(to / from, share) * from;
                between.clamp(*from, *to)
            } else {
                from + (to - from) * share
            }),
        }
    }
}

/// A sweep that was read; its keys and values are held against a design by [`Plan`](crate::Plan).
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// The design that is varied, from where the sweep lies; the built-in one when `None`.
    pub design: Option<String>,
    /// Files of every run.
    pub files: BTreeSet<FileKind>,
    pub(crate) fixed: Vec<(KeyPath, Value)>,
    pub(crate) axes: Vec<Axis>,
    kind: SweepKind,
    run_count: u64,
    seed: u64,
}

impl Sweep {
    /// Reads a sweep; `name` is only named in the sentence.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn read(text: &str, name: &str) -> Result<Self, SweepError> {
        let at = |sentence: Sentence| {
            SweepError(Sentence::new(
                format!("{name}: {}", sentence.japanese),
                format!("{name}: {}", sentence.english),
            ))
        };
        if SIZE_LIMIT < text.len() {
            return Err(at(Sentence::new(
                "大きすぎてスイープではありません。ファイルを確かめてください",
                "the text is too large for a sweep; is this the right file?",
            )));
        }
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let read: SweepText =
            toml::from_str(text).map_err(|error| not_a_sweep(&error, text, name))?;
        Self::of(read).map_err(at)
    }

    fn of(read: SweepText) -> Result<Self, Sentence> {
        if read.lole_sweep != VERSION {
            return Err(Sentence::new(
                format!(
                    "lole_sweep = {} は読めません。lole_sweep = {VERSION} と書いてください",
                    read.lole_sweep
                ),
                format!(
                    "lole_sweep = {} cannot be read; write lole_sweep = {VERSION}",
                    read.lole_sweep
                ),
            ));
        }
        let is_cube = read.kind == SweepKind::LatinHypercube;
        if !is_cube && (read.count.is_some() || read.seed.is_some()) {
            return Err(Sentence::new(
                "count と seed は kind = \"latin-hypercube\" のものです。消してください",
                "count and seed belong to kind = \"latin-hypercube\"; take them out",
            ));
        }
        if read.axis.is_empty() {
            return Err(Sentence::new(
                "変えるものがありません。[[axis]] に key と values を書いてください",
                "nothing is varied; write an [[axis]] with its key and values",
            ));
        }
        let axes = (1..).zip(read.axis).map(|(number, axis)| {
            let place = format!("[[axis]] {number}");
            axis.read(read.kind).map_err(|why| {
                Sentence::new(
                    format!("{place}: {}", why.japanese),
                    format!("{place}: {}", why.english),
                )
            })
        });
        let axes = axes.collect::<Result<Vec<Axis>, _>>()?;
        let fixed = read.fixed.into_iter().map(|(name, value)| {
            let put = (KeyPath::read(&name), scalar(&value));
            match put {
                (Ok(path), Ok(())) => Ok((path, value)),
                (Err(why), _) | (_, Err(why)) => Err(Sentence::new(
                    format!("[fixed] {}", why.japanese),
                    format!("[fixed] {}", why.english),
                )),
            }
        });
        let fixed = fixed.collect::<Result<Vec<_>, _>>()?;
        refuse_twice(&fixed, &axes)?;
        Ok(Self {
            design: read.design,
            files: read.files,
            run_count: run_count(read.kind, read.count, &axes)?,
            fixed,
            axes,
            kind: read.kind,
            seed: read.seed.unwrap_or(1),
        })
    }

    /// How many runs there are.
    #[must_use]
    pub const fn run_count(&self) -> u64 {
        self.run_count
    }

    /// Shares of each axis, run by run, of a hypercube; `None` of the other kinds. Each axis has a chance of
    /// its own, so that another axis leaves it as it was.
    pub(crate) fn shares(&self) -> Option<Vec<Vec<f64>>> {
        if self.kind != SweepKind::LatinHypercube {
            return None;
        }
        let count = self.run_count;
        let axes = self.axes.iter().map(|axis| {
            let name = fnv::hash(axis.keys[0].name.bytes());
            let mut chance = Chance::new(self.seed.wrapping_add(name));
            let mut parts: Vec<u64> = (0..count).collect();
            // Fisher and Yates.
            for last in (1..parts.len()).rev() {
                let limit = u64::try_from(last).unwrap_or(u64::MAX) + 1;
                let other = usize::try_from(chance.bits() % limit).unwrap_or(0);
                parts.swap(last, other);
            }
            let share = |part: u64| (part as f64 + chance.finest_share()) / count as f64;
            parts.into_iter().map(share).collect()
        });
        Some(axes.collect())
    }

    /// The value of each axis in a run of a grid or a list.
    pub(crate) fn listed(&self, run: u64) -> Vec<Value> {
        let mut rest = run;
        let mut values: Vec<Value> = Vec::with_capacity(self.axes.len());
        // The last axis changes fastest.
        for axis in self.axes.iter().rev() {
            let Span::Values(list) = &axis.span else {
                continue;
            };
            let length = list.len() as u64;
            let place = if self.kind == SweepKind::List {
                run
            } else {
                rest % length
            };
            rest /= length;
            values.push(list[usize::try_from(place).unwrap_or(0)].clone());
        }
        values.reverse();
        values
    }
}

fn not_a_sweep(error: &toml::de::Error, text: &str, name: &str) -> SweepError {
    let start = error.span().map_or(0, |span| span.start.min(text.len()));
    let line = 1 + text.as_bytes()[..start]
        .iter()
        .filter(|it| **it == b'\n')
        .count();
    let message: Vec<&str> = error.message().split_whitespace().collect();
    let message = message.join(" ");
    SweepError(Sentence::new(
        format!("{name}:{line}: スイープとして読めません（{message}）。その行を直してください"),
        format!("{name}:{line}: this is no sweep ({message}); mend the line"),
    ))
}

impl AxisText {
    fn read(self, kind: SweepKind) -> Result<Axis, Sentence> {
        let names = match (self.key, self.keys) {
            (Some(key), None) => vec![key],
            (None, Some(keys)) if !keys.is_empty() => keys,
            _ => {
                return Err(Sentence::new(
                    "key か keys のどちらか一つを書いてください",
                    "write either key or keys",
                ));
            }
        };
        let keys = names.iter().map(|name| KeyPath::read(name));
        let keys = keys.collect::<Result<Vec<_>, _>>()?;
        let name = &names[0];
        let either = || {
            Sentence::new(
                format!("{name}: values か、from と to のどちらかを書いてください"),
                format!("{name}: write either values, or from and to"),
            )
        };
        let span = match (self.values, self.from, self.to) {
            (Some(values), None, None) if self.count.is_none() && self.scale.is_none() => {
                if values.is_empty() {
                    return Err(Sentence::new(
                        format!("{name}: values が空です。一つ以上書いてください"),
                        format!("{name}: values is empty; write at least one"),
                    ));
                }
                values.iter().try_for_each(scalar)?;
                Span::Values(values)
            }
            (None, Some(from), Some(to)) => {
                range(name, (from, to), (self.count, self.scale), kind)?
            }
            _ => return Err(either()),
        };
        Ok(Axis {
            keys,
            span,
            is_range: self.from.is_some(),
        })
    }
}

/// A range of an axis, divided where it is not a hypercube's.
fn range(
    name: &str,
    (from, to): (f64, f64),
    (count, scale): (Option<u64>, Option<Scale>),
    kind: SweepKind,
) -> Result<Span, Sentence> {
    let is_log = scale == Some(Scale::Log);
    if !(from.is_finite() && to.is_finite() && from < to) {
        return Err(Sentence::new(
            format!(
                "{name}: from = {from}, to = {to} は空の範囲です。to を from より大きくしてください"
            ),
            format!("{name}: from = {from} to = {to} is an empty range; write a larger to"),
        ));
    }
    if is_log && from <= 0.0 {
        return Err(Sentence::new(
            format!("{name}: scale = \"log\" の from は 0 より大きくしてください"),
            format!("{name}: scale = \"log\" needs a from above 0"),
        ));
    }
    let span = Span::Between { from, to, is_log };
    match (count, kind == SweepKind::LatinHypercube) {
        (None, true) => Ok(span),
        (Some(count), false) if (2..=MOST_RUNS).contains(&count) => {
            let last = (count - 1) as f64;
            let values = (0..count).map(|place| span.at(place as f64 / last));
            Ok(Span::Values(values.collect()))
        }
        (Some(_), true) => Err(Sentence::new(
            format!("{name}: latin-hypercube の範囲に count は要りません。上の count が回数です"),
            format!(
                "{name}: a range of a latin-hypercube takes no count; the count of the sweep is the number of runs"
            ),
        )),
        (_, false) => Err(Sentence::new(
            format!("{name}: count に 2 から {MOST_RUNS} までの整数を書いてください"),
            format!("{name}: write its count, a whole number from 2 to {MOST_RUNS}"),
        )),
    }
}

/// Only what a key of a design can hold.
fn scalar(value: &Value) -> Result<(), Sentence> {
    let is_scalar = match value {
        Value::Float(number) => number.is_finite(),
        Value::String(_) | Value::Integer(_) => true,
        _ => false,
    };
    if is_scalar {
        return Ok(());
    }
    Err(Sentence::new(
        format!("{value} は値になりません。数か、引用符で囲んだ名前を書いてください"),
        format!("{value} is no value; write a number, or a name in quotes"),
    ))
}

fn refuse_twice(fixed: &[(KeyPath, Value)], axes: &[Axis]) -> Result<(), Sentence> {
    let mut seen = BTreeSet::new();
    let all = (fixed.iter().map(|(path, _)| path)).chain(axes.iter().flat_map(|axis| &axis.keys));
    for path in all {
        if !seen.insert(&path.name) {
            let name = &path.name;
            return Err(Sentence::new(
                format!("{name} が二度あります。一つだけ残してください"),
                format!("{name} stands there twice; keep one"),
            ));
        }
    }
    Ok(())
}

fn run_count(kind: SweepKind, count: Option<u64>, axes: &[Axis]) -> Result<u64, Sentence> {
    let lengths = axes.iter().filter_map(|axis| match &axis.span {
        Span::Values(values) => Some(values.len() as u64),
        Span::Between { .. } => None,
    });
    let runs = match kind {
        SweepKind::Grid => lengths.fold(1_u64, u64::saturating_mul),
        SweepKind::List => {
            let lengths: Vec<u64> = lengths.collect();
            if let Some(other) = lengths.iter().find(|&&it| it != lengths[0]) {
                return Err(Sentence::new(
                    format!(
                        "kind = \"list\" では values の数をそろえてください（{} と {other}）",
                        lengths[0]
                    ),
                    format!(
                        "kind = \"list\" needs as many values in every axis; here are {} and {other}",
                        lengths[0]
                    ),
                ));
            }
            lengths[0]
        }
        SweepKind::LatinHypercube => count.ok_or_else(|| {
            Sentence::new(
                "latin-hypercube には count（回数）を書いてください",
                "a latin-hypercube needs its count of runs",
            )
        })?,
    };
    if (1..=MOST_RUNS).contains(&runs) {
        return Ok(runs);
    }
    Err(Sentence::new(
        format!("{runs} 回は実行できません。1 から {MOST_RUNS} 回にしてください"),
        format!("{runs} runs are out of range; vary less, so that there are 1 to {MOST_RUNS}"),
    ))
}

#[cfg(test)]
#[path = "sweep/tests.rs"]
mod tests;
