//! Draws a scene into a texture and reads it back.

use super::device::Device;
use super::paints::PaintViews;
use super::pipeline::{COLOR, DEPTH, Pipelines, SAMPLES, Vertex};
use crate::bake::{Bake, GROUND_CELLS};
use crate::cpu::reflection::Reflection;
use crate::frame::Frame;
use crate::prepare::Geometry;
use crate::renderer::RoomLight;
use crate::shade::Surface;
use crate::srgb::SrgbTable;
use crate::{Image, RenderError, Scene, Size, Texture};
use std::sync::Arc;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// What is kept from picture to picture.
pub(crate) struct GpuRenderer {
    gpu: Device,
    pipelines: Pipelines,
    targets: Targets,
    sampler: wgpu::Sampler,
    paints: PaintViews,
    blank: wgpu::TextureView,
    srgb: SrgbTable,
    /// Textures that the last picture used, with their copies on the adapter.
    uploaded: Vec<(Arc<Texture>, wgpu::TextureView)>,
    /// The light of the picture before.
    bake: Option<Bake>,
}

/// What is drawn into.
struct Targets {
    size: Size,
    samples: wgpu::TextureView,
    depth: wgpu::TextureView,
    picture: wgpu::Texture,
    readback: wgpu::Buffer,
}

/// What one mesh binds and draws.
struct Draw {
    group: wgpu::BindGroup,
    indices: std::ops::Range<u32>,
}

impl GpuRenderer {
    /// Opens an adapter for pictures of `size`.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`] where there is none, [`RenderError::Gpu`] where it refuses.
    pub(crate) fn open(size: Size) -> Result<Self, RenderError> {
        let gpu = Device::open()?;
        check_side(&gpu, size)?;
        let scope = gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipelines = Pipelines::new(&gpu.device);
        let targets = Targets::new(&gpu.device, size);
        let sampler = print_sampler(&gpu.device);
        let paints = PaintViews::new(&gpu);
        let blank = float_texture(&gpu, [1, 1], Format::Bytes, &[255; 4]);
        checked(scope, "setting up")?;
        Ok(Self {
            gpu,
            pipelines,
            targets,
            sampler,
            paints,
            blank,
            srgb: SrgbTable::new(),
            uploaded: Vec::new(),
            bake: None,
        })
    }

    /// Draws pictures of `size` from now on.
    ///
    /// # Errors
    /// Where the adapter has no room for it; the size then stays as it was.
    pub(crate) fn resize(&mut self, size: Size) -> Result<(), RenderError> {
        check_side(&self.gpu, size)?;
        let scope = (self.gpu.device).push_error_scope(wgpu::ErrorFilter::Validation);
        let targets = Targets::new(&self.gpu.device, size);
        checked(scope, "resizing")?;
        self.targets = targets;
        Ok(())
    }

    /// The adapter's name.
    pub(crate) fn description(&self) -> &str {
        &self.gpu.description
    }

    /// Whether the adapter is a driver that computes on the CPU.
    pub(crate) const fn is_software(&self) -> bool {
        self.gpu.is_software
    }

    /// Draws a checked scene.
    ///
    /// # Errors
    /// [`RenderError::Gpu`] where the adapter fails.
    pub(crate) fn render(
        &mut self,
        scene: &Scene<'_>,
        light: RoomLight,
    ) -> Result<Image, RenderError> {
        let geometry = Geometry::of(scene);
        let before = self.bake.take().filter(|_| light == RoomLight::AsBefore);
        let bake = Bake::lit(scene, &geometry, before);
        let frame = Frame::new(scene, self.targets.size, &bake);
        let scope = self
            .gpu
            .device
            .push_error_scope(wgpu::ErrorFilter::Validation);
        self.upload_textures(scene);
        self.paints.upload(&self.gpu, &scene.background);
        let reflection = Reflection::of(scene, &geometry, (&bake, &frame), &self.srgb);
        self.paints.reflect(&self.gpu, reflection.as_ref());
        self.draw(scene, &geometry, &bake, &frame);
        self.bake = Some(bake);
        checked(scope, "drawing")?;
        self.read_back()
    }

    /// Keeps on the adapter the textures of this scene and no others.
    fn upload_textures(&mut self, scene: &Scene<'_>) {
        let wanted = |texture: &Arc<Texture>| {
            scene
                .meshes
                .iter()
                .filter_map(|mesh| mesh.material.texture.as_ref())
                .any(|used| Arc::ptr_eq(used, texture))
        };
        self.uploaded.retain(|(texture, _)| wanted(texture));
        for mesh in &scene.meshes {
            let Some(texture) = &mesh.material.texture else {
                continue;
            };
            if !self.uploaded.iter().any(|(t, _)| Arc::ptr_eq(t, texture)) {
                let view = mipmapped_texture(&self.gpu, texture);
                self.uploaded.push((Arc::clone(texture), view));
            }
        }
    }

    fn draw(&self, scene: &Scene<'_>, geometry: &Geometry, bake: &Bake, frame: &Frame) {
        let device = &self.gpu.device;
        let vertices = vertices(geometry, bake);
        let buffer = |label, contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let vertex_buffer = buffer(
            "vertices",
            bytemuck::cast_slice(&vertices),
            wgpu::BufferUsages::VERTEX,
        );
        let index_buffer = buffer(
            "triangles",
            bytemuck::cast_slice(&geometry.triangles),
            wgpu::BufferUsages::INDEX,
        );
        let frame_group = self.frame_group(bake, frame);
        let draws = self.draws(scene, geometry);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let resolved = self
            .targets
            .picture
            .create_view(&wgpu::TextureViewDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("picture"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &self.targets.samples,
                    depth_slice: None,
                    resolve_target: Some(&resolved),
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Discard,
                    },
                })],
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &self.targets.depth,
                    depth_ops: Some(wgpu::Operations {
                        load: wgpu::LoadOp::Clear(0.0),
                        store: wgpu::StoreOp::Discard,
                    }),
                    stencil_ops: None,
                }),
                ..wgpu::RenderPassDescriptor::default()
            });
            pass.set_bind_group(0, &frame_group, &[]);
            pass.set_pipeline(&self.pipelines.background);
            pass.draw(0..3, 0..1);
            if !geometry.triangles.is_empty() {
                pass.set_vertex_buffer(0, vertex_buffer.slice(..));
                pass.set_index_buffer(index_buffer.slice(..), wgpu::IndexFormat::Uint32);
            }
            for (draw, part) in draws.iter().zip(&geometry.parts) {
                if !draw.indices.is_empty() {
                    pass.set_pipeline(self.pipelines.mesh(part.sides));
                    pass.set_bind_group(1, &draw.group, &[]);
                    pass.draw_indexed(draw.indices.clone(), 0, 0..1);
                }
            }
        }
        self.targets.copy_to_readback(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
    }

    fn frame_group(&self, bake: &Bake, frame: &Frame) -> wgpu::BindGroup {
        let device = &self.gpu.device;
        let uniform = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("frame"),
            contents: bytemuck::bytes_of(frame),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let map = &bake.key_map;
        let side = |texels: usize| u32::try_from(texels).unwrap_or(u32::MAX);
        let key_map = levels_texture(
            &self.gpu,
            [side(map.width), side(map.height)],
            std::iter::once(&map.nearest).chain(&map.coarser),
        );
        let ground = bake.ground.as_ref().map(|light| {
            let cells: Vec<[f32; 4]> = light
                .factors
                .iter()
                .map(|factor| factor.extend(1.0).into())
                .collect();
            let format = Format::FourFloats;
            let side = side(GROUND_CELLS);
            float_texture(
                &self.gpu,
                [side, side],
                format,
                bytemuck::cast_slice(&cells),
            )
        });
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("frame"),
            layout: &self.pipelines.frame_layout,
            entries: &[
                &[
                    wgpu::BindGroupEntry {
                        binding: 0,
                        resource: uniform.as_entire_binding(),
                    },
                    view_entry(1, &key_map),
                    view_entry(2, ground.as_ref().unwrap_or(&self.blank)),
                ][..],
                &self.paints.entries(),
            ]
            .concat(),
        })
    }

    fn draws(&self, scene: &Scene<'_>, geometry: &Geometry) -> Vec<Draw> {
        let device = &self.gpu.device;
        scene
            .meshes
            .iter()
            .zip(&geometry.parts)
            .map(|(mesh, part)| {
                let uniform = device.create_buffer_init(&BufferInitDescriptor {
                    label: Some("surface"),
                    contents: bytemuck::bytes_of(&Surface::of(mesh.material)),
                    usage: wgpu::BufferUsages::UNIFORM,
                });
                let texture = mesh.material.texture.as_ref().and_then(|texture| {
                    let found = self.uploaded.iter().find(|(t, _)| Arc::ptr_eq(t, texture));
                    found.map(|(_, view)| view)
                });
                let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                    label: Some("surface"),
                    layout: &self.pipelines.surface_layout,
                    entries: &[
                        wgpu::BindGroupEntry {
                            binding: 0,
                            resource: uniform.as_entire_binding(),
                        },
                        view_entry(1, texture.unwrap_or(&self.blank)),
                        wgpu::BindGroupEntry {
                            binding: 2,
                            resource: wgpu::BindingResource::Sampler(&self.sampler),
                        },
                    ],
                });
                let indices = part.triangles.start * 3..part.triangles.end * 3;
                Draw { group, indices }
            })
            .collect()
    }

    fn read_back(&self) -> Result<Image, RenderError> {
        read_buffer(&self.gpu, &self.targets.readback, self.targets.size)
    }
}

/// The vertices as the shader takes them.
fn vertices(geometry: &Geometry, bake: &Bake) -> Vec<Vertex> {
    let vertex = |index: usize| Vertex {
        position: geometry.positions[index].into(),
        normal: geometry.normals[index].into(),
        uv: geometry.uvs[index].into(),
        color: geometry.colors[index].into(),
        face_light: bake.ambient[index][0].into(),
        back_light: bake.ambient[index][1].into(),
    };
    (0..geometry.positions.len()).map(vertex).collect()
}

impl Targets {
    fn new(device: &wgpu::Device, size: Size) -> Self {
        let texture = |label, format, samples, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: extent(size.width, size.height),
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let view =
            |texture: wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self {
            size,
            samples: view(texture("samples", COLOR, SAMPLES, attachment)),
            depth: view(texture("depth", DEPTH, SAMPLES, attachment)),
            picture: texture(
                "picture",
                COLOR,
                1,
                attachment | wgpu::TextureUsages::COPY_SRC,
            ),
            readback: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("readback"),
                size: u64::from(row_stride(size)) * u64::from(size.height),
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                mapped_at_creation: false,
            }),
        }
    }

    fn copy_to_readback(&self, encoder: &mut wgpu::CommandEncoder) {
        copy_rows(encoder, &self.picture, &self.readback, self.size);
    }
}

/// Texel formats that are uploaded.
#[derive(Clone, Copy)]
pub(super) enum Format {
    Bytes,
    Float,
    FourFloats,
}

impl Format {
    const fn of_wgpu(self) -> wgpu::TextureFormat {
        match self {
            Self::Bytes => wgpu::TextureFormat::Rgba8UnormSrgb,
            Self::Float => wgpu::TextureFormat::R32Float,
            Self::FourFloats => wgpu::TextureFormat::Rgba32Float,
        }
    }
}

pub(super) fn float_texture(
    gpu: &Device,
    [width, height]: [u32; 2],
    format: Format,
    texels: &[u8],
) -> wgpu::TextureView {
    let descriptor = texture_descriptor([width, height], 1, format);
    let order = wgpu::util::TextureDataOrder::LayerMajor;
    gpu.device
        .create_texture_with_data(&gpu.queue, &descriptor, order, texels)
        .create_view(&wgpu::TextureViewDescriptor::default())
}

/// A texture of numbers with its coarser levels, the finest first.
fn levels_texture<'a>(
    gpu: &Device,
    [width, height]: [u32; 2],
    levels: impl Iterator<Item = &'a Vec<f32>>,
) -> wgpu::TextureView {
    let levels: Vec<&Vec<f32>> = levels.collect();
    let count = u32::try_from(levels.len()).unwrap_or(1);
    let descriptor = texture_descriptor([width, height], count, Format::Float);
    let texels: Vec<f32> = levels.into_iter().flatten().copied().collect();
    let order = wgpu::util::TextureDataOrder::LayerMajor;
    gpu.device
        .create_texture_with_data(
            &gpu.queue,
            &descriptor,
            order,
            bytemuck::cast_slice(&texels),
        )
        .create_view(&wgpu::TextureViewDescriptor::default())
}

pub(super) fn mipmapped_texture(gpu: &Device, texture: &Texture) -> wgpu::TextureView {
    let levels = texture.levels();
    let count = u32::try_from(levels.len()).unwrap_or(1);
    let descriptor = texture_descriptor([texture.width(), texture.height()], count, Format::Bytes);
    let texels: Vec<u8> = levels
        .iter()
        .flat_map(|level| level.pixels.iter().copied())
        .collect();
    let order = wgpu::util::TextureDataOrder::LayerMajor;
    gpu.device
        .create_texture_with_data(&gpu.queue, &descriptor, order, &texels)
        .create_view(&wgpu::TextureViewDescriptor::default())
}

fn texture_descriptor(
    [width, height]: [u32; 2],
    levels: u32,
    format: Format,
) -> wgpu::TextureDescriptor<'static> {
    wgpu::TextureDescriptor {
        label: None,
        size: extent(width, height),
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: format.of_wgpu(),
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    }
}

pub(super) const fn extent(width: u32, height: u32) -> wgpu::Extent3d {
    wgpu::Extent3d {
        width,
        height,
        depth_or_array_layers: 1,
    }
}

pub(super) const fn view_entry(binding: u32, view: &wgpu::TextureView) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::TextureView(view),
    }
}

/// Refuses pictures that the adapter cannot hold.
pub(super) fn check_side(gpu: &Device, size: Size) -> Result<(), RenderError> {
    let longest = gpu.device.limits().max_texture_dimension_2d;
    if size.width.max(size.height) > longest {
        return Err(RenderError::NoAdapter {
            reason: format!("{} draws at most {longest} pixels", gpu.description),
        });
    }
    Ok(())
}

/// What the adapter complained about since `scope` was opened.
pub(super) fn checked(
    scope: wgpu::ErrorScopeGuard,
    doing: &'static str,
) -> Result<(), RenderError> {
    match pollster::block_on(scope.pop()) {
        None => Ok(()),
        Some(error) => Err(RenderError::Gpu {
            doing,
            reason: error.to_string(),
        }),
    }
}

/// Copies a finished texture and waits for it.
pub(super) fn read_texture(
    gpu: &Device,
    texture: &wgpu::Texture,
    size: Size,
) -> Result<Image, RenderError> {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size: u64::from(row_stride(size)) * u64::from(size.height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder =
        (gpu.device).create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    copy_rows(&mut encoder, texture, &buffer, size);
    gpu.queue.submit([encoder.finish()]);
    read_buffer(gpu, &buffer, size)
}

/// Bytes from one row to the next in a buffer that is read back.
const fn row_stride(size: Size) -> u32 {
    (size.width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}

fn copy_rows(
    encoder: &mut wgpu::CommandEncoder,
    texture: &wgpu::Texture,
    buffer: &wgpu::Buffer,
    size: Size,
) {
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row_stride(size)),
                rows_per_image: None,
            },
        },
        extent(size.width, size.height),
    );
}

fn read_buffer(gpu: &Device, buffer: &wgpu::Buffer, size: Size) -> Result<Image, RenderError> {
    let failed = |reason: String| RenderError::Gpu {
        doing: "reading the picture back",
        reason,
    };
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |mapped| {
        // Nobody listens only where the picture was given up.
        drop(sender.send(mapped));
    });
    gpu.device
        .poll(wgpu::PollType::wait_indefinitely())
        .map_err(|e| failed(e.to_string()))?;
    receiver
        .recv()
        .map_err(|e| failed(e.to_string()))?
        .map_err(|e| failed(e.to_string()))?;
    let mut pixels = Vec::with_capacity(size.pixel_count() * 4);
    {
        let bytes = buffer
            .get_mapped_range(..)
            .map_err(|e| failed(e.to_string()))?;
        for row in bytes.chunks(row_stride(size) as usize) {
            pixels.extend_from_slice(&row[..size.width as usize * 4]);
        }
    }
    buffer.unmap();
    Ok(Image {
        width: size.width,
        height: size.height,
        pixels,
    })
}

/// How prints are read: repeated, and smoothly at every size.
pub(super) fn print_sampler(device: &wgpu::Device) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("print"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..wgpu::SamplerDescriptor::default()
    })
}
