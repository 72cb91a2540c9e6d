//! When the next frame is due: never before its time by the clock, and without a debt that a slow
//! machine could only pay by racing.

use lole_stage::FRAMES_PER_SECOND;

/// A hiccup of this many frames is caught up with; a longer one is forgotten.
const DEBT: f64 = 2.0;
/// The pace is measured over about this time [s].
const MEMORY: f64 = 1.0;

/// The clock of a show. Times are seconds on the wall from any start.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    speed: f64,
    next_due: f64,
    /// Start of the present measurement, frames in it, and the last result.
    measured_from: f64,
    frames: u32,
    measured: Option<f64>,
}

impl Pace {
    /// A clock that starts at `now`.
    pub(crate) const fn new(now: f64, speed: f64) -> Self {
        Self {
            speed,
            next_due: now,
            measured_from: now,
            frames: 0,
            measured: None,
        }
    }

    /// Time from one frame to the next [s].
    pub(crate) fn period(&self) -> f64 {
        1.0 / (f64::from(FRAMES_PER_SECOND) * self.speed)
    }

    /// Time until the next frame may be worked out [s]; 0 when it is due.
    pub(crate) const fn wait(&self, now: f64) -> f64 {
        (self.next_due - now).max(0.0)
    }

    /// Notes that a frame was begun at `now`.
    pub(crate) fn begin(&mut self, now: f64) {
        let period = self.period();
        let oldest = now - DEBT * period;
        self.next_due = (self.next_due + period).max(oldest);
        self.frames += 1;
        let elapsed = now - self.measured_from;
        if MEMORY <= elapsed {
            self.measured = Some(f64::from(self.frames) / f64::from(FRAMES_PER_SECOND) / elapsed);
            self.measured_from = now;
            self.frames = 0;
        }
    }

    /// Seconds of the dance in one second on the wall; `None` in the first second.
    pub(crate) const fn measured(&self) -> Option<f64> {
        self.measured
    }

    /// Goes on at another speed.
    pub(crate) const fn set_speed(&mut self, now: f64, speed: f64) {
        *self = Self::new(now, speed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames danced in `seconds` when one costs `cost` [s].
    fn frames_in(seconds: f64, speed: f64, cost: f64) -> (f64, Pace) {
        let (mut now, mut frames) = (0.0, 0.0);
        let mut pace = Pace::new(now, speed);
        loop {
            now += pace.wait(now);
            if seconds <= now {
                return (frames, pace);
            }
            pace.begin(now);
            frames += 1.0;
            now += cost;
        }
    }

    #[test]
    fn a_fast_machine_keeps_time_and_never_runs_ahead() {
        for speed in [1.0, 0.25] {
            let (frames, pace) = frames_in(10.0, speed, 0.002);
            assert!((frames - 600.0 * speed).abs() <= 1.0, "{frames}");
            assert!(
                pace.measured()
                    .is_some_and(|pace| (pace - speed).abs() < 0.02)
            );
        }
    }

    #[test]
    fn a_slow_machine_falls_behind_and_does_not_race_afterwards() {
        let (frames, pace) = frames_in(10.0, 1.0, 1.0 / 30.0);
        assert!((frames - 300.0).abs() <= 1.0, "{frames}");
        assert!(
            pace.measured()
                .is_some_and(|pace| (pace - 0.5).abs() < 0.03)
        );
        // After a long hiccup at most the debt is caught up with.
        let mut pace = Pace::new(0.0, 1.0);
        pace.begin(5.0);
        let mut at_once = 0;
        while pace.wait(5.0) == 0.0 {
            pace.begin(5.0);
            at_once += 1;
        }
        assert!(at_once <= 3, "{at_once}");
    }
}
