//! From where each phrase of a film is seen.

use std::f32::consts::TAU;

use lole_costume::document::CameraWork;
use lole_geom::trig;
use lole_stage::{Danced, Production};

/// Largest drift to either side around one dancer, and around a group, whose rows would hide each other [rad].
const DRIFT: f32 = 0.6;
const GROUP_DRIFT: f32 = 0.2;
/// Time of one drift from side to side and back [s].
const DRIFT_PERIOD: f32 = 16.0;
/// Time of one turn around her [s].
const TURN_PERIOD: f32 = 12.0;

/// A phrase is so many counts, and the shot of one that would be shorter than this goes on [s].
const PHRASE_COUNTS: u32 = 8;
const SHORTEST: f64 = 3.0;
/// A recording has no counts: it is cut so often [s].
const WITHOUT_COUNTS: f64 = 6.0;
/// Longest film [s].
const LONGEST: f64 = 600.0;
/// How fast a shot goes around her, so that it is no photograph [rad/s].
const CREEP: f32 = 0.02;

/// What a shot shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Framing {
    /// Everybody from head to foot.
    Whole,
    /// One dancer from the hips up, with her hands.
    Upper,
}

/// Where the camera of a shot stands, and what it shows; it is told again and again, phrase by phrase.
const SHOTS: [(f32, Framing); 6] = [
    (0.0, Framing::Whole),
    (0.5, Framing::Upper),
    (-0.45, Framing::Whole),
    (-0.12, Framing::Upper),
    (0.65, Framing::Whole),
    (-0.6, Framing::Upper),
];
/// Of a group: nobody is picked out.
const GROUP_SHOTS: [f32; 3] = [0.0, 0.3, -0.3];

/// From where a film is seen at which time.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Shots {
    work: CameraWork,
    is_group: bool,
    /// Times of the cuts [s].
    cuts: Vec<f32>,
}

impl Shots {
    /// Of the dance that so many share.
    pub(super) fn new(production: &Production, dancer_count: usize) -> Self {
        let work = production.design.stage.camera;
        let cuts = match work {
            CameraWork::Cuts => cuts(&production.dance),
            CameraWork::Drift | CameraWork::Still | CameraWork::Turntable => Vec::new(),
        };
        Self {
            work,
            is_group: 1 < dancer_count,
            cuts,
        }
    }

    /// How far around her to her left the camera stands at a time [s], and what it shows [rad].
    pub(super) fn at(&self, time: f32) -> (f32, Framing) {
        match self.work {
            CameraWork::Still => (0.0, Framing::Whole),
            CameraWork::Turntable => (TAU * time / TURN_PERIOD, Framing::Whole),
            CameraWork::Drift => {
                let drift = if self.is_group { GROUP_DRIFT } else { DRIFT };
                let phase = TAU * time / DRIFT_PERIOD;
                (drift * trig::sin(phase), Framing::Whole)
            }
            CameraWork::Cuts => {
                let number = self.cuts.partition_point(|&cut| cut <= time);
                let begun = number.checked_sub(1).map_or(0.0, |it| self.cuts[it]);
                let (azimuth, framing) = if self.is_group {
                    (GROUP_SHOTS[number % GROUP_SHOTS.len()], Framing::Whole)
                } else {
                    SHOTS[number % SHOTS.len()]
                };
                (azimuth + CREEP * (time - begun), framing)
            }
        }
    }

    /// Times of the cuts [s].
    pub(super) fn cuts(&self) -> &[f32] {
        &self.cuts
    }
}

/// When phrases begin [s].
fn cuts(dance: &Danced) -> Vec<f32> {
    let mut begun = 0.0;
    let mut cuts = Vec::new();
    let mut cut = |time: f64| {
        if SHORTEST <= time - begun {
            begun = time;
            cuts.push(lole_geom::narrow(time));
        }
    };
    if let Danced::Step(dance) = dance {
        for count in dance.counts(LONGEST) {
            if count.part.is_some() && (count.number - 1).is_multiple_of(PHRASE_COUNTS) {
                cut(count.time);
            }
        }
    } else {
        let mut time = WITHOUT_COUNTS;
        while time < LONGEST {
            cut(time);
            time += WITHOUT_COUNTS;
        }
    }
    cuts
}
