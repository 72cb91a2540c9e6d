//! Fabrics, validation and benches as tables of Python.

use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use lole_cloth::InstructionSet;
use lole_costume::fabrics::PRESETS;
use lole_language::Sentence;
use lole_stage::validate::PROTOCOLS;
use lole_study::bench::{BenchSettings, entries};
use lole_study::{Clock, validation};
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::{objects_of, refused, wrong};

/// The machine's clocks: whoever calls from Python waits by them.
struct MachineClock(Instant, ProcessTime);

impl Clock for MachineClock {
    fn wall(&self) -> Duration {
        self.0.elapsed()
    }

    fn process(&self) -> Duration {
        self.1.elapsed()
    }
}

/// The fabrics of the shelf, in SI units.
#[pyfunction]
pub(crate) fn fabrics(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let rows = PRESETS.iter().map(|it| {
        let micro = |pair: [f64; 2]| pair.map(|rigidity| 1e-6 * rigidity);
        json!({
            "id": it.id,
            "name": it.name,
            "name_ja": it.name_ja,
            "areal_density_kg_per_m2": 1e-3 * it.areal_density.value,
            "thickness_m": 1e-3 * it.thickness.value,
            "stretch_n_per_m": it.stretch.value,
            "shear_n_per_m": it.shear.value,
            "bend_n_m": micro(it.bend.value),
            "twist_n_m": 1e-6 * it.twist.value,
            "friction_coefficient": it.friction.value,
            "source": it.source,
        })
    });
    objects_of(py, &rows.collect::<Vec<Value>>())
}

/// The engine against closed forms, a row each, as `lole validate --json` has them.
#[pyfunction]
#[pyo3(signature = (only=None))]
pub(crate) fn validate<'py>(py: Python<'py>, only: Option<&str>) -> PyResult<Bound<'py, PyAny>> {
    let wanted = |name: &str| only.is_none_or(|only| only == name);
    if !PROTOCOLS.iter().any(|protocol| wanted(protocol.name)) {
        let names: Vec<_> = PROTOCOLS.iter().map(|protocol| protocol.name).collect();
        return Err(no_such(py, only.unwrap_or_default(), &names));
    }
    let mut rows = Vec::new();
    for protocol in PROTOCOLS.iter().filter(|protocol| wanted(protocol.name)) {
        for &subject in protocol.subjects {
            py.check_signals()?;
            let checks = py.detach(|| protocol.run(subject));
            let checks = checks.map_err(|error| wrong(py, error.to_string(), error.to_string()))?;
            let of = |check| validation::row(protocol, subject, check);
            rows.extend(checks.into_iter().map(of));
        }
    }
    objects_of(py, &rows)
}

/// What a frame of a scene costs, as `lole bench --json` has it.
#[pyfunction]
#[pyo3(signature = (scene, method="xpbd"))]
#[expect(
    clippy::disallowed_methods,
    reason = "the caller's clock: a bench of Python is timed here"
)]
pub(crate) fn bench<'py>(
    py: Python<'py>,
    scene: &str,
    method: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let entries = entries();
    let asked = entries
        .iter()
        .find(|it| it.scene == scene && it.method == method);
    let Some(entry) = asked else {
        let names: Vec<_> = entries.iter().map(|it| it.scene).collect();
        return Err(no_such(py, scene, &names));
    };
    let row = py.detach(|| {
        let clock = MachineClock(Instant::now(), ProcessTime::now());
        entry.measure(BenchSettings {
            instruction_set: InstructionSet::Detected,
            roofline: false,
            clock: &clock,
        })
    });
    objects_of(
        py,
        &row.map_err(|error| wrong(py, error.to_string(), error.to_string()))?,
    )
}

fn no_such(py: Python<'_>, name: &str, names: &[&str]) -> PyErr {
    let mut names = names.to_vec();
    names.dedup();
    let list = names.join(", ");
    refused(
        py,
        &Sentence::new(
            format!("{name}: ありません。{list} から選んでください"),
            format!("{name}: there is no such one; choose one of {list}"),
        ),
    )
}
