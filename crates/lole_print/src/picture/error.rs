//! Why a picture cannot be a print.

use lole_language::Bilingual;

use super::{LONGEST_SIDE, MOST_PIXELS};

/// Why a picture cannot be a print, and what to do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The bytes begin like no picture.
    #[error("this is not a PNG, JPEG or SVG picture; save the print as one of them")]
    NotPicture,
    /// A picture of a kind that is not read.
    #[error("this is {format}, and a print is read from PNG, JPEG or SVG; save it as PNG")]
    OtherFormat {
        /// Name of the kind.
        format: &'static str,
    },
    /// A photo as many telephones keep it.
    #[error(
        "this photo is HEIC (or AVIF), which is not read here; send it to yourself as JPEG, or set \
         the camera to \"Most Compatible\" (iPhone: Settings, Camera, Formats) and take it again"
    )]
    Heic,
    /// More pixels than are read, or none.
    #[error(
        "the picture is {width} x {height} pixels, and at most {LONGEST_SIDE} on a side and \
         {} million in all are read; make it smaller: 4000 on the longer side show every yarn",
        MOST_PIXELS / 1_000_000
    )]
    TooLarge {
        /// Width [pixel].
        width: u32,
        /// Height [pixel].
        height: u32,
    },
    /// The file breaks off or contradicts itself.
    #[error("the picture is damaged or incomplete ({message}); copy or save it again")]
    Broken {
        /// What the reader said, on one line.
        message: String,
    },
    /// An SVG with letters, whose font is not part of it.
    #[error("the drawing has text, whose font is not in the file; turn the text into paths")]
    SvgText,
    /// An SVG that shows another picture.
    #[error("the drawing shows a photo inside of it; give the photo itself as PNG or JPEG")]
    SvgImage,
    /// An SVG whose lines have markers, such as arrowheads.
    #[error("the drawing has markers on its lines, such as arrowheads; turn them into paths")]
    SvgMarkers,
    /// An SVG that would be drawn for longer than a print may.
    #[error(
        "the drawing would take more than ten seconds to draw; leave out filters, and patterns, masks and clips \
         that lie in each other, or save it as PNG"
    )]
    SvgWork,
    /// An SVG whose layers need more memory than a print may.
    #[error(
        "the drawing would take more than 400 MB to draw; make its patterns smaller and leave out layers that \
         lie in each other, or save it as PNG"
    )]
    SvgMemory,
}

impl PictureError {
    /// What another crate said, cut to one line.
    pub(super) fn broken(said: &impl std::fmt::Display) -> Self {
        let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
        Self::Broken {
            message: said.to_string().chars().take(120).map(visible).collect(),
        }
    }
}

impl Bilingual for PictureError {
    fn japanese(&self) -> String {
        match self {
            Self::NotPicture => {
                "PNG・JPEG・SVG の画像ではありません。そのどれかで保存し直してください".to_owned()
            }
            Self::OtherFormat { format } => {
                format!("{format} です。柄は PNG・JPEG・SVG から読みます。PNG で保存し直してください")
            }
            Self::Heic => "この写真は HEIC（または AVIF）で、読めません。JPEG にして送るか、\
                 カメラの設定を「互換性優先」（iPhone は 設定 → カメラ → フォーマット）にして撮り直してください"
                .to_owned(),
            Self::TooLarge { width, height } => format!(
                "画像が {width} × {height} 画素です。読めるのは一辺 {LONGEST_SIDE} まで、全部で {} 万画素までです。\
                 長い辺を 4000 画素にすれば糸まで見えます。小さくしてください",
                MOST_PIXELS / 10_000
            ),
            Self::Broken { message } => format!(
                "画像がこわれているか、途中で切れています（{message}）。もう一度コピーか保存をしてください"
            ),
            Self::SvgText => "図に文字があり、その書体がファイルにありません。\
                 文字をアウトライン（パス）に変えてください"
                .to_owned(),
            Self::SvgMarkers => {
                "図の線にマーカー（矢じりなど）が付いています。アウトライン（パス）に変えてください".to_owned()
            }
            Self::SvgWork => "図を描くのに 10 秒より長くかかります。フィルターや、入れ子のパターン・マスク・クリップを\
                 減らすか、PNG で保存し直してください"
                .to_owned(),
            Self::SvgMemory => "図を描くのに 400 MB より多くのメモリーが要ります。パターンを小さくし、\
                 入れ子のレイヤーを減らすか、PNG で保存し直してください"
                .to_owned(),
            Self::SvgImage => {
                "図の中に写真があります。写真そのものを PNG か JPEG で指定してください".to_owned()
            }
        }
    }
}
