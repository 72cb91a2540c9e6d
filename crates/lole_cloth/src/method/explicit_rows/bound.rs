//! How short a substep must be for the cloth as it lies: a bound on the frequency of every particle.
//!
//! The bound of the reference holds for flat cloth, where springs along rows and down columns pull
//! at right angles. In gathers that open over the hips both lie along the same line and their
//! stiffness adds up: the frequency is 1.4 times as high, and the substeps of flat cloth let it fly
//! apart. So the same bound, `ω² ≤ (2 λ_max(Σ_j K_ij) + Σ_j |H_ij|) / m_i`, is taken anew for
//! every step, with the stiffness of every spring in its present direction `n` and at its present
//! length `l`, `K = k n n^T + k max(0, 1 - L / l) (I - n n^T)`.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::ExplicitModel;
use super::spring::Spring;
use crate::lanes::{Points, Scalars, Vectors, larger};

/// What the frequency may gain while a step lasts: 10 %, as in the reference.
const MARGIN: f64 = 1.1;

/// Below this squared length [m²] a spring has no direction.
const DEGENERATE_SQUARED: f32 = 1.0e-14;

/// Least trace [N/m] of a form, so that it can be divided by.
const LEAST_TRACE: f32 = 1.0e-20;

/// A symmetric form by lanes: `xx`, `yy`, `zz`, and `yz`, `xz`, `xy`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Form {
    diagonal: Points,
    rest: Points,
}

/// A symmetric form by lanes, in registers.
#[derive(Clone, Copy)]
struct Forms<S: Simd> {
    diagonal: Vectors<S>,
    rest: Vectors<S>,
}

/// Substeps per second at which (9) is stable: `1 / Δt` where `ω² Δt² + 2 c Δt = 4`.
#[inline(always)]
pub(super) fn stable_rate<S: Simd>(
    simd: S,
    model: &ExplicitModel,
    positions: &[Points],
    forms: &mut Vec<Form>,
) -> f64 {
    let squared = f64::from(largest_frequency_squared(simd, model, positions, forms));
    let drag_rate = f64::from(model.cloth.spec().fabric.drag_rate);
    0.25 * (drag_rate + (drag_rate * drag_rate + 4.0 * squared * MARGIN * MARGIN).sqrt())
}

/// The largest bound `ω²` of any free particle [1/s²].
#[inline(always)]
fn largest_frequency_squared<S: Simd>(
    simd: S,
    model: &ExplicitModel,
    positions: &[Points],
    forms: &mut Vec<Form>,
) -> f32 {
    let layout = &model.cloth.layout;
    let (width, row_count) = (layout.group_count, layout.row_count);
    forms.clear();
    forms.resize(2 * width, Form::default());
    let mut largest = f32x16::splat(simd, 0.0);
    for row in 0..row_count {
        let (first, second) = forms.split_at_mut(width);
        let [this, next] = if row % 2 == 0 {
            [first, second]
        } else {
            [second, first]
        };
        let rows = &positions[row * width..];
        for link in &model.cloth.row_pairs {
            let [left, right] = link.groups.map(usize::from);
            let shift = link.shifts[1];
            let mask = link.mask.as_deref();
            let at = |point: usize, shift: u8| Vectors::load(simd, &rows[point]).rotate_left(shift);
            let (x00, x01) = (at(left, 0), at(right, shift));
            let along = model.cell.along.form(simd, x01.sub(x00), mask);
            this[left].add(along, 0);
            this[right].add(along, shift);
            if row + 1 < row_count {
                let (x10, x11) = (at(left + width, 0), at(right + width, shift));
                let falling = model.cell.diagonal.form(simd, x11.sub(x00), mask);
                let rising = model.cell.diagonal.form(simd, x10.sub(x01), mask);
                this[left].add(falling, 0);
                next[right].add(falling, shift);
                this[right].add(rising, shift);
                next[left].add(rising, 0);
            }
        }
        if row + 1 < row_count {
            for group in 0..width {
                let upper = Vectors::load(simd, &rows[group]);
                let offset = Vectors::load(simd, &rows[group + width]).sub(upper);
                let down = model.down.form(simd, offset, None);
                this[group].add(down, 0);
                next[group].add(down, 0);
            }
        }
        let inv_masses = &model.cloth.inv_masses[row * width..(row + 1) * width];
        for (form, inv_mass) in this.iter_mut().zip(inv_masses) {
            let stiffness = Forms::load(simd, form).largest_eigenvalue(simd) * 2.0;
            let inv_mass = f32x16::load_array_ref(simd, &inv_mass.0);
            largest = larger(largest, (stiffness + model.plate_bound) * inv_mass);
            *form = Form::default();
        }
    }
    largest.to_array().into_iter().fold(0.0, f32::max)
}

impl Spring {
    /// `K` of springs with this offset between their ends [N/m]; zero where the mask is.
    #[inline(always)]
    fn form<S: Simd>(&self, simd: S, offset: Vectors<S>, mask: Option<&Scalars>) -> Forms<S> {
        let squared = offset.dot(offset);
        let stretch = self.stretch(squared);
        let factor = self.exact_where_far(simd, self.factor(stretch), stretch);
        let zero = f32x16::splat(simd, 0.0);
        let mut sideways = larger(factor, zero);
        let floor = f32x16::splat(simd, DEGENERATE_SQUARED);
        let mut lengthwise =
            (f32x16::splat(simd, self.stiffness()) - sideways) / larger(squared, floor);
        if let Some(mask) = mask {
            let mask = f32x16::load_array_ref(simd, &mask.0);
            sideways *= mask;
            lengthwise *= mask;
        }
        let scaled = offset.scale(lengthwise);
        Forms {
            diagonal: Vectors {
                x: scaled.x * offset.x + sideways,
                y: scaled.y * offset.y + sideways,
                z: scaled.z * offset.z + sideways,
            },
            rest: Vectors {
                x: scaled.y * offset.z,
                y: scaled.x * offset.z,
                z: scaled.x * offset.y,
            },
        }
    }
}

impl Form {
    /// Adds a form of lanes that are rotated by `shift`.
    #[inline(always)]
    fn add<S: Simd>(&mut self, other: Forms<S>, shift: u8) {
        let sum = Forms::load(other.rest.x.token(), self);
        (sum.diagonal.add(other.diagonal.rotate_right(shift))).store(&mut self.diagonal);
        (sum.rest.add(other.rest.rotate_right(shift))).store(&mut self.rest);
    }
}

impl<S: Simd> Forms<S> {
    #[inline(always)]
    fn load(simd: S, form: &Form) -> Self {
        Self {
            diagonal: Vectors::load(simd, &form.diagonal),
            rest: Vectors::load(simd, &form.rest),
        }
    }

    #[inline(always)]
    fn scale(self, factor: f32x16<S>) -> Self {
        Self {
            diagonal: self.diagonal.scale(factor),
            rest: self.rest.scale(factor),
        }
    }

    /// The form applied twice.
    #[inline(always)]
    fn squared(self) -> Self {
        let (d, r) = (self.diagonal, self.rest);
        let (xx, yy, zz) = (r.x * r.x, r.y * r.y, r.z * r.z);
        Self {
            diagonal: Vectors {
                x: d.x * d.x + (yy + zz),
                y: d.y * d.y + (xx + zz),
                z: d.z * d.z + (xx + yy),
            },
            rest: Vectors {
                x: r.x * (d.y + d.z) + r.y * r.z,
                y: r.y * (d.x + d.z) + r.x * r.z,
                z: r.z * (d.x + d.y) + r.x * r.y,
            },
        }
    }

    /// Largest eigenvalue, not below it and at most 4 % above: `λ_max ≤ tr(M³²)^(1/32)`, which is
    /// `3^(1/32)` too large where all three are equal.
    #[inline(always)]
    fn largest_eigenvalue(self, simd: S) -> f32x16<S> {
        let trace = (self.diagonal.x + self.diagonal.y) + self.diagonal.z;
        let trace = larger(trace, f32x16::splat(simd, LEAST_TRACE));
        let unit = self.scale(f32x16::splat(simd, 1.0) / trace);
        let power = unit.squared().squared().squared().squared();
        let sum = power.diagonal.dot(power.diagonal) + (power.rest.dot(power.rest)) * 2.0;
        sum.sqrt().sqrt().sqrt().sqrt().sqrt() * trace
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};
    use glam::Vec3;

    /// Bound on the largest eigenvalue of `Σ λ n n^T` over these `λ n`.
    fn bound(axes: [Vec3; 3]) -> f32 {
        dispatch!(Level::baseline(), simd => {
            let mut form = Form::default();
            for axis in axes {
                let spring = Spring::new(f64::from(axis.length_squared()), f64::from(axis.length()));
                form.add(spring.form(simd, Vectors::splat(simd, axis), None), 0);
            }
            Forms::load(simd, &form).largest_eigenvalue(simd).to_array()[0]
        })
    }

    #[test]
    fn the_largest_eigenvalue_is_never_underestimated_and_hardly_over() {
        let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
        let turn = glam::Quat::from_array([0.5, 0.1, -0.3, 0.8]).normalize();
        for (axes, largest) in [
            ([x, y, z], 1.0),
            ([x * 3.0, y, z * 0.2], 3.0),
            ([x * 2.0, y * 2.0, z], 2.0),
            ([x * 2.0, x * 3.0, z], 5.0),
        ] {
            let found = bound(axes.map(|axis| turn * axis));
            assert!(
                (0.9999 * largest..1.04 * largest).contains(&found),
                "{found} for {largest}"
            );
        }
    }
}
