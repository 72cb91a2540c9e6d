//! Moving air: still, a breeze, strong or as one likes, and how it blows.

use eframe::egui::Ui;
use lole_cloth::wind::WindLaw;
use lole_costume::document::{WindDesign, WindModel};

use super::knob::{Knob, Scale, choice, wide_button};
use crate::studio::range;
use crate::{Studio, text};

/// The wind slider ends here [m/s]: a strong breeze.
const MOST_WIND: f64 = 8.0;
/// A breeze on which leaves rustle, Beaufort 2 [m/s].
const BREEZE: f64 = 2.0;
/// A wind that moves small trees, Beaufort 4 [m/s].
const STRONG: f64 = 6.0;
/// Gusts over the mean speed near the ground in the open, as a root mean square; estimated from
/// the intensity of turbulence that builders reckon with.
const USUAL_GUSTS: f64 = 0.2;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    strength(ui, studio);
    if studio.design().wind.speed_m_per_s <= 0.0 {
        return;
    }
    ui.label(studio.say(text::WIND_ACTS_ON));
    let models = [
        (WindModel::Triangles, studio.say(text::WIND_ON_FACES)),
        (WindModel::Uniform, studio.say(text::WIND_ON_ALL)),
    ];
    let wind = studio.design().wind.clone();
    if let Some(model) = choice(ui, Some(wind.model), &models) {
        studio.change(|design| design.wind.model = model);
    }
    ui.label(studio.say(text::WIND_DIRECTION));
    let laws = [
        (WindLaw::Steady, studio.say(text::WIND_IS_STEADY)),
        (WindLaw::Spherical, studio.say(text::WIND_TURNS)),
        (WindLaw::LiteralScalar, studio.say(text::WIND_TO_AND_FRO)),
    ];
    if let Some(law) = choice(ui, Some(wind.law), &laws) {
        studio.change(|design| design.wind.law = law);
    }
    if wind.law == WindLaw::Steady {
        origin(ui, studio, &wind);
    }
    if wind.model == WindModel::Triangles {
        gusts(ui, studio, &wind);
    }
}

fn strength(ui: &mut Ui, studio: &mut Studio) {
    let speed = studio.design().wind.speed_m_per_s;
    let ready = [
        (0.0, studio.say(text::STILL_AIR)),
        (BREEZE, studio.say(text::BREEZE)),
        (STRONG, studio.say(text::STRONG_WIND)),
    ];
    if let Some(speed) = choice(ui, Some(speed), &ready) {
        studio.change(|design| {
            let wind = &mut design.wind;
            if wind.speed_m_per_s == 0.0 && *wind == WindDesign::default() {
                wind.model = WindModel::Triangles;
                wind.law = WindLaw::Steady;
                wind.gust_ratio = USUAL_GUSTS;
            }
            wind.speed_m_per_s = speed;
        });
    }
    let (low, high) = range("wind", "speed_m_per_s");
    let knob = Knob {
        name: studio.say(text::WIND_SPEED),
        range: low..=high.min(MOST_WIND),
        decimals: 1,
        unit: " m/s",
        scale: Scale::Even,
    };
    if let (_, Some(speed)) = knob.show(ui, speed) {
        studio.change(|design| design.wind.speed_m_per_s = speed);
    }
}

/// Where a steady wind comes from, as one sees it who looks at the dancer from the front.
fn origin(ui: &mut Ui, studio: &mut Studio, wind: &WindDesign) {
    ui.label(studio.say(text::WIND_COMES_FROM));
    // Her right side is on the left of the picture.
    let sides = [
        (-90.0, studio.say(text::WIND_FROM_LEFT)),
        (0.0, studio.say(text::WIND_FROM_FRONT)),
        (90.0, studio.say(text::WIND_FROM_RIGHT)),
        (180.0, studio.say(text::WIND_FROM_BACK)),
    ];
    if let Some(from) = choice(ui, Some(wind.from_deg), &sides) {
        studio.change(|design| design.wind.from_deg = from);
    }
    let (low, high) = range("wind", "from_deg");
    let knob = Knob {
        name: studio.say(text::WIND_ANGLE),
        range: low..=high,
        decimals: 0,
        unit: "°",
        scale: Scale::Even,
    };
    if let (_, Some(from)) = knob.show(ui, wind.from_deg) {
        studio.change(|design| design.wind.from_deg = from.round());
    }
}

fn gusts(ui: &mut Ui, studio: &mut Studio, wind: &WindDesign) {
    let (low, high) = range("wind", "gust_ratio");
    let knob = Knob {
        name: studio.say(text::GUSTS),
        range: 100.0 * low..=100.0 * high,
        decimals: 0,
        unit: " %",
        scale: Scale::Even,
    };
    if let (_, Some(percent)) = knob.show(ui, 100.0 * wind.gust_ratio) {
        studio.change(|design| design.wind.gust_ratio = percent.round() / 100.0);
    }
    if 0.0 < wind.gust_ratio {
        let name = format!("{} ({})", studio.say(text::OTHER_GUSTS), wind.seed);
        if wide_button(ui, &name) {
            studio.change(|design| design.wind.seed = design.wind.seed % 999 + 1);
        }
    }
}
