//! What a dancer wears or holds, whatever it is made of: one list, and one way to look at it.
//!
//! Gathered rectangles, garments sewn from shaped pieces, and what is worn beside the cloth move by methods of
//! their own; whoever draws, exports, colors or takes hold of them goes through this list.

use std::ops::Range;

use glam::Vec3;
use lole_garment::adorn::{self, Carried};
use lole_geom::finer::Finer;

use crate::adorned::Adornment;
use crate::production::{DressedGarment, Garment, Production, cloth_count};

/// Vertices of a surface [m] and their outward unit normals.
pub type Vertices = [Vec<Vec3>; 2];

/// One thing that is worn or held.
#[derive(Clone, Copy)]
pub enum Worn<'a> {
    /// A gathered rectangle.
    Gathered(&'a Garment),
    /// A garment sewn from shaped pieces.
    Sewn(&'a DressedGarment),
    /// What is worn beside the cloth, or held.
    Beside(&'a Adornment),
}

/// What of it is drawn as one mesh.
#[derive(Clone, Copy)]
pub enum WornSurface<'a> {
    /// A gathered rectangle: the column of its seam is drawn twice.
    Gathered(&'a Garment),
    /// A garment sewn from shaped pieces: its particles are its vertices.
    Sewn(&'a DressedGarment),
    /// Part of what is worn beside the cloth, by its place there.
    Beside(&'a Adornment, usize),
}

impl<'a> Worn<'a> {
    /// Name in files; no two of a production share one.
    #[must_use]
    pub fn name(self) -> &'a str {
        match self {
            Self::Gathered(garment) => &garment.name,
            Self::Sewn(garment) => &garment.name,
            Self::Beside(adornment) => &adornment.name,
        }
    }

    /// Its place in the design's list; `None` of the design's skirt.
    #[must_use]
    pub const fn listed(self) -> Option<usize> {
        match self {
            Self::Gathered(garment) => garment.listed,
            Self::Sewn(garment) => Some(garment.listed),
            Self::Beside(adornment) => Some(adornment.place),
        }
    }

    /// Its particles among those of everything that moves by itself; none where bones carry all of it.
    #[must_use]
    pub fn particles(self) -> Range<usize> {
        match self {
            Self::Gathered(garment) => garment.particles.clone(),
            Self::Sewn(garment) => garment.particles.clone(),
            Self::Beside(adornment) => adornment.particles.clone(),
        }
    }

    /// What is drawn of it.
    pub fn surfaces(self) -> impl Iterator<Item = WornSurface<'a>> {
        let count = match self {
            Self::Gathered(_) | Self::Sewn(_) => 1,
            Self::Beside(adornment) => adornment.surfaces.len(),
        };
        (0..count).map(move |place| match self {
            Self::Gathered(garment) => WornSurface::Gathered(garment),
            Self::Sewn(garment) => WornSurface::Sewn(garment),
            Self::Beside(adornment) => WornSurface::Beside(adornment, place),
        })
    }
}

impl<'a> WornSurface<'a> {
    /// What it belongs to.
    #[must_use]
    pub const fn worn(self) -> Worn<'a> {
        match self {
            Self::Gathered(garment) => Worn::Gathered(garment),
            Self::Sewn(garment) => Worn::Sewn(garment),
            Self::Beside(adornment, _) => Worn::Beside(adornment),
        }
    }

    /// Its triangles, by its drawn vertices, counterclockwise seen from outside.
    #[must_use]
    pub fn triangles(self) -> &'a [[u32; 3]] {
        match self {
            Self::Gathered(garment) => &garment.mesh.triangles,
            Self::Sewn(garment) => &garment.dressed.triangles,
            Self::Beside(adornment, place) => &adornment.surfaces[place].triangles,
        }
    }

    /// How it is made finer for pictures from near by; `None` of what is fine enough.
    #[must_use]
    pub fn finer(self) -> Option<Finer> {
        match self {
            Self::Sewn(garment) => Some(garment.dressed.finer()),
            Self::Gathered(_) | Self::Beside(..) => None,
        }
    }

    /// What it is beside the cloth; `None` of cloth.
    #[must_use]
    pub fn beside(self) -> Option<&'a adorn::Surface> {
        match self {
            Self::Gathered(_) | Self::Sewn(_) => None,
            Self::Beside(adornment, place) => Some(&adornment.surfaces[place]),
        }
    }

    /// Whether bones carry all of it, so that nothing of it moves by itself.
    #[must_use]
    pub fn rides_on_bones(self) -> bool {
        self.beside()
            .is_some_and(|surface| matches!(surface.carried, Carried::Bones { .. }))
    }

    /// Values by particle of everything that moves by itself, as values by its drawn vertices; empty where bones
    /// carry it or its particles have no value.
    #[must_use]
    pub fn by_vertex<T: Copy>(self, by_particle: &[T]) -> Vec<T> {
        let Some(own) = by_particle.get(self.worn().particles()) else {
            return Vec::new();
        };
        let mut by_vertex = Vec::new();
        match self {
            Self::Gathered(garment) => garment.mesh.spread(own, &mut by_vertex),
            Self::Sewn(_) => by_vertex.extend_from_slice(own),
            Self::Beside(adornment, place) => {
                if let Carried::Strands(vertices) = &adornment.surfaces[place].carried {
                    let near = vertices.iter().map(|vertex| adornment.nearest(vertex));
                    by_vertex.extend(near.filter_map(|particle| own.get(particle?).copied()));
                }
            }
        }
        by_vertex
    }
}

impl Production {
    /// Everything that she wears or holds: gathered rectangles from the skin outward, then what is sewn from
    /// shaped pieces, then what is worn beside the cloth.
    pub fn worn(&self) -> impl Iterator<Item = Worn<'_>> {
        let gathered = self.garments.iter().map(Worn::Gathered);
        let sewn = self.dressed.iter().map(Worn::Sewn);
        let beside = self.adornments.iter().map(Worn::Beside);
        gathered.chain(sewn).chain(beside)
    }

    /// What is drawn of all that, in the same order.
    pub fn surfaces(&self) -> impl Iterator<Item = WornSurface<'_>> {
        self.worn().flat_map(Worn::surfaces)
    }

    /// Particles of all cloth: of gathered rectangles first, then of what is sewn.
    #[must_use]
    pub fn cloth_count(&self) -> usize {
        cloth_count(&self.garments, &self.dressed)
    }
}
