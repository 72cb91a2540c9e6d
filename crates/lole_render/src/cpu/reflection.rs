//! What a floor mirrors of the meshes: they are drawn from below the floor, a quarter as fine as the picture and a
//! little smeared, as in boards that are no mirror. Both backends lay it over the floor.

use super::raster;
use super::resolve::{self, Picture};
use super::tiles::{TILE, TileGrid};
use crate::bake::Bake;
use crate::frame::Frame;
use crate::prepare::Geometry;
use crate::srgb::SrgbTable;
use crate::{Background, Scene, Size, whole};
use glam::{Mat4, Vec2, Vec3, Vec4};
use rayon::prelude::*;

/// A side of a texel [pixel of the picture].
const COARSER: u32 = 4;
/// How much of the height of a picture the light of a place is smeared up and down.
const SMEAR: f32 = 0.016;

/// Light of the meshes in the floor, seen at the same places of the picture.
pub(crate) struct Reflection {
    /// Columns and rows.
    pub(crate) size: Size,
    /// Linear light times how much of the texel is covered, and how much that is, row by row.
    pub(crate) texels: Vec<Vec4>,
}

impl Reflection {
    /// That of a scene; `None` where the floor that meshes stand on mirrors nothing: what lies beyond the shore is too
    /// far for it.
    pub(crate) fn of(
        scene: &Scene<'_>,
        geometry: &Geometry,
        (bake, picture): (&Bake, &Frame),
        srgb: &SrgbTable,
    ) -> Option<Self> {
        let Background::Landscape(landscape) = &scene.background else {
            return None;
        };
        let ground = scene.ground.as_ref()?;
        if landscape.near.mirror <= 0.0
            || geometry.triangles.is_empty()
            || scene.camera.eye.y <= ground.height
        {
            return None;
        }
        let [across, down] = [picture.ray_right.w, picture.ray_down.w].map(|pixels| {
            u32::try_from(whole::index(pixels)).map_or(1, |pixels| pixels.div_ceil(COARSER))
        });
        let size = Size::new(across.max(1), down.max(1));
        let frame = picture.seen_from_below(ground.height, size);
        let corners = raster::screen_corners(geometry, &frame);
        let grid = TileGrid::new(size, geometry, &corners);
        let drawn = Picture::of(scene, (geometry, bake), (&frame, srgb), None);
        let tiles: Vec<Vec<Vec4>> = (0..grid.tile_count())
            .into_par_iter()
            .map(|tile| {
                let samples = raster::draw_tile(&grid, tile, geometry, &corners);
                resolve::tile_covered(&drawn, &grid, tile, &samples)
            })
            .collect();
        let (width, height) = (size.width as usize, size.height as usize);
        let texel = |x: usize, y: usize| {
            let tile = &tiles[y / TILE * grid.columns + x / TILE];
            tile[y % TILE * TILE + x % TILE]
        };
        // Drawn left for right, see `Frame::seen_from_below`.
        let texels = (0..height).flat_map(|y| (0..width).rev().map(move |x| (x, y)));
        let texels = texels.map(|(x, y)| texel(x, y)).collect();
        let sharp = Self { size, texels };
        Some(sharp.smeared())
    }

    /// Every texel the mean of those around it, by triangles: one beside it, and so many above and below.
    fn smeared(&self) -> Self {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let reach = whole::index((SMEAR * height as f32).ceil());
        let mean = |texels: &[Vec4], x: usize, y: usize, [wide, high]: [usize; 2]| {
            let (mut sum, mut total) = (Vec4::ZERO, 0.0);
            for row in y.saturating_sub(high)..=(y + high).min(height - 1) {
                for column in x.saturating_sub(wide)..=(x + wide).min(width - 1) {
                    let near = (1 + high - y.abs_diff(row)) * (1 + wide - x.abs_diff(column));
                    sum += texels[row * width + column] * near as f32;
                    total += near as f32;
                }
            }
            sum / total
        };
        let pass = |texels: &[Vec4], reach: [usize; 2]| -> Vec<Vec4> {
            let places = (0..texels.len()).into_par_iter();
            places
                .map(|at| mean(texels, at % width, at / width, reach))
                .collect()
        };
        let across = pass(&self.texels, [1, 0]);
        Self {
            size: self.size,
            texels: pass(&across, [0, reach]),
        }
    }

    /// At a place of the picture, both shares of its sides, bilinear.
    pub(crate) fn sample(&self, place: Vec2) -> Vec4 {
        let size = Vec2::new(self.size.width as f32, self.size.height as f32);
        let at = (place * size - 0.5).clamp(Vec2::ZERO, size - 1.0);
        let first = [whole::index(at.x), whole::index(at.y)];
        let part = at - Vec2::new(first[0] as f32, first[1] as f32);
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let texel = |x: usize, y: usize| self.texels[y.min(height - 1) * width + x.min(width - 1)];
        let row = |y: usize| texel(first[0], y).lerp(texel(first[0] + 1, y), part.x);
        row(first[1]).lerp(row(first[1] + 1), part.y)
    }
}

impl Frame {
    /// The same picture as a floor at a height [m] mirrors it, in other pixels. It is turned left for right, so that
    /// what is seen of a triangle stays the side that is.
    fn seen_from_below(&self, height: f32, size: Size) -> Self {
        let mirror = Mat4::from_translation(Vec3::Y * (2.0 * height))
            * Mat4::from_scale(Vec3::new(1.0, -1.0, 1.0));
        let turned = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
        let below = |ray: Vec4| Vec4::new(ray.x, -ray.y, ray.z, ray.w);
        let (width, rows) = (size.width as f32, size.height as f32);
        let across = below(self.ray_right) * (self.ray_right.w / width);
        let down = below(self.ray_down) * (self.ray_down.w / rows);
        let corner = below(self.ray_corner) + across * width;
        Self {
            clip_from_world: turned * self.clip_from_world * mirror,
            eye: Vec4::new(
                self.eye.x,
                2.0 * height - self.eye.y,
                self.eye.z,
                self.eye.w,
            ),
            ray_corner: corner.truncate().extend(self.ray_corner.w),
            ray_right: (-across).truncate().extend(width),
            ray_down: down.truncate().extend(rows),
            ..*self
        }
    }
}
