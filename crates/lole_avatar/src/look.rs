//! What the parts of an avatar look like: base colors and base-color pictures.
//!
//! Whatever the shading of the file (metal and roughness, unlit, `MToon`), the base color and its
//! picture are what remains of it. What a picture leaves clear is cut away, triangle by triangle.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

use glam::Vec2;
use gltf_json::material::{AlphaMode, Material};
use gltf_json::texture::Info;
use gltf_json::validation::Checked;
use lole_body::{Look, SkinPicture};
use lole_language::words;

use crate::AvatarError;
use crate::container::{File, embedded, visible};
use crate::geometry::Geometry;

/// Longest side of a picture that is read [pixel].
const LONGEST_SIDE: u32 = 8192;
/// Longest side of a picture that is kept [pixel]; a larger one is made smaller.
const KEPT_SIDE: u32 = 2048;
/// Pixels of all pictures of a file that are read: sixteen of the largest that people use.
const MOST_PIXELS: u64 = 16 * 4096 * 4096;
/// Bytes that decoding a picture may take.
const MOST_BYTES: u64 = 512 << 20;
/// Opacity below which nothing is drawn, where the material does not say.
const USUAL_CUTOFF: f32 = 0.5;
/// Gray of a part without a material.
const PLAIN: [f32; 3] = [0.6; 3];

/// Looks, and the triangles of each.
pub(crate) type Looks = (Vec<Look>, Vec<Vec<[u32; 3]>>);

/// The looks of a file, one for each material that is used.
pub(crate) fn looks(file: &File<'_>, geometry: &Geometry) -> Result<Looks, AvatarError> {
    let mut used: Vec<Option<usize>> = geometry.parts.iter().map(|part| part.material).collect();
    used.sort_unstable();
    used.dedup();
    let mut pictures: Vec<Option<Option<Arc<SkinPicture>>>> = vec![None; file.root.images.len()];
    let (mut looks, mut triangles) = (Vec::new(), Vec::new());
    check_pixels(file, &used)?;
    for material in used {
        let said = material.and_then(|index| file.root.materials.get(index));
        let look = look(file, said, &mut pictures)?;
        let parts = geometry
            .parts
            .iter()
            .filter(|part| part.material == material);
        let mut shown: Vec<[u32; 3]> = parts.flat_map(|part| part.triangles.clone()).collect();
        if let Some(cutoff) = said.and_then(cutoff) {
            shown.retain(|triangle| !is_clear(&look, geometry, *triangle, cutoff));
        }
        looks.push(look);
        triangles.push(shown);
    }
    Ok((looks, triangles))
}

fn look(
    file: &File<'_>,
    said: Option<&Material>,
    pictures: &mut [Option<Option<Arc<SkinPicture>>>],
) -> Result<Look, AvatarError> {
    let Some(said) = said else {
        return Ok(Look {
            name: String::new(),
            base_color: PLAIN,
            picture: None,
            roughness: 0.8,
            is_two_sided: false,
        });
    };
    let base = &said.pbr_metallic_roughness;
    let [red, green, blue, _] = base.base_color_factor.0;
    let picture = match &base.base_color_texture {
        Some(info) => picture(file, info, pictures)?,
        None => None,
    };
    Ok(Look {
        name: visible(said.name.as_deref().unwrap_or("")),
        base_color: [red, green, blue].map(|part| {
            if part.is_finite() {
                part.clamp(0.0, 1.0)
            } else {
                1.0
            }
        }),
        picture,
        roughness: if base.roughness_factor.0.is_finite() {
            base.roughness_factor.0.clamp(0.3, 1.0)
        } else {
            1.0
        },
        is_two_sided: said.double_sided,
    })
}

/// Opacity below which a material is not drawn; `None` where it is opaque.
fn cutoff(said: &Material) -> Option<f32> {
    match said.alpha_mode {
        Checked::Valid(AlphaMode::Opaque) | Checked::Invalid => None,
        Checked::Valid(AlphaMode::Mask) => {
            let said = said.alpha_cutoff.map_or(USUAL_CUTOFF, |cutoff| cutoff.0);
            Some(said.clamp(0.0, 1.0))
        }
        Checked::Valid(AlphaMode::Blend) => Some(USUAL_CUTOFF),
    }
}

/// The picture of a texture; `None` where it is of a kind that is not read.
fn picture(
    file: &File<'_>,
    info: &Info,
    pictures: &mut [Option<Option<Arc<SkinPicture>>>],
) -> Result<Option<Arc<SkinPicture>>, AvatarError> {
    let Some(image) = image_of(file, info) else {
        return Ok(None);
    };
    let slot = &mut pictures[image];
    if slot.is_none() {
        *slot = Some(decoded(file, image)?.map(Arc::new));
    }
    Ok(slot.clone().flatten())
}

/// Checks how many pixels the pictures of these materials have, before any is read.
fn check_pixels(file: &File<'_>, used: &[Option<usize>]) -> Result<(), AvatarError> {
    let materials = used.iter().flatten();
    let said = materials.filter_map(|&index| file.root.materials.get(index));
    let infos = said.filter_map(|said| said.pbr_metallic_roughness.base_color_texture.as_ref());
    let images: BTreeSet<usize> = infos.filter_map(|info| image_of(file, info)).collect();
    let mut sum = 0_u64;
    for index in images {
        let Some(bytes) = encoded(file, index)? else {
            continue;
        };
        let reader = image::ImageReader::new(std::io::Cursor::new(bytes)).with_guessed_format();
        let size = reader.ok().and_then(|reader| reader.into_dimensions().ok());
        let pixels = size.map_or(0, |(width, height)| u64::from(width) * u64::from(height));
        sum = sum.saturating_add(pixels);
    }
    if MOST_PIXELS < sum {
        return Err(AvatarError::TooLarge {
            what: words("画素の画像", "pixels in its pictures"),
            count: sum,
            limit: MOST_PIXELS,
        });
    }
    Ok(())
}

/// The bytes of a picture as it lies in the file; `None` where it lies in another one.
fn encoded<'a>(file: &'a File<'_>, index: usize) -> Result<Option<Cow<'a, [u8]>>, AvatarError> {
    let said = &file.root.images[index];
    Ok(match (said.buffer_view, &said.uri) {
        (Some(view), _) => Some(Cow::Borrowed(file.view(view)?)),
        (None, Some(uri)) => match embedded(uri) {
            Some(Ok(bytes)) => Some(Cow::Owned(bytes)),
            // A picture in another file leaves the plain color.
            _ => None,
        },
        (None, None) => None,
    })
}

/// Which picture a texture shows, where there is one.
fn image_of(file: &File<'_>, info: &Info) -> Option<usize> {
    let texture = file.root.textures.get(info.index.value())?;
    let image = texture.source.value();
    (image < file.root.images.len()).then_some(image)
}

fn decoded(file: &File<'_>, index: usize) -> Result<Option<SkinPicture>, AvatarError> {
    let Some(bytes) = encoded(file, index)? else {
        return Ok(None);
    };
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(LONGEST_SIDE);
    limits.max_image_height = Some(LONGEST_SIDE);
    limits.max_alloc = Some(MOST_BYTES);
    let reader = image::ImageReader::new(std::io::Cursor::new(bytes)).with_guessed_format();
    let Ok(mut reader) = reader else {
        return Ok(None);
    };
    if reader.format().is_none() {
        return Ok(None);
    }
    reader.limits(limits);
    let picture = reader.decode().map_err(|error| {
        let said = visible(&error.to_string());
        AvatarError::part(
            format!("images[{index}]"),
            format!("画像が読めません（{said}）"),
            format!("the picture cannot be read ({said})"),
        )
    })?;
    let longest = picture.width().max(picture.height());
    let picture = if KEPT_SIDE < longest {
        picture.thumbnail(KEPT_SIDE, KEPT_SIDE)
    } else {
        picture
    };
    let pixels = picture.into_rgba8();
    let (width, height) = pixels.dimensions();
    Ok((width > 0 && height > 0).then(|| SkinPicture {
        width,
        height,
        pixels: pixels.into_raw(),
    }))
}

/// Whether the picture is clear at the middle and near all corners of a triangle.
fn is_clear(look: &Look, geometry: &Geometry, triangle: [u32; 3], cutoff: f32) -> bool {
    let Some(picture) = &look.picture else {
        return false;
    };
    let corners = triangle.map(|vertex| geometry.uvs[vertex as usize]);
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let places = corners.map(|corner| corner.lerp(middle, 0.25));
    let opacity = |place: Vec2| {
        let texel = |part: f32, side: u32| {
            let whole = part.rem_euclid(1.0) * side as f32;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a place within the picture"
            )]
            let texel = whole as u32;
            texel.min(side - 1) as usize
        };
        let (x, y) = (
            texel(place.x, picture.width),
            texel(place.y, picture.height),
        );
        let alpha = picture.pixels[4 * (y * picture.width as usize + x) + 3];
        f32::from(alpha) / 255.0
    };
    opacity(middle) < cutoff && places.iter().all(|&place| opacity(place) < cutoff)
}
