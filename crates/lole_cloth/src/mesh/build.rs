//! Constraints of a piece in the engine's own order: triangles, stars, and which star solves which
//! triangles.

use glam::{DMat2, DVec2, DVec3};

use lole_geom::narrow as narrow_float;

use crate::Fabric;
use crate::lanes::narrow;
use crate::mesh::bend::fit::{Star, measures};
use crate::mesh::bend::{BentBatch, Curve, STAR_SIZES, StarBatch, StarSpec};
use crate::mesh::order::{Batch, Slots, into_batches};
use crate::mesh::rest::{Fan, Rest};
use crate::mesh::spec::{MeshError, MeshSpec};
use crate::mesh::strain::{Flat, StrainBatch};
use crate::mesh::topology::Topology;

/// Least share of the stiffest rigidity that the others are given: a fabric that bends for nothing
/// one way is still measured.
const RIGIDITY_FLOOR: f64 = 1.0e-6;

/// Bending, by how many neighbors the particle in the middle has.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Stars {
    pub(crate) few: Vec<StarBatch<{ STAR_SIZES[0] }>>,
    pub(crate) more: Vec<StarBatch<{ STAR_SIZES[1] }>>,
    pub(crate) many: Vec<StarBatch<{ STAR_SIZES[2] }>>,
    pub(crate) bent_few: Vec<BentBatch<{ STAR_SIZES[0] }>>,
    pub(crate) bent_more: Vec<BentBatch<{ STAR_SIZES[1] }>>,
    pub(crate) bent_many: Vec<BentBatch<{ STAR_SIZES[2] }>>,
}

/// Edges and neighbors of a piece, and how it lies flat.
#[derive(Clone, Copy)]
pub(crate) struct Shape<'a> {
    pub(crate) topology: &'a Topology,
    pub(crate) rest: Rest<'a>,
}

/// Everything that is solved.
pub(crate) struct Parts {
    pub(crate) stars: Stars,
    /// Triangles that no star solves.
    pub(crate) other_triangles: Vec<StrainBatch>,
    /// Every triangle.
    pub(crate) triangles: Vec<StrainBatch>,
}

/// Cuts a piece into batches; `inv_masses` are by particle [1/kg].
pub(crate) fn parts(
    spec: &MeshSpec,
    shape: Shape<'_>,
    (slots, inv_masses): (&Slots, &[f64]),
) -> Result<Parts, MeshError> {
    let topology = shape.topology;
    let is_free = |triangle: &[u32; 3]| !triangle.iter().all(|&p| spec.pinned[p as usize]);
    let mut unassigned: Vec<bool> = topology.triangles.iter().map(is_free).collect();
    let triangles = strain_batches(shape, slots, &unassigned)?;
    let mut stars = stars(spec, shape, inv_masses);
    stars.sort_by_key(|star| slots.of_particle[star.members[0] as usize]);
    assign_triangles(shape, slots, (&mut stars, &mut unassigned));
    for member in stars.iter_mut().flat_map(|star| &mut star.members) {
        *member = slots.of_particle[*member as usize];
    }
    let [few, more, _] = STAR_SIZES;
    let (bent, stars): (Vec<_>, Vec<_>) = stars.into_iter().partition(|it| it.curve.is_some());
    let [few, more, many] = [0..few + 1, few + 1..more + 1, more + 1..usize::MAX];
    let count = slots.count;
    Ok(Parts {
        stars: Stars {
            few: star_batches((&stars, few.clone()), count, StarBatch::new)?,
            more: star_batches((&stars, more.clone()), count, StarBatch::new)?,
            many: star_batches((&stars, many.clone()), count, StarBatch::new)?,
            bent_few: star_batches((&bent, few), count, BentBatch::new)?,
            bent_more: star_batches((&bent, more), count, BentBatch::new)?,
            bent_many: star_batches((&bent, many), count, BentBatch::new)?,
        },
        other_triangles: strain_batches(shape, slots, &unassigned)?,
        triangles,
    })
}

/// The chosen triangles in the order of their slots.
fn strain_batches(
    shape: Shape<'_>,
    slots: &Slots,
    chosen: &[bool],
) -> Result<Vec<StrainBatch>, MeshError> {
    let Shape { topology, rest } = shape;
    let chosen = topology.triangles.iter().zip(chosen).enumerate();
    let mut chosen: Vec<([u32; 3], Flat)> = chosen
        .filter(|(_, (_, chosen))| **chosen)
        .map(|(index, (&triangle, _))| {
            let flat = rest.triangle(topology, index, triangle);
            (slots.of(triangle), flat)
        })
        .collect();
    chosen.sort_by_key(|&(mut slots, _)| {
        slots.sort_unstable();
        slots
    });
    let (corners, flats): (Vec<_>, Vec<_>) = chosen.into_iter().unzip();
    let lists: Vec<&[u32]> = corners
        .iter()
        .map(|corners: &[u32; 3]| &corners[..])
        .collect();
    let batches = into_batches(&lists, slots.count)?;
    let batches = batches
        .iter()
        .map(|batch| StrainBatch::new(batch, &corners, &flats));
    Ok(batches.collect())
}

fn star_batches<B>(
    (stars, sizes): (&[StarSpec], std::ops::Range<usize>),
    slot_count: usize,
    batch_of: impl Fn(&Batch, &[&StarSpec]) -> B,
) -> Result<Vec<B>, MeshError> {
    let chosen = stars
        .iter()
        .filter(|star| sizes.contains(&star.weights.len()));
    let chosen: Vec<&StarSpec> = chosen.collect();
    let lists: Vec<&[u32]> = chosen.iter().map(|star| &star.members[..]).collect();
    let batches = into_batches(&lists, slot_count)?;
    Ok(batches
        .iter()
        .map(|batch| batch_of(batch, &chosen))
        .collect())
}

/// Bending at every particle, with particles for members.
fn stars(spec: &MeshSpec, shape: Shape<'_>, inv_masses: &[f64]) -> Vec<StarSpec> {
    (0..spec.pinned.len())
        .filter_map(|middle| star_at(spec, shape, middle, inv_masses))
        .collect()
}

/// Bending stiffness along warp, weft and twist [N·m]; `None` of a fabric that bends for nothing.
fn rigidities(fabric: &Fabric) -> Option<[f64; 3]> {
    let rigidities = [fabric.bend[0], fabric.bend[1], 2.0 * fabric.twist].map(f64::from);
    let stiffest = rigidities.into_iter().fold(0.0, f64::max);
    let floored = rigidities.map(|rigidity| rigidity.max(stiffest * RIGIDITY_FLOOR));
    (0.0 < stiffest).then_some(floored)
}

/// Bending at one particle; `None` where nothing bends.
fn star_at(
    spec: &MeshSpec,
    shape: Shape<'_>,
    middle: usize,
    inv_masses: &[f64],
) -> Option<StarSpec> {
    let Shape { topology, rest } = shape;
    let layers = f64::from(spec.layers[middle]);
    let rigidities = rigidities(&spec.fabric)?.map(|rigidity| layers * rigidity);
    let pinned = |particle: &u32| spec.pinned[*particle as usize];
    if spec.pinned[middle] && topology.neighbors[middle].iter().all(pinned) {
        return None;
    }
    let mut ring = rest.ring(topology, middle);
    // Of a ring too large the nearest are kept.
    let [.., most] = STAR_SIZES;
    if most < ring.len() {
        ring.sort_by(|(_, a), (_, b)| a.length_squared().total_cmp(&b.length_squared()));
        ring.truncate(most);
    }
    let (ring, mut offsets): (Vec<u32>, Vec<DVec2>) = ring.into_iter().unzip();
    let bent = bent_star(spec, (middle, &ring), &offsets);
    if let Some((bent, _)) = &bent {
        offsets = bent.iter().map(|offset| offset.truncate()).collect();
    }
    // At a clamp, a pinned particle with a pinned triangle on one side and cloth on the other, the
    // arm that bends is half as long and the energy twice as large.
    let is_clamp = spec.pinned[middle]
        && topology.triangles.iter().any(|triangle| {
            triangle.iter().any(|&p| p as usize == middle) && triangle.iter().all(pinned)
        });
    let ring_masses: Vec<f64> = ring.iter().map(|&p| inv_masses[p as usize]).collect();
    let measures = measures(&Star {
        offsets: &offsets,
        inv_masses: &ring_masses,
        inv_mass: inv_masses[middle],
        area: f64::from(topology.areas[middle]) * if is_clamp { 2.0 } else { 1.0 },
        rigidities,
    })?;
    let curve = bent.map(|(bent, slopes)| {
        let heights = bent.iter().zip(&measures.weights);
        let rest = |measure: usize| heights.clone().map(|(at, row)| at.z * row[measure]).sum();
        Curve {
            slopes: slopes
                .into_iter()
                .map(|it| it.to_array().map(narrow_float))
                .collect(),
            rests: [0, 1, 2].map(rest).map(narrow_float),
        }
    });
    let mut members = vec![narrow(middle)];
    members.extend(ring);
    Some(StarSpec {
        members,
        weights: measures
            .weights
            .into_iter()
            .map(|row| row.map(narrow_float))
            .collect(),
        masses: measures.masses.map(narrow_float),
        triangles: [Flat::NONE; 2],
        curve,
    })
}

/// The ring of a star that is bent at rest: its places [m] along warp, weft and normal of the bent surface, and
/// their weights in its slopes along warp and weft [1/m], which are those of a plane fitted to the flat ring.
/// Along the surface the measures of bending see nothing then, and what they are at rest is along the normal.
fn bent_star(
    spec: &MeshSpec,
    (middle, ring): (usize, &[u32]),
    offsets: &[DVec2],
) -> Option<(Vec<DVec3>, Vec<DVec2>)> {
    let center = spec.bent_positions.get(middle)?.as_dvec3();
    let places = ring
        .iter()
        .map(|&it| spec.bent_positions[it as usize].as_dvec3() - center);
    let outer = |&offset: &DVec2| DMat2::from_cols(offset * offset.x, offset * offset.y);
    let spread: DMat2 = offsets.iter().map(outer).sum();
    if spread.determinant() <= 0.0 {
        return None;
    }
    let inverse = spread.inverse();
    let slopes: Vec<DVec2> = offsets.iter().map(|&offset| inverse * offset).collect();
    let slope = |way: usize| -> DVec3 {
        let parts = places.clone().zip(&slopes);
        parts.map(|(place, weights)| place * weights[way]).sum()
    };
    let (warp, weft) = (slope(0), slope(1));
    let spanned = warp.cross(weft);
    let normal = spanned.try_normalize()?;
    let along = warp.try_normalize()?;
    let across = normal.cross(along);
    let places =
        places.map(|place| DVec3::new(place.dot(along), place.dot(across), place.dot(normal)));
    let scale = 1.0 / spanned.length().sqrt();
    let slopes = slopes.into_iter().map(|weights| weights * scale);
    Some((places.collect(), slopes.collect()))
}

/// Triangles that a star may solve, and how many of their corners come later in memory.
struct Choice {
    score: u32,
    corners: [u32; 3],
    triangles: [Option<usize>; 2],
}

/// Gives every star at most two triangles side by side that no other has: the star's particles are
/// at hand then, and fetching them is half of the work. Members come so that the triangles are
/// those of the middle with the first two, and with the second and third.
fn assign_triangles(
    shape: Shape<'_>,
    slots: &Slots,
    (stars, unassigned): (&mut [StarSpec], &mut [bool]),
) {
    let Shape { topology, rest } = shape;
    let mut fans: Vec<Fan> = vec![Vec::new(); topology.neighbors.len()];
    for (index, &[a, b, c]) in topology.triangles.iter().enumerate() {
        for [middle, right, left] in [[a, b, c], [b, c, a], [c, a, b]] {
            fans[middle as usize].push(([right, left], index));
        }
    }
    for star in stars {
        let middle = star.members[0];
        // A ring that was cut short may lack a corner.
        if star.weights.len() < topology.neighbors[middle as usize].len() {
            continue;
        }
        let Some(choice) = choose(middle, &fans[middle as usize], slots, unassigned) else {
            continue;
        };
        for (place, corner) in choice.corners.into_iter().enumerate() {
            let found = star.members.iter().position(|&member| member == corner);
            if let Some(found) = found.filter(|&found| place + 1 < found) {
                star.members.swap(place + 1, found);
                star.weights.swap(place, found - 1);
                if let Some(curve) = &mut star.curve {
                    curve.slopes.swap(place, found - 1);
                }
            }
        }
        let [a, b, c] = choice.corners;
        let corners = [[middle, a, b], [middle, b, c]];
        for ((flat, triangle), corners) in (star.triangles.iter_mut())
            .zip(choice.triangles)
            .zip(corners)
        {
            if let Some(triangle) = triangle {
                unassigned[triangle] = false;
                *flat = rest.triangle(topology, triangle, corners);
            }
        }
    }
}

/// Of a particle's free triangles two side by side, else one; those that lie ahead in memory first,
/// so that the particles before have left none behind.
fn choose(middle: u32, fan: &Fan, slots: &Slots, unassigned: &[bool]) -> Option<Choice> {
    let slot = |particle: u32| slots.of_particle[particle as usize];
    let ahead = |particle: u32| u32::from(slot(middle) < slot(particle));
    let free = fan.iter().filter(|&&(_, triangle)| unassigned[triangle]);
    let choices = free.clone().map(|&([a, b], first)| {
        let second = free.clone().find(|&&([right, _], _)| right == b);
        match second {
            Some(&([_, c], second)) => Choice {
                score: 4 + ahead(a) + ahead(b) + ahead(c),
                corners: [a, b, c],
                triangles: [Some(first), Some(second)],
            },
            None => Choice {
                score: ahead(a) + ahead(b),
                corners: [a, b, b],
                triangles: [Some(first), None],
            },
        }
    });
    choices.max_by_key(|choice| choice.score)
}
