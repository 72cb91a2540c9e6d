//! In which size a garment of a file is sewn for a body, and where it hangs on her.
//!
//! Panels were drafted for somebody else. What hangs from the shoulders keeps its size unless it would not close
//! around her; what is worn from a band slides to where the band fits, and changes its size only where it fits
//! nowhere. Whatever is changed is told.

use lole_geom::{Length, narrow};
use lole_language::{Sentence, Words, words};

use super::around::Around;
use super::{Given, Origin};
use crate::fitting::Fitting;

/// Cloth around the trunk over the body there, at least, of what hangs from the shoulders.
const LEAST_EASE: f64 = 1.03;
/// The same of a band that is worn: it lies on the skin.
const BAND: f64 = 1.01;
/// A garment whose highest level lies above this hangs from the shoulders, by where places are counted from [m]:
/// the armpits of the formats' bodies lie below it, and their shoulders above.
const SHOULDERS: [f64; 2] = [1.30, 0.20];
/// A band above this is worn above the waist [m].
const HIGH_BANDS: [f64; 2] = [1.12, 0.04];
/// Distance of levels that are looked at [m].
const STEP: f64 = 0.02;
/// How far below the upper end of its sides a garment closes around her for certain [m].
const BELOW_SIDES: f64 = 0.01;
/// How far below its upper edge the length of a band is taken that has no free edge [m].
const BELOW_EDGE: f64 = 0.004;
/// Cloth lies this far above the skin on the shoulder [m].
const OVER_SHOULDER: f64 = 0.010;
/// Below the armpits cloth may be narrower than the tape over the arms' folds [m].
const BELOW_ARMPIT: f64 = 0.03;

/// What a garment of a file hangs from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hang {
    /// The shoulders.
    Shoulders,
    /// Its upper edge, which is held around the trunk.
    Band,
}

/// The size of a garment for a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Size {
    /// All lengths over those of the file.
    pub ratio: f64,
    /// What it hangs from.
    pub hang: Hang,
    /// Its highest level in the space of the file's body [m], and the height above the floor where that comes to
    /// lie on her [m].
    pub top: [f64; 2],
    /// What was changed and why, one sentence each.
    pub notes: Vec<Sentence>,
}

impl Size {
    /// The size for one body; `chosen` by the maker instead of what can be worn.
    #[must_use]
    pub fn new(given: &Given, fitting: &Fitting<'_>, chosen: Option<f64>) -> Self {
        let around = Around::new(given);
        let Some([_, top]) = around.levels() else {
            return Self {
                ratio: chosen.unwrap_or(1.0),
                hang: Hang::Shoulders,
                top: [0.0, fitting.measures.neck_height.to_m()],
                notes: Vec::new(),
            };
        };
        let origin = usize::from(given.origin == Origin::Trunk);
        if SHOULDERS[origin] < top {
            let sides = around.end_of_sides(given, top);
            return Self::from_shoulders(&around, fitting, (top, sides, chosen));
        }
        let measures = fitting.measures;
        let (from, reach) = if HIGH_BANDS[origin] < top {
            let reach = [measures.armpit_height, measures.waist_height];
            (words("わきの下", "armpits"), reach)
        } else {
            let reach = [measures.waist_height, measures.hip_height];
            (words("ウエスト", "waist"), reach)
        };
        let reach = (from, reach.map(Length::to_m));
        let edge = around.upper_edge(given, top);
        let cloth = edge.or_else(|| around.girth(top - BELOW_EDGE));
        Self::from_band(fitting, (top, cloth.unwrap_or(0.0), chosen), reach)
    }

    /// A level of the file's body as a height on her [m].
    #[must_use]
    pub fn height(&self, level: f64) -> f64 {
        self.top[1] - (self.top[0] - level) * self.ratio
    }

    fn from_shoulders(
        around: &Around,
        fitting: &Fitting<'_>,
        (top, sides, chosen): (f64, f64, Option<f64>),
    ) -> Self {
        let measures = fitting.measures;
        let mut size = Self {
            ratio: chosen.unwrap_or(1.0),
            hang: Hang::Shoulders,
            top: [top, measures.neck_height.to_m() + OVER_SHOULDER],
            notes: Vec::new(),
        };
        let lowest = measures.hip_height.to_m();
        let armpit = measures.armpit_height.to_m() - BELOW_ARMPIT;
        // A larger garment hangs deeper, where she may be wider.
        for _ in 0..3 {
            let mut tightest: Option<[f64; 3]> = None;
            let mut height = lowest;
            // Above its sides cloth does not close around her.
            let highest = armpit.min(size.height(sides) - BELOW_SIDES);
            while height < highest {
                let level = top - (size.top[1] - height) / size.ratio;
                let cloth = around.girth(level);
                let body = fitting.girth_at(narrow(height));
                if let (Some(cloth), Some(body)) = (cloth, body) {
                    let ratio = LEAST_EASE * body.to_m() / cloth;
                    let before = tightest.filter(|before| ratio <= before[0]);
                    tightest = before.or(Some([ratio, cloth, body.to_m()]));
                }
                height += STEP;
            }
            let Some([ratio, cloth, body]) = tightest else {
                break;
            };
            size.notes.clear();
            match chosen {
                Some(chosen) if chosen * LEAST_EASE < ratio => {
                    size.notes.push(too_tight(chosen * cloth, body));
                }
                None if 1.0 < ratio => {
                    size.ratio = size.ratio.max(ratio);
                    size.notes.push(enlarged([cloth, body], size.ratio));
                }
                _ => {}
            }
        }
        size
    }

    fn from_band(
        fitting: &Fitting<'_>,
        (top, cloth, chosen): (f64, f64, Option<f64>),
        (from, [highest, lowest]): (Words, [f64; 2]),
    ) -> Self {
        let worn = cloth * chosen.unwrap_or(1.0);
        let at = |height: f64| {
            let girth = fitting.girth_at(narrow(height));
            girth.map_or(0.0, |girth| BAND * girth.to_m())
        };
        let band = |height: f64, ratio: f64, notes| Self {
            ratio,
            hang: Hang::Band,
            top: [top, height],
            notes,
        };
        if cloth <= 0.0 {
            return band(highest, chosen.unwrap_or(1.0), Vec::new());
        }
        let steps = (0_u32..).map(|step| highest - f64::from(step) * 0.5 * STEP);
        let heights: Vec<f64> = steps.take_while(|height| lowest <= *height).collect();
        let narrowest = heights
            .iter()
            .copied()
            .min_by(|a, b| at(*a).total_cmp(&at(*b)));
        let widest = heights
            .iter()
            .copied()
            .max_by(|a, b| at(*a).total_cmp(&at(*b)));
        let (Some(narrowest), Some(widest)) = (narrowest, widest) else {
            return band(highest, chosen.unwrap_or(1.0), Vec::new());
        };
        if let Some(chosen) = chosen {
            let fits = heights.iter().find(|height| worn <= at(**height));
            let notes = if worn * 1.01 < at(narrowest) {
                vec![too_tight(worn, at(narrowest) / BAND)]
            } else {
                Vec::new()
            };
            return band(*fits.unwrap_or(&widest), chosen, notes);
        }
        if worn < at(narrowest) {
            let ratio = at(narrowest) / cloth;
            let note = enlarged([cloth, at(narrowest) / BAND], ratio);
            return band(narrowest, ratio, vec![note]);
        }
        match heights.iter().find(|height| worn <= at(**height)) {
            // Where a band lies between two heights it is drawn in by less than a tape is read to.
            Some(height) => {
                let note = slid(cloth, highest - *height, from);
                band(*height, at(*height) / cloth, note.into_iter().collect())
            }
            None => {
                let ratio = at(widest) / cloth;
                band(
                    widest,
                    ratio,
                    vec![reduced([cloth, at(widest) / BAND], ratio)],
                )
            }
        }
    }
}

fn enlarged(girths: [f64; 2], ratio: f64) -> Sentence {
    let [cloth, body] = girths.map(|girth| 100.0 * girth);
    Sentence::new(
        format!(
            "型紙は {cloth:.1} cm で、体の {body:.1} cm を回りません。全体を {ratio:.3} 倍にします"
        ),
        format!(
            "the pattern goes around {cloth:.1} cm, and she has {body:.1} cm there; all of it is sewn {ratio:.3} times as large"
        ),
    )
}

fn reduced(girths: [f64; 2], ratio: f64) -> Sentence {
    let [cloth, body] = girths.map(|girth| 100.0 * girth);
    Sentence::new(
        format!(
            "型紙の上端は {cloth:.1} cm で、腰の {body:.1} cm でも落ちます。全体を {ratio:.3} 倍にします"
        ),
        format!(
            "the upper edge is {cloth:.1} cm and would slide over her hips of {body:.1} cm; all of it is sewn {ratio:.3} times as large"
        ),
    )
}

fn too_tight(cloth: f64, body: f64) -> Sentence {
    let [cloth, body] = [cloth, body].map(|girth| 100.0 * girth);
    Sentence::new(
        format!("型紙は {cloth:.1} cm で、体の {body:.1} cm にはきつく、布が伸びます"),
        format!(
            "the pattern goes around {cloth:.1} cm and is tight on her {body:.1} cm: the cloth will stretch"
        ),
    )
}

/// A band that is worn so far below a place because it is too long for that [m].
fn slid(cloth: f64, below: f64, from: Words) -> Option<Sentence> {
    let [cloth, below] = [cloth, below].map(|length| 100.0 * length);
    (1.0 < below).then(|| {
        Sentence::new(
            format!(
                "上端の {cloth:.1} cm が体に合うのは、{}より {below:.0} cm 下です。そこで着ます",
                from.japanese
            ),
            format!(
                "its upper edge of {cloth:.1} cm fits her {below:.0} cm below the {} and is worn there",
                from.english
            ),
        )
    })
}
