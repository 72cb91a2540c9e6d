//! One moment of the show, handed from the simulation's thread to the picture.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::Vec3;
use lole_body::{Bone, Taped};
use lole_cloth::Grid;
use lole_geom::Capsule;
use lole_pattern::Tailored;
use lole_picture::{Looks, Moment};
use lole_render::Scene;
use lole_stage::{Divergence, PartNow, Production, Worn, WornSurface};

use crate::history::Sample;

/// What belongs together as long as the skirt is not sewn anew. It is all that the picture needs of the
/// production, which stays with the simulation.
pub struct Wardrobe {
    /// Tells wardrobes apart.
    pub id: u64,
    /// Triangles, materials and prints.
    pub looks: Looks,
    /// Height of the dancer's crown above the floor [m].
    pub crown_height: f32,
    /// What a tape says around the dancer.
    pub taped: [Taped; 14],
    /// What her body has of each of [`Tailored::ALL`] [cm].
    pub tailored_cm: [f64; Tailored::ALL.len()],
    /// The springs of everything that is worn, as they are shown.
    pub(crate) nets: Vec<Net>,
    /// Which particle of all cloth each drawn vertex goes with, surface by surface; empty where bones carry it.
    pub(crate) particle_of_vertex: Vec<Vec<u32>>,
    /// What she wears in fewer triangles, surface by surface, for adapters that compute on the processor;
    /// `None` where there are no fewer.
    pub(crate) coarse_triangles: Vec<Option<Vec<[u32; 3]>>>,
}

/// The springs of one thing that is worn, as lines between particles.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Net {
    /// Distance between the finest threads of a grid [m]; 0 where all lines are always shown.
    pub(crate) spacing: f32,
    /// The lines, by particles of all cloth, and which row or column of a grid each lies on.
    pub(crate) lines: Vec<[u32; 3]>,
}

impl Wardrobe {
    /// A wardrobe with a number of its own.
    pub(crate) fn new(production: &Production, looks: Looks) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        let particles = u32::try_from(production.moving_count()).unwrap_or(u32::MAX);
        let numbers: Vec<u32> = (0..particles).collect();
        let measures = lole_garment::measures(&production.dancer);
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
            particle_of_vertex: (production.surfaces())
                .map(|surface| surface.by_vertex(&numbers))
                .collect(),
            nets: production.worn().filter_map(Net::of).collect(),
            crown_height: production.dancer.landmarks.crown_height,
            taped: production.dancer.taped(&production.design.tape()),
            tailored_cm: Tailored::ALL.map(|tailored| tailored.measure().of(&measures).to_cm()),
            looks,
        }
    }

    /// Draws what she wears in fewer triangles.
    pub(crate) fn coarsen<'a>(&'a self, scene: &mut Scene<'a>) {
        for (mesh, triangles) in scene.meshes.iter_mut().zip(&self.coarse_triangles) {
            // Cloth comes first in a scene.
            let Some(triangles) = triangles else { break };
            mesh.triangles = triangles;
        }
    }
}

impl Net {
    /// The springs between neighbors of a grid, or the edges of triangles; `None` of what is no cloth.
    fn of(worn: Worn<'_>) -> Option<Self> {
        let first = u32::try_from(worn.particles().start).ok()?;
        let (spacing, mut lines) = match worn {
            Worn::Gathered(garment) => {
                let grid = &garment.sewn.spec.grid;
                (grid.spacing[0].min(grid.spacing[1]), springs(grid))
            }
            Worn::Sewn(garment) => (0.0, edges(&garment.dressed.triangles)),
            Worn::Beside(_) => return None,
        };
        for [from, to, _] in &mut lines {
            *from += first;
            *to += first;
        }
        Some(Self { spacing, lines })
    }
}

/// The springs between neighbors, each with its row or column.
fn springs(grid: &Grid) -> Vec<[u32; 3]> {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "particles are counted in 32 bits"
    )]
    let at = |row: u32, column: u32| grid.index(row, column) as u32;
    let mut lines = Vec::new();
    for row in 0..grid.row_count {
        for column in 0..grid.column_count {
            if let Some(right) = grid.column_right(column, 1) {
                lines.push([at(row, column), at(row, right), row]);
            }
            if row + 1 < grid.row_count {
                lines.push([at(row, column), at(row + 1, column), column]);
            }
        }
    }
    lines
}

/// Every edge of triangles once.
fn edges(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let sides = sides.map(|[a, b]| [a.min(b), a.max(b), 0]);
    let once: BTreeSet<[u32; 3]> = sides.collect();
    once.into_iter().collect()
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
    /// The part of the choreography that is danced.
    pub part: Option<PartNow>,
    /// How long the recording is that is danced [s].
    pub recording_seconds: Option<f32>,
    /// Substeps of the next frame.
    pub substep_count: u32,
    /// Parts of the body beside which cloth has no room.
    pub without_room: Vec<Bone>,
    /// Where and when the cloth flew apart.
    pub stopped: Option<Divergence>,
}

impl Snapshot {
    /// One that shows a moment at a time of the dance [s] and says nothing else.
    pub(crate) fn showing(wardrobe: &Arc<Wardrobe>, moment: Moment, time: f32) -> Self {
        Self {
            wardrobe: Arc::clone(wardrobe),
            time,
            particles: Vec::new(),
            moment,
            capsules: Vec::new(),
            bones: Vec::new(),
            strain: Vec::new(),
            sunken: Vec::new(),
            samples: Vec::new(),
            pace: None,
            part: None,
            recording_seconds: None,
            substep_count: 0,
            without_room: Vec::new(),
            stopped: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use lole_cloth::Topology;

    use super::*;

    #[test]
    fn a_tube_has_a_spring_to_the_right_of_every_particle_and_below_all_but_the_last() {
        let grid = Grid {
            column_count: 8,
            row_count: 5,
            topology: Topology::Tube,
            spacing: [0.01, 0.01],
            flounce: None,
            crimp: None,
        };
        assert_eq!(springs(&grid).len(), 8 * 5 + 8 * 4);
        assert_eq!(edges(&[[0, 1, 2], [2, 1, 3]]).len(), 5);
    }
}
