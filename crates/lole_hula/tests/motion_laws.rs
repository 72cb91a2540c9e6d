//! Laws of the dance: feet stand, the head stays level, loops close, mirrors and tempo hold.

mod motion_support;
mod posed_support;

use std::sync::LazyLock;

use glam::Vec3;
use lole_body::{Bone, Pose, Skeleton};
use lole_hula::{
    AmiTurn, ArmStyle, Dance, DanceStep, HipLead, HipLift, MotionError, MotionSettings,
};
use motion_support::woman;
use posed_support::{LEGS, Moment};

const SAMPLES_PER_COUNT: f32 = 40.0;

fn dance_of(settings: &MotionSettings) -> Dance {
    Dance::new(&woman(), settings).expect("settings within their ranges")
}

/// The steps whose figures are stated here; what holds for all of them is in `repertoire_laws`.
const FIRST: [DanceStep; 4] = [
    DanceStep::Kao,
    DanceStep::Kaholo,
    DanceStep::Ami,
    DanceStep::Uwehe,
];

fn settings_of(dance_step: DanceStep) -> MotionSettings {
    MotionSettings {
        dance_step,
        ..MotionSettings::default()
    }
}

/// Every step in a few tempos, schools and amplitudes.
fn many_settings() -> Vec<MotionSettings> {
    settings_of_many(&DanceStep::ALL)
}

fn settings_of_many(steps: &[DanceStep]) -> Vec<MotionSettings> {
    let mut all = Vec::new();
    for &dance_step in steps {
        for beats_per_minute in [60.0, 80.0, 130.0] {
            all.push(MotionSettings {
                beats_per_minute,
                ..settings_of(dance_step)
            });
        }
        for arms in [ArmStyle::Open, ArmStyle::HandsOnHips] {
            all.push(MotionSettings {
                arms,
                ..settings_of(dance_step)
            });
        }
        all.push(MotionSettings {
            hip_lift: HipLift::FreeSide,
            hip_lead: HipLead::SteppingFoot,
            ami_turn: AmiTurn::Hema,
            ..settings_of(dance_step)
        });
        all.push(MotionSettings {
            sway: 1.6,
            knee_degrees: 10.0,
            step_width: 0.26,
            heel_lift: 0.03,
            ..settings_of(dance_step)
        });
        all.push(MotionSettings {
            sway: 0.0,
            knee_degrees: 65.0,
            ..settings_of(dance_step)
        });
    }
    all
}

/// Times [s] of the lead-in and of one loop.
fn times(dance: &Dance, settings: &MotionSettings) -> Vec<f32> {
    let count = 60.0 / settings.beats_per_minute;
    let end = dance.lead_in() + dance.period();
    let step = count / SAMPLES_PER_COUNT;
    (0_u16..)
        .map(|i| f32::from(i) * step)
        .take_while(|&time| time <= end + 0.5 * step)
        .collect()
}

static WOMAN: LazyLock<Skeleton> = LazyLock::new(woman);

fn moment_of(pose: &Pose) -> Moment<'static> {
    Moment::of(&WOMAN, pose.clone())
}

const FEET: [[Bone; 2]; 2] = [
    [Bone::LeftFoot, Bone::LeftToes],
    [Bone::RightFoot, Bone::RightToes],
];

/// Largest distance between joints of two poses [m].
fn distance(a: &Pose, b: &Pose) -> f32 {
    let (a, b) = (moment_of(a), moment_of(b));
    let gaps = Bone::ALL
        .iter()
        .map(|&bone| a.at(bone).distance(b.at(bone)));
    gaps.fold(0.0, f32::max)
}

#[test]
fn room_before_the_chest_keeps_that_hand_away_and_moves_nothing_else() {
    let plain = dance_of(&settings_of(DanceStep::Kaholo));
    let roomy = dance_of(&MotionSettings {
        chest_room_degrees: 10.0,
        ..settings_of(DanceStep::Kaholo)
    });
    let (mut across, mut out) = (0, 0);
    for time in times(&plain, &settings_of(DanceStep::Kaholo)) {
        let [plain, roomy] = [&plain, &roomy].map(|dance| moment_of(&dance.pose_at(time)));
        assert_eq!(
            plain.at(Bone::LeftFoot),
            roomy.at(Bone::LeftFoot),
            "{time} s"
        );
        let chest = plain.skin[Bone::UpperChest.index()].inverse();
        let tip = |moment: &Moment<'_>| chest.transform_point3(moment.at(Bone::LeftMiddleDistal));
        let farther = tip(&roomy).z - tip(&plain).z;
        if tip(&plain).x < 0.02 {
            across += 1;
            assert!((0.03..0.1).contains(&farther), "{farther} m at {time} s");
        } else if 0.5 < tip(&plain).x {
            out += 1;
            assert!(farther.abs() < 1e-6, "{farther} m at {time} s");
        }
    }
    assert!(20 < across && 20 < out, "{across} across, {out} out");
}

#[test]
fn a_standing_foot_slides_less_than_a_millimetre() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        for [foot, toes] in FEET {
            let mut stand: Option<Vec3> = None;
            for time in times(&dance, &settings) {
                let moment = moment_of(&dance.pose_at(time));
                let flat = moment.turn(foot) * Vec3::Y;
                let ball = moment.at(toes);
                let bind = moment.skeleton.joint(toes).y;
                assert!(ball.y > bind - 1e-4, "{settings:?}: toes in the floor");
                let lifted = ball.y > bind + 1e-4;
                if lifted || flat.y < 0.999_99 {
                    stand = None;
                    continue;
                }
                let ankle = moment.at(foot);
                assert!(
                    (ankle.y - moment.skeleton.joint(foot).y).abs() < 1e-3,
                    "{settings:?}"
                );
                let first = *stand.get_or_insert(ankle);
                assert!(
                    ankle.distance(first) < 1e-3,
                    "{settings:?} at {time}: slides"
                );
            }
        }
    }
}

#[test]
fn a_raised_heel_leaves_the_ball_of_the_foot_where_it_was() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        for [_, toes] in FEET {
            let mut stand: Option<Vec3> = None;
            for time in times(&dance, &settings) {
                let moment = moment_of(&dance.pose_at(time));
                let ball = moment.at(toes);
                if ball.y > moment.skeleton.joint(toes).y + 1e-4 {
                    stand = None;
                    continue;
                }
                let first = *stand.get_or_insert(ball);
                // The lift of a sliding foot grows from nothing, hence not exactly zero.
                assert!(ball.distance(first) < 0.01, "{settings:?} at {time}");
                let toes_up = moment.turn(toes) * Vec3::Y;
                assert!(toes_up.y > 0.9999, "{settings:?}: toes stay flat");
            }
        }
    }
}

#[test]
fn one_foot_always_stands() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        for time in times(&dance, &settings) {
            let moment = moment_of(&dance.pose_at(time));
            let lowest = FEET.map(|[_, toes]| moment.at(toes).y - moment.skeleton.joint(toes).y);
            assert!(lowest[0].min(lowest[1]) < 1e-4, "{settings:?} at {time}");
        }
    }
}

#[test]
fn head_and_shoulders_stay_level() {
    for settings in settings_of_many(&FIRST) {
        let dance = dance_of(&settings);
        let extreme = settings.sway > 1.0;
        let mut heights = [f32::MAX, f32::MIN];
        for time in times(&dance, &settings) {
            let moment = moment_of(&dance.pose_at(time));
            let height = moment.at(Bone::Head).y;
            heights = [heights[0].min(height), heights[1].max(height)];
            let across = moment.at(Bone::LeftUpperArm).y - moment.at(Bone::RightUpperArm).y;
            let style = settings.arms != ArmStyle::OfStep || settings.dance_step == DanceStep::Ami;
            assert!(
                !style || across.abs() < 0.01,
                "{settings:?}: shoulders {across}"
            );
            let up = moment.turn(Bone::UpperChest) * Vec3::Y;
            assert!(up.y > 0.999_99, "{settings:?}: chest leans");
        }
        let drift = heights[1] - heights[0];
        let allowed = if extreme { 0.06 } else { 0.01 };
        assert!(
            drift < allowed,
            "{settings:?}: head rises and falls by {drift}"
        );
    }
}

#[test]
fn the_head_stays_above_the_feet_in_place() {
    for dance_step in [DanceStep::Kao, DanceStep::Ami, DanceStep::Uwehe] {
        let settings = settings_of(dance_step);
        let dance = dance_of(&settings);
        for time in times(&dance, &settings) {
            let moment = moment_of(&dance.pose_at(time));
            let x = moment.at(Bone::Head).x;
            assert!(x.abs() < 0.015, "{dance_step:?} at {time}: head at {x}");
        }
    }
}

#[test]
fn loops_close_with_their_velocity() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        let period = dance.period();
        let start = dance.lead_in();
        let step = 0.01;
        for shift in [-step, 0.0, step, 0.37 * period] {
            let once = dance.pose_at(start + period + shift);
            let again = dance.pose_at(start + 2.0 * period + shift);
            let gap = distance(&once, &again);
            assert!(gap < 1e-4, "{settings:?} at {shift}: loop opens by {gap}");
        }
    }
}

/// Largest second difference of a joint over three moments [m].
fn bend(moments: &[Moment<'_>; 3]) -> f32 {
    let bends = Bone::ALL.iter().map(|&bone| {
        let [a, b, c] = [0, 1, 2].map(|i| moments[i].at(bone));
        (a - 2.0 * b + c).length()
    });
    bends.fold(0.0, f32::max)
}

#[test]
fn joints_have_continuous_velocity_from_the_stance_on() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        let count = 60.0 / settings.beats_per_minute;
        let step = count / 400.0;
        let most = if settings.sway > 1.0 { 200.0 } else { 80.0 };
        for time in times(&dance, &settings) {
            let moments = [-step, 0.0, step].map(|shift| moment_of(&dance.pose_at(time + shift)));
            // m per count²; a jump in velocity of v [m per count] would give 400 v.
            let acceleration = bend(&moments) * 400.0 * 400.0;
            assert!(
                acceleration < most,
                "{settings:?} at {time}: {acceleration}"
            );
        }
    }
}

#[test]
fn it_starts_in_the_ready_stance_on_both_feet() {
    for settings in settings_of_many(&FIRST) {
        let dance = dance_of(&settings);
        for time in [0.0, -3.0, f32::NEG_INFINITY, f32::NAN, f32::INFINITY] {
            assert_eq!(dance.pose_at(time), dance.stance());
        }
        let moment = moment_of(&dance.stance());
        for leg in LEGS {
            let knee = moment.knee_degrees(leg);
            // Kāholo stands as low as its stride needs.
            let deeper = match settings.dance_step {
                DanceStep::Kaholo if settings.step_width > 0.2 => 40.0,
                DanceStep::Kaholo => 14.0,
                _ if settings.knee_degrees < 20.0 => 10.0,
                _ => 2.5,
            };
            let range = settings.knee_degrees - 0.5..settings.knee_degrees + deeper;
            assert!(range.contains(&knee), "{settings:?}: knee {knee}");
        }
        let gap = moment.at(Bone::LeftFoot).x - moment.at(Bone::RightFoot).x;
        assert!((gap - 0.124 * 1.5847).abs() < 0.002, "ankles {gap} m apart");
    }
}

#[test]
fn no_time_gives_a_broken_pose() {
    for settings in many_settings() {
        let dance = dance_of(&settings);
        let odd = [1e-30, 0.1, 7.77, 3600.0, 1e6, 1e12, 1e30, f32::MAX];
        for time in times(&dance, &settings).into_iter().chain(odd) {
            let moment = moment_of(&dance.pose_at(time));
            assert!(moment.is_whole(), "{settings:?} at {time}");
            for leg in LEGS {
                let knee = moment.knee_degrees(leg);
                let most = if settings.knee_degrees > 60.0 {
                    105.0
                } else {
                    80.0
                };
                assert!(
                    (8.0..most).contains(&knee),
                    "{settings:?} at {time}: knee {knee}"
                );
            }
        }
    }
}

/// The pose seen in a mirror at `x` [m].
fn mirrored(moment: &Moment<'_>, bone: Bone, x: f32) -> Vec3 {
    let name = bone.name();
    let other = if name.starts_with("left") {
        name.replace("left", "right")
    } else {
        name.replace("right", "left")
    };
    let other = Bone::ALL
        .iter()
        .find(|bone| bone.name() == other)
        .expect("bones are paired");
    let place = moment.at(*other);
    Vec3::new(2.0 * x - place.x, place.y, place.z)
}

#[test]
fn the_left_half_is_the_mirror_image_of_the_right_half() {
    for settings in settings_of_many(&FIRST) {
        if settings.dance_step == DanceStep::Ami {
            continue;
        }
        let dance = dance_of(&settings);
        // Kāholo's mirror stands in the middle of its way.
        let middle = match settings.dance_step {
            DanceStep::Kaholo => -settings.step_width * (0.3566 + 0.3739) / 0.461,
            _ => 0.0,
        };
        for i in 0..20 {
            let time = dance.lead_in() + dance.period() * (1.0 + i as f32 / 40.0);
            let right = moment_of(&dance.pose_at(time));
            let left = moment_of(&dance.pose_at(time + 0.5 * dance.period()));
            for &bone in Bone::ALL {
                let gap = right.at(bone).distance(mirrored(&left, bone, middle));
                assert!(gap < 5e-4, "{settings:?} {bone:?}: {gap}");
            }
        }
    }
}

#[test]
fn ami_hema_is_the_mirror_image_of_ami_akau() {
    let akau = dance_of(&settings_of(DanceStep::Ami));
    let hema = dance_of(&MotionSettings {
        ami_turn: AmiTurn::Hema,
        ..settings_of(DanceStep::Ami)
    });
    for i in 0..20 {
        let time = akau.lead_in() + akau.period() * i as f32 / 20.0;
        let right = moment_of(&akau.pose_at(time));
        let left = moment_of(&hema.pose_at(time + 0.5 * akau.period()));
        for &bone in Bone::ALL {
            let gap = right.at(bone).distance(mirrored(&left, bone, 0.0));
            assert!(gap < 5e-4, "{bone:?}: {gap}");
        }
    }
}

#[test]
fn ami_akau_goes_from_left_to_back() {
    let dance = dance_of(&settings_of(DanceStep::Ami));
    let hips = |part: f32| {
        let moment = moment_of(&dance.pose_at(dance.lead_in() + part * dance.period()));
        0.5 * (moment.at(Bone::LeftUpperLeg) + moment.at(Bone::RightUpperLeg))
    };
    let (left, back, right, front) = (hips(0.0), hips(0.25), hips(0.5), hips(0.75));
    assert!(left.x > 0.06 && right.x < -0.06, "{left} {right}");
    assert!(
        back.z < left.z - 0.04 && front.z > left.z + 0.02,
        "{back} {front}"
    );
    // The front reach is 0.6 of the back reach.
    let ratio = (front.z - left.z) / (left.z - back.z);
    assert!((ratio - 0.6).abs() < 0.02, "{ratio}");
}

#[test]
fn tempo_scales_time_exactly() {
    for dance_step in DanceStep::ALL {
        let slow = dance_of(&MotionSettings {
            beats_per_minute: 64.0,
            ..settings_of(dance_step)
        });
        let fast = dance_of(&MotionSettings {
            beats_per_minute: 128.0,
            ..settings_of(dance_step)
        });
        assert_eq!(slow.period(), 2.0 * fast.period());
        for i in 0..50 {
            let time = i as f32 * 0.125;
            assert_eq!(slow.pose_at(2.0 * time), fast.pose_at(time));
        }
    }
}

#[test]
fn hip_adduction_agrees_with_the_radiographs_of_a_dancer() {
    // Komiyama et al. 2018: 15° in kaʻo, 11° in kāholo.
    for (dance_step, measured) in [(DanceStep::Kao, 15.0), (DanceStep::Kaholo, 11.0)] {
        let settings = settings_of(dance_step);
        let dance = dance_of(&settings);
        let most = (times(&dance, &settings).into_iter())
            .map(|time| moment_of(&dance.pose_at(time)).adduction(0))
            .fold(f32::MIN, f32::max);
        assert!((most - measured).abs() < 3.0, "{dance_step:?}: {most}");
    }
}

#[test]
fn kao_sways_fourteen_centimetres_at_two_thirds_hertz() {
    let settings = settings_of(DanceStep::Kao);
    let dance = dance_of(&settings);
    assert!((1.0 / dance.period() - 0.667).abs() < 1e-3);
    let x = |time: f32| {
        let moment = moment_of(&dance.pose_at(time));
        0.5 * (moment.at(Bone::LeftUpperLeg) + moment.at(Bone::RightUpperLeg)).x
    };
    let left = x(dance.lead_in());
    let right = x(dance.lead_in() + 0.5 * dance.period());
    assert!((left - right - 0.143).abs() < 0.004, "{left} {right}");
}

#[test]
fn hands_keep_clear_of_trunk_and_skirt() {
    for settings in many_settings() {
        if settings.arms == ArmStyle::HandsOnHips {
            continue;
        }
        // The hand of ʻaui goes down to the toes.
        let low = settings.knee_degrees > 60.0 || settings.dance_step == DanceStep::Aui;
        let lowest = if low { 0.7 } else { 0.95 };
        let dance = dance_of(&settings);
        for time in times(&dance, &settings) {
            let moment = moment_of(&dance.pose_at(time));
            let trunk = moment.at(Bone::Chest);
            for hand in [Bone::LeftHand, Bone::RightHand, Bone::LeftMiddleDistal] {
                let place = moment.at(hand);
                assert!(
                    place.y > lowest,
                    "{settings:?} at {time}: {hand:?} at {place}"
                );
                let away = (place - trunk).with_y(0.0).length();
                assert!(
                    away > 0.15,
                    "{settings:?} at {time}: {hand:?} {away} m from the axis"
                );
            }
        }
    }
}

#[test]
fn the_far_hand_of_kaholo_is_out_at_shoulder_height_with_its_palm_down() {
    let settings = settings_of(DanceStep::Kaholo);
    let dance = dance_of(&settings);
    // Third count of the way to the right.
    let moment = moment_of(&dance.pose_at(dance.lead_in() + 0.25 * dance.period()));
    let shoulder = moment.at(Bone::RightUpperArm);
    let hand = moment.at(Bone::RightHand);
    assert!(shoulder.x - hand.x > 0.38, "{hand}");
    assert!((shoulder.y - hand.y).abs() < 0.08, "{hand}");
    let along = moment.at(Bone::RightMiddleProximal) - hand;
    let across = moment.at(Bone::RightLittleProximal) - moment.at(Bone::RightIndexProximal);
    let palm = along.cross(across).normalize_or_zero();
    assert!(palm.y < -0.8, "{palm}");
    // The thumb is on the front side then.
    assert!(moment.at(Bone::RightThumbProximal).z > moment.at(Bone::RightLittleProximal).z);
    let chest_hand = moment.at(Bone::LeftMiddleProximal);
    assert!(
        (chest_hand.x - moment.at(Bone::UpperChest).x).abs() < 0.08,
        "{chest_hand}"
    );
}

#[test]
fn absurd_settings_are_refused_with_a_sentence() {
    let absurd = [
        MotionSettings {
            beats_per_minute: 0.0,
            ..MotionSettings::default()
        },
        MotionSettings {
            beats_per_minute: 1000.0,
            ..MotionSettings::default()
        },
        MotionSettings {
            beats_per_minute: f32::NAN,
            ..MotionSettings::default()
        },
        MotionSettings {
            sway: -1.0,
            ..MotionSettings::default()
        },
        MotionSettings {
            knee_degrees: f32::INFINITY,
            ..MotionSettings::default()
        },
    ];
    for settings in absurd {
        let error = Dance::new(&woman(), &settings).expect_err("it is absurd");
        assert!(error.to_string().contains("use a number from"), "{error}");
    }
    let mut skeleton = woman();
    skeleton.joints[Bone::LeftLowerLeg.index()] = skeleton.joint(Bone::LeftUpperLeg);
    let error = Dance::new(&skeleton, &MotionSettings::default()).expect_err("no thigh");
    assert_eq!(
        error,
        MotionError::BoneWithoutLength {
            bone: "leftUpperLeg"
        }
    );
}

#[test]
fn steps_are_found_by_their_ids() {
    for dance_step in DanceStep::ALL {
        assert_eq!(DanceStep::from_id(dance_step.id()), Some(dance_step));
    }
    assert_eq!(DanceStep::from_id("waltz"), None);
}
