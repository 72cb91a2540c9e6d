//! The cut plan: where each piece lies on the cloth.
//!
//! The cloth lies on the table with its selvages along `x`: `x` runs along the warp from the cut end,
//! `y` across from one selvage (or from the fold of doubled cloth) to the other. Pieces are laid with
//! their grain along `x`, turned by half a turn where the cloth has no direction, and never over
//! each other. What counts is the length that is used.
//!
//! Upright rectangles are laid exactly, each into the corners that the others leave. Other pieces are
//! laid on a grid of pixels that covers them and a little more, bottom-left-fill in several orders,
//! and then pushed together until their cut lines touch.

mod item;
mod nest;
mod raster;
mod rectangles;
mod slide;
pub mod strips;

use kurbo::Affine;
use lole_geom::Length;
use lole_language::{Bilingual, Sentence, Words};

use crate::piece::{ClothRole, LineKind, Mark};
use crate::polygon::Polygon;
use crate::{Pattern, Yardage};

pub(crate) use item::{fits_cloth, size_on_cloth};

/// Cloth as it lies on the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableCloth {
    /// From selvage to selvage.
    pub width: Length,
    /// Whether it looks the same from both ends.
    pub nap: Nap,
    /// What of a piece lies along the selvage at `y = 0`, where that is printed with a border.
    pub border: Option<Border>,
    /// Repeat of the print along the warp, where it is to meet at the seams: pieces are laid whole
    /// repeats apart, measured from the lower ends of their stitching lines.
    pub matched_repeat: Option<Length>,
    /// Single, or doubled lengthwise.
    pub lay: Lay,
}

/// What of a piece lies on a printed border.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Border {
    /// Its straight hem.
    Hem,
    /// The side opposite its straight hem: the border shows at the hips.
    Hip,
}

/// From which ends cloth looks the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Nap {
    /// From all sides, as plain cloth and a print of scattered motifs do: pieces may be turned by a quarter too.
    AllWays,
    /// From both ends: pieces may be turned by half a turn.
    #[default]
    TwoWay,
    /// Its pile, shine or print has a direction: all pieces lie the same way.
    OneWay,
}

/// How cloth lies on the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Lay {
    /// One layer, right side up.
    #[default]
    Single,
    /// Folded lengthwise, right sides together, selvage on selvage: pairs are cut at once, and
    /// pieces on the fold lie at it.
    Folded,
}

/// All pieces of one cloth laid out.
#[derive(Debug, Clone, PartialEq)]
pub struct Marker {
    /// The cloth.
    pub cloth: TableCloth,
    /// Where the pieces lie, in the order in which they were laid.
    pub placed: Vec<Placed>,
    /// Length of doubled cloth, from the cut end; behind it the cloth lies single.
    pub folded_length: Length,
    /// What to buy.
    pub yardage: Yardage,
    /// Area of the pieces over that of the cloth they need.
    pub efficiency: f64,
    /// What the maker should decide before cutting.
    pub warnings: Vec<MarkerWarning>,
}

/// A piece on the cloth.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Index into [`Pattern::pieces`].
    pub piece: usize,
    /// Which of its copies, from 0; of pairs, odd ones are mirrored. Where two layers are cut at once,
    /// the first of both.
    pub copy: u32,
    /// Layers that are cut through.
    pub layers: u32,
    /// From the piece's plane to the cloth.
    pub cloth_from_piece: Affine,
    /// Its cut line on the cloth [m].
    pub outline: Polygon,
    /// It is drawn to its fold, which lies on the fold of the cloth.
    pub is_on_fold: bool,
}

/// Something that can be cut but should be decided knowingly.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MarkerWarning {
    /// A piece is wider across than the cloth.
    #[error(
        "{}: {across_cm:.1} cm lie across cloth of {width_cm:.1} cm; {}, use cloth at least {:.0} cm \
         wide, or make the piece {:.1} cm smaller", name.english, remedy(self).english, across_cm.ceil(),
         across_cm - width_cm
    )]
    WiderThanCloth {
        /// The piece.
        name: Words,
        /// Its size across the cloth [cm].
        across_cm: f64,
        /// Its size along the cloth [cm].
        along_cm: f64,
        /// Width of the cloth, or of the doubled cloth [cm].
        width_cm: f64,
    },
    /// The border cannot run along the hem of a piece.
    #[error(
        "{}: with the border along its hem it is {across_cm:.1} cm across cloth of {width_cm:.1} cm, so it \
         lies along the warp without the border; shorten it, or use wider cloth", name.english
    )]
    BorderTooNarrow {
        /// The piece.
        name: Words,
        /// Its size across the cloth with the hem at the border [cm].
        across_cm: f64,
        /// Width of the cloth [cm].
        width_cm: f64,
    },
}

impl MarkerWarning {
    /// The piece that it is about, and its size across the cloth [cm].
    #[must_use]
    pub const fn piece(&self) -> (Words, f64) {
        match self {
            Self::WiderThanCloth {
                name, across_cm, ..
            }
            | Self::BorderTooNarrow {
                name, across_cm, ..
            } => (*name, *across_cm),
        }
    }

    /// The sentence with the garment's name before the piece's, unless they are the same.
    #[must_use]
    pub fn of_garment(&self, garment: Words) -> Sentence {
        let (piece, _) = self.piece();
        if piece.english == garment.english {
            return Sentence::of(self);
        }
        Sentence::new(
            format!("{}: {}", garment.japanese, self.japanese()),
            format!("{}: {self}", garment.english),
        )
    }
}

/// What to do first about a piece that is too wide.
fn remedy(warning: &MarkerWarning) -> Words {
    use lole_language::words;
    match warning {
        MarkerWarning::WiderThanCloth {
            along_cm, width_cm, ..
        } if along_cm <= width_cm => words(
            "布目を横にして置くか",
            "lay it with its grain across the cloth",
        ),
        _ => words(
            "二枚に分けてはぎ合わせるか（縫い代を2 cm足す）",
            "cut it in two and join them with a seam (2 cm more)",
        ),
    }
}

impl Bilingual for MarkerWarning {
    fn japanese(&self) -> String {
        match self {
            Self::WiderThanCloth {
                name,
                across_cm,
                width_cm,
                ..
            } => format!(
                "{}: 布幅 {width_cm:.1} cm に対して {across_cm:.1} cm あり、はみ出します。{}、\
                 幅 {:.0} cm 以上の布にするか、{:.1} cm 小さくしてください",
                name.japanese,
                remedy(self).japanese,
                across_cm.ceil(),
                across_cm - width_cm
            ),
            Self::BorderTooNarrow {
                name,
                across_cm,
                width_cm,
            } => format!(
                "{}: 裾をボーダー柄に合わせると布幅 {width_cm:.1} cm に対して {across_cm:.1} cm あるので、\
                 ボーダーを使わず縦に置きました。丈を短くするか、幅の広い布にしてください",
                name.japanese
            ),
        }
    }
}

/// Lays out the pieces of a pattern that are cut from one of its cloths. The same pattern gives the
/// same plan.
#[must_use]
pub fn lay_out(pattern: &Pattern, role: ClothRole, cloth: &TableCloth) -> Marker {
    let pieces = (pattern.pieces.iter().enumerate()).filter(|(_, piece)| piece.cloth == role);
    let mut warnings = Vec::new();
    let mut doubled = Vec::new();
    let mut single = Vec::new();
    for (index, piece) in pieces {
        let cut = item::cut_list(index, piece, cloth, &mut warnings);
        doubled.extend(cut.doubled);
        single.extend(cut.single);
    }
    let half = cloth.width * 0.5;
    let mut placed = nest::place(&doubled, half, cloth.matched_repeat);
    let folded_length = end(&placed);
    let behind = Affine::translate((folded_length.to_m(), 0.0));
    let rest = nest::place(&single, cloth.width, cloth.matched_repeat);
    placed.extend(rest.into_iter().map(|mut piece| {
        piece.cloth_from_piece = behind * piece.cloth_from_piece;
        piece.outline = piece.outline.transformed(behind);
        piece
    }));
    let length = end(&placed);
    let area: f64 = (placed.iter())
        .map(|piece| piece.outline.signed_area() * f64::from(piece.layers))
        .sum();
    let cloth_area = length.to_m() * cloth.width.to_m();
    Marker {
        cloth: *cloth,
        folded_length,
        yardage: if is_gathered_ring(pattern, role) {
            Yardage::for_gathered(length)
        } else {
            Yardage::for_length(length)
        },
        efficiency: if 0.0 < cloth_area {
            area / cloth_area
        } else {
            0.0
        },
        warnings,
        placed,
    }
}

/// Whether all that is cut from a cloth is one rectangle that is closed to a ring and gathered on elastic.
fn is_gathered_ring(pattern: &Pattern, role: ClothRole) -> bool {
    let mut pieces = (pattern.pieces.iter().enumerate()).filter(|(_, piece)| piece.cloth == role);
    let (Some((index, piece)), None) = (pieces.next(), pieces.next()) else {
        return false;
    };
    let has_casing = piece.marks.iter().any(|mark| {
        matches!(
            mark,
            Mark::Line {
                kind: LineKind::CasingTop,
                ..
            }
        )
    });
    let is_closed =
        (pattern.seams.iter()).any(|seam| seam.flat.piece == index && seam.full.piece == index);
    has_casing && is_closed && piece.cut.pieces() == 1
}

/// How far along the cloth the pieces reach.
fn end(placed: &[Placed]) -> Length {
    let ends = placed.iter().map(|piece| piece.outline.bounds().x1);
    Length::from_m(ends.fold(0.0, f64::max))
}
