//! A round specimen on a disc, after Cusick: what shows how a fabric drapes.
//!
//! Standards lay a circle of cloth on a smaller disc and measure the shadow of what hangs over. Here a mesh
//! of triangles is clamped on the disc, let down through thick air, and looked at from above.

use std::f32::consts::{PI, TAU};
use std::num::NonZeroU32;

use glam::{Vec2, Vec3};
use lole_geom::trig;

use crate::mesh::{self, MeshError, MeshModel, MeshSpec, MeshState};
use crate::{Fabric, SolverConfig, StepInput};

/// Radii of the disc and of the specimen [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundDrape {
    /// What holds the specimen level.
    pub disc: f32,
    /// The circle of cloth.
    pub specimen: f32,
}

/// How a specimen hangs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hung {
    /// Shadow less disc over specimen less disc.
    pub coefficient: f32,
    /// Folds of the hem, which textile laboratories call nodes.
    pub folds: u32,
}

/// Frames until a specimen hangs still, and the drag [1/s] of air so thick that it sinks and does
/// not swing: friction keeps what it comes from.
const FRAMES: u32 = 300;
const DRAG: f32 = 40.0;
/// Height of the first unevenness [m].
const SEED: f32 = 2.0e-4;
/// Rings of a specimen: the edges of the standards' discs lie on one. So fine a cloth bends as its fabric with
/// as many substeps only ([`RoundDrape::settings`]).
const RINGS: u32 = 30;
/// By which rings are turned against each other.
const GOLDEN: f32 = 0.618_034;

impl RoundDrape {
    /// BS 5058 and ISO 9073-9: 18 and 30 cm across.
    pub const BS: Self = Self {
        disc: 0.09,
        specimen: 0.15,
    };
    /// JIS L 1096: 12.7 and 25.4 cm across.
    pub const JIS: Self = Self {
        disc: 0.0635,
        specimen: 0.127,
    };

    /// Lays a specimen of this fabric on the disc and lets it hang: by meshes of triangles, which are elastic.
    ///
    /// # Errors
    ///
    /// If the fabric is none.
    pub fn hang(self, fabric: Fabric) -> Result<Hung, MeshError> {
        let fabric = Fabric {
            drag_rate: DRAG,
            ..fabric
        };
        let (flat, triangles) = disc(self.specimen, RINGS);
        let places: Vec<Vec3> = flat.iter().map(|&point| self.start(point)).collect();
        let mut spec = MeshSpec::new(flat, triangles, fabric);
        for (pinned, point) in spec.pinned.iter_mut().zip(&spec.flat_positions) {
            *pinned = point.length() <= 1.001 * self.disc;
        }
        let model = MeshModel::new(&spec)?;
        let pins: Vec<Vec3> = (model.pin_indices().iter())
            .map(|&pin| places[pin as usize])
            .collect();
        let mut state = MeshState::new(&model, &places);
        let input = StepInput {
            pin_targets: &pins,
            ..StepInput::default()
        };
        for _ in 0..FRAMES {
            // What is not finite shows in the figures.
            if mesh::step(&model, &Self::settings(), &input, &mut state, 1.0 / 60.0).is_err() {
                break;
            }
        }
        let mut positions = Vec::new();
        state.copy_positions(&model, &mut positions);
        let hem = (6 * RINGS) as usize;
        Ok(self.hung(&positions[positions.len() - hem..]))
    }

    /// Settings of the real-time method for specimens at rest: with a quarter of the substeps cells of half a
    /// centimeter bend too easily, and the coefficient of a stiff cloth is 11 points too low.
    #[must_use]
    pub fn settings() -> SolverConfig {
        SolverConfig {
            substep_count: NonZeroU32::MIN.saturating_add(95),
            structural_sweep_count: NonZeroU32::MIN.saturating_add(1),
            row_strides: Vec::new(),
            column_strides: Vec::new(),
            tether_scale: None,
            ..SolverConfig::default()
        }
    }

    /// Where a place of the flat specimen begins [m]: uneven outside the disc as no symmetry of it is.
    #[must_use]
    pub fn start(self, flat: Vec2) -> Vec3 {
        let beyond = (flat.length() - self.disc).max(0.0) / self.disc;
        let uneven = trig::sin(47.0 * flat.x + 31.0 * flat.y) + trig::sin(23.0 * flat.y + 1.0);
        Vec3::new(flat.x, SEED * beyond * uneven, flat.y)
    }

    /// What the hem tells, once around, `y` being upward.
    #[must_use]
    pub fn hung(self, hem: &[Vec3]) -> Hung {
        // Twice the area of the shadow's outline.
        let doubled: f32 = (hem.iter().zip(hem.iter().cycle().skip(1)))
            .map(|(here, next)| here.x * next.z - here.z * next.x)
            .sum();
        let square = self.disc * self.disc;
        let whole = self.specimen * self.specimen - square;
        let shadow = 0.5 * doubled.abs() / PI - square;
        Hung {
            coefficient: shadow / whole,
            folds: fold_count(hem.iter().map(|place| f64::from(place.y))),
        }
    }
}

/// Folds of a hem by its heights [m], once around: how often it rises above its mean height and falls below, a
/// tenth of its range apart.
#[must_use]
pub fn fold_count(heights: impl Iterator<Item = f64>) -> u32 {
    let heights: Vec<f64> = heights.collect();
    let mean = heights.iter().sum::<f64>() / heights.len() as f64;
    let [low, high] = heights.iter().fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[low, high], &height| [low.min(height), high.max(height)],
    );
    let margin = 0.05 * (high - low);
    let (mut is_up, mut folds) = (None, 0);
    // Twice round, so that the first place does not matter.
    for (index, &height) in heights.iter().chain(&heights).enumerate() {
        let now = if mean + margin < height {
            true
        } else if height < mean - margin {
            false
        } else {
            continue;
        };
        if heights.len() <= index && is_up == Some(false) && now {
            folds += 1;
        }
        is_up = Some(now);
    }
    folds
}

/// Rings of `6 k` points, turned against each other so that no direction is another's, and the triangles
/// between them.
fn disc(radius: f32, rings: u32) -> (Vec<Vec2>, Vec<[u32; 3]>) {
    let mut points = vec![Vec2::ZERO];
    let mut triangles = Vec::new();
    // First point, count and turn of a ring, in shares of a turn.
    let ring_of = |ring: u32| match ring {
        0 => (0, 1, 0.0),
        _ => (1 + 3 * ring * (ring - 1), 6 * ring, GOLDEN * ring as f32),
    };
    for ring in 1..=rings {
        let (first, count, turn) = ring_of(ring);
        let (inner_first, inner_count, inner_turn) = ring_of(ring - 1);
        let reach = radius * ring as f32 / rings as f32;
        points.extend((0..count).map(|index| {
            let angle = TAU * (turn + index as f32 / count as f32);
            Vec2::new(trig::cos(angle), trig::sin(angle)) * reach
        }));
        // The inner ring's points counted from the outer ring's first.
        let ahead = (turn - inner_turn) * inner_count as f32;
        let start = ahead.floor() + 1.0;
        let inner_at = |index: u32| (start - ahead + index as f32) / inner_count as f32;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "rings are turned forward by less than the points of a ring"
        )]
        let inner_start = start as u32;
        let inner = |index: u32| inner_first + (inner_start + index) % inner_count;
        let outer = |index: u32| first + index % count;
        let (mut outside, mut inside) = (0, 0);
        // Whichever has its next point first goes on.
        while outside < count || ring > 1 && inside < inner_count {
            let goes_out = ring == 1
                || inside == inner_count
                || outside < count && (outside + 1) as f32 / (count as f32) <= inner_at(inside);
            let last = inner(inside + inner_count - 1);
            if goes_out {
                triangles.push([last, outer(outside), outer(outside + 1)]);
                outside += 1;
            } else {
                triangles.push([last, outer(outside), inner(inside)]);
                inside += 1;
            }
        }
    }
    (points, triangles)
}
