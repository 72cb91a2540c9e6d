//! Garments of the templates, sewn on the dancer: pieces cut out, divided into triangles, laid around
//! her, sewn by their seams and brought to rest on the skin.
//!
//! A garment is one mesh whose pieces lie beside each other on the cloth, and an [`Assembly`] whose
//! seams hold them together; nothing of it is pinned but what its row says.

pub(crate) mod bodice;
mod crossings;
mod error;
mod fair;
pub(crate) mod fit;
mod flat;
mod folded;
pub(crate) mod form;
mod given;
pub(crate) mod hung;
mod laid;
mod layers;
mod panel;
mod smooth;
mod state;
#[cfg(test)]
mod tests;
mod tuck;
mod under;
pub(crate) mod wrap;

use std::num::NonZeroU32;
use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3};
use lole_body::{Dancer, Pose, TapePoint};
use lole_cloth::assembly::{
    Assembly, AssemblyState, ClothJoint, ClothPiece, ClothSeam, Elastic, Ends, PieceParticle,
};
use lole_cloth::diagnose::StrainSummary;
use lole_cloth::mesh::{self, MeshModel, MeshSpec};
use lole_cloth::{Crossings, Fabric, SelfCollision, SolverConfig};
use lole_geom::finer::Finer;
use lole_geom::mesh::vertex_normals;
use lole_geom::{Capsule, MeshSurfels, Surfel};
use lole_pattern::Pattern;

use crate::GarmentSpec;
use crate::fitting::Fitting;
use crate::template::{SewnRow, Wear};
use fair::Fairing;
use flat::number;
use form::Form;
use under::Under;

pub use bodice::Covered;
pub use crossings::ClothCrossing;
pub use error::DressError;
pub use laid::Way;
pub use layers::{Body, Layers, Over, PieceOver};
pub use state::DressedState;
pub use tuck::Bands;
pub use wrap::Wrap;

/// Distance kept between garments [m]: the thickness of two fabrics and of the air between them.
pub const LAYER_GAP: f32 = 0.0015;
/// Distance kept between skin and cloth [m]: with edges of two centimeters the middle of a triangle on
/// an arm lies 1.5 mm below its corners.
const CONTACT_OFFSET: f32 = 0.004;
/// Half of the distance that folds keep [m].
const HALF_GAP: f32 = 0.003;
/// Friction of cloth that is pulled into place.
const SLIPPING: f32 = 0.05;
/// Fastest that cloth found inside the skin is pushed out [m/s].
const DEPENETRATION_SPEED: f32 = 1.0;
/// The floor: a ball so large that it is flat to 2 mm over a train.
const FLOOR: Capsule = Capsule {
    ends: [Vec3::new(-1.0, -500.0, 0.0), Vec3::new(1.0, -500.0, 0.0)],
    radii: [500.0; 2],
};
/// Substeps of a frame while seams come together: more of them let triangles turn inside out there.
const SEWING_SUBSTEPS: NonZeroU32 = NonZeroU32::MIN.saturating_add(11);
/// Elastic is fastened to every so manyth particle of its line: what lies in between puckers. Fastened to
/// all of them it would push their edges together, and cloth does not give along its edges.
const FASTENED: usize = 2;
/// Tension of flat elastic of 6 to 8 mm at twice its length [N]. Estimated.
const ELASTIC_STIFFNESS: f32 = 15.0;
/// How long edges of triangles are, about [m].
const EDGE: f32 = 0.02;

/// A garment on a dancer, ready to be simulated and drawn.
#[derive(Debug, Clone)]
pub struct Dressed {
    /// Pieces, seams and elastics as the engine knows them: one mesh.
    assembly: Assembly,
    /// What it is sewn of.
    kit: Arc<Kit>,
    /// Particles that a hand holds besides those that are pinned, ascending.
    held: Vec<u32>,
    /// What it is drafted as.
    pub pattern: Pattern,
    /// Its cloth in SI units.
    pub fabric: Fabric,
    /// Skin that carries the pinned particles, in their order, and how far they lie over it [m].
    pins: Pins,
    /// Where it rests on the standing dancer [m], shape `[particle_count]`.
    pub start: Vec<Vec3>,
    /// How it rests there; `None` before it has come to rest.
    rested: Option<DressedState>,
    /// Its triangles, counterclockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// By particle, the piece of cloth that it belongs to, and by piece of cloth, the pattern's.
    panel_of: Vec<u32>,
    pieces: Vec<usize>,
    /// Where every particle lies on the cloth as it comes from the bolt [m]: along the warp, and across
    /// it, seen from the right side.
    pub on_cloth: Vec<Vec2>,
    /// By particle, the first of those that it is sewn to: they are drawn as one.
    welded: Vec<u32>,
    /// Particles of gathered edges that are drawn in the seam, between two others.
    puckers: Vec<(u32, [u32; 2], f32)>,
    /// What is beside each vertex when its seams are closed.
    fairing: Fairing,
    /// The triangles that cover the trunk, and not the arms: garments worn over it meet them.
    pub trunk_triangles: Vec<[u32; 3]>,
    /// Those of them that hang below what is tucked in: skirts worn over it meet them.
    pub hanging_triangles: Vec<[u32; 3]>,
    /// The triangles that are not tucked under a skirt.
    pub open_triangles: Vec<[u32; 3]>,
}

/// What carries the pinned particles of a garment, in their order.
#[derive(Debug, Clone, Default)]
struct Pins {
    /// The skin below each, and how far it lies over it [m].
    skin: MeshSurfels,
    gaps: Vec<f32>,
    /// What is tied around the trunk goes with it, and not with the skin that an arm draws up.
    tied: Vec<Option<TapePoint>>,
}

impl Pins {
    /// Where they are [m].
    fn places(&self, world: &World<'_>) -> Vec<Vec3> {
        let mut carried = Vec::new();
        (self.skin).pose(world.skin.0, world.skin.1, &mut carried);
        let over_skin = carried.iter().zip(&self.gaps);
        let over_skin = over_skin.map(|(skin, gap)| skin.position + skin.normal * *gap);
        let tied = over_skin.zip(&self.tied);
        tied.map(|(place, tied)| {
            tied.as_ref()
                .map_or(place, |tied| tied.posed(world.world_from_bind))
        })
        .collect()
    }
}

/// What a garment is sewn of.
#[derive(Debug, Clone)]
struct Kit {
    template: &'static str,
    row: &'static SewnRow,
    spec: MeshSpec,
    joints: Vec<ClothJoint>,
    division: Division,
    /// Places among the pinned particles of those that are led to where they are tied, and the way of each [m].
    led: Vec<(usize, Vec<Vec3>)>,
}

/// How finely garments are divided into triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Division {
    /// As they are danced.
    #[default]
    Full,
    /// Into two and a half times as many, with edges of 1.2 cm: to see what finer cloth would cost and look like.
    Fine,
    /// Into half as many, for small pictures.
    Half,
}

impl Division {
    /// Distance kept between skin and cloth [m]: longer edges lie deeper in the middle.
    const fn contact_offset(self) -> f32 {
        match self {
            Self::Full | Self::Fine => CONTACT_OFFSET,
            Self::Half => 1.75 * CONTACT_OFFSET,
        }
    }

    /// Particles over those that it is danced with.
    const fn particle_share(self) -> f64 {
        match self {
            Self::Full => 1.0,
            Self::Fine => 2.5,
            Self::Half => 0.5,
        }
    }
}

/// What a garment is put on among.
#[derive(Debug, Clone, Copy, Default)]
pub struct Among<'a> {
    /// Upper edges of skirts: what lies below them is tucked in.
    pub bands: Option<Bands<'a>>,
    /// Triangles on the trunk of garments that are worn under it, and where they lie in the stance [m].
    pub inside: &'a [(&'a [[u32; 3]], &'a [Vec3])],
    /// How finely it is divided.
    pub division: Division,
}

/// What a dressed garment meets in a step.
#[derive(Debug, Clone, Copy)]
pub struct World<'a> {
    /// Vertices of the skin and their normals at the end of the step: what is pinned goes with them.
    pub skin: (&'a [Vec3], &'a [Vec3]),
    /// What the cloth meets, always the same ones in the same order.
    pub surfels: &'a [Surfel],
    /// How bones move from the bind pose: what is tied around the trunk goes with them.
    pub world_from_bind: &'a [Affine3A],
    /// Velocity of the air [m/s].
    pub air_velocity: Vec3,
    /// How far the floor is from where it was laid [m].
    pub floor: Vec3,
    /// Particles that a hand holds, and where [m]: at least those of [`Dressed::held`].
    pub held: &'a [(u32, Vec3)],
}

/// Puts a garment on a dancer who comes to stand in the pose `stance`; `surfels` are her skin's.
///
/// # Errors
/// Measures that it cannot be drafted from, and pieces that cannot be cut or sewn.
pub fn dress(
    spec: &GarmentSpec<'_>,
    (dancer, surfels): (&Dancer, &MeshSurfels),
    stance: &Pose,
    among: &Among<'_>,
) -> Result<Dressed, DressError> {
    let on_body = crate::measures(dancer);
    // She is dressed as she stands there, in what is cut to what was taken of her.
    let measures = spec.tailor_tape.over(on_body.clone())?;
    // Drafts go by measures alone, and the pieces of a file by tapes around her.
    let fitting = Fitting {
        dancer: spec.given.map(|_| dancer),
        alterations: spec.alterations,
        ..Fitting::by(&measures)
    };
    let template = spec.template.id;
    let size = (spec.given).map(|given| given.size_for(&fitting, spec.options));
    let sized = (spec.given.zip(size.as_ref())).map(|(given, size)| given::Sized { given, size });
    let pattern = match sized {
        Some(sized) => sized.given.pattern_in(sized.size),
        None => spec.pattern(&fitting)?,
    };
    let Wear::Sewn(row) = &spec.template.worn else {
        return Err(DressError::NotWorn { template });
    };
    let laid = laid::lay(
        (template, row),
        pattern,
        (dancer, &on_body),
        (among.division, sized),
    )?;
    let mut under = Under::new(dancer, stance, among.inside);
    let (mut dressed, mut kit) = Dressed::sew((spec, row), laid, among.division)?;
    let lost = |lost| DressError::Lost { template, lost };
    under.lay_over(dancer, &mut dressed);
    fit::fit(
        (&mut dressed, &kit),
        (dancer, surfels),
        (stance, &mut under),
    )?;
    if let Some(bands) = among.bands {
        let form = Form::new(dancer, stance, dancer.landmarks.crotch_height);
        if tuck::tuck(&mut dressed, &mut kit, (&form, bands))? {
            fit::rest(&mut dressed, (dancer, surfels), (stance, &mut under)).map_err(lost)?;
        }
    }
    dressed.kit = Arc::new(kit);
    Ok(dressed)
}

impl Dressed {
    /// Prepares seams and elastics of a garment that is laid around the dancer.
    fn sew(
        (garment, row): (&GarmentSpec<'_>, &'static SewnRow),
        laid: laid::Laid,
        division: Division,
    ) -> Result<(Self, Kit), DressError> {
        let template = garment.template.id;
        let laid::Laid {
            pattern,
            mesh,
            places,
            facing,
            pieces,
            is_on_arm,
            elastics,
            pinned,
            pins,
            led,
            layers,
        } = laid;
        let fabric = garment.fabric;
        let mut spec = MeshSpec::new(mesh.flat.clone(), mesh.triangles.clone(), fabric);
        spec.layers = layers;
        spec.pinned = pinned;
        let joints = joints(&mesh, &elastics);
        let kit = Kit {
            template,
            row,
            spec,
            joints,
            division,
            led,
        };
        let assembly = assembly(&kit, Ease::Worn)?;
        let turned = |&[a, b, c]: &[u32; 3]| {
            if facing[mesh.panel_of[a as usize]] {
                [a, b, c]
            } else {
                [a, c, b]
            }
        };
        let triangles: Vec<[u32; 3]> = mesh.triangles.iter().map(turned).collect();
        let on_trunk = |triangle: &&[u32; 3]| !is_on_arm[mesh.panel_of[triangle[0] as usize]];
        let trunk_triangles: Vec<[u32; 3]> = triangles.iter().filter(on_trunk).copied().collect();
        let on_cloth = mesh.flat.iter().zip(&mesh.panel_of).map(|(flat, &panel)| {
            if facing[panel] {
                *flat
            } else {
                Vec2::new(flat.x, -flat.y)
            }
        });
        let dressed = Self {
            assembly,
            kit: Arc::new(kit.clone()),
            held: Vec::new(),
            pattern,
            fabric,
            pins,
            start: places,
            rested: None,
            hanging_triangles: trunk_triangles.clone(),
            trunk_triangles,
            open_triangles: triangles.clone(),
            triangles,
            on_cloth: on_cloth.collect(),
            welded: welded(&mesh),
            panel_of: mesh.panel_of.iter().map(|&it| number(it)).collect(),
            pieces,
            puckers: mesh.puckers,
            fairing: Fairing::default(),
        };
        Ok((dressed.with_fairing(), kit))
    }

    /// Takes so many substeps in every step, instead of as many as the garment's row says.
    pub fn set_substep_count(&mut self, count: NonZeroU32) {
        self.assembly = self.assembly.clone().with_substep_count(count);
    }

    /// Which particles belong to cloth over the trunk that is not tucked in.
    fn on_trunk(&self) -> Vec<bool> {
        let mut is_on_trunk = vec![false; self.start.len()];
        for &corner in self.trunk_triangles.iter().flatten() {
            is_on_trunk[corner as usize] = true;
        }
        is_on_trunk
    }

    /// The mesh as the engine knows it.
    fn model(&self) -> Option<&MeshModel> {
        match self.assembly.pieces() {
            [ClothPiece::Mesh(model, _)] => Some(model),
            _ => None,
        }
    }

    /// Number of particles.
    #[must_use]
    pub const fn particle_count(&self) -> usize {
        self.start.len()
    }

    /// Places of the cloth as it is sewn: what is sewn together is one point [m].
    fn joined(&self, positions: &[Vec3]) -> Vec<Vec3> {
        let mut joined = self.closed(positions);
        self.pucker(&mut joined);
        joined
    }

    /// Lays what is gathered on a seam into it.
    fn pucker(&self, joined: &mut [Vec3]) {
        for &(particle, ends, share) in &self.puckers {
            let [first, last] = ends.map(|end| joined[end as usize]);
            joined[particle as usize] = first.lerp(last, share);
        }
    }

    /// Places with seams closed: what is sewn together lies in its middle [m].
    fn closed(&self, positions: &[Vec3]) -> Vec<Vec3> {
        let mut sums = vec![(Vec3::ZERO, 0.0_f32); positions.len()];
        for (&group, &position) in self.welded.iter().zip(positions) {
            let sum = &mut sums[group as usize];
            *sum = (sum.0 + position, sum.1 + 1.0);
        }
        let groups = self.welded.iter().map(|&group| sums[group as usize]);
        groups.map(|(sum, count)| sum / count.max(1.0)).collect()
    }

    /// How its drawn surface is made finer for pictures from near by.
    #[must_use]
    pub fn finer(&self) -> Finer {
        Finer::new(&self.triangles, &self.welded)
    }

    /// Unit normals of drawn places, outward; seams are smooth.
    #[must_use]
    pub fn normals(&self, drawn: &[Vec3]) -> Vec<Vec3> {
        let weld = |corners: &[u32; 3]| corners.map(|corner| self.welded[corner as usize]);
        let triangles: Vec<[u32; 3]> = self.triangles.iter().map(weld).collect();
        let normals = vertex_normals(drawn, &triangles);
        let groups = self.welded.iter().map(|&group| normals[group as usize]);
        groups.collect()
    }

    /// Stretch along warp and weft at `positions` [m], 0 where the cloth is pushed together: folds finer
    /// than its triangles are no strain.
    #[must_use]
    pub fn strain(&self, positions: &[Vec3]) -> StrainSummary {
        let mut stretches = self.stretches(positions).into_flattened();
        stretches.sort_by(f32::total_cmp);
        let count = stretches.len().max(1);
        StrainSummary {
            mean: stretches.iter().sum::<f32>() / count as f32,
            p99: stretches.get(count * 99 / 100).copied().unwrap_or(0.0),
            max: stretches.last().copied().unwrap_or(0.0),
        }
    }

    /// The same of every triangle, along the warp and along the weft; 0 where it is held all around.
    #[must_use]
    pub fn stretches(&self, positions: &[Vec3]) -> Vec<[f32; 2]> {
        let Some(model) = self.model() else {
            return Vec::new();
        };
        let pinned = &model.spec().pinned;
        let stretches = self.triangles.iter().map(|&triangle| {
            if triangle.iter().all(|&corner| pinned[corner as usize]) {
                return [0.0; 2];
            }
            let along = mesh::diagnose::deformation(model, triangle, positions);
            along.map(|column| (column.length() - 1.0).max(0.0))
        });
        stretches.collect()
    }

    /// The garment with particles that a hand holds, besides what is pinned: where, a [`World`] says. None
    /// lets go of all of it.
    ///
    /// # Errors
    /// A joint that cannot be made with them.
    pub fn held(&self, particles: &[u32]) -> Result<Self, DressError> {
        let pinned = &self.kit.spec.pinned;
        let is_free = |particle: &&u32| pinned.get(**particle as usize) == Some(&false);
        let mut held: Vec<u32> = particles.iter().filter(is_free).copied().collect();
        held.sort_unstable();
        held.dedup();
        let mut kit = Kit::clone(&self.kit);
        for &particle in &held {
            kit.spec.pinned[particle as usize] = true;
        }
        Ok(Self {
            assembly: assembly(&kit, Ease::Worn)?,
            held,
            ..self.clone()
        })
    }

    /// By particle, whether skin or tape carries it.
    #[must_use]
    pub fn pinned(&self) -> &[bool] {
        &self.kit.spec.pinned
    }

    /// Mass of every particle [kg].
    #[must_use]
    pub fn masses(&self) -> Vec<f32> {
        (self.model()).map_or_else(Vec::new, MeshModel::particle_masses)
    }

    /// Mean of the larger stretch of the triangles around every particle.
    #[must_use]
    pub fn strain_by_particle(&self, positions: &[Vec3]) -> Vec<f32> {
        let mut sums = vec![(0.0_f32, 0.0_f32); positions.len()];
        for (corners, [warp, weft]) in self.triangles.iter().zip(self.stretches(positions)) {
            for &corner in corners {
                let (sum, count) = &mut sums[corner as usize];
                *sum += warp.max(weft);
                *count += 1.0;
            }
        }
        let means = sums.into_iter();
        means.map(|(sum, count)| sum / count.max(1.0)).collect()
    }

    /// Where everything is that is pinned or held, in its order [m].
    fn pin_targets(&self, world: &World<'_>) -> Vec<Vec3> {
        let pinned = self.pins.places(world);
        if self.held.is_empty() {
            return pinned;
        }
        let own = (0_u32..).zip(&self.kit.spec.pinned);
        let own = own
            .filter(|(_, pinned)| **pinned)
            .map(|(particle, _)| particle);
        let mut all: Vec<(u32, Vec3)> = own.zip(pinned).collect();
        let place = |particle: u32| {
            let found = world.held.iter().find(|(held, _)| *held == particle);
            found.map(|(_, place)| (particle, *place))
        };
        all.extend(self.held.iter().filter_map(|&particle| place(particle)));
        all.sort_by_key(|(particle, _)| *particle);
        all.into_iter().map(|(_, place)| place).collect()
    }

    /// The garment at rest where it starts, with all that its folds keep apart there.
    #[must_use]
    pub fn state(&self) -> DressedState {
        let laid = || DressedState {
            state: AssemblyState::new(&self.assembly, std::slice::from_ref(&self.start)),
        };
        self.rested.clone().unwrap_or_else(laid)
    }

    /// Lets it start as it has come to rest.
    fn start_from(&mut self, mut rested: DressedState) {
        rested.scale_velocities(self, 0.0);
        let mut start = Vec::new();
        rested.copy_positions(self, &mut start);
        self.start = start;
        self.rested = Some(rested);
    }
}

/// What a garment is prepared for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ease {
    /// To be sewn: it slips over the skin.
    Basted,
    /// To be worn.
    Worn,
}

/// One mesh with its seams.
fn assembly(kit: &Kit, ease: Ease) -> Result<Assembly, DressError> {
    let template = kit.template;
    let mut spec = kit.spec.clone();
    let contact = Some(SelfCollision {
        radius: HALF_GAP,
        substep_interval: NonZeroU32::MIN.saturating_add(2),
        crossings: Crossings::Repair,
    });
    if ease == Ease::Basted {
        spec.fabric.friction = SLIPPING;
    }
    let config = SolverConfig {
        self_collision: contact,
        contact_offset: kit.division.contact_offset(),
        depenetration_speed: DEPENETRATION_SPEED,
        structural_sweep_count: NonZeroU32::MIN,
        column_strides: Vec::new(),
        tether_scale: None,
        ..SolverConfig::default()
    };
    let model = MeshModel::new(&spec).map_err(|error| DressError::Mesh { template, error })?;
    let pieces = vec![ClothPiece::Mesh(Box::new(model), Box::new(config))];
    let [usual, strained] = match ease {
        Ease::Basted => [SEWING_SUBSTEPS; 2],
        Ease::Worn => kit.row.substep_counts,
    };
    Assembly::new(pieces, &kit.joints, usual)
        .map(|assembly| assembly.with_strained_substep_count(strained))
        .map_err(|error| DressError::Joint { template, error })
}

/// Seams point by point, and elastics.
fn joints(mesh: &flat::FlatMesh, elastics: &[f32]) -> Vec<ClothJoint> {
    let place = |particle: u32| PieceParticle { piece: 0, particle };
    let stitches = mesh.stitches.iter();
    let stitches = stitches.map(|pair| pair.map(|particle| place(particle).into()));
    let mut joints = vec![ClothJoint::Seam(ClothSeam {
        stitches: stitches.collect(),
    })];
    for (line, &length) in mesh.lines.iter().zip(elastics) {
        let flat: f32 = (line.windows(2))
            .map(|pair| {
                let [a, b] = [pair[0], pair[1]].map(|particle| mesh.flat[particle as usize]);
                a.distance(b)
            })
            .sum();
        if line.len() < 2 || flat <= 0.0 {
            continue;
        }
        let is_fastened = |at: usize| at.is_multiple_of(FASTENED) || at + 1 == line.len();
        let fastened = line.iter().enumerate().filter(|(at, _)| is_fastened(*at));
        joints.push(ClothJoint::Elastic(Elastic {
            line: fastened.map(|(_, &particle)| place(particle)).collect(),
            ends: Ends::Apart,
            rest_share: length / flat,
            stretch_stiffness: ELASTIC_STIFFNESS,
        }));
    }
    joints
}

/// By particle, the first one that it is sewn to, directly or by way of others.
fn welded(mesh: &flat::FlatMesh) -> Vec<u32> {
    let mut first: Vec<u32> = (0..number(mesh.flat.len())).collect();
    fn root(first: &mut [u32], mut particle: u32) -> u32 {
        while first[particle as usize] != particle {
            first[particle as usize] = first[first[particle as usize] as usize];
            particle = first[particle as usize];
        }
        particle
    }
    for &[a, b] in &mesh.stitches {
        let [a, b] = [a, b].map(|particle| root(&mut first, particle));
        first[a.max(b) as usize] = a.min(b);
    }
    (0..number(mesh.flat.len()))
        .map(|particle| root(&mut first, particle))
        .collect()
}
