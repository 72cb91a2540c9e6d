//! Everything that a design has to be cut and sewn from: each garment drafted to the dancer, with the
//! cloth that it is cut from.

use std::cell::LazyCell;

use lole_body::Dancer;
use lole_garment::template::PAU_SKIRT;
use lole_garment::{Template, measures};
use lole_geom::Length;
use lole_language::{Bilingual, Words, words};
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements, draft_pau_skirt};
use lole_pattern::design::pau_top::{TopMeasurements, draft_pau_top};
use lole_pattern::marker::{Border, Lay, Nap, TableCloth, lay_out};
use lole_pattern::piece::ClothRole;
use lole_pattern::{DraftError, Marker, Pattern};
use lole_print::{PrintBorder, PrintMotif};

use crate::document::{
    Design, FabricDesign, GarmentDesign, GarmentLayer, PrintChoice, SkirtDesign, WornTop,
};

/// Name in files of the design's skirt.
pub const SKIRT: &str = "pau_skirt";
/// What the design's skirt is called.
pub const SKIRT_NAME: Words = words("パウスカート", "pāʻū skirt");
/// Name in files of a top.
pub const TOP: &str = "pau_top";

/// One garment of a design, ready to be cut.
#[derive(Debug, Clone, PartialEq)]
pub struct GarmentPattern {
    /// What it is.
    pub template: &'static Template,
    /// Name in files, such as `pau_skirt`; no two garments of a design share one.
    pub id: String,
    /// What it is called.
    pub name: Words,
    /// Its pieces, seams, notions and steps.
    pub pattern: Pattern,
    /// What it is cut from.
    pub cloth: Cloth,
}

/// Cloth as it is bought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cloth {
    /// What to ask for.
    pub name: Words,
    /// From selvage to selvage.
    pub width: Length,
    /// Width of lining, contrast cloth and interfacing.
    pub beside_width: Length,
    /// Mass per area [kg/m²].
    pub areal_density: f64,
    /// Whether cloth and print look the same from both ends.
    pub nap: Nap,
    /// What of a piece lies along a selvage that is printed with a border.
    pub border: Option<Border>,
    /// Repeat of the print along the warp; `None` of plain cloth.
    pub repeat: Option<Length>,
}

/// One cloth of a garment with all pieces that are cut from it laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothPlan {
    /// Which of the garment's cloths it is.
    pub role: ClothRole,
    /// Where the pieces lie, how much to buy, what to decide before cutting.
    pub marker: Marker,
    /// Mass of the cloth that the pieces need, offcuts included [kg].
    pub mass: f64,
}

/// What a cloth of a garment is called.
#[must_use]
pub const fn role_name(role: ClothRole) -> Words {
    match role {
        ClothRole::Main => words("表布", "main cloth"),
        ClothRole::Contrast => words("別布", "contrast cloth"),
        ClothRole::Lining => words("裏布", "lining"),
        ClothRole::Interfacing => words("芯地", "interfacing"),
    }
}

impl GarmentPattern {
    /// The cut plans of its cloths. Lining and other cloths beside the garment's own are taken to be as
    /// heavy as it is, and plain. `matched_repeat` makes the print meet at the seams.
    #[must_use]
    pub fn cloth_plans(&self, lay: Lay, matched_repeat: Option<Length>) -> Vec<ClothPlan> {
        const ROLES: [ClothRole; 4] = [
            ClothRole::Main,
            ClothRole::Contrast,
            ClothRole::Lining,
            ClothRole::Interfacing,
        ];
        let is_cut =
            |role: &ClothRole| self.pattern.pieces.iter().any(|piece| piece.cloth == *role);
        let plan = |role| {
            let cloth = if role == ClothRole::Main {
                self.cloth.on_table(lay, matched_repeat)
            } else {
                TableCloth {
                    width: self.cloth.beside_width,
                    nap: Nap::TwoWay,
                    border: None,
                    ..self.cloth.on_table(lay, None)
                }
            };
            let marker = lay_out(&self.pattern, role, &cloth);
            ClothPlan {
                role,
                mass: self.cloth.mass(marker.yardage.needed, cloth.width),
                marker,
            }
        };
        ROLES.into_iter().filter(is_cut).map(plan).collect()
    }
}

/// A gathered rectangle drafted to the dancer, with where it is worn.
#[derive(Debug, Clone, PartialEq)]
pub struct Drafted {
    /// The garment on paper.
    pub draft: PauDraft,
    /// What was measured for it.
    pub worn: PauMeasurements,
}

/// Which garment of a design cannot be drafted, and why.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}: {error}", garment.english)]
pub struct TailoringError {
    /// What it is called.
    pub garment: Words,
    /// Its place in the design's list, from 1; `None` of the skirt that has no place there.
    pub place: Option<usize>,
    /// What is wrong.
    pub error: Box<DraftError>,
}

impl Bilingual for TailoringError {
    fn japanese(&self) -> String {
        format!("{}: {}", self.garment.japanese, self.error.japanese())
    }
}

/// The patterns of everything that a design's dancer wears, from the skin outward.
///
/// # Errors
/// The first garment that cannot be drafted.
pub fn patterns_of(
    design: &Design,
    dancer: &Dancer,
) -> Result<Vec<GarmentPattern>, TailoringError> {
    let drafts = drafts_of(design, dancer).into_iter();
    drafts.map(|(_, draft)| draft).collect()
}

/// What became of drafting each garment of a design, from the skin outward, with its place in the
/// design's list, from 0; the skirt has none. One that cannot be drafted leaves the others as they are.
#[must_use]
pub fn drafts_of(
    design: &Design,
    dancer: &Dancer,
) -> Vec<(Option<usize>, Result<GarmentPattern, TailoringError>)> {
    let mut drafts = Vec::new();
    let mut ids: Vec<String> = Vec::new();
    let mut add = |(place, template): (Option<usize>, &'static Template),
                   named: (&str, Words),
                   pattern,
                   cloth| {
        let (file_name, name) = named;
        let id = numbered(file_name, ids.iter().map(String::as_str));
        ids.push(id.clone());
        let draft = match pattern {
            Ok(pattern) => Ok(GarmentPattern {
                template,
                id,
                name,
                pattern,
                cloth,
            }),
            Err(error) => Err(TailoringError {
                garment: name,
                place: place.map(|index| index + 1),
                error: Box::new(error),
            }),
        };
        drafts.push((place, draft));
    };
    let measures = LazyCell::new(|| measures(dancer));
    for layer in [GarmentLayer::Under, GarmentLayer::Over] {
        for (index, garment) in design.listed_in(layer) {
            let name = garment_name(garment);
            let pattern = match garment {
                GarmentDesign::PauSkirt(worn) => {
                    draft_skirt(&worn.skirt, &worn.fabric, dancer).map(|it| it.draft.pattern(name))
                }
                GarmentDesign::PauTop(worn) => {
                    draft_top(worn, &design.skirt, dancer).map(|it| it.draft.pattern(name))
                }
                GarmentDesign::Template(worn) => worn.pattern(&measures),
            };
            let cloth = Cloth::of(garment.fabric(), garment.print());
            let what = (Some(index), garment.template());
            add(what, (&file_name(garment), name), pattern, cloth);
        }
        if layer == GarmentLayer::Under && design.skirt.is_worn {
            let name = SKIRT_NAME;
            let drafted = draft_skirt(&design.skirt, &design.fabric, dancer);
            let pattern = drafted.map(|it| it.draft.pattern(name));
            let cloth = Cloth::of(&design.fabric, &design.print);
            add((None, &PAU_SKIRT), (SKIRT, name), pattern, cloth);
        }
    }
    drafts
}

/// Name in files of a garment of a design's list, before it is numbered.
#[must_use]
pub fn file_name(garment: &GarmentDesign) -> String {
    match (garment, garment.layer()) {
        (GarmentDesign::PauSkirt(_), GarmentLayer::Under) => "pau_underskirt".to_owned(),
        (GarmentDesign::PauSkirt(_), GarmentLayer::Over) => "pau_overskirt".to_owned(),
        (GarmentDesign::PauTop(_), _) => TOP.to_owned(),
        (GarmentDesign::Template(worn), _) => worn.template.id.replace('-', "_"),
    }
}

/// What a garment of a design's list is called.
#[must_use]
pub const fn garment_name(garment: &GarmentDesign) -> Words {
    match (garment, garment.layer()) {
        (GarmentDesign::PauSkirt(_), GarmentLayer::Under) => {
            words("下に重ねるパウスカート", "pāʻū underskirt")
        }
        (GarmentDesign::PauSkirt(_), GarmentLayer::Over) => {
            words("上に重ねるパウスカート", "pāʻū overskirt")
        }
        (GarmentDesign::PauTop(_), _) => words("パウトップ", "pāʻū top"),
        (GarmentDesign::Template(worn), _) => worn.template.name,
    }
}

/// The name, numbered where others have it.
#[must_use]
pub fn numbered<'a>(name: &str, others: impl Iterator<Item = &'a str>) -> String {
    let alike = others.filter(|other| other.starts_with(name)).count();
    if alike == 0 {
        name.to_owned()
    } else {
        format!("{name}_{}", alike + 1)
    }
}

impl Cloth {
    /// The cloth that a part of a design names.
    #[must_use]
    pub fn of(fabric: &FabricDesign, print: &PrintChoice) -> Self {
        let density = fabric.areal_density_g_per_m2;
        let density = density.unwrap_or(fabric.preset.areal_density.value);
        let is_printed = print.motif != PrintMotif::Plain || print.file.is_some();
        let border = match print.lay.border {
            PrintBorder::None => None,
            PrintBorder::Hem => Some(Border::Hem),
            PrintBorder::Hip => Some(Border::Hip),
        };
        Self {
            name: Words {
                japanese: fabric.preset.name_ja,
                english: fabric.preset.name,
            },
            width: fabric.width(),
            beside_width: fabric
                .beside_width_cm
                .map_or_else(|| fabric.width(), Length::from_cm),
            areal_density: density * 1.0e-3,
            // The motifs of the built-in prints look alike from both ends. A picture has a top, and so
            // has a border.
            nap: if print.file.is_some() || border.is_some() {
                Nap::OneWay
            } else {
                Nap::TwoWay
            },
            border,
            repeat: is_printed.then(|| Length::from_cm(print.repeat_cm * print.lay.scale_ratio)),
        }
    }

    /// The cloth on the table.
    #[must_use]
    pub const fn on_table(&self, lay: Lay, matched_repeat: Option<Length>) -> TableCloth {
        TableCloth {
            width: self.width,
            nap: self.nap,
            border: self.border,
            matched_repeat,
            lay,
        }
    }

    /// Mass of a length of it, or of cloth as heavy, of this width [kg].
    #[must_use]
    pub const fn mass(&self, length: Length, width: Length) -> f64 {
        length.to_m() * width.to_m() * self.areal_density
    }
}

/// Drafts a skirt to the dancer.
///
/// # Errors
/// What no skirt can be sewn from.
pub fn draft_skirt(
    skirt: &SkirtDesign,
    fabric: &FabricDesign,
    dancer: &Dancer,
) -> Result<Drafted, DraftError> {
    let height = worn_height(skirt, dancer);
    let worn = PauMeasurements {
        hip_girth: dancer.measurements.hip_girth,
        worn_girth: girth(dancer, height),
        worn_height: Length::from_m(f64::from(height)),
    };
    let draft = draft_pau_skirt(&worn, &skirt.options(fabric)?)?;
    Ok(Drafted { draft, worn })
}

/// Drafts a top to the dancer, its hem just above `skirt` where the design does not say otherwise.
///
/// # Errors
/// What no top can be sewn from.
pub fn draft_top(
    worn: &WornTop,
    skirt: &SkirtDesign,
    dancer: &Dancer,
) -> Result<Drafted, DraftError> {
    let landmarks = &dancer.landmarks;
    let top = &worn.top;
    let height = |written: Option<f64>, usual: f32| {
        written.map_or(usual, |cm| Length::from_cm(cm).to_m_f32())
    };
    let upper = height(top.upper_height_cm, landmarks.bust_height + ABOVE_BUST);
    let lower = height(top.lower_height_cm, landmarks.bust_height - BELOW_BUST);
    let trunk = (0 < top.lower_row_count).then(|| way_up(dancer, lower, upper));
    // Further rows lie below the first.
    let rows = f64::from(top.lower_row_count.max(1) - 1);
    let below = Length::from_cm(rows * (top.casing_cm + top.casing_gap_cm)).to_m_f32();
    let lowest = if trunk.is_some() {
        lower - below
    } else {
        upper
    };
    let measurements = TopMeasurements {
        bust_girth: dancer.measurements.bust_girth,
        upper_girth: girth(dancer, upper),
        lowest: (girth(dancer, lowest), Length::from_m(f64::from(lowest))),
        trunk,
    };
    let above_skirt = skirt_top(skirt, dancer) + ABOVE_SKIRT;
    let hem = Length::from_m(f64::from(above_skirt.min(lowest - LEAST_FRILL)));
    let draft = draft_pau_top(&measurements, &worn.options(hem)?)?;
    Ok(Drafted {
        draft,
        worn: measurements.worn(),
    })
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

/// Upper edge of a skirt [m].
fn skirt_top(skirt: &SkirtDesign, dancer: &Dancer) -> f32 {
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

#[cfg(test)]
mod tests {
    use lole_body::Measurements;

    use super::*;
    use crate::document::{WornSkirt, WornTop};

    fn patterns(design: &Design) -> Vec<GarmentPattern> {
        let measurements = Measurements::from_tape(&design.tape()).unwrap();
        let dancer = Dancer::with_appearance(&measurements, &design.appearance()).unwrap();
        patterns_of(design, &dancer).unwrap()
    }

    #[test]
    fn every_garment_has_a_pattern_from_the_skin_outward() {
        let mut design = Design::default();
        let underskirt = || GarmentDesign::PauSkirt(WornSkirt::default());
        design.garments = vec![
            underskirt(),
            GarmentDesign::PauTop(WornTop::default()),
            underskirt(),
        ];
        let patterns = patterns(&design);
        let ids: Vec<&str> = patterns.iter().map(|garment| garment.id.as_str()).collect();
        let expected = ["pau_underskirt", "pau_underskirt_2", "pau_skirt", "pau_top"];
        assert_eq!(ids, expected);
        for garment in &patterns {
            assert!(
                garment.pattern.pieces[0]
                    .stitching_polygon(1e-4)
                    .signed_area()
                    > 0.1
            );
        }
    }

    /// The worked example of the makers: hip 91.4 cm, four times its cloth.
    #[test]
    fn the_skirt_is_four_times_the_hips_around() {
        let mut design = Design::default();
        design.dancer.hip_cm = Some(91.4);
        let patterns = patterns(&design);
        let cut = patterns[0].pattern.pieces[0]
            .drawing(1e-4)
            .rectangle
            .unwrap();
        assert!(
            (cut[0].to_cm() - (4.0 * 91.4 + 2.0)).abs() < 0.05,
            "{cut:?}"
        );
        let cloth = &patterns[0].cloth;
        let mass = cloth.mass(Length::from_yd(4.0), cloth.width);
        assert!((0.40..0.48).contains(&mass), "{mass}");
    }
}
