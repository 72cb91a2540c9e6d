//! The meshes of a window's picture on the adapter: what stays is uploaded once, what moves is
//! written anew for each picture.

use std::sync::Arc;

use super::pipelines::LivePipelines;
use crate::gpu::device::Device;
use crate::gpu::draw::{Format, float_texture, mipmapped_texture, print_sampler, view_entry};
use crate::gpu::pipeline::Vertex;
use crate::prepare::{Geometry, used_vertices};
use crate::shade::Surface;
use crate::{Material, Scene, SceneMesh, Sides, Texture};
use glam::{Vec2, Vec3};
use lole_geom::mesh::vertex_normals;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// All meshes of one scene.
pub(super) struct LiveMeshes {
    parts: Vec<Part>,
    /// What the adapter holds. All columns lie in one buffer: of several, Mesa's processor driver
    /// (22.3) was measured to lose about a megabyte for each draw.
    vertices: Vec<Vertex>,
    pub(super) vertex_buffer: wgpu::Buffer,
    pub(super) indices: wgpu::Buffer,
    pub(super) index_count: u32,
    /// Light on face and back that the vertices go towards.
    target: Vec<[Vec3; 2]>,
    /// Pictures until it is reached.
    rounds_left: u32,
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
    is_painted: bool,
}

/// A first light, before any has been worked out: that of an evenly lit room.
const FIRST_LIGHT: Vec3 = Vec3::splat(0.24);
/// Pictures over which new light fades in.
pub(super) const FADE_ROUNDS: u32 = 8;

impl LiveMeshes {
    /// Uploads the meshes of a checked scene.
    pub(super) fn new(gpu: &Device, pipelines: &LivePipelines, scene: &Scene<'_>) -> Self {
        let geometry = Geometry::of(scene);
        let device = &gpu.device;
        let vertices: Vec<Vertex> = (geometry.positions.iter().zip(&geometry.normals))
            .zip(geometry.uvs.iter().zip(&geometry.colors))
            .map(|((&position, &normal), (&uv, &color))| Vertex {
                position: position.into(),
                normal: normal.into(),
                uv: uv.into(),
                color: color.into(),
                face_light: FIRST_LIGHT.into(),
                back_light: FIRST_LIGHT.into(),
            })
            .collect();
        let blank = float_texture(gpu, [1, 1], Format::Bytes, &[255; 4]);
        let sampler = print_sampler(device);
        let mut meshes = Self {
            parts: Vec::new(),
            vertex_buffer: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("vertices"),
                size: (vertices.len().max(1) * size_of::<Vertex>()) as u64,
                usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            indices: device.create_buffer_init(&BufferInitDescriptor {
                label: Some("triangles"),
                contents: bytemuck::cast_slice(&geometry.triangles),
                usage: wgpu::BufferUsages::INDEX,
            }),
            index_count: u32::try_from(geometry.triangles.len() * 3).unwrap_or(0),
            target: vec![[FIRST_LIGHT; 2]; vertices.len()],
            vertices,
            rounds_left: 0,
            blank,
            sampler,
        };
        let mut first = 0;
        for (mesh, part) in scene.meshes.iter().zip(&geometry.parts) {
            let sources = used_vertices(mesh);
            let count = sources.len();
            let (surface, group) = meshes.surface(gpu, pipelines, mesh.material, None);
            meshes.parts.push(Part {
                sources,
                first,
                indices: part.triangles.start * 3..part.triangles.end * 3,
                sides: part.sides,
                group,
                surface,
                texture: mesh.material.texture.clone(),
                is_painted: false,
            });
            first += count;
        }
        meshes
    }

    /// The material's constants and what the shader binds for it; `surface` is used again where it
    /// is given.
    fn surface(
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

    /// Writes positions, normals, texture coordinates, colors, materials and light of a scene that fits.
    pub(super) fn write(&mut self, gpu: &Device, pipelines: &LivePipelines, scene: &Scene<'_>) {
        self.move_vertices(scene);
        self.fade_light();
        gpu.queue
            .write_buffer(&self.vertex_buffer, 0, bytemuck::cast_slice(&self.vertices));
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
                let (_, group) = self.surface(gpu, pipelines, material, Some(surface));
                self.parts[index].group = group;
                self.parts[index].texture.clone_from(&material.texture);
            }
        }
    }

    fn move_vertices(&mut self, scene: &Scene<'_>) {
        for (mesh, part) in scene.meshes.iter().zip(&mut self.parts) {
            let made;
            let normals = if mesh.normals.is_empty() {
                made = vertex_normals(mesh.positions, mesh.triangles);
                &made
            } else {
                mesh.normals
            };
            let paints = !mesh.colors.is_empty();
            let repaints = paints || part.is_painted;
            part.is_painted = paints;
            for (vertex, &source) in self.vertices[part.first..].iter_mut().zip(&part.sources) {
                let source = source as usize;
                write_vertex(vertex, (mesh, normals), source);
                if repaints {
                    vertex.color = mesh.colors.get(source).copied().unwrap_or(Vec3::ONE).into();
                }
            }
        }
    }

    fn fade_light(&mut self) {
        if self.rounds_left == 0 {
            return;
        }
        let share = 1.0 / self.rounds_left as f32;
        for (vertex, target) in self.vertices.iter_mut().zip(&self.target) {
            for (shown, &target) in [&mut vertex.face_light, &mut vertex.back_light]
                .into_iter()
                .zip(target)
            {
                *shown = Vec3::from(*shown).lerp(target, share).into();
            }
        }
        self.rounds_left -= 1;
    }

    /// Fades to another light over `rounds` pictures; one of other meshes is ignored.
    pub(super) fn light_up(&mut self, light: &[[Vec3; 2]], rounds: u32) {
        if light.len() == self.target.len() {
            self.target.copy_from_slice(light);
            self.rounds_left = rounds;
        }
    }

    /// How many vertices there are.
    pub(super) const fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// How many of the meshes are drawn.
    pub(super) fn drawn_count(&self) -> usize {
        let drawn = self.parts.iter().filter(|part| !part.indices.is_empty());
        drawn.count()
    }

    /// What [`Self::write`] writes of meshes that fit [byte].
    pub(super) fn written_bytes(&self) -> u64 {
        let surfaces = self.parts.len() * size_of::<Surface>();
        self.vertex_buffer.size() + surfaces as u64
    }

    /// Binds the vertices and triangles.
    pub(super) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertex_buffer.slice(..));
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

/// Writes where one vertex of a mesh is, whose normals are given, and where it is on the texture.
fn write_vertex(vertex: &mut Vertex, (mesh, normals): (&SceneMesh<'_>, &[Vec3]), source: usize) {
    vertex.position = mesh.positions[source].into();
    vertex.normal = normals[source].into();
    // A print of another size lies on the same triangles.
    vertex.uv = mesh.uvs.get(source).copied().unwrap_or(Vec2::ZERO).into();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_print_of_another_size_is_written_on_the_same_triangles() {
        let material = Material::default();
        let mut vertex = Vertex {
            position: [0.0; 3],
            normal: [0.0; 3],
            uv: [0.5, 0.5],
            color: [1.0; 3],
            face_light: [0.0; 3],
            back_light: [0.0; 3],
        };
        let mesh = SceneMesh {
            positions: &[Vec3::X],
            normals: &[Vec3::Y],
            uvs: &[Vec2::new(2.0, 3.0)],
            triangles: &[],
            colors: &[],
            material: &material,
        };
        write_vertex(&mut vertex, (&mesh, mesh.normals), 0);
        assert_eq!((vertex.position, vertex.uv), ([1.0, 0.0, 0.0], [2.0, 3.0]));
        let plain = SceneMesh { uvs: &[], ..mesh };
        write_vertex(&mut vertex, (&plain, mesh.normals), 0);
        assert_eq!(vertex.uv, [0.0, 0.0]);
    }
}
