//! Manners of dancing by name: what a hālau would set once.

use lole_language::{Words, words};

use super::settings::{ArmManner, Hands, HipLead, HipLift, MotionSettings};

/// A manner of dancing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct School {
    /// Name in documents: ASCII, lower case.
    pub id: &'static str,
    /// What it is.
    pub about: Words,
    /// Which side of the pelvis is higher while it sways.
    pub hip_lift: HipLift,
    /// Where the hips are on the count.
    pub hip_lead: HipLead,
    /// See [`MotionSettings::sway`].
    pub sway: f32,
    /// See [`MotionSettings::knee_degrees`].
    pub knee_degrees: f32,
    /// See [`MotionSettings::heel_lift`].
    pub heel_lift: f32,
    /// See [`MotionSettings::step_width`].
    pub step_width: f32,
    /// See [`MotionSettings::stance_width`].
    pub stance_width: f32,
    /// See [`MotionSettings::toe_out_degrees`].
    pub toe_out_degrees: f32,
    /// See [`MotionSettings::figure_eight`].
    pub figure_eight: f32,
    /// How the arms move.
    pub arm_manner: ArmManner,
    /// What the hands are like.
    pub hands: Hands,
}

/// ʻAuana as most books of the basics in Japan teach it: the default.
const AUANA: School = School {
    id: "auana",
    about: words(
        "アウアナ。拍で足を置くとき腰はまだ反対側（日本に多い）",
        "ʻauana; on the count the hips are still over the other foot (common in Japan)",
    ),
    hip_lift: HipLift::WeightedSide,
    hip_lead: HipLead::OtherFoot,
    sway: 1.0,
    knee_degrees: 32.0,
    heel_lift: 0.02,
    step_width: 0.18,
    stance_width: 0.124,
    toe_out_degrees: 7.0,
    figure_eight: 0.0,
    arm_manner: ArmManner::Curved,
    hands: Hands::Soft,
};

/// All schools, the default first. They are sketches: a kumu's way comes first.
pub const SCHOOLS: &[School] = &[
    AUANA,
    School {
        id: "auana-toward",
        about: words(
            "アウアナ。拍で腰を出す足の側へ",
            "ʻauana; on the count the hips sway toward the stepping foot",
        ),
        hip_lead: HipLead::SteppingFoot,
        ..AUANA
    },
    School {
        id: "auana-flat",
        about: words(
            "アウアナ。かかとを上げず、つま先はまっすぐ",
            "ʻauana with the soles down and the toes straight ahead",
        ),
        heel_lift: 0.0,
        toe_out_degrees: 0.0,
        ..AUANA
    },
    School {
        id: "ka-lewa",
        about: words(
            "カ・レヴァ。自由な側の腰がかかとと共に上がり、うしろに八の字",
            "ka lewa; the free hip rises with its heel, and the hips draw an eight behind",
        ),
        hip_lift: HipLift::FreeSide,
        heel_lift: 0.025,
        figure_eight: 0.008,
        ..AUANA
    },
    School {
        id: "kahiko-wahine",
        about: words(
            "カヒコ（女性）。低いアイ・ハア、腕は拍で止まり手は開く",
            "kahiko, women; low ʻai haʻa, arms that stop on the count, open hands",
        ),
        sway: 0.9,
        knee_degrees: 60.0,
        heel_lift: 0.01,
        stance_width: 0.16,
        arm_manner: ArmManner::Crisp,
        hands: Hands::Flat,
        ..AUANA
    },
    School {
        id: "kahiko-kane",
        about: words(
            "カヒコ（男性）。肩幅で低く、つま先は外、手は握る",
            "kahiko, men; low, as wide as the shoulders, toes out, closed hands",
        ),
        sway: 0.7,
        knee_degrees: 62.0,
        heel_lift: 0.0,
        stance_width: 0.22,
        toe_out_degrees: 10.0,
        arm_manner: ArmManner::Crisp,
        hands: Hands::Fist,
        ..AUANA
    },
];

impl School {
    /// The school whose name in documents is `id`.
    #[must_use]
    pub fn from_id(id: &str) -> Option<&'static Self> {
        SCHOOLS.iter().find(|school| school.id == id)
    }

    /// Lets `settings` be danced in its manner; what is danced stays as it is.
    pub fn apply(&self, settings: &mut MotionSettings) {
        *settings = MotionSettings {
            hip_lift: self.hip_lift,
            hip_lead: self.hip_lead,
            sway: self.sway,
            knee_degrees: self.knee_degrees,
            heel_lift: self.heel_lift,
            step_width: self.step_width,
            stance_width: self.stance_width,
            toe_out_degrees: self.toe_out_degrees,
            figure_eight: self.figure_eight,
            arm_manner: self.arm_manner,
            hands: self.hands,
            ..settings.clone()
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_school_is_the_default() {
        let mut settings = MotionSettings::default();
        SCHOOLS[0].apply(&mut settings);
        assert_eq!(settings, MotionSettings::default());
    }

    #[test]
    fn schools_are_found_by_their_ids_and_can_be_danced() {
        for school in SCHOOLS {
            assert_eq!(School::from_id(school.id), Some(school));
            let mut settings = MotionSettings::default();
            school.apply(&mut settings);
            settings.check().expect(school.id);
        }
        assert_eq!(School::from_id("hula"), None);
    }
}
