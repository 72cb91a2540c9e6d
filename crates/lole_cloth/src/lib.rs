//! The cloth engine: particles joined by springs that move under gravity, drag, wind and contact.
//!
//! It knows no garment and no dancer, and has no file, clock, log or picture in it.
//!
//! A handkerchief, held by two corners, falls for a second:
//!
//! ```
//! use lole_cloth::{ClothModel, ClothState, SolverConfig, StepInput, diagnose, step};
//!
//! let setup = (lole_cloth::scenes::SCENES[0].build)();
//! let model = ClothModel::new(&setup.spec)?;
//! let mut state = ClothState::new(&model, &setup.positions);
//! let pins: Vec<_> = model.pin_indices().iter().map(|&pin| setup.positions[pin as usize]).collect();
//! let input = StepInput { pin_targets: &pins, ..StepInput::default() };
//! for _ in 0..60 {
//!     step(&model, &SolverConfig::default(), &input, &mut state, 1.0 / 60.0);
//! }
//! let mut positions = Vec::new();
//! state.copy_positions(&model, &mut positions);
//! assert!(diagnose::strain(&setup.spec, &positions).max < 0.05);
//! # Ok::<(), lole_cloth::BuildError>(())
//! ```
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

pub mod assembly;
pub mod collision;
pub mod config;
mod constraint;
pub mod diagnose;
pub mod fabric;
pub mod grid;
mod lanes;
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
pub use grid::{Flounce, Grid, Topology};
pub use model::{BuildError, ClothModel};
pub use phase::Phase;
pub use snapshot::{mesh_state_hash, reference_state_hash, state_hash};
pub use spec::{ClothSpec, MassLaw};
pub use state::ClothState;
pub use step::{SKIN_REACH, StepInput, step, step_observed};
