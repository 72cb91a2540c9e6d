//! Pictures of meshes, without a window: by wgpu where an adapter exists, by a CPU rasterizer
//! where none does.
//!
//! A [`Scene`] names meshes with materials, a camera, lights, a backdrop and a ground; a
//! [`Renderer`] turns it into an [`Image`]. It knows no cloth, no garment and no dancer.
//! World space is right-handed, meters, `+Y` up, `+Z` the dancer's front, `+X` the dancer's left.
//!
//! Both backends share one light bake (`bake`): the shadow map of the key light, the light that
//! reaches each vertex from the studio around it past everything in the way, and the shadow on
//! the ground. They differ in who finds the visible triangle of each sample and runs the shading
//! formula, which is written twice, `shade.rs` and `shade.wgsl`, line by line alike.
//!
//! Colors are linear unless a name says sRGB; light is in units in which a white card facing the
//! key light shows as white.

pub mod backdrop;
mod bake;
pub mod camera;
mod cpu;
mod depth_map;
pub mod error;
mod frame;
mod gpu;
pub mod image;
pub mod label;
pub mod light;
pub mod material;
mod prepare;
mod renderer;
pub mod scene;
mod shade;
pub mod srgb;
mod surroundings;
pub mod texture;
mod whole;

pub use backdrop::{Background, Gradient, Ground, Landscape};
pub use camera::{Bounds, Camera, View};
pub use error::RenderError;
pub use gpu::{AmbientLight, Effort, LivePass, LiveView, Overlay, OverlayLine, PassCost};
pub use image::{Exposure, Image, Size};
pub use light::{KeyLight, LightRig, SoftBox};
pub use material::{BackShade, Material, Sides};
pub use renderer::{Backend, Renderer, RoomLight};
pub use scene::{Scene, SceneMesh};
pub use texture::Texture;
pub use wgpu;
