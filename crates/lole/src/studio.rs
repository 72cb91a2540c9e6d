//! What the camera sees: materials, light and viewpoints of the pictures.

use std::sync::Arc;

use anyhow::Result;
use glam::Vec3;
use lole_body::{BodyPicture, Bone, PartKind, appearance};
use lole_costume::print::{self, PrintImage};
use lole_geom::trig;
use lole_render::{
    Bounds, Camera, Image, LightRig, Material, Renderer, Scene, SceneMesh, Size, Texture, View,
};
use lole_stage::Performance;

/// Pixels of one print repeat: a repeat of 45 cm shows every petal from two meters.
const PRINT_SIDE: u32 = 1024;

/// Everything that pictures of one production share.
pub(crate) struct Studio {
    cloth: Material,
    parts: Vec<(PartKind, Material)>,
    /// The print, for files that carry it.
    pub(crate) print: PrintImage,
}

/// One named still.
pub(crate) struct Still {
    pub(crate) file: &'static str,
    pub(crate) caption_en: &'static str,
    pub(crate) caption_ja: &'static str,
    pub(crate) view: View,
}

/// The stills of every run, the poster first.
pub(crate) const STILLS: [Still; 4] = [
    Still {
        file: "three-quarter.png",
        caption_en: "Three-quarter",
        caption_ja: "斜め前",
        view: View::ThreeQuarter,
    },
    Still {
        file: "front.png",
        caption_en: "Front",
        caption_ja: "正面",
        view: View::Front,
    },
    Still {
        file: "side.png",
        caption_en: "Side",
        caption_ja: "横",
        view: View::Side,
    },
    Still {
        file: "back.png",
        caption_en: "Back",
        caption_ja: "後ろ",
        view: View::Back,
    },
];

impl Studio {
    /// Draws print and face once.
    pub(crate) fn new(performance: &Performance) -> Result<Self> {
        let design = &performance.production().design;
        let print = print::draw(&design.print.print(), PRINT_SIDE);
        let texture = Arc::new(Texture::new(
            print.width,
            print.height,
            print.pixels.clone(),
        )?);
        let paint = Paint::new()?;
        let kinds = performance
            .production()
            .dancer
            .skin
            .parts
            .iter()
            .map(|part| part.kind);
        let parts = kinds
            .map(|kind| (kind, part_material(kind, &paint)))
            .collect();
        Ok(Self {
            cloth: Material::printed_cloth(texture),
            parts,
            print,
        })
    }

    /// The picture of the performance's current frame; its body must be posed.
    pub(crate) fn shoot(
        &self,
        performance: &Performance,
        camera: Camera,
        lights: LightRig,
        renderer: &mut Renderer,
    ) -> Result<Image> {
        let production = performance.production();
        let mesh = &production.skirt_mesh;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        mesh.spread(performance.cloth_positions(), &mut positions);
        mesh.spread(&performance.cloth_normals(), &mut normals);
        let mut scene = Scene {
            lights,
            ..Scene::studio(camera)
        };
        scene.meshes.push(SceneMesh {
            positions: &positions,
            normals: &normals,
            uvs: &mesh.uvs,
            colors: &[],
            triangles: &mesh.triangles,
            material: &self.cloth,
        });
        for (part, (_, material)) in production.dancer.skin.parts.iter().zip(&self.parts) {
            scene.meshes.push(SceneMesh {
                positions: performance.body_positions(),
                normals: performance.body_normals(),
                uvs: &production.dancer.skin.uvs,
                colors: &[],
                triangles: &part.triangles,
                material,
            });
        }
        Ok(renderer.render(&scene)?)
    }
}

/// The pictures on the body.
struct Paint {
    face: Arc<Texture>,
    hair: Arc<Texture>,
}

impl Paint {
    fn new() -> Result<Self> {
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

/// Linear light of an sRGB-encoded color (IEC 61966-2-1).
pub(crate) fn linear(srgb: [u8; 3]) -> [f32; 3] {
    srgb.map(|byte| {
        let value = f32::from(byte) / 255.0;
        if value <= 0.040_45 {
            value / 12.92
        } else {
            trig::powf((value + 0.055) / 1.055, 2.4)
        }
    })
}

/// The camera of a still: the whole dancer with her skirt.
pub(crate) fn still_camera(performance: &Performance, view: View, size: Size) -> Camera {
    Camera::framing(bounds_now(performance), view, size.aspect())
}

fn bounds_now(performance: &Performance) -> Bounds {
    let body = Bounds::of(performance.body_positions());
    let cloth = Bounds::of(performance.cloth_positions());
    let around = match (body, cloth) {
        (Some(body), Some(cloth)) => body.union(cloth),
        (Some(one), None) | (None, Some(one)) => one,
        (None, None) => Bounds {
            min: Vec3::ZERO,
            max: Vec3::ONE,
        },
    };
    // The floor in front of the feet belongs to the picture.
    Bounds {
        min: around.min.min(Vec3::new(around.min.x, 0.0, around.min.z)),
        ..around
    }
}

/// The film's camera: it follows the hips softly, as a hand would, and drifts from the front to
/// the dancer's side and back.
pub(crate) struct FilmCamera {
    center: Vec3,
    velocity: Vec3,
}

/// How quickly the camera follows [1/s]: it lags by half a second.
const FOLLOW_RATE: f32 = 2.0;
/// Largest drift to either side [rad].
const DRIFT: f32 = 0.6;
/// Time of one drift from side to side and back [s].
const DRIFT_PERIOD: f32 = 16.0;

impl FilmCamera {
    pub(crate) fn new(performance: &Performance) -> Self {
        Self {
            center: hips(performance),
            velocity: Vec3::ZERO,
        }
    }

    /// Moves on by `dt` [s] and gives the view at the performance's time (critically damped).
    pub(crate) fn advance(&mut self, performance: &Performance, dt: f32, size: Size) -> Camera {
        let pull = (hips(performance) - self.center) * FOLLOW_RATE * FOLLOW_RATE;
        self.velocity += (pull - self.velocity * (2.0 * FOLLOW_RATE)) * dt;
        self.center += self.velocity * dt;
        let stature = performance.production().dancer.landmarks.crown_height;
        let reach = 0.56 * stature;
        let middle = Vec3::new(self.center.x, 0.0, self.center.z);
        let bounds = Bounds {
            min: middle + Vec3::new(-reach, 0.0, -0.35),
            max: middle + Vec3::new(reach, 1.06 * stature, 0.35),
        };
        let phase = std::f32::consts::TAU * performance.time() / DRIFT_PERIOD;
        Camera::framing(
            bounds,
            View::Turned(DRIFT * trig::sin(phase)),
            size.aspect(),
        )
    }
}

fn hips(performance: &Performance) -> Vec3 {
    let joint = performance.production().dancer.skeleton.joint(Bone::Hips);
    performance.world_from_bind()[Bone::Hips.index()].transform_point3(joint)
}
