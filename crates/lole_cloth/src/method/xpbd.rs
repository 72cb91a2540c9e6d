//! Small substeps with one projection of every constraint each: the real-time method.
//!
//! Macklin and others 2019, "Small Steps in Physics Simulation", with XPBD's compliance. Every
//! substep predicts, solves the constraints from the farthest-reaching to the nearest, then
//! contacts, and turns what the projections changed into velocity: `v += (x - prediction) / h`
//! rather than `v = (x - x_before) / h`, because the second loses bits in `f32` at small `h`.

pub(crate) mod observed;
mod schedule;
mod work;

use std::cmp::Ordering;

use fearless_simd::{Simd, dispatch};
use glam::Vec3;
use lole_geom::{Surfel, trig};

use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::Range;
use crate::collision::cloth_cloth::{ClothContactLaw, Columns, Shape};
use crate::collision::face_contact::Moving;
use crate::collision::outside::Body;
use crate::collision::placement::Placement;
use crate::collision::repair::{CrossingRepair, Fixed};
use crate::collision::response::ContactLaw;
use crate::collision::surfel::{Cloth, Skin, SurfelContacts};
use crate::constraint::bend::Bend;
use crate::constraint::hysteresis::Friction;
use crate::constraint::pull::Pull;
use crate::constraint::shear::Cell;
use crate::constraint::structural::Spring;
use crate::constraint::tether::Tethers;
use crate::lanes::{LANES, Points};
use crate::method::fineness::Substeps;
use crate::method::reference::SpringConstants;
use crate::phase::{Observer, Phase};
use crate::{
    ClothModel, ClothState, Crossings, Hysteresis, SelfCollision, SolverConfig, StepInput,
};
use schedule::Schedule;
use schedule::Stage;
pub(crate) use work::RowStrides;
use work::Work;

/// Structural sweeps after the contacts of the cloth with itself: none leaves the springs strained
/// where folds are pressed together, all of them press folds through each other.
const LAST_SWEEPS: u32 = 1;

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
    /// Above the seam of a flounce, along it, and below; all alike where there is none.
    woven: [Woven; 3],
    /// Row of that seam; none is so far down where there is none.
    seam_row: usize,
    contact: ContactLaw,
}

/// What holds cloth together whose columns are so wide.
#[derive(Debug, Clone, PartialEq)]
struct Woven {
    across: Spring,
    down: Spring,
    cell: Cell,
    bend_across: f32,
    bend_down: f32,
    friction: Frictions,
}

/// Internal friction of the cloth, by what it resists; see [`crate::constraint::hysteresis`].
#[derive(Debug, Clone, PartialEq, Default)]
struct Frictions {
    /// Along rows and down columns.
    bend: [Option<Friction>; 2],
    shear: Option<Friction>,
}

impl Frictions {
    /// `bends` along rows and down columns and `cell` are those of the substep.
    fn new(model: &ClothModel, spacing: [f32; 2], bends: [f32; 2], cell: &Cell) -> Self {
        let fabric = &model.spec().fabric;
        if fabric.hysteresis == Hysteresis::NONE {
            return Self::default();
        }
        let inv_mass = model.largest_inv_mass;
        let bend = [0, 1].map(|along| {
            let residual = 0.5 * fabric.hysteresis.bend[along] / fabric.bend[along];
            let term = Bend {
                scaled_compliance: bends[along],
                has_clamp: false,
            };
            // The second difference is the curvature times the squared spacing.
            let second = residual * spacing[along] * spacing[along];
            Friction::new(second, term.own_share(inv_mass))
        });
        let residual = 0.5 * fabric.hysteresis.shear / fabric.shear;
        // An angle of shear stretches one diagonal by this share of it.
        let strain = residual * spacing[0] * spacing[1] / cell.diagonal.rest_length_squared();
        Self {
            bend,
            shear: Friction::new(strain, cell.own_share(inv_mass)),
        }
    }

    const fn acts(&self) -> bool {
        self.bend[0].is_some() || self.bend[1].is_some() || self.shear.is_some()
    }
}

impl Substep {
    fn new(
        (model, config, count): (&ClothModel, &SolverConfig, u32),
        air_velocity: Vec3,
        dt: f32,
    ) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "substeps and sweeps are few")]
        let (h, sweeps) = (
            dt / count as f32,
            config.structural_sweep_count.get() as f32,
        );
        let spec = model.spec();
        let woven = [0.0, 0.5, 1.0].map(|below: f32| {
            let fullness = (spec.grid.flounce).map_or(1.0, |flounce| flounce.fullness);
            let [u, v] = spec.grid.spacing;
            Woven::new(model, [u + (fullness - 1.0) * below * u, v], (h, sweeps))
        });
        let seam_row = spec.grid.flounce.map(|flounce| flounce.seam_row as usize);
        Self {
            h,
            count,
            gravity_gain: config.gravity * h,
            air_velocity,
            drag_kept: trig::exp(-spec.fabric.drag_rate * h),
            woven,
            seam_row: seam_row.unwrap_or(usize::MAX),
            contact: ContactLaw {
                friction: spec.fabric.friction,
                depenetration: config.depenetration_speed * h,
            },
        }
    }

    /// What holds a row together.
    fn row(&self, row: usize) -> &Woven {
        &self.woven[if self.seam_row < row { 2 } else { 0 }]
    }

    /// What holds the cells between a row and the next together. Those below a seam are gathered into
    /// it at their upper edge.
    fn cells(&self, row: usize) -> &Woven {
        &self.woven[match row.cmp(&self.seam_row) {
            Ordering::Less => 0,
            Ordering::Equal => 1,
            Ordering::Greater => 2,
        }]
    }

    /// Whether any of it has internal friction.
    fn has_friction(&self) -> bool {
        self.woven.iter().any(|woven| woven.friction.acts())
    }
}

impl Woven {
    /// Cells of `[u, v]` [m] in a substep of `h` [s].
    fn new(model: &ClothModel, [u, v]: [f32; 2], (h, sweeps): (f32, f32)) -> Self {
        let fabric = &model.spec().fabric;
        let scaled_compliance = |stiffness: f32| 1.0 / (stiffness * h * h);
        // A pass without `λ` adds its own stiffness to the passes before it, hence the factor.
        let spring = |rest_length: f32, stiffness: f32| Spring {
            pull: Pull::new(rest_length * rest_length),
            scaled_compliance: scaled_compliance(stiffness) * sweeps,
        };
        let constants = SpringConstants::from_fabric(fabric, [u, v].map(f64::from));
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
        let cell = Cell {
            diagonal: Pull::new(u * u + v * v),
            shear_compliance: scaled_compliance(shear),
            twist_compliance: scaled_compliance(2.0 * fabric.twist / (u * v)),
        };
        let bend_across = scaled_compliance(fabric.bend[0] * v / (u * u * u));
        let bend_down = scaled_compliance(fabric.bend[1] * u / (v * v * v));
        Self {
            across: spring(u, structural_u),
            down: spring(v, structural_v),
            friction: Frictions::new(model, [u, v], [bend_across, bend_down], &cell),
            cell,
            bend_across,
            bend_down,
        }
    }
}

/// One step of one cloth, cut into substeps so that several cloths can take theirs in turn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    substep: Substep,
    /// Duration of the step [s].
    dt: f32,
    cloth_contact: Option<(ClothContactLaw, u32)>,
    /// Coulomb friction coefficient of cloth on cloth.
    friction: f32,
}

/// Moves the cloth on by `dt`.
pub(crate) fn advance(
    model: &ClothModel,
    config: &SolverConfig,
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) {
    let plan = begin(model, config, (input, dt), state);
    for index in 0..plan.substep.count {
        if meets_itself(&plan, index, state) {
            predict_and_project((model, config, input), (&plan, index), state);
            collide_and_finish((model, config), (&plan, index), state);
        } else {
            start_substep((model, config, input), (&plan, index), state);
            let part = (Part::Whole, plan.range(index), index);
            run((model, config, &plan.substep), part, state);
        }
    }
    end((model, config), (input, dt), state);
}

/// Whether the cloth meets itself in a substep: where it is due, and where something is guarded.
fn meets_itself(plan: &Plan, index: u32, state: &ClothState) -> bool {
    plan.law(index).is_some() || !state.scratch.crossing_repair.guards.is_empty()
}

impl Plan {
    /// How the cloth meets itself in this substep, where it is due.
    fn law(&self, index: u32) -> Option<ClothContactLaw> {
        let (law, interval) = self.cloth_contact?;
        index.is_multiple_of(interval).then_some(law)
    }

    /// Which capsules are tested in this substep.
    fn range(&self, index: u32) -> Range {
        let is_last = index + 1 == self.substep.count;
        if is_last || (index + 1).is_multiple_of(FAR_INTERVAL) {
            Range::All
        } else {
            Range::Near
        }
    }
}

/// What is done once, before the first substep.
pub(crate) fn begin(
    model: &ClothModel,
    config: &SolverConfig,
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) -> Plan {
    begin_observed((model, config), (input, dt), state, None)
}

/// The same, with whoever wants to know how long each search takes.
fn begin_observed(
    (model, config): (&ClothModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
    observer: Observer<'_>,
) -> Plan {
    let count = state.fineness.substep_count(Substeps::of(config));
    let substep = Substep::new((model, config, count), input.air_velocity, dt);
    if substep.has_friction() {
        let [rows, width] = [model.layout.row_count, model.layout.group_count];
        let bend_counts = [rows * model.row_triples.len(), rows * width];
        let shear_count = rows * model.row_pairs.len();
        state.yarn_sets.prepare(bend_counts, shear_count);
    }
    if state.capsules.len() != input.capsules.len() {
        state.capsules.clear();
        state.capsules.extend_from_slice(input.capsules);
    }
    if state.surfels.len() != input.surfels.len() {
        state.surfels.clear();
        state.surfels.extend_from_slice(input.surfels);
    }
    start_pins(model, input.pin_targets, state, dt);
    find_body_contacts(model, config, (input, dt), state);
    let cloth_contact = find_contacts((model, config, &substep), (input, dt), state, observer);
    set_schedules(model, config, state);
    let scratch = &mut state.scratch;
    let starts = scratch.cloth_contacts.start_positions();
    let guards = &mut scratch.crossing_repair.guards;
    guards.prepare(starts, &model.layout, &model.inv_masses);
    Plan {
        friction: model.spec().fabric.cloth_friction,
        substep,
        dt,
        cloth_contact,
    }
}

/// The first part of a substep: a straight flight, and all springs but the last sweep.
pub(crate) fn predict_and_project(
    (model, config, input): (&ClothModel, &SolverConfig, &StepInput<'_>),
    (plan, index): (&Plan, u32),
    state: &mut ClothState,
) {
    start_substep((model, config, input), (plan, index), state);
    let part = (Part::BeforeContact, plan.range(index), index);
    run((model, config, &plan.substep), part, state);
}

/// The rest of a substep: contact of the cloth with itself, the last sweep, contact with the body,
/// and velocities.
pub(crate) fn collide_and_finish(
    (model, config): (&ClothModel, &SolverConfig),
    (plan, index): (&Plan, u32),
    state: &mut ClothState,
) {
    if let Some(law) = plan.law(index) {
        solve_cloth_contacts(law, state);
    }
    keep_guards(plan, state);
    let part = (Part::AfterContact, plan.range(index), index);
    run((model, config, &plan.substep), part, state);
}

/// Where the body is in a substep.
fn start_substep(
    (model, config, input): (&ClothModel, &SolverConfig, &StepInput<'_>),
    (plan, index): (&Plan, u32),
    state: &mut ClothState,
) {
    move_capsules(config, input, (index + 1, plan.substep.count), state);
    let substeps = (index, plan.substep.count);
    let level = config.instruction_set.level();
    with_skin(
        model,
        config,
        (input, plan.dt),
        state,
        |contacts, cloth, skin| {
            contacts.begin_substep(level, substeps, cloth, skin);
        },
    );
}

/// What is done once, after the last substep.
pub(crate) fn end(
    (model, config): (&ClothModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) {
    finish_pins(model, state);
    repair_crossings((model, config), (input, dt), state);
    let positions = &state.positions;
    (state.fineness).learn(Substeps::of(config), |strained, points| {
        model.layout.gather_points(positions, points);
        strained.count_grid(model, points);
    });
}

/// Takes back what came to cross in this step.
fn repair_crossings(
    (model, config): (&ClothModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) {
    let repairs = |contact: SelfCollision| contact.crossings == Crossings::Repair;
    if config.self_collision.is_some_and(repairs) {
        let scratch = &mut state.scratch;
        scratch.crossing_repair.repair(
            Fixed {
                level: config.instruction_set.level(),
                surface: &model.surface,
                layout: &model.layout,
                inv_masses: &model.inv_masses,
                body: &Body {
                    layout: &model.layout,
                    capsules: input.capsules,
                    contact_offset: config.contact_offset,
                    skin: &scratch.surfel_contacts,
                    held: &scratch.held_depths,
                },
                dt,
            },
            scratch.cloth_contacts.start_positions(),
            &mut state.positions,
            &mut state.velocities,
        );
    } else {
        // What a repair has left without contact, for the next one to draw out, would stay so.
        state.scratch.crossing_repair.forget();
    }
}

/// A substep in one piece, or cut where the cloth meets itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Whole,
    BeforeContact,
    AfterContact,
}

/// Order of the work by [`Part`].
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Schedules([Schedule; 3]);

/// Far capsules are tested in every so manyth substep, and in the last of a step.
const FAR_INTERVAL: u32 = 4;

/// Vector instructions are chosen here and where contacts are found, and nowhere between: what calls
/// them stays small for the compiler, however many ways lead here.
fn run(
    (model, config, substep): (&ClothModel, &SolverConfig, &Substep),
    part: (Part, Range, u32),
    state: &mut ClothState,
) {
    let level = config.instruction_set.level();
    dispatch!(level, simd => run_with(simd, (model, config, substep), part, state));
}

#[inline(always)]
fn run_with<S: Simd>(
    simd: S,
    (model, config, substep): (&ClothModel, &SolverConfig, &Substep),
    (part, range, index): (Part, Range, u32),
    state: &mut ClothState,
) {
    let scratch = &mut state.scratch;
    let mut work = Work {
        model,
        config,
        substep,
        strides: &scratch.row_strides,
        positions: &mut state.positions,
        velocities: &mut state.velocities,
        yarn_sets: &mut state.yarn_sets,
        predicted: &mut scratch.predicted,
        capsules: &scratch.moving_capsules,
        contacts: &scratch.row_contacts,
        range,
        surfel_contacts: &scratch.surfel_contacts,
        passed: scratch.surfel_contacts.passed(index),
        held: &scratch.held_depths,
    };
    scratch.schedules.0[part as usize].run(
        model.layout.row_count,
        #[inline(always)]
        |stage, row| work.perform(simd, stage, row),
    );
}

/// Orders the work: what reaches farthest first, structural springs last, so that what is drawn is
/// stretched least.
fn set_schedules(model: &ClothModel, config: &SolverConfig, state: &mut ClothState) {
    let scratch = &mut state.scratch;
    scratch.row_strides.set(model, config);
    let sweep_count = config.structural_sweep_count.get();
    let last_count = LAST_SWEEPS.min(sweep_count);
    for (part, schedule) in [Part::Whole, Part::BeforeContact, Part::AfterContact]
        .into_iter()
        .zip(&mut scratch.schedules.0)
    {
        schedule.clear();
        let sweeps = match part {
            Part::Whole => sweep_count,
            Part::BeforeContact => sweep_count - last_count,
            Part::AfterContact => last_count,
        };
        if part != Part::AfterContact {
            push_far_and_soft(model, config, schedule);
        }
        for _ in 0..sweeps {
            schedule.push(Stage::SpringsAlong);
            for _ in 0..config.gathered_sweep_count {
                schedule.push(Stage::SpringsGathered);
            }
            schedule.push(Stage::SpringsDown);
        }
        if part != Part::BeforeContact {
            schedule.push(Stage::Finish);
        }
    }
}

fn push_far_and_soft(model: &ClothModel, config: &SolverConfig, schedule: &mut Schedule) {
    schedule.push(Stage::Predict);
    if config.tether_scale.is_some() && model.tethers != Tethers::Loose {
        schedule.push(Stage::Tether(model.tethers.reach()));
    }
    let [u, v] = model.spec().grid.spacing;
    for &stride in &config.column_strides {
        schedule.push(Stage::ColumnStride(stride as usize, limit(stride, v)));
    }
    let fullness = (model.spec().grid.flounce).map_or(1.0, |flounce| flounce.fullness);
    for (index, &stride) in config.row_strides.iter().enumerate() {
        let limits = [u, fullness * u].map(|spacing| limit(stride, spacing));
        schedule.push(Stage::RowStride(index, limits));
    }
    schedule.push(Stage::BendAlong);
    schedule.push(Stage::BendDown);
    schedule.push(Stage::Cells);
}

/// What pulls where so many cells of a spacing [m] are the limit.
#[expect(clippy::cast_precision_loss, reason = "a stride is far below 2^24")]
fn limit(cells: u32, spacing: f32) -> Pull {
    let reach = cells as f32 * spacing;
    Pull::new(reach * reach)
}

/// Where each row may touch the body in this step.
pub(super) fn find_body_contacts(
    model: &ClothModel,
    config: &SolverConfig,
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
) {
    let (scratch, positions, velocities) =
        (&mut state.scratch, &state.positions, &state.velocities);
    let speed_gain = config.gravity.length() * dt;
    let level = config.instruction_set.level();
    dispatch!(level, simd => scratch.row_contacts.find(
        simd,
        (positions, velocities, model.layout.group_count),
        [&state.capsules, input.capsules],
        (config.contact_offset, speed_gain, dt),
    ));
    let spacing = model.spec().grid.spacing[1];
    model.pinned_rows.held_depths(
        (config.held_depth, model.spec().grid.row_count, spacing),
        &mut scratch.held_depths,
    );
    let substep_count = state.fineness.substep_count(Substeps::of(config));
    with_skin(
        model,
        config,
        (input, dt),
        state,
        |contacts, cloth, skin| {
            contacts.plan(cloth, skin, substep_count);
        },
    );
}

fn cloth_of<'a>(
    (model, config): (&'a ClothModel, &SolverConfig),
    (positions, velocities): (&'a [Points], &'a [Points]),
    (held, repair): (&'a [f32], &'a CrossingRepair),
    dt: f32,
) -> Cloth<'a> {
    Cloth {
        layout: &model.layout,
        positions,
        velocities,
        held,
        spacing: model.spec().grid.spacing[0],
        speed_gain: config.gravity.length() * dt,
        dt,
        held_back: &repair.held_back,
        torn: repair.torn(),
        hanging: model,
    }
}

const fn skin_of<'a>(
    config: &SolverConfig,
    before: &'a [Surfel],
    input: &StepInput<'a>,
) -> Skin<'a> {
    Skin {
        before,
        after: input.surfels,
        offset: config.contact_offset,
    }
}

fn with_skin(
    model: &ClothModel,
    config: &SolverConfig,
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
    act: impl FnOnce(&mut SurfelContacts, Cloth<'_>, Skin<'_>),
) {
    let scratch = &mut state.scratch;
    let moving = (&state.positions[..], &state.velocities[..]);
    let held = (&scratch.held_depths[..], &scratch.crossing_repair);
    let cloth = cloth_of((model, config), moving, held, dt);
    let skin = skin_of(config, &state.surfels, input);
    act(&mut scratch.surfel_contacts, cloth, skin);
}
/// Where the cloth may touch the skin, and, at the same time, where it may touch itself in this
/// step: the law of that, and the interval of substeps.
fn find_contacts(
    (model, config, substep): (&ClothModel, &SolverConfig, &Substep),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
    observer: Observer<'_>,
) -> Option<(ClothContactLaw, u32)> {
    let scratch = &mut state.scratch;
    let (positions, velocities) = (&state.positions, &state.velocities);
    let (cloth, skin) = (
        cloth_of(
            (model, config),
            (positions, velocities),
            (&scratch.held_depths, &scratch.crossing_repair),
            dt,
        ),
        skin_of(config, &state.surfels, input),
    );
    let surfel_contacts = &mut scratch.surfel_contacts;
    let cloth_contacts = &mut scratch.cloth_contacts;
    let is_tangled = &scratch.crossing_repair.is_tangled;
    let level = config.instruction_set.level();
    let mut find_skin = || surfel_contacts.begin_substep(level, (0, substep.count), cloth, skin);
    let Some(contact) = config.self_collision else {
        find_skin();
        if let Some(passed) = observer {
            passed(Phase::FindBody);
        }
        return None;
    };
    let shape = Shape {
        grid: &model.spec().grid,
        layout: &model.layout,
        pinned_rows: &model.pinned_rows,
        inv_masses: &model.inv_masses,
        is_tangled,
    };
    let friction = model.spec().fabric.cloth_friction;
    let law = ClothContactLaw::new(shape.grid, contact.radius, friction, substep.h);
    let mut find_cloth =
        || dispatch!(level, simd => cloth_contacts.find(simd, shape, positions, law));
    if let Some(passed) = observer {
        find_skin();
        passed(Phase::FindBody);
        find_cloth();
        passed(Phase::FindSelf);
    } else {
        rayon::join(find_skin, find_cloth);
    }
    Some((law, contact.substep_interval.get()))
}

/// Keeps what was parted apart.
fn keep_guards(plan: &Plan, state: &mut ClothState) {
    let guards = std::mem::take(&mut state.scratch.crossing_repair.guards);
    guards.solve(state, plan.friction, plan.substep.h);
    state.scratch.crossing_repair.guards = guards;
}

impl Moving for ClothState {
    fn place(&self, _piece: usize, slot: usize) -> Vec3 {
        self.positions[slot / LANES].get(slot % LANES)
    }

    fn start(&self, _piece: usize, slot: usize, h: f32) -> Vec3 {
        let (vector, lane) = (slot / LANES, slot % LANES);
        self.scratch.predicted[vector].get(lane) - self.velocities[vector].get(lane) * h
    }

    fn put(&mut self, _piece: usize, slot: usize, position: Vec3, quiet: Vec3) {
        let (vector, lane) = (slot / LANES, slot % LANES);
        self.positions[vector].set(lane, position);
        let predicted = &mut self.scratch.predicted[vector];
        predicted.set(lane, predicted.get(lane) + quiet);
    }
}

fn solve_cloth_contacts(law: ClothContactLaw, state: &mut ClothState) {
    let columns = Columns {
        positions: &mut state.positions,
        predicted: &mut state.scratch.predicted,
        velocities: &state.velocities,
    };
    state.scratch.cloth_contacts.solve(columns, law);
}

/// Pinned particles fly straight to where they go, so every substep finds them on the way.
pub(crate) fn start_pins(model: &ClothModel, targets: &[Vec3], state: &mut ClothState, dt: f32) {
    let pins: (&dyn Placement, _) = (&model.layout, model.pin_indices());
    let goals = &mut state.scratch.pin_goals;
    goals.set(pins, (&state.pin_targets, targets), &state.positions);
    goals.start(pins, (&state.positions, &mut state.velocities), dt);
}

/// Rounding has moved the pins a little off where they go.
pub(crate) fn finish_pins(model: &ClothModel, state: &mut ClothState) {
    let goals = &state.scratch.pin_goals;
    goals.finish((&model.layout, model.pin_indices()), &mut state.positions);
}

/// Moves the capsules to where they are after `done` of `count` parts of the step.
pub(super) fn move_capsules(
    config: &SolverConfig,
    input: &StepInput<'_>,
    (done, count): (u32, u32),
    state: &mut ClothState,
) {
    #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
    let (fraction, share) = (done as f32 / count as f32, 1.0 / count as f32);
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
