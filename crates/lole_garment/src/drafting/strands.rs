//! What skirts of strands share: a band of cloth with elastic, to which they are sewn.

use lole_geom::Length;
use lole_language::{Sentence, words};
use lole_pattern::pattern::{Notion, Seam, Step};
use lole_pattern::piece::{CutCount, Finish, LineKind, Piece};
use lole_pattern::{DraftError, Measure, Measures};

use super::chosen::Chosen;
use super::making::{cm, edges_of, elastic, plain, say, side, step, stitching};
use super::shape::{AROUND, CM, Label, across, rectangle};

/// Allowance of the seams [m].
const SEAM: f64 = 1.0 * CM;
/// Overlap where the elastic is joined [m].
const OVERLAP: f64 = 3.0 * CM;
/// Relaxed elastic over the girth where it is worn.
const ELASTIC_RATIO: f64 = 0.85;
/// Cloth of the band over the hips: it must pass over them.
const BAND_EASE: f64 = 1.05;

/// The option of the hem of a skirt of strands.
pub(crate) const STRANDS_HEM: lole_language::Words = words(
    "床から裾まで。書かなければひざ",
    "hem above the floor; left out: at the knees",
);

/// Whether a skirt of strands whose upper edge is at a height, and which is fastened so far below it [m], lies on hips
/// and not on legs.
pub(crate) fn is_on_hips(measures: &Measures, height: f64, below: f64) -> Result<(), DraftError> {
    let Some(lowest) = measures.trunk.first() else {
        return Ok(());
    };
    let least = lowest.height.to_m() + below;
    if height < least {
        return Err(DraftError::WornTooLow {
            worn_cm: height / CM,
            least_cm: (least / CM).ceil(),
        });
    }
    Ok(())
}

/// Where a skirt of strands is worn, and how long it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hung {
    /// Girth where it is worn [m].
    pub(crate) girth: f64,
    /// Fullest girth of the hips [m].
    pub(crate) hips: f64,
    /// From the band's upper edge to the strands' ends [m].
    pub(crate) length: f64,
}

impl Hung {
    /// From the options `hem_height_cm` and `worn_height_cm`.
    pub(crate) fn of(measures: &Measures, chosen: &Chosen<'_>) -> Result<Self, DraftError> {
        measures.check(&[
            Measure::HipGirth,
            Measure::HipBoneHeight,
            Measure::KneeHeight,
        ])?;
        let height = chosen.m_or("worn_height_cm", measures.hip_bone_height.to_m());
        is_on_hips(measures, height, 0.0)?;
        let girth = measures.girth_at(Length::from_m(height));
        let hem = chosen.m_or("hem_height_cm", measures.knee_height.to_m());
        let length = height - hem;
        if length < LEAST_LENGTH {
            return Err(DraftError::TooShort {
                hem_cm: hem / CM,
                finished_cm: length / CM,
                band_cm: LEAST_LENGTH / CM,
            });
        }
        Ok(Self {
            girth: girth.unwrap_or(measures.hip_girth).to_m(),
            hips: measures.hip_girth.to_m(),
            length,
        })
    }
}

/// A skirt of strands has at least this length [m].
const LEAST_LENGTH: f64 = 15.0 * CM;

/// A band of cloth, folded lengthwise around its elastic.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Band {
    /// Around, sewn [m].
    length: f64,
    /// Height once it is folded [m].
    height: f64,
    /// Elastic to cut [m].
    elastic: f64,
}

impl Band {
    pub(crate) fn new(worn: &Hung, height: f64) -> Self {
        Self {
            length: worn.hips * BAND_EASE,
            height,
            elastic: worn.girth * ELASTIC_RATIO + OVERLAP,
        }
    }

    pub(crate) const fn length(&self) -> f64 {
        self.length
    }

    pub(crate) fn piece(&self) -> Piece {
        let sides = [
            ("lower", Finish::Seam, SEAM),
            ("left_end", Finish::Seam, SEAM),
            ("upper", Finish::Seam, SEAM),
            ("right_end", Finish::Seam, SEAM),
        ];
        let label = Label::main("band", words("腰の帯", "band"), CutCount::Alike(1));
        let mut piece = rectangle(label, [self.length, 2.0 * self.height], sides, AROUND);
        piece.marks = vec![across(LineKind::TopFold, self.height, [0.0, self.length])];
        piece
    }

    /// Its ends, and its long edges on each other: those run against each other.
    pub(crate) fn seams(piece: usize) -> Vec<Seam> {
        vec![
            plain(side(piece, 0, 1), side(piece, 0, 3).back()),
            plain(side(piece, 0, 0), side(piece, 0, 2).back()),
        ]
    }

    pub(crate) fn elastic(&self) -> Notion {
        // It lies flat in the folded band, with a few millimeters of room.
        let name = match self.height / CM {
            cm if cm < 2.7 => words("1.5 cm 幅の平ゴム", "flat elastic (1.5 cm)"),
            cm if cm < 3.8 => words("2～2.5 cm 幅の平ゴム", "flat elastic (2 to 2.5 cm)"),
            cm if cm < 5.0 => words("3～3.5 cm 幅の平ゴム", "flat elastic (3 to 3.5 cm)"),
            _ => words(
                "平ゴム（帯より 1 cm 細いもの）",
                "flat elastic (1 cm narrower than the band)",
            ),
        };
        elastic(name, 1, self.elastic)
    }

    /// Cutting and closing, before strands are laid in.
    pub(crate) fn first_steps(&self) -> Vec<Step> {
        let [cut_cm, height_cm, ring_cm] = [
            self.length + 2.0 * SEAM,
            2.0 * self.height + 2.0 * SEAM,
            self.length,
        ]
        .map(cm);
        vec![
            step(
                words("帯を裁つ", "Cut the band"),
                say!(
                    "耳に沿って {cut_cm} cm、幅 {height_cm} cm の帯を裁ちます。",
                    "Cut a band of {cut_cm} cm along the selvage, {height_cm} cm wide."
                ),
                [10.0, 10.0],
            )
            .shown(edges_of(0, &[0, 1, 2, 3])),
            step(
                words("輪にして折る", "Close and fold it"),
                say!(
                    "短い端どうしをゴム通し口を残して縫い、{ring_cm} cm の輪にします。縫い代を折り、長い方を二つ折りにしてアイロンをかけます。",
                    "Sew the short ends to a ring of {ring_cm} cm, leaving a gap for the elastic. Fold the long allowances in, fold the band in half along its length and press."
                ),
                stitching(2.0 * self.height),
            )
            .shown(edges_of(0, &[1, 3])),
        ]
    }

    /// Strands between its long edges, then the elastic. `strands` says how they lie.
    pub(crate) fn last_steps(&self, strands: Sentence, minutes: [f64; 2]) -> Vec<Step> {
        let [elastic_cm, overlap_cm] = [self.elastic, OVERLAP].map(cm);
        vec![
            step(words("束を付ける", "Set in the strands"), strands, minutes)
                .shown(edges_of(0, &[0, 2])),
            step(
                words("ゴムを通す", "Draw in the elastic"),
                say!(
                    "{elastic_cm} cm のゴムを通し、端を {overlap_cm} cm 重ねて縫い、口を閉じます。",
                    "Draw in {elastic_cm} cm of elastic, overlap its ends by {overlap_cm} cm, sew them and close the gap."
                ),
                stitching(0.3),
            ),
        ]
    }
}
