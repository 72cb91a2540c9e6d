//! The pāʻū top: a tube of cloth held above the bust by elastic in casings, and below it where there
//! are rows for it; the rest hangs free.
//!
//! ```text
//!            raw edge ───────────────────────────── 0
//!            turn under  1 cm
//!   fold     (inside of the upper band: fold depth F)
//!   depth
//!            TOP FOLD ═════════════════════════════ top of the finished top
//!            header      2.5 cm    ruffle
//!            casing 1    2.5 cm    elastic, above the bust
//!            bust        T         from elastic to elastic, over the bust
//!            casing 2    2.5 cm    elastic on a tape, below the bust
//!            frill
//!            HEM FOLD ═════════════════════════════ L below the top fold
//!            hem
//!            raw edge ─────────────────────────────
//! ```
//!
//! `flat length = r·B`, `F = header + n·casing + (n-1)·gap`,
//! `L = F - casing/2 + T + (m-1)·(casing + gap) + frill`, where `B` is the bust girth, `n` and `m` the
//! upper and lower rows, and `frill` the height of the lowest elastic over the hem. Without lower
//! rows `T` and their term are left out.
//!
//! Cloth of twice the widest girth, a ruffle of an inch and a casing of an inch and a quarter: a
//! tube top's published sewing notes; everything is an option.

use lole_geom::Length;

use super::pau_skirt::{
    ElasticRow, PauDraft, PauMeasurements, PauOptions, check_length, check_options, fold_depth,
    marked_lines, thread,
};
use crate::{DraftError, Yardage};
use lole_language::words;

/// What the tape says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopMeasurements {
    /// Fullest girth of the bust, `B`.
    pub bust_girth: Length,
    /// Girth at the upper rows.
    pub upper_girth: Length,
    /// Where the lowest elastic is worn: girth and height above the floor.
    pub lowest: (Length, Length),
    /// From the lowest upper row down over the bust to the first lower row, along the body, `T`
    /// without ease; `None` without lower rows.
    pub trunk: Option<Length>,
}

/// What the maker decides beside [`PauOptions`], of which the elastic rows are the upper ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopOptions {
    /// Rows, casings, gathers, hem height and cloth.
    pub cut: PauOptions,
    /// Rows of elastic below the bust, 0 to 3.
    pub lower_row_count: u32,
}

/// Cloth over the bust is this much longer than the way it goes, so that it blouses a little and
/// never pulls the elastics together.
const EASE: f64 = 1.06;

/// Drafts a pāʻū top.
///
/// # Errors
/// Measurements or options that no top can be sewn from, see [`DraftError`].
pub fn draft_pau_top(
    measurements: &TopMeasurements,
    options: &TopOptions,
) -> Result<PauDraft, DraftError> {
    let cut = &options.cut;
    check_length(
        words("バスト", "the bust girth"),
        measurements.bust_girth,
        40.0,
        200.0,
    )?;
    check_length(
        words("床から裾までの高さ", "the hem's height above the floor"),
        cut.hem_height,
        0.0,
        170.0,
    )?;
    check_options(&PauOptions {
        hem_height: Length::ZERO,
        ..*cut
    })?;
    let flat_length = measurements.bust_girth * cut.gather_ratio.get();
    let (lowest_girth, lowest_height) = measurements.lowest;
    let widest = measurements.upper_girth.to_cm().max(lowest_girth.to_cm());
    if flat_length.to_cm() < widest {
        return Err(DraftError::TooNarrow {
            flat_cm: flat_length.to_cm(),
            worn_cm: widest,
            ratio: widest / measurements.bust_girth.to_cm(),
        });
    }
    let fold_depth = fold_depth(cut);
    let elastic_rows = elastic_rows(measurements, options);
    let lowest = elastic_rows
        .last()
        .map_or(Length::ZERO, |row| row.from_fold);
    let finished_length = lowest + (lowest_height - cut.hem_height);
    if finished_length <= lowest + cut.casing * 0.5 + cut.hem {
        return Err(DraftError::TooShort {
            hem_cm: cut.hem_height.to_cm(),
            finished_cm: finished_length.to_cm(),
            band_cm: (lowest + cut.casing * 0.5 + cut.hem).to_cm(),
        });
    }
    let cut_length = flat_length + cut.seam_allowance * 2.0;
    let cut_height = finished_length + fold_depth + cut.turn_under + cut.hem;
    let elastic_total = elastic_rows
        .iter()
        .fold(Length::ZERO, |sum, row| sum + row.cut_length);
    let row_count = cut.elastic_row_count + options.lower_row_count;
    Ok(PauDraft {
        flat_length,
        finished_length,
        cut_length,
        cut_height,
        fold_depth,
        hem_depth: cut.hem,
        band_row_count: elastic_rows.len().min(cut.elastic_row_count as usize),
        lines: marked_lines(&elastic_rows, finished_length, cut),
        elastic_rows,
        elastic_total,
        yardage: Yardage::for_gathered(cut_length),
        thread: thread(row_count, cut_length, cut_height),
        warnings: Vec::new(),
    })
}

/// Elastics from the top down.
fn elastic_rows(measurements: &TopMeasurements, options: &TopOptions) -> Vec<ElasticRow> {
    let cut = &options.cut;
    let pitch = cut.casing + cut.gap;
    let row = |from_fold: Length, girth: Length| {
        let ring_length = girth * cut.elastic_ratio.get();
        ElasticRow {
            from_fold,
            cut_length: ring_length + cut.elastic_overlap,
            ring_length,
        }
    };
    let first = cut.header + cut.casing * 0.5;
    let upper_count = cut.elastic_row_count;
    let mut rows: Vec<ElasticRow> = (0..upper_count)
        .map(|index| row(first + pitch * f64::from(index), measurements.upper_girth))
        .collect();
    if let Some(trunk) = measurements.trunk {
        let upper = first + pitch * f64::from(upper_count - 1);
        let lower = (0..options.lower_row_count).map(|index| {
            let from_fold = upper + trunk * EASE + pitch * f64::from(index);
            row(from_fold, measurements.lowest.0)
        });
        rows.extend(lower);
    }
    rows
}

impl TopMeasurements {
    /// Where the top is worn, as for a skirt: by its lowest elastic.
    #[must_use]
    pub const fn worn(&self) -> PauMeasurements {
        PauMeasurements {
            hip_girth: self.bust_girth,
            worn_girth: self.lowest.0,
            worn_height: self.lowest.1,
        }
    }
}
