//! What a dance step is, written down: where the feet land by count, the path of the hips, what
//! the arms do, and on whose word.
//!
//! A score is plain constant data, one for each step, in `repertoire/`. It is written for the right
//! side; the left side is its mirror image. Counts are local to the score: a foot that a teacher
//! sets down on "1" lands at local count 1, and count 0 is the moment before the phrase begins.
//! Lengths are in statures, angles in degrees, as in [`super::figure`].

use lole_language::Words;

use super::arms::ArmPlan;
use super::ease::{hump, ramp_between};
use super::settings::MotionSettings;

/// One dance step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Score {
    /// Name in documents and on the command line: ASCII, lower case.
    pub id: &'static str,
    /// Name as it is written in Hawaiian, with ʻokina and kahakō.
    pub name: &'static str,
    /// Name as it is said in Japanese, and what the name or the variant means in English.
    pub title: Words,
    /// What it is, in one sentence.
    pub about: Words,
    /// What a teacher says on each count of the written half, first count first.
    pub teaching: &'static [Words],
    /// What sources say of it.
    pub facts: &'static [Fact],
    /// What only a kumu can answer.
    pub questions: &'static [Words],
    /// Slowest and fastest tempo it is danced at [counts per minute]; estimates.
    pub tempo: [f32; 2],
    /// Counts of the part that is written out.
    pub half: f32,
    /// What follows it.
    pub answer: Answer,
    /// Local count of the teacher's "1": 1 where a foot lands on it, 0 in the first steps that
    /// were written, whose sway is at its side there.
    pub first_count: f32,
    /// Left and right foot.
    pub feet: [FootScore; 2],
    /// Path of the pelvis above the feet.
    pub hips: Hips,
    /// Path of the whole body over the floor.
    pub travel: Travel,
    /// Where the written half takes the body; the mirror stands in the middle of that way.
    pub way: Spot,
    /// Turn of the whole body to the left [°].
    pub heading: Curve,
    /// Lowering of the pelvis beyond the standing height.
    pub dips: &'static [Dip],
    /// Lean of the upper body to the left [°].
    pub lean: Curve,
    /// How much lower than the knees of the settings the whole step is danced [statures]: a
    /// stepping dancer sinks, or her far leg could not reach.
    pub sink: f32,
    /// Largest distance between the ankles while both bear weight.
    pub stride: Stride,
    /// What the arms do if nothing else is asked for.
    pub arms: ArmPlan,
    /// Local count by which the arms are later than written in their plan.
    pub arms_later: f32,
}

/// What follows the written half of a score.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Answer {
    /// The written half once more.
    Repeat,
    /// Its mirror image, back over the same floor.
    Mirror,
    /// Its mirror image, and backward what went forward.
    MirrorBackward,
}

/// A statement about a step and where it comes from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fact {
    /// The statement.
    pub what: Words,
    /// Where it comes from.
    pub basis: Basis,
}

/// What a statement rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Basis {
    /// Sources by their keys in [`super::sources::SOURCES`].
    Sources(&'static [&'static str]),
    /// Computed from other statements.
    Derived,
    /// An estimate, to be judged by a dancer.
    Estimated,
}

/// A statement with its sources.
pub(super) const fn fact(what: Words, sources: &'static [&'static str]) -> Fact {
    Fact {
        what,
        basis: Basis::Sources(sources),
    }
}

/// An estimate.
pub(super) const fn estimate(what: Words) -> Fact {
    Fact {
        what,
        basis: Basis::Estimated,
    }
}

/// A statement computed from others.
pub(super) const fn derived(what: Words) -> Fact {
    Fact {
        what,
        basis: Basis::Derived,
    }
}

/// A point of the floor, which depends on how wide the dancer stands and steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    /// Halves of the stance's width to the left.
    pub base: f32,
    /// Side steps of the settings to the left.
    pub step: f32,
    /// Statures to the left of that.
    pub side: f32,
    /// Halves of the stance's width to the front.
    pub base_ahead: f32,
    /// Side steps of the settings to the front.
    pub step_ahead: f32,
    /// Statures to the front of that.
    pub ahead: f32,
}

/// Where the left foot stands.
pub(super) const LEFT: Spot = spot(1.0, 0.0);
/// Where the right foot stands.
pub(super) const RIGHT: Spot = spot(-1.0, 0.0);
/// The middle between them.
pub(super) const MIDDLE: Spot = spot(0.0, 0.0);

/// A point `base` half stances and `step` side steps to the left.
pub(super) const fn spot(base: f32, step: f32) -> Spot {
    Spot {
        base,
        step,
        side: 0.0,
        base_ahead: 0.0,
        step_ahead: 0.0,
        ahead: 0.0,
    }
}

impl Spot {
    /// The point this much farther to the left and to the front [statures].
    pub(super) const fn by(self, side: f32, ahead: f32) -> Self {
        Self {
            side: self.side + side,
            ahead: self.ahead + ahead,
            ..self
        }
    }

    /// The point this many side steps farther to the front.
    pub(super) const fn steps_ahead(self, step_ahead: f32) -> Self {
        Self { step_ahead, ..self }
    }

    /// The point this many half stances farther to the front.
    pub(super) const fn bases_ahead(self, base_ahead: f32) -> Self {
        Self { base_ahead, ..self }
    }

    /// Left and front [statures].
    pub(super) fn resolve(&self, settings: &MotionSettings) -> [f32; 2] {
        let half = 0.5 * settings.stance_width;
        let step = settings.step_width;
        [
            self.base * half + self.step * step + self.side,
            self.base_ahead * half + self.step_ahead * step + self.ahead,
        ]
    }
}

/// A distance between two feet that stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stride {
    /// Side steps of the settings beyond the stance.
    pub step: f32,
    /// Statures beyond that.
    pub more: f32,
}

impl Stride {
    /// No wider than the stance.
    pub(super) const STANCE: Self = Self {
        step: 0.0,
        more: 0.0,
    };

    /// The distance [statures].
    pub(super) fn length(&self, settings: &MotionSettings) -> f32 {
        settings.stance_width + self.step * settings.step_width + self.more
    }
}

/// Height of the heel of a foot that turns on its ball [statures], 1.3 cm.
const PIVOT_HEEL: f32 = 0.008;
/// Counts by which the heel is up earlier and longer than the foot turns.
const PIVOT_MARGIN: f32 = 0.12;

/// One foot of a score.
#[derive(Debug, Clone, Copy)]
pub(super) struct FootScore {
    /// How it stands at count 0.
    pub start: Stand,
    /// Where it goes, in order.
    pub landings: &'static [Landing],
    /// What heel, ball and knee do besides.
    pub raises: &'static [Raise],
    /// Turn about the ball to the left [°], over the counts of the half; 0 or whole turns at its
    /// end. The heel rises with it.
    pub twist: Curve,
    /// Whether the heel rises while the hips are on the other side.
    pub heel_follows: bool,
}

/// The left and the right foot standing still.
pub(super) const STANDING: [FootScore; 2] = [standing(LEFT), standing(RIGHT)];

/// A foot that stands flat at `spot`.
pub(super) const fn standing(spot: Spot) -> FootScore {
    FootScore {
        start: Stand::flat(spot),
        landings: &[],
        raises: &[],
        twist: Curve::ZERO,
        heel_follows: false,
    }
}

impl FootScore {
    /// The foot, going from landing to landing.
    pub(super) const fn landing(self, landings: &'static [Landing]) -> Self {
        Self { landings, ..self }
    }

    /// The foot with its raises.
    pub(super) const fn raising(self, raises: &'static [Raise]) -> Self {
        Self { raises, ..self }
    }

    /// The foot, turning about its ball.
    pub(super) const fn twisting(self, changes: &'static [Change]) -> Self {
        let twist = Curve {
            start: 0.0,
            changes,
        };
        Self { twist, ..self }
    }

    /// Turn about the ball [°] at a count of the half, and how high the heel is for it [statures].
    pub(super) fn pivot_at(&self, count: f32) -> [f32; 2] {
        let mut heel = 0.0;
        for &Change(from, to, _) in self.twist.changes {
            let (from, to) = (from - PIVOT_MARGIN, to + PIVOT_MARGIN);
            heel += PIVOT_HEEL * hump((count - from) / (to - from));
        }
        [self.twist.at(count), heel]
    }

    /// The foot, starting from another stand.
    pub(super) const fn from(self, start: Stand) -> Self {
        Self { start, ..self }
    }
}

/// How a foot stands on the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stand {
    /// Where.
    pub spot: Spot,
    /// Where the body faces when it is set down, to the left [°].
    pub heading: f32,
    /// Height of the heel [statures]; 0 is flat.
    pub heel: f32,
    /// Turn-out beyond that of the settings [°].
    pub turn_out: f32,
}

/// Height of the heel in a tap [statures], 3 cm.
pub(super) const TAP_HEEL: f32 = 0.019;
/// Turn of a tapping foot, heel in [°].
const TAP_TURN: f32 = 10.0;

impl Stand {
    /// Flat.
    pub(super) const fn flat(spot: Spot) -> Self {
        Self {
            spot,
            heading: 0.0,
            heel: 0.0,
            turn_out: 0.0,
        }
    }

    /// On the ball without weight, the heel turned in.
    pub(super) const fn tap(spot: Spot) -> Self {
        Self {
            heel: TAP_HEEL,
            turn_out: TAP_TURN,
            ..Self::flat(spot)
        }
    }

    /// On the ball with the heel so high [statures].
    pub(super) const fn ball(spot: Spot, heel: f32) -> Self {
        Self {
            heel,
            ..Self::flat(spot)
        }
    }

    /// With the toes turned out by so much more [°].
    pub(super) const fn out(self, turn_out: f32) -> Self {
        Self { turn_out, ..self }
    }

    /// Set down while the body faces there, to the left [°].
    pub(super) const fn facing(self, heading: f32) -> Self {
        Self { heading, ..self }
    }
}

/// Part of a count a stepping foot is in the air. Published counts give no figure; at 0.4 the foot
/// would fly at 3 m/s in a full side step, twice as fast as it looks in hula, so it takes half.
pub(super) const FLIGHT_COUNTS: f32 = 0.5;
/// Height of a sliding step [statures], 1.6 cm.
pub(super) const SLIDE_LIFT: f32 = 0.010;

/// Where and when a foot lands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Landing {
    /// Local count of the landing.
    pub count: f32,
    /// Counts in the air before it.
    pub flight: f32,
    /// How it stands afterwards.
    pub stand: Stand,
    /// How high it flies [statures].
    pub lift: f32,
    /// Part of its way that the body follows: 1 shares the weight, 0 leaves it where it was.
    pub carry: f32,
    /// Whether it closes beside the other foot: it leaves earlier where the hips lead.
    pub closes: bool,
    /// How far the flight swings out, to the left and to the front [statures].
    pub swing: [f32; 2],
}

/// A sliding step that lands at `count`.
pub(super) const fn land(count: f32, stand: Stand) -> Landing {
    Landing {
        count,
        flight: FLIGHT_COUNTS,
        stand,
        lift: SLIDE_LIFT,
        carry: 1.0,
        closes: false,
        swing: [0.0, 0.0],
    }
}

impl Landing {
    /// The landing, closing beside the other foot.
    pub(super) const fn closing(self) -> Self {
        Self {
            closes: true,
            ..self
        }
    }

    /// The landing without weight.
    pub(super) const fn free(self) -> Self {
        Self { carry: 0.0, ..self }
    }

    /// The landing after so many counts in the air.
    pub(super) const fn flying(self, flight: f32) -> Self {
        Self { flight, ..self }
    }

    /// The landing after a flight so high [statures].
    pub(super) const fn lifted(self, lift: f32) -> Self {
        Self { lift, ..self }
    }

    /// The landing, the foot swinging out so far on its way, to the left and to the front [statures].
    pub(super) const fn swinging(self, swing: [f32; 2]) -> Self {
        Self { swing, ..self }
    }
}

/// A movement of a foot in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Raise {
    /// Height of the whole foot [statures].
    pub lift: f32,
    /// Height of the heel above the ball [statures].
    pub heel: f32,
    /// Turn-out of the knee beyond the toes [°].
    pub knee_out: f32,
    /// How much of it there is, over the counts of the half.
    pub share: Curve,
}

/// A lowering of the pelvis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dip {
    /// How deep [statures].
    pub drop: f32,
    /// How much of it there is, over the counts of the half.
    pub share: Curve,
}

/// A value that changes smoothly between counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Curve {
    /// Value at count 0.
    pub start: f32,
    /// How it changes from there.
    pub changes: &'static [Change],
}

/// From a count to a count, by an amount: a minimum-jerk ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Change(pub f32, pub f32, pub f32);

impl Curve {
    /// Always 0.
    pub(super) const ZERO: Self = Self {
        start: 0.0,
        changes: &[],
    };

    /// The curve that starts at 0.
    pub(super) const fn from_zero(changes: &'static [Change]) -> Self {
        Self {
            start: 0.0,
            changes,
        }
    }

    /// The value at a count.
    pub(super) fn at(&self, count: f32) -> f32 {
        let mut value = self.start;
        for &Change(from, to, by) in self.changes {
            value += by * ramp_between(count, from, to);
        }
        value
    }
}

/// Amplitudes of a sway: shift to the side [statures], roll [°], yaw [°].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sway {
    /// To each side [statures].
    pub shift: f32,
    /// Side of the sway up [°].
    pub roll: f32,
    /// Side of the sway forward [°].
    pub yaw: f32,
}

/// Path of the pelvis above the feet.
#[derive(Debug, Clone, Copy)]
pub(super) enum Hips {
    /// From side to side, once a count.
    Sway {
        /// How far.
        amplitude: Sway,
        /// Local counts in the middle of a hold, within the whole loop.
        holds: &'static [f32],
    },
    /// To the side that a curve says, −1 right to +1 left, over the counts of the half.
    Lean {
        /// How far.
        amplitude: Sway,
        /// Where.
        side: Curve,
    },
    /// Round and round.
    Circle {
        /// How far to the sides.
        amplitude: Sway,
        /// How far to the back [statures]; 0.6 of it to the front.
        depth: f32,
        /// Tail out at the back [°].
        tilt: f32,
        /// Turns a count from each local count on, within the whole loop.
        rates: &'static [(f32, f32)],
        /// Size of the circle over the whole loop.
        size: Curve,
        /// Most they come to the front [statures].
        front: Option<f32>,
    },
    /// A figure of eight lying on its side: one hip forward, out, back, home; then the other.
    Eight {
        /// How far.
        amplitude: Sway,
        /// How far to front and back [statures].
        depth: f32,
        /// Counts of a whole eight.
        counts: f32,
    },
}

/// Path of the whole body over the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Travel {
    /// After the feet, as far as they carry weight.
    WithFeet,
    /// To and fro along the way of the halves at even speed, with rounded turns.
    Even,
    /// Round the ball of the left foot as the body turns.
    RoundLeftBall,
}

/// A score that stands still, to write others from.
pub(super) const STILL: Score = Score {
    id: "",
    name: "",
    title: Words {
        japanese: "",
        english: "",
    },
    about: Words {
        japanese: "",
        english: "",
    },
    teaching: &[],
    facts: &[],
    questions: &[],
    tempo: [60.0, 132.0],
    half: 4.0,
    answer: Answer::Mirror,
    first_count: 1.0,
    feet: STANDING,
    hips: Hips::Lean {
        amplitude: Sway {
            shift: 0.0,
            roll: 0.0,
            yaw: 0.0,
        },
        side: Curve::ZERO,
    },
    travel: Travel::WithFeet,
    way: MIDDLE,
    heading: Curve::ZERO,
    dips: &[],
    lean: Curve::ZERO,
    sink: 0.0,
    stride: Stride::STANCE,
    arms: ArmPlan::Open,
    arms_later: 0.0,
};

impl Score {
    /// Counts of the whole loop.
    pub(super) fn counts(&self) -> f32 {
        match self.answer {
            Answer::Repeat => self.half,
            Answer::Mirror | Answer::MirrorBackward => 2.0 * self.half,
        }
    }
}
