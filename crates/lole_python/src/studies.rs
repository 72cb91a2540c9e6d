//! Fabrics, validation and benches as tables of Python.

use std::time::Instant;

use cpu_time::ProcessTime;
use lole_costume::fabrics::PRESETS;
use lole_language::Sentence;
use lole_stage::validate::PROTOCOLS;
use pyo3::prelude::*;
use serde_json::{Value, json};

use crate::design::Design;
use crate::performance::Performance;
use crate::{objects_of, refused, wrong};

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

/// The engine against closed forms, a row each: what was measured, its reference and its bounds.
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
            rows.extend(checks.into_iter().map(|check| {
                json!({
                    "name": protocol.name,
                    "method": subject.id(),
                    "case": check.case,
                    "measured": check.measured,
                    "reference": check.reference,
                    "unit": check.unit,
                    "bounds": check.bounds(),
                    "pass": check.passes(),
                })
            }));
        }
    }
    objects_of(py, &rows)
}

/// What a frame of a design costs on this machine, once it has settled.
#[pyfunction]
#[pyo3(signature = (design=None, *, frames=120, threads=1))]
#[expect(
    clippy::disallowed_methods,
    reason = "the caller's clock: a bench of Python is timed here"
)]
pub(crate) fn bench<'py>(
    py: Python<'py>,
    design: Option<PyRef<'py, Design>>,
    frames: u32,
    threads: usize,
) -> PyResult<Bound<'py, PyAny>> {
    if !(1..=36_000).contains(&frames) {
        return Err(wrong(
            py,
            "frames は 1 から 36000 までの整数にしてください",
            "frames: give a whole number from 1 to 36000",
        ));
    }
    let mut performance = Performance::on_stage(py, design.as_deref(), threads)?;
    performance.settle(py)?;
    let (mut wall, mut process) = (Vec::new(), Vec::new());
    for _ in 0..frames {
        py.check_signals()?;
        let (at, spent) = (Instant::now(), ProcessTime::now());
        performance.advance(py)?;
        process.push(1e3 * spent.elapsed().as_secs_f64());
        wall.push(1e3 * at.elapsed().as_secs_f64());
    }
    let row = json!({
        "particles": performance.particle_count(),
        "threads": threads,
        "frames": frames,
        "frame_ms": spread(process),
        "frame_wall_ms": spread(wall),
        "state_hash": performance.hash(),
    });
    objects_of(py, &row)
}

/// Median and 99th percentile: entries `n/2` and `99 n/100` of the sorted values.
fn spread(mut values: Vec<f64>) -> Value {
    values.sort_by(f64::total_cmp);
    json!({ "median": values[values.len() / 2], "p99": values[values.len() * 99 / 100] })
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
