//! A banded symmetric matrix over the net of a round sheet, and what it solves.

use glam::{DMat3, DVec3};

use super::equilibrium::{RAYS, RINGS};

/// A symmetric matrix of the nodes that move, three lines each, of which only what is near the diagonal is
/// anything: rays are counted from both sides of the first, so that neighbors are two apart and what bends
/// together four.
pub(super) struct Banded(Vec<[f64; BAND]>);

/// Lines from the diagonal to the last that is anything, and the diagonal.
const BAND: usize = 3 * 5 * RINGS;

impl Banded {
    pub(super) fn new() -> Self {
        Self(vec![[0.0; BAND]; 3 * RINGS * RAYS])
    }

    /// First line of a node; none of those that are held.
    fn line(node: usize) -> Option<usize> {
        let (ring, ray) = (node / RAYS, node % RAYS);
        let place = if 2 * ray <= RAYS {
            (2 * ray).saturating_sub(1)
        } else {
            2 * (RAYS - ray)
        };
        Some(3 * (place * RINGS + ring.checked_sub(1)?))
    }

    /// Adds what the motions of some nodes do to each other, by their places in the list.
    pub(super) fn add_all(&mut self, nodes: &[usize], block: impl Fn([usize; 2]) -> DMat3) {
        for (one, &node) in nodes.iter().enumerate() {
            for (other, &neighbor) in nodes.iter().enumerate() {
                self.add(node, neighbor, block([one, other]));
            }
        }
    }

    /// Adds what a node's motion does to another; only what is below the diagonal is kept.
    fn add(&mut self, one: usize, other: usize, block: DMat3) {
        let (Some(row), Some(column)) = (Self::line(one), Self::line(other)) else {
            return;
        };
        for i in 0..3 {
            for j in 0..3 {
                if let Some(below) = (row + i).checked_sub(column + j) {
                    self.0[row + i][below] += block.col(j)[i];
                }
            }
        }
    }

    /// Cholesky's square root in place, then forwards and backwards.
    pub(super) fn solve(mut self, forces: &[DVec3]) -> Vec<DVec3> {
        let lines = &mut self.0;
        for row in 0..lines.len() {
            let (above, rest) = lines.split_at_mut(row);
            let own = &mut rest[0];
            for below in (0..BAND.min(row + 1)).rev() {
                let column = row - below;
                // Products of what both lines have to the left of the column.
                let shared = (BAND - 1 - below).min(column);
                let other = if below == 0 { &*own } else { &above[column] };
                let sum = product(&own[below + 1..=below + shared], &other[1..=shared]);
                own[below] = if below == 0 {
                    (own[0] - sum).sqrt()
                } else {
                    (own[below] - sum) / above[column][0]
                };
            }
        }
        let mut values = vec![0.0; lines.len()];
        for (node, force) in forces.iter().enumerate() {
            if let Some(line) = Self::line(node) {
                values[line..line + 3].copy_from_slice(&force.to_array());
            }
        }
        for row in 0..values.len() {
            let sum: f64 = (1..BAND.min(row + 1))
                .map(|left| lines[row][left] * values[row - left])
                .sum();
            values[row] = (values[row] - sum) / lines[row][0];
        }
        for row in (0..values.len()).rev() {
            values[row] /= lines[row][0];
            for left in 1..BAND.min(row + 1) {
                values[row - left] -= lines[row][left] * values[row];
            }
        }
        let step = |node| {
            let line = Self::line(node);
            line.map_or(DVec3::ZERO, |line| DVec3::from_slice(&values[line..]))
        };
        (0..forces.len()).map(step).collect()
    }
}

/// The sum of the products of two lists, eight at a time.
fn product(one: &[f64], other: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (ones, one_rest) = one.as_chunks::<8>();
    let (others, other_rest) = other.as_chunks::<8>();
    for (one, other) in ones.iter().zip(others) {
        for (sum, (one, other)) in sums.iter_mut().zip(one.iter().zip(other)) {
            *sum += one * other;
        }
    }
    let rest = one_rest.iter().zip(other_rest);
    sums.iter().sum::<f64>() + rest.map(|(one, other)| one * other).sum::<f64>()
}
