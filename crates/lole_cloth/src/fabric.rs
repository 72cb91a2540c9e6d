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
    /// Internal friction, apart from the drag of the air. Only the real-time method of grids,
    /// [`step()`](crate::step()), has it; the others are elastic.
    pub hysteresis: Hysteresis,
    /// Coulomb friction coefficient between cloth and body.
    pub friction: f32,
    /// Coulomb friction coefficient of cloth on cloth.
    pub cloth_friction: f32,
    /// Air drag as a rate [1/s]: equation (3) divided by mass.
    pub drag_rate: f32,
}

impl Fabric {
    /// A light cotton such as lawn, to begin with: 104 g/m² and 0.18 mm as measured, stretch of the cotton of
    /// Clyde, Teran and Tamstorf 2017; everything else is an estimate.
    pub const COTTON: Self = Self {
        areal_density: 0.104,
        thickness: 0.18e-3,
        stretch: [4500.0, 2800.0],
        shear: 60.0,
        bend: [6.0e-6, 4.0e-6],
        twist: 4.9e-6,
        hysteresis: Hysteresis {
            bend: [0.63e-3, 0.42e-3],
            shear: 3.0,
        },
        friction: 0.5,
        cloth_friction: 0.5,
        drag_rate: 0.53,
    };
}

/// Friction between the yarns of a fabric: how far apart its curves of bending and of shear lie
/// while it is deformed and while it goes back, as Kawabata's instruments (KES) measure it.
///
/// Half of the distance is a moment or a force of Coulomb's kind: it opposes the change, whatever
/// its speed, and holds a residual curvature of up to `2HB / (2 B)` and a residual angle of shear
/// of up to `2HG / (2 G)` in cloth that nothing else acts on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Hysteresis {
    /// `2HB` along `u` and `v`: moment per width [N·m/m].
    pub bend: [f32; 2],
    /// `2HG`: force per width [N/m].
    pub shear: f32,
}

impl Hysteresis {
    /// Cloth that gives back all that was put into it.
    pub const NONE: Self = Self {
        bend: [0.0; 2],
        shear: 0.0,
    };
}
