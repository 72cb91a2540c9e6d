//! Narrow strips: three columns wide, as many rows long as asked.

use glam::DVec3;
use lole_cloth::{ClothSpec, Fabric, Grid, MassLaw, Topology};

use super::rig::GRAVITY;

/// Columns of a strip: the fewest that a cloth can have.
pub(super) const COLUMNS: u32 = 3;

/// Mass per area of every strip [kg/m²].
pub(super) const AREAL_DENSITY: f32 = 0.15;

/// A strip by its length and stiffness.
pub(super) struct Strip {
    /// From the first row to the last [m].
    pub(super) length: f64,
    /// Rows less one.
    pub(super) segments: u32,
    /// Membrane stiffness along it [N/m].
    pub(super) stretch: f64,
    /// Bending rigidity along it [N·m].
    pub(super) bend: f64,
    /// Drag that brings it to rest [1/s].
    pub(super) drag: f64,
    /// Coulomb friction coefficient against capsules.
    pub(super) friction: f64,
}

impl Strip {
    /// Distance from row to row [m].
    pub(super) fn spacing(&self) -> f64 {
        self.length / f64::from(self.segments)
    }

    /// The cloth, with these rows held.
    #[expect(clippy::cast_possible_truncation, reason = "specifications are in f32")]
    pub(super) fn spec(&self, held_rows: &[u32]) -> ClothSpec {
        let spacing = self.spacing() as f32;
        let grid = Grid {
            column_count: COLUMNS,
            row_count: self.segments + 1,
            topology: Topology::Sheet,
            spacing: [spacing; 2],
            flounce: None,
            crimp: None,
        };
        let mut pinned = vec![false; grid.particle_count()];
        for &row in held_rows {
            let first = grid.index(row, 0);
            pinned[first..first + COLUMNS as usize].fill(true);
        }
        ClothSpec {
            fabric: Fabric {
                areal_density: AREAL_DENSITY,
                thickness: 3.0e-4,
                stretch: [0.0, self.stretch as f32],
                shear: 0.0,
                bend: [0.0, self.bend as f32],
                twist: 0.0,
                hysteresis: lole_cloth::Hysteresis::NONE,
                friction: self.friction as f32,
                cloth_friction: self.friction as f32,
                drag_rate: self.drag as f32,
            },
            row_layers: vec![1.0; grid.row_count as usize],
            mass: MassLaw::AreaWeighted,
            pinned,
            grid,
        }
    }

    /// Particles with the row `i` in `place(i · spacing)`, columns side by side along `z`.
    pub(super) fn laid(&self, place: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
        let spacing = self.spacing();
        (0..=self.segments)
            .flat_map(|row| {
                let middle = place(f64::from(row) * spacing);
                (0..COLUMNS).map(move |column| middle + DVec3::Z * (f64::from(column) * spacing))
            })
            .collect()
    }
}

/// The middle particle of `row`.
pub(super) fn middle(positions: &[DVec3], row: u32) -> DVec3 {
    positions[(row * COLUMNS + COLUMNS / 2) as usize]
}

/// Weight per area [N/m²].
pub(super) fn weight() -> f64 {
    f64::from(AREAL_DENSITY) * GRAVITY
}
