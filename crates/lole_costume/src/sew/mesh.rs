//! The grid of a gathered garment as it is drawn.

use glam::{Vec2, Vec3};
use lole_cloth::Grid;
use lole_geom::mesh::vertex_normals;
use lole_pattern::design::pau_skirt::PauDraft;

use lole_print::PrintImage;

/// The drawn skirt: the particles' grid with the seam column twice, so that the print may differ on
/// the two sides of the seam, and the row twice to which a flounce is sewn.
#[derive(Debug, Clone, PartialEq)]
pub struct SkirtMesh {
    /// Particle behind each vertex, shape `[vertex_count]`.
    pub particles: Vec<u32>,
    /// Place of each vertex on the flat cloth [m]: `x` around the body, to the left as it is seen from
    /// outside, and `y` down from the top fold, in a flounce from its upper edge, shape
    /// `[vertex_count, 2]`.
    pub flat: Vec<Vec2>,
    /// Vertex indices, facing outward, shape `[triangle_count, 3]`.
    pub triangles: Vec<[u32; 3]>,
    /// The same triangles by particle, without the seam.
    pub particle_triangles: Vec<[u32; 3]>,
    /// First vertex of the flounce; all are before it where there is none.
    pub flounce_start: usize,
}

impl SkirtMesh {
    /// The mesh of a grid.
    #[must_use]
    pub fn new(grid: &Grid) -> Self {
        let mut mesh = Self {
            particles: Vec::new(),
            flat: Vec::new(),
            triangles: Vec::new(),
            particle_triangles: Vec::new(),
            flounce_start: 0,
        };
        let last = grid.row_count - 1;
        let seam = grid.flounce.map_or(last, |flounce| flounce.seam_row);
        mesh.add(grid, [0, seam]);
        mesh.flounce_start = mesh.particles.len();
        if seam < last {
            mesh.add(grid, [seam, last]);
        }
        mesh.particle_triangles = (mesh.triangles.iter())
            .map(|t| t.map(|i| mesh.particles[i as usize]))
            .collect();
        mesh
    }

    /// Adds the cloth from a row down to another.
    fn add(&mut self, grid: &Grid, [first, last]: [u32; 2]) {
        let columns = grid.cell_columns() + 1;
        let start = u32::try_from(self.particles.len()).unwrap_or(u32::MAX);
        let spacing = Vec2::new(grid.cloth_spacing(last), grid.spacing[1]);
        for row in first..=last {
            for column in 0..columns {
                (self.particles).push(row * grid.column_count + column % grid.column_count);
                let place = Vec2::new(column as f32, (row - first) as f32);
                self.flat.push(place * spacing);
            }
        }
        for row in first..last {
            for column in 0..grid.cell_columns() {
                let a = start + (row - first) * columns + column;
                let (b, c, d) = (a + 1, a + columns, a + columns + 1);
                // Alternating diagonals keep the drawing free of a bias direction.
                if (row + column) % 2 == 0 {
                    self.triangles.extend([[a, b, c], [b, d, c]]);
                } else {
                    self.triangles.extend([[a, b, d], [a, d, c]]);
                }
            }
        }
    }

    /// Where every vertex lies on a print, in repeats: what is cut by `draft`, and its `flounce`.
    #[must_use]
    pub fn on_print(
        &self,
        print: &PrintImage,
        draft: &PauDraft,
        flounce: Option<&PauDraft>,
    ) -> Vec<Vec2> {
        let parts = [draft, flounce.unwrap_or(draft)].map(|part| print.uv_from_panel(part));
        let flat = self.flat.iter().enumerate();
        flat.map(|(vertex, &at)| {
            parts[usize::from(self.flounce_start <= vertex)].transform_point2(at)
        })
        .collect()
    }

    /// The garment as it is drawn, its particles being at `particles` [m]: vertices [m] and their outward unit
    /// normals, shape `[vertex_count, 3]` both; the seam is smooth.
    ///
    /// # Panics
    /// When there are fewer particles than the mesh has.
    #[must_use]
    pub fn vertices(&self, particles: &[Vec3]) -> [Vec<Vec3>; 2] {
        let by_particle = vertex_normals(particles, &self.particle_triangles);
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        self.spread(particles, &mut positions);
        self.spread(&by_particle, &mut normals);
        [positions, normals]
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

#[cfg(test)]
mod tests {
    use lole_cloth::{Flounce, Topology};

    use super::*;

    #[test]
    fn a_flounce_begins_anew_on_its_own_cloth_and_hangs_on_the_same_particles() {
        let plain = Grid {
            column_count: 6,
            row_count: 5,
            topology: Topology::Tube,
            spacing: [0.01, 0.02],
            flounce: None,
            crimp: None,
        };
        let grid = Grid {
            flounce: Some(Flounce {
                seam_row: 2,
                fullness: 1.5,
            }),
            ..plain
        };
        let [without, with] = [plain, grid].map(|grid| SkirtMesh::new(&grid));
        assert_eq!(without.flounce_start, without.particles.len());
        // The row of the seam twice, and the seam's column twice in it.
        assert_eq!(with.particles.len(), without.particles.len() + 7);
        assert_eq!(with.flounce_start, 3 * 7);
        assert_eq!(with.particles[2 * 7..3 * 7], with.particles[3 * 7..4 * 7]);
        assert_eq!(with.flat[3 * 7], Vec2::ZERO);
        assert!(
            (with.flat[4 * 7 - 1].x - 0.09).abs() < 1e-6,
            "its own width"
        );
        assert!((with.flat.last().expect("vertices").y - 0.04).abs() < 1e-6);
        assert_eq!(with.particle_triangles, without.particle_triangles);
    }
}
