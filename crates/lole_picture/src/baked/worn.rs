//! What is worn, in `dancer.glb`: what bones carry is skinned, everything else is baked.

use glam::{Vec2, Vec3};
use lole_cloth::Topology;
use lole_export::glb::{
    BakedCloth, GlbMaterial, GlbMesh, GlbPart, GlbSides, GridMesh, GridRing, GridSheet,
};
use lole_export::still::encode_png;
use lole_export::{ExportError, ImageView};
use lole_garment::adorn::{self, AdornmentFinish, Carried};
use lole_print::PrintImage;
use lole_stage::{Garment, Production, WornSurface};

use super::keys::SurfaceKeys;
use crate::Cover;

/// Columns of the simulation for one column of the file: a gather keeps five vertices.
const COLUMN_STRIDE: u32 = 2;
/// Rows of the simulation for one row of the file.
const ROW_STRIDE: u32 = 1;

/// A surface that was not recorded.
const NO_FRAMES: &Vec<Vec<Vec3>> = &Vec::new();
/// How much the fibers of woven cloth shine at a grazing angle, as the pictures of a dance have it.
const CLOTH_SHEEN: f32 = 0.12;

/// Everything that is worn, prepared for the file.
pub(crate) struct Worn<'a> {
    /// What bones carry.
    ridden: Vec<Ridden<'a>>,
    /// What moves by itself.
    baked: Vec<Baked<'a>>,
}

struct Ridden<'a> {
    name: String,
    surface: &'a adorn::Surface,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
}

struct Baked<'a> {
    name: String,
    mesh: GridMesh,
    /// The print; `None` where it is no cloth.
    print: Option<Vec<u8>>,
    beside: Option<&'a adorn::Surface>,
    /// Place among all surfaces.
    place: usize,
}

impl<'a> Worn<'a> {
    pub(crate) fn of(production: &'a Production, covers: &[Cover]) -> Result<Self, ExportError> {
        let mut worn = Self {
            ridden: Vec::new(),
            baked: Vec::new(),
        };
        for (place, (surface, cover)) in production.surfaces().zip(covers).enumerate() {
            let name = match surface {
                WornSurface::Beside(_, number) => {
                    format!("{}_{}", surface.worn().name(), number + 1)
                }
                WornSurface::Gathered(_) | WornSurface::Sewn(_) => surface.worn().name().to_owned(),
            };
            if let Some(beside) = surface.beside()
                && let Carried::Bones { carriers, .. } = &beside.carried
            {
                worn.ridden.push(Ridden {
                    name,
                    surface: beside,
                    joints: carriers.iter().map(|carrier| carrier.joints).collect(),
                    weights: carriers.iter().map(|carrier| carrier.weights).collect(),
                });
                continue;
            }
            worn.baked.push(Baked {
                name,
                mesh: mesh(surface, cover),
                print: cover.print.as_ref().map(print_png).transpose()?,
                beside: surface.beside(),
                place,
            });
        }
        Ok(worn)
    }

    /// Triangles and material of each ridden surface.
    pub(crate) fn ridden(&self) -> Vec<[GlbPart<'a>; 1]> {
        let part = |ridden: &Ridden<'a>| {
            [GlbPart {
                triangles: &ridden.surface.triangles,
                material: material(ridden.surface.finish),
            }]
        };
        self.ridden.iter().map(part).collect()
    }

    /// What bones carry.
    pub(crate) fn skinned<'b>(&'b self, parts: &'b [[GlbPart<'a>; 1]]) -> Vec<GlbMesh<'b>> {
        let ridden = self.ridden.iter().zip(parts);
        let meshes = ridden.filter_map(|(ridden, parts)| {
            let Carried::Bones {
                positions, normals, ..
            } = &ridden.surface.carried
            else {
                return None;
            };
            Some(GlbMesh {
                name: &ridden.name,
                positions,
                normals,
                uvs: &[],
                colors: &ridden.surface.colors,
                joints: &ridden.joints,
                weights: &ridden.weights,
                parts,
                shapes: &[],
                shape_times: &[],
            })
        });
        // An adornment without its flowers has a surface without triangles.
        meshes.filter(|mesh| !mesh.positions.is_empty()).collect()
    }

    /// What a surface that moves by itself is made of, by its place among all surfaces.
    pub(crate) fn material_at(&self, place: usize) -> GlbMaterial<'_> {
        let baked = self.baked.iter().find(|baked| baked.place == place);
        baked.map_or(cloth(None), Baked::material)
    }

    /// What moves by itself, with its recorded frames by surface.
    pub(super) fn baked<'b>(
        &'b self,
        key_times: &'b [f32],
        frames: &'b [SurfaceKeys<'b>],
    ) -> Vec<BakedCloth<'b>> {
        let baked = self.baked.iter().map(|baked| BakedCloth {
            name: &baked.name,
            mesh: &baked.mesh,
            colors: baked.beside.map_or(&[], |surface| &surface.colors),
            material: baked.material(),
            key_times,
            frames: (frames.get(baked.place)).map_or(NO_FRAMES, |frames| frames),
        });
        baked.collect()
    }
}

impl Baked<'_> {
    fn material(&self) -> GlbMaterial<'_> {
        match self.beside {
            Some(surface) => material(surface.finish),
            None => cloth(self.print.as_deref()),
        }
    }
}

pub(crate) fn print_png(print: &PrintImage) -> Result<Vec<u8>, ExportError> {
    let image = ImageView::new(print.width, print.height, &print.pixels)?;
    encode_png(image)
}

/// The mesh of a surface in the file: of gathered rectangles every second column, of everything else what is
/// drawn.
fn mesh(surface: WornSurface<'_>, cover: &Cover) -> GridMesh {
    match (surface, &cover.print) {
        (WornSurface::Gathered(garment), Some(print)) => grid_mesh(garment, print),
        _ => {
            let beside = surface.beside().map_or(0, adorn::Surface::vertex_count);
            let count = cover.uvs.len().max(beside);
            let mut uvs = cover.uvs.clone();
            uvs.resize(count, Vec2::ZERO);
            GridMesh {
                particles: (0_u32..).take(count).collect(),
                uvs,
                triangles: surface.triangles().to_vec(),
            }
        }
    }
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
        spacing: [grid.cloth_spacing(grid.row_count - 1), grid.spacing[1]],
        uv_from_flat: print.uv_from_panel(flounce),
        ..sheet
    };
    mesh.with(&GridMesh::new(&below, [COLUMN_STRIDE, ROW_STRIDE]))
}

pub(crate) const fn cloth(print: Option<&[u8]>) -> GlbMaterial<'_> {
    GlbMaterial {
        name: "print",
        base_color: [1.0; 3],
        roughness: 0.85,
        sheen: CLOTH_SHEEN,
        texture_png: print,
        sides: GlbSides::Both,
    }
}

pub(crate) const fn material(finish: AdornmentFinish) -> GlbMaterial<'static> {
    let (name, roughness, sheen) = match finish {
        AdornmentFinish::Leaf => ("leaf", 0.55, 0.0),
        AdornmentFinish::Petal => ("petal", 0.85, 0.15),
        AdornmentFinish::Feather => ("feather", 0.9, 0.35),
        AdornmentFinish::Fiber => ("fiber", 0.9, 0.10),
        AdornmentFinish::Wood => ("wood", 0.4, 0.0),
        AdornmentFinish::Film => ("film", 0.15, 0.0),
    };
    GlbMaterial {
        name,
        base_color: [1.0; 3],
        roughness,
        sheen,
        texture_png: None,
        sides: GlbSides::Both,
    }
}
