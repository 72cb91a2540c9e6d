//! Garments of the templates on stage: meshes beside the grids of skirts and tops.
//!
//! What is worn under the skirt moves first and meets the skin; skirts lie over its outline. What is worn
//! over it moves last and meets the outline of the skirts. So every garment leads those outside of it.

use glam::{Affine3A, Vec3};
use lole_cloth::collision::layer::{Envelope, Trunk};
use lole_cloth::diagnose::StrainSummary;
use lole_costume::document::GarmentLayer;
use lole_garment::dress::{Body, DressedState, Layers, World};
use lole_geom::Surfel;

use super::order::{self, GAP};
use super::{FRAME_SECONDS, Performance, held_in};
use crate::StageError;
use crate::production::{DressedGarment, Garment};
use crate::skin_check::{self, SkinCheck};
use crate::solver::{CONTACT_OFFSET, Observer};

/// Share of its velocity that cloth keeps from frame to frame until the dance begins.
const SETTLING: f32 = 0.9;

/// The moving part of a dressed garment.
#[derive(Clone)]
pub(super) struct Dressed {
    state: DressedState,
    positions: Vec<Vec3>,
    /// The garment with what a hand holds of it; `None` where none does.
    held: Option<Box<lole_garment::dress::Dressed>>,
    /// What lies inside of it, looked at anew in every frame.
    envelope: Envelope,
    surfels: Vec<Surfel>,
    /// Whether it has flown away: it stays where it was.
    is_lost: bool,
}

/// What a dressed garment meets in a frame.
pub(super) struct Around<'a> {
    pub(super) trunk: Trunk,
    /// How bones move from the bind pose.
    pub(super) world_from_bind: &'a [Affine3A],
    /// Vertices of the skin and their normals.
    pub(super) body: (&'a [Vec3], &'a [Vec3]),
    /// The skin, arms and all.
    pub(super) skin: &'a [Surfel],
    pub(super) air_velocity: Vec3,
    pub(super) is_settling: bool,
    /// What a hand holds, by the numbers of all cloth, and where [m].
    pub(super) held: &'a [(u32, Vec3)],
}

impl Dressed {
    /// Moves it, and where its body was left, by as much [m], and makes it `faster` [m/s].
    pub(super) fn carry(&mut self, by: Vec3, faster: Vec3) {
        self.state.carry(by, faster);
    }

    pub(super) fn new(garment: &DressedGarment) -> Self {
        Self {
            state: garment.dressed.state(),
            positions: garment.dressed.start.clone(),
            held: None,
            envelope: Envelope::default(),
            surfels: Vec::new(),
            is_lost: false,
        }
    }

    /// Lets a hand hold these particles of it, by their numbers in it, and no others.
    pub(super) fn hold(
        &mut self,
        garment: &DressedGarment,
        particles: &[u32],
    ) -> Result<(), StageError> {
        if particles.is_empty() && self.held.is_none() {
            return Ok(());
        }
        let now = self.held.as_deref().unwrap_or(&garment.dressed);
        let next = garment.dressed.held(particles)?;
        self.state = self.state.passed_on(now, &next);
        self.held = (!particles.is_empty()).then(|| Box::new(next));
        Ok(())
    }

    /// Moves it on by a frame over what is worn inside of it: triangles and where they are.
    pub(super) fn step(
        &mut self,
        garment: &DressedGarment,
        (around, inside): (&Around<'_>, &[order::Inner<'_>]),
        observer: &mut Observer<'_>,
    ) {
        self.surfels.clear();
        self.surfels.extend_from_slice(around.skin);
        if !inside.is_empty() {
            self.envelope.begin_around(around.trunk, &self.positions);
            for (triangles, positions) in inside {
                self.envelope.put_on(triangles, positions);
            }
            let inset = CONTACT_OFFSET - GAP;
            self.envelope.add_surfels(inset, &mut self.surfels);
        }
        let held = held_in(&garment.particles, around.held);
        let world = World {
            held: &held,
            skin: around.body,
            surfels: &self.surfels,
            world_from_bind: around.world_from_bind,
            air_velocity: around.air_velocity,
            floor: Vec3::ZERO,
        };
        let sewn = self.held.as_deref().unwrap_or(&garment.dressed);
        let moved = match observer {
            None => self.state.step(sewn, &world, FRAME_SECONDS),
            Some(passed) => (self.state).step_observed(sewn, (&world, FRAME_SECONDS), *passed),
        };
        self.is_lost |= moved.is_err();
        if around.is_settling {
            self.state.scale_velocities(&garment.dressed, SETTLING);
        }
        self.state
            .copy_positions(&garment.dressed, &mut self.positions);
    }

    pub(super) fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Where it found no place outside of the skin, or no way there that does not cross [m].
    pub(super) fn without_room(&self, garment: &DressedGarment) -> Vec<Vec3> {
        let held = self.state.without_room(&garment.dressed);
        held.iter().map(|&it| self.positions[it as usize]).collect()
    }

    pub(super) fn substep_count(&self, garment: &DressedGarment) -> u32 {
        self.state.substep_count(&garment.dressed)
    }

    pub(super) const fn is_lost(&self) -> bool {
        self.is_lost
    }

    pub(super) fn hash(&self) -> u64 {
        self.state.hash()
    }

    /// How much the cloth is stretched, and how much of it is in the skin.
    pub(super) fn measure(
        &self,
        garment: &DressedGarment,
        body: skin_check::CheckedSurface<'_>,
    ) -> (StrainSummary, SkinCheck) {
        let strain = garment.dressed.strain(&self.positions);
        (strain, skin_check::check(body, self.surface(garment)))
    }

    /// The cloth, without what only holds it together.
    fn surface<'a>(&'a self, garment: &'a DressedGarment) -> skin_check::CheckedSurface<'a> {
        skin_check::CheckedSurface {
            positions: &self.positions,
            normals: &[],
            triangles: &garment.dressed.open_triangles,
        }
    }
}

/// Moves the garments of a layer on by a frame, each over those inside of it and over `grids`.
pub(super) fn step_layer(
    (moving, garments): (&mut [Dressed], &[DressedGarment]),
    layer: GarmentLayer,
    (around, grids): (&Around<'_>, &[order::Inner<'_>]),
    observer: &mut Observer<'_>,
) {
    for place in 0..moving.len() {
        let (before, rest) = moving.split_at_mut(place);
        let (Some(own), garment) = (rest.first_mut(), &garments[place]) else {
            continue;
        };
        if garment.layer != layer {
            continue;
        }
        let worn = before.iter().zip(garments);
        let worn = worn.filter(|(_, other)| other.is_inside(layer));
        let inside = worn.map(|(moving, other)| {
            let triangles = &other.dressed.trunk_triangles[..];
            (triangles, moving.positions())
        });
        let inside: Vec<order::Inner<'_>> = inside.chain(grids.iter().copied()).collect();
        own.step(garment, (around, &inside), observer);
    }
}

/// Triangles and places of skirts and tops.
pub(super) fn grids<'a>(
    garments: &'a [Garment],
    positions: &'a [Vec3],
) -> impl Iterator<Item = (&'a [[u32; 3]], &'a [Vec3])> {
    garments.iter().map(|garment| {
        let own = &positions[garment.particles.clone()];
        (&garment.mesh.particle_triangles[..], own)
    })
}

impl Performance {
    /// Particles of a dressed garment [m], by its place among those of the production.
    #[must_use]
    pub fn dressed_positions(&self, place: usize) -> &[Vec3] {
        self.dressed[place].positions()
    }

    /// Vertices of a dressed garment as it is drawn [m], by its place among those of the production, and
    /// their outward normals.
    #[must_use]
    pub fn dressed_vertices(&self, place: usize) -> [Vec<Vec3>; 2] {
        let garment = &self.production.dressed[place].dressed;
        let drawn = garment.drawn(self.dressed[place].positions());
        let normals = garment.normals(&drawn);
        [drawn, normals]
    }

    /// How much a dressed garment is stretched in the current frame, and how much of it is in the drawn
    /// skin; call [`Self::pose_body`] first.
    #[must_use]
    pub fn measure_dressed(&self, place: usize) -> (StrainSummary, SkinCheck) {
        self.dressed[place].measure(&self.production.dressed[place], self.body_surface())
    }

    /// Which cloth of a dressed garment lies outside where it covers itself, in the current frame; call
    /// [`Self::pose_body`] first.
    #[must_use]
    pub fn dressed_layers(&self, place: usize) -> Layers {
        let garment = &self.production.dressed[place].dressed;
        Layers::new(garment, self.dressed_positions(place), self.layered_body())
    }

    /// Places of a dressed garment whose `layers` have changed sides; call [`Self::pose_body`] first.
    #[must_use]
    pub fn dressed_inversions(&self, place: usize, layers: &Layers) -> usize {
        let garment = &self.production.dressed[place].dressed;
        layers.inversions(garment, self.dressed_positions(place), self.layered_body())
    }

    fn layered_body(&self) -> Body<'_> {
        Body {
            positions: &self.body_positions,
            normals: &self.body_normals,
            triangles: &self.production.body_triangles,
        }
    }

    /// Vertices of the drawn body that lie outside a dressed garment which should cover them, as
    /// [`Self::measure_dressed`] counts them; call [`Self::pose_body`] first.
    #[must_use]
    pub fn showing_through(&self, place: usize) -> Vec<usize> {
        let garment = &self.production.dressed[place];
        let cloth = self.dressed[place].surface(garment);
        skin_check::showing(self.body_surface(), cloth)
    }
}
