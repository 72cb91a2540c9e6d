//! Sheets, tubes and dice that the laws of the reference method share.

#![allow(dead_code, reason = "every test file uses another part")]

use glam::DVec3;
use lole_cloth::collision::penalty::Penalty;
use lole_cloth::method::explicit::{ContactEvaluation, ExplicitConfig, Integrator, Substeps};
use lole_cloth::method::reference::{ReferenceModel, ReferenceState, SpringConstants};
use lole_cloth::{ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::trig64;
use std::num::NonZeroU32;

/// A fabric without stiffness or drag, 0.15 kg/m²; the laws set what they need.
pub(crate) const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.0003,
    stretch: [0.0; 2],
    shear: 0.0,
    bend: [0.0; 2],
    twist: 0.0,
    hysteresis: lole_cloth::Hysteresis::NONE,
    friction: 0.0,
    cloth_friction: 0.0,
    drag_rate: 0.0,
};

/// A cloth without pins, every particle equally heavy.
pub(crate) fn spec(columns: u32, rows: u32, topology: Topology, spacing: [f32; 2]) -> ClothSpec {
    let grid = Grid {
        column_count: columns,
        row_count: rows,
        topology,
        spacing,
        flounce: None,
        crimp: None,
    };
    ClothSpec {
        grid,
        fabric: FABRIC,
        row_layers: vec![1.0; rows as usize],
        mass: MassLaw::Uniform,
        pinned: vec![false; grid.particle_count()],
    }
}

/// Equal structural and shear springs of `stiffness` [N/m].
pub(crate) fn lattice(stiffness: f64) -> SpringConstants {
    SpringConstants {
        structural_u: stiffness,
        structural_v: stiffness,
        shear: stiffness,
        ..SpringConstants::default()
    }
}

/// A model that must build.
pub(crate) fn model(spec: &ClothSpec, constants: SpringConstants) -> ReferenceModel {
    ReferenceModel::with_constants(spec, constants).expect("a sound specification")
}

/// Flat sheet in the plane `z = 0`, rows downwards; a tube as the regular polygon whose sides are
/// the spacing, its axis along `-y`.
pub(crate) fn rest_positions(grid: &Grid) -> Vec<DVec3> {
    let [h_u, h_v] = grid.spacing.map(f64::from);
    let mut positions = Vec::new();
    for row in 0..grid.row_count {
        for column in 0..grid.column_count {
            let (u, y) = (f64::from(column), -h_v * f64::from(row));
            positions.push(match grid.topology {
                Topology::Sheet => DVec3::new(h_u * u, y, 0.0),
                Topology::Tube => {
                    let turn = std::f64::consts::TAU / f64::from(grid.column_count);
                    let radius = 0.5 * h_u / trig64::sin(0.5 * turn);
                    let (sin, cos) = trig64::sin_cos(turn * u);
                    DVec3::new(radius * cos, y, radius * sin)
                }
            });
        }
    }
    positions
}

/// No gravity, no wind, no contact, `count` substeps.
pub(crate) fn still(count: u32) -> ExplicitConfig {
    ExplicitConfig {
        gravity: DVec3::ZERO,
        wind: None,
        penalty: Penalty::new(0.0, 0.0),
        substeps: Substeps::Fixed(NonZeroU32::new(count).expect("at least one")),
        integrator: Integrator::FbEuler,
        contact_evaluation: ContactEvaluation::PerStage,
    }
}

/// Targets that leave every pin where it is.
pub(crate) fn held_pins(model: &ReferenceModel, state: &ReferenceState) -> Vec<DVec3> {
    model
        .pin_indices()
        .iter()
        .map(|&index| state.positions[index as usize])
        .collect()
}

/// The 64-bit generator of Knuth's MMIX.
pub(crate) struct Lcg(pub(crate) u64);

impl Lcg {
    /// A number in `-1..1`.
    pub(crate) fn signed(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let bits = u32::try_from(self.0 >> 33).expect("31 bits");
        f64::from(bits) / f64::from(1u32 << 30) - 1.0
    }

    /// A vector with components in `-1..1`.
    pub(crate) fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }
}

/// A square net of `size × size` particles, top row pinned, all springs with 10 N/m, the paper's
/// bend springs included, and `drag_rate` [1/s].
pub(crate) fn pinned_net(size: u32, drag_rate: f32) -> ReferenceModel {
    let mut spec = spec(size, size, Topology::Sheet, [0.02; 2]);
    spec.pinned[..size as usize].fill(true);
    spec.fabric.drag_rate = drag_rate;
    let constants = SpringConstants {
        skip_u: 10.0,
        skip_v: 10.0,
        ..lattice(10.0)
    };
    model(&spec, constants)
}
