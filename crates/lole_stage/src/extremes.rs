//! Laws of a whole performance where bodies do what is hard for cloth: it stays finite, hardly
//! stretches, and no skin comes through.

use std::thread;

use glam::{Quat, Vec3};
use lole_body::{Bone, Pose};
use lole_costume::document::{Design, LinkedFile};
use lole_geom::trig;
use lole_hula::DanceStep;

use crate::{FRAME_SECONDS, Performance, Production, RunMetrics};

/// Frames from one look at the skin to the next.
const FRAMES_PER_LOOK: u32 = 6;

/// A skirt with less cloth than the film's, so that the laws are quick.
fn design() -> Design {
    let mut design = Design::default();
    design.skirt.gather_ratio = 2.0;
    design.skirt.column_count = 160;
    design.skirt.row_count = 40;
    design
}

fn settled(design: &Design) -> Performance {
    let mut performance = Performance::new(Production::new(design).unwrap()).unwrap();
    for _ in 0..Performance::settle_frame_count() {
        performance.advance().unwrap();
    }
    performance
}

/// Looks at every few frames of some seconds, in which `advance` moves the performance on to a time
/// [s].
fn look(
    mut performance: Performance,
    seconds: f32,
    mut advance: impl FnMut(&mut Performance, f32),
) -> RunMetrics {
    let mut metrics = Vec::new();
    let mut time = 0.0;
    let mut frame = 0_u32;
    while time < seconds {
        time += FRAME_SECONDS;
        frame += 1;
        advance(&mut performance, time);
        if frame.is_multiple_of(FRAMES_PER_LOOK) {
            performance.pose_body();
            metrics.push(performance.measure());
        }
    }
    RunMetrics::of(&metrics)
}

fn check(name: &str, found: RunMetrics, (most_strain, deepest): (f32, f32)) {
    let (strain, depth) = (found.strain.p99, found.skin.worst_depth);
    assert!(strain < most_strain, "{name}: {strain}");
    assert!(depth < deepest, "{name}: {depth} m");
    assert_eq!(found.skin.showing_body_vertices, 0, "{name}");
}

/// What legs that cross may do: between them there is less room than cloth keeps from both, and they give
/// way to it.
fn check_between_legs(name: &str, found: RunMetrics) {
    let (strain, depth) = (found.strain.p99, found.skin.worst_depth);
    assert!(strain < 0.15, "{name}: {strain}");
    assert!(depth < 5.0e-3, "{name}: {depth} m");
    let showing = found.skin.showing_body_vertices;
    assert!(showing <= 8, "{name}: {showing} vertices of skin show");
}

/// Steps that keep the skirt in one piece at 240 counts a minute, twice what is danced.
const AT_DOUBLE_TEMPO: [DanceStep; 4] = [
    DanceStep::Kao,
    DanceStep::Kaholo,
    DanceStep::Ami,
    DanceStep::Uwehe,
];

/// At double tempo the belly bulges between two casings. A quarter turn of the body in a beat would
/// be a pirouette then, so that most steps are held to the fastest tempo they are danced at.
#[test]
fn every_step_at_its_fastest_tempo() {
    // Two at a time: this is the longest of all tests.
    thread::scope(|scope| {
        for part in 0..2 {
            scope.spawn(move || {
                let steps = DanceStep::ALL.into_iter().skip(part).step_by(2);
                steps.for_each(at_fastest_tempo);
            });
        }
    });
}

fn at_fastest_tempo(step: DanceStep) {
    let [_, fastest] = step.tempo();
    let doubled = AT_DOUBLE_TEMPO.contains(&step);
    let mut design = design();
    design.motion.step = step;
    design.motion.tempo_bpm = if doubled { 240.0 } else { f64::from(fastest) };
    let found = look(settled(&design), 2.0, |performance, _| {
        performance.advance().unwrap();
    });
    // Where folds come to cross, skin gives way to all that is held back for them.
    check(step.id(), found, (0.2, 3.0e-3));
}

/// Poses that no step has, from 0 at the stance to 1 at the utmost, and how they go to and fro.
#[test]
fn turning_circling_crossing_and_pinching() {
    let stance = settled(&design());
    let base = stance.pose().clone();
    // Comes in within half a second, or the stance would jump.
    let ease = |time: f32| (2.0 * time).min(1.0);
    let wave =
        |time: f32, hertz: f32| trig::sin_cos(std::f32::consts::TAU * ((hertz * time) % 1.0));
    let turned = |pose: &mut Pose, bone: Bone, turn: Quat| {
        let rotation = &mut pose.rotations[bone.index()];
        *rotation = turn * *rotation;
    };
    type Motion<'a> = (&'static str, Box<dyn Fn(f32, &mut Pose) + 'a>);
    let motions: [Motion<'_>; 4] = [
        (
            "a turn of 180° a second",
            Box::new(|time, pose| {
                let angle = std::f32::consts::PI * (time - 0.25 * (2.0 * time).min(1.0));
                turned(
                    pose,
                    Bone::Hips,
                    Quat::from_rotation_y(angle % std::f32::consts::TAU),
                );
            }),
        ),
        (
            "hips circling at 2.5 Hz",
            Box::new(|time, pose| {
                let (sin, cos) = wave(time, 2.5);
                pose.hips_translation += Vec3::new(sin, 0.0, cos) * (0.05 * ease(time));
            }),
        ),
        (
            "legs crossing",
            Box::new(|time, pose| {
                let (sin, _) = wave(time, 0.75);
                let across = 0.3 * ease(time) * (0.5 - 0.5 * sin);
                turned(
                    pose,
                    Bone::LeftUpperLeg,
                    Quat::from_rotation_x(-across) * Quat::from_rotation_z(-across),
                );
                turned(
                    pose,
                    Bone::RightUpperLeg,
                    Quat::from_rotation_x(across) * Quat::from_rotation_z(across),
                );
            }),
        ),
        (
            "a skirt pinched between knees",
            Box::new(|time, pose| {
                let (sin, _) = wave(time, 1.0);
                let apart = ease(time) * (0.12 + 0.2 * sin);
                for (side, leg) in [(1.0, Bone::LeftUpperLeg), (-1.0, Bone::RightUpperLeg)] {
                    turned(pose, leg, Quat::from_rotation_z(side * apart));
                }
            }),
        ),
    ];
    for (name, motion) in motions {
        let found = look(stance.clone(), 3.0, |performance, time| {
            let mut pose = base.clone();
            motion(time, &mut pose);
            performance.advance_in(pose).unwrap();
        });
        if name == "legs crossing" {
            check_between_legs(name, found);
        } else {
            // A band on the skin follows hips that are thrown at more than the weight of the cloth.
            let deepest = if name.starts_with("hips") {
                2.0e-3
            } else {
                0.5e-3
            };
            check(name, found, (0.15, deepest));
        }
    }
}

/// Recorded dancers wear no skirt: their arms hang where its folds are, and in the hips of another
/// body.
#[test]
fn hands_pressed_into_the_hips_neither_tear_nor_carry_away_the_skirt() {
    let mut stance = settled(&design());
    let base = stance.pose().clone();
    let skeleton = stance.production().dancer.skeleton.clone();
    let arms = [
        (1.0, Bone::LeftUpperArm, Bone::LeftLowerArm, Bone::LeftHand),
        (
            -1.0,
            Bone::RightUpperArm,
            Bone::RightLowerArm,
            Bone::RightHand,
        ),
    ];
    let mut deepest_hand = f32::INFINITY;
    let mut worst_strain = 0.0_f32;
    let mut time = 0.0;
    while time < 3.0 {
        time += FRAME_SECONDS;
        let (sin, _) = trig::sin_cos(std::f32::consts::TAU * 0.7 * time);
        let mut pose = base.clone();
        for (side, upper, lower, hand) in arms {
            let along = (skeleton.joint(lower) - skeleton.joint(upper)).normalize_or_zero();
            let hanging = Vec3::new(side * (0.1 - 0.35 * sin), -1.0, 0.0).normalize_or_zero();
            pose.rotations[upper.index()] = Quat::from_rotation_arc(along, hanging);
            pose.rotations[lower.index()] = Quat::IDENTITY;
            pose.rotations[hand.index()] = Quat::IDENTITY;
        }
        stance.advance_in(pose).unwrap();
        let hand = stance.world_from_bind()[Bone::LeftHand.index()];
        deepest_hand = deepest_hand.min(hand.transform_point3(skeleton.joint(Bone::LeftHand)).x);
        worst_strain = worst_strain.max(stance.measure().strain.p99);
    }
    assert!(worst_strain < 0.15, "{worst_strain}");
    assert!(deepest_hand < 0.15, "the hands press: {deepest_hand}");
    let grid = &stance.production().skirt().unwrap().sewn.spec.grid;
    let crossings = lole_cloth::diagnose::self_crossings(grid, stance.cloth_positions());
    assert_eq!(crossings, Some(0));
}

/// A recording of the CMU database (subject 1, trial 1: a deep crouch and a leap within 2.4 s),
/// where the folder that `LOLE_ASSETS` names holds it.
#[test]
#[expect(clippy::print_stderr, reason = "says why nothing was tested")]
fn a_recorded_leap_leaves_the_skirt_whole() {
    let name = "cmu_01_01.bvh";
    let folder = std::env::var("LOLE_ASSETS").unwrap_or_default();
    let bytes = match std::fs::read(std::path::Path::new(&folder).join(name)) {
        Ok(bytes) => bytes,
        Err(error) => {
            eprintln!("skipped: LOLE_ASSETS names no folder with {name} ({error})");
            return;
        }
    };
    let mut design = design();
    design.motion.file = Some(LinkedFile {
        name: name.to_owned(),
        bytes: Some(bytes.into()),
    });
    let mut performance = settled(&design);
    let mut worst = 0.0_f32;
    while performance.time() < 2.6 {
        performance.advance().unwrap();
        worst = worst.max(performance.measure().strain.p99);
    }
    // Belly and thighs press the casings together while she crouches.
    assert!(worst < 0.4, "{worst}");
    let after = performance.measure().strain.p99;
    assert!(after < 0.15, "{after}");
}
