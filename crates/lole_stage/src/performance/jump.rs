//! Where a recording jumps: told from how hips go on.

use glam::Vec3;

use super::FRAME_SECONDS;

/// Hips that are farther than this from where they would have been at the speed of the frame before [m]
/// have jumped: five times the acceleration of free fall.
const JUMP: f32 = 5.0 * 9.81 * FRAME_SECONDS * FRAME_SECONDS;

/// What a jump does to all that she carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jump {
    /// How far it goes beside what it does by itself [m].
    pub(super) by: Vec3,
    /// What it has become faster by [m/s]: a jump that goes on is a speed.
    pub(super) faster: Vec3,
}

/// Where hips are, and how they came there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hips {
    place: Vec3,
    /// What they did in the last frame, and in the last one in which they did not jump [m].
    moved: Vec3,
    went: Vec3,
}

impl Hips {
    /// Goes on to a place [m]; what of that she did not do by herself.
    ///
    /// What is done twice is a speed: a recording may begin in the middle of a run, or somebody who sat is
    /// up in no time.
    pub(super) fn follow(hips: &mut Option<Self>, place: Vec3) -> Option<Jump> {
        let Some(before) = *hips else {
            *hips = Some(Self {
                place,
                moved: Vec3::ZERO,
                went: Vec3::ZERO,
            });
            return None;
        };
        let moved = place - before.place;
        let jump = moved - before.went;
        let is_driven = JUMP < jump.length();
        let jumps = is_driven && JUMP < moved.distance(before.moved);
        *hips = Some(Self {
            place,
            moved,
            // She has not come there by herself, and goes on as she did.
            went: if jumps { before.went } else { moved },
        });
        let (by, faster) = if jumps {
            (jump, Vec3::ZERO)
        } else {
            (Vec3::ZERO, jump / FRAME_SECONDS)
        };
        is_driven.then_some(Jump { by, faster })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn followed(places: &[f32]) -> Vec<Option<Jump>> {
        let mut hips = None;
        let follow = |&place: &f32| Hips::follow(&mut hips, Vec3::X * place);
        places.iter().map(follow).collect()
    }

    fn jumps(places: &[f32]) -> Vec<Option<f32>> {
        let jumps = followed(places).into_iter();
        jumps.map(|jump| jump.map(|jump| jump.by.x)).collect()
    }

    #[test]
    fn a_place_that_is_left_at_once_is_a_jump_and_the_way_back_too() {
        let found = jumps(&[0.0, 0.005, 0.06, 0.065, 0.02, 0.025]);
        let about = |jump: Option<f32>, wanted: f32| {
            jump.is_some_and(|jump| (jump - wanted).abs() < 1.0e-6)
        };
        assert_eq!([found[0], found[1], found[3], found[5]], [None; 4]);
        assert!(about(found[2], 0.05) && about(found[4], -0.05), "{found:?}");
    }

    #[test]
    fn a_run_from_the_first_frame_is_a_speed_from_the_second() {
        let places: Vec<f32> = (0..8_u8).map(|frame| 0.03 * f32::from(frame)).collect();
        let found = followed(&places);
        assert!(found[1].is_some_and(|jump| 0.02 < jump.by.x && jump.faster == Vec3::ZERO));
        let speed = 0.03 / FRAME_SECONDS;
        let is_speed = |jump: Jump| jump.by == Vec3::ZERO && (jump.faster.x - speed).abs() < 1.0e-3;
        assert!(found[2].is_some_and(is_speed), "{:?}", found[2]);
        assert_eq!(found[3..], [None; 5]);
    }

    #[test]
    fn a_dancer_who_leaps_does_not_jump() {
        // To and fro by 5 cm four times a second: 32 m/s².
        let places: Vec<f32> = (0..60_u8)
            .map(|frame| {
                let turn = std::f32::consts::TAU * 4.0 * f32::from(frame) * FRAME_SECONDS;
                0.05 * (1.0 - lole_geom::trig::sin_cos(turn).1)
            })
            .collect();
        assert!(jumps(&places).iter().all(Option::is_none));
    }
}
