//! A design document as an object of Python.

use std::path::PathBuf;

use lole_batch::put;
use lole_body::{Dancer, Measurements};
use lole_costume::document::{self, Design as Document};
use lole_costume::{cost, order};
use lole_files::{name_linked_files, read_document, read_linked_files};
use lole_language::Sentence;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use serde_json::json;
use toml::{Table, Value};

use crate::{objects_of, path, refused, wrong};

/// A design document: from a dict of tables, from a file, or the built-in pāʻū skirt.
#[pyclass(frozen, module = "lole")]
#[derive(Clone)]
pub(crate) struct Design {
    /// With the files that it names, by their whole paths.
    pub(crate) document: Document,
}

#[pymethods]
impl Design {
    /// Reads a design: a dict such as `{"skirt": {"gather_ratio": 3}}`, the path of a file, or nothing.
    #[new]
    #[pyo3(signature = (source=None))]
    fn new(py: Python<'_>, source: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let Some(source) = source else {
            return Ok(Self {
                document: Document::default(),
            });
        };
        if let Ok(dict) = source.cast::<PyDict>() {
            return Self::of_table(py, table(dict)?);
        }
        let path = path(source)?;
        let bytes = read_document(&path).map_err(|why| refused(py, &why))?;
        let document = document::parse_bytes(&bytes, &path.display().to_string());
        let document = document.map_err(|error| refused(py, &error))?;
        Self::linked(py, document, path)
    }

    /// The document as TOML: what `lole dance` reads.
    #[getter]
    fn text(&self) -> String {
        document::to_toml(&self.document)
    }

    /// The document as tables; `Design(design.to_dict())` is the same design.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        objects_of(py, &self.table())
    }

    /// The same design with other values, such as `{"skirt.gather_ratio": 3}`.
    fn replaced(&self, py: Python<'_>, keys: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut table = self.table();
        for (key, value) in keys {
            let key: String = key.extract()?;
            put(&mut table, &key, value_of(&value)?).map_err(|why| refused(py, &why))?;
        }
        Self::of_table(py, table)
    }

    /// The skirt on paper, lengths in cm; `None` where none is worn.
    fn draft<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        if !self.document.skirt.is_worn {
            return Ok(None);
        }
        let production = lole_stage::Production::new(&self.document);
        let production = production.map_err(|error| refused(py, &error))?;
        let Some(skirt) = production.skirt() else {
            return Ok(None);
        };
        let draft = &skirt.draft;
        let elastics = draft.elastic_rows.iter().map(|row| row.cut_length.to_cm());
        let warnings = draft.warnings.iter().map(ToString::to_string);
        let drawn = json!({
            "flat_length_cm": draft.flat_length.to_cm(),
            "finished_length_cm": draft.finished_length.to_cm(),
            "cut_length_cm": draft.cut_length.to_cm(),
            "cut_height_cm": draft.cut_height.to_cm(),
            "elastic_cut_lengths_cm": elastics.collect::<Vec<_>>(),
            "cloth_to_buy_m": draft.yardage.metric.to_m(),
            "cloth_to_buy_yd": draft.yardage.imperial.to_yd(),
            "warnings": warnings.collect::<Vec<_>>(),
        });
        objects_of(py, &drawn).map(Some)
    }

    /// The bill: what is paid for, in the design's currency; a line without a price has no sum, and `asks`
    /// names the key that would tell it.
    fn cost<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let document = &self.document;
        let dancer = match &document.dancer.file {
            Some(_) => lole_stage::dancer(document)
                .map(|(dancer, _)| dancer)
                .map_err(|error| refused(py, &error))?,
            None => Measurements::from_tape(&document.tape())
                .and_then(|tape| Dancer::to_measure(&tape, &document.appearance()))
                .map_err(|error| refused(py, &error))?,
        };
        let plan = order::plan_dancer("", document, &dancer);
        let plan = plan.map_err(|error| refused(py, &error))?;
        let bill = cost::bill(document, &plan);
        let lines = bill.lines.iter().map(|line| {
            json!({
                "name": line.name.english,
                "name_ja": line.name.japanese,
                "amount": line.amount.english,
                "amount_ja": line.amount.japanese,
                "sum": line.sum,
                "asks": line.asks,
            })
        });
        let told = json!({
            "currency": bill.currency.id(),
            "total": bill.total,
            "hours": bill.hours,
            "is_complete": bill.is_complete(),
            "lines": lines.collect::<Vec<_>>(),
        });
        objects_of(py, &told)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.text() == other.text()
    }
}

impl Design {
    fn of_table(py: Python<'_>, mut table: Table) -> PyResult<Self> {
        let version = i64::try_from(document::VERSION).unwrap_or(i64::MAX);
        table.entry("lole").or_insert(Value::Integer(version));
        let text = toml::to_string(&table)
            .map_err(|error| wrong(py, error.to_string(), error.to_string()))?;
        let document = document::parse(&text, "design").map_err(|error| {
            // The text is not the user's, and neither are its lines.
            let error = document::DesignError {
                line: None,
                ..error
            };
            refused(py, &error)
        })?;
        Self::linked(py, document, PathBuf::from("design"))
    }

    fn linked(py: Python<'_>, mut document: Document, path: PathBuf) -> PyResult<Self> {
        read_linked_files(&mut document, &path).map_err(|why| refused(py, &why))?;
        name_linked_files(&mut document, &path);
        Ok(Self { document })
    }

    fn table(&self) -> Table {
        self.text().parse().unwrap_or_default()
    }
}

fn table(dict: &Bound<'_, PyDict>) -> PyResult<Table> {
    let entries = dict
        .iter()
        .map(|(key, value)| Ok((key.extract()?, value_of(&value)?)));
    entries.collect()
}

/// A value of a document. Numbers of `NumPy` are numbers.
fn value_of(it: &Bound<'_, PyAny>) -> PyResult<Value> {
    if let Ok(text) = it.cast::<PyString>() {
        return Ok(Value::String(text.to_cow()?.into_owned()));
    }
    if it.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(it.extract()?));
    }
    if let Ok(dict) = it.cast::<PyDict>() {
        return table(dict).map(Value::Table);
    }
    if it.is_instance_of::<PyList>() || it.is_instance_of::<PyTuple>() {
        let all = it.try_iter()?.map(|it| value_of(&it?));
        return all.collect::<PyResult<Vec<_>>>().map(Value::Array);
    }
    let is_whole = it.is_instance_of::<PyInt>() || it.hasattr("__index__")?;
    if let (true, Ok(number)) = (is_whole, it.extract::<i64>()) {
        return Ok(Value::Integer(number));
    }
    if it.is_instance_of::<PyFloat>() || it.hasattr("__float__")? {
        return Ok(Value::Float(it.extract()?));
    }
    let shown = it.repr()?;
    Err(refused(
        it.py(),
        &Sentence::new(
            format!("{shown} はデザインの値になりません。数、文字、表を書いてください"),
            format!("{shown} is no value of a design; write a number, a text or a dict"),
        ),
    ))
}
