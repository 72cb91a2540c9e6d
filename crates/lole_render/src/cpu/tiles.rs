//! The picture in square tiles, each with the triangles that may show in it, in their order.

use super::raster::{Corner, screen_pieces};
use crate::prepare::Geometry;
use crate::{Sides, Size, whole};
use glam::Vec2;
use rayon::prelude::*;

/// Side of a tile [pixel]: its samples fit the cache nearest to a core.
pub(super) const TILE: usize = 32;
/// Triangles that are sorted into tiles together.
const CHUNK: usize = 4096;

/// Which triangles may show in which tile.
pub(super) struct TileGrid {
    /// Tiles in a row.
    pub(super) columns: usize,
    rows: usize,
    /// Start of each tile's triangles, and the end of the last's.
    starts: Vec<usize>,
    triangles: Vec<u32>,
}

impl TileGrid {
    pub(super) fn new(size: Size, geometry: &Geometry, corners: &[Corner]) -> Self {
        let columns = (size.width as usize).div_ceil(TILE);
        let rows = (size.height as usize).div_ceil(TILE);
        let chunks: Vec<Vec<(u32, u32)>> = geometry
            .triangles
            .par_chunks(CHUNK)
            .enumerate()
            .map(|(chunk, triangles)| {
                let mut entries = Vec::with_capacity(triangles.len() * 2);
                for (offset, _) in triangles.iter().enumerate() {
                    let triangle = index(chunk * CHUNK + offset);
                    let Some(seen) = seen_box(geometry, corners, triangle) else {
                        continue;
                    };
                    enter(&mut entries, [columns, rows], triangle, seen);
                }
                entries
            })
            .collect();
        let mut starts = vec![0; columns * rows + 1];
        for (tile, _) in chunks.iter().flatten() {
            starts[*tile as usize + 1] += 1;
        }
        for tile in 0..columns * rows {
            starts[tile + 1] += starts[tile];
        }
        let mut cursors = starts.clone();
        let mut triangles = vec![0; starts[columns * rows]];
        for &(tile, triangle) in chunks.iter().flatten() {
            let cursor = &mut cursors[tile as usize];
            triangles[*cursor] = triangle;
            *cursor += 1;
        }
        Self {
            columns,
            rows,
            starts,
            triangles,
        }
    }

    pub(super) const fn tile_count(&self) -> usize {
        self.columns * self.rows
    }

    /// Triangles that may show in a tile.
    pub(super) fn triangles(&self, tile: usize) -> &[u32] {
        &self.triangles[self.starts[tile]..self.starts[tile + 1]]
    }

    /// Top left corner of a tile [pixel].
    pub(super) fn origin(&self, tile: usize) -> Vec2 {
        let (column, row) = (tile % self.columns, tile / self.columns);
        Vec2::new((column * TILE) as f32, (row * TILE) as f32)
    }
}

/// Lowest and highest corner of what is seen of a triangle [pixel]; `None` where nothing is.
fn seen_box(geometry: &Geometry, corners: &[Corner], triangle: u32) -> Option<[Vec2; 2]> {
    let sides = geometry.parts[geometry.part_of(triangle)].sides;
    let points = geometry.triangles[triangle as usize].map(|vertex| corners[vertex as usize]);
    let mut low = Vec2::INFINITY;
    let mut high = Vec2::NEG_INFINITY;
    for piece in screen_pieces(points).as_slice() {
        if sides == Sides::Outward && super::raster::doubled_area(piece) <= 0.0 {
            continue;
        }
        for point in piece {
            low = low.min(point.at);
            high = high.max(point.at);
        }
    }
    if high.x < low.x {
        return None;
    }
    Some([low, high])
}

/// Enters a triangle into every tile that its box touches.
fn enter(
    entries: &mut Vec<(u32, u32)>,
    [columns, rows]: [usize; 2],
    triangle: u32,
    [low, high]: [Vec2; 2],
) {
    let picture = Vec2::new((columns * TILE) as f32, (rows * TILE) as f32);
    if high.cmplt(Vec2::ZERO).any() || low.cmpge(picture).any() {
        return;
    }
    let tile_of = |at: f32, count: usize| (whole::index(at) / TILE).min(count - 1);
    for row in tile_of(low.y, rows)..=tile_of(high.y, rows) {
        for column in tile_of(low.x, columns)..=tile_of(high.x, columns) {
            entries.push((index(row * columns + column), triangle));
        }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "tiles and triangles are counted in u32"
)]
const fn index(count: usize) -> u32 {
    count as u32
}
