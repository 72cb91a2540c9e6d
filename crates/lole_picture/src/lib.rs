//! What the camera sees of a performance: the materials of dancer and skirt, and the meshes of one
//! moment as a scene. Films, stills and the live window show the same.
//!
//! It opens nothing and draws nothing: [`lole_render`] does.

use std::sync::Arc;

use glam::Vec3;
use lole_body::{BodyPicture, PartKind, appearance};
use lole_costume::document::Design;
use lole_costume::print::{self, PrintImage};
use lole_render::srgb::linear_from_srgb;
use lole_render::{Camera, LightRig, Material, RenderError, Scene, SceneMesh, Texture};
use lole_stage::Production;

/// Pixels of one print repeat: a repeat of 45 cm shows every petal from two meters.
const PRINT_SIDE: u32 = 1024;

/// The materials of one production.
pub struct Looks {
    /// The skirt's cloth.
    pub cloth: Material,
    /// The dancer's parts, in the order of her skin's.
    pub parts: Vec<(PartKind, Material)>,
    /// The print, for files that carry it.
    pub print: PrintImage,
}

/// Dancer and skirt in one moment, as they are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Figure<'a> {
    /// Vertices of the skirt [m], the seam's column twice (see
    /// [`SkirtMesh::spread`](lole_costume::sew::SkirtMesh::spread)).
    pub cloth_positions: &'a [Vec3],
    /// Their outward normals.
    pub cloth_normals: &'a [Vec3],
    /// Linear color factors of the skirt's vertices; may be empty.
    pub cloth_colors: &'a [Vec3],
    /// Posed vertices of the body [m].
    pub body_positions: &'a [Vec3],
    /// Their normals.
    pub body_normals: &'a [Vec3],
}

impl Looks {
    /// Draws print, face and hair once.
    ///
    /// # Errors
    /// A picture that cannot be a texture.
    pub fn new(design: &Design, production: &Production) -> Result<Self, RenderError> {
        let print = print::draw(&design.print.print(), PRINT_SIDE);
        let texture = Arc::new(Texture::new(
            print.width,
            print.height,
            print.pixels.clone(),
        )?);
        let paint = Paint::new()?;
        let kinds = (production.dancer.skin.parts.iter()).map(|part| part.kind);
        let parts = kinds
            .map(|kind| (kind, part_material(kind, &paint)))
            .collect();
        Ok(Self {
            cloth: Material::printed_cloth(texture),
            parts,
            print,
        })
    }

    /// The scene of one moment in the studio.
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
        let mesh = &production.skirt_mesh;
        scene.meshes.push(SceneMesh {
            positions: figure.cloth_positions,
            normals: figure.cloth_normals,
            uvs: &mesh.uvs,
            colors: figure.cloth_colors,
            triangles: &mesh.triangles,
            material: &self.cloth,
        });
        let skin = &production.dancer.skin;
        for (part, (_, material)) in skin.parts.iter().zip(&self.parts) {
            scene.meshes.push(SceneMesh {
                positions: figure.body_positions,
                normals: figure.body_normals,
                uvs: &skin.uvs,
                colors: &[],
                triangles: &part.triangles,
                material,
            });
        }
        scene
    }
}

/// The pictures on the body.
struct Paint {
    face: Arc<Texture>,
    hair: Arc<Texture>,
}

impl Paint {
    fn new() -> Result<Self, RenderError> {
        let texture = |picture: BodyPicture| {
            Texture::new(picture.side, picture.side, picture.pixels).map(Arc::new)
        };
        Ok(Self {
            face: texture(appearance::face_texture())?,
            hair: texture(appearance::hair_texture())?,
        })
    }
}

fn part_material(kind: PartKind, paint: &Paint) -> Material {
    match kind {
        PartKind::Skin => Material::skin(linear(appearance::SKIN_SRGB)),
        PartKind::Face => Material {
            texture: Some(Arc::clone(&paint.face)),
            ..Material::skin([1.0; 3])
        },
        PartKind::Leotard => Material {
            roughness: 0.75,
            sheen: 0.15,
            ..Material::cloth(linear(appearance::LEOTARD_SRGB))
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
