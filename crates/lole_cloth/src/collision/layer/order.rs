//! Two layers brought back into their order at the end of a step.

use glam::Vec3;
use lole_geom::triangle_grid::{blend, nearest_barycentric};

use super::points::PointGrid;
use super::shape::{LayerShape, write_normals};
use super::{LayerLaw, is_on_border};
use crate::{ClothModel, ClothState};

/// Sweeps over all contacts of two layers: a particle of one is a corner of the other's triangles.
const SWEEP_COUNT: usize = 4;

/// Particles that are nearer than this [m] to one of the other layer are looked at closely.
const NEAR: f32 = 0.014;

/// Every so manyth particle stands for the layer where nothing is near: a few centimeters away no
/// single fold counts.
const FAR_STRIDE: usize = 8;

/// Cosine of the angle from the outward normal within which what is seen from a particle lies
/// outside without doubt.
const CLEARLY_OUTSIDE: f32 = 0.7;

/// And how many gaps away it then is at least.
const CLEAR_GAPS: f32 = 3.0;

/// Times that the normals of a layer are evened out: over about half a gather's cloth to either side.
/// Outward is then away from the garment, not out of the nearest fold, and neighbors give way
/// together.
const EVEN_OUT_COUNT: u32 = 6;

/// Steps from a particle to the one next to it that lies nearer.
const DESCENT_LIMIT: u32 = 12;

/// One cloth among layers.
#[derive(Debug)]
pub struct LayerCloth<'a> {
    /// What never changes of it.
    pub model: &'a ClothModel,
    /// Where it is.
    pub state: &'a mut ClothState,
    /// Its triangles.
    pub shape: &'a LayerShape,
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

/// Keeps two layers in order, frame after frame. What it holds is room: every frame is looked at
/// anew, so that states say all there is to know.
#[derive(Debug, Clone, Default)]
pub struct LayerOrder {
    /// Of the inner and of the outer layer.
    rooms: [Room; 2],
}

/// What is read of one layer, and what is found for its particles.
#[derive(Debug, Clone, Default)]
struct Room {
    positions: Vec<Vec3>,
    starts: Vec<Vec3>,
    velocities: Vec<Vec3>,
    /// [1/kg]
    inv_masses: Vec<f32>,
    /// Of the particles, evened out.
    normals: Vec<Vec3>,
    sums: Vec<Vec3>,
    near: PointGrid,
    far: PointGrid,
    contacts: Vec<Contact>,
}

impl LayerOrder {
    /// Brings two layers that have moved on by `dt` [s] back into their order, and the outer one out
    /// of the body again where that pushed it into it. Call it after both have been stepped, from the
    /// innermost pair outwards.
    ///
    /// The inner layer leads and the outer one gives way: layers that both gave way would drag each
    /// other along wherever a fold of one lies in a fold of the other. What undoes an approach takes
    /// the outer layer's velocity too; layers that were in the wrong order part without a push.
    pub fn keep(
        &mut self,
        (inner, outer): (&LayerCloth<'_>, &mut LayerCloth<'_>),
        law: LayerLaw,
        dt: f32,
    ) {
        let [low, high] = &mut self.rooms;
        low.read(inner);
        high.read(outer);
        let (Some(first), Some(second)) = (low.bounds(), high.bounds()) else {
            return;
        };
        // Only what lies in the way of both can meet.
        let reach = law.reach;
        let common = [
            first[0].max(second[0]) - reach,
            first[1].min(second[1]) + reach,
        ];
        if !common[0].cmple(common[1]).all() {
            return;
        }
        rayon::join(
            || low.prepare(inner.shape, common, reach),
            || high.prepare(outer.shape, common, reach),
        );
        let shapes = [inner.shape, outer.shape];
        let (mut below, mut above) = (
            std::mem::take(&mut low.contacts),
            std::mem::take(&mut high.contacts),
        );
        let ((), ()) = rayon::join(
            || find([&*low, &*high], shapes[1], (-1.0, law, common), &mut below),
            || find([&*high, &*low], shapes[0], (1.0, law, common), &mut above),
        );
        low.inv_masses.fill(0.0);
        let mut sweep = |high: &mut Room| {
            above
                .iter()
                .for_each(|contact| part(contact, high, low, law.gap));
            below
                .iter()
                .for_each(|contact| part(contact, low, high, law.gap));
        };
        (0..SWEEP_COUNT).for_each(|_| sweep(high));
        high.leave_body(outer);
        sweep(high);
        (low.contacts, high.contacts) = (below, above);
        high.store(outer, law.parting_speed * dt);
    }
}

impl Room {
    fn read(&mut self, cloth: &LayerCloth<'_>) {
        let model = cloth.model;
        cloth.state.copy_positions(model, &mut self.positions);
        cloth.state.copy_velocities(model, &mut self.velocities);
        self.starts.clone_from(&self.positions);
        self.inv_masses.clear();
        let inv_mass = |particle: usize| {
            let (vector, lane) = model.layout.slot(particle);
            model.inv_masses[vector].0[lane]
        };
        self.inv_masses
            .extend((0..self.positions.len()).map(inv_mass));
    }

    /// Box around the layer; `None` where it holds a number that is not finite.
    fn bounds(&self) -> Option<[Vec3; 2]> {
        let mut bounds = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        for &position in &self.positions {
            if !position.is_finite() {
                return None;
            }
            bounds = [bounds[0].min(position), bounds[1].max(position)];
        }
        Some(bounds)
    }

    /// Normals, and what is looked for among the particles that lie between the corners of `common`.
    fn prepare(&mut self, shape: &LayerShape, common: [Vec3; 2], reach: f32) {
        write_normals(&shape.triangles, &self.positions, &mut self.normals);
        for _ in 0..EVEN_OUT_COUNT {
            even_out(&shape.triangles, &mut self.normals, &mut self.sums);
        }
        let numbered = (0_u32..).zip(self.positions.iter().copied());
        self.near.sort(numbered.clone(), common, NEAR);
        self.far.sort(numbered.step_by(FAR_STRIDE), common, reach);
    }

    /// Leaves the skin that the layer was pushed into since the step.
    fn leave_body(&mut self, cloth: &LayerCloth<'_>) {
        let skin = &cloth.state.scratch.surfel_contacts;
        if skin.is_empty() {
            return;
        }
        let layout = &cloth.model.layout;
        let moved = self.positions.iter_mut().zip(&self.starts).enumerate();
        for (particle, (position, start)) in moved {
            if position != start && 0.0 < self.inv_masses[particle] {
                *position = skin.outside(layout.slot(particle), *position);
            }
        }
    }

    /// Moves what was moved, at most by `share` [m].
    fn store(&self, cloth: &mut LayerCloth<'_>, share: f32) {
        let layout = &cloth.model.layout;
        let moved = self.starts.iter().zip(&self.positions).enumerate();
        for (particle, (&start, &position)) in moved {
            if start != position {
                let (vector, lane) = layout.slot(particle);
                let moved = (position - start).clamp_length_max(share);
                cloth.state.positions[vector].set(lane, start + moved);
                cloth.state.velocities[vector].set(lane, self.velocities[particle]);
            }
        }
    }

    /// The nearest particle to `point`, where the point may be in contact with the triangles around
    /// it: not where it lies outside without doubt.
    fn near_particle(
        &self,
        shape: &LayerShape,
        (point, hint): (Vec3, Option<u32>),
        (sign, law): (f32, LayerLaw),
    ) -> Option<u32> {
        let hint = hint.map(|number| (self.positions[number as usize], number));
        let near = self.near.nearest(point, NEAR, hint);
        let (mut particle, mut distance) = match near {
            Some(near) => near,
            None => self.far.nearest(point, law.reach, None)?,
        };
        let is_clear = |particle: u32, distance: f32| {
            let arm = point - self.positions[particle as usize];
            let height = sign * arm.dot(self.normals[particle as usize]);
            f32::max(CLEAR_GAPS * law.gap, CLEARLY_OUTSIDE * distance) < height
        };
        if is_clear(particle, distance) {
            return None;
        }
        if near.is_none() {
            for _ in 0..DESCENT_LIMIT {
                let (next, nearer) = self.nearest_around(shape, particle, point);
                if distance <= nearer {
                    break;
                }
                (particle, distance) = (next, nearer);
            }
        }
        Some(particle)
    }

    /// The nearest to `point` among the particles of the triangles around one, and its distance.
    fn nearest_around(&self, shape: &LayerShape, particle: u32, point: Vec3) -> (u32, f32) {
        let triangles = shape.around(particle).iter();
        let corners = triangles.flat_map(|&triangle| shape.triangles[triangle as usize]);
        corners.fold((particle, f32::INFINITY), |best, corner| {
            let distance = self.positions[corner as usize].distance(point);
            if distance < best.1 {
                (corner, distance)
            } else {
                best
            }
        })
    }

    /// The nearest point to `point` on the triangles around a particle: corners and their weights.
    fn foot(&self, shape: &LayerShape, particle: u32, point: Vec3) -> Option<([u32; 3], Vec3)> {
        let mut best = (f32::INFINITY, None);
        for &triangle in shape.around(particle) {
            let corners = shape.triangles[triangle as usize];
            let places = corners.map(|corner| self.positions[corner as usize]);
            let weights = nearest_barycentric(point, places);
            let distance = blend(places, weights).distance_squared(point);
            if distance < best.0 {
                best = (distance, Some((corners, weights)));
            }
        }
        best.1
    }
}

/// Gives every particle the mean direction of the triangles around it.
fn even_out(triangles: &[[u32; 3]], normals: &mut [Vec3], sums: &mut Vec<Vec3>) {
    sums.clear();
    sums.resize(normals.len(), Vec3::ZERO);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| normals[corner as usize]);
        for &corner in triangle {
            sums[corner as usize] += a + b + c;
        }
    }
    for (normal, sum) in normals.iter_mut().zip(sums) {
        *normal = sum.normalize_or_zero();
    }
}

/// Writes the contacts of the particles of the first layer with the triangles of the other, which
/// they must have `sign` outward of.
fn find(
    [own, other]: [&Room; 2],
    shape: &LayerShape,
    (sign, law, common): (f32, LayerLaw, [Vec3; 2]),
    contacts: &mut Vec<Contact>,
) {
    contacts.clear();
    let mut hint = None;
    for (particle, &point) in (0_u32..).zip(&own.positions) {
        if !(common[0].cmple(point).all() && point.cmple(common[1]).all()) {
            continue;
        }
        let near = other.near_particle(shape, (point, hint), (sign, law));
        hint = near.or(hint);
        let foot = near.and_then(|near| other.foot(shape, near, point));
        let Some((corners, weights)) = foot else {
            continue;
        };
        if is_on_border(&shape.is_border, corners, weights) {
            continue;
        }
        let normals = corners.map(|corner| other.normals[corner as usize]);
        let Some(normal) = blend(normals, weights).try_normalize() else {
            continue;
        };
        let places = corners.map(|corner| other.positions[corner as usize]);
        let arm = point - blend(places, weights);
        if sign * arm.dot(normal) < law.gap && arm.length_squared() < law.reach * law.reach {
            contacts.push(Contact {
                particle,
                corners,
                weights,
                normal: normal * sign,
            });
        }
    }
}

/// Moves a particle and a triangle apart until their distance along the normal is `gap` [m].
fn part(contact: &Contact, own: &mut Room, other: &mut Room, gap: f32) {
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
