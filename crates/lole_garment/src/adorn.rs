//! What is worn or held beside the cloth: lei, wreaths, flowers, bands of leaves, skirts of strands,
//! instruments. Their shapes are made from the template's options and the dancer's measures, low in
//! triangles, and each vertex knows what carries it: bones, or a strand that moves.
//!
//! What makes one of them stands in its file under `garment/`; here is what they are made from.

pub(crate) mod blade;
pub(crate) mod body;
pub(crate) mod chosen;
pub(crate) mod flower;
pub(crate) mod grip;
pub(crate) mod shape;
pub(crate) mod strand_skirt;
pub(crate) mod strands;
pub(crate) mod wreath;

use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use lole_body::Dancer;
use lole_cloth::strands::{Link, Strand, StrandConfig, Tie};
use lole_pattern::{DraftError, Measures};

use crate::GarmentSpec;
use crate::fitting::Fitting;
use crate::template::Wear;

pub use grip::Grip;
pub use strands::{Frame, frames};

/// One mesh of one finish.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// What it is made of.
    pub finish: AdornmentFinish,
    /// Linear colors of the vertices.
    pub colors: Vec<Vec3>,
    /// Vertex indices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// What carries the vertices.
    pub carried: Carried,
}

/// What a surface is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AdornmentFinish {
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
#[derive(Debug, Clone, Copy)]
pub struct Wearer<'a> {
    /// She.
    pub dancer: &'a Dancer,
    /// What was measured of her.
    pub measures: &'a Measures,
    /// How her bones move from the bind pose to her stance.
    pub stance: &'a [Affine3A],
}

/// What makes one kind.
pub type Make = fn(&GarmentSpec<'_>, &Wearer<'_>) -> Result<Made, DraftError>;

/// What one is made of.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Made {
    /// What is drawn, by what it is made of.
    pub surfaces: Vec<Surface>,
    /// What moves by itself; `None` where bones carry all of it.
    pub strands: Option<HangingStrands>,
    /// Hands that hold it.
    pub grips: Vec<Grip>,
}

/// Makes what is worn beside the cloth; `None` of everything else.
///
/// # Errors
/// Measures or options that it cannot be made from.
pub fn adorn(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Option<Made>, DraftError> {
    let Wear::Beside(row) = &spec.template.worn else {
        return Ok(None);
    };
    // What cannot be drafted cannot be worn: the drafter knows every range.
    spec.pattern(&Fitting::by(wearer.measures))?;
    (row.make)(spec, wearer).map(Some)
}
