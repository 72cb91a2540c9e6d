//! What a piece of cloth of any triangle mesh is made of, and why one cannot be built.

use glam::{DVec2, DVec3, Vec2, Vec3};

use crate::Fabric;

/// Everything that never changes about one piece of cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSpec {
    /// Every particle in the flat piece [m]: `x` runs along the warp (`u`), `y` along the weft
    /// (`v`). Shape `[particle_count]`; empty where every triangle is laid flat by itself.
    pub flat_positions: Vec<Vec2>,
    /// Three particles each, in either direction around.
    pub triangles: Vec<[u32; 3]>,
    /// Of pieces that are welded to one surface: the corners of every triangle as it lies flat [m],
    /// warp along `x`, in the order of its particles and wherever in the plane. Only their
    /// differences count, and a triangle may lie mirrored. Shape `[triangle_count]`; empty where
    /// the piece as a whole lies flat.
    pub flat_corners: Vec<[Vec2; 3]>,
    /// Where the particles lie when nothing is bent [m]: what was pressed or knitted into a shape goes back to
    /// it. Bending alone asks for it, wherever it stands and however it is turned. Shape
    /// `[particle_count]`; empty where nothing is bent when it is flat.
    pub bent_positions: Vec<Vec3>,
    /// Material of the whole piece.
    pub fabric: Fabric,
    /// Layers of cloth at each particle: 1, or more where a hem or casing is folded. Multiplies
    /// the mass and the bending stiffness: each layer bends by itself. Shape `[particle_count]`.
    pub layers: Vec<f32>,
    /// Particles carried exactly by the body, shape `[particle_count]`.
    pub pinned: Vec<bool>,
}

impl MeshSpec {
    /// A free piece, one layer thick.
    #[must_use]
    pub fn new(flat_positions: Vec<Vec2>, triangles: Vec<[u32; 3]>, fabric: Fabric) -> Self {
        Self {
            layers: vec![1.0; flat_positions.len()],
            pinned: vec![false; flat_positions.len()],
            flat_positions,
            triangles,
            flat_corners: Vec::new(),
            bent_positions: Vec::new(),
            fabric,
        }
    }

    /// A free piece of pieces that are welded to one surface, such as a garment whose seams are
    /// closed: each triangle lies flat as `flat_corners` [m] say, `texture coordinates by corner
    /// times what one of them measures`, so both sides of a seam keep their own grain.
    ///
    /// Where two sides of a seam differ in length each wants its own, and the cloth there is
    /// strained until they agree. At rest nothing is bent: a fold is where the cloth was pressed,
    /// not what it remembers.
    #[must_use]
    pub fn welded(
        particle_count: usize,
        triangles: Vec<[u32; 3]>,
        flat_corners: Vec<[Vec2; 3]>,
        fabric: Fabric,
    ) -> Self {
        Self {
            layers: vec![1.0; particle_count],
            pinned: vec![false; particle_count],
            flat_positions: Vec::new(),
            triangles,
            flat_corners,
            bent_positions: Vec::new(),
            fabric,
        }
    }

    /// A free piece whose triangles are as large as they are at `positions` [m], warp of each in its
    /// plane along what `warp` says of it: a surface in space that is strained by nothing as it is.
    ///
    /// Where a triangle is square to its warp, or there is none, warp runs along the axis that is
    /// nearest to its plane. At rest nothing is bent, as of [`MeshSpec::welded`].
    #[must_use]
    pub fn of_surface(
        positions: &[Vec3],
        triangles: Vec<[u32; 3]>,
        warp: impl Fn(usize) -> Vec3,
        fabric: Fabric,
    ) -> Self {
        let place = |corner: u32| positions.get(corner as usize).copied().unwrap_or(Vec3::NAN);
        let corners = triangles.iter().enumerate();
        let flat_corners =
            corners.map(|(triangle, corners)| laid(corners.map(place), warp(triangle)));
        Self::welded(
            positions.len(),
            triangles.clone(),
            flat_corners.collect(),
            fabric,
        )
    }

    /// This piece, bent by nothing where its particles are at `positions` [m] instead of where it is flat.
    /// Shape `[particle_count]`.
    #[must_use]
    pub fn bent_at(mut self, positions: Vec<Vec3>) -> Self {
        self.bent_positions = positions;
        self
    }

    /// Number of particles.
    #[must_use]
    pub const fn particle_count(&self) -> usize {
        if self.flat_corners.is_empty() {
            self.flat_positions.len()
        } else {
            self.layers.len()
        }
    }
}

/// A warp nearer to a triangle's normal than this, as the sine of the angle, has no direction in it.
const SQUARE: f64 = 1.0e-3;

/// A triangle in space [m] as it lies flat, its first corner in the origin.
fn laid([origin, first, second]: [Vec3; 3], warp: Vec3) -> [Vec2; 3] {
    let [e1, e2] = [first, second].map(|corner| corner.as_dvec3() - origin.as_dvec3());
    let normal = e1.cross(e2).normalize_or_zero();
    let within = |axis: DVec3| axis - normal * normal.dot(axis);
    let wanted = within(warp.as_dvec3().normalize_or_zero());
    let along = if SQUARE < wanted.length() {
        wanted
    } else {
        let axes = DVec3::AXES.map(within);
        let longer = |a: DVec3, b: DVec3| if a.length() < b.length() { b } else { a };
        axes.into_iter().fold(DVec3::ZERO, longer)
    };
    let along = along.normalize_or_zero();
    let across = normal.cross(along);
    let flat = |edge: DVec3| DVec2::new(edge.dot(along), edge.dot(across)).as_vec2();
    [Vec2::ZERO, flat(e1), flat(e2)]
}

/// Why a [`MeshSpec`] cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// No particle or no triangle.
    #[error("the mesh has {particle_count} particles and {triangle_count} triangles; give it some")]
    Empty {
        /// Particles found.
        particle_count: usize,
        /// Triangles found.
        triangle_count: usize,
    },
    /// Neighbors stand farther apart in memory than the engine reaches: half a million particles
    /// in a square fit, and more in a strip.
    #[error("the mesh has {particle_count} particles, too many for one piece; cut it in two")]
    TooLarge {
        /// Particles found.
        particle_count: usize,
    },
    /// A column of the specification has another length than there are particles.
    #[error("`{field}` has {actual} entries; the mesh needs {expected}")]
    WrongLength {
        /// Field of the specification.
        field: &'static str,
        /// Entries found.
        actual: usize,
        /// Entries needed.
        expected: usize,
    },
    /// A triangle names a particle that does not exist.
    #[error("triangle {triangle} names particle {index}, and there are {particle_count}")]
    IndexOutOfRange {
        /// Position in the list of triangles.
        triangle: usize,
        /// The index found.
        index: u32,
        /// Particles there are.
        particle_count: usize,
    },
    /// A flat position that is not a number, or is infinite.
    #[error("particle {particle} lies at ({}, {}) in the flat piece; give it a finite place", position.x, position.y)]
    NotFinite {
        /// The particle.
        particle: usize,
        /// Where it was said to lie [m].
        position: Vec2,
    },
    /// A flat corner that is not a number, or is infinite.
    #[error(
        "corner {corner} of triangle {triangle} lies at ({}, {}) in the flat; give it a finite place",
        position.x, position.y
    )]
    CornerNotFinite {
        /// Position in the list of triangles.
        triangle: usize,
        /// Which of its corners, from 0.
        corner: usize,
        /// Where it was said to lie [m].
        position: Vec2,
    },
    /// A place of the bent piece that is not a number, or is infinite.
    #[error("particle {particle} lies at {position} in the bent piece; give it a finite place")]
    BentNotFinite {
        /// The particle.
        particle: usize,
        /// Where it was said to lie [m].
        position: Vec3,
    },
    /// A triangle that names a particle twice.
    #[error("triangle {triangle} names particle {index} twice; remove it")]
    Repeated {
        /// Position in the list of triangles.
        triangle: usize,
        /// The particle.
        index: u32,
    },
    /// A surface with one side only.
    #[error(
        "the surface has no two sides: around the edge of particles {first} and {second} it comes back turned over; cut it there"
    )]
    OneSided {
        /// One end of the edge.
        first: u32,
        /// The other end of the edge.
        second: u32,
    },
    /// A triangle without area, or one so narrow that its area is rounding.
    #[error(
        "triangle {triangle} is {height} m high over a side of {side} m; remove it or move a corner"
    )]
    ZeroArea {
        /// Position in the list of triangles.
        triangle: usize,
        /// The triangle's longest side [m].
        side: f32,
        /// The triangle's height over that side [m].
        height: f32,
    },
    /// A particle of no triangle, which would weigh nothing.
    #[error("particle {particle} belongs to no triangle and would weigh nothing; remove it")]
    ZeroMass {
        /// The particle.
        particle: usize,
    },
    /// More than two triangles share an edge.
    #[error(
        "{triangle_count} triangles share the edge of particles {first} and {second}; cloth has at most two there"
    )]
    NonManifoldEdge {
        /// One end of the edge.
        first: u32,
        /// The other end of the edge.
        second: u32,
        /// Triangles that share it.
        triangle_count: usize,
    },
    /// Two parts of the piece touch in a single particle only.
    #[error(
        "parts of the mesh hang together by particle {particle} alone; give each part its own and sew them"
    )]
    NonManifoldVertex {
        /// The particle.
        particle: usize,
    },
    /// Two neighboring triangles lie on top of each other in the flat piece.
    #[error(
        "the flat piece folds over at the edge of particles {first} and {second}; lay it out flat"
    )]
    FoldedOver {
        /// One end of the edge.
        first: u32,
        /// The other end of the edge.
        second: u32,
    },
    /// A number that is not finite or that no fabric has.
    #[error("`{field}` is {value}; it must be {rule}")]
    OutOfRange {
        /// Field of the specification.
        field: &'static str,
        /// The value found.
        value: f32,
        /// What would be allowed.
        rule: &'static str,
    },
}
