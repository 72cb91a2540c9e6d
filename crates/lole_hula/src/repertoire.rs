//! The table of dance steps. A new step is a file in `repertoire/` and a row here.

mod ai_kawele;
mod ami;
mod aui;
mod hela;
mod holo;
mod kaapuni;
mod kaholo;
mod kalakaua;
mod kao;
mod kawelu;
mod kui;
mod lele;
mod nee;
mod uwehe;

use lole_language::Words;

use super::choreography::MOST_COUNTS;
use super::score::{Answer, Basis, Fact, Landing, STILL, Score};
use super::sources::{SOURCES, Source};

/// How much farther a foot lands on a way than its step takes it [statures], 16 cm.
const MOST_STRIDE: f32 = 0.10;
/// Counts of a flight; a foot gets less far in a quicker one.
const USUAL_FLIGHT: f32 = 0.5;

macro_rules! repertoire {
    ($($(#[$doc:meta])* $variant:ident = $score:path;)*) => {
        /// A basic step of hula.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum DanceStep {
            $($(#[$doc])* $variant,)*
        }

        /// All steps, in the order they are taught.
        const ALL: &[DanceStep] = &[$(DanceStep::$variant,)*];

        impl DanceStep {
            /// What the step is.
            pub(super) const fn score(self) -> &'static Score {
                match self {
                    $(Self::$variant => const { &$score },)*
                }
            }
        }
    };
}

repertoire! {
    /// Sway in place.
    Kao = kao::KAO;
    /// Two sliding steps to each side.
    Kaholo = kaholo::KAHOLO;
    /// The hips circle over standing feet.
    Ami = ami::AMI;
    /// A foot is lifted and put down, then both heels snap up.
    Uwehe = uwehe::UWEHE;
    /// Kāholo that sinks on its first count.
    KaholoDip = kaholo::KAHOLO_DIP;
    /// Kāholo of four steps each way.
    KaholoDouble = kaholo::KAHOLO_DOUBLE;
    /// Kāholo forward and back.
    KaholoForward = kaholo::KAHOLO_FORWARD;
    /// Kāholo forward to the right and back to the left.
    KaholoDiagonal = kaholo::KAHOLO_DIAGONAL;
    /// A foot points forward and out, and comes back.
    Hela = hela::HELA;
    /// Large, slow ʻami.
    AmiKahela = ami::AMI_KAHELA;
    /// Two large ʻami and three small fast ones.
    AmiKuu = ami::AMI_KUU;
    /// Figure of eight of the hips.
    AmiOniu = ami::AMI_ONIU;
    /// ʻAmi cut straight across the front.
    AmiHalfMoon = ami::AMI_HALF_MOON;
    /// Round the ball of one foot with ʻami.
    Kaapuni = kaapuni::KAAPUNI;
    /// Heel beats while the other foot goes forward and back.
    Kawelu = kawelu::KAWELU;
    /// Kāholo that goes forward and back, zigzag.
    KaweluZigzag = kawelu::KAWELU_ZIGZAG;
    /// The English name of the dictionary's kāwelu.
    Kalakaua = kalakaua::KALAKAUA;
    /// Kaʻo whose foot goes to the front and back.
    KalakauaSway = kalakaua::KALAKAUA_SWAY;
    /// Kāholo that opens a quarter turn.
    KalakauaTurn = kalakaua::KALAKAUA_TURN;
    /// Walking forward and back.
    Lele = lele::LELE;
    /// Step, point, close and snap.
    LeleUwehe = lele::LELE_UWEHE;
    /// The foot twists and the heel stamps.
    Kui = kui::KUI;
    /// A foot draws half a circle in the air.
    AiKawele = ai_kawele::AI_KAWELE;
    /// Running sideways.
    Holo = holo::HOLO;
    /// Turned aside, pointing again and again.
    Aui = aui::AUI;
    /// Kaʻo that creeps to the side.
    Nee = nee::NEE;
    /// A small ʻami as fast as the drum.
    Hue = ami::HUE;
}

/// The ready stance as a score: nothing moves.
pub(super) static STANCE: Score = STILL;

impl DanceStep {
    /// All steps, in the order they are taught.
    pub const ALL: [Self; ALL.len()] = {
        let mut all = [Self::Kao; ALL.len()];
        let mut i = 0;
        while i < ALL.len() {
            all[i] = ALL[i];
            i += 1;
        }
        all
    };

    /// Whether the weight goes to another foot, so that it can take somebody anywhere.
    #[must_use]
    pub fn walks(self) -> bool {
        let steps = |landing: &Landing| 0.0 < landing.lift && 0.0 < landing.carry;
        let mut feet = self.score().feet.iter();
        feet.any(|foot| foot.landings.iter().any(steps))
    }

    /// How far feet carry somebody in so many counts besides what the step does [statures]; 0 where she steps on no
    /// foot.
    #[must_use]
    pub fn longest_way(self, counts: u32) -> f32 {
        if !self.walks() {
            return 0.0;
        }
        let shares = self.longest_share(0).zip(self.longest_share(1));
        shares.map_or(0.0, |(left, right)| {
            MOST_STRIDE * counts as f32 / left.max(right)
        })
    }

    /// Counts in which feet carry somebody so far [statures], in whole phrases; those of a longest part where she
    /// steps on no foot.
    pub(super) fn counts_for(self, way: f32) -> u32 {
        let phrases = 1..=MOST_COUNTS / self.phrase();
        let mut counts = phrases.map(|phrases| phrases * self.phrase());
        let enough = |counts: &u32| way <= self.longest_way(*counts);
        counts.find(enough).unwrap_or(MOST_COUNTS)
    }

    /// How many counts of a way a foot [left, right] makes up for in one flight, at most, where a quick flight counts
    /// for more; `None` where it never flies.
    fn longest_share(self, foot: usize) -> Option<f32> {
        let score = self.score();
        let flights = |foot: usize, from: f32| {
            let flies = |landing: &&Landing| 0.0 < landing.lift;
            let flights = score.feet[foot].landings.iter().filter(flies);
            flights.map(move |landing| (from + landing.count, landing.flight))
        };
        let (counts, flights): (f32, Vec<(f32, f32)>) = match score.answer {
            Answer::Repeat => (score.half, flights(foot, 0.0).collect()),
            // In the answer each foot does what the other did.
            Answer::Mirror | Answer::MirrorBackward => (
                2.0 * score.half,
                flights(foot, 0.0)
                    .chain(flights(1 - foot, score.half))
                    .collect(),
            ),
        };
        let last = flights.last().map(|(landed, _)| landed - counts);
        let before = last
            .into_iter()
            .chain(flights.iter().map(|flight| flight.0));
        let stands = flights.iter().zip(before);
        let shares = stands
            .map(|((landed, flight), before)| (landed - before) * (USUAL_FLIGHT / flight).max(1.0));
        shares.reduce(f32::max)
    }

    /// Name in documents and on the command line: ASCII, lower case.
    #[must_use]
    pub const fn id(self) -> &'static str {
        self.score().id
    }

    /// Name as it is written in Hawaiian, with ʻokina and kahakō; a variant in brackets.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.score().name
    }

    /// Name as it is said in Japanese, and what the name or the variant means in English.
    #[must_use]
    pub const fn title(self) -> Words {
        self.score().title
    }

    /// What it is, in one sentence.
    #[must_use]
    pub const fn about(self) -> Words {
        self.score().about
    }

    /// What a teacher says on each count of the written side, first count first.
    #[must_use]
    pub const fn teaching(self) -> &'static [Words] {
        self.score().teaching
    }

    /// What only a kumu can answer.
    #[must_use]
    pub const fn questions(self) -> &'static [Words] {
        self.score().questions
    }

    /// What is said of the step, and on whose word.
    pub fn statements(self) -> impl Iterator<Item = Statement> {
        self.score().facts.iter().map(Statement::of)
    }

    /// Slowest and fastest tempo it is danced at [counts per minute]. No measured tempi are
    /// published, so these are estimates; a dance may be slower or faster.
    #[must_use]
    pub const fn tempo(self) -> [f32; 2] {
        self.score().tempo
    }

    /// The step whose [`id`](Self::id) is `id`.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|step| step.id() == id)
    }

    /// Counts (beats) of one whole loop, right and left halves together.
    #[must_use]
    pub fn counts(self) -> u32 {
        whole(self.score().counts())
    }

    /// Counts of one phrase, the part that is danced to one side before the other answers.
    #[must_use]
    pub fn phrase(self) -> u32 {
        whole(self.score().half)
    }

    /// Local count of the teacher's "1", from the beginning of the loop: 0 or 1.
    #[must_use]
    pub fn first_count(self) -> u32 {
        whole(self.score().first_count)
    }
}

/// A statement about a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statement {
    /// The statement.
    pub what: Words,
    /// Published sources it is taken from; empty where it is computed or estimated.
    pub sources: &'static [&'static str],
    /// Whether it is an estimate, to be judged by a dancer.
    pub estimated: bool,
}

impl Statement {
    const fn of(fact: &Fact) -> Self {
        let (sources, estimated): (&'static [&'static str], _) = match fact.basis {
            Basis::Sources(keys) => (keys, false),
            Basis::Derived => (&[], false),
            Basis::Estimated => (&[], true),
        };
        Self {
            what: fact.what,
            sources,
            estimated,
        }
    }

    /// The sources it is taken from.
    pub fn cited(self) -> impl Iterator<Item = &'static Source> {
        (self.sources.iter()).filter_map(|key| SOURCES.iter().find(|source| source.key == *key))
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts are small whole numbers"
)]
fn whole(counts: f32) -> u32 {
    counts as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MotionSettings;
    use crate::steps::{Moment, Reading, stands, tracks};

    #[test]
    fn every_step_has_its_words_and_every_source_is_listed() {
        let mut ids = std::collections::BTreeSet::new();
        for step in DanceStep::ALL {
            let id = step.id();
            assert!(ids.insert(id), "{id} twice");
            assert!(
                id.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'),
                "{id}"
            );
            assert_eq!(step.teaching().len(), step.phrase() as usize, "{id}");
            assert!(
                !step.name().is_empty() && !step.title().japanese.is_empty(),
                "{id}"
            );
            assert!(!step.questions().is_empty(), "{id}");
            assert!(0 < step.statements().count(), "{id}");
            for statement in step.statements() {
                assert_eq!(statement.cited().count(), statement.sources.len(), "{id}");
            }
        }
    }

    #[test]
    fn halves_end_where_their_answers_begin() {
        let settings = MotionSettings::default();
        for step in DanceStep::ALL {
            let score = step.score();
            let reading = Reading {
                score,
                settings: &settings,
            };
            let tracks = tracks(reading);
            for boundary in [score.half, score.counts()] {
                let before = Moment::of(score, boundary - 1e-3);
                let after = Moment::of(score, boundary + 1e-3);
                let [a, b] = [before, after].map(|moment| stands(reading, &tracks, moment));
                for i in 0..2 {
                    let gap = (a[i].x - b[i].x).abs() + (a[i].z - b[i].z).abs();
                    let turn = (a[i].heading + a[i].twist - b[i].heading - b[i].twist) % 360.0;
                    assert!(gap < 1e-3, "{}: foot {i} jumps by {gap}", step.id());
                    assert!(turn.abs() < 0.1, "{}: foot {i} turns by {turn}", step.id());
                    assert!(
                        (a[i].heel - b[i].heel).abs() < 1e-3,
                        "{}: heel {i}",
                        step.id()
                    );
                }
            }
        }
    }

    #[test]
    fn strides_are_as_wide_as_weight_is_carried() {
        let settings = MotionSettings::default();
        for step in DanceStep::ALL {
            let score = step.score();
            let reading = Reading {
                score,
                settings: &settings,
            };
            let tracks = tracks(reading);
            // A foot without weight may reach farther.
            let free = score
                .feet
                .iter()
                .flat_map(|foot| foot.landings)
                .any(|l| l.carry < 0.5);
            // A foot that turns on its ball is elsewhere than it was set down.
            let turns = score.feet.iter().any(|foot| !foot.twist.changes.is_empty());
            if free || turns || step == DanceStep::LeleUwehe {
                continue;
            }
            for i in 0..100 {
                let count = score.counts() * i as f32 / 100.0;
                let feet = stands(reading, &tracks, Moment::of(score, count));
                let [left, right] = feet;
                let (dx, dz) = (left.x - right.x, left.z - right.z);
                let apart = (dx * dx + dz * dz).sqrt();
                let stride = score.stride.length(&settings);
                assert!(apart < stride + 0.005, "{} at {count}: {apart}", step.id());
            }
        }
    }
}
