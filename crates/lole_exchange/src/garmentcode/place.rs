//! Where a panel lies around the body of its file.

use glam::{DAffine3, DMat3, DVec3};
use lole_geom::trig64;

use super::FARTHEST;
use crate::ExchangeError;
use crate::fields::Fields;

/// Rotation about x, then y, then z [°], then the translation.
pub(super) fn read(panel: &Fields<'_>, unit: f64) -> Result<DAffine3, ExchangeError> {
    let translation = DVec3::from(panel.numbers::<3>("translation")?) * unit;
    if FARTHEST < translation.abs().max_element() {
        return Err(ExchangeError::wrong(
            panel.at("translation"),
            &panel.map["translation"].to_string(),
            (
                "体のそばの場所（units_in_meter を確かめてください）",
                "a place beside a body; check units_in_meter",
            ),
        ));
    }
    let degrees = panel.numbers::<3>("rotation")?;
    let [x, y, z] = degrees.map(|angle| trig64::sin_cos((angle % 360.0).to_radians()));
    let about_x = DMat3::from_cols(
        DVec3::X,
        DVec3::new(0.0, x.1, x.0),
        DVec3::new(0.0, -x.0, x.1),
    );
    let about_y = DMat3::from_cols(
        DVec3::new(y.1, 0.0, -y.0),
        DVec3::Y,
        DVec3::new(y.0, 0.0, y.1),
    );
    let about_z = DMat3::from_cols(
        DVec3::new(z.1, z.0, 0.0),
        DVec3::new(-z.0, z.1, 0.0),
        DVec3::Z,
    );
    Ok(DAffine3::from_mat3_translation(
        about_z * about_y * about_x,
        translation,
    ))
}
