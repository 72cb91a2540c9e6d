//! What a recording holds, as people and programs read it.

use lole_body::Bone;
use lole_language::Sentence;
use serde::Serialize;

use crate::axes::{Unit, axis_name};
use crate::retarget::{facing, leg_length, rest};
use crate::{Axes, BoneMap, MapSource, Recording};

/// What a recording holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RecordingInspection {
    /// Kind of file.
    pub format: &'static str,
    /// Joints, without the ends of bones.
    pub joint_count: usize,
    /// Joints with position channels or more than three channels.
    pub six_channel_joint_count: usize,
    /// Frames, a leading stance for calibration among them.
    pub frame_count: usize,
    /// Frames a second.
    pub frames_per_second: f64,
    /// From the first frame to the last [s].
    pub duration_s: f64,
    /// Whether the first frame is a stance for calibration, which is not danced.
    pub begins_with_a_stance: bool,
    /// What is known of the dancer in it, if it is a person.
    pub person: Option<Person>,
    /// Why it cannot be danced, in both languages.
    pub refused: Option<[String; 2]>,
    /// Names of joints that are no bone of the dancer's.
    pub unrecognized: Vec<String>,
}

/// The person of a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Person {
    /// How the joints were recognized.
    pub recognized_by: String,
    /// Thigh and shank [file units].
    pub leg_length: f32,
    /// Likely unit of the file's numbers.
    pub unit: Option<&'static str>,
    /// One unit [m].
    pub meters_per_unit: Option<f32>,
    /// Axis that points up.
    pub up: &'static str,
    /// Nearest axis to where the dancer faces in the first frame.
    pub front: &'static str,
    /// VRM names of bones with the names of their joints.
    pub bones: Vec<(&'static str, String)>,
    /// VRM names of bones for which there is no joint of their own.
    pub missing: Vec<&'static str>,
}

impl RecordingInspection {
    /// Looks into a recording that was a file of kind `format`; `list` says which joint is which
    /// bone, as [`BoneMap::from_list`] takes it.
    #[must_use]
    pub fn new(format: &'static str, recording: &Recording, list: Option<&str>) -> Self {
        let map = match list {
            Some(list) => BoneMap::from_list(recording, list),
            None => BoneMap::recognize(recording),
        };
        let (person, refused) = match &map {
            Ok(map) => match person(recording, map) {
                Ok(person) => (Some(person), None),
                Err(error) => (None, Some(Sentence::of(&error))),
            },
            Err(error) => (None, Some(Sentence::of(error))),
        };
        let named = recording.joints.iter().enumerate();
        let named = named.filter(|(_, joint)| !joint.name.is_empty());
        let strange = named.clone().filter(|&(index, _)| {
            let known = map.as_ref().is_ok_and(|map| map.is_recognized(index));
            !known
        });
        let six = named.clone().filter(|(_, joint)| joint.channel_count > 3);
        Self {
            format,
            joint_count: named.clone().count(),
            six_channel_joint_count: six.count(),
            frame_count: recording.frame_count(),
            frames_per_second: 1.0 / recording.frame_seconds,
            duration_s: recording.duration(),
            begins_with_a_stance: recording.begins_with_a_stance(),
            person,
            refused: refused.map(|said| [said.japanese, said.english]),
            unrecognized: strange.map(|(_, joint)| joint.name.clone()).collect(),
        }
    }

    /// What the recording holds, as lines of text.
    #[must_use]
    pub fn lines(&self) -> Vec<Sentence> {
        let mut lines = vec![
            Sentence::new(
                format!(
                    "{}: 関節 {} 個（うち6チャンネル {} 個）",
                    self.format, self.joint_count, self.six_channel_joint_count
                ),
                format!(
                    "{}: {} joints, {} of them with six channels",
                    self.format, self.joint_count, self.six_channel_joint_count
                ),
            ),
            Sentence::new(
                format!(
                    "{} フレーム、毎秒 {:.3}、長さ {:.2} 秒",
                    self.frame_count, self.frames_per_second, self.duration_s
                ),
                format!(
                    "{} frames, {:.3} a second, {:.2} s long",
                    self.frame_count, self.frames_per_second, self.duration_s
                ),
            ),
        ];
        if self.begins_with_a_stance {
            lines.push(Sentence::new(
                "最初のフレームは較正の姿勢で、踊りには入りません",
                "the first frame is a stance for calibration and is not danced",
            ));
        }
        if let Some(person) = &self.person {
            lines.extend(person.lines());
        }
        if let Some([japanese, english]) = &self.refused {
            lines.push(Sentence::new(
                format!("踊れません: {japanese}"),
                format!("cannot be danced: {english}"),
            ));
        }
        if !self.unrecognized.is_empty() {
            let names = self.unrecognized.join(", ");
            lines.push(Sentence::new(
                format!("骨にあたらない関節: {names}"),
                format!("joints that are no bone: {names}"),
            ));
        }
        lines
    }
}

impl Person {
    fn lines(&self) -> Vec<Sentence> {
        let unit = match (self.unit, self.meters_per_unit) {
            (Some(name), Some(meters)) => {
                let leg = 100.0 * self.leg_length * meters;
                Sentence::new(
                    format!(
                        "脚の長さ {:.3}、単位はおそらく {name}（脚 {leg:.0} cm）",
                        self.leg_length
                    ),
                    format!(
                        "legs of {:.3}, likely in {name} (a leg of {leg:.0} cm)",
                        self.leg_length
                    ),
                )
            }
            _ => Sentence::new(
                format!("脚の長さ {:.3}、単位は分かりません", self.leg_length),
                format!("legs of {:.3} in no known unit", self.leg_length),
            ),
        };
        let bones: Vec<String> = (self.bones.iter())
            .map(|(bone, joint)| format!("{bone} = {joint}"))
            .collect();
        let mut lines = vec![
            unit,
            Sentence::new(
                format!("上は {}、最初に向いているのは {}", self.up, self.front),
                format!("up is {}, and she faces {} at first", self.up, self.front),
            ),
            Sentence::new(
                format!("関節の見分け方: {}", self.recognized_by),
                format!("joints recognized by: {}", self.recognized_by),
            ),
            Sentence::new(
                format!("骨と関節: {}", bones.join(", ")),
                format!("bones and joints: {}", bones.join(", ")),
            ),
        ];
        if !self.missing.is_empty() {
            let names = self.missing.join(", ");
            lines.push(Sentence::new(
                format!("関節のない骨（親とともに動きます）: {names}"),
                format!("bones without a joint, which go with the one they hang on: {names}"),
            ));
        }
        lines
    }
}

fn person(recording: &Recording, map: &BoneMap) -> Result<Person, crate::RecordingError> {
    let (rest, first) = rest(recording);
    let leg_length = leg_length(map, &rest)?;
    let unit = Unit::of_leg(leg_length);
    let axes = if recording.frame_count() == 0 {
        Axes::of(map, &rest)
    } else {
        facing(recording, map, first)
    };
    // Trunk and neck are chains of any number of joints, shared among the bones there.
    let chained = [Bone::Spine, Bone::Chest, Bone::UpperChest, Bone::Neck];
    let own = Bone::ALL.iter().filter(|bone| !chained.contains(bone));
    let name = |joint: usize| recording.joints[joint].name.clone();
    let chain = |joints: &[usize]| {
        joints
            .iter()
            .map(|&j| name(j))
            .collect::<Vec<_>>()
            .join(" – ")
    };
    let mut bones: Vec<(&'static str, String)> = own
        .clone()
        .filter_map(|&bone| Some((bone.name(), name(map.joint(bone)?))))
        .collect();
    bones.insert(1, ("spine", chain(map.spine())));
    bones.insert(2, ("neck", chain(map.neck())));
    Ok(Person {
        recognized_by: match map.source {
            MapSource::Names(program) => program.to_owned(),
            MapSource::Hierarchy => "hierarchy".to_owned(),
            MapSource::List => "list".to_owned(),
            MapSource::File(kind) => kind.to_owned(),
        },
        leg_length,
        unit: unit.map(|unit| unit.name),
        meters_per_unit: unit.map(|unit| unit.meters),
        up: axis_name(axes.up),
        front: axis_name(axes.front),
        bones,
        missing: own
            .filter(|&&bone| map.joint(bone).is_none())
            .map(|bone| bone.name())
            .collect(),
    })
}
