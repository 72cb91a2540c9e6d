//! What holds the cloth together in a substep, row by row: rows whose columns are crimped, or wider in a
//! flounce, are held otherwise.

use crate::constraint::bend::Bend;
use crate::constraint::hysteresis::Friction;
use crate::constraint::pull::Pull;
use crate::constraint::shear::Cell;
use crate::constraint::structural::Spring;
use crate::method::reference::SpringConstants;
use crate::{ClothModel, Hysteresis, SolverConfig};

/// By row, what holds it and the cells between it and the next together, down to the row from which on all
/// are alike.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct WovenRows(Vec<[Woven; 2]>);

impl WovenRows {
    /// Those of a substep of `h` [s].
    pub(super) fn set(&mut self, model: &ClothModel, config: &SolverConfig, h: f32) {
        #[expect(clippy::cast_precision_loss, reason = "sweeps are few")]
        let sweeps = config.structural_sweep_count.get() as f32;
        let grid = &model.spec().grid;
        self.0.clear();
        self.0.extend((0..=grid.last_uneven_row()).map(|row| {
            let [upper, lower] = [row, row + 1].map(|row| grid.row_spacing(row));
            // Cells that are gathered into a seam, or open below puckers, are as wide as their middle.
            [upper, 0.5 * (upper + lower)]
                .map(|u| Woven::new(model, [u, grid.spacing[1]], (h, sweeps)))
        }));
    }

    /// What holds a row together.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> &Woven {
        &self.0[row.min(self.0.len() - 1)][0]
    }

    /// What holds the cells between a row and the next together.
    #[inline(always)]
    pub(super) fn cells(&self, row: usize) -> &Woven {
        &self.0[row.min(self.0.len() - 1)][1]
    }

    /// Whether any of it has internal friction.
    pub(super) fn has_friction(&self) -> bool {
        self.0.iter().flatten().any(|woven| woven.friction.acts())
    }
}

/// What holds cloth together whose columns are so wide.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Woven {
    /// Rest distance between its columns [m].
    pub(super) spacing: f32,
    pub(super) across: Spring,
    pub(super) down: Spring,
    pub(super) cell: Cell,
    pub(super) bend_across: f32,
    pub(super) bend_down: f32,
    pub(super) friction: Frictions,
}

/// Internal friction of the cloth, by what it resists; see [`crate::constraint::hysteresis`].
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Frictions {
    /// Along rows and down columns.
    pub(super) bend: [Option<Friction>; 2],
    pub(super) shear: Option<Friction>,
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
            spacing: u,
            across: spring(u, structural_u),
            down: spring(v, structural_v),
            friction: Frictions::new(model, [u, v], [bend_across, bend_down], &cell),
            cell,
            bend_across,
            bend_down,
        }
    }
}
