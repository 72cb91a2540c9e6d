//! A vest: a blouse whose sleeves are left out.

use lole_garment::Fitting;
use lole_garment::dress::{Covered, Way};
use lole_garment::sketch::{Sketch, Tone};
use lole_garment::template::{FEW_SUBSTEPS, Options, SewnRow, Shelf, Template, Wear};
use lole_language::words;
use lole_pattern::{DraftError, Pattern};

pub(crate) static VEST: Template = Template {
    id: "vest",
    name: words("ベスト", "vest"),
    about: words("袖のない上着", "a blouse without sleeves"),
    shelf: Shelf::Tops,
    options: &[],
    draft,
    worn: Wear::Sewn(SewnRow {
        way: Way::Fitted(&[("front", Covered::Front), ("back", Covered::Back)]),
        particle_count: 1200.0,
        substep_counts: FEW_SUBSTEPS,
    }),
    chest_room_deg: 7.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.3, 0.2], [0.7, 0.2], [0.7, 0.8], [0.3, 0.8]],
        Tone::Cloth,
    );
}

fn draft(fitting: &Fitting<'_>, _: &Options) -> Result<Pattern, DraftError> {
    let blouse = Template::of_id("blouse").expect("the shelf has a blouse");
    (blouse.draft)(fitting, &Options::of(blouse))
}
