//! Where a body left its cloth no room: told, because there the skin gave way and not the cloth. What had no
//! room when a frame began and lies outside of the skin when it ends is not worth a word.

use glam::Vec3;
use lole_body::Bone;
use lole_geom::Surfel;
use lole_language::{Sentence, Words, words};

/// Cloth that was held back farther than this from all skin [m] was pressed by other cloth.
const NEAR: f32 = 0.06;
/// Cloth less deep in the skin than this [m] has found room after all.
const SUNK: f32 = 0.5e-3;
/// Cloth that was held back which is looked at in a frame, at most.
const LOOKED_AT: usize = 32;
/// A part of the body counts that has at least one in so many of those beside it.
const LEAST_SHARE: usize = 5;
/// Shorter times [s] are not worth a word.
const LEAST: f32 = 0.1;
/// Times nearer together than this [s] are one.
const PAUSE: f32 = 0.5;

/// A time in which cloth had no room beside a part of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoRoom {
    /// Which part: the first bone of it.
    pub part: Bone,
    /// From when to when [s].
    pub time: [f32; 2],
}

impl NoRoom {
    /// Whether it is worth a word.
    pub(super) fn is_long(&self) -> bool {
        LEAST <= self.time[1] - self.time[0]
    }

    /// The same in words.
    #[must_use]
    pub fn sentence(&self) -> Sentence {
        let [from, to] = self.time;
        let part = part_words(self.part);
        Sentence::new(
            format!(
                "{from:.1}〜{to:.1} 秒: {}のところで布の居場所がなく、布の代わりに肌のほうをよけさせました",
                part.japanese
            ),
            format!(
                "{from:.1} to {to:.1} s: no room for the cloth at {}; there the skin gives way, not the cloth",
                part.english
            ),
        )
    }
}

/// Beside which parts of the body cloth has no room now, in one sentence; `None` where there is room.
#[must_use]
pub fn no_room_now(parts: &[Bone]) -> Option<Sentence> {
    let words = || parts.iter().map(|&part| part_words(part));
    let [japanese, english] = [
        words().map(|it| it.japanese).collect::<Vec<_>>().join("と"),
        words()
            .map(|it| it.english)
            .collect::<Vec<_>>()
            .join(" and "),
    ];
    (!parts.is_empty()).then(|| {
        Sentence::new(
            format!("{japanese}のところで布の居場所がなく、肌のほうがよけています"),
            format!("no room for the cloth at {english}: the skin gives way"),
        )
    })
}

impl super::Performance {
    /// Writes down where the dance left cloth no room.
    pub(super) fn note_no_room(&mut self) {
        if self.frame <= 0 {
            return;
        }
        let gathered = self.worn.iter().zip(&self.production.garments);
        let gathered = gathered.map(|(worn, garment)| {
            let positions = &self.cloth_positions[garment.particles.clone()];
            let held = worn.solver.without_room();
            held.iter().map(|&it| positions[it as usize]).collect()
        });
        let dressed = self.dressed.iter().zip(&self.production.dressed);
        let dressed = dressed.map(|(moving, garment)| moving.without_room(garment));
        let (skin, surfels) = (&self.production.dancer.skin, &self.production.body_surfels);
        let bone_of = |surfel: usize| skin.strongest_bone(surfels.carrier(surfel) as usize);
        let time = self.frame as f32 * super::FRAME_SECONDS;
        for (held, met) in (gathered.map(|held: Vec<Vec3>| (held, &self.surfels)))
            .chain(dressed.map(|held| (held, &self.whole_skin)))
        {
            if !held.is_empty() && !met.is_empty() {
                note(&mut self.no_room, time, &held, (met, &bone_of));
            }
        }
    }

    /// When, and beside what, the dance left cloth no room, so far: what passed in a few frames is
    /// not worth a word.
    pub fn no_room(&self) -> impl Iterator<Item = &NoRoom> {
        self.no_room.iter().filter(|it| it.is_long())
    }

    /// Parts of the body beside which the dance leaves cloth no room now, or did a moment ago: what lasts
    /// for a few frames only is not among them.
    #[must_use]
    pub fn without_room(&self) -> Vec<Bone> {
        let now = self.time();
        let told = self.no_room().filter(|it| now - it.time[1] < PAUSE);
        told.map(|it| it.part).collect()
    }
}

/// Writes down in what cloth lies that had no room in a frame that ends at a time [s]: `held` are its
/// particles [m], of the body there are surfels, with the bone that carries each.
pub(super) fn note(
    told: &mut Vec<NoRoom>,
    time: f32,
    held: &[Vec3],
    (surfels, bone_of): (&[Surfel], &dyn Fn(usize) -> Bone),
) {
    let step = held.len().div_ceil(LOOKED_AT).max(1);
    let looked_at: Vec<Bone> = (held.iter().step_by(step))
        .filter_map(|&place| nearest(place, surfels))
        .map(|surfel| part_of(bone_of(surfel)))
        .collect();
    for part in PARTS.map(|(part, _)| part) {
        let count = looked_at.iter().filter(|&&it| it == part).count();
        if count == 0 || count * LEAST_SHARE < looked_at.len() {
            continue;
        }
        let known = told
            .iter_mut()
            .find(|it| it.part == part && time - it.time[1] < PAUSE);
        match known {
            Some(known) => known.time[1] = time,
            None => told.push(NoRoom {
                part,
                time: [time; 2],
            }),
        }
    }
}

/// The surfel nearest to a place [m] that lies in the skin there.
fn nearest(place: Vec3, surfels: &[Surfel]) -> Option<usize> {
    let squares = surfels
        .iter()
        .map(|surfel| surfel.position.distance_squared(place));
    let (surfel, square) = squares.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let Surfel { position, normal } = surfels[surfel];
    let is_in = (place - position).dot(normal) < -SUNK;
    (is_in && square < NEAR * NEAR).then_some(surfel)
}

/// Parts that are told apart, with their words.
const PARTS: [(Bone, Words); 13] = [
    (Bone::Hips, words("腰", "her hips")),
    (Bone::Spine, words("胴", "her trunk")),
    (Bone::Neck, words("首から上", "her head")),
    (Bone::LeftUpperArm, words("左の上腕", "her left upper arm")),
    (
        Bone::RightUpperArm,
        words("右の上腕", "her right upper arm"),
    ),
    (
        Bone::LeftLowerArm,
        words("左の前腕と手", "her left forearm and hand"),
    ),
    (
        Bone::RightLowerArm,
        words("右の前腕と手", "her right forearm and hand"),
    ),
    (Bone::LeftUpperLeg, words("左の太もも", "her left thigh")),
    (Bone::RightUpperLeg, words("右の太もも", "her right thigh")),
    (Bone::LeftLowerLeg, words("左のすね", "her left shank")),
    (Bone::RightLowerLeg, words("右のすね", "her right shank")),
    (Bone::LeftFoot, words("左足", "her left foot")),
    (Bone::RightFoot, words("右足", "her right foot")),
];

/// The part that a bone belongs to.
fn part_of(bone: Bone) -> Bone {
    let is_part = |bone: &Bone| PARTS.iter().any(|(part, _)| part == bone);
    bone.lineage().find(is_part).unwrap_or(Bone::Hips)
}

fn part_words(part: Bone) -> Words {
    let found = PARTS.iter().find(|(bone, _)| *bone == part);
    found.map_or(words("体", "her body"), |(_, words)| *words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_back_in_a_part_of_the_body_is_told_once_for_a_time() {
        let surfel = |x: f32| Surfel {
            position: Vec3::X * x,
            normal: Vec3::X,
        };
        let surfels = [surfel(0.0), surfel(1.0)];
        let bones = [Bone::LeftToes, Bone::Chest];
        let bone_of = |surfel: usize| bones[surfel];
        let mut told = Vec::new();
        for frame in 0..10_u8 {
            let time = 2.0 + f32::from(frame) * 0.1;
            let held = [Vec3::X * -0.01, Vec3::X * 0.5];
            note(&mut told, time, &held, (&surfels, &bone_of));
        }
        note(&mut told, 5.0, &[Vec3::X * 0.99], (&surfels, &bone_of));
        note(&mut told, 5.1, &[], (&surfels, &bone_of));
        note(&mut told, 8.0, &[Vec3::X * 1.002], (&surfels, &bone_of));
        let parts: Vec<_> = told.iter().map(|it| it.part).collect();
        assert_eq!(parts, [Bone::LeftFoot, Bone::Spine]);
        assert_eq!(told[0].time[0], 2.0);
        assert!((told[0].time[1] - 2.9).abs() < 1.0e-3);
        let said = told[0].sentence();
        assert!(said.english.contains("2.0 to 2.9 s") && said.english.contains("left foot"));
        assert!(said.japanese.contains("左足"));
    }

    #[test]
    fn what_has_no_room_now_is_one_sentence_in_both_languages() {
        assert_eq!(no_room_now(&[]), None);
        let said = no_room_now(&[Bone::LeftUpperLeg, Bone::RightUpperLeg]).unwrap();
        assert_eq!(
            said.english,
            "no room for the cloth at her left thigh and her right thigh: the skin gives way"
        );
        assert_eq!(
            said.japanese,
            "左の太ももと右の太もものところで布の居場所がなく、肌のほうがよけています"
        );
    }

    #[test]
    fn every_bone_is_of_a_part_that_has_words() {
        for &bone in Bone::ALL {
            assert!(part_words(part_of(bone)).english != "her body");
        }
    }
}
