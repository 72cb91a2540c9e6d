//! A dancer in her costume as VRM 1.0: the body in the T-pose on its bones, what hangs from the hips on chains of
//! spring bones whose settings are fitted to how it swayed.
//!
//! What hangs is divided into sectors around the hips and levels down to the hem. Every sector has a chain; a vertex
//! is carried by the two chains beside it and the two joints about it. The chains' stiffness, drag and gravity are the
//! ones with which chains that are simulated as VRM says come nearest to where the cloth was in the take.

mod chains;
mod rest;
mod springs;

use glam::Vec3;
use lole_body::Bone;
use lole_export::ExportError;
use lole_export::glb::{AddedJoint, GlbMesh, GlbPart, GlbScene, GlbShape, write_glb};
use lole_export::take::{TakeScene, TakeSource};
use lole_export::vrm::{VrmCollider, VrmJoint, VrmMeta, VrmSpring, humanoid, spring_bone};
use lole_garment::adorn::Carried;
use lole_geom::Capsule;
use lole_stage::{Production, WornSurface};
use rayon::prelude::*;

use crate::Cover;
use crate::baked::{BodyPictures, worn};
use chains::{Chains, LEVELS, NODES, SECTORS};
use rest::{Hanging, Rest};
use springs::{HIT_RADIUS, Settings, Track};

/// Most frames that settings are fitted to and errors are measured in.
const MOST_FRAMES: u32 = 400;
/// Cloth that lies this much deeper in a leg than the take's [m] lets the leg through.
const SEEN_DEPTH: f32 = 0.01;

/// How near the chains come to the take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VrmFigures {
    /// Frames of the take that were compared.
    pub frames: u32,
    /// Mean distance of a vertex that chains carry from where it was [mm].
    pub mean_mm: f64,
    /// Largest distance [mm].
    pub worst_mm: f64,
    /// Share of the frames in which a leg comes through: a vertex lies a centimeter deeper in its capsule than in
    /// the take. A thigh's capsule is wider than its flesh at the hip, so that depth alone would say nothing.
    pub leg_share: f64,
    /// Fitted stiffness, drag and gravity of VRM.
    pub settings: [f32; 3],
}

/// Why there is no VRM.
#[derive(Debug, thiserror::Error)]
pub enum VrmError {
    /// A mesh or a picture that the file cannot carry.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// A frame cannot be read.
    #[error("the take cannot be read ({0}); record it again")]
    Take(#[from] std::io::Error),
}

/// Width of the band below the hips [m] over which cloth passes from the skin to the chains.
const BAND: f32 = 0.06;

/// A mesh of the file, in the T-pose.
struct Clothing {
    /// Place among all surfaces.
    place: usize,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
}

/// The file's bytes, and how near its chains come to the take. A dancer whose license keeps her out of files must not
/// be given.
///
/// # Errors
/// See [`VrmError`].
pub fn take_vrm(
    production: &Production,
    covers: &[Cover],
    (take, meta): (&mut dyn TakeSource, &VrmMeta),
) -> Result<(Vec<u8>, VrmFigures), VrmError> {
    let scene = take.scene().clone();
    let rest = Rest::new(&production.dancer, &take.pose(0)?);
    let hanging = rest.hanging(production, &scene, take)?;
    let chains = Chains::new(&hanging, rest.hips());
    let track = track(production, &chains, (take, &hanging))?;
    let (settings, figures) = springs::fit(&chains, &track);
    let clothes = clothes(production, &scene, (&rest, &chains, take), &hanging)?;
    let bytes = write(
        production,
        covers,
        (&rest, &chains, &clothes),
        (settings, meta),
    )?;
    Ok((bytes, figures))
}

/// Where the joints' cloth was in the take, beside where the hips and the legs were.
fn track(
    production: &Production,
    chains: &Chains,
    (take, hanging): (&mut dyn TakeSource, &Hanging),
) -> Result<Track, VrmError> {
    let scene = take.scene().clone();
    let stride = scene.frame_count.div_ceil(MOST_FRAMES).max(1);
    let skeleton = &production.dancer.skeleton;
    let mut track = Track::new(scene.frame_rate, chains);
    for frame in 0..scene.frame_count {
        let world = skeleton.world_from_bind(&take.pose(frame)?);
        let legs = legs(production, &world);
        let is_compared = frame.is_multiple_of(stride);
        let mut places = Vec::new();
        if is_compared {
            for surface in &hanging.surfaces {
                let [positions, _] = take.vertices(frame, surface.mesh)?;
                places.extend(surface.vertices.iter().map(|&vertex| positions[vertex]));
            }
        }
        track.push(
            world[Bone::Hips.index()],
            legs,
            is_compared.then_some(places),
        );
    }
    Ok(track)
}

/// Capsules of the legs in a pose.
fn legs(production: &Production, world_from_bind: &[glam::Affine3A]) -> Vec<Capsule> {
    let capsules = production.dancer.capsules.iter();
    let legs = capsules.filter(|capsule| is_leg(capsule.ends[1].0));
    legs.map(|capsule| capsule.posed(world_from_bind)).collect()
}

const fn is_leg(bone: Bone) -> bool {
    matches!(
        bone,
        Bone::LeftUpperLeg | Bone::RightUpperLeg | Bone::LeftLowerLeg | Bone::RightLowerLeg
    )
}

/// Whether a leg comes through cloth that is carried to some places [m] and was in others.
fn comes_through(legs: &[Capsule], carried: &[Vec3], taken: &[Vec3]) -> bool {
    let depth = |leg: &Capsule, place: Vec3| (-leg.signed_distance(place)).max(0.0);
    let mut pairs = carried.iter().zip(taken);
    pairs.any(|(&carried, &taken)| {
        let deeper = |leg: &Capsule| SEEN_DEPTH < depth(leg, carried) - depth(leg, taken);
        legs.iter().any(deeper)
    })
}

/// Everything that is worn, in the T-pose: what hangs on the hips and the chains, everything else on the bones that
/// carry it or the skin below it.
fn clothes(
    production: &Production,
    scene: &TakeScene,
    (rest, chains, take): (&Rest, &Chains, &mut dyn TakeSource),
    hanging: &Hanging,
) -> Result<Vec<Clothing>, VrmError> {
    let mut clothes = Vec::new();
    for (place, surface) in production.surfaces().enumerate() {
        if scene.meshes[place]
            .parts
            .iter()
            .all(|part| part.triangles.is_empty())
        {
            continue;
        }
        let [positions, normals] = take.vertices(0, place)?;
        let hangs = hanging.surfaces.iter().any(|it| it.mesh == place);
        let made: Vec<Carried4> = (0..positions.len())
            .into_par_iter()
            .map(|vertex| {
                let at = (positions[vertex], normals[vertex]);
                let carrier = carrier(surface, vertex).unwrap_or_else(|| rest.nearest(at.0));
                let on_skin = rest.carried(at, carrier);
                let below = rest.hips().y - rest.off_hips(at.0).y;
                if hangs && 0.0 < below {
                    hung(rest, chains, (at, on_skin, below))
                } else {
                    (on_skin.0, on_skin.1, carrier.0, carrier.1)
                }
            })
            .collect();
        clothes.push(Clothing {
            place,
            positions: made.iter().map(|it| it.0).collect(),
            normals: made.iter().map(|it| it.1).collect(),
            joints: made.iter().map(|it| it.2).collect(),
            weights: made.iter().map(|it| it.3).collect(),
        });
    }
    Ok(clothes)
}

/// A vertex in the T-pose, its normal, and what carries it.
type Carried4 = (Vec3, Vec3, [u16; 4], [f32; 4]);

/// Bones that carry a vertex of what is worn beside the cloth.
fn carrier(surface: WornSurface<'_>, vertex: usize) -> Option<([u16; 4], [f32; 4])> {
    match &surface.beside()?.carried {
        Carried::Bones { carriers, .. } => {
            let carrier = carriers.get(vertex)?;
            Some((carrier.joints, carrier.weights))
        }
        Carried::Strands(_) => None,
    }
}

/// A vertex that hangs so far below the hips: carried by the chains, and near the hips where the skin would have it.
fn hung(
    rest: &Rest,
    chains: &Chains,
    (at, on_skin, below): ((Vec3, Vec3), (Vec3, Vec3), f32),
) -> Carried4 {
    let place = rest.off_hips(at.0);
    let position = on_skin.0.lerp(place, (below / BAND).min(1.0));
    let (mut joints, mut weights, mut count) = ([0; 4], [0.0; 4], 0);
    for (carrier, share) in chains.carried(place) {
        let joint = carrier.map_or(0, |(chain, joint)| joint_place(chain, joint));
        // No joint stands twice for a vertex.
        let slot = joints[..count].iter().position(|&it| it == joint);
        let slot = slot.unwrap_or_else(|| {
            count += 1;
            count - 1
        });
        joints[slot] = joint;
        weights[slot] += share;
    }
    let joints = joints.map(|joint| u16::try_from(joint).unwrap_or(0));
    (position, rest.turned_off_hips(at.1), joints, weights)
}

/// Place of a joint of a chain among bones and added joints.
const fn joint_place(chain: usize, joint: usize) -> usize {
    Bone::COUNT + chain * NODES + joint
}

/// Joints and springs of the chains.
fn swinging(chains: &Chains, settings: Settings) -> (Vec<AddedJoint>, Vec<VrmSpring>) {
    let (mut joints, mut springs) = (Vec::new(), Vec::new());
    if chains.is_empty() {
        return (joints, springs);
    }
    for chain in 0..SECTORS {
        let name = format!("skirt_{chain:02}");
        for node in 0..NODES {
            joints.push(AddedJoint {
                name: format!("{name}_{node}"),
                parent: match node {
                    0 => Bone::Hips.index(),
                    node => joint_place(chain, node - 1),
                },
                place: chains.rest[chain][node],
            });
        }
        let joint = |node: usize| VrmJoint {
            joint: joint_place(chain, node),
            hit_radius: if node < LEVELS { HIT_RADIUS } else { 0.0 },
            stiffness: settings.stiffness,
            gravity_power: settings.gravity,
            drag_force: settings.drag,
        };
        springs.push(VrmSpring {
            name,
            joints: (0..NODES).map(joint).collect(),
        });
    }
    (joints, springs)
}

/// Capsules of the legs on their bones.
fn colliders(production: &Production) -> Vec<VrmCollider> {
    let dancer = &production.dancer;
    let legs = dancer.capsules.iter();
    let legs = legs.filter(|capsule| is_leg(capsule.ends[1].0));
    legs.map(|capsule| {
        // One bone carries a collider of VRM: the one of its lower end.
        let bone = capsule.ends[1].0;
        let joint = dancer.skeleton.joint(bone);
        let ends = capsule.ends.map(|(_, end)| (end - joint).to_array());
        let [first, second] = capsule.radii;
        VrmCollider {
            joint: bone.index(),
            ends,
            radius: 0.5 * (first + second),
        }
    })
    .collect()
}

fn write(
    production: &Production,
    covers: &[Cover],
    (rest, chains, clothes): (&Rest, &Chains, &[Clothing]),
    (settings, meta): (Settings, &VrmMeta),
) -> Result<Vec<u8>, ExportError> {
    let dancer = &production.dancer;
    let pictures = BodyPictures::of(dancer)?;
    let parts = pictures.parts(dancer);
    let worn = worn::Worn::of(production, covers)?;
    let surfaces: Vec<WornSurface<'_>> = production.surfaces().collect();
    let names: Vec<String> = surfaces
        .iter()
        .enumerate()
        .map(|(place, surface)| format!("{}_{place}", surface.worn().name()))
        .collect();
    let cloth_parts: Vec<[GlbPart<'_>; 1]> = clothes
        .iter()
        .map(|it| {
            [GlbPart {
                triangles: &covers[it.place].triangles,
                material: match surfaces[it.place].beside() {
                    Some(beside) => worn::material(beside.finish),
                    None => worn.material_at(it.place),
                },
            }]
        })
        .collect();
    let shapes: Vec<GlbShape> = rest.closed_eyes(dancer).into_iter().collect();
    let mut meshes = vec![GlbMesh {
        name: "dancer",
        positions: &rest.positions,
        normals: &rest.normals,
        uvs: &dancer.drawn().uvs,
        colors: &dancer.drawn().colors,
        joints: &dancer.drawn().joints,
        weights: &dancer.drawn().weights,
        parts: &parts,
        shapes: &shapes,
        shape_times: &[],
    }];
    meshes.extend(clothes.iter().zip(&cloth_parts).map(|(it, parts)| GlbMesh {
        name: &names[it.place],
        positions: &it.positions,
        normals: &it.normals,
        uvs: &covers[it.place].uvs,
        colors: &covers[it.place].colors,
        joints: &it.joints,
        weights: &it.weights,
        parts,
        shapes: &[],
        shape_times: &[],
    }));
    let (added, springs) = swinging(chains, settings);
    // Meshes stand behind the armature, the bones and the joints of the chains.
    let body = 1 + Bone::COUNT + added.len();
    let blinks = (!shapes.is_empty()).then_some(body);
    let mut extensions = vec![("VRMC_vrm", humanoid(meta, blinks))];
    if !springs.is_empty() {
        extensions.push((
            "VRMC_springBone",
            spring_bone(&springs, &colliders(production)),
        ));
    }
    let file = write_glb(&GlbScene {
        skeleton: &rest.skeleton,
        pose_times: &[],
        poses: &[],
        skinned: &meshes,
        cloths: &[],
        added: &added,
        extensions: &extensions,
    })?;
    Ok(file.bytes)
}
