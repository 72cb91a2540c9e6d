//! Many rectangles on one cloth: strips that are cut or torn off it from selvage to selvage, each with what
//! lies side by side in it.

use lole_geom::Length;

use super::item::FITS;

/// A length of cloth, cut off from selvage to selvage.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Along the selvage: that of the longest in it.
    pub length: Length,
    /// What lies in it, from the lower selvage up.
    pub laid: Vec<InStrip>,
}

/// A rectangle in a strip; it begins at the strip's cut end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InStrip {
    /// Index into the sizes that were asked for.
    pub index: usize,
    /// Its lower edge over the lower selvage.
    pub across: Length,
}

/// Lays rectangles, each with its size along the selvage and across, on cloth of a width: longest first, each
/// into the first strip that has room beside the others, or into the one that it leaves the least room in,
/// whichever needs less cloth ("first fit" and "best fit decreasing height"; the first needs at most 1.7 times
/// the least cloth and one longest strip more, Coffman and others 1980). The same sizes in the same order give
/// the same strips; their number is as large as it likes to be.
///
/// What is wider than the cloth gets a strip of its own.
#[must_use]
pub fn strips(sizes: &[[Length; 2]], width: Length) -> Vec<Strip> {
    let mut order: Vec<usize> = (0..sizes.len()).collect();
    let long = |index: usize| sizes[index][0].to_m();
    order.sort_by(|one, other| long(*other).total_cmp(&long(*one)));
    let plans = [first_room, least_room].map(|choose| laid(sizes, &order, (width, choose)));
    let [first, least] = plans;
    if length_of(&least) < length_of(&first) - Length::from_m(FITS) {
        least
    } else {
        first
    }
}

/// Length of strips behind each other.
#[must_use]
pub fn length_of(strips: &[Strip]) -> Length {
    let lengths = strips.iter().map(|strip| strip.length);
    lengths.fold(Length::ZERO, |sum, length| sum + length)
}

/// Chooses one of the strips' free widths [m] for something that wide.
type Choose = fn(&[f64], f64) -> Option<usize>;

fn first_room(free: &[f64], wide: f64) -> Option<usize> {
    free.iter().position(|room| wide <= room + FITS)
}

fn least_room(free: &[f64], wide: f64) -> Option<usize> {
    let rooms = free.iter().enumerate();
    let rooms = rooms.filter(|(_, room)| wide <= **room + FITS);
    let least = rooms.min_by(|(_, one), (_, other)| one.total_cmp(other));
    least.map(|(index, _)| index)
}

fn laid(sizes: &[[Length; 2]], order: &[usize], (width, choose): (Length, Choose)) -> Vec<Strip> {
    let mut strips: Vec<Strip> = Vec::new();
    let mut free: Vec<f64> = Vec::new();
    for &index in order {
        let [along, across] = sizes[index];
        let strip = choose(&free, across.to_m()).unwrap_or_else(|| {
            strips.push(Strip {
                length: along,
                laid: Vec::new(),
            });
            free.push(width.to_m());
            strips.len() - 1
        });
        strips[strip].laid.push(InStrip {
            index,
            across: width - Length::from_m(free[strip]),
        });
        free[strip] = (free[strip] - across.to_m()).max(0.0);
    }
    strips
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cm(along: f64, across: f64) -> [Length; 2] {
        [along, across].map(Length::from_cm)
    }

    /// By hand: three strips of 35 cm lie side by side on 110 cm, so thirty need ten lengths.
    #[test]
    fn thirty_of_a_third_of_the_width_need_ten_lengths() {
        let plan = strips(&[cm(320.0, 35.0); 30], Length::from_cm(110.0));
        assert_eq!(plan.len(), 10);
        assert!((length_of(&plan).to_cm() - 3200.0).abs() < 1e-6);
        assert!(plan.iter().all(|strip| strip.laid.len() == 3));
    }

    #[test]
    fn nothing_lies_over_another_or_beyond_the_selvage_and_nothing_is_lost() {
        let sizes: Vec<[Length; 2]> = (0..1000_u32)
            .map(|index| {
                let part = |factor: u32, most: u32| f64::from(index * factor % most);
                cm(20.0 + part(37, 211), 5.0 + part(53, 101))
            })
            .collect();
        let width = Length::from_cm(110.0);
        let plan = strips(&sizes, width);
        assert_eq!(plan, strips(&sizes, width));
        let mut seen = vec![false; sizes.len()];
        for strip in &plan {
            let mut top = 0.0;
            for one in &strip.laid {
                let [along, across] = sizes[one.index];
                assert!(along <= strip.length && !seen[one.index]);
                assert!(top - 1e-9 < one.across.to_m());
                top = (one.across + across).to_m();
                seen[one.index] = true;
            }
            assert!(top <= width.to_m() + 1e-6);
        }
        assert!(seen.into_iter().all(|is_laid| is_laid));
    }
}
