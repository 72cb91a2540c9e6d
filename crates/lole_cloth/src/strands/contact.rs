//! Contact of strands with a body of surfels: each particle meets the tangent plane of the surfel
//! nearest to it in the middle of the step, which moves on with the body in the substeps.

use fearless_simd::{Simd, dispatch};
use glam::Vec3;
use lole_geom::Surfel;

use super::StrandStep;
use crate::InstructionSet;
use crate::collision::surfel::{REACH_MAX, Skin, SurfelCells};
use crate::step::Progress;

/// A particle that comes nearer to a surfel than this [m], besides its offset and what it may travel,
/// takes its plane.
const REACH: f32 = 0.02;

/// The plane of one particle on its way through the step.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Plane {
    particle: usize,
    ends: [Surfel; 2],
}

/// The planes of one step.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Contacts {
    cells: SurfelCells,
    planes: Vec<Plane>,
}

/// The strands at the start of a step of `dt` [s].
pub(super) struct Flight<'a> {
    pub(super) positions: &'a [Vec3],
    pub(super) velocities: &'a [Vec3],
    pub(super) dt: f32,
}

impl Contacts {
    /// Finds the surfels, which move from where they were `before` the step.
    pub(super) fn find(&mut self, step: StrandStep<'_>, before: &[Surfel], flight: &Flight<'_>) {
        let after = step.input.surfels;
        self.planes.clear();
        if after.is_empty() {
            return;
        }
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let bounds = flight.positions.iter().fold(start, |(low, high), &place| {
            (low.min(place), high.max(place))
        });
        let skin = Skin {
            before,
            after,
            offset: 0.0,
        };
        self.cells.sort(skin, [bounds.0, bounds.1], REACH_MAX);
        let level = InstructionSet::Detected.level();
        dispatch!(level, simd => self.find_nearest(simd, step, before, flight));
    }

    #[inline(always)]
    fn find_nearest<S: Simd>(
        &mut self,
        simd: S,
        step: StrandStep<'_>,
        before: &[Surfel],
        flight: &Flight<'_>,
    ) {
        let StrandStep {
            model,
            config,
            input,
        } = step;
        let common = self.cells.mean_motion();
        let mut hint = None;
        for (particle, &inv_mass) in model.inv_masses.iter().enumerate() {
            if inv_mass == 0.0 {
                continue;
            }
            let fall = config.gravity * flight.dt;
            let away = (flight.velocities[particle] + fall) * flight.dt - common;
            let middle = flight.positions[particle] + (common + away) * 0.5;
            let travel = away.length() + self.cells.spread();
            let reach = REACH + model.contact_offsets[particle] + travel;
            hint = self.cells.nearest(simd, middle, reach.min(REACH_MAX), hint);
            if let Some(place) = hint {
                let surfel = self.cells.surfel(place);
                self.planes.push(Plane {
                    particle,
                    ends: [before[surfel], input.surfels[surfel]],
                });
            }
        }
    }

    /// Pushes particles out of their planes as these are at the end of a substep of `h` [s], when the
    /// step has come so far. What slides along is held back by Coulomb's law,
    /// `|Δx_t| <= friction Δx_n`. What a particle was inside before, it leaves without speed: `before`,
    /// from which its velocity is told, is moved with it.
    pub(super) fn push_out(
        &self,
        step: StrandStep<'_>,
        [positions, before]: [&mut [Vec3]; 2],
        progress: Progress,
        h: f32,
    ) {
        let (model, config) = (step.model, step.config);
        for plane in &self.planes {
            let particle = plane.particle;
            let [from, to] = &plane.ends;
            let now = from.lerp(to, progress.fraction);
            let normal = now.normal.normalize_or_zero();
            let position = &mut positions[particle];
            let gap = (*position - now.position).dot(normal);
            let overlap = model.contact_offsets[particle] - gap;
            if overlap <= 0.0 || normal == Vec3::ZERO {
                continue;
            }
            let surface = (to.position - from.position) * progress.share;
            let motion = *position - before[particle] - surface;
            // What came in during this substep leaves at once, what was inside before not faster
            // than it may.
            let came = (-motion.dot(normal)).max(0.0);
            let push = overlap.min(came + config.depenetration_speed * h);
            *position += normal * push;
            before[particle] += normal * (push - came).max(0.0);
            let along = motion - normal * motion.dot(normal);
            let length = along.length();
            if 0.0 < length {
                *position -= along * (config.friction * push / length).min(1.0);
            }
        }
    }
}
