//! `dancer.glb`: the recorded run as a file for other programs.

mod keys;
pub(crate) mod worn;

pub use keys::Keys;

use lole_avatar::License;
use lole_body::{Appearance, BodyPicture, Dancer, DrawnBody, Look, PartKind, appearance};
use lole_export::glb::{
    GlbFile, GlbMaterial, GlbMesh, GlbPart, GlbScene, GlbShape, GlbSides, MOST_TARGETS, write_glb,
};
use lole_export::still::encode_png;
use lole_export::{ExportError, ImageView};
use lole_stage::{FRAMES_PER_SECOND, Performance};

use crate::{Cover, alive, linear, nail_color};

/// Keys of the baked motion per second, the best first: fewer where cloth can then be written as it moved.
const KEY_RATES: [u32; 3] = [15, 12, 10];

/// Keys a second of a dance of so many simulated frames.
#[must_use]
pub fn key_rate(frame_count: u32) -> u32 {
    let fits = |rate: &u32| {
        let keys = frame_count.div_ceil(FRAMES_PER_SECOND / rate);
        keys as usize <= MOST_TARGETS + 1
    };
    KEY_RATES.into_iter().find(fits).unwrap_or(KEY_RATES[0])
}

fn body_png(picture: &BodyPicture) -> Result<Vec<u8>, ExportError> {
    let image = ImageView::new(picture.side, picture.side, &picture.pixels)?;
    encode_png(image)
}

/// Pictures on the dancer, as a file carries them.
pub(crate) struct BodyPictures {
    hair: Vec<u8>,
    /// Of each part of a given skin.
    looks: Vec<Option<Vec<u8>>>,
}

impl BodyPictures {
    pub(crate) fn of(dancer: &Dancer) -> Result<Self, ExportError> {
        let looks = dancer.drawn().looks.iter().map(look_png);
        Ok(Self {
            hair: body_png(&dancer.hair_picture())?,
            looks: looks.collect::<Result<_, _>>()?,
        })
    }

    /// The parts of her skin with their materials.
    pub(crate) fn parts<'a>(&'a self, dancer: &'a Dancer) -> Vec<GlbPart<'a>> {
        let skin = dancer.drawn();
        let parts = skin.parts.iter().enumerate();
        parts
            .map(|(place, part)| GlbPart {
                triangles: &part.triangles,
                material: match (skin.looks.get(place), self.looks.get(place)) {
                    (Some(look), Some(png)) => look_material(look, png.as_deref()),
                    _ => material(part.kind, &dancer.appearance, &self.hair),
                },
            })
            .collect()
    }
}

/// Pictures a second of a blink, which keys of a dance are too far apart for.
const BLINK_RATE: f32 = 30.0;

/// How she blinks in a dance: the shapes of her face, and when they are on.
pub(crate) struct Blinking {
    shapes: Vec<GlbShape>,
    times: Vec<f32>,
}

impl Blinking {
    /// As long as a dance goes on, from its first time to its last [s]; nothing of a given body.
    pub(crate) fn of(dancer: &Dancer, times: &[f32]) -> Self {
        let Some(drawn) = &dancer.drawn_body else {
            return Self {
                shapes: Vec::new(),
                times: Vec::new(),
            };
        };
        let ends = [times.first(), times.last()].map(|time| time.copied().unwrap_or_default());
        let step = |index: u16| ends[0] + f32::from(index) / BLINK_RATE;
        let times: Vec<f32> = if ends[0] < ends[1] {
            let times = (0..u16::MAX).map(step);
            times.take_while(|time| *time <= ends[1]).collect()
        } else {
            Vec::new()
        };
        let shapes = ["eyes_half_closed", "eyes_closed"].into_iter().enumerate();
        let shapes = shapes.map(|(shape, name)| GlbShape {
            name,
            moved: (drawn.closing())
                .map(|(vertex, moved)| (vertex, moved[shape]))
                .collect(),
            weights: (times.iter())
                .map(|&time| DrawnBody::closing_shares(alive::blink(time))[shape])
                .collect(),
        });
        Self {
            shapes: shapes.collect(),
            times,
        }
    }
}

pub(crate) fn skinned<'a>(
    dancer: &'a Dancer,
    parts: &'a [GlbPart<'a>],
    blinking: &'a Blinking,
) -> GlbMesh<'a> {
    let skin = dancer.drawn();
    GlbMesh {
        name: "dancer",
        positions: &skin.positions,
        normals: &skin.normals,
        uvs: &skin.uvs,
        colors: &skin.colors,
        joints: &skin.joints,
        weights: &skin.weights,
        parts,
        shapes: &blinking.shapes,
        shape_times: &blinking.times,
    }
}

/// The dancer alone, standing in her bind pose.
///
/// # Errors
/// A mesh or a picture that the file cannot carry.
pub fn body_glb(dancer: &Dancer) -> Result<Vec<u8>, ExportError> {
    let pictures = BodyPictures::of(dancer)?;
    let parts = pictures.parts(dancer);
    let file = write_glb(&GlbScene {
        skeleton: &dancer.skeleton,
        pose_times: &[],
        poses: &[],
        skinned: &[skinned(dancer, &parts, &Blinking::of(dancer, &[]))],
        cloths: &[],
        added: &[],
        extensions: &[],
    })?;
    Ok(file.bytes)
}

/// The file's bytes: dancer with skeleton and motion, garments with their baked motion and print;
/// `covers` are how they look, surface by surface.
///
/// # Errors
/// A mesh or a picture that the file cannot carry.
pub fn dancer_glb(
    performance: &Performance,
    keys: &Keys,
    covers: &[Cover],
) -> Result<GlbFile, ExportError> {
    let production = performance.production();
    let pictures = BodyPictures::of(&production.dancer)?;
    let parts = pictures.parts(&production.dancer);
    let worn = worn::Worn::of(production, covers)?;
    let ridden = worn.ridden();
    let blinking = Blinking::of(&production.dancer, &keys.times);
    let mut bodies = Vec::new();
    if !leaves_body_out(performance) {
        bodies.push(skinned(&production.dancer, &parts, &blinking));
    }
    bodies.extend(worn.skinned(&ridden));
    let frames = keys.by_surface();
    let cloths = worn.baked(&keys.times, &frames);
    write_glb(&GlbScene {
        skeleton: &production.dancer.skeleton,
        pose_times: &keys.times,
        poses: &keys.poses,
        skinned: &bodies,
        cloths: &cloths,
        added: &[],
        extensions: &[],
    })
}

/// Whether the dancer is an avatar whose license keeps it out of files.
#[must_use]
pub fn leaves_body_out(performance: &Performance) -> bool {
    is_kept_here(performance.production().license.as_ref())
}

/// Whether a license keeps an avatar out of files.
#[must_use]
pub fn is_kept_here(license: Option<&License>) -> bool {
    license.is_some_and(|license| license.export_refusal().is_some())
}

/// The picture of a part of an avatar.
fn look_png(look: &Look) -> Result<Option<Vec<u8>>, ExportError> {
    let Some(picture) = &look.picture else {
        return Ok(None);
    };
    let image = ImageView::new(picture.width, picture.height, &picture.pixels)?;
    Ok(Some(encode_png(image)?))
}

fn look_material<'a>(look: &'a Look, png: Option<&'a [u8]>) -> GlbMaterial<'a> {
    GlbMaterial {
        name: &look.name,
        base_color: look.base_color,
        roughness: look.roughness,
        sheen: 0.0,
        texture_png: png,
        sides: if look.is_two_sided {
            GlbSides::Both
        } else {
            GlbSides::Front
        },
    }
}

fn material<'a>(kind: PartKind, look: &Appearance, hair: &'a [u8]) -> GlbMaterial<'a> {
    let (name, color, roughness, texture_png) = match kind {
        PartKind::Skin | PartKind::Face | PartKind::Given => ("skin", look.skin_srgb, 0.6, None),
        PartKind::Nail => ("nails", look.skin_srgb, 0.3, None),
        PartKind::Eye => ("eyes", [255; 3], 0.15, None),
        PartKind::Brow => ("brows", [255; 3], 0.6, None),
        PartKind::Lash => ("lashes", [255; 3], 0.6, None),
        PartKind::Leotard => ("leotard", look.leotard_srgb, 0.8, None),
        PartKind::Hair => ("hair", [255; 3], 0.75, Some(hair)),
        PartKind::Flower => ("flower", appearance::FLOWER_SRGB, 0.8, None),
        PartKind::FlowerHeart => ("flower_heart", appearance::FLOWER_HEART_SRGB, 0.8, None),
    };
    GlbMaterial {
        name,
        base_color: if kind == PartKind::Nail {
            nail_color(look)
        } else {
            linear(color)
        },
        roughness,
        sheen: 0.0,
        texture_png,
        sides: if kind == PartKind::Lash {
            GlbSides::Both
        } else {
            GlbSides::Front
        },
    }
}
