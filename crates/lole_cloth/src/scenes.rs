//! Scenes as data: the table that benches, tests and the command line walk alike.

use std::f64::consts::{PI, TAU};
use std::num::NonZeroU32;

use glam::Vec3;
use lole_geom::{Capsule, narrow, trig64};

use crate::{ClothSpec, Fabric, Grid, MassLaw, SelfCollision, SolverConfig, Topology};

/// Duration of a frame of every scene [s].
pub const FRAME_DT: f32 = 1.0 / 60.0;

/// One cloth in one world.
pub struct ClothScene {
    /// Short name, as it is typed.
    pub name: &'static str,
    /// What a viewer should see.
    pub about: &'static str,
    /// Frames of [`FRAME_DT`].
    pub frame_count: u32,
    /// Cloth, settings and start.
    pub build: fn() -> Setup,
    /// Capsules at a time [s].
    pub capsules: fn(f64) -> Vec<Capsule>,
}

/// How a scene starts.
#[derive(Debug, Clone)]
pub struct Setup {
    /// What cloth it is.
    pub spec: ClothSpec,
    /// Settings measured as good for it.
    pub config: SolverConfig,
    /// Start positions [m], row-major, at rest. Pinned particles stay there.
    pub positions: Vec<Vec3>,
}

/// Every scene.
pub const SCENES: &[ClothScene] = &[
    ClothScene {
        name: "hang-64",
        about: "A square of 1.2 m, level at first, swings down from two corners.",
        frame_count: 300,
        build: || hang(64, 4, &[4]),
        capsules: |_| Vec::new(),
    },
    ClothScene {
        name: "hang-128",
        about: "The same square with four times the particles.",
        frame_count: 300,
        build: || hang(128, 5, &[16, 4]),
        capsules: |_| Vec::new(),
    },
    ClothScene {
        name: "hang-256",
        about: "The same square with sixteen times the particles.",
        frame_count: 300,
        build: || hang(256, 6, &[16, 4]),
        capsules: |_| Vec::new(),
    },
    ClothScene {
        name: "skirt",
        about: "A gathered skirt of 8,192 particles over 13 capsules that sway sideways.",
        frame_count: 300,
        build: skirt,
        capsules: swaying_capsules,
    },
    ClothScene {
        name: "skirt-self",
        about: "The same skirt, whose folds do not pass through each other.",
        frame_count: 300,
        build: || {
            let mut setup = skirt();
            // Where folds keep apart once a frame, more sweeps strain them more: of the settings that
            // `--pareto` tries none is both faster and less strained than these.
            setup.config.substep_count = NonZeroU32::MIN.saturating_add(7);
            setup.config.structural_sweep_count = NonZeroU32::MIN.saturating_add(1);
            setup.config.self_collision = Some(SelfCollision {
                radius: 0.006,
                substep_interval: NonZeroU32::MIN.saturating_add(1),
                crossings: crate::Crossings::Repair,
            });
            setup
        },
        capsules: swaying_capsules,
    },
    ClothScene {
        name: "gathered",
        about: "512 columns gathered four to one by three casings, over a body that sways.",
        frame_count: 180,
        build: gathered,
        capsules: swaying_hips,
    },
];

/// The hanging square at four sizes, from 4,096 to 262,144 particles, with the same settings: what
/// the size of a cloth alone costs.
pub const SIZES: &[ClothScene] = &[
    size("size-64", || hang(64, 6, &[16, 4])),
    size("size-128", || hang(128, 6, &[16, 4])),
    size("size-256", || hang(256, 6, &[16, 4])),
    size("size-512", || hang(512, 6, &[16, 4])),
];

const fn size(name: &'static str, build: fn() -> Setup) -> ClothScene {
    ClothScene {
        name,
        about: "A square of 1.2 m, level at first, swings down from two corners.",
        frame_count: 60,
        build,
        capsules: |_| Vec::new(),
    }
}

/// A cotton for dresses; drag of still air.
const FABRIC: Fabric = Fabric {
    areal_density: 0.15,
    thickness: 0.4e-3,
    stretch: [4500.0, 2800.0],
    shear: 90.0,
    bend: [9.0e-6, 6.0e-6],
    twist: 4.0e-6,
    hysteresis: crate::Hysteresis::NONE,
    friction: 0.3,
    cloth_friction: 0.3,
    drag_rate: 1.0,
};

fn hang(side: u32, substep_count: u32, strides: &[u32]) -> Setup {
    let spacing = narrow(1.2 / f64::from(side - 1));
    let grid = Grid {
        column_count: side,
        row_count: side,
        topology: Topology::Sheet,
        spacing: [spacing; 2],
        flounce: None,
        crimp: None,
    };
    let mut pinned = vec![false; grid.particle_count()];
    pinned[grid.index(0, 0)] = true;
    pinned[grid.index(0, side - 1)] = true;
    let rows = (0..side).flat_map(|row| (0..side).map(move |column| (row, column)));
    let at = |index: u32| narrow(f64::from(index) * 1.2 / f64::from(side - 1));
    Setup {
        positions: rows
            .map(|(row, column)| Vec3::new(at(column) - 0.6, 0.0, at(row)))
            .collect(),
        spec: ClothSpec {
            grid,
            fabric: FABRIC,
            row_layers: vec![1.0; side as usize],
            mass: MassLaw::Uniform,
            pinned,
        },
        config: SolverConfig {
            substep_count: NonZeroU32::MIN.saturating_add(substep_count - 1),
            structural_sweep_count: NonZeroU32::MIN,
            row_strides: strides.to_vec(),
            column_strides: strides.to_vec(),
            ..SolverConfig::default()
        },
    }
}

/// Girth of the cloth, of the ring it is gathered onto, and length of the skirt [m].
const SKIRT_GIRTH: f64 = 2.0;
const RING_GIRTH: f64 = 0.72;
const SKIRT_LENGTH: f64 = 0.75;
/// Waves around the ring.
const WAVE_COUNT: f64 = 16.0;

fn skirt() -> Setup {
    let (column_count, row_count) = (128, 64);
    let spacing = [
        SKIRT_GIRTH / f64::from(column_count),
        SKIRT_LENGTH / f64::from(row_count - 1),
    ];
    let grid = Grid {
        column_count,
        row_count,
        topology: Topology::Tube,
        spacing: spacing.map(narrow),
        flounce: None,
        crimp: None,
    };
    let mut positions = Vec::with_capacity(grid.particle_count());
    let (mut height, mut radius_above) = (0.0, 0.0);
    for row in 0..row_count {
        let radius = skirt_radius(f64::from(row) * spacing[1]);
        if 0 < row {
            let outward = radius - radius_above;
            height -= (spacing[1] * spacing[1] - outward * outward)
                .max(1.0e-8)
                .sqrt();
        }
        radius_above = radius;
        let ring = waved_ring(radius, SKIRT_GIRTH, column_count, WAVE_COUNT);
        positions.extend(
            ring.into_iter()
                .map(|[x, z]| Vec3::new(narrow(x), narrow(height), narrow(z))),
        );
    }
    let pinned = (0..grid.particle_count()).map(|particle| particle < column_count as usize);
    Setup {
        spec: ClothSpec {
            grid,
            fabric: Fabric {
                areal_density: 0.18,
                ..FABRIC
            },
            row_layers: vec![1.0; row_count as usize],
            mass: MassLaw::Uniform,
            pinned: pinned.collect(),
        },
        config: SolverConfig {
            substep_count: NonZeroU32::MIN.saturating_add(8),
            structural_sweep_count: NonZeroU32::MIN.saturating_add(3),
            column_strides: vec![16, 8, 4],
            ..SolverConfig::default()
        },
        positions,
    }
}

/// Where the gathered skirt's casings lie: the rows, and the girth they are drawn in to [m].
const CASING_ROWS: [u32; 3] = [2, 5, 8];
const CASING_GIRTH: f64 = 0.86;
/// Folds around the casings, about 2 cm each.
const FOLD_COUNT: f64 = 44.0;

/// A skirt such as the dancer wears: folds of 2 cm at three casings, free above and below.
fn gathered() -> Setup {
    let (column_count, row_count) = (512, 50);
    let spacing = [0.007, 0.015];
    let grid = Grid {
        column_count,
        row_count,
        topology: Topology::Tube,
        spacing: spacing.map(narrow),
        flounce: None,
        crimp: None,
    };
    let girth = f64::from(column_count) * spacing[0];
    let ring = waved_ring(CASING_GIRTH / TAU, girth, column_count, FOLD_COUNT);
    let positions = (0..row_count).flat_map(|row| {
        let height = 0.05 - f64::from(row) * spacing[1];
        ring.iter()
            .map(move |&[x, z]| Vec3::new(narrow(x), narrow(height), narrow(z)))
    });
    let rows = (0..row_count).flat_map(|row| (0..column_count).map(move |_| row));
    Setup {
        positions: positions.collect(),
        spec: ClothSpec {
            grid,
            fabric: Fabric {
                areal_density: 0.11,
                friction: 0.45,
                cloth_friction: 0.45,
                ..FABRIC
            },
            row_layers: vec![1.0; row_count as usize],
            mass: MassLaw::AreaWeighted,
            pinned: rows.map(|row| CASING_ROWS.contains(&row)).collect(),
        },
        config: SolverConfig {
            self_collision: Some(SelfCollision {
                radius: 0.003,
                substep_interval: NonZeroU32::MIN.saturating_add(1),
                crossings: crate::Crossings::Repair,
            }),
            ..SolverConfig::default()
        },
    }
}

/// Hips and legs of [`swaying_capsules`] with a sway that stays inside the casings.
#[must_use]
pub fn swaying_hips(time: f64) -> Vec<Capsule> {
    let sway = 0.5 * (swaying_capsules(time)[0].ends[0].x - swaying_capsules(0.0)[0].ends[0].x);
    let shift = Vec3::X * sway;
    swaying_capsules(0.0)
        .into_iter()
        .skip(3)
        .map(|capsule| Capsule {
            ends: capsule.ends.map(|end| end + shift),
            ..capsule
        })
        .collect()
}

/// Radius [m] of the skirt `slant` [m] below its ring: it opens over the hips, then flares.
fn skirt_radius(slant: f64) -> f64 {
    let ring = RING_GIRTH / TAU;
    if slant < 0.14 {
        ring + (0.205 - ring) * trig64::sin(0.5 * PI * slant / 0.14)
    } else {
        0.205 + (0.245 - 0.205) * (slant - 0.14) / 0.61
    }
}

/// Points `[x, z]` at equal arc length on `r(θ) = radius + a cos(wave_count θ)`, with the
/// amplitude `a` that makes the curve `girth` long.
#[must_use]
pub fn waved_ring(radius: f64, girth: f64, point_count: u32, wave_count: f64) -> Vec<[f64; 2]> {
    const CURVE_POINTS: u32 = 8192;
    let point = |amplitude: f64, turn: f64| {
        let (sin, cos) = trig64::sin_cos(TAU * turn);
        let r = radius + amplitude * trig64::cos(wave_count * TAU * turn);
        [r * cos, r * sin]
    };
    let lengths = |amplitude: f64| {
        let mut sum = 0.0;
        let mut last = point(amplitude, 0.0);
        let mut lengths = vec![0.0];
        for index in 1..=CURVE_POINTS {
            let next = point(amplitude, f64::from(index) / f64::from(CURVE_POINTS));
            let (dx, dz) = (next[0] - last[0], next[1] - last[1]);
            sum += (dx * dx + dz * dz).sqrt();
            lengths.push(sum);
            last = next;
        }
        lengths
    };
    let (mut low, mut high) = (0.0, radius);
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        let total = lengths(middle).last().copied().unwrap_or(0.0);
        if total < girth {
            low = middle;
        } else {
            high = middle;
        }
    }
    let amplitude = 0.5 * (low + high);
    let lengths = lengths(amplitude);
    let total = lengths.last().copied().unwrap_or(0.0);
    let mut segment = 0;
    let points = (0..point_count).map(|index| {
        let length = total * f64::from(index) / f64::from(point_count);
        while segment + 2 < lengths.len() && lengths[segment + 1] < length {
            segment += 1;
        }
        let fraction = (length - lengths[segment]) / (lengths[segment + 1] - lengths[segment]);
        #[expect(clippy::cast_precision_loss, reason = "the curve has 8192 points")]
        let turn = (segment as f64 + fraction) / f64::from(CURVE_POINTS);
        point(amplitude, turn)
    });
    points.collect()
}

/// Ends and radius [m] of the capsules in the middle, which take the whole sway.
const MIDDLE_CAPSULES: [([f64; 3], [f64; 3], f64); 3] = [
    ([-0.02, 0.03, 0.0], [0.02, 0.03, 0.0], 0.065),
    ([-0.05, -0.12, 0.0], [0.05, -0.12, 0.0], 0.09),
    ([-0.03, -0.09, 0.03], [0.03, -0.09, 0.03], 0.07),
];

/// A capsule of one side: ends, radius, and the share of the sway that each end takes.
type SideCapsule = ([f64; 3], [f64; 3], f64, [f64; 2]);

/// Capsules of the left side; the right mirrors them.
const SIDE_CAPSULES: [SideCapsule; 5] = [
    ([0.065, -0.15, 0.0], [0.075, -0.22, 0.0], 0.085, [1.0, 1.0]),
    ([0.05, -0.16, -0.05], [0.05, -0.21, -0.04], 0.08, [1.0, 1.0]),
    ([0.08, -0.22, 0.0], [0.09, -0.52, 0.01], 0.075, [1.0, 0.5]),
    ([0.09, -0.52, 0.01], [0.09, -0.57, 0.01], 0.06, [0.5, 0.5]),
    ([0.09, -0.57, 0.01], [0.09, -0.95, -0.01], 0.05, [0.5, 0.0]),
];

/// Abdomen, pelvis, belly, then hip, glute, thigh, knee and shank of both sides, swaying 8 cm
/// sideways once a second, eased in over the first.
#[must_use]
pub fn swaying_capsules(time: f64) -> Vec<Capsule> {
    let sway = 0.08 * trig64::sin(TAU * time) * time.min(1.0);
    let end =
        |[x, y, z]: [f64; 3], share: f64| Vec3::new(narrow(x + share * sway), narrow(y), narrow(z));
    let mut capsules: Vec<_> = MIDDLE_CAPSULES
        .iter()
        .map(|&(a, b, radius)| Capsule::uniform(end(a, 1.0), end(b, 1.0), narrow(radius)))
        .collect();
    for side in [-1.0, 1.0] {
        let mirror = |[x, y, z]: [f64; 3]| [side * x, y, z];
        capsules.extend(SIDE_CAPSULES.iter().map(|&(a, b, radius, share)| {
            Capsule::uniform(
                end(mirror(a), share[0]),
                end(mirror(b), share[1]),
                narrow(radius),
            )
        }));
    }
    capsules
}
