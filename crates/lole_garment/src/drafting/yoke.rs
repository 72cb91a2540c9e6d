//! Halves of a block cut along a yoke line, for dresses that hang from a yoke.

use kurbo::{Affine, ParamCurve as _, PathSeg, Point};
use lole_pattern::error::DraftError;
use lole_pattern::piece::{Edge, Finish, Mark, Piece};

use super::block::{Block, Half};
use super::chosen::Chosen;
use super::fitted::{SEAM, center_edge};
use super::shape::{CM, Label, at, edge, length, line};
use super::sleeve::armhole_notch;
use crate::garment::blouse::{NECK_LOWER, NECK_LOWER_KEY};

/// A half cut along a level line.
#[derive(Debug, Clone)]
pub(crate) struct Yoked {
    /// Level of the line over the waist [m].
    pub(crate) level: f64,
    /// The armhole from the underarm up to the line.
    pub(crate) lower: Vec<PathSeg>,
    /// The armhole from the line up to the shoulder.
    pub(crate) upper: Vec<PathSeg>,
    /// Where the line meets the armhole.
    pub(crate) end: Point,
}

/// The armhole among the edges of a yoke.
const ARMHOLE: usize = 1;
/// How far below the neckline's middle a yoke ends, where the armhole has room for it [m].
const BELOW_NECK: f64 = 3.0 * CM;
/// How far below the neckline's middle a yoke ends, at least [m].
const LEAST_BELOW_NECK: f64 = 1.5 * CM;

impl Yoked {
    /// Cuts the front and the back.
    ///
    /// # Errors
    ///
    /// [`DraftError::Option`] for `neck_lower_cm` where the neckline reaches the yoke's line.
    pub(crate) fn both(block: &Block, chosen: &Chosen<'_>) -> Result<[Self; 2], DraftError> {
        let yokes = [Self::new(&block.front), Self::new(&block.back)];
        let room = block.front.center.y - yokes[0].level - LEAST_BELOW_NECK;
        if room < 0.0 {
            let value = chosen.number(NECK_LOWER_KEY);
            return Err(DraftError::Option {
                key: NECK_LOWER_KEY,
                about: NECK_LOWER,
                value,
                min: 0.0,
                // To a whole millimetre that certainly fits.
                max: ((10.0 * (value + room / CM)).floor() / 10.0).max(0.0),
            });
        }
        Ok(yokes)
    }

    /// Cuts a half at the level where its armhole runs upright, or lower where the neckline asks for it.
    fn new(half: &Half) -> Self {
        let level = half.narrowest.y.min(half.center.y - BELOW_NECK);
        let underarm = half.underarm.y;
        let level = level.max(underarm + 0.06 * (half.shoulder[0].y - underarm));
        let mut lower = Vec::new();
        let mut upper = Vec::new();
        for segment in &half.armhole {
            match crossing(segment, level) {
                _ if segment.end().y <= level => lower.push(*segment),
                Some(share) if segment.start().y < level || upper.is_empty() && 0.0 < share => {
                    lower.push(segment.subsegment(0.0..share));
                    upper.push(segment.subsegment(share..1.0));
                }
                _ => upper.push(*segment),
            }
        }
        let end = lower.last().map_or(half.underarm, PathSeg::end);
        Self {
            level,
            lower,
            upper,
            end,
        }
    }

    /// Share of the armhole that is below the line.
    pub(crate) fn lower_share(&self) -> f64 {
        let (lower, upper) = (length(&self.lower), length(&self.upper));
        lower / (lower + upper)
    }

    /// The notch of the armhole, where it lies below the line: on this edge of the piece there.
    pub(crate) fn notch_below(&self, edge: usize, mark: fn(usize, f64) -> Mark) -> Option<Mark> {
        let at = self.notch();
        (at < length(&self.lower)).then(|| mark(edge, at))
    }

    /// The notch of the armhole from the underarm up [m].
    fn notch(&self) -> f64 {
        let armhole = length(&self.lower) + length(&self.upper);
        armhole_notch(armhole, Some(self))
    }

    /// The yoke: its lower edge, armhole, shoulder, neckline and middle. The notch of the armhole is cut
    /// as `mark` says, where it lies above the line.
    pub(crate) fn piece(
        &self,
        half: &Half,
        label: Label,
        center: (&'static str, Finish),
        mark: fn(usize, f64) -> Mark,
    ) -> Piece {
        let [tip, neck] = half.shoulder;
        let middle = at(0.0, self.level);
        // A cut segment begins where it was evaluated, and outlines close to the last bit.
        let start = self.upper.first().map_or(tip, PathSeg::start);
        let edges = vec![
            edge("yoke", vec![line(middle, start)], Finish::Seam, SEAM),
            edge("armhole", self.upper.clone(), Finish::Seam, SEAM),
            edge("shoulder", vec![line(tip, neck)], Finish::Seam, SEAM),
            edge(
                "neckline",
                half.neckline.clone(),
                Finish::Seam,
                super::fitted::BOUND,
            ),
            center_edge(center.0, vec![line(half.center, middle)], center.1),
        ];
        let over = self.notch() - length(&self.lower);
        let marks = (0.0 < over).then(|| mark(ARMHOLE, over));
        label.piece(edges, super::shape::DOWN, marks.into_iter().collect())
    }
}

/// Where a segment that rises crosses a level, by halving; `None` where it does not.
fn crossing(segment: &PathSeg, level: f64) -> Option<f64> {
    const HALVINGS: u32 = 60;
    if segment.end().y <= level {
        return None;
    }
    // A pivoted armhole dips before it rises.
    let lowest = (0..=16)
        .map(|index| f64::from(index) / 16.0)
        .min_by(|a, b| segment.eval(*a).y.total_cmp(&segment.eval(*b).y))
        .unwrap_or_default();
    if level <= segment.eval(lowest).y {
        return None;
    }
    let (mut low, mut high) = (lowest, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if segment.eval(middle).y < level {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}

/// The lower armhole as an edge, moved to the side by `spread` [m] after turning it back about the bust
/// point, so that the dart of the front lies in the gathers of its upper edge.
pub(crate) fn opened_armhole(yoked: &Yoked, block: &Block, spread: f64) -> Edge {
    let back = Affine::rotate_about(-block.dart_angle, block.bust_point);
    let moved = Affine::translate((spread, 0.0)) * back;
    let way = yoked.lower.iter().map(|segment| moved * *segment).collect();
    edge("armhole", way, Finish::Seam, SEAM)
}
