//! Every key of the design document, one row each.
//!
//! Reading, checking, writing and the messages all walk this table, so a key that is added here is
//! read, refused, written and explained.

use lole_body::{Figure, HairStyle, Makeup};
use lole_cloth::collision::penalty::{CapsuleShape, Response};
use lole_cloth::method::explicit::ContactEvaluation;
use lole_cloth::wind::WindLaw;
use lole_language::words;
use lole_pattern::Tailored;

use super::alterations::ALTERATIONS;
use super::cost::COST;
use super::face::FACE;
use super::motion::MOTION;
use super::{Key, Kind, Table};
use crate::document::{
    BodyShapes, CameraWork, Gaze, LinkedFile, MethodName, MotionBlur, StageMood, StageSet,
    Uncrossed, WindModel,
};
use crate::fabrics::{PRESETS, Preset};

/// Largest seed: what fits the integers of TOML.
pub(super) const MAX_SEED: u64 = i64::MAX as u64;

const FIGURES: &[(&str, Figure)] = &[
    (Figure::OfStature.id(), Figure::OfStature),
    (Figure::Woman.id(), Figure::Woman),
    (Figure::Man.id(), Figure::Man),
    (Figure::Child.id(), Figure::Child),
];
const HAIR_STYLES: &[(&str, HairStyle)] = &[
    (HairStyle::OfFigure.id(), HairStyle::OfFigure),
    (HairStyle::Bun.id(), HairStyle::Bun),
    (HairStyle::Long.id(), HairStyle::Long),
    (HairStyle::Short.id(), HairStyle::Short),
    (HairStyle::Bob.id(), HairStyle::Bob),
];
const MAKEUPS: &[(&str, Makeup)] = &[
    (Makeup::OfFigure.id(), Makeup::OfFigure),
    (Makeup::Bare.id(), Makeup::Bare),
    (Makeup::Light.id(), Makeup::Light),
    (Makeup::Stage.id(), Makeup::Stage),
];
const WIND_LAWS: &[(&str, WindLaw)] = &[
    ("spherical", WindLaw::Spherical),
    ("literal-scalar", WindLaw::LiteralScalar),
    ("steady", WindLaw::Steady),
];
const WIND_MODELS: &[(&str, WindModel)] = &[
    ("uniform", WindModel::Uniform),
    ("triangles", WindModel::Triangles),
];
const SETS: &[(&str, StageSet)] = &[
    (StageSet::Studio.id(), StageSet::Studio),
    (StageSet::Plain.id(), StageSet::Plain),
    (StageSet::Theater.id(), StageSet::Theater),
    (StageSet::Beach.id(), StageSet::Beach),
    (StageSet::Lawn.id(), StageSet::Lawn),
];
const MOODS: &[(&str, StageMood)] = &[
    (StageMood::Tender.id(), StageMood::Tender),
    (StageMood::Joyful.id(), StageMood::Joyful),
    (StageMood::Sea.id(), StageMood::Sea),
    (StageMood::Solemn.id(), StageMood::Solemn),
];
const BLURS: &[(&str, MotionBlur)] = &[
    (MotionBlur::None.id(), MotionBlur::None),
    (MotionBlur::Film.id(), MotionBlur::Film),
    (MotionBlur::Long.id(), MotionBlur::Long),
];
const GAZES: &[(&str, Gaze)] = &[
    (Gaze::Hands.id(), Gaze::Hands),
    (Gaze::Ahead.id(), Gaze::Ahead),
];
const CAMERAS: &[(&str, CameraWork)] = &[
    (CameraWork::Drift.id(), CameraWork::Drift),
    (CameraWork::Still.id(), CameraWork::Still),
    (CameraWork::Turntable.id(), CameraWork::Turntable),
    (CameraWork::Cuts.id(), CameraWork::Cuts),
];
const BODIES: &[(&str, BodyShapes)] = &[
    (BodyShapes::Skin.id(), BodyShapes::Skin),
    (BodyShapes::Capsules.id(), BodyShapes::Capsules),
    (BodyShapes::TwoCylinders.id(), BodyShapes::TwoCylinders),
];
const UNCROSSED: &[(&str, Uncrossed)] = &[
    (Uncrossed::Always.id(), Uncrossed::Always),
    (Uncrossed::InTime.id(), Uncrossed::InTime),
    (Uncrossed::Never.id(), Uncrossed::Never),
];
const CONTACT_EVALUATIONS: &[(&str, ContactEvaluation)] = &[
    ("per-stage", ContactEvaluation::PerStage),
    ("per-step", ContactEvaluation::PerStep),
];
const RESPONSES: &[(&str, Response)] = &[
    ("clamped", Response::Clamped),
    ("as-printed", Response::AsPrinted),
];
const CAPSULE_SHAPES: &[(&str, CapsuleShape)] = &[
    ("capped", CapsuleShape::Capped),
    (
        "literal-infinite-cylinder",
        CapsuleShape::LiteralInfiniteCylinder,
    ),
];

/// The tables in the order they are written.
pub const TABLES: &[Table] = &[
    DANCER,
    ALTERATIONS,
    FACE,
    SKIRT,
    FABRIC,
    PRINT,
    COST,
    MOTION,
    WIND,
    STAGE,
    METHOD,
];

const DANCER: Table = Table {
    name: "dancer",
    about: words(
        "採寸（cm）。測っていないものは書かない",
        "the tape, in cm; leave out what was not measured",
    ),
    keys: &[
        Key {
            name: "file",
            about: words(
                "採寸した踊り手のかわりに着るアバター（VRM・glTF）。この文書から見た場所",
                "avatar (VRM, glTF) that is dressed instead; its place from this document",
            ),
            kind: Kind::Text {
                what: words("ファイルの名前", "the name of a file"),
                get: |design| design.dancer.file.as_ref().map(|file| file.name.as_str()),
                set: |design, name| design.dancer.file = Some(LinkedFile::named(name)),
            },
        },
        choice!(
            "figure",
            words("体つき", "figure"),
            FIGURES,
            dancer.figure,
            "だれの体つきか。of-stature は身長から",
            "whose proportions; of-stature goes by the stature"
        ),
        number_if_known!(
            "stature_cm",
            100.0..=195.0,
            dancer.stature_cm,
            "頭のてっぺんから床まで",
            "crown to floor"
        ),
        number_if_known!(
            "bust_cm",
            48.0..=150.0,
            dancer.bust_cm,
            "胸のいちばん太いところ",
            "fullest part of the bust"
        ),
        number_if_known!(
            "underbust_cm",
            45.0..=130.0,
            dancer.underbust_cm,
            "胸のすぐ下",
            "under the bust"
        ),
        number_if_known!(
            "waist_cm",
            45.0..=130.0,
            dancer.waist_cm,
            "胴のいちばん細いところ",
            "narrowest part of the trunk"
        ),
        number_if_known!(
            "high_hip_cm",
            48.0..=150.0,
            dancer.high_hip_cm,
            "腰骨の前の出っぱりを通る一周",
            "over the front points of the hip bones"
        ),
        number_if_known!(
            "hip_cm",
            55.0..=150.0,
            dancer.hip_cm,
            "腰のいちばん太いところ",
            "fullest part of the hips"
        ),
        number_if_known!(
            "thigh_cm",
            28.0..=90.0,
            dancer.thigh_cm,
            "股のすぐ下の片脚",
            "one thigh just below the crotch"
        ),
        number_if_known!(
            "knee_cm",
            20.0..=60.0,
            dancer.knee_cm,
            "ひざの皿の真ん中",
            "one knee at the middle of the kneecap"
        ),
        number_if_known!(
            "calf_cm",
            20.0..=60.0,
            dancer.calf_cm,
            "ふくらはぎのいちばん太いところ",
            "fullest part of one calf"
        ),
        number_if_known!(
            "ankle_cm",
            13.0..=36.0,
            dancer.ankle_cm,
            "足首のいちばん細いところ",
            "one ankle at its narrowest"
        ),
        number_if_known!(
            "inseam_cm",
            38.0..=97.5,
            dancer.inseam_cm,
            "股から床まで",
            "crotch to floor"
        ),
        number_if_known!(
            "waist_height_cm",
            55.0..=130.0,
            dancer.waist_height_cm,
            "ウエストの巻き尺から床まで",
            "waist tape to floor"
        ),
        number_if_known!(
            "shoulder_breadth_cm",
            22.0..=52.0,
            dancer.shoulder_breadth_cm,
            "肩先から肩先まで",
            "shoulder point to shoulder point"
        ),
        number_if_known!(
            "upper_arm_length_cm",
            16.0..=42.0,
            dancer.upper_arm_length_cm,
            "肩先からひじまで",
            "shoulder point to elbow"
        ),
        tailored!(Tailored::Neck),
        tailored!(Tailored::BackBreadth),
        tailored!(Tailored::ChestBreadth),
        tailored!(Tailored::BackLength),
        tailored!(Tailored::FrontLength),
        tailored!(Tailored::BustPoints),
        tailored!(Tailored::UpperArm),
        tailored!(Tailored::Wrist),
        tailored!(Tailored::ArmLength),
        tailored!(Tailored::CrotchLength),
        tailored!(Tailored::Head),
        number_if_known!(
            "age_years",
            3.0..=100.0,
            dancer.age_years,
            "顔と髪に見える年齢（歳）",
            "how old face and hair look"
        ),
        choice!(
            "hair",
            words("髪型", "hair style"),
            HAIR_STYLES,
            dancer.hair,
            "髪型。of-figure は女性がお団子、男性が短髪、子どもがおかっぱ",
            "how the hair is worn; of-figure: a woman's bun, a man's short cut, a child's bob"
        ),
        choice!(
            "makeup",
            words("化粧", "makeup"),
            MAKEUPS,
            dancer.makeup,
            "化粧。of-figure は女性がうすく、bare はなし、light はうすく、stage は舞台用",
            "how the face is made up; of-figure: a woman's light; bare: none; stage: red lips and dark lids"
        ),
        color!(
            "skin_color",
            dancer.skin_color,
            "肌の色を変えるとき",
            "instead of the usual skin"
        ),
        color!(
            "hair_color",
            dancer.hair_color,
            "髪の色を変えるとき",
            "instead of the usual hair"
        ),
        color!(
            "leotard_color",
            dancer.leotard_color,
            "レオタードの色を変えるとき",
            "instead of the usual leotard"
        ),
    ],
};

const SKIRT: Table = Table {
    name: "skirt",
    about: words("パウスカート", "the pāʻū skirt"),
    keys: skirt_keys!(Key {
        name: "worn",
        about: words(
            "着るか（yes）、代わりに別のスカートや服だけを着るか（no）",
            "yes, or no where another skirt or a dress is worn instead",
        ),
        kind: Kind::Name {
            what: words("答え", "yes or no"),
            choices: || vec![YES, NO],
            get: |design| if design.skirt.is_worn { YES } else { NO },
            set: |design, name| design.skirt.is_worn = name != NO,
        },
    }),
};

/// Whether the skirt is worn.
const YES: &str = "yes";
const NO: &str = "no";

const FABRIC: Table = Table {
    name: "fabric",
    about: words(
        "棚の布と、本物の布で測った値",
        "a fabric from the shelf, and figures measured on the real cloth",
    ),
    keys: fabric_keys!(),
};

const PRINT: Table = Table {
    name: "print",
    about: words(
        "布の柄。色は \"#rrggbb\"",
        "what is printed on the cloth; colors as \"#rrggbb\"",
    ),
    keys: print_keys!(),
};

const WIND: Table = Table {
    name: "wind",
    about: words(
        "回る風（いちばん強いときの速さ）か、一方から吹く風",
        "a turning wind, by its strongest breath, or a steady one",
    ),
    keys: &[
        number!(
            "speed_m_per_s",
            0.0..=20.0,
            wind.speed_m_per_s,
            "0 なら無風",
            "0 is still air"
        ),
        choice!(
            "law",
            words("風の式の読み方", "reading of the wind's equation"),
            WIND_LAWS,
            wind.law,
            "風の吹き方: 式のとおり回るか、対角線を行き来するか、一方から吹くか",
            "the equation's turning wind, its wind to and fro, or a steady one"
        ),
        number!(
            "from_deg",
            -180.0..=180.0,
            wind.from_deg,
            "steady の風が来る向き。0 は踊り手の正面、90 は踊り手の左から",
            "where a steady wind comes from: 0 is her front, 90 her left"
        ),
        choice!(
            "model",
            words("風の当て方", "model of the wind"),
            WIND_MODELS,
            wind.model,
            "xpbd の風: どの質点にも同じか、三角形の広さと向きによるか",
            "xpbd: wind on every particle alike, or on triangles by area and direction"
        ),
        number!(
            "gust_ratio",
            0.0..=1.0,
            wind.gust_ratio,
            "triangles の突風の強さ。風の速さに対する比",
            "gusts of triangles, over the wind's speed"
        ),
        seed!(wind, "突風を決める種", "what the gusts follow from"),
    ],
};

const STAGE: Table = Table {
    name: "stage",
    about: words(
        "写真と動画の背景と光",
        "background and light of pictures and film",
    ),
    keys: &[
        choice!(
            "set",
            words("背景", "set"),
            SETS,
            stage.set,
            "studio は写真スタジオ、plain は白、theater は劇場、beach は夕暮れの浜、lawn は芝生と山",
            "a photographer's studio, plain white, a theater, a beach at dusk, or a lawn before mountains"
        ),
        choice!(
            "mood",
            words("照明の気分", "mood of the lamps"),
            MOODS,
            stage.mood,
            "theater の照明: tender は紫、joyful は金、sea は青、solemn は暗く",
            "lamps of the theater: violet, gold, blue, or dark but for the lamp on her"
        ),
        choice!(
            "camera",
            words("動画の撮り方", "camera of the film"),
            CAMERAS,
            stage.camera,
            "動画の撮り方: drift はゆっくり左右に、still は正面から、turntable は 12 秒でひとまわり、cuts はフレーズごとに切り替える",
            "how the film is shot: slowly from side to side, from the front, once around in 12 s, or cut on phrases"
        ),
        choice!(
            "motion_blur",
            words("動きのぼけ", "motion blur"),
            BLURS,
            stage.motion_blur,
            "動画で動くものの流れ方: none は流れない、film は映画のように、long は長く。描く時間が数倍になる",
            "how what moves is smeared in the film: not, as in films, or long; drawing takes several times as long"
        ),
        choice!(
            "gaze",
            words("視線", "gaze"),
            GAZES,
            stage.gaze,
            "視線: hands は語る手を目で追う、ahead はまっすぐ前を見る",
            "where she looks: at the hand that tells the story, or straight ahead"
        ),
        Key {
            name: "title",
            about: words(
                "動画のはじめに出し、本・注文書・型紙に書く題名。なければファイルの名前",
                "what is written over the beginning of a film, and on booklets, orders and patterns instead of the file's name",
            ),
            kind: Kind::Text {
                what: words("題名", "title"),
                get: |design| Some(design.stage.title.as_str()).filter(|title| !title.is_empty()),
                set: |design, title| title.clone_into(&mut design.stage.title),
            },
        },
    ],
};

const METHOD: Table = Table {
    name: "method",
    about: words("布の計算のしかた", "how the cloth is computed"),
    keys: &[
        Key {
            name: "name",
            about: words("方法", "method"),
            kind: Kind::Name {
                what: words("方法", "method"),
                choices: || MethodName::ALL.iter().map(|method| method.id()).collect(),
                get: |design| design.method.name.id(),
                set: |design, name| {
                    design.method.name = MethodName::from_id(name).unwrap_or(design.method.name);
                },
            },
        },
        Key {
            name: "substep_count",
            about: words(
                "1コマを分ける数。書かなければ方法にまかせる",
                "time slices of a picture; left out: the method's choice",
            ),
            kind: Kind::Count {
                min: 1,
                max: 10_000,
                get: |design| design.method.substep_count.map(u64::from),
                set: |design, value| design.method.substep_count = u32::try_from(value).ok(),
            },
        },
        choice!(
            "body",
            words("衝突の体", "body for contact"),
            BODIES,
            method.body,
            "布が当たる体の形。skin は肌そのもの（論文の方法ではカプセル）",
            "what the cloth meets as a body; skin is the drawn skin (capsules for the paper's methods)"
        ),
        count!(
            "capsule_count",
            1..=40,
            method.capsule_count,
            "体のカプセルの数",
            "capsules of the body"
        ),
        choice!(
            "uncrossed",
            words(
                "布のすり抜けどめ",
                "keeping cloth from passing through itself"
            ),
            UNCROSSED,
            method.uncrossed,
            "xpbd: 布が布をすり抜けないようにするか。いつでも (always)、画面では間に合うあいだだけ (in-time)、しない (never)",
            "xpbd: whether cloth is kept from passing through itself: always, in the window only while it keeps pace (in-time), or never"
        ),
        choice!(
            "contact_evaluation",
            words("接触を調べる時", "time of contact"),
            CONTACT_EVALUATIONS,
            method.contact_evaluation,
            "論文の方法で、接触を段ごとに調べるか、1回だけか",
            "methods of the paper: contact in every stage, or once a step"
        ),
        choice!(
            "penalty",
            words("押し返し方", "penalty"),
            RESPONSES,
            method.penalty,
            "論文の方法で、肌が布を引くことがあるか",
            "methods of the paper: whether skin may pull"
        ),
        number_if_known!(
            "bounce_ratio",
            0.0..=1.0,
            method.bounce_ratio,
            "論文の方法で、当たった布が戻る速さの割合",
            "methods of the paper: speed with which cloth leaves the skin, over that with which it came"
        ),
        choice!(
            "capsule_shape",
            words("カプセルの端", "end of capsules"),
            CAPSULE_SHAPES,
            method.capsule_shape,
            "論文の方法で、カプセルに端があるか",
            "methods of the paper: whether capsules end"
        ),
    ],
};
