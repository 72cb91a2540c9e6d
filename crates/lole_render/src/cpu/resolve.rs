//! From samples to pixels: each triangle that a pixel shows is shaded once and counts by its
//! samples.

use super::raster::{NOTHING, SAMPLE_X, SAMPLE_Y, Samples};
use super::tiles::{TILE, TileGrid};
use crate::Scene;
use crate::bake::Bake;
use crate::frame::Frame;
use crate::prepare::Geometry;
use crate::shade::{self, KeyShadow, Point, SOFTEST_DISTANCE, Surface};
use crate::srgb::SrgbTable;
use crate::surroundings::{self, Paints};
use glam::{Vec2, Vec3, Vec4};

/// Everything that pixels are made of.
pub(super) struct Picture<'a> {
    pub(super) scene: &'a Scene<'a>,
    pub(super) geometry: &'a Geometry,
    pub(super) bake: &'a Bake,
    pub(super) frame: &'a Frame,
    pub(super) srgb: &'a SrgbTable,
    pub(super) surfaces: Vec<Surface>,
    pub(super) shadow: KeyShadow<'a>,
    /// What a landscape is painted with; `None` where there is none.
    pub(super) paints: Option<Paints<'a>>,
}

impl<'a> Picture<'a> {
    pub(super) fn of(
        scene: &'a Scene<'a>,
        (geometry, bake): (&'a Geometry, &'a Bake),
        (frame, srgb): (&'a Frame, &'a SrgbTable),
        paints: Option<Paints<'a>>,
    ) -> Self {
        let materials = scene.meshes.iter().map(|mesh| mesh.material);
        Self {
            scene,
            geometry,
            bake,
            frame,
            srgb,
            surfaces: materials.map(Surface::of).collect(),
            shadow: KeyShadow {
                map: &bake.key_map,
                clear_above: &bake.key_clear,
                tangent: frame.key_toward.w,
                softest: SOFTEST_DISTANCE,
            },
            paints,
        }
    }
}

/// RGBA of the pixels of a tile, row by row.
pub(super) fn tile_pixels(
    picture: &Picture<'_>,
    grid: &TileGrid,
    tile: usize,
    samples: &Samples,
) -> Vec<u8> {
    let origin = grid.origin(tile);
    let mut bytes = Vec::with_capacity(TILE * TILE * 4);
    for (index, seen) in samples.triangles.iter().enumerate() {
        let corner = origin + Vec2::new((index % TILE) as f32, (index / TILE) as f32);
        let color = pixel_color(picture, corner, seen);
        bytes.extend(picture.srgb.encode(color));
        bytes.push(255);
    }
    bytes
}

/// Light of the meshes in the texels of a tile, times how much of each is covered, and how much that is.
pub(super) fn tile_covered(
    picture: &Picture<'_>,
    grid: &TileGrid,
    tile: usize,
    samples: &Samples,
) -> Vec<Vec4> {
    let origin = grid.origin(tile);
    let texels = samples.triangles.iter().enumerate();
    let covered = texels.map(|(index, seen)| {
        let corner = origin + Vec2::new((index % TILE) as f32, (index / TILE) as f32);
        let mut sum = Vec4::ZERO;
        for (triangle, place, count) in shown(seen) {
            if triangle != NOTHING {
                let color = surface_color(picture, triangle, corner + place);
                sum += color.extend(1.0) * (count * 0.25);
            }
        }
        sum
    });
    covered.collect()
}

/// What a pixel shows: each triangle, or [`NOTHING`], with the mean place and the number of its samples.
fn shown(seen: &[u32; 4]) -> impl Iterator<Item = (u32, Vec2, f32)> {
    let first = |&(sample, triangle): &(usize, &u32)| !seen[..sample].contains(triangle);
    (seen.iter().enumerate())
        .filter(first)
        .map(|(_, &triangle)| {
            let mut place = Vec2::ZERO;
            let mut count = 0.0;
            for (other, _) in seen.iter().enumerate().filter(|(_, t)| **t == triangle) {
                place += Vec2::new(SAMPLE_X[other], SAMPLE_Y[other]);
                count += 1.0;
            }
            (triangle, place / count, count)
        })
}

/// Mean of the four samples of the pixel with top left corner `corner`.
fn pixel_color(picture: &Picture<'_>, corner: Vec2, seen: &[u32; 4]) -> Vec3 {
    let mut color = Vec3::ZERO;
    for (triangle, place, count) in shown(seen) {
        let share = if triangle == NOTHING {
            let middle = corner + 0.5;
            let hit = surroundings::floor_hit(picture.frame, middle);
            let ground = match &picture.bake.ground {
                Some(light) if hit.z > 0.0 => light.factor_at(hit.x, hit.y),
                _ => Vec3::ONE,
            };
            surroundings::background(picture.frame, picture.paints.as_ref(), middle, ground)
        } else {
            surface_color(picture, triangle, corner + place)
        };
        color += share * (count * 0.25);
    }
    color
}

/// Color of a triangle where the ray through a place of the picture meets it.
fn surface_color(picture: &Picture<'_>, triangle: u32, pixel: Vec2) -> Vec3 {
    let (geometry, frame) = (picture.geometry, picture.frame);
    let part = geometry.part_of(triangle);
    let surface = &picture.surfaces[part];
    let corners = geometry.triangles[triangle as usize].map(|vertex| vertex as usize);
    let eye = frame.eye.truncate();
    let [a, b, c] = corners.map(|vertex| geometry.positions[vertex] - eye);
    // Volumes between the ray and two corners: in the proportion of the third corner's weight.
    let volumes = [b.cross(c), c.cross(a), a.cross(b)];
    let weights_along = |ray: Vec3| {
        let parts = Vec3::new(
            ray.dot(volumes[0]),
            ray.dot(volumes[1]),
            ray.dot(volumes[2]),
        );
        let sum = parts.element_sum();
        if sum == 0.0 {
            Vec3::splat(1.0 / 3.0)
        } else {
            parts / sum
        }
    };
    let ray = frame.ray(pixel);
    let weights = weights_along(ray);
    // The face is seen where the triangle winds counter-clockwise, against the ray.
    let is_face = ray.dot(volumes[0] + volumes[1] + volumes[2]) <= 0.0;
    let position = mix(corners, weights, |vertex| geometry.positions[vertex]);
    let normal = mix(corners, weights, |vertex| geometry.normals[vertex]);
    let [face_light, back_light] =
        [0, 1].map(|side| mix(corners, weights, |v| picture.bake.ambient[v][side]).max(Vec3::ZERO));
    let mut paint = mix(corners, weights, |vertex| geometry.colors[vertex]);
    if let Some(texture) = &picture.scene.meshes[part].material.texture {
        let uv_along = |weights: Vec3| {
            geometry.uvs[corners[0]] * weights.x
                + geometry.uvs[corners[1]] * weights.y
                + geometry.uvs[corners[2]] * weights.z
        };
        let uv = uv_along(weights);
        let texels = Vec2::new(texture.width() as f32, texture.height() as f32);
        let change = |step: Vec3| (uv_along(weights_along(ray + step)) - uv) * texels;
        let lod = shade::texture_lod(
            change(frame.ray_right.truncate()),
            change(frame.ray_down.truncate()),
        );
        paint *= texture.sample(picture.srgb, uv, lod);
    }
    let facing = if is_face { 1.0 } else { -1.0 };
    let seen_normal = normal.normalize_or(-ray * facing) * facing;
    let point = Point {
        position,
        normal: seen_normal.normalize_or(-ray),
        albedo: shade::albedo(surface, paint, if is_face { 1.0 } else { 0.0 }),
        ambient: if is_face {
            [face_light, back_light]
        } else {
            [back_light, face_light]
        },
    };
    shade::shade(frame, picture.shadow, surface, &point)
}

fn mix(corners: [usize; 3], weights: Vec3, column: impl Fn(usize) -> Vec3) -> Vec3 {
    column(corners[0]) * weights.x + column(corners[1]) * weights.y + column(corners[2]) * weights.z
}
