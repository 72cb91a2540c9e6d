//! The pipelines: meshes with one or two sides, and the backdrop.

use super::paints::PaintViews;
use crate::Sides;

/// Format of the finished picture; the adapter encodes sRGB after it has mixed the samples.
pub(super) const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
/// Depth, 1 at the near plane.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Samples a pixel.
pub(super) const SAMPLES: u32 = 4;

/// One vertex as the shader reads it.
#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Vertex {
    pub(super) position: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) uv: [f32; 2],
    pub(super) color: [f32; 3],
    pub(super) face_light: [f32; 3],
    pub(super) back_light: [f32; 3],
}

pub(super) const ATTRIBUTES: [wgpu::VertexAttribute; 6] = wgpu::vertex_attr_array![
    0 => Float32x3, 1 => Float32x3, 2 => Float32x2, 3 => Float32x3, 4 => Float32x3, 5 => Float32x3
];

/// All pipelines and what they bind.
pub(super) struct Pipelines {
    /// Group 0: the picture's constants, the key light's map, the floor's light, the landscape's paints.
    pub(super) frame_layout: wgpu::BindGroupLayout,
    /// Group 1: the material's constants, its texture, the sampler.
    pub(super) surface_layout: wgpu::BindGroupLayout,
    outward: wgpu::RenderPipeline,
    both: wgpu::RenderPipeline,
    pub(super) background: wgpu::RenderPipeline,
}

impl Pipelines {
    pub(super) fn new(device: &wgpu::Device) -> Self {
        let frame_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("frame"),
            entries: &[
                &[uniform(0), texture(1, READ_ONLY), texture(2, READ_ONLY)][..],
                &PaintViews::layout(),
            ]
            .concat(),
        });
        let surface_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("surface"),
            entries: &[uniform(0), texture(1, FILTERED), sampler(2)],
        });
        let source = concat!(include_str!("shade.wgsl"), include_str!("key.wgsl"));
        let shader = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("shade"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("shade"),
            bind_group_layouts: &[Some(&frame_layout), Some(&surface_layout)],
            immediate_size: 0,
        });
        let backdrop_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("background"),
            bind_group_layouts: &[Some(&frame_layout)],
            immediate_size: 0,
        });
        let mesh = |cull| Recipe {
            layout: &layout,
            shader: &shader,
            entries: ["mesh_vertex", "mesh_fragment"],
            cull,
            depth: wgpu::CompareFunction::Greater,
        };
        let background = Recipe {
            layout: &backdrop_layout,
            shader: &shader,
            entries: ["background_vertex", "background_fragment"],
            cull: None,
            depth: wgpu::CompareFunction::Always,
        };
        Self {
            outward: mesh(Some(wgpu::Face::Back)).build(device),
            both: mesh(None).build(device),
            background: background.build(device),
            frame_layout,
            surface_layout,
        }
    }

    /// The pipeline that draws these sides of a mesh.
    pub(super) const fn mesh(&self, sides: Sides) -> &wgpu::RenderPipeline {
        match sides {
            Sides::Outward => &self.outward,
            Sides::Both => &self.both,
        }
    }
}

/// What the pipelines differ in.
struct Recipe<'a> {
    layout: &'a wgpu::PipelineLayout,
    shader: &'a wgpu::ShaderModule,
    /// Names of the vertex and the fragment function.
    entries: [&'a str; 2],
    cull: Option<wgpu::Face>,
    depth: wgpu::CompareFunction,
}

impl Recipe<'_> {
    fn build(&self, device: &wgpu::Device) -> wgpu::RenderPipeline {
        let is_mesh = self.depth != wgpu::CompareFunction::Always;
        let vertices = [Some(wgpu::VertexBufferLayout {
            array_stride: size_of::<Vertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &ATTRIBUTES,
        })];
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.entries[1]),
            layout: Some(self.layout),
            vertex: wgpu::VertexState {
                module: self.shader,
                entry_point: Some(self.entries[0]),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: if is_mesh { &vertices } else { &[] },
            },
            primitive: wgpu::PrimitiveState {
                cull_mode: self.cull,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(is_mesh),
                depth_compare: Some(self.depth),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState {
                count: SAMPLES,
                ..wgpu::MultisampleState::default()
            },
            fragment: Some(wgpu::FragmentState {
                module: self.shader,
                entry_point: Some(self.entries[1]),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(COLOR.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

pub(super) const fn uniform(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A texture that is read texel by texel.
pub(super) const READ_ONLY: wgpu::TextureSampleType =
    wgpu::TextureSampleType::Float { filterable: false };
/// A texture that is read through a sampler.
pub(super) const FILTERED: wgpu::TextureSampleType =
    wgpu::TextureSampleType::Float { filterable: true };

pub(super) const fn texture(
    binding: u32,
    sample_type: wgpu::TextureSampleType,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}

pub(super) const fn sampler(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        count: None,
    }
}
