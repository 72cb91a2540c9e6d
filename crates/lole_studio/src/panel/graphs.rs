//! Frame time, energy and the way of the hem over the last ten seconds.

use eframe::egui::{Color32, Rangef, RichText, Ui};
use egui_plot::{HLine, Line, Plot, PlotPoints};

use crate::history::Sample;
use crate::{Studio, look, text};

/// Height of a graph [point].
const HEIGHT: f32 = 104.0;
/// What a frame may take in real time [ms].
const REAL_TIME_MS: f64 = 1000.0 / 60.0;

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let points = |value: &dyn Fn(&Sample) -> [f64; 2]| -> Vec<[f64; 2]> {
        studio.history.samples().map(value).collect()
    };
    let time = |sample: &Sample| f64::from(sample.time);

    ui.label(RichText::new(pace(studio)).small());
    title(ui, studio.say(text::FRAME_TIME));
    let cost = points(&|s| [time(s), f64::from(s.milliseconds)]);
    plot("frame time")
        .include_y(0.0)
        .include_y(20.0)
        .show(ui, |plot| {
            plot.hline(HLine::new("", REAL_TIME_MS).color(look::RED).width(1.0));
            plot.line(line("", cost, look::TEAL));
        });

    title(ui, studio.say(text::ENERGY));
    let least = (studio.history.samples())
        .map(|s| s.vitals.potential_energy)
        .fold(f32::MAX, f32::min);
    let motion = points(&|s| [time(s), f64::from(s.vitals.kinetic_energy)]);
    let height = points(&|s| [time(s), f64::from(s.vitals.potential_energy - least)]);
    let elastic: Vec<[f64; 2]> = (studio.history.samples())
        .filter_map(|s| Some([time(s), f64::from(s.vitals.elastic_energy?)]))
        .collect();
    let stretches = !elastic.is_empty();
    plot("energy").include_y(0.0).show(ui, |plot| {
        plot.line(line("", motion, look::RED));
        plot.line(line("", height, look::TEAL));
        plot.line(line("", elastic, look::OCHRE));
    });
    ui.horizontal_wrapped(|ui| {
        legend(ui, studio.say(text::MOTION_ENERGY), look::RED);
        legend(ui, studio.say(text::HEIGHT_ENERGY), look::TEAL);
        if stretches {
            legend(ui, studio.say(text::ELASTIC_ENERGY), look::OCHRE);
        }
    });

    title(ui, studio.say(text::HEM_PATH));
    let path = points(&|s| {
        [
            100.0 * f64::from(s.vitals.hem_middle[0]),
            100.0 * f64::from(s.vitals.hem_height),
        ]
    });
    plot("hem path").show(ui, |plot| plot.line(line("", path, look::TEAL)));
}

/// What a frame takes, and how many pictures a second there are.
fn pace(studio: &Studio) -> String {
    let mut said = Vec::new();
    if let Some(milliseconds) = studio.history.milliseconds() {
        let unit = studio.say(text::MS_PER_FRAME);
        said.push(format!("{milliseconds:.1} {unit}"));
    }
    if let Some(pictures) = studio.pictures_per_second {
        let unit = studio.say(text::PICTURES_PER_SECOND);
        said.push(format!("{pictures:.0} {unit}"));
    }
    said.join("   ")
}

fn title(ui: &mut Ui, name: &str) {
    ui.label(RichText::new(name).small());
}

fn legend(ui: &mut Ui, name: &str, color: Color32) {
    ui.label(RichText::new("●").small().color(color));
    ui.label(RichText::new(name).small());
}

/// A graph that is looked at only: the wheel scrolls the panel.
fn plot(id: &str) -> Plot<'_> {
    Plot::new(id)
        .height(HEIGHT)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .show_background(true)
        .grid_spacing(Rangef::new(12.0, 46.0))
        .y_axis_min_width(30.0)
        .label_formatter(|_| None)
}

fn line(name: &str, points: Vec<[f64; 2]>, color: Color32) -> Line<'_> {
    Line::new(name, PlotPoints::from(points))
        .color(color)
        .width(1.6)
}
