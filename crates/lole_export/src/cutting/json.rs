//! The pattern for programs: sizes, pieces as polygons, cut plans.

use kurbo::Point;
use lole_language::{Bilingual as _, Sentence, Words};
use lole_pattern::marker::{Lay, MarkerWarning, Nap, Placed};
use lole_pattern::pattern::Amount;
use lole_pattern::piece::{ClothRole, CutCount, Finish, Piece};
use serde::Serialize;

use super::{CutGarment, TOLERANCE};
use crate::ExportError;

/// A text in both languages.
#[derive(Serialize)]
struct Both {
    ja: String,
    en: String,
}

impl Both {
    fn words(words: Words) -> Self {
        Self {
            ja: words.japanese.to_owned(),
            en: words.english.to_owned(),
        }
    }

    fn sentence(sentence: &Sentence) -> Self {
        Self {
            ja: sentence.japanese.clone(),
            en: sentence.english.clone(),
        }
    }

    fn warning(warning: &MarkerWarning) -> Self {
        Self {
            ja: warning.japanese(),
            en: warning.to_string(),
        }
    }
}

#[derive(Serialize)]
struct File {
    lole: &'static str,
    unit: &'static str,
    garments: Vec<GarmentRow>,
}

#[derive(Serialize)]
struct GarmentRow {
    id: String,
    name: Both,
    pieces: Vec<PieceRow>,
    cloths: Vec<ClothRow>,
    notions: Vec<NotionRow>,
    warnings: Vec<Both>,
}

#[derive(Serialize)]
struct PieceRow {
    id: &'static str,
    name: Both,
    cloth: &'static str,
    cut_pieces: u32,
    is_pair: bool,
    is_rectangle: bool,
    width_cm: f64,
    height_cm: f64,
    area_cm2: f64,
    grain: [f64; 2],
    cut_line_cm: Vec<[f64; 2]>,
    edges: Vec<EdgeRow>,
}

#[derive(Serialize)]
struct EdgeRow {
    id: &'static str,
    finish: &'static str,
    allowance_cm: f64,
    length_cm: f64,
    stitching_line_cm: Vec<[f64; 2]>,
}

#[derive(Serialize)]
struct ClothRow {
    role: &'static str,
    name: Both,
    width_cm: f64,
    nap: &'static str,
    lay: &'static str,
    needed_cm: f64,
    buy_m: f64,
    buy_yd: f64,
    mass_kg: f64,
    efficiency: f64,
    placed: Vec<PlacedRow>,
    warnings: Vec<Both>,
}

#[derive(Serialize)]
struct PlacedRow {
    piece: &'static str,
    copy: u32,
    layers: u32,
    on_fold: bool,
    /// `x' = a x + c y + e`, `y' = b x + d y + f` [cm]: from the piece to the cloth.
    cloth_from_piece: [f64; 6],
}

#[derive(Serialize)]
struct NotionRow {
    name: Both,
    #[serde(skip_serializing_if = "Option::is_none")]
    length_cm: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    count: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mass_kg: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<Both>,
}

/// Writes the garments as JSON; lengths are centimeters.
///
/// # Errors
/// [`ExportError::Encoding`], never met: every value is a number or a text.
pub fn pattern_json(garments: &[CutGarment], version: &'static str) -> Result<String, ExportError> {
    let file = File {
        lole: version,
        unit: "cm",
        garments: garments.iter().map(garment_row).collect(),
    };
    serde_json::to_string_pretty(&file).map_err(|error| ExportError::Encoding {
        file: "JSON",
        cause: error.to_string(),
    })
}

fn garment_row(cut: &CutGarment) -> GarmentRow {
    let pattern = &cut.garment.pattern;
    let cloths = cut.plans.iter().map(|plan| {
        let marker = &plan.marker;
        ClothRow {
            role: role_id(plan.role),
            name: Both::words(cut.garment.cloth.name),
            width_cm: micrometers(marker.cloth.width.to_cm()),
            nap: match marker.cloth.nap {
                Nap::AllWays | Nap::TwoWay => "two-way",
                Nap::OneWay => "one-way",
            },
            lay: match marker.cloth.lay {
                Lay::Single => "single",
                Lay::Folded => "folded",
            },
            needed_cm: micrometers(marker.yardage.needed.to_cm()),
            buy_m: micrometers(marker.yardage.metric.to_m()),
            buy_yd: micrometers(marker.yardage.imperial.to_yd()),
            mass_kg: micrometers(plan.mass),
            efficiency: micrometers(marker.efficiency),
            placed: (marker.placed.iter())
                .map(|placed| placed_row(placed, &cut.garment.cutting().pieces[placed.piece]))
                .collect(),
            warnings: marker.warnings.iter().map(Both::warning).collect(),
        }
    });
    let notions = pattern.notions.iter().map(|notion| {
        let [mut length_cm, mut mass_kg] = [None, None];
        let mut count = None;
        match notion.amount {
            Amount::Length(length) => length_cm = Some(micrometers(length.to_cm())),
            Amount::Count(number) => count = Some(number),
            Amount::Mass(mass) => mass_kg = Some(micrometers(mass)),
        }
        NotionRow {
            name: Both::words(notion.name),
            length_cm,
            count,
            mass_kg,
            note: notion.note.as_ref().map(Both::sentence),
        }
    });
    GarmentRow {
        id: cut.garment.id.clone(),
        name: Both::words(cut.garment.name),
        pieces: (cut.garment.cutting().pieces.iter())
            .map(piece_row)
            .collect(),
        cloths: cloths.collect(),
        notions: notions.collect(),
        warnings: pattern.warnings.iter().map(Both::sentence).collect(),
    }
}

fn piece_row(piece: &Piece) -> PieceRow {
    let whole = piece.unfolded();
    let drawing = whole.drawing(TOLERANCE);
    let bounds = drawing.cut.bounds();
    let edges = whole.edges.iter().map(|edge| EdgeRow {
        id: edge.id,
        finish: match edge.finish {
            Finish::Seam => "seam",
            Finish::Hem => "hem",
            Finish::Fold => "fold",
            Finish::Selvage => "selvage",
            Finish::Raw => "raw",
        },
        allowance_cm: micrometers(edge.allowance.to_cm()),
        length_cm: micrometers(100.0 * edge.length()),
        stitching_line_cm: edge.points(TOLERANCE).into_iter().map(point).collect(),
    });
    PieceRow {
        id: piece.id,
        name: Both::words(piece.name),
        cloth: role_id(piece.cloth),
        cut_pieces: piece.cut.pieces(),
        is_pair: matches!(piece.cut, CutCount::Pairs(_)),
        is_rectangle: drawing.rectangle.is_some(),
        width_cm: micrometers(100.0 * bounds.width()),
        height_cm: micrometers(100.0 * bounds.height()),
        area_cm2: micrometers(1e4 * drawing.cut.signed_area()),
        grain: [micrometers(whole.grain.x), micrometers(whole.grain.y)],
        cut_line_cm: drawing.cut.points.iter().copied().map(point).collect(),
        edges: edges.collect(),
    }
}

fn placed_row(placed: &Placed, piece: &Piece) -> PlacedRow {
    let [a, b, c, d, e, f] = placed.cloth_from_piece.as_coeffs();
    PlacedRow {
        piece: piece.id,
        copy: placed.copy,
        layers: placed.layers,
        on_fold: placed.is_on_fold,
        cloth_from_piece: [a, b, c, d, 100.0 * e, 100.0 * f].map(micrometers),
    }
}

const fn role_id(role: ClothRole) -> &'static str {
    match role {
        ClothRole::Main => "main",
        ClothRole::Contrast => "contrast",
        ClothRole::Lining => "lining",
        ClothRole::Interfacing => "interfacing",
    }
}

fn point(at: Point) -> [f64; 2] {
    [100.0 * at.x, 100.0 * at.y].map(micrometers)
}

/// Four digits behind the point: micrometers of centimeters, and nothing of rounding noise.
fn micrometers(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}
