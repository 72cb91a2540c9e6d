//! The table of a sweep: one row a run, as CSV and as Parquet.
//!
//! It is made of the records alone and holds no clock's time, so that it is the same to the bit however the
//! runs were shared out and however often they were interrupted. A number that a run does not have, or that
//! is not finite, is left empty.

use std::sync::Arc;

use bytes::Bytes;
use lole_language::Sentence;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use toml::Value;

use crate::plan::{Plan, Run};
use crate::record::{Figures, Record};

/// The cells of a column.
#[derive(Debug, Clone, PartialEq)]
enum Cells {
    Numbers(Vec<Option<f64>>),
    Counts(Vec<Option<i64>>),
    Texts(Vec<Option<String>>),
}

/// A column: its name and its cells.
#[derive(Debug, Clone, PartialEq)]
struct Column {
    name: String,
    cells: Cells,
}

/// All runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    columns: Vec<Column>,
    row_count: usize,
}

type Number = fn(&Figures) -> Option<f64>;
type Count = fn(&Figures) -> Option<u64>;

/// What is measured: names and figures, in their order in the table.
const NUMBERS: &[(&str, Number)] = &[
    ("dance_s", |it| Some(it.dance_s)),
    ("strain_mean_pct", |it| Some(it.strain_mean_pct)),
    ("strain_p99_worst_pct", |it| Some(it.strain_p99_worst_pct)),
    ("strain_worst_pct", |it| Some(it.strain_worst_pct)),
    ("skin_depth_worst_mm", |it| Some(it.skin_depth_worst_mm)),
    ("hem_low_cm", |it| Some(it.hem_low_cm)),
    ("hem_mean_cm", |it| Some(it.hem_mean_cm)),
    ("hem_high_cm", |it| Some(it.hem_high_cm)),
    ("sway_cm", |it| it.sway_cm),
    ("sway_worst_cm", |it| it.sway_worst_cm),
    ("rest_fold_depth_cm", |it| it.rest_fold_depth_cm),
    ("fold_count", |it| it.fold_count),
    ("fold_depth_cm", |it| it.fold_depth_cm),
    ("hem_radius_cm", |it| it.hem_radius_cm),
    ("pull_n", |it| it.pull_n),
    ("held_n", |it| it.held_n),
    ("slip_ratio", |it| it.slip_ratio),
];

/// What is counted.
const COUNTS: &[(&str, Count)] = &[
    ("frames", |it| Some(u64::from(it.frames))),
    ("particles", |it| Some(it.particles)),
    ("rest_fold_count", |it| it.rest_fold_count),
];

impl Table {
    /// The table of all runs of a plan, in their order.
    #[must_use]
    pub fn new(plan: &Plan, rows: &[(Run, Record)]) -> Self {
        let mut columns = vec![
            Column {
                name: "run".to_owned(),
                cells: Cells::Counts((0..).map(Some).take(rows.len()).collect()),
            },
            texts("id", rows.iter().map(|(run, _)| Some(run.id.clone()))),
        ];
        for (place, name) in plan.parameters().enumerate() {
            columns.push(parameter(name, rows, place));
        }
        for &(name, count) in COUNTS {
            let cells = rows.iter().map(|(_, record)| {
                let count = record.figures.as_ref().and_then(count)?;
                i64::try_from(count).ok()
            });
            columns.push(Column {
                name: name.to_owned(),
                cells: Cells::Counts(cells.collect()),
            });
        }
        for &(name, number) in NUMBERS {
            let cells = rows.iter().map(|(_, record)| {
                let number = record.figures.as_ref().and_then(number)?;
                number.is_finite().then_some(number)
            });
            columns.push(Column {
                name: name.to_owned(),
                cells: Cells::Numbers(cells.collect()),
            });
        }
        let hashes = rows
            .iter()
            .map(|(_, record)| Some(record.figures.as_ref()?.state_hash.clone()));
        columns.push(texts("state_hash", hashes));
        let errors = rows
            .iter()
            .map(|(_, record)| Some(record.error.as_ref()?.english.clone()));
        columns.push(texts("error", errors));
        Self {
            columns,
            row_count: rows.len(),
        }
    }

    /// How many runs have an error.
    #[must_use]
    pub fn failed_count(&self) -> usize {
        let last = self.columns.last().map(|it| &it.cells);
        match last {
            Some(Cells::Texts(errors)) => errors.iter().flatten().count(),
            _ => 0,
        }
    }

    /// As CSV (RFC 4180) in UTF-8, with a head.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let names: Vec<String> = self.columns.iter().map(|it| quoted(&it.name)).collect();
        let mut text = names.join(",") + "\r\n";
        for row in 0..self.row_count {
            let cells: Vec<String> = self.columns.iter().map(|it| it.cells.text(row)).collect();
            text.push_str(&cells.join(","));
            text.push_str("\r\n");
        }
        text
    }

    /// As Parquet, one row group, plain.
    ///
    /// # Errors
    /// What the writer of Parquet says: a fault of this program.
    pub fn to_parquet(&self) -> Result<Vec<u8>, Sentence> {
        self.write_parquet().map_err(|error| {
            Sentence::new(
                format!("表を Parquet にできません（{error}）。CSV をお使いください"),
                format!("the table cannot be made Parquet ({error}); use the CSV"),
            )
        })
    }

    fn write_parquet(&self) -> Result<Vec<u8>, ParquetError> {
        let fields = self.columns.iter().map(|column| {
            let (physical, logical) = match column.cells {
                Cells::Numbers(_) => (Physical::DOUBLE, None),
                Cells::Counts(_) => (Physical::INT64, None),
                Cells::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            };
            Type::primitive_type_builder(&column.name, physical)
                .with_logical_type(logical)
                .with_repetition(Repetition::OPTIONAL)
                .build()
                .map(Arc::new)
        });
        let schema = Type::group_type_builder("runs")
            .with_fields(fields.collect::<Result<Vec<_>, _>>()?)
            .build()?;
        let properties = WriterProperties::builder()
            .set_created_by(format!("lole {}", env!("CARGO_PKG_VERSION")))
            .build();
        let mut bytes = Vec::new();
        let mut file =
            SerializedFileWriter::new(&mut bytes, Arc::new(schema), Arc::new(properties))?;
        let mut group = file.next_row_group()?;
        for column in &self.columns {
            column.cells.write(&mut group)?;
        }
        group.close()?;
        file.close()?;
        Ok(bytes)
    }
}

impl Cells {
    fn text(&self, row: usize) -> String {
        match self {
            Self::Numbers(cells) => cells[row].map_or_else(String::new, |it| it.to_string()),
            Self::Counts(cells) => cells[row].map_or_else(String::new, |it| it.to_string()),
            Self::Texts(cells) => cells[row].as_deref().map_or_else(String::new, quoted),
        }
    }

    fn write<W: std::io::Write + Send>(
        &self,
        group: &mut SerializedRowGroupWriter<'_, W>,
    ) -> Result<(), ParquetError> {
        let Some(mut writer) = group.next_column()? else {
            return Ok(());
        };
        match self {
            Self::Numbers(cells) => {
                let (values, levels) = present(cells, |it| *it);
                writer
                    .typed::<DoubleType>()
                    .write_batch(&values, Some(&levels), None)?;
            }
            Self::Counts(cells) => {
                let (values, levels) = present(cells, |it| *it);
                writer
                    .typed::<Int64Type>()
                    .write_batch(&values, Some(&levels), None)?;
            }
            Self::Texts(cells) => {
                let bytes = |it: &String| ByteArray::from(Bytes::from(it.clone()));
                let (values, levels) = present(cells, bytes);
                writer
                    .typed::<ByteArrayType>()
                    .write_batch(&values, Some(&levels), None)?;
            }
        }
        writer.close()
    }
}

/// The cells that hold something, and for every cell whether it does, as Parquet has it.
fn present<T, U>(cells: &[Option<T>], value: impl Fn(&T) -> U) -> (Vec<U>, Vec<i16>) {
    let values = cells.iter().flatten().map(value).collect();
    let levels = cells.iter().map(|it| i16::from(it.is_some())).collect();
    (values, levels)
}

fn texts(name: &str, cells: impl Iterator<Item = Option<String>>) -> Column {
    Column {
        name: name.to_owned(),
        cells: Cells::Texts(cells.collect()),
    }
}

/// A column of what is varied: numbers where all are, else texts.
fn parameter(name: &str, rows: &[(Run, Record)], place: usize) -> Column {
    let values = || rows.iter().map(|(run, _)| &run.values[place]);
    let cells = if values().all(Value::is_integer) {
        Cells::Counts(values().map(Value::as_integer).collect())
    } else if values().all(|it| it.is_integer() || it.is_float()) {
        #[expect(clippy::cast_precision_loss, reason = "values of a design are small")]
        let number = |it: &Value| it.as_float().or(it.as_integer().map(|it| it as f64));
        Cells::Numbers(values().map(number).collect())
    } else {
        let text = |it: &Value| it.as_str().map_or_else(|| it.to_string(), str::to_owned);
        Cells::Texts(values().map(|it| Some(text(it))).collect())
    };
    Column {
        name: name.to_owned(),
        cells,
    }
}

/// A text as a cell of CSV.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
#[path = "table/tests.rs"]
mod tests;
