//! What is wrong with a recording, in one sentence of each language.

use lole_language::{Bilingual, Sentence};
use thiserror::Error;

/// Why a recording cannot be read or danced.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// The text is not a recording from some line on.
    #[error("line {line}: {problem}")]
    Syntax {
        /// Line, counted from 1.
        line: usize,
        /// What is wrong there, and what to do.
        problem: Sentence,
    },
    /// It is larger than any dance.
    #[error("the recording has {count} {what}, over the {limit} that are read; cut it shorter")]
    TooLarge {
        /// What there are too many of.
        what: &'static str,
        /// How many.
        count: usize,
        /// How many are read.
        limit: usize,
    },
    /// It has joints and no motion.
    #[error("the recording has no frames: it is a skeleton without a dance")]
    NoFrames,
    /// Bones that a dancer needs have no joint.
    #[error(
        "no joint was recognized for {bones}; `lole inspect` lists the joints, and a bone list says which is which"
    )]
    NotHumanoid {
        /// VRM names of the bones.
        bones: String,
    },
    /// A joint that a list of bones names is not in the recording.
    #[error("line {line} of the bone list: {problem}")]
    BoneList {
        /// Line, counted from 1.
        line: usize,
        /// What is wrong there.
        problem: Sentence,
    },
    /// Joints that span a limb coincide.
    #[error("the bone {bone} of the recording has no length")]
    BoneWithoutLength {
        /// VRM name of the bone.
        bone: &'static str,
    },
}

impl Bilingual for RecordingError {
    fn japanese(&self) -> String {
        match self {
            Self::Syntax { line, problem } => format!("{line} 行目: {}", problem.japanese),
            Self::TooLarge { what, count, limit } => {
                let what = match *what {
                    "joints" => "関節",
                    "frames" => "フレーム",
                    "levels of joints" => "関節の階層",
                    _ => "数値",
                };
                format!(
                    "記録の{what}が {count} あり、上限の {limit} を超えています。短く切ってください"
                )
            }
            Self::NoFrames => {
                "記録にフレームがありません。動きのない骨格だけのファイルです".to_owned()
            }
            Self::NotHumanoid { bones } => format!(
                "{bones} にあたる関節が見つかりません。lole inspect で関節の一覧を確かめ、骨の対応表を書いてください"
            ),
            Self::BoneList { line, problem } => {
                format!("骨の対応表の {line} 行目: {}", problem.japanese)
            }
            Self::BoneWithoutLength { bone } => {
                format!("記録の {bone} の骨に長さがありません")
            }
        }
    }
}
