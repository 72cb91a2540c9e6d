//! A face of her own: what is measured is made wider, fuller or longer feature by feature.
//!
//! Every feature moves its own part of the face and fades out before the hairline, the ears and the neck, so hair
//! lies as before and the head meets the same neck. Lengths are in eyes: what is said in millimeters is of an eye of
//! the mean woman.

use glam::{Quat, Vec3};

use crate::appearance::{Face, Feature};
use crate::parts::HeadPart;
use crate::surface::warp::smooth_step;

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

/// 1 up to `full`, 0 from `none` on.
fn fading(distance: f32, [full, none]: [f32; 2]) -> f32 {
    smooth_step((none - distance) / (none - full))
}

/// Named places of a head before it is changed.
pub(super) struct Marks {
    pub(super) eye: Vec3,
    pub(super) radius: f32,
    tip: Vec3,
    pub(super) alare: Vec3,
    subnasale: Vec3,
    nasion: Vec3,
    stomion: Vec3,
    menton: Vec3,
    pub(super) corner: Vec3,
    lip_above: Vec3,
    lip_below: Vec3,
    lobe: Vec3,
    cheek: Vec3,
    /// A millimeter of the mean woman's face [m].
    pub(super) mm: f32,
}

impl Marks {
    pub(super) fn of(head: &HeadPart) -> Self {
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
            mm: 0.001 * head.size(),
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

/// Changes a head to the features that were chosen; `free` says how far each of its points may move.
pub(super) fn choose(head: &mut HeadPart, face: &Face, free: &[f32]) {
    if *face == Face::default() {
        return;
    }
    let marks = Marks::of(head);
    for (place, free) in head.part.positions.iter_mut().zip(free) {
        *place += marks.moved(*place, face) * *free;
    }
    let size = 1.0 + EYE_SIZE * face.feature(Feature::EyeSize);
    head.eye += marks.moved(head.eye, face);
    head.eye_radius *= size;
    head.iris_radius *= size;
}
