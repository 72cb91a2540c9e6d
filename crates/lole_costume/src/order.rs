//! A group's costumes: one design cut for every dancer of a list, and what the group buys.

use lole_body::{BodyError, Dancer, Measure, Measurements};
use lole_geom::Length;
use lole_language::{Bilingual, Sentence, Words};
use lole_pattern::Yardage;
use lole_pattern::marker::{Lay, MarkerWarning};
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::piece::ClothRole;
use lole_print::PrintMotif;

use crate::cost::ClothPrice;
use crate::document::{Design, FabricDesign, GarmentDesign, GarmentLayer, PrintChoice};
use crate::roster::{Roster, RosterDancer, RowProblem};
use crate::tailoring::{ClothPlan, GarmentPattern, SKIRT, TailoringError, patterns_of, role_name};

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
        let pieces = self.tailored.pattern.pieces.iter();
        pieces
            .filter_map(|piece| {
                let [width, height] = piece.drawing(CURVE_TOLERANCE).rectangle?;
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
    let dancer = Dancer::with_appearance(&measurements, &design.appearance())?;
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
        let skirts = self.garments.iter().filter_map(|garment| match garment {
            GarmentDesign::PauSkirt(worn) => Some(worn.skirt.hem_height_cm),
            _ => None,
        });
        let decided = self.garments.iter().filter_map(|garment| match garment {
            GarmentDesign::Template(worn) => {
                let position = worn.template.position("hem_height_cm")?;
                worn.options.get(position)
            }
            _ => None,
        });
        (skirts.reduce(f64::min)).or_else(|| decided.reduce(f64::min))
    }

    /// Cloth and print of every garment, in the order of [`patterns_of`].
    pub(crate) fn cloths(&self) -> Vec<(&FabricDesign, &PrintChoice)> {
        let of_layer = |layer| {
            let garments = self.listed_in(layer);
            garments.map(|(_, garment)| (garment.fabric(), garment.print()))
        };
        of_layer(GarmentLayer::Under)
            .chain(self.skirt.is_worn.then_some((&self.fabric, &self.print)))
            .chain(of_layer(GarmentLayer::Over))
            .collect()
    }

    /// Cloth of every garment, in the order of [`patterns_of`].
    pub(crate) fn fabrics(&self) -> impl Iterator<Item = &FabricDesign> {
        self.cloths().into_iter().map(|(fabric, _)| fabric)
    }
}

/// What a group buys of one print.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintTotal {
    /// The garments that are cut from it.
    pub garments: Vec<Words>,
    /// The cloth.
    pub cloth: Words,
    /// What is printed on it.
    pub print: PrintChoice,
    /// What it is in the garments: their own cloth, lining and so on.
    pub role: ClothRole,
    /// What it costs.
    pub price: ClothPrice,
    /// Width of the cloth.
    pub width: Length,
    /// What the pieces need, each dancer's rounded up by herself.
    pub needed: Length,
    /// To ask for, with what is spare.
    pub bought: Yardage,
    /// Where the bolt's length is known: what is cut from each bolt, as places among the dancers with
    /// lengths, longest first.
    pub bolts: Vec<Vec<(usize, Length)>>,
    /// Dancers whose piece is longer than a bolt.
    pub longer_than_bolt: Vec<usize>,
}

/// What a group buys of each print.
#[must_use]
pub fn prints(plans: &[DancerPlan], design: &Design, settings: &Settings) -> Vec<PrintTotal> {
    let cloths = design.cloths();
    let mut kinds: Vec<Vec<usize>> = Vec::new();
    for (index, cloth) in cloths.iter().enumerate() {
        match kinds.iter_mut().find(|kind| cloths[kind[0]] == *cloth) {
            Some(kind) => kind.push(index),
            None => kinds.push(vec![index]),
        }
    }
    let total = |kind: &Vec<usize>| {
        let (fabric, print) = cloths[kind[0]];
        let mut cuts = Vec::new();
        let mut garments = Vec::new();
        for (dancer, plan) in plans.iter().enumerate() {
            let of_kind = kind.iter().filter_map(|&index| plan.garments.get(index));
            // Leaves and flowers need no cloth.
            for garment in of_kind.filter(|garment| garment.own_plan().is_some()) {
                cuts.push((dancer, garment.bought().needed));
                if !garments.contains(&garment.tailored.name) {
                    garments.push(garment.tailored.name);
                }
            }
        }
        let needed = cuts
            .iter()
            .fold(Length::ZERO, |sum, &(_, length)| sum + length);
        let (bolts, longer_than_bolt) = match settings.bolt_length {
            Some(length) => bolts(&cuts, length),
            None => (Vec::new(), Vec::new()),
        };
        PrintTotal {
            garments,
            cloth: Words {
                japanese: fabric.preset.name_ja,
                english: fabric.preset.name,
            },
            print: print.clone(),
            role: ClothRole::Main,
            price: ClothPrice::of(fabric, ClothRole::Main, first_of(plans, kind)),
            width: Length::from_cm(fabric.width_cm),
            needed,
            bought: Yardage::for_length(needed * (1.0 + settings.spare_ratio)),
            bolts,
            longer_than_bolt,
        }
    };
    let totals = kinds
        .iter()
        .map(total)
        .chain(beside(plans, design, settings));
    totals.filter(|total| Length::ZERO < total.needed).collect()
}

/// Identifier of the garment whose table is asked for the price of a cloth: the skirt's own where it is
/// among those of the cloth, else the first.
fn first_of<'a>(plans: &'a [DancerPlan], kind: &[usize]) -> &'a str {
    let garments = plans.first().map_or(&[][..], |plan| &plan.garments);
    let ids = kind.iter().filter_map(|&index| garments.get(index));
    let ids: Vec<&str> = ids.map(|garment| garment.tailored.id.as_str()).collect();
    let skirt = ids.iter().find(|id| **id == SKIRT);
    skirt.or(ids.first()).copied().unwrap_or_default()
}

/// Lining, contrast cloth and interfacing of a group, each of one width together.
fn beside(plans: &[DancerPlan], design: &Design, settings: &Settings) -> Vec<PrintTotal> {
    let mut totals: Vec<PrintTotal> = Vec::new();
    let garments = (plans.iter()).flat_map(|plan| plan.garments.iter().zip(design.fabrics()));
    for (garment, fabric) in garments {
        let name = garment.tailored.name;
        let beside = garment.plans.iter();
        for plan in beside.filter(|plan| plan.role != ClothRole::Main) {
            let (width, needed) = (plan.marker.cloth.width, plan.marker.yardage.needed);
            let price = ClothPrice::of(fabric, plan.role, &garment.tailored.id);
            let is_same = |total: &&mut PrintTotal| {
                (total.role, total.width, total.price) == (plan.role, width, price)
            };
            if let Some(total) = totals.iter_mut().find(is_same) {
                total.needed = total.needed + needed;
                if !total.garments.contains(&name) {
                    total.garments.push(name);
                }
                continue;
            }
            let total = PrintTotal {
                garments: vec![name],
                cloth: role_name(plan.role),
                print: PrintChoice {
                    motif: PrintMotif::Plain,
                    ..PrintChoice::default()
                },
                role: plan.role,
                price,
                width,
                needed,
                bought: plan.marker.yardage,
                bolts: Vec::new(),
                longer_than_bolt: Vec::new(),
            };
            totals.push(total);
        }
    }
    let with_spare = |total: PrintTotal| PrintTotal {
        bought: Yardage::for_length(total.needed * (1.0 + settings.spare_ratio)),
        ..total
    };
    totals.into_iter().map(with_spare).collect()
}

/// What is cut from each bolt, so that no piece spans the end of one: the longest piece first, each
/// from the first bolt that still holds it (first fit, decreasing: at most 11/9 of the fewest bolts,
/// Johnson 1973).
fn bolts(cuts: &[(usize, Length)], bolt: Length) -> (Vec<Vec<(usize, Length)>>, Vec<usize>) {
    let mut sorted = cuts.to_vec();
    // Equal lengths stay in the order of the list.
    sorted.sort_by(|(_, one), (_, other)| other.to_m().total_cmp(&one.to_m()));
    let mut bolts: Vec<(Length, Vec<(usize, Length)>)> = Vec::new();
    let mut too_long = Vec::new();
    for (dancer, length) in sorted {
        if bolt < length {
            too_long.push(dancer);
            continue;
        }
        let room = bolts.iter_mut().find(|(left, _)| length <= *left);
        match room {
            Some((left, cut)) => {
                *left = *left - length;
                cut.push((dancer, length));
            }
            None => bolts.push((bolt - length, vec![(dancer, length)])),
        }
    }
    let bolts = bolts.into_iter().map(|(_, cut)| cut).collect();
    (bolts, too_long)
}

/// A group's notions of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct NotionTotal {
    /// What to ask for.
    pub name: Words,
    /// How much of it.
    pub amount: Amount,
    /// What sort of thing it is.
    pub kind: NotionKind,
    /// Length of each where they are counted but have one, as zips: whole centimeters.
    pub length: Option<Length>,
}

/// An opening's length as zips are sold: the next whole centimeter.
fn whole_cm(amount: Amount) -> Length {
    match amount {
        Amount::Length(length) => Length::from_cm((length.to_cm() - 1e-6).ceil()),
        Amount::Count(_) | Amount::Mass(_) => Length::ZERO,
    }
}

/// Everything a group buys beside cloth, equal things together.
#[must_use]
pub fn notions(plans: &[DancerPlan]) -> Vec<NotionTotal> {
    let mut totals: Vec<NotionTotal> = Vec::new();
    let garments = plans.iter().flat_map(|plan| &plan.garments);
    for notion in garments.flat_map(|garment| &garment.tailored.pattern.notions) {
        let is_zip = notion.kind == NotionKind::Zip;
        let same = totals.iter_mut().find(|total| {
            // Zips are bought by the piece, each of its length.
            total.name == notion.name && (!is_zip || total.length == Some(whole_cm(notion.amount)))
        });
        let Some(total) = same else {
            totals.push(NotionTotal {
                name: notion.name,
                amount: if is_zip {
                    Amount::Count(1)
                } else {
                    notion.amount
                },
                kind: notion.kind,
                length: is_zip.then(|| whole_cm(notion.amount)),
            });
            continue;
        };
        if is_zip {
            if let Amount::Count(count) = &mut total.amount {
                *count += 1;
            }
            continue;
        }
        total.amount = match (total.amount, notion.amount) {
            (Amount::Length(one), Amount::Length(other)) => Amount::Length(one + other),
            (Amount::Count(one), Amount::Count(other)) => Amount::Count(one + other),
            (Amount::Mass(one), Amount::Mass(other)) => Amount::Mass(one + other),
            (kept, _) => kept,
        };
    }
    // Zips of each sort stand together, the shortest first.
    let names: Vec<Words> = totals.iter().map(|total| total.name).collect();
    let place = |total: &NotionTotal| names.iter().position(|name| *name == total.name);
    let long = |total: &NotionTotal| total.length.map_or(0.0, Length::to_m);
    totals.sort_by(|one, other| {
        (place(one).cmp(&place(other))).then(long(one).total_cmp(&long(other)))
    });
    totals
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::document::WornTop;
    use crate::roster;

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
        assert!((needed - cut).abs() < 1e-9, "{needed} of {cut} m");
    }

    #[test]
    fn garments_of_one_print_are_bought_together() {
        let mut design = Design::default();
        design.garments = vec![GarmentDesign::PauTop(WornTop {
            fabric: design.fabric.clone(),
            print: design.print.clone(),
            ..WornTop::default()
        })];
        let cut = plans(&design);
        let settings = Settings::default();
        let together = prints(&cut, &design, &settings);
        assert_eq!(together.len(), 1);
        assert_eq!(together[0].garments.len(), 2);
        design.print.colorway = "blue";
        let apart = prints(&cut, &design, &settings);
        assert_eq!(apart.len(), 2);
        let sum = apart[0].needed + apart[1].needed;
        assert!((sum - together[0].needed).to_m().abs() < 1e-9);
        let with_spare = together[0].needed * 1.05;
        let over = (together[0].bought.metric - with_spare).to_cm();
        assert!((-2.0..10.0).contains(&over), "{over} cm");
    }

    #[test]
    fn no_piece_spans_two_bolts() {
        let cuts: Vec<(usize, Length)> = [3.7, 3.9, 2.5, 4.1, 1.2, 3.3, 25.0]
            .into_iter()
            .enumerate()
            .map(|(index, meters)| (index, Length::from_m(meters)))
            .collect();
        let (bolts, too_long) = bolts(&cuts, Length::from_m(8.0));
        assert_eq!(too_long, [6]);
        let mut seen: Vec<usize> = Vec::new();
        for bolt in &bolts {
            let length: f64 = bolt.iter().map(|(_, length)| length.to_m()).sum();
            assert!(length <= 8.0 + 1e-9, "{length}");
            seen.extend(bolt.iter().map(|&(dancer, _)| dancer));
        }
        seen.sort_unstable();
        assert_eq!(seen, [0, 1, 2, 3, 4, 5]);
        // 18.7 m need at least three bolts of 8 m.
        assert_eq!(bolts.len(), 3);
    }

    #[test]
    fn elastic_of_a_group_is_the_sum() {
        let plans = plans(&Design::default());
        let elastics = plans.iter().flat_map(|plan| plan.garments[0].elastics());
        let sum: f64 = elastics
            .map(|elastic| elastic.length.to_m() * f64::from(elastic.count))
            .sum();
        let total = notions(&plans);
        let Amount::Length(length) = total[0].amount else {
            panic!("elastic is sold by length")
        };
        assert!((length.to_m() - sum).abs() < 1e-9);
    }
}
