//! Ruler and scale: from the weight of a swatch and the overhang of a strip to the figures that decide
//! how a cloth hangs.
//!
//! A strip that is pushed over an edge until its tip has come down by a known slope or drop bends by
//! `B θ'' = -ρ g (L - s) cos θ`, with `θ = 0` at the edge and `θ' = 0` at the tip (the heavy
//! elastica; Bickley 1934, Phil. Mag. 17:603). In lengths of `c = (B / ρ g)^⅓`, the bending
//! length of Peirce (1930, J. Text. Inst. 21:T377), it has no parameter but `L / c`, and is
//! solved here to six digits. At a slope of 41.5° `L / c` is 2, which is why laboratories use it (ASTM
//! D1388); at the 45° of JIS L 1096 A it is 2.08. A table's edge and a ruler do as well: whatever the drop
//! is, it gives `L / c`.

use lole_geom::trig64;
use lole_language::Bilingual;

use super::Preset;
use crate::document::FabricDesign;

/// Standard gravity [m/s²].
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// A piece of cloth that was cut, measured and weighed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swatch {
    /// Length along the warp [cm].
    pub length_cm: f64,
    /// Width along the weft [cm].
    pub width_cm: f64,
    /// Mass [g].
    pub mass_g: f64,
}

/// A strip that hangs over a straight edge, the rest of it held flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Overhang {
    /// Its tip touches a plane that falls from the edge at this slope.
    Slope {
        /// Length of cloth beyond the edge [cm].
        length_cm: f64,
        /// Slope of the plane below the horizontal [°].
        slope_deg: f64,
    },
    /// Its tip lies so far below the edge.
    Drop {
        /// Length of cloth beyond the edge [cm].
        length_cm: f64,
        /// How far the tip is below the edge [cm].
        drop_cm: f64,
    },
}

/// What was measured, in the document's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Mass per area [g/m²].
    pub areal_density: f64,
    /// Bending length along warp and weft [cm].
    pub bending_length: [f64; 2],
    /// Bending rigidity along warp and weft [µN·m].
    pub bend: [f64; 2],
    /// Relative uncertainty of the mass per area with a ruler of 1 mm and a scale of 1 g.
    pub density_error: f64,
    /// Relative uncertainty of the rigidities, which goes with the cube of the overhang.
    pub bend_error: f64,
}

/// Half a division of a kitchen scale [g], and of a ruler [cm].
const SCALE_ERROR: f64 = 0.5;
const RULER_ERROR: f64 = 0.05;

/// Why a measurement cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasureError {
    /// A number that no cloth has.
    #[error("{what_en} {found} is out of range; give {min} to {max}")]
    OutOfRange {
        /// Which number, in Japanese.
        what_ja: &'static str,
        /// Which number, in English.
        what_en: &'static str,
        /// The number.
        found: f64,
        /// Smallest accepted.
        min: f64,
        /// Largest accepted.
        max: f64,
    },
    /// The strip is too short or too long for its stiffness to be read.
    #[error(
        "the tip is {drop_cm} cm below the edge with {length_cm} cm over it; push the strip until it \
         drops by a tenth to nine tenths of its overhang"
    )]
    Drop {
        /// Overhang [cm].
        length_cm: f64,
        /// Drop [cm].
        drop_cm: f64,
    },
}

impl Bilingual for MeasureError {
    fn japanese(&self) -> String {
        match self {
            Self::OutOfRange {
                what_ja,
                found,
                min,
                max,
                ..
            } => format!("{what_ja} {found} は範囲の外です。{min} から {max} までにしてください"),
            Self::Drop { length_cm, drop_cm } => format!(
                "{length_cm} cm はみ出した先が {drop_cm} cm 下がっています。\
                 はみ出した長さの 1 割から 9 割だけ下がるように、布を出し入れしてください"
            ),
        }
    }
}

impl Swatch {
    /// The figures of a cloth whose strips along warp and weft hang so; a cloth with one strip is taken to
    /// be alike both ways.
    ///
    /// # Errors
    /// Numbers that no cloth has.
    pub fn measure(
        &self,
        warp: Overhang,
        weft: Option<Overhang>,
    ) -> Result<Measured, MeasureError> {
        let side = |what_ja, what_en, found| in_range(what_ja, what_en, found, [2.0, 1000.0]);
        side(
            "布の長さ（cm）",
            "the swatch's length in cm",
            self.length_cm,
        )?;
        side("布の幅（cm）", "the swatch's width in cm", self.width_cm)?;
        in_range(
            "布の重さ（g）",
            "the swatch's mass in g",
            self.mass_g,
            [0.05, 20_000.0],
        )?;
        let areal_density = self.mass_g / (self.length_cm * self.width_cm * 1e-4);
        in_range(
            "1 平方メートルの重さ（g）",
            "the cloth's mass per square meter in g",
            areal_density,
            [10.0, 1000.0],
        )?;
        let warp_length = warp.bending_length_cm()?;
        let weft = weft.unwrap_or(warp);
        let bending_length = [warp_length, weft.bending_length_cm()?];
        let bend = bending_length.map(|cm| {
            let meters = cm * 1e-2;
            areal_density * 1e-3 * STANDARD_GRAVITY * meters * meters * meters * 1e6
        });
        let density_error =
            SCALE_ERROR / self.mass_g + RULER_ERROR / self.length_cm + RULER_ERROR / self.width_cm;
        let shortest = warp.length_cm().min(weft.length_cm());
        Ok(Measured {
            areal_density,
            bending_length,
            bend,
            density_error,
            bend_error: density_error + 3.0 * RULER_ERROR / shortest,
        })
    }
}

impl Measured {
    /// The measured cloth, with the rest of its figures from the fabric of the shelf that hangs most
    /// like it.
    #[must_use]
    pub fn fabric(&self) -> FabricDesign {
        FabricDesign {
            preset: Preset::nearest(self.areal_density, self.bend),
            areal_density_g_per_m2: Some(self.areal_density),
            bend_warp_un_m: Some(self.bend[0]),
            bend_weft_un_m: Some(self.bend[1]),
            ..FabricDesign::default()
        }
    }
}

impl Overhang {
    /// Length of cloth beyond the edge [cm].
    #[must_use]
    pub const fn length_cm(&self) -> f64 {
        match self {
            Self::Slope { length_cm, .. } | Self::Drop { length_cm, .. } => *length_cm,
        }
    }

    /// Bending length `c` [cm].
    ///
    /// # Errors
    /// Numbers that no strip has.
    pub fn bending_length_cm(&self) -> Result<f64, MeasureError> {
        in_range(
            "はみ出した長さ（cm）",
            "the overhang in cm",
            self.length_cm(),
            [0.5, 60.0],
        )?;
        match *self {
            Self::Slope {
                length_cm,
                slope_deg,
            } => {
                in_range(
                    "斜面の角度（°）",
                    "the slope in degrees",
                    slope_deg,
                    [10.0, 75.0],
                )?;
                let slope = trig64::tan(slope_deg.to_radians());
                Ok(length_cm / overhang_where(|tip| tip.drop - slope * tip.reach))
            }
            Self::Drop { length_cm, drop_cm } => {
                let share = drop_cm / length_cm;
                if !(0.1..=0.9).contains(&share) {
                    return Err(MeasureError::Drop { length_cm, drop_cm });
                }
                Ok(length_cm / overhang_where(|tip| tip.drop - share * tip.overhang))
            }
        }
    }
}

/// Horizontal reach of a strip over its length, which is `overhang` bending lengths: 1 where it stands
/// straight out, towards 0 where it hangs.
pub(super) fn reach_of_overhang(overhang: f64) -> f64 {
    // A stiff strip bends as a beam does: its tip comes back by `Γ² / 112`-ths of its length or less.
    if overhang < 0.2 {
        return 1.0;
    }
    let (mut low, mut high) = TIP_ANGLES;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if tip(middle).overhang < overhang {
            low = middle;
        } else {
            high = middle;
        }
    }
    let found = tip(low);
    // A limper strip hangs straight down but for the first few bending lengths.
    found.reach / found.overhang.max(overhang)
}

/// A strip's tip, in bending lengths.
#[derive(Debug, Clone, Copy)]
struct Tip {
    /// Length of the strip.
    overhang: f64,
    /// How far it reaches out.
    reach: f64,
    /// How far it hangs down.
    drop: f64,
}

/// Angles of the tip below the horizontal that are looked at [rad]: an overhang of 0.1 to about 6
/// bending lengths.
const TIP_ANGLES: (f64, f64) = (1.5e-4, std::f64::consts::FRAC_PI_2 - 1e-6);
/// Halvings of that interval: its width falls below 1e-12.
const HALVINGS: usize = 41;
/// Step of the integration in bending lengths; its error is below 1e-9.
const STEP: f64 = 0.01;

/// The strip whose tip slopes at `angle` [rad], followed from the tip to where it is level.
///
/// With `t` the length from the tip, `θ'' = -t cos θ` and `θ'(0) = 0`.
fn tip(angle: f64) -> Tip {
    let slope_rate = |t: f64, angle: f64| -t * trig64::cos(angle);
    let (mut t, mut theta, mut bend) = (0.0, angle, 0.0);
    let (mut reach, mut drop) = (0.0, 0.0);
    loop {
        // Runge and Kutta's classical step for angle and curvature.
        let k1 = (bend, slope_rate(t, theta));
        let half = 0.5 * STEP;
        let k2 = (
            bend + half * k1.1,
            slope_rate(t + half, theta + half * k1.0),
        );
        let k3 = (
            bend + half * k2.1,
            slope_rate(t + half, theta + half * k2.0),
        );
        let k4 = (
            bend + STEP * k3.1,
            slope_rate(t + STEP, theta + STEP * k3.0),
        );
        let next = theta + STEP / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
        let next_bend = bend + STEP / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
        // Simpson's rule, the middle by the cubic through both ends.
        let middle = 0.5 * (theta + next) + 0.125 * STEP * (bend - next_bend);
        let ((sin, cos), (sin_middle, cos_middle)) =
            (trig64::sin_cos(theta), trig64::sin_cos(middle));
        let (sin_next, cos_next) = trig64::sin_cos(next);
        if next <= 0.0 {
            // The rest of the way to the edge, where the curve is all but a circle.
            let share = theta / (theta - next);
            let rest = share * STEP;
            let last = trig64::sin_cos(0.5 * theta);
            return Tip {
                overhang: t + rest,
                reach: reach + rest * last.1,
                drop: drop + rest * last.0,
            };
        }
        reach += STEP / 6.0 * (cos + 4.0 * cos_middle + cos_next);
        drop += STEP / 6.0 * (sin + 4.0 * sin_middle + sin_next);
        (t, theta, bend) = (t + STEP, next, next_bend);
    }
}

/// Overhang in bending lengths where `excess`, which rises with the tip's angle, passes zero.
fn overhang_where(excess: impl Fn(&Tip) -> f64) -> f64 {
    let (mut low, mut high) = TIP_ANGLES;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if excess(&tip(middle)) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    tip(0.5 * (low + high)).overhang
}

fn in_range(
    what_ja: &'static str,
    what_en: &'static str,
    found: f64,
    [min, max]: [f64; 2],
) -> Result<(), MeasureError> {
    if (min..=max).contains(&found) {
        return Ok(());
    }
    Err(MeasureError::OutOfRange {
        what_ja,
        what_en,
        found,
        min,
        max,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swatch() -> Swatch {
        Swatch {
            length_cm: 50.0,
            width_cm: 40.0,
            mass_g: 22.0,
        }
    }

    #[test]
    fn strips_hang_as_the_heavy_elastica_tables_say() {
        // `Γ = (L / c)³`, reach and drop over the length, from a table of the clamped heavy elastica that
        // was computed with another method.
        for (gamma, reach, drop) in [
            (1.0, 0.991_246_4, 0.123_471_4),
            (3.0, 0.931_511_2, 0.339_648_4),
            (8.0, 0.724_424_7, 0.640_630_7),
            (30.0, 0.342_763_7, 0.873_092_4),
            (100.0, 0.159_223_4, 0.937_523_9),
        ] {
            let overhang = trig64::powf(gamma, 1.0 / 3.0);
            assert!(
                (reach_of_overhang(overhang) - reach).abs() < 1e-4,
                "Γ = {gamma}"
            );
            let found = Overhang::Drop {
                length_cm: 10.0,
                drop_cm: 10.0 * drop,
            };
            if drop <= 0.9 {
                let found = 10.0 / found.bending_length_cm().unwrap();
                assert!(
                    (found / overhang - 1.0).abs() < 2e-4,
                    "Γ = {gamma}: {found}"
                );
            }
        }
    }

    #[test]
    fn at_the_laboratory_slope_the_bending_length_is_half_the_overhang() {
        let length = |slope_deg| {
            let overhang = Overhang::Slope {
                length_cm: 4.0,
                slope_deg,
            };
            overhang.bending_length_cm().unwrap()
        };
        assert!((length(41.5) - 2.0).abs() < 0.002, "{}", length(41.5));
        // Peirce's own formula: `c = L (cos(θ/2) / (8 tan θ))^⅓`, good to a few percent up to there.
        for slope in [20.0_f64, 30.0, 41.5, 45.0] {
            let radians = slope.to_radians();
            let ratio = trig64::cos(0.5 * radians) / (8.0 * trig64::tan(radians));
            let peirce = 4.0 * trig64::powf(ratio, 1.0 / 3.0);
            assert!((length(slope) / peirce - 1.0).abs() < 0.04, "{slope}");
        }
        assert!(length(45.0) < length(41.5));
    }

    #[test]
    fn a_swatch_of_broadcloth_gives_the_figures_of_the_shelf() {
        let strip = |length_cm| Overhang::Slope {
            length_cm,
            slope_deg: 41.5,
        };
        let found = swatch().measure(strip(4.0), Some(strip(3.6))).unwrap();
        assert!((found.areal_density - 110.0).abs() < 1e-9);
        for (bend, expected) in found.bend.into_iter().zip([8.6, 6.3]) {
            assert!((bend - expected).abs() < 0.05, "{bend} for {expected}");
        }
        // Half a gram of 22 alone is 2 %; half a millimeter of 36 goes in with its cube.
        assert!((0.02..0.03).contains(&found.density_error));
        assert!((0.06..0.08).contains(&found.bend_error));
    }

    #[test]
    fn any_drop_of_one_cloth_gives_the_same_bending_length() {
        for overhang in [1.2, 1.7, 2.4, 3.0] {
            let reach = reach_of_overhang(overhang);
            assert!((0.3..1.0).contains(&reach));
            let (mut low, mut high) = TIP_ANGLES;
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if tip(middle).overhang < overhang {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let strip = Overhang::Drop {
                length_cm: 1.9 * overhang,
                drop_cm: 1.9 * tip(low).drop,
            };
            let found = strip.bending_length_cm().unwrap();
            assert!((found - 1.9).abs() < 1e-3, "{overhang}: {found}");
        }
    }

    #[test]
    fn numbers_that_no_cloth_has_are_refused_by_name() {
        let strip = Overhang::Drop {
            length_cm: 10.0,
            drop_cm: 5.0,
        };
        let heavy = Swatch {
            mass_g: 2000.0,
            ..swatch()
        };
        let error = heavy.measure(strip, None).unwrap_err();
        assert!(
            error.to_string().contains("mass per square meter"),
            "{error}"
        );
        let straight = Overhang::Drop {
            length_cm: 10.0,
            drop_cm: 0.2,
        };
        let error = swatch().measure(straight, None).unwrap_err();
        assert!(error.to_string().contains("nine tenths"), "{error}");
        assert!(error.japanese().contains("割"));
        let nothing = Swatch {
            length_cm: f64::NAN,
            ..swatch()
        };
        nothing.measure(strip, None).unwrap_err();
    }
}
