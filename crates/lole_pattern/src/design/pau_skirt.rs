//! The pāʻū skirt: one rectangle, three casings with elastic, a header ruffle and a hem.
//!
//! The width of the bolt (selvage to selvage) becomes the height of the skirt and the bought
//! length becomes its circumference, closed by one seam. So the warp runs around the body, and
//! yardage does not depend on how long the skirt is.
//!
//! ```text
//!            raw edge ───────────────────────────── 0
//!            turn under  1 cm
//!   fold     (inside of the band: fold depth F)
//!   depth
//!            TOP FOLD ═════════════════════════════ top of the finished skirt
//!            header      2 cm      ruffle
//!            casing 1    1.5 cm    elastic
//!            gap         2.5 cm
//!            casing 2    1.5 cm    elastic
//!            gap         2.5 cm
//!            casing 3    1.5 cm    elastic  ← worn height: on the front hip bones
//!            skirt
//!            HEM FOLD ═════════════════════════════ L below the top fold
//!            hem         5 cm      (4 cm turned twice by 1 cm)
//!            raw edge ─────────────────────────────
//! ```
//!
//! `flat length = r·H`, `cut length = flat length + 2 seam allowances`,
//! `F = header + n·casing + (n-1)·gap`, `L = worn height - hem height + (F - casing/2)`,
//! `cut height = L + F + turn under + hem`, `elastic = q·G + overlap` for each row.
//!
//! Spacing: published sewing notes of Japanese pāʻū makers (2 / 1.5 / 2.5 / 1.5 / 2.5 / 1.5 cm);
//! American ones use 1 and ¾ inch. A kumu's own rule comes first: everything is an option.

use lole_geom::Length;
use lole_language::{Bilingual, Words, words};

use crate::pattern::THREAD_PER_STITCH;
use crate::{DraftError, ElasticRatio, GatherRatio, Yardage};

/// What the tape says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PauMeasurements {
    /// Fullest girth of the hips, `H`. The cloth is bought by it, and the skirt goes on over it.
    pub hip_girth: Length,
    /// Girth where the lowest elastic row is worn, `G`.
    pub worn_girth: Length,
    /// Height above the floor of the middle of the lowest elastic row.
    pub worn_height: Length,
}

/// What the maker decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PauOptions {
    /// Flat length over hip girth. More gives deeper folds and a heavier skirt.
    pub gather_ratio: GatherRatio,
    /// Height of the hem above the floor; one number makes a group look level.
    pub hem_height: Length,
    /// Rows of elastic: 3 for slow songs, 4 or 5 for fast ones. 1 to 6.
    pub elastic_row_count: u32,
    /// Relaxed elastic over the girth where it is worn. Less holds better and pinches more.
    pub elastic_ratio: ElasticRatio,
    /// Ruffle above the top casing.
    pub header: Length,
    /// Height of one casing between its two rows of stitches.
    pub casing: Length,
    /// Height between two casings.
    pub gap: Length,
    /// Cloth turned under at the raw edge inside the band.
    pub turn_under: Length,
    /// Cloth for the hem, its turned edge included.
    pub hem: Length,
    /// Allowance at each end of the one seam.
    pub seam_allowance: Length,
    /// Overlap where an elastic is joined to a ring.
    pub elastic_overlap: Length,
    /// Width of the cloth from selvage to selvage.
    pub fabric_width: Length,
}

impl Default for PauOptions {
    /// The usual adult skirt: 4 × hip, 22 cm above the floor, three rows, 110 cm cloth.
    fn default() -> Self {
        Self {
            gather_ratio: GatherRatio::PAU,
            hem_height: Length::from_cm(22.0),
            elastic_row_count: 3,
            elastic_ratio: ElasticRatio::PAU,
            header: Length::from_cm(2.0),
            casing: Length::from_cm(1.5),
            gap: Length::from_cm(2.5),
            turn_under: Length::from_cm(1.0),
            hem: Length::from_cm(5.0),
            seam_allowance: Length::from_cm(1.0),
            elastic_overlap: Length::from_cm(3.0),
            fabric_width: Length::from_cm(110.0),
        }
    }
}

/// One elastic in its casing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticRow {
    /// From the top fold down to the middle of the casing.
    pub from_fold: Length,
    /// Length to cut, overlap included.
    pub cut_length: Length,
    /// Relaxed length of the joined ring, without the overlap.
    pub ring_length: Length,
}

/// A line to mark or stitch across the flat cloth, parallel to the selvages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PauLine {
    /// Crease of the turned edge inside the band.
    TurnUnder,
    /// The top of the finished skirt.
    TopFold,
    /// Stitches along the upper edge of a casing.
    CasingTop,
    /// Stitches along the lower edge of a casing.
    CasingBottom,
    /// The bottom of the finished skirt.
    HemFold,
}

impl PauLine {
    /// What the line is called on a cutting plan.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::TurnUnder => "crease of the turned edge",
            Self::TopFold => "top fold",
            Self::CasingTop => "casing, upper stitches",
            Self::CasingBottom => "casing, lower stitches",
            Self::HemFold => "hem fold",
        }
    }
}

/// One of the lines across the flat cloth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkedLine {
    /// What it is for.
    pub kind: PauLine,
    /// Distance from the raw top edge.
    pub from_edge: Length,
}

/// A pāʻū skirt or top ready to cut: a rectangle gathered onto rows of elastic.
#[derive(Debug, Clone, PartialEq)]
pub struct PauDraft {
    /// Circumference of the sewn, flat cloth: `r·H`, along the warp.
    pub flat_length: Length,
    /// From the top fold to the hem fold, `L`.
    pub finished_length: Length,
    /// Length to cut along the selvage: flat length and two seam allowances.
    pub cut_length: Length,
    /// Height to cut across the bolt.
    pub cut_height: Length,
    /// Depth of the doubled band below the top fold, `F`.
    pub fold_depth: Length,
    /// Depth of the doubled hem above the hem fold.
    pub hem_depth: Length,
    /// Elastics from the top down; the last is worn at the worn height.
    pub elastic_rows: Vec<ElasticRow>,
    /// How many of them, from the top, run in casings of the folded band; the others run in tapes
    /// that are sewn on inside.
    pub band_row_count: usize,
    /// All elastics together.
    pub elastic_total: Length,
    /// Lines across the cloth, from the raw top edge down.
    pub lines: Vec<MarkedLine>,
    /// Cloth to buy.
    pub yardage: Yardage,
    /// Sewing thread, machine sewn.
    pub thread: Length,
    /// What the maker should know before cutting.
    pub warnings: Vec<PauWarning>,
}

/// Something that can be sewn but should be decided knowingly.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PauWarning {
    /// The piece is taller than the bolt is wide.
    #[error(
        "the piece is {cut_cm:.1} cm tall and the cloth {width_cm:.1} cm wide; \
         shorten the skirt to {longest_cm:.1} cm, use fewer elastic rows or wider cloth"
    )]
    TallerThanCloth {
        /// Height to cut [cm].
        cut_cm: f64,
        /// Width of the cloth [cm].
        width_cm: f64,
        /// Longest finished length this cloth allows [cm].
        longest_cm: f64,
    },
    /// An elastic has to stretch further than flat braided elastic does.
    #[error(
        "a ring of elastic of {ring_cm:.1} cm does not go over hips of {hip_cm:.1} cm (flat braided \
         elastic stretches {limit:.1} times); make the ring at least {least_cm:.1} cm, or use softer \
         elastic"
    )]
    ElasticStretch {
        /// The sewn ring of the tightest elastic, at rest [cm].
        ring_cm: f64,
        /// Girth of the hips [cm].
        hip_cm: f64,
        /// Smallest ring that goes over them [cm].
        least_cm: f64,
        /// Stretch a braided elastic gives.
        limit: f64,
    },
    /// The band is fuller than the elastic can gather evenly.
    #[error(
        "the gathers leave {per_cm:.1} cm of cloth on each cm of elastic at rest; \
         expect a bulky band, or lower the gather ratio"
    )]
    BulkyBand {
        /// Flat cloth over relaxed elastic.
        per_cm: f64,
    },
}

impl Bilingual for PauWarning {
    fn japanese(&self) -> String {
        match self {
            Self::TallerThanCloth {
                cut_cm,
                width_cm,
                longest_cm,
            } => format!(
                "裁ち丈が {cut_cm:.1} cm で、布幅 {width_cm:.1} cm に収まりません。\
                 丈を {longest_cm:.1} cm までにするか、ゴムの段を減らすか、幅の広い布にしてください"
            ),
            Self::ElasticStretch {
                ring_cm,
                hip_cm,
                least_cm,
                limit,
            } => format!(
                "輪にして {ring_cm:.1} cm のゴムは、{hip_cm:.1} cm のヒップを通りません（コールゴムは {limit:.1} 倍まで伸びます）。\
                 輪を {least_cm:.1} cm 以上にするか、よく伸びるソフトゴムを使ってください"
            ),
            Self::BulkyBand { per_cm } => format!(
                "縮んだゴム 1 cm あたり布が {per_cm:.1} cm になります。腰まわりが厚くなるので、\
                 気になるときはギャザーの倍率を下げてください"
            ),
        }
    }
}

/// Stretch of flat braided ("kooru") elastic before it is overstrained; dressmaking references.
const BRAIDED_ELASTIC_STRETCH: f64 = 1.8;

/// Cloth over relaxed elastic above which four layers of broadcloth crowd the casing: 5 yards on
/// a 91 cm hip (6.5) is the fullest that makers describe.
const CROWDED_BAND: f64 = 6.5;

/// Drafts a pāʻū skirt.
///
/// # Errors
/// Measurements or options that no skirt can be sewn from, see [`DraftError`].
pub fn draft_pau_skirt(
    measurements: &PauMeasurements,
    options: &PauOptions,
) -> Result<PauDraft, DraftError> {
    check_measurements(measurements)?;
    check_options(options)?;
    let flat_length = measurements.hip_girth * options.gather_ratio.get();
    if flat_length < measurements.worn_girth {
        return Err(DraftError::TooNarrow {
            flat_cm: flat_length.to_cm(),
            worn_cm: measurements.worn_girth.to_cm(),
            ratio: measurements.worn_girth.to_cm() / measurements.hip_girth.to_cm(),
        });
    }

    let fold_depth = fold_depth(options);
    let finished_length =
        measurements.worn_height - options.hem_height + (fold_depth - options.casing * 0.5);
    if finished_length <= fold_depth + options.hem {
        return Err(DraftError::TooShort {
            hem_cm: options.hem_height.to_cm(),
            finished_cm: finished_length.to_cm(),
            band_cm: fold_depth.to_cm(),
        });
    }

    let cut_length = flat_length + options.seam_allowance * 2.0;
    let cut_height = finished_length + fold_depth + options.turn_under + options.hem;
    let elastic_rows = elastic_rows(measurements.worn_girth, options);
    let elastic_total = elastic_rows
        .iter()
        .fold(Length::ZERO, |sum, row| sum + row.cut_length);
    Ok(PauDraft {
        flat_length,
        finished_length,
        cut_length,
        cut_height,
        fold_depth,
        hem_depth: options.hem,
        band_row_count: elastic_rows.len(),
        lines: marked_lines(&elastic_rows, finished_length, options),
        elastic_rows,
        elastic_total,
        yardage: Yardage::for_gathered(cut_length),
        thread: thread(options.elastic_row_count, cut_length, cut_height),
        warnings: warnings(measurements, options, cut_height),
    })
}

/// Longest finished length that a cloth allows: its width less fold, turn under and hem.
#[must_use]
pub fn longest_finished_length(options: &PauOptions) -> Length {
    options.fabric_width - fold_depth(options) - options.turn_under - options.hem
}

/// `F = header + n·casing + (n-1)·gap`.
pub(super) fn fold_depth(options: &PauOptions) -> Length {
    let rows = f64::from(options.elastic_row_count);
    options.header + options.casing * rows + options.gap * (rows - 1.0)
}

/// Distance from the top fold to the upper edge of casing `row`, counted from 0.
fn casing_top(row: u32, options: &PauOptions) -> Length {
    options.header + (options.casing + options.gap) * f64::from(row)
}

fn elastic_rows(worn_girth: Length, options: &PauOptions) -> Vec<ElasticRow> {
    let ring_length = worn_girth * options.elastic_ratio.get();
    (0..options.elastic_row_count)
        .map(|row| ElasticRow {
            from_fold: casing_top(row, options) + options.casing * 0.5,
            cut_length: ring_length + options.elastic_overlap,
            ring_length,
        })
        .collect()
}

/// Lines across the cloth, from the raw top edge down, around these elastics.
pub(super) fn marked_lines(
    elastic_rows: &[ElasticRow],
    finished_length: Length,
    options: &PauOptions,
) -> Vec<MarkedLine> {
    let fold = options.turn_under + fold_depth(options);
    let line = |kind, from_edge| MarkedLine { kind, from_edge };
    let mut lines = vec![
        line(PauLine::TurnUnder, options.turn_under),
        line(PauLine::TopFold, fold),
    ];
    for row in elastic_rows {
        let middle = fold + row.from_fold;
        lines.push(line(PauLine::CasingTop, middle - options.casing * 0.5));
        lines.push(line(PauLine::CasingBottom, middle + options.casing * 0.5));
    }
    lines.push(line(PauLine::HemFold, fold + finished_length));
    lines
}

/// Two rows of stitches for each casing, two to neaten the edges, one for the hem, and the seam.
pub(super) fn thread(row_count: u32, cut_length: Length, cut_height: Length) -> Length {
    let rounds = f64::from(2 * row_count + 3);
    (cut_length * rounds + cut_height) * THREAD_PER_STITCH
}

fn warnings(
    measurements: &PauMeasurements,
    options: &PauOptions,
    cut_height: Length,
) -> Vec<PauWarning> {
    let mut warnings = Vec::new();
    if options.fabric_width < cut_height {
        warnings.push(PauWarning::TallerThanCloth {
            cut_cm: cut_height.to_cm(),
            width_cm: options.fabric_width.to_cm(),
            longest_cm: longest_finished_length(options).to_cm(),
        });
    }
    let ring_cm = measurements.worn_girth.to_cm() * options.elastic_ratio.get();
    let hip_cm = measurements.hip_girth.to_cm();
    if BRAIDED_ELASTIC_STRETCH * ring_cm < hip_cm {
        warnings.push(PauWarning::ElasticStretch {
            ring_cm,
            hip_cm,
            // The next millimeter.
            least_cm: (10.0 * hip_cm / BRAIDED_ELASTIC_STRETCH).ceil() / 10.0,
            limit: BRAIDED_ELASTIC_STRETCH,
        });
    }
    let per_cm = hip_cm * options.gather_ratio.get() / ring_cm;
    if CROWDED_BAND < per_cm {
        warnings.push(PauWarning::BulkyBand { per_cm });
    }
    warnings
}

/// Girths from a small child to the largest tape, heights from a toddler's hips to a tall
/// dancer's waist: beyond them a number was typed in the wrong unit.
fn check_measurements(measurements: &PauMeasurements) -> Result<(), DraftError> {
    check_length(
        words("ヒップ", "the hip girth"),
        measurements.hip_girth,
        40.0,
        200.0,
    )?;
    check_length(
        words("はく位置の胴回り", "the girth where the skirt is worn"),
        measurements.worn_girth,
        35.0,
        200.0,
    )?;
    check_length(
        words("はく位置の高さ", "the height where the skirt is worn"),
        measurements.worn_height,
        30.0,
        140.0,
    )
}

pub(super) fn check_options(options: &PauOptions) -> Result<(), DraftError> {
    if !(1..=6).contains(&options.elastic_row_count) {
        return Err(DraftError::ElasticRowCount {
            count: options.elastic_row_count,
        });
    }
    check_length(
        words("床から裾までの高さ", "the hem's height above the floor"),
        options.hem_height,
        0.0,
        100.0,
    )?;
    check_length(words("上のフリル", "the header"), options.header, 0.0, 15.0)?;
    check_length(
        words("ゴム通しの幅", "the casing"),
        options.casing,
        0.5,
        10.0,
    )?;
    check_length(
        words("ゴム通しの間隔", "the gap between casings"),
        options.gap,
        0.0,
        15.0,
    )?;
    check_length(
        words("折り代", "the turned edge"),
        options.turn_under,
        0.0,
        5.0,
    )?;
    check_length(
        words("裾上げの分", "the hem allowance"),
        options.hem,
        0.0,
        30.0,
    )?;
    check_length(
        words("縫い代", "the seam allowance"),
        options.seam_allowance,
        0.0,
        10.0,
    )?;
    check_length(
        words("ゴムの重なり", "the overlap of the elastic"),
        options.elastic_overlap,
        0.0,
        10.0,
    )?;
    check_length(
        words("布幅", "the width of the cloth"),
        options.fabric_width,
        30.0,
        400.0,
    )
}

pub(super) fn check_length(
    what: Words,
    length: Length,
    min_cm: f64,
    max_cm: f64,
) -> Result<(), DraftError> {
    let cm = length.to_cm();
    // Tolerance for the conversion to meters and back, far below a tape's millimeter.
    if (min_cm - 1e-9..=max_cm + 1e-9).contains(&cm) {
        Ok(())
    } else {
        Err(DraftError::Length {
            what,
            cm,
            min_cm,
            max_cm,
        })
    }
}
