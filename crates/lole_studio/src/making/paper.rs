//! Booklet and pattern of one dancer, to her own figures.

use std::sync::Arc;

use lole_body::Dancer;
use lole_costume::cost;
use lole_costume::order;
use lole_costume::tailoring;
use lole_export::booklet::{Booklet, Worn, booklet_sheets};
use lole_export::cutting::{CutGarment, PatternParts, Stamp, pattern_folder};
use lole_export::pdf::{Document, printable};
use lole_language::{Bilingual, Sentence};
use lole_picture::portrait::{self, PortraitError};
use lole_print::PrintImage;
use lole_stage::Production;

use super::{Line, Unmade, Wish, flew_apart};

/// Repeats on cut plans are drawn with so many pixels on a side.
const PRINT_SIDE: u32 = 512;
/// Shares of a booklet that are done when its figures are known and when its cover is drawn.
const SHARES: [f32; 2] = [0.1, 0.9];

/// The booklet as the bytes of a PDF.
pub(super) fn booklet(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let design = &wish.design;
    let dancer = dancer(wish)?;
    let plan = order::plan_dancer("", design, &dancer).map_err(|error| said(&error))?;
    let bill = cost::bill(design, &plan);
    line.goes_on(SHARES[0])?;
    let worn = worn(wish, line)?;
    let drafted_by = tailoring::drafted_by(design, &dancer);
    line.goes_on(SHARES[1])?;
    let prints = prints(wish)?;
    let booklet = Booklet {
        title: printable(&wish.title),
        plan: &plan,
        group: &[],
        prints: &prints,
        bill: &bill,
        drafted_by: &drafted_by,
        worn: Some(worn),
        hem_height_cm: design.costume_hem_cm(),
    };
    let sheets = booklet_sheets(&booklet, wish.paper, wish.language);
    let document = Document::new(&printable(&wish.title), wish.language, sheets);
    document.to_bytes().map_err(|error| Unmade::of(&error))
}

/// The files of a folder with everything that is cut.
pub(super) fn pattern(wish: &Wish, line: &Line<'_>) -> Result<Vec<(String, Vec<u8>)>, Unmade> {
    let design = &wish.design;
    let dancer = dancer(wish)?;
    let patterns = tailoring::patterns_of(design, &dancer).map_err(|error| said(&error))?;
    let cuts: Vec<CutGarment> = (patterns.into_iter().zip(prints(wish)?))
        .map(|(garment, print)| {
            let repeat = garment.cloth.repeat.filter(|_| wish.cutting.matches_print);
            CutGarment {
                plans: garment.cloth_plans(wish.cutting.lay, repeat),
                garment,
                print: Some(print),
                owner: String::new(),
                stamp: Stamp::of(&printable(&wish.title), design),
            }
        })
        .collect();
    let parts = PatternParts {
        cuts: &cuts,
        size: &printable(&wish.title),
        paper: wish.paper,
        whole: &[],
        language: wish.language,
        version: env!("CARGO_PKG_VERSION"),
    };
    let files = pattern_folder(&parts, &|| !line.is_called_off());
    let files = files.map_err(|error| Unmade::of(&error))?;
    line.goes_on(1.0)?;
    Ok(files)
}

fn dancer(wish: &Wish) -> Result<Dancer, Unmade> {
    let built = lole_stage::dancer(&wish.design);
    built
        .map(|(dancer, _)| dancer)
        .map_err(|error| said(&error))
}

fn prints(wish: &Wish) -> Result<Vec<Arc<PrintImage>>, Unmade> {
    let prints = wish.design.cut_print_images(PRINT_SIDE);
    let prints = prints.map_err(|error| said(&error))?;
    Ok(prints.into_iter().map(Arc::new).collect())
}

/// She in her costume.
fn worn(wish: &Wish, line: &Line<'_>) -> Result<Worn, Unmade> {
    let production = Production::new(&wish.design).map_err(|error| said(&error))?;
    let stopped = || line.is_called_off();
    let failed = |error: PortraitError| match error {
        PortraitError::CalledOff => Unmade::CalledOff,
        PortraitError::Stage(error) => said(&error),
        PortraitError::Diverged => Unmade::Failed(flew_apart(None)),
        error => Unmade::of(&error),
    };
    let performance = portrait::stand(production, u32::MAX, &stopped).map_err(failed)?;
    portrait::of_booklet(&performance).map_err(failed)
}

/// Of an error that speaks both languages.
pub(crate) fn said(error: &impl Bilingual) -> Unmade {
    Unmade::Failed(Sentence::of(error))
}
