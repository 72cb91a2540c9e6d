//! A GLB read by the rules of glTF 2.0 gives back the dance that went in.

#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test that meets anything unexpected should stop"
)]

use glam::{Affine2, Affine3A, Mat4, Quat, Vec2, Vec3, Vec4};
use lole_body::skeleton::{Bone, Pose, Skeleton};
use lole_export::ExportError;
use lole_export::glb::{
    BakedCloth, GlbMaterial, GlbMesh, GlbPart, GlbScene, GlbSides, GridMesh, GridRing, GridSheet,
    MOST_TARGETS, write_glb,
};
use serde_json::Value;

/// A GLB taken apart by hand.
struct File {
    json: Value,
    binary: Vec<u8>,
}

impl File {
    fn read(bytes: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!(
            (&bytes[..4], word(4), word(8)),
            (&b"glTF"[..], 2, bytes.len())
        );
        let json_end = 20 + word(12);
        assert_eq!(
            (&bytes[16..20], &bytes[json_end + 4..json_end + 8]),
            (&b"JSON"[..], &b"BIN\0"[..])
        );
        let binary = bytes[json_end + 8..].to_vec();
        assert_eq!(binary.len(), word(json_end));
        Self {
            json: serde_json::from_slice(&bytes[20..json_end]).unwrap(),
            binary,
        }
    }

    /// An accessor's numbers as glTF 2.0, section 3.6.2 and 3.11, reads them.
    fn numbers(&self, accessor: &Value) -> Vec<f32> {
        let accessor = &self.json["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &self.json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let width = match accessor["type"].as_str().unwrap() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            "MAT4" => 16,
            other => panic!("{other}"),
        };
        let component = accessor["componentType"].as_u64().unwrap();
        let bytes = match component {
            5120 => 1,
            5122 | 5123 => 2,
            _ => 4,
        };
        let stride = view["byteStride"]
            .as_u64()
            .map_or(width * bytes, |stride| stride as usize);
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        let end = start + view["byteLength"].as_u64().unwrap() as usize;
        assert!(start.is_multiple_of(4) && end <= self.binary.len());
        let mut numbers = Vec::new();
        for element in 0..accessor["count"].as_u64().unwrap() as usize {
            for column in 0..width {
                let at = &self.binary[start + element * stride + column * bytes..end];
                numbers.push(match component {
                    5120 => (f32::from(at[0].cast_signed()) / 127.0).max(-1.0),
                    5122 => (f32::from(i16::from_le_bytes([at[0], at[1]])) / 32767.0).max(-1.0),
                    5123 => f32::from(u16::from_le_bytes([at[0], at[1]])),
                    5125 => u32::from_le_bytes(at[..4].try_into().unwrap()) as f32,
                    5126 => f32::from_le_bytes(at[..4].try_into().unwrap()),
                    other => panic!("{other}"),
                });
            }
        }
        numbers
    }

    fn vectors(&self, accessor: &Value) -> Vec<Vec3> {
        self.numbers(accessor)
            .chunks_exact(3)
            .map(Vec3::from_slice)
            .collect()
    }

    fn node(&self, name: &str) -> (usize, &Value) {
        let nodes = self.json["nodes"].as_array().unwrap();
        let index = nodes.iter().position(|node| node["name"] == name).unwrap();
        (index, &nodes[index])
    }

    /// The keyed value of a node's property at key `key`.
    fn keyed(&self, node: usize, path: &str, key: usize, width: usize) -> Option<Vec<f32>> {
        let animation = &self.json["animations"][0];
        let channel = animation["channels"]
            .as_array()
            .unwrap()
            .iter()
            .find(|channel| {
                channel["target"]["node"] == node && channel["target"]["path"] == path
            })?;
        let sampler = &animation["samplers"][channel["sampler"].as_u64().unwrap() as usize];
        let values = self.numbers(&sampler["output"]);
        Some(values[key * width..(key + 1) * width].to_vec())
    }

    /// World transform of every node at key `key`, from the node tree alone.
    fn worlds(&self, key: usize) -> Vec<Mat4> {
        let nodes = self.json["nodes"].as_array().unwrap();
        let mut worlds = vec![Mat4::IDENTITY; nodes.len()];
        let roots = self.json["scenes"][0]["nodes"].as_array().unwrap();
        let mut open: Vec<(usize, Mat4)> = roots
            .iter()
            .map(|root| (root.as_u64().unwrap() as usize, Mat4::IDENTITY))
            .collect();
        while let Some((index, parent)) = open.pop() {
            let node = &nodes[index];
            let still = node["translation"].as_array().map_or(vec![0.0; 3], |list| {
                list.iter()
                    .map(|value| value.as_f64().unwrap() as f32)
                    .collect()
            });
            let place = self.keyed(index, "translation", key, 3).unwrap_or(still);
            let turn = self
                .keyed(index, "rotation", key, 4)
                .unwrap_or(vec![0.0, 0.0, 0.0, 1.0]);
            let scale = node["scale"][0].as_f64().unwrap_or(1.0) as f32;
            worlds[index] = parent
                * Mat4::from_scale_rotation_translation(
                    Vec3::splat(scale),
                    Quat::from_slice(&turn),
                    Vec3::from_slice(&place),
                );
            for child in node["children"].as_array().into_iter().flatten() {
                open.push((child.as_u64().unwrap() as usize, worlds[index]));
            }
        }
        worlds
    }
}

/// A dancer of points and a small tube of cloth, that move.
struct Sample {
    skeleton: Skeleton,
    times: Vec<f32>,
    poses: Vec<Pose>,
    positions: Vec<Vec3>,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
    triangles: Vec<[u32; 3]>,
    mesh: GridMesh,
    frames: Vec<Vec<Vec3>>,
}

const COLUMNS: u32 = 24;
const ROWS: u32 = 9;

impl Sample {
    fn new(travel: f32) -> Self {
        let mut joints: Vec<Vec3> = Vec::new();
        for (index, bone) in Bone::ALL.iter().enumerate() {
            let parent = bone
                .parent()
                .map_or(Vec3::Y, |parent| joints[parent.index()]);
            let side = if index % 2 == 0 { 0.11 } else { -0.07 };
            joints.push(parent + Vec3::new(side, -0.05, 0.03));
        }
        let times: Vec<f32> = (0..6_u8).map(|key| f32::from(key) / 10.0).collect();
        let poses = (0..6_u8).map(|key| {
            let swing = f32::from(key) * 0.3;
            let mut pose = Pose {
                hips_translation: Vec3::X * swing * 0.2,
                ..Pose::default()
            };
            pose.rotate(Bone::Hips, Quat::from_rotation_y(swing));
            pose.rotate(Bone::LeftUpperLeg, Quat::from_rotation_x(-swing));
            pose.rotate(Bone::RightHand, Quat::from_rotation_z(2.0 * swing));
            pose
        });
        let sheet = GridSheet {
            column_count: COLUMNS,
            row_count: ROWS,
            rows_above: 0,
            ring: GridRing::Closed,
            spacing: [0.05, 0.1],
            uv_from_flat: Affine2::from_scale(Vec2::splat(1.0 / 0.4)),
        };
        let frames: Vec<Vec<Vec3>> = (0..6_u8)
            .map(|key| {
                let wave = f32::from(key) * 0.7;
                let sway = Vec3::X * travel * f32::from(key) / 5.0;
                let particle = |row: u32, column: u32| {
                    let turn = Quat::from_rotation_y(
                        column as f32 / COLUMNS as f32 * std::f32::consts::TAU,
                    );
                    let far =
                        0.2 + 0.02 * row as f32 + 0.01 * lole_geom::trig::sin(wave + column as f32);
                    turn * Vec3::new(far, 1.0 - 0.1 * row as f32, 0.0) + sway
                };
                (0..ROWS)
                    .flat_map(|row| (0..COLUMNS).map(move |column| particle(row, column)))
                    .collect()
            })
            .collect();
        let bone_count = u16::try_from(Bone::COUNT).unwrap();
        Self {
            positions: joints.iter().map(|joint| *joint + Vec3::Z * 0.04).collect(),
            joints: (0..bone_count).map(|index| [index, 0, 7, 9]).collect(),
            weights: vec![[1.5, 0.5, 0.0, 0.0]; Bone::COUNT],
            triangles: vec![[0, 1, 2], [2, 3, 4]],
            skeleton: Skeleton {
                joints,
                waist_side: Vec3::ZERO,
            },
            poses: poses.collect(),
            times,
            mesh: GridMesh::new(&sheet, [2, 3]).facing_outward(&frames[0]),
            frames,
        }
    }

    fn write(&self) -> Result<Vec<u8>, ExportError> {
        let material = GlbMaterial {
            name: "skin",
            base_color: [0.5, 0.3, 0.2],
            roughness: 0.6,
            sheen: 0.0,
            texture_png: None,
            sides: GlbSides::Front,
        };
        let normals = vec![Vec3::Z; self.positions.len()];
        let parts = [GlbPart {
            triangles: &self.triangles,
            material,
        }];
        let skinned = [GlbMesh {
            name: "body",
            positions: &self.positions,
            normals: &normals,
            colors: &[],
            uvs: &[],
            joints: &self.joints,
            weights: &self.weights,
            parts: &parts,
            shapes: &[],
            shape_times: &[],
        }];
        let cloths = [BakedCloth {
            name: "pau_skirt",
            mesh: &self.mesh,
            colors: &[],
            material: GlbMaterial {
                name: "print",
                sheen: 0.12,
                sides: GlbSides::Both,
                ..material
            },
            key_times: &self.times,
            frames: &self.frames,
        }];
        let file = write_glb(&GlbScene {
            skeleton: &self.skeleton,
            pose_times: &self.times,
            poses: &self.poses,
            skinned: &skinned,
            cloths: &cloths,
            added: &[],
            extensions: &[],
        })?;
        assert_eq!(file.fits.is_empty(), self.frames.len() <= MOST_TARGETS + 1);
        Ok(file.bytes)
    }
}

#[test]
fn skinning_the_file_gives_the_posed_body() {
    let sample = Sample::new(0.3);
    let file = File::read(&sample.write().unwrap());
    let skin = &file.json["skins"][0];
    let binds = file.numbers(&skin["inverseBindMatrices"]);
    let (_, body) = file.node("body");
    let primitive = &file.json["meshes"][body["mesh"].as_u64().unwrap() as usize]["primitives"][0];
    let attributes = &primitive["attributes"];
    let positions = file.vectors(&attributes["POSITION"]);
    let (joints, weights) = (
        file.numbers(&attributes["JOINTS_0"]),
        file.numbers(&attributes["WEIGHTS_0"]),
    );
    for (key, pose) in sample.poses.iter().enumerate() {
        let worlds = file.worlds(key);
        let expected: Vec<Affine3A> = sample.skeleton.world_from_bind(pose);
        for (vertex, position) in positions.iter().enumerate() {
            let mut skinned = Vec4::ZERO;
            for slot in 4 * vertex..4 * vertex + 4 {
                let joint = joints[slot] as usize;
                let node = skin["joints"][joint].as_u64().unwrap() as usize;
                let bind = Mat4::from_cols_slice(&binds[16 * joint..16 * joint + 16]);
                skinned += weights[slot] * (worlds[node] * bind * position.extend(1.0));
            }
            let origin = sample.positions[vertex];
            let wanted = 0.75 * expected[vertex].transform_point3(origin)
                + 0.25 * expected[0].transform_point3(origin);
            let error = (skinned.truncate() - wanted).length();
            assert!(error < 2e-6, "key {key}, vertex {vertex}: {error} m");
        }
    }
}

#[test]
fn bones_have_the_names_and_parents_of_vrm() {
    let file = File::read(&Sample::new(0.3).write().unwrap());
    for bone in Bone::ALL {
        let (index, _) = file.node(bone.name());
        let parent = bone.parent().map_or("dancer", Bone::name);
        let children = file.node(parent).1["children"].as_array().unwrap();
        assert!(
            children.iter().any(|child| child == index),
            "{}",
            bone.name()
        );
    }
}

/// The cloth of the file at key `key`: base plus weighted targets, then the node's transform.
fn morphed(file: &File, key: usize) -> Vec<Vec3> {
    let (node, cloth) = file.node("pau_skirt");
    let primitive = &file.json["meshes"][cloth["mesh"].as_u64().unwrap() as usize]["primitives"][0];
    let targets = primitive["targets"].as_array().unwrap();
    let weights = file.keyed(node, "weights", key, targets.len()).unwrap();
    let mut positions = file.vectors(&primitive["attributes"]["POSITION"]);
    for (target, weight) in targets.iter().zip(weights) {
        for (position, moved) in positions.iter_mut().zip(file.vectors(&target["POSITION"])) {
            *position += weight * moved;
        }
    }
    let world = file.worlds(key)[node];
    positions
        .iter()
        .map(|position| world.transform_point3(*position))
        .collect()
}

#[test]
fn morphing_the_file_gives_the_recorded_cloth() {
    // One dance on the spot, one that travels farther than a displacement reaches unscaled.
    for (travel, error_max) in [(0.3, 0.03e-3), (2.7, 0.11e-3)] {
        let sample = Sample::new(travel);
        let file = File::read(&sample.write().unwrap());
        for (key, frame) in sample.frames.iter().enumerate() {
            let cloth = morphed(&file, key);
            for (position, particle) in cloth.iter().zip(&sample.mesh.particles) {
                let error = (*position - frame[*particle as usize]).length();
                assert!(error < error_max, "travel {travel}, key {key}: {error} m");
            }
        }
    }
}

#[test]
fn a_thinned_tube_keeps_its_hem_and_its_print_across_the_seam() {
    let sample = Sample::new(0.3);
    let mesh = &sample.mesh;
    let last_row = (ROWS - 1) * COLUMNS;
    assert!(mesh.particles.iter().any(|particle| last_row <= *particle));
    let flat_width = mesh.uvs.iter().map(|uv| uv.x).fold(0.0, f32::max);
    assert!(
        (flat_width - 24.0 * 0.05 / 0.4).abs() < 1e-6,
        "whole circumference: {flat_width}"
    );
    let hem = mesh.uvs.iter().map(|uv| uv.y).fold(0.0, f32::max);
    assert!((hem - 8.0 * 0.1 / 0.4).abs() < 1e-6, "{hem}");
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|vertex| mesh.uvs[vertex as usize]);
        let widest = (a - b).abs().max((b - c).abs()).max((c - a).abs());
        assert!(
            widest.cmple(Vec2::new(0.26, 0.76)).all(),
            "a cell runs back across the print"
        );
        let [a, b, c] =
            triangle.map(|vertex| sample.frames[0][mesh.particles[vertex as usize] as usize]);
        assert!(
            0.0 < (b - a).cross(c - a).dot((a + b + c).with_y(0.0)),
            "faces inward"
        );
    }
}

#[test]
fn broken_scenes_are_refused_in_words() {
    let mut sample = Sample::new(0.3);
    sample.frames[2][5].y = f32::NAN;
    assert!(
        sample
            .write()
            .unwrap_err()
            .to_string()
            .contains("pau_skirt")
    );
    let mut sample = Sample::new(0.3);
    sample.joints[3] = [999, 0, 0, 0];
    assert!(sample.write().unwrap_err().to_string().contains("999"));
    let mut sample = Sample::new(0.3);
    sample.weights[3] = [0.0; 4];
    assert!(matches!(sample.write(), Err(ExportError::NotFinite { .. })));
    let mut sample = Sample::new(0.3);
    sample.times[3] = 0.0;
    assert!(
        sample
            .write()
            .unwrap_err()
            .to_string()
            .contains("key times")
    );
    let mut sample = Sample::new(0.3);
    sample.poses.pop();
    assert!(matches!(
        sample.write(),
        Err(ExportError::ColumnLength { .. })
    ));
}

#[test]
fn cloth_below_a_seam_hangs_on_the_particles_of_the_seam() {
    let above = GridSheet {
        column_count: 8,
        row_count: 4,
        rows_above: 0,
        ring: GridRing::Closed,
        spacing: [0.1, 0.1],
        uv_from_flat: Affine2::IDENTITY,
    };
    let below = GridSheet {
        row_count: 3,
        rows_above: 3,
        spacing: [0.15, 0.1],
        ..above
    };
    let [first, second] = [above, below].map(|sheet| GridMesh::new(&sheet, [1, 1]));
    let whole = first.clone().with(&second);
    let seam = first.particles.len() - 9;
    assert_eq!(
        first.particles[seam..],
        second.particles[..9],
        "one row of particles"
    );
    assert_eq!(
        whole.particles.len(),
        first.particles.len() + second.particles.len()
    );
    assert_eq!(whole.particles.iter().max(), Some(&(6 * 8 - 1)));
    assert_eq!(whole.triangles.len(), 2 * 8 * (3 + 2));
    let corners = whole.triangles.iter().flatten();
    assert_eq!(
        corners.max().map(|&last| last as usize + 1),
        Some(whole.uvs.len())
    );
    // Its cloth begins anew, and is wider.
    assert_eq!(whole.uvs[first.uvs.len()], Vec2::ZERO);
    assert!((second.uvs[8].x - 1.2).abs() < 1e-6);
}
