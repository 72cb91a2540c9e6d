//! The order of garments: what is worn under another one stays under it.

use glam::Vec3;
use lole_cloth::collision::layer::{Layer, LayerCloth, LayerLaw, LayerOrder};
use lole_cloth::diagnose;

use super::FRAME_SECONDS;
use super::worn::Worn;
use crate::production::Garment;

/// How garments meet. A reach of a deep fold: what is farther on the wrong side is the other side of
/// the dancer. They part by a few millimeters a frame: gathers that lie in one another's way are led
/// past each other, where a faster push would tear folds open.
const LAW: LayerLaw = LayerLaw {
    gap: 0.0015,
    reach: 0.04,
    parting_speed: 0.2,
};

/// Brings garments that have moved on by a frame back into their order, from the skin outward.
/// Cloth that the paper's methods move keeps none.
pub(super) fn keep(worn: &mut [Worn], garments: &[Garment], orders: &mut [LayerOrder]) {
    for (inner, order) in orders.iter_mut().enumerate() {
        let [low, high] = &mut worn[inner..inner + 2] else {
            return;
        };
        let (Some(low), Some(high)) = (low.solver.xpbd_mut(), high.solver.xpbd_mut()) else {
            return;
        };
        let pair = [(low, inner), (high, inner + 1)].map(|((model, state), garment)| LayerCloth {
            model,
            state,
            shape: &garments[garment].shape,
        });
        let [low, mut high] = pair;
        order.keep((&low, &mut high), LAW, FRAME_SECONDS);
    }
}

/// Particles on the inward side of the next garment inward.
pub(super) fn inversions(garments: &[Garment], positions: &[Vec3]) -> usize {
    let pairs = garments.windows(2).map(|pair| {
        let inner = Layer {
            triangles: &pair[0].mesh.particle_triangles,
            positions: &positions[pair[0].particles.clone()],
        };
        diagnose::layer_inversions(inner, &positions[pair[1].particles.clone()], LAW.reach)
    });
    pairs.sum()
}
