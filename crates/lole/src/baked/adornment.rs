//! Adornments in `dancer.glb`: what bones carry is skinned, what strands carry is baked.

use glam::{Vec2, Vec3};
use lole_costume::adorn::{Adornment, Carried, Finish, Surface};
use lole_export::glb::{BakedCloth, GlbMaterial, GridMesh, MeshPart, Sides, SkinnedMesh};

/// Whether a surface moves by itself.
pub(super) const fn is_baked(surface: &Surface) -> bool {
    matches!(surface.carried, Carried::Strands(_))
}

/// Everything that is worn, prepared for the file.
pub(super) struct Worn<'a> {
    /// Name and surface of what bones carry, with bones and shares by vertex.
    ridden: Vec<Ridden<'a>>,
    /// Name, surface and mesh of what strands carry.
    hanging: Vec<(String, &'a Surface, GridMesh)>,
}

struct Ridden<'a> {
    name: String,
    surface: &'a Surface,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
}

impl<'a> Worn<'a> {
    pub(super) fn of(adornments: &'a [Adornment]) -> Self {
        let mut worn = Self {
            ridden: Vec::new(),
            hanging: Vec::new(),
        };
        for adornment in adornments {
            for (number, surface) in adornment.surfaces.iter().enumerate() {
                let name = format!("{}_{}", adornment.name, number + 1);
                worn.add(name, surface);
            }
        }
        worn
    }

    fn add(&mut self, name: String, surface: &'a Surface) {
        match &surface.carried {
            Carried::Bones { carriers, .. } => self.ridden.push(Ridden {
                name,
                surface,
                joints: carriers.iter().map(|carrier| carrier.joints).collect(),
                weights: carriers.iter().map(|carrier| carrier.weights).collect(),
            }),
            Carried::Strands(places) => {
                let count = u32::try_from(places.len()).unwrap_or(u32::MAX);
                let mesh = GridMesh {
                    particles: (0..count).collect(),
                    uvs: vec![Vec2::ZERO; places.len()],
                    triangles: surface.triangles.clone(),
                };
                self.hanging.push((name, surface, mesh));
            }
        }
    }

    /// Triangles and material of each ridden surface.
    pub(super) fn ridden(&self) -> Vec<[MeshPart<'a>; 1]> {
        let part = |ridden: &Ridden<'a>| {
            [MeshPart {
                triangles: &ridden.surface.triangles,
                material: material(ridden.surface.finish),
            }]
        };
        self.ridden.iter().map(part).collect()
    }

    /// What bones carry.
    pub(super) fn skinned<'b>(&'b self, parts: &'b [[MeshPart<'a>; 1]]) -> Vec<SkinnedMesh<'b>> {
        let ridden = self.ridden.iter().zip(parts);
        let meshes = ridden.filter_map(|(ridden, parts)| {
            let Carried::Bones {
                positions, normals, ..
            } = &ridden.surface.carried
            else {
                return None;
            };
            Some(SkinnedMesh {
                name: &ridden.name,
                positions,
                normals,
                uvs: &[],
                colors: &ridden.surface.colors,
                joints: &ridden.joints,
                weights: &ridden.weights,
                parts,
            })
        });
        // An adornment without its flowers has a surface without triangles.
        meshes.filter(|mesh| !mesh.positions.is_empty()).collect()
    }

    /// What strands carry, with its recorded frames.
    pub(super) fn baked<'b>(
        &'b self,
        key_times: &'b [f32],
        frames: &'b [Vec<Vec<Vec3>>],
    ) -> Vec<BakedCloth<'b>> {
        let hanging = self.hanging.iter().zip(frames);
        let baked = hanging.map(|((name, surface, mesh), frames)| BakedCloth {
            name,
            mesh,
            colors: &surface.colors,
            material: material(surface.finish),
            key_times,
            frames,
        });
        baked.collect()
    }
}

const fn material(finish: Finish) -> GlbMaterial<'static> {
    let (name, roughness) = match finish {
        Finish::Leaf => ("leaf", 0.55),
        Finish::Petal => ("petal", 0.85),
        Finish::Feather => ("feather", 0.9),
        Finish::Fiber => ("fiber", 0.9),
        Finish::Wood => ("wood", 0.4),
        Finish::Film => ("film", 0.15),
    };
    GlbMaterial {
        name,
        base_color: [1.0; 3],
        roughness,
        texture_png: None,
        sides: Sides::Both,
    }
}
