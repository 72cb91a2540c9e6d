//! Six built dancers from small to large: those on whom everything of the house must fit.

use lole_body::Figure;
use lole_costume::document::DancerDesign;

/// Six built dancers from small to large: name, figure, stature, bust, waist and hip [cm].
const DANCERS: [(&str, Figure, [Option<f64>; 4]); 6] = [
    (
        "child",
        Figure::Child,
        [Some(110.0), Some(56.0), Some(51.0), Some(58.0)],
    ),
    (
        "small",
        Figure::Woman,
        [Some(150.0), Some(80.0), Some(62.0), Some(86.0)],
    ),
    ("mean", Figure::Woman, [None; 4]),
    (
        "tall",
        Figure::Woman,
        [Some(173.0), Some(90.0), Some(70.0), Some(97.0)],
    ),
    (
        "large",
        Figure::Woman,
        [Some(163.0), Some(102.0), Some(90.0), Some(106.0)],
    ),
    ("man", Figure::Man, [None; 4]),
];

/// Six built dancers from small to large, by name: those on whom everything of the house must fit.
#[must_use]
pub fn six_dancers() -> [(&'static str, DancerDesign); 6] {
    DANCERS.map(|(name, figure, [stature_cm, bust_cm, waist_cm, hip_cm])| {
        let design = DancerDesign {
            figure,
            stature_cm,
            bust_cm,
            waist_cm,
            hip_cm,
            ..DancerDesign::default()
        };
        (name, design)
    })
}
