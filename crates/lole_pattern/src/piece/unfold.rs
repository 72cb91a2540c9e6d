//! Pieces turned over: the other half of a piece on the fold, the right one of a pair.

use kurbo::{Affine, ParamCurve as _, PathSeg, Point};

use super::{Edge, Finish, Mark, Piece};

/// A notch nearer to a fold than this lies on it [m].
const SAME: f64 = 1.0e-4;

impl Piece {
    /// The whole piece: what is drawn to a fold, and its mirror image beyond it. Its edges run
    /// counterclockwise from the fold on, those of the mirror image last; those that lie on a fold
    /// are gone, and its marks are there twice. A piece without a fold comes back as it is.
    #[must_use]
    pub fn unfolded(&self) -> Self {
        let fold = (self.edges.iter()).position(|edge| edge.finish == Finish::Fold);
        let Some((fold, line)) = fold.and_then(|fold| Some((fold, chord(&self.edges[fold])?)))
        else {
            return self.clone();
        };
        let count = self.edges.len();
        let half: Vec<usize> = (1..count).map(|step| (fold + step) % count).collect();
        let mirror = reflection(line);
        let mirrored = half
            .iter()
            .rev()
            .map(|&index| self.edges[index].transformed(mirror));
        let edges = half.iter().map(|&index| self.edges[index].clone());
        let place = |edge: usize| half.iter().position(|&index| index == edge);
        let near = self.marks.iter().filter_map(|mark| match mark {
            Mark::Notch { edge, .. } => Some(mark.on_edge(place(*edge)?)),
            _ => Some(mark.clone()),
        });
        let far = self.marks.iter().filter_map(|mark| match mark {
            // On the fold it is its own mirror image.
            Mark::Notch { edge, along, .. }
                if (*along < SAME && place(*edge)? == 0)
                    || (self.edges[*edge].length() - SAME < *along
                        && place(*edge)? + 1 == half.len()) =>
            {
                None
            }
            Mark::Notch { edge, .. } => {
                let twin = 2 * half.len() - 1 - place(*edge)?;
                Some(mark.transformed(mirror, self).on_edge(twin))
            }
            _ => Some(mark.transformed(mirror, self)),
        });
        let whole = Self {
            edges: edges.chain(mirrored).collect(),
            marks: near.chain(far).collect(),
            ..self.clone()
        };
        // A quarter has two folds; unfolding removes one of them and doubles the other, whose halves
        // lie on one line. Folds on both sides of a strip would never end.
        let whole = whole.join_folds();
        if whole.fold_count() < self.fold_count() {
            whole.unfolded()
        } else {
            whole
        }
    }

    fn fold_count(&self) -> usize {
        let folds = self.edges.iter();
        folds.filter(|edge| edge.finish == Finish::Fold).count()
    }

    /// The piece turned over, as the right one of a pair is cut: mirrored at `x = 0`.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let last = self.edges.len() - 1;
        let edges = self.edges.iter().rev();
        let marks = self.marks.iter().map(|mark| {
            let turned = mark.transformed(Affine::FLIP_X, self);
            match mark {
                Mark::Notch { edge, .. } => turned.on_edge(last - edge),
                _ => turned,
            }
        });
        Self {
            edges: edges.map(|edge| edge.transformed(Affine::FLIP_X)).collect(),
            grain: Affine::FLIP_X * self.grain.to_point() - Point::ORIGIN,
            marks: marks.collect(),
            ..self.clone()
        }
    }

    /// Two neighboring fold edges on one line become one.
    fn join_folds(mut self) -> Self {
        let is_fold = |edge: &Edge| edge.finish == Finish::Fold;
        let pair = (1..self.edges.len())
            .find(|&index| is_fold(&self.edges[index - 1]) && is_fold(&self.edges[index]));
        if let Some(index) = pair {
            let second = self.edges.remove(index);
            self.edges[index - 1].segments.extend(second.segments);
            for mark in &mut self.marks {
                if let Mark::Notch { edge, .. } = mark
                    && index <= *edge
                {
                    *edge -= 1;
                }
            }
        }
        self
    }
}

impl Edge {
    /// The edge under a reflection, run the other way so that cloth stays on its left.
    fn transformed(&self, mirror: Affine) -> Self {
        let segments = self.segments.iter().rev();
        Self {
            segments: segments
                .map(|segment| mirror * segment.reverse())
                .collect::<Vec<PathSeg>>(),
            ..self.clone()
        }
    }
}

impl Mark {
    /// The mark under a reflection of its piece; a notch keeps its index.
    fn transformed(&self, mirror: Affine, piece: &Piece) -> Self {
        match self {
            Self::Line { kind, path } => Self::Line {
                kind: *kind,
                path: mirror * path.clone(),
            },
            Self::Notch {
                edge,
                along,
                is_double,
            } => Self::Notch {
                edge: *edge,
                along: (piece.edges.get(*edge)).map_or(*along, |edge| edge.length() - along),
                is_double: *is_double,
            },
            Self::Point { name, at } => Self::Point {
                name: *name,
                at: mirror * *at,
            },
        }
    }

    /// The same notch on another edge; other marks have none.
    fn on_edge(&self, place: usize) -> Self {
        match self {
            Self::Notch {
                along, is_double, ..
            } => Self::Notch {
                edge: place,
                along: *along,
                is_double: *is_double,
            },
            _ => self.clone(),
        }
    }
}

/// First and last point of an edge; `None` for one without length.
fn chord(edge: &Edge) -> Option<[Point; 2]> {
    let (first, last) = (edge.segments.first()?, edge.segments.last()?);
    let chord = [first.start(), last.end()];
    (0.0 < chord[0].distance(chord[1])).then_some(chord)
}

/// Reflection at the line through two points.
pub(super) fn reflection([a, b]: [Point; 2]) -> Affine {
    let along = (b - a) / (b - a).hypot();
    let (c, s) = (
        along.x * along.x - along.y * along.y,
        2.0 * along.x * along.y,
    );
    Affine::translate(a.to_vec2())
        * Affine::new([c, s, s, -c, 0.0, 0.0])
        * Affine::translate(-a.to_vec2())
}
