//! How programs name the joints of a person.
//!
//! Names are compared without case, spaces, signs and what stands before a colon. A convention says
//! what its joints are called and where the side is said; the one that names most bones of a
//! recording is taken.

use lole_body::Bone;

use crate::Recording;

/// Where a name says its side.
#[derive(Debug, Clone, Copy)]
enum Side {
    /// `LeftArm`, `lShldr`: in front.
    Before([&'static str; 2]),
    /// `thigh_l`: at the end.
    After([&'static str; 2]),
}

/// Names of one family of programs, as [`bare`] leaves them.
#[derive(Debug)]
struct Convention {
    name: &'static str,
    /// What all names may begin with.
    prefixes: &'static [&'static str],
    side: Side,
    hips: &'static [&'static str],
    head: &'static [&'static str],
    /// Shoulder, upper arm, lower arm, hand, upper leg, lower leg, foot, toes; alternatives in the
    /// order of preference.
    limbs: [&'static [&'static str]; 8],
    fingers: Fingers,
}

/// How the three bones of each finger are called, root first: what a name ends in.
#[derive(Debug, Clone, Copy)]
struct Fingers {
    names: [&'static str; 5],
    joints: [[&'static str; 3]; 2],
}

/// `HandThumb1` to `HandPinky3`.
const NUMBERED: Fingers = Fingers {
    names: [
        "handthumb",
        "handindex",
        "handmiddle",
        "handring",
        "handpinky",
    ],
    joints: [["1", "2", "3"], ["1", "2", "3"]],
};
/// `thumb_01` to `pinky_03`.
const NUMBERED_FROM_01: Fingers = Fingers {
    names: ["thumb", "index", "middle", "ring", "pinky"],
    joints: [["01", "02", "03"], ["01", "02", "03"]],
};
/// `thumb1` to `pinky3`.
const NUMBERED_FROM_1: Fingers = Fingers {
    names: ["thumb", "index", "mid", "ring", "pinky"],
    joints: [["1", "2", "3"], ["1", "2", "3"]],
};

const CONVENTIONS: [Convention; 13] = [
    Convention {
        name: "MotionBuilder, Mixamo, CMU",
        prefixes: &["", "mixamorig", "character1"],
        side: Side::Before(["left", "right"]),
        hips: &["hips"],
        head: &["head"],
        limbs: [
            &["shoulder"],
            &["arm"],
            &["forearm"],
            &["hand"],
            &["upleg"],
            &["leg"],
            &["foot"],
            &["toebase", "toe"],
        ],
        fingers: NUMBERED,
    },
    Convention {
        name: "VRM, Unity",
        prefixes: &[""],
        side: Side::Before(["left", "right"]),
        hips: &["hips"],
        head: &["head"],
        limbs: [
            &["shoulder"],
            &["upperarm"],
            &["lowerarm"],
            &["hand"],
            &["upperleg"],
            &["lowerleg"],
            &["foot"],
            &["toes"],
        ],
        fingers: Fingers {
            names: ["thumb", "index", "middle", "ring", "little"],
            joints: [
                ["metacarpal", "proximal", "distal"],
                ["proximal", "intermediate", "distal"],
            ],
        },
    },
    Convention {
        name: "VRoid",
        prefixes: &["jbip"],
        side: Side::Before(["l", "r"]),
        hips: &["chips"],
        head: &["chead"],
        limbs: [
            &["shoulder"],
            &["upperarm"],
            &["lowerarm"],
            &["hand"],
            &["upperleg"],
            &["lowerleg"],
            &["foot"],
            &["toebase"],
        ],
        fingers: Fingers {
            names: ["thumb", "index", "middle", "ring", "little"],
            joints: [["1", "2", "3"], ["1", "2", "3"]],
        },
    },
    Convention {
        name: "3ds Max Biped",
        prefixes: &["bip01", "bip001", "bip1", "bip"],
        side: Side::Before(["l", "r"]),
        hips: &["pelvis", ""],
        head: &["head"],
        limbs: [
            &["clavicle"],
            &["upperarm"],
            &["forearm"],
            &["hand"],
            &["thigh"],
            &["calf"],
            &["foot"],
            &["toe0"],
        ],
        fingers: Fingers {
            names: ["finger0", "finger1", "finger2", "finger3", "finger4"],
            joints: [["", "1", "2"], ["", "1", "2"]],
        },
    },
    Convention {
        name: "Daz",
        prefixes: &["", "genesis"],
        side: Side::Before(["l", "r"]),
        hips: &["hip", "pelvis"],
        head: &["head"],
        limbs: [
            &["collar"],
            &["shldrbend", "shldr", "upperarm"],
            &["forearmbend", "forearm"],
            &["hand"],
            &["thighbend", "thigh"],
            &["shin"],
            &["foot"],
            &["toe", "toes", "metatarsals"],
        ],
        fingers: NUMBERED_FROM_1,
    },
    Convention {
        name: "Poser, LifeForms",
        prefixes: &[""],
        side: Side::Before(["left", "right"]),
        hips: &["hips", "hip"],
        head: &["head"],
        limbs: [
            &["collar"],
            &["shoulder"],
            &["elbow"],
            &["wrist"],
            &["hip"],
            &["knee"],
            &["ankle"],
            &["toe"],
        ],
        fingers: NUMBERED,
    },
    Convention {
        name: "SMPL",
        prefixes: &["", "f", "m"],
        side: Side::Before(["l", "r"]),
        hips: &["pelvis"],
        head: &["head"],
        limbs: [
            &["collar"],
            &["shoulder"],
            &["elbow"],
            &["wrist"],
            &["hip"],
            &["knee"],
            &["ankle"],
            &["foot"],
        ],
        fingers: NUMBERED_FROM_1,
    },
    Convention {
        name: "Unreal",
        prefixes: &[""],
        side: Side::After(["l", "r"]),
        hips: &["pelvis"],
        head: &["head"],
        limbs: [
            &["clavicle"],
            &["upperarm"],
            &["lowerarm"],
            &["hand"],
            &["thigh"],
            &["calf"],
            &["foot"],
            &["ball"],
        ],
        fingers: NUMBERED_FROM_01,
    },
    Convention {
        name: "Rigify",
        prefixes: &["", "def"],
        side: Side::After(["l", "r"]),
        hips: &["spine"],
        head: &["head", "spine006"],
        limbs: [
            &["shoulder"],
            &["upperarm"],
            &["forearm"],
            &["hand"],
            &["thigh"],
            &["shin"],
            &["foot"],
            &["toe"],
        ],
        fingers: Fingers {
            names: ["thumb", "findex", "fmiddle", "fring", "fpinky"],
            joints: [["01", "02", "03"], ["01", "02", "03"]],
        },
    },
    Convention {
        name: "VRM add-on of Blender",
        prefixes: &[""],
        side: Side::After(["l", "r"]),
        hips: &["hips"],
        head: &["head"],
        limbs: [
            &["shoulder"],
            &["upperarm"],
            &["lowerarm"],
            &["hand"],
            &["upperleg"],
            &["lowerleg"],
            &["foot"],
            &["toes"],
        ],
        fingers: NUMBERED_FROM_1,
    },
    Convention {
        name: "VRChat",
        prefixes: &[""],
        side: Side::Before(["left", "right"]),
        hips: &["hips"],
        head: &["head"],
        limbs: [
            &["shoulder"],
            &["arm"],
            &["elbow"],
            &["wrist"],
            &["leg"],
            &["knee"],
            &["ankle"],
            &["toe"],
        ],
        fingers: NUMBERED_FROM_1,
    },
    Convention {
        name: "MakeHuman",
        prefixes: &[""],
        side: Side::After(["l", "r"]),
        hips: &["root"],
        head: &["head"],
        limbs: [
            &["clavicle"],
            &["upperarm01"],
            &["lowerarm01"],
            &["wrist"],
            &["upperleg01"],
            &["lowerleg01"],
            &["foot"],
            &["toe11"],
        ],
        fingers: Fingers {
            names: ["finger1", "finger2", "finger3", "finger4", "finger5"],
            joints: [["1", "2", "3"], ["1", "2", "3"]],
        },
    },
    Convention {
        name: "MikuMikuDance",
        prefixes: &[""],
        side: Side::Before(["左", "右"]),
        hips: &["下半身", "センター"],
        head: &["頭"],
        limbs: [
            &["肩"],
            &["腕"],
            &["ひじ"],
            &["手首"],
            &["足"],
            &["ひざ"],
            &["足首"],
            &["つま先"],
        ],
        fingers: NUMBERED_FROM_1,
    },
];

/// Bones of one side in the order of [`Convention::limbs`].
const LIMBS: [[Bone; 8]; 2] = [
    [
        Bone::LeftShoulder,
        Bone::LeftUpperArm,
        Bone::LeftLowerArm,
        Bone::LeftHand,
        Bone::LeftUpperLeg,
        Bone::LeftLowerLeg,
        Bone::LeftFoot,
        Bone::LeftToes,
    ],
    [
        Bone::RightShoulder,
        Bone::RightUpperArm,
        Bone::RightLowerArm,
        Bone::RightHand,
        Bone::RightUpperLeg,
        Bone::RightLowerLeg,
        Bone::RightFoot,
        Bone::RightToes,
    ],
];

/// The first finger bone of each side; the other fourteen follow in the order of bones.
const FIRST_FINGER: [Bone; 2] = [Bone::LeftThumbMetacarpal, Bone::RightThumbMetacarpal];

/// A name as it is compared: what follows the last colon, its letters and digits in lower case.
fn bare(name: &str) -> String {
    let name = name.rsplit(':').next().unwrap_or(name);
    name.chars()
        .filter(|letter| letter.is_alphanumeric())
        .flat_map(char::to_lowercase)
        .collect()
}

/// The convention that names most bones, with the joint of each bone; `None` where none names any.
pub(crate) fn by_names(recording: &Recording) -> Option<(&'static str, Vec<Option<usize>>)> {
    let names: Vec<String> = recording
        .joints
        .iter()
        .map(|joint| bare(&joint.name))
        .collect();
    // Bones of the body count before fingers, which programs name alike.
    let of_body = |joints: &[Option<usize>]| {
        let of_body = LIMBS.iter().flatten().chain([&Bone::Hips, &Bone::Head]);
        of_body
            .filter(|bone| joints[bone.index()].is_some())
            .count()
    };
    let mut best: Option<(usize, &'static str, Vec<Option<usize>>)> = None;
    for convention in &CONVENTIONS {
        for prefix in convention.prefixes {
            let joints = convention.joints(prefix, &names);
            let count = 100 * of_body(&joints) + joints.iter().flatten().count();
            if best.as_ref().is_none_or(|(most, ..)| *most < count) {
                best = Some((count, convention.name, joints));
            }
        }
    }
    let (count, name, joints) = best?;
    (count > 0).then_some((name, joints))
}

impl Convention {
    /// The joint of each bone among `names`.
    fn joints(&self, prefix: &str, names: &[String]) -> Vec<Option<usize>> {
        let find = |wanted: &str| {
            names
                .iter()
                .position(|name| !name.is_empty() && name.strip_prefix(prefix) == Some(wanted))
        };
        let first = |choices: &[&str]| choices.iter().find_map(|choice| find(choice));
        let mut joints = vec![None; Bone::COUNT];
        joints[Bone::Hips.index()] = first(self.hips);
        joints[Bone::Head.index()] = first(self.head);
        for side in 0..2 {
            let sided = |part: &str| match self.side {
                Side::Before(words) => format!("{}{part}", words[side]),
                Side::After(words) => format!("{part}{}", words[side]),
            };
            for (bone, choices) in LIMBS[side].into_iter().zip(self.limbs) {
                joints[bone.index()] = choices.iter().find_map(|part| find(&sided(part)));
            }
            let start = FIRST_FINGER[side].index();
            for (finger, name) in self.fingers.names.iter().enumerate() {
                let ends = self.fingers.joints[usize::from(finger > 0)];
                for (joint, end) in ends.iter().enumerate() {
                    joints[start + 3 * finger + joint] = find(&sided(&format!("{name}{end}")));
                }
            }
        }
        joints
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_compared_without_case_signs_and_namespaces() {
        assert_eq!(bare("mixamorig:LeftUpLeg"), "leftupleg");
        assert_eq!(bare("Bip01 L UpperArm"), "bip01lupperarm");
        assert_eq!(bare("J_Bip_C_Hips"), "jbipchips");
        assert_eq!(bare("upper_arm.L"), "upperarml");
    }

    #[test]
    fn the_fingers_of_a_side_follow_its_thumb() {
        for (side, last) in [Bone::LeftLittleDistal, Bone::RightLittleDistal]
            .into_iter()
            .enumerate()
        {
            assert_eq!(FIRST_FINGER[side].index() + 14, last.index());
        }
    }
}
