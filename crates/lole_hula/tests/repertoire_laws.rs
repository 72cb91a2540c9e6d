//! Laws of the whole repertoire, for six dancers, from the slowest to the fastest tempo of each
//! step, and for every way from one step into another.

mod posed_support;

use std::sync::LazyLock;

use glam::{Quat, Vec3};
use lole_body::{Bone, Dancer, Measurements, Side, Skeleton, Tape};
use lole_geom::Length;
use lole_hula::SCHOOLS;
use lole_hula::{Dance, DanceStep, MotionSettings, Part};
use posed_support::{LEGS, Moment};

const SAMPLES_PER_COUNT: f32 = 40.0;

/// Stature, bust, waist, hip [cm].
const DANCERS: [[f64; 4]; 6] = [
    [158.0, 83.5, 66.0, 91.0],
    [143.0, 80.0, 62.0, 86.0],
    [176.0, 92.0, 74.0, 99.0],
    [150.0, 104.0, 92.0, 108.0],
    [163.0, 120.0, 110.0, 128.0],
    [170.0, 78.0, 60.0, 84.0],
];

static SKELETONS: LazyLock<Vec<Skeleton>> = LazyLock::new(|| {
    let skeleton = |[stature, bust, waist, hip]: [f64; 4]| {
        let cm = |value| Some(Length::from_cm(value));
        let tape = Tape {
            stature: cm(stature),
            bust_girth: cm(bust),
            waist_girth: cm(waist),
            hip_girth: cm(hip),
            ..Tape::default()
        };
        let measurements = Measurements::from_tape(&tape).expect("a dancer's tape");
        Dancer::new(&measurements).expect("a body").skeleton
    };
    DANCERS.map(skeleton).to_vec()
});

fn woman() -> &'static Skeleton {
    &SKELETONS[0]
}

/// Fastest a joint may turn [rad per count]; at 132 counts a minute 15 rad/s. Runners' knees turn
/// at 15 to 20 rad/s.
const MOST_TURN: f32 = 7.0;
/// Farthest second difference of a joint's place [m per count²]: a jump in velocity of 10 cm a
/// count would be seen as 4 m per count² at 40 samples a count.
const MOST_BEND: f32 = 50.0;

const FEET: [[Bone; 2]; 2] = [
    [Bone::LeftFoot, Bone::LeftToes],
    [Bone::RightFoot, Bone::RightToes],
];
/// What the floor has to bear, from moment to moment.
#[derive(Default)]
struct Floor {
    /// Where a ball and a flat foot's ankle came to stand.
    balls: [Option<Vec3>; 2],
    ankles: [Option<Vec3>; 2],
}

impl Floor {
    /// Farthest that a standing foot has slid since it stood [m]; it must not be in the floor.
    fn slide(&mut self, moment: &Moment<'_>, said: &str) -> f32 {
        let mut slide = 0.0_f32;
        let mut stands = false;
        for (i, [foot, toes]) in FEET.into_iter().enumerate() {
            let bind = moment.skeleton.joint(toes);
            let ball = moment.at(toes);
            assert!(
                ball.y > bind.y - 2e-3,
                "{said}: ball {} m in the floor",
                bind.y - ball.y
            );
            // The sole under the heel, as far behind the ankle as a heel goes.
            let ankle = moment.skeleton.joint(foot);
            let heel = moment.carried(foot, Vec3::new(ankle.x, 0.0, ankle.z - 0.05));
            assert!(heel.y > -2e-3, "{said}: heel {} m in the floor", -heel.y);
            if ball.y > bind.y + 2e-4 {
                (self.balls[i], self.ankles[i]) = (None, None);
                continue;
            }
            stands = true;
            slide = slide.max(ball.distance(*self.balls[i].get_or_insert(ball)));
            let flat = moment.turn(foot) * Vec3::Y;
            if flat.y < 0.999_99 {
                self.ankles[i] = None;
                continue;
            }
            let ankle = moment.at(foot);
            slide = slide.max(ankle.distance(*self.ankles[i].get_or_insert(ankle)));
        }
        assert!(stands, "{said}: no foot stands");
        slide
    }
}

fn turned_by(a: Quat, b: Quat) -> f32 {
    2.0 * lole_geom::trig::acos(a.dot(b).abs().min(1.0))
}

/// Fastest turn of a joint [rad per step] and farthest second difference of a joint [m].
fn motion(moments: &[Moment<'_>; 3]) -> (f32, Bone, f32) {
    let (mut turn, mut fastest, mut bend) = (0.0_f32, Bone::Hips, 0.0_f32);
    for &bone in Bone::ALL {
        let by = turned_by(
            moments[0].pose.rotation(bone),
            moments[1].pose.rotation(bone),
        );
        if turn < by {
            (turn, fastest) = (by, bone);
        }
        let [a, b, c] = [0, 1, 2].map(|i: usize| moments[i].at(bone));
        bend = bend.max((a - 2.0 * b + c).length());
    }
    (turn, fastest, bend)
}

fn settings_of(dance_step: DanceStep) -> MotionSettings {
    MotionSettings {
        dance_step,
        ..MotionSettings::default()
    }
}

/// Moments of the lead-in and one loop.
fn moments<'a>(
    skeleton: &'a Skeleton,
    settings: &MotionSettings,
) -> impl Iterator<Item = (f32, Moment<'a>)> {
    let dance = Dance::new(skeleton, settings).expect("it can be danced");
    let step = 60.0 / settings.beats_per_minute / SAMPLES_PER_COUNT;
    let end = dance.lead_in() + 1.1 * dance.period();
    (0_u16..)
        .map(move |i| f32::from(i) * step)
        .take_while(move |time| *time <= end)
        .map(move |time| (time, Moment::of(skeleton, dance.pose_at(time))))
}

#[test]
fn feet_are_locked_to_the_floor_for_six_dancers_at_every_tempo() {
    for skeleton in SKELETONS.iter() {
        for step in DanceStep::ALL {
            let [slow, fast] = step.tempo();
            for beats_per_minute in [slow, 80.0, fast] {
                let settings = MotionSettings {
                    beats_per_minute,
                    ..settings_of(step)
                };
                let mut floor = Floor::default();
                for (time, moment) in moments(skeleton, &settings) {
                    let said = format!("{step:?} at {beats_per_minute}, {time} s");
                    assert!(moment.is_whole(), "{said}");
                    let slide = floor.slide(&moment, &said);
                    assert!(slide < 0.005, "{said}: slides {slide} m");
                }
            }
        }
    }
}

/// How far the head may rise and fall [m]: steps that dip or lean are meant to.
fn head_allowance(step: DanceStep) -> f32 {
    match step {
        DanceStep::KaholoDip => 0.055,
        DanceStep::LeleUwehe => 0.025,
        DanceStep::Kawelu | DanceStep::Kalakaua | DanceStep::Aui => 0.02,
        _ => 0.01,
    }
}

#[test]
fn the_head_stays_level_where_no_dip_is_asked_for() {
    for step in DanceStep::ALL {
        let mut heights = [f32::MAX, f32::MIN];
        for (_, moment) in moments(woman(), &settings_of(step)) {
            let height = moment.at(Bone::Head).y;
            heights = [heights[0].min(height), heights[1].max(height)];
        }
        let drift = heights[1] - heights[0];
        assert!(drift < head_allowance(step), "{step:?}: {drift} m");
    }
}

#[test]
fn knees_bend_as_in_hula_and_joints_turn_no_faster_than_they_can() {
    for step in DanceStep::ALL {
        let [_, beats_per_minute] = step.tempo();
        let settings = MotionSettings {
            beats_per_minute,
            ..settings_of(step)
        };
        let all: Vec<_> = moments(woman(), &settings)
            .map(|(_, moment)| moment)
            .collect();
        for moment in &all {
            for leg in LEGS {
                let knee = moment.knee_degrees(leg);
                assert!((11.0..72.0).contains(&knee), "{step:?}: knee {knee}");
            }
        }
        for pair in all.windows(2) {
            for &bone in Bone::ALL {
                let by = turned_by(pair[0].pose.rotation(bone), pair[1].pose.rotation(bone));
                let rate = by * SAMPLES_PER_COUNT;
                assert!(
                    rate < MOST_TURN,
                    "{step:?}: {bone:?} turns by {rate} rad a count"
                );
            }
        }
    }
}

#[test]
fn hips_adduct_as_in_the_radiographs_of_a_dancer() {
    // Komiyama et al. 2018: 15° in kaʻo, 11° in kāholo.
    for (step, measured) in [(DanceStep::Kao, 15.0), (DanceStep::Kaholo, 11.0)] {
        let most = moments(woman(), &settings_of(step))
            .flat_map(|(_, moment)| [moment.adduction(0), moment.adduction(1)])
            .fold(f32::MIN, f32::max);
        assert!((most - measured).abs() < 3.0, "{step:?}: {most}");
    }
}

fn parts_of(parts: Vec<Part>) -> MotionSettings {
    MotionSettings {
        parts,
        ..MotionSettings::default()
    }
}

/// Checks a stretch of a dance: feet locked, joints bounded, no pop.
fn check_stretch(dance: &Dance, skeleton: &Skeleton, times: [f32; 2], count: f32, said: &str) {
    check_quick((dance, skeleton), times, (count, 1.0), said);
}

/// The same where joints are so much quicker.
fn check_quick(
    (dance, skeleton): (&Dance, &Skeleton),
    [from, to]: [f32; 2],
    (count, quick): (f32, f32),
    said: &str,
) {
    let step = count / SAMPLES_PER_COUNT;
    let mut floor = Floor::default();
    let mut time = from;
    let moment = |time: f32| Moment::of(skeleton, dance.pose_at(time));
    let mut trio = [-step, 0.0, step].map(|shift| moment(from + shift));
    while time < to {
        let said = format!("{said} at {} counts", (time - from) / count);
        let slide = floor.slide(&trio[1], &said);
        assert!(slide < 0.005, "{said}: slides {slide} m");
        let (turn, bone, bend) = motion(&trio);
        let turn = turn * SAMPLES_PER_COUNT;
        assert!(
            turn < quick * MOST_TURN,
            "{said}: {bone:?} turns by {turn} rad a count"
        );
        let bend = bend * SAMPLES_PER_COUNT * SAMPLES_PER_COUNT;
        assert!(bend < quick * MOST_BEND, "{said}: {bend} m per count²");
        time += step;
        let [_, before, now] = trio;
        trio = [before, now, moment(time + step)];
    }
}

#[test]
fn every_step_goes_over_into_every_other() {
    let skeleton = woman();
    for first in DanceStep::ALL {
        for second in DanceStep::ALL {
            for side in [Side::Right, Side::Left] {
                let next = Part {
                    side,
                    ..Part::new(second, second.phrase())
                };
                let settings = parts_of(vec![Part::new(first, first.phrase()), next]);
                let dance = Dance::new(skeleton, &settings).expect("it can be danced");
                let count = 60.0 / settings.beats_per_minute;
                let begin = (2.0 + first.phrase() as f32 - 1.0) * count;
                let said = format!("{first:?} {second:?} {side:?}");
                check_stretch(&dance, skeleton, [begin, begin + 3.5 * count], count, &said);
            }
        }
    }
}

/// Parts of two phrases: step, side, facing [°], tempo.
const TURNING: [(DanceStep, Side, f32, Option<f32>); 10] = [
    (DanceStep::Kaholo, Side::Right, 0.0, Some(72.0)),
    (DanceStep::Hela, Side::Left, 45.0, None),
    (DanceStep::Ami, Side::Left, 90.0, Some(96.0)),
    (DanceStep::Kaapuni, Side::Left, 90.0, None),
    (DanceStep::Kaholo, Side::Left, -90.0, None),
    (DanceStep::Kaapuni, Side::Right, -90.0, Some(60.0)),
    (DanceStep::Uwehe, Side::Right, 0.0, None),
    (DanceStep::LeleUwehe, Side::Right, 180.0, None),
    (DanceStep::Lele, Side::Left, 0.0, Some(110.0)),
    (DanceStep::Kao, Side::Right, 0.0, None),
];

#[test]
fn a_dance_that_turns_and_changes_tempo_is_one_movement_to_its_end() {
    let parts = TURNING.map(|(step, side, facing_degrees, beats_per_minute)| Part {
        side,
        facing_degrees,
        beats_per_minute,
        ..Part::new(step, 2 * step.phrase())
    });
    let settings = parts_of(parts.to_vec());
    for skeleton in SKELETONS.iter() {
        let dance = Dance::new(skeleton, &settings).expect("it can be danced");
        let end = dance.lead_in() + dance.period() + 2.0;
        check_stretch(&dance, skeleton, [0.05, end], 0.5, "the dance");
        // She has come to rest, facing the front again.
        let (a, b) = (dance.pose_at(end + 1.0), dance.pose_at(end + 60.0));
        assert_eq!(a, b);
        let rest = Moment::of(skeleton, a);
        let front = rest.turn(Bone::Hips) * Vec3::Z;
        assert!(front.z > 0.999, "{front}");
        let apart = rest.at(Bone::LeftFoot) - rest.at(Bone::RightFoot);
        assert!(apart.x > 0.15, "{apart}");
    }
}

/// Whoever goes to another place on the stage walks there on her feet, in any step that walks, and arrives.
#[test]
fn a_way_is_walked_and_ends_where_it_should() {
    let skeleton = woman();
    let mut walked = 0;
    for step in DanceStep::ALL {
        let counts = 4 * step.phrase();
        let most = 0.999 * step.longest_way(counts);
        for (side, direction) in [
            (Side::Right, [1.0_f32, 0.0]),
            (Side::Left, [0.6, -0.8]),
            (Side::Right, [-0.8, 0.6]),
        ] {
            let dance = |travel: [f32; 2]| {
                let part = Part {
                    side,
                    travel,
                    ..Part::new(step, counts)
                };
                let next = Part::new(DanceStep::Kao, 4);
                Dance::new(skeleton, &parts_of(vec![part, next]))
            };
            let travel = direction.map(|along| along * most);
            let (stays, goes) = (dance([0.0; 2]).expect("it can be danced"), dance(travel));
            if most == 0.0 {
                assert!(dance([0.3, 0.0]).is_err(), "{step:?} takes nobody anywhere");
                continue;
            }
            walked += 1;
            let goes = goes.expect("it can be danced");
            let said = format!("{step:?} {side:?} {travel:?}");
            let count = 60.0 / MotionSettings::default().beats_per_minute;
            let end = goes.lead_in() + goes.period() + 2.0;
            // Longer strides are taken in the same time.
            check_quick((&goes, skeleton), [0.05, end], (count, 1.3), &said);
            let place = |dance: &Dance| Moment::of(skeleton, dance.pose_at(end)).at(Bone::Hips);
            let way = place(&goes) - place(&stays);
            let asked = Vec3::new(travel[0], 0.0, travel[1]) * goes.stature();
            assert!(way.distance(asked) < 0.02, "{said}: {way} m of {asked}");
            assert!(
                dance(direction.map(|along| 1.1 * most * along)).is_err(),
                "{said}"
            );
        }
    }
    assert!(walked > 20, "{walked} ways were walked");
}

/// The joint of the other side that answers to this one.
fn opposite(bone: Bone) -> Bone {
    let name = bone.name();
    let other = if name.starts_with("left") {
        name.replace("left", "right")
    } else {
        name.replace("right", "left")
    };
    let found = Bone::ALL.iter().find(|bone| bone.name() == other);
    *found.expect("bones are paired")
}

#[test]
fn the_left_side_is_the_mirror_image_of_the_right_side() {
    let skeleton = woman();
    for step in DanceStep::ALL {
        let dances = [Side::Right, Side::Left].map(|side| {
            let part = Part {
                side,
                ..Part::new(step, 2 * step.phrase())
            };
            Dance::new(skeleton, &parts_of(vec![part])).expect("it can be danced")
        });
        for i in 0..120_u16 {
            let time = f32::from(i) * 0.1;
            let [right, left] =
                [0, 1].map(|d: usize| Moment::of(skeleton, dances[d].pose_at(time)));
            for &bone in Bone::ALL {
                let place = left.at(opposite(bone));
                let gap = right
                    .at(bone)
                    .distance(Vec3::new(-place.x, place.y, place.z));
                assert!(gap < 1e-3, "{step:?} at {time}: {bone:?} {gap} m");
            }
        }
    }
}

#[test]
fn counts_fall_on_the_beat_and_parts_begin_on_their_first_count() {
    let settings = parts_of(vec![
        Part {
            beats_per_minute: Some(60.0),
            ..Part::new(DanceStep::Kaholo, 8)
        },
        Part {
            beats_per_minute: Some(120.0),
            ..Part::new(DanceStep::Hela, 4)
        },
    ]);
    let dance = Dance::new(woman(), &settings).expect("it can be danced");
    let counts = dance.counts(1e9);
    assert_eq!(counts.len(), 3 + 8 + 4 + 2);
    let of_part = |number| {
        counts
            .iter()
            .filter(move |count| count.part == Some(number))
    };
    let first = of_part(1).next().expect("part 1");
    assert!(
        (first.time - 3.0).abs() < 1e-9 && first.number == 1,
        "{first:?}"
    );
    // Ten counts of a second, then two that shrink to half of one.
    let times: Vec<f64> = of_part(2).map(|count| count.time).collect();
    for (time, truth) in times.iter().zip([10.875, 11.5, 12.0, 12.5]) {
        assert!((time - truth).abs() < 1e-9, "{times:?}");
    }
    assert!((dance.duration().expect("it ends") - counts[16].time).abs() < 1e-9);
    // The foot of kāholo is on its way before one, and stands from then on.
    let toes = |time: f32| Moment::of(woman(), dance.pose_at(time)).at(Bone::RightToes);
    assert!(toes(2.8).y > toes(3.0).y + 1e-3);
    assert!(toes(3.0).distance(toes(3.3)) < 1e-5);
}

#[test]
fn a_repeated_step_says_its_counts_for_ever() {
    let dance = Dance::new(woman(), &settings_of(DanceStep::Kao)).expect("it can be danced");
    let counts = dance.counts(7.6);
    // Two counts of lead-in, then one, two, one, two; the last at 7.5 s.
    let numbers: Vec<u32> = counts.iter().map(|count| count.number).collect();
    assert_eq!(numbers, [1, 2, 1, 2, 1, 2, 1, 2, 1, 2, 1]);
    assert!((counts[10].time - 7.5).abs() < 1e-9);
}

#[test]
fn what_cannot_be_danced_is_refused_with_a_sentence() {
    let half = parts_of(vec![Part::new(DanceStep::Kaholo, 6)]);
    let spin = parts_of(vec![Part {
        facing_degrees: 270.0,
        ..Part::new(DanceStep::Kao, 2)
    }]);
    for (settings, words) in [(half, "multiple of 4"), (spin, "at most 180")] {
        let error = Dance::new(woman(), &settings).expect_err("it cannot be danced");
        assert!(error.to_string().contains(words), "{error}");
    }
}

#[test]
fn every_school_can_dance_every_step() {
    for school in SCHOOLS {
        for step in DanceStep::ALL {
            let mut settings = settings_of(step);
            school.apply(&mut settings);
            let mut floor = Floor::default();
            for (time, moment) in moments(woman(), &settings) {
                let said = format!("{step:?} in {}, {time} s", school.id);
                let slide = floor.slide(&moment, &said);
                assert!(slide < 0.005, "{said}: slides {slide} m");
            }
        }
    }
}
