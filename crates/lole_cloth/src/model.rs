//! A cloth prepared for the real-time method: what never changes from step to step.

use crate::collision::pinned_rows::PinnedRows;
use crate::collision::surface::Surface;
use crate::collision::surfel::room::{Anchor, Hanging};
use crate::constraint::RowMasses;
use crate::constraint::bend::{self, Clamps};
use crate::constraint::tether::Tethers;
use crate::lanes::{Layout, Points, RowLink, Scalars, narrow, row_links};
use crate::{ClothSpec, Flounce, MassLaw, Topology};

/// Why a [`ClothSpec`] cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BuildError {
    /// Fewer than three rows or columns.
    #[error(
        "the cloth has {column_count} columns and {row_count} rows; give it at least 3 of each"
    )]
    GridTooSmall {
        /// Columns asked for.
        column_count: u32,
        /// Rows asked for.
        row_count: u32,
    },
    /// A column of the specification has another length than the grid asks for.
    #[error("`{field}` has {actual} entries; the grid needs {expected}")]
    WrongLength {
        /// Field of the specification.
        field: &'static str,
        /// Entries found.
        actual: usize,
        /// Entries needed.
        expected: usize,
    },
    /// A method that moves cloth of one width only.
    #[error("this method moves no flounce; choose xpbd, or a garment without one")]
    Flounce,
    /// A method that moves cloth whose columns are all as wide.
    #[error("this method moves no crimped cloth; choose xpbd, or cloth that lies flat")]
    Crimp,
    /// A number that is not finite or out of its range.
    #[error("`{field}` is {value}; it must be {rule}")]
    OutOfRange {
        /// Field of the specification.
        field: &'static str,
        /// The value found.
        value: f32,
        /// What would be allowed.
        rule: &'static str,
    },
}

/// A cloth prepared for the real-time method.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothModel {
    spec: ClothSpec,
    pin_indices: Vec<u32>,
    pub(crate) layout: Layout,
    /// [1/kg]; 0 for pinned particles and for lanes without a column.
    pub(crate) inv_masses: Vec<Scalars>,
    /// Inverse mass of the lightest free particle [1/kg].
    pub(crate) largest_inv_mass: f32,
    /// By row, the inverse mass of every particle [1/kg] where all have the same.
    even_rows: Vec<Option<f32>>,
    /// Neighbors along a row.
    pub(crate) row_pairs: Vec<RowLink<2>>,
    /// A column and the two right of it.
    pub(crate) row_triples: Vec<RowLink<3>>,
    pub(crate) clamps: Clamps,
    /// By group, how much softer bending down the columns is at the borders.
    pub(crate) bend_borders: Vec<Option<Box<Scalars>>>,
    pub(crate) tethers: Tethers,
    pub(crate) pinned_rows: PinnedRows,
    pub(crate) surface: Surface,
}

impl ClothModel {
    /// Prepares `spec`.
    ///
    /// # Errors
    /// When a length does not fit the grid, or a number is not finite or out of range.
    pub fn new(spec: &ClothSpec) -> Result<Self, BuildError> {
        check_lengths(spec)?;
        check_numbers(spec)?;
        let layout = Layout::new(&spec.grid);
        let pin_indices: Vec<u32> = (0u32..)
            .zip(&spec.pinned)
            .filter(|(_, pinned)| **pinned)
            .map(|(i, _)| i)
            .collect();
        let inv_masses: Vec<f32> = particle_masses(spec)
            .into_iter()
            .zip(&spec.pinned)
            .map(|(mass, &pinned)| if pinned { 0.0 } else { 1.0 / mass })
            .collect();
        Ok(Self {
            even_rows: inv_masses
                .chunks_exact(spec.grid.column_count as usize)
                .map(even)
                .collect(),
            largest_inv_mass: inv_masses.iter().copied().fold(0.0, f32::max),
            inv_masses: layout.scatter(&inv_masses),
            row_pairs: row_links(&spec.grid, &layout, [0, 1]),
            row_triples: row_links(&spec.grid, &layout, [0, 1, 2]),
            clamps: Clamps::new(spec),
            bend_borders: bend::borders(spec, &layout),
            tethers: Tethers::new(spec, &layout, &pin_indices),
            pinned_rows: PinnedRows::new(spec),
            surface: Surface::from_grid(&spec.grid),
            spec: spec.clone(),
            pin_indices,
            layout,
        })
    }

    /// Memory that it holds [byte].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        let links = |count: usize| count * (size_of::<RowLink<3>>() + size_of::<Scalars>());
        let tethers = match &self.tethers {
            Tethers::Loose => 0,
            Tethers::Rows(rows) => size_of_val(&rows[..]),
            Tethers::Anchors(anchors) => (anchors.iter())
                .map(|anchor| size_of_val(&anchor.inv_squares[..]))
                .sum(),
        };
        size_of_val(&self.spec.pinned[..])
            + size_of_val(&self.pin_indices[..])
            + size_of_val(&self.inv_masses[..])
            + links(self.row_pairs.len() + self.row_triples.len())
            + self.layout.byte_count()
            + tethers
            + self.surface.byte_count()
    }

    /// What the cloth was made from.
    #[must_use]
    pub const fn spec(&self) -> &ClothSpec {
        &self.spec
    }

    /// Inverse masses of a row.
    pub(crate) fn row_masses(&self, row: usize) -> RowMasses<'_> {
        let width = self.layout.group_count;
        RowMasses {
            lanes: &self.inv_masses[row * width..(row + 1) * width],
            even: self.even_rows[row],
        }
    }

    /// Row-major indices of the pinned particles, ascending.
    #[must_use]
    pub fn pin_indices(&self) -> &[u32] {
        &self.pin_indices
    }

    /// Structural and shear springs, bending and twist terms together.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        let grid = &self.spec.grid;
        let (columns, rows) = (grid.column_count as usize, grid.row_count as usize);
        let cells_across = grid.cell_columns() as usize;
        let structural = cells_across * rows + columns * (rows - 1);
        let shear_and_twist = 3 * cells_across * (rows - 1);
        let bend_across = match grid.topology {
            Topology::Sheet => columns - 2,
            Topology::Tube => columns,
        };
        structural + shear_and_twist + bend_across * rows + columns * (rows - 2)
    }
}

/// The value that all `values` have.
fn even(values: &[f32]) -> Option<f32> {
    let first = *values.first()?;
    let alike = values
        .iter()
        .all(|value| value.to_bits() == first.to_bits());
    alike.then_some(first)
}

impl Hanging for ClothModel {
    fn anchor(&self, (vector, lane): (usize, usize)) -> Option<Anchor> {
        let width = self.layout.group_count;
        let (pins, share, far) = self.pinned_rows.between(vector / width)?;
        #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
        let length = far as f32 * self.spec.grid.spacing[1];
        Some(Anchor {
            pins: pins.map(|row| (row as usize * width + vector % width, lane)),
            share,
            length,
        })
    }

    /// Of its springs but those that cross the ends of strips.
    fn stretch_at(&self, positions: &[Points], (vector, lane): (usize, usize)) -> f32 {
        let width = self.layout.group_count;
        let (row, group) = (vector / width, vector % width);
        let at = positions[vector].get(lane);
        let stretch =
            |other: usize, rest: f32| positions[other].get(lane).distance(at) / rest - 1.0;
        let [across, down] = [
            self.spec.grid.row_spacing(narrow(row)),
            self.spec.grid.spacing[1],
        ];
        let above = (0 < row).then(|| stretch(vector - width, down));
        let below = (row + 1 < self.layout.row_count).then(|| stretch(vector + width, down));
        let left = (0 < group).then(|| stretch(vector - 1, across));
        // The last group of some strips is empty.
        let right = (group + 2 < width).then(|| stretch(vector + 1, across));
        let all = [above, below, left, right].into_iter().flatten();
        all.fold(0.0, f32::max)
    }
}

/// Mass of every particle [kg], row-major.
#[must_use]
pub fn particle_masses(spec: &ClothSpec) -> Vec<f32> {
    let grid = &spec.grid;
    let cell_mass = spec.fabric.areal_density * grid.spacing[0] * grid.spacing[1];
    #[expect(
        clippy::cast_precision_loss,
        reason = "cells are counted below 2^24 or rounded alike"
    )]
    let uniform = {
        let rows = (0..grid.row_count - 1).map(|row| grid.cell_fullness(row));
        grid.cell_columns() as f32 * rows.sum::<f32>() * cell_mass / grid.particle_count() as f32
    };
    // Cells that touch a row, in those of the first row, and likewise cells that touch a column.
    let in_row = |row: u32| {
        let above = row.checked_sub(1).map(|above| grid.cell_fullness(above));
        let below = (row + 1 < grid.row_count).then(|| grid.cell_fullness(row));
        0.5 * above.unwrap_or(0.0) + 0.5 * below.unwrap_or(0.0)
    };
    let in_column = |column: u32| match grid.topology {
        Topology::Sheet if column == 0 || column + 1 == grid.column_count => 0.5,
        Topology::Sheet | Topology::Tube => 1.0,
    };
    let mut masses = Vec::with_capacity(grid.particle_count());
    for (row, &layers) in (0..grid.row_count).zip(&spec.row_layers) {
        masses.extend((0..grid.column_count).map(|column| {
            let single = match spec.mass {
                MassLaw::Uniform => uniform,
                MassLaw::AreaWeighted => cell_mass * in_row(row) * in_column(column),
            };
            single * layers
        }));
    }
    masses
}

fn check_lengths(spec: &ClothSpec) -> Result<(), BuildError> {
    let grid = &spec.grid;
    if grid.column_count < 3 || grid.row_count < 3 {
        return Err(BuildError::GridTooSmall {
            column_count: grid.column_count,
            row_count: grid.row_count,
        });
    }
    let lengths = [
        ("row_layers", spec.row_layers.len(), grid.row_count as usize),
        ("pinned", spec.pinned.len(), grid.particle_count()),
    ];
    for (field, actual, expected) in lengths {
        if actual != expected {
            return Err(BuildError::WrongLength {
                field,
                actual,
                expected,
            });
        }
    }
    Ok(())
}

fn check_numbers(spec: &ClothSpec) -> Result<(), BuildError> {
    let fabric = &spec.fabric;
    let positive = [
        ("grid.spacing", spec.grid.spacing[0]),
        ("grid.spacing", spec.grid.spacing[1]),
        ("fabric.areal_density", fabric.areal_density),
    ];
    if let Some(crimp) = spec.grid.crimp
        && !(0.0 < crimp.share && crimp.share <= 1.0)
    {
        return Err(BuildError::OutOfRange {
            field: "grid.crimp.share",
            value: crimp.share,
            rule: "above 0 and at most 1",
        });
    }
    if let Some(Flounce { seam_row, fullness }) = spec.grid.flounce {
        if !(fullness.is_finite() && 1.0 <= fullness) {
            return Err(BuildError::OutOfRange {
                field: "grid.flounce.fullness",
                value: fullness,
                rule: "finite and at least 1",
            });
        }
        if seam_row == 0 || spec.grid.row_count <= seam_row + 1 {
            return Err(BuildError::OutOfRange {
                field: "grid.flounce.seam_row",
                value: seam_row as f32,
                rule: "neither the first row nor the last",
            });
        }
    }
    let layers = spec.row_layers.iter().map(|&layers| ("row_layers", layers));
    for (field, value) in positive.into_iter().chain(layers) {
        if !(value.is_finite() && 0.0 < value) {
            return Err(BuildError::OutOfRange {
                field,
                value,
                rule: "finite and above 0",
            });
        }
    }
    let not_negative = [
        ("fabric.stretch", fabric.stretch[0]),
        ("fabric.stretch", fabric.stretch[1]),
        ("fabric.shear", fabric.shear),
        ("fabric.bend", fabric.bend[0]),
        ("fabric.bend", fabric.bend[1]),
        ("fabric.twist", fabric.twist),
        ("fabric.hysteresis.bend", fabric.hysteresis.bend[0]),
        ("fabric.hysteresis.bend", fabric.hysteresis.bend[1]),
        ("fabric.hysteresis.shear", fabric.hysteresis.shear),
        ("fabric.friction", fabric.friction),
        ("fabric.cloth_friction", fabric.cloth_friction),
        ("fabric.drag_rate", fabric.drag_rate),
    ];
    for (field, value) in not_negative {
        if !(value.is_finite() && 0.0 <= value) {
            return Err(BuildError::OutOfRange {
                field,
                value,
                rule: "finite and not negative",
            });
        }
    }
    Ok(())
}
