//! What a tape says about a body, as far as drafting asks.

use lole_geom::Length;
use lole_language::{Words, words};

use crate::DraftError;

/// Measures of one body. All are given or estimated by whoever made them: a draft does not guess.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// Height without shoes.
    pub stature: Length,
    /// Fullest girth of the bust.
    pub bust_girth: Length,
    /// Girth right below the bust.
    pub underbust_girth: Length,
    /// Girth of the waist.
    pub waist_girth: Length,
    /// Fullest girth of the hips.
    pub hip_girth: Length,
    /// Girth around the root of the neck.
    pub neck_girth: Length,
    /// Girth around the head above the brows.
    pub head_girth: Length,
    /// Girth of the upper arm below the armpit.
    pub upper_arm_girth: Length,
    /// Girth of the wrist.
    pub wrist_girth: Length,
    /// Girth of the ankle.
    pub ankle_girth: Length,
    /// Girth through the crotch: waist in front, between the legs, waist at the back.
    pub crotch_length: Length,
    /// From the point of one shoulder to the other.
    pub shoulder_breadth: Length,
    /// From the shoulder point to the elbow.
    pub upper_arm_length: Length,
    /// From the shoulder point to the wrist along the arm.
    pub arm_length: Length,
    /// From the bone at the nape down to the waist.
    pub back_length: Length,
    /// From the side of the neck over the bust point to the waist.
    pub front_length: Length,
    /// How far the shoulder falls from the side of the neck to its point.
    pub shoulder_drop: Length,
    /// Across the back between the arms.
    pub back_breadth: Length,
    /// Across the chest between the arms.
    pub chest_breadth: Length,
    /// Between the two bust points.
    pub bust_point_breadth: Length,
    /// Height of the side of the neck above the floor.
    pub neck_height: Length,
    /// Height of the fullest bust above the floor.
    pub bust_height: Length,
    /// Height of the armpit above the floor.
    pub armpit_height: Length,
    /// Height of the waist above the floor.
    pub waist_height: Length,
    /// Height above the floor of the front points of the hip bones, where a pāʻū skirt is worn.
    pub hip_bone_height: Length,
    /// Height of the fullest hips above the floor.
    pub hip_height: Length,
    /// Height of the knee above the floor.
    pub knee_height: Length,
    /// Girth of the trunk by height above the floor, from the crotch up to the armpits, rising.
    pub trunk: Vec<TrunkGirth>,
}

/// A tape around the trunk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrunkGirth {
    /// Above the floor.
    pub height: Length,
    /// Of the taut tape.
    pub girth: Length,
}

macro_rules! measures {
    ($($(#[$doc:meta])* $variant:ident $field:ident $japanese:literal $english:literal $band:expr;)*) => {
        /// One of [`Measures`], to be named when it is the cause of something.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Measure {
            $($(#[$doc])* $variant,)*
        }

        impl Measure {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];

            /// What a tailor calls it.
            #[must_use]
            pub const fn words(self) -> Words {
                match self { $(Self::$variant => words($japanese, $english),)* }
            }

            /// What it can be, from a small child to the largest tape or an avatar's big head, wide sleeve
            /// or boot [cm]: beyond it a number was typed in another unit.
            #[must_use]
            pub const fn band_cm(self) -> [f64; 2] {
                match self { $(Self::$variant => $band,)* }
            }

            /// Its value.
            #[must_use]
            pub const fn of(self, measures: &Measures) -> Length {
                match self { $(Self::$variant => measures.$field,)* }
            }

            /// Its value, to be changed.
            pub const fn of_mut(self, measures: &mut Measures) -> &mut Length {
                match self { $(Self::$variant => &mut measures.$field,)* }
            }
        }
    };
}

measures! {
    /// [`Measures::stature`].
    Stature stature "身長" "the stature" [80.0, 220.0];
    /// [`Measures::bust_girth`].
    BustGirth bust_girth "バスト" "the bust girth" [40.0, 180.0];
    /// [`Measures::underbust_girth`].
    UnderbustGirth underbust_girth "アンダーバスト" "the girth under the bust" [36.0, 170.0];
    /// [`Measures::waist_girth`].
    WaistGirth waist_girth "ウエスト" "the waist girth" [36.0, 180.0];
    /// [`Measures::hip_girth`].
    HipGirth hip_girth "ヒップ" "the hip girth" [40.0, 200.0];
    /// [`Measures::neck_girth`].
    NeckGirth neck_girth "首の付け根の周り" "the girth of the neck" [18.0, 65.0];
    /// [`Measures::head_girth`].
    HeadGirth head_girth "頭囲" "the girth of the head" [40.0, 130.0];
    /// [`Measures::upper_arm_girth`].
    UpperArmGirth upper_arm_girth "上腕の周り" "the girth of the upper arm" [11.0, 65.0];
    /// [`Measures::wrist_girth`].
    WristGirth wrist_girth "手首の周り" "the girth of the wrist" [8.0, 70.0];
    /// [`Measures::ankle_girth`].
    AnkleGirth ankle_girth "足首の周り" "the girth of the ankle" [11.0, 70.0];
    /// [`Measures::crotch_length`].
    CrotchLength crotch_length "前後の股上（ウエストから股を通ってウエストまで）" "the crotch length" [30.0, 130.0];
    /// [`Measures::shoulder_breadth`].
    ShoulderBreadth shoulder_breadth "肩幅" "the shoulder breadth" [18.0, 60.0];
    /// [`Measures::upper_arm_length`].
    UpperArmLength upper_arm_length "肩先からひじ" "the length of the upper arm" [12.0, 48.0];
    /// [`Measures::arm_length`].
    ArmLength arm_length "袖丈" "the length of the arm" [22.0, 80.0];
    /// [`Measures::back_length`].
    BackLength back_length "背丈" "the back length" [15.0, 60.0];
    /// [`Measures::front_length`].
    FrontLength front_length "前丈（首の横から胸を通ってウエスト）" "the front length" [15.0, 75.0];
    /// [`Measures::shoulder_drop`].
    ShoulderDrop shoulder_drop "肩下がり" "the drop of the shoulder" [0.5, 12.0];
    /// [`Measures::back_breadth`].
    BackBreadth back_breadth "背幅" "the breadth of the back" [15.0, 65.0];
    /// [`Measures::chest_breadth`].
    ChestBreadth chest_breadth "胸幅" "the breadth of the chest" [15.0, 65.0];
    /// [`Measures::bust_point_breadth`].
    BustPointBreadth bust_point_breadth "乳頭の間隔" "the distance of the bust points" [8.0, 40.0];
    /// [`Measures::neck_height`].
    NeckHeight neck_height "首の横の高さ" "the height of the neck" [60.0, 190.0];
    /// [`Measures::bust_height`].
    BustHeight bust_height "バストの高さ" "the height of the bust" [50.0, 165.0];
    /// [`Measures::armpit_height`].
    ArmpitHeight armpit_height "脇の下の高さ" "the height of the armpit" [50.0, 175.0];
    /// [`Measures::waist_height`].
    WaistHeight waist_height "ウエストの高さ" "the height of the waist" [40.0, 145.0];
    /// [`Measures::hip_bone_height`].
    HipBoneHeight hip_bone_height "腰骨の高さ" "the height of the hip bones" [35.0, 130.0];
    /// [`Measures::hip_height`].
    HipHeight hip_height "ヒップの高さ" "the height of the hips" [30.0, 125.0];
    /// [`Measures::knee_height`].
    KneeHeight knee_height "ひざの高さ" "the height of the knee" [18.0, 75.0];
}

impl Measures {
    /// Checks that each of these measures is a number in its band.
    ///
    /// # Errors
    /// [`DraftError::Length`] with the name of the first one that is not.
    pub fn check(&self, measures: &[Measure]) -> Result<(), DraftError> {
        measures.iter().try_for_each(|measure| {
            let [min_cm, max_cm] = measure.band_cm();
            let cm = measure.of(self).to_cm();
            if (min_cm..=max_cm).contains(&cm) {
                return Ok(());
            }
            Err(DraftError::Length {
                what: measure.words(),
                cm,
                min_cm,
                max_cm,
            })
        })
    }

    /// Girth of the trunk at a height above the floor, between two tapes in proportion; the nearest
    /// tape's beyond the ends, `None` without tapes.
    #[must_use]
    pub fn girth_at(&self, height: Length) -> Option<Length> {
        let above = self.trunk.partition_point(|tape| tape.height < height);
        let (Some(below), Some(above)) = (
            self.trunk.get(above.saturating_sub(1)),
            self.trunk.get(above).or(self.trunk.last()),
        ) else {
            return None;
        };
        let rise = (above.height - below.height).to_m();
        let part = if rise <= 0.0 {
            0.0
        } else {
            ((height - below.height).to_m() / rise).clamp(0.0, 1.0)
        };
        Some(below.girth + (above.girth - below.girth) * part)
    }

    /// Mean way along the trunk from one height [m] up to another, by the tapes in between: a tape that
    /// is longer by `d` lies farther out by `d / 2π`.
    #[must_use]
    pub fn way_up(&self, from: f64, to: f64) -> Length {
        let girth = |height: f64| {
            let girth = self.girth_at(Length::from_m(height));
            girth.map_or(0.0, Length::to_m)
        };
        let between = self.trunk.iter().map(|tape| tape.height.to_m());
        let between = between.filter(|height| from < *height && *height < to);
        let mut below = from;
        let mut way = 0.0;
        for height in between.chain([to]) {
            let out = (girth(height) - girth(below)) / std::f64::consts::TAU;
            let rise = height - below;
            way += (rise * rise + out * out).sqrt();
            below = height;
        }
        Length::from_m(way)
    }
}
