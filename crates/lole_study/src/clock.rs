//! How long something took, by the caller's clock.

use std::time::Duration;

/// What tells the time: the caller's, because libraries have no clock.
pub trait Clock: Sync {
    /// Wall time since some fixed moment; costs less to read than the processor's.
    fn wall(&self) -> Duration;
    /// Processor time of all threads since some fixed moment.
    fn process(&self) -> Duration;
}

/// How long one frame of simulation took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Processor time of all threads [s].
    pub process_seconds: f64,
    /// Time on the wall [s].
    pub wall_seconds: f64,
}

/// Wall and processor time since it was started.
#[derive(Clone, Copy)]
pub struct Stopwatch<'a> {
    clock: &'a dyn Clock,
    wall_start: Duration,
    process_start: Duration,
}

impl<'a> Stopwatch<'a> {
    /// Starts now.
    #[must_use]
    pub fn start(clock: &'a dyn Clock) -> Self {
        Self {
            clock,
            wall_start: clock.wall(),
            process_start: clock.process(),
        }
    }

    /// Wall time since the start [s].
    #[must_use]
    pub fn read_wall(&self) -> f64 {
        (self.clock.wall().saturating_sub(self.wall_start)).as_secs_f64()
    }

    /// Processor time since the start, all threads [s].
    #[must_use]
    pub fn read_process(&self) -> f64 {
        (self.clock.process().saturating_sub(self.process_start)).as_secs_f64()
    }

    /// Time since the start.
    #[must_use]
    pub fn read(&self) -> Timing {
        // The processor's clock first: reading it costs more.
        let process_seconds = self.read_process();
        Timing {
            process_seconds,
            wall_seconds: self.read_wall(),
        }
    }
}

/// The machine's clocks, for tests.
#[cfg(test)]
pub(crate) struct TestClock {
    wall: std::time::Instant,
    process: cpu_time::ProcessTime,
}

#[cfg(test)]
impl TestClock {
    #[expect(
        clippy::disallowed_methods,
        reason = "a test that compares times, not a library, reads the clock"
    )]
    pub(crate) fn start() -> Self {
        Self {
            wall: std::time::Instant::now(),
            process: cpu_time::ProcessTime::now(),
        }
    }
}

#[cfg(test)]
impl Clock for TestClock {
    fn wall(&self) -> Duration {
        self.wall.elapsed()
    }

    fn process(&self) -> Duration {
        self.process.elapsed()
    }
}
