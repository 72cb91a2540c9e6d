//! Everything that a design has to be cut and sewn from: each garment drafted to the dancer, with the
//! cloth that it is cut from.

mod trial;

use lole_body::Dancer;
use lole_garment::{Fitting, Template, measures};
use lole_geom::Length;
use lole_language::{Bilingual, Words, words};
use lole_pattern::joining::fit_to_cloth;
use lole_pattern::marker::{Border, Lay, Nap, TableCloth, lay_out};
use lole_pattern::piece::ClothRole;
use lole_pattern::{DraftError, Marker, Measures, Pattern};
use lole_print::{PrintBorder, PrintMotif};

use crate::document::{
    Design, FabricDesign, GarmentDesign, GarmentLayer, PrintChoice, SkirtDesign,
};

pub use trial::{DraftedBy, SHOWN_CM, UsedAlteration, UsedMeasure, drafted_by};

/// Name in files of the design's skirt.
pub const SKIRT: &str = "pau_skirt";

/// One garment of a design, ready to be cut.
#[derive(Debug, Clone, PartialEq)]
pub struct GarmentPattern {
    /// What it is.
    pub template: &'static Template,
    /// Its place in the design's list, from 0; `None` of the skirt, which has none there.
    pub place: Option<usize>,
    /// Name in files, such as `pau_skirt`; no two garments of a design share one.
    pub id: String,
    /// What it is called.
    pub name: Words,
    /// Its pieces, seams, notions and steps.
    pub pattern: Pattern,
    /// Its pieces as they are cut, where some are wider than their cloth and are joined of parts.
    pub parts: Option<Pattern>,
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
    /// Its pieces as they are laid on cloth and cut: parts of those that are wider than it.
    #[must_use]
    pub fn cutting(&self) -> &Pattern {
        self.parts.as_ref().unwrap_or(&self.pattern)
    }

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
            let cloth = self.cloth.in_role(role, lay, matched_repeat);
            let marker = lay_out(self.cutting(), role, &cloth);
            ClothPlan {
                role,
                mass: self.cloth.mass(marker.yardage.needed, cloth.width),
                marker,
            }
        };
        ROLES.into_iter().filter(is_cut).map(plan).collect()
    }
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

impl TailoringError {
    /// Whether its cloth is too narrow for it: nothing is wrong with measures and options.
    #[must_use]
    pub fn is_too_wide(&self) -> bool {
        matches!(*self.error, DraftError::WiderThanCloth { .. })
    }

    /// The key of `[dancer]` that is the cause, where what was taken of her is.
    #[must_use]
    pub fn dancer_key(&self) -> Option<&'static str> {
        match *self.error {
            DraftError::Tailored { tailored, .. } => Some(tailored.key()),
            _ => None,
        }
    }
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
    let measures = design.dancer.tailor_tape.over(measures(dancer));
    let mut drafts = Vec::new();
    let mut ids: Vec<String> = Vec::new();
    let mut add = |place: Option<usize>, garment: &GarmentDesign| {
        let layer = place.map(|_| garment.layer);
        let name = garment.template.name_in(layer);
        let file_name = garment.template.file_name_in(layer);
        let id = numbered(&file_name, ids.iter().map(String::as_str));
        ids.push(id.clone());
        let cloth = Cloth::of(&garment.fabric, &garment.print);
        let on_table = |role| cloth.in_role(role, Lay::Single, None);
        let drafted = (measures.as_ref().map_err(Clone::clone))
            .and_then(|taken| garment.pattern(&fitting(design, (dancer, taken), (layer, garment))));
        let draft = match drafted.and_then(|pattern| fit_to_cloth(pattern, on_table)) {
            Ok(fitted) => Ok(GarmentPattern {
                template: garment.template,
                place,
                id,
                name,
                pattern: fitted.pattern,
                parts: fitted.parts,
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
    for place in design.cut() {
        match place {
            Some(index) => add(place, &design.garments[index]),
            None => add(None, &design.skirt.garment(&design.fabric, &design.print)),
        }
    }
    drafts
}

/// For whom a garment of a design is drafted, of what cloth and with what: in a layer, or as the skirt.
#[must_use]
pub fn fitting<'a>(
    design: &Design,
    (dancer, measures): (&'a Dancer, &'a Measures),
    (layer, garment): (Option<GarmentLayer>, &GarmentDesign),
) -> Fitting<'a> {
    Fitting {
        measures,
        alterations: design.alterations,
        dancer: Some(dancer),
        cloth_width: Some(garment.fabric.width()),
        skirt_edge: Some(skirt_edge(&design.skirt, dancer)),
        layer,
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
            } else if print.motif.is_alike_all_around() {
                Nap::AllWays
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

    /// The cloth of this role on the table; what lies beside the garment's own is plain.
    #[must_use]
    pub const fn in_role(
        &self,
        role: ClothRole,
        lay: Lay,
        matched_repeat: Option<Length>,
    ) -> TableCloth {
        if matches!(role, ClothRole::Main) {
            return self.on_table(lay, matched_repeat);
        }
        TableCloth {
            width: self.beside_width,
            nap: Nap::AllWays,
            border: None,
            ..self.on_table(lay, None)
        }
    }

    /// Mass of a length of it, or of cloth as heavy, of this width [kg].
    #[must_use]
    pub const fn mass(&self, length: Length, width: Length) -> f64 {
        length.to_m() * width.to_m() * self.areal_density
    }
}

/// Upper edge of a skirt above the floor.
fn skirt_edge(skirt: &SkirtDesign, dancer: &Dancer) -> Length {
    let gaps = f64::from(skirt.elastic_row_count - 1);
    let band_cm =
        skirt.header_cm + 0.5 * skirt.casing_cm + gaps * (skirt.casing_cm + skirt.casing_gap_cm);
    let worn = skirt
        .worn_height_cm
        .map(|cm| Length::from_cm(cm).to_m_f32());
    let worn = worn.unwrap_or(dancer.landmarks.asis_height);
    Length::from_m(f64::from(worn + Length::from_cm(band_cm).to_m_f32()))
}

#[cfg(test)]
mod tests {
    use lole_body::Measurements;
    use lole_pattern::{Alteration, Measure, TailorTape, Tailored};

    use super::*;
    use crate::document::{parse, to_toml};

    fn patterns(design: &Design) -> Vec<GarmentPattern> {
        let measurements = Measurements::from_tape(&design.tape()).unwrap();
        let dancer = Dancer::with_appearance(&measurements, &design.appearance()).unwrap();
        patterns_of(design, &dancer).unwrap()
    }

    #[test]
    fn every_garment_has_a_pattern_from_the_skin_outward() {
        let mut design = Design::default();
        let kinds = ["pau-skirt", "pau-top", "pau-skirt"];
        design.garments = kinds
            .into_iter()
            .filter_map(GarmentDesign::of_kind)
            .collect();
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

    #[test]
    fn a_wreath_depends_on_the_head_and_a_blouse_on_neck_and_arm() {
        let used = |kind: &str| {
            let mut design = Design::default();
            design.skirt.is_worn = false;
            design.garments = GarmentDesign::of_kind(kind).into_iter().collect();
            let measurements = Measurements::from_tape(&design.tape()).unwrap();
            let dancer = Dancer::with_appearance(&measurements, &design.appearance()).unwrap();
            let used = drafted_by(&design, &dancer).measures.into_iter();
            used.map(|used| used.measure).collect::<Vec<Measure>>()
        };
        assert_eq!(used("lei-poo"), [Measure::HeadGirth]);
        let blouse = used("blouse");
        for measure in [
            Measure::BustGirth,
            Measure::NeckGirth,
            Measure::UpperArmGirth,
            Measure::BackLength,
        ] {
            assert!(blouse.contains(&measure), "{measure:?} not in {blouse:?}");
        }
        assert!(!blouse.contains(&Measure::CrotchLength), "{blouse:?}");
    }

    /// A fitted garment is altered in six ways, a yoke that hangs on a fold in five, a skirt in none; each is shown
    /// on a piece that it changes.
    #[test]
    fn fitted_garments_are_altered_and_a_skirt_is_not() {
        let used = |kind: &str| {
            let mut design = Design::default();
            design.skirt.is_worn = kind == "skirt";
            design.garments = GarmentDesign::of_kind(kind).into_iter().collect();
            design.alterations = design.alterations.with_cm(Alteration::BroadBack, 1.5);
            let measurements = Measurements::from_tape(&design.tape()).unwrap();
            let dancer = Dancer::with_appearance(&measurements, &design.appearance()).unwrap();
            drafted_by(&design, &dancer).alterations
        };
        for kind in ["blouse", "holoku", "muumuu"] {
            let used = used(kind);
            let all = Alteration::ALL.into_iter();
            let wanted = all.filter(|one| kind != "muumuu" || *one != Alteration::SwayBack);
            let found = used.iter().map(|used| used.alteration);
            assert!(wanted.eq(found), "{kind}");
            for one in &used {
                let is_broad = one.alteration == Alteration::BroadBack;
                assert_eq!(one.cm, if is_broad { 1.5 } else { 0.0 });
                assert_ne!(one.shown[0].edges, one.shown[1].edges);
                assert_ne!(one.shown[0].id, "binding", "{kind} {:?}", one.alteration);
            }
        }
        assert!(used("skirt").is_empty() && used("malo").is_empty());
    }

    /// A design of much that is drafted, for one of these dancers.
    fn many_for([stature, bust, waist, hip]: [f64; 4]) -> Design {
        let mut design = Design::default();
        let tape = &mut design.dancer;
        (tape.stature_cm, tape.bust_cm) = (Some(stature), Some(bust));
        (tape.waist_cm, tape.hip_cm) = (Some(waist), Some(hip));
        let kinds = ["blouse", "muumuu", "holoku", "malo", "lei-poo", "kupee"];
        let listed = kinds.into_iter().filter_map(GarmentDesign::of_kind);
        design.garments = listed.collect();
        design
    }

    fn built(design: &Design) -> Dancer {
        let measurements = Measurements::from_tape(&design.tape()).unwrap();
        Dancer::to_measure(&measurements, &design.appearance()).unwrap()
    }

    /// What is written down as it is measured on her cuts what is cut without it, through the document, too.
    #[test]
    fn taking_what_she_has_cuts_the_same() {
        for body in DANCERS {
            let design = many_for(body);
            let dancer = built(&design);
            let own = measures(&dancer);
            let mut taken = design.clone();
            for one in Tailored::ALL {
                let cm = Some(one.measure().of(&own).to_cm());
                taken.dancer.tailor_tape = taken.dancer.tailor_tape.with_cm(one, cm);
            }
            let read = parse(&to_toml(&taken), "taken").unwrap();
            assert_eq!(read, taken);
            let [before, after] =
                [&design, &read].map(|design| patterns_of(design, &dancer).unwrap());
            for (one, other) in before.iter().zip(&after) {
                let edges = |garment: &GarmentPattern| -> Vec<f64> {
                    let pieces = garment.pattern.pieces.iter();
                    let edges = pieces.flat_map(|piece| &piece.edges);
                    edges.map(lole_pattern::piece::Edge::length).collect()
                };
                let (one, other) = (edges(one), edges(other));
                assert_eq!(one.len(), other.len());
                let mut pairs = one.iter().zip(&other);
                assert!(pairs.all(|(a, b)| (a - b).abs() < 1.0e-5), "{body:?}");
            }
        }
    }

    /// What is not of her body is refused by its key, in whatever garment; the nearest that is said is drafted.
    #[test]
    fn what_is_too_far_from_her_body_is_refused_by_its_key() {
        for body in DANCERS {
            let design = many_for(body);
            let dancer = built(&design);
            let own = measures(&dancer);
            for one in Tailored::ALL {
                let [least, most] = one.room_cm(one.measure().of(&own).to_cm());
                for (cm, is_fit) in [(least - 0.1, false), (least, true), (most + 0.1, false)] {
                    let mut taken = design.clone();
                    taken.dancer.tailor_tape = TailorTape::NONE.with_cm(one, Some(cm));
                    let drafts = drafts_of(&taken, &dancer);
                    let keys = drafts.iter().map(|(_, draft)| match draft {
                        Ok(_) => None,
                        Err(error) => error.dancer_key(),
                    });
                    let wanted = (!is_fit).then_some(one.key());
                    assert!(keys.into_iter().all(|key| key == wanted), "{one:?} {cm}");
                }
            }
        }
    }

    const DANCERS: [[f64; 4]; 4] = [
        [112.0, 58.0, 53.0, 61.0],
        [149.0, 76.0, 60.0, 84.0],
        [159.0, 104.0, 92.0, 112.0],
        [172.0, 90.0, 71.0, 98.0],
    ];

    /// The worked example of the makers: hip 91.4 cm, four times its cloth.
    #[test]
    fn the_skirt_is_four_times_the_hips_around() {
        let mut design = Design::default();
        design.dancer.hip_cm = Some(91.4);
        let patterns = patterns(&design);
        let cut = patterns[0].pattern.pieces[0].rectangle(1e-4).unwrap();
        assert!(
            (cut[0].to_cm() - (4.0 * 91.4 + 2.0)).abs() < 0.05,
            "{cut:?}"
        );
        let cloth = &patterns[0].cloth;
        let mass = cloth.mass(Length::from_yd(4.0), cloth.width);
        assert!((0.40..0.48).contains(&mass), "{mass}");
    }
}
