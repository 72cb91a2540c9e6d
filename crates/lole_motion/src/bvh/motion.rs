//! The part of a BVH file that says what the joints do.

use glam::{DQuat, DVec3};
use lole_geom::trig64;

use super::hierarchy::Skeleton;
use super::lines::Lines;
use super::{Channel, MOST_NUMBERS};
use crate::{Recording, RecordingError};

/// Reads frames after the line `MOTION`.
pub(super) fn read(lines: &mut Lines<'_>, skeleton: Skeleton) -> Result<Recording, RecordingError> {
    let frame_count = frame_count(lines)?;
    let frame_seconds = frame_seconds(lines)?;
    let channel_count = skeleton.channel_count();
    // Each joint is stored, whether it moves or not.
    let numbers = frame_count.saturating_mul(channel_count.max(skeleton.joints.len()));
    if MOST_NUMBERS < numbers {
        return Err(RecordingError::TooLarge {
            what: "numbers",
            count: numbers,
            limit: MOST_NUMBERS,
        });
    }
    let numbers = read_numbers(lines, frame_count, channel_count)?;
    Ok(recording(skeleton, &numbers, frame_count, frame_seconds))
}

/// What stands after `label` and a colon.
fn labeled<'a>(lines: &mut Lines<'a>, label: &str) -> Result<&'a str, RecordingError> {
    let line = lines.expect(label)?;
    let value = line.split_once(':');
    let value = value.filter(|(name, _)| {
        let words: Vec<&str> = name.split_whitespace().collect();
        words.join(" ").eq_ignore_ascii_case(label)
    });
    value.map(|(_, value)| value.trim()).ok_or_else(|| {
        lines.error(
            format!("ここには「{label}: 」の行が要ります"),
            format!("a line \"{label}:\" should stand here"),
        )
    })
}

fn frame_count(lines: &mut Lines<'_>) -> Result<usize, RecordingError> {
    let text = labeled(lines, "Frames")?;
    text.parse().map_err(|_| {
        lines.error(
            "Frames には 0 以上の整数を書きます",
            "Frames takes a whole number from 0 upward",
        )
    })
}

fn frame_seconds(lines: &mut Lines<'_>) -> Result<f64, RecordingError> {
    let text = labeled(lines, "Frame Time")?;
    let seconds = lines.number(text)?;
    if (1.0e-4..=10.0).contains(&seconds) {
        Ok(seconds)
    } else {
        Err(lines.error(
            format!("Frame Time が {seconds} 秒です。0.0001 から 10 までにしてください"),
            format!("the Frame Time is {seconds} s; it should be from 0.0001 to 10"),
        ))
    }
}

/// All numbers of all frames. Lines are not minded: some programs break them.
fn read_numbers(
    lines: &mut Lines<'_>,
    frame_count: usize,
    channel_count: usize,
) -> Result<Vec<f64>, RecordingError> {
    let wanted = frame_count * channel_count;
    // The text may be shorter than it says: room is made as it is filled.
    let mut numbers = Vec::with_capacity(wanted.min(1 << 20));
    while let Some(line) = lines.next() {
        for word in line.split_whitespace() {
            if numbers.len() == wanted {
                return Err(lines.error(
                    format!("Frames: {frame_count} を超える数が続いています"),
                    format!("more numbers follow than the {frame_count} frames take"),
                ));
            }
            numbers.push(lines.number(word)?);
        }
    }
    if numbers.len() < wanted {
        let (whole, rest) = (numbers.len() / channel_count, numbers.len() % channel_count);
        return Err(lines.error(
            format!(
                "{frame_count} フレームのうち {whole} フレームと {rest} 個の数でファイルが終わっています（1フレームは {channel_count} 個）。書き出し直すか、Frames: {whole} に直してください"
            ),
            format!(
                "the file ends after {whole} of {frame_count} frames and {rest} numbers, and a frame has {channel_count}; write the file anew, or correct it to Frames: {whole}"
            ),
        ));
    }
    Ok(numbers)
}

fn recording(
    skeleton: Skeleton,
    numbers: &[f64],
    frame_count: usize,
    frame_seconds: f64,
) -> Recording {
    let channel_count = skeleton.channel_count();
    let joint_count = skeleton.joints.len();
    let bases = bases(&skeleton, numbers);
    let mut rotations = Vec::with_capacity(frame_count * joint_count);
    let mut translations = Vec::with_capacity(frame_count * joint_count);
    for frame in 0..frame_count {
        let mut values = numbers[frame * channel_count..(frame + 1) * channel_count].iter();
        for (channels, &base) in skeleton.channels.iter().zip(&bases) {
            let (mut position, mut turn) = (base, DQuat::IDENTITY);
            for (channel, &value) in channels.iter().zip(values.by_ref()) {
                match *channel {
                    Channel::Position(axis) => position[axis] += value,
                    Channel::Rotation(axis) => turn *= turn_about(axis, value.to_radians()),
                }
            }
            rotations.push(turn.as_quat().normalize());
            translations.push(position.as_vec3());
        }
    }
    Recording {
        joints: skeleton.joints,
        frame_seconds,
        rotations,
        translations,
    }
}

/// What the position channels of each joint are added to: its offset, or nothing on the axes whose
/// channels take the offset's place.
fn bases(skeleton: &Skeleton, numbers: &[f64]) -> Vec<DVec3> {
    let channel_count = skeleton.channel_count().max(1);
    let mut start = 0;
    let joints = skeleton.joints.iter().zip(&skeleton.channels);
    joints
        .map(|(joint, channels)| {
            let offset = joint.translation.as_dvec3();
            let mut moved = DVec3::ZERO;
            let mut mean = DVec3::ZERO;
            for (place, channel) in (start..).zip(channels) {
                if let Channel::Position(axis) = *channel {
                    moved[axis] = 1.0;
                    let column = numbers.iter().skip(place).step_by(channel_count);
                    let count = (numbers.len() / channel_count).max(1);
                    mean[axis] = column.sum::<f64>() / count as f64;
                }
            }
            start += channels.len();
            let replaced = (mean - offset * moved).length() < mean.length();
            if replaced {
                offset * (DVec3::ONE - moved)
            } else {
                offset
            }
        })
        .collect()
}

/// Rotation about an axis of space by `angle` [rad].
fn turn_about(axis: usize, angle: f64) -> DQuat {
    let (sin, cos) = trig64::sin_cos(0.5 * angle);
    let mut v = [0.0; 3];
    v[axis] = sin;
    DQuat::from_xyzw(v[0], v[1], v[2], cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_about_each_axis_moves_the_next_axis_to_the_one_after() {
        for axis in 0..3 {
            let quarter = turn_about(axis, std::f64::consts::FRAC_PI_2);
            let unit = |i: usize| DVec3::AXES[i % 3];
            assert!((quarter * unit(axis + 1) - unit(axis + 2)).length() < 1e-12);
        }
    }
}
