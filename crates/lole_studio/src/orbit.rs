//! The camera on its arm around the dancer, moved by mouse and touchpad.

use glam::{Vec2, Vec3};
use lole_geom::trig;
use lole_render::{Bounds, Camera, View};

/// Turn for a drag over the whole height of the picture [rad].
const TURN_PER_HEIGHT: f32 = 3.6;
/// The camera looks up and down at most this far [rad]: not from under the floor.
const PITCHES: [f32; 2] = [-0.12, 1.45];
/// Nearest and farthest that the camera goes [m].
const DISTANCES: [f32; 2] = [0.45, 14.0];
/// The target stays within this box around the stage [m].
const STAGE: f32 = 3.0;

/// A camera on an arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// What it looks at [m].
    pub target: Vec3,
    /// Angle about the vertical [rad], 0 in front, growing towards the dancer's left.
    pub azimuth: f32,
    /// Angle above the horizontal [rad].
    pub pitch: f32,
    /// Length of the arm [m].
    pub distance: f32,
    /// Opening from bottom to top [rad].
    pub vertical_fov: f32,
    /// The view it was last set to, until it is moved by hand.
    pub view: Option<View>,
}

/// The views of the buttons, with the angle they look from.
pub(crate) const VIEWS: [View; 4] = [View::Front, View::Side, View::Back, View::ThreeQuarter];

impl Orbit {
    /// The camera that shows all of `bounds` from `view` in a picture of `aspect`.
    #[must_use]
    pub fn framing(bounds: Bounds, view: View, aspect: f32) -> Self {
        let camera = Camera::framing(bounds, view, aspect);
        let arm = camera.eye - camera.target;
        let distance = arm.length().max(1.0e-3);
        Self {
            target: camera.target,
            azimuth: view.azimuth(),
            pitch: trig::atan2(arm.y, Vec2::new(arm.x, arm.z).length()),
            distance,
            vertical_fov: camera.vertical_fov,
            view: Some(view),
        }
    }

    /// Unit vectors right, up and backward.
    #[must_use]
    pub fn axes(&self) -> [Vec3; 3] {
        let (sin_azimuth, cos_azimuth) = trig::sin_cos(self.azimuth);
        let (sin_pitch, cos_pitch) = trig::sin_cos(self.pitch);
        let backward = Vec3::new(sin_azimuth * cos_pitch, sin_pitch, cos_azimuth * cos_pitch);
        let right = Vec3::new(cos_azimuth, 0.0, -sin_azimuth);
        [right, backward.cross(right), backward]
    }

    /// The camera as the renderer wants it.
    #[must_use]
    pub fn camera(&self) -> Camera {
        let [_, _, backward] = self.axes();
        Camera {
            eye: self.target + backward * self.distance,
            target: self.target,
            vertical_fov: self.vertical_fov,
        }
    }

    /// Turns by a drag, in heights of the picture: to the right turns the dancer to the right.
    pub fn turn(&mut self, drag: Vec2) {
        let turned = self.azimuth - drag.x * TURN_PER_HEIGHT;
        self.azimuth = turned.rem_euclid(std::f32::consts::TAU);
        self.pitch = (self.pitch + drag.y * TURN_PER_HEIGHT).clamp(PITCHES[0], PITCHES[1]);
        self.view = None;
    }

    /// Moves across by a drag, in heights of the picture: what is under the pointer stays there.
    pub fn pan(&mut self, drag: Vec2) {
        let [right, up, _] = self.axes();
        let height = 2.0 * trig::tan(self.vertical_fov * 0.5) * self.distance;
        let target = self.target - right * (drag.x * height) + up * (drag.y * height);
        self.target = target.clamp(Vec3::splat(-STAGE), Vec3::splat(STAGE));
        self.view = None;
    }

    /// Comes nearer by this factor.
    pub fn zoom(&mut self, factor: f32) {
        if factor.is_finite() && 0.0 < factor {
            self.distance = (self.distance / factor).clamp(DISTANCES[0], DISTANCES[1]);
            self.view = None;
        }
    }

    /// Unit direction of the ray through a place in the picture: from -1 to 1 both ways, up is
    /// positive, in a picture of `aspect`.
    #[must_use]
    pub fn ray(&self, place: Vec2, aspect: f32) -> Vec3 {
        let [right, up, backward] = self.axes();
        let reach = trig::tan(self.vertical_fov * 0.5);
        (right * (place.x * reach * aspect) + up * (place.y * reach) - backward).normalize_or_zero()
    }
}

/// The particle under a ray, nearest to the eye among those within `reach` [rad] of it.
#[must_use]
pub(crate) fn pick(particles: &[Vec3], eye: Vec3, ray: Vec3, reach: f32) -> Option<u32> {
    let mut best = None;
    let mut best_depth = f32::MAX;
    for (particle, &position) in (0..).zip(particles) {
        let arm = position - eye;
        let depth = arm.dot(ray);
        if depth <= 0.0 || best_depth <= depth {
            continue;
        }
        if (arm - ray * depth).length() <= reach * depth {
            best_depth = depth;
            best = Some(particle);
        }
    }
    best
}

/// Where a ray meets the plane through `point` across the camera's view.
#[must_use]
pub(crate) fn hand_at(orbit: &Orbit, ray: Vec3, point: Vec3) -> Vec3 {
    let [_, _, backward] = orbit.axes();
    let eye = orbit.camera().eye;
    let along = -ray.dot(backward);
    let depth = -(point - eye).dot(backward);
    if 1.0e-4 < along && 0.0 < depth {
        eye + ray * (depth / along)
    } else {
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn front() -> Orbit {
        let bounds = Bounds {
            min: Vec3::new(-0.6, 0.0, -0.3),
            max: Vec3::new(0.6, 1.7, 0.3),
        };
        Orbit::framing(bounds, View::Front, 1.2)
    }

    #[test]
    fn it_never_tips_over_nor_leaves_the_stage() {
        let mut orbit = front();
        for _ in 0..100 {
            orbit.turn(Vec2::new(0.3, 1.0));
            orbit.pan(Vec2::new(1.0, 2.0));
            orbit.zoom(0.5);
        }
        let camera = orbit.camera();
        assert!(orbit.pitch <= PITCHES[1] && orbit.distance <= DISTANCES[1]);
        assert!(orbit.target.abs().max_element() <= STAGE && camera.eye.is_finite());
        orbit.zoom(f32::NAN);
        orbit.zoom(0.0);
        assert!(orbit.distance.is_finite());
    }

    #[test]
    fn dragging_to_the_right_brings_her_right_side_to_the_front() {
        // Seen from the front her left is on the right; walking to her right shows that side.
        let mut orbit = front();
        orbit.turn(Vec2::new(0.1, 0.0));
        assert!(orbit.camera().eye.x < 0.0);
    }

    #[test]
    fn the_hand_stays_under_the_pointer() {
        let orbit = front();
        let held = Vec3::new(0.2, 0.7, 0.15);
        let place = Vec2::new(0.3, -0.2);
        let ray = orbit.ray(place, 1.2);
        let hand = hand_at(&orbit, ray, held);
        let eye = orbit.camera().eye;
        assert!((hand - eye).normalize_or_zero().distance(ray) < 1e-5);
        let [_, _, backward] = orbit.axes();
        assert!((hand - held).dot(backward).abs() < 1e-4);
    }

    #[test]
    fn the_front_of_the_cloth_is_picked_not_its_back() {
        let orbit = front();
        let ray = orbit.ray(Vec2::ZERO, 1.2);
        let eye = orbit.camera().eye;
        let (near, far) = (eye + ray * 3.0, eye + ray * 3.4);
        let aside = near + orbit.axes()[0];
        assert_eq!(pick(&[far, aside, near], eye, ray, 0.01), Some(2));
        assert_eq!(pick(&[aside], eye, ray, 0.01), None);
        assert_eq!(pick(&[], eye, ray, 0.01), None);
    }
}
