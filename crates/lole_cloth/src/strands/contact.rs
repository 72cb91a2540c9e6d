//! Contact of strands with a body of surfels: each particle meets the tangent plane of the surfel
//! nearest to it in the middle of the step, which moves on with the body in the substeps.

use fearless_simd::{Simd, dispatch};
use glam::Vec3;
use lole_geom::Surfel;

use super::{StrandConfig, StrandModel};
use crate::InstructionSet;
use crate::collision::surfel::{REACH_MAX, Skin, SurfelCells};

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
    /// Finds the surfels, given before and after the step.
    pub(super) fn find(
        &mut self,
        model: &StrandModel,
        config: &StrandConfig,
        [before, after]: [&[Surfel]; 2],
        flight: &Flight<'_>,
    ) {
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
        dispatch!(level, simd => self.find_nearest(simd, (model, config), [before, after], flight));
    }

    #[inline(always)]
    fn find_nearest<S: Simd>(
        &mut self,
        simd: S,
        (model, config): (&StrandModel, &StrandConfig),
        [before, after]: [&[Surfel]; 2],
        flight: &Flight<'_>,
    ) {
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
                    ends: [before[surfel], after[surfel]],
                });
            }
        }
    }

    /// Pushes particles out of their planes as these are at the end of a substep: a `fraction` of the
    /// way through the step, of which the substep of `h` [s] is a `share`. What slides along is held
    /// back by Coulomb's law, `|Δx_t| <= friction Δx_n`. What a particle was inside before, it leaves
    /// without speed: `before`, from which its velocity is told, is moved with it.
    pub(super) fn push_out(
        &self,
        model: &StrandModel,
        config: &StrandConfig,
        (positions, before): (&mut [Vec3], &mut [Vec3]),
        (fraction, share, h): (f32, f32, f32),
    ) {
        for plane in &self.planes {
            let particle = plane.particle;
            let [from, to] = &plane.ends;
            let now = from.lerp(to, fraction);
            let normal = now.normal.normalize_or_zero();
            let position = &mut positions[particle];
            let gap = (*position - now.position).dot(normal);
            let overlap = model.contact_offsets[particle] - gap;
            if overlap <= 0.0 || normal == Vec3::ZERO {
                continue;
            }
            let surface = (to.position - from.position) * share;
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
