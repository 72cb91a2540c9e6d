//! Spring bones as VRM 1.0 simulates them, and the settings with which they come nearest to a take.
//!
//! For a joint whose tail was at `x` and before at `y`: `next = x + (x - y)(1 - drag) + dt · stiffness · axis +
//! dt · gravity`, brought to the joint's length and out of the colliders (`VRMC_springBone` 1.0, "Algorithm").

use glam::{Affine3A, Quat, Vec3};
use lole_geom::Capsule;
use rayon::prelude::*;

use super::chains::{Chains, LEVELS, NODES, SECTORS};
use super::{VrmFigures, comes_through};

/// Frames in a second that players simulate springs at.
const PLAYED_RATE: u32 = 60;
/// How far joints keep from colliders [m]: cloth and what it folds.
pub(super) const HIT_RADIUS: f32 = 0.012;
/// Frames that chains hang in the first pose before the take.
const WARM_UP: u32 = 120;
/// Settings that are tried first.
const STIFFNESS: [f32; 6] = [0.02, 0.1, 0.3, 0.8, 2.0, 4.0];
const DRAG: [f32; 5] = [0.05, 0.2, 0.4, 0.6, 0.9];
const GRAVITY: [f32; 5] = [0.0, 0.1, 0.3, 0.8, 2.0];
/// Rounds in which the best ones are improved; the step is halved where none around it is better.
const ROUNDS: usize = 10;

/// Settings of all joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Settings {
    pub(super) stiffness: f32,
    pub(super) drag: f32,
    pub(super) gravity: f32,
}

impl Settings {
    /// These first, and all that are a step away in some of the three.
    fn around(self, factor: f32, step: f32) -> Vec<Self> {
        let mut near = vec![self];
        let factors = [1.0, 1.0 / factor, factor];
        for stiffer in factors {
            for heavier in factors {
                for change in [0.0, -step, step] {
                    near.push(Self {
                        stiffness: (self.stiffness * stiffer).min(4.0),
                        drag: (self.drag + change).clamp(0.0, 1.0),
                        gravity: self.gravity * heavier,
                    });
                }
            }
        }
        near
    }
}

/// What the take was, as chains are compared with it.
pub(super) struct Track {
    frame_rate: u32,
    /// Hips in each frame, from where they rest.
    hips: Vec<Affine3A>,
    legs: Vec<Vec<Capsule>>,
    /// Where the hanging vertices were, in frames that are compared.
    places: Vec<Option<Vec<Vec3>>>,
    /// Mean place of the vertices about each joint, in the same frames.
    targets: Vec<Option<Vec<[Option<Vec3>; NODES]>>>,
    near: Vec<[Vec<usize>; NODES]>,
}

impl Track {
    pub(super) fn new(frame_rate: u32, chains: &Chains) -> Self {
        Self {
            frame_rate,
            hips: Vec::new(),
            legs: Vec::new(),
            places: Vec::new(),
            targets: Vec::new(),
            near: chains.near.clone(),
        }
    }

    pub(super) fn push(&mut self, hips: Affine3A, legs: Vec<Capsule>, places: Option<Vec<Vec3>>) {
        let mean = |vertices: &Vec<usize>, places: &[Vec3]| {
            let sum: Vec3 = vertices.iter().map(|&vertex| places[vertex]).sum();
            (!vertices.is_empty()).then(|| sum / vertices.len() as f32)
        };
        let targets = places.as_ref().map(|places| {
            let chains = self.near.iter();
            let chains = chains.map(|nodes| std::array::from_fn(|it| mean(&nodes[it], places)));
            chains.collect()
        });
        self.hips.push(hips);
        self.legs.push(legs);
        self.places.push(places);
        self.targets.push(targets);
    }
}

/// A chain as it moves.
struct Moving {
    now: [Vec3; LEVELS],
    before: [Vec3; LEVELS],
}

/// Joints as they are: where each is, and its turn from rest.
pub(super) type Posed = Vec<[(Vec3, Quat); LEVELS]>;

/// All chains, step by step.
struct Simulation<'a> {
    chains: &'a Chains,
    settings: Settings,
    moving: Vec<Moving>,
    posed: Posed,
}

impl<'a> Simulation<'a> {
    fn new(chains: &'a Chains, settings: Settings, hips: Affine3A) -> Self {
        let tails = chains.rest.iter().map(|rest| {
            let now = std::array::from_fn(|it| hips.transform_point3(rest[it + 1]));
            Moving { now, before: now }
        });
        Self {
            moving: tails.collect(),
            posed: vec![[(Vec3::ZERO, Quat::IDENTITY); LEVELS]; SECTORS],
            chains,
            settings,
        }
    }

    fn step(&mut self, hips: Affine3A, legs: &[Capsule], dt: f32) {
        let (_, turn, _) = hips.to_scale_rotation_translation();
        let Settings {
            stiffness,
            drag,
            gravity,
        } = self.settings;
        let chains = self.chains.rest.iter().zip(&mut self.moving);
        for ((rest, moving), posed) in chains.zip(&mut self.posed) {
            let (mut turn, mut root) = (turn, hips.transform_point3(rest[0]));
            for joint in 0..LEVELS {
                let along = rest[joint + 1] - rest[joint];
                let length = along.length().max(1.0e-4);
                let axis = turn * (along / length);
                let inertia = (moving.now[joint] - moving.before[joint]) * (1.0 - drag);
                let pull = dt * (stiffness * axis + gravity * Vec3::NEG_Y);
                let on = |place: Vec3| root + length * (place - root).normalize_or(axis);
                let mut next = on(moving.now[joint] + inertia + pull);
                for leg in legs {
                    next = pushed_out(leg, next).map_or(next, on);
                }
                moving.before[joint] = moving.now[joint];
                moving.now[joint] = next;
                turn = Quat::from_rotation_arc(axis, (next - root) / length) * turn;
                posed[joint] = (root, turn);
                root = next;
            }
        }
    }

    /// Where a hanging vertex is carried to.
    fn vertex(&self, vertex: usize, hips: Affine3A) -> Vec3 {
        let rest = self.chains.vertices[vertex];
        let carriers = self.chains.carriers[vertex].iter();
        carriers.fold(Vec3::ZERO, |sum, &(carrier, share)| {
            let at = match carrier {
                None => hips.transform_point3(rest),
                Some((chain, joint)) => {
                    let (place, turn) = self.posed[chain][joint];
                    place + turn * (rest - self.chains.rest[chain][joint])
                }
            };
            sum + share * at
        })
    }
}

/// Where a place is pushed by a collider of one radius, the mean of the leg's.
fn pushed_out(leg: &Capsule, place: Vec3) -> Option<Vec3> {
    let along = leg.axis_parameter(place);
    let foot = leg.ends[0].lerp(leg.ends[1], along);
    let reach = radius(leg) + HIT_RADIUS;
    let off = place - foot;
    let far = off.length();
    (far < reach).then(|| foot + off / far.max(1.0e-6) * reach)
}

/// One radius for a capsule that has two.
pub(super) fn radius(leg: &Capsule) -> f32 {
    0.5 * (leg.radii[0] + leg.radii[1])
}

/// Plays the take; `look` is called in every frame.
fn play(
    chains: &Chains,
    track: &Track,
    settings: Settings,
    mut look: impl FnMut(usize, &Simulation<'_>),
) {
    let steps = (PLAYED_RATE / track.frame_rate).max(1);
    let dt = 1.0 / (track.frame_rate * steps) as f32;
    let mut simulation = Simulation::new(chains, settings, track.hips[0]);
    for _ in 0..WARM_UP {
        simulation.step(track.hips[0], &track.legs[0], dt);
    }
    look(0, &simulation);
    for frame in 1..track.hips.len() {
        let [last, next] =
            [frame - 1, frame].map(|it| track.hips[it].to_scale_rotation_translation());
        for step in 1..=steps {
            let share = step as f32 / steps as f32;
            let turn = last.1.slerp(next.1, share);
            let hips = Affine3A::from_rotation_translation(turn, last.2.lerp(next.2, share));
            simulation.step(hips, &track.legs[frame], dt);
        }
        look(frame, &simulation);
    }
}

/// Mean square of the distances between joints and the cloth about them [m²].
fn loss(chains: &Chains, track: &Track, settings: Settings) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    play(chains, track, settings, |frame, simulation| {
        let Some(targets) = &track.targets[frame] else {
            return;
        };
        for (moving, nodes) in simulation.moving.iter().zip(targets) {
            for (tail, target) in moving.now.iter().zip(&nodes[1..]) {
                if let Some(target) = target {
                    sum += f64::from(tail.distance_squared(*target));
                    count += 1.0;
                }
            }
        }
    });
    sum / f64::max(count, 1.0)
}

/// The settings with which the chains come nearest, and how near that is.
pub(super) fn fit(chains: &Chains, track: &Track) -> (Settings, VrmFigures) {
    let mut grid = Vec::new();
    for stiffness in STIFFNESS {
        for drag in DRAG {
            for gravity in GRAVITY {
                grid.push(Settings {
                    stiffness,
                    drag,
                    gravity,
                });
            }
        }
    }
    let mut best = best_of(chains, track, &grid);
    let (mut factor, mut step) = (1.5_f32, 0.1_f32);
    for _ in 0..ROUNDS {
        // Stiffness, drag and gravity make up for each other: a better place lies across their axes.
        let near = best.around(factor, step);
        let better = best_of(chains, track, &near);
        if better == best {
            factor = 1.0 + 0.5 * (factor - 1.0);
            step *= 0.5;
        }
        best = better;
    }
    (best, figures(chains, track, best))
}

/// The first of the settings that leave the least loss.
fn best_of(chains: &Chains, track: &Track, settings: &[Settings]) -> Settings {
    let losses: Vec<f64> = settings
        .par_iter()
        .map(|&it| loss(chains, track, it))
        .collect();
    let places = 0..settings.len();
    let best = places.min_by(|&a, &b| losses[a].total_cmp(&losses[b]));
    settings[best.unwrap_or(0)]
}

fn figures(chains: &Chains, track: &Track, settings: Settings) -> VrmFigures {
    let (mut sum, mut worst, mut count) = (0.0_f64, 0.0_f32, 0.0_f64);
    let (mut frames, mut through) = (0_u32, 0_u32);
    play(chains, track, settings, |frame, simulation| {
        let Some(places) = &track.places[frame] else {
            return;
        };
        let hips = track.hips[frame];
        let carried: Vec<Vec3> = (0..places.len())
            .map(|vertex| simulation.vertex(vertex, hips))
            .collect();
        for (found, wanted) in carried.iter().zip(places) {
            let off = found.distance(*wanted);
            sum += f64::from(off);
            worst = worst.max(off);
            count += 1.0;
        }
        frames += 1;
        through += u32::from(comes_through(&track.legs[frame], &carried, places));
    });
    VrmFigures {
        frames,
        mean_mm: 1000.0 * sum / count.max(1.0),
        worst_mm: 1000.0 * f64::from(worst),
        leg_share: f64::from(through) / f64::from(frames.max(1)),
        settings: [settings.stiffness, settings.drag, settings.gravity],
    }
}

#[cfg(test)]
mod tests {
    use lole_geom::trig;

    use super::super::rest::{Hanging, HangingSurface};
    use super::*;

    const HIPS: Vec3 = Vec3::new(0.0, 0.9, 0.0);

    /// A skirt of a cone, at rest.
    fn chains() -> Chains {
        let mut rest = Vec::new();
        for row in 0..20_u16 {
            for column in 0..64_u16 {
                let down = f32::from(row) / 19.0;
                let (sin, cos) = trig::sin_cos(f32::from(column) / 64.0 * std::f32::consts::TAU);
                let radius = 0.15 + 0.1 * down;
                rest.push(HIPS + Vec3::new(radius * sin, -0.01 - 0.6 * down, radius * cos));
            }
        }
        let surface = HangingSurface {
            mesh: 0,
            vertices: (0..rest.len()).collect(),
            rest,
        };
        Chains::new(
            &Hanging {
                surfaces: vec![surface],
            },
            HIPS,
        )
    }

    /// Hips that sway to and fro for some seconds, without legs.
    fn swaying(chains: &Chains) -> Track {
        let mut track = Track::new(30, chains);
        for frame in 0..90_u16 {
            let sway = 0.08 * trig::sin(0.2 * f32::from(frame));
            let turn = Quat::from_rotation_z(0.8 * sway);
            let about = Affine3A::from_translation(HIPS)
                * Affine3A::from_quat(turn)
                * Affine3A::from_translation(-HIPS);
            track.push(
                Affine3A::from_translation(Vec3::X * sway) * about,
                Vec::new(),
                None,
            );
        }
        track
    }

    #[test]
    fn every_vertex_is_carried_in_whole_and_rests_where_it_is() {
        let chains = chains();
        for carriers in &chains.carriers {
            let sum: f32 = carriers.iter().map(|(_, share)| share).sum();
            assert!((sum - 1.0).abs() < 1.0e-5, "{carriers:?}");
            assert!(carriers.iter().all(|(_, share)| 0.0 <= *share));
        }
        let still = Settings {
            stiffness: 1.0,
            drag: 0.4,
            gravity: 0.0,
        };
        let mut simulation = Simulation::new(&chains, still, Affine3A::IDENTITY);
        for _ in 0..60 {
            simulation.step(Affine3A::IDENTITY, &[], 1.0 / 60.0);
        }
        for (vertex, place) in chains.vertices.iter().enumerate() {
            let off = simulation
                .vertex(vertex, Affine3A::IDENTITY)
                .distance(*place);
            assert!(off < 1.0e-4, "{off} m");
        }
    }

    #[test]
    fn settings_that_made_a_sway_are_found_again() {
        let chains = chains();
        let made = Settings {
            stiffness: 0.5,
            drag: 0.3,
            gravity: 0.2,
        };
        let still = swaying(&chains);
        let mut track = Track::new(30, &chains);
        play(&chains, &still, made, |frame, simulation| {
            let hips = still.hips[frame];
            let places = 0..chains.vertices.len();
            let places = places.map(|vertex| simulation.vertex(vertex, hips));
            track.push(hips, Vec::new(), Some(places.collect()));
        });
        let (found, figures) = fit(&chains, &track);
        assert!(figures.mean_mm < 3.0, "{found:?} {figures:?}");
        assert!(figures.mean_mm <= figures.worst_mm);
        let stiff = Settings {
            stiffness: 4.0,
            ..made
        };
        assert!(loss(&chains, &track, found) < 0.2 * loss(&chains, &track, stiff));
    }

    #[test]
    fn joints_stay_out_of_legs() {
        let chains = chains();
        let leg = Capsule::uniform(Vec3::new(0.2, 0.9, 0.0), Vec3::new(0.3, 0.2, 0.0), 0.08);
        let soft = Settings {
            stiffness: 0.3,
            drag: 0.5,
            gravity: 0.3,
        };
        let mut simulation = Simulation::new(&chains, soft, Affine3A::IDENTITY);
        for _ in 0..120 {
            simulation.step(Affine3A::IDENTITY, &[leg], 1.0 / 60.0);
        }
        for moving in &simulation.moving {
            for tail in moving.now {
                // A joint keeps its length, so that it may come a little into what pushes it.
                assert!(-0.004 < leg.signed_distance(tail), "{tail}");
            }
        }
    }
}
