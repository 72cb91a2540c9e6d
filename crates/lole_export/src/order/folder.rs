//! Everything that an order's folder holds, as bytes.

use std::borrow::Cow;
use std::sync::Arc;

use lole_body::{Dancer, Measurements};
use lole_costume::cost::{self, Bill};
use lole_costume::document::Design;
use lole_costume::order::{self, DancerPlan, Group, PrintTotal, Settings};
use lole_costume::tailoring::{self, DraftedBy};
use lole_language::{Language, Sentence};
use rayon::prelude::*;

use super::{Order, order_json, order_sheets};
use crate::ExportError;
use crate::booklet::{Booklet, Worn, booklet_sheets};
use crate::cutting::{CutGarment, Stamp, tiled_sheets};
use crate::pdf::{Document, EncodedPicture, Paper, Sheet, missing_glyphs};

/// What an order is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderParts<'a> {
    /// What the costume is called.
    pub title: String,
    /// Its design.
    pub design: &'a Design,
    /// The dancers, cut; at least one.
    pub group: &'a Group,
    /// Each dancer's picture, where there is one; all at one scale.
    pub pictures: &'a [Option<EncodedPicture>],
    /// Spare cloth and bolts.
    pub settings: &'a Settings,
    /// What it is printed on.
    pub paper: Paper,
    /// In which language.
    pub language: Language,
    /// Version of the program.
    pub version: &'static str,
    /// Files that were written into the folder beside these, by their paths in it: kept pictures.
    pub kept_files: &'a [String],
}

/// The files of an order, and what of them is told on a screen.
#[derive(Debug, Clone, PartialEq)]
pub struct OrderFolder {
    /// Names and contents.
    pub files: Vec<(String, Vec<u8>)>,
    /// What is bought of each print.
    pub prints: Vec<PrintTotal>,
    /// The order as data; one of the files.
    pub json: String,
}

/// How the files of patterns begin.
pub const PATTERN_FILES: &str = "pattern-";
/// The order as data.
pub const ORDER_JSON: &str = "order.json";
/// Folder of the pictures that a command keeps, within the order's.
pub const PICTURE_FOLDER: &str = "pictures";

/// The files of an order's folder by the list in its [`ORDER_JSON`]; none where there is no such list.
/// Only names that orders give are taken from it, so that a list that somebody wrote names no other file.
#[must_use]
pub fn listed_files(json: &str) -> Vec<String> {
    let order: serde_json::Value = serde_json::from_str(json).unwrap_or_default();
    let files = order["files"].as_array().map_or(&[][..], Vec::as_slice);
    let names = files.iter().filter_map(|name| name.as_str());
    names
        .filter(|name| is_of_order(name))
        .map(str::to_owned)
        .collect()
}

/// Whether orders write files of this name.
fn is_of_order(name: &str) -> bool {
    let is_plain = |name: &str| !name.contains(['/', '\\', ':']) && !name.contains("..");
    let ends = |name: &str, end: &str| {
        std::path::Path::new(name)
            .extension()
            .is_some_and(|found| found == end)
    };
    if let Some(picture) = name.strip_prefix(PICTURE_FOLDER) {
        let picture = picture.strip_prefix('/').unwrap_or_default();
        return is_plain(picture) && ends(picture, "jpg");
    }
    let is_pattern = name.starts_with(PATTERN_FILES) && ends(name, "pdf");
    is_plain(name) && (is_pattern || ["order.pdf", "booklet.pdf", ORDER_JSON].contains(&name))
}

/// What an earlier order of the folder wrote, by its list, and this one did not.
#[must_use]
pub fn left_behind(earlier: &str, now: &str) -> Vec<String> {
    let kept = listed_files(now);
    let earlier = listed_files(earlier).into_iter();
    earlier.filter(|name| !kept.contains(name)).collect()
}

/// Repeats on cut plans of booklets are drawn with so many pixels on a side.
const PRINT_SIDE: u32 = 512;

/// The summary with shopping list and labels, the sewing booklet, every dancer's paper patterns where
/// her garments have any, and the same as data.
///
/// `goes_on` is asked once for each dancer, from any thread, before her patterns are laid out; where it
/// says no they are left out, and the folder is not to be used.
///
/// # Errors
/// [`ExportError`] of the encoders.
pub fn order_folder(
    parts: &OrderParts<'_>,
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<OrderFolder, ExportError> {
    let (design, plans) = (parts.design, &parts.group.plans);
    let bills: Vec<Bill> = plans.iter().map(|plan| cost::bill(design, plan)).collect();
    let prints = order::prints(plans, design, parts.settings);
    let mut notes = parts.group.notes.clone();
    notes.extend(parts.group.warnings());
    let named = paper_names(plans);
    if let Cow::Owned(_) = named {
        notes.push(Sentence::new(
            "紙に印刷できない文字は〓です。その名前の前の数字は、名簿で何人目かです。",
            "letters that cannot be printed stand as 〓; the number before such a name is her place in the list",
        ));
    }
    let order = Order {
        title: parts.title.clone(),
        hem_height_cm: design.costume_hem_cm(),
        plans: &named,
        pictures: parts.pictures,
        prints: &prints,
        notions: &order::notions(plans, parts.settings),
        bills: &bills,
        total: &cost::group_bill(design, plans, &prints),
        problems: &parts.group.problems,
        notes: &notes,
        settings: parts.settings,
        spool_m: design.cost.thread_spool_m,
    };
    let (paper, language) = (parts.paper, parts.language);
    let pdf = |sheets: Vec<Sheet>| Document::new(&parts.title, language, sheets).to_bytes();
    let mut files = vec![(
        "order.pdf".to_owned(),
        pdf(order_sheets(&order, paper, language))?,
    )];
    if let Some(sheets) = booklet_of(parts, (&named, &bills)) {
        files.push(("booklet.pdf".to_owned(), pdf(sheets)?));
    }
    files.extend(paper_patterns(parts, &named, goes_on)?);
    let mut names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    names.push(ORDER_JSON);
    names.extend(parts.kept_files.iter().map(String::as_str));
    let as_listed = Order { plans, ..order };
    let json = order_json(&as_listed, parts.version, &names)?;
    files.push((ORDER_JSON.to_owned(), json.clone().into_bytes()));
    Ok(OrderFolder {
        files,
        prints,
        json,
    })
}

/// The plans with names that can be told apart on paper: before one with letters that cannot be printed stands its
/// number.
fn paper_names(plans: &[DancerPlan]) -> Cow<'_, [DancerPlan]> {
    let is_unprintable = |plan: &DancerPlan| !missing_glyphs(&plan.name).is_empty();
    if !plans.iter().any(is_unprintable) {
        return Cow::Borrowed(plans);
    }
    let named = (1..).zip(plans).map(|(number, plan)| {
        let mut plan = plan.clone();
        if is_unprintable(&plan) {
            plan.name = format!("{number} {}", plan.name);
        }
        plan
    });
    Cow::Owned(named.collect())
}

/// How the costume is sewn, with the first dancer's lengths; `None` where there are no dancers.
fn booklet_of(
    parts: &OrderParts<'_>,
    (plans, bills): (&[DancerPlan], &[Bill]),
) -> Option<Vec<Sheet>> {
    let design = parts.design;
    // A picture that was not read leaves the plans without it.
    let images = design.cut_print_images(PRINT_SIDE).unwrap_or_default();
    let images: Vec<_> = images.into_iter().map(Arc::new).collect();
    let first = parts.group.designs.first();
    let drafted_by = first.map_or_else(DraftedBy::default, drafted_by);
    let booklet = Booklet {
        title: parts.title.clone(),
        plan: plans.first()?,
        group: plans,
        prints: &images,
        bill: bills.first()?,
        drafted_by: &drafted_by,
        worn: (parts.pictures.first().cloned().flatten()).map(Worn::alone),
        hem_height_cm: design.costume_hem_cm(),
    };
    Some(booklet_sheets(&booklet, parts.paper, parts.language))
}

/// What a design's costume is drafted by; nothing where its tape makes no body.
fn drafted_by(design: &Design) -> DraftedBy {
    let tape = Measurements::from_tape(&design.tape());
    let dancer = tape.and_then(|tape| Dancer::to_measure(&tape, &design.appearance()));
    dancer.map_or_else(
        |_| DraftedBy::default(),
        |dancer| tailoring::drafted_by(design, &dancer),
    )
}

/// A file of patterns at full size for every dancer whose garments are not all drawn by ruler.
fn paper_patterns(
    parts: &OrderParts<'_>,
    plans: &[DancerPlan],
    goes_on: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<(String, Vec<u8>)>, ExportError> {
    let (paper, language) = (parts.paper, parts.language);
    let of_dancer = |(index, plan): (usize, &DancerPlan)| {
        if !goes_on() {
            return Ok(None);
        }
        let design = parts.group.designs.get(index);
        let stamp = design.map(|design| Stamp::of(&parts.title, design));
        let sheets = pattern_sheets(plan, &stamp.unwrap_or_default(), paper, language);
        if sheets.is_empty() {
            return Ok(None);
        }
        let as_listed = parts.group.plans.get(index).unwrap_or(plan);
        let title = format!("{}: {}", parts.title, as_listed.name);
        let document = Document::new(&title, language, sheets);
        let size = paper.name().to_ascii_lowercase();
        let (number, who) = (index + 1, file_word(&as_listed.name));
        let name = format!("{PATTERN_FILES}{number:03}-{who}-{size}.pdf");
        Ok(Some((name, document.to_bytes()?)))
    };
    let files: Result<Vec<_>, ExportError> = plans.par_iter().enumerate().map(of_dancer).collect();
    Ok(files?.into_iter().flatten().collect())
}

/// One dancer's patterns at full size; none where all of hers are drawn by ruler.
fn pattern_sheets(
    plan: &DancerPlan,
    stamp: &Stamp,
    paper: Paper,
    language: Language,
) -> Vec<Sheet> {
    let tiled = plan.garments.iter().filter_map(|garment| {
        let cut = CutGarment {
            owner: plan.name.clone(),
            stamp: stamp.clone(),
            ..CutGarment::of(garment)
        };
        tiled_sheets(&cut, paper, language)
    });
    tiled.flat_map(|pattern| pattern.sheets).collect()
}

/// A name as part of a file's: letters and digits, whatever the script.
fn file_word(name: &str) -> String {
    let letters = name.chars().take(40);
    let letters = letters.map(|letter| {
        if letter.is_alphanumeric() {
            letter
        } else {
            '-'
        }
    });
    letters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_cannot_be_printed_are_told_apart_by_their_numbers() {
        let design = Design::default();
        let plan = order::plan_design("花子", &design).unwrap_or_else(|error| panic!("{error}"));
        let called = |name: &str| DancerPlan {
            name: name.to_owned(),
            ..plan.clone()
        };
        let plain = [called("花子"), called("Lei")];
        assert!(matches!(paper_names(&plain), Cow::Borrowed(_)));
        let mixed = [called("花子"), called("김수"), called("박민")];
        let named = paper_names(&mixed);
        let names: Vec<&str> = named.iter().map(|plan| plan.name.as_str()).collect();
        assert_eq!(names, ["花子", "2 김수", "3 박민"]);
    }

    /// Only what an earlier list names goes, and only names that orders give.
    #[test]
    fn what_no_order_wrote_stays() {
        let earlier = r#"{"files": ["order.pdf", "pattern-003-花子-a4.pdf", "pictures/003-0a.jpg",
            "../secret.pdf", "notes.txt", "pattern-../x.pdf", "pictures/../order.jpg", "photo.jpg",
            "pattern-/etc/x.pdf", 7, "order.json"]}"#;
        let now = r#"{"files": ["order.pdf", "order.json", "booklet.pdf"]}"#;
        let gone = ["pattern-003-花子-a4.pdf", "pictures/003-0a.jpg"];
        assert_eq!(left_behind(earlier, now), gone);
        assert!(left_behind("no json", now).is_empty());
        assert!(left_behind(r#"{"dancers": []}"#, now).is_empty());
        assert!(left_behind(now, now).is_empty());
    }
}
