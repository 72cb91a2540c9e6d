//! One's own picture of a cloth: which part of it is the repeat, and how large something on it is, drawn
//! on the picture with the pointer.

use std::sync::Arc;

use eframe::egui::{
    self, Color32, ColorImage, Painter, Pos2, Rect, RichText, Sense, Stroke, StrokeKind,
    TextureHandle, TextureOptions, Ui, pos2, vec2,
};
use lole_costume::document::PhotoMarks;
use lole_print::Picture;

use super::knob::{Knob, Scale, choice, wide_button};
use crate::studio::range;
use crate::{Studio, text};

/// Height of the picture in the column at most [point].
const HEIGHT: f32 = 260.0;
/// Longest side of the picture on the graphics adapter [pixel]: the column is not wider.
const SHOWN_SIDE: u32 = 1024;
/// A drag shorter than this on the picture's side marks nothing: a hand that trembles.
const LEAST_SHARE: f64 = 0.01;
/// A length that is often known: the ruler of a sewing box, or a postcard [cm].
const USUAL_CM: f64 = 10.0;
const REPEAT_LINE: Color32 = Color32::from_rgb(255, 210, 60);
const RULER_LINE: Color32 = Color32::from_rgb(90, 220, 255);
/// Below every line: a photo may be as pale as the line, or as dark.
const EDGE: Color32 = Color32::from_rgb(20, 18, 22);
/// Over what does not repeat.
const SHADE: Color32 = Color32::from_black_alpha(120);
/// Width of a line and of its edge [point].
const WIDTHS: [f32; 2] = [2.5, 5.5];

/// What a drag on the picture marks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Marking {
    /// The part that repeats.
    #[default]
    Repeat,
    /// A length that is known.
    Ruler,
}

/// The picture on the screen, and the mark that is being drawn.
#[derive(Default)]
pub(crate) struct PhotoDesk {
    marking: Marking,
    /// Where the drag began, in shares of the picture.
    start: Option<[f64; 2]>,
    /// Pictures that the graphics adapter has, one for each that is unfolded.
    shown: Vec<(Arc<Picture>, TextureHandle)>,
}

impl PhotoDesk {
    fn texture(&mut self, context: &egui::Context, picture: &Arc<Picture>) -> TextureHandle {
        let known = self
            .shown
            .iter()
            .find(|(shown, _)| Arc::ptr_eq(shown, picture));
        if let Some((_, texture)) = known {
            return texture.clone();
        }
        // What nobody else holds belongs to no design any more.
        self.shown.retain(|(shown, _)| 1 < Arc::strong_count(shown));
        let texture = context.load_texture("photo", scaled_down(picture), TextureOptions::LINEAR);
        self.shown.push((Arc::clone(picture), texture.clone()));
        texture
    }
}

/// Every so manyth pixel, so that the longest side fits an adapter.
fn scaled_down(picture: &Picture) -> ColorImage {
    let step = picture
        .width
        .max(picture.height)
        .div_ceil(SHOWN_SIDE)
        .max(1);
    let [width, height] = [picture.width, picture.height].map(|side| side.div_ceil(step));
    let pixels = (0..height).flat_map(|row| {
        (0..width).flat_map(move |column| {
            let place =
                4 * (row * step) as usize * picture.width as usize + 4 * (column * step) as usize;
            picture.pixels[place..place + 4].iter().copied()
        })
    });
    let pixels: Vec<u8> = pixels.collect();
    ColorImage::from_rgba_unmultiplied([width as usize, height as usize], &pixels)
}

/// Shows the picture with its marks, which a drag moves.
pub(super) fn show(
    ui: &mut Ui,
    studio: &mut Studio,
    picture: &Arc<Picture>,
    marks: &mut PhotoMarks,
) {
    let marking = studio.photo.marking;
    let ways = [
        (Marking::Repeat, studio.say(text::MARK_REPEAT)),
        (Marking::Ruler, studio.say(text::MARK_LENGTH)),
    ];
    let chosen = choice(ui, Some(marking), &ways);
    let how = match marking {
        Marking::Repeat => text::MARK_REPEAT_HOW,
        Marking::Ruler => text::MARK_LENGTH_HOW,
    };
    ui.label(RichText::new(studio.say(how)).small().weak());
    let texture = studio.photo.texture(ui.ctx(), picture);
    let [across, down] = picture.size_in_file.map(f64::from);
    let scale = (f64::from(ui.available_width()) / across).min(f64::from(HEIGHT) / down);
    #[expect(clippy::cast_possible_truncation, reason = "points of a window")]
    let size = vec2((across * scale) as f32, (down * scale) as f32);
    let (rect, response) = ui.allocate_exact_size(size, Sense::drag());
    let about = studio.say(text::OWN_PICTURE_MARKS);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, about));
    let painter = ui.painter_at(rect);
    let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    painter.image(texture.id(), rect, whole, Color32::WHITE);
    if response.drag_started() {
        studio.photo.start = response.interact_pointer_pos().map(|at| share(rect, at));
    }
    if let (Some(from), Some(at)) = (studio.photo.start, response.interact_pointer_pos()) {
        mark(marking, [from, share(rect, at)], [across, down], marks);
    }
    if response.drag_stopped() {
        studio.photo.start = None;
    }
    if let Some(repeat) = repeat_of(marks, [across, down]) {
        let corners = repeat.map(|corner| place(rect, corner));
        let frame = Rect::from_two_pos(corners[0], corners[1]);
        // A ruler lies anywhere on the photo.
        if marking == Marking::Repeat {
            shade_around(&painter, rect, frame);
        }
        paint_frame(&painter, frame);
    }
    if let Some(ruler) = ruler_of(marks, [across, down]) {
        paint_ruler(&painter, ruler.map(|end| place(rect, end)));
    }
    known_length(ui, studio, marks);
    if *marks != PhotoMarks::default() && wide_button(ui, studio.say(text::FORGET_MARKS)) {
        *marks = PhotoMarks::default();
    }
    studio.photo.marking = chosen.unwrap_or(marking);
}

/// Shade over what does not repeat.
fn shade_around(painter: &Painter, photo: Rect, frame: Rect) {
    let [left, right] = [photo.left(), photo.right()];
    for shaded in [
        Rect::from_min_max(photo.min, pos2(right, frame.top())),
        Rect::from_min_max(pos2(left, frame.bottom()), photo.max),
        Rect::from_min_max(pos2(left, frame.top()), frame.left_bottom()),
        Rect::from_min_max(frame.right_top(), pos2(right, frame.bottom())),
    ] {
        painter.rect_filled(shaded, 0.0, SHADE);
    }
}

fn paint_frame(painter: &Painter, frame: Rect) {
    for (width, color) in [(WIDTHS[1], EDGE), (WIDTHS[0], REPEAT_LINE)] {
        let stroke = Stroke::new(width, color);
        painter.rect_stroke(frame, 0.0, stroke, StrokeKind::Middle);
    }
}

fn paint_ruler(painter: &Painter, ends: [Pos2; 2]) {
    for (width, color) in [(WIDTHS[1], EDGE), (WIDTHS[0], RULER_LINE)] {
        painter.line_segment(ends, Stroke::new(width, color));
        for end in ends {
            painter.circle_stroke(end, 5.0, Stroke::new(width, color));
        }
    }
}

/// How long the marked line is on the cloth.
fn known_length(ui: &mut Ui, studio: &Studio, marks: &mut PhotoMarks) {
    let Some(length) = marks.known_length_cm else {
        return;
    };
    let (min, max) = range("print", "known_length_cm");
    let knob = Knob {
        name: studio.say(text::KNOWN_LENGTH),
        range: min.max(0.5)..=max.min(200.0),
        decimals: 1,
        unit: " cm",
        scale: Scale::Factors,
    };
    if let (_, Some(moved)) = knob.show(ui, length) {
        marks.known_length_cm = Some((moved * 10.0).round() / 10.0);
    }
}

/// Marks what lies between two places, in shares of a picture of a size [pixel of the file].
fn mark(marking: Marking, ends: [[f64; 2]; 2], size: [f64; 2], marks: &mut PhotoMarks) {
    let [from, to] = ends;
    let pixel = |axis: usize, share: f64| (share * size[axis]).round();
    let apart = [(from[0] - to[0]).abs(), (from[1] - to[1]).abs()];
    match marking {
        Marking::Repeat if LEAST_SHARE < apart[0].min(apart[1]) => {
            let [left, top] = [0, 1].map(|axis| pixel(axis, from[axis].min(to[axis])));
            let [right, low] = [0, 1].map(|axis| pixel(axis, from[axis].max(to[axis])));
            marks.crop_left_px = Some(left);
            marks.crop_top_px = Some(top);
            marks.crop_width_px = Some((right - left).max(1.0));
            marks.crop_height_px = Some((low - top).max(1.0));
        }
        Marking::Ruler if LEAST_SHARE < apart[0].max(apart[1]) => {
            marks.known_from_x_px = Some(pixel(0, from[0]));
            marks.known_from_y_px = Some(pixel(1, from[1]));
            marks.known_to_x_px = Some(pixel(0, to[0]));
            marks.known_to_y_px = Some(pixel(1, to[1]));
            marks.known_length_cm = Some(marks.known_length_cm.unwrap_or(USUAL_CM));
        }
        Marking::Repeat | Marking::Ruler => {}
    }
}

/// Upper left and lower right corner of the repeat, in shares of the picture, where it is marked.
fn repeat_of(marks: &PhotoMarks, [across, down]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let is_marked = [
        marks.crop_left_px,
        marks.crop_top_px,
        marks.crop_width_px,
        marks.crop_height_px,
    ];
    is_marked.iter().any(Option::is_some).then(|| {
        let [left, top] = [marks.crop_left_px, marks.crop_top_px].map(|at| at.unwrap_or(0.0));
        let right = marks.crop_width_px.map_or(across, |width| left + width);
        let low = marks.crop_height_px.map_or(down, |height| top + height);
        [[left / across, top / down], [right / across, low / down]]
    })
}

/// Both ends of the known length, in shares of the picture, where they are marked.
fn ruler_of(marks: &PhotoMarks, [across, down]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    Some([
        [
            marks.known_from_x_px? / across,
            marks.known_from_y_px? / down,
        ],
        [marks.known_to_x_px? / across, marks.known_to_y_px? / down],
    ])
}

fn share(rect: Rect, at: Pos2) -> [f64; 2] {
    let share = (at - rect.min) / rect.size();
    [share.x, share.y].map(|share| f64::from(share.clamp(0.0, 1.0)))
}

#[expect(clippy::cast_possible_truncation, reason = "points of a window")]
fn place(rect: Rect, [x, y]: [f64; 2]) -> Pos2 {
    rect.min + vec2(x as f32, y as f32) * rect.size()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_marks_the_repeat_whichever_way_it_goes() {
        let mut marks = PhotoMarks::default();
        let ends = [[0.75, 0.5], [0.25, 0.1]];
        mark(Marking::Repeat, ends, [400.0, 200.0], &mut marks);
        let crop = [
            marks.crop_left_px,
            marks.crop_top_px,
            marks.crop_width_px,
            marks.crop_height_px,
        ];
        assert_eq!(crop, [100.0, 20.0, 200.0, 80.0].map(Some));
        let drawn = repeat_of(&marks, [400.0, 200.0]);
        assert_eq!(drawn, Some([[0.25, 0.1], [0.75, 0.5]]));
    }

    #[test]
    fn a_line_along_a_ruler_is_ten_centimeters_until_told_otherwise() {
        let mut marks = PhotoMarks::default();
        let line = [[0.1, 0.5], [0.6, 0.5]];
        mark(Marking::Ruler, line, [1000.0, 500.0], &mut marks);
        assert_eq!(marks.known_length_cm, Some(10.0));
        assert_eq!(
            (marks.known_from_x_px, marks.known_to_x_px),
            (Some(100.0), Some(600.0))
        );
        marks.known_length_cm = Some(25.0);
        mark(Marking::Ruler, line, [1000.0, 500.0], &mut marks);
        assert_eq!(marks.known_length_cm, Some(25.0));
        assert_eq!(ruler_of(&marks, [1000.0, 500.0]), Some(line));
    }

    #[test]
    fn a_click_marks_nothing() {
        let mut marks = PhotoMarks::default();
        for marking in [Marking::Repeat, Marking::Ruler] {
            mark(
                marking,
                [[0.5, 0.5], [0.504, 0.502]],
                [900.0, 900.0],
                &mut marks,
            );
        }
        assert_eq!(marks, PhotoMarks::default());
    }

    #[test]
    fn a_large_picture_is_shown_smaller_and_whole() {
        let picture = Picture {
            size_in_file: [3000, 10],
            width: 3000,
            height: 10,
            pixels: [10, 20, 30, 255].repeat(30_000),
        };
        let shown = scaled_down(&picture);
        assert_eq!(shown.size, [1000, 4]);
        assert_eq!(shown.pixels[3999], Color32::from_rgb(10, 20, 30));
    }
}
