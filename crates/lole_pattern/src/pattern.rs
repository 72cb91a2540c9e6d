//! A pattern: the flat pieces of one garment, how they are joined, what else it takes, and the steps
//! of its making.

mod matching;

use lole_geom::Length;
use lole_language::{Sentence, Words};

use crate::Piece;

pub use matching::matched_parts;

/// Everything that is needed to cut and sew one garment.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pattern {
    /// Its pieces, the largest ones first.
    pub pieces: Vec<Piece>,
    /// How they are joined, in the order of sewing.
    pub seams: Vec<Seam>,
    /// Edges that elastic draws together.
    pub drawn_in: Vec<DrawnIn>,
    /// What it takes beside cloth.
    pub notions: Vec<Notion>,
    /// What is done, in order.
    pub steps: Vec<Step>,
    /// What the maker should know before cutting.
    pub warnings: Vec<Sentence>,
    /// What a tape says of the sewn garment.
    pub finished: Vec<FinishedMeasure>,
}

/// A measure of the sewn garment, beside that of the body where it is worn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FinishedMeasure {
    /// Where it is taken.
    pub name: Words,
    /// Of the body there; `None` where there is none, as at a hem that flares.
    pub body: Option<Length>,
    /// Of the garment, as it hangs or as its elastic rests.
    pub garment: Length,
}

impl FinishedMeasure {
    /// What the garment has over the body; negative where it is drawn in.
    #[must_use]
    pub fn ease(&self) -> Option<Length> {
        Some(self.garment - self.body?)
    }
}

/// Two edges that are sewn together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seam {
    /// One side; it lies flat where the other one is gathered or eased.
    pub flat: SeamSide,
    /// The other side, which is at least as long.
    pub full: SeamSide,
    /// What becomes of the difference in length.
    pub kind: SeamKind,
}

/// A stretch of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamSide {
    /// Index into [`Pattern::pieces`].
    pub piece: usize,
    /// Which of the cut pieces, from 0. Odd ones of pairs are the wearer's right, mirrored; of a piece
    /// with an edge on the fold, 0 is the drawn half and 1 its mirror image.
    pub copy: u32,
    /// Index into [`Piece::edges`].
    pub edge: usize,
    /// Where it begins and ends along the edge's stitching line, 0 to 1; from the end backwards when
    /// the first is the larger one. Both sides of a seam are walked together.
    pub between: [f64; 2],
}

/// An edge that elastic or cord draws together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnIn {
    /// The edge, as far as it is drawn in.
    pub line: SeamSide,
    /// Length of the elastic there, without what its ends overlap.
    pub length: Length,
}

/// How edges of different length are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeamKind {
    /// Both are equally long.
    Plain,
    /// The fuller one is worked in without folds, a few percent at most.
    Eased,
    /// The fuller one is gathered by rows of long stitches.
    Gathered,
}

/// What a garment takes beside cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct Notion {
    /// What sort of thing it is; costs are given by it.
    pub kind: NotionKind,
    /// What to ask for in a shop.
    pub name: Words,
    /// How much of it, all pieces together.
    pub amount: Amount,
    /// Into how many equal pieces its length is cut; 1 where it stays in one.
    pub pieces: u32,
    /// Where it goes, for labels, where that is one place of the garment: the edge of the sleeves.
    pub place: Option<Words>,
    /// How it is cut or used, where that is not plain: "3 pieces of 76.1 cm".
    pub note: Option<Sentence>,
}

impl Notion {
    /// With a word on how it is cut or used.
    #[must_use]
    pub fn noted(mut self, note: Sentence) -> Self {
        self.note = Some(note);
        self
    }
}

/// Sorts of notions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum NotionKind {
    /// Elastic in casings.
    Elastic,
    /// Cord, tape, string or ribbon.
    Cord,
    /// Sewing thread, both threads of a machine.
    Thread,
    /// A zip; its amount is the length of the opening that it closes.
    Zip,
    /// Buttons.
    Button,
    /// Hooks with their eyes.
    Hook,
    /// Flowers, artificial or fresh.
    Flower,
    /// Pistils of artificial flowers.
    Pistil,
    /// Fresh leaves and ferns.
    Leaf,
    /// Raffia, by length or by mass.
    Raffia,
    /// Cellophane and other film, by length.
    Film,
    /// Pins and clips for the hair.
    HairPin,
    /// Dried gourds.
    Gourd,
    /// Sticks of bamboo.
    Bamboo,
    /// Feathers.
    Feather,
    /// Handles of rattles.
    Handle,
    /// Seeds that rattle.
    Seed,
    /// Sheets of card.
    Card,
    /// Tubes of glue.
    Glue,
}

impl NotionKind {
    /// The word that such things are counted with in Japanese.
    #[must_use]
    pub const fn counter(self) -> &'static str {
        match self {
            Self::Leaf | Self::Card => "枚",
            Self::Seed => "粒",
            Self::Zip
            | Self::HairPin
            | Self::Pistil
            | Self::Bamboo
            | Self::Feather
            | Self::Handle
            | Self::Glue
            | Self::Elastic
            | Self::Cord => "本",
            Self::Hook => "組",
            _ => "個",
        }
    }
}

/// How much.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// By length.
    Length(Length),
    /// By number.
    Count(u32),
    /// By mass [kg].
    Mass(f64),
}

/// Sewing thread over stitched length of a lockstitch, both threads and waste included.
pub const THREAD_PER_STITCH: f64 = 3.0;

/// One thing to do.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// A few words for its head.
    pub title: Words,
    /// What to do with a sewing machine, in whole sentences with this design's own numbers.
    pub by_machine: Sentence,
    /// What to do instead by hand, where that differs.
    pub by_hand: Option<Sentence>,
    /// What its drawing shows.
    pub figure: StepFigure,
    /// Time with a machine, and by hand [min]; 0 for what is no work, such as putting it on. Estimates.
    pub minutes: [f64; 2],
    /// Whether cloth is cut in it.
    pub cuts: bool,
}

/// What the drawing of a step shows, taken from the pieces themselves.
#[derive(Debug, Clone, PartialEq)]
pub enum StepFigure {
    /// Nothing that a drawing would make clearer.
    None,
    /// A piece with some of its edges and marks brought out.
    Piece {
        /// Index into [`Pattern::pieces`].
        piece: usize,
        /// Indices into [`Piece::edges`].
        edges: Vec<usize>,
        /// Indices into [`Piece::marks`].
        marks: Vec<usize>,
    },
    /// Two edges brought together: indices into [`Pattern::seams`].
    Seams(Vec<usize>),
    /// Cloth in section, layer on layer: a fold, a casing or a hem, drawn from the marks of a piece.
    Section {
        /// Index into [`Pattern::pieces`].
        piece: usize,
        /// Indices into [`Piece::marks`] of the lines across, from the raw edge on.
        marks: Vec<usize>,
    },
    /// A long cloth that is wound around its wearer: its parts in the order in which they are laid.
    Wrapping(Vec<WrapPart>),
    /// Something that hands do without cloth.
    Craft(Craft),
}

/// A part of a cloth along its length, and where it comes to lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrapPart {
    /// How much of the cloth it is.
    pub length: Length,
    /// Where it lies.
    pub name: Words,
    /// Its way around the wearer, in turns: 0 is the middle of the front, a quarter her left, a half the
    /// middle of the back. `None` of what hangs or goes another way.
    pub around: Option<[f64; 2]>,
}

/// Work of hands that no piece of cloth shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Craft {
    /// Three strands braided.
    Braid,
    /// Leaves and flowers laid one over the other on a base and wound on with a strand.
    Wili,
    /// A leaf slit along its midrib, whole for this length above its stem.
    SlitLeaf(Length),
    /// Stems hung over a cord and bound by another one this far below it.
    LeavesOnCord(Length),
}

impl Step {
    /// The step as one in which cloth is cut.
    #[must_use]
    pub const fn cutting(mut self) -> Self {
        self.cuts = true;
        self
    }

    /// The step with how it is done by hand.
    #[must_use]
    pub fn or_by_hand(mut self, sentence: Sentence) -> Self {
        self.by_hand = Some(sentence);
        self
    }

    /// The step with what is drawn beside it.
    #[must_use]
    pub fn shown(mut self, figure: StepFigure) -> Self {
        self.figure = figure;
        self
    }
}

impl SeamSide {
    /// A whole edge of a piece, walked as it is drawn.
    #[must_use]
    pub const fn whole(piece: usize, copy: u32, edge: usize) -> Self {
        Self {
            piece,
            copy,
            edge,
            between: [0.0, 1.0],
        }
    }

    /// A part of the edge: shares of its length, walked from the first to the second.
    #[must_use]
    pub const fn between(self, from: f64, to: f64) -> Self {
        Self {
            between: [from, to],
            ..self
        }
    }

    /// The same walked from its other end.
    #[must_use]
    pub const fn back(self) -> Self {
        let [from, to] = self.between;
        self.between(to, from)
    }

    /// The same of another copy of the piece.
    #[must_use]
    pub const fn of_copy(self, copy: u32) -> Self {
        Self { copy, ..self }
    }

    /// Its length along the stitching line [m].
    ///
    /// # Panics
    /// When `pieces` has no such piece or edge.
    #[must_use]
    pub fn length(&self, pieces: &[Piece]) -> f64 {
        let edge = &pieces[self.piece].edges[self.edge];
        edge.length() * (self.between[1] - self.between[0]).abs()
    }
}

impl Pattern {
    /// The pattern with both copies of an edge drawn in by elastic of this length each.
    #[must_use]
    pub fn drawn_in(mut self, piece: usize, edge: usize, length: Length) -> Self {
        self.drawn_in.extend([0, 1].map(|copy| DrawnIn {
            line: SeamSide::whole(piece, copy, edge),
            length,
        }));
        self
    }

    /// The pattern with what a tape says of the sewn garment.
    #[must_use]
    pub fn measuring(mut self, finished: Vec<FinishedMeasure>) -> Self {
        self.finished = finished;
        self
    }

    /// The pattern with one more warning.
    #[must_use]
    pub fn warn(mut self, sentence: Sentence) -> Self {
        self.warnings.push(sentence);
        self
    }
}
