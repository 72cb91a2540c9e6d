//! How long the kinds of work of a garment take: one small table, all of it estimates.
//!
//! Rows of stitches are what makers of pāʻū skirts report; the rest is what dressmaking classes allow
//! a practised home sewer, with pins, iron and neatened edges in it.

/// A kind of work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Work {
    /// A row of stitches along a marked line, by the meter.
    Row,
    /// A seam: pinned, sewn, both edges neatened, pressed; by the meter.
    Seam,
    /// A hem, turned twice, by the meter.
    Hem,
    /// Two rows of long stitches, drawn up, spread and sewn on, by the meter of the gathered edge.
    Gathers,
    /// An edge bound on the bias, by the meter.
    Binding,
    /// Setting in a concealed zip.
    Zip,
    /// Setting in a sleeve.
    Sleeve,
    /// A dart.
    Dart,
    /// A bound slit with loop and button.
    Slit,
    /// Marking and cutting one piece of cloth by its pattern.
    Piece,
}

impl Work {
    /// Minutes with a machine and by hand, for a meter or for one.
    const fn minutes(self) -> [f64; 2] {
        match self {
            Self::Row => [3.5, 24.0],
            Self::Seam => [14.0, 40.0],
            Self::Hem => [12.0, 30.0],
            Self::Gathers => [15.0, 35.0],
            Self::Binding => [25.0, 45.0],
            Self::Zip => [40.0, 90.0],
            Self::Sleeve => [20.0, 60.0],
            Self::Dart => [8.0, 15.0],
            Self::Slit => [25.0, 45.0],
            Self::Piece => [6.0, 6.0],
        }
    }
}

/// Minutes that any step takes: reading and laying out.
const OF_STEP: f64 = 3.0;

/// Time of a step of these kinds of work, each with its meters or how often it is done: with a machine
/// and by hand [min].
pub(crate) fn minutes(parts: &[(Work, f64)]) -> [f64; 2] {
    [0, 1].map(|which| {
        let sum: f64 = (parts.iter())
            .map(|(work, amount)| work.minutes()[which] * amount)
            .sum();
        OF_STEP + sum
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_adds_up_and_hands_are_slower_than_machines() {
        let [machine, hand] = minutes(&[(Work::Zip, 1.0), (Work::Hem, 2.0)]);
        assert!((machine - (3.0 + 40.0 + 24.0)).abs() < 1e-9 && machine < hand);
    }
}
