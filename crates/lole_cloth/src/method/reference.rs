//! The reference cloth: the paper's mass-spring grid in `f64`, with plate bending beside it.
//!
//! Springs are edge lists, one per family; a model never changes once it is built.
//! Forces are gathered: every particle sums its own springs in a fixed order, so any number of
//! threads gives the same bits, and the two ends of a spring feel exactly opposite forces.

mod bound;
mod constants;
mod energy;
mod plate;
mod springs;

use glam::DVec3;
use lole_geom::{Capsule, trig64};

pub use constants::SpringConstants;
pub use energy::Momentum;
pub use springs::{SpringFamily, Springs};

use crate::model::particle_masses;
use crate::{BuildError, ClothSpec, Grid, Topology};
use plate::Plate;
use springs::SpringGather;

/// What never changes about one cloth: masses, springs, plate bending and pins.
#[derive(Debug, Clone)]
pub struct ReferenceModel {
    grid: Grid,
    constants: SpringConstants,
    drag_rate: f64,
    masses: Vec<f64>,
    pinned: Vec<bool>,
    pin_indices: Vec<u32>,
    springs: Vec<Springs>,
    gather: SpringGather,
    plate: Plate,
    frequency_bounds_squared: Vec<f64>,
}

/// What changes: where the particles are and how they move.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReferenceState {
    /// Positions [m], row-major.
    pub positions: Vec<DVec3>,
    /// Velocities [m/s], row-major.
    pub velocities: Vec<DVec3>,
    /// The capsules at the end of the last step; empty before the first.
    pub capsules: Vec<Capsule>,
}

impl ReferenceState {
    /// Particles at `positions` [m], at rest.
    #[must_use]
    pub fn at_rest(positions: Vec<DVec3>) -> Self {
        Self {
            velocities: vec![DVec3::ZERO; positions.len()],
            positions,
            capsules: Vec::new(),
        }
    }
}

impl ReferenceModel {
    /// A model of `spec` with the spring constants that its fabric has on its grid.
    ///
    /// # Errors
    /// When the specification does not fit together; the sentence says what to change.
    pub fn new(spec: &ClothSpec) -> Result<Self, BuildError> {
        let spacing = spec.grid.spacing.map(f64::from);
        Self::with_constants(spec, SpringConstants::from_fabric(&spec.fabric, spacing))
    }

    /// A model of `spec` with the given spring constants in place of its fabric's.
    ///
    /// # Errors
    /// When the specification does not fit together, or a constant is negative or not finite; the sentence
    /// says what to change.
    pub fn with_constants(
        spec: &ClothSpec,
        constants: SpringConstants,
    ) -> Result<Self, BuildError> {
        check_spec(spec)?;
        constants.check()?;
        let masses = particle_masses(spec).into_iter().map(f64::from).collect();
        let springs = springs::build(&spec.grid, &constants, &spec.fabric);
        let gather = SpringGather::new(spec.grid.particle_count(), &springs);
        let plate = Plate::new(spec, &constants);
        let pin_indices = (0u32..)
            .zip(&spec.pinned)
            .filter_map(|(index, &is_pinned)| is_pinned.then_some(index))
            .collect();
        let mut model = Self {
            grid: spec.grid,
            constants,
            drag_rate: f64::from(spec.fabric.drag_rate),
            masses,
            pinned: spec.pinned.clone(),
            pin_indices,
            springs,
            gather,
            plate,
            frequency_bounds_squared: Vec::new(),
        };
        model.frequency_bounds_squared = bound::frequency_bounds_squared(&model);
        Ok(model)
    }

    /// The grid that the particles stand in.
    #[must_use]
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The constants the springs were built with.
    #[must_use]
    pub const fn constants(&self) -> &SpringConstants {
        &self.constants
    }

    /// Mass of each particle [kg], row-major.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Mass [kg] of the lightest free particle; zero if all are pinned.
    #[must_use]
    pub fn lightest_mass(&self) -> f64 {
        let free = self.masses.iter().zip(&self.pinned);
        let lightest = free
            .filter(|&(_, &is_pinned)| !is_pinned)
            .fold(f64::INFINITY, |least, (&mass, _)| least.min(mass));
        if lightest.is_finite() { lightest } else { 0.0 }
    }

    /// The rate `ρ / m` [1/s] of equation (3).
    #[must_use]
    pub const fn drag_rate(&self) -> f64 {
        self.drag_rate
    }

    /// Whether each particle is carried by the body.
    #[must_use]
    pub fn pinned(&self) -> &[bool] {
        &self.pinned
    }

    /// Particles carried by the body, in the order of the targets a step takes.
    #[must_use]
    pub fn pin_indices(&self) -> &[u32] {
        &self.pin_indices
    }

    /// The edge lists, one for each family with a constant above zero and each width of its columns.
    #[must_use]
    pub fn springs(&self) -> &[Springs] {
        &self.springs
    }

    /// Number of springs of all families.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        self.springs.iter().map(|family| family.ends.len()).sum()
    }

    /// Positions [m] at which no spring of cloth that is not crimped is stretched: a flat sheet in the plane `z = 0`, rows
    /// downwards; a tube as the regular polygon whose sides are the spacing, its axis along `-y`.
    #[must_use]
    pub fn rest_positions(&self) -> Vec<DVec3> {
        let grid = &self.grid;
        let [width, height] = grid.spacing.map(f64::from);
        let turn = std::f64::consts::TAU / f64::from(grid.column_count);
        let radius = 0.5 * width / trig64::sin(0.5 * turn);
        let mut positions = Vec::with_capacity(grid.particle_count());
        for row in 0..grid.row_count {
            let y = -height * f64::from(row);
            positions.extend((0..grid.column_count).map(|column| {
                let u = f64::from(column);
                match grid.topology {
                    Topology::Sheet => DVec3::new(width * u, y, 0.0),
                    Topology::Tube => {
                        let (sin, cos) = trig64::sin_cos(turn * u);
                        DVec3::new(radius * cos, y, radius * sin)
                    }
                }
            }));
        }
        positions
    }

    /// Force [N] of springs and plate on the particle `index`: equation (1) summed over its
    /// springs, and the plate's in place of the bend springs.
    #[inline]
    #[must_use]
    pub fn internal_force(&self, index: usize, positions: &[DVec3]) -> DVec3 {
        self.gather.force(index, positions) + self.plate.force(index, positions)
    }
}

/// Whether counts, columns and densities fit together.
fn check_spec(spec: &ClothSpec) -> Result<(), BuildError> {
    let grid = &spec.grid;
    if grid.column_count < 3 || grid.row_count < 3 {
        return Err(BuildError::GridTooSmall {
            column_count: grid.column_count,
            row_count: grid.row_count,
        });
    }
    if grid.flounce.is_some() {
        return Err(BuildError::Flounce);
    }
    let columns = [
        ("row_layers", spec.row_layers.len(), grid.row_count as usize),
        ("pinned", spec.pinned.len(), grid.particle_count()),
    ];
    for (field, actual, expected) in columns {
        if actual != expected {
            return Err(BuildError::WrongLength {
                field,
                actual,
                expected,
            });
        }
    }
    check_positive("spacing along u", f64::from(grid.spacing[0]))?;
    check_positive("spacing along v", f64::from(grid.spacing[1]))?;
    if let Some(crimp) = grid.crimp {
        check_positive("grid.crimp.share", f64::from(crimp.share))?;
    }
    check_positive("areal_density", f64::from(spec.fabric.areal_density))?;
    for &layers in &spec.row_layers {
        check_positive("row_layers", f64::from(layers))?;
    }
    check_not_negative("drag_rate", f64::from(spec.fabric.drag_rate))
}

/// An error unless `value` is finite and above zero.
fn check_positive(field: &'static str, value: f64) -> Result<(), BuildError> {
    if value.is_finite() && 0.0 < value {
        return Ok(());
    }
    Err(out_of_range(field, value, "finite and above 0"))
}

/// An error unless `value` is finite and not negative.
fn check_not_negative(field: &'static str, value: f64) -> Result<(), BuildError> {
    if value.is_finite() && 0.0 <= value {
        return Ok(());
    }
    Err(out_of_range(field, value, "finite and not negative"))
}

/// The error about `value`.
fn out_of_range(field: &'static str, value: f64, rule: &'static str) -> BuildError {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the value is only shown to the reader"
    )]
    let value = value as f32;
    BuildError::OutOfRange { field, value, rule }
}

/// Cells that belong to a row: a half at the top and bottom border, else one.
fn row_share(grid: &Grid, row: u32) -> f64 {
    if row == 0 || row + 1 == grid.row_count {
        0.5
    } else {
        1.0
    }
}

/// Cells that belong to a column: a half at the free border of a sheet, else one.
fn column_share(grid: &Grid, column: u32) -> f64 {
    let is_border = column == 0 || column + 1 == grid.column_count;
    match grid.topology {
        Topology::Sheet if is_border => 0.5,
        Topology::Sheet | Topology::Tube => 1.0,
    }
}
