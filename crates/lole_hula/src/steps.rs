//! Reads a score: what the body does at one local count, seen from where the score begins.
//!
//! Feet come in two layers. Where a foot stands, flies and twists is a [`Foot`] of [`stands`];
//! what heel, ball and knee do in that place are the feet of [`figure`], to be added on top: a
//! mixture of two figures never moves a foot that stands.

use std::f32::consts::{PI, TAU};

use lole_geom::trig;

use super::arms;
use super::ease::{dip_area, hinge, hump, mix, ramp, ramp_between, rounded_abs, soft_min};
use super::figure::{Figure, Foot, Pelvis, turned};
use super::score::{Answer, FootScore, Hips, LEFT, Landing, Score, Stand, Sway, TAP_HEEL, Travel};
use super::settings::{HipLead, HipLift, MotionSettings};

/// Counts of the lead-in from the ready stance to the first count of the loop.
pub(super) const LEAD_IN_COUNTS: f32 = 2.0;

/// Counts on either side of the turns of an even walk within which it is rounded.
const TURN_COUNTS: f32 = 0.7;
/// Counts before and after a landing in which the body follows the foot.
const FOLLOW_COUNTS: [f32; 2] = [0.75, 0.5];
/// Most the head sinks in the middle of a sway [statures], 0.5 cm.
const BOB: f32 = 0.003;
/// Counts on either side of a change of rate within which a circle is rounded.
const RATE_CHANGE_COUNTS: f32 = 0.4;
/// The ball of a foot before its ankle [statures], of the mean woman.
const BALL_AHEAD: f32 = 0.077;
/// Width over which the front of a circle is cut off [statures], 1 cm.
const CUT: f32 = 0.006;

/// A dance step in the manner of some settings.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reading<'a> {
    /// The step.
    pub score: &'a Score,
    /// The manner.
    pub settings: &'a MotionSettings,
}

/// The ready stance: standing even, arms where the step begins.
pub(super) fn stance(reading: Reading<'_>) -> Figure {
    let plan = reading.score.arms_of(reading.settings);
    let (arms, gaze, nod) = arms::ready(plan, reading.score.counts(), reading.settings);
    Figure {
        arms,
        gaze,
        nod,
        ..Figure::default()
    }
}

/// Figure at a local count of the loop, whose feet are to be added to [`stands`]. Counts below 0
/// are the lead-in.
pub(super) fn figure(reading: Reading<'_>, count: f32) -> Figure {
    let Reading { score, settings } = reading;
    let moment = Moment::of(score, count);
    let mut figure = Figure {
        pelvis: pelvis(reading, moment, count),
        feet: raised_feet(score, moment),
        ..Figure::default()
    };
    for (i, free) in [-1.0, 1.0].into_iter().enumerate() {
        if score.feet[i].heel_follows {
            let away = free * sway_side(reading, moment, count);
            figure.feet[i].heel += settings.heel_lift * ramp((away - 0.4) / 0.6);
        }
    }
    let plan = score.arms_of(settings);
    (figure.arms, figure.gaze, figure.nod) =
        arms::of_count(plan, score.counts(), count - score.arms_later, settings);
    figure
}

/// A local count within the written half or its answer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    /// Count within the half.
    pub count: f32,
    /// Whether it is in the answer.
    pub answers: bool,
}

impl Moment {
    /// Where a local count falls.
    pub(super) fn of(score: &Score, count: f32) -> Self {
        let within = count.rem_euclid(score.counts());
        let answers = score.answer != Answer::Repeat && score.half <= within;
        Self {
            count: if answers { within - score.half } else { within },
            answers,
        }
    }

    /// 1 in the written half, −1 in its mirror image.
    fn side(self) -> f32 {
        if self.answers { -1.0 } else { 1.0 }
    }
}

impl Score {
    /// The movement of the arms that settings ask for.
    pub(super) fn arms_of(&self, settings: &MotionSettings) -> arms::ArmPlan {
        arms::ArmPlan::of(settings.arms, self.arms)
    }

    /// Where a point of the written half is in its answer [statures].
    fn answered(&self, point: [f32; 2], settings: &MotionSettings) -> [f32; 2] {
        let way = self.way.resolve(settings);
        match self.answer {
            Answer::Repeat => point,
            Answer::Mirror => [way[0] - point[0], point[1]],
            Answer::MirrorBackward => [way[0] - point[0], way[1] - point[1]],
        }
    }

    /// A foot of the written half as the other foot of its answer.
    fn answered_foot(&self, foot: Foot, settings: &MotionSettings) -> Foot {
        let way = self.way.resolve(settings);
        let mirrored = foot.mirrored(way[0]);
        let [_, z] = self.answered([foot.x, foot.z], settings);
        Foot { z, ..mirrored }
    }
}

/// Counts before a landing at which the foot leaves the floor.
pub(super) fn flight(landing: &Landing, settings: &MotionSettings) -> f32 {
    // Where the hips are early over the stepping foot, the other foot follows earlier.
    match settings.hip_lead {
        HipLead::SteppingFoot if landing.closes => 1.5 * landing.flight,
        HipLead::SteppingFoot | HipLead::OtherFoot => landing.flight,
    }
}

/// A foot as it stands, in the axes of the score; `side` is +1 left, −1 right.
pub(super) fn standing_foot(stand: &Stand, settings: &MotionSettings) -> Foot {
    let [x, z] = stand.spot.resolve(settings);
    Foot {
        x,
        z,
        heading: stand.heading,
        heel: stand.heel,
        turn_out: settings.toe_out_degrees + stand.turn_out,
        ..Foot::default()
    }
}

/// One foot on its way through one half.
#[derive(Debug, Clone, Default)]
pub(super) struct Track {
    /// How it stands before the first move.
    pub start: Foot,
    /// Where it goes, in order.
    pub moves: Vec<Move>,
}

/// A flight, or a turn in its place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Move {
    /// Local count of the landing.
    pub count: f32,
    /// Counts it takes.
    pub flight: f32,
    /// How it stands afterwards.
    pub foot: Foot,
    /// How high it flies [statures]; 0 stays on the ball.
    pub lift: f32,
    /// How high the heel goes with it [statures].
    pub heel: f32,
    /// How far it swings out [statures].
    pub swing: [f32; 2],
    /// How it stands afterwards in other terms, not twisted but set down where it has twisted to; `None`
    /// where `foot` says it already.
    pub settled: Option<Foot>,
}

impl Track {
    /// The foot at a local count.
    pub(super) fn at(&self, count: f32) -> Foot {
        let mut foot = self.start;
        for step in &self.moves {
            let flight = (count - step.count) / step.flight + 1.0;
            if flight <= 0.0 {
                break;
            }
            if let (Some(settled), true) = (step.settled, 1.0 <= flight) {
                foot = settled;
                continue;
            }
            let way = ramp(flight);
            let place = step.foot;
            let [side, ahead] = step.swing;
            // A foot that stays on the floor turns while its heel is up.
            let turned = if step.lift <= 0.0 {
                ramp((flight - 0.15) / 0.7)
            } else {
                way
            };
            foot = Foot {
                x: mix(foot.x, place.x, way) + side * hump(flight),
                z: mix(foot.z, place.z, way) + ahead * hump(1.6 * flight),
                heading: mix(foot.heading, place.heading, way),
                twist: mix(foot.twist, place.twist, turned),
                lift: step.lift * hump(flight),
                // The heel leaves first and the ball lands first.
                heel: mix(foot.heel, place.heel, way) + step.heel * hump(flight),
                turn_out: mix(foot.turn_out, place.turn_out, way),
                knee_out: 0.0,
            };
        }
        foot
    }
}

impl Move {
    /// The flight to a landing.
    fn to(landing: &Landing, settings: &MotionSettings) -> Self {
        Self {
            count: landing.count,
            flight: flight(landing, settings),
            foot: standing_foot(&landing.stand, settings),
            lift: landing.lift,
            heel: 0.6 * TAP_HEEL,
            swing: landing.swing,
            settled: None,
        }
    }

    /// The move as the answer to the written half has it.
    fn answered(&self, score: &Score, settings: &MotionSettings) -> Self {
        let back = match score.answer {
            Answer::MirrorBackward => -1.0,
            Answer::Mirror | Answer::Repeat => 1.0,
        };
        Self {
            foot: score.answered_foot(self.foot, settings),
            swing: [-self.swing[0], back * self.swing[1]],
            ..*self
        }
    }
}

/// The tracks [left, right] of the written half.
pub(super) fn tracks(reading: Reading<'_>) -> [Track; 2] {
    let Reading { score, settings } = reading;
    score.feet.map(|foot: FootScore| Track {
        start: standing_foot(&foot.start, settings),
        moves: (foot.landings.iter())
            .map(|landing| Move::to(landing, settings))
            .collect(),
    })
}

/// The tracks [left, right] of the answer.
pub(super) fn answering_tracks(reading: Reading<'_>, tracks: &[Track; 2]) -> [Track; 2] {
    let Reading { score, settings } = reading;
    let answered = |track: &Track| Track {
        start: score.answered_foot(track.start, settings),
        moves: (track.moves.iter())
            .map(|step| step.answered(score, settings))
            .collect(),
    };
    [answered(&tracks[1]), answered(&tracks[0])]
}

/// Where the feet [left, right] stand, fly and twist at a moment, given the tracks of the written
/// half.
pub(super) fn stands(reading: Reading<'_>, tracks: &[Track; 2], moment: Moment) -> [Foot; 2] {
    let Reading { score, settings } = reading;
    let feet = [0, 1].map(|i: usize| {
        let foot = tracks[i].at(moment.count);
        let [twist, heel] = score.feet[i].pivot_at(moment.count);
        Foot {
            twist: foot.twist + twist,
            heel: foot.heel + heel,
            ..foot
        }
    });
    if moment.answers {
        let [left, right] = feet.map(|foot| score.answered_foot(foot, settings));
        return [right, left];
    }
    feet
}

/// What heel, ball and knee do in their place.
fn raised_feet(score: &Score, moment: Moment) -> [Foot; 2] {
    let feet = score.feet.map(|foot| {
        let mut raised = Foot::default();
        for raise in foot.raises {
            let share = raise.share.at(moment.count);
            raised.lift += raise.lift * share;
            raised.heel += raise.heel * share;
            raised.knee_out += raise.knee_out * share;
        }
        raised
    });
    let [left, right] = feet;
    if moment.answers {
        return [right, left];
    }
    [left, right]
}

/// How far the hips are to the side, −1 right to +1 left.
fn sway_side(reading: Reading<'_>, moment: Moment, count: f32) -> f32 {
    let Reading { score, settings } = reading;
    match &score.hips {
        Hips::Sway { holds, .. } => {
            let phase = match settings.hip_lead {
                HipLead::OtherFoot => 0.0,
                HipLead::SteppingFoot => 1.0,
            };
            // In the left half the formula of the right half continues, so it is not mirrored.
            alternating(count + phase, holds, score.counts())
        }
        Hips::Lean { side, .. } => moment.side() * side.at(moment.count),
        Hips::Circle { rates, .. } => {
            trig::cos(TAU * turns(count, rates, score.counts())) * moment.side()
        }
        Hips::Eight { counts, .. } => trig::sin(TAU * count / counts),
    }
}

/// Once a count from side to side, held about some counts of a loop.
fn alternating(count: f32, holds: &[f32], loop_counts: f32) -> f32 {
    let Some(first) = holds.first() else {
        return trig::cos(PI * count);
    };
    // The phase advances by π a count and loses π in each hold.
    let count = count.rem_euclid(loop_counts);
    let mut lost = 0.0;
    for hold in holds.iter().chain([&(first + loop_counts)]) {
        lost += dip_area(count - hold);
    }
    trig::cos(PI * (count - lost))
}

/// Turns of a circle since count 0, whose rate changes at counts of a loop.
fn turns(count: f32, rates: &[(f32, f32)], loop_counts: f32) -> f32 {
    let (Some(&(_, first)), Some(&(_, last))) = (rates.first(), rates.last()) else {
        return 0.0;
    };
    if rates.len() == 1 {
        return first * count;
    }
    let bends = |count: f32| {
        let mut sum = (first - last) * hinge(count, RATE_CHANGE_COUNTS)
            + (first - last) * hinge(count - loop_counts, RATE_CHANGE_COUNTS);
        for pair in rates.windows(2) {
            let [(_, before), (from, after)] = [pair[0], pair[1]];
            sum += (after - before) * hinge(count - from, RATE_CHANGE_COUNTS);
        }
        sum
    };
    last * count + bends(count) - bends(0.0)
}

/// Lowering in the middle of a sway, where both legs share the weight.
fn bob(sway: f32) -> f32 {
    BOB * (1.0 - sway * sway)
}

fn swayed(settings: &MotionSettings, amplitude: &Sway, sway: f32) -> Pelvis {
    let up = match settings.hip_lift {
        HipLift::WeightedSide => 1.0,
        HipLift::FreeSide => -1.0,
    };
    // The eight behind the navel: back at both ends of the sway.
    let back = settings.figure_eight * sway * sway;
    let sway = sway * settings.sway;
    Pelvis {
        x: amplitude.shift * sway,
        z: -back,
        roll: up * amplitude.roll * sway,
        yaw: amplitude.yaw * sway,
        ..Pelvis::default()
    }
}

fn pelvis(reading: Reading<'_>, moment: Moment, count: f32) -> Pelvis {
    let Reading { score, settings } = reading;
    let side = sway_side(reading, moment, count);
    let mut pelvis = match &score.hips {
        Hips::Sway { amplitude, .. } | Hips::Lean { amplitude, .. } => Pelvis {
            drop: bob(side),
            ..swayed(settings, amplitude, side)
        },
        Hips::Circle { .. } => circling(reading, moment, count),
        Hips::Eight {
            amplitude,
            depth,
            counts,
        } => Pelvis {
            z: depth * settings.sway * trig::sin(2.0 * TAU * count / counts),
            ..swayed(settings, amplitude, side)
        },
    };
    for dip in score.dips {
        pelvis.drop += dip.drop * dip.share.at(moment.count);
    }
    pelvis.lean = moment.side() * score.lean.at(moment.count);
    pelvis.heading = moment.side() * score.heading.at(moment.count);
    [pelvis.travel, pelvis.ahead] = match score.travel {
        Travel::Even => even_travel(reading, count),
        Travel::RoundLeftBall => {
            let [x, z] = LEFT.resolve(settings);
            let ball = [x, z + BALL_AHEAD];
            let [x, z] = turned([-ball[0], -ball[1]], pelvis.heading);
            [ball[0] + x, ball[1] + z]
        }
        Travel::WithFeet => {
            let way = travel_with_feet(reading, moment.count);
            if moment.answers {
                score.answered(way, settings)
            } else {
                way
            }
        }
    };
    pelvis
}

/// ʻAmi: the circle is widest at the sides, where the hips are also highest.
fn circling(reading: Reading<'_>, moment: Moment, count: f32) -> Pelvis {
    let Reading { score, settings } = reading;
    let Hips::Circle {
        amplitude,
        depth,
        tilt,
        rates,
        size,
        front,
    } = &score.hips
    else {
        return Pelvis::default();
    };
    let (sin, cos) = trig::sin_cos(TAU * turns(count, rates, score.counts()));
    let sin = moment.side() * settings.ami_turn.sign() * sin;
    let size = size.at(count.rem_euclid(score.counts()));
    let side = size * moment.side() * cos;
    let mut pelvis = swayed(settings, amplitude, side);
    // To the front the hips reach 0.6 of what they reach to the back.
    pelvis.z = -depth * settings.sway * (size * (0.8 * sin + 0.2 * sin * sin));
    if let Some(front) = front {
        pelvis.z = soft_min(pelvis.z, *front, CUT);
    }
    pelvis.tilt = tilt * settings.sway * (size * sin);
    pelvis.roll = amplitude.roll * settings.sway * side;
    pelvis
}

/// Where the body is on its way to and fro [statures]: even walking with rounded turns.
///
/// At the turns it is between the standing feet, hence the straight parts aim beyond them by what
/// the rounding cuts off.
fn even_travel(reading: Reading<'_>, count: f32) -> [f32; 2] {
    let Reading { score, settings } = reading;
    let [x, z] = score.way.resolve(settings);
    let length = (x * x + z * z).sqrt();
    if length <= f32::MIN_POSITIVE {
        return [0.0, 0.0];
    }
    let half = score.half;
    let cut_off = 0.375 * TURN_COUNTS;
    let speed = length / (half - 2.0 * cut_off);
    let from_turn = |turn: f32| TURN_COUNTS * rounded_abs((count - turn) / TURN_COUNTS) - cut_off;
    let way = if count < 0.0 {
        // Lead-in: only the rounded turn itself, faded in within one count.
        speed * from_turn(0.0) * ramp(1.0 + count)
    } else if count < 0.5 * half {
        speed * from_turn(0.0)
    } else if count < 1.5 * half {
        length - speed * from_turn(half)
    } else {
        speed * from_turn(2.0 * half)
    };
    [x / length * way, z / length * way]
}

/// Where the body is behind its feet, within the written half [statures].
fn travel_with_feet(reading: Reading<'_>, count: f32) -> [f32; 2] {
    let Reading { score, settings } = reading;
    let [before, after] = FOLLOW_COUNTS;
    let mut way = [0.0, 0.0];
    for foot in &score.feet {
        let mut from = foot.start.spot.resolve(settings);
        way = [way[0] + 0.5 * from[0], way[1] + 0.5 * from[1]];
        for landing in foot.landings {
            let to = landing.stand.spot.resolve(settings);
            let begin = (landing.count - before).max(0.0);
            let end = (landing.count + after).min(score.half);
            let share = 0.5 * landing.carry * ramp_between(count, begin, end);
            way = [
                way[0] + share * (to[0] - from[0]),
                way[1] + share * (to[1] - from[1]),
            ];
            from = to;
        }
    }
    way
}
