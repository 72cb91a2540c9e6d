//! Which way is up in a recording, where its dancer faces, and what its numbers measure.

use glam::{Mat3, Quat, Vec3};
use lole_body::Bone;

use crate::{BoneMap, JointPlace};

/// Cosine of the angle up to which a way from hips to head is taken for an axis of the file.
const UPRIGHT: f32 = 0.94;

/// Directions of a standing body in the space of a recording; unit vectors, right-handed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// To the dancer's left.
    pub left: Vec3,
    /// From the floor up.
    pub up: Vec3,
    /// Where she faces.
    pub front: Vec3,
}

impl Axes {
    /// Axes whose up is `up`, with `left` made square to it.
    #[must_use]
    pub fn new(left: Vec3, up: Vec3) -> Self {
        let up = up.try_normalize().unwrap_or(Vec3::Y);
        let left = (left - up * left.dot(up))
            .try_normalize()
            .unwrap_or_else(|| up.any_orthonormal_vector());
        Self {
            left,
            up,
            front: left.cross(up),
        }
    }

    /// Axes of a body whose joints lie at `places`.
    #[must_use]
    pub fn of(map: &BoneMap, places: &[JointPlace]) -> Self {
        let up = upright(map, places);
        let axis = snapped(up);
        // The head of one who stands upright is a little before or behind the hips.
        let stands = UPRIGHT * up.length() < up.dot(axis);
        Self::new(left(map, places), if stands { axis } else { up })
    }

    /// These axes set upright over the floor: up is the axis of the file nearest to `up`, and the front is
    /// on the side where it was.
    pub(crate) fn over_floor(self, up: Vec3) -> Self {
        Self::new(self.left, snapped(up))
    }

    /// Turn from the recording's space to the product's: `+X` left, `+Y` up, `+Z` front.
    #[must_use]
    pub fn world_from_file(&self) -> Quat {
        let file_from_world = Mat3::from_cols(self.left, self.up, self.front);
        Quat::from_mat3(&file_from_world.transpose()).normalize()
    }
}

/// From hips to head, or to the chest where no head is known; not normalized.
pub(crate) fn upright(map: &BoneMap, places: &[JointPlace]) -> Vec3 {
    let at = |joint: usize| places[joint].position;
    let hips = 0.5 * (at(map.needed(Bone::LeftUpperLeg)) + at(map.needed(Bone::RightUpperLeg)));
    let top = map.joint(Bone::Head).unwrap_or_else(|| map.chest());
    at(top) - hips
}

/// From the right hip joint to the left one; not normalized.
pub(crate) fn left(map: &BoneMap, places: &[JointPlace]) -> Vec3 {
    let at = |bone| places[map.needed(bone)].position;
    at(Bone::LeftUpperLeg) - at(Bone::RightUpperLeg)
}

/// The nearest of the six directions along axes.
fn snapped(direction: Vec3) -> Vec3 {
    let size = direction.abs();
    let axis = if size.y >= size.x && size.y >= size.z {
        Vec3::Y
    } else if size.z >= size.x {
        Vec3::Z
    } else {
        Vec3::X
    };
    axis * direction.dot(axis).signum()
}

/// Name of the axis nearest to a direction, such as `+Y`.
#[must_use]
pub fn axis_name(direction: Vec3) -> &'static str {
    const NAMES: [(&str, Vec3); 6] = [
        ("+Y", Vec3::Y),
        ("+Z", Vec3::Z),
        ("+X", Vec3::X),
        ("-Y", Vec3::NEG_Y),
        ("-Z", Vec3::NEG_Z),
        ("-X", Vec3::NEG_X),
    ];
    let nearest = snapped(direction);
    let found = NAMES.iter().find(|(_, axis)| axis.dot(nearest) > 0.5);
    found.map_or("+Y", |(name, _)| name)
}

/// What the numbers of a recording measure. Retargeting needs no unit, because it scales by the
/// length of the legs: this is for the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Name in both languages where the field has one.
    pub name: &'static str,
    /// Length of one unit [m].
    pub meters: f32,
}

/// Units that recordings are in. The CMU database counts in inches over 0.45.
const UNITS: [Unit; 6] = [
    unit("m", 1.0),
    unit("cm", 0.01),
    unit("inch", 0.0254),
    unit("inch/0.45 (CMU)", 0.0254 / 0.45),
    unit("mm", 0.001),
    unit("foot", 0.3048),
];

const fn unit(name: &'static str, meters: f32) -> Unit {
    Unit { name, meters }
}

/// Thigh and shank of an adult [m], the middle between women and men.
const USUAL_LEG: f32 = 0.82;

impl Unit {
    /// The unit in which a leg (thigh and shank) of `leg_length` file units is most like an
    /// adult's; `None` where no unit brings it to between a child's and a giant's.
    #[must_use]
    pub fn of_leg(leg_length: f32) -> Option<Self> {
        let misfit = |unit: &Self| {
            let ratio = leg_length * unit.meters / USUAL_LEG;
            ratio.max(1.0 / ratio.max(f32::MIN_POSITIVE))
        };
        let best = UNITS
            .iter()
            .min_by(|a, b| misfit(a).total_cmp(&misfit(b)))?;
        (misfit(best) < 1.7).then_some(*best)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leg_of_eighty_centimeters_tells_its_unit() {
        for (length, name) in [
            (0.8, "m"),
            (80.0, "cm"),
            (31.5, "inch"),
            (14.3, "inch/0.45 (CMU)"),
            (800.0, "mm"),
        ] {
            assert_eq!(Unit::of_leg(length).unwrap().name, name);
        }
        assert_eq!(Unit::of_leg(1e5), None);
        assert_eq!(Unit::of_leg(0.0), None);
    }

    #[test]
    fn axes_turn_any_space_to_left_up_and_front() {
        let axes = Axes::new(Vec3::NEG_Y, Vec3::Z);
        let turn = axes.world_from_file();
        for (from, to) in [
            (axes.left, Vec3::X),
            (axes.up, Vec3::Y),
            (axes.front, Vec3::Z),
        ] {
            assert!((turn * from - to).length() < 1e-6);
        }
        assert_eq!(axis_name(axes.front), "-X");
    }
}
