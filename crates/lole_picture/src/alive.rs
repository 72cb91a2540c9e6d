//! What her face does: eyes that blink, and that look at the hand which tells the story.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer, Expression};
use lole_costume::document::Gaze;
use lole_geom::fnv;
use lole_stage::Performance;

/// One blink in every so many seconds, on the mean; people blink every three to five.
const BLINK_EVERY: f32 = 3.9;
/// How much later than that one may come [s].
const BLINK_LATER: f32 = 2.2;
/// How long the lids take to close, stay closed, and take to open [s].
const CLOSING: f32 = 0.08;
const CLOSED: f32 = 0.03;
const OPENING: f32 = 0.16;

/// How long before a hand arrives the eyes look there [s]: they lead the hand by some tenths of a second (Land and
/// Hayhoe 2001, "In what ways do eye movements contribute to everyday activities?").
pub const EYES_LEAD: f32 = 0.2;

/// What the face of a dancer does in the present frame, who blinks by a clock that is so much fast [s].
#[must_use]
pub fn expression(performance: &Performance, fast: f32) -> Expression {
    let production = performance.production();
    let now = (production.design.stage.gaze, performance.time() + fast);
    let soon = performance.bones_after(EYES_LEAD);
    let bones = [performance.world_from_bind(), &soon];
    expression_at(&production.dancer, now, bones)
}

/// What the face of a dancer does at a time of the dance [s], with the bones then and [`EYES_LEAD`] later.
#[must_use]
pub fn expression_at(
    dancer: &Dancer,
    (gaze, time): (Gaze, f32),
    bones: [&[Affine3A]; 2],
) -> Expression {
    Expression {
        closed: blink(time),
        looks_at: match gaze {
            Gaze::Hands => leading_hand(dancer, bones),
            Gaze::Ahead => None,
        },
    }
}

/// How far the eyes are closed at a time [s]: the same at the same time.
#[expect(
    clippy::cast_possible_truncation,
    reason = "seconds of a dance, and bits of a hash"
)]
pub(crate) fn blink(time: f32) -> f32 {
    let turn = (time / BLINK_EVERY).floor();
    // Each comes at its own time after its turn, and is over before the next one's.
    let hash = fnv::hash((turn as i64).to_le_bytes());
    let late = (hash >> 40) as f32 / (1_u32 << 24) as f32;
    shut(time - (turn * BLINK_EVERY + BLINK_LATER * late))
}

/// How far the eyes are closed so long after a blink began [s].
fn shut(after: f32) -> f32 {
    let ease = |share: f32| {
        let share = share.clamp(0.0, 1.0);
        share * share * (3.0 - 2.0 * share)
    };
    ease(after / CLOSING).min(ease(1.0 - (after - CLOSING - CLOSED) / OPENING))
}

/// Where the hand will soon be that then reaches farther up and out; both where they reach as far. None where both
/// hang down.
fn leading_hand(dancer: &Dancer, [now, soon]: [&[Affine3A]; 2]) -> Option<Vec3> {
    let skeleton = &dancer.skeleton;
    let joint = |bone: Bone| soon[bone.index()].transform_point3(skeleton.joint(bone));
    let [hips, chest] = [Bone::Hips, Bone::UpperChest].map(joint);
    // Only a drawn body has eyes that turn.
    let eyes = dancer.drawn_body.as_ref()?.between_eyes();
    let head = now[Bone::Head.index()].transform_point3(eyes);
    let ahead = now[Bone::Head.index()].transform_vector3(Vec3::Z);
    let size = (chest.y - hips.y).max(0.05);
    let (mut sum, mut total) = (Vec3::ZERO, 0.0);
    for bone in [Bone::LeftMiddleProximal, Bone::RightMiddleProximal] {
        let hand = joint(bone);
        let up = ((hand.y - hips.y) / size).clamp(0.0, 2.0);
        let out = Vec3::new(hand.x - chest.x, 0.0, hand.z - chest.z).length() / size;
        let reach = up * (0.4 + out);
        let weight = reach * reach * reach * reach;
        sum += hand * weight;
        total += weight;
    }
    // As the hands rise, the eyes go from ahead to them.
    const RISEN: f32 = 0.12;
    let risen = total / (total + RISEN);
    let far = head + ahead * (3.0 * size);
    (0.0 < total).then(|| far.lerp(sum / total, risen))
}

#[cfg(test)]
mod tests {
    use lole_body::{Appearance, Measurements, Pose};

    use super::*;

    /// She looks to the side to which a hand is about to rise, while both still hang down.
    #[test]
    fn eyes_are_there_before_the_hand() {
        let woman = Measurements::woman();
        let dancer = Dancer::with_appearance(&woman, &Appearance::default()).unwrap();
        let bones = |raised: Option<Bone>| {
            let mut pose = Pose::default();
            if let Some(arm) = raised {
                let side = if arm == Bone::LeftUpperArm { 1.0 } else { -1.0 };
                pose.rotate(arm, glam::Quat::from_rotation_z(1.2 * side));
            }
            dancer.skeleton.world_from_bind(&pose)
        };
        let now = bones(None);
        for (arm, side) in [(Bone::LeftUpperArm, 1.0), (Bone::RightUpperArm, -1.0)] {
            let soon = bones(Some(arm));
            let seen = expression_at(&dancer, (Gaze::Hands, 0.0), [&now, &soon])
                .looks_at
                .unwrap();
            assert!(0.15 < seen.x * side, "{arm:?}: {seen}");
            let ahead = expression_at(&dancer, (Gaze::Ahead, 0.0), [&now, &soon]).looks_at;
            assert_eq!(ahead, None);
        }
    }

    #[test]
    fn eyes_are_open_nearly_always_and_close_again_and_again() {
        let frames = 60 * 60;
        let closed = (0..frames).map(|frame| blink(frame as f32 / 60.0));
        let closed: Vec<f32> = closed.collect();
        assert!(closed.iter().all(|share| (0.0..=1.0).contains(share)));
        let open = closed.iter().filter(|share| **share == 0.0).count();
        assert!(open * 10 > frames * 8, "{open} of {frames} frames");
        let blinks = closed
            .windows(2)
            .filter(|pair| pair[0] < 0.9 && 0.9 <= pair[1]);
        assert!((10..=22).contains(&blinks.count()));
        // No lid jumps: it takes more than a picture of a film.
        assert!(
            closed
                .windows(2)
                .all(|pair| (pair[1] - pair[0]).abs() < 0.35)
        );
    }
}
