//! BVH recordings of a person's joints, now and then of something else.

use std::fmt::Write as _;

use arbitrary::Unstructured;

use crate::{between, choose, count, once_in};

/// Name and parent of each joint of a body that is right, in the order of a file.
const JOINTS: [(&str, Option<usize>); 19] = [
    ("Hips", None),
    ("Spine", Some(0)),
    ("Spine1", Some(1)),
    ("Neck", Some(2)),
    ("Head", Some(3)),
    ("LeftShoulder", Some(2)),
    ("LeftArm", Some(5)),
    ("LeftForeArm", Some(6)),
    ("LeftHand", Some(7)),
    ("RightShoulder", Some(2)),
    ("RightArm", Some(9)),
    ("RightForeArm", Some(10)),
    ("RightHand", Some(11)),
    ("LeftUpLeg", Some(0)),
    ("LeftLeg", Some(13)),
    ("LeftFoot", Some(14)),
    ("RightUpLeg", Some(0)),
    ("RightLeg", Some(16)),
    ("RightFoot", Some(17)),
];
/// What a joint is now and then called instead.
const NAMES: [&str; 6] = ["Hips", "mixamorig:Hips", "joint 1", "", "腰", "End"];
/// Channels, the right orders first.
const CHANNELS: [&str; 6] = [
    "3 Zrotation Xrotation Yrotation",
    "3 Xrotation Yrotation Zrotation",
    "6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
    "1 Yrotation",
    "0",
    "7 Xposition Xposition Zrotation Zrotation Zrotation Yrotation Wrotation",
];
/// Numbers that are none, or far away.
const NUMBERS: [&str; 7] = ["nan", "inf", "-1e39", "1e300", "0x10", "1e-320", "١"];

/// A file.
pub fn text(bytes: &mut Unstructured<'_>) -> String {
    let mut text = "HIERARCHY\n".to_owned();
    let mut channel_count = 0;
    let mut open: Vec<usize> = Vec::new();
    for (place, (name, parent)) in JOINTS.iter().enumerate() {
        if once_in(bytes, 30) {
            continue;
        }
        while open.last().is_some_and(|last| Some(*last) != *parent) {
            close(&mut text, &mut open);
        }
        let kind = if place == 0 { "ROOT" } else { "JOINT" };
        let name = if once_in(bytes, 30) {
            *choose(bytes, &NAMES)
        } else {
            name
        };
        let _ = writeln!(
            text,
            "{kind} {name}\n{{\nOFFSET {}",
            numbers(bytes, 3, 30.0)
        );
        let channels = match place {
            0 => CHANNELS[2],
            _ if once_in(bytes, 12) => *choose(bytes, &CHANNELS),
            _ => CHANNELS[0],
        };
        channel_count += channels
            .split(' ')
            .next()
            .and_then(|it| it.parse::<u32>().ok())
            .unwrap_or(0);
        let _ = writeln!(text, "CHANNELS {channels}");
        open.push(place);
        let has_child = JOINTS.iter().any(|(_, parent)| *parent == Some(place));
        if !has_child || once_in(bytes, 30) {
            let _ = writeln!(text, "End Site\n{{\nOFFSET {}\n}}", numbers(bytes, 3, 10.0));
        }
    }
    let left_open = if once_in(bytes, 40) { 1 } else { 0 };
    while left_open < open.len() {
        close(&mut text, &mut open);
    }
    let frames = count(bytes, 6);
    let said = if once_in(bytes, 20) {
        count(bytes, u32::MAX)
    } else {
        frames
    };
    let time = if once_in(bytes, 12) {
        numbers(bytes, 1, 1.0)
    } else {
        "0.0333333".to_owned()
    };
    let _ = writeln!(text, "MOTION\nFrames: {said}\nFrame Time: {time}");
    for _ in 0..frames {
        let more = if once_in(bytes, 40) {
            count(bytes, 2)
        } else {
            0
        };
        let _ = writeln!(text, "{}", numbers(bytes, channel_count + more, 120.0));
    }
    text
}

fn close(text: &mut String, open: &mut Vec<usize>) {
    text.push_str("}\n");
    open.pop();
}

/// So many numbers on a line.
fn numbers(bytes: &mut Unstructured<'_>, how_many: u32, most: f64) -> String {
    let number = |bytes: &mut Unstructured<'_>| {
        if once_in(bytes, 60) {
            (*choose(bytes, &NUMBERS)).to_owned()
        } else {
            format!("{:.3}", between(bytes, -most, most))
        }
    };
    let numbers: Vec<String> = (0..how_many.min(400)).map(|_| number(bytes)).collect();
    numbers.join(" ")
}
