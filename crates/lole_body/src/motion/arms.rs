//! What the arms do in each step, as directions over counts.
//!
//! Hands keep to the front or well to the side, above the waist: below it is the skirt.

use std::f32::consts::PI;

use lole_geom::trig;

use super::ease::ramp_between;
use super::figure::Arm;
use super::settings::{ArmStyle, DanceStep, MotionSettings};

/// The movement of the arms that settings ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ArmPlan {
    /// Kāholo: one arm out on the side of travel, the other hand before the chest.
    LeadAndChest,
    /// ʻUwehe: the arm of the lifted foot high, the other low in front.
    HighAndLow,
    /// ʻAmi: both arms rounded in front.
    Rounded,
    /// Both arms open to the sides.
    Open,
    /// Both hands on the waist.
    HandsOnHips,
}

impl ArmPlan {
    /// The plan that belongs to the settings.
    pub(super) fn of(settings: &MotionSettings) -> Self {
        match (settings.arms, settings.dance_step) {
            (ArmStyle::HandsOnHips, _) => Self::HandsOnHips,
            (ArmStyle::Open, _) | (ArmStyle::OfStep, DanceStep::Kao) => Self::Open,
            (ArmStyle::OfStep, DanceStep::Kaholo) => Self::LeadAndChest,
            (ArmStyle::OfStep, DanceStep::Ami) => Self::Rounded,
            (ArmStyle::OfStep, DanceStep::Uwehe) => Self::HighAndLow,
        }
    }
}

/// Arm out to the side at shoulder height, elbow soft, palm down.
const OUT: Arm = Arm {
    azimuth: 8.0,
    elevation: -4.0,
    fore_azimuth: 24.0,
    fore_elevation: 2.0,
    palm: 0.0,
    wrist: 0.0,
    fingers: 0.0,
};
/// Hand at the center of the chest, elbow at chest height, palm down.
const AT_CHEST: Arm = Arm {
    azimuth: 38.0,
    elevation: -20.0,
    fore_azimuth: 168.0,
    fore_elevation: 3.0,
    palm: 0.0,
    wrist: 0.0,
    fingers: 4.0,
};
/// Arm open to the side, below shoulder height.
const OPEN: Arm = Arm {
    azimuth: 16.0,
    elevation: -17.0,
    fore_azimuth: 36.0,
    fore_elevation: -6.0,
    palm: 12.0,
    wrist: 0.0,
    fingers: 0.0,
};
/// Arm rounded in front at the height of the lower ribs.
const ROUNDED: Arm = Arm {
    azimuth: 22.0,
    elevation: -30.0,
    fore_azimuth: 112.0,
    fore_elevation: -6.0,
    palm: 14.0,
    wrist: -4.0,
    fingers: 2.0,
};
/// Arm raised in the "U" above.
const HIGH: Arm = Arm {
    azimuth: 28.0,
    elevation: 28.0,
    fore_azimuth: 48.0,
    fore_elevation: 58.0,
    palm: 60.0,
    wrist: -8.0,
    fingers: 0.0,
};
/// Arm low in front, well above the skirt.
const LOW: Arm = Arm {
    azimuth: 34.0,
    elevation: -34.0,
    fore_azimuth: 70.0,
    fore_elevation: -8.0,
    palm: 30.0,
    wrist: -6.0,
    fingers: 0.0,
};
/// Hand on the waist above the band.
const ON_WAIST: Arm = Arm {
    azimuth: 2.0,
    elevation: -40.0,
    fore_azimuth: 190.0,
    fore_elevation: -32.0,
    palm: 72.0,
    wrist: -48.0,
    fingers: 8.0,
};

/// Counts by which the fingers follow the wrist: 60 ms at 80 beats per minute.
const FINGER_LAG_COUNTS: f32 = 0.08;
/// Turn of the head toward the far hand [°].
const GAZE: f32 = 18.0;

/// Arms of the ready stance [left, right]: where the loop begins, without its waves. A loop has
/// `loop_counts`.
pub(super) fn ready(plan: ArmPlan, loop_counts: f32) -> [Arm; 2] {
    [shape(plan, 0.0), shape(plan, 0.5 * loop_counts)]
}

/// Turn of the head in the ready stance [°].
pub(super) fn ready_gaze(plan: ArmPlan) -> f32 {
    match plan {
        ArmPlan::LeadAndChest => GAZE,
        ArmPlan::HighAndLow => -GAZE,
        ArmPlan::Rounded | ArmPlan::Open | ArmPlan::HandsOnHips => 0.0,
    }
}

/// Arms [left, right] and turn of the head [°] at `count` of a loop of `loop_counts`.
pub(super) fn of_count(plan: ArmPlan, loop_counts: f32, count: f32) -> ([Arm; 2], f32) {
    // The right arm does what the left arm does half a loop later.
    let arms = [waved(plan, count), waved(plan, count + 0.5 * loop_counts)];
    (arms, gaze(plan, loop_counts, count))
}

fn gaze(plan: ArmPlan, loop_counts: f32, count: f32) -> f32 {
    match plan {
        ArmPlan::LeadAndChest => GAZE * (2.0 * left_out(count - 0.05) - 1.0),
        ArmPlan::HighAndLow => GAZE * (2.0 * left_high(count) - 1.0),
        ArmPlan::Open => 6.0 * trig::cos(2.0 * PI * count / loop_counts),
        ArmPlan::Rounded | ArmPlan::HandsOnHips => 0.0,
    }
}

/// How far the left arm of kāholo is out: 1 while travelling left (counts 5 to 8), 0 while
/// travelling right; it changes sides from 4 to 5.
fn left_out(count: f32) -> f32 {
    let count = count.rem_euclid(8.0);
    ramp_between(count, 4.0, 5.1) + 1.0 - ramp_between(count, 0.0, 1.1)
}

/// How far the left arm of ʻuwehe is high: 1 about the lift of the left foot (count 2).
fn left_high(count: f32) -> f32 {
    let count = count.rem_euclid(4.0);
    ramp_between(count, 1.1, 2.0) - ramp_between(count, 3.1, 4.0)
}

/// Left arm without its waves. The upper arm leads, the forearm follows.
fn shape(plan: ArmPlan, count: f32) -> Arm {
    let (from, to, way): (_, _, fn(f32) -> f32) = match plan {
        ArmPlan::LeadAndChest => (AT_CHEST, OUT, left_out),
        ArmPlan::HighAndLow => (LOW, HIGH, left_high),
        ArmPlan::Rounded => (ROUNDED, ROUNDED, still),
        ArmPlan::Open => (OPEN, OPEN, still),
        ArmPlan::HandsOnHips => (ON_WAIST, ON_WAIST, still),
    };
    let leading = from.mixed(&to, way(count));
    let following = from.mixed(&to, way(count - FINGER_LAG_COUNTS));
    Arm {
        azimuth: leading.azimuth,
        elevation: leading.elevation,
        ..following
    }
}

fn still(_count: f32) -> f32 {
    0.0
}

/// Left arm with its wave, one in two counts: while the forearm rises the hand hangs behind, while
/// it sinks the hand is drawn back, and the fingers come a little later.
fn waved(plan: ArmPlan, count: f32) -> Arm {
    let arm = shape(plan, count);
    let (wrist, elbow) = match plan {
        ArmPlan::LeadAndChest => {
            let out = left_out(count);
            (9.0 + 8.0 * out, 1.5 + 3.0 * out)
        }
        ArmPlan::Open => (14.0, 4.0),
        ArmPlan::Rounded => (12.0, 3.0),
        ArmPlan::HighAndLow => (6.0, 2.0),
        ArmPlan::HandsOnHips => return arm,
    };
    let (sin, cos) = trig::sin_cos(PI * count);
    let later = trig::cos(PI * (count - FINGER_LAG_COUNTS));
    Arm {
        elevation: arm.elevation + 0.4 * elbow * sin,
        fore_elevation: arm.fore_elevation + elbow * sin,
        wrist: arm.wrist - 2.5 + wrist * cos,
        fingers: arm.fingers + 0.4 * wrist * later,
        ..arm
    }
}
