//! What a costume costs: cloth and notions by the prices of the design, work by its wage.
//!
//! Nothing is assumed: an amount without a price stands on the bill without a sum, and the bill says
//! which price is asked for. Shops sell cloth by 10 cm or by half a yard, elastic and tape by 10 cm,
//! thread by the spool.

use lole_garment::RAFFIA_PER_METER;
use lole_geom::Length;
use lole_language::{Sentence, Words, words};
use lole_pattern::Yardage;
use lole_pattern::pattern::{Amount, NotionKind};
use lole_pattern::piece::ClothRole;

use crate::document::{CostDesign, Currency, Design, FabricDesign, NotionPrices};
use crate::order::{DancerPlan, PrintTotal};
use crate::tailoring::{SKIRT, role_name};

/// What is paid for.
#[derive(Debug, Clone, PartialEq)]
pub struct BillLine {
    /// What it is.
    pub name: Sentence,
    /// How much of it, as a shop sells it.
    pub amount: Sentence,
    /// What it costs; `None` where no price is known.
    pub sum: Option<f64>,
    /// Key of the document that would tell the price, where it is not known.
    pub asks: Option<&'static str>,
}

/// A bill.
#[derive(Debug, Clone, PartialEq)]
pub struct Bill {
    /// Of all sums.
    pub currency: Currency,
    /// What is paid for.
    pub lines: Vec<BillLine>,
    /// All known sums together.
    pub total: f64,
    /// Hours of sewing with a machine. An estimate.
    pub hours: f64,
    /// What the same costs ready made, where the design says so.
    pub bought: Option<f64>,
}

impl Bill {
    fn new(cost: &CostDesign, hours: f64) -> Self {
        Self {
            currency: cost.currency,
            lines: Vec::new(),
            total: 0.0,
            hours,
            bought: cost.bought_price,
        }
    }

    fn add_named(&mut self, name: Words, amount: Sentence, price: Result<f64, &'static str>) {
        self.add(Sentence::new(name.japanese, name.english), amount, price);
    }

    fn add(&mut self, name: Sentence, amount: Sentence, price: Result<f64, &'static str>) {
        self.total += price.unwrap_or(0.0);
        self.lines.push(BillLine {
            name,
            amount,
            sum: price.ok(),
            asks: price.err(),
        });
    }

    /// Keys of the document without which the total is not all of it, each once.
    #[must_use]
    pub fn asked_for(&self) -> Vec<&'static str> {
        let mut keys: Vec<&'static str> = self.lines.iter().filter_map(|line| line.asks).collect();
        keys.sort_unstable();
        keys.dedup();
        keys
    }

    /// Whether every price is known.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.lines.iter().all(|line| line.sum.is_some())
    }

    /// Whether any price is known.
    #[must_use]
    pub fn knows_something(&self) -> bool {
        self.lines.iter().any(|line| line.sum.is_some())
    }

    /// What sewing saves against buying; negative where it costs more. `None` unless all prices are
    /// known.
    #[must_use]
    pub fn saving(&self) -> Option<f64> {
        let bought = self.bought.filter(|_| self.is_complete())?;
        Some(bought - self.total)
    }
}

/// The bill of one dancer's costume.
#[must_use]
pub fn bill(design: &Design, plan: &DancerPlan) -> Bill {
    let cost = &design.cost;
    let mut bill = Bill::new(cost, hours(plan));
    for garment in &plan.garments {
        let (fabric, _) = design.cloth_of(garment.tailored.place);
        for plan in &garment.plans {
            let price = ClothPrice::of(fabric, plan.role, &garment.tailored.id);
            let (amount, price) = price.of_length(plan.marker.yardage);
            let name = match plan.role {
                ClothRole::Main => garment.tailored.name,
                role => role_name(role),
            };
            bill.add(cloth_of(&[name]), amount, price);
        }
    }
    bill.add_notions(std::slice::from_ref(plan), cost);
    bill.add_rest(1, cost);
    bill
}

/// The bill of a group that buys together: the cloth of its [prints](crate::order::prints), what is
/// spare included, and notions by their sums, so that it may differ from the sum of single bills.
#[must_use]
pub fn group_bill(design: &Design, plans: &[DancerPlan], prints: &[PrintTotal]) -> Bill {
    let cost = &design.cost;
    let mut bill = Bill::new(cost, plans.iter().map(hours).sum());
    bill.bought = cost.bought_price.map(|price| price * plans.len() as f64);
    for print in prints {
        let (amount, price) = print.price.of_length(print.bought);
        let names = match print.role {
            ClothRole::Main => print.garments.as_slice(),
            _ => &[print.cloth],
        };
        bill.add(cloth_of(names), amount, price);
    }
    bill.add_notions(plans, cost);
    bill.add_rest(plans.len(), cost);
    bill
}

/// Hours of sewing with a machine. An estimate.
fn hours(plan: &DancerPlan) -> f64 {
    let minutes: f64 = (plan.garments.iter())
        .flat_map(|garment| &garment.tailored.pattern.steps)
        .map(|step| step.minutes[0])
        .sum();
    minutes / 60.0
}

impl Bill {
    /// Everything beside cloth.
    fn add_notions(&mut self, plans: &[DancerPlan], cost: &CostDesign) {
        for (name, length) in elastics(plans) {
            let (amount, price) = by_meter(
                length,
                cost.elastic_price_per_m,
                "[cost] elastic_price_per_m",
            );
            self.add_named(name, amount, price);
        }
        self.add_sewn(plans, cost);
        for sold in SOLD {
            if let Some(count) = sold.count(plans) {
                let amount = sold.unit.words(sold.kind, count);
                let price = (sold.place)(&mut cost.notions.clone()).map(|price| price * count);
                self.add_named(sold.name, amount, price.ok_or(sold.key));
            }
        }
    }

    /// Tape, cord and thread.
    fn add_sewn(&mut self, plans: &[DancerPlan], cost: &CostDesign) {
        if let Some(length) = notion_length(plans, NotionKind::Cord) {
            let (amount, price) =
                by_meter(length, cost.tape_price_per_m, "[cost] tape_price_per_m");
            self.add_named(words("テープ・ひも", "tape and cord"), amount, price);
        }
        if let Some(length) = notion_length(plans, NotionKind::Thread) {
            let spools = (length.to_m() / cost.thread_spool_m - 1e-9).ceil();
            let plural = if 1.0 < spools { "s" } else { "" };
            let amount = Sentence::new(format!("{spools} 巻き"), format!("{spools} spool{plural}"));
            let price = cost.thread_price_per_spool.map(|price| price * spools);
            self.add_named(
                words("糸", "thread"),
                amount,
                price.ok_or("[cost] thread_price_per_spool"),
            );
        }
    }

    /// What is not bought by its amount, for so many costumes, and the work.
    fn add_rest(&mut self, count: usize, cost: &CostDesign) {
        if let Some(price) = cost.other_price {
            let sum = price * count as f64;
            self.add_named(words("そのほか", "other"), Sentence::new("", ""), Ok(sum));
        }
        if let Some(wage) = cost.wage_per_h {
            let hours = self.hours;
            let amount = Sentence::new(
                format!("{hours:.1} 時間（目安）"),
                format!("{hours:.1} h (estimate)"),
            );
            self.add_named(words("縫い手間", "sewing"), amount, Ok(wage * hours));
        }
    }
}

/// What a cloth costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClothPrice {
    per_m: Option<f64>,
    per_yd: Option<f64>,
    /// Key of the document that would tell the price.
    key: &'static str,
}

impl ClothPrice {
    /// Of the own cloth of a garment of this identifier or of what lies beside it.
    pub(crate) fn of(fabric: &FabricDesign, role: ClothRole, garment: &str) -> Self {
        let [per_m, per_yd] = match role {
            ClothRole::Main => [fabric.price_per_m, fabric.price_per_yd],
            _ => [fabric.beside_price_per_m, None],
        };
        let key = match (role, garment == SKIRT) {
            (ClothRole::Main, true) => "[fabric] price_per_m",
            (ClothRole::Main, false) => "[garment.fabric] price_per_m",
            (_, true) => "[fabric] beside_price_per_m",
            (_, false) => "[garment.fabric] beside_price_per_m",
        };
        Self { per_m, per_yd, key }
    }

    /// A length as a shop sells it, and its price.
    fn of_length(self, bought: Yardage) -> (Sentence, Result<f64, &'static str>) {
        let metric = format!("{:.1} m", bought.metric.to_m());
        let imperial = format!("{:.1} yd", bought.imperial.to_yd());
        match (self.per_m, self.per_yd) {
            (Some(price), _) => (
                Sentence::new(metric.clone(), metric),
                Ok(price * bought.metric.to_m()),
            ),
            (None, Some(price)) => (
                Sentence::new(imperial.clone(), imperial),
                Ok(price * bought.imperial.to_yd()),
            ),
            (None, None) => (Sentence::new(metric.clone(), metric), Err(self.key)),
        }
    }
}

/// Cloth by the garment that it is for.
fn cloth_of(garments: &[Words]) -> Sentence {
    let japanese: Vec<&str> = garments.iter().map(|name| name.japanese).collect();
    let english: Vec<&str> = garments.iter().map(|name| name.english).collect();
    Sentence::new(
        format!("布（{}）", japanese.join("・")),
        format!("cloth ({})", english.join(", ")),
    )
}

/// How a notion is sold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Unit {
    /// By the piece.
    Piece,
    /// Priced by 100 g, in tens of grams.
    Grams,
    /// Priced by the meter, in tens of centimeters.
    Meter,
}

impl Unit {
    /// So many of a kind: pieces, hundreds of grams or meters.
    fn words(self, kind: NotionKind, count: f64) -> Sentence {
        match self {
            Self::Piece => Sentence::new(
                format!("{count:.0} {}", kind.counter()),
                format!("{count:.0} piece{}", if count == 1.0 { "" } else { "s" }),
            ),
            Self::Grams => {
                let grams = format!("{:.0} g", 100.0 * count);
                Sentence::new(grams.clone(), grams)
            }
            Self::Meter => {
                let meters = format!("{count:.1} m");
                Sentence::new(meters.clone(), meters)
            }
        }
    }
}

/// A sort of notion that has a price of its own.
struct Sold {
    kind: NotionKind,
    name: Words,
    unit: Unit,
    key: &'static str,
    place: fn(&mut NotionPrices) -> &mut Option<f64>,
}

/// A price that a maker may write for a sort of notion.
#[derive(Debug, Clone, Copy)]
pub struct NotionPrice {
    /// What it is.
    pub name: Words,
    /// What the price is for.
    pub unit: Words,
    /// Its key in the document's table `cost`.
    pub key: &'static str,
    /// Where it is kept.
    pub place: fn(&mut NotionPrices) -> &mut Option<f64>,
}

/// Prices of all sorts of notions that have one of their own, in the order of the bill.
pub fn notion_prices() -> impl Iterator<Item = NotionPrice> {
    SOLD.iter().map(|sold| NotionPrice {
        name: sold.name,
        unit: match sold.unit {
            Unit::Piece => words("/ 1 つ", "each"),
            Unit::Grams => words("/ 100 g", "per 100 g"),
            Unit::Meter => words("/ 1 m", "per m"),
        },
        key: sold.key.trim_start_matches("[cost] "),
        place: sold.place,
    })
}

impl Sold {
    /// How much of it costumes take, in its unit; `None` where they take none.
    fn count(&self, plans: &[DancerPlan]) -> Option<f64> {
        let garments = plans.iter().flat_map(|plan| &plan.garments);
        let notions = garments.flat_map(|garment| &garment.tailored.pattern.notions);
        let amounts = notions.filter(|notion| notion.kind == self.kind);
        let sum: f64 = amounts
            .map(|notion| match (notion.amount, self.unit) {
                (Amount::Count(count), _) => f64::from(count),
                // A zip is one, whatever its length.
                (_, Unit::Piece) => 1.0,
                (Amount::Length(length), Unit::Meter) => length.to_m(),
                (Amount::Length(length), Unit::Grams) => 10.0 * RAFFIA_PER_METER * length.to_m(),
                (Amount::Mass(mass), _) => 10.0 * mass,
            })
            .sum();
        let sold = match self.unit {
            Unit::Piece => sum,
            // Sold by 10 g and by 10 cm.
            Unit::Grams | Unit::Meter => (sum * 10.0 - 1e-9).ceil() / 10.0,
        };
        (0.0 < sold).then_some(sold)
    }
}

/// Every sort of notion with a price of its own, in the order of the bill.
const SOLD: &[Sold] = &[
    Sold {
        kind: NotionKind::Zip,
        name: words("ファスナー", "zip"),
        unit: Unit::Piece,
        key: "[cost] zip_price",
        place: |prices| &mut prices.zip,
    },
    Sold {
        kind: NotionKind::Button,
        name: words("ボタン", "button"),
        unit: Unit::Piece,
        key: "[cost] button_price",
        place: |prices| &mut prices.button,
    },
    Sold {
        kind: NotionKind::Hook,
        name: words("ホック", "hook and eye"),
        unit: Unit::Piece,
        key: "[cost] hook_price",
        place: |prices| &mut prices.hook,
    },
    Sold {
        kind: NotionKind::Flower,
        name: words("花", "flowers"),
        unit: Unit::Piece,
        key: "[cost] flower_price",
        place: |prices| &mut prices.flower,
    },
    Sold {
        kind: NotionKind::Pistil,
        name: words("しべ（ペップ）", "pistils"),
        unit: Unit::Piece,
        key: "[cost] pistil_price",
        place: |prices| &mut prices.pistil,
    },
    Sold {
        kind: NotionKind::Leaf,
        name: words("葉", "leaves"),
        unit: Unit::Piece,
        key: "[cost] leaf_price",
        place: |prices| &mut prices.leaf,
    },
    Sold {
        kind: NotionKind::Raffia,
        name: words("ラフィア", "raffia"),
        unit: Unit::Grams,
        key: "[cost] raffia_price_per_100g",
        place: |prices| &mut prices.raffia_per_100g,
    },
    Sold {
        kind: NotionKind::Film,
        name: words("フィルム", "film"),
        unit: Unit::Meter,
        key: "[cost] film_price_per_m",
        place: |prices| &mut prices.film_per_m,
    },
    Sold {
        kind: NotionKind::HairPin,
        name: words("ヘアピン・クリップ", "hair pins or clips"),
        unit: Unit::Piece,
        key: "[cost] hair_pin_price",
        place: |prices| &mut prices.hair_pin,
    },
    Sold {
        kind: NotionKind::Gourd,
        name: words("ひょうたん", "gourds"),
        unit: Unit::Piece,
        key: "[cost] gourd_price",
        place: |prices| &mut prices.gourd,
    },
    Sold {
        kind: NotionKind::Bamboo,
        name: words("竹", "bamboo"),
        unit: Unit::Piece,
        key: "[cost] bamboo_price",
        place: |prices| &mut prices.bamboo,
    },
    Sold {
        kind: NotionKind::Feather,
        name: words("羽根", "feathers"),
        unit: Unit::Piece,
        key: "[cost] feather_price",
        place: |prices| &mut prices.feather,
    },
    Sold {
        kind: NotionKind::Handle,
        name: words("持ち手", "handles"),
        unit: Unit::Piece,
        key: "[cost] handle_price",
        place: |prices| &mut prices.handle,
    },
    Sold {
        kind: NotionKind::Seed,
        name: words("種", "seeds"),
        unit: Unit::Piece,
        key: "[cost] seed_price",
        place: |prices| &mut prices.seed,
    },
    Sold {
        kind: NotionKind::Card,
        name: words("厚紙", "card"),
        unit: Unit::Piece,
        key: "[cost] card_price",
        place: |prices| &mut prices.card,
    },
    Sold {
        kind: NotionKind::Glue,
        name: words("接着剤", "glue"),
        unit: Unit::Piece,
        key: "[cost] glue_price",
        place: |prices| &mut prices.glue,
    },
];

/// Elastics of each sort, in the order in which they are met.
fn elastics(plans: &[DancerPlan]) -> Vec<(Words, Length)> {
    let garments = plans.iter().flat_map(|plan| &plan.garments);
    let notions = garments.flat_map(|garment| &garment.tailored.pattern.notions);
    let elastics = notions.filter(|notion| notion.kind == NotionKind::Elastic);
    elastics.fold(Vec::new(), |mut sums: Vec<(Words, Length)>, notion| {
        if let Amount::Length(length) = notion.amount {
            match sums.iter_mut().find(|(name, _)| *name == notion.name) {
                Some((_, sum)) => *sum = *sum + length,
                None => sums.push((notion.name, length)),
            }
        }
        sums
    })
}

/// A length sold by 10 cm, and its price.
fn by_meter(
    length: Length,
    price_per_m: Option<f64>,
    key: &'static str,
) -> (Sentence, Result<f64, &'static str>) {
    // Rounding noise buys no further 10 cm.
    let meters = (length.to_m() * 10.0 - 1e-9).ceil() / 10.0;
    let amount = format!("{meters:.1} m");
    let price = price_per_m.map(|price| price * meters).ok_or(key);
    (Sentence::new(amount.clone(), amount), price)
}

/// Length of all notions of a kind; `None` where there are none.
fn notion_length(plans: &[DancerPlan], kind: NotionKind) -> Option<Length> {
    let garments = plans.iter().flat_map(|plan| &plan.garments);
    let notions = garments.flat_map(|garment| &garment.tailored.pattern.notions);
    let lengths = notions.filter(|notion| notion.kind == kind);
    let lengths = lengths.filter_map(|notion| match notion.amount {
        Amount::Length(length) => Some(length),
        Amount::Count(_) | Amount::Mass(_) => None,
    });
    lengths.fold(None, |sum, length| {
        Some(sum.map_or(length, |sum: Length| sum + length))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::order::{self, tests::plan_of};

    fn design() -> Design {
        let mut design = Design::default();
        design.dancer.hip_cm = Some(91.4);
        design
    }

    #[test]
    fn nothing_is_assumed() {
        let design = design();
        let bill = bill(&design, &plan_of(&design));
        assert_eq!(bill.total, 0.0);
        let keys = [
            "[cost] elastic_price_per_m",
            "[cost] thread_price_per_spool",
            "[fabric] price_per_m",
        ];
        assert_eq!(bill.asked_for(), keys);
        assert_eq!(bill.saving(), None);
    }

    /// 366 to 368 cm of cloth are 3.7 m in Japan and 4 yd in Hawaiʻi.
    #[test]
    fn cloth_costs_what_a_shop_cuts() {
        let mut design = design();
        design.fabric.price_per_yd = Some(6.0);
        assert_eq!(bill(&design, &plan_of(&design)).total, 24.0);
        design.fabric.price_per_m = Some(1000.0);
        assert!((bill(&design, &plan_of(&design)).total - 3700.0).abs() < 1e-6);
    }

    /// Whatever is bought stands on the bill, with the key that would price it.
    #[test]
    fn every_notion_is_asked_for_and_then_paid() {
        use lole_garment::TEMPLATES;

        use crate::document::GarmentDesign;

        for template in TEMPLATES {
            let mut design = design();
            design.skirt.is_worn = false;
            design.garments = GarmentDesign::of_kind(template.id).into_iter().collect();
            let plan = plan_of(&design);
            let bill = bill(&design, &plan);
            let kinds: std::collections::BTreeSet<NotionKind> = (plan.garments.iter())
                .flat_map(|garment| &garment.tailored.pattern.notions)
                .map(|notion| notion.kind)
                .collect();
            let cloths: usize = plan.garments.iter().map(|it| it.plans.len()).sum();
            assert_eq!(bill.lines.len(), kinds.len() + cloths, "{}", template.id);
            assert!(
                !bill.is_complete() && !bill.lines.is_empty(),
                "{}",
                template.id
            );
        }
        let mut ipu = design();
        ipu.skirt.is_worn = false;
        ipu.garments = GarmentDesign::of_kind("ipu").into_iter().collect();
        ipu.cost.notions.gourd = Some(4500.0);
        let paid = bill(&ipu, &plan_of(&ipu));
        let notions = &plan_of(&ipu).garments[0].tailored.pattern.notions;
        let gourds = notions.iter().find_map(|notion| match notion.amount {
            Amount::Count(count) if notion.kind == NotionKind::Gourd => Some(f64::from(count)),
            _ => None,
        });
        assert_eq!(Some(paid.total), gourds.map(|gourds| 4500.0 * gourds));
    }

    /// What is bought together is rounded up once, so it never costs more; without roundings it is the sum.
    #[test]
    fn a_group_pays_no_more_than_its_dancers_alone() {
        let mut design = design();
        design.fabric.price_per_m = Some(1200.0);
        design.cost.elastic_price_per_m = Some(60.0);
        design.cost.thread_price_per_spool = Some(250.0);
        design.cost.wage_per_h = Some(1000.0);
        design.cost.other_price = Some(100.0);
        design.cost.bought_price = Some(15_000.0);
        let plans = vec![plan_of(&design); 3];
        let one = bill(&design, &plans[0]);
        let settings = order::Settings {
            spare_ratio: 0.0,
            ..order::Settings::default()
        };
        let prints = order::prints(&plans, &design, &settings);
        let all = group_bill(&design, &plans, &prints);
        assert!(one.is_complete() && all.is_complete());
        assert_eq!(all.lines.len(), one.lines.len());
        for (together, alone) in all.lines.iter().zip(&one.lines) {
            let (together, alone) = (together.sum.unwrap(), alone.sum.unwrap());
            assert!(together <= 3.0 * alone + 1e-6, "{together} {alone}");
            assert!(alone < together, "{together} {alone}");
        }
        // Three times 105 m of thread are two spools, not three.
        let thread = all.lines.iter().find(|line| line.name.english == "thread");
        assert_eq!(thread.and_then(|line| line.sum), Some(500.0));
        assert!((all.hours - 3.0 * one.hours).abs() < 1e-9);
        assert_eq!(all.bought, Some(45_000.0));
    }
}
