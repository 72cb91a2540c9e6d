//! Where the time of a frame goes.

use lole_cloth::Phase;
use serde::Serialize;

use crate::figures::median_and_p99;
use crate::{Clock, Stopwatch};

/// Every so manyth frame is observed, and its time does not count: one phase after the other takes
/// a little longer than all of them staggered, with the same bits.
const INTERVAL: u32 = 8;

/// Time of one phase in a frame.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PhaseTime {
    /// Name of the phase.
    pub name: &'static str,
    /// Processor time in a frame: the median of the observed ones.
    pub ms: f64,
    /// Of all phases together.
    pub share_pct: f64,
}

/// Adds up the time of each phase, frame by frame.
pub(super) struct PhaseClock<'a> {
    clock: &'a dyn Clock,
    watch: Stopwatch<'a>,
    /// Of each phase, its time in every observed frame [s].
    seconds: [Vec<f64>; Phase::ALL.len()],
    /// When the last phase ended [s].
    ended: f64,
    /// What a look at the processor's clock takes [s]. The wall's takes less, but on a machine that
    /// does other things it stands still for no one, and the longest phase waits the most.
    look: f64,
}

/// Looks at the clock of which the shortest tells what one takes.
const LOOK_COUNT: u32 = 100;

impl<'a> PhaseClock<'a> {
    /// No frame yet.
    pub(super) fn new(clock: &'a dyn Clock) -> Self {
        let watch = Stopwatch::start(clock);
        let looks = (0..LOOK_COUNT).map(|_| {
            let start = watch.read_process();
            watch.read_process() - start
        });
        Self {
            look: looks.fold(f64::INFINITY, f64::min),
            clock,
            watch,
            seconds: Default::default(),
            ended: 0.0,
        }
    }

    /// Whether a frame is one of those to be observed.
    pub(super) const fn observes(frame: u32) -> bool {
        frame % INTERVAL == INTERVAL - 1
    }

    /// A stopwatch by the same clock, started now.
    pub(super) fn stopwatch(&self) -> Stopwatch<'a> {
        Stopwatch::start(self.clock)
    }

    /// Starts a frame.
    pub(super) fn begin_frame(&mut self) {
        self.seconds.iter_mut().for_each(|frames| frames.push(0.0));
        self.ended = self.watch.read_process();
    }

    /// A phase has ended.
    pub(super) fn passed(&mut self, phase: Phase) {
        let now = self.watch.read_process();
        if let Some(seconds) = self.seconds[phase as usize].last_mut() {
            *seconds += (now - self.ended - self.look).max(0.0);
        }
        self.ended = now;
    }

    /// Median time of a phase in a frame [s].
    pub(super) fn median(&self, phase: Phase) -> f64 {
        median_and_p99(&self.seconds[phase as usize]).median
    }

    /// Every phase that took any time; `None` where none did.
    pub(super) fn times(&self) -> Option<Vec<PhaseTime>> {
        let sum: f64 = Phase::ALL.iter().map(|&phase| self.median(phase)).sum();
        let time = |phase: Phase| PhaseTime {
            name: phase.id(),
            ms: 1e3 * self.median(phase),
            share_pct: 100.0 * self.median(phase) / sum,
        };
        let taken = Phase::ALL
            .into_iter()
            .filter(|&phase| 0.0 < self.median(phase));
        (0.0 < sum).then(|| taken.map(time).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clock::TestClock;

    #[test]
    fn shares_of_the_phases_are_those_of_their_medians() {
        let machine = TestClock::start();
        let mut clock = PhaseClock::new(&machine);
        assert_eq!(clock.times(), None);
        clock.seconds[Phase::Springs as usize] = vec![3.0, 900.0, 3.0];
        clock.seconds[Phase::Bend as usize] = vec![1.0, 1.0, 0.0];
        let times = clock.times().unwrap();
        let shares: Vec<_> = times
            .iter()
            .map(|time| (time.name, time.share_pct))
            .collect();
        assert_eq!(shares, [("bend", 25.0), ("springs", 75.0)]);
    }

    #[test]
    fn a_phase_takes_the_processor_s_time_until_it_ends() {
        let machine = TestClock::start();
        let mut clock = PhaseClock::new(&machine);
        clock.begin_frame();
        clock.passed(Phase::Bend);
        let watch = clock.stopwatch();
        while watch.read_process() < 5e-3 {}
        clock.passed(Phase::Springs);
        let [bend, springs] = [Phase::Bend, Phase::Springs].map(|phase| clock.median(phase));
        assert!(bend < springs && 4e-3 < springs, "{bend} s and {springs} s");
    }
}
