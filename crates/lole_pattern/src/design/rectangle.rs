//! A gathered rectangle as a pattern: its one piece, the seam that closes it, elastic and thread.

use kurbo::{BezPath, Point, Vec2};
use lole_geom::Length;
use lole_language::{Sentence, Words, words};

use super::pau_skirt::{PauDraft, PauLine, PauWarning};
use super::steps::{Sewn, steps};
use crate::pattern::{
    Amount, FinishedMeasure, Notion, NotionKind, Pattern, Seam, SeamKind, SeamSide,
};
use crate::piece::{ClothRole, CutCount, Edge, Finish, LineKind, Mark, Piece};

/// Edges of the piece, in their order.
const LEFT_END: usize = 1;
const RIGHT_END: usize = 3;

/// Elastics and tapes by the casings that they fit, each up to this height [cm]: the elastic lies flat in its
/// casing with a few millimeters of room, the tape has both rows of stitches on it.
const CASINGS: [(f64, Words, Words); 8] = [
    (
        0.7,
        words("丸ゴム（太さ 2 mm）", "round elastic (2 mm)"),
        words("ゴム通し用テープ（1 cm 幅）", "casing tape (1 cm)"),
    ),
    (
        0.9,
        words("平ゴム（3～4 mm 幅）", "flat braided elastic (3 to 4 mm)"),
        words("ゴム通し用テープ（1 cm 幅）", "casing tape (1 cm)"),
    ),
    (
        1.3,
        words("平ゴム（5～6 mm 幅）", "flat braided elastic (5 to 6 mm)"),
        words("ゴム通し用テープ（1.5 cm 幅）", "casing tape (1.5 cm)"),
    ),
    (
        1.9,
        words("平ゴム（8～10 mm 幅）", "flat braided elastic (8 to 10 mm)"),
        words("ゴム通し用テープ（2 cm 幅）", "casing tape (2 cm)"),
    ),
    (
        2.4,
        words("平ゴム（15 mm 幅）", "flat braided elastic (15 mm)"),
        words("ゴム通し用テープ（2.5 cm 幅）", "casing tape (2.5 cm)"),
    ),
    (
        3.0,
        words("平ゴム（20 mm 幅）", "flat braided elastic (20 mm)"),
        words("ゴム通し用テープ（3 cm 幅）", "casing tape (3 cm)"),
    ),
    (
        4.0,
        words("平ゴム（25 mm 幅）", "flat braided elastic (25 mm)"),
        words("ゴム通し用テープ（4 cm 幅）", "casing tape (4 cm)"),
    ),
    (
        f64::INFINITY,
        words(
            "平ゴム（ゴム通しより 5 mm 細いもの）",
            "flat elastic (5 mm narrower than its casing)",
        ),
        words(
            "ゴム通し用テープ（ゴム通しより 1 cm 広いもの）",
            "casing tape (1 cm wider than its casing)",
        ),
    ),
];

impl PauDraft {
    /// What the tape around its lowest edge is called.
    pub const HEM: Words = words("裾まわり", "around the hem");

    /// The draft as a pattern. The piece lies as it is worn, its flat length along `x` from 0, its
    /// hem fold at `y = 0`; the warp runs around the body.
    #[must_use]
    pub fn pattern(&self, name: Words) -> Pattern {
        self.pattern_with(name, None).with_matching_notches()
    }

    /// The same with what is sewn onto it before the elastics are drawn in, and without notches.
    #[must_use]
    pub fn pattern_with(&self, name: Words, sewn: Option<Sewn>) -> Pattern {
        let below = sewn.as_ref().map_or(Length::ZERO, |sewn| sewn.below);
        Pattern {
            pieces: vec![self.piece(name)],
            seams: vec![closing_seam()],
            drawn_in: Vec::new(),
            notions: self.notions(),
            steps: steps(self, sewn),
            // What is wider than the cloth is joined where it is cut, or refused there, for whatever cloth that is.
            warnings: (self.warnings.iter())
                .filter(|warning| !matches!(warning, PauWarning::TallerThanCloth { .. }))
                .map(Sentence::of)
                .collect(),
            finished: self.finished(below),
        }
    }

    /// What a tape says of it, sewn: length and hem, with what hangs below its own edge.
    fn finished(&self, below: Length) -> Vec<FinishedMeasure> {
        let measure = |name: Words, garment: Length| FinishedMeasure {
            name,
            body: None,
            garment,
        };
        vec![
            measure(
                words("上の折り山から裾まで", "from the top fold to the hem"),
                self.finished_length + below,
            ),
            measure(Self::HEM, self.flat_length),
        ]
    }

    fn piece(&self, name: Words) -> Piece {
        let (width, height) = (self.flat_length.to_m(), self.finished_length.to_m());
        let [a, b, c, d] = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)];
        let seam_allowance = (self.cut_length - self.flat_length) * 0.5;
        let fold = self.cut_height - self.finished_length - self.hem_depth;
        let edge = |id, from: (f64, f64), to: (f64, f64), finish, allowance| {
            Edge::straight(id, from.into(), to.into(), finish).with_allowance(allowance)
        };
        Piece {
            id: "panel",
            name,
            edges: vec![
                edge("hem", a, b, Finish::Hem, self.hem_depth),
                edge("left_end", b, c, Finish::Seam, seam_allowance),
                edge("top", c, d, Finish::Hem, fold),
                edge("right_end", d, a, Finish::Seam, seam_allowance),
            ],
            grain: Vec2::new(1.0, 0.0),
            marks: self.marks(height + fold.to_m()),
            cloth: ClothRole::Main,
            cut: CutCount::Alike(1),
        }
    }

    /// Lines across the cloth, whose raw upper edge lies at `raw_edge` [m].
    fn marks(&self, raw_edge: f64) -> Vec<Mark> {
        let width = self.flat_length.to_m();
        (self.lines.iter())
            .map(|line| {
                let y = raw_edge - line.from_edge.to_m();
                let mut path = BezPath::new();
                path.move_to(Point::new(0.0, y));
                path.line_to(Point::new(width, y));
                let kind = match line.kind {
                    PauLine::TurnUnder => LineKind::TurnUnder,
                    PauLine::TopFold => LineKind::TopFold,
                    PauLine::CasingTop => LineKind::CasingTop,
                    PauLine::CasingBottom => LineKind::CasingBottom,
                    PauLine::HemFold => LineKind::HemFold,
                };
                Mark::Line { kind, path }
            })
            .collect()
    }

    fn notions(&self) -> Vec<Notion> {
        let mut notions = self.elastics();
        let tape_count = self.elastic_rows.len() - self.band_row_count;
        if 0 < tape_count {
            // Two centimeters more are turned under at the ends.
            let length = self.flat_length + Length::from_cm(2.0);
            notions.push(Notion {
                kind: NotionKind::Cord,
                name: self.widths().1,
                amount: Amount::Length(length * tape_count as f64),
                pieces: u32::try_from(tape_count).unwrap_or(1),
                place: None,
                note: Some(pieces_of(tape_count, length)),
            });
        }
        notions.push(Notion {
            kind: NotionKind::Thread,
            name: words("ミシン糸", "sewing thread"),
            amount: Amount::Length(self.thread),
            pieces: 1,
            place: None,
            note: None,
        });
        notions
    }

    /// Elastic and tape that fit the casing.
    fn widths(&self) -> (Words, Words) {
        let at = |kind| {
            let line = self.lines.iter().find(|line| line.kind == kind);
            line.map_or(Length::ZERO, |line| line.from_edge)
        };
        let casing = at(PauLine::CasingBottom) - at(PauLine::CasingTop);
        let fits = CASINGS.iter().find(|(most, ..)| casing.to_cm() < *most);
        let (_, elastic, tape) = fits.unwrap_or(&CASINGS[CASINGS.len() - 1]);
        (*elastic, *tape)
    }

    /// One notion for each elastic, from the top down.
    fn elastics(&self) -> Vec<Notion> {
        let rows = self.elastic_rows.iter();
        rows.map(|row| Notion {
            kind: NotionKind::Elastic,
            name: self.widths().0,
            amount: Amount::Length(row.cut_length),
            pieces: 1,
            place: None,
            note: None,
        })
        .collect()
    }
}

/// "3 pieces of 76.1 cm".
fn pieces_of(count: usize, length: Length) -> Sentence {
    let cm = length.to_cm();
    Sentence::new(
        format!("{cm:.1} cm を {count} 本"),
        match count {
            1 => format!("1 piece of {cm:.1} cm"),
            _ => format!("{count} pieces of {cm:.1} cm"),
        },
    )
}

fn closing_seam() -> Seam {
    let side = |edge, between| SeamSide {
        piece: 0,
        copy: 0,
        edge,
        between,
    };
    Seam {
        flat: side(LEFT_END, [0.0, 1.0]),
        full: side(RIGHT_END, [1.0, 0.0]),
        kind: SeamKind::Plain,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};

    #[test]
    fn the_piece_has_the_sizes_of_the_draft() {
        let measurements = PauMeasurements {
            hip_girth: Length::from_cm(91.4),
            worn_girth: Length::from_cm(83.0),
            worn_height: Length::from_cm(85.0),
        };
        let draft = draft_pau_skirt(&measurements, &PauOptions::default());
        let draft = draft.unwrap_or_else(|error| panic!("{error}"));
        let pattern = draft.pattern(words("パウスカート", "pāʻū skirt"));
        let piece = &pattern.pieces[0];
        let across: f64 = ["left_end", "top", "hem"]
            .map(|id| piece.edge(id))
            .into_iter()
            .flatten()
            .map(|edge| match edge.finish {
                Finish::Hem => edge.allowance.to_m(),
                _ => edge.length(),
            })
            .sum();
        assert!((across - draft.cut_height.to_m()).abs() < 1e-9);
        assert_eq!(
            piece.edges[LEFT_END].length(),
            piece.edges[RIGHT_END].length()
        );
        let is_line = |mark: &&Mark| matches!(mark, Mark::Line { .. });
        assert_eq!(
            piece.marks.iter().filter(is_line).count(),
            draft.lines.len()
        );
    }
}
