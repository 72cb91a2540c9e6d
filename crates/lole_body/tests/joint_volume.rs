//! Bent knees and elbows keep their flesh: the section through the joint, and the knee's volume.

#![expect(clippy::unwrap_used, reason = "a test of the default dancers")]

use glam::{DVec3, Quat, Vec3};
use lole_body::{Bone, Dancer, Figure, Measurements, Pose, Tape};
use lole_geom::trig;

fn dancer(figure: Figure) -> Dancer {
    let tape = Tape {
        figure,
        ..Tape::default()
    };
    Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap()
}

/// A hinge: its bone, the bone above and the joint below it.
struct Hinge {
    above: Bone,
    bone: Bone,
    end: Bone,
}

const KNEE: Hinge = Hinge {
    above: Bone::LeftUpperLeg,
    bone: Bone::LeftLowerLeg,
    end: Bone::LeftFoot,
};
const ELBOW: Hinge = Hinge {
    above: Bone::LeftUpperArm,
    bone: Bone::LeftLowerArm,
    end: Bone::LeftHand,
};

impl Hinge {
    /// Unit directions down the bone above and down the bone itself, in the bind pose.
    fn directions(&self, dancer: &Dancer) -> [Vec3; 2] {
        let at = |bone| dancer.skeleton.joint(bone);
        [
            (at(self.bone) - at(self.above)).normalize_or_zero(),
            (at(self.end) - at(self.bone)).normalize_or_zero(),
        ]
    }

    /// Turns the bone until it makes `degrees` with the one above.
    fn bent(&self, dancer: &Dancer, degrees: f32) -> Pose {
        let [above, below] = self.directions(dancer);
        // The knee bends back, the elbow to the front.
        let forward = if self.bone == Bone::LeftLowerLeg {
            Vec3::NEG_Z
        } else {
            Vec3::Z
        };
        let side = (forward - above * forward.dot(above)).normalize_or_zero();
        let (sin, cos) = trig::sin_cos(degrees.to_radians());
        let wanted = above * cos + side * sin;
        let mut pose = Pose::default();
        pose.rotate(self.bone, Quat::from_rotation_arc(below, wanted));
        pose
    }

    /// Volume of the body [m³] and area of the section through the joint [m²], in a pose.
    fn measured(&self, dancer: &Dancer, pose: &Pose) -> [f64; 2] {
        let triangles = dancer.skin.body_triangles();
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world = dancer.skeleton.world_from_bind(pose);
        dancer.skin.pose(&world, &mut positions, &mut normals);
        let joint = dancer.skeleton.joint(self.bone);
        let [above, below] = self.directions(dancer);
        let below = pose.rotation(self.bone) * below;
        let normal = (above + below).normalize_or_zero().as_dvec3();
        let joint = joint.as_dvec3();
        let points: Vec<DVec3> = positions.iter().map(|p| p.as_dvec3() - joint).collect();
        let (mut volume, mut area) = (0.0, 0.0);
        for triangle in triangles {
            let corners = triangle.map(|vertex| points[vertex as usize]);
            let [a, b, c] = corners;
            volume += a.dot(b.cross(c)) / 6.0;
            area -= swept(corners, normal);
        }
        [volume, area]
    }
}

/// Area [m²] that a triangle's cut with the plane through the origin sweeps around the origin; 0 far
/// from it, where the plane cuts other limbs.
fn swept(corners: [DVec3; 3], normal: DVec3) -> f64 {
    const REACH: f64 = 0.14;
    let heights = corners.map(|corner| corner.dot(normal));
    let mut ends = Vec::new();
    for side in 0..3 {
        let (i, j) = (side, (side + 1) % 3);
        if (heights[i] < 0.0) != (heights[j] < 0.0) {
            let share = heights[i] / (heights[i] - heights[j]);
            ends.push((corners[i].lerp(corners[j], share), heights[i] < 0.0));
        }
    }
    let [(a, a_up), (b, _)] = ends[..] else {
        return 0.0;
    };
    if a.length() > REACH || b.length() > REACH {
        return 0.0;
    }
    let area = 0.5 * a.cross(b).dot(normal);
    if a_up { area } else { -area }
}

/// Volume of a limb about a joint [m³]: a piece as long as it is wide.
fn piece(area: f64) -> f64 {
    area * (4.0 * area / std::f64::consts::PI).sqrt()
}

#[test]
fn bent_knees_and_elbows_keep_their_flesh() {
    for figure in [Figure::Woman, Figure::Man, Figure::Child] {
        let dancer = dancer(figure);
        for (name, hinge) in [("knee", KNEE), ("elbow", ELBOW)] {
            let [volume, area] = hinge.measured(&dancer, &hinge.bent(&dancer, 0.0));
            for degrees in [75.0, 90.0] {
                let bent = hinge.measured(&dancer, &hinge.bent(&dancer, degrees));
                let section = bent[1] / area;
                let kept = 1.0 + (bent[0] - volume) / piece(area);
                let what = format!("{figure:?} {name} at {degrees}");
                assert!(section > 0.95, "{what}: section {section}");
                // An elbow's fold is most of the piece; a knee's is not.
                let is_knee = hinge.bone == Bone::LeftLowerLeg;
                assert!(!is_knee || kept > 0.80, "{what}: volume {kept}");
            }
        }
    }
}
