//! What does not change while it is performed: the dancer, her dance, and what she wears.

use std::ops::Range;

use glam::Affine3A;
use lole_avatar::{Avatar, License};
use lole_body::{Bone, CapsuleLayout, Dancer, Measurements, Pose, SkinSurfels};
use lole_cloth::Fabric;
use lole_costume::document::{
    Design, FabricDesign, GarmentDesign, GarmentLayer, PrintChoice, SkirtDesign, WornTop,
};
use lole_costume::sew::{self, Clothed, Cut, SewSettings, SewnSkirt, SkirtMesh, WornPlace};
use lole_geom::Length;
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements, draft_pau_skirt};
use lole_pattern::design::pau_top::{TopMeasurements, draft_pau_top};

use crate::performance::Forearms;
use crate::{Danced, StageError};

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
    /// What may be done with the avatar that she is, if she is one.
    pub license: Option<License>,
    /// What she dances.
    pub dance: Danced,
    /// What she wears, from the skin outward; particles are numbered through all of it.
    pub garments: Vec<Garment>,
    /// Triangles of the closed body surface.
    pub body_triangles: Vec<[u32; 3]>,
    /// The body surface as cloth meets it that meets the skin.
    pub body_surfels: SkinSurfels,
    /// Which of them are on the forearms.
    pub(crate) forearms: Forearms,
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
    /// Place of the first garment that it is worn over or under, directly or by way of others; its own
    /// where that is none. Garments of different chains never meet.
    pub chain: usize,
}

impl Production {
    /// Measures, drafts and sews a design.
    ///
    /// # Errors
    /// A design whose parts do not fit together.
    pub fn new(design: &Design) -> Result<Self, StageError> {
        let (mut dancer, license) = dancer(design)?;
        let layout = design.capsule_layout();
        if layout != CapsuleLayout::default() {
            dancer.capsules = dancer.fit_capsules(layout);
        }
        let dance = Danced::new(design, &dancer.skeleton)?;
        let body_triangles = dancer.skin.body_triangles();
        let mut wardrobe = Wardrobe {
            dancer: &dancer,
            stance: dancer.skeleton.world_from_bind(&dance.pose_at(0.0)),
            bind: dancer.skeleton.world_from_bind(&Pose::default()),
            body_triangles: &body_triangles,
            skirt_top: skirt_top(design, &dancer),
            clothed: Clothed::new(dancer.skeleton.joint(Bone::Hips)),
            garments: Vec::new(),
        };
        wardrobe.put_on_layer(design, GarmentLayer::Under)?;
        let skirt = wardrobe.garments.len();
        let (cut, fabric, print) = (&design.skirt, &design.fabric, &design.print);
        wardrobe.put_on_skirt(("pau_skirt", 0.0), (cut, fabric), print)?;
        wardrobe.put_on_layer(design, GarmentLayer::Over)?;
        let mut garments = wardrobe.garments;
        link_chains(&mut garments);
        let body_surfels =
            SkinSurfels::new(&dancer.skin.positions, &body_triangles, SURFEL_SPACING);
        Ok(Self {
            design: design.clone(),
            dance,
            garments,
            forearms: Forearms::new(&dancer, &body_surfels),
            body_surfels,
            body_triangles,
            dancer,
            license,
            skirt,
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

/// The dancer of a design: built to its tape, or its avatar.
fn dancer(design: &Design) -> Result<(Dancer, Option<License>), StageError> {
    let Some(file) = &design.dancer.file else {
        let measurements = Measurements::from_tape(&design.tape())?;
        let dancer = Dancer::with_appearance(&measurements, &design.appearance())?;
        return Ok((dancer, None));
    };
    let name = || file.name.clone();
    let bytes = file.bytes.as_ref();
    let bytes = bytes.ok_or_else(|| StageError::AvatarNotRead { file: name() })?;
    let avatar = Avatar::read(bytes).map_err(|error| StageError::Avatar {
        file: name(),
        error: Box::new(error),
    })?;
    Ok((avatar.dancer, Some(avatar.license)))
}

/// A dancer who is being dressed, from the skin outward.
struct Wardrobe<'a> {
    dancer: &'a Dancer,
    stance: Vec<Affine3A>,
    bind: Vec<Affine3A>,
    body_triangles: &'a [[u32; 3]],
    /// Upper edge of the design's skirt [m].
    skirt_top: f32,
    clothed: Clothed,
    garments: Vec<Garment>,
}

/// Particles that a fold of a listed garment has at least: with fewer it is a cog that crosses the
/// next one.
const FOLD_COLUMNS: f32 = 9.0;

/// How finely a garment is sewn, and by what chance.
#[derive(Debug, Clone, Copy)]
struct Fineness {
    column_count: u32,
    row_count: u32,
    seed: u64,
    /// Particles of a fold, at least; folds are laid wider where there are too few.
    fold_columns: f32,
}

impl Wardrobe<'_> {
    /// Puts on what the design lists for a layer.
    fn put_on_layer(&mut self, design: &Design, layer: GarmentLayer) -> Result<(), StageError> {
        for (place, garment) in design.garments_in(layer) {
            let put_on = match garment {
                GarmentDesign::PauSkirt(worn) => {
                    let name = match layer {
                        GarmentLayer::Under => "pau_underskirt",
                        GarmentLayer::Over => "pau_overskirt",
                    };
                    let cut = (&worn.skirt, &worn.fabric);
                    self.put_on_skirt((name, FOLD_COLUMNS), cut, &worn.print)
                }
                GarmentDesign::PauTop(worn) => self.put_on_top(worn),
                // It is drafted and not danced: `Design::not_danced` says so.
                GarmentDesign::Template(_) => Ok(()),
            };
            put_on.map_err(|error| StageError::Garment {
                place: place + 1,
                error: Box::new(error),
            })?;
        }
        Ok(())
    }

    fn put_on_skirt(
        &mut self,
        (name, fold_columns): (&str, f32),
        (skirt, fabric): (&SkirtDesign, &FabricDesign),
        print: &PrintChoice,
    ) -> Result<(), StageError> {
        let height = worn_height(skirt, self.dancer);
        let worn = PauMeasurements {
            hip_girth: self.dancer.measurements.hip_girth,
            worn_girth: girth(self.dancer, height),
            worn_height: Length::from_m(f64::from(height)),
        };
        let draft = draft_pau_skirt(&worn, &skirt.options(fabric)?)?;
        let fineness = Fineness {
            column_count: skirt.column_count,
            row_count: skirt.row_count,
            seed: skirt.seed,
            fold_columns,
        };
        let parts = (draft, worn, fabric.fabric());
        self.put_on((name, WornPlace::Hips), parts, fineness, print)
    }

    fn put_on_top(&mut self, worn: &WornTop) -> Result<(), StageError> {
        let landmarks = &self.dancer.landmarks;
        let top = &worn.top;
        let height = |written: Option<f64>, usual: f32| {
            written.map_or(usual, |cm| Length::from_cm(cm).to_m_f32())
        };
        let upper = height(top.upper_height_cm, landmarks.bust_height + ABOVE_BUST);
        let lower = height(top.lower_height_cm, landmarks.bust_height - BELOW_BUST);
        let trunk = (0 < top.lower_row_count).then(|| way_up(self.dancer, lower, upper));
        // Further rows lie below the first.
        let rows = f64::from(top.lower_row_count.max(1) - 1);
        let below = Length::from_cm(rows * (top.casing_cm + top.casing_gap_cm)).to_m_f32();
        let lowest = if trunk.is_some() {
            lower - below
        } else {
            upper
        };
        let measurements = TopMeasurements {
            bust_girth: self.dancer.measurements.bust_girth,
            upper_girth: girth(self.dancer, upper),
            lowest: (
                girth(self.dancer, lowest),
                Length::from_m(f64::from(lowest)),
            ),
            trunk,
        };
        let hem = Length::from_m(f64::from(
            (self.skirt_top + ABOVE_SKIRT).min(lowest - LEAST_FRILL),
        ));
        let draft = draft_pau_top(&measurements, &worn.options(hem)?)?;
        let fineness = Fineness {
            column_count: top.column_count,
            row_count: top.row_count,
            seed: top.seed,
            fold_columns: FOLD_COLUMNS,
        };
        let parts = (draft, measurements.worn(), worn.fabric.fabric());
        self.put_on(("pau_top", WornPlace::Bust), parts, fineness, &worn.print)
    }

    /// Sews a garment over what is worn already.
    fn put_on(
        &mut self,
        (name, place): (&str, WornPlace),
        (draft, worn, fabric): (PauDraft, PauMeasurements, Fabric),
        fineness: Fineness,
        print: &PrintChoice,
    ) -> Result<(), StageError> {
        let usual = SewSettings::default();
        let column_count = fineness.column_count;
        let widest = worn.worn_girth.to_m_f32() * fineness.fold_columns / column_count as f32;
        let settings = SewSettings {
            column_count,
            row_count: fineness.row_count,
            seed: fineness.seed,
            gather_pitch: usual.gather_pitch.max(widest),
            ..usual
        };
        let cut = Cut {
            draft: &draft,
            worn: &worn,
            fabric: &fabric,
            place,
        };
        let body = (self.dancer, &self.clothed);
        let sewn = sew::sew(&cut, body, &self.stance, &settings)?;
        self.clothed.put_on(sewn.bind_positions());
        let mesh = SkirtMesh::new(&sewn.spec.grid, print.print().repeat.to_m_f32());
        let pins = sewn.pins.iter();
        let pin_surfels = SkinSurfels::nearest_to(
            pins.map(|pin| pin.posed(&self.bind)),
            (&self.dancer.skin.positions, self.body_triangles),
            PIN_REACH,
        );
        let first = self.garments.last().map_or(0, |last| last.particles.end);
        let particle_count = sewn.spec.grid.particle_count();
        self.garments.push(Garment {
            name: self.unique(name),
            draft,
            worn,
            fabric,
            sewn,
            mesh,
            pin_surfels,
            particles: first..first + particle_count,
            chain: self.garments.len(),
        });
        Ok(())
    }

    /// The name, numbered where another garment has it.
    fn unique(&self, name: &str) -> String {
        let alike = self.garments.iter();
        let alike = alike
            .filter(|garment| garment.name.starts_with(name))
            .count();
        if alike == 0 {
            name.to_owned()
        } else {
            format!("{name}_{}", alike + 1)
        }
    }
}

/// Links garments that share a height of the body into chains.
fn link_chains(garments: &mut [Garment]) {
    let heights = |garment: &Garment| {
        let heights = garment.sewn.bind_positions().map(|place| place.y);
        heights.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], y| {
            [low.min(y), high.max(y)]
        })
    };
    let heights: Vec<[f32; 2]> = garments.iter().map(heights).collect();
    for outer in 1..garments.len() {
        for inner in 0..outer {
            let [one, other] = [heights[outer], heights[inner]];
            if one[0] <= other[1] && other[0] <= one[1] {
                let chains = [garments[inner].chain, garments[outer].chain];
                let [first, last] = [chains[0].min(chains[1]), chains[0].max(chains[1])];
                let linked = garments.iter_mut().filter(|garment| garment.chain == last);
                linked.for_each(|garment| garment.chain = first);
            }
        }
    }
}

/// Upper elastic of a top over the fullest bust [m], where nothing else is written: below the arms.
const ABOVE_BUST: f32 = 0.015;
/// Lower elastic of a top below it [m]: where the bust ends.
const BELOW_BUST: f32 = 0.08;

/// Hem of a top over the upper edge of the skirt [m], where nothing else is written.
const ABOVE_SKIRT: f32 = 0.005;
/// And below its own lowest elastic, at least [m].
const LEAST_FRILL: f32 = 0.06;

/// Points of the tape that measures a girth.
const TAPE_POINTS: usize = 360;
/// Distance between the tapes along which a way up the trunk is measured [m].
const WAY_STEP: f32 = 0.005;

/// Where a skirt is worn [m]: its lowest elastic at the front points of the hip bones, unless the
/// design says otherwise.
fn worn_height(skirt: &SkirtDesign, dancer: &Dancer) -> f32 {
    match skirt.worn_height_cm {
        Some(centimeters) => Length::from_cm(centimeters).to_m_f32(),
        None => dancer.landmarks.asis_height,
    }
}

/// Upper edge of the design's skirt [m].
fn skirt_top(design: &Design, dancer: &Dancer) -> f32 {
    let skirt = &design.skirt;
    let gaps = f64::from(skirt.elastic_row_count - 1);
    let band_cm =
        skirt.header_cm + 0.5 * skirt.casing_cm + gaps * (skirt.casing_cm + skirt.casing_gap_cm);
    worn_height(skirt, dancer) + Length::from_cm(band_cm).to_m_f32()
}

/// What a tape says around the trunk at `height` [m].
fn girth(dancer: &Dancer, height: f32) -> Length {
    let ring = dancer.tape_ring(height, TAPE_POINTS);
    let next = ring.iter().cycle().skip(1);
    let girth: f32 = ring
        .iter()
        .zip(next)
        .map(|(a, b)| a.bind_position.distance(b.bind_position))
        .sum();
    Length::from_m(f64::from(girth))
}

/// Mean way along the trunk from one height [m] up to another.
fn way_up(dancer: &Dancer, from: f32, to: f32) -> Length {
    let mut way = 0.0;
    let mut height = from;
    let mut below = dancer.tape_ring(height, TAPE_POINTS);
    while height < to {
        height = (height + WAY_STEP).min(to);
        let above = dancer.tape_ring(height, TAPE_POINTS);
        let rises = below.iter().zip(&above);
        let rise: f32 = rises
            .map(|(low, high)| low.bind_position.distance(high.bind_position))
            .sum();
        way += rise / TAPE_POINTS as f32;
        below = above;
    }
    Length::from_m(f64::from(way))
}
