//! Laws of air against cells: terminal speed, friction, symmetry, gusts, strong wind.

mod xpbd_support;

use glam::Vec3;
use lole_cloth::wind::{Aerodynamics, AirPush, GustyWind, WindNow, blow};
use lole_cloth::{ClothModel, ClothState, Fabric, InstructionSet, MassLaw, diagnose, state_hash};
use xpbd_support::{DT, FABRIC, World, flat_positions, mean, sheet_spec};

const AIR: Aerodynamics = Aerodynamics {
    air_density: 1.2,
    normal_coefficient: 1.17,
    tangential_coefficient: 0.02,
};

/// A level sheet of 0.6 m by 0.4 m that weighs the same everywhere.
fn sheet(drag_rate: f32) -> World {
    let mut spec = sheet_spec(
        31,
        21,
        0.02,
        Fabric {
            drag_rate,
            ..FABRIC
        },
    );
    spec.mass = MassLaw::AreaWeighted;
    World::new(&spec, &flat_positions(31, 21, 0.02))
}

const fn push(wind: &WindNow) -> AirPush<'_> {
    AirPush {
        law: AIR,
        wind,
        dt: DT,
    }
}

fn blow_once(world: &mut World, wind: &WindNow) {
    let set = world.config.instruction_set;
    blow(&world.model, push(wind), set, &mut world.state);
}

#[test]
fn a_level_sheet_falls_at_the_speed_at_which_air_carries_it() {
    let mut world = sheet(0.0);
    let still = WindNow::steady(Vec3::ZERO);
    let mut heights = Vec::new();
    for _ in 0..120 {
        blow_once(&mut world, &still);
        world.step(&[]);
        heights.push(mean(&world.positions()).y);
    }
    let speed = (heights[89] - heights[119]) / (30.0 * DT);
    let weight = FABRIC.areal_density * 9.81;
    let truth = (2.0 * weight / (AIR.air_density * AIR.normal_coefficient)).sqrt();
    assert!(
        (speed / truth - 1.0).abs() < 0.01,
        "{speed} and not {truth} m/s"
    );
}

#[test]
fn a_sheet_along_the_wind_feels_only_friction() {
    let mut world = sheet(0.0);
    let wind = WindNow::steady(Vec3::X * 10.0);
    blow_once(&mut world, &wind);
    let velocity = mean(&world.velocities());
    // `F / M = ½ ρ C_t u² / areal density`, hardly less at the end of the frame.
    let truth =
        0.5 * AIR.air_density * AIR.tangential_coefficient * 100.0 / FABRIC.areal_density * DT;
    assert!(
        (velocity.x / truth - 1.0).abs() < 0.02,
        "{velocity} and not {truth}"
    );
    assert!(
        velocity.y.abs() + velocity.z.abs() < 1e-6 * truth,
        "{velocity}"
    );
}

#[test]
fn an_inclined_sheet_is_lifted_along_its_normal() {
    let mut world = sheet(0.0);
    // Nose down by a slope of 3 in 4: the normal is (0.6, 0.8, 0).
    let tilted: Vec<Vec3> = (world.positions().iter())
        .map(|p| Vec3::new(0.8 * p.x, -0.6 * p.x, p.z))
        .collect();
    world.state.set_positions(&world.model, &tilted);
    let gentle = WindNow::steady(Vec3::X * 0.1);
    blow_once(&mut world, &gentle);
    let velocity = mean(&world.velocities());
    let across = 0.5 * AIR.air_density * AIR.normal_coefficient * 0.06 * 0.06;
    let along = 0.5 * AIR.air_density * AIR.tangential_coefficient * 0.08 * 0.08;
    let truth = (Vec3::new(0.6, 0.8, 0.0) * across + Vec3::new(0.8, -0.6, 0.0) * along)
        * (DT / FABRIC.areal_density);
    assert!(
        velocity.distance(truth) < 0.01 * truth.length(),
        "{velocity} and not {truth}"
    );
}

#[test]
fn a_mirrored_wind_mirrors_the_cloth() {
    let run = |sign: f32| {
        let mut world = sheet(0.5);
        let wind = WindNow::steady(Vec3::new(3.0, 0.5 * sign, 1.0));
        for _ in 0..20 {
            blow_once(&mut world, &wind);
            world.config.gravity = Vec3::ZERO;
            world.step(&[]);
        }
        world.positions()
    };
    let (up, down) = (run(1.0), run(-1.0));
    for (up, down) in up.iter().zip(&down) {
        let mirrored = Vec3::new(down.x, -down.y, down.z);
        assert!(up.distance(mirrored) < 1e-6, "{up} and {mirrored}");
    }
}

#[test]
fn gusts_have_no_mean_of_their_own_and_the_strength_that_was_asked_for() {
    let mean_wind = Vec3::new(4.0, 0.0, 3.0);
    for seed in [1, 2, 77] {
        let wind = GustyWind::new(mean_wind, 0.2, seed);
        let (mut sum, mut squares, mut count) = (glam::DVec3::ZERO, 0.0, 0.0);
        for frame in 0..20_000_u32 {
            let now = wind.at(f64::from(frame) * 0.11);
            let place =
                Vec3::new(0.3, 0.7, -0.2) * f32::from(u8::try_from(frame % 7).expect("few"));
            let gust = (now.velocity(place) - mean_wind).as_dvec3();
            sum += gust;
            squares += gust.length_squared() / 3.0;
            count += 1.0;
        }
        let rms = f64::sqrt(squares / count);
        assert!(
            sum.length() / count < 0.03,
            "seed {seed}: mean {}",
            sum / count
        );
        assert!(
            (rms - 1.0).abs() < 0.03,
            "seed {seed}: {rms} and not 0.2 · 5 m/s"
        );
    }
}

#[test]
fn gusts_are_smooth_and_belong_to_their_seed() {
    let wind = |seed| GustyWind::new(Vec3::X * 5.0, 0.3, seed);
    let place = Vec3::new(0.1, 1.0, 0.2);
    assert_eq!(
        wind(3).at(1.5).velocity(place),
        wind(3).at(1.5).velocity(place)
    );
    assert!(
        0.1 < wind(3)
            .at(1.5)
            .velocity(place)
            .distance(wind(4).at(1.5).velocity(place))
    );
    let (mut jump, mut last) = (0.0_f32, wind(3).at(0.0).velocity(place));
    for millisecond in 1..5000_u16 {
        let now = wind(3).at(1e-3 * f64::from(millisecond)).velocity(place);
        jump = jump.max(now.distance(last));
        last = now;
    }
    // The shortest wave of 0.4 m passes in 80 ms with about 1 m/s.
    assert!(jump < 0.25, "{jump} m/s in a millisecond");
}

#[test]
fn a_flag_in_a_storm_stays_finite_and_whole() {
    let mut spec = sheet_spec(
        31,
        21,
        0.02,
        Fabric {
            drag_rate: 1.0,
            ..FABRIC
        },
    );
    for row in 0..21 {
        spec.pinned[row * 31] = true;
    }
    let mut world = World::new(&spec, &flat_positions(31, 21, 0.02));
    let wind = GustyWind::new(Vec3::new(40.0, 0.0, 5.0), 0.3, 9);
    for frame in 0..240_u32 {
        blow_once(&mut world, &wind.at(f64::from(frame) * f64::from(DT)));
        world.step(&[]);
        assert_eq!(diagnose::first_non_finite(&world.positions()), None);
    }
    let strain = diagnose::strain(&spec, &world.positions());
    // Its own force stretches such cloth by a tenth, and gusts jerk it.
    assert!(strain.p99 < 0.3, "{strain:?}");
    let speed = diagnose::rms_speed(&world.velocities());
    assert!(speed < 60.0, "{speed} m/s");
}

#[test]
fn the_wind_has_the_same_bits_with_all_vector_instructions() {
    let spec = sheet_spec(37, 21, 0.02, FABRIC);
    let model = ClothModel::new(&spec).expect("the cloth is valid");
    let wind = GustyWind::new(Vec3::new(3.0, 1.0, 5.0), 0.3, 9).at(2.5);
    let hash = |set| {
        let mut state = ClothState::new(&model, &flat_positions(37, 21, 0.02));
        blow(&model, push(&wind), set, &mut state);
        state_hash(&state)
    };
    let detected = hash(InstructionSet::Detected);
    assert_eq!(detected, hash(InstructionSet::Wide));
    assert_eq!(detected, hash(InstructionSet::Baseline));
}
