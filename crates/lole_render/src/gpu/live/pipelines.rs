//! The pipelines of a window's picture: shadow casters, the floor's light, meshes, backdrop, lines.

use crate::Sides;
use crate::gpu::paints::PaintViews;
use crate::gpu::pipeline::{
    ATTRIBUTES, COLOR, DEPTH, FILTERED, READ_ONLY, Vertex, sampler, texture, uniform,
};

/// Format of the floor's light.
pub(super) const FLOOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// All pipelines and what they bind.
pub(super) struct LivePipelines {
    /// Group 0 of the casters: the picture's constants and the floor's.
    pub(super) caster_layout: wgpu::BindGroupLayout,
    /// Group 0 of the floor: those, the key light's map and the map from below.
    pub(super) floor_layout: wgpu::BindGroupLayout,
    /// Group 0 of the picture: its constants, the key light's map, the floor's light, the landscape's paints.
    pub(super) frame_layout: wgpu::BindGroupLayout,
    /// Group 1 of the picture: the material's constants, its texture, the sampler.
    pub(super) surface_layout: wgpu::BindGroupLayout,
    pub(super) caster: wgpu::RenderPipeline,
    pub(super) under: wgpu::RenderPipeline,
    pub(super) floor: wgpu::RenderPipeline,
    outward: wgpu::RenderPipeline,
    both: wgpu::RenderPipeline,
    pub(super) background: wgpu::RenderPipeline,
    pub(super) lines_on_surfaces: wgpu::RenderPipeline,
    pub(super) lines_through: wgpu::RenderPipeline,
}

/// Vertices as the meshes' shader reads them, and as the casters do.
const WHOLE: [wgpu::VertexBufferLayout<'static>; 1] = [vertices(&ATTRIBUTES)];
const PLACES: [wgpu::VertexBufferLayout<'static>; 1] =
    [vertices(&wgpu::vertex_attr_array![0 => Float32x3])];

const fn vertices(
    attributes: &'static [wgpu::VertexAttribute],
) -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<Vertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes,
    }
}

/// One line: both ends, color and width.
const LINES: [wgpu::VertexBufferLayout<'static>; 1] = [wgpu::VertexBufferLayout {
    array_stride: 32,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Float32
    ],
}];

impl LivePipelines {
    /// Pipelines for pictures of `samples` samples a pixel.
    pub(super) fn new(device: &wgpu::Device, samples: u32) -> Self {
        let source = concat!(include_str!("../shade.wgsl"), include_str!("../live.wgsl"));
        let shader = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("live"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let layout = |label, entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some(label),
                entries,
            })
        };
        let caster_layout = layout("casters", &[uniform(0), uniform(5)]);
        let floor_layout = layout(
            "floor",
            &[
                uniform(0),
                texture(1, DEPTHS),
                comparison(3),
                texture(4, READ_ONLY),
                uniform(5),
                texture(6, READ_ONLY),
            ],
        );
        let frame_layout = layout(
            "frame",
            &[
                &[
                    uniform(0),
                    texture(1, DEPTHS),
                    texture(2, READ_ONLY),
                    comparison(3),
                ][..],
                &PaintViews::layout(),
            ]
            .concat(),
        );
        let surface_layout = layout("surface", &[uniform(0), texture(1, FILTERED), sampler(2)]);
        let build = |recipe: &Recipe<'_>| recipe.build(device, &shader, samples);
        let (mesh, above) = ([&frame_layout, &surface_layout], [&frame_layout]);
        let outward = Recipe::mesh(&mesh, Some(wgpu::Face::Back));
        Self {
            caster: build(&Recipe::caster(&[&caster_layout], "caster_vertex")),
            under: build(&Recipe::caster(&[&caster_layout], "under_vertex")),
            floor: build(&Recipe::floor(&[&floor_layout])),
            outward: build(&outward),
            both: build(&Recipe::mesh(&mesh, None)),
            background: build(&Recipe::background(&above)),
            lines_on_surfaces: build(&Recipe::lines(&above, wgpu::CompareFunction::Greater)),
            lines_through: build(&Recipe::lines(&above, wgpu::CompareFunction::Always)),
            caster_layout,
            floor_layout,
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
    groups: &'a [&'a wgpu::BindGroupLayout],
    vertex: &'static str,
    /// The fragment function and the format it draws into; none for depth alone.
    fragment: Option<(&'static str, wgpu::TextureFormat)>,
    buffers: &'static [wgpu::VertexBufferLayout<'static>],
    cull: Option<wgpu::Face>,
    /// How depths are compared, and whether they are written; `None` for no depth at all.
    depth: Option<(wgpu::CompareFunction, Writes)>,
    is_multisampled: bool,
}

/// Whether a pipeline writes depths.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Writes {
    Depth,
    ColorOnly,
}

impl<'a> Recipe<'a> {
    fn caster(groups: &'a [&'a wgpu::BindGroupLayout], vertex: &'static str) -> Self {
        Self {
            groups,
            vertex,
            fragment: None,
            buffers: &PLACES,
            cull: None,
            depth: Some((wgpu::CompareFunction::Greater, Writes::Depth)),
            is_multisampled: false,
        }
    }

    fn floor(groups: &'a [&'a wgpu::BindGroupLayout]) -> Self {
        Self {
            groups,
            vertex: "background_vertex",
            fragment: Some(("floor_fragment", FLOOR)),
            buffers: &[],
            cull: None,
            depth: None,
            is_multisampled: false,
        }
    }

    fn mesh(groups: &'a [&'a wgpu::BindGroupLayout], cull: Option<wgpu::Face>) -> Self {
        Self {
            groups,
            vertex: "mesh_vertex",
            fragment: Some(("mesh_fragment", LIVE_COLOR)),
            buffers: &WHOLE,
            cull,
            depth: Some((wgpu::CompareFunction::Greater, Writes::Depth)),
            is_multisampled: true,
        }
    }

    fn background(groups: &'a [&'a wgpu::BindGroupLayout]) -> Self {
        Self {
            groups,
            vertex: "background_vertex",
            fragment: Some(("background_fragment", LIVE_COLOR)),
            buffers: &[],
            cull: None,
            depth: Some((wgpu::CompareFunction::Always, Writes::ColorOnly)),
            is_multisampled: true,
        }
    }

    fn lines(groups: &'a [&'a wgpu::BindGroupLayout], compare: wgpu::CompareFunction) -> Self {
        Self {
            groups,
            vertex: "line_vertex",
            fragment: Some(("line_fragment", LIVE_COLOR)),
            buffers: &LINES,
            cull: None,
            depth: Some((compare, Writes::ColorOnly)),
            is_multisampled: true,
        }
    }

    fn build(
        &self,
        device: &wgpu::Device,
        shader: &wgpu::ShaderModule,
        samples: u32,
    ) -> wgpu::RenderPipeline {
        let groups: Vec<_> = self.groups.iter().copied().map(Some).collect();
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.vertex),
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let buffers: Vec<_> = self.buffers.iter().cloned().map(Some).collect();
        let toward_eye = [("TOWARD_EYE", TOWARD_EYE)];
        let is_line = self.vertex == "line_vertex";
        let is_encoded = LIVE_COLOR != COLOR && self.is_multisampled;
        let targets = [self.fragment.map(|(_, format)| wgpu::ColorTargetState {
            format,
            blend: is_line.then_some(wgpu::BlendState::ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        })];
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.vertex),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: shader,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions {
                    constants: if is_line { &toward_eye } else { &[] },
                    ..wgpu::PipelineCompilationOptions::default()
                },
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState {
                cull_mode: self.cull,
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: self.depth.map(|(compare, writes)| wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(writes == Writes::Depth),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState {
                count: if self.is_multisampled { samples } else { 1 },
                ..wgpu::MultisampleState::default()
            },
            fragment: self.fragment.map(|(entry, _)| wgpu::FragmentState {
                module: shader,
                entry_point: Some(entry),
                compilation_options: wgpu::PipelineCompilationOptions {
                    constants: if is_encoded { &[("ENCODES", 1.0)] } else { &[] },
                    ..wgpu::PipelineCompilationOptions::default()
                },
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Format of the picture. WebGL cannot look at one texture in two formats, as the window does to have what its
/// format encoded: there, the shader encodes.
pub(super) const LIVE_COLOR: wgpu::TextureFormat = if cfg!(target_arch = "wasm32") {
    wgpu::TextureFormat::Rgba8Unorm
} else {
    COLOR
};

/// Lines on a surface are moved toward the eye by this share of their distance: 6 mm at 3 m, so
/// that the surface does not swallow them.
const TOWARD_EYE: f64 = 2.0e-3;

/// A map of depths that is compared; one that is read texel by texel is as any other texture.
const DEPTHS: wgpu::TextureSampleType = wgpu::TextureSampleType::Depth;

const fn comparison(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison),
        count: None,
    }
}

#[cfg(test)]
mod tests {
    use naga::back::{glsl, pipeline_constants::process_overrides};
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    /// Every function of the window's picture can be said in the language of WebGL 2, as a page needs it.
    #[test]
    fn shaders_can_be_drawn_by_web_gl() {
        let source = concat!(include_str!("../shade.wgsl"), include_str!("../live.wgsl"));
        let module = naga::front::wgsl::parse_str(source).unwrap();
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module).unwrap();
        let mut constants = naga::back::PipelineConstants::default();
        constants.insert("ENCODES".to_owned(), 1.0);
        let options = glsl::Options {
            version: glsl::Version::Embedded {
                version: 300,
                is_webgl: true,
            },
            ..glsl::Options::default()
        };
        assert!(!module.entry_points.is_empty());
        for entry in &module.entry_points {
            let function = Some((entry.stage, entry.name.as_str()));
            let (whole, info) = process_overrides(&module, &info, function, &constants).unwrap();
            let pipeline = glsl::PipelineOptions {
                shader_stage: entry.stage,
                entry_point: entry.name.clone(),
                multiview: None,
            };
            let bounds = naga::proc::BoundsCheckPolicies::default();
            let mut text = String::new();
            let written = glsl::Writer::new(&mut text, &whole, &info, &options, &pipeline, bounds)
                .and_then(|mut writer| writer.write());
            assert!(written.is_ok(), "{}: {written:?}", entry.name);
        }
    }
}
