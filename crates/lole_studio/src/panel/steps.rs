//! The steps of hula in families, to be danced over and over or to be put into a choreography.

use eframe::egui::{Button, ComboBox, RichText, Ui, WidgetInfo, accesskit::Role};
use lole_hula::DanceStep;
use lole_language::{Language, Words, words};

use super::dance;
use crate::{Studio, look, text};

/// Steps that go together.
struct Family {
    name: Words,
    steps: &'static [DanceStep],
}

/// Every step, once.
const FAMILIES: &[Family] = &[
    Family {
        name: words("カホロの仲間", "Kāholo"),
        steps: &[
            DanceStep::Kaholo,
            DanceStep::KaholoDip,
            DanceStep::KaholoDouble,
            DanceStep::KaholoForward,
            DanceStep::KaholoDiagonal,
        ],
    },
    Family {
        name: words("腰を揺らす", "Swaying"),
        steps: &[DanceStep::Kao, DanceStep::Nee, DanceStep::KalakauaSway],
    },
    Family {
        name: words("アミ（腰を回す）", "ʻAmi"),
        steps: &[
            DanceStep::Ami,
            DanceStep::AmiKahela,
            DanceStep::AmiKuu,
            DanceStep::AmiOniu,
            DanceStep::AmiHalfMoon,
            DanceStep::Hue,
        ],
    },
    Family {
        name: words("足を出す・上げる", "Pointing and lifting"),
        steps: &[
            DanceStep::Hela,
            DanceStep::Uwehe,
            DanceStep::LeleUwehe,
            DanceStep::AiKawele,
            DanceStep::Kui,
            DanceStep::Aui,
        ],
    },
    Family {
        name: words("進む", "Travelling"),
        steps: &[
            DanceStep::Lele,
            DanceStep::Holo,
            DanceStep::Kawelu,
            DanceStep::KaweluZigzag,
            DanceStep::Kalakaua,
        ],
    },
    Family {
        name: words("回る", "Turning"),
        steps: &[DanceStep::KalakauaTurn, DanceStep::Kaapuni],
    },
];

/// Place of the family of a step.
pub(super) fn family_of(step: DanceStep) -> usize {
    let mut families = FAMILIES.iter();
    families
        .position(|family| family.steps.contains(&step))
        .unwrap_or(0)
}

/// Height of the list that drops down [point]: a dozen steps.
const LIST_HEIGHT: f32 = 480.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let chosen = dance::is_danced(studio).then_some(studio.design().motion.step);
    if let Some(step) = rows(ui, studio.language, chosen) {
        dance::dance_step(studio, step);
    }
    let chosen = studio.design().motion.step;
    ui.label(RichText::new(studio.say(chosen.about())).small().weak());
}

/// Name of a step: in Hawaiian, and for Japanese eyes as it is said.
pub(super) fn name(step: DanceStep, language: Language) -> &'static str {
    match language {
        Language::Japanese => step.title().japanese,
        Language::English => step.name(),
    }
}

/// All steps in rows; the one that was picked, if one was.
fn rows(ui: &mut Ui, language: Language, chosen: Option<DanceStep>) -> Option<DanceStep> {
    let mut picked = None;
    for family in FAMILIES {
        ui.label(RichText::new(family.name.text(language)).small().weak());
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = [4.0, 4.0].into();
            for &step in family.steps {
                let button = Button::selectable(chosen == Some(step), name(step, language))
                    .frame_when_inactive(true)
                    .min_size([36.0, look::TARGET].into());
                if ui.add(button).on_hover_text(step.name()).clicked() {
                    picked = Some(step);
                }
            }
        });
    }
    picked
}

/// A list of the steps that drops down, for one part of a choreography.
pub(super) struct StepList {
    /// Number of the part, from 1.
    pub(super) number: usize,
    /// Width of the list while it is shut [point].
    pub(super) width: f32,
}

impl StepList {
    /// Shows it; the new step.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        studio: &Studio,
        chosen: DanceStep,
    ) -> Option<DanceStep> {
        let language = studio.language;
        let mut picked = chosen;
        let response = ComboBox::from_id_salt(("step of part", self.number))
            .width(self.width)
            .height(LIST_HEIGHT)
            .wrap()
            .selected_text(name(chosen, language))
            .show_ui(ui, |ui| {
                for family in FAMILIES {
                    ui.label(RichText::new(family.name.text(language)).small().weak());
                    for &step in family.steps {
                        ui.selectable_value(&mut picked, step, name(step, language));
                    }
                }
            })
            .response;
        response.widget_info(|| {
            let what = format!("{} {}", self.number, studio.say(text::DANCE_STEP));
            let mut info = WidgetInfo::labeled(Role::ComboBox, true, what);
            info.current_text_value = Some(name(chosen, language).to_owned());
            info
        });
        (picked != chosen).then_some(picked)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_is_in_one_family() {
        let mut all: Vec<DanceStep> = FAMILIES.iter().flat_map(|f| f.steps).copied().collect();
        all.sort();
        let mut known = DanceStep::ALL.to_vec();
        known.sort();
        assert_eq!(all, known);
    }
}
