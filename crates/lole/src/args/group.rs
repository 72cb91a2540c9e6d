//! Options of a group on one stage.

use std::path::PathBuf;

use clap::Args;
use lole_language::Sentence;
use lole_stage::Formation;

/// A group instead of one dancer.
#[derive(Debug, Default, Args)]
pub(crate) struct GroupArgs {
    /// List of dancers as a spreadsheet saves it (.csv, .xlsx, .ods): all of them dance together, each in her own
    /// measures; 24 at most.
    #[arg(long, value_name = "LIST", conflicts_with_all = ["avatar", "measures", "json"])]
    pub(crate) dancers: Option<PathBuf>,
    /// How they stand: rows, line, wedge or circle.
    #[arg(long, value_name = "NAME", default_value = "rows", value_parser = formation, requires = "dancers")]
    pub(crate) formation: Formation,
    /// From one dancer of a row to the next [cm], 60 to 500; otherwise so far that no hand reaches a neighbor.
    #[arg(long, value_name = "CM", value_parser = spacing, allow_negative_numbers = true, requires = "dancers")]
    pub(crate) spacing: Option<f32>,
}

fn formation(text: &str) -> Result<Formation, Sentence> {
    let names = Formation::ALL.map(Formation::id).join(", ");
    Formation::from_id(text).ok_or_else(|| {
        Sentence::new(
            format!("{names} から選んでください"),
            format!("choose one of {names}"),
        )
    })
}

/// Meters of a number of centimeters.
fn spacing(text: &str) -> Result<f32, Sentence> {
    let cm = text.parse::<f32>().ok();
    let fits = cm.filter(|cm| (60.0..=500.0).contains(cm));
    fits.map(|cm| 0.01 * cm).ok_or_else(|| {
        Sentence::new(
            "60 から 500 までの数（cm）を書いてください（例: 150）",
            "give a number of centimeters from 60 to 500, such as 150",
        )
    })
}
