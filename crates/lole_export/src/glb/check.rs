//! Refuses scenes that would make a broken file.

use std::borrow::Cow;

use glam::Vec3;
use lole_body::skeleton::Bone;

use super::{BakedCloth, GlbMesh, GlbScene};
use crate::ExportError;

/// Columns fit each other, indices are in range, numbers are finite, times grow.
pub(super) fn check_scene(scene: &GlbScene<'_>) -> Result<(), ExportError> {
    let skeleton = "skeleton";
    length(skeleton, "joints", scene.skeleton.joints.len(), Bone::COUNT)?;
    finite(skeleton, "joints", &scene.skeleton.joints)?;
    length(skeleton, "poses", scene.poses.len(), scene.pose_times.len())?;
    key_times(skeleton, scene.pose_times)?;
    for (index, pose) in scene.poses.iter().enumerate() {
        length(skeleton, "rotations", pose.rotations.len(), Bone::COUNT)?;
        let turned = pose.rotations.iter().all(|q| q.is_finite());
        if !turned || !pose.hips_translation.is_finite() {
            let (mesh, column) = (skeleton.to_owned(), "poses");
            return Err(ExportError::NotFinite {
                mesh,
                column,
                index,
            });
        }
    }
    finite_added(scene)?;
    let joint_count = Bone::COUNT + scene.added.len();
    let mut skinned = scene.skinned.iter();
    skinned.try_for_each(|mesh| check_skinned(mesh, joint_count))?;
    scene.cloths.iter().try_for_each(check_cloth)
}

fn finite_added(scene: &GlbScene<'_>) -> Result<(), ExportError> {
    for (place, joint) in scene.added.iter().enumerate() {
        finite(&joint.name, "joints", &[joint.place])?;
        let parents = Bone::COUNT + place;
        indices(&joint.name, "joints", [joint.parent].into_iter(), parents)?;
    }
    Ok(())
}

fn check_skinned(mesh: &GlbMesh<'_>, joint_count: usize) -> Result<(), ExportError> {
    let count = mesh.positions.len();
    length(mesh.name, "normals", mesh.normals.len(), count)?;
    if !mesh.uvs.is_empty() {
        length(mesh.name, "uvs", mesh.uvs.len(), count)?;
    }
    length(mesh.name, "joints", mesh.joints.len(), count)?;
    length(mesh.name, "weights", mesh.weights.len(), count)?;
    finite(mesh.name, "positions", mesh.positions)?;
    finite(mesh.name, "normals", mesh.normals)?;
    let joints = mesh
        .joints
        .as_flattened()
        .iter()
        .map(|joint| usize::from(*joint));
    indices(mesh.name, "joints", joints, joint_count)?;
    for part in mesh.parts {
        let corners = part
            .triangles
            .as_flattened()
            .iter()
            .map(|index| *index as usize);
        indices(mesh.name, "triangles", corners, count)?;
    }
    if !mesh.colors.is_empty() {
        length(mesh.name, "colors", mesh.colors.len(), count)?;
        finite(mesh.name, "colors", mesh.colors)?;
    }
    key_times(mesh.name, mesh.shape_times)?;
    for shape in mesh.shapes {
        let moved = shape.moved.iter().map(|(vertex, _)| *vertex as usize);
        indices(mesh.name, "shapes", moved, count)?;
        let ways: Vec<Vec3> = shape.moved.iter().map(|(_, way)| *way).collect();
        finite(mesh.name, "shapes", &ways)?;
        if !shape.weights.is_empty() {
            length(
                mesh.name,
                "shape weights",
                shape.weights.len(),
                mesh.shape_times.len(),
            )?;
        }
    }
    for (index, weights) in mesh.weights.iter().enumerate() {
        let sum: f32 = weights.iter().sum();
        let usable = weights.iter().all(|w| (0.0..f32::INFINITY).contains(w)) && 1e-6 < sum;
        if !usable {
            let (mesh, column) = (mesh.name.to_owned(), "weights");
            return Err(ExportError::NotFinite {
                mesh,
                column,
                index,
            });
        }
    }
    Ok(())
}

fn check_cloth(cloth: &BakedCloth<'_>) -> Result<(), ExportError> {
    length(
        cloth.name,
        "frames",
        cloth.frames.count(),
        cloth.key_times.len(),
    )?;
    if cloth.frames.count() == 0 {
        return length(cloth.name, "frames", 0, 1);
    }
    key_times(cloth.name, cloth.key_times)?;
    let vertex_count = cloth.mesh.particles.len();
    length(cloth.name, "uvs", cloth.mesh.uvs.len(), vertex_count)?;
    let corners = cloth
        .mesh
        .triangles
        .as_flattened()
        .iter()
        .map(|index| *index as usize);
    indices(cloth.name, "triangles", corners, vertex_count)?;
    let particle_count = cloth.frames.frame(0)?.len();
    let particles = cloth
        .mesh
        .particles
        .iter()
        .map(|particle| *particle as usize);
    indices(cloth.name, "particles", particles, particle_count)?;
    Ok(())
}

/// A frame of a cloth, looked at: as many particles as in the first, all of them somewhere.
pub(super) fn checked_frame<'a>(
    cloth: &BakedCloth<'a>,
    number: usize,
    particle_count: usize,
) -> Result<Cow<'a, [Vec3]>, ExportError> {
    let frame = cloth.frames.frame(number)?;
    let column = "particles of a frame";
    length(cloth.name, column, frame.len(), particle_count)?;
    finite(cloth.name, column, &frame)?;
    Ok(frame)
}

fn length(
    mesh: &str,
    column: &'static str,
    actual: usize,
    expected: usize,
) -> Result<(), ExportError> {
    if actual == expected {
        return Ok(());
    }
    Err(ExportError::ColumnLength {
        mesh: mesh.to_owned(),
        column,
        expected,
        actual,
    })
}

fn indices(
    mesh: &str,
    column: &'static str,
    mut values: impl Iterator<Item = usize>,
    count: usize,
) -> Result<(), ExportError> {
    match values.find(|index| count <= *index) {
        Some(index) => Err(ExportError::IndexRange {
            mesh: mesh.to_owned(),
            column,
            index,
            count,
        }),
        None => Ok(()),
    }
}

fn finite(mesh: &str, column: &'static str, vectors: &[Vec3]) -> Result<(), ExportError> {
    match vectors.iter().position(|vector| !vector.is_finite()) {
        Some(index) => Err(ExportError::NotFinite {
            mesh: mesh.to_owned(),
            column,
            index,
        }),
        None => Ok(()),
    }
}

fn key_times(mesh: &str, times: &[f32]) -> Result<(), ExportError> {
    let mut last = -1.0;
    for (index, time) in times.iter().copied().enumerate() {
        let grows = 0.0 <= time && last < time && time.is_finite();
        if !grows {
            return Err(ExportError::KeyTimes {
                mesh: mesh.to_owned(),
                index,
            });
        }
        last = time;
    }
    Ok(())
}
