//! What does not change while it is performed: the dancer, her dance, and what she wears.

use std::ops::Range;

use lole_body::motion::Dance;
use lole_body::{CapsuleLayout, Dancer, Measurements, Pose, SkinSurfels};
use lole_cloth::Fabric;
use lole_costume::document::Design;
use lole_costume::sew::{self, SewSettings, SewnSkirt, SkirtMesh};
use lole_geom::Length;
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements, draft_pau_skirt};

use crate::StageError;

/// Farthest that the tape of an elastic row is from the skin below it [m]: across the small of the
/// back and between the buttocks.
const PIN_REACH: f32 = 0.08;

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
    /// What she wears, from the skin outward; particles are numbered through all of it.
    pub garments: Vec<Garment>,
    /// Triangles of the closed body surface.
    pub body_triangles: Vec<[u32; 3]>,
    /// The body surface as cloth meets it that meets the skin.
    pub body_surfels: SkinSurfels,
    /// Place of the design's skirt among the garments.
    skirt: usize,
}

/// One garment, from paper to particles.
pub struct Garment {
    /// Name in files, such as `pau_skirt`; no two garments of a production share one.
    pub name: String,
    /// The garment on paper.
    pub draft: PauDraft,
    /// What was measured for it, and where it is worn.
    pub worn: PauMeasurements,
    /// Its cloth in SI units.
    pub fabric: Fabric,
    /// The garment on the dancer.
    pub sewn: SewnSkirt,
    /// The garment as it is drawn.
    pub mesh: SkirtMesh,
    /// The skin below every pin; `None` where one is too far from the body.
    pub pin_surfels: Option<SkinSurfels>,
    /// Its particles among those of all garments.
    pub particles: Range<usize>,
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
        let body_triangles = dancer.skin.body_triangles();
        let skirt = Garment::skirt(design, &dancer, &dance, &body_triangles)?;
        Ok(Self {
            design: design.clone(),
            dance,
            garments: vec![skirt],
            body_surfels: SkinSurfels::new(&dancer.skin.positions, &body_triangles, SURFEL_SPACING),
            body_triangles,
            dancer,
            skirt: 0,
        })
    }

    /// The skirt that the design is about, among what is worn with it.
    #[must_use]
    pub fn skirt(&self) -> &Garment {
        &self.garments[self.skirt]
    }

    /// Particles of all garments.
    #[must_use]
    pub fn particle_count(&self) -> usize {
        self.garments.last().map_or(0, |last| last.particles.end)
    }
}

impl Garment {
    fn skirt(
        design: &Design,
        dancer: &Dancer,
        dance: &Dance,
        body_triangles: &[[u32; 3]],
    ) -> Result<Self, StageError> {
        let worn = worn_measurements(design, dancer);
        let draft = draft_pau_skirt(&worn, &design.pau_options()?)?;
        let fabric = design.fabric.fabric();
        let settings = SewSettings {
            column_count: design.skirt.column_count,
            row_count: design.skirt.row_count,
            seed: design.skirt.seed,
            ..SewSettings::default()
        };
        let stance = dancer.skeleton.world_from_bind(&dance.pose_at(0.0));
        let sewn = sew::sew(&draft, &worn, &fabric, dancer, &stance, &settings)?;
        let mesh = SkirtMesh::new(&sewn.spec.grid, design.print.print().repeat.to_m_f32());
        let bind = dancer.skeleton.world_from_bind(&Pose::default());
        let pins = sewn.pins.iter();
        let particle_count = sewn.spec.grid.particle_count();
        Ok(Self {
            name: "pau_skirt".to_owned(),
            draft,
            worn,
            fabric,
            mesh,
            pin_surfels: SkinSurfels::nearest_to(
                pins.map(|pin| pin.posed(&bind)),
                (&dancer.skin.positions, body_triangles),
                PIN_REACH,
            ),
            sewn,
            particles: 0..particle_count,
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
