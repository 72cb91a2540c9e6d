//! Random motion by a seed: what a body and the air do, as smooth as bodies and air are.

use glam::Vec3;
use lole_cloth::scenes::FRAME_DT;
use lole_geom::{Chance, trig};

/// Frames from one random place to the next, least and most: a third of a second to a second and
/// a half.
const FRAME_RANGE: [f32; 2] = [20.0, 90.0];

/// How far the body moves from where the scene has it [m].
const SHIFT: Vec3 = Vec3::new(0.12, 0.05, 0.12);
/// How far it turns [rad], to both sides.
const TURN: Vec3 = Vec3::new(0.0, 0.8, 0.0);
/// Fastest wind along each axis [m/s].
const WIND: Vec3 = Vec3::new(6.0, 2.0, 6.0);
/// The scene's own motion runs at up to twice its speed, and may stand still.
const PACE: Vec3 = Vec3::new(1.0, 0.0, 0.0);

/// From -1 to 1.
fn signed(chance: &mut Chance) -> f32 {
    let [high, low, ..] = chance.bits().to_le_bytes();
    f32::from(u16::from_le_bytes([high, low])) / 32_767.5 - 1.0
}

/// A vector that goes from one random place to the next, at rest at both.
#[derive(Debug, Clone)]
struct Wander {
    reach: Vec3,
    from: Vec3,
    to: Vec3,
    frame: f32,
    frame_count: f32,
}

impl Wander {
    const fn new(reach: Vec3) -> Self {
        Self {
            reach,
            from: Vec3::ZERO,
            to: Vec3::ZERO,
            frame: 0.0,
            frame_count: 0.0,
        }
    }

    fn next(&mut self, chance: &mut Chance) -> Vec3 {
        if self.frame_count <= self.frame {
            self.from = self.to;
            self.to = self.reach * Vec3::from_array([(); 3].map(|()| signed(chance)));
            let [least, most] = FRAME_RANGE;
            self.frame_count = (least + (most - least) * (0.5 + 0.5 * signed(chance))).round();
            self.frame = 0.0;
        }
        self.frame += 1.0;
        let share = self.frame / self.frame_count;
        self.from + (self.to - self.from) * (share * share * (3.0 - 2.0 * share))
    }
}

/// Where the body stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    shift: Vec3,
    /// Sine and cosine of its turn about the upright axis.
    turn: (f32, f32),
}

impl Place {
    /// Where a point of the body is.
    pub(super) fn apply(&self, point: Vec3) -> Vec3 {
        let (sin, cos) = self.turn;
        let turned = Vec3::new(
            cos * point.x + sin * point.z,
            point.y,
            cos * point.z - sin * point.x,
        );
        turned + self.shift
    }
}

/// Everything around the cloth at the end of a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct World {
    /// Time of the scene's own motion [s].
    pub(super) time: f64,
    pub(super) place: Place,
    /// [m/s]
    pub(super) air_velocity: Vec3,
}

/// The random motion of one seed.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    chance: Chance,
    shift: Wander,
    turn: Wander,
    wind: Wander,
    pace: Wander,
    time: f64,
}

impl Motion {
    /// At rest, where the scene starts.
    pub(super) const fn new(seed: u64) -> Self {
        Self {
            chance: Chance::new(seed),
            shift: Wander::new(SHIFT),
            turn: Wander::new(TURN),
            wind: Wander::new(WIND),
            pace: Wander::new(PACE),
            time: 0.0,
        }
    }

    /// The next frame.
    pub(super) fn next_frame(&mut self) -> World {
        let chance = &mut self.chance;
        let pace = 1.0 + self.pace.next(chance).x;
        self.time += f64::from(FRAME_DT * pace);
        World {
            time: self.time,
            place: Place {
                shift: self.shift.next(chance),
                turn: trig::sin_cos(self.turn.next(chance).y),
            },
            air_velocity: self.wind.next(chance),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_and_air_move_within_their_reach_and_no_faster_than_people_do() {
        let mut motion = Motion::new(3);
        let hip = Vec3::new(0.1, 0.0, 0.0);
        let mut last = hip;
        let mut farthest = 0.0_f32;
        for _ in 0..20_000 {
            let world = motion.next_frame();
            let now = world.place.apply(hip);
            let speed = now.distance(last) / FRAME_DT;
            assert!(speed < 2.0, "{speed} m/s");
            assert!((now - hip).abs().max_element() < 0.25);
            assert!(world.air_velocity.abs().cmple(WIND).all());
            farthest = farthest.max(world.place.shift.x.abs());
            last = now;
        }
        assert!(0.1 < farthest, "it moves at all: {farthest} m");
        let whole = 20_000.0 * f64::from(FRAME_DT);
        assert!((0.8..1.2).contains(&(motion.time / whole)));
    }

    #[test]
    fn a_turn_keeps_distances() {
        let place = Place {
            shift: Vec3::ONE,
            turn: trig::sin_cos(0.6),
        };
        let (a, b) = (Vec3::new(0.3, -0.2, 0.1), Vec3::new(-0.1, 0.4, 0.2));
        let apart = place.apply(a).distance(place.apply(b));
        assert!((apart - a.distance(b)).abs() < 1e-6);
    }
}
