//! What does not change while it is performed: the dancer, her dance, and what she wears.

use std::num::NonZeroU32;
use std::ops::Range;
use std::sync::Arc;

use glam::{Affine3A, Vec3};
use lole_avatar::{Avatar, License};
use lole_body::{Bone, CapsuleLayout, Dancer, DrawnBody, Measurements, MeshPart, Pose};
use lole_cloth::Fabric;
use lole_costume::document::{Design, GarmentDesign, GarmentLayer};
use lole_costume::sew::{
    self, Closing, Clothed, Cut, Lifts, SewSettings, SewnSkirt, SkirtMesh, Watched,
};
use lole_costume::tailoring;
use lole_garment::dress::{self, Among, Bands, Division, Dressed};
use lole_garment::template::WornRuffle;
use lole_garment::{Fineness, GarmentSpec, WornPlace};
use lole_geom::{Length, MeshSurfels};
use lole_pattern::Measures;
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements};

use crate::adorned::{Adornment, adorned, drawn_shown, parts_shown};
use crate::performance::Forearms;
use crate::{Danced, StageError};

/// Farthest that the tape of an elastic row is from the skin below it [m]: across the small of the
/// back and between the buttocks.
const PIN_REACH: f32 = 0.08;

/// Farthest that surfels of the skin lie apart [m].
const SURFEL_SPACING: f32 = 0.016;

/// Everything about one performance that does not change from frame to frame.
#[derive(Clone)]
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
    /// Garments of the templates that she wears besides, from the skin outward.
    pub dressed: Vec<DressedGarment>,
    /// What she wears or holds beside the cloth.
    pub adornments: Vec<Adornment>,
    /// Triangles of the closed body surface that cloth meets.
    pub body_triangles: Vec<[u32; 3]>,
    /// The same of the body as it is drawn.
    pub drawn_triangles: Vec<[u32; 3]>,
    /// The body surface as cloth meets it that meets the skin.
    pub body_surfels: MeshSurfels,
    /// Which of them are on the forearms.
    pub(crate) forearms: Forearms,
    /// Place of the design's skirt among the garments; `None` where it is not worn.
    skirt: Option<usize>,
    /// All parts of her skin, those too that an adornment stands for.
    parts: Vec<MeshPart>,
    /// The drawn body with all of its parts.
    drawn_body: Option<Arc<DrawnBody>>,
}

/// One garment, from paper to particles.
#[derive(Clone)]
pub struct Garment {
    /// Name in files, such as `pau_skirt`; no two garments of a production share one.
    pub name: String,
    /// Place in the design's list; `None` of the design's skirt.
    pub listed: Option<usize>,
    /// The garment on paper.
    pub draft: PauDraft,
    /// What is gathered and sewn to its lower edge.
    pub flounce: Option<PauDraft>,
    /// What was measured for it, and where it is worn.
    pub worn: PauMeasurements,
    /// Its cloth in SI units.
    pub fabric: Fabric,
    /// What carries it.
    pub place: WornPlace,
    /// The garment on the dancer.
    pub sewn: SewnSkirt,
    /// The garment as it is drawn.
    pub mesh: SkirtMesh,
    /// The skin below every pin; `None` where one is too far from the body.
    pub pin_surfels: Option<MeshSurfels>,
    /// Which surfels of the body may come below its elastics, where those give way to them.
    pub watched: Vec<Watched>,
    /// Its particles among those of all garments.
    pub particles: Range<usize>,
    /// Place of the first garment that it is worn over or under, directly or by way of others; its own
    /// where that is none. Garments of different chains never meet.
    pub chain: usize,
    /// What holds its rows together.
    pub rows: Rows,
}

/// What holds the rows of a gathered garment together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rows {
    /// Springs, and chords over many columns. Over other cloth those draw it through that.
    ByChords,
    /// Springs alone.
    BySprings,
}

/// A garment of a template on the dancer.
#[derive(Clone)]
pub struct DressedGarment {
    /// Name in files, such as `blouse`; no two garments of a production share one.
    pub name: String,
    /// Place in the design's list.
    pub listed: usize,
    /// Whether it lies under the skirts or over them.
    pub layer: GarmentLayer,
    /// Its particles among those of all cloth.
    pub particles: Range<usize>,
    /// Its cloth, sewn.
    pub dressed: Dressed,
}

impl DressedGarment {
    /// Whether one that is listed after it, in a layer, is worn over it.
    pub(crate) fn is_inside(&self, layer: GarmentLayer) -> bool {
        self.layer == layer || self.layer == GarmentLayer::Under
    }
}

impl Production {
    /// Lets garments of triangles take so many substeps in every frame, strained or not: their rows say what they
    /// want, and this is for whoever asks what fewer or more would give.
    pub fn set_garment_substep_count(&mut self, count: NonZeroU32) {
        for garment in &mut self.dressed {
            garment.dressed.set_substep_count(count);
        }
    }

    /// Measures, drafts and sews a design.
    ///
    /// # Errors
    /// A design whose parts do not fit together.
    pub fn new(design: &Design) -> Result<Self, StageError> {
        Self::divided(design, Division::Full)
    }

    /// The same with garments of templates that are divided as finely as said.
    ///
    /// # Errors
    /// A design whose parts do not fit together.
    pub fn divided(design: &Design, division: Division) -> Result<Self, StageError> {
        Self::divided_on(design, dancer(design)?, division)
    }

    /// The same for the design's [`dancer`] of the caller's, who has built her for something else before.
    ///
    /// # Errors
    /// As [`Self::divided`].
    pub fn divided_on(
        design: &Design,
        (dancer, license): (Dancer, Option<License>),
        division: Division,
    ) -> Result<Self, StageError> {
        let dance = Danced::new(design, &dancer)?;
        let production = Self::sewn(design, (dancer, dance), division)?;
        Ok(Self {
            license,
            ..production
        })
    }

    /// Sews a design for a dancer and a dance of the caller's instead of its own.
    ///
    /// # Errors
    /// A design whose parts do not fit together on her.
    pub fn of(design: &Design, dancer: Dancer, dance: Danced) -> Result<Self, StageError> {
        Self::sewn(design, (dancer, dance), Division::Full)
    }

    fn sewn(
        design: &Design,
        (mut dancer, dance): (Dancer, Danced),
        division: Division,
    ) -> Result<Self, StageError> {
        let parts = dancer.skin.parts.clone();
        dancer.skin.parts = parts_shown(&parts, design);
        let drawn_body = dancer.drawn_body.clone();
        dancer.drawn_body = drawn_shown(drawn_body.as_ref(), design);
        let drawn_triangles = dancer.drawn().body_triangles();
        let body_triangles = dancer.skin.body_triangles();
        let body_surfels =
            MeshSurfels::new(&dancer.skin.positions, &body_triangles, SURFEL_SPACING);
        let stance = dance.pose_at(0.0);
        let measures = lole_garment::measures(&dancer);
        let mut wardrobe = Wardrobe {
            dancer: &dancer,
            stance: dancer.skeleton.world_from_bind(&stance),
            bind: dancer.skeleton.world_from_bind(&Pose::default()),
            body_triangles: &body_triangles,
            body_surfels: &body_surfels,
            design,
            measures: &measures,
            clothed: Clothed::new(dancer.skeleton.joint(Bone::Hips)),
            garments: Vec::new(),
            listed: None,
        };
        wardrobe.put_on_layer(design, GarmentLayer::Under)?;
        let skirt = (design.skirt.is_worn).then_some(wardrobe.garments.len());
        if design.skirt.is_worn {
            let garment = design.skirt.garment(&design.fabric, &design.print);
            wardrobe.listed = None;
            wardrobe.put_on_gathered((tailoring::SKIRT, None), &garment, 0.0)?;
        }
        wardrobe.put_on_layer(design, GarmentLayer::Over)?;
        let (mut garments, posed) = (wardrobe.garments, wardrobe.stance);
        link_chains(&mut garments);
        hold_rows(&mut garments, design);
        let body = (&dancer, &body_surfels);
        let dressed = dressed(design, body, (&stance, &garments), division)?;
        let adornments = adorned(design, &dancer, &posed, cloth_count(&garments, &dressed))?;
        Ok(Self {
            design: design.clone(),
            dance,
            garments,
            dressed,
            adornments,
            forearms: Forearms::new(&dancer, &body_surfels),
            body_surfels,
            body_triangles,
            drawn_triangles,
            dancer,
            license: None,
            skirt,
            parts,
            drawn_body,
        })
    }

    /// The same costume with the adornments of another design, which has the same cloth: nothing is sewn
    /// for that.
    ///
    /// # Errors
    /// An adornment that does not fit her.
    pub fn with_adornments(&self, design: &Design) -> Result<Self, StageError> {
        let mut new = self.clone();
        // What is sewn stays as it was sewn, in the order that is wished now.
        // What is only drafted is not sewn.
        let is_sewn = |garment: &GarmentDesign| garment.is_danced() || garment.is_dressed();
        let mut sewn = self.design.garments.iter().filter(|it| is_sewn(it));
        new.design.garments = (design.garments.iter())
            .filter_map(|wished| {
                let own = if is_sewn(wished) {
                    sewn.next()
                } else {
                    Some(wished)
                };
                own.cloned()
            })
            .collect();
        let places = |design: &Design| -> Vec<usize> {
            let listed = design.garments.iter().enumerate();
            let sewn = listed.filter(|(_, garment)| is_sewn(garment));
            sewn.map(|(place, _)| place).collect()
        };
        let [before, after] = [&self.design, &new.design].map(places);
        let gathered = new.garments.iter_mut().filter_map(|it| it.listed.as_mut());
        let sewn = new.dressed.iter_mut().map(|it| &mut it.listed);
        for listed in gathered.chain(sewn) {
            let place = before.iter().position(|it| it == listed);
            if let Some(&now) = place.and_then(|place| after.get(place)) {
                *listed = now;
            }
        }
        if self.design.appearance() != design.appearance() {
            new.design.dancer = design.dancer.clone();
            let (dancer, _) = dancer(design)?;
            (new.parts, new.drawn_body) = (dancer.skin.parts.clone(), dancer.drawn_body.clone());
            new.drawn_triangles = dancer.drawn().body_triangles();
            new.dancer = dancer;
        }
        new.dancer.skin.parts = parts_shown(&new.parts, &new.design);
        new.dancer.drawn_body = drawn_shown(new.drawn_body.as_ref(), &new.design);
        let stance = self.dance.pose_at(0.0);
        let posed = new.dancer.skeleton.world_from_bind(&stance);
        new.adornments = adorned(&new.design, &new.dancer, &posed, self.cloth_count())?;
        Ok(new)
    }

    /// The skirt that the design is about, among what is worn with it; `None` where it is not worn.
    #[must_use]
    pub fn skirt(&self) -> Option<&Garment> {
        self.garments.get(self.skirt?)
    }

    /// Everything that moves by itself: particles of all garments and of strands.
    #[must_use]
    pub fn moving_count(&self) -> usize {
        let last = self.adornments.last();
        last.map_or_else(|| self.cloth_count(), |last| last.particles.end)
    }

    /// Particles of gathered garments.
    #[must_use]
    pub fn particle_count(&self) -> usize {
        self.garments.last().map_or(0, |last| last.particles.end)
    }
}

/// The dancer of a design: built to its tape, or its avatar with what may be done with it.
///
/// # Errors
/// A tape that no body has, or an avatar that is none.
pub fn dancer(design: &Design) -> Result<(Dancer, Option<License>), StageError> {
    let (mut dancer, license) = built(design)?;
    let layout = design.capsule_layout();
    if layout != CapsuleLayout::default() {
        dancer.capsules = dancer.fit_capsules(layout);
    }
    Ok((dancer, license))
}

fn built(design: &Design) -> Result<(Dancer, Option<License>), StageError> {
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
    body_surfels: &'a MeshSurfels,
    design: &'a Design,
    measures: &'a Measures,
    clothed: Clothed,
    garments: Vec<Garment>,
    /// Place in the design's list of what is being put on.
    listed: Option<usize>,
}

/// Particles that a fold of a listed garment has at least: with fewer it is a cog that crosses the
/// next one.
const FOLD_COLUMNS: f32 = 9.0;

/// A rectangle that is gathered and put on.
struct Gathering {
    place: WornPlace,
    closing: Closing,
    draft: PauDraft,
    /// What is gathered and sewn to its lower edge.
    flounce: Option<PauDraft>,
    worn: PauMeasurements,
    fabric: Fabric,
    fineness: Fineness,
    /// Particles of a fold, at least; folds are laid wider where there are too few.
    fold_columns: f32,
}

impl Wardrobe<'_> {
    /// Puts on what the design lists for a layer.
    fn put_on_layer(&mut self, design: &Design, layer: GarmentLayer) -> Result<(), StageError> {
        for (place, garment) in design.garments_in(layer) {
            self.listed = Some(place);
            let name = garment.file_name();
            let put_on = self.put_on_gathered((&name, Some(layer)), garment, FOLD_COLUMNS);
            put_on.map_err(|error| StageError::Garment {
                place: place + 1,
                error: Box::new(error),
            })?;
        }
        Ok(())
    }

    /// Puts on a gathered rectangle, and the ruffle on it.
    fn put_on_gathered(
        &mut self,
        (name, layer): (&str, Option<GarmentLayer>),
        garment: &GarmentDesign,
        fold_columns: f32,
    ) -> Result<(), StageError> {
        let fitting =
            tailoring::fitting(self.design, (self.dancer, self.measures), (layer, garment));
        let gathered = garment.template.gathered(&fitting, &garment.options)?;
        let Some(gathered) = gathered else {
            return Ok(());
        };
        let fineness = garment.fineness;
        let closing = if gathered.is_open {
            Closing::Open
        } else {
            Closing::Sewn
        };
        let fabric = garment.fabric.fabric();
        let (flounce, layer) = match gathered.ruffle {
            None => (None, None),
            Some(WornRuffle::Flounce(flounce)) => (Some(flounce), None),
            Some(WornRuffle::Layer { draft, worn }) => (None, Some((draft, worn))),
        };
        let row_height = gathered.draft.finished_length.to_m() / f64::from(fineness.row_count - 1);
        let piece = Gathering {
            place: gathered.place,
            closing,
            draft: gathered.draft,
            flounce,
            worn: gathered.worn,
            fabric,
            fineness,
            fold_columns,
        };
        let Some((draft, edge)) = layer else {
            return self.put_on(name, piece);
        };
        let ruffle = Gathering {
            place: WornPlace::Skirt,
            flounce: None,
            fineness: Fineness {
                row_count: rows_of(draft.finished_length, row_height),
                seed: fineness.seed + 1,
                ..fineness
            },
            draft,
            worn: edge,
            ..piece
        };
        self.put_on(name, piece)?;
        self.put_on(name, ruffle)
    }

    /// Sews a garment over what is worn already.
    fn put_on(&mut self, name: &str, piece: Gathering) -> Result<(), StageError> {
        let Gathering {
            place,
            closing,
            draft,
            flounce,
            worn,
            fabric,
            fineness,
            fold_columns,
        } = piece;
        let usual = SewSettings::default();
        let column_count = fineness.column_count;
        let widest = worn.worn_girth.to_m_f32() * fold_columns / column_count as f32;
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
            closing,
            flounce: flounce.as_ref(),
        };
        let body = (self.dancer, &self.clothed);
        let sewn = sew::sew(&cut, body, &self.stance, &settings)?;
        self.clothed.put_on(sewn.bind_positions());
        let mesh = SkirtMesh::new(&sewn.spec.grid);
        let pins = sewn.pins.iter();
        let pin_surfels = MeshSurfels::nearest_to(
            pins.map(|pin| pin.posed(&self.bind)),
            (&self.dancer.skin.positions, self.body_triangles),
            PIN_REACH,
        );
        let watched = (sewn.band.as_ref()).map_or_else(Vec::new, |band| {
            let skin = &self.dancer.skin;
            let carriers = self.body_surfels.carriers();
            band.watched(carriers.map(|vertex| {
                let vertex = vertex as usize;
                (skin.strongest_bone(vertex), skin.positions[vertex])
            }))
        });
        let first = self.garments.last().map_or(0, |last| last.particles.end);
        let particle_count = sewn.spec.grid.particle_count();
        self.garments.push(Garment {
            name: tailoring::numbered(
                name,
                self.garments.iter().map(|garment| garment.name.as_str()),
            ),
            listed: self.listed,
            draft,
            flounce,
            worn,
            fabric,
            place,
            sewn,
            mesh,
            pin_surfels,
            watched,
            particles: first..first + particle_count,
            chain: self.garments.len(),
            rows: Rows::ByChords,
        });
        Ok(())
    }
}

/// Particles of all cloth: of gathered rectangles first, then of what is sewn.
pub(crate) fn cloth_count(garments: &[Garment], dressed: &[DressedGarment]) -> usize {
    let sewn = dressed.last().map(|last| last.particles.end);
    let gathered = garments.last().map(|last| last.particles.end);
    sewn.or(gathered).unwrap_or(0)
}

/// Rows of particles down a length of cloth, about so far apart [m].
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a garment has fewer than 1,000 rows"
)]
fn rows_of(length: Length, row_height: f64) -> u32 {
    ((length.to_m() / row_height).round() as u32 + 1).max(LEAST_ROWS)
}

/// Rows that a garment has at least.
const LEAST_ROWS: u32 = 6;

/// Sews what the design lists of the templates that can be put on.
fn dressed(
    design: &Design,
    body: (&Dancer, &MeshSurfels),
    (stance, garments): (&Pose, &[Garment]),
    division: Division,
) -> Result<Vec<DressedGarment>, StageError> {
    let posed = body.0.skeleton.world_from_bind(stance);
    let edge = upper_edges(garments, &posed);
    let mut dressed: Vec<DressedGarment> = Vec::new();
    let listed = design.garments.iter().enumerate();
    let (under, over): (Vec<_>, Vec<_>) =
        listed.partition(|(_, garment)| garment.layer == GarmentLayer::Under);
    for (listed, garment) in under.into_iter().chain(over) {
        if !garment.is_dressed() {
            continue;
        }
        let is_under = garment.layer == GarmentLayer::Under;
        let bands = (is_under && !edge.is_empty()).then_some(Bands { edge: &edge });
        let inside = dressed
            .iter()
            .filter(|other| other.is_inside(garment.layer));
        let inside = inside.map(|other| {
            let triangles = &other.dressed.trunk_triangles[..];
            (triangles, &other.dressed.start[..])
        });
        let inside: Vec<_> = inside.collect();
        let among = Among {
            bands,
            inside: &inside,
            division,
        };
        let spec = GarmentSpec {
            alterations: design.alterations,
            tailor_tape: design.dancer.tailor_tape,
            ..garment.spec()
        };
        let sewn = dress::dress(&spec, body, stance, &among);
        let sewn = sewn.map_err(|error| StageError::Garment {
            place: listed + 1,
            error: Box::new(error.into()),
        })?;
        let first = (dressed.last().map(|last| last.particles.end))
            .or_else(|| garments.last().map(|last| last.particles.end));
        let first = first.unwrap_or(0);
        let others = garments.iter().map(|garment| garment.name.as_str());
        let others = others.chain(dressed.iter().map(|garment| garment.name.as_str()));
        dressed.push(DressedGarment {
            name: tailoring::numbered(&garment.file_name(), others),
            listed,
            layer: garment.layer,
            particles: first..first + sewn.particle_count(),
            dressed: sewn,
        });
    }
    Ok(dressed)
}

/// The upper edges of skirts as they are worn [m].
fn upper_edges(garments: &[Garment], posed: &[Affine3A]) -> Vec<Vec3> {
    let skirts = garments
        .iter()
        .filter(|garment| garment.place == WornPlace::Hips);
    let edges = skirts.flat_map(|garment| {
        let mut places = (garment.sewn).start_positions(posed, &Lifts::default());
        places.truncate(garment.sewn.spec.grid.column_count as usize);
        places
    });
    edges.collect()
}

/// Columns from which on the rows of a garment that lies on the skin need chords whatever is worn over it: with
/// springs alone a skirt of 512 stays strained, and one of 352 does not.
const CHORDED_COLUMNS: u32 = 400;

/// Finds what holds the rows of each garment together.
fn hold_rows(garments: &mut [Garment], design: &Design) {
    let is_under =
        |garment: &GarmentDesign| garment.is_dressed() && garment.layer == GarmentLayer::Under;
    let has_under = design.garments.iter().any(is_under);
    let chains: Vec<usize> = garments.iter().map(|garment| garment.chain).collect();
    for (place, garment) in garments.iter_mut().enumerate() {
        let lies_on_cloth = has_under || chains[..place].contains(&garment.chain);
        let is_under_other = chains[place + 1..].contains(&garment.chain);
        let is_fine = CHORDED_COLUMNS <= garment.sewn.spec.grid.column_count;
        if lies_on_cloth || (is_under_other && !is_fine) {
            garment.rows = Rows::BySprings;
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
