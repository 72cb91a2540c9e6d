//! Animations of a file as recordings: sampled sixty times a second, as the product counts frames.

use glam::{Quat, Vec3, Vec4};
use gltf_json::Index;
use gltf_json::accessor::Accessor;
use gltf_json::animation::{Channel, Interpolation, Property};
use gltf_json::validation::Checked;
use lole_language::words;
use lole_motion::{JointPlace, Recording};
use serde::Serialize;

use crate::AvatarError;
use crate::container::{File, visible};
use crate::rig::{Rig, within};
use crate::tree::{Local, place, turn_of};

/// Frames of a recording per second.
const RATE: f64 = 60.0;
/// Longest animation that is read [s].
const LONGEST: f32 = 3600.0;
/// Joints times frames at most.
const MOST_PLACES: usize = 1 << 23;

/// One animation of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimationSummary {
    /// Its name; empty where it has none.
    pub name: String,
    /// From its first key to its last [s].
    pub duration_s: f32,
    /// Keys of the track that has most.
    pub key_count: usize,
    /// Bones of the dancer that it moves.
    pub bone_count: usize,
}

/// What moves one property of a node.
struct Track {
    node: usize,
    property: Property,
    interpolation: Interpolation,
    /// Ascending [s].
    times: Vec<f32>,
    /// A value for each time; three where they are cubic: tangent in, value, tangent out.
    values: Vec<Vec4>,
}

/// What a file's animations are.
pub(crate) fn summaries(file: &File<'_>, rig: &Rig) -> Result<Vec<AnimationSummary>, AvatarError> {
    let animations = 0..file.root.animations.len();
    animations
        .map(|index| {
            let tracks = tracks(file, index)?;
            let span = span(&tracks);
            let mut moved: Vec<usize> = tracks
                .iter()
                .filter_map(|track| rig.joints[track.node])
                .filter(|&joint| rig.map.is_recognized(joint))
                .collect();
            moved.sort_unstable();
            moved.dedup();
            let name = file.root.animations[index].name.as_deref();
            Ok(AnimationSummary {
                name: visible(name.unwrap_or("")),
                duration_s: span.map_or(0.0, |[first, last]| last - first),
                key_count: tracks
                    .iter()
                    .map(|track| track.times.len())
                    .max()
                    .unwrap_or(0),
                bone_count: moved.len(),
            })
        })
        .collect()
}

impl AnimationSummary {
    /// Whether it can be danced: it moves bones, and is more than one pose.
    #[must_use]
    pub const fn is_dance(&self) -> bool {
        0 < self.bone_count && 1 < self.key_count
    }
}

/// Animations that a sentence names at most.
const MOST_NAMED: usize = 12;

/// Number of the animation that is asked for: by its name, by its number, counted from 1, or, where
/// nothing is said, the first that moves bones.
fn chosen(found: &[AnimationSummary], clip: &str) -> Result<usize, AvatarError> {
    let moving: Vec<(usize, &str)> = (found.iter().enumerate())
        .filter(|(_, animation)| animation.is_dance())
        .map(|(index, animation)| (index, animation.name.as_str()))
        .collect();
    let first = moving.first().ok_or(AvatarError::NoAnimation)?.0;
    if clip.is_empty() {
        return Ok(first);
    }
    let named = moving.iter().find(|(_, name)| *name == clip);
    let number = clip.parse::<usize>().ok();
    let numbered = || (moving.iter()).find(|(index, _)| number == index.checked_add(1));
    named
        .or_else(numbered)
        .map(|&(index, _)| index)
        .ok_or_else(|| AvatarError::UnknownClip {
            clip: visible(clip),
            known: (moving.iter().take(MOST_NAMED))
                .map(|(index, name)| format!("{} \"{name}\"", index + 1))
                .collect::<Vec<_>>()
                .join(", "),
        })
}

/// One animation as a recording: see [`chosen`].
///
/// # Errors
/// None that moves bones; one that is not there, is damaged or too long.
pub(crate) fn recording(file: &File<'_>, rig: &Rig, clip: &str) -> Result<Recording, AvatarError> {
    let tracks = tracks(file, chosen(&summaries(file, rig)?, clip)?)?;
    let [first, last] = span(&tracks).ok_or(AvatarError::NoAnimation)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an hour has 216,000 frames"
    )]
    let frame_count = 1 + (f64::from(last - first) * RATE).round() as usize;
    if MOST_PLACES / rig.nodes.len().max(1) < frame_count {
        return Err(AvatarError::TooLarge {
            what: words("フレーム", "frames"),
            count: frame_count as u64,
            limit: (MOST_PLACES / rig.nodes.len().max(1)) as u64,
        });
    }
    let mut recording = rig.rest.clone();
    recording.frame_seconds = 1.0 / RATE;
    let mut locals = rig.locals.clone();
    for frame in 0..frame_count {
        #[expect(clippy::cast_possible_truncation, reason = "seconds of a dance")]
        let time = first + (frame as f64 / RATE) as f32;
        for track in &tracks {
            track.apply(time.min(last), &mut locals[track.node]);
        }
        let worlds = rig.tree.worlds(&locals);
        let places: Vec<JointPlace> = rig.nodes.iter().map(|&node| place(&worlds[node])).collect();
        for (joint, at) in recording.joints.iter().zip(&places) {
            let (translation, rotation) = within(joint.parent.map(|parent| places[parent]), *at);
            recording.translations.push(translation);
            recording.rotations.push(rotation);
        }
    }
    let finite = recording.translations.iter().all(|place| place.is_finite())
        && recording.rotations.iter().all(|turn| turn.is_finite());
    finite.then_some(recording).ok_or_else(|| {
        AvatarError::part(
            "animations",
            "動きが有限の数になりません",
            "its motion leaves the finite numbers",
        )
    })
}

/// Tracks of an animation that move nodes.
fn tracks(file: &File<'_>, index: usize) -> Result<Vec<Track>, AvatarError> {
    let animation = &file.root.animations[index];
    let mut tracks = Vec::new();
    for (place, channel) in animation.channels.iter().enumerate() {
        let place = format!("animations[{index}].channels[{place}]");
        if let Some(track) = track(file, &animation.samplers, channel, &place)? {
            tracks.push(track);
        }
    }
    Ok(tracks)
}

fn track(
    file: &File<'_>,
    samplers: &[gltf_json::animation::Sampler],
    channel: &Channel,
    place: &str,
) -> Result<Option<Track>, AvatarError> {
    let wrong = |japanese: &str, english: &str| AvatarError::part(place, japanese, english);
    let property = match &channel.target.path {
        Checked::Valid(Property::MorphTargetWeights) | Checked::Invalid => return Ok(None),
        Checked::Valid(property) => *property,
    };
    let node = channel.target.node.value();
    if file.root.nodes.len() <= node {
        return Err(wrong(
            "動かすノードがありません",
            "the node that it moves is not there",
        ));
    }
    let sampler = samplers
        .get(channel.sampler.value())
        .ok_or_else(|| wrong("sampler がありません", "its sampler is not there"))?;
    let Checked::Valid(interpolation) = &sampler.interpolation else {
        return Err(wrong(
            "補間の種類が不明です",
            "its interpolation is unknown",
        ));
    };
    let times: Vec<f32> = file.floats::<1>(sampler.input)?.concat();
    if !times.is_sorted() || times.iter().any(|time| !(0.0..=LONGEST).contains(time)) {
        return Err(wrong(
            "キーの時刻が順に並んでいないか、1 時間を超えています",
            "its key times do not ascend or go beyond an hour",
        ));
    }
    let values = key_values(file, sampler.output, property)?;
    let each = if *interpolation == Interpolation::CubicSpline {
        3
    } else {
        1
    };
    if values.len() < times.len() * each {
        return Err(wrong(
            "キーより値が少なくなっています",
            "it has fewer values than keys",
        ));
    }
    Ok((!times.is_empty()).then_some(Track {
        node,
        property,
        interpolation: *interpolation,
        times,
        values,
    }))
}

/// The values of all keys: rotations as they are, all else with 0 as the fourth number.
fn key_values(
    file: &File<'_>,
    output: Index<Accessor>,
    property: Property,
) -> Result<Vec<Vec4>, AvatarError> {
    Ok(if property == Property::Rotation {
        let values = file.floats::<4>(output)?;
        values.into_iter().map(Vec4::from_array).collect()
    } else {
        let values = file.floats::<3>(output)?;
        let values = values.into_iter();
        values
            .map(|value| Vec3::from_array(value).extend(0.0))
            .collect()
    })
}

/// First and last key of all tracks [s].
fn span(tracks: &[Track]) -> Option<[f32; 2]> {
    let first = tracks.iter().filter_map(|track| track.times.first());
    let last = tracks.iter().filter_map(|track| track.times.last());
    Some([
        first.copied().reduce(f32::min)?,
        last.copied().reduce(f32::max)?,
    ])
}

impl Track {
    fn apply(&self, time: f32, local: &mut Local) {
        let value = self.value(time);
        match self.property {
            Property::Translation => local.translation = value.truncate(),
            Property::Scale => local.scale = value.truncate(),
            Property::Rotation => local.rotation = turn_of(value.to_array()),
            Property::MorphTargetWeights => {}
        }
    }

    /// Value at a time; before the first key the first, after the last the last.
    fn value(&self, time: f32) -> Vec4 {
        let next = self.times.partition_point(|&key| key <= time);
        let last = self.times.len() - 1;
        if next == 0 || last < next || self.interpolation == Interpolation::Step {
            return self.key(next.saturating_sub(1).min(last));
        }
        let (a, b) = (next - 1, next);
        let length = self.times[b] - self.times[a];
        let share = (time - self.times[a]) / length.max(f32::MIN_POSITIVE);
        match (self.interpolation, self.property) {
            (Interpolation::CubicSpline, _) => self.cubic(a, b, share, length),
            (_, Property::Rotation) => {
                let [from, to]: [Quat; 2] = [a, b].map(|key| turn_of(self.key(key).to_array()));
                Vec4::from(from.slerp(to, share))
            }
            _ => self.key(a).lerp(self.key(b), share),
        }
    }

    fn key(&self, key: usize) -> Vec4 {
        match self.interpolation {
            Interpolation::CubicSpline => self.values[3 * key + 1],
            Interpolation::Linear | Interpolation::Step => self.values[key],
        }
    }

    /// Hermite's curve between two keys, as the glTF specification's appendix C has it.
    fn cubic(&self, a: usize, b: usize, t: f32, length: f32) -> Vec4 {
        let (out, into) = (self.values[3 * a + 2], self.values[3 * b]);
        let (t2, t3) = (t * t, t * t * t);
        self.key(a) * (2.0 * t3 - 3.0 * t2 + 1.0)
            + out * (length * (t3 - 2.0 * t2 + t))
            + self.key(b) * (3.0 * t2 - 2.0 * t3)
            + into * (length * (t3 - t2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(interpolation: Interpolation, values: &[f32]) -> Track {
        Track {
            node: 0,
            property: Property::Translation,
            interpolation,
            times: vec![1.0, 3.0],
            values: values
                .iter()
                .map(|&x| Vec4::new(x, 0.0, 0.0, 0.0))
                .collect(),
        }
    }

    #[test]
    fn keys_are_met_and_held_beyond_the_ends() {
        let linear = track(Interpolation::Linear, &[2.0, 6.0]);
        let step = track(Interpolation::Step, &[2.0, 6.0]);
        for (time, on_line, on_step) in [
            (0.0, 2.0, 2.0),
            (1.0, 2.0, 2.0),
            (2.0, 4.0, 2.0),
            (3.0, 6.0, 6.0),
            (9.0, 6.0, 6.0),
        ] {
            assert_eq!(linear.value(time).x, on_line, "{time}");
            assert_eq!(step.value(time).x, on_step, "{time}");
        }
    }

    #[test]
    fn a_cubic_track_follows_a_cubic() {
        // x = t³ from 1 to 3: tangents 3 and 27.
        let cubic = track(
            Interpolation::CubicSpline,
            &[0.0, 1.0, 3.0, 27.0, 27.0, 0.0],
        );
        for time in [1.0_f32, 1.5, 2.0, 2.5, 3.0] {
            assert!(
                (cubic.value(time).x - time * time * time).abs() < 1e-5,
                "{time}"
            );
        }
    }

    #[test]
    fn an_animation_is_chosen_by_name_or_number() {
        let animation = |name: &str, bone_count| AnimationSummary {
            name: name.to_owned(),
            duration_s: 1.0,
            key_count: 2,
            bone_count,
        };
        let found = [
            animation("Blink", 0),
            animation("Wave", 9),
            animation("3", 9),
        ];
        let mut found = found.to_vec();
        found.push(animation("Hula", 9));
        for (clip, expected) in [
            ("", 1),
            ("Wave", 1),
            ("2", 1),
            ("3", 2),
            ("4", 3),
            ("Hula", 3),
        ] {
            assert_eq!(chosen(&found, clip), Ok(expected), "{clip}");
        }
        // The first moves no bone.
        for clip in ["Blink", "1", "0", "5", "hula"] {
            let said = chosen(&found, clip).map_err(|error| error.to_string());
            let expected = format!(
                "the file has no animation \"{clip}\"; it has 2 \"Wave\", 3 \"3\", 4 \"Hula\": write \
                 a name or a number"
            );
            assert_eq!(said, Err(expected));
        }
        assert_eq!(chosen(&found[..1], ""), Err(AvatarError::NoAnimation));
    }
}
