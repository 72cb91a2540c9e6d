//! A whole dance: segments one after the other, and how one goes over into the next.
//!
//! A part ends on its last count and the next begins there; its own first count is the next beat.
//! Within that beat the body goes over from the one to the other, while the feet never blend: one
//! foot stays where it stands, at most turning on its ball, and the other is put where the new part
//! needs it. Where the old part's last step would end elsewhere, it closes there instead, as a
//! dancer does who knows what comes.

use lole_body::Side;
use lole_geom::narrow;

use super::ease::ramp_between;
use super::figure::{Figure, Foot, Place};
use super::score::{SLIDE_LIFT, TAP_HEEL};
use super::segment::{Length, Segment};
use super::settings::{AmiTurn, MotionSettings};
use super::steps::{LEAD_IN_COUNTS, Move, Reading, Track};

/// Counts in which one part goes over into the next.
const BLEND_COUNTS: f32 = 1.0;
/// Counts of a foot that is put elsewhere between two parts.
const ADJUST_COUNTS: f32 = 0.5;
/// A foot that lands this soon flies there from where it is.
const SOON_COUNTS: f32 = 1.25;
/// Largest turn [°] after which a foot may fly to its first landing directly; beyond it, the
/// standing foot takes a whole count to turn on its ball.
const DIRECT_TURN: f32 = 60.0;
/// Height of the heel of a foot that turns on its ball [statures], and the turn [°] that needs it.
const PIVOT_HEEL: f32 = 0.008;
const PIVOT_TURN: f32 = 3.0;
/// Feet nearer than this to where they should be stay [statures], 0.3 mm; and as straight [°].
const SAME_PLACE: f32 = 2.0e-4;
const SAME_TURN: f32 = 0.2;

/// A dance as segments in order, with what is where on the floor.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    segments: Vec<Segment>,
    /// From the ankle to the ball of each foot [statures].
    to_balls: [[f32; 2]; 2],
}

/// The segment after an end.
struct Entry<'a> {
    segment: &'a Segment,
    /// Where the feet are before it.
    end: [Foot; 2],
    /// The foot that stays.
    standing: usize,
    /// Turn of the body from before [°].
    turn: f32,
    /// Local count at which feet that are put elsewhere have landed.
    landed: f32,
}

impl Plan {
    /// The step of the settings for ever, or their parts and then the ready stance.
    pub(super) fn new(settings: &MotionSettings, to_balls: [[f32; 2]; 2]) -> Self {
        let mut plan = Self {
            segments: Vec::new(),
            to_balls,
        };
        let mut start = f64::from(LEAD_IN_COUNTS);
        let manner = |arms| MotionSettings {
            arms,
            // The side of a part says which way round it goes.
            ami_turn: AmiTurn::Akau,
            parts: Vec::new(),
            ..settings.clone()
        };
        for part in &settings.parts {
            let manner = manner(part.arms.unwrap_or(settings.arms));
            let mut segment = Segment::new(Some(part.step), manner, start);
            segment.mirrored = part.side == Side::Left;
            segment.local_start = part.step.score().first_count - 1.0;
            segment.length = Length::Counts(part.counts as f32);
            segment.facing = part.facing_degrees;
            segment.travel = part.travel;
            plan.add(segment);
            start += f64::from(part.counts);
        }
        if let Some(last) = plan.segments.last() {
            let mut rest = Segment::new(None, last.settings.clone(), start);
            rest.length = Length::Rest;
            (rest.facing, rest.mirrored) = (last.facing, last.mirrored);
            plan.add(rest);
        } else {
            let step = Some(settings.dance_step);
            plan.add(Segment::new(step, settings.clone(), start));
        }
        plan
    }

    /// The scores and manners that are danced.
    pub(super) fn readings(&self) -> impl Iterator<Item = Reading<'_>> {
        self.segments.iter().map(Segment::reading)
    }

    /// The ready stance.
    pub(super) fn stance(&self) -> Figure {
        let Some(first) = self.segments.first() else {
            return Figure::default();
        };
        Figure {
            feet: self.opening(first),
            ..first.stance()
        }
    }

    /// What the whole body does at a count of the dance; the lead-in begins at 0.
    pub(super) fn figure(&self, count: f64) -> Figure {
        let begun = |segment: &Segment| segment.start <= count;
        let index = self.segments.iter().rposition(begun).unwrap_or(0);
        let Some(segment) = self.segments.get(index) else {
            return Figure::default();
        };
        let since = narrow(count - segment.start);
        let before = index.checked_sub(1).and_then(|i| self.segments.get(i));
        let mut figure = segment.body(count);
        if since < 0.0 {
            let weight = ramp_between(since, -LEAD_IN_COUNTS, 0.0);
            figure = segment.stance().mixed(&figure, weight);
        } else if let Some(before) = before.filter(|_| since < BLEND_COUNTS) {
            let weight = ramp_between(since, 0.0, BLEND_COUNTS);
            let old = before.body(count);
            // One foot stands at every moment: what is lifted is put down before what comes is
            // lifted.
            let half = 0.5 * BLEND_COUNTS;
            let fades = ramp_between(since, 0.0, half);
            let comes = ramp_between(since, half, BLEND_COUNTS);
            let raised = [0, 1].map(|i: usize| {
                let flat = old.feet[i].mixed(&Foot::default(), fades);
                flat.mixed(&figure.feet[i], comes)
            });
            figure = Figure {
                feet: raised,
                ..old.mixed(&figure, weight)
            };
        }
        let feet = segment.feet(segment.local(count));
        for (raised, foot) in figure.feet.iter_mut().zip(feet) {
            *raised = Foot {
                lift: foot.lift + raised.lift,
                heel: foot.heel + raised.heel,
                knee_out: raised.knee_out,
                ..foot
            };
        }
        figure
    }

    /// Where the ball of a foot is on the floor [statures]; a twist leaves it there.
    fn ball(&self, foot: &Foot, i: usize) -> [f32; 2] {
        let place = Place {
            x: foot.x,
            z: foot.z,
            heading: foot.heading + side_of(i) * foot.turn_out,
        };
        place.point(self.to_balls[i])
    }

    /// A foot on the floor as it stands, said without a twist: set down as it has twisted.
    fn untwisted(&self, foot: Foot, i: usize) -> Foot {
        let heading = foot.heading + foot.twist;
        let ball = self.ball(&foot, i);
        let place = Place {
            heading: heading + side_of(i) * foot.turn_out,
            ..Place::default()
        };
        let [x, z] = place.point(self.to_balls[i]);
        Foot {
            x: ball[0] - x,
            z: ball[1] - z,
            heading,
            twist: 0.0,
            ..foot
        }
    }

    /// The feet of the ready stance before the first segment.
    fn opening(&self, first: &Segment) -> [Foot; 2] {
        let place = Place {
            heading: first.facing,
            ..Place::default()
        };
        first.home().map(|foot| place.foot(foot))
    }

    /// The feet at the end of a segment.
    fn standing_at_end(&self, before: &Segment) -> [Foot; 2] {
        let [left, right] = before.feet(before.local_end());
        [self.untwisted(left, 0), self.untwisted(right, 1)]
    }

    /// Puts a segment after the others, on the foot that stays where it stands.
    fn add(&mut self, mut segment: Segment) {
        let heading = match self.segments.last() {
            None => segment.facing,
            // Headings go on from the part before, however often it has turned.
            Some(before) => before.heading_at_end() + segment.facing - before.facing,
        };
        segment.put(Place {
            heading,
            ..Place::default()
        });
        let standing = standing_foot(self.segments.last(), &segment);
        let (end, turn, later) = match self.segments.last() {
            None => (self.opening(&segment), 0.0, 0.0),
            Some(before) => (
                self.standing_at_end(before),
                segment.facing - before.facing,
                ADJUST_COUNTS,
            ),
        };
        let [from, to] = [
            self.ball(&segment.own_first()[standing].start, standing),
            self.ball(&end[standing], standing),
        ];
        segment.put(Place {
            x: to[0] - from[0],
            z: to[1] - from[1],
            heading,
        });
        let mut entry = Entry {
            landed: segment.local_start + later,
            segment: &segment,
            end,
            standing,
            turn,
        };
        let free = 1 - standing;
        if let Some(before) = self.segments.last_mut()
            && !entry.flies_soon(free)
            && turn.abs() <= DIRECT_TURN
        {
            let end_of_half = before.reading().score.half;
            let place = segment.own_first()[free].start;
            // What it has traveled comes on top of where the step puts it.
            let [x, z] = before.traveled(free, before.local_end());
            let put = Foot {
                x: place.x - x,
                z: place.z - z,
                ..place
            };
            if let Some(step) = before.last_tracks()[free].moves.last_mut()
                && (step.count - end_of_half).abs() < 1e-3
            {
                step.foot = put;
                entry.end[free] = place;
            }
        }
        let mut first = [0, 1].map(|i| entry.track(i));
        for (i, track) in first.iter_mut().enumerate() {
            for step in &mut track.moves {
                let twisted = step.foot.twist != 0.0;
                step.settled = twisted.then(|| self.untwisted(step.foot, i));
            }
        }
        segment.first = Some(first);
        self.segments.push(segment);
    }
}

/// The foot that stays where it is while a segment begins: not the one that moves first, else not
/// the one that moved last.
fn standing_foot(before: Option<&Segment>, segment: &Segment) -> usize {
    let first_move = |i: usize| (segment.own_first()[i].moves.first()).map(|step| step.count);
    match (first_move(0), first_move(1)) {
        (Some(left), Some(right)) => usize::from(left < right),
        (Some(_), None) => 1,
        (None, Some(_)) => 0,
        (None, None) => before.map_or(0, |before| usize::from(before.lands_last() == Some(0))),
    }
}

impl Entry<'_> {
    /// Whether a foot is on its way before there is time to put it elsewhere.
    fn flies_soon(&self, i: usize) -> bool {
        let soon = self.segment.local_start + SOON_COUNTS;
        let first = self.segment.own_first()[i].moves.first();
        self.turn.abs() <= DIRECT_TURN && first.is_some_and(|step| step.count <= soon)
    }

    /// The track of a foot in the first half.
    fn track(&self, i: usize) -> Track {
        let own = &self.segment.own_first()[i];
        let leads_in = self.landed <= self.segment.local_start;
        let adjusted = if i == self.standing {
            self.settling(i)
        } else if self.flies_soon(i) && !leads_in {
            None
        } else {
            self.moved(i)
        };
        Track {
            start: self.end[i],
            moves: adjusted
                .into_iter()
                .chain(own.moves.iter().copied())
                .collect(),
        }
    }

    /// The move in place that turns a foot on its ball and lowers its heel; none where it stands
    /// as it should.
    fn settling(&self, i: usize) -> Option<Move> {
        let (foot, place) = (self.end[i], self.segment.own_first()[i].start);
        let turn = place.yaw(side_of(i)) - foot.yaw(side_of(i));
        if turn.abs() < SAME_TURN && (place.heel - foot.heel).abs() < SAME_PLACE {
            return None;
        }
        let slow = DIRECT_TURN < self.turn.abs();
        let more = if slow { ADJUST_COUNTS } else { 0.0 };
        Some(Move {
            count: self.landed + more,
            flight: ADJUST_COUNTS + more,
            foot: Foot {
                twist: foot.twist + turn,
                heel: place.heel,
                ..foot
            },
            lift: 0.0,
            heel: if PIVOT_TURN < turn.abs() {
                PIVOT_HEEL
            } else {
                0.0
            },
            swing: [0.0, 0.0],
            settled: None,
        })
    }

    /// The flight to where a foot should stand; none where it stands there.
    fn moved(&self, i: usize) -> Option<Move> {
        let (foot, place) = (self.end[i], self.segment.own_first()[i].start);
        let [dx, dz] = [place.x - foot.x, place.z - foot.z];
        let turn = place.yaw(side_of(i)) - foot.yaw(side_of(i));
        if (dx * dx + dz * dz).sqrt() < SAME_PLACE && turn.abs() < SAME_TURN {
            return self.settling(i);
        }
        Some(Move {
            count: self.landed,
            flight: ADJUST_COUNTS,
            foot: place,
            lift: SLIDE_LIFT,
            heel: 0.6 * TAP_HEEL,
            swing: [0.0, 0.0],
            settled: None,
        })
    }
}

fn side_of(i: usize) -> f32 {
    if i == 0 { 1.0 } else { -1.0 }
}
