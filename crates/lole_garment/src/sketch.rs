//! Small flat drawings of garments, as a maker sketches them from the front.

use lole_geom::trig;

/// What a patch of a sketch is filled with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// Cloth.
    Cloth,
    /// What is tied of leaves.
    Leaf,
    /// A color of its own, sRGB.
    Rgb([u8; 3]),
}

/// A part of a sketch. Corners of its square are at 0 and 1, `y` down.
#[derive(Debug, Clone, PartialEq)]
pub enum SketchStroke {
    /// A thin line through points.
    Line(Vec<[f32; 2]>),
    /// A convex patch with its outline.
    Patch(Vec<[f32; 2]>, Tone),
    /// A disc with its outline: middle and radius.
    Disc([f32; 2], f32, Tone),
}

/// A sketch: strokes, those farther behind first.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sketch {
    /// What is drawn.
    pub strokes: Vec<SketchStroke>,
}

impl Sketch {
    /// A thin line.
    pub fn line(&mut self, points: &[[f32; 2]]) {
        self.strokes.push(SketchStroke::Line(points.to_vec()));
    }

    /// A convex patch with its outline.
    pub fn patch(&mut self, points: &[[f32; 2]], tone: Tone) {
        self.strokes
            .push(SketchStroke::Patch(points.to_vec(), tone));
    }

    /// A disc with its outline.
    pub fn disc(&mut self, middle: [f32; 2], radius: f32, tone: Tone) {
        self.strokes.push(SketchStroke::Disc(middle, radius, tone));
    }

    /// Lines from a waist that open like a fan.
    pub(crate) fn fan(&mut self, [top, bottom]: [f32; 2], [narrow, wide]: [f32; 2], count: u8) {
        for index in 0..=count {
            let share = 2.0 * f32::from(index) / f32::from(count) - 1.0;
            self.line(&[[0.5 + share * narrow, top], [0.5 + share * wide, bottom]]);
        }
    }

    /// A ring of small discs.
    pub(crate) fn ring(
        &mut self,
        middle: [f32; 2],
        [across, down]: [f32; 2],
        [count, size]: [f32; 2],
    ) {
        let mut turn = 0.0;
        while turn < 1.0 - 1e-3 {
            let (sin, cos) = trig::sin_cos(turn * std::f32::consts::TAU);
            let at = [middle[0] + across * cos, middle[1] + down * sin];
            self.disc(at, size, Tone::Cloth);
            turn += 1.0 / count;
        }
    }

    /// A skirt with its casings and folds.
    pub(crate) fn skirt(&mut self, hem: f32) {
        let outline = [[0.32, 0.1], [0.68, 0.1], [0.9, hem], [0.1, hem]];
        self.patch(&outline, Tone::Cloth);
        for y in [0.15, 0.2, 0.25] {
            let wider = 0.28 * (y - 0.1);
            self.line(&[[0.32 - wider, y], [0.68 + wider, y]]);
        }
        self.fan([0.3, hem], [0.18, 0.3], 4);
    }

    /// A dress with sleeves; `waist` is how far each side is from the middle there.
    pub(crate) fn dress(&mut self, waist: f32, hem: f32) {
        for side in [-1.0, 1.0] {
            let x = |x: f32| 0.5 + side * x;
            let sleeve = [
                [x(0.17), 0.12],
                [x(0.34), 0.3],
                [x(0.25), 0.37],
                [x(0.15), 0.26],
            ];
            self.patch(&sleeve, Tone::Cloth);
        }
        let [left, right] = [[0.5 - waist, 0.42], [0.5 + waist, 0.42]];
        let bodice = [
            [0.35, 0.1],
            [0.65, 0.1],
            [0.66, 0.26],
            right,
            left,
            [0.34, 0.26],
        ];
        self.patch(&bodice, Tone::Cloth);
        let skirt = [left, right, [0.5 + hem, 0.94], [0.5 - hem, 0.94]];
        self.patch(&skirt, Tone::Cloth);
        self.line(&[[0.42, 0.1], [0.46, 0.15], [0.54, 0.15], [0.58, 0.1]]);
    }

    /// Strands on a band.
    pub(crate) fn strands(&mut self, tone: Tone, count: u8) {
        let skirt = [[0.3, 0.16], [0.7, 0.16], [0.88, 0.9], [0.12, 0.9]];
        self.patch(&skirt, tone);
        let band = [[0.29, 0.1], [0.71, 0.1], [0.71, 0.17], [0.29, 0.17]];
        self.patch(&band, Tone::Cloth);
        self.fan([0.17, 0.9], [0.19, 0.38], count);
    }
}
