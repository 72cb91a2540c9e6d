//! Pieces that are wider than their cloth: cut in parts that it takes, and joined by seams where they are
//! hidden.
//!
//! A gathered panel is joined within its upper edge, which is turned to the inside, or under the ruffle that
//! is laid on it; where neither helps it is cut in widths, whose seams run down in the gathers. A back on the
//! fold gets a seam down its middle, and other pieces get gores near their sides. What shows all of its
//! cloth, as a wrap does, is not joined: then the cloth is too narrow for it.

mod split;

use kurbo::{BezPath, Point, Shape as _, Vec2};
use lole_geom::Length;
use lole_language::{Sentence, Words, words};

use crate::marker::{Nap, TableCloth, fits_cloth, size_on_cloth};
use crate::pattern::{Amount, NotionKind, Step, StepFigure, THREAD_PER_STITCH};
use crate::piece::{ClothRole, CutCount, Edge, Finish, LineKind, Mark};
use crate::{DraftError, Pattern, Piece};
use split::{ALLOWANCE, Across, split};

/// A pattern whose pieces its cloth takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// As it is sewn, its pieces whole, with a step for each piece that is joined first.
    pub pattern: Pattern,
    /// As it is cut where pieces are cut in parts: its pieces, without seams and steps.
    pub parts: Option<Pattern>,
}

/// Cuts what is wider than its cloth in parts and says how they are joined.
///
/// # Errors
/// [`DraftError::WiderThanCloth`] of the first piece that cannot be joined where a seam is hidden.
pub fn fit_to_cloth(
    mut pattern: Pattern,
    cloth: impl Fn(ClothRole) -> TableCloth,
) -> Result<Fitted, DraftError> {
    let mut parts = Vec::new();
    let mut steps = Vec::new();
    let mut joined = 0.0;
    for (index, piece) in pattern.pieces.iter_mut().enumerate() {
        let cloth = cloth(piece.cloth);
        if fits_cloth(piece, &cloth) {
            parts.push(piece.clone());
            continue;
        }
        let Some(joint) = Joint::of(piece, &cloth) else {
            let [_, across] = size_on_cloth(piece);
            return Err(DraftError::WiderThanCloth {
                piece: piece.name,
                across_cm: 100.0 * across,
                width_cm: cloth.width.to_cm(),
            });
        };
        joined += joint.length(piece);
        steps.push(joint.step(index, piece, &cloth));
        piece
            .marks
            .extend(joint.lines.into_iter().map(|path| Mark::Line {
                kind: LineKind::Join,
                path,
            }));
        parts.extend(joint.parts);
    }
    if steps.is_empty() {
        let parts = None;
        return Ok(Fitted { pattern, parts });
    }
    put_after_cutting(steps, &mut pattern.steps);
    add_thread(&mut pattern, joined);
    Ok(Fitted {
        parts: Some(Pattern {
            pieces: parts,
            ..Pattern::default()
        }),
        pattern,
    })
}

/// Puts the steps that join right behind that in which the cloth is cut, which says what is cut in parts.
fn put_after_cutting(joins: Vec<Step>, steps: &mut Vec<Step>) {
    let place = steps.iter().position(|step| step.cuts);
    if let Some(place) = place {
        let cut = &mut steps[place];
        cut.by_machine = Sentence::new(
            format!(
                "{}ただし布幅に入りきらないものは、次の手順のとおりに分けて裁ちます。ここに書いた寸法と向きは、はぎ合わせたあとのものです。",
                cut.by_machine.japanese
            ),
            format!(
                "{} But what is wider than the cloth is cut in parts, as the next step says: sizes and directions here are those of the joined cloth.",
                cut.by_machine
            ),
        );
    }
    let behind = place.map_or(0, |place| place + 1);
    steps.splice(behind..behind, joins);
}

/// Thread for seams of this length [m]: a row to join and one to neaten each allowance.
fn add_thread(pattern: &mut Pattern, joined: f64) {
    /// Rows of stitches of a seam.
    const ROWS: f64 = 3.0;
    let thread = pattern.notions.iter_mut();
    for notion in thread.filter(|notion| notion.kind == NotionKind::Thread) {
        if let Amount::Length(length) = &mut notion.amount {
            *length = *length + Length::from_m(ROWS * THREAD_PER_STITCH * joined);
        }
    }
}

/// Where a join is hidden.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Hidden {
    /// Within the upper edge that is turned to the inside.
    Inside,
    /// Under a ruffle.
    UnderRuffle,
    /// In the gathers, the grain turned.
    InGathers,
    /// Down the middle of the back.
    MiddleBack,
    /// Near the sides.
    Sides,
}

/// How a piece is cut in parts.
struct Joint {
    hidden: Hidden,
    parts: Vec<Piece>,
    /// Where the parts meet on the whole piece; those of a piece on the fold on its drawn half.
    lines: Vec<BezPath>,
    /// Beyond each of them [m].
    allowance: f64,
}

impl Joint {
    /// The first way that the cloth takes; `None` where there is none.
    fn of(piece: &Piece, cloth: &TableCloth) -> Option<Self> {
        let fits = |joint: &Self| joint.parts.iter().all(|part| fits_cloth(part, cloth));
        if piece.is_on_bias() {
            return None;
        }
        if piece.grain.y.abs() < piece.grain.x.abs() {
            return level_joints(piece).chain(widths(piece, cloth)).find(fits);
        }
        middle_back(piece)
            .into_iter()
            .find(fits)
            .or_else(|| gores(piece, cloth).find(fits))
    }

    /// Length of the seams [m], of all copies.
    fn length(&self, piece: &Piece) -> f64 {
        let halves = match self.hidden {
            Hidden::Sides if has_fold(piece) => 2.0,
            _ => 1.0,
        };
        let long: f64 = self.lines.iter().map(|path| path.perimeter(1.0e-6)).sum();
        long * halves * f64::from(piece.cut.pieces())
    }

    /// What is done as soon as the cloth is cut.
    fn step(&self, index: usize, piece: &Piece, cloth: &TableCloth) -> Step {
        /// Pinning, sewing and neatening a meter with a machine, and by hand [min/m]; and for each piece.
        const PER_METER: [f64; 2] = [5.0, 30.0];
        const EACH: f64 = 10.0;
        let [_, across] = size_on_cloth(piece);
        let (name, width) = (piece.name, cloth.width.to_cm());
        let across = 100.0 * across;
        let (sizes, length) = (self.sizes(), self.length(piece));
        let hidden = self.hidden.words();
        let allowance = 100.0 * self.allowance;
        let line_count = self.lines.len();
        let marks = piece.marks.len();
        Step {
            title: words(
                "布幅に足りない分をはぐ",
                "Join what is wider than the cloth",
            ),
            by_machine: Sentence::new(
                format!(
                    "「{}」は布幅の方向に {across:.1} cm あり、幅 {width:.0} cm の布一枚では取れません。{}に分けて裁ち、「はぎ」の端どうしを中表に縫い代 {allowance:.1} cm で縫い合わせ、端を始末して縫い代を割ります。{}。このあとは、はぎ合わせたものを一枚の「{}」として扱います。",
                    name.japanese, sizes.japanese, hidden.japanese, name.japanese
                ),
                format!(
                    "The {} is {across:.1} cm across, more than one width of {width:.0} cm. Cut it as {}, sew the joins right sides together with {allowance:.1} cm of allowance, neaten them and press them open. {}. From here on what is joined is one {}.",
                    name.english, sizes.english, hidden.english, name.english
                ),
            ),
            by_hand: None,
            figure: StepFigure::Piece {
                piece: index,
                edges: Vec::new(),
                marks: (marks..marks + line_count).collect(),
            },
            minutes: PER_METER.map(|rate| EACH + rate * length),
            cuts: false,
        }
    }

    /// What is cut, by name and number, rectangles with their sizes.
    fn sizes(&self) -> Sentence {
        let (japanese, english): (Vec<String>, Vec<String>) = (self.parts.iter())
            .map(|part| {
                let count = part.cut.pieces();
                if part.rectangle(1.0e-4).is_none() {
                    return (
                        format!("「{}」{count} 枚", part.name.japanese),
                        format!("{count} of the {}", part.name.english),
                    );
                }
                let [along, across] = size_on_cloth(part).map(|side| 100.0 * side);
                (
                    format!(
                        "「{}」{count} 枚（耳に沿って {along:.1} cm、幅の方向に {across:.1} cm）",
                        part.name.japanese
                    ),
                    format!(
                        "{count} of {along:.1} cm along the selvage by {across:.1} cm ({})",
                        part.name.english
                    ),
                )
            })
            .unzip();
        Sentence::new(japanese.join("と"), english.join(" and "))
    }
}

impl Hidden {
    const fn words(self) -> Words {
        match self {
            Self::Inside => words(
                "はぎ目は上端の折り返しの内側に隠れます",
                "The join is hidden inside the turned upper edge",
            ),
            Self::UnderRuffle => words(
                "はぎ目はフリルの下に隠れます",
                "The join is hidden under the ruffle",
            ),
            Self::InGathers => words(
                "はぎ目は縦に通り、ギャザーの中に隠れます。耳に沿う方向が丈になります",
                "The joins run down and are hidden in the gathers; the direction along the selvage becomes the height",
            ),
            Self::MiddleBack => words(
                "はぎ目は後ろ中心に来ます",
                "The join runs down the middle of the back",
            ),
            Self::Sides => words("はぎ目は脇の近くに来ます", "The joins lie near the sides"),
        }
    }
}

/// Level joins that nothing shows: in the middle of the ruffle above the top casing, on the inside, and just
/// under the line that a ruffle is laid on.
fn level_joints(piece: &Piece) -> impl Iterator<Item = Joint> {
    inside(piece).into_iter().chain(under_ruffle(piece))
}

/// A rectangle whose upper edge is turned to the inside, joined there.
fn inside(piece: &Piece) -> Option<Joint> {
    /// In a narrower ruffle above the casing both allowances would lie in the casing [m].
    const LEAST_HEADER: f64 = 1.5 * ALLOWANCE;
    let (fold, casing) = (
        level_of(piece, LineKind::TopFold)?,
        level_of(piece, LineKind::CasingTop)?,
    );
    let top = piece.edges.iter().position(|edge| edge.id == "top")?;
    let raw = fold + piece.edges[top].allowance.to_m();
    let y = fold + 0.5 * (fold - casing);
    if fold - casing < LEAST_HEADER || raw < y + ALLOWANCE || piece.edges.len() != 4 {
        return None;
    }
    let bounds = piece.stitching_line().bounding_box();
    let corners = [
        (bounds.x0, y),
        (bounds.x1, y),
        (bounds.x1, raw),
        (bounds.x0, raw),
    ]
    .map(Point::from);
    let edges = (0..4).map(|index| {
        // The facing goes around as the piece does, its lower edge and its ends like those of it.
        let [from, to] = [corners[index], corners[(index + 1) % 4]];
        match index {
            0 => Edge::straight("join", from, to, Finish::Seam)
                .with_allowance(Length::from_m(ALLOWANCE)),
            2 => Edge::straight("top", from, to, Finish::Raw),
            end => Edge::straight(piece.edges[end].id, from, to, piece.edges[end].finish)
                .with_allowance(piece.edges[end].allowance),
        }
    });
    let is_above =
        |mark: &Mark| matches!(mark, Mark::Line { path, .. } if y < path.bounding_box().center().y);
    let facing = Piece {
        id: "facing",
        name: words("折り返しの継ぎ布", "facing"),
        edges: edges.collect(),
        marks: piece
            .marks
            .iter()
            .filter(|mark| is_above(mark))
            .cloned()
            .collect(),
        ..piece.clone()
    };
    let mut below = piece.clone();
    below.edges[top].allowance = Length::from_m(y - fold + ALLOWANCE);
    below.marks.retain(|mark| !is_above(mark));
    let mut line = BezPath::new();
    line.move_to(corners[0]);
    line.line_to(corners[1]);
    Some(Joint {
        hidden: Hidden::Inside,
        parts: vec![below, facing],
        lines: vec![line],
        allowance: ALLOWANCE,
    })
}

/// A piece that a ruffle is laid on, joined under it.
fn under_ruffle(piece: &Piece) -> Option<Joint> {
    /// Below the stitches of the ruffle [m].
    const BELOW_RUFFLE: f64 = 1.5 * ALLOWANCE;
    let line = Across::Level(level_of(piece, LineKind::Placement)? - BELOW_RUFFLE);
    let [under, over] = split(piece, line)?;
    let over = Piece {
        id: "upper_part",
        name: words("上の継ぎ布", "upper part"),
        ..over
    };
    Some(Joint {
        hidden: Hidden::UnderRuffle,
        parts: vec![under, over],
        lines: vec![line.within(piece)?],
        allowance: ALLOWANCE,
    })
}

/// Height of the first marked line of a kind [m].
fn level_of(piece: &Piece, wanted: LineKind) -> Option<f64> {
    piece.marks.iter().find_map(|mark| match mark {
        Mark::Line { kind, path } if *kind == wanted => Some(path.bounding_box().center().y),
        _ => None,
    })
}

/// A gathered rectangle in strips from selvage to selvage, their warp down the body; none where the print
/// does not look the same after a quarter turn.
fn widths(piece: &Piece, cloth: &TableCloth) -> Option<Joint> {
    let is_gathered = level_of(piece, LineKind::CasingTop).is_some();
    let may_turn = cloth.nap == Nap::AllWays && cloth.border.is_none();
    let rectangle = piece.rectangle(1.0e-4);
    if !is_gathered || !may_turn || rectangle.is_none() || piece.edges.len() != 4 {
        return None;
    }
    // Any strip may lie at an end of the whole: all get the allowance of the ends.
    let ends = [1, 3].map(|edge| piece.edges[edge].allowance.to_m());
    let end = ends[0].max(ends[1]).max(ALLOWANCE);
    let (long, room) = (piece.edges[0].length(), cloth.width.to_m() - 2.0 * end);
    if room < LEAST_WIDTH {
        return None;
    }
    let mut count = 2;
    while room * f64::from(count) < long {
        count += 1;
    }
    let strip = long / f64::from(count);
    let upright = |index: u32| Across::Upright(strip * f64::from(index));
    let lines = (1..count).filter_map(|index| upright(index).within(piece));
    let lines: Vec<BezPath> = lines.collect();
    let [first, _] = split(piece, upright(1))?;
    let is_end = |edge: &Edge| ["join", "left_end", "right_end"].contains(&edge.id);
    let edges = first.edges.into_iter().map(|edge| match edge {
        edge if is_end(&edge) => Edge {
            finish: Finish::Seam,
            ..edge.with_allowance(Length::from_m(end))
        },
        edge => edge,
    });
    // Notches are cut once the strips are joined.
    let is_line = |mark: &Mark| matches!(mark, Mark::Line { .. });
    let part = Piece {
        id: "width",
        name: words("はぎ合わせる布幅", "width to be joined"),
        edges: edges.collect(),
        grain: Vec2::new(0.0, 1.0),
        marks: first.marks.into_iter().filter(is_line).collect(),
        cut: CutCount::Alike(count * piece.cut.pieces()),
        ..piece.clone()
    };
    Some(Joint {
        hidden: Hidden::InGathers,
        parts: vec![part],
        lines,
        allowance: end,
    })
}

/// Strips narrower than this are none [m].
const LEAST_WIDTH: f64 = 0.2;

fn has_fold(piece: &Piece) -> bool {
    piece.edges.iter().any(|edge| edge.finish == Finish::Fold)
}

/// A back on the fold as a pair with a seam down its middle.
fn middle_back(piece: &Piece) -> Option<Joint> {
    let fold = piece
        .edges
        .iter()
        .find(|edge| edge.finish == Finish::Fold)?;
    let CutCount::Alike(count) = piece.cut else {
        return None;
    };
    if fold.id != "center_back" {
        return None;
    }
    let edges = piece.edges.iter().map(|edge| match edge.finish {
        Finish::Fold => Edge {
            id: "join",
            finish: Finish::Seam,
            ..edge.clone().with_allowance(Length::from_m(ALLOWANCE))
        },
        _ => edge.clone(),
    });
    Some(Joint {
        hidden: Hidden::MiddleBack,
        parts: vec![Piece {
            edges: edges.collect(),
            cut: CutCount::Pairs(count),
            ..piece.clone()
        }],
        lines: vec![BezPath::from_path_segments(fold.segments.iter().copied())],
        allowance: ALLOWANCE,
    })
}

/// The piece with a gore at its side, or at both where it is on the fold: as narrow a gore as leaves the rest
/// on the cloth, and then wider ones, where a line cuts the outline more than twice.
fn gores<'a>(piece: &'a Piece, cloth: &TableCloth) -> impl Iterator<Item = Joint> + 'a {
    /// From one line that is tried to the next [m].
    const STEP: f64 = 0.01;
    /// Lines that are tried.
    const TRIES: u32 = 40;
    let bounds = piece.stitching_line().bounding_box();
    let is_wrap = !piece.edges.iter().any(|edge| edge.finish == Finish::Seam);
    let width = cloth.width.to_m();
    let first = if has_fold(piece) {
        0.5 * width - ALLOWANCE
    } else {
        bounds.x0 + width - 3.0 * ALLOWANCE
    };
    let tries = if is_wrap { 0 } else { TRIES };
    (0..tries).filter_map(move |index| {
        let line = Across::Upright(first - 1.0e-4 - STEP * f64::from(index));
        let [inner, outer] = split(piece, line)?;
        let (id, name) = gore_of(piece.id);
        let outer = Piece { id, name, ..outer };
        Some(Joint {
            hidden: Hidden::Sides,
            parts: vec![inner, outer],
            lines: vec![line.within(piece)?],
            allowance: ALLOWANCE,
        })
    })
}

/// What the gore of a piece is called.
fn gore_of(id: &str) -> (&'static str, Words) {
    match id {
        "front" => ("front_gore", words("前の脇の継ぎ布", "front side gore")),
        "back" => ("back_gore", words("後ろの脇の継ぎ布", "back side gore")),
        "sleeve" => ("sleeve_gore", words("袖の継ぎ布", "sleeve gore")),
        _ => ("gore", words("脇の継ぎ布", "side gore")),
    }
}
