//! Sews the drafted pāʻū skirt to a dancer: flat rectangle → gathered tube of particles around the
//! hips, its elastic rows carried by the skin.

mod fold_curve;

use glam::{Affine3A, Vec2, Vec3};
use lole_body::{Dancer, TapePoint};
use lole_cloth::{ClothSpec, Fabric, Grid, MassLaw, Topology};
use lole_geom::trig;
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements};

use fold_curve::FoldCurve;

/// How the skirt is divided into particles and laid around the dancer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SewSettings {
    /// Particles around the skirt; at least 512 for gathers of about 2 cm.
    pub column_count: u32,
    /// Particles from top fold to hem.
    pub row_count: u32,
    /// Ring length of one gather at the band [m].
    pub gather_pitch: f32,
    /// Gap between the skin and the inner turn of the gathers [m]: a fold of cloth and elastic.
    pub band_gap: f32,
    /// How unevenly gathers are pushed together: 0 is a machine's pleating, 1 a loose hand's.
    pub unevenness: f32,
    /// Chance for the unevenness; same seed, same gathers.
    pub seed: u64,
}

impl Default for SewSettings {
    fn default() -> Self {
        Self {
            column_count: 512,
            row_count: 50,
            gather_pitch: 0.016,
            band_gap: 0.006,
            unevenness: 0.5,
            seed: 1,
        }
    }
}

/// Why a skirt could not be sewn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SewError {
    /// The flat cloth does not reach around the body.
    #[error(
        "the skirt's cloth is {flat_cm:.0} cm around but the band sits on {ring_cm:.0} cm; raise gather_ratio"
    )]
    TooNarrow {
        /// Length of the cloth around [cm].
        flat_cm: f64,
        /// Girth it must reach around [cm].
        ring_cm: f64,
    },
    /// The body has no section where an elastic row should lie.
    #[error(
        "the dancer has no trunk at {height_cm:.1} cm, where an elastic row lies; lower the number of elastic rows"
    )]
    NoSection {
        /// Height above the floor [cm].
        height_cm: f64,
    },
    /// Too few particles for the band.
    #[error(
        "{row_count} rows are too few for {elastic_row_count} elastic rows; use at least {least}"
    )]
    TooFewRows {
        /// Rows asked for.
        row_count: u32,
        /// Elastic rows of the draft.
        elastic_row_count: usize,
        /// Rows needed.
        least: u32,
    },
}

/// A particle carried by the skin: its place in the bind pose and the bones that move it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkinPin {
    /// Particle it holds.
    pub particle: u32,
    point: TapePoint,
}

impl SkinPin {
    /// Where it is in the world [m].
    #[must_use]
    pub fn posed(&self, world_from_bind: &[Affine3A]) -> Vec3 {
        self.point.posed(world_from_bind)
    }
}

/// A skirt on a dancer, ready to be simulated and drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SewnSkirt {
    /// What the engine needs to know.
    pub spec: ClothSpec,
    /// The pinned particles, in ascending order.
    pub pins: Vec<SkinPin>,
    /// Grid rows that carry elastic, from the top.
    pub elastic_rows: Vec<u32>,
    /// Every particle carried by the nearest skin: the start of the drape.
    start: Vec<TapePoint>,
}

impl SewnSkirt {
    /// Where the drape starts, in the pose `world_from_bind` [m], shape `[particle_count, 3]`.
    #[must_use]
    pub fn start_positions(&self, world_from_bind: &[Affine3A]) -> Vec<Vec3> {
        self.start
            .iter()
            .map(|point| point.posed(world_from_bind))
            .collect()
    }

    /// Where the pins are in the pose `world_from_bind` [m], in the order of [`Self::pins`].
    pub fn pose_pins(&self, world_from_bind: &[Affine3A], targets: &mut Vec<Vec3>) {
        targets.clear();
        targets.extend(self.pins.iter().map(|pin| pin.posed(world_from_bind)));
    }
}

/// Sews the drafted skirt onto the dancer.
///
/// # Errors
/// A draft that does not fit the body or the grid.
pub fn sew(
    draft: &PauDraft,
    worn: &PauMeasurements,
    fabric: &Fabric,
    dancer: &Dancer,
    settings: &SewSettings,
) -> Result<SewnSkirt, SewError> {
    let layout = Layout::new(draft, worn, settings)?;
    let lowest = *layout.elastic_rows.last().unwrap_or(&0);
    let worn_height = worn.worn_height.to_m_f32();
    let mut start = Vec::with_capacity(layout.grid.particle_count());
    let lowest_ring = Ring::at(dancer, worn_height, settings, &layout)?;
    for row in 0..layout.grid.row_count {
        let drop = (row as f32 - lowest as f32) * layout.grid.spacing[1];
        if row <= lowest {
            let ring = Ring::at(dancer, worn_height - drop, settings, &layout)?;
            ring.lay_row(0.0, 0.0, &layout, &mut start);
        } else {
            lowest_ring.lay_row(drop, opening(drop), &layout, &mut start);
        }
    }
    let mut pinned = vec![false; layout.grid.particle_count()];
    let mut pins = Vec::new();
    for &row in &layout.elastic_rows {
        for column in 0..layout.grid.column_count {
            let index = layout.grid.index(row, column);
            pinned[index] = true;
            let particle = row * layout.grid.column_count + column;
            pins.push(SkinPin {
                particle,
                point: start[index],
            });
        }
    }
    let spec = ClothSpec {
        grid: layout.grid,
        fabric: *fabric,
        row_layers: layout.row_layers,
        mass: MassLaw::AreaWeighted,
        pinned,
    };
    Ok(SewnSkirt {
        spec,
        pins,
        elastic_rows: layout.elastic_rows,
        start,
    })
}

/// How far the skirt is held open [m], `drop` [m] below the band, before it is let go: a cone of
/// about 15°, inside what the hips and the folds' own width ask for.
fn opening(drop: f32) -> f32 {
    0.26 * drop
}

/// The grid and what its rows and columns mean.
struct Layout {
    grid: Grid,
    elastic_rows: Vec<u32>,
    row_layers: Vec<f32>,
    /// Cloth around the skirt [m].
    flat_length: f32,
    /// Fold phase of every column, in folds.
    phases: Vec<f32>,
    fold_count: f32,
    band_gap: f32,
}

impl Layout {
    fn new(
        draft: &PauDraft,
        worn: &PauMeasurements,
        settings: &SewSettings,
    ) -> Result<Self, SewError> {
        let finished = draft.finished_length.to_m_f32();
        let flat_length = draft.flat_length.to_m_f32();
        let spacing_v = finished / (settings.row_count.max(2) - 1) as f32;
        let elastic_rows: Vec<u32> = draft
            .elastic_rows
            .iter()
            .map(|row| nearest_row(row.from_fold.to_m_f32(), spacing_v))
            .collect();
        let rising = elastic_rows.windows(2).all(|pair| pair[0] < pair[1]);
        let below = elastic_rows.last().map_or(0, |&row| row + 3);
        if !rising || settings.row_count <= below {
            return Err(SewError::TooFewRows {
                row_count: settings.row_count,
                elastic_row_count: elastic_rows.len(),
                least: 40,
            });
        }
        let grid = Grid {
            column_count: settings.column_count,
            row_count: settings.row_count,
            topology: Topology::Tube,
            spacing: [flat_length / settings.column_count as f32, spacing_v],
        };
        let fold_depth = draft.fold_depth.to_m_f32();
        let hem = draft.hem_depth.to_m_f32();
        let layers = |row: u32| {
            let from_top = row as f32 * spacing_v;
            if from_top < fold_depth || finished - hem < from_top {
                2.0
            } else {
                1.0
            }
        };
        let ring_length = worn.worn_girth.to_m_f32();
        let fold_count = (ring_length / settings.gather_pitch).round().max(8.0);
        Ok(Self {
            grid,
            elastic_rows,
            row_layers: (0..settings.row_count).map(layers).collect(),
            flat_length,
            phases: fold_phases(settings, fold_count),
            fold_count,
            band_gap: settings.band_gap,
        })
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a distance on the skirt over a row's height: below 1,000 rows"
)]
fn nearest_row(distance: f32, spacing: f32) -> u32 {
    (distance / spacing).round() as u32
}

/// The fold phase of each column: even, plus a slow random drift that closes around the ring.
fn fold_phases(settings: &SewSettings, fold_count: f32) -> Vec<f32> {
    const WAVES: [f32; 6] = [2.0, 3.0, 5.0, 7.0, 11.0, 17.0];
    let mut state = settings.seed ^ 0x9e37_79b9_7f4a_7c15;
    let shifts = WAVES.map(|_| unit_random(&mut state));
    let strengths = WAVES.map(|_| 0.5 + unit_random(&mut state));
    (0..settings.column_count)
        .map(|column| {
            let around = column as f32 / settings.column_count as f32;
            let drift: f32 = WAVES
                .iter()
                .zip(shifts)
                .zip(strengths)
                // Each wave changes the local pitch by the same share, whatever its length.
                .map(|((wave, shift), strength)| {
                    strength / wave * trig::sin(std::f32::consts::TAU * (wave * around + shift))
                })
                .sum();
            fold_count * (around + 0.025 * settings.unevenness * drift)
        })
        .collect()
}

/// A repeatable number in `0..1` (`SplitMix64`, Steele, Lea and Flood 2014).
fn unit_random(state: &mut u64) -> f32 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    (bits >> 40) as f32 / (1_u32 << 24) as f32
}

/// Points of a tape that one row of gathers is laid along.
const RING_POINTS: usize = 720;

/// A tape around the body that one row is laid along.
struct Ring {
    points: Vec<TapePoint>,
    girth: f32,
}

impl Ring {
    fn at(
        dancer: &Dancer,
        height: f32,
        settings: &SewSettings,
        layout: &Layout,
    ) -> Result<Self, SewError> {
        let points = dancer.tape_ring(height, RING_POINTS);
        if points.is_empty() {
            return Err(SewError::NoSection {
                height_cm: f64::from(height) * 100.0,
            });
        }
        let next = points.iter().cycle().skip(1);
        let girth = points
            .iter()
            .zip(next)
            .map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum();
        let around = girth + std::f32::consts::TAU * settings.band_gap;
        if layout.flat_length < around {
            return Err(SewError::TooNarrow {
                flat_cm: f64::from(layout.flat_length) * 100.0,
                ring_cm: f64::from(around) * 100.0,
            });
        }
        Ok(Self { points, girth })
    }

    /// Lays one row of particles, `drop` [m] below the ring and `out` [m] further from the body.
    fn lay_row(&self, drop: f32, out: f32, layout: &Layout, into: &mut Vec<TapePoint>) {
        let cloth_per_fold = layout.flat_length / layout.fold_count;
        // The middle line of the folds lies half their depth further out than their inner turns,
        // which shortens the folds, which moves the middle line: two rounds settle it.
        let mut depth = 0.0;
        let mut curve = FoldCurve::new(cloth_per_fold, cloth_per_fold);
        for _ in 0..3 {
            let ring = self.girth + std::f32::consts::TAU * (layout.band_gap + out + 0.5 * depth);
            curve = FoldCurve::new(cloth_per_fold, ring / layout.fold_count);
            depth = curve.depth();
        }
        let middle = self.girth + std::f32::consts::TAU * (layout.band_gap + out + 0.5 * depth);
        for (column, &phase) in layout.phases.iter().enumerate() {
            let (sideways, outward) = curve.at(phase);
            let even = column as f32 / layout.phases.len() as f32;
            let around = even + sideways / middle;
            let mut point = self.point(around);
            point.bind_position += point.outward * (layout.band_gap + out + outward);
            point.bind_position.y -= drop;
            into.push(point);
        }
    }

    /// The tape point a fraction `around` the ring, mixed from its two neighbors.
    fn point(&self, around: f32) -> TapePoint {
        let place = (around - around.floor()) * self.points.len() as f32;
        let whole = place.floor();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of points"
        )]
        let index = whole as usize % self.points.len();
        let (a, b) = (
            &self.points[index],
            &self.points[(index + 1) % self.points.len()],
        );
        let fraction = place - whole;
        // The nearer neighbor's bones carry it: weights vary slowly along a tape.
        let carrier = if fraction < 0.5 { a } else { b };
        TapePoint {
            bind_position: a.bind_position.lerp(b.bind_position, fraction),
            outward: a.outward.lerp(b.outward, fraction).normalize_or(a.outward),
            ..*carrier
        }
    }
}

/// The drawn skirt: the particles' grid with the seam column twice, so that the print may differ on
/// the two sides of the seam.
#[derive(Debug, Clone, PartialEq)]
pub struct SkirtMesh {
    /// Particle behind each vertex, shape `[vertex_count]`.
    pub particles: Vec<u32>,
    /// Texture coordinates in repeats of the print, `v` down, shape `[vertex_count, 2]`.
    pub uvs: Vec<Vec2>,
    /// Vertex indices, facing outward, shape `[triangle_count, 3]`.
    pub triangles: Vec<[u32; 3]>,
    /// The same triangles by particle, without the seam.
    pub particle_triangles: Vec<[u32; 3]>,
}

impl SkirtMesh {
    /// The mesh of a grid whose print repeats every `print_repeat` [m].
    #[must_use]
    pub fn new(grid: &Grid, print_repeat: f32) -> Self {
        let columns = grid.cell_columns() + 1;
        let (mut particles, mut uvs) = (Vec::new(), Vec::new());
        for row in 0..grid.row_count {
            for column in 0..columns {
                particles.push(row * grid.column_count + column % grid.column_count);
                let flat = Vec2::new(column as f32, row as f32) * Vec2::from(grid.spacing);
                uvs.push(flat / print_repeat);
            }
        }
        let mut triangles = Vec::new();
        for row in 0..grid.row_count - 1 {
            for column in 0..grid.cell_columns() {
                let a = row * columns + column;
                let (b, c, d) = (a + 1, a + columns, a + columns + 1);
                // Alternating diagonals keep the drawing free of a bias direction.
                if (row + column) % 2 == 0 {
                    triangles.extend([[a, b, c], [b, d, c]]);
                } else {
                    triangles.extend([[a, b, d], [a, d, c]]);
                }
            }
        }
        let particle_triangles = triangles
            .iter()
            .map(|t| t.map(|i| particles[i as usize]))
            .collect();
        Self {
            particles,
            uvs,
            triangles,
            particle_triangles,
        }
    }

    /// Copies one value per particle to every vertex.
    pub fn spread<T: Copy>(&self, by_particle: &[T], by_vertex: &mut Vec<T>) {
        by_vertex.clear();
        by_vertex.extend(
            self.particles
                .iter()
                .map(|&index| by_particle[index as usize]),
        );
    }
}
