//! What is worn and held beside the cloth, on stage: hands close around it, strands hang and swing.
//!
//! Strands move after the cloth and meet the skin and what is worn over it, which does not feel them.

use glam::{Affine3A, Vec3};
use lole_body::Pose;
use lole_cloth::strands::{self, Ring, StrandConfig, StrandInput, StrandModel, StrandState};
use lole_garment::adorn::{self, Frame, HangingStrands};
use lole_geom::mesh::vertex_normals;
use lole_geom::{Surfel, fnv};

use super::FRAME_SECONDS;
use super::order::Inner;
use super::over_cloth::{Attention, OverCloth};
use crate::production::{Garment, Production};
use crate::{Adornment, StageError};

/// Frames in which strands come down from where they are let go, and their drag then [1/s].
const LOWERING_FRAMES: usize = 100;
/// Frames of it from one look at the cloth below to the next.
const LOWERING_LOOKS: usize = 5;
const LOWERING_DRAG: f32 = 7.0;

/// Columns and rows of cloth that one surfel stands for: a fold and more.
const COVER: [usize; 2] = [8, 3];

/// The moving part of all adornments.
#[derive(Clone, Default)]
pub(super) struct Adorned {
    /// In the order of the production's adornments.
    hanging: Vec<Option<Hanging>>,
    /// Room for the body as strands meet it, and for the cloth over it.
    met: Vec<Surfel>,
    worn: Vec<Surfel>,
    /// The garments sewn from shaped pieces, vertex by vertex, for strands that are not tied.
    sewn: Vec<Surfel>,
    /// The same for those that are, which lie on them.
    over: OverCloth,
}

/// Strands of one adornment.
#[derive(Clone)]
struct Hanging {
    /// Whether a step was not taken: they hang where they were.
    is_lost: bool,
    model: StrandModel,
    /// Particles that a hand holds, ascending.
    held: Vec<u32>,
    state: StrandState,
    pins: Vec<Vec3>,
    ties: Vec<Vec3>,
}

/// What strands meet in a frame.
pub(super) struct AroundStrands<'a> {
    pub(super) world_from_bind: &'a [Affine3A],
    /// The skin.
    pub(super) surfels: &'a [Surfel],
    /// Positions of the cloth of all gathered garments [m].
    pub(super) cloth: &'a [Vec3],
    /// Triangles of the garments sewn from shaped pieces, and where they are [m].
    pub(super) dressed: &'a [Inner<'a>],
    pub(super) air_velocity: Vec3,
    /// What a hand holds, ascending by the numbers of everything that moves, and where [m].
    pub(super) held: &'a [(u32, Vec3)],
}

impl Adorned {
    /// Strands on a dancer as she stands, come down to rest on her skin and the cloth of her garments
    /// [m].
    pub(super) fn new(
        production: &Production,
        world_from_bind: &[Affine3A],
        (cloth, dressed): (&[Vec3], &[Inner<'_>]),
    ) -> Result<Self, StageError> {
        let hanging = production.adornments.iter().map(|adornment| {
            let hung = adornment.strands.as_ref();
            hung.map(Hanging::new).transpose()
        });
        let mut adorned = Self {
            hanging: hanging.collect::<Result<_, _>>()?,
            ..Self::default()
        };
        if adorned.has_strands() {
            let skin = &production.dancer.skin;
            let (mut positions, mut normals) = (Vec::new(), Vec::new());
            skin.pose(world_from_bind, &mut positions, &mut normals);
            let mut surfels = Vec::new();
            (production.body_surfels).pose(&positions, &normals, &mut surfels);
            let around = AroundStrands {
                world_from_bind,
                surfels: &surfels,
                cloth,
                dressed,
                air_velocity: Vec3::ZERO,
                held: &[],
            };
            if adorned.lies_on_cloth(&around) {
                adorned.over = OverCloth::new(&surfels, dressed);
            }
            adorned.look(production, &around, Attention::Whole);
            adorned.lift(production, &around);
            for frame in 0..LOWERING_FRAMES {
                // Nothing but the strands moves, and they are lowered slowly.
                if frame.is_multiple_of(LOWERING_LOOKS) {
                    adorned.look_under_tied(&around, Attention::Whole);
                }
                adorned.step_by(production, &around, |config| StrandConfig {
                    drag_rate: config.drag_rate.max(LOWERING_DRAG),
                    ..config
                });
            }
        }
        Ok(adorned)
    }

    /// Particles [m] of each adornment that has strands.
    pub(super) fn positions(&self) -> impl Iterator<Item = &[Vec3]> {
        let hanging = self.hanging.iter().flatten();
        hanging.map(|hanging| &hanging.state.positions[..])
    }

    /// Place of the first adornment whose strands went nowhere.
    pub(super) fn lost(&self) -> Option<usize> {
        let is_lost = |hanging: &Option<Hanging>| hanging.as_ref().is_some_and(|it| it.is_lost);
        self.hanging.iter().position(is_lost)
    }

    /// Lets a hand hold these particles, by the numbers of everything that moves, and no others.
    pub(super) fn take(
        &mut self,
        production: &Production,
        particles: &[u32],
    ) -> Result<(), StageError> {
        for (adornment, hanging) in production.adornments.iter().zip(&mut self.hanging) {
            let (Some(hung), Some(hanging)) = (&adornment.strands, hanging) else {
                continue;
            };
            let held = particles
                .iter()
                .filter(|&&particle| adornment.particles.contains(&(particle as usize)));
            let first = adornment.particles.start;
            let held: Vec<u32> = held.map(|&particle| own(particle, first)).collect();
            if held != hanging.held {
                hanging.model = model_of(hung)?.with_held(&held);
                hanging.held = held;
            }
        }
        Ok(())
    }

    /// Whether anything moves by itself.
    pub(super) fn has_strands(&self) -> bool {
        self.hanging.iter().any(Option::is_some)
    }

    /// Moves all strands on by a frame.
    pub(super) fn step(&mut self, production: &Production, around: &AroundStrands<'_>) {
        self.look(production, around, Attention::InTurn);
        self.step_by(production, around, |config| config);
    }

    /// Looks at the cloth that strands lie on: the same for all of them.
    fn look(&mut self, production: &Production, around: &AroundStrands<'_>, attention: Attention) {
        self.worn.clear();
        if !around.cloth.is_empty() {
            for garment in &production.garments {
                let positions = &around.cloth[garment.particles.clone()];
                cover(garment, positions, &mut self.worn);
            }
        }
        self.sewn.clear();
        let all_tied = self.hanging.iter().flatten().all(Hanging::is_tied);
        for &(triangles, positions) in around.dressed.iter().filter(|_| !all_tied) {
            let normals = vertex_normals(positions, triangles);
            let outside = positions.iter().zip(normals);
            let surfels = outside.map(|(&position, normal)| Surfel { position, normal });
            self.sewn.extend(surfels);
        }
        self.look_under_tied(around, attention);
    }

    /// Looks at the cloth below strands that are tied, where they are now.
    fn look_under_tied(&mut self, around: &AroundStrands<'_>, attention: Attention) {
        if self.lies_on_cloth(around) {
            let tied = self.hanging.iter().flatten();
            let tied = tied.filter(|hanging| hanging.is_tied());
            let strands: Vec<Vec3> = tied
                .flat_map(|hanging| hanging.state.positions.iter().copied())
                .collect();
            let strands = (&strands[..], attention);
            self.over.look(around.surfels, around.dressed, strands);
        }
    }

    /// Whether strands that are tied lie on garments sewn from shaped pieces.
    fn lies_on_cloth(&self, around: &AroundStrands<'_>) -> bool {
        !around.dressed.is_empty() && self.hanging.iter().flatten().any(Hanging::is_tied)
    }

    /// Lifts strands that lie on cloth to where they are not in it.
    fn lift(&mut self, production: &Production, around: &AroundStrands<'_>) {
        for (adornment, hanging) in production.adornments.iter().zip(&mut self.hanging) {
            let (Some(hung), Some(hanging)) = (&adornment.strands, hanging) else {
                continue;
            };
            let lifts = hung.tie_riders.iter().map(|rider| {
                let place = rider.posed(around.world_from_bind)[0];
                self.over.lift(around.surfels, place).y
            });
            let highest = lifts.fold(0.0, f32::max);
            for position in &mut hanging.state.positions {
                position.y += highest;
            }
        }
    }

    /// Moves all strands on by a frame over the cloth that was looked at last.
    fn step_by(
        &mut self,
        production: &Production,
        around: &AroundStrands<'_>,
        change: impl Fn(StrandConfig) -> StrandConfig,
    ) {
        for (adornment, hanging) in production.adornments.iter().zip(&mut self.hanging) {
            let (Some(hung), Some(hanging)) = (&adornment.strands, hanging) else {
                continue;
            };
            self.met.clear();
            self.met.extend_from_slice(around.surfels);
            if hanging.is_tied() {
                self.over.raise(&mut self.met);
            }
            if hung.passes_arms {
                production.forearms.withdraw_all(&mut self.met);
            }
            self.met.extend_from_slice(&self.worn);
            let sewn = if hanging.is_tied() {
                self.over.far()
            } else {
                &self.sewn
            };
            self.met.extend_from_slice(sewn);
            let config = change(hung.config);
            hanging.step((adornment, hung), &self.over, around, &self.met, &config);
        }
    }

    /// Vertices [m] and normals of every surface of every adornment.
    pub(super) fn posed(
        &self,
        production: &Production,
        world_from_bind: &[Affine3A],
    ) -> Vec<[Vec<Vec3>; 2]> {
        let mut surfaces = Vec::new();
        for (adornment, hanging) in production.adornments.iter().zip(&self.hanging) {
            let frames = match (&adornment.strands, hanging) {
                (Some(hung), Some(hanging)) => hanging.frames(hung, world_from_bind),
                _ => Vec::new(),
            };
            let posed = adornment.surfaces.iter();
            surfaces.extend(posed.map(|surface| surface.posed(world_from_bind, &frames)));
        }
        surfaces
    }

    /// Mean height above the floor [m] of the ends of the first skirt of strands; `None` where none is
    /// worn.
    pub(super) fn hem_height(&self, production: &Production) -> Option<f32> {
        let mut worn = production.adornments.iter().zip(&self.hanging);
        worn.find_map(|(adornment, hanging)| {
            let (hung, hanging) = (adornment.strands.as_ref()?, hanging.as_ref()?);
            let ends = hanging.model.strands().map(|strand| strand.end - 1);
            let heights: Vec<f32> = ends.map(|end| hanging.state.positions[end].y).collect();
            let mean = heights.iter().sum::<f32>() / heights.len().max(1) as f32;
            (!hung.roots.is_empty()).then_some(mean)
        })
    }

    /// All bits of the strands, laid over a hash (`FNV-1a`, Fowler, Noll and Vo).
    pub(super) fn hashed(&self, mut hash: u64) -> u64 {
        for hanging in self.hanging.iter().flatten() {
            let state = &hanging.state;
            for vector in state.positions.iter().chain(&state.velocities) {
                for value in vector.to_array() {
                    hash = (hash ^ u64::from(value.to_bits())).wrapping_mul(fnv::PRIME);
                }
            }
        }
        hash
    }
}

impl Hanging {
    fn new(hung: &HangingStrands) -> Result<Self, StageError> {
        Ok(Self {
            is_lost: false,
            model: model_of(hung)?,
            held: Vec::new(),
            state: StrandState::new(&hung.strands),
            pins: Vec::new(),
            ties: Vec::new(),
        })
    }

    /// Whether it is held where it lies on the body.
    const fn is_tied(&self) -> bool {
        self.model.is_tied()
    }

    fn step(
        &mut self,
        (adornment, hung): (&Adornment, &HangingStrands),
        over: &OverCloth,
        around: &AroundStrands<'_>,
        met: &[Surfel],
        config: &StrandConfig,
    ) {
        for (places, riders) in [
            (&mut self.pins, &hung.pin_riders),
            (&mut self.ties, &hung.tie_riders),
        ] {
            places.clear();
            places.extend(
                riders
                    .iter()
                    .map(|rider| rider.posed(around.world_from_bind)[0]),
            );
        }
        self.place_held(adornment.particles.start, around.held);
        for place in &mut self.ties {
            *place += over.lift(around.surfels, *place);
        }
        let input = StrandInput {
            pins: &self.pins,
            ties: &self.ties,
            surfels: met,
            air_velocity: around.air_velocity,
        };
        let moved = strands::step(&self.model, config, &input, &mut self.state, FRAME_SECONDS);
        self.is_lost |= moved.is_err();
    }

    /// Puts what a hand holds among the pins, by their numbers from `first` on.
    fn place_held(&mut self, first: usize, held: &[(u32, Vec3)]) {
        if self.held.is_empty() {
            return;
        }
        let mut carried = self.pins.drain(..);
        let pins: Vec<Vec3> = (self.model.pins().iter())
            .map(|pin| match self.held.binary_search(pin) {
                Err(_) => carried.next().unwrap_or_default(),
                Ok(_) => {
                    let hand = held
                        .iter()
                        .find(|(particle, _)| own(*particle, first) == *pin);
                    hand.map_or(self.state.positions[*pin as usize], |&(_, place)| place)
                }
            })
            .collect();
        drop(carried);
        self.pins = pins;
    }

    fn frames(&self, hung: &HangingStrands, world_from_bind: &[Affine3A]) -> Vec<Vec<Frame>> {
        let rings = self.model.rings();
        let frames = self.model.strands().zip(rings).enumerate();
        frames
            .map(|(strand, (range, &ring)): (usize, (_, &Ring))| {
                let root = hung.roots.get(strand);
                let outward = root.map_or(Vec3::Y, |root| root.posed(world_from_bind)[1]);
                adorn::frames(&self.state.positions[range], ring, outward)
            })
            .collect()
    }
}

/// The strands of an adornment, nothing of them held by a hand.
fn model_of(hung: &HangingStrands) -> Result<StrandModel, StageError> {
    Ok(StrandModel::new(&hung.strands, &hung.links, &hung.ties)?)
}

/// The number of a particle among those of an adornment, which begin with `first`.
fn own(particle: u32, first: usize) -> u32 {
    let own = (particle as usize).checked_sub(first);
    own.and_then(|own| u32::try_from(own).ok())
        .unwrap_or(u32::MAX)
}

/// Closes the hands that hold something.
pub(super) fn grip(production: &Production, pose: &mut Pose) {
    let skeleton = &production.dancer.skeleton;
    for grip in production.adornments.iter().flat_map(|one| &one.grips) {
        grip.apply(skeleton, pose);
    }
}

/// What comes down on the skin above a garment slides over its upper edge, not in behind it: a ramp from
/// the skin to the edge.
fn ramp(edge: Vec3, outward: Vec3, surfels: &mut Vec<Surfel>) {
    /// Ways from the edge towards the skin [m], and the rise over them.
    const WAYS: [f32; 4] = [0.0, 0.012, 0.024, 0.036];
    const RISE: f32 = 0.9;
    let outward = outward.with_y(0.0).normalize_or_zero();
    let normal = (outward * RISE + Vec3::Y).normalize_or_zero();
    surfels.extend(WAYS.map(|way| Surfel {
        position: edge - outward * way + Vec3::Y * (RISE * way),
        normal: if outward == Vec3::ZERO {
            Vec3::ZERO
        } else {
            normal
        },
    }));
}

/// The outside of a garment's folds as surfels: of each patch of cloth its mean normal, and the
/// outermost of it in that direction.
fn cover(garment: &Garment, positions: &[Vec3], surfels: &mut Vec<Surfel>) {
    let grid = &garment.sewn.spec.grid;
    let columns = grid.column_count as usize;
    let normals = vertex_normals(positions, &garment.mesh.particle_triangles);
    let rows = positions.len() / columns.max(1);
    let starts = |count: usize, step: usize| (0..count).step_by(step);
    for row in starts(rows, COVER[1]) {
        for column in starts(columns, COVER[0]) {
            let patch = || {
                let rows = row..(row + COVER[1]).min(rows);
                rows.flat_map(move |row| {
                    let columns_of = column..(column + COVER[0]).min(columns);
                    columns_of.map(move |column| row * columns + column)
                })
            };
            let count = patch().count().max(1) as f32;
            let middle = patch().map(|k| positions[k]).sum::<Vec3>() / count;
            let normal = patch()
                .map(|k| normals[k])
                .sum::<Vec3>()
                .normalize_or_zero();
            let out = patch()
                .map(|k| (positions[k] - middle).dot(normal))
                .fold(0.0, f32::max);
            let position = middle + normal * out;
            surfels.push(Surfel { position, normal });
            if row == 0 {
                let top = patch().map(|k| positions[k].y).fold(f32::MIN, f32::max);
                ramp(position.with_y(top), normal, surfels);
            }
        }
    }
}
