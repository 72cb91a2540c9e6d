//! The motifs that the program draws: one row of [`MOTIFS`] each, with what is scattered over the
//! repeat and how.

use lole_language::{Words, words};

use super::shape::{self, Shape};

/// What is drawn on the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PrintMotif {
    /// Large hibiscus with monstera leaves and ferns.
    Hibiscus,
    /// Breadfruit (ʻulu) leaves and fruit.
    Ulu,
    /// Plumeria among its leaves.
    Plumeria,
    /// Leaves of monstera in two sizes and colors.
    Monstera,
    /// Sprays of ti (lāʻī).
    TiLeaf,
    /// Fronds of palapalai fern.
    Palapalai,
    /// ʻŌhiʻa lehua with its twigs.
    Lehua,
    /// Birds-of-paradise among their torn leaves, all upright.
    BirdOfParadise,
    /// Pineapples, all upright.
    Pineapple,
    /// Turtles (honu) in the surf.
    Honu,
    /// Medallions of a Hawaiian quilt with their echoed stitches.
    Quilt,
    /// Bands of kapa, stamped with bamboo.
    Kapa,
    /// Blocks of tapa.
    Tapa,
    /// Nothing: the ground alone.
    Plain,
}

impl PrintMotif {
    /// Whether it looks the same from all sides: neither bands nor all upright.
    #[must_use]
    pub const fn is_alike_all_around(self) -> bool {
        !matches!(self, Self::BirdOfParadise | Self::Pineapple | Self::Kapa)
    }
}

/// A row of [`MOTIFS`].
#[derive(Debug)]
pub struct MotifRow {
    /// Name in documents.
    pub id: &'static str,
    /// The motif.
    pub motif: PrintMotif,
    /// What it is called.
    pub name: Words,
    /// How it is made.
    pub(super) recipe: Recipe,
}

/// How a repeat is made.
#[derive(Debug)]
pub(super) enum Recipe {
    /// Shapes scattered over it.
    Scatter(Scatter),
    /// Ordered geometry, drawn by the print's seed.
    Geometry(super::geometry::Geometry),
    /// Nothing.
    Bare,
}

/// What is scattered, in the order in which places are found: later things take what is left.
#[derive(Debug)]
pub(super) struct Scatter {
    /// Flowers or fruit that keep apart from each other, with their radii.
    pub heroes: &'static [(Shape, f32)],
    /// Grow out from under each hero: shape, shortest and longest.
    pub tucked: &'static [(Shape, [f32; 2])],
    /// Fill what is open, from the largest to the smallest that fits.
    pub fill: &'static [Fill],
    /// The quiet layer below.
    pub shadow: Shadow,
    /// Which way things stand.
    pub stand: Stand,
}

/// What fills the open ground.
#[derive(Debug)]
pub(super) struct Fill {
    /// What it is.
    pub shape: Shape,
    /// Which colors it takes.
    pub role: Role,
    /// Largest and smallest size.
    pub sizes: [f32; 2],
    /// At most so many.
    pub most: usize,
}

/// The quiet layer below.
#[derive(Debug)]
pub(super) enum Shadow {
    /// So many leaves of this shape, shortest and longest.
    Leaves(Shape, usize, [f32; 2]),
    /// Lines of surf all across.
    Surf,
}

/// Which way things stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stand {
    /// Tossed: every way alike.
    Tossed,
    /// Heroes within some way of upright [rad], so that the print has a top.
    Upright(f32),
}

/// Which colors a shape takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// The ground's darker shade.
    Shadow,
    /// The leaves' color, with that of the flowers.
    Leaf,
    /// The flowers' color, with that of the leaves.
    Flower,
}

const fn fill(shape: Shape, role: Role, sizes: [f32; 2]) -> Fill {
    Fill {
        shape,
        role,
        sizes,
        most: usize::MAX,
    }
}

const fn few(shape: Shape, role: Role, sizes: [f32; 2], most: usize) -> Fill {
    Fill {
        shape,
        role,
        sizes,
        most,
    }
}

const MONSTERA_SHADOW: Shadow = Shadow::Leaves(shape::MONSTERA, 9, [0.26, 0.34]);

/// Every motif, in the order in which they are offered.
pub const MOTIFS: &[MotifRow] = &[
    MotifRow {
        id: "hibiscus",
        motif: PrintMotif::Hibiscus,
        name: words("ハイビスカス", "hibiscus"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::HIBISCUS, 0.168),
                (shape::HIBISCUS, 0.148),
                (shape::HIBISCUS, 0.132),
                (shape::HIBISCUS, 0.118),
            ],
            tucked: &[
                (shape::MONSTERA, [0.23, 0.31]),
                (shape::MONSTERA, [0.23, 0.31]),
                (shape::FERN, [0.27, 0.37]),
            ],
            fill: &[
                fill(shape::FERN, Role::Leaf, [0.34, 0.18]),
                fill(shape::BLOSSOM, Role::Flower, [0.062, 0.032]),
            ],
            shadow: MONSTERA_SHADOW,
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "ulu",
        motif: PrintMotif::Ulu,
        name: words("ウル（パンノキ）", "ʻulu (breadfruit)"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::BREADFRUIT, 0.168),
                (shape::BREADFRUIT, 0.148),
                (shape::BREADFRUIT, 0.132),
                (shape::BREADFRUIT, 0.118),
            ],
            tucked: &[
                (shape::BREADFRUIT_LEAF, [0.23, 0.31]),
                (shape::BREADFRUIT_LEAF, [0.23, 0.31]),
                (shape::FERN, [0.27, 0.37]),
            ],
            fill: &[
                fill(shape::BREADFRUIT_LEAF, Role::Leaf, [0.30, 0.15]),
                fill(shape::BLOSSOM, Role::Flower, [0.055, 0.032]),
            ],
            shadow: Shadow::Leaves(shape::BREADFRUIT_LEAF, 9, [0.26, 0.34]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "plumeria",
        motif: PrintMotif::Plumeria,
        name: words("プルメリア", "plumeria"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::PLUMERIA, 0.150),
                (shape::PLUMERIA, 0.140),
                (shape::PLUMERIA, 0.125),
                (shape::PLUMERIA, 0.112),
                (shape::PLUMERIA, 0.100),
            ],
            tucked: &[
                (shape::PLUMERIA_LEAF, [0.26, 0.34]),
                (shape::PLUMERIA_LEAF, [0.22, 0.30]),
            ],
            fill: &[
                few(shape::PLUMERIA, Role::Flower, [0.090, 0.060], 5),
                fill(shape::PLUMERIA_LEAF, Role::Leaf, [0.28, 0.14]),
                fill(shape::BLOSSOM, Role::Flower, [0.050, 0.028]),
            ],
            shadow: Shadow::Leaves(shape::PLUMERIA_LEAF, 14, [0.26, 0.36]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "monstera",
        motif: PrintMotif::Monstera,
        name: words("モンステラ", "monstera"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[],
            tucked: &[],
            fill: &[
                few(shape::MONSTERA, Role::Flower, [0.46, 0.40], 2),
                few(shape::MONSTERA, Role::Leaf, [0.42, 0.34], 3),
                few(shape::MONSTERA, Role::Flower, [0.34, 0.22], 4),
                fill(shape::MONSTERA, Role::Leaf, [0.26, 0.13]),
                fill(shape::BLOSSOM, Role::Flower, [0.040, 0.026]),
            ],
            shadow: Shadow::Leaves(shape::MONSTERA, 9, [0.34, 0.44]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "ti-leaf",
        motif: PrintMotif::TiLeaf,
        name: words("ティーリーフ（ラーイー）", "ti leaf (lāʻī)"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[],
            tucked: &[],
            fill: &[
                few(shape::TI_SPRAY, Role::Leaf, [0.44, 0.36], 3),
                few(shape::TI_SPRAY, Role::Flower, [0.36, 0.26], 3),
                fill(shape::TI_LEAF, Role::Leaf, [0.40, 0.20]),
                fill(shape::BLOSSOM, Role::Flower, [0.052, 0.028]),
            ],
            shadow: Shadow::Leaves(shape::TI_SPRAY, 6, [0.38, 0.46]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "palapalai",
        motif: PrintMotif::Palapalai,
        name: words("パラパライ（シダ）", "palapalai fern"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::BLOSSOM, 0.070),
                (shape::BLOSSOM, 0.060),
                (shape::BLOSSOM, 0.052),
            ],
            tucked: &[
                (shape::PALAPALAI, [0.40, 0.50]),
                (shape::PALAPALAI, [0.34, 0.44]),
                (shape::PALAPALAI, [0.28, 0.36]),
            ],
            fill: &[
                few(shape::PALAPALAI, Role::Flower, [0.44, 0.30], 4),
                fill(shape::PALAPALAI, Role::Leaf, [0.38, 0.17]),
                fill(shape::BLOSSOM, Role::Flower, [0.040, 0.026]),
            ],
            shadow: Shadow::Leaves(shape::PALAPALAI, 12, [0.36, 0.50]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "lehua",
        motif: PrintMotif::Lehua,
        name: words("オヒア・レフア", "ʻōhiʻa lehua"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::LEHUA, 0.185),
                (shape::LEHUA, 0.165),
                (shape::LEHUA, 0.145),
                (shape::LEHUA, 0.125),
            ],
            tucked: &[
                (shape::LEHUA_SPRIG, [0.26, 0.34]),
                (shape::LEHUA_SPRIG, [0.24, 0.30]),
                (shape::LEHUA_SPRIG, [0.20, 0.28]),
            ],
            fill: &[
                few(shape::LEHUA, Role::Flower, [0.100, 0.065], 4),
                fill(shape::LEHUA_SPRIG, Role::Leaf, [0.28, 0.14]),
            ],
            shadow: Shadow::Leaves(shape::LEHUA_SPRIG, 12, [0.34, 0.44]),
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "bird-of-paradise",
        motif: PrintMotif::BirdOfParadise,
        name: words("極楽鳥花", "bird-of-paradise"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[],
            tucked: &[],
            fill: &[
                few(shape::BIRD, Role::Flower, [0.62, 0.54], 3),
                few(shape::BIRD, Role::Flower, [0.50, 0.38], 4),
                few(shape::PADDLE, Role::Leaf, [0.46, 0.30], 5),
                fill(shape::PADDLE, Role::Leaf, [0.30, 0.15]),
            ],
            shadow: Shadow::Leaves(shape::PADDLE, 10, [0.40, 0.50]),
            stand: Stand::Upright(0.5),
        }),
    },
    MotifRow {
        id: "pineapple",
        motif: PrintMotif::Pineapple,
        name: words("パイナップル", "pineapple"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[],
            tucked: &[],
            fill: &[
                few(shape::PINEAPPLE, Role::Flower, [0.42, 0.38], 3),
                few(shape::PINEAPPLE, Role::Flower, [0.34, 0.28], 2),
                fill(shape::TI_LEAF, Role::Leaf, [0.32, 0.18]),
                fill(shape::BLOSSOM, Role::Flower, [0.056, 0.030]),
            ],
            shadow: Shadow::Leaves(shape::TI_SPRAY, 6, [0.36, 0.44]),
            stand: Stand::Upright(0.35),
        }),
    },
    MotifRow {
        id: "honu",
        motif: PrintMotif::Honu,
        name: words("ホヌ（ウミガメ）と波", "honu (turtle) and surf"),
        recipe: Recipe::Scatter(Scatter {
            heroes: &[
                (shape::TURTLE, 0.235),
                (shape::TURTLE, 0.205),
                (shape::TURTLE, 0.170),
                (shape::TURTLE, 0.150),
                (shape::TURTLE, 0.120),
            ],
            tucked: &[],
            fill: &[
                few(shape::WAVE, Role::Leaf, [0.150, 0.085], 12),
                few(shape::TURTLE, Role::Flower, [0.090, 0.060], 3),
                fill(shape::WAVE, Role::Leaf, [0.060, 0.034]),
            ],
            shadow: Shadow::Surf,
            stand: Stand::Tossed,
        }),
    },
    MotifRow {
        id: "quilt",
        motif: PrintMotif::Quilt,
        name: words("ハワイアンキルト", "Hawaiian quilt"),
        recipe: Recipe::Geometry(super::geometry::Geometry::Quilt),
    },
    MotifRow {
        id: "kapa",
        motif: PrintMotif::Kapa,
        name: words("カパの帯（オヘ・カーパラ）", "kapa bands (ʻohe kāpala)"),
        recipe: Recipe::Geometry(super::geometry::Geometry::Kapa),
    },
    MotifRow {
        id: "tapa",
        motif: PrintMotif::Tapa,
        name: words("タパの格子", "tapa blocks"),
        recipe: Recipe::Geometry(super::geometry::Geometry::Tapa),
    },
    MotifRow {
        id: "plain",
        motif: PrintMotif::Plain,
        name: words("無地", "plain"),
        recipe: Recipe::Bare,
    },
];

impl PrintMotif {
    /// Its row.
    #[must_use]
    pub fn row(self) -> &'static MotifRow {
        let found = MOTIFS.iter().find(|row| row.motif == self);
        // A test sees that every motif has a row.
        found.unwrap_or(&MOTIFS[MOTIFS.len() - 1])
    }

    /// The motif of this name.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        let found = MOTIFS.iter().find(|row| row.id == id);
        found.map(|row| row.motif)
    }
}
