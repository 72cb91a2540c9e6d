//! The four steps as figures over counts.
//!
//! Count 0 of this file is count "1" of a teacher. Sway runs from −1 (hips right) to +1 (left).

use std::f32::consts::PI;

use lole_geom::trig;

use super::arms::{self, ArmPlan};
use super::ease::{dip_area, hump, mix, ramp, ramp_between, rounded_abs};
use super::figure::{Figure, Foot, Pelvis};
use super::settings::{AmiTurn, DanceStep, HipLead, HipLift, MotionSettings};

/// Counts of the lead-in from the ready stance to the first count of the loop.
pub(super) const LEAD_IN_COUNTS: f32 = 2.0;

/// Part of a count a stepping foot is in the air. Published counts give no figure; at 0.4 the foot
/// would fly at 3 m/s in a full side step, twice as fast as it looks in hula, so it takes half.
const FLIGHT_COUNTS: f32 = 0.5;
/// Counts on either side of kāholo's turns within which the walk is rounded.
const TURN_COUNTS: f32 = 0.7;
/// Height of a sliding step [statures], 1.6 cm.
const SLIDE_LIFT: f32 = 0.010;
/// Height of the heel in kāholo's closing tap [statures], 3 cm.
const TAP_HEEL: f32 = 0.019;
/// Turn of the tapping foot, heel in [°].
const TAP_TURN: f32 = 10.0;
/// Most the head sinks in the middle of a sway [statures], 0.5 cm.
const BOB: f32 = 0.003;

/// Amplitudes of a step: shift to the side [statures], roll [°], yaw [°].
struct Sway {
    shift: f32,
    roll: f32,
    yaw: f32,
}

const KAO: Sway = Sway {
    shift: 0.045,
    roll: 9.0,
    yaw: 2.0,
};
const KAHOLO: Sway = Sway {
    shift: 0.035,
    roll: 6.0,
    yaw: 1.5,
};
const AMI: Sway = Sway {
    shift: 0.045,
    roll: 6.0,
    yaw: 0.0,
};
const UWEHE: Sway = Sway {
    shift: 0.032,
    roll: 6.0,
    yaw: 0.0,
};

/// How much lower than the knees of the settings a step is danced [statures]: a stepping dancer
/// sinks, or her far leg could not reach.
pub(super) fn sink(step: DanceStep) -> f32 {
    match step {
        DanceStep::Kaholo => 0.012,
        DanceStep::Ami => 0.002,
        DanceStep::Kao | DanceStep::Uwehe => 0.0,
    }
}

/// Largest distance between the ankles in the step [statures].
pub(super) fn widest_feet(settings: &MotionSettings) -> f32 {
    match settings.dance_step {
        DanceStep::Kaholo => settings.stance_width + settings.step_width,
        DanceStep::Kao | DanceStep::Ami | DanceStep::Uwehe => settings.stance_width,
    }
}

/// The ready stance: standing even, arms where the step begins.
pub(super) fn stance(settings: &MotionSettings) -> Figure {
    let plan = ArmPlan::of(settings);
    Figure {
        feet: [standing_foot(settings, 1.0), standing_foot(settings, -1.0)],
        arms: arms::ready(plan, loop_counts(settings)),
        gaze: arms::ready_gaze(plan),
        ..Figure::default()
    }
}

/// Figure at `count` of the repeated step; counts from −[`LEAD_IN_COUNTS`] to 0 are the lead-in.
pub(super) fn figure(settings: &MotionSettings, count: f32) -> Figure {
    if count >= 0.0 {
        return looped(settings, count.rem_euclid(loop_counts(settings)));
    }
    let weight = ramp_between(count, -LEAD_IN_COUNTS, 0.0);
    let mut figure = stance(settings).mixed(&looped(settings, count), weight);
    if settings.dance_step == DanceStep::Kaholo {
        figure.feet = kaholo_first_feet(settings, count);
    }
    figure
}

fn loop_counts(settings: &MotionSettings) -> f32 {
    settings.dance_step.counts() as f32
}

fn looped(settings: &MotionSettings, count: f32) -> Figure {
    let mut figure = match settings.dance_step {
        DanceStep::Kao => kao(settings, count),
        DanceStep::Kaholo => kaholo(settings, count),
        DanceStep::Ami => ami(settings, count),
        DanceStep::Uwehe => uwehe(settings, count),
    };
    (figure.arms, figure.gaze) =
        arms::of_count(ArmPlan::of(settings), loop_counts(settings), count);
    figure
}

/// A foot flat at its place in the stance; `side` is +1 left, −1 right.
fn standing_foot(settings: &MotionSettings, side: f32) -> Foot {
    Foot {
        x: side * 0.5 * settings.stance_width,
        turn_out: settings.toe_out_degrees,
        ..Foot::default()
    }
}

fn swayed(settings: &MotionSettings, amplitude: &Sway, sway: f32) -> Pelvis {
    let up = match settings.hip_lift {
        HipLift::WeightedSide => 1.0,
        HipLift::FreeSide => -1.0,
    };
    let sway = sway * settings.sway;
    Pelvis {
        x: amplitude.shift * sway,
        roll: up * amplitude.roll * sway,
        yaw: amplitude.yaw * sway,
        ..Pelvis::default()
    }
}

/// Lowering in the middle of a sway, where both legs share the weight.
fn bob(sway: f32) -> f32 {
    BOB * (1.0 - sway * sway)
}

/// Height of the heels [left, right] when the weight is at `sway`: the free one is up.
fn free_heels(settings: &MotionSettings, sway: f32) -> [f32; 2] {
    [-sway, sway].map(|free| settings.heel_lift * ramp((free - 0.4) / 0.6))
}

fn kao(settings: &MotionSettings, count: f32) -> Figure {
    let phase = match settings.hip_lead {
        HipLead::OtherFoot => 0.0,
        HipLead::SteppingFoot => 1.0,
    };
    let sway = trig::cos(PI * (count + phase));
    let mut figure = stance(settings);
    figure.pelvis = swayed(settings, &KAO, sway);
    figure.pelvis.drop = bob(sway);
    let heels = free_heels(settings, sway);
    for (foot, heel) in figure.feet.iter_mut().zip(heels) {
        foot.heel = heel;
    }
    figure
}

fn ami(settings: &MotionSettings, count: f32) -> Figure {
    let (sin, cos) = trig::sin_cos(PI * count);
    let sin = match settings.ami_turn {
        AmiTurn::Akau => sin,
        AmiTurn::Hema => -sin,
    };
    let mut figure = stance(settings);
    figure.pelvis = swayed(settings, &AMI, cos);
    // To the front the hips reach 0.6 of what they reach to the back.
    figure.pelvis.z = -0.030 * settings.sway * (0.8 * sin + 0.2 * sin * sin);
    figure.pelvis.tilt = 5.0 * settings.sway * sin;
    // The circle is widest at the sides, where the hips are also highest.
    figure.pelvis.roll = AMI.roll * settings.sway * cos;
    figure
}

/// Kāholo: the right half (counts 0 to 4) is written out, the left half is its mirror image.
fn kaholo(settings: &MotionSettings, count: f32) -> Figure {
    let mirror = -settings.step_width;
    let left_half = count >= 4.0;
    let count_of_half = if left_half { count - 4.0 } else { count };
    let mut figure = stance(settings);
    figure.feet = kaholo_right_feet(settings, count_of_half);
    let phase = match settings.hip_lead {
        HipLead::OtherFoot => 0.0,
        HipLead::SteppingFoot => 1.0,
    };
    // In the left half the formula of the right half continues, so it is not mirrored.
    let sway = kaholo_sway(count + phase);
    if left_half {
        figure = figure.mirrored(mirror);
    }
    figure.pelvis = swayed(settings, &KAHOLO, sway);
    figure.pelvis.travel = kaholo_travel(settings, count);
    figure.pelvis.drop = bob(sway);
    figure
}

/// Sway of kāholo: once a count from side to side, held at the taps (counts 0 and 4).
fn kaholo_sway(count: f32) -> f32 {
    // The phase advances by π a count and loses π in each hold, whose middle is at 0.5 and 4.5.
    let count = count.rem_euclid(8.0);
    let lost = dip_area(count - 0.5) + dip_area(count - 4.5) + dip_area(count - 8.5);
    trig::cos(PI * (count - lost))
}

/// Where the pelvis is on its way right and back [statures]: even walking with rounded turns.
///
/// At the turns (counts 0 and 4) it is between the standing feet, hence the straight parts aim
/// beyond them by what the rounding cuts off.
fn kaholo_travel(settings: &MotionSettings, count: f32) -> f32 {
    let cut_off = 0.375 * TURN_COUNTS;
    let speed = 2.0 * settings.step_width / (4.0 - 2.0 * cut_off);
    let from_turn = |turn: f32| TURN_COUNTS * rounded_abs((count - turn) / TURN_COUNTS) - cut_off;
    if count < 0.0 {
        // Lead-in: only the rounded turn itself, faded in within one count.
        return -speed * from_turn(0.0) * ramp(1.0 + count);
    }
    if count < 2.0 {
        -speed * from_turn(0.0)
    } else if count < 6.0 {
        -2.0 * settings.step_width + speed * from_turn(4.0)
    } else {
        -speed * from_turn(8.0)
    }
}

/// Feet of kāholo to the right, from the tap of the right foot (count 0) to that of the left (4).
fn kaholo_right_feet(settings: &MotionSettings, count: f32) -> [Foot; 2] {
    let half = 0.5 * settings.stance_width;
    let step = settings.step_width;
    let flat = Foot {
        turn_out: settings.toe_out_degrees,
        ..Foot::default()
    };
    let tapping = Foot {
        heel: TAP_HEEL,
        turn_out: settings.toe_out_degrees + TAP_TURN,
        ..flat
    };
    // Where the hips are early over the stepping foot, the other foot follows earlier.
    let closing = match settings.hip_lead {
        HipLead::OtherFoot => FLIGHT_COUNTS,
        HipLead::SteppingFoot => 1.5 * FLIGHT_COUNTS,
    };
    let step_out = |landing: f32, x: f32| Landing {
        count: landing,
        flight: FLIGHT_COUNTS,
        place: Foot { x, ..flat },
    };
    let close = |landing: f32, place: Foot| Landing {
        count: landing,
        flight: closing,
        place,
    };
    let right = [
        step_out(1.0, -half - step),
        step_out(3.0, -half - 2.0 * step),
    ];
    let left = [
        close(
            2.0,
            Foot {
                x: half - step,
                ..flat
            },
        ),
        close(
            4.0,
            Foot {
                x: -2.0 * step,
                ..tapping
            },
        ),
    ];
    [
        stepped(Foot { x: half, ..flat }, &left, count),
        stepped(tapping, &right, count),
    ]
}

/// Feet of kāholo's lead-in: the right foot goes from the stance to the first tap.
fn kaholo_first_feet(settings: &MotionSettings, count: f32) -> [Foot; 2] {
    let place = kaholo_right_feet(settings, 0.0)[1];
    let tap = Landing {
        count: 0.0,
        flight: FLIGHT_COUNTS,
        place,
    };
    [
        standing_foot(settings, 1.0),
        stepped(standing_foot(settings, -1.0), &[tap], count),
    ]
}

/// Where and when a foot lands.
struct Landing {
    /// Count of the landing.
    count: f32,
    /// Counts in the air before it.
    flight: f32,
    /// How it stands afterwards.
    place: Foot,
}

/// A foot that starts at `foot` and goes from landing to landing.
fn stepped(mut foot: Foot, landings: &[Landing], count: f32) -> Foot {
    for landing in landings {
        let flight = (count - landing.count) / landing.flight + 1.0;
        if flight <= 0.0 {
            break;
        }
        let way = ramp(flight);
        let place = landing.place;
        foot = Foot {
            x: mix(foot.x, place.x, way),
            lift: SLIDE_LIFT * hump(flight),
            // The heel leaves first and the ball lands first.
            heel: mix(foot.heel, place.heel, way) + 0.6 * TAP_HEEL * hump(flight),
            turn_out: mix(foot.turn_out, place.turn_out, way),
            knee_out: 0.0,
        };
    }
    foot
}

/// ʻUwehe: the right half (counts 0 to 2) is written out, the left half is its mirror image.
fn uwehe(settings: &MotionSettings, count: f32) -> Figure {
    let count = count.rem_euclid(4.0);
    if count >= 2.0 {
        return uwehe_right(settings, count - 2.0).mirrored(0.0);
    }
    uwehe_right(settings, count)
}

fn uwehe_right(settings: &MotionSettings, count: f32) -> Figure {
    let sway = 1.0 - ramp_between(count, 0.1, 0.8) - ramp_between(count, 1.2, 2.0);
    // Both heels snap up on the second count and are down before the next lift.
    let snap = ramp_between(count, 0.72, 1.0) * (1.0 - ramp_between(count, 1.04, 1.36));
    let mut figure = stance(settings);
    figure.pelvis = swayed(settings, &UWEHE, sway);
    figure.pelvis.drop = bob(sway) + 0.0015 * snap;
    for foot in &mut figure.feet {
        foot.heel = 0.032 * snap;
        foot.knee_out = 30.0 * snap;
    }
    // The right foot is up on the first count; the left one rises toward the third.
    let lifted = 1.0 - ramp_between(count, 0.04, 0.45);
    let rising = ramp_between(count, 1.55, 2.0);
    for (foot, lifted) in figure.feet.iter_mut().zip([rising, lifted]) {
        foot.lift = 0.030 * lifted;
        foot.heel += 0.022 * lifted;
    }
    figure
}
