//! Everything that an order's folder holds, as bytes.

use std::sync::Arc;

use lole_costume::cost::{self, Bill};
use lole_costume::document::Design;
use lole_costume::order::{self, Group, PrintTotal, Settings};
use lole_language::Language;

use super::{Order, order_json, order_sheets};
use crate::ExportError;
use crate::booklet::{Booklet, booklet_sheets};
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
    pub files: Vec<(&'static str, Vec<u8>)>,
    /// What is bought of each print.
    pub prints: Vec<PrintTotal>,
    /// The order as data; one of the files.
    pub json: String,
}

/// Repeats on cut plans of booklets are drawn with so many pixels on a side.
const PRINT_SIDE: u32 = 512;

/// The summary with shopping list and labels, the sewing booklet, and the same as data.
///
/// # Errors
/// [`ExportError`] of the encoders.
pub fn order_folder(parts: &OrderParts<'_>) -> Result<OrderFolder, ExportError> {
    let (design, plans) = (parts.design, &parts.group.plans);
    let bills: Vec<Bill> = plans.iter().map(|plan| cost::bill(design, plan)).collect();
    let prints = order::prints(plans, design, parts.settings);
    let order = Order {
        title: parts.title.clone(),
        hem_height_cm: design.costume_hem_cm(),
        plans,
        pictures: parts.pictures,
        prints: &prints,
        notions: &order::notions(plans),
        bills: &bills,
        total: &cost::sum(&bills, &design.cost),
        problems: &parts.group.problems,
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
    let mut files = vec![("order.pdf", pdf(order_sheets(&order, paper, language))?)];
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
        files.push(("booklet.pdf", pdf(sheets)?));
    }
    files.push(("order.json", json.clone().into_bytes()));
    Ok(OrderFolder {
        files,
        prints,
        json,
    })
}
