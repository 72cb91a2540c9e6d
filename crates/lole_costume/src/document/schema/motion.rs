//! The keys of the dance: of `[motion]`, and of each part in the list `[[motion.part]]`.

use lole_body::Side;
use lole_hula::SCHOOLS;
use lole_hula::{
    AmiTurn, ArmManner, ArmStyle, DanceStep, Formation, Hands, HipLead, HipLift, School,
};
use lole_language::{Words, words};

use super::{Key, Kind, Table};
use crate::document::{LinkedFile, MotionDrift, MotionRepeat, PartDesign, StageMood};

/// Name of the list of parts in `[motion]`.
pub const MOTION_PARTS: &str = "part";

const REPEATS: &[(&str, MotionRepeat)] =
    &[("once", MotionRepeat::Once), ("loop", MotionRepeat::Loop)];
const DRIFTS: &[(&str, MotionDrift)] =
    &[("keep", MotionDrift::Keep), ("remove", MotionDrift::Remove)];

macro_rules! step {
    ($($field:ident).+) => {
        Key {
            name: "step",
            about: words("ステップ", "dance step"),
            kind: Kind::Name {
                what: words("ステップ", "dance step"),
                choices: || DanceStep::ALL.iter().map(|step| step.id()).collect(),
                get: |design| design.$($field).+.id(),
                set: |design, name| {
                    design.$($field).+ = DanceStep::from_id(name).unwrap_or(design.$($field).+);
                },
            },
        }
    };
}

const HIP_LIFTS: &[(&str, HipLift)] = &[
    ("weighted-side", HipLift::WeightedSide),
    ("free-side", HipLift::FreeSide),
];
const HIP_LEADS: &[(&str, HipLead)] = &[
    ("other-foot", HipLead::OtherFoot),
    ("stepping-foot", HipLead::SteppingFoot),
];
const ARM_STYLES: &[(&str, ArmStyle)] = &[
    ("of-step", ArmStyle::OfStep),
    ("open", ArmStyle::Open),
    ("hands-on-hips", ArmStyle::HandsOnHips),
    ("ready", ArmStyle::Ready),
    ("open-up", ArmStyle::OpenUp),
    ("low-front", ArmStyle::LowFront),
    ("rounded", ArmStyle::Rounded),
];
const ARMS_OF_PART: &[(&str, Option<ArmStyle>)] = &[
    ("of-dance", None),
    ("of-step", Some(ArmStyle::OfStep)),
    ("open", Some(ArmStyle::Open)),
    ("hands-on-hips", Some(ArmStyle::HandsOnHips)),
    ("ready", Some(ArmStyle::Ready)),
    ("open-up", Some(ArmStyle::OpenUp)),
    ("low-front", Some(ArmStyle::LowFront)),
    ("rounded", Some(ArmStyle::Rounded)),
];
const FORMATIONS: &[(&str, Option<Formation>)] = &[
    ("as-before", None),
    (Formation::Rows.id(), Some(Formation::Rows)),
    (Formation::Line.id(), Some(Formation::Line)),
    (Formation::Wedge.id(), Some(Formation::Wedge)),
    (Formation::Circle.id(), Some(Formation::Circle)),
];
const MOODS: &[(&str, Option<StageMood>)] = &[
    ("as-before", None),
    (StageMood::Tender.id(), Some(StageMood::Tender)),
    (StageMood::Joyful.id(), Some(StageMood::Joyful)),
    (StageMood::Sea.id(), Some(StageMood::Sea)),
    (StageMood::Solemn.id(), Some(StageMood::Solemn)),
];
const ARM_MANNERS: &[(&str, ArmManner)] =
    &[("curved", ArmManner::Curved), ("crisp", ArmManner::Crisp)];
const HANDS: &[(&str, Hands)] = &[
    ("soft", Hands::Soft),
    ("flat", Hands::Flat),
    ("fist", Hands::Fist),
];
const AMI_TURNS: &[(&str, AmiTurn)] = &[("akau", AmiTurn::Akau), ("hema", AmiTurn::Hema)];
const SIDES: &[(&str, Side)] = &[("right", Side::Right), ("left", Side::Left)];

const ARM_STYLE: Words = words("腕の形", "arm style");

/// The dance and its manner. The school is read before the rest, wherever it stands, and sets what
/// is left out.
pub(super) const MOTION: Table = Table {
    name: "motion",
    about: words(
        "踊り。ハーラウごとに違い、クムの教えが先",
        "what is danced; hālau differ, and a kumu's rule comes first",
    ),
    keys: &[
        Key {
            name: "school",
            about: words(
                "流儀。下の項目のうち書かれていないものを決める",
                "manner; sets those keys below that are left out",
            ),
            kind: Kind::Name {
                what: words("流儀", "school"),
                choices: || SCHOOLS.iter().map(|school| school.id).collect(),
                get: |design| design.motion.school.id,
                set: |design, name| {
                    if let Some(school) = School::from_id(name) {
                        design.motion.follow(school);
                    }
                },
            },
        },
        step!(motion.step),
        number!(
            "tempo_bpm",
            30.0..=240.0,
            motion.tempo_bpm,
            "1分間の拍数",
            "counts per minute"
        ),
        number_if_known!(
            "duration_s",
            0.5..=600.0,
            motion.duration_s,
            "踊りの長さ。書かなければ振付の長さ、振付がなければ 12 秒",
            "length of the dance; left out: that of its parts, or 12 s"
        ),
        number!(
            "sway_ratio",
            0.0..=1.6,
            motion.sway_ratio,
            "腰の揺れの倍率",
            "factor on the sway of the hips"
        ),
        number!(
            "knee_deg",
            10.0..=65.0,
            motion.knee_deg,
            "ひざの曲げ",
            "bend of the knees"
        ),
        number!(
            "heel_ratio",
            0.0..=0.03,
            motion.heel_ratio,
            "自由な足のかかとの高さ÷身長",
            "height of the free heel over the stature"
        ),
        number!(
            "step_ratio",
            0.0..=0.26,
            motion.step_ratio,
            "横への一歩÷身長",
            "a step to the side over the stature"
        ),
        number!(
            "stance_ratio",
            0.1..=0.3,
            motion.stance_ratio,
            "立つときの足首の間隔÷身長",
            "distance of the ankles while standing over the stature"
        ),
        number!(
            "toe_out_deg",
            0.0..=30.0,
            motion.toe_out_deg,
            "つま先の開き",
            "turn-out of each foot"
        ),
        number!(
            "eight_ratio",
            0.0..=0.02,
            motion.eight_ratio,
            "腰の八の字の深さ÷身長",
            "depth of the hips' figure of eight over the stature"
        ),
        choice!(
            "hip_lift",
            words("腰の上げ方", "hip lift"),
            HIP_LIFTS,
            motion.hip_lift,
            "どちらの腰が上がるか",
            "which hip is higher"
        ),
        choice!(
            "hip_lead",
            words("腰の出し方", "hip lead"),
            HIP_LEADS,
            motion.hip_lead,
            "拍で腰がどちらにあるか",
            "hips on the count"
        ),
        choice!(
            "arms",
            ARM_STYLE,
            ARM_STYLES,
            motion.arms,
            "腕の動き",
            "what the arms do"
        ),
        choice!(
            "arm_manner",
            words("腕の動かし方", "arm manner"),
            ARM_MANNERS,
            motion.arm_manner,
            "なめらかか、拍で止まるか",
            "curved, or stopping on the count"
        ),
        choice!(
            "hands",
            words("手の形", "shape of hands"),
            HANDS,
            motion.hands,
            "手の形",
            "what the hands are like"
        ),
        choice!(
            "ami_turn",
            words("アミの回り方", "turn of the ʻami"),
            AMI_TURNS,
            motion.ami_turn,
            "回る向き",
            "way round"
        ),
        Key {
            name: "file",
            about: words(
                "ステップのかわりに踊る記録（BVH・VRMA・glTF）。この文書から見た場所",
                "recording (BVH, VRMA, glTF) that is danced instead of a step; its place from this document",
            ),
            kind: Kind::Text {
                what: words("ファイルの名前", "the name of a file"),
                get: |design| design.motion.file.as_ref().map(|file| file.name.as_str()),
                set: |design, name| design.motion.file = Some(LinkedFile::named(name)),
            },
        },
        Key {
            name: "clip",
            about: words(
                "記録の中のどのアニメーションか。名前か、1 から数えた番号",
                "which animation of the recording: its name, or its number, counted from 1",
            ),
            kind: Kind::Text {
                what: words(
                    "アニメーションの名前か番号",
                    "the name or number of an animation",
                ),
                get: |design| {
                    let clip = design.motion.clip.as_str();
                    (!clip.is_empty()).then_some(clip)
                },
                set: |design, clip| clip.clone_into(&mut design.motion.clip),
            },
        },
        choice!(
            "repeat",
            words("くり返し方", "way of repeating"),
            REPEATS,
            motion.repeat,
            "記録の終わりのあと",
            "what follows the end of a recording"
        ),
        choice!(
            "drift",
            words("移動の扱い", "treatment of drift"),
            DRIFTS,
            motion.drift,
            "記録の中で進んだ道のり",
            "the way that is gone in a recording"
        ),
    ],
};

/// The keys of one part in `[[motion.part]]`.
pub const PART_KEYS: &[Key<PartDesign>] = &[
    step!(step),
    choice!(
        "side",
        words("側", "side"),
        SIDES,
        side,
        "右から始めるか、左からか",
        "which side begins"
    ),
    Key {
        name: "beat_count",
        about: words(
            "拍数。ステップのひと区切りの倍数",
            "counts: whole phrases of the step",
        ),
        kind: Kind::Count {
            min: 1,
            max: 256,
            get: |part| Some(u64::from(part.beat_count)),
            set: |part, value| part.beat_count = u32::try_from(value).unwrap_or(u32::MAX),
        },
    },
    number!(
        "facing_deg",
        -720.0..=720.0,
        facing_deg,
        "体の向き。正面から踊り手の左へ",
        "where she faces, to her left of the front"
    ),
    choice!(
        "arms",
        ARM_STYLE,
        ARMS_OF_PART,
        arms,
        "腕の動き",
        "what the arms do"
    ),
    number_if_known!(
        "tempo_bpm",
        30.0..=240.0,
        tempo_bpm,
        "ここからの1分間の拍数。書かなければそのまま",
        "counts per minute from here on; left out: as before"
    ),
    choice!(
        "formation",
        words("隊形", "formation"),
        FORMATIONS,
        formation,
        "この部分のあいだにグループが歩いて移る隊形。ひとりで踊るときは動かない",
        "the formation that a group walks to in this part; one dancer stays"
    ),
    choice!(
        "mood",
        words("照明の気分", "mood of the lamps"),
        MOODS,
        mood,
        "ここからの劇場の照明。動画で移り変わる",
        "the lamps of a theater from here on; films fade to them"
    ),
];
