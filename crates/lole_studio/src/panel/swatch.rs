//! One's own cloth by ruler and scale: the form of the test, and the fabric that comes of it.

use eframe::egui::{DragValue, Grid, RichText, TextEdit, Ui};
use lole_costume::document::FabricDesign;
use lole_costume::fabrics::{Measured, Overhang, Swatch, Touch};
use lole_language::Sentence;

use super::garment::kept;
use super::hindrance;
use super::knob::wide_button;
use crate::{Studio, look, text};

/// What is written on the form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SwatchForm {
    /// What its owner calls the cloth.
    pub(crate) name: String,
    /// Length along the selvage and width [cm].
    pub(crate) size_cm: [f64; 2],
    /// What it weighs [g].
    pub(crate) mass_g: f64,
    /// Cloth over the edge, and how far its tip is below, along the selvage [cm].
    pub(crate) warp_cm: [f64; 2],
    /// Cloth over the edge, and how far its tip is below, across [cm]; `None` where that was not tried.
    pub(crate) weft_cm: Option<[f64; 2]>,
}

impl Default for SwatchForm {
    /// The example of the instructions.
    fn default() -> Self {
        Self {
            name: String::new(),
            size_cm: [50.0, 40.0],
            mass_g: 22.0,
            warp_cm: [3.5, 1.9],
            weft_cm: None,
        }
    }
}

impl SwatchForm {
    /// What was measured.
    ///
    /// # Errors
    /// Numbers that no cloth has, in a sentence.
    pub(crate) fn measured(&self) -> Result<Measured, Sentence> {
        let swatch = Swatch {
            length_cm: self.size_cm[0],
            width_cm: self.size_cm[1],
            mass_g: self.mass_g,
        };
        let strip = |[length_cm, drop_cm]: [f64; 2]| Overhang::Drop { length_cm, drop_cm };
        let measured = swatch.measure(strip(self.warp_cm), self.weft_cm.map(strip));
        measured.map_err(|error| Sentence::of(&error))
    }

    /// The cloth as the design keeps it; width and prices stay those of `before`.
    pub(crate) fn fabric(&self, measured: &Measured, before: &FabricDesign) -> FabricDesign {
        let own = measured.fabric();
        let rounded = |value: Option<f64>| value.map(|value| (value * 100.0).round() / 100.0);
        let name = self.name.trim();
        FabricDesign {
            name: (!name.is_empty()).then(|| name.to_owned()),
            preset: own.preset,
            areal_density_g_per_m2: rounded(own.areal_density_g_per_m2),
            bend_warp_un_m: rounded(own.bend_warp_un_m),
            bend_weft_un_m: rounded(own.bend_weft_un_m),
            ..kept(before)
        }
    }
}

/// Shows the form; the fabric, when it is taken.
pub(super) fn show(
    ui: &mut Ui,
    studio: &mut Studio,
    before: &FabricDesign,
) -> Option<FabricDesign> {
    let mut form = studio.swatch.clone();
    ui.label(RichText::new(studio.say(text::SWATCH_HOW)).small().weak());
    ui.horizontal(|ui| {
        let label = ui.label(studio.say(text::SWATCH_NAME));
        let field = TextEdit::singleline(&mut form.name).desired_width(f32::INFINITY);
        look::typing(ui);
        ui.add(field).labelled_by(label.id);
    });
    Grid::new("swatch").num_columns(2).show(ui, |ui| {
        number(
            ui,
            studio.say(text::SWATCH_LENGTH),
            &mut form.size_cm[0],
            " cm",
        );
        number(
            ui,
            studio.say(text::SWATCH_WIDTH),
            &mut form.size_cm[1],
            " cm",
        );
        number(ui, studio.say(text::SWATCH_MASS), &mut form.mass_g, " g");
        number(ui, studio.say(text::OVERHANG), &mut form.warp_cm[0], " cm");
        number(ui, studio.say(text::DROP), &mut form.warp_cm[1], " cm");
    });
    let mut has_weft = form.weft_cm.is_some();
    if ui
        .checkbox(&mut has_weft, studio.say(text::ALSO_ACROSS))
        .changed()
    {
        form.weft_cm = has_weft.then_some(form.warp_cm);
    }
    if let Some(weft) = &mut form.weft_cm {
        Grid::new("weft").num_columns(2).show(ui, |ui| {
            number(ui, studio.say(text::OVERHANG_ACROSS), &mut weft[0], " cm");
            number(ui, studio.say(text::DROP_ACROSS), &mut weft[1], " cm");
        });
    }
    let measured = form.measured();
    let chosen = match &measured {
        Ok(measured) => {
            result(ui, studio, measured);
            wide_button(ui, studio.say(text::TAKE_FABRIC)).then(|| form.fabric(measured, before))
        }
        Err(sentence) => {
            hindrance::sentence(ui, studio, sentence);
            None
        }
    };
    studio.swatch = form;
    chosen
}

/// A number that was measured, with its name before it.
fn number(ui: &mut Ui, name: &str, value: &mut f64, unit: &str) {
    let label = ui.label(name);
    let field = DragValue::new(value)
        .range(0.0..=10_000.0)
        .speed(0.1)
        .max_decimals(1)
        .suffix(unit)
        .update_while_editing(false);
    ui.add(field).labelled_by(label.id);
    ui.end_row();
}

/// What such a cloth is like.
fn result(ui: &mut Ui, studio: &Studio, measured: &Measured) {
    let touch = Touch::of(&measured.fabric().figures());
    let words: Vec<&str> = touch.words.iter().map(|word| studio.say(*word)).collect();
    let (density, [warp, weft]) = (measured.areal_density, measured.bend);
    let error = 100.0 * measured.bend_error;
    let preset = measured.fabric().preset;
    let sentence = Sentence::new(
        format!(
            "{density:.0} g/m²、曲げにくさ たて {warp:.1}・よこ {weft:.1} µN·m（±{error:.0} %）。{}。棚の布では「{}」に近い。",
            words.join("・"),
            preset.name_ja
        ),
        format!(
            "{density:.0} g/m², bending rigidity {warp:.1} along and {weft:.1} µN·m across (±{error:.0} %): {}. Nearest on the shelf: {}.",
            words.join(", "),
            preset.name
        ),
    );
    ui.label(RichText::new(studio.tell(&sentence)).small());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip that drops as far under twice the weight is twice as stiff.
    #[test]
    fn twice_as_heavy_with_the_same_drop_is_twice_as_stiff() {
        let light = SwatchForm::default();
        let heavy = SwatchForm {
            mass_g: 2.0 * light.mass_g,
            ..light.clone()
        };
        let [light, heavy] = [light, heavy].map(|form| form.measured().unwrap());
        assert!((light.areal_density - 110.0).abs() < 1e-9);
        assert!((heavy.bend[0] / light.bend[0] - 2.0).abs() < 1e-9);
    }

    #[test]
    fn the_own_cloth_keeps_width_and_price_and_is_a_design_s_fabric() {
        let form = SwatchForm {
            name: " 赤いコットン ".to_owned(),
            ..SwatchForm::default()
        };
        let before = FabricDesign {
            width_cm: 148.0,
            price_per_m: Some(1200.0),
            ..FabricDesign::default()
        };
        let own = form.fabric(&form.measured().unwrap(), &before);
        assert_eq!(own.name.as_deref(), Some("赤いコットン"));
        assert_eq!((own.width_cm, own.price_per_m), (148.0, Some(1200.0)));
        let design = lole_costume::document::Design {
            fabric: own,
            ..Default::default()
        };
        assert!(design.check("").is_ok());
        let impossible = SwatchForm {
            warp_cm: [3.5, 3.49],
            ..form
        };
        assert!(impossible.measured().unwrap_err().english.contains("drops"));
    }
}
