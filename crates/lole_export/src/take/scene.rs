//! What of a take does not move: meshes, materials, rate.

use glam::{Vec2, Vec3};

/// Everything of a take that does not move.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TakeScene {
    /// Frames in a second.
    pub frame_rate: u32,
    /// Frames; the first is at 0 s.
    pub frame_count: u32,
    /// Meshes.
    pub meshes: Vec<TakeMesh>,
}

impl TakeScene {
    /// When a frame is [s].
    #[must_use]
    pub fn time(&self, frame: u32) -> f64 {
        f64::from(frame) / f64::from(self.frame_rate)
    }
}

/// A mesh whose vertices move.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TakeMesh {
    /// Its name, an [`identifier`]; no two meshes share one.
    pub name: String,
    /// Its vertices.
    pub vertex_count: usize,
    /// Where they lie on the picture, v down; shape `[vertex_count]` or empty.
    pub uvs: Vec<Vec2>,
    /// Linear colors that multiply the material's; shape `[vertex_count]` or empty.
    pub colors: Vec<Vec3>,
    /// Its triangles, by material.
    pub parts: Vec<TakePart>,
}

impl TakeMesh {
    /// All triangles, part by part.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.parts
            .iter()
            .flat_map(|part| part.triangles.iter().copied())
    }
}

/// The triangles of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct TakePart {
    /// By vertices, counterclockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// What they are made of.
    pub material: TakeMaterial,
}

/// How a surface looks.
#[derive(Debug, Clone, PartialEq)]
pub struct TakeMaterial {
    /// Its name, an [`identifier`]; no two materials of a take share one.
    pub name: String,
    /// Linear color, 0 to 1; it multiplies the picture.
    pub base_color: [f32; 3],
    /// Perceptual roughness, 0 to 1.
    pub roughness: f32,
    /// PNG of an sRGB picture that repeats.
    pub texture_png: Option<Vec<u8>>,
    /// Whether both sides are drawn.
    pub is_two_sided: bool,
}

impl TakeMaterial {
    /// Name of the picture's file.
    #[must_use]
    pub fn picture_name(&self) -> String {
        format!("{}.png", self.name)
    }
}

/// A name that every format and file system takes: ASCII letters, digits and `_`, no digit first, and none of
/// `taken`, whatever their case.
pub fn identifier(name: &str, taken: &[String]) -> String {
    let plain = |letter: char| {
        if letter.is_ascii_alphanumeric() {
            letter
        } else {
            '_'
        }
    };
    let mut base: String = name.chars().map(plain).collect();
    if !base.starts_with(|letter: char| letter.is_ascii_alphabetic()) {
        base.insert_str(0, "mesh_");
    }
    // File systems that know no case would make one file of two.
    let is_free = |name: &str| !taken.iter().any(|other| other.eq_ignore_ascii_case(name));
    if is_free(&base) {
        return base;
    }
    let numbered = (2_u32..).map(|number| format!("{base}_{number}"));
    numbered
        .into_iter()
        .find(|name| is_free(name))
        .unwrap_or(base)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_ones_that_every_format_takes_and_no_two_are_alike() {
        let mut taken = Vec::new();
        for name in ["pau_skirt", "Pau_Skirt", "パウ", "../x", "", "1", "1"] {
            let made = identifier(name, &taken);
            let letters = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
            assert!(made.chars().all(letters) && !made.is_empty(), "{made}");
            assert!(!made.starts_with(|letter: char| letter.is_ascii_digit()));
            assert!(
                !taken
                    .iter()
                    .any(|it: &String| it.eq_ignore_ascii_case(&made)),
                "{made}"
            );
            taken.push(made);
        }
    }
}
