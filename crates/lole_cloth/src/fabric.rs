//! Fabric in SI units, as it is measured.

/// Mechanical data of one fabric, by direction of the grid (`u` along rows, `v` down columns).
///
/// In a pāʻū skirt the warp runs around the body: `u` is warp, `v` is weft.
/// Moduli are stored as they are measured; the engine turns them into spring constants or
/// compliances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fabric {
    /// Mass per area [kg/m²].
    pub areal_density: f32,
    /// Thickness [m].
    pub thickness: f32,
    /// Membrane stiffness along `u` and `v` [N/m].
    pub stretch: [f32; 2],
    /// Membrane shear stiffness [N/m per rad].
    pub shear: f32,
    /// Bending rigidity along `u` and `v` [N·m] (per unit width).
    pub bend: [f32; 2],
    /// Twist rigidity `B_t` [N·m] in `½ (B_u κ_uu² + B_v κ_vv² + 2 B_t κ_uv²)`.
    pub twist: f32,
    /// Coulomb friction coefficient between cloth and body.
    pub friction: f32,
    /// Air drag as a rate [1/s]: equation (3) divided by mass.
    pub drag_rate: f32,
}
