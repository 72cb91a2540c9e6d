//! Light of the surroundings on each vertex: past the folds, the skirt and the body itself.
//!
//! Worked out by vertex, because it is smooth and meshes here are fine; a mesh of few large
//! triangles shows it coarsely.

use super::ground::GroundLight;
use super::studio::{Pair, Room};
use crate::depth_map::DepthMap;
use crate::prepare::Geometry;
use glam::Vec3;
use rayon::prelude::*;

/// Vertices that are worked on together, map by map.
const CHUNK: usize = 1024;
/// A point is lifted off its own surface by this many texels, so that it does not shade itself.
const LIFT_TEXELS: f32 = 1.3;
/// What is this close in front does not hide the light [m]: the surface itself, seen coarsely.
const SLACK: f32 = 0.002;

/// Light on the face and on the back of each vertex.
pub(super) fn by_vertex(
    geometry: &Geometry,
    room: &Room,
    ground: Option<&GroundLight>,
) -> Vec<[Vec3; 2]> {
    let mut ambient = vec![[Vec3::ZERO; 2]; geometry.positions.len()];
    ambient
        .par_chunks_mut(CHUNK)
        .enumerate()
        .for_each(|(chunk, lights)| {
            let start = chunk * CHUNK;
            for (pair, map) in room.pairs() {
                for (offset, light) in lights.iter_mut().enumerate() {
                    let position = geometry.positions[start + offset];
                    let normal = geometry.normals[start + offset];
                    let [up, down] = arriving(pair, map, position, normal);
                    let bounce = ground.map_or(Vec3::ONE, |ground| {
                        ground.factor_along(position, -pair.axis)
                    });
                    let cosine = normal.dot(pair.axis);
                    let (from_above, from_below) = (
                        pair.radiance[0] * (up * cosine.abs()),
                        pair.radiance[1] * bounce * (down * cosine.abs()),
                    );
                    // The face looks to +axis where the cosine is positive; the back then looks
                    // to -axis.
                    let (face, back) = if cosine >= 0.0 {
                        (from_above, from_below)
                    } else {
                        (from_below, from_above)
                    };
                    light[0] += face;
                    light[1] += back;
                }
            }
        });
    ambient
}

/// How much of the light from `+axis` and from `-axis` arrives at the side that looks there.
fn arriving(pair: &Pair, map: &DepthMap, position: Vec3, normal: Vec3) -> [f32; 2] {
    let outward = if normal.dot(pair.axis) >= 0.0 {
        normal
    } else {
        -normal
    };
    let lift = outward * (map.texel * LIFT_TEXELS);
    let slack = Vec3::new(0.0, 0.0, SLACK);
    [
        map.seen_from_front(map.project(position + lift) + slack),
        map.seen_from_behind(map.project(position - lift) - slack),
    ]
}
