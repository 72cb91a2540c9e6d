//! Sizes that shops sell by, as a list of dancers: each row is a size.

use crate::roster::{self, Roster};

/// JIS L 4005, women of the usual figure (A) and of 158 cm (R), around 9AR (bust 83, hip 91): the bust in steps of
/// 3 cm up to 15, of 4 beyond, the hip in steps of 2. The waist is estimated, because the standard has it by age.
const JIS: &str = "name,stature,bust,hip\n5AR,158,77,87\n7AR,158,80,89\n9AR,158,83,91\n11AR,158,86,93\n\
    13AR,158,89,95\n15AR,158,92,97\n17AR,158,96,99\n";

/// EN 13402-3, women by their bust, of the middle of its steps of stature: the bust in steps of 4 cm up to 104, of 6
/// beyond, with waist and hip as the standard pairs them.
const EN: &str = "name,stature,bust,waist,hip\n76,168,76,60,84\n80,168,80,64,88\n84,168,84,68,92\n\
    88,168,88,72,96\n92,168,92,76,100\n96,168,96,80,104\n100,168,100,84,108\n104,168,104,88,112\n";

/// Charts by name: in commands, and what it is.
const CHARTS: [(&str, &str); 2] = [("jis", JIS), ("en", EN)];

/// The sizes of a chart, from the smallest on; `None` where none has that name.
#[must_use]
pub fn chart(name: &str) -> Option<Roster> {
    let (_, text) = CHARTS.iter().find(|(known, _)| *known == name)?;
    // Each is read by a test.
    roster::read(text.as_bytes()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roster::RosterDancer;

    #[test]
    fn every_size_is_read_and_rises() {
        let expected = [("jis", 7, 2.0), ("en", 8, 4.0)];
        assert_eq!(expected.map(|it| it.0), CHARTS.map(|it| it.0));
        for (name, count, step) in expected {
            let chart = chart(name).expect("a chart");
            assert!(
                chart.problems.is_empty() && chart.notes.is_empty(),
                "{chart:?}"
            );
            assert_eq!(chart.dancers.len(), count, "{name}");
            let hips: Vec<f64> = chart.dancers.iter().map(RosterDancer::hip_cm).collect();
            assert!(
                hips.windows(2).all(|pair| pair[1] - pair[0] == step),
                "{hips:?}"
            );
        }
        assert_eq!(chart("us"), None);
    }
}
