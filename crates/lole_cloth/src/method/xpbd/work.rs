//! What each stage of a substep does to its rows.

use fearless_simd::{Simd, f32x16, prelude::*};

use super::schedule::Stage;
use super::substep::Substep;
use super::woven::WovenRows;
use crate::collision::capsule::MovingCapsule;
use crate::collision::capsule::near::{Range, RowContacts};
use crate::collision::response::ContactRow;
use crate::collision::surfel::SurfelContacts;
use crate::constraint::bend::{Bend, Bending};
use crate::constraint::hysteresis::{BendSets, Frictionless, Sets, ShearSets};
use crate::constraint::shear::Shearing;
use crate::constraint::stride::Limit;
use crate::constraint::tether::{HangingRow, Tethers};
use crate::lanes::{Points, RowLink, Vectors, row_links};
use crate::step::Progress;
use crate::{ClothModel, SolverConfig};

/// Stride links along rows, with their strides.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct RowStrides(Vec<(u32, Vec<RowLink<2>>)>);

impl RowStrides {
    /// Prepares the strides of `config`; nothing is done where they are those of the last step.
    pub(crate) fn set(&mut self, model: &ClothModel, config: &SolverConfig) {
        let known = self.0.iter().map(|&(stride, _)| stride);
        if known.eq(config.row_strides.iter().copied()) {
            return;
        }
        let links = |&stride: &u32| {
            let links = row_links(&model.spec().grid, &model.layout, [0, stride]);
            (stride, links)
        };
        self.0 = config.row_strides.iter().map(links).collect();
    }
}

/// Two rows of this width, the upper first.
#[inline(always)]
fn pair(positions: &mut [Points], [upper, lower]: [usize; 2], width: usize) -> [&mut [Points]; 2] {
    let (above, below) = positions.split_at_mut(lower * width);
    [
        &mut above[upper * width..(upper + 1) * width],
        &mut below[..width],
    ]
}

/// A row of this width and the two below it.
#[inline(always)]
fn triple(positions: &mut [Points], row: usize, width: usize) -> [&mut [Points]; 3] {
    let rows = &mut positions[row * width..(row + 3) * width];
    let (upper, rest) = rows.split_at_mut(width);
    let (middle, lower) = rest.split_at_mut(width);
    [upper, middle, lower]
}

/// The cloth in a substep.
pub(super) struct Work<'a> {
    pub(super) model: &'a ClothModel,
    pub(super) config: &'a SolverConfig,
    pub(super) substep: &'a Substep,
    pub(super) woven: &'a WovenRows,
    pub(super) strides: &'a RowStrides,
    pub(super) positions: &'a mut [Points],
    pub(super) velocities: &'a mut [Points],
    pub(super) yarn_sets: &'a mut Sets,
    /// Positions predicted at the start of the substep.
    pub(super) predicted: &'a mut [Points],
    pub(super) capsules: &'a [MovingCapsule],
    pub(super) contacts: &'a RowContacts,
    /// Which capsules are tested.
    pub(super) range: Range,
    pub(super) surfel_contacts: &'a SurfelContacts,
    /// How far what they were found for has come at the end of the substep.
    pub(super) skin_progress: Progress,
    /// By row, how far inside the capsules its particles may stay [m].
    pub(super) held: &'a [f32],
}

impl Work<'_> {
    /// Does the work of a stage that starts at a row.
    #[inline(always)]
    pub(super) fn perform<S: Simd>(&mut self, simd: S, stage: Stage, row: usize) {
        let (model, woven) = (self.model, self.woven);
        let masses = model.row_masses(row);
        match stage {
            Stage::Predict => self.predict(simd, row),
            Stage::Tether(_) => self.solve_tethers(simd, row),
            Stage::ColumnStride(span, limit) => {
                let masses = [masses, model.row_masses(row + span)];
                limit.solve_pair(simd, self.row_pair(row, span), masses);
            }
            Stage::RowStride(index, stride) => {
                let (_, links) = &self.strides.0[index];
                let limit = Limit::new(stride, woven.row(row).spacing);
                limit.solve_row(simd, self.row(row), masses, links);
            }
            Stage::BendAlong => self.bend_along(simd, row),
            Stage::BendDown => self.bend_down(simd, row),
            Stage::Cells => self.solve_cells(simd, row),
            Stage::SpringsGathered if !model.pinned_rows.is_gathered(row) => {}
            Stage::SpringsAlong | Stage::SpringsGathered => {
                let links = &model.row_pairs;
                let spring = woven.row(row).across;
                spring.solve_row(simd, self.row(row), masses, links);
            }
            Stage::SpringsDown => {
                let masses = [masses, model.row_masses(row + 1)];
                let spring = woven.cells(row).down;
                spring.solve_pair(simd, self.row_pair(row, 1), masses);
            }
            Stage::Finish => self.finish(simd, row),
        }
    }

    #[inline(always)]
    fn bend_along<S: Simd>(&mut self, simd: S, row: usize) {
        let model = self.model;
        let (width, links) = (model.layout.group_count, &model.row_triples);
        // Half of a border row's cells is missing.
        let is_border = row == 0 || row + 1 == model.layout.row_count;
        let woven = self.woven.row(row);
        let bend = Bend {
            scaled_compliance: woven.bend_across * if is_border { 2.0 } else { 1.0 }
                / model.spec().row_layers[row],
            has_clamp: model.clamps.rows[row],
        };
        let masses = model.row_masses(row);
        let points = &mut self.positions[row * width..(row + 1) * width];
        match woven.friction.bend[0] {
            None => {
                let friction = &mut Frictionless;
                Bending { bend, friction }.solve_row(simd, points, masses, links);
            }
            Some(friction) => {
                let first = row * links.len();
                let sets = &mut self.yarn_sets.bend[0][first..first + links.len()];
                let friction = &mut BendSets { sets, friction };
                Bending { bend, friction }.solve_row(simd, points, masses, links);
            }
        }
    }

    #[inline(always)]
    fn bend_down<S: Simd>(&mut self, simd: S, row: usize) {
        let model = self.model;
        let width = model.layout.group_count;
        let woven = self.woven.row(row + 1);
        let bend = Bend {
            scaled_compliance: woven.bend_down / model.spec().row_layers[row + 1],
            has_clamp: model.clamps.columns[row],
        };
        let masses = [row, row + 1, row + 2].map(|row| model.row_masses(row));
        let borders = &model.bend_borders;
        let rows = triple(self.positions, row, width);
        match woven.friction.bend[1] {
            None => {
                let friction = &mut Frictionless;
                Bending { bend, friction }.solve_triple(simd, rows, masses, borders);
            }
            Some(friction) => {
                let sets = &mut self.yarn_sets.bend[1][row * width..(row + 1) * width];
                let friction = &mut BendSets { sets, friction };
                Bending { bend, friction }.solve_triple(simd, rows, masses, borders);
            }
        }
    }

    #[inline(always)]
    fn solve_cells<S: Simd>(&mut self, simd: S, row: usize) {
        let model = self.model;
        let (width, links) = (model.layout.group_count, &model.row_pairs);
        let masses = [model.row_masses(row), model.row_masses(row + 1)];
        let woven = self.woven.cells(row);
        let cell = woven.cell;
        let rows = pair(self.positions, [row, row + 1], width);
        match woven.friction.shear {
            None => {
                let friction = &mut Frictionless;
                Shearing { cell, friction }.solve_pair(simd, rows, masses, links);
            }
            Some(friction) => {
                let first = row * links.len();
                let friction = &mut ShearSets {
                    sets: &mut self.yarn_sets.shear[first..first + links.len()],
                    friction,
                    inv_four_squares: 0.25 / cell.diagonal.rest_length_squared(),
                };
                Shearing { cell, friction }.solve_pair(simd, rows, masses, links);
            }
        }
    }

    #[inline(always)]
    fn row(&mut self, row: usize) -> &mut [Points] {
        let width = self.model.layout.group_count;
        &mut self.positions[row * width..(row + 1) * width]
    }

    /// A row, and the one so many further down.
    #[inline(always)]
    fn row_pair(&mut self, row: usize, span: usize) -> [&mut [Points]; 2] {
        let width = self.model.layout.group_count;
        pair(self.positions, [row, row + span], width)
    }

    #[inline(always)]
    fn predict<S: Simd>(&mut self, simd: S, row: usize) {
        let width = self.model.layout.group_count;
        let range = row * width..(row + 1) * width;
        let substep = self.substep;
        let zero = f32x16::splat(simd, 0.0);
        let gravity = Vectors::splat(simd, substep.gravity_gain);
        let air = Vectors::splat(simd, substep.air_velocity);
        let kept = f32x16::splat(simd, substep.drag_kept);
        let h = f32x16::splat(simd, substep.h);
        let columns = (self.positions[range.clone()].iter_mut())
            .zip(&mut self.velocities[range.clone()])
            .zip(&mut self.predicted[range.clone()])
            .zip(&self.model.inv_masses[range]);
        for (((position, velocity), predicted), inv_mass) in columns {
            let free = zero.simd_lt(f32x16::load_array_ref(simd, &inv_mass.0));
            let before = Vectors::load(simd, velocity);
            // Drag slows what moves and leaves the whole weight to what hangs still.
            let after = before.sub(air).scale(kept).add(air).add(gravity);
            let after = Vectors {
                x: free.select(after.x, before.x),
                y: free.select(after.y, before.y),
                z: free.select(after.z, before.z),
            };
            let moved = Vectors::load(simd, position).add(after.scale(h));
            after.store(velocity);
            moved.store(position);
            moved.store(predicted);
        }
    }

    #[inline(always)]
    fn solve_tethers<S: Simd>(&mut self, simd: S, row: usize) {
        let Some(scale) = self.config.tether_scale else {
            return;
        };
        let model = self.model;
        let width = model.layout.group_count;
        let range = row * width..(row + 1) * width;
        match &model.tethers {
            Tethers::Loose => {}
            Tethers::Rows(anchor_rows) => {
                let anchor_row = anchor_rows[row] as usize;
                let distance = row.abs_diff(anchor_row);
                if distance < 2 {
                    return;
                }
                let (points, anchors) = if anchor_row < row {
                    let [anchors, points] = self.row_pair(anchor_row, distance);
                    (points, anchors)
                } else {
                    let [points, anchors] = self.row_pair(row, distance);
                    (points, anchors)
                };
                #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
                let limit = distance as f32 * model.spec().grid.spacing[1] * scale;
                let row = HangingRow {
                    points,
                    inv_masses: &model.inv_masses[range],
                };
                row.pull_to_row(simd, anchors, limit);
            }
            Tethers::Anchors(anchors) => {
                for anchor in anchors {
                    let (vector, lane) =
                        model.layout.slot(model.pin_indices()[anchor.pin] as usize);
                    let position = self.positions[vector].get(lane);
                    let row = HangingRow {
                        points: &mut self.positions[range.clone()],
                        inv_masses: &model.inv_masses[range.clone()],
                    };
                    let inv_squares = &anchor.inv_squares[range.clone()];
                    row.pull_to_anchor(simd, inv_squares, position, scale);
                }
            }
        }
    }

    /// Contact with the body; then what the projections changed becomes velocity.
    #[inline(always)]
    fn finish<S: Simd>(&mut self, simd: S, row: usize) {
        let width = self.model.layout.group_count;
        let range = row * width..(row + 1) * width;
        let indices = self.contacts.row(row, self.range);
        let has_skin = !self.surfel_contacts.is_empty();
        if has_skin || !indices.is_empty() {
            let mut contact_row = ContactRow {
                first: range.start,
                positions: &mut self.positions[range.clone()],
                predicted: &mut self.predicted[range.clone()],
                velocities: &self.velocities[range.clone()],
                inv_masses: &self.model.inv_masses[range.clone()],
                h: self.substep.h,
                held: self.held[row],
                law: self.substep.contact,
            };
            contact_row.project(simd, self.capsules, indices);
            if has_skin {
                contact_row.project_out_of_skin(simd, self.surfel_contacts, self.skin_progress);
            }
        }
        let inv_h = f32x16::splat(simd, 1.0 / self.substep.h);
        let columns = (self.positions[range.clone()].iter())
            .zip(&self.predicted[range.clone()])
            .zip(&mut self.velocities[range]);
        for ((position, predicted), velocity) in columns {
            let change = Vectors::load(simd, position).sub(Vectors::load(simd, predicted));
            Vectors::load(simd, velocity)
                .add(change.scale(inv_h))
                .store(velocity);
        }
    }
}
