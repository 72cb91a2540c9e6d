//! A performance: one dancer, one skirt, one dance, moved on frame by frame.

use std::sync::Arc;

use glam::{Affine3A, Vec3};
use lole_body::motion::Dance;
use lole_body::{BodyCapsule, CapsuleLayout, Dancer, Measurements, Pose, SkinSurfels};
use lole_cloth::method::explicit::ExplicitConfig;
use lole_cloth::method::reference::ReferenceModel;
use lole_cloth::method::settle::{SettleConfig, Settling};
use lole_cloth::{Crossings, Fabric, InstructionSet, Phase, diagnose};
use lole_costume::document::{BodyShapes, Design};
use lole_costume::sew::{self, SewSettings, SewnSkirt, SkirtMesh};
use lole_geom::{Capsule, Length, Surfel, mesh::vertex_normals};
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements, draft_pau_skirt};

use crate::solver::{Observer, Solver, Surroundings};
use crate::{FrameMetrics, StageError, skin_check};

/// Steps of the simulation per second: one for every picture of an ordinary screen.
pub const FRAMES_PER_SECOND: u32 = 60;

/// Frames the cloth hangs down in the stance before the dance starts, at most: three seconds. The
/// real-time method brings it to rest in about two thirds of them.
const SETTLE_FRAMES: u32 = 3 * FRAMES_PER_SECOND;
/// The first of them, in which cloth that the paper's methods move is lowered by hand instead of
/// dropped: a fall would lay its folds flat on each other.
const LOWERING_FRAMES: u32 = 100;
/// Share of its velocity that the cloth keeps from frame to frame while it is lowered.
const LOWERING: f32 = 0.6;

/// Duration of one frame [s].
pub const FRAME_SECONDS: f32 = 1.0 / FRAMES_PER_SECOND as f32;

/// Cloth that is further than this from the origin [m] has left the stage: the run has diverged.
const STAGE_RADIUS: f32 = 100.0;

/// Farthest that the tape of an elastic row is from the skin below it [m]: across the small of the
/// back and between the buttocks.
const PIN_REACH: f32 = 0.08;

/// Least distance of an elastic row from the skin [m]: half the thickness of what is sewn there.
const PIN_CLEARANCE: f32 = 0.001;

/// Farthest that surfels of the skin lie apart [m].
const SURFEL_SPACING: f32 = 0.016;

/// Everything about one performance that does not change from frame to frame.
pub struct Production {
    /// What is performed.
    pub design: Design,
    /// The dancer.
    pub dancer: Dancer,
    /// What she dances.
    pub dance: Dance,
    /// The skirt on paper, and what was measured for it.
    pub draft: PauDraft,
    /// Where the skirt is worn.
    pub worn: PauMeasurements,
    /// The skirt in SI units.
    pub fabric: Fabric,
    /// The skirt on the dancer.
    pub skirt: SewnSkirt,
    /// The skirt as it is drawn.
    pub skirt_mesh: SkirtMesh,
    /// Triangles of the closed body surface.
    pub body_triangles: Vec<[u32; 3]>,
    /// The body surface as cloth meets it that meets the skin.
    pub body_surfels: SkinSurfels,
    /// The skin below every pin of the skirt; `None` where one is too far from the body.
    pub pin_surfels: Option<SkinSurfels>,
}

/// Where and when the cloth stopped being cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// Time of the dance [s]; negative while settling.
    pub time: f32,
    /// Row and column of the first particle that left.
    pub row: u32,
    /// See `row`.
    pub column: u32,
}

/// Energy of a cloth [J].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Of motion.
    pub kinetic: f64,
    /// Stored in the springs.
    pub springs: f64,
    /// Stored in bending and twist.
    pub bending: f64,
    /// Of height above the floor.
    pub height: f64,
}

impl Energy {
    /// All of it [J].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.springs + self.bending + self.height
    }
}

/// A production on stage. Clones share the production.
#[derive(Clone)]
pub struct Performance {
    production: Arc<Production>,
    solver: Solver,
    pose: Pose,
    world_from_bind: Vec<Affine3A>,
    /// What the cloth meets as a body: the dancer's capsules, unless others were given.
    body_capsules: Vec<BodyCapsule>,
    /// Whether it meets the skin instead.
    meets_skin: bool,
    crossings: Crossings,
    capsules: Vec<Capsule>,
    pin_targets: Vec<Vec3>,
    /// Particles that a hand holds besides, ascending, and where it has them [m].
    held: Vec<(u32, Vec3)>,
    cloth_positions: Vec<Vec3>,
    body_positions: Vec<Vec3>,
    body_normals: Vec<Vec3>,
    surfels: Vec<Surfel>,
    /// The skin below every pin.
    pin_skin: Vec<Surfel>,
    /// Brings the cloth to rest before the dance; `None` once it is, and for the paper's methods,
    /// whose experiments keep the damping they had.
    settling: Option<Settling>,
    /// Frames danced; negative while settling.
    frame: i64,
}

impl Production {
    /// Measures, drafts and sews a design.
    ///
    /// # Errors
    /// A design whose parts do not fit together.
    pub fn new(design: &Design) -> Result<Self, StageError> {
        let measurements = Measurements::from_tape(&design.tape())?;
        let mut dancer = Dancer::new(&measurements)?;
        let layout = design.capsule_layout();
        if layout != CapsuleLayout::default() {
            dancer.capsules = dancer.fit_capsules(layout);
        }
        let dance = Dance::new(&dancer.skeleton, &design.motion_settings())?;
        let worn = worn_measurements(design, &dancer);
        let draft = draft_pau_skirt(&worn, &design.pau_options()?)?;
        let fabric = design.fabric.fabric();
        let settings = SewSettings {
            column_count: design.skirt.column_count,
            row_count: design.skirt.row_count,
            seed: design.skirt.seed,
            ..SewSettings::default()
        };
        let stance = dancer.skeleton.world_from_bind(&dance.pose_at(0.0));
        let skirt = sew::sew(&draft, &worn, &fabric, &dancer, &stance, &settings)?;
        let skirt_mesh = SkirtMesh::new(&skirt.spec.grid, design.print.print().repeat.to_m_f32());
        let body_triangles = dancer.skin.body_triangles();
        let bind = dancer.skeleton.world_from_bind(&Pose::default());
        let pins = skirt.pins.iter();
        Ok(Self {
            design: design.clone(),
            dance,
            draft,
            worn,
            fabric,
            skirt_mesh,
            body_surfels: SkinSurfels::new(&dancer.skin.positions, &body_triangles, SURFEL_SPACING),
            pin_surfels: SkinSurfels::nearest_to(
                pins.map(|pin| pin.posed(&bind)),
                (&dancer.skin.positions, &body_triangles),
                PIN_REACH,
            ),
            body_triangles,
            dancer,
            skirt,
        })
    }
}

/// Points of the tape that measures the girth where the skirt is worn.
const TAPE_POINTS: usize = 360;

/// What the tape says where the lowest elastic row is worn: at the front points of the hip bones,
/// unless the design says otherwise.
fn worn_measurements(design: &Design, dancer: &Dancer) -> PauMeasurements {
    let height = match design.skirt.worn_height_cm {
        Some(centimeters) => Length::from_cm(centimeters).to_m_f32(),
        None => dancer.landmarks.asis_height,
    };
    let ring = dancer.tape_ring(height, TAPE_POINTS);
    let next = ring.iter().cycle().skip(1);
    let girth: f32 = ring
        .iter()
        .zip(next)
        .map(|(a, b)| a.bind_position.distance(b.bind_position))
        .sum();
    PauMeasurements {
        hip_girth: dancer.measurements.hip_girth,
        worn_girth: Length::from_m(f64::from(girth)),
        worn_height: Length::from_m(f64::from(height)),
    }
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
        let start = production.skirt.start_positions(&world_from_bind);
        let solver = Solver::new(&production.design, &production.skirt.spec, &start)?;
        let settle = SettleConfig {
            dt: FRAME_SECONDS,
            frame_limit: SETTLE_FRAMES,
            ..SettleConfig::default()
        };
        let is_quick = solver.explicit().is_none();
        let mut performance = Self {
            settling: is_quick.then(|| Settling::new(&production.skirt.spec, settle, &start)),
            body_capsules: production.dancer.capsules.clone(),
            meets_skin: production.design.contact_body() == BodyShapes::Skin,
            crossings: Crossings::Repair,
            production,
            solver,
            pose: Pose::default(),
            world_from_bind,
            capsules: Vec::new(),
            pin_targets: Vec::new(),
            held: Vec::new(),
            cloth_positions: start,
            body_positions: Vec::new(),
            body_normals: Vec::new(),
            surfels: Vec::new(),
            pin_skin: Vec::new(),
            frame: -i64::from(SETTLE_FRAMES),
        };
        let pose = performance.pose_of_dance();
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
        self.step_in(pose, None)
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
        self.step_in(pose, None)
    }

    /// Lets another method go on with the cloth as it is.
    pub(crate) fn replace_solver(&mut self, solver: Solver) {
        self.solver = solver;
    }

    /// Lets the cloth meet other capsules from the next frame on.
    pub(crate) fn replace_capsules(&mut self, capsules: Vec<BodyCapsule>) {
        self.body_capsules = capsules;
    }

    /// Lets the cloth meet what `design` has it meet, from the next frame on.
    pub(crate) fn meet_body_of(&mut self, design: &Design) {
        self.meets_skin = design.contact_body() == BodyShapes::Skin;
    }

    /// Places particles that a hand holds, from the next frame on: ascending, and pinned in the
    /// solver's cloth.
    pub(crate) fn hold(&mut self, held: Vec<(u32, Vec3)>) {
        self.held = held;
    }

    fn step_in(&mut self, pose: Pose, observer: Observer<'_>) -> Result<(), Divergence> {
        self.pose_dancer(pose);
        let surroundings = Surroundings {
            pin_targets: &self.pin_targets,
            capsules: if self.meets_skin { &[] } else { &self.capsules },
            surfels: &self.surfels,
            crossings: self.crossings,
            time: self.time(),
        };
        self.solver.step(&surroundings, FRAME_SECONDS, observer);
        self.solver.copy_positions(&mut self.cloth_positions);
        self.settle();
        self.check_stage()
    }

    /// Damps the cloth before the dance, which begins when the cloth is at rest.
    fn settle(&mut self) {
        let Some(settling) = &mut self.settling else {
            if self.frame <= i64::from(LOWERING_FRAMES) - i64::from(SETTLE_FRAMES) {
                self.solver.scale_velocities(LOWERING);
            }
            return;
        };
        let verdict = settling.judge(&self.cloth_positions);
        if let Some(kept) = verdict.kept {
            self.solver.scale_velocities(kept);
        }
        if verdict.end.is_some() {
            self.settling = None;
            self.frame = 0;
        }
    }

    fn pose_of_dance(&self) -> Pose {
        self.production.dance.pose_at(self.time().max(0.0))
    }

    fn pose_dancer(&mut self, pose: Pose) {
        self.pose = pose;
        self.world_from_bind = self.production.dancer.skeleton.world_from_bind(&self.pose);
        self.capsules = (self.body_capsules.iter())
            .map(|capsule| capsule.posed(&self.world_from_bind))
            .collect();
        self.surfels.clear();
        if self.meets_skin {
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
        }
        self.production
            .skirt
            .pose_pins(&self.world_from_bind, &mut self.pin_targets);
        if self.meets_skin {
            self.lift_pins();
        }
        if !self.held.is_empty() {
            let pins = self.production.skirt.pins.iter().map(|pin| pin.particle);
            let mut all: Vec<(u32, Vec3)> = pins.zip(self.pin_targets.drain(..)).collect();
            all.extend(&self.held);
            all.sort_by_key(|&(particle, _)| particle);
            self.pin_targets
                .extend(all.iter().map(|&(_, target)| target));
        }
    }

    /// Skin that folds would swallow the tape, which runs straight between the points that carry it.
    fn lift_pins(&mut self) {
        let Some(skin) = &self.production.pin_surfels else {
            return;
        };
        let (positions, normals) = (&self.body_positions, &self.body_normals);
        skin.pose(positions, normals, &mut self.pin_skin);
        for (target, skin) in self.pin_targets.iter_mut().zip(&self.pin_skin) {
            let gap = (*target - skin.position).dot(skin.normal);
            *target += skin.normal * (PIN_CLEARANCE - gap).max(0.0);
        }
    }

    fn check_stage(&self) -> Result<(), Divergence> {
        let left = |position: &Vec3| {
            !position.is_finite() || STAGE_RADIUS * STAGE_RADIUS < position.length_squared()
        };
        let Some(particle) = self.cloth_positions.iter().position(left) else {
            return Ok(());
        };
        let columns = self.production.skirt.spec.grid.column_count as usize;
        let place = |value: usize| u32::try_from(value).unwrap_or(u32::MAX);
        let (row, column) = (place(particle / columns), place(particle % columns));
        Err(Divergence {
            time: self.time(),
            row,
            column,
        })
    }

    /// Places the drawn body in the current pose: for pictures and checks, not for the cloth.
    pub fn pose_body(&mut self) {
        let skin = &self.production.dancer.skin;
        skin.pose(
            &self.world_from_bind,
            &mut self.body_positions,
            &mut self.body_normals,
        );
    }

    /// Positions of the particles [m], row-major.
    #[must_use]
    pub fn cloth_positions(&self) -> &[Vec3] {
        &self.cloth_positions
    }

    /// Unit normals of the particles, outward; the seam is smooth.
    #[must_use]
    pub fn cloth_normals(&self) -> Vec<Vec3> {
        vertex_normals(
            &self.cloth_positions,
            &self.production.skirt_mesh.particle_triangles,
        )
    }

    /// Posed vertices of the drawn body [m]; call [`Self::pose_body`] first.
    #[must_use]
    pub fn body_positions(&self) -> &[Vec3] {
        &self.body_positions
    }

    /// Posed unit normals of the drawn body.
    #[must_use]
    pub fn body_normals(&self) -> &[Vec3] {
        &self.body_normals
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

    /// Measures the current frame; call [`Self::pose_body`] first.
    #[must_use]
    pub fn measure(&self) -> FrameMetrics {
        let spec = &self.production.skirt.spec;
        let body = skin_check::Surface {
            positions: &self.body_positions,
            normals: &self.body_normals,
            triangles: &self.production.body_triangles,
        };
        let cloth = skin_check::Surface {
            positions: &self.cloth_positions,
            normals: &[],
            triangles: &self.production.skirt_mesh.particle_triangles,
        };
        let columns = spec.grid.column_count as usize;
        let hem = &self.cloth_positions[self.cloth_positions.len() - columns..];
        FrameMetrics {
            time: self.time(),
            strain: diagnose::strain(spec, &self.cloth_positions),
            capsule_penetration: diagnose::worst_capsule_penetration(
                spec,
                &self.cloth_positions,
                self.met_capsules(),
            ),
            skin: skin_check::check(body, cloth),
            hem_height: hem.iter().map(|p| p.y).sum::<f32>() / columns as f32,
        }
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

    /// Model and settings of the paper's methods; `None` for `xpbd`.
    #[must_use]
    pub fn explicit(&self) -> Option<(&ReferenceModel, &ExplicitConfig)> {
        let explicit = self.solver.explicit()?;
        Some((&explicit.model, &explicit.config))
    }

    /// Changes the settings of the paper's methods from the next frame on; nothing for `xpbd`.
    pub fn tune_explicit(&mut self, change: impl FnOnce(&ReferenceModel, &mut ExplicitConfig)) {
        if let Some(explicit) = self.solver.explicit_mut() {
            change(&explicit.model, &mut explicit.config);
        }
    }

    /// Energy of the cloth under the paper's methods; `None` for `xpbd`.
    #[must_use]
    pub fn energy(&self) -> Option<Energy> {
        let explicit = self.solver.explicit()?;
        let (model, state) = (&explicit.model, &explicit.state);
        let gravity = explicit.config.gravity;
        let weights = model.masses().iter().zip(&state.positions);
        Some(Energy {
            kinetic: model.kinetic_energy(&state.velocities),
            springs: model.spring_energy(&state.positions),
            bending: model.plate_energy(&state.positions),
            height: weights
                .map(|(mass, position)| -mass * gravity.dot(*position))
                .sum(),
        })
    }

    /// All bits of the cloth's state as one number.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        self.solver.state_hash()
    }

    /// Springs of the prepared cloth.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        self.solver.spring_count()
    }

    /// What is done about cloth of `xpbd` that has gone through itself, from the next frame on.
    pub const fn set_crossings(&mut self, crossings: Crossings) {
        self.crossings = crossings;
    }

    /// Vector instructions of `xpbd` from the next frame on; the bits are the same with all.
    pub fn set_instruction_set(&mut self, set: InstructionSet) {
        self.solver.set_instruction_set(set);
    }

    /// Memory of the prepared cloth and its state [byte].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.solver.byte_count()
    }

    /// Root mean square of the particles' speeds [m/s].
    #[must_use]
    pub fn rms_speed(&self) -> f32 {
        self.solver.rms_speed()
    }

    /// Acceleration of free fall [m/s²].
    pub(crate) fn gravity(&self) -> Vec3 {
        self.solver.gravity()
    }

    /// Substeps of one frame.
    #[must_use]
    pub fn substep_count(&self) -> u32 {
        self.solver.substep_count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_film_s_skirt_is_at_rest_when_it_dances_and_stays_there() {
        let production = Production::new(&Design::default()).unwrap();
        let mut performance = Performance::new(production).unwrap();
        let mut frame_count = 0;
        while performance.time() < 0.0 {
            performance.advance().unwrap();
            frame_count += 1;
        }
        assert!(frame_count <= SETTLE_FRAMES, "{frame_count} frames");
        let rest = performance.cloth_positions().to_vec();
        let stance = performance.production.dance.pose_at(0.0);
        for _ in 0..FRAMES_PER_SECOND {
            performance.advance_in(stance.clone()).unwrap();
        }
        let squares =
            (rest.iter().zip(performance.cloth_positions())).map(|(a, b)| a.distance_squared(*b));
        let apart = (squares.sum::<f32>() / rest.len() as f32).sqrt();
        assert!(apart < 0.005, "{apart} m in a second");
    }

    /// Hash of a coarse skirt after half a second in this wind, and how far its hem has swung [m].
    fn blown(change: impl Fn(&mut Design)) -> (u64, f32) {
        let mut design = Design::default();
        (design.skirt.column_count, design.skirt.row_count) = (96, 24);
        change(&mut design);
        let mut performance = Performance::new(Production::new(&design).unwrap()).unwrap();
        let start = performance.cloth_positions().to_vec();
        for _ in 0..30 {
            performance.advance().unwrap();
        }
        let hem = performance.cloth_positions().iter().zip(&start).rev();
        let swing = hem
            .take(96)
            .map(|(now, then)| (*now - *then).x)
            .sum::<f32>()
            / 96.0;
        (performance.state_hash(), swing.abs())
    }

    #[test]
    fn wind_on_triangles_moves_the_skirt_and_its_gusts_follow_the_seed() {
        let wind = |seed: u64, speed: f64| {
            blown(move |design| {
                design.wind.model = lole_costume::document::WindModel::Triangles;
                design.wind.speed_m_per_s = speed;
                design.wind.gust_ratio = 0.3;
                design.wind.seed = seed;
            })
        };
        let (calm, storm) = (wind(1, 0.0), wind(1, 8.0));
        assert!(calm.1 + 0.005 < storm.1, "{} and {} m", calm.1, storm.1);
        assert_eq!(storm, wind(1, 8.0));
        assert!(storm.0 != wind(2, 8.0).0);
    }
}
