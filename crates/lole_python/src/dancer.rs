//! The dancer of a design, standing.

use lole_costume::document::Design as Document;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::design::Design;
use crate::{array, objects_of, refused};

/// The dancer of a design, standing.
#[pyclass(frozen, module = "lole")]
pub(crate) struct Dancer {
    dancer: lole_body::Dancer,
}

#[pymethods]
impl Dancer {
    /// Builds her to the design's tape, or reads its avatar.
    #[new]
    #[pyo3(signature = (design=None))]
    fn new(py: Python<'_>, design: Option<PyRef<'_, Design>>) -> PyResult<Self> {
        let document = design.map_or_else(Document::default, |it| it.document.clone());
        let dancer = py.detach(|| lole_stage::dancer(&document));
        let (dancer, _) = dancer.map_err(|error| refused(py, &error))?;
        Ok(Self { dancer })
    }

    /// Her tape, taken on her body [cm].
    #[getter]
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let tape = lole_body::Tape::default();
        let taped = self.dancer.taped(&tape);
        let measures = taped.into_iter();
        let measures = measures.map(|it| (it.measure.key(), it.on_body.to_cm()));
        objects_of(py, &measures.collect::<std::collections::BTreeMap<_, _>>())
    }

    /// Vertices of her skin [m], shape `[vertices, 3]`.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        array(py, &self.dancer.skin.positions)
    }

    /// Triangles of her skin, shape `[triangles, 3]`.
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let triangles = self.dancer.skin.body_triangles();
        PyArray1::from_vec(py, triangles.as_flattened().to_vec()).reshape([triangles.len(), 3])
    }
}
