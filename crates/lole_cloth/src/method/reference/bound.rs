//! How large a substep may be: a bound on the highest frequency, never below the true one.

use glam::DVec2;

use super::ReferenceModel;
use crate::collision::penalty::Penalty;

/// The bound holds for the flat cloth. Stretched springs also resist sideways, by
/// `k (1 - L / l)`, and sheared cells lay their springs closer together: 10 % on the frequency
/// covers tensile strains of about 10 %.
const DEFORMATION_MARGIN: f64 = 1.1;

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

    /// Substeps into which (9) must divide `dt` [s] to be stable with this contact, from
    /// `ω² Δt² + 2 c Δt < 4` at every free particle, where `ω² = ω_i² + n k / m_i`,
    /// `c = drag_rate + n b / m_i` and `n` capsules push at once ([`Penalty::overlap_count`]); and so that `ω_c Δt ≤ 0.5`, which
    /// keeps the bounce honest. At least 1.
    #[must_use]
    pub fn stable_substeps(&self, dt: f64, contact: &Penalty) -> u32 {
        let overlap = f64::from(contact.overlap_count());
        let mut rate: f64 = 0.0;
        for (index, &frequency_squared) in self.frequency_bounds_squared.iter().enumerate() {
            if self.pinned[index] {
                continue;
            }
            let contact_squared = overlap * contact.stiffness / self.masses[index];
            let damping = self.drag_rate + overlap * contact.damping / self.masses[index];
            let spring_squared = frequency_squared * DEFORMATION_MARGIN * DEFORMATION_MARGIN;
            rate = rate
                .max(stability_rate(spring_squared + contact_squared, damping))
                .max(contact_squared.sqrt() / CONTACT_PHASE);
        }
        whole_substeps(dt * rate)
    }
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
