//! What a cloth is made of, before any method has prepared it.

use crate::{Fabric, Grid};

/// Everything that never changes about one cloth, method by method prepared into a model.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothSpec {
    /// Particles and their rest distances.
    pub grid: Grid,
    /// Material of the whole cloth.
    pub fabric: Fabric,
    /// Layers of cloth at each row: 1, or more where a hem or casing is folded. Multiplies the mass and
    /// the bending stiffness: each layer bends by itself. Shape `[row_count]`.
    pub row_layers: Vec<f32>,
    /// Whether border particles carry only the area of their own half cells.
    pub mass: MassLaw,
    /// Particles carried exactly by the body, row-major, shape `[particle_count]`.
    pub pinned: Vec<bool>,
}

impl ClothSpec {
    /// One layer of a fabric, nowhere pinned, whose particles carry the area nearest to them.
    #[must_use]
    pub fn new(grid: Grid, fabric: Fabric) -> Self {
        Self {
            grid,
            fabric,
            row_layers: vec![1.0; grid.row_count as usize],
            mass: MassLaw::AreaWeighted,
            pinned: vec![false; grid.particle_count()],
        }
    }

    /// This cloth, with the particles pinned of which `is_pinned` says so by row and column, besides those
    /// that are.
    #[must_use]
    pub fn pinned_where(mut self, is_pinned: impl Fn(u32, u32) -> bool) -> Self {
        for row in 0..self.grid.row_count {
            for column in 0..self.grid.column_count {
                self.pinned[self.grid.index(row, column)] |= is_pinned(row, column);
            }
        }
        self
    }
}

/// How the cloth's mass is shared among particles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MassLaw {
    /// Every particle weighs the same (the paper): total mass / particle count.
    Uniform,
    /// Each particle carries the area nearest to it: borders weigh half, corners a quarter.
    AreaWeighted,
}
