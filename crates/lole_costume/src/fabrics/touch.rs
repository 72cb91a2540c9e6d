//! How a cloth feels, in words that follow from its figures: nobody types "soft" beside a preset.
//!
//! The words are those of makers and of Kawabata's standard of hand evaluation (1980): *hari*,
//! resistance to draping; *koshi*, springiness in bending; *shinayakasa*, soft give; *fukurami*,
//! fullness. The limits between words are this program's estimates, set so that the measured fabrics of
//! the shelf are called what a shop calls them; those of weight are the trade's 4 and 7 oz/yd².

use lole_language::{Words, words};

use super::FabricFigures;
use super::measure::{STANDARD_GRAVITY, reach_of_overhang};

/// How a cloth feels.
#[derive(Debug, Clone, PartialEq)]
pub struct Touch {
    /// Length that bends under its own weight as far as any other cloth's does, `(B / ρ g)^⅓`, of the
    /// mean rigidity [cm]. It alone decides how a cloth hangs.
    pub bending_length: f64,
    /// Share of a ring of cloth, 6 cm wide around a disc of 18 cm, that a lamp from above shows, 0 limp
    /// to 1 flat: Cusick's drape coefficient if every radius hung as a strip of its own. A
    /// drapemeter shows more, because a disc bends two ways.
    pub drape: f64,
    /// The words, the most telling first.
    pub words: Vec<Words>,
}

/// Radii of Cusick's disc and cloth [cm].
const DRAPE_RADII: [f64; 2] = [9.0, 15.0];

/// A word for figures below a limit; the last of a scale has none.
type Scale = &'static [(f64, Words)];

/// By bending length [cm].
const HANG: Scale = &[
    (
        1.35,
        words(
            "しなやか（とろみがあり、よく落ちる）",
            "fluid: drapes softly and closely",
        ),
    ),
    (1.8, words("やわらかい", "soft")),
    (2.6, words("ほどよいハリ", "some body")),
    (3.8, words("ハリがある", "crisp: stands away")),
    (
        f64::INFINITY,
        words("かたい（折り紙のよう）", "stiff, like paper"),
    ),
];

/// By mass per area [g/m²]: 2, 4 and 7 oz/yd².
const WEIGHT: Scale = &[
    (68.0, words("とても軽い", "very light")),
    (136.0, words("軽い", "light")),
    (237.0, words("中くらいの重さ", "medium weight")),
    (f64::INFINITY, words("重い", "heavy")),
];

/// By mean bending rigidity [µN·m]: what fingers feel in a fold, whatever the weight.
const SPRING: Scale = &[
    (3.0, words("コシがない", "no spring")),
    (20.0, words("ほどよいコシ", "some spring")),
    (f64::INFINITY, words("コシが強い", "springy")),
];

/// By thickness over mass per area [cm³/g].
const FULLNESS: Scale = &[
    (2.9, words("", "")),
    (f64::INFINITY, words("ふっくら", "full, lofty")),
];

/// By mean membrane stiffness [N/m].
const STRETCH: Scale = &[
    (150.0, words("よく伸びる", "stretchy")),
    (f64::INFINITY, words("", "")),
];

/// By shear stiffness [N/m per rad]: how cloth follows a curve.
const GIVE: Scale = &[
    (26.0, words("斜めになじむ", "gives on the bias")),
    (80.0, words("", "")),
    (f64::INFINITY, words("斜めに動きにくい", "firm on the bias")),
];

impl Touch {
    /// How a cloth with these figures feels.
    #[must_use]
    pub fn of(figures: &FabricFigures) -> Self {
        let mean = |[warp, weft]: [f64; 2]| (warp * weft).sqrt();
        let bend = mean(figures.bend);
        let bending_length = bending_length_cm(bend, figures.areal_density);
        let fullness = 1000.0 * figures.thickness / figures.areal_density;
        let found = [
            word(HANG, bending_length),
            word(WEIGHT, figures.areal_density),
            word(SPRING, bend),
            word(FULLNESS, fullness),
            word(STRETCH, mean(figures.stretch)),
            word(GIVE, figures.shear),
        ];
        let [disc, cloth] = DRAPE_RADII;
        let reach = disc + (cloth - disc) * reach_of_overhang((cloth - disc) / bending_length);
        Self {
            bending_length,
            drape: (reach * reach - disc * disc) / (cloth * cloth - disc * disc),
            words: found.into_iter().flatten().collect(),
        }
    }
}

/// `(B / ρ g)^⅓` [cm] of a rigidity [µN·m] and a mass per area [g/m²].
#[must_use]
pub fn bending_length_cm(bend: f64, areal_density: f64) -> f64 {
    let cubed = (bend * 1e-6) / (areal_density * 1e-3 * STANDARD_GRAVITY);
    100.0 * lole_geom::trig64::powf(cubed, 1.0 / 3.0)
}

fn word(scale: Scale, figure: f64) -> Option<Words> {
    let found = scale.iter().find(|(limit, _)| figure < *limit);
    found
        .map(|(_, word)| *word)
        .filter(|word| !word.english.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabrics::{PRESETS, Preset};

    fn touch(id: &str) -> Touch {
        Preset::from_id(id).unwrap().touch()
    }

    #[test]
    fn the_shelf_is_called_what_shops_call_it() {
        for (id, expected) in [
            ("rayon-challis", "fluid: drapes softly and closely"),
            ("polyester-satin", "gives on the bias"),
            ("chiffon", "very light"),
            ("cotton-lawn", "soft"),
            ("polycotton-broadcloth", "some body"),
            ("polycotton-broadcloth", "firm on the bias"),
            ("barkcloth", "stiff, like paper"),
            ("woven-velvet", "full, lofty"),
            ("jersey", "stretchy"),
            ("spandex", "stretchy"),
        ] {
            let words = touch(id).words;
            let found = words.iter().any(|word| word.english == expected);
            assert!(found, "{id}: {words:?}");
        }
    }

    #[test]
    fn drape_falls_as_cloth_becomes_softer_and_stays_a_share() {
        let order = [
            "chiffon",
            "rayon-challis",
            "polycotton-broadcloth",
            "barkcloth",
            "kapa",
        ];
        let drapes = order.map(|id| touch(id).drape);
        assert!(drapes.is_sorted(), "{drapes:?}");
        for preset in PRESETS {
            let touch = preset.touch();
            assert!((0.0..=1.0).contains(&touch.drape), "{}", preset.id);
            assert!(3 <= touch.words.len(), "{}: {touch:?}", preset.id);
            let both = touch.words.iter().all(|word| !word.japanese.is_empty());
            assert!(both, "{}", preset.id);
        }
    }

    #[test]
    fn a_scale_has_a_word_for_every_figure_and_rises() {
        for scale in [HANG, WEIGHT, SPRING, FULLNESS, STRETCH, GIVE] {
            assert!(scale.windows(2).all(|pair| pair[0].0 < pair[1].0));
            assert_eq!(scale.last().map(|(limit, _)| *limit), Some(f64::INFINITY));
        }
    }
}
