//! Alterations of fitted garments: what a trial in basted cloth has shown, and no tape says.

use lole_geom::Length;
use lole_language::{Words, words};

/// How much a pattern is altered by each of [`Alteration::ALL`] [cm]; nothing at first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Alterations([f64; Alteration::ALL.len()]);

impl Alterations {
    /// No alteration.
    pub const NONE: Self = Self([0.0; Alteration::ALL.len()]);

    /// These, with one of them anew [cm].
    #[must_use]
    pub const fn with_cm(mut self, alteration: Alteration, cm: f64) -> Self {
        self.0[alteration as usize] = cm;
        self
    }

    /// How much of one, as it was given [cm].
    #[must_use]
    pub const fn cm(&self, alteration: Alteration) -> f64 {
        self.0[alteration as usize]
    }

    /// How much of one.
    #[must_use]
    pub const fn of(&self, alteration: Alteration) -> Length {
        Length::from_cm(self.cm(alteration))
    }
}

/// One way of altering a fitted pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Alteration {
    /// The front is longer and wider over a full bust, and its dart deeper; all the reverse below 0.
    FullBust,
    /// The back is longer over round shoulder blades, shorter below 0, for an erect back.
    RoundBack,
    /// The middle of the back is folded out over the waist, towards nothing at the sides, for a hollow back.
    SwayBack,
    /// Shoulders and armholes lie lower, and higher below 0, for square shoulders.
    SlopingShoulders,
    /// The back is wider from the armhole down; narrower below 0.
    BroadBack,
    /// The sleeve is wider around the upper arm at the same cap; narrower below 0.
    FullArm,
}

impl Alteration {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::FullBust,
        Self::RoundBack,
        Self::SwayBack,
        Self::SlopingShoulders,
        Self::BroadBack,
        Self::FullArm,
    ];

    /// Key of a design.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::FullBust => "full_bust_cm",
            Self::RoundBack => "round_back_cm",
            Self::SwayBack => "sway_back_cm",
            Self::SlopingShoulders => "sloping_shoulders_cm",
            Self::BroadBack => "broad_back_cm",
            Self::FullArm => "full_arm_cm",
        }
    }

    /// What a tailor calls it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::FullBust => words("胸の補正", "full bust"),
            Self::RoundBack => words("猫背の補正", "round back"),
            Self::SwayBack => words("反り腰の補正", "sway back"),
            Self::SlopingShoulders => words("なで肩の補正", "sloping shoulders"),
            Self::BroadBack => words("背幅の補正", "broad back"),
            Self::FullArm => words("腕の補正", "full arm"),
        }
    }

    /// What it does, and what less than nothing of it does.
    #[must_use]
    pub const fn about(self) -> Words {
        match self {
            Self::FullBust => words(
                "胸の補正。前身頃を胸の上で長く、広くし、ダーツを深くする分。負なら小さい胸",
                "front longer and wider over the bust, its dart deeper; below 0 for a small bust",
            ),
            Self::RoundBack => words(
                "猫背の補正。後ろ身頃を肩甲骨の上で長くする分。負なら反り身",
                "back longer over the shoulder blades; below 0 for an erect back",
            ),
            Self::SwayBack => words(
                "反り腰の補正。後ろ中心をウエストでたたむ分。脇で 0 になる",
                "middle of the back folded out over the waist, to nothing at the sides",
            ),
            Self::SlopingShoulders => words(
                "なで肩の補正。肩先と袖ぐりを下げる分。負ならいかり肩",
                "shoulder points and armholes lower; below 0 for square shoulders",
            ),
            Self::BroadBack => words(
                "背幅の補正。後ろ身頃を袖ぐりから下で広くする分。負なら狭い背",
                "back wider from the armholes down; below 0 for a narrow back",
            ),
            Self::FullArm => words(
                "腕の補正。袖を上腕のまわりで広くする分。負なら細い腕",
                "sleeve wider around the upper arm; below 0 for a thin arm",
            ),
        }
    }

    /// What one sees on the basted garment where it is needed.
    #[must_use]
    pub const fn seen(self) -> Words {
        match self {
            Self::FullBust => words(
                "胸の先から脇や袖ぐりへ斜めのしわが引かれ、前の裾が上がる。胸の上で布がたるむなら負の数",
                "creases pull from the bust point to side and armhole, and the hem rises in front; a negative number where cloth sags over the bust",
            ),
            Self::RoundBack => words(
                "首の後ろが背から離れ、後ろの裾が上がり、肩甲骨の上で引かれる。首の下に横じわがたまるなら負の数",
                "the back of the neck stands away, the hem rises at the back, the shoulder blades pull; a negative number where folds lie across below the nape",
            ),
            Self::SwayBack => words(
                "後ろのウエストの上に横じわがたまる。その高さをつまんだ分",
                "folds lie across the back over the waist: what is pinned out of them",
            ),
            Self::SlopingShoulders => words(
                "首の横から袖ぐりの下へ斜めのしわが垂れる。肩先へ引かれ、衿ぐりが浮くなら負の数（いかり肩）",
                "creases hang from the neck to the underarm; a negative number where the shoulder points pull and the neckline stands away",
            ),
            Self::BroadBack => words(
                "腕を前へ出すと背が引かれ、後ろの袖の縫い目が食い込む。背の両脇にたてじわがたるむなら負の数",
                "the back pulls across when the arms reach forward; a negative number where it sags in folds down from the armholes",
            ),
            Self::FullArm => words(
                "袖が上腕で引かれ、横じわが寄る。たてにたるむなら負の数",
                "the sleeve pulls around the upper arm in creases across; a negative number where it sags lengthwise",
            ),
        }
    }

    /// How much of it there can be [cm].
    #[must_use]
    pub const fn band_cm(self) -> [f64; 2] {
        match self {
            Self::FullBust => [-3.0, 6.0],
            Self::RoundBack => [-2.0, 4.0],
            Self::SwayBack => [0.0, 4.0],
            Self::SlopingShoulders => [-2.5, 3.0],
            Self::BroadBack => [-4.0, 6.0],
            Self::FullArm => [-3.0, 8.0],
        }
    }
}
