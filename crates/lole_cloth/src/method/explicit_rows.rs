//! FB Euler (9) on vectors: the reference's forces in `f32`, fast enough to use.
//!
//! Structural and shear springs are the paper's (1), bending and twist the plate's, all with the
//! constants of [`SpringConstants`], so that a cloth has the modulus of its fabric whatever the
//! grid, which the real-time method has only with very many substeps. Every step is divided as
//! finely as the bound on the frequency of every particle asks for then (see `bound.rs`).
//!
//! Every force is worked out once and added to both ends, row by row from the top; a row moves as
//! soon as nothing below asks for it any more, so one row of positions and three of forces are all
//! that a substep keeps at hand. A spring is a polynomial where cloth lives (see `spring.rs`), so
//! it waits for no root and no quotient.
//!
//! What comes behind the tangent planes of the body's capsules, which are found anew in every
//! eighth substep, is put back and stopped, with Coulomb's friction. The cloth does not meet
//! itself.

mod bound;
mod forces;
mod spring;

use fearless_simd::{Simd, dispatch, f32x16, prelude::*};

use crate::collision::capsule::near::Range;
use crate::collision::capsule::stop::{Flying, KeptCapsule, StopLaw};
use crate::lanes::{LANES, Points, Scalars, Vectors};
use crate::lost::{Lost, check_cloth, check_pins};
use crate::method::reference::SpringConstants;
use crate::method::xpbd;
use crate::step::{GridStep, Progress, StepOf};
use crate::{BuildError, ClothModel, ClothSpec, ClothState, SolverConfig, StepInput, Topology};
pub(crate) use bound::Form;
use forces::Cell;
use spring::Spring;

/// Substeps for which the tangent planes of the body are kept.
const CONTACT_INTERVAL: u32 = 8;

/// Far capsules are looked at when planes are found for every so manyth time.
const FAR_INTERVAL: u32 = 4;

/// Rows that a row's forces reach down to, itself included.
const REACH: usize = 3;

/// A cloth prepared for FB Euler on vectors.
#[derive(Debug, Clone)]
pub struct ExplicitModel {
    cloth: ClothModel,
    cell: Cell,
    down: Spring,
    /// Bending along rows and down columns at the middle of every term [N/m].
    bend: [Vec<Scalars>; 2],
    /// Gershgorin's bound on the stiffness of bending and twist at a particle [N/m].
    plate_bound: f32,
}

impl ExplicitModel {
    /// Prepares `spec`.
    ///
    /// # Errors
    /// When a length does not fit the grid, a number is not finite or out of range, or the grid has a
    /// flounce or is crimped.
    pub fn new(spec: &ClothSpec) -> Result<Self, BuildError> {
        let cloth = ClothModel::new(spec)?;
        if spec.grid.flounce.is_some() {
            return Err(BuildError::Flounce);
        }
        if spec.grid.crimp.is_some() {
            return Err(BuildError::Crimp);
        }
        let [h_u, h_v] = spec.grid.spacing.map(f64::from);
        let constants = SpringConstants::from_fabric(&spec.fabric, [h_u, h_v]);
        let bend = bend_weights(spec, &constants);
        let largest = |weights: &Vec<f32>| weights.iter().copied().fold(0.0, f32::max);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "constants are derived in f64 and used in f32"
        )]
        let twist = (2.0 * constants.twist / (h_u * h_v)) as f32;
        Ok(Self {
            cell: Cell {
                along: Spring::new(h_u * h_u, constants.structural_u),
                diagonal: Spring::new(h_u * h_u + h_v * h_v, constants.shear),
                twist,
            },
            down: Spring::new(h_v * h_v, constants.structural_v),
            // The rows of |Δ²|² and of the twist's Hessian add up to 16 without their signs.
            plate_bound: 16.0 * (largest(&bend[0]) + largest(&bend[1]) + twist),
            bend: bend.map(|weights| cloth.layout.scatter(&weights)),
            cloth,
        })
    }

    /// The cloth as states know it.
    #[must_use]
    pub const fn cloth(&self) -> &ClothModel {
        &self.cloth
    }

    /// Memory that it holds [byte].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        let bend = self.bend.iter().map(|weights| size_of_val(&weights[..]));
        self.cloth.byte_count() + bend.sum::<usize>()
    }
}

/// Weights [N/m] of `½ w |x₋ - 2 x₀ + x₊|²` by the particle in the middle, along rows and down
/// columns: by the area a term stands for, half at free borders, and twice that at a clamp, as in
/// the reference.
#[expect(
    clippy::cast_possible_truncation,
    reason = "weights are derived in f64 and used in f32"
)]
fn bend_weights(spec: &ClothSpec, constants: &SpringConstants) -> [Vec<f32>; 2] {
    let grid = &spec.grid;
    let [h_u, h_v] = grid.spacing.map(f64::from);
    let whole = [
        constants.plate_u * h_v / (h_u * h_u * h_u),
        constants.plate_v * h_u / (h_v * h_v * h_v),
    ];
    let (columns, rows) = (grid.column_count, grid.row_count);
    let pinned = |row: u32, column: u32| spec.pinned[grid.index(row, column)];
    let clamp = |center: bool, ends: [bool; 2]| {
        if center && ends[0] != ends[1] {
            2.0
        } else {
            1.0
        }
    };
    let share = |is_border: bool| if is_border { 0.5 } else { 1.0 };
    let mut weights = [Vec::new(), Vec::new()];
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let whole = whole.map(|weight| weight * f64::from(spec.row_layers[row as usize]));
        let center = pinned(row, column);
        let [left, right] = [columns - 1, 1].map(|by| pinned(row, (column + by) % columns));
        let is_border = row == 0 || row + 1 == rows;
        weights[0].push((whole[0] * share(is_border) * clamp(center, [left, right])) as f32);
        let [above, below] =
            [row.saturating_sub(1), (row + 1).min(rows - 1)].map(|row| pinned(row, column));
        let is_border = grid.topology == Topology::Sheet && (column == 0 || column + 1 == columns);
        weights[1].push((whole[1] * share(is_border) * clamp(center, [above, below])) as f32);
    }
    weights
}

/// Moves the cloth on by `dt` [s] and returns the number of substeps it took.
///
/// Pins and capsules move evenly from where the previous call left them to where `input` has them;
/// of `config` gravity, contact with the body and vector instructions count. The result is the
/// same bit for bit with all vector instructions and on any number of threads.
///
/// # Errors
/// A state of another cloth, or as many targets as there are not pins; the cloth is as it was then.
pub fn step(
    model: &ExplicitModel,
    config: &SolverConfig,
    input: &StepInput<'_>,
    state: &mut ClothState,
    dt: f32,
) -> Result<u32, Lost> {
    let vectors = [model.cloth().layout.vector_count(), state.positions.len()];
    check_cloth(0, vectors)?;
    check_pins(model.cloth().pin_indices().len(), input.pin_targets)?;
    let level = config.instruction_set.level();
    let forms = &mut state.scratch.forms;
    let positions = &state.positions;
    let rate = dispatch!(level, simd => bound::stable_rate(simd, model, positions, forms));
    let contact_count = whole_count(f64::from(dt) * rate / f64::from(CONTACT_INTERVAL));
    let step = StepOf {
        model,
        config,
        input,
        dt,
    };
    dispatch!(level, simd => advance(simd, step, contact_count, state));
    state.pin_targets.clear();
    state.pin_targets.extend_from_slice(input.pin_targets);
    state.capsules.clear();
    state.capsules.extend_from_slice(input.capsules);
    Ok(contact_count * CONTACT_INTERVAL)
}

/// The least whole number above `count`, at least 1.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to the range of u32; a NaN becomes 1"
)]
fn whole_count(count: f64) -> u32 {
    (count.floor() + 1.0).clamp(1.0, f64::from(u32::MAX / CONTACT_INTERVAL)) as u32
}

/// Numbers that hold for every substep of one step.
#[derive(Clone, Copy)]
struct Substep {
    /// Duration [s].
    h: f32,
    /// What drag (3) leaves of a velocity.
    kept: f32,
    /// What gravity and moving air add to it [m/s].
    gain: glam::Vec3,
}

#[inline(always)]
fn advance<S: Simd>(
    simd: S,
    step: StepOf<'_, ExplicitModel>,
    contact_count: u32,
    state: &mut ClothState,
) {
    let StepOf {
        model,
        config,
        input,
        dt,
    } = step;
    let cloth = &model.cloth;
    let grid_step = GridStep {
        model: cloth,
        config,
        input,
        dt,
    };
    let count = contact_count * CONTACT_INTERVAL;
    #[expect(clippy::cast_precision_loss, reason = "substeps are far below 2^24")]
    let (h, interval) = (dt / count as f32, dt / contact_count as f32);
    let drag_rate = cloth.spec().fabric.drag_rate;
    let substep = Substep {
        h,
        kept: 1.0 - drag_rate * h,
        gain: (config.gravity + input.air_velocity * drag_rate) * h,
    };
    if state.capsules.len() != input.capsules.len() {
        state.capsules.clear();
        state.capsules.extend_from_slice(input.capsules);
    }
    let forces = REACH * cloth.layout.group_count;
    state.scratch.forces.clear();
    state.scratch.forces.resize(forces, Points::default());
    xpbd::start_pins(cloth, input.pin_targets, state, dt);
    xpbd::find_body_contacts(grid_step, state);
    let mut law = StopLaw {
        friction: cloth.spec().fabric.friction,
        depenetration_speed: config.depenetration_speed,
        h,
        age: 0.0,
    };
    state.scratch.tangent_planes.clear();
    for index in 0..contact_count {
        if !input.capsules.is_empty() {
            xpbd::move_capsules(grid_step, Progress::after(index, contact_count), state);
            let range = if index % FAR_INTERVAL == 0 {
                Range::All
            } else {
                Range::Near
            };
            find_planes(simd, cloth, (range, interval), state);
        }
        law.age = 0.0;
        for _ in 0..CONTACT_INTERVAL {
            run_substep(simd, model, substep, state);
            law.age += h;
            let mut flying = Flying {
                positions: &mut state.positions,
                velocities: &mut state.velocities,
                inv_masses: &cloth.inv_masses,
            };
            state.scratch.tangent_planes.stop(simd, &mut flying, law);
        }
    }
    xpbd::finish_pins(cloth, state);
}

/// Tangent planes of the capsules as they are now, for all that is near them.
#[inline(always)]
fn find_planes<S: Simd>(
    simd: S,
    cloth: &ClothModel,
    (range, interval): (Range, f32),
    state: &mut ClothState,
) {
    let width = cloth.layout.group_count;
    let scratch = &mut state.scratch;
    scratch.tangent_planes.clear();
    for row in 0..cloth.layout.row_count {
        let held = scratch.held_depths[row];
        let first = row * width;
        let points = &state.positions[first..first + width];
        for &index in scratch.row_contacts.row(row, range) {
            let capsule = &scratch.moving_capsules[index as usize];
            let planes = &mut scratch.tangent_planes;
            let kept = KeptCapsule {
                capsule,
                held,
                time: interval,
            };
            planes.add(simd, first, points, kept);
        }
    }
}

/// Equations (6), (7) and (9) once for every particle.
#[inline(always)]
fn run_substep<S: Simd>(simd: S, model: &ExplicitModel, substep: Substep, state: &mut ClothState) {
    let cloth = &model.cloth;
    let (width, row_count) = (cloth.layout.group_count, cloth.layout.row_count);
    let is_full = cloth.spec().grid.column_count as usize == LANES * width;
    let forces = &mut state.scratch.forces[..REACH * width];
    // Forces on all other rows are set, not added, by the second row above.
    forces[..2 * width].fill(Points::default());
    for row in 0..row_count {
        let (first, rest) = forces.split_at_mut(width);
        let (second, third) = rest.split_at_mut(width);
        // The rows of forces take turns: this row's comes first.
        let [this, next, far] = match row % REACH {
            0 => [first, second, third],
            1 => [second, third, first],
            _ => [third, first, second],
        };
        let start = row * width;
        let (done, below) = state.positions.split_at_mut(start + width);
        let points = &mut done[start..];
        let bending = forces::RowBending {
            links: &cloth.row_triples,
            weights: &model.bend[0][start..start + width],
        };
        bending.add(simd, this, points);
        let mut flight = Flight {
            simd,
            positions: points,
            velocities: &mut state.velocities[start..start + width],
            inv_masses: &cloth.inv_masses[start..start + width],
            substep,
            is_free: is_full && cloth.row_masses(row).even.is_some_and(|even| 0.0 < even),
        };
        if row + 1 == row_count {
            let along = &model.cell.along;
            along.add_row(simd, this, flight.positions, &cloth.row_pairs);
            for (group, force) in this.iter().enumerate() {
                flight.take(group, Vectors::load(simd, force));
            }
            continue;
        }
        let lower = &below[..width];
        let pair = [&*flight.positions, lower];
        (model.cell).add_to_rows(simd, [this, next], pair, &cloth.row_pairs);
        if row + 2 == row_count {
            for group in 0..width {
                let points = [&flight.positions[group], &lower[group]];
                let ends = [&mut this[group], &mut next[group]];
                let force = forces::add_last_pair(simd, &model.down, points, ends);
                flight.take(group, force);
            }
            continue;
        }
        for group in 0..width {
            let columns = forces::Columns {
                spring: &model.down,
                bend: &model.bend[1][start + width..start + 2 * width],
                rows: [&*flight.positions, lower, &below[width..2 * width]],
            };
            let rows = [&mut this[group], &mut next[group], &mut far[group]];
            let force = columns.add(simd, group, rows);
            flight.take(group, force);
        }
    }
}

/// A row whose forces become known group by group.
struct Flight<'a, S: Simd> {
    simd: S,
    positions: &'a mut [Points],
    velocities: &'a mut [Points],
    inv_masses: &'a [Scalars],
    substep: Substep,
    /// Whether all lanes hold particles that are not pinned.
    is_free: bool,
}

impl<S: Simd> Flight<'_, S> {
    /// Moves a group on which this force [N] acts by (9).
    #[inline(always)]
    fn take(&mut self, group: usize, force: Vectors<S>) {
        let (simd, substep) = (self.simd, self.substep);
        let h = f32x16::splat(simd, substep.h);
        let inv_mass = f32x16::load_array_ref(simd, &self.inv_masses[group].0);
        let before = Vectors::load(simd, &self.velocities[group]);
        let mut after = (before.scale(f32x16::splat(simd, substep.kept)))
            .add(Vectors::splat(simd, substep.gain))
            .add(force.scale(inv_mass * h));
        if !self.is_free {
            let free = f32x16::splat(simd, 0.0).simd_lt(inv_mass);
            after = Vectors {
                x: free.select(after.x, before.x),
                y: free.select(after.y, before.y),
                z: free.select(after.z, before.z),
            };
        }
        after.store(&mut self.velocities[group]);
        let position = Vectors::load(simd, &self.positions[group]);
        position
            .add(after.scale(h))
            .store(&mut self.positions[group]);
    }
}
