//! The state as one number, so that two runs can be told apart by a single bit.

use lole_geom::fnv;

use crate::ClothState;
use crate::lanes::Points;
use crate::mesh::MeshState;
use crate::method::reference::ReferenceState;

/// FNV-1a hash of all bits of all positions and velocities of a grid.
#[must_use]
pub fn state_hash(state: &ClothState) -> u64 {
    points_hash(&state.positions, &state.velocities)
}

/// FNV-1a hash of all bits of all positions and velocities of a piece of any mesh.
#[must_use]
pub fn mesh_state_hash(state: &MeshState) -> u64 {
    points_hash(&state.positions, &state.velocities)
}

fn points_hash(positions: &[Points], velocities: &[Points]) -> u64 {
    let points = positions.iter().chain(velocities);
    let values = points
        .flat_map(|points| [points.x, points.y, points.z])
        .flatten();
    fnv::hash(values.flat_map(f32::to_le_bytes))
}

/// FNV-1a hash of all bits of all positions and velocities of the reference.
#[must_use]
pub fn reference_state_hash(state: &ReferenceState) -> u64 {
    let vectors = state.positions.iter().chain(&state.velocities);
    fnv::hash(
        vectors
            .flat_map(|vector| vector.to_array())
            .flat_map(f64::to_le_bytes),
    )
}
