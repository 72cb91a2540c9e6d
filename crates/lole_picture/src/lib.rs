//! What the camera sees of a performance: the materials of dancer and garments, and the meshes of one
//! moment as a scene. Films, stills and the live window show the same.
//!
//! It opens nothing and draws nothing: [`lole_render`] does.

mod moment;

use std::sync::Arc;

use glam::Vec2;
use lole_body::{Appearance, BodyPicture, Dancer, Look, PartKind, appearance};
use lole_costume::adorn::{Adornment, Finish};
use lole_costume::document::Design;
use lole_costume::document::PrintError;
use lole_costume::print::PrintImage;
use lole_render::srgb::linear_from_srgb;
use lole_render::{Camera, LightRig, Material, RenderError, Scene, SceneMesh, Sides, Texture};
use lole_stage::{DressedGarment, Production};
pub use moment::{Figure, Moment, Vertices};

/// Pixels of one print repeat: a repeat of 45 cm shows every petal from two meters.
const PRINT_SIDE: u32 = 1024;

/// The materials of one production.
pub struct Looks {
    /// The cloth of every garment, in the production's order.
    pub cloths: Vec<Material>,
    /// The dancer's parts, in the order of her skin's.
    pub parts: Vec<(PartKind, Material)>,
    /// The surfaces of the adornments, one after the other in the production's order.
    pub adornments: Vec<Material>,
    /// The print of every garment, for files that carry it.
    pub prints: Vec<PrintImage>,
    /// Where its vertices lie on the print, in repeats.
    print_uvs: Vec<Vec<Vec2>>,
    /// The same of the dressed garments.
    pub dressed: Vec<DressedLook>,
}

/// The cloth of a dressed garment.
pub struct DressedLook {
    /// The cloth.
    pub cloth: Material,
    /// The print, for files that carry it.
    pub print: PrintImage,
    /// Where its vertices lie on the print, in repeats.
    pub uvs: Vec<Vec2>,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum LookError {
    /// The print cannot be made.
    #[error(transparent)]
    Print(#[from] PrintError),
    /// A picture cannot be a texture.
    #[error(transparent)]
    Render(#[from] RenderError),
}

impl Looks {
    /// Draws prints, face and hair once.
    ///
    /// # Errors
    /// A picture that was not read or cannot be a texture.
    pub fn new(design: &Design, production: &Production) -> Result<Self, LookError> {
        let prints = design.worn_print_images(PRINT_SIDE)?;
        let cloths = prints.iter().map(|print| {
            let texture = Texture::new(print.width, print.height, print.pixels.clone())?;
            Ok(Material::printed_cloth(Arc::new(texture)))
        });
        Ok(Self {
            cloths: cloths.collect::<Result<_, RenderError>>()?,
            parts: dancer_materials(&production.dancer)?,
            adornments: adornment_materials(&production.adornments),
            print_uvs: (production.garments.iter().zip(&prints))
                .map(|(garment, print)| {
                    (garment.mesh).on_print(print, &garment.draft, garment.flounce.as_ref())
                })
                .collect(),
            dressed: (production.dressed.iter())
                .map(|garment| dressed_look(design, garment))
                .collect::<Result<_, LookError>>()?,
            prints,
        })
    }

    /// The scene of one moment in the studio: first the garments, then the parts of the dancer,
    /// then the adornments.
    #[must_use]
    pub fn scene<'a>(
        &'a self,
        production: &'a Production,
        figure: &Figure<'a>,
        camera: Camera,
        lights: LightRig,
    ) -> Scene<'a> {
        let mut scene = Scene {
            lights,
            ..Scene::studio(camera)
        };
        let worn = production.garments.iter().zip(figure.cloths).enumerate();
        let looks = self.cloths.iter().zip(&self.print_uvs);
        for ((place, (garment, [positions, normals])), (material, uvs)) in worn.zip(looks) {
            scene.meshes.push(SceneMesh {
                positions,
                normals,
                uvs,
                colors: figure.cloth_colors.get(place).map_or(&[], Vec::as_slice),
                triangles: &garment.mesh.triangles,
                material,
            });
        }
        let dressed = production.dressed.iter().zip(figure.dressed);
        for ((garment, [positions, normals]), look) in dressed.zip(&self.dressed) {
            scene.meshes.push(SceneMesh {
                positions,
                normals,
                uvs: &look.uvs,
                colors: &[],
                triangles: &garment.dressed.triangles,
                material: &look.cloth,
            });
        }
        let skin = &production.dancer.skin;
        let [positions, normals] = figure.body;
        for (part, (_, material)) in skin.parts.iter().zip(&self.parts) {
            scene.meshes.push(SceneMesh {
                positions,
                normals,
                uvs: &skin.uvs,
                colors: &[],
                triangles: &part.triangles,
                material,
            });
        }
        let surfaces = production.adornments.iter().flat_map(|one| &one.surfaces);
        let posed = figure.adornments.iter().zip(&self.adornments);
        for (surface, ([positions, normals], material)) in surfaces.zip(posed) {
            scene.meshes.push(SceneMesh {
                positions,
                normals,
                uvs: &[],
                colors: &surface.colors,
                triangles: &surface.triangles,
                material,
            });
        }
        scene
    }
}

/// The cloth of a dressed garment, cut from its print.
fn dressed_look(design: &Design, garment: &DressedGarment) -> Result<DressedLook, LookError> {
    let listed = &design.garments[garment.listed];
    let print = listed.print().image(PRINT_SIDE, listed.fabric().width())?;
    let texture = Texture::new(print.width, print.height, print.pixels.clone())?;
    let uv_from_cloth = print.uv_from_cloth();
    let uvs = garment.dressed.on_cloth.iter();
    Ok(DressedLook {
        cloth: Material::printed_cloth(Arc::new(texture)),
        uvs: uvs.map(|&at| uv_from_cloth.transform_point2(at)).collect(),
        print,
    })
}

/// The materials of all surfaces of adornments, one after the other; their colors are the vertices'.
#[must_use]
pub fn adornment_materials(adornments: &[Adornment]) -> Vec<Material> {
    let surfaces = adornments.iter().flat_map(|one| &one.surfaces);
    surfaces
        .map(|surface| finish_material(surface.finish))
        .collect()
}

fn finish_material(finish: Finish) -> Material {
    let thin = Material {
        base_color: [1.0; 3],
        sides: Sides::Both,
        ..Material::default()
    };
    match finish {
        Finish::Leaf => Material {
            roughness: 0.52,
            specular: 0.035,
            translucency: 0.22,
            wrap: 0.15,
            ..thin
        },
        Finish::Petal => Material {
            roughness: 0.80,
            specular: 0.02,
            sheen: 0.15,
            translucency: 0.30,
            wrap: 0.25,
            ..thin
        },
        Finish::Feather => Material {
            roughness: 0.90,
            specular: 0.02,
            sheen: 0.35,
            translucency: 0.18,
            wrap: 0.20,
            ..thin
        },
        Finish::Fiber => Material {
            roughness: 0.85,
            specular: 0.02,
            sheen: 0.10,
            wrap: 0.12,
            ..thin
        },
        Finish::Wood => Material {
            roughness: 0.36,
            specular: 0.045,
            ..thin
        },
        Finish::Film => Material {
            roughness: 0.20,
            specular: 0.20,
            translucency: 0.35,
            wrap: 0.10,
            ..thin
        },
    }
}

/// The materials of a dancer's parts, in the order of her skin's.
///
/// # Errors
/// A picture that cannot be a texture.
pub fn dancer_materials(dancer: &Dancer) -> Result<Vec<(PartKind, Material)>, RenderError> {
    let texture = |picture: BodyPicture| {
        Texture::new(picture.side, picture.side, picture.pixels).map(Arc::new)
    };
    let paint = Paint {
        appearance: &dancer.appearance,
        face: texture(dancer.face_picture())?,
        hair: texture(dancer.hair_picture())?,
    };
    let parts = dancer.skin.parts.iter().enumerate().map(|(place, part)| {
        let material = match dancer.skin.looks.get(place) {
            Some(look) => look_material(look)?,
            None => part_material(part.kind, &paint),
        };
        Ok((part.kind, material))
    });
    parts.collect()
}

/// The colors and pictures on the body.
struct Paint<'a> {
    appearance: &'a Appearance,
    face: Arc<Texture>,
    hair: Arc<Texture>,
}

/// A part of a given body: its base color and picture, lit softly as skin is.
fn look_material(look: &Look) -> Result<Material, RenderError> {
    let texture = |picture: &lole_body::SkinPicture| {
        Texture::new(picture.width, picture.height, picture.pixels.clone()).map(Arc::new)
    };
    Ok(Material {
        base_color: look.base_color,
        texture: look.picture.as_deref().map(texture).transpose()?,
        roughness: look.roughness.max(0.45),
        specular: 0.03,
        wrap: 0.2,
        sides: if look.is_two_sided {
            Sides::Both
        } else {
            Sides::Outward
        },
        ..Material::default()
    })
}

fn part_material(kind: PartKind, paint: &Paint<'_>) -> Material {
    match kind {
        PartKind::Skin | PartKind::Given => Material::skin(linear(paint.appearance.skin_srgb)),
        PartKind::Face => Material {
            texture: Some(Arc::clone(&paint.face)),
            ..Material::skin([1.0; 3])
        },
        PartKind::Leotard => Material {
            roughness: 0.75,
            sheen: 0.15,
            ..Material::cloth(linear(paint.appearance.leotard_srgb))
        },
        // Lit as skin is: at the hairline it shows skin.
        PartKind::Hair => Material {
            texture: Some(Arc::clone(&paint.hair)),
            roughness: 0.62,
            specular: 0.02,
            ..Material::skin([1.0; 3])
        },
        PartKind::Flower => Material::cloth(linear(appearance::FLOWER_SRGB)),
        PartKind::FlowerHeart => Material::cloth(linear(appearance::FLOWER_HEART_SRGB)),
    }
}

/// Linear light of an sRGB-encoded color.
#[must_use]
pub fn linear(srgb: [u8; 3]) -> [f32; 3] {
    srgb.map(|byte| linear_from_srgb(f32::from(byte) / 255.0))
}
