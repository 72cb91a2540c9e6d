//! Layers of cloth whose order the garment knows: an underskirt stays under the skirt.
//!
//! What lies in another layer's way is not asked for but known, so contact is one-sided: a particle
//! of the outer layer stays on the outward side of the nearest triangle of the inner one, and a
//! particle of the inner layer on the inward side of the nearest triangle of the outer one. A start
//! in the wrong order comes right by itself, at a limited speed.

use glam::Vec3;
use lole_geom::triangle_grid::{Nearest, TriangleGrid, blend};

use crate::{ClothModel, ClothState};

/// Weight of a corner below which the nearest point lies on the opposite side of its triangle.
const ON_SIDE: f32 = 1.0e-4;

/// Cells of the search over the mean edge of a triangle, about.
const SEARCH_CELL: f32 = 2.0;

/// Sweeps over all contacts of two layers: a particle of one is a corner of the other's triangles.
const SWEEP_COUNT: usize = 4;

/// A surface with an inside and an outside.
#[derive(Debug, Clone, Copy)]
pub struct Layer<'a> {
    /// Corners, counterclockwise seen from the outside; shape `[triangle_count]`.
    pub triangles: &'a [[u32; 3]],
    /// Particles [m], shape `[particle_count]`.
    pub positions: &'a [Vec3],
}

/// How two layers meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerLaw {
    /// Distance kept between them [m].
    pub gap: f32,
    /// How far a particle may be on the wrong side and still be brought back [m]. More finds more,
    /// takes longer, and must stay below half of the way through the garment.
    pub reach: f32,
    /// Fastest that the layers are moved apart [m/s]; a slow push does not pop.
    pub parting_speed: f32,
}

/// Outward normals of a layer, found once for many questions.
pub struct Orientation<'a> {
    layer: Layer<'a>,
    search: TriangleGrid<'a>,
    /// Sum of the normals of the triangles around every particle, unit length or zero.
    normals: Vec<Vec3>,
    /// Particles on the border of the layer.
    is_border: Vec<bool>,
}

/// A point seen from a layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// The nearest triangle.
    pub triangle: u32,
    /// Weights of its corners at the nearest point.
    pub weights: Vec3,
    /// Outward unit vector there.
    pub normal: Vec3,
    /// Height above the nearest point along the normal [m]; negative inside.
    pub height: f32,
}

impl<'a> Orientation<'a> {
    /// Prepares `layer`, with a border where an edge belongs to one triangle alone.
    #[must_use]
    pub fn new(layer: Layer<'a>) -> Self {
        let mut normals = vec![Vec3::ZERO; layer.positions.len()];
        let mut sides = Vec::with_capacity(3 * layer.triangles.len());
        let (mut length, mut count) = (0.0, 0.0);
        for triangle in layer.triangles {
            let [a, b, c] = triangle.map(|corner| layer.positions[corner as usize]);
            let normal = (b - a).cross(c - a);
            length += a.distance(b);
            count += 1.0;
            for side in 0..3 {
                let (one, other) = (triangle[side], triangle[(side + 1) % 3]);
                normals[one as usize] += normal;
                sides.push([one.min(other), one.max(other)]);
            }
        }
        for normal in &mut normals {
            *normal = normal.normalize_or_zero();
        }
        sides.sort_unstable();
        let mut is_border = vec![false; layer.positions.len()];
        for alike in sides.chunk_by(|one, other| one == other) {
            if let [[one, other]] = alike {
                is_border[*one as usize] = true;
                is_border[*other as usize] = true;
            }
        }
        let cell = SEARCH_CELL * length / f32::max(count, 1.0);
        Self {
            layer,
            search: TriangleGrid::new(layer.positions, layer.triangles, cell.max(1.0e-4)),
            normals,
            is_border,
        }
    }

    /// The point of the layer nearest to `point` [m] within `reach` [m], and on which side of it the
    /// point lies. A point beyond the border of the layer is on neither side.
    #[must_use]
    pub fn sight(&self, point: Vec3, reach: f32) -> Option<Sight> {
        let nearest: Nearest = self.search.nearest(point, reach)?;
        let corners = self.layer.triangles[nearest.triangle as usize];
        let weights = nearest.barycentric;
        if self.is_on_border(corners, weights) {
            return None;
        }
        let normals = corners.map(|corner| self.normals[corner as usize]);
        let normal = blend(normals, weights).try_normalize()?;
        let height = (point - nearest.point).dot(normal);
        Some(Sight {
            triangle: nearest.triangle,
            weights,
            normal,
            height,
        })
    }

    /// Whether the nearest point lies on an edge or corner of the border.
    fn is_on_border(&self, corners: [u32; 3], weights: Vec3) -> bool {
        let weights = weights.to_array();
        let is_inner = weights.into_iter().all(|weight| ON_SIDE < weight);
        let mut counted = corners.into_iter().zip(weights);
        !is_inner
            && counted.all(|(corner, weight)| weight <= ON_SIDE || self.is_border[corner as usize])
    }
}

/// One cloth among layers.
#[derive(Debug)]
pub struct LayerCloth<'a> {
    /// What never changes of it.
    pub model: &'a ClothModel,
    /// Where it is.
    pub state: &'a mut ClothState,
    /// Its triangles, counterclockwise seen from the outside.
    pub triangles: &'a [[u32; 3]],
}

/// A particle of one layer and the triangle of the other that it must not pass.
#[derive(Debug, Clone, Copy)]
struct Contact {
    particle: u32,
    corners: [u32; 3],
    weights: Vec3,
    /// From the triangle to the side of the particle.
    normal: Vec3,
}

/// Brings two layers that have moved on by `dt` [s] back into their order, by the masses of what
/// meets. Call it after both have been stepped, from the innermost pair outwards.
///
/// What undoes an approach takes its velocity too; layers that were in the wrong order part without
/// a push.
pub fn keep_order<'a>(
    inner: &mut LayerCloth<'a>,
    outer: &mut LayerCloth<'a>,
    law: LayerLaw,
    dt: f32,
) {
    let mut sides = [inner, outer].map(Side::new);
    if !sides
        .iter()
        .all(|side| side.positions.iter().all(|p| p.is_finite()))
    {
        return;
    }
    let contacts = [
        find([&sides[1], &sides[0]], 1.0, law),
        find([&sides[0], &sides[1]], -1.0, law),
    ];
    let share = law.parting_speed * dt;
    let starts = sides.each_ref().map(|side| side.positions.clone());
    for _ in 0..SWEEP_COUNT {
        for (place, contacts) in contacts.iter().enumerate() {
            let [lower, upper] = &mut sides;
            let (own, other) = if place == 0 {
                (upper, lower)
            } else {
                (lower, upper)
            };
            for contact in contacts {
                part(contact, own, other, law.gap);
            }
        }
    }
    for (side, starts) in sides.iter_mut().zip(&starts) {
        side.store(starts, share);
    }
}

/// One of two layers while they are brought into order.
struct Side<'a, 'b> {
    cloth: &'a mut LayerCloth<'b>,
    positions: Vec<Vec3>,
    velocities: Vec<Vec3>,
    /// [1/kg], row-major.
    inv_masses: Vec<f32>,
}

impl<'a, 'b> Side<'a, 'b> {
    fn new(cloth: &'a mut LayerCloth<'b>) -> Self {
        let (mut positions, mut velocities) = (Vec::new(), Vec::new());
        cloth.state.copy_positions(cloth.model, &mut positions);
        cloth.state.copy_velocities(cloth.model, &mut velocities);
        let inv_mass = |particle: usize| {
            let (vector, lane) = cloth.model.layout.slot(particle);
            cloth.model.inv_masses[vector].0[lane]
        };
        let inv_masses = (0..positions.len()).map(inv_mass).collect();
        Self {
            cloth,
            positions,
            velocities,
            inv_masses,
        }
    }

    /// Moves what was moved since `starts`, at most by `share` [m].
    fn store(&mut self, starts: &[Vec3], share: f32) {
        let layout = &self.cloth.model.layout;
        for (particle, (&start, &position)) in starts.iter().zip(&self.positions).enumerate() {
            if start != position {
                let (vector, lane) = layout.slot(particle);
                let moved = (position - start).clamp_length_max(share);
                self.cloth.state.positions[vector].set(lane, start + moved);
                self.cloth.state.velocities[vector].set(lane, self.velocities[particle]);
            }
        }
    }
}

/// Contacts of the particles of the first side with the triangles of the other, which they must
/// have `sign` outward of.
fn find([own, other]: [&Side<'_, '_>; 2], sign: f32, law: LayerLaw) -> Vec<Contact> {
    let layer = Layer {
        triangles: other.cloth.triangles,
        positions: &other.positions,
    };
    let orientation = Orientation::new(layer);
    let contact = |(particle, &point): (u32, &Vec3)| {
        let sight = orientation.sight(point, law.reach)?;
        (sign * sight.height < law.gap).then(|| Contact {
            particle,
            corners: layer.triangles[sight.triangle as usize],
            weights: sight.weights,
            normal: sight.normal * sign,
        })
    };
    (0u32..).zip(&own.positions).filter_map(contact).collect()
}

/// Moves a particle and a triangle apart until their distance along the normal is `gap` [m].
fn part(contact: &Contact, own: &mut Side<'_, '_>, other: &mut Side<'_, '_>, gap: f32) {
    let particle = contact.particle as usize;
    let corners = contact.corners.map(|corner| corner as usize);
    let weights = contact.weights.to_array();
    let foot = blend(
        corners.map(|corner| other.positions[corner]),
        contact.weights,
    );
    let missing = gap - (own.positions[particle] - foot).dot(contact.normal);
    let mut inv_mass = own.inv_masses[particle];
    for (&corner, weight) in corners.iter().zip(weights) {
        inv_mass += weight * weight * other.inv_masses[corner];
    }
    if missing <= 0.0 || inv_mass <= 0.0 {
        return;
    }
    let flow = blend(
        corners.map(|corner| other.velocities[corner]),
        contact.weights,
    );
    let approach = (flow - own.velocities[particle])
        .dot(contact.normal)
        .max(0.0);
    let (push, stop) = (
        contact.normal * (missing / inv_mass),
        contact.normal * (approach / inv_mass),
    );
    own.positions[particle] += push * own.inv_masses[particle];
    own.velocities[particle] += stop * own.inv_masses[particle];
    for (&corner, weight) in corners.iter().zip(weights) {
        let share = weight * other.inv_masses[corner];
        other.positions[corner] -= push * share;
        other.velocities[corner] -= stop * share;
    }
}
