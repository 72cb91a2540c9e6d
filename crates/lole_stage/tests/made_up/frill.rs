//! A frill: a short gathered skirt whose length is a share of the hips' height.

use lole_garment::Fitting;
use lole_garment::sketch::{Sketch, Tone};
use lole_garment::template::{
    Fineness, Gathered, GatheredRow, OptionKind, OptionRow, Options, Shelf, Template, Wear,
    WornPlace,
};
use lole_language::words;
use lole_pattern::design::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};
use lole_pattern::{DraftError, GatherRatio, Pattern};

pub(crate) static FRILL: Template = Template {
    id: "frill",
    name: words("フリル", "frill"),
    about: words("短いスカート", "a short skirt"),
    shelf: Shelf::Skirts,
    options: &[OptionRow {
        key: "share_ratio",
        about: words("丈÷腰の高さ", "length over the height of the hips"),
        kind: OptionKind::Number {
            min: 0.3,
            max: 0.6,
            default: Some(0.4),
        },
    }],
    draft,
    worn: Wear::Gathered(GatheredRow {
        count: |_| 1,
        draft: worn,
        fineness: Fineness::OF_SKIRT,
        second: None,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x0020_6040, 0x00f0_f0e0, 0x0030_8050, 0x0010_3020]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.3, 0.2], [0.7, 0.2], [0.8, 0.5], [0.2, 0.5]],
        Tone::Leaf,
    );
}

fn worn(fitting: &Fitting<'_>, options: &Options) -> Result<Gathered, DraftError> {
    let measures = fitting.measures;
    let height = measures.hip_bone_height;
    let worn = PauMeasurements {
        hip_girth: measures.hip_girth,
        worn_girth: measures.girth_at(height).unwrap_or(measures.hip_girth),
        worn_height: height,
    };
    let share = options.get(0).unwrap_or(0.4);
    let cut = PauOptions {
        gather_ratio: GatherRatio::new(2.0)?,
        hem_height: height * (1.0 - share),
        ..PauOptions::default()
    };
    Ok(Gathered {
        draft: draft_pau_skirt(&worn, &cut)?,
        worn,
        place: WornPlace::Hips,
        is_open: false,
        ruffle: None,
    })
}

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let gathered = worn(fitting, options)?;
    Ok(gathered.draft.pattern(FRILL.name))
}
