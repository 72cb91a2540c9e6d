//! Which alteration is too much, where a garment cannot be drafted with those that are asked for.

use lole_pattern::{Alteration, Alterations, DraftError, Pattern};

use crate::fitting::Fitting;

/// Drafts with the fitting's alterations.
///
/// # Errors
/// What is wrong with the garment as it is without them; else the key of the alteration that is too much, and
/// how much of it can be drafted beside the others.
pub(crate) fn altered(
    fitting: &Fitting<'_>,
    draft: impl Fn(&Fitting<'_>) -> Result<Pattern, DraftError>,
) -> Result<Pattern, DraftError> {
    let with = |alterations: Alterations| {
        draft(&Fitting {
            alterations,
            ..*fitting
        })
    };
    let asked = fitting.alterations;
    let refused = match draft(fitting) {
        Err(refused) if asked != Alterations::NONE => refused,
        drafted => return drafted,
    };
    with(Alterations::NONE)?;
    let alone = Alteration::ALL.into_iter().find(|&one| {
        let is_asked = asked.cm(one) != 0.0;
        is_asked && with(asked.with_cm(one, 0.0)).is_ok()
    });
    if let Some(one) = alone {
        return Err(too_much(one, asked, |all| with(all).is_ok()));
    }
    // No one of them alone is too much beside the others: they are taken back until the rest can be drafted.
    let mut left = asked;
    for one in Alteration::ALL {
        let without = left.with_cm(one, 0.0);
        if with(without).is_ok() {
            return Err(too_much(one, left, |all| with(all).is_ok()));
        }
        left = without;
    }
    Err(refused)
}

/// How much of one alteration goes with the others, in whole millimeters.
fn too_much(
    one: Alteration,
    asked: Alterations,
    is_drafted: impl Fn(Alterations) -> bool,
) -> DraftError {
    let value = asked.cm(one);
    let of_millimeters = |count: f64| count * value.signum() / 10.0;
    let (mut low, mut high) = (0.0, (value.abs() * 10.0).ceil());
    while 1.0 < high - low {
        let middle = (0.5 * (low + high)).floor();
        if is_drafted(asked.with_cm(one, of_millimeters(middle))) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let nearest = of_millimeters(low);
    let [least, most] = one.band_cm();
    DraftError::Option {
        key: one.key(),
        about: one.name(),
        value,
        min: if value < 0.0 { nearest } else { least },
        max: if value < 0.0 { most } else { nearest },
    }
}
