//! What the camera sees of a performance: the materials of dancer and garments, the meshes of one moment as
//! a scene, viewpoints, and all moments of a dance as a 3D file. Films, stills, the live window and that file
//! show the same.
//!
//! It opens nothing and draws nothing: [`lole_render`] does. What becomes a file is given back as bytes.

pub mod alive;
pub mod baked;
pub mod film;
pub mod group;
mod moment;
pub mod portrait;
mod sets;
pub mod studio;
pub mod taken;
pub mod vrm;

use std::sync::{Arc, Mutex, PoisonError};

use glam::{Vec2, Vec3};
use lole_body::{Appearance, BodyPicture, Dancer, Look, PartKind, appearance};
use lole_costume::document::{Design, PrintError};
use lole_garment::adorn::AdornmentFinish;
use lole_geom::finer::Finer;
use lole_print::PrintImage;
use lole_render::srgb::linear_from_srgb;
use lole_render::{Camera, Material, RenderError, Scene, SceneMesh, Sides, Texture};
use lole_stage::{Production, WornSurface};
pub use moment::{DrawnDancer, Moment, drawn_body};
use sets::StageLook;
pub use sets::{Lamps, Scenery};

/// Pixels of one print repeat: a repeat of 45 cm shows every petal from two meters.
const PRINT_SIDE: u32 = 1024;
/// The same where nothing is seen from near by.
const PRINT_SIDE_AFAR: u32 = 512;

/// All that is drawn of one production, without the production: whoever shows a moment of it needs nothing else.
pub struct Looks {
    /// What she wears or holds, surface by surface as [`Production::surfaces`] has them.
    pub worn: Vec<Cover>,
    /// The dancer's parts, in the order of her skin's.
    pub parts: Vec<BodyPart>,
    /// Where the vertices of her skin lie on its pictures.
    pub skin_uvs: Vec<Vec2>,
    /// Linear factors on the colors of her vertices; empty where there are none.
    pub skin_colors: Vec<Vec3>,
    /// Her skin, finer, as it is photographed; `None` where that is not asked for or it is drawn as it is.
    pub finer_skin: Option<FinerSkin>,
    /// Single strands of her hair; `None` where there are none.
    pub strands: Option<Strands>,
    /// What is around her.
    pub scenery: Scenery,
}

/// How single strands of hair look.
pub struct Strands {
    /// Their material.
    pub material: Material,
    /// Where they lie in its picture.
    pub uvs: Vec<Vec2>,
    /// Their triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// How one part of the dancer looks.
pub struct BodyPart {
    /// Its material.
    pub material: Material,
    /// Its triangles, by vertices of her skin.
    pub triangles: Vec<[u32; 3]>,
}

/// A dancer's skin as it is photographed from near by.
pub struct FinerSkin {
    /// How it is made of her skin.
    pub finer: Finer,
    /// Triangles of each part, in their order.
    pub parts: Vec<Vec<[u32; 3]>>,
    /// Where its vertices lie on the pictures of the skin.
    pub uvs: Vec<Vec2>,
    /// Linear factors on their colors; empty where there are none.
    pub colors: Vec<Vec3>,
}

impl FinerSkin {
    /// That of a dancer; `None` of a body that is drawn as it is.
    #[must_use]
    pub fn of(dancer: &Dancer) -> Option<Self> {
        let drawn = dancer.drawn_body.as_ref()?;
        let (skin, finer) = (&drawn.mesh, drawn.finer());
        let mut rounded = finer.triangles.as_slice();
        let parts = skin.parts.iter().map(|part| {
            if !part.kind.is_rounded() {
                return part.triangles.clone();
            }
            let (own, rest) = rounded.split_at(Finer::TIMES * part.triangles.len());
            rounded = rest;
            own.to_vec()
        });
        Some(Self {
            parts: parts.collect(),
            uvs: finer.spread(&skin.uvs),
            colors: finer.spread(&skin.colors),
            finer,
        })
    }
}

/// How one surface of what is worn looks.
pub struct Cover {
    /// Its material.
    pub material: Material,
    /// Its triangles, by its drawn vertices.
    pub triangles: Vec<[u32; 3]>,
    /// Linear color factors of its vertices; none where the material says all.
    pub colors: Vec<Vec3>,
    /// Whether it is cloth.
    pub is_cloth: bool,
    /// Where its vertices lie on the print, in repeats; none where it is no cloth.
    pub uvs: Vec<Vec2>,
    /// The print, for files that carry it; `None` where it is no cloth.
    pub print: Option<PrintImage>,
    /// The same, finer, as it is photographed; `None` where that is not asked for or it is fine enough.
    pub finer: Option<FinerCover>,
}

/// A surface of what is worn as it is photographed from near by.
pub struct FinerCover {
    /// How it is made of the surface.
    pub finer: Finer,
    /// Where its vertices lie on the print, in repeats.
    pub uvs: Vec<Vec2>,
}

impl FinerCover {
    fn of(surface: WornSurface<'_>, uvs: &[Vec2]) -> Option<Self> {
        let finer = surface.finer()?;
        Some(Self {
            uvs: finer.spread(uvs),
            finer,
        })
    }
}

impl Cover {
    /// Triangles and places on the print of so many vertices of it.
    fn drawn(&self, count: usize) -> (&[[u32; 3]], &[Vec2]) {
        let finer = self.finer.as_ref().filter(|it| it.finer.count() == count);
        finer.map_or((&self.triangles, &self.uvs), |it| {
            (&it.finer.triangles, &it.uvs)
        })
    }
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

impl Strands {
    /// Those of a dancer whose parts have these materials; `None` where she has none.
    #[must_use]
    pub fn of(dancer: &Dancer, materials: &[(PartKind, Material)]) -> Option<Self> {
        let (_, hair) = materials.iter().find(|(kind, _)| *kind == PartKind::Hair)?;
        let strands = &dancer.drawn_body.as_ref()?.strands;
        let triangles = strands.parts.iter().flat_map(|part| &part.triangles);
        Some(Self {
            material: strand_material(hair),
            uvs: strands.uvs.clone(),
            triangles: triangles.copied().collect(),
        })
    }

    /// Their mesh, with its posed vertices [m] and normals.
    #[must_use]
    pub fn mesh<'a>(&'a self, [positions, normals]: [&'a [Vec3]; 2]) -> SceneMesh<'a> {
        SceneMesh {
            positions,
            normals,
            uvs: &self.uvs,
            colors: &[],
            triangles: &self.triangles,
            material: &self.material,
        }
    }
}

impl Looks {
    /// Draws prints and hair once, with what [`Moment::photographed`] rounds.
    ///
    /// # Errors
    /// A picture that was not read or cannot be a texture.
    pub fn photographed(design: &Design, production: &Production) -> Result<Self, LookError> {
        let mut looks = Self::new(design, production)?;
        looks.finer_skin = FinerSkin::of(&production.dancer);
        for (cover, surface) in looks.worn.iter_mut().zip(production.surfaces()) {
            cover.finer = FinerCover::of(surface, &cover.uvs);
        }
        Ok(looks)
    }

    /// Draws prints and hair once.
    ///
    /// # Errors
    /// A picture that was not read or cannot be a texture.
    pub fn new(design: &Design, production: &Production) -> Result<Self, LookError> {
        Self::with_prints(design, production, PRINT_SIDE)
    }

    /// The same for a picture in which a repeat of a print is some hundred pixels wide.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn from_afar(design: &Design, production: &Production) -> Result<Self, LookError> {
        Self::with_prints(design, production, PRINT_SIDE_AFAR)
    }

    fn with_prints(design: &Design, production: &Production, side: u32) -> Result<Self, LookError> {
        let surfaces = production.surfaces();
        let skin = production.dancer.drawn();
        let materials = dancer_materials(&production.dancer)?;
        let strands = Strands::of(&production.dancer, &materials);
        let parts = skin.parts.iter().zip(materials);
        Ok(Self {
            worn: surfaces
                .map(|surface| cover(design, surface, side))
                .collect::<Result<_, _>>()?,
            parts: parts
                .map(|(part, (_, material))| BodyPart {
                    material,
                    triangles: part.triangles.clone(),
                })
                .collect(),
            skin_uvs: skin.uvs.clone(),
            skin_colors: skin.colors.clone(),
            finer_skin: None,
            strands,
            scenery: Scenery::of(&design.stage),
        })
    }

    /// The scene of one moment in its set: first the cloth, then the parts of the dancer, then what she
    /// wears beside the cloth.
    #[must_use]
    pub fn scene<'a>(
        &'a self,
        dancer: &DrawnDancer<'a>,
        camera: Camera,
        lamps: Lamps,
    ) -> Scene<'a> {
        self.scene_in((self.scenery, lamps), dancer, camera)
    }

    /// The same in other surroundings, as while the lamps of a theater say something else.
    #[must_use]
    pub fn scene_in<'a>(
        &'a self,
        around: (Scenery, Lamps),
        dancer: &DrawnDancer<'a>,
        camera: Camera,
    ) -> Scene<'a> {
        Self::stage(&[(self, *dancer)], around, camera)
    }

    /// The scene of one moment of several dancers in a set, each as [`Looks::scene`] has her.
    #[must_use]
    pub fn stage<'a>(
        dancers: &[(&'a Self, DrawnDancer<'a>)],
        (scenery, lamps): (Scenery, Lamps),
        camera: Camera,
    ) -> Scene<'a> {
        let (lights, background, ground) = StageLook::of(scenery).around(&camera, lamps);
        let meshes = dancers
            .iter()
            .flat_map(|(looks, dancer)| looks.meshes(dancer));
        Scene {
            meshes: meshes.collect(),
            camera,
            lights,
            background,
            ground: Some(ground),
        }
    }

    /// The meshes of one moment: cloth, parts of the dancer, what she wears beside the cloth.
    fn meshes<'a>(&'a self, dancer: &DrawnDancer<'a>) -> Vec<SceneMesh<'a>> {
        let worn = dancer.worn.iter().zip(&self.worn).enumerate();
        let worn = worn.map(|(place, (vertices, cover))| {
            let colors = dancer.colors.get(place).filter(|colors| !colors.is_empty());
            let (triangles, uvs) = cover.drawn(vertices[0].len());
            SceneMesh {
                positions: &vertices[0],
                normals: &vertices[1],
                uvs,
                colors: colors.unwrap_or(&cover.colors),
                triangles,
                material: (dancer.colored)
                    .filter(|_| colors.is_some())
                    .unwrap_or(&cover.material),
            }
        });
        let [positions, normals] = dancer.body;
        let finer = (self.finer_skin.as_ref()).filter(|it| it.finer.count() == positions.len());
        let parts = self.parts.iter().enumerate().map(|(place, part)| {
            let (uvs, colors, triangles) = finer.map_or(
                (&self.skin_uvs, &self.skin_colors, &part.triangles),
                |finer| (&finer.uvs, &finer.colors, &finer.parts[place]),
            );
            SceneMesh {
                positions,
                normals,
                uvs,
                colors,
                triangles,
                material: &part.material,
            }
        });
        let cloth_count = self.worn.iter().filter(|cover| cover.is_cloth).count();
        let [positions, normals] = dancer.strands;
        let strands = (self.strands.iter()).map(|strands| strands.mesh([positions, normals]));
        let strands = strands.filter(|mesh| mesh.uvs.len() == mesh.positions.len());
        let mut meshes: Vec<SceneMesh<'a>> = worn.collect();
        let beside = meshes.split_off(cloth_count);
        meshes.extend(parts.chain(strands));
        meshes.extend(beside);
        meshes
    }
}

/// How a surface looks: cut from its print, drawn with so many pixels on a `side`, or of what it is made.
fn cover(design: &Design, surface: WornSurface<'_>, side: u32) -> Result<Cover, LookError> {
    if let Some(beside) = surface.beside() {
        return Ok(Cover {
            material: finish_material(beside.finish),
            triangles: surface.triangles().to_vec(),
            colors: beside.colors.clone(),
            is_cloth: false,
            uvs: Vec::new(),
            print: None,
            finer: None,
        });
    }
    let (fabric, print) = design.cloth_of(surface.worn().listed());
    let print = print.image(side, fabric.width())?;
    let texture = Texture::new(print.width, print.height, print.pixels.clone())?;
    let uvs = match surface {
        WornSurface::Gathered(garment) => {
            (garment.mesh).on_print(&print, &garment.draft, garment.flounce.as_ref())
        }
        WornSurface::Sewn(garment) => {
            let uv_from_cloth = print.uv_from_cloth();
            let on_cloth = garment.dressed.on_cloth.iter();
            on_cloth
                .map(|&at| uv_from_cloth.transform_point2(at))
                .collect()
        }
        WornSurface::Beside(..) => Vec::new(),
    };
    Ok(Cover {
        finer: None,
        material: Material::printed_cloth(Arc::new(texture)),
        triangles: surface.triangles().to_vec(),
        colors: Vec::new(),
        is_cloth: true,
        uvs,
        print: Some(print),
    })
}

fn finish_material(finish: AdornmentFinish) -> Material {
    let thin = Material {
        base_color: [1.0; 3],
        sides: Sides::Both,
        ..Material::default()
    };
    match finish {
        AdornmentFinish::Leaf => Material {
            roughness: 0.52,
            specular: 0.035,
            translucency: 0.22,
            wrap: 0.15,
            ..thin
        },
        AdornmentFinish::Petal => Material {
            roughness: 0.80,
            specular: 0.02,
            sheen: 0.15,
            translucency: 0.30,
            wrap: 0.25,
            ..thin
        },
        AdornmentFinish::Feather => Material {
            roughness: 0.90,
            specular: 0.02,
            sheen: 0.35,
            translucency: 0.18,
            wrap: 0.20,
            ..thin
        },
        AdornmentFinish::Fiber => Material {
            roughness: 0.85,
            specular: 0.02,
            sheen: 0.10,
            wrap: 0.12,
            ..thin
        },
        AdornmentFinish::Wood => Material {
            roughness: 0.36,
            specular: 0.045,
            ..thin
        },
        AdornmentFinish::Film => Material {
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
    let paint = Paint {
        appearance: &dancer.appearance,
        hair: painted_hair(dancer)?,
    };
    let drawn = dancer.drawn();
    let parts = drawn.parts.iter().enumerate().map(|(place, part)| {
        let material = match drawn.looks.get(place) {
            Some(look) => look_material(look)?,
            None => part_material(part.kind, &paint),
        };
        Ok((part.kind, material))
    });
    parts.collect()
}

/// Pictures of hair that are kept, five megabytes each.
const KEPT_HAIR: usize = 4;

/// The picture of her hair; painted once for all who have the same colors, because it takes longer than a dancer's
/// place in a small picture.
fn painted_hair(dancer: &Dancer) -> Result<Arc<Texture>, RenderError> {
    type Colors = [[u8; 3]; 2];
    static KEPT: Mutex<Vec<(Colors, Arc<Texture>)>> = Mutex::new(Vec::new());
    let colors = [dancer.appearance.skin_srgb, dancer.appearance.hair_srgb];
    let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, hair)) = kept().iter().find(|(of, _)| *of == colors) {
        return Ok(Arc::clone(hair));
    }
    let BodyPicture { side, pixels } = dancer.hair_picture();
    let hair = Arc::new(Texture::new(side, side, pixels)?);
    let mut kept = kept();
    kept.truncate(KEPT_HAIR - 1);
    kept.insert(0, (colors, Arc::clone(&hair)));
    Ok(hair)
}

/// The colors and pictures on the body.
struct Paint<'a> {
    appearance: &'a Appearance,
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
        PartKind::Skin | PartKind::Face | PartKind::Given => {
            Material::skin(linear(paint.appearance.skin_srgb))
        }
        PartKind::Nail => Material {
            roughness: 0.32,
            specular: 0.04,
            ..Material::skin(nail_color(paint.appearance))
        },
        PartKind::Eye => Material {
            roughness: 0.12,
            specular: 0.045,
            ..Material::skin([1.0; 3])
        },
        PartKind::Brow => Material::skin([1.0; 3]),
        PartKind::Lash => Material {
            sides: Sides::Both,
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
            ..Material::hair([1.0; 3])
        },
        PartKind::Flower => Material::cloth(linear(appearance::FLOWER_SRGB)),
        PartKind::FlowerHeart => Material::cloth(linear(appearance::FLOWER_HEART_SRGB)),
    }
}

/// Single strands over hair of a material: they shine, and are seen from both sides.
fn strand_material(hair: &Material) -> Material {
    Material {
        roughness: 0.48,
        specular: 0.032,
        sheen: 0.06,
        sides: Sides::Both,
        ..Material {
            texture: hair.texture.clone(),
            ..Material::hair([1.0; 3])
        }
    }
}

/// Linear color of a dancer's nails.
pub(crate) fn nail_color(look: &Appearance) -> [f32; 3] {
    let skin = linear(look.skin_srgb);
    std::array::from_fn(|channel| (skin[channel] * appearance::NAIL_TONE[channel]).min(1.0))
}

/// Linear light of an sRGB-encoded color.
#[must_use]
pub fn linear(srgb: [u8; 3]) -> [f32; 3] {
    srgb.map(|byte| linear_from_srgb(f32::from(byte) / 255.0))
}

#[cfg(test)]
mod tests {
    use lole_body::Measurements;

    use super::*;

    /// Hair of equal colors is one picture, and of others is painted as it is.
    #[test]
    fn hair_is_painted_once_for_equal_colors() {
        let mut dancer =
            Dancer::to_measure(&Measurements::woman(), &Appearance::default()).unwrap();
        let first = painted_hair(&dancer).unwrap();
        assert!(Arc::ptr_eq(&first, &painted_hair(&dancer).unwrap()));
        for gray in 1..=u8::try_from(KEPT_HAIR).unwrap() {
            dancer.appearance.hair_srgb = [40 * gray; 3];
            let BodyPicture { side, pixels } = dancer.hair_picture();
            let expected = Texture::new(side, side, pixels).unwrap();
            assert_eq!(*painted_hair(&dancer).unwrap(), expected);
        }
        dancer.appearance = Appearance::default();
        assert_eq!(painted_hair(&dancer).unwrap(), first);
    }
}
