//! A garment that nobody here drafted: its pieces as a file of another program has them, and where that
//! program lays them around a body of its own.

pub(crate) mod around;
mod numbers;
pub mod size;

use glam::{DAffine3, DVec2, DVec3};
use lole_language::{Sentence, words};
use lole_pattern::{DraftError, Pattern};

use crate::drafting::chosen::by_measure;
use crate::dress::Way;
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{MANY_SUBSTEPS, OptionRow, Options, SewnRow, Shelf, Template, Wear};

use around::{Around, Part};
pub use numbers::{MOST_PANELS, number_words, panel_id};
pub use size::{Hang, Size};

/// A garment of a file: not in the table of [`TEMPLATES`](crate::TEMPLATES), because nothing here drafts it.
pub static TEMPLATE: Template = Template {
    id: "pattern-file",
    name: words("型紙ファイルの服", "garment of a pattern file"),
    about: words(
        "ほかのプログラムの型紙から縫う服",
        "a garment sewn from another program's pattern",
    ),
    shelf: Shelf::Dresses,
    options: OPTIONS,
    draft,
    worn: Wear::Sewn(SewnRow {
        way: Way::Given,
        particle_count: 4000.0,
        substep_counts: MANY_SUBSTEPS,
    }),
    chest_room_deg: 14.0,
    natural: None,
    sketch,
};

/// Place of [`SIZE_KEY`] among the options.
pub(crate) const SIZE: usize = 0;
/// Key of the size of all pieces over that of the file.
pub const SIZE_KEY: &str = "size_ratio";

const OPTIONS: &[OptionRow] = &[by_measure(
    SIZE_KEY,
    [0.25, 4.0],
    words(
        "型紙の大きさの倍率。書かなければ、着られる大きさ",
        "size of all pieces over that of the file; left out: the one that can be worn",
    ),
)];

fn draft(_: &Fitting<'_>, _: &Options) -> Result<Pattern, DraftError> {
    Err(DraftError::NoFile)
}

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.3, 0.2], [0.7, 0.2], [0.78, 0.86], [0.22, 0.86]],
        Tone::Cloth,
    );
    pen.line(&[[0.5, 0.2], [0.5, 0.86]]);
}

/// A garment as a file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Given {
    /// One piece for each panel, cut once, and how they are joined [m].
    pub pattern: Pattern,
    /// The panels, in the order of the pieces.
    pub panels: Vec<GivenPanel>,
    /// Where the file's places are counted from.
    pub origin: Origin,
    /// What the file does not say and how it was taken, one sentence each.
    pub notes: Vec<Sentence>,
}

/// What a file says of a panel besides its outline.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenPanel {
    /// What the file calls it.
    pub name: String,
    /// Where it lies around the file's body: from the plane of its piece to that body's space [m].
    pub body_from_piece: DAffine3,
    /// Where the right side of its cloth looks in that space, unit length.
    pub outward: DVec3,
}

impl GivenPanel {
    /// A point of the piece in the space of the file's body [m].
    #[must_use]
    pub fn place(&self, point: DVec2) -> DVec3 {
        self.body_from_piece.transform_point3(point.extend(0.0))
    }
}

/// Where the places of a file are counted from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// From the floor.
    Floor,
    /// From within the trunk, some centimeters above the waist.
    Trunk,
}

impl Given {
    /// The size in which it is sewn for one body.
    #[must_use]
    pub fn size_for(&self, fitting: &Fitting<'_>, options: &Options) -> Size {
        Size::new(self, fitting, options.get(SIZE))
    }

    /// By panel, whether it covers an arm.
    pub(crate) fn on_arms(&self) -> Vec<bool> {
        let around = Around::new(self);
        let parts = around.panels.iter().map(|panel| panel.part);
        parts.map(|part| matches!(part, Part::Arm(_))).collect()
    }

    /// The piece that an edge is sewn to; `None` where nothing is.
    pub(crate) fn sewn_to(&self, piece: usize, edge: usize) -> Option<usize> {
        let sides = self.pattern.seams.iter().map(|seam| [seam.flat, seam.full]);
        let mut sides = sides.flat_map(|[a, b]| [[a, b], [b, a]]);
        let found = sides.find(|[own, _]| own.piece == piece && own.edge == edge);
        found.map(|[_, other]| other.piece)
    }

    /// The pattern for one body: all pieces in her size.
    #[must_use]
    pub fn pattern_for(&self, fitting: &Fitting<'_>, options: &Options) -> Pattern {
        self.pattern_in(&self.size_for(fitting, options))
    }

    /// The pattern in a size.
    pub(crate) fn pattern_in(&self, size: &Size) -> Pattern {
        let mut pattern = self.pattern.clone();
        let scale = kurbo::Affine::scale(size.ratio);
        let segments = pattern.pieces.iter_mut().flat_map(|piece| &mut piece.edges);
        for segment in segments.flat_map(|edge| &mut edge.segments) {
            *segment = scale * *segment;
        }
        pattern.warnings.extend(size.notes.iter().cloned());
        pattern
    }
}
