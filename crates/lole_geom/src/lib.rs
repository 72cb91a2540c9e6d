//! Geometry that every other crate shares: lengths with units, capsules, surfels, triangle meshes and
//! trigonometry that gives the same bits on every platform.
//!
//! It knows no cloth, no garment and no file.
//! World space is right-handed, meters, `+Y` up, `+Z` the dancer's front, `+X` the dancer's left.

pub mod capsule;
pub mod chance;
pub mod finer;
pub mod fnv;
pub mod inside;
pub mod length;
pub mod mesh;
pub mod mesh_surfels;
pub mod number;
pub mod polygon;
pub mod srgb;
pub mod surfel;
pub mod triangle_grid;
pub mod trig;
pub mod trig64;
pub mod weld;

pub use capsule::Capsule;
pub use chance::Chance;
pub use inside::InsideColumns;
pub use length::Length;
pub use mesh::TriangleMesh;
pub use mesh_surfels::MeshSurfels;
pub use number::narrow;
pub use surfel::Surfel;
pub use triangle_grid::TriangleGrid;
pub use weld::WeldedMesh;

#[expect(
    clippy::cast_possible_truncation,
    reason = "a mesh has fewer than 2^32 of each"
)]
const fn index(value: usize) -> u32 {
    value as u32
}
