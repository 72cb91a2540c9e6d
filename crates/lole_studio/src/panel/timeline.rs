//! The choreography as a band of blocks, each as long as its counts.

use eframe::egui::{
    self, Align2, Color32, CornerRadius, Painter, Pos2, Rect, Response, RichText, ScrollArea,
    Sense, Stroke, StrokeKind, TextStyle, Ui, pos2, vec2,
};
use lole_body::Side;
use lole_costume::document::PartDesign;
use lole_stage::PartNow;

use super::choreography::{Edit, dancing_part};
use super::steps;
use crate::{Studio, look, text};

/// Height of the band [point].
const HEIGHT: f32 = 58.0;
/// Between blocks, and between a block's edge and its words [point].
const GAP: f32 = 2.0;
const INSET: f32 = 5.0;
/// Length of the arrow of where she faces [point].
const ARROW: f32 = 7.0;

/// Fills of the blocks, by the family of the step.
const FILLS: [Color32; 6] = [
    Color32::from_rgb(212, 230, 229),
    Color32::from_rgb(244, 226, 200),
    Color32::from_rgb(240, 214, 216),
    Color32::from_rgb(221, 231, 205),
    Color32::from_rgb(217, 220, 238),
    Color32::from_rgb(233, 220, 236),
];

/// What was done on the band.
#[derive(Default)]
pub(super) struct Timeline {
    /// To the list.
    pub(super) edit: Option<Edit>,
    /// The part whose settings are to be seen.
    pub(super) looked_at: Option<usize>,
    /// The part that is to be seen again as it was danced.
    pub(super) again: Option<usize>,
}

/// Shows the band, and what is done with the part that was chosen on it.
pub(super) fn show(ui: &mut Ui, studio: &Studio, parts: &[PartDesign]) -> Timeline {
    let mut done = Timeline::default();
    let id = ui.scope_id().with("chosen part");
    let dancing = dancing_part(studio);
    let clicked: Option<usize> = ui.data(|data| data.get_temp(id));
    let chosen = clicked.or(dancing.map(|part| part.index)).unwrap_or(0);
    let chosen = chosen.min(parts.len().saturating_sub(1));
    let band = |ui: &mut Ui| {
        let blocks = blocks(ui, parts);
        for (index, (part, block)) in parts.iter().zip(&blocks).enumerate() {
            let response = block_ui(ui, studio, (index, part), *block);
            paint(ui, studio, (index, part), *block);
            if index == chosen {
                let edge = Stroke::new(2.0, look::INK);
                let painter = ui.painter();
                painter.rect_stroke(*block, ROUND, edge, StrokeKind::Inside);
            }
            if response.clicked() {
                done.looked_at = Some(index);
            }
            if let Some(place) = dragged_to(ui, &response, (index, &blocks)) {
                done.edit = Some(Edit::Move(index, place));
            }
        }
        paint_now(ui.painter(), &blocks, dancing);
    };
    ScrollArea::horizontal().id_salt("timeline").show(ui, band);
    if let Some(index) = done.looked_at {
        ui.data_mut(|data| data.insert_temp(id, index));
    }
    ui.label(RichText::new(studio.say(text::TIMELINE_HOW)).small());
    ui.horizontal_wrapped(|ui| {
        if ui.button(studio.say(text::REPEAT_PART)).clicked() {
            done.edit = Some(Edit::Repeat(chosen));
        }
        if ui.button(studio.say(text::MIRROR_PARTS)).clicked() {
            done.edit = Some(Edit::Mirror);
        }
        let again = egui::Button::new(studio.say(text::SEE_PART_AGAIN));
        let was_danced = studio.take.of_part(chosen).is_some();
        if ui.add_enabled(was_danced, again).clicked() {
            done.again = Some(chosen);
        }
    });
    done
}

const ROUND: CornerRadius = CornerRadius::same(5);

/// Where the blocks lie: as long as their counts, and none narrower than a fingertip.
fn blocks(ui: &mut Ui, parts: &[PartDesign]) -> Vec<Rect> {
    let counts = |part: &PartDesign| {
        u16::try_from(part.beat_count)
            .map_or(1.0, f32::from)
            .max(1.0)
    };
    let all: f32 = parts.iter().map(counts).sum();
    let least = parts.iter().map(counts).fold(f32::INFINITY, f32::min);
    let scale = (ui.available_width() / all).max((look::TARGET + GAP) / least);
    let (band, _) = ui.allocate_exact_size(vec2(scale * all, HEIGHT), Sense::hover());
    let mut left = band.left();
    let blocks = parts.iter().map(|part| {
        let from = left;
        left += scale * counts(part);
        Rect::from_x_y_ranges(from..=(left - GAP), band.y_range())
    });
    blocks.collect()
}

/// A block that can be clicked and dragged.
fn block_ui(
    ui: &Ui,
    studio: &Studio,
    (index, part): (usize, &PartDesign),
    block: Rect,
) -> Response {
    let response = ui.interact(
        block,
        ui.scope_id().with(("part", index)),
        Sense::click_and_drag(),
    );
    let (step, counts) = (steps::name(part.step, studio.language), part.beat_count);
    let name = format!(
        "{}: {step}, {counts} {}",
        index + 1,
        studio.say(text::COUNTS)
    );
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
    response.on_hover_text(name)
}

/// The place that a block was dragged to; a line shows it on the way there.
fn dragged_to(ui: &Ui, response: &Response, (index, blocks): (usize, &[Rect])) -> Option<usize> {
    if !response.dragged() && !response.drag_stopped() {
        return None;
    }
    let pointer = response.interact_pointer_pos()?;
    let others = blocks
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != index);
    let place = others
        .filter(|(_, block)| block.center().x < pointer.x)
        .count();
    if response.drag_stopped() {
        return (place != index).then_some(place);
    }
    let edge = if place <= index {
        blocks[place].left() - 0.5 * GAP
    } else {
        blocks[place].right() + 0.5 * GAP
    };
    let line = Stroke::new(3.0, look::TEAL);
    ui.painter().vline(edge, response.rect.y_range(), line);
    ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
    None
}

/// What a block says: its number and step where there is room, its counts, its side, and where she faces.
fn paint(ui: &Ui, studio: &Studio, (index, part): (usize, &PartDesign), block: Rect) {
    let painter = ui.painter();
    let fill = FILLS[steps::family_of(part.step) % FILLS.len()];
    painter.rect_filled(block, ROUND, fill);
    let font = TextStyle::Small.resolve(ui.style());
    let room = block.width() - 2.0 * INSET;
    let write = |at: Pos2, align: Align2, words: String, room: f32| {
        let galley = painter.layout_no_wrap(words, font.clone(), look::INK);
        let fits = galley.size().x <= room;
        if fits {
            let corner = align.anchor_size(at, galley.size()).min;
            painter.galley(corner, galley, look::INK);
        }
        fits
    };
    let top = block.left_top() + vec2(INSET, INSET);
    let number = index + 1;
    let step = steps::name(part.step, studio.language);
    if !write(top, Align2::LEFT_TOP, format!("{number} {step}"), room) {
        write(top, Align2::LEFT_TOP, number.to_string(), room);
    }
    let bottom = block.left_bottom() + vec2(INSET, -INSET);
    let side = studio.say(match part.side {
        Side::Right => text::FROM_RIGHT,
        Side::Left => text::FROM_LEFT,
    });
    let room = room - 2.5 * ARROW;
    let counts = part.beat_count;
    let both = format!("{counts} {side}");
    if !write(bottom, Align2::LEFT_BOTTOM, both, room) {
        write(bottom, Align2::LEFT_BOTTOM, counts.to_string(), room);
    }
    let middle = block.right_bottom() - vec2(INSET + ARROW, INSET + ARROW);
    paint_facing(painter, middle, part.facing_deg);
}

/// Where she faces, as seen from above by who sits in front: the front is down.
fn paint_facing(painter: &Painter, middle: Pos2, degrees: f64) {
    let turn = lole_geom::narrow(degrees.to_radians());
    // Her left is on the right of who sits in front.
    let along = vec2(lole_geom::trig::sin(turn), lole_geom::trig::cos(turn));
    painter.arrow(
        middle - along * ARROW,
        along * (2.0 * ARROW),
        Stroke::new(1.5, look::INK),
    );
}

/// Where in the dance she is.
fn paint_now(painter: &Painter, blocks: &[Rect], now: Option<PartNow>) {
    let Some((block, now)) = now.and_then(|now| Some((blocks.get(now.index)?, now))) else {
        return;
    };
    let x = block.left() + now.share * block.width();
    painter.vline(x, block.y_range(), Stroke::new(2.0, look::RED));
    let tip = pos2(x, block.top() + 7.0);
    let corners = vec![tip, tip - vec2(5.0, 7.0), tip - vec2(-5.0, 7.0)];
    painter.add(egui::Shape::convex_polygon(
        corners,
        look::RED,
        Stroke::NONE,
    ));
}

#[cfg(test)]
mod tests {
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable as _;
    use lole_costume::document::Design;
    use lole_hula::DanceStep;
    use lole_language::Language;

    use super::super::tests::{click, window, wished};
    use super::*;
    use crate::studio::Tab;

    /// A window with a choreography of these steps and counts.
    fn danced(parts: &[(DanceStep, u32)]) -> Harness<'static, Studio> {
        let mut design = Design::default();
        let parts = parts.iter().map(|&(step, beat_count)| PartDesign {
            step,
            beat_count,
            ..PartDesign::default()
        });
        design.motion.parts = parts.collect();
        let mut studio = Studio::new(Language::English, design, None);
        studio.tab = Tab::Dance;
        window(studio)
    }

    fn block(window: &Harness<'static, Studio>, name: &str) -> Rect {
        window
            .get_by_role_and_label(egui::accesskit::Role::Button, name)
            .rect()
    }

    const THREE: [(DanceStep, u32); 3] = [
        (DanceStep::Kaholo, 16),
        (DanceStep::Kao, 8),
        (DanceStep::Ami, 8),
    ];
    /// What a block is called at a place of the list.
    fn named(place: usize, (step, counts): (DanceStep, u32)) -> String {
        format!("{place}: {}, {counts} counts", step.name())
    }

    #[test]
    fn blocks_are_as_long_as_their_counts_and_none_is_too_small_to_touch() {
        let window = danced(&THREE);
        let [first, second, third] =
            [1, 2, 3].map(|place| block(&window, &named(place, THREE[place - 1])));
        assert!((first.width() + GAP - 2.0 * (second.width() + GAP)).abs() < 1.0);
        assert!((second.right() + GAP - third.left()).abs() < 0.5);
        let many: Vec<_> = (0..40).map(|_| (DanceStep::Kao, 8)).collect();
        let window = danced(&many);
        assert!(look::TARGET - 0.5 <= block(&window, &named(2, many[1])).width());
    }

    #[test]
    fn a_block_is_dragged_to_another_place_and_back() {
        let mut window = danced(&THREE);
        let mut drag = |from: String, to: String| {
            let [from, to] = [from, to].map(|name| block(&window, &name));
            window.hover_at(from.center());
            window.drag_at(from.center());
            window.run_steps(2);
            for at in [
                from.center().lerp(to.center(), 0.5),
                to.right_center() - vec2(4.0, 0.0),
            ] {
                window.hover_at(at);
                window.run_steps(2);
            }
            window.drop_at(to.right_center() - vec2(4.0, 0.0));
            window.run_steps(3);
            let parts = wished(&mut window).motion.parts;
            parts.iter().map(|part| part.step).collect::<Vec<_>>()
        };
        let [kaholo, kao, ami] = THREE.map(|(step, _)| step);
        let [first, second, third] = THREE;
        let moved = drag(named(1, first), named(3, third));
        assert_eq!(moved, [kao, ami, kaholo]);
        let moved = drag(named(1, second), named(2, third));
        assert_eq!(moved, [ami, kao, kaholo]);
    }

    #[test]
    fn what_was_clicked_is_danced_once_more_and_all_is_mirrored() {
        let mut window = danced(&THREE);
        click(&mut window, &named(2, THREE[1]));
        click(&mut window, "Repeat the chosen part");
        let parts = wished(&mut window).motion.parts;
        let steps: Vec<DanceStep> = parts.iter().map(|part| part.step).collect();
        let [kaholo, kao, ami] = THREE.map(|(step, _)| step);
        assert_eq!(steps, [kaholo, kao, kao, ami]);
        click(&mut window, "Mirror left and right");
        let mirrored = wished(&mut window).motion.parts;
        assert!(std::iter::zip(parts, mirrored).all(|(was, now)| was.side != now.side));
    }
}
