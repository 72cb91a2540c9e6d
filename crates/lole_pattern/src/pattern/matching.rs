//! Notches that meet: every seam of two edges is marked on both of them, so that whoever pins it knows at
//! each mark how the rest lies.
//!
//! A seam is marked where it begins or ends within an edge, at the folds of its pieces, which are the
//! middles of the body, and between them at equal parts. Gathered seams are marked at halves of halves, as
//! people find them by folding: quarters and eighths. As both sides are walked together, the lengths from
//! mark to mark differ as those of the whole seam do.

use super::{Pattern, Seam, SeamKind, SeamSide};
use crate::piece::{Finish, Mark, Piece};

/// Marks nearer than this are one [m].
const SAME: f64 = 1.0e-4;
/// Marks between others keep this far from them [m]: nearer ones are mistaken for each other. One that is there
/// already stands in for one that would be nearer, so marks lie up to twice this farther apart than wanted.
const APART: f64 = 0.025;
/// Seams shorter than these need no mark between their ends [m].
const SHORT_GATHERS: f64 = 0.12;
const SHORT_SEAM: f64 = 0.15;
/// Farthest from mark to mark on the flat side [m].
const GATHERS_APART: f64 = 0.25;
const SEAM_APART: f64 = 0.40;

/// Into how many equal parts a seam is marked whose flat side has this length [m].
#[must_use]
pub fn matched_parts(kind: SeamKind, flat: f64) -> u32 {
    match kind {
        SeamKind::Gathered if flat < SHORT_GATHERS => 1,
        SeamKind::Gathered => {
            let mut parts = 2;
            while GATHERS_APART * f64::from(parts) < flat {
                parts *= 2;
            }
            parts
        }
        SeamKind::Plain | SeamKind::Eased if flat < SHORT_SEAM => 1,
        SeamKind::Plain | SeamKind::Eased => {
            let mut parts = 2;
            while SEAM_APART * f64::from(parts) < flat {
                parts += 1;
            }
            parts
        }
    }
}

impl Pattern {
    /// The pattern with notches on both sides of every seam; those that are there already stay.
    #[must_use]
    pub fn with_matching_notches(mut self) -> Self {
        let lengths: Vec<Vec<f64>> = (self.pieces.iter())
            .map(|piece| piece.edges.iter().map(|edge| edge.length()).collect())
            .collect();
        let of = |side: &SeamSide| lengths[side.piece][side.edge];
        for seam in &self.seams {
            for share in [0.0, 1.0] {
                for side in [seam.flat, seam.full] {
                    let along = along(&side, of(&side), share);
                    self.pieces[side.piece].notch_within(side.edge, along, of(&side));
                }
            }
        }
        // Copies of one piece have the same marks, so those made from here on keep no others away.
        let counts: Vec<usize> = self.pieces.iter().map(|piece| piece.marks.len()).collect();
        for seam in &self.seams {
            let sides = [seam.flat, seam.full].map(|side| (side, of(&side)));
            let places = inner_shares(seam, sides[0].1)
                .map(|share| sides.map(|(side, whole)| (side, along(&side, whole, share))));
            let is_free = |places: &[(SeamSide, f64); 2]| {
                !places.iter().any(|(side, along)| {
                    let marks = &self.pieces[side.piece].marks[..counts[side.piece]];
                    has_notch(marks, side.edge, [*along, APART])
                })
            };
            let free: Vec<_> = places.filter(is_free).flatten().collect();
            for (side, along) in free {
                self.pieces[side.piece].push_notch(side.edge, along);
            }
        }
        self
    }
}

/// Where a share of a seam's side lies from the beginning of its edge, which is `whole` long [m].
fn along(side: &SeamSide, whole: f64, share: f64) -> f64 {
    let [from, to] = side.between;
    (from + (to - from) * share) * whole
}

/// Shares at which a seam is marked between its ends; its flat edge is `whole` long [m].
fn inner_shares(seam: &Seam, whole: f64) -> impl Iterator<Item = f64> {
    let [from, to] = seam.flat.between;
    let parts = matched_parts(seam.kind, whole * (to - from).abs());
    (1..parts).map(move |part| f64::from(part) / f64::from(parts))
}

impl Piece {
    /// A notch where a seam ends within the edge, or at a fold, which is within the whole piece.
    fn notch_within(&mut self, edge: usize, along: f64, whole: f64) {
        let count = self.edges.len();
        let is_fold = |other: usize| self.edges[other].finish == Finish::Fold;
        let is_corner = if along < SAME {
            !is_fold((edge + count - 1) % count)
        } else if whole - SAME < along {
            !is_fold((edge + 1) % count)
        } else {
            false
        };
        if !is_corner {
            self.push_notch(edge, along.clamp(0.0, whole));
        }
    }

    /// A notch, where there is none.
    fn push_notch(&mut self, edge: usize, along: f64) {
        if !has_notch(&self.marks, edge, [along, SAME]) {
            self.marks.push(Mark::Notch {
                edge,
                along,
                is_double: false,
            });
        }
    }
}

/// Whether there is a notch on an edge as near as that to a place.
fn has_notch(marks: &[Mark], wanted: usize, [place, distance]: [f64; 2]) -> bool {
    marks.iter().any(|mark| {
        matches!(mark, Mark::Notch { edge, along, .. }
            if *edge == wanted && (along - place).abs() < distance)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gathers_are_marked_at_halves_of_halves_and_seams_at_equal_parts() {
        let gathers =
            [0.1, 0.15, 0.5, 0.6, 1.8].map(|flat| matched_parts(SeamKind::Gathered, flat));
        assert_eq!(gathers, [1, 2, 2, 4, 8]);
        let seams = [0.1, 0.5, 1.0, 1.3].map(|flat| matched_parts(SeamKind::Plain, flat));
        assert_eq!(seams, [1, 2, 3, 4]);
    }
}
