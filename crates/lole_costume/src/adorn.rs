//! What is worn or held beside the cloth: lei, wreaths, flowers, bands of leaves, skirts of strands,
//! instruments. Their shapes are made from the template's options and the dancer's measures, low in
//! triangles, and each vertex knows what carries it: bones, or a strand that moves.
//!
//! One file for each thing; `KINDS` is the table of contents.

mod blade;
mod body;
mod chosen;
mod flower;
mod grip;
mod hair_flower;
mod ipu;
mod kupee;
mod lei;
mod lei_poo;
mod puili;
mod shape;
mod strand_skirt;
mod strands;
mod uliuli;
mod wreath;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use lole_body::{Dancer, PartKind, Side};
use lole_cloth::strands::{Link, Strand, StrandConfig, Tie};
use lole_pattern::{DraftError, Measures};

use crate::document::{Design, GarmentDesign, WornTemplate};

pub use grip::Grip;
pub use strands::{Frame, frames};

/// Something worn or held, as it is drawn and moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Adornment {
    /// Name in files; no two of a dancer share one.
    pub name: String,
    /// Place in the design's list of garments.
    pub place: usize,
    /// What is drawn, by what it is made of.
    pub surfaces: Vec<Surface>,
    /// What moves by itself; `None` where bones carry all of it.
    pub strands: Option<HangingStrands>,
    /// Hands that hold it.
    pub grips: Vec<Grip>,
}

/// One mesh of one finish.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// What it is made of.
    pub finish: Finish,
    /// Linear colors of the vertices.
    pub colors: Vec<Vec3>,
    /// Vertex indices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// What carries the vertices.
    pub carried: Carried,
}

/// What a surface is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finish {
    /// A waxy leaf.
    #[default]
    Leaf,
    /// A petal.
    Petal,
    /// Feathers.
    Feather,
    /// Dry fiber, cord and cloth.
    Fiber,
    /// Polished gourd and bamboo.
    Wood,
    /// Clear shining film.
    Film,
}

/// What carries the vertices of a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Carried {
    /// Bones, as they carry the skin.
    Bones {
        /// In the bind pose [m].
        positions: Vec<Vec3>,
        /// Unit normals there.
        normals: Vec<Vec3>,
        /// What carries each vertex.
        carriers: Vec<Carrier>,
    },
    /// Strands: each vertex keeps its place in the frame that runs along one.
    Strands(Vec<OnStrand>),
}

impl Default for Carried {
    fn default() -> Self {
        Self::Strands(Vec::new())
    }
}

/// Bones and their shares, as in [`lole_body::SkinnedMesh`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Carrier {
    /// Bones.
    pub joints: [u16; 4],
    /// Their shares, summing to 1.
    pub weights: [f32; 4],
}

/// A vertex on a strand.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OnStrand {
    /// The strand.
    pub strand: u32,
    /// Place along it, in particles from its first one.
    pub along: f32,
    /// Place from there [m]: across, outward and along.
    pub offset: Vec3,
    /// Unit normal in the same directions.
    pub normal: Vec3,
}

/// A point of the bind pose that bones carry.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rider {
    /// Where it lies in the bind pose [m].
    pub position: Vec3,
    /// Unit direction out of the body there.
    pub outward: Vec3,
    /// What carries it.
    pub carrier: Carrier,
}

/// Strands on a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HangingStrands {
    /// As they begin: positions are in the world, on the dancer in her stance.
    pub strands: Vec<Strand>,
    /// What keeps them in their places beside each other.
    pub links: Vec<Link>,
    /// Particles drawn to the body.
    pub ties: Vec<Tie>,
    /// Where, one for each tie.
    pub tie_riders: Vec<Rider>,
    /// What carries the pinned particles, ascending.
    pub pin_riders: Vec<Rider>,
    /// Which way the flat of each strand faces at its first particle; the strands run free where empty.
    pub roots: Vec<Rider>,
    /// Settings that follow from what they are made of.
    pub config: StrandConfig,
    /// Whether forearms and hands pass by them without touching.
    pub passes_arms: bool,
}

impl Carrier {
    /// The transform that carries the bind pose to the world.
    #[must_use]
    pub fn world_from_bind(&self, bones: &[Affine3A]) -> Affine3A {
        let mut matrix = Mat3A::ZERO;
        let mut translation = Vec3A::ZERO;
        for (&joint, &weight) in self.joints.iter().zip(&self.weights) {
            if 0.0 < weight {
                let bone = &bones[usize::from(joint)];
                matrix += bone.matrix3 * weight;
                translation += bone.translation * weight;
            }
        }
        Affine3A {
            matrix3: matrix,
            translation,
        }
    }
}

impl Rider {
    /// Where it is in the world [m], and which way is out of the body there.
    #[must_use]
    pub fn posed(&self, bones: &[Affine3A]) -> [Vec3; 2] {
        let world_from_bind = self.carrier.world_from_bind(bones);
        let outward = world_from_bind.transform_vector3(self.outward);
        [
            world_from_bind.transform_point3(self.position),
            outward.normalize_or_zero(),
        ]
    }
}

impl Surface {
    /// Number of vertices.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        match &self.carried {
            Carried::Bones { positions, .. } => positions.len(),
            Carried::Strands(places) => places.len(),
        }
    }

    /// Its vertices in the world [m] and their unit normals, given the bones and, for each strand, its
    /// [`frames`].
    #[must_use]
    pub fn posed(&self, bones: &[Affine3A], frames: &[Vec<Frame>]) -> [Vec<Vec3>; 2] {
        let mut places = Vec::with_capacity(self.vertex_count());
        let mut directions = Vec::with_capacity(self.vertex_count());
        match &self.carried {
            Carried::Bones {
                positions,
                normals,
                carriers,
            } => {
                let mut last: Option<(Carrier, Affine3A)> = None;
                for ((&position, &normal), carrier) in positions.iter().zip(normals).zip(carriers) {
                    // Whole leaves and petals share their carrier.
                    let known = last.filter(|(known, _)| known == carrier);
                    let (_, world) =
                        known.unwrap_or_else(|| (*carrier, carrier.world_from_bind(bones)));
                    last = Some((*carrier, world));
                    places.push(world.transform_point3(position));
                    directions.push(world.transform_vector3(normal).normalize_or_zero());
                }
            }
            Carried::Strands(on) => {
                for vertex in on {
                    let along = frames.get(vertex.strand as usize);
                    let [place, direction] = along.map_or([Vec3::ZERO, Vec3::Y], |frames| {
                        strands::on_strand(frames, vertex)
                    });
                    places.push(place);
                    directions.push(direction);
                }
            }
        }
        [places, directions]
    }
}

/// The dancer who is adorned.
pub(crate) struct Wearer<'a> {
    pub(crate) dancer: &'a Dancer,
    pub(crate) measures: &'a Measures,
    /// The bones in her stance.
    pub(crate) stance: &'a [Affine3A],
}

/// What makes one kind.
type Make = fn(&WornTemplate, &Wearer<'_>) -> Result<Made, DraftError>;

/// What one kind is made of.
#[derive(Default)]
pub(crate) struct Made {
    pub(crate) surfaces: Vec<Surface>,
    pub(crate) strands: Option<HangingStrands>,
    pub(crate) grips: Vec<Grip>,
}

/// Kinds of templates that are worn beside the cloth, by their identifiers.
const KINDS: &[(&str, Make)] = &[
    ("ti-leaf-skirt", strand_skirt::ti_leaf),
    ("raffia-skirt", strand_skirt::raffia),
    ("cellophane-skirt", strand_skirt::cellophane),
    ("lei", lei::make),
    ("lei-poo", lei_poo::make),
    ("kupee", kupee::make),
    ("hair-flower", hair_flower::make),
    ("uliuli", uliuli::make),
    ("puili", puili::make),
    ("ipu", ipu::make),
];

/// Whether a template of this identifier is worn beside the cloth.
#[must_use]
pub fn is_adornment(id: &str) -> bool {
    KINDS.iter().any(|(kind, _)| *kind == id)
}

/// How far an elbow is opened whose hand would go through it on the chest [°]; 0 for what lies elsewhere.
#[must_use]
pub(crate) fn chest_room_deg(id: &str) -> f32 {
    if id == "lei" {
        lei::CHEST_ROOM_DEG
    } else {
        0.0
    }
}

/// Makes everything of a design that is worn beside the cloth, in the order of its list, for a dancer
/// who stands with these bones.
///
/// # Errors
/// The place in the list, and measures or options that it cannot be made from.
pub fn adorn(
    design: &Design,
    dancer: &Dancer,
    stance: &[Affine3A],
) -> Result<Vec<Adornment>, (usize, DraftError)> {
    let mut adornments: Vec<Adornment> = Vec::new();
    let mut measures = None;
    for (place, garment) in design.garments.iter().enumerate() {
        let GarmentDesign::Template(worn) = garment else {
            continue;
        };
        let Some((id, make)) = KINDS.iter().find(|(id, _)| *id == worn.template.id) else {
            continue;
        };
        let measures = measures.get_or_insert_with(|| crate::measures(dancer));
        // What cannot be drafted cannot be worn: the drafter knows every range.
        worn.pattern(measures).map_err(|error| (place, error))?;
        let wearer = Wearer {
            dancer,
            measures,
            stance,
        };
        let made = make(worn, &wearer).map_err(|error| (place, error))?;
        let names = adornments.iter().map(|adornment| adornment.name.as_str());
        adornments.push(Adornment {
            name: crate::tailoring::numbered(&id.replace('-', "_"), names),
            place,
            surfaces: made.surfaces,
            strands: made.strands,
            grips: made.grips,
        });
    }
    Ok(adornments)
}

/// Whether the flower that belongs to a dancer's hair gives way to what the design puts there.
#[must_use]
pub fn replaces_part(design: &Design, part: PartKind) -> bool {
    let is_flower = matches!(part, PartKind::Flower | PartKind::FlowerHeart);
    is_flower
        && design.garments.iter().any(|garment| match garment {
            GarmentDesign::Template(worn) => match worn.template.id {
                "hair-flower" => hair_flower::side(worn) == Side::Left,
                id => id == "lei-poo",
            },
            _ => false,
        })
}
