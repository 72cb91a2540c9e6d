//! `dancer.glb`: the recorded run as a file for other programs.

mod adornment;

use anyhow::Result;
use glam::Vec3;
use lole_avatar::License;
use lole_body::{Appearance, BodyPicture, Dancer, Look, PartKind, Pose, appearance};
use lole_cloth::Topology;
use lole_costume::print::PrintImage;
use lole_export::Image;
use lole_export::glb::{
    BakedCloth, GlbMaterial, GlbScene, GridMesh, GridRing, GridSheet, MeshPart, Sides, SkinnedMesh,
    write_glb,
};
use lole_export::still::encode_png;
use lole_picture::linear;
use lole_stage::{Garment, Performance};

use crate::studio::Studio;

/// Columns of the simulation for one column of the file: a gather keeps five vertices.
const COLUMN_STRIDE: u32 = 2;
/// Rows of the simulation for one row of the file.
const ROW_STRIDE: u32 = 1;

/// Poses and cloth at key times.
#[derive(Debug, Default)]
pub(crate) struct Keys {
    pub(crate) times: Vec<f32>,
    pub(crate) poses: Vec<Pose>,
    /// By garment, then by time.
    pub(crate) cloths: Vec<Vec<Vec<Vec3>>>,
    /// By dressed garment, then by time.
    dressed: Vec<Vec<Vec<Vec3>>>,
    /// Surfaces of adornments that strands carry, by surface, then by time.
    pub(crate) strands: Vec<Vec<Vec<Vec3>>>,
}

impl Keys {
    /// Keeps the current frame.
    pub(crate) fn keep(&mut self, performance: &Performance) {
        self.times.push(performance.time());
        self.poses.push(performance.pose().clone());
        let garments = &performance.production().garments;
        self.cloths.resize_with(garments.len(), Vec::new);
        for (frames, garment) in self.cloths.iter_mut().zip(garments) {
            frames.push(performance.pressed_positions(garment).into_owned());
        }
        let count = performance.production().dressed.len();
        self.dressed.resize_with(count, Vec::new);
        for (place, frames) in self.dressed.iter_mut().enumerate() {
            let [positions, _] = performance.dressed_vertices(place);
            frames.push(positions);
        }
        let posed = performance.posed_adornments().into_iter();
        let surfaces = performance.production().adornments.iter();
        let posed = posed.zip(surfaces.flat_map(|one| &one.surfaces));
        let moving = posed.filter(|(_, surface)| adornment::is_baked(surface));
        let moving: Vec<Vec<Vec3>> = moving.map(|([positions, _], _)| positions).collect();
        self.strands.resize_with(moving.len(), Vec::new);
        for (frames, positions) in self.strands.iter_mut().zip(moving) {
            frames.push(positions);
        }
    }
}

fn body_png(picture: &BodyPicture) -> Result<Vec<u8>> {
    let image = Image::new(picture.side, picture.side, &picture.pixels)?;
    Ok(encode_png(image)?)
}

/// Pictures on the dancer, as a file carries them.
struct BodyPictures {
    face: Vec<u8>,
    hair: Vec<u8>,
    /// Of each part of a given skin.
    looks: Vec<Option<Vec<u8>>>,
}

impl BodyPictures {
    fn of(dancer: &Dancer) -> Result<Self> {
        let looks = dancer.skin.looks.iter().map(look_png);
        Ok(Self {
            face: body_png(&dancer.face_picture())?,
            hair: body_png(&dancer.hair_picture())?,
            looks: looks.collect::<Result<_>>()?,
        })
    }

    /// The parts of her skin with their materials.
    fn parts<'a>(&'a self, dancer: &'a Dancer) -> Vec<MeshPart<'a>> {
        let skin = &dancer.skin;
        let parts = skin.parts.iter().enumerate();
        parts
            .map(|(place, part)| MeshPart {
                triangles: &part.triangles,
                material: match (skin.looks.get(place), self.looks.get(place)) {
                    (Some(look), Some(png)) => look_material(look, png.as_deref()),
                    _ => material(part.kind, &dancer.appearance, [&self.face, &self.hair]),
                },
            })
            .collect()
    }
}

fn skinned<'a>(dancer: &'a Dancer, parts: &'a [MeshPart<'a>]) -> SkinnedMesh<'a> {
    let skin = &dancer.skin;
    SkinnedMesh {
        name: "dancer",
        positions: &skin.positions,
        normals: &skin.normals,
        uvs: &skin.uvs,
        colors: &[],
        joints: &skin.joints,
        weights: &skin.weights,
        parts,
    }
}

/// The dancer alone, standing in her bind pose.
pub(crate) fn body_glb(dancer: &Dancer) -> Result<Vec<u8>> {
    let pictures = BodyPictures::of(dancer)?;
    let parts = pictures.parts(dancer);
    Ok(write_glb(&GlbScene {
        skeleton: &dancer.skeleton,
        pose_times: &[],
        poses: &[],
        skinned: &[skinned(dancer, &parts)],
        cloths: &[],
    })?)
}

/// The file's bytes: dancer with skeleton and motion, garments with their baked motion and print.
pub(crate) fn dancer_glb(
    performance: &Performance,
    keys: &Keys,
    studio: &Studio,
) -> Result<Vec<u8>> {
    let production = performance.production();
    let pngs = |prints: &mut dyn Iterator<Item = &PrintImage>| -> Result<Vec<Vec<u8>>> {
        let png = |print: &PrintImage| {
            let image = Image::new(print.width, print.height, &print.pixels)?;
            Ok(encode_png(image)?)
        };
        prints.map(png).collect()
    };
    let prints_png = pngs(&mut studio.prints().iter())?;
    let dressed_png = pngs(&mut studio.dressed().iter().map(|look| &look.print))?;
    let pictures = BodyPictures::of(&production.dancer)?;
    let parts = pictures.parts(&production.dancer);
    let adorned = adornment::Worn::of(&production.adornments);
    let ridden = adorned.ridden();
    let mut bodies = Vec::new();
    if !leaves_body_out(performance) {
        bodies.push(skinned(&production.dancer, &parts));
    }
    bodies.extend(adorned.skinned(&ridden));
    let worn = production.garments.iter().zip(studio.prints());
    let meshes: Vec<GridMesh> = worn
        .map(|(garment, print)| grid_mesh(garment, print))
        .collect();
    let worn = production.garments.iter().zip(&meshes);
    let baked = worn.zip(prints_png.iter().zip(&keys.cloths));
    let cloth = |name, mesh, png, frames| BakedCloth {
        name,
        mesh,
        colors: &[],
        material: GlbMaterial {
            name: "print",
            base_color: [1.0; 3],
            roughness: 0.85,
            texture_png: Some(png),
            sides: Sides::Both,
        },
        key_times: &keys.times,
        frames,
    };
    let mut cloths: Vec<BakedCloth<'_>> = baked
        .map(|((garment, mesh), (png, frames))| cloth(&garment.name, mesh, &png[..], &frames[..]))
        .collect();
    let dressed_meshes = dressed_meshes(performance, studio);
    let dressed = production.dressed.iter().zip(&dressed_meshes);
    let dressed = dressed.zip(dressed_png.iter().zip(&keys.dressed));
    cloths.extend(
        dressed.map(|((garment, mesh), (png, frames))| {
            cloth(&garment.name, mesh, &png[..], &frames[..])
        }),
    );
    cloths.extend(adorned.baked(&keys.times, &keys.strands));
    Ok(write_glb(&GlbScene {
        skeleton: &production.dancer.skeleton,
        pose_times: &keys.times,
        poses: &keys.poses,
        skinned: &bodies,
        cloths: &cloths,
    })?)
}

/// Whether the dancer is an avatar whose license keeps it out of files.
pub(crate) fn leaves_body_out(performance: &Performance) -> bool {
    is_kept_here(performance.production().license.as_ref())
}

/// Whether a license keeps an avatar out of files.
pub(crate) fn is_kept_here(license: Option<&License>) -> bool {
    license.is_some_and(|license| license.export_refusal().is_some())
}

/// The picture of a part of an avatar.
fn look_png(look: &Look) -> Result<Option<Vec<u8>>> {
    let Some(picture) = &look.picture else {
        return Ok(None);
    };
    let image = Image::new(picture.width, picture.height, &picture.pixels)?;
    Ok(Some(encode_png(image)?))
}

fn look_material<'a>(look: &'a Look, png: Option<&'a [u8]>) -> GlbMaterial<'a> {
    GlbMaterial {
        name: &look.name,
        base_color: look.base_color,
        roughness: look.roughness,
        texture_png: png,
        sides: if look.is_two_sided {
            Sides::Both
        } else {
            Sides::Front
        },
    }
}

/// The meshes of dressed garments in the file: as they are drawn.
fn dressed_meshes(performance: &Performance, studio: &Studio) -> Vec<GridMesh> {
    let dressed = performance.production().dressed.iter();
    let meshes = dressed
        .zip(studio.dressed())
        .map(|(garment, look)| GridMesh {
            particles: (0_u32..).take(look.uvs.len()).collect(),
            uvs: look.uvs.clone(),
            triangles: garment.dressed.triangles.clone(),
        });
    meshes.collect()
}

/// The mesh of a garment's grid in the file.
fn grid_mesh(garment: &Garment, print: &PrintImage) -> GridMesh {
    let grid = &garment.sewn.spec.grid;
    let seam = grid.flounce.map(|flounce| flounce.seam_row);
    let sheet = GridSheet {
        column_count: grid.column_count,
        row_count: seam.map_or(grid.row_count, |seam| seam + 1),
        rows_above: 0,
        ring: match grid.topology {
            Topology::Tube => GridRing::Closed,
            Topology::Sheet => GridRing::Open,
        },
        spacing: grid.spacing,
        uv_from_flat: print.uv_from_panel(&garment.draft),
    };
    let mesh = GridMesh::new(&sheet, [COLUMN_STRIDE, ROW_STRIDE]);
    let Some((seam, flounce)) = seam.zip(garment.flounce.as_ref()) else {
        return mesh;
    };
    let below = GridSheet {
        row_count: grid.row_count - seam,
        rows_above: seam,
        spacing: [grid.row_spacing(grid.row_count - 1), grid.spacing[1]],
        uv_from_flat: print.uv_from_panel(flounce),
        ..sheet
    };
    mesh.with(&GridMesh::new(&below, [COLUMN_STRIDE, ROW_STRIDE]))
}

fn material<'a>(kind: PartKind, look: &Appearance, [face, hair]: [&'a [u8]; 2]) -> GlbMaterial<'a> {
    let (name, color, roughness, texture_png) = match kind {
        PartKind::Skin | PartKind::Given => ("skin", look.skin_srgb, 0.6, None),
        PartKind::Face => ("face", [255; 3], 0.6, Some(face)),
        PartKind::Leotard => ("leotard", look.leotard_srgb, 0.8, None),
        PartKind::Hair => ("hair", [255; 3], 0.75, Some(hair)),
        PartKind::Flower => ("flower", appearance::FLOWER_SRGB, 0.8, None),
        PartKind::FlowerHeart => ("flower_heart", appearance::FLOWER_HEART_SRGB, 0.8, None),
    };
    GlbMaterial {
        name,
        base_color: linear(color),
        roughness,
        texture_png,
        sides: Sides::Front,
    }
}
