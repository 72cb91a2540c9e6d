//! Small random scenes by a seed, made to drive cloth through itself: sheets, tubes, rolls and piles of
//! pieces, thrown, pinned and dragged through themselves, swept by capsules and surfels.
//! Whether they cross is asked of exact predicates in every frame.
#![allow(dead_code, reason = "every test file uses some of it")]

mod body;
mod cloth;
mod drive;

use std::fmt::Write as _;

use glam::Vec3;
use lole_geom::{Chance, trig};

use crate::exact_support::{Pair, Surface, Touching};
use body::Body;
use cloth::Cloth;
use drive::Drive;

/// Frames of a scene.
pub(crate) const FRAME_COUNT: u32 = 80;

/// Duration of a frame [s].
const DT: f32 = 1.0 / 60.0;

/// One random scene.
pub(crate) struct RandomScene {
    /// What is in it.
    pub(crate) about: String,
    cloth: Cloth,
    body: Body,
    drive: Drive,
    surface: Surface,
    chance: Chance,
    frame: u32,
}

/// What became of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Verdict {
    /// Frames that were run and looked at, but for the start.
    pub(crate) frame_count: u32,
    /// Whether the start crosses already, or touches itself: then nothing was run.
    pub(crate) starts_crossed: bool,
    /// The first frame that ends with crossings, and all of them.
    pub(crate) crossed: Option<(u32, Vec<Pair>)>,
    /// Edges and triangles that touch and do not cross, in all frames.
    pub(crate) touching_count: usize,
    /// Steps that were not taken, because they would have led nowhere.
    pub(crate) held_count: u32,
}

impl RandomScene {
    /// The scene of a seed. Same seed, same bits.
    pub(crate) fn draw(seed: u64) -> Self {
        let mut chance = Chance::new(seed);
        let mut about = String::new();
        let cloth = Cloth::draw(&mut chance, &mut about);
        let body = Body::draw(&mut chance, &mut about);
        let drive = Drive::draw(&mut chance, &cloth, &mut about);
        write!(about, ", {} particles", cloth.positions().len()).expect("a string takes all");
        Self {
            surface: Surface::new(&cloth.triangles, &cloth.positions()),
            about,
            cloth,
            body,
            drive,
            chance,
            frame: 0,
        }
    }

    /// Every edge that goes through a triangle, but for those that a seam makes neighbors.
    pub(crate) fn crossings(&mut self, touching: Touching) -> Vec<Pair> {
        self.crossings_at(&self.cloth.positions(), touching)
    }

    /// Every edge that goes through a triangle with the particles at other positions [m], but for those that a
    /// seam makes neighbors.
    pub(crate) fn crossings_at(&mut self, positions: &[Vec3], touching: Touching) -> Vec<Pair> {
        let mut pairs = self.surface.crossings(positions, touching);
        let names = &self.cloth.names;
        let name = |particle: u32| names[particle as usize];
        pairs.retain(|(edge, corners)| {
            let mut corners = corners.iter().map(|&it| name(it));
            !corners.any(|corner| edge.iter().any(|&end| name(end) == corner))
        });
        pairs
    }

    /// Moves on by a frame; whether the step was taken.
    pub(crate) fn advance(&mut self) -> bool {
        if self.frame.is_multiple_of(self.drive.throw_interval) && 0.0 < self.drive.throw_speed {
            let waves = waves(&mut self.chance, self.drive.throw_speed);
            self.cloth.throw(&waves);
        }
        self.frame += 1;
        let capsules = self.body.move_on(&mut self.chance);
        let pins = self.drive.move_on(&mut self.chance);
        self.cloth.step((&capsules, &self.body.surfels), &pins, DT)
    }

    /// Where everything is [m].
    pub(crate) fn positions(&self) -> Vec<Vec3> {
        self.cloth.positions()
    }
}

/// Runs the scene of a seed and looks at every frame, up to the first that crosses.
pub(crate) fn judge(seed: u64, frame_count: u32) -> Verdict {
    let mut scene = RandomScene::draw(seed);
    let mut verdict = Verdict {
        frame_count: 0,
        starts_crossed: !scene.crossings(Touching::Counts).is_empty(),
        crossed: None,
        touching_count: 0,
        held_count: 0,
    };
    while verdict.frame_count < frame_count && !verdict.starts_crossed {
        verdict.held_count += u32::from(!scene.advance());
        verdict.frame_count += 1;
        assert!(
            scene.positions().iter().all(|it| it.is_finite()),
            "{seed}: frame {}",
            verdict.frame_count
        );
        let all = scene.crossings(Touching::Counts).len();
        if all == 0 {
            continue;
        }
        let pairs = scene.crossings(Touching::IsFine);
        verdict.touching_count += all - pairs.len();
        if !pairs.is_empty() {
            verdict.crossed = Some((verdict.frame_count, pairs));
            break;
        }
    }
    verdict
}

/// Velocities [m/s] that throw folds against each other, by place [m].
fn waves(chance: &mut Chance, speed: f32) -> impl Fn(Vec3) -> Vec3 + use<> {
    let mut draw =
        |low: f32, high: f32| Vec3::from_array([(); 3].map(|()| chance.between(low, high)));
    let waves = [(); 3].map(|()| (draw(-60.0, 60.0), draw(-speed, speed), draw(0.0, 6.0).x));
    move |place| {
        let each = waves.iter();
        each.map(|(number, reach, phase)| *reach * trig::sin(number.dot(place) + *phase))
            .sum()
    }
}
