//! The figures of a frame: strain, depth in the skin, energy, heights, hash.

use glam::Vec3;
use lole_cloth::diagnose;
use lole_geom::fnv;

use super::dressed::Dressed;
use super::worn::Worn;
use super::{Performance, order};
use crate::production::Garment;
use crate::solver::Solver;
use crate::{FrameMetrics, skin_check};

/// Energy of a cloth [J].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Of motion.
    pub kinetic: f64,
    /// Stored in the springs.
    pub springs: f64,
    /// Stored in bending and twist.
    pub bending: f64,
    /// Of height above the floor.
    pub height: f64,
}

impl Energy {
    /// All of it [J].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.springs + self.bending + self.height
    }
}

impl Performance {
    /// Measures the current frame; call [`Self::pose_body`] first.
    #[must_use]
    pub fn measure(&self) -> FrameMetrics {
        let body = self.body_surface();
        let mut metrics = FrameMetrics {
            time: self.time(),
            hem_height: self.hem_height(),
            ..FrameMetrics::default()
        };
        for garment in &self.production.garments {
            let (spec, positions) = (&garment.sewn.spec, self.garment_positions(garment));
            let share = positions.len() as f32 / self.cloth_positions.len() as f32;
            let (strain, skin) = Worn::measure(garment, positions, body);
            metrics.add_strain(strain, share);
            metrics.skin.add(skin);
            let depth = diagnose::worst_capsule_penetration(spec, positions, self.met_capsules());
            metrics.capsule_penetration = metrics.capsule_penetration.max(depth);
        }
        for place in 0..self.dressed.len() {
            let (strain, skin) = self.measure_dressed(place);
            metrics.add_strain(strain, 0.0);
            metrics.skin.add(skin);
        }
        metrics
    }

    /// How often a garment crosses itself; `None` where it is nowhere.
    #[must_use]
    pub fn self_crossings(&self, garment: &Garment) -> Option<usize> {
        diagnose::self_crossings(&garment.sewn.spec.grid, self.garment_positions(garment))
    }

    /// Mean strain of the structural springs at each particle of a garment, row-major: positive where
    /// the cloth is stretched.
    #[must_use]
    pub fn strain_by_particle(&self, garment: &Garment) -> Vec<f32> {
        diagnose::strain_by_particle(&garment.sewn.spec, self.garment_positions(garment))
    }

    /// How deep below the drawn skin each of these places lies [m], 0 outside; call [`Self::pose_body`]
    /// first.
    #[must_use]
    pub fn depths_below_skin(&self, places: &[Vec3]) -> Vec<f32> {
        skin_check::depths(self.body_surface(), places)
    }

    /// The drawn body in the current frame.
    pub(super) fn body_surface(&self) -> skin_check::CheckedSurface<'_> {
        skin_check::CheckedSurface {
            positions: &self.body_positions,
            normals: &self.body_normals,
            triangles: &self.production.body_triangles,
        }
    }

    /// Particles of a garment on the inward side of the next one inward, of all garments: 0 where
    /// their order is kept.
    #[must_use]
    pub fn layer_inversions(&self) -> usize {
        order::inversions(&self.production.garments, &self.cloth_positions)
    }

    /// Mean height above the floor [m] of the skirt's hem, of the lowest hem where another skirt is
    /// worn, or of the ends of strands; without any that of the lowest cloth, and 0 where there is none.
    pub(crate) fn hem_height(&self) -> f32 {
        if let Some(skirt) = self.production.skirt() {
            return self.hem_height_of(skirt);
        }
        let lowest = |heights: &mut dyn Iterator<Item = f32>| heights.min_by(f32::total_cmp);
        let mut hems = (self.production.garments.iter()).map(|garment| self.hem_height_of(garment));
        let mut dressed = (self.dressed.iter())
            .flat_map(Dressed::positions)
            .map(|it| it.y);
        let strands = self.adorned.hem_height(&self.production);
        let hem = lowest(&mut hems).or(strands);
        hem.or_else(|| lowest(&mut dressed)).unwrap_or(0.0)
    }

    /// Mean height above the floor [m] of a garment's last row.
    fn hem_height_of(&self, garment: &Garment) -> f32 {
        let positions = self.garment_positions(garment);
        let columns = garment.sewn.spec.grid.column_count as usize;
        let hem = &positions[positions.len() - columns..];
        hem.iter().map(|p| p.y).sum::<f32>() / columns as f32
    }

    /// Energy of the cloth under the paper's methods; `None` for `xpbd`.
    #[must_use]
    pub fn energy(&self) -> Option<Energy> {
        let explicit = self.worn.first()?.solver.explicit()?;
        let (model, state) = (&explicit.model, &explicit.state);
        let gravity = explicit.config.gravity;
        let weights = model.masses().iter().zip(&state.positions);
        Some(Energy {
            kinetic: model.kinetic_energy(&state.velocities),
            springs: model.spring_energy(&state.positions),
            bending: model.plate_energy(&state.positions),
            height: weights
                .map(|(mass, position)| -mass * gravity.dot(*position))
                .sum(),
        })
    }

    /// All bits of the state of cloth and strands as one number: that of the only garment, or one of them
    /// all.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        let dressed = self.dressed.iter().map(Dressed::hash);
        let mut hashes = (self.worn.iter().map(|worn| worn.solver.state_hash())).chain(dressed);
        let first = hashes.next().unwrap_or(0);
        self.adorned
            .hashed(hashes.fold(first, |all, next| all.wrapping_mul(fnv::PRIME) ^ next))
    }

    /// Springs of the prepared cloth.
    #[must_use]
    pub fn spring_count(&self) -> usize {
        self.solvers().map(Solver::spring_count).sum()
    }

    /// In how many places gathered garments press on themselves and are kept from crossing.
    #[must_use]
    pub fn pressed_count(&self) -> usize {
        self.solvers().map(Solver::pressed_count).sum()
    }

    /// Memory of the prepared cloth and its state [byte].
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.solvers().map(Solver::byte_count).sum()
    }

    /// Root mean square of the particles' speeds [m/s].
    #[must_use]
    pub fn rms_speed(&self) -> f32 {
        if let [only] = &self.worn[..] {
            return only.solver.rms_speed();
        }
        let count = self.cloth_positions.len().max(1) as f32;
        let squares = self.worn.iter().zip(&self.production.garments);
        let squares = squares.map(|(worn, garment)| {
            let speed = worn.solver.rms_speed();
            speed * speed * garment.particles.len() as f32 / count
        });
        squares.sum::<f32>().sqrt()
    }
}
