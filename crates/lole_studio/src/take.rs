//! What was danced in the window, kept so that it can be seen again: at any moment, slowly, over and over.
//!
//! A frame is kept as it was drawn, in less than half of the bytes; between two of them every point goes along a
//! smooth curve. It is of what was on stage: another costume or another beginning starts another take.

use std::collections::VecDeque;
use std::sync::Arc;

use glam::{Vec2, Vec3};
use lole_geom::Capsule;
use lole_picture::Moment;
use lole_stage::{PartNow, Vertices};

use crate::Snapshot;
use crate::snapshot::Wardrobe;

/// Frames are kept this far apart [s of the dance] where they come faster: every fourth of the show.
const INTERVAL: f32 = 0.066;
/// Frames that are kept at most; more bytes are fewer frames.
const MOST_FRAMES: usize = 6000;
/// A step back in time of more than this is another beginning [s].
const BACK: f32 = 1e-3;

/// What was danced; another one of the same costs nothing.
#[derive(Clone, Default)]
pub struct Take {
    frames: VecDeque<Arc<Kept>>,
    bytes: usize,
}

/// One frame.
struct Kept {
    wardrobe: Arc<Wardrobe>,
    time: f32,
    worn: Vec<Packed>,
    body: Packed,
    capsules: Vec<Capsule>,
    bones: Vec<[Vec3; 2]>,
    part: Option<PartNow>,
    recording_seconds: Option<f32>,
    bytes: usize,
}

/// Which way through time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Way {
    Back,
    On,
}

/// Positions within their box and normals, as integers.
#[derive(Debug, Clone, PartialEq)]
struct Packed {
    corner: Vec3,
    /// Meters in one step of a position.
    step: Vec3,
    positions: Vec<[u16; 3]>,
    normals: Vec<[i16; 2]>,
}

impl Take {
    /// The first and the last moment that can be seen [s of the dance]; `None` before there are two.
    #[must_use]
    pub fn span(&self) -> Option<[f32; 2]> {
        let [first, last] = [self.frames.front()?, self.frames.back()?];
        (first.time < last.time).then_some([first.time, last.time])
    }

    /// Takes in a moment that is shown, in at most so many bytes for all; whether it was kept.
    pub(crate) fn keep(&mut self, snapshot: &Snapshot, most_bytes: usize) -> bool {
        // While she is dressed the clock is below 0.
        if snapshot.time < 0.0 || snapshot.stopped.is_some() {
            return false;
        }
        if let Some(last) = self.frames.back() {
            let is_another = last.wardrobe.id != snapshot.wardrobe.id;
            if is_another || snapshot.time < last.time - BACK {
                *self = Self::default();
            } else if snapshot.time < last.time + INTERVAL {
                return false;
            }
        }
        let kept = Kept::of(snapshot);
        self.bytes += kept.bytes;
        self.frames.push_back(Arc::new(kept));
        while most_bytes < self.bytes || MOST_FRAMES < self.frames.len() {
            let Some(first) = self.frames.pop_front() else {
                break;
            };
            self.bytes -= first.bytes;
        }
        true
    }

    /// The moment at a time of the dance [s], or the nearest one that was kept.
    #[must_use]
    pub fn at(&self, time: f32) -> Option<Snapshot> {
        let after = self.frames.partition_point(|kept| kept.time <= time);
        let last = self.frames.len().checked_sub(1)?;
        let here = after.saturating_sub(1);
        let places = [
            here.saturating_sub(1),
            here,
            after.min(last),
            (after + 1).min(last),
        ];
        let kept = places.map(|place| &*self.frames[place]);
        let [_, from, to, _] = kept;
        let share = if from.time < to.time {
            ((time - from.time) / (to.time - from.time)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let times = kept.map(|kept| kept.time);
        let weights = curve(times, share);
        let blend = |of: &dyn Fn(&Kept) -> &Packed| Packed::blend(kept.map(of), weights);
        let worn = (0..from.worn.len()).map(|surface| blend(&|kept| &kept.worn[surface]));
        let moment = Moment {
            worn: worn.collect(),
            body: blend(&|kept| &kept.body),
            strands: Vertices::default(),
        };
        let nearest = if share < 0.5 { from } else { to };
        let bones = from.bones.iter().zip(&to.bones);
        let part = match (from.part, to.part) {
            (Some(from), Some(to)) if from.index == to.index => Some(PartNow {
                index: from.index,
                share: from.share + (to.share - from.share) * share,
            }),
            _ => nearest.part,
        };
        let time = from.time + (to.time - from.time) * share;
        Some(Snapshot {
            particles: particles(&from.wardrobe, &moment.worn),
            capsules: nearest.capsules.clone(),
            bones: bones
                .map(|(a, b)| [a[0].lerp(b[0], share), a[1].lerp(b[1], share)])
                .collect(),
            part,
            recording_seconds: nearest.recording_seconds,
            ..Snapshot::showing(&from.wardrobe, moment, time)
        })
    }

    /// The time of the frame before or after a time [s]; the time itself where there is none.
    pub(crate) fn next(&self, time: f32, way: Way) -> f32 {
        let nearer = INTERVAL * 0.1;
        let found = if way == Way::On {
            let place = self
                .frames
                .partition_point(|kept| kept.time <= time + nearer);
            self.frames.get(place)
        } else {
            let place = self
                .frames
                .partition_point(|kept| kept.time < time - nearer);
            place
                .checked_sub(1)
                .and_then(|place| self.frames.get(place))
        };
        found.map_or(time, |kept| kept.time)
    }

    /// From when to when the latest dance of a part was kept [s].
    pub(crate) fn of_part(&self, index: usize) -> Option<[f32; 2]> {
        let is_it = |kept: &&Arc<Kept>| kept.part.is_some_and(|part| part.index == index);
        let mut latest = (self.frames.iter().rev())
            .skip_while(|kept| !is_it(kept))
            .take_while(is_it);
        let last = latest.next()?.time;
        let first = latest.last().map_or(last, |kept| kept.time);
        Some([first, last])
    }
}

impl Kept {
    fn of(snapshot: &Snapshot) -> Self {
        let moment = &snapshot.moment;
        let worn: Vec<Packed> = moment.worn.iter().map(Packed::of).collect();
        let body = Packed::of(&moment.body);
        let points: usize = worn
            .iter()
            .chain([&body])
            .map(|it| it.positions.len())
            .sum();
        Self {
            wardrobe: Arc::clone(&snapshot.wardrobe),
            time: snapshot.time,
            bytes: points * (size_of::<[u16; 3]>() + size_of::<[i16; 2]>()),
            worn,
            body,
            capsules: snapshot.capsules.clone(),
            bones: snapshot.bones.clone(),
            part: snapshot.part,
            recording_seconds: snapshot.recording_seconds,
        }
    }
}

/// How much each of four frames counts between the two in the middle: a cubic curve through both, along the way
/// from the one before to the one after.
fn curve(times: [f32; 4], share: f32) -> [f32; 4] {
    let [before, from, to, after] = times;
    let (square, cube) = (share * share, share * share * share);
    let [start, end] = [2.0 * cube - 3.0 * square + 1.0, 3.0 * square - 2.0 * cube];
    let [leaves, arrives] = [cube - 2.0 * square + share, cube - square];
    let length = to - from;
    // Ways of a frame, in frames; none where there is no frame beside it.
    let way = |first: f32, last: f32| {
        if first < last {
            length / (last - first)
        } else {
            0.0
        }
    };
    let [leaving, arriving] = [way(before, to), way(from, after)];
    [
        -leaves * leaving,
        start - arrives * arriving,
        end + leaves * leaving,
        arrives * arriving,
    ]
}

/// The particles of all cloth, as its drawn vertices have them.
fn particles(wardrobe: &Wardrobe, worn: &[Vertices]) -> Vec<Vec3> {
    let mut particles = Vec::new();
    for (particles_of, [positions, _]) in wardrobe.particle_of_vertex.iter().zip(worn) {
        for (&particle, &position) in particles_of.iter().zip(positions) {
            let place = particle as usize;
            if particles.len() <= place {
                particles.resize(place + 1, Vec3::ZERO);
            }
            particles[place] = position;
        }
    }
    particles
}

impl Packed {
    fn of([positions, normals]: &Vertices) -> Self {
        let everywhere = [Vec3::splat(f32::INFINITY), Vec3::splat(f32::NEG_INFINITY)];
        let [low, high] = positions.iter().fold(everywhere, |[low, high], &point| {
            [low.min(point), high.max(point)]
        });
        let (low, high) = if positions.is_empty() {
            (Vec3::ZERO, Vec3::ZERO)
        } else {
            (low, high)
        };
        let step = ((high - low) / f32::from(u16::MAX)).max(Vec3::splat(f32::MIN_POSITIVE));
        Self {
            corner: low,
            step,
            positions: (positions.iter())
                .map(|&point| ((point - low) / step).to_array().map(unsigned))
                .collect(),
            normals: normals.iter().map(|&normal| folded(normal)).collect(),
        }
    }

    fn position(&self, place: usize) -> Vec3 {
        let steps = self.positions[place].map(f32::from);
        self.corner + Vec3::from(steps) * self.step
    }

    /// What is between the two in the middle of four frames of a surface.
    fn blend(frames: [&Self; 4], weights: [f32; 4]) -> Vertices {
        let [before, from, to, after] = frames;
        let count = from.positions.len();
        // Never of one wardrobe, and yet no reason to fall.
        let all = if frames.iter().all(|frame| frame.positions.len() == count) {
            [before, from, to, after]
        } else {
            [from; 4]
        };
        let positions = (0..count).map(|place| {
            let terms = all.iter().zip(weights);
            terms
                .map(|(frame, weight)| frame.position(place) * weight)
                .sum()
        });
        let turn = weights[2] + weights[3];
        let normals = (0..from.normals.len()).map(|place| {
            let [from, to] = [all[1], all[2]].map(|frame| unfolded(frame.normals[place]));
            from.lerp(to, turn).normalize_or(from)
        });
        [positions.collect(), normals.collect()]
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to what it holds"
)]
fn unsigned(steps: f32) -> u16 {
    steps.round().clamp(0.0, f32::from(u16::MAX)) as u16
}

/// A unit vector on the faces of an octahedron that is folded open, as two integers.
fn folded(normal: Vec3) -> [i16; 2] {
    let all = normal.x.abs() + normal.y.abs() + normal.z.abs();
    let flat = if 0.0 < all { normal / all } else { Vec3::Z };
    let upper = Vec2::new(flat.x, flat.y);
    let place = if flat.z < 0.0 {
        turned_down(upper)
    } else {
        upper
    };
    #[expect(clippy::cast_possible_truncation, reason = "clamped to what it holds")]
    place
        .to_array()
        .map(|share| (share.clamp(-1.0, 1.0) * f32::from(i16::MAX)).round() as i16)
}

fn unfolded(place: [i16; 2]) -> Vec3 {
    let [x, y] = place.map(|share| f32::from(share) / f32::from(i16::MAX));
    let z = 1.0 - x.abs() - y.abs();
    let place = Vec2::new(x, y);
    let place = if z < 0.0 { turned_down(place) } else { place };
    Vec3::new(place.x, place.y, z).normalize_or(Vec3::Z)
}

/// The lower half of the octahedron beside the upper one, and back.
fn turned_down(place: Vec2) -> Vec2 {
    let sign = |value: f32| if value < 0.0 { -1.0 } else { 1.0 };
    Vec2::new(
        (1.0 - place.y.abs()) * sign(place.x),
        (1.0 - place.x.abs()) * sign(place.y),
    )
}

#[cfg(test)]
pub(crate) mod tests {
    use lole_costume::document::Design;

    use super::*;
    use crate::sim::first_moment;

    /// What somebody wears, worn by nobody yet.
    pub(crate) fn wardrobe() -> Arc<Wardrobe> {
        let mut design = Design::default();
        (design.skirt.column_count, design.skirt.row_count) = (96, 12);
        first_moment(&design).expect("she is dressed").wardrobe
    }

    /// A moment of three points at a time of the dance [s].
    pub(crate) fn moment(wardrobe: &Arc<Wardrobe>, time: f32) -> Snapshot {
        let body = [
            places(time).to_vec(),
            places(time).map(Vec3::normalize_or_zero).to_vec(),
        ];
        let moment = Moment {
            worn: Vec::new(),
            body,
            strands: Vertices::default(),
        };
        Snapshot {
            bones: vec![[places(time)[0], places(time)[1]]],
            ..Snapshot::showing(wardrobe, moment, time)
        }
    }

    /// A hand that goes to and fro once a second, a foot, and a crown that stands still.
    fn places(time: f32) -> [Vec3; 3] {
        let (sin, cos) = lole_geom::trig::sin_cos(std::f32::consts::TAU * time);
        [
            Vec3::new(0.4 * sin, 1.1 + 0.2 * cos, 0.3),
            Vec3::new(0.1 * cos, 0.05 * sin, -0.2),
            Vec3::new(0.0, 1.6, 0.0),
        ]
    }

    #[test]
    fn what_is_seen_again_is_where_it_was_and_moves_smoothly_between() {
        let wardrobe = wardrobe();
        let mut take = Take::default();
        for frame in 0_u8..=180 {
            take.keep(&moment(&wardrobe, f32::from(frame) / 60.0), usize::MAX);
        }
        let [first, last] = take.span().expect("it is kept");
        assert!(first == 0.0 && 2.9 < last);
        let mut worst = [0.0_f32; 2];
        // Before the second frame and after the last but one the curve knows one neighbor alone.
        for step in 100_u16..2800 {
            let time = f32::from(step) * 1e-3;
            let shown = take.at(time).expect("it is kept");
            assert!((shown.time - time).abs() < 1e-5);
            let [positions, normals] = &shown.moment.body;
            for ((&position, &normal), expected) in positions.iter().zip(normals).zip(places(time))
            {
                worst[0] = worst[0].max(position.distance(expected));
                worst[1] = worst[1].max(normal.distance(expected.normalize_or_zero()));
            }
        }
        // Straight ways between frames would cut off 9 mm.
        assert!(worst[0] < 1e-3 && worst[1] < 0.02, "{worst:?}");
        let kept = take.at(1.0).expect("it is kept");
        assert!(kept.moment.body[0][0].distance(places(1.0)[0]) < 5e-5);
    }

    #[test]
    fn the_earliest_is_forgotten_where_there_is_no_room_and_another_beginning_is_another_take() {
        let [wardrobe, other] = [wardrobe(), wardrobe()];
        let mut take = Take::default();
        let bytes = Kept::of(&moment(&wardrobe, 0.0)).bytes;
        for second in 0_u8..20 {
            assert!(take.keep(&moment(&wardrobe, f32::from(second)), 5 * bytes));
        }
        assert_eq!(take.span(), Some([15.0, 19.0]));
        assert!(!take.keep(&moment(&wardrobe, -1.0), 5 * bytes));
        assert!(take.keep(&moment(&wardrobe, 0.0), 5 * bytes));
        assert_eq!(take.span(), None);
        take.keep(&moment(&wardrobe, 1.0), 5 * bytes);
        take.keep(&moment(&other, 2.0), 5 * bytes);
        assert_eq!(take.span(), None);
    }

    #[test]
    fn every_direction_comes_back_from_two_integers() {
        for step in 0_u16..5000 {
            let turn = f32::from(step) * 2.4;
            let height = f32::from(step) / 2500.0 - 0.9999;
            let (sin, cos) = lole_geom::trig::sin_cos(turn);
            let level = (1.0 - height * height).max(0.0).sqrt();
            let normal = Vec3::new(level * cos, level * sin, height);
            let found = unfolded(folded(normal));
            assert!(
                found.distance(normal.normalize_or_zero()) < 1e-4,
                "{normal} {found}"
            );
        }
        assert!(unfolded(folded(Vec3::ZERO)).is_normalized());
    }
}
