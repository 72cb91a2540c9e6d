//! What a group buys: cloth by print, and everything beside cloth.

use lole_geom::Length;
use lole_language::Words;
use lole_pattern::Yardage;
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::piece::ClothRole;
use lole_print::PrintMotif;

use super::{DancerPlan, PlannedGarment, Settings};
use crate::cost::ClothPrice;
use crate::document::{Design, FabricDesign, PrintChoice};
use crate::tailoring::{SKIRT, role_name};

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
    let mut kinds: Vec<Kind<'_>> = Vec::new();
    let cut = (0_usize..).zip(plans);
    let cut = cut.flat_map(|(dancer, plan)| plan.garments.iter().map(move |it| (dancer, it)));
    // Leaves and flowers need no cloth.
    for one in cut.filter(|(_, garment)| garment.own_plan().is_some()) {
        let cloth = design.cloth_of(one.1.tailored.place);
        match kinds.iter_mut().find(|kind| kind.cloth == cloth) {
            Some(kind) => kind.cut.push(one),
            None => kinds.push(Kind {
                cloth,
                cut: vec![one],
            }),
        }
    }
    let totals = kinds.iter().map(|kind| kind.total(settings));
    let totals = totals.chain(beside(plans, design, settings));
    totals.filter(|total| Length::ZERO < total.needed).collect()
}

/// What is cut from one print, by its dancer's place in the list.
struct Kind<'a> {
    cloth: (&'a FabricDesign, &'a PrintChoice),
    cut: Vec<(usize, &'a PlannedGarment)>,
}

impl Kind<'_> {
    fn total(&self, settings: &Settings) -> PrintTotal {
        let (fabric, print) = self.cloth;
        let cuts = self.cut.iter();
        let cuts: Vec<_> = cuts
            .map(|(dancer, garment)| (*dancer, garment.bought().needed))
            .collect();
        let mut garments = Vec::new();
        for (_, garment) in &self.cut {
            if !garments.contains(&garment.tailored.name) {
                garments.push(garment.tailored.name);
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
            price: ClothPrice::of(fabric, ClothRole::Main, self.priced_by()),
            width: Length::from_cm(fabric.width_cm),
            needed,
            bought: Yardage::for_length(needed * (1.0 + settings.spare_ratio)),
            bolts,
            longer_than_bolt,
        }
    }

    /// Identifier of the garment whose table is asked for the price of the cloth: the skirt's own where it is
    /// among those of it, else the first.
    fn priced_by(&self) -> &str {
        let mut ids = self
            .cut
            .iter()
            .map(|(_, garment)| garment.tailored.id.as_str());
        let first = ids.clone().next();
        ids.find(|id| *id == SKIRT).or(first).unwrap_or_default()
    }
}

/// Lining, contrast cloth and interfacing of a group, each of one width together.
fn beside(plans: &[DancerPlan], design: &Design, settings: &Settings) -> Vec<PrintTotal> {
    let mut totals: Vec<PrintTotal> = Vec::new();
    for garment in plans.iter().flat_map(|plan| &plan.garments) {
        let (fabric, _) = design.cloth_of(garment.tailored.place);
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
mod tests {
    use super::*;

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
}
