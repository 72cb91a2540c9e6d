//! Sketches of garments, drawn.

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, pos2};
use lole_garment::Sketch;
use lole_garment::sketch::{self, Tone};

use crate::look;

/// Color of cloth and of what is tied of leaves.
const CLOTH: Color32 = Color32::from_rgb(240, 214, 208);
const LEAF: Color32 = Color32::from_rgb(205, 222, 190);

/// Draws a sketch in the middle of a rectangle.
pub(super) fn draw(painter: &Painter, rect: Rect, draw: fn(&mut Sketch)) {
    let mut drawn = Sketch::default();
    draw(&mut drawn);
    let size = rect.width().min(rect.height());
    let at = |[x, y]: [f32; 2]| -> Pos2 {
        let middle = rect.center();
        pos2(middle.x + (x - 0.5) * size, middle.y + (y - 0.5) * size)
    };
    let all = |points: Vec<[f32; 2]>| points.into_iter().map(at).collect();
    for stroke in drawn.strokes {
        painter.add(match stroke {
            sketch::SketchStroke::Line(points) => {
                Shape::line(all(points), Stroke::new(0.9, look::PALE_INK))
            }
            sketch::SketchStroke::Patch(points, tone) => {
                let outline = Stroke::new(1.4, look::INK);
                Shape::convex_polygon(all(points), color(tone), outline)
            }
            sketch::SketchStroke::Disc(middle, radius, tone) => {
                let circle = eframe::egui::epaint::CircleShape {
                    center: at(middle),
                    radius: radius * size,
                    fill: color(tone),
                    stroke: Stroke::new(1.2, look::INK),
                };
                circle.into()
            }
        });
    }
}

const fn color(tone: Tone) -> Color32 {
    match tone {
        Tone::Cloth => CLOTH,
        Tone::Leaf => LEAF,
        Tone::Rgb([red, green, blue]) => Color32::from_rgb(red, green, blue),
    }
}
