//! Scenes with a dancer: what a whole frame of the product costs.

use lole_cloth::InstructionSet;
use lole_cloth::diagnose;
use lole_costume::document::{Design, GarmentDesign, WornSkirt, WornTop};
use lole_export::report::Worst;
use lole_stage::{Performance, Production, RunMetrics, StageError};

use super::BenchRow;
use crate::figures::{median_and_p99, percent};
use crate::stopwatch::Stopwatch;

/// One skirt on one dancer.
pub(super) struct StageScene {
    pub(super) name: &'static str,
    frame_count: u32,
    design: fn() -> Design,
}

impl StageScene {
    /// The method that moves its cloth.
    pub(super) fn method(&self) -> &'static str {
        (self.design)().method.name.id()
    }
}

/// Every scene with a dancer.
pub(super) const SCENES: &[StageScene] = &[
    StageScene {
        name: "pau-fine",
        frame_count: 300,
        design: Design::default,
    },
    StageScene {
        name: "pau-layers",
        frame_count: 300,
        design: double_pau,
    },
];

/// A double pāʻū and a top, of 40,000 particles: a plain underskirt, the print skirt over it, shorter,
/// and the top over its band.
fn double_pau() -> Design {
    let mut design = Design::default();
    design.skirt.hem_height_cm = 34.0;
    design.skirt.gather_ratio = 3.0;
    (design.skirt.column_count, design.skirt.row_count) = (480, 36);
    design.garments = vec![
        GarmentDesign::PauSkirt(WornSkirt::default()),
        GarmentDesign::PauTop(WornTop::default()),
    ];
    design
}

/// Dances a scene, settled beforehand. Measured is all that a frame needs before it can be drawn:
/// pose, capsules, pins and cloth.
pub(super) fn measure(scene: &StageScene, set: InstructionSet) -> Result<BenchRow, StageError> {
    let mut performance = Performance::new(Production::new(&(scene.design)())?)?;
    performance.set_instruction_set(set);
    let (mut process, mut wall, mut metrics) = (Vec::new(), Vec::new(), Vec::new());
    let (mut crossings, mut inversions) = (0, 0);
    // What stops short is seen in the figures of the frames.
    while performance.time() < 0.0 && performance.advance().is_ok() {}
    for _ in 0..scene.frame_count {
        let watch = Stopwatch::start();
        let went_on = performance.advance().is_ok();
        let timing = watch.read();
        process.push(1e3 * timing.process_seconds);
        wall.push(1e3 * timing.wall_seconds);
        performance.pose_body();
        metrics.push(performance.measure());
        crossings = crossings.max(self_crossings(&performance));
        inversions = inversions.max(performance.layer_inversions());
        if !went_on {
            break;
        }
    }
    let particles = performance.production().particle_count();
    let substeps = performance.substep_count();
    let frame_ms = median_and_p99(&process);
    let worst = RunMetrics::of(&metrics);
    #[expect(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
    let (count, bytes) = (particles as f64, performance.byte_count() as f64);
    Ok(BenchRow {
        scene: scene.name,
        method: performance.production().design.method.name.id(),
        particles,
        substeps,
        threads: rayon::current_num_threads(),
        frame_ms,
        frame_wall_ms: median_and_p99(&wall),
        particle_substep_ns: 1e6 * frame_ms.median / (count * f64::from(substeps)),
        strain_end_pct: percent(worst.strain_end),
        strain_worst_pct: percent(worst.strain),
        penetration_mm: Worst {
            worst: 1e3 * f64::from(worst.capsule_penetration.max(worst.skin.worst_depth)),
        },
        skin_penetration_mm: Some(Worst {
            worst: 1e3 * f64::from(worst.skin.worst_depth),
        }),
        self_crossings: Some(crossings),
        layer_inversions: (1 < performance.production().garments.len()).then_some(inversions),
        rms_speed_m_per_s: f64::from(performance.rms_speed()),
        bytes_per_particle: bytes / count,
        state_hash: format!("{:016x}", performance.state_hash()),
    })
}

/// Edges of a garment that cross a triangle of the same one, of all garments.
fn self_crossings(performance: &Performance) -> usize {
    let crossings = performance.production().garments.iter().map(|garment| {
        let grid = &garment.sewn.spec.grid;
        diagnose::self_crossings(grid, performance.garment_positions(garment))
    });
    let sum = crossings.sum::<Option<usize>>();
    sum.unwrap_or(usize::MAX)
}
