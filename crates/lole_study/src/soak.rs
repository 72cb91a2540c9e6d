//! Long runs in random motion: whatever the body does, the laws hold.

mod motion;

use glam::Vec3;
use lole_cloth::scenes::{ClothScene, FRAME_DT, Setup};
use lole_cloth::{
    BuildError, ClothModel, ClothState, InstructionSet, StepInput, diagnose, state_hash, step,
};
use lole_geom::Capsule;
use lole_geom::triangle_grid::TriangleGrid;
use lole_language::{Words, words};
use serde::Serialize;

use crate::bench::pins;
use motion::Motion;

/// Frames from one look at the laws to the next.
const LOOK_INTERVAL: u32 = 10;

/// Frames before the first look: some scenes start stretched, or inside their capsules.
const START_FRAMES: u32 = 60;

/// What must hold at every look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// Every position is a number.
    Finite,
    /// The 99th percentile of the structural strain is at most [`STRAIN_BOUND`].
    Strain,
    /// No free particle is deeper in a capsule than [`PENETRATION_BOUND`].
    Penetration,
    /// No triangle of the cloth is crossed by the axis of a capsule: what is on the wrong side of a
    /// limb has its axis between it and where it is held.
    Side,
}

/// Largest 99th percentile of the strain, a share. Random motion pulls with more than its weight at
/// cloth whose settings were measured for dances, which strain it below 0.05; what bursts goes far
/// beyond.
pub const STRAIN_BOUND: f32 = 0.25;

/// Deepest that a free particle may be in a capsule [m]. Particles beside pins are in capsules as
/// the pins are, which the capsules' sway carries through them.
pub const PENETRATION_BOUND: f32 = 0.06;

impl Law {
    /// What it asks.
    #[must_use]
    pub const fn about(self) -> Words {
        match self {
            Self::Finite => words("座標が有限", "positions are finite"),
            Self::Strain => words("ひずみ p99 [%]", "strain p99 [%]"),
            Self::Penetration => words("めり込み [mm]", "penetration [mm]"),
            Self::Side => words(
                "カプセルの軸が布を貫かない",
                "no capsule's axis crosses the cloth",
            ),
        }
    }
}

/// A figure at its worst.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct WorstAt {
    /// The figure.
    pub worst: f64,
    /// Frame in which it was seen first.
    pub frame: u32,
}

impl WorstAt {
    fn see(&mut self, value: f64, frame: u32) {
        if self.worst < value {
            *self = Self {
                worst: value,
                frame,
            };
        }
    }
}

/// A law that did not hold.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Violation {
    /// Which one.
    pub law: Law,
    /// Frame in which it was seen first.
    pub frame: u32,
    /// The figure there, in the law's unit.
    pub measured: f64,
    /// What it may be at most.
    pub bound: f64,
    /// Looks at which it did not hold.
    pub looks: u32,
}

/// What a soak of one scene found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SoakRow {
    /// Name of the scene.
    pub scene: &'static str,
    /// Chance of its motion.
    pub seed: u64,
    /// Frames that were run: fewer than asked for where it was interrupted, or left the numbers.
    pub frames: u32,
    /// Looks at the laws.
    pub looks: u32,
    /// Structural strain, 99th percentile [%].
    pub strain_p99_pct: WorstAt,
    /// Largest structural strain [%].
    pub strain_max_pct: WorstAt,
    /// Deepest free particle in a capsule [mm].
    pub penetration_mm: WorstAt,
    /// Most crossings of the cloth with itself; left out where it may pass through itself.
    pub self_crossings: Option<WorstAt>,
    /// Fastest that any particle was, by the root mean square of all [m/s].
    pub rms_speed_m_per_s: WorstAt,
    /// The laws that did not hold.
    pub violations: Vec<Violation>,
    /// All bits of the state at the end.
    pub state_hash: String,
}

impl SoakRow {
    fn new(scene: &ClothScene, setup: &Setup, seed: u64) -> Self {
        Self {
            scene: scene.name,
            seed,
            frames: 0,
            looks: 0,
            strain_p99_pct: WorstAt::default(),
            strain_max_pct: WorstAt::default(),
            penetration_mm: WorstAt::default(),
            self_crossings: (setup.config.self_collision).map(|_| WorstAt::default()),
            rms_speed_m_per_s: WorstAt::default(),
            violations: Vec::new(),
            state_hash: String::new(),
        }
    }

    /// Holds a figure against the bound of its law.
    fn hold(&mut self, law: Law, (measured, bound): (f64, f64), frame: u32) {
        if measured <= bound {
            return;
        }
        if let Some(known) = self.violations.iter_mut().find(|known| known.law == law) {
            known.looks += 1;
        } else {
            self.violations.push(Violation {
                law,
                frame,
                measured,
                bound,
                looks: 1,
            });
        }
    }
}

/// What is asked of a soak.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SoakSettings {
    /// Frames to run.
    pub frame_count: u32,
    /// Chance for the motion; a seed repeats its run.
    pub seed: u64,
    /// Vector instructions of the engine.
    pub instruction_set: InstructionSet,
}

/// Runs a scene in random motion for as long as `go_on` says, and looks at the laws now and then.
///
/// # Errors
/// A scene that cannot be built.
pub fn soak(
    scene: &ClothScene,
    settings: SoakSettings,
    go_on: &mut dyn FnMut(u32) -> bool,
) -> Result<SoakRow, BuildError> {
    let mut setup = (scene.build)();
    setup.config.instruction_set = settings.instruction_set;
    let model = ClothModel::new(&setup.spec)?;
    let mut state = ClothState::new(&model, &setup.positions);
    let pins = pins(&model, &setup.positions);
    let mut motion = Motion::new(settings.seed);
    let mut row = SoakRow::new(scene, &setup, settings.seed);
    while row.frames < settings.frame_count && go_on(row.frames) {
        let world = motion.next_frame();
        let pins: Vec<Vec3> = pins.iter().map(|&pin| world.place.apply(pin)).collect();
        let capsules = (scene.capsules)(world.time).into_iter();
        let capsules: Vec<Capsule> = capsules
            .map(|capsule| Capsule {
                ends: capsule.ends.map(|end| world.place.apply(end)),
                ..capsule
            })
            .collect();
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            air_velocity: world.air_velocity,
            ..StepInput::default()
        };
        step(&model, &setup.config, &input, &mut state, FRAME_DT).expect("a target for every pin");
        row.frames += 1;
        let is_due = row.frames.is_multiple_of(LOOK_INTERVAL) && START_FRAMES < row.frames;
        if is_due && !look((&setup, &model), &state, &capsules, &mut row) {
            break;
        }
    }
    row.state_hash = format!("{:016x}", state_hash(&state));
    Ok(row)
}

/// Looks at every law; whether going on makes sense.
fn look(
    (setup, model): (&Setup, &ClothModel),
    state: &ClothState,
    capsules: &[Capsule],
    row: &mut SoakRow,
) -> bool {
    let frame = row.frames;
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    state.copy_positions(model, &mut positions);
    state.copy_velocities(model, &mut velocities);
    row.looks += 1;
    if let Some(particle) = diagnose::first_non_finite(&positions) {
        #[expect(clippy::cast_precision_loss, reason = "an index is far below 2^52")]
        row.hold(Law::Finite, (particle as f64 + 1.0, 0.0), frame);
        return false;
    }
    let strain = diagnose::strain(&setup.spec, &positions);
    let [p99, max] = [strain.p99, strain.max].map(|strain| 100.0 * f64::from(strain));
    row.strain_p99_pct.see(p99, frame);
    row.strain_max_pct.see(max, frame);
    row.hold(Law::Strain, (p99, 100.0 * f64::from(STRAIN_BOUND)), frame);
    let depth = diagnose::worst_capsule_penetration(&setup.spec, &positions, capsules);
    let depth = 1e3 * f64::from(depth);
    row.penetration_mm.see(depth, frame);
    let bound = 1e3 * f64::from(PENETRATION_BOUND);
    row.hold(Law::Penetration, (depth, bound), frame);
    row.hold(
        Law::Side,
        (axes_crossed(setup, &positions, capsules), 0.0),
        frame,
    );
    let speed = f64::from(diagnose::rms_speed(&velocities));
    row.rms_speed_m_per_s.see(speed, frame);
    if let Some(most) = &mut row.self_crossings {
        let count = diagnose::self_crossings(&setup.spec.grid, &positions);
        #[expect(clippy::cast_precision_loss, reason = "a count is far below 2^52")]
        most.see(count.unwrap_or(0) as f64, frame);
    }
    true
}

/// Triangles that axes of capsules cross.
#[expect(clippy::cast_precision_loss, reason = "a count is far below 2^52")]
fn axes_crossed(setup: &Setup, positions: &[Vec3], capsules: &[Capsule]) -> f64 {
    if capsules.is_empty() {
        return 0.0;
    }
    let grid = &setup.spec.grid;
    let triangles = grid.triangles();
    let size = 2.0 * grid.spacing[0].max(grid.spacing[1]);
    let search = TriangleGrid::new(positions, &triangles, size);
    let mut crossed = Vec::new();
    let counts = capsules.iter().map(|capsule| {
        let [start, end] = capsule.ends;
        search.crossed_by(start, end, &mut crossed);
        crossed.len()
    });
    counts.sum::<usize>() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(frame_count: u32, seed: u64) -> SoakSettings {
        SoakSettings {
            frame_count,
            seed,
            instruction_set: InstructionSet::Detected,
        }
    }

    fn soaked(name: &str, seed: u64) -> SoakRow {
        let scene = crate::bench::scene(name);
        soak(scene, settings(200, seed), &mut |_| true).unwrap()
    }

    #[test]
    fn a_seed_repeats_its_soak_and_another_moves_otherwise() {
        let (first, again, other) = (soaked("skirt", 7), soaked("skirt", 7), soaked("skirt", 8));
        assert_eq!(first, again);
        assert_eq!(first.looks, 14, "at frames 70, 80 and so on");
        assert_ne!(first.state_hash, other.state_hash);
        assert_eq!(first.violations, [], "{first:?}");
    }

    #[test]
    fn a_soak_ends_when_it_is_told_to() {
        let scene = crate::bench::scene("hang-64");
        let mut go_on = |frame: u32| frame < 30;
        let row = soak(scene, settings(1000, 1), &mut go_on).unwrap();
        assert_eq!(row.frames, 30);
    }

    #[test]
    fn cloth_on_the_wrong_side_of_a_limb_and_cloth_that_is_no_number_are_seen() {
        let scene = crate::bench::scene("skirt");
        let setup = (scene.build)();
        let model = ClothModel::new(&setup.spec).unwrap();
        let capsules = (scene.capsules)(0.0);
        let state = |positions: &[Vec3]| ClothState::new(&model, positions);
        let laws = |positions: &[Vec3]| -> Vec<Law> {
            let mut row = SoakRow::new(scene, &setup, 1);
            look((&setup, &model), &state(positions), &capsules, &mut row);
            row.violations
                .iter()
                .map(|violation| violation.law)
                .collect()
        };
        assert!(!laws(&setup.positions).contains(&Law::Side));
        // The left leg stands outside of a skirt that was moved to the right.
        let moved: Vec<Vec3> = (setup.positions.iter())
            .map(|&point| point - 0.2 * Vec3::X * (-point.y).clamp(0.0, 1.0) * 2.0)
            .collect();
        assert!(laws(&moved).contains(&Law::Side));
        let mut broken = setup.positions.clone();
        broken[500].y = f32::NAN;
        assert_eq!(laws(&broken), [Law::Finite]);
    }
}
