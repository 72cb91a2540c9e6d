//! Scenes with a dancer: what a whole frame of the product costs.

use lole_cloth::{Phase, diagnose};
use lole_costume::document::Design;
use lole_stage::{Performance, Production, RunMetrics, StageError, double_pau};

use super::BenchSettings;
use super::phases::PhaseClock;
use super::row::{BenchRow, Crossings, Run};
use crate::Timing;

/// One skirt on one dancer.
pub(super) struct StageScene {
    pub(super) name: &'static str,
    /// What is in it.
    pub(super) about: &'static str,
    frame_count: u32,
    pub(super) design: fn() -> Design,
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
        about: "a pāʻū skirt of 28,160 particles on a dancer",
        frame_count: 300,
        design: Design::default,
    },
    StageScene {
        name: "pau-layers",
        about: "a double pāʻū and a top, 41,408 particles on a dancer",
        frame_count: 300,
        design: double_pau,
    },
];

/// A scene's dancer, settled and about to dance.
fn settled(design: &Design, settings: BenchSettings<'_>) -> Result<Performance, StageError> {
    let mut performance = Performance::new(Production::new(design)?)?;
    performance.set_instruction_set(settings.instruction_set);
    // What stops short is seen in the figures of the frames.
    while performance.time() < 0.0 && performance.advance().is_ok() {}
    Ok(performance)
}

/// Dances a scene twice with the same bits: once for its times, with nothing between the frames that
/// would empty the caches, and once for what the cloth does in every frame. Timed is all that a
/// frame needs before it can be drawn: pose, capsules, pins and cloth.
pub(super) fn measure(
    scene: &StageScene,
    design: &Design,
    settings: BenchSettings<'_>,
) -> Result<BenchRow, StageError> {
    let (timings, clock, hash) = time(scene, settled(design, settings)?, settings);
    let mut judged = settled(design, settings)?;
    let (mut metrics, mut crossings) = (Vec::new(), Crossings::none());
    let mut inversions = 0;
    for _ in 0..scene.frame_count {
        let went_on = judged.advance().is_ok();
        judged.pose_body();
        metrics.push(judged.measure());
        // A skirt that has settled crosses itself no more than one that dances.
        crossings.see(u32::MAX, || self_crossings(&judged));
        inversions = inversions.max(judged.layer_inversions());
        if !went_on {
            break;
        }
    }
    debug_assert_eq!(judged.state_hash(), hash, "{}", scene.name);
    let worst = RunMetrics::of(&metrics);
    let run = Run {
        scene: scene.name,
        method: judged.production().design.method.name.id(),
        particles: judged.production().particle_count(),
        substeps: judged.substep_count(),
        timings,
        phases: clock.times(),
        spring_roofline: None,
        finite: diagnose::first_non_finite(judged.cloth_positions()).is_none(),
        strain_end: worst.strain_end,
        strain_worst: worst.strain,
        penetration: worst.capsule_penetration.max(worst.skin.worst_depth),
        skin_penetration: Some(worst.skin.worst_depth),
        crossings: Some(crossings),
        layer_inversions: (1 < judged.production().garments.len()).then_some(inversions),
        rms_speed: judged.rms_speed(),
        byte_count: judged.byte_count(),
        state_hash: judged.state_hash(),
    };
    Ok(run.row())
}

/// Times of the frames of a scene, of their phases, and the bits that it ends with.
fn time<'a>(
    scene: &StageScene,
    mut performance: Performance,
    settings: BenchSettings<'a>,
) -> (Vec<Timing>, PhaseClock<'a>, u64) {
    let (mut timings, mut clock) = (Vec::new(), PhaseClock::new(settings.clock));
    for frame in 0..scene.frame_count {
        if !advance(&mut performance, frame, &mut timings, &mut clock) {
            break;
        }
    }
    (timings, clock, performance.state_hash())
}

/// The next frame, timed or observed; whether the dance goes on.
fn advance(
    performance: &mut Performance,
    frame: u32,
    timings: &mut Vec<Timing>,
    clock: &mut PhaseClock<'_>,
) -> bool {
    if PhaseClock::observes(frame) {
        clock.begin_frame();
        let advanced = performance.advance_observed(&mut |phase| clock.passed(phase));
        clock.passed(Phase::Outside);
        return advanced.is_ok();
    }
    let watch = clock.stopwatch();
    let advanced = performance.advance();
    timings.push(watch.read());
    advanced.is_ok()
}

/// Edges of a garment that cross a triangle of the same one, of all garments.
fn self_crossings(performance: &Performance) -> Option<usize> {
    let crossings = performance.production().garments.iter().map(|garment| {
        let grid = &garment.sewn.spec.grid;
        diagnose::self_crossings(grid, performance.garment_positions(garment))
    });
    crossings.sum()
}
