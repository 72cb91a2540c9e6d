//! The one place that reads clocks.

use std::time::{Duration, Instant};

use cpu_time::{ProcessTime, ThreadTime};
use lole_study::Clock;

/// The machine's clocks since the command began.
pub(crate) struct SystemClock {
    wall: Instant,
    process: ProcessTime,
}

impl SystemClock {
    /// Begins now.
    #[expect(
        clippy::disallowed_methods,
        reason = "the program, not a library, reads the clock"
    )]
    pub(crate) fn start() -> Self {
        Self {
            wall: Instant::now(),
            process: ProcessTime::now(),
        }
    }
}

/// Processor time of this thread since some fixed moment.
pub(crate) fn of_thread() -> Duration {
    ThreadTime::now().as_duration()
}

impl Clock for SystemClock {
    fn wall(&self) -> Duration {
        self.wall.elapsed()
    }

    fn process(&self) -> Duration {
        self.process.elapsed()
    }
}
