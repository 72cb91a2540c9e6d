//! Constraints of a piece with what depends on the length of a substep worked out.

use crate::mesh::build::Stars;
use crate::mesh::model::MeshModel;
use crate::mesh::strain::{Strain, StrainBatch};

/// What is solved in every substep.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Resisting {
    /// One over the substep squared [1/s²] and moduli that it was made for.
    made_for: Option<(f32, Strain)>,
    pub(crate) stars: Stars,
    /// Every triangle, for sweeps after the first.
    pub(crate) triangles: Vec<StrainBatch>,
    /// Triangles that no star solves.
    pub(crate) other_triangles: Vec<StrainBatch>,
}

impl Resisting {
    /// Works out what resists in substeps of `h` [s]; nothing is done where they are as long as
    /// those before.
    pub(crate) fn set(&mut self, model: &MeshModel, h: f32, strain: Strain) {
        let made_for = (1.0 / (h * h), strain);
        if self.made_for == Some(made_for) {
            return;
        }
        *self = Self {
            made_for: Some(made_for),
            stars: model.stars.clone(),
            triangles: model.triangles.clone(),
            other_triangles: model.other_triangles.clone(),
        };
        let inv_masses = &model.inv_masses;
        (self.stars.few.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        (self.stars.more.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        (self.stars.many.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        (self.stars.bent_few.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        (self.stars.bent_more.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        (self.stars.bent_many.iter_mut()).for_each(|batch| batch.resist(inv_masses, made_for));
        let triangles = self.triangles.iter_mut().chain(&mut self.other_triangles);
        triangles.for_each(|batch| batch.resist(inv_masses, strain));
    }
}
