//! Cloth that lies through itself when it is laid is smoothed by hand: what crosses and the cloth around it
//! is spread evenly between what lies well, and comes to rest again.
//!
//! Laid around her, pieces meet at armholes, in gathers and under arms, and some of that goes through itself.
//! Repair keeps apart what is apart, and a tangle whose contour cannot become shorter stays for good. Spread
//! evenly, cloth has no fold that could go through another; what is too much of it puckers anew, and then
//! with nothing crossed.

use std::collections::BTreeSet;

use glam::Vec3;

use super::form::Form;
use super::{Dressed, fit, flat};

/// Passes in which cloth is spread, and how often it is brought out of the skin meanwhile.
const PASSES: u32 = 10;
const PUSHES: u32 = 6;

/// Rings of triangles around what crosses that are smoothed in the first round; one more in each.
const RINGS: u32 = 2;

/// Particles with what is beside them, with seams closed.
pub(super) struct Smoothing {
    neighbors: Vec<Vec<u32>>,
    /// Which of them stay: what the skin carries, and hems, which would be drawn into the cloth and take a
    /// sleeve up the arm.
    is_held: Vec<bool>,
}

impl Smoothing {
    pub(super) fn new(garment: &Dressed) -> Self {
        let mut neighbors = vec![Vec::new(); garment.start.len()];
        for corners in &garment.triangles {
            let [a, b, c] = corners.map(|corner| garment.welded[corner as usize]);
            for [one, other] in [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]] {
                neighbors[one as usize].push(other);
            }
        }
        for ring in &mut neighbors {
            ring.sort_unstable();
            ring.dedup();
        }
        let mut is_held = vec![false; garment.start.len()];
        for (particle, &group) in (0..).zip(&garment.welded) {
            is_held[group as usize] |= garment.is_pinned(particle);
        }
        for particle in hems(garment) {
            is_held[particle as usize] = true;
        }
        Self { neighbors, is_held }
    }

    /// Smooths what crosses at `places` [m], in a round counted from 0; whether anything did.
    pub(super) fn smooth(
        &self,
        garment: &Dressed,
        (form, round): (&Form<'_>, u32),
        places: &mut [Vec3],
    ) -> bool {
        let crossings = garment.crossing_pairs(places).unwrap_or_default();
        let mut taken: BTreeSet<u32> = (crossings.iter())
            .flat_map(|it| it.ends.into_iter().chain(it.corners))
            .collect();
        if taken.is_empty() {
            return false;
        }
        for _ in 0..RINGS + round {
            let around = taken.iter().flat_map(|&it| &self.neighbors[it as usize]);
            let around: Vec<u32> = around.copied().collect();
            taken.extend(around);
        }
        taken.retain(|&it| !self.is_held[it as usize]);
        let mut spread = garment.closed(places);
        for _ in 0..PUSHES {
            self.spread(&taken, &mut spread);
            form.push_out_some(&mut spread, |particle| {
                let is_taken = taken.contains(&flat::number(particle));
                is_taken.then_some(fit::START_GAP)
            });
        }
        for (place, &group) in places.iter_mut().zip(&garment.welded) {
            if taken.contains(&group) {
                *place = spread[group as usize];
            }
        }
        true
    }

    /// Draws what is taken to the middle of what is beside it, pass after pass.
    fn spread(&self, taken: &BTreeSet<u32>, places: &mut [Vec3]) {
        for _ in 0..PASSES {
            for &particle in taken {
                let ring = &self.neighbors[particle as usize];
                let sum: Vec3 = ring.iter().map(|&it| places[it as usize]).sum();
                places[particle as usize] = sum / ring.len().max(1) as f32;
            }
        }
    }
}

/// Particles at edges of the cloth that nothing is sewn to.
fn hems(garment: &Dressed) -> Vec<u32> {
    let mut sides: Vec<[u32; 2]> = (garment.triangles.iter())
        .map(|corners| corners.map(|corner| garment.welded[corner as usize]))
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    sides.sort_unstable();
    let in_seams = garment.in_seams();
    let is_sewn = |side: &[u32; 2]| side.iter().all(|&end| in_seams[end as usize]);
    let alone = sides.chunk_by(|a, b| a == b).filter(|same| same.len() == 1);
    alone
        .map(|same| same[0])
        .filter(|side| !is_sewn(side))
        .flatten()
        .collect()
}
