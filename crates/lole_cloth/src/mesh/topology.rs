//! What a list of triangles says about edges and neighbors, and what is wrong with it.

use std::collections::BTreeMap;

use glam::Vec2;

use crate::mesh::rest::{self, Welded};
use crate::mesh::spec::{MeshError, MeshSpec};

/// Below this share of its longest side a triangle's height is rounding.
const FLAT_SHARE: f32 = 1.0e-4;

/// Edges and neighbors of a checked mesh.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Topology {
    /// Counterclockwise in the flat piece.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Every edge once, its lower particle first, with the corners across it.
    pub(crate) edges: Vec<MeshEdge>,
    /// By particle, those it shares an edge with, ascending.
    pub(crate) neighbors: Vec<Vec<u32>>,
    /// By particle, a third of the area of its triangles [m²].
    pub(crate) areas: Vec<f32>,
}

/// An edge, and the corners of its one or two triangles that face it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeshEdge {
    pub(crate) ends: [u32; 2],
    pub(crate) opposite: [Option<u32>; 2],
}

impl Topology {
    /// Checks the mesh of `spec`, whose lengths fit.
    pub(crate) fn new(spec: &MeshSpec) -> Result<(Self, Option<Welded>), MeshError> {
        if spec.flat_corners.is_empty() {
            check_positions(spec)?;
            let triangles = oriented(spec)?;
            let flat = &spec.flat_positions;
            let area = |triangle: [u32; 3], _| doubled_area(flat, triangle);
            let topology = Self::of(flat.len(), triangles, area)?;
            return Ok((topology, None));
        }
        check_corners(spec)?;
        let (triangles, corners) = rest::oriented(spec)?;
        let area = |_, triangle: usize| {
            let [a, b, c] = corners[triangle];
            (b - a).perp_dot(c - a)
        };
        let topology = Self::of(spec.particle_count(), triangles, area)?;
        let welded = Welded::new(&topology, corners)?;
        Ok((topology, Some(welded)))
    }

    /// Edges and neighbors of triangles that are turned alike; `area` is twice that of each [m²].
    fn of(
        particle_count: usize,
        triangles: Vec<[u32; 3]>,
        area: impl Fn([u32; 3], usize) -> f32,
    ) -> Result<Self, MeshError> {
        let edges = edges(&triangles)?;
        let mut neighbors = vec![Vec::new(); particle_count];
        let mut border_counts = vec![0_u32; particle_count];
        for edge in &edges {
            let [a, b] = edge.ends;
            neighbors[a as usize].push(b);
            neighbors[b as usize].push(a);
            if edge.opposite[1].is_none() {
                border_counts[a as usize] += 1;
                border_counts[b as usize] += 1;
            }
        }
        if let Some(particle) = neighbors.iter().position(Vec::is_empty) {
            return Err(MeshError::ZeroMass { particle });
        }
        // Of one fan of triangles, a particle on the border has two border edges.
        if let Some(particle) = border_counts.iter().position(|&count| 2 < count) {
            return Err(MeshError::NonManifoldVertex { particle });
        }
        neighbors.iter_mut().for_each(|list| list.sort_unstable());
        let mut areas = vec![0.0; particle_count];
        for (index, triangle) in triangles.iter().enumerate() {
            let third = area(*triangle, index) / 6.0;
            for &particle in triangle {
                areas[particle as usize] += third;
            }
        }
        Ok(Self {
            triangles,
            edges,
            neighbors,
            areas,
        })
    }
}

/// Checks the triangles of a welded piece one by one.
fn check_corners(spec: &MeshSpec) -> Result<(), MeshError> {
    for (triangle, (particles, corners)) in
        (spec.triangles.iter().zip(&spec.flat_corners)).enumerate()
    {
        check_indices(triangle, particles, spec.particle_count())?;
        let [a, b, c] = *particles;
        if let Some(index) = [(a, b), (b, c), (c, a)]
            .iter()
            .find(|(one, other)| one == other)
        {
            return Err(MeshError::Repeated {
                triangle,
                index: index.0,
            });
        }
        if let Some(corner) = corners.iter().position(|corner| !corner.is_finite()) {
            return Err(MeshError::CornerNotFinite {
                triangle,
                corner,
                position: corners[corner],
            });
        }
        let [a, b, c] = *corners;
        check_height(triangle, *corners, (b - a).perp_dot(c - a))?;
    }
    Ok(())
}

fn check_indices(
    triangle: usize,
    particles: &[u32; 3],
    particle_count: usize,
) -> Result<(), MeshError> {
    match particles.iter().find(|&&p| particle_count <= p as usize) {
        Some(&index) => Err(MeshError::IndexOutOfRange {
            triangle,
            index,
            particle_count,
        }),
        None => Ok(()),
    }
}

fn check_height(triangle: usize, [a, b, c]: [Vec2; 3], area: f32) -> Result<(), MeshError> {
    let side = a.distance(b).max(b.distance(c)).max(c.distance(a));
    let height = if 0.0 < side { area.abs() / side } else { 0.0 };
    if FLAT_SHARE * side < height {
        return Ok(());
    }
    Err(MeshError::ZeroArea {
        triangle,
        side,
        height,
    })
}

fn check_positions(spec: &MeshSpec) -> Result<(), MeshError> {
    let mut positions = spec.flat_positions.iter().enumerate();
    match positions.find(|(_, position)| !position.is_finite()) {
        Some((particle, &position)) => Err(MeshError::NotFinite { particle, position }),
        None => Ok(()),
    }
}

/// Twice the area, positive counterclockwise [m²].
fn doubled_area(flat: &[Vec2], triangle: [u32; 3]) -> f32 {
    let [a, b, c] = triangle.map(|particle| flat[particle as usize]);
    (b - a).perp_dot(c - a)
}

/// The triangles, each turned counterclockwise.
fn oriented(spec: &MeshSpec) -> Result<Vec<[u32; 3]>, MeshError> {
    let particle_count = spec.flat_positions.len();
    let mut triangles = Vec::with_capacity(spec.triangles.len());
    for (index, &triangle) in spec.triangles.iter().enumerate() {
        check_indices(index, &triangle, particle_count)?;
        let area = doubled_area(&spec.flat_positions, triangle);
        let corners = triangle.map(|particle| spec.flat_positions[particle as usize]);
        check_height(index, corners, area)?;
        let [a, b, c] = triangle;
        triangles.push(if 0.0 < area { [a, b, c] } else { [a, c, b] });
    }
    Ok(triangles)
}

fn edges(triangles: &[[u32; 3]]) -> Result<Vec<MeshEdge>, MeshError> {
    // By edge, the corners across it and whether they walk it upwards.
    let mut sides: BTreeMap<[u32; 2], Vec<(u32, bool)>> = BTreeMap::new();
    for &[a, b, c] in triangles {
        for [from, to, across] in [[a, b, c], [b, c, a], [c, a, b]] {
            let edge = [from.min(to), from.max(to)];
            sides.entry(edge).or_default().push((across, from < to));
        }
    }
    let edges = sides.into_iter().map(|(ends, corners)| {
        let [first, second] = ends;
        match corners[..] {
            [(only, _)] => Ok(MeshEdge {
                ends,
                opposite: [Some(only), None],
            }),
            [(one, upward), (other, other_upward)] if upward != other_upward => Ok(MeshEdge {
                ends,
                opposite: [Some(one), Some(other)],
            }),
            [_, _] => Err(MeshError::FoldedOver { first, second }),
            _ => Err(MeshError::NonManifoldEdge {
                first,
                second,
                triangle_count: corners.len(),
            }),
        }
    });
    edges.collect()
}
