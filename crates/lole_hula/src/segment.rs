//! One part of a dance on its place on the floor.

use super::ease::{mix, ramp};
use super::figure::{Figure, Foot, Place, turned};
use super::repertoire::{DanceStep, STANCE};
use super::score::{Answer, Score};
use super::settings::MotionSettings;
use super::steps::{self, LEAD_IN_COUNTS, Moment, Move, Reading, Track};

/// How long a segment goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Length {
    /// For ever.
    Endless,
    /// So many counts.
    Counts(f32),
    /// The dancer stands still.
    Rest,
}

/// One step, or the ready stance, on its place on the floor.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// What is danced; the ready stance when `None`.
    pub step: Option<DanceStep>,
    /// In which manner.
    pub settings: MotionSettings,
    /// Whether it is danced to the left.
    pub mirrored: bool,
    /// Count of the dance at which it begins.
    pub start: f64,
    /// Local count there.
    pub local_start: f32,
    /// How long it goes on.
    pub length: Length,
    /// Where it is danced.
    pub place: Place,
    /// Where it faces, as the choreography says [°].
    pub facing: f32,
    /// How far it gets besides what the step does, on the floor [statures].
    pub travel: [f32; 2],
    /// The tracks of the written half in the axes of the step.
    written: [Track; 2],
    /// The tracks of the written half and of its answer, on the floor.
    halves: [[Track; 2]; 2],
    /// What the feet do instead in the first half, and in the last.
    pub first: Option<[Track; 2]>,
    /// See `first`.
    pub last: Option<[Track; 2]>,
}

/// A local count of a step: which half it is in, and where in it. The end of a half belongs to it,
/// so that its last landing does.
#[derive(Debug, Clone, Copy)]
struct InHalf {
    index: f32,
    within: f32,
}

impl Segment {
    /// A step, or the ready stance, at the middle of the floor.
    pub(super) fn new(step: Option<DanceStep>, settings: MotionSettings, start: f64) -> Self {
        let reading = Reading {
            score: step.map_or(&STANCE, DanceStep::score),
            settings: &settings,
        };
        let written = steps::tracks(reading);
        Self {
            step,
            mirrored: false,
            start,
            local_start: 0.0,
            length: Length::Endless,
            place: Place::default(),
            facing: 0.0,
            travel: [0.0; 2],
            halves: [written.clone(), written.clone()],
            written,
            first: None,
            last: None,
            settings,
        }
    }

    /// Moves it to a place on the floor.
    pub(super) fn put(&mut self, place: Place) {
        self.place = place;
        let answer = steps::answering_tracks(self.reading(), &self.written);
        self.halves = [self.on_floor(&self.written), self.on_floor(&answer)];
    }

    /// What is danced and how.
    pub(super) fn reading(&self) -> Reading<'_> {
        Reading {
            score: self.score(),
            settings: &self.settings,
        }
    }

    fn score(&self) -> &'static Score {
        self.step.map_or(&STANCE, DanceStep::score)
    }

    /// Local count of a count of the dance.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a part has at most 256 counts and a loop fewer"
    )]
    pub(super) fn local(&self, count: f64) -> f32 {
        let local = count - self.start + f64::from(self.local_start);
        match self.length {
            Length::Endless if 0.0 <= local => {
                local.rem_euclid(f64::from(self.score().counts())) as f32
            }
            Length::Endless | Length::Counts(_) => local as f32,
            // Nothing happens any more.
            Length::Rest => local.min(8.0) as f32,
        }
    }

    /// Local count at its end.
    pub(super) fn local_end(&self) -> f32 {
        match self.length {
            Length::Counts(counts) => self.local_start + counts,
            Length::Endless | Length::Rest => self.local_start,
        }
    }

    /// A foot [left, right] of the ready stance.
    pub(super) fn home(&self) -> [Foot; 2] {
        [1.0, -1.0].map(|side| Foot {
            x: side * (0.5 * self.settings.stance_width),
            turn_out: self.settings.toe_out_degrees,
            ..Foot::default()
        })
    }

    /// The body at a count of the dance; of its feet only what heel, ball and knee do in place.
    pub(super) fn body(&self, count: f64) -> Figure {
        let local = self.local(count);
        let figure = match self.length {
            Length::Rest => steps::stance(self.reading()),
            // The lead-in counts up to the beginning of the loop.
            _ if self.start <= f64::from(LEAD_IN_COUNTS) && local < self.local_start => {
                let mut figure = steps::figure(self.reading(), local);
                figure.pelvis.heading -= self.turn_of_lap();
                figure
            }
            _ => {
                let laps = self.laps(local);
                let mut figure =
                    steps::figure(self.reading(), local - laps * self.score().counts());
                figure.pelvis.heading += laps * self.turn_of_lap();
                figure
            }
        };
        let mut figure = self.figure_on_floor(figure);
        // The body is between its feet.
        let [left, right] = [0, 1].map(|i| self.traveled(i, local));
        figure.pelvis.travel += 0.5 * (left[0] + right[0]);
        figure.pelvis.ahead += 0.5 * (left[1] + right[1]);
        figure
    }

    /// The ready stance before it, without its feet.
    pub(super) fn stance(&self) -> Figure {
        self.figure_on_floor(steps::stance(self.reading()))
    }

    fn figure_on_floor(&self, figure: Figure) -> Figure {
        if self.mirrored {
            return figure.mirrored().placed(&self.place);
        }
        figure.placed(&self.place)
    }

    /// Whole loops before a local count.
    fn laps(&self, local: f32) -> f32 {
        match self.length {
            Length::Counts(_) => (local / self.score().counts()).floor(),
            Length::Endless | Length::Rest => 0.0,
        }
    }

    /// How far the body has turned after a loop, as the score has it [°]: 0 or whole turns.
    fn turn_of_lap(&self) -> f32 {
        match self.score().answer {
            Answer::Repeat => self.score().heading.at(self.score().half),
            Answer::Mirror | Answer::MirrorBackward => 0.0,
        }
    }

    /// Where the body faces on the floor at the end [°], whole turns included.
    pub(super) fn heading_at_end(&self) -> f32 {
        let turn = self.laps(self.local_end()) * self.turn_of_lap();
        self.place.heading + if self.mirrored { -turn } else { turn }
    }

    /// Where the feet [left, right] stand, fly and twist on the floor at a local count.
    pub(super) fn feet(&self, local: f32) -> [Foot; 2] {
        let mut feet = self.steps_of_feet(local);
        for (i, foot) in feet.iter_mut().enumerate() {
            let [x, z] = self.traveled(i, local);
            foot.x += x;
            foot.z += z;
        }
        feet
    }

    /// How far a foot has got on the way of the part, on the floor [statures]: it lands every time where the way
    /// has come to, and flies there from where it stood.
    pub(super) fn traveled(&self, i: usize, local: f32) -> [f32; 2] {
        if self.travel == [0.0; 2] || !matches!(self.length, Length::Counts(_)) {
            return [0.0; 2];
        }
        let half = self.score().half;
        let lands = |step: &&Move| 0.0 < step.lift;
        let landed = |index: f32| {
            let step = self.tracks_of(index)[i].moves.iter().rfind(lands)?;
            Some(index * half + step.count)
        };
        let landed_before = |end: f32| {
            let halves = (0_u16..)
                .map(f32::from)
                .take_while(move |index| *index < end);
            halves.filter_map(landed).last()
        };
        // With its last landing it has come all the way.
        let Some(arrival) = landed_before(self.last_half() + 1.0) else {
            return [0.0; 2];
        };
        let whole = (arrival - self.local_start).max(1.0);
        let way = |local: f32| ((local - self.local_start) / whole).clamp(0.0, 1.0);
        let at = self.in_half(local);
        let mut share = landed_before(at.index).map_or(0.0, way);
        for step in self.tracks_of(at.index)[i].moves.iter().filter(lands) {
            let flight = (at.within - step.count) / step.flight + 1.0;
            share = mix(share, way(at.index * half + step.count), ramp(flight));
        }
        self.travel.map(|along| along * share)
    }

    /// The tracks of a half.
    fn tracks_of(&self, index: f32) -> &[Track; 2] {
        match (&self.first, &self.last) {
            (Some(tracks), _) if index <= 0.0 => tracks,
            (_, Some(tracks)) if self.last_half() <= index => tracks,
            _ => &self.halves[usize::from(self.answers(index))],
        }
    }

    fn steps_of_feet(&self, local: f32) -> [Foot; 2] {
        if self.length == Length::Endless {
            return match &self.first {
                Some(tracks) if local < 0.0 => [0, 1].map(|i: usize| tracks[i].at(local)),
                _ => {
                    let moment = Moment::of(self.score(), local);
                    steps::stands(self.reading(), &self.written, moment)
                        .map(|foot| self.place.foot(foot))
                }
            };
        }
        let at = self.in_half(local);
        let is_own = (self.first.is_some() && at.index <= 0.0)
            || (self.last.is_some() && self.last_half() <= at.index);
        let turn = if is_own {
            0.0
        } else {
            self.turn_before(at.index)
        };
        self.twisted(self.tracks_of(at.index), at, turn)
    }

    fn in_half(&self, local: f32) -> InHalf {
        let half = self.score().half;
        let index = ((local / half).ceil() - 1.0).max(0.0);
        InHalf {
            index,
            within: local - index * half,
        }
    }

    fn last_half(&self) -> f32 {
        self.in_half(self.local_end()).index
    }

    fn answers(&self, index: f32) -> bool {
        self.score().answer != Answer::Repeat && 0.5 < (0.5 * index).fract() * 2.0
    }

    /// Turn [°] of the laps before a half, on the floor.
    fn turn_before(&self, index: f32) -> f32 {
        let turn = match self.score().answer {
            Answer::Repeat => index * self.turn_of_lap(),
            Answer::Mirror | Answer::MirrorBackward => 0.0,
        };
        if self.mirrored { -turn } else { turn }
    }

    /// Feet of tracks on the floor with what the score twists, turned on by `turn` [°].
    fn twisted(&self, tracks: &[Track; 2], at: InHalf, turn: f32) -> [Foot; 2] {
        let [left, right] = self.score().feet.map(|foot| foot.pivot_at(at.within));
        let pivots = if self.answers(at.index) == self.mirrored {
            [left, right]
        } else {
            [[-right[0], right[1]], [-left[0], left[1]]]
        };
        [0, 1].map(|i: usize| {
            let foot = tracks[i].at(at.within);
            let [twist, heel] = pivots[i];
            Foot {
                heading: foot.heading + turn,
                twist: foot.twist + twist,
                heel: foot.heel + heel,
                ..foot
            }
        })
    }

    /// The step's own tracks [left, right] of its first half.
    pub(super) fn own_first(&self) -> &[Track; 2] {
        &self.halves[0]
    }

    /// The tracks of its last half as they are now, to be changed.
    pub(super) fn last_tracks(&mut self) -> &mut [Track; 2] {
        let index = self.last_half();
        if index <= 0.0 {
            return self.first.get_or_insert_with(|| self.halves[0].clone());
        }
        let answers = self.answers(index);
        let turn = self.turn_before(index);
        self.last.get_or_insert_with(|| {
            let mut tracks = self.halves[usize::from(answers)].clone();
            for track in &mut tracks {
                track.start.heading += turn;
                for step in &mut track.moves {
                    step.foot.heading += turn;
                }
            }
            tracks
        })
    }

    /// The foot that lands at its end, if one does.
    pub(super) fn lands_last(&self) -> Option<usize> {
        let half = self.score().half;
        let tracks = &self.halves[usize::from(self.answers(self.last_half()))];
        [0, 1].into_iter().find(|&i: &usize| {
            let last = tracks[i].moves.last();
            last.is_some_and(|step| (step.count - half).abs() < 1e-3)
        })
    }

    fn on_floor(&self, tracks: &[Track; 2]) -> [Track; 2] {
        let foot = |foot: Foot| {
            let foot = if self.mirrored {
                foot.mirrored(0.0)
            } else {
                foot
            };
            self.place.foot(foot)
        };
        let side = if self.mirrored { -1.0 } else { 1.0 };
        let track = |track: &Track| Track {
            start: foot(track.start),
            moves: (track.moves.iter())
                .map(|step| Move {
                    foot: foot(step.foot),
                    swing: turned([side * step.swing[0], step.swing[1]], self.place.heading),
                    ..*step
                })
                .collect(),
        };
        let [left, right] = [track(&tracks[0]), track(&tracks[1])];
        if self.mirrored {
            [right, left]
        } else {
            [left, right]
        }
    }
}
