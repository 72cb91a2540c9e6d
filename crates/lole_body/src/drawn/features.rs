//! A face of her own: what is measured is made wider, fuller or longer feature by feature, and older.
//!
//! Every feature moves its own part of the face and fades out before the hairline, the ears and the neck, so hair
//! lies as before and the head meets the same neck. Lengths are in eyes: what is said in millimeters is of an eye of
//! the mean woman.

use glam::{Quat, Vec3};
use lole_geom::mesh::vertex_normals;

use crate::appearance::{Face, Feature, oldness};
use crate::parts::{self, HeadPart, Shares};
use crate::surface::warp::smooth_step;
use crate::{Appearance, BodyError};

/// Radius of the mean woman's eye [m].
const MEAN_EYE: f32 = 0.01429;
/// The measured bodies between which the years of a face lie.
const YOUNG: &str = "woman_mean";
const OLD: &str = "woman_60s";

/// How near to the neck's edge nothing moves, and from where on everything does [m].
const NECK: [f32; 2] = [0.004, 0.045];

/// What a feature at its most adds: shares of what is there, millimeters, radians.
const EYE_SIZE: f32 = 0.10;
const EYE_DISTANCE: f32 = 2.0;
const EYE_TILT: f32 = 0.10;
const NOSE_WIDTH: f32 = 0.20;
const NOSE_BRIDGE: f32 = 2.4;
const NOSE_LENGTH: f32 = 2.6;
const MOUTH_WIDTH: f32 = 0.11;
const LIP_FULLNESS: f32 = 0.28;
const LIP_FORWARD: f32 = 0.9;
const CHEEKS: f32 = 3.2;
const JAW_WIDTH: f32 = 0.095;
const CHIN: f32 = 4.2;

/// Where lines of age run deepest: depth of the fold beside the nose, of the one below the mouth and of the bag below
/// the eye, at 65 years [mm].
const FOLD: f32 = 0.75;
const MOUTH_FOLD: f32 = 0.5;
const BAG: f32 = 0.55;
/// How dark they are.
const FOLD_SHADE: f32 = 0.26;
const BAG_SHADE: f32 = 0.17;

/// 1 up to `full`, 0 from `none` on.
fn fading(distance: f32, [full, none]: [f32; 2]) -> f32 {
    smooth_step((none - distance) / (none - full))
}

/// Named places of a head before it is changed.
struct Marks {
    eye: Vec3,
    radius: f32,
    tip: Vec3,
    alare: Vec3,
    subnasale: Vec3,
    nasion: Vec3,
    stomion: Vec3,
    menton: Vec3,
    corner: Vec3,
    lip_above: Vec3,
    lip_below: Vec3,
    lobe: Vec3,
    cheek: Vec3,
    /// A millimeter of the mean woman's face [m].
    mm: f32,
}

impl Marks {
    fn of(head: &HeadPart) -> Self {
        let at = |point: u32| head.part.positions[point as usize];
        let lip = |column: usize| at(head.lips[head.lip_rim][column]);
        let places = &head.places;
        let most = head.cheek.iter().copied().fold(0.0, f32::max);
        let rosy = (head.part.positions.iter().zip(&head.cheek))
            .filter(|(_, cheek)| 0.9 * most <= **cheek);
        let (sum, count) = rosy.fold((Vec3::ZERO, 0.0), |(sum, count), (place, _)| {
            (sum + *place, count + 1.0)
        });
        Self {
            eye: head.eye,
            radius: head.eye_radius,
            tip: at(places.pronasale),
            alare: at(places.alare),
            subnasale: at(places.subnasale),
            nasion: at(places.nasion),
            stomion: at(places.stomion),
            menton: at(places.menton),
            corner: lip(13),
            lip_above: lip(0),
            lip_below: lip(23),
            lobe: at(places.ear_lobe),
            cheek: sum / f32::max(count, 1.0),
            mm: 0.001 * head.eye_radius / MEAN_EYE,
        }
    }

    /// How far the changes of a face move a place [m].
    fn moved(&self, place: Vec3, face: &Face) -> Vec3 {
        self.around_the_eye(place, face)
            + self.nose(place, face)
            + self.mouth(place, face)
            + self.below(place, face)
    }

    fn around_the_eye(&self, place: Vec3, face: &Face) -> Vec3 {
        let out = place - self.eye;
        let near = fading(out.length() / self.radius, [1.3, 1.95]);
        let size = EYE_SIZE * face.feature(Feature::EyeSize);
        let turn = Quat::from_rotation_z(EYE_TILT * face.feature(Feature::EyeTilt) * near);
        let aside = EYE_DISTANCE * self.mm * face.feature(Feature::EyeDistance);
        (turn * out - out) + (out * size + Vec3::X * aside) * near
    }

    fn nose(&self, place: Vec3, face: &Face) -> Vec3 {
        let mm = self.mm;
        let [width, bridge, length] =
            [Feature::NoseWidth, Feature::NoseBridge, Feature::NoseLength]
                .map(|feature| face.feature(feature));
        let wing = fading((place.y - self.alare.y).abs(), [3.0 * mm, 15.0 * mm])
            * fading(self.tip.z - place.z, [16.0 * mm, 26.0 * mm])
            * fading(place.x, [self.alare.x, 1.9 * self.alare.x]);
        let wider = NOSE_WIDTH * width * wing * place.x.min(self.alare.x);
        let along = (place.y - self.tip.y) / (self.nasion.y - self.tip.y);
        // From the tip up over the root of the nose to between the brows.
        let ridge = smooth_step(along / 0.55) * smooth_step((1.75 - along) / 0.75);
        let ridge = ridge
            * fading(place.x, [1.5 * mm, 13.0 * mm])
            * fading(self.nasion.z - place.z, [6.0 * mm, 16.0 * mm]);
        let end = self.tip.midpoint(self.subnasale);
        let low = fading(place.distance(end), [7.0 * mm, 23.0 * mm]);
        Vec3::new(
            wider,
            -NOSE_LENGTH * mm * length * low,
            NOSE_BRIDGE * mm * bridge * ridge,
        )
    }

    fn mouth(&self, place: Vec3, face: &Face) -> Vec3 {
        let mm = self.mm;
        let over = place.y - self.stomion.y;
        let front = fading(self.stomion.z - place.z, [12.0 * mm, 26.0 * mm]);
        let level = fading(over.abs(), [5.0 * mm, 19.0 * mm]) * front;
        let wide = fading(place.x, [1.1 * self.corner.x, 2.0 * self.corner.x]);
        let width = MOUTH_WIDTH * face.feature(Feature::MouthWidth) * level * wide;
        let fullness = face.feature(Feature::LipFullness);
        let lip = if over < 0.0 {
            self.stomion.y - self.lip_below.y
        } else {
            self.lip_above.y - self.stomion.y
        };
        let share = over.abs() / lip;
        let near = fading(share, [1.0, 2.0])
            * fading(place.x, [0.5 * self.corner.x, 1.05 * self.corner.x])
            * front;
        // Farthest forward is the middle of each lip, not its border or the line between them.
        let swell = near * smooth_step(share / 0.5) * fading(share, [0.5, 1.5]);
        Vec3::new(
            width * place.x.min(1.1 * self.corner.x),
            LIP_FULLNESS * fullness * near * over,
            LIP_FORWARD * mm * fullness * swell,
        )
    }

    /// Cheeks, jaw and chin.
    fn below(&self, place: Vec3, face: &Face) -> Vec3 {
        let mm = self.mm;
        let round = fading(place.distance(self.cheek), [6.0 * mm, 34.0 * mm]);
        let middle = Vec3::new(0.0, place.y, self.lobe.z);
        let out = (place - middle).normalize_or(Vec3::Z);
        let before_ear = smooth_step((place.z - self.lobe.z) / (18.0 * mm));
        let cheek = out * (CHEEKS * mm * face.feature(Feature::CheekFullness) * round);
        let jaw_level = self.stomion.y.midpoint(self.menton.y);
        let level = fading((place.y - jaw_level).abs(), [14.0 * mm, 40.0 * mm]);
        let jaw = JAW_WIDTH * face.feature(Feature::JawWidth) * level * before_ear * place.x;
        let chin = smooth_step((self.lip_below.y - place.y) / (self.lip_below.y - self.menton.y))
            * fading(self.menton.y - place.y, [6.0 * mm, 42.0 * mm])
            * fading(self.menton.z - place.z, [14.0 * mm, 62.0 * mm]);
        let down = CHIN * mm * face.feature(Feature::ChinLength) * chin;
        cheek * before_ear + Vec3::new(jaw, -down, 0.0)
    }
}

/// Changes a head that is made of these shares to the face that was chosen.
pub(super) fn shape(
    head: &mut HeadPart,
    shares: &Shares,
    appearance: &Appearance,
) -> Result<(), BodyError> {
    let old = oldness(appearance.age_years);
    let free = free_of_the_neck(head);
    if appearance.age_years.is_some() {
        grow_old(head, shares, (old, &free))?;
    }
    if appearance.face != Face::default() {
        let marks = Marks::of(head);
        for (place, free) in head.part.positions.iter_mut().zip(&free) {
            *place += marks.moved(*place, &appearance.face) * *free;
        }
        let size = 1.0 + EYE_SIZE * appearance.face.feature(Feature::EyeSize);
        head.eye += marks.moved(head.eye, &appearance.face);
        head.eye_radius *= size;
        head.iris_radius *= size;
    }
    if 0.0 < old {
        line(head, old);
    }
    for &point in &head.middle {
        head.part.positions[point as usize].x = 0.0;
    }
    Ok(())
}

/// How far each point may move: where the head meets the neck, nothing does.
fn free_of_the_neck(head: &HeadPart) -> Vec<f32> {
    let positions = &head.part.positions;
    let rim: Vec<Vec3> = (head.part.rim.iter())
        .map(|&point| positions[point as usize])
        .collect();
    let free = positions.iter().map(|place| {
        let apart = rim.iter().map(|end| end.distance_squared(*place));
        let nearest = apart.fold(f32::INFINITY, f32::min).sqrt();
        smooth_step((nearest - NECK[0]) / (NECK[1] - NECK[0]))
    });
    free.collect()
}

/// Takes the face so far from that of a young woman to that of one in her sixties, whoever else it is made of.
fn grow_old(
    head: &mut HeadPart,
    shares: &Shares,
    (old, free): (f32, &[f32]),
) -> Result<(), BodyError> {
    let total: f32 = shares.iter().map(|(_, share)| *share).sum();
    let elder = shares.iter().filter(|(name, _)| name == OLD);
    let already = elder.map(|(_, share)| *share / total).sum::<f32>();
    // Her measures may have made her face of an elder one's in part: that part is of her years, not more.
    let more = old - already;
    let ends = [YOUNG, OLD].map(|name| parts::head(&vec![(name.to_owned(), 1.0)]));
    let [young, elder] = ends;
    let (young, elder) = (young?, elder?);
    let marks = Marks::of(head);
    let size = marks.mm * 1000.0;
    let down = elder.eye - young.eye;
    let down = Vec3::new(0.0, down.y, down.z);
    let ends = young.part.positions.iter().zip(&elder.part.positions);
    let places = head.part.positions.iter_mut().zip(free);
    for ((place, free), (young, elder)) in places.zip(ends) {
        *place += (*elder - *young - down) * (size * more * free);
    }
    head.eye += (elder.eye - young.eye - down) * (size * more);
    for (radius, [young, elder]) in [
        (&mut head.eye_radius, [young.eye_radius, elder.eye_radius]),
        (
            &mut head.iris_radius,
            [young.iris_radius, elder.iris_radius],
        ),
    ] {
        *radius += (elder - young) * size * more;
    }
    Ok(())
}

/// A line of age, seen from the front.
struct Crease {
    points: Vec<Vec3>,
    /// Half its width [m].
    half: f32,
    /// How deep it is [m].
    depth: f32,
    shade: f32,
}

impl Crease {
    /// How near a place is to it, 0 to 1.
    fn near(&self, place: Vec3) -> f32 {
        let pairs = self.points.windows(2).enumerate();
        let count = self.points.len().saturating_sub(1).max(1) as f32;
        let found = pairs.map(|(index, pair)| {
            let [a, b] = [pair[0], pair[1]].map(|it| it.truncate());
            let (way, to) = (b - a, place.truncate() - a);
            let share = (to.dot(way) / way.length_squared().max(1.0e-12)).clamp(0.0, 1.0);
            let apart = to.distance(way * share);
            (apart, (index as f32 + share) / count)
        });
        let nearest = found.min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((apart, along)) = nearest else {
            return 0.0;
        };
        // It begins and ends in nothing.
        let ends = smooth_step(along / 0.2) * smooth_step((1.0 - along) / 0.3);
        ends * smooth_step(1.0 - apart / (2.0 * self.half))
    }
}

/// Folds beside nose and mouth and bags below the eyes.
fn creases(head: &HeadPart, old: f32) -> Vec<Crease> {
    let marks = Marks::of(head);
    let mm = marks.mm;
    let by = |x: f32, y: f32| Vec3::new(x, y, 0.0) * mm;
    let bag = |turn: f32| {
        let (sin, cos) = lole_geom::trig::sin_cos(turn);
        marks.eye + Vec3::new(cos, sin, 0.0) * (1.27 * marks.radius)
    };
    let beside = vec![
        marks.alare + by(1.0, 6.0),
        marks.alare + by(6.5, -5.0),
        marks.corner + by(9.0, 9.0),
        marks.corner + by(9.5, -3.0),
    ];
    let below = vec![
        marks.corner + by(3.0, 1.0),
        marks.corner + by(6.5, -7.0),
        marks.corner + by(7.0, -17.0),
    ];
    let under = [-2.75_f32, -2.3, -1.9, -1.5, -1.1, -0.7].map(bag).to_vec();
    [
        (beside, 3.2, FOLD, FOLD_SHADE),
        (below, 2.8, MOUTH_FOLD, 0.7 * FOLD_SHADE),
        (under, 2.6, BAG, BAG_SHADE),
    ]
    .map(|(points, half, depth, shade)| Crease {
        points,
        half: half * mm,
        depth: depth * old * mm,
        shade: shade * old,
    })
    .into()
}

/// Lays lines into the skin.
fn line(head: &mut HeadPart, old: f32) {
    let normals = vertex_normals(&head.part.positions, &head.part.triangles);
    let creases = creases(head, old);
    for (place, normal) in head.part.positions.iter_mut().zip(normals) {
        // A line lies in what is seen from the front.
        let front = smooth_step(normal.normalize_or_zero().z / 0.4);
        let at = *place;
        for crease in &creases {
            let near = crease.near(at);
            *place -= normal.normalize_or_zero() * (crease.depth * near * near * front);
        }
    }
}

/// How much light lines of age leave to each point of a head.
pub(super) fn lined(head: &HeadPart, age_years: Option<f32>) -> Option<Vec<f32>> {
    let old = oldness(age_years);
    if old <= 0.0 {
        return None;
    }
    let creases = creases(head, old);
    let shades = head.part.positions.iter().map(|&place| {
        let shade = creases.iter().map(|crease| {
            let near = crease.near(place);
            1.0 - crease.shade * near * near
        });
        shade.product()
    });
    Some(shades.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The neck's edge stays to the bit, at every age of every measured head.
    #[test]
    fn no_year_moves_the_neck() {
        for name in [
            "woman_mean",
            "woman_60s",
            "woman_large",
            "man_mean",
            "child_8",
        ] {
            let shares = vec![(name.to_owned(), 1.0)];
            let before = parts::head(&shares).unwrap();
            let mut after = before.clone();
            let looks = Appearance {
                face: Face::of_seed(5),
                age_years: Some(95.0),
                ..Appearance::default()
            };
            shape(&mut after, &shares, &looks).unwrap();
            for &point in &before.part.rim {
                let [from, to] = [&before, &after].map(|head| head.part.positions[point as usize]);
                assert_eq!(from, to, "{name}");
            }
        }
    }
}
