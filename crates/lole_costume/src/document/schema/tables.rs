//! Every key of the design document, one row each.
//!
//! Reading, checking, writing and the messages all walk this table, so a key that is added here is
//! read, refused, written and explained.

use lole_cloth::collision::penalty::{CapsuleShape, Response};
use lole_cloth::method::explicit::ContactEvaluation;
use lole_cloth::wind::WindLaw;
use lole_language::words;

use super::motion::MOTION;
use super::{Key, Kind, Table};
use crate::document::{BodyShapes, MethodName, WindModel};
use crate::fabrics::{PRESETS, Preset};
use crate::print::{PrintDesign, PrintMotif};

/// Largest seed: what fits the integers of TOML.
const MAX_SEED: u64 = i64::MAX as u64;

macro_rules! number {
    ($name:literal, $min:literal..=$max:literal, $table:ident.$field:ident, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Number {
                min: $min,
                max: $max,
                get: |design| Some(design.$table.$field),
                set: |design, value| design.$table.$field = value,
            },
        }
    };
}

macro_rules! number_if_known {
    ($name:literal, $min:literal..=$max:literal, $table:ident.$field:ident, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Number {
                min: $min,
                max: $max,
                get: |design| design.$table.$field,
                set: |design, value| design.$table.$field = Some(value),
            },
        }
    };
}

macro_rules! count {
    ($name:literal, $min:literal..=$max:literal, $table:ident.$field:ident, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Count {
                min: $min,
                max: $max,
                get: |design| Some(u64::from(design.$table.$field)),
                set: |design, value| {
                    design.$table.$field = u32::try_from(value).unwrap_or(u32::MAX);
                },
            },
        }
    };
}

macro_rules! seed {
    ($table:ident, $japanese:literal, $about:literal) => {
        Key {
            name: "seed",
            about: words($japanese, $about),
            kind: Kind::Count {
                min: 0,
                max: MAX_SEED,
                get: |design| Some(design.$table.seed),
                set: |design, value| design.$table.seed = value,
            },
        }
    };
}

macro_rules! color {
    ($name:literal, $field:ident, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Color {
                get: |design| design.print.$field,
                set: |design, value| design.print.$field = Some(value),
            },
        }
    };
}

/// A choice among `(id, value)` pairs that this file names.
macro_rules! choice {
    ($name:literal, $what:expr, $list:ident, $table:ident.$field:ident, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Name {
                what: $what,
                choices: || $list.iter().map(|(id, _)| *id).collect(),
                get: |design| {
                    let found = $list
                        .iter()
                        .find(|(_, value)| *value == design.$table.$field);
                    found.map_or($list[0].0, |(id, _)| id)
                },
                set: |design, name| {
                    if let Some((_, value)) = $list.iter().find(|(id, _)| *id == name) {
                        design.$table.$field = *value;
                    }
                },
            },
        }
    };
}

const MOTIFS: &[(&str, PrintMotif)] =
    &[("hibiscus", PrintMotif::Hibiscus), ("ulu", PrintMotif::Ulu)];
const WIND_LAWS: &[(&str, WindLaw)] = &[
    ("spherical", WindLaw::Spherical),
    ("literal-scalar", WindLaw::LiteralScalar),
];
const WIND_MODELS: &[(&str, WindModel)] = &[
    ("uniform", WindModel::Uniform),
    ("triangles", WindModel::Triangles),
];
const BODIES: &[(&str, BodyShapes)] = &[
    (BodyShapes::Skin.id(), BodyShapes::Skin),
    (BodyShapes::Capsules.id(), BodyShapes::Capsules),
    (BodyShapes::TwoCylinders.id(), BodyShapes::TwoCylinders),
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
pub const TABLES: &[Table] = &[DANCER, SKIRT, FABRIC, PRINT, MOTION, WIND, METHOD];

const DANCER: Table = Table {
    name: "dancer",
    about: words(
        "採寸（cm）。測っていないものは書かない",
        "the tape, in cm; leave out what was not measured",
    ),
    keys: &[
        number_if_known!(
            "stature_cm",
            130.0..=195.0,
            dancer.stature_cm,
            "頭のてっぺんから床まで",
            "crown to floor"
        ),
        number_if_known!(
            "bust_cm",
            60.0..=140.0,
            dancer.bust_cm,
            "胸のいちばん太いところ",
            "fullest part of the bust"
        ),
        number_if_known!(
            "waist_cm",
            50.0..=130.0,
            dancer.waist_cm,
            "胴のいちばん細いところ",
            "narrowest part of the trunk"
        ),
        number_if_known!(
            "hip_cm",
            70.0..=150.0,
            dancer.hip_cm,
            "腰のいちばん太いところ",
            "fullest part of the hips"
        ),
        number_if_known!(
            "inseam_cm",
            52.0..=97.5,
            dancer.inseam_cm,
            "股から床まで",
            "crotch to floor"
        ),
    ],
};

const SKIRT: Table = Table {
    name: "skirt",
    about: words("パウスカート", "the pāʻū skirt"),
    keys: &[
        number!(
            "hem_height_cm",
            0.0..=100.0,
            skirt.hem_height_cm,
            "床から裾まで",
            "hem above the floor"
        ),
        number_if_known!(
            "worn_height_cm",
            40.0..=130.0,
            skirt.worn_height_cm,
            "床からいちばん下のゴムまで。書かなければ腰骨の前",
            "lowest elastic above the floor; left out: the front hip bones"
        ),
        number!(
            "gather_ratio",
            1.0..=5.0,
            skirt.gather_ratio,
            "布の長さ÷ヒップ",
            "flat length over hip girth"
        ),
        count!(
            "elastic_row_count",
            1..=6,
            skirt.elastic_row_count,
            "ゴムの段数",
            "rows of elastic"
        ),
        number!(
            "elastic_ratio",
            0.8..=0.9,
            skirt.elastic_ratio,
            "縮んだゴムの長さ÷はく位置の胴回り",
            "relaxed elastic over the girth where it is worn"
        ),
        number!(
            "header_cm",
            0.0..=15.0,
            skirt.header_cm,
            "いちばん上のゴムより上のフリル",
            "ruffle above the top elastic"
        ),
        number!(
            "casing_cm",
            0.5..=10.0,
            skirt.casing_cm,
            "ゴム通しの幅",
            "height of one casing"
        ),
        number!(
            "casing_gap_cm",
            0.0..=15.0,
            skirt.casing_gap_cm,
            "ゴム通しの間隔",
            "between two casings"
        ),
        number!(
            "hem_allowance_cm",
            0.0..=30.0,
            skirt.hem_allowance_cm,
            "裾上げの分",
            "cloth for the hem"
        ),
        count!(
            "column_count",
            32..=4096,
            skirt.column_count,
            "横まわりの質点の数",
            "particles around"
        ),
        count!(
            "row_count",
            8..=512,
            skirt.row_count,
            "上から裾までの質点の数",
            "particles from top to hem"
        ),
        seed!(
            skirt,
            "ギャザーの寄り方（乱数の種）",
            "chance of the gathers"
        ),
    ],
};

const FABRIC: Table = Table {
    name: "fabric",
    about: words(
        "棚の布と、本物の布で測った値",
        "a fabric from the shelf, and figures measured on the real cloth",
    ),
    keys: &[
        Key {
            name: "preset",
            about: words("棚の布", "fabric from the shelf"),
            kind: Kind::Name {
                what: words("布", "fabric"),
                choices: || PRESETS.iter().map(|preset| preset.id).collect(),
                get: |design| design.fabric.preset.id,
                set: |design, name| {
                    if let Some(preset) = Preset::from_id(name) {
                        design.fabric.preset = preset;
                    }
                },
            },
        },
        number!(
            "width_cm",
            30.0..=400.0,
            fabric.width_cm,
            "布の耳から耳まで",
            "selvage to selvage"
        ),
        number_if_known!(
            "areal_density_g_per_m2",
            10.0..=1000.0,
            fabric.areal_density_g_per_m2,
            "布の重さ",
            "weight"
        ),
        number_if_known!(
            "thickness_mm",
            0.02..=5.0,
            fabric.thickness_mm,
            "厚さ",
            "thickness"
        ),
        number_if_known!(
            "stretch_warp_n_per_m",
            1.0..=1e6,
            fabric.stretch_warp_n_per_m,
            "横まわりの伸びにくさ",
            "around the skirt"
        ),
        number_if_known!(
            "stretch_weft_n_per_m",
            1.0..=1e6,
            fabric.stretch_weft_n_per_m,
            "丈の方向の伸びにくさ",
            "down the skirt"
        ),
        number_if_known!(
            "shear_n_per_m",
            0.1..=1e6,
            fabric.shear_n_per_m,
            "バイアスの伸びにくさ",
            "across the bias"
        ),
        number_if_known!(
            "bend_warp_un_m",
            0.01..=1e5,
            fabric.bend_warp_un_m,
            "横まわりの曲げにくさ",
            "bending around"
        ),
        number_if_known!(
            "bend_weft_un_m",
            0.01..=1e5,
            fabric.bend_weft_un_m,
            "丈の方向の曲げにくさ",
            "bending down"
        ),
        number_if_known!(
            "twist_un_m",
            0.01..=1e5,
            fabric.twist_un_m,
            "ねじりにくさ",
            "twisting"
        ),
        number_if_known!(
            "friction_coefficient",
            0.0..=2.0,
            fabric.friction_coefficient,
            "肌との摩擦",
            "on skin"
        ),
        number_if_known!(
            "drag_per_s",
            0.0..=50.0,
            fabric.drag_per_s,
            "空気の抵抗",
            "air drag"
        ),
    ],
};

const PRINT: Table = Table {
    name: "print",
    about: words(
        "布の柄。色は \"#rrggbb\"",
        "what is printed on the cloth; colors as \"#rrggbb\"",
    ),
    keys: &[
        choice!(
            "motif",
            words("柄", "motif"),
            MOTIFS,
            print.motif,
            "描くもの",
            "what is drawn"
        ),
        Key {
            name: "colorway",
            about: words("色の組み合わせ", "ready set of colors"),
            kind: Kind::Name {
                what: words("配色", "colorway"),
                choices: || PrintDesign::COLORWAYS.to_vec(),
                get: |design| design.print.colorway,
                set: |design, name| {
                    let found = PrintDesign::COLORWAYS
                        .iter()
                        .find(|choice| **choice == name);
                    design.print.colorway = found.unwrap_or(&design.print.colorway);
                },
            },
        },
        color!(
            "ground",
            ground,
            "地の色を変えるとき",
            "instead of the colorway's ground"
        ),
        color!(
            "flower",
            flower,
            "花の色を変えるとき",
            "instead of the colorway's flowers"
        ),
        color!(
            "leaf",
            leaf,
            "葉の色を変えるとき",
            "instead of the colorway's leaves"
        ),
        color!(
            "shadow",
            shadow,
            "奥の柄の色を変えるとき",
            "instead of the colorway's second layer"
        ),
        number!(
            "repeat_cm",
            5.0..=200.0,
            print.repeat_cm,
            "柄のひと送り",
            "one repeat on the cloth"
        ),
        seed!(print, "柄の置き方（乱数の種）", "chance of the places"),
    ],
};

const WIND: Table = Table {
    name: "wind",
    about: words(
        "回る風。いちばん強いときの速さ",
        "a turning wind, by its strongest breath",
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
            "風の式の読み方: 回るか、対角線を行き来するか",
            "reading of the equation: turning, or to and fro"
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
