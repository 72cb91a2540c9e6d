//! The order of garments: what is worn under another one stays under it.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Skeleton};
use lole_cloth::collision::layer::{Envelope, Layer, Trunk};
use lole_cloth::diagnose;
pub(super) use lole_garment::dress::LAYER_GAP as GAP;
use lole_geom::Surfel;
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::worn::Worn;
use crate::production::Garment;
use crate::solver::{CONTACT_OFFSET, Observer, Surroundings};

/// How far inside a layer its particles are looked for [m]: what is farther on the wrong side is the
/// other side of the dancer.
const REACH: f32 = 0.04;

/// The garments of a performance, chain by chain.
#[derive(Debug, Clone, Default)]
pub(super) struct Order {
    chains: Vec<Chain>,
}

/// What garments meet that move on one after the other, from the skin outward: the skin, and the
/// envelope of what is worn already, which they meet in the same way. It is room: every frame is
/// looked at anew, so that states say all there is to know.
#[derive(Debug, Clone, Default)]
struct Chain {
    envelope: Envelope,
    surfels: Vec<Surfel>,
    /// Where what was moved last is [m].
    positions: Vec<Vec3>,
}

/// Triangles on the trunk of what is worn inside of all chains, and where they are [m].
pub(super) type Inner<'a> = (&'a [[u32; 3]], &'a [Vec3]);

/// Garments of one chain, from the skin outward.
type Dressed<'a> = Vec<(&'a mut Worn, &'a Garment)>;

impl Order {
    /// Moves garments on by a frame, from the skin outward: each meets what is worn inside of it
    /// where that is at the end of the frame. Cloth that the paper's methods move does not. Chains do
    /// not meet each other, so they move on at the same time.
    pub(super) fn step(
        &mut self,
        (trunk, inner): (Trunk, &[Inner<'_>]),
        (worn, garments): (&mut [Worn], &[Garment]),
        surroundings: &Surroundings<'_>,
        observer: &mut Observer<'_>,
    ) {
        let mut dressed: Vec<Dressed<'_>> = garments.iter().map(|_| Vec::new()).collect();
        for pair in worn.iter_mut().zip(garments) {
            dressed[pair.1.chain].push(pair);
        }
        dressed.retain(|chain| !chain.is_empty());
        self.chains.resize_with(dressed.len(), Chain::default);
        let chains = self.chains.iter_mut().zip(dressed);
        if observer.is_some() || rayon::current_num_threads() == 1 {
            for (chain, dressed) in chains {
                chain.step((trunk, inner), dressed, surroundings, observer);
            }
        } else {
            let chains: Vec<_> = chains.collect();
            chains.into_par_iter().for_each(|(chain, dressed)| {
                chain.step((trunk, inner), dressed, surroundings, &mut None);
            });
        }
    }
}

impl Chain {
    fn step(
        &mut self,
        (trunk, inner): (Trunk, &[Inner<'_>]),
        dressed: Dressed<'_>,
        surroundings: &Surroundings<'_>,
        observer: &mut Observer<'_>,
    ) {
        self.envelope.begin(trunk);
        self.surfels.clear();
        self.surfels.extend_from_slice(surroundings.surfels);
        let skin_count = self.surfels.len();
        if !inner.is_empty() {
            for (triangles, positions) in inner {
                self.envelope.put_on(triangles, positions);
            }
            self.envelope
                .add_surfels(CONTACT_OFFSET - GAP, &mut self.surfels);
        }
        let count = dressed.len();
        for (place, (worn, garment)) in dressed.into_iter().enumerate() {
            let surroundings = Surroundings {
                surfels: &self.surfels,
                ..*surroundings
            };
            match observer {
                None => worn.step(&surroundings, None),
                Some(passed) => worn.step(&surroundings, Some(&mut **passed)),
            }
            if place + 1 < count {
                let mut positions = std::mem::take(&mut self.positions);
                positions.clear();
                worn.add_positions(&mut positions);
                self.put_on(garment, &positions, skin_count);
                self.positions = positions;
            }
        }
    }

    /// Puts on a garment that lies at `positions` [m] over the skin of so many surfels.
    fn put_on(&mut self, garment: &Garment, positions: &[Vec3], skin_count: usize) {
        let triangles = &garment.mesh.particle_triangles;
        self.envelope.put_on(triangles, positions);
        self.surfels.truncate(skin_count);
        self.envelope
            .add_surfels(CONTACT_OFFSET - GAP, &mut self.surfels);
    }
}

/// The trunk in a pose: what is worn hangs around it.
pub(super) fn trunk(skeleton: &Skeleton, world_from_bind: &[Affine3A]) -> Trunk {
    let hips = world_from_bind[Bone::Hips.index()];
    let forward = hips.transform_vector3(Vec3::Z).with_y(0.0);
    Trunk {
        axis: hips.transform_point3(skeleton.joint(Bone::Hips)),
        forward: forward.try_normalize().unwrap_or(Vec3::Z),
    }
}

/// Particles on the inward side of the next garment inward.
pub(super) fn inversions(garments: &[Garment], positions: &[Vec3]) -> usize {
    let pairs = garments.windows(2).map(|pair| {
        let inner = Layer {
            triangles: &pair[0].mesh.particle_triangles,
            positions: &positions[pair[0].particles.clone()],
        };
        diagnose::layer_inversions(inner, &positions[pair[1].particles.clone()], REACH)
    });
    pairs.sum()
}
