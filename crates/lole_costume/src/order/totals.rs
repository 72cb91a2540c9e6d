//! What a group buys: cloth by print, and everything beside cloth.

use lole_geom::Length;
use lole_language::Words;
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::piece::ClothRole;
use lole_pattern::{Yardage, sold_zip};
use lole_print::PrintMotif;

use super::together::{Cut, SharedStrip, bolts, together};
use super::{DancerPlan, Settings};
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
    /// What the pieces of all dancers need, laid together.
    pub needed: Length,
    /// What they need where everybody's are laid by themselves.
    pub apart: Length,
    /// To ask for, with what is spare.
    pub bought: Yardage,
    /// What is cut off the cloth, and what of it is whose.
    pub strips: Vec<SharedStrip>,
    /// Where the bolt's length is known: what is cut from each bolt, as places among the strips, longest
    /// first.
    pub bolts: Vec<Vec<usize>>,
    /// Dancers whose piece is longer than a bolt.
    pub longer_than_bolt: Vec<usize>,
}

impl PrintTotal {
    /// What is saved by cutting together; zero where it is nothing that a shop would sell.
    #[must_use]
    pub fn saved(&self) -> Length {
        let saved = self.apart - self.needed;
        if saved < Length::from_cm(1.0) {
            Length::ZERO
        } else {
            saved
        }
    }
}

/// What a group buys of each print.
#[must_use]
pub fn prints(plans: &[DancerPlan], design: &Design, settings: &Settings) -> Vec<PrintTotal> {
    let mut kinds: Vec<Kind<'_>> = Vec::new();
    let cut = (0_usize..).zip(plans);
    let cut = cut.flat_map(|(dancer, plan)| plan.garments.iter().map(move |it| (dancer, it)));
    // Leaves and flowers need no cloth.
    let cut = cut.filter_map(|(dancer, garment)| Some((dancer, garment, garment.own_plan()?)));
    for one in cut {
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
    cut: Vec<Cut<'a>>,
}

impl Kind<'_> {
    fn total(&self, settings: &Settings) -> PrintTotal {
        let (fabric, print) = self.cloth;
        let cloth = Words {
            japanese: fabric.preset.name_ja,
            english: fabric.preset.name,
        };
        PrintTotal {
            cloth,
            print: print.clone(),
            ..total(
                &self.cut,
                (
                    ClothRole::Main,
                    ClothPrice::of(fabric, ClothRole::Main, self.priced_by()),
                    Length::from_cm(fabric.width_cm),
                ),
                settings,
            )
        }
    }

    /// Identifier of the garment whose table is asked for the price of the cloth: the skirt's own where it is
    /// among those of it, else the first.
    fn priced_by(&self) -> &str {
        let mut ids = self.cut.iter().map(|cut| cut.1.tailored.id.as_str());
        let first = ids.clone().next();
        ids.find(|id| *id == SKIRT).or(first).unwrap_or_default()
    }
}

/// What is bought of one cloth, named by its role and plain unless the caller says otherwise, by price and width
/// for all that is cut from it; bolts are those of the garments' own cloth.
fn total(
    cuts: &[Cut<'_>],
    (role, price, width): (ClothRole, ClothPrice, Length),
    settings: &Settings,
) -> PrintTotal {
    let mut garments = Vec::new();
    for (_, garment, _) in cuts {
        if !garments.contains(&garment.tailored.name) {
            garments.push(garment.tailored.name);
        }
    }
    let laid = together(cuts, width);
    let bolt_length = settings.bolt_length.filter(|_| role == ClothRole::Main);
    let (bolts, too_long) = match bolt_length {
        Some(length) => bolts(&laid.strips, length),
        None => (Vec::new(), Vec::new()),
    };
    let mut longer_than_bolt: Vec<usize> = (too_long.iter())
        .flat_map(|&strip| &laid.strips[strip].shares)
        .map(|share| share.dancer)
        .collect();
    longer_than_bolt.sort_unstable();
    longer_than_bolt.dedup();
    PrintTotal {
        garments,
        cloth: role_name(role),
        print: PrintChoice {
            motif: PrintMotif::Plain,
            ..PrintChoice::default()
        },
        role,
        price,
        width,
        needed: laid.needed,
        apart: laid.apart,
        bought: Yardage::for_length(laid.needed * (1.0 + settings.spare_ratio)),
        strips: laid.strips,
        bolts,
        longer_than_bolt,
    }
}

/// Lining, contrast cloth and interfacing of a group, each of one width together.
fn beside(plans: &[DancerPlan], design: &Design, settings: &Settings) -> Vec<PrintTotal> {
    let mut kinds: Vec<((ClothRole, ClothPrice, Length), Vec<Cut<'_>>)> = Vec::new();
    for (dancer, plan) in plans.iter().enumerate() {
        for garment in &plan.garments {
            let (fabric, _) = design.cloth_of(garment.tailored.place);
            let beside = garment.plans.iter();
            for plan in beside.filter(|plan| plan.role != ClothRole::Main) {
                let price = ClothPrice::of(fabric, plan.role, &garment.tailored.id);
                let kind = (plan.role, price, plan.marker.cloth.width);
                let cut = (dancer, garment, plan);
                match kinds.iter_mut().find(|(other, _)| *other == kind) {
                    Some((_, cuts)) => cuts.push(cut),
                    None => kinds.push((kind, vec![cut])),
                }
            }
        }
    }
    let totals = kinds
        .iter()
        .map(|(kind, cuts)| total(cuts, *kind, settings));
    totals.collect()
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
    /// Length of each where they are counted but have one, as zips: one that is sold.
    pub length: Option<Length>,
}

/// The zip that is bought for an opening.
fn zip_for(amount: Amount) -> Length {
    match amount {
        Amount::Length(length) => sold_zip(length),
        Amount::Count(_) | Amount::Mass(_) => Length::ZERO,
    }
}

/// Everything a group buys beside cloth, equal things together; of elastic and cord as much more as of cloth.
#[must_use]
pub fn notions(plans: &[DancerPlan], settings: &Settings) -> Vec<NotionTotal> {
    let mut totals: Vec<NotionTotal> = Vec::new();
    let garments = plans.iter().flat_map(|plan| &plan.garments);
    for notion in garments.flat_map(|garment| &garment.tailored.pattern.notions) {
        let is_zip = notion.kind == NotionKind::Zip;
        let same = totals.iter_mut().find(|total| {
            // Zips are bought by the piece, each of its length.
            total.name == notion.name && (!is_zip || total.length == Some(zip_for(notion.amount)))
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
                length: is_zip.then(|| zip_for(notion.amount)),
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
    for total in &mut totals {
        if let (NotionKind::Elastic | NotionKind::Cord, Amount::Length(length)) =
            (total.kind, &mut total.amount)
        {
            *length = *length * (1.0 + settings.spare_ratio);
        }
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
