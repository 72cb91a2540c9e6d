//! Lole as a module of Python: `import lole`.
//!
//! The classes hold what the libraries hold and add no arithmetic. Sentences become exceptions word for word;
//! work that takes long releases Python's lock; positions are given as arrays of `NumPy`. Types and docstrings
//! for users stand in `python/lole/_lole.pyi`.

mod dancer;
mod design;
mod performance;
mod studies;
mod sweep;

use std::path::PathBuf;

use glam::Vec3;
use lole_language::{Bilingual, Sentence};
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(
    lole,
    LoleError,
    PyValueError,
    "What was asked for cannot be done."
);
create_exception!(lole, Diverged, PyRuntimeError, "The cloth flew apart.");

/// A sentence as an exception, with its Japanese beside it.
fn refused(py: Python<'_>, said: &impl Bilingual) -> PyErr {
    in_both(py, LoleError::new_err(said.to_string()), &said.japanese())
}

fn in_both(py: Python<'_>, error: PyErr, japanese: &str) -> PyErr {
    match error.value(py).setattr("japanese", japanese) {
        Ok(()) => error,
        Err(other) => other,
    }
}

/// The same for what a program of Python says wrongly.
fn wrong(py: Python<'_>, japanese: impl Into<String>, english: impl Into<String>) -> PyErr {
    refused(py, &Sentence::new(japanese, english))
}

/// Places [m] as an array of shape `[places, 3]`.
fn array<'py>(py: Python<'py>, places: &[Vec3]) -> PyResult<Bound<'py, PyArray2<f32>>> {
    let numbers: Vec<f32> = bytemuck::cast_slice(places).to_vec();
    PyArray1::from_vec(py, numbers).reshape([places.len(), 3])
}

/// Text of JSON as objects of Python.
fn objects<'py>(py: Python<'py>, json: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (json,))
}

/// The same of anything that can be written so.
fn objects_of<'py>(py: Python<'py>, it: &impl serde::Serialize) -> PyResult<Bound<'py, PyAny>> {
    let json = serde_json::to_string(it);
    let json = json.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    objects(py, &json)
}

/// A text or a path of Python.
fn path(it: &Bound<'_, PyAny>) -> PyResult<PathBuf> {
    it.extract()
}

/// Hula costume CAD with live cloth.
#[pymodule]
fn _lole(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("LoleError", module.py().get_type::<LoleError>())?;
    module.add("Diverged", module.py().get_type::<Diverged>())?;
    module.add_class::<design::Design>()?;
    module.add_class::<dancer::Dancer>()?;
    module.add_class::<performance::Performance>()?;
    module.add_class::<sweep::Sweep>()?;
    module.add_function(wrap_pyfunction!(studies::fabrics, module)?)?;
    module.add_function(wrap_pyfunction!(studies::validate, module)?)?;
    module.add_function(wrap_pyfunction!(studies::bench, module)?)
}
