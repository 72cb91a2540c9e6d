//! What is wrong with a file, in one sentence of each language.

use lole_language::{Bilingual, Sentence, Words};
use lole_motion::RecordingError;
use thiserror::Error;

/// Why a file cannot be read, measured or danced.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum AvatarError {
    /// It does not begin as glTF, GLB, VRM, VRMA or BVH.
    #[error(
        "this is no glTF, GLB, VRM, VRMA or BVH file; export the avatar or the dance as one of them"
    )]
    UnknownFormat,
    /// The container of chunks is damaged.
    #[error("{problem}; copy or export the file again")]
    Container {
        /// What is wrong with it.
        problem: Sentence,
    },
    /// The text part is no glTF.
    #[error("the glTF text is broken: {problem}; export the file again")]
    Text {
        /// What the reader said, with line and column.
        problem: String,
    },
    /// One part of the file is damaged.
    #[error("{place}: {problem}; export the file again")]
    Part {
        /// Which, such as `accessors[3]`.
        place: String,
        /// What is wrong there.
        problem: Sentence,
    },
    /// Data lies in another file.
    #[error(
        "{place} lies in another file, {uri}, which was not given; export everything as one .glb"
    )]
    Elsewhere {
        /// Which part.
        place: String,
        /// Where it lies.
        uri: String,
    },
    /// It cannot be read without an extension.
    #[error("the file needs the extension {name}, which is not read; export it without")]
    Extension {
        /// Name of the extension.
        name: String,
    },
    /// It is larger than any avatar.
    #[error("the file has {count} {}, over the {limit} that are read; make it smaller", what.english)]
    TooLarge {
        /// What there is too much of.
        what: Words,
        /// How many.
        count: u64,
        /// How many are read.
        limit: u64,
    },
    /// Bones of a person are missing, or hang together as no person's.
    #[error("no person: {0}")]
    NotHumanoid(RecordingError),
    /// The trunk does not stand over the legs.
    #[error(
        "no person: the trunk lies {degrees:.0}° from upright over the legs, as an animal's does; \
         only people dance"
    )]
    FourLegged {
        /// Angle between the trunk and the way from the feet up [°].
        degrees: f32,
    },
    /// Nothing can be seen.
    #[error("the file has no mesh on its bones: it is a skeleton or a dance, and no avatar")]
    NoMesh,
    /// Legs of a length that no unit explains.
    #[error(
        "its legs are {meters:.3} m long, and no unit makes them a person's; scale the avatar to meters"
    )]
    UnknownScale {
        /// Thigh and shank, if the file were in meters [m].
        meters: f32,
    },
    /// The body cannot be measured.
    #[error("the avatar cannot be dressed: {0}")]
    Body(#[from] lole_body::BodyError),
    /// It holds no dance.
    #[error("the file has no animation of its bones; it can be dressed, and does not dance")]
    NoAnimation,
    /// It holds dances, and not the one that is asked for.
    #[error("the file has no animation \"{clip}\"; it has {known}: write a name or a number")]
    UnknownClip {
        /// What was asked for.
        clip: String,
        /// Numbers and names of what is there.
        known: String,
    },
    /// The dance cannot be read.
    #[error("{0}")]
    Recording(#[from] RecordingError),
}

impl AvatarError {
    /// A damaged part.
    pub(crate) fn part(
        place: impl Into<String>,
        japanese: impl Into<String>,
        english: impl Into<String>,
    ) -> Self {
        Self::Part {
            place: place.into(),
            problem: Sentence::new(japanese, english),
        }
    }
}

impl Bilingual for AvatarError {
    fn japanese(&self) -> String {
        match self {
            Self::UnknownFormat => "glTF・GLB・VRM・VRMA・BVH のファイルではありません。\
                 アバターか踊りをそのどれかで書き出してください"
                .to_owned(),
            Self::Container { problem } => format!(
                "{}。コピーし直すか、もう一度書き出してください",
                problem.japanese
            ),
            Self::Text { problem } => {
                format!("glTF の記述が壊れています（{problem}）。もう一度書き出してください")
            }
            Self::Part { place, problem } => {
                format!("{place}: {}。もう一度書き出してください", problem.japanese)
            }
            Self::Elsewhere { place, uri } => format!(
                "{place} は別のファイル {uri} にあり、読み込まれていません。一つの .glb に書き出してください"
            ),
            Self::Extension { name } => format!(
                "このファイルには拡張 {name} が必要ですが、読めません。使わずに書き出してください"
            ),
            Self::TooLarge { what, count, limit } => format!(
                "{}が {count} あり、上限の {limit} を超えています。小さくしてください",
                what.japanese
            ),
            Self::NotHumanoid(error) => format!("人の形ではありません: {}", error.japanese()),
            Self::FourLegged { degrees } => format!(
                "人の形ではありません: 胴が脚の上に立たず {degrees:.0}° 傾いていて、動物のようです。踊れるのは人だけです"
            ),
            Self::NoMesh => {
                "骨についたメッシュがありません。骨格か踊りだけのファイルで、アバターではありません"
                    .to_owned()
            }
            Self::UnknownScale { meters } => format!(
                "脚の長さが {meters:.3} m で、どの単位でも人の脚になりません。メートルに合わせてください"
            ),
            Self::Body(error) => format!("このアバターには着せられません: {}", error.japanese()),
            Self::NoAnimation => {
                "骨のアニメーションがありません。着せることはできますが、踊りは入っていません"
                    .to_owned()
            }
            Self::UnknownClip { clip, known } => format!(
                "アニメーション「{clip}」はありません。あるのは {known} です。名前か番号を書いてください"
            ),
            Self::Recording(error) => error.japanese(),
        }
    }
}
