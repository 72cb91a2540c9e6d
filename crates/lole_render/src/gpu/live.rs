//! Pictures for a window: a scene drawn again and again on a device that somebody else opened,
//! into a texture that somebody else shows.
//!
//! The formula is that of the stills. What stills work out for each picture on the processor is
//! cheaper here: the key light's map and the floor's light are drawn by the adapter, and the light
//! of the room ([`AmbientLight`]) is worked out now and then, on any thread, and faded in.

mod budget;
mod meshes;
mod pipelines;

pub use budget::{LivePass, PassCost};

use super::device::Device;
use super::draw::{check_side, checked, extent, view_entry};
use super::paints::{Kept, PaintViews};
use super::pipeline::{COLOR, DEPTH};
use crate::bake::{ambient_alone, room_on_floor, unit_toward};
use crate::frame::{Frame, GroundPlace, Places};
use crate::prepare::Geometry;
use crate::{Bounds, Image, RenderError, Scene, Size};
use glam::{Vec2, Vec3, Vec4};
use meshes::{FADE_ROUNDS, LiveMeshes};
use pipelines::{FLOOR, LIVE_COLOR, LivePipelines};

/// How much work a picture may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// For graphics hardware: four samples a pixel, all shadows anew in each picture.
    Full,
    /// For a driver that computes on the processor: one sample, a coarser key light's map, and the
    /// floor's light anew in every fourth picture.
    Light,
}

impl Effort {
    /// Samples a pixel.
    const fn samples(self) -> u32 {
        match self {
            Self::Full => 4,
            Self::Light => 1,
        }
    }

    /// Side of the key light's map [texel]: 2 to 3 mm on a dancer, or 4 to 6.
    const fn key_side(self) -> u32 {
        match self {
            Self::Full => 1024,
            Self::Light => 512,
        }
    }

    /// Taps of the key light's map at each point; odd.
    const fn key_taps(self) -> f32 {
        match self {
            Self::Full => 11.0,
            Self::Light => 5.0,
        }
    }

    /// Pictures for which the floor's light stays.
    const fn floor_interval(self) -> u32 {
        match self {
            Self::Full => 1,
            Self::Light => 4,
        }
    }
}

/// Side of the floor's light and of the map from below [texel]; also in `live.wgsl`.
const FLOOR_CELLS: u32 = 256;
/// Side of the lit floor [m].
const FLOOR_SIDE: f32 = 5.0;
/// The key light's map covers a ball around everything, whose radius grows in steps of this [m]: a
/// texel that keeps its size keeps shadows calm.
const REACH_STEP: f32 = 0.25;
/// Bytes of one line in its buffer.
const STROKE_BYTES: u64 = 32;

/// A line or, where both ends are the same, a dot over the picture.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct OverlayLine {
    /// Where it starts [m].
    pub from: Vec3,
    /// Where it ends [m].
    pub to: Vec3,
    /// sRGB and opacity.
    pub color: [u8; 4],
    /// Width [pixel].
    pub width: f32,
}

/// What is drawn over the meshes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Overlay<'a> {
    /// Lines on surfaces: hidden by what is before them.
    pub on_surfaces: &'a [OverlayLine],
    /// Lines that shine through everything.
    pub through: &'a [OverlayLine],
}

/// Light of the room by vertex of a scene's meshes: on the face and on the back.
#[derive(Debug, Clone, PartialEq)]
pub struct AmbientLight(Vec<[Vec3; 2]>);

impl AmbientLight {
    /// Works it out on the processor, for the meshes and lights of `scene`.
    ///
    /// # Errors
    /// Where the scene holds a number that is not finite, or an index out of range.
    pub fn of(scene: &Scene<'_>) -> Result<Self, RenderError> {
        scene.check()?;
        let geometry = Geometry::of(scene);
        Ok(Self(ambient_alone(&scene.lights, &geometry)))
    }

    /// Light on the face and on the back of each vertex, linear, in the order of the scene's meshes.
    #[must_use]
    pub fn faces(&self) -> &[[Vec3; 2]] {
        &self.0
    }

    /// The light whose [`Self::faces`] these are.
    #[must_use]
    pub const fn from_faces(faces: Vec<[Vec3; 2]>) -> Self {
        Self(faces)
    }
}

/// Constants of the floor's light (`FloorLight` in `live.wgsl`).
#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct FloorLight {
    room: Vec4,
    key: Vec4,
}

/// A picture that is drawn again and again.
pub struct LiveView {
    gpu: Device,
    effort: Effort,
    /// Pictures until the floor's light is drawn again.
    floor_due: u32,
    pipelines: LivePipelines,
    targets: Targets,
    shared: Shared,
    meshes: Option<LiveMeshes>,
    has_light: bool,
    strokes: Option<wgpu::Buffer>,
    paints: PaintViews,
    /// Group 0 of the picture, with these paints.
    frame_group: wgpu::BindGroup,
}

/// What is drawn into.
struct Targets {
    size: Size,
    /// Samples of the picture; `None` where there is one a pixel.
    samples: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
    picture: wgpu::Texture,
    drawn: wgpu::TextureView,
    shown: wgpu::TextureView,
}

/// What does not depend on the picture's size.
struct Shared {
    frame: wgpu::Buffer,
    floor_light: wgpu::Buffer,
    key_map: wgpu::TextureView,
    under_map: wgpu::TextureView,
    floor: wgpu::TextureView,
    caster_group: wgpu::BindGroup,
    floor_group: wgpu::BindGroup,
    key_sampler: wgpu::Sampler,
}

impl LiveView {
    /// Pictures of `size` by `device`.
    ///
    /// # Errors
    /// [`RenderError`] where the device refuses.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        size: Size,
        effort: Effort,
    ) -> Result<Self, RenderError> {
        let gpu = Device {
            device: device.clone(),
            queue: queue.clone(),
            description: "the window's adapter".to_owned(),
            is_software: false,
        };
        Self::on(gpu, size, effort)
    }

    /// Pictures of `size` by an adapter of its own, without a window.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`] where there is none, [`RenderError`] where it refuses.
    pub fn alone(size: Size, effort: Effort) -> Result<Self, RenderError> {
        Self::on(Device::open()?, size, effort)
    }

    fn on(gpu: Device, size: Size, effort: Effort) -> Result<Self, RenderError> {
        size.check()?;
        check_side(&gpu, size)?;
        let device = &gpu.device;
        let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipelines = LivePipelines::new(device, effort.samples());
        let targets = Targets::new(device, size, effort.samples());
        let shared = Shared::new(device, &pipelines, effort.key_side());
        let paints = PaintViews::new(&gpu);
        let frame_group = shared.frame_group(device, &pipelines, &paints);
        checked(scope, "setting up")?;
        Ok(Self {
            gpu,
            effort,
            floor_due: 0,
            pipelines,
            targets,
            shared,
            meshes: None,
            has_light: false,
            strokes: None,
            paints,
            frame_group,
        })
    }

    /// The adapter's name.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.gpu.description
    }

    /// Size of the pictures.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.targets.size
    }

    /// Draws pictures of `size` from now on, into a new texture.
    ///
    /// # Errors
    /// Where the adapter has no room for it; the size then stays as it was.
    pub fn resize(&mut self, size: Size) -> Result<(), RenderError> {
        size.check()?;
        check_side(&self.gpu, size)?;
        let scope = (self.gpu.device).push_error_scope(wgpu::ErrorFilter::Validation);
        let targets = Targets::new(&self.gpu.device, size, self.effort.samples());
        checked(scope, "resizing")?;
        self.targets = targets;
        Ok(())
    }

    /// The picture to be shown: its bytes are sRGB-encoded, and reading gives them as they are.
    #[must_use]
    pub const fn shown(&self) -> &wgpu::TextureView {
        &self.targets.shown
    }

    /// Fades to a light that was worked out for these meshes; one of other meshes is ignored.
    /// Whether it fits.
    pub fn light_up(&mut self, light: &AmbientLight) -> bool {
        let Some(meshes) = &mut self.meshes else {
            return false;
        };
        let fits = light.0.len() == meshes.vertex_count();
        if fits {
            let rounds = if self.has_light { FADE_ROUNDS } else { 1 };
            meshes.light_up(&light.0, rounds);
            self.has_light = true;
        }
        fits
    }

    /// Draws a scene and lines over it. Meshes that are the last scene's, moved, are quickest.
    ///
    /// # Errors
    /// Where the scene holds a number that is not finite, an index out of range or a camera that
    /// cannot look; where the adapter refuses.
    pub fn draw(&mut self, scene: &Scene<'_>, overlay: Overlay<'_>) -> Result<(), RenderError> {
        scene.check()?;
        let scope = (self.gpu.device).push_error_scope(wgpu::ErrorFilter::Validation);
        self.write(scene, overlay);
        let mut encoder =
            (self.gpu.device).create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        for pass in self.passes_due() {
            self.encode(pass, &mut encoder, overlay);
        }
        self.gpu.queue.submit([encoder.finish()]);
        checked(scope, "drawing")
    }

    /// Writes what the passes of a checked scene read.
    fn write(&mut self, scene: &Scene<'_>, overlay: Overlay<'_>) {
        if !self.meshes.as_ref().is_some_and(|meshes| meshes.fit(scene)) {
            self.meshes = Some(LiveMeshes::new(&self.gpu, &self.pipelines, scene));
            self.has_light = false;
        }
        if let Some(meshes) = &mut self.meshes {
            meshes.write(&self.gpu, &self.pipelines, scene);
        }
        if self.paints.upload(&self.gpu, &scene.background) == Kept::Changed {
            let device = &self.gpu.device;
            self.frame_group = (self.shared).frame_group(device, &self.pipelines, &self.paints);
        }
        self.write_frame(scene);
        self.write_strokes(overlay);
    }

    /// Passes of the next picture, in their order: the floor's light stays for some pictures.
    fn passes_due(&mut self) -> Vec<LivePass> {
        let draws_floor = self.floor_due == 0;
        self.floor_due = if draws_floor {
            self.effort.floor_interval() - 1
        } else {
            self.floor_due - 1
        };
        let every = LivePass::DRAWN.into_iter();
        every
            .filter(|pass| draws_floor || !pass.is_of_the_floor())
            .collect()
    }

    fn encode(&self, pass: LivePass, encoder: &mut wgpu::CommandEncoder, overlay: Overlay<'_>) {
        let (shared, pipelines) = (&self.shared, &self.pipelines);
        match pass {
            LivePass::Writing => {}
            LivePass::KeyMap => self.draw_casters(encoder, &shared.key_map, &pipelines.caster),
            LivePass::FloorMap => self.draw_casters(encoder, &shared.under_map, &pipelines.under),
            LivePass::Floor => self.draw_floor(encoder),
            LivePass::Picture => self.draw_picture(encoder, overlay),
        }
    }

    fn write_frame(&self, scene: &Scene<'_>) {
        let bounds = scene.bounds().unwrap_or(Bounds {
            min: Vec3::NEG_ONE,
            max: Vec3::ONE,
        });
        let axis = unit_toward(scene.lights.key.toward);
        let places = places(
            axis,
            bounds,
            self.effort.key_side(),
            scene.ground.map_or(0.0, |ground| ground.height),
        );
        let mut frame = Frame::of(
            scene,
            self.targets.size,
            &Places {
                ground: scene.ground.and(places.ground),
                ..places
            },
        );
        frame.ray_corner.w = self.effort.key_taps();
        let key = Vec3::from(scene.lights.key.color) * axis.y.max(0.0);
        let shadow = scene.ground.map_or(0.0, |ground| ground.shadow);
        let floor_light = FloorLight {
            room: room_on_floor(&scene.lights).extend(shadow),
            key: key.extend(self.effort.key_side() as f32),
        };
        let queue = &self.gpu.queue;
        queue.write_buffer(&self.shared.frame, 0, bytemuck::bytes_of(&frame));
        queue.write_buffer(
            &self.shared.floor_light,
            0,
            bytemuck::bytes_of(&floor_light),
        );
    }

    fn write_strokes(&mut self, overlay: Overlay<'_>) {
        let strokes = [overlay.on_surfaces, overlay.through].concat();
        let needed = (strokes.len().max(1) as u64) * STROKE_BYTES;
        let has_room = (self.strokes.as_ref()).is_some_and(|buffer| needed <= buffer.size());
        if !has_room {
            self.strokes = Some(self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("lines"),
                size: needed.next_power_of_two(),
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }));
        }
        if let Some(buffer) = &self.strokes {
            (self.gpu.queue).write_buffer(buffer, 0, bytemuck::cast_slice(&strokes));
        }
    }

    /// How deep everything lies as seen from a light.
    fn draw_casters(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        map: &wgpu::TextureView,
        pipeline: &wgpu::RenderPipeline,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("casters"),
            depth_stencil_attachment: Some(depth_attachment(map, wgpu::StoreOp::Store)),
            ..wgpu::RenderPassDescriptor::default()
        });
        let Some(meshes) = self.meshes.as_ref().filter(|m| m.index_count > 0) else {
            return;
        };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &self.shared.caster_group, &[]);
        meshes.bind(&mut pass);
        pass.draw_indexed(0..meshes.index_count, 0, 0..1);
    }

    /// The floor's light by the key light's map and the map from below.
    fn draw_floor(&self, encoder: &mut wgpu::CommandEncoder) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("floor"),
            color_attachments: &[Some(color_attachment(&self.shared.floor, None))],
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(&self.pipelines.floor);
        pass.set_bind_group(0, &self.shared.floor_group, &[]);
        pass.draw(0..3, 0..1);
    }

    fn draw_picture(&self, encoder: &mut wgpu::CommandEncoder, overlay: Overlay<'_>) {
        let targets = &self.targets;
        let color = match &targets.samples {
            Some(samples) => color_attachment(samples, Some(&targets.drawn)),
            None => color_attachment(&targets.drawn, None),
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(color)],
            depth_stencil_attachment: Some(depth_attachment(
                &targets.depth,
                wgpu::StoreOp::Discard,
            )),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_bind_group(0, &self.frame_group, &[]);
        pass.set_pipeline(&self.pipelines.background);
        pass.draw(0..3, 0..1);
        if let Some(meshes) = self.meshes.as_ref().filter(|m| m.index_count > 0) {
            meshes.bind(&mut pass);
            meshes.draw(&self.pipelines, &mut pass);
        }
        if let Some(strokes) = &self.strokes {
            let count = |strokes: &[OverlayLine]| u32::try_from(strokes.len()).unwrap_or(0);
            let (on, through) = (count(overlay.on_surfaces), count(overlay.through));
            pass.set_vertex_buffer(0, strokes.slice(..));
            for (pipeline, range) in [
                (&self.pipelines.lines_on_surfaces, 0..on),
                (&self.pipelines.lines_through, on..on + through),
            ] {
                if !range.is_empty() {
                    pass.set_pipeline(pipeline);
                    pass.draw(0..6, range);
                }
            }
        }
    }

    /// The last picture, as bytes.
    ///
    /// # Errors
    /// Where the adapter fails.
    pub fn read_back(&self) -> Result<Image, RenderError> {
        super::draw::read_texture(&self.gpu, &self.targets.picture, self.targets.size)
    }
}

/// Where the light's maps lie: around everything, in whole texels.
fn places(axis: Vec3, bounds: Bounds, key_side: u32, ground_height: f32) -> Places {
    let (right, up) = axis.any_orthonormal_pair();
    let radius = (bounds.max - bounds.min).length() * 0.5;
    let reach = (radius / REACH_STEP).ceil().max(1.0) * REACH_STEP;
    let texel = 2.0 * reach / key_side as f32;
    let center = bounds.center();
    let row = |direction: Vec3| {
        let first = ((center.dot(direction) - reach) / texel).floor();
        (direction / texel).extend(-first)
    };
    let cell = FLOOR_SIDE / FLOOR_CELLS as f32;
    let low = Vec2::new(center.x, center.z) - FLOOR_SIDE * 0.5;
    Places {
        axis,
        texel,
        texel_u: row(right),
        texel_v: row(up),
        ground: Some(GroundPlace {
            height: ground_height,
            corner: (low / cell).floor() * cell,
            cell,
        }),
    }
}

fn color_attachment<'a>(
    view: &'a wgpu::TextureView,
    resolve_target: Option<&'a wgpu::TextureView>,
) -> wgpu::RenderPassColorAttachment<'a> {
    wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target,
        ops: wgpu::Operations {
            load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
            store: if resolve_target.is_some() {
                wgpu::StoreOp::Discard
            } else {
                wgpu::StoreOp::Store
            },
        },
    }
}

const fn depth_attachment(
    view: &wgpu::TextureView,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations {
            load: wgpu::LoadOp::Clear(0.0),
            store,
        }),
        stencil_ops: None,
    }
}

/// What the pixels of a texture are, and what is done with them.
#[derive(Clone, Copy)]
struct TextureKind {
    format: wgpu::TextureFormat,
    samples: u32,
    usage: wgpu::TextureUsages,
}

impl TextureKind {
    fn texture(self, device: &wgpu::Device, [width, height]: [u32; 2]) -> wgpu::Texture {
        device.create_texture(&wgpu::TextureDescriptor {
            label: Some("live"),
            size: extent(width, height),
            mip_level_count: 1,
            sample_count: self.samples,
            dimension: wgpu::TextureDimension::D2,
            format: self.format,
            usage: self.usage,
            view_formats: if self.format == COLOR && self.samples == 1 {
                &[wgpu::TextureFormat::Rgba8Unorm]
            } else {
                &[]
            },
        })
    }
}

fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

impl Targets {
    fn new(device: &wgpu::Device, size: Size, samples: u32) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let sides = [size.width, size.height];
        let sampled = |format| {
            let kind = TextureKind {
                format,
                samples,
                usage: attachment,
            };
            view(&kind.texture(device, sides))
        };
        let shown = TextureKind {
            format: LIVE_COLOR,
            samples: 1,
            usage: attachment
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
        };
        let picture = shown.texture(device, sides);
        Self {
            size,
            samples: (samples > 1).then(|| sampled(LIVE_COLOR)),
            depth: sampled(DEPTH),
            drawn: view(&picture),
            shown: picture.create_view(&wgpu::TextureViewDescriptor {
                label: Some("shown"),
                format: Some(wgpu::TextureFormat::Rgba8Unorm),
                usage: Some(wgpu::TextureUsages::TEXTURE_BINDING),
                ..wgpu::TextureViewDescriptor::default()
            }),
            picture,
        }
    }
}

impl Shared {
    fn new(device: &wgpu::Device, pipelines: &LivePipelines, key_side: u32) -> Self {
        let uniform = |label, bytes: usize| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes as u64,
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let frame = uniform("frame", size_of::<Frame>());
        let floor_light = uniform("floor", size_of::<FloorLight>());
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let map = |side, format| {
            let kind = TextureKind {
                format,
                samples: 1,
                usage,
            };
            view(&kind.texture(device, [side; 2]))
        };
        let key_map = map(key_side, DEPTH);
        let under_map = map(FLOOR_CELLS, DEPTH);
        let floor = map(FLOOR_CELLS, FLOOR);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("key light"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            compare: Some(wgpu::CompareFunction::GreaterEqual),
            ..wgpu::SamplerDescriptor::default()
        });
        let compares = wgpu::BindGroupEntry {
            binding: 3,
            resource: wgpu::BindingResource::Sampler(&sampler),
        };
        let group = |layout, entries: &[wgpu::BindGroupEntry<'_>]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout,
                entries,
            })
        };
        Self {
            caster_group: group(
                &pipelines.caster_layout,
                &[buffer_entry(0, &frame), buffer_entry(5, &floor_light)],
            ),
            floor_group: group(
                &pipelines.floor_layout,
                &[
                    buffer_entry(0, &frame),
                    view_entry(1, &key_map),
                    compares,
                    view_entry(4, &under_map),
                    buffer_entry(5, &floor_light),
                    view_entry(6, &key_map),
                ],
            ),
            key_sampler: sampler,
            frame,
            floor_light,
            key_map,
            under_map,
            floor,
        }
    }

    /// Group 0 of the picture.
    fn frame_group(
        &self,
        device: &wgpu::Device,
        pipelines: &LivePipelines,
        paints: &PaintViews,
    ) -> wgpu::BindGroup {
        let own = [
            buffer_entry(0, &self.frame),
            view_entry(1, &self.key_map),
            view_entry(2, &self.floor),
            wgpu::BindGroupEntry {
                binding: 3,
                resource: wgpu::BindingResource::Sampler(&self.key_sampler),
            },
        ];
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("frame"),
            layout: &pipelines.frame_layout,
            entries: &[&own[..], &paints.entries()].concat(),
        })
    }
}

fn buffer_entry(binding: u32, buffer: &wgpu::Buffer) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry {
        binding,
        resource: buffer.as_entire_binding(),
    }
}
