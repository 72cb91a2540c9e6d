//! What a surface is made of.

use crate::Texture;
use std::sync::Arc;

/// Which sides of a surface are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sides {
    /// The side its triangles wind counter-clockwise on: closed bodies.
    #[default]
    Outward,
    /// Both: cloth.
    Both,
}

/// How the reverse of a cloth differs from its face: a print is paler behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BackShade {
    /// The color, linear, towards which the face's color goes: the unprinted ground of the cloth.
    pub color: [f32; 3],
    /// How far it goes, 0 (the same as the face) to 1 (`color` alone).
    pub fade: f32,
}

/// What a surface is made of. All factors are 0 to 1.
#[derive(Debug, Clone)]
pub struct Material {
    /// Share of light given back, linear; multiplies texture and vertex colors.
    pub base_color: [f32; 3],
    /// Picture on the surface, by texture coordinates.
    pub texture: Option<Arc<Texture>>,
    /// Reverse side; `None` shows the face's color on both.
    pub back: Option<BackShade>,
    /// 0 is a mirror, 1 is chalk.
    pub roughness: f32,
    /// Share of light mirrored head-on: 0.04 for most things, 0 for none.
    pub specular: f32,
    /// Soft brightness at grazing angles: the nap of cotton, velvet, fine hair on skin.
    pub sheen: f32,
    /// Share of the light from behind that comes through: thin cloth 0.2 to 0.4.
    pub translucency: f32,
    /// How far light wraps around past the terminator: skin 0.3, cloth 0.1.
    pub wrap: f32,
    /// Tint, linear, of the light that `wrap` carries past the terminator, because it went through
    /// what lies below the surface: white for none, orange-red for skin.
    pub subsurface: [f32; 3],
    /// Sides that are drawn.
    pub sides: Sides,
}

impl Default for Material {
    /// A matt light gray solid.
    fn default() -> Self {
        Self {
            base_color: [0.6; 3],
            texture: None,
            back: None,
            roughness: 0.7,
            specular: 0.04,
            sheen: 0.0,
            translucency: 0.0,
            wrap: 0.0,
            subsurface: [1.0; 3],
            sides: Sides::Outward,
        }
    }
}

impl Material {
    /// Plain-woven cotton or polyester of color `base_color` (linear), drawn on both sides.
    #[must_use]
    pub fn cloth(base_color: [f32; 3]) -> Self {
        Self {
            base_color,
            roughness: 0.85,
            specular: 0.03,
            sheen: 0.25,
            translucency: 0.22,
            wrap: 0.12,
            sides: Sides::Both,
            ..Self::default()
        }
    }

    /// Printed cloth: `texture` on the face, paler behind.
    #[must_use]
    pub fn printed_cloth(texture: Arc<Texture>) -> Self {
        Self {
            texture: Some(texture),
            back: Some(BackShade {
                color: [0.80, 0.76, 0.70],
                fade: 0.45,
            }),
            ..Self::cloth([1.0; 3])
        }
    }

    /// Skin of color `base_color` (linear).
    #[must_use]
    pub fn skin(base_color: [f32; 3]) -> Self {
        Self {
            base_color,
            roughness: 0.48,
            specular: 0.035,
            sheen: 0.10,
            wrap: 0.30,
            subsurface: [1.0, 0.42, 0.26],
            ..Self::default()
        }
    }

    /// Combed hair of color `base_color` (linear).
    #[must_use]
    pub fn hair(base_color: [f32; 3]) -> Self {
        Self {
            base_color,
            roughness: 0.38,
            specular: 0.05,
            sheen: 0.08,
            wrap: 0.15,
            ..Self::default()
        }
    }
}
