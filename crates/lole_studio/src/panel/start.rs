//! The first view: costumes to begin from, designs of the last days, a file, a group's list.

use std::path::PathBuf;

use eframe::egui::{self, Align2, RichText, ScrollArea, Sense, Ui};
use lole_body::Figure;
use lole_costume::document::{Design, GarmentDesign};
use lole_garment::Template;
use lole_language::{Words, words};

use super::{knob, sketch};
use crate::studio::{Request, Tab};
use crate::{Studio, look, text};

/// Size of a card with a costume [point].
const CARD: egui::Vec2 = egui::vec2(142.0, 132.0);
/// Height of the sketch on it [point].
const SKETCH: f32 = 76.0;
/// Width of the page where there is room [point].
const WIDTH: f32 = 780.0;

/// A costume to begin from.
struct Costume {
    name: Words,
    /// What is drawn of it.
    sketch: &'static str,
    /// What is worn instead of the pāʻū skirt alone.
    worn: Worn,
    figure: Figure,
}

/// Kinds of garments, from the skin outward.
#[derive(Clone, Copy)]
enum Worn {
    /// With the pāʻū skirt.
    With(&'static [&'static str]),
    /// In its place.
    Instead(&'static [&'static str]),
}

const fn costume(name: Words, sketch: &'static str, worn: Worn) -> Costume {
    Costume {
        name,
        sketch,
        worn,
        figure: Figure::OfStature,
    }
}

/// From the plainest on.
const COSTUMES: [Costume; 10] = [
    costume(
        words("パウスカート", "Pāʻū skirt"),
        "pau-skirt",
        Worn::With(&[]),
    ),
    costume(
        words("パウとトップ", "Pāʻū and top"),
        "pau-top",
        Worn::With(&["pau-top"]),
    ),
    costume(
        words("パウとブラウス", "Pāʻū and blouse"),
        "blouse",
        Worn::With(&["blouse"]),
    ),
    costume(
        words("フリルのパウ", "Pāʻū with ruffles"),
        "pau-ruffle",
        Worn::Instead(&["pau-ruffle"]),
    ),
    costume(
        words("ムームー", "Muʻumuʻu"),
        "muumuu",
        Worn::Instead(&["muumuu"]),
    ),
    costume(
        words("ホロクー", "Holokū"),
        "holoku",
        Worn::Instead(&["holoku"]),
    ),
    costume(
        words("キーケパ", "Kīkepa"),
        "kikepa",
        Worn::Instead(&["kikepa"]),
    ),
    costume(
        words("カヒコのパウ", "Pāʻū of kahiko"),
        "pau-kahiko",
        Worn::Instead(&["pau-kahiko"]),
    ),
    costume(
        words("ティーリーフ", "Ti leaf skirt"),
        "ti-leaf-skirt",
        Worn::Instead(&["ti-leaf-skirt"]),
    ),
    Costume {
        figure: Figure::Man,
        ..costume(
            words("マロ（男性）", "Malo (men)"),
            "malo",
            Worn::Instead(&["malo"]),
        )
    },
];

impl Costume {
    fn design(&self) -> Design {
        let mut design = Design::default();
        let (Worn::With(kinds) | Worn::Instead(kinds)) = self.worn;
        design.skirt.is_worn = matches!(self.worn, Worn::With(_));
        design.dancer.figure = self.figure;
        design.garments = (kinds.iter())
            .filter_map(|id| GarmentDesign::of_kind(id))
            .collect();
        design
    }
}

/// What was chosen.
enum Chosen {
    Costume(&'static Costume),
    Recent(PathBuf),
    File,
    List,
    Nothing,
}

/// Shows it over the dance, until something is chosen.
pub fn show(ui: &mut Ui, studio: &mut Studio) {
    // A question that was asked from here stands in its place, and leads back when it is given up.
    if !studio.starts || studio.question.is_some() {
        return;
    }
    let screen = ui.ctx().content_rect();
    let room = egui::vec2(
        WIDTH.min(screen.width() - 52.0),
        (screen.height() - 110.0).max(120.0),
    );
    let mut chosen = None;
    egui::Window::new(studio.say(text::WHAT_TO_MAKE))
        .id(egui::Id::unique("start"))
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ui.ctx(), |ui| {
            ui.set_width(room.x);
            ScrollArea::vertical().max_height(room.y).show(ui, |ui| {
                chosen = page(ui, studio);
            });
        });
    if ui.input(|input| input.key_pressed(egui::Key::Escape)) {
        chosen = Some(Chosen::Nothing);
    }
    if let Some(chosen) = chosen {
        begin(studio, chosen);
    }
}

fn page(ui: &mut Ui, studio: &Studio) -> Option<Chosen> {
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(8.0, 8.0);
        for costume in &COSTUMES {
            if card(ui, studio.say(costume.name), costume.sketch) {
                chosen = Some(Chosen::Costume(costume));
            }
        }
    });
    if !studio.memory.recent.is_empty() {
        ui.add_space(6.0);
        let title = RichText::new(studio.say(text::RECENT)).heading();
        ui.label(title.color(look::RED));
        for path in &studio.memory.recent {
            let name = path.file_stem().unwrap_or(path.as_os_str());
            let button = ui.add(
                egui::Button::new(name.to_string_lossy())
                    .wrap()
                    .min_size(egui::vec2(220.0, look::TARGET)),
            );
            if button.on_hover_text(path.display().to_string()).clicked() {
                chosen = Some(Chosen::Recent(path.clone()));
            }
        }
    }
    ui.add_space(8.0);
    ui.horizontal_wrapped(|ui| {
        for (name, choice) in [
            (text::OPEN_DESIGN, Chosen::File),
            (text::CHOOSE_LIST, Chosen::List),
            (text::BEGIN_AS_IT_IS, Chosen::Nothing),
        ] {
            if ui.button(studio.say(name)).clicked() {
                chosen = Some(choice);
            }
        }
    });
    chosen
}

/// A card with a sketch and a name; whether it was chosen.
fn card(ui: &mut Ui, name: &str, id: &str) -> bool {
    let (rect, response) = ui.allocate_exact_size(CARD, Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
    let visuals = *ui.style().interact(&response);
    ui.painter().rect(
        rect,
        8.0,
        visuals.bg_fill.gamma_multiply(0.55),
        visuals.bg_stroke,
        egui::StrokeKind::Inside,
    );
    if let Some(template) = Template::of_id(id) {
        let top = rect.center_top() + egui::vec2(0.0, 6.0 + 0.5 * SKETCH);
        let place = egui::Rect::from_center_size(top, egui::Vec2::splat(SKETCH));
        sketch::draw(ui.painter(), place, template.sketch);
    }
    let font = egui::TextStyle::Body.resolve(ui.style());
    let room = CARD.x - 12.0;
    let mut job = egui::text::LayoutJob::simple(name.to_owned(), font, look::INK, room);
    job.halign = egui::Align::Center;
    let galley = ui.painter().layout_job(job);
    let low = rect.bottom() - 6.0 - galley.size().y;
    ui.painter()
        .galley(egui::pos2(rect.center().x, low), galley, look::INK);
    response.clicked()
}

fn begin(studio: &mut Studio, chosen: Chosen) {
    match chosen {
        Chosen::Costume(costume) => {
            // The first is worn already: nothing has to be sewn anew.
            if costume.design() != *studio.design() {
                studio.opened(costume.design(), None);
            }
            studio.tab = Tab::default();
        }
        Chosen::Recent(path) => studio.request(Request::Open(path)),
        // The page stays until something is opened.
        Chosen::File => {
            studio.request(Request::AskOpen);
            return;
        }
        Chosen::List => {
            studio.tab = Tab::Order;
            studio.request(Request::AskRoster);
            return;
        }
        Chosen::Nothing => {}
    }
    studio.starts = false;
}

/// A button that leads back to this page.
pub(super) fn button(ui: &mut Ui, studio: &mut Studio) {
    if knob::wide_button(ui, studio.say(text::FIRST_PAGE)) {
        studio.starts = true;
        ui.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::tests::paper_of;

    #[test]
    fn every_costume_to_begin_from_can_be_drafted_and_no_two_are_alike() {
        let designs: Vec<Design> = COSTUMES.iter().map(Costume::design).collect();
        for (place, (costume, design)) in COSTUMES.iter().zip(&designs).enumerate() {
            let name = costume.name.english;
            assert!(design.check("").is_ok(), "{name}");
            let (Worn::With(kinds) | Worn::Instead(kinds)) = costume.worn;
            assert_eq!(design.garments.len(), kinds.len(), "{name}");
            assert!(Template::of_id(costume.sketch).is_some(), "{name}");
            let paper = paper_of(design);
            assert!(
                paper.garments.iter().all(|garment| garment.cut.is_ok()),
                "{name}"
            );
            assert!(!designs[..place].contains(design), "{name}");
        }
        assert_eq!(designs[0], Design::default());
    }
}
