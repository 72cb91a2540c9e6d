//! From a run of a scene to its row of the table.

use lole_cloth::diagnose::StrainSummary;
use lole_export::report::{MeanPercentileMax, MedianPercentile, Worst};
use serde::Serialize;

use super::phases::PhaseTime;
use super::roofline::SpringRoofline;
use crate::Timing;
use crate::figures::{median_and_p99, percent};

/// Frame from which the cloth may not cross itself: some scenes start so tightly folded that it
/// does.
const CROSSINGS_FROM: u32 = 30;

/// One scene on this machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BenchRow {
    /// Name of the scene.
    pub scene: &'static str,
    /// Name of the method.
    pub method: &'static str,
    /// Particles of its cloth.
    pub particles: usize,
    /// Substeps of a frame; the median where they follow the cloth.
    pub substeps: u32,
    /// Threads of the simulation.
    pub threads: usize,
    /// Processor time of a frame, all threads [ms].
    pub frame_ms: MedianPercentile,
    /// Wall time of a frame [ms].
    pub frame_wall_ms: MedianPercentile,
    /// Processor time of a median frame over that of the reference row in the same run.
    pub ratio_to_reference: Option<f64>,
    /// Processor time for one particle in one substep [ns].
    pub particle_substep_ns: f64,
    /// Where the time of a frame goes, in the order of its phases; left out where the method has
    /// none.
    pub phases: Option<Vec<PhaseTime>>,
    /// The structural springs against the best that this machine can do; left out unless asked for.
    pub spring_roofline: Option<SpringRoofline>,
    /// Whether every position is a number at the end; where not, the other figures say little.
    pub finite: bool,
    /// Absolute structural strain at the end [%].
    pub strain_end_pct: MeanPercentileMax,
    /// Its worst from the seventh frame on [%].
    pub strain_worst_pct: MeanPercentileMax,
    /// Deepest free particle, over the run, in the body that the cloth meets: capsules, or the skin.
    pub penetration_mm: Worst<f64>,
    /// Deepest particle below the drawn skin over the run; left out where there is no skin.
    pub skin_penetration_mm: Option<Worst<f64>>,
    /// Edges of the cloth that cross one of its triangles, most of any frame from
    /// the 31st on; left out where the cloth may pass through itself, and where its
    /// positions are not finite.
    pub self_crossings: Option<usize>,
    /// Particles on the wrong side of the layer below them, most of any frame; left out where there
    /// are no layers.
    pub layer_inversions: Option<usize>,
    /// Root mean square of the particles' speeds at the end [m/s]; left out where a garment of triangles is worn.
    pub rms_speed_m_per_s: Option<f64>,
    /// Memory of the prepared cloth and its state; left out where a garment of triangles is worn.
    pub bytes_per_particle: Option<f64>,
    /// All bits of the state at the end.
    pub state_hash: String,
}

impl BenchRow {
    /// Says how its frames compare with those of a reference.
    pub fn compare(&mut self, reference: &Self) {
        self.ratio_to_reference = Some(self.frame_ms.median / reference.frame_ms.median);
    }

    /// Whether it is the same scene by the same method.
    #[must_use]
    pub fn is_of(&self, entry: &super::Entry) -> bool {
        self.scene == entry.scene && self.method == entry.method
    }

    /// The phase that takes most of the time.
    #[must_use]
    pub fn longest_phase(&self) -> Option<&'static str> {
        let phases = self.phases.as_ref()?.iter();
        let longest = phases.max_by(|a, b| a.share_pct.total_cmp(&b.share_pct))?;
        Some(longest.name)
    }
}

/// What a run leaves, in the units of the engine.
pub(super) struct Run {
    pub(super) scene: &'static str,
    pub(super) method: &'static str,
    pub(super) particles: usize,
    pub(super) substeps: u32,
    /// Of every frame that nobody observed.
    pub(super) timings: Vec<Timing>,
    pub(super) phases: Option<Vec<PhaseTime>>,
    pub(super) spring_roofline: Option<SpringRoofline>,
    pub(super) finite: bool,
    pub(super) strain_end: StrainSummary,
    pub(super) strain_worst: StrainSummary,
    /// [m]
    pub(super) penetration: f32,
    /// [m]
    pub(super) skin_penetration: Option<f32>,
    pub(super) crossings: Option<Crossings>,
    pub(super) layer_inversions: Option<usize>,
    /// [m/s]
    pub(super) rms_speed: Option<f32>,
    pub(super) byte_count: Option<usize>,
    pub(super) state_hash: u64,
}

impl Run {
    /// Its row.
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
    pub(super) fn row(self) -> BenchRow {
        let times = |seconds: fn(&Timing) -> f64| -> Vec<f64> {
            (self.timings.iter())
                .map(|timing| 1e3 * seconds(timing))
                .collect()
        };
        let frame_ms = median_and_p99(&times(|timing| timing.process_seconds));
        let count = self.particles as f64;
        let worst_mm = |depth: f32| Worst {
            worst: 1e3 * f64::from(depth),
        };
        BenchRow {
            scene: self.scene,
            method: self.method,
            particles: self.particles,
            substeps: self.substeps,
            threads: rayon::current_num_threads(),
            frame_ms,
            frame_wall_ms: median_and_p99(&times(|timing| timing.wall_seconds)),
            ratio_to_reference: None,
            particle_substep_ns: 1e6 * frame_ms.median / (count * f64::from(self.substeps)),
            phases: self.phases,
            spring_roofline: self.spring_roofline,
            finite: self.finite,
            strain_end_pct: percent(self.strain_end),
            strain_worst_pct: percent(self.strain_worst),
            penetration_mm: worst_mm(self.penetration),
            skin_penetration_mm: self.skin_penetration.map(worst_mm),
            self_crossings: self.crossings.and_then(Crossings::most),
            layer_inversions: self.layer_inversions,
            rms_speed_m_per_s: self.rms_speed.map(f64::from),
            bytes_per_particle: self.byte_count.map(|it| it as f64 / count),
            state_hash: format!("{:016x}", self.state_hash),
        }
    }
}

/// How often the cloth crosses itself, at worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Crossings {
    /// `None` once there was no answer.
    most: Option<usize>,
}

impl Crossings {
    /// None yet.
    pub(super) const fn none() -> Self {
        Self { most: Some(0) }
    }

    /// Looks at what was counted in a frame: nothing, where positions were not finite.
    pub(super) fn see(&mut self, frame: u32, count: impl FnOnce() -> Option<usize>) {
        if CROSSINGS_FROM <= frame {
            self.most = (self.most)
                .zip(count())
                .map(|(most, count)| most.max(count));
        }
    }

    const fn most(self) -> Option<usize> {
        self.most
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_counted_once_has_no_most() {
        let mut crossings = Crossings::none();
        crossings.see(0, || Some(90));
        assert_eq!(crossings.most(), Some(0), "the start does not count");
        for count in [3, 7, 5] {
            crossings.see(CROSSINGS_FROM, || Some(count));
        }
        assert_eq!(crossings.most(), Some(7));
        crossings.see(CROSSINGS_FROM, || None);
        crossings.see(CROSSINGS_FROM, || Some(9));
        assert_eq!(crossings.most(), None);
    }
}
