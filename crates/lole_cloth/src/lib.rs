//! The cloth engine: particles joined by springs that move under gravity, drag, wind and contact.
//!
//! It knows no garment and no dancer, and has no file, clock, log or picture in it.
//!
//! Whatever it is made of, cloth is moved in the same five steps: describe it, prepare a model, begin a state,
//! step, read the positions. A model never changes, a state is all that moves, a world is lent to each step, and a
//! step that cannot be taken says why ([`Lost`]) and changes nothing.
//!
//! A handkerchief as a grid, held by two corners, falls for a second onto nothing:
//!
//! ```
//! use glam::Vec3;
//! use lole_cloth::{ClothModel, ClothSpec, ClothState, Fabric, Grid, SolverConfig, StepInput, step};
//!
//! let grid = Grid::sheet(32, 32, [0.012, 0.012]);
//! let spec = ClothSpec::new(grid, Fabric::COTTON).pinned_where(|row, column| row == 0 && column % 31 == 0);
//! let place = |i: usize| Vec3::new((i % 32) as f32, 0.0, (i / 32) as f32) * 0.012;
//! let start: Vec<Vec3> = (0..grid.particle_count()).map(place).collect();
//! let model = ClothModel::new(&spec)?;
//! let mut state = ClothState::new(&model, &start);
//! for _ in 0..60 {
//!     step(&model, &SolverConfig::default(), &StepInput::default(), &mut state, 1.0 / 60.0)?;
//! }
//! let now = state.positions(&model);
//! assert_eq!(now[0], start[0], "a corner that is held");
//! assert!(now[grid.index(31, 16)].y < -0.2, "the hem has fallen");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Any triangles, here a square of four, over a sphere that is a capsule of no length:
//!
//! ```
//! use glam::{Vec2, Vec3};
//! use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
//! use lole_cloth::{Fabric, SolverConfig, StepInput};
//! use lole_geom::Capsule;
//!
//! let flat = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1], [0.05, 0.05]].map(Vec2::from);
//! let triangles = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
//! let model = MeshModel::new(&MeshSpec::new(flat.to_vec(), triangles, Fabric::COTTON))?;
//! let start: Vec<Vec3> = flat.map(|at| Vec3::new(at.x - 0.05, 0.11, at.y - 0.05)).to_vec();
//! let mut state = MeshState::new(&model, &start);
//! let ball = [Capsule::uniform(Vec3::ZERO, Vec3::ZERO, 0.1)];
//! let world = StepInput { capsules: &ball, ..StepInput::default() };
//! for _ in 0..60 {
//!     mesh::step(&model, &SolverConfig::default(), &world, &mut state, 1.0 / 60.0)?;
//! }
//! assert!(state.positions(&model).iter().all(|place| 0.099 < place.length()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Both can be pieces of an [`assembly`], which sews them; raffia and lei are [`strands`]. The examples go on from
//! here: `hang`, `skirt`, `flag`, `from_obj`, `two_pieces`, `character`.
//!
//! # Which method when
//!
//! | Method | For | Numbers | Cost | What it does not do |
//! |---|---|---|---|---|
//! | [`step()`], `xpbd` | dancing, windows, films | `f32`, the same bits on any thread count and instruction set | about 6 ns a particle and substep, 4 to 12 substeps a frame | stretch converges with substeps, not with passes; bends too deep beyond four cells a bending length with 12 substeps, beyond eight with 40 |
//! | [`method::explicit_rows::step`] | truth in time to look at: the fabric's own modulus, contact with the body | `f32`, the same bits on any thread count and instruction set | about 3 ns a particle and substep, 150 to 700 substeps a frame | the cloth does not meet itself; what is stretched rings on, because only drag damps it: no internal friction |
//! | [`method::settle`] | static drape: how a cloth hangs at rest | those of [`step()`] | 100 to 200 frames of [`step()`] from a draft to rest | the stiffness is that of the substeps; friction and folds leave more than one rest |
//! | [`mesh::step()`] | pieces of any triangles, which meet the skin and themselves as grids do; [`assembly`] sews them to grids and lets pieces meet | the same | 18 to 25 ns a particle and substep with one sweep: 1.9 to 2.9 times the grid with its default of six sweeps and nearly its strain, 3.4 to 4.0 times the grid with one | stay near pins inside the body (`held_depth`); take back crossings of one piece with another; internal friction |
//! | [`method::explicit::step`] with `fb-euler` | truth: static shapes, periods, energy | `f64` | substeps grow with the root of stiffness over mass and with the fineness of the grid: hundreds a frame | contact as a penalty, so cloth sinks in by weight over stiffness; internal friction |
//! | the same with `euler`, `rk4`, `rk-as-printed`, `rk-double-counted` | the paper's experiment | `f64` | 1, 4, 4 and 4 forces a step | `euler` and the printed method are stable only with damping |

//!
//! # What a setting costs
//!
//! The skirt of 8,192 particles whose folds do not pass through each other, 5 s over a body that sways, each setting
//! of [`SolverConfig`] turned alone; one core with AVX-512, CPU of a step on the mean (3.5 ms as the scene has it).
//! The example `knobs` measures it anew.
//!
//! | Setting | Cost | Strain p99, worst | Crossings at the end |
//! |---|---|---|---|
//! | as the scene has it: 10 substeps, 5 sweeps | 1 | 8.5 % | 0 |
//! | `substep_count` halved | 0.75 | 7.3 % | 0 |
//! | `substep_count` doubled | 1.31 | 2.4 % | 0 |
//! | `strained_substep_count` of 30 | 1.08 | 7.6 % | 0 |
//! | `structural_sweep_count` of 2 | 0.91 | 4.6 % | 0 |
//! | `structural_sweep_count` doubled | 1.17 | 6.0 % | 0 |
//! | `gathered_sweep_count` of 2 | 1.02 | 3.5 % | 0 |
//! | `tether_scale` of `None` | 0.94 | 8.9 % | 0 |
//! | `column_strides` left out | 1.02 | 7.9 % | 0 |
//! | `row_strides` of 4 | 0.98 | 8.4 % | 0 |
//! | [`Crossings::Leave`] | 0.71 | 2.9 % | 44 |
//! | `substep_interval` of 1 | 0.96 | 8.8 % | 0 |
//! | `self_collision` of `None` | 0.27 | 3.1 % | 2,497 |
//! | [`InstructionSet::Wide`], AVX2 | 1.32 | the same bits | the same bits |
//! | [`InstructionSet::Baseline`], SSE2 | 1.53 | the same bits | the same bits |
//!
//! What takes back crossings is a third of a step, and the strain of the worst moment is what it leaves there.

pub mod assembly;
pub mod awake;
pub mod collision;
pub mod config;
mod constraint;
pub mod diagnose;
pub mod drape_test;
pub mod fabric;
pub mod grid;
mod lanes;
pub mod lost;
pub mod mesh;
pub mod method;
pub mod model;
pub mod phase;
mod pins;
pub mod roofline;
pub mod scenes;
pub mod snapshot;
pub mod spec;
pub mod state;
pub mod step;
pub mod strands;
pub mod wind;

pub use config::{Crossings, InstructionSet, SelfCollision, SolverConfig};
pub use fabric::{Fabric, Hysteresis};
pub use grid::{Crimp, Flounce, Grid, Topology};
pub use lost::{Lost, SubstepPart};
pub use model::{BuildError, ClothModel};
pub use phase::Phase;
pub use snapshot::{mesh_state_hash, reference_state_hash, state_hash};
pub use spec::{ClothSpec, MassLaw};
pub use state::ClothState;
pub use step::{GridStep, SKIN_REACH, StepInput, StepOf, step, step_observed};
