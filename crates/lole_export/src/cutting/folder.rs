//! Everything that one costume is cut by, as the files of one folder.

use lole_language::Language;

use super::{
    CutGarment, WholeSheet, cut_plan_sheets, cut_plan_svg, pattern_json, pieces_svg, ruler_sheets,
    tiled_sheets, whole_sheet,
};
use crate::ExportError;
use crate::dxf::pattern_dxf;
use crate::hpgl::plotter_file;
use crate::pdf::{Document, Paper, Sheet};

/// The patterns as data.
pub const PATTERN_JSON: &str = "pattern.json";
/// Files that all garments of a folder share.
const SHARED_FILES: [&str; 3] = ["cut-plan.pdf", "cut-plan.svg", "ruler.pdf"];

/// What a folder of patterns is made of.
#[derive(Debug, Clone, Copy)]
pub struct PatternParts<'a> {
    /// The garments with their cut plans.
    pub cuts: &'a [CutGarment],
    /// Name of the size in the files of pattern programs: that of the design.
    pub size: &'a str,
    /// What it is printed on.
    pub paper: Paper,
    /// Pages beside it that hold a garment whole.
    pub whole: &'a [WholeSheet],
    /// Language of every word.
    pub language: Language,
    /// Version of the program, written into the data.
    pub version: &'static str,
}

/// Cut plans, sheets for ruler and chalk, and of each garment its pieces at full size, as names and
/// bytes of files.
///
/// `goes_on` is asked once for each garment; where it says no, what is left is left out, and the files
/// are not to be used.
///
/// # Errors
/// [`ExportError`] of the encoders.
pub fn pattern_folder(
    parts: &PatternParts<'_>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<(String, Vec<u8>)>, ExportError> {
    let mut folder = Folder {
        parts,
        files: Vec::new(),
    };
    folder.plans()?;
    for cut in parts.cuts {
        if !goes_on() {
            break;
        }
        folder.garment(cut)?;
    }
    let json = pattern_json(parts.cuts, parts.version)?;
    folder.add(PATTERN_JSON, json.into_bytes());
    Ok(folder.files)
}

/// Names that the folder's earlier patterns may have, by their [`PATTERN_JSON`], and `files` have not:
/// sheets of garments that are worn no more. Only names that patterns give are among them.
#[must_use]
pub fn left_behind(earlier: &[u8], files: &[(String, Vec<u8>)]) -> Vec<String> {
    let earlier: serde_json::Value = serde_json::from_slice(earlier).unwrap_or_default();
    let Some(garments) = earlier["garments"].as_array() else {
        return Vec::new();
    };
    let ids = garments.iter().filter_map(|garment| garment["id"].as_str());
    // An id that somebody else wrote names no file elsewhere.
    let plain = ids.filter(|id| !id.contains(['/', '\\', ':']) && !id.contains(".."));
    let own = plain.flat_map(|id| {
        let sheets = Paper::ALL.map(|(paper, _)| tiled_name(id, paper));
        sheets
            .into_iter()
            .chain(WholeSheet::ALL.map(|(page, _)| whole_name(id, page)))
            .chain([sizes_name(id), format!("{id}.svg"), format!("{id}.dxf")])
    });
    let shared = SHARED_FILES.map(str::to_owned);
    let names = shared.into_iter().chain(own);
    names
        .filter(|name| files.iter().all(|(written, _)| written != name))
        .collect()
}

/// The file of a garment's sheets to join.
fn tiled_name(id: &str, paper: Paper) -> String {
    format!("{id}-{}.pdf", paper.name().to_ascii_lowercase())
}

/// The file of a page with all sizes of a garment.
#[must_use]
pub fn sizes_name(id: &str) -> String {
    format!("{id}-sizes.pdf")
}

/// The file of a page that holds a garment whole.
#[must_use]
pub fn whole_name(id: &str, page: WholeSheet) -> String {
    match page {
        WholeSheet::Plotter => format!("{id}.plt"),
        page => format!("{id}-{}.pdf", page.name()),
    }
}

struct Folder<'a> {
    parts: &'a PatternParts<'a>,
    files: Vec<(String, Vec<u8>)>,
}

impl Folder<'_> {
    /// What all garments share: cut plans, and the sheets for ruler and chalk.
    fn plans(&mut self) -> Result<(), ExportError> {
        let PatternParts {
            cuts,
            paper,
            language,
            ..
        } = *self.parts;
        // What is tied, strung or carved has no cut plan: its booklet says what to gather.
        if cuts.iter().all(|cut| cut.plans.is_empty()) {
            return Ok(());
        }
        let title = language.pick("裁ち方図", "cut plan");
        self.pdf(
            "cut-plan.pdf",
            title,
            cut_plan_sheets(cuts, paper, language),
        )?;
        self.add("cut-plan.svg", cut_plan_svg(cuts, language));
        let ruler = ruler_sheets(cuts, paper, language);
        if ruler.is_empty() {
            return Ok(());
        }
        let title = language.pick("定規で引く線", "rectangles by ruler");
        self.pdf("ruler.pdf", title, ruler)
    }

    /// The pieces of one garment at full size.
    fn garment(&mut self, cut: &CutGarment) -> Result<(), ExportError> {
        let (paper, language) = (self.parts.paper, self.parts.language);
        let id = &cut.garment.id;
        if let Some(tiled) = tiled_sheets(cut, paper, language) {
            let name = tiled_name(id, paper);
            self.pdf(&name, cut.garment.name.text(language), tiled.sheets)?;
        }
        for page in self.parts.whole {
            // A plotter's own letters are Latin.
            let language = match page {
                WholeSheet::Plotter => Language::English,
                _ => language,
            };
            if let Some(sheet) = whole_sheet(cut, *page, language) {
                let title = cut.garment.name.text(language);
                let bytes = match page {
                    WholeSheet::Plotter => plotter_file(&sheet),
                    _ => sheet.to_bytes(title, language)?,
                };
                self.add(&whole_name(id, *page), bytes);
            }
        }
        // Leaves and flowers are tied, not cut.
        if !cut.garment.pattern.pieces.is_empty() {
            self.add(&format!("{id}.svg"), pieces_svg(cut, language));
            let size = Some(cut.stamp.size.as_str()).filter(|size| !size.is_empty());
            let size = size.unwrap_or(self.parts.size);
            self.add(&format!("{id}.dxf"), pattern_dxf(cut, size));
        }
        Ok(())
    }

    fn pdf(&mut self, name: &str, title: &str, sheets: Vec<Sheet>) -> Result<(), ExportError> {
        let document = Document::new(title, self.parts.language, sheets);
        self.add(name, document.to_bytes()?);
        Ok(())
    }

    fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.push((name.to_owned(), bytes));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Only what patterns write goes, and only where there were patterns.
    #[test]
    fn sheets_of_garments_that_are_worn_no_more_are_left_behind() {
        let earlier = br#"{"garments": [{"id": "skirt"}, {"id": "pau-top-2"}, {"id": "../x"}]}"#;
        let written = ["cut-plan.pdf", "cut-plan.svg", "skirt.svg", "skirt.dxf"];
        let files = written.map(|name| (name.to_owned(), Vec::new()));
        let gone = left_behind(earlier, &files);
        for name in [
            "ruler.pdf",
            "skirt-a4.pdf",
            "skirt-roll.pdf",
            "pau-top-2.svg",
            "pau-top-2.dxf",
        ] {
            assert!(gone.iter().any(|it| it == name), "{name} in {gone:?}");
        }
        let is_own = |name: &String| written.contains(&name.as_str()) || name.contains("..");
        assert!(!gone.iter().any(is_own), "{gone:?}");
        assert!(left_behind(b"no json", &files).is_empty());
        assert!(left_behind(b"", &files).is_empty());
    }
}
