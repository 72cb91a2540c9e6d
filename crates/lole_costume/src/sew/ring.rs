//! Lays rows of gathered cloth around the body.

use glam::Vec3;
use lole_body::{Dancer, TapePoint};

use super::SewError;
use super::fold_curve::{FoldCurve, LARGEST_SWING, SAMPLE_COUNT};

/// Points of a tape that rows are laid along.
const RING_POINTS: usize = 720;
/// Halvings of the search for the swing of a fold.
const SEARCH_STEPS: u32 = 16;
/// Distance between the tapes that follow the skin upward [m].
const PROFILE_STEP: f32 = 0.005;

/// A closed line around the body that the inner turns of a row touch.
#[derive(Clone)]
pub(super) struct Ring {
    points: Vec<TapePoint>,
    /// Its length [m].
    pub(super) girth: f32,
}

/// A row of cloth to be laid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<'a> {
    /// Distance below the ring [m].
    pub(super) drop: f32,
    /// Distance of the inner turns outside the ring [m].
    pub(super) out: f32,
    /// Length of the row's cloth [m].
    pub(super) cloth_length: f32,
    /// Particles of the row.
    pub(super) column_count: u32,
    /// Where each fold starts, as a fraction of the ring, ascending; every fold holds as much cloth.
    pub(super) fold_starts: &'a [f32],
}

/// A place on a ring: fraction around it, and distance outside it [m].
type Place = (f32, f32);

/// One fold of one row.
struct Fold {
    start: f32,
    width: f32,
    out: f32,
    /// Meters of ring, at the inner turns, that the fold fills.
    pitch: f32,
    curve: FoldCurve,
}

impl Fold {
    /// The place at `phase` in `0..1` of the fold's cloth.
    fn place(&self, phase: f32) -> Place {
        let scaled = phase * SAMPLE_COUNT as f32;
        let whole = scaled.floor();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the sample count"
        )]
        let index = (whole as usize).min(SAMPLE_COUNT - 1);
        let end = index + 1 == SAMPLE_COUNT;
        let next = if end { 0 } else { index + 1 };
        let fraction = scaled - whole;
        let (along, outward) = (&self.curve.along, &self.curve.outward);
        let next_along = if end { 1.0 } else { along[next] };
        let mixed_along = along[index] + (next_along - along[index]) * fraction;
        let mixed_out = outward[index] + (outward[next] - outward[index]) * fraction;
        (
            self.start + self.width * mixed_along,
            self.out + self.pitch * mixed_out,
        )
    }
}

impl Ring {
    /// The tape at `height` [m] of the bind pose.
    pub(super) fn at(dancer: &Dancer, height: f32) -> Result<Self, SewError> {
        let points = dancer.tape_ring(height, RING_POINTS);
        if points.is_empty() {
            return Err(SewError::NoSection {
                height_cm: f64::from(height) * 100.0,
            });
        }
        Ok(Self::of(points))
    }

    fn of(points: Vec<TapePoint>) -> Self {
        let next = points.iter().cycle().skip(1);
        let girth = points
            .iter()
            .zip(next)
            .map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum();
        Self { points, girth }
    }

    /// `count` rings above `height`, from the tape there, each `spacing` [m] further up along the
    /// skin: at the sides, where the hips lean in, a row rises less than in front.
    pub(super) fn upward(
        dancer: &Dancer,
        height: f32,
        spacing: f32,
        count: u32,
    ) -> Result<Vec<Self>, SewError> {
        let mut below = Self::at(dancer, height)?;
        let mut rows = vec![Vec::with_capacity(RING_POINTS); count as usize];
        let mut climbed = vec![0.0_f32; RING_POINTS];
        let mut reached = vec![0_usize; RING_POINTS];
        let mut level = height;
        while reached.iter().any(|&row| row < count as usize) {
            level += PROFILE_STEP;
            let above = Self::at(dancer, level)?;
            for index in 0..RING_POINTS {
                let (low, high) = (&below.points[index], &above.points[index]);
                let rise = low
                    .bind_position
                    .distance(high.bind_position)
                    .max(PROFILE_STEP);
                let missing = |row: usize| (row + 1) as f32 * spacing - climbed[index];
                while reached[index] < count as usize && missing(reached[index]) <= rise {
                    let share = missing(reached[index]) / rise;
                    rows[reached[index]].push((index, mix(low, high, share)));
                    reached[index] += 1;
                }
                climbed[index] += rise;
            }
            below = above;
        }
        let rings = rows.into_iter().map(|mut row| {
            row.sort_by_key(|&(index, _)| index);
            Self::of(row.into_iter().map(|(_, point)| point).collect())
        });
        Ok(rings.collect())
    }

    /// Lays one row: every fold as deep as it takes to bring its share of the cloth onto its share
    /// of the ring, particles evenly along the cloth.
    pub(super) fn lay(&self, row: Row<'_>, into: &mut Vec<TapePoint>) {
        let fold_count = row.fold_starts.len();
        let folds: Vec<Fold> = (0..fold_count).map(|index| self.fold(row, index)).collect();
        for column in 0..row.column_count {
            let cloth = column as f32 * fold_count as f32 / row.column_count as f32;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "below the number of folds"
            )]
            let fold = (cloth as usize).min(fold_count - 1);
            let place = folds[fold].place(cloth - fold as f32);
            let mut point = self.nearest_point(place.0);
            point.bind_position = self.position(place);
            point.bind_position.y -= row.drop;
            into.push(point);
        }
    }

    fn fold(&self, row: Row<'_>, index: usize) -> Fold {
        let fold_count = row.fold_starts.len();
        let start = row.fold_starts[index];
        let end = row
            .fold_starts
            .get(index + 1)
            .copied()
            .unwrap_or(1.0 + row.fold_starts[0]);
        let cloth = row.cloth_length / fold_count as f32;
        // Particles cut the corners of the curve; the polygon through them must hold the cloth.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a dozen particles a fold"
        )]
        let corner_count = (row.column_count as f32 / fold_count as f32)
            .round()
            .max(2.0) as u32;
        let with_swing = |swing: f32| Fold {
            start,
            width: end - start,
            out: row.out,
            pitch: (end - start) * (self.girth + std::f32::consts::TAU * row.out),
            curve: FoldCurve::new(swing),
        };
        let (mut low, mut high) = (0.0, LARGEST_SWING);
        for _ in 0..SEARCH_STEPS {
            let swing = 0.5 * (low + high);
            if self.polygon_length(&with_swing(swing), corner_count) < cloth {
                low = swing;
            } else {
                high = swing;
            }
        }
        with_swing(0.5 * (low + high))
    }

    fn polygon_length(&self, fold: &Fold, corner_count: u32) -> f32 {
        let corner = |index: u32| {
            let phase = index as f32 / corner_count as f32;
            self.position(if index == corner_count {
                (fold.start + fold.width, fold.out)
            } else {
                fold.place(phase)
            })
        };
        (0..corner_count)
            .map(|index| corner(index).distance(corner(index + 1)))
            .sum()
    }

    fn position(&self, (around, out): Place) -> Vec3 {
        let (a, b, fraction) = self.neighbors(around);
        let outward = a.outward.lerp(b.outward, fraction).normalize_or(a.outward);
        a.bind_position.lerp(b.bind_position, fraction) + outward * out
    }

    /// The point nearest to a fraction around the ring: its bones carry what is laid there.
    fn nearest_point(&self, around: f32) -> TapePoint {
        let (a, b, fraction) = self.neighbors(around);
        if fraction < 0.5 { *a } else { *b }
    }

    fn neighbors(&self, around: f32) -> (&TapePoint, &TapePoint, f32) {
        let place = (around - around.floor()) * self.points.len() as f32;
        let whole = place.floor();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of points"
        )]
        let index = whole as usize % self.points.len();
        let next = (index + 1) % self.points.len();
        (&self.points[index], &self.points[next], place - whole)
    }
}

/// The point a fraction of the way from `low` to `high`, carried by the nearer one's bones.
fn mix(low: &TapePoint, high: &TapePoint, fraction: f32) -> TapePoint {
    let carrier = if fraction < 0.5 { low } else { high };
    TapePoint {
        bind_position: low.bind_position.lerp(high.bind_position, fraction),
        outward: low
            .outward
            .lerp(high.outward, fraction)
            .normalize_or(low.outward),
        ..*carrier
    }
}
