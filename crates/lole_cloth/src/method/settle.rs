//! Static drape: the real-time method with kinetic damping, until no force is left unbalanced.
//!
//! Dynamic relaxation with kinetic damping (Barnes 1999, "Form finding and analysis of tension
//! structures by dynamic relaxation"): the cloth moves undamped until its energy of motion has
//! passed a peak, where potential energy is near its least along the way; there it is brought to a
//! stop and let go again. A swing that would go to and fro for seconds costs a quarter of its
//! period, and no constant has to be tuned to the cloth's frequencies.
//!
//! Every stop is also a measurement. A particle let go from rest at which the accelerations `a` do
//! not balance has come `d = ½ a t²` after the time `t`, so `2 |d| / (t² g)` is what is left
//! unbalanced at it, per weight, contact and friction included, with the contacts' trembling taken
//! out by the time `t`. At the peak of a swing that began with the acceleration `a` this reads
//! `8 / π² = 0.81 a`. A residual `r` says how near the rest is: a pendulum of length `L` with it
//! hangs `r L` beside its rest, so 0.004 is 4 mm for a skirt of a meter.

use std::ops::ControlFlow;

use glam::Vec3;

use crate::Lost;
use crate::model::particle_masses;
use crate::{ClothModel, ClothSpec, ClothState, SolverConfig, StepInput, step};

/// Unit of the residual [m/s²].
pub const STANDARD_GRAVITY: f32 = 9.81;

/// Frames that the cloth flies at least before it is stopped: with fewer the trembling of contacts
/// passes for a peak, and is divided by a short time squared.
const SHORTEST_FLIGHT: u32 = 4;

/// Share of its velocity that the cloth keeps from frame to frame while it is lowered.
const LOWERING: f32 = 0.6;

/// When a drape is done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettleConfig {
    /// Duration of a frame [s], divided by the substeps of the [`SolverConfig`].
    pub dt: f32,
    /// Root mean square of the unbalanced forces per weight at which the cloth is at rest. Half of
    /// it costs about a fifth more frames; below 0.002 gathers that touch each other never come.
    pub residual: f32,
    /// Frames after which it is given up.
    pub frame_limit: u32,
    /// First frames, in which the cloth is lowered as by a hand, because a fall lays folds flat on
    /// each other. Without them gathers cross each other; twice as many cost as many frames.
    pub lowering_frame_count: u32,
}

impl Default for SettleConfig {
    fn default() -> Self {
        Self {
            dt: 1.0 / 60.0,
            residual: 0.004,
            frame_limit: 600,
            lowering_frame_count: 15,
        }
    }
}

/// How far a drape has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettleProgress {
    /// Frames done.
    pub frame: u32,
    /// Root mean square, by mass, of the free particles' displacements in the last frame over its
    /// duration [m/s].
    pub speed: f32,
    /// Unbalanced force per weight at the last stop; `None` before the first.
    pub residual: Option<f32>,
}

/// How a drape ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drape {
    /// At rest: what is unbalanced is at most what was asked for.
    Settled {
        /// Unbalanced force per weight, root mean square by mass.
        residual: f32,
        /// Frames it took.
        frame_count: u32,
    },
    /// The frames were used up.
    GivenUp {
        /// That of the last stop; `None` where the cloth never came to one.
        residual: Option<f32>,
    },
    /// The callback broke it off.
    Interrupted {
        /// Frames done until then.
        frame_count: u32,
    },
}

/// Brings the cloth to rest where pins, capsules and air of `input` stand still; `report` hears of
/// every frame and may break it off, which leaves the cloth as it is then.
///
/// The shape at rest is that of [`step()`] with the same `config`: of the stiffness that its
/// substeps give, with its contacts and its friction. More substeps make it truer and slower.
///
/// # Errors
/// A state of another cloth, or as many targets as there are not pins.
pub fn settle(
    model: &ClothModel,
    (config, settle): (&SolverConfig, &SettleConfig),
    input: &StepInput<'_>,
    state: &mut ClothState,
    mut report: impl FnMut(SettleProgress) -> ControlFlow<()>,
) -> Result<Drape, Lost> {
    let mut positions = Vec::new();
    state.copy_positions(model, &mut positions);
    state.scale_velocities(0.0);
    let mut settling = Settling::new(model.spec(), *settle, &positions);
    loop {
        step(model, config, input, state, settle.dt)?;
        state.copy_positions(model, &mut positions);
        let verdict = settling.judge(&positions);
        if let Some(kept) = verdict.kept {
            state.scale_velocities(kept);
        }
        if let Some(end) = verdict.end {
            return Ok(end);
        }
        if report(settling.progress()).is_break() {
            let frame_count = settling.progress().frame;
            return Ok(Drape::Interrupted { frame_count });
        }
    }
}

/// What becomes of the velocities after a frame, and whether it was the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// Share of the velocities that the cloth keeps; all where `None`.
    pub kept: Option<f32>,
    /// How the drape ended, if it did.
    pub end: Option<Drape>,
}

/// Kinetic damping for whoever takes the frames himself, by whatever method.
#[derive(Debug, Clone, PartialEq)]
pub struct Settling {
    config: SettleConfig,
    /// Share of each particle in the cloth's free mass.
    shares: Vec<f32>,
    /// Positions after the last frame, and where the flight began [m].
    last: Vec<Vec3>,
    start: Vec<Vec3>,
    /// Frames since the flight began.
    flight: u32,
    progress: SettleProgress,
}

impl Settling {
    /// Begins with the cloth at rest at `positions` [m], row-major.
    ///
    /// # Panics
    /// When `positions` has another length than the grid has particles.
    #[must_use]
    pub fn new(spec: &ClothSpec, config: SettleConfig, positions: &[Vec3]) -> Self {
        let mut shares = particle_masses(spec);
        assert_eq!(shares.len(), positions.len(), "one position a particle");
        for (share, &pinned) in shares.iter_mut().zip(&spec.pinned) {
            *share = if pinned { 0.0 } else { *share };
        }
        let mass: f32 = shares.iter().sum();
        if 0.0 < mass {
            shares.iter_mut().for_each(|share| *share /= mass);
        }
        Self {
            config,
            shares,
            last: positions.to_vec(),
            start: positions.to_vec(),
            flight: 0,
            progress: SettleProgress {
                frame: 0,
                speed: 0.0,
                residual: None,
            },
        }
    }

    /// How far it has come.
    #[must_use]
    pub const fn progress(&self) -> SettleProgress {
        self.progress
    }

    /// Looks at the cloth after one more frame, at `positions` [m].
    ///
    /// # Panics
    /// When the number of positions has changed.
    #[must_use = "the velocities must be changed as it says"]
    pub fn judge(&mut self, positions: &[Vec3]) -> Verdict {
        assert_eq!(positions.len(), self.last.len(), "one position a particle");
        let speed = self.distance(&self.last, positions) / self.config.dt;
        let before = self.progress.speed;
        self.progress.frame += 1;
        self.progress.speed = speed;
        self.last.copy_from_slice(positions);
        if self.progress.frame <= self.config.lowering_frame_count {
            self.start_flight();
            return self.verdict(Some(LOWERING), None);
        }
        self.flight += 1;
        if self.flight < SHORTEST_FLIGHT || before < speed {
            return self.verdict(None, None);
        }
        #[expect(
            clippy::cast_precision_loss,
            reason = "a flight has fewer than 2^24 frames"
        )]
        let time = self.flight as f32 * self.config.dt;
        let moved = self.distance(&self.start, positions);
        let residual = 2.0 * moved / (time * time * STANDARD_GRAVITY);
        self.progress.residual = Some(residual);
        self.progress.speed = 0.0;
        self.start_flight();
        let settled = Drape::Settled {
            residual,
            frame_count: self.progress.frame,
        };
        self.verdict(
            Some(0.0),
            (residual <= self.config.residual).then_some(settled),
        )
    }

    fn start_flight(&mut self) {
        self.flight = 0;
        self.start.copy_from_slice(&self.last);
    }

    fn verdict(&self, kept: Option<f32>, end: Option<Drape>) -> Verdict {
        let residual = self.progress.residual;
        let is_last = self.config.frame_limit <= self.progress.frame;
        Verdict {
            kept,
            end: end.or(is_last.then_some(Drape::GivenUp { residual })),
        }
    }

    /// Root mean square, by mass, of the free particles' distances [m].
    #[expect(
        clippy::cast_possible_truncation,
        reason = "summed in f64 and used in f32"
    )]
    fn distance(&self, from: &[Vec3], to: &[Vec3]) -> f32 {
        let squares = (self.shares.iter().zip(from).zip(to))
            .map(|((&share, &from), &to)| f64::from(share * from.distance_squared(to)));
        squares.sum::<f64>().sqrt() as f32
    }
}

#[cfg(test)]
mod tests {
    use lole_geom::trig;

    use super::*;
    use crate::{Fabric, Grid, MassLaw, Topology};

    fn spec() -> ClothSpec {
        let grid = Grid {
            column_count: 3,
            row_count: 3,
            topology: Topology::Sheet,
            spacing: [0.1; 2],
            flounce: None,
            crimp: None,
        };
        ClothSpec {
            grid,
            fabric: Fabric {
                areal_density: 0.1,
                thickness: 1e-3,
                stretch: [100.0; 2],
                shear: 1.0,
                bend: [0.0; 2],
                twist: 0.0,
                hysteresis: crate::Hysteresis::NONE,
                friction: 0.0,
                cloth_friction: 0.0,
                drag_rate: 0.0,
            },
            row_layers: vec![1.0; 3],
            mass: MassLaw::Uniform,
            pinned: vec![false; 9],
        }
    }

    #[test]
    fn the_residual_of_a_swing_is_its_first_acceleration_over_gravity() {
        // Every particle swings with amplitude A: `x = A cos ωt`, `a = ω² A` where it is let go.
        for (frequency, amplitude) in [(2.0_f32, 0.05_f32), (4.0, 0.01), (6.0, 0.002)] {
            let config = SettleConfig {
                lowering_frame_count: 0,
                residual: 0.0,
                ..SettleConfig::default()
            };
            let at = |frame: u8| {
                let angle = frequency * f32::from(frame) * config.dt;
                vec![Vec3::X * (amplitude * trig::sin_cos(angle).1); 9]
            };
            let mut settling = Settling::new(&spec(), config, &at(0));
            let stopped = (1..=200).find(|&frame| settling.judge(&at(frame)).kept.is_some());
            let quarter = 0.5 * std::f32::consts::PI / (frequency * config.dt);
            let frame = f32::from(stopped.expect("every swing has a middle"));
            assert!((frame - quarter).abs() <= 2.0, "{frame} and not {quarter}");
            let truth = frequency * frequency * amplitude / STANDARD_GRAVITY;
            let share = settling.progress().residual.expect("measured") / truth;
            assert!((0.7..0.9).contains(&share), "{share} of the acceleration");
        }
    }

    #[test]
    fn what_does_not_move_is_at_rest_at_once() {
        let config = SettleConfig::default();
        let positions = [Vec3::Y; 9];
        let mut settling = Settling::new(&spec(), config, &positions);
        let frames = config.lowering_frame_count + SHORTEST_FLIGHT;
        for _ in 1..frames {
            assert_eq!(settling.judge(&positions).end, None);
        }
        let settled = Drape::Settled {
            residual: 0.0,
            frame_count: frames,
        };
        assert_eq!(settling.judge(&positions).end, Some(settled));
    }
}
