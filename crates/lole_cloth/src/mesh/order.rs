//! Orders: of particles, so that neighbors on the cloth are neighbors in memory, and of
//! constraints, sixteen at a time that share no particle.

use glam::{Vec2, Vec3};

use crate::collision::placement::Placement;
use crate::lanes::{LANES, Points, narrow};
use crate::mesh::particles::{BASE_STEP, Lanes, WIDTH, WINDOW_SLOTS};
use crate::mesh::spec::MeshError;
use crate::mesh::surface_order;
use crate::mesh::topology::Topology;

/// Side of the tiles that are filled one after the other, in mean distances of particles. A tile
/// is what meets a capsule together.
const TILE_SIDE: f32 = 8.0;

/// Vectors of particles that meet the body together: a tile of 8 by 8.
pub(crate) const PATCH_VECTORS: usize = 4;

/// The particle of a slot that has none.
const NOTHING: u32 = u32::MAX;

/// Where particles stand in the engine's own order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Slots {
    /// By particle.
    pub(crate) of_particle: Vec<u32>,
    /// By slot; [`NOTHING`] where there is none.
    particles: Vec<u32>,
    /// Slots in all, those of nothing included: whole patches.
    pub(crate) count: usize,
    /// By vector, a bit for every lane with a particle.
    occupied: Vec<u16>,
}

impl Slots {
    /// Orders particles tile by tile of the flat piece, along its shorter side first, so that
    /// neighbors stand at most about two strips of tiles apart. `area` is that of the piece [m²].
    pub(crate) fn new(flat: &[Vec2], area: f32) -> Self {
        let low = flat.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let high = flat.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        let extent = high - low;
        #[expect(clippy::cast_precision_loss, reason = "an estimate of the spacing")]
        let tile = TILE_SIDE * (area / flat.len() as f32).sqrt();
        let key = |&point: &Vec2| {
            let place = (point - low) / tile;
            let place = if extent.x < extent.y {
                place
            } else {
                Vec2::new(place.y, place.x)
            };
            let corner = place.floor();
            let within = ((place - corner) * 255.0).as_uvec2();
            (
                [corner.y.to_bits(), corner.x.to_bits()],
                interleave(within.x, within.y),
            )
        };
        let mut order: Vec<_> = flat.iter().map(key).zip(0_u32..).collect();
        order.sort_unstable();
        let order: Vec<u32> = order.into_iter().map(|(_, particle)| particle).collect();
        Self::in_order(&order)
    }

    /// Orders the particles of a surface without a plane, by patches of neighbors.
    pub(crate) fn along(topology: &Topology) -> Self {
        Self::in_order(&surface_order::patch_by_patch(&topology.neighbors))
    }

    /// Puts particles into slots in their order.
    fn in_order(order: &[u32]) -> Self {
        let mut of_particle = vec![0; order.len()];
        for (place, &particle) in order.iter().enumerate() {
            // The last slot before every possible start of a window stays empty.
            of_particle[particle as usize] = narrow(place + place / (BASE_STEP - 1));
        }
        let last = order.len() + order.len() / (BASE_STEP - 1);
        let count = last.next_multiple_of(LANES * PATCH_VECTORS);
        let mut occupied = vec![0; count / LANES];
        for &slot in &of_particle {
            occupied[slot as usize / LANES] |= 1 << (slot as usize % LANES);
        }
        let mut particles = vec![NOTHING; count];
        for (particle, &slot) in (0_u32..).zip(&of_particle) {
            particles[slot as usize] = particle;
        }
        Self {
            particles,
            of_particle,
            count,
            occupied,
        }
    }

    /// The particle of a vector and lane.
    pub(crate) fn particle_at(&self, (vector, lane): (usize, usize)) -> Option<usize> {
        let particle = self.particles[vector * LANES + lane];
        (particle != NOTHING).then_some(particle as usize)
    }
}

impl Placement for Slots {
    fn slot(&self, particle: usize) -> (usize, usize) {
        let slot = self.of_particle[particle] as usize;
        (slot / LANES, slot % LANES)
    }

    fn row_count(&self) -> usize {
        self.occupied.len() / PATCH_VECTORS
    }

    fn row_of(&self, vector: usize) -> usize {
        vector / PATCH_VECTORS
    }

    fn add_row_slots(&self, row: usize, slots: &mut Vec<(usize, usize)>) {
        let first = row * PATCH_VECTORS;
        for (vector, &lanes) in (first..).zip(&self.occupied[first..first + PATCH_VECTORS]) {
            let occupied = (0..LANES).filter(|lane| lanes >> lane & 1 == 1);
            slots.extend(occupied.map(|lane| (vector, lane)));
        }
    }

    fn gather_points(&self, vectors: &[Points], points: &mut Vec<Vec3>) {
        points.clear();
        let at = |&slot: &u32| vectors[slot as usize / LANES].get(slot as usize % LANES);
        points.extend(self.of_particle.iter().map(at));
    }
}

impl Slots {
    /// The slots of these particles.
    pub(crate) fn of<const N: usize>(&self, particles: [u32; N]) -> [u32; N] {
        particles.map(|particle| self.of_particle[particle as usize])
    }
}

/// The bits of two bytes in turn (Morton 1966): a curve that fills the tile.
fn interleave(x: u32, y: u32) -> u32 {
    (0..8).fold(0, |key, bit| {
        key | (x >> bit & 1) << (2 * bit) | (y >> bit & 1) << (2 * bit + 1)
    })
}

/// Batches that are filled at the same time: as many as a word has bits.
const OPEN_COUNT: usize = 64;

/// Parts of a piece whose batches take turns.
const PARTS_IN_TURN: usize = 4;

/// Sixteen constraints that share no particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Batch {
    /// Slot at which their window starts.
    pub(crate) base: u32,
    /// Which constraint stands in each lane; none where the batch is not full.
    pub(crate) constraints: [Option<u32>; LANES],
}

impl Batch {
    /// The slot that each constraint has at a place of its list, as offsets; nothing where there
    /// is none.
    pub(crate) fn lanes(&self, slot: impl Fn(usize) -> Option<u32>) -> Lanes {
        let filler = self.base + narrow(BASE_STEP) - 1;
        Lanes(self.constraints.map(|constraint| {
            let slot = constraint.and_then(|constraint| slot(constraint as usize));
            let offset = (slot.unwrap_or(filler) - self.base) as usize * WIDTH;
            u16::try_from(offset).unwrap_or(u16::MAX)
        }))
    }

    /// A number of each constraint, or `filler`.
    pub(crate) fn column(&self, filler: f32, value: impl Fn(usize) -> f32) -> [f32; LANES] {
        self.constraints
            .map(|constraint| constraint.map_or(filler, |constraint| value(constraint as usize)))
    }
}

/// A batch that is being filled.
#[derive(Clone, Copy)]
struct Open {
    batch: Batch,
    count: usize,
}

impl Open {
    const EMPTY: Self = Self {
        batch: Batch {
            base: 0,
            constraints: [None; LANES],
        },
        count: 0,
    };

    fn has_room(&self, [low, high]: [u32; 2]) -> bool {
        self.count == 0 || self.batch.base <= low && high - self.batch.base < narrow(WINDOW_SLOTS)
    }
}

/// Cuts constraints into batches whose members share no particle, nearly in their order.
///
/// `lists` holds the slots of each. A constraint goes into the first batch still open that has none
/// of its particles; a full batch is closed.
///
/// # Errors
/// When the particles of one stand too far apart for a window.
pub(crate) fn into_batches(lists: &[&[u32]], slot_count: usize) -> Result<Vec<Batch>, MeshError> {
    let mut batches = Vec::new();
    let mut open = vec![Open::EMPTY; OPEN_COUNT];
    // For every slot, the open batches that it is in.
    let mut marks = vec![0_u64; slot_count];
    for (constraint, list) in (0_u32..).zip(lists) {
        let bounds = bounds(list, slot_count)?;
        let taken = list
            .iter()
            .fold(0, |word, &slot| word | marks[slot as usize]);
        let free =
            (0..OPEN_COUNT).find(|&place| taken >> place & 1 == 0 && open[place].has_room(bounds));
        let place = free.unwrap_or_else(|| {
            let fullest = (0..OPEN_COUNT).max_by_key(|&place| open[place].count);
            fullest.unwrap_or(0)
        });
        if free.is_none() {
            batches.push(close(&mut open, place, lists, &mut marks));
        }
        let Open { batch, count } = &mut open[place];
        if *count == 0 {
            batch.base = window_start(bounds[0]);
        }
        batch.constraints[*count] = Some(constraint);
        *count += 1;
        for &slot in *list {
            marks[slot as usize] |= 1 << place;
        }
        if *count == LANES {
            batches.push(close(&mut open, place, lists, &mut marks));
        }
    }
    let rest = open.into_iter().filter(|open| 0 < open.count);
    batches.extend(rest.map(|open| open.batch));
    Ok(in_turn(&batches))
}

/// Batches that follow each other are from different parts of the piece, so that one need not wait
/// for what the last has written, and the processor works on several at a time.
fn in_turn(batches: &[Batch]) -> Vec<Batch> {
    let part = batches.len().div_ceil(PARTS_IN_TURN).max(1);
    let turns = (0..part).flat_map(|first| batches[first..].iter().step_by(part));
    turns.copied().collect()
}

/// Lowest and highest slot of a constraint.
fn bounds(list: &[u32], slot_count: usize) -> Result<[u32; 2], MeshError> {
    let low = list.iter().copied().min().unwrap_or(0);
    let high = list.iter().copied().max().unwrap_or(0);
    if narrow(WINDOW_SLOTS) <= high - window_start(low) {
        return Err(MeshError::TooLarge {
            particle_count: slot_count,
        });
    }
    Ok([low, high])
}

const fn window_start(slot: u32) -> u32 {
    slot - slot % narrow(BASE_STEP)
}

fn close(open: &mut [Open], place: usize, lists: &[&[u32]], marks: &mut [u64]) -> Batch {
    let batch = open[place].batch;
    for &constraint in batch.constraints.iter().flatten() {
        for &slot in lists[constraint as usize] {
            marks[slot as usize] &= !(1 << place);
        }
    }
    open[place] = Open::EMPTY;
    batch
}
