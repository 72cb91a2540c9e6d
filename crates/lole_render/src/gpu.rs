//! Pictures by a graphics adapter through wgpu: within the limits of WebGL2, so that the same
//! drawing can run in a browser. Opening a device ([`device`]), the pipelines ([`pipeline`]) and
//! drawing a picture into a texture ([`draw`]) are apart, so that a window can lend its own device.

mod device;
mod draw;
mod live;
mod paints;
mod pipeline;

pub(crate) use device::may_exist;
pub(crate) use draw::GpuRenderer;
pub use live::{AmbientLight, Effort, LivePass, LiveView, Overlay, OverlayLine, PassCost};
