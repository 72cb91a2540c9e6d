//! A body as a moving triangle mesh, deep ones included: what cloth meets of it, and how what starts or is
//! driven deep inside comes out.
//!
//! The skin itself is met in surfels, which are looked for as far as [`SKIN_REACH`]. What is deeper is found by
//! how often the mesh winds around it (`lole_geom::InsideColumns`) and goes to the nearest point of the mesh, as
//! fast as the settings let anything leave a body. It stays with the side through which it began to leave: in a
//! thin limb the other one is as near.

use glam::{DVec3, Vec3};
use lole_geom::mesh::vertex_normals;
use lole_geom::triangle_grid::blend;
use lole_geom::{InsideColumns, MeshSurfels, Surfel, TriangleGrid};

use crate::SKIN_REACH;
use crate::collision::placement::Placement as _;
use crate::collision::surfel::Deep;
use crate::mesh::model::MeshModel;
use crate::mesh::state::MeshState;

/// Side of the columns in which the inside of a body is known [m].
const COLUMN: f32 = 0.01;

/// Skin that is covered this far out is in another part of the body [m]: a place may be judged by 0.71 columns
/// beside where it is.
const COVERED: f32 = 0.01;

/// Side of the cells of the search for the nearest triangle [m].
const CELL: f32 = 0.03;

/// Why a mesh is no body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyMeshError {
    /// Nothing to meet.
    #[error("the body has {vertex_count} vertices and {triangle_count} triangles; give it some")]
    Empty {
        /// Vertices found.
        vertex_count: usize,
        /// Triangles found.
        triangle_count: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} of the body names vertex {index}, and there are {vertex_count}")]
    IndexOutOfRange {
        /// Position in the list of triangles.
        triangle: usize,
        /// The index found.
        index: u32,
        /// Vertices there are.
        vertex_count: usize,
    },
    /// A vertex that is nowhere.
    #[error("vertex {vertex} of the body is at {position}; give it a finite place")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// Where it was said to be [m].
        position: Vec3,
    },
    /// The body has another number of vertices than at first.
    #[error("the body has {actual} vertices now and had {expected}; a body keeps its vertices")]
    OtherCount {
        /// Vertices found.
        actual: usize,
        /// Vertices at first.
        expected: usize,
    },
    /// A distance between surfels that is none.
    #[error("the points of the body are to be {spacing} m apart; make that more than 0")]
    Spacing {
        /// The distance found [m].
        spacing: f32,
    },
}

/// How deep a look into a body went, and what it found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Depths {
    /// How deep particles are brought out from [m]: deeper ones are counted and let alone.
    pub reach: f32,
    /// Particles deeper in the body than its skin alone brings out, [`SKIN_REACH`].
    pub deep: usize,
    /// Deep particles that are farther from the surface than the reach.
    pub out_of_reach: usize,
    /// Particles inside where the body overlaps itself, as a hand in a hip: no way leads out there, so they
    /// are let alone until the parts leave each other.
    pub covered: usize,
    /// How deep the deepest particle is that was reached [m]; 0 where none is deep.
    pub deepest: f32,
}

/// Where a deep particle comes out.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Exit {
    particle: u32,
    triangle: u32,
    barycentric: Vec3,
}

/// A moving body of triangles.
#[derive(Debug, Clone)]
pub struct MeshBody {
    triangles: Vec<[u32; 3]>,
    points: MeshSurfels,
    reach: f32,
    /// By vertex, whether cloth meets it; empty where it meets all.
    met: Vec<bool>,
    /// Before the last move, and now.
    positions: [Vec<Vec3>; 2],
    normals: [Vec<Vec3>; 2],
    surfels: Vec<Surfel>,
    columns: InsideColumns,
    /// Of the particles that were deep when looked at last, ascending.
    exits: Vec<Exit>,
    places: Vec<Vec3>,
}

impl MeshBody {
    /// How deep particles are brought out from, unless that is set otherwise [m]: more than half of a trunk.
    pub const REACH: f32 = 0.15;

    /// A body at `positions` [m], met in points at most about `spacing` [m] apart; 12 mm suits a person.
    ///
    /// Triangles turn counterclockwise seen from outside; where the mesh encloses less than nothing all of
    /// them are turned. It need not be closed, and parts may overlap: through what has a hole nothing deep is
    /// brought out.
    ///
    /// # Errors
    /// A mesh of nothing, an index without a vertex, or a number that is not finite.
    pub fn new(
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        spacing: f32,
    ) -> Result<Self, BodyMeshError> {
        if positions.is_empty() || triangles.is_empty() {
            return Err(BodyMeshError::Empty {
                vertex_count: positions.len(),
                triangle_count: triangles.len(),
            });
        }
        if !(0.0 < spacing && spacing.is_finite()) {
            return Err(BodyMeshError::Spacing { spacing });
        }
        check_finite(positions)?;
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&it| positions.len() <= it as usize) {
                return Err(BodyMeshError::IndexOutOfRange {
                    triangle,
                    index,
                    vertex_count: positions.len(),
                });
            }
        }
        let mut triangles = triangles.to_vec();
        if volume(positions, &triangles) < 0.0 {
            triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        let normals = vertex_normals(positions, &triangles);
        let mut body = Self {
            points: MeshSurfels::new(positions, &triangles, spacing),
            triangles,
            reach: Self::REACH,
            met: Vec::new(),
            positions: [positions.to_vec(), positions.to_vec()],
            normals: [normals.clone(), normals],
            surfels: Vec::new(),
            columns: InsideColumns::default(),
            exits: Vec::new(),
            places: Vec::new(),
        };
        body.pose_surfels();
        Ok(body)
    }

    /// This body, made to bring particles out from another depth [m] than [`Self::REACH`].
    #[must_use]
    pub const fn with_reach(mut self, reach: f32) -> Self {
        self.reach = reach;
        self
    }

    /// This body, of which cloth meets only the vertices that `met` says: recorded forearms hang where a skirt
    /// is, and are better let through it than in its way. By vertex; those beyond the list are met.
    #[must_use]
    pub fn with_met(mut self, met: Vec<bool>) -> Self {
        self.met = met;
        self.pose_surfels();
        self
    }

    fn is_met(&self, vertex: u32) -> bool {
        self.met.get(vertex as usize).is_none_or(|&met| met)
    }

    /// Moves the body to where its vertices are at the end of the next step [m].
    ///
    /// # Errors
    /// Another number of vertices than at first, or one that is not finite; the body stays where it was.
    pub fn pose(&mut self, positions: &[Vec3]) -> Result<(), BodyMeshError> {
        let expected = self.positions[1].len();
        if positions.len() != expected {
            return Err(BodyMeshError::OtherCount {
                actual: positions.len(),
                expected,
            });
        }
        check_finite(positions)?;
        self.positions.swap(0, 1);
        self.normals.swap(0, 1);
        self.positions[1].clear();
        self.positions[1].extend_from_slice(positions);
        self.normals[1] = vertex_normals(positions, &self.triangles);
        self.pose_surfels();
        Ok(())
    }

    fn pose_surfels(&mut self) {
        (self.points).pose(&self.positions[1], &self.normals[1], &mut self.surfels);
        self.columns = InsideColumns::new(&self.positions[1], &self.triangles, COLUMN);
        let mut surfels = std::mem::take(&mut self.surfels);
        for (surfel, carrier) in surfels.iter_mut().zip(self.points.carriers()) {
            if !self.is_met(carrier) || is_covered(&self.columns, surfel) {
                surfel.normal = Vec3::ZERO;
            }
        }
        self.surfels = surfels;
    }

    /// What [`crate::StepInput::surfels`] wants. Where the body overlaps itself nothing touches it: cloth
    /// between a hand and the hip that it is in has nowhere to go.
    #[must_use]
    pub fn surfels(&self) -> &[Surfel] {
        &self.surfels
    }

    /// The triangles, counterclockwise seen from outside.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Looks how deep the piece is in the body, before a step towards its pose: in that step what is too deep
    /// for the surfels goes towards the nearest point of the surface, by
    /// [`crate::SolverConfig::depenetration_speed`] at most, besides what the surface itself moves.
    pub fn look(&mut self, model: &MeshModel, state: &mut MeshState) -> Depths {
        let mut places = std::mem::take(&mut self.places);
        state.copy_positions(model, &mut places);
        let windings = (0_u32..).zip(places.iter().map(|&place| self.columns.winding(place)));
        let inside: Vec<(u32, i32)> = windings.filter(|&(_, winding)| 0 < winding).collect();
        let (exits, depths) = self.exits_of(&inside, &places);
        let deep = &mut state.scratch.surfel_contacts.deep_next;
        deep.clear();
        deep.extend(exits.iter().map(|exit| Deep {
            slot: model.slots.slot(exit.particle as usize),
            ends: [0, 1].map(|end| self.surfel_at(exit, end)),
        }));
        self.exits = exits;
        self.places = places;
        depths
    }

    /// Where particles that lie inside come out, those left out that the skin brings out.
    fn exits_of(&self, inside: &[(u32, i32)], places: &[Vec3]) -> (Vec<Exit>, Depths) {
        let mut depths = Depths {
            reach: self.reach,
            ..Depths::default()
        };
        let mut exits = Vec::new();
        if inside.is_empty() {
            return (exits, depths);
        }
        let grid = TriangleGrid::new(&self.positions[1], &self.triangles, CELL);
        for &(particle, winding) in inside {
            if 1 < winding {
                depths.covered += 1;
                continue;
            }
            let place = places[particle as usize];
            let Some(nearest) = grid.nearest(place, self.reach) else {
                depths.deep += 1;
                depths.out_of_reach += 1;
                continue;
            };
            let corners = self.triangles[nearest.triangle as usize];
            if !corners.into_iter().all(|corner| self.is_met(corner)) {
                continue;
            }
            // In the column's middle it may be inside and here beside the body.
            let exit = Exit {
                particle,
                triangle: nearest.triangle,
                barycentric: nearest.barycentric,
            };
            let exit = self.kept(exit, place);
            let out = self.surfel_at(&exit, 1);
            let depth = (out.position - place).dot(out.normal);
            if SKIN_REACH < depth {
                if is_covered(&self.columns, &out) {
                    depths.covered += 1;
                    continue;
                }
                depths.deep += 1;
                depths.deepest = depths.deepest.max(nearest.distance);
                exits.push(exit);
            }
        }
        (exits, depths)
    }

    /// The exit that a particle has had, where it still lies behind that and the new one faces the other way.
    fn kept(&self, new: Exit, place: Vec3) -> Exit {
        let found = (self.exits).binary_search_by_key(&new.particle, |exit| exit.particle);
        let Some(old) = found.ok().map(|at| self.exits[at]) else {
            return new;
        };
        let [had, has] = [old, new].map(|exit| self.surfel_at(&exit, 1));
        let is_behind = (place - had.position).dot(had.normal) < 0.0;
        let is_near = place.distance(had.position) < self.reach;
        if is_behind && is_near && has.normal.dot(had.normal) < 0.0 {
            old
        } else {
            new
        }
    }

    /// The skin at an exit before the last move (0) or now (1).
    fn surfel_at(&self, exit: &Exit, end: usize) -> Surfel {
        let corners = self.triangles[exit.triangle as usize].map(|corner| corner as usize);
        let of = |column: &[Vec3]| blend(corners.map(|corner| column[corner]), exit.barycentric);
        Surfel {
            position: of(&self.positions[end]),
            normal: of(&self.normals[end]).normalize_or_zero(),
        }
    }
}

/// Whether a surfel lies in another part of the body.
fn is_covered(columns: &InsideColumns, surfel: &Surfel) -> bool {
    0 < columns.winding(surfel.position + surfel.normal * COVERED)
}

fn check_finite(positions: &[Vec3]) -> Result<(), BodyMeshError> {
    let mut places = positions.iter().enumerate();
    match places.find(|(_, place)| !place.is_finite()) {
        Some((vertex, &position)) => Err(BodyMeshError::NotFinite { vertex, position }),
        None => Ok(()),
    }
}

/// What the mesh encloses in cubic meters, negative where it is turned inside out.
fn volume(positions: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    let corners = triangles
        .iter()
        .map(|it| it.map(|corner| positions[corner as usize].as_dvec3()));
    let parts = corners.map(|[a, b, c]: [DVec3; 3]| a.dot(b.cross(c)) / 6.0);
    parts.sum()
}
