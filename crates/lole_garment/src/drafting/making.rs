//! Steps, seams, notions and times that garments share.
//!
//! Times are estimates by the kind of work and its length, from the table in [`super::work`].

use lole_geom::Length;
use lole_language::{Sentence, Words, words};
use lole_pattern::pattern::{
    Amount, FinishedMeasure, Notion, NotionKind, Pattern, Seam, SeamKind, SeamSide, Step,
    StepFigure, THREAD_PER_STITCH, WrapPart,
};
use lole_pattern::piece::{Finish, LineKind, Mark, Piece};

use super::shape::marked;
use super::work::{self, Work};

/// A sentence in both languages from two format strings, Japanese first.
macro_rules! say {
    ($japanese:literal, $english:literal) => {
        lole_language::Sentence::new(format!($japanese), format!($english))
    };
}
pub(crate) use say;

/// Meters as centimeters, for a sentence.
pub(crate) fn cm(meters: f64) -> String {
    let tenths = (meters * 1000.0).round() / 10.0;
    format!("{tenths}")
}

/// The next whole number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of things on a body: hundreds"
)]
pub(crate) fn whole(count: f64) -> u32 {
    (count - 1.0e-9).ceil().clamp(0.0, 1.0e6) as u32
}

/// Time of steps that are no work, such as putting it on.
pub(crate) const NO_WORK: [f64; 2] = [0.0, 0.0];

/// Time for rows of stitches of this length [m].
pub(crate) fn stitching(meters: f64) -> [f64; 2] {
    work::minutes(&[(Work::Row, meters)])
}

/// A step.
pub(crate) const fn step(title: Words, by_machine: Sentence, minutes: [f64; 2]) -> Step {
    Step {
        title,
        by_machine,
        by_hand: None,
        figure: StepFigure::None,
        minutes,
        cuts: false,
    }
}

/// A piece with some edges brought out.
pub(crate) fn edges_of(piece: usize, edges: &[usize]) -> StepFigure {
    StepFigure::Piece {
        piece,
        edges: edges.to_vec(),
        marks: Vec::new(),
    }
}

/// A measure of the sewn garment [m], of the body there too where it is worn close to one.
pub(crate) fn sewn(name: Words, body: Option<Length>, garment: f64) -> FinishedMeasure {
    let garment = Length::from_m(garment);
    FinishedMeasure {
        name,
        body,
        garment,
    }
}

/// A part of a cloth that is wound around its wearer [m].
pub(crate) fn laid(length: f64, name: Words, around: Option<[f64; 2]>) -> WrapPart {
    let length = Length::from_m(length);
    WrapPart {
        length,
        name,
        around,
    }
}

/// The hem of a piece in section.
pub(crate) const fn hem_in_section(piece: usize) -> StepFigure {
    let marks = Vec::new();
    StepFigure::Section { piece, marks }
}

/// A whole edge of a piece, walked as it is drawn.
pub(crate) const fn side(piece: usize, copy: u32, edge: usize) -> SeamSide {
    SeamSide::whole(piece, copy, edge)
}

pub(crate) const fn plain(flat: SeamSide, full: SeamSide) -> Seam {
    let kind = SeamKind::Plain;
    Seam { flat, full, kind }
}

pub(crate) const fn gathered(flat: SeamSide, full: SeamSide) -> Seam {
    let kind = SeamKind::Gathered;
    Seam { flat, full, kind }
}

pub(crate) const fn eased(flat: SeamSide, full: SeamSide) -> Seam {
    let kind = SeamKind::Eased;
    Seam { flat, full, kind }
}

/// The seam on the wearer's left and the same one on her right.
pub(crate) fn both_sides(seam: Seam) -> [Seam; 2] {
    [0, 1].map(|copy| Seam {
        flat: seam.flat.of_copy(copy),
        full: seam.full.of_copy(copy),
        kind: seam.kind,
    })
}

/// How far a hem is folded to the wrong side, first and then again [cm]: by halves where it is narrow.
pub(crate) fn folds(hem: f64) -> [String; 2] {
    let [turn, rest] = lole_pattern::piece::hem_turns(Length::from_m(hem));
    [turn, rest].map(|fold| {
        let hundredths = (fold.to_m() * 1.0e4).round() / 100.0;
        format!("{hundredths}")
    })
}

/// A notion.
pub(crate) const fn notion(kind: NotionKind, name: Words, amount: Amount) -> Notion {
    Notion {
        kind,
        name,
        amount,
        pieces: 1,
        place: None,
        note: None,
    }
}

/// Elastic of `count` pieces of `cut` [m] each.
pub(crate) fn elastic(name: Words, count: u32, cut: f64) -> Notion {
    let each = cm(cut);
    Notion {
        pieces: count,
        note: Some(say!("{each} cm を {count} 本", "{count} of {each} cm")),
        ..notion(
            NotionKind::Elastic,
            name,
            Amount::Length(Length::from_m(cut * f64::from(count))),
        )
    }
}

/// Edges of a piece that are sewn, as often as they are cut: once for stitching, and their allowance
/// folded or neatened once more.
fn stitched(piece: &Piece) -> f64 {
    let halves = if piece.edges.iter().any(|edge| edge.finish == Finish::Fold) {
        2.0
    } else {
        1.0
    };
    let edges = piece.edges.iter().map(|edge| match edge.finish {
        // Half of the seam's own stitches, and neatening.
        Finish::Seam => edge.length() * 1.5,
        Finish::Hem => edge.length(),
        Finish::Fold | Finish::Selvage | Finish::Raw => 0.0,
    });
    edges.sum::<f64>() * halves * f64::from(piece.cut.pieces())
}

/// Length of all stitches of these pieces [m], with two more rows along every gathered edge.
pub(crate) fn stitches(pieces: &[Piece], seams: &[Seam]) -> f64 {
    let gathers = (seams.iter())
        .filter(|seam| seam.kind == SeamKind::Gathered)
        .map(|seam| 2.0 * seam.full.length(pieces));
    pieces.iter().map(stitched).sum::<f64>() + gathers.sum::<f64>()
}

/// Where a shaped piece is made longer or shorter without touching what is sewn across it: level, at the middle of
/// its side seam; `None` where it has none or is too short for it.
fn adjustment(piece: &Piece) -> Option<Mark> {
    /// A shorter side leaves no room above and below [m].
    const LEAST: f64 = 0.12;
    /// Lines are this near to curves [m].
    const TOLERANCE: f64 = 1.0e-4;
    let side = piece.edges.iter().find(|edge| edge.id.ends_with("side"))?;
    if side.length() < LEAST || piece.rectangle(TOLERANCE).is_some() {
        return None;
    }
    let (middle, _) = side.place(0.5 * side.length())?;
    let edges = piece.edges.iter().map(|edge| edge.points(TOLERANCE));
    let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
    for points in edges {
        for pair in points.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            if (from.y - middle.y) * (to.y - middle.y) <= 0.0 && from.y != to.y {
                let share = (middle.y - from.y) / (to.y - from.y);
                let x = from.x + share * (to.x - from.x);
                ends = [ends[0].min(x), ends[1].max(x)];
            }
        }
    }
    let line = ends.map(|x| kurbo::Point::new(x, middle.y));
    (ends[0] < ends[1]).then(|| marked(LineKind::Adjust, &line))
}

/// A pattern, its seams marked on both sides and its thread counted from its own edges and seams.
pub(crate) fn pattern(
    pieces: Vec<Piece>,
    seams: Vec<Seam>,
    notions: Vec<Notion>,
    steps: Vec<Step>,
) -> Pattern {
    let thread = stitches(&pieces, &seams) * THREAD_PER_STITCH;
    let mut pieces = pieces;
    for piece in &mut pieces {
        piece.marks.extend(adjustment(piece));
    }
    let mut notions = notions;
    if 0.0 < thread {
        notions.push(notion(
            NotionKind::Thread,
            words("ミシン糸", "sewing thread"),
            Amount::Length(Length::from_m(thread)),
        ));
    }
    let pattern = Pattern {
        pieces,
        seams,
        drawn_in: Vec::new(),
        notions,
        steps,
        warnings: Vec::new(),
        finished: Vec::new(),
    };
    pattern.with_matching_notches()
}

/// Length and width of a hemmed cloth [m].
pub(crate) fn length_and_width(length: f64, width: f64) -> Vec<FinishedMeasure> {
    vec![
        sewn(words("長さ", "length"), None, length),
        sewn(words("幅", "width"), None, width),
    ]
}
