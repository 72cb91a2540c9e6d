//! Which joint of a recording is which bone of a dancer.

use lole_body::Bone;
use lole_language::Sentence;

use crate::{Recording, RecordingError};
use crate::{hierarchy, names};

/// Bones without which nobody dances.
const NEEDED: [Bone; 13] = [
    Bone::Hips,
    Bone::LeftUpperLeg,
    Bone::LeftLowerLeg,
    Bone::LeftFoot,
    Bone::RightUpperLeg,
    Bone::RightLowerLeg,
    Bone::RightFoot,
    Bone::LeftUpperArm,
    Bone::LeftLowerArm,
    Bone::LeftHand,
    Bone::RightUpperArm,
    Bone::RightLowerArm,
    Bone::RightHand,
];

/// How joints were recognized.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapSource {
    /// By their names; the family of programs that give such names.
    Names(&'static str),
    /// By how they hang together.
    Hierarchy,
    /// By a list that was given.
    List,
    /// The file itself says it; the kind of file.
    File(&'static str),
}

/// Which joint is which bone.
#[derive(Debug, Clone, PartialEq)]
pub struct BoneMap {
    /// How it was found.
    pub source: MapSource,
    joints: Vec<Option<usize>>,
    /// Joints of the trunk from the one above the hips to the one on which the arms hang.
    spine: Vec<usize>,
    /// Joints from above the chest to the head.
    neck: Vec<usize>,
}

impl BoneMap {
    /// Recognizes the joints by their names, or else by how they hang together.
    ///
    /// # Errors
    /// [`RecordingError::NotHumanoid`].
    pub fn recognize(recording: &Recording) -> Result<Self, RecordingError> {
        let named = names::by_names(recording)
            .map(|(name, joints)| Self::checked(recording, MapSource::Names(name), joints));
        match named {
            Some(Ok(map)) => Ok(map),
            said => {
                let joints = hierarchy::by_hierarchy(recording);
                let hung = joints.map(|j| Self::checked(recording, MapSource::Hierarchy, j));
                match (hung, said) {
                    (Some(Ok(map)), _) => Ok(map),
                    (_, Some(Err(error))) | (Some(Err(error)), _) => Err(error),
                    _ => Err(not_humanoid(NEEDED.iter())),
                }
            }
        }
    }

    /// Takes the joints from a list, over what is recognized by name: on each line
    /// `joint = bone`, the bone by its VRM name (`leftUpperLeg`); `#` starts a comment.
    ///
    /// # Errors
    /// A line that names no joint or no bone, [`RecordingError::NotHumanoid`].
    pub fn from_list(recording: &Recording, list: &str) -> Result<Self, RecordingError> {
        let named = names::by_names(recording);
        let mut joints = named.map_or_else(|| vec![None; Bone::COUNT], |(_, joints)| joints);
        for (line, text) in (1..).zip(list.lines()) {
            let text = text.split('#').next().unwrap_or_default().trim();
            if text.is_empty() {
                continue;
            }
            let (joint, bone) = list_entry(recording, text)
                .map_err(|problem| RecordingError::BoneList { line, problem })?;
            // A joint is one bone: what a name said before is forgotten.
            for known in &mut joints {
                *known = known.filter(|&known| known != joint);
            }
            joints[bone.index()] = Some(joint);
        }
        Self::checked(recording, MapSource::List, joints)
    }

    /// Takes the joint of each bone as it is given, shape `[Bone::COUNT]`, by `source`.
    ///
    /// # Errors
    /// [`RecordingError::NotHumanoid`].
    pub fn given(
        recording: &Recording,
        source: MapSource,
        joints: Vec<Option<usize>>,
    ) -> Result<Self, RecordingError> {
        let mut joints = joints;
        joints.resize(Bone::COUNT, None);
        for joint in &mut joints {
            *joint = joint.filter(|&joint| joint < recording.joints.len());
        }
        Self::checked(recording, source, joints)
    }

    fn checked(
        recording: &Recording,
        source: MapSource,
        joints: Vec<Option<usize>>,
    ) -> Result<Self, RecordingError> {
        let joint = |bone: Bone| joints[bone.index()];
        let missing = NEEDED.iter().filter(|&&bone| joint(bone).is_none());
        if missing.clone().next().is_some() {
            return Err(not_humanoid(missing));
        }
        let needed = |bone: Bone| joint(bone).unwrap_or_default();
        let mut joints_of_limbs = LIMBS.iter().flatten();
        let torn = joints_of_limbs.find(|&&[upper, lower]| {
            let mut above = recording.ancestors(needed(lower)).skip(1);
            !above.any(|above| above == needed(upper))
        });
        if let Some([_, lower]) = torn {
            return Err(not_humanoid(std::iter::once(lower)));
        }
        let hips = needed(Bone::Hips);
        let left: Vec<usize> = recording.ancestors(needed(Bone::LeftUpperArm)).collect();
        let chest = recording
            .ancestors(needed(Bone::RightUpperArm))
            .find(|joint| left.contains(joint))
            .ok_or_else(|| not_humanoid([Bone::LeftUpperArm].iter()))?;
        let way = |from: usize, to: usize| {
            let mut way: Vec<usize> = recording
                .ancestors(to)
                .take_while(|&joint| joint != from)
                .collect();
            way.reverse();
            way
        };
        let neck = match joint(Bone::Head) {
            Some(head) if recording.ancestors(head).any(|above| above == chest) => way(chest, head),
            _ => Vec::new(),
        };
        let spine = if recording.ancestors(chest).any(|above| above == hips) {
            way(hips, chest)
        } else {
            vec![chest]
        };
        Ok(Self {
            source,
            joints,
            spine,
            neck,
        })
    }

    /// The joint of a bone. Bones of trunk and neck have several joints or none between them: see
    /// [`Self::spine`].
    #[must_use]
    pub fn joint(&self, bone: Bone) -> Option<usize> {
        self.joints[bone.index()]
    }

    /// The joint of a bone without which nobody dances; 0 for others that are missing.
    pub(crate) fn needed(&self, bone: Bone) -> usize {
        self.joint(bone).unwrap_or_default()
    }

    /// Joints of the trunk from the one above the hips to the one on which the arms hang; empty
    /// where they hang on the hips.
    #[must_use]
    pub fn spine(&self) -> &[usize] {
        &self.spine
    }

    /// Joints from above the chest to the head; empty for a body without a head.
    #[must_use]
    pub fn neck(&self) -> &[usize] {
        &self.neck
    }

    /// The joint on which the arms hang.
    pub(crate) fn chest(&self) -> usize {
        let hips = self.needed(Bone::Hips);
        self.spine.last().copied().unwrap_or(hips)
    }

    /// Whether a joint is any bone.
    #[must_use]
    pub fn is_recognized(&self, joint: usize) -> bool {
        self.joints.contains(&Some(joint))
            || self.spine.contains(&joint)
            || self.neck.contains(&joint)
    }
}

/// Bones that hang on each other in every person.
const LIMBS: [[[Bone; 2]; 2]; 4] = [
    [
        [Bone::LeftUpperLeg, Bone::LeftLowerLeg],
        [Bone::LeftLowerLeg, Bone::LeftFoot],
    ],
    [
        [Bone::RightUpperLeg, Bone::RightLowerLeg],
        [Bone::RightLowerLeg, Bone::RightFoot],
    ],
    [
        [Bone::LeftUpperArm, Bone::LeftLowerArm],
        [Bone::LeftLowerArm, Bone::LeftHand],
    ],
    [
        [Bone::RightUpperArm, Bone::RightLowerArm],
        [Bone::RightLowerArm, Bone::RightHand],
    ],
];

fn not_humanoid<'a>(bones: impl Iterator<Item = &'a Bone>) -> RecordingError {
    let names: Vec<&str> = bones.map(|bone| bone.name()).collect();
    RecordingError::NotHumanoid {
        bones: names.join(", "),
    }
}

fn list_entry(recording: &Recording, text: &str) -> Result<(usize, Bone), Sentence> {
    let (joint_name, bone_name) = text.rsplit_once('=').ok_or_else(|| {
        Sentence::new(
            "「関節 = 骨」の形で書いてください（例: Thigh_L = leftUpperLeg）",
            "write `joint = bone`, such as `Thigh_L = leftUpperLeg`",
        )
    })?;
    let [joint_name, bone_name] = [joint_name, bone_name].map(str::trim);
    let mut joints = recording.joints.iter();
    let joint = joints.position(|joint| joint.name == joint_name);
    let joint = joint.filter(|_| !joint_name.is_empty()).ok_or_else(|| {
        Sentence::new(
            format!("記録に「{joint_name}」という関節はありません"),
            format!("the recording has no joint \"{joint_name}\""),
        )
    })?;
    let bone = Bone::ALL.iter().find(|bone| bone.name() == bone_name);
    let bone = bone.ok_or_else(|| {
        Sentence::new(
            format!("「{bone_name}」という骨はありません。leftUpperLeg のような VRM の名前です"),
            format!("there is no bone \"{bone_name}\"; bones have VRM names such as leftUpperLeg"),
        )
    })?;
    Ok((joint, *bone))
}
