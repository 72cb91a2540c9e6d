//! What the user turns: substeps, contact, self-collision.

use std::num::NonZeroU32;

use fearless_simd::Level;
use glam::Vec3;

/// Settings of the real-time method; the default holds the values measured on the scenes.
#[derive(Debug, Clone, PartialEq)]
pub struct SolverConfig {
    /// Substeps per step. More substeps mean stiffer cloth, truer motion and more work.
    pub substep_count: NonZeroU32,
    /// Substeps per step at most, for a while, where more than one part of the cloth in a hundred, an edge
    /// of a grid or a direction of a triangle's yarns, is strained by more than 6 %; no more than
    /// `substep_count` keeps to that. An assembly sets both for its pieces. With more, and with crossings that
    /// are repaired, a grid also has its strain limited at the end of a step: where more than one edge in a
    /// hundred is strained by more than 9 %, edges are brought to within 7 %, as far as none crosses by it.
    pub strained_substep_count: NonZeroU32,
    /// Passes over the structural springs in each substep. More passes mean less strain.
    pub structural_sweep_count: NonZeroU32,
    /// Passes more along the rows near those that are pinned all along, in each pass over the
    /// structural springs: where cloth is gathered, the springs are pressed most.
    pub gathered_sweep_count: u32,
    /// Acceleration of free fall [m/s²].
    pub gravity: Vec3,
    /// Distance kept between cloth and capsules [m]; hides the cloth's thickness.
    pub contact_offset: f32,
    /// Fastest a particle found inside a capsule is pushed out [m/s]; a slow push does not pop.
    pub depenetration_speed: f32,
    /// Depth [m] inside capsules in which contact leaves rows that are pinned all along, and, less
    /// with distance, their neighbors. Capsules are not the skin that carries pins; at 0 they
    /// stretch the cloth where they reach beyond it.
    pub held_depth: f32,
    /// Distances in grid cells, coarse first, over which neighbors along a row may not stretch.
    pub row_strides: Vec<u32>,
    /// Distances in grid cells, coarse first, over which neighbors down a column may not stretch.
    pub column_strides: Vec<u32>,
    /// Longest tether over its geodesic rest length; `None` leaves the cloth untethered.
    pub tether_scale: Option<f32>,
    /// Contact of the cloth with itself; `None` lets folds pass through each other.
    pub self_collision: Option<SelfCollision>,
    /// Vector instructions to use; the result has the same bits with all of them.
    pub instruction_set: InstructionSet,
}

impl Default for SolverConfig {
    fn default() -> Self {
        Self {
            substep_count: NonZeroU32::MIN.saturating_add(11),
            strained_substep_count: NonZeroU32::MIN,
            structural_sweep_count: NonZeroU32::MIN.saturating_add(5),
            gathered_sweep_count: 0,
            gravity: Vec3::new(0.0, -9.81, 0.0),
            contact_offset: 0.0,
            depenetration_speed: 2.0,
            held_depth: 0.0,
            row_strides: Vec::new(),
            column_strides: vec![4],
            tether_scale: Some(1.0),
            self_collision: None,
            instruction_set: InstructionSet::Detected,
        }
    }
}

/// Contact of the cloth with itself, and of the pieces of an assembly with each other: a sphere
/// around every particle of a grid, vertices and triangles elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelfCollision {
    /// Half of the distance that is kept [m]; two particles keep `min(2 radius, rest distance)`.
    pub radius: f32,
    /// Substeps from one solution of the contacts to the next: 1 is safest, 2 halves the work.
    pub substep_interval: NonZeroU32,
    /// What is done where edges came to cross triangles all the same.
    pub crossings: Crossings,
}

/// What the end of a step does about cloth that has gone through itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Crossings {
    /// Takes back what came to cross in the step, and draws out what crossed before: a quarter to a
    /// third of a step in gathers.
    #[default]
    Repair,
    /// Does nothing: what crosses goes on crossing.
    Leave,
}

/// Vector instructions of the processor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InstructionSet {
    /// The widest this processor has.
    #[default]
    Detected,
    /// At most eight floats at a time (AVX2), where the processor has them.
    Wide,
    /// What every processor of the architecture has (SSE2, NEON, or WebAssembly as compiled).
    Baseline,
}

impl InstructionSet {
    /// Every one, the widest first.
    pub const ALL: [Self; 3] = [Self::Detected, Self::Wide, Self::Baseline];

    /// What this processor has of it, by its usual name: two sets of the same name are the same.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.level() {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512(_) => "AVX-512",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2(_) => "AVX2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse4_2(_) => "SSE4.2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse2(_) => "SSE2",
            #[cfg(target_arch = "aarch64")]
            Level::Neon(_) => "NEON",
            _ => "as compiled",
        }
    }

    pub(crate) fn level(self) -> Level {
        match self {
            Self::Detected => Level::new(),
            Self::Wide => wide_level(),
            Self::Baseline => Level::baseline(),
        }
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn wide_level() -> Level {
    Level::new().as_avx2().map_or(Level::new(), Level::Avx2)
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn wide_level() -> Level {
    Level::new()
}
