//! What each pass of a window's picture costs.

use super::{FLOOR_CELLS, LiveView, Overlay, STROKE_BYTES};
use crate::frame::Frame;
use crate::gpu::draw::checked;
use crate::{RenderError, Scene};

/// A part of the work of one picture, in the order in which they come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LivePass {
    /// What moves is written to the adapter.
    Writing,
    /// How deep everything lies as the key light sees it.
    KeyMap,
    /// The same from below, for the floor.
    FloorMap,
    /// The floor's light, by both maps.
    Floor,
    /// What is seen: what is behind, the meshes, the lines over them.
    Picture,
}

/// What a pass asks of an adapter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PassCost {
    /// Calls that draw.
    pub draw_count: usize,
    /// Triangles in them.
    pub triangle_count: usize,
    /// Bytes written to the adapter; for a pass that draws, those of what it draws into.
    pub byte_count: u64,
}

impl LivePass {
    /// Those that draw.
    pub(super) const DRAWN: [Self; 4] = [Self::KeyMap, Self::FloorMap, Self::Floor, Self::Picture];

    /// Its name, for a table of figures.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Writing => "writing",
            Self::KeyMap => "key light's map",
            Self::FloorMap => "map from below",
            Self::Floor => "floor's light",
            Self::Picture => "picture",
        }
    }

    /// Whether it is left out while the floor's light stays.
    pub(super) const fn is_of_the_floor(self) -> bool {
        matches!(self, Self::FloorMap | Self::Floor)
    }
}

impl LiveView {
    /// Draws as [`Self::draw`] does, and waits for the adapter after each pass: `after` may look at a
    /// clock.
    ///
    /// # Errors
    /// As [`Self::draw`].
    pub fn draw_by_pass(
        &mut self,
        scene: &Scene<'_>,
        overlay: Overlay<'_>,
        after: &mut dyn FnMut(LivePass, PassCost),
    ) -> Result<(), RenderError> {
        scene.check()?;
        let scope = (self.gpu.device).push_error_scope(wgpu::ErrorFilter::Validation);
        self.write(scene, overlay);
        let due = self.passes_due();
        for pass in std::iter::once(LivePass::Writing).chain(due) {
            let mut encoder = (self.gpu.device)
                .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.encode(pass, &mut encoder, overlay);
            self.gpu.queue.submit([encoder.finish()]);
            (self.gpu.device)
                .poll(wgpu::PollType::wait_indefinitely())
                .map_err(|error| RenderError::Gpu {
                    doing: "waiting",
                    reason: error.to_string(),
                })?;
            after(pass, self.cost(pass, overlay));
        }
        checked(scope, "drawing")
    }

    fn cost(&self, pass: LivePass, overlay: Overlay<'_>) -> PassCost {
        /// Bytes of a texel of depth, of the floor's light and of the picture.
        const TEXEL: u64 = 4;
        let meshes = self.meshes.as_ref();
        let triangles = meshes.map_or(0, |meshes| meshes.index_count as usize / 3);
        let strokes = [overlay.on_surfaces, overlay.through].map(<[_]>::len);
        let square = |side: u32| u64::from(side) * u64::from(side);
        let casters = |side| PassCost {
            draw_count: usize::from(triangles > 0),
            triangle_count: triangles,
            byte_count: square(side) * TEXEL,
        };
        match pass {
            LivePass::Writing => PassCost {
                draw_count: 0,
                triangle_count: 0,
                byte_count: meshes.map_or(0, super::LiveMeshes::written_bytes)
                    + (strokes[0] + strokes[1]) as u64 * STROKE_BYTES
                    + (size_of::<Frame>() + size_of::<super::FloorLight>()) as u64,
            },
            LivePass::KeyMap => casters(self.effort.key_side()),
            LivePass::FloorMap => casters(FLOOR_CELLS),
            LivePass::Floor => PassCost {
                draw_count: 1,
                triangle_count: 1,
                byte_count: square(FLOOR_CELLS) * TEXEL,
            },
            LivePass::Picture => {
                let drawn = meshes.map_or(0, super::LiveMeshes::drawn_count);
                let lines = strokes.iter().filter(|&&count| count > 0).count();
                let size = self.targets.size;
                let pixels = u64::from(size.width) * u64::from(size.height);
                let samples = match self.effort.samples() {
                    1 => 2 * TEXEL,
                    samples => (2 * u64::from(samples) + 1) * TEXEL,
                };
                PassCost {
                    draw_count: 1 + drawn + lines,
                    triangle_count: 1 + triangles + 2 * (strokes[0] + strokes[1]),
                    byte_count: pixels * samples,
                }
            }
        }
    }
}
