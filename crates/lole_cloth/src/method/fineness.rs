//! Into how many substeps a step is cut: as many as usual, and more for a while where cloth is strained.
//!
//! A pass over the springs leaves a strain that grows with the pull and with the square of the substep: a
//! skirt that is whirled pulls at itself with several times its weight. Substeps are the cheapest way to
//! keep it whole (Macklin et al. 2019, "Small Steps in Physics Simulation"), and a calm dance shall not
//! pay for them.

use std::num::NonZeroU32;

use glam::Vec3;

use crate::collision::repair::limit::{FEW, TOO_FAR};
use crate::mesh::MeshModel;
use crate::{ClothModel, SolverConfig, diagnose};

/// Strain from which a part of the cloth counts as strained, and as not quite at rest.
const STRAINED: f32 = 0.06;
const UNEASY: f32 = 0.04;

/// Substeps of a step as usual, and at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Substeps {
    usual: u32,
    most: u32,
}

impl Substeps {
    pub(crate) const fn exactly(count: NonZeroU32) -> Self {
        Self {
            usual: count.get(),
            most: count.get(),
        }
    }

    /// As many as usual, and `most` at most, or as usual where that is more.
    pub(crate) fn up_to(self, most: NonZeroU32) -> Self {
        Self {
            most: most.get().max(self.usual),
            ..self
        }
    }

    pub(crate) fn of(config: &SolverConfig) -> Self {
        Self::exactly(config.substep_count).up_to(config.strained_substep_count)
    }
}

/// Into how many substeps the next step is cut.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Fineness {
    /// None before the first step.
    count: u32,
    /// Of whatever was looked at last, in the model's order [m].
    pub(crate) positions: Vec<Vec3>,
}

impl Fineness {
    /// Substeps of the next step.
    pub(crate) fn substep_count(&self, substeps: Substeps) -> u32 {
        self.count.clamp(substeps.usual, substeps.most)
    }

    /// Sets the substeps of the next step to those that all else takes with which the cloth is joined.
    pub(crate) const fn follow(&mut self, count: u32) {
        self.count = count;
    }

    /// Learns how strained the cloth came out of a step; `look` counts its parts, with a list for positions. Whether
    /// so much of it is strained too far that this is brought back at once.
    pub(crate) fn learn(
        &mut self,
        substeps: Substeps,
        look: impl FnOnce(&mut Strained, &mut Vec<Vec3>),
    ) -> bool {
        if substeps.most <= substeps.usual {
            return false;
        }
        let mut strained = Strained::default();
        look(&mut strained, &mut self.positions);
        let [is_torn, is_strained, is_uneasy] =
            strained.beyond.map(|beyond| strained.all < FEW * beyond);
        let now = self.substep_count(substeps);
        let usual = substeps.usual;
        self.count = if is_strained {
            now.saturating_add(usual)
        } else if is_uneasy {
            now
        } else {
            now.saturating_sub(usual.div_ceil(4)).max(usual)
        };
        is_torn
    }
}

/// How many parts of the cloth are strained.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Strained {
    all: usize,
    /// Strained too far, strained, and uneasy.
    beyond: [usize; 3],
}

impl Strained {
    /// Counts the edges of a grid along rows and columns, with its particles at `positions` [m].
    pub(crate) fn count_grid(&mut self, model: &ClothModel, positions: &[Vec3]) {
        let spec = model.spec();
        diagnose::each_structural_edge(spec, |[first, second], rest_length| {
            if !(spec.pinned[first] && spec.pinned[second]) {
                let squared = positions[first].distance_squared(positions[second]);
                self.count(squared, rest_length);
            }
        });
    }

    /// Counts the triangles of a mesh, along warp and along weft, with its particles at `positions` [m].
    pub(crate) fn count_mesh(&mut self, model: &MeshModel, positions: &[Vec3]) {
        let pinned = &model.spec().pinned;
        for (index, triangle) in model.triangles().iter().enumerate() {
            if triangle.iter().all(|&particle| pinned[particle as usize]) {
                continue;
            }
            for column in crate::mesh::diagnose::deformation_of(model, index, positions) {
                self.count(column.length_squared(), 1.0);
            }
        }
    }

    /// Counts what is so long, squared [m²], and was `rest_length` [m].
    fn count(&mut self, squared: f32, rest_length: f32) {
        self.all += 1;
        for (beyond, limit) in self.beyond.iter_mut().zip([TOO_FAR, STRAINED, UNEASY]) {
            let [short, long] = [1.0 - limit, 1.0 + limit].map(|share| share * rest_length);
            *beyond += usize::from(!(short * short..=long * long).contains(&squared));
        }
    }
}
