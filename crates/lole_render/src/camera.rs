//! Where a picture is taken from, and views that frame a box.

use crate::{RenderError, Size};
use glam::{Mat4, Vec2, Vec3};
use lole_geom::trig;

/// Nothing nearer than this is drawn [m].
pub(crate) const NEAR: f32 = 0.02;
/// Share of the picture's height or width left free on each side of a framed box.
const MARGIN: f32 = 0.05;
/// Opening of the framing views [rad]: a short portrait lens (24°), which does not distort a
/// standing figure.
const FRAMING_FOV: f32 = 0.42;
/// The framing views look down by this much [rad], enough to show the floor and its shadow.
const FRAMING_PITCH: f32 = 0.10;
/// Rounds of balancing in [`Camera::framing`]; each shrinks what is left about tenfold.
const FRAMING_ROUNDS: usize = 6;

/// An axis-aligned box, in meters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Least corner [m].
    pub min: Vec3,
    /// Greatest corner [m].
    pub max: Vec3,
}

impl Bounds {
    /// The box around `positions`; `None` where there are none.
    #[must_use]
    pub fn of(positions: &[Vec3]) -> Option<Self> {
        let (&first, rest) = positions.split_first()?;
        let start = Self {
            min: first,
            max: first,
        };
        Some(rest.iter().fold(start, |bounds, &point| Self {
            min: bounds.min.min(point),
            max: bounds.max.max(point),
        }))
    }

    /// The box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Middle of the box [m].
    #[must_use]
    pub fn center(self) -> Vec3 {
        (self.min + self.max) * 0.5
    }

    /// The eight corners [m].
    #[must_use]
    pub fn corners(self) -> [Vec3; 8] {
        let pick = |bit: bool, low: f32, high: f32| if bit { high } else { low };
        std::array::from_fn(|index| {
            Vec3::new(
                pick(index & 1 != 0, self.min.x, self.max.x),
                pick(index & 2 != 0, self.min.y, self.max.y),
                pick(index & 4 != 0, self.min.z, self.max.z),
            )
        })
    }
}

/// Named viewpoints around a dancer who faces `+Z`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum View {
    /// From `+Z`, face to face.
    Front,
    /// From `+X`, the dancer's left.
    Side,
    /// From `-Z`.
    Back,
    /// Between front and the dancer's left.
    ThreeQuarter,
    /// Turned by this angle [rad] about the vertical, from the front towards the dancer's left.
    Turned(f32),
}

impl View {
    /// Angle about the vertical [rad], 0 at the front, growing towards the dancer's left.
    #[must_use]
    pub const fn azimuth(self) -> f32 {
        use std::f32::consts::{FRAC_PI_2, PI};
        match self {
            Self::Front => 0.0,
            Self::Side => FRAC_PI_2,
            Self::Back => PI,
            Self::ThreeQuarter => 0.62,
            Self::Turned(azimuth) => azimuth,
        }
    }
}

/// A pinhole camera, upright.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Where it stands [m].
    pub eye: Vec3,
    /// The point in the middle of the picture [m].
    pub target: Vec3,
    /// Opening from the bottom to the top of the picture [rad].
    pub vertical_fov: f32,
}

impl Camera {
    /// A camera that shows all of `bounds` in a picture of `aspect` (width over height), as large
    /// as fits, from `view` and slightly above.
    #[must_use]
    pub fn framing(bounds: Bounds, view: View, aspect: f32) -> Self {
        Self::framing_points(&bounds.corners(), view, aspect)
    }

    /// A camera that shows all `points` in a picture of `aspect` (width over height), as large as fits,
    /// from `view` and slightly above: tighter around a figure than around its box. Where there are
    /// none it looks at the origin.
    #[must_use]
    pub fn framing_points(points: &[Vec3], view: View, aspect: f32) -> Self {
        let (sin_azimuth, cos_azimuth) = trig::sin_cos(view.azimuth());
        let (sin_pitch, cos_pitch) = trig::sin_cos(FRAMING_PITCH);
        let backward = Vec3::new(sin_azimuth * cos_pitch, sin_pitch, cos_azimuth * cos_pitch);
        let right = Vec3::new(cos_azimuth, 0.0, -sin_azimuth);
        let up = backward.cross(right);
        let tan_up = trig::tan(FRAMING_FOV * 0.5) * (1.0 - 2.0 * MARGIN);
        let tan_right = tan_up * aspect.max(1.0e-3);
        let center = Bounds::of(points).map_or(Vec3::ZERO, Bounds::center);

        // The camera goes back until each of the four sides of the view clears each point; the
        // sides are balanced by moving the target across the view.
        let mut offset = Vec2::ZERO;
        let mut distance = 0.1_f32;
        for _ in 0..FRAMING_ROUNDS {
            distance = 0.1;
            let mut low = Vec2::INFINITY;
            let mut high = Vec2::NEG_INFINITY;
            for &point in points {
                let from_center = point - center;
                let across = Vec2::new(from_center.dot(right), from_center.dot(up)) - offset;
                let needed = across.abs() / Vec2::new(tan_right, tan_up);
                distance = distance.max(from_center.dot(backward) + needed.max_element());
            }
            for &point in points {
                let from_center = point - center;
                let depth = (distance - from_center.dot(backward)).max(NEAR);
                let across = Vec2::new(from_center.dot(right), from_center.dot(up)) - offset;
                low = low.min(across / depth);
                high = high.max(across / depth);
            }
            if points.is_empty() {
                break;
            }
            offset += (low + high) * 0.5 * distance;
        }
        let target = center + right * offset.x + up * offset.y;
        Self {
            eye: target + backward * distance,
            target,
            vertical_fov: FRAMING_FOV,
        }
    }

    /// How far it stands from its target [m]. Two framing views at the same distance show the same
    /// figure at the same scale.
    #[must_use]
    pub fn distance(&self) -> f32 {
        self.eye.distance(self.target)
    }

    /// The camera moved along its view to a distance [m] from its target.
    #[must_use]
    pub fn at_distance(self, distance: f32) -> Self {
        let [_, _, backward] = self.axes();
        Self {
            eye: self.target + backward * distance,
            ..self
        }
    }

    /// The framing view after a `fraction` of a full turn around `bounds`, starting at the front.
    #[must_use]
    pub fn turntable(bounds: Bounds, fraction: f32, aspect: f32) -> Self {
        let azimuth = (fraction - fraction.floor()) * std::f32::consts::TAU;
        let radius = bounds.corners().iter().fold(0.0_f32, |radius, corner| {
            let arm = *corner - bounds.center();
            radius.max(Vec2::new(arm.x, arm.z).length())
        });
        // A round box, so that the camera keeps its distance while it turns.
        let center = bounds.center();
        let round = Bounds {
            min: Vec3::new(center.x - radius, bounds.min.y, center.z - radius),
            max: Vec3::new(center.x + radius, bounds.max.y, center.z + radius),
        };
        let front = Self::framing(round, View::Front, aspect);
        let arm = front.eye - Vec3::new(center.x, front.eye.y, center.z);
        let (sin_azimuth, cos_azimuth) = trig::sin_cos(azimuth);
        let turn = |v: Vec3| {
            Vec3::new(
                v.x * cos_azimuth + v.z * sin_azimuth,
                v.y,
                v.z * cos_azimuth - v.x * sin_azimuth,
            )
        };
        let target_arm = front.target - Vec3::new(center.x, 0.0, center.z);
        Self {
            eye: Vec3::new(center.x, front.eye.y, center.z) + turn(arm),
            target: Vec3::new(center.x, 0.0, center.z) + turn(target_arm),
            ..front
        }
    }

    /// Where a point of the world is seen in a picture of `size` [pixel], from its top left corner; `None` behind
    /// the camera.
    #[must_use]
    pub fn pixel(&self, point: Vec3, size: Size) -> Option<Vec2> {
        let clip = self.clip_from_world(size.aspect()) * point.extend(1.0);
        let half = Vec2::new(size.width as f32, size.height as f32) * 0.5;
        let seen = Vec2::new(clip.x, -clip.y) / clip.w;
        (NEAR < clip.w).then(|| half + seen * half)
    }

    /// Unit vectors of the picture: right, up and backward (towards the viewer).
    pub(crate) fn axes(&self) -> [Vec3; 3] {
        let backward = (self.eye - self.target).try_normalize().unwrap_or(Vec3::Z);
        // Straight up or down there is no upright; the front of the stage is then at the bottom.
        let right = Vec3::Y.cross(backward).try_normalize().unwrap_or(Vec3::X);
        [right, backward.cross(right), backward]
    }

    /// Maps world points to clip space of a picture of `aspect`: depth 1 at [`NEAR`], 0 at
    /// infinity, which spends the precision of floats evenly.
    pub(crate) fn clip_from_world(&self, aspect: f32) -> Mat4 {
        let [right, up, backward] = self.axes();
        let focal = 1.0 / trig::tan(self.vertical_fov * 0.5);
        let view_from_world = Mat4::from_cols(
            glam::Vec4::new(right.x, up.x, backward.x, 0.0),
            glam::Vec4::new(right.y, up.y, backward.y, 0.0),
            glam::Vec4::new(right.z, up.z, backward.z, 0.0),
            glam::Vec4::new(
                -right.dot(self.eye),
                -up.dot(self.eye),
                -backward.dot(self.eye),
                1.0,
            ),
        );
        let clip_from_view = Mat4::from_cols(
            glam::Vec4::new(focal / aspect, 0.0, 0.0, 0.0),
            glam::Vec4::new(0.0, focal, 0.0, 0.0),
            glam::Vec4::new(0.0, 0.0, 0.0, -1.0),
            glam::Vec4::new(0.0, 0.0, NEAR, 0.0),
        );
        clip_from_view * view_from_world
    }

    /// Refuses a camera that cannot look anywhere.
    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let reason = if !(self.eye.is_finite() && self.target.is_finite()) {
            "its eye or target is not a finite number"
        } else if (self.eye - self.target).length_squared() < 1.0e-12 {
            "its eye and target are the same point"
        } else if !(0.001..3.1).contains(&self.vertical_fov) {
            "its opening must be between 0.001 and 3.1 radians"
        } else {
            return Ok(());
        };
        Err(RenderError::Camera { reason })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standing() -> Bounds {
        Bounds {
            min: Vec3::new(-0.5, 0.0, -0.35),
            max: Vec3::new(0.7, 1.7, 0.45),
        }
    }

    /// Picture coordinates, -1 to 1 where visible.
    fn seen(camera: &Camera, aspect: f32, point: Vec3) -> Vec2 {
        let clip = camera.clip_from_world(aspect) * point.extend(1.0);
        Vec2::new(clip.x, clip.y) / clip.w
    }

    #[test]
    fn framing_shows_the_whole_box_centered_and_large() {
        for aspect in [16.0 / 9.0, 1.0, 0.5625] {
            for view in [View::Front, View::Side, View::Back, View::ThreeQuarter] {
                let camera = Camera::framing(standing(), view, aspect);
                let places = standing()
                    .corners()
                    .map(|corner| seen(&camera, aspect, corner));
                let low = places.iter().copied().reduce(Vec2::min).unwrap();
                let high = places.iter().copied().reduce(Vec2::max).unwrap();
                let largest = (high - low).max_element();
                assert!(
                    high.max_element() < 0.95 && low.min_element() > -0.95,
                    "{view:?}"
                );
                assert!(
                    (low + high).abs().max_element() < 0.02,
                    "{view:?} {low} {high}"
                );
                assert!(largest > 1.6, "{view:?} fills only {largest}");
            }
        }
    }

    #[test]
    fn the_named_views_look_from_their_side() {
        let from = |view| {
            let camera = Camera::framing(standing(), view, 1.5);
            camera.eye - camera.target
        };
        assert!(from(View::Front).z > 0.0 && from(View::Front).x.abs() < 1e-4);
        assert!(from(View::Side).x > 0.0 && from(View::Side).z.abs() < 1e-4);
        assert!(from(View::Back).z < 0.0 && from(View::Back).x.abs() < 1e-4);
        assert!(from(View::ThreeQuarter).x > 0.0 && from(View::ThreeQuarter).z > 0.0);
    }

    #[test]
    fn a_turntable_keeps_its_distance_and_closes() {
        let axis = |camera: &Camera| {
            let arm = camera.eye - standing().center();
            Vec2::new(arm.x, arm.z).length()
        };
        let start = Camera::turntable(standing(), 0.0, 1.5);
        for step in 0..8_u8 {
            let camera = Camera::turntable(standing(), f32::from(step) / 8.0, 1.5);
            assert!((axis(&camera) - axis(&start)).abs() < 1e-4);
            for corner in standing().corners() {
                assert!(seen(&camera, 1.5, corner).abs().max_element() < 0.96);
            }
        }
        let end = Camera::turntable(standing(), 1.0, 1.5);
        assert!((end.eye - start.eye).length() < 1e-4);
    }
}
