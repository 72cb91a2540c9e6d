//! Every kernel by itself: `cargo bench -p lole_cloth --bench kernel`.
//!
//! Kernels of the real-time method are timed inside of whole frames, by their phase: what comes
//! before has left caches and cloth as it always does. The rest are calls of their own.
#![allow(
    missing_docs,
    clippy::disallowed_methods,
    reason = "criterion's macros write undocumented functions; a bench reads the clock"
)]

use std::hint::black_box;
use std::num::NonZeroU32;
use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::{Vec2, Vec3};
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState};
use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::roofline::SpringStream;
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES, Setup};
use lole_cloth::wind::{Aerodynamics, AirPush, GustyWind, blow};
use lole_cloth::{
    ClothModel, ClothState, GridStep, InstructionSet, Phase, SolverConfig, StepInput, diagnose,
    step, step_observed,
};
use lole_geom::{Capsule, Surfel, trig};

/// Frames before the measurement: the cloth has fallen and lies on the body.
const WARM_UP_FRAMES: u32 = 30;

/// Distance of surfels on a body [m], as the dancer has them.
const SURFEL_SPACING: f32 = 0.012;

/// Phases that take less of a frame are not timed: there is nothing for them to do.
const LEAST_SHARE: f64 = 0.005;

/// In which form the cloth meets the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Body {
    Capsules,
    Skin,
}

/// A scene that goes on and on.
struct World {
    scene: &'static ClothScene,
    setup: Setup,
    model: ClothModel,
    state: ClothState,
    pins: Vec<Vec3>,
    body: Body,
    frame: u32,
}

impl World {
    fn new(name: &str, body: Body) -> Self {
        let scene = SCENES.iter().find(|scene| scene.name == name);
        let scene = scene.expect("a scene of the table");
        let setup = (scene.build)();
        let model = ClothModel::new(&setup.spec).expect("the scene is valid");
        let pins = model.pin_indices().iter();
        let mut world = Self {
            scene,
            state: ClothState::new(&model, &setup.positions),
            pins: pins.map(|&pin| setup.positions[pin as usize]).collect(),
            setup,
            model,
            body,
            frame: 0,
        };
        for _ in 0..WARM_UP_FRAMES {
            world.advance(&mut |_| {});
        }
        world
    }

    /// The next frame.
    fn advance(&mut self, passed: &mut dyn FnMut(Phase)) {
        self.frame += 1;
        let capsules = (self.scene.capsules)(f64::from(self.frame) * f64::from(FRAME_DT));
        let (capsules, surfels) = match self.body {
            Body::Capsules => (capsules, Vec::new()),
            Body::Skin => (Vec::new(), skin(&capsules)),
        };
        let input = StepInput {
            pin_targets: &self.pins,
            capsules: &capsules,
            surfels: &surfels,
            ..StepInput::default()
        };
        let step = GridStep {
            model: &self.model,
            config: &self.setup.config,
            input: &input,
            dt: FRAME_DT,
        };
        step_observed(step, &mut self.state, passed).expect("a target for every pin");
    }

    /// Time of a phase in so many frames.
    fn time_of(&mut self, phase: Phase, frame_count: u64) -> Duration {
        let mut sum = Duration::ZERO;
        for _ in 0..frame_count {
            let mut ended = Instant::now();
            self.advance(&mut |passed| {
                let now = Instant::now();
                if passed == phase {
                    sum += now - ended;
                }
                ended = now;
            });
        }
        sum
    }
}

/// The walls of capsules as surfels. All of them, always in the same order: what lies inside of
/// another capsule is no less a surfel there than on a body whose limbs touch.
fn skin(capsules: &[Capsule]) -> Vec<Surfel> {
    let mut surfels = Vec::new();
    for capsule in capsules {
        let [start, end] = capsule.ends;
        let axis = (end - start).normalize_or(Vec3::Y);
        let (side, front) = axis.any_orthonormal_pair();
        let count = |length: f32| (length / SURFEL_SPACING).ceil().max(1.0);
        let rings = count(start.distance(end));
        let around = count(std::f32::consts::TAU * capsule.radii[0]);
        let places =
            (0..=whole(rings)).flat_map(|ring| (0..whole(around)).map(move |at| (ring, at)));
        surfels.extend(places.map(|(ring, at)| {
            let (sin, cos) = trig::sin_cos(std::f32::consts::TAU * f32::from(at) / around);
            let normal = side * cos + front * sin;
            let center = start.lerp(end, f32::from(ring) / rings);
            Surfel {
                position: center + normal * capsule.radii[0],
                normal,
            }
        }));
    }
    surfels
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a limb has a few dozen rings"
)]
const fn whole(count: f32) -> u16 {
    count as u16
}

fn bench_phases(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("phase");
    // A frame is run for every look at a phase, however short that is.
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(20))
        .measurement_time(Duration::from_millis(100));
    for (name, body) in [
        ("hang-128", Body::Capsules),
        ("skirt", Body::Capsules),
        ("skirt", Body::Skin),
        ("gathered", Body::Capsules),
    ] {
        let mut world = World::new(name, body);
        let whole: Duration = Phase::ALL.map(|phase| world.time_of(phase, 4)).iter().sum();
        for phase in Phase::ALL.into_iter().skip(1) {
            if world.time_of(phase, 4).as_secs_f64() < LEAST_SHARE * whole.as_secs_f64() {
                continue;
            }
            let scene = match body {
                Body::Capsules => name.to_owned(),
                Body::Skin => format!("{name}-on-skin"),
            };
            let id = BenchmarkId::new(phase.id(), scene);
            group.bench_function(id, |bencher| {
                bencher.iter_custom(|frame_count| world.time_of(phase, frame_count));
            });
        }
    }
    group.finish();
}

/// The square of a setup as triangles.
fn triangulated(setup: &Setup) -> MeshSpec {
    let grid = &setup.spec.grid;
    let flat = setup
        .positions
        .iter()
        .map(|place| Vec2::new(place.x, place.z));
    MeshSpec {
        pinned: setup.spec.pinned.clone(),
        ..MeshSpec::new(flat.collect(), grid.triangles(), setup.spec.fabric)
    }
}

fn bench_calls(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("call");
    let World {
        setup,
        model,
        mut state,
        pins,
        ..
    } = World::new("hang-64", Body::Capsules);
    let input = StepInput {
        pin_targets: &pins,
        ..StepInput::default()
    };
    let mut positions = Vec::new();
    state.copy_positions(&model, &mut positions);
    group.bench_function("diagnose-strain", |bencher| {
        bencher.iter(|| diagnose::strain(&setup.spec, black_box(&positions)));
    });
    group.bench_function("diagnose-self-crossings", |bencher| {
        bencher.iter(|| diagnose::self_crossings(&setup.spec.grid, black_box(&positions)));
    });
    let explicit = ExplicitModel::new(&setup.spec).expect("the scene is valid");
    let mut moving = state.clone();
    group.bench_function("explicit-rows-frame", |bencher| {
        bencher
            .iter(|| explicit_rows::step(&explicit, &setup.config, &input, &mut moving, FRAME_DT));
    });
    let spec = triangulated(&setup);
    let mesh_model = MeshModel::new(&spec).expect("the square is valid");
    let mut mesh_state = MeshState::new(&mesh_model, &setup.positions);
    let config = SolverConfig {
        structural_sweep_count: NonZeroU32::MIN,
        ..setup.config.clone()
    };
    group.bench_function("mesh-frame", |bencher| {
        bencher.iter(|| mesh::step(&mesh_model, &config, &input, &mut mesh_state, FRAME_DT));
    });
    let air = AirPush {
        law: Aerodynamics::default(),
        wind: &GustyWind::new(Vec3::X * 3.0, 0.3, 1).at(1.0),
        dt: FRAME_DT,
    };
    // The step keeps the cloth where cloth is, so that the wind does not blow it away; its time is
    // not counted.
    group.bench_function("wind-plates", |bencher| {
        bencher.iter_custom(|frame_count| {
            let mut sum = Duration::ZERO;
            for _ in 0..frame_count {
                let start = Instant::now();
                blow(&model, air, InstructionSet::Detected, &mut state);
                sum += start.elapsed();
                step(&model, &setup.config, &input, &mut state, FRAME_DT)
                    .expect("a target for every pin");
            }
            sum
        });
    });
    let mut stream = SpringStream::new(model.spec().grid.particle_count());
    group.bench_function("spring-stream", |bencher| {
        bencher.iter(|| stream.pass(InstructionSet::Detected));
    });
    group.finish();
}

criterion_group!(benches, bench_phases, bench_calls);
criterion_main!(benches);
