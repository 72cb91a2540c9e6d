//! Everything of a design on paper: each garment drafted and laid out, with its print and its cost.
//!
//! A garment that cannot be drafted says why and leaves the others as they are.

use std::sync::Arc;

use lole_body::Dancer;
use lole_costume::cost::{self, Bill};
use lole_costume::document::GarmentDesign;
use lole_costume::document::{Design, PrintChoice};
use lole_costume::order::{DancerPlan, PlannedGarment};
use lole_costume::tailoring::{TailoringError, drafts_of};
use lole_export::cutting::lying_width;
use lole_garment::template::PAU_SKIRT;
use lole_geom::Length;
use lole_language::{Sentence, Words};
use lole_pattern::marker::Lay;
use lole_pattern::piece::ClothRole;
use lole_pattern::{DraftError, Marker};
use lole_print::{ClothPicture, PrintImage, cloth_picture};

/// A drawn repeat has so many pixels on a side: motifs are as large on the plan as a fingernail.
const PRINT_SIDE: u32 = 384;

/// How cloth is laid to be cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cutting {
    /// Single or doubled.
    pub lay: Lay,
    /// Whether the print meets at the seams.
    pub matches_print: bool,
}

/// A design on paper.
#[derive(Debug, Clone)]
pub struct PaperDesign {
    /// The design that it is of.
    pub design: Design,
    /// No two papers of a window share one.
    pub number: u64,
    /// From the skin outward; empty where the dancer's tape makes no body.
    pub garments: Vec<PaperGarment>,
    /// What everything that can be drafted costs.
    pub bill: Option<Bill>,
}

/// One garment on paper.
#[derive(Debug, Clone)]
pub struct PaperGarment {
    /// Its place in the design's list, from 0; the skirt has none.
    pub place: Option<usize>,
    /// What it is called.
    pub name: Words,
    /// Its pieces laid out, or why it cannot be drafted.
    pub cut: Result<PlannedGarment, DraftTrouble>,
    /// The cloth of each of its plans with the print; `None` of cloth beside its own.
    pub pictures: Vec<Option<ClothPicture>>,
}

/// Why a garment cannot be drafted.
#[derive(Debug, Clone, PartialEq)]
pub struct DraftTrouble {
    /// Key of the option to look at, where it is one.
    pub key: Option<&'static str>,
    /// What is wrong and what to do.
    pub sentence: Sentence,
}

impl DraftTrouble {
    fn of(error: &TailoringError) -> Self {
        let key = match *error.error {
            DraftError::Option { key, .. } => Some(key),
            _ => None,
        };
        Self {
            key,
            sentence: Sentence::of(&*error.error),
        }
    }
}

/// Repeats that were drawn, so that they are not drawn again while something else is changed.
#[derive(Debug, Default)]
pub(crate) struct DrawnPrints(Vec<(PrintChoice, Length, Arc<PrintImage>)>);

impl DrawnPrints {
    /// Draws what is new and forgets what is not asked for.
    fn draw(&mut self, wanted: &[(PrintChoice, Length)]) -> Vec<Option<Arc<PrintImage>>> {
        let mut kept = Vec::new();
        let mut images = Vec::new();
        for (print, width) in wanted {
            let known = (self.0.iter()).find(|(other, of, _)| other == print && of == width);
            let image = match known {
                Some((_, _, image)) => Some(Arc::clone(image)),
                // A picture that was not read is told where it is chosen.
                None => print.image(PRINT_SIDE, *width).ok().map(Arc::new),
            };
            kept.extend(image.clone().map(|image| (print.clone(), *width, image)));
            images.push(image);
        }
        self.0 = kept;
        images
    }
}

impl PaperDesign {
    /// Drafts and lays out everything for a dancer who has the design's tape.
    #[must_use]
    pub fn of(design: &Design, cutting: Cutting, dancer: &Dancer) -> Self {
        Self::drawn(design, cutting, dancer, &mut DrawnPrints::default())
    }

    /// Drafts and lays out everything for a dancer who has the design's tape; prints that are drawn
    /// already are taken as they are.
    pub(crate) fn drawn(
        design: &Design,
        cutting: Cutting,
        dancer: &Dancer,
        prints: &mut DrawnPrints,
    ) -> Self {
        let drafts = drafts_of(design, dancer);
        let cloth = |place: Option<usize>| match place.and_then(|at| design.garments.get(at)) {
            Some(garment) => (garment.print.clone(), garment.fabric.width()),
            None => (design.print.clone(), design.fabric.width()),
        };
        let wanted: Vec<_> = drafts.iter().map(|(place, _)| cloth(*place)).collect();
        let images = prints.draw(&wanted);
        let garments = drafts
            .into_iter()
            .zip(images)
            .map(|((place, draft), image)| {
                let listed = place.and_then(|at| design.garments.get(at));
                let cut = draft
                    .map_err(|error| DraftTrouble::of(&error))
                    .map(|tailored| {
                        let repeat = tailored.cloth.repeat.filter(|_| cutting.matches_print);
                        let plans = tailored.cloth_plans(cutting.lay, repeat);
                        PlannedGarment { tailored, plans }
                    });
                let plans = cut.as_ref().map_or(&[][..], |cut| &cut.plans);
                let picture = |role, marker: &Marker| {
                    let image = image.as_ref().filter(|_| role == ClothRole::Main)?;
                    Some(cloth_picture(image, marker, lying_width(marker)))
                };
                PaperGarment {
                    place,
                    name: listed.map_or(PAU_SKIRT.name, GarmentDesign::name),
                    pictures: (plans.iter())
                        .map(|plan| picture(plan.role, &plan.marker))
                        .collect(),
                    cut,
                }
            });
        let garments: Vec<PaperGarment> = garments.collect();
        Self {
            bill: bill(design, &garments),
            design: design.clone(),
            number: 0,
            garments,
        }
    }

    /// The paper of a garment, if it is still of that one: `None` stands for the skirt.
    #[must_use]
    pub fn garment(&self, place: Option<usize>, design: &Design) -> Option<&PaperGarment> {
        let kind = |design: &Design| Some(design.garments.get(place?)?.kind_id());
        let found = self
            .garments
            .iter()
            .find(|garment| garment.place == place)?;
        (kind(design) == kind(&self.design)).then_some(found)
    }
}

/// What everything that can be drafted costs; `None` where even the skirt cannot be.
fn bill(design: &Design, garments: &[PaperGarment]) -> Option<Bill> {
    let mut priced = design.clone();
    let mut left_out: Vec<usize> = Vec::new();
    let mut cut = Vec::new();
    for garment in garments {
        match (&garment.cut, garment.place) {
            (Ok(planned), _) => cut.push(planned.clone()),
            (Err(_), Some(place)) => left_out.push(place),
            (Err(_), None) => return None,
        }
    }
    left_out.sort_unstable();
    for place in left_out.into_iter().rev() {
        priced.garments.remove(place);
    }
    let plan = DancerPlan {
        name: String::new(),
        tape_cm: Vec::new(),
        estimated: Vec::new(),
        garments: cut,
    };
    Some(cost::bill(&priced, &plan))
}

#[cfg(test)]
pub(crate) mod tests {
    use lole_costume::document::GarmentDesign;

    use super::*;

    /// The paper of a design, without a thread.
    pub(crate) fn paper_of(design: &Design) -> PaperDesign {
        let dancer = lole_stage::dancer(design).unwrap_or_else(|error| panic!("{error}"));
        PaperDesign::of(design, Cutting::default(), &dancer.0)
    }

    #[test]
    fn a_garment_that_cannot_be_drafted_says_why_and_leaves_the_others() {
        let mut design = Design::default();
        let listed = ["blouse", "ti-leaf-skirt"];
        design.garments = listed.map(|id| GarmentDesign::of_kind(id).unwrap()).into();
        let whole = paper_of(&design);
        assert!(whole.garments.iter().all(|garment| garment.cut.is_ok()));
        design.garments[0] = design.garments[0].clone().with(&[("bust_ease_cm", 99.0)]);
        let paper = paper_of(&design);
        let blouse = paper.garment(Some(0), &design).unwrap();
        let trouble = blouse.cut.as_ref().unwrap_err();
        assert_eq!(trouble.key, Some("bust_ease_cm"));
        assert!(trouble.sentence.english.contains("99"));
        assert!(paper.garment(Some(1), &design).unwrap().cut.is_ok());
        // Its cloth is not on the bill, whatever notions go with it; that of the others is.
        let names = |paper: &PaperDesign| {
            let lines = paper.bill.iter().flat_map(|bill| &bill.lines);
            lines
                .map(|line| line.name.english.clone())
                .collect::<Vec<_>>()
        };
        let names_it = |name: &String| name.contains("blouse");
        assert!(names(&whole).iter().any(names_it));
        let left = names(&paper);
        assert!(!left.iter().any(names_it));
        assert!(left.iter().all(|name| names(&whole).contains(name)));
    }

    #[test]
    fn wider_cloth_needs_less_of_it_and_the_picture_covers_the_cloth() {
        let mut design = Design::default();
        let narrow = paper_of(&design);
        design.garments = vec![GarmentDesign::of_kind("muumuu").unwrap()];
        design.garments[0].fabric.width_cm = 150.0;
        let wide = paper_of(&design);
        fabric_width(&mut design, 110.0);
        let narrower = paper_of(&design);
        let needed = |paper: &PaperDesign| {
            let garment = paper
                .garments
                .iter()
                .find(|garment| garment.place == Some(0));
            garment.unwrap().cut.as_ref().unwrap().bought().needed
        };
        assert!(needed(&wide) < needed(&narrower));
        let picture = narrow.garments[0].pictures[0].as_ref().unwrap();
        let marker = &narrow.garments[0].cut.as_ref().unwrap().plans[0].marker;
        let aspect = f64::from(picture.width) / f64::from(picture.height);
        let cloth = marker.yardage.needed.to_m() / lying_width(marker).to_m();
        assert!((aspect / cloth - 1.0).abs() < 0.01, "{aspect} {cloth}");
    }

    fn fabric_width(design: &mut Design, width_cm: f64) {
        design.garments[0].fabric.width_cm = width_cm;
    }
}
