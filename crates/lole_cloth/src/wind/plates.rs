//! Air against cells: every cell of the grid is a small plate that the air pushes.
//!
//! With the air's velocity `u` relative to a plate of vector area `S = A n` and mass `M`, split into
//! `u_n = (u·n) n` and `u_t = u - u_n`, the force is
//!
//! ```text
//! F = ½ ρ A (C_n |u_n| u_n + C_t |u_t| u_t)
//! ```
//!
//! Each component of the flow acts for itself: the cross-flow principle (Hoerner 1965,
//! "Fluid-Dynamic Drag"). A plate at an angle is pushed along its normal, which is lift and drag in
//! one, and flutter follows from it.
//!
//! The law is solved exactly for each plate alone: `u' = -K |u| u` leaves `u / (1 + K |u| t)` after
//! the time `t`. So it takes no more of a velocity than there is, however strong the wind and long
//! the frame, and once a frame is enough.

use fearless_simd::{Simd, dispatch, f32x16, prelude::*};

use super::gust::WindNow;
use crate::lanes::{Points, RowLink, Vectors, larger};
use crate::{ClothModel, ClothState, InstructionSet};

/// Least squared vector area (m⁴) of a plate that has a normal.
const DEGENERATE_AREA_SQUARED: f32 = 1.0e-24;

/// How air pushes cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aerodynamics {
    /// `ρ` of the air [kg/m³].
    pub air_density: f32,
    /// `C_n`: what a plate across the flow feels. More makes cloth fall slower and billow more.
    pub normal_coefficient: f32,
    /// `C_t` of both faces together: what a plate along the flow feels.
    pub tangential_coefficient: f32,
}

impl Default for Aerodynamics {
    /// Air at 20 °C; a square plate across the flow (1.17, Hoerner 1965), and the friction of a
    /// rough skin on two faces.
    fn default() -> Self {
        Self {
            air_density: 1.204,
            normal_coefficient: 1.17,
            tangential_coefficient: 0.02,
        }
    }
}

/// The air that pushes a cloth in one frame.
#[derive(Debug, Clone, Copy)]
pub struct AirPush<'a> {
    /// How it pushes.
    pub law: Aerodynamics,
    /// How it moves.
    pub wind: &'a WindNow,
    /// Duration of the frame [s].
    pub dt: f32,
}

/// Changes the velocities of the cloth as the air does in a frame; call it once before each step. Pinned
/// particles are left alone.
///
/// It stands in the place of [`Fabric::drag_rate`](crate::Fabric::drag_rate), which pulls every
/// particle alike: a fabric for it has a drag rate of 0, or the little that its threads take.
pub fn blow(
    model: &ClothModel,
    air: AirPush<'_>,
    instruction_set: InstructionSet,
    state: &mut ClothState,
) {
    let level = instruction_set.level();
    dispatch!(level, simd => blow_rows(simd, model, air, state));
}

/// Factors of one row of cells.
#[derive(Clone, Copy)]
struct Plates {
    /// `½ ρ C dt / M` [s/m³], normal and tangential.
    rates: [f32; 2],
    /// `M / 4` [kg].
    quarter: f32,
}

#[inline(always)]
fn blow_rows<S: Simd>(simd: S, model: &ClothModel, air: AirPush<'_>, state: &mut ClothState) {
    let AirPush { law, wind, dt } = air;
    let spec = model.spec();
    let (width, row_count) = (model.layout.group_count, model.layout.row_count);
    let cell_mass = spec.fabric.areal_density * spec.grid.spacing[0] * spec.grid.spacing[1];
    let coefficients = [law.normal_coefficient, law.tangential_coefficient];
    let impulses = &mut state.scratch.forces;
    impulses.clear();
    impulses.resize(2 * width, Points::default());
    for (row, number) in (0..row_count).zip(0_u32..) {
        let (first, second) = impulses.split_at_mut(width);
        let [this, next] = if row % 2 == 0 {
            [first, second]
        } else {
            [second, first]
        };
        if row + 1 < row_count {
            let layers = spec.row_layers[row] + spec.row_layers[row + 1];
            let mass = 0.5 * cell_mass * spec.grid.cell_fullness(number) * layers;
            let plates = Plates {
                rates: coefficients.map(|c| 0.5 * law.air_density * c * dt / mass),
                quarter: 0.25 * mass,
            };
            let range = row * width..(row + 2) * width;
            let columns = [&state.positions[range.clone()], &state.velocities[range]];
            for link in &model.row_pairs {
                let impulse = plates.impulse(simd, columns, link, wind);
                let [left, right] = link.groups.map(usize::from);
                let shift = link.shifts[1];
                for forces in [&mut *this, &mut *next] {
                    add(&mut forces[left], impulse, 0);
                    add(&mut forces[right], impulse, shift);
                }
            }
        }
        let range = row * width..(row + 1) * width;
        let velocities = state.velocities[range.clone()].iter_mut();
        for ((velocity, inv_mass), impulse) in velocities.zip(&model.inv_masses[range]).zip(this) {
            let inv_mass = f32x16::load_array_ref(simd, &inv_mass.0);
            let change = Vectors::load(simd, impulse).scale(inv_mass);
            Vectors::load(simd, velocity).add(change).store(velocity);
            *impulse = Points::default();
        }
    }
}

#[inline(always)]
fn add<S: Simd>(sum: &mut Points, impulse: Vectors<S>, shift: u8) {
    Vectors::load(impulse.x.token(), sum)
        .add(impulse.rotate_right(shift))
        .store(sum);
}

impl Plates {
    /// Impulse [N·s] on each corner of the cells of a link, given positions and velocities of both
    /// rows.
    #[inline(always)]
    fn impulse<S: Simd>(
        self,
        simd: S,
        [positions, velocities]: [&[Points]; 2],
        link: &RowLink<2>,
        wind: &WindNow,
    ) -> Vectors<S> {
        let [left, right] = link.groups.map(usize::from);
        let (width, shift) = (positions.len() / 2, link.shifts[1]);
        let corners = |points: &[Points]| {
            [
                Vectors::load(simd, &points[left]),
                Vectors::load(simd, &points[right]).rotate_left(shift),
                Vectors::load(simd, &points[left + width]),
                Vectors::load(simd, &points[right + width]).rotate_left(shift),
            ]
        };
        let quarter = f32x16::splat(simd, 0.25);
        let middle = |[a, b, c, d]: [Vectors<S>; 4]| a.add(d).add(b.add(c)).scale(quarter);
        let [x00, x01, x10, x11] = corners(positions);
        // The mean of both ways to cut the cell into two triangles.
        let area = x11
            .sub(x00)
            .cross(x10.sub(x01))
            .scale(f32x16::splat(simd, 0.5));
        let center = middle([x00, x01, x10, x11]);
        let flow = wind
            .velocities(simd, center)
            .sub(middle(corners(velocities)));
        let squared = larger(area.dot(area), f32x16::splat(simd, DEGENERATE_AREA_SQUARED));
        let through = flow.dot(area);
        let normal = area.scale(through / squared);
        let tangential = flow.sub(normal);
        let slid = (tangential.dot(tangential) * squared).sqrt();
        let [across, along] = [through.abs() * self.rates[0], slid * self.rates[1]];
        let mut mass = f32x16::splat(simd, self.quarter);
        if let Some(mask) = &link.mask {
            mass *= f32x16::load_array_ref(simd, &mask.0);
        }
        normal
            .scale(across / (across + 1.0))
            .add(tangential.scale(along / (along + 1.0)))
            .scale(mass)
    }
}
