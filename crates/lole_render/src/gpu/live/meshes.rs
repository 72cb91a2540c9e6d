//! The meshes of a window's picture on the adapter: what stays is uploaded once, what moves is
//! written anew for each picture.

use std::sync::Arc;

use super::pipelines::LivePipelines;
use crate::gpu::device::Device;
use crate::gpu::draw::{Format, float_texture, mipmapped_texture, view_entry};
use crate::prepare::{Geometry, used_vertices};
use crate::shade::Surface;
use crate::{Material, Scene, Sides, Texture};
use glam::Vec3;
use lole_geom::mesh::vertex_normals;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// All meshes of one scene.
pub(super) struct LiveMeshes {
    parts: Vec<Part>,
    pub(super) vertex_count: usize,
    pub(super) moving: wgpu::Buffer,
    pub(super) uvs: wgpu::Buffer,
    pub(super) colors: wgpu::Buffer,
    pub(super) light: wgpu::Buffer,
    pub(super) indices: wgpu::Buffer,
    pub(super) index_count: u32,
    /// Light on face and back that is shown, and that it goes towards.
    shown: Vec<[Vec3; 2]>,
    target: Vec<[Vec3; 2]>,
    /// Pictures until `shown` is `target`.
    rounds_left: u32,
    painted: Vec<bool>,
    scratch: Vec<[Vec3; 2]>,
    blank: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

/// One mesh.
struct Part {
    /// The scene's vertices that it uses, in order.
    sources: Vec<u32>,
    /// Its first vertex among all.
    first: usize,
    indices: std::ops::Range<u32>,
    sides: Sides,
    group: wgpu::BindGroup,
    surface: wgpu::Buffer,
    texture: Option<Arc<Texture>>,
}

/// A first light, before any has been worked out: that of an evenly lit room.
const FIRST_LIGHT: Vec3 = Vec3::splat(0.24);
/// Pictures over which new light fades in.
const FADE_ROUNDS: u32 = 8;

impl LiveMeshes {
    /// Uploads the meshes of a checked scene.
    pub(super) fn new(gpu: &Device, pipelines: &LivePipelines, scene: &Scene<'_>) -> Self {
        let geometry = Geometry::of(scene);
        let vertex_count = geometry.positions.len();
        let device = &gpu.device;
        let kept = |label, contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let rewritten = |label, stride: usize| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: (vertex_count.max(1) * stride) as u64,
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let colors = rewritten("colors", 12);
        gpu.queue
            .write_buffer(&colors, 0, bytemuck::cast_slice(&geometry.colors));
        let blank = float_texture(gpu, [1, 1], Format::Bytes, &[255; 4]);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("print"),
            address_mode_u: wgpu::AddressMode::Repeat,
            address_mode_v: wgpu::AddressMode::Repeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..wgpu::SamplerDescriptor::default()
        });
        let light = vec![[FIRST_LIGHT; 2]; vertex_count];
        let mut meshes = Self {
            parts: Vec::new(),
            vertex_count,
            moving: rewritten("positions and normals", 24),
            uvs: kept(
                "texture coordinates",
                bytemuck::cast_slice(&geometry.uvs),
                wgpu::BufferUsages::VERTEX,
            ),
            colors,
            light: rewritten("light", 24),
            indices: kept(
                "triangles",
                bytemuck::cast_slice(&geometry.triangles),
                wgpu::BufferUsages::INDEX,
            ),
            index_count: u32::try_from(geometry.triangles.len() * 3).unwrap_or(0),
            shown: light.clone(),
            target: light,
            rounds_left: 1,
            painted: vec![false; scene.meshes.len()],
            scratch: Vec::with_capacity(vertex_count),
            blank,
            sampler,
        };
        let mut first = 0;
        for (mesh, part) in scene.meshes.iter().zip(&geometry.parts) {
            let sources = used_vertices(mesh);
            let count = sources.len();
            let (surface, group) = meshes.bind(gpu, pipelines, mesh.material, None);
            meshes.parts.push(Part {
                sources,
                first,
                indices: part.triangles.start * 3..part.triangles.end * 3,
                sides: part.sides,
                group,
                surface,
                texture: mesh.material.texture.clone(),
            });
            first += count;
        }
        meshes
    }

    /// The material's constants and what the shader binds for it; `surface` is used again where it
    /// is given.
    fn bind(
        &self,
        gpu: &Device,
        pipelines: &LivePipelines,
        material: &Material,
        surface: Option<wgpu::Buffer>,
    ) -> (wgpu::Buffer, wgpu::BindGroup) {
        let surface = surface.unwrap_or_else(|| {
            gpu.device.create_buffer_init(&BufferInitDescriptor {
                label: Some("surface"),
                contents: bytemuck::bytes_of(&Surface::of(material)),
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            })
        });
        let picture = material
            .texture
            .as_ref()
            .map(|texture| mipmapped_texture(gpu, texture));
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("surface"),
            layout: &pipelines.surface_layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: surface.as_entire_binding(),
                },
                view_entry(1, picture.as_ref().unwrap_or(&self.blank)),
                wgpu::BindGroupEntry {
                    binding: 2,
                    resource: wgpu::BindingResource::Sampler(&self.sampler),
                },
            ],
        });
        (surface, group)
    }

    /// Whether these buffers hold the meshes of `scene`, moved and painted anew at most.
    pub(super) fn fit(&self, scene: &Scene<'_>) -> bool {
        self.parts.len() == scene.meshes.len()
            && self.parts.iter().zip(&scene.meshes).all(|(part, mesh)| {
                let triangles = mesh.triangles.len() * 3 == part.indices.len();
                let last = part
                    .sources
                    .last()
                    .is_none_or(|&l| (l as usize) < mesh.positions.len());
                triangles && last
            })
    }

    /// Writes positions, normals, colors, materials and light of a scene that fits.
    pub(super) fn write(&mut self, gpu: &Device, pipelines: &LivePipelines, scene: &Scene<'_>) {
        self.write_motion(gpu, scene);
        self.write_colors(gpu, scene);
        self.write_light(gpu);
        for index in 0..self.parts.len() {
            let material = scene.meshes[index].material;
            let part = &self.parts[index];
            gpu.queue
                .write_buffer(&part.surface, 0, bytemuck::bytes_of(&Surface::of(material)));
            let same = match (&part.texture, &material.texture) {
                (Some(old), Some(new)) => Arc::ptr_eq(old, new),
                // A texture that is not shown now may be shown again.
                (_, None) => true,
                (None, Some(_)) => false,
            };
            if !same {
                let surface = part.surface.clone();
                let (_, group) = self.bind(gpu, pipelines, material, Some(surface));
                self.parts[index].group = group;
                self.parts[index].texture.clone_from(&material.texture);
            }
        }
    }

    fn write_motion(&mut self, gpu: &Device, scene: &Scene<'_>) {
        self.scratch.clear();
        for (mesh, part) in scene.meshes.iter().zip(&self.parts) {
            let made;
            let normals = if mesh.normals.is_empty() {
                made = vertex_normals(mesh.positions, mesh.triangles);
                &made
            } else {
                mesh.normals
            };
            self.scratch.extend(part.sources.iter().map(|&source| {
                let source = source as usize;
                [mesh.positions[source], normals[source]]
            }));
        }
        gpu.queue
            .write_buffer(&self.moving, 0, bytemuck::cast_slice(&self.scratch));
    }

    fn write_colors(&mut self, gpu: &Device, scene: &Scene<'_>) {
        for ((mesh, part), painted) in (scene.meshes.iter().zip(&self.parts)).zip(&mut self.painted)
        {
            let paints = !mesh.colors.is_empty();
            if !paints && !*painted {
                continue;
            }
            *painted = paints;
            let colors: Vec<Vec3> = part
                .sources
                .iter()
                .map(|&source| {
                    mesh.colors
                        .get(source as usize)
                        .copied()
                        .unwrap_or(Vec3::ONE)
                })
                .collect();
            let place = (part.first * size_of::<Vec3>()) as u64;
            gpu.queue
                .write_buffer(&self.colors, place, bytemuck::cast_slice(&colors));
        }
    }

    fn write_light(&mut self, gpu: &Device) {
        if self.rounds_left == 0 {
            return;
        }
        let share = 1.0 / self.rounds_left as f32;
        for (shown, target) in self.shown.iter_mut().zip(&self.target) {
            for (shown, target) in shown.iter_mut().zip(target) {
                *shown += (*target - *shown) * share;
            }
        }
        self.rounds_left -= 1;
        gpu.queue
            .write_buffer(&self.light, 0, bytemuck::cast_slice(&self.shown));
    }

    /// Fades to another light; one of other meshes is ignored.
    pub(super) fn light_up(&mut self, light: &[[Vec3; 2]], is_first: bool) {
        if light.len() == self.target.len() {
            self.target.copy_from_slice(light);
            self.rounds_left = if is_first { 1 } else { FADE_ROUNDS };
        }
    }

    /// Binds the columns of all vertices.
    pub(super) fn bind_columns<'pass>(&'pass self, pass: &mut wgpu::RenderPass<'pass>) {
        pass.set_vertex_buffer(0, self.moving.slice(..));
        pass.set_vertex_buffer(1, self.uvs.slice(..));
        pass.set_vertex_buffer(2, self.colors.slice(..));
        pass.set_vertex_buffer(3, self.light.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
    }

    /// Draws every mesh.
    pub(super) fn draw(&self, pipelines: &LivePipelines, pass: &mut wgpu::RenderPass<'_>) {
        for part in &self.parts {
            if !part.indices.is_empty() {
                pass.set_pipeline(pipelines.mesh(part.sides));
                pass.set_bind_group(1, &part.group, &[]);
                pass.draw_indexed(part.indices.clone(), 0, 0..1);
            }
        }
    }
}
