//! Hip angles of the dance beside those that radiographs of a dancer showed.

use std::io;

use glam::{Quat, Vec3};
use lole_body::{Bone, Dancer};
use lole_geom::trig;
use lole_hula::{Dance, DanceStep, MotionSettings};

use crate::line;

/// Flexion, adduction and external rotation of the hip [°] in Komiyama et al. 2018.
const MEASURED: [(DanceStep, [f32; 3]); 2] = [
    (DanceStep::Kao, [31.0, 15.0, 11.0]),
    (DanceStep::Kaholo, [17.0, 11.0, 11.0]),
];

const HEAD: &str = "
## Hip angles beside radiographs

One dancer of 73 years with a replaced hip was filmed by X-ray [20].
Adduction is held to within 3° by a test.
Flexion and rotation are only reported: the radiographs count the tilt of her pelvis and the turn of her thigh in the plane of the detector, which is not published, and the poses follow knees over toes instead.
The angles are those of the left hip at its largest adduction.

| step | | flexion | adduction | external rotation |
|---|---|---|---|---|
";

pub(crate) fn describe(page: &mut String, dancer: &Dancer) -> io::Result<()> {
    page.push_str(HEAD);
    for (dance_step, measured) in MEASURED {
        let settings = MotionSettings {
            dance_step,
            ..MotionSettings::default()
        };
        let dance = Dance::new(&dancer.skeleton, &settings).map_err(io::Error::other)?;
        let angles = (0..400_u16)
            .map(|i| dance.lead_in() + dance.period() * f32::from(i) / 400.0)
            .map(|time| hip_angles(dancer, &dance, time))
            .reduce(|best, angles| if best[1] < angles[1] { angles } else { best })
            .unwrap_or_default();
        let name = dance_step.name();
        for (said, [flexion, adduction, rotation]) in [("measured", measured), ("danced", angles)] {
            line(
                page,
                format_args!(
                    "| {name} | {said} | {flexion:.0}° | {adduction:.0}° | {rotation:.0}° |"
                ),
            );
        }
    }
    Ok(())
}

/// Flexion, adduction and external rotation of the left hip [°] in the pelvis.
fn hip_angles(dancer: &Dancer, dance: &Dance, time: f32) -> [f32; 3] {
    let pose = dance.pose_at(time);
    let joint = |bone| dancer.skeleton.joint(bone);
    let along = (joint(Bone::LeftLowerLeg) - joint(Bone::LeftUpperLeg)).normalize_or(Vec3::NEG_Y);
    let turn = pose.rotation(Bone::LeftUpperLeg);
    let thigh = turn * along;
    let flexion = trig::atan2(thigh.z, -thigh.y).to_degrees();
    let adduction = trig::atan2(-thigh.x, -thigh.y).to_degrees();
    // What is left of the turn after the thigh has swung to where it points.
    let twist = Quat::from_rotation_arc(along, thigh).inverse() * turn;
    let up = -along;
    let about = 2.0 * trig::atan2(Vec3::new(twist.x, twist.y, twist.z).dot(up), twist.w);
    let degrees = about.to_degrees();
    let rotation = degrees - 360.0 * (degrees / 360.0).round();
    [flexion, adduction, rotation]
}
