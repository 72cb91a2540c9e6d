//! A performance: one dancer, what she wears, one dance, moved on frame by frame.

mod adornment;
mod covering;
mod drawn;
mod dressed;
mod figures;
mod forearms;
mod hair;
mod jump;
mod no_room;
mod order;
mod over_cloth;
mod pressed;
mod worn;

pub use covering::{GarmentLayers, LayerWatch};
pub use figures::Energy;
pub(crate) use forearms::Forearms;
pub use no_room::{NoRoom, no_room_now};

use std::ops::Range;
use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3};
use lole_body::{BodyCapsule, Bone, Pose, Swing};
use lole_cloth::awake::keep_awake;
use lole_cloth::collision::layer::Press;
use lole_cloth::method::explicit::ExplicitConfig;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::wind::GustyWind;
use lole_cloth::{Crossings, InstructionSet, Phase};
use lole_costume::document::{BodyShapes, Design, GarmentLayer};
use lole_geom::{Capsule, Surfel};

use crate::StageError;
use crate::danced::Danced;
use crate::production::{DressedGarment, Garment, Production};
use crate::solver::{self, Observer, Solver, Surroundings};
use adornment::{Adorned, AroundStrands};
use dressed::{Around, Dressed};
use hair::{AroundHair, Hair};
use jump::{Hips, Jump};
use order::Order;
use worn::{Carrier, Worn};

/// Steps of the simulation per second: one for every picture of an ordinary screen.
pub const FRAMES_PER_SECOND: u32 = 60;

/// Frames the cloth hangs down in the stance before the dance starts, at most: three seconds. The
/// real-time method brings it to rest in about two thirds of them.
const SETTLE_FRAMES: u32 = 3 * FRAMES_PER_SECOND;
/// The first of them, in which cloth that the paper's methods move is lowered by hand instead of
/// dropped: a fall would lay its folds flat on each other.
const LOWERING_FRAMES: u32 = 100;
/// Least frames that dressed garments hang before the dance, where there are some.
const DRESSED_FRAMES: i64 = 30;
/// Share of its velocity that the cloth keeps from frame to frame while it is lowered.
const LOWERING: f32 = 0.6;

/// Duration of one frame [s].
pub const FRAME_SECONDS: f32 = 1.0 / FRAMES_PER_SECOND as f32;

/// Cloth that is further than this from the origin [m] has left the stage: the run has diverged.
const STAGE_RADIUS: f32 = 100.0;

/// Where and when the cloth stopped being cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// Time of the dance [s]; negative while settling.
    pub time: f32,
    /// Place among all that is worn, as [`Production::worn`] has it.
    pub garment: usize,
    /// Row and column, there, of the first particle that left.
    pub row: u32,
    /// See `row`.
    pub column: u32,
}

/// The same production with other adornments, and what moves of them.
pub(crate) struct NewlyAdorned(Arc<Production>, Adorned);

/// A production on stage. Clones share the production.
#[derive(Clone)]
pub struct Performance {
    production: Arc<Production>,
    /// In the order of the production's garments.
    worn: Vec<Worn>,
    /// What moves of the production's adornments.
    adorned: Adorned,
    order: Order,
    /// How what is worn over skirts and tops presses them.
    press: Option<Press>,
    /// In the order of the production's dressed garments.
    dressed: Vec<Dressed>,
    /// The gusts around strands and dressed garments; `None` where the wind has none.
    gusts: Option<GustyWind>,
    /// The skin with all of the arms, which sleeves meet; empty where nothing is dressed.
    whole_skin: Vec<Surfel>,
    pose: Pose,
    world_from_bind: Vec<Affine3A>,
    /// What the cloth meets as a body: the dancer's capsules, unless others were given.
    body_capsules: Vec<BodyCapsule>,
    /// Whether it meets the skin instead.
    meets_skin: bool,
    crossings: Crossings,
    capsules: Vec<Capsule>,
    /// Particles that a hand holds besides, ascending, and where it has them [m].
    held: Vec<(u32, Vec3)>,
    /// Of all garments.
    cloth_positions: Vec<Vec3>,
    body_positions: Vec<Vec3>,
    body_normals: Vec<Vec3>,
    surfels: Vec<Surfel>,
    /// Of the forearms, those too that touch nothing.
    forearm_skin: Vec<Surfel>,
    no_room: Vec<NoRoom>,
    /// Her hair, where it is open.
    hair: Hair,
    /// Where her hips are, `None` before the first frame.
    hips: Option<Hips>,
    /// Frames danced; negative while settling.
    frame: i64,
}

impl Performance {
    /// Puts a production on stage: the dancer in her stance, the skirt where its drape starts,
    /// at most [`Self::settle_frame_count`] frames before the dance.
    ///
    /// # Errors
    /// A skirt the chosen method cannot be prepared for.
    pub fn new(production: impl Into<Arc<Production>>) -> Result<Self, StageError> {
        let production = production.into();
        let skeleton = &production.dancer.skeleton;
        let world_from_bind = skeleton.world_from_bind(&production.dance.pose_at(0.0));
        let mut performance = Self {
            body_capsules: production.dancer.capsules.clone(),
            meets_skin: production.design.contact_body() == BodyShapes::Skin,
            crossings: production.design.crossings(),
            dressed: production.dressed.iter().map(Dressed::new).collect(),
            adorned: Adorned::default(),
            gusts: solver::gusts(&production.design),
            press: pressed::press(&production),
            production,
            order: Order::default(),
            whole_skin: Vec::new(),
            worn: Vec::new(),
            pose: Pose::default(),
            world_from_bind,
            capsules: Vec::new(),
            held: Vec::new(),
            cloth_positions: Vec::new(),
            body_positions: Vec::new(),
            body_normals: Vec::new(),
            surfels: Vec::new(),
            forearm_skin: Vec::new(),
            no_room: Vec::new(),
            hair: Hair::default(),
            hips: None,
            frame: -i64::from(SETTLE_FRAMES),
        };
        let pose = performance.pose_of_dance();
        performance.pose_dancer(pose.clone());
        performance.worn = (performance.production.garments.iter())
            .map(|garment| {
                Worn::new(
                    &performance.production.design,
                    garment,
                    &performance.carrier(),
                )
            })
            .collect::<Result<Vec<_>, _>>()?;
        look(&performance.worn, &mut performance.cloth_positions);
        performance.adorned = Adorned::new(
            &performance.production,
            &performance.world_from_bind,
            (&performance.cloth_positions, &performance.dressed_cloth()),
        )?;
        performance.pose_dancer(pose);
        Ok(performance)
    }

    /// What is performed.
    #[must_use]
    pub fn production(&self) -> &Production {
        &self.production
    }

    /// What is performed, to be kept by others too.
    #[must_use]
    pub fn shared_production(&self) -> Arc<Production> {
        Arc::clone(&self.production)
    }

    /// Frames the cloth hangs down in the stance before the dance starts, at most: once it is at
    /// rest, [`Self::time`] goes to zero.
    #[must_use]
    pub const fn settle_frame_count() -> u32 {
        SETTLE_FRAMES
    }

    /// Time of the dance [s]; negative while settling.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "ten minutes are 36,000 frames")]
    pub fn time(&self) -> f32 {
        self.frame as f32 * FRAME_SECONDS
    }

    /// Moves dancer and cloth on by one frame: the part that must run in real time.
    ///
    /// # Errors
    /// The first particle that left the stage, with time and place.
    pub fn advance(&mut self) -> Result<(), Divergence> {
        self.frame += 1;
        let pose = self.pose_of_dance();
        keep_awake(|| self.step_in(pose, None))
    }

    /// The same, bit for bit, and `passed` is called whenever a [`Phase`] of the real-time method
    /// has ended; other methods have none.
    ///
    /// # Errors
    /// As [`Self::advance`].
    pub fn advance_observed(&mut self, passed: &mut dyn FnMut(Phase)) -> Result<(), Divergence> {
        self.frame += 1;
        let pose = self.pose_of_dance();
        self.step_in(pose, Some(passed))
    }

    /// The same with the dancer in a pose of the caller's instead of her dance's.
    pub(crate) fn advance_in(&mut self, pose: Pose) -> Result<(), Divergence> {
        self.frame += 1;
        keep_awake(|| self.step_in(pose, None))
    }

    /// Lets her walk in the parts of her choreography, as [`Danced::walking`] has it; to be said before she dances.
    ///
    /// # Errors
    /// A way that the feet do not carry her in a part.
    pub fn walk(&mut self, ways: &[Vec2]) -> Result<(), StageError> {
        let danced = Danced::walking(&self.production.design, &self.production.dancer, ways)?;
        Arc::make_mut(&mut self.production).dance = danced;
        Ok(())
    }

    /// The adornments of another design, which has the same cloth, come down on her and her cloth as both
    /// are now; [`Self::adorn`] puts them on.
    pub(crate) fn adorned_as(&self, design: &Design) -> Result<NewlyAdorned, StageError> {
        let production = self.production.with_adornments(design)?;
        let worn = (&self.cloth_positions[..], &self.dressed_cloth()[..]);
        let adorned = Adorned::new(&production, &self.world_from_bind, worn)?;
        Ok(NewlyAdorned(Arc::new(production), adorned))
    }

    /// Lets her wear them from the next frame on.
    pub(crate) fn adorn(&mut self, NewlyAdorned(production, adorned): NewlyAdorned) {
        (self.production, self.adorned) = (production, adorned);
    }

    /// Lets other methods go on with the cloth as it is: one for each garment.
    pub(crate) fn replace_solvers(&mut self, solvers: Vec<Solver>) {
        for (worn, solver) in self.worn.iter_mut().zip(solvers) {
            worn.solver = solver;
        }
    }

    /// Lets the cloth meet other capsules from the next frame on.
    pub(crate) fn replace_capsules(&mut self, capsules: Vec<BodyCapsule>) {
        self.body_capsules = capsules;
    }

    /// Lets the cloth meet body and itself as `design` says, from the next frame on.
    pub(crate) fn set_contact_of(&mut self, design: &Design) {
        self.meets_skin = design.contact_body() == BodyShapes::Skin;
        self.crossings = design.crossings();
    }

    /// Lets a hand hold these particles of strands and of what is sewn from shaped pieces, and no others of
    /// them: ascending, by the numbers of everything that moves. Gathered cloth is held by [`Self::replace_solvers`].
    ///
    /// # Errors
    /// A seam that cannot be made with them; what was held before may be let go then.
    pub(crate) fn take(&mut self, particles: &[u32]) -> Result<(), StageError> {
        for (moving, garment) in self.dressed.iter_mut().zip(&self.production.dressed) {
            let own = particles.iter().filter_map(|&particle| {
                let range = &garment.particles;
                let own = (particle as usize).checked_sub(range.start)?;
                (own < range.len()).then_some(u32::try_from(own).ok()?)
            });
            moving.hold(garment, &own.collect::<Vec<u32>>())?;
        }
        self.adorned.take(&self.production, particles)
    }

    /// Places particles that a hand holds, from the next frame on: ascending, by the numbers of everything that moves,
    /// and pinned in the solver's cloth or taken by [`Self::take`].
    pub(crate) fn hold(&mut self, held: Vec<(u32, Vec3)>) {
        self.held = held;
    }

    fn step_in(&mut self, pose: Pose, mut observer: Observer<'_>) -> Result<(), Divergence> {
        self.pose_dancer(pose);
        self.follow_jump();
        let surroundings = Surroundings {
            pin_targets: &[],
            capsules: if self.meets_skin { &[] } else { &self.capsules },
            surfels: if self.meets_skin { &self.surfels } else { &[] },
            crossings: self.crossings,
            time: self.time(),
        };
        let trunk = order::trunk(&self.production.dancer.skeleton, &self.world_from_bind);
        let around = Around {
            trunk,
            world_from_bind: &self.world_from_bind,
            body: (&self.body_positions, &self.body_normals),
            skin: &self.whole_skin,
            air_velocity: self.air_velocity(),
            held: &self.held,
            is_settling: self.frame <= 0,
        };
        let pairs = || self.production.dressed.iter();
        let is_under = |garment: &DressedGarment| garment.layer == GarmentLayer::Under;
        let all = (&mut self.dressed[..], &self.production.dressed[..]);
        dressed::step_layer(all, GarmentLayer::Under, (&around, &[]), &mut observer);
        let inner: Vec<order::Inner<'_>> = (self.dressed.iter().zip(pairs()))
            .filter(|(_, garment)| is_under(garment))
            .map(|(dressed, garment)| {
                let triangles = &garment.dressed.hanging_triangles[..];
                (triangles, dressed.positions())
            })
            .filter(|(triangles, _)| !triangles.is_empty())
            .collect();
        let worn = (&mut self.worn[..], &self.production.garments[..]);
        self.order
            .step((trunk, &inner), worn, &surroundings, &mut observer);
        look(&self.worn, &mut self.cloth_positions);
        let hanging = (&self.production.garments[..], &self.cloth_positions[..]);
        let pressed = pressed::flatten((self.press.as_mut(), trunk), hanging);
        let grids = dressed::grids(&self.production.garments, &pressed);
        let grids: Vec<order::Inner<'_>> = grids.collect();
        let all = (&mut self.dressed[..], &self.production.dressed[..]);
        dressed::step_layer(all, GarmentLayer::Over, (&around, &grids), &mut observer);
        let over = (&self.dressed[..], &self.production.dressed[..]);
        pressed::tighten((self.press.as_mut(), trunk), over);
        self.step_adornments();
        self.step_hair();
        if let Some(passed) = observer {
            passed(Phase::Strands);
        }
        self.note_no_room();
        self.settle();
        self.check_stage()
    }

    /// Lets cloth go along where her hips change their speed in a frame as no dancer does, because a
    /// recording jumps.
    fn follow_jump(&mut self) {
        let skeleton = &self.production.dancer.skeleton;
        let bind = skeleton.joint(Bone::Hips);
        let now = self.world_from_bind[Bone::Hips.index()].transform_point3(bind);
        let Some(Jump { by, faster }) = Hips::follow(&mut self.hips, now) else {
            return;
        };
        for worn in &mut self.worn {
            worn.solver.carry(by, faster);
        }
        for dressed in &mut self.dressed {
            dressed.carry(by, faster);
        }
    }

    fn step_adornments(&mut self) {
        if !self.adorned.has_strands() {
            return;
        }
        let mut adorned = std::mem::take(&mut self.adorned);
        let around = AroundStrands {
            world_from_bind: &self.world_from_bind,
            surfels: &self.surfels,
            cloth: &self.cloth_positions,
            dressed: &self.dressed_cloth(),
            air_velocity: self.air_velocity(),
            held: &self.held,
        };
        adorned.step(&self.production, &around);
        self.adorned = adorned;
    }

    fn step_hair(&mut self) {
        let Some(drawn) = &self.production.dancer.drawn_body else {
            return;
        };
        if drawn.open_hair.knots.is_empty() {
            return;
        }
        let dressed = self.dressed.iter().map(Dressed::positions);
        let cloth: Vec<&[Vec3]> = dressed.chain([&self.cloth_positions[..]]).collect();
        let around = AroundHair {
            world_from_bind: &self.world_from_bind,
            gravity: self.gravity(),
            air_velocity: self.air_velocity(),
            cloth: &cloth,
        };
        self.hair.step(&drawn.open_hair, &around);
    }

    /// Velocity of the air around strands and garments sewn from shaped pieces [m/s]: the wind's, with
    /// the gust that is at the dancer's hips.
    fn air_velocity(&self) -> Vec3 {
        let wind = self.production.design.wind.velocity();
        let time = f64::from(self.time());
        let steady = wind.force(time).as_vec3();
        let Some(gusts) = &self.gusts else {
            return steady;
        };
        let trunk = order::trunk(&self.production.dancer.skeleton, &self.world_from_bind);
        gusts.at(time).with_mean(steady).velocity(trunk.axis)
    }

    /// Triangles of the garments sewn from shaped pieces, and where they are [m].
    fn dressed_cloth(&self) -> Vec<order::Inner<'_>> {
        let garments = self.production.dressed.iter().zip(&self.dressed);
        garments
            .map(|(garment, moving)| (&garment.dressed.triangles[..], moving.positions()))
            .collect()
    }

    /// Damps the cloth before the dance, which begins when all of it is at rest.
    fn settle(&mut self) {
        let is_dressed_alone = self.frame < 0
            && self.worn.is_empty()
            && !self.dressed.is_empty()
            && !self.adorned.has_strands();
        if !is_dressed_alone && !self.worn.iter().any(Worn::is_settling) {
            if self.frame <= i64::from(LOWERING_FRAMES) - i64::from(SETTLE_FRAMES) {
                for worn in &mut self.worn {
                    worn.solver.scale_velocities(LOWERING);
                }
            }
            return;
        }
        // Dressed garments have come to rest on her already; with the skirt they take as long as that.
        let mut all_rest =
            self.dressed.is_empty() || DRESSED_FRAMES <= self.frame + i64::from(SETTLE_FRAMES);
        for (worn, garment) in self.worn.iter_mut().zip(&self.production.garments) {
            all_rest &= worn.settle(&self.cloth_positions[garment.particles.clone()]);
        }
        if all_rest {
            self.worn.iter_mut().for_each(Worn::let_go);
            self.frame = 0;
        }
    }

    /// The bones so much later in the dance [s]: a hand that is raised then is looked at before.
    #[must_use]
    pub fn bones_after(&self, seconds: f32) -> Vec<Affine3A> {
        let pose = (self.production.dance).pose_at((self.time() + seconds).max(0.0));
        self.production.dancer.skeleton.world_from_bind(&pose)
    }

    fn pose_of_dance(&self) -> Pose {
        self.production.dance.pose_at(self.time().max(0.0))
    }

    fn pose_dancer(&mut self, mut pose: Pose) {
        adornment::grip(&self.production, &mut pose);
        self.pose = pose;
        self.world_from_bind = self.production.dancer.skeleton.world_from_bind(&self.pose);
        self.capsules = (self.body_capsules.iter())
            .map(|capsule| capsule.posed(&self.world_from_bind))
            .collect();
        self.surfels.clear();
        if self.meets_skin || !self.dressed.is_empty() || self.adorned.has_strands() {
            self.production.dancer.skin.pose(
                &self.world_from_bind,
                &mut self.body_positions,
                &mut self.body_normals,
            );
            self.production.body_surfels.pose(
                &self.body_positions,
                &self.body_normals,
                &mut self.surfels,
            );
            if !self.dressed.is_empty() {
                self.whole_skin.clone_from(&self.surfels);
            }
            (self.production.forearms).copy_whole(&self.surfels, &mut self.forearm_skin);
            (self.production.forearms).withdraw(&self.capsules, &mut self.surfels);
        }
        let mut worn = std::mem::take(&mut self.worn);
        for (worn, garment) in worn.iter_mut().zip(&self.production.garments) {
            worn.place_pins(
                garment,
                &self.carrier(),
                &held_in(&garment.particles, &self.held),
            );
        }
        self.worn = worn;
    }

    /// The body in the present pose.
    fn carrier(&self) -> Carrier<'_> {
        let skin = (&self.body_positions[..], &self.body_normals[..]);
        Carrier {
            world_from_bind: &self.world_from_bind,
            skin: self.meets_skin.then_some(skin),
            surfels: if self.meets_skin { &self.surfels } else { &[] },
            forearms: if self.meets_skin {
                &self.forearm_skin
            } else {
                &[]
            },
            triangles: &self.production.body_triangles,
        }
    }

    fn check_stage(&self) -> Result<(), Divergence> {
        let (gathered, sewn) = (self.worn.len(), self.dressed.len());
        let lost = (self.worn.iter().position(Worn::is_lost))
            .or_else(|| Some(gathered + self.dressed.iter().position(Dressed::is_lost)?))
            .or_else(|| Some(gathered + sewn + self.adorned.lost()?));
        if let Some(garment) = lost {
            return Err(Divergence {
                time: self.time(),
                garment,
                row: 0,
                column: 0,
            });
        }
        let left = |position: &Vec3| {
            !position.is_finite() || STAGE_RADIUS * STAGE_RADIUS < position.length_squared()
        };
        let Some(first) = self.cloth_positions.iter().position(left) else {
            return Ok(());
        };
        let garments = &self.production.garments;
        let holds = |garment: &Garment| garment.particles.contains(&first);
        let index = garments.iter().position(holds).unwrap_or(0);
        let particle = first - garments[index].particles.start;
        let columns = garments[index].sewn.spec.grid.column_count as usize;
        let place = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        let (row, column) = (place(particle / columns), place(particle % columns));
        Err(Divergence {
            time: self.time(),
            garment: index,
            row,
            column,
        })
    }

    /// Places the skin in the current pose: for checks and cameras, not for the cloth; what is drawn is another body.
    pub fn pose_body(&mut self) {
        let skin = &self.production.dancer.skin;
        skin.pose(
            &self.world_from_bind,
            &mut self.body_positions,
            &mut self.body_normals,
        );
    }

    /// Positions of the particles [m], row-major, of one garment after the other.
    #[must_use]
    pub fn cloth_positions(&self) -> &[Vec3] {
        &self.cloth_positions
    }

    /// Positions of the particles of one garment [m], row-major.
    #[must_use]
    pub fn garment_positions(&self, garment: &Garment) -> &[Vec3] {
        &self.cloth_positions[garment.particles.clone()]
    }

    /// Posed vertices of the skin [m]; call [`Self::pose_body`] first.
    #[must_use]
    pub fn body_positions(&self) -> &[Vec3] {
        &self.body_positions
    }

    /// Posed unit normals of the skin.
    #[must_use]
    pub fn body_normals(&self) -> &[Vec3] {
        &self.body_normals
    }

    /// Particles [m] of the strands of each adornment that has some, one strand after the other.
    pub fn strand_positions(&self) -> impl Iterator<Item = &[Vec3]> {
        self.adorned.positions()
    }

    /// The dancer's current pose.
    #[must_use]
    pub const fn pose(&self) -> &Pose {
        &self.pose
    }

    /// Skin transforms of the current pose, by bone.
    #[must_use]
    pub fn world_from_bind(&self) -> &[Affine3A] {
        &self.world_from_bind
    }

    /// How her open hair swings; nothing of other hair.
    #[must_use]
    pub fn swing(&self) -> Swing {
        self.hair.swing()
    }

    /// The capsules that the cloth meets: none where it meets the skin.
    fn met_capsules(&self) -> &[Capsule] {
        if self.meets_skin { &[] } else { &self.capsules }
    }

    /// The capsules of the current pose.
    #[must_use]
    pub fn capsules(&self) -> &[Capsule] {
        &self.capsules
    }

    /// Model and settings of the paper's methods, which move one garment; `None` for `xpbd`.
    #[must_use]
    pub fn explicit(&self) -> Option<(&ReferenceModel, &ExplicitConfig)> {
        let explicit = self.worn.first()?.solver.explicit()?;
        Some((&explicit.model, &explicit.config))
    }

    /// Changes the settings of the paper's methods from the next frame on; nothing for `xpbd`.
    pub fn tune_explicit(&mut self, mut change: impl FnMut(&ReferenceModel, &mut ExplicitConfig)) {
        for worn in &mut self.worn {
            if let Some(explicit) = worn.solver.explicit_mut() {
                change(&explicit.model, &mut explicit.config);
            }
        }
    }

    /// What is done about cloth of `xpbd` that has gone through itself, from the next frame on.
    pub const fn set_crossings(&mut self, crossings: Crossings) {
        self.crossings = crossings;
    }

    /// Vector instructions of `xpbd` from the next frame on; the bits are the same with all.
    pub fn set_instruction_set(&mut self, set: InstructionSet) {
        for worn in &mut self.worn {
            worn.solver.set_instruction_set(set);
        }
    }

    /// Acceleration of free fall [m/s²].
    pub(crate) fn gravity(&self) -> Vec3 {
        let usual = lole_cloth::SolverConfig::default().gravity;
        self.solvers().next().map_or(usual, Solver::gravity)
    }

    /// Substeps of the next frame, most of any garment: more than usual where cloth is strained.
    #[must_use]
    pub fn substep_count(&self) -> u32 {
        let dressed = self.dressed.iter().zip(&self.production.dressed);
        let dressed = dressed.map(|(moving, garment)| moving.substep_count(garment));
        let counts = self.solvers().map(Solver::substep_count).chain(dressed);
        counts.max().unwrap_or(0)
    }

    fn solvers(&self) -> impl Iterator<Item = &Solver> {
        self.worn.iter().map(|worn| &worn.solver)
    }
}

/// Writes the positions of all gathered garments [m] over `positions`.
fn look(worn: &[Worn], positions: &mut Vec<Vec3>) {
    positions.clear();
    for worn in worn {
        worn.add_positions(positions);
    }
}

/// What a hand holds of a garment, by its numbers in that garment.
fn held_in(range: &Range<usize>, held: &[(u32, Vec3)]) -> Vec<(u32, Vec3)> {
    let own = held.iter().filter_map(|&(particle, place)| {
        let own = (particle as usize).checked_sub(range.start)?;
        (own < range.len()).then_some((u32::try_from(own).ok()?, place))
    });
    own.collect()
}

#[cfg(test)]
mod tests;
