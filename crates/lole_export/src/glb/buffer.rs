//! The binary chunk of a GLB, and the JSON lists that describe it.

use glam::{Vec2, Vec3};
use serde_json::{Value, json};

/// Component types of glTF 2.0, section 3.6.2.2.
const BYTE: u32 = 5120;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// What a buffer view feeds, glTF 2.0, section 5.11.5.
const VERTICES: u32 = 34_962;
const INDICES: u32 = 34_963;

/// Largest value of a normalized short and byte; `f = max(c / 32767, -1)`, section 3.11.
const SHORT_ONE: f32 = 32_767.0;
const BYTE_ONE: f32 = 127.0;

/// Bytes with the views and accessors into them.
#[derive(Debug, Default)]
pub(super) struct Buffer {
    /// The bytes so far.
    pub bytes: Vec<u8>,
    /// JSON `bufferViews`.
    pub views: Vec<Value>,
    /// JSON `accessors`.
    pub accessors: Vec<Value>,
}

impl Buffer {
    /// Appends a view of `bytes` and gives its index.
    fn view(&mut self, bytes: &[u8], target: Option<u32>, stride: Option<u32>) -> usize {
        // Accessors start at multiples of their component size; 4 holds for all.
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let mut view = json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(),
        });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        if let Some(stride) = stride {
            view["byteStride"] = json!(stride);
        }
        self.bytes.extend_from_slice(bytes);
        self.views.push(view);
        self.views.len() - 1
    }

    /// Appends an accessor and gives its index.
    fn accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// A picture file.
    pub(super) fn picture(&mut self, bytes: &[u8]) -> usize {
        self.view(bytes, None, None)
    }

    /// Vertex positions, with the bounds glTF asks for.
    pub(super) fn positions(&mut self, points: &[Vec3]) -> usize {
        let accessor = self.vectors(points);
        let (low, high) = bounds(points);
        self.accessors[accessor]["min"] = json!(low.to_array());
        self.accessors[accessor]["max"] = json!(high.to_array());
        accessor
    }

    /// Vertex vectors, such as normals.
    pub(super) fn vectors(&mut self, vectors: &[Vec3]) -> usize {
        let bytes = float_bytes(vectors.iter().flat_map(|vector| vector.to_array()));
        let view = self.view(&bytes, Some(VERTICES), Some(12));
        self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": "VEC3", "count": vectors.len(),
        }))
    }

    /// How far some of `count` vertices move from where they are, and the others not at all.
    pub(super) fn moves(&mut self, count: usize, moved: &[(u32, Vec3)]) -> usize {
        let ways: Vec<Vec3> = moved.iter().map(|(_, way)| *way).collect();
        // Those that stay count too.
        let (low, high) = bounds(&ways);
        let (low, high) = (low.min(Vec3::ZERO), high.max(Vec3::ZERO));
        let vertices: Vec<u8> = (moved.iter())
            .flat_map(|(vertex, _)| vertex.to_le_bytes())
            .collect();
        let vertices = self.view(&vertices, None, None);
        let ways = float_bytes(ways.iter().flat_map(|way| way.to_array()));
        let ways = self.view(&ways, None, None);
        self.accessor(json!({
            "componentType": FLOAT, "type": "VEC3", "count": count,
            "min": low.to_array(), "max": high.to_array(),
            "sparse": {
                "count": moved.len(),
                "indices": { "bufferView": vertices, "componentType": UNSIGNED_INT },
                "values": { "bufferView": ways },
            },
        }))
    }

    /// Texture coordinates.
    pub(super) fn uvs(&mut self, uvs: &[Vec2]) -> usize {
        let bytes = float_bytes(uvs.iter().flat_map(|uv| uv.to_array()));
        let view = self.view(&bytes, Some(VERTICES), Some(8));
        self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": "VEC2", "count": uvs.len(),
        }))
    }

    /// Bones of each vertex.
    pub(super) fn joints(&mut self, joints: &[[u16; 4]]) -> usize {
        let bytes: Vec<u8> = joints
            .as_flattened()
            .iter()
            .flat_map(|j| j.to_le_bytes())
            .collect();
        let view = self.view(&bytes, Some(VERTICES), Some(8));
        self.accessor(json!({
            "bufferView": view, "componentType": UNSIGNED_SHORT, "type": "VEC4",
            "count": joints.len(),
        }))
    }

    /// Weights of each vertex.
    pub(super) fn weights(&mut self, weights: &[[f32; 4]]) -> usize {
        let bytes = float_bytes(weights.as_flattened().iter().copied());
        let view = self.view(&bytes, Some(VERTICES), Some(16));
        self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": "VEC4", "count": weights.len(),
        }))
    }

    /// Triangles.
    pub(super) fn triangles(&mut self, triangles: &[[u32; 3]]) -> usize {
        let bytes: Vec<u8> = triangles
            .as_flattened()
            .iter()
            .flat_map(|index| index.to_le_bytes())
            .collect();
        let view = self.view(&bytes, Some(INDICES), None);
        self.accessor(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "type": "SCALAR",
            "count": 3 * triangles.len(),
        }))
    }

    /// Key times of an animation [s].
    pub(super) fn times(&mut self, times: &[f32]) -> usize {
        let accessor = self.scalars(times);
        self.accessors[accessor]["min"] = json!([times.first().copied().unwrap_or(0.0)]);
        self.accessors[accessor]["max"] = json!([times.last().copied().unwrap_or(0.0)]);
        accessor
    }

    /// Numbers of an animation.
    pub(super) fn scalars(&mut self, values: &[f32]) -> usize {
        self.key_values(values, 1, "SCALAR")
    }

    /// Numbers of an animation, `width` to an element of glTF type `kind`.
    pub(super) fn key_values(&mut self, values: &[f32], width: usize, kind: &str) -> usize {
        let bytes = float_bytes(values.iter().copied());
        let view = self.view(&bytes, None, None);
        self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": kind,
            "count": values.len() / width,
        }))
    }

    /// Displacements [1] within `-1..=1` as normalized shorts (`KHR_mesh_quantization`).
    pub(super) fn displacements(&mut self, vectors: &[Vec3]) -> usize {
        let mut bytes = Vec::with_capacity(8 * vectors.len());
        let (mut low, mut high) = ([i16::MAX; 3], [i16::MIN; 3]);
        for vector in vectors {
            for (axis, value) in vector.to_array().into_iter().enumerate() {
                let level = level(value, SHORT_ONE);
                (low[axis], high[axis]) = (low[axis].min(level), high[axis].max(level));
                bytes.extend_from_slice(&level.to_le_bytes());
            }
            bytes.extend_from_slice(&[0, 0]);
        }
        let view = self.view(&bytes, Some(VERTICES), Some(8));
        self.accessor(json!({
            "bufferView": view, "componentType": SHORT, "normalized": true, "type": "VEC3",
            "count": vectors.len(), "min": low, "max": high,
        }))
    }

    /// Differences of unit vectors within `-1..=1` as normalized bytes.
    pub(super) fn turns(&mut self, vectors: &[Vec3]) -> usize {
        let mut bytes = Vec::with_capacity(4 * vectors.len());
        for vector in vectors {
            for value in vector.to_array() {
                bytes.push(level(value, BYTE_ONE).to_le_bytes()[0]);
            }
            bytes.push(0);
        }
        let view = self.view(&bytes, Some(VERTICES), Some(4));
        self.accessor(json!({
            "bufferView": view, "componentType": BYTE, "normalized": true, "type": "VEC3",
            "count": vectors.len(),
        }))
    }

    /// Inverse bind matrices of joints whose axes are those of the body: translations.
    pub(super) fn inverse_binds(&mut self, joints: &[Vec3]) -> usize {
        let columns = joints.iter().flat_map(|joint| {
            let mut matrix = [0.0_f32; 16];
            (matrix[0], matrix[5], matrix[10], matrix[15]) = (1.0, 1.0, 1.0, 1.0);
            (matrix[12], matrix[13], matrix[14]) = (-joint.x, -joint.y, -joint.z);
            matrix
        });
        let values: Vec<f32> = columns.collect();
        self.key_values(&values, 16, "MAT4")
    }
}

/// Nearest level of a normalized integer whose one is `one`.
fn level(value: f32, one: f32) -> i16 {
    #[expect(clippy::cast_possible_truncation, reason = "clamped to -32767..=32767")]
    let level = (value.clamp(-1.0, 1.0) * one).round() as i16;
    level
}

/// Little-endian bytes of numbers.
fn float_bytes(values: impl Iterator<Item = f32>) -> Vec<u8> {
    values.flat_map(f32::to_le_bytes).collect()
}

/// Smallest and largest coordinates.
fn bounds(points: &[Vec3]) -> (Vec3, Vec3) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), point| {
        (low.min(*point), high.max(*point))
    })
}
