//! The picture: its texture, the camera under the mouse, the hand on the cloth.

use std::sync::Arc;

use eframe::egui::{self, Color32, PointerButton, Rect, Response, Sense, Ui};
use eframe::egui_wgpu::RenderState;
use glam::{Vec2, Vec3};
use lole_geom::trig;
use lole_language::Sentence;
use lole_picture::{DrawnDancer, Scenery};
use lole_render::{Bounds, Effort, Image, LiveView, Material, RenderError, Size, View, wgpu};
use lole_stage::Pull;

use crate::clock::Clock;
use crate::companion::Companion;
use crate::light::Job;
use crate::look::strain_color;
use crate::message::Message;
use crate::orbit::{Orbit, hand_at, pick};
use crate::overlay::Strokes;
use crate::platform::{self, Light};
use crate::studio::{Shows, Tool};
use crate::take::Take;
use crate::{Command, Snapshot, Studio};

/// Room to each side of the dancer that the views show [m]: she steps to both sides.
const SIDE_ROOM: f32 = 0.62;
/// Where the kept dance is beside the one on stage [m]: neither arm meets the other.
const BESIDE_WAY: Vec3 = Vec3::new(1.7, 0.0, 0.0);
/// How quickly the camera goes with her [1/s]: softly, as a hand would.
const FOLLOW_RATE: f32 = 1.6;
/// The longest time between two pictures that the camera makes up for [s].
const LONGEST_PICTURE: f32 = 0.25;
/// A way that is not worth following [m].
const STILL: f32 = 2.0e-3;
/// Nearness for each point of the wheel: one notch of 50 points comes nearer by a tenth.
const ZOOM_BASE: f32 = 1.002;
/// The pointer takes hold of cloth this near [point].
const GRASP: f32 = 14.0;
/// Pictures are counted over this time [s].
const COUNTED: f64 = 1.0;

/// Pixels of the picture for each of the screen's where the processor draws them.
const SOFTWARE_SCALE: f32 = 0.75;

/// What the picture keeps.
pub(crate) struct Viewport {
    /// The picture of a dance, and the finer one of what stands still, for drivers that compute on
    /// the processor; others have the first alone.
    lives: [Option<Live>; 2],
    light: Light,
    hold: Option<Hold>,
    drawn: Option<Drawn>,
    clock: Clock,
    counted_from: f64,
    pictures: u32,
    strain_cloth: Material,
    aspect: f32,
    /// Whether the adapter is a driver that computes on the processor.
    is_software: bool,
    /// Of the present picture.
    quality: Quality,
    /// How far the camera went with her over the floor [m].
    drift: Vec3,
    followed_at: f64,
    /// Who dances beside her, of which take and at which time of it [s].
    beside: Option<(Arc<Take>, f32, Companion)>,
}

/// What is on the adapter.
struct Live {
    view: LiveView,
    texture: egui::TextureId,
    wardrobe: u64,
    is_lit: bool,
}

impl Live {
    /// Takes up a wardrobe; the light of another one is none for it.
    const fn wear(&mut self, wardrobe: u64) {
        if self.wardrobe != wardrobe {
            self.wardrobe = wardrobe;
            self.is_lit = false;
        }
    }
}

/// A hand on the cloth.
struct Hold {
    particle: u32,
    /// The plane in which the hand moves goes through this point [m].
    anchor: Vec3,
}

/// What the last picture showed: another one is drawn only where something differs.
#[derive(Clone, PartialEq)]
struct Drawn {
    snapshot: *const Snapshot,
    /// Another moment may lie where one was.
    time: f32,
    /// Who is seen.
    together: u64,
    orbit: Orbit,
    scenery: Scenery,
    size: (u32, u32),
    shows: Shows,
    quality: Quality,
}

/// How much work a picture may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Quality {
    /// What a driver on the processor can do while she dances.
    Quick,
    /// What the machine can do.
    Fine,
}

impl Viewport {
    pub(crate) fn new() -> Self {
        let clock = Clock::start();
        Self {
            lives: [None, None],
            light: Light::start(),
            hold: None,
            drawn: None,
            clock,
            counted_from: clock.seconds(),
            pictures: 0,
            strain_cloth: Material {
                specular: 0.0,
                sheen: 0.1,
                ..Material::cloth([1.0; 3])
            },
            aspect: 1.0,
            is_software: false,
            quality: Quality::Fine,
            drift: Vec3::ZERO,
            followed_at: clock.seconds(),
            beside: None,
        }
    }

    /// Shows the picture in all of `ui`.
    pub(crate) fn show(&mut self, ui: &mut Ui, studio: &mut Studio, gpu: Option<&RenderState>) {
        let (area, response) = ui.allocate_exact_size(
            ui.available_size().max(egui::Vec2::splat(1.0)),
            Sense::drag(),
        );
        let scale = ui.ctx().pixels_per_point();
        self.aspect = (area.width() / area.height().max(1.0)).clamp(0.02, 50.0);
        let Some(snapshot) = studio.snapshot.clone() else {
            return;
        };
        self.place_camera(studio, &snapshot);
        if self.follow_dancer(&snapshot) {
            ui.ctx().request_repaint();
        }
        self.follow_pointer(ui, studio, area, &response);
        let Some(gpu) = gpu else { return };
        self.is_software = gpu.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        let moves = studio.moves() || ui.input(|input| input.pointer.any_down());
        self.quality = if self.is_software && moves {
            Quality::Quick
        } else {
            Quality::Fine
        };
        let scale = if self.quality == Quality::Quick {
            scale * SOFTWARE_SCALE
        } else {
            scale
        };
        let raster = Raster::over(area, scale);
        if let Err(error) = self.draw(studio, &snapshot, gpu, raster) {
            let text = error.to_string();
            let sentence = Sentence::new(format!("画面に描けません（{text}）"), text);
            studio.message = Some(Message::trouble(&sentence));
        }
        if let Some(live) = self.live() {
            let whole = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter()
                .image(live.texture, area, whole, Color32::WHITE);
            if !live.is_lit {
                ui.ctx().request_repaint_after_secs(0.1);
            }
        }
        self.count(studio);
    }

    /// Frames the dancer where that was asked for, or where nobody moved the camera since.
    fn place_camera(&self, studio: &mut Studio, snapshot: &Snapshot) {
        let view = match (studio.wanted_view.take(), studio.orbit) {
            (Some(view), _) => view,
            (None, Some(orbit)) => match orbit.view {
                Some(view) => view,
                None => return,
            },
            (None, None) => View::Front,
        };
        let mut stage = stage_of(snapshot);
        if studio.kept.is_some() {
            stage.max += BESIDE_WAY;
        }
        studio.orbit = Some(Orbit::framing(stage, view, self.aspect));
    }

    /// What shows the present picture.
    const fn live(&self) -> Option<&Live> {
        self.lives[self.quality as usize].as_ref()
    }

    /// Whether the skirt is drawn in fewer triangles; its springs lie on the fine ones.
    const fn is_coarse(&self, shows: Shows) -> bool {
        matches!(self.quality, Quality::Quick) && !shows.springs
    }

    /// Goes with her over the floor; whether the camera is still on its way.
    fn follow_dancer(&mut self, snapshot: &Snapshot) -> bool {
        let now = self.clock.seconds();
        #[expect(clippy::cast_possible_truncation, reason = "a fraction of a second")]
        let dt = ((now - self.followed_at) as f32).min(LONGEST_PICTURE);
        self.followed_at = now;
        let hips = snapshot.bones.first().map_or(Vec3::ZERO, |&[hips, _]| hips);
        let way = Vec3::new(hips.x, 0.0, hips.z) - self.drift;
        if way.length() < STILL {
            return false;
        }
        self.drift += way * (FOLLOW_RATE * dt).min(1.0);
        true
    }

    /// The camera where it stands now.
    fn standing(&self, orbit: &Orbit) -> Orbit {
        Orbit {
            target: orbit.target + self.drift,
            ..*orbit
        }
    }

    fn follow_pointer(&mut self, ui: &Ui, studio: &mut Studio, area: Rect, response: &Response) {
        let Some(mut orbit) = studio.orbit else {
            return;
        };
        let height = area.height().max(1.0);
        let drag = drag_of(ui, response) / height;
        let shift = ui.input(|input| input.modifiers.shift);
        let is_taken = response.drag_started_by(PointerButton::Primary) && !shift;
        if is_taken
            && studio.tool == Tool::Hold
            && studio.replay.is_none()
            && let Some(snapshot) = &studio.snapshot
        {
            self.take_hold(ui, &self.standing(&orbit), snapshot, area);
        }
        if self.hold.is_some() {
            self.move_hand(ui, studio, &self.standing(&orbit), area);
        } else if response.dragged_by(PointerButton::Primary) && !shift {
            orbit.turn(drag);
        } else if response.dragged() {
            orbit.pan(drag);
        }
        if response.hovered() {
            zoom(ui, &mut orbit);
        }
        if studio.orbit != Some(orbit) {
            studio.orbit = Some(orbit);
        }
    }

    fn take_hold(&mut self, ui: &Ui, orbit: &Orbit, snapshot: &Snapshot, area: Rect) {
        let Some(at) = ui.input(|input| input.pointer.press_origin()) else {
            return;
        };
        let ray = self.ray_at(orbit, area, at);
        let reach = orbit.vertical_fov * GRASP / area.height().max(1.0);
        let eye = orbit.camera().eye;
        self.hold = pick(&snapshot.particles, eye, ray, reach).map(|particle| Hold {
            particle,
            anchor: snapshot.particles[particle as usize],
        });
    }

    fn move_hand(&mut self, ui: &Ui, studio: &mut Studio, orbit: &Orbit, area: Rect) {
        let pointer = ui.input(|input| {
            input
                .pointer
                .primary_down()
                .then(|| input.pointer.latest_pos())
                .flatten()
        });
        let pull = match (&self.hold, pointer) {
            (Some(hold), Some(at)) => {
                let ray = self.ray_at(orbit, area, at);
                Some(Pull {
                    particle: hold.particle,
                    hand: hand_at(orbit, ray, hold.anchor),
                })
            }
            _ => None,
        };
        if pull.is_none() {
            self.hold = None;
        }
        studio.command(Command::Pull(pull));
    }

    fn ray_at(&self, orbit: &Orbit, area: Rect, at: egui::Pos2) -> Vec3 {
        let place = Vec2::new(
            (at.x - area.left()) / area.width().max(1.0) * 2.0 - 1.0,
            1.0 - (at.y - area.top()) / area.height().max(1.0) * 2.0,
        );
        orbit.ray(place, self.aspect)
    }

    fn draw(
        &mut self,
        studio: &Studio,
        snapshot: &Arc<Snapshot>,
        gpu: &RenderState,
        Raster { size, scale }: Raster,
    ) -> Result<(), RenderError> {
        let Some(orbit) = studio.orbit.map(|orbit| self.standing(&orbit)) else {
            return Ok(());
        };
        let is_new_light = self.take_light();
        let scenery = studio.scenery(snapshot);
        self.bring_beside(studio, snapshot.time);
        let beside = self.beside.as_ref().map(|(_, _, companion)| companion);
        self.light.offer(Job {
            snapshot: Arc::clone(snapshot),
            camera: orbit.camera(),
            scenery,
            is_coarse: self.is_coarse(studio.shows),
            beside: beside.cloned(),
        });
        let drawn = Drawn {
            snapshot: Arc::as_ptr(snapshot),
            time: snapshot.time,
            together: Companion::together(beside, &snapshot.wardrobe),
            orbit,
            scenery,
            size: (size.width, size.height),
            shows: studio.shows,
            quality: self.quality,
        };
        if self.drawn.as_ref() == Some(&drawn) && !is_new_light {
            return Ok(());
        }
        self.prepare(gpu, size)?;
        let is_coarse = self.is_coarse(studio.shows);
        let Some(live) = &mut self.lives[self.quality as usize] else {
            return Ok(());
        };
        live.wear(drawn.together);
        let reach = trig::tan(orbit.vertical_fov * 0.5);
        let meters_per_pixel = 2.0 * reach * orbit.distance / size.height as f32;
        let strokes = Strokes::of(snapshot, studio.shows, meters_per_pixel, scale);
        let colors = cloth_colors(snapshot, studio.shows);
        let figure = DrawnDancer {
            colors: &colors,
            colored: Some(&self.strain_cloth),
            ..snapshot.moment.dancer()
        };
        let wardrobe = &snapshot.wardrobe;
        let camera = orbit.camera();
        let beside = self.beside.as_ref().map(|(_, _, companion)| companion);
        let mut scene = Companion::scene(beside, (wardrobe, figure), (scenery, camera));
        if is_coarse {
            wardrobe.coarsen(&mut scene);
        }
        live.view.draw(&scene, strokes.overlay())?;
        platform::note("drawn");
        self.pictures += 1;
        self.drawn = Some(drawn);
        Ok(())
    }

    /// Brings the kept dance to where the one on stage is.
    fn bring_beside(&mut self, studio: &Studio, time: f32) {
        let wanted = studio.kept.clone().zip(studio.kept_time(time));
        let Some((take, time)) = wanted else {
            self.beside = None;
            return;
        };
        let is_there = |(of, at, _): &(Arc<Take>, f32, Companion)| {
            Arc::ptr_eq(of, &take) && at.to_bits() == time.to_bits()
        };
        if self.beside.as_ref().is_some_and(is_there) {
            return;
        }
        self.beside = take.at(time).map(|shown| {
            let companion = Companion {
                wardrobe: shown.wardrobe,
                moment: Arc::new(shown.moment.moved(BESIDE_WAY)),
            };
            (take, time, companion)
        });
    }

    /// A view of this size on the window's device.
    fn prepare(&mut self, gpu: &RenderState, size: Size) -> Result<(), RenderError> {
        let filter = wgpu::FilterMode::Linear;
        let quality = self.quality;
        match &mut self.lives[quality as usize] {
            free @ None => {
                let effort = match quality {
                    Quality::Quick => Effort::Light,
                    Quality::Fine => Effort::Full,
                };
                let view = LiveView::new(&gpu.device, &gpu.queue, size, effort)?;
                let mut renderer = gpu.renderer.write();
                let texture = renderer.register_native_texture(&gpu.device, view.shown(), filter);
                *free = Some(Live {
                    view,
                    texture,
                    wardrobe: 0,
                    is_lit: false,
                });
            }
            Some(live) if live.view.size() != size => {
                live.view.resize(size)?;
                gpu.renderer.write().update_egui_texture_from_wgpu_texture(
                    &gpu.device,
                    live.view.shown(),
                    filter,
                    live.texture,
                );
            }
            Some(_) => {}
        }
        Ok(())
    }

    fn take_light(&mut self) -> bool {
        let live = &mut self.lives[self.quality as usize];
        let (Some(live), Some((wardrobe, light))) = (live, self.light.take()) else {
            return false;
        };
        if wardrobe == live.wardrobe {
            live.is_lit |= live.view.light_up(&light);
        }
        true
    }

    fn count(&mut self, studio: &mut Studio) {
        let now = self.clock.seconds();
        let elapsed = now - self.counted_from;
        if COUNTED <= elapsed {
            studio.pictures_per_second =
                (0 < self.pictures).then(|| f64::from(self.pictures) / elapsed);
            self.pictures = 0;
            self.counted_from = now;
        }
    }

    /// The picture as it is shown, overlays and all.
    pub(crate) fn picture(&self) -> Option<Result<Image, RenderError>> {
        self.live().map(|live| live.view.read_back())
    }
}

/// How far the pointer was dragged since the last picture [point]. In the picture in which it was
/// pressed, the way before that does not count.
fn drag_of(ui: &Ui, response: &Response) -> Vec2 {
    let delta = if response.drag_started() {
        ui.input(|input| {
            let pressed = input.pointer.press_origin();
            let now = input.pointer.latest_pos();
            pressed.zip(now).map(|(pressed, now)| now - pressed)
        })
        .unwrap_or_default()
    } else {
        response.drag_delta()
    };
    Vec2::new(delta.x, delta.y)
}

/// Where she stands and steps [m].
fn stage_of(snapshot: &Snapshot) -> Bounds {
    let crown = snapshot.wardrobe.crown_height;
    Bounds {
        min: Vec3::new(-SIDE_ROOM, -0.02, -0.3),
        max: Vec3::new(SIDE_ROOM, crown + 0.06, 0.3),
    }
}

/// Colors of the vertices of everything that is worn by its strain, or of cloth plain under its springs; empty
/// where it shows what it is made of.
fn cloth_colors(snapshot: &Snapshot, shows: Shows) -> Vec<Vec<Vec3>> {
    let strain = snapshot.strain.iter().map(|&strain| strain_color(strain));
    let strain: Vec<Vec3> = strain.collect();
    let wardrobe = &snapshot.wardrobe;
    let surfaces = wardrobe.looks.worn.iter().zip(&wardrobe.particle_of_vertex);
    let colors = surfaces.zip(&snapshot.moment.worn);
    let colors = colors.map(|((cover, particles), [positions, _])| {
        let by_strain = |&particle: &u32| strain.get(particle as usize).copied();
        let by_strain: Vec<Vec3> = particles.iter().filter_map(by_strain).collect();
        if shows.strain && !by_strain.is_empty() {
            by_strain
        } else if shows.springs && cover.is_cloth {
            vec![strain_color(0.0); positions.len()]
        } else {
            Vec::new()
        }
    });
    colors.collect()
}

/// Comes nearer or goes farther with the wheel and with two fingers.
fn zoom(ui: &Ui, orbit: &mut Orbit) {
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    if scroll != 0.0 {
        orbit.zoom(trig::powf(ZOOM_BASE, scroll));
    }
    #[expect(clippy::float_cmp, reason = "exactly 1 where nothing was pinched")]
    if pinch != 1.0 {
        orbit.zoom(pinch);
    }
}

/// The pixels of a picture in the window.
#[derive(Clone, Copy)]
struct Raster {
    size: Size,
    /// Pixels of a point.
    scale: f32,
}

impl Raster {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a window's side in pixels, at least 1"
    )]
    fn over(area: Rect, scale: f32) -> Self {
        let side = |points: f32| (points * scale).round().clamp(1.0, 8192.0) as u32;
        Self {
            size: Size::new(side(area.width()), side(area.height())),
            scale,
        }
    }
}
