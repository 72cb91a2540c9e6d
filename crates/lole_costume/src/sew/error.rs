//! Why a skirt could not be sewn, in both languages.

use lole_language::Bilingual;

/// Why a skirt could not be sewn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SewError {
    /// The flat cloth does not reach around the body.
    #[error(
        "the cloth is {flat_cm:.1} cm around but the band sits on {ring_cm:.1} cm; raise gather_ratio"
    )]
    TooNarrow {
        /// Length of the cloth around [cm].
        flat_cm: f64,
        /// Girth it must reach around [cm].
        ring_cm: f64,
    },
    /// The body has no section where an elastic row should lie.
    #[error(
        "the dancer has no trunk at {height_cm:.1} cm, where an elastic row lies; lower the number of elastic rows"
    )]
    NoSection {
        /// Height above the floor [cm].
        height_cm: f64,
    },
    /// The band would reach up to the bust.
    #[error(
        "the band would reach {top_cm:.0} cm above the floor and the bust is at {bust_cm:.0} cm; lower casing_cm, casing_gap_cm or elastic_row_count, or wear the skirt lower"
    )]
    BandTooTall {
        /// Upper edge of the band above the floor [cm].
        top_cm: f64,
        /// The bust above the floor [cm].
        bust_cm: f64,
    },
    /// The top would reach up to the shoulders.
    #[error(
        "the top would reach {top_cm:.0} cm above the floor and the shoulders are at {shoulder_cm:.0} cm; lower upper_height_cm or header_cm"
    )]
    TopTooTall {
        /// Upper edge above the floor [cm].
        top_cm: f64,
        /// The shoulder joints above the floor [cm].
        shoulder_cm: f64,
    },
    /// The skirt would be worn around the legs.
    #[error(
        "worn_height_cm is {worn_cm:.0} cm, where her legs have parted; wear the skirt above {least_cm:.0} cm"
    )]
    WornTooLow {
        /// Height of the lowest elastic above the floor [cm].
        worn_cm: f64,
        /// Lowest height at which a skirt is carried [cm].
        least_cm: f64,
    },
    /// Too few particles for the gathers.
    #[error(
        "{column_count} columns are too few to gather {flat_cm:.0} cm of cloth; use a column_count of at least {least}, or a smaller gather_ratio"
    )]
    TooFewColumns {
        /// Columns asked for.
        column_count: u32,
        /// Length of the cloth around [cm].
        flat_cm: f64,
        /// Columns needed.
        least: u32,
    },
    /// Too few particles for the band.
    #[error(
        "{row_count} rows are too few for {elastic_row_count} elastic rows; {}",
        match least {
            Some(least) => format!("use a row_count of at least {least}"),
            None => "they lie too close together: make casing_cm or casing_gap_cm larger, or elastic_row_count smaller"
                .to_owned(),
        }
    )]
    TooFewRows {
        /// Rows asked for.
        row_count: u32,
        /// Elastic rows of the draft.
        elastic_row_count: usize,
        /// Rows needed; `None` where no number that is accepted is enough.
        least: Option<u32>,
    },
}

impl Bilingual for SewError {
    fn japanese(&self) -> String {
        match self {
            Self::TooNarrow { flat_cm, ring_cm } => format!(
                "布は一周 {flat_cm:.1} cm ですが、ゴムの位置のまわりは {ring_cm:.1} cm です。gather_ratio を大きくしてください"
            ),
            Self::NoSection { height_cm } => format!(
                "ゴムが来る高さ {height_cm:.1} cm に胴がありません。ゴムの段を減らしてください"
            ),
            Self::TooFewRows {
                row_count,
                elastic_row_count,
                least,
            } => match least {
                Some(least) => format!(
                    "ゴム {elastic_row_count} 段に対して {row_count} 行では足りません。row_count を {least} 以上にしてください"
                ),
                None => format!(
                    "ゴム {elastic_row_count} 段の間が狭すぎます。casing_cm か casing_gap_cm を大きくするか、\
                     elastic_row_count を小さくしてください"
                ),
            },
            Self::BandTooTall { top_cm, bust_cm } => format!(
                "ゴムの部分が床から {top_cm:.0} cm まで届きますが、バストは {bust_cm:.0} cm です。\
                 casing_cm か casing_gap_cm か elastic_row_count を小さくするか、低い位置ではいてください"
            ),
            Self::TopTooTall {
                top_cm,
                shoulder_cm,
            } => format!(
                "トップの上端が床から {top_cm:.0} cm になりますが、肩は {shoulder_cm:.0} cm です。\
                 upper_height_cm か header_cm を小さくしてください"
            ),
            Self::WornTooLow { worn_cm, least_cm } => format!(
                "worn_height_cm が {worn_cm:.0} cm ですが、そこはもう脚です。{least_cm:.0} cm より上ではいてください"
            ),
            Self::TooFewColumns {
                column_count,
                flat_cm,
                least,
            } => format!(
                "{flat_cm:.0} cm の布にギャザーを寄せるには {column_count} 列では足りません。\
                 column_count を {least} 以上にするか、gather_ratio を小さくしてください"
            ),
        }
    }
}
