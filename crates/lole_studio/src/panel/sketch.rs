//! Small flat drawings of garments, as a maker sketches them from the front.

use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, pos2};
use lole_geom::trig;

use crate::look;

/// Color of cloth and of what is tied of leaves.
const CLOTH: Color32 = Color32::from_rgb(240, 214, 208);
const LEAF: Color32 = Color32::from_rgb(205, 222, 190);

/// Draws in a square whose corners are 0 and 1, `y` down.
struct Pen<'a> {
    painter: &'a Painter,
    rect: Rect,
}

impl Pen<'_> {
    fn at(&self, [x, y]: [f32; 2]) -> Pos2 {
        let size = self.rect.width().min(self.rect.height());
        pos2(
            self.rect.center().x + (x - 0.5) * size,
            self.rect.center().y + (y - 0.5) * size,
        )
    }

    fn line(&self, points: &[[f32; 2]]) {
        let points = points.iter().map(|point| self.at(*point)).collect();
        let stroke = Stroke::new(0.9, look::PALE_INK);
        self.painter.add(Shape::line(points, stroke));
    }

    /// A convex patch with its outline.
    fn patch(&self, points: &[[f32; 2]], fill: Color32) {
        let points = points.iter().map(|point| self.at(*point)).collect();
        let stroke = Stroke::new(1.4, look::INK);
        self.painter
            .add(Shape::convex_polygon(points, fill, stroke));
    }

    fn disc(&self, middle: [f32; 2], radius: f32, fill: Color32) {
        let size = self.rect.width().min(self.rect.height());
        let stroke = Stroke::new(1.2, look::INK);
        (self.painter).circle(self.at(middle), radius * size, fill, stroke);
    }

    /// Lines from a waist that open like a fan.
    fn fan(&self, [top, bottom]: [f32; 2], [narrow, wide]: [f32; 2], count: u8) {
        for index in 0..=count {
            let share = 2.0 * f32::from(index) / f32::from(count) - 1.0;
            self.line(&[[0.5 + share * narrow, top], [0.5 + share * wide, bottom]]);
        }
    }

    /// A ring of small discs.
    fn ring(&self, middle: [f32; 2], [across, down]: [f32; 2], [count, size]: [f32; 2]) {
        let mut turn = 0.0;
        while turn < 1.0 - 1e-3 {
            let (sin, cos) = trig::sin_cos(turn * std::f32::consts::TAU);
            let at = [middle[0] + across * cos, middle[1] + down * sin];
            self.disc(at, size, CLOTH);
            turn += 1.0 / count;
        }
    }

    /// A skirt with its casings and folds.
    fn skirt(&self, hem: f32) {
        self.patch(&[[0.32, 0.1], [0.68, 0.1], [0.9, hem], [0.1, hem]], CLOTH);
        for y in [0.15, 0.2, 0.25] {
            let wider = 0.28 * (y - 0.1);
            self.line(&[[0.32 - wider, y], [0.68 + wider, y]]);
        }
        self.fan([0.3, hem], [0.18, 0.3], 4);
    }

    /// A dress with sleeves; `waist` is how far each side is from the middle there.
    fn dress(&self, waist: f32, hem: f32) {
        for side in [-1.0, 1.0] {
            let x = |x: f32| 0.5 + side * x;
            let sleeve = [
                [x(0.17), 0.12],
                [x(0.34), 0.3],
                [x(0.25), 0.37],
                [x(0.15), 0.26],
            ];
            self.patch(&sleeve, CLOTH);
        }
        let body = |x: f32| [[0.5 - x, 0.42], [0.5 + x, 0.42]];
        let [left, right] = body(waist);
        self.patch(
            &[
                [0.35, 0.1],
                [0.65, 0.1],
                [0.66, 0.26],
                right,
                left,
                [0.34, 0.26],
            ],
            CLOTH,
        );
        self.patch(&[left, right, [0.5 + hem, 0.94], [0.5 - hem, 0.94]], CLOTH);
        self.line(&[[0.42, 0.1], [0.46, 0.15], [0.54, 0.15], [0.58, 0.1]]);
    }

    fn blouse(&self) {
        for side in [-1.0, 1.0] {
            self.disc([0.5 + side * 0.24, 0.34], 0.11, CLOTH);
        }
        let body = [
            [0.33, 0.2],
            [0.67, 0.2],
            [0.67, 0.5],
            [0.72, 0.82],
            [0.28, 0.82],
            [0.33, 0.5],
        ];
        self.patch(&body, CLOTH);
        self.line(&[[0.4, 0.2], [0.44, 0.29], [0.56, 0.29], [0.6, 0.2]]);
    }

    /// Strands on a band.
    fn strands(&self, fill: Color32, count: u8) {
        let skirt = [[0.3, 0.16], [0.7, 0.16], [0.88, 0.9], [0.12, 0.9]];
        self.patch(&skirt, fill);
        self.patch(
            &[[0.29, 0.1], [0.71, 0.1], [0.71, 0.17], [0.29, 0.17]],
            CLOTH,
        );
        self.fan([0.17, 0.9], [0.19, 0.38], count);
    }
}

/// Draws the garment of this kind; nothing for one that has no sketch yet.
pub(super) fn draw(painter: &Painter, rect: Rect, id: &str) {
    let pen = Pen { painter, rect };
    match id {
        "pau-skirt" => pen.skirt(0.9),
        "pau-ruffle" => {
            pen.skirt(0.74);
            let ruffle = [[0.17, 0.72], [0.83, 0.72], [0.96, 0.92], [0.04, 0.92]];
            pen.patch(&ruffle, CLOTH);
            pen.fan([0.74, 0.92], [0.3, 0.42], 9);
        }
        "pau-kahiko" => {
            pen.patch(&[[0.26, 0.2], [0.74, 0.2], [0.88, 0.8], [0.12, 0.8]], CLOTH);
            pen.patch(
                &[[0.24, 0.14], [0.76, 0.14], [0.78, 0.26], [0.22, 0.26]],
                CLOTH,
            );
            pen.fan([0.28, 0.8], [0.2, 0.32], 6);
        }
        "pau-top" => {
            pen.patch(
                &[[0.26, 0.26], [0.74, 0.26], [0.72, 0.76], [0.28, 0.76]],
                CLOTH,
            );
            pen.line(&[[0.26, 0.33], [0.74, 0.33]]);
            pen.line(&[[0.28, 0.6], [0.72, 0.6]]);
            pen.fan([0.34, 0.58], [0.18, 0.18], 6);
        }
        "blouse" => pen.blouse(),
        "muumuu" => {
            pen.dress(0.2, 0.32);
            pen.line(&[[0.34, 0.24], [0.66, 0.24]]);
        }
        "holoku" => {
            pen.dress(0.13, 0.24);
            pen.patch(&[[0.7, 0.82], [0.98, 0.96], [0.74, 0.94]], CLOTH);
        }
        "kikepa" => {
            pen.patch(&[[0.3, 0.34], [0.7, 0.3], [0.76, 0.9], [0.24, 0.9]], CLOTH);
            pen.patch(
                &[[0.3, 0.34], [0.36, 0.12], [0.44, 0.12], [0.5, 0.33]],
                CLOTH,
            );
        }
        "kihei" => {
            pen.patch(
                &[
                    [0.3, 0.16],
                    [0.5, 0.2],
                    [0.82, 0.5],
                    [0.74, 0.9],
                    [0.2, 0.86],
                ],
                CLOTH,
            );
            pen.disc([0.34, 0.17], 0.05, CLOTH);
            pen.line(&[[0.38, 0.24], [0.66, 0.86]]);
        }
        "malo" => {
            pen.patch(&[[0.2, 0.3], [0.8, 0.3], [0.8, 0.4], [0.2, 0.4]], CLOTH);
            pen.patch(
                &[[0.38, 0.36], [0.62, 0.36], [0.6, 0.86], [0.4, 0.86]],
                CLOTH,
            );
        }
        _ => draw_adornment(&pen, id),
    }
}

/// What is tied of leaves and strung of flowers, and what is played.
fn draw_adornment(pen: &Pen<'_>, id: &str) {
    match id {
        "ti-leaf-skirt" => pen.strands(LEAF, 8),
        "raffia-skirt" => pen.strands(Color32::from_rgb(240, 226, 190), 11),
        "cellophane-skirt" => pen.strands(Color32::from_rgb(214, 230, 240), 9),
        "lei" => pen.ring([0.5, 0.5], [0.26, 0.36], [20.0, 0.05]),
        "lei-poo" => pen.ring([0.5, 0.5], [0.36, 0.17], [18.0, 0.06]),
        "kupee" => {
            pen.ring([0.3, 0.5], [0.16, 0.1], [12.0, 0.04]);
            pen.ring([0.72, 0.5], [0.16, 0.1], [12.0, 0.04]);
        }
        "hair-flower" => {
            pen.ring([0.5, 0.5], [0.2, 0.2], [5.0, 0.17]);
            pen.disc([0.5, 0.5], 0.07, Color32::from_rgb(240, 200, 60));
        }
        "uliuli" => {
            pen.ring([0.5, 0.3], [0.26, 0.12], [14.0, 0.08]);
            pen.disc([0.5, 0.3], 0.16, CLOTH);
            pen.patch(
                &[[0.46, 0.46], [0.54, 0.46], [0.54, 0.66], [0.46, 0.66]],
                LEAF,
            );
            pen.disc([0.5, 0.76], 0.14, Color32::from_rgb(214, 180, 130));
        }
        "puili" => {
            for x in [0.34, 0.6] {
                pen.patch(
                    &[[x, 0.1], [x + 0.1, 0.1], [x + 0.1, 0.92], [x, 0.92]],
                    LEAF,
                );
                for step in [0.03, 0.05, 0.07] {
                    pen.line(&[[x + step, 0.1], [x + step, 0.66]]);
                }
            }
        }
        "ipu" => {
            let gourd = Color32::from_rgb(214, 180, 130);
            pen.disc([0.5, 0.66], 0.26, gourd);
            pen.disc([0.5, 0.29], 0.18, gourd);
            pen.line(&[[0.44, 0.12], [0.56, 0.12]]);
        }
        _ => {}
    }
}
