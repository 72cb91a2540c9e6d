//! Where the motifs lie on the repeat, which is a torus: what leaves on the right comes back on
//! the left.
//!
//! Flowers keep apart from each other first; large leaves grow out from under them; what stays
//! open is filled with ever smaller things, always where there is most room. No grid appears
//! because nothing is placed on one.

use glam::Vec2;
use lole_geom::trig;

use super::PrintMotif;

/// A thing that is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// A leaf of the quiet layer below, in the ground's darker shade.
    Shadow,
    /// Monstera or breadfruit leaf.
    Leaf,
    /// Frond of palapalai fern.
    Fern,
    /// Hibiscus flower, or breadfruit.
    Flower,
    /// Plumeria blossom.
    Blossom,
}

/// One motif on the repeat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placement {
    /// What it is.
    pub shape: Shape,
    /// Its origin: a flower's middle, a leaf's stalk. Repeat units, 0 to 1, y down.
    pub origin: Vec2,
    /// Direction its tip points to [rad], clockwise from +x as y is down.
    pub angle: f32,
    /// Radius of a flower, length of a leaf. Repeat units.
    pub size: f32,
    /// Chooses its small irregularities, 0 to 1.
    pub whim: f32,
}

/// Part of the repeat that is taken.
#[derive(Debug, Clone, Copy)]
struct Disc {
    middle: Vec2,
    radius: f32,
}

/// Radii of the flowers.
const FLOWERS: [f32; 4] = [0.168, 0.148, 0.132, 0.118];
/// Places tried for each motif; more pack denser.
const TRIES: usize = 220;

/// The motifs of one repeat, in drawing order.
pub(super) fn place(motif: PrintMotif, seed: u64) -> Vec<Placement> {
    let fill = match motif {
        PrintMotif::Hibiscus => [(Shape::Fern, 0.34, 0.18), (Shape::Blossom, 0.062, 0.032)],
        PrintMotif::Ulu => [(Shape::Leaf, 0.30, 0.15), (Shape::Blossom, 0.055, 0.032)],
        PrintMotif::Plain => return Vec::new(),
    };
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x10_1e);
    let mut taken: Vec<Disc> = Vec::new();
    let flowers = place_flowers(&mut dice, &mut taken);
    let mut leaves = Vec::new();
    for flower in &flowers {
        for shape in [Shape::Leaf, Shape::Leaf, Shape::Fern] {
            leaves.extend(tuck_under(flower, shape, &taken, &mut dice));
            if let Some(leaf) = leaves.last() {
                taken.extend(discs(leaf));
            }
        }
    }
    let mut small = Vec::new();
    for (shape, largest, smallest) in fill {
        fill_gaps(
            shape,
            [largest, smallest],
            &mut taken,
            &mut small,
            &mut dice,
        );
    }
    let mut placements = place_shadows(&mut dice);
    placements.extend(leaves);
    placements.extend(small);
    placements.extend(flowers);
    placements
}

/// Flowers, each at the roomiest of many places.
fn place_flowers(dice: &mut Dice, taken: &mut Vec<Disc>) -> Vec<Placement> {
    let mut flowers = Vec::new();
    for radius in FLOWERS {
        let middle = (0..TRIES)
            .map(|_| Vec2::new(dice.unit(), dice.unit()))
            .map(|middle| (middle, clearance(&[Disc { middle, radius }], taken)))
            .fold((Vec2::splat(0.5), f32::MIN), |best, tried| {
                if best.1 < tried.1 { tried } else { best }
            })
            .0;
        taken.push(Disc { middle, radius });
        flowers.push(Placement {
            shape: Shape::Flower,
            origin: middle,
            angle: dice.turn(),
            size: radius,
            whim: dice.unit(),
        });
    }
    flowers
}

/// A leaf whose stalk is hidden by `flower`, at the angle with most room; none where all angles
/// run into something.
fn tuck_under(
    flower: &Placement,
    shape: Shape,
    taken: &[Disc],
    dice: &mut Dice,
) -> Option<Placement> {
    let mut best = (None, -0.012);
    for _ in 0..TRIES {
        let angle = dice.turn();
        let away = direction(angle);
        let length = match shape {
            Shape::Fern => 0.27 + 0.10 * dice.unit(),
            _ => 0.23 + 0.08 * dice.unit(),
        };
        let leaf = Placement {
            shape,
            origin: wrap(flower.origin + away * flower.size * 0.62),
            angle: angle + 0.5 * (dice.unit() - 0.5),
            size: length,
            whim: dice.unit(),
        };
        // The first half of the leaf may lie below its own flower.
        let own = |disc: &Disc| torus_distance(disc.middle, flower.origin) < 0.01;
        let others: Vec<Disc> = taken.iter().copied().filter(|disc| !own(disc)).collect();
        let room = clearance(&discs(&leaf), &others);
        if best.1 < room {
            best = (Some(leaf), room.min(0.004) + 0.002 * dice.unit());
        }
    }
    best.0
}

/// Fills what is open with one kind of motif, from the largest to the smallest that fits.
fn fill_gaps(
    shape: Shape,
    [largest, smallest]: [f32; 2],
    taken: &mut Vec<Disc>,
    placements: &mut Vec<Placement>,
    dice: &mut Dice,
) {
    let mut size = largest;
    while smallest < size {
        let found = (0..TRIES).find_map(|_| {
            let placement = Placement {
                shape,
                origin: Vec2::new(dice.unit(), dice.unit()),
                angle: dice.turn(),
                size,
                whim: dice.unit(),
            };
            let room = clearance(&discs(&placement), taken);
            (0.006 < room).then_some(placement)
        });
        match found {
            Some(placement) => {
                taken.extend(discs(&placement));
                placements.push(placement);
            }
            None => size *= 0.92,
        }
    }
}

/// Large leaves of the quiet layer: they only keep apart from each other.
fn place_shadows(dice: &mut Dice) -> Vec<Placement> {
    let mut taken = Vec::new();
    let mut shadows = Vec::new();
    for _ in 0..9 {
        let tried = (0..TRIES).map(|_| Placement {
            shape: Shape::Shadow,
            origin: Vec2::new(dice.unit(), dice.unit()),
            angle: dice.turn(),
            size: 0.26 + 0.08 * dice.unit(),
            whim: dice.unit(),
        });
        let tried: Vec<Placement> = tried.collect();
        let best = tried
            .into_iter()
            .map(|placement| (placement, clearance(&discs(&placement), &taken)))
            .reduce(|best, next| if best.1 < next.1 { next } else { best });
        if let Some((placement, _)) = best {
            taken.extend(discs(&placement));
            shadows.push(placement);
        }
    }
    shadows
}

/// Discs that cover a motif.
fn discs(placement: &Placement) -> Vec<Disc> {
    let along = direction(placement.angle);
    let disc = |far: f32, radius: f32| Disc {
        middle: wrap(placement.origin + along * far * placement.size),
        radius: radius * placement.size,
    };
    match placement.shape {
        Shape::Flower | Shape::Blossom => vec![disc(0.0, 1.0)],
        Shape::Leaf | Shape::Shadow => vec![disc(0.36, 0.36), disc(0.70, 0.27)],
        Shape::Fern => {
            vec![
                disc(0.16, 0.14),
                disc(0.36, 0.19),
                disc(0.58, 0.16),
                disc(0.78, 0.11),
                disc(0.94, 0.05),
            ]
        }
    }
}

/// Least gap between two sets of discs; negative where they overlap.
fn clearance(discs: &[Disc], taken: &[Disc]) -> f32 {
    let mut least = f32::MAX;
    for disc in discs {
        for other in taken {
            let gap = torus_distance(disc.middle, other.middle) - disc.radius - other.radius;
            least = least.min(gap);
        }
    }
    least
}

/// Shortest way between two points of the repeat.
fn torus_distance(a: Vec2, b: Vec2) -> f32 {
    let apart = a - b;
    (apart - apart.round()).length()
}

/// The same point within the repeat.
fn wrap(point: Vec2) -> Vec2 {
    point - point.floor()
}

/// Unit vector at an angle [rad].
pub(super) fn direction(angle: f32) -> Vec2 {
    let (sin, cos) = trig::sin_cos(angle);
    Vec2::new(cos, sin)
}

/// A stream of numbers that looks random and is the same for the same seed: `SplitMix64` of
/// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
struct Dice(u64);

impl Dice {
    /// At least 0, less than 1.
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        let top = u16::try_from(bits >> 48).unwrap_or(0);
        f32::from(top) / 65_536.0
    }

    /// An angle [rad].
    fn turn(&mut self) -> f32 {
        self.unit() * std::f32::consts::TAU
    }
}
