//! Everything that an order's folder holds, as bytes.

use std::sync::Arc;

use lole_costume::cost::{self, Bill};
use lole_costume::document::Design;
use lole_costume::order::{self, DancerPlan, Group, PrintTotal, Settings};
use lole_language::Language;

use super::{Order, order_json, order_sheets};
use crate::ExportError;
use crate::booklet::{Booklet, booklet_sheets};
use crate::cutting::{CutGarment, tiled_sheets};
use crate::pdf::{Document, Paper, Picture, Sheet};

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
    pub pictures: &'a [Option<Picture>],
    /// Spare cloth and bolts.
    pub settings: &'a Settings,
    /// What it is printed on.
    pub paper: Paper,
    /// In which language.
    pub language: Language,
    /// Version of the program.
    pub version: &'static str,
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

/// Repeats on cut plans of booklets are drawn with so many pixels on a side.
const PRINT_SIDE: u32 = 512;

/// The summary with shopping list and labels, the sewing booklet, every dancer's paper patterns where
/// her garments have any, and the same as data.
///
/// # Errors
/// [`ExportError`] of the encoders.
pub fn order_folder(parts: &OrderParts<'_>) -> Result<OrderFolder, ExportError> {
    let (design, plans) = (parts.design, &parts.group.plans);
    let bills: Vec<Bill> = plans.iter().map(|plan| cost::bill(design, plan)).collect();
    let prints = order::prints(plans, design, parts.settings);
    let mut notes = parts.group.notes.clone();
    notes.extend(parts.group.warnings());
    let order = Order {
        title: parts.title.clone(),
        hem_height_cm: design.costume_hem_cm(),
        plans,
        pictures: parts.pictures,
        prints: &prints,
        notions: &order::notions(plans),
        bills: &bills,
        total: &cost::group_bill(design, plans, &prints),
        problems: &parts.group.problems,
        notes: &notes,
        settings: parts.settings,
        spool_m: design.cost.thread_spool_m,
    };
    let (paper, language) = (parts.paper, parts.language);
    let pdf = |sheets: Vec<Sheet>| {
        let document = Document {
            title: parts.title.clone(),
            language: language.pick("ja", "en"),
            sheets,
        };
        document.to_bytes()
    };
    let json = order_json(&order, parts.version)?;
    let mut files = vec![(
        "order.pdf".to_owned(),
        pdf(order_sheets(&order, paper, language))?,
    )];
    if let (Some(plan), Some(bill)) = (plans.first(), bills.first()) {
        // A picture that was not read leaves the plans without it.
        let images = design.cut_print_images(PRINT_SIDE).unwrap_or_default();
        let images: Vec<_> = images.into_iter().map(Arc::new).collect();
        let booklet = Booklet {
            title: parts.title.clone(),
            plan,
            group: plans,
            prints: &images,
            bill,
            cover: parts.pictures.first().cloned().flatten(),
            hem_height_cm: order.hem_height_cm,
        };
        let sheets = booklet_sheets(&booklet, paper, language);
        files.push(("booklet.pdf".to_owned(), pdf(sheets)?));
    }
    files.extend(paper_patterns(plans, &parts.title, (paper, language))?);
    files.push(("order.json".to_owned(), json.clone().into_bytes()));
    Ok(OrderFolder {
        files,
        prints,
        json,
    })
}

/// A file of patterns at full size for every dancer whose garments are not all drawn by ruler.
fn paper_patterns(
    plans: &[DancerPlan],
    title: &str,
    (paper, language): (Paper, Language),
) -> Result<Vec<(String, Vec<u8>)>, ExportError> {
    let mut files = Vec::new();
    for (number, plan) in (1..).zip(plans) {
        let sheets: Vec<Sheet> = (plan.garments.iter())
            .filter_map(|garment| {
                let cut = CutGarment {
                    garment: garment.tailored.clone(),
                    plans: garment.plans.clone(),
                    print: None,
                    owner: plan.name.clone(),
                };
                tiled_sheets(&cut, paper, language)
            })
            .flat_map(|pattern| pattern.sheets)
            .collect();
        if sheets.is_empty() {
            continue;
        }
        let document = Document {
            title: format!("{title}: {}", plan.name),
            language: language.pick("ja", "en"),
            sheets,
        };
        let size = paper.name().to_ascii_lowercase();
        let who = file_word(&plan.name);
        let name = format!("{PATTERN_FILES}{number:03}-{who}-{size}.pdf");
        files.push((name, document.to_bytes()?));
    }
    Ok(files)
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
