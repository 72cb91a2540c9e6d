//! The shutter of the film's camera: while it is open, what moves is smeared.

use std::collections::VecDeque;

use glam::Vec3;
use lole_costume::document::MotionBlur;
use lole_render::{Camera, Exposure, Image, RenderError, RoomLight, Size};
use lole_stage::Vertices;
use rayon::prelude::*;

use super::FILM_RATE;
use crate::Moment;

/// What moves goes no farther than so much from one of the pictures to the next of which a blurred one is made
/// [pixel].
const STEP: f32 = 1.5;
/// Most pictures of which one is made.
const MOST_PICTURES: u16 = 16;
/// Times that differ by less are the same [s].
const SAME_TIME: f32 = 1.0e-4;

/// Keeps the moments that lie as far back as the shutter is open; of several dancers, each of them in her order.
pub(crate) struct Shutter {
    /// How long it is open before a picture [s].
    open: f32,
    /// The latest moments and their times [s], in their order.
    kept: VecDeque<(f32, Vec<Moment>)>,
}

impl Shutter {
    pub(crate) const fn new(blur: MotionBlur) -> Self {
        Self {
            open: blur.open_share() / FILM_RATE as f32,
            kept: VecDeque::new(),
        }
    }

    /// Whether moments between pictures count.
    pub(crate) fn smears(&self) -> bool {
        0.0 < self.open
    }

    /// Keeps a moment and its time [s], later than all before.
    pub(crate) fn keep(&mut self, time: f32, moments: Vec<Moment>) {
        self.kept.push_back((time, moments));
        // One moment may lie before the shutter opens: what was seen then begins at it.
        let begins = time - self.open + SAME_TIME;
        while self.kept.get(1).is_some_and(|(next, _)| *next < begins) {
            self.kept.pop_front();
        }
    }

    /// The picture of the moment that was kept last, in all that the shutter saw before it; `draw` draws moments, of
    /// which all but the first are lit as the one before.
    pub(crate) fn expose(
        &self,
        (camera, size): (&Camera, Size),
        mut draw: impl FnMut(&[Moment], RoomLight) -> Result<Image, RenderError>,
    ) -> Result<Image, RenderError> {
        let Some((now, last)) = self.kept.back() else {
            return draw(&[], RoomLight::Anew);
        };
        let count = self.picture_count(camera, size);
        if count == 1 {
            return draw(last, RoomLight::Anew);
        }
        let mut exposure = Exposure::new(size);
        for number in 0..count {
            let share = (f32::from(number) + 0.5) / f32::from(count);
            let room = if number == 0 {
                RoomLight::Anew
            } else {
                RoomLight::AsBefore
            };
            exposure.add(&draw(&self.at(now - self.open * (1.0 - share)), room)?, 1.0);
        }
        Ok(exposure.develop())
    }

    /// Where everything was at a time [s].
    fn at(&self, time: f32) -> Vec<Moment> {
        let later = self.kept.partition_point(|(kept, _)| *kept <= time);
        let later = later.clamp(1, self.kept.len().max(2) - 1);
        let [(before, from), (after, to)] = [later - 1, later].map(|place| &self.kept[place]);
        let share = ((time - before) / (after - before)).clamp(0.0, 1.0);
        from.iter()
            .zip(to)
            .map(|(from, to)| from.towards(to, share))
            .collect()
    }

    /// Of how many pictures one is made, so that what moves farthest is smeared without gaps.
    fn picture_count(&self, camera: &Camera, size: Size) -> u16 {
        let mut way = 0.0;
        let later = self.kept.iter().skip(1);
        for ((before, from), (after, to)) in self.kept.iter().zip(later) {
            let open = (self.open / (after - before)).min(1.0);
            let moved = from.iter().zip(to);
            let moved = moved.map(|(from, to)| farthest(from, to, (camera, size)));
            way += open * moved.fold(0.0, f32::max);
        }
        let enough = |count: &u16| way <= f32::from(*count) * STEP;
        (1..MOST_PICTURES).find(enough).unwrap_or(MOST_PICTURES)
    }
}

/// How far what moves farthest goes in a picture [pixel].
fn farthest(from: &Moment, to: &Moment, (camera, size): (&Camera, Size)) -> f32 {
    let pairs = from.surfaces().zip(to.surfaces());
    let way = |(from, to): (&Vec3, &Vec3)| {
        let seen = camera.pixel(*from, size).zip(camera.pixel(*to, size));
        seen.map_or(0.0, |(from, to)| from.distance(to))
    };
    let ways = pairs.map(|([from, _], [to, _]): (&Vertices, &Vertices)| {
        let ways = from.par_iter().zip(to).map(way);
        ways.reduce(|| 0.0, f32::max)
    });
    ways.fold(0.0, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_render::{Bounds, View};

    const SIZE: Size = Size::new(640, 360);
    const FRAME: f32 = 1.0 / 60.0;

    fn moment(x: f32) -> Vec<Moment> {
        let place = Vec3::new(x, 1.0, 0.0);
        vec![Moment {
            body: [vec![place, Vec3::Y], vec![Vec3::Z; 2]],
            ..Moment::default()
        }]
    }

    fn camera() -> Camera {
        let stage = Bounds {
            min: Vec3::new(-1.0, 0.0, -1.0),
            max: Vec3::new(1.0, 2.0, 1.0),
        };
        Camera::framing(stage, View::Front, SIZE.aspect())
    }

    /// Where a point that moves at a speed [m/s] is in the pictures of which one is made.
    fn seen(blur: MotionBlur, speed: f32) -> Vec<f32> {
        let mut shutter = Shutter::new(blur);
        for frame in 0_u8..7 {
            let time = FRAME * f32::from(frame);
            shutter.keep(time, moment(speed * time));
        }
        let mut places = Vec::new();
        let image = shutter.expose((&camera(), SIZE), |moments, _| {
            places.push(moments[0].body[0][0].x);
            Ok(Image::filled(SIZE, [80, 90, 100]))
        });
        assert_eq!(image.unwrap(), Image::filled(SIZE, [80, 90, 100]));
        places
    }

    #[test]
    fn what_moves_is_seen_evenly_over_the_time_that_the_shutter_is_open() {
        for (blur, open) in [(MotionBlur::Film, FRAME), (MotionBlur::Long, 2.0 * FRAME)] {
            for speed in [1.6, -2.3, 3.5] {
                let places = seen(blur, speed);
                let [now, way] = [6.0 * FRAME * speed, open * speed];
                assert!(places.len() > 1, "{speed} m/s at one place");
                let step = way / places.len() as f32;
                for (number, place) in places.iter().enumerate() {
                    let expected = now - way + step * (number as f32 + 0.5);
                    assert!((place - expected).abs() < 1.0e-4, "{place} {expected}");
                }
                let pixels = [0.0, step].map(|x| camera().pixel(Vec3::new(x, 1.0, 0.0), SIZE));
                let [from, to] = pixels.map(Option::unwrap);
                assert!(from.distance(to) < 1.01 * STEP, "{from} {to}");
            }
        }
    }

    #[test]
    fn what_stands_and_what_is_seen_for_a_moment_costs_one_picture() {
        assert_eq!(seen(MotionBlur::Long, 0.0), [0.0]);
        assert_eq!(seen(MotionBlur::None, 1.0), [6.0 * FRAME]);
    }

    #[test]
    fn light_is_added_and_not_its_bytes() {
        let mut exposure = Exposure::new(SIZE);
        exposure.add(&Image::filled(SIZE, [0, 0, 0]), 1.0);
        exposure.add(&Image::filled(SIZE, [255, 255, 255]), 1.0);
        // Half the light of white, by the curve of IEC 61966-2-1.
        assert_eq!(exposure.develop().pixel(3, 4), Some([188, 188, 188, 255]));
    }
}
