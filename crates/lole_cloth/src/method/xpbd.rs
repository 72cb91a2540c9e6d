//! Small substeps with one projection of every constraint each: the real-time method.
//!
//! Macklin and others 2019, "Small Steps in Physics Simulation", with XPBD's compliance. Every
//! substep predicts, solves the constraints from the farthest-reaching to the nearest, then
//! contacts, and turns what the projections changed into velocity: `v += (x - prediction) / h`
//! rather than `v = (x - x_before) / h`, because the second loses bits in `f32` at small `h`.

use fearless_simd::{Simd, f32x16, prelude::*};
use glam::Vec3;
use lole_geom::trig;
use rayon::prelude::*;

use crate::collision::capsule::{self, ContactLaw, MovingCapsule, RowContacts};
use crate::collision::cloth_cloth::{ClothContactLaw, Columns, Shape};
use crate::constraint::shear::Cell;
use crate::constraint::structural::Spring;
use crate::constraint::tether::Tethers;
use crate::constraint::{Rows, bend, shear, stride, structural, tether};
use crate::lanes::{Points, RowLink, Scalars, Vectors, row_links};
use crate::method::reference::SpringConstants;
use crate::{ClothModel, ClothState, SolverConfig, StepInput};

/// Rows that one task takes.
const TASK_ROWS: usize = 8;

/// Structural sweeps after the contacts of the cloth with itself: none leaves the springs strained
/// where folds are pressed together, all of them press folds through each other.
const LAST_SWEEPS: u32 = 1;

/// Below this many vectors of particles the contacts of a substep are over before a second thread
/// has woken up, which takes it about 50 µs.
const PARALLEL_VECTORS_MIN: usize = 8192;

/// Numbers that hold for every substep of one step.
#[derive(Debug, Clone, PartialEq)]
struct Substep {
    /// Duration [s].
    h: f32,
    count: u32,
    /// What gravity adds to a velocity [m/s].
    gravity_gain: Vec3,
    air_velocity: Vec3,
    /// What drag leaves of a velocity relative to the air: `exp(-drag_rate h)`.
    drag_kept: f32,
    across: Spring,
    down: Spring,
    cell: Cell,
    bend_across: f32,
    bend_down: f32,
    contact: ContactLaw,
}

impl Substep {
    fn new(model: &ClothModel, config: &SolverConfig, air_velocity: Vec3, dt: f32) -> Self {
        let count = config.substep_count.get();
        #[expect(clippy::cast_precision_loss, reason = "substeps and sweeps are few")]
        let (h, sweeps) = (
            dt / count as f32,
            config.structural_sweep_count.get() as f32,
        );
        let fabric = &model.spec().fabric;
        let [u, v] = model.spec().grid.spacing;
        let scaled_compliance = |stiffness: f32| 1.0 / (stiffness * h * h);
        // A pass without `λ` adds its own stiffness to the passes before it, hence the factor.
        let spring = |rest_length: f32, stiffness: f32| Spring {
            rest_length_squared: rest_length * rest_length,
            scaled_compliance: scaled_compliance(stiffness) * sweeps,
        };
        let constants =
            SpringConstants::from_fabric(fabric, model.spec().grid.spacing.map(f64::from));
        #[expect(
            clippy::cast_possible_truncation,
            reason = "constants are derived in f64 and used in f32"
        )]
        let [structural_u, structural_v, shear] = [
            constants.structural_u,
            constants.structural_v,
            constants.shear,
        ]
        .map(|constant| constant as f32);
        Self {
            h,
            count,
            gravity_gain: config.gravity * h,
            air_velocity,
            drag_kept: trig::exp(-fabric.drag_rate * h),
            across: spring(u, structural_u),
            down: spring(v, structural_v),
            cell: Cell {
                diagonal: (u * u + v * v).sqrt(),
                shear_compliance: scaled_compliance(shear),
                twist_compliance: scaled_compliance(2.0 * fabric.twist / (u * v)),
            },
            bend_across: scaled_compliance(fabric.bend[0] * v / (u * u * u)),
            bend_down: scaled_compliance(fabric.bend[1] * u / (v * v * v)),
            contact: ContactLaw {
                friction: fabric.friction,
                depenetration: config.depenetration_speed * h,
            },
        }
    }
}

/// Moves the cloth on by `dt`.
#[inline(always)]
pub(crate) fn advance<S: Simd>(
    simd: S,
    model: &ClothModel,
    config: &SolverConfig,
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) {
    let substep = Substep::new(model, config, input.air_velocity, dt);
    let strides = stride_links(model, config);
    if state.capsules.len() != input.capsules.len() {
        state.capsules.clear();
        state.capsules.extend_from_slice(input.capsules);
    }
    start_pins(model, input.pin_targets, state, dt);
    let width = model.layout.group_count;
    state.scratch.row_contacts.find(
        simd,
        (&state.positions, &state.velocities, width),
        [&state.capsules, input.capsules],
        (config.contact_offset, config.gravity.length() * dt, dt),
    );
    let spacing = model.spec().grid.spacing[1];
    model.pinned_rows.held_depths(
        (config.held_depth, model.spec().grid.row_count, spacing),
        &mut state.scratch.held_depths,
    );
    let shape = Shape {
        grid: &model.spec().grid,
        layout: &model.layout,
        pinned_rows: &model.pinned_rows,
        inv_masses: &model.inv_masses,
    };
    let cloth_contact = config.self_collision.map(|contact| {
        let friction = model.spec().fabric.friction;
        let law = ClothContactLaw::new(shape.grid, contact.radius, friction, substep.h);
        let contacts = &mut state.scratch.cloth_contacts;
        contacts.find(shape, &state.positions, law);
        (law, contact.substep_interval.get())
    });
    for index in 0..substep.count {
        predict(simd, model, &substep, state);
        solve_far_and_soft(simd, model, (config, &strides), &substep, state);
        let sweep_count = config.structural_sweep_count.get();
        let last_count = LAST_SWEEPS.min(sweep_count);
        solve_structural(simd, model, sweep_count - last_count, &substep, state);
        if let Some((law, interval)) = cloth_contact
            && index % interval == 0
        {
            let columns = Columns {
                positions: &mut state.positions,
                predicted: &mut state.scratch.predicted,
                velocities: &state.velocities,
            };
            state.scratch.cloth_contacts.solve(columns, law);
        }
        solve_structural(simd, model, last_count, &substep, state);
        move_capsules(config, input, index, &substep, state);
        resolve_contacts_and_update_velocities(simd, model, &substep, state);
    }
    finish_pins(model, input.pin_targets, state);
}

/// Pinned particles fly straight to their targets, so every substep finds them on the way.
fn start_pins(model: &ClothModel, targets: &[Vec3], state: &mut ClothState, dt: f32) {
    for ((&pin, &target), &start) in model
        .pin_indices()
        .iter()
        .zip(targets)
        .zip(&state.pin_targets)
    {
        let (vector, lane) = model.layout.slot(pin as usize);
        state.velocities[vector].set(lane, (target - start) / dt);
    }
}

/// Rounding has moved the pins a little off their targets.
fn finish_pins(model: &ClothModel, targets: &[Vec3], state: &mut ClothState) {
    for (&pin, &target) in model.pin_indices().iter().zip(targets) {
        let (vector, lane) = model.layout.slot(pin as usize);
        state.positions[vector].set(lane, target);
    }
}

/// Stride links along rows, with their stride.
fn stride_links(model: &ClothModel, config: &SolverConfig) -> Vec<(u32, Vec<RowLink<2>>)> {
    let grid = &model.spec().grid;
    config
        .row_strides
        .iter()
        .map(|&stride| (stride, row_links(grid, &model.layout, [0, stride])))
        .collect()
}

/// Gravity, drag towards the air, and a straight flight.
#[inline(always)]
fn predict<S: Simd>(simd: S, model: &ClothModel, substep: &Substep, state: &mut ClothState) {
    let zero = f32x16::splat(simd, 0.0);
    let gravity = Vectors::splat(simd, substep.gravity_gain);
    let air = Vectors::splat(simd, substep.air_velocity);
    let kept = f32x16::splat(simd, substep.drag_kept);
    let h = f32x16::splat(simd, substep.h);
    let columns = state.positions.iter_mut().zip(&mut state.velocities);
    let columns = columns
        .zip(&mut state.scratch.predicted)
        .zip(&model.inv_masses);
    for (((position, velocity), predicted), inv_mass) in columns {
        let free = zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
        let before = Vectors::load(simd, velocity);
        let after = before.add(gravity).sub(air).scale(kept).add(air);
        let after = Vectors {
            x: free.select(after.x, before.x),
            y: free.select(after.y, before.y),
            z: free.select(after.z, before.z),
        };
        let moved = Vectors::load(simd, position).add(after.scale(h));
        after.store(velocity);
        moved.store(position);
        moved.store(predicted);
    }
}

#[inline(always)]
fn solve_far_and_soft<S: Simd>(
    simd: S,
    model: &ClothModel,
    (config, strides): (&SolverConfig, &[(u32, Vec<RowLink<2>>)]),
    substep: &Substep,
    state: &mut ClothState,
) {
    if let Some(scale) = config.tether_scale {
        solve_tethers(simd, model, scale, state);
    }
    let mut rows = Rows {
        positions: &mut state.positions,
        inv_masses: &model.inv_masses,
        group_count: model.layout.group_count,
    };
    let [u, v] = model.spec().grid.spacing;
    #[expect(clippy::cast_precision_loss, reason = "a stride is far below 2^24")]
    let squared = |stride: u32, spacing: f32| (stride as f32 * spacing) * (stride as f32 * spacing);
    for &stride in &config.column_strides {
        stride::solve_columns(simd, &mut rows, stride as usize, squared(stride, v));
    }
    for (stride, links) in strides {
        stride::solve_rows(simd, &mut rows, links, squared(*stride, u));
    }
    let clamps = &model.clamps;
    bend::solve_rows(
        simd,
        &mut rows,
        &model.row_triples,
        (substep.bend_across, clamps),
    );
    bend::solve_columns(simd, &mut rows, (substep.bend_down, clamps));
    shear::solve(simd, &mut rows, &model.row_pairs, substep.cell);
}

/// Last of the springs, so that what is drawn is stretched least.
#[inline(always)]
fn solve_structural<S: Simd>(
    simd: S,
    model: &ClothModel,
    sweep_count: u32,
    substep: &Substep,
    state: &mut ClothState,
) {
    let mut rows = Rows {
        positions: &mut state.positions,
        inv_masses: &model.inv_masses,
        group_count: model.layout.group_count,
    };
    for _ in 0..sweep_count {
        structural::solve_rows(simd, &mut rows, &model.row_pairs, substep.across);
        structural::solve_columns(simd, &mut rows, substep.down);
    }
}

#[inline(always)]
fn solve_tethers<S: Simd>(simd: S, model: &ClothModel, scale: f32, state: &mut ClothState) {
    let width = model.layout.group_count;
    match &model.tethers {
        Tethers::Loose => {}
        Tethers::Rows(anchor_rows) => {
            let spacing = model.spec().grid.spacing[1] * scale;
            for (row, &anchor_row) in anchor_rows.iter().enumerate() {
                let (anchor_row, distance) =
                    (anchor_row as usize, row.abs_diff(anchor_row as usize));
                if distance < 2 {
                    continue;
                }
                let range = |row: usize| row * width..(row + 1) * width;
                let split = row.max(anchor_row) * width;
                let (above, below) = state.positions.split_at_mut(split);
                let (points, anchors) = if anchor_row < row {
                    (&mut below[..width], &above[range(anchor_row)])
                } else {
                    (&mut above[range(row)], &below[..width])
                };
                #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
                let limit = distance as f32 * spacing;
                tether::solve_row(simd, points, &model.inv_masses[range(row)], anchors, limit);
            }
        }
        Tethers::Anchors(anchors) => {
            for anchor in anchors {
                let (vector, lane) = model.layout.slot(model.pin_indices()[anchor.pin] as usize);
                let position = state.positions[vector].get(lane);
                let columns = (&model.inv_masses, &anchor.rest_lengths);
                tether::solve_anchor(
                    simd,
                    &mut state.positions,
                    columns.0,
                    columns.1,
                    (position, scale),
                );
            }
        }
    }
}

fn move_capsules(
    config: &SolverConfig,
    input: &StepInput<'_>,
    index: u32,
    substep: &Substep,
    state: &mut ClothState,
) {
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    let (fraction, share) = (
        (index + 1) as f32 / substep.count as f32,
        1.0 / substep.count as f32,
    );
    state.scratch.moving_capsules.clear();
    state
        .scratch
        .moving_capsules
        .extend(
            state
                .capsules
                .iter()
                .zip(input.capsules)
                .map(|(before, after)| {
                    MovingCapsule::new([before, after], fraction, share, config.contact_offset)
                }),
        );
}

/// Contacts and velocities concern one row at a time, so threads share the rows and change nothing.
#[inline(always)]
fn resolve_contacts_and_update_velocities<S: Simd>(
    simd: S,
    model: &ClothModel,
    substep: &Substep,
    state: &mut ClothState,
) {
    let width = model.layout.group_count;
    let capsules = &state.scratch.moving_capsules[..];
    let contacts = &state.scratch.row_contacts;
    let held = &state.scratch.held_depths[..];
    let task = TASK_ROWS * width;
    let kernel = |index: usize, columns: ContactColumns<'_>| {
        simd.vectorize(
            #[inline(always)]
            || {
                finish_rows(
                    simd,
                    (index * TASK_ROWS, width),
                    columns,
                    (capsules, contacts, held),
                    substep,
                );
            },
        );
    };
    if rayon::current_num_threads() == 1 || model.layout.vector_count() < PARALLEL_VECTORS_MIN {
        let tasks = state
            .positions
            .chunks_mut(task)
            .zip(state.velocities.chunks_mut(task));
        let fixed = state
            .scratch
            .predicted
            .chunks(task)
            .zip(model.inv_masses.chunks(task));
        for (index, columns) in tasks.zip(fixed).enumerate() {
            kernel(index, columns);
        }
    } else {
        let tasks = state
            .positions
            .par_chunks_mut(task)
            .zip(state.velocities.par_chunks_mut(task));
        let fixed = state
            .scratch
            .predicted
            .par_chunks(task)
            .zip(model.inv_masses.par_chunks(task));
        tasks
            .zip(fixed)
            .enumerate()
            .for_each(|(index, columns)| kernel(index, columns));
    }
}

/// Positions and velocities, then predictions and inverse masses, of some rows.
type ContactColumns<'a> = (
    (&'a mut [Points], &'a mut [Points]),
    (&'a [Points], &'a [Scalars]),
);

#[inline(always)]
fn finish_rows<S: Simd>(
    simd: S,
    (first_row, width): (usize, usize),
    ((positions, velocities), (predicted, inv_masses)): ContactColumns<'_>,
    (capsules, contacts, held): (&[MovingCapsule], &RowContacts, &[f32]),
    substep: &Substep,
) {
    let h = f32x16::splat(simd, substep.h);
    let inv_h = f32x16::splat(simd, 1.0 / substep.h);
    for index in 0..positions.len() {
        let row = first_row + index / width;
        let indices = contacts.row(row);
        let mut position = Vectors::load(simd, &positions[index]);
        let velocity = Vectors::load(simd, &velocities[index]);
        let predicted = Vectors::load(simd, &predicted[index]);
        let inv_mass = f32x16::load_array_ref(simd, &inv_masses[index].0);
        let before = predicted.sub(velocity.scale(h));
        let held = f32x16::splat(simd, held[row]);
        let law = substep.contact;
        capsule::project(
            simd,
            &mut position,
            before,
            (inv_mass, held),
            (capsules, indices),
            law,
        );
        position.store(&mut positions[index]);
        velocity
            .add(position.sub(predicted).scale(inv_h))
            .store(&mut velocities[index]);
    }
}
