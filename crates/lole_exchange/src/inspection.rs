//! What is in a pattern, for people and for programs.

use lole_garment::Given;
use lole_language::Sentence;
use lole_pattern::pattern::{SeamKind, SeamSide};
use serde::Serialize;

/// What is in a pattern.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PatternInspection {
    /// What kind of file it is.
    pub format: &'static str,
    /// Its panels, in the order of their numbers.
    pub panels: Vec<InspectedPanel>,
    /// Its stitches, in the order of the file.
    pub stitches: Vec<InspectedStitch>,
    /// Cloth of all panels without allowances [m²].
    pub cloth_area_m2: f64,
    /// What the file leaves open and how it was taken, in English.
    pub notes: Vec<String>,
    #[serde(skip)]
    said: Vec<Sentence>,
}

/// A panel.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InspectedPanel {
    /// What the file calls it.
    pub name: String,
    /// Edges around it.
    pub edge_count: usize,
    /// Width and height in its own plane [cm].
    pub size_cm: [f64; 2],
    /// Its cloth without allowances [m²].
    pub area_m2: f64,
}

/// A stitch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InspectedStitch {
    /// Names of both panels.
    pub panels: [String; 2],
    /// Lengths of both edges, the shorter one first [cm].
    pub lengths_cm: [f64; 2],
    /// Whether the longer one is gathered.
    pub is_gathered: bool,
}

impl PatternInspection {
    /// Looks at a pattern.
    #[must_use]
    pub fn new(given: &Given) -> Self {
        let pieces = &given.pattern.pieces;
        let panels = pieces.iter().zip(&given.panels).map(|(piece, panel)| {
            let polygon = piece.stitching_polygon(1.0e-4);
            let bounds = polygon.bounds();
            InspectedPanel {
                name: panel.name.clone(),
                edge_count: piece.edges.len(),
                size_cm: [bounds.width(), bounds.height()].map(|size| 100.0 * size),
                area_m2: polygon.signed_area(),
            }
        });
        let panels: Vec<InspectedPanel> = panels.collect();
        let stitches = given.pattern.seams.iter().map(|seam| {
            let name = |side: SeamSide| given.panels[side.piece].name.clone();
            InspectedStitch {
                panels: [seam.flat, seam.full].map(name),
                lengths_cm: [seam.flat, seam.full].map(|side| 100.0 * side.length(pieces)),
                is_gathered: seam.kind == SeamKind::Gathered,
            }
        });
        Self {
            format: "GarmentCode",
            stitches: stitches.collect(),
            cloth_area_m2: panels.iter().map(|panel| panel.area_m2).sum(),
            panels,
            notes: given
                .notes
                .iter()
                .map(|note| note.english.clone())
                .collect(),
            said: given.notes.clone(),
        }
    }

    /// The same as sentences.
    #[must_use]
    pub fn lines(&self) -> Vec<Sentence> {
        let (panels, stitches, area) = (self.panels.len(), self.stitches.len(), self.cloth_area_m2);
        let mut lines = vec![Sentence::new(
            format!(
                "GarmentCode の型紙: {panels} 枚、縫い合わせ {stitches} か所、布 {area:.3} m²（縫い代なし）"
            ),
            format!(
                "pattern of GarmentCode: {panels} panels, {stitches} stitches, {area:.3} m² of cloth without allowances"
            ),
        )];
        for (number, panel) in (1..).zip(&self.panels) {
            let ([width, height], edges, name) = (panel.size_cm, panel.edge_count, &panel.name);
            lines.push(Sentence::new(
                format!("{number} {name}: {width:.1} × {height:.1} cm、縁 {edges} 本"),
                format!("{number} {name}: {width:.1} × {height:.1} cm, {edges} edges"),
            ));
        }
        for (number, stitch) in (1..).zip(&self.stitches) {
            let ([one, other], [short, long]) = (&stitch.panels, stitch.lengths_cm);
            let ratio = long / short;
            let [ja, en] = if stitch.is_gathered {
                [
                    format!("、{ratio:.2} 倍のギャザー"),
                    format!(", gathered {ratio:.2} times"),
                ]
            } else {
                [String::new(), String::new()]
            };
            lines.push(Sentence::new(
                format!("縫い合わせ {number}: {one} {short:.1} cm と {other} {long:.1} cm{ja}"),
                format!("stitch {number}: {one} {short:.1} cm to {other} {long:.1} cm{en}"),
            ));
        }
        lines.extend(self.said.iter().cloned());
        lines
    }
}
