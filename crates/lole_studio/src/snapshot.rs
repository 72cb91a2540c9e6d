//! One moment of the show, handed from the simulation's thread to the picture.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::Vec3;
use lole_body::{Bone, Taped};
use lole_cloth::Grid;
use lole_geom::Capsule;
use lole_picture::{Looks, Moment};
use lole_render::Scene;
use lole_stage::{Divergence, Production, WornSurface};

use crate::history::Sample;

/// What belongs together as long as the skirt is not sewn anew.
pub struct Wardrobe {
    /// Tells wardrobes apart.
    pub id: u64,
    /// Dancer, dance and garments.
    pub production: Arc<Production>,
    /// Materials.
    pub looks: Looks,
    /// What a tape says around the dancer.
    pub taped: [Taped; 14],
    /// What she wears in fewer triangles, surface by surface, for adapters that compute on the processor;
    /// `None` where there are no fewer.
    pub(crate) coarse_triangles: Vec<Option<Vec<[u32; 3]>>>,
}

impl Wardrobe {
    /// A wardrobe with a number of its own.
    pub(crate) fn new(production: Arc<Production>, looks: Looks) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        Self {
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            coarse_triangles: (production.surfaces())
                .map(|surface| match surface {
                    WornSurface::Gathered(garment) => {
                        Some(coarse_triangles(&garment.sewn.spec.grid))
                    }
                    WornSurface::Sewn(_) | WornSurface::Beside(..) => None,
                })
                .collect(),
            taped: production.dancer.taped(&production.design.tape()),
            production,
            looks,
        }
    }
}

impl Wardrobe {
    /// Draws what she wears in fewer triangles.
    pub(crate) fn coarsen<'a>(&'a self, scene: &mut Scene<'a>) {
        for (mesh, triangles) in scene.meshes.iter_mut().zip(&self.coarse_triangles) {
            // Cloth comes first in a scene.
            let Some(triangles) = triangles else { break };
            mesh.triangles = triangles;
        }
    }
}

/// Triangles over every second row and column of a grid's vertices, the last ones included.
fn coarse_triangles(grid: &Grid) -> Vec<[u32; 3]> {
    let columns = grid.cell_columns() + 1;
    let every_second = |count: u32| {
        let mut kept: Vec<u32> = (0..count).step_by(2).collect();
        if kept.last() != Some(&(count - 1)) {
            kept.push(count - 1);
        }
        kept
    };
    let (rows, kept) = (every_second(grid.row_count), every_second(columns));
    let mut triangles = Vec::new();
    for row in rows.windows(2) {
        for column in kept.windows(2) {
            let at = |row: u32, column: u32| row * columns + column;
            let (a, b) = (at(row[0], column[0]), at(row[0], column[1]));
            let (c, d) = (at(row[1], column[0]), at(row[1], column[1]));
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    triangles
}

/// One moment.
pub struct Snapshot {
    /// What is shown.
    pub wardrobe: Arc<Wardrobe>,
    /// Time of the dance [s]; negative while the skirt settles.
    pub time: f32,
    /// Particles of all cloth [m].
    pub particles: Vec<Vec3>,
    /// Everything as it is drawn.
    pub moment: Moment,
    /// What the cloth meets.
    pub capsules: Vec<Capsule>,
    /// Ends of each bone [m].
    pub bones: Vec<[Vec3; 2]>,
    /// Strain at every particle of all cloth; empty where it is not watched.
    pub strain: Vec<f32>,
    /// Particles below the drawn skin [m]; empty where they are not watched.
    pub sunken: Vec<Vec3>,
    /// The frames since the last snapshot.
    pub samples: Vec<Sample>,
    /// Seconds of the dance in one second on the wall, measured; `None` while it stands still.
    pub pace: Option<f64>,
    /// Place of the part of the choreography that is danced.
    pub part: Option<usize>,
    /// How long the recording is that is danced [s].
    pub recording_seconds: Option<f32>,
    /// Substeps of one frame.
    pub substep_count: u32,
    /// Parts of the body beside which cloth has no room.
    pub without_room: Vec<Bone>,
    /// Where and when the cloth flew apart.
    pub stopped: Option<Divergence>,
}
