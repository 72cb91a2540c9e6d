//! Where each piece lies on its cloth, with the print, how much to buy, and what to decide first.

use eframe::egui::{
    self, Align2, Color32, ColorImage, FontId, Painter, Pos2, Rect, RichText, Sense, Shape, Stroke,
    StrokeKind, TextureHandle, TextureOptions, Ui, Vec2, pos2, vec2,
};
use kurbo::Point;
use lole_costume::order::PlannedGarment;
use lole_costume::tailoring::{ClothPlan, role_name};
use lole_export::cutting::{lying_width, used_words};
use lole_geom::narrow;
use lole_language::{Language, Sentence};
use lole_pattern::Pattern;
use lole_pattern::marker::{Lay, Placed};
use lole_pattern::piece::ClothRole;
use lole_print::ClothPicture;

use super::cost::{fabric_mut, fabric_of};
use super::garment::width_ui;
use super::hindrance;
use super::knob::{choice, wide_button};
use crate::paper::PaperGarment;
use crate::{Studio, look, text};

/// Height of a plan in the column at most [point].
const HEIGHT: f32 = 220.0;
/// Room around the cloth for its measures [point].
const BORDER: f32 = 20.0;
/// Points of a meter from which on stitching lines are shown, too.
const DETAILED: f32 = 180.0;
/// Smallest letters that name a piece on its plan [point].
const SMALLEST: f32 = 10.0;

/// Pictures of cloth that the graphics adapter has, all of one paper.
#[derive(Default)]
pub(crate) struct ClothTextures {
    kept: Vec<(PlanKey, TextureHandle)>,
}

/// A plan among all that the window ever showed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct PlanKey {
    /// Number of its paper.
    paper: u64,
    /// Its garment on the paper, and the plan of the garment.
    garment: usize,
    plan: usize,
}

impl ClothTextures {
    /// The texture of a plan's cloth, made when it is first shown.
    fn of(
        &mut self,
        context: &egui::Context,
        key: PlanKey,
        picture: &ClothPicture,
    ) -> TextureHandle {
        self.kept.retain(|(kept, _)| kept.paper == key.paper);
        if let Some((_, texture)) = self.kept.iter().find(|(kept, _)| *kept == key) {
            return texture.clone();
        }
        let size = [picture.width as usize, picture.height as usize];
        let image = ColorImage::from_rgba_unmultiplied(size, &picture.pixels);
        let name = format!("cloth {} {}", key.garment, key.plan);
        let texture = context.load_texture(name, image, TextureOptions::LINEAR);
        self.kept.push((key, texture.clone()));
        texture
    }
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let lays = [
        (Lay::Single, studio.say(text::SINGLE)),
        (Lay::Folded, studio.say(text::FOLDED)),
    ];
    if let Some(lay) = choice(ui, Some(studio.cutting.lay), &lays) {
        studio.cutting.lay = lay;
    }
    let words = studio.say(text::MATCH_PRINT);
    ui.checkbox(&mut studio.cutting.matches_print, words);
    let Some(paper) = studio.paper.clone() else {
        ui.horizontal(|ui| {
            ui.spinner();
            ui.label(studio.say(text::DRAFTING));
        });
        return;
    };
    for (index, garment) in paper.garments.iter().enumerate() {
        ui.add_space(4.0);
        if 0 < index {
            ui.separator();
        }
        let name = RichText::new(studio.say(garment.name)).strong();
        ui.label(name.color(look::TEAL));
        match &garment.cut {
            Ok(cut) if cut.plans.is_empty() => {
                ui.label(studio.say(text::NO_CLOTH));
            }
            Ok(cut) => {
                let first = PlanKey {
                    paper: paper.number,
                    garment: index,
                    plan: 0,
                };
                ui.push_id(("cut", index), |ui| {
                    plans_ui(ui, studio, garment, first);
                    if cut.tailored.parts.is_some() {
                        ui.label(studio.say(text::JOINED));
                    }
                    for warning in &cut.tailored.pattern.warnings {
                        hindrance::sentence(ui, studio, warning);
                    }
                });
            }
            Err(trouble) => hindrance::sentence(ui, studio, &trouble.sentence),
        }
    }
}

/// The plans of a garment that is cut, from the `first` on, with the widths of its cloths.
fn plans_ui(ui: &mut Ui, studio: &mut Studio, garment: &PaperGarment, first: PlanKey) {
    let Ok(cut) = &garment.cut else { return };
    let place = garment.place;
    let fabric = fabric_of(studio.design(), place);
    let widths = fabric.map(|fabric| (fabric.width_cm, fabric.beside_width_cm));
    if let Some((own, _)) = widths
        && let Some(width) = width_ui(ui, studio, own)
    {
        studio.change_later(|design| fabric_mut(design, place).width_cm = width);
    }
    // All cloths beside the garment's own have one width, asked for once.
    let first_beside = (cut.plans.iter()).position(|plan| plan.role != ClothRole::Main);
    for (number, plan) in cut.plans.iter().enumerate() {
        if plan.role != ClothRole::Main {
            ui.label(studio.say(role_name(plan.role)));
            if let Some((own, beside)) = widths
                && first_beside == Some(number)
                && let Some(width) = width_ui(ui, studio, beside.unwrap_or(own))
            {
                studio.change_later(|design| {
                    fabric_mut(design, place).beside_width_cm = Some(width);
                });
            }
        }
        let key = PlanKey {
            plan: number,
            ..first
        };
        plan_ui(ui, studio, garment, key);
    }
}

/// One plan in the column, to be enlarged, with what it says.
fn plan_ui(ui: &mut Ui, studio: &mut Studio, garment: &PaperGarment, key: PlanKey) {
    let Some(drawing) = Drawing::of(ui, &mut studio.textures, garment, key) else {
        return;
    };
    let plan = drawing.plan;
    let size = drawing.size(vec2(ui.available_width(), HEIGHT));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    drawing.paint(ui.painter(), rect, studio);
    if response.on_hover_text(studio.say(text::LARGER)).clicked()
        || wide_button(ui, studio.say(text::LARGER))
    {
        studio.enlarged = Some((key.garment, key.plan));
    }
    ui.label(RichText::new(studio.tell(&facts(plan))).small());
    for warning in &plan.marker.warnings {
        hindrance::sentence(ui, studio, &Sentence::of(warning));
    }
}

/// What to buy, what it weighs and how well it is used.
fn facts(plan: &ClothPlan) -> Sentence {
    let marker = &plan.marker;
    let needed = marker.yardage.needed.to_cm();
    let (metric, yards) = (
        marker.yardage.metric.to_m(),
        marker.yardage.imperial.to_yd(),
    );
    let mass = plan.mass;
    let (japanese, english) = (
        used_words(plan, "、", Language::Japanese),
        used_words(plan, "; ", Language::English),
    );
    Sentence::new(
        format!(
            "用尺 {needed:.1} cm → {metric:.1} m（{yards:.1} ヤード）を買う。重さ {mass:.2} kg{japanese}。"
        ),
        format!(
            "Needs {needed:.1} cm: buy {metric:.1} m ({yards:.1} yd). Weighs {mass:.2} kg{english}."
        ),
    )
}

/// A plan over the dance, as large as there is room.
pub fn enlarged(ui: &mut Ui, studio: &mut Studio) {
    let (Some((index, number)), Some(paper)) = (studio.enlarged, studio.paper.clone()) else {
        return;
    };
    let garment = paper.garments.get(index);
    let key = PlanKey {
        paper: paper.number,
        garment: index,
        plan: number,
    };
    let drawing = garment.and_then(|it| Drawing::of(ui, &mut studio.textures, it, key));
    let (Some(garment), Some(drawing)) = (garment, drawing) else {
        studio.enlarged = None;
        return;
    };
    let screen = ui.ctx().content_rect();
    let room = vec2(screen.width() - 80.0, screen.height() - 190.0);
    let mut is_open = true;
    let title = format!(
        "{}: {}",
        studio.say(text::CUT_PLAN),
        studio.say(garment.name)
    );
    egui::Window::new(title)
        .id(egui::Id::unique("cut plan"))
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .show(ui.ctx(), |ui| {
            let size = drawing.size(room);
            let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
            drawing.paint(ui.painter(), rect, studio);
            ui.label(studio.tell(&facts(drawing.plan)));
            if ui.button(studio.say(text::CLOSE)).clicked() {
                is_open = false;
            }
        });
    if ui.input(|input| input.key_pressed(egui::Key::Escape)) {
        is_open = false;
    }
    if !is_open {
        studio.enlarged = None;
    }
}

/// A plan to be drawn.
struct Drawing<'a> {
    cut: &'a PlannedGarment,
    plan: &'a ClothPlan,
    texture: Option<TextureHandle>,
}

impl<'a> Drawing<'a> {
    /// A plan of a garment; `None` where it has no such plan.
    fn of(
        ui: &Ui,
        textures: &mut ClothTextures,
        garment: &'a PaperGarment,
        key: PlanKey,
    ) -> Option<Self> {
        let cut = garment.cut.as_ref().ok()?;
        let plan = cut.plans.get(key.plan)?;
        let picture = garment.pictures.get(key.plan).and_then(Option::as_ref);
        let texture = picture.map(|it| textures.of(ui.ctx(), key, it));
        Some(Self { cut, plan, texture })
    }

    /// Length and width of what is drawn [m]: pieces may reach over the selvage.
    fn extent(&self) -> [f32; 2] {
        let marker = &self.plan.marker;
        let reach = (marker.placed.iter()).map(|placed| placed.outline.bounds().y1);
        let across = reach.fold(lying_width(marker).to_m(), f64::max);
        [marker.yardage.needed.to_m().max(0.01), across].map(narrow)
    }

    /// As large as fits.
    fn size(&self, room: Vec2) -> Vec2 {
        let [length, across] = self.extent();
        let inner = room - Vec2::splat(2.0 * BORDER);
        let scale = (inner.x / length).min(inner.y / across);
        vec2(length, across) * scale + Vec2::splat(2.0 * BORDER)
    }

    fn paint(&self, painter: &Painter, rect: Rect, studio: &Studio) {
        let marker = &self.plan.marker;
        let [length, across] = self.extent();
        let scale = (rect.width() - 2.0 * BORDER) / length;
        let origin = pos2(rect.left() + BORDER, rect.top() + BORDER + across * scale);
        let at = |x: f64, y: f64| origin + vec2(narrow(x), -narrow(y)) * scale;
        let width = lying_width(marker).to_m();
        let cloth = Rect::from_two_pos(at(0.0, 0.0), at(marker.yardage.needed.to_m(), width));
        match &self.texture {
            Some(texture) => {
                let whole = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
                painter.image(texture.id(), cloth, whole, Color32::WHITE);
            }
            None => {
                painter.rect_filled(cloth, 0.0, Color32::from_rgb(246, 243, 236));
            }
        }
        let selvage = Stroke::new(1.5, look::PALE_INK);
        painter.rect_stroke(cloth, 0.0, selvage, StrokeKind::Middle);
        for placed in &marker.placed {
            let outline: Vec<Pos2> = (placed.outline.points.iter())
                .map(|point| at(point.x, point.y))
                .collect();
            let is_wide = width + 1e-4 < placed.outline.bounds().y1;
            let stroke = if is_wide {
                Stroke::new(2.5, look::RED)
            } else {
                Stroke::new(1.4, look::INK)
            };
            painter.add(Shape::closed_line(outline, stroke));
            if DETAILED <= scale {
                let page = |point: Point| at(point.x, point.y);
                inner_lines(painter, self.cut.tailored.cutting(), placed, page);
            }
            let bounds = placed.outline.bounds();
            let middle = at(0.5 * (bounds.x0 + bounds.x1), 0.5 * (bounds.y0 + bounds.y1));
            let room = narrow(bounds.x1 - bounds.x0) * scale;
            let piece = &self.cut.tailored.cutting().pieces[placed.piece];
            name_piece(painter, middle, room, studio.say(piece.name));
        }
        self.measures(painter, cloth, studio);
    }

    /// Length below and width beside the cloth.
    fn measures(&self, painter: &Painter, cloth: Rect, studio: &Studio) {
        let marker = &self.plan.marker;
        let font = FontId::proportional(13.0);
        let length = format!("{:.1} cm", marker.yardage.needed.to_cm());
        let below = cloth.center_bottom() + vec2(0.0, 10.0);
        painter.text(
            below,
            Align2::CENTER_CENTER,
            length,
            font.clone(),
            look::INK,
        );
        let across = format!("{:.0} cm", lying_width(marker).to_cm());
        let galley = painter.layout_no_wrap(across, font.clone(), look::INK);
        let beside = pos2(
            cloth.left() - 4.0 - galley.size().y,
            cloth.center().y + 0.5 * galley.size().x,
        );
        painter.add(egui::epaint::TextShape {
            angle: -std::f32::consts::FRAC_PI_2,
            ..egui::epaint::TextShape::new(beside, galley, look::INK)
        });
        let lower = match (marker.cloth.lay, marker.cloth.border.is_some()) {
            (Lay::Folded, _) => text::FOLD_OF_CLOTH,
            (Lay::Single, true) => text::BORDER_SELVAGE,
            (Lay::Single, false) => text::SELVAGE,
        };
        let at = cloth.left_bottom() + vec2(0.0, 10.0);
        let small = FontId::proportional(11.0);
        let lower = studio.say(lower);
        painter.text(at, Align2::LEFT_CENTER, lower, small, look::PALE_INK);
    }
}

/// Stitching lines, marks and the grain of a laid piece.
fn inner_lines(
    painter: &Painter,
    pattern: &Pattern,
    placed: &Placed,
    page: impl Fn(Point) -> Pos2,
) {
    let piece = &pattern.pieces[placed.piece];
    let shown = if placed.is_on_fold {
        piece.clone()
    } else {
        piece.unfolded()
    };
    let drawing = shown.drawing(TOLERANCE);
    let thin = Stroke::new(0.8, look::INK);
    let on_page = |point: &Point| page(placed.cloth_from_piece * *point);
    let stitches = drawing.stitches.iter().map(|stitches| &stitches.points);
    let marks = drawing.lines.iter().map(|marked| &marked.points);
    for points in stitches.chain(marks) {
        let points = points.iter().map(on_page).collect();
        painter.add(Shape::line(points, thin));
    }
    let [tail, head] = drawing.grain.map(|end| on_page(&end));
    painter.arrow(tail, head - tail, Stroke::new(1.2, look::INK));
}

/// Curves are drawn this finely [m].
const TOLERANCE: f64 = 1e-3;

/// The name of a piece on a white plate, as large as fits; none where it could not be read.
fn name_piece(painter: &Painter, middle: Pos2, room: f32, name: &str) {
    let natural = painter.layout_no_wrap(name.to_owned(), FontId::proportional(14.0), look::INK);
    let size = (14.0 * 0.9 * room / natural.size().x.max(1.0)).min(14.0);
    if size < SMALLEST {
        return;
    }
    let galley = painter.layout_no_wrap(name.to_owned(), FontId::proportional(size), look::INK);
    let plate = Rect::from_center_size(middle, galley.size() + vec2(8.0, 4.0));
    painter.rect_filled(plate, 4.0, Color32::from_white_alpha(230));
    painter.galley(plate.min + vec2(4.0, 2.0), galley, look::INK);
}
