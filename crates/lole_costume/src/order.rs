//! A group's costumes: one design cut for every dancer of a list, and what the group buys.

mod together;
mod totals;

use lole_body::{BodyError, Dancer, Measure, Measurements};
use lole_garment::template::PAU_SKIRT;
use lole_geom::Length;
use lole_language::{Bilingual, Sentence, Words};
use lole_pattern::Yardage;
use lole_pattern::marker::{Lay, MarkerWarning};
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::piece::ClothRole;

use crate::document::{Design, GarmentDesign};
use crate::roster::{Roster, RosterDancer, RowProblem};
use crate::tailoring::{ClothPlan, GarmentPattern, TailoringError, patterns_of};

pub use together::{Share, SharedStrip};
pub use totals::{NotionTotal, PrintTotal, notions, prints};

/// What the buyer decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Cloth bought over what is needed, over it: prints are seldom printed again.
    pub spare_ratio: f64,
    /// Cloth on one bolt, where it is known.
    pub bolt_length: Option<Length>,
}

impl Default for Settings {
    /// One skirt in twenty may go wrong.
    fn default() -> Self {
        Self {
            spare_ratio: 0.05,
            bolt_length: None,
        }
    }
}

/// Everything one dancer's costume is cut from.
#[derive(Debug, Clone, PartialEq)]
pub struct DancerPlan {
    /// Who.
    pub name: String,
    /// Her tape with what was not measured filled in [cm], in the order of [`Measure::ALL`].
    pub tape_cm: Vec<(Measure, f64)>,
    /// What of it was not measured.
    pub estimated: Vec<Measure>,
    /// Her garments, from the skin outward.
    pub garments: Vec<PlannedGarment>,
}

/// One garment with where its pieces lie on its cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct PlannedGarment {
    /// Pieces, notions, steps and cloth.
    pub tailored: GarmentPattern,
    /// The pieces of each of its cloths laid out, its own cloth first.
    pub plans: Vec<ClothPlan>,
}

impl PlannedGarment {
    /// Its own cloth to buy; none where no piece is cut from it.
    #[must_use]
    pub fn bought(&self) -> Yardage {
        self.own_plan().map_or_else(
            || Yardage::for_length(Length::ZERO),
            |plan| plan.marker.yardage,
        )
    }

    /// What is cut from its own cloth; `None` where nothing is.
    #[must_use]
    pub fn own_plan(&self) -> Option<&ClothPlan> {
        self.plans.iter().find(|plan| plan.role == ClothRole::Main)
    }

    /// Pieces that are cut as rectangles: along the selvage and across, as often as they are cut.
    #[must_use]
    pub fn rectangles(&self) -> Vec<(Words, [Length; 2], u32)> {
        let pieces = self.tailored.cutting().pieces.iter();
        pieces
            .filter_map(|piece| {
                let [width, height] = piece.rectangle(CURVE_TOLERANCE)?;
                let sizes = if piece.is_on_bias() || piece.grain.y.abs() < piece.grain.x.abs() {
                    [width, height]
                } else {
                    [height, width]
                };
                Some((piece.name, sizes, piece.cut.pieces()))
            })
            .collect()
    }

    /// Its elastics to cut, from the top down; neighbors of one length and place together.
    #[must_use]
    pub fn elastics(&self) -> Vec<CutElastic> {
        let notions = self.tailored.pattern.notions.iter();
        let elastics = notions.filter(|notion| notion.kind == NotionKind::Elastic);
        elastics.fold(Vec::new(), |mut cut: Vec<CutElastic>, notion| {
            let Amount::Length(all) = notion.amount else {
                return cut;
            };
            let one = CutElastic {
                place: notion.place,
                length: all * (1.0 / f64::from(notion.pieces.max(1))),
                count: notion.pieces.max(1),
            };
            match cut.last_mut() {
                Some(last) if last.place == one.place && is_same(last.length, one.length) => {
                    last.count += one.count;
                }
                _ => cut.push(one),
            }
            cut
        })
    }
}

/// Equal pieces of elastic to cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutElastic {
    /// Where they go, where that is one place of the garment.
    pub place: Option<Words>,
    /// Length of each.
    pub length: Length,
    /// How many.
    pub count: u32,
}

/// Elastics are cut to the millimeter.
fn is_same(one: Length, other: Length) -> bool {
    (one - other).to_cm().abs() < 0.05
}

/// Farthest that drawn lines are from their curves [m].
const CURVE_TOLERANCE: f64 = 1e-4;

/// Why a dancer's costume cannot be cut.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// Her tape makes no body.
    #[error("{0}")]
    Body(#[from] BodyError),
    /// A garment cannot be drafted to it.
    #[error("{0}")]
    Tailoring(#[from] TailoringError),
}

impl PlanError {
    /// Whether a garment's cloth is too narrow for it.
    #[must_use]
    pub fn is_too_wide(&self) -> bool {
        matches!(self, Self::Tailoring(error) if error.is_too_wide())
    }

    /// The key of `[dancer]` that is the cause, where what was taken of her is.
    #[must_use]
    pub fn dancer_key(&self) -> Option<&'static str> {
        match self {
            Self::Tailoring(error) => error.dancer_key(),
            Self::Body(_) => None,
        }
    }
}

impl Bilingual for PlanError {
    fn japanese(&self) -> String {
        match self {
            Self::Body(error) => error.japanese(),
            Self::Tailoring(error) => error.japanese(),
        }
    }
}

/// Cuts a design for one dancer of a list.
///
/// # Errors
/// A tape that makes no body, or a garment that cannot be drafted to it.
pub fn plan(dancer: &RosterDancer, design: &Design) -> Result<DancerPlan, PlanError> {
    plan_design(&dancer.name, &dancer.design(design))
}

/// Cuts a design for its own dancer.
///
/// # Errors
/// As [`plan`].
pub fn plan_design(name: &str, design: &Design) -> Result<DancerPlan, PlanError> {
    let tape = design.tape();
    let measurements = Measurements::from_tape(&tape)?;
    let dancer = Dancer::to_measure(&measurements, &design.appearance())?;
    plan_dancer(name, design, &dancer)
}

/// Cuts a design for a dancer who stands there already.
///
/// # Errors
/// A garment that cannot be drafted to her.
pub fn plan_dancer(name: &str, design: &Design, dancer: &Dancer) -> Result<DancerPlan, PlanError> {
    let tape = design.tape();
    let taped = dancer.taped(&tape);
    let garments = patterns_of(design, dancer)?
        .into_iter()
        .map(|tailored| {
            let plans = tailored.cloth_plans(Lay::Single, None);
            PlannedGarment { tailored, plans }
        })
        .collect();
    Ok(DancerPlan {
        name: name.to_owned(),
        tape_cm: (taped.iter())
            .map(|taped| (taped.measure, taped.on_body.to_cm()))
            .collect(),
        estimated: (Measure::ALL.into_iter())
            .filter(|measure| measure.of(&tape).is_none())
            .collect(),
        garments,
    })
}

/// A list of dancers, cut.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Everybody who can be cut for, in the order of the list.
    pub plans: Vec<DancerPlan>,
    /// What each of them wears, to her measures.
    pub designs: Vec<Design>,
    /// Rows that cannot be used, with line and column, in the order of the list.
    pub problems: Vec<Sentence>,
    /// The line of each.
    problem_lines: Vec<u32>,
    /// Dancers who are left out because the cloth is too narrow for their size.
    pub too_wide_count: usize,
    /// What was not read, or read otherwise than it is written.
    pub notes: Vec<Sentence>,
}

impl Group {
    /// Nobody yet.
    #[must_use]
    pub fn of(list: &Roster) -> Self {
        Self {
            plans: Vec::new(),
            designs: Vec::new(),
            problems: list.problems.iter().map(RowProblem::sentence).collect(),
            problem_lines: list.problems.iter().map(|problem| problem.line).collect(),
            too_wide_count: 0,
            notes: list.notes.clone(),
        }
    }

    /// Takes in what was cut for a dancer of the list; whoever cannot be cut for is told and left out.
    pub fn add(
        &mut self,
        dancer: &RosterDancer,
        design: &Design,
        cut: Result<DancerPlan, PlanError>,
    ) {
        match cut {
            Ok(plan) => {
                self.plans.push(plan);
                self.designs.push(dancer.design(design));
            }
            Err(error) => {
                self.too_wide_count += usize::from(error.is_too_wide());
                let problem = RowProblem {
                    line: dancer.line,
                    column: None,
                    what: Sentence::new(
                        format!("{}: {}", dancer.name, error.japanese()),
                        format!("{}: {error}", dancer.name),
                    ),
                };
                let lines = &mut self.problem_lines;
                let place = lines.partition_point(|&line| line <= dancer.line);
                lines.insert(place, dancer.line);
                self.problems.insert(place, problem.sentence());
            }
        }
    }
}

/// A piece that is wider than its cloth, for some dancers.
struct TooWide<'a> {
    garment: Words,
    widest: MarkerWarning,
    names: Vec<&'a str>,
}

impl TooWide<'_> {
    fn sentence(&self) -> Sentence {
        let (first, others) = (self.names[0], self.names.len() - 1);
        let widest = self.widest.of_garment(self.garment);
        if others == 0 {
            return Sentence::new(
                format!("{first}: {}", widest.japanese()),
                format!("{first}: {widest}"),
            );
        }
        Sentence::new(
            format!(
                "{first} ほか {others} 人: {}（いちばん大きい人の場合）",
                widest.japanese()
            ),
            format!("{first} and {others} more: {widest} (of the widest)"),
        )
    }
}

impl Group {
    /// What should be decided before cutting: pieces that are wider than their cloth, each with those
    /// whom it concerns and by its widest.
    #[must_use]
    pub fn warnings(&self) -> Vec<Sentence> {
        let garments = (self.plans.iter())
            .flat_map(|plan| plan.garments.iter().map(|garment| (&plan.name, garment)));
        let laid = garments.flat_map(|(name, garment)| {
            let warnings = garment.plans.iter().flat_map(|plan| &plan.marker.warnings);
            warnings.map(|warning| (name.as_str(), garment.tailored.name, *warning))
        });
        let mut wide: Vec<TooWide<'_>> = Vec::new();
        for (name, garment, warning) in laid {
            let (piece, size) = warning.piece();
            let is_known = |known: &&mut TooWide<'_>| {
                (known.garment, known.widest.piece().0) == (garment, piece)
            };
            let Some(known) = wide.iter_mut().find(is_known) else {
                wide.push(TooWide {
                    garment,
                    widest: warning,
                    names: vec![name],
                });
                continue;
            };
            known.names.push(name);
            if known.widest.piece().1 < size {
                known.widest = warning;
            }
        }
        wide.iter().map(TooWide::sentence).collect()
    }
}

impl Design {
    /// Height of the costume's hem above the floor [cm]: of its pāʻū where it has one, else of the
    /// lowest garment whose hem was decided. `None` where nothing says one, as of a lei.
    #[must_use]
    pub fn costume_hem_cm(&self) -> Option<f64> {
        if self.skirt.is_worn {
            return Some(self.skirt.hem_height_cm);
        }
        let lowest = |is_meant: fn(&GarmentDesign) -> bool| {
            let meant = self.garments.iter().filter(|garment| is_meant(garment));
            let decided = meant.filter_map(|garment| garment.option("hem_height_cm"));
            decided.reduce(f64::min)
        };
        lowest(|garment| garment.template == &PAU_SKIRT).or_else(|| lowest(|_| true))
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::roster;
    use lole_garment::template::PAU_TOP;

    /// The design cut for its own dancer.
    pub(crate) fn plan_of(design: &Design) -> DancerPlan {
        plan_design("花子", design).unwrap_or_else(|error| panic!("{error}"))
    }

    fn plans(design: &Design) -> Vec<DancerPlan> {
        let list = "name,stature,hip\na,150,85\nb,158,91.4\nc,171,101\n";
        let roster = roster::read(list.as_bytes()).unwrap();
        let plans = roster.dancers.iter().map(|dancer| plan(dancer, design));
        plans.collect::<Result<_, _>>().unwrap()
    }

    /// Four times the hips and two seam allowances, for each of them.
    #[test]
    fn every_dancer_gets_her_own_cut() {
        let plans = plans(&Design::default());
        for (plan, hip) in plans.iter().zip([85.0, 91.4, 101.0]) {
            let (_, [along, across], count) = plan.garments[0].rectangles()[0];
            assert!(
                (along.to_cm() - (4.0 * hip + 2.0)).abs() < 1e-6,
                "{along:?}"
            );
            assert!((50.0..130.0).contains(&across.to_cm()) && count == 1);
            assert_eq!(plan.garments[0].elastics()[0].count, 3);
            assert_eq!(plan.estimated.len(), 12);
        }
        let height = |index: usize| plans[index].garments[0].rectangles()[0].1[1].to_cm();
        // One hem above the floor: taller dancers wear longer skirts.
        assert!(height(0) < height(1) && height(1) < height(2));
    }

    #[test]
    fn garments_that_are_only_drafted_are_bought_too() {
        let mut design = Design::default();
        let listed = ["pau-top", "ti-leaf-skirt", "kikepa"];
        design.garments = listed.map(|id| GarmentDesign::of_kind(id).unwrap()).into();
        let cut = plans(&design);
        let totals = prints(&cut, &design, &Settings::default());
        // The top and the wrap are of one plain cloth; leaves are no cloth.
        let names: Vec<usize> = totals.iter().map(|total| total.garments.len()).collect();
        assert_eq!(names, [1, 2]);
        let needed = totals
            .iter()
            .fold(0.0, |sum, total| sum + total.needed.to_m());
        let garments = cut.iter().flat_map(|plan| &plan.garments);
        let cut: f64 = garments.map(|garment| garment.bought().needed.to_m()).sum();
        // Cut together they need no more.
        assert!(0.0 < needed && needed < cut + 1e-9, "{needed} of {cut} m");
    }

    #[test]
    fn garments_of_one_print_are_bought_together() {
        let mut design = Design::default();
        design.garments = vec![GarmentDesign {
            fabric: design.fabric.clone(),
            print: design.print.clone(),
            ..GarmentDesign::new(&PAU_TOP)
        }];
        let cut = plans(&design);
        let settings = Settings::default();
        let together = prints(&cut, &design, &settings);
        assert_eq!(together.len(), 1);
        assert_eq!(together[0].garments.len(), 2);
        design.print.colorway = "blue";
        let apart = prints(&cut, &design, &settings);
        assert_eq!(apart.len(), 2);
        let sum = apart[0].needed + apart[1].needed;
        assert!((together[0].needed - sum).to_m() < 1e-9);
        let with_spare = together[0].needed * 1.05;
        let over = (together[0].bought.metric - with_spare).to_cm();
        assert!((-2.0..10.0).contains(&over), "{over} cm");
    }

    #[test]
    fn elastic_of_a_group_is_the_sum_and_what_is_spare() {
        let plans = plans(&Design::default());
        let elastics = plans.iter().flat_map(|plan| plan.garments[0].elastics());
        let sum: f64 = elastics
            .map(|elastic| elastic.length.to_m() * f64::from(elastic.count))
            .sum();
        let settings = Settings {
            spare_ratio: 0.08,
            ..Settings::default()
        };
        let total = notions(&plans, &settings);
        let Amount::Length(length) = total[0].amount else {
            panic!("elastic is sold by length")
        };
        assert!((length.to_m() - 1.08 * sum).abs() < 1e-9);
    }
}
