//! Contact with moving capsules by the penalty force (14), in `f64`, for the reference methods.

use std::num::NonZeroU32;

use glam::DVec3;
use lole_geom::{Capsule, trig64};

use crate::method::paper;

/// What happens where capsules overlap, as the thirteen do at every joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlap {
    /// Only the capsule that holds the particle deepest pushes it. The default: the stiffness, and
    /// with it the largest stable substep, is then the same at a joint as along a limb.
    Deepest,
    /// Every capsule pushes, as the paper's text suggests: where `n` overlap, contact is `n` times
    /// as stiff, and the substeps are made for it.
    Sum {
        /// The largest number of capsules that overlap anywhere.
        count: NonZeroU32,
    },
}

/// How the size of (14) is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Response {
    /// Never negative: skin pushes and does not pull.
    #[default]
    Clamped,
    /// Of either sign, as printed: sticky for a particle that leaves.
    AsPrinted,
}

/// Where a capsule ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CapsuleShape {
    /// At its hemispheres.
    #[default]
    Capped,
    /// Nowhere: the cylinder of (12) with `s` of (11) unbounded, as printed. For study only.
    LiteralInfiniteCylinder,
}

/// The constants of the penalty force (14).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Penalty {
    /// `k` [N/m]. A particle under the force `F` rests `F / k` deep.
    pub stiffness: f64,
    /// `b` [N·s/m]. Zero bounces the particle back at the speed it came with.
    pub damping: f64,
    /// Coulomb friction coefficient; zero as in the paper, which models none.
    pub friction: f64,
    /// Distance kept between cloth and capsules [m], added to every radius.
    pub contact_offset: f64,
    /// What overlapping capsules do.
    pub overlap: Overlap,
    /// Whether skin may pull.
    pub response: Response,
    /// Whether capsules end.
    pub shape: CapsuleShape,
}

impl Penalty {
    /// The paper's contact: stiffness [N/m] and damping [N·s/m], no friction, no offset.
    #[must_use]
    pub const fn new(stiffness: f64, damping: f64) -> Self {
        Self {
            stiffness,
            damping,
            friction: 0.0,
            contact_offset: 0.0,
            overlap: Overlap::Deepest,
            response: Response::Clamped,
            shape: CapsuleShape::Capped,
        }
    }

    /// Contact of `stiffness` [N/m] that returns a particle of `mass` [kg] at `restitution` of its
    /// speed, from above 0 to 1.
    ///
    /// Solves [`restitution`] for the damping ratio by bisection.
    #[must_use]
    pub fn with_bounce(stiffness: f64, mass: f64, bounce: f64, response: Response) -> Self {
        let (mut low, mut high) = (0.0, MAX_DAMPING_RATIO);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if bounce < restitution(middle, response) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let damping = 2.0 * low * (stiffness * mass).sqrt();
        Self {
            response,
            ..Self::new(stiffness, damping)
        }
    }

    /// How many capsules may push one particle at once.
    #[must_use]
    pub const fn overlap_count(&self) -> u32 {
        match self.overlap {
            Overlap::Deepest => 1,
            Overlap::Sum { count } => count.get(),
        }
    }
}

/// Above this damping ratio a particle creeps out of the skin and does not bounce.
const MAX_DAMPING_RATIO: f64 = 50.0;

/// Halvings after which an `f64` has no more digits to give.
const BISECTIONS: u32 = 100;

/// Speed after over speed before a contact (14) of one particle, by the damping ratio
/// `ζ = b / (2 sqrt(k m))`.
///
/// With `s = sqrt(1 - ζ²)`: as printed the contact lasts until the depth is zero again,
/// `exp(-π ζ / s)`, and a particle at `ζ ≥ 1` never leaves. Clamped it ends earlier, when the force
/// has fallen to zero: `exp(-(ζ / s) atan2(2 ζ s, 2 ζ² - 1))`, and beyond `ζ = 1` with
/// `q = sqrt(ζ² - 1)`: `((ζ + q) / (ζ - q))^(-ζ / q)`, after Schwager and Pöschel, "Coefficient of
/// restitution and linear-dashpot model revisited", Granular Matter 9 (2007).
#[must_use]
pub fn restitution(damping_ratio: f64, response: Response) -> f64 {
    let ratio = damping_ratio.max(0.0);
    let squared = 1.0 - ratio * ratio;
    if response == Response::AsPrinted {
        if squared <= 0.0 {
            return 0.0;
        }
        return trig64::exp(-std::f64::consts::PI * ratio / squared.sqrt());
    }
    // At exactly 1 both forms are 0 / 0 with the limit exp(-2).
    if squared.abs() < 1.0e-9 {
        return trig64::exp(-2.0);
    }
    let root = squared.abs().sqrt();
    if squared > 0.0 {
        let angle = trig64::atan2(2.0 * ratio * root, 2.0 * ratio * ratio - 1.0);
        return trig64::exp(-ratio / root * angle);
    }
    // (ζ + q)(ζ - q) = 1.
    trig64::exp(-2.0 * ratio / root * trig64::ln(ratio + root))
}

/// A capsule at one moment of a step, with the velocity of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingCapsule {
    /// Both ends of the axis [m].
    pub ends: [DVec3; 2],
    /// Radius at each end [m].
    pub radii: [f64; 2],
    /// Velocity of each end [m/s].
    pub end_velocities: [DVec3; 2],
    /// Growth of the radius at each end [m/s].
    pub radius_rates: [f64; 2],
}

/// One particle inside one capsule.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Unit vector from the axis to the particle.
    pub normal: DVec3,
    /// Penetration depth [m], positive.
    pub depth: f64,
    /// Velocity [m/s] of the surface under the particle.
    pub surface_velocity: DVec3,
}

impl MovingCapsule {
    /// A capsule that stands still, every radius larger by `offset` [m].
    #[must_use]
    pub fn at_rest(capsule: &Capsule, offset: f64) -> Self {
        Self::between(capsule, capsule, 0.0, 1.0).inflated(offset)
    }

    /// The capsule a `fraction` of the way from `start` to `end`, which are `dt` [s] apart, its
    /// ends moving on straight lines.
    #[must_use]
    pub fn between(start: &Capsule, end: &Capsule, fraction: f64, dt: f64) -> Self {
        let paths = [0, 1].map(|i| (start.ends[i].as_dvec3(), end.ends[i].as_dvec3()));
        let radii = [0, 1].map(|i| (f64::from(start.radii[i]), f64::from(end.radii[i])));
        Self {
            ends: paths.map(|(a, b)| a + (b - a) * fraction),
            radii: radii.map(|(a, b)| a + (b - a) * fraction),
            end_velocities: paths.map(|(a, b)| (b - a) / dt),
            radius_rates: radii.map(|(a, b)| (b - a) / dt),
        }
    }

    /// This capsule with every radius larger by `offset` [m].
    #[must_use]
    pub fn inflated(mut self, offset: f64) -> Self {
        self.radii = self.radii.map(|radius| radius + offset);
        self
    }

    /// Distance [m] from `point` to the surface; negative inside. The `f64` twin of
    /// [`Capsule::signed_distance`], with its rule for tapered capsules.
    #[must_use]
    pub fn signed_distance(&self, point: DVec3) -> f64 {
        let foot = paper::axis_foot(point, self.ends);
        (point - foot.point).length() - self.radius_at(foot.parameter)
    }

    /// Radius [m] at the axis parameter `s`.
    fn radius_at(&self, parameter: f64) -> f64 {
        self.radii[0] + (self.radii[1] - self.radii[0]) * parameter
    }

    /// The contact of a particle at `point`; `None` outside.
    #[inline]
    #[must_use]
    pub fn contact(&self, point: DVec3) -> Option<Contact> {
        self.contact_at(point, paper::axis_foot(point, self.ends))
    }

    /// The contact of a particle at `point` with the endless cylinder of (12) as printed.
    #[must_use]
    pub fn contact_unbounded(&self, point: DVec3) -> Option<Contact> {
        self.contact_at(point, paper::axis_foot_unbounded(point, self.ends))
    }

    #[inline]
    fn contact_at(&self, point: DVec3, foot: paper::AxisFoot) -> Option<Contact> {
        let radius = self.radius_at(foot.parameter.clamp(0.0, 1.0));
        let offset = point - foot.point;
        let distance_squared = offset.length_squared();
        if radius <= 0.0 || radius * radius <= distance_squared {
            return None;
        }
        let normal = offset
            .try_normalize()
            .unwrap_or_else(|| self.fallback_normal());
        Some(Contact {
            normal,
            depth: radius - distance_squared.sqrt(),
            surface_velocity: self.surface_velocity(foot.parameter, normal, radius),
        })
    }

    /// Any direction across the axis, for a particle that lies on it.
    fn fallback_normal(&self) -> DVec3 {
        (self.ends[1] - self.ends[0])
            .try_normalize()
            .map_or(DVec3::Y, DVec3::any_orthonormal_vector)
    }

    /// Velocity [m/s] of the surface point under `normal`: the axis point's, the turning of the
    /// axis (`ω = a × ȧ / |a|²`), and the growth of the radius. Rolling about the axis itself is
    /// not seen in the ends.
    fn surface_velocity(&self, parameter: f64, normal: DVec3, radius: f64) -> DVec3 {
        let axis = self.ends[1] - self.ends[0];
        let axis_rate = self.end_velocities[1] - self.end_velocities[0];
        let length_squared = axis.length_squared();
        let turning = if length_squared > 0.0 {
            axis.cross(axis_rate) / length_squared
        } else {
            DVec3::ZERO
        };
        let growth =
            self.radius_rates[0] + (self.radius_rates[1] - self.radius_rates[0]) * parameter;
        self.end_velocities[0]
            + axis_rate * parameter
            + turning.cross(normal) * radius
            + normal * growth
    }
}

/// The push of the body on one particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Equation (14) times the normal, summed as [`Overlap`] says [N].
    pub force: DVec3,
    /// The deepest contact, which friction acts on.
    pub deepest: Contact,
}

/// Equation (14) for a particle at `position` moving at `velocity`, against the `capsules` that may
/// touch it; `None` outside all of them.
#[must_use]
pub fn contact_force<'a>(
    penalty: &Penalty,
    capsules: impl Iterator<Item = &'a MovingCapsule>,
    position: DVec3,
    velocity: DVec3,
) -> Option<ContactForce> {
    let mut found: Option<ContactForce> = None;
    let touch = |capsule: &MovingCapsule| match penalty.shape {
        CapsuleShape::Capped => capsule.contact(position),
        CapsuleShape::LiteralInfiniteCylinder => capsule.contact_unbounded(position),
    };
    let law = match penalty.response {
        Response::Clamped => paper::penalty_force,
        Response::AsPrinted => paper::penalty_force_as_printed,
    };
    for contact in capsules.filter_map(touch) {
        let depth_rate = (contact.surface_velocity - velocity).dot(contact.normal);
        let size = law(
            contact.depth,
            depth_rate,
            penalty.stiffness,
            penalty.damping,
        );
        let force = contact.normal * size;
        found = Some(match found {
            None => ContactForce {
                force,
                deepest: contact,
            },
            Some(other) => combine(penalty.overlap, other, force, contact),
        });
    }
    found
}

/// One more contact of a particle that already has one.
fn combine(overlap: Overlap, found: ContactForce, force: DVec3, contact: Contact) -> ContactForce {
    let is_deeper = found.deepest.depth < contact.depth;
    let deepest = if is_deeper { contact } else { found.deepest };
    let force = match overlap {
        Overlap::Sum { .. } => found.force + force,
        Overlap::Deepest if is_deeper => force,
        Overlap::Deepest => found.force,
    };
    ContactForce { force, deepest }
}

/// Coulomb friction [N] on a particle of `mass` [kg] pressed against `contact` by `normal_force`
/// [N], which `velocity` [m/s] would carry along the surface during the next `dt` [s].
///
/// The force opposes the sliding, is at most `friction * normal_force`, and never more than what
/// stops the sliding within `dt`: a particle that can stick, sticks.
#[must_use]
pub fn friction_force(
    contact: &Contact,
    max_force: f64,
    velocity: DVec3,
    mass_over_dt: f64,
) -> DVec3 {
    let relative = velocity - contact.surface_velocity;
    let sliding = relative - contact.normal * relative.dot(contact.normal);
    let stopping_force = sliding.length() * mass_over_dt;
    if stopping_force <= max_force {
        return -sliding * mass_over_dt;
    }
    -sliding * (mass_over_dt * max_force / stopping_force)
}
