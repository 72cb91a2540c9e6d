//! How large a substep may be: a bound on the highest frequency, never below the true one.
//!
//! In flat cloth springs along rows and down columns pull at right angles. In gathers that open
//! over the hips both lie along the same line and their stiffness adds up: the frequency is 1.4
//! times as high, and the substeps of flat cloth let it fly apart. So a step is divided by the bound
//! for the cloth as it lies, with every spring in its present direction `n` and at its present
//! length `l`: `K = k n n^T + k max(0, 1 - L / l) (I - n n^T)`, the second part being the geometric
//! stiffness of what is taut.

use glam::{DMat3, DVec2, DVec3};
use rayon::prelude::*;

use super::ReferenceModel;
use crate::collision::penalty::Penalty;

/// The bound holds for the cloth as it lies at the start of a step. While the step lasts springs
/// turn and stretch: 10 % on the frequency covers tensile strains of about 10 %.
const DEFORMATION_MARGIN: f64 = 1.1;

/// Below this length [m] a spring has no direction.
const DEGENERATE_LENGTH: f64 = 1.0e-12;

/// How often a form is squared for its largest eigenvalue: `λ_max ≤ tr(M^2n)^(1/2n)` with
/// `n = 2^6` is 0.9 % too large where all three are equal, and exact where one stands out.
const SQUARINGS: u32 = 6;

/// `ω_c Δt` of the contact at most: there a penalty without damping returns a particle at 98 to
/// 102 % of its speed, whatever the phase of the impact; at 1.5 it may add a quarter.
const CONTACT_PHASE: f64 = 0.5;

impl ReferenceModel {
    /// A bound [rad/s] on the highest frequency of the flat cloth, contact and drag aside:
    /// `ω² ≤ max_i (2 λ_max(Σ_j k_ij n n^T) + Σ_j |H_ij|) / m_i` over free particles `i`, with the
    /// springs to pinned particles counted once and the Hessian `H` of the plate by rows.
    #[must_use]
    pub fn largest_frequency_bound(&self) -> f64 {
        self.frequency_bounds_squared
            .iter()
            .fold(0.0, |largest: f64, &bound| largest.max(bound))
            .sqrt()
    }

    /// A bound [rad/s] on the highest frequency of the cloth at these positions [m], contact and
    /// drag aside; never below [`ReferenceModel::largest_frequency_bound`]. The bound is the same
    /// sum with `Σ_j K_ij` of the springs where they are.
    #[must_use]
    pub fn largest_frequency_bound_at(&self, positions: &[DVec3]) -> f64 {
        (0..self.masses.len())
            .into_par_iter()
            .map(|index| self.frequency_bound_squared_at(index, positions))
            .reduce(|| 0.0, f64::max)
            .sqrt()
    }

    /// The bound `ω_i²` [1/s²] of a particle where it is; zero where pinned.
    fn frequency_bound_squared_at(&self, index: usize, positions: &[DVec3]) -> f64 {
        if self.pinned[index] {
            return 0.0;
        }
        let mut form = DMat3::ZERO;
        for spring in self.gather.springs_of(index) {
            let factor = if self.pinned[spring.other] { 1.0 } else { 2.0 };
            let offset = positions[spring.other] - positions[index];
            form += stiffness(offset, spring.rest_length, factor * spring.stiffness);
        }
        let plate = self.plate.row_bound(index, &self.pinned);
        let here = (largest_eigenvalue(form) + plate) / self.masses[index];
        here.max(self.frequency_bounds_squared[index])
    }

    /// [`ReferenceModel::stable_substeps`] for the cloth at these positions [m], folded and strained
    /// as it is; never fewer than those of the flat cloth.
    #[must_use]
    pub fn stable_substeps_at(&self, positions: &[DVec3], dt: f64, contact: &Penalty) -> u32 {
        let rate = (0..self.masses.len())
            .into_par_iter()
            .map(|index| {
                let frequency_squared = self.frequency_bound_squared_at(index, positions);
                self.least_rate(index, frequency_squared, contact)
            })
            .reduce(|| 0.0, f64::max);
        whole_substeps(dt * rate)
    }

    /// Substeps into which (9) must divide `dt` [s] for flat cloth to be stable with this contact, from
    /// `ω² Δt² + 2 c Δt < 4` at every free particle, where `ω² = ω_i² + n k / m_i`,
    /// `c = drag_rate + n b / m_i` and `n` capsules push at once ([`Penalty::overlap_count`]); and so that
    /// `ω_c Δt ≤ 0.5`, which keeps the bounce honest. At least 1.
    #[must_use]
    pub fn stable_substeps(&self, dt: f64, contact: &Penalty) -> u32 {
        let rates = (0..self.masses.len())
            .map(|index| self.least_rate(index, self.frequency_bounds_squared[index], contact));
        whole_substeps(dt * rates.fold(0.0, f64::max))
    }

    /// Substeps per second that a particle with this `ω_i²` [1/s²] asks for; none where pinned.
    fn least_rate(&self, index: usize, frequency_squared: f64, contact: &Penalty) -> f64 {
        if self.pinned[index] {
            return 0.0;
        }
        let overlap = f64::from(contact.overlap_count());
        let contact_squared = overlap * contact.stiffness / self.masses[index];
        let damping = self.drag_rate + overlap * contact.damping / self.masses[index];
        let spring_squared = frequency_squared * DEFORMATION_MARGIN * DEFORMATION_MARGIN;
        stability_rate(spring_squared + contact_squared, damping)
            .max(contact_squared.sqrt() / CONTACT_PHASE)
    }
}

/// `K` [N/m] of a spring of `stiffness` with this offset to its other end.
fn stiffness(offset: DVec3, rest_length: f64, stiffness: f64) -> DMat3 {
    let length = offset.length();
    if length < DEGENERATE_LENGTH {
        return DMat3::from_diagonal(DVec3::splat(stiffness));
    }
    let direction = offset / length;
    let sideways = stiffness * (1.0 - rest_length / length).max(0.0);
    let along = direction * (stiffness - sideways);
    DMat3::from_diagonal(DVec3::splat(sideways))
        + DMat3::from_cols(
            along * direction.x,
            along * direction.y,
            along * direction.z,
        )
}

/// The largest eigenvalue of a symmetric form without negative ones, never below it.
fn largest_eigenvalue(form: DMat3) -> f64 {
    let trace = form.x_axis.x + form.y_axis.y + form.z_axis.z;
    if trace <= 0.0 {
        return 0.0;
    }
    let mut power = form * (1.0 / trace);
    for _ in 0..SQUARINGS {
        power = power * power;
    }
    let mut root = power.x_axis.length_squared()
        + power.y_axis.length_squared()
        + power.z_axis.length_squared();
    for _ in 0..=SQUARINGS {
        root = root.sqrt();
    }
    root * trace
}

/// The least number of substeps per second at which (9) is stable: `1 / Δt` where
/// `ω² Δt² + 2 c Δt = 4`, that is `(c + sqrt(c² + 4 ω²)) / 4`.
fn stability_rate(frequency_squared: f64, damping: f64) -> f64 {
    0.25 * (damping + (damping * damping + 4.0 * frequency_squared).sqrt())
}

/// The least whole number above `count`, at least 1.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to the range of u32; a NaN becomes 1"
)]
fn whole_substeps(count: f64) -> u32 {
    (count.floor() + 1.0).clamp(1.0, f64::from(u32::MAX)) as u32
}

/// The bound `ω_i²` [1/s²] of every particle; zero where pinned.
///
/// For springs, `Σ k (n·(v_i - v_j))² ≤ 2 Σ k ((n·v_i)² + (n·v_j)²)`, which splits the energy of a
/// mode into one quadratic form per particle; a pinned end does not move and needs no factor 2.
pub(super) fn frequency_bounds_squared(model: &ReferenceModel) -> Vec<f64> {
    let mut forms = vec![PlaneForm::default(); model.masses.len()];
    for family in &model.springs {
        for &[a, b] in &family.ends {
            let [a, b] = [a as usize, b as usize];
            let factor = if model.pinned[a] || model.pinned[b] {
                1.0
            } else {
                2.0
            };
            for end in [a, b] {
                forms[end].add(family.direction, factor * family.stiffness);
            }
        }
    }
    forms
        .iter()
        .enumerate()
        .map(|(index, form)| {
            if model.pinned[index] {
                return 0.0;
            }
            let plate = model.plate.row_bound(index, &model.pinned);
            (form.largest_eigenvalue() + plate) / model.masses[index]
        })
        .collect()
}

/// A symmetric form in the plane of the flat cloth: `Σ k n n^T` [N/m].
#[derive(Debug, Clone, Copy, Default)]
struct PlaneForm {
    uu: f64,
    vv: f64,
    uv: f64,
}

impl PlaneForm {
    fn add(&mut self, direction: DVec2, stiffness: f64) {
        self.uu += stiffness * direction.x * direction.x;
        self.vv += stiffness * direction.y * direction.y;
        self.uv += stiffness * direction.x * direction.y;
    }

    fn largest_eigenvalue(&self) -> f64 {
        let mean = 0.5 * (self.uu + self.vv);
        let half_difference = 0.5 * (self.uu - self.vv);
        mean + (half_difference * half_difference + self.uv * self.uv).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn the_largest_eigenvalue_is_never_below_the_true_one_and_hardly_above() {
        let turn = DQuat::from_xyzw(0.5, 0.1, -0.3, 0.8).normalize();
        let turn = DMat3::from_quat(turn);
        for values in [[1.0, 1.0, 1.0], [3.0, 1.0, 0.0], [2.0e4, 1.9e4, 1.0]] {
            let form = turn * DMat3::from_diagonal(DVec3::from_array(values)) * turn.transpose();
            let ratio = largest_eigenvalue(form) / values[0];
            assert!((1.0 - 1e-12..1.009).contains(&ratio), "{values:?}: {ratio}");
        }
        assert!(largest_eigenvalue(DMat3::ZERO) <= 0.0);
    }
}
