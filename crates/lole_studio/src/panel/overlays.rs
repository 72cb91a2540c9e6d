//! What is drawn over the picture.

use eframe::egui::{self, RichText, Ui};

use crate::{Studio, look, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let mut shows = studio.shows;
    let boxes = [
        (&mut shows.capsules, text::CAPSULES),
        (&mut shows.skeleton, text::SKELETON),
        (&mut shows.springs, text::SPRINGS),
        (&mut shows.sunken, text::SUNKEN),
    ];
    let half = ui.available_width() / 2.0;
    egui::Grid::new("overlays")
        .num_columns(2)
        .min_col_width(half - 8.0)
        .spacing([8.0, 4.0])
        .show(ui, |ui| {
            for (index, (shown, name)) in boxes.into_iter().enumerate() {
                ui.checkbox(shown, studio.say(name));
                if index % 2 == 1 {
                    ui.end_row();
                }
            }
        });
    studio.set_shows(shows);
}

/// Whether the cloth is colored by its strain, which shows a maker where it pulls.
pub(super) fn strain(ui: &mut Ui, studio: &mut Studio) {
    let mut shows = studio.shows;
    ui.checkbox(&mut shows.strain, studio.say(text::STRAIN));
    if shows.strain {
        legend(ui, studio);
    }
    studio.set_shows(shows);
}

/// What the colors of the strain mean.
fn legend(ui: &mut Ui, studio: &Studio) {
    let percent = 100.0 * look::FULL_STRAIN;
    let width = ui.available_width();
    let (area, _) = ui.allocate_exact_size(egui::vec2(width, 12.0), egui::Sense::hover());
    let mut mesh = egui::Mesh::default();
    const STEPS: u16 = 32;
    for step in 0..=STEPS {
        let share = f32::from(step) / f32::from(STEPS);
        let color = look::strain_color((2.0 * share - 1.0) * look::FULL_STRAIN);
        let color: egui::Color32 = egui::Rgba::from_rgb(color.x, color.y, color.z).into();
        let x = area.left() + share * area.width();
        mesh.colored_vertex(egui::pos2(x, area.top()), color);
        mesh.colored_vertex(egui::pos2(x, area.bottom()), color);
        if 0 < step {
            let last = u32::from(step) * 2;
            mesh.add_triangle(last - 2, last - 1, last);
            mesh.add_triangle(last - 1, last, last + 1);
        }
    }
    ui.painter().add(mesh);
    ui.horizontal(|ui| {
        let small = |words: String| RichText::new(words).small();
        ui.label(small(format!(
            "−{percent:.0} % {}",
            studio.say(text::SHRUNK)
        )));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(small(format!(
                "{} +{percent:.0} %",
                studio.say(text::STRETCHED)
            )));
        });
    });
}
