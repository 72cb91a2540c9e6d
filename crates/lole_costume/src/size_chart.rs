//! Sizes that shops sell by, as a list of dancers: each row is a size.

use crate::roster::{self, Roster};

/// JIS L 4005, women of the usual figure (A) and of 158 cm (R), around 9AR (bust 83, hip 91): the bust in steps of
/// 3 cm up to 15, of 4 beyond, the hip in steps of 2. The waist is estimated, because the standard has it by age.
const JIS: &str = "name,stature,bust,hip\n5AR,158,77,87\n7AR,158,80,89\n9AR,158,83,91\n11AR,158,86,93\n\
    13AR,158,89,95\n15AR,158,92,97\n17AR,158,96,99\n";

/// The sizes of JIS L 4005, from the smallest on.
#[must_use]
pub fn jis() -> Roster {
    read(JIS)
}

fn read(text: &str) -> Roster {
    // A test reads it.
    roster::read(text.as_bytes()).unwrap_or_else(|_| Roster {
        dancers: Vec::new(),
        problems: Vec::new(),
        notes: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roster::RosterDancer;

    #[test]
    fn every_size_is_read_and_rises() {
        let chart = jis();
        assert!(
            chart.problems.is_empty() && chart.notes.is_empty(),
            "{chart:?}"
        );
        assert_eq!(chart.dancers.len(), 7);
        let hips: Vec<f64> = chart.dancers.iter().map(RosterDancer::hip_cm).collect();
        assert!(
            hips.windows(2).all(|pair| pair[1] - pair[0] == 2.0),
            "{hips:?}"
        );
    }
}
