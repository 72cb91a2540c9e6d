//! How finely a page dances: a worker has one thread.

use lole_costume::document::Design;

/// Vertices around and down of a skirt for which nobody chose: the scene `dance` has them too, so that a browser
/// is held to its bits.
const PAGE_GRID: [u32; 2] = [288, 40];

/// The design as a page dances it. A grid that somebody chose is danced as it is, and files are made of the
/// studio's own design.
pub(crate) fn danced(design: &Design) -> Design {
    let mut quick = design.clone();
    let usual = Design::default().skirt;
    let skirt = &mut quick.skirt;
    if [skirt.column_count, skirt.row_count] == [usual.column_count, usual.row_count] {
        [skirt.column_count, skirt.row_count] = PAGE_GRID;
    }
    quick
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_that_was_chosen_is_kept() {
        let mut design = Design::default();
        assert!(danced(&design) != design);
        assert!(danced(&danced(&design)) == danced(&design));
        design.skirt.column_count -= 1;
        assert!(danced(&design) == design);
    }

    #[test]
    fn a_page_dances_less_than_half_of_the_usual_cloth() {
        let count = |design: &Design| design.skirt.column_count * design.skirt.row_count;
        let usual = Design::default();
        assert!(2 * count(&danced(&usual)) < count(&usual));
    }
}
