//! Open hair: threads of knots that stay behind what she does, swing back, and lie on her back.
//!
//! Hair hangs as it is combed while she stands: that is at rest by its definition, so a still of one who stands shows
//! what the comb left. What moves it is what has changed since: where the head and the back have gone, where down is
//! for one who bends, and the wind.

use glam::{Affine3A, Vec3};
use lole_body::{Combed, OpenHair, Swing};

use super::FRAME_SECONDS;

/// Steps of a frame.
const STEPS: u8 = 4;
/// Passes over threads in a step.
const PASSES: u8 = 4;
/// How fast what is away from where it is combed to comes back: at the root and at the ends [1/s²]. A thread of the
/// length of this hair swings about once a second, as a pendulum does; the roots of hair are stiffer than its ends.
const RETURNS: [f32; 2] = [220.0, 34.0];
/// How fast hair takes the velocity of the air [1/s].
const DRAG: f32 = 0.9;
/// How fast it takes the velocity of hair and back beside it [1/s].
const RUBS: f32 = 1.6;
/// The same where it lies on her back.
const RUBS_ON_BACK: f32 = 5.0;
/// How far it is pressed towards the back [m].
const PRESSED: f32 = 0.003;
/// Cloth that is nearer than this across a thread carries it [m], and less by so much of how far it is: hair lies on
/// the crests of folds, and spans from one to the next.
const CARRIES: f32 = 0.05;
const SPANS: f32 = 0.55;
/// Cloth beyond these is not below the hair [m]: in her, or far behind her.
const REACHES: [f32; 2] = [-0.05, 0.15];
/// Free air below a thread, which is the outer side of the hair [m].
const ABOVE_CLOTH: f32 = 0.014;
/// Threads that lie beside each other keep this share of their distance, and no more than that.
const BESIDE: [f32; 2] = [0.7, 1.3];
/// A head goes no farther in a frame [m]; a recording that jumps does.
const JUMP: f32 = 0.25;

/// What hair meets in a frame.
pub(super) struct AroundHair<'a> {
    /// Skin transforms of the pose, by bone.
    pub(super) world_from_bind: &'a [Affine3A],
    /// Acceleration of free fall [m/s²].
    pub(super) gravity: Vec3,
    /// Velocity of the air [m/s].
    pub(super) air_velocity: Vec3,
    /// Places of what she wears [m].
    pub(super) cloth: &'a [&'a [Vec3]],
}

/// Open hair in motion.
#[derive(Debug, Clone, Default)]
pub(super) struct Hair {
    /// Where the knots are [m], and how fast [m/s].
    places: Vec<Vec3>,
    velocities: Vec<Vec3>,
    /// Where they are combed to.
    combed: Vec<Combed>,
    /// How far outward of there back and cloth reach [m].
    ground: Vec<f32>,
    /// Knots of a column.
    row_count: usize,
}

impl Hair {
    /// Moves on by a frame.
    pub(super) fn step(&mut self, hair: &OpenHair, around: &AroundHair<'_>) {
        let combed: Vec<Combed> = hair.combed(around.world_from_bind).collect();
        let goes_on = combed.len() == self.combed.len()
            && (combed.iter().zip(&self.combed))
                .all(|(now, before)| now.place.distance(before.place) < JUMP);
        if !goes_on {
            self.places = combed.iter().map(|it| it.place).collect();
            self.velocities = vec![Vec3::ZERO; combed.len()];
            self.combed = combed;
            self.row_count = hair.knots.len() / hair.column_count.max(1);
            self.ground = vec![-PRESSED; self.places.len()];
            self.lie_on(around.cloth);
            self.keep_off_back();
            return;
        }
        self.lie_on(around.cloth);
        let before = std::mem::take(&mut self.combed);
        for step in 1..=STEPS {
            let share = f32::from(step) / f32::from(STEPS);
            let pairs = before.iter().zip(&combed);
            let between = pairs.map(|(before, now)| Combed {
                place: before.place.lerp(now.place, share),
                ..*now
            });
            self.combed = between.collect();
            let pairs = before.iter().zip(&combed);
            let carried: Vec<Vec3> = pairs
                .map(|(before, now)| (now.place - before.place) / FRAME_SECONDS)
                .collect();
            self.substep(&carried, around);
        }
        self.combed = combed;
    }

    /// Moves on by a step; where they are combed to goes with these velocities [m/s].
    fn substep(&mut self, carried: &[Vec3], around: &AroundHair<'_>) {
        let dt = FRAME_SECONDS / f32::from(STEPS);
        let from = self.places.clone();
        for (knot, &carried) in carried.iter().enumerate() {
            let (combed, place) = (&self.combed[knot], self.places[knot]);
            let down = (knot % self.row_count) as f32 / (self.row_count - 1).max(1) as f32;
            let returns = RETURNS[0] + (RETURNS[1] - RETURNS[0]) * down;
            let weight = around.gravity - combed.down * around.gravity.length();
            let out = (place - combed.place).dot(combed.outward);
            let rubs = if out < self.ground[knot] + PRESSED {
                RUBS_ON_BACK
            } else {
                RUBS
            };
            let velocity = &mut self.velocities[knot];
            *velocity += (weight + (combed.place - place) * returns) * dt;
            *velocity += (around.air_velocity - *velocity) * (DRAG * dt);
            *velocity += (carried - *velocity) * (rubs * dt);
            self.places[knot] += *velocity * dt;
        }
        for _ in 0..PASSES {
            self.hold_threads();
            self.hold_beside();
            self.keep_off_back();
        }
        for (knot, velocity) in self.velocities.iter_mut().enumerate() {
            *velocity = (self.places[knot] - from[knot]) / dt;
        }
    }

    /// Roots stay, and threads are as long as they are combed.
    fn hold_threads(&mut self) {
        for knot in 0..self.places.len() {
            if knot.is_multiple_of(self.row_count) {
                self.places[knot] = self.combed[knot].place;
                continue;
            }
            let length = (self.combed[knot].place).distance(self.combed[knot - 1].place);
            let along = self.places[knot] - self.places[knot - 1];
            let off = along.normalize_or_zero() * (along.length() - length);
            if (knot - 1).is_multiple_of(self.row_count) {
                self.places[knot] -= off;
            } else {
                self.places[knot - 1] += off * 0.5;
                self.places[knot] -= off * 0.5;
            }
        }
    }

    /// Threads neither go through those beside them nor leave them.
    fn hold_beside(&mut self) {
        for knot in self.row_count..self.places.len() {
            let beside = knot - self.row_count;
            if knot.is_multiple_of(self.row_count) {
                continue;
            }
            let breadth = (self.combed[knot].place).distance(self.combed[beside].place);
            let across = self.places[knot] - self.places[beside];
            let [least, most] = BESIDE.map(|share| share * breadth);
            let length = across.length();
            let off = across.normalize_or_zero() * (length - length.clamp(least, most));
            self.places[beside] += off * 0.5;
            self.places[knot] -= off * 0.5;
        }
    }

    /// Finds how far back and cloth reach where the threads are.
    fn lie_on(&mut self, cloth: &[&[Vec3]]) {
        let [low, high] = (self.places.iter())
            .fold([Vec3::MAX, Vec3::MIN], |[low, high], place| {
                [low.min(*place), high.max(*place)]
            });
        let [low, high] = [low - REACHES[1], high + REACHES[1]];
        let near: Vec<Vec3> = (cloth.iter().copied().flatten().copied())
            .filter(|point| low.cmple(*point).all() && point.cmple(high).all())
            .collect();
        let knots = self.places.iter().zip(&self.combed);
        for (ground, (place, combed)) in self.ground.iter_mut().zip(knots) {
            let rises = near.iter().filter_map(|point| {
                let from_comb = (*point - combed.place).dot(combed.outward);
                let beside = (*point - *place).reject_from(combed.outward);
                let carries = beside.length_squared() < CARRIES * CARRIES
                    && (REACHES[0]..REACHES[1]).contains(&from_comb);
                carries.then(|| from_comb + ABOVE_CLOTH - SPANS * beside.length())
            });
            *ground = rises.fold(-PRESSED, f32::max);
        }
    }

    /// Nothing goes into her back or into cloth; roots stay.
    fn keep_off_back(&mut self) {
        let knots = self.places.iter_mut().zip(&self.combed).zip(&self.ground);
        for (knot, ((place, combed), ground)) in knots.enumerate() {
            let depth = (*place - combed.place).dot(combed.outward) - ground;
            if depth < 0.0 && !knot.is_multiple_of(self.row_count) {
                *place -= combed.outward * depth;
            }
        }
    }

    /// How it is away from where it is combed to.
    pub(super) fn swing(&self) -> Swing {
        let along = |knot: usize, at: &dyn Fn(usize) -> Vec3| {
            let above = knot - usize::from(!knot.is_multiple_of(self.row_count));
            let below = if above == knot { knot + 1 } else { knot };
            (at(below) - at(above)).normalize_or_zero()
        };
        let pairs = self.places.iter().zip(&self.combed);
        Swing {
            moved: pairs.map(|(place, combed)| *place - combed.place).collect(),
            turned: (0..self.places.len())
                .map(|knot| {
                    let combed = along(knot, &|knot| self.combed[knot].place);
                    combed.cross(along(knot, &|knot| self.places[knot]))
                })
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Quat;
    use lole_body::{Appearance, Bone, Dancer, HairStyle, Measurements, Pose, Tape};
    use lole_geom::Length;

    use super::*;

    fn dancer(measurements: &Measurements) -> Dancer {
        let appearance = Appearance {
            hair: HairStyle::Long,
            ..Appearance::default()
        };
        Dancer::with_appearance(measurements, &appearance).unwrap()
    }

    /// A pose turned about the vertical, and bent forward at the hips [rad].
    fn posed(dancer: &Dancer, turn: f32, bend: f32) -> Vec<Affine3A> {
        let mut pose = Pose::default();
        pose.rotations[Bone::Hips.index()] =
            Quat::from_rotation_y(turn) * Quat::from_rotation_x(bend);
        dancer.skeleton.world_from_bind(&pose)
    }

    /// A frame in a pose and moving air, over cloth.
    fn step(hair: &mut Hair, open: &OpenHair, pose: &[Affine3A], (air, cloth): (Vec3, &[&[Vec3]])) {
        let around = AroundHair {
            world_from_bind: pose,
            gravity: Vec3::new(0.0, -9.81, 0.0),
            air_velocity: air,
            cloth,
        };
        hair.step(open, &around);
    }

    /// How far the farthest knot is away from where it is combed to, after the laws of every moment held.
    fn farthest(hair: &Hair) -> f32 {
        let knots = hair.places.iter().zip(&hair.combed);
        for (knot, (place, combed)) in knots.enumerate() {
            assert!(place.is_finite());
            let depth = (combed.place - *place).dot(combed.outward);
            assert!(depth < PRESSED + 1.0e-4, "{depth} m below the back");
            if !knot.is_multiple_of(hair.row_count) {
                let length = place.distance(hair.places[knot - 1]);
                let combed = (combed.place).distance(hair.combed[knot - 1].place);
                assert!(
                    (length / combed - 1.0).abs() < 0.2,
                    "{length} m of {combed}"
                );
            }
        }
        let swing = hair.swing();
        assert!(swing.turned.iter().all(|turned| turned.length() <= 1.0));
        let moved = swing.moved.iter().map(|moved| moved.length());
        moved.fold(0.0, f32::max)
    }

    #[test]
    fn open_hair_swings_after_a_turn_and_hangs_again() {
        for stature in [118.0, 158.5, 179.0] {
            let tape = Tape {
                stature: Some(Length::from_cm(stature)),
                ..Tape::default()
            };
            let dancer = dancer(&Measurements::from_tape(&tape).unwrap());
            let open = &dancer.drawn_body.as_ref().unwrap().open_hair;
            let mut hair = Hair::default();
            // Standing it hangs as it is combed.
            for _ in 0..60 {
                step(
                    &mut hair,
                    open,
                    &posed(&dancer, 0.0, 0.0),
                    (Vec3::ZERO, &[]),
                );
                assert_eq!(farthest(&hair), 0.0);
            }
            let mut most = 0.0_f32;
            for frame in 0_u8..60 {
                let turn = std::f32::consts::TAU * f32::from(frame) / 60.0;
                step(
                    &mut hair,
                    open,
                    &posed(&dancer, turn, 0.0),
                    (Vec3::ZERO, &[]),
                );
                most = most.max(farthest(&hair));
            }
            assert!((0.02..0.35).contains(&most), "{most} m");
            for _ in 0..300 {
                step(
                    &mut hair,
                    open,
                    &posed(&dancer, 0.0, 0.0),
                    (Vec3::ZERO, &[]),
                );
                farthest(&hair);
            }
            assert!(farthest(&hair) < 0.003, "{} m", farthest(&hair));
        }
    }

    #[test]
    fn hair_hangs_down_from_one_who_bends_and_blows_in_the_wind() {
        let dancer = dancer(&Measurements::woman());
        let open = &dancer.drawn_body.as_ref().unwrap().open_hair;
        let hang = |bend: f32, air: Vec3| {
            let mut hair = Hair::default();
            for frame in 0_u16..400 {
                let share = (f32::from(frame) / 100.0).min(1.0);
                step(
                    &mut hair,
                    open,
                    &posed(&dancer, 0.0, bend * share),
                    (air, &[]),
                );
                farthest(&hair);
            }
            let tips = hair.places.iter().zip(&hair.combed);
            let tips = tips.skip(hair.row_count - 1).step_by(hair.row_count);
            let moved: Vec<Vec3> = tips.map(|(tip, combed)| *tip - combed.place).collect();
            moved.iter().sum::<Vec3>() / moved.len() as f32
        };
        let away = hang(0.0, Vec3::new(3.0, 0.0, 0.0));
        assert!(0.01 < away.x && away.z.abs() < 0.05, "{away}");
        // What lies on a back that leans backwards hangs free.
        let free = hang(-0.4, Vec3::ZERO);
        assert!(free.z < -0.01, "{free}");
    }

    #[test]
    fn hair_lies_over_what_is_worn() {
        let dancer = dancer(&Measurements::woman());
        let open = &dancer.drawn_body.as_ref().unwrap().open_hair;
        let pose = posed(&dancer, 0.0, 0.0);
        let combed: Vec<Combed> = open.combed(&pose).collect();
        // The back of a wide dress, with folds.
        let cloth: Vec<Vec3> = (0_u16..1600)
            .map(|point| {
                let [across, down] = [point % 40, point / 40].map(f32::from);
                let (top, middle) = (combed[3].place, combed[2 * open.knots.len() / 5].place);
                let fold = 0.03 + 0.015 * f32::from(point % 40 % 7) / 6.0;
                Vec3::new(0.01 * across - 0.2, top.y - 0.012 * down, middle.z - fold)
            })
            .collect();
        let mut hair = Hair::default();
        for _ in 0..120 {
            step(&mut hair, open, &pose, (Vec3::ZERO, &[&cloth]));
        }
        for (knot, place) in hair.places.iter().enumerate() {
            let below = cloth
                .iter()
                .filter(|point| (point.truncate() - place.truncate()).length() < 0.008);
            let is_root = knot.is_multiple_of(hair.row_count);
            assert!(
                is_root || below.clone().all(|point| place.z < point.z),
                "knot {knot}: {place}"
            );
        }
    }

    #[test]
    fn a_jump_of_a_recording_leaves_no_hair_behind() {
        let dancer = dancer(&Measurements::woman());
        let open = &dancer.drawn_body.as_ref().unwrap().open_hair;
        let mut hair = Hair::default();
        step(
            &mut hair,
            open,
            &posed(&dancer, 0.0, 0.0),
            (Vec3::ZERO, &[]),
        );
        let mut far = posed(&dancer, 0.4, 0.0);
        for bone in &mut far {
            bone.translation.x += 3.0;
        }
        step(&mut hair, open, &far, (Vec3::ZERO, &[]));
        assert_eq!(farthest(&hair), 0.0);
    }
}
