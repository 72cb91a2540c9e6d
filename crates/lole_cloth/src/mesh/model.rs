//! A piece of cloth prepared for the real-time method: what never changes from step to step.

use glam::{Vec2, Vec3};

use crate::collision::face_contact::{FacePiece, Faces, FlatShape};
use crate::collision::placement::Placement;
use crate::collision::surface::Surface;
use crate::collision::surfel::room::{Anchor, Hanging};
use crate::lanes::{LANES, Points, Scalars};
use crate::mesh::build::{self, Shape, Stars};
use crate::mesh::order::Slots;
use crate::mesh::particles::column_length;
use crate::mesh::rest::{Rest, Welded};
use crate::mesh::spec::{MeshError, MeshSpec};
use crate::mesh::strain::StrainBatch;
use crate::mesh::tether::{Tethers, tether_passes};
use crate::mesh::topology::Topology;

/// A piece of cloth prepared for the real-time method.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshModel {
    spec: MeshSpec,
    topology: Topology,
    /// Of a piece that does not lie in a plane as a whole.
    welded: Option<Welded>,
    pin_indices: Vec<u32>,
    pub(crate) slots: Slots,
    /// [1/kg], by slot; 0 for pinned particles and slots of nothing.
    pub(crate) inv_masses: Vec<Scalars>,
    /// Every triangle, for sweeps after the first.
    pub(crate) triangles: Vec<StrainBatch>,
    /// Triangles that no star solves.
    pub(crate) other_triangles: Vec<StrainBatch>,
    pub(crate) stars: Stars,
    pub(crate) tethers: Vec<Tethers>,
    /// By particle, the nearest pin and the cloth between [m]; empty where nothing is pinned.
    nearest_pins: Vec<(u32, f32)>,
    /// How the piece meets itself.
    pub(crate) faces: Faces,
    /// What may cross itself.
    pub(crate) surface: Surface,
}

impl MeshModel {
    /// Prepares `spec`. Triangles may turn either way; they are all turned alike.
    ///
    /// # Errors
    /// When the mesh is empty, no surface or not flat, a particle would weigh nothing, or a number
    /// is not finite or out of range.
    pub fn new(spec: &MeshSpec) -> Result<Self, MeshError> {
        check_lengths(spec)?;
        check_numbers(spec)?;
        let (topology, welded) = Topology::new(spec)?;
        let rest = rest_of(spec, welded.as_ref());
        let shape = Shape {
            topology: &topology,
            rest,
        };
        let slots = match rest {
            Rest::Plane(flat) => Slots::new(flat, topology.areas.iter().sum()),
            Rest::Welded(_) => Slots::along(&topology),
        };
        let vector_count = slots.count / LANES;
        let mut inv_masses = vec![Scalars::default(); vector_count];
        let density = spec.fabric.areal_density;
        let particle_inv_mass = |particle: usize| {
            if spec.pinned[particle] {
                0.0
            } else {
                1.0 / (density * topology.areas[particle] * spec.layers[particle])
            }
        };
        for (particle, &slot) in slots.of_particle.iter().enumerate() {
            let (vector, lane) = (slot as usize / LANES, slot as usize % LANES);
            inv_masses[vector].0[lane] = particle_inv_mass(particle);
        }
        let pin_indices: Vec<u32> = (0_u32..)
            .zip(&spec.pinned)
            .filter(|(_, pinned)| **pinned)
            .map(|(particle, _)| particle)
            .collect();
        let tethers = tether_passes(shape, &pin_indices);
        let masses: Vec<f64> = (0..spec.pinned.len())
            .map(|p| f64::from(particle_inv_mass(p)))
            .collect();
        let parts = build::parts(spec, shape, (&slots, &masses))?;
        let mut model = Self {
            triangles: parts.triangles,
            other_triangles: parts.other_triangles,
            stars: parts.stars,
            tethers: tethers
                .iter()
                .map(|pass| Tethers::new(pass, &slots.of_particle, vector_count))
                .collect(),
            nearest_pins: nearest_pins(&tethers),
            faces: Faces::default(),
            surface: Surface::new(spec.pinned.len(), &side_by_side(&topology, &slots)),
            spec: spec.clone(),
            topology,
            welded,
            pin_indices,
            slots,
            inv_masses,
        };
        let faces = Faces::new(&[model.face_piece(Vec::new())]);
        model.faces = faces;
        Ok(model)
    }

    /// What contact must know of the piece.
    pub(crate) fn face_piece(&self, is_sewn: Vec<bool>) -> FacePiece<'_> {
        FacePiece {
            triangles: self.topology.triangles.clone(),
            flat_distance: Box::new(|ends| self.flat_distance(ends)),
            flat_positions: Some(match self.rest() {
                Rest::Plane(flat) => FlatShape::Plane(flat),
                Rest::Welded(welded) => FlatShape::Near(&welded.near),
            }),
            placement: &self.slots,
            inv_masses: &self.inv_masses,
            pins: self.nearest_pins.clone(),
            is_sewn,
            particle_count: self.particle_count(),
        }
    }

    /// What the piece was made from.
    #[must_use]
    pub const fn spec(&self) -> &MeshSpec {
        &self.spec
    }

    /// How far two particles lie apart in the flat piece [m]; of pieces that are welded, how far it is
    /// from one to the other on the cloth, and infinite where no way leads there.
    #[must_use]
    pub fn flat_distance(&self, ends: [u32; 2]) -> f32 {
        self.rest().distance(&self.topology, ends)
    }

    /// The corners of one of the triangles as it lies flat [m], counterclockwise, warp along `x`.
    #[must_use]
    pub fn flat_corners(&self, triangle: usize) -> [Vec2; 3] {
        match self.rest() {
            Rest::Plane(flat) => {
                self.topology.triangles[triangle].map(|particle| flat[particle as usize])
            }
            Rest::Welded(welded) => welded.corners[triangle],
        }
    }

    /// How the piece lies flat.
    pub(crate) fn rest(&self) -> Rest<'_> {
        rest_of(&self.spec, self.welded.as_ref())
    }

    /// The triangles, all turned counterclockwise in the flat piece; of pieces that are welded, turned
    /// like the first of what hangs together.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.topology.triangles
    }

    /// Indices of the pinned particles, ascending.
    #[must_use]
    pub fn pin_indices(&self) -> &[u32] {
        &self.pin_indices
    }

    /// Number of particles.
    #[must_use]
    pub const fn particle_count(&self) -> usize {
        self.slots.of_particle.len()
    }

    /// Mass of every particle [kg], shape `[particle_count]`.
    #[must_use]
    pub fn particle_masses(&self) -> Vec<f32> {
        let density = self.spec.fabric.areal_density;
        let shares = self.topology.areas.iter().zip(&self.spec.layers);
        shares
            .map(|(area, layers)| density * area * layers)
            .collect()
    }

    /// Edges and neighbors.
    pub(crate) const fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Root of the area that a particle has [m]: the spacing of a square grid as fine.
    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    pub(crate) fn spacing(&self) -> f32 {
        let area: f32 = self.topology.areas.iter().sum();
        (area / self.topology.areas.len() as f32).sqrt()
    }

    /// About how far the cloth reaches [m]: from what is farthest from its first particle to what is
    /// farthest from there, of what hangs together with it.
    pub(crate) fn longest_way(&self) -> f32 {
        let farthest = |from: u32| {
            let ways = self.rest().ways_from(&self.topology, from);
            let reached = (0_u32..).zip(ways).filter(|(_, way)| way.is_finite());
            reached.fold(
                (from, 0.0),
                |most, it| if most.1 < it.1 { it } else { most },
            )
        };
        farthest(farthest(0).0).1
    }

    /// Numbers in a column of particles.
    pub(crate) const fn column_length(&self) -> usize {
        column_length(self.slots.count)
    }

    /// Vectors of sixteen slots.
    pub(crate) const fn vector_count(&self) -> usize {
        self.inv_masses.len()
    }

    /// Brings points by particle into slots; slots of nothing hold the first.
    pub(crate) fn scatter_points(&self, points: &[Vec3], filler: Vec3, vectors: &mut [Points]) {
        for vector in vectors.iter_mut() {
            for lane in 0..LANES {
                vector.set(lane, filler);
            }
        }
        for (&point, &slot) in points.iter().zip(&self.slots.of_particle) {
            vectors[slot as usize / LANES].set(slot as usize % LANES, point);
        }
    }
}

impl Hanging for MeshModel {
    fn anchor(&self, slot: (usize, usize)) -> Option<Anchor> {
        let particle = self.slots.particle_at(slot)?;
        let &(pin, length) = self.nearest_pins.get(particle)?;
        let pin = self.slots.slot(pin as usize);
        length.is_finite().then_some(Anchor {
            pins: [pin; 2],
            share: 0.0,
            length,
        })
    }

    fn stretch_at(&self, positions: &[Points], slot: (usize, usize)) -> f32 {
        let Some(particle) = self.slots.particle_at(slot) else {
            return 0.0;
        };
        let at = |particle: usize| {
            let (vector, lane) = self.slots.slot(particle);
            positions[vector].get(lane)
        };
        let length = |place: usize, other: u32| match self.rest() {
            Rest::Plane(flat) => flat[particle].distance(flat[other as usize]),
            Rest::Welded(welded) => welded.lengths[particle][place],
        };
        let neighbors = self.topology.neighbors[particle].iter().enumerate();
        let stretch = |(place, &other): (usize, &u32)| {
            at(particle).distance(at(other as usize)) / length(place, other) - 1.0
        };
        neighbors.map(stretch).fold(0.0, f32::max)
    }
}

fn rest_of<'a>(spec: &'a MeshSpec, welded: Option<&'a Welded>) -> Rest<'a> {
    welded.map_or(Rest::Plane(&spec.flat_positions), Rest::Welded)
}

/// By particle, the pin that is nearest of all passes.
fn nearest_pins(passes: &[Vec<(u32, f32)>]) -> Vec<(u32, f32)> {
    let Some((first, others)) = passes.split_first() else {
        return Vec::new();
    };
    let mut nearest = first.clone();
    for pass in others {
        for (least, &other) in nearest.iter_mut().zip(pass) {
            if other.1 < least.1 {
                *least = other;
            }
        }
    }
    nearest
}

fn check_lengths(spec: &MeshSpec) -> Result<(), MeshError> {
    let particle_count = spec.particle_count();
    if particle_count == 0 || spec.triangles.is_empty() {
        return Err(MeshError::Empty {
            particle_count,
            triangle_count: spec.triangles.len(),
        });
    }
    if (u32::MAX / 2) as usize <= particle_count {
        return Err(MeshError::TooLarge { particle_count });
    }
    let mut lengths = vec![
        ("layers", spec.layers.len(), particle_count),
        ("pinned", spec.pinned.len(), particle_count),
    ];
    if !spec.bent_positions.is_empty() {
        lengths.push(("bent_positions", spec.bent_positions.len(), particle_count));
    }
    if !spec.flat_corners.is_empty() {
        lengths.push((
            "flat_corners",
            spec.flat_corners.len(),
            spec.triangles.len(),
        ));
        lengths.push(("flat_positions", spec.flat_positions.len(), 0));
    }
    match lengths
        .into_iter()
        .find(|&(_, actual, expected)| actual != expected)
    {
        Some((field, actual, expected)) => Err(MeshError::WrongLength {
            field,
            actual,
            expected,
        }),
        None => Ok(()),
    }
}

/// A field of the fabric, its value, its range, and the range in words.
type Rule = (&'static str, f32, [f32; 2], &'static str);

fn check_numbers(spec: &MeshSpec) -> Result<(), MeshError> {
    let mut bent = spec.bent_positions.iter().enumerate();
    if let Some((particle, &position)) = bent.find(|(_, position)| !position.is_finite()) {
        return Err(MeshError::BentNotFinite { particle, position });
    }
    let fabric = &spec.fabric;
    // The thinnest silk weighs 8 g/m², a rubber mat 10 kg/m²; a foil of steel 1 mm thick has
    // 2e8 N/m and bends with 18 N·m.
    const WEIGHT: &str = "between 1e-4 and 100 kg/m²";
    const STRETCH: &str = "between 1 and 1e9 N/m";
    const SHEAR: &str = "between 0 and 1e9 N/m";
    const BEND: &str = "between 0 and 100 N·m";
    const PLAIN: &str = "between 0 and 1000";
    let rules: [Rule; 9] = [
        (
            "fabric.areal_density",
            fabric.areal_density,
            [1e-4, 100.0],
            WEIGHT,
        ),
        ("fabric.stretch", fabric.stretch[0], [1.0, 1e9], STRETCH),
        ("fabric.stretch", fabric.stretch[1], [1.0, 1e9], STRETCH),
        ("fabric.shear", fabric.shear, [0.0, 1e9], SHEAR),
        ("fabric.bend", fabric.bend[0], [0.0, 100.0], BEND),
        ("fabric.bend", fabric.bend[1], [0.0, 100.0], BEND),
        ("fabric.twist", fabric.twist, [0.0, 100.0], BEND),
        ("fabric.friction", fabric.friction, [0.0, 1000.0], PLAIN),
        ("fabric.drag_rate", fabric.drag_rate, [0.0, 1000.0], PLAIN),
    ];
    let layers = spec.layers.iter().map(|&layers| {
        let rule: Rule = ("layers", layers, [1e-3, 1000.0], "between 0.001 and 1000");
        rule
    });
    for (field, value, [low, high], rule) in rules.into_iter().chain(layers) {
        if !(low <= value && value <= high) {
            return Err(MeshError::OutOfRange { field, value, rule });
        }
    }
    Ok(())
}

/// The triangles in the order in which their corners stand in memory, which is by patches.
fn side_by_side(topology: &Topology, slots: &Slots) -> Vec<[u32; 3]> {
    let mut triangles = topology.triangles.clone();
    let slot = |corner: u32| slots.of_particle[corner as usize];
    triangles.sort_by_key(|triangle| triangle.map(slot).into_iter().min());
    triangles
}
