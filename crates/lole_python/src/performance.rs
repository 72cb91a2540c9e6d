//! A performance, stepped or run.

use lole_costume::document::Design as Document;
use lole_stage::{Divergence, FRAMES_PER_SECOND, Production};
use numpy::{
    PyArray1, PyArray2, PyArray3, PyArrayMethods as _, PyReadwriteArray2,
    PyUntypedArrayMethods as _,
};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde_json::json;

use crate::design::Design;
use crate::{Diverged, array, in_both, objects_of, refused, wrong};

/// Longest dance [s], as of the command.
const MOST_SECONDS: f64 = 600.0;

/// A dancer in what she wears, moved on by frames of 1/60 s.
#[pyclass(module = "lole")]
pub(crate) struct Performance {
    stage: lole_stage::Performance,
    pool: ThreadPool,
}

#[pymethods]
impl Performance {
    /// Drafts, sews and dresses. The result is the same on any number of threads.
    #[new]
    #[pyo3(signature = (design=None, *, threads=1))]
    fn new(py: Python<'_>, design: Option<PyRef<'_, Design>>, threads: usize) -> PyResult<Self> {
        Self::on_stage(py, design.as_deref(), threads)
    }

    /// Time of the dance [s]; negative while the cloth settles.
    #[getter]
    fn time(&self) -> f32 {
        self.stage.time()
    }

    /// Begin and end of each gathered garment's particles in `positions`.
    #[getter]
    fn garments(&self) -> Vec<(String, (usize, usize))> {
        let garments = self.stage.production().garments.iter();
        garments
            .map(|it| (it.name.clone(), (it.particles.start, it.particles.end)))
            .collect()
    }

    /// All bits of the cloth as 16 hexadecimal digits.
    #[getter]
    fn state_hash(&self) -> String {
        self.hash()
    }

    /// Lets the cloth come to rest on the standing dancer: at most three seconds, to time 0.
    pub(crate) fn settle(&mut self, py: Python<'_>) -> PyResult<()> {
        while self.stage.time() < 0.0 {
            py.check_signals()?;
            self.advance(py)?;
        }
        Ok(())
    }

    /// Moves on by so many frames.
    #[pyo3(signature = (frames=1))]
    fn step(&mut self, py: Python<'_>, frames: u32) -> PyResult<()> {
        for _ in 0..frames {
            py.check_signals()?;
            self.advance(py)?;
        }
        Ok(())
    }

    /// Dances so long [s], and gives the positions of every so many frames [m], shape
    /// `[pictures, particles, 3]`; `callback` is called after each frame, and ends the dance by returning
    /// `False`.
    #[pyo3(signature = (seconds, *, every=2, callback=None))]
    fn run<'py>(
        slf: &Bound<'py, Self>,
        seconds: f64,
        every: u32,
        callback: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let py = slf.py();
        if !(0.0..=MOST_SECONDS).contains(&seconds) || every == 0 {
            return Err(wrong(
                py,
                "seconds は 0 から 600、every は 1 以上にしてください",
                "run: give seconds from 0 to 600, and every from 1 on",
            ));
        }
        slf.borrow_mut().settle(py)?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most 600 seconds"
        )]
        let frames = (seconds * f64::from(FRAMES_PER_SECOND)).round() as u32;
        let mut numbers: Vec<f32> = Vec::new();
        let (mut pictures, particles) = (0, slf.borrow().stage.particles().count());
        for frame in 1..=frames {
            py.check_signals()?;
            slf.borrow_mut().advance(py)?;
            if frame % every == 0 {
                let performance = slf.borrow();
                numbers.extend(performance.stage.particles().flat_map(|it| it.to_array()));
                pictures += 1;
            }
            if let Some(callback) = callback
                && callback
                    .call1((slf,))?
                    .is(&*pyo3::types::PyBool::new(py, false))
            {
                break;
            }
        }
        // The array owns these numbers: nothing is copied.
        PyArray1::from_vec(py, numbers).reshape([pictures, particles, 3])
    }

    /// Where every particle of the cloth is now [m], shape `[particles, 3]`: a copy, because the cloth moves on
    /// under a view.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let places: Vec<glam::Vec3> = self.stage.particles().copied().collect();
        array(py, &places)
    }

    /// The same, into an array of one's own of that shape: nothing is allocated.
    fn positions_into(&self, py: Python<'_>, mut out: PyReadwriteArray2<'_, f32>) -> PyResult<()> {
        let count = self.stage.particles().count();
        if out.shape() != [count, 3] {
            return Err(wrong(
                py,
                format!("out は形 [{count}, 3] の float32 にしてください"),
                format!("out: give a float32 array of shape [{count}, 3]"),
            ));
        }
        for (mut row, place) in out
            .as_array_mut()
            .outer_iter_mut()
            .zip(self.stage.particles())
        {
            for (to, from) in row.iter_mut().zip(place.to_array()) {
                *to = from;
            }
        }
        Ok(())
    }

    /// Vertices of the posed skin [m], shape `[vertices, 3]`.
    fn body_positions<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        self.stage.pose_body();
        array(py, self.stage.body_positions())
    }

    /// This frame in numbers: strain in percent, depth in the skin in mm, height of the hem in cm.
    fn measure<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.stage.pose_body();
        let found = self.stage.measure();
        let percent = |share: f32| 100.0 * f64::from(share);
        let numbers = json!({
            "time_s": found.time,
            "strain_mean_pct": percent(found.strain.mean),
            "strain_p99_pct": percent(found.strain.p99),
            "strain_worst_pct": percent(found.strain.max),
            "skin_depth_mm": 1e3 * f64::from(found.skin.worst_depth),
            "hem_height_cm": percent(found.hem_height),
        });
        objects_of(py, &numbers)
    }
}

impl Performance {
    /// Drafts, sews and dresses.
    pub(crate) fn on_stage(
        py: Python<'_>,
        design: Option<&Design>,
        threads: usize,
    ) -> PyResult<Self> {
        if !(1..=256).contains(&threads) {
            return Err(wrong(
                py,
                "threads は 1 から 256 までの整数にしてください",
                "threads: give a whole number from 1 to 256",
            ));
        }
        let document = design.map_or_else(Document::default, |it| it.document.clone());
        let stage = py.detach(|| Production::new(&document).and_then(lole_stage::Performance::new));
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        Ok(Self {
            stage: stage.map_err(|error| refused(py, &error))?,
            pool: pool.map_err(|error| wrong(py, "スレッドを作れません", error.to_string()))?,
        })
    }

    /// Particles that move.
    pub(crate) fn particle_count(&self) -> usize {
        self.stage.production().moving_count()
    }

    /// All bits of the cloth.
    pub(crate) fn hash(&self) -> String {
        format!("{:016x}", self.stage.state_hash())
    }

    /// One frame, without Python's lock.
    pub(crate) fn advance(&mut self, py: Python<'_>) -> PyResult<()> {
        let Self { stage, pool } = self;
        let result = py.detach(|| pool.install(|| stage.advance()));
        result.map_err(|Divergence { time, row, column, .. }| {
            let error = Diverged::new_err(format!(
                "the cloth diverged at {time:.2} s at row {row} column {column}; raise [method] substep_count, or lower [motion] tempo_bpm"
            ));
            let japanese = format!(
                "{time:.2} 秒に {row} 行 {column} 列で布の計算が発散しました。[method] substep_count を増やすか、[motion] tempo_bpm を下げてください"
            );
            in_both(py, error, &japanese)
        })
    }
}
