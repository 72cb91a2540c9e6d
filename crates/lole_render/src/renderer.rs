//! Chooses who draws, and draws.

use crate::cpu::CpuRenderer;
use crate::gpu::{self, GpuRenderer};
use crate::{Image, RenderError, Scene, Size};

/// Who draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Backend {
    /// A graphics adapter where one is found, else the CPU. A driver that itself computes on the
    /// CPU is passed over: measured, it takes about four times as long for the same picture.
    #[default]
    Auto,
    /// A graphics adapter, also one that computes on the CPU, or an error.
    Gpu,
    /// The rasterizer of this crate; the same bits on every machine and any number of threads.
    Cpu,
}

/// Where the light of the room on vertices and floor comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomLight {
    /// It is worked out.
    Anew,
    /// It is that of the picture before; worked out anew where that had another number of vertices.
    AsBefore,
}

/// Draws scenes as pictures of one size.
pub struct Renderer {
    size: Size,
    description: String,
    drawer: Drawer,
}

enum Drawer {
    Cpu(Box<CpuRenderer>),
    Gpu(Box<GpuRenderer>),
}

impl Renderer {
    /// A renderer of pictures of `size`.
    ///
    /// # Errors
    /// [`RenderError::ImageSize`] for a size without pixels, [`RenderError::NoAdapter`] where
    /// [`Backend::Gpu`] is asked for and there is none.
    pub fn new(backend: Backend, size: Size) -> Result<Self, RenderError> {
        size.check()?;
        let gpu = match backend {
            Backend::Cpu => None,
            Backend::Gpu => Some(GpuRenderer::open(size)?),
            Backend::Auto if !gpu::may_exist() => None,
            Backend::Auto => GpuRenderer::open(size)
                .ok()
                .filter(|gpu| !gpu.is_software()),
        };
        Ok(match gpu {
            Some(gpu) => Self {
                size,
                description: gpu.description().to_owned(),
                drawer: Drawer::Gpu(Box::new(gpu)),
            },
            None => Self {
                size,
                description: cpu_description(),
                drawer: Drawer::Cpu(Box::new(CpuRenderer::new())),
            },
        })
    }

    /// Draws pictures of another size from now on, on the same adapter: looking for one again would
    /// take longer than a picture.
    ///
    /// # Errors
    /// [`RenderError::ImageSize`] for a size without pixels, [`RenderError::Gpu`] where the adapter
    /// has no room for it; the size then stays as it was.
    pub fn resize(&mut self, size: Size) -> Result<(), RenderError> {
        size.check()?;
        if let Drawer::Gpu(gpu) = &mut self.drawer {
            gpu.resize(size)?;
        }
        self.size = size;
        Ok(())
    }

    /// Size of its pictures.
    #[must_use]
    pub const fn size(&self) -> Size {
        self.size
    }

    /// What draws, for people: `CPU rasterizer, 2 threads` or the adapter's name.
    #[must_use]
    pub fn description(&self) -> &str {
        &self.description
    }

    /// The picture of `scene`.
    ///
    /// # Errors
    /// Where the scene holds a number that is not finite, an index out of range or a camera that
    /// cannot look, naming the place; where the graphics adapter fails.
    pub fn render(&mut self, scene: &Scene<'_>) -> Result<Image, RenderError> {
        self.render_lit(scene, RoomLight::Anew)
    }

    /// The picture of `scene`, with the light of the room from there. That of the picture before is for meshes that
    /// have moved by little since, as while a shutter is open, and spares the largest part of the light's work. Shadows of
    /// the key light follow.
    ///
    /// # Errors
    /// As [`Self::render`].
    pub fn render_lit(
        &mut self,
        scene: &Scene<'_>,
        light: RoomLight,
    ) -> Result<Image, RenderError> {
        scene.check()?;
        match &mut self.drawer {
            Drawer::Cpu(cpu) => Ok(cpu.render(scene, self.size, light)),
            Drawer::Gpu(gpu) => gpu.render(scene, light),
        }
    }
}

fn cpu_description() -> String {
    match rayon::current_num_threads() {
        1 => "CPU rasterizer, 1 thread".to_owned(),
        threads => format!("CPU rasterizer, {threads} threads"),
    }
}
