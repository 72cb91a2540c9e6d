//! Sleeves: a cap that is sewn to an armhole, exactly as long as that and its ease, or fuller and gathered.
//!
//! The cap is laid out as in Bunka's sleeve: its height is a share of the mean height of both shoulder
//! points over the armhole, and each half is as wide as makes its curve as long as its half of the
//! armhole. A puff is the same sleeve, slashed and spread: wider, and higher at the crown.
//!
//! From the underarm up to the notches the cap is as long as the armhole; what it has more, eased or
//! gathered, lies between the notches alone, evenly from each notch to the crown.
//!
//! The crown lies at `x = 0`; the front is towards `-x`; the underarm line is at `y = 0`.

use kurbo::{PathSeg, Point, Vec2};
use lole_language::words;
use lole_pattern::pattern::{Seam, SeamKind};
use lole_pattern::piece::{CutCount, Edge, Finish, LineKind, Piece};
use lole_pattern::{DraftError, Measure, Measures};

use super::block::{Block, NO_REMEDY, unfit};
use super::shape::{CM, Label, at, back_notch, beside, curve, edge, length, line, marked, notch};
use super::yoke::Yoked;
use crate::drafting::making::{both_sides, eased, gathered, plain, side};

/// Edges of a sleeve, in their order.
pub(crate) const HEM: usize = 0;
pub(crate) const BACK_SIDE: usize = 1;
pub(crate) const CAP: usize = 2;
pub(crate) const FRONT_SIDE: usize = 3;

/// What a sleeve is to be like, in meters.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SleeveFit {
    /// From the shoulder point down.
    pub(crate) length: f64,
    /// Width of the sleeve over the girth of the upper arm, at least.
    pub(crate) arm_ease: f64,
    /// Cap over armhole: 1.03 is eased, 1.5 is gathered.
    pub(crate) cap_ratio: f64,
    /// The crown of a gathered cap is raised by this.
    pub(crate) crown_raised: f64,
    /// Finished width of the lower edge; as wide as the sleeve when `None`.
    pub(crate) hem_width: Option<f64>,
    /// Cloth for the hem.
    pub(crate) hem: f64,
    /// Height of the cap over the height of the armhole.
    pub(crate) cap_height: f64,
    /// Wider than that around the upper arm, at the same cap.
    pub(crate) widened: f64,
}

/// A sleeve, and how its cap lies in the armhole.
#[derive(Debug, Clone)]
pub(crate) struct Sleeve {
    pub(crate) piece: Piece,
    /// Where the crown lies along the cap, which begins at the back underarm.
    pub(crate) crown: f64,
    /// How the cap is sewn in between its notches.
    pub(crate) kind: SeamKind,
    /// Armholes from the underarm to the shoulder, the back's and the front's [m].
    armholes: [f64; 2],
    /// Where their notches are, from the underarm up [m]; those of the cap are as far from its ends.
    notches: [f64; 2],
    /// Finished width of the lower edge [m].
    pub(crate) hem_width: f64,
}

/// Allowance of sleeve seams [m].
pub(crate) const SEAM: f64 = 1.0 * CM;
/// A cap lower than this [m] is none, and one that is higher than this over the armhole's height.
const LOWEST_CAP: f64 = 2.0 * CM;
const HIGHEST_CAP: f64 = 1.1;
/// Ratio up to which a cap is eased between its notches; fuller ones are gathered.
const MOST_EASE: f64 = 1.08;
/// Notches of an armhole from the underarm up, over its length.
const NOTCH: f64 = 0.4;
/// A notch this near to the seam of a yoke [m] would be taken for it.
const NOTCH_FROM_YOKE: f64 = 1.5 * CM;

/// Where the notch of half an armhole is, from the underarm up [m]; below the seam of a yoke that would
/// lie beside it, or above where there is no room.
pub(crate) fn armhole_notch(armhole: f64, yoke: Option<&Yoked>) -> f64 {
    let usual = NOTCH * armhole;
    let Some(seam) = yoke.map(|yoke| length(&yoke.lower)) else {
        return usual;
    };
    if NOTCH_FROM_YOKE <= (usual - seam).abs() {
        usual
    } else if 2.0 * NOTCH_FROM_YOKE < seam {
        seam - NOTCH_FROM_YOKE
    } else {
        seam + NOTCH_FROM_YOKE
    }
}

impl Sleeve {
    /// Length of its underarm seam [m].
    pub(crate) fn underarm(&self) -> f64 {
        self.piece.edges[BACK_SIDE].length()
    }

    /// A sleeve for the armholes of a block, which yokes may cut.
    ///
    /// # Errors
    /// An arm that the armhole is too small for, or that is shorter than its sleeve's cap.
    pub(crate) fn new(
        measures: &Measures,
        (block, yokes): (&Block, Option<&[Yoked; 2]>),
        fit: &SleeveFit,
    ) -> Result<Self, DraftError> {
        measures.check(&[
            Measure::UpperArmGirth,
            Measure::ArmLength,
            Measure::WristGirth,
        ])?;
        let halves = [&block.back, &block.front];
        let armholes = halves.map(|half| length(&half.armhole));
        let depths = halves.map(|half| half.shoulder[0].y - half.underarm.y);
        let depth = 0.5 * (depths[0] + depths[1]);
        let wanted = measures.upper_arm_girth.to_m() + fit.arm_ease;
        let (height, widths) = cap_of(armholes, depth * fit.cap_height, (wanted, fit.cap_ratio))
            .ok_or_else(|| {
                // The flattest cap is a line, as wide as the armhole is long.
                let most = (armholes[0] + armholes[1]) * fit.cap_ratio - fit.arm_ease;
                let least = Measure::UpperArmGirth.band_cm()[0] * CM;
                let remedy = words(
                    "。または身頃のゆとりを増やしてください",
                    ", or give the bodice more ease",
                );
                unfit(
                    Measure::UpperArmGirth,
                    measures,
                    [least, most * 0.97],
                    remedy,
                )
            })?;
        let widths_at = |height: f64| {
            let raised = height + fit.crown_raised;
            [0, 1].map(|side| {
                let wide = width_for(raised, side, armholes[side] * fit.cap_ratio);
                wide.unwrap_or(widths[side])
            })
        };
        let height = if fit.widened == 0.0 {
            height
        } else {
            let width = |height: f64| widths_at(height).iter().sum::<f64>();
            altered_cap(measures, (height, fit.widened), depth * HIGHEST_CAP, width)?
        };
        let below = fit.length - height;
        if below < LEAST_BELOW {
            let least = height + LEAST_BELOW;
            let band = [least, Measure::ArmLength.band_cm()[1] * CM];
            let remedy = words(
                "。または袖を長くしてください",
                ", or make the sleeve longer",
            );
            return Err(unfit(Measure::ArmLength, measures, band, remedy));
        }
        let raised = height + fit.crown_raised;
        let widths = if fit.crown_raised == 0.0 && fit.widened == 0.0 {
            widths
        } else {
            widths_at(height)
        };
        let [of_front, of_back] = [0, 1].map(|half| yokes.map(|yokes| &yokes[half]));
        let notches = [
            armhole_notch(armholes[0], of_back),
            armhole_notch(armholes[1], of_front),
        ];
        Ok(Self::of_cap(
            (raised, widths),
            -below,
            (fit, armholes, notches),
        ))
    }

    fn of_cap(
        (height, widths): (f64, [f64; 2]),
        hem_y: f64,
        (fit, armholes, notches): (&SleeveFit, [f64; 2], [f64; 2]),
    ) -> Self {
        let [back, front] = widths;
        let cap = cap_curve(height, widths);
        let halves = [length(&cap[..2]), length(&cap[2..])];
        let crown = halves[0] / (halves[0] + halves[1]);
        let hem_width = fit.hem_width.unwrap_or(back + front).min(back + front);
        // Both sides come in alike, so that they stay equally long.
        let inwards = 0.5 * (back + front - hem_width);
        let [hem_front, hem_back] = [at(-front + inwards, hem_y), at(back - inwards, hem_y)];
        let edges = vec![
            edge("hem", vec![line(hem_front, hem_back)], Finish::Hem, fit.hem),
            edge(
                "back_side",
                vec![line(hem_back, at(back, 0.0))],
                Finish::Seam,
                SEAM,
            ),
            edge("cap", cap, Finish::Seam, SEAM),
            edge(
                "front_side",
                vec![line(at(-front, 0.0), hem_front)],
                Finish::Seam,
                SEAM,
            ),
        ];
        let fullest = [0, 1]
            .map(|half| (halves[half] - notches[half]) / (armholes[half] - notches[half]))
            .into_iter()
            .fold(1.0, f64::max);
        let kind = if fullest <= 1.0 + 1.0e-9 {
            SeamKind::Plain
        } else if fullest <= MOST_EASE {
            SeamKind::Eased
        } else {
            SeamKind::Gathered
        };
        let marks = cap_marks(&edges[CAP], halves, (notches, kind));
        let label = Label::main("sleeve", words("袖", "sleeve"), CutCount::Pairs(1));
        let mut piece = label.piece(edges, super::shape::DOWN, marks);
        piece
            .marks
            .push(marked(LineKind::HemFold, &[hem_front, hem_back]));
        Self {
            piece,
            crown,
            kind,
            armholes,
            notches,
            hem_width,
        }
    }

    /// Seams of both sleeves: the sides, then the caps. `armholes` names the back's and the front's
    /// stretches of armhole from the underarm up: piece, edge, and the share of the whole armhole that
    /// lies in each.
    pub(crate) fn seams(&self, piece: usize, [back, front]: [&[ArmholePart]; 2]) -> Vec<Seam> {
        let mut seams = Vec::new();
        let sides = plain(side(piece, 0, BACK_SIDE), side(piece, 0, FRONT_SIDE).back());
        seams.extend(both_sides(sides));
        for (half, parts) in [back, front].into_iter().enumerate() {
            let notch = self.notches[half] / self.armholes[half];
            let mut passed = 0.0;
            for part in parts {
                let end = passed + part.share;
                for [from, to] in stretches([passed, end], notch) {
                    let within = |share: f64| ((share - passed) / part.share).clamp(0.0, 1.0);
                    let flat = side(part.piece, 0, part.edge).between(within(from), within(to));
                    let along = [from, to].map(|share| self.along_cap(half, share));
                    let full = side(piece, 0, CAP).between(along[0], along[1]);
                    seams.extend(both_sides(match self.kind {
                        _ if to <= notch + SAME_PLACE => plain(flat, full),
                        SeamKind::Plain => plain(flat, full),
                        SeamKind::Eased => eased(flat, full),
                        SeamKind::Gathered => gathered(flat, full),
                    }));
                }
                passed = end;
            }
        }
        seams
    }

    /// Where along the cap a place of an armhole is sewn: `share` of the back's (0) or the front's (1)
    /// length from the underarm up.
    fn along_cap(&self, half: usize, share: f64) -> f64 {
        let whole = self.piece.edges[CAP].length();
        let of_half = [self.crown, 1.0 - self.crown][half] * whole;
        let (armhole, notch) = (self.armholes[half], self.notches[half]);
        let over = (share * armhole - notch).max(0.0);
        let up = (share * armhole).min(notch) + over * (of_half - notch) / (armhole - notch);
        let along = (up / whole).clamp(0.0, 1.0);
        if half == 0 { along } else { 1.0 - along }
    }

    /// How long the armholes are between their notches, over the shoulder, and the cap there [m].
    pub(crate) fn between_notches(&self) -> [f64; 2] {
        let below: f64 = self.notches.iter().sum();
        let armholes: f64 = self.armholes.iter().sum();
        [armholes, self.piece.edges[CAP].length()].map(|whole| whole - below)
    }
}

/// Shares of an armhole nearer than this are one place.
const SAME_PLACE: f64 = 1.0e-6;

/// A stretch of an armhole, cut at its notch where that lies within.
fn stretches([from, to]: [f64; 2], notch: f64) -> Vec<[f64; 2]> {
    if from + SAME_PLACE < notch && notch < to - SAME_PLACE {
        vec![[from, notch], [notch, to]]
    } else {
        vec![[from, to]]
    }
}

/// A stretch of an armhole that runs up from the underarm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArmholePart {
    pub(crate) piece: usize,
    pub(crate) edge: usize,
    /// Of the whole half armhole.
    pub(crate) share: f64,
}

/// Sleeve below the underarm line [m], at least.
const LEAST_BELOW: f64 = 1.5 * CM;

/// Notches: one in front, two at the back, one at the crown; gathers in between.
fn cap_marks(
    cap: &Edge,
    [back, front]: [f64; 2],
    (notches, kind): ([f64; 2], SeamKind),
) -> Vec<lole_pattern::piece::Mark> {
    let ends = [notches[0], back + front - notches[1]];
    let mut marks = vec![
        back_notch(CAP, ends[0]),
        notch(CAP, back),
        notch(CAP, ends[1]),
    ];
    if kind == SeamKind::Gathered {
        marks.push(beside(LineKind::Gather, cap, -0.4 * CM, ends));
    }
    marks
}

/// The highest cap up to `highest` whose halves are `ratio` times the armholes and together at least
/// `wanted` wide, with the widths of back and front.
fn cap_of(
    armholes: [f64; 2],
    highest: f64,
    (wanted, ratio): (f64, f64),
) -> Option<(f64, [f64; 2])> {
    let widths = |height: f64| -> Option<[f64; 2]> {
        let back = width_for(height, 0, armholes[0] * ratio)?;
        Some([back, width_for(height, 1, armholes[1] * ratio)?])
    };
    let is_wide = |height: f64| widths(height).is_some_and(|[back, front]| wanted <= back + front);
    if is_wide(highest) {
        return Some((highest, widths(highest)?));
    }
    if !is_wide(LOWEST_CAP) {
        return None;
    }
    let least = |height: f64| widths(height).map_or(0.0, |[back, front]| back + front);
    let height = height_for([LOWEST_CAP, highest.max(LOWEST_CAP)], wanted, least);
    Some((height, widths(height)?))
}

/// Height of the cap that is wider by so much than that of a height, no higher than `highest`.
fn altered_cap(
    measures: &Measures,
    (height, widened): (f64, f64),
    highest: f64,
    width: impl Fn(f64) -> f64,
) -> Result<f64, DraftError> {
    /// Less than a fitter sees [m].
    const CLOSE: f64 = 0.05 * CM;
    let wanted = width(height) + widened;
    let altered = height_for([LOWEST_CAP, highest], wanted, &width);
    let missing = wanted - width(altered);
    if missing.abs() <= CLOSE {
        return Ok(altered);
    }
    let arm = measures.upper_arm_girth.to_m();
    let band = if 0.0 < missing {
        [Measure::UpperArmGirth.band_cm()[0] * CM, arm - missing]
    } else {
        [arm - missing, Measure::UpperArmGirth.band_cm()[1] * CM]
    };
    Err(unfit(Measure::UpperArmGirth, measures, band, NO_REMEDY))
}

/// The highest cap whose width is at least `wanted`, where a higher one is narrower.
fn height_for([mut low, mut high]: [f64; 2], wanted: f64, width: impl Fn(f64) -> f64) -> f64 {
    const HALVINGS: u32 = 60;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if wanted <= width(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Width of one half of the cap (0 the back, 1 the front) whose curve has this length; `None` where
/// the cap alone is higher.
fn width_for(height: f64, half: usize, wanted: f64) -> Option<f64> {
    const HALVINGS: u32 = 60;
    let of_width = |width: f64| {
        let curve = cap_curve(height, [width, width]);
        let part = if half == 0 { &curve[..2] } else { &curve[2..] };
        length(part)
    };
    let (mut low, mut high) = (0.25 * height, wanted);
    if wanted < of_width(low) || of_width(high) < wanted {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if of_width(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}

/// The cap from the back underarm over the crown to the front underarm: hollow below, round above,
/// deeper hollowed in front, where the arm moves.
fn cap_curve(height: f64, [back, front]: [f64; 2]) -> Vec<PathSeg> {
    let crown = at(0.0, height);
    let half = |sign: f64, width: f64, hollow: f64| -> [PathSeg; 2] {
        let underarm = at(sign * width, 0.0);
        // The curve crosses the straight line from underarm to crown in its lower half.
        let crossing: Point = underarm.lerp(crown, 0.46);
        let slope = Vec2::new(-sign * width * 0.34, height * 0.62);
        let lower = curve(
            underarm,
            Vec2::new(-sign * hollow * width, 0.0),
            slope * 0.36,
            crossing,
        );
        let upper = curve(
            crossing,
            slope * 0.52,
            Vec2::new(-sign * 0.40 * width, 0.0),
            crown,
        );
        [lower, upper]
    };
    let [back_lower, back_upper] = half(1.0, back, 0.20);
    let [front_lower, front_upper] = half(-1.0, front, 0.25);
    vec![
        back_lower,
        back_upper,
        front_upper.reverse(),
        front_lower.reverse(),
    ]
}
