//! A long recording of cloth as bones of its own in the file.

use glam::Vec3;
use serde_json::{Value, json};

use super::BakedCloth;
use super::check::checked_frame;
use super::fit::{ClothFit, Fit, SAMPLES, spread};
use super::write::{Document, push_channel, vertices, write_material};
use crate::ExportError;

/// Writes mesh, bones and their keys; says how far they are from the recording.
pub(super) fn write(
    document: &mut Document,
    cloth: &BakedCloth<'_>,
) -> Result<ClothFit, ExportError> {
    let first = cloth.frames.frame(0)?;
    let particle_count = first.len();
    let frame = |number: usize| -> Result<Vec<Vec3>, ExportError> {
        Ok(vertices(
            cloth,
            &checked_frame(cloth, number, particle_count)?,
        ))
    };
    let count = cloth.frames.count();
    let samples = spread(count, SAMPLES).into_iter().map(frame);
    let samples: Vec<Vec<Vec3>> = samples.collect::<Result<_, _>>()?;
    if samples[0].is_empty() {
        return Ok(Fit::nothing(cloth.name));
    }
    let mut fit = Fit::new(&samples);
    let mut keys = vec![(Vec::new(), Vec::new()); fit.joints.len()];
    for number in 0..count {
        let joints = fit.joints.clone();
        let bones = fit.follow(&frame(number)?).iter();
        for ((bone, joint), (places, turns)) in bones.zip(joints).zip(&mut keys) {
            places.extend((bone.turn * joint + bone.place).to_array());
            turns.push(bone.turn);
        }
    }
    write_bones(document, cloth, (&fit, keys));
    let normals = cloth.mesh.normals(&first);
    write_mesh(document, cloth, (&fit, &samples[0], &normals));
    Ok(fit.told(cloth.name))
}

/// Places of a bone, number by number, and its turns, by keys.
type BoneKeys = (Vec<f32>, Vec<glam::Quat>);

/// The bones below a node of their own, with their keys.
fn write_bones(
    document: &mut Document,
    cloth: &BakedCloth<'_>,
    (fit, keys): (&Fit, Vec<BoneKeys>),
) {
    let armature = document.nodes.len();
    let first = armature + 1;
    let bones: Vec<usize> = (first..first + fit.joints.len()).collect();
    document.roots.push(armature);
    let name = format!("{}_bones", cloth.name);
    document
        .nodes
        .push(json!({ "name": name, "children": bones }));
    for (place, joint) in fit.joints.iter().enumerate() {
        document.nodes.push(json!({
            "name": format!("{}_bone_{place:03}", cloth.name), "translation": joint.to_array(),
        }));
    }
    let input = document.buffer.times(cloth.key_times);
    for ((places, turns), &node) in keys.into_iter().zip(&bones) {
        let output = document.buffer.key_values(&places, 3, "VEC3");
        push_channel(document, [input, output], node, "translation");
        // A quaternion and its negative turn alike, but interpolation between them does not.
        let mut last = glam::Quat::IDENTITY;
        let turns = turns.into_iter().flat_map(|turn| {
            let turn = turn.normalize();
            last = if turn.dot(last) < 0.0 { -turn } else { turn };
            last.to_array()
        });
        let output = document
            .buffer
            .key_values(&turns.collect::<Vec<f32>>(), 4, "VEC4");
        push_channel(document, [input, output], node, "rotation");
    }
    let inverse_binds = document.buffer.inverse_binds(&fit.joints);
    document.skins.push(json!({
        "name": name, "skeleton": armature, "joints": bones, "inverseBindMatrices": inverse_binds,
    }));
}

fn write_mesh(
    document: &mut Document,
    cloth: &BakedCloth<'_>,
    (fit, rest, normals): (&Fit, &[Vec3], &[Vec3]),
) {
    let buffer = &mut document.buffer;
    let mut attributes = json!({
        "POSITION": buffer.positions(rest),
        "NORMAL": buffer.vectors(normals),
        "JOINTS_0": buffer.joints(&used(fit)),
        "WEIGHTS_0": buffer.weights(&fit.skin.weights),
    });
    if cloth.material.texture_png.is_some() {
        attributes["TEXCOORD_0"] = json!(buffer.uvs(&cloth.mesh.uvs));
    }
    if !cloth.colors.is_empty() {
        attributes["COLOR_0"] = json!(buffer.vectors(cloth.colors));
    }
    let indices = document.buffer.triangles(&cloth.mesh.triangles);
    let material = write_material(document, &cloth.material);
    document.meshes.push(json!({
        "name": cloth.name,
        "primitives": [{ "attributes": attributes, "indices": indices, "material": material }],
    }));
    document.roots.push(document.nodes.len());
    let node: Value = json!({
        "name": cloth.name, "mesh": document.meshes.len() - 1, "skin": document.skins.len() - 1,
    });
    document.nodes.push(node);
}

/// Bones of zero weight become bone 0, as glTF recommends.
fn used(fit: &Fit) -> Vec<[u16; 4]> {
    let carried = fit.skin.bones.iter().zip(&fit.skin.weights);
    carried
        .map(|(bones, weights)| {
            [0, 1, 2, 3].map(|slot| if 0.0 < weights[slot] { bones[slot] } else { 0 })
        })
        .collect()
}
