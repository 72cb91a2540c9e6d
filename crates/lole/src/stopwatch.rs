//! The one place that reads clocks.

use std::time::Instant;

use cpu_time::ProcessTime;

use crate::figures::Timing;

/// Wall and processor time since it was started.
pub(crate) struct Stopwatch {
    wall: Instant,
    process: ProcessTime,
}

impl Stopwatch {
    /// Starts now.
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

    /// Wall time since the start [s], which costs less to read than the processor's.
    pub(crate) fn read_wall(&self) -> f64 {
        self.wall.elapsed().as_secs_f64()
    }

    /// Processor time since the start, all threads [s].
    pub(crate) fn read_process(&self) -> f64 {
        self.process.elapsed().as_secs_f64()
    }

    /// Time since the start.
    pub(crate) fn read(&self) -> Timing {
        // The processor's clock first: reading it costs more.
        let process_seconds = self.process.elapsed().as_secs_f64();
        Timing {
            process_seconds,
            wall_seconds: self.wall.elapsed().as_secs_f64(),
        }
    }
}
