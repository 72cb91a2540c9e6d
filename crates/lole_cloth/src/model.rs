//! A cloth prepared for the real-time method: what never changes from step to step.
use crate::ClothSpec;

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
}

impl ClothModel {
    /// Prepares `spec`.
    ///
    /// # Errors
    /// When a length does not fit the grid, or a number is not finite or out of range.
    pub fn new(spec: &ClothSpec) -> Result<Self, BuildError> {
        Ok(Self {
            spec: spec.clone(),
            pin_indices: (0u32..)
                .zip(&spec.pinned)
                .filter(|(_, pinned)| **pinned)
                .map(|(i, _)| i)
                .collect(),
        })
    }

    /// What the cloth was made from.
    #[must_use]
    pub const fn spec(&self) -> &ClothSpec {
        &self.spec
    }

    /// Row-major indices of the pinned particles, ascending.
    #[must_use]
    pub fn pin_indices(&self) -> &[u32] {
        &self.pin_indices
    }

    /// Structural, shear and bending springs together.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        let grid = &self.spec.grid;
        let (columns, rows) = (grid.cell_columns() as usize, grid.row_count as usize);
        columns * rows + grid.column_count as usize * (rows - 1) + 2 * columns * (rows - 1)
    }
}
