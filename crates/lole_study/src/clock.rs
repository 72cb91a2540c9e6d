//! How long something took, by the caller's clock.

/// What tells the time: the caller's, because libraries have no clock.
pub trait Clock: Sync {
    /// Wall time since some fixed moment [s]; costs less to read than the processor's.
    fn wall_seconds(&self) -> f64;
    /// Processor time of all threads since some fixed moment [s].
    fn process_seconds(&self) -> f64;
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
    start: Timing,
}

impl<'a> Stopwatch<'a> {
    /// Starts now.
    #[must_use]
    pub fn start(clock: &'a dyn Clock) -> Self {
        let start = Timing {
            wall_seconds: clock.wall_seconds(),
            process_seconds: clock.process_seconds(),
        };
        Self { clock, start }
    }

    /// Wall time since the start [s].
    #[must_use]
    pub fn read_wall(&self) -> f64 {
        self.clock.wall_seconds() - self.start.wall_seconds
    }

    /// Processor time since the start, all threads [s].
    #[must_use]
    pub fn read_process(&self) -> f64 {
        self.clock.process_seconds() - self.start.process_seconds
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
    fn wall_seconds(&self) -> f64 {
        self.wall.elapsed().as_secs_f64()
    }

    fn process_seconds(&self) -> f64 {
        self.process.elapsed().as_secs_f64()
    }
}
