//! A performance that is changed while it runs: by another step, tempo, method or fabric, and by a
//! hand that pulls at the cloth.
//!
//! What a change can keep, it keeps: a new tempo goes on from the same count, a new step is eased
//! into, another method takes the cloth over as it hangs. Only another dancer or another cut asks
//! for a new [`Production`].

use std::sync::Arc;

use glam::{Affine3A, Vec3};
use lole_body::{Bone, HairStyle, Makeup, Pose, Swing};
use lole_cloth::{ClothSpec, Crossings, diagnose, model::particle_masses};
use lole_costume::document::{
    DancerDesign, Design, FabricDesign, GarmentDesign, PartDesign, PrintChoice,
};
use lole_geom::Capsule;
use lole_geom::narrow;
use lole_pattern::{Alterations, TailorTape};

use crate::performance::{FRAME_SECONDS, FRAMES_PER_SECOND};
use crate::skin_check::{self, CheckedSurface};
use crate::solver::Solver;
use crate::{Adornment, Danced, Divergence, Performance, Production, StageError, Vertices, Worn};

/// Time in which one dance step is eased into the next [s]: about one count.
const EASE_SECONDS: f64 = 0.9;

/// A hand takes the cloth this far around the point where it takes it [m]: two fingers wide.
const HAND_RADIUS: f32 = 0.022;
/// Fastest the hand moves the cloth [m/s], so that a jerk of the mouse does not tear it.
const HAND_SPEED: f32 = 1.6;

/// Where in a choreography she is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartNow {
    /// Place of the part in the list.
    pub index: usize,
    /// How much of its counts is danced, from 0 to 1.
    pub share: f32,
}

/// A show: a performance with its present wishes.
pub struct Show {
    performance: Performance,
    design: Design,
    /// The garments as they are computed now: the production's, in the present fabrics.
    specs: Vec<ClothSpec>,
    /// Of the particles of all cloth [kg].
    masses: Vec<f32>,
    layers: Vec<Layer>,
    hold: Option<Hold>,
    /// Last good positions of all cloth [m], and the velocities [m/s] that led there.
    positions: Vec<Vec3>,
    velocities: Vec<Vec3>,
    stopped: Option<Divergence>,
}

/// One dance of those that are being eased into each other, the last on top.
struct Layer {
    dance: Danced,
    /// Its own time [s].
    time: f64,
    /// Time since it began to cover what is below [s].
    age: f64,
}

/// A hand that holds the cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// Particle that is held, by its number among those of all cloth.
    pub particle: u32,
    /// Where the hand is [m].
    pub hand: Vec3,
}

/// The cloth between the fingers.
struct Hold {
    pull: Pull,
    /// Where the fingers are [m]: on the way to the hand.
    place: Vec3,
    /// The particles between them, ascending, and where they are from there [m].
    patch: Vec<(u32, Vec3)>,
}

/// What a wish asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// It was granted on the spot.
    Granted,
    /// It needs a new production: another dancer or another cut.
    Resew,
}

/// The cloth's figures of one frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vitals {
    /// Energy of motion, `Σ ½ m v²` [J].
    pub kinetic_energy: f32,
    /// Energy of height, `-Σ m g·x` with `x` from the floor [J].
    pub potential_energy: f32,
    /// Energy stored in springs and bending [J]; `None` for `xpbd`, which has no such energy.
    pub elastic_energy: Option<f32>,
    /// Mean height of the hem above the floor [m].
    pub hem_height: f32,
    /// Middle of the hem: right to left and back to front [m].
    pub hem_middle: [f32; 2],
}

impl Show {
    /// Puts a design on stage.
    ///
    /// # Errors
    /// A design whose parts do not fit together.
    pub fn new(design: &Design) -> Result<Self, StageError> {
        Self::of(Production::new(design)?)
    }

    /// Puts a production on stage, from the beginning.
    ///
    /// # Errors
    /// A skirt the chosen method cannot be prepared for.
    pub fn of(production: impl Into<Arc<Production>>) -> Result<Self, StageError> {
        let production = production.into();
        let specs = production.garments.iter();
        let specs: Vec<ClothSpec> = specs.map(|garment| garment.sewn.spec.clone()).collect();
        let layer = Layer {
            dance: production.dance.clone(),
            time: 0.0,
            age: EASE_SECONDS,
        };
        let performance = Performance::new(Arc::clone(&production))?;
        let positions: Vec<Vec3> = performance.particles().copied().collect();
        Ok(Self {
            design: production.design.clone(),
            masses: masses(&specs, &production),
            velocities: vec![Vec3::ZERO; positions.len()],
            positions,
            performance,
            specs,
            layers: vec![layer],
            hold: None,
            stopped: None,
        })
    }

    /// The same production and wishes, from the beginning.
    ///
    /// # Errors
    /// A skirt the chosen method cannot be prepared for.
    pub fn restarted(&self) -> Result<Self, StageError> {
        let mut fresh = Self::of(self.performance.shared_production())?;
        fresh.wish(&self.design)?;
        fresh.layers.drain(..fresh.layers.len() - 1);
        if let Some(layer) = fresh.layers.first_mut() {
            (layer.time, layer.age) = (0.0, EASE_SECONDS);
        }
        Ok(fresh)
    }

    /// What is performed.
    #[must_use]
    pub fn production(&self) -> Arc<Production> {
        self.performance.shared_production()
    }

    /// What is wished at present.
    #[must_use]
    pub const fn design(&self) -> &Design {
        &self.design
    }

    /// Time of the dance [s]; negative while the skirt settles.
    #[must_use]
    pub fn time(&self) -> f32 {
        self.performance.time()
    }

    /// Where and when the cloth stopped being cloth, if it did.
    #[must_use]
    pub const fn stopped(&self) -> Option<Divergence> {
        self.stopped
    }

    /// Changes the design; a refused or postponed wish changes nothing.
    ///
    /// # Errors
    /// A dance that cannot be danced, a fabric the method cannot be prepared for.
    pub fn wish(&mut self, design: &Design) -> Result<Wish, StageError> {
        if needs_sewing(&self.design, design) {
            return Ok(Wish::Resew);
        }
        let dance = (self.design.motion != design.motion)
            .then(|| self.next_layer(design))
            .transpose()?;
        let looks_anew = self.design.appearance() != design.appearance();
        let adorned = (looks_anew || adornments(&self.design) != adornments(design))
            .then(|| self.performance.adorned_as(design))
            .transpose()?;
        let cloth_changes = self.design.worn_fabrics() != design.worn_fabrics()
            || self.design.method != design.method
            || self.design.wind != design.wind;
        if cloth_changes {
            self.prepare(design)?;
            let layout = design.capsule_layout();
            if layout != self.design.capsule_layout() {
                let dancer = &self.performance.production().dancer;
                let capsules = dancer.fit_capsules(layout);
                self.performance.replace_capsules(capsules);
            }
            self.performance.set_contact_of(design);
            self.stopped = None;
        }
        if let Some(adorned) = adorned {
            self.performance.adorn(adorned);
            self.follow_adornments();
        }
        if let Some(layer) = dance {
            self.layers.push(layer);
        }
        self.design = design.clone();
        Ok(Wish::Granted)
    }

    /// Strands are others now, at rest where they hang: a hand that held one has nothing in it.
    fn follow_adornments(&mut self) {
        let production = self.performance.shared_production();
        let is_strand =
            |&(particle, _): &(u32, Vec3)| production.cloth_count() <= particle as usize;
        if { self.hold.iter() }.any(|hold| hold.patch.iter().any(is_strand)) {
            self.hold = None;
            self.performance.hold(Vec::new());
        }
        self.positions.clear();
        self.positions.extend(self.performance.particles());
        self.velocities.truncate(production.cloth_count());
        self.velocities.resize(self.positions.len(), Vec3::ZERO);
        self.masses = masses(&self.specs, &production);
    }

    /// The dance of `design`, on the count of the present one.
    fn next_layer(&self, design: &Design) -> Result<Layer, StageError> {
        let dance = Danced::new(design, &self.performance.production().dancer)?;
        let (old, new) = (&self.design.motion, &design.motion);
        let last = self.layers.last();
        let time = last.map_or(0.0, |layer| layer.time);
        let same_figure = MotionOfTempo(old) == MotionOfTempo(new);
        // The same step goes on from the same count; another one starts on the same beat.
        let counts = last.and_then(|layer| layer.dance.beat_at(time));
        let counts = counts.unwrap_or(0.0);
        let lead_in = f64::from(dance.lead_in());
        let time = match &dance {
            // The same recording goes on from where it is; another one begins.
            Danced::Recording(_) if same_figure => time,
            Danced::Recording(_) => 0.0,
            Danced::Step(step) if same_figure || self.has_danced_alike(design) => {
                step.time_of_beat(counts)
            }
            Danced::Step(_) if time <= 0.0 => 0.0,
            Danced::Step(_) => lead_in + counts.fract() * 60.0 / new.tempo_bpm,
        };
        let age = if same_figure { EASE_SECONDS } else { 0.0 };
        Ok(Layer { dance, time, age })
    }

    /// Whether `design` has the same choreography up to the part that is danced now, and the same
    /// manner: it goes on from the same count.
    fn has_danced_alike(&self, design: &Design) -> bool {
        let (old, new) = (&self.design.motion, &design.motion);
        let now = self.part().map(|part| part.index);
        let alike = |now: usize| {
            let upto = |parts: &[PartDesign]| parts.get(..=now).map(<[_]>::to_vec);
            upto(&old.parts) == upto(&new.parts)
        };
        let mut manner = old.clone();
        manner.parts.clone_from(&new.parts);
        now.is_some_and(alike) && MotionOfTempo(&manner) == MotionOfTempo(new)
    }

    /// Holds the cloth, moves the hand, or lets go.
    ///
    /// Held particles are carried by the hand as those of the elastic rows are by the skin: every
    /// method knows how.
    ///
    /// # Errors
    /// A cloth that the method cannot be prepared for; nothing is held then.
    pub fn pull(&mut self, pull: Option<Pull>) -> Result<(), StageError> {
        match (pull, &mut self.hold) {
            (Some(pull), Some(hold)) if hold.pull.particle == pull.particle => {
                hold.pull = pull;
                Ok(())
            }
            (Some(pull), _) => self.take(pull),
            (None, Some(_)) => {
                self.hold = None;
                self.performance.hold(Vec::new());
                self.prepare(&self.design.clone())
            }
            (None, None) => Ok(()),
        }
    }

    fn take(&mut self, pull: Pull) -> Result<(), StageError> {
        let Some(&place) = self.positions.get(pull.particle as usize) else {
            return Ok(());
        };
        let production = self.performance.shared_production();
        let sewn = production.dressed.iter();
        let sewn = sewn.flat_map(|garment| garment.dressed.pinned().iter().copied());
        let strands = production.adornments.iter().flat_map(Adornment::pinned);
        let gathered = self.specs.iter().flat_map(|spec| &spec.pinned).copied();
        let pinned = gathered.chain(sewn).chain(strands);
        let patch: Vec<(u32, Vec3)> = (0..)
            .zip(self.positions.iter().zip(pinned))
            .filter(|(_, (position, pinned))| !*pinned && position.distance(place) < HAND_RADIUS)
            .map(|(particle, (&position, _))| (particle, position - place))
            .collect();
        if patch.is_empty() {
            return Ok(());
        }
        self.hold = Some(Hold { pull, place, patch });
        let taken = self.prepare(&self.design.clone());
        if taken.is_err() {
            self.hold = None;
        }
        self.place_held();
        taken
    }

    /// Prepares the cloth anew for the method of `design`: as it hangs and moves, in its fabric, with
    /// what is held.
    fn prepare(&mut self, design: &Design) -> Result<(), StageError> {
        let production = self.performance.shared_production();
        let mut specs = self.specs.clone();
        for (spec, fabric) in specs.iter_mut().zip(design.worn_fabrics()) {
            spec.fabric = fabric;
        }
        let held = self.hold.iter().flat_map(|hold| &hold.patch);
        let held: Vec<usize> = held.map(|&(particle, _)| particle as usize).collect();
        let mut solvers = Vec::with_capacity(specs.len());
        for (spec, garment) in specs.iter().zip(&production.garments) {
            let own = garment.particles.clone();
            let mut pinned = spec.clone();
            for particle in held.iter().filter(|&particle| own.contains(particle)) {
                pinned.pinned[particle - own.start] = true;
            }
            let mut solver = Solver::new(
                design,
                (&pinned, garment.rows),
                &self.positions[own.clone()],
            )?;
            solver.edit_velocities(|kept| kept.copy_from_slice(&self.velocities[own]));
            solvers.push(solver);
        }
        let held = self.hold.iter().flat_map(|hold| &hold.patch);
        let held: Vec<u32> = held.map(|&(particle, _)| particle).collect();
        self.performance.take(&held)?;
        self.performance.replace_solvers(solvers);
        self.masses = masses(&specs, &production);
        self.specs = specs;
        Ok(())
    }

    /// Moves the fingers towards the hand by one frame.
    fn move_hand(&mut self) {
        if let Some(hold) = &mut self.hold {
            let way = hold.pull.hand - hold.place;
            hold.place += way.clamp_length_max(HAND_SPEED * FRAME_SECONDS);
        }
        self.place_held();
    }

    fn place_held(&mut self) {
        if let Some(hold) = &self.hold {
            let held = hold.patch.iter();
            let held = held.map(|&(particle, offset)| (particle, hold.place + offset));
            self.performance.hold(held.collect());
        }
    }

    /// Moves dancer and cloth on by one frame; a stopped show stays as it is.
    ///
    /// # Errors
    /// The first particle that left the stage, with time and place.
    pub fn advance(&mut self) -> Result<(), Divergence> {
        if let Some(divergence) = self.stopped {
            return Err(divergence);
        }
        let dances = 0.0 <= self.performance.time();
        for layer in &mut self.layers {
            let dt = 1.0 / f64::from(FRAMES_PER_SECOND);
            layer.time += if dances { dt } else { 0.0 };
            layer.age += dt;
        }
        let covered = |layer: &Layer| EASE_SECONDS <= layer.age;
        let bottom = self.layers.iter().rposition(covered).unwrap_or(0);
        self.layers.drain(..bottom);
        self.move_hand();
        let pose = self.pose();
        match self.performance.advance_in(pose) {
            Ok(()) => {
                let now = self.performance.particles();
                for ((velocity, before), &after) in
                    (self.velocities.iter_mut().zip(&mut self.positions)).zip(now)
                {
                    *velocity = (after - *before) / FRAME_SECONDS;
                    *before = after;
                }
                Ok(())
            }
            Err(divergence) => {
                self.stopped = Some(divergence);
                Err(divergence)
            }
        }
    }

    /// Lets the skirt settle until the dance begins.
    ///
    /// # Errors
    /// As [`Self::advance`].
    pub fn settle(&mut self) -> Result<(), Divergence> {
        while self.time() < 0.0 {
            self.advance()?;
        }
        Ok(())
    }

    /// The bones so much later in the dance [s], as [`Performance::bones_after`] has them.
    #[must_use]
    pub fn bones_after(&self, seconds: f32) -> Vec<Affine3A> {
        let skeleton = &self.performance.production().dancer.skeleton;
        skeleton.world_from_bind(&self.pose_after(seconds))
    }

    fn pose(&self) -> Pose {
        self.pose_after(0.0)
    }

    fn pose_after(&self, seconds: f32) -> Pose {
        let mut layers = self.layers.iter();
        let mut pose = layers.next().map_or_else(Pose::default, |layer| {
            layer.dance.pose_at(narrow(layer.time) + seconds)
        });
        for layer in layers {
            let share = narrow((layer.age / EASE_SECONDS).clamp(0.0, 1.0));
            let share = share * share * (3.0 - 2.0 * share);
            let other = layer.dance.pose_at(narrow(layer.time) + seconds);
            pose = between(&pose, &other, share);
        }
        pose
    }

    /// What is done about cloth that has gone through itself, from the next frame on; what the design
    /// says unless it is said here.
    pub const fn set_crossings(&mut self, crossings: Crossings) {
        self.performance.set_crossings(crossings);
    }

    /// The last good positions of gathered cloth [m], row-major, of one garment after the other.
    #[must_use]
    pub fn cloth_positions(&self) -> &[Vec3] {
        &self.positions[..self.performance.production().particle_count()]
    }

    /// The last good positions of everything that moves by itself [m]: of gathered cloth, then of what is sewn
    /// from shaped pieces, then of strands.
    #[must_use]
    pub fn particles(&self) -> &[Vec3] {
        &self.positions
    }

    /// Everything that is worn or held as it is drawn, surface by surface as [`Production::surfaces`] has them.
    #[must_use]
    pub fn surfaces(&self) -> Vec<Vertices> {
        self.performance.surfaces_of(self.cloth_positions())
    }

    /// The capsules now.
    #[must_use]
    pub fn capsules(&self) -> &[Capsule] {
        self.performance.capsules()
    }

    /// How her open hair swings; nothing of other hair.
    #[must_use]
    pub fn swing(&self) -> Swing {
        self.performance.swing()
    }

    /// Skin transforms of the present pose, by bone.
    #[must_use]
    pub fn world_from_bind(&self) -> &[Affine3A] {
        self.performance.world_from_bind()
    }

    /// Parts of the body beside which the dance leaves cloth no room now.
    #[must_use]
    pub fn without_room(&self) -> Vec<Bone> {
        self.performance.without_room()
    }

    /// Substeps of the next frame, most of any garment.
    #[must_use]
    pub fn substep_count(&self) -> u32 {
        self.performance.substep_count()
    }

    /// The part of the choreography that is danced now; `None` before the first and after the last
    /// one, and where there are none.
    #[must_use]
    pub fn part(&self) -> Option<PartNow> {
        let layer = self.layers.last()?;
        part_at(&layer.dance, &self.design.motion.parts, layer.time)
    }

    /// How long the recording is that is danced [s], if it is one.
    #[must_use]
    pub fn recording_seconds(&self) -> Option<f32> {
        match &self.layers.last()?.dance {
            Danced::Step(_) => None,
            recording @ Danced::Recording(_) => Some(recording.period()),
        }
    }

    /// Springs of all families.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        self.performance.spring_count()
    }

    /// The cloth's figures now.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a skirt has 512 columns")]
    pub fn vitals(&self) -> Vitals {
        let hem = (self.performance.production().skirt()).map_or(&[][..], |skirt| {
            let columns = skirt.sewn.spec.grid.column_count as usize;
            let positions = &self.positions[skirt.particles.clone()];
            &positions[positions.len().saturating_sub(columns)..]
        });
        let middle = hem.iter().sum::<Vec3>() / hem.len().max(1) as f32;
        let gravity = self.performance.gravity();
        let (mut kinetic, mut potential) = (0.0, 0.0);
        for ((&mass, velocity), position) in
            (self.masses.iter().zip(&self.velocities)).zip(&self.positions)
        {
            kinetic += 0.5 * mass * velocity.length_squared();
            potential -= mass * gravity.dot(*position);
        }
        Vitals {
            kinetic_energy: kinetic,
            potential_energy: potential,
            elastic_energy: (self.performance.energy())
                .map(|energy| narrow(energy.springs + energy.bending)),
            hem_height: self.performance.hem_height(),
            hem_middle: [middle.x, middle.z],
        }
    }

    /// Strain at each particle of [`Self::particles`], positive where it is stretched: of gathered cloth the mean
    /// of its structural springs, `length / rest_length - 1`, of strands that of the ways to their neighbors; of
    /// what is sewn the stretch of its triangles, 0 where they are pushed together.
    #[must_use]
    pub fn strain(&self) -> Vec<f32> {
        let production = self.performance.production();
        let gathered = self.specs.iter().zip(&production.garments);
        let gathered = gathered.flat_map(|(spec, garment)| {
            diagnose::strain_by_particle(spec, &self.positions[garment.particles.clone()])
        });
        let sewn = production.dressed.iter().flat_map(|garment| {
            let own = &self.positions[garment.particles.clone()];
            garment.dressed.strain_by_particle(own)
        });
        let strands = production
            .adornments
            .iter()
            .flat_map(|adornment| adornment.strain(&self.positions[adornment.particles.clone()]));
        gathered.chain(sewn).chain(strands).collect()
    }

    /// Particles below the drawn skin, given its posed vertices and normals.
    #[must_use]
    pub fn sunken(&self, body_positions: &[Vec3], body_normals: &[Vec3]) -> Vec<Vec3> {
        let production = self.performance.production();
        let body = CheckedSurface {
            positions: body_positions,
            normals: body_normals,
            triangles: &production.body_triangles,
        };
        let cloths = production.worn().filter_map(|worn| {
            let triangles = match worn {
                Worn::Gathered(garment) => &garment.mesh.particle_triangles,
                Worn::Sewn(garment) => &garment.dressed.open_triangles,
                Worn::Beside(_) => return None,
            };
            let positions = &self.positions[worn.particles()];
            Some(CheckedSurface {
                positions,
                normals: &[],
                triangles,
            })
        });
        let sunken = cloths.flat_map(|cloth| {
            let sunken = skin_check::sunken(body, cloth).into_iter();
            sunken.map(move |vertex| cloth.positions[vertex as usize])
        });
        sunken.collect()
    }

    /// Ends of each bone that has a parent, in the world [m].
    #[must_use]
    pub fn bones(&self) -> Vec<[Vec3; 2]> {
        let skeleton = &self.performance.production().dancer.skeleton;
        let joint = |bone: Bone| {
            self.world_from_bind()[bone.index()].transform_point3(skeleton.joint(bone))
        };
        Bone::ALL
            .iter()
            .filter_map(|&bone| Some([joint(bone.parent()?), joint(bone)]))
            .collect()
    }
}

/// Of the particles of all cloth [kg].
fn masses(specs: &[ClothSpec], production: &Production) -> Vec<f32> {
    let sewn = production.dressed.iter();
    let sewn = sewn.flat_map(|garment| garment.dressed.masses());
    let strands = production.adornments.iter().flat_map(Adornment::masses);
    let gathered = specs.iter().flat_map(particle_masses);
    gathered.chain(sewn).chain(strands).collect()
}

/// What is worn or held beside the cloth.
fn adornments(design: &Design) -> Vec<&GarmentDesign> {
    let garments = design.garments.iter();
    garments.filter(|it| it.is_adornment()).collect()
}

/// Whether cloth must be sewn anew on the way from one design to the other.
fn needs_sewing(old: &Design, new: &Design) -> bool {
    let cut = |design: &Design| {
        // What is only drawn or woven otherwise needs no needle.
        let mut garments = design.garments.clone();
        // What is only drafted needs none either.
        garments.retain(|it| it.is_danced() || it.is_dressed());
        for garment in garments.iter_mut().filter(|it| it.is_danced()) {
            garment.fabric = FabricDesign::default();
            garment.print = PrintChoice::default();
        }
        // What is dressed is fitted in its own fabric.
        for garment in garments.iter_mut().filter(|it| it.is_dressed()) {
            garment.print = PrintChoice::default();
        }
        // What was taken for drafting cuts what is sewn of pieces, and no body.
        let tailor_tape = if garments.iter().any(GarmentDesign::is_dressed) {
            design.dancer.tailor_tape
        } else {
            TailorTape::NONE
        };
        // Face, hair and colors are not in the way of cloth.
        let dancer = DancerDesign {
            tailor_tape,
            hair: HairStyle::default(),
            makeup: Makeup::default(),
            age_years: None,
            skin_color: None,
            hair_color: None,
            leotard_color: None,
            ..design.dancer.clone()
        };
        let is_altered = garments.iter().any(|it| it.template.is_fitted());
        let alterations = if is_altered {
            design.alterations
        } else {
            Alterations::NONE
        };
        (dancer, alterations, design.skirt.clone(), garments)
    };
    cut(old) != cut(new)
}

/// The part of a choreography that is danced at `time` [s].
fn part_at(dance: &Danced, parts: &[PartDesign], time: f64) -> Option<PartNow> {
    let begun = dance.beat_at(f64::from(dance.lead_in()))?;
    let mut danced = dance.beat_at(time)? - begun;
    if danced < 0.0 {
        return None;
    }
    for (index, part) in parts.iter().enumerate() {
        let counts = f64::from(part.beat_count);
        if danced < counts {
            let share = narrow(danced / counts);
            return Some(PartNow { index, share });
        }
        danced -= counts;
    }
    None
}

/// A motion but for its tempo and length, and for what of its parts is no step of one dancer.
struct MotionOfTempo<'a>(&'a lole_costume::document::MotionDesign);

impl PartialEq for MotionOfTempo<'_> {
    fn eq(&self, other: &Self) -> bool {
        let mut motion = self.0.clone();
        motion.tempo_bpm = other.0.tempo_bpm;
        motion.duration_s = other.0.duration_s;
        for (part, other) in motion.parts.iter_mut().zip(&other.0.parts) {
            (part.formation, part.mood) = (other.formation, other.mood);
        }
        motion == *other.0
    }
}

/// The pose a `share` of the way from `from` to `to`.
fn between(from: &Pose, to: &Pose, share: f32) -> Pose {
    Pose {
        hips_translation: from.hips_translation.lerp(to.hips_translation, share),
        rotations: (from.rotations.iter().zip(&to.rotations))
            .map(|(&from, &to)| from.lerp(to, share))
            .collect(),
    }
}

#[cfg(test)]
mod tests;
