//! The dancer, built from a tape: skin, skeleton, capsules and landmarks.

use std::sync::Arc;

use glam::{Affine3A, Vec2, Vec3};
use lole_geom::Capsule;

use crate::appearance::{add_drawn_hair, add_hair};
use crate::capsules::{CapsuleLayout, fit_capsules};
use crate::drawn::{DrawnBody, Expression, build_drawn};
use crate::skin_build::{Half, build_skin, skin_half};
use crate::surface::Shape;
use crate::{
    Appearance, BodyCapsule, BodyError, Bone, Measurements, Skeleton, SkinnedMesh, TapePoint,
};
use crate::{surface, tape};

/// Heights of the standing bind pose above the floor [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Landmarks {
    /// Where the bust tape runs.
    pub bust_height: f32,
    /// Where the tape under the bust runs.
    pub underbust_height: f32,
    /// Where the waist tape runs: the narrowest trunk.
    pub waist_height: f32,
    /// Where the high hip tape runs.
    pub high_hip_height: f32,
    /// Front points of the hip bones (anterior superior iliac spines): the lowest elastic row.
    pub asis_height: f32,
    /// Where the hip tape runs: the fullest hips.
    pub hip_height: f32,
    /// Where the thigh tape runs: just below the crotch.
    pub thigh_height: f32,
    /// Where the knee tape runs: the middle of the kneecap.
    pub knee_tape_height: f32,
    /// Where the calf tape runs: the fullest calf.
    pub calf_height: f32,
    /// Where the ankle tape runs: the narrowest ankle.
    pub ankle_tape_height: f32,
    /// Crotch; the inseam.
    pub crotch_height: f32,
    /// Hip joints.
    pub hip_joint_height: f32,
    /// Knee joints.
    pub knee_height: f32,
    /// Ankle joints.
    pub ankle_height: f32,
    /// Crown; the stature.
    pub crown_height: f32,
}

/// A dancer in the bind pose: arms 47° below the horizontal, legs apart, feet on the floor at 0,
/// front towards `+Z`.
///
/// ```
/// use lole_body::{Dancer, Measurements, Pose};
///
/// let dancer = Dancer::new(&Measurements::woman())?;
/// let world_from_bind = dancer.skeleton.world_from_bind(&Pose::default());
/// assert_eq!(dancer.posed_capsules(&world_from_bind).len(), 13);
/// let band = dancer.tape_ring(dancer.landmarks.asis_height, 512);
/// assert_eq!(band.len(), 512);
/// # Ok::<(), lole_body::BodyError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Dancer {
    /// What she was built from.
    pub measurements: Measurements,
    /// Hair and colors.
    pub appearance: Appearance,
    /// Joints of the bind pose.
    pub skeleton: Skeleton,
    /// What cloth meets and a tape measures.
    pub skin: SkinnedMesh,
    /// What is drawn of her instead; `None` where her skin is drawn: of a given body, and of one that was built
    /// to be measured.
    pub drawn_body: Option<Arc<DrawnBody>>,
    /// The capsules cloth collides with: the 13 of [`CapsuleLayout::default`]; none of one that is there to be
    /// measured.
    pub capsules: Vec<BodyCapsule>,
    /// Heights to hang clothes on.
    pub landmarks: Landmarks,
}

impl Dancer {
    /// Builds the dancer of these measurements, with the hair of her figure, to be measured and dressed. Same
    /// measurements, same bits.
    ///
    /// # Errors
    /// A measurement outside its band, or measurements that make no closed body.
    pub fn new(measurements: &Measurements) -> Result<Self, BodyError> {
        let appearance = Appearance::default();
        let mut dancer = Self::to_measure(measurements, &appearance)?;
        dancer.capsules = dancer.fit_capsules(CapsuleLayout::default());
        Ok(dancer)
    }

    /// As [`Dancer::with_appearance`], but without a face and without capsules: whoever measures her and drafts for
    /// her needs neither, and both take a quarter of the time.
    ///
    /// # Errors
    /// As [`Dancer::new`].
    pub fn to_measure(
        measurements: &Measurements,
        appearance: &Appearance,
    ) -> Result<Self, BodyError> {
        measurements.check()?;
        let shape = surface::build(measurements)?;
        Ok(Self::built(
            measurements,
            appearance,
            (&shape, &skin_half(&shape)),
        ))
    }

    /// Builds the dancer of these measurements with hair and colors of her own, and with what is drawn of her; the
    /// body that cloth meets is that of [`Dancer::new`] to the bit.
    ///
    /// # Errors
    /// As [`Dancer::new`].
    pub fn with_appearance(
        measurements: &Measurements,
        appearance: &Appearance,
    ) -> Result<Self, BodyError> {
        measurements.check()?;
        let shape = surface::build(measurements)?;
        let half = skin_half(&shape);
        let mut dancer = Self::built(measurements, appearance, (&shape, &half));
        dancer.capsules = dancer.fit_capsules(CapsuleLayout::default());
        let looks = (measurements.figure, appearance);
        let (mut drawn, scalp) = build_drawn((&shape, &half), &dancer.skeleton, looks)?;
        let style = appearance.hair.worn_by(measurements.figure);
        add_drawn_hair(&mut drawn, (&shape, &scalp), style);
        let count = drawn.mesh.positions.len();
        drawn.mesh.colors.resize(count, Vec3::ONE);
        dancer.drawn_body = Some(Arc::new(drawn));
        Ok(dancer)
    }

    fn built(
        measurements: &Measurements,
        appearance: &Appearance,
        (shape, half): (&Shape, &Half),
    ) -> Self {
        let skeleton = Skeleton {
            joints: (Bone::ALL.iter())
                .map(|bone| shape.body.joint(bone.name()))
                .collect(),
            waist_side: widest_at(shape, shape.body.tape_level("waist")),
        };
        let mut skin = build_skin(half, &skeleton);
        let style = appearance.hair.worn_by(measurements.figure);
        add_hair(&mut skin, (shape, shape.head.head()), style);
        let height = |bone: Bone| skeleton.joint(bone).y;
        let landmarks = Landmarks {
            bust_height: shape.body.tape_level("bust"),
            underbust_height: shape.body.tape_level("underbust"),
            waist_height: shape.body.tape_level("waist"),
            high_hip_height: shape.body.tape_level("high_hip"),
            asis_height: shape.asis,
            hip_height: shape.body.tape_level("hip"),
            thigh_height: shape.body.tape_level("thigh"),
            knee_tape_height: shape.body.tape_level("knee"),
            calf_height: shape.body.tape_level("calf"),
            ankle_tape_height: shape.body.tape_level("ankle"),
            crotch_height: shape.crotch,
            hip_joint_height: height(Bone::LeftUpperLeg),
            knee_height: height(Bone::LeftLowerLeg),
            ankle_height: height(Bone::LeftFoot),
            crown_height: shape.body.height,
        };
        Self {
            measurements: *measurements,
            appearance: *appearance,
            skeleton,
            skin,
            drawn_body: None,
            capsules: Vec::new(),
            landmarks,
        }
    }

    /// The body as it is drawn.
    #[must_use]
    pub fn drawn(&self) -> &SkinnedMesh {
        let drawn = self.drawn_body.as_deref();
        drawn.map_or(&self.skin, |drawn| &drawn.mesh)
    }

    /// Posed vertices and normals of [`Self::drawn`]; both vectors are cleared and filled.
    pub fn pose_drawn(
        &self,
        world_from_bind: &[Affine3A],
        expression: Expression,
        (positions, normals): (&mut Vec<Vec3>, &mut Vec<Vec3>),
    ) {
        match &self.drawn_body {
            Some(drawn) => drawn.pose(world_from_bind, expression, positions, normals),
            None => self.skin.pose(world_from_bind, positions, normals),
        }
    }

    /// Other capsules for the same body: assign them to [`Dancer::capsules`].
    #[must_use]
    pub fn fit_capsules(&self, layout: CapsuleLayout) -> Vec<BodyCapsule> {
        fit_capsules(&self.skin, &self.skeleton, &self.landmarks, layout)
    }

    /// The capsules in the world.
    #[must_use]
    pub fn posed_capsules(&self, world_from_bind: &[Affine3A]) -> Vec<Capsule> {
        self.capsules
            .iter()
            .map(|capsule| capsule.posed(world_from_bind))
            .collect()
    }

    /// Vertices of the skin of trunk, head and legs, ascending.
    #[must_use]
    pub fn trunk_vertices(&self) -> Vec<u32> {
        let mut vertices = tape::trunk(&self.skin).into_flattened();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// A tape around the trunk (arms left out) at `height` [m] of the bind pose: `point_count`
    /// points at equal arc length on the convex hull of the cut, each carried by the skin.
    ///
    /// It starts at the middle of the back and runs over her left side (`+X`) to the front and back:
    /// clockwise seen from above. Empty where the cut is empty or `point_count` is 0.
    #[must_use]
    pub fn tape_ring(&self, height: f32, point_count: usize) -> Vec<TapePoint> {
        tape::ring(&self.skin, height, point_count)
    }

    /// How cloth hangs around the trunk (arms left out) that is wrapped at the height `top` [m] of the bind
    /// pose: at every `step` [m] from there down to `lowest`, the convex hull of all cuts down to there, as
    /// corners `(x, z)` [m].
    ///
    /// Each starts at the middle of the back and runs over her left side (`+X`); it is empty where there is
    /// no trunk yet.
    #[must_use]
    pub fn hung_rings(&self, [top, lowest]: [f32; 2], step: f32) -> Vec<Vec<Vec2>> {
        tape::hung_rings(&self.skin, [top, lowest], step)
    }
}

/// The point of the trunk farthest to the left at a height of the bind pose [m].
fn widest_at(shape: &Shape, height: f32) -> Vec3 {
    let is_trunk = |&vertex: &u32| !shape.labels[vertex as usize].is_arm();
    let trunk = (shape.triangles.iter().copied()).filter(|triangle| triangle.iter().all(is_trunk));
    (surface::section::cut_points(&shape.positions, trunk, height).iter())
        .map(|cut| Vec3::new(cut.point.x, height, cut.point.y))
        .fold(
            Vec3::ZERO,
            |widest, point| {
                if widest.x < point.x { point } else { widest }
            },
        )
}
