//! The dancer's face and hair: age, features, hair and makeup.

use eframe::egui::Ui;
use lole_body::{Feature, HairStyle, Makeup};
use lole_costume::document::FaceDesign;

use super::knob::{Knob, Scale, wide_button};
use super::set::choose;
use crate::{Studio, text};

/// What an age that nobody gave looks like [years].
const USUAL_AGE: f64 = 30.0;

/// Someone's avatar has a head of its own.
pub(super) fn is_hers(studio: &Studio) -> bool {
    studio.design().dancer.file.is_none()
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let (hair, makeup) = (studio.design().dancer.hair, studio.design().dancer.makeup);
    let styles = HairStyle::ALL.map(|style| (style, style.name()));
    if let Some(style) = choose(ui, studio, (text::HAIR, &styles), hair) {
        studio.change(|design| design.dancer.hair = style);
    }
    let makeups = Makeup::ALL.map(|makeup| (makeup, makeup.name()));
    if let Some(makeup) = choose(ui, studio, (text::MAKEUP, &makeups), makeup) {
        studio.change(|design| design.dancer.makeup = makeup);
    }
    age(ui, studio);
    if wide_button(ui, studio.say(text::OTHER_FACE)) {
        studio.change(|design| {
            design.face = FaceDesign {
                // Every press shows one that was not there before.
                seed: design.face.seed % u64::from(u32::MAX) + 1,
                ..FaceDesign::default()
            };
        });
    }
    let is_measured = studio.design().face.is_unchosen();
    if !is_measured && wide_button(ui, studio.say(text::MEASURED_FACE)) {
        studio.change(|design| design.face = FaceDesign::default());
    }
    ui.collapsing(studio.say(text::FEATURES), |ui| features(ui, studio));
}

/// How old she looks, and a button to leave it to her measures.
fn age(ui: &mut Ui, studio: &mut Studio) {
    let given = studio.design().dancer.age_years;
    let knob = Knob {
        name: studio.say(text::AGE),
        range: 0.0..=f64::INFINITY,
        decimals: 0,
        unit: studio.say(text::YEARS),
        scale: Scale::Even,
    };
    let knob = knob.within("dancer", "age_years");
    if let (_, Some(years)) = knob.show(ui, given.unwrap_or(USUAL_AGE)) {
        studio.change_later(|design| design.dancer.age_years = Some(years.round()));
    }
    if given.is_some() && wide_button(ui, studio.say(text::NO_AGE)) {
        studio.change(|design| design.dancer.age_years = None);
    }
}

fn features(ui: &mut Ui, studio: &mut Studio) {
    let face = studio.design().face.face();
    for feature in Feature::ALL {
        let knob = Knob {
            name: studio.say(feature.name()),
            range: -1.0..=1.0,
            decimals: 2,
            unit: "",
            scale: Scale::Even,
        };
        let knob = knob.within("face", feature.id());
        if let (_, Some(value)) = knob.show(ui, f64::from(face.feature(feature))) {
            let value = (value * 100.0).round() / 100.0;
            studio.change_later(|design| {
                design.face.features[feature.index()] = Some(value);
            });
        }
    }
}
