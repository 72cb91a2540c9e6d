//! The paper's equations, one function each, in `f64` and as plain as they are printed.
//!
//! "The paper" is Kamasaka, Miyamoto, Sakamoto, "Real-Time Cloth Simulation for Hula Costume CAD
//! Development". Each function names its equation, its symbols and their units; where the print is
//! incomplete or contradicts itself, the function says how it is read and why.
//! Here are (1) to (9) and (11) to (14); there is no (15), the text that refers to it means (14).
//! Equation (10) is one function for all its stages, [`crate::method::explicit::RungeKutta`].

use glam::DVec3;
use lole_geom::trig64;

/// Below this length [m] a spring or a contact has no usable direction; thread is 1e-4 m thick.
const DEGENERATE_LENGTH: f64 = 1.0e-12;

/// Below this squared axis length [m²] a capsule is a sphere, as in [`lole_geom::Capsule`].
const DEGENERATE_AXIS_SQUARED: f64 = 1.0e-12;

/// Equation (1), Hooke's law: the force [N] on particle `i` from particle `j`,
/// `f_stretch = k (|P_ij| - L) P_ij / |P_ij|` with `P_ij = P_j - P_i`.
///
/// `rest_length` is `L` [m], `stiffness` is `k` [N/m]. A stretched spring (`|P_ij| > L`) pulls `i`
/// towards `j`; a compressed one pushes as hard. The print divides by zero where the two particles
/// coincide; there the spring has no direction and the force is zero.
#[inline]
#[must_use]
pub fn spring_force(
    position_i: DVec3,
    position_j: DVec3,
    rest_length: f64,
    stiffness: f64,
) -> DVec3 {
    let offset = position_j - position_i;
    let length = offset.length();
    if length < DEGENERATE_LENGTH {
        return DVec3::ZERO;
    }
    offset * (stiffness * (length - rest_length) / length)
}

/// Equation (2): the weight [N] of a particle, `f_gravity = m_i g`.
///
/// `mass` is `m_i` [kg]; `gravity` is the vector `g` [m/s²], which the paper prints as a scalar.
#[inline]
#[must_use]
pub fn gravity_force(mass: f64, gravity: DVec3) -> DVec3 {
    gravity * mass
}

/// Equation (3): the resistance [N], `f_damper = -ρ v_i`.
///
/// `resistance` is `ρ` [kg/s]. The paper calls this both air resistance and the damping of the
/// springs; as printed it acts on the velocity in the world, so it also slows rigid motion and
/// gives free fall the terminal speed `m g / ρ`.
#[inline]
#[must_use]
pub fn damper_force(resistance: f64, velocity: DVec3) -> DVec3 {
    -velocity * resistance
}

/// Equation (4): the wind [N] on every particle alike,
/// `f_wind = α (cos β sin γ, 0, sin β sin γ)`.
///
/// `amplitude` is `α` [N]; `phases` are `β` and `γ` [rad] from [`wind_phases`]. The print adds the
/// two products into one scalar although the text says that the force acts "in the x-axis and
/// z-axis directions": the sum is read as the sum of the two components of a vector. Hence
/// `|f_wind| = α |sin γ| ≤ α`, and the direction turns with `β`.
#[must_use]
pub fn wind_force(amplitude: f64, phases: [f64; 2]) -> DVec3 {
    let [beta, gamma] = phases;
    let (sin_beta, cos_beta) = trig64::sin_cos(beta);
    let sin_gamma = trig64::sin(gamma);
    DVec3::new(cos_beta * sin_gamma, 0.0, sin_beta * sin_gamma) * amplitude
}

/// Equation (4) to the letter: one scalar [N], `α (cos β sin γ + sin β sin γ)`, applied along x and
/// along z.
///
/// It equals `√2 α sin γ sin(β + π/4)`: the wind always blows along (1, 0, 1) or against it, with
/// each component at most `√2 α`.
#[must_use]
pub fn wind_force_literal(amplitude: f64, phases: [f64; 2]) -> DVec3 {
    let spherical = wind_force(amplitude, phases);
    let scalar = spherical.x + spherical.z;
    DVec3::new(scalar, 0.0, scalar)
}

/// Equation (5): the wind's phases `β = 100 t / 10` and `γ = 100 t / 15` at `time` `t` [s].
///
/// Read in radians, as sine and cosine take them in C++: the wind then repeats every
/// `6π/10 = 1.885 s`. In degrees it would take 108 s and no flutter could be seen.
#[must_use]
pub fn wind_phases(time: f64) -> [f64; 2] {
    [100.0 * time / 10.0, 100.0 * time / 15.0]
}

/// The forces [N] on one particle that equation (6) adds up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Forces {
    /// Weight: equation (2).
    pub gravity: DVec3,
    /// Resistance of the air: equation (3).
    pub damper: DVec3,
    /// Springs: equation (1), summed over the springs of the particle.
    pub stretch: DVec3,
    /// Wind: equation (4).
    pub wind: DVec3,
    /// Contact: equation (14) times the contact normal, pointing out of the body.
    pub penalty: DVec3,
}

/// Equation (6): the total force [N], `F_i = f_gravity + f_damper + f_stretch + f_wind`, and
/// `f_penalty`, which the print leaves out although section VI computes it for this sum.
#[inline]
#[must_use]
pub fn total_force(forces: &Forces) -> DVec3 {
    forces.gravity + forces.damper + forces.stretch + forces.wind + forces.penalty
}

/// Equation (7): the acceleration [m/s²], `a_i = F_i / m_i`. `mass` is `m_i` [kg].
#[inline]
#[must_use]
pub fn acceleration(mass: f64, force: DVec3) -> DVec3 {
    force / mass
}

/// Equation (8), Euler's method: `x(t + Δt) = x(t) + v(t) Δt` and `v(t + Δt) = v(t) + a(t) Δt`,
/// both from the old velocity. Returns position [m] and velocity [m/s] after `dt` [s].
///
/// The energy of an undamped oscillator of angular frequency `ω` grows by the factor `1 + ω² Δt²`
/// in every step, however small: the method is stable only with damping, while `Δt < c / ω²`.
#[inline]
#[must_use]
pub fn euler(position: DVec3, velocity: DVec3, acceleration: DVec3, dt: f64) -> (DVec3, DVec3) {
    (position + velocity * dt, velocity + acceleration * dt)
}

/// Equation (9), "FB Euler": `v(t + Δt) = v(t) + a(t) Δt`, then `x(t + Δt) = x(t) + v(t + Δt) Δt`.
/// Returns position [m] and velocity [m/s] after `dt` [s].
///
/// The paper calls the second half "backward Euler"; nothing is implicit in it. It is the
/// symplectic Euler method: stable for an undamped oscillator of angular frequency `ω` while
/// `ω Δt < 2`, first order, and without drift of energy.
#[inline]
#[must_use]
pub fn fb_euler(position: DVec3, velocity: DVec3, acceleration: DVec3, dt: f64) -> (DVec3, DVec3) {
    let velocity = velocity + acceleration * dt;
    (position + velocity * dt, velocity)
}

/// The foot of a particle on a capsule's axis, from [`axis_foot`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisFoot {
    /// `s`: 0 at `a`, 1 at `b`.
    pub parameter: f64,
    /// `y = a + s (b - a)` [m].
    pub point: DVec3,
}

/// Equation (11): the point `y = a + s (b - a)` with `(y - x)·(b - a) = 0`, where `s` is confined
/// to `0..=1`.
///
/// `point` is the particle `x` [m], `ends` are `a` and `b` [m]. The print does not bound `s`, which
/// would make the cylinder of (12) infinite. Confined, the distance from `x` to `y` decides (12)
/// and (13) at once: it is `r'` beside the cylinder and `r''` beyond an end. A capsule without
/// length is a sphere about `a`.
#[inline]
#[must_use]
pub fn axis_foot(point: DVec3, ends: [DVec3; 2]) -> AxisFoot {
    let parameter = line_parameter(point, ends).clamp(0.0, 1.0);
    AxisFoot {
        parameter,
        point: ends[0] + (ends[1] - ends[0]) * parameter,
    }
}

/// `s` of equation (11) on the infinite line through both ends.
#[inline]
fn line_parameter(point: DVec3, ends: [DVec3; 2]) -> f64 {
    let axis = ends[1] - ends[0];
    let length_squared = axis.length_squared();
    if length_squared < DEGENERATE_AXIS_SQUARED {
        return 0.0;
    }
    (point - ends[0]).dot(axis) / length_squared
}

/// Equation (11) to the letter: the foot on the endless line through both ends, so that the
/// cylinder of (12) has no ends. Particles above a head or below a foot are hit by it, too.
#[inline]
#[must_use]
pub fn axis_foot_unbounded(point: DVec3, ends: [DVec3; 2]) -> AxisFoot {
    let parameter = line_parameter(point, ends);
    AxisFoot {
        parameter,
        point: ends[0] + (ends[1] - ends[0]) * parameter,
    }
}

/// Equation (12): whether the particle at `point` lies in the cylinder part, `r' - r < 0`, where
/// `r'` is its distance from `y` of (11) and `y` lies between the ends.
#[must_use]
pub fn is_in_cylinder(point: DVec3, ends: [DVec3; 2], radius: f64) -> bool {
    let parameter = line_parameter(point, ends);
    let foot = ends[0] + (ends[1] - ends[0]) * parameter;
    (0.0..=1.0).contains(&parameter) && (point - foot).length() - radius < 0.0
}

/// Equation (13): whether the particle at `point` lies in a hemisphere, `r'' - r < 0`, where `r''`
/// is its distance from `a` or `b`.
#[must_use]
pub fn is_in_hemisphere(point: DVec3, ends: [DVec3; 2], radius: f64) -> bool {
    ends.iter()
        .any(|&end| (point - end).length() - radius < 0.0)
}

/// Equation (14): the size [N] of the penalty force along the outward normal,
/// `f_penalty = k d + b ḋ`, never negative and zero outside the body.
///
/// `depth` is `d` [m], positive inside; `depth_rate` is `ḋ` [m/s], positive while the particle
/// sinks deeper *relative to the moving surface*; `stiffness` is `k` [N/m], `damping` is `b`
/// [N·s/m]. The print gives neither direction nor sign. Without the bound at zero a leaving
/// particle would stick to the skin.
#[inline]
#[must_use]
pub fn penalty_force(depth: f64, depth_rate: f64, stiffness: f64, damping: f64) -> f64 {
    if depth <= 0.0 {
        return 0.0;
    }
    (stiffness * depth + damping * depth_rate).max(0.0)
}

/// Equation (14) to the letter: `k d + b ḋ` wherever the particle is inside, whatever its sign.
///
/// A leaving particle is pulled back while `b |ḋ| > k d`: the skin is sticky. A particle that only
/// just touches (`d = 0`) already feels all of `b ḋ`. Symbols and units as in [`penalty_force`].
#[inline]
#[must_use]
pub fn penalty_force_as_printed(depth: f64, depth_rate: f64, stiffness: f64, damping: f64) -> f64 {
    if depth <= 0.0 {
        return 0.0;
    }
    stiffness * depth + damping * depth_rate
}
