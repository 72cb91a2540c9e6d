//! When counts fall: tempo that changes from part to part, and counts as times.

/// Counts within which a new tempo is reached.
pub(super) const CHANGE_COUNTS: f64 = 2.0;

/// When every count of a dance falls.
///
/// Within a span the length of a beat changes evenly from count to count, so that time is a
/// quadratic of the count: `t = t₀ + p n + q n²` for `n` counts into the span.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tempo {
    spans: Vec<Span>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Span {
    /// First count and its time [s].
    count: f64,
    time: f64,
    /// Counts per minute at the beginning and at the end.
    bpm: [f64; 2],
    /// Counts of the span.
    counts: f64,
}

impl Span {
    /// Time [s] of `n` counts into the span.
    fn time_of(&self, n: f64) -> f64 {
        let [first, last] = self.bpm.map(|bpm| 60.0 / bpm);
        self.time + first * n + 0.5 * (last - first) / self.counts * n * n
    }

    /// Counts after `time` [s] of the span: the root of the quadratic that begins at 0.
    fn counts_in(&self, time: f64) -> f64 {
        let [from, to] = self.bpm;
        if from.to_bits() == to.to_bits() {
            return time * from / 60.0;
        }
        let [first, last] = self.bpm.map(|bpm| 60.0 / bpm);
        let bend = 0.5 * (last - first) / self.counts;
        2.0 * time / (first + (first * first + 4.0 * bend * time).max(0.0).sqrt())
    }
}

impl Tempo {
    /// One tempo [counts per minute] throughout.
    pub(super) fn even(bpm: f32) -> Self {
        let bpm = f64::from(bpm);
        let span = Span {
            count: 0.0,
            time: 0.0,
            bpm: [bpm, bpm],
            counts: f64::INFINITY,
        };
        Self { spans: vec![span] }
    }

    /// From `count` on, `bpm` counts per minute, reached within [`CHANGE_COUNTS`] or `counts` if
    /// these are fewer. Changes are given in order.
    pub(super) fn change(&mut self, count: f64, counts: f64, bpm: f32) {
        let bpm = f64::from(bpm);
        let time = self.time_of(count);
        let Some(span) = self.spans.last_mut() else {
            return;
        };
        let before = span.bpm[1];
        if before.to_bits() == bpm.to_bits() {
            return;
        }
        span.counts = span.counts.min(count - span.count);
        let change = Span {
            count,
            time,
            bpm: [before, bpm],
            counts: CHANGE_COUNTS.min(counts),
        };
        let after = Span {
            count: count + change.counts,
            time: change.time_of(change.counts),
            bpm: [bpm, bpm],
            counts: f64::INFINITY,
        };
        self.spans.retain(|span| 0.0 < span.counts);
        self.spans.extend([change, after]);
    }

    /// Time [s] of a count.
    pub(super) fn time_of(&self, count: f64) -> f64 {
        let span = (self.spans.iter().rev()).find(|span| span.count <= count);
        span.or(self.spans.first())
            .map_or(0.0, |span| span.time_of_count(count))
    }

    /// Count at a time [s].
    pub(super) fn count_at(&self, time: f64) -> f64 {
        let span = (self.spans.iter().rev()).find(|span| span.time <= time);
        span.or(self.spans.first())
            .map_or(0.0, |span| span.count + span.counts_in(time - span.time))
    }

    /// Counts per minute at a count.
    pub(super) fn bpm_at(&self, count: f64) -> f64 {
        let span = (self.spans.iter().rev()).find(|span| span.count <= count);
        span.or(self.spans.first()).map_or(0.0, |span| {
            let [first, last] = span.bpm.map(|bpm| 60.0 / bpm);
            let part = ((count - span.count) / span.counts).clamp(0.0, 1.0);
            60.0 / (first + (last - first) * part)
        })
    }
}

impl Span {
    fn time_of_count(&self, count: f64) -> f64 {
        let n = count - self.count;
        if self.bpm[0].to_bits() == self.bpm[1].to_bits() {
            return self.time + n * 60.0 / self.bpm[0];
        }
        self.time_of(n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn changing() -> Tempo {
        let mut tempo = Tempo::even(80.0);
        tempo.change(10.0, 8.0, 120.0);
        tempo.change(18.0, 1.0, 60.0);
        tempo
    }

    #[test]
    fn an_even_tempo_is_a_straight_line() {
        let tempo = Tempo::even(90.0);
        assert!((tempo.time_of(3.0) - 2.0).abs() < 1e-12);
        assert!((tempo.count_at(2.0) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn counts_and_times_undo_each_other() {
        let tempo = changing();
        for i in 0..400 {
            let count = f64::from(i) * 0.1;
            let back = tempo.count_at(tempo.time_of(count));
            assert!((back - count).abs() < 1e-9, "{count} {back}");
        }
    }

    #[test]
    fn beats_change_length_evenly_and_without_a_jump() {
        let tempo = changing();
        // Before, in the middle (0.75 s to 0.5 s) and after the first change.
        for (count, beat) in [(5.0, 0.75), (11.0, 0.625), (15.0, 0.5), (25.0, 1.0)] {
            let length = (tempo.time_of(count + 1e-4) - tempo.time_of(count - 1e-4)) / 2e-4;
            assert!((length - beat).abs() < 1e-6, "{count}: {length}");
            assert!((tempo.bpm_at(count) - 60.0 / beat).abs() < 1e-6);
        }
        // Two counts of change last as long as two of their mean.
        assert!((tempo.time_of(12.0) - tempo.time_of(10.0) - 1.25).abs() < 1e-12);
    }
}
