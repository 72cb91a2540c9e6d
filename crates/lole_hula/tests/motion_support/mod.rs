//! A skeleton for motion tests that does not depend on the building of the dancer's surface.

use glam::Vec3;
use lole_body::{Bone, Skeleton};

/// Joints of the mean woman of 158 cm in the middle and on the left [m].
const JOINTS: [(&str, [f32; 3]); 29] = [
    ("hips", [0.0, 0.8393, 0.02]),
    ("spine", [0.0, 0.9582, 0.0178]),
    ("chest", [0.0, 1.0628, 0.0123]),
    ("upperChest", [0.0, 1.1888, 0.0117]),
    ("neck", [0.0, 1.3424, -0.0012]),
    ("head", [0.0, 1.3986, 0.0257]),
    ("leftShoulder", [0.0615, 1.3117, 0.0171]),
    ("leftUpperArm", [0.1525, 1.2578, 0.0206]),
    ("leftLowerArm", [0.3145, 1.082, 0.0265]),
    ("leftHand", [0.4245, 0.9602, 0.1636]),
    ("leftUpperLeg", [0.0906, 0.7924, 0.0159]),
    ("leftLowerLeg", [0.1303, 0.4394, 0.047]),
    ("leftFoot", [0.1568, 0.0671, 0.025]),
    ("leftToes", [0.1559, 0.0239, 0.147]),
    ("leftIndexProximal", [0.4489, 0.9204, 0.245]),
    ("leftIndexIntermediate", [0.452, 0.9064, 0.2626]),
    ("leftIndexDistal", [0.4515, 0.8914, 0.2764]),
    ("leftMiddleProximal", [0.4632, 0.9115, 0.2286]),
    ("leftMiddleIntermediate", [0.4697, 0.8877, 0.2458]),
    ("leftMiddleDistal", [0.4721, 0.868, 0.2601]),
    ("leftRingProximal", [0.4699, 0.9055, 0.2134]),
    ("leftRingIntermediate", [0.4777, 0.8833, 0.2246]),
    ("leftRingDistal", [0.4813, 0.8642, 0.2349]),
    ("leftLittleProximal", [0.4706, 0.8987, 0.196]),
    ("leftLittleIntermediate", [0.4763, 0.8816, 0.202]),
    ("leftLittleDistal", [0.4777, 0.8686, 0.2064]),
    ("leftThumbMetacarpal", [0.4254, 0.9517, 0.2016]),
    ("leftThumbProximal", [0.4071, 0.9431, 0.2199]),
    ("leftThumbDistal", [0.3963, 0.9294, 0.2466]),
];

/// The mean woman's skeleton; right joints mirror the left ones.
pub(crate) fn woman() -> Skeleton {
    let joints = Bone::ALL.iter().map(|bone| {
        let mirrored = bone.name().replace("right", "left");
        let (_, [x, y, z]) = JOINTS
            .iter()
            .find(|(name, _)| *name == mirrored)
            .expect("every bone has a joint");
        let side = if bone.name().starts_with("right") {
            -1.0
        } else {
            1.0
        };
        Vec3::new(side * x, *y, *z)
    });
    Skeleton {
        joints: joints.collect(),
        waist_side: Vec3::new(0.115, 0.975, 0.02),
    }
}
