//! What the arms do in each step, as directions over counts.
//!
//! Hands keep to the front or well to the side, above the waist: below it is the skirt.

use std::f32::consts::PI;

use lole_geom::trig;

use super::ease::{mix, ramp, ramp_between};
use super::figure::Arm;
use super::settings::{ArmManner, ArmStyle, Hands, MotionSettings};

/// A movement of the arms.
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
    /// Makaʻukau: the left arm out, the right hand before the chest, throughout.
    Ready,
    /// Both arms up in a "U".
    OpenUp,
    /// Both arms low in front, palms up.
    LowFront,
    /// ʻAui: the arm of the pointing foot low toward the toes, the other high behind.
    ToesAndBehind,
}

impl ArmPlan {
    /// The plan of a style, for a step that would have `of_step`.
    pub(super) fn of(style: ArmStyle, of_step: Self) -> Self {
        match style {
            ArmStyle::OfStep => of_step,
            ArmStyle::Open => Self::Open,
            ArmStyle::HandsOnHips => Self::HandsOnHips,
            ArmStyle::Ready => Self::Ready,
            ArmStyle::OpenUp => Self::OpenUp,
            ArmStyle::LowFront => Self::LowFront,
            ArmStyle::Rounded => Self::Rounded,
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
    on_waist: 0.0,
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
    on_waist: 0.0,
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
    on_waist: 0.0,
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
    on_waist: 0.0,
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
    on_waist: 0.0,
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
    on_waist: 0.0,
};
/// Hand on the waist above the band; the rig finds the waist, and these are the angles on the way
/// there.
const ON_WAIST: Arm = Arm {
    azimuth: 2.0,
    elevation: -40.0,
    fore_azimuth: 190.0,
    fore_elevation: -32.0,
    palm: 72.0,
    wrist: -48.0,
    fingers: 8.0,
    on_waist: 1.0,
};

/// Arm raised well above the shoulder, elbow soft, palm inward: one half of the "U".
const UP: Arm = Arm {
    azimuth: 34.0,
    elevation: 44.0,
    fore_azimuth: 52.0,
    fore_elevation: 68.0,
    palm: 78.0,
    wrist: -8.0,
    fingers: 0.0,
    on_waist: 0.0,
};
/// Arm low in front, palm up, as if offering.
const OFFERING: Arm = Arm {
    azimuth: 52.0,
    elevation: -42.0,
    fore_azimuth: 84.0,
    fore_elevation: -4.0,
    palm: 150.0,
    wrist: 6.0,
    fingers: 4.0,
    on_waist: 0.0,
};
/// Arm stretched down toward the pointing toes, well clear of the skirt.
const TO_TOES: Arm = Arm {
    azimuth: 40.0,
    elevation: -24.0,
    fore_azimuth: 52.0,
    fore_elevation: -15.0,
    palm: 8.0,
    wrist: -4.0,
    fingers: 0.0,
    on_waist: 0.0,
};
/// Arm high behind the side.
const HIGH_BEHIND: Arm = Arm {
    azimuth: -4.0,
    elevation: 24.0,
    fore_azimuth: 10.0,
    fore_elevation: 46.0,
    palm: 30.0,
    wrist: -6.0,
    fingers: 0.0,
    on_waist: 0.0,
};

/// Counts by which the fingers follow the wrist: 60 ms at 80 beats per minute.
const FINGER_LAG_COUNTS: f32 = 0.08;
/// Turn of the head toward the far hand [°].
const GAZE: f32 = 18.0;
/// Most the head turns and bows after a hand [°].
const MOST_GAZE: [f32; 2] = [32.0, 22.0];
/// Part of a hand's direction that the head takes; the eyes do the rest.
const GAZE_OF_HEAD: f32 = 0.45;
/// By how many arm's lengths one hand must be farther out than the other to have all of the gaze.
const FAR_HAND: f32 = 0.7;
/// Part of the bend of the elbows that kahiko keeps.
const CRISP_BEND: f32 = 0.45;
/// Part of the wave of the wrists that kahiko keeps.
const CRISP_WAVE: f32 = 0.15;
/// Curl of the fingers of a fist [° per joint].
const FIST: f32 = 72.0;
/// Bend of the wrist that makes up for stretched hands of kahiko [° per joint].
const FLAT: f32 = -5.0;

/// Arms [left, right], turn and bow of the head [°].
pub(super) type ArmsAndGaze = ([Arm; 2], f32, f32);

/// Arms of the ready stance: where the loop begins, without its waves. A loop has `loop_counts`.
pub(super) fn ready(plan: ArmPlan, loop_counts: f32, settings: &MotionSettings) -> ArmsAndGaze {
    let right = shape(plan, loop_counts, opposite(plan, 0.0, loop_counts));
    let arms = [shape(plan, loop_counts, 0.0), right];
    let arms = sides_of(plan, arms).map(|arm| mannered(arm, settings));
    let gaze = match plan {
        ArmPlan::LeadAndChest => (GAZE, 0.0),
        ArmPlan::HighAndLow => (-GAZE, 0.0),
        ArmPlan::Rounded | ArmPlan::Open | ArmPlan::HandsOnHips => (0.0, 0.0),
        _ => after_hands(arms),
    };
    (arms, gaze.0, gaze.1)
}

/// Arms, turn and bow of the head at `count` of a loop of `loop_counts`.
pub(super) fn of_count(
    plan: ArmPlan,
    loop_counts: f32,
    count: f32,
    settings: &MotionSettings,
) -> ArmsAndGaze {
    let waved = |count: f32| match settings.arm_manner {
        ArmManner::Curved => waved(plan, loop_counts, count, 1.0),
        ArmManner::Crisp => waved(plan, loop_counts, arriving(count), CRISP_WAVE),
    };
    // The right arm does what the left arm does half a loop later.
    let arms = [waved(count), waved(opposite(plan, count, loop_counts))];
    let arms = sides_of(plan, arms).map(|arm| mannered(arm, settings));
    let (gaze, nod) = gaze(plan, loop_counts, count, arms);
    (arms, gaze, nod)
}

/// Where the right arm is in the plan of the left one.
fn opposite(plan: ArmPlan, count: f32, loop_counts: f32) -> f32 {
    match plan {
        ArmPlan::OpenUp | ArmPlan::LowFront | ArmPlan::Ready => count,
        _ => count + 0.5 * loop_counts,
    }
}

/// Only the ready arms differ without a plan that makes them differ.
fn sides_of(plan: ArmPlan, [left, right]: [Arm; 2]) -> [Arm; 2] {
    match plan {
        ArmPlan::Ready => [
            left,
            Arm {
                wrist: AT_CHEST.wrist + 0.5 * (right.wrist - OUT.wrist),
                fingers: AT_CHEST.fingers + 0.5 * (right.fingers - OUT.fingers),
                ..AT_CHEST
            },
        ],
        _ => [left, right],
    }
}

/// A count whose movements arrive on the counts and stop there.
fn arriving(count: f32) -> f32 {
    let whole = count.floor();
    whole + ramp(2.0 * (count - whole) - 1.0)
}

/// The arm with the elbow and the hand of the settings' manner.
fn mannered(arm: Arm, settings: &MotionSettings) -> Arm {
    let arm = roomy(arm, settings.chest_room_degrees);
    let arm = match settings.arm_manner {
        ArmManner::Curved => arm,
        ArmManner::Crisp => straighter(arm),
    };
    match settings.hands {
        Hands::Soft => arm,
        Hands::Flat => Arm {
            fingers: FLAT,
            ..arm
        },
        Hands::Fist => Arm {
            fingers: FIST,
            wrist: 0.3 * arm.wrist,
            ..arm
        },
    }
}

/// A forearm that lies before the chest, its elbow opened by as much as `degrees`. Hands on the waist
/// stay there.
fn roomy(arm: Arm, degrees: f32) -> Arm {
    let is_across = ramp_between(arm.fore_azimuth, 90.0, 160.0);
    let is_level = ramp_between(arm.fore_elevation, -28.0, -12.0);
    Arm {
        fore_azimuth: arm.fore_azimuth - degrees * is_across * is_level,
        ..arm
    }
}

/// A forearm more in line with the upper arm. Elbows that are bent by more than a right angle, as
/// with a hand at the chest or on the waist, stay as they are.
fn straighter(arm: Arm) -> Arm {
    let apart = (arm.fore_azimuth - arm.azimuth).abs();
    let keep = mix(CRISP_BEND, 1.0, ramp_between(apart, 60.0, 110.0));
    Arm {
        fore_azimuth: mix(arm.azimuth, arm.fore_azimuth, keep),
        fore_elevation: mix(arm.elevation, arm.fore_elevation, keep),
        ..arm
    }
}

fn gaze(plan: ArmPlan, loop_counts: f32, count: f32, arms: [Arm; 2]) -> (f32, f32) {
    match plan {
        ArmPlan::LeadAndChest => {
            let out = left_out(count - 0.05, loop_counts);
            (GAZE * (2.0 * out - 1.0), 0.0)
        }
        ArmPlan::HighAndLow => (GAZE * (2.0 * left_high(count, loop_counts) - 1.0), 0.0),
        ArmPlan::Open => (6.0 * trig::cos(2.0 * PI * count / loop_counts), 0.0),
        ArmPlan::Rounded | ArmPlan::HandsOnHips => (0.0, 0.0),
        ArmPlan::Ready | ArmPlan::OpenUp | ArmPlan::LowFront | ArmPlan::ToesAndBehind => {
            after_hands(arms)
        }
    }
}

/// Turn and bow of the head [°] after the hand that is farther from the body.
fn after_hands(arms: [Arm; 2]) -> (f32, f32) {
    let [left, right] = [hand(&arms[0], 1.0), hand(&arms[1], -1.0)];
    let away = |[x, _, z]: [f32; 3]| (x * x + z * z).sqrt();
    let share = ramp(0.5 + 0.5 * (away(left) - away(right)) / FAR_HAND);
    let [x, y, z] = [0, 1, 2].map(|i| mix(right[i], left[i], share));
    let turn = trig::atan2(x, z.max(0.2)).to_degrees();
    // The eyes are two fifths of an arm above the shoulders.
    let bow = -trig::atan2(y - 0.8, (x * x + z * z).sqrt().max(0.5)).to_degrees();
    let [most_turn, most_bow] = MOST_GAZE;
    (
        soft_limit(GAZE_OF_HEAD * turn, most_turn),
        soft_limit(GAZE_OF_HEAD * bow, most_bow),
    )
}

/// Nearly `value` where it is small, never beyond `most` either way.
fn soft_limit(value: f32, most: f32) -> f32 {
    value / (1.0 + (value / most) * (value / most)).sqrt()
}

/// Where a hand is from its shoulder, left, up and front [upper arms]; `side` is +1 left.
fn hand(arm: &Arm, side: f32) -> [f32; 3] {
    let direction = |azimuth: f32, elevation: f32| {
        let (sin_a, cos_a) = trig::sin_cos(azimuth.to_radians());
        let (sin_e, cos_e) = trig::sin_cos(elevation.to_radians());
        [side * cos_a * cos_e, sin_e, sin_a * cos_e]
    };
    let upper = direction(arm.azimuth, arm.elevation);
    let fore = direction(arm.fore_azimuth, arm.fore_elevation);
    // Half a shoulder's width aside.
    [
        upper[0] + fore[0] + 0.6 * side,
        upper[1] + fore[1],
        upper[2] + fore[2],
    ]
}

/// How far the left arm of kāholo is out: 1 while travelling left (the second half), 0 while
/// travelling right; it changes sides from the last count of one half to the first of the next.
fn left_out(count: f32, loop_counts: f32) -> f32 {
    let half = 0.5 * loop_counts;
    let count = count.rem_euclid(loop_counts);
    ramp_between(count, half, half + 1.1) + 1.0 - ramp_between(count, 0.0, 1.1)
}

/// How far the left arm of ʻuwehe is high: 1 about the lift of the left foot (half the loop).
fn left_high(count: f32, loop_counts: f32) -> f32 {
    let quarter = 0.25 * loop_counts;
    let count = count.rem_euclid(loop_counts);
    let rise = ramp_between(count, 1.1 * quarter, 2.0 * quarter);
    rise - ramp_between(count, 3.1 * quarter, 4.0 * quarter)
}

/// Left arm without its waves. The upper arm leads, the forearm follows.
fn shape(plan: ArmPlan, loop_counts: f32, count: f32) -> Arm {
    let (from, to, way): (_, _, fn(f32, f32) -> f32) = match plan {
        ArmPlan::LeadAndChest => (AT_CHEST, OUT, left_out),
        ArmPlan::HighAndLow => (LOW, HIGH, left_high),
        ArmPlan::Rounded => (ROUNDED, ROUNDED, still),
        ArmPlan::Open => (OPEN, OPEN, still),
        ArmPlan::HandsOnHips => (ON_WAIST, ON_WAIST, still),
        ArmPlan::Ready => (OUT, OUT, still),
        ArmPlan::OpenUp => (UP, UP, still),
        ArmPlan::LowFront => (OFFERING, OFFERING, still),
        ArmPlan::ToesAndBehind => (HIGH_BEHIND, TO_TOES, left_out),
    };
    let leading = from.mixed(&to, way(count, loop_counts));
    let following = from.mixed(&to, way(count - FINGER_LAG_COUNTS, loop_counts));
    Arm {
        azimuth: leading.azimuth,
        elevation: leading.elevation,
        ..following
    }
}

fn still(_count: f32, _loop_counts: f32) -> f32 {
    0.0
}

/// Left arm with its wave, one in two counts: while the forearm rises the hand hangs behind, while
/// it sinks the hand is drawn back, and the fingers come a little later. `share` of it is left.
fn waved(plan: ArmPlan, loop_counts: f32, count: f32, share: f32) -> Arm {
    let arm = shape(plan, loop_counts, count);
    let (wrist, elbow) = match plan {
        ArmPlan::LeadAndChest => {
            let out = left_out(count, loop_counts);
            (9.0 + 8.0 * out, 1.5 + 3.0 * out)
        }
        ArmPlan::Open | ArmPlan::Ready => (14.0, 4.0),
        ArmPlan::Rounded | ArmPlan::LowFront => (12.0, 3.0),
        ArmPlan::OpenUp => (10.0, 3.0),
        ArmPlan::HighAndLow | ArmPlan::ToesAndBehind => (6.0, 2.0),
        ArmPlan::HandsOnHips => return arm,
    };
    let (wrist, elbow) = (share * wrist, share * elbow);
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
