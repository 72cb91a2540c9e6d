//! What can be wrong with a draft, said so that a costume maker can mend it.

use lole_language::{Bilingual, Sentence, Words};

use crate::Tailored;

/// Why a draft cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DraftError {
    /// The gather ratio is not a number between 1 and 5.
    #[error("gather ratio {ratio} is out of range; use 1 (no gathers) to 5, usually 3 to 5")]
    GatherRatio {
        /// The refused ratio.
        ratio: f64,
    },
    /// The elastic ratio is not a number between 0.8 and 0.9.
    #[error(
        "elastic ratio {ratio} is out of range; use 0.8 (tight, heavy cloth) to 0.9 (light cloth)"
    )]
    ElasticRatio {
        /// The refused ratio.
        ratio: f64,
    },
    /// The number of elastic rows is not between 1 and 6.
    #[error("{count} elastic rows cannot be drafted; use 1 to 6, usually 3 to 5")]
    ElasticRowCount {
        /// The refused number.
        count: u32,
    },
    /// A length is not a finite number in the range that makes sense for it.
    #[error(
        "{} is {cm} cm; give a length between {min_cm} cm and {max_cm} cm",
        what.english
    )]
    Length {
        /// Which length, as a tailor says it.
        what: Words,
        /// The refused length [cm].
        cm: f64,
        /// Smallest accepted length [cm].
        min_cm: f64,
        /// Largest accepted length [cm].
        max_cm: f64,
    },
    /// The hem would hang above the band.
    #[error("{}", too_short([*hem_cm, *finished_cm, *band_cm]).english)]
    TooShort {
        /// Height of the hem above the floor [cm].
        hem_cm: f64,
        /// Resulting finished length [cm].
        finished_cm: f64,
        /// Depth of the band of casings [cm].
        band_cm: f64,
    },
    /// The cloth does not reach around the place where it is worn.
    #[error(
        "{flat_cm:.1} cm of cloth does not go around {worn_cm:.1} cm where the skirt is worn; \
         raise the gather ratio above {ratio:.2}"
    )]
    TooNarrow {
        /// Flat length around [cm].
        flat_cm: f64,
        /// Girth where it is worn [cm].
        worn_cm: f64,
        /// Gather ratio that would just reach.
        ratio: f64,
    },
    /// An option of a template is not a number in its range.
    #[error("{key} is {value}; give a number from {min} to {max} ({})", about.english)]
    Option {
        /// Key of the option.
        key: &'static str,
        /// What it means.
        about: Words,
        /// The refused number.
        value: f64,
        /// Smallest accepted number.
        min: f64,
        /// Largest accepted number.
        max: f64,
    },
    /// A garment cannot be drafted to a measure beside the others.
    #[error(
        "{} is {cm:.1} cm, and this garment can be drafted from {least_cm:.1} cm to {most_cm:.1} cm \
         beside the other measures; measure it again{}",
        what.english,
        remedy.english
    )]
    Measure {
        /// The measure that is the cause.
        what: Words,
        /// Its value [cm].
        cm: f64,
        /// Smallest value that fits [cm].
        least_cm: f64,
        /// Largest value that fits [cm].
        most_cm: f64,
        /// What else can be done, beginning with a comma; may be empty.
        remedy: Words,
    },
    /// A measure that was taken for drafting is not that of the body that was built from her tape.
    #[error("{}", not_hers(*tailored, [*cm, *on_body_cm, *least_cm, *most_cm]).english)]
    Tailored {
        /// Which measure.
        tailored: Tailored,
        /// What was given [cm].
        cm: f64,
        /// What the body has [cm].
        on_body_cm: f64,
        /// Smallest that is drafted [cm].
        least_cm: f64,
        /// Largest that is drafted [cm].
        most_cm: f64,
    },
    /// A skirt would be worn around the legs.
    #[error(
        "worn_height_cm is {worn_cm:.0} cm, where her legs have parted; wear the skirt above {least_cm:.0} cm"
    )]
    WornTooLow {
        /// Height of its upper edge above the floor [cm].
        worn_cm: f64,
        /// Lowest height at which it is carried [cm].
        least_cm: f64,
    },
    /// A garment of a pattern file whose file was not read.
    #[error("the pattern's file is not read; name it with file = \"…\"")]
    NoFile,
    /// A piece is wider than its cloth, and no seam that joins it would be hidden.
    #[error(
        "the {} is {across_cm:.1} cm across and cannot be joined unseen on cloth of {width_cm:.1} cm; use \
         cloth at least {:.0} cm wide, or make it smaller",
        piece.english,
        across_cm.ceil()
    )]
    WiderThanCloth {
        /// The piece.
        piece: Words,
        /// Its size across the cloth [cm].
        across_cm: f64,
        /// Width of the cloth [cm].
        width_cm: f64,
    },
}

/// A hem that leaves no length, or one above the place where the garment is worn [cm].
fn too_short([hem, finished, band]: [f64; 3]) -> Sentence {
    if finished <= 0.0 {
        return Sentence::new(
            format!(
                "床上 {hem:.1} cm の裾は、着る位置より上になります。裾を下げるか、高い位置で着てください"
            ),
            format!(
                "the hem at {hem:.1} cm above the floor lies above the place where it is worn; lower the hem or wear it higher"
            ),
        );
    }
    Sentence::new(
        format!(
            "裾を床上 {hem:.1} cm にすると丈が {finished:.1} cm しかなく、上の部分の {band:.1} cm より長くなりません。裾を下げるか、高い位置で着てください"
        ),
        format!(
            "the hem at {hem:.1} cm above the floor leaves {finished:.1} cm from the upper edge to the hem, which is no longer than the {band:.1} cm of the upper part; lower the hem or wear it higher"
        ),
    )
}

/// A measure that is not that of her body, what was given, what the body has, and what can be had [cm].
fn not_hers(tailored: Tailored, [cm, on_body, least, most]: [f64; 4]) -> Sentence {
    let (key, name) = (tailored.key(), tailored.name());
    Sentence::new(
        format!(
            "{key}（{}）が {cm:.1} cm ですが、ほかの寸法の体では {on_body:.1} cm ほどです。測り直して {least:.1}～{most:.1} cm を書くか、消してください",
            name.japanese
        ),
        format!(
            "{key} is {cm:.1} cm, and a body of her other measures has {on_body:.1} cm; measure the {} again and give {least:.1} to {most:.1} cm, or leave it out",
            name.english
        ),
    )
}

impl Bilingual for DraftError {
    fn japanese(&self) -> String {
        match self {
            Self::GatherRatio { ratio } => format!(
                "ギャザーの倍率 {ratio} は使えません。1（ギャザーなし）から 5 まで、ふつうは 3 から 5 です"
            ),
            Self::ElasticRatio { ratio } => format!(
                "ゴムの割合 {ratio} は使えません。0.8（きつめ、重い布）から 0.9（軽い布）までにしてください"
            ),
            Self::ElasticRowCount { count } => {
                format!("ゴム {count} 段は製図できません。1 から 6 段、ふつうは 3 から 5 段です")
            }
            Self::Length {
                what,
                cm,
                min_cm,
                max_cm,
            } => format!(
                "{}が {cm} cm です。{min_cm}～{max_cm} cm にしてください",
                what.japanese
            ),
            Self::TooShort {
                hem_cm,
                finished_cm,
                band_cm,
            } => too_short([*hem_cm, *finished_cm, *band_cm]).japanese,
            Self::TooNarrow {
                flat_cm,
                worn_cm,
                ratio,
            } => format!(
                "布の長さ {flat_cm:.1} cm では、はく位置の {worn_cm:.1} cm を回りません。\
                 ギャザーの倍率を {ratio:.2} より大きくしてください"
            ),
            Self::Option {
                key,
                about,
                value,
                min,
                max,
            } => format!(
                "{key}（{}）が {value} です。{min} から {max} までの数にしてください",
                about.japanese
            ),
            Self::Measure {
                what,
                cm,
                least_cm,
                most_cm,
                remedy,
            } => format!(
                "{}が {cm:.1} cm です。ほかの寸法のもとでこの服を製図できるのは \
                 {least_cm:.1}～{most_cm:.1} cm です。測り直してください{}",
                what.japanese, remedy.japanese
            ),
            Self::Tailored {
                tailored,
                cm,
                on_body_cm,
                least_cm,
                most_cm,
            } => not_hers(*tailored, [*cm, *on_body_cm, *least_cm, *most_cm]).japanese,
            Self::WornTooLow { worn_cm, least_cm } => format!(
                "worn_height_cm が {worn_cm:.0} cm ですが、そこはもう脚です。{least_cm:.0} cm より上ではいてください"
            ),
            Self::NoFile => {
                "型紙のファイルがまだ読まれていません。file = \"…\" で名前を書いてください"
                    .to_owned()
            }
            Self::WiderThanCloth {
                piece,
                across_cm,
                width_cm,
            } => format!(
                "「{}」は布幅の方向に {across_cm:.1} cm あり、幅 {width_cm:.1} cm の布では目立たない所で\
                 はぎ合わせられません。幅 {:.0} cm 以上の布にするか、小さくしてください",
                piece.japanese,
                across_cm.ceil()
            ),
        }
    }
}
