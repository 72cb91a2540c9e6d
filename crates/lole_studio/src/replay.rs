//! Seeing again what was danced: the show stands still meanwhile, and goes on where it was left.

use std::sync::Arc;

use lole_costume::document::MotionRepeat;

use crate::message::Message;
use crate::studio::Studio;
use crate::take::Way;
use crate::{Command, Snapshot, platform};

/// What is seen again, and how.
pub struct Replay {
    /// The moment that is shown [s of the dance].
    pub at: f32,
    /// Whether it goes on by itself.
    pub plays: bool,
    /// Whether the show danced when it was left.
    danced: bool,
    /// The newest moment of the show.
    live: Arc<Snapshot>,
}

impl Studio {
    /// Takes in a new moment of the show.
    pub fn receive(&mut self, snapshot: Arc<Snapshot>) {
        for sample in &snapshot.samples {
            self.history.push(*sample);
        }
        self.stopped = snapshot.stopped;
        self.take.keep(&snapshot, platform::TAKE_BYTES);
        match &mut self.replay {
            Some(replay) if replay.live.wardrobe.id == snapshot.wardrobe.id => {
                replay.live = snapshot;
            }
            // Something else is worn now, and that is what is wanted to be seen.
            Some(_) => {
                self.dance_on();
                self.snapshot = Some(snapshot);
            }
            None => self.snapshot = Some(snapshot),
        }
    }

    /// Shows a moment of what was danced [s]; the show stands still until [`Self::dance_on`].
    pub fn look_again(&mut self, at: f32) {
        let (Some([first, last]), Some(live)) = (self.take.span(), self.snapshot.clone()) else {
            return;
        };
        let at = at.clamp(first, last);
        match &mut self.replay {
            Some(replay) => replay.at = at,
            None => {
                self.replay = Some(Replay {
                    at,
                    plays: false,
                    danced: self.plays,
                    live,
                });
                self.plays = false;
                self.command(Command::Pause);
            }
        }
        self.show_again();
    }

    /// Goes back to the show, which dances on if it did.
    pub fn dance_on(&mut self) {
        let Some(replay) = self.replay.take() else {
            return;
        };
        self.phrase = [None; 2];
        self.snapshot = Some(replay.live);
        if replay.danced {
            self.plays = true;
            self.command(Command::Play);
        }
    }

    /// From where to where is seen again [s]: the phrase that was chosen, or everything.
    #[must_use]
    pub fn phrase_span(&self) -> Option<[f32; 2]> {
        let [first, last] = self.take.span()?;
        let [from, to] = self.phrase;
        let from = from.unwrap_or(first).clamp(first, last);
        let to = to.unwrap_or(last).clamp(first, last);
        Some(if from < to { [from, to] } else { [first, last] })
    }

    /// Lets what is seen again go on by so many seconds on the wall; whether it moves.
    pub fn replay_on(&mut self, seconds: f64) -> bool {
        let Some([from, to]) = self.phrase_span() else {
            return false;
        };
        let speed = self.speed;
        let Some(replay) = self.replay.as_mut().filter(|replay| replay.plays) else {
            return false;
        };
        let way = lole_geom::narrow(seconds * speed);
        // From its beginning again, also where the hand was outside of the phrase.
        let next = replay.at + way;
        replay.at = if next < from || to < next { from } else { next };
        self.show_again();
        true
    }

    /// The moment before or after, as they were kept.
    pub(crate) fn step_again(&mut self, way: Way) {
        let at = (self.replay.as_ref()).map_or(f32::INFINITY, |replay| replay.at);
        let beside = self.take.next(at, way);
        self.look_again(beside);
        if let Some(replay) = &mut self.replay {
            replay.plays = false;
        }
    }

    /// Shows a part of the choreography over and over, as it was danced last; whether it was danced.
    pub(crate) fn see_part(&mut self, index: usize) -> bool {
        let Some([from, to]) = self.take.of_part(index) else {
            return false;
        };
        self.phrase = [Some(from), Some(to)];
        self.look_again(from);
        if let Some(replay) = &mut self.replay {
            replay.plays = true;
        }
        true
    }

    fn show_again(&mut self) {
        if let Some(replay) = &self.replay
            && let Some(shown) = self.take.at(replay.at)
        {
            self.snapshot = Some(Arc::new(shown));
        }
    }

    /// Dances on or stands still: the show, or what is seen again.
    pub fn toggle_playing(&mut self) {
        if let Some(replay) = &mut self.replay {
            replay.plays = !replay.plays;
            return;
        }
        self.plays = !self.plays;
        self.command(if self.plays {
            Command::Play
        } else {
            Command::Pause
        });
    }

    /// Lets what was danced last be danced once more beside what is on stage.
    pub fn keep_beside(&mut self) {
        self.dance_on();
        self.kept = Some(Arc::new(self.take.clone()));
        self.message = Some(Message::news(
            "いまの踊りを右に並べました。衣装・布・寸法を変えると、左がその新しいほうです。",
            "This dance is kept on the right; change costume, cloth or measures, and the left one shows it.",
        ));
    }

    /// The moment of the kept dance that belongs to a time [s] of the one on stage: the same count of the dance.
    #[must_use]
    pub fn kept_time(&self, time: f32) -> Option<f32> {
        let [first, last] = self.kept.as_ref()?.span()?;
        let Some(period) = self.period().filter(|period| *period < last - first) else {
            return Some(time.clamp(first, last));
        };
        // As many times around less, or more, as were kept.
        let rounds = ((time - last) / period).ceil().max(0.0);
        let more = ((first - time) / period).ceil().max(0.0);
        Some((time + (more - rounds) * period).clamp(first, last))
    }

    /// How long a dance is that is danced over and over [s].
    fn period(&self) -> Option<f32> {
        let motion = &self.design().motion;
        if motion.file.is_some() {
            let seconds = self.snapshot.as_ref()?.recording_seconds;
            return seconds.filter(|_| motion.repeat == MotionRepeat::Loop);
        }
        let seconds = f64::from(motion.step.counts()) * 60.0 / motion.tempo_bpm;
        (motion.parts.is_empty()).then(|| lole_geom::narrow(seconds))
    }

    /// Whether what is shown moves.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.replay
            .as_ref()
            .map_or(self.plays, |replay| replay.plays)
    }

    /// One frame, then still.
    pub fn step(&mut self) {
        if self.replay.is_some() {
            self.step_again(Way::On);
            return;
        }
        self.plays = false;
        self.command(Command::Step);
    }

    /// From the beginning.
    pub fn reset(&mut self) {
        if self.replay.is_some() {
            if let Some([from, _]) = self.phrase_span() {
                self.look_again(from);
            }
            return;
        }
        self.plays = true;
        self.command(Command::Reset);
        self.command(Command::Play);
    }
}

#[cfg(test)]
mod tests {
    use lole_costume::document::{Design, PartDesign};
    use lole_language::Language;
    use lole_stage::PartNow;

    use super::*;
    use crate::take::tests::{moment, wardrobe};

    /// A window in which ten seconds were danced, five in each of two parts.
    fn danced() -> Studio {
        let mut studio = Studio::new(Language::English, Design::default(), None);
        let wardrobe = wardrobe();
        for tenth in 0_u8..=100 {
            let mut shown = moment(&wardrobe, f32::from(tenth) / 10.0);
            shown.part = Some(PartNow {
                index: usize::from(tenth / 51),
                share: f32::from(tenth % 51) / 50.0,
            });
            studio.receive(Arc::new(shown));
        }
        studio
    }

    fn shown(studio: &Studio) -> f32 {
        studio.snapshot.as_ref().expect("something is shown").time
    }

    #[test]
    fn the_show_stands_still_while_it_is_seen_again_and_goes_on_after_it() {
        let mut studio = danced();
        studio.look_again(3.2);
        assert_eq!(studio.take_commands(), [Command::Pause]);
        assert!((shown(&studio) - 3.2).abs() < 1e-4 && !studio.moves());
        studio.toggle_playing();
        assert!(studio.moves() && studio.take_commands().is_empty());
        studio.speed = 0.5;
        assert!(studio.replay_on(0.4));
        assert!((shown(&studio) - 3.4).abs() < 1e-4);
        studio.step();
        assert!((shown(&studio) - 3.5).abs() < 1e-4 && !studio.moves());
        studio.dance_on();
        assert_eq!(studio.take_commands(), [Command::Play]);
        assert!((shown(&studio) - 10.0).abs() < 1e-4 && studio.moves());
        // What stood still before stands still after.
        studio.toggle_playing();
        studio.look_again(1.0);
        studio.dance_on();
        assert!(!studio.moves());
    }

    #[test]
    fn a_phrase_is_seen_over_and_over() {
        let mut studio = danced();
        assert!(studio.see_part(1));
        assert!((shown(&studio) - 5.1).abs() < 1e-4);
        let mut seen = Vec::new();
        for _ in 0..40 {
            studio.replay_on(0.3);
            seen.push(shown(&studio));
        }
        assert!(
            seen.iter().all(|time| (5.09..=10.01).contains(time)),
            "{seen:?}"
        );
        assert!(1 < seen.windows(2).filter(|pair| pair[1] < pair[0]).count());
        studio.phrase = [None; 2];
        studio.reset();
        assert!(shown(&studio).abs() < 1e-4);
        assert!(!studio.see_part(7));
    }

    #[test]
    fn the_kept_dance_is_at_the_same_count_as_the_one_on_stage() {
        let mut studio = danced();
        studio.keep_beside();
        let motion = &studio.design().motion;
        let period = f64::from(motion.step.counts()) * 60.0 / motion.tempo_bpm;
        let period = lole_geom::narrow(period);
        for tenth in 0_u16..600 {
            let time = f32::from(tenth) / 10.0;
            let kept = studio.kept_time(time).expect("it is kept");
            assert!((0.0..=10.0).contains(&kept), "{time} {kept}");
            let rounds = (time - kept) / period;
            assert!(
                (rounds - rounds.round()).abs() < 1e-3,
                "{time} {kept} {period}"
            );
        }
        // A choreography is danced once: after its end she stands there.
        studio.change(|design| design.motion.parts = vec![PartDesign::default()]);
        assert_eq!(studio.kept_time(60.0), Some(10.0));
        // What comes on stage later is another take; the kept one stays.
        studio.receive(Arc::new(moment(&wardrobe(), 0.5)));
        assert!(
            studio
                .kept
                .as_ref()
                .is_some_and(|kept| kept.span().is_some())
        );
    }

    #[test]
    fn what_is_worn_anew_ends_what_is_seen_again() {
        let mut studio = danced();
        studio.look_again(2.0);
        studio.receive(Arc::new(moment(&wardrobe(), 10.5)));
        assert!(studio.replay.is_none() && studio.moves());
        assert!((shown(&studio) - 10.5).abs() < 1e-4);
        assert_eq!(studio.take_commands(), [Command::Pause, Command::Play]);
    }
}
