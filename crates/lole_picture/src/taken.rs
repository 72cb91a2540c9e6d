//! A performance as a take: the meshes of what is seen, and where they are in its present frame.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt;

use glam::{Vec2, Vec3};
use lole_body::Pose;
use lole_export::ExportError;
use lole_export::glb::{
    BakedCloth, ClothFrames, GlbFile, GlbMaterial, GlbScene, GlbSides, GridMesh, MOST_TARGETS,
    write_glb,
};
use lole_export::take::{
    TakeMaterial, TakeMesh, TakePart, TakeScene, TakeSource, TakeVertices, identifier,
};
use lole_stage::{Performance, Production, WornSurface};

use crate::baked::{Blinking, BodyPictures, is_kept_here, skinned, worn};
use crate::{Cover, Moment};

/// Fewest keys a second that cloth is thinned to, to be written as it moved.
const FEWEST_KEYS: u32 = 10;

/// Meshes and materials of everything that is seen of a production: what she wears or holds, then she herself, unless
/// her license keeps her out of files.
///
/// # Errors
/// A picture that the file cannot carry.
pub fn take_scene(production: &Production, covers: &[Cover]) -> Result<TakeScene, ExportError> {
    let mut scene = TakeScene::default();
    let mut names = Vec::new();
    for (surface, cover) in production.surfaces().zip(covers) {
        let name = match surface {
            WornSurface::Beside(_, place) => format!("{}_{}", surface.worn().name(), place + 1),
            WornSurface::Gathered(_) | WornSurface::Sewn(_) => surface.worn().name().to_owned(),
        };
        let png = cover.print.as_ref().map(worn::print_png).transpose()?;
        let material = match surface.beside() {
            Some(beside) => worn::material(beside.finish),
            None => worn::cloth(png.as_deref()),
        };
        let name = identifier(&name, &names);
        names.push(name.clone());
        scene.meshes.push(TakeMesh {
            vertex_count: vertex_count(surface, cover),
            uvs: cover.uvs.clone(),
            colors: cover.colors.clone(),
            parts: vec![TakePart {
                triangles: cover.triangles.clone(),
                material: owned(&material, &name),
            }],
            name,
        });
    }
    // An adornment without its flowers has a surface without triangles; it keeps its place among the vertices.
    if !is_kept_here(production.license.as_ref()) {
        scene.meshes.push(body(production, &names)?);
    }
    Ok(scene)
}

fn vertex_count(surface: WornSurface<'_>, cover: &Cover) -> usize {
    let beside = surface.beside();
    beside.map_or(cover.uvs.len(), lole_garment::adorn::Surface::vertex_count)
}

fn body(production: &Production, names: &[String]) -> Result<TakeMesh, ExportError> {
    let dancer = &production.dancer;
    let pictures = BodyPictures::of(dancer)?;
    let name = identifier("dancer", names);
    let parts = pictures.parts(dancer);
    let parts = parts.iter().filter(|part| !part.triangles.is_empty());
    let mut taken = Vec::new();
    let parts = parts.map(|part| {
        let material = identifier(&format!("{name}_{}", part.material.name), &taken);
        taken.push(material.clone());
        TakePart {
            triangles: part.triangles.to_vec(),
            material: TakeMaterial {
                name: material,
                ..owned(&part.material, &name)
            },
        }
    });
    Ok(TakeMesh {
        parts: parts.collect(),
        vertex_count: dancer.drawn().positions.len(),
        uvs: dancer.drawn().uvs.clone(),
        colors: dancer.drawn().colors.clone(),
        name,
    })
}

/// A material of a mesh, named after both.
fn owned(material: &GlbMaterial<'_>, mesh: &str) -> TakeMaterial {
    TakeMaterial {
        name: format!("{mesh}_{}", material.name),
        base_color: material.base_color,
        roughness: material.roughness,
        texture_png: material.texture_png.map(<[u8]>::to_vec),
        is_two_sided: material.sides == GlbSides::Both,
    }
}

/// The present frame: the pose, and the vertices of [`take_scene`]'s meshes; call [`Performance::pose_body`] first.
#[must_use]
pub fn take_frame(performance: &Performance) -> (Pose, Vec<TakeVertices>) {
    let Moment { mut worn, body, .. } = Moment::of(performance);
    if !is_kept_here(performance.production().license.as_ref()) {
        worn.push(body);
    }
    (performance.pose().clone(), worn)
}

/// A take as GLB: the dancer and what her bones carry skinned, all that moves by itself as it was seen.
///
/// # Errors
/// A mesh or a picture that the file cannot carry, or a frame that cannot be read.
pub fn take_glb(
    production: &Production,
    covers: &[Cover],
    take: &mut dyn TakeSource,
) -> Result<GlbFile, ExportError> {
    let scene = take.scene().clone();
    let stride = stride(&scene);
    let frames: Vec<u32> = (0..scene.frame_count).step_by(stride as usize).collect();
    let lost = |frame: u32| {
        move |cause: std::io::Error| ExportError::FrameLost {
            mesh: "dancer".to_owned(),
            frame: frame as usize,
            cause: cause.to_string(),
        }
    };
    let poses = frames
        .iter()
        .map(|&frame| take.pose(frame).map_err(lost(frame)));
    let poses: Vec<Pose> = poses.collect::<Result<_, _>>()?;
    #[expect(clippy::cast_possible_truncation, reason = "ten minutes at most")]
    let times: Vec<f32> = frames.iter().map(|&it| scene.time(it) as f32).collect();
    let worn = worn::Worn::of(production, covers)?;
    let ridden = worn.ridden();
    let pictures = BodyPictures::of(&production.dancer)?;
    let parts = pictures.parts(&production.dancer);
    let blinking = Blinking::of(&production.dancer, &times);
    let mut bodies = Vec::new();
    if !is_kept_here(production.license.as_ref()) {
        bodies.push(skinned(&production.dancer, &parts, &blinking));
    }
    bodies.extend(worn.skinned(&ridden));
    let shared = RefCell::new(take);
    let moving: Vec<usize> = production
        .surfaces()
        .enumerate()
        .filter(|(_, surface)| !surface.rides_on_bones())
        .map(|(place, _)| place)
        .collect();
    let meshes: Vec<GridMesh> = moving
        .iter()
        .map(|&place| whole_mesh(&scene.meshes[place]))
        .collect();
    let recorded: Vec<Recorded<'_, '_>> = moving
        .iter()
        .map(|&mesh| Recorded {
            take: &shared,
            name: &scene.meshes[mesh].name,
            mesh,
            frames: &frames,
        })
        .collect();
    let cloths = moving.iter().zip(&meshes).zip(&recorded);
    let cloths = cloths.filter(|((_, mesh), _)| !mesh.triangles.is_empty());
    let cloths: Vec<BakedCloth<'_>> = cloths
        .map(|((&place, mesh), frames)| BakedCloth {
            name: &scene.meshes[place].name,
            mesh,
            colors: &scene.meshes[place].colors,
            material: worn.material_at(place),
            key_times: &times,
            frames,
        })
        .collect();
    write_glb(&GlbScene {
        skeleton: &production.dancer.skeleton,
        pose_times: &times,
        poses: &poses,
        skinned: &bodies,
        cloths: &cloths,
        added: &[],
        extensions: &[],
    })
}

/// Frames from one key to the next: so many that cloth can be written as it moved, unless that were too few.
fn stride(scene: &TakeScene) -> u32 {
    let rate = scene.frame_rate;
    let even = |stride: &u32| rate.is_multiple_of(*stride) && FEWEST_KEYS <= rate / stride;
    let fits = |stride: &u32| scene.frame_count.div_ceil(*stride) as usize <= MOST_TARGETS + 1;
    (1..=rate).filter(even).find(fits).unwrap_or(1)
}

/// Every vertex of a mesh.
fn whole_mesh(mesh: &TakeMesh) -> GridMesh {
    let mut uvs = mesh.uvs.clone();
    uvs.resize(mesh.vertex_count, Vec2::ZERO);
    GridMesh {
        particles: (0_u32..).take(mesh.vertex_count).collect(),
        uvs,
        triangles: mesh.triangles().collect(),
    }
}

/// The frames of one mesh of a take.
struct Recorded<'a, 'b> {
    take: &'a RefCell<&'b mut dyn TakeSource>,
    name: &'a str,
    mesh: usize,
    frames: &'a [u32],
}

impl fmt::Debug for Recorded<'_, '_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} frames of {}", self.frames.len(), self.name)
    }
}

impl ClothFrames for Recorded<'_, '_> {
    fn count(&self) -> usize {
        self.frames.len()
    }

    fn frame(&self, number: usize) -> Result<Cow<'_, [Vec3]>, ExportError> {
        let read = self
            .take
            .borrow_mut()
            .vertices(self.frames[number], self.mesh);
        let lost = |cause: std::io::Error| ExportError::FrameLost {
            mesh: self.name.to_owned(),
            frame: number,
            cause: cause.to_string(),
        };
        read.map(|[positions, _]| Cow::Owned(positions))
            .map_err(lost)
    }
}
