//! One constant for each family of springs, and how a fabric gives them.

use super::check_not_negative;
use crate::{BuildError, Fabric, Grid};

/// Stiffness of each family, the same for every spring of the family.
///
/// All values are finite and not negative; zero leaves the family out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpringConstants {
    /// Between neighbors along a row [N/m].
    pub structural_u: f64,
    /// Between neighbors down a column [N/m].
    pub structural_v: f64,
    /// Along both diagonals of every cell [N/m].
    pub shear: f64,
    /// The paper's bend springs along a row, between every other particle [N/m]. They have no
    /// bending stiffness in a flat cloth and stiffen its stretch instead: zero by default.
    pub skip_u: f64,
    /// The paper's bend springs down a column [N/m]; zero by default.
    pub skip_v: f64,
    /// Plate rigidity `B_u` along a row [N·m].
    pub plate_u: f64,
    /// Plate rigidity `B_v` down a column [N·m].
    pub plate_v: f64,
    /// Twist rigidity `B_t` [N·m].
    pub twist: f64,
}

impl SpringConstants {
    /// The constants with which a grid of rectangular cells has the moduli of `fabric`;
    /// `spacing` is the cell `[h_u, h_v]` [m].
    ///
    /// A cell with structural springs `k_u`, `k_v` and two diagonals of length `d` and stiffness
    /// `k_s` stores, per area, `½ (C_11 ε_u² + 2 C_12 ε_u ε_v + C_22 ε_v² + C_66 γ²)` with
    ///
    /// ```text
    /// C_66 = C_12 = 2 k_s h_u h_v / d²
    /// C_11 = k_u h_u / h_v + C_66 h_u² / h_v²
    /// C_22 = k_v h_v / h_u + C_66 h_v² / h_u²
    /// ```
    ///
    /// (on square cells `k_s`, `k_u + k_s`, `k_v + k_s`). `C_66` is set to `fabric.shear`, and
    /// `C_11`, `C_22` so that a strip pulled along `u` or `v` and free to narrow shows exactly
    /// `fabric.stretch`: `Y_u = C_11 - C_12² / C_22`, `Y_v = C_22 - C_12² / C_11`. On cells so long
    /// that the diagonals alone are stiffer than that, the structural constant is kept at 1 % of
    /// `Y × width / length`. Borders use the same constants although only half a cell lies there.
    #[must_use]
    pub fn from_fabric(fabric: &Fabric, spacing: [f64; 2]) -> Self {
        let [h_u, h_v] = spacing;
        let [stretch_u, stretch_v] = fabric.stretch.map(f64::from);
        let c_66 = f64::from(fabric.shear);
        let [c_11, c_22] = plane_moduli(stretch_u, stretch_v, c_66);
        let structural = |modulus: f64, stretch: f64, length: f64, width: f64| {
            let aspect = length / width;
            ((modulus - c_66 * aspect * aspect) / aspect).max(0.01 * stretch / aspect)
        };
        Self {
            structural_u: structural(c_11, stretch_u, h_u, h_v),
            structural_v: structural(c_22, stretch_v, h_v, h_u),
            shear: c_66 * (h_u * h_u + h_v * h_v) / (2.0 * h_u * h_v),
            skip_u: 0.0,
            skip_v: 0.0,
            plate_u: f64::from(fabric.bend[0]),
            plate_v: f64::from(fabric.bend[1]),
            twist: f64::from(fabric.twist),
        }
    }

    /// The same where columns of `fabric` are `width` [m] wide instead of as in `grid`, because they are crimped.
    pub(super) fn at_width(&self, (grid, fabric): (&Grid, &Fabric), width: f64) -> Self {
        let [h_u, h_v] = grid.spacing.map(f64::from);
        let [flat, crimped] = [h_u, width].map(|h_u| Self::from_fabric(fabric, [h_u, h_v]));
        let ratio = |of: fn(&Self) -> f64| match of(&flat) {
            0.0 => 1.0,
            flat => of(&crimped) / flat,
        };
        Self {
            structural_u: self.structural_u * ratio(|it| it.structural_u),
            structural_v: self.structural_v * ratio(|it| it.structural_v),
            shear: self.shear * ratio(|it| it.shear),
            ..*self
        }
    }

    /// An error unless every constant is finite and not negative.
    pub(super) fn check(&self) -> Result<(), BuildError> {
        let named = [
            ("structural_u", self.structural_u),
            ("structural_v", self.structural_v),
            ("shear", self.shear),
            ("skip_u", self.skip_u),
            ("skip_v", self.skip_v),
            ("plate_u", self.plate_u),
            ("plate_v", self.plate_v),
            ("twist", self.twist),
        ];
        named
            .into_iter()
            .try_for_each(|(name, value)| check_not_negative(name, value))
    }
}

/// `C_11` and `C_22` [N/m] of a sheet whose strips show `stretch_u` and `stretch_v`, with
/// `C_12 = coupling`: from `C_22 / C_11 = Y_v / Y_u` and `C_11² Y_v / Y_u - Y_v C_11 = C_12²`.
fn plane_moduli(stretch_u: f64, stretch_v: f64, coupling: f64) -> [f64; 2] {
    if stretch_u <= 0.0 || stretch_v <= 0.0 {
        return [stretch_u, stretch_v];
    }
    let ratio = stretch_v / stretch_u;
    let c_11 =
        0.5 * (stretch_u + (stretch_u * stretch_u + 4.0 * coupling * coupling / ratio).sqrt());
    [c_11, c_11 * ratio]
}
