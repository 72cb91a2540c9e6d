//! Where everything that is drawn is in one moment.

use glam::Vec3;
use lole_stage::Performance;

/// Vertices of a surface [m] and their outward unit normals.
pub type Vertices = [Vec<Vec3>; 2];

/// Dancer and garments in one moment, as they are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Figure<'a> {
    /// The garments, in the production's order, the seam's column twice (see
    /// [`SkirtMesh::spread`](lole_costume::sew::SkirtMesh::spread)).
    pub cloths: &'a [Vertices],
    /// Linear color factors of their vertices, by garment; empty, or of a garment empty, where the cloth
    /// has its own colors.
    pub cloth_colors: &'a [Vec<Vec3>],
    /// The dressed garments, in the production's order.
    pub dressed: &'a [Vertices],
    /// The surfaces of the adornments, one after the other in the production's order.
    pub adornments: &'a [Vertices],
    /// The posed body: vertices [m] and their normals.
    pub body: [&'a [Vec3]; 2],
}

/// A performance's present frame, kept to be drawn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Moment {
    /// The garments, in the production's order.
    pub cloths: Vec<Vertices>,
    /// The dressed garments, in the production's order.
    pub dressed: Vec<Vertices>,
    /// The surfaces of the adornments, one after the other.
    pub adornments: Vec<Vertices>,
    /// The body.
    pub body: Vertices,
}

impl Moment {
    /// The present frame of a performance; its body must be posed.
    #[must_use]
    pub fn of(performance: &Performance) -> Self {
        let production = performance.production();
        let cloths = production.garments.iter().map(|garment| {
            let particles = performance.pressed_positions(garment);
            garment.mesh.vertices(&particles)
        });
        let dressed: Vec<Vertices> = (0..production.dressed.len())
            .map(|place| performance.dressed_vertices(place))
            .collect();
        let mut body = performance.body_positions().to_vec();
        let normals = performance.body_normals().to_vec();
        lole_stage::give_way(production, &dressed, (&mut body, &normals));
        Self {
            cloths: cloths.collect(),
            dressed,
            adornments: performance.posed_adornments(),
            body: [body, normals],
        }
    }

    /// What is drawn of it; cloth in its own colors.
    #[must_use]
    pub fn figure(&self) -> Figure<'_> {
        Figure {
            cloths: &self.cloths,
            cloth_colors: &[],
            dressed: &self.dressed,
            adornments: &self.adornments,
            body: [&self.body[0], &self.body[1]],
        }
    }
}
