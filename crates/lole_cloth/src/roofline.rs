//! What a machine can do at best for structural springs.
//!
//! A stream of springs that wait for nothing: the arithmetic of the engine's springs, each on the
//! ends of another vector, through an array as large as the cloth's positions, so that it lies in
//! the same cache. What a cloth's springs lose against it they lose to their order: a spring along
//! a row waits for its neighbor.

use fearless_simd::{Simd, dispatch};

use crate::InstructionSet;
use crate::constraint::pull::Pull;
use crate::lanes::{LANES, Points, Vectors};

/// Additions, multiplications and comparisons of one spring: 3 for the offset, 5 for its square, 1
/// for the limit, 6 for the cubic, 3 for the change and 6 for both ends.
pub const FLOPS_PER_SPRING: u32 = 24;

/// Bytes that one spring reads and writes: both ends, three `f32` each, there and back.
pub const BYTES_PER_SPRING: u32 = 48;

/// Vectors between the two ends of a spring: no spring waits for the one before, and what one
/// writes is still in the nearest cache when another reads it, as between the rows of a cloth.
const DISTANCE: usize = 8;

/// Springs in a row, ready to be solved.
#[derive(Debug, Clone)]
pub struct SpringStream {
    points: Vec<Points>,
    pull: Pull,
}

impl SpringStream {
    /// Springs between as many particles as a cloth has, in its layout; a few vectors of particles at least.
    #[must_use]
    pub fn new(particle_count: usize) -> Self {
        let vector_count = particle_count.div_ceil(LANES).max(DISTANCE + 1);
        #[expect(
            clippy::cast_precision_loss,
            reason = "places need not be told apart exactly"
        )]
        let points = (0..vector_count).map(|vector| Points {
            // A little more than the rest length apart: no number ever becomes denormal.
            x: [0.011 * (vector / DISTANCE) as f32; LANES],
            y: [0.001 * (vector % DISTANCE) as f32; LANES],
            z: [0.0; LANES],
        });
        Self {
            points: points.collect(),
            // What is shared moves little, so that springs stay as they are however many passes.
            pull: Pull::new(0.01 * 0.01).shared(1.0e-3),
        }
    }

    /// How many springs a pass solves.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        (self.points.len() - DISTANCE) * LANES
    }

    /// Solves every spring once.
    pub fn pass(&mut self, instruction_set: InstructionSet) {
        let level = instruction_set.level();
        dispatch!(level, simd => solve(simd, &mut self.points, self.pull));
    }

    /// Whether every number is still one; reading them keeps a compiler from leaving the work out.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let is_finite = |points: &Points| (0..LANES).all(|lane| points.get(lane).is_finite());
        self.points.iter().all(is_finite)
    }
}

#[inline(always)]
fn solve<S: Simd>(simd: S, points: &mut [Points], pull: Pull) {
    for index in 0..points.len() - DISTANCE {
        let (before, after) = points.split_at_mut(index + DISTANCE);
        let (upper, lower) = (&mut before[index], &mut after[0]);
        let first = Vectors::load(simd, upper);
        let second = Vectors::load(simd, lower);
        let offset = second.sub(first);
        let change = offset.scale(pull.factor(simd, offset.dot(offset)));
        first.add(change).store(upper);
        second.sub(change).store(lower);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_pulls_its_springs_towards_their_length_with_the_same_bits_everywhere() {
        let streams = [
            InstructionSet::Detected,
            InstructionSet::Wide,
            InstructionSet::Baseline,
        ]
        .map(|set| {
            let mut stream = SpringStream::new(4096);
            assert_eq!(stream.spring_count(), 4096 - LANES * DISTANCE);
            (0..20_000).for_each(|_| stream.pass(set));
            assert!(stream.is_finite());
            stream
        });
        let ends = |stream: &SpringStream| {
            let [first, second] = [0, DISTANCE].map(|index| stream.points[index].get(0));
            first.distance(second)
        };
        let (length, start) = (ends(&streams[0]), ends(&SpringStream::new(4096)));
        assert!(
            (0.0099..start).contains(&length),
            "{length} m, from {start}"
        );
        assert!(
            streams
                .iter()
                .all(|other| other.points == streams[0].points)
        );
    }
}
