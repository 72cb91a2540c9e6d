//! The rasterizer for machines without a graphics adapter: four samples a pixel for edges, one
//! shading for each triangle in a pixel, tiles in parallel, the same bits on any number of threads.
//!
//! A ready-made software rasterizer was looked at first: `euc` 0.5.3, the newest release in its
//! registry, has neither multisampling nor threads, and the shadow maps here, seen from both ends
//! of an axis at once, would have needed a rasterizer of their own beside it.

mod raster;
pub(crate) mod reflection;
mod resolve;
mod tiles;

use crate::bake::Bake;
use crate::frame::Frame;
use crate::prepare::Geometry;
use crate::renderer::RoomLight;
use crate::srgb::SrgbTable;
use crate::surroundings::Paints;
use crate::{Image, Scene, Size};
use rayon::prelude::*;
use reflection::Reflection;
use resolve::Picture;
use tiles::{TILE, TileGrid};

/// What is kept from picture to picture.
pub(crate) struct CpuRenderer {
    srgb: SrgbTable,
    /// The light of the picture before.
    bake: Option<Bake>,
}

impl CpuRenderer {
    pub(crate) fn new() -> Self {
        Self {
            srgb: SrgbTable::new(),
            bake: None,
        }
    }

    /// Draws a checked scene.
    pub(crate) fn render(&mut self, scene: &Scene<'_>, size: Size, light: RoomLight) -> Image {
        let geometry = Geometry::of(scene);
        let before = self.bake.take().filter(|_| light == RoomLight::AsBefore);
        let bake = Bake::lit(scene, &geometry, before);
        let frame = Frame::new(scene, size, &bake);
        let reflection = Reflection::of(scene, &geometry, (&bake, &frame), &self.srgb);
        let corners = raster::screen_corners(&geometry, &frame);
        let grid = TileGrid::new(size, &geometry, &corners);
        let lit = (&geometry, &bake);
        let paints = Paints::of(&scene.background, &self.srgb, reflection.as_ref());
        let picture = Picture::of(scene, lit, (&frame, &self.srgb), paints);
        let tiles: Vec<Vec<u8>> = (0..grid.tile_count())
            .into_par_iter()
            .map(|tile| {
                let samples = raster::draw_tile(&grid, tile, &geometry, &corners);
                resolve::tile_pixels(&picture, &grid, tile, &samples)
            })
            .collect();
        let image = assemble(size, &grid, &tiles);
        self.bake = Some(bake);
        image
    }
}

/// Puts the tiles side by side.
fn assemble(size: Size, grid: &TileGrid, tiles: &[Vec<u8>]) -> Image {
    let row_bytes = size.width as usize * 4;
    let mut pixels = vec![0; size.pixel_count() * 4];
    pixels
        .par_chunks_mut(row_bytes)
        .enumerate()
        .for_each(|(y, row)| {
            for (column, part) in row.chunks_mut(TILE * 4).enumerate() {
                let tile = &tiles[y / TILE * grid.columns + column];
                let start = (y % TILE) * TILE * 4;
                part.copy_from_slice(&tile[start..start + part.len()]);
            }
        });
    Image {
        width: size.width,
        height: size.height,
        pixels,
    }
}
