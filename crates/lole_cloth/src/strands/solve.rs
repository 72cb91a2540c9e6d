//! The constraints of strands, each solved once a substep.

use glam::Vec3;
use lole_geom::trig;

use super::{Ring, StrandInput, StrandModel, StrandState, StrandStep};

/// Below this length [m] a stretch has no direction.
const DEGENERATE_LENGTH: f32 = 1.0e-7;

/// Moves all free particles as gravity and air have them.
pub(super) fn predict(step: StrandStep<'_>, state: &mut StrandState, h: f32) {
    let StrandStep {
        model,
        config,
        input,
    } = step;
    let taken = 1.0 - trig::exp(-config.drag_rate * h);
    let [before, _] = &mut state.before;
    before.clone_from(&state.positions);
    let moving = state.positions.iter_mut().zip(&mut state.velocities);
    for ((position, velocity), &inv_mass) in moving.zip(&model.inv_masses) {
        if 0.0 < inv_mass {
            *velocity += config.gravity * h;
            *velocity += (input.air_velocity - *velocity) * taken;
            *position += *velocity * h;
        }
    }
}

/// Moves pinned particles a `share` of the way that is left to their places.
pub(super) fn place_pins(
    model: &StrandModel,
    input: &StrandInput<'_>,
    state: &mut StrandState,
    share: f32,
) {
    for (&pin, &place) in model.pins.iter().zip(input.pins) {
        let position = &mut state.positions[pin as usize];
        *position += (place - *position) * share;
    }
}

/// Bending: with `C = x0 - 2 x1 + x2`, the energy of a curvature `|C| / l²` over the length `l` is
/// `EI |C|² / (2 l³)`, so the compliance is `l³ / EI` and
/// `Δλ = -C / (w0 + 4 w1 + w2 + compliance / h²)`.
pub(super) fn bend(model: &StrandModel, state: &mut StrandState, h: f32) {
    for (strand, range) in model.strands().enumerate() {
        let compliance = model.bend_compliances[strand] / (h * h);
        if !compliance.is_finite() {
            continue;
        }
        let count = range.len();
        let middles = match model.rings[strand] {
            Ring::Open => 1..count - 1,
            Ring::Closed => 1..count + 1,
        };
        for middle in middles {
            let at = |place: usize| range.start + place % count;
            let [a, b, c] = [at(middle - 1), at(middle), at(middle + 1)];
            let [u, v, w] = [a, b, c].map(|particle| model.inv_masses[particle]);
            let sum = u + 4.0 * v + w;
            if sum <= 0.0 {
                continue;
            }
            let positions = &mut state.positions;
            let turn = positions[a] - positions[b] * 2.0 + positions[c];
            let lambda = turn / (sum + compliance);
            positions[a] -= lambda * u;
            positions[b] += lambda * (2.0 * v);
            positions[c] -= lambda * w;
        }
    }
}

/// Length: with `C = |x1 - x0| - spacing`, `Δλ = -C / (w0 + w1)`. It does not give.
pub(super) fn stretch(model: &StrandModel, state: &mut StrandState) {
    for (strand, range) in model.strands().enumerate() {
        let spacing = model.spacings[strand];
        let exactly = |particles: [usize; 2]| Range {
            particles,
            bounds: [spacing, spacing],
            scaled_compliance: 0.0,
        };
        for first in range.start..range.end - 1 {
            exactly([first, first + 1]).hold(model, &mut state.positions);
        }
        if model.rings[strand] == Ring::Closed {
            exactly([range.end - 1, range.start]).hold(model, &mut state.positions);
        }
    }
}

/// Links, where they are overcome.
pub(super) fn link(model: &StrandModel, state: &mut StrandState, h: f32) {
    for link in &model.links {
        let range = Range {
            particles: link.particles.map(|particle| particle as usize),
            bounds: link.range,
            scaled_compliance: link.compliance / (h * h),
        };
        range.hold(model, &mut state.positions);
    }
}

/// Ties: with `C = x - p`, `Δλ = -C / (w + compliance / h²)`.
pub(super) fn tie(model: &StrandModel, input: &StrandInput<'_>, state: &mut StrandState, h: f32) {
    for (tie, &place) in model.ties.iter().zip(input.ties) {
        let particle = tie.particle as usize;
        let inv_mass = model.inv_masses[particle];
        if 0.0 < inv_mass {
            let away = state.positions[particle] - place;
            let share = inv_mass / (inv_mass + tie.compliance / (h * h));
            state.positions[particle] -= away * share;
        }
    }
}

/// A range in which the distance of two particles is held.
struct Range {
    particles: [usize; 2],
    /// Least and largest distance [m].
    bounds: [f32; 2],
    /// Compliance over the substep squared [1/kg].
    scaled_compliance: f32,
}

impl Range {
    /// Brings the particles into it.
    fn hold(&self, model: &StrandModel, positions: &mut [Vec3]) {
        let [a, b] = self.particles;
        let [least, most] = self.bounds;
        let [u, v] = self.particles.map(|particle| model.inv_masses[particle]);
        let sum = u + v;
        let apart = positions[b] - positions[a];
        let length = apart.length();
        if sum <= 0.0 || length < DEGENERATE_LENGTH {
            return;
        }
        let excess = length - length.clamp(least, most);
        if excess == 0.0 {
            return;
        }
        let lambda = apart * (excess / (length * (sum + self.scaled_compliance)));
        positions[a] += lambda * u;
        positions[b] -= lambda * v;
    }
}

/// Velocities from what the substep did.
pub(super) fn update_velocities(state: &mut StrandState, h: f32) {
    let [before, _] = &state.before;
    for ((velocity, position), before) in
        (state.velocities.iter_mut().zip(&state.positions)).zip(before)
    {
        *velocity = (*position - *before) / h;
    }
}
