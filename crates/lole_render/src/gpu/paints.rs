//! What a landscape is painted with, on the adapter.

use super::device::Device;
use super::draw::{Format, float_texture, mipmapped_texture, print_sampler, view_entry};
use super::pipeline::{FILTERED, READ_ONLY, sampler, texture};
use crate::cpu::reflection::Reflection;
use crate::{Background, Texture};
use std::sync::Arc;

/// Bindings of the panorama, what is mirrored of it and the two floors in group 0, and of their sampler.
const VIEWS: [u32; 4] = [7, 11, 8, 9];
const SAMPLER: u32 = 10;
/// Binding of what floors mirror of the meshes.
const REFLECTION: u32 = 12;

/// The pictures of the last landscape: they stay until another comes.
pub(super) struct PaintViews {
    shown: Option<[Arc<Texture>; 4]>,
    views: [wgpu::TextureView; 4],
    /// Nothing but in pictures that have one.
    reflection: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

/// Whether what is bound is still what it was.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kept {
    Same,
    Changed,
}

impl PaintViews {
    /// One white pixel for each.
    pub(super) fn new(gpu: &Device) -> Self {
        let blank = float_texture(gpu, [1, 1], Format::Bytes, &[255; 4]);
        Self {
            shown: None,
            views: std::array::from_fn(|_| blank.clone()),
            reflection: no_reflection(gpu),
            sampler: print_sampler(&gpu.device),
        }
    }

    /// What group 0 has to say of them.
    pub(super) const fn layout() -> [wgpu::BindGroupLayoutEntry; 6] {
        [
            texture(VIEWS[0], FILTERED),
            texture(VIEWS[1], FILTERED),
            texture(VIEWS[2], FILTERED),
            texture(VIEWS[3], FILTERED),
            sampler(SAMPLER),
            texture(REFLECTION, READ_ONLY),
        ]
    }

    /// Uploads the pictures of a backdrop, if it has any that are not here.
    pub(super) fn upload(&mut self, gpu: &Device, background: &Background) -> Kept {
        let Background::Landscape(landscape) = background else {
            return Kept::Same;
        };
        let paints = landscape.paints();
        let same = (self.shown.iter().flatten())
            .zip(paints)
            .filter(|(here, wanted)| Arc::ptr_eq(here, wanted));
        if same.count() == paints.len() {
            return Kept::Same;
        }
        self.views = paints.map(|paint| mipmapped_texture(gpu, paint));
        self.shown = Some(paints.map(Arc::clone));
        Kept::Changed
    }

    /// Uploads what floors mirror of the meshes in one picture.
    pub(super) fn reflect(&mut self, gpu: &Device, reflection: Option<&Reflection>) {
        self.reflection = reflection.map_or_else(
            || no_reflection(gpu),
            |it| {
                let size = [it.size.width, it.size.height];
                let texels = bytemuck::cast_slice(&it.texels);
                float_texture(gpu, size, Format::FourFloats, texels)
            },
        );
    }

    /// What group 0 binds.
    pub(super) fn entries(&self) -> [wgpu::BindGroupEntry<'_>; 6] {
        let [far, mirrored, near, beyond] = &self.views;
        [
            view_entry(VIEWS[0], far),
            view_entry(VIEWS[1], mirrored),
            view_entry(VIEWS[2], near),
            view_entry(VIEWS[3], beyond),
            wgpu::BindGroupEntry {
                binding: SAMPLER,
                resource: wgpu::BindingResource::Sampler(&self.sampler),
            },
            view_entry(REFLECTION, &self.reflection),
        ]
    }
}

/// One texel that hides nothing.
fn no_reflection(gpu: &Device) -> wgpu::TextureView {
    float_texture(gpu, [1, 1], Format::Bytes, &[0; 4])
}
