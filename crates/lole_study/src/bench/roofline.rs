//! The structural springs against the best that this machine can do.

use lole_cloth::roofline::{BYTES_PER_SPRING, FLOPS_PER_SPRING, SpringStream};
use lole_cloth::{ClothSpec, SolverConfig};
use serde::Serialize;

use super::BenchSettings;
use crate::Stopwatch;

/// Shortest time that is measured at once [s], and how often: the least of them counts, because
/// other programs only ever add.
const CHUNK_SECONDS: f64 = 1e-3;
const CHUNK_COUNT: u32 = 40;

/// Springs of a scene, and springs that wait for nothing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpringRoofline {
    /// Time of one structural spring in the scene [ns].
    pub spring_ns: f64,
    /// Time of one spring of a stream of as many particles: the same arithmetic and bytes.
    pub best_spring_ns: f64,
    /// Operations in a second of that stream [10⁹/s].
    pub best_gflops: f64,
    /// What it reads and writes [10⁹ byte/s].
    pub best_gbytes_per_s: f64,
    /// Speed of the scene's springs, of the stream's [%].
    pub reached_pct: f64,
}

impl SpringRoofline {
    /// Holds the springs of a cloth, which take `seconds` of a frame, against the stream.
    pub(super) fn measure(
        (spec, config): (&ClothSpec, &SolverConfig),
        seconds: f64,
        settings: BenchSettings<'_>,
    ) -> Self {
        let solved = f64::from(config.substep_count.get())
            * f64::from(config.structural_sweep_count.get())
            * spring_count(spec);
        let (spring_ns, best) = (
            1e9 * seconds / solved,
            best_spring_ns(spec.grid.particle_count(), settings),
        );
        Self {
            spring_ns,
            best_spring_ns: best,
            best_gflops: f64::from(FLOPS_PER_SPRING) / best,
            best_gbytes_per_s: f64::from(BYTES_PER_SPRING) / best,
            reached_pct: 100.0 * best / spring_ns,
        }
    }
}

/// Structural springs with a free end.
fn spring_count(spec: &ClothSpec) -> f64 {
    let (grid, mut count) = (&spec.grid, 0_u32);
    for row in 0..grid.row_count {
        for column in 0..grid.column_count {
            let is_pinned = |row: u32, column: u32| spec.pinned[grid.index(row, column)];
            let held = is_pinned(row, column);
            let right = grid.column_right(column, 1);
            count += u32::from(right.is_some_and(|right| !(held && is_pinned(row, right))));
            count += u32::from(row + 1 < grid.row_count && !(held && is_pinned(row + 1, column)));
        }
    }
    f64::from(count)
}

/// Least time of a spring that waits for nothing [ns].
#[expect(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
fn best_spring_ns(particle_count: usize, settings: BenchSettings<'_>) -> f64 {
    let mut stream = SpringStream::new(particle_count);
    let mut best = f64::INFINITY;
    for _ in 0..CHUNK_COUNT {
        let watch = Stopwatch::start(settings.clock);
        let (mut passes, mut seconds) = (0_u32, 0.0);
        while seconds < CHUNK_SECONDS {
            (0..8).for_each(|_| stream.pass(settings.instruction_set));
            passes += 8;
            seconds = watch.read_wall();
        }
        best = best.min(1e9 * seconds / (f64::from(passes) * stream.spring_count() as f64));
    }
    if stream.is_finite() { best } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_cloth::scenes::SCENES;

    #[test]
    fn springs_between_pins_do_not_count() {
        let scene = SCENES.iter().find(|scene| scene.name == "skirt").unwrap();
        // 63 free rings of 128, and 63 rows of 128 between rows.
        let count = spring_count(&(scene.build)().spec);
        assert_eq!(count, f64::from(2 * 63 * 128));
    }
}
