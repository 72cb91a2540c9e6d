//! Where the motifs lie on the repeat, which is a torus: what leaves on the right comes back on
//! the left.
//!
//! Flowers keep apart from each other first; large leaves grow out from under them; what stays
//! open is filled with ever smaller things, always where there is most room. No grid appears
//! because nothing is placed on one.

use glam::Vec2;
use lole_geom::Chance;

use super::motif::{Fill, Role, Scatter, Shadow, Stand};
use super::shape::{Shape, at_angle};

/// One motif on the repeat.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    /// What it is.
    pub shape: Shape,
    /// Which colors it takes.
    pub role: Role,
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

/// Places tried for each motif; more pack denser.
const TRIES: usize = 220;
/// Straight up, as y is down [rad].
const UP: f32 = -std::f32::consts::FRAC_PI_2;

/// The motifs of one repeat, in drawing order.
pub(super) fn place(scatter: &Scatter, seed: u64) -> Vec<Placement> {
    let mut bed = Bed {
        dice: Dice::new(seed),
        taken: Vec::new(),
    };
    let heroes = bed.place_heroes(scatter);
    let mut leaves = Vec::new();
    for hero in &heroes {
        for &(shape, lengths) in scatter.tucked {
            leaves.extend(bed.tuck_under(hero, shape, lengths));
        }
    }
    let mut small = Vec::new();
    for fill in scatter.fill {
        small.extend(bed.fill_gaps(fill, scatter.stand));
    }
    let mut placements = match scatter.shadow {
        Shadow::Leaves(shape, count, sizes) => place_shadows((shape, count, sizes), &mut bed.dice),
        Shadow::Surf => Vec::new(),
    };
    placements.extend(leaves);
    placements.extend(small);
    placements.extend(heroes);
    placements
}

/// The repeat while it is filled.
struct Bed {
    dice: Dice,
    /// What lies on it already.
    taken: Vec<Disc>,
}

impl Bed {
    /// Heroes, each at the roomiest of many places.
    fn place_heroes(&mut self, scatter: &Scatter) -> Vec<Placement> {
        let mut heroes = Vec::new();
        for &(shape, radius) in scatter.heroes {
            let middle = (0..TRIES)
                .map(|_| Vec2::new(self.dice.unit(), self.dice.unit()))
                .map(|middle| (middle, clearance(&[Disc { middle, radius }], &self.taken)))
                .fold((Vec2::splat(0.5), f32::MIN), |best, tried| {
                    if best.1 < tried.1 { tried } else { best }
                })
                .0;
            self.taken.push(Disc { middle, radius });
            heroes.push(Placement {
                shape,
                role: Role::Flower,
                origin: middle,
                angle: self.dice.turn(),
                size: radius,
                whim: self.dice.unit(),
            });
        }
        heroes
    }

    /// A leaf whose stalk is hidden by `hero`, at the angle with most room; none where all angles run
    /// into something.
    fn tuck_under(
        &mut self,
        hero: &Placement,
        shape: Shape,
        [shortest, longest]: [f32; 2],
    ) -> Option<Placement> {
        // The first half of the leaf may lie below its own flower.
        let own = |disc: &Disc| torus_distance(disc.middle, hero.origin) < 0.01;
        let others = self.taken.iter().copied().filter(|disc| !own(disc));
        let others: Vec<Disc> = others.collect();
        let dice = &mut self.dice;
        let mut best = (None, -0.012);
        for _ in 0..TRIES {
            let angle = dice.turn();
            let leaf = Placement {
                shape,
                role: Role::Leaf,
                origin: wrap(hero.origin + at_angle(angle) * hero.size * 0.62),
                size: shortest + (longest - shortest) * dice.unit(),
                angle: angle + 0.5 * (dice.unit() - 0.5),
                whim: dice.unit(),
            };
            let room = clearance(&discs(&leaf), &others);
            if best.1 < room {
                best = (Some(leaf), room.min(0.004) + 0.002 * dice.unit());
            }
        }
        self.taken.extend(best.0.iter().flat_map(discs));
        best.0
    }

    /// Fills what is open with one kind of motif, from the largest to the smallest that fits.
    fn fill_gaps(&mut self, fill: &Fill, stand: Stand) -> Vec<Placement> {
        let [mut size, smallest] = fill.sizes;
        let mut placements = Vec::new();
        while smallest < size && placements.len() < fill.most {
            let found = (0..TRIES).find_map(|_| {
                let dice = &mut self.dice;
                let placement = Placement {
                    shape: fill.shape,
                    role: fill.role,
                    origin: Vec2::new(dice.unit(), dice.unit()),
                    angle: match (stand, fill.role) {
                        (Stand::Upright(lean), Role::Flower) => {
                            UP + lean * (2.0 * dice.unit() - 1.0)
                        }
                        _ => dice.turn(),
                    },
                    size,
                    whim: dice.unit(),
                };
                let room = clearance(&discs(&placement), &self.taken);
                (0.006 < room).then_some(placement)
            });
            match found {
                Some(placement) => {
                    self.taken.extend(discs(&placement));
                    placements.push(placement);
                }
                None => size *= 0.92,
            }
        }
        placements
    }
}

/// Large leaves of the quiet layer: they only keep apart from each other.
fn place_shadows(
    (shape, count, [shortest, longest]): (Shape, usize, [f32; 2]),
    dice: &mut Dice,
) -> Vec<Placement> {
    let mut taken = Vec::new();
    let mut shadows = Vec::new();
    for _ in 0..count {
        let tried = (0..TRIES).map(|_| Placement {
            shape,
            role: Role::Shadow,
            origin: Vec2::new(dice.unit(), dice.unit()),
            angle: dice.turn(),
            size: shortest + (longest - shortest) * dice.unit(),
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
    let along = at_angle(placement.angle);
    let disc = |&(far, radius): &(f32, f32)| Disc {
        middle: wrap(placement.origin + along * far * placement.size),
        radius: radius * placement.size,
    };
    placement.shape.discs.iter().map(disc).collect()
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

/// Chance that a print's seed repeats.
pub(super) struct Dice(Chance);

impl Dice {
    /// The stream of a seed.
    pub(super) const fn new(seed: u64) -> Self {
        let mixed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x10_1e;
        Self(Chance::new(mixed))
    }

    /// At least 0, less than 1.
    pub(super) fn unit(&mut self) -> f32 {
        self.0.share()
    }

    /// An angle [rad].
    pub(super) fn turn(&mut self) -> f32 {
        self.unit() * std::f32::consts::TAU
    }
}
