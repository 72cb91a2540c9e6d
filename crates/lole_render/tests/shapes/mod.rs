//! Shapes and a material that pictures are tried with.

use glam::{Vec2, Vec3};
use lole_geom::trig;
use lole_render::{Material, SceneMesh};
use std::f32::consts::{PI, TAU};

/// Columns of a mesh, owned.
#[derive(Default)]
pub(crate) struct Shape {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) uvs: Vec<Vec2>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// Made of a material.
    pub(crate) fn with<'a>(&'a self, material: &'a Material) -> SceneMesh<'a> {
        SceneMesh {
            positions: &self.positions,
            normals: &[],
            uvs: &self.uvs,
            colors: &[],
            triangles: &self.triangles,
            material,
        }
    }
}

/// A ball.
pub(crate) fn sphere(center: Vec3, radius: f32) -> Shape {
    let mut shape = Shape::default();
    let (rings, columns) = (24_u16, 48_u16);
    for ring in 0..=rings {
        let polar = f32::from(ring) / f32::from(rings) * PI;
        for column in 0..columns {
            let around = f32::from(column) / f32::from(columns) * TAU;
            let outward = Vec3::new(
                trig::sin(polar) * trig::sin(around),
                trig::cos(polar),
                trig::sin(polar) * trig::cos(around),
            );
            shape.positions.push(center + outward * radius);
        }
    }
    let columns = u32::from(columns);
    for ring in 0..u32::from(rings) {
        for column in 0..columns {
            let next = (column + 1) % columns;
            let (top, below) = (ring * columns, (ring + 1) * columns);
            shape
                .triangles
                .push([top + column, below + column, top + next]);
            shape
                .triangles
                .push([top + next, below + column, below + next]);
        }
    }
    shape
}

pub(crate) fn matt(color: [f32; 3]) -> Material {
    Material {
        base_color: color,
        roughness: 1.0,
        specular: 0.0,
        ..Material::default()
    }
}
