//! Runs by the thousand, for whoever has a cluster.

use cpu_time::ThreadTime;
use lole_batch::{Batch, Missing};
use lole_files::{RunFolder, write_folder};
use lole_language::Sentence;
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;
use serde_json::json;

use crate::{objects, objects_of, path, refused, wrong};

/// A sweep in a file, performed in any order by anyone.
#[pyclass(frozen, module = "lole")]
pub(crate) struct Sweep {
    batch: Batch,
}

#[pymethods]
impl Sweep {
    /// Reads the sweep and its design, and holds every value against it.
    #[new]
    fn new(py: Python<'_>, path: &Bound<'_, PyAny>) -> PyResult<Self> {
        let path = crate::path(path)?;
        let batch = py
            .detach(|| Batch::open(&path))
            .map_err(|why| refused(py, &why))?;
        Ok(Self { batch })
    }

    fn __len__(&self) -> usize {
        usize::try_from(self.batch.plan().run_count()).unwrap_or(usize::MAX)
    }

    /// What is varied: names of columns of the table.
    #[getter]
    fn parameters(&self) -> Vec<String> {
        self.batch.plan().parameters().map(str::to_owned).collect()
    }

    /// `id`, `values` and `document` of a run, counted from 0.
    fn run<'py>(&self, py: Python<'py>, number: u64) -> PyResult<Bound<'py, PyAny>> {
        let run = self.checked(py, number)?;
        let values = self.batch.plan().parameters().zip(&run.values);
        let values: serde_json::Map<String, serde_json::Value> = values
            .map(|(name, value)| (name.to_owned(), json!(value)))
            .collect();
        objects_of(
            py,
            &json!({ "id": run.id, "values": values, "document": run.document }),
        )
    }

    /// Whether the folder holds the run.
    fn is_done(&self, py: Python<'_>, number: u64, out: &Bound<'_, PyAny>) -> PyResult<bool> {
        let run = self.checked(py, number)?;
        Ok(self
            .batch
            .record(&RunFolder::at(&path(out)?), &run)
            .is_some())
    }

    /// Performs a run unless the folder holds it, keeps it there, and gives its record.
    fn perform<'py>(
        &self,
        py: Python<'py>,
        number: u64,
        out: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let run = self.checked(py, number)?;
        let out = path(out)?;
        let record = py.detach(|| -> Result<String, Sentence> {
            let folder = RunFolder::create(&out)?;
            if let Some(record) = self.batch.record(&folder, &run) {
                return Ok(record.to_json());
            }
            let cannot = |error: rayon::ThreadPoolBuildError| {
                Sentence::new(
                    "スレッドを作れません",
                    format!("no thread can be made ({error})"),
                )
            };
            let pool = ThreadPoolBuilder::new()
                .num_threads(1)
                .build()
                .map_err(cannot)?;
            let performed = pool.install(|| {
                let started = ThreadTime::now();
                let mut done = self.batch.perform(&run, &|| true)?;
                done.record.process_seconds = started.elapsed().as_secs_f64();
                Some(done)
            });
            let Some(done) = performed else {
                return Err(Sentence::new("中止しました", "called off"));
            };
            self.batch.keep(&folder, &run, &done)?;
            Ok(done.record.to_json())
        });
        objects(py, &record.map_err(|why| refused(py, &why))?)
    }

    /// The runs that are to be performed, because the folder does not hold them; of equal runs only the first.
    fn missing(&self, py: Python<'_>, out: &Bound<'_, PyAny>) -> PyResult<Vec<u64>> {
        let folder = RunFolder::at(&path(out)?);
        Ok(py.detach(|| self.batch.due(&folder, (1, 1))))
    }

    /// Takes over runs from other folders; how many.
    fn gather(
        &self,
        py: Python<'_>,
        out: &Bound<'_, PyAny>,
        others: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<u64> {
        let out = path(out)?;
        let others = others.iter().map(|it| Ok(RunFolder::at(&path(it)?)));
        let others = others.collect::<PyResult<Vec<_>>>()?;
        py.detach(|| self.batch.gather(&RunFolder::create(&out)?, &others))
            .map_err(|why| refused(py, &why))
    }

    /// Writes `runs.csv` and `runs.parquet` into the folder; the CSV as text.
    fn write_table(&self, py: Python<'_>, out: &Bound<'_, PyAny>) -> PyResult<String> {
        let out = path(out)?;
        py.detach(|| {
            let table = self.batch.table(&RunFolder::at(&out));
            let all = self.batch.plan().run_count();
            let (table, _) = table.map_err(|missing: Missing| missing.sentence(all))?;
            let csv = table.to_csv();
            let files = [
                ("runs.csv".to_owned(), csv.clone().into_bytes()),
                ("runs.parquet".to_owned(), table.to_parquet()?),
            ];
            write_folder(&out, &files)?;
            Ok(csv)
        })
        .map_err(|why: Sentence| refused(py, &why))
    }
}

impl Sweep {
    fn checked(&self, py: Python<'_>, number: u64) -> PyResult<lole_batch::plan::Run> {
        let count = self.batch.plan().run_count();
        if number < count {
            return Ok(self.batch.run(number));
        }
        Err(wrong(
            py,
            format!(
                "{number} 番の実行はありません。0 から {} までです",
                count - 1
            ),
            format!(
                "there is no run {number}; they are numbered from 0 to {}",
                count - 1
            ),
        ))
    }
}
