//! The vertices and triangles of a grid of particles, thinned for a file.

use glam::{Affine2, Vec2, Vec3};

/// Whether the last column of a grid is sewn to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GridRing {
    /// Four free edges.
    Open,
    /// The last column is followed by the first.
    Closed,
}

/// A grid of particles, row by row from the top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridSheet {
    /// Particles in a row, at least 2 (3 when closed).
    pub column_count: u32,
    /// Rows, at least 2.
    pub row_count: u32,
    /// Rows of particles above the first of these.
    pub rows_above: u32,
    /// How the first and last column meet.
    pub ring: GridRing,
    /// Flat distance between neighbors along a row and down a column [m].
    pub spacing: [f32; 2],
    /// From the flat sheet [m], columns to the right and rows down, to the print in repeats, v down.
    pub uv_from_flat: Affine2,
}

/// Which particles are vertices of a file, and how they are joined.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GridMesh {
    /// Particle of each vertex.
    pub particles: Vec<u32>,
    /// Texture coordinates of each vertex, in print repeats, v down.
    pub uvs: Vec<Vec2>,
    /// Vertex indices.
    pub triangles: Vec<[u32; 3]>,
}

impl GridMesh {
    /// Every `strides`-th column and row of a grid, the last row always kept, and the last column
    /// of an open one. A closed grid repeats its first column at the end, for the texture.
    ///
    /// Triangles wind counter-clockwise for an eye that sees columns run right and rows run down.
    #[must_use]
    pub fn new(sheet: &GridSheet, strides: [u32; 2]) -> Self {
        let mut columns = thinned(sheet.column_count, strides[0]);
        match sheet.ring {
            GridRing::Open => keep_last(&mut columns, sheet.column_count),
            GridRing::Closed => columns.push(sheet.column_count),
        }
        let mut rows = thinned(sheet.row_count, strides[1]);
        keep_last(&mut rows, sheet.row_count);
        let mut mesh = Self::default();
        for row in &rows {
            for column in &columns {
                mesh.particles.push(
                    (sheet.rows_above + row) * sheet.column_count + column % sheet.column_count,
                );
                let flat = Vec2::new(count(*column), count(*row)) * Vec2::from(sheet.spacing);
                mesh.uvs.push(sheet.uv_from_flat.transform_point2(flat));
            }
        }
        let (width, height) = (columns.len(), rows.len());
        for row in 0..height.saturating_sub(1) {
            for column in 0..width.saturating_sub(1) {
                let corner = row * width + column;
                let [a, b, c, d] = [corner, corner + 1, corner + width, corner + width + 1]
                    .map(|index| u32::try_from(index).unwrap_or(u32::MAX));
                mesh.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
        mesh
    }

    /// Adds another mesh of the same particles.
    #[must_use]
    pub fn with(mut self, other: &Self) -> Self {
        let first = u32::try_from(self.particles.len()).unwrap_or(u32::MAX);
        self.particles.extend(&other.particles);
        self.uvs.extend(&other.uvs);
        let triangles = other.triangles.iter();
        (self.triangles).extend(triangles.map(|corners| corners.map(|corner| first + corner)));
        self
    }

    /// Turns all triangles over if they face, on the whole, towards the vertical line through the
    /// middle of `particles` [m]: a skirt's outside is then its front.
    #[must_use]
    pub fn facing_outward(mut self, particles: &[Vec3]) -> Self {
        let count = particles.len().max(1);
        #[expect(clippy::cast_precision_loss, reason = "far fewer than 2^24 particles")]
        let middle = particles.iter().copied().sum::<Vec3>() / count as f32;
        let point = |vertex: u32| {
            let particle = self
                .particles
                .get(vertex as usize)
                .copied()
                .unwrap_or(u32::MAX);
            particles.get(particle as usize).copied().unwrap_or(middle)
        };
        let outward: f32 = self
            .triangles
            .iter()
            .map(|triangle| {
                let [a, b, c] = triangle.map(point);
                let away = ((a + b + c) / 3.0 - middle).with_y(0.0);
                (b - a).cross(c - a).dot(away)
            })
            .sum();
        if outward < 0.0 {
            for triangle in &mut self.triangles {
                triangle.swap(1, 2);
            }
        }
        self
    }
}

/// Every `stride`-th of `count` indices.
fn thinned(count: u32, stride: u32) -> Vec<u32> {
    (0..count).step_by(stride.max(1) as usize).collect()
}

/// Adds the last of `count` indices where it was passed over.
fn keep_last(indices: &mut Vec<u32>, count: u32) {
    if let Some(last) = count.checked_sub(1)
        && indices.last() != Some(&last)
    {
        indices.push(last);
    }
}

/// A grid index as a number.
#[expect(
    clippy::cast_precision_loss,
    reason = "grids have far fewer than 2^24 columns"
)]
fn count(index: u32) -> f32 {
    index as f32
}
