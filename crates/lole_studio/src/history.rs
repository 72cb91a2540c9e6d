//! The last seconds of the dance as numbers, for the graphs.

use std::collections::VecDeque;

use lole_stage::Vitals;

/// Frames that are kept: ten seconds.
const LENGTH: usize = 600;

/// One frame of the simulation in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time of the dance [s]; negative while the skirt settles.
    pub time: f32,
    /// Wall time that the frame took [ms].
    pub milliseconds: f32,
    /// The cloth's figures.
    pub vitals: Vitals,
}

/// The last samples, the newest last.
#[derive(Debug, Clone, Default)]
pub struct History {
    samples: VecDeque<Sample>,
}

impl History {
    /// Adds a sample; one of an earlier time starts a new history.
    pub fn push(&mut self, sample: Sample) {
        if (self.samples.back()).is_some_and(|last| sample.time < last.time) {
            self.samples.clear();
        }
        if self.samples.len() == LENGTH {
            self.samples.pop_front();
        }
        self.samples.push_back(sample);
    }

    /// The samples, the newest last.
    pub fn samples(&self) -> impl ExactSizeIterator<Item = &Sample> {
        self.samples.iter()
    }

    /// Median wall time of the last second's frames [ms].
    #[must_use]
    pub fn milliseconds(&self) -> Option<f32> {
        let mut last: Vec<f32> = (self.samples.iter().rev().take(60))
            .map(|sample| sample.milliseconds)
            .collect();
        last.sort_by(f32::total_cmp);
        last.get(last.len() / 2).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(time: f32) -> Sample {
        Sample {
            time,
            milliseconds: time,
            vitals: Vitals::default(),
        }
    }

    #[test]
    fn the_newest_ten_seconds_are_kept_and_a_new_start_forgets_the_old() {
        let mut history = History::default();
        for frame in 0..1000_u16 {
            history.push(sample(f32::from(frame)));
        }
        assert_eq!(history.samples().len(), LENGTH);
        assert_eq!(history.samples().last().map(|s| s.time), Some(999.0));
        assert_eq!(history.milliseconds(), Some(970.0));
        history.push(sample(-3.0));
        assert_eq!(history.samples().len(), 1);
    }
}
